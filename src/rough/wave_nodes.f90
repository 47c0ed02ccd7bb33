! SPDX-License-Identifier: GPL-3.0-or-later
!> Nodes for integrals over the slope t of the waves up to a wave number q, t^2 = M_2(q), which is the variable of Persson's theory:
!> int q^3 C f dq = (1/pi) int f t dt.
!>
!> Panels end where the pieces of the spectrum do, and are short in ln t and in ln q: where the slope hardly grows, many waves have
!> next to the same t. Toward the slope of all waves panels are halved, for near full contact the gap is of exp(-2 p^2/(E t)^2).
!> In a part of a piece that begins at q_a with the mean square slope M_a the nodes have
!>
!>     q = q_a exp(log1p(a z)/a),   z = M_a expm1(2 ln(t/t_a))/(2 pi C_a q_a^4),   a = 4 + s,
!>
!> which has no difference of slopes that are nearly equal.
module adfric_rough_wave_nodes
   use adfric_base_constants, only: pi
   use adfric_base_kinds, only: dp
   use adfric_numerics_gauss, only: gauss_nodes_10, gauss_weights_10
   use adfric_numerics_libm, only: expm1, log1p
   use adfric_shape_height_spectrum, only: height_spectrum_t
   implicit none (type, external)
   private
   public :: wave_nodes_t, new_wave_nodes, n_of_panel, least_for_gap, least_for_squares

   !> Nodes of a panel.
   integer, parameter :: n_of_panel = 10
   !> Logarithms of slopes over the last one, below which integrals have nothing: those of dt, and those of t dt.
   real(dp), parameter :: least_for_gap = -44, least_for_squares = -20
   !> Widest part of a piece in ln q, and in a ln q.
   real(dp), parameter :: widest_part = 1
   !> Width in ln t of the panel at the slope of all waves.
   real(dp), parameter :: finest = 6.0e-3_dp
   !> A part with so little of ln t carries nothing.
   real(dp), parameter :: nothing = 1.0e-24_dp
   !> Below, exp and log have no more than two terms.
   real(dp), parameter :: two_terms = 1.0e-8_dp

   !> Nodes of a spectrum.
   type :: wave_nodes_t
      !> Slope of the whole spectrum.
      real(dp) :: slope = 0
      !> Number of panels.
      integer :: n_panels = 0
      !> Slopes at the ends of panels over `slope`, rising, and M_1 [m] up to there; shape `(0:n_panels)`.
      real(dp), allocatable :: ends(:), m_1(:)
      !> Widths of panels in ln t; shape `(n_panels)`.
      real(dp), allocatable :: widths(:)
      !> Slopes over `slope`, wave numbers [rad/m], and weights of integrals over ln t; shape `(n_of_panel, n_panels)`.
      real(dp), allocatable :: t(:, :), q(:, :), weights(:, :)
   end type wave_nodes_t

contains

   !> The nodes of a spectrum.
   pure subroutine new_wave_nodes(self, spectrum, widest, least)
      type(wave_nodes_t), intent(out) :: self
      type(height_spectrum_t), intent(in) :: spectrum
      !> Widest panel in ln t, and logarithm of the least slope over the last one, below 0.
      real(dp), intent(in) :: widest, least

      self%slope = spectrum%root_mean_square_slope()
      ! once to count the panels, once to fill them
      call lay_panels(self, spectrum, widest, least)
      associate (n => self%n_panels)
         allocate (self%ends(0:n), self%m_1(0:n), self%widths(n), self%t(n_of_panel, n), self%q(n_of_panel, n), &
            & self%weights(n_of_panel, n))
         call lay_panels(self, spectrum, widest, least)
         self%ends(n) = 1
      end associate
   end subroutine new_wave_nodes

   !> Go through the parts of all pieces; panels are filled if their arrays are allocated, else counted.
   pure subroutine lay_panels(self, spectrum, widest, least)
      type(wave_nodes_t), intent(inout) :: self
      type(height_spectrum_t), intent(in) :: spectrum
      real(dp), intent(in) :: widest, least
      real(dp) :: q, of_part, begin, length
      integer :: first, i, k, n_parts

      self%n_panels = 0
      begin = spectrum%moment(2)*exp(2*least)
      first = spectrum%piece_of_slope(begin)
      q = spectrum%wave_number_of_slope(begin)
      if (allocated(self%ends)) then
         self%ends(0) = exp(least)
         self%m_1(0) = spectrum%moment_up_to(1, q)
      end if
      do i = first, size(spectrum%power)
         if (i > first) begin = spectrum%sums(2, i - 1)
         if (i > first) q = spectrum%q(i - 1)
         length = log(spectrum%q(i)/q)
         if (.not. length > 0) cycle
         n_parts = max(1, ceiling(length*max(1.0_dp, abs(4 + spectrum%power(i)))/widest_part))
         do k = 1, n_parts
            of_part = q*exp(length*(k - 1)/n_parts)
            call lay_part(self, spectrum, i, of_part, length/n_parts, widest, begin)
         end do
      end do
   end subroutine lay_panels

   !> Go through the panels of a part.
   pure subroutine lay_part(self, spectrum, piece, q, length, widest, begin)
      type(wave_nodes_t), intent(inout) :: self
      type(height_spectrum_t), intent(in) :: spectrum
      integer, intent(in) :: piece
      !> Wave number at the beginning of the part, its length in ln q, and widest panel.
      real(dp), intent(in) :: q, length, widest
      !> In: mean square slope at the beginning of the part. Out: that at its end.
      real(dp), intent(inout) :: begin
      real(dp) :: a, unit, growth, all_of_it, done, width, t_begin, log_t
      integer :: n, k

      a = 4 + spectrum%power(piece)
      ! M_2 grows as unit (exp(a x) - 1)/a
      unit = 2*pi*spectrum%density(piece)*spectrum%q(piece - 1)**4*(q/spectrum%q(piece - 1))**a
      growth = length*(1 + a*length/2)
      if (abs(a*length) > two_terms) growth = expm1(a*length)/a
      growth = unit*growth
      all_of_it = log1p(growth/begin)/2
      t_begin = sqrt(begin/spectrum%moment(2))
      log_t = log(begin/spectrum%moment(2))/2
      done = 0
      do
         if (.not. all_of_it - done > nothing) exit
         width = min(widest, max(finest, -(log_t + done)/2))
         n = ceiling((all_of_it - done)/width)
         width = (all_of_it - done)/n
         self%n_panels = self%n_panels + 1
         if (allocated(self%ends)) then
            associate (panel => self%n_panels)
               self%widths(panel) = width
               self%weights(:, panel) = width/2*gauss_weights_10
               do k = 1, n_of_panel
                  associate (s => done + width/2*(1 + gauss_nodes_10(k)))
                     self%t(k, panel) = t_begin*exp(s)
                     self%q(k, panel) = wave_after(q, a, begin*expm1(2*s)/unit)
                  end associate
               end do
               self%ends(panel) = t_begin*exp(done + width)
               associate (q_end => wave_after(q, a, begin*expm1(2*(done + width))/unit))
                  self%m_1(panel) = spectrum%moment_up_to(1, q_end)
               end associate
            end associate
         end if
         if (n == 1) exit
         done = done + width
      end do
      begin = begin + growth
   end subroutine lay_part

   !> Wave number q exp(log1p(a z)/a).
   pure real(dp) function wave_after(q, a, z)
      real(dp), intent(in) :: q, a, z

      if (abs(a*z) > two_terms) then
         wave_after = q*exp(log1p(a*z)/a)
      else
         wave_after = q*exp(z*(1 - a*z/2))
      end if
   end function wave_after

end module adfric_rough_wave_nodes

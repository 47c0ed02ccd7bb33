! SPDX-License-Identifier: GPL-3.0-or-later
!> Nodes for integrals over the slope t of the waves up to a wave number q, t^2 = M_2(q), which is the variable of Persson's theory:
!> int q^3 C f dq = (1/pi) int f t dt.
!>
!> Panels are equal in ln t or shorter, and end where the pieces of the spectrum do.
module adfric_rough_wave_nodes
   use adfric_base_kinds, only: dp
   use adfric_numerics_gauss, only: gauss_nodes_10, gauss_weights_10
   use adfric_rough_height_spectrum, only: height_spectrum_t
   implicit none (type, external)
   private
   public :: wave_nodes_t, new_wave_nodes, n_of_panel, least_for_gap, least_for_squares

   !> Nodes of a panel.
   integer, parameter :: n_of_panel = 10
   !> Logarithms of slopes over the last one, below which integrals have nothing: those of dt, and those of t dt.
   real(dp), parameter :: least_for_gap = -44, least_for_squares = -20
   !> Widest panel in ln q in a piece so steep that its slope tends to a limit.
   real(dp), parameter :: widest_steep = 1

   !> Nodes of a spectrum.
   type :: wave_nodes_t
      !> Slope of the whole spectrum.
      real(dp) :: slope = 0
      !> Slopes at the ends of panels over `slope`, rising, and M_1 [m] up to there; shape `(0:n_panels)`.
      real(dp), allocatable :: ends(:), m_1(:)
      !> Slopes over `slope`, wave numbers [rad/m], and weights of integrals over ln t; shape `(n_of_panel, n_panels)`.
      real(dp), allocatable :: t(:, :), q(:, :), weights(:, :)
   end type wave_nodes_t

contains

   !> The nodes of a spectrum.
   pure subroutine new_wave_nodes(self, spectrum, widest, least)
      type(wave_nodes_t), intent(out) :: self
      type(height_spectrum_t), intent(in) :: spectrum
      !> Widest panel in ln t, and one of `least_...`.
      real(dp), intent(in) :: widest, least
      real(dp), allocatable :: ends(:)
      real(dp) :: half
      integer :: i, k

      self%slope = spectrum%root_mean_square_slope()
      call find_ends(spectrum, widest, least, ends)
      associate (n => size(ends) - 1, all => spectrum%moment(2))
         allocate (self%ends(0:n), self%m_1(0:n), self%t(n_of_panel, n), self%q(n_of_panel, n), self%weights(n_of_panel, n))
         self%ends(:) = exp(ends)
         do i = 0, n
            self%m_1(i) = spectrum%moment_up_to(1, spectrum%wave_number_of_slope(self%ends(i)**2*all))
         end do
         do i = 1, n
            half = (ends(i + 1) - ends(i))/2
            self%t(:, i) = exp(ends(i) + half*(1 + gauss_nodes_10))
            self%weights(:, i) = half*gauss_weights_10
            do k = 1, n_of_panel
               self%q(k, i) = spectrum%wave_number_of_slope(self%t(k, i)**2*all)
            end do
         end do
      end associate
   end subroutine new_wave_nodes

   !> Ends of the panels, as ln t over the last one.
   pure subroutine find_ends(spectrum, widest, least, ends)
      type(height_spectrum_t), intent(in) :: spectrum
      real(dp), intent(in) :: widest, least
      !> Receives them, rising, the last one 0.
      real(dp), allocatable, intent(out) :: ends(:)
      real(dp) :: last, next, low, q
      integer :: i, k, n, n_pieces, n_parts

      n_pieces = size(spectrum%power)
      ends = [real(dp) :: least]
      last = least
      do i = 1, n_pieces
         ! a steep piece by its wave numbers, any piece by its slopes
         n_parts = 1
         if (spectrum%power(i) < -4) n_parts = max(1, ceiling(log(spectrum%q(i)/spectrum%q(i - 1))/widest_steep))
         do k = 1, n_parts
            next = 0
            q = spectrum%q(i - 1)*(spectrum%q(i)/spectrum%q(i - 1))**(real(k, dp)/n_parts)
            if (k < n_parts .or. i < n_pieces) next = log(spectrum%moment_up_to(2, min(q, spectrum%q(i)))/spectrum%moment(2))/2
            low = last
            n = ceiling((next - low)/widest)
            ! pieces that carry nothing, and the shortest ends, make no panel
            if (n < 1) cycle
            ends = [ends, low + (next - low)*fractions(n)]
            last = next
         end do
      end do
      ends(size(ends)) = 0
   end subroutine find_ends

   !> 1/n, 2/n, ..., 1.
   pure function fractions(n) result(x)
      integer, intent(in) :: n
      real(dp) :: x(n)
      integer :: k

      x = [(real(k, dp)/n, k=1, n)]
   end function fractions

end module adfric_rough_wave_nodes

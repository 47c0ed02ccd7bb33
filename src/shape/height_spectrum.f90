! SPDX-License-Identifier: GPL-3.0-or-later
!> The power spectral density of an isotropic rough surface, as pieces of powers of the wave number q:
!>
!>     C(q) = C_i (q/q_i)^s_i,   q_i <= q <= q_(i+1),   <h^2> = int C d^2q = 2 pi int C q dq,   M_n = 2 pi int C q^(n+1) dq
!>
!> A self-affine spectrum with a roll-off has the two pieces s = 0 and s = -2 - 2 H; a table has one between each two of its rows.
!> With x = ln(q/q_i), up to a wave number q of the piece,
!>
!>     M_n = 2 pi C_i q_i^(n+2) x exprel((n + 2 + s_i) x),   exprel(y) = (exp(y) - 1)/y
!>
!> which has no difference of equal numbers where n + 2 + s = 0. The slope up to a wave number has the inverse
!> q = q_i exp(log1p(a z)/a), a = 4 + s_i, z = M_2/(2 pi C_i q_i^4).
module adfric_shape_height_spectrum
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_base_constants, only: pi
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: height_spectrum_t, new_self_affine, new_tabulated, new_pieces, in_this_convention, exponential_ratio
   public :: convention_words, convention_variance, convention_transform, convention_cycles

   !> Words of the conventions of a density that is given, and their indices: the variance per area of wave numbers, the squared
   !> transform over the area, and the variance per area of cycles per length.
   character(*), parameter :: convention_words = 'variance transform cycles'
   integer, parameter :: convention_variance = 1, convention_transform = 2, convention_cycles = 3

   !> A spectrum.
   type :: height_spectrum_t
      !> Wave numbers [rad/m] at the ends of the pieces, rising; shape `(0:n_pieces)`.
      real(dp), allocatable :: q(:)
      !> Wave number [rad/m] of the longest wave that a drawn surface has to have: that of the first piece, or of a map.
      real(dp) :: longest = 0
      !> Density at the beginning of each piece [m^4], and the power of the wave number in it; shape `(n_pieces)`.
      real(dp), allocatable :: density(:), power(:)
      !> M_0 to M_4 [m^(2-n)] up to the ends of the pieces; shape `(0:4, 0:n_pieces)`.
      real(dp), allocatable :: sums(:, :)
   contains
      procedure :: moment
      procedure :: moment_up_to
      procedure :: wave_number_of_slope
      procedure :: piece_of_slope
      procedure :: density_at
      procedure :: scale_by
      procedure :: stretch
      procedure :: root_mean_square_height
      procedure :: root_mean_square_slope
      procedure :: root_mean_square_curvature
      procedure :: nayak_parameter
   end type height_spectrum_t

contains

   !> A self-affine spectrum with a plateau of density 1/q_r^4 below the roll-off; `scale_by` gives it another.
   pure subroutine new_self_affine(self, hurst_exponent, q_long, q_rolloff, q_short)
      type(height_spectrum_t), intent(out) :: self
      !> Hurst exponent H, from 0 to 1.
      real(dp), intent(in) :: hurst_exponent
      !> Wave numbers [rad/m] of the longest wave, of the roll-off, and of the shortest wave; `q_long <= q_rolloff <= q_short`,
      !> the first less than the last.
      real(dp), intent(in) :: q_long, q_rolloff, q_short
      real(dp), allocatable :: powers(:), q(:)

      if (has_asserts) call assert(q_long > 0 .and. q_long <= q_rolloff .and. q_rolloff <= q_short .and. q_long < q_short, &
         & 'new_self_affine: wave numbers rise')
      if (.not. q_rolloff > q_long) then
         q = [q_long, q_short]
         powers = [-2 - 2*hurst_exponent]
      else if (.not. q_short > q_rolloff) then
         q = [q_long, q_short]
         powers = [0.0_dp]
      else
         q = [q_long, q_rolloff, q_short]
         powers = [0.0_dp, -2 - 2*hurst_exponent]
      end if
      call new_pieces(self, q, spread(1/q_rolloff**4, 1, size(powers)), powers)
   end subroutine new_self_affine

   !> A spectrum of a table: powers of the wave number between its rows, and nothing outside of them.
   pure subroutine new_tabulated(self, q, density)
      type(height_spectrum_t), intent(out) :: self
      !> Wave numbers [rad/m], rising, two or more, and their densities [m^4], > 0; shape `(n)`.
      real(dp), intent(in) :: q(:), density(:)
      integer :: n

      n = size(q)
      call new_pieces(self, q, density(:n - 1), log(density(2:)/density(:n - 1))/log(q(2:)/q(:n - 1)))
   end subroutine new_tabulated

   !> A spectrum of pieces.
   pure subroutine new_pieces(self, q, density, power)
      type(height_spectrum_t), intent(out) :: self
      !> Wave numbers [rad/m] at the ends of the pieces, rising; density at the beginning of each [m^4], and its power. There is one
      !> end more than pieces.
      real(dp), intent(in) :: q(:), density(:), power(:)
      integer :: i, n

      allocate (self%q(0:size(power)), self%density(size(power)), self%power(size(power)), self%sums(0:4, 0:size(power)))
      self%q(:) = q
      self%longest = q(1)
      self%density(:) = density
      self%power(:) = power
      self%sums = 0
      do i = 1, size(power)
         do n = 0, 4
            self%sums(n, i) = self%sums(n, i - 1) + moment_of_piece(self, i, n, q(i + 1))
         end do
      end do
   end subroutine new_pieces

   !> Part of a moment from the beginning of a piece up to a wave number in it.
   pure real(dp) function moment_of_piece(self, i, n, q) result(moment)
      class(height_spectrum_t), intent(in) :: self
      !> Number of the piece, and order of the moment, 0 to 4.
      integer, intent(in) :: i, n
      real(dp), intent(in) :: q
      real(dp) :: x

      x = log(q/self%q(i - 1))
      moment = 2*pi*self%density(i)*self%q(i - 1)**(n + 2)*x*exponential_ratio((n + 2 + self%power(i))*x)
   end function moment_of_piece

   !> Moment M_n of the surface [m^(2-n)].
   pure real(dp) function moment(self, n)
      class(height_spectrum_t), intent(in) :: self
      !> Order, 0 to 4.
      integer, intent(in) :: n

      moment = self%sums(n, size(self%power))
   end function moment

   !> Moment M_n of the waves up to a wave number [m^(2-n)].
   pure real(dp) function moment_up_to(self, n, q) result(moment)
      class(height_spectrum_t), intent(in) :: self
      !> Order, 0 to 4.
      integer, intent(in) :: n
      !> Wave number [rad/m], within the spectrum.
      real(dp), intent(in) :: q
      integer :: i

      i = max(1, count_up_to(self%q(:size(self%power) - 1), q))
      moment = self%sums(n, i - 1) + moment_of_piece(self, i, n, q)
   end function moment_up_to

   !> Wave number [rad/m] up to which the waves have a mean square slope.
   pure real(dp) function wave_number_of_slope(self, mean_square) result(q)
      class(height_spectrum_t), intent(in) :: self
      !> Mean square slope, from 0 to M_2.
      real(dp), intent(in) :: mean_square
      real(dp) :: z, a
      integer :: i

      i = self%piece_of_slope(mean_square)
      a = 4 + self%power(i)
      z = (mean_square - self%sums(2, i - 1))/(2*pi*self%density(i)*self%q(i - 1)**4)
      q = self%q(i)
      if (a*z > -1) q = min(q, self%q(i - 1)*exp(z*log_1p_over(a*z)))
   end function wave_number_of_slope

   !> Number of the piece in which the waves reach a mean square slope.
   pure integer function piece_of_slope(self, mean_square) result(i)
      class(height_spectrum_t), intent(in) :: self
      !> Mean square slope, from 0 to M_2.
      real(dp), intent(in) :: mean_square

      i = max(1, count_up_to(self%sums(2, :size(self%power) - 1), mean_square))
   end function piece_of_slope

   !> How many numbers of a list are at most a value, by halves.
   pure integer function count_up_to(list, value) result(n)
      !> Numbers, not falling.
      real(dp), intent(in) :: list(:)
      real(dp), intent(in) :: value
      integer :: above, middle

      n = 0
      above = size(list) + 1
      do while (above - n > 1)
         middle = (n + above)/2
         if (list(middle) <= value) then
            n = middle
         else
            above = middle
         end if
      end do
   end function count_up_to

   !> (exp(y) - 1)/y.
   elemental real(dp) function exponential_ratio(y) result(value)
      !> Any number.
      real(dp), intent(in) :: y
      real(dp) :: u

      u = exp(y)
      if (abs(y) > 1) then
         value = (u - 1)/y
      else
         ! W. Kahan's form: the error of exp(y) cancels
         value = 1
         if (abs(u - 1) > 0) value = (u - 1)/log(u)
      end if
   end function exponential_ratio

   !> log(1 + x)/x.
   elemental real(dp) function log_1p_over(x) result(value)
      real(dp), intent(in) :: x
      real(dp) :: y

      ! W. Kahan's form: the error of 1 + x cancels
      y = 1 + x
      value = 1
      if (abs(y - 1) > 0) value = log(y)/(y - 1)
   end function log_1p_over

   !> Density [m^4] at a wave number, 0 outside of the spectrum.
   pure real(dp) function density_at(self, q) result(density)
      class(height_spectrum_t), intent(in) :: self
      !> Wave number [rad/m], > 0.
      real(dp), intent(in) :: q
      integer :: i, n

      n = size(self%power)
      density = 0
      if (q < self%q(0) .or. q > self%q(n)) return
      i = min(n, count_up_to(self%q, q))
      density = self%density(i)*(q/self%q(i - 1))**self%power(i)
   end function density_at

   !> Multiply the density.
   pure subroutine scale_by(self, factor)
      class(height_spectrum_t), intent(inout) :: self
      !> Factor, > 0.
      real(dp), intent(in) :: factor

      self%density = self%density*factor
      self%sums = self%sums*factor
   end subroutine scale_by

   !> Multiply all wavelengths, and leave the heights.
   pure subroutine stretch(self, factor)
      class(height_spectrum_t), intent(inout) :: self
      !> Factor, > 0.
      real(dp), intent(in) :: factor
      integer :: n

      self%q = self%q/factor
      self%longest = self%longest/factor
      self%density = self%density*factor**2
      do n = 0, 4
         self%sums(n, :) = self%sums(n, :)/factor**n
      end do
   end subroutine stretch

   !> Root mean square height h [m].
   pure real(dp) function root_mean_square_height(self) result(h)
      class(height_spectrum_t), intent(in) :: self

      h = sqrt(self%moment(0))
   end function root_mean_square_height

   !> Root mean square of the gradient g [-].
   pure real(dp) function root_mean_square_slope(self) result(g)
      class(height_spectrum_t), intent(in) :: self

      g = sqrt(self%moment(2))
   end function root_mean_square_slope

   !> Root mean square of half the Laplacian [1/m].
   pure real(dp) function root_mean_square_curvature(self) result(k)
      class(height_spectrum_t), intent(in) :: self

      k = sqrt(self%moment(4))/2
   end function root_mean_square_curvature

   !> Nayak's parameter m0 m4/m2^2 of the moments along a line, 3/2 at least.
   pure real(dp) function nayak_parameter(self) result(alpha)
      class(height_spectrum_t), intent(in) :: self

      alpha = max(1.5_dp, 1.5_dp*(self%moment(0)/self%moment(2))*(self%moment(4)/self%moment(2)))
   end function nayak_parameter

   !> Wave numbers and densities as they are meant here, from those of a convention.
   pure subroutine in_this_convention(convention, wave_numbers, densities, q, density)
      !> One of `convention_...`.
      integer, intent(in) :: convention
      !> Wave numbers [rad/m], or cycles per length [1/m]; and densities [m^4]; shape `(n)`.
      real(dp), intent(in) :: wave_numbers(:), densities(:)
      !> Receive wave numbers [rad/m] and densities of the variance [m^4]; shape `(n)`.
      real(dp), intent(out) :: q(:), density(:)

      q = wave_numbers
      density = densities
      ! h^2 = int C_t d^2q/(2 pi)^2, and int C_c d^2f with q = 2 pi f
      if (convention /= convention_variance) density = densities/(2*pi)**2
      if (convention == convention_cycles) q = 2*pi*wave_numbers
   end subroutine in_this_convention

end module adfric_shape_height_spectrum

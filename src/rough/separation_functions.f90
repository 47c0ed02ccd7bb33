! SPDX-License-Identifier: GPL-3.0-or-later
!> Functions of Persson's theory that no spectrum enters, with the share W of the energy of full contact that waves have in a part
!> A of the area, W = a_1 A + a_3 A^3 + a_5 A^5:
!>
!>     F_n(x) = int_x^inf erf(y)^n exp(-y^2) dy/y,   n = 0, 2, 4;   F_0 = E1(x^2)/2,
!>     R(y) = int_y^inf (1/S(erf z) - 1 - exp(-z^2) (c + b z^2)) dz/z^3,   S = W/A.
!>
!> c and b are those of 1/S - 1 = c + (b - c) z^2 + ... , so R has no logarithm. Both are found once by quadrature, and are series
!> then.
module adfric_rough_separation_functions
   use adfric_base_constants, only: pi
   use adfric_base_kinds, only: dp
   use adfric_numerics_chebyshev, only: degree
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   use adfric_rough_panel_series, only: new_panel_series, panel_series_t, positions_of
   implicit none (type, external)
   private
   public :: energy_share_t, separation_functions_t, new_separation_functions, area_function_t, new_area_function
   public :: plain_share, yang_persson_share, wang_mueser_share

   !> erf is 1 to round-off from here on.
   real(dp), parameter :: full = 6.5_dp
   !> Below, F_0 has its logarithm, and is summed.
   real(dp), parameter :: small = 0.5_dp
   !> Width of panels.
   real(dp), parameter :: width = 0.5_dp
   integer, parameter :: n_panels = 13
   real(dp), parameter :: euler = 0.57721566490153286061_dp

   !> Coefficients of W.
   type :: energy_share_t
      !> Of A, A^3 and A^5; their sum is 1.
      real(dp) :: a_1 = 1, a_3 = 0, a_5 = 0
   contains
      procedure :: share
      procedure :: stiffening
      procedure :: slope => slope_of_share
      procedure :: separation
   end type energy_share_t

   !> Series of F_n.
   type :: separation_functions_t
      !> exp(x^2) F_n on panels from `small` for n = 0, from 0 for n = 2, 4.
      type(panel_series_t) :: f_0, f_2, f_4
   contains
      procedure :: get_f
   end type separation_functions_t

   !> The area of a corrected theory.
   type :: area_function_t
      !> The share whose S it has.
      type(energy_share_t) :: share
      !> c and b of R.
      real(dp) :: c = 0, b = 0
      !> R.
      type(panel_series_t) :: rest
   contains
      procedure :: contact_fraction
      procedure :: accumulated
   end type area_function_t

contains

   !> W = A: Persson's theory as it was.
   pure type(energy_share_t) function plain_share() result(share)
      share = energy_share_t(1.0_dp, 0.0_dp, 0.0_dp)
   end function plain_share

   !> W = gamma A + (1 - gamma) A^3.
   pure type(energy_share_t) function yang_persson_share(gamma) result(share)
      !> Constant gamma, above 0, up to 1.
      real(dp), intent(in) :: gamma

      share = energy_share_t(gamma, 1 - gamma, 0.0_dp)
   end function yang_persson_share

   !> W = (5 A - 2 A^3 + 6 A^5)/9.
   pure type(energy_share_t) function wang_mueser_share() result(share)
      share = energy_share_t(5/9.0_dp, -2/9.0_dp, 6/9.0_dp)
   end function wang_mueser_share

   !> W.
   elemental real(dp) function share(self, a)
      class(energy_share_t), intent(in) :: self
      !> Part of the area in contact, 0 to 1.
      real(dp), intent(in) :: a

      share = a*self%stiffening(a)
   end function share

   !> S = W/A.
   elemental real(dp) function stiffening(self, a)
      class(energy_share_t), intent(in) :: self
      real(dp), intent(in) :: a

      stiffening = self%a_1 + a**2*(self%a_3 + a**2*self%a_5)
   end function stiffening

   !> dW/dA.
   elemental real(dp) function slope_of_share(self, a) result(slope)
      class(energy_share_t), intent(in) :: self
      real(dp), intent(in) :: a

      slope = self%a_1 + a**2*(3*self%a_3 + 5*a**2*self%a_5)
   end function slope_of_share

   !> Phi = a_1 F_0 + 3 a_3 F_2 + 5 a_5 F_4, times exp(x^2).
   pure real(dp) function separation(self, f)
      class(energy_share_t), intent(in) :: self
      !> exp(x^2) F_n, n = 0, 2, 4.
      real(dp), intent(in) :: f(3)

      separation = self%a_1*f(1) + 3*self%a_3*f(2) + 5*self%a_5*f(3)
   end function separation

   !> Find the series of F_n.
   pure subroutine new_separation_functions(self)
      type(separation_functions_t), intent(out) :: self
      real(dp) :: x(0:degree, n_panels), f(0:degree, n_panels, 3)
      integer :: j, k

      x = positions_of(0.0_dp, width, n_panels)
      do k = 1, n_panels
         do j = 0, degree
            f(j, k, 1) = 0
            if (k > 1) f(j, k, 1) = scaled_e_1(x(j, k)**2)/2
            f(j, k, 2:3) = integrals_from(x(j, k))
         end do
      end do
      call new_panel_series(self%f_0, small, width, f(:, 2:, 1))
      call new_panel_series(self%f_2, 0.0_dp, width, f(:, :, 2))
      call new_panel_series(self%f_4, 0.0_dp, width, f(:, :, 3))
   end subroutine new_separation_functions

   !> exp(x^2) F_n, n = 2, 4, by quadrature.
   pure function integrals_from(x) result(f)
      real(dp), intent(in) :: x
      real(dp) :: f(2), y(size(gauss_nodes)), term(size(gauss_nodes))
      integer, parameter :: n_parts = 13
      integer :: k

      f = 0
      do k = 1, n_parts
         y = x + full/n_parts*(k - 1 + (1 + gauss_nodes)/2)
         ! x^2 - y^2 has no difference of squares
         term = gauss_weights*full/(2*n_parts)*exp((x - y)*(x + y))*erf(y)**2/y
         f = f + [sum(term), sum(term*erf(y)**2)]
      end do
   end function integrals_from

   !> exp(x^2) F_n(x), n = 0, 2, 4.
   pure subroutine get_f(self, x, f)
      class(separation_functions_t), intent(in) :: self
      !> Argument, > 0.
      real(dp), intent(in) :: x
      real(dp), intent(out) :: f(3)

      if (x >= full) then
         f = scaled_e_1(x**2)/2
         return
      else if (x < small) then
         f(1) = scaled_e_1(x**2)/2
      else
         f(1) = self%f_0%value_at(x)
      end if
      f(2) = self%f_2%value_at(x)
      f(3) = self%f_4%value_at(x)
   end subroutine get_f

   !> exp(z) E1(z), z > 0.
   elemental real(dp) function scaled_e_1(z) result(value)
      real(dp), intent(in) :: z
      real(dp) :: term
      integer :: k, n

      if (z <= 1) then
         ! E1 = -gamma - ln z - sum (-z)^k/(k k!)
         value = -euler - log(z)
         term = 1
         do k = 1, 20
            term = -term*z/k
            value = value - term/k
         end do
         value = exp(z)*value
      else
         ! the continued fraction 1/(z + 1 - 1/(z + 3 - 4/(z + 5 - ...))), from its end
         n = 12 + int(60/z)
         value = 0
         do k = n, 1, -1
            value = k**2/(z + 2*k + 1 - value)
         end do
         value = 1/(z + 1 - value)
      end if
   end function scaled_e_1

   !> Find the area of a corrected theory.
   pure subroutine new_area_function(self, share)
      type(area_function_t), intent(out) :: self
      type(energy_share_t), intent(in) :: share
      real(dp) :: x(0:degree, n_panels), r(0:degree, n_panels), y(size(gauss_nodes)), far, near
      integer, parameter :: n_parts = 4
      integer :: i, j, k

      self%share = share
      ! 1/S - 1 = 1/a_1 - 1 - (a_3/a_1^2) (4/pi) z^2 + ...
      self%c = 1/share%a_1 - 1
      self%b = self%c - share%a_3/share%a_1**2*4/pi
      x = positions_of(0.0_dp, width, n_panels)
      far = 0
      do k = n_panels, 1, -1
         do j = 0, degree
            near = 0
            do i = 1, n_parts
               associate (step => (k*width - x(j, k))/n_parts)
                  y = x(j, k) + step*(i - 1 + (1 + gauss_nodes)/2)
                  near = near + sum(gauss_weights*step/2*rest_of(self, y))
               end associate
            end do
            r(j, k) = far + near
         end do
         y = (k - 1)*width + width*(1 + gauss_nodes)/2
         far = far + sum(gauss_weights*width/2*rest_of(self, y))
      end do
      call new_panel_series(self%rest, 0.0_dp, width, r)
   end subroutine new_area_function

   !> What R integrates.
   elemental real(dp) function rest_of(self, z) result(rest)
      class(area_function_t), intent(in) :: self
      real(dp), intent(in) :: z
      real(dp) :: a

      a = erf(z)
      associate (s => self%share%stiffening(a))
         rest = ((1 - s)/s - exp(-z**2)*(self%c + self%b*z**2))/z**3
      end associate
   end function rest_of

   !> 2 y^2 int_y^inf dz/(z^3 S(erf z)), and its derivative by ln y.
   pure subroutine accumulated(self, y, value, slope)
      class(area_function_t), intent(in) :: self
      real(dp), intent(in) :: y
      real(dp), intent(out) :: value, slope
      real(dp) :: e

      if (y >= full) then
         value = 1
         slope = 0
         return
      end if
      e = scaled_e_1(y**2)/2
      ! int exp(-z^2)/z^3 = exp(-y^2)/(2 y^2) - E1/2, int exp(-z^2)/z = E1/2
      value = 1 + exp(-y**2)*(self%c + 2*y**2*(self%b - self%c)*e) + 2*y**2*self%rest%value_at(y)
      slope = 2*(value - 1/self%share%stiffening(erf(y)))
   end subroutine accumulated

   !> Part of the area in contact: A = erf y, y^2 = 2 P^2 H(y), H that of `accumulated`.
   pure subroutine contact_fraction(self, pressure, a, is_converged)
      class(area_function_t), intent(in) :: self
      !> P, mean pressure over modulus and slope, > 0.
      real(dp), intent(in) :: pressure
      !> Receives the part.
      real(dp), intent(out) :: a
      logical, intent(out) :: is_converged
      real(dp) :: y, value, slope, step
      integer :: k

      y = sqrt(2.0_dp)*pressure
      a = 1
      is_converged = y >= full
      if (is_converged) return
      y = y*sqrt((1 + self%c*exp(-y**2)))
      do k = 1, 50
         call self%accumulated(min(y, full), value, slope)
         ! Newton's step of 2 ln y - ln(2 P^2) - ln H
         step = (2*log(y/pressure) - log(2*value))/(2 - slope/value)
         y = y*exp(-max(-1.0_dp, min(1.0_dp, step)))
         is_converged = abs(step) <= 1.0e-9_dp
         if (is_converged) exit
      end do
      a = erf(y)
   end subroutine contact_fraction

end module adfric_rough_separation_functions

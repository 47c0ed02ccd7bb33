! SPDX-License-Identifier: GPL-3.0-or-later
!> Friction of bonds that form, are stretched, break and rest (A. Schallamach, Wear 6 (1963) 375).
!>
!> N sites per area of the stiffness K bind. A bond is stretched by x at the speed v, breaks with the hazard r(x), and binds again
!> after the rest t_f. With the length x_b and the life t_b of a bond, u = v t_b/x_b and m = t_f/t_b the stress is
!>
!>     tau = N K x_b J1/(J0 + u m),    J_n = int (x/x_b)^n S dx/x_b,    S the share of bonds that are still whole at x.
!>
!> With z = 1/u the integrals of the two hazards are:
!>
!> - 1/t_b, with a certain break at x_b:  J0 = (1 - e^(-z))/z,  J1 = (1 - (1 + z) e^(-z))/z^2;
!> - e^(x/x_b)/t_b:  J_n = int_0^inf x^n exp(-z (e^x - 1)) dx, so J0 = e^z E1(z), J1 = e^z int_z^inf E1(t)/t dt.
module adfric_interface_breaking_bonds
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   use adfric_numerics_libm, only: expm1, log1p
   implicit none (type, external)
   private
   public :: get_bond_stress, hazard_constant, hazard_exponential

   !> Hazards, in the order of the choice.
   integer, parameter :: hazard_constant = 1, hazard_exponential = 2
   !> Euler's constant.
   real(dp), parameter :: euler = 0.577215664901532860607_dp
   !> Speeds u below which the stress is u/(1 + m) to all digits: its relative change is of the order of u, or less.
   real(dp), parameter :: slowest(2) = [1.0e-3_dp, 1.0e-18_dp]
   !> Below it the power series of the constant hazard hold, in as many terms.
   real(dp), parameter :: small_z = 0.1_dp
   integer, parameter :: n_terms = 12
   !> Terms of the series of E1 and its integral up to z = 1.
   integer, parameter :: n_integral_terms = 20
   !> Ends of the panels on which e^(-t) is integrated; behind the last one it is nothing.
   real(dp), parameter :: panel_ends(0:6) = [0.0_dp, 1.0_dp, 3.0_dp, 7.0_dp, 14.0_dp, 26.0_dp, 44.0_dp]

contains

   !> Stress over the slope of slow speeds, tau/(N K x_b/(1 + m)), and how it changes with the speed.
   pure subroutine get_bond_stress(hazard, log_speed, rest_ratio, stress, slope)
      !> One of `hazard_...`.
      integer, intent(in) :: hazard
      !> Logarithm of u [-].
      real(dp), intent(in) :: log_speed
      !> m, the rest over the life of a bond [-], >= 0.
      real(dp), intent(in) :: rest_ratio
      !> (1 + m) J1/(J0 + u m) [-].
      real(dp), intent(out) :: stress
      !> d ln tau/d ln v [-].
      real(dp), intent(out) :: slope
      real(dp) :: z, u, j0, j1, slope_0, slope_1

      u = exp(log_speed)
      stress = u
      slope = 1
      if (u < slowest(hazard)) return
      z = exp(-log_speed)
      if (hazard == hazard_constant) then
         call get_constant_hazard(z, j0, j1, slope_0, slope_1)
      else if (z < 1) then
         call get_short_lives(z, log_speed, j0, j1, slope_0, slope_1)
      else
         call get_long_lives(z, j0, j1, slope_0, slope_1)
      end if
      stress = (1 + rest_ratio)*j1/(j0 + u*rest_ratio)
      slope = slope_1/j1 - (slope_0 + u*rest_ratio)/(j0 + u*rest_ratio)
   end subroutine get_bond_stress

   !> Integrals of the constant hazard.
   pure subroutine get_constant_hazard(z, j0, j1, slope_0, slope_1)
      real(dp), intent(in) :: z
      !> J0 and J1, and their derivatives by ln u.
      real(dp), intent(out) :: j0, j1, slope_0, slope_1
      real(dp) :: term
      integer :: k

      if (z < small_z) then
         ! 1 - (1 + z) e^(-z) = sum over k >= 2 of (-1)^k (k - 1) z^k/k!
         j1 = 0
         term = 0.5_dp
         do k = 2, n_terms
            j1 = j1 + (k - 1)*term
            term = -term*z/(k + 1)
         end do
      else
         j1 = (-expm1(-z) - z*exp(-z))/z**2
      end if
      j0 = 1
      if (z > 0) j0 = -expm1(-z)/z
      slope_0 = j0 - exp(-z)
      slope_1 = 2*j1 - exp(-z)
   end subroutine get_constant_hazard

   !> Integrals of the exponential hazard for z < 1, by the series of E1.
   pure subroutine get_short_lives(z, log_speed, j0, j1, slope_0, slope_1)
      real(dp), intent(in) :: z
      !> -ln z.
      real(dp), intent(in) :: log_speed
      !> J0 and J1, and their derivatives by ln u.
      real(dp), intent(out) :: j0, j1, slope_0, slope_1
      real(dp) :: e1, integral, term
      integer :: k

      e1 = log_speed - euler
      integral = (log_speed - euler)**2/2 + pi**2/12
      term = 1
      do k = 1, n_integral_terms
         term = -term*z/k
         e1 = e1 - term/k
         integral = integral + term/k**2
      end do
      j0 = exp(z)*e1
      j1 = exp(z)*integral
      slope_0 = 1 - z*j0
      slope_1 = j0 - z*j1
   end subroutine get_short_lives

   !> Integrals of the exponential hazard for z >= 1: with w = e^x - 1 = t/z, J0 = int e^(-t) g0 dt/z and J1 = int e^(-t) g1 dt/z,
   !> g0 = 1/(1 + w), g1 = ln(1 + w)/(1 + w).
   pure subroutine get_long_lives(z, j0, j1, slope_0, slope_1)
      real(dp), intent(in) :: z
      !> J0 and J1, and their derivatives by ln u.
      real(dp), intent(out) :: j0, j1, slope_0, slope_1
      real(dp) :: sums(4), t, w, share
      integer :: i, k

      sums = 0
      do k = 1, ubound(panel_ends, 1)
         associate (half => (panel_ends(k) - panel_ends(k - 1))/2, middle => (panel_ends(k) + panel_ends(k - 1))/2)
            do i = 1, size(gauss_nodes)
               t = middle + half*gauss_nodes(i)
               w = t/z
               share = half*gauss_weights(i)*exp(-t)/(1 + w)
               sums = sums + share*[1.0_dp, log1p(w), -w/(1 + w), w*(1 - log1p(w))/(1 + w)]
            end do
         end associate
      end do
      sums = sums/z
      j0 = sums(1)
      j1 = sums(2)
      slope_0 = j0 + sums(3)
      slope_1 = j1 + sums(4)
   end subroutine get_long_lives

end module adfric_interface_breaking_bonds

! SPDX-License-Identifier: GPL-3.0-or-later
!> Mean stress at which contacts escape whose barrier falls with the power 3/2 of the force (Prandtl and Tomlinson).
!>
!> The force on a contact rises from 0 to F = F_c, where its barrier is gone, at a rate that is R times the attempts to escape.
!> With d = 1 - sqrt(1 - F/F_c) and B the barrier without force over kT the share of contacts that have not escaped is exp(-H),
!>
!>     H(d) = (1/R) int exp(-B u^3) 2 u du, over u from 1 - d to 1,
!>
!> and the mean force over F_c is M = int exp(-H(d)) 2 (1 - d) dd over d from 0 to 1. As H goes with 1/R, d ln M/d ln R is the mean
!> of H with the weight exp(-H). In d nothing cancels, however slow the ramp is.
module adfric_interface_escape_stress
   use adfric_base_kinds, only: dp
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   implicit none (type, external)
   private
   public :: get_escape_stress

   !> Where H exceeds it nothing remains, and below the least one everything.
   real(dp), parameter :: largest_hazard = 40.0_dp, least_hazard = 1.0e-15_dp
   !> From panel to panel H falls by this factor.
   real(dp), parameter :: ratio = 6.0_dp
   !> Logarithm of H, to which the ends of panels are found.
   real(dp), parameter :: tolerance = 0.1_dp
   !> Where the exponent exceeds it an integrand is nothing.
   real(dp), parameter :: largest_exponent = 42.0_dp
   integer, parameter :: most_bisections = 200

contains

   !> Mean stress at escape over its largest value, and how it changes with the speed.
   pure subroutine get_escape_stress(barrier, log_rate, stress, slope)
      !> B, the barrier over kT [-], > 0.
      real(dp), intent(in) :: barrier
      !> Logarithm of R, the rate of the ramp over that of the attempts [-].
      real(dp), intent(in) :: log_rate
      !> M [-], 0 to 1.
      real(dp), intent(out) :: stress
      !> d ln M/d ln R [-].
      real(dp), intent(out) :: slope
      real(dp) :: upper, lower, level, weight, hazard, d, moment
      integer :: i
      logical :: is_last

      stress = 0
      moment = 0
      level = log(largest_hazard)
      upper = end_at(barrier, log_rate, level)
      is_last = .false.
      do while (.not. is_last)
         level = level - log(ratio)
         is_last = level < log(least_hazard)
         lower = 0
         if (.not. is_last) lower = min(upper, end_at(barrier, log_rate, level))
         do i = 1, size(gauss_nodes)
            d = lower + (upper - lower)*(1 + gauss_nodes(i))/2
            hazard = exp(min(log_hazard(barrier, log_rate, d), log(2*largest_exponent)))
            weight = gauss_weights(i)*(upper - lower)*(1 - d)*exp(-hazard)
            stress = stress + weight
            moment = moment + weight*hazard
         end do
         upper = lower
      end do
      slope = 1
      if (stress > 0) slope = moment/stress
   end subroutine get_escape_stress

   !> Where ln H reaches a level, or 1 where it does not.
   pure real(dp) function end_at(barrier, log_rate, level) result(d)
      real(dp), intent(in) :: barrier, log_rate, level
      real(dp) :: low, high, middle, reached
      integer :: i

      d = 1
      if (log_hazard(barrier, log_rate, d) <= level) return
      ! exp(-B) (2 d - d^2) <= R H <= 2 d
      low = level + log_rate - log(2.0_dp)
      high = min(0.0_dp, level + log_rate + barrier)
      do i = 1, most_bisections
         middle = low + (high - low)/2
         reached = log_hazard(barrier, log_rate, exp(middle))
         if (abs(reached - level) < tolerance) exit
         if (reached > level) then
            high = middle
         else
            low = middle
         end if
      end do
      d = exp(middle)
   end function end_at

   !> ln H.
   pure real(dp) function log_hazard(barrier, log_rate, d)
      real(dp), intent(in) :: barrier, log_rate
      !> Position, 0 < d <= 1.
      real(dp), intent(in) :: d
      real(dp) :: u, length, whole, x, total
      integer :: i, k
      integer, parameter :: n_panels = 3

      u = 1 - d
      ! B ((u + x)^3 - u^3) is at least 3 u^2 B x and at least B x^3
      length = min(d, (largest_exponent/barrier)**(1.0_dp/3.0_dp))
      if (3*u**2*barrier*length > largest_exponent) length = largest_exponent/(3*u**2*barrier)
      whole = 0
      do k = 1, n_panels
         do i = 1, size(gauss_nodes)
            x = length*(k - 0.5_dp + gauss_nodes(i)/2)/n_panels
            whole = whole + gauss_weights(i)*exp(-barrier*x*(3*u*(u + x) + x**2))*(u + x)
         end do
      end do
      total = whole*length/n_panels
      log_hazard = log(total) - log_rate - barrier + barrier*d*(3*u + d**2)
   end function log_hazard

end module adfric_interface_escape_stress

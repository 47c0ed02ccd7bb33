! SPDX-License-Identifier: GPL-3.0-or-later
!> What ends a zone, within one piece of the heights, and the first position where it does.
!>
!> The curve is a polynomial in theta and a sum of decays. A step towards its first zero uses a bound of its second derivative on the
!> rest of the piece, so that it cannot pass a zero: with h'' >= -B, h is positive before the zero of h + h' s - B s^2/2.
module adfric_foundation_stepping_zone_curve
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: zone_curve_t, find_first_zero, highest_power

   !> Highest power of theta.
   integer, parameter :: highest_power = 21
   !> Most steps towards a zero.
   integer, parameter :: most_steps = 2000
   !> The least step in theta, and in shares of what has passed, which is lost in round-off no more.
   real(dp), parameter :: least_step = 4.0e-16_dp

   !> A curve h(theta), positive where the zone lasts.
   type :: zone_curve_t
      !> Number of decays, and the last power with a coefficient.
      integer :: n = 0, last = 0
      !> Coefficients of the powers of theta.
      real(dp) :: power(0:highest_power) = 0
      !> Theta where the decays have their amplitudes.
      real(dp) :: anchor = 0
      !> Amplitudes and rates of the decays; shape `(n)`.
      real(dp), allocatable :: amplitude(:), rate(:)
   end type zone_curve_t

contains

   !> Value and slope at a position, and a bound of minus the second derivative from there to the end of the piece.
   pure subroutine evaluate(self, passed, value, slope, bound)
      type(zone_curve_t), intent(in) :: self
      !> Position, as the share of the piece since the anchor.
      real(dp), intent(in) :: passed
      !> Receives value and derivative.
      real(dp), intent(out) :: value, slope
      !> Receives the bound, >= 0.
      real(dp), intent(out) :: bound
      real(dp) :: theta, remaining
      integer :: i, m

      theta = self%anchor + passed
      value = 0
      slope = 0
      bound = 0
      do m = self%last, 1, -1
         value = value*theta + self%power(m)
         slope = slope*theta + m*self%power(m)
      end do
      value = value*theta + self%power(0)
      do m = 2, self%last
         ! a power with a positive coefficient bends upwards
         if (self%power(m) < 0) bound = bound - m*(m - 1)*self%power(m)
      end do
      do i = 1, self%n
         remaining = self%rate(i)*passed
         if (remaining > 700) cycle
         remaining = self%amplitude(i)*exp(-remaining)
         value = value + remaining
         slope = slope - self%rate(i)*remaining
         if (remaining < 0) bound = bound - self%rate(i)**2*remaining
      end do
   end subroutine evaluate

   !> Find the first position in a piece, from the anchor on, where the curve falls to zero. What has passed since the anchor is kept apart
   !> from theta, since arms may relax in less than the round-off of a position.
   pure subroutine find_first_zero(self, tolerance, has_risen, passed, has_zero, is_found)
      type(zone_curve_t), intent(in) :: self
      !> Value that is as good as zero, > 0.
      real(dp), intent(in) :: tolerance
      !> Has the curve been above zero since the zone began? Until then it ends where the curve is clearly below zero, for a column that
      !> touches and turns back has not changed its zone.
      logical, intent(inout) :: has_risen
      !> Receives the zero, if there is one, as the share of the piece since the anchor.
      real(dp), intent(out) :: passed
      !> Is there a zero in the piece?
      logical, intent(out) :: has_zero
      !> Has the search ended? Else it was given up.
      logical, intent(out) :: is_found
      real(dp) :: value, slope, bound, step, root
      integer :: k

      is_found = .true.
      has_zero = .false.
      passed = 0
      do k = 1, most_steps
         call evaluate(self, passed, value, slope, bound)
         if (value <= tolerance) then
            has_zero = count([has_risen, value < -tolerance, slope <= 0]) >= 2
            if (has_zero) then
               ! a zone is not shorter than a position can tell
               if (k == 1 .and. .not. has_risen) passed = least_step
               return
            end if
            ! nowhere near, the curve is clearly below zero
            value = max(value, -tolerance) + 2*tolerance
         else
            has_risen = .true.
         end if
         root = sqrt(slope**2 + 2*bound*value)
         ! a step of a whole piece is as good as a longer one, which may be larger than a number can be
         step = 1
         if (slope >= 0) then
            if (slope + root < bound) step = (slope + root)/bound
         else
            if (2*value < root - slope) step = 2*value/(root - slope)
         end if
         passed = passed + max(step, least_step*passed, tiny(step))
         if (self%anchor + passed >= 1) return
      end do
      is_found = .false.
   end subroutine find_first_zero

end module adfric_foundation_stepping_zone_curve

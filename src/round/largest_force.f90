! SPDX-License-Identifier: GPL-3.0-or-later
!> The largest force on the path from rest to sliding of a contact that shrinks as slip takes from its adhesion.
!>
!> It is that of the end of the path, or one that no stretch from g to g' can hide: its forces are below
!> T0 b(g)^2 (2/pi) (th' + sin th' cos th'). Stretches that may hide more are divided, down to 5 %; there the signs of dT/dg at both ends
!> show a peak.
module adfric_round_largest_force
   use adfric_base_kinds, only: dp
   use adfric_round_shrinking_path, only: force_of, shrinking_path_t, slip_state_t
   use adfric_round_slip_annulus, only: force_of_angle
   implicit none (type, external)
   private
   public :: find_largest_force

   !> Smallest stretch of ln g.
   real(dp), parameter :: least_stretch = 0.05_dp
   !> A step of ln g that is round-off.
   real(dp), parameter :: round_off = 8*epsilon(1.0_dp)

contains

   !> The largest force before the contact is constant, if it is larger than a given one.
   pure subroutine find_largest_force(path, start, finish, force, state, is_found)
      class(shrinking_path_t), intent(inout) :: path
      !> The state at rest, and the end of the part where the contact changes.
      type(slip_state_t), intent(in) :: start, finish
      !> The force that is to be surpassed.
      real(dp), intent(in) :: force
      !> Receives the state of a larger force, if there is one.
      type(slip_state_t), intent(out) :: state
      logical, intent(out) :: is_found
      integer, parameter :: most_stretches = 2000
      type(slip_state_t) :: high, low, stack(64)
      real(dp) :: largest, position, rate
      integer :: n, k

      position = -1
      rate = 0
      is_found = .false.
      if (.not. path%is_weakened) return
      largest = force
      high = finish
      n = 0
      do k = 1, most_stretches
         if (n == 0) then
            ! the next stretch towards the beginning
            call path%get_state(high%slip_energy/2, low)
            if (.not. low%is_found) return
         else
            low = stack(n)
         end if
         ! nothing before the end of this stretch bears more
         if (bound_of(path, start, high) <= largest) return
         if (bound_of(path, low, high) <= largest .or. log(high%slip_energy/low%slip_energy) <= least_stretch) then
            if (bound_of(path, low, high) > largest) call find_peak(path, low, high, position, rate, &
               & largest, state, is_found)
            high = low
            n = max(n - 1, 0)
         else if (n < size(stack) - 1) then
            if (n == 0) stack(1) = low
            n = max(n, 1)
            n = n + 1
            call path%get_state(sqrt(low%slip_energy)*sqrt(high%slip_energy), stack(n))
         else
            return
         end if
      end do
   end subroutine find_largest_force

   !> No state between two of the path bears more than this.
   pure real(dp) function bound_of(path, low, high) result(bound)
      class(shrinking_path_t), intent(in) :: path
      type(slip_state_t), intent(in) :: low, high

      bound = path%force_scale*low%radius**2*force_of_angle(high%angle)
   end function bound_of

   !> The peak between two states close to each other.
   pure subroutine find_peak(path, first, last, position, known_rate, largest, peak, is_found)
      class(shrinking_path_t), intent(inout) :: path
      type(slip_state_t), intent(in) :: first, last
      !> A g whose rate is known. Out: that of the first state.
      real(dp), intent(inout) :: position
      !> Its d ln T/d ln g.
      real(dp), intent(inout) :: known_rate
      !> In: the largest force so far. Out: that of the peak if it is larger.
      real(dp), intent(inout) :: largest
      type(slip_state_t), intent(inout) :: peak
      !> Becomes true then.
      logical, intent(inout) :: is_found
      integer, parameter :: most_steps = 100
      ! the rate of ln T that is round-off
      real(dp), parameter :: flat = 1.0e-14_dp
      type(slip_state_t) :: state
      real(dp) :: low, high, at_low, at_high, y, rate
      integer :: k, side

      at_high = known_rate
      if (abs(last%slip_energy - position) > 0) call path%get_state(last%slip_energy, state, at_high)
      call path%get_state(first%slip_energy, state, at_low)
      position = first%slip_energy
      known_rate = at_low
      if (.not. (at_low > 0 .and. at_high < 0)) return
      low = log(first%slip_energy)
      high = log(last%slip_energy)
      state = first
      side = 0
      do k = 1, most_steps
         if (high - low <= round_off) exit
         y = low + (high - low)*(at_low/(at_low - at_high))
         if (.not. (y > low .and. y < high) .or. modulo(k, 6) == 0) y = low + (high - low)/2
         call path%get_state(exp(y), state, rate)
         if (.not. state%is_found) return
         if (abs(rate) <= flat) exit
         if (rate > 0) then
            low = y
            at_low = rate
            if (side == 1) at_high = at_high/2
            side = 1
         else
            high = y
            at_high = rate
            if (side == 2) at_low = at_low/2
            side = 2
         end if
      end do
      if (.not. force_of(path, state) > largest) return
      largest = force_of(path, state)
      peak = state
      is_found = .true.
   end subroutine find_peak

end module adfric_round_largest_force

! SPDX-License-Identifier: GPL-3.0-or-later
!> The search along the curve of states of an instant, with the radius c of adhesion as its parameter: the first root of S, what a
!> state has of what is prescribed less what is prescribed, in the direction of its sign.
module adfric_round_timed_adhesion_search
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_round_timed_adhesion_memory, only: reserve_nodes, spring_memory_t
   use adfric_round_timed_adhesion_problem, only: zone_problem_t, zone_state_t
   use adfric_round_timed_adhesion_zone, only: shift_state, solve_zone, sum_up
   use adfric_round_timed_path, only: timed_control_t
   implicit none (type, external)
   private
   public :: find_near, find_jump

   !> What a search has found: a root beside the start, none there, or no state at all.
   integer, parameter, public :: near = 1, far = 2, nowhere = 3
   !> A step of Newton's method that is not checked, in cells: it leaves its square.
   real(dp), parameter :: enough = 1.0e-5_dp

contains

   !> What a state has more than is prescribed.
   pure real(dp) function excess(control, prescribed, state)
      type(timed_control_t), intent(in) :: control
      real(dp), intent(in) :: prescribed
      type(zone_state_t), intent(in) :: state

      excess = control%by_load*state%load - prescribed
      if (control%by_approach > 0) excess = excess + control%by_approach*state%approach
   end function excess

   !> Its derivative by c along the curve of states.
   pure real(dp) function excess_slope(control, state)
      type(timed_control_t), intent(in) :: control
      type(zone_state_t), intent(in) :: state

      excess_slope = control%by_load*state%load_slope + control%by_approach*state%approach_slope
   end function excess_slope

   !> The state of another c, from a state beside it.
   pure subroutine solve_beside(problem, c, from, state)
      type(zone_problem_t), intent(in) :: problem
      real(dp), intent(in) :: c
      type(zone_state_t), intent(in) :: from
      type(zone_state_t), intent(out) :: state
      real(dp) :: guess

      guess = from%a
      if (guess > 0) guess = max(guess/2, min(guess + from%a_slope*(c - from%c), c - (from%c - guess)/2))
      call solve_zone(problem, c, guess, state)
   end subroutine solve_beside

   !> The state without contact: apart as far as is prescribed, or, under a load, nobody knows where.
   pure subroutine part(control, prescribed, state)
      type(timed_control_t), intent(in) :: control
      real(dp), intent(in) :: prescribed
      type(zone_state_t), intent(out) :: state

      state%approach = not_a_number()
      if (control%by_approach > 0) state%approach = prescribed/control%by_approach
   end subroutine part

   !> The first root of S beside the present radius.
   pure subroutine find_near(problem, control, present_state, prescribed, reach, state, verdict)
      !> The elastic problem of the instant.
      type(zone_problem_t), intent(in) :: problem
      !> What is prescribed, the state before, and the value that is prescribed now.
      type(timed_control_t), intent(in) :: control
      type(zone_state_t), intent(in) :: present_state
      real(dp), intent(in) :: prescribed
      !> How far it may be.
      real(dp), intent(in) :: reach
      !> Receives the state, and one of `near`, `far`, `nowhere`.
      type(zone_state_t), intent(out) :: state
      integer, intent(out) :: verdict
      real(dp), parameter :: round_off = 8*epsilon(1.0_dp), still = 1.0e-8_dp, least = 1.0e-6_dp
      type(zone_state_t) :: last
      real(dp) :: first, value, before, side, moved, ahead, slope, begin

      call solve_zone(problem, present_state%c, present_state%a, state)
      verdict = nowhere
      if (.not. state%is_found) return
      first = excess(control, prescribed, state)
      verdict = near
      if (.not. state%c > 0) then
         ! without a load that pulls contact begins
         if (.not. control%by_approach > 0) first = merge(-1.0_dp, 1.0_dp, prescribed >= 0)
         if (first < 0) verdict = far
         call part(control, prescribed, state)
         return
      end if
      if (abs(first) <= max(round_off*(abs(prescribed) + abs(first - prescribed)), &
         & still*abs(excess_slope(control, state))*problem%cell)) return
      side = sign(1.0_dp, -first)
      begin = state%c
      moved = 0
      before = first
      do
         ! by Newton's method, or as far as may be where it looks back
         slope = excess_slope(control, state)
         ahead = reach
         if (-side*before*slope > 0 .and. abs(before) < abs(slope)*reach) ahead = abs(before/slope)
         if (moved > 0 .and. ahead <= enough*problem%cell) then
            call shift_state(problem, state, side*ahead)
            return
         end if
         moved = min(reach, moved + max(ahead, least*reach))
         last = state
         call solve_beside(problem, max(0.0_dp, begin + side*moved), last, state)
         if (.not. state%is_found) then
            verdict = nowhere
            return
         end if
         value = excess(control, prescribed, state)
         if (.not. value*first > 0) exit
         if (.not. moved < reach .or. .not. state%c > 0) then
            verdict = far
            return
         end if
         before = value
      end do
      call find_root(problem, control, prescribed, last, before, (state), value, state, verdict)
   end subroutine find_near

   !> The root of S between two states.
   pure subroutine find_root(problem, control, prescribed, one, its_value, other, other_value, state, verdict)
      type(zone_problem_t), intent(in) :: problem
      type(timed_control_t), intent(in) :: control
      real(dp), intent(in) :: prescribed
      !> The two, and S of them, of unlike signs.
      type(zone_state_t), intent(in), value :: one, other
      real(dp), intent(in), value :: its_value, other_value
      !> Receives the state.
      type(zone_state_t), intent(out) :: state
      integer, intent(out) :: verdict
      integer, parameter :: most_steps = 100
      type(zone_state_t) :: low, high
      real(dp) :: low_value, value, c, change, slope
      integer :: k

      low = one
      high = other
      low_value = its_value
      state = other
      value = other_value
      verdict = near
      do k = 1, most_steps
         if (.not. abs(value) > 0) exit
         ! by Newton's method from the last state, or to the middle
         slope = excess_slope(control, state)
         change = 2*max(low%c, high%c)
         if (abs(slope)*change > abs(value)) change = -value/slope
         c = state%c + change
         if ((c - low%c)*(c - high%c) < 0) then
            if (abs(change) <= enough*problem%cell) then
               call shift_state(problem, state, change)
               exit
            end if
            if (modulo(k, 4) == 0) c = (low%c + high%c)/2
         else
            c = (low%c + high%c)/2
         end if
         if (abs(high%c - low%c) <= 4*epsilon(c)*max(low%c, high%c)) exit
         call solve_beside(problem, c, (state), state)
         if (.not. state%is_found) then
            verdict = nowhere
            return
         end if
         value = excess(control, prescribed, state)
         if (value*low_value > 0) then
            low = state
            low_value = value
         else
            high = state
         end if
      end do
   end subroutine find_root

   !> The first root of S, however far it is, or no contact.
   pure subroutine find_jump(problem, memory, control, present_state, prescribed, state, verdict)
      !> The elastic problem of the instant, and its springs; both receive nodes where they are needed.
      type(zone_problem_t), intent(inout) :: problem
      type(spring_memory_t), intent(inout) :: memory
      !> What is prescribed, the state before, and the value that is prescribed now.
      type(timed_control_t), intent(in) :: control
      type(zone_state_t), intent(in) :: present_state
      real(dp), intent(in) :: prescribed
      !> Receives the state, and one of `near`, `nowhere`.
      type(zone_state_t), intent(out) :: state
      integer, intent(out) :: verdict
      integer, parameter :: most_steps = 10000000
      type(zone_state_t) :: last
      real(dp) :: first, value, before, side
      integer :: k

      call solve_zone(problem, present_state%c, present_state%a, last)
      first = excess(control, prescribed, last)
      if (.not. last%c > 0) first = -1
      side = sign(1.0_dp, -first)
      before = first
      do k = 1, most_steps
         call reserve_nodes(memory, problem, int(last%c/problem%cell) + 4)
         call sum_up(problem, last%c + side*problem%cell/2, last%a, side/2, .false.)
         call solve_beside(problem, max(0.0_dp, last%c + side*problem%cell/2), last, state)
         verdict = nowhere
         if (.not. state%is_found) return
         value = excess(control, prescribed, state)
         if (.not. value*first > 0) exit
         if (.not. state%c > 0) then
            call part(control, prescribed, state)
            verdict = near
            return
         end if
         last = state
         before = value
      end do
      call find_root(problem, control, prescribed, last, before, (state), value, state, verdict)
   end subroutine find_jump

end module adfric_round_timed_adhesion_search

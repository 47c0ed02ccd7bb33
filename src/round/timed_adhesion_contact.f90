! SPDX-License-Identifier: GPL-3.0-or-later
!> A contact with a zone of adhesion on a viscoelastic half-space in time, step after step.
!>
!> Each step is an elastic problem (`adfric_round_timed_adhesion_zone`). Its states form a curve with the radius c of adhesion as
!> the parameter; along it runs
!>
!>     S(c) = [what is prescribed, as this state has it] - [what is prescribed]
!>
!> Where S < 0 the radius grows to the first root of S, where S > 0 it shrinks to the first one. A step ends before either radius
!> has moved by more than half a cell. Where it moves further however short the step is, it jumps: an event.
module adfric_round_timed_adhesion_contact
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_round_shape, only: shape_t
   use adfric_round_timed_adhesion_memory, only: prepare_step, reserve_nodes, spring_memory_t, start_memory, &
      & stored_energy, take_step, wake_springs
   use adfric_round_timed_adhesion_problem, only: set_shape, zone_problem_t, zone_state_t
   use adfric_round_timed_adhesion_search, only: find_jump, find_near, near, nowhere
   use adfric_round_timed_adhesion_zone, only: set_edge, sum_up, zone_energy
   use adfric_round_timed_path, only: prescribed_at, prescribed_rate, timed_control_t, timed_leg_t
   use adfric_solid_prony, only: prony_t
   implicit none (type, external)
   private
   public :: adhesive_contact_t, start_adhesive_contact, advance_to

   !> A jump of the contact.
   type :: zone_jump_t
      !> Its leg.
      integer :: leg = 0
      !> Its time.
      real(dp) :: clock = 0
      !> The states before and after.
      type(zone_state_t) :: before, after
   end type zone_jump_t

   !> The least load of legs that retract.
   type :: least_load_t
      !> Load, approach and time; the load is enormous where there is none.
      real(dp) :: load = huge(1.0_dp), approach = 0, clock = 0
      !> Its leg.
      integer :: leg = 0
      !> Was the step before the lowest one so far?
      logical :: was_last = .false.
   end type least_load_t

   !> A contact.
   type :: adhesive_contact_t
      !> The elastic problem of the present step.
      type(zone_problem_t) :: problem
      !> The springs.
      type(spring_memory_t) :: memory
      !> The state.
      type(zone_state_t) :: state
      !> What is prescribed.
      type(timed_control_t) :: control
      !> Its legs; shape `(n_legs)`.
      type(timed_leg_t), allocatable :: legs(:)
      !> Longest step over the time that has passed since the last kink.
      real(dp) :: fineness = 0.05_dp
      !> Present leg.
      integer :: leg = 1
      !> Phase of it, phase of the last kink, and length in phase of the next step.
      real(dp) :: phase = 0, kink = 0, next = 0
      !> Time since the last kink, and length in time of the next step, at the end of the leg before.
      real(dp), private :: since = 0, last_step = 0
      !> The jumps; the first `n_jumps` have a meaning.
      type(zone_jump_t), allocatable :: jumps(:)
      !> Number of jumps.
      integer :: n_jumps = 0
      !> Work of the load, what arms have lost and what jumps have taken, and the largest amount of work.
      real(dp) :: work = 0, lost = 0, taken = 0, largest_work = 0
      !> Least load of legs that retract.
      type(least_load_t) :: least
      !> The last steps of a leg, of which the first may be missing.
      real(dp), private :: times(2) = 0, loads(2) = 0, approaches(2) = 0
      !> How many of them there are.
      integer, private :: n_before = 0
      !> Change of the radius of adhesion in the last step.
      real(dp), private :: moved = 0
      !> The narrowest zone that was met, in cells.
      real(dp) :: narrowest = huge(1.0_dp)
   end type adhesive_contact_t

   !> Shortest step in phase.
   real(dp), parameter :: least_phase = 4.0e-15_dp

contains

   !> A contact before the begin of its history.
   pure subroutine start_adhesive_contact(self, solid, shape, stress, range, cell, control, legs)
      !> Receives the contact.
      type(adhesive_contact_t), intent(out) :: self
      !> The solid, whose relaxed modulus is 1.
      type(prony_t), intent(in) :: solid
      !> The shape.
      class(shape_t), intent(in) :: shape
      !> Stress S of adhesion and its range h, reduced.
      real(dp), intent(in) :: stress, range
      !> Distance of the nodes.
      real(dp), intent(in) :: cell
      !> What is prescribed, and its legs; shape `(n_legs)`.
      type(timed_control_t), intent(in) :: control
      type(timed_leg_t), intent(in) :: legs(:)
      integer, parameter :: first_nodes = 256
      integer :: n_nodes

      call set_shape(self%problem, shape)
      self%problem%stress = stress
      self%problem%range = range
      self%problem%cell = cell
      self%control = control
      self%legs = legs
      associate (face => self%problem%face)
         ! approaches up to the largest one are as long as the face
         if (face < huge(face)) self%problem%face_scale = (max(maxval(abs(legs%begin)), maxval(abs(legs%end))) &
            & /(control%by_approach + 2*face*control%by_load) + range)/face + 2*stress
      end associate
      allocate (self%jumps(8))
      n_nodes = first_nodes
      if (self%problem%face < huge(cell)) n_nodes = max(n_nodes, nint(self%problem%face/cell) + 4)
      call start_memory(self%memory, solid, self%problem, n_nodes)
      self%state%approach = not_a_number()
      if (control%by_approach > 0) self%state%approach = prescribed_at(legs(1), 0.0_dp)/control%by_approach
   end subroutine start_adhesive_contact

   !> Go on to a phase of the present leg.
   pure subroutine advance_to(self, phase, is_solved)
      !> The contact.
      type(adhesive_contact_t), intent(inout) :: self
      !> The phase, above that of the contact; at 1 the leg ends.
      real(dp), intent(in) :: phase
      !> Were all steps found?
      logical, intent(out) :: is_solved
      integer, parameter :: most_steps = 20000000
      integer :: step

      is_solved = .true.
      if (.not. self%phase > 0) call begin_leg(self)
      do step = 1, most_steps
         if (.not. self%phase < phase) exit
         call take_one_step(self, phase, is_solved)
         if (.not. is_solved) return
      end do
      is_solved = .not. self%phase < phase
      if (.not. phase < 1) then
         self%since = self%legs(self%leg)%span*(1 - self%kink)
         self%last_step = self%legs(self%leg)%span*self%next
         self%leg = self%leg + 1
         self%phase = 0
      end if
   end subroutine advance_to

   !> Begin a leg. At its begin the rate of what is prescribed has a kink. Where that is weak, as in a list of many values, steps go
   !> on as before it: as if a share of the time since the last strong one had passed.
   pure subroutine begin_leg(self)
      type(adhesive_contact_t), intent(inout) :: self
      real(dp), parameter :: strong = 0.25_dp
      real(dp) :: share, before, after, largest

      self%kink = 0
      self%next = 0
      share = 0
      if (self%leg > 1) then
         associate (last => self%legs(self%leg - 1), leg => self%legs(self%leg))
            if (last%span > 0 .and. leg%span > 0) then
               before = prescribed_rate(last, 1.0_dp)/last%span
               after = prescribed_rate(leg, 0.0_dp)/leg%span
               largest = max(abs(before), abs(after))
               if (largest > 0) share = max(0.0_dp, 1 - abs(after - before)/(strong*largest))
               self%kink = -share*self%since/leg%span
               self%next = share*self%last_step/leg%span
            end if
         end associate
      end if
      self%next = max(self%next, first_step(self))
      if (.not. share > 0) self%n_before = 0
   end subroutine begin_leg

   !> Length in phase of the first step after a kink.
   pure real(dp) function first_step(self)
      type(adhesive_contact_t), intent(in) :: self
      real(dp), parameter :: share_of_time = 0.05_dp

      first_step = 1.0e-3_dp
      associate (leg => self%legs(self%leg))
         if (leg%span > 0 .and. size(self%memory%solid%times) > 0) first_step = min(first_step, &
            & share_of_time*self%fineness*self%memory%solid%times(1)/leg%span)
      end associate
      first_step = max(first_step, least_phase)
   end function first_step

   !> One step.
   pure subroutine take_one_step(self, phase, is_solved)
      type(adhesive_contact_t), intent(inout) :: self
      !> Where it ends at the latest.
      real(dp), intent(in) :: phase
      logical, intent(out) :: is_solved
      real(dp), parameter :: growth = 2.0_dp, margin = 0.9_dp, almost = 0.6_dp
      integer, parameter :: most_tries = 200
      type(zone_state_t) :: state
      real(dp) :: step, span, prescribed, end, reach, moved
      integer :: try, verdict
      logical :: is_jump

      reach = self%problem%cell/2
      step = self%next
      if (self%legs(self%leg)%span > 0 .and. self%memory%last >= 0) step = min(step, max(first_step(self), &
         & self%fineness*(self%phase - self%kink)))
      is_solved = .false.
      is_jump = .false.
      call reserve_nodes(self%memory, self%problem, int(self%state%c/self%problem%cell) + 4)
      do try = 1, most_tries
         end = self%phase + step
         if (end > phase - least_phase) end = phase
         if (end < phase .and. end > phase - almost*step) end = self%phase + (phase - self%phase)/2
         if (.not. end > self%phase) end = phase
         span = self%legs(self%leg)%span*(end - self%phase)
         prescribed = prescribed_at(self%legs(self%leg), end)
         call prepare_step(self%memory, span, self%problem)
         call set_edge(self%problem, self%state)
         call sum_up(self%problem, self%problem%adhesion_radius(self%state%c), self%state%a, self%moved/(2*self%problem%cell), &
            & .true.)
         call find_near(self%problem, self%control, self%state, prescribed, reach, state, verdict)
         if (self%memory%core > 0 .and. (verdict == nowhere .or. int(state%a/self%problem%cell) < self%memory%core)) then
            call wake_all(self, span)
            call find_near(self%problem, self%control, self%state, prescribed, reach, state, verdict)
         end if
         moved = abs(state%c - self%state%c)
         if (max(state%a, self%state%a) > 2*reach) moved = max(moved, abs(state%a - self%state%a))
         if (verdict == near .and. (moved <= reach .or. end - self%phase <= 2*least_phase)) exit
         if (end - self%phase <= 2*least_phase) then
            call wake_all(self, span)
            call find_jump(self%problem, self%memory, self%control, self%state, prescribed, state, verdict)
            is_jump = verdict == near
            exit
         end if
         step = (end - self%phase)/2
         if (verdict == near .and. moved > 0) step = (end - self%phase)*max(0.2_dp, margin*reach/moved)
         step = max(step, least_phase)
      end do
      if (verdict /= near) return
      is_solved = .true.
      if (abs(state%c - self%state%c) > 6*reach .or. .not. state%c > 0 .and. self%state%c > 0) is_jump = .true.
      ! at the edge of a flat punch a zone of any width has all digits
      if (state%a > 0 .and. .not. state%c > self%problem%face) self%narrowest = min(self%narrowest, &
         & (state%c - state%a)/self%problem%cell)
      self%moved = merge(0.0_dp, state%c - self%state%c, is_jump)
      call account(self, state, self%legs(self%leg)%clock + self%legs(self%leg)%span*end, is_jump)
      self%state = state
      self%next = (end - self%phase)*min(growth, margin*reach/max(moved, tiny(1.0_dp)))
      self%phase = end
      if (is_jump) then
         self%kink = self%phase
         self%next = least_phase
      end if
   end subroutine take_one_step

   !> States of the present step may ask for the memory of all nodes.
   pure subroutine wake_all(self, span)
      type(adhesive_contact_t), intent(inout) :: self
      !> Length of the step in time.
      real(dp), intent(in) :: span
      integer, parameter :: pause = 64

      self%memory%pause = max(self%memory%pause, pause)
      if (self%memory%core == 0 .and. self%memory%tail%first > self%memory%last) return
      call wake_springs(self%memory)
      call prepare_step(self%memory, span, self%problem)
   end subroutine wake_all

   !> Energies, jumps, least load and memory of a step.
   pure subroutine account(self, state, clock, is_jump)
      type(adhesive_contact_t), intent(inout) :: self
      !> The state at its end.
      type(zone_state_t), intent(in) :: state
      !> Time at its end.
      real(dp), intent(in) :: clock
      logical, intent(in) :: is_jump
      type(zone_jump_t), allocatable :: more(:)
      real(dp) :: work, energy

      work = 0
      if (self%state%c > 0 .or. state%c > 0) then
         ! a load that nothing carries any more does no work that is known
         if (self%control%by_approach > 0 .or. self%state%c > 0 .and. state%c > 0) &
            & work = (self%state%load + state%load)/2*(state%approach - self%state%approach)
      end if
      self%work = self%work + work
      self%largest_work = max(self%largest_work, abs(self%work))
      if (is_jump) then
         energy = stored_energy(self%memory, self%problem%cell) + zone_energy(self%problem, self%state)
         if (self%n_jumps == size(self%jumps)) then
            allocate (more(2*self%n_jumps))
            more(:self%n_jumps) = self%jumps
            call move_alloc(more, self%jumps)
         end if
         self%n_jumps = self%n_jumps + 1
         self%jumps(self%n_jumps) = zone_jump_t(self%leg, clock, self%state, state)
      end if
      call reserve_nodes(self%memory, self%problem, int(state%c/self%problem%cell) + 4)
      call take_step(self%memory, self%problem, state, self%lost)
      if (is_jump) self%taken = self%taken + work + energy - stored_energy(self%memory, self%problem%cell) &
         & - zone_energy(self%problem, state)
      call find_least(self, state, clock, is_jump)
   end subroutine account

   !> The least load so far of legs that retract: between steps that of a parabola.
   pure subroutine find_least(self, state, clock, is_jump)
      type(adhesive_contact_t), intent(inout) :: self
      type(zone_state_t), intent(in) :: state
      real(dp), intent(in) :: clock
      logical, intent(in) :: is_jump
      real(dp) :: loads(2), approaches(2), shift

      associate (leg => self%legs(self%leg), least => self%least)
         if (.not. leg%end < leg%begin .and. .not. abs(leg%amplitude) > 0) return
         if (least%was_last .and. .not. is_jump .and. state%load >= self%state%load .and. self%n_before == 2 &
            & .and. clock > self%times(2)) then
            ! P = P2 + q1 x + q2 x^2 with x from the middle step
            loads = parabola_of([self%times, clock], [self%loads(1), self%state%load, state%load])
            if (loads(2) > 0) then
               shift = -loads(1)/(2*loads(2))
               if (abs(shift) <= max(clock - self%times(2), self%times(2) - self%times(1))) then
                  approaches = parabola_of([self%times, clock], [self%approaches(1), self%state%approach, state%approach])
                  least%load = self%state%load - loads(1)**2/(4*loads(2))
                  least%approach = self%state%approach + approaches(1)*shift + approaches(2)*shift**2
                  least%clock = self%times(2) + shift
               end if
            end if
         end if
         least%was_last = .false.
         if (self%state%c > 0 .and. state%c > 0 .and. state%load < least%load) then
            least%load = state%load
            least%approach = state%approach
            least%clock = clock
            least%leg = self%leg
            least%was_last = .true.
         end if
         self%times = [self%times(2), clock]
         self%loads = [self%loads(2), state%load]
         self%approaches = [self%approaches(2), state%approach]
         self%n_before = merge(0, min(2, self%n_before + 1), is_jump .or. .not. clock > self%times(1))
      end associate
   end subroutine find_least

   !> Slope and half the curvature, at the second of three samples, of the parabola through them.
   pure function parabola_of(x, y) result(coefficients)
      !> The samples, of which no two have the same x.
      real(dp), intent(in) :: x(3), y(3)
      real(dp) :: coefficients(2)
      real(dp) :: slopes(2)

      slopes = [(y(1) - y(2))/(x(1) - x(2)), (y(3) - y(2))/(x(3) - x(2))]
      coefficients(2) = (slopes(2) - slopes(1))/(x(3) - x(1))
      coefficients(1) = slopes(1) - coefficients(2)*(x(1) - x(2))
   end function parabola_of

end module adfric_round_timed_adhesion_contact

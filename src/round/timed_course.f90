! SPDX-License-Identifier: GPL-3.0-or-later
!> The course of a contact in time, kept as polynomials, so that approach, load and radius of contact can be read at any time. It is
!> what a fit asks for, point after point; and what a list with noise is read from, whose legs were made fewer.
module adfric_round_timed_course
   use adfric_base_kinds, only: dp
   use adfric_describe_model, only: model_t
   use adfric_describe_pointwise, only: point_state_t
   use adfric_describe_status, only: status_not_converged, status_solved
   use adfric_numerics_time_panels, only: get_weights, last_begun, n_nodes
   use adfric_round_indenter_states, only: indenter_states_t
   use adfric_round_timed_contact, only: advance, error_of, timed_contact_t
   use adfric_round_timed_cycle, only: read_cycle, timed_cycle_t
   use adfric_round_timed_panel, only: timed_panel_t
   use adfric_round_timed_path, only: timed_leg_t
   use adfric_round_timed_rows, only: p_approach, p_load, p_radius, p_time
   use adfric_round_timed_springs, only: get_spot
   implicit none (type, external)
   private
   public :: timed_course_t, find_course, join_legs, read_steps

   !> Panels that there is space for at first.
   integer, parameter :: first_space = 32

   !> What is kept of each panel.
   type :: kept_panel_t
      !> Time at the begin and length in time, in units of the contact.
      real(dp) :: clock = 0, span = 0
      !> Approach, depth and load at the nodes, and is there contact?
      real(dp), dimension(n_nodes) :: approach = 0, depth = 0, load = 0
      !> Is there contact?
      logical :: has_contact = .false.
   end type kept_panel_t

   !> The course.
   type, extends(point_state_t) :: timed_course_t
      !> Values of the variables that it belongs to; shape `(n_variables)`.
      real(dp), allocatable :: values(:)
      !> Time of the begin [s].
      real(dp) :: begin = 0
      !> The indenter on an elastic half-space, with the units.
      type(indenter_states_t) :: states
      !> The contact in closed form, where its path is one cycle; else there are panels.
      type(timed_cycle_t) :: cycle
      !> The panels.
      type(kept_panel_t), allocatable :: panels(:)
      !> Number of panels.
      integer :: n = 0
      !> Error of approach and load, and one of `status_...`.
      real(dp) :: error = 0
      !> See `error`.
      integer :: status = status_not_converged
   contains
      procedure :: keep
      procedure :: read_at
      procedure :: is_of
   end type timed_course_t

contains

   !> Follow a contact through its history.
   subroutine find_course(self, model, contact)
      !> In: with values, begin and units. Out: with the panels, the error and the status.
      class(timed_course_t), intent(inout) :: self
      !> The model, which may be told to end.
      class(model_t), intent(in) :: model
      !> The contact before its history, in these units; at its end afterwards.
      type(timed_contact_t), intent(inout) :: contact
      type(timed_panel_t) :: panel
      logical :: is_solved

      self%n = 0
      self%status = status_not_converged
      do while (.not. contact%is_done)
         if (model%is_stopped()) return
         call advance(contact, panel, is_solved)
         if (.not. is_solved) return
         call self%keep(panel)
      end do
      self%error = error_of(contact)
      self%status = status_solved
   end subroutine find_course

   !> Is it the course of these values, all but the time at which it is read?
   pure logical function is_of(self, values, time)
      class(timed_course_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Index of the time.
      integer, intent(in) :: time

      integer :: k

      is_of = size(values) == size(self%values)
      if (.not. is_of) return
      do k = 1, size(values)
         if (abs(values(k) - self%values(k)) <= 0 .or. k == time) cycle
         is_of = .false.
         return
      end do
   end function is_of

   !> Keep a panel.
   pure subroutine keep(self, panel)
      class(timed_course_t), intent(inout) :: self
      !> The panel, which begins where the one before ends.
      type(timed_panel_t), intent(in) :: panel
      type(kept_panel_t), allocatable :: more(:)

      if (.not. allocated(self%panels)) allocate (self%panels(first_space))
      if (self%n == size(self%panels)) then
         allocate (more(2*self%n))
         more(:self%n) = self%panels
         call move_alloc(more, self%panels)
      end if
      self%n = self%n + 1
      associate (kept => self%panels(self%n))
         kept%clock = panel%clock
         kept%span = panel%span
         kept%approach = panel%approach
         kept%depth = panel%depth
         kept%load = panel%load
         kept%has_contact = maxval(panel%radius) > 0
      end associate
   end subroutine keep

   !> Approach, load and radius of contact at a time, in SI units; behind a jump, where there is one.
   pure subroutine read_at(self, time, approach, load, radius, is_there)
      class(timed_course_t), intent(inout) :: self
      !> Time [s].
      real(dp), intent(in) :: time
      !> Receive the approach [m], the load [N] and the radius of contact [m].
      real(dp), intent(out) :: approach, load, radius
      !> Is the time one of the history?
      logical, intent(out) :: is_there
      real(dp), parameter :: round_off = 16*epsilon(1.0_dp)
      real(dp) :: clock, weights(n_nodes), moment, s

      clock = time - self%begin
      approach = 0
      load = 0
      radius = 0
      if (self%cycle%is_found) then
         is_there = clock >= -round_off*abs(time) .and. clock <= self%cycle%end + round_off*(abs(time) + abs(self%begin))
         if (is_there) call read_from_cycle(self, clock, approach, load, radius)
         return
      end if
      is_there = self%n > 0
      if (.not. is_there) return
      associate (last => self%panels(self%n))
         is_there = clock >= -round_off*(abs(time) + last%clock) .and. &
            & clock <= last%clock + last%span + round_off*(abs(time) + abs(self%begin))
      end associate
      if (.not. is_there) return
      associate (panel => self%panels(last_begun(self%panels(:self%n)%clock, clock)), case => self%states%case)
         s = 1
         if (panel%span > 0) s = min(1.0_dp, max(-1.0_dp, 2*(clock - panel%clock)/panel%span - 1))
         call get_weights(s, weights)
         approach = dot_product(weights, panel%approach)*case%height_unit
         if (.not. panel%has_contact) return
         load = max(0.0_dp, dot_product(weights, panel%load))*case%force_unit()
         call get_spot(self%states, dot_product(weights, panel%depth), radius, moment)
         radius = radius*case%length_unit
      end associate
   end subroutine read_at

   !> Approach, load and radius of contact of a cycle, in SI units.
   pure subroutine read_from_cycle(self, clock, approach, load, radius)
      type(timed_course_t), intent(inout) :: self
      !> Time from the begin [s].
      real(dp), intent(in) :: clock
      !> Receive the approach [m], the load [N] and the radius of contact [m].
      real(dp), intent(out) :: approach, load, radius
      real(dp) :: depth, moment

      associate (case => self%states%case)
         call read_cycle(self%cycle, self%states, clock, approach, depth, load)
         approach = approach*case%height_unit
         load = load*case%force_unit()
         radius = 0
         if (.not. depth > 0) return
         call get_spot(self%states, depth, radius, moment)
         radius = radius*case%length_unit
      end associate
   end subroutine read_from_cycle

   !> Steps of a list whose legs were made fewer, in units of the contact.
   pure subroutine read_steps(course, times, n_per_leg, steps)
      !> The course.
      type(timed_course_t), intent(inout) :: course
      !> Times of the list [s], and steps of each of its legs.
      real(dp), intent(in) :: times(:)
      integer, intent(in) :: n_per_leg
      !> Receives times from the begin, approaches, loads and radii; shape `(n_steps, n_timed_profiles)`.
      real(dp), intent(inout) :: steps(:, :)
      real(dp) :: time
      integer :: leg, k, step
      logical :: is_there

      associate (case => course%states%case)
         do leg = 1, size(times) - 1
            do k = merge(0, 1, leg == 1), n_per_leg
               step = 1 + (leg - 1)*n_per_leg + k
               time = times(leg) + (times(leg + 1) - times(leg))*k/n_per_leg
               call course%read_at(time, steps(step, p_approach), steps(step, p_load), steps(step, p_radius), is_there)
               steps(step, p_time) = time - course%begin
               steps(step, p_approach) = steps(step, p_approach)/case%height_unit
               steps(step, p_load) = steps(step, p_load)/case%force_unit()
               steps(step, p_radius) = steps(step, p_radius)/case%length_unit
            end do
         end do
      end associate
   end subroutine read_steps

   !> Make straight legs that follow each other fewer, where one differs from no end of theirs by more than a tolerance. Jumps and
   !> sines stay as they are.
   pure subroutine join_legs(legs, tolerance)
      !> The legs.
      type(timed_leg_t), allocatable, intent(inout) :: legs(:)
      !> Largest difference, in the unit of what the legs prescribe.
      real(dp), intent(in) :: tolerance
      type(timed_leg_t), allocatable :: joined(:)
      real(dp) :: lowest, highest, slope, span
      integer :: first, last, n

      allocate (joined(size(legs)))
      n = 0
      last = 0
      do while (last < size(legs))
         first = last + 1
         last = first
         n = n + 1
         joined(n) = legs(first)
         if (.not. is_straight(legs(first))) cycle
         ! slopes of all straight lines from the begin that pass every end within the tolerance
         lowest = -huge(1.0_dp)
         highest = huge(1.0_dp)
         call narrow(legs(first), lowest, highest)
         do while (last < size(legs))
            if (.not. is_straight(legs(last + 1))) exit
            span = legs(last + 1)%clock + legs(last + 1)%span - joined(n)%clock
            slope = (legs(last + 1)%end - joined(n)%begin)/span
            if (slope < lowest .or. slope > highest) exit
            last = last + 1
            call narrow(legs(last), lowest, highest)
            joined(n)%span = span
            joined(n)%end = legs(last)%end
         end do
      end do
      legs = joined(:n)

   contains

      !> Leave out the slopes that miss the end of a leg.
      pure subroutine narrow(leg, low, high)
         !> The leg.
         type(timed_leg_t), intent(in) :: leg
         !> The least and the largest slope.
         real(dp), intent(inout) :: low, high
         real(dp) :: time

         time = leg%clock + leg%span - joined(n)%clock
         low = max(low, (leg%end - tolerance - joined(n)%begin)/time)
         high = min(high, (leg%end + tolerance - joined(n)%begin)/time)
      end subroutine narrow

   end subroutine join_legs

   !> Is a leg straight, and no jump?
   pure logical function is_straight(leg)
      type(timed_leg_t), intent(in) :: leg

      is_straight = leg%span > 0 .and. .not. abs(leg%amplitude) > 0
   end function is_straight

end module adfric_round_timed_course

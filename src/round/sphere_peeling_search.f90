! SPDX-License-Identifier: GPL-3.0-or-later
!> What is looked for on the path from rest to sliding: its end, and states with a given angle, force or displacement.
!>
!> Where the contact shrinks as slip takes from adhesion, which it does in stable contact under a given load or approach, the first
!> state with a force or displacement and the largest force are found for certain (`adfric_round_shrinking_path`): the force may
!> have two peaks (JKR at a given separation with alpha near 1). Where it grows, one peak is looked for.
module adfric_round_sphere_peeling_search
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi
   use adfric_numerics_scalar_root, only: equation_t, find_root
   use adfric_round_sphere_contact, only: sphere_contact_t, theory_t, control_load, control_approach, branch_stable
   use adfric_interface_interaction, only: slip_energy_of_ratio
   use adfric_round_largest_force, only: find_largest_force
   use adfric_round_shrinking_path, only: find_first, first_displacement, first_force, slip_state_t
   use adfric_round_slip_annulus, only: angle_of_force, angle_of_slip, slip_of_angle, largest_slip_core
   use adfric_round_sphere_peeling_path, only: peeling_path_t, peeling_waypoint_t, get_waypoint, complete_waypoint, quantity_of, &
      & rate_of, &
      & core_along, force_along, end_none, end_capped, end_sliding, end_snap_off, end_no_adhesion
   use adfric_round_shrinking_sphere, only: new_shrinking, shrinking_sphere_t, state_of
   implicit none (type, external)
   private
   public :: find_end, find_state, find_largest, get_capped

   !> The last intimate contact less what is prescribed, as a function of X.
   type, extends(equation_t) :: last_contact_t
      !> Theory of adhesion; its X is set by `evaluate`.
      class(theory_t), allocatable :: theory
      !> What is prescribed: `control_load` or `control_approach`.
      integer :: control = control_load
      !> Load or approach that is prescribed, reduced.
      real(dp) :: prescribed = 0
   contains
      procedure :: evaluate
   end type last_contact_t

   !> Step of ln X for the slope of the last contact, and of ln g for that of a quantity.
   real(dp), parameter :: ratio_step = 1.0e-6_dp, fine_step = 1.0e-5_dp
   integer, parameter :: max_doublings = 60, n_marks = 100

contains

   !> The state with a value of a quantity, the first on the path; not found if there is none before sliding.
   pure subroutine find_state(self, quantity, value, waypoint, is_converged)
      !> The path; where its end is needed it receives that, too.
      type(peeling_path_t), intent(inout) :: self
      !> One of `..._along`: the quantity that is to have the value.
      integer, intent(in) :: quantity
      !> Value of the quantity, reduced, >= 0.
      real(dp), intent(in) :: value
      !> Receives the state; not found if the value is not reached before sliding.
      type(peeling_waypoint_t), intent(out) :: waypoint
      logical, intent(out) :: is_converged

      is_converged = .true.
      if (.not. self%start%is_found) then
         ! a mere touch carries no friction
         waypoint = self%start
         waypoint%is_found = self%start%contact%is_found .and. .not. value > 0
         is_converged = self%start%contact%is_converged
         return
      end if
      if (.not. value > 0 .or. .not. self%friction%interaction > 0) then
         call turn(self, self%start, quantity, value, waypoint)
         waypoint%slip_energy = min(self%compliance*waypoint%friction_radius*waypoint%core, self%friction%slip_energy_ratio)
         return
      end if
      if (quantity /= core_along .and. is_shrinking(self)) then
         call find_first_state(self, quantity, value, waypoint, is_converged)
         return
      end if
      if (self%ending == end_none) call find_end(self, is_converged)
      if (is_converged) call find_before_end(self, quantity, value, waypoint, is_converged)
   end subroutine find_state

   !> The first state with a force or a displacement on a path along which the contact shrinks.
   pure subroutine find_first_state(self, quantity, value, waypoint, is_converged)
      type(peeling_path_t), intent(in) :: self
      !> `force_along` or `displacement_along`.
      integer, intent(in) :: quantity
      !> Value of the quantity, reduced, > 0.
      real(dp), intent(in) :: value
      !> Receives the state; not found if the value is not reached before sliding.
      type(peeling_waypoint_t), intent(out) :: waypoint
      logical, intent(out) :: is_converged
      type(shrinking_sphere_t) :: retreat
      type(slip_state_t) :: state

      call new_shrinking(retreat, self)
      call find_first(retreat, merge(first_force, first_displacement, quantity == force_along), value, state_of(self%start), &
         & state, &
         & is_converged)
      if (.not. state%is_found) return
      call get_waypoint(self, state%slip_energy, self%start%contact, waypoint)
      waypoint%angle = state%angle
      waypoint%core = state%core
   end subroutine find_first_state

   !> `find_state` on the whole path, whose end is known.
   pure subroutine find_before_end(self, quantity, value, waypoint, is_converged)
      !> The path, whose end is known; it serves as the equation of searches.
      type(peeling_path_t), intent(inout) :: self
      !> One of `..._along`: the quantity that is to have the value.
      integer, intent(in) :: quantity
      !> Value of the quantity, reduced, > 0.
      real(dp), intent(in) :: value
      !> Receives the state; not found if the value is not reached before sliding.
      type(peeling_waypoint_t), intent(out) :: waypoint
      logical, intent(out) :: is_converged
      type(peeling_waypoint_t) :: peak

      is_converged = .true.
      if (value <= quantity_of(self, quantity, self%finish)) then
         peak = self%finish
      else
         call find_peak(self, quantity, peak, is_converged)
      end if
      if (.not. is_converged) return
      if (peak%is_found) then
         if (value <= quantity_of(self, quantity, peak)) then
            call find_crossing(self, quantity, value, peak, waypoint, is_converged)
            return
         end if
      end if
      if (self%ending == end_capped) call turn(self, self%finish, quantity, value, waypoint)
   end subroutine find_before_end

   !> The state of an unchanged contact with a value of a quantity; not found if that is beyond gamma = 0.
   pure subroutine turn(self, from, quantity, value, waypoint)
      type(peeling_path_t), intent(in) :: self
      type(peeling_waypoint_t), intent(in) :: from
      !> One of `..._along`: the quantity that is to have the value.
      integer, intent(in) :: quantity
      !> Value of the quantity, reduced, >= 0.
      real(dp), intent(in) :: value
      !> Receives the state; not found if the value is beyond gamma = 0.
      type(peeling_waypoint_t), intent(out) :: waypoint
      real(dp) :: largest

      call get_capped(from, half_pi, waypoint)
      largest = quantity_of(self, quantity, waypoint)
      waypoint%is_found = value <= largest
      if (.not. waypoint%is_found .or. .not. largest > 0) return
      select case (quantity)
      case (core_along)
         if (value < largest) waypoint%angle = angle_of_slip(value**2)
      case (force_along)
         waypoint%angle = angle_of_force(value/largest)
      case default
         waypoint%angle = asin(value/largest)
      end select
      waypoint%core = slip_of_angle(waypoint%angle)
   end subroutine turn

   !> The state of an unchanged contact with another angle.
   pure subroutine get_capped(from, angle, waypoint)
      type(peeling_waypoint_t), intent(in) :: from
      !> Angle arccos gamma of the new state [rad], 0 to pi/2.
      real(dp), intent(in) :: angle
      !> Receives the state with this angle and its slip core.
      type(peeling_waypoint_t), intent(out) :: waypoint

      waypoint = from
      waypoint%angle = angle
      waypoint%core = largest_slip_core
      if (angle < half_pi) waypoint%core = slip_of_angle(angle)
   end subroutine get_capped

   !> Find where the path ends, and how.
   pure subroutine find_end(self, is_converged)
      !> The path, which receives its end in `finish` and `ending`.
      type(peeling_path_t), intent(inout) :: self
      logical, intent(out) :: is_converged
      type(peeling_waypoint_t) :: last
      real(dp) :: cap, expected
      integer :: k

      is_converged = .true.
      self%ending = merge(end_capped, end_no_adhesion, self%friction%slip_energy_ratio < self%limit)
      cap = min(self%friction%slip_energy_ratio, self%limit)
      ! g of gamma = 0 with the area of rest, which is enough unless the area grows
      expected = largest_slip_core*self%compliance*self%start%friction_radius
      do k = 1, max_doublings
         call get_waypoint(self, min(cap, expected), self%start%contact, last)
         if (.not. last%is_found) exit
         if (last%core >= largest_slip_core .or. last%slip_energy >= cap) exit
         expected = 2*expected
      end do
      if (.not. is_shrinking(self)) then
         call stepping(self, last)
      else if (.not. last%is_found) then
         call find_snap_off(self, last, is_converged)
      end if
      self%finish = last
      if (last%core >= largest_slip_core .and. is_converged) then
         self%ending = end_sliding
         call find_crossing(self, core_along, sqrt(largest_slip_core), last, self%finish, is_converged)
         call get_capped(self%finish, half_pi, last)
         self%finish = last
      end if
   end subroutine find_end

   !> Does the area shrink all the path, so that gamma falls all the path? Not on the other branch, and not with a radius
   !> held, where the reach of adhesion widens.
   pure logical function is_shrinking(self)
      type(peeling_path_t), intent(in) :: self

      is_shrinking = self%branch == branch_stable .and. (self%control == control_load .or. self%control == control_approach)
   end function is_shrinking

   !> Where the area may grow: go step by step to where contact is lost or gamma falls below 0 for the first time.
   pure subroutine stepping(self, last)
      !> The path; its `ending` is set where contact is lost.
      type(peeling_path_t), intent(inout) :: self
      !> In: a state at or beyond the end. Out: the last state with contact, or the first one with gamma < 0.
      type(peeling_waypoint_t), intent(inout) :: last
      type(peeling_waypoint_t) :: next, known
      real(dp) :: whole, low, high
      integer :: k

      whole = sqrt(last%slip_energy)
      known = self%start
      do k = 1, n_marks
         high = whole*k/n_marks
         call get_waypoint(self, high**2, self%start%contact, next)
         if (.not. next%is_found) exit
         known = next
         if (known%core >= largest_slip_core) exit
      end do
      ! nothing on the path: the state at its end stands, which the last step may miss by round-off
      if (next%is_found .and. known%core < largest_slip_core .and. last%is_found) return
      if (.not. next%is_found) then
         self%ending = end_snap_off
         low = sqrt(known%slip_energy)
         do k = 1, digits(low)
            call get_waypoint(self, (low + (high - low)/2)**2, self%start%contact, next)
            if (next%is_found) known = next
            if (next%is_found) low = low + (high - low)/2
            if (.not. next%is_found) high = low + (high - low)/2
         end do
      end if
      last = known
   end subroutine stepping

   !> The last contact on the way to a state without contact.
   pure subroutine find_snap_off(self, last, is_converged)
      !> The path, whose `ending` is set.
      type(peeling_path_t), intent(inout) :: self
      !> In: a state without contact. Out: the last one with contact.
      type(peeling_waypoint_t), intent(inout) :: last
      logical, intent(out) :: is_converged
      type(last_contact_t) :: equation
      real(dp) :: ratio

      self%ending = end_snap_off
      allocate (equation%theory, source=self%theory)
      equation%control = self%control
      equation%prescribed = self%prescribed
      ratio = last%ratio + (1 - last%ratio)/2
      call find_root(equation, last%ratio, 1.0_dp, .false., ratio, is_converged)
      equation%theory%ratio = ratio
      call get_last_contact(equation%theory, self%control, last%contact)
      last%ratio = ratio
      last%slip_energy = slip_energy_of_ratio(ratio, self%friction%interaction)
      last%is_found = .true.
      call complete_waypoint(self, last)
   end subroutine find_snap_off

   !> The last intimate contact of a theory: pull-off, or, where the surfaces part without a jump, the radius 0.
   pure subroutine get_last_contact(theory, control, contact)
      !> Theory of adhesion, for the X that its `ratio` holds.
      class(theory_t), intent(in) :: theory
      !> One of `control_...`: what is prescribed.
      integer, intent(in) :: control
      type(sphere_contact_t), intent(out) :: contact

      call theory%pull_off(control, contact)
      if (.not. contact%radius > 0) call theory%of_radius(0.0_dp, contact)
   end subroutine get_last_contact

   !> The last contact less what is prescribed.
   pure subroutine evaluate(self, x, value, slope)
      !> The equation, with its theory, control and the value that is prescribed.
      class(last_contact_t), intent(in) :: self
      !> X, the share of adhesion that remains [-], > 0.
      real(dp), intent(in) :: x
      !> Load or approach of the last contact less the one that is prescribed, reduced.
      real(dp), intent(out) :: value
      !> Derivative of the value by X, from a difference.
      real(dp), intent(out) :: slope
      class(theory_t), allocatable :: theory
      type(sphere_contact_t) :: here, near

      allocate (theory, source=self%theory)
      theory%ratio = x
      call get_last_contact(theory, self%control, here)
      theory%ratio = x*(1 - ratio_step)
      call get_last_contact(theory, self%control, near)
      if (self%control == control_approach) then
         value = here%approach - self%prescribed
         slope = (here%approach - near%approach)/(x*ratio_step)
      else
         value = here%load - self%prescribed
         slope = (here%load - near%load)/(x*ratio_step)
      end if
   end subroutine evaluate

   !> The state of the largest force before the contact is constant; not found if the end of the path bears more.
   pure subroutine find_largest(self, onset, waypoint, is_converged)
      !> The path, whose end is known.
      type(peeling_path_t), intent(inout) :: self
      type(peeling_waypoint_t), intent(in) :: onset
      type(peeling_waypoint_t), intent(out) :: waypoint
      logical, intent(out) :: is_converged
      type(shrinking_sphere_t) :: retreat
      type(slip_state_t) :: state
      logical :: is_larger

      is_converged = .true.
      if (is_shrinking(self)) then
         call new_shrinking(retreat, self)
         call find_largest_force(retreat, state_of(self%start), state_of(self%finish), quantity_of(self, force_along, onset), &
            & state, &
            & is_larger)
         if (is_larger) call get_waypoint(self, state%slip_energy, self%start%contact, waypoint)
      else
         call find_peak(self, force_along, waypoint, is_converged)
      end if
   end subroutine find_largest

   !> The largest value of a quantity before the end of the path; not found if it still rises there.
   pure subroutine find_peak(self, quantity, waypoint, is_converged)
      !> The path, whose end is known; it serves as the equation of the search.
      type(peeling_path_t), intent(inout) :: self
      !> One of `..._along`: the quantity whose largest value is wanted.
      integer, intent(in) :: quantity
      !> Receives the state of the largest value; not found if the quantity still rises at the end.
      type(peeling_waypoint_t), intent(out) :: waypoint
      logical, intent(out) :: is_converged
      real(dp) :: z, high

      is_converged = .true.
      if (.not. self%friction%interaction > 0) return
      if (rate_of(self, quantity, self%finish, fine_step, .false.) >= 0) return
      self%quantity = quantity
      self%is_rate = .true.
      high = sqrt(self%finish%slip_energy)
      z = high/2
      call find_root(self, 0.0_dp, high, .false., z, is_converged)
      call get_waypoint(self, z**2, self%start%contact, waypoint)
   end subroutine find_peak

   !> The state with a value of a quantity, 0 < value <= that of a state which lies after it.
   pure subroutine find_crossing(self, quantity, value, last, waypoint, is_converged)
      !> The path, which serves as the equation of the search.
      type(peeling_path_t), intent(inout) :: self
      !> One of `..._along`: the quantity that is to have the value.
      integer, intent(in) :: quantity
      !> Value of the quantity, reduced, > 0, at most that of the state `last`.
      real(dp), intent(in) :: value
      !> State on the way that lies after the one with the value, or is that one.
      type(peeling_waypoint_t), intent(in) :: last
      !> Receives the state with the value.
      type(peeling_waypoint_t), intent(inout) :: waypoint
      logical, intent(out) :: is_converged
      real(dp) :: z, high

      self%quantity = quantity
      self%given = value
      self%is_rate = .false.
      high = sqrt(last%slip_energy)
      z = high*value/quantity_of(self, quantity, last)
      call find_root(self, 0.0_dp, high*(1 + 4*epsilon(high)), .true., z, is_converged)
      call get_waypoint(self, z**2, self%start%contact, waypoint)
   end subroutine find_crossing

end module adfric_round_sphere_peeling_search

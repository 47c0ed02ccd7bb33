! SPDX-License-Identifier: GPL-3.0-or-later
!> A sphere whose lateral spring is driven: the state at a displacement of the base that has grown from rest, reduced (J 2.11).
!>
!> It is the first place of the way where h = D + T/k reaches the displacement, which is the running maximum. Beyond the largest h it
!> is a sphere that slides, or in stick-slip the same places again and again, from the force of sliding up to the jump.
!>
!> The polynomials of the way know h to the round-off of its largest value. That says which place is the first one; of a small h it leaves
!> few digits, so the place is found again with the states themselves, between places of which the polynomials are certain.
module adfric_sphere_spring_drive
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_material_pulled_contact, only: extension_at, first_reach, pulled_curve_t, spot_t
   use adfric_material_stick_slip, only: find_stick_slip, stick_slip_t
   use adfric_numerics_secant_root, only: find_rising_root, rising_equation_t
   use adfric_sphere_contact, only: theory_t
   use adfric_sphere_peeling, only: describe, friction_state_t, slide
   use adfric_sphere_peeling_path, only: displacement_along, end_none, end_no_adhesion, end_snap_off, force_along, friction_t, &
      & new_path, path_t, quantity_of, waypoint_t
   use adfric_sphere_peeling_search, only: find_end
   use adfric_sphere_pulled_sphere, only: get_waypoint_of, place_of, take_sphere_curve
   implicit none (type, external)
   private
   public :: spring_drive_t, new_spring_drive, find_driven_state

   !> How far the place of the polynomials is looked for at first, relative, how much farther each time, and how often.
   real(dp), parameter :: first_width = 1.0e-13_dp, wider = 16.0_dp
   integer, parameter :: most_widenings = 60
   !> What the polynomials know of h, relative to its largest value.
   real(dp), parameter :: certain = 1.0e-11_dp
   !> At a small place h is about the second to fourth power of it: a guess of the slope of its logarithm.
   real(dp), parameter :: usual_power = 2.0_dp

   !> The way of a sphere, and what happens on its spring.
   type :: spring_drive_t
      !> Has all been found to round-off?
      logical :: is_converged = .true.
      !> Stiffness of the spring.
      real(dp) :: stiffness = 1
      !> The way from rest to sliding, as a path and as polynomials.
      type(path_t) :: path
      !> The polynomials.
      type(pulled_curve_t) :: curve
      !> The state of sliding.
      type(friction_state_t) :: sliding
      !> The jump.
      type(stick_slip_t) :: jump
   end type spring_drive_t

   !> h over the value that it has to have, less 1, as a function of the logarithm of the place in a piece.
   type, extends(rising_equation_t) :: driven_place_t
      !> The way.
      type(path_t) :: path
      !> The piece.
      integer :: piece = 1
      !> Stiffness of the spring, and the value.
      real(dp) :: stiffness = 1, extension = 1
   contains
      procedure :: evaluate => excess_extension
   end type driven_place_t

contains

   !> The way of a sphere on a spring.
   pure subroutine new_spring_drive(self, theory, friction, control, held, branch, stiffness)
      !> Receives the way; without contact at rest its path has no start.
      type(spring_drive_t), intent(out) :: self
      !> Theory of adhesion; its own X is not used.
      class(theory_t), intent(in) :: theory
      !> Parameters of the law of friction, reduced.
      type(friction_t), intent(in) :: friction
      !> One of `control_...`: what is held.
      integer, intent(in) :: control
      !> Value of the load, approach or radius that is held, reduced.
      real(dp), intent(in) :: held
      !> One of `branch_...`: which state is meant where there are two.
      integer, intent(in) :: branch
      !> Stiffness of the spring, reduced, > 0.
      real(dp), intent(in) :: stiffness
      real(dp) :: force

      self%stiffness = stiffness
      call new_path(self%path, theory, friction, control, held, branch)
      if (.not. self%path%start%is_found) return
      call find_end(self%path, self%is_converged)
      if (.not. self%is_converged) return
      call slide(self%path, self%sliding)
      force = -1
      if (self%sliding%is_found .and. self%path%ending /= end_snap_off) force = self%sliding%force
      call take_sphere_curve(self%path, force, self%curve)
      self%is_converged = self%curve%is_converged
      call find_stick_slip(self%curve, stiffness, self%jump)
   end subroutine new_spring_drive

   !> The state at a displacement of the base.
   pure subroutine find_driven_state(self, base, state)
      !> The way.
      type(spring_drive_t), intent(in) :: self
      !> Displacement of the base from rest, reduced, >= 0.
      real(dp), intent(in) :: base
      !> Receives the state, with the displacement from rest; not found where contact is lost.
      type(friction_state_t), intent(out) :: state
      type(waypoint_t) :: waypoint
      type(spot_t) :: spot
      real(dp) :: place
      logical :: is_reached

      state%is_converged = self%is_converged
      state%is_found = .false.
      if (.not. (self%path%start%is_found .and. self%is_converged) .or. self%path%ending == end_none) return
      place = base
      if (self%jump%slides) then
         associate (jump => self%jump)
            if (base > jump%base_displacement) place = jump%base_displacement - jump%period &
               & + modulo(base - jump%base_displacement, jump%period)
         end associate
      end if
      spot = spot_t(1, -1.0_dp)
      is_reached = .true.
      ! the largest h itself is reached
      if (place > 0) call first_reach(self%curve, 1.0_dp, 1/self%stiffness, place*(1 - 8*epsilon(place)), spot_t(1, -1.0_dp), &
         & spot, is_reached)
      if (is_reached) then
         call settle(self, place, spot, waypoint)
         call describe(self%path, waypoint, state)
      else
         if (self%jump%is_lost .or. .not. self%curve%slides .or. self%path%ending == end_no_adhesion) return
         state = self%sliding
         ! a force of sliding above that of the end of the way is not reached at once
         state%force = min(state%force, self%stiffness*(base - self%curve%last_displacement))
         state%slip = not_a_number()
      end if
      state%displacement = base - state%force/self%stiffness
   end subroutine find_driven_state

   !> The state with a given h, next to a place that the polynomials have found.
   pure subroutine settle(self, extension, spot, waypoint)
      !> The way.
      type(spring_drive_t), intent(in) :: self
      !> h.
      real(dp), intent(in) :: extension
      !> The place of the polynomials.
      type(spot_t), intent(in) :: spot
      !> Receives the state.
      type(waypoint_t), intent(out) :: waypoint
      type(driven_place_t) :: equation
      real(dp) :: place, x, ends(2)
      logical :: is_between, is_converged

      associate (panel => self%curve%panels(spot%panel))
         place = place_of(panel, spot%x)
         if (extension > 0) then
            ! next to rest the polynomials do not tell one place from another
            place = max(place, epsilon(place)*panel%high)
            equation%path = self%path
            equation%piece = panel%piece
            equation%stiffness = self%stiffness
            equation%extension = extension
            x = log(place)
            call find_bracket(self, equation, spot%panel, x, ends, is_between)
            if (is_between) then
               call find_rising_root(equation, ends(1), ends(2), usual_power, 2*epsilon(x), x, is_converged)
               if (is_converged) place = min(exp(x), 1.0_dp)
            end if
         end if
         call get_waypoint_of(self%path, panel%piece, place, waypoint)
      end associate
   end subroutine settle

   !> Places around one of the polynomials, before and behind the one of a given h.
   pure subroutine find_bracket(self, equation, number, x, ends, is_between)
      !> The way.
      type(spring_drive_t), intent(in) :: self
      !> The equation.
      class(driven_place_t), intent(in) :: equation
      !> Number of the panel.
      integer, intent(in) :: number
      !> Logarithm of the place.
      real(dp), intent(in) :: x
      !> Receive logarithms of the places.
      real(dp), intent(out) :: ends(2)
      !> Are there such places, of which the polynomials are certain?
      logical, intent(out) :: is_between
      real(dp) :: value, width, margin, place, within
      integer :: k

      ends = x
      is_between = .false.
      width = first_width
      do k = 1, most_widenings
         ends(1) = x - width
         call equation%evaluate(ends(1), value)
         if (value < 0) exit
         width = wider*width
      end do
      if (.not. value < 0) return
      associate (panel => self%curve%panels(number))
         margin = certain*sum(abs(panel%displacement) + abs(panel%force)/self%stiffness)
         width = first_width
         do k = 1, most_widenings
            place = min(exp(x + width), panel%high)
            ends(2) = log(place)
            call equation%evaluate(ends(2), value)
            is_between = value > 0
            if (is_between .or. .not. place < panel%high) return
            ! beyond what the polynomials leave open there would be another place
            within = 2*(place - panel%low)/(panel%high - panel%low) - 1
            if (extension_at(self%curve, 1.0_dp, 1/self%stiffness, spot_t(number, within)) > equation%extension + margin) return
            width = wider*width
         end do
      end associate
   end subroutine find_bracket

   !> See `driven_place_t`.
   pure subroutine excess_extension(self, x, value)
      !> The equation.
      class(driven_place_t), intent(in) :: self
      !> Logarithm of the place.
      real(dp), intent(in) :: x
      !> Receives h over its value, less 1.
      real(dp), intent(out) :: value
      type(waypoint_t) :: waypoint

      call get_waypoint_of(self%path, self%piece, exp(x), waypoint)
      value = quantity_of(self%path, displacement_along, waypoint) &
         & + quantity_of(self%path, force_along, waypoint)/self%stiffness
      value = value/self%extension - 1
   end subroutine excess_extension

end module adfric_sphere_spring_drive

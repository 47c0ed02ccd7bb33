! SPDX-License-Identifier: GPL-3.0-or-later
!> A sphere whose lateral spring is driven: the state at a displacement of the base that has grown from rest, reduced (J 2.11).
!>
!> It is the first position of the path where h = D + T/k reaches the displacement, which is the running maximum. Beyond the largest
!> h it is a sphere that slides, or in stick-slip the same positions again and again, from the force of sliding up to the jump.
module adfric_round_sphere_spring_drive
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_round_driven_contact, only: find_driven_position
   use adfric_round_pulled_contact, only: pulled_curve_t
   use adfric_round_stick_slip, only: find_stick_slip, stick_slip_t
   use adfric_round_sphere_contact, only: theory_t
   use adfric_round_sphere_peeling, only: describe, friction_state_t, slide
   use adfric_round_sphere_peeling_path, only: end_none, end_no_adhesion, end_snap_off, peeling_friction_t, new_path, &
      & peeling_path_t, peeling_waypoint_t
   use adfric_round_sphere_peeling_search, only: find_end
   use adfric_round_pulled_sphere, only: get_waypoint_of, pulled_sphere_t, take_sphere_curve
   implicit none (type, external)
   private
   public :: sphere_spring_drive_t, new_spring_drive, find_driven_state

   !> The path of a sphere, and what happens on its spring.
   type :: sphere_spring_drive_t
      !> Is there a contact at rest, and has all been found to round-off?
      logical :: is_found = .false., is_converged = .true.
      !> Stiffness of the spring.
      real(dp) :: stiffness = 1
      !> The path from rest to sliding, as a contact that is pulled, and as polynomials.
      type(pulled_sphere_t) :: contact
      !> The polynomials.
      type(pulled_curve_t) :: curve
      !> The state of sliding.
      type(friction_state_t) :: sliding
      !> The jump.
      type(stick_slip_t) :: jump
   end type sphere_spring_drive_t

contains

   !> The path of a sphere on a spring.
   pure subroutine new_spring_drive(self, theory, friction, control, prescribed, branch, stiffness)
      type(sphere_spring_drive_t), intent(out) :: self
      !> Theory of adhesion; its own X is not used.
      class(theory_t), intent(in) :: theory
      type(peeling_friction_t), intent(in) :: friction
      !> One of `control_...`: what is prescribed.
      integer, intent(in) :: control
      !> Value of the load, approach or radius that is prescribed, reduced.
      real(dp), intent(in) :: prescribed
      !> One of `branch_...`: which state is meant where there are two.
      integer, intent(in) :: branch
      !> Stiffness of the spring, reduced, > 0.
      real(dp), intent(in) :: stiffness
      type(peeling_path_t) :: path
      real(dp) :: force

      self%stiffness = stiffness
      call new_path(path, theory, friction, control, prescribed, branch)
      self%is_found = path%start%is_found
      if (.not. self%is_found) return
      call find_end(path, self%is_converged)
      if (.not. self%is_converged) return
      call slide(path, self%sliding)
      force = -1
      if (self%sliding%is_found .and. path%ending /= end_snap_off) force = self%sliding%force
      call take_sphere_curve(path, force, self%curve, self%contact)
      self%is_converged = self%curve%is_converged
      call find_stick_slip(self%curve, stiffness, self%jump)
   end subroutine new_spring_drive

   !> The state at a displacement of the base.
   pure subroutine find_driven_state(self, base, state)
      type(sphere_spring_drive_t), intent(in) :: self
      !> Displacement of the base from rest, reduced, >= 0.
      real(dp), intent(in) :: base
      !> Receives the state, with the displacement from rest; not found where contact is lost.
      type(friction_state_t), intent(out) :: state
      type(peeling_waypoint_t) :: waypoint
      real(dp) :: position
      integer :: piece
      logical :: is_reached

      state%is_converged = self%is_converged
      state%is_found = .false.
      if (.not. (self%is_found .and. self%is_converged) .or. self%contact%path%ending == end_none) return
      call find_driven_position(self%contact, self%curve, self%jump, self%stiffness, base, piece, position, is_reached)
      if (is_reached) then
         call get_waypoint_of(self%contact%path, piece, position, waypoint)
         call describe(self%contact%path, waypoint, state)
      else
         if (self%jump%is_lost .or. .not. self%curve%slides .or. self%contact%path%ending == end_no_adhesion) return
         state = self%sliding
         ! a force of sliding above that of the end of the path is not reached at once
         state%force = min(state%force, self%stiffness*(base - self%curve%last_displacement))
         state%slip = not_a_number()
      end if
      state%displacement = base - state%force/self%stiffness
   end subroutine find_driven_state

end module adfric_round_sphere_spring_drive

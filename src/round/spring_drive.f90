! SPDX-License-Identifier: GPL-3.0-or-later
!> An indenter whose lateral spring is driven: the state at a displacement of the base that has grown from rest, reduced (J 2.11).
!>
!> It is the first position of the path where h = u + T/k reaches the displacement, which is the running maximum. Beyond the largest
!> h it is an indenter that slides, or in stick-slip the same positions again and again, from the force of sliding up to the jump.
module adfric_round_spring_drive
   use adfric_base_kinds, only: dp
   use adfric_round_interaction_events, only: slide
   use adfric_round_interaction_path, only: end_capped, end_sliding, interaction_path_t, waypoint_t
   use adfric_round_interaction_search, only: find_end
   use adfric_round_pulled_indenter, only: get_waypoint_of, pulled_indenter_t, take_indenter_curve
   use adfric_round_driven_contact, only: find_driven_position
   use adfric_round_pulled_contact, only: pulled_curve_t
   use adfric_round_shrinking_path, only: force_of
   use adfric_round_stick_slip, only: find_stick_slip, stick_slip_t
   implicit none (type, external)
   private
   public :: spring_drive_t, driven_state_t, new_spring_drive, find_driven_state

   !> The path of an indenter, and what happens on its spring.
   type :: spring_drive_t
      !> Is there a contact at rest, and has all been found to round-off?
      logical :: is_found = .false., is_converged = .true.
      !> Stiffness of the spring.
      real(dp) :: stiffness = 1
      !> The path from rest to sliding, as a contact that is pulled, and as polynomials.
      type(pulled_indenter_t) :: contact
      !> The polynomials.
      type(pulled_curve_t) :: curve
      !> The state of sliding; not found where the path does not end in it.
      type(waypoint_t) :: sliding
      !> The jump.
      type(stick_slip_t) :: jump
   end type spring_drive_t

   !> A state on the spring.
   type :: driven_state_t
      !> Is there one, and does it slide?
      logical :: is_found = .false., is_sliding = .false.
      !> The state.
      type(waypoint_t) :: waypoint
      !> T, and the displacement of the contact.
      real(dp) :: force = 0, displacement = 0
   end type driven_state_t

contains

   !> The path of an indenter on a spring.
   pure subroutine new_spring_drive(self, start, stiffness)
      type(spring_drive_t), intent(out) :: self
      class(interaction_path_t), intent(in) :: start
      !> Stiffness of the spring, reduced, > 0.
      real(dp), intent(in) :: stiffness
      class(interaction_path_t), allocatable :: path
      real(dp) :: force
      logical :: slides

      self%stiffness = stiffness
      self%is_found = start%start%is_found
      if (.not. self%is_found) return
      allocate (path, source=start)
      call find_end(path, self%is_converged)
      if (.not. self%is_converged) return
      slides = .false.
      if (path%ending == end_sliding .or. path%ending == end_capped) call slide(path, self%sliding, slides)
      self%sliding%is_found = slides
      force = -1
      if (slides) force = force_of(path, self%sliding)
      call take_indenter_curve(path, force, self%curve, self%contact)
      self%is_converged = self%curve%is_converged
      call find_stick_slip(self%curve, stiffness, self%jump)
   end subroutine new_spring_drive

   !> The state at a displacement of the base.
   pure subroutine find_driven_state(self, base, state)
      type(spring_drive_t), intent(in) :: self
      !> Displacement of the base from rest, reduced, >= 0.
      real(dp), intent(in) :: base
      !> Receives the state; not found where contact is lost, or jumps to a smaller one.
      type(driven_state_t), intent(out) :: state
      real(dp) :: position
      integer :: piece
      logical :: is_reached

      if (.not. (self%is_found .and. self%is_converged)) return
      call find_driven_position(self%contact, self%curve, self%jump, self%stiffness, base, piece, position, is_reached)
      if (is_reached) then
         call get_waypoint_of(self%contact, piece, position, state%waypoint)
         state%force = force_of(self%contact%path, state%waypoint)
      else
         if (self%jump%is_lost .or. .not. self%curve%slides) return
         state%waypoint = self%sliding
         state%is_sliding = .true.
         ! a force of sliding above that of the end of the path is not reached at once
         state%force = min(self%curve%force_after, self%stiffness*(base - self%curve%last_displacement))
      end if
      state%is_found = .true.
      state%displacement = base - state%force/self%stiffness
   end subroutine find_driven_state

end module adfric_round_spring_drive

! SPDX-License-Identifier: GPL-3.0-or-later
!> The state of a contact with Coulomb's friction: a stack of segments of the load from 0 to P, each of one share f of the friction,
!>
!>     T = mu sum f dL,     u = mu m sum f dg + the position where contact began
!>
!> |f| <= 1, dg the part of the approach that belongs to dL. Forces are in units of mu, displacements in units of mu m.
module adfric_interface_slip_stack
   use adfric_base_kinds, only: dp
   use adfric_interface_normal_contact, only: by_force, coordinate, find_position, normal_contact_t, normal_state_t
   implicit none (type, external)
   private
   public :: slip_stack_t, step_t

   !> Number of segments for which there is space at first.
   integer, parameter :: first_size = 16

   !> A segment of the load.
   type :: segment_t
      !> Its outer end.
      type(normal_state_t) :: outer
      !> f, between -1 and 1.
      real(dp) :: f = 0
      !> T/mu, and u/(mu m) less where contact began, at the outer end.
      real(dp) :: sums(2) = 0
   end type segment_t

   !> A contact with its segments.
   type :: slip_stack_t
      !> The normal state; the approach is below 0 out of contact.
      type(normal_state_t) :: normal
      !> u/(mu m) where contact began.
      real(dp) :: zero = 0
      !> What friction has taken, over mu^2 m; and the round-off of it.
      real(dp) :: loss = 0, loss_error = 0
      !> Number of the segments.
      integer :: n = 0
      !> The segments, from the inside out.
      type(segment_t), allocatable :: segments(:)
      !> Have all normal states been found to round-off?
      logical :: is_converged = .true.
   contains
      procedure :: clear
      procedure :: bottom
      procedure :: cut
      procedure :: push
   end type slip_stack_t

   !> A straight step: coordinate 1 is the load with the force, 2 the approach with the displacement less its zero.
   type :: step_t
      !> `by_force` or `by_displacement`, which is also the coordinate.
      integer :: kind = by_force
      !> Normal and tangential coordinate at its beginning and its end.
      real(dp) :: normal(2) = 0, tangential(2) = 0
   end type step_t

contains

   !> No segments.
   pure subroutine clear(self)
      class(slip_stack_t), intent(inout) :: self

      self%n = 0
      if (.not. allocated(self%segments)) allocate (self%segments(first_size))
   end subroutine clear

   !> Load or approach at the inner end of the outermost segment.
   pure real(dp) function bottom(self, kind)
      class(slip_stack_t), intent(in) :: self
      !> `by_force` or `by_displacement`.
      integer, intent(in) :: kind

      bottom = 0
      if (self%n > 1) bottom = coordinate(self%segments(self%n - 1)%outer, kind)
   end function bottom

   !> Cut the outermost segment.
   pure subroutine cut(self, contact, kind, position, known)
      class(slip_stack_t), intent(inout) :: self
      class(normal_contact_t), intent(in) :: contact
      !> `by_force` or `by_displacement`.
      integer, intent(in) :: kind
      !> Load or approach of the new end.
      real(dp), intent(in) :: position
      !> A state that may be that of the position.
      type(normal_state_t), intent(in) :: known
      type(normal_state_t) :: end_state
      real(dp) :: f

      end_state = known
      if (abs(coordinate(known, kind) - position) > 0) call find_position(contact, kind, position, end_state, self%is_converged)
      f = self%segments(self%n)%f
      self%n = self%n - 1
      self%normal = end_state
      call self%push(end_state, f)
   end subroutine cut

   !> Add a segment.
   pure subroutine push(self, outer, f)
      class(slip_stack_t), intent(inout) :: self
      type(normal_state_t), intent(in) :: outer
      real(dp), intent(in) :: f
      type(segment_t), allocatable :: more(:)
      type(segment_t) :: last

      if (self%n > 0) then
         last = self%segments(self%n)
         if (.not. outer%load > last%outer%load) return
         ! the same segment goes on
         if (.not. abs(last%f - f) > 0) self%n = self%n - 1
      else if (.not. outer%load > 0) then
         return
      end if
      if (self%n == size(self%segments)) then
         allocate (more(2*self%n))
         more(:self%n) = self%segments
         call move_alloc(more, self%segments)
      end if
      self%n = self%n + 1
      self%segments(self%n)%f = f
      self%segments(self%n)%outer = outer
      self%segments(self%n)%sums = last%sums + f*[outer%load - last%outer%load, outer%approach - last%outer%approach]
   end subroutine push

end module adfric_interface_slip_stack

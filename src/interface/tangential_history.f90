! SPDX-License-Identifier: GPL-3.0-or-later
!> Coulomb's friction of a contact through any history of normal and tangential loading (R. D. Mindlin, H. Deresiewicz, J. Appl. Mech. 20,
!> 1953, 327; J. Jaeger, Arch. Appl. Mech. 63, 1993, 402), for every contact whose tangential compliance is m times the normal one.
!>
!> Each increment dL of the load lies in a ring of the contact, and what it bears of the tangential force is mu f dL with |f| <= 1. So a
!> state is a stack of segments of the load from 0 to P, each of one f (`adfric_interface_slip_stack`). In units of mu and mu m, a step
!> (dP, dT) adds a segment f = dT/dP where P grows and |dT| <= dP: no slip. Else slip with the sign of dT - f dP, f of the outermost
!> segment, eats inwards from the edge (`adfric_interface_slip_zone`). The same holds for steps that are straight in approach and
!> displacement, with g in place of L. Nothing is followed in small steps.
module adfric_interface_tangential_history
   use adfric_base_kinds, only: dp
   use adfric_interface_normal_contact, only: by_displacement, by_force, coordinate, friction_holds, normal_contact_t, &
      & normal_state_t, round_off
   use adfric_interface_slip_stack, only: slip_stack_t, step_t
   use adfric_interface_slip_zone, only: slide, slip
   implicit none (type, external)
   private
   public :: history_t, start_history

   !> A contact with its history.
   type, extends(slip_stack_t) :: history_t
      !> T/mu and u/(mu m).
      real(dp) :: force = 0, displacement = 0
   contains
      procedure :: advance
      procedure :: stick_radius
   end type history_t

contains

   !> A contact that has not touched yet.
   pure subroutine start_history(self)
      type(history_t), intent(out) :: self

      call self%clear()
   end subroutine start_history

   !> A straight step to another normal state, under a force or to a displacement.
   pure subroutine advance(self, contact, next, kind, given, is_possible)
      class(history_t), intent(inout) :: self
      class(normal_contact_t), intent(in) :: contact
      !> The normal state at the end; out of contact its load and work are 0, and its approach at most 0.
      type(normal_state_t), intent(in) :: next
      !> `by_force` or `by_displacement`: along which coordinates the step is straight.
      integer, intent(in) :: kind
      !> T/mu or u/(mu m) at the end.
      real(dp), intent(in) :: given
      !> Is there such a state? A force above that of sliding has none, and leaves the history as it is.
      logical, intent(out) :: is_possible
      real(dp) :: target

      is_possible = kind == by_displacement .or. friction_holds(given, next%load)
      if (.not. is_possible) return
      target = given
      if (kind == by_force) target = sign(min(abs(given), next%load), given)
      call begin_contact(self, next, kind, target)
      if (kind == by_displacement .and. self%n > 0 .and. next%approach < 0) then
         call end_contact(self, contact, next, target)
      else if (next%approach > 0 .or. self%n > 0) then
         call follow(self, contact, next, straight_step(self, next, kind, target))
      end if
      self%normal = next
      if (.not. next%approach > 0) self%n = 0
      call set_sums(self, kind, target)
      self%loss_error = self%loss_error + round_off*self%loss
   end subroutine advance

   !> A contact that is none: where it begins is the zero of its displacement, at the beginning of the step or within it.
   pure subroutine begin_contact(self, next, kind, target)
      type(history_t), intent(inout) :: self
      !> The normal state at the end of the step.
      type(normal_state_t), intent(in) :: next
      !> `by_force` or `by_displacement`.
      integer, intent(in) :: kind
      !> T/mu or u/(mu m) at the end.
      real(dp), intent(in) :: target
      real(dp) :: share

      if (kind == by_displacement .and. next%approach > 0 .and. self%normal%approach < 0) then
         share = -self%normal%approach/(next%approach - self%normal%approach)
         self%zero = self%displacement + share*(target - self%displacement)
         self%displacement = self%zero
         self%normal = normal_state_t()
      else if (self%n == 0) then
         self%zero = self%displacement
         self%normal%approach = max(self%normal%approach, 0.0_dp)
      end if
   end subroutine begin_contact

   !> Go along a step within which contact ends, up to there.
   pure subroutine end_contact(self, contact, next, target)
      type(history_t), intent(inout) :: self
      class(normal_contact_t), intent(in) :: contact
      !> The normal state at the end of the step, out of contact.
      type(normal_state_t), intent(in) :: next
      !> u/(mu m) at the end.
      real(dp), intent(in) :: target
      type(normal_state_t) :: touching
      real(dp) :: share

      share = self%normal%approach/(self%normal%approach - next%approach)
      call follow(self, contact, touching, straight_step(self, touching, by_displacement, self%displacement &
         & + share*(target - self%displacement)))
   end subroutine end_contact

   !> Force and displacement at the end of a step, of which one is given.
   pure subroutine set_sums(self, kind, target)
      type(history_t), intent(inout) :: self
      !> `by_force` or `by_displacement`.
      integer, intent(in) :: kind
      !> T/mu or u/(mu m).
      real(dp), intent(in) :: target

      if (kind == by_displacement) then
         self%displacement = target
         self%force = 0
         if (self%n > 0) self%force = self%segments(self%n)%sums(by_force)
      else
         self%force = target
         self%displacement = self%zero
         if (self%n > 0) self%displacement = self%zero + self%segments(self%n)%sums(by_displacement)
      end if
   end subroutine set_sums

   !> The coordinates of a step.
   pure type(step_t) function straight_step(self, next, kind, target) result(step)
      type(history_t), intent(in) :: self
      type(normal_state_t), intent(in) :: next
      !> `by_force` or `by_displacement`.
      integer, intent(in) :: kind
      !> T/mu or u/(mu m) at the end.
      real(dp), intent(in) :: target

      step%kind = kind
      step%normal = [coordinate(self%normal, kind), coordinate(next, kind)]
      if (kind == by_force) then
         step%tangential = [self%force, target]
      else
         step%tangential = [self%displacement, target] - self%zero
      end if
   end function straight_step

   !> Go along a step, from one change of the sign of slip to the next.
   pure subroutine follow(self, contact, next, whole)
      type(history_t), intent(inout) :: self
      class(normal_contact_t), intent(in) :: contact
      type(normal_state_t), intent(in) :: next
      type(step_t), intent(in) :: whole
      type(step_t) :: step
      real(dp) :: normal, tangential, change, size
      logical :: has_ended

      step = whole
      has_ended = .false.
      do while (.not. has_ended)
         normal = step%normal(2) - step%normal(1)
         tangential = step%tangential(2) - step%tangential(1)
         size = round_off*max(step%normal(1), step%normal(2), 0.0_dp)
         if (abs(normal) <= size .and. abs(tangential) <= size) exit
         if (normal >= 0 .and. (abs(tangential) <= normal .or. self%n == 0)) then
            call grow(self, contact, next, step)
            exit
         end if
         if (self%n == 0) exit
         change = tangential - self%segments(self%n)%f*normal
         if (.not. abs(change) > size .and. normal < 0) then
            call go_back(self, contact, next, step, has_ended)
         else
            call slip(self, contact, next, sign(1.0_dp, change), step, has_ended)
         end if
      end do
   end subroutine follow

   !> The contact grows without slip; one that begins cannot bear more than that.
   pure subroutine grow(self, contact, next, step)
      type(history_t), intent(inout) :: self
      class(normal_contact_t), intent(in) :: contact
      !> The normal state at the end of the step.
      type(normal_state_t), intent(in) :: next
      type(step_t), intent(in) :: step
      real(dp) :: normal, tangential, f

      normal = step%normal(2) - step%normal(1)
      tangential = step%tangential(2) - step%tangential(1)
      f = 0
      if (normal > 0) f = max(-1.0_dp, min(1.0_dp, tangential/normal))
      call self%push(next, f)
      if (step%kind == by_displacement .and. abs(tangential) > normal) then
         call slide(self, contact, next, step, sign(1.0_dp, tangential), step%normal(1))
      end if
   end subroutine grow

   !> Unloading goes back along the outermost segment without slip, up to the end of the step or of the segment.
   pure subroutine go_back(self, contact, next, step, has_ended)
      !> The contact with its history, of one segment at least.
      type(history_t), intent(inout) :: self
      class(normal_contact_t), intent(in) :: contact
      !> The normal state at the end of the step.
      type(normal_state_t), intent(in) :: next
      !> In: the step, in which the coordinate falls. Out: what remains of it.
      type(step_t), intent(inout) :: step
      logical, intent(out) :: has_ended
      real(dp) :: bottom, normal, tangential

      normal = step%normal(2) - step%normal(1)
      tangential = step%tangential(2) - step%tangential(1)
      bottom = self%bottom(step%kind)
      has_ended = step%normal(2) >= bottom
      call self%cut(contact, step%kind, max(step%normal(2), bottom), next)
      if (has_ended) return
      step%tangential(1) = step%tangential(1) + tangential*((bottom - step%normal(1))/normal)
      step%normal(1) = bottom
   end subroutine go_back

   !> Radius of what sticks: the contact, less the zone at its edge where the last step has slipped.
   pure real(dp) function stick_radius(self) result(radius)
      class(history_t), intent(in) :: self

      radius = self%normal%radius
      if (self%n == 0) return
      if (abs(self%segments(self%n)%f) < 1) return
      radius = 0
      if (self%n > 1) radius = self%segments(self%n - 1)%outer%radius
   end function stick_radius

end module adfric_interface_tangential_history

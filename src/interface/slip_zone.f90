! SPDX-License-Identifier: GPL-3.0-or-later
!> A zone of slip at the edge of a contact with Coulomb's friction, which eats inwards during a straight step.
!>
!> What lies within L keeps its f and what lies beyond has f = s, so that H(L) = s T(L) - L, which falls with L, has the value
!> s T - P. In a straight step both sides change in proportion, so the inner end of the zone is a straight function of the step within
!> each segment, and every event, the end of a segment or the end of a zone that unloading overtakes, has a position in closed form.
!> Forces are in units of mu, displacements in units of mu m.
module adfric_interface_slip_zone
   use adfric_base_kinds, only: dp
   use adfric_interface_normal_contact, only: by_displacement, coordinate, find_position, normal_contact_t, normal_state_t, &
      & round_off
   use adfric_interface_slip_loss, only: add_loss, add_sliding_loss
   use adfric_interface_slip_stack, only: slip_stack_t, step_t
   implicit none (type, external)
   private
   public :: slip, slide

   !> A zone of slip, and how far the step has gone when its inner end is that of the outermost segment.
   type :: slip_zone_t
      !> Sign s of the slip.
      real(dp) :: s = 1
      !> s T - P at the beginning and at the end of the step.
      real(dp) :: begin = 0, finish = 0
      !> How much the coordinate grows in the step; and its round-off.
      real(dp) :: normal = 0, size = 0
      !> Share of the step that is done; and width of the zone then, of the coordinate.
      real(dp) :: share = 0, width = 0
      !> The normal state then.
      type(normal_state_t) :: top
   end type slip_zone_t

   !> What a zone does to the outermost segment.
   type :: front_t
      !> f of the segment.
      real(dp) :: f = 0
      !> Its outer end.
      type(normal_state_t) :: high
      !> Coordinate of its inner end, and of that of the zone when the step has ended or the segment is eaten.
      real(dp) :: low = 0, position = 0
      !> Share of the step that is done by then; and width of the zone, below 0 where unloading has overtaken it.
      real(dp) :: share = 1, width = 0
   end type front_t

contains

   !> Slip of one sign eats inwards, up to the end of the step, or until unloading has overtaken it.
   pure subroutine slip(self, contact, next, s, step, has_ended)
      class(slip_stack_t), intent(inout) :: self
      class(normal_contact_t), intent(in) :: contact
      !> The normal state at the end of the step.
      type(normal_state_t), intent(in) :: next
      !> Sign of the slip.
      real(dp), intent(in) :: s
      !> In: the step. Out: what remains of it.
      type(step_t), intent(inout) :: step
      logical, intent(out) :: has_ended
      type(slip_zone_t) :: zone
      type(front_t) :: front

      call open_zone(self, s, step, zone)
      do while (self%n > 0)
         call meet_segment(self, step, zone, front)
         has_ended = .not. front%width < -zone%size
         if (.not. has_ended) then
            call end_overtaken(self, contact, zone, front, step)
            return
         end if
         call eat(self, contact, next, step, front, zone)
         if (front%position > front%low) exit
         self%n = self%n - 1
         if (.not. front%share < 1) exit
      end do
      has_ended = .true.
      call close_zone(self, contact, next, step, zone)
   end subroutine slip

   !> A zone at the beginning of a step; one of this sign that is there goes on.
   pure subroutine open_zone(self, s, step, zone)
      class(slip_stack_t), intent(inout) :: self
      !> Sign of the slip.
      real(dp), intent(in) :: s
      type(step_t), intent(in) :: step
      type(slip_zone_t), intent(out) :: zone

      zone%s = s
      zone%normal = step%normal(2) - step%normal(1)
      zone%begin = s*step%tangential(1) - step%normal(1)
      zone%finish = s*step%tangential(2) - step%normal(2)
      zone%size = round_off*max(step%normal(1), step%normal(2))
      zone%top = self%normal
      if (1 - s*self%segments(self%n)%f > round_off) return
      self%n = self%n - 1
      zone%width = step%normal(1)
      if (self%n > 0) zone%width = step%normal(1) - coordinate(self%segments(self%n)%outer, step%kind)
   end subroutine open_zone

   !> How far the zone gets into the outermost segment.
   pure subroutine meet_segment(self, step, zone, front)
      class(slip_stack_t), intent(in) :: self
      type(step_t), intent(in) :: step
      type(slip_zone_t), intent(in) :: zone
      !> Receives what it does to the segment.
      type(front_t), intent(out) :: front
      real(dp) :: h_low

      front%f = self%segments(self%n)%f
      front%high = self%segments(self%n)%outer
      front%low = self%bottom(step%kind)
      h_low = 0
      if (self%n > 1) h_low = zone%s*self%segments(self%n - 1)%sums(step%kind) - front%low
      front%position = front%low
      if (h_low > zone%finish .and. 1 - zone%s*front%f > 0) then
         front%position = min(front%low + (h_low - zone%finish)/(1 - zone%s*front%f), coordinate(front%high, step%kind))
      else if (zone%finish > zone%begin) then
         front%share = max(zone%share, min(1.0_dp, (h_low - zone%begin)/(zone%finish - zone%begin)))
      end if
      front%width = step%normal(1) + front%share*zone%normal - front%position
   end subroutine meet_segment

   !> Unloading overtakes the zone within the segment: nothing slips any more, and a step is left.
   pure subroutine end_overtaken(self, contact, zone, front, step)
      class(slip_stack_t), intent(inout) :: self
      class(normal_contact_t), intent(in) :: contact
      type(slip_zone_t), intent(in) :: zone
      type(front_t), intent(in) :: front
      !> In: the step. Out: what remains of it.
      type(step_t), intent(inout) :: step
      type(normal_state_t) :: edge
      real(dp) :: shift, share, position

      shift = zone%width/(zone%width - front%width)
      share = zone%share + (front%share - zone%share)*shift
      position = step%normal(1) + share*zone%normal
      call find_position(contact, step%kind, position, edge, self%is_converged)
      call add_loss(self, contact, step%kind, 1 - zone%s*front%f, edge, front%high, [zone%top, edge])
      call self%cut(contact, step%kind, position, edge)
      self%normal = edge
      step%tangential(1) = self%segments(self%n)%sums(step%kind)
      step%normal(1) = position
   end subroutine end_overtaken

   !> Eat the outermost segment, or what of it lies beyond the end of the zone; one that is eaten whole is still there.
   pure subroutine eat(self, contact, next, step, front, zone)
      class(slip_stack_t), intent(inout) :: self
      class(normal_contact_t), intent(in) :: contact
      !> The normal state at the end of the step.
      type(normal_state_t), intent(in) :: next
      type(step_t), intent(in) :: step
      type(front_t), intent(in) :: front
      type(slip_zone_t), intent(inout) :: zone
      type(normal_state_t) :: edge, top

      top = next
      if (front%share < 1 .and. abs(zone%normal) > 0) &
         & call find_position(contact, step%kind, step%normal(1) + front%share*zone%normal, top, self%is_converged)
      if (front%position > front%low) then
         call find_position(contact, step%kind, front%position, edge, self%is_converged)
      else if (self%n > 1) then
         edge = self%segments(self%n - 1)%outer
      end if
      call add_loss(self, contact, step%kind, 1 - zone%s*front%f, edge, front%high, [zone%top, top])
      zone%share = front%share
      zone%width = front%width
      zone%top = top
      if (front%position > front%low) call self%cut(contact, step%kind, front%position, edge)
   end subroutine eat

   !> The end of the step: what has slipped is one segment.
   pure subroutine close_zone(self, contact, next, step, zone)
      class(slip_stack_t), intent(inout) :: self
      class(normal_contact_t), intent(in) :: contact
      !> The normal state at the end of the step.
      type(normal_state_t), intent(in) :: next
      type(step_t), intent(in) :: step
      type(slip_zone_t), intent(in) :: zone
      logical :: is_sliding

      is_sliding = self%n == 0 .and. step%kind == by_displacement
      call self%push(next, zone%s)
      if (is_sliding) then
         call slide(self, contact, next, step, zone%s, step%normal(1) + zone%share*zone%normal)
      else if (self%n > 0) then
         ! the sum is that of the step to the last digit
         self%segments(self%n)%sums(step%kind) = step%tangential(2)
      end if
   end subroutine close_zone

   !> A contact that slides as a whole drags its zero along, and friction takes mu P over the path.
   pure subroutine slide(self, contact, next, step, s, start)
      class(slip_stack_t), intent(inout) :: self
      class(normal_contact_t), intent(in) :: contact
      !> The normal state at the end of the step.
      type(normal_state_t), intent(in) :: next
      type(step_t), intent(in) :: step
      !> Sign of the slip.
      real(dp), intent(in) :: s
      !> Approach where it begins to slide.
      real(dp), intent(in) :: start
      type(normal_state_t) :: first
      real(dp) :: path

      path = s*step%tangential(2) - step%normal(2)
      if (.not. path > 0) return
      self%zero = self%zero + s*path
      call find_position(contact, by_displacement, max(start, 0.0_dp), first, self%is_converged)
      call add_sliding_loss(self, first, next, path)
   end subroutine slide

end module adfric_interface_slip_zone

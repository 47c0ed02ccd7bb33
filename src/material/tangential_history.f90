! SPDX-License-Identifier: GPL-3.0-or-later
!> Coulomb's friction of a contact through any history of normal and tangential loading (R. D. Mindlin, H. Deresiewicz, J. Appl. Mech. 20,
!> 1953, 327; J. Jaeger, Arch. Appl. Mech. 63, 1993, 402), for every contact whose tangential compliance is m times the normal one.
!>
!> Each increment dL of the load lies in a ring of the contact, and what it bears of the tangential force is mu f dL with |f| <= 1. So a
!> state is a stack of segments of the load from 0 to P, each of one f:
!>
!>     T = mu sum f dL,     u = mu m sum f dg + the place where contact began
!>
!> dg the part of the approach that belongs to dL. In units of mu and mu m, a step (dP, dT) adds a segment f = dT/dP where P grows and
!> |dT| <= dP: no slip. Else slip with the sign s eats inwards from the edge. What lies within L keeps its f and what lies beyond has
!> f = s, so that H(L) = s T(L) - L, which falls with L, has the value s T - P. s is the sign of dT - f dP of the outermost segment. In a
!> straight step both sides change in proportion, so P* is a straight function of the step within each segment, and every event, the
!> end of a segment or the end of a zone that unloading overtakes, has a place in closed form. The same holds for steps that are straight
!> in approach and displacement, with g in place of L. Nothing is followed in small steps.
!>
!> Friction takes mu^2 m (1 - s f) int F dg from a segment that is eaten, F = P - P(g) - P'(g) (delta - g), which needs only P, g and
!> U = int P dg at the ends.
module adfric_material_tangential_history
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: normal_contact_t, normal_state_t, history_t, start_history, by_force, by_displacement

   !> What a step gives: the tangential force, or the displacement.
   integer, parameter :: by_force = 1, by_displacement = 2
   !> Differences below this share are round-off.
   real(dp), parameter :: round_off = 16*epsilon(1.0_dp)
   !> Number of segments for which there is room at first.
   integer, parameter :: first_size = 16

   !> A contact without friction under a load.
   type :: normal_state_t
      !> Load P, approach g, and U, the integral of P over g.
      real(dp) :: load = 0, approach = 0, work = 0
      !> dP/dg.
      real(dp) :: stiffness = 0
      !> Radius of contact.
      real(dp) :: radius = 0
   end type normal_state_t

   !> Contacts without friction of the same bodies.
   type, abstract :: normal_contact_t
      !> Approach where dP/dg is not smooth, if there is one.
      real(dp) :: kink = 0
   contains
      procedure(find_state_i), deferred :: under_load
      procedure(find_state_i), deferred :: at_approach
   end type normal_contact_t

   abstract interface
      !> The state under a load, or at an approach.
      pure subroutine find_state_i(self, given, state, is_converged)
         import :: normal_contact_t, normal_state_t, dp
         implicit none (type, external)
         !> The contacts.
         class(normal_contact_t), intent(in) :: self
         !> Load or approach, >= 0.
         real(dp), intent(in) :: given
         !> Receives the state.
         type(normal_state_t), intent(out) :: state
         !> Was it found to round-off?
         logical, intent(out) :: is_converged
      end subroutine find_state_i
   end interface

   !> A segment of the load.
   type :: segment_t
      !> Its outer end.
      type(normal_state_t) :: outer
      !> f, between -1 and 1.
      real(dp) :: f = 0
      !> T/mu, and u/(mu m) less where contact began, at the outer end.
      real(dp) :: sums(2) = 0
   end type segment_t

   !> A contact with its history.
   type :: history_t
      !> The normal state; the approach is below 0 out of contact.
      type(normal_state_t) :: normal
      !> T/mu and u/(mu m).
      real(dp) :: force = 0, displacement = 0
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
      procedure :: advance
      procedure :: stick_radius
   end type history_t

   !> A straight step: coordinate 1 is the load with the force, 2 the approach with the displacement less its zero.
   type :: step_t
      !> One of `by_...`, which is also the coordinate.
      integer :: kind = by_force
      !> Normal and tangential coordinate at its beginning and its end.
      real(dp) :: normal(2) = 0, tangential(2) = 0
   end type step_t

contains

   !> A contact that has not touched yet.
   pure subroutine start_history(self)
      !> Receives the state.
      type(history_t), intent(out) :: self

      allocate (self%segments(first_size))
   end subroutine start_history

   !> A straight step to another normal state, under a force or to a displacement.
   pure subroutine advance(self, contact, next, kind, given, is_possible)
      !> The contact with its history.
      class(history_t), intent(inout) :: self
      !> Its normal states.
      class(normal_contact_t), intent(in) :: contact
      !> The normal state at the end; out of contact its load and work are 0, and its approach at most 0.
      type(normal_state_t), intent(in) :: next
      !> `by_force` or `by_displacement`: along which coordinates the step is straight.
      integer, intent(in) :: kind
      !> T/mu or u/(mu m) at the end.
      real(dp), intent(in) :: given
      !> Is there such a state? A force above that of sliding has none, and leaves the history as it is.
      logical, intent(out) :: is_possible
      type(normal_state_t) :: touching
      type(step_t) :: step
      real(dp) :: share, target

      is_possible = kind == by_displacement .or. abs(given) <= (1 + round_off)*next%load
      if (.not. is_possible) return
      step%kind = kind
      target = given
      if (kind == by_force) target = sign(min(abs(given), next%load), given)
      if (kind == by_displacement .and. next%approach > 0 .and. self%normal%approach < 0) then
         ! contact begins within the step
         share = -self%normal%approach/(next%approach - self%normal%approach)
         self%zero = self%displacement + share*(target - self%displacement)
         self%displacement = self%zero
         self%normal = touching
      else if (self%n == 0) then
         self%zero = self%displacement
         self%normal%approach = max(self%normal%approach, 0.0_dp)
      end if
      if (kind == by_displacement .and. self%n > 0 .and. next%approach < 0) then
         ! contact ends within the step
         share = self%normal%approach/(self%normal%approach - next%approach)
         call set_step(self, touching, kind, self%displacement + share*(target - self%displacement), step)
         call follow(self, contact, touching, step)
      else if (next%approach > 0 .or. self%n > 0) then
         call set_step(self, next, kind, target, step)
         call follow(self, contact, next, step)
      end if
      self%normal = next
      if (.not. next%approach > 0) self%n = 0
      if (kind == by_displacement) then
         self%displacement = target
         self%force = 0
         if (self%n > 0) self%force = self%segments(self%n)%sums(by_force)
      else
         self%force = target
         self%displacement = self%zero
         if (self%n > 0) self%displacement = self%zero + self%segments(self%n)%sums(by_displacement)
      end if
      self%loss_error = self%loss_error + round_off*self%loss
   end subroutine advance

   !> The coordinates of a step.
   pure subroutine set_step(self, next, kind, target, step)
      !> The contact with its history.
      type(history_t), intent(in) :: self
      !> The normal state at the end.
      type(normal_state_t), intent(in) :: next
      !> One of `by_...`.
      integer, intent(in) :: kind
      !> T/mu or u/(mu m) at the end.
      real(dp), intent(in) :: target
      !> Receives them.
      type(step_t), intent(out) :: step

      step%kind = kind
      step%normal = [coordinate(self%normal, kind), coordinate(next, kind)]
      if (kind == by_force) then
         step%tangential = [self%force, target]
      else
         step%tangential = [self%displacement, target] - self%zero
      end if
   end subroutine set_step

   !> Load or approach.
   pure real(dp) function coordinate(state, kind)
      !> A normal state.
      type(normal_state_t), intent(in) :: state
      !> One of `by_...`.
      integer, intent(in) :: kind

      coordinate = merge(state%load, state%approach, kind == by_force)
   end function coordinate

   !> Go along a step, from one change of the sign of slip to the next.
   pure subroutine follow(self, contact, next, whole)
      !> The contact with its history.
      type(history_t), intent(inout) :: self
      !> Its normal states.
      class(normal_contact_t), intent(in) :: contact
      !> The normal state at the end.
      type(normal_state_t), intent(in) :: next
      !> The step.
      type(step_t), intent(in) :: whole
      type(step_t) :: step
      real(dp) :: normal, tangential, f, size, bottom
      logical :: has_ended

      step = whole
      do
         normal = step%normal(2) - step%normal(1)
         tangential = step%tangential(2) - step%tangential(1)
         size = round_off*max(step%normal(1), step%normal(2), 0.0_dp)
         if (abs(normal) <= size .and. abs(tangential) <= size) exit
         if (normal >= 0 .and. (abs(tangential) <= normal .or. self%n == 0)) then
            ! a contact that begins cannot bear more
            f = 0
            if (normal > 0) f = max(-1.0_dp, min(1.0_dp, tangential/normal))
            call push(self, next, f)
            if (step%kind == by_displacement .and. abs(tangential) > normal) then
               call slide(self, contact, next, step, sign(1.0_dp, tangential), step%normal(1))
            end if
            exit
         end if
         if (self%n == 0) exit
         f = tangential - self%segments(self%n)%f*normal
         if (.not. abs(f) > size .and. normal < 0) then
            ! back along the outermost segment
            bottom = 0
            if (self%n > 1) bottom = coordinate(self%segments(self%n - 1)%outer, step%kind)
            has_ended = step%normal(2) >= bottom
            call cut(self, contact, step%kind, max(step%normal(2), bottom), next)
            if (has_ended) exit
            step%tangential(1) = step%tangential(1) + tangential*((bottom - step%normal(1))/normal)
            step%normal(1) = bottom
         else
            call slip(self, contact, next, sign(1.0_dp, f), step, has_ended)
            if (has_ended) exit
         end if
      end do
   end subroutine follow

   !> Slip of one sign eats inwards, up to the end of the step, or until unloading has overtaken it.
   pure subroutine slip(self, contact, next, s, step, has_ended)
      !> The contact with its history.
      type(history_t), intent(inout) :: self
      !> Its normal states.
      class(normal_contact_t), intent(in) :: contact
      !> The normal state at the end of the step.
      type(normal_state_t), intent(in) :: next
      !> Sign of the slip.
      real(dp), intent(in) :: s
      !> In: the step. Out: what is left of it.
      type(step_t), intent(inout) :: step
      !> Did the step end?
      logical, intent(out) :: has_ended
      type(normal_state_t) :: edge, high, top(2)
      real(dp) :: begin, finish, low, h_low, share, last_share, place, gap, last_gap, normal, size, f, shift
      integer :: k

      has_ended = .true.
      k = step%kind
      normal = step%normal(2) - step%normal(1)
      begin = s*step%tangential(1) - step%normal(1)
      finish = s*step%tangential(2) - step%normal(2)
      size = round_off*max(step%normal(1), step%normal(2))
      edge = self%normal
      last_share = 0
      last_gap = 0
      top(1) = edge
      if (1 - s*self%segments(self%n)%f <= round_off) then
         ! the zone of this sign is there
         self%n = self%n - 1
         last_gap = step%normal(1)
         if (self%n > 0) last_gap = step%normal(1) - coordinate(self%segments(self%n)%outer, k)
      end if
      do while (self%n > 0)
         associate (segment => self%segments(self%n))
            f = segment%f
            high = segment%outer
            low = 0
            h_low = 0
            if (self%n > 1) then
               low = coordinate(self%segments(self%n - 1)%outer, k)
               h_low = s*self%segments(self%n - 1)%sums(k) - low
            end if
         end associate
         share = 1
         place = low
         if (h_low > finish .and. 1 - s*f > 0) then
            place = min(low + (h_low - finish)/(1 - s*f), coordinate(high, k))
         else if (finish > begin) then
            share = max(last_share, min(1.0_dp, (h_low - begin)/(finish - begin)))
         end if
         gap = step%normal(1) + share*normal - place
         if (gap < -size) then
            ! unloading overtakes the zone
            shift = last_gap/(last_gap - gap)
            share = last_share + (share - last_share)*shift
            place = step%normal(1) + share*normal
            call find(contact, k, place, edge, self%is_converged)
            top(2) = edge
            call add_loss(self, contact, k, (1 - s*f), edge, high, top)
            call cut(self, contact, k, place, edge)
            self%normal = edge
            step%tangential(1) = self%segments(self%n)%sums(k)
            step%normal(1) = place
            has_ended = .false.
            return
         end if
         if (share < 1) then
            call find(contact, k, step%normal(1) + share*normal, top(2), self%is_converged)
            if (.not. abs(normal) > 0) top(2) = next
         else
            top(2) = next
         end if
         edge = normal_state_t()
         if (place > low) then
            call find(contact, k, place, edge, self%is_converged)
         else if (self%n > 1) then
            edge = self%segments(self%n - 1)%outer
         end if
         call add_loss(self, contact, k, (1 - s*f), edge, high, top)
         last_share = share
         last_gap = gap
         top(1) = top(2)
         if (place > low) then
            call cut(self, contact, k, place, edge)
            exit
         end if
         self%n = self%n - 1
         if (.not. share < 1) exit
      end do
      if (self%n == 0 .and. k == by_displacement) then
         ! all of it slides
         call push(self, next, s)
         call slide(self, contact, next, step, s, step%normal(1) + last_share*normal)
      else
         call push(self, next, s)
         ! the sum is that of the step to the last digit
         if (self%n > 0) self%segments(self%n)%sums(k) = step%tangential(2)
      end if
   end subroutine slip

   !> A contact that slides as a whole drags its zero along, and friction takes mu P over the way.
   pure subroutine slide(self, contact, next, step, s, start)
      !> The contact with its history: one segment.
      type(history_t), intent(inout) :: self
      !> Its normal states.
      class(normal_contact_t), intent(in) :: contact
      !> The normal state at the end of the step.
      type(normal_state_t), intent(in) :: next
      !> The step, in approach and displacement.
      type(step_t), intent(in) :: step
      !> Sign of the slip.
      real(dp), intent(in) :: s
      !> Approach where it begins to slide.
      real(dp), intent(in) :: start
      type(normal_state_t) :: first
      real(dp) :: way, mean

      way = s*step%tangential(2) - step%normal(2)
      if (.not. way > 0) return
      self%zero = self%zero + s*way
      call find(contact, by_displacement, max(start, 0.0_dp), first, self%is_converged)
      mean = (first%load + next%load)/2
      if (abs(next%approach - first%approach) > 1.0e-4_dp*max(next%approach, first%approach)) &
         & mean = (next%work - first%work)/(next%approach - first%approach)
      self%loss = self%loss + way*mean
   end subroutine slide

   !> A normal state by its coordinate.
   pure subroutine find(contact, kind, given, state, is_converged)
      !> The normal states.
      class(normal_contact_t), intent(in) :: contact
      !> One of `by_...`.
      integer, intent(in) :: kind
      !> Load or approach.
      real(dp), intent(in) :: given
      !> Receives the state.
      type(normal_state_t), intent(out) :: state
      !> Becomes false if it is not found to round-off.
      logical, intent(inout) :: is_converged
      logical :: is_found

      if (.not. given > 0) return
      if (kind == by_force) then
         call contact%under_load(given, state, is_found)
      else
         call contact%at_approach(given, state, is_found)
      end if
      is_converged = is_converged .and. is_found
   end subroutine find

   !> Cut the outermost segment.
   pure subroutine cut(self, contact, kind, place, known)
      !> The contact with its history.
      type(history_t), intent(inout) :: self
      !> Its normal states.
      class(normal_contact_t), intent(in) :: contact
      !> One of `by_...`.
      integer, intent(in) :: kind
      !> Load or approach of the new end.
      real(dp), intent(in) :: place
      !> A state that may be that of the place.
      type(normal_state_t), intent(in) :: known
      type(normal_state_t) :: end_state
      real(dp) :: f

      end_state = known
      if (abs(coordinate(known, kind) - place) > 0) call find(contact, kind, place, end_state, self%is_converged)
      f = self%segments(self%n)%f
      self%n = self%n - 1
      self%normal = end_state
      call push(self, end_state, f)
   end subroutine cut

   !> Add a segment.
   pure subroutine push(self, outer, f)
      !> The contact with its history.
      type(history_t), intent(inout) :: self
      !> Outer end of the segment.
      type(normal_state_t), intent(in) :: outer
      !> Its f.
      real(dp), intent(in) :: f
      type(segment_t), allocatable :: more(:)
      type(segment_t) :: last

      if (self%n > 0) then
         last = self%segments(self%n)
         if (.not. outer%load > last%outer%load) return
         if (.not. abs(last%f - f) > 0) then
            ! the same segment goes on
            self%n = self%n - 1
         end if
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

   !> Add what friction takes while a segment is eaten from `high` to `low` and the normal state goes from the first to the second of
   !> `top`: of the coordinate of the step, one is a straight function of the other.
   pure subroutine add_loss(self, contact, kind, factor, low, high, top)
      !> The contact with its history; its loss grows.
      type(history_t), intent(inout) :: self
      !> Its normal states.
      class(normal_contact_t), intent(in) :: contact
      !> One of `by_...`.
      integer, intent(in) :: kind
      !> 1 - s f.
      real(dp), intent(in) :: factor
      !> Ends of what is eaten.
      type(normal_state_t), intent(in) :: low, high
      !> The normal state at the beginning, where the slip is at `high`, and at the end.
      type(normal_state_t), intent(in) :: top(2)
      ! below this change of the normal state an integral over it is a rule of three nodes
      real(dp), parameter :: small = 1.0e-2_dp, narrow = 1.0e-6_dp
      ! beside the edge terms take each other's digits
      real(dp), parameter :: close = 0.03_dp
      real(dp), parameter :: node = 0.7745966692414834_dp
      type(normal_state_t) :: at_node
      real(dp) :: span, change, slope, sums(2), terms(5), first, second, widest
      integer :: i

      span = coordinate(high, kind) - coordinate(low, kind)
      if (.not. span > 0) return
      widest = maxval(top%approach)
      if (widest - low%approach < close*widest .and. .not. (contact%kink > low%approach .and. contact%kink < widest)) then
         call add_small_loss(self, contact, kind, factor, low, span, top)
         return
      end if
      change = coordinate(top(1), kind) - coordinate(top(2), kind)
      slope = change/span
      ! the mean over the way of the other coordinate of the normal state
      if (.not. abs(change) > 0) then
         sums = [top(1)%approach, top(1)%load]
      else if (abs(change) > small*max(coordinate(top(1), kind), coordinate(top(2), kind))) then
         sums(1) = (top(1)%load*top(1)%approach - top(1)%work - (top(2)%load*top(2)%approach - top(2)%work))/change
         sums(2) = (top(1)%work - top(2)%work)/change
      else
         sums = 0
         do i = -1, 1
            call find(contact, kind, coordinate(top(2), kind) + change*(1 + i*node)/2, at_node, self%is_converged)
            sums = sums + merge(4.0_dp/9, 2.5_dp/9, i == 0)*[at_node%approach, at_node%load]
         end do
      end if
      if (span <= narrow*coordinate(high, kind)) then
         ! F is a straight function of the place
         first = high%approach - low%approach
         if (kind == by_force) first = 2*span/(low%stiffness + high%stiffness)
         terms = 0
         terms(1) = first*(sums(2) - (low%load + high%load)/2)
         terms(2) = -first*(low%stiffness + high%stiffness)/2*(sums(1) - (low%approach + high%approach)/2)
      else if (kind == by_force) then
         ! int P d(g) with P = P2 + slope (P(g) - P(low))
         first = (top(2)%load - slope*low%load)*(high%approach - low%approach) + slope*(high%work - low%work)
         second = sums(1)*(high%load - low%load)
         terms = [first, -(high%work - low%work), -second, high%load*high%approach - low%load*low%approach, &
            & -(high%work - low%work)]
      else
         first = sums(2)*(high%approach - low%approach)
         second = high%load*(top(1)%approach - high%approach) - low%load*(top(2)%approach - low%approach)
         terms = [first, -(high%work - low%work), -second, (slope - 1)*(high%work - low%work), 0.0_dp]
      end if
      self%loss = self%loss + factor*max(sum(terms), 0.0_dp)
      ! differences of loads, approaches and works have the round-off of these
      self%loss_error = self%loss_error + round_off*factor*(high%work + high%load*high%approach + abs(slope)*maxval(top%work)*span &
         & /max(abs(change), span))
   end subroutine add_loss

   !> The same beside the edge: F = int [K(y) - K(g)] dy, g < y < delta, K = dP/dg, by Gauss's rule.
   pure subroutine add_small_loss(self, contact, kind, factor, low, span, top)
      !> The contact with its history; its loss grows.
      type(history_t), intent(inout) :: self
      !> Its normal states.
      class(normal_contact_t), intent(in) :: contact
      !> One of `by_...`.
      integer, intent(in) :: kind
      !> 1 - s f.
      real(dp), intent(in) :: factor
      !> Inner end of what is eaten.
      type(normal_state_t), intent(in) :: low
      !> How much is eaten, of the coordinate.
      real(dp), intent(in) :: span
      !> The normal state at the beginning, and at the end, where the slip is at `low`.
      type(normal_state_t), intent(in) :: top(2)
      real(dp), parameter :: nodes(4) = [-0.8611363115940526_dp, -0.3399810435848563_dp, 0.3399810435848563_dp, &
         & 0.8611363115940526_dp]
      real(dp), parameter :: weights(4) = [0.3478548451374538_dp, 0.6521451548625461_dp, 0.6521451548625461_dp, &
         & 0.3478548451374538_dp]
      type(normal_state_t) :: place, edge, between
      real(dp) :: opening, part, change
      integer :: i, j

      change = coordinate(top(1), kind) - coordinate(top(2), kind)
      do i = 1, size(nodes)
         call find(contact, kind, coordinate(low, kind) + span*(1 + nodes(i))/2, place, self%is_converged)
         edge = top(2)
         if (abs(change) > 0) call find(contact, kind, coordinate(top(2), kind) + change*(1 + nodes(i))/2, edge, self%is_converged)
         opening = max(edge%approach - place%approach, 0.0_dp)
         part = 0
         do j = 1, size(nodes)
            call find(contact, by_displacement, place%approach + opening*(1 + nodes(j))/2, between, self%is_converged)
            part = part + weights(j)/2*opening*max(between%stiffness - place%stiffness, 0.0_dp)
         end do
         associate (weight => factor*weights(i)/2*span/merge(place%stiffness, 1.0_dp, kind == by_force))
            self%loss = self%loss + weight*part
            self%loss_error = self%loss_error + round_off*weight*(opening*place%stiffness + part*edge%approach/max(opening, &
               & round_off*edge%approach))
         end associate
      end do
   end subroutine add_small_loss

   !> Radius of what sticks: the contact, less the zone at its edge where the last step has slipped.
   pure real(dp) function stick_radius(self) result(radius)
      !> The contact with its history.
      class(history_t), intent(in) :: self

      radius = self%normal%radius
      if (self%n == 0) return
      if (abs(self%segments(self%n)%f) < 1) return
      radius = 0
      if (self%n > 1) radius = self%segments(self%n - 1)%outer%radius
   end function stick_radius

end module adfric_material_tangential_history

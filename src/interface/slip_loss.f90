! SPDX-License-Identifier: GPL-3.0-or-later
!> Energy that friction takes while slip eats into a segment of the load, and while a contact slides as a whole.
!>
!> A segment of f that is eaten by slip of the sign s loses mu^2 m (1 - s f) int F dg, F = P - P(g) - P'(g) (delta - g), which needs only
!> P, g and U = int P dg at the ends. Forces are in units of mu, displacements in units of mu m.
module adfric_interface_slip_loss
   use adfric_base_kinds, only: dp
   use adfric_interface_normal_contact, only: by_displacement, by_force, coordinate, find_position, normal_contact_t, &
      & normal_state_t, &
      & round_off
   use adfric_interface_slip_stack, only: slip_stack_t
   implicit none (type, external)
   private
   public :: add_loss, add_sliding_loss

   !> Below this change of the normal state an integral over it is a rule of three nodes.
   real(dp), parameter :: small = 1.0e-2_dp
   !> A segment of this share of its position is so narrow that F is a straight function of the position.
   real(dp), parameter :: narrow = 1.0e-6_dp
   !> Beside the edge, within this share of the approach, terms take each other's digits.
   real(dp), parameter :: close = 0.03_dp
   !> Below this share of the approach two loads have a mean that is half their sum.
   real(dp), parameter :: near = 1.0e-4_dp

   !> What is eaten.
   type :: bite_t
      !> `by_force` or `by_displacement`.
      integer :: kind = by_force
      !> Its inner and its outer end.
      type(normal_state_t) :: low, high
      !> The normal state at the beginning, where the slip is at `high`, and at the end, where it is at `low`.
      type(normal_state_t) :: top(2)
      !> Of the coordinate: how much is eaten, and how much the normal state falls meanwhile.
      real(dp) :: span = 0, change = 0
   end type bite_t

contains

   !> Add what friction takes while a segment is eaten from `high` to `low` and the normal state goes from the first to the second of
   !> `top`: of the coordinate of the step, one is a straight function of the other.
   pure subroutine add_loss(self, contact, kind, factor, low, high, top)
      class(slip_stack_t), intent(inout) :: self
      class(normal_contact_t), intent(in) :: contact
      !> `by_force` or `by_displacement`.
      integer, intent(in) :: kind
      !> 1 - s f.
      real(dp), intent(in) :: factor
      type(normal_state_t), intent(in) :: low, high
      !> The normal state at the beginning, where the slip is at `high`, and at the end.
      type(normal_state_t), intent(in) :: top(2)
      type(bite_t) :: bite
      real(dp) :: widest, means(2), sum_of_terms, slope

      bite = bite_t(kind, low, high, top)
      bite%span = coordinate(high, kind) - coordinate(low, kind)
      if (.not. bite%span > 0) return
      bite%change = coordinate(top(1), kind) - coordinate(top(2), kind)
      widest = maxval(top%approach)
      if (widest - low%approach < close*widest .and. .not. (contact%kink > low%approach .and. contact%kink < widest)) then
         call add_small_loss(self, contact, factor, bite)
         return
      end if
      slope = bite%change/bite%span
      call find_means(contact, bite, means, self%is_converged)
      if (bite%span <= narrow*coordinate(high, kind)) then
         sum_of_terms = narrow_loss(bite, means)
      else
         sum_of_terms = wide_loss(bite, means, slope)
      end if
      self%loss = self%loss + factor*max(sum_of_terms, 0.0_dp)
      ! differences of loads, approaches and works have the round-off of these
      self%loss_error = self%loss_error + round_off*factor*(high%work + high%load*high%approach + abs(slope)*maxval(top%work) &
         & *bite%span/max(abs(bite%change), bite%span))
   end subroutine add_loss

   !> Means of the approach and of the load of the normal state over the path.
   pure subroutine find_means(contact, bite, means, is_converged)
      class(normal_contact_t), intent(in) :: contact
      type(bite_t), intent(in) :: bite
      !> Receives the means of approach and load.
      real(dp), intent(out) :: means(2)
      !> Becomes false if a state is not found to round-off.
      logical, intent(inout) :: is_converged
      real(dp), parameter :: node = 0.7745966692414834_dp
      type(normal_state_t) :: at_node
      real(dp) :: last
      integer :: i

      associate (top => bite%top, change => bite%change)
         last = coordinate(top(2), bite%kind)
         if (.not. abs(change) > 0) then
            means = [top(1)%approach, top(1)%load]
         else if (abs(change) > small*max(coordinate(top(1), bite%kind), last)) then
            means(1) = (top(1)%load*top(1)%approach - top(1)%work - (top(2)%load*top(2)%approach - top(2)%work))/change
            means(2) = (top(1)%work - top(2)%work)/change
         else
            means = 0
            do i = -1, 1
               call find_position(contact, bite%kind, last + change*(1 + i*node)/2, at_node, is_converged)
               means = means + merge(4.0_dp/9, 2.5_dp/9, i == 0)*[at_node%approach, at_node%load]
            end do
         end if
      end associate
   end subroutine find_means

   !> int F dg of a narrow segment, where F is a straight function of the position.
   pure real(dp) function narrow_loss(bite, means) result(loss)
      type(bite_t), intent(in) :: bite
      !> Means of approach and load.
      real(dp), intent(in) :: means(2)
      real(dp) :: width

      associate (low => bite%low, high => bite%high)
         width = high%approach - low%approach
         if (bite%kind == by_force) width = 2*bite%span/(low%stiffness + high%stiffness)
         loss = width*(means(2) - (low%load + high%load)/2) &
            & + (-width*(low%stiffness + high%stiffness)/2*(means(1) - (low%approach + high%approach)/2))
      end associate
   end function narrow_loss

   !> int F dg of a segment that is not narrow, by P, g and U at its ends.
   pure real(dp) function wide_loss(bite, means, slope) result(loss)
      type(bite_t), intent(in) :: bite
      !> Means of approach and load.
      real(dp), intent(in) :: means(2)
      !> How much the coordinate of the normal state falls over how much is eaten.
      real(dp), intent(in) :: slope
      real(dp) :: first, second, terms(5)

      associate (low => bite%low, high => bite%high, top => bite%top)
         if (bite%kind == by_force) then
            ! int P d(g) with P = P2 + slope (P(g) - P(low))
            first = (top(2)%load - slope*low%load)*(high%approach - low%approach) + slope*(high%work - low%work)
            second = means(1)*(high%load - low%load)
            terms = [first, -(high%work - low%work), -second, high%load*high%approach - low%load*low%approach, &
               & -(high%work - low%work)]
         else
            first = means(2)*(high%approach - low%approach)
            second = high%load*(top(1)%approach - high%approach) - low%load*(top(2)%approach - low%approach)
            terms = [first, -(high%work - low%work), -second, (slope - 1)*(high%work - low%work), 0.0_dp]
         end if
      end associate
      loss = sum(terms)
   end function wide_loss

   !> The same beside the edge: F = int [K(y) - K(g)] dy, g < y < delta, K = dP/dg, by Gauss's rule.
   pure subroutine add_small_loss(self, contact, factor, bite)
      class(slip_stack_t), intent(inout) :: self
      class(normal_contact_t), intent(in) :: contact
      !> 1 - s f.
      real(dp), intent(in) :: factor
      type(bite_t), intent(in) :: bite
      real(dp), parameter :: nodes(4) = [-0.8611363115940526_dp, -0.3399810435848563_dp, 0.3399810435848563_dp, &
         & 0.8611363115940526_dp]
      real(dp), parameter :: weights(4) = [0.3478548451374538_dp, 0.6521451548625461_dp, 0.6521451548625461_dp, &
         & 0.3478548451374538_dp]
      type(normal_state_t) :: position, edge, between
      real(dp) :: opening, part
      integer :: i, j

      associate (kind => bite%kind, low => bite%low, top => bite%top, span => bite%span, change => bite%change)
         do i = 1, size(nodes)
            call find_position(contact, kind, coordinate(low, kind) + span*(1 + nodes(i))/2, position, self%is_converged)
            edge = top(2)
            if (abs(change) > 0) call find_position(contact, kind, coordinate(top(2), kind) + change*(1 + nodes(i))/2, edge, &
               & self%is_converged)
            opening = max(edge%approach - position%approach, 0.0_dp)
            part = 0
            do j = 1, size(nodes)
               call find_position(contact, by_displacement, position%approach + opening*(1 + nodes(j))/2, between, &
                  & self%is_converged)
               part = part + weights(j)/2*opening*max(between%stiffness - position%stiffness, 0.0_dp)
            end do
            associate (weight => factor*weights(i)/2*span/merge(position%stiffness, 1.0_dp, kind == by_force))
               self%loss = self%loss + weight*part
               self%loss_error = self%loss_error + round_off*weight*(opening*position%stiffness + part*edge%approach/max(opening, &
                  & round_off*edge%approach))
            end associate
         end do
      end associate
   end subroutine add_small_loss

   !> Add what friction takes of a contact that slides as a whole: mu P over the path.
   pure subroutine add_sliding_loss(self, first, next, path)
      class(slip_stack_t), intent(inout) :: self
      !> The normal states where it begins to slide and at the end of the step.
      type(normal_state_t), intent(in) :: first, next
      !> How far it slides, over mu m.
      real(dp), intent(in) :: path
      real(dp) :: mean

      mean = (first%load + next%load)/2
      if (abs(next%approach - first%approach) > near*max(next%approach, first%approach)) &
         & mean = (next%work - first%work)/(next%approach - first%approach)
      self%loss = self%loss + path*mean
   end subroutine add_sliding_loss

end module adfric_interface_slip_loss

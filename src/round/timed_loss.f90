! SPDX-License-Identifier: GPL-3.0-or-later
!> The last moments of a contact whose load falls to 0. There the edge recedes as a power of the time that remains, and has no
!> digits: the force of a spring is a difference of approaches. So short a time is one panel in closed form.
!>
!> The time that remains is far below all relaxation times. A spring of force y is let go when the approach has fallen by
!>
!>     (E0 theta + sum_i E_i q_i exp(-t/t_i))/E_glassy,
!>
!> with the time t that has passed: then it has no force. What the arms forget of this fall meanwhile is left out: it is the fall
!> times t/t_i. Which spring is let go when changes what it remembers by no more; here the depth of the edge falls straight in time.
module adfric_round_timed_loss
   use adfric_base_kinds, only: dp
   use adfric_numerics_time_panels, only: n_nodes, panel_nodes
   use adfric_round_timed_panel, only: begin_panel, timed_panel_t
   use adfric_round_timed_path, only: falls_to_zero, prescribed_at, time_between
   use adfric_round_timed_springs, only: get_spot, mark_of, shrinking, thin_depth, timed_springs_t
   implicit none (type, external)
   private
   public :: ends_soon, solve_end

contains

   !> Is the time that remains so short that the closed form is as good as panels?
   pure logical function ends_soon(self)
      !> The springs at the begin of a panel.
      type(timed_springs_t), intent(in) :: self
      !> Shorter than any step that is written, and the part of what is tolerated that may be left out.
      real(dp), parameter :: last_phase = 1.0e-6_dp, share = 0.1_dp

      ends_soon = .not. self%control%by_approach > 0 .and. self%edge_mode == shrinking .and. 1 - self%phase <= last_phase
      if (ends_soon) ends_soon = falls_to_zero(self%legs(self%leg))
      if (ends_soon) ends_soon = left_out(self) <= thin_depth(self, share)
   end function ends_soon

   !> What the closed form leaves out of the approach.
   pure real(dp) function left_out(self)
      type(timed_springs_t), intent(in) :: self
      real(dp) :: arms(size(self%times))

      left_out = 0
      if (size(self%times) == 0) return
      call find_arms(self, 0.0_dp, arms)
      associate (force => self%relaxed*self%approach + sum(self%moduli*arms))
         left_out = abs(force)/self%glassy*self%legs(self%leg)%span*(1 - self%phase)/minval(self%times)
      end associate
   end function left_out

   !> The panel up to the end of the leg.
   pure subroutine solve_end(self, panel)
      !> The springs at its begin.
      type(timed_springs_t), intent(in) :: self
      !> Receives the panel.
      type(timed_panel_t), intent(inout) :: panel
      real(dp) :: arms(size(self%times)), faded(size(self%times)), fall, moment
      integer :: j

      call begin_panel(self, 1 - self%phase, panel)
      do j = 1, n_nodes
         panel%depth(j) = self%depth*(1 - panel_nodes(j))/2
         if (j == 1) then
            arms = self%at_edge
         else
            call find_arms(self, panel%depth(j), arms)
         end if
         faded = panel%faded(j, :)
         fall = (self%relaxed*(self%approach - panel%depth(j)) + sum(self%moduli*arms*faded))/self%glassy
         panel%approach(j) = self%approach - fall
         panel%rise(j) = -fall
         panel%drive(j, :) = self%drive*faded - fall
         panel%at_edge(j, :) = arms*faded - fall
         call get_spot(self%contacts, panel%depth(j), panel%radius(j), moment)
         ! q_i of what is in contact differs by depths alone
         panel%sums(j, :) = panel%radius(j)*panel%at_edge(j, :)
      end do
      panel%load = prescribed_at(self%legs(self%leg), panel%phase + panel%phase_span*(panel_nodes + 1)/2)
      panel%position = self%touched%ends(2, self%touched%count)
      panel%opening = -1
      panel%piece_end = 1
      panel%error = left_out(self)/self%depth_size/self%tolerance
   end subroutine solve_end

   !> The arms of the spring in contact that has a depth.
   pure subroutine find_arms(self, depth, arms)
      type(timed_springs_t), intent(in) :: self
      !> Its depth; the edge is deeper.
      real(dp), intent(in) :: depth
      !> Receives q_i; shape `(n_arms)`.
      real(dp), intent(out) :: arms(:)
      integer, parameter :: most_halvings = 60
      real(dp) :: memory(size(arms)), low, high, middle, at, since
      integer :: piece, k

      associate (pile => self%touched)
         do piece = pile%count, 1, -1
            call pile%read_at(piece, pile%ends(1, piece), at, memory)
            if (at <= depth) exit
         end do
         piece = max(1, piece)
         low = pile%ends(1, piece)
         high = pile%ends(2, piece)
         do k = 1, most_halvings
            middle = (low + high)/2
            if (.not. (middle > low .and. middle < high)) exit
            call pile%read_at(piece, middle, at, memory)
            if (at <= depth) then
               low = middle
            else
               high = middle
            end if
         end do
         call pile%read_at(piece, low, at, memory)
         since = time_between(self%legs, pile%marks(piece), mark_of(self))
         arms = self%drive + memory*exp(-pile%lag_of(piece, low, since)*pile%rates)
      end associate
   end subroutine find_arms

end module adfric_round_timed_loss

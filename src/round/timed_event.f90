! SPDX-License-Identifier: GPL-3.0-or-later
!> What ends a panel of a contact in time: the edge turns, it meets the begin of a piece of springs, contact is made, the edge
!> passes a corner of the profile.
module adfric_round_timed_event
   use adfric_base_kinds, only: dp
   use adfric_numerics_time_panels, only: find_fall, n_nodes
   use adfric_round_timed_panel, only: timed_panel_t
   use adfric_round_timed_springs, only: growing_again, lost, shrinking, thin_depth, timed_springs_t
   implicit none (type, external)
   private
   public :: find_event, by_time, by_turn, by_piece, by_contact, by_corner

   !> What ends a panel.
   integer, parameter :: by_time = 0, by_turn = 1, by_piece = 2, by_contact = 3, by_corner = 4

contains

   !> The first event of a panel.
   pure subroutine find_event(self, panel, event, end)
      !> The springs at the begin of the panel.
      type(timed_springs_t), intent(in) :: self
      !> The panel, as far as it was tried.
      type(timed_panel_t), intent(in) :: panel
      !> Receives one of `by_...`.
      integer, intent(out) :: event
      !> Receives its position in the panel, from -1 to 1.
      real(dp), intent(out) :: end
      ! derivatives at the nodes of a panel lose two digits; at the edge the approach has no more than its own
      real(dp), parameter :: noise = 2048*epsilon(1.0_dp), round_off = 64*epsilon(1.0_dp)
      real(dp) :: small, beyond

      event = by_time
      end = 2
      small = thin_depth(self, 1.0e-2_dp)
      if (self%edge_mode /= lost) small = max(small, noise*maxval(abs(panel%rise)), round_off*maxval(abs(panel%approach)))
      select case (self%edge_mode)
      case (lost)
         if (abs(self%control%by_approach) > 0) call look(-panel%depth, small, by_contact, event, end)
      case (shrinking)
         call look(-panel%opening, small, by_turn, event, end)
         call look(panel%piece_end, 0.0_dp, by_piece, event, end)
      case (growing_again)
         call look(panel%opening, small, by_turn, event, end)
         call look(panel%piece_end, 0.0_dp, by_piece, event, end)
      case default
         call look(panel%opening, small, by_turn, event, end)
      end select
      if (self%edge_mode /= lost .and. self%contacts%kink > 0) then
         beyond = self%depth - self%contacts%kink
         if (abs(beyond) > small) &
            & call look((panel%depth - self%contacts%kink)*sign(1.0_dp, beyond), 0.0_dp, by_corner, event, end)
      end if
   end subroutine find_event

   !> Keep an event that comes before those that are known.
   pure subroutine look(values, small, kind, event, end)
      !> Values at the nodes: the event is where they fall below 0.
      real(dp), intent(in) :: values(n_nodes)
      !> What is round-off.
      real(dp), intent(in) :: small
      !> One of `by_...`.
      integer, intent(in) :: kind
      !> What is first so far, and where.
      integer, intent(inout) :: event
      real(dp), intent(inout) :: end
      real(dp) :: root

      root = find_fall(values, small)
      if (root >= end) return
      end = root
      event = kind
   end subroutine look

end module adfric_round_timed_event

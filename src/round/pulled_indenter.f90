! SPDX-License-Identifier: GPL-3.0-or-later
!> The path of an indenter from rest to sliding as a contact that is pulled through a spring, reduced (J 2.11).
!>
!> Its positions are z, the root of g over that of the end of the path. Where a piece ends in sliding, as contact is lost, or as the
!> edge of contact passes a corner of the profile, radii or angles go there by the root of the distance, which z = z1 + (z2 - z1) y
!> (2 - y) makes smooth in y. The path is divided where a or c passes the corner. Where slip takes no more from adhesion before the
!> centre slips, a last piece follows, along which the angle th grows alone.
module adfric_round_pulled_indenter
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi
   use adfric_round_interaction_path, only: end_capped, get_known_waypoint, interaction_path_t, waypoint_t
   use adfric_round_pulled_contact, only: pulled_contact_t, pulled_curve_t, take_curve
   use adfric_round_shrinking_path, only: displacement_of, force_of, turn
   implicit none (type, external)
   private
   public :: pulled_indenter_t, take_indenter_curve, get_waypoint_of

   !> Corners that a path may pass: with a, and with c.
   integer, parameter :: most_corners = 2
   !> Halvings that leave round-off of a position.
   integer, parameter :: most_halvings = 60

   !> The contact.
   type, extends(pulled_contact_t) :: pulled_indenter_t
      !> Its path, known up to its end.
      class(interaction_path_t), allocatable :: path
      !> The end of the part where the contact changes.
      type(waypoint_t) :: finish
      !> Does slip take no more from there on?
      logical :: is_capped = .false.
      !> Pieces of the part where the contact changes, and their ends in z.
      integer :: n_changing = 1
      !> The ends, of which the first is 0 and the last one 1.
      real(dp) :: ends(0:most_corners + 1) = 0
   contains
      procedure :: get_state
   end type pulled_indenter_t

contains

   !> Take the path of an indenter.
   pure subroutine take_indenter_curve(path, sliding_force, curve, contact)
      !> The path from rest, whose end has been found.
      class(interaction_path_t), intent(in) :: path
      !> Force of sliding; below 0 where contact is lost.
      real(dp), intent(in) :: sliding_force
      type(pulled_curve_t), intent(out) :: curve
      type(pulled_indenter_t), intent(out) :: contact

      allocate (contact%path, source=path)
      contact%finish = path%finish
      contact%is_capped = path%ending == end_capped
      contact%slides = sliding_force >= 0
      contact%force_after = max(sliding_force, 0.0_dp)
      if (path%is_weakened) then
         call divide(contact)
      else
         ! all of the path is one contact, whose angle grows alone
         contact%n_changing = 0
         contact%is_capped = .true.
         call turn(0.0_dp, contact%finish)
      end if
      contact%n_pieces = contact%n_changing + merge(1, 0, contact%is_capped)
      call take_curve(contact, curve)
   end subroutine take_indenter_curve

   !> Divide the path where the edges of contact and of adhesion pass the corner.
   pure subroutine divide(self)
      !> In: the contact. Out: with its pieces.
      type(pulled_indenter_t), intent(inout) :: self
      real(dp) :: low, high, z
      integer :: corner, k, n

      n = 0
      do corner = self%path%n_passed(self%path%start%contact) + 1, self%path%n_passed(self%finish%contact)
         low = self%ends(n)
         high = 1
         do k = 1, most_halvings
            z = low + (high - low)/2
            if (.not. (z > low .and. z < high)) exit
            if (is_passed(self, corner, z)) then
               high = z
            else
               low = z
            end if
         end do
         if (high < 1 .and. high > self%ends(n)) then
            n = n + 1
            self%ends(n) = high
         end if
      end do
      self%n_changing = n + 1
      self%ends(n + 1) = 1
   end subroutine divide

   !> Has a corner been passed at a position?
   pure logical function is_passed(self, corner, z)
      type(pulled_indenter_t), intent(in) :: self
      !> Number of the corner.
      integer, intent(in) :: corner
      !> The position, 0 to 1.
      real(dp), intent(in) :: z
      type(waypoint_t) :: waypoint

      call get_waypoint_at(self, z, waypoint)
      is_passed = self%path%n_passed(waypoint%contact) >= corner
   end function is_passed

   !> See `pulled_contact_t`.
   pure subroutine get_state(self, piece, position, displacement, force)
      class(pulled_indenter_t), intent(in) :: self
      integer, intent(in) :: piece
      real(dp), intent(in) :: position
      real(dp), intent(out) :: displacement, force
      type(waypoint_t) :: waypoint

      displacement = 0
      force = 0
      if (piece == 1 .and. .not. position > 0) return
      call get_waypoint_of(self, piece, position, waypoint)
      displacement = displacement_of(self%path, waypoint)
      force = force_of(self%path, waypoint)
   end subroutine get_state

   !> The state at a position of a piece.
   pure subroutine get_waypoint_of(self, piece, position, waypoint)
      class(pulled_indenter_t), intent(in) :: self
      integer, intent(in) :: piece
      !> Position in the piece, 0 to 1.
      real(dp), intent(in) :: position
      type(waypoint_t), intent(out) :: waypoint
      real(dp) :: share

      if (piece > self%n_changing) then
         waypoint = self%finish
         call turn(self%finish%angle + (half_pi - self%finish%angle)*position, waypoint)
      else
         share = position*(2 - position)
         if (piece == self%n_changing .and. self%is_capped) share = position
         call get_waypoint_at(self, self%ends(piece - 1) + (self%ends(piece) - self%ends(piece - 1))*share, waypoint)
      end if
   end subroutine get_waypoint_of

   !> The state at a position of the part where the contact changes.
   pure subroutine get_waypoint_at(self, z, waypoint)
      class(pulled_indenter_t), intent(in) :: self
      real(dp), intent(in) :: z
      type(waypoint_t), intent(out) :: waypoint

      waypoint = self%finish
      if (z >= 1) return
      call get_known_waypoint(self%path, self%finish%slip_energy*z**2, waypoint)
      ! round-off beyond the last contact
      if (.not. waypoint%is_found) waypoint = self%finish
   end subroutine get_waypoint_at

end module adfric_round_pulled_indenter

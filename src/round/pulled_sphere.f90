! SPDX-License-Identifier: GPL-3.0-or-later
!> The path of a sphere from rest to sliding as a contact that is pulled through a spring, reduced (J 2.11).
!>
!> Its positions are those of the path, z = sqrt(g); where that ends in sliding or as contact is lost, radii or angles go there by
!> the root of the distance, and z = z_end y (2 - y) makes them smooth in y. Where slip takes no more from adhesion before the
!> centre slips, a second piece follows, along which the angle arccos gamma grows alone.
module adfric_round_pulled_sphere
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi
   use adfric_round_pulled_contact, only: pulled_contact_t, pulled_curve_t, take_curve
   use adfric_round_sphere_peeling_path, only: peeling_path_t, peeling_waypoint_t, get_waypoint, quantity_of, force_along, &
      & displacement_along, &
      & end_capped
   use adfric_round_sphere_peeling_search, only: get_capped
   implicit none (type, external)
   private
   public :: pulled_sphere_t, take_sphere_curve, get_waypoint_of

   !> The contact.
   type, extends(pulled_contact_t) :: pulled_sphere_t
      !> Its path, whose end is known.
      type(peeling_path_t) :: path
   contains
      procedure :: get_state
   end type pulled_sphere_t

contains

   !> Take the path of a sphere.
   pure subroutine take_sphere_curve(path, sliding_force, curve, contact)
      !> The path from rest to sliding, whose end is known.
      type(peeling_path_t), intent(in) :: path
      !> Force of sliding; below 0 where contact is lost.
      real(dp), intent(in) :: sliding_force
      type(pulled_curve_t), intent(out) :: curve
      !> Receives the contact that is pulled.
      type(pulled_sphere_t), intent(out) :: contact

      contact%path = path
      contact%slides = sliding_force >= 0
      contact%force_after = max(sliding_force, 0.0_dp)
      contact%n_pieces = merge(2, 1, path%ending == end_capped)
      call take_curve(contact, curve)
   end subroutine take_sphere_curve

   !> See `pulled_contact_t`.
   pure subroutine get_state(self, piece, position, displacement, force)
      class(pulled_sphere_t), intent(in) :: self
      integer, intent(in) :: piece
      !> Position in the piece, 0 to 1.
      real(dp), intent(in) :: position
      !> Receive D and T.
      real(dp), intent(out) :: displacement, force
      type(peeling_waypoint_t) :: waypoint

      displacement = 0
      force = 0
      if (piece == 1 .and. .not. position > 0) return
      call get_waypoint_of(self%path, piece, position, waypoint)
      displacement = quantity_of(self%path, displacement_along, waypoint)
      force = quantity_of(self%path, force_along, waypoint)
   end subroutine get_state

   !> The state at a position of a piece.
   pure subroutine get_waypoint_of(path, piece, position, waypoint)
      type(peeling_path_t), intent(in) :: path
      integer, intent(in) :: piece
      !> Position in the piece, 0 to 1.
      real(dp), intent(in) :: position
      type(peeling_waypoint_t), intent(out) :: waypoint
      real(dp) :: z

      if (piece == 2) then
         call get_capped(path%finish, path%finish%angle + (half_pi - path%finish%angle)*position, waypoint)
      else if (position >= 1) then
         waypoint = path%finish
      else
         z = position
         if (path%ending /= end_capped) z = position*(2 - position)
         call get_waypoint(path, path%finish%slip_energy*z**2, path%start%contact, waypoint)
         ! round-off beyond the last contact
         if (.not. waypoint%is_found) waypoint = path%finish
      end if
   end subroutine get_waypoint_of

end module adfric_round_pulled_sphere

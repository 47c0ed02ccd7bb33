! SPDX-License-Identifier: GPL-3.0-or-later
!> What an indenter of any axisymmetric shape is to its contact (Galin 1946; Sneddon, Int. J. Eng. Sci. 3, 1965, 47): the function
!>
!>     g(x) = x int f'(r)/sqrt(x^2 - r^2) dr,  0 < r < x,      P1(a) = 2 int [g(a) - g(x)] dx,  0 < x < a
!>
!> of the profile f, and the load P1 of a contact of radius a without adhesion. Here and in all other files of this folder but
!> `case`, lengths in the plane of contact are in a unit L, heights in a unit H, and forces in E* L H (`case` has the units).
!>
!> A contact is not known by its radius a, which has no digits left where a contact has hardly left a flat face of radius b, but by
!> u: beyond a corner b of the profile u = v = sqrt(a^2 - b^2), within it u = a, on a flat face u = a/sqrt(b^2 - a^2). A shape without corner has b = 0, and v = a; a
!> sphere has u = artanh(a/R).
module adfric_round_shape
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: shape_t, spot_t, piece_t, most_pieces, within_edge

   !> Most pieces of a shape.
   integer, parameter :: most_pieces = 3
   !> Contacts and zones that come nearer to a vertical edge of the profile than this share of its radius are left out: the profile has
   !> no digits there.
   real(dp), parameter :: within_edge = 1.0_dp - 1.0e-6_dp

   !> What a shape is at a radius a of contact.
   type :: spot_t
      !> Radius a of contact.
      real(dp) :: radius = 0
      !> v = sqrt(a^2 - b^2) beyond the corner; on a flat face sqrt(b^2 - a^2).
      real(dp) :: beyond = 0
      !> da/du, and its derivative by u.
      real(dp) :: radius_slope = 1, radius_curve = 0
      !> g(a), the approach without adhesion.
      real(dp) :: depth = 0
      !> dg/du, and its derivative by u.
      real(dp) :: depth_slope = 0, depth_curve = 0
      !> P1(a), the load without adhesion.
      real(dp) :: load = 0
   end type spot_t

   !> A range of u where sqrt(a) g'(a) rises, or falls.
   type :: piece_t
      !> Does it lie beyond the corner?
      logical :: is_beyond = .true.
      !> Ends of the range; the last piece of a shape has no end.
      real(dp) :: low = 0, high = huge(1.0_dp)
   end type piece_t

   !> A shape. Its n_pieces pieces cover all contacts that may be stable, from the smallest to the largest.
   type, abstract :: shape_t
      !> Radius b of the corner; 0 if there is none.
      real(dp) :: corner = 0
      !> Is the profile flat up to the corner, so that no smaller contact is stable?
      logical :: has_face = .false.
      !> Does g' never fall, so that a curve of Maugis's theory has at most one fold?
      logical :: has_rising_slope = .true.
      !> dg/dv is analytic up to this |v| about 0; 0 if it is not even there.
      real(dp) :: reach = 0
      !> Radius where the profile ends, since it is vertical there.
      real(dp) :: edge = huge(1.0_dp)
      !> dg/dv is like this power of v where v is small.
      real(dp) :: onset = 1
      !> Number of pieces; 0 for a face without an edge that rises, which is in contact all over.
      integer :: n_pieces = 1
      !> The pieces; shape `(most_pieces)`, of which the first `n_pieces` have a meaning.
      type(piece_t) :: pieces(most_pieces)
   contains
      procedure(evaluate_i), deferred :: evaluate
      procedure(unknown_of_i), deferred :: unknown_of
      procedure(get_end_i), deferred :: get_end
      procedure(rise_i), deferred :: rise
      procedure(inner_rise_i), deferred :: inner_rise
      procedure(energy_i), deferred :: energy
      procedure(get_profile_i), deferred :: get_profile
      procedure(radius_of_height_i), deferred :: radius_of_height
      procedure(get_closed_annulus_i), deferred :: get_closed_annulus
   end type shape_t

   abstract interface

      !> The spot of an unknown u.
      pure subroutine evaluate_i(self, u, is_beyond, spot)
         import :: shape_t, spot_t, dp
         implicit none (type, external)
         !> The shape that is evaluated.
         class(shape_t), intent(in) :: self
         !> The unknown, >= 0.
         real(dp), intent(in) :: u
         !> Is u one of those beyond the corner?
         logical, intent(in) :: is_beyond
         !> Receives what the shape is there.
         type(spot_t), intent(out) :: spot
      end subroutine evaluate_i

      !> The unknown u of a radius.
      elemental real(dp) function unknown_of_i(self, radius)
         import :: shape_t, dp
         implicit none (type, external)
         !> The shape that is asked.
         class(shape_t), intent(in) :: self
         !> Radius a of contact, >= 0; of a sphere less than its own radius.
         real(dp), intent(in) :: radius
      end function unknown_of_i

      !> An unknown beyond which sqrt(a) g'(a) is larger than a given number.
      pure real(dp) function get_end_i(self, target)
         import :: shape_t, dp
         implicit none (type, external)
         class(shape_t), intent(in) :: self
         !> The number, > 0.
         real(dp), intent(in) :: target
      end function get_end_i

      !> dg/dv = g'(x) v/x beyond the corner.
      elemental real(dp) function rise_i(self, v)
         import :: shape_t, dp
         implicit none (type, external)
         class(shape_t), intent(in) :: self
         !> v = sqrt(x^2 - b^2), > 0.
         real(dp), intent(in) :: v
      end function rise_i

      !> g'(x)/x within the corner, where g' is proportional to x.
      pure real(dp) function inner_rise_i(self)
         import :: shape_t, dp
         implicit none (type, external)
         class(shape_t), intent(in) :: self
      end function inner_rise_i

      !> The profile f(r) and its slope.
      pure subroutine get_profile_i(self, r, height, slope)
         import :: shape_t, dp
         implicit none (type, external)
         class(shape_t), intent(in) :: self
         !> Distance from the axis, >= 0.
         real(dp), intent(in) :: r
         !> f and f'.
         real(dp), intent(out) :: height, slope
      end subroutine get_profile_i

      !> A radius where the profile is at least as high as a given height, and not much higher.
      pure real(dp) function radius_of_height_i(self, height)
         import :: shape_t, dp
         implicit none (type, external)
         class(shape_t), intent(in) :: self
         !> The height, > 0.
         real(dp), intent(in) :: height
      end function radius_of_height_i

      !> J and I of `adfric_round_annulus` where they are closed forms.
      pure subroutine get_closed_annulus_i(self, spot, is_beyond, s, opening, intensity, is_closed)
         import :: shape_t, spot_t, dp
         implicit none (type, external)
         class(shape_t), intent(in) :: self
         !> What the shape is at the contact.
         type(spot_t), intent(in) :: spot
         !> Does the contact reach beyond the corner?
         logical, intent(in) :: is_beyond
         !> s = sqrt(c^2 - a^2), > 0.
         real(dp), intent(in) :: s
         !> Receive J and I; 0 where they are not closed forms.
         real(dp), intent(out) :: opening, intensity
         !> Are they closed forms here that lose no digits?
         logical, intent(out) :: is_closed
      end subroutine get_closed_annulus_i

      !> int [g(a) - g(x)]^2 dx from 0 to a: the elastic energy without adhesion, over E* L H^2.
      pure real(dp) function energy_i(self, u, is_beyond)
         import :: shape_t, dp
         implicit none (type, external)
         class(shape_t), intent(in) :: self
         !> The unknown of the contact, >= 0.
         real(dp), intent(in) :: u
         logical, intent(in) :: is_beyond
      end function energy_i

   end interface

end module adfric_round_shape

! SPDX-License-Identifier: GPL-3.0-or-later
!> Shapes with a corner at r = b, in units b of length and of height k b or b^2/R: with v = sqrt(a^2 - b^2), phi = arctan(v/b) and
!> b = 1, beyond the corner
!>
!>     flat_cone          f = r - 1          g = a phi             P1 = a^2 phi + v
!>     flat_paraboloid    f = (r^2 - 1)/2    g = a v               P1 = 2 v (2 a^2 + 1)/3
!>     rounded_punch      f = (r - 1)^2/2    g = a (v - phi)       P1 = a^2 (v - phi) + v^3/3
!>     rounded_cone       f = r - 1/2        g = a phi + a/(a + v)   P1 = a^2 phi + (4/3) a^2/(a + v) + v/3
!>
!> Within the corner there is a flat face; the rounded cone has f = r^2/2, g = a^2, P1 = 4 a^3/3.
!>
!> sqrt(a) g'(a) of the flat cone and the flat paraboloid is infinite at the corner, falls to a least value and rises; that of the
!> rounded punch rises from 0; that of the rounded cone rises up to the corner, falls to a least value, and rises.
module adfric_round_corner_shape
   use adfric_base_kinds, only: dp
   use adfric_round_closed_annulus, only: add_power_annulus, get_cone_annulus, get_paraboloid_annulus, get_punch_annulus, &
      & get_rounded_cone_annulus, less_arctan
   use adfric_round_corner_energy, only: corner_energy
   use adfric_round_corner_kinds, only: flat_face, flat_cone, flat_paraboloid, rounded_punch, rounded_cone
   use adfric_round_shape, only: shape_t, spot_t, piece_t
   implicit none (type, external)
   private
   public :: corner_shape_t, new_corner_shape, flat_face, flat_cone, flat_paraboloid, rounded_punch, rounded_cone

   !> v where sqrt(a) g'(a) is least: the roots of v^3 phi + v^2 = 2, of 6 v^4 + 3 v^2 = 2, and of
   !> v [phi (a + v) + 2] (a + v) = 2.
   real(dp), parameter :: least_of_cone = 1.0424561234141567_dp, least_of_paraboloid = 0.6157539034434908_dp, &
      & least_of_rounded_cone = 0.4709827637930153_dp

   !> A shape with a corner.
   type, extends(shape_t) :: corner_shape_t
      !> One of the kinds above.
      integer :: kind = flat_cone
   contains
      procedure :: evaluate
      procedure :: unknown_of
      procedure :: get_end
      procedure :: rise
      procedure :: inner_rise
      procedure :: energy
      procedure :: get_profile
      procedure :: radius_of_height
      procedure :: get_closed_annulus
   end type corner_shape_t

contains

   !> The shape of a kind.
   pure subroutine new_corner_shape(self, kind)
      type(corner_shape_t), intent(out) :: self
      !> One of the kinds of this file.
      integer, intent(in) :: kind
      real(dp) :: least

      self%corner = 1
      self%reach = 1
      self%kind = kind
      self%has_face = kind /= rounded_cone
      self%has_rising_slope = kind == rounded_punch
      select case (kind)
      case (flat_cone)
         least = least_of_cone
         self%onset = 0
      case (flat_paraboloid)
         least = least_of_paraboloid
         self%onset = 0
      case (rounded_cone)
         least = least_of_rounded_cone
      case (rounded_punch)
         self%onset = 2
         return
      case default
         self%n_pieces = 0
         return
      end select
      self%n_pieces = 2
      self%pieces(1)%high = least
      self%pieces(2)%low = least
      if (kind /= rounded_cone) return
      self%n_pieces = 3
      self%pieces(2:3) = self%pieces(1:2)
      self%pieces(1) = piece_t(.false., 0.0_dp, 1.0_dp)
   end subroutine new_corner_shape

   !> See `shape_t`.
   pure subroutine evaluate(self, u, is_beyond, spot)
      class(corner_shape_t), intent(in) :: self
      real(dp), intent(in) :: u
      logical, intent(in) :: is_beyond
      type(spot_t), intent(out) :: spot

      if (is_beyond) then
         spot%beyond = u
         spot%radius = sqrt(1 + u*u)
         spot%radius_slope = u/spot%radius
         spot%radius_curve = 1/spot%radius**3
         call evaluate_beyond(self%kind, u, spot%radius, spot)
      else if (self%kind == rounded_cone) then
         spot%radius = u
         spot%depth = u*u
         spot%depth_slope = 2*u
         spot%depth_curve = 2
         spot%load = 4*u**3/3
      else
         spot%beyond = 1/sqrt(1 + u*u)
         spot%radius = u*spot%beyond
         spot%radius_slope = spot%beyond**3
         spot%radius_curve = -3*u*spot%beyond**5
      end if
   end subroutine evaluate

   !> g, its derivatives by v, and P1 beyond the corner.
   pure subroutine evaluate_beyond(kind, v, a, spot)
      integer, intent(in) :: kind
      !> v = sqrt(a^2 - 1), >= 0.
      real(dp), intent(in) :: v
      !> Radius a of contact.
      real(dp), intent(in) :: a
      !> Receives g, its derivatives and P1.
      type(spot_t), intent(inout) :: spot
      real(dp) :: phi, rest

      select case (kind)
      case (flat_cone)
         phi = atan(v)
         spot%depth = a*phi
         spot%depth_slope = (phi*v + 1)/a
         spot%depth_curve = phi/a**3
         spot%load = a*a*phi + v
      case (flat_paraboloid)
         spot%depth = a*v
         spot%depth_slope = (2*v*v + 1)/a
         spot%depth_curve = v*(2*v*v + 3)/a**3
         spot%load = 2*v*(2*a*a + 1)/3
      case (rounded_punch)
         rest = less_arctan(v)
         spot%depth = a*rest
         spot%depth_slope = v*(v + rest)/a
         spot%depth_curve = (2*v*a*a + rest)/a**3
         spot%load = a*a*rest + v**3/3
      case (rounded_cone)
         phi = atan(v)
         spot%depth = a*phi + a/(a + v)
         spot%depth_slope = v*(phi + 2/(a + v))/a
         spot%depth_curve = phi/a**3 + 2 - v*(2*v*v + 3)/a**3
         spot%load = a*a*phi + 4*a*(a/(a + v))/3 + v/3
      end select
   end subroutine evaluate_beyond

   !> See `shape_t`.
   elemental real(dp) function unknown_of(self, radius)
      class(corner_shape_t), intent(in) :: self
      real(dp), intent(in) :: radius

      unknown_of = radius
      if (radius >= self%corner) then
         unknown_of = sqrt((radius - self%corner)*(radius + self%corner))
      else if (self%has_face) then
         unknown_of = radius/sqrt((self%corner - radius)*(self%corner + radius))
      end if
   end function unknown_of

   !> See `shape_t`: sqrt(a) g' is above sqrt(a) phi, 2 v^(3/2) and v^(3/2).
   pure real(dp) function get_end(self, target)
      class(corner_shape_t), intent(in) :: self
      real(dp), intent(in) :: target
      real(dp), parameter :: margin = 1.0_dp + 1.0e-6_dp

      select case (self%kind)
      case (flat_cone, rounded_cone)
         ! phi >= pi/4
         get_end = max(2.0_dp, margin*(1.28_dp*target)**2)
      case (flat_paraboloid)
         get_end = max(2.0_dp, margin*(target/2)**(2.0_dp/3))
      case default
         get_end = margin*target**(2.0_dp/3)
      end select
   end function get_end

   !> See `shape_t`.
   elemental real(dp) function rise(self, v)
      class(corner_shape_t), intent(in) :: self
      real(dp), intent(in) :: v
      real(dp) :: x

      x = sqrt(1 + v*v)
      select case (self%kind)
      case (flat_cone)
         rise = (atan(v)*v + 1)/x
      case (flat_paraboloid)
         rise = (2*v*v + 1)/x
      case (rounded_punch)
         rise = v*(v + less_arctan(v))/x
      case (rounded_cone)
         rise = v*(atan(v) + 2/(x + v))/x
      case default
         rise = 0
      end select
   end function rise

   !> See `shape_t`.
   pure real(dp) function inner_rise(self)
      class(corner_shape_t), intent(in) :: self

      inner_rise = 0
      if (self%kind == rounded_cone) inner_rise = 2
   end function inner_rise

   !> See `shape_t`.
   pure real(dp) function energy(self, u, is_beyond)
      class(corner_shape_t), intent(in) :: self
      real(dp), intent(in) :: u
      logical, intent(in) :: is_beyond

      energy = 0
      if (is_beyond) then
         energy = corner_energy(self%kind, u)
      else if (self%kind == rounded_cone) then
         energy = 8*u**5/15
      end if
   end function energy

   !> See `shape_t`.
   pure subroutine get_profile(self, r, height, slope)
      class(corner_shape_t), intent(in) :: self
      real(dp), intent(in) :: r
      real(dp), intent(out) :: height, slope

      height = 0
      slope = 0
      if (self%kind == rounded_cone .and. r <= 1) then
         height = r**2/2
         slope = r
      else if (r > 1) then
         slope = 1
         if (self%kind == flat_paraboloid) slope = r
         if (self%kind == rounded_punch) slope = r - 1
         height = r - 1
         if (self%kind == flat_paraboloid) height = (r - 1)*(r + 1)/2
         if (self%kind == rounded_punch) height = (r - 1)**2/2
         if (self%kind == rounded_cone) height = r - 0.5_dp
      end if
   end subroutine get_profile

   !> See `shape_t`.
   pure real(dp) function radius_of_height(self, height)
      class(corner_shape_t), intent(in) :: self
      real(dp), intent(in) :: height

      select case (self%kind)
      case (flat_cone)
         radius_of_height = 1 + height
      case (flat_paraboloid)
         radius_of_height = sqrt(1 + 2*height)
      case (rounded_punch)
         radius_of_height = 1 + sqrt(2*height)
      case (rounded_cone)
         radius_of_height = max(sqrt(2*min(height, 0.5_dp)), height + 0.5_dp)
      case default
         radius_of_height = 1
      end select
   end function radius_of_height

   !> See `shape_t`: beside small contacts those of `rounded_punch` and `rounded_cone` lose digits.
   pure subroutine get_closed_annulus(self, spot, is_beyond, s, opening, intensity, is_closed)
      class(corner_shape_t), intent(in) :: self
      type(spot_t), intent(in) :: spot
      logical, intent(in) :: is_beyond
      real(dp), intent(in) :: s
      real(dp), intent(out) :: opening, intensity
      logical, intent(out) :: is_closed
      ! J is smaller than its terms by V, and of a punch by V^2
      real(dp), parameter :: least_square_of_cone = 0.04_dp, least_square_of_punch = 0.4_dp
      real(dp) :: v, width

      opening = 0
      intensity = 0
      if (self%kind == rounded_cone .and. .not. is_beyond) then
         is_closed = spot%radius**2 + s**2 <= 1
         if (is_closed) call add_power_annulus(2, 1.0_dp, spot%radius, s, opening, intensity)
         return
      end if
      is_closed = .true.
      v = spot%beyond
      width = s
      if (.not. is_beyond) then
         ! the annulus begins at the corner
         if (.not. s > spot%beyond) return
         v = 0
         width = sqrt((s - spot%beyond)*(s + spot%beyond))
      end if
      select case (self%kind)
      case (flat_cone)
         call get_cone_annulus(v, width, opening, intensity)
      case (flat_paraboloid)
         call get_paraboloid_annulus(v, width, opening, intensity)
      case (rounded_punch)
         is_closed = .not. is_beyond .or. v**2 + s**2 > least_square_of_punch
         if (is_closed) call get_punch_annulus(v, width, opening, intensity)
      case (rounded_cone)
         is_closed = v**2 + s**2 > least_square_of_cone
         if (is_closed) call get_rounded_cone_annulus(spot%radius, v, s, opening, intensity)
      end select
      if (is_closed .and. is_beyond) opening = opening + spot%depth*less_arctan(s/spot%radius)
   end subroutine get_closed_annulus

end module adfric_round_corner_shape

! SPDX-License-Identifier: GPL-3.0-or-later
!> Integrals over the annulus a < x < c of a zone of adhesion:
!>
!>     J = int g'(x) arccos(x/c) dx,    I = int g'(x) x/sqrt(c^2 - x^2) dx,    K = int [g(x) - g(a)] sqrt(c^2 - x^2) dx
!>
!> J is pi/2 times the gap at c that the profile makes; I is c dJ/dc at given a; K = int g' [c^2 arccos(x/c) - x y]/2 dx. With
!> y = sqrt(c^2 - x^2), v = sqrt(x^2 - b^2) and V = sqrt(c^2 - b^2), beyond a corner b
!>
!>     dx g' = dv dg/dv,   v = V cos(t),  y = V sin(t),   0 < t < arctan(s/v_a),   s = sqrt(c^2 - a^2)
!>
!> c is given by s, which has all digits where the annulus is narrow. All integrands are positive. Where dg/dv is analytic for |v| < V
!> one range of Gauss's rule does; else t ends at 1.1, and what remains is integrated over ln v, and over v where dg/dv is analytic.
!> Where t ends at 0.7, 10 nodes do: the nearest singularities are at cos(t) = 0 or i b/V, outside the ellipse around the range whose
!> axes sum up to 6.8 times half of it, and 6.8^-20 is round-off.
!> Where the shape has closed forms of J and I (`adfric_round_closed_annulus`) they are taken.
module adfric_round_annulus
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi
   use adfric_round_shape, only: shape_t, spot_t
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights, gauss_nodes_10, gauss_weights_10
   implicit none (type, external)
   private
   public :: get_annulus

   !> Where ranges of t end: towards v = 0, and, beside a vertical edge of the profile, towards the edge.
   real(dp), parameter :: last_angle = 1.1_dp, edge_angle = 0.5_dp
   !> Up to this angle 10 nodes do.
   real(dp), parameter :: narrow_angle = 0.7_dp
   !> Longest panel of ln v, and where a decaying exponential is round-off.
   real(dp), parameter :: longest = 2.0_dp, decayed = 40.0_dp
   !> Ways along which the integrals are taken.
   integer, parameter :: along_angle = 1, along_edge = 2, along_logarithm = 3, along_v = 4

contains

   !> J and I, and K where it is asked for.
   pure subroutine get_annulus(shape, spot, is_beyond, s, opening, intensity, moment)
      class(shape_t), intent(in) :: shape
      type(spot_t), intent(in) :: spot
      !> Does the contact reach beyond the corner?
      logical, intent(in) :: is_beyond
      !> s = sqrt(c^2 - a^2), >= 0.
      real(dp), intent(in) :: s
      !> Receive J and I.
      real(dp), intent(out) :: opening, intensity
      !> Receives K.
      real(dp), intent(out), optional :: moment
      real(dp) :: first, largest, c, sums(3), square
      logical :: is_closed

      if (s > 0 .and. .not. present(moment)) then
         call shape%get_closed_annulus(spot, is_beyond, s, opening, intensity, is_closed)
         if (is_closed) return
      end if
      sums = 0
      c = hypot(spot%radius, s)
      if (is_beyond) then
         first = spot%beyond
         largest = hypot(first, s)
      else
         first = 0
         square = (s - spot%beyond)*(s + spot%beyond)
         if (.not. shape%has_face) square = (c - shape%corner)*(c + shape%corner)
         largest = sqrt(max(square, 0.0_dp))
         if (shape%inner_rise() > 0) call add_inner(shape, spot%radius, c, largest, s, sums)
      end if
      if (largest > 0) call add_outer(shape, first, largest, merge(atan2(s, first), half_pi, is_beyond), sums)
      opening = sums(1)
      intensity = sums(2)
      if (present(moment)) moment = sums(3)
   end subroutine get_annulus

   !> What lies within the corner, where g' = q x and x = c cos(t):
   !> q c^2 int cos(t) [t sin(t), cos(t), c^2 (t - sin(t) cos(t)) sin(t)/2] dt.
   pure subroutine add_inner(shape, a, c, largest, s, sums)
      class(shape_t), intent(in) :: shape
      !> Radii of contact and of adhesion.
      real(dp), intent(in) :: a, c
      !> sqrt(c^2 - b^2), 0 if the adhesion ends within the corner.
      real(dp), intent(in) :: largest
      !> sqrt(c^2 - a^2).
      real(dp), intent(in) :: s
      !> The integrals, to which is added.
      real(dp), intent(inout) :: sums(3)
      real(dp) :: low, half, t
      integer :: node

      low = 0
      if (largest > 0) low = atan2(largest, shape%corner)
      half = (atan2(s, a) - low)/2
      do node = 1, size(gauss_nodes)
         t = low + half*(1 + gauss_nodes(node))
         sums = sums + shape%inner_rise()*c**2*half*gauss_weights(node)*cos(t) &
            & *[t*sin(t), cos(t), c**2*(t - sin(t)*cos(t))*sin(t)/2]
      end do
   end subroutine add_inner

   !> What lies beyond the corner.
   pure subroutine add_outer(shape, first, largest, angle, sums)
      class(shape_t), intent(in) :: shape
      !> v_a, where the range begins; 0 for a contact within the corner.
      real(dp), intent(in) :: first
      !> V, where it ends.
      real(dp), intent(in) :: largest
      !> Angle t of the beginning, arctan(s/v_a).
      real(dp), intent(in) :: angle
      real(dp), intent(inout) :: sums(3)
      real(dp) :: next, low, high, closeness

      next = 0
      if (shape%edge < huge(next)) then
         ! sin(t) = k sinh(q), k = sqrt(R^2 - c^2)/c: the integrand is singular at q = i pi/2
         next = min(angle, edge_angle)
         closeness = sqrt((shape%edge - largest)*(shape%edge + largest))/largest
         call add_range(shape, along_edge, closeness, largest, 0.0_dp, asinh(sin(next)/closeness), sums)
         if (.not. angle > next) return
      end if
      if (largest <= shape%reach .or. angle <= last_angle) then
         call add_range(shape, along_angle, 0.0_dp, largest, next, angle, sums)
         return
      end if
      call add_range(shape, along_angle, 0.0_dp, largest, next, last_angle, sums)
      high = largest*cos(last_angle)
      low = max(first, min(shape%reach, high))
      if (low < high) then
         next = decayed/(shape%onset + 1)
         if (low > 0) next = min(next, log(high/low))
         call add_range(shape, along_logarithm, high, largest, 0.0_dp, next, sums)
      end if
      if (first < min(shape%reach, high)) call add_range(shape, along_v, 0.0_dp, largest, first, min(shape%reach, high), sums)
   end subroutine add_outer

   !> Add the integrals along a range, by panels of bounded length.
   pure subroutine add_range(shape, path, scale, largest, low, high, sums)
      class(shape_t), intent(in) :: shape
      !> One of `along_...`.
      integer, intent(in) :: path
      !> The number k along the edge; the largest v along the logarithm.
      real(dp), intent(in) :: scale
      !> V.
      real(dp), intent(in) :: largest
      !> Ends of the range of the variable.
      real(dp), intent(in) :: low, high
      real(dp), intent(inout) :: sums(3)
      real(dp) :: half, position, v, y, x, slope, angle, part(3), nodes(size(gauss_nodes)), weights(size(gauss_nodes))
      integer :: panel, n_panels, node, n_nodes

      n_panels = 1
      if (path == along_edge .or. path == along_logarithm) n_panels = max(1, ceiling((high - low)/longest))
      half = (high - low)/(2*n_panels)
      n_nodes = size(gauss_nodes)
      nodes = gauss_nodes
      weights = gauss_weights
      if (path == along_angle .and. high <= narrow_angle) then
         n_nodes = size(gauss_nodes_10)
         nodes(:n_nodes) = gauss_nodes_10
         weights(:n_nodes) = gauss_weights_10
      end if
      part = 0
      do panel = 1, n_panels
         do node = 1, n_nodes
            position = low + half*(2*panel - 1 + nodes(node))
            ! slope is -dv over that of the variable, which falls with v along all ways but the last
            select case (path)
            case (along_angle)
               y = largest*sin(position)
               v = largest*cos(position)
               slope = y
            case (along_edge)
               y = largest*scale*sinh(position)
               v = sqrt((largest - y)*(largest + y))
               slope = y/v*largest*scale*cosh(position)
            case (along_logarithm)
               v = scale*exp(-position)
               y = sqrt((largest - v)*(largest + v))
               slope = v
            case default
               v = position
               y = sqrt((largest - v)*(largest + v))
               slope = 1
            end select
            ! without a corner t itself is the angle
            x = v
            angle = position
            if (shape%corner > 0) x = sqrt(shape%corner**2 + v*v)
            if (shape%corner > 0 .or. path /= along_angle) angle = atan2(y, x)
            part = part + weights(node)*shape%rise(v)*slope*[angle, x/y, ((x**2 + y**2)*angle - x*y)/2]
         end do
      end do
      sums = sums + half*part
   end subroutine add_range

end module adfric_round_annulus

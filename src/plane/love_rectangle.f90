! SPDX-License-Identifier: GPL-3.0-or-later
!> A constant pressure p on a rectangle of an elastic half-space (A. E. H. Love, Phil. Trans. R. Soc. Lond. A 228, 1929, 377).
!>
!> z points into the solid, tension is positive, and p presses. Boussinesq's stresses are derivatives along the surface of 1/R and
!> ln(R + z). Their integrals over the rectangle are sums over its corners, with the signs + - - +, of functions of X and Y from the
!> corner to the position, R^2 = X^2 + Y^2 + z^2:
!>
!>     A(X, Y) = atan(Y/X) - atan(z Y/(X R)),   Q = A(X, Y) + A(Y, X) = atan(X Y/(z R)),   L(X, Y) = ln(R + Y)
!>     s_xx = -(p/2 pi) [A(X, Y) + 2 nu A(Y, X) - z X Y/(R (X^2 + z^2))],   s_yy with X and Y exchanged
!>     s_zz = -(p/2 pi) [Q + z X Y/R (1/(X^2 + z^2) + 1/(Y^2 + z^2))]
!>     s_xy = -(p/2 pi) [(1 - 2 nu) ln(R + z) + z/R],   s_xz = (p/2 pi) z^2 Y/(R (X^2 + z^2)),   s_yz with X and Y exchanged
!>     u_x = -(p/4 pi G) {z L(X, Y) + (1 - 2 nu) [Y ln(R + z) + z L(X, Y) + X A(X, Y)]},   u_y with X and Y exchanged
!>     u_z = (p/4 pi G) {2 (1 - nu) [X L(X, Y) + Y L(Y, X)] - (1 - 2 nu) z Q}
!>
!> Far away the corners cancel. There a product of Gauss's rules of 16 nodes has the point loads: at a distance of three times the
!> larger side it is exact to round-off.
module adfric_plane_love_rectangle
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   use adfric_plane_boussinesq_cerruti, only: point_displacement, point_stress
   implicit none (type, external)
   private
   public :: rectangle_field

   !> Twice the digits: nearer corners cancel, too, where the rectangle is narrow.
   integer, parameter :: qp = selected_real_kind(30)
   !> Distance from the middle beyond which point loads are summed, in the larger half-width.
   real(dp), parameter :: far = 6
   !> Sums of corners below this, over their largest term, are round-off of what cancels: stresses of an incompressible solid beside the
   !> rectangle on the surface, for example.
   real(qp), parameter :: round_off = 64*epsilon(1.0_qp)

contains

   !> Stresses [s_xx, s_yy, s_zz, s_xy, s_yz, s_xz] over p, and displacements [u_x, u_y, u_z] times G/p; s_xy is NaN at a corner.
   pure subroutine rectangle_field(half_widths, poisson_ratio, position, stress, displacement)
      !> Half-widths a along x and b along y [m].
      real(dp), intent(in) :: half_widths(2)
      !> Poisson's ratio nu [-].
      real(dp), intent(in) :: poisson_ratio
      !> Coordinates x, y, z of the position, from the middle of the rectangle [m], z >= 0.
      real(dp), intent(in) :: position(3)
      !> Receives the stresses over p.
      real(dp), intent(out) :: stress(6)
      !> Receives the displacements times G/p [m].
      real(dp), intent(out) :: displacement(3)
      real(qp) :: s(6), u(3), x, y, total(6), moved(3), largest(6)
      real(dp) :: unit
      integer :: i, j

      unit = max(maxval(half_widths), maxval(abs(position)))
      stress = 0
      displacement = 0
      if (norm2(position/unit) > far*maxval(half_widths)/unit) then
         call sum_point_loads(half_widths/unit, poisson_ratio, position/unit, stress, displacement)
      else
         total = 0
         moved = 0
         largest = 1
         do j = 1, -1, -2
            do i = 1, -1, -2
               x = (real(position(1), qp) + i*real(half_widths(1), qp))/unit
               y = (real(position(2), qp) + j*real(half_widths(2), qp))/unit
               call corner_field(x, y, real(position(3), qp)/unit, real(poisson_ratio, qp), s, u)
               total = total + i*j*s
               moved = moved + i*j*u
               largest = max(largest, abs(s))
            end do
         end do
         where (abs(total) <= round_off*largest) total = 0
         stress = real(total, dp)/(2*pi)
         if (is_corner(half_widths, position)) stress(4) = not_a_number()
         displacement = real(moved, dp)/(4*pi)
      end if
      displacement = displacement*unit
   end subroutine rectangle_field

   !> Is a position a corner of the rectangle?
   pure logical function is_corner(half_widths, position)
      real(dp), intent(in) :: half_widths(2), position(3)

      is_corner = .not. any(abs([abs(position(:2)) - half_widths, position(3)]) > 0)
   end function is_corner

   !> The field of the point loads at the nodes of Gauss's rules.
   pure subroutine sum_point_loads(half_widths, nu, position, stress, displacement)
      real(dp), intent(in) :: half_widths(2), nu, position(3)
      real(dp), intent(out) :: stress(6), displacement(3)
      real(dp) :: from_node(3), load
      integer :: i, j

      stress = 0
      displacement = 0
      do j = 1, size(gauss_nodes)
         do i = 1, size(gauss_nodes)
            from_node = position - [half_widths(1)*gauss_nodes(i), half_widths(2)*gauss_nodes(j), 0.0_dp]
            load = product(half_widths)*gauss_weights(i)*gauss_weights(j)
            stress = stress + point_stress(load, 0.0_dp, nu, from_node)
            displacement = displacement + point_displacement(load, 0.0_dp, 1.0_dp, nu, from_node)
         end do
      end do
   end subroutine sum_point_loads

   !> What a corner adds; nothing at the corner itself.
   pure subroutine corner_field(x, y, z, nu, s, u)
      !> X, Y and z from the corner.
      real(qp), intent(in) :: x, y, z
      real(qp), intent(in) :: nu
      real(qp), intent(out) :: s(6), u(3)
      real(qp) :: r, a_x, a_y, log_z, log_x, log_y, across_x, across_y

      r = norm2([x, y, z])
      s = 0
      u = 0
      if (.not. r > 0) return
      a_x = angle(x, y, z, r)
      a_y = angle(y, x, z, r)
      ! z X/(X^2 + z^2) and z Y/(Y^2 + z^2)
      across_x = share(z, x)
      across_y = share(z, y)
      log_z = log(r + z)
      log_y = log_of(y, x, z, r)
      log_x = log_of(x, y, z, r)
      s(1) = -(a_x + 2*nu*a_y - across_x*y/r)
      s(2) = -(a_y + 2*nu*a_x - across_y*x/r)
      s(3) = -(a_x + a_y + across_x*y/r + across_y*x/r)
      s(4) = -((1 - 2*nu)*log_z + z/r)
      s(5) = x/r*share(z, y, z)
      s(6) = y/r*share(z, x, z)
      u(1) = -(z*log_y + (1 - 2*nu)*(y*log_z + z*log_y + x*a_x))
      u(2) = -(z*log_x + (1 - 2*nu)*(x*log_z + z*log_x + y*a_y))
      u(3) = 2*(1 - nu)*(x*log_y + y*log_x) - (1 - 2*nu)*z*(a_x + a_y)
   end subroutine corner_field

   !> A(X, Y), as one angle: tan A = X Y (R - z)/(X^2 R + z Y^2).
   pure real(qp) function angle(x, y, z, r)
      real(qp), intent(in) :: x, y, z, r
      real(qp) :: along, across

      across = x*y*((x*x + y*y)/(r + z))
      along = x*x*r + z*y*y
      angle = 0
      if (abs(across) > 0 .or. along > 0) angle = atan2(across, along)
   end function angle

   !> z X/(X^2 + z^2), or z^2/(X^2 + z^2); 0 where both vanish.
   pure real(qp) function share(z, x, other)
      real(qp), intent(in) :: z, x
      !> What takes the part of X in the numerator; not present: X.
      real(qp), intent(in), optional :: other
      real(qp) :: distance

      share = 0
      distance = hypot(x, z)
      if (.not. distance > 0) return
      share = (z/distance)*(x/distance)
      if (present(other)) share = (z/distance)*(other/distance)
   end function share

   !> ln(R + Y); 0 where it is infinite, for its factors vanish there.
   pure real(qp) function log_of(y, x, z, r)
      real(qp), intent(in) :: y, x, z, r

      log_of = 0
      if (y > 0) then
         log_of = log(r + y)
      else if (hypot(x, z) > 0) then
         log_of = 2*log(hypot(x, z)) - log(r - y)
      end if
   end function log_of

end module adfric_plane_love_rectangle

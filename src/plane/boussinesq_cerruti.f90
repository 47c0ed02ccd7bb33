! SPDX-License-Identifier: GPL-3.0-or-later
!> Point force on an elastic half-space (Boussinesq: along the normal, Cerruti: along the surface).
!>
!> z points into the solid; the normal force N presses along +z, T pulls along +x. Tension is positive. Source: K. L. Johnson,
!> Contact Mechanics, 1985, (3.18), (3.19), (3.75), (3.76), written with 1/(r + z) where Johnson divides by the distance from
!> the axis.
module adfric_plane_boussinesq_cerruti
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   implicit none (type, external)
   private
   public :: point_stress, point_displacement

contains

   !> Stresses [s_xx, s_yy, s_zz, s_xy, s_yz, s_xz]; NaN under the force itself.
   pure function point_stress(normal, tangential, poisson_ratio, position) result(stress)
      !> Normal force N [N], along +z.
      real(dp), intent(in) :: normal
      !> Tangential force T [N], along +x.
      real(dp), intent(in) :: tangential
      !> Poisson's ratio nu [-].
      real(dp), intent(in) :: poisson_ratio
      !> Coordinates x, y, z of the position, from the force [m], z >= 0.
      real(dp), intent(in) :: position(3)
      real(dp) :: stress(6)
      real(dp) :: r, l, h, x, y, z, radial

      stress = not_a_number()
      r = norm2(position)
      if (.not. r > 0) return
      ! directions, and 1/(1 + z/r)
      x = position(1)/r
      y = position(2)/r
      z = position(3)/r
      h = 1/(1 + z)
      l = 1 - 2*poisson_ratio
      ! the part of an incompressible solid is a push along the line to the force
      radial = -3*(normal*z + tangential*x)
      stress = radial*[x*x, y*y, z*z, x*y, y*z, x*z]
      stress(1) = stress(1) + l*normal*(z - h + x*x*(2 + z)*h*h) &
         & + l*tangential*x*(1 - 3*h*h + x*x*h*h*(1 + 2*h))
      stress(2) = stress(2) + l*normal*(z - h + y*y*(2 + z)*h*h) &
         & + l*tangential*x*(1 - h*h + y*y*h*h*(1 + 2*h))
      stress(4) = stress(4) + l*normal*x*y*(2 + z)*h*h + l*tangential*y*h*h*(x*x*(1 + 2*h) - 1)
      stress = stress/(2*pi)/r/r
   end function point_stress

   !> Displacements [u_x, u_y, u_z], 0 far away; NaN under the force itself.
   pure function point_displacement(normal, tangential, shear_modulus, poisson_ratio, position) result(u)
      !> Normal force N [N], along +z.
      real(dp), intent(in) :: normal
      !> Tangential force T [N], along +x.
      real(dp), intent(in) :: tangential
      !> Shear modulus G [Pa].
      real(dp), intent(in) :: shear_modulus
      !> Poisson's ratio nu [-].
      real(dp), intent(in) :: poisson_ratio
      !> Coordinates x, y, z of the position, from the force [m], z >= 0.
      real(dp), intent(in) :: position(3)
      real(dp) :: u(3)
      real(dp) :: r, l, h, x, y, z

      u = not_a_number()
      r = norm2(position)
      if (.not. r > 0) return
      x = position(1)/r
      y = position(2)/r
      z = position(3)/r
      h = 1/(1 + z)
      l = 1 - 2*poisson_ratio
      u = normal*[x*(z - l*h), y*(z - l*h), z*z + 2*(1 - poisson_ratio)] &
         & + tangential*[1 + x*x + l*h*(1 - x*x*h), x*y*(1 - l*h*h), x*(z + l*h)]
      u = u/(4*pi*shear_modulus)/r
   end function point_displacement

end module adfric_plane_boussinesq_cerruti

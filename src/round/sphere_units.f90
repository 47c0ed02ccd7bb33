! SPDX-License-Identifier: GPL-3.0-or-later
!> The units of the reduced variables of a sphere (K. L. Johnson, Proc. R. Soc. Lond. A 453, 1997, 163, eq. 2.11).
module adfric_round_sphere_units
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_numerics_powers, only: cube_root
   implicit none (type, external)
   private
   public :: get_sphere_units

contains

   !> What one of each reduced variable is in SI units.
   elemental subroutine get_sphere_units(radius, contact_modulus, work_of_adhesion, length, approach, force, stress)
      !> Radius R of the sphere [m], > 0.
      real(dp), intent(in) :: radius
      !> Contact modulus E* [Pa], > 0.
      real(dp), intent(in) :: contact_modulus
      !> Work of adhesion w [J/m^2], > 0.
      real(dp), intent(in) :: work_of_adhesion
      !> Unit of radii in the plane of contact, (3 pi w R^2/4E*)^(1/3) [m].
      real(dp), intent(out) :: length
      !> Unit of the approach, (9 pi^2 w^2 R/16E*^2)^(1/3) [m].
      real(dp), intent(out) :: approach
      !> Unit of forces, pi w R [N].
      real(dp), intent(out) :: force
      !> Unit of stresses, (2 pi w E*^2/9R)^(1/3) [Pa]: the adhesion stress is Maugis's lambda times it.
      real(dp), intent(out) :: stress

      force = pi*work_of_adhesion*radius
      length = cube_root(0.75_dp*force*radius/contact_modulus)
      approach = length**2/radius
      stress = force/(2*length**2)
   end subroutine get_sphere_units

end module adfric_round_sphere_units

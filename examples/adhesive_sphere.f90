! SPDX-License-Identifier: GPL-3.0-or-later
!> Maugis's theory by itself, with plain numbers: a contact of a soft sphere from a pull to a push.
program adhesive_sphere
   use adfric_contact_sphere, only: dp, get_sphere_units, solve_sphere_load, status_solved
   implicit none (type, external)
   real(dp), parameter :: radius = 1.0e-3_dp, modulus = 1.0e6_dp, work = 0.05_dp, stress = 1.0e6_dp   ! [m], [Pa], [J/m^2], [Pa]
   real(dp), parameter :: loads(*) = [-200.0e-6_dp, -100.0e-6_dp, 0.0_dp, 100.0e-6_dp, 1000.0e-6_dp]    ! [N]
   real(dp), dimension(size(loads)) :: contact_radius, adhesion_radius, approach
   real(dp) :: length, closer, force, strength
   integer :: status(size(loads)), i

   call get_sphere_units(radius, modulus, work, length, closer, force, strength)
   call solve_sphere_load(stress/strength, loads/force, contact_radius, adhesion_radius, approach, status)
   do i = 1, size(loads)
      if (status(i) == status_solved) print '(3es14.6)', loads(i), contact_radius(i)*length, approach(i)*closer
   end do
end program adhesive_sphere

! SPDX-License-Identifier: GPL-3.0-or-later
!> A caller who does not do what a procedure demands.
program unmet_demand
   use, intrinsic :: iso_fortran_env, only: output_unit
   use adfric_base_kinds, only: dp
   use adfric_numerics_powers, only: cube_root
   implicit none (type, external)

   write (output_unit, '(a, es9.1)') 'no demand was checked, the cube root is ', cube_root(-1.0_dp)
end program unmet_demand

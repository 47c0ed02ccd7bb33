! SPDX-License-Identifier: GPL-3.0-or-later
!> Use a kernel of adfric::physics, which calls GSL: R_F(0, 1, 1) = pi/2.
program use_physics
   use, intrinsic :: iso_fortran_env, only: real64
   use adfric_base_version, only: program_version
   use adfric_numerics_elliptic, only: carlson_f
   implicit none (type, external)
   real(real64), parameter :: half_pi = 2*atan(1.0_real64)

   if (.not. abs(carlson_f(0.0_real64, 1.0_real64, 1.0_real64) - half_pi) <= 10*epsilon(half_pi)) error stop 'not pi/2'
   print '(2a)', 'physics ', program_version
end program use_physics

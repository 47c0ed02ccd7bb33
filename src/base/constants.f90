! SPDX-License-Identifier: GPL-3.0-or-later
!> Mathematical constants.
module adfric_base_constants
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: pi, two_pi, half_pi

   real(dp), parameter :: pi = 3.14159265358979323846264338327950288_dp
   real(dp), parameter :: two_pi = 2*pi
   real(dp), parameter :: half_pi = pi/2

end module adfric_base_constants

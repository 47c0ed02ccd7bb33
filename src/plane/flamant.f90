! SPDX-License-Identifier: GPL-3.0-or-later
!> Line load on an elastic half-plane in plane strain (Flamant; Y, K. L. Johnson, Contact Mechanics, 1985, 2.2 and 2.3).
!>
!> y points into the solid, x along its boundary. The load N [N/m] presses along +y, T [N/m] pulls along +x. Tension is
!> positive. r and th are the distance from the load and the angle from the inward normal: x = r sin th, y = r cos th.
module adfric_plane_flamant
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   implicit none (type, external)
   private
   public :: line_stress, line_displacement

contains

   !> Stresses [s_xx, s_yy, s_xy]; NaN under the load itself. Both loads make a purely radial stress,
   !>
   !>     s_r = -(2/pi r)(N cos th + T sin th)
   pure function line_stress(normal, tangential, x, y) result(stress)
      !> Normal load N per length [N/m], along +y.
      real(dp), intent(in) :: normal
      !> Tangential load T per length [N/m], along +x.
      real(dp), intent(in) :: tangential
      !> Coordinates of the position, from the load [m], y >= 0.
      real(dp), intent(in) :: x, y
      real(dp) :: stress(3)
      real(dp) :: r, s, c

      stress = not_a_number()
      r = hypot(x, y)
      if (.not. r > 0) return
      s = x/r
      c = y/r
      stress = -2/(pi*r)*(normal*c + tangential*s)*[s*s, c*c, s*c]
   end function line_stress

   !> Displacements [u_x, u_y], up to a rigid motion; NaN under the load itself. With k = (1 + nu)/(pi E):
   !>
   !>     N: u_r  = -k N [2 (1 - nu) ln(r/r0) cos th + (1 - 2 nu) th sin th]
   !>        u_th =  k N [2 (1 - nu) ln(r/r0) sin th + 2 nu sin th + (1 - 2 nu)(sin th - th cos th)]
   !>     T: u_r  = -k T [2 (1 - nu) ln(r/r0) sin th - (1 - 2 nu) th cos th]
   !>        u_th = -k T [2 (1 - nu) ln(r/r0) cos th + 2 nu cos th + (1 - 2 nu)(cos th + th sin th)]
   !>
   !> The displacements printed in Y do not satisfy Hooke's law with these stresses.
   pure function line_displacement(normal, tangential, young_modulus, poisson_ratio, datum, x, y) result(u)
      !> Normal load N per length [N/m], along +y.
      real(dp), intent(in) :: normal
      !> Tangential load T per length [N/m], along +x.
      real(dp), intent(in) :: tangential
      !> Young's modulus E [Pa].
      real(dp), intent(in) :: young_modulus
      !> Poisson's ratio nu [-].
      real(dp), intent(in) :: poisson_ratio
      !> Distance r0 [m], > 0: the half-plane has no place at rest, so this distance fixes the rigid motion.
      real(dp), intent(in) :: datum
      !> Coordinates of the position, from the load [m], y >= 0.
      real(dp), intent(in) :: x, y
      real(dp) :: u(2)
      real(dp) :: r, th, s, c, logarithm, l, u_r, u_th

      u = not_a_number()
      r = hypot(x, y)
      if (.not. r > 0) return
      s = x/r
      c = y/r
      th = atan2(x, y)
      logarithm = 2*(1 - poisson_ratio)*log(r/datum)
      l = 1 - 2*poisson_ratio
      u_r = -normal*(logarithm*c + l*th*s) - tangential*(logarithm*s - l*th*c)
      u_th = normal*(logarithm*s + 2*poisson_ratio*s + l*(s - th*c)) &
         & - tangential*(logarithm*c + 2*poisson_ratio*c + l*(c + th*s))
      u = (1 + poisson_ratio)/(pi*young_modulus)*[u_r*s + u_th*c, u_r*c - u_th*s]
   end function line_displacement

end module adfric_plane_flamant

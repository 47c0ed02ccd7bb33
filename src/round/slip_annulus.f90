! SPDX-License-Identifier: GPL-3.0-or-later
!> Friction of a uniform strength tau0 before sliding: slip in an annulus e <= r <= b, none within e (K. L. Johnson, Proc. R. Soc.
!> Lond. A 453, 1997, 163: J 3.3-3.7).
!>
!> Everything depends on gamma = e/b, or on its angle th = arccos gamma, which keeps its digits where the annulus is
!> narrow. The force T, over that of sliding T_s = pi tau0 b^2, the displacement D and the slip s at the edge go by
!>
!>     T/T_s = (2/pi) [th + sin th cos th]                                         (J 3.4)
!>     D     ~ sin th, the displacement core                                       (J 3.5)
!>     s     ~ th sin th + cos th - 1, the slip core                               (J 3.7, mean around the edge)
!>
!> J 3.7 is printed with the sign of cos th - 1 reversed, which gives three times the work of slip of fracture
!> mechanics for a narrow annulus.
module adfric_round_slip_annulus
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_base_constants, only: pi, half_pi
   use adfric_numerics_powers, only: cube_root
   use adfric_numerics_trigonometry, only: sinc_minus_cos, angle_minus_sine
   implicit none (type, external)
   private
   public :: angle_of_gamma, force_ratio, displacement_core, slip_core, angular_core
   public :: gamma_of_force, gamma_of_displacement
   public :: force_of_angle, slip_of_angle, angle_of_force, angle_of_slip
   public :: shear_traction, largest_slip_core

   !> The slip core at the onset of sliding, th = pi/2.
   real(dp), parameter :: largest_slip_core = half_pi - 1
   !> Above these shares of T_s and of the largest slip core, inverses are computed from the side of sliding.
   real(dp), parameter :: near_sliding = 0.8_dp, near_largest_slip = 0.5_dp
   integer, parameter :: max_steps = 12
   !> A step of Newton's method, relative, that leaves round-off only.
   real(dp), parameter :: close_enough = 1.0e-9_dp

contains

   !> arccos gamma, 0 <= gamma <= 1, to full relative precision.
   elemental real(dp) function angle_of_gamma(gamma) result(angle)
      !> gamma = e/b [-], 0 to 1.
      real(dp), intent(in) :: gamma

      angle = atan2(displacement_core(gamma), gamma)
   end function angle_of_gamma

   !> T/T_s of gamma (J 3.4).
   elemental real(dp) function force_ratio(gamma)
      real(dp), intent(in) :: gamma

      force_ratio = 2*(angle_of_gamma(gamma) + gamma*displacement_core(gamma))/pi
   end function force_ratio

   !> sqrt(1 - gamma^2) (J 3.5).
   elemental real(dp) function displacement_core(gamma)
      real(dp), intent(in) :: gamma

      displacement_core = sqrt((1 - gamma)*(1 + gamma))
   end function displacement_core

   !> sqrt(1 - gamma^2) arccos gamma + gamma - 1 (J 3.7 corrected).
   elemental real(dp) function slip_core(gamma)
      real(dp), intent(in) :: gamma
      real(dp) :: sine

      sine = displacement_core(gamma)
      ! sin th/(1 + cos th) = tan(th/2), about th/2: nothing is lost
      slip_core = sine*(angle_of_gamma(gamma) - sine/(1 + gamma))
   end function slip_core

   !> (1 - gamma^3)/3, the part of the slip that goes around with cos 2t (J 3.6 corrected).
   elemental real(dp) function angular_core(gamma)
      real(dp), intent(in) :: gamma

      angular_core = (1 - gamma)*(1 + gamma*(1 + gamma))/3
   end function angular_core

   !> T/T_s of the angle (J 3.4).
   elemental real(dp) function force_of_angle(angle)
      !> Angle arccos gamma [rad], 0 to pi/2.
      real(dp), intent(in) :: angle

      force_of_angle = 2*(angle + sin(angle)*cos(angle))/pi
   end function force_of_angle

   !> The slip core of the angle (J 3.7 corrected).
   elemental real(dp) function slip_of_angle(angle)
      real(dp), intent(in) :: angle

      slip_of_angle = sin(angle)*(angle - tan(angle/2))
   end function slip_of_angle

   !> gamma of T/T_s, 0 to 1; near 1 with the digits that 1 - T/T_s has.
   elemental real(dp) function gamma_of_force(ratio) result(gamma)
      !> Force over that of sliding, T/T_s [-], 0 to 1.
      real(dp), intent(in) :: ratio

      if (ratio > near_sliding) then
         gamma = sin(complement_of_force(ratio))
      else
         gamma = cos(angle_of_force(ratio))
      end if
   end function gamma_of_force

   !> gamma of the displacement core, 0 to 1.
   elemental real(dp) function gamma_of_displacement(core) result(gamma)
      !> Displacement core sqrt(1 - gamma^2) [-], 0 to 1.
      real(dp), intent(in) :: core

      gamma = displacement_core(core)
   end function gamma_of_displacement

   !> The angle of T/T_s, 0 to 1: x + sin x = pi T/T_s, x = 2 th, which is nearly straight.
   elemental real(dp) function angle_of_force(ratio) result(angle)
      real(dp), intent(in) :: ratio
      real(dp) :: x, step
      integer :: k

      if (ratio > near_sliding) then
         angle = half_pi - complement_of_force(ratio)
         return
      end if
      x = half_pi*ratio
      do k = 1, max_steps
         step = (pi*ratio - x - sin(x))/(1 + cos(x))
         x = x + step
         if (abs(step) <= close_enough*x) exit
      end do
      angle = x/2
   end function angle_of_force

   !> pi/2 less the angle: y - sin y = pi (1 - T/T_s), of whose left-hand side the cube root is nearly straight.
   elemental real(dp) function complement_of_force(ratio) result(complement)
      real(dp), intent(in) :: ratio
      real(dp) :: target, y, root, step
      integer :: k

      complement = 0
      target = cube_root(6*pi*max(1 - ratio, 0.0_dp))
      if (.not. target > 0) return
      y = target
      do k = 1, max_steps
         root = cube_root(6*angle_minus_sine(y))
         step = (target - root)*root**2/(4*sin(y/2)**2)
         y = y + step
         if (abs(step) <= close_enough*y) exit
      end do
      complement = y/2
   end function complement_of_force

   !> The angle of a slip core; pi/2 for the largest one and beyond.
   elemental real(dp) function angle_of_slip(core) result(angle)
      !> Slip core [-], >= 0.
      real(dp), intent(in) :: core
      real(dp) :: target, root, step
      integer :: k

      if (has_asserts) call assert(core >= 0, 'angle_of_slip: core >= 0')
      if (core > near_largest_slip*largest_slip_core) then
         angle = half_pi - complement_of_slip(core)
         return
      end if
      ! the root of twice the core, about th, is nearly straight
      target = sqrt(2*core)
      angle = target
      if (.not. target > 0) return
      do k = 1, max_steps
         root = sqrt(2*slip_of_angle(angle))
         step = (target - root)*root/(angle*cos(angle))
         angle = angle + step
         if (abs(step) <= close_enough*angle) exit
      end do
   end function angle_of_slip

   !> pi/2 less the angle, ph: (pi/2)(1 - cos ph) - (sin ph - ph cos ph) is what the core lacks; its root is nearly
   !> straight.
   elemental real(dp) function complement_of_slip(core) result(complement)
      real(dp), intent(in) :: core
      real(dp) :: target, root, step
      integer :: k

      target = sqrt(max(largest_slip_core - core, 0.0_dp))
      complement = 2*target/sqrt(pi)
      if (.not. target > 0) return
      do k = 1, max_steps
         root = sqrt(pi*sin(complement/2)**2 - complement*sinc_minus_cos(complement))
         step = 2*(target - root)*root/((half_pi - complement)*sin(complement))
         complement = complement + step
         if (abs(step) <= close_enough*complement) exit
      end do
   end function complement_of_slip

   !> Shear stress over the strength at a radius >= 0 (J 3.3, there with e and b interchanged).
   elemental real(dp) function shear_traction(radius, friction_radius, gamma) result(traction)
      !> Distance from the axis, reduced, >= 0.
      real(dp), intent(in) :: radius
      !> Radius b of the circle that bears friction, reduced, >= 0; a point has no shear stress.
      real(dp), intent(in) :: friction_radius
      real(dp), intent(in) :: gamma
      real(dp) :: r

      if (has_asserts) call assert(radius >= 0 .and. friction_radius >= 0, 'shear_traction: radii >= 0')
      traction = 0
      if (.not. radius <= friction_radius .or. .not. friction_radius > 0) return
      r = radius/friction_radius
      if (r >= gamma) then
         traction = 1
      else
         ! arccos[(2 e^2 - b^2 - r^2)/(b^2 - r^2)] by its half angle
         traction = 2*atan2(displacement_core(gamma), sqrt((gamma - r)*(gamma + r)))/pi
      end if
   end function shear_traction

end module adfric_round_slip_annulus

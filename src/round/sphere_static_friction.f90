! SPDX-License-Identifier: GPL-3.0-or-later
!> Displacement and slip of a sphere before sliding, J 3.5-3.7, in the reduced variables of J 2.11:
!>
!>     D = (2/3) k tau b sin th,   s = (4/(3 pi)) k tau b [th sin th + cos th - 1],      k = (2 - nu)/(1 - nu)
!>
!> tau being the strength in the scale of lambda, D and s lengths in the scale of the approach, and th = arccos(e/b) the angle of
!> `adfric_round_slip_annulus`.
module adfric_round_sphere_static_friction
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_round_slip_annulus, only: slip_of_angle
   implicit none (type, external)
   private
   public :: slip_factor, mean_slip, slip_at_angle, largest_slip

contains

   !> k = (2 - nu)/(1 - nu).
   elemental real(dp) function slip_factor(poisson)
      !> Poisson's ratio nu [-], above -1, up to 1/2.
      real(dp), intent(in) :: poisson

      slip_factor = (2 - poisson)/(1 - poisson)
   end function slip_factor

   !> Slip at the edge r = b, mean around it (J 3.7 corrected), reduced.
   elemental real(dp) function mean_slip(strength, poisson, friction_radius, angle) result(slip)
      !> Shear strength tau, in the scale of lambda, > 0.
      real(dp), intent(in) :: strength
      !> Poisson's ratio nu [-], above -1, up to 1/2.
      real(dp), intent(in) :: poisson
      !> Radius b of the circle that bears friction, reduced, >= 0.
      real(dp), intent(in) :: friction_radius
      !> Angle arccos gamma [rad], 0 to pi/2.
      real(dp), intent(in) :: angle

      slip = 4*slip_factor(poisson)*strength*friction_radius*slip_of_angle(angle)/(3*pi)
   end function mean_slip

   !> Slip at the edge in a direction t from that of the force (J 3.6 corrected), reduced.
   elemental real(dp) function slip_at_angle(strength, poisson, friction_radius, angle, direction) result(slip)
      !> Shear strength tau, in the scale of lambda, > 0.
      real(dp), intent(in) :: strength
      !> Poisson's ratio nu [-], above -1, up to 1/2.
      real(dp), intent(in) :: poisson
      !> Radius b of the circle that bears friction, reduced, >= 0.
      real(dp), intent(in) :: friction_radius
      !> Angle arccos gamma [rad], 0 to pi/2.
      real(dp), intent(in) :: angle
      !> Direction t from that of the force [rad].
      real(dp), intent(in) :: direction

      slip = mean_slip(strength, poisson, friction_radius, angle) &
         & - around(strength, poisson, friction_radius, angle)*cos(2*direction)
   end function slip_at_angle

   !> The largest slip at the edge, across the force where nu > 0, reduced.
   elemental real(dp) function largest_slip(strength, poisson, friction_radius, angle) result(slip)
      !> Shear strength tau, in the scale of lambda, > 0.
      real(dp), intent(in) :: strength
      !> Poisson's ratio nu [-], above -1, up to 1/2.
      real(dp), intent(in) :: poisson
      !> Radius b of the circle that bears friction, reduced, >= 0.
      real(dp), intent(in) :: friction_radius
      !> Angle arccos gamma [rad], 0 to pi/2.
      real(dp), intent(in) :: angle

      slip = mean_slip(strength, poisson, friction_radius, angle) &
         & + abs(around(strength, poisson, friction_radius, angle))
   end function largest_slip

   !> How much the slip varies around the edge.
   elemental real(dp) function around(strength, poisson, friction_radius, angle)
      !> Shear strength tau, in the scale of lambda, > 0.
      real(dp), intent(in) :: strength
      !> Poisson's ratio nu [-], above -1, up to 1/2.
      real(dp), intent(in) :: poisson
      !> Radius b of the circle that bears friction, reduced, >= 0.
      real(dp), intent(in) :: friction_radius
      !> Angle arccos gamma [rad], 0 to pi/2.
      real(dp), intent(in) :: angle
      real(dp) :: gamma, core

      gamma = cos(angle)
      core = 2*sin(angle/2)**2*(1 + gamma*(1 + gamma))/3
      around = 4*poisson*strength*friction_radius*core/(3*pi*(1 - poisson))
   end function around

end module adfric_round_sphere_static_friction

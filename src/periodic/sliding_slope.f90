! SPDX-License-Identifier: GPL-3.0-or-later
!> Slope of the friction of cells over the logarithm of the velocity.
module adfric_periodic_sliding_slope
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_interface_friction_law, only: friction_law_t
   use adfric_interface_total_friction, only: get_shear_of_area
   use adfric_periodic_law_of_cells, only: get_mean_of_cells
   use adfric_periodic_near_contact, only: near_contact_t, near_step
   use adfric_periodic_viscoelastic_solid, only: viscoelastic_solid_t
   implicit none (type, external)
   private
   public :: contact_slope

   !> By how much the friction may bend beside its change within the steps of ln v, over the friction.
   real(dp), parameter :: largest_bend = 0.05_dp

contains

   !> Change of the friction by ln v through the contact, with the law at the velocity of the point; NaN where a contact a little off
   !> has not been found, or is of another branch.
   real(dp) function contact_slope(law, speed, temperature, tension, solid, near, at_point) result(slope)
      !> The law of the interface.
      type(friction_law_t), intent(in) :: law
      !> Speed [m/s], temperature of the contact [K], and tension of adhesion [Pa].
      real(dp), intent(in) :: speed, temperature, tension
      !> The solid, with the direction of the motion.
      type(viscoelastic_solid_t), intent(in) :: solid
      !> Contacts at velocities a little off; none where the velocity does not count.
      type(near_contact_t), intent(in) :: near(:)
      !> Friction of the point [Pa].
      real(dp), intent(in) :: at_point
      real(dp) :: friction(size(near)), shear, unused
      logical :: is_valid
      integer :: k

      slope = 0
      if (size(near) == 0) return
      slope = not_a_number()
      do k = 1, size(near)
         if (.not. near(k)%is_found) return
         associate (modulus => solid%modulus)
            if (law%depends_on_pressure()) then
               call get_mean_of_cells(law, speed, temperature, modulus*near(k)%pressure, &
                  & near(k)%is_contact, shear, unused, is_valid)
               shear = near(k)%area*shear
            else
               call get_shear_of_area(law, speed, temperature, near(k)%area, modulus &
                  & *near(k)%mean_pressure + tension*max(near(k)%share - near(k)%area, 0.0_dp), shear, unused, is_valid)
            end if
            if (.not. is_valid) return
            friction(k) = modulus*solid%forward(near(k)%loss) + shear
         end associate
      end do
      ! a jump lies between, where both sides do not go on from the point
      if (abs(sum(friction)/2 - at_point) > abs(friction(2) - friction(1))/2 + largest_bend*abs(at_point)) return
      slope = (friction(2) - friction(1))/(2*near_step)
   end function contact_slope

end module adfric_periodic_sliding_slope

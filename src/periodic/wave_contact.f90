! SPDX-License-Identifier: GPL-3.0-or-later
!> Full contact of a rigid wave that slides over a viscoelastic solid, in closed form: the displacement is the wave.
!>
!> A wave D cos(k.x) has the pressure q + D Re(A exp(ik.x)), with the stiffness A of its wave. Waves along x and y add up.
module adfric_periodic_wave_contact
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_periodic_solver, only: periodic_solution_t, contact_solved
   use adfric_periodic_viscoelastic_solid, only: viscoelastic_solid_t
   implicit none (type, external)
   private
   public :: wave_pressure_of_full_contact, wave_friction_of_full_contact, mean_pressure_at, set_full_contact

   !> The waves along x and along y.
   real(dp), parameter :: along_x(2) = [1.0_dp, 0.0_dp], along_y(2) = [0.0_dp, 1.0_dp]

contains

   !> Least mean pressure of full contact [E0].
   pure real(dp) function wave_pressure_of_full_contact(solid, amplitude, is_2d) result(pressure)
      type(viscoelastic_solid_t), intent(in) :: solid
      !> Amplitude D [periods].
      real(dp), intent(in) :: amplitude
      !> Are there waves along x and y, or along x alone?
      logical, intent(in) :: is_2d

      pressure = amplitude*abs(solid%stiffness_of_wave(along_x))
      if (is_2d) pressure = pressure + amplitude*abs(solid%stiffness_of_wave(along_y))
   end function wave_pressure_of_full_contact

   !> Friction over nominal area in full contact [E0].
   pure real(dp) function wave_friction_of_full_contact(solid, amplitude, is_2d) result(friction)
      type(viscoelastic_solid_t), intent(in) :: solid
      !> Amplitude D [periods].
      real(dp), intent(in) :: amplitude
      !> Are there waves along x and y, or along x alone?
      logical, intent(in) :: is_2d

      friction = solid%forward(losses_of_full_contact(solid, amplitude, is_2d))
   end function wave_friction_of_full_contact

   !> Stress along x and y that holds the body back in full contact [E0].
   pure function losses_of_full_contact(solid, amplitude, is_2d) result(losses)
      type(viscoelastic_solid_t), intent(in) :: solid
      !> Amplitude D [periods].
      real(dp), intent(in) :: amplitude
      !> Are there waves along x and y, or along x alone?
      logical, intent(in) :: is_2d
      real(dp) :: losses(2)

      losses = solid%losses_of_wave(along_x, amplitude)
      if (is_2d) losses = losses + solid%losses_of_wave(along_y, amplitude)
   end function losses_of_full_contact

   !> Mean pressure of full contact at a penetration into a layer [E0]; 0 for a half-space, in which no penetration is known of it.
   pure real(dp) function mean_pressure_at(penetration, solid, amplitude, period, is_2d) result(pressure)
      !> Penetration [m].
      real(dp), intent(in) :: penetration
      type(viscoelastic_solid_t), intent(in) :: solid
      !> Amplitude D and period of the wave [m].
      real(dp), intent(in) :: amplitude, period
      !> Are there waves along x and y, or along x alone?
      logical, intent(in) :: is_2d

      pressure = 0
      associate (compliance => solid%elastic%mean_compliance()*period)
         if (compliance > 0) pressure = (penetration - merge(2, 1, is_2d)*amplitude)/compliance
      end associate
   end function mean_pressure_at

   !> The full contact under a mean pressure.
   subroutine set_full_contact(solid, shape, amplitude, period, mean_pressure, solution)
      type(viscoelastic_solid_t), intent(in) :: solid
      !> Gap of the undeformed wave in the middles of its cells [m]; ny = 1 for a wave along x alone.
      real(dp), intent(in) :: shape(:, :)
      !> Amplitude D and period of the wave [m].
      real(dp), intent(in) :: amplitude, period
      !> Mean pressure, that of full contact or more [E0].
      real(dp), intent(in) :: mean_pressure
      !> Receives the contact; lengths in m, pressures in E0.
      type(periodic_solution_t), intent(out) :: solution
      real(dp) :: across(size(shape, 2))
      logical :: is_2d
      integer :: j

      is_2d = size(shape, 2) > 1
      solution%mean_pressure = mean_pressure
      solution%penetration = merge(2, 1, is_2d)*amplitude + mean_pressure*solid%elastic%mean_compliance()*period
      solution%gap = 0*shape
      solution%pressure = 0*shape
      across = 0
      if (is_2d) across = pressure_along(along_y, size(shape, 2))
      do j = 1, size(shape, 2)
         solution%pressure(:, j) = max(mean_pressure + pressure_along(along_x, size(shape, 1)) + across(j), 0.0_dp)
      end do
      solution%area%cells = 1
      solution%area%corrected = 1
      solution%area%error = 0
      solution%full_pressure = wave_pressure_of_full_contact(solid, amplitude/period, is_2d)
      solution%friction%loss = losses_of_full_contact(solid, amplitude/period, is_2d)
      solution%friction%direct = solution%friction%loss
      solution%stiffness_ratio = ratio_of(along_x)
      if (is_2d) solution%stiffness_ratio = min(solution%stiffness_ratio, ratio_of(along_y))
      solution%residual = 0
      solution%status = contact_solved

   contains

      !> Real part of the stiffness of a wave over its size.
      pure real(dp) function ratio_of(waves)
         !> Number of waves along x and y, one of them 1.
         real(dp), intent(in) :: waves(2)

         associate (stiffness => solid%stiffness_of_wave(waves))
            ratio_of = real(stiffness, dp)/abs(stiffness)
         end associate
      end function ratio_of

      !> Pressure of a wave in the middles of the cells of a period, without its mean.
      pure function pressure_along(waves, n) result(pressure)
         !> Number of waves along x and y, one of them 1.
         real(dp), intent(in) :: waves(2)
         !> Number of cells.
         integer, intent(in) :: n
         real(dp) :: pressure(n)
         complex(dp) :: stiffness
         integer :: i

         stiffness = solid%stiffness_of_wave(waves)*(amplitude/period)
         pressure = [(real(stiffness, dp)*cos(two_pi*(i - 0.5_dp)/n) - aimag(stiffness)*sin(two_pi*(i - 0.5_dp)/n), i=1, n)]
      end function pressure_along

   end subroutine set_full_contact

end module adfric_periodic_wave_contact

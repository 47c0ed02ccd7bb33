! SPDX-License-Identifier: GPL-3.0-or-later
!> One point of `surface_sliding`: from the values of a namelist to the solid below the moving surface.
module adfric_periodic_sliding_case
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, two_pi
   use adfric_base_unset, only: is_set
   use adfric_interface_friction_law_rows, only: i_pressure_factor
   use adfric_interface_shear_coupling, only: is_coupled
   use adfric_solid_given_spectrum, only: given_spectrum_t
   use adfric_solid_prony, only: prony_t
   use adfric_solid_spectrum_rows, only: get_spectrum, poisson_ratio_of, shift_factor_of, n_spectrum_rows
   use adfric_periodic_coupled_kernel, only: shear_coupling_t
   use adfric_periodic_layer_kernel, only: layer_kernel_t
   use adfric_periodic_point, only: periodic_surface_t
   use adfric_periodic_sliding_variables, only: s_coupling, s_friction, s_thickness, s_base, s_poisson_ratio, s_velocity, &
      & base_bonded
   use adfric_periodic_viscoelastic_solid, only: motion_t, viscoelastic_solid_t, set_viscoelastic_solid
   implicit none (type, external)
   private
   public :: set_sliding_solid, frequencies_of, is_direction, poisson_ratio_of_solid, speed_of

   !> Directions are multiples of it [degrees].
   real(dp), parameter :: half_right_angle = 45

contains

   !> The solid of a point.
   subroutine set_sliding_solid(values, direction, spectrum, surface)
      !> Values of the rows of the solid, which have been checked; shape `(n_solid_rows)`.
      real(dp), intent(in) :: values(:)
      !> Direction of the motion [degrees], a multiple of 45, of 90 for heights.
      real(dp), intent(in) :: direction
      type(given_spectrum_t), intent(in) :: spectrum
      !> In: with periods and cells. Out: also with `solid`.
      type(periodic_surface_t), intent(inout) :: surface
      type(viscoelastic_solid_t), allocatable :: solid
      type(layer_kernel_t), allocatable :: layer
      type(shear_coupling_t), allocatable :: coupling
      type(motion_t) :: motion
      type(prony_t) :: prony

      call get_spectrum(values(:n_spectrum_rows), spectrum, prony)
      motion = motion_t(speed_of(values, spectrum), steps_of(direction), surface%n_cells > 1)
      allocate (solid)
      ! what is not allocated is absent
      if (is_set(values(s_thickness))) then
         allocate (layer)
         layer%thickness = values(s_thickness)
         layer%is_bonded = nint(values(s_base)) == base_bonded
         if (is_set(poisson_ratio_of_solid(values))) layer%poisson_ratio = poisson_ratio_of_solid(values)
      end if
      if (is_coupled(values(s_coupling))) then
         allocate (coupling)
         coupling%friction_coefficient = values(s_friction + i_pressure_factor - 1)
         coupling%poisson_ratio = poisson_ratio_of_solid(values)
      end if
      call set_viscoelastic_solid(solid, prony, motion, surface%period(1), layer, coupling)
      call move_alloc(solid, surface%solid)
   end subroutine set_sliding_solid

   !> Poisson's ratio, of the layer or of the material [-], or unset.
   pure real(dp) function poisson_ratio_of_solid(values) result(poisson_ratio)
      !> Values of the rows of the solid; shape `(n_solid_rows)`.
      real(dp), intent(in) :: values(:)

      poisson_ratio = poisson_ratio_of(values(:n_spectrum_rows))
      if (is_set(values(s_poisson_ratio))) poisson_ratio = values(s_poisson_ratio)
   end function poisson_ratio_of_solid

   !> Velocity times the factor of all relaxation times [m/s].
   pure real(dp) function speed_of(values, spectrum) result(speed)
      !> Values of the rows of the solid, which have been checked; shape `(n_solid_rows)`.
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: spectrum

      speed = values(s_velocity)*shift_factor_of(values(:n_spectrum_rows), spectrum)
   end function speed_of

   !> Can the body slide to there? Along diagonals of cells the history of a position has less samples than the surface, and waves
   !> shorter than two of them would be taken for others: that is for waves alone, which have none.
   pure logical function is_direction(direction, has_heights)
      !> Direction of the motion [degrees].
      real(dp), intent(in) :: direction
      !> Is the surface one of heights, and no wave?
      logical, intent(in) :: has_heights

      associate (unit => merge(2, 1, has_heights)*half_right_angle)
         is_direction = .not. abs(direction - unit*nint(direction/unit)) > 0
      end associate
   end function is_direction

   !> The way from cell to cell along x and y.
   pure function steps_of(direction) result(steps)
      !> Direction of the motion [degrees], a multiple of 45.
      real(dp), intent(in) :: direction
      integer :: steps(2)
      integer, parameter :: along_x(0:7) = [1, 1, 0, -1, -1, -1, 0, 1], along_y(0:7) = [0, 1, 1, 1, 0, -1, -1, -1]

      associate (octant => modulo(nint(direction/half_right_angle), 8))
         steps = [along_x(octant), along_y(octant)]
      end associate
   end function steps_of

   !> Lowest and highest angular frequency that the surface excites in the solid, whatever its temperature [rad/s]: those of the period
   !> and, of heights, of waves of two cells. 0 where the surface does not vary along the motion.
   pure function frequencies_of(velocity, direction, has_heights, surface) result(frequencies)
      !> Velocity [m/s].
      real(dp), intent(in) :: velocity
      !> Direction of the motion [degrees], a multiple of 45.
      real(dp), intent(in) :: direction
      !> Is the surface one of heights, and no wave?
      logical, intent(in) :: has_heights
      type(periodic_surface_t), intent(in) :: surface
      real(dp) :: frequencies(2), passed(2)
      integer :: steps(2)

      ! periods that pass in a second, along x and y
      steps = steps_of(direction)
      passed = abs(steps)*velocity/norm2(real(steps, dp))/surface%period
      passed = merge(passed, 0.0_dp, surface%n_cells > 1)
      frequencies = two_pi*maxval(passed)
      if (any(passed > 0)) frequencies(1) = two_pi*minval(passed, mask=passed > 0)
      if (has_heights) frequencies(2) = pi*sum(passed*surface%n_cells)
   end function frequencies_of

end module adfric_periodic_sliding_case

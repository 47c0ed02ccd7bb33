!> One point of `surface_sliding`: from the values of a namelist to the solid below the moving surface.
module adfric_periodic_sliding_case
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, two_pi
   use adfric_base_unset, only: is_set
   use adfric_material_given_spectrum, only: given_spectrum_t
   use adfric_material_prony, only: prony_t
   use adfric_material_spectrum_rows, only: get_spectrum, poisson_ratio_of, shift_factor_of, n_spectrum_rows
   use adfric_periodic_layer_kernel, only: layer_kernel_t
   use adfric_periodic_point, only: periodic_surface_t
   use adfric_periodic_sliding_variables, only: s_thickness, s_base, s_poisson_ratio, s_velocity, base_bonded
   use adfric_periodic_viscoelastic_solid, only: motion_t, viscoelastic_solid_t, set_viscoelastic_solid
   implicit none (type, external)
   private
   public :: set_sliding_solid, frequencies_of, is_direction, speed_of

   !> Directions are multiples of it [degrees].
   real(dp), parameter :: right_angle = 90

contains

   !> The solid of a point.
   subroutine set_sliding_solid(values, direction, spectrum, surface)
      !> Values of the rows of the solid, which have been checked; shape `(n_solid_rows)`.
      real(dp), intent(in) :: values(:)
      !> Direction of the motion [degrees], 0, 90, 180 or 270.
      real(dp), intent(in) :: direction
      !> Lists and master curve of the input.
      type(given_spectrum_t), intent(in) :: spectrum
      !> In: with periods and cells. Out: also with `solid`.
      type(periodic_surface_t), intent(inout) :: surface
      type(viscoelastic_solid_t), allocatable :: solid
      type(layer_kernel_t) :: layer
      type(motion_t) :: motion
      type(prony_t) :: prony

      call get_spectrum(values(:n_spectrum_rows), spectrum, prony)
      motion = motion_t(speed_of(values, spectrum), along_of(direction), nint(direction/right_angle) >= 2)
      allocate (solid)
      if (is_set(values(s_thickness))) then
         layer%thickness = values(s_thickness)
         layer%is_bonded = nint(values(s_base)) == base_bonded
         if (is_set(poisson_ratio_of(values(:n_spectrum_rows)))) layer%poisson_ratio = poisson_ratio_of(values(:n_spectrum_rows))
         if (is_set(values(s_poisson_ratio))) layer%poisson_ratio = values(s_poisson_ratio)
         call set_viscoelastic_solid(solid, prony, motion, surface%period(1), layer)
      else
         call set_viscoelastic_solid(solid, prony, motion, surface%period(1))
      end if
      call move_alloc(solid, surface%solid)
   end subroutine set_sliding_solid

   !> Velocity times the factor of all relaxation times [m/s].
   pure real(dp) function speed_of(values, spectrum) result(speed)
      !> Values of the rows of the solid, which have been checked; shape `(n_solid_rows)`.
      real(dp), intent(in) :: values(:)
      !> Lists and master curve of the input.
      type(given_spectrum_t), intent(in) :: spectrum

      speed = values(s_velocity)*shift_factor_of(values(:n_spectrum_rows), spectrum)
   end function speed_of

   !> Can the body slide to there?
   pure logical function is_direction(direction)
      !> Direction of the motion [degrees].
      real(dp), intent(in) :: direction

      is_direction = .not. abs(direction - right_angle*nint(direction/right_angle)) > 0
   end function is_direction

   !> Is the motion along x (1) or along y (2)?
   pure integer function along_of(direction)
      !> Direction of the motion [degrees], 0, 90, 180 or 270.
      real(dp), intent(in) :: direction

      along_of = 1 + modulo(nint(direction/right_angle), 2)
   end function along_of

   !> Lowest and highest angular frequency that the surface excites in the solid, whatever its temperature [rad/s]: those of the period
   !> and, of heights, of waves of two cells. 0 where the surface does not vary along the motion.
   pure function frequencies_of(velocity, direction, has_heights, surface) result(frequencies)
      !> Velocity [m/s].
      real(dp), intent(in) :: velocity
      !> Direction of the motion [degrees], 0, 90, 180 or 270.
      real(dp), intent(in) :: direction
      !> Is the surface one of heights, and no wave?
      logical, intent(in) :: has_heights
      !> Its periods and cells.
      type(periodic_surface_t), intent(in) :: surface
      real(dp) :: frequencies(2)

      associate (n => surface%n_cells(along_of(direction)), period => surface%period(along_of(direction)))
         frequencies = two_pi*velocity/period
         if (has_heights) frequencies(2) = pi*velocity*n/period
         if (n == 1) frequencies = 0
      end associate
   end function frequencies_of

end module adfric_periodic_sliding_case

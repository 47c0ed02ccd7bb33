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
   public :: set_sliding_solid, frequencies_of, has_way, is_direction, speed_of

   !> Directions are multiples of it [degrees].
   real(dp), parameter :: half_right_angle = 45
   !> Diagonals need cells whose length and width differ by no more than that share.
   real(dp), parameter :: square_enough = 1.0e-9_dp

contains

   !> The solid of a point.
   subroutine set_sliding_solid(values, direction, spectrum, surface)
      !> Values of the rows of the solid, which have been checked; shape `(n_solid_rows)`.
      real(dp), intent(in) :: values(:)
      !> Direction of the motion [degrees], a multiple of 45.
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
      motion = motion_t(speed_of(values, spectrum), steps_of(direction), surface%n_cells > 1)
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

   !> Is it one along rows, columns or diagonals of cells?
   pure logical function is_direction(direction)
      !> Direction of the motion [degrees].
      real(dp), intent(in) :: direction

      is_direction = .not. abs(direction - half_right_angle*nint(direction/half_right_angle)) > 0
   end function is_direction

   !> Can the body slide to there, from cell to cell? Along diagonals only where cells are as long as wide.
   pure logical function has_way(direction, surface)
      !> Direction of the motion [degrees].
      real(dp), intent(in) :: direction
      !> Periods and cells of the surface.
      type(periodic_surface_t), intent(in) :: surface

      has_way = is_direction(direction)
      if (.not. has_way .or. any(steps_of(direction) == 0) .or. any(surface%n_cells <= 1)) return
      associate (size => surface%period/surface%n_cells)
         has_way = abs(size(1) - size(2)) <= square_enough*size(1)
      end associate
   end function has_way

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
      !> Its periods and cells.
      type(periodic_surface_t), intent(in) :: surface
      real(dp) :: frequencies(2), passed(2)

      ! periods that pass in a second, along x and y
      passed = abs(steps_of(direction))*velocity/norm2(real(steps_of(direction), dp))/surface%period
      passed = merge(passed, 0.0_dp, surface%n_cells > 1)
      frequencies = two_pi*maxval(passed)
      if (any(passed > 0)) frequencies(1) = two_pi*minval(passed, mask=passed > 0)
      if (has_heights) frequencies(2) = pi*sum(passed*surface%n_cells)
   end function frequencies_of

end module adfric_periodic_sliding_case

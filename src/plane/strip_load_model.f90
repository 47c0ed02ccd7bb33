! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `strip_load`: given tractions on a strip of an elastic half-plane, plane strain.
module adfric_plane_strip_load_model
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_plane_field_model, only: set_plane_stresses, maps_of
   use adfric_plane_plane_load, only: plane_load_model_t, set_plane_variables, set_stress, v_young_modulus, &
      & v_poisson_ratio, r_stress_xx, r_stress_xy
   use adfric_plane_sampled_traction, only: sampled_traction_t, every_second
   use adfric_plane_strip_tractions, only: uniform_strip_stress, hertz_strip_stress, uniform_strip_integral, &
      & hertz_strip_integral
   use adfric_describe_check, only: require
   use adfric_describe_pointwise, only: point_state_t
   use adfric_describe_rows, only: positive, number, choice, dataset, result_row
   use adfric_describe_status, only: status_solved
   use adfric_describe_table, only: result_t, variable_t
   implicit none (type, external)
   private
   public :: strip_load_model_t, new_strip_load_model

   !> Places of the strip load's own variables and results; those of `adfric_plane_plane_load` are the first.
   integer, parameter, public :: v_normal = 5, v_tangential = 6, v_distribution = 7, v_half_width = 8, v_positions = 9, &
      & v_pressures = 10, v_shear_tractions = 11
   integer, parameter, public :: r_strain = 5, r_slope = 6
   !> Places of the words in the choice of the distribution.
   integer, parameter, public :: distribution_uniform = 1, distribution_hertz = 2, distribution_sampled = 3
   !> Fewest samples, so that every second of them makes a coarser set to compare with.
   integer, parameter :: fewest_samples = 3

   !> Tractions on a strip of a half-plane.
   type, extends(plane_load_model_t) :: strip_load_model_t
      private
      !> Tractions of &samples.
      type(sampled_traction_t) :: samples
   contains
      procedure :: take_dataset
      procedure :: check_case
      procedure :: get_field
      procedure :: solve_point
   end type strip_load_model_t

contains

   !> The model of a strip load with its tables.
   subroutine new_strip_load_model(self)
      !> The new model; receives its tables.
      type(strip_load_model_t), intent(out) :: self
      type(variable_t) :: v(11)
      type(result_t) :: r(6)

      call set_plane_variables(v)
      v(v_normal) = number(group='operating', name='normal_traction', unit='Pa', meaning='p, into the solid; its largest value', &
         & default=0.0_dp)
      v(v_tangential) = number(group='operating', name='tangential_traction', unit='Pa', meaning='q, along x; its largest value', &
         & default=0.0_dp)
      v(v_distribution) = choice(group='operating', name='distribution', &
         & meaning='of both tractions: constant, sqrt(1 - x^2/a^2), or as in &samples', choices='uniform hertz sampled')
      v(v_half_width) = positive(group='operating', name='half_width', unit='m', &
         & meaning='half-width a of the strip; not of a sampled one')
      v(v_positions) = dataset(group='samples', name='positions', unit='m', &
         & meaning='where the tractions are given, increasing; linear between', largest_rank=1, least_count=fewest_samples)
      v(v_pressures) = dataset(group='samples', name='pressures', unit='Pa', meaning='p there, into the solid', largest_rank=1, &
         & least_count=fewest_samples)
      v(v_shear_tractions) = dataset(group='samples', name='shear_tractions', unit='Pa', &
         & meaning='q there, along x; not given: none', largest_rank=1, least_count=fewest_samples)
      call set_plane_stresses(r)
      r(r_strain) = result_row(name='surface_strain', unit='-', long_name='du_x/dx of the surface at position_x')
      r(r_slope) = result_row(name='surface_slope', unit='-', long_name='du_y/dx of the surface at position_x')
      call self%set_tables(name='strip_load', &
         & summary='tractions on a strip of an elastic half-plane: stresses and surface slopes', variables=v, results=r, &
         & profiles=maps_of(r), axes='y x', is_depth=.true.)
   end subroutine new_strip_load_model

   !> See `halfspace_model_t`.
   subroutine check_case(self, values, problems)
      !> The model; its tables give the variables their names.
      class(strip_load_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: k

      call require(self%variables, values, [v_young_modulus, v_poisson_ratio, v_distribution], problems)
      if (.not. is_set(values(v_distribution))) return
      if (nint(values(v_distribution)) == distribution_sampled) then
         call require(self%variables, values, [v_positions, v_pressures], problems)
         call check_samples(self, values, problems)
         if (is_set(values(v_half_width))) call refuse(v_half_width)
         do k = v_normal, v_tangential
            if (abs(values(k)) > 0) call refuse(k)
         end do
      else
         call require(self%variables, values, [v_half_width], problems)
         do k = v_positions, v_shear_tractions
            if (is_set(values(k))) call refuse(k)
         end do
      end if

   contains

      !> Add a problem to the list: a variable is given that the distribution does not take.
      subroutine refuse(k)
         !> Place in `variables` of a variable that is given but not taken.
         integer, intent(in) :: k

         call problems%add(self%variables(k)%group, self%variables(k)%name, 'is given, but the distribution does not take it')
      end subroutine refuse

   end subroutine check_case

   !> Do the samples belong together? Only those are looked at that are given.
   subroutine check_samples(self, values, problems)
      !> The model with its samples.
      class(strip_load_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      if (.not. is_set(values(v_positions))) return
      if (is_set(values(v_pressures))) then
         if (size(self%samples%p) /= size(self%samples%s)) &
            & call problems%add('samples', 'pressures', 'has not as many values as positions')
      end if
      if (is_set(values(v_shear_tractions))) then
         if (size(self%samples%q) /= size(self%samples%s)) &
            & call problems%add('samples', 'shear_tractions', 'has not as many values as positions')
      end if
   end subroutine check_samples

   !> See `model_t`.
   subroutine take_dataset(self, place, values, problems)
      !> The model, which keeps the samples.
      class(strip_load_model_t), intent(inout) :: self
      !> Place of the dataset in `variables`.
      integer, intent(in) :: place
      !> Values of the dataset; shape `(n_samples, 1)`.
      real(dp), intent(in) :: values(:, :)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      select case (place)
      case (v_positions)
         self%samples%s = values(:, 1)
         associate (s => self%samples%s)
            if (.not. all(s(2:) > s(:size(s) - 1))) &
               & call problems%add('samples', 'positions', 'do not increase from each to the next')
         end associate
      case (v_pressures)
         self%samples%p = values(:, 1)
         ! until they are given
         self%samples%q = 0*values(:, 1)
      case (v_shear_tractions)
         self%samples%q = values(:, 1)
      end select
   end subroutine take_dataset

   !> See `field_model_t`.
   subroutine get_field(self, values, place, field)
      !> The model with its samples.
      class(strip_load_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Coordinates x, y, z of the place [m]; of a half-plane x, y, 0.
      real(dp), intent(in) :: place(3)
      !> Results at the place, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(out) :: field(:)
      real(dp) :: x, y, shape, integral, tractions(2), integrals(2)
      logical :: is_uniform

      if (nint(values(v_distribution)) == distribution_sampled) then
         call set_stress(self%samples%stress_at(place(1), place(2)), field)
         call set_slopes(values, self%samples%value_at(place(1)), self%samples%integral_at(place(1)), field)
         return
      end if

      x = place(1)/values(v_half_width)
      y = place(2)/values(v_half_width)
      is_uniform = nint(values(v_distribution)) == distribution_uniform
      field = not_a_number()
      ! a jump of the tractions: no values at the edges
      if (is_uniform .and. .not. max(abs(abs(x) - 1), y) > 0) return
      if (is_uniform) then
         call set_stress(uniform_strip_stress(values(v_normal), values(v_tangential), x, y), field)
         if (.not. abs(abs(x) - 1) > 0) return
         integral = uniform_strip_integral(x)
         shape = merge(1.0_dp, 0.0_dp, abs(x) < 1)
      else
         call set_stress(hertz_strip_stress(values(v_normal), values(v_tangential), x, y), field)
         integral = hertz_strip_integral(x)
         shape = sqrt(max(0.0_dp, (1 - x)*(1 + x)))
      end if
      tractions = [values(v_normal), values(v_tangential)]*shape
      integrals = [values(v_normal), values(v_tangential)]*integral
      call set_slopes(values, tractions, integrals, field)
   end subroutine get_field

   !> The slopes of the surface (Johnson 2.25), with p and q where they are and their principal values I:
   !>
   !>     du_x/dx = -(1 + nu)(1 - 2 nu)/E p - 2 (1 - nu^2)/(pi E) I[q]
   !>     du_y/dx =  (1 + nu)(1 - 2 nu)/E q - 2 (1 - nu^2)/(pi E) I[p]
   pure subroutine set_slopes(values, tractions, integrals, field)
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Tractions p and q at the place [Pa].
      real(dp), intent(in) :: tractions(2)
      !> Principal values I[p] and I[q] at the place [Pa].
      real(dp), intent(in) :: integrals(2)
      !> Results at the place; strain and slope of the surface are set.
      real(dp), intent(inout) :: field(:)
      real(dp) :: near, far

      near = (1 + values(v_poisson_ratio))*(1 - 2*values(v_poisson_ratio))/values(v_young_modulus)
      far = 2*(1 - values(v_poisson_ratio)**2)/(pi*values(v_young_modulus))
      field(r_strain) = -near*tractions(1) - far*integrals(2)
      field(r_slope) = near*tractions(2) - far*integrals(1)
   end subroutine set_slopes

   !> See `pointwise_model_t`. The error of sampled tractions is what every second sample changes of the stresses: at least the
   !> error of the interpolation, where that falls with the distance of the samples or faster. Against the root of the squares of
   !> the stresses; 1 where they are 0 and should perhaps not be.
   subroutine solve_point(self, values, state, results, error_estimate, status, counts)
      !> The model with its samples.
      class(strip_load_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Nothing is left for the next point.
      class(point_state_t), allocatable, intent(inout) :: state
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Estimated relative error of the main result [-].
      real(dp), intent(out) :: error_estimate
      !> Status of the point, one of `status_...`.
      integer, intent(out) :: status
      !> These models count nothing; size 0.
      real(dp), intent(inout) :: counts(:)
      type(sampled_traction_t) :: coarse
      real(dp) :: place(3), change

      place = self%get_place(values)
      call self%get_field(values, place, results)
      status = status_solved
      error_estimate = epsilon(error_estimate)
      if (nint(values(v_distribution)) /= distribution_sampled) return
      if (.not. place(2) > 0 .and. self%samples%jumps_at(place(1))) return
      coarse = every_second(self%samples)
      associate (stress => results(r_stress_xx:r_stress_xy))
         change = norm2(stress - coarse%stress_at(place(1), place(2)))
         if (change > 0) error_estimate = max(error_estimate, change/max(change, norm2(stress)))
      end associate
      associate (unused => state, unused_counts => counts)
      end associate
   end subroutine solve_point

end module adfric_plane_strip_load_model

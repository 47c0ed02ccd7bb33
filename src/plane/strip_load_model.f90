! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `strip_load`: given tractions on a strip of an elastic half-plane, plane strain.
module adfric_plane_strip_load_model
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_plane_field_model, only: set_plane_stresses, maps_of
   use adfric_plane_plane_load, only: plane_load_model_t, set_plane_variables, set_stress, plane_load_input, &
      & plane_load_output
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

   !> Variables in the order of their rows; a component is the index of its row.
   type :: strip_load_input_t
      !> Indices of the rows.
      integer :: normal = 0, tangential = 0, distribution = 0, half_width = 0, positions = 0, pressures = 0, &
         & shear_tractions = 0
   end type strip_load_input_t
   type(strip_load_input_t), parameter, public :: strip_load_input = transfer(counting(plane_load_input%y + 1:), &
      & strip_load_input_t())
   !> Results in the order of their rows; a component is the index of its row.
   type :: strip_load_output_t
      !> Indices of the rows.
      integer :: strain = 0, slope = 0
   end type strip_load_output_t
   type(strip_load_output_t), parameter, public :: strip_load_output = transfer(counting(plane_load_output%shear + 1:), &
      & strip_load_output_t())
   !> Indices of the words in the choice of the distribution.
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
      v(strip_load_input%normal) = number(group='operating', name='normal_traction', unit='Pa', &
         & meaning='p, into the solid; its largest value', &
         & default=0.0_dp)
      v(strip_load_input%tangential) = number(group='operating', name='tangential_traction', unit='Pa', &
         & meaning='q, along x; its largest value', &
         & default=0.0_dp)
      v(strip_load_input%distribution) = choice(group='operating', name='distribution', &
         & meaning='of both tractions: constant, sqrt(1 - x^2/a^2), or as in &samples', choices='uniform hertz sampled')
      v(strip_load_input%half_width) = positive(group='operating', name='half_width', unit='m', &
         & meaning='half-width a of the strip; not of a sampled one')
      v(strip_load_input%positions) = dataset(group='samples', name='positions', unit='m', &
         & meaning='where the tractions are given, increasing; linear between', largest_rank=1, least_count=fewest_samples)
      v(strip_load_input%pressures) = dataset(group='samples', name='pressures', unit='Pa', meaning='p there, into the solid', &
         & largest_rank=1, &
         & least_count=fewest_samples)
      v(strip_load_input%shear_tractions) = dataset(group='samples', name='shear_tractions', unit='Pa', &
         & meaning='q there, along x; not given: none', largest_rank=1, least_count=fewest_samples)
      call set_plane_stresses(r)
      r(strip_load_output%strain) = result_row(name='surface_strain', unit='-', long_name='du_x/dx of the surface at position_x')
      r(strip_load_output%slope) = result_row(name='surface_slope', unit='-', long_name='du_y/dx of the surface at position_x')
      call self%set_tables(name='strip_load', &
         & summary='tractions on a strip of an elastic half-plane: stresses and surface slopes', variables=v, results=r, &
         & profiles=maps_of(r), axes='y x', is_depth=.true.)
   end subroutine new_strip_load_model

   !> See `halfspace_model_t`.
   subroutine check_case(self, values, problems)
      class(strip_load_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: k

      call require(self%variables, values, [plane_load_input%young_modulus, plane_load_input%poisson_ratio, &
         & strip_load_input%distribution], problems)
      if (.not. is_set(values(strip_load_input%distribution))) return
      if (nint(values(strip_load_input%distribution)) == distribution_sampled) then
         call require(self%variables, values, [strip_load_input%positions, strip_load_input%pressures], problems)
         call check_samples(self, values, problems)
         if (is_set(values(strip_load_input%half_width))) call refuse(strip_load_input%half_width)
         do k = strip_load_input%normal, strip_load_input%tangential
            if (abs(values(k)) > 0) call refuse(k)
         end do
      else
         call require(self%variables, values, [strip_load_input%half_width], problems)
         do k = strip_load_input%positions, strip_load_input%shear_tractions
            if (is_set(values(k))) call refuse(k)
         end do
      end if

   contains

      !> Add a problem to the list: a variable is given that the distribution does not take.
      subroutine refuse(k)
         !> Position in `variables` of a variable that is given but not taken.
         integer, intent(in) :: k

         call problems%add(self%variables(k)%group, self%variables(k)%name, 'is given, but the distribution does not take it')
      end subroutine refuse

   end subroutine check_case

   !> Do the samples belong together? Only those are looked at that are given.
   subroutine check_samples(self, values, problems)
      class(strip_load_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems

      if (.not. is_set(values(strip_load_input%positions))) return
      if (is_set(values(strip_load_input%pressures))) then
         if (size(self%samples%p) /= size(self%samples%s)) &
            & call problems%add('samples', 'pressures', 'has not as many values as positions')
      end if
      if (is_set(values(strip_load_input%shear_tractions))) then
         if (size(self%samples%q) /= size(self%samples%s)) &
            & call problems%add('samples', 'shear_tractions', 'has not as many values as positions')
      end if
   end subroutine check_samples

   !> See `model_t`.
   subroutine take_dataset(self, index, values, problems)
      class(strip_load_model_t), intent(inout) :: self
      !> Index of the dataset in `variables`.
      integer, intent(in) :: index
      !> Values of the dataset; shape `(n_samples, 1)`.
      real(dp), intent(in) :: values(:, :)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      select case (index)
      case (strip_load_input%positions)
         self%samples%s = values(:, 1)
         associate (s => self%samples%s)
            if (.not. all(s(2:) > s(:size(s) - 1))) &
               & call problems%add('samples', 'positions', 'do not increase from each to the next')
         end associate
      case (strip_load_input%pressures)
         self%samples%p = values(:, 1)
         ! until they are given
         self%samples%q = 0*values(:, 1)
      case (strip_load_input%shear_tractions)
         self%samples%q = values(:, 1)
      end select
   end subroutine take_dataset

   !> See `field_model_t`.
   subroutine get_field(self, values, position, field)
      class(strip_load_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Coordinates x, y, z of the position [m]; of a half-plane x, y, 0.
      real(dp), intent(in) :: position(3)
      !> Results at the position, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(out) :: field(:)
      real(dp) :: x, y, shape, integral, tractions(2), integrals(2)
      logical :: is_uniform

      if (nint(values(strip_load_input%distribution)) == distribution_sampled) then
         call set_stress(self%samples%stress_at(position(1), position(2)), field)
         call set_slopes(values, self%samples%value_at(position(1)), self%samples%integral_at(position(1)), field)
         return
      end if

      x = position(1)/values(strip_load_input%half_width)
      y = position(2)/values(strip_load_input%half_width)
      is_uniform = nint(values(strip_load_input%distribution)) == distribution_uniform
      field = not_a_number()
      ! a jump of the tractions: no values at the edges
      if (is_uniform .and. .not. max(abs(abs(x) - 1), y) > 0) return
      if (is_uniform) then
         call set_stress(uniform_strip_stress(values(strip_load_input%normal), values(strip_load_input%tangential), x, y), field)
         if (.not. abs(abs(x) - 1) > 0) return
         integral = uniform_strip_integral(x)
         shape = merge(1.0_dp, 0.0_dp, abs(x) < 1)
      else
         call set_stress(hertz_strip_stress(values(strip_load_input%normal), values(strip_load_input%tangential), x, y), field)
         integral = hertz_strip_integral(x)
         shape = sqrt(max(0.0_dp, (1 - x)*(1 + x)))
      end if
      tractions = [values(strip_load_input%normal), values(strip_load_input%tangential)]*shape
      integrals = [values(strip_load_input%normal), values(strip_load_input%tangential)]*integral
      call set_slopes(values, tractions, integrals, field)
   end subroutine get_field

   !> The slopes of the surface (Johnson 2.25), with p and q where they are and their principal values I:
   !>
   !>     du_x/dx = -(1 + nu)(1 - 2 nu)/E p - 2 (1 - nu^2)/(pi E) I[q]
   !>     du_y/dx =  (1 + nu)(1 - 2 nu)/E q - 2 (1 - nu^2)/(pi E) I[p]
   pure subroutine set_slopes(values, tractions, integrals, field)
      real(dp), intent(in) :: values(:)
      !> Tractions p and q at the position [Pa].
      real(dp), intent(in) :: tractions(2)
      !> Principal values I[p] and I[q] at the position [Pa].
      real(dp), intent(in) :: integrals(2)
      !> Results at the position; strain and slope of the surface are set.
      real(dp), intent(inout) :: field(:)
      real(dp) :: near, far

      near = (1 + values(plane_load_input%poisson_ratio))*(1 &
         & - 2*values(plane_load_input%poisson_ratio))/values(plane_load_input%young_modulus)
      far = 2*(1 - values(plane_load_input%poisson_ratio)**2)/(pi*values(plane_load_input%young_modulus))
      field(strip_load_output%strain) = -near*tractions(1) - far*integrals(2)
      field(strip_load_output%slope) = near*tractions(2) - far*integrals(1)
   end subroutine set_slopes

   !> See `pointwise_model_t`. The error of sampled tractions is what every second sample changes of the stresses: at least the
   !> error of the interpolation, where that falls with the distance of the samples or faster. Against the root of the squares of
   !> the stresses; 1 where they are 0 and should perhaps not be.
   subroutine solve_point(self, values, state, results, error_estimate, status, counts)
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
      real(dp) :: position(3), change

      position = self%get_position(values)
      call self%get_field(values, position, results)
      status = status_solved
      error_estimate = epsilon(error_estimate)
      if (nint(values(strip_load_input%distribution)) /= distribution_sampled) return
      if (.not. position(2) > 0 .and. self%samples%jumps_at(position(1))) return
      coarse = every_second(self%samples)
      associate (stress => results(plane_load_output%stress_xx:plane_load_output%stress_xy))
         change = norm2(stress - coarse%stress_at(position(1), position(2)))
         if (change > 0) error_estimate = max(error_estimate, change/max(change, norm2(stress)))
      end associate
      associate (unused => state, unused_counts => counts)
      end associate
   end subroutine solve_point

end module adfric_plane_strip_load_model

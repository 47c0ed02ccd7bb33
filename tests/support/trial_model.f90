! SPDX-License-Identifier: GPL-3.0-or-later
!> A model for tests of what lies around a model: cheap, with every kind of variable, with a contradiction, and with
!> results that can be said in advance.
!>
!> force = friction * load, regime by the sign of the velocity. A negative load has no equilibrium; a load
!> above `largest_load` does not converge, and `endless_load` exhausts the memory. `place` is the index of a
!> point in its block, so that a sweep whose blocks depended on the number of threads would show it.
module trial_model
   use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_quiet_nan
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set, unset
   use adfric_describe_derived, only: derived_t, add_derived
   use adfric_describe_model, only: model_t
   use adfric_describe_status, only: status_solved, status_no_equilibrium, status_not_converged, status_out_of_memory
   use adfric_describe_rows, only: count_row
   use adfric_describe_table, only: variable_t, result_t, profile_t, profile_axis_t, kind_real, kind_integer, kind_logical, &
      & kind_choice
   implicit none (type, external)
   private
   public :: trial_model_t, new_trial_model, trial_values, trial_force, trial_profile, largest_load, endless_load
   public :: kind_index, period_index, velocity_index, load_index, friction_index
   public :: strips_index, profiles_index, size_index, n_x_index, n_y_index

   !> Load above which nothing converges [N].
   real(dp), parameter :: largest_load = 1e6_dp
   !> Load that no memory is large enough for [N].
   real(dp), parameter :: endless_load = 1e12_dp
   !> Distance of the points of a profile [m].
   real(dp), parameter :: spacing = 0.5_dp

   !> Indices of the variables. There are two sizes, the first of the surface.
   integer, parameter :: kind_index = 1, period_index = 2, size_index = 3, velocity_index = 4, load_index = 5, &
      penetration_index = 6, friction_index = 7, strips_index = 8, second_size_index = 9, profiles_index = 10, &
      n_x_index = 11, n_y_index = 12, n_variables = 12

   !> The model.
   type, extends(model_t) :: trial_model_t
   contains
      procedure :: check_values
      procedure :: describe_results
      procedure :: describe_profiles
      procedure :: wants_profiles
      procedure :: get_profile_axes
      procedure :: solve_block
      procedure :: solve_profiles
      procedure :: derive_quantities
      procedure :: describe_case
   end type trial_model_t

contains

   !> Make the model.
   subroutine new_trial_model(self)
      type(trial_model_t), intent(out) :: self

      self%name = 'trial'
      self%summary = 'a block that slides on a table'
      self%references = 'Nobody, Nowhere 1 (2001) 1'
      self%profile_axes = 'y x'
      allocate (self%counts(1))
      self%counts(1) = count_row(name='steps_per_point', long_name='steps of the block')
      allocate (self%variables(n_variables))
      associate (variables => self%variables)
         call set(variables(kind_index), 'surface', 'kind', kind_choice, '', 1.0_dp)
         variables(kind_index)%choices = 'wave_2d wave_3d'
         call set(variables(period_index), 'surface', 'period', kind_real, 'm', unset)
         variables(period_index)%lower = 0
         variables(period_index)%lower_open = .true.
         call set(variables(size_index), 'surface', 'size', kind_real, 'm', unset)
         call set(variables(velocity_index), 'operating', 'velocity', kind_real, 'm/s', 0.5_dp)
         variables(velocity_index)%lower = 0
         call set(variables(load_index), 'operating', 'load', kind_real, 'N', unset)
         call set(variables(penetration_index), 'operating', 'penetration', kind_real, 'm', unset)
         call set(variables(friction_index), 'operating', 'friction', kind_real, '-', 0.5_dp)
         variables(friction_index)%lower = 0
         variables(friction_index)%upper = 1
         variables(friction_index)%upper_open = .true.
         call set(variables(strips_index), 'numerics', 'strips', kind_integer, '-', 10.0_dp)
         variables(strips_index)%lower = 1
         call set(variables(second_size_index), 'numerics', 'size', kind_real, 'm', unset)
         call set(variables(profiles_index), 'output', 'profiles', kind_logical, '', 0.0_dp)
         call set(variables(n_x_index), 'output', 'n_x', kind_integer, '-', 4.0_dp)
         call set(variables(n_y_index), 'output', 'n_y', kind_integer, '-', 1.0_dp)
      end associate
      call add_results(self)
   end subroutine new_trial_model

   !> Describe a variable.
   subroutine set(variable, group, name, kind, unit, default)
      type(variable_t), intent(inout) :: variable
      character(*), intent(in) :: group, name
      integer, intent(in) :: kind
      character(*), intent(in) :: unit
      real(dp), intent(in) :: default

      variable%group = group
      variable%name = name
      variable%kind = kind
      variable%unit = unit
      variable%meaning = 'the '//name
      variable%choices = ''
      variable%default = default
   end subroutine set

   !> Describe the results and the profiles.
   subroutine add_results(self)
      type(trial_model_t), intent(inout) :: self

      allocate (self%results(4), self%profiles(2))
      self%results(1) = result_t('load', 'N', 'load that is carried', '', .true.)
      self%results(2) = result_t('force', 'N', 'friction force', '', .true.)
      self%results(3) = result_t('regime', '-', 'what the block does', 'rests slides', .false.)
      self%results(4) = result_t('place', '-', 'place in its block', '', .false.)
      self%profiles(1) = profile_t('pressure', 'Pa', 'pressure')
      self%profiles(2) = profile_t('gap', 'm', 'gap')
   end subroutine add_results

   !> Values of a point that can be solved: the defaults, and a load of 1 N.
   pure function trial_values(model) result(values)
      type(trial_model_t), intent(in) :: model
      real(dp) :: values(n_variables)

      values = model%variables%default
      values(load_index) = 1
   end function trial_values

   !> Friction force [N].
   elemental real(dp) function trial_force(friction, load)
      real(dp), intent(in) :: friction, load

      trial_force = friction*load
   end function trial_force

   !> Pressure (1) or gap (2) at the point (i, j) from 0, i along x.
   elemental real(dp) function trial_profile(load, i, j, number)
      real(dp), intent(in) :: load
      integer, intent(in) :: i, j, number

      trial_profile = number*(load + i + 100*j)
   end function trial_profile

   !> The period is required and longer than 1e-6, load and penetration contradict each other, and a load has a limit.
   subroutine check_values(self, values, is_swept, problems)
      class(trial_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      logical, intent(in) :: is_swept(:)
      type(problems_t), intent(inout) :: problems

      if (size(is_swept) /= size(self%variables)) error stop 'is_swept has the wrong size'
      if (.not. is_set(values(period_index))) call problems%add('surface', 'period', 'not given, needed: a number')
      if (values(period_index) < 1e-6_dp) call problems%add('surface', 'period', 'shorter than an atom')
      if (.not. is_set(values(load_index))) return
      if (is_set(values(penetration_index))) &
         call problems%add('operating', 'load', 'contradicts penetration, given both, allowed: one of them')
      if (values(load_index) > 100) call problems%add('operating', '', 'the weight breaks the surface')
   end subroutine check_values

   function describe_results(self, values) result(results)
      class(trial_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(result_t), allocatable :: results(:)

      results = self%results
      if (values(kind_index) > 1.5_dp) results(2)%unit = 'N/m'
   end function describe_results

   !> In units of something else on a round table.
   function describe_profiles(self, values) result(profiles)
      class(trial_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(profile_t), allocatable :: profiles(:)

      profiles = self%profiles
      if (values(kind_index) > 1.5_dp) profiles(1)%unit = '-'
   end function describe_profiles

   pure logical function wants_profiles(self, values)
      class(trial_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)

      wants_profiles = size(self%profiles) > 0 .and. values(profiles_index) > 0.5_dp
   end function wants_profiles

   subroutine get_profile_axes(self, values, axes)
      class(trial_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(profile_axis_t), allocatable, intent(out) :: axes(:)
      integer, parameter :: n_indices(2) = [n_y_index, n_x_index]
      character(*), parameter :: names = 'yx'
      integer :: i, k, n

      allocate (axes(2))
      do k = 1, 2
         n = nint(values(n_indices(k)))
         if (size(self%profiles) == 0) n = 1
         axes(k)%name = names(k:k)
         axes(k)%unit = trim(merge('- ', 'm ', values(kind_index) > 1.5_dp))
         axes(k)%long_name = 'place along '//names(k:k)
         axes(k)%coordinates = [(spacing*i, i=0, n - 1)]
      end do
   end subroutine get_profile_axes

   subroutine solve_block(self, values, results, error_estimate, status, counts)
      class(trial_model_t), intent(in) :: self
      real(dp), intent(in), contiguous :: values(:, :)
      real(dp), intent(out) :: results(:, :)
      real(dp), intent(out) :: error_estimate(:)
      integer, intent(out) :: status(:)
      real(dp), intent(out) :: counts(:)
      integer :: i

      do i = 1, size(status)
         associate (load => values(load_index, i), &
                    force => trial_force(values(friction_index, i), values(load_index, i)))
            results(:, i) = [load, force, merge(1.0_dp, 0.0_dp, values(velocity_index, i) > 0), real(i, dp)]
            error_estimate(i) = 1e-12_dp*i
            status(i) = status_solved
            if (load < 0) status(i) = status_no_equilibrium
            if (load > largest_load) status(i) = status_not_converged
            if (load >= endless_load) status(i) = status_out_of_memory
         end associate
         if (status(i) /= status_solved) results(:, i) = ieee_value(1.0_dp, ieee_quiet_nan)
      end do
      counts(1) = 0.1_dp*size(status)
   end subroutine solve_block

   subroutine solve_profiles(self, values, results, profiles)
      class(trial_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      real(dp), intent(in) :: results(:)
      real(dp), intent(out) :: profiles(:, :, :)
      integer :: i, j, k

      do k = 1, size(self%profiles)
         do j = 1, size(profiles, 2)
            do i = 1, size(profiles, 1)
               profiles(i, j, k) = trial_profile(results(1), i - 1, j - 1, k) + 0*values(1)
            end do
         end do
      end do
   end subroutine solve_profiles

   !> Twice the friction, and twice the load.
   function derive_quantities(self, values) result(derived)
      class(trial_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(derived_t), allocatable :: derived(:)

      allocate (derived(0))
      if (size(self%variables) == 0) return
      call add_derived(derived, 'twice_friction', '-', 'twice the friction', 2*values(friction_index), 'friction')
      call add_derived(derived, 'twice_load', 'N', 'twice the load', 2*values(load_index))
   end function derive_quantities

   function describe_case(self, values) result(text)
      class(trial_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text
      character(24) :: buffer

      write (buffer, '(es10.3)') trial_force(values(friction_index), values(load_index))
      text = self%name//' force '//trim(adjustl(buffer))//' N'
   end function describe_case

end module trial_model

!> A model without physics, for the tests of the input: every kind of variable, and one contradiction.
module fake_model
   use adfric_base_kinds, only: dp
   use adfric_base_model, only: model_t, variable_t, result_t, attribute_t, &
                                kind_real, kind_integer, kind_logical, kind_choice
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   implicit none (type, external)
   private
   public :: fake_model_t, new_fake_model
   public :: i_kind, i_period, i_velocity, i_load, i_penetration, i_ratio, i_strips, i_profiles, i_size_one

   !> Places of the variables.
   integer, parameter :: i_kind = 1, i_period = 2, i_velocity = 3, i_load = 4, i_penetration = 5, i_ratio = 6, &
                         i_strips = 7, i_profiles = 8, i_size_one = 9, i_size_two = 10, n_variables = 10

   !> The model.
   type, extends(model_t) :: fake_model_t
   contains
      procedure :: check_values
      procedure :: describe_results
      procedure :: wants_profiles
      procedure :: get_profile_axis
      procedure :: solve_block
      procedure :: solve_profiles
      procedure :: describe_case
   end type fake_model_t

contains

   !> Make the model.
   subroutine new_fake_model(self)
      type(fake_model_t), intent(out) :: self

      self%name = 'fake'
      self%summary = 'nothing'
      allocate (self%variables(n_variables), self%results(0), self%profiles(0))
      self%profile_axes = ''
      self%variables(i_kind) = named('surface', 'kind', kind_choice, '')
      self%variables(i_kind)%choices = 'wave_2d wave_3d'
      self%variables(i_kind)%default = 1
      self%variables(i_period) = named('surface', 'period', kind_real, 'm')
      self%variables(i_period)%lower = 0
      self%variables(i_period)%lower_open = .true.
      self%variables(i_velocity) = named('operating', 'velocity', kind_real, 'm/s')
      self%variables(i_velocity)%default = 0.5_dp
      self%variables(i_velocity)%lower = 0
      self%variables(i_load) = named('operating', 'load', kind_real, 'N')
      self%variables(i_penetration) = named('operating', 'penetration', kind_real, 'm')
      self%variables(i_ratio) = named('operating', 'ratio', kind_real, '-')
      self%variables(i_ratio)%default = 0.3_dp
      self%variables(i_ratio)%lower = 0
      self%variables(i_ratio)%upper = 0.5_dp
      self%variables(i_ratio)%upper_open = .true.
      self%variables(i_strips) = named('numerics', 'strips', kind_integer, '-')
      self%variables(i_strips)%default = 10
      self%variables(i_strips)%lower = 1
      self%variables(i_profiles) = named('output', 'profiles', kind_logical, '')
      self%variables(i_profiles)%default = 0
      self%variables(i_size_one) = named('surface', 'size', kind_real, 'm')
      self%variables(i_size_two) = named('numerics', 'size', kind_real, 'm')
   end subroutine new_fake_model

   !> A variable without default and range.
   function named(group, name, kind, unit) result(variable)
      character(*), intent(in) :: group, name
      integer, intent(in) :: kind
      character(*), intent(in) :: unit
      type(variable_t) :: variable

      variable%group = group
      variable%name = name
      variable%kind = kind
      variable%unit = unit
      variable%meaning = 'something'
      variable%choices = ''
   end function named

   !> The period is required, load and penetration contradict each other, and a period is longer than 1e-6.
   subroutine check_values(self, values, is_swept, problems)
      class(fake_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      logical, intent(in) :: is_swept(:)
      type(problems_t), intent(inout) :: problems

      if (size(is_swept) /= size(self%variables)) error stop 'is_swept has the wrong size'
      if (.not. is_set(values(i_period))) call problems%add('surface', 'period', 'not given, needed: a number')
      if (is_set(values(i_period)) .and. values(i_period) < 1e-6_dp) &
         call problems%add('surface', 'period', 'shorter than an atom')
      if (is_set(values(i_load)) .and. is_set(values(i_penetration))) &
         call problems%add('operating', 'load', 'contradicts penetration, given both, allowed: one of them')
      if (is_set(values(i_load)) .and. values(i_load) > 100) &
         call problems%add('operating', '', 'the weight breaks the surface')
   end subroutine check_values

   !> Nothing.
   function describe_results(self, values) result(results)
      class(fake_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(result_t), allocatable :: results(:)

      allocate (results(0))
      if (size(values) /= size(self%variables)) error stop 'values have the wrong size'
   end function describe_results

   !> As the variable says.
   pure logical function wants_profiles(self, values)
      class(fake_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)

      wants_profiles = values(i_profiles) > 0 .and. size(self%profiles) > 0
   end function wants_profiles

   !> Nothing.
   function get_profile_axis(self, values, axis) result(coordinate)
      class(fake_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      integer, intent(in) :: axis
      real(dp), allocatable :: coordinate(:)

      allocate (coordinate(0))
      if (size(values) /= size(self%variables) .or. axis < 1) error stop 'wrong arguments'
   end function get_profile_axis

   !> Nothing.
   subroutine solve_block(self, values, results, error_estimate, status, attributes)
      class(fake_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:, :)
      real(dp), intent(out) :: results(:, :)
      real(dp), intent(out) :: error_estimate(:)
      integer, intent(out) :: status(:)
      type(attribute_t), allocatable, intent(out) :: attributes(:)

      allocate (attributes(0))
      results = 0
      error_estimate = 0
      status = 0
      if (size(values, 1) /= size(self%variables)) error stop 'values have the wrong size'
   end subroutine solve_block

   !> Nothing.
   subroutine solve_profiles(self, values, results, profiles)
      class(fake_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      real(dp), intent(in) :: results(:)
      real(dp), intent(out) :: profiles(:, :, :)

      profiles = 0
      if (size(values) /= size(self%variables) .or. size(results) > 0) error stop 'wrong arguments'
   end subroutine solve_profiles

   !> Nothing.
   function describe_case(self, values) result(text)
      class(fake_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text

      text = self%summary
      if (size(values) /= size(self%variables)) error stop 'values have the wrong size'
   end function describe_case

end module fake_model

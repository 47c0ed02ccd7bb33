!> Rows of the tables of models.
module adfric_model_rows
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: unset
   use adfric_model_table, only: variable_t, profile_t, kind_real, kind_integer, kind_logical, kind_choice, kind_dataset
   implicit none (type, external)
   private
   public :: positive, number, choice, dataset, set_output_axis, output_switch, poisson_ratio_row, contact_profiles

   !> Sizes beyond these are those of a slip in the units.
   real(dp), parameter :: largest_unit = 1.0e30_dp, smallest_unit = 1.0e-30_dp

contains

   !> A real variable > 0 without default.
   function positive(group, name, unit, meaning) result(variable)
      !> Namelist group of the variable, without `&`.
      character(*), intent(in) :: group
      !> Name of the variable in its group.
      character(*), intent(in) :: name
      !> SI unit of the variable, `-` for a pure number.
      character(*), intent(in) :: unit
      !> What the variable is, for `adfric help`.
      character(*), intent(in) :: meaning
      type(variable_t) :: variable

      variable = variable_t(group, name, kind_real, unit, meaning, '', unset, smallest_unit, largest_unit)
   end function positive

   !> A real variable of any value.
   function number(group, name, unit, meaning, default) result(variable)
      !> Namelist group of the variable, without `&`.
      character(*), intent(in) :: group
      !> Name of the variable in its group.
      character(*), intent(in) :: name
      !> SI unit of the variable, `-` for a pure number.
      character(*), intent(in) :: unit
      !> What the variable is, for `adfric help`.
      character(*), intent(in) :: meaning
      !> Value where the user gives none; not present: there is no default.
      real(dp), intent(in), optional :: default
      type(variable_t) :: variable

      variable = variable_t(group, name, kind_real, unit, meaning, '', unset, -largest_unit, largest_unit)
      if (present(default)) variable%default = default
   end function number

   !> The variable for Poisson's ratio in &solid.
   function poisson_ratio_row() result(variable)
      type(variable_t) :: variable

      variable = variable_t('solid', 'poisson_ratio', kind_real, '-', 'Poisson''s ratio', '', unset, -1.0_dp, 0.5_dp, .true.)
   end function poisson_ratio_row

   !> A variable that is a word of a list, without default.
   function choice(group, name, meaning, choices) result(variable)
      !> Namelist group of the variable, without `&`.
      character(*), intent(in) :: group
      !> Name of the variable in its group.
      character(*), intent(in) :: name
      !> What the variable is, for `adfric help`.
      character(*), intent(in) :: meaning
      !> Allowed words, separated by a blank.
      character(*), intent(in) :: choices
      type(variable_t) :: variable

      variable = variable_t(group, name, kind_choice, '', meaning, choices)
   end function choice

   !> A variable that is a dataset of a file.
   function dataset(group, name, unit, meaning, largest_rank, least_count) result(variable)
      !> Namelist group of the variable, without `&`.
      character(*), intent(in) :: group
      !> Name of the variable in its group.
      character(*), intent(in) :: name
      !> SI unit of the variable, `-` for a pure number.
      character(*), intent(in) :: unit
      !> What the variable is, for `adfric help`.
      character(*), intent(in) :: meaning
      !> Most dimensions that the dataset may have, 1 or 2.
      integer, intent(in) :: largest_rank
      !> Fewest values that the dataset needs along each dimension.
      integer, intent(in) :: least_count
      type(variable_t) :: variable

      variable = number(group, name, unit, meaning)
      variable%kind = kind_dataset
      variable%largest_rank = largest_rank
      variable%least_count = least_count
   end function dataset

   !> The switch that says whether profiles are wanted.
   function output_switch() result(variable)
      type(variable_t) :: variable

      variable = variable_t('output', 'profiles', kind_logical, '', 'write profiles of every point', '', 0.0_dp)
   end function output_switch

   !> Set the rows for beginning, end and number of samples along an axis of the profiles.
   subroutine set_output_axis(name, n_default, is_depth, variables)
      !> Name of the axis, such as 'x'.
      character(*), intent(in) :: name
      !> Number of samples along the axis where the user gives none.
      integer, intent(in) :: n_default
      !> Does the axis point into the solid, so that it has no negative values?
      logical, intent(in) :: is_depth
      !> Receives the rows of beginning, end and number of samples; shape `(3)`.
      type(variable_t), intent(inout) :: variables(:)
      integer :: k

      variables(1) = number('output', 'min', 'm', 'where profiles begin', 0.0_dp)
      variables(2) = number('output', 'max', 'm', 'where profiles end')
      variables(3) = variable_t('output', 'n', kind_integer, '-', 'samples of profiles', '', real(n_default, dp), 1.0_dp, 1.0e7_dp)
      variables(1)%name = name//'_min'
      variables(2)%name = name//'_max'
      variables(3)%name = 'n_'//name
      do k = 1, 3
         variables(k)%meaning = variables(k)%meaning//' along '//name
      end do
      if (is_depth) variables(:2)%lower = 0
   end subroutine set_output_axis

   !> Rows of the profiles of pressure and gap.
   function contact_profiles() result(p)
      type(profile_t) :: p(2)

      p(1) = profile_t('pressure', 'Pa', 'pressure, compression positive')
      p(2) = profile_t('gap', 'm', 'gap')
   end function contact_profiles

end module adfric_model_rows

! SPDX-License-Identifier: GPL-3.0-or-later
!> Rows of the tables of models. They are written by keyword, so that a table says what each of its numbers is.
module adfric_describe_rows
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_base_kinds, only: dp
   use adfric_base_words, only: count_words, find_word, get_word
   use adfric_describe_table, only: variable_t, result_t, profile_t, profile_axis_t, count_t, kind_real, kind_integer, &
      & kind_logical, kind_choice, kind_dataset
   implicit none (type, external)
   private
   public :: positive, above_zero, number, any_number, whole_number, poisson_ratio, choice, switch, dataset, list_row
   public :: several_words, columns_row, set_output_axis, set_coordinate, result_row, count_row, contact_profiles

   !> Sizes beyond these are those of a slip in the units.
   real(dp), parameter :: largest_unit = 1.0e30_dp, smallest_unit = 1.0e-30_dp

contains

   !> A real variable > 0 of a size that there is.
   function positive(group, name, unit, meaning, default) result(variable)
      !> Group of the variable, without `&`, its name, its SI unit (`-` for a pure number), and what it is, for `adfric help`.
      character(*), intent(in) :: group, name, unit, meaning
      !> Value where the user gives none; not present: there is no default.
      real(dp), intent(in), optional :: default
      type(variable_t) :: variable

      variable = number(group, name, unit, meaning, default, lower=smallest_unit)
   end function positive

   !> A real variable > 0 of any size, without default.
   function above_zero(group, name, unit, meaning) result(variable)
      !> Group of the variable, without `&`, its name, its SI unit (`-` for a pure number), and what it is, for `adfric help`.
      character(*), intent(in) :: group, name, unit, meaning
      type(variable_t) :: variable

      variable = any_number(group, name, unit, meaning, lower=0.0_dp)
      variable%lower_open = .true.
   end function above_zero

   !> A real variable of either sign, of a size that there is.
   function number(group, name, unit, meaning, default, lower, upper) result(variable)
      !> Group of the variable, without `&`, its name, its SI unit (`-` for a pure number), and what it is, for `adfric help`.
      character(*), intent(in) :: group, name, unit, meaning
      !> Value where the user gives none; not present: there is no default.
      real(dp), intent(in), optional :: default
      !> Least value that is allowed; not present: any negative one of a size that there is.
      real(dp), intent(in), optional :: lower
      !> Largest value that is allowed; not present: any of a size that there is.
      real(dp), intent(in), optional :: upper
      type(variable_t) :: variable

      variable = any_number(group, name, unit, meaning, default, -largest_unit, largest_unit)
      if (present(lower)) variable%lower = lower
      if (present(upper)) variable%upper = upper
   end function number

   !> A real variable of any size.
   function any_number(group, name, unit, meaning, default, lower, upper) result(variable)
      !> Group of the variable, without `&`, its name, its SI unit (`-` for a pure number), and what it is, for `adfric help`.
      character(*), intent(in) :: group, name, unit, meaning
      !> Value where the user gives none, and least and largest value that are allowed; not present: none, and any.
      real(dp), intent(in), optional :: default, lower, upper
      type(variable_t) :: variable

      variable = row_of(kind_real, group, name, unit, meaning)
      if (present(default)) variable%default = default
      if (present(lower)) variable%lower = lower
      if (present(upper)) variable%upper = upper
   end function any_number

   !> A variable that is a whole number.
   function whole_number(group, name, meaning, default, lower, upper, multiple_of) result(variable)
      !> Group of the variable, without `&`, its name, and what it is, for `adfric help`.
      character(*), intent(in) :: group, name, meaning
      !> Value where the user gives none; 0: the solver chooses.
      integer, intent(in) :: default
      !> Least and largest value that is allowed.
      integer, intent(in) :: lower, upper
      !> What every value has to be a multiple of, >= 1; any whole number will do if absent.
      integer, intent(in), optional :: multiple_of
      type(variable_t) :: variable

      variable = row_of(kind_integer, group, name, '-', meaning)
      variable%default = default
      variable%zero_is_automatic = default == 0
      variable%lower = lower
      variable%upper = upper
      if (present(multiple_of)) variable%multiple_of = multiple_of
   end function whole_number

   !> A variable for Poisson's ratio.
   function poisson_ratio(group, name, meaning) result(variable)
      !> Namelist group of the variable, without `&`.
      character(*), intent(in) :: group
      !> Name of the variable in its group.
      character(*), intent(in) :: name
      !> Whose ratio it is, for `adfric help`.
      character(*), intent(in) :: meaning
      type(variable_t) :: variable

      variable = any_number(group, name, '-', meaning, lower=-1.0_dp, upper=0.5_dp)
      variable%lower_open = .true.
   end function poisson_ratio

   !> A variable that is a word of a list.
   function choice(group, name, meaning, choices, default) result(variable)
      !> Group of the variable, without `&`, its name, and what it is, for `adfric help`.
      character(*), intent(in) :: group, name, meaning
      !> Allowed words, separated by a blank.
      character(*), intent(in) :: choices
      !> The word that it is where the user gives none; not present: there is no default.
      character(*), intent(in), optional :: default
      type(variable_t) :: variable
      integer :: k

      variable = row_of(kind_choice, group, name, '', meaning)
      variable%choices = choices
      if (.not. present(default)) return
      do k = 1, count_words(choices)
         if (get_word(choices, k) == default) variable%default = k
      end do
   end function choice

   !> A variable that is one word of a list or several, without default.
   function several_words(group, name, meaning, choices) result(variable)
      !> Group of the variable, without `&`, its name, and what it is, for `adfric help`.
      character(*), intent(in) :: group, name, meaning
      !> Allowed words, separated by a blank; 7 at most, so that the results file keeps them in a small integer.
      character(*), intent(in) :: choices
      type(variable_t) :: variable

      if (has_asserts) call assert(count_words(choices) <= 7, 'several_words: 7 words at most')
      variable = choice(group, name, meaning, choices)
      variable%takes_several = .true.
   end function several_words

   !> A variable that is true or false.
   function switch(group, name, meaning, default) result(variable)
      !> Namelist group of the variable, without `&`.
      character(*), intent(in) :: group
      !> Name of the variable in its group.
      character(*), intent(in) :: name
      !> What is so if it is true, for `adfric help`.
      character(*), intent(in) :: meaning
      !> Value where the user gives none; not present: there is no default.
      logical, intent(in), optional :: default
      type(variable_t) :: variable

      variable = row_of(kind_logical, group, name, '', meaning)
      if (present(default)) variable%default = merge(1, 0, default)
   end function switch

   !> A variable that is a dataset of a file.
   function dataset(group, name, unit, meaning, largest_rank, least_count, attributes, attribute_units) result(variable)
      !> Group of the variable, without `&`, its name, its SI unit (`-` for a pure number), and what it is, for `adfric help`.
      character(*), intent(in) :: group, name, unit, meaning
      !> Most dimensions that the dataset may have, 1 or 2.
      integer, intent(in) :: largest_rank
      !> Fewest values that the dataset needs along each dimension.
      integer, intent(in) :: least_count
      !> Names of the attributes of the dataset that the model takes, and their SI units, each separated by a blank; not present:
      !> it takes none.
      character(*), intent(in), optional :: attributes, attribute_units
      type(variable_t) :: variable

      variable = number(group=group, name=name, unit=unit, meaning=meaning)
      variable%kind = kind_dataset
      variable%largest_rank = largest_rank
      variable%least_count = least_count
      if (present(attributes)) variable%attributes = attributes
      if (present(attribute_units)) variable%attribute_units = attribute_units
   end function dataset

   !> A variable that is a list of numbers, which stand in the input or in a dataset of one dimension.
   function list_row(group, name, unit, meaning, most_count, least_count, lower, upper, lower_open, attributes, attribute_units) &
         result(variable)
      !> Namelist group of the variable, without `&`.
      character(*), intent(in) :: group
      !> Name of the variable in its group.
      character(*), intent(in) :: name
      !> SI unit of each number, `-` for pure numbers.
      character(*), intent(in) :: unit
      !> What the numbers are, for `adfric help`.
      character(*), intent(in) :: meaning
      !> Most numbers that the list may have.
      integer, intent(in) :: most_count
      !> Fewest numbers that the list needs; not present: 1.
      integer, intent(in), optional :: least_count
      !> Least value of each number; not present: any negative one of a size that there is.
      real(dp), intent(in), optional :: lower
      !> Largest value of each number; not present: any of a size that there is.
      real(dp), intent(in), optional :: upper
      !> Is the least value itself not allowed? Not present: it is allowed.
      logical, intent(in), optional :: lower_open
      !> Names of the attributes of a dataset that the model takes, and their SI units, each separated by a blank; not present: it
      !> takes none.
      character(*), intent(in), optional :: attributes, attribute_units
      type(variable_t) :: variable

      variable = number(group=group, name=name, unit=unit, meaning=meaning, lower=lower, upper=upper)
      variable%kind = kind_dataset
      variable%is_list = .true.
      variable%most_count = most_count
      if (present(least_count)) variable%least_count = least_count
      if (present(lower_open)) variable%lower_open = lower_open
      if (present(attributes)) variable%attributes = attributes
      if (present(attribute_units)) variable%attribute_units = attribute_units
   end function list_row

   !> A variable that names a group of a file with datasets of one dimension and equal length.
   function columns_row(group, name, columns, units, meaning, least_count, lower, upper, lower_open, attributes, &
         attribute_units) result(variable)
      !> Namelist group of the variable, without `&`.
      character(*), intent(in) :: group
      !> Name of the variable in its group.
      character(*), intent(in) :: name
      !> Names of the datasets, separated by a blank; `frequency` [Hz] may stand for `omega` [rad/s].
      character(*), intent(in) :: columns
      !> SI units of the datasets, separated by a blank.
      character(*), intent(in) :: units
      !> What the datasets are, for `adfric help`.
      character(*), intent(in) :: meaning
      !> Fewest values that each dataset needs.
      integer, intent(in) :: least_count
      !> Least value in each dataset; not present: any negative one of a size that there is.
      real(dp), intent(in), optional :: lower
      !> Largest value in each dataset; not present: any of a size that there is.
      real(dp), intent(in), optional :: upper
      !> Is the least value itself not allowed? Not present: it is allowed.
      logical, intent(in), optional :: lower_open
      !> Names of the attributes of the group that the model takes, and their SI units, each separated by a blank; not present: it
      !> takes none.
      character(*), intent(in), optional :: attributes, attribute_units
      type(variable_t) :: variable

      variable = number(group=group, name=name, unit='', meaning=meaning, lower=lower, upper=upper)
      variable%kind = kind_dataset
      variable%columns = columns
      variable%column_units = units
      variable%least_count = least_count
      if (present(lower_open)) variable%lower_open = lower_open
      if (present(attributes)) variable%attributes = attributes
      if (present(attribute_units)) variable%attribute_units = attribute_units
   end function columns_row

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

      variables(1) = number(group='output', name=name//'_min', unit='m', meaning='where profiles begin along '//name, &
         & default=0.0_dp)
      variables(2) = number(group='output', name=name//'_max', unit='m', meaning='where profiles end along '//name)
      variables(3) = whole_number(group='output', name='n_'//name, meaning='samples of profiles along '//name, default=n_default, &
         & lower=1, upper=10000000)
      if (is_depth) variables(:2)%lower = 0
   end subroutine set_output_axis

   !> Set a profile axis that is a coordinate.
   subroutine set_coordinate(axis, names, index, coordinates)
      !> Receives name, unit and coordinates.
      type(profile_axis_t), intent(inout) :: axis
      !> Names of all profile axes of the model, such as 'y x'.
      character(*), intent(in) :: names
      !> Index of the axis among them, from 1.
      integer, intent(in) :: index
      !> Coordinates along the axis [m].
      real(dp), intent(in) :: coordinates(:)

      call find_word(names, index, axis%name)
      axis%unit = 'm'
      axis%long_name = 'coordinate '//axis%name//' of the profiles'
      axis%coordinates = coordinates
   end subroutine set_coordinate

   !> Rows of the profiles of pressure and gap.
   function contact_profiles() result(p)
      type(profile_t) :: p(2)

      p(1) = profile_t(name='pressure', unit='Pa', long_name='pressure, compression positive')
      p(2) = profile_t(name='gap', unit='m', long_name='gap')
   end function contact_profiles

   !> A row of the results.
   function result_row(name, unit, long_name, is_main, flag_meanings) result(row)
      !> Name of the result.
      character(*), intent(in) :: name
      !> SI unit of the result, `-` for a pure number.
      character(*), intent(in) :: unit
      !> What the result is, for `adfric help` and the results file.
      character(*), intent(in) :: long_name
      !> Does the result stand in the table at the end of a run? Not present: it does not.
      logical, intent(in), optional :: is_main
      !> Meanings of 0, 1, 2, ... separated by a blank; not present: the result is a number.
      character(*), intent(in), optional :: flag_meanings
      type(result_t) :: row

      row%name = name
      row%unit = unit
      row%long_name = long_name
      row%flag_meanings = ''
      if (present(is_main)) row%is_main = is_main
      if (present(flag_meanings)) row%flag_meanings = flag_meanings
   end function result_row

   !> A row of the counts.
   function count_row(name, long_name) result(row)
      !> Name of the attribute that has the mean over the points.
      character(*), intent(in) :: name
      !> What is counted, for `adfric help`.
      character(*), intent(in) :: long_name
      type(count_t) :: row

      row%name = name
      row%long_name = long_name
   end function count_row

   !> A row of the variables, without default and bounds.
   function row_of(kind, group, name, unit, meaning) result(variable)
      !> One of `kind_...`.
      integer, intent(in) :: kind
      !> Namelist group of the variable, without `&`.
      character(*), intent(in) :: group
      character(*), intent(in) :: name
      !> SI unit of the variable, `-` for a pure number, empty where it has none.
      character(*), intent(in) :: unit
      !> What the variable is, for `adfric help`.
      character(*), intent(in) :: meaning
      type(variable_t) :: variable

      variable%kind = kind
      variable%group = group
      variable%name = name
      variable%unit = unit
      variable%meaning = meaning
      variable%choices = ''
      variable%columns = ''
      variable%column_units = ''
      variable%attributes = ''
      variable%attribute_units = ''
   end function row_of

end module adfric_describe_rows

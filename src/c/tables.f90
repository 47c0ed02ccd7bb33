! SPDX-License-Identifier: GPL-3.0-or-later
!> The tables of a model as C sees them. They are made once, and stay until the program ends.
module adfric_c_tables
   use, intrinsic :: ieee_arithmetic, only: ieee_positive_inf, ieee_value
   use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_ptr
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_text, only: show_number
   use adfric_base_unset, only: is_set, unset
   use adfric_base_words, only: get_word
   use adfric_c_texts, only: keep_text
   use adfric_input_variable, only: describe_allowed
   use adfric_describe_model, only: model_t
   use adfric_describe_table, only: common_results, kind_choice, kind_dataset, kind_integer, kind_logical, kind_real, &
      & result_t, variable_t
   use adfric_output_constants, only: file_unit
   implicit none (type, external)
   private
   public :: model_info_t, variable_info_t, result_info_t, tables_t, new_tables, describe_variable, set_result

   !> `adfric_model_info` of adfric.h.
   type, bind(c) :: model_info_t
      !> Texts.
      type(c_ptr) :: name, summary, references, profile_axes
      !> Numbers of rows.
      integer(c_int32_t) :: n_variables, n_results, n_profiles
   end type model_info_t

   !> `adfric_variable_info` of adfric.h.
   type, bind(c) :: variable_info_t
      !> Texts.
      type(c_ptr) :: group, name, unit, meaning, allowed, choices, default_text, columns, column_units
      !> Default and bounds.
      real(c_double) :: default_value, lower, upper
      !> Kind, what is not allowed of the bounds, and what an array may be.
      integer(c_int32_t) :: kind, lower_is_open, upper_is_open, largest_rank, is_list
   end type variable_info_t

   !> `adfric_result_info` of adfric.h.
   type, bind(c) :: result_info_t
      !> Texts.
      type(c_ptr) :: name, unit, long_name, flag_meanings
      !> Number of the first state.
      integer(c_int32_t) :: first_flag
   end type result_info_t

   !> All tables of a model.
   type :: tables_t
      !> The model.
      type(model_info_t) :: model
      !> Its variables.
      type(variable_info_t), allocatable :: variables(:)
      !> Its results, with those of every model.
      type(result_info_t), allocatable :: results(:)
      !> Its profiles.
      type(result_info_t), allocatable :: profiles(:)
   end type tables_t

contains

   !> Make the tables of a model.
   subroutine new_tables(self, model, error)
      !> Receives the tables.
      type(tables_t), intent(out) :: self
      !> The model.
      class(model_t), intent(in) :: model
      !> Allocated if there is too little memory.
      type(error_t), allocatable, intent(inout) :: error
      type(result_t) :: common(3)
      integer :: i, n

      n = size(model%results)
      allocate (self%variables(size(model%variables)), self%results(n + size(common)), self%profiles(size(model%profiles)))
      call set_model(self, model, error)
      do i = 1, size(model%variables)
         call set_texts(self%variables(i), model%variables(i), error)
         call set_numbers(self%variables(i), model%variables(i))
      end do
      do i = 1, n
         associate (row => model%results(i))
            call set_result(self%results(i), row%name, row%unit, row%long_name, row%flag_meanings, error)
         end associate
      end do
      common = common_results()
      do i = 1, size(common)
         associate (row => common(i))
            call set_result(self%results(n + i), row%name, row%unit, row%long_name, row%flag_meanings, error)
         end associate
      end do
      do i = 1, size(model%profiles)
         associate (row => model%profiles(i))
            call set_result(self%profiles(i), row%name, row%unit, row%long_name, '', error)
         end associate
      end do
   end subroutine new_tables

   !> What is said of a variable.
   subroutine describe_variable(info, variable, error)
      !> Receives texts and numbers.
      type(variable_info_t), intent(out) :: info
      !> Row of the model's table.
      type(variable_t), intent(in) :: variable
      !> Receives that there is too little memory.
      type(error_t), allocatable, intent(inout) :: error

      call set_texts(info, variable, error)
      call set_numbers(info, variable)
   end subroutine describe_variable

   !> What is said of the model as a whole.
   subroutine set_model(self, model, error)
      !> The tables, with as many rows as the model has.
      type(tables_t), intent(inout) :: self
      class(model_t), intent(in) :: model
      type(error_t), allocatable, intent(inout) :: error

      call keep_text(model%name, self%model%name, error)
      call keep_text(model%summary, self%model%summary, error)
      call keep_text(model%references, self%model%references, error)
      call keep_text(model%profile_axes, self%model%profile_axes, error)
      self%model%n_variables = size(self%variables)
      self%model%n_results = size(self%results)
      self%model%n_profiles = size(self%profiles)
   end subroutine set_model

   !> Texts of a variable.
   subroutine set_texts(info, variable, error)
      type(variable_info_t), intent(inout) :: info
      type(variable_t), intent(in) :: variable
      type(error_t), allocatable, intent(inout) :: error
      logical :: has_columns

      call keep_text(variable%group, info%group, error)
      call keep_text(variable%name, info%name, error)
      call keep_text(unit_of_numbers(variable%kind, variable%unit), info%unit, error)
      call keep_text(variable%meaning, info%meaning, error)
      call keep_text(describe_allowed(variable), info%allowed, error)
      call keep_text(text_of_default(variable), info%default_text, error)
      if (variable%kind == kind_choice) then
         call keep_text(variable%choices, info%choices, error)
      else
         call keep_text('', info%choices, error)
      end if
      has_columns = variable%n_columns() > 0
      if (has_columns) then
         call keep_text(variable%columns, info%columns, error)
         call keep_text(variable%column_units, info%column_units, error)
      else
         call keep_text('', info%columns, error)
         call keep_text('', info%column_units, error)
      end if
   end subroutine set_texts

   !> Numbers of a variable.
   pure subroutine set_numbers(info, variable)
      type(variable_info_t), intent(inout) :: info
      type(variable_t), intent(in) :: variable

      ! the kinds of C are those of the tables
      info%kind = int(variable%kind, c_int32_t)
      info%default_value = not_a_number()
      if (is_set(variable%default) .and. variable%kind /= kind_dataset) info%default_value = variable%default
      info%lower = -ieee_value(1.0_dp, ieee_positive_inf)
      info%upper = ieee_value(1.0_dp, ieee_positive_inf)
      if (any(variable%kind == [kind_real, kind_integer, kind_dataset])) then
         if (abs(variable%lower) < unset) info%lower = variable%lower
         if (abs(variable%upper) < unset) info%upper = variable%upper
      end if
      info%lower_is_open = merge(1, 0, variable%lower_open)
      info%upper_is_open = merge(1, 0, variable%upper_open)
      info%largest_rank = merge(variable%largest_rank, 0, variable%kind == kind_dataset)
      if (variable%n_columns() > 0) info%largest_rank = 2
      info%is_list = merge(1, 0, variable%is_list)
   end subroutine set_numbers

   !> The default of a variable as it would stand in an input; empty if there is none.
   function text_of_default(variable) result(text)
      type(variable_t), intent(in) :: variable
      character(:), allocatable :: text

      text = ''
      if (.not. is_set(variable%default)) return
      select case (variable%kind)
      case (kind_logical)
         text = trim(merge('.true. ', '.false.', variable%default > 0.5_dp))
      case (kind_choice)
         text = ''''//get_word(variable%choices, nint(variable%default))//''''
      case (kind_real, kind_integer)
         text = show_number(variable%default)
      end select
   end function text_of_default

   !> The unit of a variable as it stands in a file; empty where it has no numbers.
   function unit_of_numbers(kind, unit) result(text)
      !> One of `kind_...`.
      integer, intent(in) :: kind
      !> Unit of the model's table.
      character(*), intent(in) :: unit
      character(:), allocatable :: text

      text = ''
      if (kind /= kind_logical .and. kind /= kind_choice) text = file_unit(unit)
   end function unit_of_numbers

   !> What is said of a result or a profile.
   subroutine set_result(info, name, unit, long_name, flag_meanings, error)
      !> Receives the texts.
      type(result_info_t), intent(out) :: info
      !> Its name, its unit as in a table, what it is, and the meanings of its states; empty if it is a number.
      character(*), intent(in) :: name, unit, long_name, flag_meanings
      !> Receives that there is too little memory.
      type(error_t), allocatable, intent(inout) :: error

      call keep_text(name, info%name, error)
      call keep_text(file_unit(unit), info%unit, error)
      call keep_text(long_name, info%long_name, error)
      call keep_text(flag_meanings, info%flag_meanings, error)
      info%first_flag = 0
   end subroutine set_result

end module adfric_c_tables

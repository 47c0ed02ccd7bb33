! SPDX-License-Identifier: GPL-3.0-or-later
!> The values that a caller gives to the variables of a model, compared with the tables as those of a namelist are, by the same
!> procedures and with the same words.
module adfric_api_values
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_is_nan
   use adfric_base_error, only: error_t, set_error, input_failure
   use adfric_base_kinds, only: dp, i8
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: join_words, newline, show_count, show_number, show_text, to_lower
   use adfric_input_case, only: case_t
   use adfric_input_dataset, only: examine_values
   use adfric_input_given_list, only: keep_numbers
   use adfric_input_group_columns, only: examine_columns
   use adfric_input_variable, only: check_value, describe_allowed, find_outlier, read_variable
   use adfric_input_vocabulary, only: find_variable, full_name, is_number
   use adfric_describe_model, only: model_t
   use adfric_describe_table, only: kind_dataset, variable_t
   use adfric_run_dataset, only: dataset_t
   implicit none (type, external)
   private
   public :: find_index, give_number, give_switch, give_word, give_samples, check_swept, error_of

contains

   !> Find the variable of a name.
   subroutine find_index(model, name, index, problems)
      !> The model, whose table is searched.
      class(model_t), intent(in) :: model
      !> Name of the variable, or its group and name as in `operating%load`; capitals do not count.
      character(*), intent(in) :: name
      !> Index of the variable in the table, from 1; 0 if there is none.
      integer, intent(out) :: index
      !> Receives why there is none.
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: allowed, flaw
      integer :: i

      call find_variable(model, to_lower(trim(adjustl(name))), '', index, flaw)
      if (index > 0) return
      ! only now are the names wanted that are allowed
      allowed = ''
      do i = 1, size(model%variables)
         if (.not. model%variables(i)%is_hidden) allowed = allowed//' '//full_name(model, i)
      end do
      call find_variable(model, to_lower(trim(adjustl(name))), allowed, index, flaw)
      call problems%add('', '', flaw)
   end subroutine find_index

   !> Give a number.
   subroutine give_number(variable, value, stored, problems)
      !> Row of the model's table.
      type(variable_t), intent(in) :: variable
      !> The value in the SI unit of the variable.
      real(dp), intent(in) :: value
      !> Receives the value; left as it is if something is wrong.
      real(dp), intent(inout) :: stored
      !> Receives what is wrong, if anything is.
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: flaw, text

      if (ieee_is_nan(value)) then
         text = 'NaN'
      else if (.not. ieee_is_finite(value)) then
         text = trim(merge('Infinity ', '-Infinity', value > 0))
      else if (is_number(variable)) then
         call check_value(value, variable, flaw)
         call take(variable, value, flaw, stored, problems)
         return
      else
         text = show_number(value)
      end if
      ! no value of this kind: the reader of namelists says why
      call give_literal(variable, text, stored, problems)
   end subroutine give_number

   !> Give a logical value.
   subroutine give_switch(variable, is_on, stored, problems)
      !> Row of the model's table.
      type(variable_t), intent(in) :: variable
      !> The value.
      logical, intent(in) :: is_on
      !> Receives the value as a number; left as it is if something is wrong.
      real(dp), intent(inout) :: stored
      !> Receives what is wrong, if anything is.
      type(problems_t), intent(inout) :: problems

      call give_literal(variable, trim(merge('.true. ', '.false.', is_on)), stored, problems)
   end subroutine give_switch

   !> Give a word.
   subroutine give_word(variable, word, stored, problems)
      !> Row of the model's table.
      type(variable_t), intent(in) :: variable
      !> The word, without quotes; blanks at its end do not count.
      character(*), intent(in) :: word
      !> Receives the index of the word among those that are allowed; left as it is if something is wrong.
      real(dp), intent(inout) :: stored
      !> Receives what is wrong, if anything is.
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: quoted
      integer :: i, n

      allocate (character(2*len(word) + 2) :: quoted)
      quoted(1:1) = ''''
      n = 1
      do i = 1, len_trim(word)
         n = n + 1
         quoted(n:n) = word(i:i)
         if (word(i:i) /= '''') cycle
         n = n + 1
         quoted(n:n) = ''''
      end do
      quoted(n + 1:n + 1) = ''''
      call give_literal(variable, quoted(:n + 1), stored, problems)
   end subroutine give_word

   !> Give a value as it would stand in a namelist.
   subroutine give_literal(variable, text, stored, problems)
      type(variable_t), intent(in) :: variable
      !> Text of the value.
      character(*), intent(in) :: text
      real(dp), intent(inout) :: stored
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: flaw
      real(dp) :: value
      integer :: position

      if (variable%kind == kind_dataset) then
         value = stored
         flaw = trim(merge('is a list   ', 'is a dataset', variable%is_list))//', given '//show_text(text) &
            //', allowed: an array of its values'
      else
         call read_variable(text, variable, value, flaw, position)
      end if
      call take(variable, value, flaw, stored, problems)
   end subroutine give_literal

   !> Take over a value, or report what is wrong with it.
   subroutine take(variable, value, flaw, stored, problems)
      type(variable_t), intent(in) :: variable
      !> The value, which has a meaning if nothing is wrong.
      real(dp), intent(in) :: value
      !> What is wrong; empty if nothing is.
      character(*), intent(in) :: flaw
      real(dp), intent(inout) :: stored
      type(problems_t), intent(inout) :: problems

      if (len(flaw) > 0) then
         call problems%add(variable%group, variable%name, flaw)
      else
         stored = value
      end if
   end subroutine take

   !> Give the values of a dataset, and hand them to the model. One that is refused is not given afterwards.
   subroutine give_samples(model, index, samples, rank, input, problems)
      !> The model, which takes over the values.
      class(model_t), intent(inout) :: model
      !> Index of the variable in the model's table, from 1.
      integer, intent(in) :: index
      !> The values in SI units, those that vary fastest along x first; shape `(nx, ny)`, ny = 1 for one dimension.
      real(dp), intent(in) :: samples(:, :)
      !> Number of dimensions, 1 or 2.
      integer, intent(in) :: rank
      !> Receives what is known of the dataset.
      type(case_t), intent(inout) :: input
      !> Receives what is wrong, if anything is.
      type(problems_t), intent(inout) :: problems
      type(problems_t) :: found
      type(dataset_t) :: none
      character(:), allocatable :: flaw
      real(dp), allocatable :: copy(:, :)

      associate (variable => model%variables(index))
         if (variable%kind /= kind_dataset) then
            call problems%add(variable%group, variable%name, 'has one value, given an array of '//show_count(size(samples))// &
               & ', allowed: '//describe_allowed(variable))
            return
         end if
      end associate
      input%datasets(index) = none
      input%values(index) = model%variables(index)%default
      associate (variable => model%variables(index), dataset => input%datasets(index))
         if (variable%is_list .and. rank == 1) then
            call keep_numbers(samples(:, 1), variable, dataset, flaw)
            allocate (copy, source=samples)
         else if (variable%n_columns() > 0) then
            call take_columns(samples, rank, variable, dataset, copy, flaw)
         else if (rank > variable%largest_rank) then
            flaw = 'has one dimension, given an array of '//show_count(rank)
         else
            dataset%text = 'an array of '//show_count(size(samples))//' values'
            dataset%counts = int(shape(samples), i8)
            dataset%counts = dataset%counts(rank:1:-1)
            dataset%units = ''
            allocate (copy, source=samples)
            call examine_values(dataset, variable, copy, flaw)
            if (len(flaw) > 0) flaw = flaw//', given '//dataset%text//', allowed: '//describe_allowed(variable)
         end if
         if (len(flaw) > 0) call found%add(variable%group, variable%name, flaw)
      end associate
      if (found%count() == 0) call model%take_dataset(index, copy, found)
      call append(found, problems)
      input%is_given(index) = found%count() == 0
      if (input%is_given(index)) input%values(index) = 1
   end subroutine give_samples

   !> Take the columns of a group.
   subroutine take_columns(samples, rank, variable, dataset, copy, flaw)
      !> The columns in SI units; shape `(n, n_columns)`.
      real(dp), intent(in) :: samples(:, :)
      !> Number of dimensions, 2 for columns.
      integer, intent(in) :: rank
      type(variable_t), intent(in) :: variable
      !> Receives what is known of the columns.
      type(dataset_t), intent(inout) :: dataset
      !> Receives the values.
      real(dp), allocatable, intent(out) :: copy(:, :)
      !> What is wrong, what was given, what is allowed; empty if nothing is wrong.
      character(:), allocatable, intent(out) :: flaw

      if (rank /= 2 .or. size(samples, 2) /= variable%n_columns()) then
         flaw = 'has '//show_count(variable%n_columns())//' columns, '//join_words(variable%columns, ', ')// &
            & ', given an array of '//show_count(merge(size(samples, 2), 1, rank == 2))
         return
      end if
      dataset%text = 'an array of '//show_count(size(samples))//' values'
      allocate (copy, source=samples)
      call examine_columns(dataset, variable, copy, flaw)
      if (len(flaw) > 0) flaw = flaw//', given '//dataset%text//', allowed: '//describe_allowed(variable)
   end subroutine take_columns

   !> Hold the values of a sweep against what its variable allows.
   subroutine check_swept(variable, values, problems)
      !> Row of the model's table.
      type(variable_t), intent(in) :: variable
      !> Values of the variable in its SI unit.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong, if anything is.
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: flaw
      integer :: first

      if (.not. is_number(variable)) then
         flaw = 'is not a number, it cannot be swept'
      else if (size(values) == 0) then
         flaw = 'has no value given'
      else
         call find_outlier(values, variable, first, flaw)
      end if
      if (len(flaw) > 0) call problems%add(variable%group, variable%name, flaw)
   end subroutine check_swept

   !> Add all problems of a list to another one.
   subroutine append(found, problems)
      !> The problems to add.
      type(problems_t), intent(in) :: found
      !> Receives them.
      type(problems_t), intent(inout) :: problems
      integer :: i

      do i = 1, found%count()
         call problems%add(found%items(i)%group, found%items(i)%variable, found%items(i)%text)
      end do
   end subroutine append

   !> Problems as an error, a line each.
   subroutine error_of(problems, error, path)
      !> The problems; there may be none.
      type(problems_t), intent(in) :: problems
      !> Not allocated if there are none.
      type(error_t), allocatable, intent(out) :: error
      !> Name of the input, which each line begins with; there is none if absent.
      character(*), intent(in), optional :: path
      character(:), allocatable :: file, text
      integer :: i

      if (problems%count() == 0) return
      file = ''
      if (present(path)) file = path
      text = problems%line_of(1, file)
      do i = 2, problems%count()
         if (problems%is_repeated(i)) cycle
         text = text//newline//problems%line_of(i, file)
      end do
      call set_error(error, input_failure, text)
   end subroutine error_of

end module adfric_api_values

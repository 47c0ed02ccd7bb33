! SPDX-License-Identifier: GPL-3.0-or-later
!> What an input wants to know beside the results: `&output derivatives`, and the `&uncertain` groups.
module adfric_input_variation
   use adfric_base_kinds, only: dp, i8
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: show_number
   use adfric_base_unset, only: is_set
   use adfric_base_words, only: count_words, get_word, has_word
   use adfric_input_case, only: case_t
   use adfric_input_group_values, only: look_up_number, take_choice, take_count, take_number, take_variable, take_words
   use adfric_input_namelist_file, only: namelist_file_t
   use adfric_input_vocabulary, only: output_names, report_unknown_names, uncertain_names
   use adfric_describe_model, only: model_t
   use adfric_describe_table, only: kind_integer
   use adfric_describe_vocabulary, only: list_groups
   use adfric_run_variation, only: uncertainty_t, variation_t
   implicit none (type, external)
   private
   public :: read_variation

   !> Samples of a point: least number for statistics, and most.
   integer, parameter :: least_samples = 2, most_samples = 1000000

contains

   !> Read what is wanted.
   subroutine read_variation(file, model, input, wanted, problems)
      type(namelist_file_t), intent(in) :: file
      !> The model, whose table says which variables it has.
      class(model_t), intent(in) :: model
      type(case_t), intent(in) :: input
      type(variation_t), intent(out) :: wanted
      type(problems_t), intent(inout) :: problems
      type(uncertainty_t) :: uncertain
      integer :: i

      allocate (wanted%derivatives(0), wanted%uncertain(0))
      do i = 1, size(file%groups)
         if (problems%is_enough()) return
         select case (file%groups(i)%name)
         case ('output')
            if (file%groups(i)%index == 1) call read_derivatives(file, i, model, input, wanted, problems)
         case ('uncertain')
            call read_uncertain(file, i, model, input, uncertain, problems)
            if (any(wanted%uncertain%variable == uncertain%variable) .and. uncertain%variable > 0) then
               call file%report_variable(problems, i, 'variable', model%variables(uncertain%variable)%name// &
                  ' is given twice, allowed: one &uncertain for each variable')
            end if
            wanted%uncertain = [wanted%uncertain, uncertain]
            call read_method(file, i, wanted, problems)
         end select
      end do
   end subroutine read_variation

   !> Read the names of the variables by which the results are differentiated.
   subroutine read_derivatives(file, group, model, input, wanted, problems)
      type(namelist_file_t), intent(in) :: file
      !> Number of `&output` in the file, from 1.
      integer, intent(in) :: group
      class(model_t), intent(in) :: model
      type(case_t), intent(in) :: input
      type(variation_t), intent(inout) :: wanted
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: names, flaw
      integer :: k, index

      ! of a model that has the group the rest has been read
      if (.not. has_word(list_groups(model), 'output')) call report_unknown_names(file, group, output_names, problems)
      names = ''
      call take_words(file, group, 'derivatives', 'names of numeric variables of the model', names, problems)
      do k = 1, count_words(names)
         call look_up_number(model, get_word(names, k), index, flaw)
         if (len(flaw) == 0) call check_variable(model, input, index, flaw)
         if (len(flaw) == 0 .and. any(wanted%derivatives == index)) flaw = 'given twice, '''//get_word(names, k)//''''
         if (len(flaw) > 0) then
            call file%report_variable(problems, group, 'derivatives', flaw)
         else
            wanted%derivatives = [wanted%derivatives, index]
         end if
      end do
   end subroutine read_derivatives

   !> Is it a real number that has a value?
   subroutine check_variable(model, input, index, flaw)
      !> The model, whose table says which kind the variable is of.
      class(model_t), intent(in) :: model
      type(case_t), intent(in) :: input
      !> Index of the variable in the model's table, from 1.
      integer, intent(in) :: index
      character(:), allocatable, intent(out) :: flaw

      flaw = ''
      if (model%variables(index)%kind == kind_integer) then
         flaw = 'an integer, given '''//model%variables(index)%name//''', allowed: variables that are real numbers'
      else if (model%variables(index)%has_steps) then
         flaw = 'it has some values alone, given '''//model%variables(index)%name//''', allowed: variables that vary'
      else if (.not. (is_set(input%values(index)) .or. input%is_broken(index))) then
         flaw = 'it has no value in this run, given '''//model%variables(index)%name//''', allowed: variables that have one'
      end if
   end subroutine check_variable

   !> Read the error of a variable.
   subroutine read_uncertain(file, group, model, input, uncertain, problems)
      type(namelist_file_t), intent(in) :: file
      !> Number of the `&uncertain` group in the file, from 1.
      integer, intent(in) :: group
      class(model_t), intent(in) :: model
      type(case_t), intent(in) :: input
      !> Receives the error; its variable is 0 if there is none.
      type(uncertainty_t), intent(out) :: uncertain
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: name, flaw

      call report_unknown_names(file, group, uncertain_names, problems)
      call take_variable(file, group, model, name, uncertain%variable, problems)
      if (uncertain%variable > 0) then
         call check_variable(model, input, uncertain%variable, flaw)
         if (len(flaw) > 0) call file%report_variable(problems, group, 'variable', flaw)
      end if
      call take_size(file, group, 'error', uncertain%error, problems)
      call take_size(file, group, 'relative_error', uncertain%relative_error, problems)
      if (file%groups(group)%is_garbled) return
      if (file%find_assignment(group, 'error') == 0 .and. file%find_assignment(group, 'relative_error') == 0) &
         call file%report_variable(problems, group, 'error', 'not given, needed: error or relative_error')
   end subroutine read_uncertain

   !> A number > 0.
   subroutine take_size(file, group, name, value, problems)
      type(namelist_file_t), intent(in) :: file
      integer, intent(in) :: group
      character(*), intent(in) :: name
      !> Receives the number; left as it is if it is not given.
      real(dp), intent(inout) :: value
      type(problems_t), intent(inout) :: problems
      !> Between these sizes squares can be taken.
      real(dp), parameter :: smallest = 1.0e-60_dp, largest = 1.0e60_dp
      integer :: n_before

      n_before = problems%count()
      call take_number(file, group, name, value, problems)
      if (file%find_assignment(group, name) == 0 .or. problems%count() > n_before) return
      if (value < smallest .or. value > largest) call file%report_variable(problems, group, name, 'out of range, given '// &
         show_number(value)//', allowed: a number >= '//show_number(smallest)//' and <= '//show_number(largest))
   end subroutine take_size

   !> Read how errors are propagated.
   subroutine read_method(file, group, wanted, problems)
      type(namelist_file_t), intent(in) :: file
      integer, intent(in) :: group
      !> Receives number and seed of the samples.
      type(variation_t), intent(inout) :: wanted
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: method
      integer(i8) :: n, seed
      logical :: is_given

      method = 'linear'
      n = 0
      seed = 1
      call take_choice(file, group, 'method', 'linear samples', method, problems)
      call take_count(file, group, 'count', least_samples, most_samples, n, problems)
      call take_count(file, group, 'seed', 1, huge(1), seed, problems)
      is_given = file%find_assignment(group, 'count') > 0
      if (method == 'samples') then
         if (wanted%n_samples > 0) call file%report_variable(problems, group, 'method', &
            'given twice, ''samples'' is of all variables together, allowed: in one &uncertain')
         if (.not. is_given) call file%report_variable(problems, group, 'count', 'not given, needed: the number of samples')
         wanted%n_samples = int(n)
         wanted%seed = int(seed)
      else if (is_given .or. file%find_assignment(group, 'seed') > 0) then
         call file%report_variable(problems, group, trim(merge('count', 'seed ', is_given)), &
            'has no meaning here, allowed: beside method = ''samples''')
      end if
   end subroutine read_method

end module adfric_input_variation

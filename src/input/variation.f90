! SPDX-License-Identifier: GPL-3.0-or-later
!> What an input wants to know beside the results: `&output derivatives`, and the `&uncertain` groups.
module adfric_input_variation
   use adfric_base_kinds, only: dp, i8
   use adfric_base_text, only: show_number
   use adfric_base_unset, only: is_set
   use adfric_base_words, only: count_words, get_word, has_word
   use adfric_input_case, only: case_t
   use adfric_input_group_values, only: look_up_number, take_choice, take_count, take_number, take_variable, take_words
   use adfric_input_reading, only: reading_t
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
   subroutine read_variation(r, wanted)
      type(reading_t), intent(in) :: r
      type(variation_t), intent(out) :: wanted
      type(uncertainty_t) :: uncertain
      integer :: i

      allocate (wanted%derivatives(0), wanted%uncertain(0))
      do i = 1, size(r%file%groups)
         if (r%problems%is_enough()) return
         select case (r%file%groups(i)%name)
         case ('output')
            if (r%file%groups(i)%index == 1) call read_derivatives(r, i, wanted)
         case ('uncertain')
            call read_uncertain(r, i, uncertain)
            if (any(wanted%uncertain%variable == uncertain%variable) .and. uncertain%variable > 0) then
               call r%report(i, 'variable', r%model%variables(uncertain%variable)%name &
                  //' is given twice, allowed: one &uncertain for each variable')
            end if
            wanted%uncertain = [wanted%uncertain, uncertain]
            call read_method(r, i, wanted)
         end select
      end do
   end subroutine read_variation

   !> Read the names of the variables by which the results are differentiated.
   subroutine read_derivatives(r, group, wanted)
      type(reading_t), intent(in) :: r
      !> Number of `&output` in the file, from 1.
      integer, intent(in) :: group
      type(variation_t), intent(inout) :: wanted
      character(:), allocatable :: names, flaw
      integer :: k, index

      ! of a model that has the group the rest has been read
      if (.not. has_word(list_groups(r%model), 'output')) call report_unknown_names(r, group, output_names)
      names = ''
      call take_words(r, group, 'derivatives', 'names of numeric variables of the model', names)
      do k = 1, count_words(names)
         call look_up_number(r%model, get_word(names, k), index, flaw)
         if (len(flaw) == 0) call check_variable(r%model, r%input, index, flaw)
         if (len(flaw) == 0 .and. any(wanted%derivatives == index)) flaw = 'given twice, '''//get_word(names, k)//''''
         if (len(flaw) > 0) then
            call r%report(group, 'derivatives', flaw)
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
   subroutine read_uncertain(r, group, uncertain)
      type(reading_t), intent(in) :: r
      !> Number of the `&uncertain` group in the file, from 1.
      integer, intent(in) :: group
      !> Receives the error; its variable is 0 if there is none.
      type(uncertainty_t), intent(out) :: uncertain
      character(:), allocatable :: name, flaw

      call report_unknown_names(r, group, uncertain_names)
      call take_variable(r, group, name, uncertain%variable)
      if (uncertain%variable > 0) then
         call check_variable(r%model, r%input, uncertain%variable, flaw)
         if (len(flaw) > 0) call r%report(group, 'variable', flaw)
      end if
      call take_size(r, group, 'error', uncertain%error)
      call take_size(r, group, 'relative_error', uncertain%relative_error)
      if (r%file%groups(group)%is_garbled) return
      if (r%file%find_assignment(group, 'error') == 0 .and. r%file%find_assignment(group, 'relative_error') == 0) &
         call r%report(group, 'error', 'not given, needed: error or relative_error')
   end subroutine read_uncertain

   !> A number > 0.
   subroutine take_size(r, group, name, value)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      character(*), intent(in) :: name
      !> Receives the number; left as it is if it is not given.
      real(dp), intent(inout) :: value
      !> Between these sizes squares can be taken.
      real(dp), parameter :: smallest = 1.0e-60_dp, largest = 1.0e60_dp
      integer :: n_before

      n_before = r%problems%count()
      call take_number(r, group, name, value)
      if (r%file%find_assignment(group, name) == 0 .or. r%problems%count() > n_before) return
      if (value < smallest .or. value > largest) call r%report(group, name, 'out of range, given '//show_number(value) &
         //', allowed: a number >= '//show_number(smallest)//' and <= '//show_number(largest))
   end subroutine take_size

   !> Read how errors are propagated.
   subroutine read_method(r, group, wanted)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      !> Receives number and seed of the samples.
      type(variation_t), intent(inout) :: wanted
      character(:), allocatable :: method
      integer(i8) :: n, seed
      logical :: is_given

      method = 'linear'
      n = 0
      seed = 1
      call take_choice(r, group, 'method', 'linear samples', method)
      call take_count(r, group, 'count', least_samples, most_samples, n)
      call take_count(r, group, 'seed', 1, huge(1), seed)
      is_given = r%file%find_assignment(group, 'count') > 0
      if (method == 'samples') then
         if (wanted%n_samples > 0) call r%report(group, 'method', &
            'given twice, ''samples'' is of all variables together, allowed: in one &uncertain')
         if (.not. is_given) call r%report(group, 'count', 'not given, needed: the number of samples')
         wanted%n_samples = int(n)
         wanted%seed = int(seed)
      else if (is_given .or. r%file%find_assignment(group, 'seed') > 0) then
         call r%report(group, trim(merge('count', 'seed ', is_given)), 'has no meaning here, allowed: beside method = ''samples''')
      end if
   end subroutine read_method

end module adfric_input_variation

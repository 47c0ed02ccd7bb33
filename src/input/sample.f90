! SPDX-License-Identifier: GPL-3.0-or-later
!> `&sample` with its `&range` groups: several variables that change together, spread over their ranges.
module adfric_input_sample
   use adfric_base_kinds, only: dp, i8
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: show_count, show_number
   use adfric_input_case, only: case_t
   use adfric_input_group_values, only: take_choice, take_count, take_number, take_variable
   use adfric_input_namelist_file, only: namelist_file_t
   use adfric_input_number_list, only: most_values
   use adfric_input_range_mapping, only: range_of_variable_t, map_range
   use adfric_input_swept_variable, only: break_variable, check_not_twice, put_swept
   use adfric_input_variable, only: find_outlier
   use adfric_input_vocabulary, only: range_names, report_unknown_names, sample_names
   use adfric_describe_model, only: model_t
   use adfric_numerics_unit_samples, only: fill_latin_hypercube, fill_random, fill_sobol, most_sobol_dimensions
   use adfric_run_dataset, only: dataset_t
   use adfric_run_plan, only: axis_t
   use adfric_system_memory, only: has_space
   implicit none (type, external)
   private
   public :: read_sample, sample_axis

   !> Name of the dimension.
   character(*), parameter :: sample_axis = 'sample'
   !> Bytes of a number.
   real(dp), parameter :: real_bytes = 8

   !> What `&sample` says.
   type :: sample_t
      !> Number of points; 0 if it is not given.
      integer(i8) :: n_points = 0
      !> Which sample of all.
      integer(i8) :: seed = 1
      !> 'sobol', 'latin_hypercube' or 'random'.
      character(:), allocatable :: method
   end type sample_t

contains

   !> Read a sample.
   subroutine read_sample(file, group, model, input, axis, problems)
      type(namelist_file_t), intent(in) :: file
      !> Number of `&sample` in the file, from 1.
      integer, intent(in) :: group
      class(model_t), intent(in) :: model
      !> In: what the groups and earlier sweeps give. Out: also what the sample does.
      type(case_t), intent(inout) :: input
      !> The variables and their values; not allocated if the axis cannot be used.
      type(axis_t), intent(out) :: axis
      type(problems_t), intent(inout) :: problems
      type(sample_t) :: sample
      type(range_of_variable_t), allocatable :: ranges(:)
      type(dataset_t) :: nothing
      integer :: i, n_before

      n_before = problems%count()
      call read_head(file, group, sample, problems)
      call read_ranges(file, model, input, ranges, problems)
      if (size(ranges) == 0 .and. all(file%groups%name /= 'range')) &
         call file%report_variable(problems, group, '', 'no variables, needed: a &range group for each')
      if (size(ranges) > most_sobol_dimensions .and. sample%method == 'sobol') call file%report_variable(problems, group, &
         'method', 'the Sobol sequence has at most '//show_count(most_sobol_dimensions)//' variables, given '// &
         show_count(size(ranges))//', allowed: ''latin_hypercube'', ''random'', or fewer &range groups')
      if (problems%count() == n_before) then
         if (.not. has_space(2*real_bytes*sample%n_points*size(ranges))) call file%report_variable(problems, group, 'count', &
            'too many values for the memory, given '//show_count(sample%n_points)//', allowed: fewer')
      end if
      if (problems%count() > n_before .or. size(ranges) == 0) then
         do i = 1, size(ranges)
            call break_variable(ranges(i)%variable, file%line_of(file%groups(ranges(i)%group)%first), input)
         end do
         return
      end if
      call fill_axis(sample, ranges, model, axis)
      do i = 1, size(ranges)
         call put_swept(ranges(i)%variable, axis%values(i, 1), file%line_of(file%groups(ranges(i)%group)%first), nothing, input)
      end do
   end subroutine read_sample

   !> Read `&sample` itself.
   subroutine read_head(file, group, sample, problems)
      type(namelist_file_t), intent(in) :: file
      integer, intent(in) :: group
      type(sample_t), intent(out) :: sample
      type(problems_t), intent(inout) :: problems

      sample%method = 'sobol'
      call report_unknown_names(file, group, sample_names, problems)
      call take_count(file, group, 'count', 1, most_values, sample%n_points, problems)
      call take_choice(file, group, 'method', 'sobol latin_hypercube random', sample%method, problems)
      call take_count(file, group, 'seed', 1, huge(1), sample%seed, problems)
      if (file%groups(group)%is_garbled) return
      if (file%find_assignment(group, 'count') == 0) call file%report_variable(problems, group, 'count', &
         'not given, needed: the number of points')
      if (file%find_assignment(group, 'seed') > 0 .and. sample%method == 'sobol') call file%report_variable(problems, group, &
         'seed', 'has no meaning for a Sobol sequence, of which there is one, allowed: beside method = ''latin_hypercube'' or '// &
         '''random''')
   end subroutine read_head

   !> Read all `&range` groups. One that cannot be used is left out; there is a problem then.
   subroutine read_ranges(file, model, input, ranges, problems)
      type(namelist_file_t), intent(in) :: file
      class(model_t), intent(in) :: model
      !> In: what the groups and earlier sweeps give. Out: variables that are broken.
      type(case_t), intent(inout) :: input
      !> Receives the ranges, in the order of the file.
      type(range_of_variable_t), allocatable, intent(out) :: ranges(:)
      type(problems_t), intent(inout) :: problems
      type(range_of_variable_t) :: range
      integer :: i, n, n_before

      allocate (ranges(count(file%groups%name == 'range')))
      n = 0
      do i = 1, size(file%groups)
         if (file%groups(i)%name /= 'range' .or. problems%is_enough()) cycle
         n_before = problems%count()
         call read_range(file, i, model, input, range, problems)
         if (range%variable > 0) then
            if (any(ranges(:n)%variable == range%variable)) call file%report_variable(problems, i, 'variable', &
               model%variables(range%variable)%name//' has a &range already, allowed: one')
            if (problems%count() > n_before) &
               call break_variable(range%variable, file%line_of(file%groups(i)%first), input)
         else
            ! which one is meant is not known
            input%is_broken = .true.
         end if
         ! what is wrong with the name may have been said before
         if (problems%count() > n_before .or. range%variable == 0) cycle
         n = n + 1
         ranges(n) = range
      end do
      ranges = ranges(:n)
   end subroutine read_ranges

   !> Read one range.
   subroutine read_range(file, group, model, input, range, problems)
      type(namelist_file_t), intent(in) :: file
      !> Number of the `&range` group in the file, from 1.
      integer, intent(in) :: group
      class(model_t), intent(in) :: model
      type(case_t), intent(in) :: input
      !> Receives the range; its variable is 0 if there is none.
      type(range_of_variable_t), intent(out) :: range
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: name, spacing, ends, flaw
      integer :: n_before, first

      range%group = group
      spacing = 'linear'
      call report_unknown_names(file, group, range_names, problems)
      call take_variable(file, group, model, name, range%variable, problems)
      if (range%variable > 0) call check_not_twice(file, group, model, range%variable, input, problems)
      n_before = problems%count()
      call take_number(file, group, 'from', range%from, problems)
      call take_number(file, group, 'to', range%to, problems)
      call take_choice(file, group, 'spacing', 'linear log', spacing, problems)
      range%is_logarithmic = spacing == 'log'
      if (file%groups(group)%is_garbled) return
      call check_given(file, group, 'from', problems)
      call check_given(file, group, 'to', problems)
      if (problems%count() > n_before) return
      ends = 'given from = '//show_number(range%from)//' and to = '//show_number(range%to)
      if (.not. abs(range%from - range%to) > 0) &
         call file%report_variable(problems, group, 'to', 'the range is empty, '//ends//', allowed: different ends')
      if (range%is_logarithmic .and. .not. (min(range%from, range%to) > 0 .or. max(range%from, range%to) < 0)) &
         call file%report_variable(problems, group, 'spacing', 'a logarithmic range cannot reach or pass zero, '//ends// &
         ', allowed: ends of one sign')
      if (range%variable == 0) return
      call find_outlier([range%from, range%to], model%variables(range%variable), first, flaw)
      if (first > 0) call file%report_variable(problems, group, trim(merge('from', 'to  ', first == 1)), &
         model%variables(range%variable)%name//' '//flaw)
   end subroutine read_range

   !> Both ends of a range are needed.
   subroutine check_given(file, group, name, problems)
      type(namelist_file_t), intent(in) :: file
      integer, intent(in) :: group
      !> 'from' or 'to'.
      character(*), intent(in) :: name
      type(problems_t), intent(inout) :: problems

      if (file%find_assignment(group, name) == 0) &
         call file%report_variable(problems, group, name, 'not given, needed: from and to')
   end subroutine check_given

   !> Spread the points over the ranges.
   subroutine fill_axis(sample, ranges, model, axis)
      type(sample_t), intent(in) :: sample
      type(range_of_variable_t), intent(in) :: ranges(:)
      !> The model, whose table says which variables are integers.
      class(model_t), intent(in) :: model
      type(axis_t), intent(inout) :: axis
      integer :: i

      axis%name = sample_axis
      axis%variables = ranges%variable
      allocate (axis%values(size(ranges), sample%n_points))
      select case (sample%method)
      case ('sobol')
         call fill_sobol(axis%values)
      case ('latin_hypercube')
         call fill_latin_hypercube(int(sample%seed), axis%values)
      case default
         call fill_random(int(sample%seed), axis%values)
      end select
      do i = 1, size(ranges)
         axis%values(i, :) = map_range(axis%values(i, :), ranges(i), model%variables(ranges(i)%variable))
      end do
   end subroutine fill_axis

end module adfric_input_sample

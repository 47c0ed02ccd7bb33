! SPDX-License-Identifier: GPL-3.0-or-later
!> `&sample` with its `&range` groups: several variables that change together, spread over their ranges.
module adfric_input_sample
   use adfric_base_kinds, only: dp, i8
   use adfric_base_text, only: show_count, show_number
   use adfric_input_group_values, only: take_choice, take_count, take_number, take_variable
   use adfric_input_number_list, only: most_values
   use adfric_input_range_mapping, only: range_of_variable_t, map_range
   use adfric_input_reading, only: reading_t
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
   subroutine read_sample(r, group, axis)
      type(reading_t), intent(in) :: r
      !> Number of `&sample` in the file, from 1.
      integer, intent(in) :: group
      !> The variables and their values; not allocated if the axis cannot be used.
      type(axis_t), intent(out) :: axis
      type(sample_t) :: sample
      type(range_of_variable_t), allocatable :: ranges(:)
      type(dataset_t) :: nothing
      integer :: i, n_before

      n_before = r%problems%count()
      call read_head(r, group, sample)
      call read_ranges(r, ranges)
      if (size(ranges) == 0 .and. all(r%file%groups%name /= 'range')) call r%report(group, '', &
         'no variables, needed: a &range group for each')
      if (size(ranges) > most_sobol_dimensions .and. sample%method == 'sobol') call r%report(group, 'method', &
         'the Sobol sequence has at most '//show_count(most_sobol_dimensions)//' variables, given '//show_count(size(ranges)) &
         //', allowed: ''latin_hypercube'', ''random'', or fewer &range groups')
      if (r%problems%count() == n_before) then
         if (.not. has_space(2*real_bytes*sample%n_points*size(ranges))) call r%report(group, 'count', &
            'too many values for the memory, given '//show_count(sample%n_points)//', allowed: fewer')
      end if
      if (r%problems%count() > n_before .or. size(ranges) == 0) then
         do i = 1, size(ranges)
            call break_variable(ranges(i)%variable, r%file%line_of(r%file%groups(ranges(i)%group)%first), r%input)
         end do
         return
      end if
      call fill_axis(sample, ranges, r%model, axis)
      do i = 1, size(ranges)
         call put_swept(ranges(i)%variable, axis%values(i, 1), r%file%line_of(r%file%groups(ranges(i)%group)%first), nothing, &
            r%input)
      end do
   end subroutine read_sample

   !> Read `&sample` itself.
   subroutine read_head(r, group, sample)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      type(sample_t), intent(out) :: sample

      sample%method = 'sobol'
      call report_unknown_names(r, group, sample_names)
      call take_count(r, group, 'count', 1, most_values, sample%n_points)
      call take_choice(r, group, 'method', 'sobol latin_hypercube random', sample%method)
      call take_count(r, group, 'seed', 1, huge(1), sample%seed)
      if (r%file%groups(group)%is_garbled) return
      if (r%file%find_assignment(group, 'count') == 0) call r%report(group, 'count', 'not given, needed: the number of points')
      if (r%file%find_assignment(group, 'seed') > 0 .and. sample%method == 'sobol') call r%report(group, 'seed', &
         'has no meaning for a Sobol sequence, of which there is one, allowed: beside method = ''latin_hypercube'' or ' &
         //'''random''')
   end subroutine read_head

   !> Read all `&range` groups. One that cannot be used is left out; there is a problem then.
   subroutine read_ranges(r, ranges)
      type(reading_t), intent(in) :: r
      !> Receives the ranges, in the order of the file.
      type(range_of_variable_t), allocatable, intent(out) :: ranges(:)
      type(range_of_variable_t) :: range
      integer :: i, n, n_before

      allocate (ranges(count(r%file%groups%name == 'range')))
      n = 0
      do i = 1, size(r%file%groups)
         if (r%file%groups(i)%name /= 'range' .or. r%problems%is_enough()) cycle
         n_before = r%problems%count()
         call read_range(r, i, range)
         if (range%variable > 0) then
            if (any(ranges(:n)%variable == range%variable)) call r%report(i, 'variable', r%model%variables(range%variable)%name &
               //' has a &range already, allowed: one')
            if (r%problems%count() > n_before) call break_variable(range%variable, r%file%line_of(r%file%groups(i)%first), r%input)
         else
            ! which one is meant is not known
            r%input%is_broken = .true.
         end if
         ! what is wrong with the name may have been said before
         if (r%problems%count() > n_before .or. range%variable == 0) cycle
         n = n + 1
         ranges(n) = range
      end do
      ranges = ranges(:n)
   end subroutine read_ranges

   !> Read one range.
   subroutine read_range(r, group, range)
      type(reading_t), intent(in) :: r
      !> Number of the `&range` group in the file, from 1.
      integer, intent(in) :: group
      !> Receives the range; its variable is 0 if there is none.
      type(range_of_variable_t), intent(out) :: range
      character(:), allocatable :: name, spacing, ends, flaw
      integer :: n_before, first

      range%group = group
      spacing = 'linear'
      call report_unknown_names(r, group, range_names)
      call take_variable(r, group, name, range%variable)
      if (range%variable > 0) call check_not_twice(r, group, range%variable)
      n_before = r%problems%count()
      call take_number(r, group, 'from', range%from)
      call take_number(r, group, 'to', range%to)
      call take_choice(r, group, 'spacing', 'linear log', spacing)
      range%is_logarithmic = spacing == 'log'
      if (r%file%groups(group)%is_garbled) return
      call check_given(r, group, 'from')
      call check_given(r, group, 'to')
      if (r%problems%count() > n_before) return
      ends = 'given from = '//show_number(range%from)//' and to = '//show_number(range%to)
      if (.not. abs(range%from - range%to) > 0) call r%report(group, 'to', 'the range is empty, '//ends &
         //', allowed: different ends')
      if (range%is_logarithmic .and. .not. (min(range%from, range%to) > 0 .or. max(range%from, range%to) < 0)) &
         call r%report(group, 'spacing', 'a logarithmic range cannot reach or pass zero, '//ends//', allowed: ends of one sign')
      if (range%variable == 0) return
      call find_outlier([range%from, range%to], r%model%variables(range%variable), first, flaw)
      if (first > 0) call r%report(group, trim(merge('from', 'to  ', first == 1)), r%model%variables(range%variable)%name//' ' &
         //flaw)
   end subroutine read_range

   !> Both ends of a range are needed.
   subroutine check_given(r, group, name)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      !> 'from' or 'to'.
      character(*), intent(in) :: name

      if (r%file%find_assignment(group, name) == 0) call r%report(group, name, 'not given, needed: from and to')
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

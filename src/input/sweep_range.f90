! SPDX-License-Identifier: GPL-3.0-or-later
!> The values of one `&sweep` group: a list, or a range from one end to the other.
module adfric_input_sweep_range
   use adfric_base_kinds, only: dp, i8
   use adfric_base_problems, only: problems_t
   use adfric_base_words, only: get_word
   use adfric_base_text, only: show_number, show_count, show_text
   use adfric_input_item, only: take_only_word
   use adfric_input_literal, only: convert
   use adfric_input_namelist_file, only: namelist_file_t
   use adfric_input_number_list, only: read_list, most_values
   use adfric_input_suggestion, only: did_you_mean
   use adfric_input_sweep_values, only: fill_linear, fill_logarithmic
   use adfric_system_memory, only: has_room
   implicit none (type, external)
   private
   public :: read_sweep_values

   !> Variables of `&sweep` that describe a range.
   character(*), parameter :: range_names = 'from to count spacing'

   !> A range of values.
   type :: range_t
      !> First and last value.
      real(dp) :: from = 0, to = 0
      !> Number of values, both ends included.
      integer(i8) :: count = 0
      !> Are the values at equal ratios, instead of at equal distances?
      logical :: is_logarithmic = .false.
   end type range_t

   !> Bytes of a number.
   real(dp), parameter :: real_bytes = 8

contains

   !> Read the values of a sweep; size 0 if something is wrong.
   subroutine read_sweep_values(file, group, values, problems)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Number of the `&sweep` group in the file, from 1.
      integer, intent(in) :: group
      !> The values in the order of the sweep; size 0 if something is wrong.
      real(dp), allocatable, intent(out) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      type(range_t) :: interval
      integer :: n_before, status

      n_before = problems%count()
      if (file%find_assignment(group, 'values') > 0) then
         call check_alone(file, group, problems)
         call read_sweep_list(file, group, values, problems)
      else
         call check_complete(file, group, problems)
         call read_range(file, group, interval, problems)
         if (problems%count() == n_before) call check_range(file, group, interval, problems)
         if (problems%count() == n_before) then
            status = 1
            if (has_room(real_bytes*interval%count)) allocate (values(interval%count), stat=status)
            if (status /= 0) call file%report_variable(problems, group, 'count', &
               'too many values for the memory, given '//show_count(interval%count)//', allowed: fewer')
         end if
         if (problems%count() == n_before) call fill_range(interval, values)
      end if
      if (problems%count() == n_before) return
      if (allocated(values)) deallocate (values)
      allocate (values(0))
   end subroutine read_sweep_values

   !> A list stands alone.
   subroutine check_alone(file, group, problems)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Number of the `&sweep` group in the file, from 1.
      integer, intent(in) :: group
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: k

      do k = 1, 4
         if (file%find_assignment(group, get_word(range_names, k)) == 0) cycle
         call file%report_variable(problems, group, get_word(range_names, k), 'contradicts values, given both, '// &
            'allowed: values, or from, to and count')
      end do
   end subroutine check_alone

   !> Read a list.
   subroutine read_sweep_list(file, group, values, problems)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Number of the `&sweep` group in the file, from 1.
      integer, intent(in) :: group
      !> The values in the order of the list; size 0 if something is wrong.
      real(dp), allocatable, intent(out) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: flaw
      integer :: place

      call read_list(file%value_of(file%find_assignment(group, 'values')), values, flaw, place)
      if (len(flaw) > 0) call file%report_variable(problems, group, 'values', flaw//', allowed: numbers, at most '// &
         show_count(most_values), place)
   end subroutine read_sweep_list

   !> A range has both ends and a count. Of a group that makes no sense nothing is missed.
   subroutine check_complete(file, group, problems)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Number of the `&sweep` group in the file, from 1.
      integer, intent(in) :: group
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      logical :: is_there(3)
      integer :: k

      if (file%groups(group)%is_garbled) return
      is_there = [(file%find_assignment(group, get_word(range_names, k)) > 0, k=1, 3)]
      if (.not. any(is_there)) then
         call file%report_variable(problems, group, '', 'no values given, allowed: values, or from, to and count')
         return
      end if
      do k = 1, 3
         if (is_there(k)) cycle
         call file%report_variable(problems, group, get_word(range_names, k), 'not given, needed: from, to and count')
      end do
   end subroutine check_complete

   !> Read a range.
   subroutine read_range(file, group, interval, problems)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Number of the `&sweep` group in the file, from 1.
      integer, intent(in) :: group
      !> Receives the ends, the count and the spacing; only to be used if nothing was wrong.
      type(range_t), intent(out) :: interval
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      call read_end(file, group, 'from', interval%from, problems)
      call read_end(file, group, 'to', interval%to, problems)
      call read_count(file, group, interval%count, problems)
      call read_spacing(file, group, interval%is_logarithmic, problems)
   end subroutine read_range

   !> Read an end of the range.
   subroutine read_end(file, group, name, value, problems)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Number of the `&sweep` group in the file, from 1.
      integer, intent(in) :: group
      !> 'from' or 'to'.
      character(*), intent(in) :: name
      !> The end of the range; 0 if it is missing or wrong.
      real(dp), intent(out) :: value
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: word, flaw
      integer :: number, place

      value = 0
      number = file%find_assignment(group, name)
      if (number == 0) return
      call take_only_word(file%value_of(number), word, flaw, place)
      if (len(flaw) == 0) call convert(word, value, flaw)
      if (len(flaw) > 0) call file%report_variable(problems, group, name, flaw//', allowed: a number', place)
   end subroutine read_end

   !> Read the number of values.
   subroutine read_count(file, group, n_values, problems)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Number of the `&sweep` group in the file, from 1.
      integer, intent(in) :: group
      !> The number of values; 0 if it is missing or no integer.
      integer(i8), intent(out) :: n_values
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      character(*), parameter :: allowed = ', allowed: an integer >= 1 and <= '
      character(:), allocatable :: word, flaw
      integer :: number, place

      n_values = 0
      number = file%find_assignment(group, 'count')
      if (number == 0) return
      call take_only_word(file%value_of(number), word, flaw, place)
      if (len(flaw) == 0) call convert(word, n_values, flaw)
      if (len(flaw) == 0 .and. n_values < 1) flaw = 'out of range, given '//show_count(n_values)
      if (len(flaw) == 0 .and. n_values > most_values) flaw = 'too many values, given '//show_count(n_values)
      if (len(flaw) > 0) &
         call file%report_variable(problems, group, 'count', flaw//allowed//show_count(most_values), place)
   end subroutine read_count

   !> Read the spacing.
   subroutine read_spacing(file, group, is_logarithmic, problems)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Number of the `&sweep` group in the file, from 1.
      integer, intent(in) :: group
      !> Are the values at equal ratios? False: at equal distances, as where no spacing is given.
      logical, intent(out) :: is_logarithmic
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      character(*), parameter :: allowed = ', allowed: ''linear'', ''log'''
      character(:), allocatable :: quoted, word, flaw
      integer :: number, place

      is_logarithmic = .false.
      number = file%find_assignment(group, 'spacing')
      if (number == 0) return
      word = ''
      call take_only_word(file%value_of(number), quoted, flaw, place)
      if (len(flaw) == 0) call convert(quoted, word, flaw)
      is_logarithmic = word == 'log'
      if (len(flaw) == 0 .and. word /= 'log' .and. word /= 'linear') flaw = 'unknown choice, given '''//show_text(word)//''''
      if (len(flaw) > 0) call file%report_variable(problems, group, 'spacing', &
         flaw//allowed//did_you_mean(word, 'linear log'), place)
   end subroutine read_spacing

   !> Do the ends, the count and the spacing agree?
   subroutine check_range(file, group, interval, problems)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Number of the `&sweep` group in the file, from 1.
      integer, intent(in) :: group
      !> The range, each part of which is good by itself.
      type(range_t), intent(in) :: interval
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: ends
      logical :: is_one_value

      ends = 'from = '//show_number(interval%from)//' and to = '//show_number(interval%to)
      is_one_value = .not. (interval%from < interval%to .or. interval%from > interval%to)
      if (interval%count == 1 .and. .not. is_one_value) call file%report_variable(problems, group, 'count', &
         'contradicts the ends, given 1 with '//ends//', allowed: 2 or more between different ends')
      if (interval%count > 1 .and. is_one_value) call file%report_variable(problems, group, 'count', &
         'contradicts the ends, given '//show_count(interval%count)//' with '//ends//', allowed: 1 between equal ends')
      if (.not. interval%is_logarithmic) return
      if (min(interval%from, interval%to) > 0 .or. max(interval%from, interval%to) < 0) return
      call file%report_variable(problems, group, 'spacing', 'a logarithmic sweep cannot reach or pass zero, given '// &
         ends//', allowed: ends of one sign')
   end subroutine check_range

   !> Set the values of a range.
   pure subroutine fill_range(interval, values)
      !> The range, whose ends, count and spacing agree.
      type(range_t), intent(in) :: interval
      !> Receives the values; as many as the range has.
      real(dp), intent(out) :: values(:)

      if (interval%is_logarithmic) then
         call fill_logarithmic(interval%from, interval%to, values)
      else
         call fill_linear(interval%from, interval%to, values)
      end if
   end subroutine fill_range

end module adfric_input_sweep_range

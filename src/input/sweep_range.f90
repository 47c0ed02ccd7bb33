! SPDX-License-Identifier: GPL-3.0-or-later
!> The values of one `&sweep` group: a list, or a range from one end to the other.
module adfric_input_sweep_range
   use adfric_base_kinds, only: dp, i8
   use adfric_base_words, only: get_word
   use adfric_base_text, only: show_number, show_count, show_text
   use adfric_input_dataset, only: load_numbers, read_dataset_name
   use adfric_input_given_list, only: is_dataset_name
   use adfric_input_group_values, only: take_choice, take_count, take_number
   use adfric_input_number_list, only: read_list, most_values
   use adfric_input_reading, only: reading_t
   use adfric_input_sweep_values, only: fill_linear, fill_logarithmic
   use adfric_run_dataset, only: dataset_t
   use adfric_system_memory, only: has_space
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

   !> What may be given for a list that stands in a file.
   character(*), parameter :: allowed_files = '''FILE.h5:/DATASET'' of numbers, 1 dimension, or ''FILE.csv:COLUMN'''
   !> Bytes of a number.
   real(dp), parameter :: real_bytes = 8

contains

   !> Read the values of a sweep; size 0 if something is wrong.
   subroutine read_sweep_values(r, group, values, dataset)
      type(reading_t), intent(in) :: r
      !> Number of the `&sweep` group in the file, from 1.
      integer, intent(in) :: group
      !> The values in the order of the sweep, those of a file in its units; size 0 if something is wrong.
      real(dp), allocatable, intent(out) :: values(:)
      !> The dataset or column of a file that has the values; not given if they stand in the input.
      type(dataset_t), intent(out) :: dataset
      type(range_t) :: interval
      integer :: n_before, status

      n_before = r%problems%count()
      if (r%file%find_assignment(group, 'values') > 0) then
         call check_alone(r, group)
         call read_sweep_list(r, group, values, dataset)
      else
         call check_complete(r, group)
         call read_range(r, group, interval)
         if (r%problems%count() == n_before) call check_range(r, group, interval)
         if (r%problems%count() == n_before) then
            status = 1
            if (has_space(real_bytes*interval%count)) allocate (values(interval%count), stat=status)
            if (status /= 0) call r%report(group, 'count', 'too many values for the memory, given '//show_count(interval%count) &
               //', allowed: fewer')
         end if
         if (r%problems%count() == n_before) call fill_range(interval, values)
      end if
      if (r%problems%count() == n_before) return
      if (allocated(values)) deallocate (values)
      allocate (values(0))
   end subroutine read_sweep_values

   !> A list stands alone.
   subroutine check_alone(r, group)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      integer :: k

      do k = 1, 4
         if (r%file%find_assignment(group, get_word(range_names, k)) == 0) cycle
         call r%report(group, get_word(range_names, k), 'contradicts values, given both, ' &
            //'allowed: values, or from, to and count')
      end do
   end subroutine check_alone

   !> Read a list.
   subroutine read_sweep_list(r, group, values, dataset)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      !> The values in the order of the list, those of a file in its units; size 0 if something is wrong.
      real(dp), allocatable, intent(out) :: values(:)
      !> Receives the names of file and dataset, if the values stand in one.
      type(dataset_t), intent(inout) :: dataset
      character(:), allocatable :: text, flaw
      real(dp), allocatable :: numbers(:, :)
      integer :: index

      text = r%file%value_of(r%file%find_assignment(group, 'values'))
      if (is_dataset_name(text)) then
         call read_dataset_name(text, .false., dataset, flaw, index)
         if (len(flaw) > 0) flaw = flaw//', allowed: '//allowed_files
         if (len(flaw) == 0) then
            call load_numbers(dataset, 1, numbers, flaw)
            if (len(flaw) > 0 .and. .not. dataset%is_column) flaw = flaw//', given '''//show_text(dataset%text)//''', allowed: '// &
               allowed_files
         end if
         if (len(flaw) > 0) then
            call r%report(group, 'values', flaw, index)
         else
            values = numbers(:, 1)
         end if
         return
      end if
      call read_list(text, values, flaw, index)
      if (len(flaw) > 0) call r%report(group, 'values', flaw//', allowed: numbers, at most '//show_count(most_values), index)
   end subroutine read_sweep_list

   !> A range has both ends and a count. Of a group that makes no sense nothing is missed.
   subroutine check_complete(r, group)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      logical :: is_there(3)
      integer :: k

      if (r%file%groups(group)%is_garbled) return
      is_there = [(r%file%find_assignment(group, get_word(range_names, k)) > 0, k=1, 3)]
      if (.not. any(is_there)) then
         call r%report(group, '', 'no values given, allowed: values, or from, to and count')
         return
      end if
      do k = 1, 3
         if (is_there(k)) cycle
         call r%report(group, get_word(range_names, k), 'not given, needed: from, to and count')
      end do
   end subroutine check_complete

   !> Read a range.
   subroutine read_range(r, group, interval)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      !> Receives the ends, the count and the spacing; only to be used if nothing was wrong.
      type(range_t), intent(out) :: interval

      character(:), allocatable :: spacing

      spacing = 'linear'
      call take_number(r, group, 'from', interval%from)
      call take_number(r, group, 'to', interval%to)
      call take_count(r, group, 'count', 1, most_values, interval%count)
      call take_choice(r, group, 'spacing', 'linear log', spacing)
      interval%is_logarithmic = spacing == 'log'
   end subroutine read_range

   !> Do the ends, the count and the spacing agree?
   subroutine check_range(r, group, interval)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      !> The range, each part of which is good by itself.
      type(range_t), intent(in) :: interval
      character(:), allocatable :: ends
      logical :: is_one_value

      ends = 'from = '//show_number(interval%from)//' and to = '//show_number(interval%to)
      is_one_value = .not. (interval%from < interval%to .or. interval%from > interval%to)
      if (interval%count == 1 .and. .not. is_one_value) call r%report(group, 'count', 'contradicts the ends, given 1 with '//ends &
         //', allowed: 2 or more between different ends')
      if (interval%count > 1 .and. is_one_value) call r%report(group, 'count', 'contradicts the ends, given ' &
         //show_count(interval%count)//' with '//ends//', allowed: 1 between equal ends')
      if (.not. interval%is_logarithmic) return
      if (min(interval%from, interval%to) > 0 .or. max(interval%from, interval%to) < 0) return
      call r%report(group, 'spacing', 'a logarithmic sweep cannot reach or pass zero, given '//ends//', allowed: ends of one sign')
   end subroutine check_range

   !> Set the values of a range.
   pure subroutine fill_range(interval, values)
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

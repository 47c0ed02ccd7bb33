! SPDX-License-Identifier: GPL-3.0-or-later
!> Lists of numbers.
module adfric_input_number_list
   use adfric_base_kinds, only: dp, i8
   use adfric_base_text, only: show_count
   use adfric_input_item, only: item_t, next_item
   use adfric_input_literal, only: convert
   use adfric_system_memory, only: has_space
   implicit none (type, external)
   private
   public :: read_list, most_values

   !> Values that a list may have.
   integer, parameter :: most_values = 100000000
   !> Values that there is space for at first.
   integer, parameter :: first_space = 16

   !> Bytes of a number.
   real(dp), parameter :: real_bytes = 8

contains

   !> Read a list of real numbers.
   subroutine read_list(text, values, flaw, index, most)
      !> Text of the value of an assignment: numbers, each with a repeat count or without.
      character(*), intent(in) :: text
      !> The numbers, with repeated ones written out; size 0 if something is wrong.
      real(dp), allocatable, intent(out) :: values(:)
      character(:), allocatable, intent(out) :: flaw
      !> Position in the text of what is wrong, from 1.
      integer, intent(out) :: index
      !> Values that the list may have; not present: `most_values`.
      integer, intent(in), optional :: most
      real(dp), allocatable :: kept(:)
      integer(i8) :: n, n_kept
      integer :: limit
      logical :: is_space

      limit = most_values
      if (present(most)) limit = min(most, most_values)
      call scan_list(text, limit, kept, n_kept, n, is_space, flaw, index)
      if (len(flaw) == 0) then
         if (n == 0) flaw = 'no value given'
         if (.not. is_space) flaw = 'too many values for the memory, given '//show_count(n)
         if (n > limit) flaw = 'too many values, given '//show_count(n)
      end if
      if (len(flaw) > 0) n_kept = 0
      if (n_kept == size(kept, kind=i8)) then
         call move_alloc(kept, values)
      else
         values = kept(:n_kept)
      end if
   end subroutine read_list

   !> Examine, keep and count the values of a list.
   subroutine scan_list(text, limit, values, n_kept, n, is_space, flaw, index)
      character(*), intent(in) :: text
      !> Values that the list may have, at most `most_values`.
      integer, intent(in) :: limit
      !> The numbers that are kept, and space for more behind them.
      real(dp), allocatable, intent(out) :: values(:)
      !> Number of values that are kept: no more than a list may have.
      integer(i8), intent(out) :: n_kept
      !> Number of values that the list has, whether they are kept or not.
      integer(i8), intent(out) :: n
      !> Is there memory for all that a list may have?
      logical, intent(out) :: is_space
      !> What is wrong with a value; empty if all are good.
      character(:), allocatable, intent(out) :: flaw
      integer, intent(out) :: index
      type(item_t) :: item
      real(dp) :: value
      integer :: position

      allocate (values(first_space))
      n = 0
      n_kept = 0
      is_space = .true.
      index = 1
      position = 1
      do
         call next_item(text, position, item, flaw)
         if (item%first == 0) exit
         index = item%first
         if (len(flaw) == 0) call convert(text(item%first:item%last), value, flaw)
         if (len(flaw) > 0) return
         n = n + item%repeat
         if (n > limit .or. .not. is_space) cycle
         call make_space(values, n_kept, n, is_space)
         if (.not. is_space) cycle
         values(n_kept + 1:n) = value
         n_kept = n
      end do
   end subroutine scan_list

   !> Make space for more values: twice as many, so that each of them is moved about once.
   subroutine make_space(values, n_kept, n, is_space)
      !> In: values that are kept, and space. Out: the same values with space for `n`; unchanged if that fails.
      real(dp), allocatable, intent(inout) :: values(:)
      integer(i8), intent(in) :: n_kept
      !> Number of values that there shall be space for.
      integer(i8), intent(in) :: n
      !> False if the memory has no space for so many.
      logical, intent(out) :: is_space
      real(dp), allocatable :: larger(:)
      integer(i8) :: n_larger
      integer :: status

      is_space = n <= size(values, kind=i8)
      if (is_space) return
      n_larger = max(n, min(2*size(values, kind=i8), int(most_values, i8)))
      status = 1
      if (has_space(real_bytes*n_larger)) allocate (larger(n_larger), stat=status)
      is_space = status == 0
      if (.not. is_space) return
      larger(:n_kept) = values(:n_kept)
      call move_alloc(larger, values)
   end subroutine make_space

end module adfric_input_number_list

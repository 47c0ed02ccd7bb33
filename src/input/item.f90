! SPDX-License-Identifier: GPL-3.0-or-later
!> The values of an assignment one by one, as they are written.
!>
!> A flaw is a text that says what is wrong and what was given; empty, nothing is wrong.
module adfric_input_item
   use adfric_base_kinds, only: i8
   use adfric_base_text, only: newline, is_name, show_text
   use adfric_input_source_text, only: end_of_quote
   implicit none (type, external)
   private
   public :: item_t, next_item, take_only_word

   !> Digits that a repeat count may have.
   integer, parameter :: most_repeat_digits = 9

   !> One value, with the number of times it is meant.
   type :: item_t
      !> Ends of the value in the text, without its repeat count; 0 if there is no value.
      integer :: first = 0, last = 0
      !> How many times the value is meant.
      integer(i8) :: repeat = 1
   end type item_t

contains

   !> Take the next value of a list.
   pure subroutine next_item(text, position, item, flaw)
      !> Text of the value of an assignment: values between blanks, line ends or single commas.
      character(*), intent(in) :: text
      !> In: where to look. Out: where to look for the next value; behind the text if there is none.
      integer, intent(inout) :: position
      !> Ends of the value in the text, and how often it is repeated; `first` is 0 if there is no value.
      type(item_t), intent(out) :: item
      character(:), allocatable, intent(out) :: flaw

      flaw = ''
      call skip_blanks(text, position)
      if (position > len(text)) return
      item%first = position
      do while (position <= len(text))
         select case (text(position:position))
         case (' ', newline, ',')
            exit
         case ('''', '"')
            position = end_of_quote(text, position)
         end select
         position = position + 1
      end do
      item%last = position - 1
      call take_repeat_count(text, item)
      if (item%last < item%first .or. item%repeat < 1) flaw = 'a value is missing, given '//show_text(text)
      call skip_blanks(text, position)
      if (position > len(text)) return
      if (text(position:position) /= ',') return
      position = position + 1
      call skip_blanks(text, position)
      if (position > len(text)) flaw = 'a value is missing, given '//show_text(text//',')
   end subroutine next_item

   !> Take the value of a variable that has only one.
   pure subroutine take_only_word(text, word, flaw, index)
      !> Text of the value, as it stands in the input.
      character(*), intent(in) :: text
      !> The value as it is written, without a repeat count of 1; empty if something is wrong.
      character(:), allocatable, intent(out) :: word
      character(:), allocatable, intent(out) :: flaw
      !> Position in the text of what is wrong, from 1.
      integer, intent(out) :: index
      type(item_t) :: item, second
      integer :: position

      word = ''
      index = 1
      position = 1
      call next_item(text, position, item, flaw)
      if (item%first == 0) flaw = 'no value given'
      if (len(flaw) > 0) return
      if (item%repeat > 1) flaw = 'several values, given '//show_text(text)
      if (position <= len(text)) then
         index = position
         call next_item(text, position, second, flaw)
         if (len(flaw) > 0) return
         flaw = 'several values, given '//show_text(text)
         if (is_name(text(second%first:second%last))) flaw = flaw//' (is a quote or a = missing?); numbers stand without their unit'
      end if
      if (len(flaw) == 0) word = text(item%first:item%last)
   end subroutine take_only_word

   !> Move to what is neither blank nor line end.
   pure subroutine skip_blanks(text, position)
      !> Text of the value of an assignment.
      character(*), intent(in) :: text
      !> In: where to look. Out: the first position that is no blank; one behind the text if all are.
      integer, intent(inout) :: position

      do while (position <= len(text))
         if (.not. (text(position:position) == ' ' .or. text(position:position) == newline)) return
         position = position + 1
      end do
   end subroutine skip_blanks

   !> Take `3*` off a value.
   pure subroutine take_repeat_count(text, item)
      character(*), intent(in) :: text
      !> In: the ends of the value, with its count if it has one. Out: the ends without the count, and `repeat`.
      type(item_t), intent(inout) :: item
      integer :: length, i

      length = verify(text(item%first:item%last), '0123456789') - 1
      if (length < 1 .or. length > most_repeat_digits) return
      if (text(item%first + length:item%first + length) /= '*') return
      item%repeat = 0
      do i = item%first, item%first + length - 1
         item%repeat = 10*item%repeat + iachar(text(i:i)) - iachar('0')
      end do
      item%first = item%first + length + 1
   end subroutine take_repeat_count

end module adfric_input_item

! SPDX-License-Identifier: GPL-3.0-or-later
!> Values of variables that take several of their words at once: a number in which each word has a bit, the first one that of 1.
module adfric_describe_word_sets
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_base_words, only: count_words, get_word
   implicit none (type, external)
   private
   public :: has_number, with_number, show_words

contains

   !> Is a word among those of a value?
   pure logical function has_number(value, number)
      !> The value of the variable, or `unset`.
      real(dp), intent(in) :: value
      !> Number of the word among the choices, from 1.
      integer, intent(in) :: number

      has_number = .false.
      if (is_set(value)) has_number = btest(nint(value), number - 1)
   end function has_number

   !> A value with one more word.
   pure real(dp) function with_number(value, number) result(more)
      !> A value, 0 where it has no word.
      real(dp), intent(in) :: value
      !> Number of the word among the choices, from 1.
      integer, intent(in) :: number

      more = ibset(nint(value), number - 1)
   end function with_number

   !> The words of a value.
   pure function show_words(choices, value, quote, between) result(text)
      !> Words that the variable may have, separated by a blank.
      character(*), intent(in) :: choices
      !> The value.
      real(dp), intent(in) :: value
      !> What stands around each word, and between two of them.
      character(*), intent(in) :: quote, between
      character(:), allocatable :: text
      integer :: k

      text = ''
      do k = 1, count_words(choices)
         if (.not. has_number(value, k)) cycle
         if (len(text) > 0) text = text//between
         text = text//quote//get_word(choices, k)//quote
      end do
   end function show_words

end module adfric_describe_word_sets

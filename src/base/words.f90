! SPDX-License-Identifier: GPL-3.0-or-later
!> Lists of words separated by blanks.
module adfric_base_words
   implicit none (type, external)
   private
   public :: count_words, get_word, find_word, has_word, pad

contains

   !> Number of words.
   pure integer function count_words(list)
      !> Words, separated by one blank or more.
      character(*), intent(in) :: list
      integer :: i

      count_words = 0
      do i = 1, len(list)
         if (list(i:i) == ' ') cycle
         if (i == 1) then
            count_words = 1
         else if (list(i - 1:i - 1) == ' ') then
            count_words = count_words + 1
         end if
      end do
   end function count_words

   !> A word; empty if there are fewer.
   pure function get_word(list, number) result(word)
      !> Words, separated by one blank or more.
      character(*), intent(in) :: list
      !> Which word of the list, from 1.
      integer, intent(in) :: number
      character(:), allocatable :: word

      call find_word(list, number, word)
   end function get_word

   !> Find a word. Threads use this one: gfortran keeps the length of what a function like `get_word` gives back in one index for
   !> all threads.
   pure subroutine find_word(list, number, word)
      !> Words, separated by one blank or more.
      character(*), intent(in) :: list
      !> Which word of the list, from 1.
      integer, intent(in) :: number
      !> Receives the word; empty if there are fewer.
      character(:), allocatable, intent(out) :: word
      !> Indices of the first letter of a word, and behind its last one.
      integer :: first, behind
      integer :: k, length

      first = 0
      behind = 0
      do k = 1, number
         first = behind + verify(list(behind + 1:), ' ')
         if (first == behind) exit
         length = scan(list(first:), ' ') - 1
         if (length < 0) length = len(list) - first + 1
         behind = first + length
      end do
      if (first == behind) then
         word = ''
      else
         word = list(first:behind - 1)
      end if
   end subroutine find_word

   !> A text with blanks to a width, and at least one.
   pure function pad(text, width) result(padded)
      !> The text, which is never cut.
      character(*), intent(in) :: text
      !> Length up to which blanks are added; a longer text gets one blank all the same.
      integer, intent(in) :: width
      character(:), allocatable :: padded

      padded = text//repeat(' ', max(1, width - len(text)))
   end function pad

   !> Is a word in a blank-separated list?
   pure logical function has_word(list, word)
      !> Words, separated by a blank.
      character(*), intent(in) :: list
      !> The word to look for; an empty one stands in no list.
      character(*), intent(in) :: word

      has_word = len_trim(word) > 0 .and. index(' '//list//' ', ' '//trim(word)//' ') > 0
   end function has_word

end module adfric_base_words

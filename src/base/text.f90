! SPDX-License-Identifier: GPL-3.0-or-later
!> Small words about text: letters, names, blank-separated lists, and numbers as a person writes them.
module adfric_base_text
   use adfric_base_kinds, only: dp, i8
   use adfric_base_printable, only: printable, whole_letters
   use adfric_base_words, only: count_words, get_word
   implicit none (type, external)
   private
   public :: newline, name_length, longest_name, to_lower, strip, is_letter, is_digit, is_separator, is_name, is_name_character
   public :: join_words, show_text, show_number, show_count

   !> The end of a line, once the kinds of line ends have been made one.
   character(*), parameter :: newline = achar(10)

   !> Longest name of a group or a variable.
   integer, parameter :: name_length = 63

   !> Longest name of a file, or of a dataset within it, that a system takes.
   integer, parameter :: longest_name = 4096

   !> Longest piece of the user's text that is repeated in a message.
   integer, parameter :: longest_shown = 60
   !> Decimal digits that tell any two numbers apart.
   integer, parameter :: all_digits = 17
   !> Larger numbers, rounded to fewer digits, may be beyond all numbers.
   real(dp), parameter :: largest_rounded = 1.4e308_dp
   !> Decimal exponents between which a number is written without exponent.
   integer, parameter :: smallest_plain = -3, largest_plain = 5

   !> A count as text.
   interface show_count
      module procedure show_integer
      module procedure show_long_integer
   end interface show_count

contains

   !> The text in small letters.
   pure function to_lower(text) result(lower)
      !> Any text; only the letters A to Z are changed.
      character(*), intent(in) :: text
      character(len(text)) :: lower
      integer :: i

      lower = text
      do i = 1, len(text)
         if (text(i:i) >= 'A' .and. text(i:i) <= 'Z') lower(i:i) = achar(iachar(text(i:i)) + 32)
      end do
   end function to_lower

   !> Is it a letter of the English alphabet?
   elemental logical function is_letter(c)
      !> The character to judge.
      character, intent(in) :: c

      is_letter = (c >= 'a' .and. c <= 'z') .or. (c >= 'A' .and. c <= 'Z')
   end function is_letter

   !> Is it a decimal digit?
   elemental logical function is_digit(c)
      !> The character to judge.
      character, intent(in) :: c

      is_digit = c >= '0' .and. c <= '9'
   end function is_digit

   !> Does it stand between two values?
   elemental logical function is_separator(c)
      !> The character to judge.
      character, intent(in) :: c

      is_separator = c == ' ' .or. c == newline .or. c == ','
   end function is_separator

   !> Is it a letter, a digit or an underscore?
   elemental logical function is_name_character(c)
      !> The character to judge.
      character, intent(in) :: c

      is_name_character = is_letter(c) .or. is_digit(c) .or. c == '_'
   end function is_name_character

   !> Is it a name: a letter, then letters, digits and underscores?
   pure logical function is_name(text)
      !> The text to judge; with blanks around it, it is no name.
      character(*), intent(in) :: text
      integer :: i

      is_name = .false.
      if (len(text) < 1 .or. len(text) > name_length) return
      if (.not. is_letter(text(1:1))) return
      do i = 2, len(text)
         if (.not. is_name_character(text(i:i))) return
      end do
      is_name = .true.
   end function is_name

   !> The text without the blanks and line ends around it.
   pure function strip(text) result(stripped)
      !> Any text; an empty one stays empty.
      character(*), intent(in) :: text
      character(:), allocatable :: stripped
      integer :: first

      stripped = ''
      first = verify(text, ' '//newline)
      if (first > 0) stripped = text(first:verify(text, ' '//newline, back=.true.))
   end function strip

   !> A blank-separated list with something else between its words.
   pure function join_words(list, between) result(joined)
      !> Words, separated by a blank.
      character(*), intent(in) :: list
      !> What stands between two words of the result, such as a comma and a blank.
      character(*), intent(in) :: between
      character(:), allocatable :: joined
      integer :: k

      joined = get_word(list, 1)
      do k = 2, count_words(list)
         joined = joined//between//get_word(list, k)
      end do
   end function join_words

   !> A piece of the user's text for a message: on one line, printable and not too long.
   pure function show_text(text) result(shown)
      !> Text as the user wrote it, of any length and with any bytes.
      character(*), intent(in) :: text
      character(:), allocatable :: shown
      integer :: i

      shown = whole_letters(text, longest_shown)
      do i = 1, len(shown)
         if (shown(i:i) == newline) shown(i:i) = ' '
      end do
      shown = printable(shown)
      if (len(text) > longest_shown) shown = shown//'...'
   end function show_text

   !> A number with as few digits as tell it apart from every other.
   pure function show_number(x) result(shown)
      !> A finite number.
      real(dp), intent(in) :: x
      character(:), allocatable :: shown
      character(40) :: buffer
      character(16) :: form
      character(:), allocatable :: digits
      real(dp) :: back
      integer :: n, exponent

      do n = merge(all_digits, 1, abs(x) > largest_rounded), all_digits
         write (form, '(a, i0, a)') '(es40.', n - 1, 'e3)'
         write (buffer, form) abs(x)
         read (buffer, *) back
         if (.not. (back < abs(x) .or. back > abs(x))) exit
      end do
      buffer = adjustl(buffer)
      read (buffer(index(buffer, 'E') + 1:), *) exponent
      digits = buffer(1:1)//buffer(3:index(buffer, 'E') - 1)
      digits = digits(:max(1, verify(digits, '0', back=.true.)))
      shown = put_point(digits, exponent)
      if (x < 0) shown = '-'//shown
   end function show_number

   !> Digits and a decimal exponent as a number: plain where that is short, else with an exponent.
   pure function put_point(digits, exponent) result(shown)
      !> Decimal digits, at least one; with exponent 0 the first one stands before the point.
      character(*), intent(in) :: digits
      !> Decimal exponent of the first digit.
      integer, intent(in) :: exponent
      character(:), allocatable :: shown

      if (exponent < smallest_plain .or. exponent > largest_plain) then
         shown = digits(1:1)
         if (len(digits) > 1) shown = shown//'.'//digits(2:)
         shown = shown//'e'//show_integer(exponent)
      else if (exponent < 0) then
         shown = '0.'//repeat('0', -exponent - 1)//digits
      else if (len(digits) <= exponent + 1) then
         shown = digits//repeat('0', exponent + 1 - len(digits))
      else
         shown = digits(:exponent + 1)//'.'//digits(exponent + 2:)
      end if
   end function put_point

   !> An integer as text.
   pure function show_integer(n) result(shown)
      !> Any integer; a negative one keeps its sign.
      integer, intent(in) :: n
      character(:), allocatable :: shown

      shown = show_long_integer(int(n, i8))
   end function show_integer

   !> A long integer as text.
   pure function show_long_integer(n) result(shown)
      !> Any integer; a negative one keeps its sign.
      integer(i8), intent(in) :: n
      character(:), allocatable :: shown
      character(20) :: buffer

      write (buffer, '(i0)') n
      shown = trim(buffer)
   end function show_long_integer

end module adfric_base_text

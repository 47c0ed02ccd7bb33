! SPDX-License-Identifier: GPL-3.0-or-later
!> One value, from its text to what it means.
!>
!> What the run-time library would accept in silence (an overflow, `1+3` for 1000, any word that begins with t for true)
!> is found here; `strtod`, which the run-time library calls as well, only converts what is known to be a number. A flaw is a
!> text that says what is wrong and what was given; empty, nothing is wrong.
module adfric_input_literal
   use, intrinsic :: iso_c_binding, only: c_char, c_double, c_null_char, c_null_ptr, c_ptr
   use adfric_base_kinds, only: dp, i8
   use adfric_base_text, only: is_digit, to_lower, show_text
   use adfric_input_source_text, only: end_of_quote, is_closed
   implicit none (type, external)
   private
   public :: convert

   !> Numbers from this decimal exponent on, or with these digits at the exponent, are too large.
   integer, parameter :: largest_exponent = 308
   character(*), parameter :: largest_digits = '1797693134862315'
   !> Numbers with a smaller decimal exponent would lose digits.
   integer, parameter :: smallest_exponent = -307
   !> Digits that an integer may have.
   integer, parameter :: most_digits = 18

   !> `call convert(word, value, flaw)`, by the type of the value.
   interface convert
      module procedure convert_real
      module procedure convert_integer
      module procedure convert_logical
      module procedure convert_quoted
   end interface convert

   interface
      !> The number that a text means, rounded to the nearest that can be kept.
      pure real(c_double) function c_strtod(text, end_of_number) bind(c, name='strtod')
         import :: c_char, c_double, c_ptr
         implicit none (type, external)
         !> A number as C writes it, with a null character at its end.
         character(kind=c_char), intent(in) :: text(*)
         !> Where to say how far the number goes; null: nowhere.
         type(c_ptr), intent(in), value :: end_of_number
      end function c_strtod
   end interface

contains

   !> A real number; 0 if something is wrong.
   pure subroutine convert_real(word, value, flaw)
      !> The value as it is written, without blanks.
      character(*), intent(in) :: word
      !> The nearest number that can be kept; 0 if something is wrong.
      real(dp), intent(out) :: value
      character(:), allocatable, intent(out) :: flaw
      integer :: first, exponent
      logical :: is_number

      value = 0
      flaw = ''
      call split_number(word, first, exponent, is_number)
      if (.not. is_number) then
         flaw = trim(merge('not a finite number', 'not a number       ', is_not_finite(word)))//', given '//show_text(word)
      else if (first == 0) then
         return
      else if (is_too_large(word(first:), exponent)) then
         flaw = 'a number too large to be held, given '//show_text(word)
      else if (exponent < smallest_exponent) then
         flaw = 'a number too small to be held, given '//show_text(word)
      else
         value = value_of(word)
      end if
   end subroutine convert_real

   !> Is a number beyond the largest?
   pure logical function is_too_large(digits, exponent)
      !> The number from its first digit on that is not 0, with a point and an exponent where it has them.
      character(*), intent(in) :: digits
      !> Decimal exponent of that first digit.
      integer, intent(in) :: exponent
      integer :: i, n

      is_too_large = exponent > largest_exponent
      if (exponent /= largest_exponent) return
      n = 0
      do i = 1, len(digits)
         if (digits(i:i) == '.') cycle
         n = n + 1
         is_too_large = .true.
         if (n > len(largest_digits)) return
         is_too_large = is_digit(digits(i:i)) .and. digits(i:i) > largest_digits(n:n)
         if (is_too_large .or. digits(i:i) /= largest_digits(n:n)) return
      end do
      is_too_large = n == len(largest_digits)
   end function is_too_large

   !> The value of what is known to be a number.
   pure real(dp) function value_of(word)
      !> A number as Fortran writes it, not too large and not too small.
      character(*), intent(in) :: word
      character(kind=c_char) :: letters(len(word) + 1)
      integer :: i

      do i = 1, len(word)
         letters(i) = word(i:i)
         if (scan(word(i:i), 'dD') > 0) letters(i) = 'e'
      end do
      letters(len(word) + 1) = c_null_char
      value_of = c_strtod(letters, c_null_ptr)
   end function value_of

   !> Is it one of the words for infinity and for no number?
   pure logical function is_not_finite(word)
      !> The value as it is written, with any capitals.
      character(*), intent(in) :: word
      character(:), allocatable :: lower

      lower = to_lower(word)
      if (len(lower) > 0) then
         if (scan(lower(1:1), '+-') > 0) lower = lower(2:)
      end if
      is_not_finite = lower == 'inf' .or. lower == 'infinity' .or. lower == 'nan' .or. index(lower, 'nan(') == 1
   end function is_not_finite

   !> Take a number apart: in 0.0012e5 the first digit is the 1, and the exponent is 2.
   pure subroutine split_number(word, first, exponent, is_number)
      !> The value as it is written, which may be no number.
      character(*), intent(in) :: word
      !> Position of the first digit that is not 0; 0 for the number 0.
      integer, intent(out) :: first
      !> Decimal exponent of that digit.
      integer, intent(out) :: exponent
      !> False if the word is no number; the other two mean nothing then.
      logical, intent(out) :: is_number
      integer :: i, point, n_digits

      first = 0
      exponent = 0
      point = 0
      n_digits = 0
      is_number = .false.
      do i = merge(2, 1, scan(word(:min(1, len(word))), '+-') == 1), len(word)
         select case (word(i:i))
         case ('0':'9')
            n_digits = n_digits + 1
            if (first == 0 .and. word(i:i) /= '0') first = i
         case ('.')
            if (point > 0) return
            point = i
         case default
            exit
         end select
      end do
      if (n_digits == 0) return
      is_number = i > len(word)
      if (.not. is_number) then
         if (scan(word(i:i), 'eEdD') == 0) return
         call read_exponent(word(i + 1:), exponent, is_number)
      end if
      if (point == 0) point = i
      exponent = exponent + point - first
      if (first < point) exponent = exponent - 1
   end subroutine split_number

   !> Read an exponent; an enormous one is cut where it is still enormous.
   pure subroutine read_exponent(word, exponent, is_number)
      !> What stands behind the `e`: digits, with a sign or without.
      character(*), intent(in) :: word
      !> The exponent, of at most 100000000 in size; 0 if the word is no integer.
      integer, intent(out) :: exponent
      !> False if the word is no integer.
      logical, intent(out) :: is_number
      integer, parameter :: enormous = 100000000
      integer :: i, first

      exponent = 0
      first = 1
      if (scan(word(:min(1, len(word))), '+-') == 1) first = 2
      is_number = len(word) >= first .and. verify(word(first:), '0123456789') == 0
      if (.not. is_number) return
      do i = first, len(word)
         exponent = min(enormous, 10*exponent + iachar(word(i:i)) - iachar('0'))
      end do
      if (word(1:1) == '-') exponent = -exponent
   end subroutine read_exponent

   !> An integer; 0 if something is wrong.
   pure subroutine convert_integer(word, value, flaw)
      character(*), intent(in) :: word
      !> The integer; 0 if something is wrong.
      integer(i8), intent(out) :: value
      character(:), allocatable, intent(out) :: flaw
      integer :: first

      value = 0
      flaw = ''
      first = 1
      if (scan(word, '+-') == 1) first = 2
      if (len(word) < first .or. verify(word(first:), '0123456789') > 0) then
         flaw = 'not an integer, given '//show_text(word)
      else if (len(word) - first + 1 > most_digits) then
         flaw = 'an integer too large to be held, given '//show_text(word)
      else
         read (word, *) value
      end if
   end subroutine convert_integer

   !> A logical; false if something is wrong.
   pure subroutine convert_logical(word, value, flaw)
      character(*), intent(in) :: word
      !> The logical; false if something is wrong.
      logical, intent(out) :: value
      character(:), allocatable, intent(out) :: flaw

      value = .false.
      flaw = ''
      select case (to_lower(word))
      case ('.true.', 'true', '.t.', 't')
         value = .true.
      case ('.false.', 'false', '.f.', 'f')
      case default
         flaw = 'not a logical, given '//show_text(word)
      end select
   end subroutine convert_logical

   !> A text in quotes, without them and without the blanks at its end; empty if something is wrong.
   pure subroutine convert_quoted(word, value, flaw)
      !> The value as it is written, with its quotes.
      character(*), intent(in) :: word
      !> The text between the quotes, a doubled quote made one; empty if something is wrong.
      character(:), allocatable, intent(out) :: value
      character(:), allocatable, intent(out) :: flaw
      integer :: i, last, n

      value = ''
      flaw = ''
      if (scan(word(:min(1, len(word))), '''"') /= 1) then
         flaw = 'not a text in quotes, given '//show_text(word)
         return
      end if
      last = end_of_quote(word, 1)
      if (.not. is_closed(word(:last))) then
         flaw = 'a quote is not closed on its line, given '//show_text(word)
      else if (last < len(word)) then
         flaw = 'something stands directly behind the closing quote, given '//show_text(word)
      else
         value = word(2:last - 1)
         n = 0
         i = 2
         do while (i < last)
            n = n + 1
            value(n:n) = word(i:i)
            i = i + merge(2, 1, word(i:i) == word(1:1))
         end do
         value = trim(value(:n))
      end if
   end subroutine convert_quoted

end module adfric_input_literal

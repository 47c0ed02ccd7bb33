!> One value, from its text to what it means.
!>
!> What the run-time library would accept in silence (an overflow, `1+3` for 1000, any word that begins with t for true)
!> is found here; it only converts what is known to be a number. A flaw is a text that says what is wrong and what was
!> given; empty, nothing is wrong.
module adfric_input_literal
   use adfric_base_kinds, only: dp, i8
   use adfric_input_source_text, only: end_of_quote, is_closed
   use adfric_input_text, only: to_lower, show_text
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

contains

   !> A real number; 0 if something is wrong.
   pure subroutine convert_real(word, value, flaw)
      character(*), intent(in) :: word
      real(dp), intent(out) :: value
      character(:), allocatable, intent(out) :: flaw
      character(:), allocatable :: digits
      integer :: exponent
      logical :: is_number

      value = 0
      flaw = ''
      call split_number(word, digits, exponent, is_number)
      if (is_not_finite(word)) then
         flaw = 'not a finite number, given '//show_text(word)
      else if (.not. is_number) then
         flaw = 'not a number, given '//show_text(word)
      else if (len(digits) == 0) then
         return
      else if (exponent > largest_exponent .or. (exponent == largest_exponent .and. digits >= largest_digits)) then
         flaw = 'a number too large to be held, given '//show_text(word)
      else if (exponent < smallest_exponent) then
         flaw = 'a number too small to be held, given '//show_text(word)
      else
         read (word, *) value
      end if
   end subroutine convert_real

   !> Is it one of the words for infinity and for no number?
   pure logical function is_not_finite(word)
      character(*), intent(in) :: word
      character(:), allocatable :: lower

      lower = to_lower(word)
      if (len(lower) > 0) then
         if (scan(lower(1:1), '+-') > 0) lower = lower(2:)
      end if
      is_not_finite = lower == 'inf' .or. lower == 'infinity' .or. lower == 'nan' .or. index(lower, 'nan(') == 1
   end function is_not_finite

   !> Take a number apart: 0.0012e5 has the digits 12 and the exponent 2, that of its first digit.
   pure subroutine split_number(word, digits, exponent, is_number)
      character(*), intent(in) :: word
      !> From the first that is not 0; empty for the number 0.
      character(:), allocatable, intent(out) :: digits
      integer, intent(out) :: exponent
      logical, intent(out) :: is_number
      character(:), allocatable :: mantissa
      integer :: mark, point, n_zeros

      is_number = .false.
      digits = ''
      exponent = 0
      mantissa = word
      mark = scan(word, 'eEdD')
      if (mark > 0) then
         mantissa = word(:mark - 1)
         call read_exponent(word(mark + 1:), exponent, is_number)
         if (.not. is_number) return
      end if
      if (scan(mantissa, '+-') == 1) mantissa = mantissa(2:)
      point = index(mantissa//'.', '.')
      digits = mantissa(:point - 1)//mantissa(point + 1:)
      is_number = len(digits) > 0 .and. verify(digits, '0123456789') == 0
      if (.not. is_number) return
      n_zeros = verify(digits//'1', '0') - 1
      digits = digits(n_zeros + 1:)
      exponent = exponent + point - 2 - n_zeros
   end subroutine split_number

   !> Read an exponent; an enormous one is cut where it is still enormous.
   pure subroutine read_exponent(word, exponent, is_number)
      character(*), intent(in) :: word
      integer, intent(out) :: exponent
      logical, intent(out) :: is_number
      integer, parameter :: enormous = 100000000
      integer :: i, first

      exponent = 0
      first = 1
      if (scan(word, '+-') == 1) first = 2
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
      character(*), intent(in) :: word
      character(:), allocatable, intent(out) :: value
      character(:), allocatable, intent(out) :: flaw
      integer :: i, last

      value = ''
      flaw = ''
      if (scan(word, '''"') /= 1) then
         flaw = 'not a text in quotes, given '//show_text(word)
         return
      end if
      last = end_of_quote(word, 1)
      if (.not. is_closed(word(:last))) then
         flaw = 'a quote is not closed on its line, given '//show_text(word)
      else if (last < len(word)) then
         flaw = 'something stands directly behind the closing quote, given '//show_text(word)
      else
         i = 2
         do while (i < last)
            value = value//word(i:i)
            i = i + merge(2, 1, word(i:i) == word(1:1))
         end do
         value = trim(value)
      end if
   end subroutine convert_quoted

end module adfric_input_literal

!> The values of an assignment one by one, and whether a word is a number.
!>
!> What the run-time library would accept in silence (an overflow, a null value, `1+3` for 1000, any word
!> that begins with t for true) is found here, before it reads the value. A flaw is a text that says
!> what is wrong and what was given; empty, nothing is wrong.
module adfric_input_literal
   use adfric_base_kinds, only: i8
   use adfric_input_source_text, only: end_of_quote
   use adfric_input_text, only: newline, to_lower, is_separator, show_text
   implicit none (type, external)
   private
   public :: item_t, next_item, find_real_flaw, find_integer_flaw, find_logical_flaw, find_string_flaw

   !> Numbers from this decimal exponent on, or with these digits at the exponent, are too large.
   integer, parameter :: largest_exponent = 308
   character(*), parameter :: largest_digits = '1797693134862315'
   !> Numbers with a smaller decimal exponent would lose digits.
   integer, parameter :: smallest_exponent = -307
   !> Digits that an integer may have.
   integer, parameter :: most_digits = 18
   !> Digits that a repeat count may have.
   integer, parameter :: most_repeat_digits = 9

   !> One value, with the number of times it is meant.
   type :: item_t
      !> Where it stands, without its repeat count; 0 if there is none.
      integer :: first = 0, last = 0
      integer(i8) :: repeat = 1
   end type item_t

contains

   !> Take the next value of a list.
   pure subroutine next_item(text, position, item, flaw)
      character(*), intent(in) :: text
      !> Where to look, then where to look next.
      integer, intent(inout) :: position
      type(item_t), intent(out) :: item
      character(:), allocatable, intent(out) :: flaw

      flaw = ''
      call skip_blanks(text, position)
      if (position > len(text)) return
      item%first = position
      do while (position <= len(text))
         if (is_separator(text(position:position))) exit
         if (scan(text(position:position), '''"') > 0) position = end_of_quote(text, position)
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

   !> Move to what is neither blank nor line end.
   pure subroutine skip_blanks(text, position)
      character(*), intent(in) :: text
      integer, intent(inout) :: position

      do while (position <= len(text))
         if (.not. (text(position:position) == ' ' .or. text(position:position) == newline)) return
         position = position + 1
      end do
   end subroutine skip_blanks

   !> Take `3*` off a value.
   pure subroutine take_repeat_count(text, item)
      character(*), intent(in) :: text
      type(item_t), intent(inout) :: item
      integer :: length

      length = verify(text(item%first:item%last)//'.', '0123456789') - 1
      if (length < 1 .or. length > most_repeat_digits) return
      if (item%first + length > item%last) return
      if (text(item%first + length:item%first + length) /= '*') return
      read (text(item%first:item%first + length - 1), *) item%repeat
      item%first = item%first + length + 1
   end subroutine take_repeat_count

   !> What is wrong with a real number?
   pure function find_real_flaw(word) result(flaw)
      character(*), intent(in) :: word
      character(:), allocatable :: flaw
      character(:), allocatable :: digits
      integer :: exponent
      logical :: is_number

      flaw = ''
      if (is_not_finite(word)) then
         flaw = 'not a finite number, given '//show_text(word)
         return
      end if
      call split_number(word, digits, exponent, is_number)
      if (.not. is_number) then
         flaw = 'not a number, given '//show_text(word)
      else if (len(digits) == 0) then
         return
      else if (exponent > largest_exponent .or. (exponent == largest_exponent .and. digits >= largest_digits)) then
         flaw = 'a number too large to be held, given '//show_text(word)
      else if (exponent < smallest_exponent) then
         flaw = 'a number too small to be held, given '//show_text(word)
      end if
   end function find_real_flaw

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

   !> What is wrong with an integer?
   pure function find_integer_flaw(word) result(flaw)
      character(*), intent(in) :: word
      character(:), allocatable :: flaw
      integer :: first

      flaw = ''
      first = 1
      if (scan(word, '+-') == 1) first = 2
      if (len(word) < first .or. verify(word(first:), '0123456789') > 0) then
         flaw = 'not an integer, given '//show_text(word)
      else if (len(word) - first + 1 > most_digits) then
         flaw = 'an integer too large to be held, given '//show_text(word)
      end if
   end function find_integer_flaw

   !> What is wrong with a logical?
   pure function find_logical_flaw(word) result(flaw)
      character(*), intent(in) :: word
      character(:), allocatable :: flaw

      flaw = ''
      select case (to_lower(word))
      case ('.true.', '.false.', 'true', 'false', 't', 'f', '.t.', '.f.')
      case default
         flaw = 'not a logical, given '//show_text(word)
      end select
   end function find_logical_flaw

   !> What is wrong with a quoted word?
   pure function find_string_flaw(word) result(flaw)
      character(*), intent(in) :: word
      character(:), allocatable :: flaw
      integer :: i, last

      flaw = ''
      if (len(word) == 0) return
      if (scan(word, '''"') /= 1) then
         flaw = 'not a text in quotes, given '//show_text(word)
         return
      end if
      last = end_of_quote(word, 1)
      if (mod(count([(word(i:i) == word(1:1), i=1, last)]), 2) == 1) then
         flaw = 'a quote is not closed on its line, given '//show_text(word)
      else if (last < len(word)) then
         flaw = 'something stands directly behind the closing quote, given '//show_text(word)
      end if
   end function find_string_flaw

end module adfric_input_literal

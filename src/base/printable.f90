! SPDX-License-Identifier: GPL-3.0-or-later
!> Text from outside as it may be shown: names of files, titles, values.
!>
!> A terminal obeys some characters instead of showing them: controls move, clear and colour, marks of direction turn the words
!> that follow around, and others are invisible. They are shown by their numbers, `\x1b` or `\u202e`, and so are bytes that are
!> no UTF-8.
module adfric_base_printable
   implicit none (type, external)
   private
   public :: printable, whole_letters, shell_word, length_of_letter

   character(*), parameter :: newline = achar(10)
   character(*), parameter :: hexadecimal = '0123456789abcdef'
   !> Most letters that a byte is shown by, as in `\x1b`; a code point of several bytes is shown by seven at most.
   integer, parameter :: longest_shown = 4
   !> Ranges of code points that are not shown as they are.
   integer, parameter :: unseen(2, 12) = reshape([ &
      int(z'00'), int(z'1f'), &        ! controls
      int(z'7f'), int(z'9f'), &
      int(z'ad'), int(z'ad'), &        ! a hyphen that is not always seen
      int(z'61c'), int(z'61c'), &      ! a mark of direction
      int(z'200b'), int(z'200f'), &    ! of no width, and marks of direction
      int(z'2028'), int(z'202e'), &    ! ends of lines, and marks of direction
      int(z'2060'), int(z'206f'), &    ! of no width, and marks of direction
      int(z'd800'), int(z'dfff'), &    ! no characters
      int(z'feff'), int(z'feff'), &    ! of no width
      int(z'fff9'), int(z'fffb'), &    ! notes between the lines
      int(z'180e'), int(z'180e'), &    ! of no width
      int(z'e0000'), int(z'e0fff')], [2, 12])   ! tags and variants, which are not seen

contains

   !> The text with everything in it to be seen.
   pure function printable(text, has_lines) result(shown)
      !> Text from outside: any bytes, UTF-8 or not.
      character(*), intent(in) :: text
      !> Are the line ends of the text meant as such? If absent, no: what is shown is one line.
      logical, intent(in), optional :: has_lines
      character(:), allocatable :: shown
      integer :: i, n, length
      logical :: keeps_lines

      keeps_lines = .false.
      if (present(has_lines)) keeps_lines = has_lines
      if (is_plain(text, keeps_lines)) then
         shown = text
         return
      end if
      allocate (character(longest_shown*len(text)) :: shown)
      n = 0
      i = 1
      do while (i <= len(text))
         length = length_of_letter(text, i)
         if (is_seen(text(i:i + max(length, 1) - 1), length) .or. (keeps_lines .and. text(i:i) == newline)) then
            call append(text(i:i + length - 1), shown, n)
         else if (length > 1) then
            call append('\u'//digits_of(code_point(text(i:i + length - 1)), 4), shown, n)
         else
            call append('\x'//digits_of(iachar(text(i:i)), 2), shown, n)
         end if
         i = i + max(length, 1)
      end do
      shown = shown(:n)
   end function printable

   !> Is there nothing but letters, digits and signs of the English alphabet, so that the text can be shown as it is?
   pure logical function is_plain(text, keeps_lines)
      !> Text from outside: any bytes, UTF-8 or not.
      character(*), intent(in) :: text
      logical, intent(in) :: keeps_lines
      integer :: i

      is_plain = .false.
      do i = 1, len(text)
         if (text(i:i) >= ' ' .and. text(i:i) <= '~') cycle
         if (.not. (keeps_lines .and. text(i:i) == newline)) return
      end do
      is_plain = .true.
   end function is_plain

   !> Append to a text that has the space.
   pure subroutine append(part, text, n)
      !> What is appended.
      character(*), intent(in) :: part
      !> The text, with space for the part behind its first `n` bytes.
      character(*), intent(inout) :: text
      !> Length of the text so far, in bytes; it grows by that of the part.
      integer, intent(inout) :: n

      text(n + 1:n + len(part)) = part
      n = n + len(part)
   end subroutine append

   !> Is a letter shown as it is?
   pure logical function is_seen(letter, length)
      !> Bytes of the letter in UTF-8.
      character(*), intent(in) :: letter
      !> Number of these bytes; 0 if they are no letter.
      integer, intent(in) :: length
      integer :: code

      is_seen = .false.
      if (length == 0) return
      code = code_point(letter)
      is_seen = .not. any(code >= unseen(1, :) .and. code <= unseen(2, :))
   end function is_seen

   !> Bytes of the UTF-8 letter at a position; 0 if there is none.
   pure integer function length_of_letter(text, first)
      !> Text from outside: any bytes, UTF-8 or not.
      character(*), intent(in) :: text
      !> Index of the first byte of the letter, within the text.
      integer, intent(in) :: first
      !> Least code point of a letter of so many bytes: a shorter form is the only one allowed.
      integer, parameter :: least(4) = [0, int(z'80'), int(z'800'), int(z'10000')]
      integer :: i, code

      length_of_letter = 0
      select case (iachar(text(first:first)))
      case (0:127)
         length_of_letter = 1
         return
      case (192:223)
         i = 2
      case (224:239)
         i = 3
      case (240:247)
         i = 4
      case default
         return
      end select
      if (first + i - 1 > len(text)) return
      if (.not. all(are_followers(text(first + 1:first + i - 1), i - 1))) return
      code = code_point(text(first:first + i - 1))
      if (code >= least(i) .and. code <= int(z'10ffff')) length_of_letter = i
   end function length_of_letter

   !> Are bytes those behind the first of a letter?
   pure function are_followers(bytes, n) result(are)
      !> The bytes, `n` or more.
      character(*), intent(in) :: bytes
      !> How many of them are looked at.
      integer, intent(in) :: n
      logical :: are(n)
      integer :: i

      are = [(iachar(bytes(i:i)) >= 128 .and. iachar(bytes(i:i)) < 192, i=1, n)]
   end function are_followers

   !> Number of a letter.
   pure integer function code_point(letter)
      !> Bytes of the letter in UTF-8, one to four.
      character(*), intent(in) :: letter
      !> What the first byte of a letter of so many bytes says of its length.
      integer, parameter :: mark(4) = [0, 192, 224, 240]
      integer :: i

      code_point = iachar(letter(1:1)) - mark(len(letter))
      do i = 2, len(letter)
         code_point = 64*code_point + iachar(letter(i:i)) - 128
      end do
   end function code_point

   !> A number in hexadecimal digits.
   pure function digits_of(number, n) result(digits)
      !> The number, >= 0.
      integer, intent(in) :: number
      !> Least number of digits; a shorter number has zeros before it.
      integer, intent(in) :: n
      character(:), allocatable :: digits
      integer :: rest, k

      digits = ''
      rest = number
      do while (rest > 0 .or. len(digits) < n)
         k = 1 + mod(rest, 16)
         digits = hexadecimal(k:k)//digits
         rest = rest/16
      end do
   end function digits_of

   !> The first letters of a text, of so many bytes at most: no letter is cut.
   pure function whole_letters(text, most) result(letters)
      !> Text from outside: any bytes, UTF-8 or not.
      character(*), intent(in) :: text
      !> Most bytes that the result may have, >= 0.
      integer, intent(in) :: most
      character(:), allocatable :: letters
      integer :: last, back

      last = min(len(text), most)
      if (last < len(text)) then
         do back = 0, min(2, last - 1)
            if (length_of_letter(text, last - back) <= back + 1) cycle
            last = last - back - 1
            exit
         end do
      end if
      letters = text(:last)
   end function whole_letters

   !> The name of a file as it is typed: quoted where the shell needs that, and never to be taken for an option.
   pure function shell_word(name) result(word)
      !> Name of the file, without any quotes.
      character(*), intent(in) :: name
      character(:), allocatable :: word
      character(*), parameter :: harmless = 'abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./-+=:,@%'
      integer :: i

      word = name
      if (verify(name, harmless) > 0 .or. len(name) == 0) then
         word = ''''
         do i = 1, len(name)
            if (name(i:i) == '''') then
               word = word//'''\'''''
            else
               word = word//name(i:i)
            end if
         end do
         word = word//''''
      end if
      if (index(name, '-') == 1) word = './'//word
   end function shell_word

end module adfric_base_printable

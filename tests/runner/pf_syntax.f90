! SPDX-License-Identifier: GPL-3.0-or-later
!> Lexical rules of test files, as far as this runner has to know them.
module pf_syntax
   implicit none (type, external)
   private
   public :: lower, is_identifier, leading_identifier, mask, is_reserved, check_assertion

   character(len=*), parameter :: lower_letters = 'abcdefghijklmnopqrstuvwxyz'
   character(len=*), parameter :: upper_letters = 'ABCDEFGHIJKLMNOPQRSTUVWXYZ'
   character(len=*), parameter :: word_characters = lower_letters//'0123456789_'

   !> Names that `use funit` brings in under pFUnit, or that pFUnit gives to variables in the code it adds.
   character(len=*), parameter :: reserved_names = ' all_of any_of anyexceptions array_with_size cases catch' &
      //' catchnext contains_string described_as description_of disable empty_array ends_with equal_to every' &
      //' every_item expectation false file finalize generic_run get_context initialize is matchable near not' &
      //' output_unit predicate relatively_near run second starts_with stub subject suite t test testcase' &
      //' testmethod testresult testrunner testsuite throw true '

   !> Longest assertion [characters]: pFUnit adds a few to the line, which must not pass 132.
   integer, parameter :: longest_assertion = 120

contains

   pure function lower(text) result(folded)
      character(len=*), intent(in) :: text
      character(len=len(text)) :: folded

      integer :: i, k

      folded = text
      do i = 1, len(text)
         k = index(upper_letters, text(i:i))
         if (k > 0) folded(i:i) = lower_letters(k:k)
      end do
   end function lower

   !> The word at the start of the text, in small letters; empty if there is none.
   pure function leading_identifier(text) result(word)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: word

      word = lower(text)
      word = word(:verify(word//' ', word_characters) - 1)
   end function leading_identifier

   pure logical function is_identifier(text)
      character(len=*), intent(in) :: text

      is_identifier = len(text) > 0
      if (is_identifier) is_identifier = verify(lower(text), word_characters) == 0 .and. scan(text(1:1), '0123456789_') == 0
   end function is_identifier

   pure logical function is_reserved(name)
      character(len=*), intent(in) :: name

      is_reserved = index(reserved_names, ' '//trim(name)//' ') > 0
   end function is_reserved

   !> The text with underscores for all characters inside quotes and brackets.
   pure subroutine mask(text, masked, is_balanced)
      character(len=*), intent(in) :: text
      character(len=len(text)), intent(out) :: masked
      !> Whether every quote and bracket is closed, and none closes what was not open.
      logical, intent(out) :: is_balanced

      character(len=1) :: quote
      integer :: depth, i

      masked = text
      is_balanced = .true.
      quote = ' '
      depth = 0
      do i = 1, len(text)
         if (quote /= ' ') then
            if (text(i:i) == quote) quote = ' '
            masked(i:i) = '_'
         else if (scan(text(i:i), '''"') > 0) then
            quote = text(i:i)
            masked(i:i) = '_'
         else
            if (scan(text(i:i), ')]') > 0) depth = depth - 1
            if (depth > 0) masked(i:i) = '_'
            if (scan(text(i:i), '([') > 0) depth = depth + 1
            is_balanced = is_balanced .and. depth >= 0
         end if
      end do
      is_balanced = is_balanced .and. depth == 0 .and. quote == ' '
   end subroutine mask

   !> Check one assertion, given from its name to the end of the line.
   pure subroutine check_assertion(text, problem)
      character(len=*), intent(in) :: text
      !> What is wrong; empty if nothing is.
      character(len=:), allocatable, intent(out) :: problem

      character(len=:), allocatable :: name
      character(len=len(text)) :: masked
      logical :: is_balanced

      problem = ''
      name = leading_identifier(text)
      if (find_rule(name) == '') then
         problem = '@'//name//' is not one of the assertions known here'
      else if (len(text) > longest_assertion) then
         problem = 'an assertion may have at most 120 characters'
      else
         call mask(text, masked, is_balanced)
         ! Masked, a complete call is the name, underscores in parentheses and nothing else.
         if (masked /= text(:len(name))//'('//repeat('_', max(0, len(text) - len(name) - 2))//')' &
            .or. .not. is_balanced) then
            problem = 'an assertion stands on one line, as @'//name//'(...) with nothing after it'
         else
            call check_arguments(name, text(len(name) + 2:len(text) - 1), problem)
         end if
      end if
   end subroutine check_assertion

   !> Number of operands (least, most) and keywords allowed after them; blank for an unknown assertion.
   pure function find_rule(name) result(rule)
      character(len=*), intent(in) :: name
      character(len=20) :: rule

      select case (name)
      case ('assertequal')
         rule = '22 message tolerance'
      case ('assertrelativelyequal')
         rule = '22 message tolerance'
      case ('assertlessthan', 'assertlessthanorequal', 'assertgreaterthan', 'assertgreaterthanorequal')
         rule = '22 message'
      case ('asserttrue', 'assertfalse', 'assertisnan', 'assertisfinite')
         rule = '11 message'
      case ('assertfail')
         rule = '11'
      case ('assertexceptionraised')
         rule = '01'
      case default
         rule = ''
      end select
   end function find_rule

   pure subroutine check_arguments(name, arguments, problem)
      character(len=*), intent(in) :: name, arguments
      character(len=:), allocatable, intent(out) :: problem

      character(len=len(arguments)) :: masked
      character(len=:), allocatable :: keyword
      character(len=20) :: rule
      integer :: first, last, n_operands
      logical :: is_balanced, has_tolerance

      problem = ''
      rule = find_rule(name)
      call mask(arguments, masked, is_balanced)
      if (scan(masked, '!&;@') > 0) problem = 'only expressions may stand in an assertion'
      n_operands = 0
      has_tolerance = .false.
      first = 1
      do while (first <= len(arguments) .and. len_trim(arguments) > 0)
         last = first + index(masked(first:)//',', ',') - 2
         keyword = find_keyword(arguments(first:last))
         if (keyword == '') then
            n_operands = n_operands + 1
         else if (index(rule(3:)//' ', ' '//keyword//' ') == 0) then
            problem = keyword//'= is not a keyword of @'//name//' here'
         end if
         has_tolerance = has_tolerance .or. keyword == 'tolerance'
         first = last + 2
      end do
      if (problem /= '') return
      if (n_operands < iachar(rule(1:1)) - iachar('0') .or. n_operands > iachar(rule(2:2)) - iachar('0')) then
         problem = 'wrong number of arguments of @'//name//'; message and tolerance need message= and tolerance='
      else if (name == 'assertrelativelyequal' .and. .not. has_tolerance) then
         problem = '@assertRelativelyEqual needs tolerance='
      end if
   end subroutine check_arguments

   !> The keyword of an argument written as keyword=value; empty if it has none.
   pure function find_keyword(argument) result(keyword)
      character(len=*), intent(in) :: argument
      character(len=:), allocatable :: keyword

      character(len=:), allocatable :: rest

      rest = adjustl(argument)
      keyword = leading_identifier(rest)
      rest = adjustl(rest(len(keyword) + 1:))//'  '
      if (rest(1:1) /= '=' .or. rest(2:2) == '=') keyword = ''
   end function find_keyword

end module pf_syntax

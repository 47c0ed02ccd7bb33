! SPDX-License-Identifier: GPL-3.0-or-later
!> Translation of one pFUnit test file into Fortran, line by line.
!>
!> Known are @test, @before, @after and the assertions of module funit. Whatever else pFUnit would accept, or
!> would reject or silently skip later, is refused here with the number of its line.
module pf_translate
   use pf_syntax, only: check_assertion, is_identifier, is_reserved, leading_identifier, lower, mask
   implicit none (type, external)
   private
   public :: test_file_t, new_test_file, translate_line, finish_file

   !> Longest line that Fortran allows [characters].
   integer, parameter :: longest_line = 132
   !> Longest name [characters].
   integer, parameter :: name_length = 63

   !> A test procedure.
   type :: test_t
      character(len=name_length) :: name = ''
      !> Macro that must be defined for the test to run; blank if none.
      character(len=name_length) :: condition = ''
   end type test_t

   !> What is known of a test file so far.
   type :: test_file_t
      !> Where the file lies, and its name without folders.
      character(len=:), allocatable :: path, name
      !> Unit the translation is written to.
      integer :: unit = -1
      !> Number of the current line, from 1.
      integer :: line = 0
      logical :: has_module = .false.
      !> Whether the module's `contains` has been passed.
      logical :: is_in_procedures = .false.
      !> Directive whose subroutine must come next; blank if none.
      character(len=6) :: awaiting = ''
      character(len=name_length) :: condition = '', before = '', after = ''
      type(test_t), allocatable :: tests(:)
   end type test_file_t

contains

   subroutine new_test_file(self, path, unit)
      type(test_file_t), intent(out) :: self
      character(len=*), intent(in) :: path
      integer, intent(in) :: unit

      self%path = path
      self%name = path(index(path, '/', back=.true.) + 1:)
      self%unit = unit
      allocate (self%tests(0))
      call write_position(self, 1)
   end subroutine new_test_file

   !> Translate the next line.
   subroutine translate_line(self, line, problem)
      type(test_file_t), intent(inout) :: self
      character(len=*), intent(in) :: line
      !> What is wrong with the line; empty if nothing is.
      character(len=:), allocatable, intent(out) :: problem

      character(len=:), allocatable :: text

      problem = ''
      self%line = self%line + 1
      text = trim(adjustl(line))
      if (len_trim(line) > longest_line) then
         problem = 'a line may have at most 132 characters'
      else if (text == '' .or. index(text, '!') == 1) then
         write (self%unit, '(a)') trim(line)
      else if (text(1:1) == '@') then
         call translate_directive(self, text, problem)
      else
         call check_code(self, text, problem)
         write (self%unit, '(a)') trim(line)
      end if
   end subroutine translate_line

   !> Check what can be checked only at the end, and add the procedure that runs the tests.
   subroutine finish_file(self, problem)
      type(test_file_t), intent(in) :: self
      character(len=:), allocatable, intent(out) :: problem

      problem = ''
      if (self%awaiting /= '') then
         problem = '@'//trim(self%awaiting)//' without a subroutine'
      else if (.not. self%has_module) then
         problem = 'no module '//base_name(self)
      else if (size(self%tests) == 0) then
         problem = 'no @test'
      else
         call write_suite(self)
      end if
   end subroutine finish_file

   subroutine translate_directive(self, text, problem)
      type(test_file_t), intent(inout) :: self
      character(len=*), intent(in) :: text
      character(len=:), allocatable, intent(out) :: problem

      character(len=:), allocatable :: name, rest

      problem = ''
      name = leading_identifier(text(2:))
      rest = text(len(name) + 2:)
      if (.not. self%is_in_procedures) then
         problem = '@'//name//' must come after the contains of module '//base_name(self)
      else if (self%awaiting /= '') then
         problem = 'a subroutine must follow @'//trim(self%awaiting)
      else if (index(name, 'assert') == 1) then
         call check_assertion(text(2:), problem)
         if (problem == '') call write_assertion(self, text(2:))
      else if (name == 'test') then
         call read_condition(rest, self%condition, problem)
         self%awaiting = 'test'
      else if ((name == 'before' .and. self%before == '') .or. (name == 'after' .and. self%after == '')) then
         if (rest /= '') problem = '@'//name//' stands alone on its line'
         self%awaiting = name
      else
         problem = '@'//name//' is not supported here, or is given twice; known are @test, @before, @after and @assert...'
      end if
      if (self%awaiting /= '') write (self%unit, '(a)') '! '//text(2:)
   end subroutine translate_directive

   !> What follows @test: nothing, or (ifdef=NAME).
   subroutine read_condition(rest, condition, problem)
      character(len=*), intent(in) :: rest
      character(len=name_length), intent(out) :: condition
      character(len=:), allocatable, intent(out) :: problem

      integer :: n

      condition = ''
      problem = ''
      n = len(rest)
      if (n == 0) return
      if (index(rest, '(ifdef=') == 1 .and. rest(n:n) == ')') condition = rest(8:n - 1)
      if (.not. is_identifier(trim(condition))) problem = '@test stands alone on its line or is @test(ifdef=NAME)'
   end subroutine read_condition

   !> Check a line of Fortran, and take a name from it where a directive waits for one.
   subroutine check_code(self, text, problem)
      type(test_file_t), intent(inout) :: self
      character(len=*), intent(in) :: text
      character(len=:), allocatable, intent(out) :: problem

      character(len=:), allocatable :: code

      problem = ''
      code = lower(strip_comment(text))
      if (index(strip_quoted(code), '@') > 0) then
         problem = 'a directive must be the first thing on its line'
      else if (self%awaiting /= '') then
         call take_subroutine(self, code, problem)
      else if (index(code, 'module ') == 1 .and. index(code, 'module procedure') == 0) then
         call take_module(self, text, problem)
      else if (code == 'private') then
         problem = 'pFUnit does not see private tests: leave the default public'
      else if (code == 'contains') then
         self%is_in_procedures = self%has_module
      else
         call check_names(self, code, problem)
      end if
   end subroutine check_code

   subroutine take_subroutine(self, code, problem)
      type(test_file_t), intent(inout) :: self
      character(len=*), intent(in) :: code
      character(len=:), allocatable, intent(out) :: problem

      character(len=:), allocatable :: name, rest

      problem = ''
      rest = adjustl(code(len(leading_identifier(code)) + 1:))
      name = leading_identifier(rest)
      rest = trim(adjustl(rest(len(name) + 1:)))
      if (leading_identifier(code) /= 'subroutine' .or. .not. is_identifier(name) .or. rest /= '()') then
         problem = 'after @'//trim(self%awaiting)//' the next statement must be: subroutine name()'
      else if (self%awaiting == 'test' .and. index(name, 'test_') /= 1) then
         problem = 'the name of a test begins with test_'
      else if (is_reserved(name)) then
         problem = name//' is a name that pFUnit uses itself'
      end if
      select case (self%awaiting)
      case ('test')
         self%tests = [self%tests, test_t(name, self%condition)]
      case ('before')
         self%before = name
      case default
         self%after = name
      end select
      self%awaiting = ''
   end subroutine take_subroutine

   subroutine take_module(self, text, problem)
      type(test_file_t), intent(inout) :: self
      character(len=*), intent(in) :: text
      character(len=:), allocatable, intent(out) :: problem

      problem = ''
      if (self%has_module .or. adjustl(lower(text(7:))) /= base_name(self)) then
         problem = 'a test file holds one module named as the file: module '//base_name(self)
      end if
      self%has_module = .true.
   end subroutine take_module

   !> Refuse names of procedures, and of other things declared in the module, that clash with pFUnit's.
   subroutine check_names(self, code, problem)
      type(test_file_t), intent(in) :: self
      character(len=*), intent(in) :: code
      character(len=:), allocatable, intent(out) :: problem

      character(len=len(code)) :: masked
      character(len=:), allocatable :: name
      integer :: colons, first
      logical :: is_balanced

      problem = ''
      call mask(code, masked, is_balanced)
      if (index(masked, '=') == 0 .and. index(code, 'end') /= 1) then
         name = name_after(masked, 'subroutine ')//name_after(masked, 'function ')
         if (is_reserved(name)) problem = name//' is a name that pFUnit uses itself'
      end if
      colons = index(masked, '::')
      if (self%is_in_procedures .or. colons == 0 .or. leading_identifier(code) == 'use') return
      first = colons + 2
      do while (first <= len(code))
         name = leading_identifier(adjustl(code(first:)))
         if (is_reserved(name)) problem = name//' is a name that pFUnit uses itself'
         first = first + index(masked(first:)//',', ',')
      end do
   end subroutine check_names

   !> The word after the keyword; empty if the keyword does not occur.
   pure function name_after(code, keyword) result(name)
      character(len=*), intent(in) :: code, keyword
      character(len=:), allocatable :: name

      integer :: position

      name = ''
      position = index(' '//code, ' '//keyword)
      if (position > 0) name = leading_identifier(adjustl(code(position + len(keyword):)))
   end function name_after

   !> The text up to a comment.
   pure function strip_comment(text) result(code)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: code

      code = text(:index(strip_quoted(text)//'!', '!') - 1)
      code = trim(code)
   end function strip_comment

   !> The text with blanks for everything in quotes.
   pure function strip_quoted(text) result(code)
      character(len=*), intent(in) :: text
      character(len=len(text)) :: code

      character(len=1) :: quote
      integer :: i

      code = text
      quote = ' '
      characters: do i = 1, len(text)
         if (quote == ' ' .and. text(i:i) == '!') exit characters
         if (quote == ' ' .and. scan(text(i:i), '''"') > 0) then
            quote = text(i:i)
         else if (quote /= ' ') then
            code(i:i) = ' '
            if (text(i:i) == quote) quote = ' '
         end if
      end do characters
   end function strip_quoted

   !> Name of the file without its ending, in small letters.
   pure function base_name(self) result(name)
      type(test_file_t), intent(in) :: self
      character(len=:), allocatable :: name

      name = lower(self%name(:index(self%name, '.', back=.true.) - 1))
   end function base_name

   !> Let the compiler's messages speak of this line of the test file from here on.
   subroutine write_position(self, line)
      type(test_file_t), intent(in) :: self
      integer, intent(in) :: line

      write (self%unit, '(a, i0, a)') '#line ', line, ' "'//self%path//'"'
   end subroutine write_position

   subroutine write_assertion(self, text)
      type(test_file_t), intent(in) :: self
      character(len=*), intent(in) :: text

      character(len=:), allocatable :: call_text

      call_text = 'call '//text(:len(text) - 1)
      if (index(text, '(') < len_trim(text(:len(text) - 1))) call_text = call_text//','
      call write_position(self, self%line)
      write (self%unit, '(a)') call_text//' &'
      write (self%unit, '(a, i0, a)') '   location=SourceLocation('''//self%name//''', ', self%line, '))'
      write (self%unit, '(a)') 'if (anyExceptions()) return'
      call write_position(self, self%line + 1)
   end subroutine write_assertion

   !> An external procedure that the test program calls.
   subroutine write_suite(self)
      type(test_file_t), intent(in) :: self

      character(len=:), allocatable :: condition, fixtures, name, suite
      integer :: i

      suite = base_name(self)//'_suite'
      fixtures = ''
      if (self%before /= '') fixtures = fixtures//', before='//trim(self%before)
      if (self%after /= '') fixtures = fixtures//', after='//trim(self%after)
      write (self%unit, '(a)') 'subroutine '//suite//'()', '   use funit_runner, only: run_test', &
         '   use '//base_name(self), '   implicit none (type, external)'
      do i = 1, size(self%tests)
         name = trim(self%tests(i)%name)
         condition = trim(self%tests(i)%condition)
         if (condition /= '') write (self%unit, '(a)') '#ifdef '//condition
         write (self%unit, '(a)') '   call run_test('''//suite//'.'//name//''', &', &
            '      '//name//fixtures//')'
         if (condition /= '') write (self%unit, '(a)') '#endif'
      end do
      write (self%unit, '(a)') 'end subroutine '//suite
   end subroutine write_suite

end module pf_translate

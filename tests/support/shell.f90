! SPDX-License-Identifier: GPL-3.0-or-later
!> Run the program as a user does.
module shell
   implicit none (type, external)
   private
   public :: run_program, write_input, run_command, count_lines, first_line, contains_text

contains

   !> Run the program with arguments, in the folder of the tests.
   subroutine run_program(arguments, exit_status, output, errors)
      character(*), intent(in) :: arguments
      integer, intent(out) :: exit_status
      !> What it wrote to standard output and to standard error.
      character(:), allocatable, intent(out) :: output, errors
      character(1000) :: program
      integer :: length

      call get_environment_variable('ADFRIC_PROGRAM', program, length)
      call run_command(''''//program(:length)//''' '//arguments, exit_status, output, errors)
   end subroutine run_program

   !> Run any command.
   subroutine run_command(command, exit_status, output, errors)
      character(*), intent(in) :: command
      integer, intent(out) :: exit_status
      character(:), allocatable, intent(out) :: output, errors

      call execute_command_line('{ '//command//'; } > program_output.txt 2> program_errors.txt', exitstat=exit_status)
      output = content_of('program_output.txt')
      errors = content_of('program_errors.txt')
   end subroutine run_command

   !> Write a file for the program.
   subroutine write_input(path, text)
      character(*), intent(in) :: path, text
      integer :: unit

      open (newunit=unit, file=path, access='stream', form='unformatted', status='replace', action='write')
      write (unit) text
      close (unit)
   end subroutine write_input

   !> A whole file.
   function content_of(path) result(text)
      character(*), intent(in) :: path
      character(:), allocatable :: text
      integer :: unit, length

      open (newunit=unit, file=path, access='stream', form='unformatted', status='old', action='read')
      inquire (unit=unit, size=length)
      allocate (character(length) :: text)
      if (length > 0) read (unit) text
      close (unit, status='delete')
   end function content_of

   !> Number of line ends.
   pure integer function count_lines(text)
      character(*), intent(in) :: text
      integer :: i

      count_lines = 0
      do i = 1, len(text)
         if (text(i:i) == achar(10)) count_lines = count_lines + 1
      end do
   end function count_lines

   !> The first line, without its end.
   pure function first_line(text) result(line)
      character(*), intent(in) :: text
      character(:), allocatable :: line

      line = text(:index(text//achar(10), achar(10)) - 1)
   end function first_line

   !> Does a text contain another one?
   pure logical function contains_text(text, part)
      character(*), intent(in) :: text, part

      contains_text = index(text, part) > 0
   end function contains_text

end module shell

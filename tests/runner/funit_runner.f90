! SPDX-License-Identifier: GPL-3.0-or-later
!> Runs tests one after the other and prints what pFUnit prints.
!>
!> Options of a test program: `--verbose` names each test before it starts, `--filter TEXT` runs only
!> the tests whose name contains the text. Exit status: 0 if all passed, else 2.
module funit_runner
   use, intrinsic :: iso_c_binding, only: c_int
   use, intrinsic :: iso_fortran_env, only: error_unit, int64, output_unit
   use adfric_system_program_end, only: end_program
   use funit_exceptions, only: anyExceptions, failure_t, take_failures
   implicit none (type, external)
   private
   public :: start_tests, run_test, finish_tests

   !> Dots on a line.
   integer, parameter :: line_width = 80

   abstract interface
      !> A test, or what is to be done before or after each one.
      subroutine procedure_i()
         implicit none (type, external)
      end subroutine procedure_i
   end interface

   ! One run at a time per program, so its state is kept here.
   integer(int64) :: start_count
   integer :: run_count, failure_count, column
   logical :: is_verbose
   character(len=:), allocatable :: filter, report

contains

   !> Read the options and begin to count.
   subroutine start_tests()
      run_count = 0
      failure_count = 0
      column = 0
      report = ''
      call read_options()
      call system_clock(start_count)
   end subroutine start_tests

   !> Run one test; a failure before it skips it and what comes after.
   subroutine run_test(name, test, before, after)
      !> Suite and test, joined by a dot.
      character(len=*), intent(in) :: name
      procedure(procedure_i) :: test
      procedure(procedure_i), optional :: before, after

      if (index(name, filter) == 0) return
      if (is_verbose) write (output_unit, '(/a)') 'Start: <'//name//'>'
      call print_mark('.')
      run_count = run_count + 1
      if (present(before)) call before()
      if (.not. anyExceptions()) then
         call test()
         if (present(after)) call after()
      end if
      if (anyExceptions()) call note_failures(name)
   end subroutine run_test

   !> Print the failures and the counts; stop with status 2 if there was a failure.
   subroutine finish_tests()
      integer(int64) :: now, rate

      call system_clock(now, rate)
      write (output_unit, '(/a, f12.3, a/)') 'Time: ', real(now - start_count)/real(rate), ' seconds'
      if (failure_count == 0) then
         write (output_unit, '(a/a, i0, a)') ' OK', ' (', run_count, trim(merge(' test) ', ' tests)', run_count == 1))
      else
         write (output_unit, '(a)') report//' FAILURES!!!'
         write (output_unit, '(a, i0, a, i0, a)') 'Tests run: ', run_count, ', Failures: ', failure_count, &
            ', Errors: 0'
         write (output_unit, '(a)') '*** Encountered 1 or more failures/errors during testing ***'
         flush (output_unit)
         call end_program(2_c_int)
      end if
   end subroutine finish_tests

   !> Add the failures of the test that just ran to the report.
   subroutine note_failures(name)
      character(len=*), intent(in) :: name

      type(failure_t), allocatable :: failures(:)
      character(len=12) :: line
      integer :: i

      call print_mark('F')
      failure_count = failure_count + 1
      call take_failures(failures)
      do i = 1, size(failures)
         write (line, '(i0)') failures(i)%location%line
         report = report//'Failure'//new_line('a')//' in: '//new_line('a')//name//new_line('a') &
            //'  Location: '//new_line('a')//'['//trim(failures(i)%location%file)//':'//trim(line)//']' &
            //new_line('a')//failures(i)%message//new_line('a')//new_line('a')
      end do
   end subroutine note_failures

   !> Written at once, so that it is seen even if the test ends the program.
   subroutine print_mark(mark)
      character(len=1), intent(in) :: mark

      write (output_unit, '(a)', advance='no') mark
      column = column + 1
      if (column == line_width) then
         write (output_unit, '()')
         column = 0
      end if
      flush (output_unit)
   end subroutine print_mark

   subroutine read_options()
      character(len=1000) :: argument
      integer :: i

      is_verbose = .false.
      filter = ''
      i = 1
      do while (i <= command_argument_count())
         call get_command_argument(i, argument)
         select case (argument)
         case ('-v', '--verbose')
            is_verbose = .true.
         case ('-f', '--filter')
            i = i + 1
            call get_command_argument(i, argument)
            filter = trim(argument)
         case default
            write (error_unit, '(a)') 'unknown option '//trim(argument)//'; known: --verbose, --filter TEXT'
            call end_program(2_c_int)
         end select
         i = i + 1
      end do
   end subroutine read_options

end module funit_runner

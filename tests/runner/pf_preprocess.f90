! SPDX-License-Identifier: GPL-3.0-or-later
!> Translates a pFUnit test file into Fortran: pf_preprocess FILE.pf FILE.F90
!>
!> Exit status 1 and a line `FILE.pf:line: error: ...` if the file holds anything this runner does not know.
program pf_preprocess
   use, intrinsic :: iso_c_binding, only: c_int
   use, intrinsic :: iso_fortran_env, only: error_unit, iostat_end
   use adfric_system_program_end, only: end_program
   use pf_translate, only: finish_file, new_test_file, test_file_t, translate_line
   implicit none (type, external)

   type(test_file_t) :: file
   character(len=4096) :: source, target
   character(len=512) :: line, reason
   character(len=:), allocatable, save :: problem
   integer :: input, output, status

   if (command_argument_count() /= 2) error stop 'usage: pf_preprocess FILE.pf FILE.F90'
   call get_command_argument(1, source)
   call get_command_argument(2, target)
   open (newunit=input, file=trim(source), action='read', status='old')
   open (newunit=output, file=trim(target), action='write', status='replace')

   call new_test_file(file, trim(source), output)
   lines: do
      read (input, '(a)', iostat=status, iomsg=reason) line
      if (status == 0) then
         call translate_line(file, line, problem)
      else if (status == iostat_end) then
         call finish_file(file, problem)
      else
         problem = trim(reason)
      end if
      if (problem /= '' .or. status /= 0) exit lines
   end do lines
   close (input)

   if (problem /= '') then
      close (output, status='delete')
      write (error_unit, '(a, i0, a)') trim(source)//':', file%line, ': error: '//problem
      call end_program(1_c_int)
   end if
   close (output)
end program pf_preprocess

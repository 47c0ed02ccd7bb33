! SPDX-License-Identifier: GPL-3.0-or-later
!> Output and errors of a command, written when the command has ended.
module adfric_driver_last_words
   use, intrinsic :: iso_c_binding, only: c_char, c_int, c_size_t
   use adfric_base_error, only: error_t, set_error, file_failure
   use adfric_command_outcome, only: outcome_t
   use adfric_system_files, only: error_text
   implicit none (type, external)
   private
   public :: write_outcome

   interface
      !> Write a text; 0 or an error number, which Fortran's own output would not give. See `last_resort.c`.
      integer(c_int) function write_text(file, text, length) bind(c, name='adfric_write_text')
         import :: c_char, c_int, c_size_t
         implicit none (type, external)
         !> Descriptor of the file.
         integer(c_int), intent(in), value :: file
         !> The text.
         character(kind=c_char), intent(in) :: text(*)
         !> Length of the text [bytes].
         integer(c_size_t), intent(in), value :: length
      end function write_text
   end interface

contains

   !> Write the output and the errors of a command. Output that cannot be written is a failure, too.
   subroutine write_outcome(outcome)
      !> Outcome of the command; it becomes a failure if its output is lost.
      type(outcome_t), intent(inout) :: outcome
      integer(c_int), parameter :: standard_output = 1, standard_error = 2
      type(error_t), allocatable :: error
      integer(c_int) :: number

      number = 0
      if (allocated(outcome%output)) number = write_text(standard_output, outcome%output, len(outcome%output, kind=c_size_t))
      if (number /= 0) then
         call set_error(error, file_failure, 'adfric: cannot write to the standard output: '//error_text(number))
         call outcome%fail(error)
      end if
      ! there is nobody to tell where this fails
      if (allocated(outcome%errors)) number = write_text(standard_error, outcome%errors, len(outcome%errors, kind=c_size_t))
   end subroutine write_outcome

end module adfric_driver_last_words

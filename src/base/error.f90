! SPDX-License-Identifier: GPL-3.0-or-later
!> Errors of input, files and library calls.
!>
!> A procedure that can fail has `type(error_t), allocatable, intent(out) :: error` as its last
!> argument; it is allocated if and only if the procedure failed.
module adfric_base_error
   implicit none (type, external)
   private
   public :: error_t, set_error, input_failure, file_failure

   !> Bad command line or input; also the exit status of the program.
   integer, parameter :: input_failure = 2
   !> A file that cannot be read or written, or a machine that has too little for the run; also the exit status of the program.
   integer, parameter :: file_failure = 3

   !> What went wrong.
   type :: error_t
      !> `input_failure` or `file_failure`.
      integer :: code = input_failure
      !> One line: where, what, what was given, what is allowed.
      character(:), allocatable :: message
   end type error_t

contains

   !> Raise an error.
   pure subroutine set_error(error, code, message)
      !> Receives the code and the message; it is always allocated at the end.
      type(error_t), allocatable, intent(out) :: error
      !> `input_failure` or `file_failure`.
      integer, intent(in) :: code
      !> One line: where, what, what was given, what is allowed.
      character(*), intent(in) :: message

      allocate (error)
      error%code = code
      error%message = message
   end subroutine set_error

end module adfric_base_error

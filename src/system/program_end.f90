! SPDX-License-Identifier: GPL-3.0-or-later
!> The end of a program with an exit status and without a word. `stop` says which floating-point exceptions were met, and
!> its `quiet=` came with gfortran 12.
module adfric_system_program_end
   implicit none (type, external)
   private
   public :: end_program

   interface

      !> End the program; Fortran's files are closed.
      subroutine end_program(status) bind(c, name='exit')
         use, intrinsic :: iso_c_binding, only: c_int
         implicit none (type, external)
         !> Exit status, 0 to 255.
         integer(c_int), value :: status
      end subroutine end_program

   end interface

end module adfric_system_program_end

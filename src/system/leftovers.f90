! SPDX-License-Identifier: GPL-3.0-or-later
!> Files that are of no use if the program ends now, as where memory is exhausted; the main program removes them then.
module adfric_system_leftovers
   use, intrinsic :: iso_c_binding, only: c_char, c_null_char
   implicit none (type, external)
   private
   public :: note_leftover, forget_leftover, note_kept, begin_making, end_making

   interface

      !> A file is about to be made that is of no use at first. If the program ends in another thread now, that thread waits for
      !> the file, but not for ever.
      subroutine begin_making() bind(c, name='adfric_begin_making')
         implicit none (type, external)
      end subroutine begin_making

      !> The file that was about to be made is there.
      subroutine end_making() bind(c, name='adfric_end_making')
         implicit none (type, external)
      end subroutine end_making

      !> Note a file that is to be removed when the program dies.
      subroutine c_note_leftover(path) bind(c, name='adfric_note_leftover')
         import :: c_char
         implicit none (type, external)
         !> Name of the file, with a null character at its end.
         character(kind=c_char), intent(in) :: path(*)
      end subroutine c_note_leftover

      !> The file is to stay, or is gone.
      subroutine c_forget_leftover(path) bind(c, name='adfric_forget_leftover')
         import :: c_char
         implicit none (type, external)
         !> Name of the file, with a null character at its end.
         character(kind=c_char), intent(in) :: path(*)
      end subroutine c_forget_leftover

      !> Note a file with results, which the last words of a dying program name.
      subroutine c_note_kept(path) bind(c, name='adfric_note_kept')
         import :: c_char
         implicit none (type, external)
         !> Name of the file, with a null character at its end; empty: there is none any more.
         character(kind=c_char), intent(in) :: path(*)
      end subroutine c_note_kept

   end interface

contains

   !> Note a file that is of no use if the program ends now.
   subroutine note_leftover(path)
      !> Name of the file.
      character(*), intent(in) :: path

      call c_note_leftover(path//c_null_char)
   end subroutine note_leftover

   !> Forget a file that was noted: it is gone, or is of use now.
   subroutine forget_leftover(path)
      !> Name of the file.
      character(*), intent(in) :: path

      call c_forget_leftover(path//c_null_char)
   end subroutine forget_leftover

   !> Note the file whose results stay if the program ends now.
   subroutine note_kept(path)
      !> Name of the file; empty: there is none any more.
      character(*), intent(in) :: path

      call c_note_kept(path//c_null_char)
   end subroutine note_kept

end module adfric_system_leftovers

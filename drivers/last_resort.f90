! SPDX-License-Identifier: GPL-3.0-or-later
!> What happens where memory is exhausted, or a library ends the program: see `last_resort.c`.
module adfric_driver_last_resort
   implicit none (type, external)
   private
   public :: begin_watch, end_watch

   interface

      !> From now on the program ends with status 3 and leaves nothing of no use, whoever ends it. To be called first.
      subroutine begin_watch() bind(c, name='adfric_begin_watch')
         implicit none (type, external)
      end subroutine begin_watch

      !> From now on the program ends in order. To be called last.
      subroutine end_watch() bind(c, name='adfric_end_watch')
         implicit none (type, external)
      end subroutine end_watch

   end interface

end module adfric_driver_last_resort

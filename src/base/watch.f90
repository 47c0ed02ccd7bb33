! SPDX-License-Identifier: GPL-3.0-or-later
!> Whoever may end a solution before its time, as a loop that takes long sees him.
module adfric_base_watch
   implicit none (type, external)
   private
   public :: watch_t, asks_for_end

   !> Someone who may want the work to end. Every thread asks, often and at once.
   type, abstract :: watch_t
   contains
      procedure(wants_end_i), deferred :: wants_end
   end type watch_t

   abstract interface
      !> Shall the work end before its time? What has been found so far is of no use then.
      logical function wants_end_i(self)
         import :: watch_t
         implicit none (type, external)
         !> Who is asked.
         class(watch_t), intent(in) :: self
      end function wants_end_i
   end interface

contains

   !> Shall the work end before its time? Not where nobody is to be asked.
   logical function asks_for_end(watch)
      !> Who is asked; null: nobody.
      class(watch_t), pointer, intent(in) :: watch

      asks_for_end = .false.
      if (associated(watch)) asks_for_end = watch%wants_end()
   end function asks_for_end

end module adfric_base_watch

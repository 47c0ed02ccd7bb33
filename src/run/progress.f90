! SPDX-License-Identifier: GPL-3.0-or-later
!> Who is told how far a sweep is, and may end it.
module adfric_run_progress
   use adfric_base_kinds, only: i8
   use adfric_base_watch, only: watch_t
   implicit none (type, external)
   private
   public :: progress_t, silent_progress_t

   !> A listener. It is called often, always by the same thread, and decides itself what it shows.
   type, abstract, extends(watch_t) :: progress_t
   contains
      procedure(report_i), deferred :: report
      procedure :: wants_end
   end type progress_t

   !> A listener that shows nothing.
   type, extends(progress_t) :: silent_progress_t
   contains
      procedure :: report => report_nothing
   end type silent_progress_t

   abstract interface
      !> Take note of the points solved so far.
      subroutine report_i(self, n_done, n_total)
         import :: progress_t, i8
         implicit none (type, external)
         !> The listener, which may remember what it was told.
         class(progress_t), intent(inout) :: self
         !> Number of points solved so far, also before this run and in other processes.
         integer(i8), intent(in) :: n_done
         !> Number of points of the run, or of the part of it that is solved.
         integer(i8), intent(in) :: n_total
      end subroutine report_i
   end interface

contains

   !> Shall the run end before its time? Every thread asks, often and at once. Here it shall not.
   logical function wants_end(self)
      class(progress_t), intent(in) :: self

      wants_end = .false.
      associate (unused => self)
      end associate
   end function wants_end

   !> Show nothing.
   subroutine report_nothing(self, n_done, n_total)
      class(silent_progress_t), intent(inout) :: self
      !> Number of points solved so far, also before this run and in other processes.
      integer(i8), intent(in) :: n_done
      !> Number of points of the run, or of the part of it that is solved.
      integer(i8), intent(in) :: n_total

      associate (unused => self, unused_too => n_done + n_total)
      end associate
   end subroutine report_nothing

end module adfric_run_progress

! SPDX-License-Identifier: GPL-3.0-or-later
!> How a call that solves is watched and stopped from C.
module adfric_c_listener
   use, intrinsic :: iso_c_binding, only: c_associated, c_f_procpointer, c_funptr, c_int, c_int64_t, c_null_ptr, c_ptr
   use adfric_base_kinds, only: dp, i8
   use adfric_c_handles, only: ask_to_stop, is_due, shall_stop
   use adfric_run_progress, only: progress_t
   use adfric_system_clock, only: wall_clock
   implicit none (type, external)
   private
   public :: listener_t, new_listener

   !> Least time between two calls of the caller's function [s].
   real(dp), parameter :: least_interval = 0.05_dp

   abstract interface
      !> `adfric_progress` of adfric.h.
      integer(c_int) function progress_i(context, n_done, n_points) bind(c)
         import :: c_int, c_int64_t, c_ptr
         implicit none (type, external)
         !> What the caller gave for it.
         type(c_ptr), intent(in), value :: context
         !> Number of points that are solved.
         integer(c_int64_t), intent(in), value :: n_done
         !> Number of all points.
         integer(c_int64_t), intent(in), value :: n_points
      end function progress_i
   end interface

   !> Tells the caller how far a call is, and knows whether it shall stop.
   type, extends(progress_t) :: listener_t
      !> Handle of the case that is solved.
      integer(c_int64_t) :: handle = 0
      !> Function of the caller; none if null.
      procedure(progress_i), pointer, nopass :: tell => null()
      !> What the caller gave for it.
      type(c_ptr) :: context = c_null_ptr
      !> What the caller was told last: number of points that are solved, and of all.
      integer(i8) :: n_done = 0, n_total = 0
      !> When the function was called last [s].
      real(dp) :: told_at = -1
   contains
      procedure :: report
      procedure :: wants_end
   end type listener_t

contains

   !> Watch a call.
   subroutine new_listener(self, handle, progress, context)
      !> Receives the listener.
      type(listener_t), intent(out) :: self
      !> Handle of the case that is solved.
      integer(c_int64_t), intent(in) :: handle
      !> Function of the caller, or null.
      type(c_funptr), intent(in) :: progress
      !> What is handed to it.
      type(c_ptr), intent(in) :: context

      self%handle = handle
      self%context = context
      if (c_associated(progress)) call c_f_procpointer(progress, self%tell)
   end subroutine new_listener

   !> See `progress_t`.
   subroutine report(self, n_done, n_total)
      class(listener_t), intent(inout) :: self
      !> Number of points that are solved.
      integer(i8), intent(in) :: n_done
      integer(i8), intent(in) :: n_total
      real(dp) :: now

      self%n_done = n_done
      self%n_total = n_total
      if (.not. associated(self%tell)) return
      now = wall_clock()
      if (self%told_at >= 0 .and. now - self%told_at < least_interval .and. n_done < n_total) return
      self%told_at = now
      call tell_caller(self)
   end subroutine report

   !> Tell the caller how far the call is; what he answers may stop it.
   subroutine tell_caller(self)
      !> The listener, with a function of the caller.
      class(listener_t), intent(in) :: self
      integer(c_int) :: unused

      if (self%tell(self%context, self%n_done, self%n_total) /= 0) unused = ask_to_stop(self%handle)
   end subroutine tell_caller

   !> See `progress_t`: the thread that calls hears the caller meanwhile, who is told nothing new.
   logical function wants_end(self)
      !> The listener.
      class(listener_t), intent(in) :: self

      wants_end = shall_stop(self%handle) /= 0
      if (wants_end .or. .not. associated(self%tell)) return
      if (is_due(self%handle) == 0) return
      call tell_caller(self)
      wants_end = shall_stop(self%handle) /= 0
   end function wants_end

end module adfric_c_listener

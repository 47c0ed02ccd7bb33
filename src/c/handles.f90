! SPDX-License-Identifier: GPL-3.0-or-later
!> The handles of the C interface: numbers that stand for objects, checked whenever they are used.
module adfric_c_handles
   use, intrinsic :: iso_c_binding, only: c_int, c_int64_t, c_ptr
   use adfric_base_error, only: error_t, file_failure, input_failure, set_error
   implicit none (type, external)
   private
   public :: kind_case, kind_results, add_handle, take_object, leave_object, end_handle, let_stop, shall_stop, ask_to_stop, is_due

   !> Kinds of objects, as in handles.c.
   integer(c_int), parameter :: kind_case = 0, kind_results = 1
   !> What a handle is good for, as in handles.c.
   integer(c_int), parameter :: handle_good = 0, handle_unknown = 1, handle_closed = 2, handle_of_other_kind = 3
   !> Words for the kinds, and how an object of each is come by.
   character(*), parameter :: words(0:1) = ['case   ', 'results'], sources(0:1) = [character(26) :: &
      & 'adfric_open or adfric_read', 'adfric_solve']

   interface

      !> A new handle of an object; 0 if there is no memory for it.
      integer(c_int64_t) function c_new(kind, object) bind(c, name='adfric_new_handle')
         import :: c_int, c_int64_t, c_ptr
         implicit none (type, external)
         !> One of `kind_...`.
         integer(c_int), intent(in), value :: kind
         !> Index of the object.
         type(c_ptr), intent(in), value :: object
      end function c_new

      !> Begin to use an object; one of `handle_...`.
      integer(c_int) function c_take(handle, kind, is_alone, object) bind(c, name='adfric_take_object')
         import :: c_int, c_int64_t, c_ptr
         implicit none (type, external)
         !> Any number.
         integer(c_int64_t), intent(in), value :: handle
         !> One of `kind_...`.
         integer(c_int), intent(in), value :: kind
         !> 1: no other thread may use it at the same time; 0: others may that do so, too.
         integer(c_int), intent(in), value :: is_alone
         !> Receives the index of the object; null if the handle is not good.
         type(c_ptr), intent(out) :: object
      end function c_take

      !> End the use of an object.
      subroutine leave_object(handle) bind(c, name='adfric_leave_object')
         import :: c_int64_t
         implicit none (type, external)
         !> The handle by which it was taken.
         integer(c_int64_t), intent(in), value :: handle
      end subroutine leave_object

      !> Close the handle of an object that was taken alone.
      subroutine end_handle(handle) bind(c, name='adfric_end_handle')
         import :: c_int64_t
         implicit none (type, external)
         !> The handle by which it was taken.
         integer(c_int64_t), intent(in), value :: handle
      end subroutine end_handle

      !> Say whether `adfric_stop` may stop the work on an object that was taken. It has not been asked to stop then.
      subroutine let_stop(handle, may) bind(c, name='adfric_let_stop')
         import :: c_int, c_int64_t
         implicit none (type, external)
         !> The handle by which it was taken.
         integer(c_int64_t), intent(in), value :: handle
         !> 1: it may; 0: it may not.
         integer(c_int), intent(in), value :: may
      end subroutine let_stop

      !> See adfric.h.
      integer(c_int) function ask_to_stop(handle) bind(c, name='adfric_stop')
         import :: c_int, c_int64_t
         implicit none (type, external)
         !> Any number.
         integer(c_int64_t), intent(in), value :: handle
      end function ask_to_stop

      !> Shall the work on an object that was taken stop? 0: it shall go on.
      integer(c_int) function shall_stop(handle) bind(c, name='adfric_shall_stop')
         import :: c_int, c_int64_t
         implicit none (type, external)
         !> The handle by which it was taken.
         integer(c_int64_t), intent(in), value :: handle
      end function shall_stop

      !> Is it this thread that has called for the work on an object, and was this not asked for a while? 1: it is so.
      integer(c_int) function is_due(handle) bind(c, name='adfric_is_due')
         import :: c_int, c_int64_t
         implicit none (type, external)
         !> The handle by which it was taken.
         integer(c_int64_t), intent(in), value :: handle
      end function is_due

   end interface

contains

   !> Give an object a handle.
   subroutine add_handle(kind, object, handle, error)
      !> One of `kind_...`.
      integer(c_int), intent(in) :: kind
      !> Index of the object, which stays where it is.
      type(c_ptr), intent(in) :: object
      !> Receives the handle; left as it is if there is an error.
      integer(c_int64_t), intent(inout) :: handle
      !> Allocated if there is no memory for one more.
      type(error_t), allocatable, intent(out) :: error
      integer(c_int64_t) :: added

      added = c_new(kind, object)
      if (added > 0) then
         handle = added
      else
         call set_error(error, file_failure, 'there is too little memory for one more '//trim(words(kind)))
      end if
   end subroutine add_handle

   !> Begin to use an object, or say why it cannot be used.
   subroutine take_object(handle, kind, is_alone, object, error)
      !> Any number.
      integer(c_int64_t), intent(in) :: handle
      !> One of `kind_...`.
      integer(c_int), intent(in) :: kind
      !> May no other thread use it at the same time?
      logical, intent(in) :: is_alone
      !> Receives the index of the object; `leave_object` or `end_handle` ends its use.
      type(c_ptr), intent(out) :: object
      !> Allocated if the handle is not good; there is nothing to be left then.
      type(error_t), allocatable, intent(out) :: error
      integer(c_int) :: what
      character(20) :: number

      what = c_take(handle, kind, merge(1_c_int, 0_c_int, is_alone), object)
      if (what == handle_good) return
      write (number, '(i0)') handle
      select case (what)
      case (handle_unknown)
         call set_error(error, input_failure, 'unknown '//trim(words(kind))//', given '//trim(number)//', allowed: what '// &
            & trim(sources(kind))//' gave')
      case (handle_closed)
         call set_error(error, input_failure, 'closed '//trim(words(kind))//', given '//trim(number)//', allowed: what '// &
            & trim(sources(kind))//' gave, until it is closed')
      case (handle_of_other_kind)
         call set_error(error, input_failure, 'is no '//trim(words(kind))//', given '//trim(words(1 - kind))//', allowed: what '// &
            & trim(sources(kind))//' gave')
      case default
         call set_error(error, input_failure, 'another thread uses the '//trim(words(kind))// &
            & ' at the moment, allowed: one thread at a time')
      end select
   end subroutine take_object

end module adfric_c_handles

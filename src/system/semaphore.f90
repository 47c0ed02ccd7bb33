! SPDX-License-Identifier: GPL-3.0-or-later
!> A counting semaphore: threads sleep until another one wakes them, where OpenMP would let them run in circles.
module adfric_system_semaphore
   use, intrinsic :: iso_c_binding, only: c_ptr, c_long, c_null_ptr, c_associated
   implicit none (type, external)
   private
   public :: semaphore_t

   !> A count that threads raise, and that others wait for when it is 0.
   type :: semaphore_t
      !> The semaphore of the system; null where there is none.
      type(c_ptr), private :: handle = c_null_ptr
   contains
      procedure :: make
      procedure :: post
      procedure :: wait => wait_for_post
      procedure :: free
   end type semaphore_t

   interface

      !> A new semaphore; null if the system has no space for one.
      type(c_ptr) function c_new(count) bind(c, name='adfric_new_semaphore')
         import :: c_ptr, c_long
         implicit none (type, external)
         !> Count that the semaphore begins with, >= 0.
         integer(c_long), intent(in), value :: count
      end function c_new

      !> Give a semaphore back to the system.
      subroutine c_free(handle) bind(c, name='adfric_free_semaphore')
         import :: c_ptr
         implicit none (type, external)
         !> A semaphore that was made by `c_new`; it is gone afterwards.
         type(c_ptr), intent(in), value :: handle
      end subroutine c_free

      !> Add one to the count, and wake a thread that waits for it.
      subroutine c_post(handle) bind(c, name='adfric_post_semaphore')
         import :: c_ptr
         implicit none (type, external)
         !> A semaphore that was made by `c_new`.
         type(c_ptr), intent(in), value :: handle
      end subroutine c_post

      !> Sleep until the count is not 0, and take one from it.
      subroutine c_wait(handle) bind(c, name='adfric_wait_semaphore')
         import :: c_ptr
         implicit none (type, external)
         !> A semaphore that was made by `c_new`.
         type(c_ptr), intent(in), value :: handle
      end subroutine c_wait

   end interface

contains

   !> Make the semaphore.
   subroutine make(self, count, is_made)
      class(semaphore_t), intent(inout) :: self
      !> Count that the semaphore begins with, >= 0.
      integer, intent(in) :: count
      !> False if the system has no space for a semaphore.
      logical, intent(out) :: is_made

      self%handle = c_new(int(count, c_long))
      is_made = c_associated(self%handle)
   end subroutine make

   !> Add one to the count, and wake a thread that waits for it.
   subroutine post(self)
      class(semaphore_t), intent(in) :: self

      call c_post(self%handle)
   end subroutine post

   !> Sleep until the count is not 0, and take one from it.
   subroutine wait_for_post(self)
      class(semaphore_t), intent(in) :: self

      call c_wait(self%handle)
   end subroutine wait_for_post

   !> Give back what it takes; nobody may use it any more.
   subroutine free(self)
      !> The semaphore; it may never have been made, and is gone afterwards.
      class(semaphore_t), intent(inout) :: self

      if (c_associated(self%handle)) call c_free(self%handle)
      self%handle = c_null_ptr
   end subroutine free

end module adfric_system_semaphore

! SPDX-License-Identifier: GPL-3.0-or-later
!> A lock that one thread holds while it does what others wait for.
module adfric_numerics_thread_lock
   use omp_lib, only: omp_destroy_lock, omp_init_lock, omp_lock_kind, omp_set_lock, omp_unset_lock
   implicit none (type, external)
   private
   public :: thread_lock_t

   !> A lock, held by nobody at first.
   type :: thread_lock_t
      private
      !> The lock of OpenMP.
      integer(omp_lock_kind) :: lock = 0
      !> Is there one?
      logical :: is_made = .false.
   contains
      procedure :: acquire
      procedure :: release
      procedure :: wait_for
      procedure :: destroy
   end type thread_lock_t

contains

   !> Hold the lock, once nobody else does. Calls of several threads come one after the other, since the first one makes the lock.
   subroutine acquire(self)
      class(thread_lock_t), intent(inout) :: self

      if (.not. self%is_made) call omp_init_lock(self%lock)
      self%is_made = .true.
      call omp_set_lock(self%lock)
   end subroutine acquire

   !> Give back the lock, by the thread that holds it.
   subroutine release(self)
      class(thread_lock_t), intent(inout) :: self

      call omp_unset_lock(self%lock)
   end subroutine release

   !> Wait until nobody holds a lock that has been held before; any number of threads may.
   subroutine wait_for(self)
      class(thread_lock_t), intent(inout) :: self

      call omp_set_lock(self%lock)
      call omp_unset_lock(self%lock)
   end subroutine wait_for

   !> Give back what OpenMP has for the lock. (gfortran 12 ends in a fault where it finalizes an array in a type, so this is called.)
   subroutine destroy(self)
      class(thread_lock_t), intent(inout) :: self

      if (self%is_made) call omp_destroy_lock(self%lock)
      self%is_made = .false.
   end subroutine destroy

end module adfric_numerics_thread_lock

!> What OpenMP lacks.
module adfric_sweep_threads
   use, intrinsic :: iso_c_binding, only: c_int
   implicit none (type, external)
   private
   public :: let_others_run

   interface
      integer(c_int) function sched_yield() bind(c, name='sched_yield')
         import :: c_int
         implicit none (type, external)
      end function sched_yield
   end interface

contains

   !> Let other threads have the core of this one, which has nothing to do now.
   subroutine let_others_run()
      integer(c_int) :: status

      ! It has no way to fail.
      status = sched_yield()
      associate (unused => status)
      end associate
   end subroutine let_others_run

end module adfric_sweep_threads

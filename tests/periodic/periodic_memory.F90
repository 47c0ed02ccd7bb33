! Where there is no memory for a transform, the point says so: it is not one that did not converge.
module periodic_memory
   use adfric_base_kinds, only: dp
   use adfric_model_status, only: status_out_of_memory, status_solved
   use refused_memory, only: refuse_memory
   use trial_case, only: trial_case_t, new_case
   use funit
   implicit none (type, external)

contains

   !@after
   subroutine grant_memory()
      call refuse_memory(after=huge(1))
   end subroutine grant_memory

   ! Each of the transforms of a point is refused in turn.
   !@test
   subroutine test_no_memory()
      type(trial_case_t) :: case
      integer :: i

      call new_case(case, 'wave_2d_elastic')
      call case%give('period', 1.0e-5_dp)
      call case%give('amplitude', 1.0e-7_dp)
      call case%give('contact_modulus', 1.0e9_dp)
      call case%give('cells', 64.0_dp)
      call case%give('mean_pressure', 1.0e6_dp)
#line 29 "/work/wt/penetration/tests/periodic/periodic_memory.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'periodic_memory.pf', &
 & 29) )
  if (anyExceptions()) return
#line 30 "/work/wt/penetration/tests/periodic/periodic_memory.pf"
      do i = 0, 10
         call refuse_memory(after=i)
         call case%solve()
         if (case%status(1) /= status_out_of_memory) exit
      end do
#line 35 "/work/wt/penetration/tests/periodic/periodic_memory.pf"
  call assertGreaterThan(i, 0, &
 & location=SourceLocation( &
 & 'periodic_memory.pf', &
 & 35) )
  if (anyExceptions()) return
#line 36 "/work/wt/penetration/tests/periodic/periodic_memory.pf"
#line 36 "/work/wt/penetration/tests/periodic/periodic_memory.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'periodic_memory.pf', &
 & 36) )
  if (anyExceptions()) return
#line 37 "/work/wt/penetration/tests/periodic/periodic_memory.pf"
   end subroutine test_no_memory

end module periodic_memory

module Wrapperiodic_memory
   use FUnit
   use periodic_memory
   implicit none
   private

contains


end module Wrapperiodic_memory

function periodic_memory_suite() result(suite)
   use FUnit
   use periodic_memory
   use Wrapperiodic_memory
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('periodic_memory_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_no_memory', &
      test_no_memory, tearDown=grant_memory))
   call suite%addTest(t)


end function periodic_memory_suite


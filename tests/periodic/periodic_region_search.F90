! When the open region is changed, and that the search becomes strict where it does not get on.
module periodic_region_search
   use adfric_base_kinds, only: dp
   use adfric_periodic_region_search, only: region_search_t, verdict_t, new_region_search
   use funit
   implicit none (type, external)

   integer, parameter :: patience = 3

contains

   ! Less pressure must be left than a part of the violation; that part becomes smaller, then nothing but an exact gap will do, and
   ! at last cells are changed one by one.
   !@test
   subroutine test_stages()
      real(dp), parameter :: aim = 1.0e-8_dp, least(4) = [0.1_dp, 0.01_dp, 0.001_dp, 1.0e-4_dp]
      type(region_search_t) :: search
      integer :: stage, k

      call new_region_search(search, patience)
      call search%get_stricter(100)
      do stage = 1, size(least)
#line 23 "/work/wt/penetration/tests/periodic/periodic_region_search.pf"
  call assertFalse(search%is_one_by_one, &
 & location=SourceLocation( &
 & 'periodic_region_search.pf', &
 & 23) )
  if (anyExceptions()) return
#line 24 "/work/wt/penetration/tests/periodic/periodic_region_search.pf"
#line 24 "/work/wt/penetration/tests/periodic/periodic_region_search.pf"
  call assertTrue(search%is_due(verdict_t(left=least(stage), violation=1.0_dp), aim), &
 & location=SourceLocation( &
 & 'periodic_region_search.pf', &
 & 24) )
  if (anyExceptions()) return
#line 25 "/work/wt/penetration/tests/periodic/periodic_region_search.pf"
#line 25 "/work/wt/penetration/tests/periodic/periodic_region_search.pf"
  call assertFalse(search%is_due(verdict_t(left=10*least(stage), violation=1.0_dp), aim), &
 & location=SourceLocation( &
 & 'periodic_region_search.pf', &
 & 25) )
  if (anyExceptions()) return
#line 26 "/work/wt/penetration/tests/periodic/periodic_region_search.pf"
         do k = 0, patience
            call search%get_stricter(100)
         end do
      end do
#line 30 "/work/wt/penetration/tests/periodic/periodic_region_search.pf"
  call assertFalse(search%is_one_by_one, &
 & location=SourceLocation( &
 & 'periodic_region_search.pf', &
 & 30) )
  if (anyExceptions()) return
#line 31 "/work/wt/penetration/tests/periodic/periodic_region_search.pf"
#line 31 "/work/wt/penetration/tests/periodic/periodic_region_search.pf"
  call assertFalse(search%is_due(verdict_t(left=2*aim, violation=1.0_dp), aim), &
 & location=SourceLocation( &
 & 'periodic_region_search.pf', &
 & 31) )
  if (anyExceptions()) return
#line 32 "/work/wt/penetration/tests/periodic/periodic_region_search.pf"
#line 32 "/work/wt/penetration/tests/periodic/periodic_region_search.pf"
  call assertTrue(search%is_due(verdict_t(left=aim, violation=1.0_dp), aim), &
 & location=SourceLocation( &
 & 'periodic_region_search.pf', &
 & 32) )
  if (anyExceptions()) return
#line 33 "/work/wt/penetration/tests/periodic/periodic_region_search.pf"
      do k = 0, patience
         call search%get_stricter(100)
      end do
#line 36 "/work/wt/penetration/tests/periodic/periodic_region_search.pf"
  call assertTrue(search%is_one_by_one, &
 & location=SourceLocation( &
 & 'periodic_region_search.pf', &
 & 36) )
  if (anyExceptions()) return
#line 37 "/work/wt/penetration/tests/periodic/periodic_region_search.pf"
      call search%get_stricter(100)
#line 38 "/work/wt/penetration/tests/periodic/periodic_region_search.pf"
  call assertTrue(search%is_one_by_one, &
 & location=SourceLocation( &
 & 'periodic_region_search.pf', &
 & 38) )
  if (anyExceptions()) return
#line 39 "/work/wt/penetration/tests/periodic/periodic_region_search.pf"
      call search%get_stricter(99)
#line 40 "/work/wt/penetration/tests/periodic/periodic_region_search.pf"
  call assertFalse(search%is_one_by_one, &
 & location=SourceLocation( &
 & 'periodic_region_search.pf', &
 & 40) )
  if (anyExceptions()) return
#line 41 "/work/wt/penetration/tests/periodic/periodic_region_search.pf"
   end subroutine test_stages

   ! Fewer wrong cells each time: it stays as it is.
   !@test
   subroutine test_progress()
      type(region_search_t) :: search
      integer :: n

      call new_region_search(search, patience)
      do n = 50, 1, -1
         call search%get_stricter(n)
      end do
#line 53 "/work/wt/penetration/tests/periodic/periodic_region_search.pf"
  call assertTrue(search%is_due(verdict_t(left=0.25_dp, violation=1.0_dp), 0.0_dp), &
 & location=SourceLocation( &
 & 'periodic_region_search.pf', &
 & 53) )
  if (anyExceptions()) return
#line 54 "/work/wt/penetration/tests/periodic/periodic_region_search.pf"
   end subroutine test_progress

   ! Steps that do not halve what is left for long are of no use; steps that begin anew have their time again.
   !@test
   subroutine test_stall()
      type(region_search_t) :: search
      integer :: k

      call new_region_search(search, patience)
      do k = 1, 200
         call search%note_step(verdict_t(left=0.5_dp**k))
#line 65 "/work/wt/penetration/tests/periodic/periodic_region_search.pf"
  call assertFalse(search%is_stalled(), &
 & location=SourceLocation( &
 & 'periodic_region_search.pf', &
 & 65) )
  if (anyExceptions()) return
#line 66 "/work/wt/penetration/tests/periodic/periodic_region_search.pf"
      end do
      do k = 1, 200
         call search%note_step(verdict_t(left=0.5_dp**200))
      end do
#line 70 "/work/wt/penetration/tests/periodic/periodic_region_search.pf"
  call assertTrue(search%is_stalled(), &
 & location=SourceLocation( &
 & 'periodic_region_search.pf', &
 & 70) )
  if (anyExceptions()) return
#line 71 "/work/wt/penetration/tests/periodic/periodic_region_search.pf"
      call search%note_region()
#line 72 "/work/wt/penetration/tests/periodic/periodic_region_search.pf"
  call assertFalse(search%is_stalled(), &
 & location=SourceLocation( &
 & 'periodic_region_search.pf', &
 & 72) )
  if (anyExceptions()) return
#line 73 "/work/wt/penetration/tests/periodic/periodic_region_search.pf"
   end subroutine test_stall

end module periodic_region_search

module Wrapperiodic_region_search
   use FUnit
   use periodic_region_search
   implicit none
   private

contains


end module Wrapperiodic_region_search

function periodic_region_search_suite() result(suite)
   use FUnit
   use periodic_region_search
   use Wrapperiodic_region_search
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('periodic_region_search_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_stages', &
      test_stages))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_progress', &
      test_progress))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_stall', &
      test_stall))
   call suite%addTest(t)


end function periodic_region_search_suite


! Pull-offs that the points of a run share: each is found once, is what it is alone, and a model asks for it once in a run.
module periodic_pull_off_list
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp
   use adfric_periodic_adhesive_pull_off, only: pull_off_t, find_pull_off
   use adfric_periodic_adhesive_solver, only: periodic_adhesion_t
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_elastic_model, only: elastic_model_t
   use adfric_periodic_pull_off_list, only: pull_off_list_t, get_pull_off
   use adfric_periodic_solver, only: periodic_solver_t, new_periodic_solver
   use trial_case, only: trial_case_t, new_case
   use trial_surfaces, only: rough_surface
   use funit
   implicit none (type, external)

   integer, parameter :: n = 16
   real(dp), parameter :: tolerance = 1.0e-9_dp

contains

   !> Ask for the pull-offs of surfaces, each with the same adhesion, and compare with what they are alone.
   subroutine ask(list, n_surfaces)
      type(pull_off_list_t), intent(inout) :: list
      integer, intent(in) :: n_surfaces
      type(periodic_solver_t) :: solver
      type(periodic_adhesion_t) :: adhesion
      type(pull_off_t) :: pull_off, alone
      type(error_t), allocatable :: error
      real(dp), allocatable :: shape(:, :)
      integer :: seed

      call new_periodic_solver(solver, elastic_kernel_t(), [n, n], [1.0_dp, 1.0_dp], .false., error)
      do seed = 1, n_surfaces
         shape = 0.1_dp*rough_surface(n, n, seed)
         shape = shape - minval(shape)
         adhesion = periodic_adhesion_t(stress=0.05_dp, range=0.2_dp*maxval(shape))
         call get_pull_off(list, solver, shape, [1.0_dp, 1.0_dp], adhesion, tolerance, pull_off, error)
#line 38 "/work/wt/penetration/tests/periodic/periodic_pull_off_list.pf"
  call assertFalse(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_pull_off_list.pf', &
 & 38) )
  if (anyExceptions()) return
#line 39 "/work/wt/penetration/tests/periodic/periodic_pull_off_list.pf"
         call find_pull_off(solver, shape, adhesion, tolerance, alone, error)
#line 40 "/work/wt/penetration/tests/periodic/periodic_pull_off_list.pf"
  call assertTrue(pull_off%is_found .eqv. alone%is_found, &
 & location=SourceLocation( &
 & 'periodic_pull_off_list.pf', &
 & 40) )
  if (anyExceptions()) return
#line 41 "/work/wt/penetration/tests/periodic/periodic_pull_off_list.pf"
#line 41 "/work/wt/penetration/tests/periodic/periodic_pull_off_list.pf"
  call assertEqual(alone%mean_pressure, pull_off%mean_pressure, &
 & location=SourceLocation( &
 & 'periodic_pull_off_list.pf', &
 & 41) )
  if (anyExceptions()) return
#line 42 "/work/wt/penetration/tests/periodic/periodic_pull_off_list.pf"
#line 42 "/work/wt/penetration/tests/periodic/periodic_pull_off_list.pf"
  call assertEqual(alone%penetration, pull_off%penetration, &
 & location=SourceLocation( &
 & 'periodic_pull_off_list.pf', &
 & 42) )
  if (anyExceptions()) return
#line 43 "/work/wt/penetration/tests/periodic/periodic_pull_off_list.pf"
      end do
   end subroutine ask

   !@test
   subroutine test_found_once()
      type(pull_off_list_t) :: list

      call ask(list, 3)
#line 51 "/work/wt/penetration/tests/periodic/periodic_pull_off_list.pf"
  call assertEqual(3, list%n_found, &
 & location=SourceLocation( &
 & 'periodic_pull_off_list.pf', &
 & 51) )
  if (anyExceptions()) return
#line 52 "/work/wt/penetration/tests/periodic/periodic_pull_off_list.pf"
      call ask(list, 4)
#line 53 "/work/wt/penetration/tests/periodic/periodic_pull_off_list.pf"
  call assertEqual(4, list%n_found, &
 & location=SourceLocation( &
 & 'periodic_pull_off_list.pf', &
 & 53) )
  if (anyExceptions()) return
#line 54 "/work/wt/penetration/tests/periodic/periodic_pull_off_list.pf"
   end subroutine test_found_once

   ! More surfaces than the list keeps are found again, and answers are as before.
   !@test
   subroutine test_full_list()
      type(pull_off_list_t) :: list

      call ask(list, 33)
#line 62 "/work/wt/penetration/tests/periodic/periodic_pull_off_list.pf"
  call assertEqual(33, list%n_found, &
 & location=SourceLocation( &
 & 'periodic_pull_off_list.pf', &
 & 62) )
  if (anyExceptions()) return
#line 63 "/work/wt/penetration/tests/periodic/periodic_pull_off_list.pf"
      call ask(list, 1)
#line 64 "/work/wt/penetration/tests/periodic/periodic_pull_off_list.pf"
  call assertEqual(34, list%n_found, &
 & location=SourceLocation( &
 & 'periodic_pull_off_list.pf', &
 & 64) )
  if (anyExceptions()) return
#line 65 "/work/wt/penetration/tests/periodic/periodic_pull_off_list.pf"
   end subroutine test_full_list

   ! Other adhesion is another pull-off, and a run asks once for all loads, as one that is not prepared asks for each.
   !@test
   subroutine test_run()
      type(trial_case_t) :: case
      real(dp) :: alone
      integer :: k

      call new_case(case, 'wave_2d_elastic')
      call case%give('period', 1.0e-5_dp)
      call case%give('amplitude', 1.0e-7_dp)
      call case%give('contact_modulus', 1.0e7_dp)
      call case%give('cells', 64.0_dp)
      call case%give('stress', 1.0e5_dp)
      call case%give('range', 3.0e-8_dp)
      call case%give('pull_off', 1.0_dp)
      call case%give('mean_pressure', 1.0e4_dp)
      call case%solve()
      alone = case%found('pull_off_pressure')
#line 85 "/work/wt/penetration/tests/periodic/periodic_pull_off_list.pf"
  call assertLessThan(alone, 0.0_dp, &
 & location=SourceLocation( &
 & 'periodic_pull_off_list.pf', &
 & 85) )
  if (anyExceptions()) return
#line 86 "/work/wt/penetration/tests/periodic/periodic_pull_off_list.pf"
      call case%model%prepare()
      select type (model => case%model)
      class is (elastic_model_t)
         do k = 1, 3
            call case%give('mean_pressure', 1.0e4_dp*k)
            call case%solve()
#line 92 "/work/wt/penetration/tests/periodic/periodic_pull_off_list.pf"
  call assertEqual(alone, case%found('pull_off_pressure'), &
 & location=SourceLocation( &
 & 'periodic_pull_off_list.pf', &
 & 92) )
  if (anyExceptions()) return
#line 93 "/work/wt/penetration/tests/periodic/periodic_pull_off_list.pf"
#line 93 "/work/wt/penetration/tests/periodic/periodic_pull_off_list.pf"
  call assertEqual(1, model%pull_offs%n_found, &
 & location=SourceLocation( &
 & 'periodic_pull_off_list.pf', &
 & 93) )
  if (anyExceptions()) return
#line 94 "/work/wt/penetration/tests/periodic/periodic_pull_off_list.pf"
         end do
         call case%give('range', 2.0e-8_dp)
         call case%solve()
#line 97 "/work/wt/penetration/tests/periodic/periodic_pull_off_list.pf"
  call assertEqual(2, model%pull_offs%n_found, &
 & location=SourceLocation( &
 & 'periodic_pull_off_list.pf', &
 & 97) )
  if (anyExceptions()) return
#line 98 "/work/wt/penetration/tests/periodic/periodic_pull_off_list.pf"
      end select
      call case%model%release()
   end subroutine test_run

end module periodic_pull_off_list

module Wrapperiodic_pull_off_list
   use FUnit
   use periodic_pull_off_list
   implicit none
   private

contains


end module Wrapperiodic_pull_off_list

function periodic_pull_off_list_suite() result(suite)
   use FUnit
   use periodic_pull_off_list
   use Wrapperiodic_pull_off_list
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('periodic_pull_off_list_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_found_once', &
      test_found_once))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_full_list', &
      test_full_list))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_run', &
      test_run))
   call suite%addTest(t)


end function periodic_pull_off_list_suite


! The bits of a solution depend neither on the number of threads nor on what the solver has solved before; and it takes few steps.
module periodic_threads
   use omp_lib, only: omp_get_max_threads, omp_set_num_threads
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_solver, only: periodic_solver_t, periodic_solution_t, new_periodic_solver, contact_solved
   use trial_surfaces, only: noise_surface, wave
   use funit
   implicit none (type, external)

   real(dp), parameter :: tolerance = 1.0e-10_dp, periods(2) = [1.0_dp, 1.0_dp]

contains

   !> Solve one surface of n by n cells, under load or at a penetration, with a number of threads.
   subroutine solve(n, load, penetration, n_threads, solver, solution)
      integer, intent(in) :: n, n_threads
      real(dp), intent(in) :: load, penetration
      type(periodic_solver_t), intent(inout) :: solver
      type(periodic_solution_t), intent(out) :: solution
      type(error_t), allocatable :: error
      integer :: n_before

      n_before = omp_get_max_threads()
      call omp_set_num_threads(n_threads)
      if (load > 0) call solver%solve_load(noise_surface(n, 1), load, tolerance, solution, error)
      if (.not. load > 0) call solver%solve_penetration(noise_surface(n, 1), penetration, tolerance, solution, error)
      call omp_set_num_threads(n_before)
#line 30 "/work/wt/penetration/tests/periodic/periodic_threads.pf"
  call assertFalse(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_threads.pf', &
 & 30) )
  if (anyExceptions()) return
#line 31 "/work/wt/penetration/tests/periodic/periodic_threads.pf"
#line 31 "/work/wt/penetration/tests/periodic/periodic_threads.pf"
  call assertEqual(contact_solved, solution%status, &
 & location=SourceLocation( &
 & 'periodic_threads.pf', &
 & 31) )
  if (anyExceptions()) return
#line 32 "/work/wt/penetration/tests/periodic/periodic_threads.pf"
   end subroutine solve

   subroutine check_same(a, b)
      type(periodic_solution_t), intent(in) :: a, b

#line 37 "/work/wt/penetration/tests/periodic/periodic_threads.pf"
  call assertTrue(all(.not. abs(a%pressure - b%pressure) > 0), &
 & location=SourceLocation( &
 & 'periodic_threads.pf', &
 & 37) )
  if (anyExceptions()) return
#line 38 "/work/wt/penetration/tests/periodic/periodic_threads.pf"
#line 38 "/work/wt/penetration/tests/periodic/periodic_threads.pf"
  call assertTrue(all(.not. abs(a%gap - b%gap) > 0), &
 & location=SourceLocation( &
 & 'periodic_threads.pf', &
 & 38) )
  if (anyExceptions()) return
#line 39 "/work/wt/penetration/tests/periodic/periodic_threads.pf"
#line 39 "/work/wt/penetration/tests/periodic/periodic_threads.pf"
  call assertEqual(a%mean_pressure, b%mean_pressure, &
 & location=SourceLocation( &
 & 'periodic_threads.pf', &
 & 39) )
  if (anyExceptions()) return
#line 40 "/work/wt/penetration/tests/periodic/periodic_threads.pf"
#line 40 "/work/wt/penetration/tests/periodic/periodic_threads.pf"
  call assertEqual(a%residual, b%residual, &
 & location=SourceLocation( &
 & 'periodic_threads.pf', &
 & 40) )
  if (anyExceptions()) return
#line 41 "/work/wt/penetration/tests/periodic/periodic_threads.pf"
   end subroutine check_same

   ! A map that is shared by threads, whose number of rows no number of threads divides.
   !@test
   subroutine test_same_bits()
      integer, parameter :: n = 371
      real(dp), parameter :: load = 0.05_dp
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: by_one, by_many
      type(error_t), allocatable :: error
      integer :: k

      call new_periodic_solver(solver, elastic_kernel_t(), [n, n], periods, .false., error)
#line 54 "/work/wt/penetration/tests/periodic/periodic_threads.pf"
  call assertFalse(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_threads.pf', &
 & 54) )
  if (anyExceptions()) return
#line 55 "/work/wt/penetration/tests/periodic/periodic_threads.pf"
      call solve(n, load, 0.0_dp, 1, solver, by_one)
      do k = 2, 3
         call solve(n, load, 0.0_dp, k, solver, by_many)
         call check_same(by_one, by_many)
      end do
      call solve(n, 0.0_dp, 0.002_dp, 1, solver, by_one)
      call solve(n, 10*load, 0.0_dp, 1, solver, by_many)
      call solve(n, 0.0_dp, 0.002_dp, 2, solver, by_many)
      call check_same(by_one, by_many)
   end subroutine test_same_bits

   ! Twenty steps on the finest grid do, on any number of cells; there were fourty to fifty transforms for a wave.
   !@test
   subroutine test_few_steps()
      real(dp), parameter :: loads(*) = [0.01_dp, 0.1_dp, 0.5_dp, 0.9_dp, 0.99_dp]
      integer, parameter :: most_steps = 20, cells(2) = [64, 256]
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: solution
      type(error_t), allocatable :: error
      integer :: i, k

      do i = 1, size(cells)
         call new_periodic_solver(solver, elastic_kernel_t(), [1, 1]*cells(i)/2, periods, .true., error)
#line 78 "/work/wt/penetration/tests/periodic/periodic_threads.pf"
  call assertFalse(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_threads.pf', &
 & 78) )
  if (anyExceptions()) return
#line 79 "/work/wt/penetration/tests/periodic/periodic_threads.pf"
         do k = 1, size(loads)
            call solver%solve_load(wave(cells(i), cells(i)/2), loads(k), tolerance, solution, error)
#line 81 "/work/wt/penetration/tests/periodic/periodic_threads.pf"
  call assertEqual(contact_solved, solution%status, &
 & location=SourceLocation( &
 & 'periodic_threads.pf', &
 & 81) )
  if (anyExceptions()) return
#line 82 "/work/wt/penetration/tests/periodic/periodic_threads.pf"
#line 82 "/work/wt/penetration/tests/periodic/periodic_threads.pf"
  call assertLessThanOrEqual(solution%n_iterations, most_steps, &
 & location=SourceLocation( &
 & 'periodic_threads.pf', &
 & 82) )
  if (anyExceptions()) return
#line 83 "/work/wt/penetration/tests/periodic/periodic_threads.pf"
#line 83 "/work/wt/penetration/tests/periodic/periodic_threads.pf"
  call assertEqual(solution%n_iterations + 3, solution%n_applied, &
 & location=SourceLocation( &
 & 'periodic_threads.pf', &
 & 83) )
  if (anyExceptions()) return
#line 84 "/work/wt/penetration/tests/periodic/periodic_threads.pf"
#line 84 "/work/wt/penetration/tests/periodic/periodic_threads.pf"
  call assertLessThan(solution%n_pairs, 1.5_dp*solution%n_applied, &
 & location=SourceLocation( &
 & 'periodic_threads.pf', &
 & 84) )
  if (anyExceptions()) return
#line 85 "/work/wt/penetration/tests/periodic/periodic_threads.pf"
         end do
      end do
   end subroutine test_few_steps

end module periodic_threads

module Wrapperiodic_threads
   use FUnit
   use periodic_threads
   implicit none
   private

contains


end module Wrapperiodic_threads

function periodic_threads_suite() result(suite)
   use FUnit
   use periodic_threads
   use Wrapperiodic_threads
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('periodic_threads_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_same_bits', &
      test_same_bits))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_few_steps', &
      test_few_steps))
   call suite%addTest(t)


end function periodic_threads_suite


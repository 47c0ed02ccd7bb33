! The solid under a periodic surface is what its kernel says.
module periodic_kernel
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_kernel, only: kernel_t
   use adfric_periodic_operator, only: periodic_operator_t, new_periodic_operator
   use adfric_periodic_solver, only: periodic_solver_t, periodic_solution_t, new_periodic_solver, contact_solved
   use trial_kernels, only: stiff_kernel_t, lagging_kernel_t
   use trial_surfaces, only: rough_surface
   use funit
   implicit none (type, external)

   integer, parameter :: n = 16
   real(dp), parameter :: periods(2) = [1.0_dp, 1.0_dp], tolerance = 1.0e-10_dp, pressure = 0.01_dp

contains

   subroutine solve(kernel, mean_pressure, solution)
      class(kernel_t), intent(in) :: kernel
      real(dp), intent(in) :: mean_pressure
      type(periodic_solution_t), intent(out) :: solution
      type(periodic_solver_t) :: solver
      type(error_t), allocatable :: error
      real(dp) :: shape(n, n)

      shape = rough_surface(n, n, 1)
      shape = shape - minval(shape)
      call new_periodic_solver(solver, kernel, [n, n], periods, .false., error)
#line 30 "/work/wt/penetration/tests/periodic/periodic_kernel.pf"
  call assertFalse(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_kernel.pf', &
 & 30) )
  if (anyExceptions()) return
#line 31 "/work/wt/penetration/tests/periodic/periodic_kernel.pf"
      call solver%solve_load(shape, mean_pressure, tolerance, solution, error)
#line 32 "/work/wt/penetration/tests/periodic/periodic_kernel.pf"
  call assertFalse(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_kernel.pf', &
 & 32) )
  if (anyExceptions()) return
#line 33 "/work/wt/penetration/tests/periodic/periodic_kernel.pf"
   end subroutine solve

   ! Twice the stiffness takes twice the pressure to the same gap, both to the tolerance of the solution in their own scale.
   !@test
   subroutine test_twice_as_stiff()
      type(elastic_kernel_t) :: elastic
      type(stiff_kernel_t) :: stiff
      type(periodic_solution_t) :: one, other

      call solve(elastic, pressure, one)
      call solve(stiff, 2*pressure, other)
#line 44 "/work/wt/penetration/tests/periodic/periodic_kernel.pf"
  call assertEqual([contact_solved, contact_solved], [one%status, other%status], &
 & location=SourceLocation( &
 & 'periodic_kernel.pf', &
 & 44) )
  if (anyExceptions()) return
#line 45 "/work/wt/penetration/tests/periodic/periodic_kernel.pf"
#line 45 "/work/wt/penetration/tests/periodic/periodic_kernel.pf"
  call assertEqual(one%gap, other%gap, tolerance=10*tolerance*maxval(one%gap), &
 & location=SourceLocation( &
 & 'periodic_kernel.pf', &
 & 45) )
  if (anyExceptions()) return
#line 46 "/work/wt/penetration/tests/periodic/periodic_kernel.pf"
#line 46 "/work/wt/penetration/tests/periodic/periodic_kernel.pf"
  call assertEqual(2*one%pressure, other%pressure, tolerance=10*tolerance*maxval(other%pressure), &
 & location=SourceLocation( &
 & 'periodic_kernel.pf', &
 & 46) )
  if (anyExceptions()) return
#line 47 "/work/wt/penetration/tests/periodic/periodic_kernel.pf"
   end subroutine test_twice_as_stiff

   ! The stiffness of an elastic half-space is |k|/2 in every direction.
   !@test
   subroutine test_elastic_stiffness()
      real(dp), parameter :: pi = acos(-1.0_dp)
      type(elastic_kernel_t) :: elastic
      complex(dp) :: stiffness(2, 2)

      call elastic%get_stiffness([0.0_dp, 3.0_dp], [0.0_dp, 4.0_dp], [0.1_dp, 0.1_dp], stiffness)
#line 57 "/work/wt/penetration/tests/periodic/periodic_kernel.pf"
  call assertRelativelyEqual(5*pi, real(stiffness(2, 2), dp), tolerance=4*epsilon(pi), &
 & location=SourceLocation( &
 & 'periodic_kernel.pf', &
 & 57) )
  if (anyExceptions()) return
#line 58 "/work/wt/penetration/tests/periodic/periodic_kernel.pf"
#line 58 "/work/wt/penetration/tests/periodic/periodic_kernel.pf"
  call assertEqual(0.0_dp, maxval(abs(aimag(stiffness))), &
 & location=SourceLocation( &
 & 'periodic_kernel.pf', &
 & 58) )
  if (anyExceptions()) return
#line 59 "/work/wt/penetration/tests/periodic/periodic_kernel.pf"
#line 59 "/work/wt/penetration/tests/periodic/periodic_kernel.pf"
  call assertEqual(0.0_dp, real(stiffness(1, 1), dp), &
 & location=SourceLocation( &
 & 'periodic_kernel.pf', &
 & 59) )
  if (anyExceptions()) return
#line 60 "/work/wt/penetration/tests/periodic/periodic_kernel.pf"
   end subroutine test_elastic_stiffness

   ! A complex stiffness is refused on a quarter: none of it is left out in silence.
   !@test
   subroutine test_complex_stiffness()
      type(lagging_kernel_t) :: lagging
      type(periodic_operator_t) :: operator
      type(error_t), allocatable :: error

      call new_periodic_operator(operator, lagging, [n, n], periods, .true., .false., error)
#line 70 "/work/wt/penetration/tests/periodic/periodic_kernel.pf"
  call assertTrue(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_kernel.pf', &
 & 70) )
  if (anyExceptions()) return
#line 71 "/work/wt/penetration/tests/periodic/periodic_kernel.pf"
   end subroutine test_complex_stiffness

end module periodic_kernel

module Wrapperiodic_kernel
   use FUnit
   use periodic_kernel
   implicit none
   private

contains


end module Wrapperiodic_kernel

function periodic_kernel_suite() result(suite)
   use FUnit
   use periodic_kernel
   use Wrapperiodic_kernel
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('periodic_kernel_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_twice_as_stiff', &
      test_twice_as_stiff))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_elastic_stiffness', &
      test_elastic_stiffness))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_complex_stiffness', &
      test_complex_stiffness))
   call suite%addTest(t)


end function periodic_kernel_suite


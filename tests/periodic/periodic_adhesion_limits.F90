! Adhesion on cells at its limits: the sphere from DMT to JKR, the loop of a wave, ranges above all gaps, and zones and sizes of
! which the models have no answer.
module periodic_adhesion_limits
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp
   use adfric_model_status, only: status_solved, status_not_converged
   use adfric_periodic_adhesive_pull_off, only: pull_off_t, find_pull_off
   use adfric_periodic_adhesive_solver, only: periodic_adhesion_t, solve_adhesive_load
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_solver, only: periodic_solver_t, periodic_solution_t, new_periodic_solver, contact_solved
   use trial_case, only: trial_case_t, new_case
   use trial_surfaces, only: rough_surface
   use funit
   implicit none (type, external)

   real(dp), parameter :: pi = 3.14159265358979323846264338328_dp

   !> Stress over p* and range over the amplitude of a wave whose saturation ends at a load above 0 (alpha = 0.35).
   real(dp), parameter :: loop_stress = 0.6414085_dp, loop_range = 0.3_dp

   !> A state of the loop, in p* and the amplitude.
   type :: loop_point_t
      real(dp) :: load = 0, penetration = 0, energy = 0
   end type loop_point_t

contains

   !> Pull-off over pi w R of a sphere by the program's own theory of Maugis and Dugdale.
   real(dp) function sphere_pull_off(lambda) result(pull_off)
      real(dp), intent(in) :: lambda
      integer, parameter :: units_reduced = 2, maugis_dugdale = 5
      type(trial_case_t) :: case

      call new_case(case, 'sphere')
      call case%give('units', real(units_reduced, dp))
      call case%give('theory', real(maugis_dugdale, dp))
      call case%give('lambda', lambda)
      call case%give('load', 0.0_dp)
#line 39 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'periodic_adhesion_limits.pf', &
 & 39) )
  if (anyExceptions()) return
#line 40 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
      call case%solve()
#line 41 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'periodic_adhesion_limits.pf', &
 & 41) )
  if (anyExceptions()) return
#line 42 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
      pull_off = case%found('pull_off_load')
   end function sphere_pull_off

   ! A sphere in a cell 17 times its contact or more: from DMT to JKR within 0.5 % of the exact pull-off, and between 2 and 3/2.
   !@test
   subroutine test_sphere()
      real(dp), parameter :: radius = 1, contact = 0.06_dp, lambdas(*) = [0.1_dp, 0.3_dp, 2.0_dp]
      ! cells of a quarter; `bench/run adhesion_cells` has lambda = 3, which takes long
      integer, parameter :: cells(*) = [64, 64, 96]
      type(periodic_solver_t) :: solver
      type(periodic_adhesion_t) :: adhesion
      type(pull_off_t) :: pull_off
      type(error_t), allocatable :: error
      real(dp), allocatable :: shape(:, :)
      real(dp) :: energy, found, before, exact
      integer :: i, j, k

      energy = 4*contact**3/(3*pi*radius**2)
      before = 2
      do k = 1, size(lambdas)
         associate (n => cells(k))
            allocate (shape(n, n))
            do j = 1, n
               shape(:, j) = [(((i - 0.5_dp)**2 + (j - 0.5_dp)**2)/(2*radius*(2*n)**2), i=1, n)]
            end do
            shape(:, :) = shape - minval(shape)
            call new_periodic_solver(solver, elastic_kernel_t(), [n, n], [1.0_dp, 1.0_dp], .true., error)
         end associate
         adhesion = periodic_adhesion_t(stress=lambdas(k)/2*(16*pi*energy/(9*radius))**(1.0_dp/3), has_turned=.true.)
         adhesion%range = energy/adhesion%stress
         call find_pull_off(solver, shape, adhesion, 1.0e-9_dp, pull_off, error)
#line 73 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
  call assertTrue(pull_off%is_found, &
 & location=SourceLocation( &
 & 'periodic_adhesion_limits.pf', &
 & 73) )
  if (anyExceptions()) return
#line 74 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
         found = -pull_off%mean_pressure/(pi*energy*radius)
         exact = abs(sphere_pull_off(lambdas(k)))
#line 76 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
  call assertRelativelyEqual(exact, found, tolerance=0.005_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion_limits.pf', &
 & 76) )
  if (anyExceptions()) return
#line 77 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
#line 77 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
  call assertLessThan(found, before, &
 & location=SourceLocation( &
 & 'periodic_adhesion_limits.pf', &
 & 77) )
  if (anyExceptions()) return
#line 78 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
#line 78 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
  call assertGreaterThan(found, 1.5_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion_limits.pf', &
 & 78) )
  if (anyExceptions()) return
#line 79 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
         before = found
         deallocate (shape)
      end do
   end subroutine test_sphere

   ! A range above all gaps: the surface lets go as a whole, at the stress.
   !@test
   subroutine test_whole()
      integer, parameter :: n = 32
      type(periodic_solver_t) :: solver
      type(pull_off_t) :: pull_off
      type(error_t), allocatable :: error
      real(dp), allocatable :: shape(:, :)
      real(dp) :: stress
      integer :: k

      shape = rough_surface(n, n, 3)
      shape = shape - minval(shape)
      call new_periodic_solver(solver, elastic_kernel_t(), [n, n], [1.0_dp, 1.0_dp], .false., error)
      do k = -2, 2, 2
         stress = 10.0_dp**k
         call find_pull_off(solver, shape, periodic_adhesion_t(stress=stress, range=1.001_dp*maxval(shape)), 1.0e-9_dp, pull_off, &
            & error)
#line 102 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
  call assertTrue(pull_off%is_found, &
 & location=SourceLocation( &
 & 'periodic_adhesion_limits.pf', &
 & 102) )
  if (anyExceptions()) return
#line 103 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
#line 103 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
  call assertRelativelyEqual(-stress, pull_off%mean_pressure, tolerance=2.0e-5_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion_limits.pf', &
 & 103) )
  if (anyExceptions()) return
#line 104 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
      end do
   end subroutine test_whole

   ! A loop of the load from 0 to saturation and back: its area is what its two jumps lose, and that of the exact wave.
   !@test
   subroutine test_loop()
      integer, parameter :: n = 256, n_steps = 200
      real(dp), parameter :: highest = 1.05_dp
      type(periodic_solver_t) :: solver
      type(error_t), allocatable :: error
      type(loop_point_t) :: in(0:n_steps), out(0:n_steps)
      real(dp) :: shape(n/2, 1), area, jumps
      integer :: i, k

      shape(:, 1) = [(1 - cos(2*pi*(i - 0.5_dp)/n), i=1, n/2)]
      shape = shape - minval(shape)
      call new_periodic_solver(solver, elastic_kernel_t(), [n/2, 1], [1.0_dp, 1.0_dp], .true., error)
      do k = 0, n_steps
         call find_point(solver, shape, highest*k/n_steps, .false., in(k))
         call find_point(solver, shape, highest*k/n_steps, .true., out(k))
      end do
      ! the loop is closed at both ends
#line 126 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
  call assertEqual(in(0)%penetration, out(0)%penetration, tolerance=1.0e-8_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion_limits.pf', &
 & 126) )
  if (anyExceptions()) return
#line 127 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
#line 127 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
  call assertEqual(in(n_steps)%penetration, out(n_steps)%penetration, tolerance=1.0e-8_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion_limits.pf', &
 & 127) )
  if (anyExceptions()) return
#line 128 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
      area = 0
      jumps = 0
      call add_branch(in, 1, area, jumps)
      call add_branch(out, -1, area, jumps)
#line 132 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
  call assertRelativelyEqual(jumps, area, tolerance=2.0e-3_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion_limits.pf', &
 & 132) )
  if (anyExceptions()) return
#line 133 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
#line 133 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
  call assertRelativelyEqual(exact_loss(.false.) + exact_loss(.true.), area, tolerance=2.0e-2_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion_limits.pf', &
 & 133) )
  if (anyExceptions()) return
#line 134 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
   end subroutine test_loop

   !> The state of a branch under a load in p*.
   subroutine find_point(solver, shape, load, is_adhered, point)
      type(periodic_solver_t), intent(inout) :: solver
      real(dp), intent(in) :: shape(:, :), load
      logical, intent(in) :: is_adhered
      type(loop_point_t), intent(out) :: point
      type(periodic_solution_t) :: solution
      type(error_t), allocatable :: error

      call solve_adhesive_load(solver, shape, pi*load, periodic_adhesion_t(pi*loop_stress, loop_range, is_adhered), 1.0e-10_dp, &
         & solution, error)
#line 147 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
  call assertEqual(contact_solved, solution%status, &
 & location=SourceLocation( &
 & 'periodic_adhesion_limits.pf', &
 & 147) )
  if (anyExceptions()) return
#line 148 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
      point = loop_point_t(load, solution%penetration, (solution%elastic_energy + solution%adhesion_energy)/pi)
   end subroutine find_point

   !> The state of the exact wave under a load in p*.
   subroutine find_exact(load, is_adhered, point, is_saturated)
      real(dp), intent(in) :: load
      logical, intent(in) :: is_adhered
      type(loop_point_t), intent(out) :: point
      logical, intent(out) :: is_saturated
      integer, parameter :: zones = 4
      type(trial_case_t) :: case

      call new_case(case, 'wave_1d')
      call case%give('period', 1.0_dp)
      call case%give('amplitude', 1.0_dp)
      call case%give('contact_modulus', 1/pi)
      call case%give('stress', loop_stress)
      call case%give('range', loop_range)
      call case%give('branch', merge(1.0_dp, 2.0_dp, is_adhered))
      call case%give('mean_pressure', load)
      call case%solve()
#line 169 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'periodic_adhesion_limits.pf', &
 & 169) )
  if (anyExceptions()) return
#line 170 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
      point = loop_point_t(load, case%found('penetration'), case%found('elastic_energy') + case%found('adhesion_energy'))
      is_saturated = nint(case%found('regime')) /= zones
   end subroutine find_exact

   !> What the jump of a branch of the exact wave between zones and saturation loses.
   real(dp) function exact_loss(is_adhered) result(loss)
      logical, intent(in) :: is_adhered
      type(loop_point_t) :: low, high, point
      real(dp) :: load(2)
      logical :: is_saturated
      integer :: k

      load = [0.0_dp, 1.0_dp]
      do k = 1, 45
         call find_exact(sum(load)/2, is_adhered, point, is_saturated)
         load(merge(2, 1, is_saturated)) = sum(load)/2
      end do
      call find_exact(load(1), is_adhered, low, is_saturated)
      call find_exact(load(2), is_adhered, high, is_saturated)
      ! E - q penetration, up on approach and down on parting
      loss = merge(-1, 1, is_adhered)*(low%energy - high%energy - load(1)*(low%penetration - high%penetration))
#line 191 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
  call assertGreaterThan(loss, 0.0_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion_limits.pf', &
 & 191) )
  if (anyExceptions()) return
#line 192 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
   end function exact_loss

   !> Work q d(penetration) along a branch, between jumps, and what the jumps lose of E - q penetration.
   subroutine add_branch(points, way, area, jumps)
      type(loop_point_t), intent(in) :: points(:)
      !> 1: the load rises, -1: it falls.
      integer, intent(in) :: way
      real(dp), intent(inout) :: area, jumps
      real(dp) :: work, gain
      integer :: k

      do k = 2, size(points)
         associate (low => points(k - 1), high => points(k))
            work = (low%load + high%load)/2*(high%penetration - low%penetration)
            gain = high%energy - low%energy
            area = area + way*work
            ! between jumps both are the same but for the trapezium rule
            if (abs(high%penetration - low%penetration) > 0.05_dp) jumps = jumps + way*(work - gain)
         end associate
      end do
   end subroutine add_branch

   !> A wave of 64 cells with a stress and cells per zone; lengths in its amplitude, pressures in E*, p* = 2 pi.
   subroutine new_wave(case, load, stress, cells)
      type(trial_case_t), intent(out) :: case
      real(dp), intent(in) :: load, stress, cells

      call new_case(case, 'wave_2d_elastic')
      call case%give('period', 1.0_dp)
      call case%give('amplitude', 1.0_dp)
      call case%give('contact_modulus', 1.0_dp)
      call case%give('cells', 64.0_dp)
      call case%give('mean_pressure', load)
      call case%give('stress', stress)
      call case%give('range', 4*stress*cells/(64*pi))
   end subroutine new_wave

   ! Half a cell per zone and more: the estimate has their error. Less: no answer, but where adhesion has no edge.
   !@test
   subroutine test_cells()
      type(trial_case_t) :: case

      call new_wave(case, 1.0_dp, 2.0_dp, 0.51_dp)
      call case%solve()
#line 236 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'periodic_adhesion_limits.pf', &
 & 236) )
  if (anyExceptions()) return
#line 237 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
#line 237 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
  call assertGreaterThanOrEqual(case%error_estimate(1), 0.05_dp/0.51_dp**2, &
 & location=SourceLocation( &
 & 'periodic_adhesion_limits.pf', &
 & 237) )
  if (anyExceptions()) return
#line 238 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
#line 238 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
  call assertLessThan(case%error_estimate(1), 1.0_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion_limits.pf', &
 & 238) )
  if (anyExceptions()) return
#line 239 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
      call new_wave(case, 1.0_dp, 2.0_dp, 0.49_dp)
      call case%solve()
#line 241 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
  call assertEqual(status_not_converged, case%status(1), &
 & location=SourceLocation( &
 & 'periodic_adhesion_limits.pf', &
 & 241) )
  if (anyExceptions()) return
#line 242 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
#line 242 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
  call assertIsNaN(case%found('contact_fraction'), &
 & location=SourceLocation( &
 & 'periodic_adhesion_limits.pf', &
 & 242) )
  if (anyExceptions()) return
#line 243 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
      call case%give('mean_pressure', 12.0_dp)
      call case%solve()
#line 245 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'periodic_adhesion_limits.pf', &
 & 245) )
  if (anyExceptions()) return
#line 246 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
#line 246 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
  call assertEqual(1.0_dp, case%found('contact_fraction'), tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion_limits.pf', &
 & 246) )
  if (anyExceptions()) return
#line 247 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
   end subroutine test_cells

   ! Sizes that are refused, and those next to them.
   !@test
   subroutine test_sizes()
      character(*), parameter :: message = 'stress: or its range is too small or too large for the surface'
      type(trial_case_t) :: case
      real(dp) :: size_of
      integer :: k

      do k = -1, 1, 2
         size_of = 4*10.0_dp**(12*k)
         call new_wave(case, 1.0_dp, 1.0_dp, 1.0_dp)
         call case%give('stress', size_of*1.01_dp**k)
#line 261 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
  call assertTrue(index(case%problems_of(), message) > 0, &
 & location=SourceLocation( &
 & 'periodic_adhesion_limits.pf', &
 & 261) )
  if (anyExceptions()) return
#line 262 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
         call case%give('stress', size_of*0.99_dp**k)
#line 263 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'periodic_adhesion_limits.pf', &
 & 263) )
  if (anyExceptions()) return
#line 264 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
         call new_wave(case, 1.0_dp, 1.0_dp, 1.0_dp)
         call case%give('range', size_of*1.01_dp**k)
#line 266 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
  call assertTrue(index(case%problems_of(), message) > 0, &
 & location=SourceLocation( &
 & 'periodic_adhesion_limits.pf', &
 & 266) )
  if (anyExceptions()) return
#line 267 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
         call case%give('range', size_of*0.99_dp**k)
#line 268 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'periodic_adhesion_limits.pf', &
 & 268) )
  if (anyExceptions()) return
#line 269 "/work/wt/penetration/tests/periodic/periodic_adhesion_limits.pf"
      end do
   end subroutine test_sizes

end module periodic_adhesion_limits

module Wrapperiodic_adhesion_limits
   use FUnit
   use periodic_adhesion_limits
   implicit none
   private

contains


end module Wrapperiodic_adhesion_limits

function periodic_adhesion_limits_suite() result(suite)
   use FUnit
   use periodic_adhesion_limits
   use Wrapperiodic_adhesion_limits
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('periodic_adhesion_limits_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_sphere', &
      test_sphere))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_whole', &
      test_whole))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_loop', &
      test_loop))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_cells', &
      test_cells))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_sizes', &
      test_sizes))
   call suite%addTest(t)


end function periodic_adhesion_limits_suite


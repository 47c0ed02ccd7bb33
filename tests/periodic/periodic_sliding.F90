! The engine under a sliding body: against a solver without transforms, hard cases, threads, and what was solved before.
module periodic_sliding
   use omp_lib, only: omp_get_max_threads, omp_set_num_threads
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_material_prony, only: prony_t, new_prony
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_layer_kernel, only: layer_kernel_t
   use adfric_periodic_maps, only: dot_of
   use adfric_periodic_past_directions, only: past_directions_t
   use adfric_periodic_sliding_kernel, only: sliding_kernel_t, new_sliding_kernel
   use adfric_periodic_solver, only: periodic_solver_t, periodic_solution_t, new_periodic_solver, contact_solved
   use dense_sliding, only: solve_dense
   use trial_surfaces, only: line_wave, noise_surface, rough_surface, wave
   use funit
   implicit none (type, external)

   real(dp), parameter :: tolerance = 1.0e-10_dp, loose = 1.0e-8_dp, periods(2) = [1.0_dp, 0.8_dp]

contains

   !> A solver for a solid that slides along x, in units of the period.
   subroutine make_solver(solver, n_cells, moduli, times, velocity, thickness)
      type(periodic_solver_t), intent(out) :: solver
      integer, intent(in) :: n_cells(2)
      real(dp), intent(in) :: moduli(:), times(:), velocity
      real(dp), intent(in), optional :: thickness
      type(sliding_kernel_t) :: kernel
      type(prony_t) :: prony
      type(error_t), allocatable :: error

      call new_prony(prony, 1.0_dp, moduli, times)
      if (present(thickness)) then
         call new_sliding_kernel(kernel, layer_kernel_t(thickness), prony, velocity, [1, 0])
      else
         call new_sliding_kernel(kernel, elastic_kernel_t(), prony, velocity, [1, 0])
      end if
      call new_periodic_solver(solver, kernel, n_cells, periods, .false., error)
#line 39 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
  call assertFalse(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_sliding.pf', &
 & 39) )
  if (anyExceptions()) return
#line 40 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
   end subroutine make_solver

   !> One random surface at some loads.
   subroutine check_dense(seed, moduli, times, velocity)
      integer, intent(in) :: seed
      real(dp), intent(in) :: moduli(:), times(:), velocity
      integer, parameter :: nx = 14, ny = 6
      real(dp), parameter :: loads(*) = [0.02_dp, 0.3_dp, 1.0_dp]
      real(dp) :: shape(nx, ny), pressure(nx, ny), gap(nx, ny)
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: solution
      type(error_t), allocatable :: error
      type(prony_t) :: prony
      integer :: k, n_flips

      call new_prony(prony, 1.0_dp, moduli, times)
      shape = rough_surface(nx, ny, seed)
      call make_solver(solver, [nx, ny], moduli, times, velocity)
      do k = 1, size(loads)
         call solve_dense(shape, periods(2), prony, velocity, loads(k), pressure, gap, n_flips)
#line 60 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
  call assertGreaterThanOrEqual(n_flips, 0, &
 & location=SourceLocation( &
 & 'periodic_sliding.pf', &
 & 60) )
  if (anyExceptions()) return
#line 61 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
         call solver%solve_load(shape, loads(k), tolerance, solution, error)
#line 62 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
  call assertFalse(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_sliding.pf', &
 & 62) )
  if (anyExceptions()) return
#line 63 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
#line 63 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
  call assertEqual(contact_solved, solution%status, &
 & location=SourceLocation( &
 & 'periodic_sliding.pf', &
 & 63) )
  if (anyExceptions()) return
#line 64 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
#line 64 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
  call assertEqual(pressure, solution%pressure, tolerance=1.0e-7_dp*maxval(pressure), &
 & location=SourceLocation( &
 & 'periodic_sliding.pf', &
 & 64) )
  if (anyExceptions()) return
#line 65 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
#line 65 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
  call assertEqual(gap, solution%gap, tolerance=1.0e-7_dp*maxval(shape), &
 & location=SourceLocation( &
 & 'periodic_sliding.pf', &
 & 65) )
  if (anyExceptions()) return
#line 66 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
      end do
   end subroutine check_dense

   ! Every cell of small random surfaces, slow and fast, with one time and with a spectrum.
   !@test
   subroutine test_dense()
      integer :: i

      do i = -3, 2
         call check_dense(i + 10, [9.0_dp], [1.0_dp], 10.0_dp**i)
         call check_dense(i + 20, [200.0_dp], [1.0_dp], 10.0_dp**i)
         call check_dense(i + 30, [1.0_dp, 10.0_dp, 100.0_dp], [10.0_dp, 1.0_dp, 0.01_dp], 10.0_dp**i)
      end do
   end subroutine test_dense

   ! Few cells are open: after as many steps nothing but round-off is left of the directions, and the given penetration stays.
   !@test
   subroutine test_few_open_cells()
      real(dp), parameter :: shares(*) = [1.0e-3_dp, 0.05_dp, 0.14_dp, 0.5_dp, 0.9_dp, 0.97_dp]
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: solution, back
      type(error_t), allocatable :: error
      real(dp), allocatable :: shape(:, :)
      integer :: n, i, k

      do n = 3, 14
         shape = noise_surface(n, n)
         shape = shape(:, :1) - minval(shape(:, :1))
         do i = -2, 2
            call make_solver(solver, [n, 1], [3.0_dp, 100.0_dp], [1.0_dp, 0.01_dp], 10.0_dp**i)
            call solver%solve_load(shape, 1.0_dp, tolerance, solution, error)
            do k = 1, size(shares)
               associate (load => shares(k)*solution%full_pressure)
                  call solver%solve_load(shape, load, tolerance, solution, error)
#line 100 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
  call assertEqual(contact_solved, solution%status, &
 & location=SourceLocation( &
 & 'periodic_sliding.pf', &
 & 100) )
  if (anyExceptions()) return
#line 101 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
                  call solver%solve_penetration(shape, solution%penetration, tolerance, back, error)
#line 102 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
  call assertEqual(contact_solved, back%status, &
 & location=SourceLocation( &
 & 'periodic_sliding.pf', &
 & 102) )
  if (anyExceptions()) return
#line 103 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
#line 103 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
  call assertEqual(solution%penetration, back%penetration, tolerance=tolerance*maxval(shape), &
 & location=SourceLocation( &
 & 'periodic_sliding.pf', &
 & 103) )
  if (anyExceptions()) return
#line 104 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
#line 104 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
  call assertEqual(load, back%mean_pressure, tolerance=1.0e-8_dp*solution%full_pressure, &
 & location=SourceLocation( &
 & 'periodic_sliding.pf', &
 & 104) )
  if (anyExceptions()) return
#line 105 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
               end associate
            end do
         end do
      end do
   end subroutine test_few_open_cells

   ! One time and a large ratio of moduli, where the solid relaxes within a cell or a few: where sets cycle with other moduli.
   !@test
   subroutine test_hard()
      integer, parameter :: n = 512
      real(dp), parameter :: loads(*) = [1.0e-3_dp, 0.1_dp, 1.0_dp]
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: solution
      type(error_t), allocatable :: error
      integer :: i, j, k

      do j = 3, 4
         do i = -3, 1
            call make_solver(solver, [n, 1], [10.0_dp**j - 1], [1.0_dp], 10.0_dp**i/n)
            do k = 1, size(loads)
               call solver%solve_load(line_wave(n, n), loads(k), loose, solution, error)
#line 126 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
  call assertEqual(contact_solved, solution%status, &
 & location=SourceLocation( &
 & 'periodic_sliding.pf', &
 & 126) )
  if (anyExceptions()) return
#line 127 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
#line 127 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
  call assertLessThanOrEqual(solution%residual, loose, &
 & location=SourceLocation( &
 & 'periodic_sliding.pf', &
 & 127) )
  if (anyExceptions()) return
#line 128 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
            end do
         end do
      end do
   end subroutine test_hard

   ! Where even that is not enough the solver says so, and gives no number that is none.
   !@test
   subroutine test_harder()
      integer, parameter :: n = 256
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: solution
      type(error_t), allocatable :: error
      integer :: i

      do i = -3, 1
         call make_solver(solver, [n, 1], [1.0e7_dp], [1.0_dp], 10.0_dp**i/n)
         call solver%solve_load(line_wave(n, n), 0.1_dp, tolerance, solution, error)
#line 145 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
  call assertTrue(solution%status == contact_solved .eqv. solution%residual <= tolerance, &
 & location=SourceLocation( &
 & 'periodic_sliding.pf', &
 & 145) )
  if (anyExceptions()) return
#line 146 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
#line 146 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
  call assertTrue(all(solution%pressure >= 0 .and. solution%gap >= 0), &
 & location=SourceLocation( &
 & 'periodic_sliding.pf', &
 & 146) )
  if (anyExceptions()) return
#line 147 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
      end do
   end subroutine test_harder

   ! A map that threads share; and what was solved before, under a load or into a layer, leaves no trace.
   !@test
   subroutine test_same_bits()
      integer, parameter :: n = 372
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: first, again
      type(error_t), allocatable :: error
      real(dp), allocatable :: shape(:, :)
      integer :: n_before

      shape = wave(n, n)
      call make_solver(solver, [n, n], [9.0_dp, 30.0_dp], [1.0_dp, 0.01_dp], 0.3_dp, 0.2_dp)
      n_before = omp_get_max_threads()
      call omp_set_num_threads(1)
      call solver%solve_load(shape, 0.5_dp, loose, first, error)
      call omp_set_num_threads(3)
      call solver%solve_load(shape, 0.5_dp, loose, again, error)
      call omp_set_num_threads(n_before)
#line 168 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
  call assertEqual(contact_solved, again%status, &
 & location=SourceLocation( &
 & 'periodic_sliding.pf', &
 & 168) )
  if (anyExceptions()) return
#line 169 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
#line 169 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
  call assertTrue(all(.not. abs(first%pressure - again%pressure) > 0), &
 & location=SourceLocation( &
 & 'periodic_sliding.pf', &
 & 169) )
  if (anyExceptions()) return
#line 170 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
#line 170 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
  call assertTrue(all(.not. abs(first%gap - again%gap) > 0), &
 & location=SourceLocation( &
 & 'periodic_sliding.pf', &
 & 170) )
  if (anyExceptions()) return
#line 171 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
      call solver%solve_penetration(shape, first%penetration, loose, again, error)
#line 172 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
  call assertEqual(contact_solved, again%status, &
 & location=SourceLocation( &
 & 'periodic_sliding.pf', &
 & 172) )
  if (anyExceptions()) return
#line 173 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
#line 173 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
  call assertRelativelyEqual(0.5_dp, again%mean_pressure, tolerance=1.0e-5_dp, &
 & location=SourceLocation( &
 & 'periodic_sliding.pf', &
 & 173) )
  if (anyExceptions()) return
#line 174 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
      call solver%solve_load(shape, 0.5_dp, loose, again, error)
#line 175 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
  call assertTrue(all(.not. abs(first%pressure - again%pressure) > 0), &
 & location=SourceLocation( &
 & 'periodic_sliding.pf', &
 & 175) )
  if (anyExceptions()) return
#line 176 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
   end subroutine test_same_bits

   ! A direction that is taken has a pressure orthogonal to those that are kept; after `clear` there are none.
   !@test
   subroutine test_directions()
      integer, parameter :: n = 9
      type(past_directions_t) :: past
      real(dp), dimension(n, n) :: gap, pressure, preconditioned, last, same
      real(dp) :: product
      integer :: k

      do k = 1, 5
         call random_number(gap)
         pressure = 3*gap
         preconditioned = 2*pressure
         call past%take(gap, pressure, preconditioned, product)
#line 192 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
  call assertRelativelyEqual(dot_of(pressure, preconditioned), product, tolerance=1.0e-12_dp, &
 & location=SourceLocation( &
 & 'periodic_sliding.pf', &
 & 192) )
  if (anyExceptions()) return
#line 193 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
#line 193 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
  call assertEqual(3*gap, pressure, tolerance=1.0e-12_dp, &
 & location=SourceLocation( &
 & 'periodic_sliding.pf', &
 & 193) )
  if (anyExceptions()) return
#line 194 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
         if (k > 1) then
#line 195 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
  call assertEqual(0.0_dp, dot_of(pressure, last), tolerance=1.0e-12_dp*product, &
 & location=SourceLocation( &
 & 'periodic_sliding.pf', &
 & 195) )
  if (anyExceptions()) return
#line 196 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
         end if
         last = preconditioned
      end do
      call past%clear()
      call random_number(gap)
      same = gap
      call past%take(gap, pressure, preconditioned, product)
#line 203 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
  call assertEqual(same, gap, tolerance=tiny(1.0_dp), &
 & location=SourceLocation( &
 & 'periodic_sliding.pf', &
 & 203) )
  if (anyExceptions()) return
#line 204 "/work/wt/penetration/tests/periodic/periodic_sliding.pf"
   end subroutine test_directions

end module periodic_sliding

module Wrapperiodic_sliding
   use FUnit
   use periodic_sliding
   implicit none
   private

contains


end module Wrapperiodic_sliding

function periodic_sliding_suite() result(suite)
   use FUnit
   use periodic_sliding
   use Wrapperiodic_sliding
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('periodic_sliding_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_dense', &
      test_dense))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_few_open_cells', &
      test_few_open_cells))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_hard', &
      test_hard))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_harder', &
      test_harder))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_same_bits', &
      test_same_bits))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_directions', &
      test_directions))
   call suite%addTest(t)


end function periodic_sliding_suite


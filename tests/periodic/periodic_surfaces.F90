! Any surface: the conditions of contact, the symmetries, both controls, and what is rejected.
module periodic_surfaces
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_solver, only: periodic_solver_t, periodic_solution_t, new_periodic_solver, contact_solved, &
      contact_not_converged, contact_out_of_range
   use trial_surfaces, only: wave, rough_surface, noise_surface, punch_surface
   use funit
   implicit none (type, external)

   real(dp), parameter :: tolerance = 1.0e-10_dp
   real(dp), parameter :: unit_periods(2) = 1
   !> Two solutions of residual `tolerance` of one problem, relative to their largest values.
   real(dp), parameter :: equal_solutions = 1.0e-7_dp

contains

   subroutine press(shape, load, solution, periods)
      real(dp), intent(in) :: shape(:, :), load
      type(periodic_solution_t), intent(out) :: solution
      real(dp), intent(in), optional :: periods(2)
      type(periodic_solver_t) :: solver
      type(error_t), allocatable :: error
      real(dp) :: p(2)

      p = unit_periods
      if (present(periods)) p = periods
      call new_periodic_solver(solver, elastic_kernel_t(), [size(shape, 1), size(shape, 2)], p, .false., error)
#line 30 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertFalse(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 30) )
  if (anyExceptions()) return
#line 31 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
      call solver%solve_load(shape, load, tolerance, solution, error)
#line 32 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertFalse(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 32) )
  if (anyExceptions()) return
#line 33 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
   end subroutine press

   !> Load control, its conditions, and penetration control back.
   subroutine check_surface(shape, load, name)
      real(dp), intent(in) :: shape(:, :), load
      character(*), intent(in) :: name
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: s, back
      type(error_t), allocatable :: error

      call press(shape, load, s)
#line 44 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertEqual(contact_solved, s%status, message=name, &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 44) )
  if (anyExceptions()) return
#line 45 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
#line 45 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertLessThanOrEqual(s%residual, tolerance, message=name, &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 45) )
  if (anyExceptions()) return
#line 46 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
#line 46 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertEqual(0, count(s%pressure > 0 .and. s%gap > 0), message=name, &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 46) )
  if (anyExceptions()) return
#line 47 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
#line 47 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertLessThanOrEqual(0.0_dp, minval(min(s%pressure, s%gap)), message=name, &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 47) )
  if (anyExceptions()) return
#line 48 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
#line 48 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertRelativelyEqual(load, sum(s%pressure)/size(shape), tolerance=equal_solutions, message=name, &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 48) )
  if (anyExceptions()) return
#line 49 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
      if (count(s%gap > 0) == 0) return
      call new_periodic_solver(solver, elastic_kernel_t(), [size(shape, 1), size(shape, 2)], unit_periods, .false., error)
      call solver%solve_penetration(shape, s%penetration, tolerance, back, error)
#line 52 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertEqual(contact_solved, back%status, message=name, &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 52) )
  if (anyExceptions()) return
#line 53 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
#line 53 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertLessThanOrEqual(back%residual, tolerance, message=name, &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 53) )
  if (anyExceptions()) return
#line 54 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
#line 54 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertRelativelyEqual(load, back%mean_pressure, tolerance=10*equal_solutions, message=name, &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 54) )
  if (anyExceptions()) return
#line 55 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
#line 55 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertEqual(s%penetration, back%penetration, tolerance=equal_solutions, &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 55) )
  if (anyExceptions()) return
#line 56 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
   end subroutine check_surface

   !@test
   subroutine test_many_surfaces()
      real(dp), parameter :: loads(*) = [1.0e-4_dp, 1.0e-2_dp, 0.1_dp, 0.5_dp, 1.0_dp, 10.0_dp]
      integer :: k, seed

      do k = 1, size(loads)
         do seed = 1, 3
            call check_surface(rough_surface(48, 48, seed), loads(k), 'rough')
            call check_surface(noise_surface(48, seed), loads(k), 'noise')
         end do
         call check_surface(rough_surface(31, 48, 1), loads(k), 'odd number of cells')
         call check_surface(punch_surface(32), loads(k), 'punch')
      end do
   end subroutine test_many_surfaces

   ! Nothing is spoiled by the choice of the transforms, or of the origin and the order of the axes.
   !@test
   subroutine test_quarter_and_whole()
      integer, parameter :: n = 32
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: quarter, whole
      type(error_t), allocatable :: error

      call new_periodic_solver(solver, elastic_kernel_t(), [n/2, n/2], unit_periods, .true., error)
      call solver%solve_load(wave(n, n/2), 0.3_dp, tolerance, quarter, error)
      call press(wave(n, n), 0.3_dp, whole)
#line 84 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertEqual(quarter%pressure, whole%pressure(:n/2, :n/2), tolerance=equal_solutions, &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 84) )
  if (anyExceptions()) return
#line 85 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
#line 85 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertEqual(quarter%gap, whole%gap(n:n/2 + 1:-1, :n/2), tolerance=equal_solutions, &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 85) )
  if (anyExceptions()) return
#line 86 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
#line 86 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertEqual(quarter%area%corrected, whole%area%corrected, tolerance=10*epsilon(1.0_dp), &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 86) )
  if (anyExceptions()) return
#line 87 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
#line 87 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertEqual(quarter%penetration, whole%penetration, tolerance=equal_solutions, &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 87) )
  if (anyExceptions()) return
#line 88 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
   end subroutine test_quarter_and_whole

   !@test
   subroutine test_shifted_and_turned()
      integer, parameter :: nx = 32, ny = 48
      real(dp) :: shape(nx, ny)
      type(periodic_solution_t) :: s, moved, turned

      shape = rough_surface(nx, ny, 3)
      call press(shape, 0.1_dp, s, [1.0_dp, 1.5_dp])
      call press(cshift(cshift(shape, 5, 1), -7, 2), 0.1_dp, moved, [1.0_dp, 1.5_dp])
#line 99 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertEqual(cshift(cshift(s%pressure, 5, 1), -7, 2), moved%pressure, tolerance=equal_solutions, &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 99) )
  if (anyExceptions()) return
#line 100 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
      call press(transpose(shape), 0.1_dp, turned, [1.5_dp, 1.0_dp])
#line 101 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertEqual(transpose(s%pressure), turned%pressure, tolerance=equal_solutions, &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 101) )
  if (anyExceptions()) return
#line 102 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
   end subroutine test_shifted_and_turned

   ! Lengths in nanometres and in metres.
   !@test
   subroutine test_units()
      real(dp), parameter :: metre = 1.0e-9_dp
      real(dp) :: shape(32, 32)
      type(periodic_solution_t) :: s, in_metres

      shape = rough_surface(32, 32, 2)
      call press(shape, 0.05_dp, s)
      call press(metre*shape, 0.05_dp, in_metres, metre*unit_periods)
#line 114 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertEqual(s%pressure, in_metres%pressure, tolerance=equal_solutions, &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 114) )
  if (anyExceptions()) return
#line 115 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
#line 115 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertRelativelyEqual(metre*s%penetration, in_metres%penetration, tolerance=equal_solutions, &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 115) )
  if (anyExceptions()) return
#line 116 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
   end subroutine test_units

   ! A surface that does not vary along y is the line.
   !@test
   subroutine test_line_and_surface()
      integer, parameter :: n = 64
      real(dp) :: line(n, 1)
      type(periodic_solution_t) :: s, of_line

      line = rough_surface(n, 1, 1)
      call press(line, 0.1_dp, of_line)
      call press(spread(line(:, 1), 2, 8), 0.1_dp, s)
#line 128 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertEqual(of_line%pressure(:, 1), s%pressure(:, 3), tolerance=equal_solutions, &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 128) )
  if (anyExceptions()) return
#line 129 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
   end subroutine test_line_and_surface

   !@test
   subroutine test_no_contact()
      real(dp) :: shape(16, 16)
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: s
      type(error_t), allocatable :: error

      shape = wave(16, 16)
      call new_periodic_solver(solver, elastic_kernel_t(), [16, 16], unit_periods, .false., error)
      call solver%solve_penetration(shape, -0.1_dp, tolerance, s, error)
#line 141 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertEqual(contact_solved, s%status, &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 141) )
  if (anyExceptions()) return
#line 142 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
#line 142 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertEqual(shape + 0.1_dp, s%gap, tolerance=epsilon(1.0_dp), &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 142) )
  if (anyExceptions()) return
#line 143 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
#line 143 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertEqual(0, count(s%pressure > 0), &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 143) )
  if (anyExceptions()) return
#line 144 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
      call solver%solve_load(shape, 0.0_dp, tolerance, s, error)
#line 145 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertEqual(contact_solved, s%status, &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 145) )
  if (anyExceptions()) return
#line 146 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
#line 146 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertEqual(0, count(s%pressure > 0), &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 146) )
  if (anyExceptions()) return
#line 147 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
   end subroutine test_no_contact

   !@test
   subroutine test_out_of_range()
      real(dp) :: shape(16, 16)
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: s
      type(error_t), allocatable :: error

      shape = wave(16, 16)
      call new_periodic_solver(solver, elastic_kernel_t(), [16, 16], unit_periods, .false., error)
      call solver%solve_load(shape, -0.1_dp, tolerance, s, error)
#line 159 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertEqual(contact_out_of_range, s%status, &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 159) )
  if (anyExceptions()) return
#line 160 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
      ! deeper than the mean of the gap
      call solver%solve_penetration(shape, 0.32_dp, tolerance, s, error)
#line 162 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertEqual(contact_out_of_range, s%status, &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 162) )
  if (anyExceptions()) return
#line 163 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
      ! a tolerance that no double-precision solution has
      call solver%solve_load(shape, 0.1_dp, 1.0e-18_dp, s, error)
#line 165 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertEqual(contact_not_converged, s%status, &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 165) )
  if (anyExceptions()) return
#line 166 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
#line 166 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertLessThan(s%residual, 1.0e-12_dp, &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 166) )
  if (anyExceptions()) return
#line 167 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
   end subroutine test_out_of_range

   !@test
   subroutine test_rejections()
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: s
      type(error_t), allocatable :: error

      call new_periodic_solver(solver, elastic_kernel_t(), [0, 4], unit_periods, .false., error)
#line 176 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertTrue(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 176) )
  if (anyExceptions()) return
#line 177 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
      call new_periodic_solver(solver, elastic_kernel_t(), [4, 4], [1.0_dp, 0.0_dp], .false., error)
#line 178 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertTrue(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 178) )
  if (anyExceptions()) return
#line 179 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
      call new_periodic_solver(solver, elastic_kernel_t(), [8, 8], unit_periods, .false., error)
#line 180 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertFalse(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 180) )
  if (anyExceptions()) return
#line 181 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
      call solver%solve_load(wave(16, 16), 0.1_dp, tolerance, s, error)
#line 182 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertTrue(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 182) )
  if (anyExceptions()) return
#line 183 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
      call solver%solve_penetration(wave(16, 16), 0.1_dp, tolerance, s, error)
#line 184 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
  call assertTrue(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_surfaces.pf', &
 & 184) )
  if (anyExceptions()) return
#line 185 "/work/wt/penetration/tests/periodic/periodic_surfaces.pf"
   end subroutine test_rejections

end module periodic_surfaces

module Wrapperiodic_surfaces
   use FUnit
   use periodic_surfaces
   implicit none
   private

contains


end module Wrapperiodic_surfaces

function periodic_surfaces_suite() result(suite)
   use FUnit
   use periodic_surfaces
   use Wrapperiodic_surfaces
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('periodic_surfaces_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_many_surfaces', &
      test_many_surfaces))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_quarter_and_whole', &
      test_quarter_and_whole))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_shifted_and_turned', &
      test_shifted_and_turned))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_units', &
      test_units))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_line_and_surface', &
      test_line_and_surface))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_no_contact', &
      test_no_contact))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_out_of_range', &
      test_out_of_range))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_rejections', &
      test_rejections))
   call suite%addTest(t)


end function periodic_surfaces_suite


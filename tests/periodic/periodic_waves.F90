! Waves against Westergaard's solution and against the tables of the 2-D wave.
module periodic_waves
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_solver, only: periodic_solver_t, periodic_solution_t, new_periodic_solver, contact_solved
   use reference_table, only: table_t, read_table
   use trial_surfaces, only: line_wave, wave
   use funit
   implicit none (type, external)

   real(dp), parameter :: tolerance = 1.0e-10_dp
   real(dp), parameter :: unit_periods(2) = 1

contains

   !> A quarter of n by n cells of the 2-D wave, or half a period of n cells of the 1-D wave, under a load.
   subroutine press(n, is_line, load, solution)
      integer, intent(in) :: n
      logical, intent(in) :: is_line
      real(dp), intent(in) :: load
      type(periodic_solution_t), intent(out) :: solution
      type(periodic_solver_t) :: solver
      type(error_t), allocatable :: error

      call new_periodic_solver(solver, elastic_kernel_t(), [n, merge(1, n, is_line)], unit_periods, .true., error)
#line 27 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
  call assertFalse(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_waves.pf', &
 & 27) )
  if (anyExceptions()) return
#line 28 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
      if (is_line) then
         call solver%solve_load(line_wave(2*n, n), load, tolerance, solution, error)
      else
         call solver%solve_load(wave(2*n, n), load, tolerance, solution, error)
      end if
#line 33 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
  call assertFalse(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_waves.pf', &
 & 33) )
  if (anyExceptions()) return
#line 34 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
#line 34 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
  call assertEqual(contact_solved, solution%status, &
 & location=SourceLocation( &
 & 'periodic_waves.pf', &
 & 34) )
  if (anyExceptions()) return
#line 35 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
#line 35 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
  call assertLessThanOrEqual(solution%residual, tolerance, &
 & location=SourceLocation( &
 & 'periodic_waves.pf', &
 & 35) )
  if (anyExceptions()) return
#line 36 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
#line 36 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
  call assertEqual(load, sum(solution%pressure)/size(solution%pressure), tolerance=tolerance, &
 & location=SourceLocation( &
 & 'periodic_waves.pf', &
 & 36) )
  if (anyExceptions()) return
#line 37 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
   end subroutine press

   !> Pressure at the crest of the line, from the cells beside it, even about it.
   pure real(dp) function crest_pressure(pressure)
      real(dp), intent(in) :: pressure(:)

      crest_pressure = (9*pressure(1) - pressure(2))/8
   end function crest_pressure

   ! Edges of the contact lie within a cell; that moves the crest's pressure by less than 1e-7 where the contact has some hundred
   ! cells.
   !@test
   subroutine test_westergaard()
      type(table_t) :: table
      type(periodic_solution_t) :: solution
      real(dp) :: load
      integer :: row

      call read_table(table, 'yas_westergaard')
#line 56 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
  call assertGreaterThan(table%n_rows, 0, &
 & location=SourceLocation( &
 & 'periodic_waves.pf', &
 & 56) )
  if (anyExceptions()) return
#line 57 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
      do row = 1, table%n_rows
         load = table%number(row, 'pbar')
         call press(2048, .true., load, solution)
         associate (crest => crest_pressure(solution%pressure(:, 1)), width => table%number(row, '2a'))
#line 61 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
  call assertLessThanOrEqual(abs(width - solution%area%corrected), solution%area%error, message=table%label(row), &
 & location=SourceLocation( &
 & 'periodic_waves.pf', &
 & 61) )
  if (anyExceptions()) return
#line 62 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
            if (load < 0.04_dp) cycle
#line 63 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
  call assertEqual(table%number(row, 'p(0)'), crest, tolerance=1.0e-7_dp, message=table%label(row), &
 & location=SourceLocation( &
 & 'periodic_waves.pf', &
 & 63) )
  if (anyExceptions()) return
#line 64 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
         end associate
      end do
   end subroutine test_westergaard

   !@test
   subroutine test_westergaard_profile()
      real(dp), parameter :: pi = acos(-1.0_dp), load = 0.5_dp, edge = 0.25_dp
      integer, parameter :: n = 1024
      type(periodic_solution_t) :: solution
      real(dp) :: x(n/4)
      integer :: i

      call press(n, .true., load, solution)
      x = [((i - 0.5_dp)/(2*n), i=1, n/4)]
      ! half of the contact; at its edge the error is that of the grid, sqrt(dx)
      associate (p => 2*load*cos(pi*x)/sin(pi*edge)**2*sqrt(sin(pi*edge)**2 - sin(pi*x)**2))
#line 80 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
  call assertEqual(p, solution%pressure(:n/4, 1), tolerance=1.0e-6_dp, &
 & location=SourceLocation( &
 & 'periodic_waves.pf', &
 & 80) )
  if (anyExceptions()) return
#line 81 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
      end associate
   end subroutine test_westergaard_profile

   ! The tables' uncertainty of the area; the penetration and the largest pressure converge with the square of the cell.
   !@test
   subroutine test_area_table()
      integer, parameter :: n = 128
      real(dp), parameter :: discretisation = 1.0e-4_dp
      type(table_t) :: table
      type(periodic_solution_t) :: s
      integer :: row

      call read_table(table, 'bisine_area')
#line 94 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
  call assertGreaterThan(table%n_rows, 20, &
 & location=SourceLocation( &
 & 'periodic_waves.pf', &
 & 94) )
  if (anyExceptions()) return
#line 95 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
      do row = 1, table%n_rows
         call press(n, .false., table%number(row, 'p/p*'), s)
         associate (area => table%number(row, 'A/A0'), bound => table%number(row, 'uncertainty') + s%area%error)
#line 98 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
  call assertEqual(area, s%area%corrected, tolerance=bound, message=table%label(row), &
 & location=SourceLocation( &
 & 'periodic_waves.pf', &
 & 98) )
  if (anyExceptions()) return
#line 99 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
#line 99 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
  call assertLessThan(s%area%error, 1.0e-2_dp, &
 & location=SourceLocation( &
 & 'periodic_waves.pf', &
 & 99) )
  if (anyExceptions()) return
#line 100 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
         end associate
#line 101 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
  call assertEqual(table%number(row, 'mean pen'), s%penetration, tolerance=discretisation, message=table%label(row), &
 & location=SourceLocation( &
 & 'periodic_waves.pf', &
 & 101) )
  if (anyExceptions()) return
#line 102 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
#line 102 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
  call assertEqual(table%number(row, 'pmax'), maxval(s%pressure), tolerance=10*discretisation, message=table%label(row), &
 & location=SourceLocation( &
 & 'periodic_waves.pf', &
 & 102) )
  if (anyExceptions()) return
#line 103 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
      end do
   end subroutine test_area_table

   !@test
   subroutine test_area_of_512_cells()
      type(table_t) :: table
      type(periodic_solution_t) :: s
      integer :: row

      call read_table(table, 'bisine_area')
      do row = 1, table%n_rows, 4
         call press(256, .false., table%number(row, 'p/p*'), s)
#line 115 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
  call assertEqual(table%number(row, 'A/A0'), s%area%corrected, tolerance=3.0e-4_dp, message=table%label(row), &
 & location=SourceLocation( &
 & 'periodic_waves.pf', &
 & 115) )
  if (anyExceptions()) return
#line 116 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
      end do
   end subroutine test_area_of_512_cells

   ! Contacts of neighbouring summits merge where the cell on the line between them closes: 0.2286(1), area 0.4017(5).
   !@test
   subroutine test_merging()
      integer, parameter :: n = 128
      type(periodic_solution_t) :: s
      real(dp) :: low, high
      integer :: k

      low = 0.22_dp
      high = 0.24_dp
      do k = 1, 10
         call press(n, .false., (low + high)/2, s)
         if (s%gap(n, 1) > 0) low = (low + high)/2
         if (.not. s%gap(n, 1) > 0) high = (low + high)/2
      end do
#line 134 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
  call assertEqual(0.2286_dp, high, tolerance=1.5e-4_dp, &
 & location=SourceLocation( &
 & 'periodic_waves.pf', &
 & 134) )
  if (anyExceptions()) return
#line 135 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
#line 135 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
  call assertEqual(0.4017_dp, s%area%corrected, tolerance=1.5e-3_dp, &
 & location=SourceLocation( &
 & 'periodic_waves.pf', &
 & 135) )
  if (anyExceptions()) return
#line 136 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
   end subroutine test_merging

   ! The open area shrinks to (3/(2 pi)) (1 - p/p*); on the grid the last cell closes when its own full-contact pressure is
   ! positive.
   !@test
   subroutine test_full_contact_from_below()
      integer, parameter :: n = 128
      real(dp), parameter :: pi = acos(-1.0_dp)
      type(periodic_solution_t) :: s
      real(dp) :: distance, last
      integer :: k

      last = huge(last)
      do k = 1, 14
         distance = 10.0_dp**(-k/2.0_dp)
         call press(n, .false., 1 - distance, s)
#line 152 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
  call assertLessThan(sum(s%gap), last, &
 & location=SourceLocation( &
 & 'periodic_waves.pf', &
 & 152) )
  if (anyExceptions()) return
#line 153 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
#line 153 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
  call assertEqual(1 - 1.5_dp/pi*distance, s%area%corrected, tolerance=5*distance**2 + s%area%error, &
 & location=SourceLocation( &
 & 'periodic_waves.pf', &
 & 153) )
  if (anyExceptions()) return
#line 154 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
         if (all(s%gap <= 0)) exit
         last = sum(s%gap)
      end do
#line 157 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
  call assertEqual(1.0_dp, s%area%corrected, tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'periodic_waves.pf', &
 & 157) )
  if (anyExceptions()) return
#line 158 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
#line 158 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
  call assertLessThan(distance, 1.0e-3_dp, &
 & location=SourceLocation( &
 & 'periodic_waves.pf', &
 & 158) )
  if (anyExceptions()) return
#line 159 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
   end subroutine test_full_contact_from_below

   !@test
   subroutine test_full_contact()
      integer, parameter :: n = 32
      real(dp), parameter :: pi = acos(-1.0_dp), round_off = 1.0e-13_dp
      type(periodic_solution_t) :: s
      real(dp) :: c(n)
      integer :: i

      c = [(cos(pi*(i - 0.5_dp)/n), i=1, n)]
      call press(n, .false., 1.5_dp, s)
#line 171 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
  call assertEqual(1.5_dp + (spread(c, 2, n) + spread(c, 1, n))/2, s%pressure, tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_waves.pf', &
 & 171) )
  if (anyExceptions()) return
#line 172 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
#line 172 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
  call assertEqual(1/pi, s%penetration, tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_waves.pf', &
 & 172) )
  if (anyExceptions()) return
#line 173 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
#line 173 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
  call assertEqual(0, count(s%gap > 0), &
 & location=SourceLocation( &
 & 'periodic_waves.pf', &
 & 173) )
  if (anyExceptions()) return
#line 174 "/work/wt/penetration/tests/periodic/periodic_waves.pf"
   end subroutine test_full_contact

end module periodic_waves

module Wrapperiodic_waves
   use FUnit
   use periodic_waves
   implicit none
   private

contains


end module Wrapperiodic_waves

function periodic_waves_suite() result(suite)
   use FUnit
   use periodic_waves
   use Wrapperiodic_waves
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('periodic_waves_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_westergaard', &
      test_westergaard))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_westergaard_profile', &
      test_westergaard_profile))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_area_table', &
      test_area_table))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_area_of_512_cells', &
      test_area_of_512_cells))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_merging', &
      test_merging))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_full_contact_from_below', &
      test_full_contact_from_below))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_full_contact', &
      test_full_contact))
   call suite%addTest(t)


end function periodic_waves_suite


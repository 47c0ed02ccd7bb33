! The bi-sinusoidal wave where the contacts of its summits merge, by the table.
module periodic_wave_2d_merging
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_model_status, only: status_solved
   use reference_table, only: table_t, read_table
   use trial_case, only: trial_case_t, new_case
   use funit
   implicit none (type, external)

   integer, parameter :: cells = 256

contains

   !> Gap between two summits, over the amplitude, and area at a part of the pressure of full contact.
   subroutine solve_wave(relative_pressure, gap, area, error)
      real(dp), intent(in) :: relative_pressure
      real(dp), intent(out) :: gap, area, error
      type(trial_case_t) :: case
      real(dp), allocatable :: profiles(:, :, :)

      call new_case(case, 'wave_2d_elastic')
      call case%give('period', 1.0_dp)
      call case%give('amplitude', 1.0_dp)
      call case%give('contact_modulus', 1.0_dp)
      call case%give('mean_pressure', two_pi*relative_pressure)
      call case%give('cells', real(cells, dp))
      call case%give('profiles', 1.0_dp)
      call case%solve()
#line 30 "/work/wt/penetration/tests/periodic/periodic_wave_2d_merging.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'periodic_wave_2d_merging.pf', &
 & 30) )
  if (anyExceptions()) return
#line 31 "/work/wt/penetration/tests/periodic/periodic_wave_2d_merging.pf"
      call case%get_profiles(profiles)
      gap = profiles(cells/2, 1, 2)
      area = case%found('contact_fraction')
      error = case%found('contact_fraction_error')
   end subroutine solve_wave

   ! Open just below, closed just above: by the table's uncertainty, and as much again for these grids, the coarsest of the table's.
   !@test
   subroutine test_merging()
      type(table_t) :: table
      real(dp) :: pressure, allowed, gap, area, error

      call read_table(table, 'bisine_percolation')
#line 44 "/work/wt/penetration/tests/periodic/periodic_wave_2d_merging.pf"
  call assertEqual(3, table%n_rows, &
 & location=SourceLocation( &
 & 'periodic_wave_2d_merging.pf', &
 & 44) )
  if (anyExceptions()) return
#line 45 "/work/wt/penetration/tests/periodic/periodic_wave_2d_merging.pf"
      pressure = table%number(1, 'value')
      allowed = 2*table%number(1, 'uncertainty')
      call solve_wave(pressure - allowed, gap, area, error)
#line 48 "/work/wt/penetration/tests/periodic/periodic_wave_2d_merging.pf"
  call assertGreaterThan(gap, 0.0_dp, &
 & location=SourceLocation( &
 & 'periodic_wave_2d_merging.pf', &
 & 48) )
  if (anyExceptions()) return
#line 49 "/work/wt/penetration/tests/periodic/periodic_wave_2d_merging.pf"
      call solve_wave(pressure + allowed, gap, area, error)
#line 50 "/work/wt/penetration/tests/periodic/periodic_wave_2d_merging.pf"
  call assertEqual(0.0_dp, gap, &
 & location=SourceLocation( &
 & 'periodic_wave_2d_merging.pf', &
 & 50) )
  if (anyExceptions()) return
#line 51 "/work/wt/penetration/tests/periodic/periodic_wave_2d_merging.pf"
      call solve_wave(pressure, gap, area, error)
#line 52 "/work/wt/penetration/tests/periodic/periodic_wave_2d_merging.pf"
  call assertEqual(table%number(2, 'value'), area, tolerance=table%number(2, 'uncertainty') + error, &
 & location=SourceLocation( &
 & 'periodic_wave_2d_merging.pf', &
 & 52) )
  if (anyExceptions()) return
#line 53 "/work/wt/penetration/tests/periodic/periodic_wave_2d_merging.pf"
   end subroutine test_merging

end module periodic_wave_2d_merging

module Wrapperiodic_wave_2d_merging
   use FUnit
   use periodic_wave_2d_merging
   implicit none
   private

contains


end module Wrapperiodic_wave_2d_merging

function periodic_wave_2d_merging_suite() result(suite)
   use FUnit
   use periodic_wave_2d_merging
   use Wrapperiodic_wave_2d_merging
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('periodic_wave_2d_merging_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_merging', &
      test_merging))
   call suite%addTest(t)


end function periodic_wave_2d_merging_suite


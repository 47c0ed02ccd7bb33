! The model `wave_2d_elastic`: results in SI units, status, maps, and what is rejected.
module periodic_wave_2d_model
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: unset
   use adfric_model_status, only: status_solved, status_no_equilibrium
   use adfric_periodic_variables, only: r_mean_pressure, r_penetration, r_contact_fraction, r_contact_fraction_error, &
      r_peak_pressure, r_mean_gap, r_full_contact_pressure, r_contact_violation, n_periodic_variables, n_elastic_results
   use adfric_periodic_wave_2d_model, only: wave_2d_model_t, new_wave_2d_model, v_period, v_amplitude, v_cells, n_wave_2d_own
   use counting_sink, only: n_different_bits
   use reference_table, only: table_t, read_table
   use taken_profiles, only: taken_profiles_t
   use model_calls, only: axis_of
   use funit
   implicit none (type, external)

   real(dp), parameter :: pi = acos(-1.0_dp)
   real(dp), parameter :: period = 2.0e-5_dp, amplitude = 1.0e-7_dp, modulus = 3.0e9_dp, full = 2*pi*modulus*amplitude/period

   !> Places of the variables that come after the wave's own.
   integer, parameter :: v_relative_tolerance = 4, v_contact_modulus = 5, v_mean_pressure = 18, v_penetration = 19, &
      & v_profiles = 20
   integer, parameter :: n_variables = n_wave_2d_own + n_periodic_variables

contains

   !> The wave on 128 cells a period under a part of the pressure of full contact.
   function values_of(relative_pressure) result(values)
      real(dp), intent(in) :: relative_pressure
      real(dp) :: values(n_variables)

      values = unset
      values([v_period, v_amplitude, v_contact_modulus]) = [period, amplitude, modulus]
      values([v_mean_pressure, v_penetration]) = [relative_pressure*full, unset]
      values([v_cells, v_relative_tolerance, v_profiles]) = [128.0_dp, 1.0e-10_dp, 0.0_dp]
   end function values_of

   subroutine solve(values, results, status)
      real(dp), intent(in) :: values(:, :)
      real(dp), intent(out) :: results(:, :)
      integer, intent(out) :: status(:)
      type(wave_2d_model_t) :: model
      real(dp) :: counts(1)
      real(dp) :: error_estimate(size(status))

      call new_wave_2d_model(model)
      call model%solve_block(values, results, error_estimate, status, counts)
   end subroutine solve

   !@test
   subroutine test_table()
      integer, parameter :: n = 29
      type(table_t) :: table
      real(dp) :: values(n_variables, n), r(n_elastic_results, n)
      integer :: status(n), k

      call read_table(table, 'bisine_area')
#line 58 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertEqual(n, table%n_rows, &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 58) )
  if (anyExceptions()) return
#line 59 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
      do k = 1, n
         values(:, k) = values_of(table%number(k, 'p/p*'))
      end do
      call solve(values, r, status)
      do k = 1, n
#line 64 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertEqual(status_solved, status(k), &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 64) )
  if (anyExceptions()) return
#line 65 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
         associate (bound => table%number(k, 'uncertainty') + r(r_contact_fraction_error, k))
#line 66 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertEqual(table%number(k, 'A/A0'), r(r_contact_fraction, k), tolerance=bound, message=table%label(k), &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 66) )
  if (anyExceptions()) return
#line 67 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
         end associate
#line 68 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertRelativelyEqual(full, r(r_full_contact_pressure, k), tolerance=1.0e-14_dp, &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 68) )
  if (anyExceptions()) return
#line 69 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
#line 69 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertLessThanOrEqual(r(r_contact_violation, k), 1.0e-10_dp, &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 69) )
  if (anyExceptions()) return
#line 70 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
#line 70 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertRelativelyEqual(table%number(k, 'pmax')*full, r(r_peak_pressure, k), tolerance=1.0e-2_dp, &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 70) )
  if (anyExceptions()) return
#line 71 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
         associate (unit => full*period/modulus)
#line 72 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertRelativelyEqual(table%number(k, 'mean pen')*unit, r(r_penetration, k), tolerance=1.0e-2_dp, &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 72) )
  if (anyExceptions()) return
#line 73 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
#line 73 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertEqual(2*amplitude, r(r_penetration, k) + r(r_mean_gap, k), tolerance=1.0e-12_dp*amplitude, &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 73) )
  if (anyExceptions()) return
#line 74 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
         end associate
      end do
   end subroutine test_table

   ! Penetration instead of pressure; full contact has no higher one.
   !@test
   subroutine test_penetration()
      real(dp) :: values(n_variables, 2), r(n_elastic_results, 2), first(n_elastic_results, 1)
      integer :: status(2), status_first(1)

      values(:, 1) = values_of(0.3_dp)
      call solve(values(:, :1), first, status_first)
      values(v_mean_pressure, :) = unset
      values(:, 2) = values(:, 1)
      values(v_penetration, :) = [first(r_penetration, 1), 2.001_dp*amplitude]
      call solve(values, r, status)
#line 90 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertEqual([status_solved, status_no_equilibrium], status, &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 90) )
  if (anyExceptions()) return
#line 91 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
#line 91 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertRelativelyEqual(first(r_mean_pressure, 1), r(r_mean_pressure, 1), tolerance=1.0e-8_dp, &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 91) )
  if (anyExceptions()) return
#line 92 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
#line 92 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertEqual(first(r_contact_fraction, 1), r(r_contact_fraction, 1), &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 92) )
  if (anyExceptions()) return
#line 93 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
#line 93 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertIsNaN(r(r_contact_fraction, 2), &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 93) )
  if (anyExceptions()) return
#line 94 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
   end subroutine test_penetration

   !@test
   subroutine test_maps()
      type(wave_2d_model_t) :: model
      real(dp) :: values(n_variables), r(n_elastic_results, 1), maps(64, 64, 2)
      integer :: status(1)

      call new_wave_2d_model(model)
      values = values_of(0.2_dp)
      values(v_profiles) = 1
      call solve(reshape(values, [size(values), 1]), r, status)
      call model%solve_profiles(values, r(:, 1), maps)
#line 107 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertTrue(model%wants_profiles(values), &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 107) )
  if (anyExceptions()) return
#line 108 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
#line 108 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertRelativelyEqual(0.2_dp*full, sum(maps(:, :, 1))/64**2, tolerance=1.0e-9_dp, &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 108) )
  if (anyExceptions()) return
#line 109 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
#line 109 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertRelativelyEqual(r(r_mean_gap, 1), sum(maps(:, :, 2))/64**2, tolerance=1.0e-12_dp, &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 109) )
  if (anyExceptions()) return
#line 110 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
      associate (x => axis_of(model, values, 2))
#line 111 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertEqual(64, size(x), &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 111) )
  if (anyExceptions()) return
#line 112 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
#line 112 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertRelativelyEqual(period/2*127/128, x(64), tolerance=1.0e-14_dp, &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 112) )
  if (anyExceptions()) return
#line 113 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
      end associate
   end subroutine test_maps

   ! With maps a block has the same results; the maps are those of each point alone, and no more are made than are wanted.
   !@test
   subroutine test_maps_of_a_block()
      integer, parameter :: n = 4
      real(dp), parameter :: pressures(n) = [0.3_dp, -0.1_dp, 0.0_dp, 0.95_dp]
      type(wave_2d_model_t) :: model
      type(taken_profiles_t) :: receiver, first
      real(dp) :: counts(1)
      real(dp) :: values(n_variables, n), plain(n_elastic_results, n), r(n_elastic_results, n), errors(n), map(64, 64, 2)
      integer :: plain_status(n), status(n), k

      call new_wave_2d_model(model)
      do k = 1, n
         values(:, k) = values_of(pressures(k))
      end do
      call solve(values, plain, plain_status)
      allocate (receiver%kept(64, 64, 2, n), source=-1.0_dp)
      call model%solve_block_and_profiles(values, r, errors, status, counts, map, receiver)
#line 134 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertEqual([0, status_no_equilibrium, 0, 0], status, &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 134) )
  if (anyExceptions()) return
#line 135 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
#line 135 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertEqual(status, plain_status, &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 135) )
  if (anyExceptions()) return
#line 136 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
#line 136 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertEqual(0, sum(n_different_bits(plain, r)), &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 136) )
  if (anyExceptions()) return
#line 137 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
#line 137 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertEqual(3, receiver%n_taken, &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 137) )
  if (anyExceptions()) return
#line 138 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
      do k = 1, n
         map = -1
         if (status(k) == status_solved) call model%solve_profiles(values(:, k), r(:, k), map)
#line 141 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertEqual(0, sum(n_different_bits(map, receiver%kept(:, :, :, k))), &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 141) )
  if (anyExceptions()) return
#line 142 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
      end do
      first%most = 1
      call model%solve_block_and_profiles(values, r, errors, status, counts, map, first)
#line 145 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertEqual(1, first%n_taken, &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 145) )
  if (anyExceptions()) return
#line 146 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
   end subroutine test_maps_of_a_block

   !> How many problems the values have.
   integer function n_problems(values, swept)
      real(dp), intent(in) :: values(:)
      !> Place of a swept variable; 0: none.
      integer, intent(in) :: swept
      type(wave_2d_model_t) :: model
      type(problems_t) :: problems
      integer :: k

      call new_wave_2d_model(model)
      call model%check_values(values, [(k == swept, k=1, size(values))], problems)
      n_problems = problems%count()
   end function n_problems

   !@test
   subroutine test_rejections()
      real(dp) :: values(n_variables)
      type(wave_2d_model_t) :: model

      values = values_of(0.5_dp)
#line 168 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertEqual(0, n_problems(values, 0), &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 168) )
  if (anyExceptions()) return
#line 169 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
      values(v_profiles) = 1
#line 170 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertEqual(0, n_problems(values, v_mean_pressure), &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 170) )
  if (anyExceptions()) return
#line 171 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
#line 171 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertEqual(1, n_problems(values, v_period), &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 171) )
  if (anyExceptions()) return
#line 172 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
#line 172 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertEqual(1, n_problems(values, v_cells), &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 172) )
  if (anyExceptions()) return
#line 173 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
      call new_wave_2d_model(model)
#line 174 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertEqual(64, model%variables(v_cells)%multiple_of, &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 174) )
  if (anyExceptions()) return
#line 175 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
      values = values_of(0.5_dp)
      values(v_penetration) = amplitude
#line 177 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertEqual(1, n_problems(values, 0), &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 177) )
  if (anyExceptions()) return
#line 178 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
      values([v_penetration, v_mean_pressure]) = unset
#line 179 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertEqual(1, n_problems(values, 0), &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 179) )
  if (anyExceptions()) return
#line 180 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
      values = unset
      values([v_cells, v_profiles]) = [128.0_dp, 0.0_dp]
#line 182 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
  call assertEqual(4, n_problems(values, 0), &
 & location=SourceLocation( &
 & 'periodic_wave_2d_model.pf', &
 & 182) )
  if (anyExceptions()) return
#line 183 "/work/wt/penetration/tests/periodic/periodic_wave_2d_model.pf"
   end subroutine test_rejections

end module periodic_wave_2d_model

module Wrapperiodic_wave_2d_model
   use FUnit
   use periodic_wave_2d_model
   implicit none
   private

contains


end module Wrapperiodic_wave_2d_model

function periodic_wave_2d_model_suite() result(suite)
   use FUnit
   use periodic_wave_2d_model
   use Wrapperiodic_wave_2d_model
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('periodic_wave_2d_model_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_table', &
      test_table))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_penetration', &
      test_penetration))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_maps', &
      test_maps))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_maps_of_a_block', &
      test_maps_of_a_block))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_rejections', &
      test_rejections))
   call suite%addTest(t)


end function periodic_wave_2d_model_suite


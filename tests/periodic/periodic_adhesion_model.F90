! The models on an elastic half-space with adhesion: values in SI units, both branches, pull-off against the exact wave and the
! sphere, and what is refused.
module periodic_adhesion_model
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp
   use adfric_model_status, only: status_solved, status_no_equilibrium, status_not_converged
   use adfric_periodic_adhesive_pull_off, only: pull_off_t, find_pull_off
   use adfric_periodic_adhesive_solver, only: periodic_adhesion_t
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_solver, only: periodic_solver_t, new_periodic_solver
   use reference_table, only: table_t, read_table
   use counting_sink, only: n_different_bits
   use trial_case, only: trial_case_t, new_case
   use funit
   implicit none (type, external)

   real(dp), parameter :: pi = 3.14159265358979323846264338328_dp
   real(dp), parameter :: period = 1.0e-5_dp, amplitude = 1.0e-7_dp, modulus = 1.0e7_dp, full = 2*pi*modulus*amplitude/period
   integer, parameter :: adhered = 1, approach = 2

contains

   !> The wave with a stress and a range, in p* and D.
   subroutine new_wave(case, pressure, stress, range, scale)
      type(trial_case_t), intent(out) :: case
      real(dp), intent(in) :: pressure, stress, range
      !> Factors of the lengths and of the pressures.
      real(dp), intent(in) :: scale(2)

      call new_case(case, 'wave_2d_elastic')
      call case%give('period', scale(1)*period)
      call case%give('amplitude', scale(1)*amplitude)
      call case%give('contact_modulus', scale(2)*modulus)
      call case%give('cells', 64.0_dp)
      call case%give('mean_pressure', scale(2)*pressure*full)
      call case%give('stress', scale(2)*stress*full)
      call case%give('range', scale(1)*range*amplitude)
   end subroutine new_wave

   ! Results in SI units, and as they are in others; the energy of a state is what brought it there.
   !@test
   subroutine test_units()
      real(dp), parameter :: scale(2) = [3.7e4_dp, 2.3e-3_dp]
      type(trial_case_t) :: case, other
      character(*), parameter :: names(*) = [character(20) :: 'contact_fraction', 'adhesion_fraction', 'mean_pressure', &
         & 'peak_pressure', 'penetration', 'mean_gap', 'elastic_energy', 'adhesion_energy', 'cells_per_zone', 'regime']
      real(dp) :: factors(size(names)), low, high, load, zone
      integer :: k

      factors = [1.0_dp, 1.0_dp, scale(2), scale(2), scale(1), scale(1), product(scale), product(scale), 1.0_dp, 1.0_dp]
      call new_wave(case, 0.05_dp, 0.3_dp, 0.3_dp, [1.0_dp, 1.0_dp])
#line 53 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 53) )
  if (anyExceptions()) return
#line 54 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
      call case%solve()
      call new_wave(other, 0.05_dp, 0.3_dp, 0.3_dp, scale)
      call other%solve()
#line 57 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertEqual([status_solved, status_solved], [case%status(1), other%status(1)], &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 57) )
  if (anyExceptions()) return
#line 58 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
      do k = 1, size(names)
         associate (expected => factors(k)*case%found(trim(names(k))), found => other%found(trim(names(k))))
#line 60 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertRelativelyEqual(expected, found, tolerance=1.0e-8_dp, message=names(k), &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 60) )
  if (anyExceptions()) return
#line 61 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
         end associate
      end do
      ! pi E* h0/(4 p0) over l/64
      zone = pi*64*0.3_dp/(4*0.6_dp*pi)
#line 65 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertRelativelyEqual(zone, case%found('cells_per_zone'), tolerance=1.0e-12_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 65) )
  if (anyExceptions()) return
#line 66 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
#line 66 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertEqual(4.0_dp, case%found('regime'), &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 66) )
  if (anyExceptions()) return
#line 67 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
#line 67 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertIsNaN(case%found('pull_off_pressure'), &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 67) )
  if (anyExceptions()) return
#line 68 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
      ! energy: small steps of the load
      load = 0.05_dp*full
      call case%give('mean_pressure', 0.999_dp*load)
      call case%solve()
      low = case%found('elastic_energy') + case%found('adhesion_energy') - load*case%found('penetration')
      call case%give('mean_pressure', 1.001_dp*load)
      call case%solve()
      high = case%found('elastic_energy') + case%found('adhesion_energy') - load*case%found('penetration')
#line 76 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertEqual(low, high, tolerance=1.0e-3_dp*0.002_dp*load*case%found('penetration'), &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 76) )
  if (anyExceptions()) return
#line 77 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
   end subroutine test_units

   ! A surface energy in place of a range; no stress, and no group, to the same bits; a branch that is not there.
   !@test
   subroutine test_groups()
      type(trial_case_t) :: case, other

      call new_wave(case, 0.1_dp, 0.3_dp, 0.3_dp, [1.0_dp, 1.0_dp])
      call case%solve()
      other = case
      call other%give('range', huge(1.0_dp))
      call other%give('surface_energy', 0.3_dp*full*(0.3_dp*amplitude))
#line 89 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertEqual('', other%problems_of(), &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 89) )
  if (anyExceptions()) return
#line 90 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
      call other%solve()
#line 91 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertRelativelyEqual(case%found('penetration'), other%found('penetration'), tolerance=1.0e-9_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 91) )
  if (anyExceptions()) return
#line 92 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
      call other%give('surface_energy', huge(1.0_dp))
      call other%give('stress', 0.0_dp)
      call other%solve()
      call case%give('stress', huge(1.0_dp))
      call case%give('range', huge(1.0_dp))
      call case%solve()
#line 98 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertEqual(0, sum(n_different_bits(case%results, other%results)), &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 98) )
  if (anyExceptions()) return
#line 99 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
#line 99 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertEqual(1.0_dp, case%found('regime'), &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 99) )
  if (anyExceptions()) return
#line 100 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
#line 100 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertEqual(0.0_dp, case%found('adhesion_fraction'), &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 100) )
  if (anyExceptions()) return
#line 101 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
#line 101 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertEqual(0.0_dp, case%found('adhesion_energy'), &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 101) )
  if (anyExceptions()) return
#line 102 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
      call new_wave(case, -0.001_dp, 0.3_dp, 0.3_dp, [1.0_dp, 1.0_dp])
      call case%give('branch', real(approach, dp))
      call case%solve()
#line 105 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertEqual(status_no_equilibrium, case%status(1), &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 105) )
  if (anyExceptions()) return
#line 106 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
      call case%give('branch', real(adhered, dp))
      call case%solve()
#line 108 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 108) )
  if (anyExceptions()) return
#line 109 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
#line 109 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertLessThan(case%found('mean_pressure'), 0.0_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 109) )
  if (anyExceptions()) return
#line 110 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
   end subroutine test_groups

   ! Pull-off of the wave within the table; a load above it is carried, and one below is not; it does not depend on the load.
   !@test
   subroutine test_pull_off()
      type(trial_case_t) :: case
      real(dp) :: found

      call new_wave(case, 0.1_dp, 0.3_dp, 0.3_dp, [1.0_dp, 1.0_dp])
      call case%give('cells', 128.0_dp)
      call case%give('pull_off', 1.0_dp)
      call case%solve()
      found = case%found('pull_off_pressure')
#line 123 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertEqual(-0.01252_dp, found/full, tolerance=4.0e-5_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 123) )
  if (anyExceptions()) return
#line 124 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
      call case%give('mean_pressure', 0.98_dp*found)
      call case%solve()
#line 126 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 126) )
  if (anyExceptions()) return
#line 127 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
#line 127 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertEqual(found, case%found('pull_off_pressure'), tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 127) )
  if (anyExceptions()) return
#line 128 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
      call case%give('mean_pressure', 1.02_dp*found)
      call case%solve()
#line 130 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertEqual(status_no_equilibrium, case%status(1), &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 130) )
  if (anyExceptions()) return
#line 131 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
   end subroutine test_pull_off

   !> Pull-off of a line 1 - cos 2 pi x, brought together under no load, in p*; stress in p*.
   real(dp) function line_pull_off(n, stress, range) result(found)
      integer, intent(in) :: n
      real(dp), intent(in) :: stress, range
      type(periodic_solver_t) :: solver
      type(pull_off_t) :: pull_off
      type(error_t), allocatable :: error
      real(dp) :: shape(n, 1)
      integer :: i

      shape(:, 1) = [(1 - cos(2*pi*(i - 0.5_dp)/n), i=1, n)]
      shape = shape - minval(shape)
      call new_periodic_solver(solver, elastic_kernel_t(), [n, 1], [1.0_dp, 1.0_dp], .false., error)
#line 146 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertFalse(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 146) )
  if (anyExceptions()) return
#line 147 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
      call find_pull_off(solver, shape, periodic_adhesion_t(pi*stress, range, .true., .true., 0.0_dp), 1.0e-9_dp, pull_off, error)
#line 148 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertTrue(pull_off%is_found, &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 148) )
  if (anyExceptions()) return
#line 149 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
      found = pull_off%mean_pressure/pi
   end function line_pull_off

   ! The least load of partial contacts of the exact wave, with few cells in a zone and with many.
   !@test
   subroutine test_line()
      type(table_t) :: table
      real(dp) :: cells
      integer :: k, n, n_compared

      call read_table(table, 'adh_dugdale_wave_1d_events')
      n_compared = 0
      do k = 1, table%n_rows
         if (table%text(k, 'event') /= 'load_min') cycle
         ! from about 0.57 on no partial contact is stable under no load (Johnson 1995)
         if (table%number(k, 'alpha') > 0.56_dp) cycle
         n = 256
         cells = n*table%number(k, 'range')/(4*table%number(k, 'stress'))
         if (cells < 1) cycle
         associate (exact => table%number(k, 'mean_pressure'), found => line_pull_off(n, table%number(k, 'stress'), &
            & table%number(k, 'range')))
#line 170 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertRelativelyEqual(exact, found, tolerance=0.01_dp, message=table%label(k), &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 170) )
  if (anyExceptions()) return
#line 171 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
         end associate
         n_compared = n_compared + 1
      end do
#line 174 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertGreaterThan(n_compared, 3, &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 174) )
  if (anyExceptions()) return
#line 175 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
   end subroutine test_line

   ! A sphere in a cell of 17 to 33 times its contact, against the exact law of Maugis and Dugdale.
   !@test
   subroutine test_sphere()
      real(dp), parameter :: radius = 1, contact = 0.06_dp, lambdas(*) = [0.2_dp, 1.0_dp]
      integer, parameter :: n = 128
      type(table_t) :: table
      type(periodic_solver_t) :: solver
      type(periodic_adhesion_t) :: adhesion
      type(pull_off_t) :: pull_off
      type(error_t), allocatable :: error
      real(dp) :: shape(n, n), energy
      integer :: i, j, k, row

      call read_table(table, 'md_pulloff_vs_lambda')
      do j = 1, n
         shape(:, j) = [(((i - 0.5_dp)**2 + (j - 0.5_dp)**2)/(2*radius*(2*n)**2), i=1, n)]
      end do
      shape = shape - minval(shape)
      call new_periodic_solver(solver, elastic_kernel_t(), [n, n], [1.0_dp, 1.0_dp], .true., error)
      energy = 4*contact**3/(3*pi*radius**2)
      do k = 1, size(lambdas)
         adhesion = periodic_adhesion_t(stress=lambdas(k)/2*(16*pi*energy/(9*radius))**(1.0_dp/3), &
            & has_turned=.true.)
         adhesion%range = energy/adhesion%stress
         call find_pull_off(solver, shape, adhesion, 1.0e-9_dp, pull_off, error)
#line 202 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertTrue(pull_off%is_found, &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 202) )
  if (anyExceptions()) return
#line 203 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
         do row = 1, table%n_rows
            if (abs(table%number(row, 'lambda') - lambdas(k)) > 1.0e-9_dp) cycle
            associate (exact => table%number(row, 'Pc load control'), found => pull_off%mean_pressure/(pi*energy*radius))
#line 206 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertRelativelyEqual(exact, found, tolerance=0.005_dp, message=table%label(row), &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 206) )
  if (anyExceptions()) return
#line 207 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
            end associate
         end do
      end do
   end subroutine test_sphere

   ! Each thing that is refused.
   ! A turn whose state is not found to the tolerance is no turn: the point has not converged, or it is solved.
   !@test
   subroutine test_lost_turn()
      type(trial_case_t) :: case

      call new_case(case, 'wave_2d_elastic')
      call case%give('period', 1.0_dp)
      call case%give('amplitude', 1.0_dp)
      call case%give('contact_modulus', 1.0_dp)
      call case%give('cells', 256.0_dp)
      call case%give('relative_tolerance', 1.0e-13_dp)
      call case%give('stress', 1.0e-4_dp)
      call case%give('range', 0.5_dp)
      call case%give('turning_pressure', 1.0e-7_dp)
      call case%give('mean_pressure', -1.0e-6_dp)
#line 228 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 228) )
  if (anyExceptions()) return
#line 229 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
      call case%solve()
#line 230 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertTrue(any(case%status(1) == [status_not_converged, status_solved]), &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 230) )
  if (anyExceptions()) return
#line 231 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
      if (case%status(1) == status_not_converged) then
#line 232 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertTrue(ieee_is_nan(case%found('penetration')), &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 232) )
  if (anyExceptions()) return
#line 233 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
      end if
   end subroutine test_lost_turn

   !@test
   subroutine test_rejections()
      type(trial_case_t) :: case

      call new_wave(case, -0.1_dp, 0.3_dp, 0.3_dp, [1.0_dp, 1.0_dp])
#line 241 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 241) )
  if (anyExceptions()) return
#line 242 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
      call case%give('surface_energy', 1.0e-3_dp)
#line 243 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertTrue(index(case%problems_of(), 'surface_energy: stands beside range') > 0, &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 243) )
  if (anyExceptions()) return
#line 244 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
      call case%give('surface_energy', huge(1.0_dp))
      call case%give('turning_pressure', 1.0e3_dp)
      call case%give('branch', real(approach, dp))
#line 247 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertTrue(index(case%problems_of(), 'turning_pressure: has no meaning for branch') > 0, &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 247) )
  if (anyExceptions()) return
#line 248 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
      call new_wave(case, -0.1_dp, 0.3_dp, 0.3_dp, [1.0_dp, 1.0_dp])
      call case%give('stress', huge(1.0_dp))
      call case%give('range', huge(1.0_dp))
#line 251 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertTrue(index(case%problems_of(), 'mean_pressure: is below 0, but nothing pulls without &adhesion') > 0, &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 251) )
  if (anyExceptions()) return
#line 252 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
      call case%give('mean_pressure', 1.0_dp)
      call case%give('pull_off', 1.0_dp)
#line 254 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
  call assertTrue(index(case%problems_of(), 'pull_off: has no meaning without &adhesion') > 0, &
 & location=SourceLocation( &
 & 'periodic_adhesion_model.pf', &
 & 254) )
  if (anyExceptions()) return
#line 255 "/work/wt/penetration/tests/periodic/periodic_adhesion_model.pf"
   end subroutine test_rejections

end module periodic_adhesion_model

module Wrapperiodic_adhesion_model
   use FUnit
   use periodic_adhesion_model
   implicit none
   private

contains


end module Wrapperiodic_adhesion_model

function periodic_adhesion_model_suite() result(suite)
   use FUnit
   use periodic_adhesion_model
   use Wrapperiodic_adhesion_model
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('periodic_adhesion_model_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_units', &
      test_units))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_groups', &
      test_groups))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_pull_off', &
      test_pull_off))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_line', &
      test_line))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_sphere', &
      test_sphere))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_lost_turn', &
      test_lost_turn))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_rejections', &
      test_rejections))
   call suite%addTest(t)


end function periodic_adhesion_model_suite


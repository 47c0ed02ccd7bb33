! The model `surface_elastic`: a surface of given heights against the wave, moved, in other units, and what is rejected.
module periodic_surface_model
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_problems, only: problems_t
   use adfric_model_status, only: status_solved, status_not_converged, status_no_equilibrium
   use trial_case, only: trial_case_t, new_case
   use trial_surfaces, only: rough_surface, noise_surface
   use model_calls, only: axis_of
   use funit
   implicit none (type, external)

   real(dp), parameter :: modulus = 1.0e9_dp, length = 1.0e-5_dp
   !> Two solutions of the default tolerance, relative to their largest values.
   real(dp), parameter :: equal_solutions = 1.0e-8_dp

contains

   !> Hand over the heights as the program does; how many problems they have.
   integer function take(case, heights)
      type(trial_case_t), intent(inout) :: case
      real(dp), intent(in) :: heights(:, :)
      type(problems_t) :: problems

      call case%model%take_dataset(case%model%index_of('surface', 'heights'), heights, problems)
      if (problems%count() == 0) call case%give('heights', 1.0_dp)
      take = problems%count()
   end function take

   !> A surface with maps; the period along y is left out for a line.
   subroutine new_surface(case, heights, length_x, length_y)
      type(trial_case_t), intent(out) :: case
      real(dp), intent(in) :: heights(:, :)
      real(dp), intent(in) :: length_x, length_y

      call new_case(case, 'surface_elastic')
#line 38 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertEqual(0, take(case, heights), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 38) )
  if (anyExceptions()) return
#line 39 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
      call case%give('length_x', length_x)
      if (size(heights, 2) > 1) call case%give('length_y', length_y)
      call case%give('contact_modulus', modulus)
      call case%give('profiles', 1.0_dp)
   end subroutine new_surface

   !> The wave's summits in the middles of n by n cells.
   function wave_heights(n, amplitude) result(heights)
      integer, intent(in) :: n
      real(dp), intent(in) :: amplitude
      real(dp) :: heights(n, n)
      integer :: i

      heights = spread([(amplitude*cos(2*pi*(i - 0.5_dp)/n), i=1, n)], 1, n)
      heights = heights + transpose(heights)
   end function wave_heights

   ! The wave as 64 by 64 heights and as the model `wave_2d_elastic`, which knows its symmetry.
   !@test
   subroutine test_wave()
      real(dp), parameter :: amplitude = 1.0e-7_dp
      type(trial_case_t) :: surface, wave
      real(dp), allocatable :: maps(:, :, :), quarter(:, :, :)
      real(dp) :: offset, full
      integer :: k, j

      call new_surface(surface, wave_heights(64, amplitude), length, length)
      call new_case(wave, 'wave_2d_elastic')
      call wave%give('period', length)
      call wave%give('amplitude', amplitude)
      call wave%give('contact_modulus', modulus)
      call wave%give('cells', 64.0_dp)
      full = 2*pi*modulus*amplitude/length
      ! the crest stands half a cell beside the highest of the cells
      offset = 2*amplitude*(1 - cos(pi/64))
      do k = 1, 9, 2
         call surface%give('mean_pressure', 0.1_dp*k*full)
         call wave%give('mean_pressure', 0.1_dp*k*full)
#line 77 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertEqual('', surface%problems_of(), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 77) )
  if (anyExceptions()) return
#line 78 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
         call surface%solve()
         call wave%solve()
#line 80 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertEqual(status_solved, surface%status(1), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 80) )
  if (anyExceptions()) return
#line 81 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
#line 81 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertEqual(wave%found('contact_fraction'), surface%found('contact_fraction'), tolerance=10*epsilon(1.0_dp), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 81) )
  if (anyExceptions()) return
#line 82 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
#line 82 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertRelativelyEqual(wave%found('penetration') - offset, surface%found('penetration'), tolerance=equal_solutions, &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 82) )
  if (anyExceptions()) return
#line 83 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
#line 83 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertRelativelyEqual(wave%found('mean_gap'), surface%found('mean_gap'), tolerance=equal_solutions, &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 83) )
  if (anyExceptions()) return
#line 84 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
#line 84 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertLessThan(surface%error_estimate(1), 0.1_dp, &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 84) )
  if (anyExceptions()) return
#line 85 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
         call surface%get_profiles(maps)
         call wave%get_profiles(quarter)
         do j = 1, 2
            associate (tolerance => equal_solutions*maxval(quarter(:, :, j)))
#line 89 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertEqual(quarter(:, :, j), maps(:32, :32, j), tolerance=tolerance, &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 89) )
  if (anyExceptions()) return
#line 90 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
#line 90 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertEqual(quarter(:, :, j), maps(64:33:-1, 64:33:-1, j), tolerance=tolerance, &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 90) )
  if (anyExceptions()) return
#line 91 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
            end associate
         end do
#line 93 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertEqual(maxval(maps(:, :, 1)), surface%found('peak_pressure'), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 93) )
  if (anyExceptions()) return
#line 94 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
      end do
      ! on the cells the largest tension is that of a trough's four middle cells
#line 96 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertRelativelyEqual(full*cos(pi/64), surface%found('full_contact_pressure'), tolerance=equal_solutions, &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 96) )
  if (anyExceptions()) return
#line 97 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
   end subroutine test_wave

   ! Moved over the edges of the period, and lifted: the same results and the moved maps.
   !@test
   subroutine test_shift()
      type(trial_case_t) :: case, moved
      real(dp), allocatable :: maps(:, :, :), moved_maps(:, :, :)
      real(dp) :: heights(32, 48)
      integer :: k

      heights = -1.0e-6_dp*rough_surface(32, 48, 5)
      call new_surface(case, heights, length, 1.5_dp*length)
      call new_surface(moved, cshift(cshift(heights, 7, 1), -11, 2) + 1.0e-6_dp, length, 1.5_dp*length)
      call case%give('mean_pressure', 2.0e7_dp)
      call moved%give('mean_pressure', 2.0e7_dp)
      call case%solve()
      call moved%solve()
#line 114 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertEqual([status_solved, status_solved], [case%status, moved%status], &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 114) )
  if (anyExceptions()) return
#line 115 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
      call case%get_profiles(maps)
      call moved%get_profiles(moved_maps)
      do k = 1, 2
         associate (tolerance => equal_solutions*maxval(maps(:, :, k)))
#line 119 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertEqual(cshift(cshift(maps(:, :, k), 7, 1), -11, 2), moved_maps(:, :, k), tolerance=tolerance, &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 119) )
  if (anyExceptions()) return
#line 120 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
         end associate
      end do
#line 122 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertEqual(case%found('contact_fraction'), moved%found('contact_fraction'), tolerance=epsilon(1.0_dp), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 122) )
  if (anyExceptions()) return
#line 123 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
#line 123 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertRelativelyEqual(case%found('penetration'), moved%found('penetration'), tolerance=equal_solutions, &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 123) )
  if (anyExceptions()) return
#line 124 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
      associate (full => case%found('full_contact_pressure'))
#line 125 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertRelativelyEqual(full, moved%found('full_contact_pressure'), tolerance=equal_solutions, &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 125) )
  if (anyExceptions()) return
#line 126 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
      end associate
      associate (x => axis_of(case%model, case%values, 2), y => axis_of(case%model, case%values, 1))
#line 128 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertEqual([32, 48], [size(x), size(y)], &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 128) )
  if (anyExceptions()) return
#line 129 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
#line 129 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertRelativelyEqual(length*(1 - 0.5_dp/32), x(32), tolerance=10*epsilon(1.0_dp), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 129) )
  if (anyExceptions()) return
#line 130 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
#line 130 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertRelativelyEqual(1.5_dp*length/96, y(1), tolerance=10*epsilon(1.0_dp), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 130) )
  if (anyExceptions()) return
#line 131 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
      end associate
   end subroutine test_shift

   ! Lengths in nanometres and the modulus in other units: the same area, pressures and lengths in theirs.
   !@test
   subroutine test_other_units()
      real(dp), parameter :: metre = 1.0e9_dp, pascal = 1.0e-9_dp
      type(trial_case_t) :: case, other
      real(dp) :: heights(32, 32)

      heights = -1.0e-6_dp*rough_surface(32, 32, 6)
      call new_surface(case, heights, length, length)
      call new_surface(other, metre*heights, metre*length, metre*length)
      call case%give('mean_pressure', 5.0e6_dp)
      call other%give('mean_pressure', 5.0e6_dp*pascal)
      call other%give('contact_modulus', modulus*pascal)
      call case%solve()
      call other%solve()
#line 149 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertEqual(case%found('contact_fraction'), other%found('contact_fraction'), tolerance=epsilon(1.0_dp), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 149) )
  if (anyExceptions()) return
#line 150 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
#line 150 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertRelativelyEqual(metre*case%found('penetration'), other%found('penetration'), tolerance=equal_solutions, &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 150) )
  if (anyExceptions()) return
#line 151 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
#line 151 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertRelativelyEqual(pascal*case%found('peak_pressure'), other%found('peak_pressure'), tolerance=equal_solutions, &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 151) )
  if (anyExceptions()) return
#line 152 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
#line 152 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertRelativelyEqual(metre*case%found('mean_gap'), other%found('mean_gap'), tolerance=equal_solutions, &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 152) )
  if (anyExceptions()) return
#line 153 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
      ! penetration instead of pressure
      call other%give('mean_pressure', huge(1.0_dp))
      call other%give('penetration', metre*case%found('penetration'))
      call other%solve()
#line 157 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertRelativelyEqual(5.0e6_dp*pascal, other%found('mean_pressure'), tolerance=10*equal_solutions, &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 157) )
  if (anyExceptions()) return
#line 158 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
      call other%give('penetration', metre)
      call other%solve()
#line 160 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertEqual(status_no_equilibrium, other%status(1), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 160) )
  if (anyExceptions()) return
#line 161 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
   end subroutine test_other_units

   ! Below the pressure of full contact there is a gap, above it there is none; on cells that no coarser grid follows.
   !@test
   subroutine test_full_contact()
      type(trial_case_t) :: case
      real(dp) :: heights(15, 15), full

      heights = -1.0e-5_dp*noise_surface(15, 3)
      call new_surface(case, heights, length, length)
      call case%give('mean_pressure', 1.0e6_dp)
      call case%solve()
      full = case%found('full_contact_pressure')
      call case%give('mean_pressure', 0.999_dp*full)
      call case%solve()
#line 176 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 176) )
  if (anyExceptions()) return
#line 177 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
#line 177 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertGreaterThan(case%found('mean_gap'), 0.0_dp, &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 177) )
  if (anyExceptions()) return
#line 178 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
#line 178 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertLessThan(case%found('contact_fraction'), 1.0_dp, &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 178) )
  if (anyExceptions()) return
#line 179 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
      ! nothing tells the error of the area: it is anything up to the whole surface
#line 180 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertEqual(1.0_dp, case%found('contact_fraction_error'), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 180) )
  if (anyExceptions()) return
#line 181 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
#line 181 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertEqual(1.0_dp, case%error_estimate(1), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 181) )
  if (anyExceptions()) return
#line 182 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
#line 182 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertTrue(index(case%model%describe_case(case%values), 'multiples of 4, 32 at least') > 0, &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 182) )
  if (anyExceptions()) return
#line 183 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
      call case%give('mean_pressure', 1.001_dp*full)
      call case%solve()
#line 185 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertEqual(0.0_dp, case%found('mean_gap'), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 185) )
  if (anyExceptions()) return
#line 186 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
#line 186 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertEqual(1.0_dp, case%found('contact_fraction'), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 186) )
  if (anyExceptions()) return
#line 187 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
   end subroutine test_full_contact

   ! A line of heights is Westergaard's wave.
   !@test
   subroutine test_line()
      integer, parameter :: n = 1024
      real(dp), parameter :: amplitude = 1.0e-7_dp, full = pi*modulus*amplitude/length
      type(trial_case_t) :: case, wave
      integer :: i

      call new_surface(case, reshape([(amplitude*cos(2*pi*(i - 0.5_dp)/n), i=1, n)], [n, 1]), length, length)
      call new_case(wave, 'wave_1d')
      call wave%give('period', length)
      call wave%give('amplitude', amplitude)
      call wave%give('contact_modulus', modulus)
      call case%give('mean_pressure', 0.3_dp*full)
      call wave%give('mean_pressure', 0.3_dp*full)
#line 204 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 204) )
  if (anyExceptions()) return
#line 205 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
      call case%solve()
      call wave%solve()
      associate (exact => 2/pi*asin(sqrt(0.3_dp)))
#line 208 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertEqual(exact, case%found('contact_fraction'), tolerance=case%found('contact_fraction_error'), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 208) )
  if (anyExceptions()) return
#line 209 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
      end associate
      ! to the order 3/2 of the cell at the edge of contact
#line 211 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertRelativelyEqual(wave%found('mean_gap'), case%found('mean_gap'), tolerance=1.0e-4_dp, &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 211) )
  if (anyExceptions()) return
#line 212 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
      associate (y => axis_of(case%model, case%values, 1), x => axis_of(case%model, case%values, 2))
#line 213 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertEqual([1, n], [size(y), size(x)], &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 213) )
  if (anyExceptions()) return
#line 214 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
      end associate
   end subroutine test_line

   !> Is this one of the problems of a case?
   logical function says(case, text, swept)
      type(trial_case_t), intent(in) :: case
      character(*), intent(in) :: text
      character(*), intent(in), optional :: swept

      says = index(case%problems_of(swept), 'case: &surface '//text) > 0
   end function says

   !@test
   subroutine test_rejections()
      type(trial_case_t) :: case

      call new_case(case, 'surface_elastic')
#line 231 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertTrue(says(case, 'heights: is missing [m]'), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 231) )
  if (anyExceptions()) return
#line 232 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
#line 232 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertTrue(says(case, 'length_x: is missing [m]'), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 232) )
  if (anyExceptions()) return
#line 233 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
#line 233 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertFalse(says(case, 'length_y'), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 233) )
  if (anyExceptions()) return
#line 234 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
#line 234 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertEqual(1, take(case, 0*wave_heights(4, 1.0_dp) + 2), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 234) )
  if (anyExceptions()) return
#line 235 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
#line 235 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertEqual(0, take(case, wave_heights(4, 1.0_dp)), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 235) )
  if (anyExceptions()) return
#line 236 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
#line 236 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertTrue(says(case, 'length_y: is missing [m]'), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 236) )
  if (anyExceptions()) return
#line 237 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
      call case%give('length_x', 1.0_dp)
      call case%give('length_y', 1.0_dp)
#line 239 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertFalse(says(case, ''), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 239) )
  if (anyExceptions()) return
#line 240 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
      call case%give('length_y', 0.99e6_dp)
#line 241 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertFalse(says(case, ''), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 241) )
  if (anyExceptions()) return
#line 242 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
      call case%give('length_y', 1.01e-6_dp)
#line 243 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertFalse(says(case, ''), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 243) )
  if (anyExceptions()) return
#line 244 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
      call case%give('length_y', 1.01e6_dp)
#line 245 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertTrue(says(case, 'length_y: and length_x make cells more than 1e6 times as long as wide'), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 245) )
  if (anyExceptions()) return
#line 246 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
      ! a value of a sweep that nobody has looked at
      call case%give('mean_pressure', 1.0_dp)
      call case%give('contact_modulus', 1.0_dp)
      call case%solve()
#line 250 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertEqual(status_not_converged, case%status(1), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 250) )
  if (anyExceptions()) return
#line 251 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
      call case%give('length_y', 1.0_dp)
      call case%give('profiles', 1.0_dp)
#line 253 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertTrue(says(case, 'length_x: is swept', 'length_x'), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 253) )
  if (anyExceptions()) return
#line 254 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
#line 254 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertTrue(says(case, 'length_y: is swept', 'length_y'), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 254) )
  if (anyExceptions()) return
#line 255 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
#line 255 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertEqual(0, take(case, reshape(wave_heights(4, 1.0_dp), [16, 1])), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 255) )
  if (anyExceptions()) return
#line 256 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
#line 256 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
  call assertTrue(says(case, 'length_y: is given, but the heights have one dimension, x'), &
 & location=SourceLocation( &
 & 'periodic_surface_model.pf', &
 & 256) )
  if (anyExceptions()) return
#line 257 "/work/wt/penetration/tests/periodic/periodic_surface_model.pf"
   end subroutine test_rejections

end module periodic_surface_model

module Wrapperiodic_surface_model
   use FUnit
   use periodic_surface_model
   implicit none
   private

contains


end module Wrapperiodic_surface_model

function periodic_surface_model_suite() result(suite)
   use FUnit
   use periodic_surface_model
   use Wrapperiodic_surface_model
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('periodic_surface_model_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_wave', &
      test_wave))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_shift', &
      test_shift))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_other_units', &
      test_other_units))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_full_contact', &
      test_full_contact))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_line', &
      test_line))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_rejections', &
      test_rejections))
   call suite%addTest(t)


end function periodic_surface_model_suite


! SPDX-License-Identifier: GPL-3.0-or-later
! The sliding wave in SI units: the same case in other units, and to the other side.
module classical_sliding_wave_units
   use adfric_base_kinds, only: dp
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_material_prony, only: prony_t, new_prony
   use adfric_classical_sliding_wave_units, only: wave_slide_t, wave_slide_state_t, new_wave_slide
   use funit
   implicit none (type, external)

   real(dp), parameter :: closed_form = 100*epsilon(1.0_dp)

contains

   !> A wave of 1 mm length and 10 um amplitude on a rubber of 1 to 100 MPa.
   subroutine make_case(velocity, slide, length_unit, pressure_unit, time_unit)
      real(dp), intent(in) :: velocity
      type(wave_slide_t), intent(out) :: slide
      !> Units of length, pressure and time, in m, Pa and s.
      real(dp), intent(in) :: length_unit, pressure_unit, time_unit
      type(prony_t) :: prony
      logical :: is_possible

      call new_prony(prony, 1.0e6_dp/pressure_unit, [9.0e6_dp, 90.0e6_dp]/pressure_unit, [1.0e-3_dp, 1.0e-5_dp]/time_unit)
      call new_wave_slide(slide, 1.0e-3_dp/length_unit, 1.0e-5_dp/length_unit, prony, velocity*time_unit/length_unit, is_possible)
#line 26 "/work/main/tests/classical/classical_sliding_wave_units.pf"
  call assertTrue(is_possible, &
 & location=SourceLocation( &
 & 'classical_sliding_wave_units.pf', &
 & 26) )
  if (anyExceptions()) return
#line 27 "/work/main/tests/classical/classical_sliding_wave_units.pf"
   end subroutine make_case

   !@test
   subroutine test_units()
      type(wave_slide_t) :: slide, other
      type(wave_slide_state_t) :: state, again
      real(dp) :: x, p
      logical :: is_converged
      integer :: k
      real(dp), parameter :: lengths(3) = [1.0_dp, 1.0e-9_dp, 1.0e-3_dp], pressures(3) = [1.0e9_dp, 1.0e6_dp, 1.0_dp], &
         & times(3) = [1.0_dp, 1.0e-3_dp, 3600.0_dp]

      call make_case(0.5_dp, slide, 1.0_dp, 1.0_dp, 1.0_dp)
      call slide%solve_pressure(4.0e4_dp, state, is_converged)
#line 41 "/work/main/tests/classical/classical_sliding_wave_units.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'classical_sliding_wave_units.pf', &
 & 41) )
  if (anyExceptions()) return
#line 42 "/work/main/tests/classical/classical_sliding_wave_units.pf"
      x = state%contact_shift + 1.0e-5_dp
      do k = 1, 3
         call make_case(0.5_dp, other, lengths(k), pressures(k), times(k))
         call other%solve_pressure(4.0e4_dp/pressures(k), again, is_converged)
#line 46 "/work/main/tests/classical/classical_sliding_wave_units.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'classical_sliding_wave_units.pf', &
 & 46) )
  if (anyExceptions()) return
#line 47 "/work/main/tests/classical/classical_sliding_wave_units.pf"
#line 47 "/work/main/tests/classical/classical_sliding_wave_units.pf"
  call assertRelativelyEqual(state%left_edge, again%left_edge*lengths(k), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_wave_units.pf', &
 & 47) )
  if (anyExceptions()) return
#line 48 "/work/main/tests/classical/classical_sliding_wave_units.pf"
#line 48 "/work/main/tests/classical/classical_sliding_wave_units.pf"
  call assertRelativelyEqual(state%right_edge, again%right_edge*lengths(k), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_wave_units.pf', &
 & 48) )
  if (anyExceptions()) return
#line 49 "/work/main/tests/classical/classical_sliding_wave_units.pf"
#line 49 "/work/main/tests/classical/classical_sliding_wave_units.pf"
  call assertRelativelyEqual(state%penetration, again%penetration*lengths(k), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_wave_units.pf', &
 & 49) )
  if (anyExceptions()) return
#line 50 "/work/main/tests/classical/classical_sliding_wave_units.pf"
#line 50 "/work/main/tests/classical/classical_sliding_wave_units.pf"
  call assertRelativelyEqual(state%friction_stress, again%friction_stress*pressures(k), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_wave_units.pf', &
 & 50) )
  if (anyExceptions()) return
#line 51 "/work/main/tests/classical/classical_sliding_wave_units.pf"
#line 51 "/work/main/tests/classical/classical_sliding_wave_units.pf"
  call assertRelativelyEqual(state%friction_coefficient, again%friction_coefficient, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_wave_units.pf', &
 & 51) )
  if (anyExceptions()) return
#line 52 "/work/main/tests/classical/classical_sliding_wave_units.pf"
         p = other%pressure_at(again, x/lengths(k))*pressures(k)
#line 53 "/work/main/tests/classical/classical_sliding_wave_units.pf"
  call assertRelativelyEqual(slide%pressure_at(state, x), p, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_wave_units.pf', &
 & 53) )
  if (anyExceptions()) return
#line 54 "/work/main/tests/classical/classical_sliding_wave_units.pf"
         call other%solve_penetration(state%penetration/lengths(k), again, is_converged)
#line 55 "/work/main/tests/classical/classical_sliding_wave_units.pf"
  call assertRelativelyEqual(4.0e4_dp, again%mean_pressure*pressures(k), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_wave_units.pf', &
 & 55) )
  if (anyExceptions()) return
#line 56 "/work/main/tests/classical/classical_sliding_wave_units.pf"
      end do
   end subroutine test_units

   !@test
   subroutine test_mirror()
      type(wave_slide_t) :: slide, other
      type(wave_slide_state_t) :: state, again
      logical :: is_converged
      integer :: i
      real(dp) :: x

      call make_case(0.5_dp, slide, 1.0_dp, 1.0_dp, 1.0_dp)
      call make_case(-0.5_dp, other, 1.0_dp, 1.0_dp, 1.0_dp)
      call slide%solve_pressure(4.0e4_dp, state, is_converged)
      call other%solve_pressure(4.0e4_dp, again, is_converged)
#line 71 "/work/main/tests/classical/classical_sliding_wave_units.pf"
  call assertGreaterThan(state%contact_shift, 0.0_dp, &
 & location=SourceLocation( &
 & 'classical_sliding_wave_units.pf', &
 & 71) )
  if (anyExceptions()) return
#line 72 "/work/main/tests/classical/classical_sliding_wave_units.pf"
#line 72 "/work/main/tests/classical/classical_sliding_wave_units.pf"
  call assertGreaterThan(state%friction_stress, 0.0_dp, &
 & location=SourceLocation( &
 & 'classical_sliding_wave_units.pf', &
 & 72) )
  if (anyExceptions()) return
#line 73 "/work/main/tests/classical/classical_sliding_wave_units.pf"
#line 73 "/work/main/tests/classical/classical_sliding_wave_units.pf"
  call assertEqual(state%left_edge, -again%right_edge, &
 & location=SourceLocation( &
 & 'classical_sliding_wave_units.pf', &
 & 73) )
  if (anyExceptions()) return
#line 74 "/work/main/tests/classical/classical_sliding_wave_units.pf"
#line 74 "/work/main/tests/classical/classical_sliding_wave_units.pf"
  call assertEqual(state%right_edge, -again%left_edge, &
 & location=SourceLocation( &
 & 'classical_sliding_wave_units.pf', &
 & 74) )
  if (anyExceptions()) return
#line 75 "/work/main/tests/classical/classical_sliding_wave_units.pf"
#line 75 "/work/main/tests/classical/classical_sliding_wave_units.pf"
  call assertEqual(state%friction_stress, -again%friction_stress, &
 & location=SourceLocation( &
 & 'classical_sliding_wave_units.pf', &
 & 75) )
  if (anyExceptions()) return
#line 76 "/work/main/tests/classical/classical_sliding_wave_units.pf"
#line 76 "/work/main/tests/classical/classical_sliding_wave_units.pf"
  call assertEqual(state%friction_coefficient, -again%friction_coefficient, &
 & location=SourceLocation( &
 & 'classical_sliding_wave_units.pf', &
 & 76) )
  if (anyExceptions()) return
#line 77 "/work/main/tests/classical/classical_sliding_wave_units.pf"
#line 77 "/work/main/tests/classical/classical_sliding_wave_units.pf"
  call assertEqual(state%penetration, again%penetration, &
 & location=SourceLocation( &
 & 'classical_sliding_wave_units.pf', &
 & 77) )
  if (anyExceptions()) return
#line 78 "/work/main/tests/classical/classical_sliding_wave_units.pf"
      do i = -5, 5
         x = i*1.0e-4_dp
#line 80 "/work/main/tests/classical/classical_sliding_wave_units.pf"
  call assertEqual(slide%pressure_at(state, x), other%pressure_at(again, -x), &
 & location=SourceLocation( &
 & 'classical_sliding_wave_units.pf', &
 & 80) )
  if (anyExceptions()) return
#line 81 "/work/main/tests/classical/classical_sliding_wave_units.pf"
#line 81 "/work/main/tests/classical/classical_sliding_wave_units.pf"
  call assertEqual(slide%gap_at(state, x), other%gap_at(again, -x), &
 & location=SourceLocation( &
 & 'classical_sliding_wave_units.pf', &
 & 81) )
  if (anyExceptions()) return
#line 82 "/work/main/tests/classical/classical_sliding_wave_units.pf"
#line 82 "/work/main/tests/classical/classical_sliding_wave_units.pf"
  call assertEqual(slide%displacement_at(state, x), other%displacement_at(again, -x), &
 & location=SourceLocation( &
 & 'classical_sliding_wave_units.pf', &
 & 82) )
  if (anyExceptions()) return
#line 83 "/work/main/tests/classical/classical_sliding_wave_units.pf"
      end do
   end subroutine test_mirror

   ! The resistance at the threshold of full contact is k^2 D^2 E''/4 (units), and a velocity without end is refused.
   !@test
   subroutine test_ends()
      type(wave_slide_t) :: slide
      type(wave_slide_state_t) :: state
      type(prony_t) :: prony
      real(dp), parameter :: k = 6283.185307179586_dp
      real(dp) :: storage, loss
      logical :: is_possible, is_converged

      call make_case(0.5_dp, slide, 1.0_dp, 1.0_dp, 1.0_dp)
      call slide%full_contact(state)
      call new_prony(prony, 1.0e6_dp, [9.0e6_dp, 90.0e6_dp], [1.0e-3_dp, 1.0e-5_dp])
      call prony%get_complex_modulus(0.5_dp*k, storage, loss)
#line 100 "/work/main/tests/classical/classical_sliding_wave_units.pf"
  call assertRelativelyEqual((k*1.0e-5_dp)**2*loss/4, state%friction_stress, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_wave_units.pf', &
 & 100) )
  if (anyExceptions()) return
#line 101 "/work/main/tests/classical/classical_sliding_wave_units.pf"
#line 101 "/work/main/tests/classical/classical_sliding_wave_units.pf"
  call assertRelativelyEqual(k*1.0e-5_dp*hypot(storage, loss)/2, state%mean_pressure, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_wave_units.pf', &
 & 101) )
  if (anyExceptions()) return
#line 102 "/work/main/tests/classical/classical_sliding_wave_units.pf"
#line 102 "/work/main/tests/classical/classical_sliding_wave_units.pf"
  call assertEqual(1.0_dp, state%contact_fraction, &
 & location=SourceLocation( &
 & 'classical_sliding_wave_units.pf', &
 & 102) )
  if (anyExceptions()) return
#line 103 "/work/main/tests/classical/classical_sliding_wave_units.pf"
      call slide%solve_pressure(0.0_dp, state, is_converged)
#line 104 "/work/main/tests/classical/classical_sliding_wave_units.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'classical_sliding_wave_units.pf', &
 & 104) )
  if (anyExceptions()) return
#line 105 "/work/main/tests/classical/classical_sliding_wave_units.pf"
#line 105 "/work/main/tests/classical/classical_sliding_wave_units.pf"
  call assertTrue(ieee_is_nan(state%friction_coefficient), &
 & location=SourceLocation( &
 & 'classical_sliding_wave_units.pf', &
 & 105) )
  if (anyExceptions()) return
#line 106 "/work/main/tests/classical/classical_sliding_wave_units.pf"
      call slide%solve_pressure(-1.0_dp, state, is_converged)
#line 107 "/work/main/tests/classical/classical_sliding_wave_units.pf"
  call assertFalse(is_converged, &
 & location=SourceLocation( &
 & 'classical_sliding_wave_units.pf', &
 & 107) )
  if (anyExceptions()) return
#line 108 "/work/main/tests/classical/classical_sliding_wave_units.pf"
      call new_wave_slide(slide, 1.0e-3_dp, 1.0e-5_dp, prony, 1.0e120_dp, is_possible)
#line 109 "/work/main/tests/classical/classical_sliding_wave_units.pf"
  call assertFalse(is_possible, &
 & location=SourceLocation( &
 & 'classical_sliding_wave_units.pf', &
 & 109) )
  if (anyExceptions()) return
#line 110 "/work/main/tests/classical/classical_sliding_wave_units.pf"
   end subroutine test_ends

end module classical_sliding_wave_units

module Wrapclassical_sliding_wave_units
   use FUnit
   use classical_sliding_wave_units
   implicit none
   private

contains


end module Wrapclassical_sliding_wave_units

function classical_sliding_wave_units_suite() result(suite)
   use FUnit
   use classical_sliding_wave_units
   use Wrapclassical_sliding_wave_units
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('classical_sliding_wave_units_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_units', &
      test_units))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_mirror', &
      test_mirror))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_ends', &
      test_ends))
   call suite%addTest(t)


end function classical_sliding_wave_units_suite


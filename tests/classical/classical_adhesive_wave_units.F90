! SPDX-License-Identifier: GPL-3.0-or-later
! Profiles of the adhesive wave: means, the law of adhesion, the mean gap, energies as integrals; and the same case in other units.
module classical_adhesive_wave_units
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_classical_adhesive_wave_curve, only: adhesive_wave_t
   use adfric_classical_adhesive_wave_events, only: new_adhesive_wave
   use adfric_classical_adhesive_wave_load, only: branch_approach, branch_adhered
   use adfric_classical_adhesive_wave_penetration, only: state_of_penetration
   use adfric_classical_adhesive_wave_profile, only: adhesive_wave_pressure, adhesive_wave_gap
   use adfric_classical_adhesive_wave_state, only: wave_adhesion_t, regime_free, regime_no_contact, regime_zones
   use adfric_classical_adhesive_wave_units, only: wave_adhesion_case_t, wave_adhesion_state_t, new_wave_adhesion
   use funit
   implicit none (type, external)

   real(dp), parameter :: closed_form = 1.0e-12_dp

contains

   ! Means along the wave by the midpoint rule in places that crowd at the edges.
   !@test
   subroutine test_profiles()
      integer, parameter :: n = 2000
      real(dp), parameter :: stresses(5) = [0.3_dp, 0.6_dp, 3.0_dp, 0.1_dp, 0.3_dp], ranges(5) = [0.3_dp, 1.0_dp, 0.02_dp, 2.2_dp, &
         & 0.3_dp], penetrations(5) = [0.3_dp, -0.2_dp, 0.5_dp, -1.0_dp, -0.5_dp]
      type(adhesive_wave_t) :: wave
      type(wave_adhesion_t) :: state
      character(40) :: label
      real(dp) :: edges(4), v, x, weight, p, g, means(4)
      logical :: is_converged
      integer :: i, j, k

      do k = 1, 5
         call new_adhesive_wave(wave, stresses(k), ranges(k), is_converged)
         call state_of_penetration(wave, penetrations(k), branch_approach, state, is_converged)
         write (label, '(2i4)') k, state%regime
         edges = [0.0_dp, state%contact_half_width, state%cohesive_half_width, 0.5_dp]
         means = 0
         do i = 1, 3
            if (.not. edges(i + 1) > edges(i)) cycle
            do j = 1, n
               v = (j - 0.5_dp)/n
               x = edges(i) + (edges(i + 1) - edges(i))*v**2*(3 - 2*v)
               weight = 2*(edges(i + 1) - edges(i))*6*v*(1 - v)/n
               p = adhesive_wave_pressure(wave, state, x)
               g = adhesive_wave_gap(wave, state, x)
               if (i == 1) then
#line 48 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
  call assertTrue(p >= -wave%stress .and. g <= 0, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_units.pf', &
 & 48) )
  if (anyExceptions()) return
#line 49 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
               else if (i == 2) then
#line 50 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
  call assertEqual(-wave%stress, p, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_units.pf', &
 & 50) )
  if (anyExceptions()) return
#line 51 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
#line 51 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
  call assertTrue(g > -1.0e-14_dp .and. g <= wave%range + 1.0e-12_dp, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_units.pf', &
 & 51) )
  if (anyExceptions()) return
#line 52 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
               else
#line 53 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
  call assertEqual(0.0_dp, p, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_units.pf', &
 & 53) )
  if (anyExceptions()) return
#line 54 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
#line 54 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
  call assertTrue(g >= wave%range - 1.0e-12_dp .or. state%regime == regime_free, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_units.pf', &
 & 54) )
  if (anyExceptions()) return
#line 55 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
               end if
               means = means + weight*[p, g, p*(g - (1 - cos(2*pi*x)))/2, wave%stress*(min(g, wave%range) - wave%range)]
            end do
         end do
#line 59 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
  call assertEqual(state%mean_pressure, means(1), tolerance=1.0e-6_dp, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_units.pf', &
 & 59) )
  if (anyExceptions()) return
#line 60 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
#line 60 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
  call assertEqual(1 - state%penetration, means(2), tolerance=1.0e-6_dp, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_units.pf', &
 & 60) )
  if (anyExceptions()) return
#line 61 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
         ! (1/2) <(g - g0) (p - q)>, and the mean of g - g0 is -delta
         means(3) = means(3) + state%mean_pressure*state%penetration/2
#line 63 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
  call assertEqual(state%elastic_energy, means(3), tolerance=1.0e-6_dp, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_units.pf', &
 & 63) )
  if (anyExceptions()) return
#line 64 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
#line 64 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
  call assertEqual(state%adhesion_energy, means(4), tolerance=1.0e-6_dp, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_units.pf', &
 & 64) )
  if (anyExceptions()) return
#line 65 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
      end do
   end subroutine test_profiles

   ! The edge of cohesion has the gap h0 by the integral from the contact.
   !@test
   subroutine test_gap_at_edge()
      type(adhesive_wave_t) :: wave
      type(wave_adhesion_t) :: state
      logical :: is_converged
      real(dp) :: g
      integer :: k
      real(dp), parameter :: penetrations(4) = [-0.35_dp, -0.1_dp, 0.3_dp, 0.7_dp]

      call new_adhesive_wave(wave, 0.45_dp, 0.4_dp, is_converged)
      do k = 1, 4
         call state_of_penetration(wave, penetrations(k), branch_approach, state, is_converged)
         g = adhesive_wave_gap(wave, state, state%cohesive_half_width*(1 - 1.0e-15_dp))
#line 82 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
  call assertEqual(0.4_dp, g, tolerance=1.0e-12_dp, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_units.pf', &
 & 82) )
  if (anyExceptions()) return
#line 83 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
      end do
   end subroutine test_gap_at_edge

   ! Metres and nanometres, pascals and gigapascals.
   !@test
   subroutine test_units()
      type(wave_adhesion_case_t) :: this, other
      type(wave_adhesion_state_t) :: state, again
      logical :: is_possible, is_converged
      integer :: k
      real(dp) :: l, p, turned
      real(dp), parameter :: lengths(3) = [1.0_dp, 1.0e-9_dp, 1.0e-3_dp], pressures(3) = [1.0e9_dp, 1.0e6_dp, 1.0_dp]

      call new_wave_adhesion(this, 1.0e-5_dp, 1.0e-7_dp, 1.0e9_dp, 1.0e7_dp, 3.0e-8_dp, is_possible, is_converged)
#line 97 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
  call assertTrue(is_possible .and. is_converged, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_units.pf', &
 & 97) )
  if (anyExceptions()) return
#line 98 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
      ! alpha^2 = 2 w l/(pi^2 E* D^2)
#line 99 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
  call assertRelativelyEqual(sqrt(2*0.3_dp*1.0e-5_dp/(pi**2*1.0e9_dp*1.0e-14_dp)), this%alpha, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_units.pf', &
 & 99) )
  if (anyExceptions()) return
#line 100 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
      call this%solve_pressure(5.0e6_dp, branch_approach, state, is_converged)
#line 101 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
  call assertTrue(state%regime == regime_zones, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_units.pf', &
 & 101) )
  if (anyExceptions()) return
#line 102 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
      do k = 1, 3
         l = lengths(k)
         p = pressures(k)
         call new_wave_adhesion(other, 1.0e-5_dp/l, 1.0e-7_dp/l, 1.0e9_dp/p, 1.0e7_dp/p, 3.0e-8_dp/l, is_possible, is_converged)
#line 106 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
  call assertTrue(is_possible .and. is_converged, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_units.pf', &
 & 106) )
  if (anyExceptions()) return
#line 107 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
         call other%solve_pressure(5.0e6_dp/p, branch_approach, again, is_converged)
#line 108 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
  call assertRelativelyEqual(state%penetration, again%penetration*l, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_units.pf', &
 & 108) )
  if (anyExceptions()) return
#line 109 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
#line 109 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
  call assertRelativelyEqual(state%contact_fraction, again%contact_fraction, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_units.pf', &
 & 109) )
  if (anyExceptions()) return
#line 110 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
#line 110 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
  call assertRelativelyEqual(state%crest_pressure, again%crest_pressure*p, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_units.pf', &
 & 110) )
  if (anyExceptions()) return
#line 111 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
#line 111 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
  call assertRelativelyEqual(state%valley_gap, again%valley_gap*l, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_units.pf', &
 & 111) )
  if (anyExceptions()) return
#line 112 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
#line 112 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
  call assertRelativelyEqual(state%elastic_energy, again%elastic_energy*p*l, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_units.pf', &
 & 112) )
  if (anyExceptions()) return
#line 113 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
#line 113 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
  call assertRelativelyEqual(this%pull_off_pressure(), other%pull_off_pressure()*p, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_units.pf', &
 & 113) )
  if (anyExceptions()) return
#line 114 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
         turned = other%pull_off_pressure(1.0e6_dp/p)
#line 115 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
  call assertRelativelyEqual(this%pull_off_pressure(1.0e6_dp), turned*p, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_units.pf', &
 & 115) )
  if (anyExceptions()) return
#line 116 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
#line 116 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
  call assertRelativelyEqual(this%zone_length, other%zone_length*l, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_units.pf', &
 & 116) )
  if (anyExceptions()) return
#line 117 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
         turned = other%gap_at(again, 3.0e-6_dp/l)
#line 118 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
  call assertRelativelyEqual(this%gap_at(state, 3.0e-6_dp), turned*l, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_units.pf', &
 & 118) )
  if (anyExceptions()) return
#line 119 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
         call other%solve_penetration(state%penetration/l, branch_adhered, again, is_converged, 1.0e6_dp/p)
#line 120 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
  call assertRelativelyEqual(5.0e6_dp, again%mean_pressure*p, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_units.pf', &
 & 120) )
  if (anyExceptions()) return
#line 121 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
         turned = other%pressure_at(again, 1.0e-6_dp/l)
#line 122 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
  call assertRelativelyEqual(this%pressure_at(state, 1.0e-6_dp), turned*p, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_units.pf', &
 & 122) )
  if (anyExceptions()) return
#line 123 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
      end do
      call new_wave_adhesion(other, 1.0_dp, 1.0_dp, 1.0_dp, 1.0e-20_dp, 1.0_dp, is_possible, is_converged)
#line 125 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
  call assertTrue(.not. is_possible, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_units.pf', &
 & 125) )
  if (anyExceptions()) return
#line 126 "/work/main/tests/classical/classical_adhesive_wave_units.pf"
   end subroutine test_units

end module classical_adhesive_wave_units

module Wrapclassical_adhesive_wave_units
   use FUnit
   use classical_adhesive_wave_units
   implicit none
   private

contains


end module Wrapclassical_adhesive_wave_units

function classical_adhesive_wave_units_suite() result(suite)
   use FUnit
   use classical_adhesive_wave_units
   use Wrapclassical_adhesive_wave_units
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('classical_adhesive_wave_units_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_profiles', &
      test_profiles))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_gap_at_edge', &
      test_gap_at_edge))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_units', &
      test_units))
   call suite%addTest(t)


end function classical_adhesive_wave_units_suite


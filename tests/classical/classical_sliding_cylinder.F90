! SPDX-License-Identifier: GPL-3.0-or-later
! The cylinder that slides over a viscoelastic half-plane: the table, Hertz's contacts at both ends, its equilibrium, and the wave.
module classical_sliding_cylinder
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_material_prony, only: prony_t, new_prony
   use adfric_classical_sliding_solid, only: sliding_solid_t
   use adfric_classical_sliding_cylinder, only: cylinder_contact_t, cylinder_of_width, cylinder_of_load
   use adfric_classical_sliding_cylinder_profile, only: sliding_cylinder_pressure, sliding_cylinder_gap
   use adfric_classical_sliding_cylinder_units, only: cylinder_slide_t, cylinder_slide_state_t, new_cylinder_slide
   use adfric_classical_sliding_wave, only: wave_contact_t, wave_of_width
   use adfric_classical_sliding_wave_profile, only: sliding_wave_pressure, sliding_wave_gap
   use adfric_classical_hertz_line, only: line_contact_t, line_of_load, line_pressure, line_gap
   use reference_table, only: table_t, read_table
   use sliding_cases, only: solid_of
   use funit
   implicit none (type, external)

   real(dp), parameter :: closed_form = 100*epsilon(1.0_dp)

contains

   ! Hunter's solution for one arm, by other hands.
   !@test
   subroutine test_table()
      type(table_t) :: table
      type(cylinder_contact_t) :: contact
      type(sliding_solid_t) :: solid
      real(dp) :: length, load_ratio
      logical :: is_converged
      integer :: row

      call read_table(table, 'visco_cylinder_sls')
#line 35 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertEqual(20, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 35) )
  if (anyExceptions()) return
#line 36 "/work/main/tests/classical/classical_sliding_cylinder.pf"
      do row = 1, table%n_rows
         length = table%number(row, 'L')
         load_ratio = table%number(row, 'load_ratio')
         solid = solid_of([table%number(row, 'r') - 1], [1.0_dp], 1.0_dp)
         call cylinder_of_load(solid, load_ratio*length**2, contact, is_converged)
#line 41 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 41) )
  if (anyExceptions()) return
#line 42 "/work/main/tests/classical/classical_sliding_cylinder.pf"
#line 42 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertRelativelyEqual(length, contact%half_width, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 42) )
  if (anyExceptions()) return
#line 43 "/work/main/tests/classical/classical_sliding_cylinder.pf"
#line 43 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertRelativelyEqual(load_ratio, contact%load_ratio, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 43) )
  if (anyExceptions()) return
#line 44 "/work/main/tests/classical/classical_sliding_cylinder.pf"
#line 44 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertRelativelyEqual(table%number(row, 'centre'), contact%shift%shift, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 44) )
  if (anyExceptions()) return
#line 45 "/work/main/tests/classical/classical_sliding_cylinder.pf"
#line 45 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertRelativelyEqual(table%number(row, 'leading'), contact%shift%shift + 1, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 45) )
  if (anyExceptions()) return
#line 46 "/work/main/tests/classical/classical_sliding_cylinder.pf"
#line 46 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertEqual(table%number(row, 'trailing'), contact%shift%shift - 1, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 46) )
  if (anyExceptions()) return
#line 47 "/work/main/tests/classical/classical_sliding_cylinder.pf"
#line 47 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertRelativelyEqual(table%number(row, 'mu'), contact%friction_ratio, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 47) )
  if (anyExceptions()) return
#line 48 "/work/main/tests/classical/classical_sliding_cylinder.pf"
      end do
   end subroutine test_table

   ! Load and moment of the pressure: W = int p dx and T = int p x dx/R; sums over an angle, whose midpoints miss no power.
   !@test
   subroutine test_equilibrium()
      integer, parameter :: n = 1000
      real(dp), parameter :: sums = 1.0e-12_dp
      type(cylinder_contact_t) :: contact
      type(sliding_solid_t) :: solid
      real(dp) :: theta, x, p, load, moment
      logical :: is_converged
      integer :: i, k

      do k = -3, 3
         solid = solid_of([3.0_dp, 6.0_dp, 20.0_dp], [1.0_dp, 0.1_dp, 0.05_dp], 1.0_dp)
         call cylinder_of_width(solid, 10.0_dp**k, contact, is_converged)
#line 65 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 65) )
  if (anyExceptions()) return
#line 66 "/work/main/tests/classical/classical_sliding_cylinder.pf"
         load = 0
         moment = 0
         do i = 1, n
            theta = pi*(i - 0.5_dp)/n
            x = contact%shift%shift - cos(theta)
            p = sliding_cylinder_pressure(contact, x)*sin(theta)*(pi/n)
            load = load + p
            moment = moment + p*x
         end do
         ! pressures are in E0 w/(2 R)
#line 76 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertRelativelyEqual(pi/2*contact%load_ratio, load, tolerance=sums, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 76) )
  if (anyExceptions()) return
#line 77 "/work/main/tests/classical/classical_sliding_cylinder.pf"
#line 77 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertEqual(contact%friction_ratio, moment/load, tolerance=sums, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 77) )
  if (anyExceptions()) return
#line 78 "/work/main/tests/classical/classical_sliding_cylinder.pf"
      end do
   end subroutine test_equilibrium

   ! A contact that is narrow beside the wave is that of a cylinder with the radius 1/(k^2 D), to the order of its width.
   !@test
   subroutine test_narrow_wave()
      real(dp), parameter :: width = 1.0e-5_dp, order = 100*width
      type(cylinder_contact_t) :: contact
      type(wave_contact_t) :: wave
      type(sliding_solid_t) :: solid
      real(dp) :: x, p, g
      logical :: is_converged
      integer :: k, i

      do k = -2, 1
         solid = solid_of([9.0_dp, 50.0_dp], [1.0_dp, 0.1_dp], 1.0_dp)
         call cylinder_of_width(solid, 10.0_dp**(-k), contact, is_converged)
         solid = solid_of([9.0_dp, 50.0_dp], [1.0_dp, 0.1_dp], width*10.0_dp**k)
         call wave_of_width(solid, log(tan(width/2)), wave, is_converged)
#line 97 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 97) )
  if (anyExceptions()) return
#line 98 "/work/main/tests/classical/classical_sliding_cylinder.pf"
#line 98 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertRelativelyEqual(contact%load_ratio, wave%mean_pressure*4/width**2, tolerance=order, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 98) )
  if (anyExceptions()) return
#line 99 "/work/main/tests/classical/classical_sliding_cylinder.pf"
#line 99 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertRelativelyEqual(contact%shift%shift, wave%shift%shift/width, tolerance=order, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 99) )
  if (anyExceptions()) return
#line 100 "/work/main/tests/classical/classical_sliding_cylinder.pf"
#line 100 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertRelativelyEqual(contact%friction_ratio, wave%friction/wave%mean_pressure/width, tolerance=order, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 100) )
  if (anyExceptions()) return
#line 101 "/work/main/tests/classical/classical_sliding_cylinder.pf"
         do i = -4, 4
            x = contact%shift%shift + 0.4_dp*i
            p = sliding_wave_pressure(solid, wave, x*width)/width
            g = sliding_wave_gap(solid, wave, x*width)/width**2
#line 105 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertEqual(p, sliding_cylinder_pressure(contact, x), tolerance=order*p, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 105) )
  if (anyExceptions()) return
#line 106 "/work/main/tests/classical/classical_sliding_cylinder.pf"
#line 106 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertEqual(g, sliding_cylinder_gap(contact, x), tolerance=order*g, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 106) )
  if (anyExceptions()) return
#line 107 "/work/main/tests/classical/classical_sliding_cylinder.pf"
         end do
      end do
   end subroutine test_narrow_wave

   ! At rest, slowly and fast: Hertz's contact with the relaxed and the instantaneous modulus.
   !@test
   subroutine test_hertz()
      type(cylinder_slide_t) :: slide
      type(cylinder_slide_state_t) :: state
      type(line_contact_t) :: hertz
      type(prony_t) :: prony
      real(dp) :: x, near
      logical :: is_possible, is_converged
      integer :: k
      real(dp), parameter :: radius = 0.05_dp, load = 300, speeds(4) = [0.0_dp, 1.0e-14_dp, -1.0e-14_dp, 1.0e13_dp]

      call new_prony(prony, 1.0e6_dp, [9.0e6_dp, 20.0e6_dp], [1.0_dp, 2.0_dp])
      do k = 1, 4
         call new_cylinder_slide(slide, radius, prony, speeds(k), is_possible)
#line 126 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertTrue(is_possible, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 126) )
  if (anyExceptions()) return
#line 127 "/work/main/tests/classical/classical_sliding_cylinder.pf"
         call slide%solve_load(load, state, is_converged)
#line 128 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 128) )
  if (anyExceptions()) return
#line 129 "/work/main/tests/classical/classical_sliding_cylinder.pf"
         hertz = line_of_load(radius, merge(30.0e6_dp, 1.0e6_dp, speeds(k) > 1), load)
         near = 1.0e-9_dp
#line 131 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertRelativelyEqual(hertz%half_width, state%half_width, tolerance=near, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 131) )
  if (anyExceptions()) return
#line 132 "/work/main/tests/classical/classical_sliding_cylinder.pf"
#line 132 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertEqual(0.0_dp, state%contact_shift, tolerance=near*hertz%half_width, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 132) )
  if (anyExceptions()) return
#line 133 "/work/main/tests/classical/classical_sliding_cylinder.pf"
#line 133 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertEqual(0.0_dp, state%friction_coefficient, tolerance=near, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 133) )
  if (anyExceptions()) return
#line 134 "/work/main/tests/classical/classical_sliding_cylinder.pf"
         x = hertz%half_width/2
#line 135 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertRelativelyEqual(line_pressure(hertz, x), slide%pressure_at(state, x), tolerance=near, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 135) )
  if (anyExceptions()) return
#line 136 "/work/main/tests/classical/classical_sliding_cylinder.pf"
#line 136 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertRelativelyEqual(line_gap(hertz, 3*x), slide%gap_at(state, 3*x), tolerance=near, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 136) )
  if (anyExceptions()) return
#line 137 "/work/main/tests/classical/classical_sliding_cylinder.pf"
#line 137 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertRelativelyEqual(line_gap(hertz, 5*x), slide%gap_at(state, -5*x), tolerance=near, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 137) )
  if (anyExceptions()) return
#line 138 "/work/main/tests/classical/classical_sliding_cylinder.pf"
      end do
   end subroutine test_hertz

   ! To the other side all is mirrored; other units change nothing.
   !@test
   subroutine test_mirror_and_units()
      type(cylinder_slide_t) :: slide, other
      type(cylinder_slide_state_t) :: state, again
      type(prony_t) :: prony
      logical :: is_possible, is_converged
      real(dp), parameter :: length = 1.0e-9_dp, pressure = 1.0e9_dp, time = 3600
      real(dp) :: x, p

      call new_prony(prony, 1.0e6_dp, [9.0e6_dp, 20.0e6_dp], [1.0_dp, 2.0_dp])
      call new_cylinder_slide(slide, 0.05_dp, prony, 1.0e-3_dp, is_possible)
      call slide%solve_load(300.0_dp, state, is_converged)
#line 154 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 154) )
  if (anyExceptions()) return
#line 155 "/work/main/tests/classical/classical_sliding_cylinder.pf"
#line 155 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertGreaterThan(state%friction_force, 0.0_dp, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 155) )
  if (anyExceptions()) return
#line 156 "/work/main/tests/classical/classical_sliding_cylinder.pf"
#line 156 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertRelativelyEqual(state%load*state%friction_coefficient, state%friction_force, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 156) )
  if (anyExceptions()) return
#line 157 "/work/main/tests/classical/classical_sliding_cylinder.pf"
      call new_cylinder_slide(other, 0.05_dp, prony, -1.0e-3_dp, is_possible)
      call other%solve_load(300.0_dp, again, is_converged)
#line 159 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertEqual(state%left_edge, -again%right_edge, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 159) )
  if (anyExceptions()) return
#line 160 "/work/main/tests/classical/classical_sliding_cylinder.pf"
#line 160 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertEqual(state%right_edge, -again%left_edge, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 160) )
  if (anyExceptions()) return
#line 161 "/work/main/tests/classical/classical_sliding_cylinder.pf"
#line 161 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertEqual(state%friction_force, -again%friction_force, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 161) )
  if (anyExceptions()) return
#line 162 "/work/main/tests/classical/classical_sliding_cylinder.pf"
      x = state%contact_shift + state%half_width/3
#line 163 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertEqual(slide%pressure_at(state, x), other%pressure_at(again, -x), &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 163) )
  if (anyExceptions()) return
#line 164 "/work/main/tests/classical/classical_sliding_cylinder.pf"
#line 164 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertEqual(slide%gap_at(state, 3*x), other%gap_at(again, -3*x), &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 164) )
  if (anyExceptions()) return
#line 165 "/work/main/tests/classical/classical_sliding_cylinder.pf"
      call new_prony(prony, 1.0e6_dp/pressure, [9.0e6_dp, 20.0e6_dp]/pressure, [1.0_dp, 2.0_dp]/time)
      call new_cylinder_slide(other, 0.05_dp/length, prony, 1.0e-3_dp/length*time, is_possible)
      call other%solve_load(300.0_dp/(pressure*length), again, is_converged)
#line 168 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertRelativelyEqual(state%right_edge, again%right_edge*length, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 168) )
  if (anyExceptions()) return
#line 169 "/work/main/tests/classical/classical_sliding_cylinder.pf"
#line 169 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertRelativelyEqual(state%friction_coefficient, again%friction_coefficient, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 169) )
  if (anyExceptions()) return
#line 170 "/work/main/tests/classical/classical_sliding_cylinder.pf"
      p = other%pressure_at(again, x/length)*pressure
#line 171 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertRelativelyEqual(slide%pressure_at(state, x), p, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 171) )
  if (anyExceptions()) return
#line 172 "/work/main/tests/classical/classical_sliding_cylinder.pf"
   end subroutine test_mirror_and_units

   ! No load makes no contact; a tension and a speed beyond all bounds are refused.
   !@test
   subroutine test_rejections()
      type(cylinder_slide_t) :: slide
      type(cylinder_slide_state_t) :: state
      type(prony_t) :: prony
      logical :: is_possible, is_converged

      call new_prony(prony, 1.0e6_dp, [9.0e6_dp], [1.0_dp])
      call new_cylinder_slide(slide, 0.05_dp, prony, 1.0_dp, is_possible)
      call slide%solve_load(0.0_dp, state, is_converged)
#line 185 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 185) )
  if (anyExceptions()) return
#line 186 "/work/main/tests/classical/classical_sliding_cylinder.pf"
#line 186 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertEqual(0.0_dp, state%half_width, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 186) )
  if (anyExceptions()) return
#line 187 "/work/main/tests/classical/classical_sliding_cylinder.pf"
#line 187 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertTrue(ieee_is_nan(state%friction_coefficient), &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 187) )
  if (anyExceptions()) return
#line 188 "/work/main/tests/classical/classical_sliding_cylinder.pf"
      call slide%solve_load(-1.0_dp, state, is_converged)
#line 189 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertFalse(is_converged, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 189) )
  if (anyExceptions()) return
#line 190 "/work/main/tests/classical/classical_sliding_cylinder.pf"
      call new_cylinder_slide(slide, 0.05_dp, prony, 1.0e110_dp, is_possible)
#line 191 "/work/main/tests/classical/classical_sliding_cylinder.pf"
  call assertFalse(is_possible, &
 & location=SourceLocation( &
 & 'classical_sliding_cylinder.pf', &
 & 191) )
  if (anyExceptions()) return
#line 192 "/work/main/tests/classical/classical_sliding_cylinder.pf"
   end subroutine test_rejections

end module classical_sliding_cylinder

module Wrapclassical_sliding_cylinder
   use FUnit
   use classical_sliding_cylinder
   implicit none
   private

contains


end module Wrapclassical_sliding_cylinder

function classical_sliding_cylinder_suite() result(suite)
   use FUnit
   use classical_sliding_cylinder
   use Wrapclassical_sliding_cylinder
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('classical_sliding_cylinder_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_table', &
      test_table))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_equilibrium', &
      test_equilibrium))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_narrow_wave', &
      test_narrow_wave))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_hertz', &
      test_hertz))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_mirror_and_units', &
      test_mirror_and_units))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_rejections', &
      test_rejections))
   call suite%addTest(t)


end function classical_sliding_cylinder_suite


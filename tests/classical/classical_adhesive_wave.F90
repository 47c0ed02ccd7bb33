! SPDX-License-Identifier: GPL-3.0-or-later
! The adhesive wave: tables, published numbers, derivatives along the curve of equilibria, limits.
module classical_adhesive_wave
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_classical_adhesive_wave, only: zones_t, get_zones_of_place, get_zones_of_angle, range_excess, load_slope, &
      & penetration_slope, get_range_slopes, get_fold_slopes, open_crest
   use adfric_classical_adhesive_wave_curve, only: adhesive_wave_t, find_contact, get_curve_state, is_open
   use adfric_classical_adhesive_wave_events, only: new_adhesive_wave
   use adfric_classical_adhesive_wave_integrals, only: get_zone_integrals
   use adfric_classical_adhesive_wave_load, only: state_of_load, pull_off_load, branch_approach, branch_adhered
   use adfric_classical_adhesive_wave_penetration, only: state_of_penetration
   use adfric_classical_adhesive_wave_state, only: wave_adhesion_t, state_of_zones, regime_none, regime_zones, regime_saturated, &
      & regime_full
   use adfric_classical_westergaard, only: wave_half_width, wave_penetration
   use reference_table, only: table_t, read_table
   use funit
   implicit none (type, external)

   !> Tables have 16 digits; numbers of order one come back to this, loads to this times their largest term S.
   real(dp), parameter :: digits = 2.0e-14_dp
   integer, parameter :: longest_label = 400
   character(len=*), parameter :: regime_words(-1:4) = [character(len=10) :: 'none', 'free', 'no_contact', 'zones', 'saturated', &
      & 'full']

contains

   ! States at a given c: no search of a branch.
   !@test
   subroutine test_states()
      type(table_t) :: table
      character(longest_label) :: label
      type(adhesive_wave_t) :: wave
      type(zones_t) :: zones
      type(wave_adhesion_t) :: state
      real(dp) :: s
      logical :: is_converged
      integer :: row

      call read_table(table, 'adh_dugdale_wave_1d_states')
#line 41 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(306, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 41) )
  if (anyExceptions()) return
#line 42 "/work/main/tests/classical/classical_adhesive_wave.pf"
      do row = 1, table%n_rows
         label = table%label(row)
         if (table%number(row, 'cohesive_half_width') > 0.4999999_dp) cycle
         s = table%number(row, 'stress')
         call new_adhesive_wave(wave, s, table%number(row, 'range'), is_converged)
#line 47 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertTrue(is_converged, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 47) )
  if (anyExceptions()) return
#line 48 "/work/main/tests/classical/classical_adhesive_wave.pf"
         zones%y = 0
         call find_contact(wave, log(tan(pi*table%number(row, 'cohesive_half_width'))), zones, is_converged)
#line 50 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertTrue(is_converged, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 50) )
  if (anyExceptions()) return
#line 51 "/work/main/tests/classical/classical_adhesive_wave.pf"
         call state_of_zones(wave, zones, state)
#line 52 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(table%text(row, 'regime'), trim(regime_words(state%regime)), message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 52) )
  if (anyExceptions()) return
#line 53 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 53 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(table%number(row, 'contact_half_width'), state%contact_half_width, tolerance=digits, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 53) )
  if (anyExceptions()) return
#line 54 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 54 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(table%number(row, 'mean_pressure'), state%mean_pressure, tolerance=digits*(1 + s), message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 54) )
  if (anyExceptions()) return
#line 55 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 55 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(table%number(row, 'penetration'), state%penetration, tolerance=digits, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 55) )
  if (anyExceptions()) return
#line 56 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 56 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(table%number(row, 'crest_gap'), state%crest_gap, tolerance=digits, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 56) )
  if (anyExceptions()) return
#line 57 "/work/main/tests/classical/classical_adhesive_wave.pf"
         if (state%regime /= regime_zones) cycle
#line 58 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertTrue(load_slope(wave%sigma, zones) > 0 .eqv. table%number(row, 'stable_load') > 0, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 58) )
  if (anyExceptions()) return
#line 59 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 59 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertTrue(penetration_slope(wave%sigma, zones) > 0 .eqv. table%number(row, 'stable_penetration') > 0, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 59) )
  if (anyExceptions()) return
#line 60 "/work/main/tests/classical/classical_adhesive_wave.pf"
      end do
   end subroutine test_states

   ! Folds, first contact, ends of saturation and of full contact.
   !@test
   subroutine test_events()
      type(table_t) :: table
      character(longest_label) :: label
      type(adhesive_wave_t) :: wave
      type(zones_t) :: zones
      type(wave_adhesion_t) :: state
      real(dp) :: s, load
      logical :: is_converged
      integer :: row

      call read_table(table, 'adh_dugdale_wave_1d_events')
#line 76 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(129, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 76) )
  if (anyExceptions()) return
#line 77 "/work/main/tests/classical/classical_adhesive_wave.pf"
      do row = 1, table%n_rows
         label = table%label(row)
         s = table%number(row, 'stress')
         call new_adhesive_wave(wave, s, table%number(row, 'range'), is_converged)
#line 81 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertTrue(is_converged, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 81) )
  if (anyExceptions()) return
#line 82 "/work/main/tests/classical/classical_adhesive_wave.pf"
         select case (table%text(row, 'event'))
         case ('first_contact')
            call get_zones_of_place(wave%first_place, open_crest, zones)
         case ('load_min')
#line 86 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertTrue(wave%has_folds, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 86) )
  if (anyExceptions()) return
#line 87 "/work/main/tests/classical/classical_adhesive_wave.pf"
            zones = wave%least
         case ('load_max')
#line 89 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertTrue(wave%has_folds, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 89) )
  if (anyExceptions()) return
#line 90 "/work/main/tests/classical/classical_adhesive_wave.pf"
            zones = wave%largest
         case ('penetration_min')
            zones = wave%lowest
         case ('penetration_max')
            zones = wave%highest
         case ('saturation_ends', 'pull_off_adhered')
            load = wave%saturation_load
            if (table%text(row, 'event') == 'pull_off_adhered') load = pull_off_load(wave)
#line 98 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(table%number(row, 'mean_pressure'), load, tolerance=digits*(1 + s), message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 98) )
  if (anyExceptions()) return
#line 99 "/work/main/tests/classical/classical_adhesive_wave.pf"
            ! the pull-off's own state lies on the branch
            call state_of_load(wave, load, branch_adhered, state, is_converged)
#line 101 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(table%number(row, 'penetration'), state%penetration, tolerance=1.0e-6_dp, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 101) )
  if (anyExceptions()) return
#line 102 "/work/main/tests/classical/classical_adhesive_wave.pf"
            cycle
         case default
            call state_of_load(wave, 1 - s, branch_adhered, state, is_converged)
#line 105 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertTrue(state%regime == regime_full, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 105) )
  if (anyExceptions()) return
#line 106 "/work/main/tests/classical/classical_adhesive_wave.pf"
            cycle
         end select
         call state_of_zones(wave, zones, state)
         ! the table's contacts below 1e-11 are 0
#line 110 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(table%number(row, 'contact_half_width'), state%contact_half_width, tolerance=1.0e-11_dp, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 110) )
  if (anyExceptions()) return
#line 111 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 111 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(table%number(row, 'cohesive_half_width'), state%cohesive_half_width, tolerance=digits, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 111) )
  if (anyExceptions()) return
#line 112 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 112 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(table%number(row, 'mean_pressure'), state%mean_pressure, tolerance=digits*(1 + s), message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 112) )
  if (anyExceptions()) return
#line 113 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 113 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(table%number(row, 'penetration'), state%penetration, tolerance=digits, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 113) )
  if (anyExceptions()) return
#line 114 "/work/main/tests/classical/classical_adhesive_wave.pf"
      end do
   end subroutine test_events

   ! Given loads.
   !@test
   subroutine test_loads()
      type(table_t) :: table
      character(longest_label) :: label
      type(adhesive_wave_t) :: wave
      type(wave_adhesion_t) :: state
      logical :: is_converged
      integer :: row

      call read_table(table, 'adh_dugdale_wave_1d_load')
#line 128 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(432, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 128) )
  if (anyExceptions()) return
#line 129 "/work/main/tests/classical/classical_adhesive_wave.pf"
      do row = 1, table%n_rows
         label = table%label(row)
         call new_adhesive_wave(wave, table%number(row, 'stress'), table%number(row, 'range'), is_converged)
         call state_of_load(wave, table%number(row, 'mean_pressure'), merge(branch_adhered, branch_approach, &
            & table%text(row, 'branch') == 'adhered'), state, is_converged)
#line 134 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertTrue(is_converged, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 134) )
  if (anyExceptions()) return
#line 135 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 135 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(table%text(row, 'regime'), trim(regime_words(state%regime)), message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 135) )
  if (anyExceptions()) return
#line 136 "/work/main/tests/classical/classical_adhesive_wave.pf"
         if (state%regime == regime_none) cycle
#line 137 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(table%number(row, 'contact_half_width'), state%contact_half_width, tolerance=digits, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 137) )
  if (anyExceptions()) return
#line 138 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 138 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(table%number(row, 'cohesive_half_width'), state%cohesive_half_width, tolerance=digits, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 138) )
  if (anyExceptions()) return
#line 139 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 139 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(table%number(row, 'penetration'), state%penetration, tolerance=digits, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 139) )
  if (anyExceptions()) return
#line 140 "/work/main/tests/classical/classical_adhesive_wave.pf"
      end do
   end subroutine test_loads

   ! Given penetrations.
   !@test
   subroutine test_penetrations()
      type(table_t) :: table
      character(longest_label) :: label
      type(adhesive_wave_t) :: wave
      type(wave_adhesion_t) :: state
      real(dp) :: s
      logical :: is_converged
      integer :: row

      call read_table(table, 'adh_dugdale_wave_1d_penetration')
#line 155 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(390, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 155) )
  if (anyExceptions()) return
#line 156 "/work/main/tests/classical/classical_adhesive_wave.pf"
      do row = 1, table%n_rows
         label = table%label(row)
         s = table%number(row, 'stress')
         call new_adhesive_wave(wave, s, table%number(row, 'range'), is_converged)
         call state_of_penetration(wave, table%number(row, 'penetration'), merge(branch_adhered, branch_approach, &
            & table%text(row, 'branch') == 'adhered'), state, is_converged)
#line 162 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertTrue(is_converged, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 162) )
  if (anyExceptions()) return
#line 163 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 163 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(table%text(row, 'regime'), trim(regime_words(state%regime)), message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 163) )
  if (anyExceptions()) return
#line 164 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 164 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(table%number(row, 'contact_half_width'), state%contact_half_width, tolerance=digits, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 164) )
  if (anyExceptions()) return
#line 165 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 165 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(table%number(row, 'cohesive_half_width'), state%cohesive_half_width, tolerance=digits, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 165) )
  if (anyExceptions()) return
#line 166 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 166 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(table%number(row, 'mean_pressure'), state%mean_pressure, tolerance=digits*(1 + s), message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 166) )
  if (anyExceptions()) return
#line 167 "/work/main/tests/classical/classical_adhesive_wave.pf"
      end do
   end subroutine test_penetrations

   ! The numbers of the paper's page: S = eta = 0.3, both branches, and pull-off.
   !@test
   subroutine test_numbers()
      type(adhesive_wave_t) :: wave
      type(wave_adhesion_t) :: state
      logical :: is_converged
      real(dp), parameter :: shown = 1.0e-13_dp

      call new_adhesive_wave(wave, 0.3_dp, 0.3_dp, is_converged)
      call state_of_load(wave, 0.0_dp, branch_approach, state, is_converged)
#line 180 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(0.09434534458574_dp, state%contact_half_width, tolerance=shown, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 180) )
  if (anyExceptions()) return
#line 181 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 181 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(0.16885639659550_dp, state%cohesive_half_width, tolerance=shown, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 181) )
  if (anyExceptions()) return
#line 182 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 182 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(0.15574528943509_dp, state%penetration, tolerance=shown, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 182) )
  if (anyExceptions()) return
#line 183 "/work/main/tests/classical/classical_adhesive_wave.pf"
      call state_of_load(wave, 0.3_dp, branch_approach, state, is_converged)
#line 184 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(0.23088859351166_dp, state%contact_half_width, tolerance=shown, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 184) )
  if (anyExceptions()) return
#line 185 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 185 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(0.31241413309899_dp, state%cohesive_half_width, tolerance=shown, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 185) )
  if (anyExceptions()) return
#line 186 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 186 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(0.73346061156798_dp, state%penetration, tolerance=shown, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 186) )
  if (anyExceptions()) return
#line 187 "/work/main/tests/classical/classical_adhesive_wave.pf"
      call new_adhesive_wave(wave, pi*0.04_dp/(2*0.1_dp), 0.1_dp, is_converged)
#line 188 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(-0.0550362_dp, wave%least_load, tolerance=5.0e-8_dp, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 188) )
  if (anyExceptions()) return
#line 189 "/work/main/tests/classical/classical_adhesive_wave.pf"
      call new_adhesive_wave(wave, pi*0.35_dp**2/(2*0.3_dp), 0.3_dp, is_converged)
#line 190 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(0.007885357217111_dp, wave%saturation_load, tolerance=1.0e-14_dp, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 190) )
  if (anyExceptions()) return
#line 191 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 191 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(-0.114957_dp, wave%least_load, tolerance=5.0e-7_dp, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 191) )
  if (anyExceptions()) return
#line 192 "/work/main/tests/classical/classical_adhesive_wave.pf"
      ! just inside first contact
      call new_adhesive_wave(wave, pi*0.01_dp/(2*0.1_dp), 0.1_dp, is_converged)
#line 194 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(-0.01929247560895616_dp, wave%least_load, tolerance=1.0e-16_dp, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 194) )
  if (anyExceptions()) return
#line 195 "/work/main/tests/classical/classical_adhesive_wave.pf"
      call state_of_zones(wave, wave%least, state)
#line 196 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(0.001439459321_dp, state%contact_half_width, tolerance=5.0e-13_dp, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 196) )
  if (anyExceptions()) return
#line 197 "/work/main/tests/classical/classical_adhesive_wave.pf"
   end subroutine test_numbers

   ! Range, load and penetration by small steps, and the slopes along the curve.
   !@test
   subroutine test_derivatives()
      type(adhesive_wave_t) :: wave
      type(zones_t) :: zones, after, before
      real(dp) :: by(2), load_by(2), penetration_by(2), p(2), d(2), gap, x, y, slope, step
      logical :: is_converged
      integer :: i, j
      real(dp), parameter :: h = 1.0e-4_dp, close = 1.0e-6_dp

      do i = -3, 3
         do j = -3, 2
            x = 0.8_dp*i
            y = 10.0_dp**(0.6_dp*j)
            call get_zones_of_place(x, y, zones)
            call get_range_slopes(0.3_dp, zones, by(1), by(2))
            call get_fold_slopes(0.3_dp, zones, load_by, penetration_by)
            call get_zones_of_place(x + h, y, after)
            call get_zones_of_place(x - h, y, before)
            slope = range_excess(0.3_dp, 0.0_dp, after) - range_excess(0.3_dp, 0.0_dp, before)
#line 219 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertRelativelyEqual(slope, 2*h*by(1), tolerance=close, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 219) )
  if (anyExceptions()) return
#line 220 "/work/main/tests/classical/classical_adhesive_wave.pf"
            slope = (load_slope(0.3_dp, after) - load_slope(0.3_dp, before))/(2*h)
#line 221 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(slope, load_by(1), tolerance=close, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 221) )
  if (anyExceptions()) return
#line 222 "/work/main/tests/classical/classical_adhesive_wave.pf"
            slope = (penetration_slope(0.3_dp, after) - penetration_slope(0.3_dp, before))/(2*h)
#line 223 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(slope, penetration_by(1), tolerance=100*close, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 223) )
  if (anyExceptions()) return
#line 224 "/work/main/tests/classical/classical_adhesive_wave.pf"
            step = h*y
            call get_zones_of_place(x, y + step, after)
            call get_zones_of_place(x, y - step, before)
            slope = range_excess(0.3_dp, 0.0_dp, after) - range_excess(0.3_dp, 0.0_dp, before)
#line 228 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(slope/(2*step), by(2), tolerance=close, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 228) )
  if (anyExceptions()) return
#line 229 "/work/main/tests/classical/classical_adhesive_wave.pf"
            slope = (penetration_slope(0.3_dp, after) - penetration_slope(0.3_dp, before))/(2*step)
#line 230 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(slope, penetration_by(2), tolerance=100*close, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 230) )
  if (anyExceptions()) return
#line 231 "/work/main/tests/classical/classical_adhesive_wave.pf"
         end do
      end do
      call new_adhesive_wave(wave, 0.3_dp, 0.3_dp, is_converged)
      do i = 0, 6
         x = -1.0_dp + 0.5_dp*i
         zones%y = 0
         call find_contact(wave, x, zones, is_converged)
         after = zones
         call find_contact(wave, x + h, after, is_converged)
         call get_curve_state(wave, after, p(2), d(2), gap)
         before = zones
         call find_contact(wave, x - h, before, is_converged)
         call get_curve_state(wave, before, p(1), d(1), gap)
         ! d gamma/dx = sin 2 gamma/2
         step = 2*h*zones%sine*zones%cosine
#line 246 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual((p(2) - p(1))/step, load_slope(wave%sigma, zones)/zones%y, tolerance=close, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 246) )
  if (anyExceptions()) return
#line 247 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 247 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual((d(2) - d(1))/step, 2*penetration_slope(wave%sigma, zones)/zones%y, tolerance=close, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 247) )
  if (anyExceptions()) return
#line 248 "/work/main/tests/classical/classical_adhesive_wave.pf"
      end do
   end subroutine test_derivatives

   ! The integrals by their own derivatives, and zones by both ways, over both sides of each change of the method. An angle near
   ! pi/2 has lost a factor of its tangent.
   !@test
   subroutine test_integrals()
      type(zones_t) :: zones, again
      real(dp) :: low(3), high(3), phi, tangent, f, ln_s
      integer :: i, j
      real(dp), parameter :: h = 1.0e-4_dp, round_off = 1.0e-12_dp

      do i = -6, 12
         do j = 1, 19
            tangent = exp(0.5_dp*i)
            phi = atan(tangent)*j/20
            call integrals_of(tangent, phi - h*phi, low)
            call integrals_of(tangent, phi + h*phi, high)
            f = atanh(tan(phi)/tangent)
#line 267 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertRelativelyEqual(f, (high(1) - low(1))/(2*h*phi), tolerance=1.0e-5_dp, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 267) )
  if (anyExceptions()) return
#line 268 "/work/main/tests/classical/classical_adhesive_wave.pf"
            ln_s = log(sin(atan(tangent) + phi)*sin(atan(tangent) - phi))/2 - log(cos(phi))
#line 269 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertRelativelyEqual(ln_s, (high(2) - low(2))/(2*h*phi), tolerance=1.0e-5_dp, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 269) )
  if (anyExceptions()) return
#line 270 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 270 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertRelativelyEqual(-2*phi*ln_s, (high(3) - low(3))/(2*h*phi), tolerance=1.0e-5_dp, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 270) )
  if (anyExceptions()) return
#line 271 "/work/main/tests/classical/classical_adhesive_wave.pf"
            call get_zones_of_angle(phi, sin(atan(tangent) + phi)*sin(atan(tangent) - phi)/cos(phi)**2, zones)
#line 272 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertRelativelyEqual(tangent, zones%tangent, tolerance=round_off*(1 + tangent), &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 272) )
  if (anyExceptions()) return
#line 273 "/work/main/tests/classical/classical_adhesive_wave.pf"
            call get_zones_of_place(zones%place, zones%y, again)
#line 274 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertRelativelyEqual(phi, again%phi, tolerance=round_off, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 274) )
  if (anyExceptions()) return
#line 275 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 275 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertRelativelyEqual(zones%log_ratio, again%log_ratio, tolerance=round_off, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 275) )
  if (anyExceptions()) return
#line 276 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 276 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertRelativelyEqual(zones%lambda, again%lambda, tolerance=round_off, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 276) )
  if (anyExceptions()) return
#line 277 "/work/main/tests/classical/classical_adhesive_wave.pf"
         end do
      end do
   end subroutine test_integrals

   !> K, M and W at phi.
   subroutine integrals_of(tangent, phi, values)
      real(dp), intent(in) :: tangent, phi
      real(dp), intent(out) :: values(3)

      call get_zone_integrals(tangent, tan(phi)/tangent, phi, atan(tangent) - phi, values(1), values(2), values(3))
   end subroutine integrals_of

   ! JKR: the table at h0 = 1e-4 D to 1e-6 D, and the error falls with the square of the range.
   !@test
   subroutine test_jkr_limit()
      type(table_t) :: table
      character(longest_label) :: label
      type(adhesive_wave_t) :: wave
      type(wave_adhesion_t) :: state
      real(dp) :: alpha, error(2)
      logical :: is_converged
      integer :: row, k
      real(dp), parameter :: ranges(2) = [1.0e-4_dp, 1.0e-5_dp]

      call read_table(table, 'adh_jkr_wave_1d_states')
#line 302 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(138, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 302) )
  if (anyExceptions()) return
#line 303 "/work/main/tests/classical/classical_adhesive_wave.pf"
      do row = 1, table%n_rows
         if (.not. table%number(row, 'stable_load') > 0) cycle
         label = table%label(row)
         alpha = table%number(row, 'alpha')
         do k = 1, 2
            call new_adhesive_wave(wave, pi*alpha**2/(2*ranges(k)), ranges(k), is_converged)
#line 309 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertTrue(is_converged, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 309) )
  if (anyExceptions()) return
#line 310 "/work/main/tests/classical/classical_adhesive_wave.pf"
            call state_of_penetration(wave, table%number(row, 'penetration'), branch_adhered, state, is_converged)
#line 311 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertTrue(is_converged, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 311) )
  if (anyExceptions()) return
#line 312 "/work/main/tests/classical/classical_adhesive_wave.pf"
            error(k) = abs(state%mean_pressure - table%number(row, 'mean_pressure'))
         end do
#line 314 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertTrue(error(1) < 1.0e-4_dp, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 314) )
  if (anyExceptions()) return
#line 315 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 315 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertTrue(error(2) < max(0.02_dp*error(1), 1.0e-9_dp), message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 315) )
  if (anyExceptions()) return
#line 316 "/work/main/tests/classical/classical_adhesive_wave.pf"
      end do
   end subroutine test_jkr_limit

   ! A summit that is narrow beside the period is a cylinder (Baney and Hui 1997): range and load of given zones.
   !@test
   subroutine test_cylinder_limit()
      type(zones_t) :: zones
      real(dp) :: a, c, mm, mu, range, load
      integer :: k
      real(dp), parameter :: stress = 0.02_dp

      c = 1.0e-5_dp
      do k = -4, 4
         call get_zones_of_place(log(tan(pi*c)), 10.0_dp**(k/4.0_dp), zones)
         a = c/cosh(zones%y)
         mm = c/a
         mu = sinh(zones%y)
         ! R = l^2/(4 pi^2 D)
         range = 2*pi**2*a**2*(mm*mu - zones%y) + 4*stress*a*(mu*zones%y - mm*log(mm))
#line 335 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertRelativelyEqual(range, range_excess(2*stress/pi, 0.0_dp, zones), tolerance=1.0e-8_dp, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 335) )
  if (anyExceptions()) return
#line 336 "/work/main/tests/classical/classical_adhesive_wave.pf"
         ! q l = pi E* a^2/(4 R) - 2 sigma0 sqrt(c^2 - a^2)
         load = pi**2*a**2 - 2*stress*sqrt(c**2 - a**2)
#line 338 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertRelativelyEqual(load, zones%square - 2*stress/pi*zones%phi, tolerance=1.0e-8_dp, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 338) )
  if (anyExceptions()) return
#line 339 "/work/main/tests/classical/classical_adhesive_wave.pf"
      end do
   end subroutine test_cylinder_limit

   ! Without attraction, and with an endless range.
   !@test
   subroutine test_westergaard_limits()
      type(adhesive_wave_t) :: wave
      type(wave_adhesion_t) :: state
      real(dp) :: p
      logical :: is_converged
      integer :: i

      do i = 1, 9
         p = 0.1_dp*i
         call new_adhesive_wave(wave, 1.0e-12_dp, 0.01_dp, is_converged)
         call state_of_load(wave, p, branch_approach, state, is_converged)
#line 355 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 355) )
  if (anyExceptions()) return
#line 356 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 356 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(wave_half_width(p), state%contact_half_width, tolerance=1.0e-11_dp, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 356) )
  if (anyExceptions()) return
#line 357 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 357 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(wave_penetration(p), state%penetration, tolerance=1.0e-11_dp, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 357) )
  if (anyExceptions()) return
#line 358 "/work/main/tests/classical/classical_adhesive_wave.pf"
         call new_adhesive_wave(wave, 0.25_dp, 100.0_dp, is_converged)
         call state_of_load(wave, p - 0.25_dp, branch_adhered, state, is_converged)
#line 360 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertEqual(wave_half_width(p), state%contact_half_width, tolerance=1.0e-15_dp, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 360) )
  if (anyExceptions()) return
#line 361 "/work/main/tests/classical/classical_adhesive_wave.pf"
#line 361 "/work/main/tests/classical/classical_adhesive_wave.pf"
  call assertTrue(state%regime == regime_saturated, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave.pf', &
 & 361) )
  if (anyExceptions()) return
#line 362 "/work/main/tests/classical/classical_adhesive_wave.pf"
      end do
   end subroutine test_westergaard_limits

end module classical_adhesive_wave

module Wrapclassical_adhesive_wave
   use FUnit
   use classical_adhesive_wave
   implicit none
   private

contains


end module Wrapclassical_adhesive_wave

function classical_adhesive_wave_suite() result(suite)
   use FUnit
   use classical_adhesive_wave
   use Wrapclassical_adhesive_wave
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('classical_adhesive_wave_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_states', &
      test_states))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_events', &
      test_events))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_loads', &
      test_loads))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_penetrations', &
      test_penetrations))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_numbers', &
      test_numbers))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_derivatives', &
      test_derivatives))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_integrals', &
      test_integrals))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_jkr_limit', &
      test_jkr_limit))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_cylinder_limit', &
      test_cylinder_limit))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_westergaard_limits', &
      test_westergaard_limits))
   call suite%addTest(t)


end function classical_adhesive_wave_suite


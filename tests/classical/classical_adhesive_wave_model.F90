! SPDX-License-Identifier: GPL-3.0-or-later
! The model `wave_1d` with adhesion: the tables, limits, both controls, energies, loops, other units, neighbours, rejections.
module classical_adhesive_wave_model
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_unset, only: unset
   use adfric_classical_jkr_wave, only: jkr_wave_load, jkr_wave_penetration, jkr_wave_load_slope, jkr_wave_penetration_slope, &
      & find_jkr_pull_off
   use adfric_material_adhesion_rows, only: branch_adhered, branch_approach
   use adfric_model_derived, only: derived_t
   use adfric_model_status, only: status_solved, status_no_equilibrium, status_not_converged
   use counting_sink, only: n_different_bits
   use reference_table, only: table_t, read_table
   use trial_case, only: trial_case_t, new_case
   use funit
   implicit none (type, external)

   real(dp), parameter :: period = 1.0e-5_dp, amplitude = 1.0e-7_dp, modulus = 1.0e7_dp
   !> p* [Pa], and energy over nominal area [J/m^2].
   real(dp), parameter :: unit = pi*modulus*amplitude/period, energy_unit = unit*amplitude
   !> Tables have 16 digits; numbers of order one come back to this, loads to this times their largest term S.
   real(dp), parameter :: digits = 4.0e-14_dp
   integer, parameter :: longest_label = 400
   !> Words of the tables in the order of the regimes of the model.
   character(10), parameter :: words(0:5) = [character(10) :: 'free', 'partial', 'full', 'no_contact', 'zones', 'saturated']

contains

   !> A wave with reduced stress and range.
   subroutine new_wave(case, stress, range)
      type(trial_case_t), intent(out) :: case
      real(dp), intent(in) :: stress, range

      call new_case(case, 'wave_1d')
      call case%give('period', period)
      call case%give('amplitude', amplitude)
      call case%give('contact_modulus', modulus)
      call case%give('stress', stress*unit)
      call case%give('range', range*amplitude)
   end subroutine new_wave

   subroutine solve_load(case, load, branch)
      type(trial_case_t), intent(inout) :: case
      real(dp), intent(in) :: load
      integer, intent(in) :: branch

      call case%give('branch', real(branch, dp))
      call case%give('penetration', unset)
      call case%give('mean_pressure', load*unit)
#line 51 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 51) )
  if (anyExceptions()) return
#line 52 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
      call case%solve()
   end subroutine solve_load

   subroutine solve_penetration(case, penetration, branch)
      type(trial_case_t), intent(inout) :: case
      real(dp), intent(in) :: penetration
      integer, intent(in) :: branch

      call case%give('branch', real(branch, dp))
      call case%give('mean_pressure', unset)
      call case%give('penetration', penetration*amplitude)
#line 63 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 63) )
  if (anyExceptions()) return
#line 64 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
      call case%solve()
   end subroutine solve_penetration

   !> Compare the zones; the tables call saturation without contact saturated.
   subroutine check_zones(case, table, row)
      type(trial_case_t), intent(in) :: case
      type(table_t), intent(in) :: table
      integer, intent(in) :: row
      character(longest_label) :: label
      character(10) :: word
      real(dp) :: a, c

      label = table%label(row)
#line 77 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(status_solved, case%status(1), message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 77) )
  if (anyExceptions()) return
#line 78 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
      a = case%found('contact_fraction')/2
      c = a + case%found('adhesion_fraction')/2
      word = words(nint(case%found('regime')))
      if (c >= 0.5_dp .and. .not. a > 0) word = 'saturated'
#line 82 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(table%text(row, 'regime'), trim(word), message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 82) )
  if (anyExceptions()) return
#line 83 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 83 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(table%number(row, 'contact_half_width'), a, tolerance=digits, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 83) )
  if (anyExceptions()) return
#line 84 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 84 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(table%number(row, 'cohesive_half_width'), c, tolerance=digits, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 84) )
  if (anyExceptions()) return
#line 85 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 85 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertLessThan(case%found('contact_violation'), 1.0e-12_dp, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 85) )
  if (anyExceptions()) return
#line 86 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
   end subroutine check_zones

   !> The branch of a row.
   integer function branch_of(table, row)
      type(table_t), intent(in) :: table
      integer, intent(in) :: row

      branch_of = merge(branch_adhered, branch_approach, table%text(row, 'branch') == 'adhered')
   end function branch_of

   !@test
   subroutine test_loads()
      type(table_t) :: table
      type(trial_case_t) :: case
      character(longest_label) :: label
      integer :: row

      call read_table(table, 'adh_dugdale_wave_1d_load')
#line 104 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(432, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 104) )
  if (anyExceptions()) return
#line 105 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
      do row = 1, table%n_rows
         label = table%label(row)
         call new_wave(case, table%number(row, 'stress'), table%number(row, 'range'))
         call solve_load(case, table%number(row, 'mean_pressure'), branch_of(table, row))
#line 109 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(nint(table%number(row, 'status')), case%status(1), message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 109) )
  if (anyExceptions()) return
#line 110 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
         if (case%status(1) /= status_solved) cycle
         call check_zones(case, table, row)
#line 112 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(table%number(row, 'penetration'), case%found('penetration')/amplitude, tolerance=digits, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 112) )
  if (anyExceptions()) return
#line 113 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
      end do
   end subroutine test_loads

   !@test
   subroutine test_penetrations()
      type(table_t) :: table
      type(trial_case_t) :: case
      character(longest_label) :: label
      real(dp) :: s, p
      integer :: row

      call read_table(table, 'adh_dugdale_wave_1d_penetration')
#line 125 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(390, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 125) )
  if (anyExceptions()) return
#line 126 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
      do row = 1, table%n_rows
         label = table%label(row)
         s = table%number(row, 'stress')
         call new_wave(case, s, table%number(row, 'range'))
         call solve_penetration(case, table%number(row, 'penetration'), branch_of(table, row))
         call check_zones(case, table, row)
         p = case%found('mean_pressure')/unit
#line 133 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(table%number(row, 'mean_pressure'), p, tolerance=digits*(1 + s), message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 133) )
  if (anyExceptions()) return
#line 134 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
      end do
   end subroutine test_penetrations

   ! Stable states of the curve, by load and by penetration; zones are on the branch that has turned at load 0.
   !@test
   subroutine test_states()
      type(table_t) :: table
      type(trial_case_t) :: case
      character(longest_label) :: label
      real(dp) :: s, p, delta, near
      integer :: row, n(2)
      logical :: is_reached

      call read_table(table, 'adh_dugdale_wave_1d_states')
#line 148 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(306, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 148) )
  if (anyExceptions()) return
#line 149 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
      n = 0
      do row = 1, table%n_rows
         label = table%label(row)
         s = table%number(row, 'stress')
         p = table%number(row, 'mean_pressure')
         delta = table%number(row, 'penetration')
         ! some lie on the end of saturation, where the last bit decides
         if (table%text(row, 'regime') == 'saturated') then
            p = p + 4*epsilon(p)*(1 + s)
            delta = delta + 4*epsilon(p)*abs(delta)
         end if
         call new_wave(case, s, table%number(row, 'range'))
         is_reached = .true.
         if (table%text(row, 'regime') == 'zones') then
            call case%give('turning_pressure', 0.0_dp)
            call solve_load(case, 0.0_dp, branch_adhered)
            ! else the wave is saturated at load 0, and no path of loads leads to its zones
            is_reached = nint(case%found('regime')) == 4
         end if
         if (table%number(row, 'stable_load') > 0 .and. is_reached) then
            call solve_load(case, p, branch_adhered)
            near = max(digits*(1 + s), 10*case%error_estimate(1))
#line 171 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(status_solved, case%status(1), message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 171) )
  if (anyExceptions()) return
#line 172 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 172 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(delta, case%found('penetration')/amplitude, tolerance=near, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 172) )
  if (anyExceptions()) return
#line 173 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
            n(1) = n(1) + 1
         end if
         if (table%number(row, 'stable_penetration') > 0 .and. delta < 1) then
            if (table%text(row, 'regime') == 'saturated') then
               call solve_penetration(case, delta, branch_adhered)
            else if (delta > -table%number(row, 'range')) then
               call case%give('turning_pressure', unset)
               call solve_penetration(case, delta, branch_approach)
            else
               ! only parting leads there, from contact that was partial at load 0
               call case%give('turning_pressure', 0.0_dp)
               call solve_load(case, 0.0_dp, branch_adhered)
               if (nint(case%found('regime')) /= 4) cycle
               call solve_penetration(case, delta, branch_adhered)
            end if
            near = max(digits*(1 + s), 10*(1 + s)*case%error_estimate(1))
#line 189 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(p, case%found('mean_pressure')/unit, tolerance=near, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 189) )
  if (anyExceptions()) return
#line 190 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
            n(2) = n(2) + 1
         end if
      end do
#line 193 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertGreaterThan(minval(n), 100, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 193) )
  if (anyExceptions()) return
#line 194 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
   end subroutine test_states

   ! Ends of the adhered branch, with and without a turn in partial contact.
   !@test
   subroutine test_events()
      type(table_t) :: table
      type(trial_case_t) :: case
      character(longest_label) :: label
      real(dp) :: s, near, p, delta
      integer :: row

      call read_table(table, 'adh_dugdale_wave_1d_events')
#line 206 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(129, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 206) )
  if (anyExceptions()) return
#line 207 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
      do row = 1, table%n_rows
         label = table%label(row)
         s = table%number(row, 'stress')
         near = digits*(1 + s)
         p = table%number(row, 'mean_pressure')
         delta = table%number(row, 'penetration')
         call new_wave(case, s, table%number(row, 'range'))
         select case (table%text(row, 'event'))
         case ('pull_off_adhered')
            call solve_load(case, p - near, branch_adhered)
#line 217 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(status_no_equilibrium, case%status(1), message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 217) )
  if (anyExceptions()) return
#line 218 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 218 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertTrue(ieee_is_nan(case%found('penetration')), message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 218) )
  if (anyExceptions()) return
#line 219 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
            call solve_load(case, p + near, branch_adhered)
#line 220 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(status_solved, case%status(1), message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 220) )
  if (anyExceptions()) return
#line 221 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 221 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(p, case%found('pull_off_pressure')/unit, tolerance=near, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 221) )
  if (anyExceptions()) return
#line 222 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 222 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(delta, case%found('pull_off_penetration')/amplitude, tolerance=1.0e-7_dp, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 222) )
  if (anyExceptions()) return
#line 223 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
         case ('load_min')
            ! partial contact at load 0, if the load has a maximum beyond it
            call case%give('turning_pressure', 0.0_dp)
            call solve_load(case, 0.0_dp, branch_adhered)
            if (nint(case%found('regime')) /= 4) cycle
#line 228 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(p, case%found('pull_off_pressure')/unit, tolerance=near, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 228) )
  if (anyExceptions()) return
#line 229 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 229 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(delta, case%found('pull_off_penetration')/amplitude, tolerance=digits, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 229) )
  if (anyExceptions()) return
#line 230 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
         case ('penetration_min')
            call case%give('turning_pressure', 0.0_dp)
            call solve_load(case, 0.0_dp, branch_adhered)
            if (nint(case%found('regime')) /= 4) cycle
#line 234 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(delta, case%found('jump_off_penetration')/amplitude, tolerance=digits, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 234) )
  if (anyExceptions()) return
#line 235 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
            call case%give('turning_pressure', 0.0_dp)
            call solve_penetration(case, delta - digits, branch_adhered)
#line 237 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(0, nint(case%found('regime')), message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 237) )
  if (anyExceptions()) return
#line 238 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
         end select
      end do
   end subroutine test_events

   ! The JKR limit: published numbers and tables, slopes that vanish at the events, and the pull-off that `check` shows.
   !@test
   subroutine test_jkr()
      type(table_t) :: table
      type(trial_case_t) :: case
      type(derived_t), allocatable :: derived(:)
      character(longest_label) :: label
      real(dp) :: alpha, a, p, half_width
      logical :: has_fold
      integer :: row, i

      call read_table(table, 'adh_jkr_wave_1d_states')
      do row = 1, table%n_rows
         label = table%label(row)
         alpha = table%number(row, 'alpha')
         a = table%number(row, 'contact_half_width')
#line 258 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(table%number(row, 'mean_pressure'), jkr_wave_load(alpha, a), tolerance=digits, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 258) )
  if (anyExceptions()) return
#line 259 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 259 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(table%number(row, 'penetration'), jkr_wave_penetration(alpha, a), tolerance=digits, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 259) )
  if (anyExceptions()) return
#line 260 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 260 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertTrue(jkr_wave_load_slope(alpha, a) > 0 .eqv. table%number(row, 'stable_load') > 0, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 260) )
  if (anyExceptions()) return
#line 261 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
         has_fold = jkr_wave_penetration_slope(alpha, a) > 0
#line 262 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertTrue(has_fold .eqv. table%number(row, 'stable_penetration') > 0, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 262) )
  if (anyExceptions()) return
#line 263 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
      end do
      call read_table(table, 'adh_jkr_wave_1d_events')
#line 265 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(21, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 265) )
  if (anyExceptions()) return
#line 266 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
      do row = 1, table%n_rows
         label = table%label(row)
         alpha = table%number(row, 'alpha')
         a = table%number(row, 'contact_half_width')
         select case (table%text(row, 'event'))
         case ('load_min')
            call find_jkr_pull_off(alpha, half_width, p, has_fold)
#line 273 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertTrue(has_fold, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 273) )
  if (anyExceptions()) return
#line 274 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 274 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(a, half_width, tolerance=digits, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 274) )
  if (anyExceptions()) return
#line 275 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 275 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(table%number(row, 'mean_pressure'), p, tolerance=digits, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 275) )
  if (anyExceptions()) return
#line 276 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
         case ('load_max')
#line 277 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(0.0_dp, jkr_wave_load_slope(alpha, a), tolerance=1.0e-12_dp, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 277) )
  if (anyExceptions()) return
#line 278 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
         case ('penetration_min')
#line 279 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(0.0_dp, jkr_wave_penetration_slope(alpha, a), tolerance=1.0e-11_dp, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 279) )
  if (anyExceptions()) return
#line 280 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
         case default
#line 281 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(0.0_dp, jkr_wave_load(alpha, a), tolerance=1.0e-14_dp, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 281) )
  if (anyExceptions()) return
#line 282 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
         end select
      end do
      ! Johnson: at alpha = 1/2 and load 0, a = l/4 and delta = D/2
#line 285 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(0.5_dp, jkr_wave_penetration(0.5_dp, 0.25_dp), tolerance=digits, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 285) )
  if (anyExceptions()) return
#line 286 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
      ! 4 (3/8)^(3/4) (5/8)^(5/4)
      call find_jkr_pull_off(1.0652_dp, half_width, p, has_fold)
#line 288 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertTrue(has_fold, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 288) )
  if (anyExceptions()) return
#line 289 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
      call find_jkr_pull_off(1.0653_dp, half_width, p, has_fold)
#line 290 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertTrue(.not. has_fold, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 290) )
  if (anyExceptions()) return
#line 291 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
      call new_wave(case, pi*0.04_dp/2/0.001_dp, 0.001_dp)
      call case%give('turning_pressure', 0.0_dp)
      call solve_load(case, 0.0_dp, branch_adhered)
      allocate (derived, source=case%model%derive_quantities(case%values))
      i = findloc([(derived(row)%name == 'jkr_pull_off_pressure', row=1, size(derived))], .true., 1)
      call find_jkr_pull_off(0.2_dp, half_width, p, has_fold)
#line 297 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(p*unit, derived(i)%value, tolerance=digits*unit, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 297) )
  if (anyExceptions()) return
#line 298 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
      ! the zones are 4e-6 l, the contact 0.04 l
#line 299 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertRelativelyEqual(derived(i)%value, case%found('pull_off_pressure'), tolerance=1.0e-6_dp, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 299) )
  if (anyExceptions()) return
#line 300 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
   end subroutine test_jkr

   ! Stress 0 is no adhesion to the last bit; a stress of round-off is Westergaard, an endless range his pressure less the stress.
   !@test
   subroutine test_limits()
      type(trial_case_t) :: case, plain
      real(dp) :: p, near
      integer :: i

      do i = 0, 10
         p = 0.125_dp*i
         call new_case(plain, 'wave_1d')
         call plain%give('period', period)
         call plain%give('amplitude', amplitude)
         call plain%give('contact_modulus', modulus)
         call plain%give('mean_pressure', p*unit)
         call plain%solve()
         call new_wave(case, 0.0_dp, 0.1_dp)
         call solve_load(case, p, branch_adhered)
#line 319 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(0, sum(n_different_bits(plain%results, case%results)), &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 319) )
  if (anyExceptions()) return
#line 320 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 320 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(plain%error_estimate(1), case%error_estimate(1), &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 320) )
  if (anyExceptions()) return
#line 321 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 321 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(0.0_dp, plain%found('adhesion_fraction'), &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 321) )
  if (anyExceptions()) return
#line 322 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 322 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertTrue(ieee_is_nan(plain%found('pull_off_pressure')), &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 322) )
  if (anyExceptions()) return
#line 323 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
         call new_wave(case, 1.0e-12_dp, 0.01_dp)
         call solve_load(case, p, branch_approach)
#line 325 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(plain%found('penetration'), case%found('penetration'), tolerance=1.0e-11_dp*amplitude, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 325) )
  if (anyExceptions()) return
#line 326 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 326 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(plain%found('contact_fraction'), case%found('contact_fraction'), tolerance=2.0e-6_dp, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 326) )
  if (anyExceptions()) return
#line 327 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
         ! at load 0 the attraction makes a contact, Q < S
         near = merge(2.0e-6_dp, 1.0e-10_dp, i == 0)
#line 329 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(plain%found('peak_pressure'), case%found('peak_pressure'), tolerance=near*unit, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 329) )
  if (anyExceptions()) return
#line 330 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 330 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(plain%found('mean_gap'), case%found('mean_gap'), tolerance=1.0e-11_dp*amplitude, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 330) )
  if (anyExceptions()) return
#line 331 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 331 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(plain%found('largest_gap'), case%found('largest_gap'), tolerance=1.0e-10_dp*amplitude, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 331) )
  if (anyExceptions()) return
#line 332 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 332 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(plain%found('elastic_energy'), case%found('elastic_energy'), tolerance=1.0e-11_dp*energy_unit, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 332) )
  if (anyExceptions()) return
#line 333 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
         call new_wave(case, 0.25_dp, 100.0_dp)
         call solve_load(case, p - 0.25_dp, branch_adhered)
#line 335 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(plain%found('contact_fraction'), case%found('contact_fraction'), tolerance=1.0e-14_dp, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 335) )
  if (anyExceptions()) return
#line 336 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 336 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(plain%found('peak_pressure'), case%found('peak_pressure') + 0.25_dp*unit, tolerance=1.0e-14_dp*unit, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 336) )
  if (anyExceptions()) return
#line 337 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 337 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertRelativelyEqual(-0.25_dp*unit, case%found('pull_off_pressure'), tolerance=1.0e-15_dp, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 337) )
  if (anyExceptions()) return
#line 338 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
      end do
      call solve_load(case, -0.2500001_dp, branch_adhered)
#line 340 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(status_no_equilibrium, case%status(1), &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 340) )
  if (anyExceptions()) return
#line 341 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
      call solve_load(case, -1.0e-9_dp, branch_approach)
#line 342 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(status_no_equilibrium, case%status(1), &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 342) )
  if (anyExceptions()) return
#line 343 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
      call solve_penetration(case, 1.0001_dp, branch_adhered)
#line 344 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(status_no_equilibrium, case%status(1), &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 344) )
  if (anyExceptions()) return
#line 345 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
      call solve_penetration(case, 1.0_dp, branch_adhered)
#line 346 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(2, nint(case%found('regime')), &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 346) )
  if (anyExceptions()) return
#line 347 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
      call new_wave(case, 0.0_dp, 0.1_dp)
      call solve_load(case, -0.1_dp, branch_adhered)
#line 349 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(status_no_equilibrium, case%status(1), &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 349) )
  if (anyExceptions()) return
#line 350 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
   end subroutine test_limits

   ! A load and the penetration that it has belong together, the mean gap and the penetration make D, and dE = q d delta.
   !@test
   subroutine test_energy()
      type(trial_case_t) :: case
      real(dp), parameter :: h = 1.0e-4_dp, cases(2, 4) = reshape([0.3_dp, 0.3_dp, 0.64_dp, 0.3_dp, 3.0_dp, 0.02_dp, 0.1_dp, &
         & 2.2_dp], [2, 4])
      character(longest_label) :: label
      real(dp) :: delta, p, energy(2), gap
      integer :: i, k, branch, regimes(2)

      do i = 1, 4
         call new_wave(case, cases(1, i), cases(2, i))
         do branch = branch_adhered, branch_approach
            do k = -10, 9
               delta = 0.1_dp*k + 0.003_dp
               write (label, '(3g16.8, i2)') cases(:, i), delta, branch
               call solve_penetration(case, delta - h, branch)
               regimes(1) = nint(case%found('regime'))
               energy(1) = case%found('elastic_energy') + case%found('adhesion_energy')
               call solve_penetration(case, delta + h, branch)
               regimes(2) = nint(case%found('regime'))
               energy(2) = case%found('elastic_energy') + case%found('adhesion_energy')
               call solve_penetration(case, delta, branch)
               p = case%found('mean_pressure')/unit
               gap = case%found('mean_gap') + case%found('penetration')
#line 377 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(amplitude, gap, tolerance=digits*amplitude, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 377) )
  if (anyExceptions()) return
#line 378 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
               if (regimes(1) == regimes(2)) then
#line 379 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(p, (energy(2) - energy(1))/(2*h*energy_unit), tolerance=1.0e-5_dp, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 379) )
  if (anyExceptions()) return
#line 380 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
               end if
               if (p < 0 .or. nint(case%found('regime')) == 0) cycle
               call solve_load(case, p, branch)
               if (case%status(1) /= status_solved) cycle
               ! states that a load does not hold are none of its branch
               if (abs(case%found('penetration')/amplitude - delta) > 0.01_dp) cycle
#line 386 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(delta, case%found('penetration')/amplitude, tolerance=1.0e-12_dp, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 386) )
  if (anyExceptions()) return
#line 387 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
            end do
         end do
      end do
   end subroutine test_energy

   ! The loss is the area of the loop. After a turn in partial contact only the part from the jump in to the jump off is not
   ! retraced.
   !@test
   subroutine test_loop()
      type(trial_case_t) :: case
      integer, parameter :: n = 4000
      real(dp), parameter :: low = -1.0_dp, step = (1 - low)/n
      real(dp) :: area, start, v, largest, there, back
      integer :: k

      call new_wave(case, 0.3_dp, 0.3_dp)
      call solve_load(case, 0.0_dp, branch_approach)
      ! found by the equations at 30 digits
#line 405 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(0.00240924_dp, case%found('hysteresis_loss')/energy_unit, tolerance=5.0e-9_dp, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 405) )
  if (anyExceptions()) return
#line 406 "/work/main/tests/classical/classical_adhesive_wave_model.pf"

      call new_wave(case, pi*0.35_dp**2/0.6_dp, 0.3_dp)
      area = 0
      largest = 0
      do k = 1, n
         call solve_penetration(case, low + step*(k - 0.5_dp), branch_approach)
         there = case%found('mean_pressure')/unit
         call solve_penetration(case, low + step*(k - 0.5_dp), branch_adhered)
         back = case%found('mean_pressure')/unit
         largest = max(largest, abs(there), abs(back))
         area = area + (there - back)*step
      end do
      ! half a step at each of four jumps
#line 419 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(case%found('hysteresis_loss')/energy_unit, area, tolerance=2*step*2*largest, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 419) )
  if (anyExceptions()) return
#line 420 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 420 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertGreaterThan(area, 10*step*largest, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 420) )
  if (anyExceptions()) return
#line 421 "/work/main/tests/classical/classical_adhesive_wave_model.pf"

      call case%give('turning_pressure', 0.1_dp*unit)
      call solve_load(case, 0.0_dp, branch_adhered)
      start = case%found('jump_off_penetration')/amplitude
      area = 0
      do k = 1, 200
         v = (k - 0.5_dp)/200
         call solve_penetration(case, start + (-0.3_dp - start)*v**2, branch_adhered)
         area = area - case%found('mean_pressure')/unit*(-0.3_dp - start)*2*v/200
      end do
#line 431 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(area, case%found('hysteresis_loss')/energy_unit, tolerance=1.0e-5_dp, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 431) )
  if (anyExceptions()) return
#line 432 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
   end subroutine test_loop

   ! Towards a short range at one surface energy (alpha = 0.8) the loss comes to rest: what the end of saturation loses falls with
   ! the cube root of the range.
   !@test
   subroutine test_losses_of_short_ranges()
      type(trial_case_t) :: case
      real(dp) :: loss(9)
      integer :: k

      do k = 1, 9
         call new_wave(case, 10.0_dp**k, 10.0_dp**(-k))
         call solve_penetration(case, 0.5_dp, branch_adhered)
         loss(k) = case%found('hysteresis_loss')/energy_unit
#line 446 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertGreaterThan(loss(k), 0.3_dp, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 446) )
  if (anyExceptions()) return
#line 447 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
         if (k < 3) cycle
#line 448 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertLessThan(loss(k), loss(k - 1), &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 448) )
  if (anyExceptions()) return
#line 449 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 449 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertLessThan(loss(k - 1) - loss(k), 0.5_dp*10.0_dp**(-k/3.0_dp), &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 449) )
  if (anyExceptions()) return
#line 450 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
      end do
   end subroutine test_losses_of_short_ranges

   ! Metres and nanometres, pascals and gigapascals; surface energy in place of the range.
   !@test
   subroutine test_units()
      type(trial_case_t) :: case, other
      character(22), parameter :: lengths(4) = [character(22) :: 'penetration', 'largest_gap', 'contact_width', &
         & 'pull_off_penetration'], pressures(3) = [character(22) :: 'mean_pressure', 'peak_pressure', 'pull_off_pressure'], &
         & energies(3) = [character(22) :: 'elastic_energy', 'adhesion_energy', 'hysteresis_loss']
      real(dp), parameter :: metres(3) = [1.0e6_dp, 1.0e-6_dp, 1.0_dp], pascals(3) = [1.0e-9_dp, 1.0e3_dp, 1.0e6_dp]
      real(dp) :: value
      integer :: k, i

      call new_wave(case, 0.3_dp, 0.3_dp)
      call solve_load(case, 0.1_dp, branch_adhered)
      do k = 1, 3
         associate (l => metres(k), p => pascals(k))
            call new_case(other, 'wave_1d')
            call other%give('period', period*l)
            call other%give('amplitude', amplitude*l)
            call other%give('contact_modulus', modulus*p)
            call other%give('stress', 0.3_dp*unit*p)
            call other%give('surface_energy', 0.09_dp*energy_unit*l*p)
            call other%give('mean_pressure', 0.1_dp*unit*p)
#line 475 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual('', other%problems_of(), &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 475) )
  if (anyExceptions()) return
#line 476 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
            call other%solve()
            do i = 1, size(lengths)
               value = other%found(trim(lengths(i)))/l
#line 479 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertRelativelyEqual(case%found(trim(lengths(i))), value, tolerance=1.0e-12_dp, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 479) )
  if (anyExceptions()) return
#line 480 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
            end do
            do i = 1, size(pressures)
               value = other%found(trim(pressures(i)))/p
#line 483 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertRelativelyEqual(case%found(trim(pressures(i))), value, tolerance=1.0e-12_dp, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 483) )
  if (anyExceptions()) return
#line 484 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
            end do
            do i = 1, size(energies)
               value = other%found(trim(energies(i)))/(l*p)
#line 487 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertRelativelyEqual(case%found(trim(energies(i))), value, tolerance=1.0e-11_dp, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 487) )
  if (anyExceptions()) return
#line 488 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
            end do
         end associate
      end do
   end subroutine test_units

   ! Whatever the point before was, with adhesion or without, of this wave or another, turned or not.
   !@test
   subroutine test_neighbours()
      integer, parameter :: n = 48
      type(trial_case_t) :: case
      real(dp), allocatable :: values(:, :), results(:, :), alone(:, :)
      real(dp) :: errors(n), counts(0)
      integer :: status(n), own(n), order(n), i, k

      call new_wave(case, 0.3_dp, 0.3_dp)
      allocate (values(size(case%values), n), results(size(case%model%results), n), alone(size(case%model%results), n))
      do i = 1, n
         call case%give('stress', 0.1_dp*modulo(i, 3)*unit)
         call case%give('turning_pressure', merge(0.1_dp*unit*modulo(i/3, 2), unset, modulo(i/6, 2) == 0))
         call case%give('mean_pressure', (0.1_dp*(i/12) - 0.01_dp)*unit)
         values(:, i) = case%values
         call case%solve()
         alone(:, i) = case%results(:, 1)
         own(i) = case%status(1)
      end do
      do k = 1, n - 1
         ! steps without a common divisor meet each point
         if (mod(k, 2) == 0 .or. mod(k, 3) == 0) cycle
         order = 1 + modulo([(i*k, i=1, n)], n)
         call case%model%solve_block(values(:, order), results, errors, status, counts)
#line 518 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(own(order), status, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 518) )
  if (anyExceptions()) return
#line 519 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 519 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(0, sum(n_different_bits(alone(:, order), results)), &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 519) )
  if (anyExceptions()) return
#line 520 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
      end do
#line 521 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertTrue(any(own == status_no_equilibrium) .and. count(own == status_solved) > n/2, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 521) )
  if (anyExceptions()) return
#line 522 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
   end subroutine test_neighbours

   ! Any stress and range, both branches and controls, turned or not: all are found, and keep the conditions of contact.
   !@test
   subroutine test_plane()
      real(dp), parameter :: steps(5) = [0.6180339887498949_dp, 0.4142135623730951_dp, 0.7320508075688772_dp, &
         & 0.2360679774997897_dp, 0.6457513110645906_dp]
      type(trial_case_t) :: case
      character(longest_label) :: label
      real(dp) :: u(5), s, eta
      integer :: i, branch, counts(0:1)

      counts = 0
      do i = 1, 2000
         u = modulo(i*steps, 1.0_dp)
         s = 10**(23.9_dp*(u(1) - 0.5_dp)*merge(1.0_dp, 0.2_dp, mod(i, 2) == 0))
         eta = 10**(23.9_dp*(u(2) - 0.5_dp)*merge(1.0_dp, 0.2_dp, mod(i, 2) == 0))
         if (mod(i, 10) == 0) eta = 1.85_dp + 0.3_dp*u(2)
         write (label, '(i0, 5g16.8)') i, s, eta, u(3:)
         call new_wave(case, s, eta)
         if (u(3) < 0.3_dp) call case%give('turning_pressure', u(4)*unit)
         branch = merge(branch_adhered, branch_approach, u(3) < 0.6_dp)
         if (mod(i, 4) < 2) then
            call solve_load(case, merge(1.05_dp*u(5), (1 + s)*1.1_dp*u(5) - s, mod(i, 3) == 0), branch)
         else
            call solve_penetration(case, merge(2*u(5), (1 + 1.2_dp*eta)*u(5) - 1.2_dp*eta + 1, mod(i, 3) == 0) - 1, branch)
         end if
#line 549 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertTrue(case%status(1) /= status_not_converged, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 549) )
  if (anyExceptions()) return
#line 550 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 550 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertTrue(case%found('hysteresis_loss') >= 0, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 550) )
  if (anyExceptions()) return
#line 551 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 551 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertTrue(case%found('pull_off_pressure') >= -s*unit*(1 + digits), message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 551) )
  if (anyExceptions()) return
#line 552 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
         counts(case%status(1)) = counts(case%status(1)) + 1
         if (case%status(1) /= status_solved) cycle
#line 554 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertLessThan(case%found('contact_violation'), 1.0e-12_dp, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 554) )
  if (anyExceptions()) return
#line 555 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 555 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertTrue(case%found('mean_gap') >= 0 .and. case%found('largest_gap') >= 0, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 555) )
  if (anyExceptions()) return
#line 556 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
      end do
#line 557 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertTrue(all(counts > 50), &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 557) )
  if (anyExceptions()) return
#line 558 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
   end subroutine test_plane

   ! Pressures and gaps along the wave in each regime.
   !@test
   subroutine test_profiles()
      type(trial_case_t) :: case
      real(dp), allocatable :: profiles(:, :, :)
      real(dp), parameter :: penetrations(4) = [-0.5_dp, -0.2_dp, 0.5_dp, 0.99_dp]
      real(dp) :: means(2), p0
      integer, parameter :: regimes(4) = [0, 3, 4, 5], n = 4001
      integer :: k

      p0 = 0.05_dp*unit
      do k = 1, 4
         call new_wave(case, 0.05_dp, 0.3_dp)
         call case%give('profiles', 1.0_dp)
         call case%give('x_max', period)
         call case%give('n_x', real(n, dp))
         call solve_penetration(case, penetrations(k), branch_approach)
#line 577 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(regimes(k), nint(case%found('regime')), &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 577) )
  if (anyExceptions()) return
#line 578 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
         call case%get_profiles(profiles)
#line 579 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(case%found('peak_pressure'), profiles(1, 1, 1), tolerance=1.0e-12_dp*unit, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 579) )
  if (anyExceptions()) return
#line 580 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 580 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(case%found('largest_gap'), profiles((n + 1)/2, 1, 2), tolerance=1.0e-12_dp*amplitude, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 580) )
  if (anyExceptions()) return
#line 581 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 581 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertTrue(all(profiles(:, 1, 1) >= -p0*(1 + 1.0e-12_dp) .and. profiles(:, 1, 2) >= 0), &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 581) )
  if (anyExceptions()) return
#line 582 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 582 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertTrue(all(profiles(:, 1, 2) <= 0 .or. profiles(:, 1, 1) <= 0), &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 582) )
  if (anyExceptions()) return
#line 583 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
         ! the trapezium rule of a period, with jumps and roots of the pressure at four places
         means = [sum(profiles(2:, 1, 1)), sum(profiles(2:, 1, 2))]/(n - 1)
#line 585 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(case%found('mean_pressure'), means(1), tolerance=4*p0/n, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 585) )
  if (anyExceptions()) return
#line 586 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 586 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(case%found('mean_gap'), means(2), tolerance=1.0e-5_dp*amplitude, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 586) )
  if (anyExceptions()) return
#line 587 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
      end do
   end subroutine test_profiles

   subroutine check_problem(case, start, words)
      type(trial_case_t), intent(in) :: case
      character(*), intent(in) :: start, words
      character(:), allocatable :: text

      text = case%problems_of()
#line 596 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(1, index(text, 'case: &'//start//': '), message=text, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 596) )
  if (anyExceptions()) return
#line 597 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 597 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertGreaterThan(index(text, words), len(start), message=text, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 597) )
  if (anyExceptions()) return
#line 598 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
#line 598 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
  call assertEqual(len(text), index(text, new_line('a')), message=text, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_model.pf', &
 & 598) )
  if (anyExceptions()) return
#line 599 "/work/main/tests/classical/classical_adhesive_wave_model.pf"
   end subroutine check_problem

   !@test
   subroutine test_rejections()
      type(trial_case_t) :: case

      call new_wave(case, 0.3_dp, 0.3_dp)
      call case%give('mean_pressure', 0.0_dp)
      call case%give('surface_energy', 1.0_dp)
      call check_problem(case, 'adhesion surface_energy', 'stands beside range')
      call case%give('surface_energy', unset)
      call case%give('range', unset)
      call check_problem(case, 'adhesion surface_energy', 'is missing [J/m^2]; stress needs it, or range')
      call case%give('stress', unset)
      call case%give('range', 1.0_dp)
      call check_problem(case, 'adhesion stress', 'is missing [Pa]; range needs it')
      call case%give('range', unset)
      call case%give('surface_energy', 1.0_dp)
      call check_problem(case, 'adhesion stress', 'is missing [Pa]; surface_energy needs it')
      call case%give('surface_energy', unset)
      call case%give('turning_pressure', 0.0_dp)
      call check_problem(case, 'adhesion turning_pressure', 'has no meaning without a stress')
      call case%give('turning_pressure', unset)
      call case%give('mean_pressure', -1.0_dp)
      call check_problem(case, 'operating mean_pressure', 'is below 0, but nothing pulls without &adhesion')

      call new_wave(case, 0.3_dp, 0.3_dp)
      call case%give('mean_pressure', -1.0_dp)
      call case%give('branch', real(branch_approach, dp))
      call case%give('turning_pressure', 0.0_dp)
      call check_problem(case, 'adhesion turning_pressure', 'has no meaning for branch = ''approach''')
      call new_wave(case, 1.0e-13_dp, 1.0_dp)
      call case%give('mean_pressure', 0.0_dp)
      call check_problem(case, 'adhesion stress', 'or its range is too small or too large for the wave')
      call new_wave(case, 1.0_dp, 1.0e13_dp)
      call case%give('mean_pressure', 0.0_dp)
      call check_problem(case, 'adhesion stress', 'or its range is too small or too large for the wave')
      call new_wave(case, 0.3_dp, 0.3_dp)
      call case%give('mean_pressure', 0.0_dp)
      call case%give('penetration', 0.0_dp)
      call check_problem(case, 'operating mean_pressure', 'stands beside penetration')

      ! sliding
      call new_wave(case, 0.3_dp, 0.3_dp)
      call case%give('mean_pressure', 1.0_dp)
      call case%give('contact_modulus', unset)
      call case%give('modulus', modulus)
      call case%give('velocity', 1.0_dp)
      call check_problem(case, 'adhesion stress', 'stands beside &material')
   end subroutine test_rejections

end module classical_adhesive_wave_model

module Wrapclassical_adhesive_wave_model
   use FUnit
   use classical_adhesive_wave_model
   implicit none
   private

contains


end module Wrapclassical_adhesive_wave_model

function classical_adhesive_wave_model_suite() result(suite)
   use FUnit
   use classical_adhesive_wave_model
   use Wrapclassical_adhesive_wave_model
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('classical_adhesive_wave_model_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_loads', &
      test_loads))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_penetrations', &
      test_penetrations))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_states', &
      test_states))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_events', &
      test_events))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_jkr', &
      test_jkr))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_limits', &
      test_limits))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_energy', &
      test_energy))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_loop', &
      test_loop))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_losses_of_short_ranges', &
      test_losses_of_short_ranges))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_units', &
      test_units))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_neighbours', &
      test_neighbours))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_plane', &
      test_plane))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_profiles', &
      test_profiles))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_rejections', &
      test_rejections))
   call suite%addTest(t)


end function classical_adhesive_wave_model_suite


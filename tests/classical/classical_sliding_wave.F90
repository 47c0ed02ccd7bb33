! SPDX-License-Identifier: GPL-3.0-or-later
! The wave that slides over a viscoelastic half-plane: the tables, the limits, and the equations that the closed form does not use.
module classical_sliding_wave
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_material_prony, only: prony_t, new_prony
   use adfric_classical_sliding_solid, only: sliding_solid_t, new_sliding_solid, suits_solid
   use adfric_classical_sliding_wave, only: wave_contact_t, get_full_contact, wave_of_width, wave_of_pressure, wave_of_penetration
   use adfric_classical_sliding_wave_profile, only: sliding_wave_pressure, sliding_wave_gap, sliding_wave_displacement
   use adfric_classical_sliding_wave_survey, only: wave_survey_t, survey_wave
   use adfric_classical_westergaard, only: wave_half_width, wave_penetration, wave_pressure, wave_gap
   use reference_table, only: table_t, read_table, table_digits
   use sliding_cases, only: solid_of, prony_of_cells, named_prony, pressure_samples_t, sample_pressure, pressure_mode, &
      & complex_ratio
   use funit
   implicit none (type, external)

   real(dp), parameter :: closed_form = 100*epsilon(1.0_dp)
   integer, parameter :: longest_label = 400

contains

   ! One arm, two equations in the two edges by other hands; pressures of the table are in p*, stresses in E0 k^2 D^2 = 2 k D p*.
   !@test
   subroutine test_one_arm()
      type(table_t) :: table
      character(longest_label) :: label
      type(wave_contact_t) :: contact, back
      type(sliding_solid_t) :: solid
      real(dp) :: q, shift, half_width
      logical :: is_converged
      integer :: row

      call read_table(table, 'visco_wave_sls')
#line 35 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertEqual(133, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 35) )
  if (anyExceptions()) return
#line 36 "/work/main/tests/classical/classical_sliding_wave.pf"
      do row = 1, table%n_rows
         label = table%label(row)
         q = table%number(row, 'p_over_p0star')
         solid = solid_of([table%number(row, 'r') - 1], [1.0_dp], table%number(row, 'a'))
         call wave_of_pressure(solid, q, contact, is_converged)
#line 41 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertTrue(is_converged, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 41) )
  if (anyExceptions()) return
#line 42 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 42 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertTrue(contact%is_full .eqv. table%text(row, 'regime') == 'full', message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 42) )
  if (anyExceptions()) return
#line 43 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 43 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(table%number(row, 'friction'), contact%friction/2, tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 43) )
  if (anyExceptions()) return
#line 44 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 44 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(table%number(row, 'mu'), contact%friction/q, tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 44) )
  if (anyExceptions()) return
#line 45 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 45 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(table%number(row, 'pen'), contact%penetration, tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 45) )
  if (anyExceptions()) return
#line 46 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 46 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(table%number(row, 'area'), contact%half_width/pi, tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 46) )
  if (anyExceptions()) return
#line 47 "/work/main/tests/classical/classical_sliding_wave.pf"
         if (contact%is_full) cycle
         shift = (table%number(row, 'leading') + table%number(row, 'trailing'))/2
         half_width = (table%number(row, 'leading') - table%number(row, 'trailing'))/2
#line 50 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertEqual(shift, contact%shift%shift, tolerance=table_digits*half_width, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 50) )
  if (anyExceptions()) return
#line 51 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 51 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertEqual(half_width, contact%half_width, tolerance=table_digits*half_width, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 51) )
  if (anyExceptions()) return
#line 52 "/work/main/tests/classical/classical_sliding_wave.pf"
         call wave_of_penetration(solid, contact%penetration, back, is_converged)
#line 53 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 53) )
  if (anyExceptions()) return
#line 54 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 54 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(q, back%mean_pressure, tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 54) )
  if (anyExceptions()) return
#line 55 "/work/main/tests/classical/classical_sliding_wave.pf"
      end do
   end subroutine test_one_arm

   ! Two and three arms, by contour integrals; their mean pressures are in E0, which is 2 p*.
   !@test
   subroutine test_several_arms()
      type(table_t) :: table
      character(longest_label) :: label
      type(wave_contact_t) :: contact
      type(sliding_solid_t) :: solid
      type(prony_t) :: prony
      logical :: is_converged
      integer :: row

      call read_table(table, 'visco_wave_prony')
#line 70 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertEqual(5, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 70) )
  if (anyExceptions()) return
#line 71 "/work/main/tests/classical/classical_sliding_wave.pf"
      do row = 1, table%n_rows
         label = table%label(row)
         prony = prony_of_cells(table%text(row, 'moduli'), table%text(row, 'times'))
         call new_sliding_solid(solid, prony, table%number(row, 'V'))
         call wave_of_pressure(solid, 2*table%number(row, 'q'), contact, is_converged)
#line 76 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 76) )
  if (anyExceptions()) return
#line 77 "/work/main/tests/classical/classical_sliding_wave.pf"
         associate (shift => contact%shift%shift, w => contact%half_width)
#line 78 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(table%number(row, 'trailing'), shift - w, tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 78) )
  if (anyExceptions()) return
#line 79 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 79 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(table%number(row, 'leading'), shift + w, tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 79) )
  if (anyExceptions()) return
#line 80 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 80 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(table%number(row, 'area'), w/pi, tolerance=table_digits, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 80) )
  if (anyExceptions()) return
#line 81 "/work/main/tests/classical/classical_sliding_wave.pf"
         end associate
#line 82 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(table%number(row, 'mu'), contact%friction/contact%mean_pressure, tolerance=table_digits, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 82) )
  if (anyExceptions()) return
#line 83 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 83 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(table%number(row, 'pen'), contact%penetration, tolerance=table_digits, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 83) )
  if (anyExceptions()) return
#line 84 "/work/main/tests/classical/classical_sliding_wave.pf"
      end do
   end subroutine test_several_arms

   ! To 13 arms, V tau from 1e-15 to 1e15, moduli to 1e4 of the relaxed one, contacts from 1e-7 of the period to nearly all.
   !@test
   subroutine test_hard_cases()
      type(table_t) :: table
      character(longest_label) :: label
      type(wave_contact_t) :: contact
      type(sliding_solid_t) :: solid
      type(prony_t) :: prony
      logical :: is_converged
      integer :: row

      call read_table(table, 'visco_wave_arms')
#line 99 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertEqual(48, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 99) )
  if (anyExceptions()) return
#line 100 "/work/main/tests/classical/classical_sliding_wave.pf"
      do row = 1, table%n_rows
         label = table%label(row)
         prony = prony_of_cells(table%text(row, 'moduli'), table%text(row, 'times'))
         call new_sliding_solid(solid, prony, table%number(row, 'V'))
         call wave_of_width(solid, table%number(row, 'logarithm'), contact, is_converged)
#line 105 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertTrue(is_converged, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 105) )
  if (anyExceptions()) return
#line 106 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 106 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(table%number(row, 'q'), contact%mean_pressure/2, tolerance=closed_form, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 106) )
  if (anyExceptions()) return
#line 107 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 107 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(table%number(row, 'shift'), contact%shift%shift, tolerance=closed_form, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 107) )
  if (anyExceptions()) return
#line 108 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 108 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(table%number(row, 'friction'), contact%friction/2, tolerance=closed_form, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 108) )
  if (anyExceptions()) return
#line 109 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 109 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(table%number(row, 'pen'), contact%penetration, tolerance=closed_form, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 109) )
  if (anyExceptions()) return
#line 110 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 110 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(table%number(row, 'mean'), contact%mean_gap, tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 110) )
  if (anyExceptions()) return
#line 111 "/work/main/tests/classical/classical_sliding_wave.pf"
      end do
   end subroutine test_hard_cases

   ! The contact found from a mean pressure, or from a penetration, is the one it was taken from. Near full contact both are level.
   !@test
   subroutine test_round_trips()
      type(table_t) :: table
      character(longest_label) :: label
      type(wave_contact_t) :: contact, back
      type(sliding_solid_t) :: solid
      type(prony_t) :: prony
      real(dp) :: level
      logical :: is_converged
      integer :: row

      call read_table(table, 'visco_wave_arms')
      do row = 1, table%n_rows
         label = table%label(row)
         prony = prony_of_cells(table%text(row, 'moduli'), table%text(row, 'times'))
         call new_sliding_solid(solid, prony, table%number(row, 'V'))
         call wave_of_width(solid, table%number(row, 'logarithm'), contact, is_converged)
         level = 1/contact%cosine**2
         call wave_of_pressure(solid, contact%mean_pressure, back, is_converged)
#line 134 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertTrue(is_converged, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 134) )
  if (anyExceptions()) return
#line 135 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 135 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(contact%half_width, back%half_width, tolerance=closed_form*level, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 135) )
  if (anyExceptions()) return
#line 136 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 136 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(contact%friction, back%friction, tolerance=closed_form*level, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 136) )
  if (anyExceptions()) return
#line 137 "/work/main/tests/classical/classical_sliding_wave.pf"
         call wave_of_penetration(solid, contact%penetration, back, is_converged)
#line 138 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertTrue(is_converged, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 138) )
  if (anyExceptions()) return
#line 139 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 139 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(contact%half_width, back%half_width, tolerance=closed_form*level**2, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 139) )
  if (anyExceptions()) return
#line 140 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 140 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(contact%mean_pressure, back%mean_pressure, tolerance=closed_form*level**2, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 140) )
  if (anyExceptions()) return
#line 141 "/work/main/tests/classical/classical_sliding_wave.pf"
      end do
   end subroutine test_round_trips

   ! Mean pressure and friction rise with the width, which the search of a width relies on.
   !@test
   subroutine test_monotony()
      type(wave_contact_t) :: contact
      real(dp) :: q, penetration
      logical :: is_converged
      integer :: i, k

      do k = -4, 4
         q = 0
         penetration = 0
         do i = -40, 32
            call wave_of_width(solid_of([9.0_dp, 990.0_dp], [1.0_dp, 1.0e-3_dp], 10.0_dp**k), i/4.0_dp, contact, is_converged)
#line 157 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 157) )
  if (anyExceptions()) return
#line 158 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 158 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertGreaterThan(contact%mean_pressure, q, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 158) )
  if (anyExceptions()) return
#line 159 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 159 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertGreaterThan(contact%penetration, penetration, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 159) )
  if (anyExceptions()) return
#line 160 "/work/main/tests/classical/classical_sliding_wave.pf"
            q = contact%mean_pressure
            penetration = contact%penetration
         end do
      end do
   end subroutine test_monotony

   ! Any spectrum in full contact; the stresses of the table are in E0 k^2 D^2, its pressures in E0 k D.
   !@test
   subroutine test_full_contact()
      type(table_t) :: table
      character(longest_label) :: label
      type(wave_contact_t) :: contact
      type(sliding_solid_t) :: solid
      real(dp) :: storage, loss, just_above, p
      logical :: is_converged
      integer :: row

      call read_table(table, 'visco_full_contact_prony')
#line 178 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertEqual(32, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 178) )
  if (anyExceptions()) return
#line 179 "/work/main/tests/classical/classical_sliding_wave.pf"
      do row = 1, table%n_rows
         label = table%label(row)
         call new_sliding_solid(solid, named_prony(table%text(row, 'material')), table%number(row, 'kV'))
         call solid%get_complex_ratio(storage, loss)
#line 183 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(table%number(row, 'E_storage'), storage, tolerance=closed_form, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 183) )
  if (anyExceptions()) return
#line 184 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 184 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(table%number(row, 'E_loss'), loss, tolerance=closed_form, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 184) )
  if (anyExceptions()) return
#line 185 "/work/main/tests/classical/classical_sliding_wave.pf"
         call get_full_contact(solid, contact)
#line 186 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(table%number(row, 'T_over'), contact%friction/2, tolerance=closed_form, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 186) )
  if (anyExceptions()) return
#line 187 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 187 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(table%number(row, 'p_full'), contact%mean_pressure/2, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 187) )
  if (anyExceptions()) return
#line 188 "/work/main/tests/classical/classical_sliding_wave.pf"
         just_above = contact%mean_pressure*1.5_dp
         call wave_of_pressure(solid, just_above, contact, is_converged)
#line 190 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertTrue(is_converged .and. contact%is_full, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 190) )
  if (anyExceptions()) return
#line 191 "/work/main/tests/classical/classical_sliding_wave.pf"
         ! p = q + |E| cos(x - d), and the surface follows the wave
         p = sliding_wave_pressure(solid, contact, 0.0_dp)
#line 193 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(just_above + storage, p, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 193) )
  if (anyExceptions()) return
#line 194 "/work/main/tests/classical/classical_sliding_wave.pf"
         p = sliding_wave_pressure(solid, contact, pi/2)
#line 195 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(just_above + loss, p, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 195) )
  if (anyExceptions()) return
#line 196 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 196 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertEqual(0.0_dp, sliding_wave_gap(solid, contact, 1.0_dp), &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 196) )
  if (anyExceptions()) return
#line 197 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 197 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertEqual(cos(1.0_dp), sliding_wave_displacement(solid, contact, 1.0_dp), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 197) )
  if (anyExceptions()) return
#line 198 "/work/main/tests/classical/classical_sliding_wave.pf"
      end do
   end subroutine test_full_contact

   ! Just below full contact all tends to it, to the order of C^2 ln C^2 for lengths about 1.
   !@test
   subroutine test_nearly_full()
      type(wave_contact_t) :: contact, full
      type(sliding_solid_t) :: solid
      logical :: is_converged
      integer :: k
      real(dp), parameter :: order = 30*exp(-26.0_dp)

      do k = -1, 1
         solid = solid_of([9.0_dp, 3.0_dp], [1.0_dp, 3.0_dp], 3.0_dp**k)
         call get_full_contact(solid, full)
         call wave_of_width(solid, 13.0_dp, contact, is_converged)
#line 214 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(full%mean_pressure, contact%mean_pressure, tolerance=order, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 214) )
  if (anyExceptions()) return
#line 215 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 215 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(full%friction, contact%friction, tolerance=order, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 215) )
  if (anyExceptions()) return
#line 216 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 216 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(full%shift%shift, contact%shift%shift, tolerance=order, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 216) )
  if (anyExceptions()) return
#line 217 "/work/main/tests/classical/classical_sliding_wave.pf"
      end do
   end subroutine test_nearly_full

   ! At rest, slowly and fast: Westergaard's wave with the relaxed and the instantaneous modulus, whose lengths are in periods.
   !@test
   subroutine test_elastic_limits()
      type(wave_contact_t) :: contact
      type(sliding_solid_t) :: solid
      real(dp) :: q, near, modulus, x, p
      logical :: is_converged
      integer :: k, i
      real(dp), parameter :: speeds(5) = [0.0_dp, 1.0e-12_dp, 1.0e-9_dp, 1.0e9_dp, 1.0e12_dp]

      do k = 1, 5
         modulus = merge(1, 30, speeds(k) < 1)
         ! the edges move by about b - a at slow speed, and the modulus by 1/a where it is high
         near = closed_form + 100*min(speeds(k), 1/max(speeds(k), tiny(near)))
         solid = solid_of([9.0_dp, 20.0_dp], [1.0_dp, 2.0_dp], speeds(k))
         do i = 1, 9
            q = 0.1_dp*i
            call wave_of_pressure(solid, q*modulus, contact, is_converged)
#line 238 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 238) )
  if (anyExceptions()) return
#line 239 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 239 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(2*pi*wave_half_width(q), contact%half_width, tolerance=near, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 239) )
  if (anyExceptions()) return
#line 240 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 240 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(wave_penetration(q), contact%penetration, tolerance=near, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 240) )
  if (anyExceptions()) return
#line 241 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 241 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertEqual(0.0_dp, contact%shift%shift, tolerance=near, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 241) )
  if (anyExceptions()) return
#line 242 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 242 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertEqual(0.0_dp, contact%friction/contact%mean_pressure, tolerance=near, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 242) )
  if (anyExceptions()) return
#line 243 "/work/main/tests/classical/classical_sliding_wave.pf"
            x = contact%half_width/3
            p = modulus*wave_pressure(q, x/(2*pi))
#line 245 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(p, sliding_wave_pressure(solid, contact, x), tolerance=near, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 245) )
  if (anyExceptions()) return
#line 246 "/work/main/tests/classical/classical_sliding_wave.pf"
            x = (contact%half_width + pi)/2
#line 247 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(wave_gap(q, x/(2*pi)), sliding_wave_gap(solid, contact, x), tolerance=near, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 247) )
  if (anyExceptions()) return
#line 248 "/work/main/tests/classical/classical_sliding_wave.pf"
         end do
      end do
   end subroutine test_elastic_limits

   ! Slow: T/V tends to a constant; fast: T V does. Both to the order of V and 1/V.
   !@test
   subroutine test_friction_limits()
      type(wave_contact_t) :: contact, slower
      real(dp) :: speed
      logical :: is_converged
      integer :: k
      real(dp), parameter :: moduli(2) = [9.0_dp, 20.0_dp], times(2) = [1.0_dp, 2.0_dp]

      do k = -1, 1, 2
         speed = 10.0_dp**(6*k)
         call wave_of_pressure(solid_of(moduli, times, speed), 0.4_dp, contact, is_converged)
         call wave_of_pressure(solid_of(moduli, times, speed*10.0_dp**k), 0.4_dp, slower, is_converged)
#line 265 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(contact%friction, 10*slower%friction, tolerance=1.0e-3_dp, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 265) )
  if (anyExceptions()) return
#line 266 "/work/main/tests/classical/classical_sliding_wave.pf"
      end do
   end subroutine test_friction_limits

   ! The pressure is that of the displacement, mode by mode, p_k = |k| E(-k V) u_k; it has the mean q and the friction T.
   !@test
   subroutine test_modes()
      integer, parameter :: n = 4096, n_modes = 4
      !> Sums over the displacement at midpoints: the slope has roots at the edges, and the error is of the order n^(-5/2).
      real(dp), parameter :: midpoints = 30*4096.0_dp**(-2.5_dp)
      real(dp), parameter :: speeds(4) = [0.1_dp, 0.3_dp, 3.0_dp, 30.0_dp], loads(4) = [0.8_dp, 0.4_dp, 1.5_dp, 0.05_dp]
      type(wave_contact_t) :: contact
      type(sliding_solid_t) :: solid
      type(pressure_samples_t) :: samples
      complex(dp) :: mode, u
      real(dp) :: x(n), displacement(n)
      logical :: is_converged
      integer :: i, j, k

      x = ([(i, i=1, n)] - 0.5_dp)*(2*pi/n)
      do j = 1, 4
         solid = solid_of([3.0_dp, 6.0_dp, 90.0_dp], [1.0_dp, 0.1_dp, 0.01_dp], speeds(j))
         call wave_of_pressure(solid, loads(j), contact, is_converged)
         samples = sample_pressure(solid, contact, 1500)
#line 289 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(contact%mean_pressure, sum(samples%share), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 289) )
  if (anyExceptions()) return
#line 290 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 290 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(contact%friction, sum(samples%share*sin(samples%x)), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 290) )
  if (anyExceptions()) return
#line 291 "/work/main/tests/classical/classical_sliding_wave.pf"
         do i = 1, n
            displacement(i) = sliding_wave_displacement(solid, contact, x(i))
         end do
#line 294 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertEqual(0.0_dp, sum(displacement)/n, tolerance=midpoints, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 294) )
  if (anyExceptions()) return
#line 295 "/work/main/tests/classical/classical_sliding_wave.pf"
         do k = 1, n_modes
            mode = pressure_mode(samples, k)
            u = sum(displacement*exp(cmplx(0.0_dp, -k*x, dp)))/n
#line 298 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertEqual(0.0_dp, abs(mode/(k*complex_ratio(solid, k)) - u), tolerance=midpoints, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 298) )
  if (anyExceptions()) return
#line 299 "/work/main/tests/classical/classical_sliding_wave.pf"
         end do
      end do
   end subroutine test_modes

   ! T is what the modes lose, the sum of 2 E''(k V) |p_k|^2/|E(k V)|^2: it meets the loss modulus nowhere else. The pressure has
   ! roots at the edges, so the terms fall as k^(-4), and what is left out is a seventh of the second half, but for the next order.
   !@test
   subroutine test_power()
      integer, parameter :: n_modes = 400
      real(dp), parameter :: next_order = 0.05_dp
      type(wave_contact_t) :: contact
      type(sliding_solid_t) :: solid
      type(pressure_samples_t) :: samples
      complex(dp) :: ratio
      real(dp) :: loss, half_loss, rest
      logical :: is_converged
      integer :: j, k

      do j = -1, 3
         solid = solid_of([3.0_dp, 6.0_dp, 20.0_dp], [1.0_dp, 0.7_dp, 0.4_dp], 10.0_dp**j)
         call wave_of_pressure(solid, 0.5_dp, contact, is_converged)
         samples = sample_pressure(solid, contact, 1500)
         loss = 0
         do k = 1, n_modes
            ratio = complex_ratio(solid, k)
            loss = loss - 2*aimag(ratio)*abs(pressure_mode(samples, k)/ratio)**2
            if (k == n_modes/2) half_loss = loss
         end do
         rest = (loss - half_loss)/7
#line 328 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertLessThan(rest, 1.0e-6_dp*loss, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 328) )
  if (anyExceptions()) return
#line 329 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 329 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertEqual(loss + rest, contact%friction, tolerance=next_order*rest, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 329) )
  if (anyExceptions()) return
#line 330 "/work/main/tests/classical/classical_sliding_wave.pf"
      end do
   end subroutine test_power

   ! Pressure and gap are nowhere negative, the pressure is 0 in the gap, and the gap in the contact; both repeat.
   !@test
   subroutine test_contact_conditions()
      type(wave_contact_t) :: contact
      type(sliding_solid_t) :: solid
      real(dp) :: x, p, g
      logical :: is_converged
      integer :: i, k

      do k = -6, 6, 2
         solid = solid_of([9.0_dp, 1.0e4_dp], [1.0_dp, 1.0e-2_dp], 10.0_dp**k)
         call wave_of_width(solid, 0.3_dp, contact, is_converged)
         do i = -20, 20
            x = contact%shift%shift + i*pi/20
            p = sliding_wave_pressure(solid, contact, x)
            g = sliding_wave_gap(solid, contact, x)
            if (abs(i*pi/20) < contact%half_width) then
#line 350 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertGreaterThan(p, 0.0_dp, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 350) )
  if (anyExceptions()) return
#line 351 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 351 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertEqual(0.0_dp, g, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 351) )
  if (anyExceptions()) return
#line 352 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 352 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(p, sliding_wave_pressure(solid, contact, x - 4*pi), tolerance=1.0e-11_dp, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 352) )
  if (anyExceptions()) return
#line 353 "/work/main/tests/classical/classical_sliding_wave.pf"
            else
#line 354 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertEqual(0.0_dp, p, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 354) )
  if (anyExceptions()) return
#line 355 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 355 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertGreaterThan(g, 0.0_dp, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 355) )
  if (anyExceptions()) return
#line 356 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 356 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(g, sliding_wave_gap(solid, contact, x + 2*pi), tolerance=1.0e-11_dp, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 356) )
  if (anyExceptions()) return
#line 357 "/work/main/tests/classical/classical_sliding_wave.pf"
            end if
         end do
      end do
   end subroutine test_contact_conditions

   ! Next to both edges a spectrum of 15 decades has a pressure and a gap. At the trailing edge the integrals of short arms are
   ! round-off of their own terms; at the leading edge the solid is a glass, and the pressure may have its maximum there.
   !@test
   subroutine test_next_to_the_edges()
      type(wave_contact_t) :: contact
      type(sliding_solid_t) :: solid
      type(wave_survey_t) :: survey
      real(dp) :: p, g, last_p, last_g, distance
      logical :: is_converged
      integer :: i, k, side
      real(dp), parameter :: moduli(15) = [(1.5_dp*4.0_dp**(6 - abs(i - 6)), i=1, 15)], &
         & times(15) = [(10.0_dp**(i - 13), i=1, 15)]

      do k = -2, 4, 2
         solid = solid_of(moduli, times, 10.0_dp**k)
         call wave_of_width(solid, 0.0_dp, contact, is_converged)
#line 378 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 378) )
  if (anyExceptions()) return
#line 379 "/work/main/tests/classical/classical_sliding_wave.pf"
         call survey_wave(solid, contact, survey)
#line 380 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertRelativelyEqual(contact%friction, survey%friction, tolerance=table_digits, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 380) )
  if (anyExceptions()) return
#line 381 "/work/main/tests/classical/classical_sliding_wave.pf"
         do side = -1, 1, 2
            last_p = 0
            last_g = 0
            do i = -13, -2
               distance = 10.0_dp**i
               associate (m => contact%shift%shift, w => contact%half_width)
                  p = sliding_wave_pressure(solid, contact, m + side*(w - distance))
                  g = sliding_wave_gap(solid, contact, m + side*(w + distance))
               end associate
#line 390 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertGreaterThan(p, merge(last_p, 0.0_dp, side < 0), &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 390) )
  if (anyExceptions()) return
#line 391 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 391 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertLessThanOrEqual(p, survey%peak_pressure*(1 + closed_form), &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 391) )
  if (anyExceptions()) return
#line 392 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 392 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertGreaterThanOrEqual(g, last_g - closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 392) )
  if (anyExceptions()) return
#line 393 "/work/main/tests/classical/classical_sliding_wave.pf"
               last_p = p
               last_g = g
            end do
         end do
      end do
   end subroutine test_next_to_the_edges

   !@test
   subroutine test_no_contact()
      type(wave_contact_t) :: contact
      type(sliding_solid_t) :: solid
      logical :: is_converged

      solid = solid_of([9.0_dp], [1.0_dp], 1.0_dp)
      call wave_of_pressure(solid, 0.0_dp, contact, is_converged)
#line 408 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 408) )
  if (anyExceptions()) return
#line 409 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 409 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertEqual(0.0_dp, contact%half_width, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 409) )
  if (anyExceptions()) return
#line 410 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 410 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertEqual(1.0_dp, contact%mean_gap, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 410) )
  if (anyExceptions()) return
#line 411 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 411 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertEqual(2.0_dp, sliding_wave_gap(solid, contact, pi), &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 411) )
  if (anyExceptions()) return
#line 412 "/work/main/tests/classical/classical_sliding_wave.pf"
      call wave_of_penetration(solid, -0.5_dp, contact, is_converged)
#line 413 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 413) )
  if (anyExceptions()) return
#line 414 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 414 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertEqual(0.0_dp, contact%mean_pressure, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 414) )
  if (anyExceptions()) return
#line 415 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 415 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertEqual(1.5_dp, contact%mean_gap, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 415) )
  if (anyExceptions()) return
#line 416 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 416 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertEqual(0.5_dp, sliding_wave_gap(solid, contact, 0.0_dp), &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 416) )
  if (anyExceptions()) return
#line 417 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 417 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertEqual(0.0_dp, sliding_wave_displacement(solid, contact, 1.0_dp), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 417) )
  if (anyExceptions()) return
#line 418 "/work/main/tests/classical/classical_sliding_wave.pf"
   end subroutine test_no_contact

   ! A tension, a penetration beyond the amplitude, and speeds whose lengths double precision cannot hold.
   !@test
   subroutine test_rejections()
      type(wave_contact_t) :: contact
      type(sliding_solid_t) :: solid
      type(prony_t) :: prony
      logical :: is_converged

      solid = solid_of([9.0_dp], [1.0_dp], 1.0_dp)
      call wave_of_pressure(solid, -0.1_dp, contact, is_converged)
#line 430 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertFalse(is_converged, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 430) )
  if (anyExceptions()) return
#line 431 "/work/main/tests/classical/classical_sliding_wave.pf"
      call wave_of_penetration(solid, 1.0001_dp, contact, is_converged)
#line 432 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertFalse(is_converged, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 432) )
  if (anyExceptions()) return
#line 433 "/work/main/tests/classical/classical_sliding_wave.pf"
      call wave_of_penetration(solid, 1.0_dp, contact, is_converged)
#line 434 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertTrue(is_converged .and. contact%is_full, &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 434) )
  if (anyExceptions()) return
#line 435 "/work/main/tests/classical/classical_sliding_wave.pf"
      call new_prony(prony, 1.0_dp, [9.0_dp], [1.0_dp])
#line 436 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertTrue(suits_solid(prony, 0.0_dp), &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 436) )
  if (anyExceptions()) return
#line 437 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 437 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertTrue(suits_solid(prony, 1.0_dp), &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 437) )
  if (anyExceptions()) return
#line 438 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 438 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertFalse(suits_solid(prony, -1.0_dp), &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 438) )
  if (anyExceptions()) return
#line 439 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 439 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertFalse(suits_solid(prony, 1.0e-101_dp), &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 439) )
  if (anyExceptions()) return
#line 440 "/work/main/tests/classical/classical_sliding_wave.pf"
#line 440 "/work/main/tests/classical/classical_sliding_wave.pf"
  call assertFalse(suits_solid(prony, 1.0e100_dp), &
 & location=SourceLocation( &
 & 'classical_sliding_wave.pf', &
 & 440) )
  if (anyExceptions()) return
#line 441 "/work/main/tests/classical/classical_sliding_wave.pf"
   end subroutine test_rejections

end module classical_sliding_wave

module Wrapclassical_sliding_wave
   use FUnit
   use classical_sliding_wave
   implicit none
   private

contains


end module Wrapclassical_sliding_wave

function classical_sliding_wave_suite() result(suite)
   use FUnit
   use classical_sliding_wave
   use Wrapclassical_sliding_wave
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('classical_sliding_wave_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_one_arm', &
      test_one_arm))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_several_arms', &
      test_several_arms))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_hard_cases', &
      test_hard_cases))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_round_trips', &
      test_round_trips))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_monotony', &
      test_monotony))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_full_contact', &
      test_full_contact))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_nearly_full', &
      test_nearly_full))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_elastic_limits', &
      test_elastic_limits))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_friction_limits', &
      test_friction_limits))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_modes', &
      test_modes))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_power', &
      test_power))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_contact_conditions', &
      test_contact_conditions))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_next_to_the_edges', &
      test_next_to_the_edges))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_no_contact', &
      test_no_contact))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_rejections', &
      test_rejections))
   call suite%addTest(t)


end function classical_sliding_wave_suite


! SPDX-License-Identifier: GPL-3.0-or-later
! The model `wave_1d` over a viscoelastic half-plane: the tables in SI units, both controls, its limits and what it refuses.
module classical_sliding_model
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: unset
   use adfric_material_master_curve, only: master_curve_fit_t, fit_master_curve, default_terms_per_decade
   use adfric_material_prony, only: prony_t, new_prony
   use adfric_model_derived, only: derived_t
   use adfric_model_status, only: status_solved, status_no_equilibrium
   use counting_sink, only: n_different_bits
   use reference_table, only: table_t, read_table, table_digits
   use sliding_cases, only: prony_of_cells
   use trial_case, only: trial_case_t, new_case
   use funit
   implicit none (type, external)

   !> The wave: a millimetre long, 10 um of amplitude; relaxed modulus [Pa]; a time unit of the tables [s].
   real(dp), parameter :: period = 1.0e-3_dp, amplitude = 1.0e-5_dp, relaxed = 2.0e6_dp, time = 1.0e-3_dp
   !> Wave number [1/m], and the mean pressure of full contact at rest [Pa].
   real(dp), parameter :: k = 2*pi/period, full_at_rest = pi*relaxed*amplitude/period
   real(dp), parameter :: closed_form = 100*epsilon(1.0_dp)
   integer, parameter :: longest_label = 400

contains

   !> Give a list to the material.
   subroutine give_list(case, name, values)
      type(trial_case_t), intent(inout) :: case
      character(*), intent(in) :: name
      real(dp), intent(in) :: values(:)
      type(problems_t) :: problems

      associate (place => case%model%index_of('material', name))
         case%values(place) = 1
         call case%model%take_dataset(place, reshape(values, [size(values), 1]), problems)
      end associate
#line 40 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(0, problems%count(), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 40) )
  if (anyExceptions()) return
#line 41 "/work/main/tests/classical/classical_sliding_model.pf"
   end subroutine give_list

   !> The wave on a material, with moduli over the relaxed one and times in time units.
   subroutine new_slide(case, moduli, times, velocity)
      type(trial_case_t), intent(out) :: case
      real(dp), intent(in) :: moduli(:), times(:), velocity

      call new_case(case, 'wave_1d')
      call case%give('period', period)
      call case%give('amplitude', amplitude)
      call case%give('modulus', relaxed)
      call give_list(case, 'moduli', relaxed*moduli)
      call give_list(case, 'relaxation_times', time*times)
      call case%give('velocity', velocity)
   end subroutine new_slide

   !> A rubber with two arms under 0.4 of the mean pressure of full contact at rest.
   subroutine new_rubber(case, velocity)
      type(trial_case_t), intent(out) :: case
      real(dp), intent(in) :: velocity

      call new_slide(case, [3.0_dp, 6.0_dp], [1.0_dp, 0.1_dp], velocity)
      call case%give('mean_pressure', 0.4_dp*full_at_rest)
   end subroutine new_rubber

   !> One problem, which begins so.
   subroutine check_problem(case, start, text, swept)
      type(trial_case_t), intent(in) :: case
      character(*), intent(in) :: start, text
      character(*), intent(in), optional :: swept
      character(:), allocatable :: found

      found = case%problems_of(swept)
#line 74 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(1, index(found, 'case: &'//start//': '), message=found, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 74) )
  if (anyExceptions()) return
#line 75 "/work/main/tests/classical/classical_sliding_model.pf"
#line 75 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertGreaterThan(index(found, text), 0, message=found//' / '//text, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 75) )
  if (anyExceptions()) return
#line 76 "/work/main/tests/classical/classical_sliding_model.pf"
#line 76 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(len(found), index(found, new_line('a')), message=found, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 76) )
  if (anyExceptions()) return
#line 77 "/work/main/tests/classical/classical_sliding_model.pf"
   end subroutine check_problem

   !> The case at the penetration that was found for its mean pressure has this mean pressure.
   subroutine check_penetration(case, tolerance, label)
      type(trial_case_t), intent(in) :: case
      real(dp), intent(in) :: tolerance
      character(*), intent(in) :: label
      type(trial_case_t) :: other

      other = case
      call other%give('mean_pressure', unset)
      call other%give('penetration', case%found('penetration'))
#line 89 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual('', other%problems_of(), message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 89) )
  if (anyExceptions()) return
#line 90 "/work/main/tests/classical/classical_sliding_model.pf"
      call other%solve()
#line 91 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(status_solved, other%status(1), message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 91) )
  if (anyExceptions()) return
#line 92 "/work/main/tests/classical/classical_sliding_model.pf"
#line 92 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertRelativelyEqual(case%found('mean_pressure'), other%found('mean_pressure'), tolerance=tolerance, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 92) )
  if (anyExceptions()) return
#line 93 "/work/main/tests/classical/classical_sliding_model.pf"
#line 93 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(case%found('penetration'), other%found('penetration'), message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 93) )
  if (anyExceptions()) return
#line 94 "/work/main/tests/classical/classical_sliding_model.pf"
   end subroutine check_penetration

   ! One arm, by other hands.
   !@test
   subroutine test_one_arm()
      type(table_t) :: table
      type(trial_case_t) :: case
      character(longest_label) :: label
      real(dp) :: shift
      logical :: is_full
      integer :: row

      call read_table(table, 'visco_wave_sls')
#line 107 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(133, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 107) )
  if (anyExceptions()) return
#line 108 "/work/main/tests/classical/classical_sliding_model.pf"
      do row = 1, table%n_rows
         label = table%label(row)
         call new_slide(case, [table%number(row, 'r') - 1], [1.0_dp], table%number(row, 'a')/(k*time))
         call case%give('mean_pressure', table%number(row, 'p_over_p0star')*full_at_rest)
#line 112 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual('', case%problems_of(), message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 112) )
  if (anyExceptions()) return
#line 113 "/work/main/tests/classical/classical_sliding_model.pf"
         call case%solve()
#line 114 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(status_solved, case%status(1), message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 114) )
  if (anyExceptions()) return
#line 115 "/work/main/tests/classical/classical_sliding_model.pf"
         is_full = table%text(row, 'regime') == 'full'
#line 116 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(merge(2, 1, is_full), nint(case%found('regime')), message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 116) )
  if (anyExceptions()) return
#line 117 "/work/main/tests/classical/classical_sliding_model.pf"
         associate (friction => table%number(row, 'friction')*relaxed*(k*amplitude)**2)
#line 118 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertRelativelyEqual(friction, case%found('friction_stress'), tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 118) )
  if (anyExceptions()) return
#line 119 "/work/main/tests/classical/classical_sliding_model.pf"
#line 119 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertRelativelyEqual(friction, case%found('dissipation'), tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 119) )
  if (anyExceptions()) return
#line 120 "/work/main/tests/classical/classical_sliding_model.pf"
         end associate
         associate (mu => table%number(row, 'mu')*k*amplitude, depth => table%number(row, 'pen')*amplitude)
#line 122 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertRelativelyEqual(mu, case%found('friction_coefficient'), tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 122) )
  if (anyExceptions()) return
#line 123 "/work/main/tests/classical/classical_sliding_model.pf"
#line 123 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertRelativelyEqual(depth, case%found('penetration'), tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 123) )
  if (anyExceptions()) return
#line 124 "/work/main/tests/classical/classical_sliding_model.pf"
         end associate
         associate (area => table%number(row, 'area'))
#line 126 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertRelativelyEqual(area, case%found('contact_fraction'), tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 126) )
  if (anyExceptions()) return
#line 127 "/work/main/tests/classical/classical_sliding_model.pf"
#line 127 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertRelativelyEqual(area*period, case%found('contact_width'), tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 127) )
  if (anyExceptions()) return
#line 128 "/work/main/tests/classical/classical_sliding_model.pf"
            shift = (table%number(row, 'leading') + table%number(row, 'trailing'))/2/k
            if (.not. is_full) then
#line 130 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(shift, case%found('contact_shift'), tolerance=table_digits*area*period, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 130) )
  if (anyExceptions()) return
#line 131 "/work/main/tests/classical/classical_sliding_model.pf"
            end if
         end associate
         ! round-off of the pressure over 1e-3 of it
#line 134 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(0.0_dp, case%found('energy_imbalance'), tolerance=closed_form/1.0e-3_dp, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 134) )
  if (anyExceptions()) return
#line 135 "/work/main/tests/classical/classical_sliding_model.pf"
#line 135 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertLessThan(case%found('contact_violation'), table_digits, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 135) )
  if (anyExceptions()) return
#line 136 "/work/main/tests/classical/classical_sliding_model.pf"
         if (.not. is_full) call check_penetration(case, table_digits, label)
      end do
   end subroutine test_one_arm

   ! Two and three arms; the mean pressures of the table are in E0 with k D = 1.
   !@test
   subroutine test_several_arms()
      type(table_t) :: table
      type(trial_case_t) :: case
      type(prony_t) :: prony
      character(longest_label) :: label
      real(dp) :: found
      integer :: row

      call read_table(table, 'visco_wave_prony')
#line 151 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(5, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 151) )
  if (anyExceptions()) return
#line 152 "/work/main/tests/classical/classical_sliding_model.pf"
      do row = 1, table%n_rows
         label = table%label(row)
         prony = prony_of_cells(table%text(row, 'moduli'), table%text(row, 'times'))
         call new_slide(case, prony%moduli, prony%times, table%number(row, 'V')/(k*time))
         call case%give('mean_pressure', 2*table%number(row, 'q')*full_at_rest)
#line 157 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual('', case%problems_of(), message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 157) )
  if (anyExceptions()) return
#line 158 "/work/main/tests/classical/classical_sliding_model.pf"
         call case%solve()
         found = case%found('friction_coefficient')/(k*amplitude)
#line 160 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertRelativelyEqual(table%number(row, 'mu'), found, tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 160) )
  if (anyExceptions()) return
#line 161 "/work/main/tests/classical/classical_sliding_model.pf"
         found = case%found('penetration')/amplitude
#line 162 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertRelativelyEqual(table%number(row, 'pen'), found, tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 162) )
  if (anyExceptions()) return
#line 163 "/work/main/tests/classical/classical_sliding_model.pf"
         found = case%found('contact_fraction')
#line 164 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertRelativelyEqual(table%number(row, 'area'), found, tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 164) )
  if (anyExceptions()) return
#line 165 "/work/main/tests/classical/classical_sliding_model.pf"
         found = k*(case%found('contact_shift') + case%found('contact_width')/2)
#line 166 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertRelativelyEqual(table%number(row, 'leading'), found, tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 166) )
  if (anyExceptions()) return
#line 167 "/work/main/tests/classical/classical_sliding_model.pf"
         call check_penetration(case, table_digits, label)
      end do
   end subroutine test_several_arms

   ! At rest the results are those of an elastic solid with the relaxed modulus; so are those of a material without arms.
   !@test
   subroutine test_elastic()
      type(trial_case_t) :: case, still, plain
      character(21), parameter :: names(8) = [character(21) :: 'mean_pressure', 'penetration', 'contact_width', &
         'peak_pressure', 'mean_gap', 'largest_gap', 'full_contact_pressure', 'regime']
      character(20), parameter :: of_sliding(5) = [character(20) :: 'friction_stress', 'friction_coefficient', 'contact_shift', &
         'dissipation', 'energy_imbalance']
      integer :: i, j

      do i = 0, 4
         call new_case(case, 'wave_1d')
         call case%give('period', period)
         call case%give('amplitude', amplitude)
         call case%give('mean_pressure', 0.3_dp*i*full_at_rest)
         plain = case
         call case%give('contact_modulus', relaxed)
         call case%solve()
         call new_rubber(still, 0.0_dp)
         call still%give('mean_pressure', 0.3_dp*i*full_at_rest)
         call still%solve()
         call plain%give('modulus', relaxed)
         call plain%give('velocity', 3.0_dp)
#line 194 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual('', plain%problems_of(), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 194) )
  if (anyExceptions()) return
#line 195 "/work/main/tests/classical/classical_sliding_model.pf"
         call plain%solve()
         do j = 1, size(names)
            associate (expected => case%found(trim(names(j))))
#line 198 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(expected, still%found(trim(names(j))), tolerance=closed_form*expected, message=names(j), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 198) )
  if (anyExceptions()) return
#line 199 "/work/main/tests/classical/classical_sliding_model.pf"
#line 199 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(expected, plain%found(trim(names(j))), tolerance=closed_form*expected, message=names(j), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 199) )
  if (anyExceptions()) return
#line 200 "/work/main/tests/classical/classical_sliding_model.pf"
            end associate
         end do
         do j = 1, size(of_sliding)
#line 203 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertTrue(ieee_is_nan(case%found(trim(of_sliding(j)))), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 203) )
  if (anyExceptions()) return
#line 204 "/work/main/tests/classical/classical_sliding_model.pf"
            if (i == 0 .and. of_sliding(j) == 'friction_coefficient') cycle
            if ((i == 0 .or. i == 4) .and. of_sliding(j) == 'contact_shift') cycle
            ! the imbalance is round-off over 1e-3 of the load
            associate (nothing => merge(closed_form/1.0e-3_dp, 0.0_dp, of_sliding(j) == 'energy_imbalance'))
#line 208 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(0.0_dp, still%found(trim(of_sliding(j))), tolerance=nothing, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 208) )
  if (anyExceptions()) return
#line 209 "/work/main/tests/classical/classical_sliding_model.pf"
#line 209 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(0.0_dp, plain%found(trim(of_sliding(j))), tolerance=nothing, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 209) )
  if (anyExceptions()) return
#line 210 "/work/main/tests/classical/classical_sliding_model.pf"
            end associate
         end do
      end do
   end subroutine test_elastic

   ! Without load there is no contact, and the gap is the wave; lifted off, the gap is wider.
   !@test
   subroutine test_no_contact()
      type(trial_case_t) :: case
      real(dp), allocatable :: profiles(:, :, :)

      call new_rubber(case, 0.1_dp)
      call case%give('mean_pressure', 0.0_dp)
      call case%solve()
#line 224 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 224) )
  if (anyExceptions()) return
#line 225 "/work/main/tests/classical/classical_sliding_model.pf"
#line 225 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(0, nint(case%found('regime')), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 225) )
  if (anyExceptions()) return
#line 226 "/work/main/tests/classical/classical_sliding_model.pf"
#line 226 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(0.0_dp, case%found('contact_width'), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 226) )
  if (anyExceptions()) return
#line 227 "/work/main/tests/classical/classical_sliding_model.pf"
#line 227 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(0.0_dp, case%found('friction_stress'), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 227) )
  if (anyExceptions()) return
#line 228 "/work/main/tests/classical/classical_sliding_model.pf"
#line 228 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(0.0_dp, case%found('energy_imbalance'), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 228) )
  if (anyExceptions()) return
#line 229 "/work/main/tests/classical/classical_sliding_model.pf"
#line 229 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(0.0_dp, case%found('peak_pressure'), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 229) )
  if (anyExceptions()) return
#line 230 "/work/main/tests/classical/classical_sliding_model.pf"
#line 230 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertTrue(ieee_is_nan(case%found('friction_coefficient')), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 230) )
  if (anyExceptions()) return
#line 231 "/work/main/tests/classical/classical_sliding_model.pf"
#line 231 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(2*amplitude, case%found('largest_gap'), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 231) )
  if (anyExceptions()) return
#line 232 "/work/main/tests/classical/classical_sliding_model.pf"
      call case%give('mean_pressure', unset)
      call case%give('penetration', -amplitude)
      call case%give('profiles', 1.0_dp)
      call case%give('x_max', period)
      call case%give('n_x', 3.0_dp)
#line 237 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 237) )
  if (anyExceptions()) return
#line 238 "/work/main/tests/classical/classical_sliding_model.pf"
      call case%solve()
#line 239 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertRelativelyEqual(3*amplitude, case%found('largest_gap'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 239) )
  if (anyExceptions()) return
#line 240 "/work/main/tests/classical/classical_sliding_model.pf"
#line 240 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertRelativelyEqual(2*amplitude, case%found('mean_gap'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 240) )
  if (anyExceptions()) return
#line 241 "/work/main/tests/classical/classical_sliding_model.pf"
      call case%get_profiles(profiles)
#line 242 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual([1, 3, 1]*amplitude, profiles(:, 1, 2), tolerance=closed_form*amplitude, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 242) )
  if (anyExceptions()) return
#line 243 "/work/main/tests/classical/classical_sliding_model.pf"
#line 243 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(0.0_dp, maxval(profiles(:, 1, 1)), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 243) )
  if (anyExceptions()) return
#line 244 "/work/main/tests/classical/classical_sliding_model.pf"
   end subroutine test_no_contact

   ! T = k^2 D^2 E''/4 and p = k D |E|/2 where full contact begins; the pressure has the amplitude k D |E|/2 from there on.
   !@test
   subroutine test_full_contact()
      type(trial_case_t) :: case
      type(prony_t) :: prony
      real(dp), parameter :: velocity = 0.3_dp
      real(dp) :: storage, loss, full

      call new_rubber(case, velocity)
      call new_prony(prony, relaxed, relaxed*[3.0_dp, 6.0_dp], time*[1.0_dp, 0.1_dp])
      call prony%get_complex_modulus(k*velocity, storage, loss)
      full = k*amplitude*hypot(storage, loss)/2
      call case%give('mean_pressure', 1.5_dp*full)
      call case%solve()
#line 260 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(2, nint(case%found('regime')), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 260) )
  if (anyExceptions()) return
#line 261 "/work/main/tests/classical/classical_sliding_model.pf"
#line 261 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertRelativelyEqual((k*amplitude)**2*loss/4, case%found('friction_stress'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 261) )
  if (anyExceptions()) return
#line 262 "/work/main/tests/classical/classical_sliding_model.pf"
#line 262 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertRelativelyEqual(full, case%found('full_contact_pressure'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 262) )
  if (anyExceptions()) return
#line 263 "/work/main/tests/classical/classical_sliding_model.pf"
#line 263 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertRelativelyEqual(2.5_dp*full, case%found('peak_pressure'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 263) )
  if (anyExceptions()) return
#line 264 "/work/main/tests/classical/classical_sliding_model.pf"
#line 264 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(0.0_dp, case%found('largest_gap'), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 264) )
  if (anyExceptions()) return
#line 265 "/work/main/tests/classical/classical_sliding_model.pf"
#line 265 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertTrue(ieee_is_nan(case%found('contact_shift')), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 265) )
  if (anyExceptions()) return
#line 266 "/work/main/tests/classical/classical_sliding_model.pf"
#line 266 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(0.0_dp, case%found('energy_imbalance'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 266) )
  if (anyExceptions()) return
#line 267 "/work/main/tests/classical/classical_sliding_model.pf"
      call case%give('mean_pressure', unset)
      call case%give('penetration', amplitude)
      call case%solve()
#line 270 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertRelativelyEqual(full, case%found('mean_pressure'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 270) )
  if (anyExceptions()) return
#line 271 "/work/main/tests/classical/classical_sliding_model.pf"
      call case%give('penetration', 1.01_dp*amplitude)
      call case%solve()
#line 273 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(status_no_equilibrium, case%status(1), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 273) )
  if (anyExceptions()) return
#line 274 "/work/main/tests/classical/classical_sliding_model.pf"
   end subroutine test_full_contact

   ! The largest pressure and gap are those of finely sampled profiles, sampled once more around the largest value.
   !@test
   subroutine test_largest_values()
      integer, parameter :: n = 5001
      character(13), parameter :: names(2) = [character(13) :: 'peak_pressure', 'largest_gap']
      type(trial_case_t) :: case
      real(dp), allocatable :: profiles(:, :, :)
      real(dp) :: x, step, largest, mean
      integer :: i, j

      do i = -2, 2
         do j = 1, 2
            call new_slide(case, [9.0_dp, 90.0_dp], [1.0_dp, 0.03_dp], 10.0_dp**i)
            call case%give('mean_pressure', 0.7_dp*full_at_rest)
            call case%give('profiles', 1.0_dp)
            step = period/(n - 1)
            call case%give('x_min', -period/2)
            call case%give('x_max', period/2)
            call case%give('n_x', real(n, dp))
#line 295 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 295) )
  if (anyExceptions()) return
#line 296 "/work/main/tests/classical/classical_sliding_model.pf"
            call case%solve()
            call case%get_profiles(profiles)
            mean = sum(profiles(:n - 1, 1, 1))/(n - 1)
            ! the slope of the pressure has no bound at the edges
#line 300 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertRelativelyEqual(case%found('mean_pressure'), mean, tolerance=1.0e-3_dp, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 300) )
  if (anyExceptions()) return
#line 301 "/work/main/tests/classical/classical_sliding_model.pf"
            x = -period/2 + step*(maxloc(profiles(:, 1, j), 1) - 1)
            call case%give('x_min', x - step)
            call case%give('x_max', x + step)
            call case%get_profiles(profiles)
            largest = maxval(profiles(:, 1, j))
#line 306 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertLessThanOrEqual(largest, case%found(trim(names(j)))*(1 + closed_form), message=names(j), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 306) )
  if (anyExceptions()) return
#line 307 "/work/main/tests/classical/classical_sliding_model.pf"
#line 307 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertRelativelyEqual(largest, case%found(trim(names(j))), tolerance=1.0e-6_dp, message=names(j), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 307) )
  if (anyExceptions()) return
#line 308 "/work/main/tests/classical/classical_sliding_model.pf"
         end do
      end do
   end subroutine test_largest_values

   !@test
   subroutine test_mirror()
      type(trial_case_t) :: case, other
      character(21), parameter :: odd(3) = [character(21) :: 'friction_stress', 'friction_coefficient', 'contact_shift']
      character(21), parameter :: even(6) = [character(21) :: 'penetration', 'contact_width', 'peak_pressure', 'largest_gap', &
         'dissipation', 'energy_imbalance']
      integer :: j

      call new_rubber(case, 0.3_dp)
      call case%solve()
#line 322 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertGreaterThan(case%found('friction_stress'), 0.0_dp, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 322) )
  if (anyExceptions()) return
#line 323 "/work/main/tests/classical/classical_sliding_model.pf"
#line 323 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertGreaterThan(case%found('contact_shift'), 0.0_dp, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 323) )
  if (anyExceptions()) return
#line 324 "/work/main/tests/classical/classical_sliding_model.pf"
      call new_rubber(other, -0.3_dp)
#line 325 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual('', other%problems_of(), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 325) )
  if (anyExceptions()) return
#line 326 "/work/main/tests/classical/classical_sliding_model.pf"
      call other%solve()
      do j = 1, size(odd)
#line 328 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(case%found(trim(odd(j))), -other%found(trim(odd(j))), message=odd(j), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 328) )
  if (anyExceptions()) return
#line 329 "/work/main/tests/classical/classical_sliding_model.pf"
      end do
      do j = 1, size(even)
#line 331 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(case%found(trim(even(j))), other%found(trim(even(j))), message=even(j), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 331) )
  if (anyExceptions()) return
#line 332 "/work/main/tests/classical/classical_sliding_model.pf"
      end do
   end subroutine test_mirror

   ! The same numbers in nanometres, gigapascals and hours.
   !@test
   subroutine test_other_units()
      type(trial_case_t) :: case, other
      real(dp), parameter :: lengths(2) = [1.0e9_dp, 1.0e-3_dp], stresses(2) = [1.0e-9_dp, 1.0e6_dp], &
         & times(2) = [1.0_dp/3600, 1.0e6_dp]
      character(21), parameter :: of_stress(5) = [character(21) :: 'mean_pressure', 'peak_pressure', 'full_contact_pressure', &
         'friction_stress', 'dissipation']
      character(21), parameter :: of_length(5) = [character(21) :: 'penetration', 'contact_width', 'mean_gap', 'largest_gap', &
         'contact_shift']
      real(dp) :: found
      integer :: i, j

      call new_rubber(case, 0.3_dp)
      call case%solve()
      do i = 1, 2
         call new_rubber(other, 0.3_dp*lengths(i)/times(i))
         call other%give('period', period*lengths(i))
         call other%give('amplitude', amplitude*lengths(i))
         call other%give('modulus', relaxed*stresses(i))
         call give_list(other, 'moduli', relaxed*stresses(i)*[3.0_dp, 6.0_dp])
         call give_list(other, 'relaxation_times', time*times(i)*[1.0_dp, 0.1_dp])
         call other%give('mean_pressure', 0.4_dp*full_at_rest*stresses(i))
#line 358 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual('', other%problems_of(), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 358) )
  if (anyExceptions()) return
#line 359 "/work/main/tests/classical/classical_sliding_model.pf"
         call other%solve()
         do j = 1, 5
            found = other%found(trim(of_stress(j)))/stresses(i)
#line 362 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertRelativelyEqual(case%found(trim(of_stress(j))), found, tolerance=closed_form, message=of_stress(j), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 362) )
  if (anyExceptions()) return
#line 363 "/work/main/tests/classical/classical_sliding_model.pf"
            found = other%found(trim(of_length(j)))/lengths(i)
#line 364 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertRelativelyEqual(case%found(trim(of_length(j))), found, tolerance=closed_form, message=of_length(j), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 364) )
  if (anyExceptions()) return
#line 365 "/work/main/tests/classical/classical_sliding_model.pf"
         end do
         found = other%found('friction_coefficient')
#line 367 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertRelativelyEqual(case%found('friction_coefficient'), found, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 367) )
  if (anyExceptions()) return
#line 368 "/work/main/tests/classical/classical_sliding_model.pf"
      end do
   end subroutine test_other_units

   ! A colder material slides as one at its reference temperature does at a_T V; here log10 a_T = -4 (-20)/(60 - 20) = 2.
   !@test
   subroutine test_temperature()
      type(trial_case_t) :: case, cold
      type(derived_t), allocatable :: derived(:)
      integer :: j

      call new_rubber(case, 0.3_dp)
      call case%solve()
      call new_rubber(cold, 3.0e-3_dp)
      call cold%give('shift', 2.0_dp)
      call cold%give('reference_temperature', 300.0_dp)
      call cold%give('wlf_c1', 4.0_dp)
      call cold%give('wlf_c2', 60.0_dp)
      call cold%give('temperature', 280.0_dp)
#line 386 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual('', cold%problems_of(), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 386) )
  if (anyExceptions()) return
#line 387 "/work/main/tests/classical/classical_sliding_model.pf"
      call cold%solve()
      do j = 1, size(case%results)
         if (case%model%results(j)%name == 'energy_imbalance') cycle
         ! what belongs to adhesion has no value
         if (ieee_is_nan(case%results(j, 1)) .and. ieee_is_nan(cold%results(j, 1))) cycle
         associate (expected => case%results(j, 1))
#line 393 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(expected, cold%results(j, 1), tolerance=closed_form*abs(expected), message=case%model%results(j)%name, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 393) )
  if (anyExceptions()) return
#line 394 "/work/main/tests/classical/classical_sliding_model.pf"
         end associate
      end do
      derived = cold%model%derive_quantities(cold%values)
#line 397 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual('shift_factor', derived(3)%name, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 397) )
  if (anyExceptions()) return
#line 398 "/work/main/tests/classical/classical_sliding_model.pf"
#line 398 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertRelativelyEqual(100.0_dp, derived(3)%value, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 398) )
  if (anyExceptions()) return
#line 399 "/work/main/tests/classical/classical_sliding_model.pf"
#line 399 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertGreaterThan(index(cold%model%describe_case(cold%values), 'arm 2: contact modulus'), 0, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 399) )
  if (anyExceptions()) return
#line 400 "/work/main/tests/classical/classical_sliding_model.pf"
#line 400 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual('', cold%model%describe_doubts(cold%values), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 400) )
  if (anyExceptions()) return
#line 401 "/work/main/tests/classical/classical_sliding_model.pf"
   end subroutine test_temperature

   ! A master curve slides as the arms that are fitted to it; there is a doubt where it was not measured.
   !@test
   subroutine test_master_curve()
      type(trial_case_t) :: case, fitted
      type(prony_t) :: prony
      type(master_curve_fit_t) :: fit
      type(problems_t) :: problems
      real(dp) :: curve(81, 3)
      integer :: i, place

      call new_prony(prony, relaxed, relaxed*[3.0_dp, 6.0_dp], time*[1.0_dp, 0.1_dp])
      do i = 1, size(curve, 1)
         curve(i, 1) = 10.0_dp**(i*0.1_dp - 1)
         call prony%get_complex_modulus(curve(i, 1), curve(i, 2), curve(i, 3))
      end do
      call fit_master_curve(fit, curve(:, 1), curve(:, 2), curve(:, 3), default_terms_per_decade)
      call new_slide(case, fit%prony%moduli/relaxed, fit%prony%times/time, 0.3_dp)
      call case%give('modulus', fit%prony%relaxed)
      call case%give('mean_pressure', 0.4_dp*full_at_rest)
      call case%solve()
      call new_case(fitted, 'wave_1d')
      call fitted%give('period', period)
      call fitted%give('amplitude', amplitude)
      call fitted%give('velocity', 0.3_dp)
      call fitted%give('mean_pressure', 0.4_dp*full_at_rest)
      place = fitted%model%index_of('material', 'master_curve')
      fitted%values(place) = 1
      call fitted%model%take_dataset(place, curve, problems)
      call fitted%model%take_attribute(place, 'reference_temperature', 300.0_dp, problems)
#line 432 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(0, problems%count(), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 432) )
  if (anyExceptions()) return
#line 433 "/work/main/tests/classical/classical_sliding_model.pf"
#line 433 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual('', fitted%problems_of(), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 433) )
  if (anyExceptions()) return
#line 434 "/work/main/tests/classical/classical_sliding_model.pf"
      call fitted%solve()
#line 435 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertRelativelyEqual(case%found('friction_stress'), fitted%found('friction_stress'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 435) )
  if (anyExceptions()) return
#line 436 "/work/main/tests/classical/classical_sliding_model.pf"
#line 436 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertRelativelyEqual(case%found('penetration'), fitted%found('penetration'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 436) )
  if (anyExceptions()) return
#line 437 "/work/main/tests/classical/classical_sliding_model.pf"
#line 437 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual('', fitted%model%describe_doubts(fitted%values), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 437) )
  if (anyExceptions()) return
#line 438 "/work/main/tests/classical/classical_sliding_model.pf"
      call fitted%give('velocity', 1.0e7_dp)
#line 439 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertGreaterThan(index(fitted%model%describe_doubts(fitted%values), 'friction is missing'), 0, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 439) )
  if (anyExceptions()) return
#line 440 "/work/main/tests/classical/classical_sliding_model.pf"
   end subroutine test_master_curve

   ! What a point leaves to the next one changes no bit of the results.
   !@test
   subroutine test_neighbours()
      integer, parameter :: n = 4
      type(trial_case_t) :: case
      real(dp), allocatable :: values(:, :), results(:, :)
      real(dp) :: errors(n), counts(0)
      integer :: status(n), i

      call new_rubber(case, 0.3_dp)
      allocate (values(size(case%values), n), results(size(case%model%results), n))
      do i = 1, n
         call case%give('velocity', 0.1_dp*i)
         if (i >= 3) call case%give('modulus', 2*relaxed)
         values(:, i) = case%values
      end do
      call case%model%solve_block(values, results, errors, status, counts)
#line 459 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(status_solved, status, &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 459) )
  if (anyExceptions()) return
#line 460 "/work/main/tests/classical/classical_sliding_model.pf"
      do i = 1, n
         case%values = values(:, i)
         call case%solve()
#line 463 "/work/main/tests/classical/classical_sliding_model.pf"
  call assertEqual(0, sum(n_different_bits(case%results, results(:, i:i))), &
 & location=SourceLocation( &
 & 'classical_sliding_model.pf', &
 & 463) )
  if (anyExceptions()) return
#line 464 "/work/main/tests/classical/classical_sliding_model.pf"
      end do
   end subroutine test_neighbours

   !@test
   subroutine test_rejections()
      type(trial_case_t) :: case

      call new_rubber(case, unset)
      call check_problem(case, 'operating velocity', 'is missing [m/s]')
      call new_rubber(case, 1.0e120_dp)
      call check_problem(case, 'operating velocity', 'is too small or too large')
      call new_rubber(case, 0.3_dp)
      call case%give('contact_modulus', relaxed)
      call check_problem(case, 'solid contact_modulus', 'stands beside &material')
      call new_rubber(case, 0.3_dp)
      call case%give('penetration', amplitude)
      call check_problem(case, 'operating mean_pressure', 'stands beside penetration')
      call case%give('penetration', unset)
      call case%give('mean_pressure', unset)
      call check_problem(case, 'operating mean_pressure', 'one of mean_pressure or penetration')
      call new_rubber(case, 0.3_dp)
      call case%give('period', unset)
      call check_problem(case, 'surface period', 'is missing [m]')
      call new_rubber(case, 0.3_dp)
      call case%give('modulus', unset)
      call check_problem(case, 'material modulus', 'is missing [Pa]')
      call new_rubber(case, 0.3_dp)
      call case%give('temperature', 300.0_dp)
      call check_problem(case, 'operating temperature', 'has no meaning without shift', 'temperature')
      call new_rubber(case, 0.3_dp)
      call give_list(case, 'moduli', [relaxed])
      call check_problem(case, 'material moduli', 'are not as many as relaxation_times')
      call new_rubber(case, 0.3_dp)
      call case%give('profiles', 1.0_dp)
      call check_problem(case, 'output x_max', 'is missing [m]')
   end subroutine test_rejections

   ! Over an elastic solid a velocity has no meaning, nor has a temperature.
   !@test
   subroutine test_elastic_rejections()
      type(trial_case_t) :: case

      call new_case(case, 'wave_1d')
      call case%give('period', period)
      call case%give('amplitude', amplitude)
      call case%give('mean_pressure', full_at_rest)
      call check_problem(case, 'solid contact_modulus', 'is missing [Pa]')
      call case%give('contact_modulus', relaxed)
      call case%give('velocity', 0.0_dp)
      call check_problem(case, 'operating velocity', 'has no meaning without &material')
      call case%give('velocity', unset)
      call case%give('temperature', 300.0_dp)
      call check_problem(case, 'operating temperature', 'has no meaning without &material')
   end subroutine test_elastic_rejections

end module classical_sliding_model

module Wrapclassical_sliding_model
   use FUnit
   use classical_sliding_model
   implicit none
   private

contains


end module Wrapclassical_sliding_model

function classical_sliding_model_suite() result(suite)
   use FUnit
   use classical_sliding_model
   use Wrapclassical_sliding_model
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('classical_sliding_model_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_one_arm', &
      test_one_arm))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_several_arms', &
      test_several_arms))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_elastic', &
      test_elastic))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_no_contact', &
      test_no_contact))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_full_contact', &
      test_full_contact))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_largest_values', &
      test_largest_values))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_mirror', &
      test_mirror))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_other_units', &
      test_other_units))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_temperature', &
      test_temperature))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_master_curve', &
      test_master_curve))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_neighbours', &
      test_neighbours))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_rejections', &
      test_rejections))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_elastic_rejections', &
      test_elastic_rejections))
   call suite%addTest(t)


end function classical_sliding_model_suite


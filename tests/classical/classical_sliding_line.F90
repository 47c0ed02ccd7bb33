! SPDX-License-Identifier: GPL-3.0-or-later
! The model `hertz` over a viscoelastic half-plane: Hunter's table in SI units, its limits, its profiles, and what it refuses.
module classical_sliding_line
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: unset
   use adfric_material_prony, only: prony_t, new_prony
   use adfric_model_derived, only: derived_t
   use adfric_model_status, only: status_solved
   use counting_sink, only: n_different_bits
   use reference_table, only: table_t, read_table
   use trial_case, only: trial_case_t, new_case
   use funit
   implicit none (type, external)

   !> The cylinder [m], the relaxed modulus [Pa], a time unit [s], and a load [N/m].
   real(dp), parameter :: radius = 0.05_dp, relaxed = 2.0e6_dp, time = 1.0e-3_dp, load = 300
   !> Half-width under the load at rest [m].
   real(dp), parameter :: half_width = sqrt(4*radius*load/(pi*relaxed))
   real(dp), parameter :: closed_form = 100*epsilon(1.0_dp)
   !> Round-off of the pressure, over the least share of the load that stands for the friction.
   real(dp), parameter :: balance = closed_form/1.0e-3_dp
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
#line 40 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(0, problems%count(), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 40) )
  if (anyExceptions()) return
#line 41 "/work/main/tests/classical/classical_sliding_line.pf"
   end subroutine give_list

   !> The cylinder on a material, with moduli over the relaxed one and times in time units.
   subroutine new_slide(case, moduli, times, velocity)
      type(trial_case_t), intent(out) :: case
      real(dp), intent(in) :: moduli(:), times(:), velocity

      call new_case(case, 'hertz')
      call case%give('kind', 1.0_dp)
      call case%give('radius', radius)
      call case%give('modulus', relaxed)
      call give_list(case, 'moduli', relaxed*moduli)
      call give_list(case, 'relaxation_times', time*times)
      call case%give('velocity', velocity)
      call case%give('load', load)
   end subroutine new_slide

   !> A rubber with two arms.
   subroutine new_rubber(case, velocity)
      type(trial_case_t), intent(out) :: case
      real(dp), intent(in) :: velocity

      call new_slide(case, [3.0_dp, 6.0_dp], [1.0_dp, 0.1_dp], velocity)
   end subroutine new_rubber

   !> Profiles of n places from `first` to `last`.
   subroutine ask_profiles(case, first, last, n, profiles)
      type(trial_case_t), intent(inout) :: case
      real(dp), intent(in) :: first, last
      integer, intent(in) :: n
      real(dp), allocatable, intent(out) :: profiles(:, :, :)

      call case%give('profiles', 1.0_dp)
      call case%give('x_min', first)
      call case%give('x_max', last)
      call case%give('n_x', real(n, dp))
#line 77 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 77) )
  if (anyExceptions()) return
#line 78 "/work/main/tests/classical/classical_sliding_line.pf"
      call case%solve()
#line 79 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 79) )
  if (anyExceptions()) return
#line 80 "/work/main/tests/classical/classical_sliding_line.pf"
      call case%get_profiles(profiles)
   end subroutine ask_profiles

   !> One problem, which begins so.
   subroutine check_problem(case, start, text, swept)
      type(trial_case_t), intent(in) :: case
      character(*), intent(in) :: start, text
      character(*), intent(in), optional :: swept
      character(:), allocatable :: found

      found = case%problems_of(swept)
#line 91 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(1, index(found, 'case: &'//start//': '), message=found, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 91) )
  if (anyExceptions()) return
#line 92 "/work/main/tests/classical/classical_sliding_line.pf"
#line 92 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertGreaterThan(index(found, text), 0, message=found//' / '//text, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 92) )
  if (anyExceptions()) return
#line 93 "/work/main/tests/classical/classical_sliding_line.pf"
#line 93 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(len(found), index(found, new_line('a')), message=found, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 93) )
  if (anyExceptions()) return
#line 94 "/work/main/tests/classical/classical_sliding_line.pf"
   end subroutine check_problem

   ! Hunter's solution for one arm, by other hands: the half-width that belongs to a load, and all that follows.
   !@test
   subroutine test_one_arm()
      type(table_t) :: table
      type(trial_case_t) :: case
      character(longest_label) :: label
      real(dp) :: width, wanted, found
      integer :: row

      call read_table(table, 'visco_cylinder_sls')
#line 106 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(20, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 106) )
  if (anyExceptions()) return
#line 107 "/work/main/tests/classical/classical_sliding_line.pf"
      do row = 1, table%n_rows
         label = table%label(row)
         width = half_width*(1 + 0.1_dp*row)
         wanted = table%number(row, 'load_ratio')*pi*relaxed*width**2/(4*radius)
         call new_slide(case, [table%number(row, 'r') - 1], [1.0_dp], width/table%number(row, 'L')/time)
         call case%give('load', wanted)
#line 113 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual('', case%problems_of(), message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 113) )
  if (anyExceptions()) return
#line 114 "/work/main/tests/classical/classical_sliding_line.pf"
         call case%solve()
#line 115 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(status_solved, case%status(1), message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 115) )
  if (anyExceptions()) return
#line 116 "/work/main/tests/classical/classical_sliding_line.pf"
#line 116 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertRelativelyEqual(width, case%found('contact_half_width'), tolerance=closed_form, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 116) )
  if (anyExceptions()) return
#line 117 "/work/main/tests/classical/classical_sliding_line.pf"
#line 117 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertRelativelyEqual(2*width, case%found('contact_area'), tolerance=closed_form, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 117) )
  if (anyExceptions()) return
#line 118 "/work/main/tests/classical/classical_sliding_line.pf"
#line 118 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertRelativelyEqual(wanted/(2*width), case%found('mean_pressure'), tolerance=closed_form, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 118) )
  if (anyExceptions()) return
#line 119 "/work/main/tests/classical/classical_sliding_line.pf"
#line 119 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(wanted, case%found('load'), message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 119) )
  if (anyExceptions()) return
#line 120 "/work/main/tests/classical/classical_sliding_line.pf"
         found = case%found('contact_shift')/width
#line 121 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertRelativelyEqual(table%number(row, 'centre'), found, tolerance=closed_form, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 121) )
  if (anyExceptions()) return
#line 122 "/work/main/tests/classical/classical_sliding_line.pf"
         found = case%found('friction_coefficient')*radius/width
#line 123 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertRelativelyEqual(table%number(row, 'mu'), found, tolerance=closed_form, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 123) )
  if (anyExceptions()) return
#line 124 "/work/main/tests/classical/classical_sliding_line.pf"
         found = wanted*case%found('friction_coefficient')
#line 125 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertRelativelyEqual(found, case%found('friction_force'), tolerance=closed_form, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 125) )
  if (anyExceptions()) return
#line 126 "/work/main/tests/classical/classical_sliding_line.pf"
#line 126 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(case%found('friction_force'), case%found('dissipation'), message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 126) )
  if (anyExceptions()) return
#line 127 "/work/main/tests/classical/classical_sliding_line.pf"
#line 127 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(0.0_dp, case%found('energy_imbalance'), tolerance=balance, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 127) )
  if (anyExceptions()) return
#line 128 "/work/main/tests/classical/classical_sliding_line.pf"
#line 128 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertLessThan(case%found('contact_violation'), closed_form, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 128) )
  if (anyExceptions()) return
#line 129 "/work/main/tests/classical/classical_sliding_line.pf"
#line 129 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertGreaterThan(case%found('peak_pressure'), case%found('mean_pressure'), message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 129) )
  if (anyExceptions()) return
#line 130 "/work/main/tests/classical/classical_sliding_line.pf"
#line 130 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertTrue(ieee_is_nan(case%found('approach')) .and. ieee_is_nan(case%found('largest_shear_stress')), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 130) )
  if (anyExceptions()) return
#line 131 "/work/main/tests/classical/classical_sliding_line.pf"
      end do
   end subroutine test_one_arm

   ! At rest and slowly Hertz's contact with E0, fast that with E0 + E1 + E2; so is that of a material without arms.
   !@test
   subroutine test_hertz()
      character(18), parameter :: names(5) = [character(18) :: 'load', 'contact_half_width', 'peak_pressure', 'mean_pressure', &
         'contact_area']
      real(dp), parameter :: speeds(5) = [0.0_dp, 1.0e-12_dp, -1.0e-12_dp, 1.0e14_dp, -1.0e14_dp]
      real(dp), parameter :: near(5) = [closed_form, 1.0e-9_dp, 1.0e-9_dp, 1.0e-9_dp, 1.0e-9_dp]
      type(trial_case_t) :: hertz, slide, plain
      real(dp) :: rest
      integer :: i, j

      do i = 1, size(speeds)
         call new_rubber(slide, speeds(i))
#line 147 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual('', slide%problems_of(), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 147) )
  if (anyExceptions()) return
#line 148 "/work/main/tests/classical/classical_sliding_line.pf"
         call slide%solve()
         call new_case(hertz, 'hertz')
         call hertz%give('kind', 1.0_dp)
         call hertz%give('radius', radius)
         call hertz%give('load', load)
         plain = hertz
         call hertz%give('contact_modulus', merge(10*relaxed, relaxed, abs(speeds(i)) > 1))
         call hertz%solve()
         do j = 1, size(names)
            associate (expected => hertz%found(trim(names(j))))
#line 158 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertRelativelyEqual(expected, slide%found(trim(names(j))), tolerance=near(i), message=names(j), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 158) )
  if (anyExceptions()) return
#line 159 "/work/main/tests/classical/classical_sliding_line.pf"
            end associate
         end do
         ! nothing at all at rest
         rest = merge(near(i), 0.0_dp, i > 1)
#line 163 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(0.0_dp, slide%found('friction_coefficient'), tolerance=rest*half_width/radius, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 163) )
  if (anyExceptions()) return
#line 164 "/work/main/tests/classical/classical_sliding_line.pf"
#line 164 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(0.0_dp, slide%found('contact_shift'), tolerance=rest*half_width, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 164) )
  if (anyExceptions()) return
#line 165 "/work/main/tests/classical/classical_sliding_line.pf"
#line 165 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(0.0_dp, slide%found('energy_imbalance'), tolerance=balance, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 165) )
  if (anyExceptions()) return
#line 166 "/work/main/tests/classical/classical_sliding_line.pf"
#line 166 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertTrue(ieee_is_nan(hertz%found('friction_force')) .and. ieee_is_nan(hertz%found('friction_coefficient')), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 166) )
  if (anyExceptions()) return
#line 167 "/work/main/tests/classical/classical_sliding_line.pf"
#line 167 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertTrue(ieee_is_nan(hertz%found('contact_shift')) .and. ieee_is_nan(hertz%found('dissipation')), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 167) )
  if (anyExceptions()) return
#line 168 "/work/main/tests/classical/classical_sliding_line.pf"
#line 168 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertTrue(ieee_is_nan(hertz%found('energy_imbalance')), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 168) )
  if (anyExceptions()) return
#line 169 "/work/main/tests/classical/classical_sliding_line.pf"
      end do
      call plain%give('modulus', relaxed)
      call plain%give('velocity', 3.0_dp)
#line 172 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual('', plain%problems_of(), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 172) )
  if (anyExceptions()) return
#line 173 "/work/main/tests/classical/classical_sliding_line.pf"
      call plain%solve()
#line 174 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertRelativelyEqual(half_width, plain%found('contact_half_width'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 174) )
  if (anyExceptions()) return
#line 175 "/work/main/tests/classical/classical_sliding_line.pf"
#line 175 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(0.0_dp, plain%found('friction_force'), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 175) )
  if (anyExceptions()) return
#line 176 "/work/main/tests/classical/classical_sliding_line.pf"
#line 176 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertGreaterThan(index(plain%model%describe_doubts(plain%values), 'nothing rubs'), 0, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 176) )
  if (anyExceptions()) return
#line 177 "/work/main/tests/classical/classical_sliding_line.pf"
   end subroutine test_hertz

   ! `wave_1d` with a long period under a light load: the crest is a parabola with R = 1/(k^2 D), but for (k a)^2.
   !@test
   subroutine test_long_wave()
      real(dp), parameter :: amplitude = 1.0e-3_dp
      type(trial_case_t) :: case, wave
      real(dp) :: k, square
      integer :: i, j

      do i = 1, 3
         do j = -1, 1
            k = 10.0_dp**(-i)
            call new_rubber(case, 10.0_dp**j)
            call case%give('radius', 1/(k**2*amplitude))
            call case%give('load', 1.0e-2_dp)
            call case%solve()
            call new_case(wave, 'wave_1d')
            call wave%give('period', 2*pi/k)
            call wave%give('amplitude', amplitude)
            call wave%give('modulus', relaxed)
            call give_list(wave, 'moduli', relaxed*[3.0_dp, 6.0_dp])
            call give_list(wave, 'relaxation_times', time*[1.0_dp, 0.1_dp])
            call wave%give('velocity', 10.0_dp**j)
            call wave%give('mean_pressure', 1.0e-2_dp*k/(2*pi))
#line 202 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual('', wave%problems_of(), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 202) )
  if (anyExceptions()) return
#line 203 "/work/main/tests/classical/classical_sliding_line.pf"
            call wave%solve()
            square = (k*case%found('contact_half_width'))**2 + closed_form
            associate (found => wave%found('contact_width')/2)
#line 206 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertRelativelyEqual(case%found('contact_half_width'), found, tolerance=square, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 206) )
  if (anyExceptions()) return
#line 207 "/work/main/tests/classical/classical_sliding_line.pf"
            end associate
            associate (found => wave%found('friction_coefficient'))
#line 209 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertRelativelyEqual(case%found('friction_coefficient'), found, tolerance=square, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 209) )
  if (anyExceptions()) return
#line 210 "/work/main/tests/classical/classical_sliding_line.pf"
            end associate
#line 211 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertRelativelyEqual(case%found('contact_shift'), wave%found('contact_shift'), tolerance=square, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 211) )
  if (anyExceptions()) return
#line 212 "/work/main/tests/classical/classical_sliding_line.pf"
#line 212 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertRelativelyEqual(case%found('peak_pressure'), wave%found('peak_pressure'), tolerance=square, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 212) )
  if (anyExceptions()) return
#line 213 "/work/main/tests/classical/classical_sliding_line.pf"
         end do
      end do
   end subroutine test_long_wave

   ! The profile carries the load and makes the friction; pressure and gap begin at the edges, as root and as power 3/2.
   !@test
   subroutine test_profiles()
      integer, parameter :: n = 4001
      real(dp), parameter :: short = 1.0e-6_dp
      type(trial_case_t) :: case
      real(dp), allocatable :: profiles(:, :, :), edge(:, :, :)
      real(dp) :: shift, width, x(n), step, place
      integer :: i, k, side

      do k = -1, 1
         call new_rubber(case, 10.0_dp**k)
         call case%solve()
         shift = case%found('contact_shift')
         width = case%found('contact_half_width')
         call ask_profiles(case, shift - 1.5_dp*width, shift + 1.5_dp*width, n, profiles)
         step = 3*width/(n - 1)
         x = [(shift + step*(i - 0.5_dp*(n + 1)), i=1, n)]
         associate (p => profiles(:, 1, 1), g => profiles(:, 1, 2), is_in => abs(x - shift) < width*(1 - short))
            ! the slope of the pressure has no bound at the edges
#line 237 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertRelativelyEqual(load, sum(p)*step, tolerance=1.0e-4_dp, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 237) )
  if (anyExceptions()) return
#line 238 "/work/main/tests/classical/classical_sliding_line.pf"
#line 238 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertRelativelyEqual(case%found('friction_force'), sum(p*x)*step/radius, tolerance=1.0e-3_dp, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 238) )
  if (anyExceptions()) return
#line 239 "/work/main/tests/classical/classical_sliding_line.pf"
#line 239 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertTrue(all(p > 0 .or. .not. is_in) .and. all(g > 0 .or. abs(x - shift) < width*(1 + short)), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 239) )
  if (anyExceptions()) return
#line 240 "/work/main/tests/classical/classical_sliding_line.pf"
#line 240 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(0.0_dp, maxval(g, mask=is_in), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 240) )
  if (anyExceptions()) return
#line 241 "/work/main/tests/classical/classical_sliding_line.pf"
#line 241 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(0.0_dp, maxval(p, mask=abs(x - shift) > width*(1 + short)), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 241) )
  if (anyExceptions()) return
#line 242 "/work/main/tests/classical/classical_sliding_line.pf"
         end associate
         do side = -1, 1, 2
            place = shift + side*width*(1 - 4*short)
            call ask_profiles(case, place, place + 8*short*width, 9, edge)
            if (side < 0) call ask_profiles(case, place - 8*short*width, place, 9, edge)
            if (side < 0) edge = edge(9:1:-1, :, :)
#line 248 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertRelativelyEqual(2.0_dp, edge(1, 1, 1)/edge(4, 1, 1), tolerance=1.0e-3_dp, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 248) )
  if (anyExceptions()) return
#line 249 "/work/main/tests/classical/classical_sliding_line.pf"
#line 249 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertRelativelyEqual(8.0_dp, edge(9, 1, 2)/edge(6, 1, 2), tolerance=1.0e-3_dp, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 249) )
  if (anyExceptions()) return
#line 250 "/work/main/tests/classical/classical_sliding_line.pf"
#line 250 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(0.0_dp, maxval(edge(6:, 1, 1)), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 250) )
  if (anyExceptions()) return
#line 251 "/work/main/tests/classical/classical_sliding_line.pf"
#line 251 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(0.0_dp, maxval(edge(:4, 1, 2)), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 251) )
  if (anyExceptions()) return
#line 252 "/work/main/tests/classical/classical_sliding_line.pf"
         end do
      end do
   end subroutine test_profiles

   ! Far away the gap is the parabola, less a rise that is slower than any power; along the line nothing changes.
   !@test
   subroutine test_far_away()
      type(trial_case_t) :: case
      real(dp), allocatable :: profiles(:, :, :)
      real(dp), parameter :: far = 1.0e4_dp*half_width

      call new_rubber(case, 0.3_dp)
      call case%give('y_max', 1.0_dp)
      call case%give('n_y', 3.0_dp)
      call ask_profiles(case, -far, far, 2, profiles)
#line 267 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertRelativelyEqual(far**2/(2*radius), profiles(1, 1, 2), tolerance=1.0e-5_dp, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 267) )
  if (anyExceptions()) return
#line 268 "/work/main/tests/classical/classical_sliding_line.pf"
#line 268 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertRelativelyEqual(far**2/(2*radius), profiles(2, 1, 2), tolerance=1.0e-5_dp, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 268) )
  if (anyExceptions()) return
#line 269 "/work/main/tests/classical/classical_sliding_line.pf"
      call ask_profiles(case, -2*half_width, 2*half_width, 41, profiles)
#line 270 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual([41, 3, 2], shape(profiles), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 270) )
  if (anyExceptions()) return
#line 271 "/work/main/tests/classical/classical_sliding_line.pf"
#line 271 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(profiles(:, 1, :), profiles(:, 3, :), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 271) )
  if (anyExceptions()) return
#line 272 "/work/main/tests/classical/classical_sliding_line.pf"
#line 272 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertGreaterThan(maxval(profiles(:, 1, 1)), 0.0_dp, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 272) )
  if (anyExceptions()) return
#line 273 "/work/main/tests/classical/classical_sliding_line.pf"
   end subroutine test_far_away

   ! The largest pressure is that of a profile sampled finely, and once more around its largest value: with a spectrum of many
   ! decades, too, where the solid is a glass within a small share of the width from the leading edge.
   !@test
   subroutine test_largest_pressure()
      integer, parameter :: n = 201
      type(trial_case_t) :: case
      real(dp), allocatable :: profiles(:, :, :)
      real(dp) :: shift, width, x, step
      integer :: i, k

      do k = -6, 6, 2
         call new_slide(case, [(2.0_dp**min(i + 7, 7 - i), i=-6, 6)], [(10.0_dp**i, i=-6, 6)], 10.0_dp**k)
         call case%solve()
         shift = case%found('contact_shift')
         width = case%found('contact_half_width')
         step = 2*width/(n - 1)
         call ask_profiles(case, shift - width, shift + width, n, profiles)
#line 292 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertLessThanOrEqual(maxval(profiles(:, 1, 1)), case%found('peak_pressure')*(1 + closed_form), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 292) )
  if (anyExceptions()) return
#line 293 "/work/main/tests/classical/classical_sliding_line.pf"
         x = shift - width + step*(maxloc(profiles(:, 1, 1), 1) - 1)
         do i = 1, 3
            call ask_profiles(case, x - step, x + step, n, profiles)
            x = x - step + 2*step/(n - 1)*(maxloc(profiles(:, 1, 1), 1) - 1)
            step = 2*step/(n - 1)
         end do
#line 299 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertRelativelyEqual(maxval(profiles(:, 1, 1)), case%found('peak_pressure'), tolerance=1.0e-9_dp, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 299) )
  if (anyExceptions()) return
#line 300 "/work/main/tests/classical/classical_sliding_line.pf"
#line 300 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(0.0_dp, case%found('energy_imbalance'), tolerance=10*balance, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 300) )
  if (anyExceptions()) return
#line 301 "/work/main/tests/classical/classical_sliding_line.pf"
#line 301 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertLessThan(case%found('contact_violation'), 10*closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 301) )
  if (anyExceptions()) return
#line 302 "/work/main/tests/classical/classical_sliding_line.pf"
      end do
   end subroutine test_largest_pressure

   ! At any speed, up to moduli that no solid has, pressure and gap keep the conditions of contact and the balances: where the glass
   ! is a layer that is short beside any sample, and where the retardation length is beyond all others.
   !@test
   subroutine test_any_speed()
      real(dp), parameter :: ratios(3) = [1.0e3_dp, 1.0e10_dp, 1.0e25_dp]
      type(trial_case_t) :: case
      character(40) :: label
      integer :: i, k

      do i = 1, 3
         do k = -40, 20, 2
            write (label, '(es9.1, i6)') ratios(i), k
            call new_slide(case, [ratios(i)], [1.0_dp], 10.0_dp**k)
            call case%solve()
#line 319 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(status_solved, case%status(1), message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 319) )
  if (anyExceptions()) return
#line 320 "/work/main/tests/classical/classical_sliding_line.pf"
#line 320 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(0.0_dp, case%found('energy_imbalance'), tolerance=10*balance, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 320) )
  if (anyExceptions()) return
#line 321 "/work/main/tests/classical/classical_sliding_line.pf"
#line 321 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertLessThan(case%found('contact_violation'), 10*closed_form, message=label, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 321) )
  if (anyExceptions()) return
#line 322 "/work/main/tests/classical/classical_sliding_line.pf"
         end do
      end do
      call new_slide(case, [1.0e31_dp], [1.0_dp], 1.0_dp)
      call check_problem(case, 'material modulus', 'is too small, or other moduli are too large')
   end subroutine test_any_speed

   ! Without load there is no contact, and the gap is the parabola.
   !@test
   subroutine test_no_load()
      type(trial_case_t) :: case
      real(dp), allocatable :: profiles(:, :, :)

      call new_rubber(case, 0.3_dp)
      call case%give('load', 0.0_dp)
      call ask_profiles(case, 0.0_dp, radius/10, 2, profiles)
#line 337 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual([0.0_dp, radius/200], profiles(:, 1, 2), tolerance=closed_form*radius, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 337) )
  if (anyExceptions()) return
#line 338 "/work/main/tests/classical/classical_sliding_line.pf"
#line 338 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(0.0_dp, maxval(profiles(:, 1, 1)), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 338) )
  if (anyExceptions()) return
#line 339 "/work/main/tests/classical/classical_sliding_line.pf"
#line 339 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(0.0_dp, case%found('contact_half_width'), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 339) )
  if (anyExceptions()) return
#line 340 "/work/main/tests/classical/classical_sliding_line.pf"
#line 340 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(0.0_dp, case%found('mean_pressure'), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 340) )
  if (anyExceptions()) return
#line 341 "/work/main/tests/classical/classical_sliding_line.pf"
#line 341 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(0.0_dp, case%found('peak_pressure'), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 341) )
  if (anyExceptions()) return
#line 342 "/work/main/tests/classical/classical_sliding_line.pf"
#line 342 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(0.0_dp, case%found('friction_force'), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 342) )
  if (anyExceptions()) return
#line 343 "/work/main/tests/classical/classical_sliding_line.pf"
#line 343 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(0.0_dp, case%found('energy_imbalance'), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 343) )
  if (anyExceptions()) return
#line 344 "/work/main/tests/classical/classical_sliding_line.pf"
#line 344 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertTrue(ieee_is_nan(case%found('friction_coefficient')) .and. ieee_is_nan(case%found('contact_shift')), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 344) )
  if (anyExceptions()) return
#line 345 "/work/main/tests/classical/classical_sliding_line.pf"
   end subroutine test_no_load

   !@test
   subroutine test_mirror()
      character(20), parameter :: odd(3) = [character(20) :: 'friction_force', 'friction_coefficient', 'contact_shift']
      character(20), parameter :: even(6) = [character(20) :: 'contact_half_width', 'peak_pressure', 'mean_pressure', &
         'dissipation', 'energy_imbalance', 'contact_violation']
      type(trial_case_t) :: case, other
      real(dp), allocatable :: profiles(:, :, :), others(:, :, :)
      integer :: j

      call new_rubber(case, 0.3_dp)
      call ask_profiles(case, -2*half_width, 2*half_width, 31, profiles)
#line 358 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertGreaterThan(case%found('friction_force'), 0.0_dp, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 358) )
  if (anyExceptions()) return
#line 359 "/work/main/tests/classical/classical_sliding_line.pf"
#line 359 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertGreaterThan(case%found('contact_shift'), 0.0_dp, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 359) )
  if (anyExceptions()) return
#line 360 "/work/main/tests/classical/classical_sliding_line.pf"
      call new_rubber(other, -0.3_dp)
      call ask_profiles(other, -2*half_width, 2*half_width, 31, others)
      do j = 1, size(odd)
#line 363 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(case%found(trim(odd(j))), -other%found(trim(odd(j))), message=odd(j), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 363) )
  if (anyExceptions()) return
#line 364 "/work/main/tests/classical/classical_sliding_line.pf"
      end do
      do j = 1, size(even)
#line 366 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(case%found(trim(even(j))), other%found(trim(even(j))), message=even(j), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 366) )
  if (anyExceptions()) return
#line 367 "/work/main/tests/classical/classical_sliding_line.pf"
      end do
      associate (sizes => maxval(maxval(profiles, 1), 1))
         do j = 1, 2
#line 370 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(profiles(31:1:-1, 1, j), others(:, 1, j), tolerance=closed_form*sizes(j), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 370) )
  if (anyExceptions()) return
#line 371 "/work/main/tests/classical/classical_sliding_line.pf"
         end do
      end associate
   end subroutine test_mirror

   ! The same numbers in nanometres, gigapascals and hours, and in other ones.
   !@test
   subroutine test_other_units()
      real(dp), parameter :: lengths(2) = [1.0e9_dp, 1.0e-3_dp], stresses(2) = [1.0e-9_dp, 1.0e6_dp], &
         & times(2) = [1.0_dp/3600, 1.0e6_dp]
      character(20), parameter :: of_stress(2) = [character(20) :: 'mean_pressure', 'peak_pressure']
      character(20), parameter :: of_length(3) = [character(20) :: 'contact_half_width', 'contact_area', 'contact_shift']
      character(20), parameter :: of_force(3) = [character(20) :: 'load', 'friction_force', 'dissipation']
      type(trial_case_t) :: case, other
      real(dp), allocatable :: profiles(:, :, :), others(:, :, :)
      real(dp) :: found
      integer :: i, j

      call new_rubber(case, 0.3_dp)
      call ask_profiles(case, -2*half_width, 2*half_width, 31, profiles)
      do i = 1, 2
         call new_rubber(other, 0.3_dp*lengths(i)/times(i))
         call other%give('radius', radius*lengths(i))
         call other%give('modulus', relaxed*stresses(i))
         call give_list(other, 'moduli', relaxed*stresses(i)*[3.0_dp, 6.0_dp])
         call give_list(other, 'relaxation_times', time*times(i)*[1.0_dp, 0.1_dp])
         call other%give('load', load*stresses(i)*lengths(i))
         call ask_profiles(other, -2*half_width*lengths(i), 2*half_width*lengths(i), 31, others)
         do j = 1, 2
            found = other%found(trim(of_stress(j)))/stresses(i)
#line 400 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertRelativelyEqual(case%found(trim(of_stress(j))), found, tolerance=closed_form, message=of_stress(j), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 400) )
  if (anyExceptions()) return
#line 401 "/work/main/tests/classical/classical_sliding_line.pf"
         end do
         do j = 1, 3
            found = other%found(trim(of_length(j)))/lengths(i)
#line 404 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertRelativelyEqual(case%found(trim(of_length(j))), found, tolerance=closed_form, message=of_length(j), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 404) )
  if (anyExceptions()) return
#line 405 "/work/main/tests/classical/classical_sliding_line.pf"
            found = other%found(trim(of_force(j)))/(stresses(i)*lengths(i))
#line 406 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertRelativelyEqual(case%found(trim(of_force(j))), found, tolerance=closed_form, message=of_force(j), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 406) )
  if (anyExceptions()) return
#line 407 "/work/main/tests/classical/classical_sliding_line.pf"
         end do
         found = other%found('friction_coefficient')
#line 409 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertRelativelyEqual(case%found('friction_coefficient'), found, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 409) )
  if (anyExceptions()) return
#line 410 "/work/main/tests/classical/classical_sliding_line.pf"
         associate (sizes => maxval(maxval(profiles, 1), 1))
#line 411 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(profiles(:, 1, 1), others(:, 1, 1)/stresses(i), tolerance=10*closed_form*sizes(1), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 411) )
  if (anyExceptions()) return
#line 412 "/work/main/tests/classical/classical_sliding_line.pf"
#line 412 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(profiles(:, 1, 2), others(:, 1, 2)/lengths(i), tolerance=10*closed_form*sizes(2), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 412) )
  if (anyExceptions()) return
#line 413 "/work/main/tests/classical/classical_sliding_line.pf"
         end associate
      end do
#line 415 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual('N/m', case%model%unit_of(case%values, case%model%index_of('operating', 'load')), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 415) )
  if (anyExceptions()) return
#line 416 "/work/main/tests/classical/classical_sliding_line.pf"
   end subroutine test_other_units

   ! A colder material slides as one at its reference temperature does at a_T V; here log10 a_T = -4 (-20)/(60 - 20) = 2.
   !@test
   subroutine test_temperature()
      type(trial_case_t) :: case, cold
      type(derived_t), allocatable :: derived(:)
      integer :: j

      call new_rubber(case, 0.3_dp)
      call case%solve()
      call new_cold(cold, 280.0_dp)
#line 428 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual('', cold%problems_of(), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 428) )
  if (anyExceptions()) return
#line 429 "/work/main/tests/classical/classical_sliding_line.pf"
      call cold%solve()
      do j = 1, size(case%results)
         associate (name => case%model%results(j)%name, expected => case%results(j, 1))
#line 432 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(ieee_is_nan(expected), ieee_is_nan(cold%results(j, 1)), message=name, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 432) )
  if (anyExceptions()) return
#line 433 "/work/main/tests/classical/classical_sliding_line.pf"
            if (ieee_is_nan(expected) .or. name == 'energy_imbalance' .or. name == 'contact_violation') cycle
#line 434 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(expected, cold%results(j, 1), tolerance=closed_form*abs(expected), message=name, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 434) )
  if (anyExceptions()) return
#line 435 "/work/main/tests/classical/classical_sliding_line.pf"
         end associate
      end do
      derived = cold%model%derive_quantities(cold%values)
#line 438 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual('shift_factor', derived(3)%name, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 438) )
  if (anyExceptions()) return
#line 439 "/work/main/tests/classical/classical_sliding_line.pf"
#line 439 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertRelativelyEqual(100.0_dp, derived(3)%value, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 439) )
  if (anyExceptions()) return
#line 440 "/work/main/tests/classical/classical_sliding_line.pf"
#line 440 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertGreaterThan(index(cold%model%describe_case(cold%values), 'arm 2: contact modulus'), 0, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 440) )
  if (anyExceptions()) return
#line 441 "/work/main/tests/classical/classical_sliding_line.pf"
#line 441 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual('', cold%model%describe_doubts(cold%values), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 441) )
  if (anyExceptions()) return
#line 442 "/work/main/tests/classical/classical_sliding_line.pf"
   end subroutine test_temperature

   !> The rubber that slides at 3 mm/s, with a shift.
   subroutine new_cold(case, temperature)
      type(trial_case_t), intent(out) :: case
      real(dp), intent(in) :: temperature

      call new_rubber(case, 3.0e-3_dp)
      call case%give('shift', 2.0_dp)
      call case%give('reference_temperature', 300.0_dp)
      call case%give('wlf_c1', 4.0_dp)
      call case%give('wlf_c2', 60.0_dp)
      call case%give('temperature', temperature)
   end subroutine new_cold

   ! There is a doubt where the contact excites V/a at which the master curve was not measured.
   !@test
   subroutine test_master_curve()
      type(trial_case_t) :: case
      type(prony_t) :: prony
      type(problems_t) :: problems
      real(dp) :: curve(81, 3), speed
      integer :: i, place

      call new_prony(prony, relaxed, relaxed*[3.0_dp, 6.0_dp], time*[1.0_dp, 0.1_dp])
      do i = 1, size(curve, 1)
         curve(i, 1) = 10.0_dp**(i*0.1_dp - 1)
         call prony%get_complex_modulus(curve(i, 1), curve(i, 2), curve(i, 3))
      end do
      call new_case(case, 'hertz')
      call case%give('kind', 1.0_dp)
      call case%give('radius', radius)
      call case%give('load', load)
      place = case%model%index_of('material', 'master_curve')
      case%values(place) = 1
      call case%model%take_dataset(place, curve, problems)
      call case%model%take_attribute(place, 'reference_temperature', 300.0_dp, problems)
#line 479 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(0, problems%count(), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 479) )
  if (anyExceptions()) return
#line 480 "/work/main/tests/classical/classical_sliding_line.pf"
      call case%give('velocity', 0.3_dp)
#line 481 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 481) )
  if (anyExceptions()) return
#line 482 "/work/main/tests/classical/classical_sliding_line.pf"
      call case%solve()
#line 483 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 483) )
  if (anyExceptions()) return
#line 484 "/work/main/tests/classical/classical_sliding_line.pf"
#line 484 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertGreaterThan(case%found('friction_coefficient'), 0.0_dp, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 484) )
  if (anyExceptions()) return
#line 485 "/work/main/tests/classical/classical_sliding_line.pf"
#line 485 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual('', case%model%describe_doubts(case%values), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 485) )
  if (anyExceptions()) return
#line 486 "/work/main/tests/classical/classical_sliding_line.pf"
      speed = curve(81, 1)*half_width
      ! stiff, the contact is narrower by less than the root of ten
      call case%give('velocity', speed/4)
#line 489 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual('', case%model%describe_doubts(case%values), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 489) )
  if (anyExceptions()) return
#line 490 "/work/main/tests/classical/classical_sliding_line.pf"
      call case%give('velocity', -speed)
#line 491 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertGreaterThan(index(case%model%describe_doubts(case%values), 'friction is missing'), 0, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 491) )
  if (anyExceptions()) return
#line 492 "/work/main/tests/classical/classical_sliding_line.pf"
      call case%give('load', 0.0_dp)
#line 493 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual('', case%model%describe_doubts(case%values), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 493) )
  if (anyExceptions()) return
#line 494 "/work/main/tests/classical/classical_sliding_line.pf"
   end subroutine test_master_curve

   ! What a point leaves to the next one changes no bit, whatever differs between the two.
   !@test
   subroutine test_neighbours()
      character(11), parameter :: names(5) = [character(11) :: 'velocity', 'load', 'temperature', 'radius', 'modulus']
      real(dp), parameter :: others(5) = [-1.0e-3_dp, 0.0_dp, 295.0_dp, 0.01_dp, 3.0e6_dp]
      integer, parameter :: n = size(names) + 1
      type(trial_case_t) :: case
      real(dp), allocatable :: values(:, :), results(:, :)
      real(dp) :: errors(n), counts(0)
      integer :: status(n), order(n), i, k

      call new_cold(case, 280.0_dp)
      allocate (values(size(case%values), n), results(size(case%model%results), n))
      values(:, 1) = case%values
      do i = 2, n
         call case%give(trim(names(i - 1)), others(i - 1))
         values(:, i) = case%values
      end do
      do k = 1, n - 1, 4
         order = 1 + modulo([(i*k, i=1, n)], n)
         call case%model%solve_block(values(:, order), results, errors, status, counts)
#line 517 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(status_solved, status, &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 517) )
  if (anyExceptions()) return
#line 518 "/work/main/tests/classical/classical_sliding_line.pf"
         do i = 1, n
            case%values = values(:, order(i))
            call case%solve()
#line 521 "/work/main/tests/classical/classical_sliding_line.pf"
  call assertEqual(0, sum(n_different_bits(case%results, results(:, i:i))), &
 & location=SourceLocation( &
 & 'classical_sliding_line.pf', &
 & 521) )
  if (anyExceptions()) return
#line 522 "/work/main/tests/classical/classical_sliding_line.pf"
         end do
      end do
   end subroutine test_neighbours

   !@test
   subroutine test_rejections()
      character(20), parameter :: of_solid(5) = [character(20) :: 'contact_modulus', 'young_modulus', 'poisson_ratio', &
         'second_young_modulus', 'second_poisson_ratio']
      type(trial_case_t) :: case
      integer :: i

      call new_rubber(case, unset)
      call check_problem(case, 'operating velocity', 'is missing [m/s]')
      call new_rubber(case, 1.0e120_dp)
      call check_problem(case, 'operating velocity', 'is too small or too large')
      call new_rubber(case, 0.3_dp)
      call case%give('load', 1.0e-250_dp)
      call check_problem(case, 'operating velocity', 'is too small or too large')
      do i = 1, size(of_solid)
         call new_rubber(case, 0.3_dp)
         call case%give(trim(of_solid(i)), 0.4_dp)
         call check_problem(case, 'solid '//trim(of_solid(i)), 'stands beside &material')
      end do
      ! one line for the whole group
      call case%give('young_modulus', relaxed)
      call check_problem(case, 'solid young_modulus', 'stands beside &material')
      call new_rubber(case, 0.3_dp)
      call case%give('approach', 1.0e-6_dp)
      call check_problem(case, 'operating approach', 'is undefined for the line contact')
      call case%give('approach', unset)
      call case%give('load', unset)
      call check_problem(case, 'operating load', 'is missing')
      call new_rubber(case, 0.3_dp)
      call case%give('radius', unset)
      call check_problem(case, 'contact radius', 'is missing [m]')
      call case%give('radius', radius)
      call case%give('radius_1x', radius)
      call check_problem(case, 'contact radius_1x', 'has no meaning for this kind')
   end subroutine test_rejections

   !@test
   subroutine test_material_rejections()
      type(trial_case_t) :: case

      call new_rubber(case, 0.3_dp)
      call case%give('kind', 2.0_dp)
      call check_problem(case, 'contact kind', 'only a cylinder slides')
      call case%give('kind', 3.0_dp)
      call case%give('radius', unset)
      call case%give('radius_1x', radius)
      call case%give('radius_1y', radius)
      call check_problem(case, 'contact kind', 'only a cylinder slides')
      call new_rubber(case, 0.3_dp)
      call case%give('kind', unset)
      call check_problem(case, 'contact kind', 'is missing')
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
   end subroutine test_material_rejections

   ! Over elastic solids a velocity has no meaning, nor has a temperature, whatever the kind.
   !@test
   subroutine test_elastic_rejections()
      type(trial_case_t) :: case
      integer :: kind

      do kind = 1, 2
         call new_case(case, 'hertz')
         call case%give('kind', real(kind, dp))
         call case%give('radius', radius)
         call case%give('load', load)
         call check_problem(case, 'solid contact_modulus', 'is missing [Pa]')
         call case%give('contact_modulus', relaxed)
         call case%give('velocity', 0.0_dp)
         call check_problem(case, 'operating velocity', 'has no meaning without &material')
         call case%give('velocity', unset)
         call case%give('temperature', 300.0_dp)
         call check_problem(case, 'operating temperature', 'has no meaning without &material')
      end do
   end subroutine test_elastic_rejections

end module classical_sliding_line

module Wrapclassical_sliding_line
   use FUnit
   use classical_sliding_line
   implicit none
   private

contains


end module Wrapclassical_sliding_line

function classical_sliding_line_suite() result(suite)
   use FUnit
   use classical_sliding_line
   use Wrapclassical_sliding_line
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('classical_sliding_line_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_one_arm', &
      test_one_arm))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_hertz', &
      test_hertz))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_long_wave', &
      test_long_wave))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_profiles', &
      test_profiles))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_far_away', &
      test_far_away))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_largest_pressure', &
      test_largest_pressure))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_any_speed', &
      test_any_speed))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_no_load', &
      test_no_load))
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
   allocate(t, source=TestMethod('test_material_rejections', &
      test_material_rejections))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_elastic_rejections', &
      test_elastic_rejections))
   call suite%addTest(t)


end function classical_sliding_line_suite


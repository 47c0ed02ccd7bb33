! SPDX-License-Identifier: GPL-3.0-or-later
! A spectrum of contact moduli from the rows of an input, and what is said of rows that do not give one.
module material_spectrum_rows
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: unset
   use adfric_base_words, only: get_word
   use adfric_material_given_spectrum, only: given_spectrum_t
   use adfric_material_master_curve, only: master_curve_fit_t
   use adfric_material_prony, only: prony_t, new_prony
   use adfric_material_spectrum_rows, only: set_spectrum_rows, take_spectrum, take_spectrum_attribute, has_spectrum, &
      check_spectrum, get_spectrum, shift_factor_of, describe_spectrum, doubt_spectrum, derive_spectrum, n_spectrum_rows, &
      spectrum_names
   use adfric_model_derived, only: derived_t
   use adfric_model_table, only: variable_t, kind_dataset
   use funit
   implicit none (type, external)

   !> Some roundings.
   real(dp), parameter :: closed_form = 10*epsilon(1.0_dp)
   !> Moduli and times of a rubber [Pa, s]; its Poisson's ratio.
   real(dp), parameter :: relaxed = 1.0e6_dp, arms(2) = [9.0e6_dp, 90.0e6_dp], times(2) = [1.0e-3_dp, 1.0e-5_dp], nu = 0.49_dp

   !> An input: values of the rows, lists and datasets, and what is swept.
   type :: input_t
      real(dp) :: values(n_spectrum_rows) = unset
      logical :: is_swept(n_spectrum_rows) = .false.
      type(given_spectrum_t) :: given
   end type input_t

contains

   !> Place of a row by its name.
   integer function place_of(name)
      character(*), intent(in) :: name
      type(variable_t) :: rows(n_spectrum_rows)

      call set_spectrum_rows(rows)
      do place_of = n_spectrum_rows, 1, -1
         if (rows(place_of)%name == name) return
      end do
   end function place_of

   !> Give a number, or a list in its place.
   subroutine give(input, name, values)
      type(input_t), intent(inout) :: input
      character(*), intent(in) :: name
      real(dp), intent(in) :: values(:)
      type(variable_t) :: rows(n_spectrum_rows)

      call set_spectrum_rows(rows)
      associate (k => place_of(name))
         input%values(k) = values(1)
         if (rows(k)%kind == kind_dataset) then
            input%values(k) = 1
            call take_spectrum(input%given, k, reshape(values, [size(values), 1]))
         end if
      end associate
   end subroutine give

   !> A rubber with two arms, by contact moduli.
   subroutine make_rubber(input)
      type(input_t), intent(out) :: input

      call give(input, 'modulus', [relaxed])
      call give(input, 'moduli', arms)
      call give(input, 'relaxation_times', times)
   end subroutine make_rubber

   !> The same by a master curve of four decades around its times, at 300 K.
   subroutine make_curve(input)
      type(input_t), intent(out) :: input
      type(prony_t) :: prony
      type(variable_t) :: rows(n_spectrum_rows)
      type(problems_t) :: problems
      real(dp) :: curve(81, 3)
      integer :: k

      call new_prony(prony, relaxed, arms, times)
      do k = 1, size(curve, 1)
         curve(k, 1) = 10.0_dp**(k*0.1_dp)
         call prony%get_complex_modulus(curve(k, 1), curve(k, 2), curve(k, 3))
      end do
      input%values(place_of('master_curve')) = 1
      call take_spectrum(input%given, place_of('master_curve'), curve)
      call set_spectrum_rows(rows)
      call take_spectrum_attribute(input%given, rows(place_of('master_curve')), place_of('master_curve'), &
         'reference_temperature', 300.0_dp, problems)
#line 89 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual(0, problems%count(), &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 89) )
  if (anyExceptions()) return
#line 90 "/work/main/tests/material/material_spectrum_rows.pf"
   end subroutine make_curve

   !> What is wrong with an input, a line for each problem.
   function problems_of(input) result(text)
      type(input_t), intent(in) :: input
      character(:), allocatable :: text
      type(variable_t) :: rows(n_spectrum_rows)
      type(problems_t) :: problems
      integer :: i

      call set_spectrum_rows(rows)
      call check_spectrum(rows, input%values, input%given, input%is_swept, problems)
      text = ''
      do i = 1, problems%count()
         text = text//problems%line_of(i, 'f')//new_line('a')
      end do
   end function problems_of

   !> The input is refused, in one line that begins so.
   subroutine check_refused(input, start)
      type(input_t), intent(in) :: input
      character(*), intent(in) :: start
      character(:), allocatable :: text

      text = problems_of(input)
#line 115 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual(1, index(text, 'f: &'//start), message=text//' / '//start, &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 115) )
  if (anyExceptions()) return
#line 116 "/work/main/tests/material/material_spectrum_rows.pf"
#line 116 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual(len(text), index(text, new_line('a')), message=text, &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 116) )
  if (anyExceptions()) return
#line 117 "/work/main/tests/material/material_spectrum_rows.pf"
   end subroutine check_refused

   !@test
   subroutine test_names()
      type(variable_t) :: rows(n_spectrum_rows)
      integer :: k

      call set_spectrum_rows(rows)
      do k = 1, n_spectrum_rows
#line 126 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual(rows(k)%name, get_word(spectrum_names, k), &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 126) )
  if (anyExceptions()) return
#line 127 "/work/main/tests/material/material_spectrum_rows.pf"
#line 127 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual(merge('operating', 'material ', k == n_spectrum_rows), rows(k)%group, &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 127) )
  if (anyExceptions()) return
#line 128 "/work/main/tests/material/material_spectrum_rows.pf"
#line 128 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertGreaterThan(len(rows(k)%meaning), 0, &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 128) )
  if (anyExceptions()) return
#line 129 "/work/main/tests/material/material_spectrum_rows.pf"
      end do
   end subroutine test_names

   !@test
   subroutine test_lists()
      type(input_t) :: input
      type(prony_t) :: prony

#line 137 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertFalse(has_spectrum(input%values), &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 137) )
  if (anyExceptions()) return
#line 138 "/work/main/tests/material/material_spectrum_rows.pf"
      call make_rubber(input)
#line 139 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertTrue(has_spectrum(input%values), &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 139) )
  if (anyExceptions()) return
#line 140 "/work/main/tests/material/material_spectrum_rows.pf"
#line 140 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual('', problems_of(input), &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 140) )
  if (anyExceptions()) return
#line 141 "/work/main/tests/material/material_spectrum_rows.pf"
      call get_spectrum(input%values, input%given, prony)
#line 142 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual(relaxed, prony%relaxed, &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 142) )
  if (anyExceptions()) return
#line 143 "/work/main/tests/material/material_spectrum_rows.pf"
#line 143 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual(arms(2:1:-1), prony%moduli, &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 143) )
  if (anyExceptions()) return
#line 144 "/work/main/tests/material/material_spectrum_rows.pf"
#line 144 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual(times(2:1:-1), prony%times, &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 144) )
  if (anyExceptions()) return
#line 145 "/work/main/tests/material/material_spectrum_rows.pf"
#line 145 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual(1.0_dp, shift_factor_of(input%values, input%given), &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 145) )
  if (anyExceptions()) return
#line 146 "/work/main/tests/material/material_spectrum_rows.pf"
#line 146 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual('', doubt_spectrum(input%values, input%given, [1.0_dp, 1.0_dp]), &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 146) )
  if (anyExceptions()) return
#line 147 "/work/main/tests/material/material_spectrum_rows.pf"
   end subroutine test_lists

   !@test
   subroutine test_young_moduli()
      type(input_t) :: input
      type(prony_t) :: prony

      call give(input, 'young_modulus', [relaxed])
      call give(input, 'poisson_ratio', [nu])
      call give(input, 'young_moduli', arms)
      call give(input, 'relaxation_times', times)
#line 158 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual('', problems_of(input), &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 158) )
  if (anyExceptions()) return
#line 159 "/work/main/tests/material/material_spectrum_rows.pf"
      call get_spectrum(input%values, input%given, prony)
      ! 1 - 0.49^2
#line 161 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertRelativelyEqual(relaxed/0.7599_dp, prony%relaxed, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 161) )
  if (anyExceptions()) return
#line 162 "/work/main/tests/material/material_spectrum_rows.pf"
#line 162 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertRelativelyEqual(arms(2:1:-1)/0.7599_dp, prony%moduli, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 162) )
  if (anyExceptions()) return
#line 163 "/work/main/tests/material/material_spectrum_rows.pf"
#line 163 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual(times(2:1:-1), prony%times, &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 163) )
  if (anyExceptions()) return
#line 164 "/work/main/tests/material/material_spectrum_rows.pf"
   end subroutine test_young_moduli

   !@test
   subroutine test_elastic()
      type(input_t) :: input
      type(prony_t) :: prony
      type(derived_t), allocatable :: list(:)
      character(:), allocatable :: text

      call give(input, 'modulus', [relaxed])
#line 174 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual('', problems_of(input), &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 174) )
  if (anyExceptions()) return
#line 175 "/work/main/tests/material/material_spectrum_rows.pf"
      call get_spectrum(input%values, input%given, prony)
#line 176 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual(relaxed, prony%relaxed, &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 176) )
  if (anyExceptions()) return
#line 177 "/work/main/tests/material/material_spectrum_rows.pf"
#line 177 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual(0, size(prony%times), &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 177) )
  if (anyExceptions()) return
#line 178 "/work/main/tests/material/material_spectrum_rows.pf"
      text = doubt_spectrum(input%values, input%given, [1.0_dp, 1.0_dp])
#line 179 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual(1, index(text, 'the material is elastic'), message=text, &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 179) )
  if (anyExceptions()) return
#line 180 "/work/main/tests/material/material_spectrum_rows.pf"
      call derive_spectrum(list, input%values, input%given)
#line 181 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual(2, size(list), &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 181) )
  if (anyExceptions()) return
#line 182 "/work/main/tests/material/material_spectrum_rows.pf"
      ! arms without a modulus are none, but their times may be shifted
      call give(input, 'moduli', 0*arms)
      call give(input, 'relaxation_times', times)
      call give(input, 'time_factor', [2.0_dp])
#line 186 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual('', problems_of(input), &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 186) )
  if (anyExceptions()) return
#line 187 "/work/main/tests/material/material_spectrum_rows.pf"
      text = doubt_spectrum(input%values, input%given, [1.0_dp, 1.0_dp])
#line 188 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual(1, index(text, 'the material is elastic'), message=text, &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 188) )
  if (anyExceptions()) return
#line 189 "/work/main/tests/material/material_spectrum_rows.pf"
      deallocate (list)
      call derive_spectrum(list, input%values, input%given)
#line 191 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual(3, size(list), &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 191) )
  if (anyExceptions()) return
#line 192 "/work/main/tests/material/material_spectrum_rows.pf"
   end subroutine test_elastic

   ! A curve of moduli is one of Young's modulus beside Poisson's ratio; the misfit of the fit is its own.
   !@test
   subroutine test_master_curve()
      type(input_t) :: input
      type(prony_t) :: contact, young
      type(master_curve_fit_t) :: fit
      character(:), allocatable :: text

      call make_curve(input)
#line 203 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual('', problems_of(input), &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 203) )
  if (anyExceptions()) return
#line 204 "/work/main/tests/material/material_spectrum_rows.pf"
      call get_spectrum(input%values, input%given, contact, fit)
#line 205 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual(fit%prony%relaxed, contact%relaxed, &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 205) )
  if (anyExceptions()) return
#line 206 "/work/main/tests/material/material_spectrum_rows.pf"
#line 206 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertRelativelyEqual(relaxed, contact%relaxed, tolerance=fit%modulus%largest, &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 206) )
  if (anyExceptions()) return
#line 207 "/work/main/tests/material/material_spectrum_rows.pf"
      call give(input, 'poisson_ratio', [nu])
#line 208 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual('', problems_of(input), &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 208) )
  if (anyExceptions()) return
#line 209 "/work/main/tests/material/material_spectrum_rows.pf"
      call get_spectrum(input%values, input%given, young)
#line 210 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertRelativelyEqual(contact%relaxed/0.7599_dp, young%relaxed, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 210) )
  if (anyExceptions()) return
#line 211 "/work/main/tests/material/material_spectrum_rows.pf"
#line 211 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertRelativelyEqual(contact%moduli/0.7599_dp, young%moduli, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 211) )
  if (anyExceptions()) return
#line 212 "/work/main/tests/material/material_spectrum_rows.pf"
      text = describe_spectrum(input%values, input%given)
#line 213 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual(1, index(text, 'master curve: 81 frequencies'), message=text, &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 213) )
  if (anyExceptions()) return
#line 214 "/work/main/tests/material/material_spectrum_rows.pf"
#line 214 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertGreaterThan(index(text, 'arm 1: contact modulus'), 0, &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 214) )
  if (anyExceptions()) return
#line 215 "/work/main/tests/material/material_spectrum_rows.pf"
#line 215 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual('', doubt_spectrum(input%values, input%given, [10.0_dp, 1.0e6_dp]), &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 215) )
  if (anyExceptions()) return
#line 216 "/work/main/tests/material/material_spectrum_rows.pf"
      text = doubt_spectrum(input%values, input%given, [1.0_dp, 1.0e6_dp])
#line 217 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertGreaterThan(index(text, 'friction is missing'), 0, message=text, &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 217) )
  if (anyExceptions()) return
#line 218 "/work/main/tests/material/material_spectrum_rows.pf"
      ! the times of a colder material are longer, and the curve ends sooner
      call give(input, 'time_factor', [1.0e6_dp])
      text = doubt_spectrum(input%values, input%given, [10.0_dp, 1.0e6_dp])
#line 221 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertGreaterThan(index(text, 'friction is missing'), 0, message=text, &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 221) )
  if (anyExceptions()) return
#line 222 "/work/main/tests/material/material_spectrum_rows.pf"
   end subroutine test_master_curve

   !@test
   subroutine test_shift()
      type(input_t) :: input
      type(derived_t), allocatable :: list(:)

      call make_curve(input)
      call give(input, 'shift', [2.0_dp])
      call give(input, 'wlf_c1', [4.0_dp])
      call give(input, 'wlf_c2', [50.0_dp])
      call give(input, 'temperature', [350.0_dp])
      call give(input, 'time_factor', [3.0_dp])
#line 235 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual('', problems_of(input), &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 235) )
  if (anyExceptions()) return
#line 236 "/work/main/tests/material/material_spectrum_rows.pf"
      ! log10 a_T = -4 50/(50 + 50), with the temperature of the curve
#line 237 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertRelativelyEqual(3.0e-2_dp, shift_factor_of(input%values, input%given), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 237) )
  if (anyExceptions()) return
#line 238 "/work/main/tests/material/material_spectrum_rows.pf"
      call give(input, 'reference_temperature', [350.0_dp])
#line 239 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual(3.0_dp, shift_factor_of(input%values, input%given), &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 239) )
  if (anyExceptions()) return
#line 240 "/work/main/tests/material/material_spectrum_rows.pf"
      call derive_spectrum(list, input%values, input%given)
#line 241 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual('shift_factor', list(3)%name, &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 241) )
  if (anyExceptions()) return
#line 242 "/work/main/tests/material/material_spectrum_rows.pf"
#line 242 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual(3.0_dp, list(3)%value, &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 242) )
  if (anyExceptions()) return
#line 243 "/work/main/tests/material/material_spectrum_rows.pf"
#line 243 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertTrue(list(3)%follows_from('temperature'), &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 243) )
  if (anyExceptions()) return
#line 244 "/work/main/tests/material/material_spectrum_rows.pf"
#line 244 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertFalse(list(3)%follows_from('modulus'), &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 244) )
  if (anyExceptions()) return
#line 245 "/work/main/tests/material/material_spectrum_rows.pf"
   end subroutine test_shift

   !@test
   subroutine test_refused_moduli()
      type(input_t) :: empty, input

      call check_refused(empty, 'material modulus: is missing [Pa]')
      input = empty
      call give(input, 'poisson_ratio', [nu])
      call check_refused(input, 'material modulus: is missing [Pa]')
      input = empty
      call give(input, 'young_modulus', [relaxed])
      call check_refused(input, 'material poisson_ratio: is missing [-]')
      call make_rubber(input)
      call give(input, 'poisson_ratio', [nu])
      call check_refused(input, 'material modulus: stands beside poisson_ratio; give modulus, or')
      call make_rubber(input)
      call give(input, 'modulus', [1.0e-95_dp])
      call check_refused(input, 'material modulus: is too small')
   end subroutine test_refused_moduli

   !@test
   subroutine test_refused_arms()
      type(input_t) :: input

      call make_rubber(input)
      call give(input, 'moduli', arms(:1))
      call check_refused(input, 'material moduli: are not as many as relaxation_times')
      call make_rubber(input)
      call give(input, 'young_moduli', arms)
      call check_refused(input, 'material young_moduli: stands beside modulus')
      call make_rubber(input)
      input%values(place_of('moduli')) = unset
      call check_refused(input, 'material moduli: is missing [Pa]')
      call make_rubber(input)
      input%values(place_of('relaxation_times')) = unset
      call check_refused(input, 'material moduli: needs relaxation_times')
      call make_rubber(input)
      call give(input, 'terms_per_decade', [2.0_dp])
      call check_refused(input, 'material terms_per_decade: has no meaning without master_curve')
      call make_rubber(input)
      input%values(place_of('modulus')) = unset
      call give(input, 'young_modulus', [relaxed])
      call give(input, 'poisson_ratio', [nu])
      call give(input, 'young_moduli', arms)
      call check_refused(input, 'material moduli: needs modulus')
   end subroutine test_refused_arms

   !@test
   subroutine test_refused_curves()
      type(input_t) :: input

      call make_curve(input)
      call give(input, 'modulus', [relaxed])
      call check_refused(input, 'material modulus: stands beside master_curve')
      call make_curve(input)
      input%given%master_curve(3, 1) = 0
      call check_refused(input, 'material master_curve: has frequencies that are not > 0')
      call make_curve(input)
      input%given%master_curve(3, 3) = -1
      call check_refused(input, 'material master_curve: has moduli < 0')
      call make_curve(input)
      input%given%master_curve(:, 2) = 0
      call check_refused(input, 'material master_curve: gives a fluid')
   end subroutine test_refused_curves

   !@test
   subroutine test_refused_shifts()
      type(input_t) :: input, elastic

      call give(elastic, 'modulus', [relaxed])
      input = elastic
      call give(input, 'temperature', [300.0_dp])
      call check_refused(input, 'operating temperature: has no meaning without relaxation_times or master_curve')
      input = elastic
      input%is_swept(place_of('time_factor')) = .true.
      call check_refused(input, 'material time_factor: has no meaning without relaxation_times')
      call make_rubber(input)
      call give(input, 'temperature', [300.0_dp])
      call check_refused(input, 'operating temperature: has no meaning without shift')
      call give(input, 'shift', [3.0_dp])
      call give(input, 'activation_energy', [1.0e5_dp])
      call check_refused(input, 'material reference_temperature: is missing [K]; shift = ''arrhenius''')
      call give(input, 'reference_temperature', [300.0_dp])
#line 329 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual('', problems_of(input), &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 329) )
  if (anyExceptions()) return
#line 330 "/work/main/tests/material/material_spectrum_rows.pf"
      call give(input, 'wlf_c1', [1.0_dp])
      call check_refused(input, 'material wlf_c1: has no meaning for shift = ''arrhenius''')
      input%values(place_of('activation_energy')) = unset
      call give(input, 'shift', [2.0_dp])
      call check_refused(input, 'material wlf_c2: is missing [K]')
      call give(input, 'wlf_c2', [50.0_dp])
      call give(input, 'temperature', [240.0_dp])
      call check_refused(input, 'operating temperature: is out of the range of the law')
      input%values(place_of('temperature')) = unset
      call check_refused(input, 'operating temperature: is missing [K]')
   end subroutine test_refused_shifts

   !@test
   subroutine test_refused_attribute()
      type(given_spectrum_t) :: given
      type(variable_t) :: rows(n_spectrum_rows)
      type(problems_t) :: problems
      character(:), allocatable :: text
      integer :: place

      call set_spectrum_rows(rows)
      place = place_of('master_curve')
      call take_spectrum_attribute(given, rows(place), place, 'reference_temperature', 0.0_dp, problems)
#line 353 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual(1, problems%count(), &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 353) )
  if (anyExceptions()) return
#line 354 "/work/main/tests/material/material_spectrum_rows.pf"
      text = problems%line_of(1, 'f')
#line 355 "/work/main/tests/material/material_spectrum_rows.pf"
  call assertEqual('f: &material master_curve: has an attribute reference_temperature that is not > 0', text, &
 & location=SourceLocation( &
 & 'material_spectrum_rows.pf', &
 & 355) )
  if (anyExceptions()) return
#line 356 "/work/main/tests/material/material_spectrum_rows.pf"
   end subroutine test_refused_attribute

end module material_spectrum_rows

module Wrapmaterial_spectrum_rows
   use FUnit
   use material_spectrum_rows
   implicit none
   private

contains


end module Wrapmaterial_spectrum_rows

function material_spectrum_rows_suite() result(suite)
   use FUnit
   use material_spectrum_rows
   use Wrapmaterial_spectrum_rows
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('material_spectrum_rows_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_names', &
      test_names))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_lists', &
      test_lists))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_young_moduli', &
      test_young_moduli))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_elastic', &
      test_elastic))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_master_curve', &
      test_master_curve))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_shift', &
      test_shift))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_refused_moduli', &
      test_refused_moduli))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_refused_arms', &
      test_refused_arms))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_refused_curves', &
      test_refused_curves))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_refused_shifts', &
      test_refused_shifts))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_refused_attribute', &
      test_refused_attribute))
   call suite%addTest(t)


end function material_spectrum_rows_suite


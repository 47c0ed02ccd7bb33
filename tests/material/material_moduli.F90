! SPDX-License-Identifier: GPL-3.0-or-later
! Young's moduli in place of the contact modulus: the same contact in every model, and a part of what it is asked for.
module material_moduli
   use adfric, only: known_models, new_model
   use adfric_base_error, only: error_t
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set, unset
   use adfric_base_words, only: count_words, get_word
   use adfric_model_model, only: model_t, derived_t
   use adfric_model_table, only: kind_dataset
   use trial_case, only: trial_case_t, new_case
   use funit
   implicit none (type, external)

   real(dp), parameter :: young = 210.0e9_dp, nu = 0.3_dp, other_young = 3.0e9_dp, other_nu = 0.4_dp
   real(dp), parameter :: rigid_plane = young/((1 - nu)*(1 + nu)), &
      modulus = 1/((1 - nu**2)/young + (1 - other_nu**2)/other_young)
   !> Roundings of E* and of what follows from it by powers and roots.
   real(dp), parameter :: tolerance = 1000*epsilon(1.0_dp)

contains

   !> A case that lacks but its modulus.
   subroutine new_contact(name, case)
      character(*), intent(in) :: name
      type(trial_case_t), intent(out) :: case

      call new_case(case, name)
      select case (name)
      case ('hertz')
         call case%give('kind', 2.0_dp)
         call case%give('radius', 1.0e-2_dp)
         call case%give('load', 3.0_dp)
      case ('rigid_punch')
         call case%give('kind', 3.0_dp)
         call case%give('radius', 1.0e-2_dp)
         call case%give('load', 3.0_dp)
      case ('indenter')
         call case%give('kind', 3.0_dp)
         call case%give('radius', 1.0e-2_dp)
         call case%give('load', 3.0_dp)
      case default
         call case%give('period', 1.0e-4_dp)
         call case%give('amplitude', 1.0e-7_dp)
         call case%give('mean_pressure', 1.0e6_dp)
      end select
      if (name == 'wave_2d_elastic') call case%give('cells', 64.0_dp)
   end subroutine new_contact

   !> Two cases have the same results.
   subroutine check_same(name, expected, found)
      character(*), intent(in) :: name
      type(trial_case_t), intent(inout) :: expected, found
      integer :: i
      real(dp) :: scale

#line 59 "/work/main/tests/material/material_moduli.pf"
  call assertEqual('', expected%problems_of(), message=name, &
 & location=SourceLocation( &
 & 'material_moduli.pf', &
 & 59) )
  if (anyExceptions()) return
#line 60 "/work/main/tests/material/material_moduli.pf"
#line 60 "/work/main/tests/material/material_moduli.pf"
  call assertEqual('', found%problems_of(), message=name, &
 & location=SourceLocation( &
 & 'material_moduli.pf', &
 & 60) )
  if (anyExceptions()) return
#line 61 "/work/main/tests/material/material_moduli.pf"
      call expected%solve()
      call found%solve()
#line 63 "/work/main/tests/material/material_moduli.pf"
  call assertEqual(0, found%status(1), message=name, &
 & location=SourceLocation( &
 & 'material_moduli.pf', &
 & 63) )
  if (anyExceptions()) return
#line 64 "/work/main/tests/material/material_moduli.pf"
      do i = 1, size(found%results, 1)
         if (index(found%model%results(i)%name, 'violation') > 0) cycle
         if (ieee_is_nan(expected%results(i, 1))) then
#line 67 "/work/main/tests/material/material_moduli.pf"
  call assertTrue(ieee_is_nan(found%results(i, 1)), message=name, &
 & location=SourceLocation( &
 & 'material_moduli.pf', &
 & 67) )
  if (anyExceptions()) return
#line 68 "/work/main/tests/material/material_moduli.pf"
            cycle
         end if
         scale = max(abs(expected%results(i, 1)), tiny(scale))
#line 71 "/work/main/tests/material/material_moduli.pf"
  call assertEqual(expected%results(i, 1), found%results(i, 1), tolerance=tolerance*scale, message=name, &
 & location=SourceLocation( &
 & 'material_moduli.pf', &
 & 71) )
  if (anyExceptions()) return
#line 72 "/work/main/tests/material/material_moduli.pf"
      end do
   end subroutine check_same

   !@test
   subroutine test_same_contact()
      character(*), parameter :: names = 'hertz rigid_punch indenter wave_1d wave_2d_elastic'
      type(trial_case_t) :: expected, found
      integer :: i

      do i = 1, count_words(names)
         call new_contact(get_word(names, i), expected)
         call expected%give('contact_modulus', rigid_plane)
         call new_contact(get_word(names, i), found)
         call found%give('young_modulus', young)
         call found%give('poisson_ratio', nu)
         if (get_word(names, i) == 'hertz') call expected%give('poisson_ratio', nu)
         call check_same(get_word(names, i), expected, found)
         if (found%model%index_of('solid', 'second_young_modulus') == 0) cycle
         call expected%give('contact_modulus', modulus)
         call found%give('second_young_modulus', other_young)
         call found%give('second_poisson_ratio', other_nu)
         call check_same(get_word(names, i)//', two bodies', expected, found)
      end do
   end subroutine test_same_contact

   !@test
   subroutine test_refusals()
      character(*), parameter :: names = 'hertz rigid_punch indenter wave_1d wave_2d_elastic'
      type(trial_case_t) :: case
      integer :: i

      do i = 1, count_words(names)
         call new_contact(get_word(names, i), case)
#line 105 "/work/main/tests/material/material_moduli.pf"
  call assertEqual(1, index(case%problems_of(), 'case: &solid contact_modulus: is missing [Pa]'), &
 & location=SourceLocation( &
 & 'material_moduli.pf', &
 & 105) )
  if (anyExceptions()) return
#line 106 "/work/main/tests/material/material_moduli.pf"
         call case%give('young_modulus', young)
#line 107 "/work/main/tests/material/material_moduli.pf"
  call assertEqual(1, index(case%problems_of(), 'case: &solid poisson_ratio: is missing'), &
 & location=SourceLocation( &
 & 'material_moduli.pf', &
 & 107) )
  if (anyExceptions()) return
#line 108 "/work/main/tests/material/material_moduli.pf"
         call case%give('poisson_ratio', nu)
         call case%give('contact_modulus', young)
#line 110 "/work/main/tests/material/material_moduli.pf"
  call assertEqual(1, index(case%problems_of(), 'case: &solid contact_modulus: stands beside young_modulus'), &
 & location=SourceLocation( &
 & 'material_moduli.pf', &
 & 110) )
  if (anyExceptions()) return
#line 111 "/work/main/tests/material/material_moduli.pf"
      end do
   end subroutine test_refusals

   !@test
   subroutine test_every_model_with_a_contact_modulus()
      class(model_t), allocatable :: model
      type(error_t), allocatable :: error
      integer :: i, k, n

      n = 0
      do i = 1, count_words(known_models)
         call new_model(model, get_word(known_models, i), error)
         do k = 1, size(model%variables)
            if (model%variables(k)%name /= 'contact_modulus') cycle
            n = n + 1
#line 126 "/work/main/tests/material/material_moduli.pf"
  call assertEqual('young_modulus', model%variables(k + 1)%name, message=model%name, &
 & location=SourceLocation( &
 & 'material_moduli.pf', &
 & 126) )
  if (anyExceptions()) return
#line 127 "/work/main/tests/material/material_moduli.pf"
#line 127 "/work/main/tests/material/material_moduli.pf"
  call assertEqual('poisson_ratio', model%variables(k + 2)%name, message=model%name, &
 & location=SourceLocation( &
 & 'material_moduli.pf', &
 & 127) )
  if (anyExceptions()) return
#line 128 "/work/main/tests/material/material_moduli.pf"
#line 128 "/work/main/tests/material/material_moduli.pf"
  call assertEqual(model%variables(k)%group, model%variables(k + 2)%group, message=model%name, &
 & location=SourceLocation( &
 & 'material_moduli.pf', &
 & 128) )
  if (anyExceptions()) return
#line 129 "/work/main/tests/material/material_moduli.pf"
            call check_derived(model, k)
         end do
      end do
#line 132 "/work/main/tests/material/material_moduli.pf"
  call assertEqual(8, n, &
 & location=SourceLocation( &
 & 'material_moduli.pf', &
 & 132) )
  if (anyExceptions()) return
#line 133 "/work/main/tests/material/material_moduli.pf"
   end subroutine test_every_model_with_a_contact_modulus

   !> The model says what E* follows from the modulus of a body.
   subroutine check_derived(model, place)
      class(model_t), intent(inout) :: model
      integer, intent(in) :: place
      type(derived_t), allocatable :: list(:)
      real(dp) :: values(size(model%variables))
      real(dp), parameter :: heights(4, 4) = reshape([real(dp) :: 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0], [4, 4])
      type(problems_t) :: problems
      integer :: i

      ! a case that has everything but a viscoelastic material; the second body is rigid
      values = [(model%variables(i)%default, i=1, size(values))]
      where (.not. is_set(values)) values = 1
      do i = 1, size(values)
         if (index(model%variables(i)%name, 'second_') == 1) values(i) = unset
         if (model%variables(i)%group == 'material') values(i) = unset
         if (model%variables(i)%kind == kind_dataset) call model%take_dataset(i, heights, problems)
      end do
      values(place:place + 2) = [unset, young, nu]
      list = model%get_derived(values)
#line 155 "/work/main/tests/material/material_moduli.pf"
  call assertGreaterThan(size(list), 0, message=model%name, &
 & location=SourceLocation( &
 & 'material_moduli.pf', &
 & 155) )
  if (anyExceptions()) return
#line 156 "/work/main/tests/material/material_moduli.pf"
#line 156 "/work/main/tests/material/material_moduli.pf"
  call assertEqual('contact_modulus', list(1)%name, message=model%name, &
 & location=SourceLocation( &
 & 'material_moduli.pf', &
 & 156) )
  if (anyExceptions()) return
#line 157 "/work/main/tests/material/material_moduli.pf"
#line 157 "/work/main/tests/material/material_moduli.pf"
  call assertRelativelyEqual(rigid_plane, list(1)%value, tolerance=tolerance, &
 & location=SourceLocation( &
 & 'material_moduli.pf', &
 & 157) )
  if (anyExceptions()) return
#line 158 "/work/main/tests/material/material_moduli.pf"
      values(place:place + 2) = [young, unset, unset]
      list = model%get_derived(values)
#line 160 "/work/main/tests/material/material_moduli.pf"
  call assertFalse(any([(list(i)%name == 'contact_modulus', i=1, size(list))]), message=model%name, &
 & location=SourceLocation( &
 & 'material_moduli.pf', &
 & 160) )
  if (anyExceptions()) return
#line 161 "/work/main/tests/material/material_moduli.pf"
   end subroutine check_derived

end module material_moduli

module Wrapmaterial_moduli
   use FUnit
   use material_moduli
   implicit none
   private

contains


end module Wrapmaterial_moduli

function material_moduli_suite() result(suite)
   use FUnit
   use material_moduli
   use Wrapmaterial_moduli
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('material_moduli_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_same_contact', &
      test_same_contact))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_refusals', &
      test_refusals))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_every_model_with_a_contact_modulus', &
      test_every_model_with_a_contact_modulus))
   call suite%addTest(t)


end function material_moduli_suite


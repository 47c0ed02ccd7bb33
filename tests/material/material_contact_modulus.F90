! SPDX-License-Identifier: GPL-3.0-or-later
! The contact modulus of elastic bodies, and what is said of values that do not give it.
module material_contact_modulus
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: unset
   use adfric_material_contact_modulus, only: set_modulus_rows, contact_modulus_of, has_contact_modulus, &
      check_contact_modulus, derive_contact_modulus, n_one_body, n_two_bodies
   use adfric_model_model, only: derived_t
   use adfric_model_rows, only: above_zero
   use adfric_model_table, only: variable_t
   use funit
   implicit none (type, external)

   !> Five roundings.
   real(dp), parameter :: closed_form = 5*epsilon(1.0_dp)
   real(dp), parameter :: steel = 210.0e9_dp, nu = 0.3_dp

contains

   !> What is wrong with the values, a line for each problem.
   function problems_of(values, has_own_poisson_ratio) result(text)
      real(dp), intent(in) :: values(:)
      logical, intent(in) :: has_own_poisson_ratio
      character(:), allocatable :: text
      type(variable_t) :: rows(size(values))
      type(problems_t) :: problems
      integer :: i

      call set_modulus_rows(above_zero('solid', '', 'Pa', ''), rows)
      call check_contact_modulus(rows, values, problems, has_own_poisson_ratio)
      text = ''
      do i = 1, problems%count()
         text = text//problems%line_of(i, 'f')//new_line('a')
      end do
   end function problems_of

   !> The values are refused, in one line that begins so.
   subroutine check_refused(values, start)
      real(dp), intent(in) :: values(:)
      character(*), intent(in) :: start
      character(:), allocatable :: text

      text = problems_of(values, .false.)
#line 45 "/work/main/tests/material/material_contact_modulus.pf"
  call assertEqual(1, index(text, 'f: &solid '//start), message=text//' / '//start, &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 45) )
  if (anyExceptions()) return
#line 46 "/work/main/tests/material/material_contact_modulus.pf"
#line 46 "/work/main/tests/material/material_contact_modulus.pf"
  call assertEqual(len(text), index(text, new_line('a')), message=text, &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 46) )
  if (anyExceptions()) return
#line 47 "/work/main/tests/material/material_contact_modulus.pf"
   end subroutine check_refused

   !@test
   subroutine test_law()
      real(dp) :: one, both

#line 53 "/work/main/tests/material/material_contact_modulus.pf"
  call assertEqual(4.0e9_dp, contact_modulus_of([4.0e9_dp, unset, unset, unset, unset]), &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 53) )
  if (anyExceptions()) return
#line 54 "/work/main/tests/material/material_contact_modulus.pf"
      one = contact_modulus_of([unset, steel, nu])
#line 55 "/work/main/tests/material/material_contact_modulus.pf"
  call assertRelativelyEqual(steel/0.91_dp, one, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 55) )
  if (anyExceptions()) return
#line 56 "/work/main/tests/material/material_contact_modulus.pf"
#line 56 "/work/main/tests/material/material_contact_modulus.pf"
  call assertEqual(one, contact_modulus_of([unset, steel, nu, unset, unset]), &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 56) )
  if (anyExceptions()) return
#line 57 "/work/main/tests/material/material_contact_modulus.pf"
      ! equal bodies, and a second one that is all but rigid
      both = contact_modulus_of([unset, steel, nu, steel, nu])
#line 59 "/work/main/tests/material/material_contact_modulus.pf"
  call assertRelativelyEqual(one/2, both, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 59) )
  if (anyExceptions()) return
#line 60 "/work/main/tests/material/material_contact_modulus.pf"
#line 60 "/work/main/tests/material/material_contact_modulus.pf"
  call assertEqual(one, contact_modulus_of([unset, steel, nu, 1.0e30_dp, 0.0_dp]), &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 60) )
  if (anyExceptions()) return
#line 61 "/work/main/tests/material/material_contact_modulus.pf"
      ! 1/E* = 0.75/2 + 0.96/3 = 0.695
      both = contact_modulus_of([unset, 2.0_dp, 0.5_dp, 3.0_dp, -0.2_dp])
#line 63 "/work/main/tests/material/material_contact_modulus.pf"
  call assertRelativelyEqual(1/0.695_dp, both, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 63) )
  if (anyExceptions()) return
#line 64 "/work/main/tests/material/material_contact_modulus.pf"
#line 64 "/work/main/tests/material/material_contact_modulus.pf"
  call assertEqual(both, contact_modulus_of([unset, 3.0_dp, -0.2_dp, 2.0_dp, 0.5_dp]), &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 64) )
  if (anyExceptions()) return
#line 65 "/work/main/tests/material/material_contact_modulus.pf"
   end subroutine test_law

   !@test
   subroutine test_ends_of_the_numbers()
      real(dp) :: soft

      ! bodies that are 60 decades apart, and Poisson's ratio next to -1
#line 72 "/work/main/tests/material/material_contact_modulus.pf"
  call assertEqual(1.0e-30_dp, contact_modulus_of([unset, 1.0e-30_dp, 0.0_dp, 1.0e30_dp, 0.0_dp]), &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 72) )
  if (anyExceptions()) return
#line 73 "/work/main/tests/material/material_contact_modulus.pf"
      soft = contact_modulus_of([unset, 1.0_dp, -1 + epsilon(1.0_dp), unset, unset])
#line 74 "/work/main/tests/material/material_contact_modulus.pf"
  call assertRelativelyEqual(0.5_dp/epsilon(1.0_dp), soft, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 74) )
  if (anyExceptions()) return
#line 75 "/work/main/tests/material/material_contact_modulus.pf"
   end subroutine test_ends_of_the_numbers

   !@test
   subroutine test_what_is_complete()
#line 79 "/work/main/tests/material/material_contact_modulus.pf"
  call assertTrue(has_contact_modulus([1.0_dp, unset, unset]), &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 79) )
  if (anyExceptions()) return
#line 80 "/work/main/tests/material/material_contact_modulus.pf"
#line 80 "/work/main/tests/material/material_contact_modulus.pf"
  call assertTrue(has_contact_modulus([unset, 1.0_dp, 0.3_dp]), &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 80) )
  if (anyExceptions()) return
#line 81 "/work/main/tests/material/material_contact_modulus.pf"
#line 81 "/work/main/tests/material/material_contact_modulus.pf"
  call assertTrue(has_contact_modulus([unset, 1.0_dp, 0.3_dp, unset, unset]), &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 81) )
  if (anyExceptions()) return
#line 82 "/work/main/tests/material/material_contact_modulus.pf"
#line 82 "/work/main/tests/material/material_contact_modulus.pf"
  call assertTrue(has_contact_modulus([unset, 1.0_dp, 0.3_dp, 1.0_dp, 0.3_dp]), &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 82) )
  if (anyExceptions()) return
#line 83 "/work/main/tests/material/material_contact_modulus.pf"
#line 83 "/work/main/tests/material/material_contact_modulus.pf"
  call assertFalse(has_contact_modulus([unset, 1.0_dp, unset]), &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 83) )
  if (anyExceptions()) return
#line 84 "/work/main/tests/material/material_contact_modulus.pf"
#line 84 "/work/main/tests/material/material_contact_modulus.pf"
  call assertFalse(has_contact_modulus([unset, unset, 0.3_dp]), &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 84) )
  if (anyExceptions()) return
#line 85 "/work/main/tests/material/material_contact_modulus.pf"
#line 85 "/work/main/tests/material/material_contact_modulus.pf"
  call assertFalse(has_contact_modulus([unset, 1.0_dp, 0.3_dp, 1.0_dp, unset]), &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 85) )
  if (anyExceptions()) return
#line 86 "/work/main/tests/material/material_contact_modulus.pf"
#line 86 "/work/main/tests/material/material_contact_modulus.pf"
  call assertFalse(has_contact_modulus([unset, unset, unset, 1.0_dp, 0.3_dp]), &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 86) )
  if (anyExceptions()) return
#line 87 "/work/main/tests/material/material_contact_modulus.pf"
   end subroutine test_what_is_complete

   !@test
   subroutine test_refusals()
      call check_refused([unset, unset, unset, unset, unset], 'contact_modulus: is missing [Pa]')
      call check_refused([unset, unset, nu, unset, unset], 'contact_modulus: is missing [Pa]')
      call check_refused([unset, unset, unset, steel, nu], 'contact_modulus: is missing [Pa]')
      call check_refused([unset, steel, unset, unset, unset], 'poisson_ratio: is missing [-]')
      call check_refused([unset, steel, nu, steel, unset], 'second_poisson_ratio: is missing [-]')
      call check_refused([unset, steel, nu, unset, nu], 'second_young_modulus: is missing [Pa]')
      call check_refused([steel, steel, nu, unset, unset], 'contact_modulus: stands beside young_modulus;')
      call check_refused([steel, unset, nu, unset, unset], 'contact_modulus: stands beside poisson_ratio;')
      call check_refused([steel, unset, unset, steel, nu], 'contact_modulus: stands beside second_young_modulus;')
      call check_refused([unset, steel, unset], 'poisson_ratio: is missing [-]')
      call check_refused([steel, steel, nu], 'contact_modulus: stands beside young_modulus;')
   end subroutine test_refusals

   !@test
   subroutine test_what_is_allowed()
#line 106 "/work/main/tests/material/material_contact_modulus.pf"
  call assertEqual('', problems_of([steel, unset, unset], .false.), &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 106) )
  if (anyExceptions()) return
#line 107 "/work/main/tests/material/material_contact_modulus.pf"
#line 107 "/work/main/tests/material/material_contact_modulus.pf"
  call assertEqual('', problems_of([unset, steel, nu], .false.), &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 107) )
  if (anyExceptions()) return
#line 108 "/work/main/tests/material/material_contact_modulus.pf"
#line 108 "/work/main/tests/material/material_contact_modulus.pf"
  call assertEqual('', problems_of([unset, steel, nu, unset, unset], .false.), &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 108) )
  if (anyExceptions()) return
#line 109 "/work/main/tests/material/material_contact_modulus.pf"
#line 109 "/work/main/tests/material/material_contact_modulus.pf"
  call assertEqual('', problems_of([unset, steel, nu, steel, nu], .false.), &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 109) )
  if (anyExceptions()) return
#line 110 "/work/main/tests/material/material_contact_modulus.pf"
      ! where Poisson's ratio has a use of its own it stands beside the contact modulus
#line 111 "/work/main/tests/material/material_contact_modulus.pf"
  call assertEqual('', problems_of([steel, unset, nu, unset, unset], .true.), &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 111) )
  if (anyExceptions()) return
#line 112 "/work/main/tests/material/material_contact_modulus.pf"
   end subroutine test_what_is_allowed

   !@test
   subroutine test_derived()
      type(variable_t) :: one(n_one_body), two(n_two_bodies)
      type(derived_t), allocatable :: list(:)

      call set_modulus_rows(above_zero('solid', '', 'Pa', ''), two)
      list = derive_contact_modulus(two, [unset, steel, nu, steel, nu])
#line 121 "/work/main/tests/material/material_contact_modulus.pf"
  call assertEqual(1, size(list), &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 121) )
  if (anyExceptions()) return
#line 122 "/work/main/tests/material/material_contact_modulus.pf"
#line 122 "/work/main/tests/material/material_contact_modulus.pf"
  call assertEqual('contact_modulus', list(1)%name, &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 122) )
  if (anyExceptions()) return
#line 123 "/work/main/tests/material/material_contact_modulus.pf"
#line 123 "/work/main/tests/material/material_contact_modulus.pf"
  call assertEqual('Pa', list(1)%unit, &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 123) )
  if (anyExceptions()) return
#line 124 "/work/main/tests/material/material_contact_modulus.pf"
#line 124 "/work/main/tests/material/material_contact_modulus.pf"
  call assertRelativelyEqual(steel/1.82_dp, list(1)%value, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 124) )
  if (anyExceptions()) return
#line 125 "/work/main/tests/material/material_contact_modulus.pf"
      call set_modulus_rows(above_zero('solid', '', 'Pa', ''), one)
      ! what is given, or cannot be known, is not derived
#line 127 "/work/main/tests/material/material_contact_modulus.pf"
  call assertEqual(0, size(derive_contact_modulus(one, [steel, unset, unset])), &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 127) )
  if (anyExceptions()) return
#line 128 "/work/main/tests/material/material_contact_modulus.pf"
#line 128 "/work/main/tests/material/material_contact_modulus.pf"
  call assertEqual(0, size(derive_contact_modulus(one, [unset, steel, unset])), &
 & location=SourceLocation( &
 & 'material_contact_modulus.pf', &
 & 128) )
  if (anyExceptions()) return
#line 129 "/work/main/tests/material/material_contact_modulus.pf"
   end subroutine test_derived

end module material_contact_modulus

module Wrapmaterial_contact_modulus
   use FUnit
   use material_contact_modulus
   implicit none
   private

contains


end module Wrapmaterial_contact_modulus

function material_contact_modulus_suite() result(suite)
   use FUnit
   use material_contact_modulus
   use Wrapmaterial_contact_modulus
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('material_contact_modulus_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_law', &
      test_law))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_ends_of_the_numbers', &
      test_ends_of_the_numbers))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_what_is_complete', &
      test_what_is_complete))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_refusals', &
      test_refusals))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_what_is_allowed', &
      test_what_is_allowed))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_derived', &
      test_derived))
   call suite%addTest(t)


end function material_contact_modulus_suite


! SPDX-License-Identifier: GPL-3.0-or-later
! The shift of relaxation times with temperature, and where its laws end.
module material_time_temperature
   use adfric_base_kinds, only: dp
   use adfric_material_time_temperature, only: time_temperature_t, shift_none, shift_wlf, shift_arrhenius, gas_constant
   use funit
   implicit none (type, external)

   !> Roundings of an exponent of some tens, as they appear in the power.
   real(dp), parameter :: power_eps = 200*epsilon(1.0_dp)

contains

   ! The factor, which must be valid.
   real(dp) function factor_at(law, temperature)
      type(time_temperature_t), intent(in) :: law
      real(dp), intent(in) :: temperature
      logical :: is_valid

      call law%get_shift_factor(temperature, factor_at, is_valid)
#line 21 "/work/main/tests/material/material_time_temperature.pf"
  call assertTrue(is_valid, &
 & location=SourceLocation( &
 & 'material_time_temperature.pf', &
 & 21) )
  if (anyExceptions()) return
#line 22 "/work/main/tests/material/material_time_temperature.pf"
   end function factor_at

   !@test
   subroutine test_none()
#line 26 "/work/main/tests/material/material_time_temperature.pf"
  call assertEqual(1.0_dp, factor_at(time_temperature_t(law=shift_none), 77.0_dp), tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'material_time_temperature.pf', &
 & 26) )
  if (anyExceptions()) return
#line 27 "/work/main/tests/material/material_time_temperature.pf"
   end subroutine test_none

   ! At the reference nothing moves; at T0 + c2 half of c1 is reached, far above all of it.
   !@test
   subroutine test_wlf()
      type(time_temperature_t) :: law

      law = time_temperature_t(law=shift_wlf, reference_temperature=250.0_dp, c1=8.0_dp, c2=50.0_dp)
#line 35 "/work/main/tests/material/material_time_temperature.pf"
  call assertEqual(1.0_dp, factor_at(law, 250.0_dp), tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'material_time_temperature.pf', &
 & 35) )
  if (anyExceptions()) return
#line 36 "/work/main/tests/material/material_time_temperature.pf"
#line 36 "/work/main/tests/material/material_time_temperature.pf"
  call assertEqual(1.0_dp, factor_at(law, 300.0_dp)/1.0e-4_dp, tolerance=power_eps, &
 & location=SourceLocation( &
 & 'material_time_temperature.pf', &
 & 36) )
  if (anyExceptions()) return
#line 37 "/work/main/tests/material/material_time_temperature.pf"
#line 37 "/work/main/tests/material/material_time_temperature.pf"
  call assertEqual(1.0_dp, factor_at(law, 225.0_dp)/1.0e8_dp, tolerance=power_eps, &
 & location=SourceLocation( &
 & 'material_time_temperature.pf', &
 & 37) )
  if (anyExceptions()) return
#line 38 "/work/main/tests/material/material_time_temperature.pf"
#line 38 "/work/main/tests/material/material_time_temperature.pf"
  call assertEqual(1.0_dp, factor_at(law, 1.0e18_dp)/1.0e-8_dp, tolerance=power_eps, &
 & location=SourceLocation( &
 & 'material_time_temperature.pf', &
 & 38) )
  if (anyExceptions()) return
#line 39 "/work/main/tests/material/material_time_temperature.pf"
   end subroutine test_wlf

   ! Constants of another reference temperature, c2' = c2 + T0' - T0, c1' c2' = c1 c2, shift by the quotient of the factors.
   !@test
   subroutine test_other_reference()
      type(time_temperature_t) :: law, other
      real(dp) :: expected
      integer :: i

      law = time_temperature_t(law=shift_wlf, reference_temperature=298.0_dp, c1=5.0_dp, c2=110.0_dp)
      other = time_temperature_t(law=shift_wlf, reference_temperature=238.0_dp, c1=11.0_dp, c2=50.0_dp)
      do i = 200, 400, 10
         expected = factor_at(law, real(i, dp))/factor_at(law, 238.0_dp)
#line 52 "/work/main/tests/material/material_time_temperature.pf"
  call assertRelativelyEqual(expected, factor_at(other, real(i, dp)), tolerance=power_eps, &
 & location=SourceLocation( &
 & 'material_time_temperature.pf', &
 & 52) )
  if (anyExceptions()) return
#line 53 "/work/main/tests/material/material_time_temperature.pf"
      end do
   end subroutine test_other_reference

   ! Arrhenius: the slope of ln a_T over 1/T is Ea/R.
   !@test
   subroutine test_arrhenius()
      type(time_temperature_t) :: law

      law = time_temperature_t(law=shift_arrhenius, reference_temperature=300.0_dp, activation_energy=1.0e5_dp)
#line 62 "/work/main/tests/material/material_time_temperature.pf"
  call assertEqual(1.0_dp, factor_at(law, 300.0_dp), tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'material_time_temperature.pf', &
 & 62) )
  if (anyExceptions()) return
#line 63 "/work/main/tests/material/material_time_temperature.pf"
#line 63 "/work/main/tests/material/material_time_temperature.pf"
  call assertRelativelyEqual(exp(-1.0e5_dp/gas_constant/1200), factor_at(law, 400.0_dp), tolerance=power_eps, &
 & location=SourceLocation( &
 & 'material_time_temperature.pf', &
 & 63) )
  if (anyExceptions()) return
#line 64 "/work/main/tests/material/material_time_temperature.pf"
#line 64 "/work/main/tests/material/material_time_temperature.pf"
  call assertRelativelyEqual(exp(1.0e5_dp/gas_constant/600), factor_at(law, 200.0_dp), tolerance=power_eps, &
 & location=SourceLocation( &
 & 'material_time_temperature.pf', &
 & 64) )
  if (anyExceptions()) return
#line 65 "/work/main/tests/material/material_time_temperature.pf"
   end subroutine test_arrhenius

   ! Where the laws end: below the pole of WLF, at no temperature, and where the factor is no number.
   !@test
   subroutine test_refused()
      type(time_temperature_t) :: wlf, arrhenius

      wlf = time_temperature_t(law=shift_wlf, reference_temperature=300.0_dp, c1=10.0_dp, c2=100.0_dp)
      arrhenius = time_temperature_t(law=shift_arrhenius, reference_temperature=300.0_dp, activation_energy=1.0e5_dp)
#line 74 "/work/main/tests/material/material_time_temperature.pf"
  call assertEqual([.true., .false., .false., .false.], is_valid_at(wlf, [205.0_dp, 204.0_dp, 200.0_dp, 150.0_dp]), &
 & location=SourceLocation( &
 & 'material_time_temperature.pf', &
 & 74) )
  if (anyExceptions()) return
#line 75 "/work/main/tests/material/material_time_temperature.pf"
#line 75 "/work/main/tests/material/material_time_temperature.pf"
  call assertEqual([.true., .false., .false.], is_valid_at(arrhenius, [25.0_dp, 20.0_dp, 1.0e-300_dp]), &
 & location=SourceLocation( &
 & 'material_time_temperature.pf', &
 & 75) )
  if (anyExceptions()) return
#line 76 "/work/main/tests/material/material_time_temperature.pf"
#line 76 "/work/main/tests/material/material_time_temperature.pf"
  call assertEqual([.false., .false.], is_valid_at(time_temperature_t(), [0.0_dp, -1.0_dp]), &
 & location=SourceLocation( &
 & 'material_time_temperature.pf', &
 & 76) )
  if (anyExceptions()) return
#line 77 "/work/main/tests/material/material_time_temperature.pf"
#line 77 "/work/main/tests/material/material_time_temperature.pf"
  call assertEqual([.false.], is_valid_at(arrhenius, [0.0_dp]), &
 & location=SourceLocation( &
 & 'material_time_temperature.pf', &
 & 77) )
  if (anyExceptions()) return
#line 78 "/work/main/tests/material/material_time_temperature.pf"

   contains

      ! Is the factor valid at temperatures? Where it is not, it is 1.
      function is_valid_at(law, temperatures) result(is_valid)
         type(time_temperature_t), intent(in) :: law
         real(dp), intent(in) :: temperatures(:)
         logical :: is_valid(size(temperatures))
         real(dp) :: factors(size(temperatures))

         call law%get_shift_factor(temperatures, factors, is_valid)
#line 89 "/work/main/tests/material/material_time_temperature.pf"
  call assertEqual(merge(1.0_dp, factors, .not. is_valid), factors, tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'material_time_temperature.pf', &
 & 89) )
  if (anyExceptions()) return
#line 90 "/work/main/tests/material/material_time_temperature.pf"
      end function is_valid_at
   end subroutine test_refused

end module material_time_temperature

module Wrapmaterial_time_temperature
   use FUnit
   use material_time_temperature
   implicit none
   private

contains


end module Wrapmaterial_time_temperature

function material_time_temperature_suite() result(suite)
   use FUnit
   use material_time_temperature
   use Wrapmaterial_time_temperature
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('material_time_temperature_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_none', &
      test_none))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_wlf', &
      test_wlf))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_other_reference', &
      test_other_reference))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_arrhenius', &
      test_arrhenius))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_refused', &
      test_refused))
   call suite%addTest(t)


end function material_time_temperature_suite


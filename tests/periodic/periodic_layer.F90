! The layer: its compliance over that of a half-space, and its limits.
module periodic_layer
   use, intrinsic :: iso_fortran_env, only: real128
   use adfric_base_kinds, only: dp
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_layer_kernel, only: layer_kernel_t, compliance_factor
   use funit
   implicit none (type, external)

   integer, parameter :: qp = real128

contains

   ! The printed formulas with 33 digits, of which their differences lose up to 27 where the layer is thin.
   !@test
   subroutine test_formulas()
      real(dp), parameter :: ratios(*) = [0.0_dp, 0.3_dp, 0.49_dp, 0.5_dp]
      real(qp) :: q, c, exact
      type(layer_kernel_t) :: layer
      integer :: i, k

      do i = -20, 12
         q = real(10.0_dp**(i/8.0_dp), qp)
         layer%is_bonded = .false.
         exact = 2*sinh(q)**2/(sinh(2*q) + 2*q)
#line 26 "/work/wt/penetration/tests/periodic/periodic_layer.pf"
  call assertRelativelyEqual(real(exact, dp), compliance_factor(layer, real(q, dp)), tolerance=1.0e-14_dp, &
 & location=SourceLocation( &
 & 'periodic_layer.pf', &
 & 26) )
  if (anyExceptions()) return
#line 27 "/work/wt/penetration/tests/periodic/periodic_layer.pf"
         layer%is_bonded = .true.
         do k = 1, size(ratios)
            layer%poisson_ratio = ratios(k)
            c = 3 - 4*real(ratios(k), qp)
            exact = (2*c*sinh(2*q) - 4*q)/(2*c*cosh(2*q) + 4*q**2 + 1 + c**2)
#line 32 "/work/wt/penetration/tests/periodic/periodic_layer.pf"
  call assertRelativelyEqual(real(exact, dp), compliance_factor(layer, real(q, dp)), tolerance=1.0e-13_dp, &
 & location=SourceLocation( &
 & 'periodic_layer.pf', &
 & 32) )
  if (anyExceptions()) return
#line 33 "/work/wt/penetration/tests/periodic/periodic_layer.pf"
         end do
      end do
   end subroutine test_formulas

   ! Thin layers are springs, but one that cannot change its volume; thick ones are a half-space.
   !@test
   subroutine test_limits()
      real(dp), parameter :: thin = 1.0e-6_dp
      type(layer_kernel_t) :: layer

      layer%thickness = 3
#line 44 "/work/wt/penetration/tests/periodic/periodic_layer.pf"
  call assertRelativelyEqual(thin/2, compliance_factor(layer, thin), tolerance=1.0e-11_dp, &
 & location=SourceLocation( &
 & 'periodic_layer.pf', &
 & 44) )
  if (anyExceptions()) return
#line 45 "/work/wt/penetration/tests/periodic/periodic_layer.pf"
#line 45 "/work/wt/penetration/tests/periodic/periodic_layer.pf"
  call assertEqual(3.0_dp, layer%mean_compliance(), &
 & location=SourceLocation( &
 & 'periodic_layer.pf', &
 & 45) )
  if (anyExceptions()) return
#line 46 "/work/wt/penetration/tests/periodic/periodic_layer.pf"
#line 46 "/work/wt/penetration/tests/periodic/periodic_layer.pf"
  call assertEqual(1.0_dp, compliance_factor(layer, 1.0e6_dp), &
 & location=SourceLocation( &
 & 'periodic_layer.pf', &
 & 46) )
  if (anyExceptions()) return
#line 47 "/work/wt/penetration/tests/periodic/periodic_layer.pf"
#line 47 "/work/wt/penetration/tests/periodic/periodic_layer.pf"
  call assertRelativelyEqual(1.0_dp, compliance_factor(layer, 21.999_dp), tolerance=1.0e-14_dp, &
 & location=SourceLocation( &
 & 'periodic_layer.pf', &
 & 47) )
  if (anyExceptions()) return
#line 48 "/work/wt/penetration/tests/periodic/periodic_layer.pf"
      layer%is_bonded = .true.
      layer%poisson_ratio = 0.3_dp
#line 50 "/work/wt/penetration/tests/periodic/periodic_layer.pf"
  call assertRelativelyEqual(layer%mean_compliance()/3*thin/2, compliance_factor(layer, thin), tolerance=1.0e-11_dp, &
 & location=SourceLocation( &
 & 'periodic_layer.pf', &
 & 50) )
  if (anyExceptions()) return
#line 51 "/work/wt/penetration/tests/periodic/periodic_layer.pf"
#line 51 "/work/wt/penetration/tests/periodic/periodic_layer.pf"
  call assertRelativelyEqual(1.0_dp, compliance_factor(layer, 21.999_dp), tolerance=1.0e-14_dp, &
 & location=SourceLocation( &
 & 'periodic_layer.pf', &
 & 51) )
  if (anyExceptions()) return
#line 52 "/work/wt/penetration/tests/periodic/periodic_layer.pf"
      layer%poisson_ratio = 0.5_dp
#line 53 "/work/wt/penetration/tests/periodic/periodic_layer.pf"
  call assertRelativelyEqual(2*thin**3/3, compliance_factor(layer, thin), tolerance=1.0e-11_dp, &
 & location=SourceLocation( &
 & 'periodic_layer.pf', &
 & 53) )
  if (anyExceptions()) return
#line 54 "/work/wt/penetration/tests/periodic/periodic_layer.pf"
#line 54 "/work/wt/penetration/tests/periodic/periodic_layer.pf"
  call assertEqual(0.0_dp, layer%mean_compliance(), &
 & location=SourceLocation( &
 & 'periodic_layer.pf', &
 & 54) )
  if (anyExceptions()) return
#line 55 "/work/wt/penetration/tests/periodic/periodic_layer.pf"
   end subroutine test_limits

   ! Waves shorter than a thick layer meet a half-space in every direction.
   !@test
   subroutine test_thick()
      type(layer_kernel_t) :: layer
      type(elastic_kernel_t) :: half_space
      complex(dp) :: one(3, 2), other(3, 2)

      layer%thickness = 10
      call layer%get_stiffness([0.0_dp, 1.0_dp], [0.0_dp, 2.0_dp, -3.0_dp], [0.1_dp, 0.1_dp], one)
      call half_space%get_stiffness([0.0_dp, 1.0_dp], [0.0_dp, 2.0_dp, -3.0_dp], [0.1_dp, 0.1_dp], other)
#line 67 "/work/wt/penetration/tests/periodic/periodic_layer.pf"
  call assertEqual(0.0_dp, maxval(abs(one - other)), tolerance=1.0e-13_dp, &
 & location=SourceLocation( &
 & 'periodic_layer.pf', &
 & 67) )
  if (anyExceptions()) return
#line 68 "/work/wt/penetration/tests/periodic/periodic_layer.pf"
   end subroutine test_thick

end module periodic_layer

module Wrapperiodic_layer
   use FUnit
   use periodic_layer
   implicit none
   private

contains


end module Wrapperiodic_layer

function periodic_layer_suite() result(suite)
   use FUnit
   use periodic_layer
   use Wrapperiodic_layer
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('periodic_layer_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_formulas', &
      test_formulas))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_limits', &
      test_limits))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_thick', &
      test_thick))
   call suite%addTest(t)


end function periodic_layer_suite


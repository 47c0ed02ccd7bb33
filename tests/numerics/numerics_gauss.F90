! SPDX-License-Identifier: GPL-3.0-or-later
! Quadrature rules and functions of the C library.
module numerics_gauss
   use adfric_base_kinds, only: dp
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights, gauss_nodes_10, gauss_weights_10
   use adfric_numerics_patterson, only: n_levels, n_half, rule_nodes, rule_weights, first_stride
   use adfric_numerics_libm, only: expm1, log1p
   use funit
   implicit none (type, external)

   real(dp), parameter :: round_off = 10*epsilon(1.0_dp)

contains

   !> A rule is exact for all Legendre polynomials up to an odd degree, and not for the even one that follows.
   subroutine check_rule(nodes, weights, degree)
      real(dp), intent(in) :: nodes(:), weights(:)
      integer, intent(in) :: degree
      real(dp) :: before(size(nodes)), this(size(nodes)), next(size(nodes))
      integer :: k
      character(20) :: label

      before = 0
      this = 1
      do k = 0, degree
         write (label, '(a, i4)') 'polynomial', k
#line 27 "/work/main/tests/numerics/numerics_gauss.pf"
  call assertEqual(merge(2.0_dp, 0.0_dp, k == 0), sum(weights*this), tolerance=round_off, message=label, &
 & location=SourceLocation( &
 & 'numerics_gauss.pf', &
 & 27) )
  if (anyExceptions()) return
#line 28 "/work/main/tests/numerics/numerics_gauss.pf"
         next = ((2*k + 1)*nodes*this - k*before)/(k + 1)
         before = this
         this = next
      end do
#line 32 "/work/main/tests/numerics/numerics_gauss.pf"
  call assertGreaterThan(abs(sum(weights*this)), 1000*round_off, &
 & location=SourceLocation( &
 & 'numerics_gauss.pf', &
 & 32) )
  if (anyExceptions()) return
#line 33 "/work/main/tests/numerics/numerics_gauss.pf"
   end subroutine check_rule

   !@test
   subroutine test_gauss()
      call check_rule(gauss_nodes, gauss_weights, 31)
      call check_rule(gauss_nodes_10, gauss_weights_10, 19)
   end subroutine test_gauss

   ! Each nested rule of n points, from Kronrod's on, is exact to the degree (3n + 1)/2; that and the nodes which it shares
   ! with the one before leave no freedom.
   !@test
   subroutine test_patterson()
      integer, parameter :: degrees(0:n_levels) = [1, 9, 17, 35, 71]
      real(dp) :: nodes(-n_half:n_half), weights(-n_half:n_half)
      integer :: level

      nodes = [-rule_nodes(n_half:1:-1), rule_nodes]
      do level = 0, n_levels
         weights = [rule_weights(n_half:1:-1, level), rule_weights(:, level)]
         call check_rule(nodes, weights, degrees(level))
      end do
   end subroutine test_patterson

   ! Each rule has every second node of the next.
   !@test
   subroutine test_patterson_is_nested()
      integer :: level, stride, j

      stride = first_stride
      do level = 1, n_levels
         do j = 0, n_half
#line 64 "/work/main/tests/numerics/numerics_gauss.pf"
  call assertTrue(rule_weights(j, level) > 0 .eqv. mod(j, stride) == 0, &
 & location=SourceLocation( &
 & 'numerics_gauss.pf', &
 & 64) )
  if (anyExceptions()) return
#line 65 "/work/main/tests/numerics/numerics_gauss.pf"
         end do
         stride = stride/2
      end do
#line 68 "/work/main/tests/numerics/numerics_gauss.pf"
  call assertEqual(0, stride, &
 & location=SourceLocation( &
 & 'numerics_gauss.pf', &
 & 68) )
  if (anyExceptions()) return
#line 69 "/work/main/tests/numerics/numerics_gauss.pf"
#line 69 "/work/main/tests/numerics/numerics_gauss.pf"
  call assertTrue(all(rule_nodes(1:) > rule_nodes(:n_half - 1)) .and. rule_nodes(n_half) < 1, &
 & location=SourceLocation( &
 & 'numerics_gauss.pf', &
 & 69) )
  if (anyExceptions()) return
#line 70 "/work/main/tests/numerics/numerics_gauss.pf"
#line 70 "/work/main/tests/numerics/numerics_gauss.pf"
  call assertEqual(0.0_dp, rule_nodes(0), &
 & location=SourceLocation( &
 & 'numerics_gauss.pf', &
 & 70) )
  if (anyExceptions()) return
#line 71 "/work/main/tests/numerics/numerics_gauss.pf"
   end subroutine test_patterson_is_nested

   !@test
   subroutine test_symmetry()
#line 75 "/work/main/tests/numerics/numerics_gauss.pf"
  call assertEqual(-gauss_nodes, gauss_nodes(16:1:-1), &
 & location=SourceLocation( &
 & 'numerics_gauss.pf', &
 & 75) )
  if (anyExceptions()) return
#line 76 "/work/main/tests/numerics/numerics_gauss.pf"
#line 76 "/work/main/tests/numerics/numerics_gauss.pf"
  call assertEqual(gauss_weights, gauss_weights(16:1:-1), &
 & location=SourceLocation( &
 & 'numerics_gauss.pf', &
 & 76) )
  if (anyExceptions()) return
#line 77 "/work/main/tests/numerics/numerics_gauss.pf"
#line 77 "/work/main/tests/numerics/numerics_gauss.pf"
  call assertTrue(all(gauss_weights > 0), &
 & location=SourceLocation( &
 & 'numerics_gauss.pf', &
 & 77) )
  if (anyExceptions()) return
#line 78 "/work/main/tests/numerics/numerics_gauss.pf"
   end subroutine test_symmetry

   ! A smooth function to round-off.
   !@test
   subroutine test_exponential()
      real(dp) :: exact, actual

      exact = exp(1.0_dp) - exp(-1.0_dp)
#line 86 "/work/main/tests/numerics/numerics_gauss.pf"
  call assertRelativelyEqual(exact, sum(gauss_weights*exp(gauss_nodes)), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_gauss.pf', &
 & 86) )
  if (anyExceptions()) return
#line 87 "/work/main/tests/numerics/numerics_gauss.pf"
      actual = rule_weights(0, 3) + 2*sum(rule_weights(1:, 3)*cosh(rule_nodes(1:)))
#line 88 "/work/main/tests/numerics/numerics_gauss.pf"
  call assertRelativelyEqual(exact, actual, tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_gauss.pf', &
 & 88) )
  if (anyExceptions()) return
#line 89 "/work/main/tests/numerics/numerics_gauss.pf"
   end subroutine test_exponential

   !@test
   subroutine test_log1p()
#line 93 "/work/main/tests/numerics/numerics_gauss.pf"
  call assertEqual(log(3.0_dp), log1p(2.0_dp), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_gauss.pf', &
 & 93) )
  if (anyExceptions()) return
#line 94 "/work/main/tests/numerics/numerics_gauss.pf"
#line 94 "/work/main/tests/numerics/numerics_gauss.pf"
  call assertEqual(1.0e-20_dp, log1p(1.0e-20_dp), tolerance=1.0e-35_dp, &
 & location=SourceLocation( &
 & 'numerics_gauss.pf', &
 & 94) )
  if (anyExceptions()) return
#line 95 "/work/main/tests/numerics/numerics_gauss.pf"
#line 95 "/work/main/tests/numerics/numerics_gauss.pf"
  call assertRelativelyEqual(-1.0e-8_dp - 0.5e-16_dp, log1p(-1.0e-8_dp), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_gauss.pf', &
 & 95) )
  if (anyExceptions()) return
#line 96 "/work/main/tests/numerics/numerics_gauss.pf"
   end subroutine test_log1p

   !@test
   subroutine test_expm1()
#line 100 "/work/main/tests/numerics/numerics_gauss.pf"
  call assertEqual(0.0_dp, expm1(0.0_dp), &
 & location=SourceLocation( &
 & 'numerics_gauss.pf', &
 & 100) )
  if (anyExceptions()) return
#line 101 "/work/main/tests/numerics/numerics_gauss.pf"
#line 101 "/work/main/tests/numerics/numerics_gauss.pf"
  call assertRelativelyEqual(1.0e-20_dp, expm1(1.0e-20_dp), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_gauss.pf', &
 & 101) )
  if (anyExceptions()) return
#line 102 "/work/main/tests/numerics/numerics_gauss.pf"
#line 102 "/work/main/tests/numerics/numerics_gauss.pf"
  call assertRelativelyEqual(exp(1.0_dp) - 1, expm1(1.0_dp), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_gauss.pf', &
 & 102) )
  if (anyExceptions()) return
#line 103 "/work/main/tests/numerics/numerics_gauss.pf"
#line 103 "/work/main/tests/numerics/numerics_gauss.pf"
  call assertEqual(-1.0_dp, expm1(-800.0_dp), &
 & location=SourceLocation( &
 & 'numerics_gauss.pf', &
 & 103) )
  if (anyExceptions()) return
#line 104 "/work/main/tests/numerics/numerics_gauss.pf"
   end subroutine test_expm1

end module numerics_gauss

module Wrapnumerics_gauss
   use FUnit
   use numerics_gauss
   implicit none
   private

contains


end module Wrapnumerics_gauss

function numerics_gauss_suite() result(suite)
   use FUnit
   use numerics_gauss
   use Wrapnumerics_gauss
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('numerics_gauss_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_gauss', &
      test_gauss))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_patterson', &
      test_patterson))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_patterson_is_nested', &
      test_patterson_is_nested))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_symmetry', &
      test_symmetry))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_exponential', &
      test_exponential))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_log1p', &
      test_log1p))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_expm1', &
      test_expm1))
   call suite%addTest(t)


end function numerics_gauss_suite


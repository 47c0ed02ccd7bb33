! SPDX-License-Identifier: GPL-3.0-or-later
! Jacobi's elliptic functions from the quarter period downwards.
module numerics_jacobi_nodes
   use adfric_base_kinds, only: dp
   use adfric_numerics_jacobi_nodes, only: halve_argument, put_midpoints
   use funit
   implicit none (type, external)

   real(dp), parameter :: round_off = 50*epsilon(1.0_dp)

contains

   ! sn(K/2) = 1/sqrt(1 + k'), cn(K/2) = sqrt(k'/(1 + k')), dn(K/2) = sqrt(k') (DLMF 22.5.9), for k' down to nearly 0.
   !@test
   subroutine test_half_of_quarter_period()
      real(dp) :: values(3), other
      integer :: i

      do i = 0, 140, 10
         other = 10.0_dp**(-i)
         values = [1.0_dp, 0.0_dp, other]
         call halve_argument(values)
#line 23 "/work/main/tests/numerics/numerics_jacobi_nodes.pf"
  call assertRelativelyEqual(1/sqrt(1 + other), values(1), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_jacobi_nodes.pf', &
 & 23) )
  if (anyExceptions()) return
#line 24 "/work/main/tests/numerics/numerics_jacobi_nodes.pf"
#line 24 "/work/main/tests/numerics/numerics_jacobi_nodes.pf"
  call assertRelativelyEqual(sqrt(other/(1 + other)), values(2), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_jacobi_nodes.pf', &
 & 24) )
  if (anyExceptions()) return
#line 25 "/work/main/tests/numerics/numerics_jacobi_nodes.pf"
#line 25 "/work/main/tests/numerics/numerics_jacobi_nodes.pf"
  call assertRelativelyEqual(sqrt(other), values(3), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_jacobi_nodes.pf', &
 & 25) )
  if (anyExceptions()) return
#line 26 "/work/main/tests/numerics/numerics_jacobi_nodes.pf"
      end do
   end subroutine test_half_of_quarter_period

   ! Without modulus they are sine, cosine and 1.
   !@test
   subroutine test_circle()
      real(dp), parameter :: angle = 0.7_dp
      real(dp) :: nodes(3, 0:1), step(3), midpoints(3, 1)

      nodes(:, 0) = [0.0_dp, 1.0_dp, 1.0_dp]
      nodes(:, 1) = [sin(angle), cos(angle), 1.0_dp]
      step = nodes(:, 1)
      call halve_argument(step)
#line 39 "/work/main/tests/numerics/numerics_jacobi_nodes.pf"
  call assertRelativelyEqual(sin(angle/2), step(1), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_jacobi_nodes.pf', &
 & 39) )
  if (anyExceptions()) return
#line 40 "/work/main/tests/numerics/numerics_jacobi_nodes.pf"
      call put_midpoints(0.0_dp, step, nodes, midpoints)
#line 41 "/work/main/tests/numerics/numerics_jacobi_nodes.pf"
  call assertEqual([sin(angle/2), cos(angle/2), 1.0_dp], midpoints(:, 1), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_jacobi_nodes.pf', &
 & 41) )
  if (anyExceptions()) return
#line 42 "/work/main/tests/numerics/numerics_jacobi_nodes.pf"
   end subroutine test_circle

   ! sn^2 + cn^2 = 1, dn^2 + k^2 sn^2 = 1, and sn(K - v) = cn(v)/dn(v), cn(K - v) = k' sn(v)/dn(v): also where cn and dn are tiny.
   !@test
   subroutine test_grids()
      integer, parameter :: n_levels = 8
      real(dp) :: nodes(3, 0:2**n_levels), midpoints(3, 2**n_levels), step(3), other
      integer :: i, level, n

      do i = 0, 100, 20
         other = 0.3_dp*10.0_dp**(-i)
         nodes(:, 0) = [0.0_dp, 1.0_dp, 1.0_dp]
         nodes(:, 1) = [1.0_dp, 0.0_dp, other]
         step = nodes(:, 1)
         n = 1
         do level = 1, n_levels
            call halve_argument(step)
            call put_midpoints((1 - other)*(1 + other), step, nodes(:, 0:n), midpoints(:, :n))
            nodes(:, 0:2*n:2) = nodes(:, 0:n)
            nodes(:, 1:2*n:2) = midpoints(:, :n)
            n = 2*n
         end do
#line 64 "/work/main/tests/numerics/numerics_jacobi_nodes.pf"
  call assertEqual(1.0_dp, nodes(1, :)**2 + nodes(2, :)**2, tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_jacobi_nodes.pf', &
 & 64) )
  if (anyExceptions()) return
#line 65 "/work/main/tests/numerics/numerics_jacobi_nodes.pf"
#line 65 "/work/main/tests/numerics/numerics_jacobi_nodes.pf"
  call assertEqual(1.0_dp, nodes(3, :)**2 + (1 - other**2)*nodes(1, :)**2, tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_jacobi_nodes.pf', &
 & 65) )
  if (anyExceptions()) return
#line 66 "/work/main/tests/numerics/numerics_jacobi_nodes.pf"
         do level = 1, n - 1
#line 67 "/work/main/tests/numerics/numerics_jacobi_nodes.pf"
  call assertRelativelyEqual(nodes(2, level)/nodes(3, level), nodes(1, n - level), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_jacobi_nodes.pf', &
 & 67) )
  if (anyExceptions()) return
#line 68 "/work/main/tests/numerics/numerics_jacobi_nodes.pf"
#line 68 "/work/main/tests/numerics/numerics_jacobi_nodes.pf"
  call assertRelativelyEqual(other*nodes(1, level)/nodes(3, level), nodes(2, n - level), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_jacobi_nodes.pf', &
 & 68) )
  if (anyExceptions()) return
#line 69 "/work/main/tests/numerics/numerics_jacobi_nodes.pf"
         end do
      end do
   end subroutine test_grids

end module numerics_jacobi_nodes

module Wrapnumerics_jacobi_nodes
   use FUnit
   use numerics_jacobi_nodes
   implicit none
   private

contains


end module Wrapnumerics_jacobi_nodes

function numerics_jacobi_nodes_suite() result(suite)
   use FUnit
   use numerics_jacobi_nodes
   use Wrapnumerics_jacobi_nodes
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('numerics_jacobi_nodes_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_half_of_quarter_period', &
      test_half_of_quarter_period))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_circle', &
      test_circle))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_grids', &
      test_grids))
   call suite%addTest(t)


end function numerics_jacobi_nodes_suite


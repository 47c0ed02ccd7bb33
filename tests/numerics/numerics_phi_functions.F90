! SPDX-License-Identifier: GPL-3.0-or-later
module numerics_phi_functions
   use adfric_base_kinds, only: dp
   use adfric_numerics_phi_functions, only: get_phi_functions, get_exponential_moments
   use quad_phi, only: qp, quad_phi_function, quad_moment
   use funit
   implicit none (type, external)

   !> A few round-offs.
   real(dp), parameter :: few_round_offs = 8*epsilon(1.0_dp)
   !> What a piece of the highest degree needs, and more.
   integer, parameter :: most = 11
   !> Numbers below it have lost digits.
   real(dp), parameter :: smallest = tiny(1.0_dp)/epsilon(1.0_dp)

contains

   ! From the smallest to the largest numbers, and densely around the places where recurrences are turned round.
   !@test
   subroutine test_all_magnitudes()
      integer :: k

      do k = -600, 600
         call check_all(10.0_dp**(0.5_dp*k))
         if (anyExceptions()) return
      end do
   end subroutine test_all_magnitudes

   !@test
   subroutine test_turning_places()
      integer :: k

      do k = 1, 750
         call check_all(0.02_dp*k)
         if (anyExceptions()) return
      end do
      do k = 1, 14
         call check_all(nearest(real(k, dp), -1.0_dp))
         call check_all(nearest(real(k, dp), 1.0_dp))
         if (anyExceptions()) return
      end do
   end subroutine test_turning_places

   ! Any number of functions is asked for, so that each is the last one once.
   subroutine check_all(z)
      real(dp), intent(in) :: z
      real(dp) :: phi(most), chi(0:most)
      integer :: n

      do n = 1, most
         call get_phi_functions(z, phi(:n))
         call check_phi(z, phi(:n))
         call get_exponential_moments(z, chi(0:n - 1))
         call check_moments(z, chi(0:n - 1))
         if (anyExceptions()) return
      end do
   end subroutine check_all

   subroutine check_phi(z, phi)
      real(dp), intent(in) :: z, phi(:)
      character(60) :: label
      real(dp) :: expected
      integer :: k

      do k = 1, size(phi)
         expected = real(quad_phi_function(k, real(z, qp)), dp)
         write (label, '(a, i0, a, i0, a, es24.16)') 'phi_', k, ' of ', size(phi), ' at', z
#line 68 "/work/main/tests/numerics/numerics_phi_functions.pf"
  call assertRelativelyEqual(expected, phi(k), tolerance=few_round_offs, message=label, &
 & location=SourceLocation( &
 & 'numerics_phi_functions.pf', &
 & 68) )
  if (anyExceptions()) return
#line 69 "/work/main/tests/numerics/numerics_phi_functions.pf"
      end do
   end subroutine check_phi

   subroutine check_moments(z, chi)
      real(dp), intent(in) :: z, chi(0:)
      character(60) :: label
      real(dp) :: expected
      integer :: j

      do j = 0, ubound(chi, 1)
         expected = real(quad_moment(j, real(z, qp)), dp)
         write (label, '(a, i0, a, i0, a, es24.16)') 'chi_', j, ' of ', ubound(chi, 1), ' at', z
         if (expected > smallest) then
#line 82 "/work/main/tests/numerics/numerics_phi_functions.pf"
  call assertRelativelyEqual(expected, chi(j), tolerance=few_round_offs, message=label, &
 & location=SourceLocation( &
 & 'numerics_phi_functions.pf', &
 & 82) )
  if (anyExceptions()) return
#line 83 "/work/main/tests/numerics/numerics_phi_functions.pf"
         else
#line 84 "/work/main/tests/numerics/numerics_phi_functions.pf"
  call assertEqual(expected, chi(j), tolerance=smallest, message=label, &
 & location=SourceLocation( &
 & 'numerics_phi_functions.pf', &
 & 84) )
  if (anyExceptions()) return
#line 85 "/work/main/tests/numerics/numerics_phi_functions.pf"
#line 85 "/work/main/tests/numerics/numerics_phi_functions.pf"
  call assertGreaterThanOrEqual(chi(j), 0.0_dp, message=label, &
 & location=SourceLocation( &
 & 'numerics_phi_functions.pf', &
 & 85) )
  if (anyExceptions()) return
#line 86 "/work/main/tests/numerics/numerics_phi_functions.pf"
         end if
      end do
   end subroutine check_moments

   !@test
   subroutine test_no_step()
      real(dp) :: phi(4), chi(0:3)

      call get_phi_functions(0.0_dp, phi)
#line 95 "/work/main/tests/numerics/numerics_phi_functions.pf"
  call assertEqual(1/[1.0_dp, 2.0_dp, 6.0_dp, 24.0_dp], phi, tolerance=epsilon(1.0_dp), &
 & location=SourceLocation( &
 & 'numerics_phi_functions.pf', &
 & 95) )
  if (anyExceptions()) return
#line 96 "/work/main/tests/numerics/numerics_phi_functions.pf"
      call get_exponential_moments(0.0_dp, chi)
#line 97 "/work/main/tests/numerics/numerics_phi_functions.pf"
  call assertEqual(1/[1.0_dp, 2.0_dp, 3.0_dp, 4.0_dp], chi, tolerance=epsilon(1.0_dp), &
 & location=SourceLocation( &
 & 'numerics_phi_functions.pf', &
 & 97) )
  if (anyExceptions()) return
#line 98 "/work/main/tests/numerics/numerics_phi_functions.pf"
   end subroutine test_no_step

end module numerics_phi_functions

module Wrapnumerics_phi_functions
   use FUnit
   use numerics_phi_functions
   implicit none
   private

contains


end module Wrapnumerics_phi_functions

function numerics_phi_functions_suite() result(suite)
   use FUnit
   use numerics_phi_functions
   use Wrapnumerics_phi_functions
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('numerics_phi_functions_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_all_magnitudes', &
      test_all_magnitudes))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_turning_places', &
      test_turning_places))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_no_step', &
      test_no_step))
   call suite%addTest(t)


end function numerics_phi_functions_suite


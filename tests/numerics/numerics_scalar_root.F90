! SPDX-License-Identifier: GPL-3.0-or-later
! The scalar root: found to round-off, always inside its bracket.
module numerics_scalar_root
   use adfric_base_kinds, only: dp
   use adfric_numerics_scalar_root, only: find_root
   use trial_equations, only: trial_equation_t, cubic, steep, flat, straight, wrong_slope, no_number
   use funit
   implicit none (type, external)

   real(dp), parameter :: round_off = 4*epsilon(1.0_dp)

contains

   !> A root from several first guesses, inside and outside the bracket.
   subroutine check_root(kind, low, high, rises, root, margin)
      integer, intent(in) :: kind
      real(dp), intent(in) :: low, high
      logical, intent(in) :: rises
      real(dp), intent(in) :: root, margin
      type(trial_equation_t) :: equation
      real(dp) :: x, guesses(5)
      logical :: is_converged
      integer :: k
      character(40) :: label

      equation = trial_equation_t(kind)
      guesses = [low - 1, low + 0.001_dp*(high - low), (low + high)/2, high - 0.001_dp*(high - low), high + 1]
      do k = 1, size(guesses)
         x = guesses(k)
         write (label, '(a, 2i4)') 'equation, guess', kind, k
         call find_root(equation, low, high, rises, x, is_converged)
#line 32 "/work/main/tests/numerics/numerics_scalar_root.pf"
  call assertTrue(is_converged, message=label, &
 & location=SourceLocation( &
 & 'numerics_scalar_root.pf', &
 & 32) )
  if (anyExceptions()) return
#line 33 "/work/main/tests/numerics/numerics_scalar_root.pf"
#line 33 "/work/main/tests/numerics/numerics_scalar_root.pf"
  call assertEqual(root, x, tolerance=margin, message=label, &
 & location=SourceLocation( &
 & 'numerics_scalar_root.pf', &
 & 33) )
  if (anyExceptions()) return
#line 34 "/work/main/tests/numerics/numerics_scalar_root.pf"
      end do
   end subroutine check_root

   !@test
   subroutine test_smooth()
      call check_root(cubic, 0.0_dp, 5.0_dp, .true., 2.0_dp**(1.0_dp/3), round_off)
      call check_root(cubic, -3.0_dp, 100.0_dp, .true., 2.0_dp**(1.0_dp/3), round_off)
   end subroutine test_smooth

   !@test
   subroutine test_falling()
      call check_root(straight, -1.0_dp, 1.0_dp, .false., 0.25_dp, round_off)
   end subroutine test_falling

   ! Newton's method alone would leave the bracket at once.
   !@test
   subroutine test_steep()
      call check_root(steep, -1.0_dp, 2.0_dp, .true., 0.3_dp, round_off)
   end subroutine test_steep

   ! A root of the fifth order: steps are a fifth of the distance, and end below 1e-9 of that to the ends.
   !@test
   subroutine test_flat()
      call check_root(flat, -1.0_dp, 2.0_dp, .true., 0.5_dp, 1.0e-8_dp)
   end subroutine test_flat

   ! Even a slope of the wrong sign only costs time.
   !@test
   subroutine test_wrong_slope()
      call check_root(wrong_slope, -1.0_dp, 2.0_dp, .true., 2.0_dp**(1.0_dp/3), 2*round_off)
   end subroutine test_wrong_slope

   !@test
   subroutine test_no_number()
      type(trial_equation_t) :: equation
      real(dp) :: x
      logical :: is_converged

      equation = trial_equation_t(no_number)
      x = 0.5_dp
      call find_root(equation, 0.0_dp, 1.0_dp, .true., x, is_converged)
#line 75 "/work/main/tests/numerics/numerics_scalar_root.pf"
  call assertFalse(is_converged, &
 & location=SourceLocation( &
 & 'numerics_scalar_root.pf', &
 & 75) )
  if (anyExceptions()) return
#line 76 "/work/main/tests/numerics/numerics_scalar_root.pf"
   end subroutine test_no_number

   ! A root close to an end keeps its own digits, not only those of the bracket.
   !@test
   subroutine test_near_the_end()
      type(trial_equation_t) :: equation
      real(dp) :: x
      logical :: is_converged
      real(dp), parameter :: root = 1.0e-30_dp

      equation = trial_equation_t(straight, root)
      x = 0.5_dp
      call find_root(equation, 0.0_dp, 1.0_dp, .false., x, is_converged)
#line 89 "/work/main/tests/numerics/numerics_scalar_root.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'numerics_scalar_root.pf', &
 & 89) )
  if (anyExceptions()) return
#line 90 "/work/main/tests/numerics/numerics_scalar_root.pf"
#line 90 "/work/main/tests/numerics/numerics_scalar_root.pf"
  call assertRelativelyEqual(root, x, tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_scalar_root.pf', &
 & 90) )
  if (anyExceptions()) return
#line 91 "/work/main/tests/numerics/numerics_scalar_root.pf"
   end subroutine test_near_the_end

end module numerics_scalar_root

module Wrapnumerics_scalar_root
   use FUnit
   use numerics_scalar_root
   implicit none
   private

contains


end module Wrapnumerics_scalar_root

function numerics_scalar_root_suite() result(suite)
   use FUnit
   use numerics_scalar_root
   use Wrapnumerics_scalar_root
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('numerics_scalar_root_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_smooth', &
      test_smooth))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_falling', &
      test_falling))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_steep', &
      test_steep))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_flat', &
      test_flat))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_wrong_slope', &
      test_wrong_slope))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_no_number', &
      test_no_number))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_near_the_end', &
      test_near_the_end))
   call suite%addTest(t)


end function numerics_scalar_root_suite


! The approximate inverse of the stiffness, the interpolation it is made of, and sums over maps.
module periodic_levels
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_material_prony, only: prony_t, new_prony
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_kernel, only: kernel_t
   use adfric_periodic_levels, only: levels_t, new_levels
   use adfric_periodic_maps, only: add_multiple, dot_of, sum_of
   use adfric_periodic_operator, only: periodic_operator_t, new_periodic_operator
   use adfric_periodic_sliding_kernel, only: sliding_kernel_t, new_sliding_kernel
   use adfric_periodic_transfer, only: gather_line, spread_line
   use funit
   implicit none (type, external)

   real(dp), parameter :: round_off = 1.0e-13_dp

contains

   !> A line there and back is one matrix and its transpose: (gather f).c = f.(spread c).
   subroutine check_transpose(n_fine, n_coarse, is_quarter)
      integer, intent(in) :: n_fine, n_coarse
      logical, intent(in) :: is_quarter
      real(dp) :: fine(0:n_fine + 2), coarse(0:n_coarse + 1), gathered(n_coarse), spread_out(n_fine)
      real(dp) :: f(n_fine), c(n_coarse)

      call random_number(f)
      call random_number(c)
      fine = 0
      coarse = 0
      fine(1:n_fine) = f
      coarse(1:n_coarse) = c
      call gather_line(fine, n_coarse < n_fine, is_quarter, gathered)
      call spread_line(coarse, n_coarse < n_fine, is_quarter, spread_out)
#line 35 "/work/wt/penetration/tests/periodic/periodic_levels.pf"
  call assertRelativelyEqual(dot_product(gathered, c), dot_product(f, spread_out), tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_levels.pf', &
 & 35) )
  if (anyExceptions()) return
#line 36 "/work/wt/penetration/tests/periodic/periodic_levels.pf"
   end subroutine check_transpose

   !@test
   subroutine test_transpose()
      logical, parameter :: is_quarter(2) = [.false., .true.]
      integer :: k

      do k = 1, 2
         call check_transpose(16, 8, is_quarter(k))
         call check_transpose(15, 8, is_quarter(k))
         call check_transpose(5, 3, is_quarter(k))
         call check_transpose(6, 6, is_quarter(k))
      end do
   end subroutine test_transpose

   ! A straight line is interpolated as it is, but at the ends.
   !@test
   subroutine test_straight_line()
      real(dp) :: coarse(0:9), fine(16)
      integer :: i

      coarse = [(real(i, dp), i=0, 9)]
      call spread_line(coarse, .true., .false., fine)
#line 59 "/work/wt/penetration/tests/periodic/periodic_levels.pf"
  call assertEqual([(i/2.0_dp + 0.25_dp, i=2, 15)], fine(2:15), tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_levels.pf', &
 & 59) )
  if (anyExceptions()) return
#line 60 "/work/wt/penetration/tests/periodic/periodic_levels.pf"
#line 60 "/work/wt/penetration/tests/periodic/periodic_levels.pf"
  call assertEqual(0.75_dp*1 + 0.25_dp*8, fine(1), tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_levels.pf', &
 & 60) )
  if (anyExceptions()) return
#line 61 "/work/wt/penetration/tests/periodic/periodic_levels.pf"
   end subroutine test_straight_line

   !> Symmetric, positive, nothing in closed cells, and the sums that come with it.
   subroutine check_inverse(kernel, n_cells, period, is_quarter)
      class(kernel_t), intent(in) :: kernel
      integer, intent(in) :: n_cells(2)
      real(dp), intent(in) :: period(2)
      logical, intent(in) :: is_quarter
      type(periodic_operator_t) :: operator
      type(error_t), allocatable :: error
      type(levels_t) :: levels
      real(dp), dimension(n_cells(1), n_cells(2)) :: a, b, dice, to_a, to_b
      logical :: is_open(n_cells(1), n_cells(2))
      real(dp) :: sums(2), unused(2)

      call new_periodic_operator(operator, kernel, n_cells, period, is_quarter, .false., error)
#line 77 "/work/wt/penetration/tests/periodic/periodic_levels.pf"
  call assertFalse(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_levels.pf', &
 & 77) )
  if (anyExceptions()) return
#line 78 "/work/wt/penetration/tests/periodic/periodic_levels.pf"
      call random_number(a)
      call random_number(b)
      call random_number(dice)
      is_open = dice < 0.7_dp
      call new_levels(levels, operator)
      call levels%set_open(is_open)
      call levels%apply(b, a, to_b, unused)
      call levels%apply(a, b, to_a, sums)
#line 86 "/work/wt/penetration/tests/periodic/periodic_levels.pf"
  call assertEqual(0, count(.not. is_open .and. abs(to_a) > 0), &
 & location=SourceLocation( &
 & 'periodic_levels.pf', &
 & 86) )
  if (anyExceptions()) return
#line 87 "/work/wt/penetration/tests/periodic/periodic_levels.pf"
#line 87 "/work/wt/penetration/tests/periodic/periodic_levels.pf"
  call assertRelativelyEqual(sum(to_a*b), sum(a*to_b), tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_levels.pf', &
 & 87) )
  if (anyExceptions()) return
#line 88 "/work/wt/penetration/tests/periodic/periodic_levels.pf"
#line 88 "/work/wt/penetration/tests/periodic/periodic_levels.pf"
  call assertRelativelyEqual(sum(to_a*a), sums(1), tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_levels.pf', &
 & 88) )
  if (anyExceptions()) return
#line 89 "/work/wt/penetration/tests/periodic/periodic_levels.pf"
#line 89 "/work/wt/penetration/tests/periodic/periodic_levels.pf"
  call assertRelativelyEqual(sum(to_a*b), sums(2), tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_levels.pf', &
 & 89) )
  if (anyExceptions()) return
#line 90 "/work/wt/penetration/tests/periodic/periodic_levels.pf"
      b = a - sum(a)/size(a)
      call levels%apply(b, a, to_b, sums)
#line 92 "/work/wt/penetration/tests/periodic/periodic_levels.pf"
  call assertGreaterThan(sums(1), 0.0_dp, &
 & location=SourceLocation( &
 & 'periodic_levels.pf', &
 & 92) )
  if (anyExceptions()) return
#line 93 "/work/wt/penetration/tests/periodic/periodic_levels.pf"
   end subroutine check_inverse

   !@test
   subroutine test_inverse()
      call check_inverse(elastic_kernel_t(), [32, 32], [1.0_dp, 1.0_dp], .false.)
      call check_inverse(elastic_kernel_t(), [31, 18], [1.0_dp, 0.7_dp], .false.)
      call check_inverse(elastic_kernel_t(), [31, 18], [1.0_dp, 0.7_dp], .true.)
      call check_inverse(elastic_kernel_t(), [20, 20], [1.0_dp, 300.0_dp], .false.)
      call check_inverse(elastic_kernel_t(), [77, 1], [1.0_dp, 1.0_dp], .false.)
      call check_inverse(elastic_kernel_t(), [400, 380], [1.0_dp, 1.0_dp], .true.)
      call check_inverse(elastic_kernel_t(), [4, 3], [1.0_dp, 1.0_dp], .false.)
   end subroutine test_inverse

   ! So it is with the grids that stand beside the others under a sliding body, whichever way it goes.
   !@test
   subroutine test_inverse_of_sliding()
      type(sliding_kernel_t) :: kernel
      type(prony_t) :: prony
      integer :: along

      call new_prony(prony, 1.0_dp, [30.0_dp, 200.0_dp], [1.0_dp, 0.01_dp])
      do along = 1, 2
         call new_sliding_kernel(kernel, elastic_kernel_t(), prony, 0.3_dp, merge([1, 0], [0, 1], along == 1))
         call check_inverse(kernel, [32, 32], [1.0_dp, 1.0_dp], .false.)
         call check_inverse(kernel, [31, 18], [1.0_dp, 0.7_dp], .false.)
         call check_inverse(kernel, [400, 380], [1.0_dp, 1.0_dp], .false.)
         call check_inverse(kernel, [77, 1], [1.0_dp, 1.0_dp], .false.)
      end do
   end subroutine test_inverse_of_sliding

   !@test
   subroutine test_sums()
      integer, parameter :: nx = 377, ny = 379
      real(dp) :: a(nx, ny), b(nx, ny), c(nx, ny)

      call random_number(a)
      call random_number(b)
#line 130 "/work/wt/penetration/tests/periodic/periodic_levels.pf"
  call assertRelativelyEqual(sum(a), sum_of(a), tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_levels.pf', &
 & 130) )
  if (anyExceptions()) return
#line 131 "/work/wt/penetration/tests/periodic/periodic_levels.pf"
#line 131 "/work/wt/penetration/tests/periodic/periodic_levels.pf"
  call assertRelativelyEqual(sum(a*b), dot_of(a, b), tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_levels.pf', &
 & 131) )
  if (anyExceptions()) return
#line 132 "/work/wt/penetration/tests/periodic/periodic_levels.pf"
      c = a
      call add_multiple(c, -0.5_dp, b)
#line 134 "/work/wt/penetration/tests/periodic/periodic_levels.pf"
  call assertEqual(a - b/2, c, tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_levels.pf', &
 & 134) )
  if (anyExceptions()) return
#line 135 "/work/wt/penetration/tests/periodic/periodic_levels.pf"
   end subroutine test_sums

end module periodic_levels

module Wrapperiodic_levels
   use FUnit
   use periodic_levels
   implicit none
   private

contains


end module Wrapperiodic_levels

function periodic_levels_suite() result(suite)
   use FUnit
   use periodic_levels
   use Wrapperiodic_levels
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('periodic_levels_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_transpose', &
      test_transpose))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_straight_line', &
      test_straight_line))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_inverse', &
      test_inverse))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_inverse_of_sliding', &
      test_inverse_of_sliding))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_sums', &
      test_sums))
   call suite%addTest(t)


end function periodic_levels_suite


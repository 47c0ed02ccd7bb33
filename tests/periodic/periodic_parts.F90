! The operator, the nested grids and the measure of the area by themselves.
module periodic_parts
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_area, only: area_t, area_of_cells, refine_area
   use adfric_periodic_contact, only: contact_state_t, start_contact, solve_contact, residual_of
   use adfric_periodic_gap_solver, only: gap_solver_t, new_gap_solver
   use adfric_periodic_grids, only: coarsen, refine, n_grids_of
   use adfric_periodic_operator, only: periodic_operator_t, new_periodic_operator
   use trial_surfaces, only: noise_surface
   use funit
   implicit none (type, external)

   real(dp), parameter :: pi = acos(-1.0_dp), round_off = 1.0e-13_dp

contains

   !> One wave, and back.
   subroutine check_operator(n_cells, is_quarter, is_measured)
      integer, intent(in) :: n_cells(2)
      logical, intent(in) :: is_quarter, is_measured
      real(dp), parameter :: period(2) = [2.0_dp, 3.0_dp]
      type(periodic_operator_t) :: operator
      type(error_t), allocatable :: error
      real(dp), dimension(n_cells(1), n_cells(2)) :: p, u, back
      real(dp) :: x, y
      integer :: i, j

      call new_periodic_operator(operator, elastic_kernel_t(), n_cells, period, is_quarter, is_measured, error)
#line 31 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
  call assertFalse(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_parts.pf', &
 & 31) )
  if (anyExceptions()) return
#line 32 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
      do j = 1, n_cells(2)
         do i = 1, n_cells(1)
            x = (i - 0.5_dp)*operator%cell_size(1)
            y = (j - 0.5_dp)*operator%cell_size(2)
            p(i, j) = cos(2*pi*2*x/period(1))*cos(2*pi*y/period(2))
         end do
      end do
      call operator%apply_compliance(p, u)
#line 40 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
  call assertEqual(p*2/(2*pi*hypot(2/period(1), 1/period(2))), u, tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_parts.pf', &
 & 40) )
  if (anyExceptions()) return
#line 41 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
      call operator%apply_stiffness(u, back)
#line 42 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
  call assertEqual(p, back, tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_parts.pf', &
 & 42) )
  if (anyExceptions()) return
#line 43 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
      call operator%apply_stiffness(u + 1, back)
#line 44 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
  call assertEqual(p, back, tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_parts.pf', &
 & 44) )
  if (anyExceptions()) return
#line 45 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
   end subroutine check_operator

   !@test
   subroutine test_operator()
      call check_operator([16, 12], .false., .false.)
      call check_operator([15, 9], .false., .true.)
      call check_operator([16, 12], .true., .true.)
      call check_operator([7, 5], .true., .false.)
   end subroutine test_operator

   !@test
   subroutine test_grids()
      real(dp) :: coarse(8, 4), fine(16, 8), line(16, 1)
      integer :: i

#line 60 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
  call assertEqual(1, n_grids_of([9, 64]), &
 & location=SourceLocation( &
 & 'periodic_parts.pf', &
 & 60) )
  if (anyExceptions()) return
#line 61 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
#line 61 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
  call assertEqual(2, n_grids_of([16, 32]), &
 & location=SourceLocation( &
 & 'periodic_parts.pf', &
 & 61) )
  if (anyExceptions()) return
#line 62 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
#line 62 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
  call assertEqual(3, n_grids_of([32, 1]), &
 & location=SourceLocation( &
 & 'periodic_parts.pf', &
 & 62) )
  if (anyExceptions()) return
#line 63 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
#line 63 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
  call assertEqual(1, n_grids_of([1, 1]), &
 & location=SourceLocation( &
 & 'periodic_parts.pf', &
 & 63) )
  if (anyExceptions()) return
#line 64 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
      coarse = spread([(real(i, dp), i=1, 8)], 2, 4)
      fine = refine(coarse, fine, .true.)
#line 66 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
  call assertEqual(1.0_dp, fine(1, 3), tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_parts.pf', &
 & 66) )
  if (anyExceptions()) return
#line 67 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
#line 67 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
  call assertEqual(2.75_dp, fine(5, 8), tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_parts.pf', &
 & 67) )
  if (anyExceptions()) return
#line 68 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
#line 68 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
  call assertEqual(coarse(2:7, :), inner(coarsen(fine)), tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_parts.pf', &
 & 68) )
  if (anyExceptions()) return
#line 69 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
      fine = refine(coarse, fine, .false.)
#line 70 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
  call assertEqual(2.75_dp, fine(1, 3), tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_parts.pf', &
 & 70) )
  if (anyExceptions()) return
#line 71 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
      line = refine(coarse(:, :1), line, .false.)
#line 72 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
  call assertEqual(fine(:, 1), line(:, 1), tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_parts.pf', &
 & 72) )
  if (anyExceptions()) return
#line 73 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
   end subroutine test_grids

   !> Without the cells at the ends.
   pure function inner(field)
      real(dp), intent(in) :: field(:, :)
      real(dp) :: inner(size(field, 1) - 2, size(field, 2))

      inner = field(2:size(field, 1) - 1, :)
   end function inner

   !@test
   subroutine test_area_of_a_rectangle()
      logical :: is_contact(10, 8)
      type(area_t) :: area

      is_contact = .false.
      is_contact(:3, :2) = .true.
      area = area_of_cells(is_contact, .true.)
#line 91 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
  call assertEqual(6/80.0_dp, area%cells, tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_parts.pf', &
 & 91) )
  if (anyExceptions()) return
#line 92 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
#line 92 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
  call assertEqual(5/80.0_dp, area%perimeter, tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_parts.pf', &
 & 92) )
  if (anyExceptions()) return
#line 93 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
#line 93 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
  call assertEqual(6/80.0_dp - (pi - 1 + log(2.0_dp))/24*5/80, area%corrected, tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_parts.pf', &
 & 93) )
  if (anyExceptions()) return
#line 94 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
      area = area_of_cells(is_contact, .false.)
#line 95 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
  call assertEqual(10/80.0_dp, area%perimeter, tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_parts.pf', &
 & 95) )
  if (anyExceptions()) return
#line 96 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
      area = area_of_cells(is_contact(:, :1), .false.)
#line 97 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
  call assertEqual(0.3_dp, area%corrected, tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_parts.pf', &
 & 97) )
  if (anyExceptions()) return
#line 98 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
   end subroutine test_area_of_a_rectangle

   !@test
   subroutine test_error_of_area()
      type(area_t) :: area

      area = area_t(perimeter=0.1_dp, resolution=0.001_dp, corrected=0.5_dp)
      call refine_area(area, area_t(corrected=0.51_dp), area_t(corrected=0.55_dp), .false.)
#line 106 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
  call assertEqual(0.02_dp + 0.003_dp + 0.001_dp, area%error, tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_parts.pf', &
 & 106) )
  if (anyExceptions()) return
#line 107 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
      call refine_area(area, area_t(corrected=0.53_dp), area_t(corrected=0.55_dp), .true.)
#line 108 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
  call assertEqual(0.03_dp + 0.1_dp + 0.001_dp, area%error, tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_parts.pf', &
 & 108) )
  if (anyExceptions()) return
#line 109 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
   end subroutine test_error_of_area

   ! Cells changed one by one, where changing all that are wrong would not end: the same contact after more rounds.
   !@test
   subroutine test_cells_one_by_one()
      integer, parameter :: n = 12
      real(dp), parameter :: least = 1.0e-10_dp
      type(periodic_operator_t) :: operator
      type(gap_solver_t) :: gap_solver
      type(contact_state_t) :: all_at_once, one_by_one
      type(error_t), allocatable :: error

      call new_periodic_operator(operator, elastic_kernel_t(), [n, n], [1.0_dp, 1.0_dp], .false., .false., error)
#line 122 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
  call assertFalse(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_parts.pf', &
 & 122) )
  if (anyExceptions()) return
#line 123 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
      call new_gap_solver(gap_solver, [n, n])
      all_at_once%shape = noise_surface(n, 4)
      all_at_once%mean_pressure = 0.01_dp
      one_by_one = all_at_once
      one_by_one%patience = -1
      call start_contact(all_at_once, operator)
      call solve_contact(all_at_once, operator, gap_solver, least)
#line 130 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
  call assertTrue(all_at_once%is_converged, &
 & location=SourceLocation( &
 & 'periodic_parts.pf', &
 & 130) )
  if (anyExceptions()) return
#line 131 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
      call start_contact(one_by_one, operator)
      ! as far from it as possible
      one_by_one%is_open = .not. all_at_once%is_open
      call solve_contact(one_by_one, operator, gap_solver, least)
#line 135 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
  call assertTrue(one_by_one%is_converged, &
 & location=SourceLocation( &
 & 'periodic_parts.pf', &
 & 135) )
  if (anyExceptions()) return
#line 136 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
#line 136 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
  call assertLessThanOrEqual(residual_of(one_by_one), least, &
 & location=SourceLocation( &
 & 'periodic_parts.pf', &
 & 136) )
  if (anyExceptions()) return
#line 137 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
#line 137 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
  call assertGreaterThan(one_by_one%n_rounds, 10, &
 & location=SourceLocation( &
 & 'periodic_parts.pf', &
 & 137) )
  if (anyExceptions()) return
#line 138 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
#line 138 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
  call assertTrue(all(one_by_one%is_open .eqv. all_at_once%is_open), &
 & location=SourceLocation( &
 & 'periodic_parts.pf', &
 & 138) )
  if (anyExceptions()) return
#line 139 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
#line 139 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
  call assertEqual(all_at_once%pressure, one_by_one%pressure, tolerance=1.0e3_dp*least*all_at_once%pressure_scale, &
 & location=SourceLocation( &
 & 'periodic_parts.pf', &
 & 139) )
  if (anyExceptions()) return
#line 140 "/work/wt/penetration/tests/periodic/periodic_parts.pf"
   end subroutine test_cells_one_by_one

end module periodic_parts

module Wrapperiodic_parts
   use FUnit
   use periodic_parts
   implicit none
   private

contains


end module Wrapperiodic_parts

function periodic_parts_suite() result(suite)
   use FUnit
   use periodic_parts
   use Wrapperiodic_parts
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('periodic_parts_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_operator', &
      test_operator))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_grids', &
      test_grids))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_area_of_a_rectangle', &
      test_area_of_a_rectangle))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_error_of_area', &
      test_error_of_area))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_cells_one_by_one', &
      test_cells_one_by_one))
   call suite%addTest(t)


end function periodic_parts_suite


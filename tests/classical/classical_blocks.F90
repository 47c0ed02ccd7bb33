! SPDX-License-Identifier: GPL-3.0-or-later
! Points of a block have the bits of points alone, in any order: what they share is theirs to the last bit.
module classical_blocks
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: unset
   use adfric_classical_hertz_ellipse
   use adfric_classical_hertz_line, only: line_contact_t, line_of_load, line_misfit
   use adfric_classical_hertz_unit, only: unit_contact_t, find_unit_line, find_unit_ellipse
   use adfric_model_status, only: status_solved
   use counting_sink, only: n_different_bits
   use trial_case, only: trial_case_t, new_case
   use funit
   implicit none (type, external)

   integer, parameter :: n_values = 3, n_points = n_values**3

contains

   !> Solve all combinations of three values of three variables in several orders, and each alone.
   subroutine check_orders(case, names, values)
      type(trial_case_t), intent(in) :: case
      !> Of the variables.
      character(*), intent(in) :: names(3)
      !> Shape `(3, 3)`: those of the first variable stand in the first column.
      real(dp), intent(in) :: values(n_values, 3)
      !> Steps from point to point: as they are, and others that meet each point, too.
      integer, parameter :: strides(4) = [1, n_points - 1, 10, 4]
      type(trial_case_t) :: one
      real(dp) :: counts(size(case%model%counts))
      real(dp) :: points(size(case%values), n_points), block(size(case%model%results), n_points), &
         alone(size(case%model%results), n_points), estimate(n_points), own_estimate(n_points)
      integer :: order(n_points), status(n_points), i, k

      one = case
      do i = 0, n_points - 1
         do k = 1, 3
            call one%give(trim(names(k)), values(1 + modulo(i/n_values**(k - 1), n_values), k))
         end do
         call one%solve()
#line 40 "/work/main/tests/classical/classical_blocks.pf"
  call assertEqual(status_solved, one%status(1), message=one%model%name, &
 & location=SourceLocation( &
 & 'classical_blocks.pf', &
 & 40) )
  if (anyExceptions()) return
#line 41 "/work/main/tests/classical/classical_blocks.pf"
         points(:, i + 1) = one%values
         alone(:, i + 1) = one%results(:, 1)
         own_estimate(i + 1) = one%error_estimate(1)
      end do
      do k = 1, size(strides)
         order = 1 + modulo([(i*strides(k), i=1, n_points)], n_points)
         call case%model%solve_block(points(:, order), block, estimate, status, counts)
#line 48 "/work/main/tests/classical/classical_blocks.pf"
  call assertTrue(all(status == status_solved), message=case%model%name, &
 & location=SourceLocation( &
 & 'classical_blocks.pf', &
 & 48) )
  if (anyExceptions()) return
#line 49 "/work/main/tests/classical/classical_blocks.pf"
#line 49 "/work/main/tests/classical/classical_blocks.pf"
  call assertEqual(0, sum(n_different_bits(alone(:, order), block)), message=case%model%name, &
 & location=SourceLocation( &
 & 'classical_blocks.pf', &
 & 49) )
  if (anyExceptions()) return
#line 50 "/work/main/tests/classical/classical_blocks.pf"
#line 50 "/work/main/tests/classical/classical_blocks.pf"
  call assertEqual(0, sum(n_different_bits(own_estimate(order), estimate)), message=case%model%name, &
 & location=SourceLocation( &
 & 'classical_blocks.pf', &
 & 50) )
  if (anyExceptions()) return
#line 51 "/work/main/tests/classical/classical_blocks.pf"
      end do
   end subroutine check_orders

   ! Also Poisson's ratios that are neighbours as numbers.
   !@test
   subroutine test_hertz()
      real(dp), parameter :: loads(3) = [0.0_dp, 3.0_dp, 700.0_dp], radii(3) = [0.01_dp, 0.03_dp, 0.09_dp], nu = 0.3_dp
      type(trial_case_t) :: case
      integer :: kind

      do kind = 1, 3
         call new_case(case, 'hertz')
         call case%give('kind', real(kind, dp))
         call case%give('contact_modulus', 1.0e9_dp)
         associate (table => reshape([nu, nearest(nu, 1.0_dp), unset, radii, loads], [3, 3]))
            if (kind < 3) then
               call check_orders(case, [character(13) :: 'poisson_ratio', 'radius', 'load'], table)
            else
               call case%give('radius_1y', 0.03_dp)
               call check_orders(case, [character(13) :: 'poisson_ratio', 'radius_1x', 'load'], table)
               call check_orders(case, [character(13) :: 'load', 'radius_1x', 'poisson_ratio'], table(:, [3, 2, 1]))
               call check_orders(case, [character(13) :: 'poisson_ratio', 'radius_1x', 'approach'], table)
               call check_orders(case, [character(13) :: 'angle', 'radius_2x', 'load'], &
                  reshape([0.0_dp, nu, nearest(nu, 1.0_dp), radii, loads], [3, 3]))
            end if
         end associate
      end do
   end subroutine test_hertz

   !@test
   subroutine test_others()
      real(dp), parameter :: loads(3) = [1.0_dp, 30.0_dp, 700.0_dp], lengths(3) = [0.01_dp, 0.02_dp, 0.05_dp]
      real(dp), parameter :: moduli(3) = [1.0e8_dp, 1.0e9_dp, 1.0e10_dp], points(3) = [16.0_dp, 32.0_dp, 64.0_dp]
      type(trial_case_t) :: case

      call new_case(case, 'rigid_punch')
      call case%give('kind', 4.0_dp)
      call case%give('coefficient_4', 100.0_dp)
      call case%give('contact_modulus', 1.0e9_dp)
      call check_orders(case, [character(13) :: 'points', 'coefficient_2', 'load'], reshape([points, lengths, loads], [3, 3]))
      call new_case(case, 'wave_1d')
      call case%give('period', 0.5_dp)
      call check_orders(case, [character(15) :: 'contact_modulus', 'amplitude', 'mean_pressure'], &
         reshape([moduli, lengths, loads], [3, 3]))
   end subroutine test_others

   ! A unit contact stays for the numbers that it follows from, and for none that differ from them in a bit, or in their count.
   !@test
   subroutine test_unit_contact_of_the_last_point()
      real(dp), parameter :: mark = -1.0_dp, ratio = 0.5_dp, poisson_ratio = 0.3_dp
      type(unit_contact_t) :: contact
      real(dp) :: shear

      call find_unit_ellipse(ratio, poisson_ratio, contact)
      shear = contact%shear
#line 106 "/work/main/tests/classical/classical_blocks.pf"
  call assertGreaterThan(shear, 0.0_dp, &
 & location=SourceLocation( &
 & 'classical_blocks.pf', &
 & 106) )
  if (anyExceptions()) return
#line 107 "/work/main/tests/classical/classical_blocks.pf"
      contact%shear = mark
      call find_unit_ellipse(ratio, poisson_ratio, contact)
#line 109 "/work/main/tests/classical/classical_blocks.pf"
  call assertEqual(mark, contact%shear, &
 & location=SourceLocation( &
 & 'classical_blocks.pf', &
 & 109) )
  if (anyExceptions()) return
#line 110 "/work/main/tests/classical/classical_blocks.pf"
      call find_unit_ellipse(nearest(ratio, 1.0_dp), poisson_ratio, contact)
#line 111 "/work/main/tests/classical/classical_blocks.pf"
  call assertRelativelyEqual(shear, contact%shear, tolerance=1.0e-6_dp, &
 & location=SourceLocation( &
 & 'classical_blocks.pf', &
 & 111) )
  if (anyExceptions()) return
#line 112 "/work/main/tests/classical/classical_blocks.pf"
      contact%shear = mark
      call find_unit_ellipse(ratio, nearest(poisson_ratio, 1.0_dp), contact)
#line 114 "/work/main/tests/classical/classical_blocks.pf"
  call assertRelativelyEqual(shear, contact%shear, tolerance=1.0e-6_dp, &
 & location=SourceLocation( &
 & 'classical_blocks.pf', &
 & 114) )
  if (anyExceptions()) return
#line 115 "/work/main/tests/classical/classical_blocks.pf"
      contact%shear = mark
      call find_unit_line(poisson_ratio, contact)
#line 117 "/work/main/tests/classical/classical_blocks.pf"
  call assertGreaterThan(contact%shear, 0.0_dp, &
 & location=SourceLocation( &
 & 'classical_blocks.pf', &
 & 117) )
  if (anyExceptions()) return
#line 118 "/work/main/tests/classical/classical_blocks.pf"
      contact%shear = mark
      call find_unit_line(poisson_ratio, contact)
#line 120 "/work/main/tests/classical/classical_blocks.pf"
  call assertEqual(mark, contact%shear, &
 & location=SourceLocation( &
 & 'classical_blocks.pf', &
 & 120) )
  if (anyExceptions()) return
#line 121 "/work/main/tests/classical/classical_blocks.pf"
      contact%shear = mark
      call find_unit_ellipse(ratio, poisson_ratio, contact)
#line 123 "/work/main/tests/classical/classical_blocks.pf"
  call assertRelativelyEqual(shear, contact%shear, tolerance=1.0e-6_dp, &
 & location=SourceLocation( &
 & 'classical_blocks.pf', &
 & 123) )
  if (anyExceptions()) return
#line 124 "/work/main/tests/classical/classical_blocks.pf"
   end subroutine test_unit_contact_of_the_last_point

   ! The conditions of contact are those of the numbers that are reported: one that is wrong by a share is a violation of that size.
   !@test
   subroutine test_violation_is_seen()
      real(dp), parameter :: wrong = 1.0e-6_dp, share = 0.1_dp*wrong
      type(line_contact_t) :: line
      type(ellipse_shape_t) :: shape
      type(ellipse_t) :: right, s
      integer :: i

      line = line_of_load(2.0_dp, 3.0_dp, 5.0_dp)
      line%half_width = line%half_width*(1 + wrong)
#line 137 "/work/main/tests/classical/classical_blocks.pf"
  call assertGreaterThan(line_misfit(line, 5.0_dp), share, &
 & location=SourceLocation( &
 & 'classical_blocks.pf', &
 & 137) )
  if (anyExceptions()) return
#line 138 "/work/main/tests/classical/classical_blocks.pf"
      call find_shape(0.2_dp, shape)
      call ellipse_of_load(0.2_dp, 1.0_dp, 3.0_dp, 2.0_dp, shape, right)
      do i = 1, 4
         s = right
         select case (i)
         case (1)
            s%major = s%major*(1 + wrong)
         case (2)
            s%minor = s%minor*(1 + wrong)
         case (3)
            s%approach = s%approach*(1 + wrong)
         case (4)
            s%load = s%load*(1 + wrong)
         end select
#line 152 "/work/main/tests/classical/classical_blocks.pf"
  call assertGreaterThan(ellipse_misfit(s, 0.2_dp, 1.0_dp, 3.0_dp), share, &
 & location=SourceLocation( &
 & 'classical_blocks.pf', &
 & 152) )
  if (anyExceptions()) return
#line 153 "/work/main/tests/classical/classical_blocks.pf"
      end do
      call find_shape(0.2_dp*(1 + wrong), shape)
      call ellipse_of_load(0.2_dp, 1.0_dp, 3.0_dp, 2.0_dp, shape, s)
#line 156 "/work/main/tests/classical/classical_blocks.pf"
  call assertGreaterThan(ellipse_misfit(s, 0.2_dp, 1.0_dp, 3.0_dp), share, &
 & location=SourceLocation( &
 & 'classical_blocks.pf', &
 & 156) )
  if (anyExceptions()) return
#line 157 "/work/main/tests/classical/classical_blocks.pf"
   end subroutine test_violation_is_seen

end module classical_blocks

module Wrapclassical_blocks
   use FUnit
   use classical_blocks
   implicit none
   private

contains


end module Wrapclassical_blocks

function classical_blocks_suite() result(suite)
   use FUnit
   use classical_blocks
   use Wrapclassical_blocks
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('classical_blocks_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_hertz', &
      test_hertz))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_others', &
      test_others))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_unit_contact_of_the_last_point', &
      test_unit_contact_of_the_last_point))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_violation_is_seen', &
      test_violation_is_seen))
   call suite%addTest(t)


end function classical_blocks_suite


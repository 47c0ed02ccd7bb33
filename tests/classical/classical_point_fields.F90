! SPDX-License-Identifier: GPL-3.0-or-later
! Flamant, Boussinesq and Cerruti: the tables, Hooke's law, and equilibrium of what is cut out around the load.
module classical_point_fields
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_classical_boussinesq_cerruti, only: point_stress, point_displacement
   use adfric_classical_flamant, only: line_stress, line_displacement
   use reference_table, only: table_t, read_table, table_digits
   use funit
   implicit none (type, external)

   real(dp), parameter :: closed_form = 100*epsilon(1.0_dp)
   !> Central differences of fourth order with this step, for numbers of order 1.
   real(dp), parameter :: step = 1.0e-3_dp, differences = 1.0e-10_dp

contains

   !@test
   subroutine test_flamant_table()
      type(table_t) :: table
      real(dp) :: x, y, th, u(2)
      integer :: row

      call read_table(table, 'yas_flamant')
#line 25 "/work/main/tests/classical/classical_point_fields.pf"
  call assertEqual(5, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_point_fields.pf', &
 & 25) )
  if (anyExceptions()) return
#line 26 "/work/main/tests/classical/classical_point_fields.pf"
      do row = 1, table%n_rows
         th = table%number(row, 'theta')
         x = table%number(row, 'r')*sin(th)
         y = table%number(row, 'r')*cos(th)
#line 30 "/work/main/tests/classical/classical_point_fields.pf"
  call assertEqual(triple(table, row, 'N: '), line_stress(1.0_dp, 0.0_dp, x, y), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'classical_point_fields.pf', &
 & 30) )
  if (anyExceptions()) return
#line 31 "/work/main/tests/classical/classical_point_fields.pf"
#line 31 "/work/main/tests/classical/classical_point_fields.pf"
  call assertEqual(triple(table, row, 'T: '), line_stress(0.0_dp, 1.0_dp, x, y), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'classical_point_fields.pf', &
 & 31) )
  if (anyExceptions()) return
#line 32 "/work/main/tests/classical/classical_point_fields.pf"
         u = line_displacement(1.0_dp, 0.0_dp, 1.0_dp, 0.3_dp, 1.0_dp, x, y)
         u = [u(1)*sin(th) + u(2)*cos(th), u(1)*cos(th) - u(2)*sin(th)]
#line 34 "/work/main/tests/classical/classical_point_fields.pf"
  call assertEqual(pair(table, row, 'N: '), u, tolerance=table_digits, &
 & location=SourceLocation( &
 & 'classical_point_fields.pf', &
 & 34) )
  if (anyExceptions()) return
#line 35 "/work/main/tests/classical/classical_point_fields.pf"
         u = line_displacement(0.0_dp, 1.0_dp, 1.0_dp, 0.3_dp, 1.0_dp, x, y)
         u = [u(1)*sin(th) + u(2)*cos(th), u(1)*cos(th) - u(2)*sin(th)]
#line 37 "/work/main/tests/classical/classical_point_fields.pf"
  call assertEqual(pair(table, row, 'T: '), u, tolerance=table_digits, &
 & location=SourceLocation( &
 & 'classical_point_fields.pf', &
 & 37) )
  if (anyExceptions()) return
#line 38 "/work/main/tests/classical/classical_point_fields.pf"
      end do
   end subroutine test_flamant_table

   function triple(table, row, load)
      type(table_t), intent(in) :: table
      integer, intent(in) :: row
      character(*), intent(in) :: load
      real(dp) :: triple(3)

      triple = [table%number(row, load//'sxx'), table%number(row, load//'syy'), table%number(row, load//'sxy')]
   end function triple

   function pair(table, row, load)
      type(table_t), intent(in) :: table
      integer, intent(in) :: row
      character(*), intent(in) :: load
      real(dp) :: pair(2)

      pair = [table%number(row, load//'u_r'), table%number(row, load//'u_theta')]
   end function pair

   ! The displacements of the lecture fail here.
   !@test
   subroutine test_flamant_hooke()
      real(dp), parameter :: e = 1.7_dp, loads(2, 3) = reshape([1.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 0.7_dp, -0.4_dp], [2, 3])
      real(dp) :: gradient(2, 2), nu, place(2), shift(2), strain(3), s(3)
      integer :: k, i, j

      do k = 1, 3
         do j = 0, 4
            nu = 0.125_dp*j
            place = [0.8_dp*j - 1.3_dp, 0.6_dp + 0.3_dp*j]
            do i = 1, 2
               shift = 0
               shift(i) = step
               gradient(:, i) = (8*(u(place + shift) - u(place - shift)) - u(place + 2*shift) + u(place - 2*shift))/(12*step)
            end do
            s = line_stress(loads(1, k), loads(2, k), place(1), place(2))
            ! plane strain
            strain = (1 + nu)/e*[(1 - nu)*s(1) - nu*s(2), (1 - nu)*s(2) - nu*s(1), 2*s(3)]
            strain = strain - [gradient(1, 1), gradient(2, 2), gradient(1, 2) + gradient(2, 1)]
#line 79 "/work/main/tests/classical/classical_point_fields.pf"
  call assertEqual(0.0_dp, maxval(abs(strain)), tolerance=differences, &
 & location=SourceLocation( &
 & 'classical_point_fields.pf', &
 & 79) )
  if (anyExceptions()) return
#line 80 "/work/main/tests/classical/classical_point_fields.pf"
         end do
      end do

   contains

      function u(p)
         real(dp), intent(in) :: p(2)
         real(dp) :: u(2)

         u = line_displacement(loads(1, k), loads(2, k), e, nu, 2.0_dp, p(1), p(2))
      end function u

   end subroutine test_flamant_hooke

   ! The tractions on any half-circle carry the load, and turn nothing.
   !@test
   subroutine test_flamant_equilibrium()
      integer, parameter :: n = 40
      real(dp) :: th, s(3), force(2), x, y, radius
      integer :: i, k

      do k = -1, 1
         radius = 10.0_dp**(100*k)
         force = 0
         do i = 1, n
            th = pi*(i - 0.5_dp)/n - pi/2
            x = radius*sin(th)
            y = radius*cos(th)
            s = line_stress(3.0_dp, 2.0_dp, x, y)
            force = force + [s(1)*sin(th) + s(3)*cos(th), s(3)*sin(th) + s(2)*cos(th)]*radius*pi/n
         end do
#line 111 "/work/main/tests/classical/classical_point_fields.pf"
  call assertEqual([-2.0_dp, -3.0_dp], force, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_point_fields.pf', &
 & 111) )
  if (anyExceptions()) return
#line 112 "/work/main/tests/classical/classical_point_fields.pf"
      end do
   end subroutine test_flamant_equilibrium

   !@test
   subroutine test_point_table()
      type(table_t) :: table
      real(dp) :: place(3), nu, u(3)
      integer :: row

      call read_table(table, 'yas_boussinesq_cerruti')
#line 122 "/work/main/tests/classical/classical_point_fields.pf"
  call assertEqual(12, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_point_fields.pf', &
 & 122) )
  if (anyExceptions()) return
#line 123 "/work/main/tests/classical/classical_point_fields.pf"
      do row = 1, table%n_rows
         place = [table%number(row, 'x'), table%number(row, 'y'), 0.0_dp]
         nu = table%number(row, 'nu')
         u = point_displacement(1.0_dp, 0.0_dp, 1.0_dp, nu, place)
#line 127 "/work/main/tests/classical/classical_point_fields.pf"
  call assertEqual(table%number(row, 'N: u_z'), u(3), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_point_fields.pf', &
 & 127) )
  if (anyExceptions()) return
#line 128 "/work/main/tests/classical/classical_point_fields.pf"
#line 128 "/work/main/tests/classical/classical_point_fields.pf"
  call assertEqual(table%number(row, 'N: u_r'), dot_product(u, place)/norm2(place), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_point_fields.pf', &
 & 128) )
  if (anyExceptions()) return
#line 129 "/work/main/tests/classical/classical_point_fields.pf"
         u = point_displacement(0.0_dp, 1.0_dp, 1.0_dp, nu, place)
#line 130 "/work/main/tests/classical/classical_point_fields.pf"
  call assertEqual(table%number(row, 'T(x): u_x'), u(1), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_point_fields.pf', &
 & 130) )
  if (anyExceptions()) return
#line 131 "/work/main/tests/classical/classical_point_fields.pf"
#line 131 "/work/main/tests/classical/classical_point_fields.pf"
  call assertEqual(table%number(row, 'T(x): u_y'), u(2), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_point_fields.pf', &
 & 131) )
  if (anyExceptions()) return
#line 132 "/work/main/tests/classical/classical_point_fields.pf"
#line 132 "/work/main/tests/classical/classical_point_fields.pf"
  call assertEqual(table%number(row, 'T(x): u_z'), u(3), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_point_fields.pf', &
 & 132) )
  if (anyExceptions()) return
#line 133 "/work/main/tests/classical/classical_point_fields.pf"
      end do
   end subroutine test_point_table

   !@test
   subroutine test_point_hooke()
      real(dp), parameter :: shear = 1.3_dp, loads(2, 2) = reshape([1.0_dp, 0.0_dp, 0.0_dp, 1.0_dp], [2, 2])
      real(dp) :: gradient(3, 3), nu, place(3), shift(3), stress(6), trace
      integer :: k, i, j

      do k = 1, 2
         do j = -1, 3
            nu = 0.125_dp*j
            place = [0.8_dp*j - 0.7_dp, 0.5_dp - 0.4_dp*j, 0.5_dp + 0.3_dp*j]
            do i = 1, 3
               shift = 0
               shift(i) = step
               gradient(:, i) = (8*(u(place + shift) - u(place - shift)) - u(place + 2*shift) + u(place - 2*shift))/(12*step)
            end do
            trace = nu/(1 - 2*nu)*(gradient(1, 1) + gradient(2, 2) + gradient(3, 3))
            stress = shear*[2*(gradient(1, 1) + trace), 2*(gradient(2, 2) + trace), 2*(gradient(3, 3) + trace), &
               & gradient(1, 2) + gradient(2, 1), gradient(2, 3) + gradient(3, 2), gradient(1, 3) + gradient(3, 1)]
#line 154 "/work/main/tests/classical/classical_point_fields.pf"
  call assertEqual(stress, point_stress(loads(1, k), loads(2, k), nu, place), tolerance=10*differences, &
 & location=SourceLocation( &
 & 'classical_point_fields.pf', &
 & 154) )
  if (anyExceptions()) return
#line 155 "/work/main/tests/classical/classical_point_fields.pf"
         end do
      end do

   contains

      function u(p)
         real(dp), intent(in) :: p(3)
         real(dp) :: u(3)

         u = point_displacement(loads(1, k), loads(2, k), shear, nu, p)
      end function u

   end subroutine test_point_hooke

   ! The tractions on a hemisphere carry the force: exact by the rule of equal angles around and many steps of depth.
   !@test
   subroutine test_point_equilibrium()
      integer, parameter :: n = 12, m = 2000
      !> Of the rule of midpoints.
      real(dp), parameter :: midpoints = 1.0e-6_dp
      real(dp) :: c, phi, d(3), s(6), force(3)
      integer :: i, j

      force = 0
      do j = 1, m
         c = (j - 0.5_dp)/m
         do i = 1, n
            phi = 2*pi*(i - 0.5_dp)/n
            d = [sqrt(1 - c*c)*cos(phi), sqrt(1 - c*c)*sin(phi), c]
            s = point_stress(3.0_dp, 2.0_dp, 0.2_dp, 5*d)
            force = force + [dot_product(s([1, 4, 6]), d), dot_product(s([4, 2, 5]), d), dot_product(s([6, 5, 3]), d)] &
               & *25*2*pi/n/m
         end do
      end do
#line 189 "/work/main/tests/classical/classical_point_fields.pf"
  call assertEqual([-2.0_dp, 0.0_dp, -3.0_dp], force, tolerance=midpoints, &
 & location=SourceLocation( &
 & 'classical_point_fields.pf', &
 & 189) )
  if (anyExceptions()) return
#line 190 "/work/main/tests/classical/classical_point_fields.pf"
      ! no tractions on the surface
      s = point_stress(3.0_dp, 2.0_dp, 0.2_dp, [0.3_dp, -0.4_dp, 0.0_dp])
#line 192 "/work/main/tests/classical/classical_point_fields.pf"
  call assertEqual(0.0_dp, maxval(abs(s([3, 5, 6]))), &
 & location=SourceLocation( &
 & 'classical_point_fields.pf', &
 & 192) )
  if (anyExceptions()) return
#line 193 "/work/main/tests/classical/classical_point_fields.pf"
   end subroutine test_point_equilibrium

end module classical_point_fields

module Wrapclassical_point_fields
   use FUnit
   use classical_point_fields
   implicit none
   private

contains


end module Wrapclassical_point_fields

function classical_point_fields_suite() result(suite)
   use FUnit
   use classical_point_fields
   use Wrapclassical_point_fields
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('classical_point_fields_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_flamant_table', &
      test_flamant_table))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_flamant_hooke', &
      test_flamant_hooke))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_flamant_equilibrium', &
      test_flamant_equilibrium))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_point_table', &
      test_point_table))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_point_hooke', &
      test_point_hooke))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_point_equilibrium', &
      test_point_equilibrium))
   call suite%addTest(t)


end function classical_point_fields_suite


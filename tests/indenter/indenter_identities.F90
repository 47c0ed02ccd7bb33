! SPDX-License-Identifier: GPL-3.0-or-later
! What holds for every kind of indenter: the way back, energy, stiffness, other units, limits.
module indenter_identities
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_unset, only: is_set, unset
   use adfric_indenter_model, only: indenter_model_t
   use adfric_indenter_variables
   use adfric_model_status, only: status_solved
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   use indenter_cases, only: new_indenter, hold, n_kinds
   use model_calls, only: solve_point
   use funit
   implicit none (type, external)

   !> Closed forms, with a root between them.
   real(dp), parameter :: round_off = 1.0e-12_dp
   real(dp), parameter :: works(*) = [0.0_dp, 1.0e-9_dp, 1.0e-3_dp, 0.3_dp, 40.0_dp]

contains

   !> Solve a point that has to be solved.
   subroutine solve(model, values, results, label)
      type(indenter_model_t), intent(in) :: model
      real(dp), intent(in) :: values(:)
      real(dp), allocatable, intent(out) :: results(:)
      character(*), intent(in) :: label
      real(dp) :: error_estimate
      integer :: status

      allocate (results(n_indenter_results))
      call solve_point(model, values, results, error_estimate, status)
#line 34 "/work/main/tests/indenter/indenter_identities.pf"
  call assertEqual(status_solved, status, message=label, &
 & location=SourceLocation( &
 & 'indenter_identities.pf', &
 & 34) )
  if (anyExceptions()) return
#line 35 "/work/main/tests/indenter/indenter_identities.pf"
   end subroutine solve

   !> A kind with a work of adhesion, and the load at which it is stable in both controls.
   subroutine new_adhesive(model, values, kind, work, load)
      type(indenter_model_t), intent(out) :: model
      real(dp), allocatable, intent(out) :: values(:)
      integer, intent(in) :: kind
      real(dp), intent(in) :: work
      real(dp), intent(out) :: load
      real(dp), allocatable :: results(:)

      call new_indenter(model, values, kind)
      values(v_work_of_adhesion) = work
      call hold(values, v_load, 0.1_dp)
      call solve(model, values, results, 'pull-off')
      load = 0.1_dp + 0.7_dp*results(r_pull_off_load)
   end subroutine new_adhesive

   ! The state of a load is that of its approach, and that of its radius.
   !@test
   subroutine test_ways_back()
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:), by_load(:), again(:)
      integer, parameter :: same(*) = [r_load, r_approach, r_contact_radius, r_mean_pressure, r_elastic_energy]
      integer :: kind, k, way, i
      real(dp) :: load, least
      character(20) :: label

      do kind = 1, n_kinds
         do k = 1, size(works)
            write (label, '(2i4)') kind, k
            call new_adhesive(model, values, kind, works(k), load)
            call hold(values, v_load, load)
            call solve(model, values, by_load, label)
            do way = 1, 2
               if (way == 2 .and. kind == kind_flat) cycle
               if (way == 1) call hold(values, v_approach, by_load(r_approach))
               if (way == 2) call hold(values, v_contact_radius, by_load(r_contact_radius))
               call solve(model, values, again, label)
               ! beside the face a radius has lost digits that a load has
               least = round_off*(1 + by_load(r_contact_radius)*by_load(r_contact_stiffness))
#line 76 "/work/main/tests/indenter/indenter_identities.pf"
  call assertEqual(by_load(r_load), again(r_load), tolerance=least*(1 + abs(load)), message=label, &
 & location=SourceLocation( &
 & 'indenter_identities.pf', &
 & 76) )
  if (anyExceptions()) return
#line 77 "/work/main/tests/indenter/indenter_identities.pf"
               do i = 1, size(same)
                  associate (expected => by_load(same(i)))
#line 79 "/work/main/tests/indenter/indenter_identities.pf"
  call assertEqual(expected, again(same(i)), tolerance=1.0e-11_dp*(1 + abs(expected)), message=label, &
 & location=SourceLocation( &
 & 'indenter_identities.pf', &
 & 79) )
  if (anyExceptions()) return
#line 80 "/work/main/tests/indenter/indenter_identities.pf"
                  end associate
               end do
            end do
         end do
      end do
   end subroutine test_ways_back

   ! The load does the work: E = U - pi a^2 w, dE = P ddelta; and dP = stiffness*ddelta.
   !@test
   subroutine test_energy()
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:), first(:), last(:), inside(:)
      real(dp) :: load, gained, done, climbed, width
      integer :: kind, k, node
      character(20) :: label

      do kind = 1, n_kinds
         do k = 1, size(works)
            write (label, '(2i4)') kind, k
            call new_adhesive(model, values, kind, works(k), load)
            call hold(values, v_load, load)
            call solve(model, values, first, label)
            call hold(values, v_load, load + 0.1_dp + 0.1_dp*abs(load))
            call solve(model, values, last, label)
            width = last(r_approach) - first(r_approach)
            done = 0
            climbed = 0
            do node = 1, size(gauss_nodes)
               call hold(values, v_approach, first(r_approach) + width*(1 + gauss_nodes(node))/2)
               call solve(model, values, inside, label)
               done = done + gauss_weights(node)*inside(r_load)*width/2
               climbed = climbed + gauss_weights(node)*inside(r_contact_stiffness)*width/2
            end do
            gained = energy_of(last, works(k)) - energy_of(first, works(k))
            associate (large => abs(energy_of(last, 0.0_dp)) + works(k)*last(r_contact_area))
#line 115 "/work/main/tests/indenter/indenter_identities.pf"
  call assertEqual(gained, done, tolerance=round_off*large, message=label, &
 & location=SourceLocation( &
 & 'indenter_identities.pf', &
 & 115) )
  if (anyExceptions()) return
#line 116 "/work/main/tests/indenter/indenter_identities.pf"
            end associate
            associate (change => last(r_load) - first(r_load))
#line 118 "/work/main/tests/indenter/indenter_identities.pf"
  call assertEqual(change, climbed, tolerance=round_off*(1 + abs(load) + abs(last(r_load))), message=label, &
 & location=SourceLocation( &
 & 'indenter_identities.pf', &
 & 118) )
  if (anyExceptions()) return
#line 119 "/work/main/tests/indenter/indenter_identities.pf"
            end associate
         end do
      end do
   end subroutine test_energy

   !> Elastic energy less that of adhesion.
   pure real(dp) function energy_of(results, work)
      real(dp), intent(in) :: results(:), work

      energy_of = results(r_elastic_energy) - work*results(r_contact_area)
   end function energy_of

   ! Nanometres and gigapascals: the same digits.
   !@test
   subroutine test_other_units()
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:), scaled(:), results(:), other(:)
      real(dp), parameter :: length = 1.0e-9_dp, stress = 1.0e9_dp
      real(dp) :: factors(n_indenter_results), load
      integer :: kind, k, i
      character(20) :: label

      factors = 1
      factors([r_load, r_pull_off_load, r_jump_inward_load, r_jump_outward_load]) = stress*length**2
      factors([r_approach, r_contact_radius, r_adhesion_radius]) = length
      factors([r_pull_off_approach, r_jump_inward_approach, r_jump_outward_approach]) = length
      factors(r_contact_area) = length**2
      factors(r_mean_pressure) = stress
      factors(r_contact_stiffness) = stress*length
      factors(r_elastic_energy) = stress*length**3
      do kind = 1, n_kinds
         do k = 1, size(works)
            write (label, '(2i4)') kind, k
            call new_adhesive(model, values, kind, works(k), load)
            call hold(values, v_load, load)
            call solve(model, values, results, label)
            scaled = values
            if (is_set(scaled(v_radius))) scaled(v_radius) = length*scaled(v_radius)
            if (is_set(scaled(v_face_radius))) scaled(v_face_radius) = length*scaled(v_face_radius)
            if (kind == kind_power) scaled(v_coefficient) = scaled(v_coefficient)*length**(1 - scaled(v_exponent))
            do i = v_coefficient_1, v_coefficient_8
               scaled(i) = scaled(i)*length**(v_coefficient_1 - i)
            end do
            scaled(v_contact_modulus) = stress
            scaled(v_work_of_adhesion) = stress*length*values(v_work_of_adhesion)
            scaled(v_load) = stress*length**2*load
            call solve(model, scaled, other, label)
            do i = 1, n_indenter_results
#line 167 "/work/main/tests/indenter/indenter_identities.pf"
  call assertTrue(ieee_is_nan(results(i)) .eqv. ieee_is_nan(other(i)), message=label, &
 & location=SourceLocation( &
 & 'indenter_identities.pf', &
 & 167) )
  if (anyExceptions()) return
#line 168 "/work/main/tests/indenter/indenter_identities.pf"
               if (ieee_is_nan(results(i))) cycle
#line 169 "/work/main/tests/indenter/indenter_identities.pf"
  call assertEqual(results(i), other(i)/factors(i), tolerance=round_off*(1 + abs(results(i))), message=label, &
 & location=SourceLocation( &
 & 'indenter_identities.pf', &
 & 169) )
  if (anyExceptions()) return
#line 170 "/work/main/tests/indenter/indenter_identities.pf"
            end do
         end do
      end do
   end subroutine test_other_units

   ! A cone with a small face is a cone, one with a small round tip, too; a large sphere is a paraboloid.
   !@test
   subroutine test_limits()
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:), sharp(:), blunt(:), results(:)
      real(dp), parameter :: small = 1.0e-9_dp
      integer :: k

      do k = 1, size(works)
         call new_indenter(model, values, kind_cone)
         values(v_work_of_adhesion) = works(k)
         call hold(values, v_load, 0.7_dp)
         call solve(model, values, sharp, 'cone')
         call new_indenter(model, values, kind_flat_cone)
         values(v_work_of_adhesion) = works(k)
         values(v_face_radius) = small
         call hold(values, v_load, 0.7_dp)
         call solve(model, values, blunt, 'flat cone')
         call check(small)
         call new_indenter(model, values, kind_rounded_cone)
         values(v_work_of_adhesion) = works(k)
         values(v_radius) = small
         call hold(values, v_load, 0.7_dp)
         call solve(model, values, blunt, 'rounded cone')
         call check(small/2)
      end do
      do k = 1, 3
         call new_indenter(model, values, kind_sphere)
         values([v_work_of_adhesion, v_radius, v_load]) = [works(k)*1.0e-19_dp, 1.0_dp, 1.0e-21_dp]
         call solve(model, values, blunt, 'sphere')
         values(v_kind) = kind_paraboloid
         call solve(model, values, results, 'paraboloid')
#line 207 "/work/main/tests/indenter/indenter_identities.pf"
  call assertRelativelyEqual(results(r_contact_radius), blunt(r_contact_radius), tolerance=round_off, &
 & location=SourceLocation( &
 & 'indenter_identities.pf', &
 & 207) )
  if (anyExceptions()) return
#line 208 "/work/main/tests/indenter/indenter_identities.pf"
#line 208 "/work/main/tests/indenter/indenter_identities.pf"
  call assertRelativelyEqual(results(r_approach), blunt(r_approach), tolerance=round_off, &
 & location=SourceLocation( &
 & 'indenter_identities.pf', &
 & 208) )
  if (anyExceptions()) return
#line 209 "/work/main/tests/indenter/indenter_identities.pf"
      end do

   contains

      !> The blunt cone is the sharp one, but for the length of its tip.
      subroutine check(missing)
         real(dp), intent(in) :: missing
         integer, parameter :: same(*) = [r_contact_radius, r_contact_stiffness, r_mean_pressure]

#line 218 "/work/main/tests/indenter/indenter_identities.pf"
  call assertRelativelyEqual(sharp(same), blunt(same), tolerance=10*small**2 + round_off, &
 & location=SourceLocation( &
 & 'indenter_identities.pf', &
 & 218) )
  if (anyExceptions()) return
#line 219 "/work/main/tests/indenter/indenter_identities.pf"
#line 219 "/work/main/tests/indenter/indenter_identities.pf"
  call assertEqual(sharp(r_approach) - missing, blunt(r_approach), tolerance=round_off*(1 + abs(sharp(r_approach))), &
 & location=SourceLocation( &
 & 'indenter_identities.pf', &
 & 219) )
  if (anyExceptions()) return
#line 220 "/work/main/tests/indenter/indenter_identities.pf"
      end subroutine check

   end subroutine test_limits

   ! Where a contact has hardly left a flat face the load has all its digits: P = 2 E* b delta, as of a flat punch.
   !@test
   subroutine test_light_loads()
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:), results(:), again(:)
      integer, parameter :: kinds(*) = [kind_flat_cone, kind_flat_paraboloid, kind_rounded_punch]
      integer :: kind, decade

      do kind = 1, size(kinds)
         do decade = -28, -20, 2
            call new_indenter(model, values, kinds(kind))
            call hold(values, v_load, 10.0_dp**decade)
            call solve(model, values, results, 'light load')
#line 237 "/work/main/tests/indenter/indenter_identities.pf"
  call assertRelativelyEqual(values(v_load)/2, results(r_approach), tolerance=round_off, &
 & location=SourceLocation( &
 & 'indenter_identities.pf', &
 & 237) )
  if (anyExceptions()) return
#line 238 "/work/main/tests/indenter/indenter_identities.pf"
#line 238 "/work/main/tests/indenter/indenter_identities.pf"
  call assertRelativelyEqual(values(v_load)**2/4, results(r_elastic_energy), tolerance=round_off, &
 & location=SourceLocation( &
 & 'indenter_identities.pf', &
 & 238) )
  if (anyExceptions()) return
#line 239 "/work/main/tests/indenter/indenter_identities.pf"
            call hold(values, v_approach, results(r_approach))
            call solve(model, values, again, 'light approach')
#line 241 "/work/main/tests/indenter/indenter_identities.pf"
  call assertRelativelyEqual(10.0_dp**decade, again(r_load), tolerance=round_off, &
 & location=SourceLocation( &
 & 'indenter_identities.pf', &
 & 241) )
  if (anyExceptions()) return
#line 242 "/work/main/tests/indenter/indenter_identities.pf"
         end do
         call hold(values, v_face_angle, 1.0e-3_dp)
         call solve(model, values, results, 'face angle')
         call hold(values, v_load, results(r_load))
         call solve(model, values, again, 'its load')
#line 247 "/work/main/tests/indenter/indenter_identities.pf"
  call assertRelativelyEqual(results(r_approach), again(r_approach), tolerance=round_off, &
 & location=SourceLocation( &
 & 'indenter_identities.pf', &
 & 247) )
  if (anyExceptions()) return
#line 248 "/work/main/tests/indenter/indenter_identities.pf"
      end do
   end subroutine test_light_loads

end module indenter_identities

module Wrapindenter_identities
   use FUnit
   use indenter_identities
   implicit none
   private

contains


end module Wrapindenter_identities

function indenter_identities_suite() result(suite)
   use FUnit
   use indenter_identities
   use Wrapindenter_identities
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('indenter_identities_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_ways_back', &
      test_ways_back))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_energy', &
      test_energy))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_other_units', &
      test_other_units))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_limits', &
      test_limits))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_light_loads', &
      test_light_loads))
   call suite%addTest(t)


end function indenter_identities_suite


! SPDX-License-Identifier: GPL-3.0-or-later
! Partial slip of `hertz`: the tables, its limits, derivative and energy, its tractions, and what it refuses.
module classical_hertz_slip
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_unset, only: unset
   use adfric_classical_hertz_ellipse, only: ellipse_t, ellipse_shape_t, ellipse_of_load, find_shape
   use adfric_classical_partial_slip, only: partial_slip_t, ellipse_slip, line_slip, shear_traction
   use adfric_model_status, only: status_solved, status_no_equilibrium
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   use reference_table, only: table_t, read_table
   use trial_case, only: trial_case_t, new_case
   use funit
   implicit none (type, external)

   !> Places of the words of `kind` and of `tangential_axis`.
   real(dp), parameter :: line = 1, circular = 2, elliptical = 3, along_major = 1, along_minor = 2
   !> A ball [m], Young's modulus [Pa], Poisson's ratio, a load [N], a coefficient of friction.
   real(dp), parameter :: radius = 0.01_dp, young = 2.0e11_dp, nu = 0.3_dp, load = 50, mu = 0.4_dp
   real(dp), parameter :: closed_form = 100*epsilon(1.0_dp)

contains

   !> A ball on a rigid plane, with a force in shares of mu P.
   subroutine new_ball(case, tau)
      type(trial_case_t), intent(out) :: case
      real(dp), intent(in) :: tau

      call new_case(case, 'hertz')
      call case%give('kind', circular)
      call case%give('radius', radius)
      call give_solid(case)
      call case%give('load', load)
      call give_friction(case, tau)
   end subroutine new_ball

   !> The elastic body.
   subroutine give_solid(case)
      type(trial_case_t), intent(inout) :: case

      ! `material` has variables of these names, too
      case%values(case%model%index_of('solid', 'young_modulus')) = young
      case%values(case%model%index_of('solid', 'poisson_ratio')) = nu
   end subroutine give_solid

   !> Friction and force.
   subroutine give_friction(case, tau)
      type(trial_case_t), intent(inout) :: case
      real(dp), intent(in) :: tau

      call case%give('coefficient', mu)
      call case%give('tangential_force', tau*mu*load)
   end subroutine give_friction

   !> Solve a case that is in order.
   subroutine solve(case)
      type(trial_case_t), intent(inout) :: case

#line 60 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 60) )
  if (anyExceptions()) return
#line 61 "/work/main/tests/classical/classical_hertz_slip.pf"
      call case%solve()
#line 62 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 62) )
  if (anyExceptions()) return
#line 63 "/work/main/tests/classical/classical_hertz_slip.pf"
   end subroutine solve

   !@test
   subroutine test_sphere_table()
      type(table_t) :: table
      type(partial_slip_t) :: slip
      type(trial_case_t) :: case
      integer :: i
      real(dp) :: full, stiffness, fair

      call read_table(table, 'slip_sphere')
#line 74 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertEqual(8, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 74) )
  if (anyExceptions()) return
#line 75 "/work/main/tests/classical/classical_hertz_slip.pf"
      do i = 1, table%n_rows
         associate (tau => table%number(i, 'tau'))
            ! tau is rounded, and 1 - tau with it
            fair = closed_form + epsilon(tau)/max(1 - tau, epsilon(tau))**(2/3.0_dp)
            slip = ellipse_slip(tau)
#line 80 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertEqual(table%number(i, 'stick'), slip%stick, tolerance=fair, message=table%label(i), &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 80) )
  if (anyExceptions()) return
#line 81 "/work/main/tests/classical/classical_hertz_slip.pf"
#line 81 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertRelativelyEqual(table%number(i, 'u'), slip%displacement(), tolerance=closed_form, message=table%label(i), &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 81) )
  if (anyExceptions()) return
#line 82 "/work/main/tests/classical/classical_hertz_slip.pf"
#line 82 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertRelativelyEqual(table%number(i, 'W'), slip%energy, tolerance=closed_form, message=table%label(i), &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 82) )
  if (anyExceptions()) return
#line 83 "/work/main/tests/classical/classical_hertz_slip.pf"
            ! and by the model, in SI units: 1/G* = (2 - nu)/(4 G)
            call new_ball(case, tau)
            call solve(case)
            stiffness = 2*case%found('contact_half_width')*4/(2 - nu)*young/(2*(1 + nu))
            full = 1.5_dp*mu*load/stiffness
#line 88 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertRelativelyEqual(table%number(i, 'u')*full, case%found('tangential_displacement'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 88) )
  if (anyExceptions()) return
#line 89 "/work/main/tests/classical/classical_hertz_slip.pf"
#line 89 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertEqual(table%number(i, 'stiffness'), case%found('tangential_stiffness')/stiffness, tolerance=4*fair, &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 89) )
  if (anyExceptions()) return
#line 90 "/work/main/tests/classical/classical_hertz_slip.pf"
#line 90 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertRelativelyEqual(table%number(i, 'W')*mu*load*full, case%found('cycle_energy'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 90) )
  if (anyExceptions()) return
#line 91 "/work/main/tests/classical/classical_hertz_slip.pf"
#line 91 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertEqual(table%number(i, 'stick')**2, case%found('stick_fraction'), tolerance=4*fair, &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 91) )
  if (anyExceptions()) return
#line 92 "/work/main/tests/classical/classical_hertz_slip.pf"
         end associate
      end do
   end subroutine test_sphere_table

   !@test
   subroutine test_line_table()
      type(table_t) :: table
      type(partial_slip_t) :: slip
      type(trial_case_t) :: case
      real(dp) :: energy
      integer :: i

      call read_table(table, 'slip_line')
#line 105 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertEqual(8, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 105) )
  if (anyExceptions()) return
#line 106 "/work/main/tests/classical/classical_hertz_slip.pf"
      do i = 1, table%n_rows
         associate (tau => table%number(i, 'tau'))
            slip = line_slip(tau)
#line 109 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertEqual(table%number(i, 'stick'), slip%stick, tolerance=closed_form, message=table%label(i), &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 109) )
  if (anyExceptions()) return
#line 110 "/work/main/tests/classical/classical_hertz_slip.pf"
#line 110 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertRelativelyEqual(table%number(i, 'W'), slip%energy, tolerance=closed_form, message=table%label(i), &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 110) )
  if (anyExceptions()) return
#line 111 "/work/main/tests/classical/classical_hertz_slip.pf"
            call new_case(case, 'hertz')
            call case%give('kind', line)
            call case%give('radius', radius)
            call case%give('contact_modulus', young)
            call case%give('load', load)
            call give_friction(case, tau)
            call solve(case)
            energy = table%number(i, 'W')*4*(mu*load)**2/(pi*young)
#line 119 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertRelativelyEqual(energy, case%found('cycle_energy'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 119) )
  if (anyExceptions()) return
#line 120 "/work/main/tests/classical/classical_hertz_slip.pf"
#line 120 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertEqual(table%number(i, 'stick'), case%found('stick_fraction'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 120) )
  if (anyExceptions()) return
#line 121 "/work/main/tests/classical/classical_hertz_slip.pf"
#line 121 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertTrue(ieee_is_nan(case%found('tangential_displacement')), &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 121) )
  if (anyExceptions()) return
#line 122 "/work/main/tests/classical/classical_hertz_slip.pf"
         end associate
      end do
   end subroutine test_line_table

   !@test
   subroutine test_ellipse_table()
      type(table_t) :: table
      type(trial_case_t) :: case
      integer :: i, axis
      character(7), parameter :: full(2) = ['ux_full', 'uy_full']
      real(dp) :: shear, length, ratio

      call read_table(table, 'slip_ellipse')
#line 135 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertEqual(16, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 135) )
  if (anyExceptions()) return
#line 136 "/work/main/tests/classical/classical_hertz_slip.pf"
      do i = 1, table%n_rows
         do axis = nint(along_major), nint(along_minor)
            call new_case(case, 'hertz')
            call case%give('kind', elliptical)
            call curvatures_of(table%number(i, 'b_over_a'), ratio)
            call case%give('radius_1x', radius/ratio)
            call case%give('radius_1y', radius)
            case%values(case%model%index_of('solid', 'young_modulus')) = young
            case%values(case%model%index_of('solid', 'poisson_ratio')) = table%number(i, 'nu')
            call case%give('load', load)
            call give_friction(case, 1.0_dp)
            call case%give('tangential_axis', real(axis, dp))
            call solve(case)
            length = case%found('contact_half_width')
            shear = young/(2*(1 + table%number(i, 'nu')))
            ! the axis ratio is found from that of the curvatures
#line 152 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertRelativelyEqual(table%number(i, 'b_over_a'), case%found('minor_half_width')/length, tolerance=1.0e-9_dp, &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 152) )
  if (anyExceptions()) return
#line 153 "/work/main/tests/classical/classical_hertz_slip.pf"
            associate (u => case%found('tangential_displacement')*shear*length/(mu*load))
#line 154 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertRelativelyEqual(table%number(i, full(axis)), u, tolerance=1.0e-9_dp, message=table%label(i), &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 154) )
  if (anyExceptions()) return
#line 155 "/work/main/tests/classical/classical_hertz_slip.pf"
            end associate
         end do
      end do
   end subroutine test_ellipse_table

   !> Ratio A/B of the curvatures that belongs to an axis ratio, by halves.
   subroutine curvatures_of(axis_ratio, ratio)
      real(dp), intent(in) :: axis_ratio
      real(dp), intent(out) :: ratio
      type(ellipse_shape_t) :: shape
      real(dp) :: low, high
      integer :: k

      low = -60
      high = 0
      ratio = 1
      if (.not. axis_ratio < 1) return
      do k = 1, 70
         ratio = exp((low + high)/2)
         call find_shape(ratio, shape)
         if (shape%axis_ratio < axis_ratio) low = (low + high)/2
         if (.not. shape%axis_ratio < axis_ratio) high = (low + high)/2
      end do
   end subroutine curvatures_of

   !@test
   subroutine test_traction_table()
      type(table_t) :: table
      type(partial_slip_t) :: slip
      real(dp) :: traction
      integer :: i

      call read_table(table, 'slip_sphere_traction')
      do i = 1, table%n_rows
         if (trim(table%text(i, 'path')) /= 'load') cycle
         slip = ellipse_slip(table%number(i, 'tau'))
         traction = shear_traction(slip, table%number(i, 'r_over_a')**2)
#line 192 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertEqual(table%number(i, 'q'), traction, tolerance=closed_form, message=table%label(i), &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 192) )
  if (anyExceptions()) return
#line 193 "/work/main/tests/classical/classical_hertz_slip.pf"
      end do
#line 194 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertGreaterThan(i, 10, &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 194) )
  if (anyExceptions()) return
#line 195 "/work/main/tests/classical/classical_hertz_slip.pf"
   end subroutine test_traction_table

   !@test
   subroutine test_force_of_tractions()
      ! the tractions of a line carry the force: int q dx = T, by x = a sin v on both sides of the edge of stick
      type(partial_slip_t) :: slip
      real(dp), parameter :: taus(3) = [0.4_dp, 0.7_dp, 0.99_dp]
      real(dp) :: force, angle, edge
      integer :: i, k

      do i = 1, size(taus)
         slip = line_slip(taus(i))
         edge = asin(slip%stick)
         force = 0
         do k = 1, size(gauss_nodes)
            ! x = y sin v sticks, x = cos v slips
            angle = pi/4*(1 + gauss_nodes(k))
            force = force + pi/4*gauss_weights(k)*shear_traction(slip, (slip%stick*sin(angle))**2)*slip%stick*cos(angle)
            angle = (pi/2 - edge)/2*(1 + gauss_nodes(k))
            force = force + (pi/2 - edge)/2*gauss_weights(k)*sin(angle)**2
         end do
         ! p0 = 2 P/(pi a)
#line 217 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertRelativelyEqual(taus(i), 2*force*2/pi, tolerance=1.0e-9_dp, &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 217) )
  if (anyExceptions()) return
#line 218 "/work/main/tests/classical/classical_hertz_slip.pf"
      end do
   end subroutine test_force_of_tractions

   !@test
   subroutine test_loop()
      ! Masing: the loop is the first loading twice as large, so it encloses 4 int T du - 2 T u of the first loading
      type(trial_case_t) :: case
      real(dp), parameter :: tau = 0.7_dp
      real(dp) :: work, last
      integer :: k

      work = 0
      do k = 1, size(gauss_nodes)
         call new_ball(case, tau*(1 + gauss_nodes(k))/2)
         call solve(case)
         ! int T du = int T (du/dT) dT
         work = work + tau*mu*load/2*gauss_weights(k)*case%values(case%model%index_of('operating', 'tangential_force')) &
            & /case%found('tangential_stiffness')
      end do
      call new_ball(case, tau)
      call solve(case)
      last = case%found('tangential_displacement')
#line 240 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertRelativelyEqual(8*work - 4*tau*mu*load*last, case%found('cycle_energy'), tolerance=1.0e-10_dp, &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 240) )
  if (anyExceptions()) return
#line 241 "/work/main/tests/classical/classical_hertz_slip.pf"
   end subroutine test_loop

   !@test
   subroutine test_slope()
      type(trial_case_t) :: case
      real(dp), parameter :: step = 1.0e-4_dp
      real(dp) :: displacements(2), slope

      call new_ball(case, 0.6_dp - step)
      call solve(case)
      displacements(1) = case%found('tangential_displacement')
      call new_ball(case, 0.6_dp + step)
      call solve(case)
      displacements(2) = case%found('tangential_displacement')
      slope = 2*step*mu*load/(displacements(2) - displacements(1))
      call new_ball(case, 0.6_dp)
      call solve(case)
#line 258 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertRelativelyEqual(slope, case%found('tangential_stiffness'), tolerance=step**2, &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 258) )
  if (anyExceptions()) return
#line 259 "/work/main/tests/classical/classical_hertz_slip.pf"
   end subroutine test_slope

   !@test
   subroutine test_small_force()
      ! W = T^3/(9 mu P a G*), and the stiffness 2 G* a of what sticks
      type(trial_case_t) :: case
      real(dp) :: shear, force
      real(dp), parameter :: tau = 1.0e-9_dp

      call new_ball(case, tau)
      call solve(case)
      shear = 4/(2 - nu)*young/(2*(1 + nu))
      force = tau*mu*load
      associate (a => case%found('contact_half_width'))
#line 273 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertRelativelyEqual(force**3/(9*mu*load*a*shear), case%found('cycle_energy'), tolerance=2*tau, &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 273) )
  if (anyExceptions()) return
#line 274 "/work/main/tests/classical/classical_hertz_slip.pf"
#line 274 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertRelativelyEqual(force/(2*shear*a), case%found('tangential_displacement'), tolerance=2*tau, &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 274) )
  if (anyExceptions()) return
#line 275 "/work/main/tests/classical/classical_hertz_slip.pf"
      end associate
   end subroutine test_small_force

   !@test
   subroutine test_two_bodies()
      ! two bodies alike give way twice as much as one, and a contact modulus with Poisson's ratio is either
      type(trial_case_t) :: one, two, given
      character(*), parameter :: names(3) = [character(23) :: 'tangential_displacement', 'cycle_energy', 'stick_fraction']
      integer :: i

      call new_ball(two, 0.5_dp)
      call two%give('second_young_modulus', young)
      call two%give('second_poisson_ratio', nu)
      call solve(two)
      call new_ball(given, 0.5_dp)
      given%values(given%model%index_of('solid', 'young_modulus')) = unset
      call given%give('contact_modulus', young/(2*(1 - nu**2)))
      call solve(given)
      call new_ball(one, 0.5_dp)
      one%values(one%model%index_of('solid', 'young_modulus')) = young/2
      call solve(one)
      do i = 1, size(names)
#line 297 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertRelativelyEqual(one%found(trim(names(i))), two%found(trim(names(i))), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 297) )
  if (anyExceptions()) return
#line 298 "/work/main/tests/classical/classical_hertz_slip.pf"
#line 298 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertRelativelyEqual(one%found(trim(names(i))), given%found(trim(names(i))), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 298) )
  if (anyExceptions()) return
#line 299 "/work/main/tests/classical/classical_hertz_slip.pf"
      end do
   end subroutine test_two_bodies

   !@test
   subroutine test_signs_and_ends()
      type(trial_case_t) :: there, back

      call new_ball(there, 0.5_dp)
      call solve(there)
      call new_ball(back, -0.5_dp)
      call solve(back)
#line 310 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertEqual(-there%found('tangential_displacement'), back%found('tangential_displacement'), &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 310) )
  if (anyExceptions()) return
#line 311 "/work/main/tests/classical/classical_hertz_slip.pf"
#line 311 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertEqual(there%found('cycle_energy'), back%found('cycle_energy'), &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 311) )
  if (anyExceptions()) return
#line 312 "/work/main/tests/classical/classical_hertz_slip.pf"
      ! no force, all of it, and more
      call new_ball(there, 0.0_dp)
      call solve(there)
#line 315 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertEqual(1.0_dp, there%found('stick_fraction'), &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 315) )
  if (anyExceptions()) return
#line 316 "/work/main/tests/classical/classical_hertz_slip.pf"
#line 316 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertEqual(0.0_dp, there%found('cycle_energy'), &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 316) )
  if (anyExceptions()) return
#line 317 "/work/main/tests/classical/classical_hertz_slip.pf"
      call new_ball(there, 1.0_dp)
      call solve(there)
#line 319 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertEqual(0.0_dp, there%found('stick_fraction'), tolerance=epsilon(1.0_dp), &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 319) )
  if (anyExceptions()) return
#line 320 "/work/main/tests/classical/classical_hertz_slip.pf"
      call new_ball(there, 1.001_dp)
#line 321 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertEqual('', there%problems_of(), &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 321) )
  if (anyExceptions()) return
#line 322 "/work/main/tests/classical/classical_hertz_slip.pf"
      call there%solve()
#line 323 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertEqual(status_no_equilibrium, there%status(1), &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 323) )
  if (anyExceptions()) return
#line 324 "/work/main/tests/classical/classical_hertz_slip.pf"
#line 324 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertTrue(all(ieee_is_nan(there%results)), &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 324) )
  if (anyExceptions()) return
#line 325 "/work/main/tests/classical/classical_hertz_slip.pf"
      ! without a load nothing sticks, and no force is held
      call new_ball(there, 0.0_dp)
      call there%give('load', 0.0_dp)
      call solve(there)
#line 329 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertTrue(ieee_is_nan(there%found('stick_fraction')), &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 329) )
  if (anyExceptions()) return
#line 330 "/work/main/tests/classical/classical_hertz_slip.pf"
      call new_ball(there, 1.0e-6_dp)
      call there%give('load', 0.0_dp)
      call there%solve()
#line 333 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertEqual(status_no_equilibrium, there%status(1), &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 333) )
  if (anyExceptions()) return
#line 334 "/work/main/tests/classical/classical_hertz_slip.pf"
   end subroutine test_signs_and_ends

   !@test
   subroutine test_profiles()
      type(trial_case_t) :: case
      real(dp), allocatable :: profiles(:, :, :)
      integer, parameter :: n = 41

      call new_ball(case, -0.5_dp)
      call case%give('profiles', 1.0_dp)
      call case%give('x_min', -2.0e-4_dp)
      call case%give('x_max', 2.0e-4_dp)
      call case%give('n_x', real(n, dp))
      call solve(case)
      call case%get_profiles(profiles)
#line 349 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertEqual(3, size(profiles, 3), &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 349) )
  if (anyExceptions()) return
#line 350 "/work/main/tests/classical/classical_hertz_slip.pf"
      associate (q => profiles(:, 1, 3), p => profiles(:, 1, 1))
#line 351 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertTrue(all(q <= 0), &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 351) )
  if (anyExceptions()) return
#line 352 "/work/main/tests/classical/classical_hertz_slip.pf"
#line 352 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertTrue(all(abs(q) <= mu*p*(1 + closed_form)), &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 352) )
  if (anyExceptions()) return
#line 353 "/work/main/tests/classical/classical_hertz_slip.pf"
         ! slip at the edge, less than friction in the middle
#line 354 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertLessThan(abs(q(n/2 + 1)), mu*p(n/2 + 1)/2, &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 354) )
  if (anyExceptions()) return
#line 355 "/work/main/tests/classical/classical_hertz_slip.pf"
#line 355 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertTrue(any(abs(q) > 0 .and. abs(abs(q) - mu*p) <= closed_form*mu*p), &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 355) )
  if (anyExceptions()) return
#line 356 "/work/main/tests/classical/classical_hertz_slip.pf"
      end associate
      ! without friction there are two
      call case%give('coefficient', unset)
      call case%give('tangential_force', unset)
      call solve(case)
      call case%get_profiles(profiles)
#line 362 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertEqual(2, size(profiles, 3), &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 362) )
  if (anyExceptions()) return
#line 363 "/work/main/tests/classical/classical_hertz_slip.pf"
   end subroutine test_profiles

   !@test
   subroutine test_refusals()
      type(trial_case_t) :: case

      call new_ball(case, 0.5_dp)
      call case%give('tangential_force', unset)
#line 371 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertTrue(index(case%problems_of(), '&operating tangential_force: is missing') > 0, &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 371) )
  if (anyExceptions()) return
#line 372 "/work/main/tests/classical/classical_hertz_slip.pf"
      call new_ball(case, 0.5_dp)
      call case%give('coefficient', unset)
#line 374 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertTrue(index(case%problems_of(), '&friction coefficient: is missing [-]; tangential_force needs it') > 0, &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 374) )
  if (anyExceptions()) return
#line 375 "/work/main/tests/classical/classical_hertz_slip.pf"
      call new_ball(case, 0.5_dp)
      call case%give('tangential_axis', along_minor)
#line 377 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertTrue(index(case%problems_of(), '&operating tangential_axis: has no meaning for this kind') > 0, &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 377) )
  if (anyExceptions()) return
#line 378 "/work/main/tests/classical/classical_hertz_slip.pf"
      call case%give('coefficient', unset)
      call case%give('tangential_force', unset)
#line 380 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertTrue(index(case%problems_of(), '&operating tangential_axis: has no meaning without &friction') > 0, &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 380) )
  if (anyExceptions()) return
#line 381 "/work/main/tests/classical/classical_hertz_slip.pf"
      call new_ball(case, 0.5_dp)
      case%values(case%model%index_of('solid', 'young_modulus')) = unset
      case%values(case%model%index_of('solid', 'poisson_ratio')) = unset
      call case%give('contact_modulus', young)
#line 385 "/work/main/tests/classical/classical_hertz_slip.pf"
  call assertTrue(index(case%problems_of(), '&solid poisson_ratio: is missing [-]; the tangential displacement') > 0, &
 & location=SourceLocation( &
 & 'classical_hertz_slip.pf', &
 & 385) )
  if (anyExceptions()) return
#line 386 "/work/main/tests/classical/classical_hertz_slip.pf"
   end subroutine test_refusals

end module classical_hertz_slip

module Wrapclassical_hertz_slip
   use FUnit
   use classical_hertz_slip
   implicit none
   private

contains


end module Wrapclassical_hertz_slip

function classical_hertz_slip_suite() result(suite)
   use FUnit
   use classical_hertz_slip
   use Wrapclassical_hertz_slip
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('classical_hertz_slip_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_sphere_table', &
      test_sphere_table))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_line_table', &
      test_line_table))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_ellipse_table', &
      test_ellipse_table))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_traction_table', &
      test_traction_table))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_force_of_tractions', &
      test_force_of_tractions))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_loop', &
      test_loop))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_slope', &
      test_slope))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_small_force', &
      test_small_force))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_two_bodies', &
      test_two_bodies))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_signs_and_ends', &
      test_signs_and_ends))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_profiles', &
      test_profiles))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_refusals', &
      test_refusals))
   call suite%addTest(t)


end function classical_hertz_slip_suite


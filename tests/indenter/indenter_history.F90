! SPDX-License-Identifier: GPL-3.0-or-later
! Histories of tangential loading: tables in displacements and forces, loops, a straight step against the same step in many
! parts and against springs that are followed in small steps, the energy of a cycle, lift-off, other units, and what is refused.
module indenter_history
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_problems, only: problems_t
   use adfric_indenter_history_model
   use adfric_indenter_model, only: indenter_model_t
   use adfric_indenter_variables
   use adfric_model_status, only: status_solved, status_no_equilibrium
   use indenter_cases, only: new_indenter, hold
   use model_calls, only: find_problems, solve_point
   use random_dice, only: dice_t, new_dice
   use reference_table, only: table_t, read_table, table_digits
   use funit
   implicit none (type, external)

   real(dp), parameter :: mu = 0.3_dp
   !> (2 - nu)/(2 (1 - nu)) = 5/4.
   real(dp), parameter :: nu = 1/3.0_dp, ratio = 1.25_dp

contains

   !> A model of a kind of unit modulus without a path.
   subroutine new_model(model, values, kind)
      type(history_model_t), intent(out) :: model
      real(dp), allocatable, intent(out) :: values(:)
      character(*), intent(in) :: kind

      call new_history_model(model)
      values = model%variables%default
      values([v_contact_modulus, v_poisson_ratio, h_coefficient]) = [1.0_dp, nu, mu]
      select case (kind)
      case ('sphere')
         values([v_kind, v_radius]) = [real(kind_paraboloid, dp), 1.0_dp]
      case ('flat_cone')
         values([v_kind, v_face_radius, v_slope]) = [real(kind_flat_cone, dp), 0.4_dp, 0.3_dp]
      case ('rounded_cone')
         values([v_kind, v_radius, v_slope]) = [real(kind_rounded_cone, dp), 1.0_dp, 0.3_dp]
      case ('flat')
         values([v_kind, v_face_radius]) = [real(kind_flat, dp), 0.4_dp]
      case default
         values([v_kind, v_slope]) = [real(kind_cone, dp), 0.3_dp]
      end select
   end subroutine new_model

   !> Give a path and go through it.
   subroutine follow(model, values, places, normal, tangential, steps, label)
      type(history_model_t), intent(inout) :: model
      real(dp), intent(inout) :: values(:)
      integer, intent(in) :: places(2)
      real(dp), intent(in) :: normal(:), tangential(:)
      real(dp), allocatable, intent(out) :: steps(:, :)
      character(*), intent(in) :: label
      real(dp) :: results(n_history_results), error_estimate
      real(dp), allocatable :: profiles(:, :, :)
      integer :: status

      call give_path(model, values, places, normal, tangential)
#line 61 "/work/main/tests/indenter/indenter_history.pf"
  call assertEqual('', find_problems(model, values), message=label, &
 & location=SourceLocation( &
 & 'indenter_history.pf', &
 & 61) )
  if (anyExceptions()) return
#line 62 "/work/main/tests/indenter/indenter_history.pf"
      call solve_point(model, values, results, error_estimate, status)
#line 63 "/work/main/tests/indenter/indenter_history.pf"
  call assertEqual(status_solved, status, message=label, &
 & location=SourceLocation( &
 & 'indenter_history.pf', &
 & 63) )
  if (anyExceptions()) return
#line 64 "/work/main/tests/indenter/indenter_history.pf"
      allocate (profiles(size(normal), 1, n_history_profiles))
      call model%solve_profiles(values, results, profiles)
      steps = profiles(:, 1, :)
#line 67 "/work/main/tests/indenter/indenter_history.pf"
  call assertEqual(results(r_total_loss), steps(size(normal), p_friction_loss), message=label, &
 & location=SourceLocation( &
 & 'indenter_history.pf', &
 & 67) )
  if (anyExceptions()) return
#line 68 "/work/main/tests/indenter/indenter_history.pf"
   end subroutine follow

   !> Give a path.
   subroutine give_path(model, values, places, normal, tangential)
      type(history_model_t), intent(inout) :: model
      real(dp), intent(inout) :: values(:)
      integer, intent(in) :: places(2)
      real(dp), intent(in) :: normal(:), tangential(:)
      type(problems_t) :: problems

      values(h_loads:h_tangential_displacements) = model%variables(h_loads:h_tangential_displacements)%default
      values(places) = 1
      call model%take_dataset(places(1), reshape(normal, [size(normal), 1]), problems)
      call model%take_dataset(places(2), reshape(tangential, [size(tangential), 1]), problems)
   end subroutine give_path

   ! Five paths of three shapes in approach and displacement.
   !@test
   subroutine test_displacements()
      type(table_t) :: table
      type(history_model_t) :: model
      real(dp), allocatable :: values(:), steps(:, :), normal(:), tangential(:)
      integer :: row, last, k

      call read_table(table, 'slip_history')
#line 93 "/work/main/tests/indenter/indenter_history.pf"
  call assertGreaterThan(table%n_rows, 50, &
 & location=SourceLocation( &
 & 'indenter_history.pf', &
 & 93) )
  if (anyExceptions()) return
#line 94 "/work/main/tests/indenter/indenter_history.pf"
      row = 1
      do while (row <= table%n_rows)
         last = row
         do while (last < table%n_rows)
            if (table%number(last + 1, 'step') < 1.5_dp) exit
            last = last + 1
         end do
         normal = [(table%number(k, 'delta'), k=row, last)]
         tangential = [(table%number(k, 'u'), k=row, last)]
         call new_model(model, values, table%text(row, 'kind'))
         call follow(model, values, [h_approaches, h_tangential_displacements], normal, tangential, steps, table%label(row))
         do k = row, last
#line 106 "/work/main/tests/indenter/indenter_history.pf"
  call assertRelativelyEqual(table%number(k, 'P'), steps(k - row + 1, p_load), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_history.pf', &
 & 106) )
  if (anyExceptions()) return
#line 107 "/work/main/tests/indenter/indenter_history.pf"
#line 107 "/work/main/tests/indenter/indenter_history.pf"
  call assertEqual(table%number(k, 'T'), steps(k - row + 1, p_tangential_force), tolerance=table_digits*0.04_dp, &
 & location=SourceLocation( &
 & 'indenter_history.pf', &
 & 107) )
  if (anyExceptions()) return
#line 108 "/work/main/tests/indenter/indenter_history.pf"
         end do
         row = last + 1
      end do
   end subroutine test_displacements

   ! Load and force together, the load first, together and then the force alone; Hertz's sphere.
   !@test
   subroutine test_forces()
      type(table_t) :: table
      type(history_model_t) :: model
      real(dp), allocatable :: values(:), steps(:, :)
      real(dp) :: slope, full, load, expected
      integer :: row, n_compared

      call read_table(table, 'slip_history_force')
      load = 4.0e-3_dp/3
      full = mu*ratio*1.0e-2_dp
      n_compared = 0
      do row = 1, table%n_rows
         call new_model(model, values, 'sphere')
         slope = mu*table%number(row, 'k_over_mu')
         select case (table%text(row, 'case'))
         case ('together')
            call follow(model, values, [h_loads, h_tangential_forces], [load], [slope*load], steps, table%label(row))
         case ('load_first')
            call follow(model, values, [h_loads, h_tangential_forces], [load, load], [0.0_dp, slope*load], steps, table%label(row))
         case ('together_then_T')
            call follow(model, values, [h_loads, h_tangential_forces], [load, load], &
               & [slope, mu*table%number(row, 'tau')]*load, steps, table%label(row))
         case default
            ! without slip whatever the force: not Coulomb's friction
            cycle
         end select
         n_compared = n_compared + 1
         expected = table%number(row, 'u_over_U0')*full
         associate (last => steps(size(steps, 1), :))
            ! close to sliding u goes by round-off of T to the power 2/3
#line 145 "/work/main/tests/indenter/indenter_history.pf"
  call assertRelativelyEqual(expected, last(p_tangential_displacement), tolerance=1.0e-10_dp, &
 & location=SourceLocation( &
 & 'indenter_history.pf', &
 & 145) )
  if (anyExceptions()) return
#line 146 "/work/main/tests/indenter/indenter_history.pf"
            expected = table%number(row, 'stick')*0.1_dp
#line 147 "/work/main/tests/indenter/indenter_history.pf"
  call assertEqual(expected, last(p_stick_radius), tolerance=1.0e-6_dp, &
 & location=SourceLocation( &
 & 'indenter_history.pf', &
 & 147) )
  if (anyExceptions()) return
#line 148 "/work/main/tests/indenter/indenter_history.pf"
         end associate
      end do
#line 150 "/work/main/tests/indenter/indenter_history.pf"
  call assertEqual(16, n_compared, &
 & location=SourceLocation( &
 & 'indenter_history.pf', &
 & 150) )
  if (anyExceptions()) return
#line 151 "/work/main/tests/indenter/indenter_history.pf"
   end subroutine test_forces

   ! Loops of Mindlin and Deresiewicz: unloading from T to -T and back, with what a cycle takes.
   !@test
   subroutine test_loops()
      type(table_t) :: table
      type(history_model_t) :: model
      type(indenter_model_t) :: indenter
      real(dp), allocatable :: values(:), steps(:, :), forces(:), slip_values(:)
      real(dp) :: load, full, results(n_indenter_results), error_estimate, expected, largest
      integer :: row, first, k, status

      call read_table(table, 'slip_sphere_loop')
      load = 4.0e-3_dp/3
      full = mu*ratio*1.0e-2_dp
      call new_model(model, values, 'sphere')
      call new_indenter(indenter, slip_values, kind_paraboloid)
      slip_values([v_radius, v_contact_modulus, v_poisson_ratio]) = [1.0_dp, 1.0_dp, nu]
      call hold(slip_values, v_load, load)
      row = 1
      do while (row <= table%n_rows)
         first = row
         do while (row < table%n_rows)
            if (abs(table%number(row + 1, 'tau_max') - table%number(first, 'tau_max')) > 0) exit
            row = row + 1
         end do
         largest = table%number(first, 'tau_max')
         ! the table begins at the largest force; the loop is closed
         forces = mu*load*[0.0_dp, (table%number(k, 'T'), k=first, row), largest]
         call follow(model, values, [h_loads, h_tangential_forces], [(load, k=1, size(forces))], forces, steps, table%label(row))
         do k = first, row
            expected = table%number(k, 'u')*full
#line 183 "/work/main/tests/indenter/indenter_history.pf"
  call assertEqual(expected, steps(k - first + 2, p_tangential_displacement), tolerance=1.0e-10_dp*full, &
 & location=SourceLocation( &
 & 'indenter_history.pf', &
 & 183) )
  if (anyExceptions()) return
#line 184 "/work/main/tests/indenter/indenter_history.pf"
         end do
         slip_values([v_friction_coefficient, v_tangential_force]) = [mu, mu*load*largest]
         call solve_point(indenter, slip_values, results, error_estimate, status)
#line 187 "/work/main/tests/indenter/indenter_history.pf"
  call assertEqual(status_solved, status, &
 & location=SourceLocation( &
 & 'indenter_history.pf', &
 & 187) )
  if (anyExceptions()) return
#line 188 "/work/main/tests/indenter/indenter_history.pf"
         expected = steps(size(forces), p_friction_loss)
         ! the first loading takes a quarter of a cycle
#line 190 "/work/main/tests/indenter/indenter_history.pf"
  call assertRelativelyEqual(1.25_dp*results(r_cycle_energy), expected, tolerance=1.0e-9_dp, &
 & location=SourceLocation( &
 & 'indenter_history.pf', &
 & 190) )
  if (anyExceptions()) return
#line 191 "/work/main/tests/indenter/indenter_history.pf"
         row = row + 1
      end do
   end subroutine test_loops

   ! A straight step is the same as in many parts, in state and energy: random paths in forces and in displacements, with
   ! lift-off in the latter, of every sort of shape.
   !@test
   subroutine test_parts()
      character(*), parameter :: kinds(5) = [character(12) :: 'sphere', 'cone', 'flat_cone', 'rounded_cone', 'flat']
      integer, parameter :: n = 40, parts = 16
      type(history_model_t) :: model
      type(dice_t) :: dice
      real(dp), allocatable :: values(:), whole(:, :), divided(:, :)
      real(dp) :: normal(n), tangential(n), fine(2, n*parts), before(2), share, fair, size_of(n_history_profiles)
      character(80) :: label
      integer :: kind, path, k, i, j, places(2)

      call new_dice(dice, 20261123)
      do kind = 1, size(kinds)
         do path = 1, 60
            call new_model(model, values, trim(kinds(kind)))
            before = 0
            do k = 1, n
               call dice%between(0.0_dp, 0.1_dp, normal(k))
               call dice%between(-1.0_dp, 1.0_dp, share)
               if (mod(path, 2) == 0) then
                  tangential(k) = share*mu*normal(k)
                  ! some along the bound, some back along the way
                  if (share > 0.9_dp) tangential(k) = mu*normal(k)
                  if (share < -0.9_dp .and. k > 2) normal(k) = normal(k - 2)
                  if (share < -0.9_dp .and. k > 2) tangential(k) = tangential(k - 2)
               else
                  tangential(k) = share*0.06_dp
                  if (share > 0.9_dp) normal(k) = -0.02_dp
               end if
               do i = 1, parts
                  fine(:, (k - 1)*parts + i) = before + ([normal(k), tangential(k)] - before)*i/parts
               end do
               fine(:, k*parts) = [normal(k), tangential(k)]
               before = [normal(k), tangential(k)]
            end do
            places = merge([h_loads, h_tangential_forces], [h_approaches, h_tangential_displacements], mod(path, 2) == 0)
            write (label, '(2a, i0)') kinds(kind), ' path ', path
            call follow(model, values, places, normal, tangential, whole, label)
            call follow(model, values, places, fine(1, :), fine(2, :), divided, label)
            size_of = maxval(abs(whole), 1)
            ! of a face that slides as a whole next to nothing is lost
            size_of(p_friction_loss) = size_of(p_tangential_force)*size_of(p_tangential_displacement)
            do j = 1, n_history_profiles
               if (j == p_stick_radius) cycle
               ! close to sliding a force has the displacement by the root of round-off
               fair = merge(1.0e-8_dp, 1.0e-10_dp, mod(path, 2) == 0 .and. any(j == [p_tangential_displacement, p_friction_loss]))
               do k = 1, n
#line 244 "/work/main/tests/indenter/indenter_history.pf"
  call assertEqual(divided(k*parts, j), whole(k, j), tolerance=fair*size_of(j), message=label, &
 & location=SourceLocation( &
 & 'indenter_history.pf', &
 & 244) )
  if (anyExceptions()) return
#line 245 "/work/main/tests/indenter/indenter_history.pf"
               end do
            end do
         end do
      end do
   end subroutine test_parts

   ! Springs of the reduced model, each followed in small steps with Coulomb's law of its own: force and energy.
   !@test
   subroutine test_springs()
      integer, parameter :: n_springs = 1000, n_small = 2000
      real(dp), parameter :: normal(6) = [0.1_dp, 0.15_dp, 0.05_dp, 0.05_dp, 0.12_dp, 0.03_dp]
      real(dp), parameter :: tangential(6) = [0.01_dp, 0.05_dp, 0.03_dp, -0.02_dp, 0.0_dp, 0.02_dp]
      type(history_model_t) :: model
      real(dp), allocatable :: values(:), steps(:, :)
      real(dp) :: place(n_springs), depth(n_springs), reach(n_springs), bound(n_springs), trial(n_springs)
      real(dp) :: approach, before(2), change(2), loss, force, width
      integer :: k, i

      call new_model(model, values, 'sphere')
      call follow(model, values, [h_approaches, h_tangential_displacements], normal, tangential, steps, 'springs')
      width = sqrt(maxval(normal))/n_springs
      place = [((i - 0.5_dp)*width, i=1, n_springs)]
      depth = place**2
      reach = 0
      loss = 0
      before = 0
      do k = 1, size(normal)
         change = ([normal(k), tangential(k)] - before)/n_small
         do i = 1, n_small
            approach = before(1) + change(1)*i
            bound = mu*ratio*max(approach - depth, 0.0_dp)
            trial = merge(reach + change(2), 0.0_dp, approach > depth)
            reach = max(-bound, min(bound, trial))
            loss = loss + 2/ratio*width*sum(bound*abs(trial - reach))
         end do
         before = [normal(k), tangential(k)]
         force = 2/ratio*width*sum(reach)
#line 282 "/work/main/tests/indenter/indenter_history.pf"
  call assertEqual(force, steps(k, p_tangential_force), tolerance=1.0e-4_dp*0.01_dp, &
 & location=SourceLocation( &
 & 'indenter_history.pf', &
 & 282) )
  if (anyExceptions()) return
#line 283 "/work/main/tests/indenter/indenter_history.pf"
#line 283 "/work/main/tests/indenter/indenter_history.pf"
  call assertEqual(loss, steps(k, p_friction_loss), tolerance=1.0e-3_dp*steps(size(normal), p_friction_loss), &
 & location=SourceLocation( &
 & 'indenter_history.pf', &
 & 283) )
  if (anyExceptions()) return
#line 284 "/work/main/tests/indenter/indenter_history.pf"
      end do
   end subroutine test_springs

   ! A mixture: displacement at constant load is the loop under forces.
   !@test
   subroutine test_mixture()
      type(history_model_t) :: model
      real(dp), allocatable :: values(:), steps(:, :), others(:, :)
      real(dp), parameter :: loads(5) = [1.0_dp, 1.0_dp, 1.0_dp, 1.0_dp, 0.5_dp]*1.0e-3_dp
      integer :: k

      call new_model(model, values, 'rounded_cone')
      call follow(model, values, [h_loads, h_tangential_forces], loads, mu*loads*[0.0_dp, 0.7_dp, -0.4_dp, 0.6_dp, 1.0_dp], &
         & steps, 'forces')
      call new_model(model, values, 'rounded_cone')
      call follow(model, values, [h_loads, h_tangential_displacements], loads(:4), steps(:4, p_tangential_displacement), others, &
         & 'mixture')
      do k = 1, 4
#line 302 "/work/main/tests/indenter/indenter_history.pf"
  call assertEqual(steps(k, p_tangential_force), others(k, p_tangential_force), tolerance=1.0e-12_dp*mu*1.0e-3_dp, &
 & location=SourceLocation( &
 & 'indenter_history.pf', &
 & 302) )
  if (anyExceptions()) return
#line 303 "/work/main/tests/indenter/indenter_history.pf"
#line 303 "/work/main/tests/indenter/indenter_history.pf"
  call assertEqual(steps(k, p_friction_loss), others(k, p_friction_loss), tolerance=1.0e-10_dp*steps(4, p_friction_loss), &
 & location=SourceLocation( &
 & 'indenter_history.pf', &
 & 303) )
  if (anyExceptions()) return
#line 304 "/work/main/tests/indenter/indenter_history.pf"
      end do
   end subroutine test_mixture

   ! Lengths by 1e-6, stresses by 1e9.
   !@test
   subroutine test_units()
      real(dp), parameter :: units(n_history_profiles) = 10.0_dp**[-3, -6, -3, -6, -6, -6, -9]
      real(dp), parameter :: approaches(4) = [0.1_dp, 0.2_dp, 0.2_dp, 0.05_dp]
      real(dp), parameter :: displacements(4) = [0.0_dp, 0.04_dp, -0.03_dp, 0.01_dp]
      type(history_model_t) :: model
      real(dp), allocatable :: values(:), steps(:, :), scaled(:, :)
      integer :: j, k

      call new_model(model, values, 'flat_cone')
      call follow(model, values, [h_approaches, h_tangential_displacements], approaches, displacements, steps, 'unit')
      call new_model(model, values, 'flat_cone')
      values([v_contact_modulus, v_face_radius]) = [1.0e9_dp, 0.4e-6_dp]
      call follow(model, values, [h_approaches, h_tangential_displacements], 1.0e-6_dp*approaches, &
         & 1.0e-6_dp*displacements, scaled, 'other units')
      do j = 1, n_history_profiles
         do k = 1, 4
#line 325 "/work/main/tests/indenter/indenter_history.pf"
  call assertEqual(units(j)*steps(k, j), scaled(k, j), tolerance=1.0e-12_dp*units(j)*maxval(abs(steps(:, j))), &
 & location=SourceLocation( &
 & 'indenter_history.pf', &
 & 325) )
  if (anyExceptions()) return
#line 326 "/work/main/tests/indenter/indenter_history.pf"
         end do
      end do
   end subroutine test_units

   ! A swept coefficient may make a force too large at a point; lists that do not belong together are refused.
   !@test
   subroutine test_refusals()
      type(history_model_t) :: model
      real(dp), allocatable :: values(:)
      real(dp) :: results(n_history_results), error_estimate
      integer :: status

      call new_model(model, values, 'cone')
#line 339 "/work/main/tests/indenter/indenter_history.pf"
  call assertTrue(index(find_problems(model, values), '&history loads: is missing [N]') > 0, &
 & location=SourceLocation( &
 & 'indenter_history.pf', &
 & 339) )
  if (anyExceptions()) return
#line 340 "/work/main/tests/indenter/indenter_history.pf"
      call give_path(model, values, [h_loads, h_tangential_forces], [1.0_dp, 1.0_dp], [0.1_dp, 0.31_dp])
#line 341 "/work/main/tests/indenter/indenter_history.pf"
  call assertTrue(index(find_problems(model, values), 'is 0.31 N at step 2, more than mu P') > 0, &
 & location=SourceLocation( &
 & 'indenter_history.pf', &
 & 341) )
  if (anyExceptions()) return
#line 342 "/work/main/tests/indenter/indenter_history.pf"
      call solve_point(model, values, results, error_estimate, status)
#line 343 "/work/main/tests/indenter/indenter_history.pf"
  call assertEqual(status_no_equilibrium, status, &
 & location=SourceLocation( &
 & 'indenter_history.pf', &
 & 343) )
  if (anyExceptions()) return
#line 344 "/work/main/tests/indenter/indenter_history.pf"
      call give_path(model, values, [h_loads, h_tangential_forces], [1.0_dp, 1.0_dp], [0.1_dp])
#line 345 "/work/main/tests/indenter/indenter_history.pf"
  call assertTrue(index(find_problems(model, values), 'has 1 values, and loads has 2') > 0, &
 & location=SourceLocation( &
 & 'indenter_history.pf', &
 & 345) )
  if (anyExceptions()) return
#line 346 "/work/main/tests/indenter/indenter_history.pf"
      call give_path(model, values, [h_loads, h_tangential_displacements], [1.0_dp, 2.0_dp], [0.0_dp, 0.31_dp])
#line 347 "/work/main/tests/indenter/indenter_history.pf"
  call assertTrue(index(find_problems(model, values), 'changes at step 2 together with loads') > 0, &
 & location=SourceLocation( &
 & 'indenter_history.pf', &
 & 347) )
  if (anyExceptions()) return
#line 348 "/work/main/tests/indenter/indenter_history.pf"
      call give_path(model, values, [h_loads, h_tangential_forces], [0.0_dp], [0.0_dp])
#line 349 "/work/main/tests/indenter/indenter_history.pf"
  call assertTrue(index(find_problems(model, values), 'never presses') > 0, &
 & location=SourceLocation( &
 & 'indenter_history.pf', &
 & 349) )
  if (anyExceptions()) return
#line 350 "/work/main/tests/indenter/indenter_history.pf"
      values(h_approaches) = 1
#line 351 "/work/main/tests/indenter/indenter_history.pf"
  call assertTrue(index(find_problems(model, values), 'stands beside approaches') > 0, &
 & location=SourceLocation( &
 & 'indenter_history.pf', &
 & 351) )
  if (anyExceptions()) return
#line 352 "/work/main/tests/indenter/indenter_history.pf"
   end subroutine test_refusals

end module indenter_history

module Wrapindenter_history
   use FUnit
   use indenter_history
   implicit none
   private

contains


end module Wrapindenter_history

function indenter_history_suite() result(suite)
   use FUnit
   use indenter_history
   use Wrapindenter_history
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('indenter_history_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_displacements', &
      test_displacements))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_forces', &
      test_forces))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_loops', &
      test_loops))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_parts', &
      test_parts))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_springs', &
      test_springs))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_mixture', &
      test_mixture))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_units', &
      test_units))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_refusals', &
      test_refusals))
   call suite%addTest(t)


end function indenter_history_suite


! Adhesion on cells at given penetrations: the exact wave on both branches, the loop that approach and parting lose, states that no
! load holds, and the way back from a load to its penetration.
module periodic_penetration
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_classical_adhesive_wave_load, only: branch_approach, branch_adhered
   use adfric_classical_adhesive_wave_units, only: wave_adhesion_case_t, wave_adhesion_state_t, &
      & new_wave_adhesion
   use adfric_periodic_adhesive_penetration, only: solve_adhesive_penetration
   use adfric_periodic_adhesive_solver, only: periodic_adhesion_t, solve_adhesive_load
   use adfric_periodic_cohesion, only: cohesion_t, new_cohesion
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_solver, only: periodic_solver_t, periodic_solution_t, new_periodic_solver, contact_solved, &
      & contact_out_of_range
   use reference_table, only: table_t, read_table
   use trial_surfaces, only: rough_surface
   use funit
   implicit none (type, external)

   real(dp), parameter :: pi = 3.14159265358979323846264338328_dp, tolerance = 1.0e-10_dp

contains

   !> 1 - cos 2 pi x on a line of n cells, less its least value, which is received, and its solver.
   subroutine make_line(n, solver, shape, lowest)
      integer, intent(in) :: n
      type(periodic_solver_t), intent(out) :: solver
      real(dp), allocatable, intent(out) :: shape(:, :)
      real(dp), intent(out) :: lowest
      integer :: i

      allocate (shape(n, 1))
      shape(:, 1) = [(1 - cos(2*pi*(i - 0.5_dp)/n), i=1, n)]
      lowest = minval(shape)
      shape(:, :) = shape - lowest
      call make_solver([n, 1], solver)
   end subroutine make_line

   !> A rough surface of n x n cells, and its solver.
   subroutine make_rough(n, seed, solver, shape)
      integer, intent(in) :: n, seed
      type(periodic_solver_t), intent(out) :: solver
      real(dp), allocatable, intent(out) :: shape(:, :)

      shape = 0.1_dp*rough_surface(n, n, seed)
      shape = shape - minval(shape)
      call make_solver([n, n], solver)
   end subroutine make_rough

   !> A solver for a period of 1.
   subroutine make_solver(n_cells, solver)
      integer, intent(in) :: n_cells(2)
      type(periodic_solver_t), intent(out) :: solver
      type(error_t), allocatable :: error

      call new_periodic_solver(solver, elastic_kernel_t(), n_cells, [1.0_dp, 1.0_dp], .false., error)
#line 57 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertFalse(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 57) )
  if (anyExceptions()) return
#line 58 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
   end subroutine make_solver

   !> Solve at a penetration.
   subroutine solve(solver, shape, penetration, adhesion, solution)
      type(periodic_solver_t), intent(inout) :: solver
      real(dp), intent(in) :: shape(:, :), penetration
      type(periodic_adhesion_t), intent(in) :: adhesion
      type(periodic_solution_t), intent(out) :: solution
      type(error_t), allocatable :: error

      call solve_adhesive_penetration(solver, shape, penetration, adhesion, tolerance, solution, error)
#line 69 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertFalse(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 69) )
  if (anyExceptions()) return
#line 70 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
   end subroutine solve

   ! The exact wave in all its regimes and on both branches, but next to jumps: what no load holds, and no contact with what it
   ! is drawn by, among them. The errors fall with the cells.
   !@test
   subroutine test_wave()
      type(table_t) :: table
      type(periodic_solver_t) :: solver
      type(wave_adhesion_case_t) :: exact
      real(dp), allocatable :: shape(:, :)
      real(dp) :: lowest, errors(2)
      integer :: k, n, step, n_compared(2)
      logical :: is_possible, is_converged

      call read_table(table, 'adh_dugdale_wave_1d_penetration')
      errors = 0
      n_compared = 0
      do step = 1, 2
         n = 128*step
         call make_line(n, solver, shape, lowest)
         do k = 1, table%n_rows
            associate (stress => table%number(k, 'stress'), range => table%number(k, 'range'), &
                  & penetration => table%number(k, 'penetration'))
               ! a dozen cells in the zone on the coarser grid: (pi/4) range/stress
               if (range/(4*stress)*128 < 12 .or. penetration >= 1) cycle
               call new_wave_adhesion(exact, 1.0_dp, 1.0_dp, 1.0_dp, pi*stress, range, is_possible, is_converged)
#line 96 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertTrue(is_possible .and. is_converged, &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 96) )
  if (anyExceptions()) return
#line 97 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
               if (is_near_jump(exact, penetration)) cycle
               call compare(solver, shape, lowest, exact, penetration, branch_approach, table%number(k, 'mean_pressure'), &
                  & errors(step))
               call compare(solver, shape, lowest, exact, penetration, branch_adhered, huge(1.0_dp), errors(step))
               n_compared(step) = n_compared(step) + 2
            end associate
         end do
      end do
#line 105 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertGreaterThan(n_compared(1), 120, &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 105) )
  if (anyExceptions()) return
#line 106 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
#line 106 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertLessThan(errors(2), errors(1)/2, &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 106) )
  if (anyExceptions()) return
#line 107 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
   end subroutine test_wave

   !> Compare a state with the exact one, and that with the load of a table, unless it is huge.
   subroutine compare(solver, shape, lowest, exact, penetration, branch, tabulated, error)
      type(periodic_solver_t), intent(inout) :: solver
      real(dp), intent(in) :: shape(:, :), lowest, penetration, tabulated
      type(wave_adhesion_case_t), intent(in) :: exact
      integer, intent(in) :: branch
      real(dp), intent(inout) :: error
      type(periodic_solution_t) :: solution
      type(wave_adhesion_state_t) :: state
      logical :: is_converged

      associate (stress => exact%wave%stress, range => exact%wave%range)
         call exact%solve_penetration(penetration, branch, state, is_converged)
#line 122 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 122) )
  if (anyExceptions()) return
#line 123 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
         if (tabulated < huge(1.0_dp)) then
#line 124 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertEqual(tabulated, state%mean_pressure/pi, tolerance=1.0e-12_dp, &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 124) )
  if (anyExceptions()) return
#line 125 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
         end if
         call solve(solver, shape, penetration - lowest, periodic_adhesion_t(stress=pi*stress, range=range, &
            & is_adhered=branch == branch_adhered), solution)
#line 128 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertEqual(contact_solved, solution%status, &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 128) )
  if (anyExceptions()) return
#line 129 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
#line 129 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertEqual(state%mean_pressure/pi, solution%mean_pressure/pi, tolerance=0.5_dp*max(1.0_dp, stress)/size(shape), &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 129) )
  if (anyExceptions()) return
#line 130 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
#line 130 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertEqual(state%label_fraction, sum(solution%share)/size(shape), tolerance=3.0_dp/size(shape), &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 130) )
  if (anyExceptions()) return
#line 131 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
      end associate
      error = error + abs(state%mean_pressure - solution%mean_pressure)
   end subroutine compare

   !> Is a penetration within 0.01 D of a jump: in, off, to saturation, with or without contact, or from it?
   logical function is_near_jump(exact, penetration)
      type(wave_adhesion_case_t), intent(in) :: exact
      real(dp), intent(in) :: penetration

      associate (wave => exact%wave)
         is_near_jump = minval(abs(penetration - [-wave%range, 2 - wave%range, wave%least_penetration, wave%largest_penetration, &
            & wave%saturation_penetration])) < 0.01_dp
      end associate
   end function is_near_jump

   ! Around the loop of approach and parting the load does the work that its jumps lose, which the exact wave knows; between the
   ! jumps the energy of each branch is that of the work.
   !@test
   subroutine test_loop()
      integer, parameter :: n = 256, n_steps = 40
      real(dp), parameter :: stress = 0.3_dp, range = 0.3_dp, from = -0.45_dp, to = 0.99_dp
      type(wave_adhesion_case_t) :: exact
      type(periodic_solver_t) :: solver
      type(periodic_adhesion_t) :: adhesion
      real(dp), allocatable :: shape(:, :)
      real(dp) :: ends(3, 2), lowest, lost, work(2), loss
      logical :: is_possible, is_converged
      integer :: k, branch

      call make_line(n, solver, shape, lowest)
      lost = 0
      work = 0
      do branch = 1, 2
         adhesion = periodic_adhesion_t(stress=pi*stress, range=range, is_adhered=branch == 1)
         ends(:, 2) = state_at(solver, shape, from - lowest, adhesion)
         do k = 1, n_steps
            ends(:, 1) = ends(:, 2)
            ends(:, 2) = state_at(solver, shape, from - lowest + k*(to - from)/n_steps, adhesion)
            call add_work(solver, shape, adhesion, ends(:, 1), ends(:, 2), 7, work(branch), lost)
         end do
      end do
      call new_wave_adhesion(exact, 1.0_dp, 1.0_dp, 1.0_dp, pi*stress, range, is_possible, is_converged)
      call exact%loop_energy(loss, is_converged)
#line 174 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertTrue(is_possible .and. is_converged, &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 174) )
  if (anyExceptions()) return
#line 175 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
#line 175 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertRelativelyEqual(loss, work(2) - work(1), tolerance=0.02_dp, &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 175) )
  if (anyExceptions()) return
#line 176 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
#line 176 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertRelativelyEqual(loss, lost, tolerance=0.02_dp, &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 176) )
  if (anyExceptions()) return
#line 177 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
   end subroutine test_loop

   !> Penetration, load and energy of a state.
   function state_at(solver, shape, penetration, adhesion) result(state)
      type(periodic_solver_t), intent(inout) :: solver
      real(dp), intent(in) :: shape(:, :), penetration
      type(periodic_adhesion_t), intent(in) :: adhesion
      real(dp) :: state(3)
      type(periodic_solution_t) :: solution

      call solve(solver, shape, penetration, adhesion, solution)
#line 188 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertEqual(contact_solved, solution%status, &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 188) )
  if (anyExceptions()) return
#line 189 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
      state = [penetration, solution%mean_pressure, solution%elastic_energy + solution%adhesion_energy]
   end function state_at

   !> Add the work between two states, and what has been lost of it, in ever smaller steps where there is a loss.
   recursive subroutine add_work(solver, shape, adhesion, first, last, n_halvings, work, lost)
      type(periodic_solver_t), intent(inout) :: solver
      real(dp), intent(in) :: shape(:, :), first(3), last(3)
      type(periodic_adhesion_t), intent(in) :: adhesion
      integer, intent(in) :: n_halvings
      real(dp), intent(inout) :: work, lost
      real(dp) :: middle(3), here, loss

      here = (first(2) + last(2))/2*(last(1) - first(1))
      loss = merge(-1, 1, adhesion%is_adhered)*(here - (last(3) - first(3)))
      if (abs(loss) > 1.0e-5_dp .and. n_halvings > 0) then
         middle = state_at(solver, shape, (first(1) + last(1))/2, adhesion)
         call add_work(solver, shape, adhesion, first, middle, n_halvings - 1, work, lost)
         call add_work(solver, shape, adhesion, middle, last, n_halvings - 1, work, lost)
      else
#line 208 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertGreaterThan(loss, -2.0e-5_dp, &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 208) )
  if (anyExceptions()) return
#line 209 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
         work = work + here
         lost = lost + loss
      end if
   end subroutine add_work

   ! A state under a load is the state at its penetration, on rough surfaces too, unless it is next to a jump.
   !@test
   subroutine test_back_from_load()
      integer, parameter :: n = 32
      real(dp), parameter :: loads(*) = [0.002_dp, 0.02_dp, 0.06_dp]
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: held, solution
      type(periodic_adhesion_t) :: adhesion
      type(error_t), allocatable :: error
      real(dp), allocatable :: shape(:, :)
      integer :: i, seed, branch, n_equal

      n_equal = 0
      do seed = 1, 4
         call make_rough(n, seed, solver, shape)
         do branch = 1, 2
            adhesion = periodic_adhesion_t(stress=0.01_dp*seed, range=0.1_dp*maxval(shape), is_adhered=branch == 1)
            do i = 1, size(loads)
               call solve_adhesive_load(solver, shape, loads(i), adhesion, tolerance, held, error)
               call solve(solver, shape, held%penetration, adhesion, solution)
#line 234 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertEqual(contact_solved, solution%status, &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 234) )
  if (anyExceptions()) return
#line 235 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
               call check_law(solution, shape, held%penetration, adhesion)
               if (abs(solution%mean_pressure - loads(i)) < 1.0e-6_dp) n_equal = n_equal + 1
               ! else the load is one of the window that the branch under a load passes in a jump
#line 238 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertEqual(loads(i), solution%mean_pressure, tolerance=0.01_dp*(abs(loads(i)) + adhesion%stress), &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 238) )
  if (anyExceptions()) return
#line 239 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
            end do
         end do
      end do
#line 242 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertGreaterThan(n_equal, 20, &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 242) )
  if (anyExceptions()) return
#line 243 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
   end subroutine test_back_from_load

   !> The penetration is as given, the pressure keeps the law, and the shares are those of the gap.
   subroutine check_law(solution, shape, penetration, adhesion)
      type(periodic_solution_t), intent(in) :: solution
      real(dp), intent(in) :: shape(:, :), penetration
      type(periodic_adhesion_t), intent(in) :: adhesion
      type(cohesion_t) :: law
      real(dp) :: scale

      scale = tolerance*(maxval(solution%pressure) + adhesion%stress)
#line 254 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertEqual(penetration, sum(shape - solution%gap)/size(shape), tolerance=1.0e-9_dp*maxval(shape), &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 254) )
  if (anyExceptions()) return
#line 255 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
#line 255 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertTrue(all(solution%gap >= 0 .and. solution%pressure >= -adhesion%stress*solution%share - scale), &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 255) )
  if (anyExceptions()) return
#line 256 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
      call new_cohesion(law, adhesion%stress, adhesion%range, .false.)
      call law%set_share(solution%gap)
#line 258 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertEqual(law%share, solution%share, tolerance=1.0e-6_dp, &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 258) )
  if (anyExceptions()) return
#line 259 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
#line 259 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertEqual(solution%mean_pressure, sum(solution%pressure)/size(shape), tolerance=1.0e-9_dp*adhesion%stress, &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 259) )
  if (anyExceptions()) return
#line 260 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
   end subroutine check_law

   ! Between the penetrations that the loads of a branch jump over, the load falls while the surfaces come nearer. Each state keeps
   ! the law, and the energy is that of the work, but once: there the zones of neighbouring summits merge.
   !@test
   subroutine test_between_jumps()
      integer, parameter :: n = 64, n_steps = 20
      real(dp), parameter :: from = 1.38_dp, step = 0.005_dp
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: solution
      type(periodic_adhesion_t) :: adhesion
      real(dp), allocatable :: shape(:, :)
      real(dp) :: load(0:n_steps), energy(0:n_steps), lost(n_steps)
      integer :: i, j, k

      allocate (shape(n, n))
      do j = 1, n
         shape(:, j) = [(2 - cos(2*pi*(i - 0.5_dp)/n) - cos(2*pi*(j - 0.5_dp)/n), i=1, n)]
      end do
      shape(:, :) = shape - minval(shape)
      call make_solver([n, n], solver)
      adhesion = periodic_adhesion_t(stress=2*pi*0.3_dp, range=0.2_dp, is_adhered=.false.)
      do k = 0, n_steps
         call solve(solver, shape, from + k*step, adhesion, solution)
#line 284 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertEqual(contact_solved, solution%status, &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 284) )
  if (anyExceptions()) return
#line 285 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
         call check_law(solution, shape, from + k*step, adhesion)
         load(k) = solution%mean_pressure
         energy(k) = solution%elastic_energy + solution%adhesion_energy
      end do
#line 289 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertLessThan(minval(load(1:) - load(:n_steps - 1)), 0.0_dp, &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 289) )
  if (anyExceptions()) return
#line 290 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
      lost = (load(1:) + load(:n_steps - 1))/2*step - (energy(1:) - energy(:n_steps - 1))
#line 291 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertEqual(1, count(lost > 1.0e-4_dp), &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 291) )
  if (anyExceptions()) return
#line 292 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
#line 292 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertEqual(n_steps - 1, count(abs(lost) < 1.0e-5_dp), &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 292) )
  if (anyExceptions()) return
#line 293 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
   end subroutine test_between_jumps

   ! Apart there is nothing, nearer than full contact there is no state, and without a jump both branches are one; a turn leaves the
   ! state of approach where it did not reach.
   !@test
   subroutine test_ends()
      integer, parameter :: n = 64
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: solution, other
      type(periodic_adhesion_t) :: adhesion
      real(dp), allocatable :: shape(:, :)
      real(dp) :: lowest

      call make_line(n, solver, shape, lowest)
      adhesion = periodic_adhesion_t(stress=0.3_dp, range=0.3_dp, is_adhered=.true.)
      call solve(solver, shape, -0.6_dp, adhesion, solution)
#line 309 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertEqual(contact_solved, solution%status, &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 309) )
  if (anyExceptions()) return
#line 310 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
#line 310 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertEqual(shape + 0.6_dp, solution%gap, tolerance=1.0e-9_dp, &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 310) )
  if (anyExceptions()) return
#line 311 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
#line 311 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertEqual(0.0_dp, maxval(abs(solution%pressure)), &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 311) )
  if (anyExceptions()) return
#line 312 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
#line 312 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertEqual(0.0_dp, solution%mean_pressure, &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 312) )
  if (anyExceptions()) return
#line 313 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
      call solve(solver, shape, sum(shape)/n, adhesion, solution)
#line 314 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertEqual(contact_out_of_range, solution%status, &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 314) )
  if (anyExceptions()) return
#line 315 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
      call solve(solver, shape, 0.3_dp, adhesion, solution)
      adhesion%is_adhered = .false.
      call solve(solver, shape, 0.3_dp, adhesion, other)
#line 318 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertEqual(solution%gap, other%gap, tolerance=1.0e-8_dp, &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 318) )
  if (anyExceptions()) return
#line 319 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
      adhesion = periodic_adhesion_t(stress=0.3_dp, range=0.3_dp, is_adhered=.true., has_turned=.true., turning_pressure=0.1_dp)
      call solve(solver, shape, 0.7_dp, adhesion, solution)
      adhesion%is_adhered = .false.
      call solve(solver, shape, 0.7_dp, adhesion, other)
#line 323 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertEqual(contact_solved, solution%status, &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 323) )
  if (anyExceptions()) return
#line 324 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
#line 324 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertTrue(all(.not. abs(solution%gap - other%gap) > 0), &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 324) )
  if (anyExceptions()) return
#line 325 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
   end subroutine test_ends

   ! A solver that has solved other penetrations gives the same digits.
   !@test
   subroutine test_order()
      integer, parameter :: n = 32
      type(periodic_solver_t) :: solver, fresh
      type(periodic_solution_t) :: solution, again
      type(periodic_adhesion_t) :: adhesion
      real(dp), allocatable :: shape(:, :)

      call make_rough(n, 4, fresh, shape)
      adhesion = periodic_adhesion_t(stress=0.03_dp, range=0.1_dp*maxval(shape), is_adhered=.true.)
      call solve(fresh, shape, 0.3_dp*maxval(shape), adhesion, solution)
      call make_rough(n, 4, solver, shape)
      call solve(solver, shape, 0.1_dp*maxval(shape), adhesion, again)
      call solve(solver, shape, -0.2_dp*maxval(shape), adhesion, again)
      call solve(solver, shape, 0.3_dp*maxval(shape), adhesion, again)
#line 343 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertEqual(contact_solved, solution%status, &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 343) )
  if (anyExceptions()) return
#line 344 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
#line 344 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
  call assertTrue(all(.not. abs(solution%gap - again%gap) > 0), &
 & location=SourceLocation( &
 & 'periodic_penetration.pf', &
 & 344) )
  if (anyExceptions()) return
#line 345 "/work/wt/penetration/tests/periodic/periodic_penetration.pf"
   end subroutine test_order

end module periodic_penetration

module Wrapperiodic_penetration
   use FUnit
   use periodic_penetration
   implicit none
   private

contains


end module Wrapperiodic_penetration

function periodic_penetration_suite() result(suite)
   use FUnit
   use periodic_penetration
   use Wrapperiodic_penetration
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('periodic_penetration_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_wave', &
      test_wave))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_loop', &
      test_loop))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_back_from_load', &
      test_back_from_load))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_between_jumps', &
      test_between_jumps))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_ends', &
      test_ends))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_order', &
      test_order))
   call suite%addTest(t)


end function periodic_penetration_suite


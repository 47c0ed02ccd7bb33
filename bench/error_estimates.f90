! SPDX-License-Identifier: GPL-3.0-or-later
!> Is `error_estimate` to be believed? Estimates beside true errors of random strips, surfaces, spheres and waves. See
!> bench/README.md.
!>
!> error_estimates [TABLE.csv [SEED]]
!>
!> True errors come from quadruple precision (strips, spheres), from the tightest tolerance and from thousands of equal strips
!> (surfaces), from finer grids (2-D waves, rough surfaces that slide or are pulled off), from Westergaard (1-D wave) and from the
!> closed form of the sliding 1-D wave. An error below the round-off of a number in double precision counts as that.
program error_estimates
   use, intrinsic :: iso_fortran_env, only: output_unit
   use adfric_base_kinds, only: dp
   use adfric_describe_status, only: status_solved
   use adfric_round_sphere_model, only: sphere_model_t, new_sphere_model
   use adfric_round_sphere_variables, only: n_sphere_results, n_sphere_variables, units_reduced, in => sphere_input, &
      & out => sphere_output
   use adfric_foundation_crosswise, only: memory_t
   use adfric_foundation_equilibrium, only: equilibrium_t, neighbour_t, solve_penetration, solve_load
   use adfric_foundation_foundation, only: new_foundation
   use adfric_foundation_surface, only: surface_t, negligible
   use estimate_counts, only: counts_t, count_case, report_counts
   use adfric_shape_height_line, only: cubic_pieces, linear_pieces
   use stepped_estimates, only: count_cosines, count_lines, count_maps
   use measure, only: print_heading, text_argument, integer_argument, open_table
   use periodic_estimates, only: count_pull_offs, count_waves_1d, count_waves_2d
   use quad_dugdale, only: state_t, of_radius, of_load, of_approach, pull_off_of_load, pull_off_of_approach, &
      touching_approach, relative, qp
   use quad_strips, only: get_quad_forces
   use random_dice, only: dice_t, new_dice
   use sliding_estimates, only: count_sliding_lines, count_sliding_waves, count_sliding_surfaces
   use trial_strips, only: trial_t, draw_trial
   implicit none (type, external)

   integer, parameter :: n_strips = 20000, n_surfaces = 400, n_spheres = 4000
   !> Sums below this share of their terms are as good as zero, as the solver has it.
   real(dp), parameter :: share_of_scale = 0.01_dp
   type(counts_t) :: counts(22)
   integer :: table, seed

   call print_heading('Error estimates beside true errors')
   seed = integer_argument(2, 1)
   call count_strips(counts(1))
   call count_surfaces(counts(2), counts(3), counts(4))
   call count_spheres(counts(5), 5, 'sphere, maugis_dugdale')
   call count_spheres(counts(6), 1, 'sphere, auto')
   call count_waves_1d(counts(7))
   call count_waves_2d(counts(8))
   call count_cosines(counts(9), counts(10), seed + 3)
   call count_lines(counts(11), counts(12), cubic_pieces, seed + 4)
   call count_lines(counts(13), counts(14), linear_pieces, seed + 5)
   call count_maps(counts(15), counts(16), seed + 6)
   call count_sliding_lines(counts(17), counts(18), seed + 7)
   call count_sliding_waves(counts(19), seed + 8)
   call count_sliding_surfaces(counts(20), counts(21), seed + 9)
   call count_pull_offs(counts(22))
   table = open_table(text_argument(1, 'error_estimates.csv'), 'cases,decade,count')
   call report_counts(table, counts)
   close (table)

contains

   !> One strip at a penetration: quadruple precision.
   subroutine count_strips(counts)
      type(counts_t), intent(out) :: counts
      type(dice_t) :: dice
      type(trial_t) :: trial
      type(memory_t) :: memory
      type(equilibrium_t) :: found
      real(qp) :: load, friction
      logical :: is_found
      integer :: k

      counts%name = '2-D wave at a penetration'
      call new_dice(dice, seed)
      do k = 1, n_strips
         call draw_trial(dice, trial)
         if (.not. trial%beta > 1) cycle
         memory = memory_t()
         call solve_penetration(new_surface(trial, .false., 1.0e-8_dp), trial%penetration, memory, found)
         if (found%status /= status_solved) then
            counts%n_unsolved = counts%n_unsolved + 1
            cycle
         end if
         call get_quad_forces(trial, memory%crest, load, friction, is_found)
         if (.not. is_found) then
            counts%n_without_truth = counts%n_without_truth + 1
            cycle
         end if
         ! per period, in units of the whole height
         call count_case(counts, found%error_estimate, &
            true_error(found, real(load/(4*acos(-1.0_qp)), dp), real(friction/4, dp)), 'strip')
      end do
   end subroutine count_strips

   !> A surface of random parameters in units of l, h and 1/K.
   type(surface_t) function new_surface(trial, is_3d, tolerance) result(surface)
      type(trial_t), intent(in) :: trial
      logical, intent(in) :: is_3d
      real(dp), intent(in) :: tolerance

      surface%shape%is_3d = is_3d
      call new_foundation(surface%foundation, trial%u, trial%beta)
      surface%adhesion%stress = trial%stress
      surface%adhesion%range = trial%range
      surface%adhesion%edge = trial%edge
      surface%branch = trial%branch
      surface%tolerance = tolerance
   end function new_surface

   !> Larger error of load and friction, in the sizes that the estimate is meant in.
   pure real(dp) function true_error(found, load, friction)
      type(equilibrium_t), intent(in) :: found
      real(dp), intent(in) :: load, friction
      real(dp) :: sizes(2)

      associate (t => found%totals)
         sizes = max(abs([load, friction]), share_of_scale*[t%load_scale, t%friction_scale], tiny(1.0_dp))
         sizes(2) = max(sizes(2), negligible*sizes(1))
         true_error = maxval(abs([t%load - load, t%friction - friction])/sizes)
      end associate
   end function true_error

   !> 3-D surfaces by the adaptive rule at a penetration and under a load, and by equal strips as published.
   subroutine count_surfaces(adaptive, loaded, equal)
      type(counts_t), intent(out) :: adaptive, loaded, equal
      integer, parameter :: n_equal = 4096, sizes(*) = [16, 64, 256, 1024], digits(*) = [3, 4, 6, 8, 10]
      type(dice_t) :: dice
      type(trial_t) :: trial
      type(memory_t) :: memory
      type(equilibrium_t) :: truth, check, found
      type(neighbour_t) :: neighbour
      type(surface_t) :: surface
      real(dp) :: load
      integer :: k, j

      adaptive%name = '3-D surface, adaptive rule'
      loaded%name = '3-D surface under a load'
      equal%name = '3-D surface, equal strips'
      call new_dice(dice, seed + 1)
      do k = 1, n_surfaces
         call draw_trial(dice, trial)
         surface = new_surface(trial, .true., 1.0e-13_dp)
         memory = memory_t()
         call solve_penetration(surface, trial%penetration, memory, truth)
         surface%n_strips = n_equal
         memory = memory_t()
         call solve_penetration(surface, trial%penetration, memory, check)
         if (check%status /= status_solved .or. .not. true_error(check, truth%totals%load, truth%totals%friction) &
            <= 3*check%error_estimate + 1.0e-12_dp) adaptive%n_doubtful = adaptive%n_doubtful + 1
         do j = 1, size(sizes)
            surface%n_strips = sizes(j)
            memory = memory_t()
            call solve_penetration(surface, trial%penetration, memory, found)
            call keep(equal, found, truth, .false.)
         end do
         surface%n_strips = 0
         do j = 1, size(digits)
            surface%tolerance = 10.0_dp**(-digits(j))
            memory = memory_t()
            call solve_penetration(surface, trial%penetration, memory, found)
            call keep(adaptive, found, truth, .false.)
         end do
         ! the same states, but found from their load, which must be one that this branch leads to
         load = truth%totals%load
         surface%tolerance = 1.0e-13_dp
         memory = memory_t()
         neighbour = neighbour_t()
         call solve_load(surface, load, neighbour, memory, truth)
         if (truth%status /= status_solved) cycle
         do j = 1, size(digits)
            surface%tolerance = 10.0_dp**(-digits(j))
            memory = memory_t()
            neighbour = neighbour_t()
            call solve_load(surface, load, neighbour, memory, found)
            call keep(loaded, found, truth, .true.)
         end do
      end do
   end subroutine count_surfaces

   !> Count one surface.
   subroutine keep(counts, found, truth, is_load_given)
      type(counts_t), intent(inout) :: counts
      type(equilibrium_t), intent(in) :: found, truth
      !> Then the load has no error.
      logical, intent(in) :: is_load_given
      real(dp) :: load

      if (found%status /= status_solved .or. truth%status /= status_solved) then
         counts%n_unsolved = counts%n_unsolved + 1
         return
      end if
      load = truth%totals%load
      if (is_load_given) load = found%totals%load
      call count_case(counts, found%error_estimate, true_error(found, load, truth%totals%friction), 'surface')
   end subroutine keep

   !> Spheres of all lambda with radius, load or approach held: quadruple precision.
   subroutine count_spheres(counts, theory, name)
      type(counts_t), intent(out) :: counts
      !> Word of the input.
      integer, intent(in) :: theory
      character(*), intent(in) :: name
      type(sphere_model_t) :: model
      type(dice_t) :: dice
      type(state_t) :: truth, fold
      real(dp) :: values(n_sphere_variables, 1), results(n_sphere_results, 1), estimate(1), lambda, prescribed, digits, control, &
         & limits(1)
      integer :: status(1), k

      counts%name = name
      call new_sphere_model(model)
      call new_dice(dice, seed + 2)
      do k = 1, n_spheres
         values(:, 1) = model%variables%default
         call dice%decades(-6.0_dp, 6.0_dp, lambda)
         call dice%between(-12.0_dp, -2.0_dp, digits)
         call dice%between(0.0_dp, 3.0_dp, control)
         call dice%decades(-2.0_dp, 2.0_dp, prescribed)
         values([in%units, in%theory], 1) = [units_reduced, theory]
         values(in%lambda, 1) = lambda
         values(in%relative_tolerance, 1) = max(10**digits, model%variables(in%relative_tolerance)%lower)
         if (control < 1) then
            values(in%contact_radius, 1) = prescribed
            truth = of_radius(lambda, prescribed)
         else if (control < 2) then
            fold = pull_off_of_load(lambda)
            prescribed = real(fold%value(2), dp) + prescribed
            values(in%load, 1) = prescribed
            truth = of_load(lambda, prescribed)
         else
            fold = pull_off_of_approach(lambda)
            prescribed = max(real(fold%value(3), dp), touching_approach(lambda)) + prescribed
            values(in%approach, 1) = prescribed
            truth = of_approach(lambda, prescribed)
         end if
         call model%solve_block(values, results, estimate, status, limits)
         if (status(1) /= status_solved) then
            counts%n_unsolved = counts%n_unsolved + 1
            cycle
         end if
         call count_case(counts, estimate(1), max(relative(results(out%load, 1), truth%value(2)), &
            relative(results(out%approach, 1), truth%value(3)), &
            real(abs(results(out%contact_radius, 1) - truth%value(1))/truth%value(1), dp)), 'sphere')
      end do
   end subroutine count_spheres

end program error_estimates

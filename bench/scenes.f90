! SPDX-License-Identifier: GPL-3.0-or-later
!> What a scene pays for: time with and without each saving of `docs/validation/scenes.md`, in turns, and what the saving changes.
!>
!> scenes [TABLE.csv]
program scenes
   use, intrinsic :: iso_fortran_env, only: output_unit
   use adfric_base_constants, only: two_pi
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_base_unset, only: unset
   use adfric_describe_model, only: model_t
   use adfric_describe_status, only: status_solved
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_solver, only: periodic_solver_t, periodic_solution_t, new_periodic_solver
   use adfric_periodic_wave_2d_model, only: wave_2d_model_t, new_wave_2d_model
   use adfric_round_sphere_model, only: sphere_model_t, new_sphere_model
   use adfric_round_sphere_variables, only: units_reduced, n_sphere_variables, sphere_input
   use adfric_system_clock, only: wall_clock
   use adfric_foundation_model, only: wavy_model_t, new_wavy_model
   use adfric_foundation_variables, only: foundation_input, out => foundation_output
   use measure, only: spread_t, spread_of, print_heading, text_argument, open_table
   use taken_profiles, only: taken_profiles_t
   use trial_surfaces, only: wave
   implicit none (type, external)

   integer, parameter :: n_repeats = 9, n_points = 250
   !> A number that is as good as nothing, and yet not 0.
   real(dp), parameter :: hardly = 1.0e-9_dp
   real(dp), parameter :: tolerance = 1.0e-8_dp
   !> Position of the mean pressure among the variables of `wave_2d_elastic`.
   integer, parameter :: w_pressure = 6
   integer :: table

   call print_heading('What a scene pays for')
   table = open_table(text_argument(1, 'scenes.csv'), 'saving,scene,with_us,without_us,ratio,ratio_least,ratio_most,change,allowed')
   print '(a36, a26, 2a11, a28, 2a10)', 'saving', 'scene', 'with us', 'without', 'ratio (range)', 'change', 'allowed'
   call compare_wavy('no adhesion', '3-D wave', surface(3, 0.0_dp), surface(3, hardly), 2*tolerance)
   call compare_wavy('elastic limit', '3-D wave, Te/Ts = 1', elastic(1.0_dp), elastic(1 + hardly), 1.0e-8_dp)
   call compare_wavy('saturated strips in closed form', '3-D wave in full contact', deep(0.0_dp), deep(1.0e-6_dp), 1.0e-8_dp)
   call compare_wavy('one strip', '2-D wave, 1024 strips', surface(2, 0.1_dp), many_strips(), unset)
   call compare_wavy('strips as the tolerance needs', '3-D wave, 1024 strips', surface(3, 0.1_dp), many_strips(), 1.0e-3_dp)
   call compare_blocks('a start from the neighbour', '2-D wave', surface(2, 0.1_dp))
   call compare_blocks('a start from the neighbour', '3-D wave', surface(3, 0.1_dp))
   call compare_theories('theory = ''auto'', DMT (x = 0)', 'lambda 1e-8', 1.0e-8_dp, 0.0_dp)
   call compare_theories('theory = ''auto'', JKR', 'lambda 1e5', 1.0e5_dp, 0.4_dp)
   call compare_theories('theory = ''auto'', neither', 'lambda 0.8', 0.8_dp, 0.4_dp)
   call compare_events()
   call compare_quarter()
   call compare_profiles()
   close (table)

contains

   !> Points of a wavy surface in units of l, h, 1/K: penetrations in even steps.
   function surface(dimensions, stress) result(values)
      integer, intent(in) :: dimensions
      real(dp), intent(in) :: stress
      real(dp) :: values(foundation_input%n_y, n_points)
      type(wavy_model_t) :: model
      integer :: k

      call new_wavy_model(model)
      do k = 1, n_points
         values(:, k) = model%variables%default
         values(foundation_input%penetration, k) = 0.1_dp + 0.5_dp*k/n_points
      end do
      values(foundation_input%kind, :) = dimensions - 1
      values([foundation_input%period, foundation_input%height, foundation_input%stiffness, foundation_input%velocity], :) = 1
      values(foundation_input%relaxation_time, :) = 0.3_dp/two_pi
      values(foundation_input%retardation_ratio, :) = 10
      values(foundation_input%stress, :) = stress
      values(foundation_input%range, :) = 0.1_dp
      values(foundation_input%relative_tolerance, :) = tolerance
   end function surface

   !> The same on a foundation that hardly relaxes.
   function elastic(ratio) result(values)
      real(dp), intent(in) :: ratio
      real(dp) :: values(foundation_input%n_y, n_points)

      values = surface(3, 0.0_dp)
      values(foundation_input%retardation_ratio, :) = ratio
   end function elastic

   !> So deep that contact is everywhere; a finite slope, however small, has no closed form. Of that slope this is the height
   !> over the period, and the period is so long that the foundation stays the same.
   function deep(height) result(values)
      real(dp), intent(in) :: height
      real(dp) :: values(foundation_input%n_y, n_points)
      integer :: k

      values = surface(3, 0.0_dp)
      values(foundation_input%penetration, :) = [(3 + 0.5_dp*k/n_points, k=1, n_points)]
      if (.not. height > 0) return
      values(foundation_input%slope, :) = 2
      values([foundation_input%period, foundation_input%relaxation_time], :) = values([foundation_input%period, &
         & foundation_input%relaxation_time], :)/height
   end function deep

   !> As published: equal strips, in 3-D.
   function many_strips() result(values)
      real(dp) :: values(foundation_input%n_y, n_points)

      values = surface(3, 0.1_dp)
      values(foundation_input%strips, :) = 1024
   end function many_strips

   !> Time of a point with and without a saving, and the largest relative change of load and friction coefficient.
   subroutine compare_wavy(saving, scene, with, without, allowed)
      character(*), intent(in) :: saving, scene
      real(dp), intent(in) :: with(:, :), without(:, :)
      !> Largest change; `unset` where the results are not the same thing.
      real(dp), intent(in) :: allowed
      type(wavy_model_t) :: model
      real(dp), allocatable :: one(:, :), other(:, :)
      real(dp) :: times(2, n_repeats), change
      integer :: r

      call new_wavy_model(model)
      do r = 1, n_repeats
         call solve(model, with, n_points, one, times(1, r))
         call solve(model, without, n_points, other, times(2, r))
      end do
      ! per area, which differs where the period does
      one(out%load, :) = one(out%load, :)/one(out%contact_area, :)
      other(out%load, :) = other(out%load, :)/other(out%contact_area, :)
      change = largest_change(one(out%load, :), other(out%load, :))
      if (abs(with(foundation_input%period, 1) - without(foundation_input%period, 1)) > 0) then
         ! friction goes like the slope
         one(out%friction_coefficient, :) = one(out%friction_coefficient, :)*with(foundation_input%period, 1)
         other(out%friction_coefficient, :) = other(out%friction_coefficient, :)*without(foundation_input%period, 1)
      end if
      if (maxval(abs(one(out%friction_coefficient, :))) > tolerance) change = max(change, &
         largest_change(one(out%friction_coefficient, :), other(out%friction_coefficient, :)))
      if (.not. allowed < unset) change = largest_change(one(out%contact_width, :), other(out%contact_width, :))
      call report(saving, scene, times, change, merge(allowed, tolerance, allowed < unset))
   end subroutine compare_wavy

   !> Points in one block, and each by itself.
   subroutine compare_blocks(saving, scene, values)
      character(*), intent(in) :: saving, scene
      real(dp), intent(in) :: values(:, :)
      type(wavy_model_t) :: model
      real(dp), allocatable :: one(:, :), other(:, :)
      real(dp) :: times(2, n_repeats)
      integer :: r

      call new_wavy_model(model)
      do r = 1, n_repeats
         call solve(model, values, n_points, one, times(1, r))
         call solve(model, values, 1, other, times(2, r))
      end do
      call report(saving, scene, times, max(largest_change(one(out%load, :), other(out%load, :)), &
         largest_change(one(out%friction_force, :), other(out%friction_force, :))), tolerance)
   end subroutine compare_blocks

   !> A sphere of a lambda where a limit theory will do.
   subroutine compare_theories(saving, scene, lambda, edge_fraction)
      character(*), intent(in) :: saving, scene
      !> With x > 0 the radius of adhesion is needed, which DMT does not have.
      real(dp), intent(in) :: lambda, edge_fraction
      real(dp), parameter :: wanted = 1.0e-4_dp
      type(sphere_model_t) :: model
      real(dp), allocatable :: one(:, :), other(:, :)
      real(dp) :: values(n_sphere_variables, n_points), full(n_sphere_variables, n_points), times(2, n_repeats), change
      integer :: r, k

      call new_sphere_model(model)
      values = spread(model%variables%default, 2, n_points)
      values(sphere_input%units, :) = units_reduced
      values(sphere_input%lambda, :) = lambda
      values(sphere_input%edge_fraction, :) = edge_fraction
      values(sphere_input%relative_tolerance, :) = wanted
      values(sphere_input%load, :) = [(100.0_dp*k/n_points, k=1, n_points)]
      full = values
      values(sphere_input%theory, :) = 1
      full(sphere_input%theory, :) = 5
      do r = 1, n_repeats
         call solve(model, values, n_points, one, times(1, r))
         call solve(model, full, n_points, other, times(2, r))
      end do
      change = 0
      do k = 1, 3
         change = max(change, largest_change(one(k, :), other(k, :)))
      end do
      call report(saving, scene//', load to 100', times, change, wanted)
   end subroutine compare_theories

   !> Events of the static phase: kept along a sweep of the tangential force, or found for each point.
   subroutine compare_events()
      type(sphere_model_t) :: model
      real(dp), allocatable :: one(:, :), other(:, :)
      real(dp) :: values(n_sphere_variables, n_points), times(2, n_repeats), change
      integer :: r, k

      call new_sphere_model(model)
      values = spread(model%variables%default, 2, n_points)
      values([sphere_input%units, sphere_input%theory], :) = spread([units_reduced, 5], 2, n_points)
      values([sphere_input%lambda, sphere_input%load, sphere_input%shear_strength, sphere_input%poisson_ratio], &
         & :) = spread([0.8_dp, 0.0_dp, 0.6_dp, 0.3_dp], 2, n_points)
      values([sphere_input%interaction, sphere_input%slip_energy_ratio, sphere_input%events], :) = spread([0.3_dp, 1.2_dp, &
         & 1.0_dp], 2, n_points)
      values(sphere_input%tangential_force, :) = [(0.2_dp*k/n_points, k=1, n_points)]
      do r = 1, n_repeats
         call solve(model, values, n_points, one, times(1, r))
         call solve(model, values, 1, other, times(2, r))
      end do
      change = 0
      do k = 1, size(one, 1)
         if (all(abs(one(k, :)) < huge(1.0_dp))) change = max(change, largest_change(one(k, :), other(k, :)))
      end do
      call report('events kept along a sweep', 'sphere, static friction', times, change, tolerance)
   end subroutine compare_events

   !> A quarter of the cells, between planes of symmetry.
   subroutine compare_quarter()
      integer, parameter :: n = 256
      real(dp), parameter :: load = 0.3_dp, residual = 1.0e-10_dp
      type(periodic_solver_t) :: quarter, whole
      type(periodic_solution_t) :: one, other
      type(error_t), allocatable :: error
      real(dp) :: times(2, n_repeats), change
      integer :: r

      call new_periodic_solver(quarter, elastic_kernel_t(), [n/2, n/2], [1.0_dp, 1.0_dp], .true., error, is_measured=.true.)
      call new_periodic_solver(whole, elastic_kernel_t(), [n, n], [1.0_dp, 1.0_dp], .false., error, is_measured=.true.)
      do r = 1, n_repeats
         times(1, r) = wall_clock()
         call quarter%solve_load(wave(n, n/2), load, residual, one, error)
         times(1, r) = 1.0e6_dp*(wall_clock() - times(1, r))
         times(2, r) = wall_clock()
         call whole%solve_load(wave(n, n), load, residual, other, error)
         times(2, r) = 1.0e6_dp*(wall_clock() - times(2, r))
      end do
      change = maxval(abs(one%pressure - other%pressure(:n/2, :n/2)))/maxval(one%pressure)
      call report('a quarter of the cell', 'half-space, 256 x 256', times, change, 100*residual)
   end subroutine compare_quarter

   !> Points with and without their profiles.
   subroutine compare_profiles()
      type(wavy_model_t) :: wavy
      type(wave_2d_model_t) :: elastic
      real(dp), allocatable :: values(:, :)

      call new_wavy_model(wavy)
      call with_profiles(wavy, surface(3, 0.1_dp), 'wavy, 401 x 101 samples')
      call new_wave_2d_model(elastic)
      allocate (values(8, 4))
      values = spread([1.0_dp, 0.01_dp, 128.0_dp, 1.0e-10_dp, 1.0_dp, 0.0_dp, unset, 1.0_dp], 2, 4)
      values(w_pressure, :) = [0.01_dp, 0.02_dp, 0.03_dp, 0.04_dp]
      call with_profiles(elastic, values, 'half-space, 128 x 128')
   end subroutine compare_profiles

   subroutine with_profiles(model, values, scene)
      class(model_t), intent(in) :: model
      real(dp), intent(in) :: values(:, :)
      character(*), intent(in) :: scene
      type(taken_profiles_t) :: receiver
      real(dp) :: counts(size(model%counts))
      real(dp), allocatable :: results(:, :), others(:, :), profiles(:, :, :)
      real(dp) :: times(2, n_repeats), error_estimate(size(values, 2))
      integer :: r, n, shape(3), status(size(values, 2))

      n = min(size(values, 2), 20)
      allocate (others(size(model%results), n))
      shape = model%profile_shape(values(:, 1))
      allocate (profiles(shape(1), shape(2), shape(3)))
      do r = 1, n_repeats
         call solve(model, values(:, :n), n, results, times(1, r))
         times(2, r) = wall_clock()
         call model%solve_block_and_profiles(values(:, :n), others, error_estimate(:n), status(:n), counts, profiles, receiver)
         times(2, r) = 1.0e6_dp*(wall_clock() - times(2, r))/n
      end do
      if (receiver%n_taken /= n_repeats*n) error stop 'scenes: not all profiles'
      call report('no profiles', scene, times, real(count(abs(results - others) > 0), dp), 0.0_dp)
   end subroutine with_profiles

   !> Solve points in blocks, and give the time of one.
   subroutine solve(model, values, block, results, time)
      class(model_t), intent(in) :: model
      real(dp), intent(in) :: values(:, :)
      integer, intent(in) :: block
      real(dp), allocatable, intent(out) :: results(:, :)
      !> [us]
      real(dp), intent(out) :: time
      real(dp) :: counts(size(model%counts))
      real(dp) :: error_estimate(size(values, 2))
      integer :: status(size(values, 2)), first, last

      allocate (results(size(model%results), size(values, 2)))
      time = wall_clock()
      do first = 1, size(values, 2), block
         last = min(first + block - 1, size(values, 2))
         call model%solve_block(values(:, first:last), results(:, first:last), error_estimate(first:last), &
            status(first:last), counts)
      end do
      time = 1.0e6_dp*(wall_clock() - time)/size(values, 2)
      if (any(status /= status_solved)) error stop 'scenes: not solved'
   end subroutine solve

   pure real(dp) function largest_change(one, other)
      real(dp), intent(in) :: one(:), other(:)

      largest_change = maxval(abs(one - other))/max(maxval(abs(one)), tiny(1.0_dp))
   end function largest_change

   subroutine report(saving, scene, times, change, allowed)
      character(*), intent(in) :: saving, scene
      !> With and without, by repetition [us].
      real(dp), intent(in) :: times(:, :)
      real(dp), intent(in) :: change, allowed
      type(spread_t) :: with, without, ratio

      with = spread_of(times(1, :))
      without = spread_of(times(2, :))
      ratio = spread_of(times(2, :)/times(1, :))
      print '(a36, a26, 2f11.2, f9.2, 2(a, f7.1), a, 2es10.1)', saving, scene, with%median, without%median, ratio%median, ' (', &
         ratio%least, ' to', ratio%most, ')', change, allowed
      write (table, '(2("""", a, """,") , 2(f0.3, ","), 3(f0.3, ","), es8.2, ",", es8.2)') saving, scene, with%median, &
         without%median, ratio, change, allowed
      flush (output_unit)
      if (.not. change <= allowed) error stop 'scenes: a saving changes the results'
   end subroutine report

end program scenes

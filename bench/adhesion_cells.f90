! SPDX-License-Identifier: GPL-3.0-or-later
!> What do cells make of a zone of adhesion that has few of them? The 1-D wave beside its closed form, and pull-off of a sphere. See
!> bench/README.md.
!>
!> adhesion_cells [TABLE.csv]
program adhesion_cells
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp
   use adfric_plane_adhesive_wave_curve, only: adhesive_wave_t
   use adfric_plane_adhesive_wave_events, only: new_adhesive_wave
   use adfric_plane_adhesive_wave_load, only: state_of_load, branch_adhered, branch_approach
   use adfric_plane_adhesive_wave_state, only: wave_adhesion_t
   use adfric_periodic_adhesive_pull_off, only: periodic_pull_off_t, find_pull_off
   use adfric_periodic_adhesive_solver, only: periodic_adhesion_t, solve_adhesive_load
   use adfric_periodic_area, only: relative_error_of
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_solver, only: periodic_solver_t, periodic_solution_t, new_periodic_solver, contact_solved, &
      & contact_not_converged
   use measure, only: print_heading, text_argument, open_table, spread_t, spread_of
   use random_dice, only: dice_t, new_dice
   use trial_case, only: trial_case_t, new_case
   implicit none (type, external)

   real(dp), parameter :: pi = 3.14159265358979323846264338328_dp, tolerance = 1.0e-10_dp
   real(dp), parameter :: cells_per_zone(*) = [0.1_dp, 0.3_dp, 0.5_dp, 0.7_dp, 1.0_dp, 1.5_dp, 2.5_dp, 4.0_dp, 8.0_dp, 16.0_dp, &
      & 40.0_dp]
   !> States of each number of cells per zone and of cells; Johnson's alpha of pull-offs.
   integer, parameter :: n_states = 100, n_cells(*) = [128, 512], cells_of_pull_off = 256
   real(dp), parameter :: alphas(*) = [0.15_dp, 0.2_dp, 0.27_dp, 0.35_dp, 0.45_dp, 0.5_dp]
   !> What `elastic_model.f90` takes for the error of an edge with one cell per zone.
   real(dp), parameter :: error_of_cell = 0.05_dp

   !> Answers beside the truth.
   type :: counts_t
      !> States with an edge of adhesion; another state than the exact one; not converged; areas whose error is above its estimate.
      integer :: n = 0, other = 0, not_solved = 0, below = 0
      !> Relative errors of the area, and errors of the penetration in amplitudes; shape `(n)`.
      real(dp) :: areas(n_states*size(n_cells)) = 0, penetrations(n_states*size(n_cells)) = 0
   end type counts_t
   integer :: table, k

   call print_heading('Zones of adhesion of few cells')
   table = open_table(text_argument(1, 'adhesion_cells.csv'), 'cells_per_zone,states,other,not_solved,below,area_median,' &
      & //'area_largest,penetration_largest,pull_off_strong,pull_off_weak')
   print '(a)', 'the 1-D wave: states with an edge, another state, not solved, errors above their estimate; errors of area, ' &
      & //'penetration, pull-off that is too strong and too weak'
   print '(a9, 4a8, 5a12)', 'cells', 'states', 'other', 'not s.', 'above', 'median', 'largest', 'penetration', 'strong', 'weak'
   do k = 1, size(cells_per_zone)
      call measure_zone(cells_per_zone(k))
   end do
   close (table)
   call measure_spheres()

contains

   !> A line of the table.
   subroutine measure_zone(cells)
      real(dp), intent(in) :: cells
      type(counts_t) :: counts
      type(spread_t) :: areas
      real(dp) :: largest, pull_off(2)
      integer :: i

      do i = 1, size(n_cells)
         call measure_states(n_cells(i), cells, counts)
      end do
      pull_off = pull_off_errors(cells)
      areas = spread_of(counts%areas(:counts%n))
      largest = maxval(counts%penetrations(:counts%n))
      associate (c => counts)
         print '(f9.2, 4i8, 5es12.1)', cells, c%n, c%other, c%not_solved, c%below, areas%median, areas%most, largest, pull_off
         write (table, '(f0.2, 4(",", i0), 5(",", es9.2))') cells, c%n, c%other, c%not_solved, c%below, areas%median, areas%most, &
            & largest, pull_off
      end associate
   end subroutine measure_zone

   !> Half of a line 1 - cos 2 pi x, and its least value before it was taken away.
   subroutine make_line(n, shape, lowest)
      integer, intent(in) :: n
      real(dp), intent(out) :: shape(:, :), lowest
      integer :: i

      shape(:, 1) = [(1 - cos(2*pi*(i - 0.5_dp)/n), i=1, n/2)]
      lowest = minval(shape)
      shape(:, :) = shape - lowest
   end subroutine make_line

   !> Random alpha, branches and loads.
   subroutine measure_states(n, cells, counts)
      integer, intent(in) :: n
      real(dp), intent(in) :: cells
      type(counts_t), intent(inout) :: counts
      type(dice_t) :: dice
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: found
      type(periodic_adhesion_t) :: adhesion
      type(wave_adhesion_t) :: exact
      type(error_t), allocatable :: error
      real(dp) :: shape(n/2, 1), lowest, load
      integer :: i
      logical :: is_known

      call make_line(n, shape, lowest)
      call new_periodic_solver(solver, elastic_kernel_t(), [n/2, 1], [1.0_dp, 1.0_dp], .true., error)
      call new_dice(dice, 7)
      do i = 1, n_states
         call draw(dice, n, cells, adhesion, load, exact)
         is_known = .true.
         if (adhesion%has_turned) then
            call solve_adhesive_load(solver, shape, 0.0_dp, periodic_adhesion_t(adhesion%stress, adhesion%range, .false.), &
               & tolerance, found, error)
            is_known = found%status == contact_solved
         end if
         if (is_known) call solve_adhesive_load(solver, shape, pi*load, adhesion, tolerance, found, error)
         call keep(counts, found, exact, cells, lowest)
      end do
   end subroutine measure_states

   !> A wave of a given number of cells per zone; on approach, from saturation, or brought together under no load.
   subroutine draw(dice, n, cells, adhesion, load, exact)
      type(dice_t), intent(inout) :: dice
      integer, intent(in) :: n
      real(dp), intent(in) :: cells
      type(periodic_adhesion_t), intent(out) :: adhesion
      !> Mean pressure in p*.
      real(dp), intent(out) :: load
      type(wave_adhesion_t), intent(out) :: exact
      type(adhesive_wave_t) :: wave
      real(dp) :: alpha, part
      integer :: branch
      logical :: is_found

      call dice%decades(-1.0_dp, 0.1_dp, alpha)
      call dice%choose(3, branch)
      call dice%between(0.0_dp, 1.0_dp, part)
      call set_adhesion(n, cells, alpha, adhesion)
      call new_adhesive_wave(wave, adhesion%stress/pi, adhesion%range, is_found)
      if (branch == 1) then
         load = part*max(wave%largest_load, 0.1_dp)
         call state_of_load(wave, load, branch_approach, exact, is_found)
         adhesion%is_adhered = .false.
      else if (branch == 2) then
         load = part - (1 - part)*wave%stress
         call state_of_load(wave, load, branch_adhered, exact, is_found)
      else
         load = wave%least_load + part*(max(wave%largest_load, 0.0_dp) - wave%least_load)
         call state_of_load(wave, load, branch_adhered, exact, is_found, 0.0_dp)
         adhesion%has_turned = .true.
      end if
      if (.not. is_found) error stop 'adhesion_cells: the exact wave is not found'
   end subroutine draw

   !> Stress and range of Johnson's alpha with a number of cells per zone.
   pure subroutine set_adhesion(n, cells, alpha, adhesion)
      integer, intent(in) :: n
      real(dp), intent(in) :: cells, alpha
      type(periodic_adhesion_t), intent(out) :: adhesion

      adhesion%range = alpha*sqrt(2*pi*cells/n)
      adhesion%stress = pi*pi*alpha**2/(2*adhesion%range)
   end subroutine set_adhesion

   !> Count an answer.
   subroutine keep(counts, found, exact, cells, lowest)
      type(counts_t), intent(inout) :: counts
      type(periodic_solution_t), intent(in) :: found
      type(wave_adhesion_t), intent(in) :: exact
      real(dp), intent(in) :: cells, lowest
      logical :: has_state, has_edge

      has_state = exact%regime >= 0
      has_edge = has_state .and. exact%cohesive_half_width < 0.5_dp
      if (found%status == contact_not_converged) then
         counts%not_solved = counts%not_solved + 1
      else if (has_state .neqv. found%status == contact_solved) then
         counts%other = counts%other + 1
      else if (has_state) then
         if (has_edge .neqv. any(found%share < 1)) then
            counts%other = counts%other + 1
         else if (has_edge) then
            counts%n = counts%n + 1
            associate (area => 2*exact%contact_half_width, n => counts%n)
               counts%areas(n) = abs(found%area%corrected - area)/max(area, found%area%resolution)
               counts%penetrations(n) = abs(found%penetration + lowest - exact%penetration)
               if (counts%areas(n) > max(relative_error_of(found%area), error_of_cell/min(cells, cells**2))) &
                  & counts%below = counts%below + 1
            end associate
         end if
      end if
   end subroutine keep

   !> The largest relative errors of pull-off after a turn at no load: of those that are too strong, and of those that are too weak.
   function pull_off_errors(cells) result(largest)
      real(dp), intent(in) :: cells
      real(dp) :: largest(2)
      type(periodic_solver_t) :: solver
      type(periodic_adhesion_t) :: adhesion
      type(periodic_pull_off_t) :: pull_off
      type(adhesive_wave_t) :: wave
      type(error_t), allocatable :: error
      real(dp) :: shape(cells_of_pull_off/2, 1), lowest, excess
      logical :: is_found
      integer :: i

      call make_line(cells_of_pull_off, shape, lowest)
      call new_periodic_solver(solver, elastic_kernel_t(), [cells_of_pull_off/2, 1], [1.0_dp, 1.0_dp], .true., error)
      largest = 0
      do i = 1, size(alphas)
         call set_adhesion(cells_of_pull_off, cells, alphas(i), adhesion)
         call new_adhesive_wave(wave, adhesion%stress/pi, adhesion%range, is_found)
         ! without folds there is no pull-off of a partial contact
         if (.not. wave%has_folds) cycle
         adhesion%has_turned = .true.
         call find_pull_off(solver, shape, adhesion, 1.0e-9_dp, pull_off, error)
         if (.not. pull_off%is_found) cycle
         excess = pull_off%mean_pressure/(pi*wave%least_load) - 1
         largest = max(largest, [excess, -excess])
      end do
   end function pull_off_errors

   !> Pull-off of spheres in cells of 17 times their contact and more.
   subroutine measure_spheres()
      real(dp), parameter :: contact = 0.06_dp, lambdas(*) = [0.3_dp, 1.0_dp, 3.0_dp]
      integer, parameter :: n = 128
      type(periodic_solver_t) :: solver
      type(periodic_adhesion_t) :: adhesion
      type(periodic_pull_off_t) :: pull_off
      type(error_t), allocatable :: error
      real(dp) :: shape(n, n), energy
      integer :: i, j

      do j = 1, n
         shape(:, j) = [(((i - 0.5_dp)**2 + (j - 0.5_dp)**2)/(2*(2*n)**2), i=1, n)]
      end do
      shape(:, :) = shape - minval(shape)
      call new_periodic_solver(solver, elastic_kernel_t(), [n, n], [1.0_dp, 1.0_dp], .true., error)
      energy = 4*contact**3/(3*pi)
      print '(a)', 'pull-off of a sphere over pi w R: lambda, cells per zone, on cells, exact, error'
      do i = 1, size(lambdas)
         adhesion%stress = lambdas(i)/2*(16*pi*energy/9)**(1.0_dp/3)
         adhesion%range = energy/adhesion%stress
         adhesion%has_turned = .true.
         call find_pull_off(solver, shape, adhesion, 1.0e-9_dp, pull_off, error)
         associate (found => pull_off%mean_pressure/(pi*energy), exact => exact_pull_off(lambdas(i)))
            print '(2f9.2, 2f12.5, es12.1)', lambdas(i), pi*adhesion%range/(4*adhesion%stress)*2*n, found, exact, &
               & abs(found/exact - 1)
         end associate
      end do
   end subroutine measure_spheres

   !> Pull-off of Maugis and Dugdale over pi w R.
   real(dp) function exact_pull_off(lambda) result(pull_off)
      real(dp), intent(in) :: lambda
      integer, parameter :: units_reduced = 2, maugis_dugdale = 5
      type(trial_case_t) :: case

      call new_case(case, 'sphere')
      call case%give('units', real(units_reduced, dp))
      call case%give('theory', real(maugis_dugdale, dp))
      call case%give('lambda', lambda)
      call case%give('load', 0.0_dp)
      call case%solve()
      pull_off = case%found('pull_off_load')
   end function exact_pull_off

end program adhesion_cells

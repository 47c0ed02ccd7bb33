! SPDX-License-Identifier: GPL-3.0-or-later
!> Time of a point of the 3-D surface under load, and error against number of strips. See bench/README.md.
!>
!> surface_3d [POINTS.csv [STRIPS.csv]]
program surface_3d
   use, intrinsic :: iso_fortran_env, only: output_unit
   use adfric_base_constants, only: two_pi
   use adfric_base_kinds, only: dp, i8
   use adfric_base_unset, only: unset
   use adfric_describe_status, only: status_solved, status_no_equilibrium, status_not_converged
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   use adfric_run_blocks, only: block_size_of
   use adfric_system_clock, only: wall_clock
   use adfric_foundation_foundation, only: new_foundation
   use adfric_foundation_model, only: wavy_model_t, new_wavy_model
   use adfric_foundation_steady_state, only: find_steady_state
   use adfric_foundation_strip, only: strip_t, steady_state_t
   use adfric_foundation_surface, only: surface_t, totals_t, new_surface_strip, add_strip
   use adfric_foundation_wave_shape, only: share_at
   use adfric_foundation_variables, only: n_wavy_results, in => foundation_input, out => foundation_output
   use measure, only: spread_t, spread_of, print_heading, text_argument, open_table
   implicit none (type, external)

   integer, parameter :: n_points = 2000, n_repeats = 5
   real(dp), parameter :: tolerance = 1.0e-8_dp, reference_tolerance = 1.0e-12_dp
   integer, parameter :: edge_continuous = 1, edge_instantaneous = 2, branch_adhered = 1, branch_approach = 2

   !> A surface in units of l, h, 1/K and h/K, a range of loads, and a penetration.
   type :: case_t
      character(40) :: name = ''
      real(dp) :: u = 1, beta = 1, stress = 0, range = 1
      integer :: edge = edge_continuous, branch = branch_adhered
      !> Loads [h/K].
      real(dp) :: from = 0, to = 1
      !> [h]
      real(dp) :: penetration = 0.3_dp
   end type case_t

   !> What a run gave.
   type :: run_t
      !> Shape `(n_wavy_results, n_points)`.
      real(dp), allocatable :: results(:, :)
      real(dp), allocatable :: error_estimate(:)
      integer, allocatable :: status(:)
      real(dp) :: strips_per_point = 0
      type(spread_t) :: time
   end type run_t

   type(case_t), allocatable :: cases(:)
   type(wavy_model_t) :: model
   integer :: k, points, strips

   call print_heading('3-D surface')
   call list_cases(cases)
   call new_wavy_model(model)
   points = open_table(text_argument(1, 'surface_3d_points.csv'), 'case,points,solved,no_equilibrium,not_converged,'// &
      'error_estimate_worst,strips_per_point,us,us_least,us_most,us_no_equilibrium')
   strips = open_table(text_argument(2, 'surface_3d_strips.csv'), 'case,rule,strips_or_tolerance,strips,us,us_least,'// &
      'us_most,load_error,friction_error,mu_error,contact_error,adhesion_error,error_estimate')
   do k = 1, size(cases)
      print '(/, a)', trim(cases(k)%name)
      call report_points(points, cases(k))
      call report_strips(strips, cases(k))
      flush (points)
      flush (strips)
      flush (output_unit)
   end do
   close (points)
   close (strips)

contains

   subroutine list_cases(cases)
      type(case_t), allocatable, intent(out) :: cases(:)

      cases = [case_t('no adhesion', 0.3_dp, 10.0_dp, from=1.0e-3_dp, to=1.0_dp), &
         case_t('saturated adhesion', 0.3_dp, 10.0_dp, 0.1_dp, 3.0_dp, from=-0.05_dp, to=1.0_dp), &
         case_t('release across the surface', 0.3_dp, 10.0_dp, 0.1_dp, 0.1_dp, from=-0.01_dp, to=1.0_dp), &
         case_t('release, approach branch', 0.3_dp, 10.0_dp, 0.1_dp, 0.1_dp, branch=branch_approach, from=0.0_dp, to=1.0_dp), &
         case_t('release, instantaneous edges', 0.3_dp, 10.0_dp, 0.1_dp, 0.1_dp, edge_instantaneous, from=-0.01_dp, &
         to=1.0_dp), &
         case_t('snap into contact', 0.3_dp, 2.0_dp, 0.3_dp, 0.05_dp, edge_instantaneous, from=-0.25_dp, to=0.25_dp), &
         case_t('strong adhesion of short range', 0.3_dp, 10.0_dp, 1.0_dp, 0.02_dp, from=-0.3_dp, to=0.3_dp), &
         case_t('fast sliding', 30.0_dp, 100.0_dp, 0.1_dp, 0.1_dp, from=-0.01_dp, to=1.0_dp), &
         case_t('slow sliding', 1.0e-3_dp, 100.0_dp, 0.1_dp, 0.1_dp, from=-0.01_dp, to=1.0_dp), &
         case_t('elastic foundation', 0.3_dp, 1.0_dp, 0.1_dp, 0.1_dp, from=-0.01_dp, to=1.0_dp)]
   end subroutine list_cases

   !> The variables of the model, such that its units are l = h = K = 1.
   pure function values_of(c) result(values)
      type(case_t), intent(in) :: c
      real(dp) :: values(in%n_y)

      values = unset
      values(in%kind) = 2
      values(in%slope) = 1
      values([in%period, in%height, in%stiffness, in%velocity]) = 1
      values(in%relaxation_time) = c%u/two_pi
      values(in%retardation_ratio) = c%beta
      values(in%stress) = c%stress
      values(in%range) = c%range
      values(in%edge) = c%edge
      values(in%branch) = c%branch
      values(in%relative_tolerance) = tolerance
      values(in%strips) = 0
   end function values_of

   !> Solve points in blocks as the program does.
   subroutine run(values, result)
      real(dp), intent(in) :: values(:, :)
      type(run_t), intent(out) :: result
      real(dp) :: counts(2)
      real(dp) :: times(n_repeats), start
      integer :: n, r, block, first, last

      n = size(values, 2)
      block = block_size_of(int(n, i8))
      allocate (result%results(n_wavy_results, n), result%error_estimate(n), result%status(n))
      do r = 1, n_repeats
         result%strips_per_point = 0
         call new_wavy_model(model)
         start = wall_clock()
         call model%prepare()
         do first = 1, n, block
            last = min(n, first + block - 1)
            call model%solve_block(values(:, first:last), result%results(:, first:last), &
               result%error_estimate(first:last), result%status(first:last), counts)
            result%strips_per_point = result%strips_per_point + counts(1)/n
         end do
         call model%release()
         times(r) = 1.0e6_dp*(wall_clock() - start)/n
      end do
      result%time = spread_of(times)
   end subroutine run

   !> Time of points under load, those that have an equilibrium and those that have none.
   subroutine report_points(table, c)
      integer, intent(in) :: table
      type(case_t), intent(in) :: c
      type(run_t) :: result, beyond
      real(dp) :: values(in%n_y, n_points)
      integer :: counts(3), k

      do k = 1, n_points
         values(:, k) = values_of(c)
         values(in%load, k) = c%from + (c%to - c%from)*(k - 1)/(n_points - 1)
      end do
      ! how many there are, and the time of those that are not
      call run(values, result)
      counts = [count(result%status == status_solved), count(result%status == status_no_equilibrium), &
         count(result%status == status_not_converged)]
      ! below the pull-off load, so the first ones
      k = counts(2)
      if (k > 0) then
         call run(values(:, :k), beyond)
         call run(values(:, k + 1:), result)
      end if
      associate (worst => maxval(result%error_estimate, mask=result%status == status_solved), t => result%time)
         print '(3(a, i0), a, es7.1, a, f0.1)', 'under load: ', counts(1), ' solved, ', counts(2), ' no equilibrium, ', &
            counts(3), ' not converged; worst estimate ', worst, ', strips per point ', result%strips_per_point
         print '(3(a, f0.1), a)', 'us per point with equilibrium ', t%median, ' (', t%least, ' to ', t%most, ')'
         if (k > 0) print '(a, f0.1)', 'us per point without ', beyond%time%median
         write (table, '(3a, 4(",", i0), ",", es8.2, 5(",", g0.5))') '"', trim(c%name), '"', n_points, counts, worst, &
            result%strips_per_point, t%median, t%least, t%most, beyond%time%median
      end associate
   end subroutine report_points

   !> Error against number of strips: the paper's equal ones, Gauss's rule on equal panels, and the program's rule.
   subroutine report_strips(table, c)
      integer, intent(in) :: table
      type(case_t), intent(in) :: c
      type(run_t) :: reference, result
      real(dp) :: values(in%n_y, 1)
      integer :: k

      values(:, 1) = values_of(c)
      values(in%penetration, 1) = c%penetration
      values(in%relative_tolerance, 1) = reference_tolerance
      call run(values, reference)
      print '(a, f0.3, a)', 'at penetration ', c%penetration, ':'
      print '(a10, a9, a9, a10, 6a10)', 'rule', 'n or tol', 'strips', 'us', 'err P', 'err T', 'err mu', 'contact', 'adhesion', &
         'estimate'
      do k = 2, 12
         values(in%strips, 1) = 2**k
         call run(values, result)
         call report_rule(table, c, 'equal', real(2**k, dp), result, reference)
      end do
      values(in%strips, 1) = 0
      do k = 0, 8
         call run_gauss(c, 2**k, result)
         call report_rule(table, c, 'gauss', real(2**k, dp), result, reference)
      end do
      do k = 2, 11
         values(in%relative_tolerance, 1) = 10.0_dp**(-k)
         call run(values, result)
         call report_rule(table, c, 'adaptive', 10.0_dp**(-k), result, reference)
      end do
   end subroutine report_strips

   !> Gauss's rule of 16 strips on each of a number of equal panels, wherever the regimes change.
   subroutine run_gauss(c, n_panels, result)
      type(case_t), intent(in) :: c
      integer, intent(in) :: n_panels
      type(run_t), intent(out) :: result
      type(surface_t) :: surface
      type(strip_t) :: strip
      type(steady_state_t) :: state, last
      type(totals_t) :: totals
      real(dp) :: times(n_repeats), start, share, theta
      integer :: r, panel, k

      surface%shape%is_3d = .true.
      call new_foundation(surface%foundation, c%u, c%beta)
      surface%adhesion%stress = c%stress
      surface%adhesion%range = c%range
      surface%adhesion%edge = c%edge
      surface%branch = c%branch
      do r = 1, n_repeats
         totals = totals_t()
         last = steady_state_t()
         start = wall_clock()
         do panel = 1, n_panels
            do k = 1, size(gauss_nodes)
               theta = (panel - 0.5_dp + gauss_nodes(k)/2)/n_panels*two_pi/2
               share = share_at(theta)
               call new_surface_strip(surface, c%penetration, share, strip)
               call find_steady_state(strip, surface%branch, state, last)
               call add_strip(surface, strip, state, share, gauss_weights(k)/(2*n_panels), totals)
               last = state
            end do
         end do
         times(r) = 1.0e6_dp*(wall_clock() - start)
      end do
      result%time = spread_of(times)
      result%strips_per_point = totals%n_strips
      allocate (result%results(n_wavy_results, 1), source=0.0_dp)
      allocate (result%error_estimate(1), source=0.0_dp)
      result%results([out%load, out%friction_force, out%contact_area, out%adhesion_area], 1) = &
         [totals%load, totals%friction, totals%contact, totals%adhesion]
      result%results(out%friction_coefficient, 1) = totals%friction/totals%load
   end subroutine run_gauss

   subroutine report_rule(table, c, rule, setting, result, reference)
      integer, intent(in) :: table
      type(case_t), intent(in) :: c
      character(*), intent(in) :: rule
      real(dp), intent(in) :: setting
      type(run_t), intent(in) :: result, reference
      integer, parameter :: judged(*) = [out%load, out%friction_force, out%friction_coefficient, out%contact_area, &
         & out%adhesion_area]
      real(dp) :: errors(size(judged) + 1)

      errors = [relative(result%results(judged, 1), reference%results(judged, 1)), result%error_estimate(1)]
      print '(a10, es9.1, f9.0, f10.1, 6es10.1)', rule, setting, result%strips_per_point, result%time%median, errors
      write (table, '(3a, ",", a, ",", es8.2, 4(",", g0.5), 6(",", es8.2))') '"', trim(c%name), '"', rule, setting, &
         result%strips_per_point, result%time%median, result%time%least, result%time%most, errors
   end subroutine report_rule

   elemental real(dp) function relative(value, reference)
      real(dp), intent(in) :: value, reference

      relative = abs(value - reference)/max(abs(reference), tiny(1.0_dp))
   end function relative

end program surface_3d

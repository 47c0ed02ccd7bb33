! SPDX-License-Identifier: GPL-3.0-or-later
!> The sinusoidal wave on an elastic half-plane by the solver of periodic surfaces, against Westergaard's solution.
!>
!>     wave_1d [TABLE.csv]
!>
!> Cells are those of a period, of which half is solved. The largest pressure is that of the crest, from the two cells beside it.
!> See bench/README.md.
program wave_1d
   use, intrinsic :: iso_fortran_env, only: output_unit
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_base_error, only: error_t
   use adfric_plane_westergaard, only: wave_half_width, wave_pressure, wave_penetration
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_solver, only: periodic_solver_t, periodic_solution_t, new_periodic_solver, contact_solved
   use adfric_system_clock, only: wall_clock
   use measure, only: spread_t, spread_of, print_heading, text_argument, open_table
   use trial_surfaces, only: line_wave
   implicit none (type, external)

   integer, parameter :: n_repeats = 9
   real(dp), parameter :: loads(*) = [0.01_dp, 0.05_dp, 0.1_dp, 0.25_dp, 0.5_dp, 0.75_dp, 0.9_dp, 0.99_dp]
   real(dp), parameter :: tolerance = 1.0e-10_dp
   !> Goal for the largest pressure, in p*, on 4096 cells from the second load on.
   integer, parameter :: goal_cells = 4096
   real(dp), parameter :: goal = 1.0e-7_dp
   logical :: is_reached
   integer :: table, k

   call print_heading('1-D wave on an elastic half-plane')
   table = open_table(text_argument(1, 'wave_1d.csv'), 'cells,load,ms,ms_least,ms_most,residual,peak_error,width_error,'// &
      'width_estimate,penetration_error')
   print '(a7, a7, a24, a9, 4a10)', 'cells', 'p/p*', 'ms (range)', 'residual', 'peak', 'width', 'estimate', 'penetr.'
   is_reached = .true.
   do k = 6, 14
      call report_size(table, 2**k, is_reached)
   end do
   close (table)
   flush (output_unit)
   if (.not. is_reached) error stop 'wave_1d: the goal is missed'

contains

   !> All loads on one grid.
   subroutine report_size(table, n, is_reached)
      integer, intent(in) :: table, n
      logical, intent(inout) :: is_reached
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: solution
      type(error_t), allocatable :: error
      real(dp) :: shape(n/2, 1), times(n_repeats), errors(3)
      type(spread_t) :: time
      integer :: k, r

      call new_periodic_solver(solver, elastic_kernel_t(), [n/2, 1], [1.0_dp, 1.0_dp], .true., error)
      if (allocated(error)) error stop 'no solver'
      shape = line_wave(n, n/2)
      do k = 1, size(loads)
         do r = 1, n_repeats
            times(r) = wall_clock()
            call solver%solve_load(shape, loads(k), tolerance, solution, error)
            times(r) = 1000*(wall_clock() - times(r))
         end do
         if (solution%status /= contact_solved) error stop 'not converged'
         time = spread_of(times)
         associate (p => solution%pressure(:2, 1))
            errors = abs([(9*p(1) - p(2))/8 - wave_pressure(loads(k), 0.0_dp), &
               solution%area%corrected - 2*wave_half_width(loads(k)), &
               solution%penetration - 2*wave_penetration(loads(k))/two_pi])
         end associate
         print '(i7, f7.2, f9.3, 2(a, f6.3), a, es8.1, 4es10.1)', n, loads(k), time%median, ' (', time%least, ' to ', time%most, &
            ')', solution%residual, errors(1:2), solution%area%error, errors(3)
         write (table, '(i0, 4(",", f0.4), 5(",", es8.2))') n, loads(k), time, solution%residual, errors(1:2), &
            solution%area%error, errors(3)
         if (n == goal_cells .and. k > 1) is_reached = is_reached .and. errors(1) < goal
      end do
   end subroutine report_size

end program wave_1d

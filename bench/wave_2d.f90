! SPDX-License-Identifier: GPL-3.0-or-later
!> The bi-sinusoidal wave on an elastic half-space: time and error of one load against the number of cells.
!>
!>     wave_2d [TABLE.csv [CELLS [DIGITS]]]
!>
!> All sizes, or one number of cells a period; residual 10**(-DIGITS), of which 10 is the default. Areas are compared with the table
!> of the tests, largest pressures with those of the finest grid, where all sizes are asked for.
!> The surface is z = D (2 - cos 2 pi x/l - cos 2 pi y/l), full contact at p* = 2 pi E* D/l. By quarter cell and cosine
!> transforms, and as a general surface; each load starts from nothing.
program wave_2d
   use, intrinsic :: iso_fortran_env, only: output_unit
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_base_not_a_number, only: not_a_number
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_solver, only: periodic_solver_t, periodic_solution_t, new_periodic_solver, contact_solved
   use adfric_periodic_wave_2d_model, only: wave_2d_model_t, new_wave_2d_model
   use adfric_system_clock, only: wall_clock
   use measure, only: spread_t, spread_of, print_heading, text_argument, integer_argument, open_table
   use trial_surfaces, only: wave
   implicit none (type, external)

   integer, parameter :: n_repeats = 5
   !> Loads over that of full contact and the areas of tests/reference/bisine_area.csv.
   real(dp), parameter :: loads(*) = [0.01_dp, 0.1_dp, 0.25_dp, 0.5_dp, 0.9_dp, 0.99_dp]
   real(dp), parameter :: areas(*) = [0.03636_dp, 0.19054_dp, 0.44358_dp, 0.70412_dp, 0.95064_dp, 0.99520_dp]
   !> Cells of the finest grid.
   integer, parameter :: finest = 2048
   !> Largest pressure on the finest grid; 0 where it is not known.
   real(dp) :: peaks(size(loads)) = 0
   real(dp) :: tolerance
   integer :: table, n

   call print_heading('2-D wave on an elastic half-space')
   tolerance = 10.0_dp**(-integer_argument(3, 10))
   table = open_table(text_argument(1, 'wave_2d.csv'), 'surface,cells,load,ms,ms_least,ms_most,setup_ms,residual,iterations,'// &
      'applied,pairs,area,area_error_estimate,area_difference,peak,peak_difference')
   print '(a8, a7, a7, a24, a9, a9, 3a7, a10, 2a9, a10, a9)', 'surface', 'cells', 'p/p*', 'ms (range)', 'set-up', 'residual', &
      'steps', 'apply', 'pairs', 'area', 'estimate', 'differs', 'peak', 'differs'
   n = integer_argument(2, 0)
   if (n > 0) then
      call report_size(table, n, .true.)
      call report_size(table, n, .false.)
   else
      call report_size(table, finest, .true.)
      do n = 7, 10
         call report_size(table, 2**n, .true.)
      end do
      do n = 7, 10
         call report_size(table, 2**n, .false.)
      end do
   end if
   close (table)

contains

   !> All loads on one grid of n by n cells a period.
   subroutine report_size(table, n, is_quarter)
      integer, intent(in) :: table, n
      logical, intent(in) :: is_quarter
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: solution
      type(error_t), allocatable :: error
      real(dp), allocatable :: shape(:, :)
      real(dp) :: times(n_repeats), setup
      character(7) :: name
      integer :: k, r

      setup = wall_clock()
      name = merge('quarter', 'general', is_quarter)
      call new_periodic_solver(solver, elastic_kernel_t(), [1, 1]*merge(n/2, n, is_quarter), [1.0_dp, 1.0_dp], &
         is_quarter, error, is_measured=.true.)
      setup = wall_clock() - setup
      if (allocated(error)) error stop 'no solver'
      shape = wave(n, merge(n/2, n, is_quarter))
      do k = 1, size(loads)
         do r = 1, n_repeats
            times(r) = wall_clock()
            call solver%solve_load(shape, loads(k), tolerance, solution, error)
            times(r) = wall_clock() - times(r)
         end do
         if (allocated(error)) error stop 'no solution'
         if (solution%status /= contact_solved) error stop 'not converged'
         if (n == finest) peaks(k) = peak_of(solution)
         call report(table, name, n, k, spread_of(1000*times), 1000*setup, solution, peaks(k))
      end do
   end subroutine report_size

   subroutine report(table, name, n, k, time, setup, solution, finest_peak)
      integer, intent(in) :: table, n, k
      character(*), intent(in) :: name
      type(spread_t), intent(in) :: time
      real(dp), intent(in) :: setup, finest_peak
      type(periodic_solution_t), intent(in) :: solution

      real(dp) :: difference(2)

      difference = [solution%area%corrected - areas(k), peak_of(solution) - finest_peak]
      if (.not. finest_peak > 0) difference(2) = not_a_number()
      associate (s => solution)
         print '(a8, i7, f7.3, f8.1, 2(a, f6.1), a, f9.1, es9.1, 2i7, f7.1, f10.6, 2es9.1, f10.6, es9.1)', name, n, loads(k), &
            time%median, ' (', time%least, ' to', time%most, ')', setup, s%residual, s%n_iterations, s%n_applied, s%n_pairs, &
            s%area%corrected, s%area%error, difference(1), peak_of(s), difference(2)
         write (table, '(a, ",", i0, 5(",", f0.4), ",", es8.2, 2(",", i0), 2(",", f0.8), 2(",", es9.2), ",", f0.8, ",", es9.2)') &
            trim(name), n, loads(k), time, setup, s%residual, s%n_iterations, s%n_applied, s%n_pairs, s%area%corrected, &
            s%area%error, difference(1), peak_of(s), difference(2)
      end associate
      flush (output_unit)
   end subroutine report

   !> The pressure of the crest [E*], as the model `wave_2d_elastic` has it.
   real(dp) function peak_of(solution)
      type(periodic_solution_t), intent(in) :: solution
      type(wave_2d_model_t) :: model
      real(dp), allocatable :: values(:)

      call new_wave_2d_model(model)
      allocate (values(size(model%variables)), source=1.0_dp)
      peak_of = model%get_peak_pressure(values, solution%pressure)
   end function peak_of

end program wave_2d

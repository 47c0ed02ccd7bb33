! SPDX-License-Identifier: GPL-3.0-or-later
!> Random self-affine surfaces on an elastic half-space: time, transforms and residual of one load.
!>
!>     rough_surface [TABLE.csv [LARGEST [DIGITS]]]
!>
!> 256 to LARGEST cells (2048 if absent) along x and y, residual 10**(-DIGITS), of which 10 is the default. Surfaces have the power
!> |k|^(-2 - 2 H) from a quarter to a 64th of the period, or down to the cells, and are the same on any number of cells but for the
!> latter. Loads are parts of the root mean square of the pressure of full contact. Each starts from nothing, by one thread and by all.
!> A pair of transforms is one application of the stiffness; coarser grids count by their cells.
program rough_surface
   use, intrinsic :: iso_fortran_env, only: output_unit
   use omp_lib, only: omp_get_max_threads, omp_set_num_threads
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_operator, only: periodic_operator_t, new_periodic_operator
   use adfric_periodic_solver, only: periodic_solver_t, periodic_solution_t, new_periodic_solver, contact_solved
   use adfric_system_clock, only: wall_clock
   use measure, only: spread_t, spread_of, print_heading, text_argument, integer_argument, open_table
   use rough_shapes, only: make_surface
   implicit none (type, external)

   integer, parameter :: n_repeats = 3
   real(dp), parameter :: loads(*) = [0.01_dp, 0.025_dp, 0.2_dp, 0.4_dp, 1.0_dp, 2.0_dp, 3.0_dp]
   real(dp), parameter :: exponents(*) = [0.8_dp, 0.3_dp]
   real(dp) :: tolerance
   integer :: table, n, k, n_threads

   call print_heading('random surfaces on an elastic half-space')
   tolerance = 10.0_dp**(-integer_argument(3, 10))
   n_threads = omp_get_max_threads()
   table = open_table(text_argument(1, 'rough_surface.csv'), 'cells,hurst,shortest,load,area,threads,ms,ms_least,ms_most,'// &
      'pairs,pairs_finest,steps,residual')
   print '(a6, a6, a9, a7, a8, a24, a8, a8, a7, a7, a10)', 'cells', 'hurst', 'shortest', 'load', 'area', 'ms (range)', &
      'threads', 'pairs', 'finest', 'steps', 'residual'
   n = 256
   do while (n <= integer_argument(2, 2048))
      do k = 1, size(exponents)
         call report_surface(table, n, exponents(k), 64)
         call report_surface(table, n, exponents(k), n/2 - 1)
      end do
      n = 2*n
   end do
   close (table)

contains

   !> All loads of one surface.
   subroutine report_surface(table, n, hurst, most_waves)
      integer, intent(in) :: table, n, most_waves
      real(dp), intent(in) :: hurst
      real(dp), allocatable :: shape(:, :), tension(:, :)
      type(periodic_solver_t) :: solver
      type(periodic_operator_t) :: operator
      type(error_t), allocatable :: error
      real(dp) :: scale
      integer :: k

      call make_surface(n, hurst, most_waves, shape)
      allocate (tension, mold=shape)
      call new_periodic_operator(operator, elastic_kernel_t(), [n, n], [1.0_dp, 1.0_dp], .false., .false., error)
      call operator%apply_stiffness(shape, tension)
      scale = sqrt(sum(tension**2)/size(tension))
      call new_periodic_solver(solver, elastic_kernel_t(), [n, n], [1.0_dp, 1.0_dp], .false., error)
      if (allocated(error)) error stop 'no solver'
      do k = 1, size(loads)
         call omp_set_num_threads(1)
         call report_load(table, n, hurst, most_waves, loads(k), solver, shape, scale, 1)
         if (n_threads == 1) cycle
         call omp_set_num_threads(n_threads)
         call report_load(table, n, hurst, most_waves, loads(k), solver, shape, scale, n_threads)
      end do
   end subroutine report_surface

   !> One load on one number of threads.
   subroutine report_load(table, n, hurst, most_waves, load, solver, shape, scale, n_threads)
      integer, intent(in) :: table, n, most_waves, n_threads
      real(dp), intent(in) :: hurst, load, shape(:, :), scale
      type(periodic_solver_t), intent(inout) :: solver
      type(periodic_solution_t) :: solution
      type(error_t), allocatable :: error
      type(spread_t) :: time
      real(dp) :: times(n_repeats)
      integer :: r

      do r = 1, n_repeats
         times(r) = wall_clock()
         call solver%solve_load(shape, load*scale, tolerance, solution, error)
         times(r) = wall_clock() - times(r)
      end do
      if (allocated(error)) error stop 'no solution'
      if (solution%status /= contact_solved) error stop 'not converged'
      time = spread_of(1000*times)
      associate (s => solution)
         print '(i6, f6.1, i9, f7.3, f8.4, f8.1, 2(a, f6.1), a, i8, f8.1, i7, i7, es10.1)', n, hurst, most_waves, load, &
            s%area%cells, time%median, ' (', time%least, ' to', time%most, ')', n_threads, s%n_pairs, s%n_applied, s%n_iterations, &
            s%residual
         write (table, '(i0, ",", f0.2, ",", i0, 2(",", f0.6), ",", i0, 4(",", f0.3), 2(",", i0), ",", es8.2)') n, &
            hurst, most_waves, load, s%area%cells, n_threads, time, s%n_pairs, s%n_applied, s%n_iterations, s%residual
      end associate
      flush (output_unit)
   end subroutine report_load

end program rough_surface

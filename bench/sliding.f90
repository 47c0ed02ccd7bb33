! SPDX-License-Identifier: GPL-3.0-or-later
!> Steady sliding over a viscoelastic half-space: time, transforms and error of one load.
!>
!>     sliding [TABLE.csv [LARGEST]]
!>
!> A wave in one direction beside its closed form, a wave in two beside more cells, and random surfaces up to LARGEST cells (1024 if
!> absent) along x and y, by one thread and by all. Waves slide over one relaxation time, kg/k0 = 10; random surfaces over 13 times
!> in 12 decades, kg/k0 = 770. Times contain the preparation of the solver for the velocity. Friction is that of the loss. A pair of
!> transforms is one application of the stiffness; coarser grids count by their cells.
program sliding
   use, intrinsic :: iso_fortran_env, only: output_unit
   use omp_lib, only: omp_get_max_threads, omp_set_num_threads
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_base_error, only: error_t
   use adfric_plane_sliding_wave_units, only: wave_slide_t, wave_slide_state_t, new_wave_slide
   use adfric_solid_prony, only: prony_t, new_prony
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_sliding_kernel, only: sliding_kernel_t, new_sliding_kernel
   use adfric_periodic_solver, only: periodic_solver_t, periodic_solution_t, new_periodic_solver, contact_solved
   use adfric_system_clock, only: wall_clock
   use measure, only: print_heading, text_argument, integer_argument, open_table, spread_t, spread_of
   use rough_shapes, only: make_surface
   implicit none (type, external)

   integer, parameter :: n_repeats = 3, finest_wave = 1024
   real(dp), parameter :: tolerance = 1.0e-8_dp, speeds(*) = [0.01_dp, 0.1_dp, 1.0_dp, 10.0_dp, 100.0_dp]
   integer :: table, n, n_threads

   call print_heading('steady sliding over a viscoelastic half-space')
   n_threads = omp_get_max_threads()
   table = open_table(text_argument(1, 'sliding.csv'), 'case,cells,speed,load,area,threads,ms,ms_least,ms_most,pairs,steps,'// &
      'friction,error,imbalance')
   print '(a10, a6, a10, a10, a8, a8, a29, a8, a7, a12, a9, a10)', 'case', 'cells', 'speed', 'load', 'area', 'threads', &
      'ms (range)', 'pairs', 'steps', 'friction', 'error', 'imbalance'
   call omp_set_num_threads(1)
   n = 128
   do while (n <= 4096)
      call report_line(n)
      n = 2*n
   end do
   call report_waves()
   n = 256
   do while (n <= integer_argument(2, 1024))
      call report_rough(n, n/8)
      call report_rough(n, n/2 - 1)
      n = 2*n
   end do
   close (table)

contains

   !> One solid for waves: one time of 1 s.
   subroutine make_standard_solid(prony)
      type(prony_t), intent(out) :: prony

      call new_prony(prony, 1.0_dp, [9.0_dp], [1.0_dp])
   end subroutine make_standard_solid

   !> The wave in one direction, at all speeds, beside the closed form.
   subroutine report_line(n)
      integer, intent(in) :: n
      type(prony_t) :: prony
      type(wave_slide_t) :: wave
      type(wave_slide_state_t) :: state
      real(dp), allocatable :: shape(:, :)
      logical :: is_possible, is_converged
      integer :: i, k

      call make_standard_solid(prony)
      allocate (shape(n, 1))
      shape(:, 1) = [(1 - cos(two_pi*(i - 0.5_dp)/n), i=1, n)]/two_pi
      do k = 1, size(speeds)
         call new_wave_slide(wave, 1.0_dp, 1/two_pi, prony, speeds(k)/two_pi, is_possible)
         if (is_possible) call wave%solve_pressure(0.2_dp, state, is_converged)
         if (.not. (is_possible .and. is_converged)) error stop 'no closed form'
         call report_load('wave_1d', shape, prony, speeds(k), 0.2_dp, 1, state%friction_stress)
      end do
   end subroutine report_line

   !> The wave in two directions, at all speeds and numbers of cells, beside more cells.
   subroutine report_waves()
      type(prony_t) :: prony
      type(periodic_solution_t) :: finest
      real(dp), allocatable :: shape(:, :)
      integer :: k, n

      call make_standard_solid(prony)
      do k = 1, size(speeds)
         call make_wave(finest_wave, shape)
         call solve(shape, prony, speeds(k), 0.2_dp, finest)
         n = 64
         do while (n < finest_wave)
            call make_wave(n, shape)
            call report_load('wave_2d', shape, prony, speeds(k), 0.2_dp, 1, finest%friction%loss(1))
            n = 2*n
         end do
      end do
   end subroutine report_waves

   !> A wave in both directions.
   subroutine make_wave(n, shape)
      integer, intent(in) :: n
      real(dp), allocatable, intent(out) :: shape(:, :)
      integer :: i, j

      allocate (shape(n, n))
      do j = 1, n
         shape(:, j) = [(2 - cos(two_pi*(i - 0.5_dp)/n) - cos(two_pi*(j - 0.5_dp)/n), i=1, n)]/two_pi
      end do
      shape = shape - minval(shape)
   end subroutine make_wave

   !> A random surface with waves from a quarter of the period on.
   subroutine report_rough(n, most_waves)
      integer, intent(in) :: n, most_waves
      real(dp), parameter :: loads(*) = [0.03_dp, 0.1_dp, 0.4_dp], velocities(*) = [1.0e-2_dp, 1.0e2_dp, 1.0e6_dp]
      type(prony_t) :: prony
      type(periodic_solution_t) :: full
      real(dp), allocatable :: shape(:, :)
      integer :: i, k, l

      call new_prony(prony, 1.0_dp, [(2.0_dp**(i/2.0_dp)*8.55_dp, i=0, 12)], [(10.0_dp**(-i), i=0, 12)])
      call make_surface(n, 0.8_dp, most_waves, shape)
      do k = 1, size(velocities)
         call solve(shape, prony, two_pi*velocities(k), huge(1.0_dp)**0.25_dp, full)
         do l = 1, size(loads)
            call report_load(merge('rough ', 'smooth', most_waves > n/4), shape, prony, two_pi*velocities(k), &
               & loads(l)*full%full_pressure, 1)
            if (n_threads > 1) call report_load(merge('rough ', 'smooth', most_waves > n/4), shape, prony, &
               & two_pi*velocities(k), loads(l)*full%full_pressure, n_threads)
         end do
      end do
   end subroutine report_rough

   !> Solve one load from nothing, with a solver of its own.
   subroutine solve(shape, prony, speed, load, solution)
      real(dp), intent(in) :: shape(:, :), speed, load
      type(prony_t), intent(in) :: prony
      type(periodic_solution_t), intent(out) :: solution
      type(sliding_kernel_t) :: kernel
      type(periodic_solver_t) :: solver
      type(error_t), allocatable :: error

      call new_sliding_kernel(kernel, elastic_kernel_t(), prony, speed/two_pi, [1, 0])
      call new_periodic_solver(solver, kernel, [size(shape, 1), size(shape, 2)], [1.0_dp, 1.0_dp], .false., error)
      if (allocated(error)) error stop 'no solver'
      call solver%solve_load(shape, load, tolerance, solution, error)
      if (allocated(error)) error stop 'no solution'
      if (solution%status /= contact_solved) error stop 'not converged'
   end subroutine solve

   !> One load on one number of threads.
   subroutine report_load(name, shape, prony, speed, load, n_threads, exact)
      character(*), intent(in) :: name
      real(dp), intent(in) :: shape(:, :), speed, load
      type(prony_t), intent(in) :: prony
      integer, intent(in) :: n_threads
      real(dp), intent(in), optional :: exact
      type(periodic_solution_t) :: solution
      type(spread_t) :: time
      real(dp) :: times(n_repeats), error, imbalance
      integer :: r

      call omp_set_num_threads(n_threads)
      do r = 1, n_repeats
         times(r) = wall_clock()
         call solve(shape, prony, speed, load, solution)
         times(r) = wall_clock() - times(r)
      end do
      call omp_set_num_threads(1)
      time = spread_of(1000*times)
      associate (s => solution, friction => solution%friction%loss(1))
         error = 0
         if (present(exact)) error = abs(friction/exact - 1)
         imbalance = s%friction%direct(1)/friction - 1
         print '(a10, i6, es10.1, es10.2, f8.4, i8, f9.2, 2(a, f8.2), a, f8.1, i7, es12.4, es9.1, es10.1)', name, size(shape, 1), &
            & speed, &
            & load, s%area%cells, n_threads, time%median, ' (', time%least, ' to', time%most, ')', s%n_pairs, s%n_iterations, &
            & friction, error, imbalance
         write (table, '(2a, i0, 3(",", es12.5), ",", i0, 3(",", f0.3), ",", f0.2, ",", i0, 3(",", es12.5))') trim(name), ',', &
            & size(shape, 1), speed, load, s%area%cells, n_threads, time, s%n_pairs, s%n_iterations, friction, error, imbalance
      end associate
      flush (output_unit)
   end subroutine report_load

end program sliding

! SPDX-License-Identifier: GPL-3.0-or-later
!> Surfaces that adhere to a half-space: time of a load and of the pull-off, on one thread, and of a large surface on all. See
!> bench/README.md.
!>
!> The law of adhesion is Dugdale's, and an exponential one of the same work and range beside it.
!>
!> adhesion [TABLE.csv [HEIGHTS]]
!>
!> HEIGHTS receives the gaps of the rough surface, raw numbers, for `adhesion_public`.
program adhesion
   use omp_lib, only: omp_get_max_threads, omp_set_num_threads
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp
   use adfric_interface_attraction, only: attraction_by_work, law_exponential
   use adfric_periodic_adhesive_pull_off, only: periodic_pull_off_t, find_pull_off
   use adfric_periodic_adhesive_solver, only: periodic_adhesion_t, solve_adhesive_load
   use adfric_periodic_attracted_surface, only: periodic_attraction_t, solve_attracted_load
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_solver, only: periodic_solver_t, periodic_solution_t, new_periodic_solver, contact_solved
   use adfric_system_clock, only: wall_clock
   use measure, only: print_heading, text_argument, open_table, spread_t, spread_of
   use rough_shapes, only: make_surface
   use trial_surfaces, only: wave
   implicit none (type, external)

   real(dp), parameter :: tolerance = 1.0e-10_dp, two_pi = 6.283185307179586476925286766559_dp
   !> Stresses over p* and ranges over the amplitude of the wave.
   real(dp), parameter :: stresses(*) = [0.3_dp, 0.6_dp], ranges(*) = [0.3_dp, 0.1_dp], loads(*) = [0.02_dp, 0.2_dp]
   !> Cells of the wave, of a finer one, of the rough surface, and of a large one; repetitions.
   integer, parameter :: n_wave = 256, n_fine = 1024, n_rough = 512, n_large = 1024, n_times = 3
   !> Hurst exponent and height of the rough surface, its stresses and load over E*, and ranges over its height: 8 and 1.6 cells a
   !> zone.
   real(dp), parameter :: hurst = 0.8_dp, rough_height = 0.02_dp
   real(dp), parameter :: rough_stresses(*) = [0.05_dp, 0.1_dp], rough_ranges(*) = [0.05_dp, 0.02_dp], rough_load = 0.01_dp
   integer, parameter :: most_waves = 32
   integer :: table, n_threads

   n_threads = omp_get_max_threads()
   call omp_set_num_threads(1)
   call print_heading('Surfaces that adhere to a half-space')
   table = open_table(text_argument(1, 'adhesion.csv'), &
      & 'surface,law,cells,stress,range,branch,load,ms,pairs,residual,contact,mean_gap,threads')
   print '(a10, a12, a7, 2a9, a10, a10, a10, a8, 3a12, a9)', 'surface', 'law', 'cells', 'stress', 'range', 'branch', 'load', 'ms', &
      & 'pairs', 'residual', 'contact', 'mean gap', 'threads'
   call solve_waves(n_wave, n_times, .true.)
   call solve_waves(n_fine, 1, .false.)
   call solve_rough()
   if (n_threads > 1) call share_large()
   close (table)

contains

   !> Loads and pull-off of the wave.
   subroutine solve_waves(n, n_repeated, is_whole)
      integer, intent(in) :: n, n_repeated
      !> With both branches, and the pull-off?
      logical, intent(in) :: is_whole
      type(periodic_solver_t) :: solver
      type(error_t), allocatable :: error
      real(dp), allocatable :: shape(:, :)
      real(dp) :: lowest
      integer :: i, k, branch

      allocate (shape, source=wave(n, n/2))
      lowest = minval(shape)
      shape(:, :) = shape - lowest
      call new_periodic_solver(solver, elastic_kernel_t(), [n/2, n/2], [1.0_dp, 1.0_dp], .true., error)
      do i = 1, size(stresses)
         do k = 1, size(loads)
            do branch = 1, merge(2, 1, is_whole)
               call solve(solver, 'wave', shape, loads(k), periodic_adhesion_t(stresses(i), ranges(i)/two_pi, branch == 1), &
                  & .false., n, n_repeated)
               if (is_whole) call solve(solver, 'wave', shape, loads(k), &
                  & periodic_adhesion_t(stresses(i), ranges(i)/two_pi, branch == 1), .true., n, n_repeated)
            end do
         end do
         if (is_whole) call pull(solver, shape, periodic_adhesion_t(stresses(i), ranges(i)/two_pi), n)
      end do
   end subroutine solve_waves

   !> Loads of the rough surface.
   subroutine solve_rough()
      type(periodic_solver_t) :: solver
      type(error_t), allocatable :: error
      real(dp), allocatable :: shape(:, :)
      character(:), allocatable :: path
      integer :: i, k, branch, file

      call make_surface(n_rough, hurst, most_waves, shape)
      shape(:, :) = rough_height*shape
      allocate (path, source=text_argument(2, ''))
      if (len(path) > 0) then
         open (newunit=file, file=path, access='stream', form='unformatted', action='write', status='replace')
         write (file) shape
         close (file)
      end if
      call new_periodic_solver(solver, elastic_kernel_t(), [n_rough, n_rough], [1.0_dp, 1.0_dp], .false., error)
      do k = 1, size(rough_stresses)
         do branch = 1, 2
            do i = 1, 2
               call solve(solver, 'rough', shape, rough_load, periodic_adhesion_t(rough_stresses(k), rough_ranges(k)*rough_height, &
                  & branch == 1), i == 2, n_rough, 1)
            end do
         end do
      end do
   end subroutine solve_rough

   !> A load of a large rough surface on one thread and on all.
   subroutine share_large()
      type(periodic_solver_t) :: solver
      type(error_t), allocatable :: error
      real(dp), allocatable :: shape(:, :)
      integer :: branch, k

      call make_surface(n_large, hurst, most_waves, shape)
      shape(:, :) = rough_height*shape
      call new_periodic_solver(solver, elastic_kernel_t(), [n_large, n_large], [1.0_dp, 1.0_dp], .false., error)
      do branch = 1, 2
         do k = 1, 2
            call omp_set_num_threads(merge(1, n_threads, k == 1))
            call solve(solver, 'large', shape, rough_load, periodic_adhesion_t(rough_stresses(1), rough_ranges(1)*rough_height, &
               & branch == 1), .false., n_large, 1)
         end do
      end do
   end subroutine share_large

   !> A line of the table: a load.
   subroutine solve(solver, name, shape, load, law, is_exponential, n, n_repeated)
      type(periodic_solver_t), intent(inout) :: solver
      character(*), intent(in) :: name
      real(dp), intent(in) :: shape(:, :), load
      type(periodic_adhesion_t), intent(in) :: law
      !> Does the tension fall exponentially, with the work and the range of `law`?
      logical, intent(in) :: is_exponential
      integer, intent(in) :: n, n_repeated
      type(periodic_attraction_t) :: attraction
      type(periodic_solution_t) :: found
      type(error_t), allocatable :: error
      type(spread_t) :: times
      real(dp) :: seconds(n_repeated)
      integer :: k

      attraction%law = attraction_by_work(law_exponential, law%stress*law%range, law%range)
      attraction%is_adhered = law%is_adhered
      do k = 1, n_repeated
         seconds(k) = wall_clock()
         if (is_exponential) then
            call solve_attracted_load(solver, shape, load, attraction, tolerance, found, error)
         else
            call solve_adhesive_load(solver, shape, load, law, tolerance, found, error)
         end if
         seconds(k) = wall_clock() - seconds(k)
      end do
      times = spread_of(seconds)
      if (found%status /= contact_solved) then
         print '(a10, i7, a)', name, n, ': not solved'
         return
      end if
      call report(name, merge('exponential', 'dugdale    ', is_exponential), n, law, load, times%least, &
         & found%n_pairs, found%residual, found%area%corrected, &
         & sum(found%gap)/size(found%gap))
   end subroutine solve

   !> A line of the table: the pull-off, as load.
   subroutine pull(solver, shape, law, n)
      type(periodic_solver_t), intent(inout) :: solver
      real(dp), intent(in) :: shape(:, :)
      type(periodic_adhesion_t), intent(in) :: law
      integer, intent(in) :: n
      type(periodic_pull_off_t) :: pull_off
      type(error_t), allocatable :: error
      real(dp) :: seconds

      seconds = wall_clock()
      call find_pull_off(solver, shape, law, tolerance, pull_off, error)
      seconds = wall_clock() - seconds
      if (pull_off%is_found) call report('pull-off', 'dugdale', n, law, pull_off%mean_pressure, seconds, pull_off%n_pairs, 0.0_dp, &
         & 0.0_dp, &
         & sum(shape)/size(shape) - pull_off%penetration)
   end subroutine pull

   !> Print and write a line.
   subroutine report(name, name_of_law, n, law, load, seconds, pairs, residual, contact, mean_gap)
      character(*), intent(in) :: name, name_of_law
      integer, intent(in) :: n
      type(periodic_adhesion_t), intent(in) :: law
      real(dp), intent(in) :: load, seconds, pairs, residual, contact, mean_gap
      character(8) :: branch

      branch = merge('adhered ', 'approach', law%is_adhered)
      print '(a10, a12, i7, 2f9.4, a10, f10.5, f10.1, f8.0, es12.1, f12.6, f12.8, i9)', name, name_of_law, n, law%stress, &
         & law%range, branch, load, 1000*seconds, pairs, residual, contact, mean_gap, omp_get_max_threads()
      write (table, '(2(a, ","), i0, 2(",", es22.15), ",", a, ",", es22.15, ",", f0.2, ",", f0.1, ",", es9.2, 2(",", es22.15), &
         & ",", i0)') name, trim(name_of_law), n, law%stress, law%range, trim(branch), load, 1000*seconds, pairs, residual, &
         & contact, mean_gap, omp_get_max_threads()
   end subroutine report

end program adhesion

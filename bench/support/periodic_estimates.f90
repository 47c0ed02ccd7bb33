! SPDX-License-Identifier: GPL-3.0-or-later
!> Estimated and true errors of the area of waves on a half-space, and of the pull-off of rough surfaces.
module periodic_estimates
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_plane_westergaard, only: wave_half_width
   use adfric_periodic_adhesive_pull_off, only: find_pull_off, periodic_pull_off_t
   use adfric_periodic_adhesive_solver, only: periodic_adhesion_t
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_grids, only: coarsen
   use adfric_periodic_solver, only: periodic_solver_t, periodic_solution_t, new_periodic_solver, contact_solved
   use estimate_counts, only: counts_t, count_case
   use random_dice, only: dice_t, new_dice
   use rough_shapes, only: make_surface
   use trial_surfaces, only: line_wave, wave
   implicit none (type, external)
   private
   public :: count_waves_1d, count_waves_2d, count_pull_offs

   real(dp), parameter :: tolerance = 1.0e-10_dp
   !> A grid this many times finer tells the error of the 2-D wave, whose area has no closed form.
   integer, parameter :: finer = 4

contains

   !> The 1-D wave under random loads, against Westergaard.
   subroutine count_waves_1d(counts)
      type(counts_t), intent(out) :: counts
      integer, parameter :: n_loads = 200
      type(dice_t) :: dice
      real(dp) :: load, fraction(2), truth
      integer :: k, digit

      counts%name = '1-D wave, area'
      call new_dice(dice, 4)
      do k = 1, n_loads
         call dice%between(0.005_dp, 0.995_dp, load)
         truth = 2*wave_half_width(load)
         do digit = 6, 12
            call press(2**digit, .true., load, fraction)
            call count_case(counts, fraction(2)/fraction(1), abs(fraction(1) - truth)/truth, 'wave_1d')
         end do
      end do
   end subroutine count_waves_1d

   !> The 2-D wave under random loads, against a finer grid.
   subroutine count_waves_2d(counts)
      type(counts_t), intent(out) :: counts
      integer, parameter :: n_loads = 40
      type(dice_t) :: dice
      real(dp) :: load, fraction(2), truth(2)
      integer :: k, digit

      counts%name = '2-D wave, area'
      call new_dice(dice, 5)
      do k = 1, n_loads
         call dice%between(0.005_dp, 0.995_dp, load)
         call press(2**8*finer, .false., load, truth)
         do digit = 6, 8
            call press(2**digit, .false., load, fraction)
            call count_case(counts, fraction(2)/fraction(1), abs(fraction(1) - truth(1))/truth(1), 'wave_2d')
         end do
      end do
   end subroutine count_waves_2d

   !> Pull-off of random rough surfaces on 32 and 64 cells a period, whose shortest wave is a quarter to an eighth of it, against 256
   !> cells.
   subroutine count_pull_offs(counts)
      type(counts_t), intent(out) :: counts
      integer, parameter :: n_finest = 256, n_wanted(*) = [64, 32], n_surfaces = 12
      type(dice_t) :: dice
      type(periodic_adhesion_t) :: adhesion
      type(periodic_pull_off_t) :: truth, found(2)
      real(dp), allocatable :: shape(:, :)
      real(dp) :: hurst, height, part, waves
      integer :: k, i

      counts%name = 'rough surface, pull-off'
      call new_dice(dice, 6)
      do k = 1, n_surfaces
         call dice%between(0.3_dp, 0.9_dp, hurst)
         call dice%decades(0.6_dp, 0.9_dp, waves)
         call dice%decades(-2.0_dp, -1.5_dp, height)
         call dice%decades(-1.5_dp, -0.9_dp, adhesion%stress)
         call dice%decades(-1.7_dp, -1.0_dp, part)
         adhesion%range = part*height
         call make_surface(n_finest, hurst, nint(waves), shape, dice)
         shape = height*shape
         call pull(shape, adhesion, truth)
         do while (size(shape, 1) > n_wanted(1))
            shape = coarsen(shape)
         end do
         call pull(shape, adhesion, found(1))
         do i = 1, size(n_wanted)
            shape = coarsen(shape)
            call pull(shape, adhesion, found(2))
            if (.not. found(1)%is_found) then
               counts%n_unsolved = counts%n_unsolved + 1
            else if (.not. truth%is_found) then
               counts%n_without_truth = counts%n_without_truth + 1
            else
               call count_case(counts, found(1)%error_beside(found(2)), &
                  & abs(found(1)%mean_pressure/truth%mean_pressure - 1), 'pull-off')
            end if
            found(1) = found(2)
         end do
      end do
   end subroutine count_pull_offs

   !> Pull-off of a surface from full contact.
   subroutine pull(shape, adhesion, pull_off)
      real(dp), intent(in) :: shape(:, :)
      type(periodic_adhesion_t), intent(in) :: adhesion
      type(periodic_pull_off_t), intent(out) :: pull_off
      type(periodic_solver_t) :: solver
      type(error_t), allocatable :: error

      call new_periodic_solver(solver, elastic_kernel_t(), [size(shape, 1), size(shape, 2)], [1.0_dp, 1.0_dp], .false., error)
      if (.not. allocated(error)) call find_pull_off(solver, shape - minval(shape), adhesion, tolerance, pull_off, error)
      if (allocated(error)) error stop 'error_estimates: a pull-off is not sought'
   end subroutine pull

   !> Area and its error on n cells a period.
   subroutine press(n, is_line, load, fraction)
      integer, intent(in) :: n
      logical, intent(in) :: is_line
      real(dp), intent(in) :: load
      real(dp), intent(out) :: fraction(2)
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: solution
      type(error_t), allocatable :: error
      real(dp), allocatable :: shape(:, :)

      if (is_line) then
         shape = line_wave(n, n/2)
      else
         shape = wave(n, n/2)
      end if
      call new_periodic_solver(solver, elastic_kernel_t(), [size(shape, 1), size(shape, 2)], [1.0_dp, 1.0_dp], .true., error)
      call solver%solve_load(shape, load, tolerance, solution, error)
      if (allocated(error) .or. solution%status /= contact_solved) error stop 'error_estimates: a wave is not solved'
      fraction = [solution%area%corrected, solution%area%error]
   end subroutine press

end module periodic_estimates

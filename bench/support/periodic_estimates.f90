! SPDX-License-Identifier: GPL-3.0-or-later
!> Estimated and true errors of the area of waves on a half-space.
module periodic_estimates
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_plane_westergaard, only: wave_half_width
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_solver, only: periodic_solver_t, periodic_solution_t, new_periodic_solver, contact_solved
   use estimate_counts, only: counts_t, count_case
   use random_dice, only: dice_t, new_dice
   use trial_surfaces, only: line_wave, wave
   implicit none (type, external)
   private
   public :: count_waves_1d, count_waves_2d

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

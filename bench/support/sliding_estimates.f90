! SPDX-License-Identifier: GPL-3.0-or-later
!> Estimated and true errors of waves and rough surfaces that slide over a viscoelastic half-space.
module sliding_estimates
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_plane_sliding_wave_units, only: wave_slide_t, wave_slide_state_t, new_wave_slide
   use adfric_solid_prony, only: prony_t, new_prony
   use adfric_describe_status, only: status_solved
   use estimate_counts, only: counts_t, count_case
   use periodic_sliding_cases, only: new_wave_case, new_heights_case, give_arms, kind_1d, kind_2d
   use random_dice, only: dice_t, new_dice
   use trial_case, only: trial_case_t
   implicit none (type, external)
   private
   public :: count_sliding_lines, count_sliding_waves, count_sliding_surfaces

   real(dp), parameter :: amplitude = 1.0e-3_dp
   integer, parameter :: most_arms = 8
   !> Waves along x and y of a random surface: from minus this to this.
   integer, parameter :: most_waves = 16

   !> A random surface: the amplitude, with its phase, of each wave along x (from 0) and y.
   type :: random_surface_t
      complex(dp) :: waves(0:most_waves, -most_waves:most_waves) = 0
   end type random_surface_t

contains

   !> A random spectrum over a few decades around the time in which a wave passes, and a load [E0].
   subroutine draw(dice, moduli, times, load)
      type(dice_t), intent(inout) :: dice
      real(dp), allocatable, intent(out) :: moduli(:), times(:)
      real(dp), intent(out) :: load
      integer :: n, i

      call dice%choose(most_arms, n)
      allocate (moduli(n), times(n))
      do i = 1, n
         call dice%decades(-1.0_dp, 1.5_dp, moduli(i))
         call dice%decades(-4.0_dp, 3.0_dp, times(i))
      end do
      call dice%decades(-2.0_dp, 1.0_dp, load)
      load = load*two_pi*amplitude/2
   end subroutine draw

   !> Solve a wave on n cells at unit velocity.
   subroutine solve(kind, n, moduli, times, load, case)
      real(dp), intent(in) :: kind, moduli(:), times(:), load
      integer, intent(in) :: n
      type(trial_case_t), intent(out) :: case

      call new_wave_case(case, kind, 1.0_dp, amplitude, real(n, dp))
      call give_arms(case, 1.0_dp, moduli, times, 1.0_dp)
      call case%give('mean_pressure', load)
      call case%solve()
   end subroutine solve

   !> Waves in one direction, against the closed form.
   subroutine count_sliding_lines(friction, area, seed)
      type(counts_t), intent(out) :: friction, area
      integer, intent(in) :: seed
      integer, parameter :: n_draws = 300
      type(dice_t) :: dice
      type(prony_t) :: prony
      type(trial_case_t) :: case
      type(wave_slide_t) :: wave
      type(wave_slide_state_t) :: exact
      real(dp), allocatable :: moduli(:), times(:)
      real(dp) :: load
      logical :: is_possible, is_converged
      integer :: k, digit

      friction%name = 'sliding 1-D wave, friction'
      area%name = 'sliding 1-D wave, area'
      call new_dice(dice, seed)
      do k = 1, n_draws
         call draw(dice, moduli, times, load)
         call new_prony(prony, 1.0_dp, moduli, times)
         call new_wave_slide(wave, 1.0_dp, amplitude, prony, 1.0_dp, is_possible)
         is_converged = .false.
         if (is_possible) call wave%solve_pressure(load, exact, is_converged)
         do digit = 7, 11
            if (.not. is_converged) then
               friction%n_without_truth = friction%n_without_truth + 1
               cycle
            end if
            call solve(kind_1d, 2**digit, moduli, times, load, case)
            if (case%status(1) /= status_solved) then
               friction%n_unsolved = friction%n_unsolved + 1
               cycle
            end if
            call count_case(friction, case%error_estimate(1), &
               & abs(case%found('friction_stress')/exact%friction_stress - 1), 'wave_1d')
            call count_case(area, case%found('contact_fraction_error')/exact%contact_fraction, &
               & abs(case%found('contact_fraction')/exact%contact_fraction - 1), 'wave_1d')
         end do
      end do
   end subroutine count_sliding_lines

   !> Waves in two directions, against a finer grid.
   subroutine count_sliding_waves(friction, seed)
      type(counts_t), intent(out) :: friction
      integer, intent(in) :: seed
      integer, parameter :: n_draws = 40, finest = 512
      type(dice_t) :: dice
      type(trial_case_t) :: case
      real(dp), allocatable :: moduli(:), times(:)
      real(dp) :: load, truth
      integer :: k, digit

      friction%name = 'sliding 2-D wave, friction'
      call new_dice(dice, seed)
      do k = 1, n_draws
         call draw(dice, moduli, times, load)
         call solve(kind_2d, finest, moduli, times, 2*load, case)
         if (case%status(1) /= status_solved) then
            friction%n_unsolved = friction%n_unsolved + 1
            cycle
         end if
         truth = case%found('friction_stress')
         do digit = 6, 7
            call solve(kind_2d, 2**digit, moduli, times, 2*load, case)
            if (case%status(1) /= status_solved) friction%n_unsolved = friction%n_unsolved + 1
            if (case%status(1) == status_solved) call count_case(friction, case%error_estimate(1), &
               & abs(case%found('friction_stress')/truth - 1), 'wave_2d')
         end do
      end do
   end subroutine count_sliding_waves

   !> Random self-affine surfaces, in periods: friction and area against a finer grid of the same waves.
   subroutine count_sliding_surfaces(friction, area, seed)
      type(counts_t), intent(out) :: friction, area
      integer, intent(in) :: seed
      integer, parameter :: n_draws = 24, finest = 512
      type(dice_t) :: dice
      type(trial_case_t) :: case
      type(random_surface_t) :: surface
      real(dp), allocatable :: moduli(:), times(:)
      real(dp) :: load, true_friction, true_area
      integer :: k, digit

      friction%name = 'sliding rough surface, friction'
      area%name = 'sliding rough surface, area'
      call new_dice(dice, seed)
      do k = 1, n_draws
         call draw(dice, moduli, times, load)
         call draw_surface(dice, surface)
         call solve_surface(surface, finest, moduli, times, load, case)
         if (case%status(1) /= status_solved) then
            friction%n_without_truth = friction%n_without_truth + 1
            cycle
         end if
         true_friction = case%found('friction_stress')
         true_area = case%found('contact_fraction')
         do digit = 6, 7
            call solve_surface(surface, 2**digit, moduli, times, load, case)
            if (case%status(1) /= status_solved) then
               friction%n_unsolved = friction%n_unsolved + 1
               cycle
            end if
            call count_case(friction, case%error_estimate(1), abs(case%found('friction_stress')/true_friction - 1), 'surface')
            call count_case(area, case%found('contact_fraction_error')/true_area, &
               & abs(case%found('contact_fraction')/true_area - 1), 'surface')
         end do
      end do
   end subroutine count_sliding_surfaces

   !> A surface of random exponent of Hurst and random shortest wave, whose slopes along x have the root of the mean square of a
   !> wave of `amplitude`.
   subroutine draw_surface(dice, surface)
      type(dice_t), intent(inout) :: dice
      type(random_surface_t), intent(out) :: surface
      real(dp) :: hurst, size, phase, square
      integer :: shortest, i, j

      call dice%between(0.3_dp, 0.9_dp, hurst)
      call dice%choose(most_waves - 1, shortest)
      shortest = shortest + 1
      square = 0
      do j = -shortest, shortest
         do i = 0, shortest
            call dice%between(0.0_dp, two_pi, phase)
            call dice%between(0.0_dp, 1.0_dp, size)
            if (hypot(real(i, dp), real(j, dp)) > shortest .or. (i == 0 .and. j <= 0)) cycle
            size = size*hypot(real(i, dp), real(j, dp))**(-1 - hurst)
            surface%waves(i, j) = cmplx(size*cos(phase), size*sin(phase), dp)
            square = square + (i*size)**2
         end do
      end do
      surface%waves = surface%waves*(amplitude/sqrt(square))
   end subroutine draw_surface

   !> Solve a random surface on n cells along x and y at unit velocity.
   subroutine solve_surface(surface, n, moduli, times, load, case)
      type(random_surface_t), intent(in) :: surface
      integer, intent(in) :: n
      real(dp), intent(in) :: moduli(:), times(:), load
      type(trial_case_t), intent(out) :: case
      complex(dp) :: along_x(n, 0:most_waves), along_y(-most_waves:most_waves, n)
      integer :: i, k

      do k = -most_waves, most_waves
         if (k >= 0) along_x(:, k) = [(exp(cmplx(0.0_dp, two_pi*k*(i - 0.5_dp)/n, dp)), i=1, n)]
         along_y(k, :) = [(exp(cmplx(0.0_dp, two_pi*k*(i - 0.5_dp)/n, dp)), i=1, n)]
      end do
      call new_heights_case(case, real(matmul(matmul(along_x, surface%waves), along_y), dp), 1.0_dp, 1.0_dp)
      call give_arms(case, 1.0_dp, moduli, times, 1.0_dp)
      call case%give('mean_pressure', load)
      call case%solve()
   end subroutine solve_surface

end module sliding_estimates

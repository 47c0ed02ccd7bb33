! SPDX-License-Identifier: GPL-3.0-or-later
!> Intervals by refits of simulated data: the best curve with new noise of the known sizes, in points, events and priors.
!>
!> A refit starts from all minima of the measured data, so that the noise may choose between them as it does in a measurement. The
!> intervals are those of the middle refits, (1 - level)/2 left out at either end. A set of two pieces shows as one long interval.
module adfric_fit_bootstrap
   use adfric_base_kinds, only: dp
   use adfric_fit_curve, only: fit_curve_t
   use adfric_fit_fold_search, only: searched_t, find_minimum
   use adfric_fit_objective, only: objective_t
   use adfric_fit_order, only: sort
   use adfric_fit_problem, only: fit_t
   use adfric_fit_scales, only: scales_t
   use adfric_base_unset, only: is_set
   use adfric_fit_intervals, only: make_pieces, value_of
   use adfric_fit_solution, only: solution_t
   use adfric_numerics_bounded_least_squares, only: squares_outcome_t, squares_no_value
   use adfric_numerics_random_numbers, only: random_t, new_random, next_normal
   implicit none (type, external)
   private
   public :: take_bootstrap

contains

   !> Intervals of all variables. The sum of squares has been evaluated at the best minimum.
   subroutine take_bootstrap(search, fit, minima, sigma, solution)
      !> The sum of squares; its data are overwritten.
      type(searched_t), intent(inout) :: search
      type(fit_t), intent(in) :: fit
      !> Minima, the least first; shape `(n_free, n_minima)`.
      real(dp), intent(in) :: minima(:, :)
      !> Standard error of a point in the units of the residuals.
      real(dp), intent(in) :: sigma
      type(solution_t), intent(inout) :: solution
      type(objective_t) :: truth
      type(random_t) :: random
      real(dp) :: found(fit%n_bootstrap, size(minima, 1)), q(size(minima, 1)), noise
      integer :: k, n, refit
      logical :: has_value

      associate (objective => search%objective)
         call move_events(objective, minima(:, 1))
         truth = objective
         call new_random(random, fit%seed)
         n = 0
         do refit = 1, fit%n_bootstrap
            do k = 1, size(objective%spheres)
               call add_noise(truth%spheres(k), sigma, random, objective%spheres(k)%x, objective%spheres(k)%y)
            end do
            do k = 1, size(objective%others)
               call add_noise(truth%others(k), sigma, random, objective%others(k)%x, objective%others(k)%y)
            end do
            do k = 1, size(objective%events)
               call next_normal(random, noise)
               objective%events(k)%value = truth%events(k)%value + noise*objective%events(k)%sigma
            end do
            do k = 1, size(q)
               if (.not. is_set(objective%frees(k)%prior)) cycle
               call next_normal(random, noise)
               noise = noise*objective%frees(k)%prior_sigma
               if (objective%frees(k)%is_log) objective%frees(k)%prior = truth%frees(k)%prior*exp(noise)
               if (.not. objective%frees(k)%is_log) objective%frees(k)%prior = truth%frees(k)%prior + noise
            end do
            call find_best(search, minima, q, has_value)
            if (.not. has_value) cycle
            n = n + 1
            found(n, :) = q
         end do
         call take_middle(found(:n, :), fit%levels, search%scales, objective, solution)
      end associate
   end subroutine take_bootstrap

   !> Let events and priors be what the estimate says.
   subroutine move_events(objective, q)
      type(objective_t), intent(inout) :: objective
      !> The estimate.
      real(dp), intent(in) :: q(:)
      real(dp) :: value, gradient(size(q)), slopes(size(q))
      logical :: is_valid
      integer :: k

      slopes = 1
      do k = 1, size(objective%events)
         associate (event => objective%events(k))
            call objective%find_event(event, slopes, value, gradient, is_valid)
            if (is_valid) event%value = value
         end associate
      end do
      do k = 1, size(q)
         if (is_set(objective%frees(k)%prior)) objective%frees(k)%prior = value_of(q(k), objective%unit(k), &
            & objective%frees(k)%is_log)
      end do
   end subroutine move_events

   !> New points around those of the model.
   subroutine add_noise(truth, sigma, random, x, y)
      class(fit_curve_t), intent(in) :: truth
      real(dp), intent(in) :: sigma
      type(random_t), intent(inout) :: random
      real(dp), intent(inout) :: x(:), y(:)
      real(dp) :: noise
      integer :: i

      do i = 1, truth%n
         call next_normal(random, noise)
         y(i) = truth%fitted(i) + noise*sigma*truth%sigma(i)
         if (.not. truth%x_sigma(i) > 0) cycle
         call next_normal(random, noise)
         x(i) = truth%foot(i) + noise*truth%x_sigma(i)
      end do
   end subroutine add_noise

   !> The best answer from all minima.
   subroutine find_best(search, minima, best, has_value)
      type(searched_t), intent(inout) :: search
      !> Minima; shape `(n_free, n_minima)`.
      real(dp), intent(in) :: minima(:, :)
      !> Receives the numbers that are fitted.
      real(dp), intent(out) :: best(:)
      logical, intent(out) :: has_value
      type(squares_outcome_t) :: outcome
      logical :: is_fixed(size(best)), is_unfolded
      real(dp) :: q(size(best)), least
      integer :: k

      is_fixed = .false.
      has_value = .false.
      least = huge(least)
      best = 0
      do k = 1, size(minima, 2)
         q = minima(:, k)
         call find_minimum(search, is_fixed, q, outcome, is_unfolded)
         if (outcome%status == squares_no_value .or. outcome%cost >= least) cycle
         has_value = .true.
         least = outcome%cost
         best = q
      end do
   end subroutine find_best

   !> The middle of the refits.
   subroutine take_middle(found, levels, scales, objective, solution)
      !> Numbers that were fitted; shape `(n_refits, n_free)`.
      real(dp), intent(in) :: found(:, :)
      real(dp), intent(in) :: levels(:)
      type(scales_t), intent(in) :: scales
      type(objective_t), intent(in) :: objective
      type(solution_t), intent(inout) :: solution
      real(dp) :: sorted(size(found, 1))
      integer :: k, level, n, ends(2)

      n = size(found, 1)
      call make_pieces(solution, 1, size(levels), size(found, 2))
      if (n < 2) return
      do k = 1, size(found, 2)
         sorted = found(:, k)
         call sort(sorted)
         do level = 1, size(levels)
            ends(1) = max(1, nint((1 - levels(level))/2*(n + 1)))
            ends(2) = n + 1 - ends(1)
            solution%interval(:, 1, level, k) = value_of(sorted(ends), scales%unit(k), objective%frees(k)%is_log)
            solution%interval_pieces(level, k) = 1
         end do
      end do
   end subroutine take_middle

end module adfric_fit_bootstrap

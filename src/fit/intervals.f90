! SPDX-License-Identifier: GPL-3.0-or-later
!> Intervals of the free variables: from the covariance, from profiles, or by refits of simulated data.
!>
!> Covariance: q +- z s with the normal quantile, or Student's t where sigma is not known. Profile: S - S_min <= chi2_1(level), or s^2 F(1, n - p).
!> A variable at its bound has no interval from the covariance.
module adfric_fit_intervals
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_fit_fold_search, only: searched_t
   use adfric_fit_objective, only: objective_t
   use adfric_fit_profile, only: interval_profile_t, find_profile, find_pieces
   use adfric_fit_scales, only: scales_t
   use adfric_fit_solution, only: solution_t
   use adfric_numerics_distributions, only: chi_squared_quantile, f_quantile, t_quantile, normal_quantile
   implicit none (type, external)
   private
   public :: take_covariance_intervals, take_profile, limit_of, value_of, make_pieces

   !> Most pieces of a set.
   integer, parameter :: most_pieces = 8
   !> Most starts that the profile over lambda gives to the others.
   integer, parameter :: most_others = 10

contains

   !> The value of a variable where the number that is fitted is given; NaN stays.
   elemental real(dp) function value_of(q, unit, is_log)
      !> The number that is fitted.
      real(dp), intent(in) :: q
      !> Unit of a variable that is not fitted by its logarithm.
      real(dp), intent(in) :: unit
      logical, intent(in) :: is_log

      value_of = q*unit
      if (is_log) value_of = exp(q)
   end function value_of

   !> The limit of S - S_min over the variance of a point.
   pure real(dp) function limit_of(level, freedom)
      real(dp), intent(in) :: level
      !> Degrees of freedom where sigma is not known, else 0.
      integer, intent(in) :: freedom

      limit_of = chi_squared_quantile(level, 1)
      if (freedom > 0) limit_of = f_quantile(level, 1, freedom)
   end function limit_of

   !> Make space for the pieces of all intervals.
   pure subroutine make_pieces(solution, n_pieces, n_levels, n_free)
      !> Receives NaN in all positions.
      type(solution_t), intent(inout) :: solution
      !> Most pieces, number of levels, of free variables.
      integer, intent(in) :: n_pieces, n_levels, n_free

      if (allocated(solution%interval)) deallocate (solution%interval)
      allocate (solution%interval(2, n_pieces, n_levels, n_free))
      solution%interval = not_a_number()
      solution%interval_pieces = 0
   end subroutine make_pieces

   !> Intervals from the covariance.
   pure subroutine take_covariance_intervals(q, scales, objective, levels, freedom, solution)
      !> The estimate, as numbers that are fitted.
      real(dp), intent(in) :: q(:)
      type(scales_t), intent(in) :: scales
      type(objective_t), intent(in) :: objective
      real(dp), intent(in) :: levels(:)
      integer, intent(in) :: freedom
      type(solution_t), intent(inout) :: solution
      real(dp) :: reach, ends(2)
      integer :: k, level

      call make_pieces(solution, 1, size(levels), size(q))
      do k = 1, size(q)
         if (solution%at_bound(k) /= 0) cycle
         do level = 1, size(levels)
            reach = normal_quantile(levels(level))
            if (freedom > 0) reach = t_quantile(levels(level), freedom)
            ends = q(k) + [-1, 1]*reach*solution%error_internal(k)/scales%unit(k)
            if (objective%frees(k)%is_log) ends = min(max(ends, -700.0_dp), 700.0_dp)
            solution%interval(:, 1, level, k) = value_of(ends, scales%unit(k), objective%frees(k)%is_log)
            solution%interval_pieces(level, k) = 1
         end do
      end do
   end subroutine take_covariance_intervals

   !> Intervals of one variable from its profile, and the profile itself.
   subroutine take_profile(search, free, minima, costs, others, variance, levels, is_lambda, solution, below, is_below)
      type(searched_t), intent(inout) :: search
      integer, intent(in) :: free
      !> Minima, the least first; shape `(n_free, n_minima)`.
      real(dp), intent(in) :: minima(:, :)
      !> S there.
      real(dp), intent(in) :: costs(:)
      !> In: more starts; shape `(n_free, n_others)`. Out: those that the profile over lambda has found, if it is this one.
      real(dp), allocatable, intent(inout) :: others(:, :)
      !> Variance of a point in units of the residuals.
      real(dp), intent(in) :: variance
      real(dp), intent(in) :: levels(:)
      logical, intent(in) :: is_lambda
      type(solution_t), intent(inout) :: solution
      !> Receives a position whose S is below the least one.
      real(dp), intent(inout) :: below(:)
      logical, intent(out) :: is_below
      type(interval_profile_t) :: profile
      real(dp) :: pieces(2, most_pieces), limit(size(levels)), error
      integer, allocatable :: kept(:)
      integer :: k, n, step

      if (size(solution%interval, 2) /= most_pieces) call make_pieces(solution, most_pieces, size(levels), size(minima, 1))
      do k = 1, size(levels)
         limit(k) = limit_of(levels(k), search%limits%freedom)
      end do
      error = solution%error_internal(free)/search%scales%unit(free)
      if (search%limits%freedom > 0) error = max(error, tiny(error))
      call find_profile(profile, search, free, minima, costs, others, variance, error, limit, is_lambda)
      is_below = profile%is_below
      if (is_below) then
         below = profile%below
         return
      end if
      do k = 1, size(levels)
         call find_pieces(profile, search, limit(k), pieces, n)
         solution%interval(:, :, k, free) = value_of(pieces, search%scales%unit(free), search%objective%frees(free)%is_log)
         solution%interval_pieces(k, free) = n
      end do
      n = profile%n
      solution%profiles(free)%value = value_of(profile%x(:n), search%scales%unit(free), search%objective%frees(free)%is_log)
      solution%profiles(free)%excess = (profile%cost(:n) - profile%least)/variance
      if (is_lambda) then
         ! nodes near the largest limit show the valleys that a walk of another variable may come to
         kept = pack([(k, k=1, n)], profile%cost(:n) - profile%least <= 2.5_dp*maxval(limit)*variance)
         step = 1 + size(kept)/most_others
         others = profile%q(:, kept(::step))
      end if
      solution%points_beyond_fold_in_profile = max(solution%points_beyond_fold_in_profile, profile%n_beyond)
   end subroutine take_profile

end module adfric_fit_intervals

! SPDX-License-Identifier: GPL-3.0-or-later
!> The nodes of a profile: the least S over all other variables at positions of one.
!>
!> A search that falls below S_min has found a better answer; it is handed back.
module adfric_fit_profile_nodes
   use adfric_base_kinds, only: dp
   use adfric_fit_fold_search, only: searched_t, find_minimum
   use adfric_numerics_bounded_least_squares, only: squares_limits_t, squares_outcome_t, squares_no_value
   implicit none (type, external)
   private
   public :: interval_profile_t, new_profile, insert_node, solve_node, solve_best_node, add_node

   !> Most nodes.
   integer, parameter :: most_nodes = 600
   !> Accuracy of S at a node, as a step in standard errors.
   real(dp), parameter :: node_step = 1.0e-4_dp

   !> A profile that is being found.
   type :: interval_profile_t
      !> Number of the variable, and of nodes.
      integer :: free = 0, n = 0
      !> Nodes, rising; S there, its slope, and all numbers that are fitted; shape `(n_free, n)`.
      real(dp), allocatable :: x(:), cost(:), slope(:), q(:, :)
      !> Least S, and variance of a point, by which S - S_min is divided.
      real(dp) :: least = 0, variance = 1
      !> S - S_min over the variance below which a position belongs to all sets.
      real(dp) :: enough = 0
      !> Is a node a minimum of S?
      logical, allocatable :: is_minimum(:)
      !> Has a search fallen below the least S?
      logical :: is_below = .false.
      !> Where that was.
      real(dp), allocatable :: below(:)
      !> Most points beyond the fold at any node.
      integer :: n_beyond = 0
   end type interval_profile_t

contains

   !> Begin a profile without nodes.
   pure subroutine new_profile(self, free, n_free, least, variance, enough)
      type(interval_profile_t), intent(out) :: self
      !> Number of the variable, and of all free ones.
      integer, intent(in) :: free, n_free
      !> Least S, variance of a point, and S - S_min over it below which a position belongs to all sets.
      real(dp), intent(in) :: least, variance, enough

      self%free = free
      self%least = least
      self%variance = variance
      self%enough = enough
      allocate (self%x(most_nodes), self%cost(most_nodes), self%slope(most_nodes), source=0.0_dp)
      allocate (self%q(n_free, most_nodes), source=0.0_dp)
      allocate (self%is_minimum(most_nodes), source=.false.)
   end subroutine new_profile

   !> Put a node in its place; at a position that has one the lesser S stays.
   pure subroutine insert_node(self, x, cost, slope, q, is_minimum)
      type(interval_profile_t), intent(inout) :: self
      !> The position, S and its slope there.
      real(dp), intent(in) :: x, cost, slope
      !> All numbers that are fitted.
      real(dp), intent(in) :: q(:)
      logical, intent(in) :: is_minimum
      integer :: i, n

      n = self%n
      i = count(self%x(:n) < x) + 1
      if (i <= n) then
         if (.not. self%x(i) > x) then
            if (cost >= self%cost(i)) return
            self%cost(i) = cost
            self%slope(i) = slope
            self%q(:, i) = q
            self%is_minimum(i) = is_minimum
            return
         end if
      end if
      if (n == most_nodes) return
      self%x(i + 1:n + 1) = self%x(i:n)
      self%cost(i + 1:n + 1) = self%cost(i:n)
      self%slope(i + 1:n + 1) = self%slope(i:n)
      self%q(:, i + 1:n + 1) = self%q(:, i:n)
      self%is_minimum(i + 1:n + 1) = self%is_minimum(i:n)
      self%x(i) = x
      self%cost(i) = cost
      self%slope(i) = slope
      self%q(:, i) = q
      self%is_minimum(i) = is_minimum
      self%n = n + 1
   end subroutine insert_node

   !> The least S over all other variables at a position, from one start.
   subroutine solve_node(self, search, x, q, cost, slope, has_value)
      !> The profile, which notes what is below its least S.
      type(interval_profile_t), intent(inout) :: self
      type(searched_t), intent(inout) :: search
      real(dp), intent(in) :: x
      !> In: a start for the others. Out: all numbers that are fitted.
      real(dp), intent(inout) :: q(:)
      !> Receives S and its slope.
      real(dp), intent(out) :: cost, slope
      logical, intent(out) :: has_value
      type(squares_limits_t) :: coarse
      type(squares_outcome_t) :: outcome
      logical :: is_fixed(size(q)), is_unfolded

      q(self%free) = x
      is_fixed = .false.
      is_fixed(self%free) = .true.
      coarse = search%limits
      coarse%step_tolerance = max(node_step, search%limits%step_tolerance)
      coarse%relative_tolerance = max(search%limits%relative_tolerance, 1.0e-9_dp)
      coarse%most_steps = 60
      call find_minimum(search, is_fixed, q, outcome, is_unfolded, coarse)
      has_value = outcome%status /= squares_no_value
      cost = outcome%cost
      slope = 0
      if (.not. has_value) return
      slope = 2*dot_product(search%work%j(:search%work%n_rows, self%free), search%work%r(:search%work%n_rows))
      self%n_beyond = max(self%n_beyond, search%objective%n_beyond())
      if (cost < self%least - 1.0e-5_dp*self%variance) then
         if (.not. self%is_below) self%below = q
         self%is_below = .true.
      end if
   end subroutine solve_node

   !> The least S over all other variables at a position, from several starts.
   subroutine solve_best_node(self, search, x, starts, q, cost, slope, has_value)
      type(interval_profile_t), intent(inout) :: self
      type(searched_t), intent(inout) :: search
      real(dp), intent(in) :: x
      !> Starts; shape `(n_free, n_starts)`.
      real(dp), intent(in) :: starts(:, :)
      !> Receives all numbers that are fitted.
      real(dp), intent(out) :: q(:)
      real(dp), intent(out) :: cost, slope
      logical, intent(out) :: has_value
      real(dp) :: trial(size(q)), trial_cost, trial_slope
      logical :: is_valid
      integer :: k

      has_value = .false.
      cost = huge(cost)
      slope = 0
      q = starts(:, 1)
      do k = 1, size(starts, 2)
         trial = starts(:, k)
         call solve_node(self, search, x, trial, trial_cost, trial_slope, is_valid)
         if (.not. is_valid) cycle
         has_value = .true.
         if (trial_cost >= cost) cycle
         cost = trial_cost
         slope = trial_slope
         q = trial
         ! well within every set: no other start changes that
         if (cost - self%least <= self%enough*self%variance) return
      end do
   end subroutine solve_best_node

   !> Add a node, solved from all minima.
   subroutine add_node(self, search, starts, x)
      type(interval_profile_t), intent(inout) :: self
      type(searched_t), intent(inout) :: search
      real(dp), intent(in) :: starts(:, :), x
      real(dp) :: q(size(starts, 1)), cost, slope
      logical :: has_value

      call solve_best_node(self, search, x, starts, q, cost, slope, has_value)
      if (has_value) call insert_node(self, x, cost, slope, q, .false.)
   end subroutine add_node

end module adfric_fit_profile_nodes

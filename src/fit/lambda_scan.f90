! SPDX-License-Identifier: GPL-3.0-or-later
!> The scan over lambda.
!>
!> Lambda is always scanned, since friction against load may have two answers for it. At each node (those of the model page: 0.03, 0.1,
!> 0.2, 0.35, 0.6, 1, 2, 5, 20, the bounds and the user's start) the other variables are solved first, at lambda = 1 from the data, then
!> outward from each neighbour. That gives the profile S_p(ln lambda) and, by the envelope theorem, its slope 2 J' r. A minimum of S
!> is one of S_p. Between two nodes there is one if the slope is negative at the left and positive at the right one, and there may be one if
!> the cubic through both values and slopes has one, or if the lower bound has a positive slope, the upper one a negative one. From each of
!> these positions, from the best node and from the user's start the search goes on in all variables.
!>
!> What may be missed: a pair of a maximum and a minimum within one interval, with slopes of one sign at both ends, which the cubic does
!> not show; and a second valley in the other variables at given lambda. `tests/fit` compares with searches from every node.
module adfric_fit_lambda_scan
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set, unset
   use adfric_fit_fold_search, only: searched_t, find_minimum
   use adfric_fit_minima, only: minima_t, add_search, minima_limit
   use adfric_fit_objective, only: objective_t, take_estimate
   use adfric_fit_problem, only: fit_t
   use adfric_fit_scales, only: scales_t
   use adfric_fit_starts, only: get_start, lambda_free, position_of_lambda
   use adfric_numerics_bounded_least_squares, only: squares_limits_t, squares_outcome_t, squares_no_value
   implicit none (type, external)
   private
   public :: scan_lambda, fewest_nodes

   !> Nodes of lambda, and the few where few starts are asked for.
   real(dp), parameter :: nodes(*) = [0.03_dp, 0.1_dp, 0.2_dp, 0.35_dp, 0.6_dp, 1.0_dp, 2.0_dp, 5.0_dp, 20.0_dp]
   real(dp), parameter :: few_nodes(*) = [0.1_dp, 0.3_dp, 1.0_dp, 5.0_dp]
   !> With fewer starts there is no scan.
   integer, parameter :: fewest_nodes = size(few_nodes)
   !> When the others are solved at a node: shorter steps than that do not change which valleys there are.
   real(dp), parameter :: node_step = 0.03_dp, node_decrease = 1.0e-4_dp
   integer, parameter :: node_steps = 30

   !> A node of the scan over lambda.
   type :: node_t
      !> Has the model a value there?
      logical :: has_value = .false.
      !> Cost and slope of the profile.
      real(dp) :: cost = 0, slope = 0
   end type node_t

contains

   !> The scan over lambda.
   subroutine scan_lambda(search, fit, minima)
      type(searched_t), intent(inout) :: search
      type(fit_t), intent(in) :: fit
      !> The minima; those found are added.
      type(minima_t), intent(inout) :: minima
      real(dp), allocatable :: positions(:), lambdas(:), q(:, :)
      type(node_t), allocatable :: node(:)
      real(dp) :: start(search%objective%n_free)
      integer :: free, k, middle

      free = lambda_free(fit)
      if (is_set(fit%frees(free)%start)) then
         call get_start(search%objective, fit, unset, search%work, start)
         call add_search(search, start, minima)
      end if
      call get_start(search%objective, fit, 1.0_dp, search%work, start)
      call make_nodes(search%objective, fit, search%scales, free, start, positions, lambdas)
      allocate (q(search%objective%n_free, size(positions)), node(size(positions)))
      middle = minloc(abs(log(lambdas)), 1)
      do k = middle, size(positions)
         call solve_node(search, fit, free, positions(k), lambdas(k), k > middle .and. node(max(k - 1, 1))%has_value, &
            & q(:, max(k - 1, 1)), q(:, k), node(k), minima)
      end do
      do k = middle - 1, 1, -1
         call solve_node(search, fit, free, positions(k), lambdas(k), node(k + 1)%has_value, q(:, k + 1), q(:, k), node(k), minima)
      end do
      call search_valleys(search, positions, q, node, minima)
   end subroutine scan_lambda

   !> The nodes, rising in the number that is fitted, and their lambda.
   subroutine make_nodes(self, fit, scales, free, start, positions, lambdas)
      type(objective_t), intent(in) :: self
      type(fit_t), intent(in) :: fit
      type(scales_t), intent(in) :: scales
      !> Number of the free variable that sets lambda.
      integer, intent(in) :: free
      real(dp), intent(in) :: start(:)
      !> Receives the numbers that are fitted.
      real(dp), allocatable, intent(out) :: positions(:)
      real(dp), allocatable, intent(out) :: lambdas(:)
      real(dp) :: v(size(start)), slopes(size(start)), one, sense
      real(dp), allocatable :: all_nodes(:)
      integer :: k

      call take_estimate(self, start, v, slopes)
      if (fit%n_starts > 0 .and. fit%n_starts < size(nodes)) then
         allocate (all_nodes, source=few_nodes)
      else
         allocate (all_nodes, source=nodes)
      end if
      one = position_of_lambda(self, free, 1.0_dp, v)
      sense = position_of_lambda(self, free, exp(1.0_dp), v) - one
      positions = one + sense*log(all_nodes)
      positions = pack(positions, positions > scales%lower(free) .and. positions < scales%upper(free))
      if (sense < 0) positions = positions(size(positions):1:-1)
      if (abs(scales%lower(free)) < 200) positions = [scales%lower(free), positions]
      if (abs(scales%upper(free)) < 200) positions = [positions, scales%upper(free)]
      lambdas = [(exp((positions(k) - one)/sense), k=1, size(positions))]
   end subroutine make_nodes

   !> Solve the other variables at a node.
   subroutine solve_node(search, fit, free, position, lambda, has_neighbour, neighbour, q, node, minima)
      type(searched_t), intent(inout) :: search
      type(fit_t), intent(in) :: fit
      integer, intent(in) :: free
      !> The number that is fitted, and lambda.
      real(dp), intent(in) :: position, lambda
      logical, intent(in) :: has_neighbour
      !> What was found there.
      real(dp), intent(in) :: neighbour(:)
      !> Receives what is found.
      real(dp), intent(out) :: q(:)
      type(node_t), intent(out) :: node
      type(minima_t), intent(inout) :: minima
      type(squares_limits_t) :: coarse
      type(squares_outcome_t) :: outcome
      logical :: is_fixed(size(q)), is_unfolded

      if (has_neighbour) then
         q = neighbour
      else
         call get_start(search%objective, fit, lambda, search%work, q)
      end if
      q(free) = position
      is_fixed = .false.
      is_fixed(free) = .true.
      coarse = search%limits
      coarse%step_tolerance = node_step
      coarse%relative_tolerance = node_decrease
      coarse%most_steps = node_steps
      call find_minimum(search, is_fixed, q, outcome, is_unfolded, coarse)
      minima%steps = minima%steps + outcome%steps
      node%has_value = outcome%status /= squares_no_value
      node%cost = outcome%cost
      node%slope = 2*dot_product(search%work%j(:search%work%n_rows, free), search%work%r(:search%work%n_rows))
   end subroutine solve_node

   !> Search in all variables wherever the profile shows a valley.
   subroutine search_valleys(search, positions, q, node, minima)
      type(searched_t), intent(inout) :: search
      !> The nodes.
      real(dp), intent(in) :: positions(:)
      !> What was found there; shape `(n_free, n_nodes)`.
      real(dp), intent(in) :: q(:, :)
      type(node_t), intent(in) :: node(:)
      type(minima_t), intent(inout) :: minima
      real(dp) :: start(size(q, 1)), at, cost, best, variance, share
      integer :: k, n
      logical :: is_valley

      n = size(positions)
      if (.not. any(node%has_value)) return
      best = minval(node%cost, node%has_value)
      variance = 1
      if (search%limits%freedom > 0) variance = best/search%limits%freedom
      do k = 1, n
         ! ends with a slope that points out, and the best node
         is_valley = node(k)%has_value .and. (k == 1 .and. node(k)%slope > 0 .or. k == n .and. node(k)%slope < 0)
         if (is_valley) is_valley = node(k)%cost - best <= 2*minima_limit*variance
         if (node(k)%has_value) is_valley = is_valley .or. node(k)%cost <= best
         if (is_valley) then
            start = q(:, k)
            call add_search(search, start, minima)
         end if
         if (k == n) exit
         if (.not. (node(k)%has_value .and. node(k + 1)%has_value)) cycle
         call find_cubic_minimum(positions(k), positions(k + 1), node(k), node(k + 1), is_valley, at, cost)
         if (.not. is_valley .or. cost - best > 2*minima_limit*variance) cycle
         share = (at - positions(k))/(positions(k + 1) - positions(k))
         start = (1 - share)*q(:, k) + share*q(:, k + 1)
         call add_search(search, start, minima)
      end do
   end subroutine search_valleys

   !> The minimum of the cubic through two values with their slopes.
   pure subroutine find_cubic_minimum(left, right, left_node, right_node, is_there, at, cost)
      !> The positions.
      real(dp), intent(in) :: left, right
      type(node_t), intent(in) :: left_node, right_node
      logical, intent(out) :: is_there
      !> Receives the position and the value of the minimum.
      real(dp), intent(out) :: at, cost
      real(dp) :: h, rise, a, b, c, t, root

      h = right - left
      rise = right_node%cost - left_node%cost
      ! cost = left + c t + b t^2 + a t^3 with t from 0 to 1
      c = left_node%slope*h
      a = (left_node%slope + right_node%slope)*h - 2*rise
      b = rise - c - a
      root = b**2 - 3*a*c
      is_there = root >= 0
      t = -1
      ! the root where 2 b + 6 a t > 0, in the form without cancellation
      if (is_there .and. b + sqrt(max(root, 0.0_dp)) > 0) then
         t = -c/(b + sqrt(root))
      else if (is_there .and. abs(a) > 0) then
         t = (-b + sqrt(root))/(3*a)
      end if
      is_there = t > 0 .and. t < 1
      at = left + t*h
      cost = left_node%cost + t*(c + t*(b + t*a))
   end subroutine find_cubic_minimum

end module adfric_fit_lambda_scan

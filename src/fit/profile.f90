! SPDX-License-Identifier: GPL-3.0-or-later
!> The profile of S over one variable, the least S over all others, and the sets where it stays below a limit.
!>
!> Is every piece of a set found? Each piece {S_p - S_min <= T} holds a local minimum of S, or one that a bound holds: S_p is continuous
!> and has a least value on a closed piece, and at a position where two valleys of the other variables cross S_p has no least value,
!> for the lesser of two functions has a maximum there. So it is enough to walk from every known minimum to both sides until S_p is
!> above the largest limit, or to the bound; a piece whose minimum the search has missed is missed here, too. For lambda the nodes
!> are 47 on a grid, and every minimum. All nodes are solved from all minima and from both neighbours. S_p itself is the least of
!> several valleys, and a valley need not have a minimum of its own. Lambda is what makes valleys, so the walks of the other
!> variables start each node from the nodes of the profile over lambda, too.
!>
!> Is every end of a piece found? Between neighbouring nodes a gap may be too narrow for them. It lies where two valleys cross:
!> there, at the position where their tangents meet, one more node is put. Crossings are refined by the secant rule with the exact
!> slope of S_p, 2 J' r.
module adfric_fit_profile
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_fit_fold_search, only: searched_t
   use adfric_fit_profile_nodes, only: interval_profile_t, new_profile, insert_node, solve_node, solve_best_node, add_node
   implicit none (type, external)
   private
   public :: interval_profile_t, find_profile, find_pieces

   !> Nodes of a grid over lambda, and most nodes of a walk.
   integer, parameter :: n_grid = 47, most_walk = 60
   !> First step of a walk in standard errors, and its longest one as a difference of the number that is fitted.
   real(dp), parameter :: first_step = 0.4_dp, longest_step = 1.0_dp
   !> Accuracy of a crossing relative to the limit.
   real(dp), parameter :: of_limit = 1.0e-7_dp
   integer, parameter :: most_refinements = 40
   !> A crossing is known to this part of the distance between its nodes.
   real(dp), parameter :: smallest_part = 1.0e-9_dp

contains

   !> Find the profile over one variable.
   subroutine find_profile(self, search, free, minima, costs, others, variance, error, limit, is_lambda)
      type(interval_profile_t), intent(out) :: self
      type(searched_t), intent(inout) :: search
      integer, intent(in) :: free
      !> Minima, the least first; shape `(n_free, n_minima)`.
      real(dp), intent(in) :: minima(:, :)
      !> S there.
      real(dp), intent(in) :: costs(:)
      !> More starts, such as those of the profile over lambda; shape `(n_free, n_others)`.
      real(dp), intent(in) :: others(:, :)
      !> Variance of a point in units of the residuals.
      real(dp), intent(in) :: variance
      !> Standard error of the number that is fitted.
      real(dp), intent(in) :: error
      !> Limits of S - S_min, over the variance.
      real(dp), intent(in) :: limit(:)
      logical, intent(in) :: is_lambda
      real(dp) :: starts(size(minima, 1), size(minima, 2) + size(others, 2)), largest
      integer :: k

      starts(:, :size(costs)) = minima
      starts(:, size(costs) + 1:) = others
      largest = maxval(limit)
      call new_profile(self, free, size(minima, 1), costs(1), variance, minval(limit)/2)
      do k = 1, size(costs)
         call insert_node(self, minima(free, k), costs(k), 0.0_dp, minima(:, k), .true.)
      end do
      if (is_lambda .and. abs(search%scales%lower(free)) < 200 .and. abs(search%scales%upper(free)) < 200) then
         do k = 0, n_grid - 1
            call add_node(self, search, starts, &
               & search%scales%lower(free) + (search%scales%upper(free) - search%scales%lower(free))*k/(n_grid - 1))
         end do
      else
         do k = 1, size(costs)
            call walk(self, search, starts, minima(:, k), error, largest, 1)
            call walk(self, search, starts, minima(:, k), error, largest, -1)
         end do
      end if
      call sweep(self, search)
      call look_between(self, search, largest)
   end subroutine find_profile

   !> Walk from a minimum to one side, until S is above the largest limit, or to the bound.
   subroutine walk(self, search, minima, from, error, largest, side)
      type(interval_profile_t), intent(inout) :: self
      type(searched_t), intent(inout) :: search
      !> All minima; shape `(n_free, n_minima)`.
      real(dp), intent(in) :: minima(:, :)
      !> The minimum.
      real(dp), intent(in) :: from(:)
      !> Standard error of the number that is fitted, and the largest limit.
      real(dp), intent(in) :: error, largest
      !> 1: to larger values; -1: to smaller ones.
      integer, intent(in) :: side
      real(dp) :: q(size(from)), starts(size(from), size(minima, 2) + 1), x, step, bound, cost, slope, last
      logical :: has_value
      integer :: k

      bound = merge(search%scales%upper(self%free), search%scales%lower(self%free), side > 0)
      step = longest_step/10
      if (error > 0 .and. error < 10*longest_step) step = first_step*error
      starts(:, 2:) = minima
      q = from
      x = from(self%free)
      last = self%least
      do k = 1, most_walk
         if (side*(bound - x) <= 0) return
         starts(:, 1) = q
         call solve_best_node(self, search, merge(min(x + step, bound), max(x - step, bound), side > 0), starts, q, cost, slope, &
            & has_value)
         if (.not. has_value .or. (cost - last > 2*largest*self%variance .and. k < most_walk/2)) then
            ! too far
            q = starts(:, 1)
            step = step/4
            if (step < 1.0e-3_dp*min(error, 1.0_dp)) return
            cycle
         end if
         x = q(self%free)
         call insert_node(self, x, cost, slope, q, .false.)
         if (cost - self%least > 1.02_dp*largest*self%variance) return
         if (abs(cost - last) < largest*self%variance/8) step = min(2*step, longest_step*max(1.0_dp, min(error, 20.0_dp)))
         last = cost
      end do
   end subroutine walk

   !> Solve each node from its neighbours.
   subroutine sweep(self, search)
      type(interval_profile_t), intent(inout) :: self
      type(searched_t), intent(inout) :: search
      integer :: k

      do k = 2, self%n
         call try_neighbour(k - 1, k)
      end do
      do k = self%n - 1, 1, -1
         call try_neighbour(k + 1, k)
      end do

   contains

      !> Solve a node from a neighbour.
      subroutine try_neighbour(from, to)
         !> Numbers of the neighbour and of the node.
         integer, intent(in) :: from, to
         real(dp) :: q(size(self%q, 1)), cost, slope
         logical :: has_value

         q = self%q(:, from)
         call solve_node(self, search, self%x(to), q, cost, slope, has_value)
         if (.not. has_value .or. cost >= self%cost(to)) return
         self%cost(to) = cost
         self%slope(to) = slope
         self%q(:, to) = q
      end subroutine try_neighbour

   end subroutine sweep

   !> Put a node where the tangents of neighbours meet above both, and one between two minima that are neighbours.
   subroutine look_between(self, search, largest)
      type(interval_profile_t), intent(inout) :: self
      type(searched_t), intent(inout) :: search
      !> The largest limit.
      real(dp), intent(in) :: largest
      real(dp), allocatable :: positions(:), starts(:, :, :)
      real(dp) :: at, bend
      integer :: k, n

      n = 0
      allocate (positions(self%n), starts(size(self%q, 1), 2, self%n))
      do k = 1, self%n - 1
         if (min(self%cost(k), self%cost(k + 1)) - self%least > largest*self%variance) cycle
         bend = self%slope(k) - self%slope(k + 1)
         at = (self%x(k) + self%x(k + 1))/2
         if (.not. (self%is_minimum(k) .and. self%is_minimum(k + 1))) then
            if (.not. bend > 0) cycle
            at = self%x(k) + (self%cost(k + 1) - self%cost(k) - self%slope(k + 1)*(self%x(k + 1) - self%x(k)))/bend
            if (.not. (at > self%x(k) .and. at < self%x(k + 1))) cycle
         end if
         n = n + 1
         positions(n) = at
         starts(:, :, n) = self%q(:, k:k + 1)
      end do
      do k = 1, n
         call add_node(self, search, starts(:, :, k), positions(k))
      end do
   end subroutine look_between

   !> The pieces of the set where S - S_min stays below a limit, as numbers that are fitted; NaN: open at the bound.
   subroutine find_pieces(self, search, limit, pieces, n_pieces)
      type(interval_profile_t), intent(inout) :: self
      type(searched_t), intent(inout) :: search
      !> The limit, over the variance.
      real(dp), intent(in) :: limit
      !> Receives low and high ends; shape `(2, most_pieces)`.
      real(dp), intent(out) :: pieces(:, :)
      integer, intent(out) :: n_pieces
      logical :: is_in(self%n), was_in
      integer :: k

      is_in = self%cost(:self%n) - self%least <= limit*self%variance
      pieces = not_a_number()
      n_pieces = 0
      was_in = .false.
      do k = 1, self%n
         if (is_in(k) .and. .not. was_in) then
            if (n_pieces == size(pieces, 2)) return
            n_pieces = n_pieces + 1
            if (k > 1) call refine(self, search, limit, k, k - 1, pieces(1, n_pieces))
         else if (was_in .and. .not. is_in(k)) then
            call refine(self, search, limit, k - 1, k, pieces(2, n_pieces))
         end if
         was_in = is_in(k)
      end do
   end subroutine find_pieces

   !> Where S - S_min crosses a limit between two nodes: false position, halved where one end stays (Illinois).
   subroutine refine(self, search, limit, inner, outer, at)
      type(interval_profile_t), intent(inout) :: self
      type(searched_t), intent(inout) :: search
      real(dp), intent(in) :: limit
      !> Numbers of the nodes within the set and outside.
      integer, intent(in) :: inner, outer
      !> Receives the position.
      real(dp), intent(out) :: at
      real(dp) :: a, b, fa, fb, cost, slope, starts(size(self%q, 1), 2), q(size(self%q, 1)), value
      logical :: has_value
      integer :: k, last

      a = self%x(inner)
      b = self%x(outer)
      fa = (self%cost(inner) - self%least)/self%variance - limit
      fb = (self%cost(outer) - self%least)/self%variance - limit
      starts(:, 1) = self%q(:, inner)
      starts(:, 2) = self%q(:, outer)
      last = 0
      at = a
      do k = 1, most_refinements
         ! S is nearly a parabola: its root is nearly linear
         at = a + (b - a)*share_of(fa, fb)
         if (mod(k, 6) == 0) at = (a + b)/2
         call solve_best_node(self, search, at, starts, q, cost, slope, has_value)
         if (.not. has_value) return
         value = (cost - self%least)/self%variance - limit
         if (abs(value) <= of_limit*limit) return
         if (value < 0) then
            a = at
            fa = value
            starts(:, 1) = q
            if (last == 1) fb = fb/2
            last = 1
         else
            b = at
            fb = value
            starts(:, 2) = q
            if (last == 2) fa = fa/2
            last = 2
         end if
         if (abs(b - a) <= smallest_part*abs(self%x(outer) - self%x(inner))) return
      end do
   end subroutine refine

   !> Where a straight line is 0.
   pure real(dp) function share_of(inner, outer)
      !> Values at its ends, of which one is <= 0, the other > 0.
      real(dp), intent(in) :: inner, outer

      share_of = inner/(inner - outer)
   end function share_of

end module adfric_fit_profile

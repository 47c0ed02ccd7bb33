! SPDX-License-Identifier: GPL-3.0-or-later
!> One state of a rigid round body that any law of attraction draws to a half-space.
!>
!> The contact of radius a is free of an unknown edge, since a is what is prescribed. In the row of springs (`shape`) their compression
!> u(x) is delta - g(x) in contact, and beyond it
!>
!>     u = -2 F(x),  F(x) = int s r/sqrt(r^2 - x^2) dr,  x < r,
!>
!> with the tension s(r) of the law. It has no jump at a, so delta = g(a) - 2 F(a), and the gap is
!>
!>     gap(r) = (2/pi) int [g(x) - g(a) + 2 F(a) - 2 F(x)]/sqrt(r^2 - x^2) dx,  a < x < r.
!>
!> The same holds without contact, a = 0, with the gap q on the axis added, and delta = -2 F(0) - q. So one coordinate z follows all
!> states: z = -q without contact, z = a with it. Unknown are the gaps at nodes t = sqrt(r^2 - a^2); in t nothing is singular at the
!> edge of contact. Between nodes s and g - F are linear in t^2, which makes the first integral a closed form; the second one has a
!> smooth integrand in the angle of x/r = sin(angle). The error falls with the square of the spacing.
!>
!> Lennard-Jones's law has no wall: its a is 0, and q may be below 0. Its tension is largest at a gap above 0. Up to there z is minus
!> what the gap on the axis has above it, and then the radius where the gap is that one. A node stands there, so grids move along with
!> the edge, and q is unknown.
!>
!> Where a law ends at its range, the last node stands where the gap is the range, so that no cell has a corner of the law's end.
module adfric_round_attracted_state
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, two_pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_interface_attraction, only: attraction_t
   use adfric_numerics_gauss, only: gauss_nodes_10, gauss_weights_10
   use adfric_numerics_lapack, only: dgesv
   use adfric_round_attracted_nodes, only: attracted_t, node_grid_t, nodes_inside, of_nodes, set_nodes
   use adfric_round_attracted_sums, only: get_influence, get_sum_weights, get_tensions
   use adfric_round_shape, only: shape_t, spot_t, within_edge
   implicit none (type, external)
   private
   public :: solve_state

   !> Share of the work that is left at the last node.
   real(dp), parameter :: share_of_tail = 1.0e-7_dp

contains

   !> The state of a coordinate, by Newton's method.
   subroutine solve_state(shape, law, z, grid, n, guess, state)
      class(shape_t), intent(in) :: shape
      type(attraction_t), intent(in) :: law
      !> The coordinate: minus the gap on the axis without contact, the radius with it. Without a wall minus the gap, always.
      real(dp), intent(in) :: z
      type(node_grid_t), intent(in) :: grid
      !> Number of nodes beside the first one.
      integer, intent(in) :: n
      !> A state near by; not allocated: the rigid body.
      type(attracted_t), allocatable, intent(in) :: guess
      type(attracted_t), intent(out) :: state
      real(dp) :: ends(2), misses(2), next
      logical :: has_wall
      integer :: k
      integer, parameter :: most_ends = 30
      real(dp), parameter :: at_rest = 1.0e-11_dp

      has_wall = law%has_wall()
      state%z = z
      state%grid = grid
      if (has_wall .and. z > 0) then
         state%radius = z
      else if (has_wall) then
         state%central_gap = -z
      else
         if (z > 0) state%pinned = n*nodes_inside/of_nodes
         state%central_gap = law%gap_of_largest() + max(-z, 0.0_dp)
      end if
      allocate (state%t(0:n), state%gap(0:n), state%tension(0:n), state%sums(0:n))
      if (.not. law%has_end()) then
         call solve_on_nodes(shape, law, reach_of(shape, law, state), guess, state)
         return
      end if
      ! bodies that the law does not reach are no state of it
      if (-z >= law%range) return
      ! secants for the end of the attraction
      ends(2) = shape%radius_of_height(law%range)
      if (allocated(guess)) ends(2) = guess%t(ubound(guess%t, 1))
      do k = 1, most_ends
         call solve_on_nodes(shape, law, ends(2), guess, state)
         if (.not. state%is_found) return
         misses(2) = state%gap(n)/law%range - 1
         if (abs(misses(2)) <= at_rest) return
         next = merge(ends(2)/2, 2*ends(2), misses(2) > 0)
         if (k == 1) then
            if (state%gap(n) > state%gap(n - 1)) next = ends(2) &
               & - misses(2)*law%range*(state%t(n) - state%t(n - 1))/(state%gap(n) - state%gap(n - 1))
         else
            if (abs(misses(2) - misses(1)) > 0) next = ends(2) - misses(2)*(ends(2) - ends(1))/(misses(2) - misses(1))
         end if
         ends(1) = ends(2)
         misses(1) = misses(2)
         ends(2) = min(max(next, ends(2)/2), 2*ends(2))
         if (.not. abs(ends(2) - ends(1)) > 2*epsilon(next)*ends(1)) return
      end do
      state%is_found = .false.
   end subroutine solve_state

   !> The state with nodes up to a given end.
   subroutine solve_on_nodes(shape, law, end, guess, state)
      class(shape_t), intent(in) :: shape
      type(attraction_t), intent(in) :: law
      !> t of the last node.
      real(dp), intent(in) :: end
      type(attracted_t), allocatable, intent(in) :: guess
      type(attracted_t), intent(inout) :: state
      real(dp), allocatable :: x(:), base(:), influence(:, :)
      integer :: n

      state%is_found = .false.
      if (.not. (end > 0 .and. end < huge(end))) return
      n = ubound(state%t, 1)
      allocate (base(0:n), influence(0:n, 0:n))
      call set_nodes(state, end)
      x = hypot(state%t, state%radius)
      if (x(n) > within_edge*shape%edge*(1 + 4*epsilon(end))) return
      call get_influence(shape, x, state%t, base, influence)
      call get_guess(shape, state, base, guess)
      call iterate(law, base, influence, state)
      if (state%is_found) call sum_up(shape, law, x, state)
   end subroutine solve_on_nodes

   !> t where next to no work is left, or at the edge of the body.
   pure real(dp) function reach_of(shape, law, state) result(end)
      class(shape_t), intent(in) :: shape
      type(attraction_t), intent(in) :: law
      type(attracted_t), intent(in) :: state
      type(spot_t) :: spot

      ! from the undisturbed surface the body has at r the distance f - delta, and delta is about g(a)
      call shape%evaluate(shape%unknown_of(state%radius), .true., spot)
      end = shape%radius_of_height(law%reach_of_work(share_of_tail) + spot%depth + abs(state%central_gap))
      end = max(end, 3*max(state%radius, state%z), state%radius + 4*(state%grid%centre + state%grid%width))
      end = min(end, within_edge*shape%edge)
      end = sqrt((end - state%radius)*(end + state%radius))
   end function reach_of

   !> Gaps to begin from.
   pure subroutine get_guess(shape, state, base, guess)
      class(shape_t), intent(in) :: shape
      type(attracted_t), intent(inout) :: state
      real(dp), intent(in) :: base(0:)
      type(attracted_t), allocatable, intent(in) :: guess
      real(dp) :: index, given
      integer :: k, j, n

      n = ubound(state%t, 1)
      given = state%central_gap
      if (.not. allocated(guess)) then
         state%gap = base + given
      else if (state%pinned > 0 .and. guess%pinned > 0) then
         do k = 0, n
            index = real(k, dp)*ubound(guess%t, 1)/n
            j = min(int(index), ubound(guess%t, 1) - 1)
            state%gap(k) = guess%gap(j) + (index - j)*(guess%gap(j + 1) - guess%gap(j))
         end do
      else
         do k = 0, n
            state%gap(k) = guess%gap_at_node(shape, state%t(k))
         end do
      end if
      state%gap(state%pinned) = given
   end subroutine get_guess

   !> Newton's method in the gaps.
   subroutine iterate(law, base, influence, state)
      type(attraction_t), intent(in) :: law
      real(dp), intent(in) :: base(0:), influence(0:, 0:)
      type(attracted_t), intent(inout) :: state
      integer, parameter :: most_steps = 40
      real(dp), parameter :: at_rest = 1.0e-11_dp
      real(dp), allocatable :: matrix(:, :), step(:), slopes(:), gaps(:)
      integer, allocatable :: pivots(:)
      real(dp) :: change, share
      integer :: n, k, j, info
      logical :: has_wall

      has_wall = law%has_wall()
      n = ubound(base, 1)
      allocate (matrix(n, n), step(n), slopes(0:n), gaps(n), pivots(n))
      do k = 1, most_steps
         call get_tensions(law, state%gap, state%tension, slopes)
         step = base(1:) + state%gap(0) + matmul(influence(1:, :), state%tension) - state%gap(1:)
         do j = 1, n
            matrix(:, j) = -influence(1:, j)*slopes(j)
            matrix(j, j) = matrix(j, j) + 1
         end do
         ! the gap on the axis is unknown, and not the one that is given
         if (state%pinned > 0) matrix(:, state%pinned) = -1 - influence(1:, 0)*slopes(0)
         call dgesv(n, 1, matrix, n, pivots, step, n, info)
         if (info /= 0) return
         gaps = state%gap(1:)
         if (state%pinned > 0) gaps(state%pinned) = state%gap(0)
         change = maxval(abs(step)/(law%range + abs(gaps)))
         if (.not. change < 1.0e6_dp) return
         ! a law without a wall has no gaps below -range
         share = 1
         if (.not. has_wall) share = min(share, 0.5_dp/maxval(max(-step/(law%range + gaps), 0.5_dp)))
         gaps = gaps + share*step
         if (state%pinned > 0) then
            state%gap(0) = gaps(state%pinned)
            gaps(state%pinned) = state%gap(state%pinned)
         end if
         state%gap(1:) = gaps
         if (change <= at_rest) exit
      end do
      if (.not. change <= at_rest) return
      state%central_gap = state%gap(0)
      call get_tensions(law, state%gap, state%tension, slopes)
      ! the column of the gap on the axis has the other sign
      state%orientation = merge(-1, 1, state%pinned > 0)
      do j = 1, n
         if ((matrix(j, j) < 0) .neqv. (pivots(j) /= j)) state%orientation = -state%orientation
      end do
      state%is_found = .not. (has_wall .and. minval(state%gap) < -1.0e-9_dp*law%range)
   end subroutine iterate

   !> Approach, load and energies of a state.
   pure subroutine sum_up(shape, law, x, state)
      class(shape_t), intent(in) :: shape
      type(attraction_t), intent(in) :: law
      real(dp), intent(in) :: x(0:)
      type(attracted_t), intent(inout) :: state
      real(dp) :: weights(0:ubound(x, 1)), pull, work, t, part, u, left
      type(spot_t) :: spot
      integer :: i, j, k, n

      n = ubound(x, 1)
      do i = 0, n
         call get_sum_weights(state%t, i, weights)
         state%sums(i) = dot_product(weights, state%tension)
      end do
      u = shape%unknown_of(state%radius)
      call shape%evaluate(u, .true., spot)
      state%edge_sum = state%sums(0)
      state%approach = spot%depth - 2*state%edge_sum - state%central_gap
      pull = 0
      work = 0
      left = 0
      do j = 0, n - 1
         left = left + (x(j + 1) - x(j))*(state%sums(j)**2 + state%sums(j + 1)**2)/2
         do k = 1, size(gauss_nodes_10)
            t = state%t(j) + (state%t(j + 1) - state%t(j))*(1 + gauss_nodes_10(k))/2
            part = (t - state%t(j))*(t + state%t(j))/((state%t(j + 1) - state%t(j))*(state%t(j + 1) + state%t(j)))
            associate (w => gauss_weights_10(k)*(state%t(j + 1) - state%t(j))/2*t)
               pull = pull + w*atan2(t, state%radius)*(state%tension(j) + part*(state%tension(j + 1) - state%tension(j)))
               work = work + w*law%work_from(max(state%gap(j) + part*(state%gap(j + 1) - state%gap(j)), -law%range/2))
            end associate
         end do
      end do
      state%load = spot%load - 4*state%radius*state%edge_sum - 4*pull
      state%attraction_energy = -pi*state%radius**2*law%work - two_pi*work
      state%elastic_energy = shape%energy(u, .true.) - 2*state%edge_sum*spot%load + 4*state%radius*state%edge_sum**2 + 4*left
      call add_tail(shape, law, x(n), state)
   end subroutine sum_up

   !> What is behind the last node, where the body is as good as rigid: the gap is like a power of the radius, f'/f r, and the tension
   !> like one of the gap. On a cone the energy of a law that falls as the third power of the gap has no bound: it has no value then.
   pure subroutine add_tail(shape, law, radius, state)
      class(shape_t), intent(in) :: shape
      type(attraction_t), intent(in) :: law
      !> Radius of the last node.
      real(dp), intent(in) :: radius
      type(attracted_t), intent(inout) :: state
      real(dp) :: height, slope, gap, power, steepness
      !> Power of the radius by which the work left falls beyond the area, below which most of the energy is far away.
      real(dp), parameter :: least_fall = 0.5_dp

      if (radius >= within_edge*shape%edge .or. law%has_end()) return
      call shape%get_profile(radius, height, slope)
      associate (n => ubound(state%t, 1))
         gap = state%gap(n)
         if (.not. state%tension(n) > 0) return
         power = radius*slope/gap
         steepness = -law%slope(gap)*gap/state%tension(n)
         if (power*steepness > 2) state%load = state%load - two_pi*radius**2*state%tension(n)/(power*steepness - 2)
         if (power*(steepness - 1) - 2 > least_fall) then
            state%attraction_energy = state%attraction_energy - two_pi*radius**2*law%work_from(gap)/(power*(steepness - 1) - 2)
         else
            state%attraction_energy = not_a_number()
         end if
      end associate
   end subroutine add_tail

end module adfric_round_attracted_state

! SPDX-License-Identifier: GPL-3.0-or-later
!> A state of a round body that a law of attraction draws, and the nodes where its gaps are known.
module adfric_round_attracted_nodes
   use adfric_base_kinds, only: dp
   use adfric_interface_attraction, only: attraction_t
   use adfric_round_shape, only: shape_t
   implicit none (type, external)
   private
   public :: attracted_t, node_grid_t, grid_of_rigid_body, grid_of_state, set_nodes, nodes_inside, of_nodes

   !> Where nodes stand: t = centre + width sinh(y), y in equal steps. They are densest at the centre and within its width.
   type :: node_grid_t
      !> Where nodes are densest, and how far from there their spacing is the same.
      real(dp) :: centre = 0, width = 1
      !> Without a wall: width inside of the radius of largest tension.
      real(dp) :: inner_width = 1
   end type node_grid_t

   !> Without a wall a radius of largest tension has this share of the nodes inside; all grids have a multiple of 50 nodes.
   integer, parameter :: nodes_inside = 2, of_nodes = 5

   !> A state. Lengths, heights and stresses are reduced as those of `shape`.
   type :: attracted_t
      !> Coordinate z; radius a of contact; gap on the axis, 0 in contact.
      real(dp) :: z = 0, radius = 0, central_gap = 0
      !> Index of the node whose gap is given, where there is no wall; 0: the axis.
      integer :: pinned = 0
      !> Approach, load, and F(a).
      real(dp) :: approach = 0, load = 0, edge_sum = 0
      !> Elastic energy, and energy of the attraction (below 0) up to the last node and behind it.
      real(dp) :: elastic_energy = 0, attraction_energy = 0
      !> Sign of the determinant of Newton's method: 1 on the first state of a path, and on all that follow it without a fold in z.
      integer :: orientation = 0
      !> Was it found, with gaps nowhere below 0 where there is a wall?
      logical :: is_found = .false.
      !> Nodes of the grid.
      type(node_grid_t) :: grid
      !> t, gap and tension at the nodes, and F; shape `(0:n)`.
      real(dp), allocatable :: t(:), gap(:), tension(:), sums(:)
   contains
      procedure :: gap_at_node
   end type attracted_t

contains

   !> Gap that a state has at t, straight between nodes in t^2; behind the last one that of the rigid body.
   pure real(dp) function gap_at_node(self, shape, t) result(gap)
      class(attracted_t), intent(in) :: self
      class(shape_t), intent(in) :: shape
      !> sqrt(r^2 - a^2), >= 0.
      real(dp), intent(in) :: t
      real(dp) :: height, slope, height_n
      integer :: n, low, high, middle

      n = ubound(self%t, 1)
      if (t >= self%t(n)) then
         call shape%get_profile(min(hypot(t, self%radius), shape%edge), height, slope)
         call shape%get_profile(min(hypot(self%t(n), self%radius), shape%edge), height_n, slope)
         gap = self%gap(n) + height - height_n
         return
      end if
      low = 0
      high = n
      do while (high - low > 1)
         middle = (low + high)/2
         if (self%t(middle) <= t) then
            low = middle
         else
            high = middle
         end if
      end do
      associate (w => (t - self%t(low))*(t + self%t(low))/((self%t(high) - self%t(low))*(self%t(high) + self%t(low))))
         gap = self%gap(low) + w*(self%gap(high) - self%gap(low))
      end associate
   end function gap_at_node

   !> A grid for a rigid body at a gap on the axis.
   pure subroutine grid_of_rigid_body(shape, law, gap, grid)
      class(shape_t), intent(in) :: shape
      type(attraction_t), intent(in) :: law
      !> The gap, > 0.
      real(dp), intent(in) :: gap
      type(node_grid_t), intent(out) :: grid

      grid%centre = 0
      grid%width = min(shape%radius_of_height(law%range + gap/4), shape%edge/2)
   end subroutine grid_of_rigid_body

   !> A grid for what is next to a state: it is as wide as the zone of attraction, and stands at its outer edge where that is sharp.
   pure subroutine grid_of_state(state, has_wall, grid)
      type(attracted_t), intent(in) :: state
      !> Does the law have a wall, or does it push by itself?
      logical, intent(in) :: has_wall
      type(node_grid_t), intent(out) :: grid
      real(dp), parameter :: sharp = 0.6_dp, sharpest = 0.01_dp
      real(dp) :: peak, half, inner, share

      peak = maxval(state%tension)
      half = outermost(state, peak/2)
      if (.not. has_wall .and. state%z > 0) then
         grid%centre = state%z
         grid%width = half - state%z
         grid%inner_width = max(min(state%z - innermost(state, peak/2), state%z), sharpest*grid%width)
         return
      end if
      inner = half - (outermost(state, peak/5) - outermost(state, 0.8_dp*peak))
      share = min(1.0_dp, (half - inner)/(sharp*half))
      grid%centre = half*(1 - share)
      grid%width = half*max(share, sharpest)
   end subroutine grid_of_state

   !> Outermost t with a given tension.
   pure real(dp) function outermost(state, tension) result(t)
      type(attracted_t), intent(in) :: state
      real(dp), intent(in) :: tension
      integer :: k

      t = state%t(1)
      if (.not. tension > 0) return
      do k = ubound(state%t, 1) - 1, 0, -1
         if (state%tension(k) < tension) cycle
         associate (s => state%tension)
            t = state%t(k) + (state%t(k + 1) - state%t(k))*(s(k) - tension)/(s(k) - s(k + 1))
         end associate
         return
      end do
   end function outermost

   !> Innermost t with a given tension, or more; 0 if the axis has it.
   pure real(dp) function innermost(state, tension) result(t)
      type(attracted_t), intent(in) :: state
      real(dp), intent(in) :: tension
      integer :: k

      t = 0
      if (state%tension(0) >= tension) return
      do k = 1, ubound(state%t, 1)
         if (state%tension(k) < tension) cycle
         associate (s => state%tension)
            t = state%t(k - 1) + (state%t(k) - state%t(k - 1))*(tension - s(k - 1))/(s(k) - s(k - 1))
         end associate
         return
      end do
   end function innermost

   !> Nodes from the edge of contact, or the axis, to an end.
   pure subroutine set_nodes(state, end)
      type(attracted_t), intent(inout) :: state
      !> t of the last node.
      real(dp), intent(in) :: end
      real(dp) :: first, last
      integer :: k, n

      n = ubound(state%t, 1)
      if (state%pinned > 0) then
         call set_nodes_about_edge(state, end)
         return
      end if
      first = -asinh(state%grid%centre/state%grid%width)
      last = asinh((end - state%grid%centre)/state%grid%width)
      do k = 0, n
         state%t(k) = state%grid%centre + state%grid%width*sinh(first + (last - first)*k/n)
      end do
      state%t(0) = 0
      state%t(n) = end
   end subroutine set_nodes

   !> Nodes that are densest at the radius of largest tension, on both sides of it.
   pure subroutine set_nodes_about_edge(state, end)
      type(attracted_t), intent(inout) :: state
      !> Radius of the last node.
      real(dp), intent(in) :: end
      integer :: k, n

      n = ubound(state%t, 1)
      associate (m => state%pinned, edge => state%z, inner => min(state%grid%inner_width, state%z))
         do k = 0, m - 1
            state%t(k) = edge - inner*sinh(asinh(edge/inner)*(m - k)/m)
         end do
         state%t(0) = 0
         do k = m, n
            state%t(k) = edge + state%grid%width*sinh(asinh((end - edge)/state%grid%width)*(k - m)/(n - m))
         end do
      end associate
   end subroutine set_nodes_about_edge

end module adfric_round_attracted_nodes

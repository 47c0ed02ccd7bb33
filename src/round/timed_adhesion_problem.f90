! SPDX-License-Identifier: GPL-3.0-or-later
!> The elastic problem of an instant of a contact with a zone of adhesion on a solid that remembers (`adfric_round_timed_adhesion_zone`),
!> and a state of it.
module adfric_round_timed_adhesion_problem
   use adfric_base_kinds, only: dp
   use adfric_round_shape, only: shape_t, spot_t, within_edge
   use adfric_round_timed_adhesion_sums, only: far_cells_t
   implicit none (type, external)
   private
   public :: zone_problem_t, zone_state_t, set_shape, get_memory

   !> The elastic problem of an instant, in units of the contact.
   type :: zone_problem_t
      !> The shape, and where its profile ends.
      class(shape_t), allocatable :: shape
      !> Stress S of adhesion, its range h, and the modulus E; all > 0.
      real(dp) :: stress = 1, range = 1, modulus = 1
      !> Distance of the nodes.
      real(dp) :: cell = 1
      !> The memory w at the nodes; shape `(0:n_nodes)`.
      real(dp), allocatable :: memory(:)
      !> Nodes of a core far within the contact, whose memory is not known: states that need it are not found.
      integer :: core = 0
      !> A node beside the edge of contact.
      integer :: anchor = 0
      !> The integral of the memory from the axis up to it.
      real(dp) :: anchor_sum = 0
      !> Cells of the zone far from its edge, where they are summed up for all radii of a step.
      type(far_cells_t) :: far
      !> Radius b of a flat punch; enormous for other shapes.
      real(dp) :: face = huge(1.0_dp)
      !> Change of approach over that of the parameter beyond the radius of a flat punch, and approach of the state there.
      real(dp) :: face_scale = 1, edge_approach = 0
      !> Was the state there found?
      logical :: has_edge = .true.
   contains
      procedure :: depth_at
      procedure :: adhesion_radius
      procedure :: node_below
   end type zone_problem_t

   !> A state.
   type :: zone_state_t
      !> Radii c of adhesion (beyond a flat punch a parameter) and a of contact, approach and load; no adhesion where c = 0.
      real(dp) :: c = 0, a = 0, approach = 0, load = 0
      !> Derivatives by c of a, approach and load along the curve of states; those of approach and load serve searches only.
      real(dp) :: a_slope = 0, approach_slope = 0, load_slope = 0
      !> Was it found?
      logical :: is_found = .true.
   end type zone_state_t

contains

   !> g at a radius; enormous where the profile has ended.
   pure real(dp) function depth_at(self, radius) result(depth)
      class(zone_problem_t), intent(in) :: self
      real(dp), intent(in) :: radius
      type(spot_t) :: spot

      depth = 0
      if (self%face < huge(depth)) return
      depth = huge(depth)
      if (.not. radius < within_edge*self%shape%edge) return
      call self%shape%evaluate(self%shape%unknown_of(radius), .not. radius < self%shape%corner, spot)
      depth = spot%depth
   end function depth_at

   !> The radius of adhesion of a parameter c.
   pure real(dp) function adhesion_radius(self, c) result(radius)
      class(zone_problem_t), intent(in) :: self
      real(dp), intent(in) :: c

      radius = min(c, self%face)
   end function adhesion_radius

   !> The last node up to a radius or a parameter c. The edge of a flat punch is a node.
   pure integer function node_below(self, c) result(node)
      class(zone_problem_t), intent(in) :: self
      real(dp), intent(in) :: c

      if (c < self%face) then
         node = int(c/self%cell)
      else
         node = nint(self%face/self%cell)
      end if
   end function node_below

   !> The shape of a problem.
   pure subroutine set_shape(self, shape)
      !> Receives the shape.
      class(zone_problem_t), intent(inout) :: self
      class(shape_t), intent(in) :: shape

      allocate (self%shape, source=shape)
      if (shape%has_face .and. shape%n_pieces == 0) self%face = shape%corner
   end subroutine set_shape

   !> The memory at a radius, and its integral from the axis.
   pure subroutine get_memory(self, x, memory, sums)
      type(zone_problem_t), intent(in) :: self
      real(dp), intent(in) :: x
      real(dp), intent(out) :: memory, sums
      real(dp) :: share
      integer :: cell, k

      cell = int(x/self%cell)
      share = x/self%cell - cell
      memory = self%memory(cell) + share*(self%memory(cell + 1) - self%memory(cell))
      sums = share*self%cell*(self%memory(cell) + memory)/2
      do k = self%anchor, cell - 1
         sums = sums + self%cell*(self%memory(k) + self%memory(k + 1))/2
      end do
      do k = cell, self%anchor - 1
         sums = sums - self%cell*(self%memory(k) + self%memory(k + 1))/2
      end do
      sums = sums + self%anchor_sum
   end subroutine get_memory

end module adfric_round_timed_adhesion_problem

! SPDX-License-Identifier: GPL-3.0-or-later
!> States of two grids make one: the error falls with the square of the spacing, so a third of what the finer grid changes is left.
module adfric_round_attracted_sample
   use adfric_base_kinds, only: dp
   use adfric_interface_attraction, only: attraction_t
   use adfric_round_attracted_nodes, only: attracted_t, node_grid_t
   use adfric_round_attracted_state, only: solve_state
   use adfric_round_shape, only: shape_t
   implicit none (type, external)
   private
   public :: body_t, attracted_sample_t, take_sample, with_control
   public :: by_load, by_approach, by_spring

   !> What is prescribed.
   integer, parameter :: by_load = 1, by_approach = 2, by_spring = 3

   !> A body and the law that draws it, reduced.
   type :: body_t
      !> The shape; it has no corner.
      class(shape_t), allocatable :: shape
      !> The law.
      type(attraction_t) :: law
      !> What is prescribed, one of `by_...`.
      integer :: control = by_load
      !> The compliance of a spring.
      real(dp) :: compliance = 0
   end type body_t

   !> What two grids say of a coordinate.
   type :: attracted_sample_t
      !> Were both states found?
      logical :: is_found = .false.
      !> Coordinate, approach, load, both energies, radius up to which the gap is at most the range.
      real(dp) :: z = 0, approach = 0, load = 0, elastic_energy = 0, attraction_energy = 0, adhesion_radius = 0
      !> The state of the finer grid.
      type(attracted_t), allocatable :: state
   end type attracted_sample_t

contains

   !> What is prescribed of an approach and a load, or of changes of both.
   pure real(dp) function with_control(body, approach, load) result(prescribed)
      type(body_t), intent(in) :: body
      real(dp), intent(in) :: approach, load

      prescribed = load
      if (body%control /= by_load) prescribed = approach
      if (body%control == by_spring) prescribed = prescribed + body%compliance*load
   end function with_control

   !> The state of a coordinate from two grids.
   subroutine take_sample(body, z, grid, n, guess, sample)
      type(body_t), intent(in) :: body
      !> The coordinate.
      real(dp), intent(in) :: z
      type(node_grid_t), intent(in) :: grid
      !> Nodes of the finer grid, an even number.
      integer, intent(in) :: n
      !> A state near by.
      type(attracted_t), allocatable, intent(in) :: guess
      type(attracted_sample_t), intent(out) :: sample
      type(attracted_t), allocatable :: coarse
      type(attracted_t) :: fine
      real(dp) :: coarse_radius

      allocate (coarse)
      sample%z = z
      call solve_state(body%shape, body%law, z, grid, n/2, guess, coarse)
      if (.not. coarse%is_found) return
      coarse_radius = radius_of_range(body, coarse)
      call solve_state(body%shape, body%law, z, grid, n, coarse, fine)
      sample%is_found = fine%is_found
      if (.not. fine%is_found) return
      sample%approach = limit(coarse%approach, fine%approach)
      sample%load = limit(coarse%load, fine%load)
      sample%elastic_energy = limit(coarse%elastic_energy, fine%elastic_energy)
      sample%attraction_energy = limit(coarse%attraction_energy, fine%attraction_energy)
      sample%adhesion_radius = limit(coarse_radius, radius_of_range(body, fine))
      allocate (sample%state, source=fine)
   end subroutine take_sample

   !> What spacings that vanish would give.
   pure real(dp) function limit(coarse, fine)
      real(dp), intent(in) :: coarse, fine

      limit = fine + (fine - coarse)/3
   end function limit

   !> Radius where the gap is the range, by a cubic in t^2 through four nodes; 0 if the gap is larger everywhere.
   pure real(dp) function radius_of_range(body, state) result(radius)
      type(body_t), intent(in) :: body
      type(attracted_t), intent(in) :: state
      real(dp) :: low, high, middle
      integer :: k, first, n

      radius = 0
      n = ubound(state%t, 1)
      associate (range => body%law%range)
         if (state%gap(0) > range) return
         do k = 1, n - 1
            if (state%gap(k) > range) exit
         end do
         first = min(max(k - 2, 0), n - 3)
         low = state%t(k - 1)
         high = state%t(k)
         do k = 1, 60
            middle = (low + high)/2
            if (cubic(state%t(first:first + 3)**2, state%gap(first:first + 3), middle**2) > range) then
               high = middle
            else
               low = middle
            end if
         end do
      end associate
      radius = hypot(state%radius, (low + high)/2)
   end function radius_of_range

   !> The cubic through four samples.
   pure real(dp) function cubic(x, y, at) result(value)
      real(dp), intent(in) :: x(4), y(4), at
      real(dp) :: part
      integer :: i, j

      value = 0
      do i = 1, 4
         part = y(i)
         do j = 1, 4
            if (j /= i) part = part*(at - x(j))/(x(i) - x(j))
         end do
         value = value + part
      end do
   end function cubic

end module adfric_round_attracted_sample

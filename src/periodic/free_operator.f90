! SPDX-License-Identifier: GPL-3.0-or-later
!> The surface of an elastic half-space under pressures on equal cells that end at the border of a map, in one direction or in both.
!>
!> Displacements are the convolution of the pressures with the influence of a cell (`adfric_periodic_free_influence`). On a grid of
!> twice the cells, filled with zeros, a transform convolves without images (R. W. Hockney, Methods Comput. Phys. 9, 1970, 135).
!> Along a direction in which the surface goes on periodically the grid has the cells of the map. The mean displacement is
!> absolute: it counts from the undisturbed surface, or, where there are images, from where a line load has none.
!>
!> `apply_stiffness` is an approximate inverse: of a map that goes on periodically in both directions, whose influence is that of
!> the nearest image. It serves conjugate gradients as preconditioner. Pressures are in E*, displacements in the unit of the cells,
!> both positive into the solid.
module adfric_periodic_free_operator
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_base_error, only: error_t, set_error, input_failure
   use adfric_base_watch, only: asks_for_end, watch_t
   use adfric_numerics_even_transform, only: next_smooth, transform_even
   use adfric_numerics_spectral_filter, only: new_spectral_filter, spectral_filter_t
   use adfric_periodic_free_influence, only: set_influence
   use adfric_periodic_operator, only: is_too_long
   implicit none (type, external)
   private
   public :: free_operator_t, new_free_operator

   !> Least compliance of a wave of the approximate inverse over that of a cell; waves of real cells have more.
   real(dp), parameter :: least_compliance = 1.0e-6_dp

   !> Compliance on a grid of cells, and an approximate inverse. Not to be copied; one for each thread.
   type :: free_operator_t
      !> Number of cells in each direction.
      integer :: n_cells(2) = 0
      !> Size of a cell.
      real(dp) :: cell_size(2) = 0
      !> Does the surface go on periodically along x, along y?
      logical :: is_periodic(2) = .false.
      !> Displacement of a cell under a pressure of E* on it alone.
      real(dp) :: own_influence = 0
      !> How often the compliance was applied.
      integer :: n_applied = 0
      !> Transforms of the grid, and of that of the approximate inverse.
      type(spectral_filter_t), private :: filter, near
      !> Compliance of the modes over the gain of the transforms, and stiffness of the approximate inverse; y first.
      real(dp), allocatable, private :: compliance(:, :), stiffness(:, :)
      !> Whom iterations ask whether they shall end; null: nobody.
      class(watch_t), pointer :: watch => null()
   contains
      procedure :: is_stopped
      procedure :: apply_compliance
      procedure :: apply_stiffness
   end type free_operator_t

contains

   !> Set up the operator on a grid.
   subroutine new_free_operator(self, n_cells, lengths, is_periodic, error)
      !> The operator; not to be used after an error.
      type(free_operator_t), intent(out) :: self
      !> Number of cells in each direction.
      integer, intent(in) :: n_cells(2)
      !> Lengths of the map along x and y, in any unit, > 0.
      real(dp), intent(in) :: lengths(2)
      !> Does the surface go on periodically along x, along y? Not along both.
      logical, intent(in) :: is_periodic(2)
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error
      integer :: n(2), n_near(2)

      if (has_asserts) call assert(.not. all(is_periodic), 'new_free_operator: a direction is free')
      if (is_too_long(n_cells, lengths)) then
         call set_error(error, input_failure, 'the cells of a surface are far longer than wide')
         return
      end if
      self%n_cells = n_cells
      self%cell_size = lengths/n_cells
      self%is_periodic = is_periodic
      ! distances up to that of the first and the last cell must not be those of images
      n = merge(n_cells, [next_smooth(2*n_cells(1) - 1), next_smooth(2*n_cells(2) - 1)], is_periodic)
      n_near = merge(n_cells, [next_smooth(n_cells(1)), next_smooth(n_cells(2))], is_periodic)
      call new_spectral_filter(self%filter, n(1), n(2), .false., .false., error, n_cells)
      if (.not. allocated(error)) call new_spectral_filter(self%near, n_near(1), n_near(2), .false., .false., error, n_cells)
      if (.not. allocated(error)) call set_modes(self, lengths, n, n_near, error)
   end subroutine new_free_operator

   !> Find the compliance of all modes, and the stiffness of those of the approximate inverse.
   subroutine set_modes(self, lengths, n, n_near, error)
      !> The operator, with its cells and transforms; receives the modes.
      type(free_operator_t), intent(inout) :: self
      !> Lengths of the map along x and y.
      real(dp), intent(in) :: lengths(2)
      !> Number of samples of both transforms.
      integer, intent(in) :: n(2), n_near(2)
      type(error_t), allocatable, intent(out) :: error
      real(dp), allocatable :: influence(:, :)

      allocate (influence(0:n(1)/2, 0:n(2)/2))
      call set_influence(self%cell_size, lengths, self%is_periodic, influence)
      self%own_influence = influence(0, 0)
      allocate (self%compliance(0:n(2) - 1, 0:n(1)/2))
      call transform_even(n, influence, self%compliance, error)
      if (allocated(error)) return
      self%compliance(:, :) = self%compliance/self%filter%gain
      allocate (self%stiffness(0:n_near(2) - 1, 0:n_near(1)/2))
      call transform_even(n_near, influence(:n_near(1)/2, :n_near(2)/2), self%stiffness, error)
      if (allocated(error)) return
      self%stiffness(:, :) = (1/max(self%stiffness, least_compliance*self%own_influence))/self%near%gain
   end subroutine set_modes

   !> Shall iterations end before their time? What they have found is of no use then.
   logical function is_stopped(self)
      class(free_operator_t), intent(in) :: self

      is_stopped = asks_for_end(self%watch)
   end function is_stopped

   !> Displacements under given pressures.
   subroutine apply_compliance(self, pressure, displacement)
      class(free_operator_t), intent(inout) :: self
      !> Pressure on the cells [E*]; shape `n_cells`.
      real(dp), intent(in), contiguous :: pressure(:, :)
      !> Receives the displacement of the surface in the middles of the cells; shape `n_cells`.
      real(dp), intent(out), contiguous :: displacement(:, :)

      call self%filter%apply(self%compliance, pressure, displacement)
      self%n_applied = self%n_applied + 1
   end subroutine apply_compliance

   !> About the pressures that make given displacements.
   subroutine apply_stiffness(self, displacement, pressure)
      class(free_operator_t), intent(inout) :: self
      !> Displacement of the surface in the middles of the cells; shape `n_cells`.
      real(dp), intent(in), contiguous :: displacement(:, :)
      !> Receives the pressure [E*]; shape `n_cells`.
      real(dp), intent(out), contiguous :: pressure(:, :)

      call self%near%apply(self%stiffness, displacement, pressure)
   end subroutine apply_stiffness

end module adfric_periodic_free_operator

! SPDX-License-Identifier: GPL-3.0-or-later
!> The surface of an elastic half-space that goes on beyond a map, as a periodic surface of twice the length.
!>
!> On a map of twice the cells a convolution with the influence of a cell has no images (`adfric_periodic_free_operator`). Its
!> transform is positive there, so that it has an inverse, which takes displacements of the doubled map to pressures. Where
!> pressures are 0 beyond the body those on the body are what makes its displacements on the half-space, exactly. So a body that
!> ends is a periodic surface of the doubled map, of this stiffness, whose cells beyond the body lie so deep that nothing touches or
!> pulls there. A constant has a stiffness as that of a layer has: displacements are absolute. Along a direction in which the
!> surface goes on periodically the map is not doubled.
module adfric_periodic_free_kernel
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t, set_error, input_failure
   use adfric_numerics_even_transform, only: transform_even
   use adfric_periodic_free_influence, only: set_influence
   use adfric_periodic_kernel, only: kernel_t
   implicit none (type, external)
   private
   public :: free_kernel_t, new_free_kernel

   !> Stiffness of the waves of a grid.
   type :: free_grid_t
      !> Pressure over displacement, up to half of the waves along y, [E* over the unit of lengths].
      real(dp), allocatable :: stiffness(:, :)
   end type free_grid_t

   !> A half-space with pressures in E*.
   type, extends(kernel_t) :: free_kernel_t
      !> Grids of the doubled map, the finest first, each of half the cells of the one before.
      type(free_grid_t), allocatable, private :: grids(:)
   contains
      procedure :: get_stiffness
      procedure :: mean_compliance
   end type free_kernel_t

contains

   !> Find the stiffness of the waves on all grids.
   subroutine new_free_kernel(self, n_cells, lengths, is_periodic, n_grids, error)
      !> The kernel; not to be used after an error.
      type(free_kernel_t), intent(out) :: self
      !> Number of cells of the map along x and y, even along a period.
      integer, intent(in) :: n_cells(2)
      !> Lengths of the map along x and y, in any unit, > 0.
      real(dp), intent(in) :: lengths(2)
      !> Does the surface go on periodically along x, along y? Not along both.
      logical, intent(in) :: is_periodic(2)
      !> Number of nested grids; the cells of the doubled map can be halved once less.
      integer, intent(in) :: n_grids
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error
      real(dp), allocatable :: influence(:, :)
      integer :: k, n(2)

      allocate (self%grids(n_grids))
      do k = 1, n_grids
         n = n_cells*merge(1, 2, is_periodic)/2**(k - 1)
         allocate (influence(0:n(1)/2, 0:n(2)/2))
         call set_influence(lengths*merge(1, 2, is_periodic)/n, lengths, is_periodic, influence)
         allocate (self%grids(k)%stiffness(0:n(2) - 1, 0:n(1)/2))
         call transform_even(n, influence, self%grids(k)%stiffness, error)
         if (allocated(error)) return
         if (.not. minval(self%grids(k)%stiffness) > 0) then
            call set_error(error, input_failure, 'the influence of a cell has a wave without stiffness')
            return
         end if
         self%grids(k)%stiffness(:, :) = 1/self%grids(k)%stiffness
         deallocate (influence)
      end do
   end subroutine new_free_kernel

   !> See `kernel_t`: the inverse of the influence.
   pure subroutine get_stiffness(self, n_x, n_y, cell_size, stiffness)
      class(free_kernel_t), intent(in) :: self
      !> Numbers of waves per length along x and along y, all of those of one of the grids.
      real(dp), intent(in) :: n_x(:), n_y(:)
      !> Size of the cells, not used here: it belongs to the grid.
      real(dp), intent(in) :: cell_size(2)
      !> Receives the stiffness of each pair of numbers; shape `(size(n_y), size(n_x))`.
      complex(dp), intent(out) :: stiffness(:, :)
      integer :: k

      stiffness = 0
      do k = 1, size(self%grids)
         if (any(shape(self%grids(k)%stiffness) /= [size(n_y), size(n_x)])) cycle
         stiffness = self%grids(k)%stiffness
         ! a constant is given its stiffness by `mean_compliance`
         stiffness(1, 1) = 0
      end do
      associate (unused => cell_size)
      end associate
   end subroutine get_stiffness

   !> Mean displacement over mean pressure [length/E*].
   pure real(dp) function mean_compliance(self)
      class(free_kernel_t), intent(in) :: self

      mean_compliance = 1/self%grids(1)%stiffness(0, 0)
   end function mean_compliance

end module adfric_periodic_free_kernel

! SPDX-License-Identifier: GPL-3.0-or-later
!> The heights of a surface as rows that a column steps along.
!>
!> Heights are in units of the peak-to-valley height of the surface, and count from its highest position. The path of a row begins
!> where its own highest piece begins.
module adfric_foundation_stepping_relief
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_shape_height_line, only: height_line_t, new_cosine_line, new_sampled_line, same_height
   use adfric_shape_period_seam, only: seam_t
   use adfric_shape_periodic_heights, only: preparation_t, prepare_heights
   use adfric_shape_polynomial, only: get_turning_positions, polynomial_at
   implicit none (type, external)
   private
   public :: relief_t, new_wave_relief, new_measured_relief

   !> The rows of a surface.
   type :: relief_t
      !> Peak-to-valley height [unit of the heights given].
      real(dp) :: height = 0
      !> Length of the period [unit of the spacing given].
      real(dp) :: period = 1
      !> The rows.
      type(height_line_t), allocatable :: rows(:)
      !> Where the paths of the rows begin, x in periods, 0 to 1; shape `(n_rows)`.
      real(dp), allocatable :: starts(:)
      !> How far their highest positions are from there along the paths, in periods; shape `(n_rows)`.
      real(dp), allocatable :: crests(:)
      !> Steps of measured heights, before their ends were brought together.
      type(seam_t) :: seam
   end type relief_t

contains

   !> One row that is a sum of waves.
   pure subroutine new_wave_relief(self, amplitudes, phases, is_reversed)
      !> Receives the row; its period is 1.
      type(relief_t), intent(out) :: self
      !> Amplitudes of the waves with 1, 2, ... periods, in any unit.
      real(dp), intent(in) :: amplitudes(:)
      !> Their phases at x = 0 [rad]; as many.
      real(dp), intent(in) :: phases(:)
      !> Is the row crossed from its end to its start?
      logical, intent(in) :: is_reversed

      allocate (self%rows(1))
      call new_cosine_line(self%rows(1), amplitudes, phases)
      if (is_reversed) call self%rows(1)%reverse()
      call reduce(self)
   end subroutine new_wave_relief

   !> Rows of measured heights.
   subroutine new_measured_relief(self, heights, spacing, preparation, interpolation, is_reversed, is_coarse, error)
      type(relief_t), intent(out) :: self
      !> The heights, in any unit; shape `(nx, n_rows)`.
      real(dp), intent(in) :: heights(:, :)
      !> Distance of samples along x, in any unit.
      real(dp), intent(in) :: spacing
      type(preparation_t), intent(in) :: preparation
      !> Pieces between samples, `linear_pieces` or `cubic_pieces`.
      integer, intent(in) :: interpolation
      !> Are the rows crossed from their ends to their starts?
      logical, intent(in) :: is_reversed
      !> Is every second sample left out, to see what the interpolation costs?
      logical, intent(in) :: is_coarse
      type(error_t), allocatable, intent(out) :: error
      type(height_line_t) :: line
      real(dp), allocatable :: periodic(:, :)
      integer :: i

      call prepare_heights(preparation, heights, spacing, periodic, self%period, self%seam, error)
      if (allocated(error)) return
      allocate (self%rows(size(periodic, 2)))
      do i = 1, size(self%rows)
         call new_sampled_line(line, periodic(:, i), interpolation)
         if (is_coarse) then
            call line%coarsen(self%rows(i))
         else
            self%rows(i)%degree = line%degree
            call move_alloc(line%coefficients, self%rows(i)%coefficients)
         end if
         if (is_reversed) call self%rows(i)%reverse()
      end do
      call reduce(self)
   end subroutine new_measured_relief

   !> Heights from the highest position in units of the height, and paths that begin where rows are highest.
   pure subroutine reduce(self)
      type(relief_t), intent(inout) :: self
      real(dp) :: lowest(size(self%rows)), highest(size(self%rows)), unit
      integer :: first(size(self%rows)), i

      allocate (self%starts(size(self%rows)), self%crests(size(self%rows)))
      do i = 1, size(self%rows)
         call self%rows(i)%get_extremes(lowest(i), highest(i), first(i))
      end do
      self%height = maxval(highest) - minval(lowest)
      unit = 1
      if (self%height > 0) unit = self%height
      do i = 1, size(self%rows)
         associate (c => self%rows(i)%coefficients)
            c(0, :) = c(0, :) - maxval(highest)
            c = c/unit
            self%crests(i) = highest_position(c(:, first(i)))/size(c, 2)
            self%starts(i) = modulo(-(first(i) - 1)/real(size(c, 2), dp), 1.0_dp)
         end associate
         call self%rows(i)%rotate(first(i))
      end do
   end subroutine reduce

   !> Where a piece is highest, 0 to 1. Of a crest between two pieces round-off decides which one it belongs to, so the end
   !> counts as well as the beginning.
   pure real(dp) function highest_position(c) result(position)
      !> Coefficients of the piece, in units of the height; shape `(0:degree)`.
      real(dp), intent(in) :: c(0:)
      real(dp) :: positions(4), highest
      integer :: i, n_positions

      position = 0
      highest = c(0)
      call get_turning_positions(c, positions, n_positions)
      do i = 1, n_positions
         if (.not. polynomial_at(c, positions(i)) > highest) cycle
         position = positions(i)
         highest = polynomial_at(c, position)
      end do
      if (sum(c) > highest + same_height) position = 1
   end function highest_position

end module adfric_foundation_stepping_relief

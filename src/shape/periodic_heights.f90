! SPDX-License-Identifier: GPL-3.0-or-later
!> From measured heights to one period of a surface, row by row along x.
module adfric_shape_periodic_heights
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_shape_closing, only: close_period, closing_blend
   use adfric_shape_period_seam, only: seam_t, seam_of
   use adfric_shape_short_waves, only: remove_short_waves
   use adfric_shape_trend, only: remove_trend, trend_line
   implicit none (type, external)
   private
   public :: preparation_t, prepare_heights

   !> What is done with measured heights, in this order.
   type :: preparation_t
      !> What is subtracted first: one of `adfric_shape_trend`.
      integer :: trend = trend_line
      !> How the ends are brought together: one of `adfric_shape_closing`.
      integer :: closing = closing_blend
      !> Share of the measured length that a blend or a taper changes, 0 to 0.5.
      real(dp) :: share = 0.05_dp
      !> The shortest wavelength that stays [unit of the spacing]; 0: the heights stay as they are.
      real(dp) :: shortest_wavelength = 0
   end type preparation_t

contains

   !> Make one period of measured heights.
   subroutine prepare_heights(preparation, heights, spacing, periodic, period, seam, error)
      !> What is to be done.
      type(preparation_t), intent(in) :: preparation
      !> Measured heights, in any unit; shape `(nx, ny)`, x is the first dimension, and a line is one row.
      real(dp), intent(in) :: heights(:, :)
      !> Distance of samples along x, > 0, in any unit.
      real(dp), intent(in) :: spacing
      !> Receives the heights of one period, shape `(n, ny)`.
      real(dp), allocatable, intent(out) :: periodic(:, :)
      !> Receives the length of the period [unit of the spacing].
      real(dp), intent(out) :: period
      !> Receives the steps along x of the heights without trend, before their ends are brought together.
      type(seam_t), intent(out) :: seam
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error
      real(dp), allocatable :: level(:, :)

      allocate (level, source=heights)
      call remove_trend(level, preparation%trend)
      seam = seam_of(level, 1)
      call close_period(level, preparation%closing, preparation%share, periodic)
      period = size(periodic, 1)*spacing
      if (preparation%shortest_wavelength > 0) then
         call remove_short_waves(periodic, preparation%shortest_wavelength/period, error)
      end if
   end subroutine prepare_heights

end module adfric_shape_periodic_heights

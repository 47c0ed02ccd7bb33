! SPDX-License-Identifier: GPL-3.0-or-later
!> Sinusoidal waves in the middles of cells.
module adfric_periodic_wave_cells
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   implicit none (type, external)
   private
   public :: set_wave

contains

   !> The gap of an undeformed wave D (1 - cos), from its crest on, along one direction or the sum of both.
   pure subroutine set_wave(amplitude, cells_of_period, n_cells, shape)
      !> D of the wave along each direction [any unit of length].
      real(dp), intent(in) :: amplitude
      !> Number of cells of a whole period.
      integer, intent(in) :: cells_of_period
      !> Number of cells that are wanted along x and y, from the crest on; 1 along y for a wave along x alone.
      integer, intent(in) :: n_cells(2)
      !> Receives the gap [unit of the amplitude]; shape `n_cells`.
      real(dp), allocatable, intent(inout) :: shape(:, :)
      real(dp) :: trough(maxval(n_cells))
      integer :: i, j

      trough = [(amplitude*(1 - cos(two_pi*(i - 0.5_dp)/cells_of_period)), i=1, size(trough))]
      if (allocated(shape)) deallocate (shape)
      allocate (shape(n_cells(1), n_cells(2)))
      do j = 1, n_cells(2)
         shape(:, j) = trough(:n_cells(1))
         if (n_cells(2) > 1) shape(:, j) = shape(:, j) + trough(j)
      end do
   end subroutine set_wave

end module adfric_periodic_wave_cells

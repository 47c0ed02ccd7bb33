! SPDX-License-Identifier: GPL-3.0-or-later
!> The last directions of steps under a sliding body, and the pressures that they make.
!>
!> Directions d_i are kept with their pressures w_i = A d_i in all cells and with these preconditioned, v_i = M w_i on the open cells, so
!> that w_i M w_j = 0: w_i . v_j = 0 over the open cells for i other than j.
module adfric_periodic_past_directions
   use adfric_base_kinds, only: dp
   use adfric_periodic_maps, only: dot_of, is_shared
   implicit none (type, external)
   private
   public :: past_directions_t

   !> Least and largest number of directions that are kept. A step has to go through all of them, which is worth it where there are
   !> many steps, on hard cases; on large maps they would take more memory than the rest of the solution.
   integer, parameter :: fewest_directions = 2, most_directions = 40
   !> Cells that are kept in all, as far as the least number of directions allows.
   integer, parameter :: cells_kept = 2**20
   !> A direction that comes out so many times shorter than it went in is made of round-off.
   real(dp), parameter :: round_off = 1.0e-13_dp

   !> One direction.
   type :: direction_t
      !> The direction, its pressure, and this preconditioned; shape of the cells.
      real(dp), allocatable, dimension(:, :) :: gap, pressure, preconditioned
      !> Sum of `pressure` times `preconditioned`.
      real(dp) :: product = 0
   end type direction_t

   !> The last directions.
   type :: past_directions_t
      private
      !> Directions, in no order.
      type(direction_t), allocatable :: directions(:)
      !> How many there have been since the last `clear`.
      integer :: n_taken = 0
   contains
      procedure :: clear
      procedure :: take
   end type past_directions_t

contains

   !> Forget all directions.
   pure subroutine clear(self)
      class(past_directions_t), intent(inout) :: self

      self%n_taken = 0
   end subroutine clear

   !> Make a direction orthogonal to those that are kept, and keep it instead of the oldest one.
   subroutine take(self, gap, pressure, preconditioned, product)
      class(past_directions_t), intent(inout) :: self
      !> The direction, its pressure in all cells, and this preconditioned; shape of the cells.
      real(dp), intent(inout), contiguous, dimension(:, :) :: gap, pressure, preconditioned
      !> Receives the sum of `pressure` times `preconditioned`; 0 if only round-off is left of the direction, which is not kept then.
      real(dp), intent(out) :: product
      real(dp) :: factors(most_directions), rows(size(gap, 2)), product_before
      integer :: i, j, n, index

      if (.not. allocated(self%directions)) &
         & allocate (self%directions(min(most_directions, max(fewest_directions, cells_kept/size(gap)))))
      n = min(self%n_taken, size(self%directions))
      index = mod(self%n_taken, size(self%directions)) + 1
      product_before = dot_of(pressure, preconditioned)
      do i = 1, n
         factors(i) = -dot_of(pressure, self%directions(i)%preconditioned)/self%directions(i)%product
      end do
      !$omp parallel do if(is_shared(size(gap))) default(none) shared(self, gap, pressure, preconditioned, factors, rows, n) &
      !$omp& private(i, j)
      do j = 1, size(gap, 2)
         do i = 1, n
            associate (d => self%directions(i))
               gap(:, j) = gap(:, j) + factors(i)*d%gap(:, j)
               pressure(:, j) = pressure(:, j) + factors(i)*d%pressure(:, j)
               preconditioned(:, j) = preconditioned(:, j) + factors(i)*d%preconditioned(:, j)
            end associate
         end do
         rows(j) = dot_product(pressure(:, j), preconditioned(:, j))
      end do
      !$omp end parallel do
      product = sum(rows)
      if (.not. product > round_off**2*product_before) product = 0
      if (.not. product > 0) return
      call keep(self%directions(index), gap, pressure, preconditioned)
      self%directions(index)%product = product
      self%n_taken = self%n_taken + 1
   end subroutine take

   !> Keep a direction.
   subroutine keep(self, gap, pressure, preconditioned)
      type(direction_t), intent(inout) :: self
      !> The direction, its pressure in all cells, and this preconditioned; shape of the cells.
      real(dp), intent(in), contiguous, dimension(:, :) :: gap, pressure, preconditioned
      integer :: j

      if (.not. allocated(self%gap)) allocate (self%gap, self%pressure, self%preconditioned, mold=gap)
      !$omp parallel do if(is_shared(size(gap))) default(none) shared(self, gap, pressure, preconditioned) private(j)
      do j = 1, size(gap, 2)
         self%gap(:, j) = gap(:, j)
         self%pressure(:, j) = pressure(:, j)
         self%preconditioned(:, j) = preconditioned(:, j)
      end do
      !$omp end parallel do
   end subroutine keep

end module adfric_periodic_past_directions

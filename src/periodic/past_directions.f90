!> The last directions of steps under a sliding body, and the pressures that they make.
!>
!> Directions d_i are kept with their pressures w_i = A d_i in all cells and with these preconditioned, v_i = M w_i on the open cells, so
!> that w_i M w_j = 0: w_i . v_j = 0 over the open cells for i other than j.
module adfric_periodic_past_directions
   use adfric_base_kinds, only: dp
   use adfric_periodic_maps, only: dot_of, add_multiple
   implicit none (type, external)
   private
   public :: past_directions_t

   !> Directions that are kept; more save few steps, and every step has to go through them.
   integer, parameter :: most_directions = 4

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
      type(direction_t) :: directions(most_directions)
      !> How many there have been since the last `clear`.
      integer :: n_taken = 0
   contains
      procedure :: clear
      procedure :: take
   end type past_directions_t

contains

   !> Forget all directions.
   pure subroutine clear(self)
      !> The directions; their memory is kept.
      class(past_directions_t), intent(inout) :: self

      self%n_taken = 0
   end subroutine clear

   !> Make a direction orthogonal to those that are kept, and keep it instead of the oldest one.
   subroutine take(self, gap, pressure, preconditioned, product)
      !> The directions.
      class(past_directions_t), intent(inout) :: self
      !> The direction, its pressure in all cells, and this preconditioned; shape of the cells.
      real(dp), intent(inout), contiguous, dimension(:, :) :: gap, pressure, preconditioned
      !> Receives the sum of `pressure` times `preconditioned`.
      real(dp), intent(out) :: product
      real(dp) :: factor
      integer :: i

      do i = 1, min(self%n_taken, most_directions)
         associate (d => self%directions(i))
            factor = -dot_of(pressure, d%preconditioned)/d%product
            call add_multiple(gap, factor, d%gap)
            call add_multiple(pressure, factor, d%pressure)
            call add_multiple(preconditioned, factor, d%preconditioned)
         end associate
      end do
      product = dot_of(pressure, preconditioned)
      if (.not. product > 0) return
      i = mod(self%n_taken, most_directions) + 1
      self%n_taken = self%n_taken + 1
      associate (d => self%directions(i))
         d%gap = gap
         d%pressure = pressure
         d%preconditioned = preconditioned
         d%product = product
      end associate
   end subroutine take

end module adfric_periodic_past_directions

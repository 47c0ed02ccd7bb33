! SPDX-License-Identifier: GPL-3.0-or-later
!> Linear problems with an obstacle.
module adfric_numerics_obstacle
   use adfric_base_kinds, only: dp
   use adfric_numerics_lapack, only: dgesv
   implicit none (type, external)
   private
   public :: solve_above

contains

   !> Solve M x = b above an obstacle: each x_i obeys its equation or is that of the obstacle, whichever is more. M has positive elements
   !> on its diagonal alone and a positive inverse. So x rises as elements leave the obstacle, and those that have left do not come back.
   pure subroutine solve_above(matrix, right_side, obstacle, x, is_solved)
      !> The matrix; shape `(n, n)`.
      real(dp), intent(in) :: matrix(:, :)
      !> Right side and obstacle; shape `(n)`.
      real(dp), intent(in) :: right_side(:), obstacle(:)
      !> Receives the solution; shape `(n)`.
      real(dp), intent(out) :: x(:)
      !> Was a system solved?
      logical, intent(out) :: is_solved
      real(dp) :: equations(size(x), size(x)), right(size(x), 1)
      integer :: pivots(size(x)), i, k, info
      logical :: is_met(size(x)), leaves(size(x))

      x = obstacle
      is_met = .true.
      is_solved = .true.
      do k = 1, size(x)
         leaves = is_met .and. matmul(matrix, x) < right_side
         if (.not. any(leaves)) return
         is_met = is_met .and. .not. leaves
         equations = matrix
         right(:, 1) = merge(obstacle, right_side, is_met)
         do i = 1, size(x)
            if (is_met(i)) equations(i, :) = 0
            if (is_met(i)) equations(i, i) = 1
         end do
         call dgesv(size(x), 1, equations, size(x), pivots, right, size(x), info)
         x = right(:, 1)
         is_solved = info == 0 .and. all(abs(x) <= huge(1.0_dp))
         if (.not. is_solved) return
      end do
   end subroutine solve_above

end module adfric_numerics_obstacle

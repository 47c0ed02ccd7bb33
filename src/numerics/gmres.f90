! SPDX-License-Identifier: GPL-3.0-or-later
!> Systems of linear equations whose matrix is known by its products alone, and need not be symmetric: the method of generalised
!> minimal residuals (Y. Saad, M. H. Schultz, SIAM J. Sci. Stat. Comput. 7 (1986) 856), begun again after some steps.
module adfric_numerics_gmres
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: linear_map_t, solve_by_products

   !> Steps before the method begins again, and steps of all.
   integer, parameter :: n_basis = 40, most_steps = 400

   !> A matrix that carries what its products need.
   type, abstract :: linear_map_t
   contains
      procedure(multiply_i), deferred :: multiply
   end type linear_map_t

   abstract interface
      !> Product of the matrix with a vector.
      subroutine multiply_i(self, x, product)
         import :: linear_map_t, dp
         implicit none (type, external)
         !> The matrix; its buffers change.
         class(linear_map_t), intent(inout) :: self
         !> The vector; shape `(n)`.
         real(dp), intent(in) :: x(:)
         !> Receives the product; shape `(n)`.
         real(dp), intent(out) :: product(:)
      end subroutine multiply_i
   end interface

contains

   !> Solve A x = b.
   subroutine solve_by_products(matrix, b, tolerance, x, n_products, is_converged)
      !> A.
      class(linear_map_t), intent(inout) :: matrix
      !> b; shape `(n)`.
      real(dp), intent(in) :: b(:)
      !> Norm of the residual over that of b that is small enough.
      real(dp), intent(in) :: tolerance
      !> Receives x; shape `(n)`.
      real(dp), intent(out) :: x(:)
      !> Number of products.
      integer, intent(out) :: n_products
      !> Is the residual, computed again from x, as small? A NaN is not.
      logical, intent(out) :: is_converged
      real(dp) :: residual(size(b)), goal, before

      x = 0
      n_products = 0
      residual = b
      goal = tolerance*norm2(b)
      is_converged = norm2(b) <= goal
      do while (.not. is_converged .and. n_products < most_steps)
         before = norm2(residual)
         call add_steps(matrix, residual, goal/2, x, n_products)
         call matrix%multiply(x, residual)
         n_products = n_products + 1
         residual = b - residual
         is_converged = norm2(residual) <= goal
         ! what no longer falls will not
         if (.not. norm2(residual) < before) exit
      end do
   end subroutine solve_by_products

   !> The steps of one beginning.
   subroutine add_steps(matrix, residual, goal, x, n_products)
      class(linear_map_t), intent(inout) :: matrix
      !> What x leaves of b.
      real(dp), intent(in) :: residual(:)
      !> Norm of the residual that is small enough.
      real(dp), intent(in) :: goal
      real(dp), intent(inout) :: x(:)
      integer, intent(inout) :: n_products
      real(dp), allocatable :: basis(:, :)
      real(dp) :: h(n_basis + 1, n_basis), right(n_basis + 1), cosines(n_basis), sines(n_basis), y(n_basis), length
      integer :: i, j, n

      allocate (basis(size(x), n_basis + 1))
      right = 0
      right(1) = norm2(residual)
      basis(:, 1) = residual/right(1)
      n = 0
      do j = 1, n_basis
         call matrix%multiply(basis(:, j), basis(:, j + 1))
         n_products = n_products + 1
         do i = 1, j
            h(i, j) = dot_product(basis(:, i), basis(:, j + 1))
            basis(:, j + 1) = basis(:, j + 1) - h(i, j)*basis(:, i)
         end do
         h(j + 1, j) = norm2(basis(:, j + 1))
         do i = 1, j - 1
            h(i:i + 1, j) = [cosines(i)*h(i, j) + sines(i)*h(i + 1, j), cosines(i)*h(i + 1, j) - sines(i)*h(i, j)]
         end do
         length = hypot(h(j, j), h(j + 1, j))
         if (.not. length > 0) exit
         n = j
         cosines(j) = h(j, j)/length
         sines(j) = h(j + 1, j)/length
         right(j:j + 1) = right(j)*[cosines(j), -sines(j)]
         if (.not. abs(right(j + 1)) > goal) then
            h(j, j) = length
            exit
         end if
         basis(:, j + 1) = basis(:, j + 1)/h(j + 1, j)
         h(j, j) = length
      end do
      do j = n, 1, -1
         y(j) = (right(j) - dot_product(h(j, j + 1:n), y(j + 1:n)))/h(j, j)
      end do
      do j = 1, n
         x = x + y(j)*basis(:, j)
      end do
   end subroutine add_steps

end module adfric_numerics_gmres

! SPDX-License-Identifier: GPL-3.0-or-later
!> Factors of matrices with few columns: Q R by Householder's reflections, and singular values by Jacobi's rotations.
!>
!> Both leave errors of round-off relative to each column's own length, so that columns of any units may stand side by side.
module adfric_numerics_column_factors
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   implicit none (type, external)
   private
   public :: factor_columns, solve_triangle, get_singular_values

   !> Sweeps of rotations in which any matrix of so few columns has become orthogonal.
   integer, parameter :: max_sweeps = 60

contains

   !> Replace a matrix by R of its factors Q R, and a vector by Q' times it.
   pure subroutine factor_columns(a, b)
      !> In: the matrix, shape `(n_rows, n)`. Out: R on and above the diagonal; what stands below has no meaning.
      real(dp), intent(inout) :: a(:, :)
      !> In: a vector, shape `(n_rows)`. Out: Q' times it: its first n numbers are along the columns.
      real(dp), intent(inout) :: b(:)
      real(dp) :: length, head, share
      integer :: k, i, m

      m = size(a, 1)
      if (has_asserts) call assert(size(b) == m, 'factor_columns: as many rows on both sides')
      do k = 1, min(size(a, 2), m)
         length = norm2(a(k:m, k))
         if (.not. length > 0) cycle
         if (a(k, k) > 0) length = -length
         ! the reflection is 1 - v v'/(length head) with v = column - length e_k, and head = length - column_k
         head = length - a(k, k)
         a(k, k) = -head
         do i = k + 1, size(a, 2)
            share = dot_product(a(k:m, k), a(k:m, i))/(length*head)
            a(k:m, i) = a(k:m, i) - share*a(k:m, k)
         end do
         share = dot_product(a(k:m, k), b(k:m))/(length*head)
         b(k:m) = b(k:m) - share*a(k:m, k)
         a(k, k) = length
      end do
   end subroutine factor_columns

   !> Solve R x = b with a triangle R. A column whose diagonal is 0 gets x = 0.
   pure subroutine solve_triangle(r, b, x)
      !> The triangle on and above the diagonal; shape `(n_rows, n)`, with n rows or more.
      real(dp), intent(in) :: r(:, :)
      !> The right side; shape `(n)` or longer.
      real(dp), intent(in) :: b(:)
      !> Receives the solution; shape `(n)`.
      real(dp), intent(out) :: x(:)
      integer :: k, n

      n = size(x)
      do k = n, 1, -1
         x(k) = b(k) - dot_product(r(k, k + 1:n), x(k + 1:n))
         if (abs(r(k, k)) > 0) then
            x(k) = x(k)/r(k, k)
         else
            x(k) = 0
         end if
      end do
   end subroutine solve_triangle

   !> Singular values, the largest first, and the directions that belong to them (one-sided rotations of Hestenes).
   pure subroutine get_singular_values(a, values, directions)
      !> The matrix; shape `(n_rows, n)`. It is overwritten.
      real(dp), intent(inout) :: a(:, :)
      !> Receives the singular values, shape `(n)`.
      real(dp), intent(out) :: values(:)
      !> Receives the directions, one a column, each of length 1; shape `(n, n)`.
      real(dp), intent(out) :: directions(:, :)
      real(dp) :: first, second, product, zeta, t, c, s, column(size(a, 1)), row(size(a, 2))
      integer :: n, i, k, sweep, at
      logical :: has_turned

      n = size(a, 2)
      directions = 0
      do i = 1, n
         directions(i, i) = 1
      end do
      do sweep = 1, max_sweeps
         has_turned = .false.
         do i = 1, n - 1
            do k = i + 1, n
               first = dot_product(a(:, i), a(:, i))
               second = dot_product(a(:, k), a(:, k))
               product = dot_product(a(:, i), a(:, k))
               if (.not. abs(product) > epsilon(product)*sqrt(first)*sqrt(second)) cycle
               has_turned = .true.
               zeta = (second - first)/(2*product)
               t = sign(1/(abs(zeta) + sqrt(1 + zeta**2)), zeta)
               c = 1/sqrt(1 + t**2)
               s = c*t
               column = c*a(:, i) - s*a(:, k)
               a(:, k) = s*a(:, i) + c*a(:, k)
               a(:, i) = column
               row = c*directions(:, i) - s*directions(:, k)
               directions(:, k) = s*directions(:, i) + c*directions(:, k)
               directions(:, i) = row
            end do
         end do
         if (.not. has_turned) exit
      end do
      values = norm2(a, 1)
      do i = 1, n - 1
         at = i - 1 + maxloc(values(i:), 1)
         values([i, at]) = values([at, i])
         directions(:, [i, at]) = directions(:, [at, i])
      end do
   end subroutine get_singular_values

end module adfric_numerics_column_factors

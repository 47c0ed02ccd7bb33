! SPDX-License-Identifier: GPL-3.0-or-later
!> Bindings of LAPACK.
module adfric_numerics_lapack
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: dgesv, dgeqrf

   interface
      !> Solve a general system of linear equations by Gaussian elimination with partial pivoting.
      pure subroutine dgesv(n, nrhs, a, lda, ipiv, b, ldb, info)
         import :: dp
         implicit none (type, external)
         !> Number of equations and of unknowns.
         integer, intent(in) :: n
         !> Number of right-hand sides.
         integer, intent(in) :: nrhs
         !> First dimension of `a`, `n` or more.
         integer, intent(in) :: lda
         !> First dimension of `b`, `n` or more.
         integer, intent(in) :: ldb
         !> In: the matrix, shape `(n, n)`. Out: its factors L and U.
         real(dp), intent(inout) :: a(lda, *)
         !> In: the right-hand sides, shape `(n, nrhs)`. Out: the solutions, if `info` is 0.
         real(dp), intent(inout) :: b(ldb, *)
         !> Receives for each row the one that it was exchanged with; shape `(n)`.
         integer, intent(out) :: ipiv(*)
         !> 0 if all went well; > 0 if the matrix is singular, < 0 if an argument is impossible.
         integer, intent(out) :: info
      end subroutine dgesv

      !> Factors Q and R of a rectangular matrix, by Householder reflections.
      pure subroutine dgeqrf(m, n, a, lda, tau, work, lwork, info)
         import :: dp
         implicit none (type, external)
         !> Number of rows.
         integer, intent(in) :: m
         !> Number of columns.
         integer, intent(in) :: n
         !> First dimension of `a`, `m` or more.
         integer, intent(in) :: lda
         !> In: the matrix, shape `(m, n)`. Out: R on and above the diagonal, the reflections below it.
         real(dp), intent(inout) :: a(lda, *)
         !> Receives the factors of the reflections; shape `(min(m, n))`.
         real(dp), intent(out) :: tau(*)
         !> Workspace; shape `(lwork)`.
         real(dp), intent(out) :: work(*)
         !> Size of that space, `n` or more; several times as much is faster.
         integer, intent(in) :: lwork
         !> 0 if all went well; < 0 if an argument is impossible.
         integer, intent(out) :: info
      end subroutine dgeqrf
   end interface

end module adfric_numerics_lapack

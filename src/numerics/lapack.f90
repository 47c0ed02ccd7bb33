!> Bindings of LAPACK.
module adfric_numerics_lapack
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: dgesv

   interface
      !> Solve a general system of linear equations by Gaussian elimination with partial pivoting.
      pure subroutine dgesv(n, nrhs, a, lda, ipiv, b, ldb, info)
         import :: dp
         implicit none (type, external)
         integer, intent(in) :: n, nrhs, lda, ldb
         real(dp), intent(inout) :: a(lda, *), b(ldb, *)
         integer, intent(out) :: ipiv(*), info
      end subroutine dgesv
   end interface

end module adfric_numerics_lapack

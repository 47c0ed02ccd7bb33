!> Bindings of FFTW 3 (M. Frigo, S. G. Johnson, Proc. IEEE 93, 2005, 216), double precision.
!>
!> Sizes are in C's order: of a Fortran array of shape `(nx, ny)` n0 is ny and n1 is nx.
module adfric_numerics_fftw_bindings
   use, intrinsic :: iso_c_binding, only: c_double, c_double_complex, c_int, c_ptr, c_size_t
   implicit none (type, external)
   private
   public :: fftw_plan_r2r_2d, fftw_plan_dft_r2c_2d, fftw_plan_dft_c2r_2d, fftw_execute, fftw_destroy_plan
   public :: fftw_malloc, fftw_free, fftw_redft10, fftw_redft01, fftw_measure, fftw_estimate

   !> Cosine transforms on the half-sample grid: forward (DCT-II) and backward (DCT-III).
   integer(c_int), parameter :: fftw_redft10 = 5, fftw_redft01 = 4
   !> How much a plan may cost: trials, or none.
   integer(c_int), parameter :: fftw_measure = 0, fftw_estimate = 64

   interface
      !> Plan a real-to-real transform; null if there is none.
      type(c_ptr) function fftw_plan_r2r_2d(n0, n1, in, out, kind0, kind1, flags) bind(c, name='fftw_plan_r2r_2d')
         import :: c_double, c_int, c_ptr
         implicit none (type, external)
         !> Number of samples along the second dimension of the Fortran array.
         integer(c_int), intent(in), value :: n0
         !> Number of samples along the first dimension of the Fortran array.
         integer(c_int), intent(in), value :: n1
         !> Transform along the second dimension of the Fortran array, `fftw_redft10` or `fftw_redft01`.
         integer(c_int), intent(in), value :: kind0
         !> Transform along the first dimension of the Fortran array, `fftw_redft10` or `fftw_redft01`.
         integer(c_int), intent(in), value :: kind1
         !> `fftw_measure` or `fftw_estimate`.
         integer(c_int), intent(in), value :: flags
         !> Array that will be transformed, shape `(n1, n0)`; trials overwrite it.
         real(c_double), intent(inout) :: in(*)
         !> Array that will receive the transform, shape `(n1, n0)`; it may be the same one.
         real(c_double), intent(inout) :: out(*)
      end function fftw_plan_r2r_2d

      !> Plan a real-to-complex transform; null if there is none.
      type(c_ptr) function fftw_plan_dft_r2c_2d(n0, n1, in, out, flags) bind(c, name='fftw_plan_dft_r2c_2d')
         import :: c_double, c_double_complex, c_int, c_ptr
         implicit none (type, external)
         !> Number of samples along the second dimension of the Fortran array.
         integer(c_int), intent(in), value :: n0
         !> Number of samples along the first dimension of the Fortran array.
         integer(c_int), intent(in), value :: n1
         !> `fftw_measure` or `fftw_estimate`.
         integer(c_int), intent(in), value :: flags
         !> Array that will be transformed, shape `(n1, n0)`; trials overwrite it.
         real(c_double), intent(inout) :: in(*)
         !> Array that will receive the modes, shape `(n1/2 + 1, n0)`; trials overwrite it.
         complex(c_double_complex), intent(inout) :: out(*)
      end function fftw_plan_dft_r2c_2d

      !> Plan a complex-to-real transform, which destroys its input; null if there is none.
      type(c_ptr) function fftw_plan_dft_c2r_2d(n0, n1, in, out, flags) bind(c, name='fftw_plan_dft_c2r_2d')
         import :: c_double, c_double_complex, c_int, c_ptr
         implicit none (type, external)
         !> Number of samples along the second dimension of the Fortran array.
         integer(c_int), intent(in), value :: n0
         !> Number of samples along the first dimension of the Fortran array.
         integer(c_int), intent(in), value :: n1
         !> `fftw_measure` or `fftw_estimate`.
         integer(c_int), intent(in), value :: flags
         !> Modes that will be transformed, shape `(n1/2 + 1, n0)`; trials overwrite them.
         complex(c_double_complex), intent(inout) :: in(*)
         !> Array that will receive the transform, shape `(n1, n0)`; trials overwrite it.
         real(c_double), intent(inout) :: out(*)
      end function fftw_plan_dft_c2r_2d

      !> Transform the arrays a plan was made for. Of FFTW only this may be called by several threads at once.
      subroutine fftw_execute(plan) bind(c, name='fftw_execute')
         import :: c_ptr
         implicit none (type, external)
         !> The plan, which remembers its arrays.
         type(c_ptr), intent(in), value :: plan
      end subroutine fftw_execute

      !> Free a plan.
      subroutine fftw_destroy_plan(plan) bind(c, name='fftw_destroy_plan')
         import :: c_ptr
         implicit none (type, external)
         !> The plan, which must not be used any more.
         type(c_ptr), intent(in), value :: plan
      end subroutine fftw_destroy_plan

      !> Memory aligned for vector instructions; null if there is none.
      type(c_ptr) function fftw_malloc(n) bind(c, name='fftw_malloc')
         import :: c_ptr, c_size_t
         implicit none (type, external)
         !> Number of bytes.
         integer(c_size_t), intent(in), value :: n
      end function fftw_malloc

      !> Free the memory that `fftw_malloc` gave.
      subroutine fftw_free(memory) bind(c, name='fftw_free')
         import :: c_ptr
         implicit none (type, external)
         !> Address that `fftw_malloc` gave; it must not be used any more.
         type(c_ptr), intent(in), value :: memory
      end subroutine fftw_free
   end interface

end module adfric_numerics_fftw_bindings

! SPDX-License-Identifier: GPL-3.0-or-later
!> Bindings of FFTW 3 (M. Frigo, S. G. Johnson, Proc. IEEE 93, 2005, 216), double precision: transforms of one line of numbers.
module adfric_numerics_fftw_bindings
   use, intrinsic :: iso_c_binding, only: c_double, c_double_complex, c_int, c_ptr, c_size_t
   implicit none (type, external)
   private
   public :: fftw_plan_r2r_1d, fftw_plan_dft_r2c_1d, fftw_plan_dft_c2r_1d, fftw_plan_dft_1d, fftw_destroy_plan
   public :: fftw_execute_r2r, fftw_execute_dft_r2c, fftw_execute_dft_c2r, fftw_execute_dft
   public :: fftw_malloc, fftw_free, fftw_redft10, fftw_redft01, fftw_forward, fftw_backward, fftw_measure, fftw_estimate

   !> Cosine transforms on the half-sample grid: forward (DCT-II) and backward (DCT-III).
   integer(c_int), parameter :: fftw_redft10 = 5, fftw_redft01 = 4
   !> Signs of the exponent of a complex transform and of its inverse.
   integer(c_int), parameter :: fftw_forward = -1, fftw_backward = 1
   !> How much a plan may cost: trials, or none.
   integer(c_int), parameter :: fftw_measure = 0, fftw_estimate = 64

   interface
      !> Plan a real-to-real transform; null if there is none.
      type(c_ptr) function fftw_plan_r2r_1d(n, in, out, kind, flags) bind(c, name='fftw_plan_r2r_1d')
         import :: c_double, c_int, c_ptr
         implicit none (type, external)
         !> Number of samples.
         integer(c_int), intent(in), value :: n
         !> Line like those that will be transformed, shape `(n)`; trials overwrite it.
         real(c_double), intent(inout) :: in(*)
         !> Line like those that will receive the transform, shape `(n)`; it may be the same one.
         real(c_double), intent(inout) :: out(*)
         !> Transform, `fftw_redft10` or `fftw_redft01`.
         integer(c_int), intent(in), value :: kind
         !> `fftw_measure` or `fftw_estimate`.
         integer(c_int), intent(in), value :: flags
      end function fftw_plan_r2r_1d

      !> Plan a real-to-complex transform; null if there is none.
      type(c_ptr) function fftw_plan_dft_r2c_1d(n, in, out, flags) bind(c, name='fftw_plan_dft_r2c_1d')
         import :: c_double, c_double_complex, c_int, c_ptr
         implicit none (type, external)
         !> Number of samples.
         integer(c_int), intent(in), value :: n
         !> Line like those that will be transformed, shape `(n)`; trials overwrite it.
         real(c_double), intent(inout) :: in(*)
         !> Line like those that will receive the modes, shape `(n/2 + 1)`; trials overwrite it.
         complex(c_double_complex), intent(inout) :: out(*)
         !> `fftw_measure` or `fftw_estimate`.
         integer(c_int), intent(in), value :: flags
      end function fftw_plan_dft_r2c_1d

      !> Plan a complex-to-real transform, which destroys its input; null if there is none.
      type(c_ptr) function fftw_plan_dft_c2r_1d(n, in, out, flags) bind(c, name='fftw_plan_dft_c2r_1d')
         import :: c_double, c_double_complex, c_int, c_ptr
         implicit none (type, external)
         !> Number of samples.
         integer(c_int), intent(in), value :: n
         !> Line like those of the modes that will be transformed, shape `(n/2 + 1)`; trials overwrite it.
         complex(c_double_complex), intent(inout) :: in(*)
         !> Line like those that will receive the samples, shape `(n)`; trials overwrite it.
         real(c_double), intent(inout) :: out(*)
         !> `fftw_measure` or `fftw_estimate`.
         integer(c_int), intent(in), value :: flags
      end function fftw_plan_dft_c2r_1d

      !> Plan a complex transform; null if there is none.
      type(c_ptr) function fftw_plan_dft_1d(n, in, out, sign, flags) bind(c, name='fftw_plan_dft_1d')
         import :: c_double_complex, c_int, c_ptr
         implicit none (type, external)
         !> Number of samples.
         integer(c_int), intent(in), value :: n
         !> Line like those that will be transformed, shape `(n)`; trials overwrite it.
         complex(c_double_complex), intent(inout) :: in(*)
         !> Line like those that will receive the transform, shape `(n)`; it may be the same one.
         complex(c_double_complex), intent(inout) :: out(*)
         !> Sign of the exponent, `fftw_forward` or `fftw_backward`.
         integer(c_int), intent(in), value :: sign
         !> `fftw_measure` or `fftw_estimate`.
         integer(c_int), intent(in), value :: flags
      end function fftw_plan_dft_1d

      !> Transform a line as planned. The lines must lie as those of the plan did: apart or the same, on multiples of 16 bytes.
      !> Of FFTW only the four procedures that execute a plan may be called by several threads at once.
      subroutine fftw_execute_r2r(plan, in, out) bind(c, name='fftw_execute_r2r')
         import :: c_double, c_ptr
         implicit none (type, external)
         !> The plan.
         type(c_ptr), intent(in), value :: plan
         !> The samples.
         real(c_double), intent(inout) :: in(*)
         !> Receives the transform; it may be the same line if it was in the plan.
         real(c_double), intent(inout) :: out(*)
      end subroutine fftw_execute_r2r

      !> See `fftw_execute_r2r`.
      subroutine fftw_execute_dft_r2c(plan, in, out) bind(c, name='fftw_execute_dft_r2c')
         import :: c_double, c_double_complex, c_ptr
         implicit none (type, external)
         !> The plan.
         type(c_ptr), intent(in), value :: plan
         !> The samples.
         real(c_double), intent(inout) :: in(*)
         !> Receives the modes.
         complex(c_double_complex), intent(inout) :: out(*)
      end subroutine fftw_execute_dft_r2c

      !> See `fftw_execute_r2r`; the modes are destroyed.
      subroutine fftw_execute_dft_c2r(plan, in, out) bind(c, name='fftw_execute_dft_c2r')
         import :: c_double, c_double_complex, c_ptr
         implicit none (type, external)
         !> The plan.
         type(c_ptr), intent(in), value :: plan
         !> The modes.
         complex(c_double_complex), intent(inout) :: in(*)
         !> Receives the samples.
         real(c_double), intent(inout) :: out(*)
      end subroutine fftw_execute_dft_c2r

      !> See `fftw_execute_r2r`.
      subroutine fftw_execute_dft(plan, in, out) bind(c, name='fftw_execute_dft')
         import :: c_double_complex, c_ptr
         implicit none (type, external)
         !> The plan.
         type(c_ptr), intent(in), value :: plan
         !> The samples.
         complex(c_double_complex), intent(inout) :: in(*)
         !> Receives the transform; it may be the same line if it was in the plan.
         complex(c_double_complex), intent(inout) :: out(*)
      end subroutine fftw_execute_dft

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

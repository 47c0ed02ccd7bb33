! SPDX-License-Identifier: GPL-3.0-or-later
!> A real field of its waves: the inverse Fourier transform in two directions, line by line.
module adfric_numerics_wave_sum
   use, intrinsic :: iso_c_binding, only: c_associated, c_f_pointer, c_int, c_null_ptr, c_ptr, c_size_t
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_base_error, only: error_t, file_failure, set_error
   use adfric_base_kinds, only: dp
   use adfric_numerics_fftw_bindings, only: fftw_backward, fftw_destroy_plan, fftw_estimate, fftw_execute_dft, &
      & fftw_execute_dft_c2r, fftw_free, fftw_malloc, fftw_plan_dft_1d, fftw_plan_dft_c2r_1d
   implicit none (type, external)
   private
   public :: sum_waves

contains

   !> Sum waves: field(i, k) = sum of waves(mx, my) exp(2 pi i ((i - 1) mx/nx + (k - 1) my/ny)) over all mx and my, where those of
   !> mx < 0 are the conjugates of those of -mx and -my. Plans are made without trials, so that the bits do not depend on one.
   subroutine sum_waves(waves, field, error)
      !> In: the waves of mx >= 0; shape `(0:nx/2, 0:ny - 1)`, my < 0 at ny + my. Out: their sums along y.
      complex(dp), intent(inout) :: waves(0:, 0:)
      !> Receives the field; shape `(nx, ny)`.
      real(dp), intent(out) :: field(:, :)
      !> Allocated if there is no memory.
      type(error_t), allocatable, intent(out) :: error
      integer(c_size_t), parameter :: n_bytes = storage_size(1.0_dp)/8
      type(c_ptr) :: line_memory, row_memory, column_plan, row_plan
      complex(dp), pointer, contiguous :: line(:)
      real(dp), pointer, contiguous :: row(:)
      integer :: nx, ny, k

      nx = size(field, 1)
      ny = size(field, 2)
      if (has_asserts) call assert(all(shape(waves) == [nx/2 + 1, ny]), 'sum_waves: waves of the field')
      column_plan = c_null_ptr
      row_plan = c_null_ptr
      line_memory = fftw_malloc(2*n_bytes*max(nx/2 + 1, ny))
      row_memory = fftw_malloc(n_bytes*(nx + 1))
      if (c_associated(line_memory) .and. c_associated(row_memory)) then
         call c_f_pointer(line_memory, line, [max(nx/2 + 1, ny)])
         call c_f_pointer(row_memory, row, [nx])
         ! all of FFTW but the execution works on tables that threads share
         !$omp critical (adfric_fftw)
         column_plan = fftw_plan_dft_1d(int(ny, c_int), line, line, fftw_backward, fftw_estimate)
         row_plan = fftw_plan_dft_c2r_1d(int(nx, c_int), line, row, fftw_estimate)
         !$omp end critical (adfric_fftw)
      end if
      if (c_associated(column_plan) .and. c_associated(row_plan)) then
         do k = 0, nx/2
            line(:ny) = waves(k, :)
            call fftw_execute_dft(column_plan, line, line)
            waves(k, :) = line(:ny)
         end do
         do k = 1, ny
            line(:nx/2 + 1) = waves(:, k - 1)
            call fftw_execute_dft_c2r(row_plan, line, row)
            field(:, k) = row
         end do
      else
         field = 0
         call set_error(error, file_failure, 'FFTW has no memory or no plan for a transform')
      end if
      !$omp critical (adfric_fftw)
      if (c_associated(column_plan)) call fftw_destroy_plan(column_plan)
      if (c_associated(row_plan)) call fftw_destroy_plan(row_plan)
      if (c_associated(line_memory)) call fftw_free(line_memory)
      if (c_associated(row_memory)) call fftw_free(row_memory)
      !$omp end critical (adfric_fftw)
   end subroutine sum_waves

end module adfric_numerics_wave_sum

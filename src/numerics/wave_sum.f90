! SPDX-License-Identifier: GPL-3.0-or-later
!> A real field of its waves, and its waves: Fourier transforms in two directions, line by line.
module adfric_numerics_wave_sum
   use, intrinsic :: iso_c_binding, only: c_associated, c_f_pointer, c_int, c_null_ptr, c_ptr, c_size_t
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_base_error, only: error_t, file_failure, set_error
   use adfric_base_kinds, only: dp
   use adfric_numerics_fftw_bindings, only: fftw_backward, fftw_destroy_plan, fftw_estimate, fftw_execute_dft, &
      & fftw_execute_dft_c2r, fftw_execute_dft_r2c, fftw_forward, fftw_free, fftw_malloc, fftw_plan_dft_1d, fftw_plan_dft_c2r_1d, &
      & fftw_plan_dft_r2c_1d
   implicit none (type, external)
   private
   public :: find_waves, sum_waves

   !> Plans of the lines along both directions, and the memory that they work on.
   type :: lines_t
      !> Memory of a line of waves and of a row of the field, and plans along columns of waves and along rows.
      type(c_ptr) :: line_memory = c_null_ptr, row_memory = c_null_ptr, column_plan = c_null_ptr, row_plan = c_null_ptr
      !> A column or a row of waves.
      complex(dp), pointer, contiguous :: line(:) => null()
      !> A row of the field; shape `(nx)`.
      real(dp), pointer, contiguous :: row(:) => null()
   end type lines_t

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
      type(lines_t) :: lines
      integer :: nx, ny, k

      nx = size(field, 1)
      ny = size(field, 2)
      if (has_asserts) call assert(all(shape(waves) == [nx/2 + 1, ny]), 'sum_waves: waves of the field')
      call open_lines(lines, nx, ny, .false., error)
      if (allocated(error)) then
         field = 0
         return
      end if
      do k = 0, nx/2
         lines%line(:ny) = waves(k, :)
         call fftw_execute_dft(lines%column_plan, lines%line, lines%line)
         waves(k, :) = lines%line(:ny)
      end do
      do k = 1, ny
         lines%line(:nx/2 + 1) = waves(:, k - 1)
         call fftw_execute_dft_c2r(lines%row_plan, lines%line, lines%row)
         field(:, k) = lines%row
      end do
      call close_lines(lines)
   end subroutine sum_waves

   !> Find the waves of which `sum_waves` makes the field.
   subroutine find_waves(field, waves, error)
      !> The field; shape `(nx, ny)`.
      real(dp), intent(in) :: field(:, :)
      !> Receives the waves of mx >= 0; shape `(0:nx/2, 0:ny - 1)`, my < 0 at ny + my.
      complex(dp), intent(out) :: waves(0:, 0:)
      !> Allocated if there is no memory.
      type(error_t), allocatable, intent(out) :: error
      type(lines_t) :: lines
      integer :: nx, ny, k

      nx = size(field, 1)
      ny = size(field, 2)
      if (has_asserts) call assert(all(shape(waves) == [nx/2 + 1, ny]), 'find_waves: waves of the field')
      waves = 0
      call open_lines(lines, nx, ny, .true., error)
      if (allocated(error)) return
      do k = 1, ny
         lines%row(:) = field(:, k)/size(field)
         call fftw_execute_dft_r2c(lines%row_plan, lines%row, lines%line)
         waves(:, k - 1) = lines%line(:nx/2 + 1)
      end do
      do k = 0, nx/2
         lines%line(:ny) = waves(k, :)
         call fftw_execute_dft(lines%column_plan, lines%line, lines%line)
         waves(k, :) = lines%line(:ny)
      end do
      call close_lines(lines)
   end subroutine find_waves

   !> Make the plans.
   subroutine open_lines(self, nx, ny, is_forward, error)
      type(lines_t), intent(out) :: self
      !> Values along both directions.
      integer, intent(in) :: nx, ny
      !> From the field to the waves? Else from the waves to the field.
      logical, intent(in) :: is_forward
      !> Allocated if there is no memory; nothing is kept then.
      type(error_t), allocatable, intent(out) :: error
      integer(c_size_t), parameter :: n_bytes = storage_size(1.0_dp)/8

      self%line_memory = fftw_malloc(2*n_bytes*max(nx/2 + 1, ny))
      self%row_memory = fftw_malloc(n_bytes*(nx + 1))
      if (c_associated(self%line_memory) .and. c_associated(self%row_memory)) then
         call c_f_pointer(self%line_memory, self%line, [max(nx/2 + 1, ny)])
         call c_f_pointer(self%row_memory, self%row, [nx])
         ! all of FFTW but the execution works on tables that threads share
         !$omp critical (adfric_fftw)
         self%column_plan = fftw_plan_dft_1d(int(ny, c_int), self%line, self%line, merge(fftw_forward, fftw_backward, is_forward), &
            & fftw_estimate)
         if (is_forward) then
            self%row_plan = fftw_plan_dft_r2c_1d(int(nx, c_int), self%row, self%line, fftw_estimate)
         else
            self%row_plan = fftw_plan_dft_c2r_1d(int(nx, c_int), self%line, self%row, fftw_estimate)
         end if
         !$omp end critical (adfric_fftw)
      end if
      if (c_associated(self%column_plan) .and. c_associated(self%row_plan)) return
      call close_lines(self)
      call set_error(error, file_failure, 'FFTW has no memory or no plan for a transform')
   end subroutine open_lines

   !> Give back plans and memory.
   subroutine close_lines(self)
      type(lines_t), intent(inout) :: self

      !$omp critical (adfric_fftw)
      if (c_associated(self%column_plan)) call fftw_destroy_plan(self%column_plan)
      if (c_associated(self%row_plan)) call fftw_destroy_plan(self%row_plan)
      if (c_associated(self%line_memory)) call fftw_free(self%line_memory)
      if (c_associated(self%row_memory)) call fftw_free(self%row_memory)
      !$omp end critical (adfric_fftw)
   end subroutine close_lines

end module adfric_numerics_wave_sum

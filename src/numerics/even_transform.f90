! SPDX-License-Identifier: GPL-3.0-or-later
!> The modes of a field that is even about its first sample and goes on periodically, which are real and even, too.
module adfric_numerics_even_transform
   use, intrinsic :: iso_c_binding, only: c_associated, c_int, c_ptr
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t, set_error, file_failure
   use adfric_numerics_fftw_bindings, only: fftw_destroy_plan, fftw_estimate, fftw_execute_dft_r2c, fftw_plan_dft_r2c_1d
   implicit none (type, external)
   private
   public :: transform_even, next_smooth

   !> Factors of the numbers of samples whose transforms are fast.
   integer, parameter :: fast_factors(4) = [2, 3, 5, 7]

contains

   !> Least number from `n` on that has no other factors than those of fast transforms.
   pure integer function next_smooth(n) result(number)
      !> Least number of samples, 1 or more.
      integer, intent(in) :: n
      integer :: rest, k

      number = n
      do
         rest = number
         do k = 1, size(fast_factors)
            do while (mod(rest, fast_factors(k)) == 0)
               rest = rest/fast_factors(k)
            end do
         end do
         if (rest == 1) return
         number = number + 1
      end do
   end function next_smooth

   !> Transform an even field: the sum over all samples of the field times cos(2 pi (m_x i/n_x + m_y j/n_y)).
   subroutine transform_even(n, field, modes, error)
      !> Number of samples in each direction.
      integer, intent(in) :: n(2)
      !> The field as far as it has to be known, to the middle; shape `(0:n(1)/2, 0:n(2)/2)`.
      real(dp), intent(in) :: field(0:, 0:)
      !> Receives the modes, y first, as a symbol of `spectral_filter_t`; shape `(0:n(2) - 1, 0:n(1)/2)`.
      real(dp), intent(out) :: modes(0:, 0:)
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error
      real(dp), allocatable :: rows(:, :), columns(:, :)
      integer :: i, j

      allocate (rows(0:n(1)/2, 0:n(2)/2))
      allocate (columns(0:n(2)/2, 0:n(1)/2))
      call transform_lines(n(1), field, rows, error)
      if (allocated(error)) return
      call transform_lines(n(2), transpose(rows), columns, error)
      if (allocated(error)) return
      do i = 0, n(1)/2
         do j = 0, n(2) - 1
            modes(j, i) = columns(min(j, n(2) - j), i)
         end do
      end do
   end subroutine transform_even

   !> Transform even lines.
   subroutine transform_lines(n, lines, modes, error)
      !> Number of samples of a line.
      integer, intent(in) :: n
      !> The lines to their middles; shape `(0:n/2, n_lines)`.
      real(dp), intent(in) :: lines(0:, :)
      !> Receives their modes; shape `(0:n/2, n_lines)`.
      real(dp), intent(out) :: modes(0:, :)
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error
      type(c_ptr) :: plan
      real(dp), allocatable :: line(:)
      complex(dp), allocatable :: waves(:)
      integer :: i, j

      allocate (line(0:n - 1))
      allocate (waves(0:n/2))
      line(:) = 0
      !$omp critical (adfric_fftw)
      plan = fftw_plan_dft_r2c_1d(int(n, c_int), line, waves, fftw_estimate)
      !$omp end critical (adfric_fftw)
      if (.not. c_associated(plan)) then
         call set_error(error, file_failure, 'FFTW has no memory or no plan for a transform')
         return
      end if
      do j = 1, size(lines, 2)
         do i = 0, n - 1
            line(i) = lines(min(i, n - i), j)
         end do
         call fftw_execute_dft_r2c(plan, line, waves)
         modes(:, j) = real(waves, dp)
      end do
      !$omp critical (adfric_fftw)
      call fftw_destroy_plan(plan)
      !$omp end critical (adfric_fftw)
   end subroutine transform_lines

end module adfric_numerics_even_transform

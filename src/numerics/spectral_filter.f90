!> Multiplication of the modes of a periodic field by a symbol: transform, multiply, transform back.
!>
!> A general field of nx by ny samples goes through the real Fourier transform, modes `(nx/2 + 1, ny)`. A field that is even about
!> the ends of its range, with samples in the middles of nx by ny cells, is a quarter of a period of 2 nx by 2 ny samples and goes
!> through the cosine transform, modes `(nx, ny)`. A filter owns its plans and its buffers: one for each thread.
module adfric_numerics_spectral_filter
   use, intrinsic :: iso_c_binding, only: c_associated, c_f_pointer, c_int, c_null_ptr, c_ptr, c_size_t
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_base_error, only: error_t, set_error, input_failure, file_failure
   use adfric_numerics_fftw_bindings, only: fftw_plan_r2r_2d, fftw_plan_dft_r2c_2d, fftw_plan_dft_c2r_2d, fftw_execute, &
      fftw_destroy_plan, fftw_malloc, fftw_free, fftw_redft10, fftw_redft01, fftw_measure, fftw_estimate
   implicit none (type, external)
   private
   public :: spectral_filter_t, new_spectral_filter

   !> Plans and buffers of one size. Not to be copied.
   type :: spectral_filter_t
      private
      !> Is the field even about the ends of its range, so that cosine transforms will do?
      logical :: is_even = .false.
      !> Factor of a transform followed by its inverse.
      real(dp), public :: gain = 1
      !> Number of modes in each direction.
      integer, public :: n_modes(2) = 0
      !> FFTW's plans of both directions, and the memory of `field` and `modes`; null where there is none.
      type(c_ptr) :: forward = c_null_ptr, backward = c_null_ptr, field_memory = c_null_ptr, modes_memory = c_null_ptr
      !> Shape `(nx, ny)`.
      real(dp), pointer, contiguous :: field(:, :) => null()
      !> Shape `(nx/2 + 1, ny)`; not of even fields, which are transformed in place.
      complex(dp), pointer, contiguous :: modes(:, :) => null()
   contains
      procedure :: apply
      final :: free
   end type spectral_filter_t

contains

   !> Make the plans of a size.
   subroutine new_spectral_filter(self, nx, ny, is_even, is_measured, error)
      !> Receives the plans and buffers; of no use after an error.
      type(spectral_filter_t), intent(out) :: self
      !> Number of samples in each direction, 1 or more.
      integer, intent(in) :: nx, ny
      !> Is the field even about the ends of its range?
      logical, intent(in) :: is_even
      !> Shall trials tell the fastest plan? That takes as long as some hundred transforms, once for each size in a run.
      logical, intent(in) :: is_measured
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error
      integer(c_int) :: flag

      if (min(nx, ny) < 1) then
         call set_error(error, input_failure, 'a transform needs at least one point in each direction')
         return
      end if
      self%is_even = is_even
      self%gain = real(nx, dp)*ny*merge(4, 1, is_even)
      self%n_modes = [merge(nx, nx/2 + 1, is_even), ny]
      flag = merge(fftw_measure, fftw_estimate, is_measured)
      ! all of FFTW but the execution works on tables that threads share
      !$omp critical (adfric_fftw)
      call make_plans(self, int(nx, c_int), int(ny, c_int), flag)
      !$omp end critical (adfric_fftw)
      if (.not. (c_associated(self%forward) .and. c_associated(self%backward))) &
         call set_error(error, file_failure, 'FFTW has no memory or no plan for a transform')
   end subroutine new_spectral_filter

   !> Buffers and plans; what fails stays null.
   subroutine make_plans(self, nx, ny, flag)
      !> In: `is_even` is set. Out: with buffers and plans; what failed is null.
      type(spectral_filter_t), intent(inout) :: self
      !> Number of samples in each direction, 1 or more.
      integer(c_int), intent(in) :: nx, ny
      !> `fftw_measure` or `fftw_estimate`.
      integer(c_int), intent(in) :: flag
      integer(c_size_t), parameter :: n_bytes = storage_size(1.0_dp)/8

      self%field_memory = fftw_malloc(n_bytes*nx*ny)
      if (.not. c_associated(self%field_memory)) return
      call c_f_pointer(self%field_memory, self%field, [nx, ny])
      if (self%is_even) then
         self%forward = fftw_plan_r2r_2d(ny, nx, self%field, self%field, fftw_redft10, fftw_redft10, flag)
         self%backward = fftw_plan_r2r_2d(ny, nx, self%field, self%field, fftw_redft01, fftw_redft01, flag)
      else
         self%modes_memory = fftw_malloc(2*n_bytes*(nx/2 + 1)*ny)
         if (.not. c_associated(self%modes_memory)) return
         call c_f_pointer(self%modes_memory, self%modes, [nx/2 + 1, ny])
         self%forward = fftw_plan_dft_r2c_2d(ny, nx, self%field, self%modes, flag)
         self%backward = fftw_plan_dft_c2r_2d(ny, nx, self%modes, self%field, flag)
      end if
   end subroutine make_plans

   !> Multiply the modes of a field.
   subroutine apply(self, symbol, x, y)
      !> The filter, whose buffers are overwritten.
      class(spectral_filter_t), intent(inout) :: self
      !> Factor of each mode; shape `(n_modes(1), n_modes(2))`; it has to contain the division by `gain`.
      real(dp), intent(in) :: symbol(:, :)
      !> The field; shape `(nx, ny)`.
      real(dp), intent(in) :: x(:, :)
      !> Receives the field with its modes multiplied; shape `(nx, ny)`.
      real(dp), intent(out) :: y(:, :)

      if (has_asserts) call assert(all(shape(x) == shape(self%field)) .and. all(shape(y) == shape(self%field)), &
         & 'apply: fields have the shape of the plans')
      if (has_asserts) call assert(size(symbol, 1) == self%n_modes(1) .and. size(symbol, 2) == self%n_modes(2), &
         & 'apply: there is a factor for each mode')
      self%field(:, :) = x
      call fftw_execute(self%forward)
      if (self%is_even) then
         self%field(:, :) = self%field*symbol
      else
         self%modes(:, :) = self%modes*symbol
      end if
      call fftw_execute(self%backward)
      y = self%field
   end subroutine apply

   !> Give back plans and buffers.
   impure elemental subroutine free(self)
      !> The filter, which holds nothing at the end.
      type(spectral_filter_t), intent(inout) :: self

      !$omp critical (adfric_fftw)
      if (c_associated(self%forward)) call fftw_destroy_plan(self%forward)
      if (c_associated(self%backward)) call fftw_destroy_plan(self%backward)
      if (c_associated(self%field_memory)) call fftw_free(self%field_memory)
      if (c_associated(self%modes_memory)) call fftw_free(self%modes_memory)
      !$omp end critical (adfric_fftw)
      self%forward = c_null_ptr
      self%backward = c_null_ptr
      self%field_memory = c_null_ptr
      self%modes_memory = c_null_ptr
      nullify (self%field, self%modes)
   end subroutine free

end module adfric_numerics_spectral_filter

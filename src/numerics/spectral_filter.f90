! SPDX-License-Identifier: GPL-3.0-or-later
!> Multiplication of the modes of a periodic field by a symbol: transform, multiply, transform back.
!>
!> A general field of nx by ny samples goes through the real Fourier transform, modes `(nx/2 + 1, ny)`. A field that is even about
!> the ends of its range, with samples in the middles of nx by ny cells, is a quarter of a period of 2 nx by 2 ny samples and goes
!> through the cosine transform, modes `(nx, ny)`.
!>
!> The field passes memory three times: rows there; columns there, times the symbol, and back; rows back. Lines are transformed one
!> by one, each as any other, by as many threads as OpenMP gives: the result has the same bits for any number of them. A filter
!> owns its plans and its buffers; one field goes through it at a time. A general field may be smaller than its transforms. It goes
!> on with zeros then, whose rows are not transformed. The file is long by two kinds of fields, which share the passes.
module adfric_numerics_spectral_filter
   use, intrinsic :: iso_c_binding, only: c_associated, c_f_pointer, c_int, c_null_ptr, c_ptr, c_size_t
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_base_error, only: error_t, set_error, input_failure, file_failure
   use adfric_numerics_fftw_bindings, only: fftw_plan_r2r_1d, fftw_plan_dft_r2c_1d, fftw_plan_dft_c2r_1d, fftw_plan_dft_1d, &
      fftw_execute_r2r, fftw_execute_dft_r2c, fftw_execute_dft_c2r, fftw_execute_dft, fftw_destroy_plan, fftw_malloc, fftw_free, &
      fftw_redft10, fftw_redft01, fftw_forward, fftw_backward, fftw_measure, fftw_estimate
   implicit none (type, external)
   private
   public :: spectral_filter_t, new_spectral_filter

   !> Columns that are taken from memory together: two lines of the cache have space for so many modes.
   integer, parameter :: n_together = 8
   !> Samples of a part of a field, and the largest number of parts.
   integer, parameter :: samples_of_part = 2**14, most_parts = 64
   !> Parts that are worth the work of another thread.
   integer, parameter :: shared_parts = 8

   !> Plans and buffers of one size. Not to be copied.
   type :: spectral_filter_t
      private
      !> Is the field even about the ends of its range, so that cosine transforms will do?
      logical :: is_even = .false.
      !> Number of samples of a transform in each direction.
      integer :: n(2) = 0
      !> Number of samples of the field in each direction; behind them it is 0.
      integer :: n_field(2) = 0
      !> Factor of a transform followed by its inverse.
      real(dp), public :: gain = 1
      !> Number of modes in each direction.
      integer, public :: n_modes(2) = 0
      !> Parts of the field that threads share among them; each has a buffer for lines of its own.
      integer :: n_parts = 1
      !> FFTW's plans of rows and columns, there and back; null where there is none.
      type(c_ptr) :: row_there = c_null_ptr, row_back = c_null_ptr, column_there = c_null_ptr, column_back = c_null_ptr
      !> Memory of the modes, of rows and of columns; null where there is none.
      type(c_ptr) :: modes_memory = c_null_ptr, rows_memory = c_null_ptr, columns_memory = c_null_ptr
      !> A row of samples for each part; shape `(nx, n_parts)`, but that rows are a little longer where that keeps them in place.
      real(dp), pointer, contiguous :: rows(:, :) => null()
      !> Modes of the rows of a general field along x, then along both; shape `(nx/2 + 1, n_field(2))` or a little wider.
      complex(dp), pointer, contiguous :: waves(:, :) => null()
      !> Some columns of `waves` for each part; shape `(ny, n_together, n_parts)`.
      complex(dp), pointer, contiguous :: wave_columns(:, :, :) => null()
      !> Modes of an even field; shape `(nx, ny)` or a little wider.
      real(dp), pointer, contiguous :: cosines(:, :) => null()
      !> Some columns of `cosines` for each part; shape `(ny, n_together, n_parts)` or a little longer.
      real(dp), pointer, contiguous :: cosine_columns(:, :, :) => null()
   contains
      procedure :: apply
      procedure, private :: rows_there
      procedure, private :: multiply
      procedure, private :: multiply_line
      procedure, private :: columns_of_waves
      procedure, private :: columns_of_cosines
      procedure, private :: rows_back
      final :: free
   end type spectral_filter_t

contains

   !> Make the plans of a size.
   subroutine new_spectral_filter(self, nx, ny, is_even, is_measured, error, n_field)
      !> Receives the plans and buffers; of no use after an error.
      type(spectral_filter_t), intent(out) :: self
      !> Number of samples in each direction, 1 or more.
      integer, intent(in) :: nx, ny
      !> Is the field even about the ends of its range?
      logical, intent(in) :: is_even
      !> Shall trials tell the fastest plan? The bits of the results then depend on their outcome.
      logical, intent(in) :: is_measured
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error
      !> Number of samples of a general field, nx and ny at most, which goes on with zeros; not present: nx and ny.
      integer, intent(in), optional :: n_field(2)
      integer(c_int) :: flag

      if (min(nx, ny) < 1) then
         call set_error(error, input_failure, 'a transform needs at least one point in each direction')
         return
      end if
      self%is_even = is_even
      self%n = [nx, ny]
      self%n_field = self%n
      if (present(n_field)) self%n_field = n_field
      if (has_asserts) call assert(all(self%n_field <= self%n) .and. (.not. is_even .or. all(self%n_field == self%n)), &
         & 'new_spectral_filter: a general field has no more samples than its transforms, an even one as many')
      self%gain = real(nx, dp)*ny*merge(4, 1, is_even)
      self%n_modes = [merge(nx, nx/2 + 1, is_even), ny]
      self%n_parts = int(min(real(most_parts, dp), max(1.0_dp, real(nx, dp)*ny/samples_of_part)))
      flag = merge(fftw_measure, fftw_estimate, is_measured)
      ! all of FFTW but the execution works on tables that threads share
      !$omp critical (adfric_fftw)
      call make_buffers(self)
      if (c_associated(self%columns_memory)) call make_plans(self, int(nx, c_int), int(ny, c_int), flag)
      !$omp end critical (adfric_fftw)
      if (.not. (c_associated(self%row_there) .and. c_associated(self%row_back) .and. c_associated(self%column_there) &
         & .and. c_associated(self%column_back))) &
         call set_error(error, file_failure, 'FFTW has no memory or no plan for a transform')
   end subroutine new_spectral_filter

   !> Buffers, in this order; where memory fails it stays null, as do the rest. Lines begin on multiples of 16 bytes.
   subroutine make_buffers(self)
      !> In: the numbers of samples and parts are set. Out: with buffers.
      type(spectral_filter_t), intent(inout) :: self
      integer(c_size_t), parameter :: n_bytes = storage_size(1.0_dp)/8
      integer :: wide, width, height

      wide = self%n(1) + mod(self%n(1), 2)
      height = self%n(2) + mod(self%n(2), 2)
      width = width_of(self%n_modes(1))
      self%modes_memory = fftw_malloc(merge(1, 2, self%is_even)*n_bytes*width*self%n_field(2))
      if (.not. c_associated(self%modes_memory)) return
      self%rows_memory = fftw_malloc(n_bytes*wide*self%n_parts)
      if (.not. c_associated(self%rows_memory)) return
      self%columns_memory = fftw_malloc(2*n_bytes*height*n_together*self%n_parts)
      if (.not. c_associated(self%columns_memory)) return
      call c_f_pointer(self%rows_memory, self%rows, [wide, self%n_parts])
      if (self%is_even) then
         call c_f_pointer(self%modes_memory, self%cosines, [width, self%n(2)])
         call c_f_pointer(self%columns_memory, self%cosine_columns, [height, n_together, self%n_parts])
         self%cosines(:, :) = 0
      else
         call c_f_pointer(self%modes_memory, self%waves, [width, self%n_field(2)])
         call c_f_pointer(self%columns_memory, self%wave_columns, [height, n_together, self%n_parts])
         self%waves(:, :) = 0
      end if
   end subroutine make_buffers

   !> Length of the rows of modes in memory: a multiple of what is taken together, but no power of 2, of which a cache would keep
   !> but few.
   pure integer function width_of(n_modes)
      !> Number of modes along x.
      integer, intent(in) :: n_modes
      integer, parameter :: avoided = 64

      width_of = (n_modes + n_together - 1)/n_together*n_together
      if (mod(width_of, avoided) == 0) width_of = width_of + n_together
   end function width_of

   !> Plans of a row and a column; what fails stays null.
   subroutine make_plans(self, nx, ny, flag)
      !> In: with its buffers. Out: with plans for lines of them.
      type(spectral_filter_t), intent(inout) :: self
      !> Number of samples in each direction, 1 or more.
      integer(c_int), intent(in) :: nx, ny
      !> `fftw_measure` or `fftw_estimate`.
      integer(c_int), intent(in) :: flag

      if (self%is_even) then
         self%row_there = fftw_plan_r2r_1d(nx, self%rows, self%cosines, fftw_redft10, flag)
         self%row_back = fftw_plan_r2r_1d(nx, self%cosines, self%rows, fftw_redft01, flag)
         self%column_there = fftw_plan_r2r_1d(ny, self%cosine_columns, self%cosine_columns, fftw_redft10, flag)
         self%column_back = fftw_plan_r2r_1d(ny, self%cosine_columns, self%cosine_columns, fftw_redft01, flag)
      else
         self%row_there = fftw_plan_dft_r2c_1d(nx, self%rows, self%waves, flag)
         self%row_back = fftw_plan_dft_c2r_1d(nx, self%waves, self%rows, flag)
         self%column_there = fftw_plan_dft_1d(ny, self%wave_columns, self%wave_columns, fftw_forward, flag)
         self%column_back = fftw_plan_dft_1d(ny, self%wave_columns, self%wave_columns, fftw_backward, flag)
      end if
   end subroutine make_plans

   !> Multiply the modes of a field.
   subroutine apply(self, symbol, x, y, product, imaginary)
      class(spectral_filter_t), intent(inout) :: self
      !> Factor of each mode; shape `(n_modes(2), n_modes(1))`, y first; it has to contain the division by `gain`.
      real(dp), intent(in), contiguous :: symbol(:, :)
      !> The field; shape `(nx, ny)`, or `n_field`.
      real(dp), intent(in), contiguous :: x(:, :)
      !> Receives the field with its modes multiplied; shape of `x`.
      real(dp), intent(out), contiguous :: y(:, :)
      !> Receives the sum of x times y over all samples.
      real(dp), intent(out), optional :: product
      !> Imaginary part of each factor, of opposite sign for opposite waves; 0 if it is absent. Not for an even field; shape of
      !> `symbol`.
      real(dp), intent(in), contiguous, optional :: imaginary(:, :)
      real(dp) :: products(self%n_field(2))
      integer :: part

      if (has_asserts) call assert(all(shape(x) == self%n_field) .and. all(shape(y) == self%n_field), &
         & 'apply: fields have the shape of the plans')
      if (has_asserts) call assert(size(symbol, 1) == self%n_modes(2) .and. size(symbol, 2) == self%n_modes(1), &
         & 'apply: there is a factor for each mode')
      if (has_asserts .and. present(imaginary)) call assert(all(shape(imaginary) == shape(symbol)) .and. .not. self%is_even, &
         & 'apply: a factor for each mode has an imaginary part, and the field is not even')
      !$omp parallel if(self%n_parts > shared_parts) default(none) shared(self, symbol, imaginary, x, y, products) private(part)
      !$omp do schedule(dynamic)
      do part = 1, self%n_parts
         call self%rows_there(part, x)
      end do
      !$omp end do
      !$omp do schedule(dynamic)
      do part = 1, self%n_parts
         ! what is absent is not passed on, which sanitizers take for a load from nowhere
         if (present(imaginary)) then
            call self%multiply(part, symbol, imaginary)
         else
            call self%multiply(part, symbol)
         end if
      end do
      !$omp end do
      !$omp do schedule(dynamic)
      do part = 1, self%n_parts
         call self%rows_back(part, x, y, products)
      end do
      !$omp end do
      !$omp end parallel
      if (present(product)) product = sum(products)
   end subroutine apply

   !> Multiply the modes of a part.
   subroutine multiply(self, part, symbol, imaginary)
      class(spectral_filter_t), intent(inout) :: self
      !> Number of the part, from 1.
      integer, intent(in) :: part
      !> Real part of each factor.
      real(dp), intent(in), contiguous :: symbol(:, :)
      !> Imaginary part of each factor; 0 if it is absent.
      real(dp), intent(in), contiguous, optional :: imaginary(:, :)

      if (self%n(2) == 1) then
         if (part > 1) return
         if (present(imaginary)) then
            call self%multiply_line(symbol, imaginary)
         else
            call self%multiply_line(symbol)
         end if
      else if (self%is_even) then
         call self%columns_of_cosines(part, symbol)
      else if (present(imaginary)) then
         call self%columns_of_waves(part, symbol, imaginary)
      else
         call self%columns_of_waves(part, symbol)
      end if
   end subroutine multiply

   !> The first of the lines, or groups of them, of a part.
   pure integer function first_of(part, n_parts, n_lines)
      !> Number of the part, from 1; beyond the last one for the end of that.
      integer, intent(in) :: part
      integer, intent(in) :: n_parts
      !> Number of lines, or groups of them, of all parts.
      integer, intent(in) :: n_lines

      first_of = int((part - 1)*real(n_lines, dp)/n_parts) + 1
   end function first_of

   !> Transform the rows of a part.
   subroutine rows_there(self, part, x)
      class(spectral_filter_t), intent(inout) :: self
      !> Number of the part, from 1.
      integer, intent(in) :: part
      !> The field; shape `(nx, ny)`.
      real(dp), intent(in), contiguous :: x(:, :)
      integer :: j

      do j = first_of(part, self%n_parts, self%n_field(2)), first_of(part + 1, self%n_parts, self%n_field(2)) - 1
         self%rows(:self%n_field(1), part) = x(:, j)
         self%rows(self%n_field(1) + 1:self%n(1), part) = 0
         if (self%is_even) then
            call fftw_execute_r2r(self%row_there, self%rows(:, part), self%cosines(:, j))
         else
            call fftw_execute_dft_r2c(self%row_there, self%rows(:, part), self%waves(:, j))
         end if
      end do
   end subroutine rows_there

   !> Multiply the modes of a field of one row, whose columns are transformed there and back by a factor alone.
   subroutine multiply_line(self, symbol, imaginary)
      class(spectral_filter_t), intent(inout) :: self
      !> Factor of each mode; shape `(1, n_modes(1))`.
      real(dp), intent(in), contiguous :: symbol(:, :)
      !> Imaginary part of the factors, if there is one.
      real(dp), intent(in), contiguous, optional :: imaginary(:, :)
      real(dp), parameter :: gain_of_cosines = 2

      associate (n => self%n_modes(1))
         if (self%is_even) then
            self%cosines(:n, 1) = gain_of_cosines*self%cosines(:n, 1)*symbol(1, :)
         else if (present(imaginary)) then
            self%waves(:n, 1) = self%waves(:n, 1)*cmplx(symbol(1, :), imaginary(1, :), dp)
         else
            self%waves(:n, 1) = self%waves(:n, 1)*symbol(1, :)
         end if
      end associate
   end subroutine multiply_line

   !> Transform the columns of a part of a general field, multiply, and transform back.
   subroutine columns_of_waves(self, part, symbol, imaginary)
      class(spectral_filter_t), intent(inout) :: self
      !> Number of the part, from 1.
      integer, intent(in) :: part
      !> Factor of each mode; shape `(n_modes(2), n_modes(1))`.
      real(dp), intent(in), contiguous :: symbol(:, :)
      !> Imaginary part of the factors, if there is one; shape of `symbol`.
      real(dp), intent(in), contiguous, optional :: imaginary(:, :)
      integer :: group, n_groups, first, i, j, n

      n_groups = (self%n_modes(1) + n_together - 1)/n_together
      associate (columns => self%wave_columns(:, :, part))
         do group = first_of(part, self%n_parts, n_groups), first_of(part + 1, self%n_parts, n_groups) - 1
            first = (group - 1)*n_together
            n = min(n_together, self%n_modes(1) - first)
            do j = 1, self%n_field(2)
               columns(j, :) = self%waves(first + 1:first + n_together, j)
            end do
            do i = 1, n
               columns(self%n_field(2) + 1:self%n(2), i) = 0
               call fftw_execute_dft(self%column_there, columns(:, i), columns(:, i))
               if (present(imaginary)) then
                  call turn(columns(:self%n(2), i), symbol(:, first + i), imaginary(:, first + i))
               else
                  do j = 1, self%n(2)
                     associate (c => columns(j, i), factor => symbol(j, first + i))
                        c = cmplx(real(c, dp)*factor, aimag(c)*factor, dp)
                     end associate
                  end do
               end if
               call fftw_execute_dft(self%column_back, columns(:, i), columns(:, i))
            end do
            do j = 1, self%n_field(2)
               self%waves(first + 1:first + n_together, j) = columns(j, :)
            end do
         end do
      end associate
   end subroutine columns_of_waves

   !> Multiply a column of modes by complex factors.
   pure subroutine turn(column, factor, imaginary)
      complex(dp), intent(inout), contiguous :: column(:)
      !> Real and imaginary part of their factors.
      real(dp), intent(in), contiguous :: factor(:), imaginary(:)
      integer :: j

      do j = 1, size(column)
         associate (a => real(column(j), dp), b => aimag(column(j)))
            column(j) = cmplx(a*factor(j) - b*imaginary(j), a*imaginary(j) + b*factor(j), dp)
         end associate
      end do
   end subroutine turn

   !> Transform the columns of a part of an even field, multiply, and transform back.
   subroutine columns_of_cosines(self, part, symbol)
      class(spectral_filter_t), intent(inout) :: self
      !> Number of the part, from 1.
      integer, intent(in) :: part
      !> Factor of each mode; shape `(n_modes(2), n_modes(1))`.
      real(dp), intent(in), contiguous :: symbol(:, :)
      integer :: group, n_groups, first, i, j, n

      n_groups = (self%n_modes(1) + n_together - 1)/n_together
      associate (columns => self%cosine_columns(:, :, part))
         do group = first_of(part, self%n_parts, n_groups), first_of(part + 1, self%n_parts, n_groups) - 1
            first = (group - 1)*n_together
            n = min(n_together, self%n_modes(1) - first)
            do j = 1, self%n(2)
               columns(j, :) = self%cosines(first + 1:first + n_together, j)
            end do
            do i = 1, n
               call fftw_execute_r2r(self%column_there, columns(:, i), columns(:, i))
               do j = 1, self%n(2)
                  columns(j, i) = columns(j, i)*symbol(j, first + i)
               end do
               call fftw_execute_r2r(self%column_back, columns(:, i), columns(:, i))
            end do
            do j = 1, self%n(2)
               self%cosines(first + 1:first + n_together, j) = columns(j, :)
            end do
         end do
      end associate
   end subroutine columns_of_cosines

   !> Transform the rows of a part back.
   subroutine rows_back(self, part, x, y, products)
      class(spectral_filter_t), intent(inout) :: self
      !> Number of the part, from 1.
      integer, intent(in) :: part
      !> The field; shape `(nx, ny)`.
      real(dp), intent(in), contiguous :: x(:, :)
      !> Receives the rows of the part; shape `(nx, ny)`.
      real(dp), intent(inout), contiguous :: y(:, :)
      !> Receives for each row of the part the sum of x times y; shape `(ny)`.
      real(dp), intent(inout), contiguous :: products(:)
      real(dp) :: total
      integer :: i, j

      do j = first_of(part, self%n_parts, self%n_field(2)), first_of(part + 1, self%n_parts, self%n_field(2)) - 1
         if (self%is_even) then
            call fftw_execute_r2r(self%row_back, self%cosines(:, j), self%rows(:, part))
         else
            call fftw_execute_dft_c2r(self%row_back, self%waves(:, j), self%rows(:, part))
         end if
         total = 0
         !$omp simd reduction(+:total)
         do i = 1, self%n_field(1)
            y(i, j) = self%rows(i, part)
            total = total + x(i, j)*y(i, j)
         end do
         products(j) = total
      end do
   end subroutine rows_back

   !> Give back plans and buffers.
   impure elemental subroutine free(self)
      !> The filter, which holds nothing at the end.
      type(spectral_filter_t), intent(inout) :: self

      !$omp critical (adfric_fftw)
      call free_plan(self%row_there)
      call free_plan(self%row_back)
      call free_plan(self%column_there)
      call free_plan(self%column_back)
      call free_memory(self%modes_memory)
      call free_memory(self%rows_memory)
      call free_memory(self%columns_memory)
      !$omp end critical (adfric_fftw)
      nullify (self%rows, self%waves, self%wave_columns, self%cosines, self%cosine_columns)
   end subroutine free

   !> Give back a plan, if there is one.
   subroutine free_plan(plan)
      !> The plan; null at the end.
      type(c_ptr), intent(inout) :: plan

      if (c_associated(plan)) call fftw_destroy_plan(plan)
      plan = c_null_ptr
   end subroutine free_plan

   !> Give back memory, if there is any.
   subroutine free_memory(memory)
      !> What `fftw_malloc` gave; null at the end.
      type(c_ptr), intent(inout) :: memory

      if (c_associated(memory)) call fftw_free(memory)
      memory = c_null_ptr
   end subroutine free_memory

end module adfric_numerics_spectral_filter

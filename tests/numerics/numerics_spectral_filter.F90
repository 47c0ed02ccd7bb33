! SPDX-License-Identifier: GPL-3.0-or-later
! Transforms, symbols and threads.
module numerics_spectral_filter
   use omp_lib, only: omp_get_max_threads, omp_set_num_threads
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_numerics_spectral_filter, only: spectral_filter_t, new_spectral_filter
   use funit
   implicit none (type, external)

   real(dp), parameter :: pi = acos(-1.0_dp), round_off = 1.0e-14_dp

contains

   !> A symbol of ones gives the field back.
   subroutine check_identity(nx, ny, is_even)
      integer, intent(in) :: nx, ny
      logical, intent(in) :: is_even
      type(spectral_filter_t) :: filter
      type(error_t), allocatable :: error
      real(dp), allocatable :: symbol(:, :), x(:, :), y(:, :)
      real(dp) :: product

      call new_spectral_filter(filter, nx, ny, is_even, .false., error)
#line 25 "/work/main/tests/numerics/numerics_spectral_filter.pf"
  call assertFalse(allocated(error), &
 & location=SourceLocation( &
 & 'numerics_spectral_filter.pf', &
 & 25) )
  if (anyExceptions()) return
#line 26 "/work/main/tests/numerics/numerics_spectral_filter.pf"
      allocate (x(nx, ny), y(nx, ny), symbol(filter%n_modes(2), filter%n_modes(1)))
      call random_number(x)
      symbol = 1/filter%gain
      call filter%apply(symbol, x, y, product)
#line 30 "/work/main/tests/numerics/numerics_spectral_filter.pf"
  call assertEqual(x, y, tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_spectral_filter.pf', &
 & 30) )
  if (anyExceptions()) return
#line 31 "/work/main/tests/numerics/numerics_spectral_filter.pf"
#line 31 "/work/main/tests/numerics/numerics_spectral_filter.pf"
  call assertRelativelyEqual(sum(x*y), product, tolerance=10*round_off, &
 & location=SourceLocation( &
 & 'numerics_spectral_filter.pf', &
 & 31) )
  if (anyExceptions()) return
#line 32 "/work/main/tests/numerics/numerics_spectral_filter.pf"
   end subroutine check_identity

   !@test
   subroutine test_identity()
      integer, parameter :: sizes(*) = [1, 2, 3, 4, 7, 16, 30, 63, 300]
      integer :: i, j

      do i = 1, size(sizes)
         do j = 1, size(sizes)
            call check_identity(sizes(i), sizes(j), .false.)
            call check_identity(sizes(i), sizes(j), .true.)
         end do
      end do
   end subroutine test_identity

   ! Of two waves the one whose place in the symbol, y first, is 0 goes; the other is trebled.
   !@test
   subroutine test_two_waves()
      integer, parameter :: nx = 12, ny = 10
      type(spectral_filter_t) :: filter
      type(error_t), allocatable :: error
      real(dp) :: symbol(ny, nx/2 + 1), one(nx, ny), other(nx, ny), y(nx, ny)
      integer :: i, j

      call new_spectral_filter(filter, nx, ny, .false., .false., error)
#line 57 "/work/main/tests/numerics/numerics_spectral_filter.pf"
  call assertFalse(allocated(error), &
 & location=SourceLocation( &
 & 'numerics_spectral_filter.pf', &
 & 57) )
  if (anyExceptions()) return
#line 58 "/work/main/tests/numerics/numerics_spectral_filter.pf"
#line 58 "/work/main/tests/numerics/numerics_spectral_filter.pf"
  call assertEqual([nx/2 + 1, ny], filter%n_modes, &
 & location=SourceLocation( &
 & 'numerics_spectral_filter.pf', &
 & 58) )
  if (anyExceptions()) return
#line 59 "/work/main/tests/numerics/numerics_spectral_filter.pf"
      do j = 1, ny
         do i = 1, nx
            one(i, j) = cos(2*pi*(2.0_dp*i/nx + 3.0_dp*j/ny))
            other(i, j) = sin(2*pi*(5.0_dp*i/nx - 1.0_dp*j/ny))
         end do
      end do
      symbol = 3/filter%gain
      symbol(1 + 3, 1 + 2) = 0
      call filter%apply(symbol, one + other, y)
#line 68 "/work/main/tests/numerics/numerics_spectral_filter.pf"
  call assertEqual(3*other, y, tolerance=10*round_off, &
 & location=SourceLocation( &
 & 'numerics_spectral_filter.pf', &
 & 68) )
  if (anyExceptions()) return
#line 69 "/work/main/tests/numerics/numerics_spectral_filter.pf"
   end subroutine test_two_waves

   !> Complex factors against the sums that the transforms stand for.
   subroutine check_complex(nx, ny)
      integer, intent(in) :: nx, ny
      type(spectral_filter_t) :: filter
      type(error_t), allocatable :: error
      real(dp), allocatable :: factor(:, :), imaginary(:, :), x(:, :), y(:, :)
      complex(dp) :: total, mode
      real(dp) :: angle
      integer :: i, j, k, l, m, n

      call new_spectral_filter(filter, nx, ny, .false., .false., error)
      allocate (x(nx, ny), y(nx, ny), factor(filter%n_modes(2), filter%n_modes(1)))
      call random_number(x)
      do k = 0, nx/2
         do l = 0, ny - 1
            factor(l + 1, k + 1) = cos(2*pi*k/nx) + 3*cos(2*pi*l/ny)
         end do
      end do
      imaginary = factor
      do k = 0, nx/2
         do l = 0, ny - 1
            imaginary(l + 1, k + 1) = sin(2*pi*k/nx) - 2*sin(2*pi*l/ny)
         end do
      end do
      call filter%apply(factor/filter%gain, x, y, imaginary=imaginary/filter%gain)
      do j = 0, ny - 1, 2
         do i = 0, nx - 1, 3
            total = 0
            do l = 0, ny - 1
               do k = 0, nx - 1
                  mode = 0
                  do n = 0, ny - 1
                     do m = 0, nx - 1
                        angle = 2*pi*(real(k*(i - m), dp)/nx + real(l*(j - n), dp)/ny)
                        mode = mode + x(m + 1, n + 1)*cmplx(cos(angle), sin(angle), dp)
                     end do
                  end do
                  total = total + mode*cmplx(cos(2*pi*k/nx) + 3*cos(2*pi*l/ny), sin(2*pi*k/nx) - 2*sin(2*pi*l/ny), dp)
               end do
            end do
#line 111 "/work/main/tests/numerics/numerics_spectral_filter.pf"
  call assertEqual(real(total, dp)/(nx*ny), y(i + 1, j + 1), tolerance=100*round_off, &
 & location=SourceLocation( &
 & 'numerics_spectral_filter.pf', &
 & 111) )
  if (anyExceptions()) return
#line 112 "/work/main/tests/numerics/numerics_spectral_filter.pf"
         end do
      end do
   end subroutine check_complex

   !@test
   subroutine test_complex()
      call check_complex(6, 5)
      call check_complex(7, 4)
      call check_complex(8, 8)
      call check_complex(11, 1)
      call check_complex(1, 9)
   end subroutine test_complex

   !> The bits of a filtered field do not depend on the number of threads.
   subroutine check_threads(is_even)
      logical, intent(in) :: is_even
      integer, parameter :: nx = 401, ny = 420
      type(spectral_filter_t) :: filter
      type(error_t), allocatable :: error
      real(dp), allocatable :: symbol(:, :)
      real(dp) :: x(nx, ny), by_one(nx, ny), by_many(nx, ny)
      integer :: n_threads, k

      n_threads = omp_get_max_threads()
      call new_spectral_filter(filter, nx, ny, is_even, .false., error)
#line 137 "/work/main/tests/numerics/numerics_spectral_filter.pf"
  call assertFalse(allocated(error), &
 & location=SourceLocation( &
 & 'numerics_spectral_filter.pf', &
 & 137) )
  if (anyExceptions()) return
#line 138 "/work/main/tests/numerics/numerics_spectral_filter.pf"
      allocate (symbol(filter%n_modes(2), filter%n_modes(1)))
      call random_number(x)
      call random_number(symbol)
      call omp_set_num_threads(1)
      call filter%apply(symbol, x, by_one)
      do k = 2, 5
         call omp_set_num_threads(k)
         call filter%apply(symbol, x, by_many)
         call omp_set_num_threads(n_threads)
#line 147 "/work/main/tests/numerics/numerics_spectral_filter.pf"
  call assertTrue(all(.not. abs(by_one - by_many) > 0), &
 & location=SourceLocation( &
 & 'numerics_spectral_filter.pf', &
 & 147) )
  if (anyExceptions()) return
#line 148 "/work/main/tests/numerics/numerics_spectral_filter.pf"
      end do
   end subroutine check_threads

   !@test
   subroutine test_threads()
      call check_threads(.false.)
      call check_threads(.true.)
   end subroutine test_threads

   !@test
   subroutine test_no_samples()
      type(spectral_filter_t) :: filter
      type(error_t), allocatable :: error

      call new_spectral_filter(filter, 0, 4, .false., .false., error)
#line 163 "/work/main/tests/numerics/numerics_spectral_filter.pf"
  call assertTrue(allocated(error), &
 & location=SourceLocation( &
 & 'numerics_spectral_filter.pf', &
 & 163) )
  if (anyExceptions()) return
#line 164 "/work/main/tests/numerics/numerics_spectral_filter.pf"
   end subroutine test_no_samples

end module numerics_spectral_filter

module Wrapnumerics_spectral_filter
   use FUnit
   use numerics_spectral_filter
   implicit none
   private

contains


end module Wrapnumerics_spectral_filter

function numerics_spectral_filter_suite() result(suite)
   use FUnit
   use numerics_spectral_filter
   use Wrapnumerics_spectral_filter
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('numerics_spectral_filter_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_identity', &
      test_identity))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_two_waves', &
      test_two_waves))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_complex', &
      test_complex))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_threads', &
      test_threads))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_no_samples', &
      test_no_samples))
   call suite%addTest(t)


end function numerics_spectral_filter_suite


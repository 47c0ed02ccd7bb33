! SPDX-License-Identifier: GPL-3.0-or-later
!> What a lighter load changes on a few cells, without transforms: by elimination, with cells opened and closed
!> until none is wrong.
module dense_relief
   use adfric_base_kinds, only: dp
   use dense_kernel, only: set_kernel
   implicit none (type, external)
   private
   public :: solve_dense_relief

contains

   !> Changes of gap and pressure of a contact, from its pressure and gap.
   subroutine solve_dense_relief(pressure, gap, period_y, relief, rise, fall, is_open, compliance)
      real(dp), intent(in) :: pressure(:, :), gap(:, :), period_y, relief
      real(dp), allocatable, intent(out) :: rise(:, :), fall(:, :)
      logical, allocatable, intent(out) :: is_open(:, :)
      !> Mean of the rise of the gap under a relief of 1 where the open cells stay so.
      real(dp), intent(out) :: compliance
      !> Violation of round-off, in the relief and in the largest rise.
      real(dp), parameter :: round_off = 1.0e-12_dp
      integer, parameter :: most_flips = 5000
      real(dp) :: matrix(size(gap), size(gap)), p(size(gap)), g(size(gap)), h(size(gap)), r(size(gap))
      logical :: open(size(gap)), is_wrong(size(gap))
      integer :: position, n_flips, fewest

      call set_matrix(size(gap, 1), size(gap, 2), period_y, matrix)
      p = reshape(pressure, [size(gap)])
      g = reshape(gap, [size(gap)])
      open = .not. p > relief
      fewest = huge(fewest)
      do n_flips = 1, most_flips
         h = merge(0.0_dp, -g, open)
         call find_rise(matrix, relief - p - matmul(matrix, h), open, h)
         r = relief - matmul(matrix, h)
         is_wrong = merge(g + h < -round_off*maxval(abs(h)), p - r < -round_off*relief, open)
         if (.not. any(is_wrong)) exit
         ! all at once while there are fewer of them than before, else the first one, which ends always
         if (count(is_wrong) < fewest) then
            fewest = count(is_wrong)
            open = open .neqv. is_wrong
         else
            position = findloc(is_wrong, .true., dim=1)
            open(position) = .not. open(position)
         end if
      end do
      if (n_flips > most_flips) error stop 'no end of cells that flip'
      rise = reshape(h, shape(gap))
      fall = reshape(merge(p, r, open), shape(gap))
      is_open = reshape(open, shape(gap))
      h = 0
      call find_rise(matrix, 0*h + 1, open, h)
      compliance = sum(h)/size(h)
   end subroutine solve_dense_relief

   !> The stiffness of all cells, wave by wave.
   subroutine set_matrix(nx, ny, period_y, matrix)
      integer, intent(in) :: nx, ny
      real(dp), intent(in) :: period_y
      real(dp), intent(out) :: matrix(nx*ny, nx*ny)
      real(dp) :: kernel(0:nx - 1, 0:ny - 1)
      integer :: i, j, k, l

      call set_kernel(period_y, kernel)
      do j = 0, ny - 1
         do i = 0, nx - 1
            do l = 0, ny - 1
               do k = 0, nx - 1
                  matrix(1 + k + nx*l, 1 + i + nx*j) = kernel(modulo(k - i, nx), modulo(l - j, ny))
               end do
            end do
         end do
      end do
   end subroutine set_matrix

   !> The rise that open cells need, by elimination; symmetric positive definite, so without pivots.
   subroutine find_rise(matrix, given, open, rise)
      real(dp), intent(in) :: matrix(:, :), given(:)
      logical, intent(in) :: open(:)
      real(dp), intent(inout) :: rise(:)
      real(dp), allocatable :: a(:, :), b(:)
      integer, allocatable :: cells(:)
      integer :: j, k, n

      cells = pack([(k, k=1, size(given))], open)
      n = size(cells)
      if (n == 0) return
      a = matrix(cells, cells)
      b = given(cells)
      ! the lower half, which the upper one is the image of
      do k = 1, n
         do j = k + 1, n
            a(j:, j) = a(j:, j) - a(j:, k)*(a(j, k)/a(k, k))
         end do
         b(k + 1:) = b(k + 1:) - a(k + 1:, k)*(b(k)/a(k, k))
      end do
      do k = n, 1, -1
         b(k) = (b(k) - dot_product(a(k + 1:, k), b(k + 1:)))/a(k, k)
      end do
      rise(cells) = b
   end subroutine find_rise

end module dense_relief

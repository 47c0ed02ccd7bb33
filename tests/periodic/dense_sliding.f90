! SPDX-License-Identifier: GPL-3.0-or-later
!> Sliding contact on a few cells, without transforms: the solid's arms time stepping along the rows of cells, and cells are opened
!> and closed one by one, the first wrong one each time (Murty), which ends for matrices with positive principal minors.
module dense_sliding
   use adfric_base_kinds, only: dp
   use adfric_solid_prony, only: prony_t
   use dense_kernel, only: set_kernel
   implicit none (type, external)
   private
   public :: set_matrix, solve_dense

contains

   !> Pressure and gap under a mean pressure; the body slides to +x with a velocity, in units of the period along x.
   subroutine solve_dense(shape, period_y, prony, velocity, mean_pressure, pressure, gap, n_flips)
      real(dp), intent(in) :: shape(:, :), period_y, velocity, mean_pressure
      type(prony_t), intent(in) :: prony
      real(dp), intent(out) :: pressure(size(shape, 1), size(shape, 2)), gap(size(shape, 1), size(shape, 2))
      !> How often a cell was opened or closed; below 0 if that did not end.
      integer, intent(out) :: n_flips
      integer, parameter :: most_flips = 20000
      real(dp), parameter :: round_off = 1.0e-11_dp
      real(dp) :: matrix(size(shape), size(shape)), given(size(shape)), g(size(shape)), p(size(shape))
      logical :: is_open(size(shape)), is_wrong(size(shape))
      integer :: position

      call set_matrix(size(shape, 1), size(shape, 2), period_y, prony, velocity, matrix)
      given = mean_pressure - matmul(matrix, reshape(shape, [size(shape)]))
      is_open = .false.
      do n_flips = 0, most_flips
         call find_gap(matrix, given, is_open, g)
         p = given + matmul(matrix, g)
         is_wrong = merge(g < -round_off*maxval(shape), p < -round_off*maxval(abs(given)), is_open)
         if (.not. any(is_wrong)) exit
         position = findloc(is_wrong, .true., dim=1)
         is_open(position) = .not. is_open(position)
      end do
      if (n_flips > most_flips) n_flips = -1
      pressure = reshape(merge(0.0_dp, p, is_open), [size(shape, 1), size(shape, 2)])
      gap = reshape(g, [size(shape, 1), size(shape, 2)])
   end subroutine solve_dense

   !> The stiffness of all cells: the elastic one, wave by wave, and then the arms along x.
   subroutine set_matrix(nx, ny, period_y, prony, velocity, matrix)
      integer, intent(in) :: nx, ny
      real(dp), intent(in) :: period_y, velocity
      type(prony_t), intent(in) :: prony
      real(dp), intent(out) :: matrix(nx*ny, nx*ny)
      real(dp) :: kernel(0:nx - 1, 0:ny - 1), memory(0:nx - 1), map(nx, ny)
      integer :: i, j, k, l, m

      call set_kernel(period_y, kernel)
      call set_memory(prony, 1/(nx*velocity), memory)
      do j = 0, ny - 1
         do i = 0, nx - 1
            do l = 0, ny - 1
               do k = 0, nx - 1
                  map(k + 1, l + 1) = 0
                  do m = 0, nx - 1
                     map(k + 1, l + 1) = map(k + 1, l + 1) + memory(m)*kernel(modulo(k + m - i, nx), modulo(l - j, ny))
                  end do
               end do
            end do
            matrix(:, 1 + i + nx*j) = reshape(map, [nx*ny])
         end do
      end do
   end subroutine set_matrix

   !> What a cell's stress gets from the elastic stress m cells ahead, whence the solid comes: steady answers of the arms on a ring.
   subroutine set_memory(prony, interval, memory)
      type(prony_t), intent(in) :: prony
      real(dp), intent(in) :: interval
      real(dp), intent(out) :: memory(0:)
      real(dp) :: kept, factor, weight
      integer :: i, m, n

      n = size(memory)
      memory = 0
      memory(0) = prony%relaxed
      do i = 1, size(prony%times)
         kept = exp(-interval/prony%times(i))
         factor = prony%moduli(i)*(1 - kept)/(interval/prony%times(i))
         do m = 0, n - 1
            weight = factor*kept**m/(1 - kept**n)
            memory(m) = memory(m) + weight
            memory(modulo(m + 1, n)) = memory(modulo(m + 1, n)) - weight
         end do
      end do
   end subroutine set_memory

   !> The gap that leaves open cells without pressure, by elimination with pivots.
   subroutine find_gap(matrix, given, is_open, gap)
      real(dp), intent(in) :: matrix(:, :), given(:)
      logical, intent(in) :: is_open(:)
      real(dp), intent(out) :: gap(:)
      real(dp), allocatable :: a(:, :), row(:)
      integer, allocatable :: cells(:)
      integer :: i, k, n, pivot

      gap = 0
      cells = pack([(i, i=1, size(given))], is_open)
      n = size(cells)
      if (n == 0) return
      allocate (a(n, n + 1))
      a(:, :n) = matrix(cells, cells)
      a(:, n + 1) = -given(cells)
      do k = 1, n
         pivot = k - 1 + maxloc(abs(a(k:, k)), dim=1)
         row = a(k, :)
         a(k, :) = a(pivot, :)
         a(pivot, :) = row
         do i = k + 1, n
            a(i, k:) = a(i, k:) - (a(i, k)/a(k, k))*a(k, k:)
         end do
      end do
      do k = n, 1, -1
         gap(cells(k)) = (a(k, n + 1) - dot_product(a(k, k + 1:n), gap(cells(k + 1:))))/a(k, k)
      end do
   end subroutine find_gap

end module dense_sliding

! SPDX-License-Identifier: GPL-3.0-or-later
!> Stiffness of a half-space and shares of cells as one first writes them: sums over all waves, triangles cut by a line. E* is 1.
module plain_periodic
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: stiff_pressure, plain_share, whole_of

   real(dp), parameter :: two_pi = 6.283185307179586476925286766559_dp

contains

   !> Pressure |k|/2 of a gap; of a quarter if it is one.
   function stiff_pressure(gap, period, is_quarter) result(pressure)
      real(dp), intent(in) :: gap(:, :), period(2)
      logical, intent(in) :: is_quarter
      real(dp), allocatable :: pressure(:, :), all(:, :)
      complex(dp), allocatable :: waves(:, :), along_x(:, :), along_y(:, :)
      integer :: k, l, n(2)

      call whole_of(gap, is_quarter, all)
      n = shape(all)
      allocate (along_x(n(1), n(1)), along_y(n(2), n(2)), waves(n(1), n(2)))
      call get_waves(along_x)
      call get_waves(along_y)
      waves(:, :) = matmul(along_x, matmul(cmplx(all, 0, dp), transpose(along_y)))
      do l = 0, n(2) - 1
         do k = 0, n(1) - 1
            waves(k + 1, l + 1) = waves(k + 1, l + 1)*two_pi/2*hypot(min(k, n(1) - k)/period(1), min(l, n(2) - l)/period(2)) &
               & /product(n)
         end do
      end do
      all(:, :) = real(matmul(conjg(along_x), matmul(waves, transpose(conjg(along_y)))), dp)
      allocate (pressure(size(gap, 1), size(gap, 2)))
      pressure(:, :) = all(:size(gap, 1), :size(gap, 2))
   end function stiff_pressure

   !> exp(-2 pi i j k/n); symmetric.
   pure subroutine get_waves(waves)
      complex(dp), intent(out) :: waves(0:, 0:)
      integer :: j, k, n

      n = size(waves, 1)
      do k = 0, n - 1
         do j = 0, n - 1
            waves(j, k) = exp(cmplx(0, -two_pi*modulo(j*k, n)/n, dp))
         end do
      end do
   end subroutine get_waves

   !> The whole of a map between mirrors, or the map.
   pure subroutine whole_of(map, is_quarter, all)
      real(dp), intent(in) :: map(:, :)
      logical, intent(in) :: is_quarter
      real(dp), allocatable, intent(out) :: all(:, :)
      integer :: n(2)

      n = shape(map)
      allocate (all(n(1)*merge(2, 1, is_quarter), n(2)*merge(2, 1, is_quarter)))
      all(:n(1), :n(2)) = map
      if (.not. is_quarter) return
      all(n(1) + 1:, :n(2)) = map(n(1):1:-1, :)
      all(:, n(2) + 1:) = all(:, n(2):1:-1)
   end subroutine whole_of

   !> Integrals of the hat functions of the cells where the gap, linear in triangles, is within the range; both ways to cut squares.
   function plain_share(gap, range, is_quarter) result(share)
      real(dp), intent(in) :: gap(:, :), range
      logical, intent(in) :: is_quarter
      real(dp), allocatable :: share(:, :), all(:, :), shares(:, :)
      integer :: i, j, k, n(2), x(4), y(4)
      integer, parameter :: triangles(3, 4) = reshape([1, 2, 3, 3, 4, 1, 2, 3, 4, 4, 1, 2], [3, 4])
      real(dp) :: part(3)

      call whole_of(gap, is_quarter, all)
      n = shape(all)
      allocate (shares(n(1), n(2)))
      shares = 0
      do j = 1, n(2)
         do i = 1, n(1)
            x = [i, modulo(i, n(1)) + 1, modulo(i, n(1)) + 1, i]
            y = [j, j, modulo(j, n(2)) + 1, modulo(j, n(2)) + 1]
            do k = 1, 4
               associate (c => triangles(:, k))
                  part = cut([all(x(c(1)), y(c(1))), all(x(c(2)), y(c(2))), all(x(c(3)), y(c(3)))], range)/4
                  shares(x(c(1)), y(c(1))) = shares(x(c(1)), y(c(1))) + part(1)
                  shares(x(c(2)), y(c(2))) = shares(x(c(2)), y(c(2))) + part(2)
                  shares(x(c(3)), y(c(3))) = shares(x(c(3)), y(c(3))) + part(3)
               end associate
            end do
         end do
      end do
      allocate (share(size(gap, 1), size(gap, 2)))
      share(:, :) = shares(:size(gap, 1), :size(gap, 2))
   end function plain_share

   !> Means of the three hat functions over a triangle, 0 where the gap is above the range: the rest is a polygon, and that a fan.
   pure function cut(corner, range) result(part)
      real(dp), intent(in) :: corner(3), range
      real(dp) :: part(3), ends(3, 4), here(3), there(3)
      integer :: k, n

      n = 0
      do k = 1, 3
         here = 0
         here(k) = 1
         there = 0
         there(modulo(k, 3) + 1) = 1
         associate (low => corner(k), high => corner(modulo(k, 3) + 1))
            if (low <= range) then
               n = n + 1
               ends(:, n) = here
            end if
            if ((low <= range) .neqv. (high <= range)) then
               n = n + 1
               ends(:, n) = here + (there - here)*((range - low)/(high - low))
            end if
         end associate
      end do
      part = 0
      do k = 2, n - 1
         part = part + abs(volume(ends(:, 1), ends(:, k), ends(:, k + 1)))*(ends(:, 1) + ends(:, k) + ends(:, k + 1))/3
      end do
   end function cut

   !> Determinant of three columns.
   pure real(dp) function volume(a, b, c)
      real(dp), intent(in) :: a(3), b(3), c(3)

      volume = a(1)*(b(2)*c(3) - b(3)*c(2)) - a(2)*(b(1)*c(3) - b(3)*c(1)) + a(3)*(b(1)*c(2) - b(2)*c(1))
   end function volume

end module plain_periodic

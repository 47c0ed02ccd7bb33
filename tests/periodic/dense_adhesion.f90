! SPDX-License-Identifier: GPL-3.0-or-later
!> Adhesive contact along a line of a few cells, without transforms: given shares, cells are opened and closed one by one (Murty), and
!> shares are found anew until they rest. Shares are those of straight lines between the middles of the cells.
module dense_adhesion
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: solve_dense_adhesion

   real(dp), parameter :: two_pi = 2*acos(-1.0_dp)

contains

   !> Gap and shares of the most or the least adhered state under a mean pressure; the period is 1.
   subroutine solve_dense_adhesion(shape, stress, range, mean_pressure, is_adhered, gap, share, has_contact)
      real(dp), intent(in) :: shape(:), stress, range, mean_pressure
      logical, intent(in) :: is_adhered
      real(dp), intent(out) :: gap(size(shape)), share(size(shape))
      logical, intent(out) :: has_contact
      integer, parameter :: most_rounds = 200000
      real(dp), parameter :: resting = 1.0e-14_dp
      real(dp) :: matrix(size(shape), size(shape)), before(size(shape))
      logical :: is_open(size(shape))
      integer :: i, j, k, n

      n = size(shape)
      matrix = 0
      do k = 1, n/2
         do j = 1, n
            do i = 1, n
               matrix(i, j) = matrix(i, j) + merge(1, 2, 2*k == n)*two_pi*k/2*cos(two_pi*k*(i - j)/n)/n
            end do
         end do
      end do
      share = merge(1, 0, is_adhered)
      is_open = .not. is_adhered
      is_open(minloc(shape, 1)) = .false.
      gap = 0
      do k = 1, most_rounds
         has_contact = mean_pressure + stress*sum(share)/n > 0
         if (.not. has_contact) return
         call solve_given(matrix, mean_pressure + stress*share - matmul(matrix, shape), is_open, gap)
         before = share
         share = shares_of(gap, range)
         if (maxval(abs(share - before)) <= resting) return
      end do
      error stop 'the shares do not come to rest'
   end subroutine solve_dense_adhesion

   !> Contact with a given pressure beside that of the gap.
   subroutine solve_given(matrix, given, is_open, gap)
      real(dp), intent(in) :: matrix(:, :), given(:)
      logical, intent(inout) :: is_open(:)
      real(dp), intent(out) :: gap(:)
      real(dp), parameter :: round_off = 1.0e-13_dp
      real(dp) :: pressure(size(gap))
      logical :: is_wrong(size(gap))
      integer :: k, position

      do k = 1, 100000
         call find_gap(matrix, given, is_open, gap)
         pressure = given + matmul(matrix, gap)
         is_wrong = merge(gap < -round_off, pressure < -round_off*maxval(abs(given)), is_open)
         if (.not. any(is_wrong)) return
         position = findloc(is_wrong, .true., dim=1)
         is_open(position) = .not. is_open(position)
      end do
      error stop 'the contact does not come to an end'
   end subroutine solve_given

   !> Gap over open cells whose pressure is 0, by elimination.
   subroutine find_gap(matrix, given, is_open, gap)
      real(dp), intent(in) :: matrix(:, :), given(:)
      logical, intent(in) :: is_open(:)
      real(dp), intent(out) :: gap(:)
      real(dp) :: a(count(is_open), count(is_open) + 1)
      integer :: positions(count(is_open)), i, j, n

      gap = 0
      n = count(is_open)
      positions = pack([(i, i=1, size(gap))], is_open)
      do i = 1, n
         a(i, :n) = matrix(positions(i), positions)
         a(i, n + 1) = -given(positions(i))
      end do
      ! the part of the stiffness on open cells is positive definite, so no pivots are needed
      do i = 1, n
         do j = i + 1, n
            a(j, i:) = a(j, i:) - a(j, i)/a(i, i)*a(i, i:)
         end do
      end do
      do i = n, 1, -1
         gap(positions(i)) = (a(i, n + 1) - sum(a(i, i + 1:n)*gap(positions(i + 1:))))/a(i, i)
      end do
   end subroutine find_gap

   !> Shares of cells within the range, from lines between their middles on a ring.
   function shares_of(gap, range) result(share)
      real(dp), intent(in) :: gap(:), range
      real(dp) :: share(size(gap)), x
      integer :: i, next

      share = 0
      do i = 1, size(gap)
         next = modulo(i, size(gap)) + 1
         associate (left => gap(i), right => gap(next))
            if (max(left, right) <= range) then
               share([i, next]) = share([i, next]) + 0.5_dp
            else if (left <= range) then
               x = (range - left)/(right - left)
               share([i, next]) = share([i, next]) + [x - x**2/2, x**2/2]
            else if (right <= range) then
               x = (range - right)/(left - right)
               share([next, i]) = share([next, i]) + [x - x**2/2, x**2/2]
            end if
         end associate
      end do
   end function shares_of

end module dense_adhesion

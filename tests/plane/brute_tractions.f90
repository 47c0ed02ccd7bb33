! SPDX-License-Identifier: GPL-3.0-or-later
!> Half-plane under tractions linear between samples, by quadrature in quadruple precision: pieces are halved until Gauss's rule
!> of 16 points is exact to its digits.
module brute_tractions
   use adfric_base_kinds, only: dp
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   implicit none (type, external)
   private
   public :: brute_stress, brute_integral

   integer, parameter :: qp = selected_real_kind(33)
   real(qp), parameter :: pi = 3.14159265358979323846264338327950288_qp
   !> Distance from the middle of an interval, in half its length, from which on it is not halved any more.
   real(qp), parameter :: far = 3.0_qp

contains

   !> Stresses [s_xx, s_yy, s_xy] at (x, y), y > 0, or beside the tractions.
   pure function brute_stress(s, p, q, x, y) result(stress)
      real(dp), intent(in) :: s(:), p(:), q(:)
      real(dp), intent(in) :: x, y
      real(dp) :: stress(3)
      real(qp) :: total(3)
      integer :: i

      total = 0
      do i = 1, size(s) - 1
         call add_stress(real(s(i:i + 1), qp), real(p(i:i + 1), qp), real(q(i:i + 1), qp), real(x, qp), real(y, qp), total)
      end do
      stress = real(-2/pi*total, dp)
   end function brute_stress

   !> Flamant's stresses over an interval.
   pure recursive subroutine add_stress(s, p, q, x, y, total)
      real(qp), intent(in) :: s(2), p(2), q(2), x, y
      real(qp), intent(inout) :: total(3)
      real(qp) :: half, middle, t, share
      integer :: k

      half = (s(2) - s(1))/2
      middle = sum(s)/2
      if (hypot(middle - x, y) < far*half) then
         call add_stress([s(1), middle], [p(1), sum(p)/2], [q(1), sum(q)/2], x, y, total)
         call add_stress([middle, s(2)], [sum(p)/2, p(2)], [sum(q)/2, q(2)], x, y, total)
         return
      end if
      do k = 1, size(gauss_nodes)
         t = middle - x + half*gauss_nodes(k)
         share = gauss_weights(k)*half*(value(p, k)*y - value(q, k)*t)/(t*t + y*y)**2
         total = total + share*[t*t, y*y, -t*y]
      end do
   end subroutine add_stress

   !> int f(s)/(x - s) ds, principal value, not at an end where f jumps: int (f(s) - f(x))/(x - s) ds and a logarithm.
   pure real(dp) function brute_integral(s, f, x) result(integral)
      real(dp), intent(in) :: s(:), f(:)
      real(dp), intent(in) :: x
      real(qp) :: total, here
      integer :: i, n

      n = size(s)
      here = 0
      do i = 1, n - 1
         if (x < s(i) .or. x > s(i + 1)) cycle
         here = f(i) + (real(f(i + 1), qp) - f(i))*(real(x, qp) - s(i))/(real(s(i + 1), qp) - s(i))
      end do
      total = 0
      do i = 1, n - 1
         if (x >= s(i) .and. x <= s(i + 1)) then
            total = total - (real(f(i + 1), qp) - f(i))
         else
            call add_integral(real(s(i:i + 1), qp), real(f(i:i + 1), qp) - here, real(x, qp), total)
         end if
      end do
      if (abs(here) > 0) total = total + here*log(abs((real(x, qp) - s(1))/(real(x, qp) - s(n))))
      integral = real(total, dp)
   end function brute_integral

   !> int f(s)/(x - s) ds over an interval that does not contain x.
   pure recursive subroutine add_integral(s, f, x, total)
      real(qp), intent(in) :: s(2), f(2), x
      real(qp), intent(inout) :: total
      real(qp) :: half, middle
      integer :: k

      half = (s(2) - s(1))/2
      middle = sum(s)/2
      if (abs(middle - x) < far*half) then
         call add_integral([s(1), middle], [f(1), sum(f)/2], x, total)
         call add_integral([middle, s(2)], [sum(f)/2, f(2)], x, total)
         return
      end if
      do k = 1, size(gauss_nodes)
         total = total + gauss_weights(k)*half*value(f, k)/(x - middle - half*gauss_nodes(k))
      end do
   end subroutine add_integral

   !> A linear function at a node of Gauss's rule.
   pure real(qp) function value(f, k)
      !> At the ends.
      real(qp), intent(in) :: f(2)
      integer, intent(in) :: k

      value = ((1 - gauss_nodes(k))*f(1) + (1 + gauss_nodes(k))*f(2))/2
   end function value

end module brute_tractions

! SPDX-License-Identifier: GPL-3.0-or-later
!> The periodic cubic spline through equidistant values.
!>
!> With the distance of neighbours as unit, its slopes d obey d(k - 1) + 4 d(k) + d(k + 1) = 3 (h(k + 1) - h(k - 1)), cyclic in k.
!> The matrix is -1/z times (1 - z S) times (1 - z / S), where S shifts by one position and z = sqrt(3) - 2: two recurrences, one
!> forwards and one backwards, each of which forgets by z at every step. n steps each, and no growth of errors.
module adfric_numerics_periodic_spline
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   implicit none (type, external)
   private
   public :: get_spline_slopes

   !> What a recurrence keeps of its value from one position to the next: the root of 1 + 4 z + z^2 inside the unit circle.
   real(dp), parameter :: kept = sqrt(3.0_dp) - 2
   !> Positions after which a recurrence has forgotten: z^40 is 1e-23.
   integer, parameter :: remembered = 40

contains

   !> Slopes of the periodic cubic spline.
   pure subroutine get_spline_slopes(heights, slopes)
      !> Values at equidistant positions of one period, 4 or more; the first follows on the last.
      real(dp), intent(in) :: heights(:)
      !> Receives the slopes [values per distance of neighbours]; as many as values.
      real(dp), intent(out) :: slopes(:)
      integer :: n

      n = size(heights)
      if (has_asserts) call assert(n >= 4 .and. size(slopes) == n, 'get_spline_slopes: a slope for each of four values or more')
      slopes(1) = 3*(heights(2) - heights(n))
      slopes(2:n - 1) = 3*(heights(3:) - heights(:n - 2))
      slopes(n) = 3*(heights(1) - heights(n - 1))
      call filter_forwards(slopes)
      slopes = -kept*slopes(n:1:-1)
      call filter_forwards(slopes)
      slopes = slopes(n:1:-1)
   end subroutine get_spline_slopes

   !> Replace v by the periodic solution u of u(k) - z u(k - 1) = v(k).
   pure subroutine filter_forwards(v)
      !> In: the right-hand side. Out: the solution.
      real(dp), intent(inout) :: v(:)
      real(dp) :: u
      integer :: k

      ! a period from zero ends at u(n) (1 - z^n), and what is further back than `remembered` does not count
      u = 0
      do k = max(1, size(v) + 1 - remembered), size(v)
         u = v(k) + kept*u
      end do
      u = u/(1 - kept**min(size(v), remembered))
      do k = 1, size(v)
         u = v(k) + kept*u
         v(k) = u
      end do
   end subroutine filter_forwards

end module adfric_numerics_periodic_spline

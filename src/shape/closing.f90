! SPDX-License-Identifier: GPL-3.0-or-later
!> How measured heights, which end where the measurement ended, become one period along x.
!>
!> Every row is closed by itself: it becomes a strip, which slides along x. The distance of samples stays as it is, so a period of
!> n' samples that comes from n has n'/n times the measured length.
module adfric_shape_closing
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_base_constants, only: half_pi
   implicit none (type, external)
   private
   public :: close_period, closed_length, closing_none, closing_blend, closing_mirror, closing_taper

   !> The ways of closing, see `close_period`.
   integer, parameter :: closing_none = 1, closing_blend = 2, closing_mirror = 3, closing_taper = 4

contains

   !> Make one period along x of measured heights z_0 ... z_(n - 1).
   !>
   !> - `closing_none`: as it is. z_0 follows on z_(n - 1); right for heights that are periodic.
   !> - `closing_blend`: the last m = share n samples are cross-faded into the first, n' = n - m:
   !>   z'_k = w z_k + (1 - w) z_(n' + k) for k < m, w = sin^2(pi k/(2 m)), and z'_k = z_k from there on. The step at the seam is
   !>   that from z_(n' - 1) to z'_0 = z_(n'), a step of the measured line; slopes have none either. The direction of crossing is
   !>   kept. Where the two ends have nothing in common the faded part is flatter: its root mean square is, in the middle,
   !>   1/sqrt(2) of that of the line.
   !> - `closing_mirror`: there and back, z_0 ... z_(n - 1), z_(n - 1) ... z_0, n' = 2 n. There is no step, and heights keep their
   !>   distribution, but half of them are crossed backwards.
   !> - `closing_taper`: n' = n, and heights go to the mean M of their row at both ends: z'_k = M + w (z_k - M) with
   !>   w = sin^2(pi (k + 1/2)/(2 m)) for k < m = share n/2, and likewise at the end. There is no step, but the ends bear less.
   pure subroutine close_period(heights, closing, share, closed)
      !> Heights of equidistant samples, shape `(n, ny)`; x is the first dimension, and a line is one row.
      real(dp), intent(in) :: heights(:, :)
      !> `closing_none`, `closing_blend`, `closing_mirror` or `closing_taper`.
      integer, intent(in) :: closing
      !> Share of the measured length that a blend fades or a taper lowers (half of it at each end), 0 to 0.5; at less than half a
      !> sample nothing is changed.
      real(dp), intent(in) :: share
      !> Receives the heights of one period, shape `(n', ny)`.
      real(dp), allocatable, intent(out) :: closed(:, :)
      integer :: n

      if (has_asserts) call assert(share >= 0 .and. share <= 0.5_dp, 'close_period: 0 <= share <= 0.5')
      n = size(heights, 1)
      select case (closing)
      case (closing_blend)
         call blend(heights, nint(share*n), closed)
      case (closing_mirror)
         allocate (closed(2*n, size(heights, 2)))
         closed(:n, :) = heights
         closed(n + 1:, :) = heights(n:1:-1, :)
      case (closing_taper)
         allocate (closed, source=heights)
         call taper(nint(share*n/2), closed)
      case default
         if (has_asserts) call assert(closing == closing_none, 'close_period: a known way of closing')
         allocate (closed, source=heights)
      end select
   end subroutine close_period

   !> Number of samples of the period that n samples become.
   pure integer function closed_length(n, closing, share) result(length)
      !> Number of samples.
      integer, intent(in) :: n
      !> `closing_none`, `closing_blend`, `closing_mirror` or `closing_taper`.
      integer, intent(in) :: closing
      !> Share of the measured length that a blend fades, 0 to 0.5.
      real(dp), intent(in) :: share

      length = n
      if (closing == closing_blend) length = n - nint(share*n)
      if (closing == closing_mirror) length = 2*n
   end function closed_length

   !> Cross-fade the last samples of each row into the first.
   pure subroutine blend(heights, m, closed)
      !> Heights, shape `(n, ny)`.
      real(dp), intent(in) :: heights(:, :)
      !> Number of samples that are faded, n/2 or less.
      integer, intent(in) :: m
      !> Receives the heights of one period, shape `(n - m, ny)`.
      real(dp), allocatable, intent(out) :: closed(:, :)
      real(dp) :: weight
      integer :: n, k

      n = size(heights, 1) - m
      allocate (closed, source=heights(:n, :))
      do k = 1, m
         weight = sin(half_pi*(k - 1)/m)**2
         closed(k, :) = weight*heights(k, :) + (1 - weight)*heights(n + k, :)
      end do
   end subroutine blend

   !> Let each row fall to its mean at both ends.
   pure subroutine taper(m, heights)
      !> Number of samples that are lowered at each end.
      integer, intent(in) :: m
      !> In: heights, shape `(n, ny)`. Out: those of one period.
      real(dp), intent(inout) :: heights(:, :)
      real(dp) :: mean(size(heights, 2)), weight
      integer :: n, k

      n = size(heights, 1)
      mean = sum(heights, dim=1)/n
      do k = 1, m
         weight = sin(half_pi*(k - 0.5_dp)/m)**2
         heights(k, :) = mean + weight*(heights(k, :) - mean)
         heights(n + 1 - k, :) = mean + weight*(heights(n + 1 - k, :) - mean)
      end do
   end subroutine taper

end module adfric_shape_closing

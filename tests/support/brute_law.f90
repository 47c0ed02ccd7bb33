! SPDX-License-Identifier: GPL-3.0-or-later
!> A column under any law of attraction in small steps of time, of the first order. For tests only: it shares heights and law with
!> the solver, and nothing else. The gap goes from where it was to the first one that has its tension, in steps that are a small part of
!> the range.
module brute_law
   use adfric_base_kinds, only: dp
   use adfric_interface_attraction, only: attraction_t
   use adfric_foundation_stepping_path, only: column_path_t, height_at
   use stepping_cases, only: stepping_case_t
   implicit none (type, external)
   private
   public :: brute_law_t, settle_law

   !> What a period adds up to.
   type :: brute_law_t
      real(dp) :: load = 0, friction = 0
      !> Were the last two periods the same?
      logical :: is_steady = .false.
   end type brute_law_t

contains

   !> Follow a column over periods until they repeat.
   subroutine settle_law(trial, law, path, depth, n_steps, found)
      type(stepping_case_t), intent(in) :: trial
      type(attraction_t), intent(in) :: law
      !> Heights.
      type(column_path_t), intent(in) :: path
      real(dp), intent(in) :: depth
      integer, intent(in) :: n_steps
      type(brute_law_t), intent(out) :: found
      integer, parameter :: most_periods = 400
      real(dp), parameter :: same = 1.0e-8_dp
      real(dp) :: length(size(trial%times)), last(size(trial%times)), share(size(trial%times)), &
         & heights(0:n_steps), gap, pressure, glassy
      integer :: i, k

      do k = 0, n_steps
         heights(k) = depth + height_of(real(k, dp)/n_steps*path%n)
      end do
      share = 1 - exp(-1/(n_steps*trial%times))
      glassy = 1 + sum(trial%stiffness)
      length = -law%stress - 1
      gap = 0
      if (trial%is_approach) then
         length = max(depth, 0.0_dp) + 1.0e-3_dp
         gap = 10
      end if
      do i = 1, most_periods
         last = length
         found%load = 0
         found%friction = 0
         do k = 1, n_steps
            call move_gap(law, glassy, sum(trial%stiffness*length)/glassy - heights(k), gap)
            pressure = heights(k) + gap + sum(trial%stiffness*(heights(k) + gap - length))
            found%load = found%load + pressure/n_steps
            found%friction = found%friction + pressure*(heights(k) - heights(k - 1))
            length = length + share*(heights(k) + gap - length)
         end do
         found%is_steady = maxval(abs(length - last)) <= same
         if (found%is_steady) return
      end do

   contains

      !> Height at a number of pieces.
      real(dp) function height_of(passed)
         real(dp), intent(in) :: passed
         integer :: piece

         piece = min(int(passed) + 1, path%n)
         height_of = height_at(path, piece, passed - (piece - 1))
      end function height_of

   end subroutine settle_law

   !> The gap at which a column comes to rest from another one.
   subroutine move_gap(law, glassy, reach, gap)
      type(attraction_t), intent(in) :: law
      real(dp), intent(in) :: glassy
      !> Where the column would be if it were let go, from the heights.
      real(dp), intent(in) :: reach
      real(dp), intent(inout) :: gap
      real(dp) :: step, next, middle, direction
      integer :: k

      direction = sign(1.0_dp, reach - gap - law%tension(gap)/glassy)
      if (gap <= 0 .and. direction < 0) return
      step = 1.0e-3_dp*law%range
      do
         next = max(0.0_dp, gap + direction*step)
         if (direction*(next + law%tension(next)/glassy - reach) >= 0) exit
         gap = next
         if (gap <= 0) return
         step = min(1.3_dp*step, 0.01_dp*(law%range + gap))
      end do
      do k = 1, 60
         middle = (gap + next)/2
         if (direction*(middle + law%tension(middle)/glassy - reach) >= 0) then
            next = middle
         else
            gap = middle
         end if
      end do
   end subroutine move_gap

end module brute_law

! SPDX-License-Identifier: GPL-3.0-or-later
!> How much the surfaces of a contact part under less load, where the cells in contact stay so: the contact is a punch.
!>
!> With the stiffness A (`adfric_periodic_contact`) and the open cells O the gap grows by k for each unit of the mean pressure, where
!> A_OO k = 1, and k = 0 elsewhere. The compliance is the mean of k. With e = 1 - A k on O, what steps have left, the mean of k (1 + e) is
!> wrong by that of e A_OO^-1 e, since A is symmetric. Where A has no positive entries off its diagonal, A_OO^-1 >= 0, and that is at most the
!> square of the largest |e| times the compliance: half the digits of k are enough.
module adfric_periodic_punch
   use adfric_base_kinds, only: dp
   use adfric_periodic_cohesion, only: cohesion_t
   use adfric_periodic_gap_solver, only: extremes_t, gap_solver_t
   use adfric_periodic_maps, only: dot_of, sum_of
   use adfric_periodic_operator, only: periodic_operator_t
   implicit none (type, external)
   private
   public :: find_punch_compliance, finish_punch

   !> Steps that are never needed.
   integer, parameter :: max_iterations = 3000
   !> Part of e A_OO^-1 e that a step leaves, at most; it is about 0.07 (`adfric_periodic_levels`).
   real(dp), parameter :: slowest = 0.1_dp

contains

   !> Find the slope of the mean gap over the relief where the open cells stay so.
   subroutine find_punch_compliance(operator, gap_solver, is_open, tolerance, compliance, is_found)
      !> Operator of the cells, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator
      type(gap_solver_t), intent(inout) :: gap_solver
      logical, intent(in), contiguous :: is_open(:, :)
      !> Relative error that is allowed [-].
      real(dp), intent(in) :: tolerance
      !> Receives the compliance [unit of the gap over E*]; 0 in full contact, below 0 without contact.
      real(dp), intent(out) :: compliance
      logical, intent(out) :: is_found
      real(dp), allocatable :: gap(:, :), pressure(:, :)

      compliance = 0
      if (all(is_open)) compliance = -1
      is_found = all(is_open) .or. .not. any(is_open)
      if (is_found) return
      allocate (gap(size(is_open, 1), size(is_open, 2)))
      allocate (pressure, mold=gap)
      gap(:, :) = 0
      pressure(:, :) = -1
      call gap_solver%forget()
      call finish_punch(operator, gap_solver, is_open, tolerance, gap, pressure, compliance, is_found)
   end subroutine find_punch_compliance

   !> Take steps of the slope alone until it is found.
   subroutine finish_punch(operator, gap_solver, is_open, tolerance, gap, pressure, compliance, is_found)
      !> Operator of the cells, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator
      type(gap_solver_t), intent(inout) :: gap_solver
      logical, intent(in), contiguous :: is_open(:, :)
      !> Relative error that is allowed [-].
      real(dp), intent(in) :: tolerance
      !> In: k to begin from, 0 in closed cells, and A k - 1. Out: those that were found.
      real(dp), intent(inout), contiguous :: gap(:, :), pressure(:, :)
      !> Receives the compliance [unit of the gap over E*].
      real(dp), intent(out) :: compliance
      logical, intent(out) :: is_found
      type(cohesion_t), allocatable :: none
      type(extremes_t) :: extremes
      real(dp) :: mean_pressure, total, before
      logical :: is_stuck
      integer :: k

      mean_pressure = -1
      call gap_solver%set_region(operator, is_open, .false., .false., .false.)
      call gap_solver%advance(0.0_dp, gap, pressure, extremes)
      total = sum_of(gap) - dot_of(gap, pressure)
      is_found = extremes%remaining <= sqrt(tolerance)
      do k = 1, max_iterations
         if (is_found) exit
         call gap_solver%improve(operator, is_open, 0.0_dp, gap, pressure, mean_pressure, extremes, is_stuck, none)
         if (is_stuck) exit
         before = total
         total = sum_of(gap) - dot_of(gap, pressure)
         is_found = extremes%remaining <= sqrt(tolerance) .or. slowest*(total - before) <= (1 - slowest)*tolerance*total
      end do
      compliance = total/size(gap)
   end subroutine finish_punch

end module adfric_periodic_punch

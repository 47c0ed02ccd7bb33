! SPDX-License-Identifier: GPL-3.0-or-later
!> Proof that no state of a surface whose cells attract each other by a falling law lies between a bound and a state that was found.
!>
!> It asks that no entry of the stiffness A off its diagonal is above 0, and not that A is symmetric: the kernel of a solid with a memory may
!> have it, too. Let F = q + A (g - g0) + s(g), and x <= y two states between the bound and the one that was found, which is one of them;
!> d = y - x, and C the diagonal of the smallest chords from the found state towards the bound.
!>
!> - On the open cells O of y, F(y) = 0 and F(x) >= 0. So A d + C d <= 0 there, and d = 0 elsewhere.
!> - A w > 0 with some w > 0 on O makes the inverse of (A + C)_OO a matrix without entries below 0 (an M-matrix; Berman and Plemmons,
!>   Nonnegative Matrices in the Mathematical Sciences, 1979, chapter 6). So d <= 0, and both states are one.
!>
!> On the cells of a line entries at even distances are 0 at rest, and memory makes some of them a little larger than 0, those at odd
!> distances smaller. What varies little from cell to cell meets the sums of two neighbours, which have the sign of the kernel. So the order
!> is asked of these sums.
module adfric_periodic_ordered_rounds
   use adfric_base_kinds, only: dp
   use adfric_periodic_adhesive_proof, only: solve_open
   use adfric_periodic_attraction_cells, only: attraction_cells_t
   use adfric_periodic_cohesion, only: cohesion_t
   use adfric_periodic_contact, only: contact_state_t
   use adfric_periodic_gap_solver, only: gap_solver_t
   use adfric_periodic_operator, only: periodic_operator_t
   implicit none (type, external)
   private
   public :: has_order, is_extremal

   !> Entries of the stiffness that are round-off, over the one on the diagonal.
   real(dp), parameter :: round_off = 1.0e-13_dp
   !> What may be left of the system of the proof, over its right side.
   real(dp), parameter :: remains = 0.2_dp
   !> Shares that stay on one side of a bound by less do so: contacts in between are not exact.
   real(dp), parameter :: like_share = 1.0e-3_dp

contains

   !> Does the stiffness of a line order the states: is no sum of neighbouring entries off its diagonal above 0? Not asked of maps.
   logical function has_order(operator)
      !> Operator of the grid, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator
      real(dp), allocatable :: unit(:, :), column(:, :)

      has_order = operator%n_cells(2) == 1
      if (.not. has_order) return
      allocate (unit(operator%n_cells(1), 1), source=0.0_dp)
      allocate (column, mold=unit)
      unit(1, 1) = 1
      call operator%apply_stiffness(unit, column)
      associate (n => size(column, 1))
         if (n > 2) has_order = .not. maxval(column(2:n - 1, 1) + column(3:, 1)) > round_off*column(1, 1)
      end associate
   end function has_order

   !> Is a state the extremal one beyond a bound: on its side, with no other one between?
   logical function is_extremal(state, operator, gap_solver, is_adhered, bound)
      !> The state, by another law than Dugdale's.
      type(contact_state_t), intent(in) :: state
      type(periodic_operator_t), intent(inout) :: operator
      type(gap_solver_t), intent(inout) :: gap_solver
      !> Is the most adhered state wanted, so that the gaps of the bound are not larger? Else they are not smaller.
      logical, intent(in) :: is_adhered
      !> What rounds have come to, with the shares of its gap.
      type(contact_state_t), intent(in) :: bound
      type(attraction_cells_t) :: cells
      type(cohesion_t), allocatable :: law
      real(dp), allocatable :: load(:, :), path(:, :)
      logical, allocatable :: is_open(:, :)

      is_extremal = maxval(merge(1, -1, is_adhered)*(state%cohesion%share - bound%cohesion%share)) <= like_share
      if (.not. is_extremal) return
      is_open = state%is_open .or. bound%is_open .or. bound%gap > 0
      if (.not. any(is_open)) return
      allocate (law, source=state%cohesion)
      cells%law = law%law
      law%fall = -(law%stress/law%law%stress)*cells%smallest_chord(max(state%gap, 0.0_dp), max(bound%gap, 0.0_dp))
      law%is_linear = .true.
      allocate (load, path, mold=state%gap)
      load(:, :) = law%stress
      call solve_open(operator, gap_solver, is_open, load, remains*law%stress, path, law)
      is_extremal = minval(path, mask=is_open) > 0
   end function is_extremal

end module adfric_periodic_ordered_rounds

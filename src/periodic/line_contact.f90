! SPDX-License-Identifier: GPL-3.0-or-later
!> Contact of a line of cells with a solid some of whose waves have a stiffness with a real part below 0, as those of thin layers may
!> have whose surface shear moves.
!>
!> The steps of `adfric_periodic_gap_solver` need real parts above 0. Here the gap over the open region is found by elimination, and
!> regions are changed as in `adfric_periodic_contact`: open cells that overlap are closed, closed ones that pull are opened, all at
!> once, and one by one when that does not bring fewer wrong cells. There is no proof that this ends, nor that there is one contact.
module adfric_periodic_line_contact
   use adfric_base_kinds, only: dp
   use adfric_numerics_lapack, only: dgesv
   use adfric_periodic_contact, only: contact_state_t, residual_of
   use adfric_periodic_operator, only: periodic_operator_t
   implicit none (type, external)
   private
   public :: solve_line

   !> Changes of the region, and how many without fewer wrong cells before cells are changed one by one.
   integer, parameter :: most_rounds = 200, patience = 8
   !> Of gap and pressure in their scales, what is 0.
   real(dp), parameter :: round_off = 1.0e-12_dp

contains

   !> Solve from the open region in `state`, under a given load or at the penetration of a layer.
   subroutine solve_line(state, operator, tolerance)
      !> In: gap and open region to begin from. Out: the solution; `is_converged` tells whether it was found.
      type(contact_state_t), intent(inout) :: state
      !> Operator of this line, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator
      !> Largest residual that is allowed [-].
      real(dp), intent(in) :: tolerance
      real(dp), allocatable :: response(:, :), given(:, :)
      logical, allocatable :: is_wrong(:)
      integer :: fewest, waited, n_wrong
      logical :: is_regular

      if (.not. allocated(state%pressure)) allocate (state%pressure, mold=state%shape)
      allocate (response, given, mold=state%shape)
      state%gap(:, :) = 0
      state%gap(1, 1) = 1
      call operator%apply_stiffness(state%gap, response)
      state%gap(:, :) = 0
      call operator%apply_stiffness(-state%shape, given)
      given(:, :) = state%mean_pressure + given
      state%gap_scale = maxval(state%shape) - minval(state%shape)
      state%is_converged = .false.
      allocate (is_wrong(size(given, 1)))
      fewest = size(is_wrong) + 1
      waited = 0
      do while (state%n_rounds < most_rounds)
         if (operator%is_stopped()) exit
         if (all(state%is_open)) state%is_open(minloc(state%shape(:, 1), 1), 1) = .false.
         call find_gap(response(:, 1), given(:, 1), state%is_open(:, 1), state%gap(:, 1), is_regular)
         state%n_iterations = state%n_iterations + 1
         if (.not. is_regular) exit
         call operator%apply_stiffness(state%gap - state%shape, state%pressure)
         state%pressure(:, :) = state%mean_pressure + state%pressure
         if (.not. maxval(state%pressure) > 0) exit
         state%pressure_scale = maxval(state%pressure)
         is_wrong(:) = merge(state%gap(:, 1) < -round_off*state%gap_scale, state%pressure(:, 1) < -round_off*state%pressure_scale, &
            & state%is_open(:, 1))
         n_wrong = count(is_wrong)
         if (n_wrong == 0) exit
         waited = merge(0, waited + 1, n_wrong < fewest)
         fewest = min(fewest, n_wrong)
         if (waited > patience) is_wrong(:findloc(is_wrong, .true., 1, back=.true.) - 1) = .false.
         state%is_open(:, 1) = state%is_open(:, 1) .neqv. is_wrong
         state%n_rounds = state%n_rounds + 1
      end do
      state%is_converged = residual_of(state) <= tolerance
      state%mean_gap = sum(state%gap)/size(state%gap)
   end subroutine solve_line

   !> The gap of open cells, in which no pressure is left.
   subroutine find_gap(response, given, is_open, gap, is_regular)
      !> Pressures of a gap of 1 in the first cell, and those without a gap; shape `(n)`.
      real(dp), intent(in) :: response(:), given(:)
      !> Is the cell open? Shape `(n)`.
      logical, intent(in) :: is_open(:)
      !> The gap; shape `(n)`.
      real(dp), intent(inout) :: gap(:)
      !> Is there one gap?
      logical, intent(out) :: is_regular
      real(dp), allocatable :: matrix(:, :), right(:, :)
      integer, allocatable :: open_cells(:), exchanged(:)
      integer :: i, k, n, info

      open_cells = pack([(i, i=1, size(is_open))], is_open)
      n = size(open_cells)
      gap(:) = 0
      is_regular = .true.
      if (n == 0) return
      allocate (matrix(n, n), right(n, 1), exchanged(n))
      do k = 1, n
         matrix(:, k) = response(modulo(open_cells - open_cells(k), size(response)) + 1)
      end do
      right(:, 1) = -given(open_cells)
      call dgesv(n, 1, matrix, n, exchanged, right, n, info)
      is_regular = info == 0
      if (is_regular) gap(open_cells) = right(:, 1)
   end subroutine find_gap

end module adfric_periodic_line_contact

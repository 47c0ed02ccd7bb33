! SPDX-License-Identifier: GPL-3.0-or-later
!> Adhesive contact of a periodic surface under a load, on one grid: the most or the least adhered of its states.
!>
!> With the shares t of the cells within the range of adhesion (`adfric_periodic_cohesion`) the contact has one solution G(t)
!> (`adfric_periodic_contact`), and a state is a gap g = R(g) = G(t(g)). Rounds g -> R(g) from shares that are not below those of a
!> state fall to the most adhered state below them; from shares that are not above, they rise to the least adhered one. On lines that
!> is proved, on maps it is not (docs/theory/periodic_adhesion.md, Proofs).
!>
!> - Between rounds, cells that go slowly go on in steps of their own, which pass no state (`adfric_periodic_adhesive_relaxation`).
!> - Newton's method is faster next to the state, but may pass one. Its state is taken only where none is passed from the gap of the
!>   rounds (`adfric_periodic_adhesive_proof`), or where rounds have come to rest.
!> - Contacts in between are solved to a part of the change that led to them. Steps in single cells keep off by what they leave.
!>
!> Where mean(p) = q + sigma0 mean(t) is not above 0 no contact carries the load: there is no state below these shares.
module adfric_periodic_adhesive_contact
   use adfric_base_kinds, only: dp
   use adfric_periodic_adhesive_proof, only: find_path, is_alone
   use adfric_periodic_adhesive_relaxation, only: relaxation_t, new_relaxation, relax
   use adfric_periodic_contact, only: contact_state_t, solve_contact, start_contact
   use adfric_periodic_gap_solver, only: gap_solver_t
   use adfric_periodic_maps, only: is_shared, largest_difference, sum_of
   use adfric_periodic_operator, only: periodic_operator_t
   implicit none (type, external)
   private
   public :: solve_adhesive_contact, find_state, solve_again, solve_with_share, widen_share

   !> Rounds from the bound, at most.
   integer, parameter :: most_rounds = 2000
   !> Largest change of a share that ends the rounds, and one from which on Newton's method is tried.
   real(dp), parameter :: resting_share = 1.0e-7_dp, small_change = 2.0e-3_dp
   !> Residual of the contacts in between: in units of the change of tension that led to it, the largest one, the least one, and that of
   !> contacts whose pressure is found anew.
   real(dp), parameter :: part_of_change = 0.02_dp, first_tolerance = 1.0e-3_dp, least_tolerance = 1.0e-9_dp
   real(dp), parameter :: passing_tolerance = 1.0e-5_dp
   !> Change of a share over that of the round before from which on a cell is slow, and the least of these changes: so large, or that part
   !> of the largest.
   real(dp), parameter :: slow = 0.5_dp, slow_share = 0.02_dp, part_of_largest = 0.3_dp
   !> Cells by which the zones of a coarser grid may be too narrow or too wide on the finer one.
   integer, parameter :: cells_beside = 1
   !> Shares that stay on one side of a bound by less do so: contacts in between are not exact.
   real(dp), parameter :: like_share = 1.0e-3_dp
   !> Largest difference of a share from the state's at which a proof is tried, and rounds from one to the next.
   real(dp), parameter :: near_share = 0.5_dp
   integer, parameter :: proof_after = 2

contains

   !> Solve under the load in `state`.
   subroutine solve_adhesive_contact(state, operator, gap_solver, tolerance, is_adhered, bound, has_guess, has_contact)
      !> In: the shape, the load, the law of adhesion, and with `has_guess` gap, shares and open region near the state. Out: the state.
      type(contact_state_t), intent(inout) :: state
      !> Operator of this grid, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator
      type(gap_solver_t), intent(inout) :: gap_solver
      !> Largest residual that is allowed [-], see `residual_of`.
      real(dp), intent(in) :: tolerance
      !> Is the most adhered state wanted? Else the least adhered one is.
      logical, intent(in) :: is_adhered
      !> Shares that are not smaller than those of the most adhered state that is wanted, or not larger than those of the least.
      real(dp), intent(in), contiguous :: bound(:, :)
      !> Is there a gap near the state?
      logical, intent(in) :: has_guess
      !> Receives whether there is a state with contact; else `state` has no meaning.
      logical, intent(out) :: has_contact
      type(contact_state_t) :: found
      type(relaxation_t) :: relaxation
      real(dp), allocatable :: share(:, :), step(:, :), path(:, :)
      real(dp) :: change, change_before
      logical, allocatable :: is_open(:, :)
      logical :: is_certain, has_found, has_rested
      integer :: k, next_try, next_proof

      has_contact = .true.
      has_found = .false.
      is_certain = .false.
      if (has_guess) then
         found = state
         call find_state(found, operator, gap_solver, tolerance, has_found)
         if (has_found) has_found = is_bound(found%cohesion%share, is_adhered, bound)
      end if
      allocate (share, source=bound)
      allocate (step, mold=bound)
      ! in the first round cells are slow whose share changes by more than half
      step(:, :) = 1
      call new_relaxation(relaxation, operator)
      next_try = 2
      next_proof = 1
      change = 0
      do k = 1, most_rounds
         change_before = change
         call solve_with_share(state, operator, gap_solver, share, change, has_contact, .true.)
         if (.not. has_contact) return
         if (operator%is_stopped()) then
            found = state
            exit
         end if
         if (has_found) has_found = is_bound(found%cohesion%share, is_adhered, share)
         call go_on(state, relaxation, is_adhered, share, step, change)
         if (has_found .and. k >= next_proof) then
            if (largest_difference(found%cohesion%share, share) <= near_share) then
               next_proof = k + proof_after
               if (.not. allocated(path)) then
                  ! what is open now covers what later rounds have open
                  is_open = found%is_open .or. (state%is_open .and. .not. is_adhered)
                  call find_path(found, is_open, operator, gap_solver, path)
               end if
               if (allocated(path)) is_certain = is_alone(found, path, is_open, operator, gap_solver, is_adhered, state%gap)
               if (is_certain) exit
            end if
         end if
         ! a contact that was solved to no more than its change had to be may only seem to rest
         has_rested = change <= resting_share .and. change_before <= small_change
         if (has_rested .or. (k >= next_try .and. .not. has_found .and. change <= small_change)) then
            next_try = k + max(2, k/6)
            found = state
            if (allocated(path)) deallocate (path)
            call find_state(found, operator, gap_solver, tolerance, has_found)
            is_certain = has_found .and. has_rested
            if (is_certain) is_certain = is_bound(found%cohesion%share, is_adhered, share)
         end if
         if (has_rested) exit
      end do
      state = found
      state%is_converged = is_certain
   end subroutine solve_adhesive_contact

   !> Find the shares of a round's contact, and go on from it in single cells.
   subroutine go_on(state, relaxation, is_adhered, share, step, change)
      !> In: the contact with given shares. Out: a gap that is nearer to the state, with its shares and open region.
      type(contact_state_t), intent(inout) :: state
      type(relaxation_t), intent(in) :: relaxation
      logical, intent(in) :: is_adhered
      !> In: the given shares. Out: those of the new gap.
      real(dp), intent(inout), contiguous :: share(:, :)
      !> In: by how much the round before changed the shares. Out: by how much this one did; shape of the cells.
      real(dp), intent(inout), contiguous :: step(:, :)
      !> Receives the largest of these changes.
      real(dp), intent(out) :: change
      logical, allocatable :: is_slow(:, :)
      real(dp) :: rows(size(share, 2)), margin, least
      integer :: j
      logical :: goes_on

      ! a pressure below 0 makes gaps too small, one above 0 too large: on one side that is safe
      !$omp parallel do if(is_shared(size(share))) default(none) shared(state, is_adhered, rows) private(j)
      do j = 1, size(share, 2)
         if (is_adhered) then
            rows(j) = maxval(state%pressure(:, j), mask=state%is_open(:, j))
         else
            rows(j) = -minval(state%pressure(:, j))
         end if
      end do
      !$omp end parallel do
      margin = max(0.0_dp, maxval(rows))
      call state%cohesion%set_share(state%gap)
      change = largest_difference(state%cohesion%share, share)
      least = min(part_of_largest*change, slow_share)
      allocate (is_slow, mold=state%is_open)
      goes_on = change > resting_share
      !$omp parallel do if(is_shared(size(share))) default(none) shared(state, share, step, is_slow, goes_on, least) private(j)
      do j = 1, size(share, 2)
         is_slow(:, j) = abs(state%cohesion%share(:, j) - share(:, j)) > max(slow*step(:, j), least)
         step(:, j) = abs(state%cohesion%share(:, j) - share(:, j))
         if (goes_on) state%pressure(:, j) = state%pressure(:, j) &
            & + state%cohesion%stress*(state%cohesion%share(:, j) - share(:, j))
      end do
      !$omp end parallel do
      if (goes_on) call relax(relaxation, is_adhered, margin, is_slow, state%cohesion, state%gap, state%pressure)
      !$omp parallel do if(is_shared(size(share))) default(none) shared(state, share, is_adhered, goes_on) private(j)
      do j = 1, size(share, 2)
         share(:, j) = state%cohesion%share(:, j)
         if (.not. goes_on) cycle
         if (is_adhered) then
            state%is_open(:, j) = state%is_open(:, j) .or. state%gap(:, j) > 0
         else
            state%is_open(:, j) = state%is_open(:, j) .and. state%gap(:, j) > 0
         end if
      end do
      !$omp end parallel do
   end subroutine go_on

   !> Do shares stay on one side of a bound?
   pure logical function is_bound(share, is_adhered, bound)
      !> The shares.
      real(dp), intent(in), contiguous :: share(:, :)
      logical, intent(in) :: is_adhered
      !> Shares of the bound.
      real(dp), intent(in), contiguous :: bound(:, :)

      is_bound = maxval(merge(1, -1, is_adhered)*(share - bound)) <= like_share
   end function is_bound

   !> Solve the contact with given shares.
   subroutine solve_with_share(state, operator, gap_solver, share, change, has_contact, is_passing)
      !> In: gap and open region of the round before, if there was one. Out: the contact.
      type(contact_state_t), intent(inout) :: state
      type(periodic_operator_t), intent(inout) :: operator
      type(gap_solver_t), intent(inout) :: gap_solver
      !> Shares of the cells.
      real(dp), intent(in), contiguous :: share(:, :)
      !> By how much they differ from those of the contact before.
      real(dp), intent(in) :: change
      !> Receives whether the load can be carried; at the penetration of a layer there always is a state.
      logical, intent(out) :: has_contact
      !> Is it one of many, whose pressure need not be found anew at its end? Its residual then falls with the change without end.
      logical, intent(in) :: is_passing
      real(dp) :: aim

      call state%cohesion%hold()
      state%cohesion%share = share
      has_contact = state%resists_mean
      if (.not. has_contact) has_contact = state%mean_pressure + state%cohesion%stress*(sum_of(share)/size(share)) > 0
      if (.not. has_contact) return
      if (.not. allocated(state%gap)) call start_contact(state, operator)
      aim = min(part_of_change*change*state%cohesion%stress/state%pressure_scale, first_tolerance)
      call solve_again(state, operator, gap_solver, max(merge(least_tolerance, passing_tolerance, is_passing), aim), is_passing)
   end subroutine solve_with_share

   !> Solve from the gap and the open region of a state, with iterations of its own.
   subroutine solve_again(state, operator, gap_solver, tolerance, is_passing)
      !> In: where to begin. Out: the contact; iterations are added to those of before.
      type(contact_state_t), intent(inout) :: state
      type(periodic_operator_t), intent(inout) :: operator
      type(gap_solver_t), intent(inout) :: gap_solver
      real(dp), intent(in) :: tolerance
      !> Is it one before another? Not given: no.
      logical, intent(in), optional :: is_passing
      integer :: n_before

      n_before = state%n_iterations
      state%n_iterations = 0
      state%n_rounds = 0
      call solve_contact(state, operator, gap_solver, tolerance, is_passing)
      state%n_iterations = state%n_iterations + n_before
   end subroutine solve_again

   !> Newton's method from a guess.
   subroutine find_state(state, operator, gap_solver, tolerance, has_found)
      !> In: gap and open region to begin from. Out: a state with its shares and their slopes, or where Newton's method went.
      type(contact_state_t), intent(inout) :: state
      type(periodic_operator_t), intent(inout) :: operator
      type(gap_solver_t), intent(inout) :: gap_solver
      real(dp), intent(in) :: tolerance
      !> Receives whether it is a state, to the tolerance.
      logical, intent(out) :: has_found

      state%cohesion%is_linear = .true.
      call solve_again(state, operator, gap_solver, tolerance)
      has_found = state%is_converged
   end subroutine find_state

   !> Bounds of shares that are known but for a few cells: 1 in cells that the zone may reach, 0 in others.
   pure subroutine widen_share(share, is_quarter, is_wider, bound)
      !> The shares; shape of the cells.
      real(dp), intent(in), contiguous :: share(:, :)
      !> Is the surface even about 0 and half a period in x and in y, and only that quarter given?
      logical, intent(in) :: is_quarter
      !> Shall the zone be wider? Else narrower.
      logical, intent(in) :: is_wider
      !> Receives 1 or 0; shape of the cells.
      real(dp), intent(out), contiguous :: bound(:, :)
      integer :: i, j, n(2)

      n = shape(share)
      bound(:, :) = merge(0, 1, is_wider)
      ! what is in grows, or what is out
      do j = 1, n(2)
         do i = 1, n(1)
            if (merge(share(i, j) > 0, share(i, j) < 1, is_wider)) bound(beside(i, n(1)), beside(j, n(2))) = merge(1, 0, is_wider)
         end do
      end do

   contains

      !> A cell and those beside it, in a period or in a mirror.
      pure function beside(k, n_cells) result(cells)
         !> The cell, and the number of cells.
         integer, intent(in) :: k, n_cells
         integer :: cells(2*cells_beside + 1)
         integer :: i

         cells = [(i, i=k - cells_beside, k + cells_beside)]
         if (is_quarter) then
            cells = max(1, min(cells, n_cells))
         else
            cells = modulo(cells - 1, n_cells) + 1
         end if
      end function beside

   end subroutine widen_share

end module adfric_periodic_adhesive_contact

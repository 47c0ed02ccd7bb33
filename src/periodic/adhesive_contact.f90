! SPDX-License-Identifier: GPL-3.0-or-later
!> Adhesive contact of a periodic surface under a load, on one grid: the most or the least adhered of its states.
!>
!> With the shares t of the cells within the range of adhesion (`adfric_periodic_cohesion`) the contact has one solution G(t)
!> (`adfric_periodic_contact`), and a state is a gap g = R(g) = G(t(g)). Rounds g -> R(g) from shares that are not below those of a
!> state fall to the most adhered state below them; from shares that are not above, they rise to the least adhered one. On lines that
!> is proved, on maps it is not (docs/theory/periodic_adhesion.md, Proofs).
!>
!> - Newton's method is faster than rounds, but may pass a state. Its state g is taken only where none is passed from a gap g -+ x,
!>   x >= 0, whose shares bound the wanted state: on each piece of that distance y = sigma0 A_OO^-1 m is below x, with the largest
!>   slope m of the shares on the piece (the same page, Newton's method).
!> - x is what a round has changed, or the change of g with the load, (A - sigma0 dt/dg)_OO^-1 1, so far that zones move by a cell.
!>   A state under more load is more adhered, so that it bounds the wanted one.
!> - Shares of a coarser grid, a cell wider or narrower, are a bound where one round changes them to no more than they are; else they
!>   are joined with what the round made of them, until it is so.
!>
!> Where mean(p) = q + sigma0 mean(t) is not above 0 no contact carries the load: there is no state below these shares.
module adfric_periodic_adhesive_contact
   use adfric_base_kinds, only: dp
   use adfric_periodic_cohesion, only: cohesion_t
   use adfric_periodic_contact, only: contact_state_t, solve_contact, start_contact
   use adfric_periodic_gap_solver, only: gap_solver_t, extremes_t
   use adfric_periodic_maps, only: sum_of
   use adfric_periodic_operator, only: periodic_operator_t
   implicit none (type, external)
   private
   public :: solve_adhesive_contact, find_state, solve_again, solve_with_share, widen_share

   !> Rounds from the bound, at most.
   integer, parameter :: most_rounds = 2000
   !> Largest change of a share that ends the rounds, and residual of the contacts on the way.
   real(dp), parameter :: resting_share = 1.0e-7_dp, passing_tolerance = 1.0e-5_dp
   !> Cells by which the zones of a coarser grid may be too narrow or too wide on the finer one.
   integer, parameter :: cells_beside = 1
   !> Shares that stay on one side of a bound by less do so: contacts on the way are not exact.
   real(dp), parameter :: like_share = 1.0e-3_dp
   !> Residual of a contact on the way, in units of the change of tension that led to it.
   real(dp), parameter :: part_of_change = 0.02_dp
   !> Pieces of the way s on which slopes are found, and parts of each.
   real(dp), parameter :: pieces(*) = [1.0_dp, 0.85_dp, 0.72_dp, 0.6_dp, 0.5_dp, 0.4_dp, 0.3_dp, 0.2_dp]
   integer, parameter :: n_pieces = size(pieces), parts_of_piece = 20
   !> Part of the last piece from which on slopes are those next to the state.
   real(dp), parameter :: last_part = 0.5_dp
   !> What a bound is compared with is smaller by that: linear systems are solved to a part of it.
   real(dp), parameter :: safe_share = 0.99_dp, linear_tolerance = 2.0e-3_dp
   integer, parameter :: most_steps = 200

contains

   !> Solve under the load in `state`.
   subroutine solve_adhesive_contact(state, operator, gap_solver, tolerance, is_adhered, bound, is_sure, has_guess, has_contact)
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
      !> Is that certain? Else it comes from a coarser grid, as gap and shares in `state` do.
      logical, intent(in) :: is_sure
      !> Is there a gap near the state?
      logical, intent(in) :: has_guess
      !> Receives whether there is a state with contact; else `state` has no meaning.
      logical, intent(out) :: has_contact
      type(contact_state_t) :: found
      real(dp), allocatable :: share(:, :)
      real(dp) :: change
      logical :: is_certain, has_found, is_widening
      integer :: k, next_try, next_proof

      has_contact = .true.
      has_found = .false.
      is_certain = .false.
      if (has_guess) then
         found = state
         call find_state(found, operator, gap_solver, tolerance, has_found)
         if (has_found) has_found = is_bound(found%cohesion%share, is_adhered, bound)
         if (has_found .and. .not. is_sure) &
            & call prove_alone(found, operator, gap_solver, is_adhered, state%cohesion%share, is_certain)
         if (is_certain) then
            state = found
            state%is_converged = .true.
            return
         end if
      end if
      allocate (share, source=bound)
      next_try = 2
      next_proof = 1
      change = 0
      is_widening = .not. is_sure
      do k = 1, most_rounds
         call solve_with_share(state, operator, gap_solver, share, change, has_contact)
         if (.not. has_contact) return
         if (operator%is_stopped()) then
            found = state
            exit
         end if
         if (has_found) has_found = is_bound(found%cohesion%share, is_adhered, share)
         if (has_found .and. k >= next_proof .and. .not. is_widening) then
            next_proof = k + 1 + k/3
            is_certain = is_next_to(found, operator, gap_solver, merge(found%is_open, state%is_open, is_adhered), is_adhered, &
               & state%gap)
            if (is_certain) exit
         end if
         call state%cohesion%set_share(state%gap)
         if (is_widening) is_widening = .not. is_bound(state%cohesion%share, is_adhered, share)
         if (is_widening) call join_share(state%cohesion%share, share, is_adhered)
         change = maxval(abs(state%cohesion%share - share))
         share(:, :) = state%cohesion%share
         if (change <= resting_share .or. (k >= next_try .and. .not. has_found)) then
            next_try = k + max(3, k/4)
            found = state
            call find_state(found, operator, gap_solver, tolerance, has_found)
            is_certain = has_found .and. change <= resting_share .and. .not. is_widening
            if (is_certain) is_certain = is_bound(found%cohesion%share, is_adhered, share)
         end if
         if (change <= resting_share) exit
      end do
      state = found
      state%is_converged = is_certain
   end subroutine solve_adhesive_contact

   !> The larger of two shares in each cell, or the smaller.
   pure subroutine join_share(share, other, is_adhered)
      !> In: shares. Out: those that bound them and the others.
      real(dp), intent(inout), contiguous :: share(:, :)
      !> The others; shape of the cells.
      real(dp), intent(in), contiguous :: other(:, :)
      logical, intent(in) :: is_adhered

      if (is_adhered) then
         share(:, :) = max(share, other)
      else
         share(:, :) = min(share, other)
      end if
   end subroutine join_share

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
   subroutine solve_with_share(state, operator, gap_solver, share, change, has_contact)
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

      call state%cohesion%hold()
      state%cohesion%share = share
      has_contact = state%resists_mean
      if (.not. has_contact) has_contact = state%mean_pressure + state%cohesion%stress*(sum_of(share)/size(share)) > 0
      if (.not. has_contact) return
      if (.not. allocated(state%gap)) call start_contact(state, operator)
      call solve_again(state, operator, gap_solver, &
         & max(passing_tolerance, min(part_of_change*change*state%cohesion%stress/state%pressure_scale, 1.0e-3_dp)))
   end subroutine solve_with_share

   !> Solve from the gap and the open region of a state, with iterations of its own.
   subroutine solve_again(state, operator, gap_solver, tolerance)
      !> In: where to begin. Out: the contact; iterations are added to those of before.
      type(contact_state_t), intent(inout) :: state
      type(periodic_operator_t), intent(inout) :: operator
      type(gap_solver_t), intent(inout) :: gap_solver
      real(dp), intent(in) :: tolerance
      integer :: n_before

      n_before = state%n_iterations
      state%n_iterations = 0
      state%n_rounds = 0
      call solve_contact(state, operator, gap_solver, tolerance)
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

   !> Is a state alone among those that are more, or less, adhered by a few cells? The way there is that of a change of the load: a
   !> state under more load is more adhered, so that it is no state under this one, nor are those on the way to it.
   subroutine prove_alone(state, operator, gap_solver, is_adhered, guess, is_certain)
      type(contact_state_t), intent(in) :: state
      type(periodic_operator_t), intent(inout) :: operator
      type(gap_solver_t), intent(inout) :: gap_solver
      logical, intent(in) :: is_adhered
      !> Shares that the way has to reach: those of the coarser grid.
      real(dp), intent(in), contiguous :: guess(:, :)
      !> Receives whether it is alone.
      logical, intent(out) :: is_certain
      type(contact_state_t) :: far
      real(dp), allocatable, dimension(:, :) :: path, load
      real(dp) :: lost
      logical :: has_contact

      associate (law => state%cohesion)
         is_certain = law%n_triangles == 0 .and. .not. maxval(abs(guess - law%share)) > like_share
         if (law%n_triangles == 0) return
         allocate (path, load, mold=state%gap)
         load(:, :) = law%stress
         call solve_open(operator, gap_solver, state%is_open, load, path, state%cohesion)
         if (minval(path) < 0) return
         load(:, :) = 0
         call law%subtract_slope(path, load, lost)
         ! nothing that the edge passes moves
         if (.not. sum(abs(load)) > 0) return
         path(:, :) = merge(-1, 1, is_adhered)*path*(cells_beside*law%stress*law%n_squares/sum(abs(load)))
      end associate
      far = state
      call far%cohesion%set_share(state%gap + path)
      if (.not. is_bound(guess, is_adhered, far%cohesion%share)) return
      if (is_adhered) then
         is_certain = is_next_to(state, operator, gap_solver, state%is_open, is_adhered, state%gap + path)
      else
         load(:, :) = far%cohesion%share
         call solve_with_share(far, operator, gap_solver, load, 0.0_dp, has_contact)
         if (has_contact) is_certain = is_next_to(state, operator, gap_solver, far%is_open, is_adhered, state%gap + path)
      end if
   end subroutine prove_alone

   !> Is there no other state on the way from the bound to a state?
   logical function is_next_to(state, operator, gap_solver, is_open, is_adhered, far)
      type(contact_state_t), intent(in) :: state
      type(periodic_operator_t), intent(inout) :: operator
      type(gap_solver_t), intent(inout) :: gap_solver
      !> Open cells of the state, or of the contact with the shares of the bound, where that has more of them.
      logical, intent(in), contiguous :: is_open(:, :)
      logical, intent(in) :: is_adhered
      !> Gap of the contact with the shares of the bound.
      real(dp), intent(in), contiguous :: far(:, :)
      type(cohesion_t) :: law
      type(cohesion_t), allocatable :: none
      real(dp), allocatable :: path(:, :), next(:, :), slope(:, :)
      integer :: k

      law = state%cohesion
      allocate (path, next, slope, mold=far)
      path(:, :) = abs(far - state%gap)
      is_next_to = .not. maxval(path) > 0
      if (is_next_to) return
      call law%set_band(min(far, state%gap), max(far, state%gap))
      do k = 1, n_pieces
         call find_slope(law, state, merge(-1, 1, is_adhered)*path, k, slope)
         call solve_open(operator, gap_solver, is_open, law%stress*slope, next, none)
         is_next_to = all(next <= safe_share*path .or. .not. slope > 0)
         if (.not. is_next_to) return
      end do
   end function is_next_to

   !> The largest slopes of the shares from a state to positions of a piece of the path.
   subroutine find_slope(law, state, path, piece, slope)
      !> The law with its slopes at the state, and the squares on the way.
      type(cohesion_t), intent(in) :: law
      type(contact_state_t), intent(in) :: state
      !> Change of the gap, of one sign.
      real(dp), intent(in), contiguous :: path(:, :)
      !> Number of the piece; the last one ends at the state.
      integer, intent(in) :: piece
      !> Receives the largest change of the share over the part of the way, >= 0.
      real(dp), intent(out), contiguous :: slope(:, :)
      real(dp) :: part, ratio, product
      real(dp), allocatable, dimension(:, :) :: gap, here, there
      integer :: k

      allocate (gap, source=state%gap)
      allocate (here, there, mold=gap)
      call law%get_band_share(gap, here)
      slope(:, :) = 0
      ratio = last_part**(1.0_dp/parts_of_piece)
      if (piece < n_pieces) ratio = (pieces(min(piece + 1, n_pieces))/pieces(piece))**(1.0_dp/parts_of_piece)
      if (piece == n_pieces) call law%subtract_slope(path, slope, product)
      slope(:, :) = abs(slope)/law%stress
      ! shares change one way, so that between two parts of the way the change is not above that of the longer one
      part = pieces(piece)
      do k = 1, parts_of_piece
         gap(:, :) = state%gap + part*path
         call law%get_band_share(gap, there)
         part = ratio*part
         slope(:, :) = max(slope, abs(there - here)/part)
      end do
   end subroutine find_slope

   !> Solve A_OO x = b over given open cells. Where the slopes of adhesion leave no positive A, x is below 0 somewhere.
   subroutine solve_open(operator, gap_solver, is_open, load, x, cohesion)
      type(periodic_operator_t), intent(inout) :: operator
      type(gap_solver_t), intent(inout) :: gap_solver
      !> The open cells.
      logical, intent(in), contiguous :: is_open(:, :)
      !> b [E*].
      real(dp), intent(in), contiguous :: load(:, :)
      !> Receives x, 0 in closed cells.
      real(dp), intent(out), contiguous :: x(:, :)
      !> Adhesion whose slopes are taken from A; not allocated: none.
      type(cohesion_t), allocatable, intent(in) :: cohesion
      type(extremes_t) :: extremes
      real(dp), allocatable :: pressure(:, :)
      real(dp) :: mean_pressure, largest
      logical :: is_stuck
      integer :: k

      x(:, :) = 0
      allocate (pressure, source=-load)
      mean_pressure = 0
      largest = maxval(load)
      call gap_solver%forget()
      call gap_solver%set_region(operator, is_open, .false., .false., .false.)
      do k = 1, most_steps
         if (operator%is_stopped()) exit
         call gap_solver%improve(operator, is_open, 0.0_dp, x, pressure, mean_pressure, extremes, is_stuck, cohesion)
         if (is_stuck .or. extremes%remaining <= linear_tolerance*largest) exit
      end do
      if (allocated(cohesion) .and. is_stuck .and. extremes%remaining > linear_tolerance*largest) x(:, :) = -1
   end subroutine solve_open

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

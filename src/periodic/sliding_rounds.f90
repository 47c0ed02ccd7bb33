! SPDX-License-Identifier: GPL-3.0-or-later
!> Adhesive contact of a periodic surface that slides steadily over a viscoelastic solid, under a load, on one grid.
!>
!> With the shares t of the cells within the range of adhesion (`adfric_periodic_cohesion`) the contact has one solution G(t), for every
!> solid and velocity: the symmetric part of the stiffness is positive definite. A state is a gap g = G(t(g)). Rounds of shares from
!> none, or from all, are what slow loading, or unloading, does while the body slides.
!>
!> Where the stiffness has no positive entries off its diagonal, gaps fall when shares rise, and rounds end in the least, or the most,
!> adhered state; none is passed (`adfric_periodic_adhesive_contact`). A viscoelastic solid has that only if it relaxes little, or over
!> a broad spectrum (`adfric_solid_order_margin`). Else nothing says that rounds end, and two ends need not bound all states. So:
!>
!> - All in range from the start is certain for every solid: the contact without adhesion at a load that is larger by the tension, if
!>   its largest gap is in range.
!> - Newton's method is taken only where rounds close in, and where its state lies where they would end: with the changes c and c r of
!>   two rounds, within a few c r/(1 - r).
!> - Shares that all move to one side pass on slowly where a state has just been lost, and need many rounds. Only where some move back
!>   and the change does not fall any more, rounds go half the distance. Those that have not ended after the last one are no answer.
!> - Another law than Dugdale's has a tension for each gap. Where the stiffness of these cells has the order, Newton's state is taken only if
!>   no other one lies between it and the gap of the rounds (`adfric_periodic_ordered_rounds`), and rounds go on until then.
module adfric_periodic_sliding_rounds
   use adfric_base_kinds, only: dp
   use adfric_periodic_adhesive_contact, only: find_state, solve_again, solve_with_share
   use adfric_periodic_contact, only: contact_state_t
   use adfric_periodic_gap_solver, only: gap_solver_t
   use adfric_periodic_maps, only: largest_difference
   use adfric_periodic_operator, only: periodic_operator_t
   use adfric_periodic_ordered_rounds, only: has_order, is_extremal
   implicit none (type, external)
   private
   public :: solve_by_rounds

   !> Rounds from the bound, at most.
   integer, parameter :: most_rounds = 2000
   !> Rounds without a smaller change after which those that move shares up and down go half the distance.
   integer, parameter :: patience = 12
   !> Largest change of a share that ends the rounds.
   real(dp), parameter :: resting_share = 1.0e-5_dp
   !> Change of the shares below which Newton's method is tried, and how far from where rounds would end its state may lie, in units
   !> of what they have left.
   real(dp), parameter :: near = 0.2_dp, nearby = 3
   !> Moves back that count, in units of the largest move.
   real(dp), parameter :: part_that_counts = 0.05_dp
   !> Rates at which rounds close in: at the least one that is reckoned with, and at the largest one that counts as closing in.
   real(dp), parameter :: least_rate = 0.5_dp, largest_rate = 0.95_dp

contains

   !> Solve under the load in `state`.
   subroutine solve_by_rounds(state, operator, gap_solver, tolerance, is_adhered, bound, has_contact)
      !> In: the shape, the load and the law of adhesion, and gap and open region to begin from, if there are any. Out: the state.
      type(contact_state_t), intent(inout) :: state
      !> Operator of this grid, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator
      type(gap_solver_t), intent(inout) :: gap_solver
      !> Largest residual that is allowed [-], see `residual_of`.
      real(dp), intent(in) :: tolerance
      !> Is the most adhered state wanted? Else the least adhered one is.
      logical, intent(in) :: is_adhered
      !> Shares of the first round.
      real(dp), intent(in), contiguous :: bound(:, :)
      !> Receives whether there is a state with contact; else `state` has no meaning.
      logical, intent(out) :: has_contact
      type(contact_state_t) :: found
      real(dp), allocatable :: share(:, :)
      real(dp) :: change, before, smallest, rate
      integer :: k, next_try, since_smallest
      logical :: has_found, is_ordered, has_rested

      allocate (share, source=bound)
      is_ordered = .false.
      if (allocated(state%cohesion%law)) is_ordered = has_order(operator)
      change = 0
      before = huge(before)
      smallest = huge(smallest)
      since_smallest = 0
      next_try = 2
      has_found = .false.
      do k = 1, most_rounds
         call solve_with_share(state, operator, gap_solver, share, change, has_contact, .false.)
         if (.not. has_contact) return
         if (operator%is_stopped()) exit
         call state%cohesion%set_share(state%gap)
         change = largest_difference(state%cohesion%share, share)
         rate = least_rate
         if (before > 0) rate = max(least_rate, change/before)
         has_rested = change <= resting_share .and. .not. is_ordered
         if (has_rested .or. (k >= next_try .and. change <= near .and. (rate <= largest_rate .or. is_ordered))) then
            next_try = k + max(2, k/4)
            found = state
            call find_state(found, operator, gap_solver, tolerance, has_found)
            if (has_found .and. is_ordered) then
               has_found = is_extremal(found, operator, gap_solver, is_adhered, state)
            else if (has_found) then
               has_found = largest_difference(found%cohesion%share, state%cohesion%share) &
                  & <= nearby*(max(change, resting_share)*rate/(1 - min(rate, largest_rate)) + resting_share)
            end if
            if (has_found .or. has_rested) exit
         end if
         before = change
         since_smallest = since_smallest + 1
         if (change < smallest) then
            smallest = change
            since_smallest = 0
         end if
         if (since_smallest >= patience .and. moves_up_and_down(state%cohesion%share, share)) then
            share(:, :) = (share + state%cohesion%share)/2
         else
            share(:, :) = state%cohesion%share
         end if
      end do
      if (has_found) then
         state = found
      else if (change <= resting_share .and. .not. is_ordered) then
         ! no Newton's method, but the shares rest
         call solve_again(state, operator, gap_solver, tolerance)
      else
         state%is_converged = .false.
      end if
   end subroutine solve_by_rounds

   !> Do some shares rise while others fall?
   pure logical function moves_up_and_down(share, before)
      !> Shares of a round and of the one before.
      real(dp), intent(in), contiguous :: share(:, :), before(:, :)

      moves_up_and_down = min(maxval(share - before), maxval(before - share)) > part_that_counts*maxval(abs(share - before))
   end function moves_up_and_down

end module adfric_periodic_sliding_rounds

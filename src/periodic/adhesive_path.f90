! SPDX-License-Identifier: GPL-3.0-or-later
!> Adhesive contact of a periodic surface whose mean gap changes slowly, on one grid.
!>
!> States are followed by `adfric_periodic_gap_path`.
!>
!> - On a path without a jump dE = q d delta, E the energy of solid and adhesion, q the load, delta the penetration. A step whose energy is
!>   not that by the trapezium has passed something, or is too long, and is halved.
!> - A body that slides over a viscoelastic solid has no such energy. Its steps move no edge of adhesion by more than half a cell, and change
!>   no tension of another law by more than a tenth of the largest.
!> - Where the smallest step fails, the state is lost. Shares are prescribed then and found anew in turns, to a state. At rest each
!>   turn lowers the energy; sliding turns need not end, and those that do not are no answer. Near the state Newton's method ends that.
!> - Surfaces without a cell in range are free; they stay so when they part.
module adfric_periodic_adhesive_path
   use adfric_base_kinds, only: dp
   use adfric_periodic_adhesive_contact, only: find_state, solve_again
   use adfric_periodic_contact, only: contact_state_t
   use adfric_periodic_gap_path, only: gap_path_t, passing_tolerance
   use adfric_periodic_gap_solver, only: gap_solver_t
   use adfric_periodic_maps, only: largest_difference, sum_of
   use adfric_periodic_operator, only: periodic_operator_t
   implicit none (type, external)
   private
   public :: follow_state

   !> Part of the load that contact carries, by which the energy of a step may differ from that of the trapezium.
   real(dp), parameter :: loss_of_step = 0.02_dp
   !> Largest change of the share of a cell in a step of a surface that slides.
   real(dp), parameter :: most_change = 0.5_dp
   !> The same of a law that falls slowly.
   real(dp), parameter :: most_change_of_law = 0.1_dp
   !> Largest change of a share that ends the turns.
   real(dp), parameter :: resting_share = 1.0e-7_dp
   !> Newton's state is the one that turns go to where it is not farther than so many times what their shrinking changes add up to.
   real(dp), parameter :: margin = 3

   !> A surface that adheres by the law of Maugis and Dugdale.
   type, extends(gap_path_t) :: dugdale_path_t
      !> Workspace of the iterations over the open cells.
      type(gap_solver_t), pointer :: gap_solver => null()
   contains
      procedure :: find
      procedure :: is_step
      procedure :: jump
      procedure :: is_free
   end type dugdale_path_t

contains

   !> Follow a state to another mean gap.
   subroutine follow_state(state, mean_gap, operator, gap_solver, tolerance, least_load, largest_load, has_arrived)
      !> In: a state, with gap, region and shares. Out: that at the mean gap, with the mean gap fixed.
      type(contact_state_t), intent(inout) :: state
      !> The mean gap, > 0.
      real(dp), intent(in) :: mean_gap
      !> Operator of this grid, which counts how often it is applied.
      type(periodic_operator_t), intent(inout), target :: operator
      type(gap_solver_t), intent(inout), target :: gap_solver
      !> Largest residual of the last state [-].
      real(dp), intent(in) :: tolerance
      !> Receive the smallest and the largest load of the states on the way, those of the ends among them [E*].
      real(dp), intent(out) :: least_load, largest_load
      !> Receives whether the mean gap was reached.
      logical, intent(out) :: has_arrived
      type(dugdale_path_t) :: path

      path%operator => operator
      path%gap_solver => gap_solver
      call path%follow(state, mean_gap, tolerance, least_load, largest_load, has_arrived)
   end subroutine follow_state

   !> See `gap_path_t`.
   subroutine find(self, state, tolerance, has_found)
      class(dugdale_path_t), intent(inout) :: self
      type(contact_state_t), intent(inout) :: state
      real(dp), intent(in) :: tolerance
      logical, intent(out) :: has_found

      call find_state(state, self%operator, self%gap_solver, tolerance, has_found)
   end subroutine find

   !> See `gap_path_t`.
   logical function is_step(self, state, next)
      class(dugdale_path_t), intent(inout) :: self
      type(contact_state_t), intent(in) :: state, next

      if (self%operator%is_symmetric .and. .not. allocated(state%cohesion%law)) then
         is_step = is_smooth(state, next)
      else
         is_step = is_near(state, next)
      end if
   end function is_step

   !> Is the energy of a step that of a path without a jump?
   logical function is_smooth(state, next)
      type(contact_state_t), intent(in) :: state, next
      real(dp) :: change, loss, carried

      change = state%mean_gap - next%mean_gap
      carried = abs(next%mean_pressure) + next%cohesion%stress*(sum_of(next%cohesion%share)/size(next%cohesion%share))
      loss = energy_of(next) - energy_of(state) - (state%mean_pressure + next%mean_pressure)/2*change
      is_smooth = abs(loss) <= loss_of_step*carried*abs(change)
   end function is_smooth

   !> Is no cell's share changed by much? Two states that are so near are one on these cells.
   logical function is_near(state, next)
      type(contact_state_t), intent(in) :: state, next

      is_near = largest_difference(next%cohesion%share, state%cohesion%share) &
         & <= merge(most_change_of_law, most_change, allocated(state%cohesion%law))
   end function is_near

   !> Energy of solid and adhesion per area [E* times the unit of the gap].
   real(dp) function energy_of(state)
      !> A state with its shares; its pressure is that of the gap and the shares.
      type(contact_state_t), intent(in) :: state
      real(dp), allocatable :: energy(:, :)

      allocate (energy, mold=state%gap)
      energy(:, :) = (state%gap - state%shape)*(state%pressure - state%mean_pressure - state%cohesion%stress*state%cohesion%share)
      energy_of = sum_of(energy)/(2*size(energy)) + state%cohesion%energy_of(state%gap)
   end function energy_of

   !> See `gap_path_t`.
   subroutine jump(self, state, tolerance, rounds_at_most, next, has_found)
      class(dugdale_path_t), intent(inout) :: self
      type(contact_state_t), intent(in) :: state
      real(dp), intent(in) :: tolerance
      !> Turns that are made at most.
      integer, intent(in) :: rounds_at_most
      !> In: the mean gap. Out: the state there.
      type(contact_state_t), intent(inout) :: next
      !> Receives whether one was found.
      logical, intent(out) :: has_found
      type(contact_state_t) :: found
      real(dp), allocatable :: share(:, :)
      real(dp) :: change, change_before, mean_gap
      integer :: k, next_try

      mean_gap = next%mean_gap
      next = state
      next%mean_gap = mean_gap
      allocate (share, source=state%cohesion%share)
      next_try = 3
      has_found = .false.
      change = huge(1.0_dp)
      do k = 1, rounds_at_most
         if (self%operator%is_stopped()) exit
         call next%cohesion%hold()
         call solve_again(next, self%operator, self%gap_solver, passing_tolerance)
         share(:, :) = next%cohesion%share
         call next%cohesion%set_share(next%gap)
         change_before = change
         change = largest_difference(next%cohesion%share, share)
         if (k < next_try .and. change > resting_share) cycle
         next_try = k + max(3, k/4)
         found = next
         call find_state(found, self%operator, self%gap_solver, tolerance, has_found)
         if (has_found .and. change > resting_share) then
            has_found = change < change_before
            if (has_found) has_found = largest_difference(found%cohesion%share, next%cohesion%share) &
               & *(1 - change/change_before) <= margin*change
         end if
         if (has_found .or. change <= resting_share) exit
      end do
      if (has_found) then
         next = found
      else if (change <= resting_share) then
         ! no Newton's method, but the shares rest
         call next%cohesion%hold()
         call solve_again(next, self%operator, self%gap_solver, tolerance)
         has_found = next%is_converged
      end if
   end subroutine jump

   !> See `gap_path_t`: no cell is within the range.
   logical function is_free(self, state)
      class(dugdale_path_t), intent(in) :: self
      type(contact_state_t), intent(in) :: state

      is_free = .not. any(state%cohesion%share > 0)
      associate (unused => self)
      end associate
   end function is_free

end module adfric_periodic_adhesive_path

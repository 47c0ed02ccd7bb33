! SPDX-License-Identifier: GPL-3.0-or-later
!> A periodic surface whose mean gap changes slowly, on one grid, whatever draws it.
!>
!> At a given mean gap there is no order of states as under a load: the mean couples all cells, and which state holds depends on those
!> before. So states are followed in steps, each with Newton's method from the last one. A step that has passed something, or is too
!> long, is made shorter. Where the smallest step fails, the state is lost, and the surface goes to another one at the same mean gap.
module adfric_periodic_gap_path
   use adfric_base_kinds, only: dp
   use adfric_periodic_contact, only: contact_state_t
   use adfric_periodic_maps, only: sum_of
   use adfric_periodic_operator, only: periodic_operator_t
   implicit none (type, external)
   private
   public :: gap_path_t, penetration_of, passing_tolerance

   !> Steps that are made at most, rounds after a jump, and rounds before a longer step is tried.
   integer, parameter :: most_steps = 2000, most_rounds = 2000, rounds_before = 40
   !> The smallest step of the mean gap, in units of the range of the undeformed gap.
   real(dp), parameter :: least_step = 2.0e-4_dp
   !> Factor of the step after one that went well, and after one that did not.
   real(dp), parameter :: growth = 2, shrinkage = 0.25_dp
   !> Factor by which the smallest step may be larger, for round-off.
   real(dp), parameter :: enough = 1.01_dp
   !> Residual of the states before the last one.
   real(dp), parameter :: passing_tolerance = 1.0e-7_dp

   !> What draws the surface, and how its states are found.
   type, abstract :: gap_path_t
      !> Operator of the grid, which counts how often it is applied.
      type(periodic_operator_t), pointer :: operator => null()
   contains
      procedure, non_overridable :: follow
      procedure(find_i), deferred :: find
      procedure(is_step_i), deferred :: is_step
      procedure(jump_i), deferred :: jump
      procedure(is_free_i), deferred :: is_free
   end type gap_path_t

   abstract interface

      !> Newton's method at the mean gap of a state.
      subroutine find_i(self, state, tolerance, has_found)
         import :: contact_state_t, dp, gap_path_t
         implicit none (type, external)
         !> The surface.
         class(gap_path_t), intent(inout) :: self
         !> In: where to begin. Out: a state, if it is found.
         type(contact_state_t), intent(inout) :: state
         !> Largest residual that is allowed [-].
         real(dp), intent(in) :: tolerance
         !> Receives whether a state was found.
         logical, intent(out) :: has_found
      end subroutine find_i

      !> Is there no jump between two states?
      logical function is_step_i(self, state, next)
         import :: contact_state_t, gap_path_t
         implicit none (type, external)
         !> The surface.
         class(gap_path_t), intent(inout) :: self
         !> The states, at mean gaps that differ.
         type(contact_state_t), intent(in) :: state, next
      end function is_step_i

      !> Go to the state to which a lost one falls.
      subroutine jump_i(self, state, tolerance, rounds_at_most, next, has_found)
         import :: contact_state_t, dp, gap_path_t
         implicit none (type, external)
         !> The surface.
         class(gap_path_t), intent(inout) :: self
         !> The last state.
         type(contact_state_t), intent(in) :: state
         !> Largest residual of the wanted one [-].
         real(dp), intent(in) :: tolerance
         !> Rounds that are made at most.
         integer, intent(in) :: rounds_at_most
         !> In: the mean gap. Out: the state there.
         type(contact_state_t), intent(inout) :: next
         !> Receives whether one was found.
         logical, intent(out) :: has_found
      end subroutine jump_i

      !> Does nothing pull or push the surfaces?
      logical function is_free_i(self, state)
         import :: contact_state_t, gap_path_t
         implicit none (type, external)
         !> The surface.
         class(gap_path_t), intent(in) :: self
         !> A state.
         type(contact_state_t), intent(in) :: state
      end function is_free_i

   end interface

contains

   !> Follow a state to another mean gap.
   subroutine follow(self, state, mean_gap, tolerance, least_load, largest_load, has_arrived)
      class(gap_path_t), intent(inout) :: self
      !> In: a state. Out: that at the mean gap, with the mean gap fixed.
      type(contact_state_t), intent(inout) :: state
      !> The mean gap, > 0.
      real(dp), intent(in) :: mean_gap
      !> Largest residual of the last state [-].
      real(dp), intent(in) :: tolerance
      !> Receive the smallest and the largest load of the states of the path, those of the ends among them [E*].
      real(dp), intent(out) :: least_load, largest_load
      !> Receives whether the mean gap was reached.
      logical, intent(out) :: has_arrived
      type(contact_state_t) :: next
      real(dp) :: step, shortest, gaps(3), loads(3)
      logical :: has_found, is_last
      integer :: k

      call fix_mean_gap(state)
      least_load = state%mean_pressure
      largest_load = state%mean_pressure
      gaps = state%mean_gap
      loads = state%mean_pressure
      step = mean_gap - state%mean_gap
      shortest = least_step*(maxval(state%shape) - minval(state%shape))
      ! a first cell in range is drawn in at once
      if (self%is_free(state)) step = sign(min(abs(step), shortest), step)
      has_found = .false.
      is_last = .false.
      do k = 1, most_steps
         if (self%operator%is_stopped()) exit
         is_last = abs(step) >= abs(mean_gap - state%mean_gap)
         if (self%is_free(state) .and. mean_gap >= state%mean_gap) then
            call part(state, mean_gap)
            has_found = .true.
            is_last = .true.
            exit
         end if
         next = state
         next%mean_gap = merge(mean_gap, state%mean_gap + step, is_last)
         call self%find(next, merge(tolerance, passing_tolerance, is_last), has_found)
         if (has_found) has_found = self%is_step(state, next)
         if (.not. has_found .and. abs(next%mean_gap - state%mean_gap) > enough*shortest) then
            step = sign(max(shortest, shrinkage*abs(next%mean_gap - state%mean_gap)), step)
            cycle
         end if
         if (.not. has_found) then
            call self%jump(state, merge(tolerance, passing_tolerance, is_last), merge(most_rounds, rounds_before, is_last), next, &
               & has_found)
            if (.not. has_found .and. is_last) exit
            ! next to where the state is lost it falls slowly
            if (.not. has_found) then
               shortest = growth*shortest
               step = sign(shortest, step)
               cycle
            end if
            shortest = least_step*(maxval(state%shape) - minval(state%shape))
         end if
         step = growth*step
         call note_load(loads, gaps, next, least_load, largest_load)
         state = next
         if (is_last) exit
      end do
      has_arrived = has_found .and. is_last
   end subroutine follow

   !> Take note of the load of one more state; between three of them it is a parabola.
   pure subroutine note_load(loads, gaps, state, least_load, largest_load)
      !> Loads [E*] and mean gaps of the last three states, the last one first; equal where there were fewer.
      real(dp), intent(inout) :: loads(3), gaps(3)
      type(contact_state_t), intent(in) :: state
      !> Smallest and largest load [E*].
      real(dp), intent(inout) :: least_load, largest_load
      real(dp) :: slopes(2), load

      loads = [state%mean_pressure, loads(:2)]
      gaps = [state%mean_gap, gaps(:2)]
      least_load = min(least_load, loads(1))
      largest_load = max(largest_load, loads(1))
      if (.not. product(gaps(:2) - gaps(2:)) > 0) return
      slopes = (loads(:2) - loads(2:))/(gaps(:2) - gaps(2:))
      if (.not. product(slopes) < 0) return
      ! slopes of the parabola at the middle state and its curvature
      associate (slope => sum(slopes*(gaps([2, 1]) - gaps([3, 2])))/(gaps(1) - gaps(3)), &
            & curvature => 2*(slopes(1) - slopes(2))/(gaps(1) - gaps(3)))
         load = loads(2) - slope**2/(2*curvature)
      end associate
      least_load = min(least_load, load)
      largest_load = max(largest_load, load)
   end subroutine note_load

   !> Fix the mean gap of a state, which may have been found under a load.
   subroutine fix_mean_gap(state)
      !> The state; receives its mean gap.
      type(contact_state_t), intent(inout) :: state

      state%has_fixed_mean = .true.
      state%mean_gap = sum_of(state%gap)/size(state%gap)
   end subroutine fix_mean_gap

   !> Part free surfaces.
   subroutine part(state, mean_gap)
      !> In: a state without a cell in range. Out: another one.
      type(contact_state_t), intent(inout) :: state
      real(dp), intent(in) :: mean_gap

      state%gap(:, :) = state%shape + (mean_gap - sum_of(state%shape)/size(state%shape))
      state%pressure(:, :) = 0
      state%mean_pressure = 0
      state%mean_gap = mean_gap
   end subroutine part

   !> How far the surfaces have approached since first touch, in the unit of the gap.
   real(dp) function penetration_of(state)
      type(contact_state_t), intent(in) :: state

      penetration_of = (sum_of(state%shape) - sum_of(state%gap))/size(state%gap)
   end function penetration_of

end module adfric_periodic_gap_path

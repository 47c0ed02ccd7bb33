! SPDX-License-Identifier: GPL-3.0-or-later
!> The state of an indenter with less adhesion below one with more (`adfric_round_weak_contact`).
module adfric_round_weak_state
   use adfric_base_kinds, only: dp
   use adfric_round_contact, only: branch_stable, find_contact, take_given
   use adfric_round_contact_state, only: contact_t, prescribed_of, prescribed_slope, set_contact
   use adfric_round_curve, only: at_corner, curve_t, state_t
   use adfric_round_survey, only: survey_t
   use adfric_round_weak_path, only: middle, weak_path_t, weaken
   implicit none (type, external)
   private
   public :: find_below

contains

   !> The state at an X below a state at a larger one.
   pure subroutine find_below(self, ratio, upper, contact)
      type(weak_path_t), intent(in) :: self
      !> X.
      real(dp), intent(in) :: ratio
      type(contact_t), intent(in) :: upper
      !> Receives the state, with `is_found`.
      type(contact_t), intent(out) :: contact
      class(curve_t), allocatable :: curve
      type(state_t) :: corner
      real(dp) :: u, low, high
      logical :: is_beyond, is_found, is_converged

      allocate (curve, source=self%curve)
      call weaken(curve, ratio)
      if (curve%shape%n_pieces == 0) then
         call find_contact(curve, survey_t(), self%control, self%given, .true., branch_stable, contact)
         contact%is_found = contact%is_found .and. contact%spot%radius > 0
         return
      end if
      is_beyond = upper%is_beyond
      high = upper%u
      low = 0
      ! a path in closed form may end beyond the corner
      if (is_beyond .and. curve%shape%corner > 0 .and. .not. (self%is_closed .and. self%low_is_beyond)) then
         call curve%get_state(0.0_dp, .true., corner)
         if (is_above(self, curve, corner)) then
            is_beyond = .false.
            high = merge(at_corner, curve%shape%corner, curve%shape%has_face)
         end if
      end if
      if (self%is_closed .and. (self%low_is_beyond .eqv. is_beyond)) low = min(self%low, high)
      call search_below(self, curve, is_beyond, low, high, u, is_found, is_converged)
      if (.not. is_found) return
      call set_contact(curve, self%control, u, is_beyond, contact)
      contact%is_found = .true.
      contact%is_stable = .true.
      contact%is_converged = contact%is_converged .and. is_converged
      call take_given(curve, self%control, self%given, contact)
   end subroutine find_below

   !> Does a state lie above the one that is sought? It is stable then, and holds more than what is given.
   pure logical function is_above(self, curve, state)
      type(weak_path_t), intent(in) :: self
      class(curve_t), intent(in) :: curve
      type(state_t), intent(in) :: state

      is_above = prescribed_of(curve, self%control, state) > self%given .and. (self%is_closed .or. state%is_stable(self%control))
   end function is_above

   !> Newton's method in the logarithm of the unknown, within a bracket.
   pure subroutine search_below(self, curve, is_beyond, first, last, u, is_found, is_converged)
      type(weak_path_t), intent(in) :: self
      class(curve_t), intent(in) :: curve
      logical, intent(in) :: is_beyond
      !> The bracket; its upper end lies above the state, or is it.
      real(dp), intent(in) :: first, last
      real(dp), intent(out) :: u
      logical, intent(out) :: is_found, is_converged
      ! a step after this one is round-off; where Newton's method is left; what next to a fold is a root
      real(dp), parameter :: close_enough = 1.0e-9_dp, little = 1.0e-12_dp, next_to_nothing = 1.0e-40_dp
      integer, parameter :: most_steps = 300, patience = 40
      type(state_t) :: state
      real(dp) :: low, high, value, slope, step
      integer :: k
      logical :: low_is_stable, is_tangent

      low = first
      high = last
      u = last
      if (.not. last < at_corner) u = 1
      low_is_stable = self%is_closed
      is_found = .true.
      is_converged = .true.
      value = 0
      do k = 1, most_steps
         call curve%get_state(u, is_beyond, state)
         is_converged = state%is_converged
         if (.not. is_converged) exit
         value = prescribed_of(curve, self%control, state) - self%given
         slope = u*prescribed_slope(curve, self%control, state)
         if (is_above(self, curve, state)) then
            high = u
         else
            low = u
            low_is_stable = self%is_closed .or. state%is_stable(self%control)
         end if
         ! a longer step than to a third is none
         is_tangent = slope > abs(value) .and. (self%is_closed .or. state%is_stable(self%control))
         step = 0
         if (is_tangent) step = -value/slope
         if (is_tangent .and. abs(step) <= close_enough) then
            u = min(max(u + u*step, first), last)
            return
         end if
         ! down to the last touch there is none
         if (high - low <= 4*epsilon(high)*high .or. .not. high > next_to_nothing*last) exit
         if (is_tangent .and. k < patience) u = u*exp(step)
         if (.not. (u > low .and. u < high) .or. .not. (is_tangent .and. k < patience)) u = middle(low, high)
      end do
      u = high
      if (low_is_stable) u = low
      is_found = is_converged .and. (low_is_stable .or. abs(value) <= little*abs(self%given))
   end subroutine search_below

end module adfric_round_weak_state

! SPDX-License-Identifier: GPL-3.0-or-later
!> The end of saturation of an adhesive sliding wave: the state without adhesion (`sliding_wave`) whose largest gap is the range.
module adfric_plane_adhesive_sliding_saturation
   use adfric_base_kinds, only: dp
   use adfric_numerics_double_exponential, only: integrand_t
   use adfric_numerics_largest_value, only: find_largest_value
   use adfric_plane_sliding_solid, only: sliding_solid_t
   use adfric_plane_sliding_wave, only: wave_contact_t, wave_of_width
   use adfric_plane_sliding_wave_profile, only: signed_gap
   implicit none (type, external)
   private
   public :: find_saturated_contact

   !> Bracket of the coordinate of the width; halvings before lines lead on; all steps.
   real(dp), parameter :: narrow = -40, wide = 25
   integer, parameter :: n_halvings = 8, most_steps = 200
   !> Largest errors of the logarithm of the gap: where steps end, and what is good enough.
   real(dp), parameter :: last_excess = 3.0e-15_dp, good_excess = 1.0e-9_dp
   !> Positions at which the summit of a gap is sought, their distance, and distances of the parabolas that lead to it, in the
   !> logarithm of the ratio of the distances from both edges.
   integer, parameter :: n_positions = 12
   real(dp), parameter :: step = 1, first_delta = 0.3_dp, last_delta = 1.0e-3_dp, farthest = 36
   integer, parameter :: most_parabolas = 12
   !> What the summit found so may be below the largest gap.
   real(dp), parameter :: same_summit = 1.0e-9_dp

   !> The gap from its leading edge.
   type, extends(integrand_t) :: gap_t
      !> The solid.
      type(sliding_solid_t) :: solid
      !> The contact.
      type(wave_contact_t) :: contact
      !> Length of the gap.
      real(dp) :: length = 0
   contains
      procedure :: evaluate
      procedure :: at
   end type gap_t

contains

   !> The contact whose largest gap is a range.
   pure subroutine find_saturated_contact(solid, range, contact, summit, is_found)
      type(sliding_solid_t), intent(in) :: solid
      !> The range [D], > 0 and < 2.
      real(dp), intent(in) :: range
      type(wave_contact_t), intent(out) :: contact
      !> Distances of its largest gap from the leading edge, along the motion, and from the next trailing edge.
      real(dp), intent(out) :: summit(2)
      logical, intent(out) :: is_found
      real(dp) :: largest, position
      type(gap_t) :: gap

      summit = 0
      call search(solid, range, .false., contact, is_found)
      if (is_found) then
         gap = gap_of(solid, contact)
         call find_largest_value(gap, gap%length, largest)
         is_found = abs(log(largest/range)) < same_summit
      end if
      ! two summits: the one that was followed is not the higher one
      if (.not. is_found) call search(solid, range, .true., contact, is_found)
      if (.not. is_found) return
      gap = gap_of(solid, contact)
      call find_summit(gap, .true., position, largest)
      summit = gap%length*[1/(1 + exp(-position)), 1/(1 + exp(position))]
   end subroutine find_saturated_contact

   !> The search for its width. The largest gap falls from 2.
   pure subroutine search(solid, range, is_global, contact, is_found)
      type(sliding_solid_t), intent(in) :: solid
      real(dp), intent(in) :: range
      !> Is the largest gap sought anew at each width, not from the last summit?
      logical, intent(in) :: is_global
      type(wave_contact_t), intent(out) :: contact
      logical, intent(out) :: is_found
      type(gap_t) :: gap
      real(dp) :: low, high, x, excess, excess_low, excess_high, largest, position
      integer :: i, side

      low = narrow
      high = wide
      excess_low = log(2/range)
      excess_high = -1
      side = 0
      position = 0
      do i = 1, most_steps
         x = low - excess_low*(high - low)/(excess_high - excess_low)
         if (i < n_halvings) x = (low + high)/2
         call wave_of_width(solid, x, contact, is_found)
         if (.not. is_found) return
         gap = gap_of(solid, contact)
         if (is_global) then
            call find_largest_value(gap, gap%length, largest)
         else
            call find_summit(gap, i == 1, position, largest)
         end if
         excess = log(largest/range)
         if (excess > 0) then
            low = x
            excess_low = excess
            if (side == 1) excess_high = excess_high/2
            side = 1
         else
            high = x
            excess_high = excess
            if (side == 2) excess_low = excess_low/2
            side = 2
         end if
         if (abs(excess) < last_excess .or. high - low < 1.0e-14_dp*max(1.0_dp, abs(x))) exit
      end do
      is_found = abs(excess) < good_excess
   end subroutine search

   !> The gap of a contact.
   pure function gap_of(solid, contact) result(gap)
      type(sliding_solid_t), intent(in) :: solid
      type(wave_contact_t), intent(in) :: contact
      type(gap_t) :: gap

      gap = gap_t(solid, contact, 4*atan2(contact%cosine, contact%sine))
   end function gap_of

   !> A summit of the gap: the highest of some positions, or the last one, from which parabolas climb.
   pure subroutine find_summit(gap, is_first, position, largest)
      type(gap_t), intent(in) :: gap
      !> Is there no last one?
      logical, intent(in) :: is_first
      !> Logarithm of the ratio of the distances from both edges: in: of the last summit; out: of this one.
      real(dp), intent(inout) :: position
      real(dp), intent(out) :: largest
      real(dp) :: values(3), move, delta, bend
      integer :: i

      if (is_first) position = step*(maxloc([(gap%at(i*step), i=-n_positions, n_positions)], 1) - n_positions - 1)
      delta = first_delta
      do i = 1, most_parabolas
         values = [gap%at(position - delta), gap%at(position), gap%at(position + delta)]
         bend = values(1) - 2*values(2) + values(3)
         move = 2*delta*sign(1.0_dp, values(3) - values(1))
         if (bend < 0) move = max(-2*delta, min(2*delta, delta*(values(1) - values(3))/(2*bend)))
         position = max(-farthest, min(farthest, position + move))
         if (abs(move) < delta .and. delta <= last_delta) exit
         if (abs(move) < delta) delta = max(last_delta, min(delta/4, 2*abs(move)))
      end do
      largest = gap%at(position)
   end subroutine find_summit

   !> The gap where the logarithm of the ratio of the distances from both edges is given.
   pure real(dp) function at(self, position)
      class(gap_t), intent(in) :: self
      real(dp), intent(in) :: position
      real(dp) :: e

      e = exp(-abs(position))
      at = self%evaluate(merge(self%length*e, self%length, position < 0)/(1 + e), 0.0_dp)
   end function at

   !> See `integrand_t`.
   pure real(dp) function evaluate(self, from_left, from_right) result(value)
      class(gap_t), intent(in) :: self
      !> Distance from the leading edge; that from the trailing edge is not needed.
      real(dp), intent(in) :: from_left, from_right

      value = signed_gap(self%solid, self%contact, self%contact%shift%shift + self%contact%half_width + from_left)
      associate (unused => from_right)
      end associate
   end function evaluate

end module adfric_plane_adhesive_sliding_saturation

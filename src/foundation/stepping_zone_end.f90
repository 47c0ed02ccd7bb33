! SPDX-License-Identifier: GPL-3.0-or-later
!> Where a zone of a march ends: blocks of pieces are passed by their bounds, and only pieces in which it may end are searched.
module adfric_foundation_stepping_zone_end
   use adfric_base_kinds, only: dp
   use adfric_foundation_stepping_path, only: way_t, decay_of, stretches_at, n_levels, block_length, negligible_term
   use adfric_foundation_stepping_zone_curve, only: zone_curve_t, find_first_zero, highest_power
   implicit none (type, external)
   private
   public :: place_t, end_contact, end_open_zone, period_over, zone_closes, zone_lets_go

   !> What ends a zone: the period, the gap that closes, or the gap that lets go (contact: the pressure).
   integer, parameter :: period_over = 0, zone_closes = 1, zone_lets_go = 2

   !> Bounds are given this share of their terms against round-off.
   real(dp), parameter :: guard = 1.0e-13_dp
   !> A value is zero within this share of its terms.
   real(dp), parameter :: round_off = 4*epsilon(1.0_dp)

   !> A place on the way.
   type :: place_t
      !> Number of the piece; one more than there are at the end of the period.
      integer :: piece = 1
      !> Share of the piece that is passed.
      real(dp) :: theta = 0
      !> Where a zone ends: share of the piece that is passed since the zone began, to all its digits, if it began in this piece; else -1.
      real(dp) :: passed = -1
   end type place_t

contains

   !> Follow a contact to its end.
   pure subroutine end_contact(way, depth, strength, disturbance, place, event, is_found)
      !> The way.
      type(way_t), intent(in) :: way
      !> Penetration, by which all heights are higher.
      real(dp), intent(in) :: depth
      !> Contact ends where the pressure falls to minus this.
      real(dp), intent(in) :: strength
      !> Stretches less those of endless contact where the zone begins; shape `(n_arms)`.
      real(dp), intent(in) :: disturbance(:)
      !> In: where the zone begins. Out: where it ends.
      type(place_t), intent(inout) :: place
      !> Receives `period_over` or `zone_lets_go`.
      integer, intent(out) :: event
      !> Has the search ended?
      logical, intent(out) :: is_found
      real(dp) :: excess(way%solid%n), left(way%solid%n), enough, terms, passed
      type(zone_curve_t) :: curve
      integer :: level
      logical :: is_first, has_risen, has_ended

      is_found = .true.
      event = period_over
      is_first = .true.
      has_risen = .false.
      excess = way%solid%stiffness*disturbance
      terms = sum(abs(excess)) + way%solid%glassy*(1 + abs(depth)) + strength
      enough = guard*terms - strength - depth
      do while (place%piece <= way%n)
         do level = first_level(way, place), 1, -1
            left = excess*what_is_left(way, place, way%ratio, way%decay, level)
            ! what pushes is least at the end, what pulls at the beginning
            if (way%bounds(level)%pressure(block_of(place, level)) + sum(min(excess, max(left, 0.0_dp))) > enough) exit
         end do
         if (level == 0) then
            call set_contact_curve(way, depth + strength, excess, place, curve)
            call find_first_zero(curve, round_off*terms, has_risen, passed, has_ended, is_found)
            if (has_ended) event = zone_lets_go
            if (has_ended) call end_within(place, passed, is_first)
            if (has_ended .or. .not. is_found) return
         else
            has_risen = .true.
         end if
         call pass(place, level)
         excess = left
         is_first = .false.
      end do
   end subroutine end_contact

   !> Follow an open zone to its end.
   pure subroutine end_open_zone(way, depth, pressure, close_gap, release_gap, elements, place, event, is_found)
      !> The way.
      type(way_t), intent(in) :: way
      !> Penetration, by which all heights are higher.
      real(dp), intent(in) :: depth
      !> Pressure in the zone: minus the adhesion stress, or 0.
      real(dp), intent(in) :: pressure
      !> The zone ends where the gap falls to this, or rises to that; the latter is huge in a free zone.
      real(dp), intent(in) :: close_gap, release_gap
      !> Kelvin elements where the zone begins; shape `(n_arms)`.
      real(dp), intent(in) :: elements(:)
      !> In: where the zone begins. Out: where it ends.
      type(place_t), intent(inout) :: place
      !> Receives `period_over`, `zone_closes` or `zone_lets_go`.
      integer, intent(out) :: event
      !> Has the search ended?
      logical, intent(out) :: is_found
      real(dp) :: y(way%solid%n), left(way%solid%n), base, terms, passed
      type(zone_curve_t) :: curve
      integer :: level
      logical :: is_first, may_close, may_let_go, has_closing_risen, has_release_risen, has_ended

      is_found = .true.
      event = period_over
      is_first = .true.
      has_closing_risen = .false.
      has_release_risen = .false.
      may_close = .true.
      may_let_go = .true.
      y = elements
      terms = sum(abs(y)) + 1 + abs(depth) + abs(pressure)
      base = pressure - depth
      do while (place%piece <= way%n)
         do level = first_level(way, place), 1, -1
            left = y*what_is_left(way, place, way%open_ratio, way%open_decay, level)
            may_close = base + sum(min(y, max(left, 0.0_dp))) - way%bounds(level)%highest(block_of(place, level)) &
               & <= close_gap + guard*terms
            may_let_go = base + sum(max(y, min(left, 0.0_dp))) - way%bounds(level)%lowest(block_of(place, level)) &
               & >= release_gap - guard*terms
            if (.not. (may_close .or. may_let_go)) exit
         end do
         has_closing_risen = has_closing_risen .or. .not. may_close
         has_release_risen = has_release_risen .or. .not. may_let_go
         if (level == 0) then
            passed = 0
            if (may_let_go) then
               call set_open_curve(way, base - release_gap, -1, y, place, curve)
               call find_first_zero(curve, round_off*terms, has_release_risen, passed, has_ended, is_found)
               if (has_ended) event = zone_lets_go
               if (.not. is_found) return
            end if
            if (may_close) then
               call set_open_curve(way, base - close_gap, 1, y, place, curve)
               call close_first(curve, round_off*terms, has_closing_risen, passed, event, is_found)
            end if
            if (event /= period_over) call end_within(place, passed, is_first)
            if (event /= period_over .or. .not. is_found) return
         end if
         call pass(place, level)
         y = left
         is_first = .false.
      end do
   end subroutine end_open_zone

   !> Look whether the gap closes before it lets go.
   pure subroutine close_first(curve, tolerance, has_risen, passed, event, is_found)
      !> Gap above that of closing.
      type(zone_curve_t), intent(in) :: curve
      !> Gap that is as good as zero.
      real(dp), intent(in) :: tolerance
      !> Has the gap been above that of closing?
      logical, intent(inout) :: has_risen
      !> In: share of the piece that is passed where the gap lets go, if it does. Out: where the first of both happens.
      real(dp), intent(inout) :: passed
      !> In: does the gap let go? Out: what happens first.
      integer, intent(inout) :: event
      !> Has the search ended?
      logical, intent(out) :: is_found
      real(dp) :: closing
      logical :: has_ended

      call find_first_zero(curve, tolerance, has_risen, closing, has_ended, is_found)
      if (.not. has_ended) return
      ! at one and the same place it closes
      if (event == zone_lets_go) then
         if (closing > passed) return
      end if
      event = zone_closes
      passed = closing
   end subroutine close_first

   !> End a zone within a piece.
   pure subroutine end_within(place, passed, is_first)
      !> In: where the zone or the piece begins. Out: where the zone ends.
      type(place_t), intent(inout) :: place
      !> Share of the piece that is passed since then.
      real(dp), intent(in) :: passed
      !> Did the zone begin in this piece?
      logical, intent(in) :: is_first

      place%theta = min(place%theta + passed, 1.0_dp)
      place%passed = merge(passed, -1.0_dp, is_first)
   end subroutine end_within

   !> The level of the largest block that begins at a place; 1 for a piece.
   pure integer function first_level(way, place) result(level)
      !> The way.
      type(way_t), intent(in) :: way
      !> The place.
      type(place_t), intent(in) :: place

      level = 1
      if (place%theta > 0) return
      do while (level < n_levels)
         associate (length => block_length(level + 1))
            if (mod(place%piece - 1, length) > 0 .or. place%piece - 1 + length > way%n) return
         end associate
         level = level + 1
      end do
   end function first_level

   !> Pass the rest of a piece, or a block.
   pure subroutine pass(place, level)
      !> The place, which moves on.
      type(place_t), intent(inout) :: place
      !> Level of the block, 0 or 1 for a piece.
      integer, intent(in) :: level

      place%piece = place%piece + block_length(max(level, 1))
      place%theta = 0
   end subroutine pass

   !> What is left of disturbances at the end of a block, or of the piece of the place.
   pure function what_is_left(way, place, ratio, decay, level) result(left)
      !> The way.
      type(way_t), intent(in) :: way
      !> The place where the block begins.
      type(place_t), intent(in) :: place
      !> A piece over the times of relaxation, and what is left after pieces and blocks; shapes `(n_arms)`, `(n_arms, n_levels)`.
      real(dp), intent(in) :: ratio(:), decay(:, :)
      !> Level of the block.
      integer, intent(in) :: level
      real(dp) :: left(way%solid%n)

      left = decay(:, level)
      if (level == 1 .and. place%theta > 0) left = decay_of((1 - place%theta)*ratio)
   end function what_is_left

   !> Number of the block of a place.
   pure integer function block_of(place, level)
      !> The place.
      type(place_t), intent(in) :: place
      !> Level of the block.
      integer, intent(in) :: level

      block_of = (place%piece - 1)/block_length(level) + 1
   end function block_of

   !> The pressure above that at which contact ends, within a piece.
   pure subroutine set_contact_curve(way, level, excess, place, curve)
      !> The way.
      type(way_t), intent(in) :: way
      !> Penetration, and strength of the contact.
      real(dp), intent(in) :: level
      !> Disturbance times stiffness at the place; shape `(n_arms)`.
      real(dp), intent(in) :: excess(:)
      !> The place, in the piece.
      type(place_t), intent(in) :: place
      !> Receives the curve.
      type(zone_curve_t), intent(inout) :: curve
      real(dp) :: stretch(way%solid%n), growth(way%solid%n), term, share
      integer :: i, m

      call stretches_at(way, place%piece, 0.0_dp, stretch, growth)
      curve%n = way%solid%n
      curve%last = highest_power
      curve%anchor = place%theta
      curve%power = 0
      curve%rate = way%ratio
      curve%amplitude = excess
      associate (c => way%coefficients(:, place%piece), d => way%degree, k => way%solid%stiffness, z => way%ratio)
         share = 1
         do i = 1, way%solid%n
            if (way%is_slow(i)) then
               share = share + k(i)
               ! k (f - e): e_(m+1) = z (c_m - e_m)/(m + 1)
               term = c(1) - stretch(i)
               curve%power(0) = curve%power(0) - k(i)*term
               do m = 1, highest_power
                  if (m <= d + 1) then
                     term = z(i)*(c(m) - term)/m
                  else
                     term = -z(i)*term/m
                  end if
                  curve%power(m) = curve%power(m) - k(i)*term
                  ! behind the heights terms fall at least as z/m
                  if (m > d + 1 .and. abs(term) < negligible_term) exit
               end do
            else
               ! a polynomial b, z b_m = (m + 1) (c_(m+1) - b_(m+1)), and what decays
               term = 0
               do m = d - 1, 0, -1
                  term = (m + 1)*(c(m + 2) - term)/z(i)
                  curve%power(m) = curve%power(m) + k(i)*term
               end do
               curve%amplitude(i) = curve%amplitude(i) + k(i)*(stretch(i) - term)*decay_of(z(i)*place%theta)
            end if
         end do
         curve%power(0:d) = curve%power(0:d) + share*c
         curve%power(0) = curve%power(0) + level
      end associate
   end subroutine set_contact_curve

   !> The gap above a bound, or below it, within a piece.
   pure subroutine set_open_curve(way, base, direction, elements, place, curve)
      !> The way.
      type(way_t), intent(in) :: way
      !> Displacement without the elements, less penetration and bound.
      real(dp), intent(in) :: base
      !> 1: the gap falls to the bound; -1: it rises to it.
      integer, intent(in) :: direction
      !> Kelvin elements at the place; shape `(n_arms)`.
      real(dp), intent(in) :: elements(:)
      !> The place, in the piece.
      type(place_t), intent(in) :: place
      !> Receives the curve.
      type(zone_curve_t), intent(inout) :: curve

      curve%n = way%solid%n
      curve%last = way%degree
      curve%anchor = place%theta
      curve%power = 0
      curve%power(0:way%degree) = -direction*way%coefficients(:, place%piece)
      curve%power(0) = curve%power(0) + direction*base
      curve%rate = way%open_ratio
      curve%amplitude = direction*elements
   end subroutine set_open_curve

end module adfric_foundation_stepping_zone_end

! SPDX-License-Identifier: GPL-3.0-or-later
!> Where a zone of a time stepping ends: blocks of pieces are passed by their bounds, and only pieces in which it may end are
!> searched.
module adfric_foundation_stepping_zone_end
   use adfric_base_kinds, only: dp
   use adfric_foundation_stepping_path, only: column_path_t, decay_of, stretches_at, n_levels, block_length, negligible_term
   use adfric_foundation_stepping_zone_curve, only: zone_curve_t, find_first_zero, highest_power
   implicit none (type, external)
   private
   public :: position_t, end_contact, end_open_zone, period_over, zone_closes, zone_lets_go

   !> What ends a zone: the period, the gap that closes, or the gap that lets go (contact: the pressure).
   integer, parameter :: period_over = 0, zone_closes = 1, zone_lets_go = 2

   !> Bounds are given this share of their terms against round-off.
   real(dp), parameter :: guard = 1.0e-13_dp
   !> A value is zero within this share of its terms.
   real(dp), parameter :: round_off = 4*epsilon(1.0_dp)

   !> A position on the path.
   type :: position_t
      !> Number of the piece; one more than there are at the end of the period.
      integer :: piece = 1
      !> Share of the piece that is passed.
      real(dp) :: theta = 0
      !> Where a zone ends: share of the piece that is passed since the zone began, to all its digits, if it began in this piece; else -1.
      real(dp) :: passed = -1
   end type position_t

contains

   !> Follow a contact to its end.
   pure subroutine end_contact(path, depth, strength, disturbance, position, event, is_found)
      type(column_path_t), intent(in) :: path
      !> Penetration, by which all heights are higher.
      real(dp), intent(in) :: depth
      !> Contact ends where the pressure falls to minus this.
      real(dp), intent(in) :: strength
      !> Stretches less those of endless contact where the zone begins; shape `(n_arms)`.
      real(dp), intent(in) :: disturbance(:)
      !> In: where the zone begins. Out: where it ends.
      type(position_t), intent(inout) :: position
      !> Receives `period_over` or `zone_lets_go`.
      integer, intent(out) :: event
      logical, intent(out) :: is_found
      real(dp) :: excess(path%solid%n), remaining(path%solid%n), enough, terms, passed
      type(zone_curve_t) :: curve
      integer :: level
      logical :: is_first, has_risen, has_ended

      is_found = .true.
      event = period_over
      is_first = .true.
      has_risen = .false.
      excess = path%solid%stiffness*disturbance
      terms = sum(abs(excess)) + path%solid%glassy*(1 + abs(depth)) + strength
      enough = guard*terms - strength - depth
      do while (position%piece <= path%n)
         do level = first_level(path, position), 1, -1
            remaining = excess*remaining_share(path, position, path%ratio, path%decay, level)
            ! what pushes is least at the end, what pulls at the beginning
            if (path%bounds(level)%pressure(block_of(position, level)) + sum(min(excess, max(remaining, 0.0_dp))) > enough) exit
         end do
         if (level == 0) then
            call set_contact_curve(path, depth + strength, excess, position, curve)
            call find_first_zero(curve, round_off*terms, has_risen, passed, has_ended, is_found)
            if (has_ended) event = zone_lets_go
            if (has_ended) call end_within(position, passed, is_first)
            if (has_ended .or. .not. is_found) return
         else
            has_risen = .true.
         end if
         call pass(position, level)
         excess = remaining
         is_first = .false.
      end do
   end subroutine end_contact

   !> Follow an open zone to its end.
   pure subroutine end_open_zone(path, depth, pressure, close_gap, release_gap, elements, position, event, is_found)
      type(column_path_t), intent(in) :: path
      real(dp), intent(in) :: depth
      !> Pressure in the zone: minus the adhesion stress, or 0.
      real(dp), intent(in) :: pressure
      !> The zone ends where the gap falls to this, or rises to that; the latter is huge in a free zone.
      real(dp), intent(in) :: close_gap, release_gap
      !> Kelvin elements where the zone begins; shape `(n_arms)`.
      real(dp), intent(in) :: elements(:)
      type(position_t), intent(inout) :: position
      !> Receives `period_over`, `zone_closes` or `zone_lets_go`.
      integer, intent(out) :: event
      logical, intent(out) :: is_found
      real(dp) :: y(path%solid%n), remaining(path%solid%n), base, terms, passed
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
      do while (position%piece <= path%n)
         do level = first_level(path, position), 1, -1
            remaining = y*remaining_share(path, position, path%open_ratio, path%open_decay, level)
            may_close = base + sum(min(y, max(remaining, 0.0_dp))) - path%bounds(level)%highest(block_of(position, level)) &
               & <= close_gap + guard*terms
            may_let_go = base + sum(max(y, min(remaining, 0.0_dp))) - path%bounds(level)%lowest(block_of(position, level)) &
               & >= release_gap - guard*terms
            if (.not. (may_close .or. may_let_go)) exit
         end do
         has_closing_risen = has_closing_risen .or. .not. may_close
         has_release_risen = has_release_risen .or. .not. may_let_go
         if (level == 0) then
            passed = 0
            if (may_let_go) then
               call set_open_curve(path, base - release_gap, -1, y, position, curve)
               call find_first_zero(curve, round_off*terms, has_release_risen, passed, has_ended, is_found)
               if (has_ended) event = zone_lets_go
               if (.not. is_found) return
            end if
            if (may_close) then
               call set_open_curve(path, base - close_gap, 1, y, position, curve)
               call close_first(curve, round_off*terms, has_closing_risen, passed, event, is_found)
            end if
            if (event /= period_over) call end_within(position, passed, is_first)
            if (event /= period_over .or. .not. is_found) return
         end if
         call pass(position, level)
         y = remaining
         is_first = .false.
      end do
   end subroutine end_open_zone

   !> Look whether the gap closes before it lets go.
   pure subroutine close_first(curve, tolerance, has_risen, passed, event, is_found)
      type(zone_curve_t), intent(in) :: curve
      !> Gap that is as good as zero.
      real(dp), intent(in) :: tolerance
      !> Has the gap been above that of closing?
      logical, intent(inout) :: has_risen
      !> In: share of the piece that is passed where the gap lets go, if it does. Out: where the first of both happens.
      real(dp), intent(inout) :: passed
      !> In: does the gap let go? Out: what happens first.
      integer, intent(inout) :: event
      logical, intent(out) :: is_found
      real(dp) :: closing
      logical :: has_ended

      call find_first_zero(curve, tolerance, has_risen, closing, has_ended, is_found)
      if (.not. has_ended) return
      ! at one and the same position it closes
      if (event == zone_lets_go) then
         if (closing > passed) return
      end if
      event = zone_closes
      passed = closing
   end subroutine close_first

   !> End a zone within a piece.
   pure subroutine end_within(position, passed, is_first)
      !> In: where the zone or the piece begins. Out: where the zone ends.
      type(position_t), intent(inout) :: position
      !> Share of the piece that is passed since then.
      real(dp), intent(in) :: passed
      !> Did the zone begin in this piece?
      logical, intent(in) :: is_first

      position%theta = min(position%theta + passed, 1.0_dp)
      position%passed = merge(passed, -1.0_dp, is_first)
   end subroutine end_within

   !> The level of the largest block that begins at a position; 1 for a piece.
   pure integer function first_level(path, position) result(level)
      type(column_path_t), intent(in) :: path
      type(position_t), intent(in) :: position

      level = 1
      if (position%theta > 0) return
      do while (level < n_levels)
         associate (length => block_length(level + 1))
            if (mod(position%piece - 1, length) > 0 .or. position%piece - 1 + length > path%n) return
         end associate
         level = level + 1
      end do
   end function first_level

   !> Pass the rest of a piece, or a block.
   pure subroutine pass(position, level)
      type(position_t), intent(inout) :: position
      !> Level of the block, 0 or 1 for a piece.
      integer, intent(in) :: level

      position%piece = position%piece + block_length(max(level, 1))
      position%theta = 0
   end subroutine pass

   !> What remains of disturbances at the end of a block, or of the piece of the position.
   pure function remaining_share(path, position, ratio, decay, level) result(remaining)
      type(column_path_t), intent(in) :: path
      type(position_t), intent(in) :: position
      !> A piece over the times of relaxation, and what remains after pieces and blocks; shapes `(n_arms)`, `(n_arms, n_levels)`.
      real(dp), intent(in) :: ratio(:), decay(:, :)
      integer, intent(in) :: level
      real(dp) :: remaining(path%solid%n)

      remaining = decay(:, level)
      if (level == 1 .and. position%theta > 0) remaining = decay_of((1 - position%theta)*ratio)
   end function remaining_share

   !> Number of the block of a position.
   pure integer function block_of(position, level)
      type(position_t), intent(in) :: position
      integer, intent(in) :: level

      block_of = (position%piece - 1)/block_length(level) + 1
   end function block_of

   !> The pressure above that at which contact ends, within a piece.
   pure subroutine set_contact_curve(path, level, excess, position, curve)
      type(column_path_t), intent(in) :: path
      !> Penetration, and strength of the contact.
      real(dp), intent(in) :: level
      !> Disturbance times stiffness at the position; shape `(n_arms)`.
      real(dp), intent(in) :: excess(:)
      type(position_t), intent(in) :: position
      type(zone_curve_t), intent(inout) :: curve
      real(dp) :: stretch(path%solid%n), growth(path%solid%n), term, share
      integer :: i, m

      call stretches_at(path, position%piece, 0.0_dp, stretch, growth)
      curve%n = path%solid%n
      curve%last = highest_power
      curve%anchor = position%theta
      curve%power = 0
      curve%rate = path%ratio
      curve%amplitude = excess
      associate (c => path%coefficients(:, position%piece), d => path%degree, k => path%solid%stiffness, z => path%ratio)
         share = 1
         do i = 1, path%solid%n
            if (path%is_slow(i)) then
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
               curve%amplitude(i) = curve%amplitude(i) + k(i)*(stretch(i) - term)*decay_of(z(i)*position%theta)
            end if
         end do
         curve%power(0:d) = curve%power(0:d) + share*c
         curve%power(0) = curve%power(0) + level
      end associate
   end subroutine set_contact_curve

   !> The gap above a bound, or below it, within a piece.
   pure subroutine set_open_curve(path, base, direction, elements, position, curve)
      type(column_path_t), intent(in) :: path
      !> Displacement without the elements, less penetration and bound.
      real(dp), intent(in) :: base
      !> 1: the gap falls to the bound; -1: it rises to it.
      integer, intent(in) :: direction
      !> Kelvin elements at the position; shape `(n_arms)`.
      real(dp), intent(in) :: elements(:)
      type(position_t), intent(in) :: position
      type(zone_curve_t), intent(inout) :: curve

      curve%n = path%solid%n
      curve%last = path%degree
      curve%anchor = position%theta
      curve%power = 0
      curve%power(0:path%degree) = -direction*path%coefficients(:, position%piece)
      curve%power(0) = curve%power(0) + direction*base
      curve%rate = path%open_ratio
      curve%amplitude = direction*elements
   end subroutine set_open_curve

end module adfric_foundation_stepping_zone_end

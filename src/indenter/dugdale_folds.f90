! SPDX-License-Identifier: GPL-3.0-or-later
!> The stable and the unstable parts of a curve of Maugis's theory.
!>
!> Folds are roots of F_P or F_d (see `adfric_indenter_dugdale_curve`), each one difference of two positive terms. With
!> N(c, th) = int g'(c cos(y)) cos(y) dy, 0 < y < th, they are where N is 2 S D,
!>
!>     D = 1 - cos(th) at given approach,    D = 1 - cos(th) + th^2/cos(th) under load.
!>
!> **Where g' never falls there is at most one fold.** For then N rises with c, and N >= g'(a) sin(th), so that d(ln N)/dth, which is
!> g'(a) cos(th)/N, is at most cot(th). At given approach d(ln D)/dth = sin(th)/(1 - cos(th)) is above that. Under load
!> sin(th) dD/dth = 2 th tan(th) + (th tan(th))^2 + sin(th)^2 is above cos(th) D = th^2 + cos(th) - cos(th)^2. So N/D falls with th and rises
!> with c, and along the curve a larger contact has a larger c and a smaller th: N/D rises, and passes 2 S once. A sign at the least and
!> at the largest contact then shows whether there is a fold. This holds for the cone, r^n with n >= 1 and sums of them, the sphere, and
!> the rounded punch.
!>
!> For the other kinds, and on a spring (`control_spring`), nobody has proved how many folds there are. They are found by the sign of
!> the difference over its terms, a number between -1 and 1, which is taken at places close to each other from the smallest contact, a = 0,
!> to one that is stable in JKR with much to spare. Each change of sign is a fold; where the number comes close to 0 and turns, its extreme value is sought between the
!> places, so that two folds side by side are seen, too.
module adfric_indenter_dugdale_folds
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, two_pi
   use adfric_indenter_curve, only: interval_t, endless, control_load, control_approach, control_spring
   use adfric_indenter_shape, only: shape_t, within_edge
   implicit none (type, external)
   private
   public :: margins_t, find_stable_parts, find_edge_angle

   !> Most places, and places in a decade: of a curve that has at most one fold, and of others.
   integer, parameter :: most_places = 400, few = 1, many = 8
   !> The corner of a flat face as seen from within, where u has no end.
   real(dp), parameter :: at_corner = 1.0e30_dp
   !> An extreme value is sought where the margin is as small as this.
   real(dp), parameter :: close_call = 0.5_dp

   !> The difference that makes folds, along a curve.
   type, abstract :: margins_t
      !> What is held; not `control_radius`.
      integer :: control = control_load
   contains
      procedure(get_margin_i), deferred :: get_margin
   end type margins_t

   abstract interface
      !> The margin at a place: > 0 where the state is stable.
      pure subroutine get_margin_i(self, u, is_beyond, margin, adhesion_radius, is_converged)
         import :: margins_t, dp
         implicit none (type, external)
         !> The curve and what is held.
         class(margins_t), intent(in) :: self
         !> The unknown, >= 0.
         real(dp), intent(in) :: u
         !> Is u one of those beyond the corner?
         logical, intent(in) :: is_beyond
         !> The margin, between -1 and 1.
         real(dp), intent(out) :: margin
         !> Radius c of adhesion.
         real(dp), intent(out) :: adhesion_radius
         !> Was the state found?
         logical, intent(out) :: is_converged
      end subroutine get_margin_i
   end interface

   !> Places along a curve.
   type :: places_t
      !> Has the curve at most one fold?
      logical :: has_one_fold = .false.
      !> Number of places.
      integer :: n = 0
      !> Their unknowns, and the origin from which their distances are like powers.
      real(dp) :: u(most_places) = 0, origin(most_places) = 0
      !> Do they lie beyond the corner?
      logical :: is_beyond(most_places) = .true.
   end type places_t

contains

   !> The parts of a curve.
   pure subroutine find_stable_parts(margins, shape, stress, range, intervals, n, is_converged)
      !> The difference that makes folds.
      class(margins_t), intent(inout) :: margins
      !> The shape of the indenter.
      class(shape_t), intent(in) :: shape
      !> Stress and range of adhesion, reduced.
      real(dp), intent(in) :: stress, range
      !> Receives the intervals.
      type(interval_t), intent(out) :: intervals(:)
      !> Receives their number.
      integer, intent(out) :: n
      !> Have all folds been found, with room for their intervals?
      logical, intent(out) :: is_converged
      type(places_t) :: places
      real(dp) :: values(most_places), c
      integer :: k, last
      logical :: is_found

      call choose_places(margins, shape, stress, range, places, is_converged)
      n = 0
      if (.not. is_converged) return
      last = places%n
      do k = 1, places%n
         call margins%get_margin(places%u(k), places%is_beyond(k), values(k), c, is_found)
         ! beside a vertical edge there is no room for a zone
         if (.not. is_found) last = k - 1
         if (.not. is_found) exit
      end do
      is_converged = last == places%n .or. (shape%edge < endless .and. last > 1)
      if (.not. is_converged) return
      call collect_intervals(margins, shape, places, last, values, intervals, n, is_converged)
   end subroutine find_stable_parts

   !> Choose the places.
   pure subroutine choose_places(margins, shape, stress, range, places, is_converged)
      !> The difference that makes folds.
      class(margins_t), intent(inout) :: margins
      !> The shape of the indenter.
      class(shape_t), intent(in) :: shape
      !> Stress and range of adhesion, reduced.
      real(dp), intent(in) :: stress, range
      !> Receives the places.
      type(places_t), intent(out) :: places
      !> Was the state at a = 0 found?
      logical, intent(out) :: is_converged
      real(dp), parameter :: smallest_share = 1.0e-3_dp, spare = 8.0_dp
      real(dp) :: margin, c, least, most, edge_angle
      integer :: control

      ! beside a vertical edge the last place may lie below the fold, and the way there is steep
      places%has_one_fold = shape%has_rising_slope .and. .not. shape%edge < endless .and. margins%control /= control_spring
      control = margins%control
      margins%control = control_approach
      call margins%get_margin(0.0_dp, .not. shape%corner > 0, margin, c, is_converged)
      margins%control = control
      if (.not. is_converged) return
      ! a fold under load near a = 0 is at a/c = (pi^2/4) S 2 c/I
      least = smallest_share*c
      if (control /= control_approach) least = min(least, 0.02_dp*c*max(1 - margin, epsilon(c))/(1 + margin + epsilon(c)))
      most = spare*max(shape%get_end(1.5_dp*sqrt(two_pi*stress*range)), c)
      if (shape%edge < endless) most = shape%unknown_of(within_edge*shape%edge)
      if (places%has_one_fold) call reach_stability(margins, most, is_converged)
      if (.not. is_converged) return
      if (shape%has_face) then
         ! within the face the zone ends at the corner where a/sqrt(b^2 - a^2) is the cotangent of the angle of a flat punch
         call find_edge_angle(pi*range/(4*stress), edge_angle)
         if (edge_angle > 0) then
            call add_places(places, .false., 1/tan(edge_angle), 1.0e-6_dp/tan(edge_angle), 1.0e6_dp/tan(edge_angle))
         else
            call add_places(places, .false., 0.0_dp, 1.0e-4_dp, 1.0e4_dp)
         end if
         call add_places(places, .true., 0.0_dp, 1.0e-4_dp*min(1.0_dp, sqrt(pi*range/(2*stress))), max(most, spare))
      else if (shape%corner > 0) then
         call add_places(places, .false., 0.0_dp, min(least, smallest_share), 1.0_dp)
         call add_places(places, .true., 0.0_dp, 1.0e-8_dp, max(most, spare))
      else
         call add_places(places, .true., 0.0_dp, least, most)
      end if
   end subroutine choose_places

   !> A contact that is stable, from a guess upwards.
   pure subroutine reach_stability(margins, u, is_converged)
      !> The difference that makes folds.
      class(margins_t), intent(in) :: margins
      !> In: a guess beyond the corner. Out: at least as much, a stable contact.
      real(dp), intent(inout) :: u
      !> Was one found?
      logical, intent(out) :: is_converged
      real(dp), parameter :: factor = 4.0_dp
      integer, parameter :: most_steps = 40
      real(dp) :: margin, c
      integer :: k
      logical :: is_found

      is_converged = .false.
      do k = 1, most_steps
         call margins%get_margin(u, .true., margin, c, is_found)
         is_converged = is_found .and. margin > 0
         if (is_converged .or. .not. is_found) return
         u = factor*u
      end do
   end subroutine reach_stability

   !> The angle th where th sin(th) + cos(th) - 1 has a value; 0 if the value is more than pi/2 - 1.
   pure subroutine find_edge_angle(value, angle)
      !> The value, > 0.
      real(dp), intent(in) :: value
      !> Receives the angle.
      real(dp), intent(out) :: angle
      ! a step after this one is round-off
      real(dp), parameter :: close_enough = 1.0e-9_dp
      integer, parameter :: most_steps = 60
      real(dp) :: k, step
      integer :: i

      angle = 0
      if (.not. value < pi/2 - 1) return
      angle = min(sqrt(2*value), pi/2)
      do i = 1, most_steps
         k = sin(angle)*(angle - tan(angle/2))
         ! by the logarithm of the angle
         step = (value - k)/(angle*cos(angle)*angle + tiny(k))
         step = max(-0.5_dp, min(0.5_dp, step))
         angle = min(angle*exp(step), pi/2)
         if (abs(step) < close_enough) exit
      end do
   end subroutine find_edge_angle

   !> Add places whose distances from an origin are a geometric row.
   pure subroutine add_places(places, is_beyond, origin, first, last)
      !> The places.
      type(places_t), intent(inout) :: places
      !> Do they lie beyond the corner?
      logical, intent(in) :: is_beyond
      !> The origin, which is the first of them.
      real(dp), intent(in) :: origin
      !> Least and largest distance.
      real(dp), intent(in) :: first, last
      integer :: k, n

      n = max(2, ceiling(merge(few, many, places%has_one_fold)*log10(last/first)))
      n = min(n, most_places/2 - 2)
      associate (m => places%n)
         do k = 0, n + 1
            places%u(m + k + 1) = origin
            if (k > 0) places%u(m + k + 1) = origin + first*(last/first)**(real(k - 1, dp)/n)
            places%origin(m + k + 1) = origin
            places%is_beyond(m + k + 1) = is_beyond
         end do
         m = m + n + 2
      end associate
   end subroutine add_places

   !> From the values at the places to intervals.
   pure subroutine collect_intervals(margins, shape, places, last, values, intervals, n, is_converged)
      !> The difference that makes folds.
      class(margins_t), intent(in) :: margins
      !> The shape of the indenter.
      class(shape_t), intent(in) :: shape
      !> The places.
      type(places_t), intent(in) :: places
      !> Number of the last place that has a value.
      integer, intent(in) :: last
      !> Margins at the places.
      real(dp), intent(in) :: values(:)
      !> Receives the intervals.
      type(interval_t), intent(out) :: intervals(:)
      !> Receives their number.
      integer, intent(out) :: n
      !> Was there room for all?
      logical, intent(out) :: is_converged
      real(dp) :: turn, at_turn
      integer :: k

      n = 1
      is_converged = .true.
      ! within a face contacts begin where their zone reaches its edge
      intervals(1) = interval_t(places%is_beyond(1), values(1) > 0, .false., .false., places%u(1), endless)
      do k = 1, last - 1
         if (n > size(intervals) - 3) is_converged = .false.
         if (.not. is_converged) return
         if (places%is_beyond(k) .neqv. places%is_beyond(k + 1)) then
            ! the corner; a fold there is one of the smallest contacts beyond it
            intervals(n)%high = merge(at_corner, shape%corner, shape%has_face)
            intervals(n)%ends_at_fold = (values(k) > 0) .and. .not. values(k + 1) > 0
            n = n + 1
            intervals(n) = interval_t(.true., values(k + 1) > 0, values(k + 1) > 0 .and. .not. values(k) > 0, .false., 0.0_dp, &
               & endless)
         else if ((values(k) > 0) .neqv. (values(k + 1) > 0)) then
            call add_fold(margins, places, k, places%u(k), places%u(k + 1), values(k), values(k + 1), intervals, n)
         else if (.not. places%has_one_fold .and. has_turn(values, places, k, last)) then
            call find_turn(margins, places, k, values(k) > 0, turn, at_turn)
            if ((at_turn > 0) .neqv. (values(k) > 0)) then
               call add_fold(margins, places, k, places%u(max(k - 1, 1)), turn, values(k), at_turn, intervals, n)
               call add_fold(margins, places, k, turn, places%u(k + 1), at_turn, values(k + 1), intervals, n)
            end if
         end if
      end do
      if (shape%edge < endless) intervals(n)%high = places%u(last)
   end subroutine collect_intervals

   !> Does the margin come close to 0 at a place, and turn?
   pure logical function has_turn(values, places, k, last)
      !> Margins at the places.
      real(dp), intent(in) :: values(:)
      !> The places.
      type(places_t), intent(in) :: places
      !> The place.
      integer, intent(in) :: k
      !> Number of the last place that has a value.
      integer, intent(in) :: last

      has_turn = .false.
      if (k == 1 .or. k + 1 > last) return
      if ((places%is_beyond(k - 1) .neqv. places%is_beyond(k)) .or. abs(values(k)) > close_call) return
      if ((values(k - 1) > 0) .neqv. (values(k) > 0)) return
      has_turn = abs(values(k)) <= abs(values(k - 1)) .and. abs(values(k)) <= abs(values(k + 1))
   end function has_turn

   !> A place between two, at a share of the way, evenly in the logarithm of the distance from the origin.
   pure real(dp) function between(low, high, origin, share)
      !> The two places.
      real(dp), intent(in) :: low, high
      !> The origin.
      real(dp), intent(in) :: origin
      !> The share, between 0 and 1.
      real(dp), intent(in) :: share

      if (low > origin) then
         between = origin + (low - origin)*((high - origin)/(low - origin))**share
      else
         between = low + (high - low)*share
      end if
   end function between

   !> The smallest margin, in size, around a place, by the golden section; the search ends where the sign changes.
   pure subroutine find_turn(margins, places, k, is_positive, turn, at_turn)
      !> The difference that makes folds.
      class(margins_t), intent(in) :: margins
      !> The places.
      type(places_t), intent(in) :: places
      !> The place.
      integer, intent(in) :: k
      !> Is the margin positive around the place?
      logical, intent(in) :: is_positive
      !> Receives the place of the turn.
      real(dp), intent(out) :: turn
      !> Receives the margin there.
      real(dp), intent(out) :: at_turn
      real(dp), parameter :: golden = 0.6180339887498949_dp
      integer, parameter :: most_steps = 45
      real(dp) :: low, high, shares(2), values(2)
      integer :: i, new

      low = 0
      high = 1
      shares = [1 - golden, golden]
      values = huge(low)
      new = 0
      do i = 1, most_steps
         if (new /= 2) values(1) = margin_at(margins, places, k, shares(1), is_positive)
         if (new /= 1) values(2) = margin_at(margins, places, k, shares(2), is_positive)
         if (any(values < 0)) exit
         if (values(1) < values(2)) then
            high = shares(2)
            shares = [high - golden*(high - low), shares(1)]
            values(2) = values(1)
            new = 1
         else
            low = shares(1)
            shares = [shares(2), low + golden*(high - low)]
            values(1) = values(2)
            new = 2
         end if
      end do
      i = minloc(values, 1)
      turn = between(places%u(k - 1), places%u(k + 1), places%origin(k), shares(i))
      at_turn = merge(values(i), -values(i), is_positive)
   end subroutine find_turn

   !> The margin at a share of the way around a place, positive as there.
   pure real(dp) function margin_at(margins, places, k, share, is_positive) result(margin)
      !> The difference that makes folds.
      class(margins_t), intent(in) :: margins
      !> The places.
      type(places_t), intent(in) :: places
      !> The place.
      integer, intent(in) :: k
      !> The share of the way from the place before to the next one.
      real(dp), intent(in) :: share
      !> Is the margin positive around the place?
      logical, intent(in) :: is_positive
      real(dp) :: u, c
      logical :: is_found

      u = between(places%u(k - 1), places%u(k + 1), places%origin(k), share)
      call margins%get_margin(u, places%is_beyond(k), margin, c, is_found)
      if (.not. is_positive) margin = -margin
   end function margin_at

   !> Find the fold between two places of different signs, and divide the last interval there.
   pure subroutine add_fold(margins, places, k, low, high, at_low, at_high, intervals, n)
      !> The difference that makes folds.
      class(margins_t), intent(in) :: margins
      !> The places.
      type(places_t), intent(in) :: places
      !> A place of the same region.
      integer, intent(in) :: k
      !> The two places.
      real(dp), intent(in) :: low, high
      !> The margins there.
      real(dp), intent(in) :: at_low, at_high
      !> The intervals; the last one is divided.
      type(interval_t), intent(inout) :: intervals(:)
      !> Their number, which grows by 1.
      integer, intent(inout) :: n
      real(dp) :: fold

      fold = root_between(margins, places%is_beyond(k), places%origin(k), low, high, at_low, at_high)
      intervals(n)%high = fold
      intervals(n)%ends_at_fold = .true.
      n = n + 1
      intervals(n) = interval_t(places%is_beyond(k), at_high > 0, .true., .false., fold, endless)
   end subroutine add_fold

   !> The root of the margin between two places, by the method of Illinois.
   pure real(dp) function root_between(margins, is_beyond, origin, low, high, at_low, at_high) result(root)
      !> The difference that makes folds.
      class(margins_t), intent(in) :: margins
      !> Do the places lie beyond the corner?
      logical, intent(in) :: is_beyond
      !> Origin of their region.
      real(dp), intent(in) :: origin
      !> The two places.
      real(dp), intent(in) :: low, high
      !> The margins there, of different signs.
      real(dp), intent(in) :: at_low, at_high
      real(dp), parameter :: close_enough = 4*epsilon(1.0_dp)
      integer, parameter :: most_steps = 100
      real(dp) :: left, right, value_left, value_right, share, value, c
      integer :: i, side
      logical :: is_found

      left = 0
      right = 1
      value_left = at_low
      value_right = at_high
      side = 0
      root = low
      do i = 1, most_steps
         share = left + (right - left)*value_left/(value_left - value_right)
         if (.not. (share > left .and. share < right)) share = left + (right - left)/2
         root = between(low, high, origin, share)
         call margins%get_margin(root, is_beyond, value, c, is_found)
         if (.not. is_found .or. .not. abs(value) > close_enough .or. right - left < close_enough) return
         if ((value > 0) .eqv. (value_left > 0)) then
            left = share
            value_left = value
            if (side == 1) value_right = value_right/2
            side = 1
         else
            right = share
            value_right = value
            if (side == 2) value_left = value_left/2
            side = 2
         end if
      end do
   end function root_between

end module adfric_indenter_dugdale_folds

! SPDX-License-Identifier: GPL-3.0-or-later
!> The stable and the unstable parts of a curve of Maugis's theory.
!>
!> Folds are roots of F_d + 2 s F_P (see `adfric_indenter_dugdale_curve`), a difference of two positive terms. With
!> N(c, th) = int g'(c cos(y)) cos(y) dy, 0 < y < th, they are where R = N/D is 2 S,
!>
!>     D = 1 - cos(th) + Y th^2/cos(th),    Y = 2 s a/(1 + 2 s a);    Y = 0 at given approach, Y = 1 under load.
!>
!> Along the curve a and c rise. With e = 1 - cos(th), k = th sin(th) + cos(th) - 1 and one factor, which is positive, da is
!> N sin(th) + 2 S (th - e sin(th)), dc is th [g'(a) sin(th) + 2 S cos(th)], and d(ln Y) = (1 - Y) d(ln a). How often R turns:
!>
!> **Where g' never falls R rises, and there is at most one fold.** For then N rises with c, and n = N/[g'(a) sin(th)] >= 1. At a fold,
!> 2 S = N/D, so that -c dth = n sin(th) (1 + k/D) - th cos(th), and R rises where
!>
!>     [n sin(th) (1 + k/D) - th cos(th)] [dD/dth - g'(a) cos(th) D/N] > Y (1 - Y) th^2/cos(th)^2 n sin(th) [sin(th) + (th - e sin(th) - sin(th) cos(th)^2)/D]
!>
!> does not fail. Both factors on the left rise faster with n than the right side, so n = 1, the cone, is the worst; with it this is, times D sin(th) cos(th)^2,
!>
!>     [e + Y th (tan(th) - th)] [e cos(th)^2 + Y th (2 sin(th) cos(th) - th cos(2 th))] > Y (1 - Y) th^2 sin(th)^2 [1 + Y th tan(th)]
!>
!> The difference of its sides is e^2 cos(th)^2 - Y m cos(th) + Y^2 q + Y^3 th^3 sin(th)^2 tan(th), m = th^2 sin(th)^2 + 2 e th^2 cos(th) - 3 e th sin(th) and
!> q = th^2 [3 sin(th)^2 - 3 th sin(th) cos(th) + th^2 cos(2 th)]. q is positive, q > 0.18 th^4, and where m > 0 m^2/(4 e^2 q), which is 1/4 at
!> th = 0, falls: so the first three terms have no root. This holds for the cone, r^n with n >= 1 and sums of them, the sphere, and the rounded punch.
!>
!> **Within a flat face R rises.** There g' = 0 and N = (pi/2) f'(c), which does not fall with c, and -c dth = N + 2 S k. The terms of N and of S both
!> outweigh those of Y, since dD/dth > Y th^2 sin(th)/cos(th)^2 and 2 Y k th/cos(th) >= Y th^3.
!>
!> **Beyond the corner of `flat_cone`, `flat_paraboloid` and `rounded_cone` R falls, and then it rises: two folds at most; in the tip
!> of `rounded_cone` R rises, and may then fall.** The direction of the curve is linear in 2 S, so for each place (a, th, Y) there is at most one S at which R turns. The sign of the
!> second derivative of R there shows which turn it is; it was evaluated, by complex steps, at TURNS turns among PLACES random places over the whole space (v from 1e-5 to 10, th down to 0.003 and up to
!> pi/2 - 1e-4, all Y): it was the one stated at all. The limit of narrow zones, th -> 0, is that of `adfric_indenter_spring_pieces`, where it is proved. All turns have v < LAST b.
!> With a tip all of whose zone is within the corner g' rises.
!>
!> So the sign of R - 2 S at the ends of a stretch tells its folds; where it is the same at both and R turns between them, its extreme
!> value does. R is smooth there, so round-off leaves two folds unseen that are closer together than about 1e-7 of their distance from the corner: what is held is the same along
!> the curve between them to round-off, so that both are as good as none.
module adfric_indenter_dugdale_folds
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, two_pi
   use adfric_indenter_curve, only: interval_t, endless, control_load
   use adfric_indenter_shape, only: shape_t, within_edge
   implicit none (type, external)
   private
   public :: margins_t, find_stable_parts, find_edge_angle

   !> The corner of a flat face as seen from within, where u has no end.
   real(dp), parameter :: at_corner = 1.0e30_dp
   !> Distances from the corner, in units of its radius, between which R turns: the least ones within and beyond it, and the largest.
   real(dp), parameter :: least_within = 1.0e-15_dp, least_beyond = 1.0e-8_dp, last_turn = 4.0_dp
   !> Share of a step by the golden section.
   real(dp), parameter :: small_share = 0.3819660112501051_dp

   !> The difference that makes folds, along a curve.
   type, abstract :: margins_t
      !> What is held; not `control_radius`.
      integer :: control = control_load
   contains
      procedure(get_margin_i), deferred :: get_margin
   end type margins_t

   abstract interface
      !> The margin at a place: > 0 where the state is stable.
      pure subroutine get_margin_i(self, u, is_beyond, margin, is_converged)
         import :: margins_t, dp
         implicit none (type, external)
         !> The curve and what is held.
         class(margins_t), intent(in) :: self
         !> The unknown, >= 0.
         real(dp), intent(in) :: u
         !> Is u one of those beyond the corner?
         logical, intent(in) :: is_beyond
         !> The margin, (R - 2 S)/(R + 2 S), between -1 and 1.
         real(dp), intent(out) :: margin
         !> Was the state found?
         logical, intent(out) :: is_converged
      end subroutine get_margin_i
   end interface

   !> A stretch of the curve along which R turns once at most.
   type :: stretch_t
      !> Does it lie beyond the corner?
      logical :: is_beyond = .true.
      !> 1 where R may fall and then rise, -1 where it may rise and then fall, 0 where it rises.
      integer :: turn = 0
      !> Its ends, the second of which may be any stable contact, and where the interval ends that it does.
      real(dp) :: low = 0, high = 0, last = endless
      !> ln(R/2 S) at the ends.
      real(dp) :: at_low = 0, at_high = 0
      !> A distance from the first end where a fold is sought first.
      real(dp) :: guess = 1
   end type stretch_t

contains

   !> The parts of a curve.
   pure subroutine find_stable_parts(margins, shape, stress, range, intervals, n, is_converged)
      !> The difference that makes folds.
      class(margins_t), intent(in) :: margins
      !> The shape of the indenter.
      class(shape_t), intent(in) :: shape
      !> Stress and range of adhesion, reduced.
      real(dp), intent(in) :: stress, range
      !> Receives the intervals.
      type(interval_t), intent(out) :: intervals(:)
      !> Receives their number.
      integer, intent(out) :: n
      !> Have all folds been found?
      logical, intent(out) :: is_converged
      type(stretch_t) :: outer, inner

      n = 0
      call lay_outer(margins, shape, stress, range, outer, is_converged)
      if (.not. is_converged) return
      if (shape%corner > 0) then
         call lay_inner(margins, shape, stress, range, outer%at_low, inner, is_converged)
         if (.not. is_converged) return
         call divide_stretch(margins, inner, shape%corner, intervals, n, is_converged)
      end if
      call divide_stretch(margins, outer, shape%corner, intervals, n, is_converged)
   end subroutine find_stable_parts

   !> The stretch beyond the corner, up to a contact that is stable; beside a vertical edge up to the last one that has room for its zone.
   pure subroutine lay_outer(margins, shape, stress, range, outer, is_converged)
      !> The difference that makes folds.
      class(margins_t), intent(in) :: margins
      !> The shape of the indenter.
      class(shape_t), intent(in) :: shape
      !> Stress and range of adhesion, reduced.
      real(dp), intent(in) :: stress, range
      !> Receives the stretch.
      type(stretch_t), intent(out) :: outer
      !> Were its ends found?
      logical, intent(out) :: is_converged
      real(dp), parameter :: factor = 4.0_dp
      integer, parameter :: most_steps = 40
      integer :: k

      call get_logarithm(margins, 0.0_dp, .true., outer%at_low, is_converged)
      if (.not. is_converged) return
      if (.not. shape%has_rising_slope) outer%turn = 1
      ! that of JKR under load, which is the largest one
      outer%guess = max(shape%get_end(1.5_dp*sqrt(two_pi*stress*range)), sqrt(stress*range))
      if (shape%edge < endless) then
         call find_room(margins, shape%unknown_of(within_edge*shape%edge), outer%high, outer%at_high)
         outer%last = outer%high
         outer%guess = min(outer%guess, outer%high/2)
         return
      end if
      outer%high = max(outer%guess, 2*last_turn*shape%corner)
      do k = 1, most_steps
         call get_logarithm(margins, outer%high, .true., outer%at_high, is_converged)
         if (.not. is_converged .or. outer%at_high > 0) return
         outer%high = factor*outer%high
      end do
      is_converged = .false.
   end subroutine lay_outer

   !> The last contact beside a vertical edge that has room for its zone; c rises along the curve, so all smaller ones have, too.
   pure subroutine find_room(margins, most, u, logarithm)
      !> The difference that makes folds.
      class(margins_t), intent(in) :: margins
      !> The contact that reaches the edge.
      real(dp), intent(in) :: most
      !> Receives the unknown of the last contact, 0 if that is the last one.
      real(dp), intent(out) :: u
      !> Receives ln(R/2 S) there.
      real(dp), intent(out) :: logarithm
      integer, parameter :: most_halvings = 16
      real(dp) :: low, high, value
      integer :: k
      logical :: is_found

      u = most
      call get_logarithm(margins, u, .true., logarithm, is_found)
      if (is_found) return
      low = 0
      high = most
      logarithm = -1
      do k = 1, most_halvings
         u = (low + high)/2
         call get_logarithm(margins, u, .true., value, is_found)
         if (is_found) low = u
         if (is_found) logarithm = value
         if (.not. is_found) high = u
      end do
      u = low
   end subroutine find_room

   !> The stretch within the corner.
   pure subroutine lay_inner(margins, shape, stress, range, at_high, inner, is_converged)
      !> The difference that makes folds.
      class(margins_t), intent(in) :: margins
      !> The shape of the indenter.
      class(shape_t), intent(in) :: shape
      !> Stress and range of adhesion, reduced.
      real(dp), intent(in) :: stress, range
      !> ln(R/2 S) at the corner.
      real(dp), intent(in) :: at_high
      !> Receives the stretch.
      type(stretch_t), intent(out) :: inner
      !> Was its first end found?
      logical, intent(out) :: is_converged
      real(dp) :: angle

      inner%is_beyond = .false.
      inner%at_high = at_high
      inner%high = shape%corner
      inner%guess = shape%corner/4
      if (shape%has_face) then
         ! contacts begin where the zone ends at the corner: a/sqrt(b^2 - a^2) is the cotangent of the angle of a flat punch
         call find_edge_angle(pi*range/(4*stress), angle)
         if (angle > 0) inner%low = 1/tan(angle)
         inner%guess = max(inner%low, 1.0_dp)
         inner%high = at_corner
      else
         inner%turn = -1
      end if
      inner%last = inner%high
      call get_logarithm(margins, inner%low, .false., inner%at_low, is_converged)
   end subroutine lay_inner

   !> ln(R/2 S) at a place.
   pure subroutine get_logarithm(margins, u, is_beyond, logarithm, is_converged)
      !> The difference that makes folds.
      class(margins_t), intent(in) :: margins
      !> The unknown, >= 0.
      real(dp), intent(in) :: u
      !> Is u one of those beyond the corner?
      logical, intent(in) :: is_beyond
      !> Receives the logarithm, cut off where R and 2 S are alike in no digit.
      real(dp), intent(out) :: logarithm
      !> Was the state found?
      logical, intent(out) :: is_converged
      real(dp) :: margin

      call margins%get_margin(u, is_beyond, margin, is_converged)
      logarithm = 2*atanh(max(min(margin, 1 - epsilon(margin)), epsilon(margin) - 1))
   end subroutine get_logarithm

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

   !> Divide a stretch at its folds.
   pure subroutine divide_stretch(margins, stretch, corner, intervals, n, is_converged)
      !> The difference that makes folds.
      class(margins_t), intent(in) :: margins
      !> The stretch.
      type(stretch_t), intent(in) :: stretch
      !> Radius of the corner.
      real(dp), intent(in) :: corner
      !> The intervals; those of the stretch are added.
      type(interval_t), intent(inout) :: intervals(:)
      !> Their number.
      integer, intent(inout) :: n
      !> Becomes false if a state is not found.
      logical, intent(inout) :: is_converged
      real(dp) :: turn, at_turn

      n = n + 1
      intervals(n) = interval_t(stretch%is_beyond, stretch%at_low > 0, .false., .false., stretch%low, stretch%last)
      if ((stretch%at_low > 0) .neqv. (stretch%at_high > 0)) then
         call add_fold(margins, stretch, [stretch%low, stretch%high], [stretch%at_low, stretch%at_high], stretch%guess, intervals, &
            & n, is_converged)
      else if (stretch%turn*stretch%at_low > 0) then
         call find_turn(margins, stretch, corner, turn, at_turn, is_converged)
         if ((at_turn > 0) .eqv. (stretch%at_low > 0)) return
         call add_fold(margins, stretch, [stretch%low, turn], [stretch%at_low, at_turn], turn/4, intervals, n, is_converged)
         call add_fold(margins, stretch, [turn, stretch%high], [at_turn, stretch%at_high], 2*turn, intervals, n, is_converged)
      end if
   end subroutine divide_stretch

   !> Where R is least, or largest, within a stretch that lies on one side of the corner, over the logarithm of the distance from the
   !> corner: by parabolas, and by the golden section where they fail (R. P. Brent, Algorithms for minimization without derivatives, 1973). The search ends where a
   !> fold has been passed.
   pure subroutine find_turn(margins, stretch, corner, turn, at_turn, is_converged)
      !> The difference that makes folds.
      class(margins_t), intent(in) :: margins
      !> The stretch, one end of which is the corner.
      type(stretch_t), intent(in) :: stretch
      !> Radius of the corner.
      real(dp), intent(in) :: corner
      !> Receives the place.
      real(dp), intent(out) :: turn
      !> Receives ln(R/2 S) there.
      real(dp), intent(out) :: at_turn
      !> Becomes false if a state is not found.
      logical, intent(inout) :: is_converged
      real(dp), parameter :: close_enough = 1.0e-7_dp
      integer, parameter :: most_steps = 100
      ! the best place so far comes first, then the next best ones; the last two steps
      real(dp) :: places(3), values(3), ends(2), steps(2), place, value
      integer :: k

      ends = log(corner*[merge(least_beyond, least_within, stretch%is_beyond), merge(last_turn, 1.0_dp, stretch%is_beyond)])
      steps = 0
      places = ends(2) - small_share*(ends(2) - ends(1))
      call get_value(margins, stretch, corner, places(1), values(1), is_converged)
      values(2:3) = values(1)
      do k = 1, most_steps
         if (.not. values(1) > 0 .or. abs(places(1) - sum(ends)/2) <= 2*close_enough - (ends(2) - ends(1))/2) exit
         call choose_step(places, values, ends, steps)
         place = places(1) + sign(max(abs(steps(1)), close_enough), steps(1))
         call get_value(margins, stretch, corner, place, value, is_converged)
         call take_value(place, value, places, values, ends)
      end do
      turn = place_of(stretch, corner, places(1))
      at_turn = stretch%turn*values(1)
   end subroutine find_turn

   !> The next step of a search for the least value.
   pure subroutine choose_step(places, values, ends, steps)
      !> The three best places, the best one first, and their values.
      real(dp), intent(in) :: places(3), values(3)
      !> Ends of what is left.
      real(dp), intent(in) :: ends(2)
      !> In: the last step and the one before. Out: the next step and the last.
      real(dp), intent(inout) :: steps(2)
      real(dp) :: p, q, before
      logical :: is_parabola

      p = (places(1) - places(2))*(values(1) - values(3))
      q = (places(1) - places(3))*(values(1) - values(2))
      before = steps(2)
      steps(2) = steps(1)
      steps(1) = (places(1) - places(2))*p - (places(1) - places(3))*q
      ! where the parabola has its least value
      is_parabola = abs(steps(1)) < abs(before*(q - p))
      if (is_parabola) then
         steps(1) = steps(1)/(2*(q - p))
         is_parabola = places(1) + steps(1) > ends(1) .and. places(1) + steps(1) < ends(2)
      end if
      if (is_parabola) return
      steps(2) = merge(ends(1), ends(2), places(1) >= sum(ends)/2) - places(1)
      steps(1) = small_share*steps(2)
   end subroutine choose_step

   !> Take a place of a search for the least value over.
   pure subroutine take_value(place, value, places, values, ends)
      !> The place and its value.
      real(dp), intent(in) :: place, value
      !> The three best places, the best one first, and their values.
      real(dp), intent(inout) :: places(3), values(3)
      !> Ends of what is left.
      real(dp), intent(inout) :: ends(2)

      if (value <= values(1)) then
         ends(merge(1, 2, place >= places(1))) = places(1)
         places = [place, places(1:2)]
         values = [value, values(1:2)]
         return
      end if
      ends(merge(2, 1, place >= places(1))) = place
      if (value <= values(2) .or. .not. abs(places(2) - places(1)) > 0) then
         places(2:3) = [place, places(2)]
         values(2:3) = [value, values(2)]
      else if (value <= values(3) .or. .not. abs(places(3) - places(1)) > 0 .or. .not. abs(places(3) - places(2)) > 0) then
         places(3) = place
         values(3) = value
      end if
   end subroutine take_value

   !> The unknown of a distance from the corner.
   pure real(dp) function place_of(stretch, corner, logarithm) result(u)
      !> The stretch.
      type(stretch_t), intent(in) :: stretch
      !> Radius of the corner.
      real(dp), intent(in) :: corner
      !> Logarithm of the distance.
      real(dp), intent(in) :: logarithm

      u = exp(logarithm)
      if (.not. stretch%is_beyond) u = max(corner - u, 0.0_dp)
   end function place_of

   !> ln(R/2 S) at a distance from the corner, with the sign that makes it positive at the ends of the stretch.
   pure subroutine get_value(margins, stretch, corner, logarithm, value, is_converged)
      !> The difference that makes folds.
      class(margins_t), intent(in) :: margins
      !> The stretch.
      type(stretch_t), intent(in) :: stretch
      !> Radius of the corner.
      real(dp), intent(in) :: corner
      !> Logarithm of the distance.
      real(dp), intent(in) :: logarithm
      !> Receives the value.
      real(dp), intent(out) :: value
      !> Becomes false if the state is not found.
      logical, intent(inout) :: is_converged
      logical :: is_found

      call get_logarithm(margins, place_of(stretch, corner, logarithm), stretch%is_beyond, value, is_found)
      value = stretch%turn*value
      is_converged = is_converged .and. is_found
   end subroutine get_value

   !> Find the fold between two places of different signs, and divide the last interval there.
   pure subroutine add_fold(margins, stretch, places, values, guess, intervals, n, is_converged)
      !> The difference that makes folds.
      class(margins_t), intent(in) :: margins
      !> The stretch.
      type(stretch_t), intent(in) :: stretch
      !> The two places, with one fold between them.
      real(dp), intent(in) :: places(2)
      !> ln(R/2 S) there.
      real(dp), intent(in) :: values(2)
      !> A distance from the first end of the stretch where it is sought first.
      real(dp), intent(in) :: guess
      !> The intervals; the last one is divided.
      type(interval_t), intent(inout) :: intervals(:)
      !> Their number, which grows by 1.
      integer, intent(inout) :: n
      !> Becomes false if a state is not found.
      logical, intent(inout) :: is_converged
      real(dp) :: ends(2), at_ends(2), fold

      ends = places
      at_ends = values
      call close_in(margins, stretch, guess, ends, at_ends, is_converged)
      call find_root_between(margins, stretch, ends, at_ends, fold, is_converged)
      intervals(n + 1) = interval_t(stretch%is_beyond, values(2) > 0, .true., .false., fold, intervals(n)%high)
      intervals(n)%high = fold
      intervals(n)%ends_at_fold = .true.
      n = n + 1
   end subroutine add_fold

   !> Close in on a fold until the distances of two places from the first end of their stretch are a decade apart.
   pure subroutine close_in(margins, stretch, guess, ends, values, is_converged)
      !> The difference that makes folds.
      class(margins_t), intent(in) :: margins
      !> The stretch.
      type(stretch_t), intent(in) :: stretch
      !> A distance from the first end of the stretch to begin with.
      real(dp), intent(in) :: guess
      !> The two places, with one fold between them.
      real(dp), intent(inout) :: ends(2)
      !> ln(R/2 S) there.
      real(dp), intent(inout) :: values(2)
      !> Becomes false if a state is not found.
      logical, intent(inout) :: is_converged
      real(dp), parameter :: decade = 10.0_dp
      integer, parameter :: most_decades = 320
      real(dp) :: distance, u, value
      integer :: k, side, last
      logical :: is_found

      distance = guess
      last = 0
      do k = 1, most_decades
         u = stretch%low + distance
         if (.not. (u > ends(1) .and. u < ends(2))) return
         call get_logarithm(margins, u, stretch%is_beyond, value, is_found)
         is_converged = is_converged .and. is_found
         side = merge(1, 2, (value > 0) .eqv. (values(1) > 0))
         ends(side) = u
         values(side) = value
         if (side + last == 3) return
         last = side
         distance = merge(decade*distance, distance/decade, side == 1)
      end do
   end subroutine close_in

   !> The fold between two places, by the method of Illinois.
   pure subroutine find_root_between(margins, stretch, ends, at_ends, fold, is_converged)
      !> The difference that makes folds.
      class(margins_t), intent(in) :: margins
      !> The stretch.
      type(stretch_t), intent(in) :: stretch
      !> The two places.
      real(dp), intent(in) :: ends(2)
      !> ln(R/2 S) there, of different signs.
      real(dp), intent(in) :: at_ends(2)
      !> Receives the fold.
      real(dp), intent(out) :: fold
      !> Becomes false if a state is not found.
      logical, intent(inout) :: is_converged
      real(dp), parameter :: close_enough = 4*epsilon(1.0_dp)
      integer, parameter :: most_steps = 100
      real(dp) :: shares(2), values(2), share, value
      integer :: k, side, last
      logical :: is_found

      shares = [0.0_dp, 1.0_dp]
      values = at_ends
      last = 0
      do k = 1, most_steps
         share = shares(1) + (shares(2) - shares(1))*values(1)/(values(1) - values(2))
         if (.not. (share > shares(1) .and. share < shares(2))) share = sum(shares)/2
         fold = between(ends, stretch%low, share)
         call get_logarithm(margins, fold, stretch%is_beyond, value, is_found)
         is_converged = is_converged .and. is_found
         if (.not. abs(value) > close_enough .or. shares(2) - shares(1) < close_enough) return
         side = merge(1, 2, (value > 0) .eqv. (values(1) > 0))
         shares(side) = share
         values(side) = value
         if (side == last) values(3 - side) = values(3 - side)/2
         last = side
      end do
   end subroutine find_root_between

   !> A place between two, at a share of the way, evenly in the logarithm of the distance from an origin.
   pure real(dp) function between(ends, origin, share)
      !> The two places.
      real(dp), intent(in) :: ends(2)
      !> The origin.
      real(dp), intent(in) :: origin
      !> The share, between 0 and 1.
      real(dp), intent(in) :: share

      if (ends(1) > origin) then
         between = origin + (ends(1) - origin)*((ends(2) - origin)/(ends(1) - origin))**share
      else
         between = ends(1) + (ends(2) - ends(1))*share
      end if
   end function between

end module adfric_indenter_dugdale_folds

! SPDX-License-Identifier: GPL-3.0-or-later
!> A stretch of a curve of Maugis's theory along which R/2 S, whose value is 1 at a fold (see `adfric_round_dugdale_folds`), turns
!> once at most, and its folds: the signs of the logarithm at its ends tell of one fold, and its least or largest value of two.
module adfric_round_dugdale_stretch
   use adfric_base_kinds, only: dp
   use adfric_round_curve, only: curve_interval_t, endless, control_load
   implicit none (type, external)
   private
   public :: margins_t, stretch_t, get_logarithm, divide_stretch, last_turn

   !> Distances from the corner, in units of its radius, between which R turns: the least ones within and beyond it, and the largest.
   real(dp), parameter :: least_within = 1.0e-15_dp, least_beyond = 1.0e-8_dp, last_turn = 4.0_dp
   !> Share of a step by the golden section.
   real(dp), parameter :: small_share = 0.3819660112501051_dp

   !> The difference that makes folds, along a curve.
   type, abstract :: margins_t
      !> What is prescribed; not `control_radius`.
      integer :: control = control_load
   contains
      procedure(get_margin_i), deferred :: get_margin
   end type margins_t

   abstract interface
      !> The margin at a position: > 0 where the state is stable.
      pure subroutine get_margin_i(self, u, is_beyond, margin, is_converged)
         import :: margins_t, dp
         implicit none (type, external)
         !> The curve and what is prescribed.
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

   !> ln(R/2 S) at a position.
   pure subroutine get_logarithm(margins, u, is_beyond, logarithm, is_converged)
      class(margins_t), intent(in) :: margins
      real(dp), intent(in) :: u
      logical, intent(in) :: is_beyond
      !> Receives the logarithm, cut off where R and 2 S are alike in no digit.
      real(dp), intent(out) :: logarithm
      logical, intent(out) :: is_converged
      real(dp) :: margin

      call margins%get_margin(u, is_beyond, margin, is_converged)
      logarithm = 2*atanh(max(min(margin, 1 - epsilon(margin)), epsilon(margin) - 1))
   end subroutine get_logarithm

   !> Divide a stretch at its folds.
   pure subroutine divide_stretch(margins, stretch, corner, intervals, n, is_converged)
      class(margins_t), intent(in) :: margins
      type(stretch_t), intent(in) :: stretch
      !> Radius of the corner.
      real(dp), intent(in) :: corner
      !> The intervals; those of the stretch are added.
      type(curve_interval_t), intent(inout) :: intervals(:)
      integer, intent(inout) :: n
      !> Becomes false if a state is not found.
      logical, intent(inout) :: is_converged
      real(dp) :: turn, at_turn

      n = n + 1
      intervals(n) = curve_interval_t(stretch%is_beyond, stretch%at_low > 0, .false., .false., stretch%low, stretch%last)
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
      class(margins_t), intent(in) :: margins
      type(stretch_t), intent(in) :: stretch
      real(dp), intent(in) :: corner
      !> Receives the position.
      real(dp), intent(out) :: turn
      !> Receives ln(R/2 S) there.
      real(dp), intent(out) :: at_turn
      logical, intent(inout) :: is_converged
      real(dp), parameter :: close_enough = 1.0e-7_dp
      integer, parameter :: most_steps = 100
      ! the best position so far comes first, then the next best ones; the last two steps
      real(dp) :: positions(3), values(3), ends(2), steps(2), position, value
      integer :: k

      ends = log(corner*[merge(least_beyond, least_within, stretch%is_beyond), merge(last_turn, 1.0_dp, stretch%is_beyond)])
      steps = 0
      positions = ends(2) - small_share*(ends(2) - ends(1))
      call get_value(margins, stretch, corner, positions(1), values(1), is_converged)
      values(2:3) = values(1)
      do k = 1, most_steps
         if (.not. values(1) > 0 .or. abs(positions(1) - sum(ends)/2) <= 2*close_enough - (ends(2) - ends(1))/2) exit
         call choose_step(positions, values, ends, steps)
         position = positions(1) + sign(max(abs(steps(1)), close_enough), steps(1))
         call get_value(margins, stretch, corner, position, value, is_converged)
         call take_value(position, value, positions, values, ends)
      end do
      turn = position_of(stretch, corner, positions(1))
      at_turn = stretch%turn*values(1)
   end subroutine find_turn

   !> The next step of a search for the least value.
   pure subroutine choose_step(positions, values, ends, steps)
      !> The three best positions, the best one first, and their values.
      real(dp), intent(in) :: positions(3), values(3)
      !> Ends of what remains.
      real(dp), intent(in) :: ends(2)
      !> In: the last step and the one before. Out: the next step and the last.
      real(dp), intent(inout) :: steps(2)
      real(dp) :: p, q, before
      logical :: is_parabola

      p = (positions(1) - positions(2))*(values(1) - values(3))
      q = (positions(1) - positions(3))*(values(1) - values(2))
      before = steps(2)
      steps(2) = steps(1)
      steps(1) = (positions(1) - positions(2))*p - (positions(1) - positions(3))*q
      ! where the parabola has its least value
      is_parabola = abs(steps(1)) < abs(before*(q - p))
      if (is_parabola) then
         steps(1) = steps(1)/(2*(q - p))
         is_parabola = positions(1) + steps(1) > ends(1) .and. positions(1) + steps(1) < ends(2)
      end if
      if (is_parabola) return
      steps(2) = merge(ends(1), ends(2), positions(1) >= sum(ends)/2) - positions(1)
      steps(1) = small_share*steps(2)
   end subroutine choose_step

   !> Take a position of a search for the least value over.
   pure subroutine take_value(position, value, positions, values, ends)
      real(dp), intent(in) :: position, value
      !> The three best positions, the best one first, and their values.
      real(dp), intent(inout) :: positions(3), values(3)
      !> Ends of what remains.
      real(dp), intent(inout) :: ends(2)

      if (value <= values(1)) then
         ends(merge(1, 2, position >= positions(1))) = positions(1)
         positions = [position, positions(1:2)]
         values = [value, values(1:2)]
         return
      end if
      ends(merge(2, 1, position >= positions(1))) = position
      if (value <= values(2) .or. .not. abs(positions(2) - positions(1)) > 0) then
         positions(2:3) = [position, positions(2)]
         values(2:3) = [value, values(2)]
      else if (value <= values(3) .or. .not. abs(positions(3) - positions(1)) > 0 .or. .not. abs(positions(3) &
         & - positions(2)) > 0) then
         positions(3) = position
         values(3) = value
      end if
   end subroutine take_value

   !> The unknown of a distance from the corner.
   pure real(dp) function position_of(stretch, corner, logarithm) result(u)
      type(stretch_t), intent(in) :: stretch
      real(dp), intent(in) :: corner
      !> Logarithm of the distance.
      real(dp), intent(in) :: logarithm

      u = exp(logarithm)
      if (.not. stretch%is_beyond) u = max(corner - u, 0.0_dp)
   end function position_of

   !> ln(R/2 S) at a distance from the corner, with the sign that makes it positive at the ends of the stretch.
   pure subroutine get_value(margins, stretch, corner, logarithm, value, is_converged)
      class(margins_t), intent(in) :: margins
      type(stretch_t), intent(in) :: stretch
      real(dp), intent(in) :: corner, logarithm
      !> Receives the value.
      real(dp), intent(out) :: value
      !> Becomes false if the state is not found.
      logical, intent(inout) :: is_converged
      logical :: is_found

      call get_logarithm(margins, position_of(stretch, corner, logarithm), stretch%is_beyond, value, is_found)
      value = stretch%turn*value
      is_converged = is_converged .and. is_found
   end subroutine get_value

   !> Find the fold between two positions of different signs, and divide the last interval there.
   pure subroutine add_fold(margins, stretch, positions, values, guess, intervals, n, is_converged)
      class(margins_t), intent(in) :: margins
      type(stretch_t), intent(in) :: stretch
      real(dp), intent(in) :: positions(2)
      !> ln(R/2 S) there.
      real(dp), intent(in) :: values(2)
      !> A distance from the first end of the stretch where it is sought first.
      real(dp), intent(in) :: guess
      !> The intervals; the last one is divided.
      type(curve_interval_t), intent(inout) :: intervals(:)
      !> Their number, which grows by 1.
      integer, intent(inout) :: n
      logical, intent(inout) :: is_converged
      real(dp) :: ends(2), at_ends(2), fold

      ends = positions
      at_ends = values
      call close_in(margins, stretch, guess, ends, at_ends, is_converged)
      call find_root_between(margins, stretch, ends, at_ends, fold, is_converged)
      intervals(n + 1) = curve_interval_t(stretch%is_beyond, values(2) > 0, .true., .false., fold, intervals(n)%high)
      intervals(n)%high = fold
      intervals(n)%ends_at_fold = .true.
      n = n + 1
   end subroutine add_fold

   !> Close in on a fold until the distances of two positions from the first end of their stretch are a decade apart.
   pure subroutine close_in(margins, stretch, guess, ends, values, is_converged)
      class(margins_t), intent(in) :: margins
      type(stretch_t), intent(in) :: stretch
      !> A distance from the first end of the stretch to begin with.
      real(dp), intent(in) :: guess
      !> The two positions, with one fold between them.
      real(dp), intent(inout) :: ends(2)
      !> ln(R/2 S) there.
      real(dp), intent(inout) :: values(2)
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

   !> The fold between two positions, by the method of Illinois.
   pure subroutine find_root_between(margins, stretch, ends, at_ends, fold, is_converged)
      class(margins_t), intent(in) :: margins
      type(stretch_t), intent(in) :: stretch
      !> The two positions.
      real(dp), intent(in) :: ends(2)
      !> ln(R/2 S) there, of different signs.
      real(dp), intent(in) :: at_ends(2)
      real(dp), intent(out) :: fold
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

   !> A position between two, at a share of the path, evenly in the logarithm of the distance from an origin.
   pure real(dp) function between(ends, origin, share)
      real(dp), intent(in) :: ends(2), origin
      !> The share, between 0 and 1.
      real(dp), intent(in) :: share

      if (ends(1) > origin) then
         between = origin + (ends(1) - origin)*((ends(2) - origin)/(ends(1) - origin))**share
      else
         between = ends(1) + (ends(2) - ends(1))*share
      end if
   end function between

end module adfric_round_dugdale_stretch

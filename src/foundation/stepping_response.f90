! SPDX-License-Identifier: GPL-3.0-or-later
!> How a period, its edges moving, answers a change of the state and of the penetration; and a proof that there is no other steady
!> state between two.
!>
!> Here the lengths of the dashpots are counted from the penetration, c = e - D, and c falls, or D rises, by small amounts: states
!> are ordered by c, and larger c have more of the period open. With u the amount by which D is smaller, w - D changes by nothing in
!> contact and by the change of m, which is \( \sum k_i \delta c_i/k_g + u/k_g \), in open zones. Edges of contact with adhesion zones
!> add nothing: w does not jump there. Where a free column is attached, or an attached one let go, w jumps; such an edge moves by the
!> change of m over the rate G at which gap and reach meet, and the column is free for so much longer. So a period is linear with a
!> positive matrix, a zone after the other: `get_response`.
!>
!> For two states with the same sequence of zones every state z between them has that sequence, too, because zones of one kind hold
!> each other, and edges between theirs. With the open zones of the upper one and the least rates G between the edges the matrix J bounds
!> \( F(z) - F(z') \le J (z - z') + b u \). If its spectral radius is below 1, steady states at penetrations that differ by u are no
!> more than \( (I - J)^{-1} b u \) apart, and the load between them changes by no less than a slope times u: `bound_response`.
module adfric_foundation_stepping_response
   use adfric_base_kinds, only: dp
   use adfric_foundation_stepping_edge_rates, only: time_of, gap_at, least_rate, rate_difference
   use adfric_foundation_stepping_law, only: stepping_law_t
   use adfric_foundation_stepping_period, only: stepped_period_t, in_contact, in_adhesion, in_free
   use adfric_foundation_stepping_spans, only: span_t, get_response, solve
   use adfric_foundation_stepping_path, only: column_path_t, expm1_of
   use adfric_foundation_stepping_zone_end, only: position_t
   implicit none (type, external)
   private
   public :: get_edge_steps, bound_response

   !> Edges of two states may be in the wrong order by this share of a period, which is round-off.
   real(dp), parameter :: same_time = 1.0e-13_dp
   !> Where gap and reach meet at a smaller rate, in lengths of 1 a period, the edge has no derivative.
   real(dp), parameter :: least_useful_rate = 1.0e-30_dp

contains

   !> Newton's step towards a steady state, and how that changes with the penetration, by the derivative of the period.
   pure subroutine get_edge_steps(path, law, period, step, response, load_step, load_slope, is_solved)
      type(column_path_t), intent(in) :: path
      type(stepping_law_t), intent(in) :: law
      type(stepped_period_t), intent(in) :: period
      !> Receives the step of the lengths e, and their change with the penetration; shape `(n_arms)`.
      real(dp), intent(out) :: step(:), response(:)
      !> Receives by how much the step changes the load, and the slope of the load over the penetration.
      real(dp), intent(out) :: load_step, load_slope
      logical, intent(out) :: is_solved
      type(span_t) :: spans(period%n_zones)
      real(dp) :: growth(path%solid%n, path%solid%n + 1), displacement(path%solid%n + 1), steps(path%solid%n, 2)
      integer :: i

      do i = 1, period%n_zones
         call set_span(path, law, period, i, spans(i), is_solved)
         if (.not. is_solved) return
      end do
      call get_response(path%solid, spans, growth, displacement)
      associate (n => path%solid%n)
         steps(:, 1) = period%growth
         steps(:, 2) = growth(:, n + 1)
         call solve(growth(:, :n), steps, is_solved)
         step = steps(:, 1)
         response = 1 - steps(:, 2)
         load_step = sum(displacement(:n)*step)
         load_slope = 1 - displacement(n + 1) - sum(displacement(:n)*steps(:, 2))
      end associate
   end subroutine get_edge_steps

   !> The span of a zone of one state.
   pure subroutine set_span(path, law, period, i, span, is_set)
      type(column_path_t), intent(in) :: path
      type(stepping_law_t), intent(in) :: law
      type(stepped_period_t), intent(in) :: period
      integer, intent(in) :: i
      type(span_t), intent(out) :: span
      !> Do gap and reach meet at a rate?
      logical, intent(out) :: is_set
      real(dp) :: rate

      is_set = .true.
      associate (zone => period%zones(i))
         span%is_contact = zone%kind == in_contact
         span%duration = zone%duration
         if (.not. lets_jump(period, i)) return
         rate = least_rate(path, zone, period%start(:, i), zone%finish, zone%finish, zone%duration, zone%duration)
         is_set = rate > least_useful_rate
         if (.not. is_set) return
         span%delay = 1/rate
         call get_jumps(law, zone%kind, period%zones(i + 1)%kind, 0.0_dp, span)
      end associate
   end subroutine set_span

   !> Does the displacement jump where a zone ends?
   pure logical function lets_jump(period, i)
      type(stepped_period_t), intent(in) :: period
      integer, intent(in) :: i

      lets_jump = .false.
      if (i == period%n_zones) return
      lets_jump = (period%zones(i)%kind == in_free) .neqv. (period%zones(i + 1)%kind == in_free)
   end function lets_jump

   !> The jumps where a free column is attached or an attached one is let go.
   pure subroutine get_jumps(law, kind, next_kind, excess, span)
      type(stepping_law_t), intent(in) :: law
      !> Kinds of the zones before and behind the edge.
      integer, intent(in) :: kind, next_kind
      !> By how much the gap of the upper state is beyond the reach between the edges of two states.
      real(dp), intent(in) :: excess
      type(span_t), intent(inout) :: span

      if (kind == in_adhesion .or. next_kind == in_adhesion) then
         span%displacement_step = law%drop
      else if (kind == in_contact) then
         span%displacement_step = law%release_reach + excess
      else
         span%displacement_step = law%attach_gap + excess
      end if
      span%target_step = span%displacement_step + law%shift
   end subroutine get_jumps

   !> Look for a proof that two states have no steady one between them, at none of the penetrations between theirs, and bound the slope
   !> of the load over the penetration.
   pure subroutine bound_response(path, law, lower, lower_depth, upper, upper_depth, slope, is_proved)
      type(column_path_t), intent(in) :: path
      type(stepping_law_t), intent(in) :: law
      !> Period of the state with smaller lengths, at the larger penetration.
      type(stepped_period_t), intent(in) :: lower
      !> This penetration.
      real(dp), intent(in) :: lower_depth
      !> Period of the state with larger lengths, at the smaller penetration.
      type(stepped_period_t), intent(in) :: upper
      !> This penetration.
      real(dp), intent(in) :: upper_depth
      !> Receives a lower bound of the slope.
      real(dp), intent(out) :: slope
      logical, intent(out) :: is_proved
      type(span_t) :: spans(lower%n_zones)
      real(dp) :: growth(path%solid%n, path%solid%n + 1), displacement(path%solid%n + 1), distances(path%solid%n, 2), last
      integer :: i

      slope = -huge(1.0_dp)
      is_proved = have_same_zones(lower, upper)
      if (.not. is_proved) return
      last = 0
      do i = 1, lower%n_zones
         call set_common_span(path, law, lower, lower_depth, upper, upper_depth, i, last, spans(i), is_proved)
         if (.not. is_proved) return
      end do
      call get_response(path%solid, spans, growth, displacement)
      associate (n => path%solid%n)
         ! a positive matrix J has a spectral radius below 1 if x = J x + (1, ..., 1) has a positive solution
         distances(:, 1) = 1
         distances(:, 2) = growth(:, n + 1)
         call solve(growth(:, :n), distances, is_proved)
         is_proved = is_proved .and. all(distances(:, 1) > 0)
         if (is_proved) slope = 1 - displacement(n + 1) - sum(displacement(:n)*distances(:, 2))
      end associate
   end subroutine bound_response

   !> Have two periods the same zones?
   pure logical function have_same_zones(lower, upper) result(are_same)
      type(stepped_period_t), intent(in) :: lower, upper

      are_same = lower%n_zones == upper%n_zones .and. lower%is_complete .and. upper%is_complete .and. &
         & (lower%is_attached .eqv. upper%is_attached)
      if (.not. are_same) return
      associate (n => lower%n_zones)
         are_same = all(lower%zones(:n)%kind == upper%zones(:n)%kind)
      end associate
   end function have_same_zones

   !> The span of a zone that two states have in common, and the edges behind it.
   pure subroutine set_common_span(path, law, lower, lower_depth, upper, upper_depth, i, last, span, is_set)
      type(column_path_t), intent(in) :: path
      type(stepping_law_t), intent(in) :: law
      type(stepped_period_t), intent(in) :: lower
      !> Its penetration.
      real(dp), intent(in) :: lower_depth
      type(stepped_period_t), intent(in) :: upper
      !> Its penetration.
      real(dp), intent(in) :: upper_depth
      integer, intent(in) :: i
      !> In: time from which both states are in this zone. Out: from which both are in the next.
      real(dp), intent(inout) :: last
      type(span_t), intent(out) :: span
      !> Are the edges in order, and is there a rate at which gap and reach meet?
      logical, intent(out) :: is_set
      real(dp) :: times(2), first, second
      logical :: is_release

      times = [time_of(path, lower%zones(i)%finish), time_of(path, upper%zones(i)%finish)]
      ! the upper state opens earlier and closes later
      is_release = lower%zones(i)%kind /= in_free
      if (i < lower%n_zones) is_release = is_release .and. lower%zones(i + 1)%kind /= in_contact
      first = minval(times)
      second = maxval(times)
      is_set = first - last > -same_time .and. (merge(times(1) - times(2), times(2) - times(1), is_release) > -same_time)
      if (.not. is_set) return
      span%is_contact = lower%zones(i)%kind == in_contact
      span%duration = max(first - last, 0.0_dp)
      span%crossing = second - first
      if (lets_jump(lower, i)) call set_jump(path, law, lower, lower_depth, upper, upper_depth, i, last, first, second, span, &
         & is_set)
      last = second
   end subroutine set_common_span

   !> The jump behind a zone that two states have in common, with the least rate of all states between them.
   pure subroutine set_jump(path, law, lower, lower_depth, upper, upper_depth, i, last, first, second, span, is_set)
      type(column_path_t), intent(in) :: path
      type(stepping_law_t), intent(in) :: law
      type(stepped_period_t), intent(in) :: lower
      real(dp), intent(in) :: lower_depth
      type(stepped_period_t), intent(in) :: upper
      real(dp), intent(in) :: upper_depth
      integer, intent(in) :: i
      !> Times from which both states are in the zone, one has left it, and both have.
      real(dp), intent(in) :: last, first, second
      type(span_t), intent(inout) :: span
      logical, intent(out) :: is_set
      type(position_t) :: early, late
      real(dp) :: rate, excess, response

      early = lower%zones(i)%finish
      late = upper%zones(i)%finish
      if (span%crossing > 0 .and. time_of(path, early) > time_of(path, late)) then
         early = upper%zones(i)%finish
         late = lower%zones(i)%finish
      end if
      ! the state that is in the zone for longer
      if (lower%zones(i)%kind == in_free) then
         rate = longer_rate(upper)
      else
         rate = longer_rate(lower)
      end if
      rate = rate - rate_difference(path, lower, lower_depth, upper, upper_depth, i, last, first)
      is_set = rate > least_useful_rate
      if (.not. is_set) return
      excess = 0
      if (lower%zones(i)%kind == in_free) then
         excess = gap_at(path, upper, i, early) - upper_depth - law%attach_gap
      else if (lower%zones(i)%kind == in_contact) then
         excess = gap_at(path, upper, i + 1, late) - upper_depth - law%release_reach
      end if
      call get_jumps(law, lower%zones(i)%kind, lower%zones(i + 1)%kind, max(excess, 0.0_dp), span)
      ! between the edges the jump of one arm moves the others
      response = -sum(path%solid%stiffness*expm1_of(-span%crossing/path%solid%time))/path%solid%glassy
      span%displacement_step = span%displacement_step + span%target_step*response/(1 - response)
      span%target_step = span%target_step/(1 - response)
      span%delay = 1/rate

   contains

      !> The least rate of a state that is in the zone for longer.
      pure real(dp) function longer_rate(period)
         type(stepped_period_t), intent(in) :: period
         real(dp) :: begin

         begin = time_of(path, period%zones(i)%start)
         longer_rate = least_rate(path, period%zones(i), period%start(:, i), early, late, first - begin, second - begin)
      end function longer_rate

   end subroutine set_jump

end module adfric_foundation_stepping_response

! SPDX-License-Identifier: GPL-3.0-or-later
!> A column under a law of attraction, in one span of gaps.
!>
!> The Kelvin elements obey \( \lambda_j z_j' = c_j p - z_j \) with \( p = -s(g) \), and the gap follows from the reach
!> \( G = \sum z_j - h \). In a step p is a cubic in time, through Lobatto's four points; what it makes of the elements is exact. So three gaps
!> are the unknowns, whatever the number of arms, and an arm may be far faster or slower than the step: one that is faster follows its rest
!> to the last digit.
!>
!> **No step passes a fold.** Where the slope of the law, -s', is above the relaxed stiffness 1, a gap that is too small grows too small
!> ever faster. With \( r = -s'/(1 + s'/k_g) \) a step is only as long as \( r \sum c_j/(1 + \lambda_j/dt) \le 1 \) at the steepest of its
!> gaps: the rate of growth is no more than 1/dt. Below the relaxed stiffness that holds for any step. The reach of a step is a cubic too,
!> whose Bernstein form must stay in the span, or the step is halved.
module adfric_foundation_stepping_attracted_zone
   use adfric_base_kinds, only: dp
   use adfric_numerics_phi_functions, only: get_exponential_moments
   use adfric_foundation_stepping_attracted_step, only: attracted_step_t, cubic_of, lobatto, points, round_off, set_weights, &
      & step_weights_t, try_step
   use adfric_foundation_stepping_attraction, only: column_attraction_t
   use adfric_foundation_stepping_path, only: column_path_t, expm1_of
   use adfric_foundation_stepping_zone_end, only: position_t, period_over, zone_closes, zone_lets_go
   implicit none (type, external)
   private
   public :: attracted_sums_t, gap_trace_t, pass_attracted_zone, traced_gap

   !> Verdicts on a step, beside how a zone ends.
   integer, parameter :: retry = -1, accept = -2, fold_is_here = -3

   !> The third power in p is so small a part of the largest tension, and what it does to the reach of the range. The error of a step is
   !> far less: a quadratic would have this one.
   real(dp), parameter :: tolerance = 2.0e-6_dp
   !> Mean of what the third power adds to a quadratic through three of the points.
   real(dp), parameter :: share_of_cubic = 0.05_dp
   !> Least part of a piece that a step is, and most steps of a zone for each piece.
   real(dp), parameter :: shortest = 1.0e-100_dp
   integer, parameter :: most_steps = 20000
   !> Towards a fold the gap goes as a root, so that steps end so much before it.
   real(dp), parameter :: share_of_fold = 100
   !> Arms with a longer retardation time, over the step, lose by the four points, others by their exponentials.
   real(dp), parameter :: slow_step = 0.05_dp

   !> Integrals over a zone.
   type :: attracted_sums_t
      !> Of the pressure over time, of the pressure over heights and the size of that, of what the arms lose, and of the displacement.
      real(dp) :: load = 0, work = 0, size_of_work = 0, dissipation = 0, displacement = 0
      !> Time that has passed.
      real(dp) :: duration = 0
   end type attracted_sums_t

   !> Gaps along zones, for profiles.
   type :: gap_trace_t
      !> Number of steps.
      integer :: n = 0
      !> Times where steps begin, their lengths, and the gaps at Lobatto's points; shapes `(n)`, `(n)`, `(0:3, n)`; more may be allocated.
      real(dp), allocatable :: starts(:), lengths(:), gaps(:, :)
   end type gap_trace_t

contains

   !> Pass a zone to the end of the span or of the period.
   pure subroutine pass_attracted_zone(path, attraction, span, depth, position, elements, grown, sums, event, is_found, trace)
      type(column_path_t), intent(in) :: path
      type(column_attraction_t), intent(in) :: attraction
      !> Number of the span.
      integer, intent(in) :: span
      !> Penetration, by which all heights are higher.
      real(dp), intent(in) :: depth
      !> In: where the zone begins. Out: where it ends.
      type(position_t), intent(inout) :: position
      !> In: the Kelvin elements where it begins. Out: where it ends; shape `(n_arms)`.
      real(dp), intent(inout) :: elements(:)
      !> Receives what they have grown by; shape `(n_arms)`.
      real(dp), intent(out) :: grown(:)
      type(attracted_sums_t), intent(out) :: sums
      !> Receives `period_over`, `zone_closes` or `zone_lets_go`.
      integer, intent(out) :: event
      logical, intent(out) :: is_found
      !> Receives the gaps, behind those that it has.
      type(gap_trace_t), intent(inout), optional :: trace
      type(step_weights_t) :: weights
      type(attracted_step_t) :: step
      real(dp) :: length, gap, remaining, within, change(path%solid%n)
      integer :: k, verdict

      grown = 0
      event = period_over
      is_found = .true.
      allocate (weights%lost(path%solid%n, 3), weights%forced(path%solid%n, 3, 0:3))
      within = round_off*(1 + abs(depth) + attraction%law%stress)
      gap = attraction%gap_at(span, sum(elements) - depth - local_height(path, position))
      length = 1
      do k = 1, most_steps + 20*path%n
         if (position%theta >= 1) position = position_t(position%piece + 1, 0.0_dp)
         if (position%piece > path%n) return
         remaining = 1 - position%theta
         step%length = min(length, remaining)
         if (step%length < remaining .and. remaining < 2*step%length) step%length = remaining/2
         if (abs(step%length - weights%length) > 0) call set_weights(path, step%length, weights)
         call try_step(path, attraction, span, depth, position, elements, gap, weights, step)
         call judge(path, attraction, span, within, step, length, verdict)
         if (verdict == fold_is_here) event = zone_closes
         if (verdict == fold_is_here) return
         if (verdict == retry) then
            if (length < shortest) exit
            cycle
         end if
         call change_of(path, weights, elements, step, change)
         call add_sums(path, weights, elements, depth, step, sums)
         if (present(trace)) call add_to_trace(trace, (position%piece - 1 + position%theta)*path%step, &
            & step%length*path%step, step%gaps)
         elements = elements + change
         grown = grown + change
         gap = step%gaps(3)
         if (step%length >= remaining) then
            position%theta = 1
         else
            position%theta = position%theta + step%length
         end if
         if (verdict == accept) cycle
         event = verdict
         if (position%piece == path%n .and. position%theta >= 1) event = period_over
         return
      end do
      is_found = .false.
   end subroutine pass_attracted_zone

   !> Height at a position, without the penetration.
   pure real(dp) function local_height(path, position) result(height)
      type(column_path_t), intent(in) :: path
      type(position_t), intent(in) :: position
      integer :: m

      height = 0
      if (position%piece > path%n) return
      do m = path%degree, 0, -1
         height = height*position%theta + path%coefficients(m, position%piece)
      end do
   end function local_height

   !> Is a step good, and does it end the zone? Else a shorter one is tried.
   pure subroutine judge(path, attraction, span, within, step, length, verdict)
      type(column_path_t), intent(in) :: path
      type(column_attraction_t), intent(in) :: attraction
      integer, intent(in) :: span
      !> Lengths that are nothing.
      real(dp), intent(in) :: within
      type(attracted_step_t), intent(in) :: step
      !> In: length that was asked for. Out: length of the next step, or of the next attempt.
      real(dp), intent(inout) :: length
      !> Receives `retry`, `accept`, `zone_closes` or `zone_lets_go`.
      integer, intent(out) :: verdict
      real(dp) :: error, factor, cubic(0:3), first, last, low, high

      verdict = retry
      associate (s => attraction%spans(span), reaches => step%reaches)
         if (.not. is_sound(path, attraction, span, step)) then
            length = step%length/2
            if (is_fold(attraction, span) .and. reaches(0) - s%low_reach <= share_of_fold*within) verdict = fold_is_here
            return
         end if
         error = abs(step%pressure(3))*share_of_cubic*max(1/attraction%law%stress, &
            & sum(path%solid%compliance*(-expm1_of(-step%length*path%open_ratio)))/min(1.0_dp, attraction%law%range))/tolerance
         factor = 0.9_dp*max(error, 1.0e-4_dp)**(-1.0_dp/3)
         if (error > 1) then
            length = step%length*max(0.2_dp, factor)
            return
         end if
         ! a zone may begin beyond an end by what its beginning is not known by
         low = min(s%low_reach, reaches(0)) - within
         high = max(s%high_reach, reaches(0)) + within
         if (reaches(3) < low) then
            first = max(reaches(0) - s%low_reach, 0.0_dp)
            last = reaches(3) - s%low_reach
            length = step%length*min(0.999_dp, max(0.1_dp, first/(first - last)))
            return
         end if
         if (reaches(3) > high) then
            first = max(s%high_reach - reaches(0), 0.0_dp)
            last = s%high_reach - reaches(3)
            length = step%length*min(0.999_dp, max(0.1_dp, first/(first - last)))
            return
         end if
         ! the reach lies within the Bernstein form of its cubic
         cubic = cubic_of(reaches)
         cubic = [cubic(0), cubic(0) + cubic(1)/3, cubic(0) + 2*cubic(1)/3 + cubic(2)/3, reaches(3)]
         if (minval(cubic) < low .or. maxval(cubic) > high) then
            length = step%length/2
            return
         end if
         verdict = accept
         if (reaches(3) - s%low_reach <= within .and. reaches(3) < reaches(0)) verdict = zone_closes
         if (s%high_reach - reaches(3) <= within .and. reaches(3) > reaches(0)) verdict = zone_lets_go
         if (factor > 1.3_dp) then
            length = min(1.0_dp, max(length, step%length*min(2.0_dp, factor)))
         else if (factor < 1) then
            length = step%length*factor
         end if
      end associate
   end subroutine judge

   !> Does a span begin where the left side is flat?
   pure logical function is_fold(attraction, span)
      type(column_attraction_t), intent(in) :: attraction
      integer, intent(in) :: span

      is_fold = .not. attraction%spans(span)%is_straight .and. attraction%spans(span)%low_gap > 0
   end function is_fold

   !> Is there a solution in the span, and does nothing grow by much within the step?
   pure logical function is_sound(path, attraction, span, step)
      type(column_path_t), intent(in) :: path
      type(column_attraction_t), intent(in) :: attraction
      integer, intent(in) :: span
      type(attracted_step_t), intent(in) :: step
      real(dp), parameter :: least_part = 1.0e-8_dp
      real(dp) :: steepest, ratios(path%solid%n)

      is_sound = step%is_solved
      if (.not. is_sound) return
      ! beyond a fold the left side falls
      if (is_fold(attraction, span)) is_sound = .not. any(step%gaps < attraction%spans(span)%low_gap)
      steepest = -minval(step%slopes)
      if (.not. is_sound .or. .not. steepest > 1) return
      ratios = step%length*path%open_ratio
      is_sound = steepest/max(1 - steepest/attraction%glassy, least_part)*sum(path%solid%compliance*ratios/(1 + ratios)) <= 1
   end function is_sound

   !> Change of the elements in a step.
   pure subroutine change_of(path, weights, elements, step, change)
      type(column_path_t), intent(in) :: path
      type(step_weights_t), intent(in) :: weights
      !> The elements where it begins; shape `(n_arms)`.
      real(dp), intent(in) :: elements(:)
      type(attracted_step_t), intent(in) :: step
      !> Receives the change; shape `(n_arms)`.
      real(dp), intent(out) :: change(:)
      integer :: m

      change = elements*weights%lost(:, 3)
      do m = 0, 3
         change = change + path%solid%compliance*weights%forced(:, 3, m)*step%pressure(m)
      end do
   end subroutine change_of

   !> Add a step to the integrals.
   pure subroutine add_sums(path, weights, elements, depth, step, sums)
      type(column_path_t), intent(in) :: path
      type(step_weights_t), intent(in) :: weights
      !> The elements where it begins; shape `(n_arms)`.
      real(dp), intent(in) :: elements(:)
      real(dp), intent(in) :: depth
      type(attracted_step_t), intent(in) :: step
      type(attracted_sums_t), intent(inout) :: sums
      real(dp) :: time, work, stretch(0:3), slopes(0:3), compliance, ratio
      integer :: j, k

      time = step%length*path%step
      slopes = 0
      do k = path%degree, 1, -1
         slopes = k*step%rise(k) + points*slopes
      end do
      work = -sum(lobatto*step%tensions*slopes)
      sums%duration = sums%duration + time
      sums%load = sums%load - time*sum(lobatto*step%tensions)
      sums%work = sums%work + work
      sums%size_of_work = sums%size_of_work + abs(work)
      sums%displacement = sums%displacement + time*(depth + sum(lobatto*(step%heights + step%gaps)))
      do j = 1, path%solid%n
         compliance = path%solid%compliance(j)
         if (.not. compliance > 0) cycle
         ratio = step%length*path%open_ratio(j)
         stretch(0) = elements(j) - compliance*step%pressure(0)
         if (ratio < slow_step) then
            do k = 1, 3
               stretch(k) = elements(j)*(1 + weights%lost(j, k)) + compliance*(sum(weights%forced(j, k, :)*step%pressure) &
                  & + step%tensions(k))
            end do
            sums%dissipation = sums%dissipation + ratio/compliance*sum(lobatto*stretch**2)
         else
            sums%dissipation = sums%dissipation + ratio/compliance*square_of(ratio, compliance, step%pressure, stretch(0))
         end if
      end do
   end subroutine add_sums

   !> Integral over a step of the square of an element less its rest.
   pure real(dp) function square_of(ratio, compliance, pressure, first) result(square)
      !> Step over retardation time.
      real(dp), intent(in) :: ratio
      real(dp), intent(in) :: compliance
      !> Powers of the pressure; shape `(0:3)`.
      real(dp), intent(in) :: pressure(0:)
      !> What the element has beyond its rest where the step begins.
      real(dp), intent(in) :: first
      real(dp) :: b(0:2), chi(0:2), amplitude
      integer :: l, m

      ! y + y'/ratio = -c p'/ratio: a quadratic, and what decays
      b(2) = -3*compliance*pressure(3)/ratio
      b(1) = -(2*compliance*pressure(2) + 2*b(2))/ratio
      b(0) = -(compliance*pressure(1) + b(1))/ratio
      amplitude = first - b(0)
      call get_exponential_moments(ratio, chi)
      square = -amplitude**2*expm1_of(-2*ratio)/(2*ratio) + 2*amplitude*sum(b*chi)
      do m = 0, 2
         do l = 0, 2
            square = square + b(m)*b(l)/(m + l + 1)
         end do
      end do
   end function square_of

   !> Add a step to a trace.
   pure subroutine add_to_trace(trace, start, length, gaps)
      type(gap_trace_t), intent(inout) :: trace
      !> Time where it begins, and its length.
      real(dp), intent(in) :: start, length
      !> Gaps at Lobatto's points; shape `(0:3)`.
      real(dp), intent(in) :: gaps(0:)
      integer, parameter :: first_space = 256
      real(dp), allocatable :: starts(:), lengths(:), all_gaps(:, :)

      if (.not. allocated(trace%starts)) allocate (trace%starts(first_space), trace%lengths(first_space), &
         & trace%gaps(0:3, first_space))
      if (trace%n == size(trace%starts)) then
         allocate (starts(2*trace%n), lengths(2*trace%n), all_gaps(0:3, 2*trace%n))
         starts(:trace%n) = trace%starts
         lengths(:trace%n) = trace%lengths
         all_gaps(:, :trace%n) = trace%gaps
         call move_alloc(starts, trace%starts)
         call move_alloc(lengths, trace%lengths)
         call move_alloc(all_gaps, trace%gaps)
      end if
      trace%n = trace%n + 1
      trace%starts(trace%n) = start
      trace%lengths(trace%n) = length
      trace%gaps(:, trace%n) = gaps
   end subroutine add_to_trace

   !> The gap at a time of a trace; negative where no step has it.
   pure real(dp) function traced_gap(trace, time) result(gap)
      type(gap_trace_t), intent(in) :: trace
      real(dp), intent(in) :: time
      real(dp) :: cubic(0:3), theta
      integer :: low, high, middle

      gap = -1
      if (trace%n == 0) return
      low = 1
      high = trace%n + 1
      do while (high - low > 1)
         middle = (low + high)/2
         if (trace%starts(middle) <= time) then
            low = middle
         else
            high = middle
         end if
      end do
      cubic = cubic_of(trace%gaps(:, low))
      theta = min(1.0_dp, max(0.0_dp, (time - trace%starts(low))/max(trace%lengths(low), tiny(time))))
      gap = max(0.0_dp, cubic(0) + theta*(cubic(1) + theta*(cubic(2) + theta*cubic(3))))
   end function traced_gap

end module adfric_foundation_stepping_attracted_zone

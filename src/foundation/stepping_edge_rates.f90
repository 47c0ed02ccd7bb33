! SPDX-License-Identifier: GPL-3.0-or-later
!> The rates at which gap and reach meet where a free column is attached or an attached one let go, for one state and for all between two.
module adfric_foundation_stepping_edge_rates
   use adfric_base_kinds, only: dp
   use adfric_foundation_stepping_period, only: stepped_period_t, zone_t, in_contact, in_adhesion
   use adfric_foundation_stepping_solid, only: product_of
   use adfric_foundation_stepping_path, only: column_path_t, decay_of, height_at, steepness_at, stretches_at
   use adfric_foundation_stepping_zone_end, only: position_t
   implicit none (type, external)
   private
   public :: time_of, gap_at, least_rate, rate_difference

   !> Edges of two states are closer than so many pieces.
   integer, parameter :: most_pieces = 16

contains

   !> Time of a position.
   pure real(dp) function time_of(path, position) result(time)
      type(column_path_t), intent(in) :: path
      type(position_t), intent(in) :: position

      time = ((position%piece - 1) + position%theta)*path%step
   end function time_of

   !> Gap of a free column, without the penetration.
   pure real(dp) function gap_at(path, period, i, position) result(gap)
      type(column_path_t), intent(in) :: path
      type(stepped_period_t), intent(in) :: period
      !> Number of the free zone.
      integer, intent(in) :: i
      type(position_t), intent(in) :: position
      real(dp) :: passed

      passed = time_of(path, position) - time_of(path, period%zones(i)%start)
      gap = sum(period%start(:, i)*decay_of(passed/path%solid%retardation)) - height_at(path, position%piece, position%theta)
   end function gap_at

   !> A lower bound of the rate at which m of a state and the surface meet (free) or part (else), between two positions of a zone or
   !> behind it; negative where these are too far apart for one of use.
   pure real(dp) function least_rate(path, zone, start, early, late, first, second) result(rate)
      type(column_path_t), intent(in) :: path
      type(zone_t), intent(in) :: zone
      !> What it begins with: stretches less those of endless contact, or Kelvin elements; shape `(n_arms)`.
      real(dp), intent(in) :: start(:)
      type(position_t), intent(in) :: early, late
      !> Their times since the zone began.
      real(dp), intent(in) :: first, second
      real(dp) :: lowest, highest
      real(dp), dimension(path%solid%n) :: stretch, growth, remaining

      rate = -1
      if (late%piece - early%piece >= most_pieces) return
      call bound_steepness(path, early, late, lowest, highest)
      associate (s => path%solid)
         select case (zone%kind)
         case (in_contact)
            call stretches_at(path, early%piece, early%theta, stretch, growth)
            stretch = stretch + start*decay_of(first/s%time)
            remaining = decay_of((second - first)/s%time)
            ! a stretch goes from here to where the least steepness would leave it
            rate = sum(s%stiffness/s%time*min(stretch, stretch*remaining + lowest*s%time*(1 - remaining)))/s%glassy - highest
         case (in_adhesion)
            rate = sum(min(-start*decay_of(first/s%retardation), -start*decay_of(second/s%retardation))/s%retardation) - highest
         case default
            rate = lowest + sum(min(start*decay_of(first/s%retardation), start*decay_of(second/s%retardation))/s%retardation)
         end select
      end associate
   end function least_rate

   !> Bounds of the derivative of the heights over time between two positions.
   pure subroutine bound_steepness(path, early, late, lowest, highest)
      type(column_path_t), intent(in) :: path
      type(position_t), intent(in) :: early, late
      !> Receives the bounds.
      real(dp), intent(out) :: lowest, highest
      real(dp) :: from, to, middle, half
      integer :: j, m

      lowest = huge(1.0_dp)
      highest = -huge(1.0_dp)
      do j = early%piece, late%piece
         from = merge(early%theta, 0.0_dp, j == early%piece)
         to = merge(late%theta, 1.0_dp, j == late%piece)
         middle = steepness_at(path, j, (from + to)/2)
         half = sum([(m*(m - 1)*abs(path%coefficients(m, j)), m=2, path%degree)])*max(to - from, 0.0_dp)/2
         lowest = min(lowest, (middle - half)/path%step)
         highest = max(highest, (middle + half)/path%step)
      end do
   end subroutine bound_steepness

   !> By how much the rates of states between two differ at most from the rate of one of the two, where one leaves a zone.
   pure real(dp) function rate_difference(path, lower, lower_depth, upper, upper_depth, i, last, first) result(difference)
      type(column_path_t), intent(in) :: path
      type(stepped_period_t), intent(in) :: lower
      !> Its penetration.
      real(dp), intent(in) :: lower_depth
      type(stepped_period_t), intent(in) :: upper
      !> Its penetration.
      real(dp), intent(in) :: upper_depth
      integer, intent(in) :: i
      !> Times from which both are in the zone, and one has left it.
      real(dp), intent(in) :: last, first
      real(dp) :: lengths(path%solid%n), states(path%solid%n, 2)

      associate (s => path%solid)
         if (lower%zones(i)%kind == in_contact) then
            call get_states(s%time, states)
            lengths = abs(states(:, 1) - states(:, 2))
            difference = sum(s%stiffness/s%time*lengths*decay_of((first - last)/s%time))/s%glassy
         else
            call get_states(s%retardation, states)
            lengths = product_of(s%lengths_of_elements, states(:, 2) - states(:, 1))
            lengths = max(abs(lengths + (lower_depth - upper_depth)), lower_depth - upper_depth)
            difference = sum(product_of(abs(s%elements_of_lengths), lengths)/s%retardation*decay_of((first - last)/s%retardation))
         end if
      end associate

   contains

      !> What decays in the zone, at the time from which both states are in it.
      pure subroutine get_states(times, states)
         !> Times with which it decays; shape `(n_arms)`.
         real(dp), intent(in) :: times(:)
         !> Receives those of the lower and of the upper state; shape `(n_arms, 2)`.
         real(dp), intent(out) :: states(:, :)

         states(:, 1) = lower%start(:, i)*decay_of((last - time_of(path, lower%zones(i)%start))/times)
         states(:, 2) = upper%start(:, i)*decay_of((last - time_of(path, upper%zones(i)%start))/times)
      end subroutine get_states

   end function rate_difference

end module adfric_foundation_stepping_edge_rates

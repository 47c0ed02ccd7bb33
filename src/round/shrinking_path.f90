! SPDX-License-Identifier: GPL-3.0-or-later
!> The path from rest to sliding of a contact that shrinks as slip takes from its adhesion, and its first state with a force or a
!> displacement.
!>
!> With b the radius up to which friction acts, K its demand, and th the angle of its slip annulus (`adfric_round_slip_annulus`),
!>
!>     T = T0 b^2 (2/pi) (th + sin th cos th),   u = u0 b sin th,   th sin th + cos th - 1 = g/(K b)
!>
!> g is the position on the path: as it grows b falls. **The state of a force T.** At a g the contact of radius b(g) bears T at an
!> angle th, and then slips by as much as the demand D(g) = K b (th sin th + cos th - 1). States of this force are where D(g) = g.
!> As g grows b falls, th rises, and so does D, for d(ln D)/d(ln b) = 1 - th (th + sin th cos th)/(cos th (th sin th + cos th - 1)),
!> which is at most -3; for a displacement u it is -(1 - cos th)/(th sin th + cos th - 1), at most -1. So g <- D(g), from g = 0,
!> rises to the first state, the one that a growing force reaches, and **passes none**: where g < D(g), there is no state between.
!> If b(g) cannot bear T, or D(g) is beyond the last contact, no g has the state. Several states may have a force; where the first
!> one has gone the surfaces jump to the next, so the first one is that of the largest force so far.
!>
!> Steps below 1 % are made 1 %: then a change of sign of ln D - ln g, or its least value where it turns, shows a state.
module adfric_round_shrinking_path
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi
   use adfric_round_slip_annulus, only: angle_of_force, angle_of_slip, force_of_angle, largest_slip_core, slip_of_angle
   implicit none (type, external)
   private
   public :: shrinking_path_t, slip_state_t, demand_up_to, find_first, turn, turn_to, force_of, displacement_of
   public :: first_force, first_displacement, first_core

   !> A state on a path.
   type :: slip_state_t
      !> Is there contact?
      logical :: is_found = .false.
      !> g, X, b.
      real(dp) :: slip_energy = 0, ratio = 1, radius = 0
      !> Slip core, which passes its largest value where e would be below 0, and th.
      real(dp) :: core = 0, angle = 0
   end type slip_state_t

   !> A path.
   type, abstract :: shrinking_path_t
      !> Does slip take anything from adhesion? Otherwise the contact stays as it is at rest.
      logical :: is_weakened = .false.
      !> K; the largest number without adhesion.
      real(dp) :: demand = huge(1.0_dp)
      !> T0 and u0: the force of sliding over b^2, and its displacement over b.
      real(dp) :: force_scale = 1, displacement_scale = 1
      !> The g from which on slip takes no more from adhesion, and the one where nothing is left of it.
      real(dp) :: slip_energy_ratio = huge(1.0_dp), limit = huge(1.0_dp)
   contains
      procedure(get_state_i), deferred :: get_state
   end type shrinking_path_t

   abstract interface

      !> The state of a g.
      pure subroutine get_state_i(self, slip_energy, state, rate)
         import :: shrinking_path_t, slip_state_t, dp
         implicit none (type, external)
         !> The path, which is followed up to there.
         class(shrinking_path_t), intent(inout) :: self
         !> g, from 0 to the smaller of its two limits.
         real(dp), intent(in) :: slip_energy
         !> Receives the state; not found where the contact has been lost.
         type(slip_state_t), intent(out) :: state
         !> Receives d ln T/d ln g, if it is asked for; enormous and below 0 beyond the last contact.
         real(dp), intent(out), optional :: rate
      end subroutine get_state_i

   end interface

   !> What a first state is to have; `first_core` is the root of its slip core.
   integer, parameter :: first_force = 1, first_displacement = 2, first_core = 3
   !> Smallest step of ln g.
   real(dp), parameter :: least_step = 0.01_dp
   !> A step of ln g that is round-off.
   real(dp), parameter :: round_off = 8*epsilon(1.0_dp)

contains

   !> The state of an unchanged contact at another angle.
   pure subroutine turn(angle, state)
      !> th, 0 to pi/2.
      real(dp), intent(in) :: angle
      !> In: a state. Out: with this angle and its slip core.
      class(slip_state_t), intent(inout) :: state

      state%angle = angle
      state%core = largest_slip_core
      if (angle < half_pi) state%core = slip_of_angle(angle)
   end subroutine turn

   !> T.
   pure real(dp) function force_of(path, state) result(force)
      class(shrinking_path_t), intent(in) :: path
      class(slip_state_t), intent(in) :: state

      force = path%force_scale*state%radius**2*force_of_angle(state%angle)
   end function force_of

   !> u.
   pure real(dp) function displacement_of(path, state) result(displacement)
      class(shrinking_path_t), intent(in) :: path
      class(slip_state_t), intent(in) :: state

      displacement = path%displacement_scale*state%radius*sin(state%angle)
   end function displacement_of

   !> Turn a state to a force, a displacement or a slip core; not found if its contact does not bear it.
   pure subroutine turn_to(path, quantity, value, state)
      class(shrinking_path_t), intent(in) :: path
      !> One of `first_...`.
      integer, intent(in) :: quantity
      !> Its value, > 0.
      real(dp), intent(in) :: value
      !> In: a state that is found. Out: with the angle.
      class(slip_state_t), intent(inout) :: state
      real(dp) :: largest, share

      select case (quantity)
      case (first_force)
         largest = path%force_scale*state%radius**2
      case (first_displacement)
         largest = path%displacement_scale*state%radius
      case default
         largest = sqrt(largest_slip_core)
      end select
      state%is_found = value <= (1 + round_off/2)*largest
      if (.not. state%is_found) return
      share = min(value/largest, 1.0_dp)
      select case (quantity)
      case (first_force)
         call turn(angle_of_force(share), state)
      case (first_displacement)
         call turn(asin(share), state)
      case default
         call turn(angle_of_slip(min(value**2, largest_slip_core)), state)
      end select
   end subroutine turn_to

   !> ln of the demand over g at a g.
   pure subroutine get_demand(path, quantity, value, slip_energy, excess, state)
      class(shrinking_path_t), intent(inout) :: path
      integer, intent(in) :: quantity
      !> T or u, > 0.
      real(dp), intent(in) :: value
      !> g > 0.
      real(dp), intent(in) :: slip_energy
      !> Receives ln(D/g).
      real(dp), intent(out) :: excess
      !> Receives the state with the angle of the value; not found where the contact is lost, or does not bear it.
      type(slip_state_t), intent(out) :: state

      call path%get_state(slip_energy, state)
      excess = huge(excess)
      if (state%is_found) call turn_to(path, quantity, value, state)
      if (state%is_found) excess = log(path%demand*state%radius*state%core/slip_energy)
   end subroutine get_demand

   !> The demand K b core, or a limit if that is smaller; without adhesion the demand is beyond all numbers.
   pure real(dp) function demand_up_to(path, radius, core, limit) result(slip_energy)
      class(shrinking_path_t), intent(in) :: path
      !> b, and the slip core, from 0 to twice its largest value.
      real(dp), intent(in) :: radius, core
      !> The largest g to be looked at.
      real(dp), intent(in) :: limit

      slip_energy = limit
      if (path%demand > 1) then
         if (radius*core >= limit/path%demand) return
      end if
      slip_energy = min(path%demand*radius*core, limit)
   end function demand_up_to

   !> The first state with a force or a displacement; not found if that is not reached before sliding.
   pure subroutine find_first(path, quantity, value, start, state, is_converged)
      class(shrinking_path_t), intent(inout) :: path
      integer, intent(in) :: quantity
      real(dp), intent(in) :: value
      type(slip_state_t), intent(in) :: start
      type(slip_state_t), intent(out) :: state
      logical, intent(out) :: is_converged
      integer, parameter :: most_steps = 20000
      type(slip_state_t) :: found
      real(dp) :: g, cap, before, at_before, earlier, at_earlier, excess, step, turning
      integer :: k
      logical :: is_certain

      is_converged = .true.
      state = start
      call turn_to(path, quantity, value, state)
      if (.not. state%is_found) return
      cap = min(path%slip_energy_ratio, path%limit)
      state%slip_energy = demand_up_to(path, state%radius, state%core, path%slip_energy_ratio)
      g = demand_up_to(path, state%radius, state%core, cap)
      ! a slip energy below all numbers takes nothing from adhesion
      if (.not. (path%is_weakened .and. g > 0)) return
      before = 0
      at_before = huge(excess)
      earlier = 0
      at_earlier = huge(excess)
      is_certain = .true.
      do k = 1, most_steps
         call get_demand(path, quantity, value, g, excess, found)
         if (.not. found%is_found) then
            state%is_found = .false.
            ! a step that was not certain may have passed a state
            if (is_certain .or. g - before <= round_off*g) then
               if (.not. earlier > 0) return
               if (log(before/earlier) <= at_earlier) return
               ! so may the step before
               call find_turn(path, quantity, value, earlier, g, turning, is_certain)
               if (is_certain) call find_between(path, quantity, value, earlier, turning, state, is_converged)
               return
            end if
            step = log(g/before)/4
            is_certain = at_before >= step
            g = before*exp(max(at_before, step))
            cycle
         end if
         state = found
         if (g >= cap .and. excess >= 0) then
            ! slip takes no more, or there is nothing left to take
            state%is_found = path%slip_energy_ratio <= path%limit
            return
         end if
         if (abs(excess) <= round_off .or. (excess < 0 .and. .not. before > 0)) return
         if (excess < 0) then
            call find_between(path, quantity, value, before, g, state, is_converged)
            return
         end if
         if (at_before < at_earlier .and. at_before < min(excess, least_step)) then
            call find_turn(path, quantity, value, earlier, g, turning, is_certain)
            if (is_certain) then
               call find_between(path, quantity, value, earlier, turning, state, is_converged)
               return
            end if
         end if
         earlier = before
         at_earlier = at_before
         before = g
         at_before = excess
         step = least_step
         is_certain = excess >= step
         g = min(g*exp(max(excess, step)), cap)
      end do
      is_converged = .false.
   end subroutine find_first

   !> Between two g of which the first has a larger demand and the second a smaller one: the state, by the method of Illinois.
   pure subroutine find_between(path, quantity, value, first, last, state, is_converged)
      class(shrinking_path_t), intent(inout) :: path
      integer, intent(in) :: quantity
      real(dp), intent(in) :: value
      !> The two g, > 0.
      real(dp), intent(in) :: first, last
      type(slip_state_t), intent(out) :: state
      logical, intent(out) :: is_converged
      integer, parameter :: most_steps = 100
      real(dp) :: low, high, at_low, at_high, width, g, excess
      integer :: k, side

      low = first
      high = last
      call get_demand(path, quantity, value, low, at_low, state)
      call get_demand(path, quantity, value, high, at_high, state)
      side = 0
      is_converged = .true.
      do k = 1, most_steps
         width = log(high/low)
         if (width <= round_off) return
         g = low*exp(width*(at_low/(at_low - at_high)))
         if (.not. (g > low .and. g < high)) g = low*exp(width/2)
         call get_demand(path, quantity, value, g, excess, state)
         is_converged = state%is_found
         if (.not. is_converged .or. abs(excess) <= round_off) return
         if (excess > 0) then
            low = g
            at_low = excess
            if (side == 1) at_high = at_high/2
            side = 1
         else
            high = g
            at_high = excess
            if (side == 2) at_low = at_low/2
            side = 2
         end if
      end do
      is_converged = .false.
   end subroutine find_between

   !> Where the demand over g is least between two g, by the golden section; the search ends where the demand is less than g.
   pure subroutine find_turn(path, quantity, value, first, last, position, is_found)
      class(shrinking_path_t), intent(inout) :: path
      integer, intent(in) :: quantity
      real(dp), intent(in) :: value
      !> The two g.
      real(dp), intent(in) :: first, last
      !> Receives a g with a smaller demand.
      real(dp), intent(out) :: position
      logical, intent(out) :: is_found
      real(dp), parameter :: golden = 0.6180339887498949_dp
      integer, parameter :: most_steps = 45
      type(slip_state_t) :: state
      real(dp) :: low, high, positions(2), values(2)
      integer :: k, new

      low = log(first)
      high = log(last)
      positions = [high - golden*(high - low), low + golden*(high - low)]
      values = huge(low)
      new = 0
      position = first
      do k = 1, most_steps
         if (new /= 2) call get_demand(path, quantity, value, exp(positions(1)), values(1), state)
         if (new /= 1) call get_demand(path, quantity, value, exp(positions(2)), values(2), state)
         is_found = any(values < 0)
         position = exp(positions(minloc(values, 1)))
         if (is_found) return
         if (values(1) < values(2) .or. .not. values(2) < huge(low)) then
            high = positions(2)
            positions = [high - golden*(high - low), positions(1)]
            values(2) = values(1)
            new = 1
         else
            low = positions(1)
            positions = [positions(2), low + golden*(high - low)]
            values(1) = values(2)
            new = 2
         end if
      end do
   end subroutine find_turn

end module adfric_round_shrinking_path

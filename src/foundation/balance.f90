! SPDX-License-Identifier: GPL-3.0-or-later
!> Forces of one strip, its dissipation, and the balances that check both.
!>
!> Everything is in closed form. Friction is the integral of the tractions; dissipation that of the stress
!> \( q = p - w \) in the Maxwell arm. The two meet only in the energy balance, which so checks every digit.
module adfric_foundation_balance
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, two_pi
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   use adfric_numerics_trigonometry, only: angle_minus_sine
   use adfric_foundation_adhesion, only: edge_work
   use adfric_foundation_contact_zone, only: decay
   use adfric_foundation_edge_equations, only: get_edge_rates, get_adhesion_rate
   use adfric_foundation_strip, only: strip_t, profile, lifted_profile, steady_state_t, regime_adhesion_only, regime_discrete, &
      & regime_saturated_adhesion, regime_adhesion_zones, regime_saturated
   implicit none (type, external)
   private
   public :: balance_t, get_balance, get_load_slope, get_slope_bound

   !> Integrals over the phase of one period, in units of the strip (c for lengths, c/K for stresses).
   type :: balance_t
      !> Integral of the pressure.
      real(dp) :: load = 0
      !> Integral of -p F', positive against the motion.
      real(dp) :: friction = 0
      !> Phases in contact and in adhesion [rad].
      real(dp) :: contact = 0, adhesion = 0
      !> Energy lost in the Maxwell arm, integral of q^2/(u (beta - 1)).
      real(dp) :: dissipation = 0
      !> Energy lost where the adhesion stress starts and ends; with continuous edges the term by which
      !> the rule itself violates the balance.
      real(dp) :: edge_loss = 0
      !> Integral of w - p, which is zero.
      real(dp) :: load_mismatch = 0
      !> Sum of the sizes of the terms of load and friction: what round-off is relative to.
      real(dp) :: load_scale = 0, friction_scale = 0
   end type balance_t

   !> A closed form that is smaller than this share of its terms has lost too many digits.
   real(dp), parameter :: cancelled = 1.0e-2_dp

   !> Integrals of powers of the Maxwell stress and of the displacement, gathered zone by zone.
   type :: sums_t
      !> Integrals over the phase of the displacement, and of the square of the Maxwell stress.
      real(dp) :: displacement = 0, square = 0
   end type sums_t

contains

   !> Balance of a steady state.
   pure subroutine get_balance(strip, state, balance)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      !> Forces, zones, losses and mismatches of the strip, per period.
      type(balance_t), intent(out) :: balance

      select case (state%regime)
      case (regime_saturated)
         call balance_saturated(strip, balance)
      case (regime_discrete, regime_saturated_adhesion, regime_adhesion_zones)
         call balance_contact(strip, state, balance)
      case (regime_adhesion_only)
         call balance_adhesion_only(strip, state, balance)
      case default
         continue
      end select
   end subroutine get_balance

   !> Contact everywhere (GM 17, with the factor that the print has lost).
   pure subroutine balance_saturated(strip, balance)
      type(strip_t), intent(in) :: strip
      !> Receives the integrals of endless contact.
      type(balance_t), intent(inout) :: balance

      associate (f => strip%foundation)
         balance%load = two_pi*strip%mean
         balance%friction = pi*f%loss
         balance%contact = two_pi
         balance%load_scale = two_pi*(abs(strip%crest) + 1)
         balance%friction_scale = balance%friction
         ! q = loss (sin + u cos), and loss (1 + u^2)/u = beta - 1
         balance%dissipation = pi*f%loss
      end associate
   end subroutine balance_saturated

   !> Discrete contact, with whatever zones there are beside it.
   pure subroutine balance_contact(strip, state, balance)
      type(strip_t), intent(in) :: strip
      !> Steady state with contact, with adhesion zones or without.
      type(steady_state_t), intent(in) :: state
      !> Receives the integrals over the period.
      type(balance_t), intent(inout) :: balance
      type(sums_t) :: sums
      real(dp) :: a, b, trailing, free, w, gap_sum

      a = state%half_width - state%shift
      b = state%half_width + state%shift
      trailing = state%trailing
      if (state%regime /= regime_adhesion_zones) trailing = two_pi - 2*state%half_width
      balance%contact = 2*state%half_width
      balance%adhesion = trailing + state%leading
      free = two_pi - balance%contact - balance%adhesion

      call add_contact(strip, state, sums, balance)
      w = lifted_profile(strip, a)
      call add_open_zone(strip, w, trailing, -strip%adhesion%stress, sums)
      if (state%regime == regime_adhesion_zones) then
         gap_sum = 2*sin(free/2)*sin(state%outer_shift)
         balance%friction = balance%friction - strip%adhesion%stress*gap_sum
         balance%friction_scale = balance%friction_scale + abs(strip%adhesion%stress*gap_sum)
         w = profile(strip, a + trailing) + strip%adhesion%release_gap + strip%adhesion%jump
         call add_open_zone(strip, w, free, 0.0_dp, sums)
         call add_edge_loss(strip, state, w, balance)
         if (.not. state%entry > 0) then
            w = lifted_profile(strip, b + state%leading) + strip%adhesion%attach_gap - strip%adhesion%jump
            call add_open_zone(strip, w, state%leading, -strip%adhesion%stress, sums)
         end if
      end if
      call finish(strip, sums, balance)
      if (.not. strip%adhesion%stress > 0) balance%adhesion = 0
   end subroutine balance_contact

   !> Adhesion without contact: everywhere, or in one zone.
   pure subroutine balance_adhesion_only(strip, state, balance)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      type(balance_t), intent(inout) :: balance
      type(sums_t) :: sums
      real(dp) :: a, b, change, w

      a = state%half_width - state%shift
      b = state%half_width + state%shift
      balance%adhesion = 2*state%half_width
      balance%load = -strip%adhesion%stress*balance%adhesion
      balance%load_scale = abs(balance%load)
      if (balance%adhesion >= two_pi) return
      ! stress times F(b) - F(-a)
      change = -2*sin(state%half_width)*sin(state%shift)
      balance%friction = strip%adhesion%stress*change
      balance%friction_scale = abs(balance%friction)
      w = lifted_profile(strip, b) + strip%adhesion%attach_gap - strip%adhesion%jump
      call add_open_zone(strip, w, balance%adhesion, -strip%adhesion%stress, sums)
      w = profile(strip, a) + strip%adhesion%release_gap + strip%adhesion%jump
      call add_open_zone(strip, w, two_pi - balance%adhesion, 0.0_dp, sums)
      call add_edge_loss(strip, state, w, balance)
      call finish(strip, sums, balance)
   end subroutine balance_adhesion_only

   !> Integrals over the contact zone of r = p + stress, from r - u r' = drive tested with 1, sin and
   !> 1 - cos of the distance from its centre: sums of terms of one order in narrow contacts.
   pure subroutine add_contact(strip, state, sums, balance)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      !> Receives the integrals over the contact zone.
      type(sums_t), intent(inout) :: sums
      !> In: the phases in contact and in adhesion. Out: load and friction of the contact, too.
      type(balance_t), intent(inout) :: balance
      real(dp) :: s, c, sin_width, cubic_1, cubic_2, even, odd, m0, m_sin, m_versine, test_sin, test_versine, versine
      real(dp) :: square(11), direct(4)

      associate (u => strip%foundation%u, v => strip%foundation%v, width => state%half_width)
         s = sin(state%shift)
         c = cos(state%shift)
         sin_width = sin(width)
         versine = 2*sin(width/2)**2
         ! width - sin(width) and width - sin(width) cos(width)
         cubic_1 = angle_minus_sine(width)
         cubic_2 = cubic_1 + sin_width*versine
         ! drive = level + even cos + odd sin of the distance from the centre
         even = c + v*s
         odd = v*c - s
         m0 = 2*(width*strip%depth - cubic_1 + sin_width*(v*s - 2*sin(state%shift/2)**2)) + u*state%entry
         test_sin = odd*cubic_2 + u*state%entry*sin_width
         test_versine = 2*cubic_1*(strip%level - even) + even*cubic_2 + u*state%entry*versine
         m_sin = (test_sin - u*m0 + u*test_versine)/(1 + u*u)
         m_versine = test_versine - u*m_sin
         balance%load = m0 - strip%adhesion%stress*(balance%contact + balance%adhesion)
         balance%load_scale = abs(m0) + strip%adhesion%stress*(balance%contact + balance%adhesion)
         balance%friction = s*(m0 - m_versine) + c*m_sin
         balance%friction_scale = abs(s*m0) + abs(c*m_sin)
         sums%displacement = 2*(width*strip%mean + sin_width*c)
         direct = contact_square(strip, state, s, c)
         ! q = r - (level + cos xi), and the integral of r^2 is that of r times the drive
         square = [even*(m0 - m_versine), odd*m_sin, strip%level*m0, u*state%entry**2/2, &
            & -2*strip%level*m0, -2*c*(m0 - m_versine), 2*s*m_sin, &
            & 2*width*strip%level**2, 4*strip%level*c*sin_width, c*c*(2*width - cubic_2), s*s*cubic_2]
         ! the form with the smaller terms keeps more digits: the direct one in contacts longer than u
         sums%square = merge(sum(direct), sum(square), sum(abs(direct)) < sum(abs(square)))
         if (sums%square < cancelled*min(sum(abs(direct)), sum(abs(square)))) then
            sums%square = integrate_square(strip, state)
         end if
      end associate
   end subroutine add_contact

   !> The four terms of the integral of q^2 over the contact, q = loss (sin + u cos) + a decaying exponential.
   pure function contact_square(strip, state, s, c) result(terms)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      !> Sine and cosine of the shift.
      real(dp), intent(in) :: s, c
      real(dp) :: terms(4), even, odd, b, sw, cw, lost, decaying, cross_cos, cross_sin

      associate (f => strip%foundation, width => state%half_width)
         even = f%loss*(s + f%u*c)
         odd = f%loss*(c - f%u*s)
         b = state%shift + width
         sw = sin(width)
         cw = cos(width)
         ! what remains at the leading edge, where p = entry - stress and w = F
         decaying = state%entry - lifted_profile(strip, b) - (even*cw + odd*sw)
         lost = decay(2*width/f%u)
         ! integrals of exp((x - width)/u) times cos x and sin x
         cross_cos = f%u*(cw*lost + f%u*sw*(2 - lost))/(1 + f%u*f%u)
         cross_sin = f%u*(sw*(2 - lost) - f%u*cw*lost)/(1 + f%u*f%u)
         terms = [even*even*(width + sw*cw), odd*odd*(width - sw*cw), &
            & 2*decaying*(even*cross_cos + odd*cross_sin), decaying*decaying*f%u/2*lost*(2 - lost)]
      end associate
   end function contact_square

   !> The same integral by Gauss's rule, for narrow contacts in which the closed forms cancel: there q is smooth.
   pure real(dp) function integrate_square(strip, state) result(square)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      real(dp) :: b, start, passed, lost, q
      integer :: k

      b = state%shift + state%half_width
      start = state%entry - lifted_profile(strip, b)
      square = 0
      associate (f => strip%foundation)
         do k = 1, size(gauss_nodes)
            passed = state%half_width*(1 + gauss_nodes(k))
            lost = decay(passed/f%u)
            ! sine and cosine at b - passed less those at b
            q = start*(1 - lost) + f%loss*((sin(b) + f%u*cos(b))*lost &
               & - 2*sin(passed/2)*(cos(b - passed/2) - f%u*sin(b - passed/2)))
            square = square + gauss_weights(k)*q*q
         end do
      end associate
      square = square*state%half_width
   end function integrate_square

   !> An open zone of constant pressure, in which w - p decays.
   pure subroutine add_open_zone(strip, excess, length, pressure, sums)
      type(strip_t), intent(in) :: strip
      !> Displacement less pressure, w - p, where the zone begins (at its leading end) [c].
      real(dp), intent(in) :: excess
      !> Length of the zone [rad].
      real(dp), intent(in) :: length
      !> Pressure in the zone, -stress or 0 [c/K].
      real(dp), intent(in) :: pressure
      !> Integrals over zones; those over this zone are added.
      type(sums_t), intent(inout) :: sums
      real(dp) :: lost

      lost = decay(length/strip%foundation%v)
      sums%displacement = sums%displacement + pressure*length + excess*strip%foundation%v*lost
      sums%square = sums%square + excess*excess*strip%foundation%v/2*lost*(2 - lost)
   end subroutine add_open_zone

   !> Energy that the two edges of the adhesion stress take.
   pure subroutine add_edge_loss(strip, state, released, balance)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      !> Displacement behind the trailing edge of adhesion, where the free zone begins [c].
      real(dp), intent(in) :: released
      type(balance_t), intent(inout) :: balance
      real(dp) :: attached

      attached = profile(strip, state%half_width + state%shift + state%leading) + strip%adhesion%attach_gap
      balance%edge_loss = edge_work(strip%adhesion, strip%foundation%beta, state%entry > 0, released - attached)
   end subroutine add_edge_loss

   !> Change of the integral of the pressure with the depth of the strip, on its branch.
   pure real(dp) function get_load_slope(strip, state) result(slope)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      real(dp) :: rates(4), by_width, by_shift

      slope = 0
      select case (state%regime)
      case (regime_adhesion_only)
         if (state%half_width < pi) slope = -2*strip%adhesion%stress*get_adhesion_rate(strip, state)
         return
      case (regime_adhesion_zones)
         rates = get_edge_rates(strip, state)
      case default
         ! no edge of adhesion can move
         slope = get_slope_bound(strip, state)
         return
      end select
      associate (v => strip%foundation%v, w => state%half_width, s => state%shift)
         by_width = 2*(strip%depth - 2*sin(w/2)**2 + cos(w)*(v*sin(s) - 2*sin(s/2)**2))
         by_shift = 2*sin(w)*(v*cos(s) - sin(s))
         slope = 2*w + by_width*rates(1) + by_shift*rates(2) - strip%adhesion%stress*(2*rates(1) + rates(3) + rates(4))
      end associate
   end function get_load_slope

   !> Change of the integral of the pressure with the depth of the strip while the edges of adhesion stay where they are: the
   !> largest change that this penetration and all smaller ones can have (docs/theory/columns_load.md).
   !>
   !> Where the phases of release and attachment are prescribed, the length e of the dashpot, K p = w + (beta - 1)(w - e), answers
   !> continuously to everything else: over a change of the depth of 1 it relaxes towards 1 in contact, over the phase u, and
   !> towards 0 where the pressure is prescribed, over the phase v. The mean displacement tells the mean pressure.
   pure real(dp) function get_slope_bound(strip, state) result(bound)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      real(dp) :: open, lost_closed, lost_open, lost

      bound = 0
      select case (state%regime)
      case (regime_saturated)
         bound = two_pi
      case (regime_discrete, regime_saturated_adhesion, regime_adhesion_zones)
         associate (f => strip%foundation)
            open = two_pi - 2*state%half_width
            lost_closed = decay(2*state%half_width/f%u)
            lost_open = decay(open/f%v)
            ! 1 - (1 - lost_closed)(1 - lost_open) without loss of digits
            lost = lost_closed + lost_open - lost_closed*lost_open
            bound = 2*state%half_width
            if (lost > 0) bound = bound + (1 - 1/f%beta)*f%v*lost_open*(lost_closed/lost)
         end associate
      case default
         continue
      end select
   end function get_slope_bound

   !> What follows from the sums.
   pure subroutine finish(strip, sums, balance)
      type(strip_t), intent(in) :: strip
      type(sums_t), intent(in) :: sums
      !> In: the load. Out: its mismatch and the dissipation, too.
      type(balance_t), intent(inout) :: balance

      associate (f => strip%foundation)
         balance%load_mismatch = sums%displacement - balance%load
         ! an elastic foundation has no Maxwell arm
         if (f%beta > 1) balance%dissipation = sums%square/(f%u*(f%beta - 1))
      end associate
   end subroutine finish

end module adfric_foundation_balance

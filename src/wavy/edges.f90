!> The edges of contact and adhesion of one strip, by Newton's method on all edge equations at once.
!>
!> With \( a = \lambda - s, b = \lambda + s \) the contact is (-a, b) and adhesion reaches to -a1 and b1. The four
!> conditions (GM 4.3) are that p returns to -stress at -a, that the gap is the range at -a1 and at b1, and that
!> it closes at b. They are written in the lengths of the zones, not in the differences of phases, so that
!> they keep their digits when a zone is short or the sliding fast.
module adfric_wavy_edges
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_wavy_contact_zone, only: decay, coth_and_slope, get_lag, longest_decay
   use adfric_wavy_phases, only: phases_left
   use adfric_wavy_strip, only: strip_t, steady_state_t, drive, drive_round_off, profile, lifted_profile, &
      & regime_adhesion_zones, regime_adhesion_only
   implicit none (type, external)
   private
   public :: refine_edges, refine_adhesion_edges, is_admissible, is_admissible_adhesion, get_edge_rates, get_adhesion_rate

   integer, parameter :: max_iterations = 30
   !> Relative step after which nothing but round-off is left, for convergence is quadratic.
   real(dp), parameter :: close_enough = 1.0e-9_dp
   !> Relative step that round-off alone may cause near the end of a branch.
   real(dp), parameter :: round_off = 1.0e-6_dp
   !> Beyond this retardation phase what a gap loses in a zone is less than round-off.
   real(dp), parameter :: fastest = 1.0e12_dp
   !> A step that says that there is none.
   real(dp), parameter :: no_step = 1.0e100_dp

   !> The four edge equations, their derivatives by the contact edges a and b and by the lengths m of the
   !> adhesion zones, and by the depth of the strip.
   type :: edge_equations_t
      real(dp) :: value(4) = 0, by_depth(4) = 0
      real(dp) :: e1_a = 0, e1_b = 0, e2_a = 0, e2_m = 0, e3_a = 0, e3_b = 0, e4_b = 0, e4_m = 0
   end type edge_equations_t

contains

   !> Newton's method on the edges of contact and adhesion, from the edges in `state`.
   pure subroutine refine_edges(strip, state)
      type(strip_t), intent(in) :: strip
      !> In: a guess of half_width, shift, trailing and leading. Out: the edges; `is_converged` tells.
      type(steady_state_t), intent(inout) :: state
      type(edge_equations_t) :: equations
      real(dp) :: step(4), size_now, size_last, share
      integer :: iteration

      state%regime = regime_adhesion_zones
      state%is_converged = .false.
      state%entry = 0
      if (strip%foundation%v > fastest) return
      if (strip%jump >= strip%range) then
         state%entry = strip%foundation%beta*(strip%jump - strip%range)
         state%leading = 0
      end if
      state%outer_shift = state%shift + (state%leading - state%trailing)/2
      size_last = huge(1.0_dp)
      do iteration = 1, max_iterations
         call get_edge_equations(strip, state, equations)
         step = solve_edges(equations, equations%value)
         if (.not. maxval(abs(step)) < no_step) return
         share = largest_share(state, step)
         size_now = maxval(abs(step)/max([state%half_width, 1.0_dp, state%trailing, state%leading], tiny(1.0_dp)*no_step))
         state%half_width = state%half_width + share*step(1)
         state%shift = state%shift + share*step(2)
         state%trailing = state%trailing + share*step(3)
         state%leading = state%leading + share*step(4)
         state%outer_shift = state%outer_shift + share*(step(2) + (step(4) - step(3))/2)
         if (.not. (share > 0 .and. free_length(state) > 0)) return
         if (share < 1) cycle
         state%is_converged = size_now <= close_enough .or. (size_now <= round_off .and. size_now >= size_last/2)
         if (state%is_converged) exit
         size_last = size_now
      end do
      if (state%is_converged) state%multiplier = get_multiplier(strip, state)
   end subroutine refine_edges

   !> The share of a step that keeps every zone longer than a tenth of what it was.
   pure real(dp) function largest_share(state, step) result(share)
      type(steady_state_t), intent(in) :: state
      real(dp), intent(in) :: step(4)
      real(dp) :: lengths(4), change(4)

      lengths = [state%half_width, state%trailing, state%leading, free_length(state)]
      change = [step(1), step(3), step(4), -(2*step(1) + step(3) + step(4))]
      share = min(1.0_dp, minval(0.9_dp*lengths/max(-change, tiny(1.0_dp)), mask=-change > 0.9_dp*lengths))
   end function largest_share

   !> Length of the free zone.
   pure real(dp) function free_length(state)
      type(steady_state_t), intent(in) :: state

      free_length = two_pi - 2*state%half_width - state%trailing - state%leading
   end function free_length

   !> The edge equations at the edges of `state`.
   pure subroutine get_edge_equations(strip, state, equations)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      type(edge_equations_t), intent(out) :: equations
      real(dp) :: sin_w, cos_w, sin_s, cos_s, sin_t, cos_t, sin_l, cos_l
      real(dp) :: sin_a, cos_a, sin_b, cos_b, sin_a1, cos_a1, sin_b1, cos_b1, sin_outer
      real(dp) :: lost_t, lost_l, lost_f, w_t, w_l, w_f, gap, inner, outer

      ! sines and cosines of all edges from those of four angles
      sin_w = sin(state%half_width); cos_w = cos(state%half_width)
      sin_s = sin(state%shift); cos_s = cos(state%shift)
      sin_t = sin(state%trailing/2); cos_t = cos(state%trailing/2)
      sin_l = sin(state%leading/2); cos_l = cos(state%leading/2)
      sin_a = sin_w*cos_s - cos_w*sin_s; cos_a = cos_w*cos_s + sin_w*sin_s
      sin_b = sin_w*cos_s + cos_w*sin_s; cos_b = cos_w*cos_s - sin_w*sin_s
      call turn(sin_a, cos_a, 2*sin_t*cos_t, 1 - 2*sin_t*sin_t, sin_a1, cos_a1)
      call turn(sin_b, cos_b, 2*sin_l*cos_l, 1 - 2*sin_l*sin_l, sin_b1, cos_b1)
      sin_outer = sin_w*(cos_t*cos_l - sin_t*sin_l) + cos_w*(sin_t*cos_l + cos_t*sin_l)
      ! F(-a) - F(b) and F(-a1) - F(b1)
      inner = 2*sin_w*sin_s
      outer = 2*sin_outer*sin(state%outer_shift)

      associate (v => strip%foundation%v, e => equations%value, e1_a => equations%e1_a, e1_b => equations%e1_b, &
         & e2_a => equations%e2_a, e2_m => equations%e2_m, e3_a => equations%e3_a, e3_b => equations%e3_b, &
         & e4_b => equations%e4_b, e4_m => equations%e4_m)
         call get_contact_equation(strip, state, sin_w, cos_w, sin_s, cos_s, e(1), e1_a, e1_b)

         ! trailing adhesion: gap = range at its end
         lost_t = decay(state%trailing/v)
         w_t = strip%depth - versine(sin_a, cos_a)
         e(2) = -w_t*lost_t + 2*(sin_a*cos_t + cos_a*sin_t)*sin_t - strip%range
         e2_a = sin_a1 - sin_a*(1 - lost_t)
         e2_m = sin_a1 - w_t*(1 - lost_t)/v

         ! free zone: gap = range at its end
         lost_f = decay(free_length(state)/v)
         w_f = strip%crest - versine(sin_a1, cos_a1) + strip%range + strip%jump
         e3_a = (w_f/v - sin_a1)*(1 - lost_f)
         e3_b = w_f*(1 - lost_f)/v + sin_b1

         ! leading adhesion: gap closed at its end. The sum of all gap conditions, in which the large terms
         ! cancel, is what keeps the displacement continuous in fast sliding
         gap = strip%range - strip%jump
         if (strip%jump >= strip%range) then
            lost_l = 0
            e(3) = -w_t*lost_t - w_f*lost_f + inner - gap - e(2)
            e(4) = 0; e4_b = 0; e4_m = 1
         else
            lost_l = decay(state%leading/v)
            w_l = strip%depth - versine(sin_b1, cos_b1) + gap
            e(3) = -w_f*lost_f + outer + strip%jump
            e(4) = -w_t*lost_t - w_l*lost_l + inner - outer - strip%jump - e(2)
            e4_b = sin_b - sin_b1*(1 - lost_l)
            e4_m = -(sin_b1 + w_l/v)*(1 - lost_l)
         end if
         equations%by_depth = [1.0_dp, -lost_t, -lost_f, -lost_l]
      end associate
   end subroutine get_edge_equations

   !> The step of (half_width, shift, trailing, leading) that takes away `value` from the edge equations.
   pure function solve_edges(equations, value) result(step)
      type(edge_equations_t), intent(in) :: equations
      real(dp), intent(in) :: value(4)
      real(dp) :: step(4)
      real(dp) :: edge_a(2), length_a(2), edge_b(2), length_b(2)
      real(dp) :: free_a, free_b, rest_free, rest_contact, determinant, da, db

      associate (e => equations)
         ! each adhesion zone ties its length to its contact edge; two equations are left for two parameters
         call tie_zone(value(2), e%e2_a, e%e2_m, edge_a, length_a)
         call tie_zone(value(4), e%e4_b, e%e4_m, edge_b, length_b)
         step = no_step
         free_a = e%e3_a*(edge_a(2) + length_a(2))
         free_b = e%e3_b*(edge_b(2) + length_b(2))
         rest_free = -value(3) - e%e3_a*(edge_a(1) + length_a(1)) - e%e3_b*(edge_b(1) + length_b(1))
         rest_contact = -value(1) - e%e1_a*edge_a(1) - e%e1_b*edge_b(1)
         determinant = free_a*e%e1_b*edge_b(2) - free_b*e%e1_a*edge_a(2)
         if (.not. abs(determinant) >= tiny(1.0_dp)) return
         da = (rest_free*e%e1_b*edge_b(2) - free_b*rest_contact)/determinant
         db = (free_a*rest_contact - rest_free*e%e1_a*edge_a(2))/determinant
      end associate
      length_a(1) = length_a(1) + length_a(2)*da
      length_b(1) = length_b(1) + length_b(2)*db
      da = edge_a(1) + edge_a(2)*da
      db = edge_b(1) + edge_b(2)*db
      step = [(da + db)/2, (db - da)/2, length_a(1), length_b(1)]
   end function solve_edges

   !> Change of (half_width, shift, trailing, leading) with the depth of the strip.
   pure function get_edge_rates(strip, state) result(rates)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      real(dp) :: rates(4)
      type(edge_equations_t) :: equations

      call get_edge_equations(strip, state, equations)
      rates = solve_edges(equations, equations%by_depth)
   end function get_edge_rates

   !> Solve value + by_edge x + by_length y = 0 as x = edge(1) + edge(2) t, y = length(1) + length(2) t,
   !> for the unknown with the larger factor.
   pure subroutine tie_zone(value, by_edge, by_length, edge, length)
      real(dp), intent(in) :: value, by_edge, by_length
      real(dp), intent(out) :: edge(2), length(2)

      edge = [0.0_dp, 1.0_dp]
      length = [0.0_dp, 1.0_dp]
      if (abs(by_length) >= abs(by_edge)) then
         if (abs(by_length) > 0) length = -[value, by_edge]/by_length
      else
         edge = -[value, by_length]/by_edge
      end if
   end subroutine tie_zone

   !> Sine and cosine of a sum of angles.
   pure subroutine turn(sin_x, cos_x, sin_y, cos_y, sin_sum, cos_sum)
      real(dp), intent(in) :: sin_x, cos_x, sin_y, cos_y
      real(dp), intent(out) :: sin_sum, cos_sum

      sin_sum = sin_x*cos_y + cos_x*sin_y
      cos_sum = cos_x*cos_y - sin_x*sin_y
   end subroutine turn

   !> The condition that the pressure returns to -stress at the trailing edge of contact.
   pure subroutine get_contact_equation(strip, state, sin_w, cos_w, sin_s, cos_s, value, by_a, by_b)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      !> Sine and cosine of half width and shift.
      real(dp), intent(in) :: sin_w, cos_w, sin_s, cos_s
      real(dp), intent(out) :: value
      !> Derivatives with respect to the edges a and b.
      real(dp), intent(out) :: by_a, by_b
      real(dp) :: coth, excess, lag, lag_slope, along, along_slope, by_width, by_shift

      associate (f => strip%foundation)
         call coth_and_slope(state%half_width/f%u, coth, excess)
         lag = f%loss*get_lag(state%half_width, f%u, coth)
         lag_slope = f%loss*(cos_w*coth + sin_w*(f%u - excess/f%u))
         along = f%loss*cos_w + f%storage*coth*sin_w
         along_slope = -f%loss*sin_w + f%storage*(coth*cos_w - sin_w*excess/f%u)
         ! level + cos(shift) (cos(half_width) - lag) + sin(shift) along
         value = strip%depth - versine(sin_w, cos_w) - cos_w*versine(sin_s, cos_s) - cos_s*lag + sin_s*along &
            & + state%entry*(coth - 1)/2
         by_width = -cos_s*(sin_w + lag_slope) + sin_s*along_slope - state%entry*excess/(2*f%u)
         by_shift = -sin_s*(cos_w - lag) + cos_s*along
         by_a = (by_width - by_shift)/2
         by_b = (by_width + by_shift)/2
      end associate
   end subroutine get_contact_equation

   !> 1 - cos x from sine and cosine, without loss of digits.
   elemental real(dp) function versine(sine, cosine)
      real(dp), intent(in) :: sine, cosine

      if (cosine > 0) then
         versine = sine*sine/(1 + cosine)
      else
         versine = 1 - cosine
      end if
   end function versine

   !> Newton's method on the two edges of adhesion where there is no contact.
   pure subroutine refine_adhesion_edges(strip, state)
      type(strip_t), intent(in) :: strip
      !> In: a guess of half_width and shift of the adhesion zone. Out: the edges; `is_converged` tells.
      type(steady_state_t), intent(inout) :: state
      real(dp) :: value(2), by_depth(2), jacobian(2, 2), step(2), size_now, size_last
      integer :: iteration

      state%is_converged = .false.
      state%regime = regime_adhesion_only
      state%trailing = 0
      state%leading = 0
      state%entry = 0
      size_last = huge(1.0_dp)
      do iteration = 1, max_iterations
         call get_adhesion_equations(strip, state, value, jacobian, by_depth)
         step = solve_pair(jacobian, value)
         size_now = maxval(abs(step))/state%half_width
         if (.not. size_now < 0.5_dp) return
         state%half_width = state%half_width + (step(1) + step(2))/2
         state%shift = state%shift + (step(2) - step(1))/2
         if (state%half_width <= 0 .or. 2*state%half_width >= two_pi) return
         state%is_converged = size_now <= close_enough .or. (size_now <= round_off .and. size_now >= size_last/2)
         if (state%is_converged) exit
         size_last = size_now
      end do
      if (state%is_converged) state%multiplier = get_multiplier(strip, state)
   end subroutine refine_adhesion_edges

   !> The conditions that the gap is the range at both ends of an adhesion zone without contact.
   pure subroutine get_adhesion_equations(strip, state, value, jacobian, by_depth)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      real(dp), intent(out) :: value(2)
      !> Derivatives of both by the edges a and b, and by the depth of the strip.
      real(dp), intent(out) :: jacobian(2, 2), by_depth(2)
      real(dp) :: a, b, lost, w, change

      associate (v => strip%foundation%v)
         a = state%half_width - state%shift
         b = state%half_width + state%shift
         ! F(-a) - F(b)
         change = 2*sin(state%half_width)*sin(state%shift)
         ! adhesion from b to -a
         lost = decay(2*state%half_width/v)
         w = lifted_profile(strip, b) + strip%range - strip%jump
         value(1) = -w*lost - change - strip%jump
         jacobian(1, :) = [sin(a) - w*(1 - lost)/v, -(sin(b) + w/v)*(1 - lost)]
         by_depth(1) = -lost
         ! free from -a to b
         lost = decay((two_pi - 2*state%half_width)/v)
         w = profile(strip, a) + strip%range + strip%jump
         value(2) = -w*lost + change + strip%jump
         jacobian(2, :) = [(w/v - sin(a))*(1 - lost), w*(1 - lost)/v + sin(b)]
         by_depth(2) = -lost
      end associate
   end subroutine get_adhesion_equations

   !> The step that takes away `value`, by Cramer's rule; `no_step` if there is none.
   pure function solve_pair(jacobian, value) result(step)
      real(dp), intent(in) :: jacobian(2, 2), value(2)
      real(dp) :: step(2), determinant

      determinant = jacobian(1, 1)*jacobian(2, 2) - jacobian(1, 2)*jacobian(2, 1)
      step = no_step
      if (abs(determinant) < tiny(1.0_dp)) return
      step(1) = (value(2)*jacobian(1, 2) - value(1)*jacobian(2, 2))/determinant
      step(2) = (value(1)*jacobian(2, 1) - value(2)*jacobian(1, 1))/determinant
   end function solve_pair

   !> Change of the half width of an adhesion zone without contact with the depth of the strip.
   pure real(dp) function get_adhesion_rate(strip, state) result(rate)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      real(dp) :: value(2), jacobian(2, 2), by_depth(2)

      call get_adhesion_equations(strip, state, value, jacobian, by_depth)
      rate = sum(solve_pair(jacobian, by_depth))/2
   end function get_adhesion_rate

   !> Do the edges of contact with adhesion zones fulfil every inequality of the model? The closed forms
   !> then have no earlier event (see `march`), so signs at the edges are enough.
   pure logical function is_admissible(strip, state)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      real(dp) :: a, b, margin

      a = state%half_width - state%shift
      b = state%half_width + state%shift
      is_admissible = state%is_converged .and. state%half_width > 0 .and. state%trailing > 0 &
         & .and. state%leading >= 0 .and. free_length(state) > 0
      if (.not. is_admissible) return
      margin = drive_round_off(strip)
      is_admissible = drive(strip, -a) < margin .and. drive(strip, -a - state%trailing) < margin - strip%range &
         & .and. drive(strip, b + state%leading) > strip%stress - strip%range - margin &
         & .and. drive(strip, b) > state%entry - margin
   end function is_admissible

   !> Does an adhesion zone without contact fulfil every inequality? Its gap is least at the end of the interval where
   !> the drive is positive, or at the end of the zone.
   pure logical function is_admissible_adhesion(strip, state)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      real(dp) :: a, b, span, margin

      a = state%half_width - state%shift
      b = state%half_width + state%shift
      margin = drive_round_off(strip)
      is_admissible_adhesion = state%is_converged .and. strip%range > strip%jump &
         & .and. drive(strip, -a) < margin - strip%range &
         & .and. drive(strip, b) > strip%stress - strip%range - margin
      if (.not. is_admissible_adhesion) return
      span = phases_left(strip, b, 0.0_dp, .false.)
      if (span < 0 .or. span >= 2*state%half_width) return
      is_admissible_adhesion = strip%range - strip%jump - 2*sin(b - span/2)*sin(span/2) &
         & - (lifted_profile(strip, b) + strip%range - strip%jump)*decay(span/strip%foundation%v) > 0
   end function is_admissible_adhesion

   !> Derivative of the return map at a steady state with adhesion and free zones. A jump of the rate of
   !> the gap where adhesion starts or ends multiplies a disturbance; the zones damp it.
   pure real(dp) function get_multiplier(strip, state) result(multiplier)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      real(dp) :: a1, b, b1, release, attach, after, damping

      associate (f => strip%foundation)
         a1 = state%half_width - state%shift + state%trailing
         b = state%half_width + state%shift
         b1 = b + state%leading
         damping = two_pi/f%v
         if (state%regime == regime_adhesion_zones) damping = damping + 2*state%half_width*(1/f%u - 1/f%v)
         ! rates of the gap (times v) before and after the edge
         release = -drive(strip, -a1) - strip%range
         attach = -drive(strip, b1) + strip%stress - strip%range
         if (state%entry > 0) then
            after = -drive(strip, b) + state%entry
         else
            after = -drive(strip, b1) - strip%range + strip%jump
         end if
         multiplier = exp(-min(damping, longest_decay)) &
            & *((release + strip%stress - strip%jump)/release)*(after/attach)
      end associate
   end function get_multiplier

end module adfric_wavy_edges

! SPDX-License-Identifier: GPL-3.0-or-later
!> The equations of the edges of contact and adhesion of one strip, and their derivatives.
!>
!> With \( a = \lambda - s, b = \lambda + s \) the contact is (-a, b) and adhesion reaches to -a1 and b1. The four
!> conditions (GM 4.3) are that p returns to -stress at -a, that the gap is that of release at -a1 and that of
!> attachment at b1, and that it closes at b. They are written in the lengths of the zones, not in the differences of
!> phases, so that they keep their digits when a zone is short or the sliding fast.
module adfric_foundation_edge_equations
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_foundation_contact_zone, only: decay, coth_and_slope, get_lag
   use adfric_foundation_strip, only: strip_t, steady_state_t, profile, lifted_profile
   implicit none (type, external)
   private
   public :: edge_equations_t, get_edge_equations, solve_edges, get_edge_rates, free_length
   public :: get_adhesion_equations, solve_pair, get_adhesion_rate, no_step

   !> A step that says that there is none.
   real(dp), parameter :: no_step = 1.0e100_dp

   !> The four edge equations, their derivatives by the contact edges a and b and by the lengths m of the
   !> adhesion zones, and by the depth of the strip.
   type :: edge_equations_t
      !> Values of the equations, 0 where they are fulfilled, and their derivatives by the depth.
      real(dp) :: value(4) = 0, by_depth(4) = 0
      !> Derivatives that are not 0 everywhere: of the equation of this number by a, b or m.
      real(dp) :: e1_a = 0, e1_b = 0, e2_a = 0, e2_m = 0, e3_a = 0, e3_b = 0, e4_b = 0, e4_m = 0
   end type edge_equations_t

contains

   !> The edge equations at the edges of `state`.
   pure subroutine get_edge_equations(strip, state, equations)
      type(strip_t), intent(in) :: strip
      !> Edges of contact and adhesion where the equations are evaluated [rad].
      type(steady_state_t), intent(in) :: state
      !> Values and derivatives of the four equations.
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

         ! trailing adhesion: the gap of release at its end
         lost_t = decay(state%trailing/v)
         w_t = strip%depth - versine(sin_a, cos_a)
         e(2) = -w_t*lost_t + 2*(sin_a*cos_t + cos_a*sin_t)*sin_t - strip%adhesion%release_gap
         e2_a = sin_a1 - sin_a*(1 - lost_t)
         e2_m = sin_a1 - w_t*(1 - lost_t)/v
         if (strip%adhesion%is_lost_at_contact) then
            ! the zone has no length
            e(2) = 0; e2_a = 0; e2_m = 1
         end if

         ! free zone: the gap of attachment at its end
         lost_f = decay(free_length(state)/v)
         w_f = strip%crest - versine(sin_a1, cos_a1) + strip%adhesion%release_gap + strip%adhesion%jump
         e3_a = (w_f/v - sin_a1)*(1 - lost_f)
         e3_b = w_f*(1 - lost_f)/v + sin_b1

         ! leading adhesion: gap closed at its end. The sum of all gap conditions, in which the large terms
         ! cancel, is what keeps the displacement continuous in fast sliding
         gap = strip%adhesion%attached_gap
         if (strip%adhesion%snaps) then
            lost_l = 0
            e(3) = -w_t*lost_t - w_f*lost_f + inner - gap - e(2)
            e(4) = 0; e4_b = 0; e4_m = 1
         else
            lost_l = decay(state%leading/v)
            w_l = strip%depth - versine(sin_b1, cos_b1) + gap
            e(3) = -w_f*lost_f + outer + strip%adhesion%gap_change
            e(4) = -w_t*lost_t - w_l*lost_l + inner - outer - strip%adhesion%gap_change - e(2)
            e4_b = sin_b - sin_b1*(1 - lost_l)
            e4_m = -(sin_b1 + w_l/v)*(1 - lost_l)
         end if
         equations%by_depth = [1.0_dp, -lost_t, -lost_f, -lost_l]
      end associate
   end subroutine get_edge_equations

   !> The step of (half_width, shift, trailing, leading) that takes away `value` from the edge equations.
   pure function solve_edges(equations, value) result(step)
      !> Derivatives of the four equations; the values in it are not used.
      type(edge_equations_t), intent(in) :: equations
      !> Values of the four equations that the step takes away [c].
      real(dp), intent(in) :: value(4)
      real(dp) :: step(4), edge_a(2), length_a(2), edge_b(2), length_b(2)
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
      !> Value of an equation, and its derivatives by the contact edge and by the length of the zone.
      real(dp), intent(in) :: value, by_edge, by_length
      !> Constant and factor of t of the edge (x), and of the length (y).
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
      !> Sine and cosine of either angle.
      real(dp), intent(in) :: sin_x, cos_x, sin_y, cos_y
      real(dp), intent(out) :: sin_sum, cos_sum

      sin_sum = sin_x*cos_y + cos_x*sin_y
      cos_sum = cos_x*cos_y - sin_x*sin_y
   end subroutine turn

   !> The condition that the pressure returns to -stress at the trailing edge of contact.
   pure subroutine get_contact_equation(strip, state, sin_w, cos_w, sin_s, cos_s, value, by_a, by_b)
      type(strip_t), intent(in) :: strip
      !> Edges of contact where the condition is evaluated [rad].
      type(steady_state_t), intent(in) :: state
      !> Sines and cosines of half width and shift.
      real(dp), intent(in) :: sin_w, cos_w, sin_s, cos_s
      !> Value of the condition; 0 where the edges fulfil it.
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
      !> Sine and cosine of x.
      real(dp), intent(in) :: sine, cosine

      if (cosine > 0) then
         versine = sine*sine/(1 + cosine)
      else
         versine = 1 - cosine
      end if
   end function versine

   !> The conditions that the gap is that of release and that of attachment at the ends of an adhesion zone without contact.
   pure subroutine get_adhesion_equations(strip, state, value, jacobian, by_depth)
      type(strip_t), intent(in) :: strip
      !> The adhesion zone, by its half width and shift [rad].
      type(steady_state_t), intent(in) :: state
      !> Values of the conditions at the trailing and at the leading end [c]; 0 where the edges fulfil them.
      real(dp), intent(out) :: value(2)
      !> Derivatives of both conditions by the edges a and b, and by the depth of the strip.
      real(dp), intent(out) :: jacobian(2, 2), by_depth(2)
      real(dp) :: a, b, lost, w, change

      associate (v => strip%foundation%v)
         a = state%half_width - state%shift
         b = state%half_width + state%shift
         ! F(-a) - F(b)
         change = 2*sin(state%half_width)*sin(state%shift)
         ! adhesion from b to -a
         lost = decay(2*state%half_width/v)
         w = lifted_profile(strip, b) + strip%adhesion%attach_gap - strip%adhesion%jump
         value(1) = -w*lost - change - strip%adhesion%gap_change
         jacobian(1, :) = [sin(a) - w*(1 - lost)/v, -(sin(b) + w/v)*(1 - lost)]
         by_depth(1) = -lost
         ! free from -a to b
         lost = decay((two_pi - 2*state%half_width)/v)
         w = profile(strip, a) + strip%adhesion%release_gap + strip%adhesion%jump
         value(2) = -w*lost + change + strip%adhesion%gap_change
         jacobian(2, :) = [(w/v - sin(a))*(1 - lost), w*(1 - lost)/v + sin(b)]
         by_depth(2) = -lost
      end associate
   end subroutine get_adhesion_equations

   !> The step that takes away `value`, by Cramer's rule; `no_step` if there is none.
   pure function solve_pair(jacobian, value) result(step)
      !> Derivatives of two equations (rows) by two unknowns (columns), and the values of the equations.
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

   !> Length of the free zone.
   pure real(dp) function free_length(state)
      !> State of which the lengths of contact and adhesion zones are read [rad].
      type(steady_state_t), intent(in) :: state

      free_length = two_pi - 2*state%half_width - state%trailing - state%leading
   end function free_length

end module adfric_foundation_edge_equations

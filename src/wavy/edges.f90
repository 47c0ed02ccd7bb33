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
   use adfric_wavy_strip, only: strip_t, steady_state_t, drive, regime_adhesion_zones
   implicit none (type, external)
   private
   public :: refine_edges, refine_adhesion_edges, is_admissible, get_multiplier

   integer, parameter :: max_iterations = 30
   !> Relative step after which nothing but round-off is left, for convergence is quadratic.
   real(dp), parameter :: close_enough = 1.0e-9_dp
   !> Relative step that round-off alone may cause near the end of a branch.
   real(dp), parameter :: round_off = 1.0e-6_dp

contains

   !> Newton's method on the edges of contact and adhesion, from the edges in `state`.
   pure subroutine refine_edges(strip, state)
      type(strip_t), intent(in) :: strip
      !> In: a guess of half_width, shift, trailing and leading. Out: the edges; `is_converged` tells.
      type(steady_state_t), intent(inout) :: state
      real(dp) :: step(4), size_now, size_last, share
      integer :: iteration

      state%regime = regime_adhesion_zones
      state%is_converged = .false.
      state%entry = 0
      if (strip%jump >= strip%range) then
         state%entry = strip%foundation%beta*(strip%jump - strip%range)
         state%leading = 0
      end if
      size_last = huge(1.0_dp)
      do iteration = 1, max_iterations
         call get_newton_step(strip, state, step)
         share = largest_share(state, step)
         size_now = maxval(abs(step)/[state%half_width, 1.0_dp, state%trailing, max(state%leading, tiny(1.0_dp))])
         if (.not. size_now < huge(1.0_dp)) return
         state%half_width = state%half_width + share*step(1)
         state%shift = state%shift + share*step(2)
         state%trailing = state%trailing + share*step(3)
         state%leading = state%leading + share*step(4)
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

   !> Newton step for (half_width, shift, trailing, leading).
   pure subroutine get_newton_step(strip, state, step)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      real(dp), intent(out) :: step(4)
      real(dp) :: e(4), e1_a, e1_b, e2_a, e2_m, e3_a, e3_b, e4_b, e4_m
      real(dp) :: a, b, n, lost, w, sin_a, cos_a, sin_b, cos_b, sin_a1, cos_a1, sin_b1, cos_b1
      real(dp) :: a_factor, b_factor, rest, da, db, gap

      associate (v => strip%foundation%v, trailing => state%trailing, leading => state%leading)
         a = state%half_width - state%shift
         b = state%half_width + state%shift
         sin_a = sin(a); cos_a = cos(a); sin_a1 = sin(a + trailing); cos_a1 = cos(a + trailing)
         sin_b = sin(b); cos_b = cos(b); sin_b1 = sin(b + leading); cos_b1 = cos(b + leading)
         call get_contact_equation(strip, state, e(1), e1_a, e1_b)

         ! trailing adhesion: gap = range after the length `trailing`
         lost = decay(trailing/v)
         w = strip%level + cos_a
         e(2) = -w*lost + 2*sin(a + trailing/2)*sin(trailing/2) - strip%range
         e2_a = sin_a1 - sin_a*(1 - lost)
         e2_m = sin_a1 - w*(1 - lost)/v

         ! free zone: gap = range at its end
         n = free_length(state)
         lost = decay(n/v)
         w = strip%mean + cos_a1 + strip%range + strip%jump
         e(3) = -w*lost + 2*sin(n/2)*sin(state%shift + (leading - trailing)/2) + strip%jump
         e3_a = (w/v - sin_a1)*(1 - lost)
         e3_b = w*(1 - lost)/v + sin_b1

         e(4) = 0; e4_b = 0; e4_m = 1
         if (state%entry <= 0) then
            ! leading adhesion: gap closed after the length `leading`
            lost = decay(leading/v)
            gap = strip%range - strip%jump
            w = strip%level + cos_b1 + gap
            e(4) = -w*lost + gap - 2*sin(b + leading/2)*sin(leading/2)
            e4_b = sin_b - sin_b1*(1 - lost)
            e4_m = -(sin_b1 + w/v)*(1 - lost)
         end if
      end associate

      ! eliminate the lengths of the adhesion zones, then Cramer's rule for the two contact edges
      step = huge(1.0_dp)
      if (min(abs(e2_m), abs(e4_m)) < tiny(1.0_dp)) return
      a_factor = e3_a*(1 - e2_a/e2_m)
      b_factor = e3_b*(1 - e4_b/e4_m)
      rest = -e(3) + e3_a*e(2)/e2_m + e3_b*e(4)/e4_m
      w = a_factor*e1_b - b_factor*e1_a
      if (abs(w) < tiny(1.0_dp)) return
      da = (rest*e1_b + e(1)*b_factor)/w
      db = -(a_factor*e(1) + rest*e1_a)/w
      step = [(da + db)/2, (db - da)/2, -(e(2) + e2_a*da)/e2_m, -(e(4) + e4_b*db)/e4_m]
   end subroutine get_newton_step

   !> The condition that the pressure returns to -stress at the trailing edge of contact.
   pure subroutine get_contact_equation(strip, state, value, by_a, by_b)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      real(dp), intent(out) :: value
      !> Derivatives with respect to the edges a and b.
      real(dp), intent(out) :: by_a, by_b
      real(dp) :: coth, excess, s, c, n, n_slope, along, along_slope, by_width, by_shift

      associate (f => strip%foundation, width => state%half_width, shift => state%shift)
         call coth_and_slope(width/f%u, coth, excess)
         s = sin(width)
         c = cos(width)
         n = f%loss*get_lag(width, f%u, coth)
         n_slope = f%loss*(c*coth + s*(f%u - excess/f%u))
         along = f%loss*c + f%storage*coth*s
         along_slope = -f%loss*s + f%storage*(coth*c - s*excess/f%u)
         value = strip%depth - 2*sin(width/2)**2 - c*2*sin(shift/2)**2 - cos(shift)*n + sin(shift)*along &
            & + state%entry*(coth - 1)/2
         by_width = -cos(shift)*(s + n_slope) + sin(shift)*along_slope - state%entry*excess/(2*f%u)
         by_shift = -sin(shift)*(c - n) + cos(shift)*along
         by_a = (by_width - by_shift)/2
         by_b = (by_width + by_shift)/2
      end associate
   end subroutine get_contact_equation

   !> Newton's method on the two edges of adhesion where there is no contact.
   pure subroutine refine_adhesion_edges(strip, state)
      type(strip_t), intent(in) :: strip
      !> In: a guess of half_width and shift of the adhesion zone. Out: the edges; `is_converged` tells.
      type(steady_state_t), intent(inout) :: state
      real(dp) :: e(2), j(2, 2), step(2), a, b, n, lost, w, determinant, size_now, size_last
      integer :: iteration

      state%is_converged = .false.
      size_last = huge(1.0_dp)
      do iteration = 1, max_iterations
         associate (v => strip%foundation%v, width => state%half_width, shift => state%shift)
            a = width - shift
            b = width + shift
            n = two_pi - 2*width
            ! adhesion from b to -a: gap = range again at its end
            lost = decay(2*width/v)
            w = strip%level + cos(b) + strip%range - strip%jump
            e(1) = -w*lost - 2*sin(width)*sin(shift) - strip%jump
            j(1, 2) = -(sin(b) + w/v)*(1 - lost)
            j(1, 1) = sin(a) - w*(1 - lost)/v
            ! free from -a to b
            lost = decay(n/v)
            w = strip%mean + cos(a) + strip%range + strip%jump
            e(2) = -w*lost + 2*sin(width)*sin(shift) + strip%jump
            j(2, 1) = (w/v - sin(a))*(1 - lost)
            j(2, 2) = w*(1 - lost)/v + sin(b)
         end associate
         determinant = j(1, 1)*j(2, 2) - j(1, 2)*j(2, 1)
         if (abs(determinant) < tiny(1.0_dp)) return
         step = [e(2)*j(1, 2) - e(1)*j(2, 2), e(1)*j(2, 1) - e(2)*j(1, 1)]/determinant
         size_now = maxval(abs(step))/state%half_width
         if (.not. size_now < 0.5_dp) return
         state%half_width = state%half_width + (step(1) + step(2))/2
         state%shift = state%shift + (step(2) - step(1))/2
         if (state%half_width <= 0 .or. 2*state%half_width >= two_pi) return
         state%is_converged = size_now <= close_enough .or. (size_now <= round_off .and. size_now >= size_last/2)
         if (state%is_converged) return
         size_last = size_now
      end do
   end subroutine refine_adhesion_edges

   !> Do the edges of contact with adhesion zones fulfil every inequality of the model? The closed forms
   !> then have no earlier event (see `march`), so signs at the edges are enough.
   pure logical function is_admissible(strip, state)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      real(dp) :: a, b

      a = state%half_width - state%shift
      b = state%half_width + state%shift
      is_admissible = state%is_converged .and. state%half_width > 0 .and. state%trailing > 0 &
         & .and. state%leading >= 0 .and. free_length(state) > 0
      if (.not. is_admissible) return
      is_admissible = drive(strip, -a) < 0 .and. drive(strip, -a - state%trailing) < -strip%range &
         & .and. drive(strip, b + state%leading) > strip%stress - strip%range &
         & .and. drive(strip, b) > state%entry
   end function is_admissible

   !> Derivative of the return map at a steady state with contact and adhesion zones. A jump of the rate of
   !> the gap where adhesion starts or ends multiplies a disturbance; the zones damp it.
   pure real(dp) function get_multiplier(strip, state) result(multiplier)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      real(dp) :: a1, b, b1, release, attach, after

      associate (f => strip%foundation)
         a1 = state%half_width - state%shift + state%trailing
         b = state%half_width + state%shift
         b1 = b + state%leading
         ! rates of the gap (times v) before and after the edge
         release = -drive(strip, -a1) - strip%range
         attach = -drive(strip, b1) + strip%stress - strip%range
         if (state%entry > 0) then
            after = -drive(strip, b) + state%entry
         else
            after = -drive(strip, b1) - strip%range + strip%jump
         end if
         multiplier = exp(-min(2*state%half_width/f%u + (two_pi - 2*state%half_width)/f%v, longest_decay)) &
            & *((release + strip%stress - strip%jump)/release)*(after/attach)
      end associate
   end function get_multiplier

end module adfric_wavy_edges

! SPDX-License-Identifier: GPL-3.0-or-later
!> The curve of equilibrium of an indenter by Maugis's theory with Dugdale's law (D. Maugis, J. Colloid Interface Sci. 150, 1992, 243),
!> for any profile, reduced: a stress S pulls on a < r < c, where the gap is at most h. With c^2 = a^2 + s^2, a = c cos(th),
!>
!>     h = (2/pi) J + (4 S/pi) [s th - s^2/(c + a)]
!>     P = P1(a) - 2 S (c^2 th + a s),    delta = g(a) - 2 S s
!>
!> J and I of `adfric_round_annulus`. For given a the right side of the first equation rises with s: s is unique. Along the curve
!>
!>     dP/da = 2 Q F_P/N,   ddelta/da = Q F_d/N,   Q = g' sin(th) + 2 S cos(th)
!>     F_P = 2 a I/c - 4 S [c th^2 + a (1 - cos(th))],    F_d = 2 I/c - 4 S (1 - cos(th))
!>     N = 2 I sin(th)/c + 4 S [th - sin(th) (1 - cos(th))]
!>
!> Q and N are positive, so a state is stable under load where F_P > 0, at given approach where F_d > 0, and on a spring of compliance s
!> where F_d + 2 s F_P > 0. None contains g'(a), and their terms are positive but for the one difference that makes a fold.
module adfric_round_dugdale_curve
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, half_pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_round_annulus, only: get_annulus
   use adfric_round_curve, only: curve_t, state_t, curve_interval_t, disc_range_t, most_intervals, most_disc_ranges, control_load, &
      & control_approach, control_spring, control_radius, stability_control
   use adfric_round_dugdale_discs, only: find_stable_discs
   use adfric_round_dugdale_folds, only: find_stable_parts
   use adfric_round_dugdale_stretch, only: margins_t
   use adfric_round_shape, only: spot_t, within_edge
   implicit none (type, external)
   private
   public :: dugdale_curve_t, get_range

   !> A curve of Maugis's theory.
   type, extends(curve_t) :: dugdale_curve_t
      !> Stress S of adhesion, and its range h; both > 0.
      real(dp) :: stress = 1, range = 1
   contains
      procedure :: get_state
      procedure :: get_sums
      procedure :: find_intervals
      procedure :: find_discs
      procedure :: get_disc
      procedure :: has_space
   end type dugdale_curve_t

   !> The differences that make folds, along the curve.
   type, extends(margins_t) :: dugdale_margins_t
      !> The curve.
      type(dugdale_curve_t) :: curve
   contains
      procedure :: get_margin
   end type dugdale_margins_t

contains

   !> See `curve_t`.
   pure subroutine get_state(self, u, is_beyond, state)
      class(dugdale_curve_t), intent(in) :: self
      real(dp), intent(in) :: u
      logical, intent(in) :: is_beyond
      type(state_t), intent(out) :: state
      real(dp) :: s, c, th, opening, intensity, f_load, f_approach, n, q, one_less

      call self%shape%evaluate(u, is_beyond, state%spot)
      call find_zone(self, state%spot, is_beyond, s, opening, intensity, state%is_converged)
      if (.not. state%is_converged) return
      associate (a => state%spot%radius, pull => self%stress)
         c = sqrt(a*a + s*s)
         th = atan2(s, a)
         one_less = (s/c)*(s/(c + a))
         state%adhesion_radius = c
         state%stress = pull
         state%neck = 2*pull*s
         state%load = state%spot%load - 2*pull*(c**2*th + a*s)
         state%approach = state%spot%depth - state%neck
         f_load = 2*a*intensity/c - 4*pull*(c*th**2 + a*one_less)
         f_approach = 2*intensity/c - 4*pull*one_less
         n = 2*intensity*s/c**2 + 4*pull*(th - one_less*s/c)
         q = state%spot%depth_slope*s/c + 2*pull*a/c*state%spot%radius_slope
         state%load_slope = 2*q*f_load/n
         state%approach_slope = q*f_approach/n
         state%stiffness = not_a_number()
         if (abs(f_approach) > 0) state%stiffness = 2*f_load/f_approach
         state%is_stable = [f_load > 0, f_approach > 0, f_approach + 2*self%compliance*f_load > 0]
      end associate
   end subroutine get_state

   !> See `curve_t`.
   pure subroutine get_sums(self, u, is_beyond, load, load_slope, approach, approach_slope)
      class(dugdale_curve_t), intent(in) :: self
      real(dp), intent(in) :: u
      logical, intent(in) :: is_beyond
      real(dp), intent(out) :: load, load_slope, approach, approach_slope
      type(state_t) :: state

      call self%get_state(u, is_beyond, state)
      load = state%load
      load_slope = state%load_slope
      approach = state%approach
      approach_slope = state%approach_slope
   end subroutine get_sums

   !> The zone of adhesion of a contact: s, with J and I. ln of the right side is almost linear in ln s, so Newton's method comes
   !> from anywhere.
   pure subroutine find_zone(self, spot, is_beyond, s, opening, intensity, is_converged)
      class(dugdale_curve_t), intent(in) :: self
      type(spot_t), intent(in) :: spot
      !> Does the contact reach beyond the corner?
      logical, intent(in) :: is_beyond
      !> Receives s = sqrt(c^2 - a^2).
      real(dp), intent(out) :: s
      !> Receive J and I.
      real(dp), intent(out) :: opening, intensity
      logical, intent(out) :: is_converged
      integer, parameter :: most_steps = 200
      real(dp), parameter :: small_step = 1.0e-8_dp, largest_step = 5.0_dp
      real(dp) :: low, high, value, slope, step, last, widest
      integer :: k

      low = 0
      widest = huge(s)
      s = 0
      opening = 0
      intensity = 0
      is_converged = .false.
      if (self%shape%edge < huge(s)) then
         if (.not. spot%radius < within_edge*self%shape%edge) return
         widest = within_edge*sqrt((self%shape%edge - spot%radius)*(self%shape%edge + spot%radius))
      end if
      high = widest
      s = min(guess_zone(self, spot), widest/2)
      last = huge(last)
      do k = 1, most_steps
         call get_range(self, spot, is_beyond, s, value, slope, opening, intensity)
         if (value < self%range) low = s
         if (.not. value < self%range) high = s
         step = -log(value/self%range)/slope
         is_converged = abs(step) <= small_step
         step = sign(min(abs(step), largest_step), step)
         if (is_converged) exit
         last = s*exp(step)
         if (.not. (last > low .and. last < high)) then
            last = sqrt(low*high)
            if (.not. low > 0) last = high/2
            if (high >= widest) last = (low + widest)/2
            if (.not. (last > low .and. last < high)) exit
         end if
         s = last
      end do
      if (.not. is_converged) return
      s = s*(1 + step)
      call get_annulus(self%shape, spot, is_beyond, s, opening, intensity)
   end subroutine find_zone

   !> Does the zone of a contact end before the vertical edge of the profile?
   pure logical function has_space(self, u, is_beyond)
      class(dugdale_curve_t), intent(in) :: self
      !> The unknown of the contact, >= 0.
      real(dp), intent(in) :: u
      logical, intent(in) :: is_beyond
      type(spot_t) :: spot
      real(dp) :: value, slope, opening, intensity

      has_space = .true.
      if (.not. self%shape%edge < huge(u)) return
      call self%shape%evaluate(u, is_beyond, spot)
      has_space = spot%radius < within_edge*self%shape%edge
      if (.not. has_space) return
      call get_range(self, spot, is_beyond, within_edge*sqrt((self%shape%edge - spot%radius)*(self%shape%edge + spot%radius)), &
         & value, slope, opening, intensity)
      has_space = value > self%range
   end function has_space

   !> The range of adhesion that a zone needs, and the derivative of its logarithm by that of s.
   pure subroutine get_range(self, spot, is_beyond, s, value, slope, opening, intensity)
      class(dugdale_curve_t), intent(in) :: self
      type(spot_t), intent(in) :: spot
      logical, intent(in) :: is_beyond
      !> s = sqrt(c^2 - a^2), > 0.
      real(dp), intent(in) :: s
      !> The right side of the equation of the zone, and s d/ds of its logarithm.
      real(dp), intent(out) :: value, slope
      !> J and I.
      real(dp), intent(out) :: opening, intensity
      real(dp) :: c, th, pull

      call get_annulus(self%shape, spot, is_beyond, s, opening, intensity)
      c = sqrt(spot%radius**2 + s*s)
      th = atan2(s, spot%radius)
      pull = 4*self%stress/pi
      value = 2*opening/pi + pull*s*(th - s/(c + spot%radius))
      slope = 2*intensity*s/(pi*c**2) + pull*(th - (s/c)**2*(s/(c + spot%radius)))
      slope = slope*s/value
   end subroutine get_range

   !> A zone that is not too narrow, from the stress alone: its opening is about (4 S/pi) s^2/2a for a narrow zone, and
   !> (4 S/pi) (pi/2 - 1) s for a wide one.
   pure real(dp) function guess_zone(self, spot) result(s)
      class(dugdale_curve_t), intent(in) :: self
      type(spot_t), intent(in) :: spot
      real(dp) :: gap, narrow

      gap = pi*self%range/(4*self%stress)
      s = gap/(half_pi - 1)
      if (spot%radius > 0) s = max(s, sqrt(2*spot%radius*gap))
      ! without stress the profile alone opens the gap, beside a large contact by (2/3 pi) g' s^3/a
      s = min(s, self%shape%radius_of_height(self%range) + spot%radius)
      narrow = 1.5_dp*pi*self%range*spot%radius_slope
      if (narrow > 0 .and. narrow < spot%depth_slope*spot%radius**2) s = min(s, (narrow*spot%radius/spot%depth_slope)**(1.0_dp/3))
   end function guess_zone

   !> See `curve_t`.
   pure subroutine find_intervals(self, control, intervals, n, is_converged)
      class(dugdale_curve_t), intent(in) :: self
      integer, intent(in) :: control
      type(curve_interval_t), intent(out) :: intervals(most_intervals)
      integer, intent(out) :: n
      logical, intent(out) :: is_converged
      type(dugdale_margins_t) :: margins

      allocate (margins%curve%shape, source=self%shape)
      margins%curve%stress = self%stress
      margins%curve%range = self%range
      margins%curve%compliance = self%compliance
      margins%control = stability_control(control)
      call find_stable_parts(margins, self%shape, self%stress, self%range, intervals, n, is_converged)
   end subroutine find_intervals

   !> See `curve_t`.
   pure subroutine find_discs(self, control, discs, n)
      class(dugdale_curve_t), intent(in) :: self
      integer, intent(in) :: control
      type(disc_range_t), intent(out) :: discs(most_disc_ranges)
      integer, intent(out) :: n
      type(state_t) :: touching
      real(dp) :: pull

      n = 0
      if (control == control_load .or. control == control_radius) return
      call self%get_state(0.0_dp, .not. self%shape%corner > 0, touching)
      if (.not. touching%is_converged) return
      pull = 0
      if (control == control_spring) pull = 2*pi*self%compliance*self%stress
      call find_stable_discs(self%shape, 4*self%stress/pi, pull, touching%adhesion_radius, discs, n)
   end subroutine find_discs

   !> See `curve_t`: P = -pi S c^2, delta = f(c) - 4 S c/pi - h.
   pure subroutine get_disc(self, c, state)
      class(dugdale_curve_t), intent(in) :: self
      real(dp), intent(in) :: c
      type(state_t), intent(out) :: state
      real(dp) :: height, slope

      call self%shape%get_profile(c, height, slope)
      call self%shape%evaluate(0.0_dp, .not. self%shape%corner > 0, state%spot)
      state%spot%radius_slope = 0
      state%load = -pi*self%stress*c**2
      state%approach = height - 4*self%stress*c/pi - self%range
      state%disc_terms = [pi*self%stress*c**2, height + 4*self%stress*c/pi + self%range]
      state%neck = 2*self%stress*c
      state%adhesion_radius = c
      state%stress = self%stress
      state%load_slope = -2*pi*self%stress*c
      state%approach_slope = slope - 4*self%stress/pi
      state%is_stable = [.false., state%approach_slope > 0, state%approach_slope + self%compliance*state%load_slope > 0]
      state%stiffness = not_a_number()
      if (abs(state%approach_slope) > 0) state%stiffness = state%load_slope/state%approach_slope
   end subroutine get_disc

   !> See `margins_t`.
   pure subroutine get_margin(self, u, is_beyond, margin, is_converged)
      class(dugdale_margins_t), intent(in) :: self
      real(dp), intent(in) :: u
      logical, intent(in) :: is_beyond
      !> F_P, F_d or F_d + 2 s F_P over the sum of its terms, between -1 and 1.
      real(dp), intent(out) :: margin
      logical, intent(out) :: is_converged
      type(spot_t) :: spot
      real(dp) :: s, c, th, opening, intensity, gain, loss, shares(2)

      call self%curve%shape%evaluate(u, is_beyond, spot)
      call find_zone(self%curve, spot, is_beyond, s, opening, intensity, is_converged)
      margin = 0
      if (.not. is_converged) return
      c = sqrt(spot%radius**2 + s*s)
      th = atan2(s, spot%radius)
      gain = intensity
      loss = 2*self%curve%stress*(s*s/(c + spot%radius))
      ! of F_d c/2 and of what F_P has beside it
      select case (self%control)
      case (control_load)
         shares = [spot%radius, 1.0_dp]
      case (control_approach)
         shares = [1.0_dp, 0.0_dp]
      case default
         shares = [1 + 2*self%curve%compliance*spot%radius, 2*self%curve%compliance]
      end select
      gain = shares(1)*gain
      loss = shares(1)*loss + shares(2)*2*self%curve%stress*(c*th)**2
      margin = (gain - loss)/(gain + loss)
   end subroutine get_margin

end module adfric_round_dugdale_curve

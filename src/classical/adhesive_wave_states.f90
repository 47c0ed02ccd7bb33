!> The states of an adhesive wave (`adhesive_wave`) under a load, or at a penetration, on each branch.
!>
!> **Load.** With labels (the cohesive width c) held, a load has one state, and its gap at the edge exceeds eta where P < P(c). More
!> labels close the gap, so there are a least and a greatest equilibrium (`adhesion` of the documents): `approach` is the first c
!> with P(c) >= P, which exists for P >= 0, and `adhered` the last with P(c) <= P. P(c) falls from 0 to its minimum, rises to its
!> maximum and falls to the end of saturation; without folds it only falls. So the approach is in the zones up to the largest load
!> and saturated beyond; the adhered branch is saturated down to the end of saturation, then in the zones down to the least load.
!> After a turn at a load (the approach's state there) it is in the zones, if it was at the turn, down to the least load.
!>
!> In the zones, Q = P + sigma phi and cos gamma = cos phi cos alpha make the excess of the range an explicit function of phi. It has
!> one root between the folds, and its slope is 2 load_slope d gamma/d phi.
!>
!> **Penetration.** Without contact up to delta = -eta, where the wave jumps in; then between the minimum and the maximum of the
!> penetration, or saturated. `adhered` is saturated down to the end of saturation, then as `approach` down to the minimum.
module adfric_classical_adhesive_wave_states
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_numerics_scalar_root, only: equation_t, find_root
   use adfric_classical_adhesive_wave, only: zones_t, get_zones_of_place, get_zones_of_angle, range_excess, load_slope, &
      & penetration_slope, get_range_slopes, open_crest
   use adfric_classical_adhesive_wave_curve, only: adhesive_wave_t, find_contact, guess_y, get_curve_state, is_open, &
      & get_saturated_penetration
   use adfric_classical_adhesive_wave_integrals, only: get_zone_integrals
   use adfric_classical_westergaard, only: find_wave_pressure
   implicit none (type, external)
   private
   public :: wave_adhesion_t, state_of_load, state_of_penetration, state_of_zones, dissipated_energy

   !> Branches: the least and the most adhered state.
   integer, parameter, public :: branch_approach = 0, branch_adhered = 1
   !> Regimes: no equilibrium; out of reach; cohesion without contact; contact, cohesion and free surface; cohesion in the whole gap;
   !> contact everywhere.
   integer, parameter, public :: regime_none = -1, regime_free = 0, regime_no_contact = 1, regime_zones = 2, regime_saturated = 3, &
      & regime_full = 4
   !> A Newton step of this relative size is the last.
   real(dp), parameter :: last_step = 1.0e-9_dp
   integer, parameter :: max_steps = 100
   !> Newton steps in two unknowns, the size of the last one, whose error is its square, and the largest y for them.
   integer, parameter :: max_newton = 12
   real(dp), parameter :: close_enough = 1.0e-8_dp, largest_y = 12.0_dp

   !> A state.
   type :: wave_adhesion_t
      !> One of `regime_...`.
      integer :: regime = regime_none
      !> Half-widths a of contact and c of cohesion [l].
      real(dp) :: contact_half_width = 0, cohesive_half_width = 0
      !> P [p*], delta and the gap of the crest [D].
      real(dp) :: mean_pressure = 0, penetration = 0, crest_gap = 0
      !> Energy of the solid, and of the attraction, which is 0 far apart and -S eta in contact [p* D].
      real(dp) :: elastic_energy = 0, adhesion_energy = 0
      !> Q = sin^2(pi a).
      real(dp) :: square = 0
      !> The zones in regimes `no_contact` and `zones`.
      type(zones_t) :: zones
   end type wave_adhesion_t

   !> delta of an open crest as a function of x, minus the wanted one.
   type, extends(equation_t) :: open_equation_t
      !> The wave.
      type(adhesive_wave_t) :: wave
      !> The wanted penetration.
      real(dp) :: penetration = 0
   contains
      procedure :: evaluate => evaluate_open
   end type open_equation_t

   !> delta in contact as a function of x, minus the wanted one.
   type, extends(equation_t) :: contact_equation_t
      !> The wave.
      type(adhesive_wave_t) :: wave
      !> The wanted penetration.
      real(dp) :: penetration = 0
   contains
      procedure :: evaluate => evaluate_contact
   end type contact_equation_t

contains

   !> The state under a mean pressure.
   pure subroutine state_of_load(wave, load, branch, state, is_converged, turning_load)
      !> The wave.
      type(adhesive_wave_t), intent(in) :: wave
      !> P, compression > 0 [p*].
      real(dp), intent(in) :: load
      !> `branch_approach` or `branch_adhered`.
      integer, intent(in) :: branch
      !> The state; `regime_none` where there is no equilibrium.
      type(wave_adhesion_t), intent(out) :: state
      !> Was it found, or is there none?
      logical, intent(out) :: is_converged
      !> Load of the approach's state from which the adhered branch comes, instead of saturation.
      real(dp), intent(in), optional :: turning_load
      logical :: is_partial

      is_converged = .true.
      is_partial = wave%has_folds
      if (is_partial) is_partial = load >= wave%least_load .and. load <= wave%largest_load
      if (branch == branch_approach) then
         if (load < 0) return
      else if (.not. was_partial(wave, turning_load)) then
         is_partial = is_partial .and. load < wave%saturation_load
         if (.not. is_partial .and. load < wave%saturation_load) return
      else if (load < wave%least_load) then
         return
      end if
      if (is_partial) then
         call find_partial(wave, load, state%zones, is_converged)
         call state_of_zones(wave, state%zones, state)
         state%mean_pressure = load
      else
         call saturate(wave, load, state)
      end if
   end subroutine state_of_load

   !> Was the approach's state at a turn partial contact?
   pure logical function was_partial(wave, turning_load)
      !> The wave.
      type(adhesive_wave_t), intent(in) :: wave
      !> The load at the turn; absent: full contact.
      real(dp), intent(in), optional :: turning_load

      was_partial = .false.
      if (present(turning_load)) was_partial = wave%has_folds .and. turning_load >= 0 .and. turning_load <= wave%largest_load
   end function was_partial

   !> Zones between the folds under a load: Newton's method in phi, with bisection.
   pure subroutine find_partial(wave, load, zones, is_converged)
      !> The wave.
      type(adhesive_wave_t), intent(in) :: wave
      !> P [p*], from the least to the largest.
      real(dp), intent(in) :: load
      !> The zones.
      type(zones_t), intent(out) :: zones
      !> Were they found?
      logical, intent(out) :: is_converged
      real(dp) :: low, high, phi, value, slope, step, old
      integer :: i

      low = max(0.0_dp, -load/wave%sigma)
      high = min(pi/2, (1 - load)/wave%sigma)
      phi = guess_angle(wave, load)
      if (.not. (phi > low .and. phi < high)) phi = low + (high - low)/2
      old = high - low
      is_converged = .false.
      do i = 1, max_steps
         call get_zones_of_angle(phi, load + wave%sigma*phi, zones)
         value = sign(huge(value), zones%place - wave%least%place)
         if (zones%place > wave%least%place .and. zones%place < wave%largest%place) value = range_excess(wave%sigma, wave%range, &
            & zones)
         slope = 2*load_slope(wave%sigma, zones)*angle_slope(wave%sigma, zones)
         if (value < 0) low = phi
         if (value > 0) high = phi
         is_converged = abs(value) < tiny(value)
         if (is_converged) return
         step = -value/slope
         if (slope > 0 .and. abs(step) <= last_step*phi .and. phi + step > low .and. phi + step < high) then
            phi = phi + step
            is_converged = .true.
         else if (.not. (slope > 0 .and. phi + step > low .and. phi + step < high .and. abs(step) < old/2)) then
            step = low + (high - low)/2 - phi
            is_converged = high - low <= 4*epsilon(phi)*high
            phi = phi + step
            old = high - low
         else
            phi = phi + step
            old = abs(step)
         end if
         if (is_converged) exit
      end do
      call get_zones_of_angle(phi, load + wave%sigma*phi, zones)
   end subroutine find_partial

   !> A first guess of phi, between those of both folds.
   pure real(dp) function guess_angle(wave, load) result(phi)
      !> The wave.
      type(adhesive_wave_t), intent(in) :: wave
      !> P [p*].
      real(dp), intent(in) :: load
      real(dp) :: share

      share = (load - wave%least_load)/(wave%largest_load - wave%least_load)
      phi = wave%least%phi + sqrt(share)*(wave%largest%phi - wave%least%phi)
   end function guess_angle

   !> d gamma/d phi under a load, (sin phi cos alpha + sigma cos phi/(2 cos alpha))/sin gamma.
   pure real(dp) function angle_slope(sigma, zones)
      !> sigma = 2 S/pi.
      real(dp), intent(in) :: sigma
      !> The zones.
      type(zones_t), intent(in) :: zones
      real(dp) :: cosine

      cosine = sqrt(1 - zones%square)
      angle_slope = (sin(zones%phi)*cosine + sigma*cos(zones%phi)/(2*cosine))/zones%sine
   end function angle_slope

   !> The saturated or full state under a load.
   pure subroutine saturate(wave, load, state)
      !> The wave.
      type(adhesive_wave_t), intent(in) :: wave
      !> P [p*], -S at least.
      real(dp), intent(in) :: load
      !> The state.
      type(wave_adhesion_t), intent(inout) :: state

      state%mean_pressure = load
      state%square = min(max(load + wave%stress, 0.0_dp), 1.0_dp)
      state%penetration = get_saturated_penetration(state%square)
      call fill_saturated(wave, state)
   end subroutine saturate

   !> What follows from Q and delta in saturation.
   pure subroutine fill_saturated(wave, state)
      !> The wave.
      type(adhesive_wave_t), intent(in) :: wave
      !> The state, with Q and delta.
      type(wave_adhesion_t), intent(inout) :: state

      state%regime = merge(regime_full, regime_saturated, state%square >= 1)
      state%contact_half_width = half_width(state%square)
      state%cohesive_half_width = 0.5_dp
      state%crest_gap = max(0.0_dp, -state%penetration)
      state%elastic_energy = 0
      if (state%square > 0) state%elastic_energy = state%square**2*(1 - 2*log(state%square))/4
      state%adhesion_energy = wave%stress*((1 - state%penetration) - wave%range)
   end subroutine fill_saturated

   !> a of Q.
   pure real(dp) function half_width(square)
      !> Q, 0 to 1.
      real(dp), intent(in) :: square

      half_width = atan2(sqrt(square), sqrt(1 - square))/pi
   end function half_width

   !> The state of zones in equilibrium. Its energies are, by dE = P d delta - sigma gamma d eta + (adhesion/sigma) d sigma,
   !>
   !>     E = Q^2 (1 - 2 ln Q)/4 + E1 + E2,    adhesion = E1 + 2 E2 - 2 sigma M P + 2 sigma^2 gamma K
   !>     E1 = sigma [phi (1 - Q) - 2 Lambda Q phi - m sin gamma cos gamma + 2 gamma (y Q - m sin^2 gamma)]
   !>     E2 = sigma^2 (W - 2 gamma K)
   pure subroutine state_of_zones(wave, zones, state)
      !> The wave.
      type(adhesive_wave_t), intent(in) :: wave
      !> The zones.
      type(zones_t), intent(in) :: zones
      !> The state.
      type(wave_adhesion_t), intent(out) :: state
      real(dp) :: k, m, w, gamma, e1, e2, energy

      associate (z => zones, q => zones%square, sigma => wave%sigma)
         state%zones = z
         state%square = q
         state%regime = merge(regime_no_contact, regime_zones, z%y >= open_crest)
         state%contact_half_width = half_width(q)
         gamma = atan(z%tangent)
         state%cohesive_half_width = gamma/pi
         state%mean_pressure = q - sigma*z%phi
         if (state%regime == regime_no_contact) state%crest_gap = max(0.0_dp, -range_excess(sigma, wave%range, z))
         call get_zone_integrals(z%tangent, z%m, z%phi, z%distance, k, m, w)
         state%penetration = q*(1 + 2*z%lambda) + 2*sigma*m - state%crest_gap
         e1 = sigma*(z%phi*(1 - q) - 2*z%lambda*q*z%phi - z%m*z%sine*z%cosine + 2*gamma*(z%y*q - z%m*z%sine**2))
         e2 = sigma**2*(w - 2*gamma*k)
         energy = q**2*(1 + 4*z%lambda)/4 + e1 + e2
         state%adhesion_energy = e1 + 2*e2 - 2*sigma*m*state%mean_pressure + 2*sigma**2*gamma*k
         state%elastic_energy = energy - state%adhesion_energy
      end associate
   end subroutine state_of_zones

   !> The state at a penetration.
   pure subroutine state_of_penetration(wave, penetration, branch, state, is_converged, turning_load)
      !> The wave.
      type(adhesive_wave_t), intent(in) :: wave
      !> delta [D], at most 1; in full contact every load from 1 - S on belongs to 1, and the least is given.
      real(dp), intent(in) :: penetration
      !> `branch_approach` or `branch_adhered`.
      integer, intent(in) :: branch
      !> The state; `regime_none` for delta > 1.
      type(wave_adhesion_t), intent(out) :: state
      !> Was it found, or is there none?
      logical, intent(out) :: is_converged
      !> Load of the approach's state from which the adhered branch comes, instead of saturation.
      real(dp), intent(in), optional :: turning_load
      logical :: is_partial

      is_converged = .true.
      if (penetration > 1) return
      is_partial = penetration <= wave%largest_penetration
      if (branch == branch_approach) then
         if (penetration <= -wave%range) call set_free(penetration, state)
      else
         if (.not. was_partial(wave, turning_load)) is_partial = is_partial .and. penetration < wave%saturation_penetration
         if (is_partial .and. penetration < wave%least_penetration) call set_free(penetration, state)
      end if
      if (state%regime == regime_free) return
      if (is_partial) then
         call find_penetration(wave, penetration, state, is_converged)
      else
         call find_wave_pressure(penetration, state%square, is_converged)
         state%penetration = penetration
         state%mean_pressure = state%square - wave%stress
         call fill_saturated(wave, state)
      end if
   end subroutine state_of_penetration

   !> The state out of reach.
   pure subroutine set_free(penetration, state)
      !> delta [D].
      real(dp), intent(in) :: penetration
      !> The state.
      type(wave_adhesion_t), intent(inout) :: state

      state%regime = regime_free
      state%penetration = penetration
      state%crest_gap = -penetration
   end subroutine set_free

   !> The state between the minimum and the maximum of the penetration, where delta rises with x.
   pure subroutine find_penetration(wave, penetration, state, is_converged)
      !> The wave.
      type(adhesive_wave_t), intent(in) :: wave
      !> delta [D].
      real(dp), intent(in) :: penetration
      !> The state.
      type(wave_adhesion_t), intent(inout) :: state
      !> Was it found?
      logical, intent(out) :: is_converged
      type(open_equation_t) :: open
      type(contact_equation_t) :: contact
      type(zones_t) :: zones
      real(dp) :: x, low, high, ends(2)

      low = wave%lowest%place
      high = wave%highest%place
      ends = 2
      if (wave%has_zones) ends = [open_penetration(wave, wave%first_place), open_penetration(wave, wave%last_place)]
      if (wave%first_place <= low) ends(1) = -huge(x)
      if (wave%last_place >= high) ends(2) = 2
      if (wave%has_zones .and. penetration > ends(1) .and. penetration < ends(2)) then
         low = max(low, wave%first_place)
         high = min(high, wave%last_place)
         x = low + (high - low)*sqrt((penetration - wave%least_penetration)/(wave%largest_penetration - wave%least_penetration))
         call get_zones_of_place(x, guess_y(wave, x), zones)
         call approach_contact(wave, penetration, low, high, zones, is_converged)
         if (.not. is_converged) then
            contact = contact_equation_t(wave, penetration)
            call find_root(contact, low, high, .true., x, is_converged)
            zones%y = 0
            if (is_converged) call find_contact(wave, x, zones, is_converged)
         end if
      else
         if (wave%has_zones .and. penetration <= ends(1)) high = min(high, wave%first_place)
         if (wave%has_zones .and. penetration >= ends(2)) low = max(low, wave%last_place)
         open = open_equation_t(wave, penetration)
         x = low + (high - low)/2
         call find_root(open, low, high, .true., x, is_converged)
         call get_zones_of_place(x, open_crest, zones)
      end if
      if (.not. is_converged) return
      call state_of_zones(wave, zones, state)
      state%penetration = penetration
   end subroutine find_penetration

   !> Newton's method for (2) and (3) in x and y, which may fail. A solution between the extremes is the only one.
   pure subroutine approach_contact(wave, penetration, low, high, zones, is_converged)
      !> The wave.
      type(adhesive_wave_t), intent(in) :: wave
      !> delta [D].
      real(dp), intent(in) :: penetration
      !> Bounds of x.
      real(dp), intent(in) :: low, high
      !> In: a first guess. Out: the zones.
      type(zones_t), intent(inout) :: zones
      !> Were they found?
      logical, intent(out) :: is_converged
      real(dp) :: by_place, by_y, range, load, delta, gap, dx, dy
      integer :: i

      is_converged = .false.
      do i = 1, max_newton
         range = range_excess(wave%sigma, wave%range, zones)
         call get_range_slopes(wave%sigma, zones, by_place, by_y)
         call get_curve_state(wave, zones, load, delta, gap)
         associate (ratio => zones%lambda/zones%y)
            dx = (penetration - delta - ratio*range)*zones%y/(2*zones%sine*zones%cosine*penetration_slope(wave%sigma, zones))
         end associate
         dy = -(range + by_place*dx)/by_y
         is_converged = abs(dx) < close_enough .and. abs(dy) < close_enough*zones%y
         if (.not. is_converged) dx = min(max(dx, (low - zones%place)/2), (high - zones%place)/2)
         dy = min(max(dy, -zones%y/2), 2*zones%y)
         call get_zones_of_place(zones%place + dx, zones%y + dy, zones)
         if (is_converged .or. .not. zones%y < largest_y) exit
      end do
      is_converged = is_converged .and. zones%place >= low .and. zones%place <= high
   end subroutine approach_contact

   !> delta with an open crest.
   pure real(dp) function open_penetration(wave, place) result(penetration)
      !> The wave.
      type(adhesive_wave_t), intent(in) :: wave
      !> ln T.
      real(dp), intent(in) :: place
      type(zones_t) :: zones
      real(dp) :: load, gap

      call get_zones_of_place(place, open_crest, zones)
      call get_curve_state(wave, zones, load, penetration, gap)
   end function open_penetration

   !> See `open_equation_t`.
   pure subroutine evaluate_open(self, x, value, slope)
      !> The equation with its wave.
      class(open_equation_t), intent(in) :: self
      !> ln T.
      real(dp), intent(in) :: x
      !> delta minus the wanted one.
      real(dp), intent(out) :: value
      !> Its derivative.
      real(dp), intent(out) :: slope
      real(dp) :: twice

      value = open_penetration(self%wave, x) - self%penetration
      twice = 1/cosh(x)
      slope = twice*(twice + self%wave%sigma*log(2*twice))
   end subroutine evaluate_open

   !> See `contact_equation_t`.
   pure subroutine evaluate_contact(self, x, value, slope)
      !> The equation with its wave.
      class(contact_equation_t), intent(in) :: self
      !> ln T.
      real(dp), intent(in) :: x
      !> delta minus the wanted one.
      real(dp), intent(out) :: value
      !> Its derivative.
      real(dp), intent(out) :: slope
      type(zones_t) :: zones
      real(dp) :: load, gap
      logical :: is_converged

      call find_contact(self%wave, x, zones, is_converged)
      call get_curve_state(self%wave, zones, load, value, gap)
      value = value - self%penetration
      slope = penetration_slope(self%wave%sigma, zones)/(cosh(x)*zones%y)
   end subroutine evaluate_contact

   !> Energy lost in a jump at a held penetration [p* D], > 0.
   elemental real(dp) function dissipated_energy(before, after)
      !> States before and after it.
      type(wave_adhesion_t), intent(in) :: before, after

      dissipated_energy = (before%elastic_energy - after%elastic_energy) + (before%adhesion_energy - after%adhesion_energy)
   end function dissipated_energy

end module adfric_classical_adhesive_wave_states

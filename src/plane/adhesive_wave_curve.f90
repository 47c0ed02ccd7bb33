! SPDX-License-Identifier: GPL-3.0-or-later
!> The curve of equilibria of an adhesive wave (`adhesive_wave`) with all its events.
!>
!> For each c between 0 and 1/2 there is one state: contact if the right side of (2) exceeds eta at y = infinity,
!>
!>     top(gamma) = 2 sin^2 gamma + 2 sigma K,    d top/d gamma = 2 sin 2 gamma + 2 sigma ln(2 cos gamma)
!>
!> else an open crest. Below eta = 2 contact begins once and stays; above, it is there between two positions, or nowhere. The
!> penetration has one minimum, at c < 1/4, and one maximum, at c > 1/4. For c < 1/4 the range rises with c at given y, too, so that
!> the minimum can be sought along y, which tells contacts apart that are too narrow for a number c. Beyond c = 1/2 the wave is
!> saturated: Q = P + S, delta = Q (1 - ln Q). Proofs: docs/theory/adhesive_wave.md; the load: `adhesive_wave_folds`.
module adfric_plane_adhesive_wave_curve
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_base_constants, only: pi
   use adfric_numerics_hyperbolic, only: sinh_minus_argument
   use adfric_numerics_scalar_root, only: equation_t, find_root
   use adfric_plane_adhesive_wave, only: zones_t, get_zones_of_position, range_excess, get_range_slopes, open_crest
   use adfric_plane_adhesive_wave_folds, only: fold_turn_t, find_fold_turn, find_least_load, find_largest_load
   use adfric_plane_adhesive_wave_integrals, only: get_zone_integrals
   implicit none (type, external)
   private
   public :: adhesive_wave_t, find_curve, find_contact, guess_y, get_curve_state, is_open, get_saturated_penetration

   !> Stresses and ranges that are handled.
   real(dp), parameter, public :: least_amount = 1.0e-12_dp, largest_amount = 1.0e12_dp
   !> Bounds of ln T.
   real(dp), parameter, public :: least_position = -100.0_dp, largest_position = 100.0_dp
   !> A Newton step of this size of y, or of ln T, is the last.
   real(dp), parameter :: last_step = 1.0e-9_dp
   !> Guesses of y are smaller; beyond, the range depends on y hardly.
   real(dp), parameter :: largest_guess = 15.0_dp

   !> A wave with its attraction, and the events of its curve.
   type :: adhesive_wave_t
      !> S, sigma = 2 S/pi and eta.
      real(dp) :: stress = 0, sigma = 0, range = 0
      !> Is there contact at any c < 1/2?
      logical :: has_zones = .false.
      !> ln T where the crest touches and where it opens again; without contact, both at the maximum of top.
      real(dp) :: first_position = 0, last_position = 0
      !> Has the load a minimum and a maximum?
      logical :: has_folds = .false.
      !> Zones at the minimum and the maximum of the load.
      type(zones_t) :: least, largest
      !> The two loads [p*].
      real(dp) :: least_load = 0, largest_load = 0
      !> Zones at the minimum and the maximum of the penetration.
      type(zones_t) :: lowest, highest
      !> The two penetrations [D].
      real(dp) :: least_penetration = 0, largest_penetration = 0
      !> Q, load and penetration at the end of saturation.
      real(dp) :: saturation_square = 0, saturation_load = 0, saturation_penetration = 0
   end type adhesive_wave_t

   !> The slope of top by x, over sin 2 gamma/2.
   type, extends(equation_t) :: top_slope_equation_t
      !> sigma.
      real(dp) :: sigma = 1
   contains
      procedure :: evaluate => evaluate_top_slope
   end type top_slope_equation_t

   !> top - eta as a function of x.
   type, extends(equation_t) :: top_equation_t
      !> sigma and eta.
      real(dp) :: sigma = 1, range = 1
   contains
      procedure :: evaluate => evaluate_top
   end type top_equation_t

   !> Excess of the range as a function of y.
   type, extends(equation_t) :: contact_equation_t
      !> sigma, eta and x.
      real(dp) :: sigma = 1, range = 1, position = 0
   contains
      procedure :: evaluate => evaluate_contact
   end type contact_equation_t

   !> Gap of the valley minus eta as a function of v.
   type, extends(equation_t) :: valley_equation_t
      !> eta.
      real(dp) :: range = 1
   contains
      procedure :: evaluate => evaluate_valley
   end type valley_equation_t

contains

   !> The events of contact, load and saturation; those of the penetration remain (`adhesive_wave_events`).
   pure subroutine find_curve(self, stress, range, is_converged)
      type(adhesive_wave_t), intent(out) :: self
      !> S = sigma0/p*, 1e-12 to 1e12.
      real(dp), intent(in) :: stress
      !> eta = h0/D, 1e-12 to 1e12.
      real(dp), intent(in) :: range
      logical, intent(out) :: is_converged
      type(fold_turn_t) :: turn
      logical :: has_found(2)

      if (has_asserts) call assert(stress > 0 .and. range > 0, 'find_curve: stress > 0, range > 0')
      self%stress = stress
      self%sigma = 2*stress/pi
      self%range = range
      call find_saturation_end(self, is_converged)
      call find_first_contact(self, has_found(1))
      is_converged = is_converged .and. has_found(1)
      if (.not. self%has_zones) return
      call find_fold_turn(self%sigma, turn, has_found(1))
      is_converged = is_converged .and. has_found(1)
      self%has_folds = range < turn%range
      if (.not. self%has_folds) return
      call find_least_load(self%sigma, range, turn, self%first_position, self%least, has_found(1))
      call find_largest_load(self%sigma, range, turn, self%largest, has_found(2))
      is_converged = is_converged .and. all(has_found)
      self%least_load = self%least%square - self%sigma*self%least%phi
      self%largest_load = self%largest%square - self%sigma*self%largest%phi
   end subroutine find_curve

   !> Where saturation ends.
   pure subroutine find_saturation_end(self, is_converged)
      !> The wave; receives the end of saturation.
      type(adhesive_wave_t), intent(inout) :: self
      logical, intent(out) :: is_converged
      type(valley_equation_t) :: equation
      real(dp) :: v

      is_converged = .true.
      self%saturation_load = -self%stress
      self%saturation_penetration = 2 - self%range
      if (self%range >= 2) return
      equation%range = self%range
      v = (0.75_dp*self%range)**(1.0_dp/3)
      if (self%range > 1) v = 1 - log((2 - self%range)/2)/2
      call find_root(equation, 0.0_dp, 50.0_dp, .true., v, is_converged)
      self%saturation_square = 1/cosh(v)**2
      self%saturation_load = self%saturation_square - self%stress
      self%saturation_penetration = get_saturated_penetration(self%saturation_square)
   end subroutine find_saturation_end

   !> Q (1 - ln Q).
   elemental real(dp) function get_saturated_penetration(square) result(penetration)
      !> Q, 0 to 1.
      real(dp), intent(in) :: square

      penetration = 0
      if (square > 0) penetration = square*(1 - log(square))
   end function get_saturated_penetration

   !> Where the crest touches.
   pure subroutine find_first_contact(self, is_converged)
      !> The wave; receives the first and the last contact.
      type(adhesive_wave_t), intent(inout) :: self
      logical, intent(out) :: is_converged
      type(top_slope_equation_t) :: slope
      type(top_equation_t) :: top
      real(dp) :: x, high, value, unused

      slope%sigma = self%sigma
      high = max(log(2/self%sigma), 2.0_dp)
      x = high - 1
      call find_root(slope, log(3.0_dp)/2, high, .false., x, is_converged, last_step)
      self%first_position = x
      self%last_position = x
      if (.not. is_converged) return
      top%sigma = self%sigma
      top%range = self%range
      call top%evaluate(x, value, unused)
      self%has_zones = value > 0
      if (.not. self%has_zones) return
      ! top <= 2 T^2 + 2 sigma T ln 2
      associate (b => self%sigma*log(2.0_dp))
         self%first_position = log(self%range/(b + sqrt(b*b + 2*self%range)))
      end associate
      call find_root(top, self%first_position - 1.0e-9_dp, x, .true., self%first_position, is_converged)
      self%last_position = largest_position
      if (self%range < 2 .or. .not. is_converged) return
      self%last_position = x + 1
      call find_root(top, x, largest_position, .false., self%last_position, is_converged)
   end subroutine find_first_contact

   !> Does the crest stand open at a position?
   pure logical function is_open(self, position)
      type(adhesive_wave_t), intent(in) :: self
      real(dp), intent(in) :: position

      is_open = .not. self%has_zones .or. position <= self%first_position .or. position >= self%last_position
   end function is_open

   !> Zones of the equilibrium at a position.
   pure subroutine find_contact(self, position, zones, is_converged)
      type(adhesive_wave_t), intent(in) :: self
      real(dp), intent(in) :: position
      !> In: zones nearby, or anything with y = 0. Out: the zones.
      type(zones_t), intent(inout) :: zones
      logical, intent(out) :: is_converged
      type(contact_equation_t) :: equation
      real(dp) :: y

      is_converged = .true.
      y = open_crest
      if (.not. is_open(self, position)) then
         equation = contact_equation_t(self%sigma, self%range, position)
         y = zones%y
         if (.not. (y > 0 .and. y < largest_guess)) y = guess_y(self, position)
         call find_root(equation, 0.0_dp, open_crest, .true., y, is_converged)
      end if
      call get_zones_of_position(position, y, zones)
   end subroutine find_contact

   !> About y of the equilibrium at a position, from the leading terms of (2).
   pure real(dp) function guess_y(self, position)
      type(adhesive_wave_t), intent(in) :: self
      real(dp), intent(in) :: position

      guess_y = min(sqrt(self%range/self%sigma*cosh(position)), (self%range*(1 + exp(-2*position)))**(1.0_dp/3), 3.0_dp)
   end function guess_y

   !> Load and penetration at zones of the curve.
   pure subroutine get_curve_state(self, zones, load, penetration, crest_gap)
      type(adhesive_wave_t), intent(in) :: self
      type(zones_t), intent(in) :: zones
      !> Mean pressure P [p*].
      real(dp), intent(out) :: load
      !> Penetration delta [D].
      real(dp), intent(out) :: penetration
      !> Gap of the crest [D].
      real(dp), intent(out) :: crest_gap
      real(dp) :: k, m, w

      call get_zone_integrals(zones%tangent, zones%m, zones%phi, zones%distance, k, m, w)
      load = zones%square - self%sigma*zones%phi
      crest_gap = 0
      if (zones%y >= open_crest) crest_gap = max(0.0_dp, -range_excess(self%sigma, self%range, zones))
      penetration = zones%square*(1 + 2*zones%lambda) + 2*self%sigma*m - crest_gap
   end subroutine get_curve_state

   !> See `top_slope_equation_t`.
   pure subroutine evaluate_top_slope(self, x, value, slope)
      class(top_slope_equation_t), intent(in) :: self
      real(dp), intent(in) :: x
      !> sin 2 gamma + sigma ln(2 cos gamma), over sin 2 gamma.
      real(dp), intent(out) :: value
      !> Its derivative.
      real(dp), intent(out) :: slope
      real(dp) :: half

      half = log(2.0_dp) - log(1 + exp(2*x))/2
      value = 1 + self%sigma*cosh(x)*half
      slope = self%sigma*(sinh(x)*half - cosh(x)/(1 + exp(-2*x)))
   end subroutine evaluate_top_slope

   !> See `top_equation_t`.
   pure subroutine evaluate_top(self, x, value, slope)
      class(top_equation_t), intent(in) :: self
      real(dp), intent(in) :: x
      !> top - eta.
      real(dp), intent(out) :: value
      !> Its derivative.
      real(dp), intent(out) :: slope
      type(zones_t) :: zones

      call get_zones_of_position(x, open_crest, zones)
      value = range_excess(self%sigma, self%range, zones)
      slope = 2*zones%sine*zones%cosine*(2*zones%sine*zones%cosine + self%sigma*(log(2.0_dp) - log(1 + zones%tangent**2)/2))
   end subroutine evaluate_top

   !> See `contact_equation_t`.
   pure subroutine evaluate_contact(self, x, value, slope)
      class(contact_equation_t), intent(in) :: self
      !> y.
      real(dp), intent(in) :: x
      !> Excess of the range.
      real(dp), intent(out) :: value
      !> Its derivative.
      real(dp), intent(out) :: slope
      type(zones_t) :: zones
      real(dp) :: unused

      call get_zones_of_position(self%position, x, zones)
      value = range_excess(self%sigma, self%range, zones)
      call get_range_slopes(self%sigma, zones, unused, slope)
   end subroutine evaluate_contact

   !> See `valley_equation_t`.
   pure subroutine evaluate_valley(self, x, value, slope)
      class(valley_equation_t), intent(in) :: self
      !> v.
      real(dp), intent(in) :: x
      !> Gap of the valley - eta.
      real(dp), intent(out) :: value
      !> Its derivative.
      real(dp), intent(out) :: slope
      real(dp) :: e, square

      e = exp(-2*x)
      square = 4*e/(1 + e)**2
      if (x < 0.5_dp) then
         value = square*sinh_minus_argument(2*x) - self%range
      else
         value = (2 - self%range) - 4*e/(1 + e) - 2*x*square
      end if
      slope = 4*x*square*tanh(x)
   end subroutine evaluate_valley

end module adfric_plane_adhesive_wave_curve

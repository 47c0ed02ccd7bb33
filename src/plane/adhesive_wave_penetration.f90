! SPDX-License-Identifier: GPL-3.0-or-later
!> The states of an adhesive wave (`adhesive_wave`) at a penetration, on each branch.
!>
!> `approach`: no contact up to delta = -eta, where the wave jumps in, for just beyond, delta falls along the curve at any stress; then
!> between the minimum and the maximum of the penetration, and saturated beyond. `adhered`: saturated down to the end of saturation,
!> then as `approach`, down to the minimum, or out of reach. After a turn at a load, the adhered branch is in the zones if it was at
!> the turn.
module adfric_plane_adhesive_wave_penetration
   use adfric_base_kinds, only: dp
   use adfric_numerics_scalar_root, only: equation_t, find_root
   use adfric_numerics_secant_root, only: rising_equation_t, find_rising_root
   use adfric_plane_adhesive_wave, only: zones_t, get_zones_of_position, range_excess, penetration_slope, get_range_slopes, &
      & open_crest
   use adfric_plane_adhesive_wave_curve, only: adhesive_wave_t, find_contact, guess_y, get_curve_state
   use adfric_plane_adhesive_wave_integrals, only: get_zone_integrals
   use adfric_plane_adhesive_wave_load, only: was_partial, branch_approach
   use adfric_plane_adhesive_wave_state, only: wave_adhesion_t, state_of_zones, fill_saturated, regime_free
   use adfric_plane_westergaard, only: find_wave_pressure
   implicit none (type, external)
   private
   public :: state_of_penetration

   !> Newton steps in two unknowns, the size of the last one, whose error is its square, and the largest y for them.
   integer, parameter :: max_newton = 12
   real(dp), parameter :: close_enough = 1.0e-8_dp, largest_y = 12.0_dp
   !> A longer step is none.
   real(dp), parameter :: endless = 1.0e100_dp
   !> What the difference of two equal penetrations may be.
   real(dp), parameter :: round_off = 2*epsilon(1.0_dp)

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
   type, extends(rising_equation_t) :: penetration_contact_equation_t
      !> The wave.
      type(adhesive_wave_t) :: wave
      !> The wanted penetration.
      real(dp) :: penetration = 0
   contains
      procedure :: evaluate => evaluate_contact
   end type penetration_contact_equation_t

contains

   !> The state at a penetration.
   pure subroutine state_of_penetration(wave, penetration, branch, state, is_converged, turning_load)
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
      type(wave_adhesion_t), intent(inout) :: state

      state%regime = regime_free
      state%penetration = penetration
      state%crest_gap = -penetration
   end subroutine set_free

   !> The state between the minimum and the maximum of the penetration, where delta rises with x.
   pure subroutine find_penetration(wave, penetration, state, is_converged)
      type(adhesive_wave_t), intent(in) :: wave
      !> delta [D].
      real(dp), intent(in) :: penetration
      type(wave_adhesion_t), intent(inout) :: state
      logical, intent(out) :: is_converged
      type(open_equation_t) :: open
      type(penetration_contact_equation_t) :: contact
      type(zones_t) :: zones
      real(dp) :: x, low, high, ends(2)

      low = wave%lowest%position
      high = wave%highest%position
      ends = 2
      if (wave%has_zones) ends = [open_penetration(wave, wave%first_position), open_penetration(wave, wave%last_position)]
      if (wave%first_position <= low) ends(1) = -huge(x)
      if (wave%last_position >= high) ends(2) = 2
      if (wave%has_zones .and. penetration > ends(1) .and. penetration < ends(2)) then
         low = max(low, wave%first_position)
         high = min(high, wave%last_position)
         x = low + (high - low)*sqrt((penetration - wave%least_penetration)/(wave%largest_penetration - wave%least_penetration))
         call get_zones_of_position(x, guess_y(wave, x), zones)
         call approach_contact(wave, penetration, low, high, zones, is_converged)
         if (.not. is_converged) then
            contact = penetration_contact_equation_t(wave, penetration)
            call find_rising_root(contact, low, high, wave%largest_penetration - wave%least_penetration, round_off, x, is_converged)
            zones%y = 0
            if (is_converged) call find_contact(wave, x, zones, is_converged)
         end if
      else
         if (wave%has_zones .and. penetration <= ends(1)) high = min(high, wave%first_position)
         if (wave%has_zones .and. penetration >= ends(2)) low = max(low, wave%last_position)
         open = open_equation_t(wave, penetration)
         x = low + (high - low)/2
         call find_root(open, low, high, .true., x, is_converged)
         call get_zones_of_position(x, open_crest, zones)
      end if
      if (.not. is_converged) return
      call state_of_zones(wave, zones, state)
      state%penetration = penetration
   end subroutine find_penetration

   !> Newton's method for (2) and (3) in x and y, which may fail. A solution between the extremes is the only one.
   pure subroutine approach_contact(wave, penetration, low, high, zones, is_converged)
      type(adhesive_wave_t), intent(in) :: wave
      !> delta [D].
      real(dp), intent(in) :: penetration
      !> Bounds of x.
      real(dp), intent(in) :: low, high
      !> In: a first guess. Out: the zones.
      type(zones_t), intent(inout) :: zones
      logical, intent(out) :: is_converged
      real(dp) :: by_position, by_y, range, delta, k, m, w, slope, dx, dy
      integer :: i

      is_converged = .false.
      do i = 1, max_newton
         call get_zone_integrals(zones%tangent, zones%m, zones%phi, zones%distance, k, m, w)
         range = range_excess(wave%sigma, wave%range, zones, k)
         delta = zones%square*(1 + 2*zones%lambda) + 2*wave%sigma*m
         call get_range_slopes(wave%sigma, zones, by_position, by_y)
         dx = (penetration - delta - zones%lambda/zones%y*range)*zones%y
         slope = 2*zones%sine*zones%cosine*penetration_slope(wave%sigma, zones)
         ! next to an extreme there may be no slope, and in a zone of round-off none of the range
         if (.not. (abs(slope)*endless > abs(dx) .and. abs(by_y) > 0)) return
         dx = dx/slope
         is_converged = abs(dx) < close_enough
         if (.not. is_converged) dx = min(max(dx, (low - zones%position)/2), (high - zones%position)/2)
         dy = -(range + by_position*dx)/by_y
         is_converged = is_converged .and. abs(dy) < close_enough*zones%y
         dy = min(max(dy, -zones%y/2), 2*zones%y)
         call get_zones_of_position(zones%position + dx, zones%y + dy, zones)
         if (is_converged .or. .not. zones%y < largest_y) exit
      end do
      is_converged = is_converged .and. zones%position >= low .and. zones%position <= high
   end subroutine approach_contact

   !> delta with an open crest.
   pure real(dp) function open_penetration(wave, position) result(penetration)
      type(adhesive_wave_t), intent(in) :: wave
      real(dp), intent(in) :: position
      type(zones_t) :: zones
      real(dp) :: load, gap

      call get_zones_of_position(position, open_crest, zones)
      call get_curve_state(wave, zones, load, penetration, gap)
   end function open_penetration

   !> See `open_equation_t`.
   pure subroutine evaluate_open(self, x, value, slope)
      class(open_equation_t), intent(in) :: self
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

   !> See `penetration_contact_equation_t`.
   pure subroutine evaluate_contact(self, x, value)
      class(penetration_contact_equation_t), intent(in) :: self
      real(dp), intent(in) :: x
      !> delta minus the wanted one.
      real(dp), intent(out) :: value
      type(zones_t) :: zones
      real(dp) :: load, gap
      logical :: is_converged

      call find_contact(self%wave, x, zones, is_converged)
      call get_curve_state(self%wave, zones, load, value, gap)
      value = value - self%penetration
   end subroutine evaluate_contact

end module adfric_plane_adhesive_wave_penetration

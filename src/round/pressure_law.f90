! SPDX-License-Identifier: GPL-3.0-or-later
!> Friction of a round body that slides by a law of the pressure itself, tau(v, p, T): its integral over the contact.
!>
!> The contact is that without friction. Tension counts as no pressure, so with tau_0 = tau(v, 0, T) and the radius b of friction
!>
!>     F = pi b^2 tau_0 + int_(p > 0) [tau(p) - tau_0] 2 pi r dr
!>
!> The rings of p > 0 are found by their signs. On each the double exponential rule takes roots, logarithms and poles of its ends.
!> Where the edge of a flat face presses, p has an inverse root there. The law rises by Om/phi p at large p, so the integral is one of
!> tau - tau_0 - (Om/phi) p, beside Om/phi times the load of the contact.
module adfric_round_pressure_law
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_interface_friction_law, only: friction_law_t
   use adfric_numerics_double_exponential, only: integrand_t, integrate
   use adfric_round_case, only: indenter_case_t
   use adfric_round_contact_state, only: contact_t
   use adfric_round_profiles, only: pressure_at
   use adfric_round_shape, only: shape_t
   implicit none (type, external)
   private
   public :: add_pressure_part

   !> Rings on which signs of the pressure are looked for, between the axis, a corner and the edge.
   integer, parameter :: n_rings = 64
   !> Most changes of sign.
   integer, parameter :: most_changes = 8
   !> Halvings of a ring in which the sign changes.
   integer, parameter :: n_halvings = 60
   !> What differences of stresses leave of the digits of an integral.
   real(dp), parameter :: round_off = 1.0e-13_dp

   !> [tau(p) - tau_0] 2 pi r, or its change by ln v, between two radii of one sign.
   type, extends(integrand_t) :: law_ring_t
      !> The law.
      type(friction_law_t) :: law
      !> The shape.
      class(shape_t), allocatable :: shape
      !> Its contact.
      type(contact_t) :: contact
      !> Speed [m/s], temperature [K], and unit of the pressure [Pa].
      real(dp) :: speed = 0, temperature = 0, unit = 1
      !> Stress without pressure, or its change by ln v [Pa]; and what rises with the pressure and is left to its sum [-].
      real(dp) :: without = 0, factor = 0
      !> Ends, reduced.
      real(dp) :: inner = 0, outer = 1
      !> Is the change by ln v the integrand?
      logical :: is_slope = .false.
   contains
      procedure :: evaluate
   end type law_ring_t

contains

   !> Add what the pressure makes of the friction.
   pure subroutine add_pressure_part(law, speed, temperature, case, contact, force, slope, is_converged)
      !> A law for which `depends_on_pressure` is true.
      type(friction_law_t), intent(in) :: law
      !> Speed [m/s], and temperature [K].
      real(dp), intent(in) :: speed, temperature
      !> The case, and its contact.
      type(indenter_case_t), intent(in) :: case
      type(contact_t), intent(in) :: contact
      !> In: friction of the stress without pressure [N]. Out: with the part of the pressure.
      real(dp), intent(inout) :: force
      !> d ln F/d ln v [-] of the same.
      real(dp), intent(inout) :: slope
      !> Have the integrals come to rest?
      logical, intent(out) :: is_converged
      type(law_ring_t) :: ring
      real(dp) :: radii(0:most_changes + 2), stress, slope_of_stress, part(2), sums(2)
      logical :: is_valid
      integer :: n, i, k

      is_converged = .true.
      if (.not. (speed > 0 .and. contact%spot%radius > 0)) return
      call law%get_stress(speed, 0.0_dp, temperature, stress, slope_of_stress, is_valid)
      ring%law = law
      allocate (ring%shape, source=case%curve%shape)
      ring%contact = contact
      ring%speed = speed
      ring%temperature = temperature
      ring%unit = case%modulus*(case%height_unit/case%length_unit)
      sums = 0
      ! the edge of a face that presses
      if (contact%neck < 0 .and. .not. contact%stress > 0) then
         ring%factor = law%pressure_volume/law%shear_volume
         sums(1) = ring%factor*(contact%load + case%curve%outer_pull)*ring%unit
      end if
      call find_rings(ring, radii, n)
      do i = 1, n
         ring%inner = radii(i - 1)
         ring%outer = radii(i)
         if (.not. pressure_of(ring, (ring%inner + ring%outer)/2) > 0) cycle
         do k = 1, 2
            ring%is_slope = k == 2
            ring%without = merge(stress*slope_of_stress, stress, ring%is_slope)
            ! a law of large barriers has the same change by ln v at all pressures: its difference is round-off
            call integrate(ring, ring%outer - ring%inner, part(k), is_valid, &
               & negligible=round_off*(abs(ring%without)*pi*(ring%outer**2 - ring%inner**2) + abs(sums(1))))
            is_converged = is_converged .and. is_valid
         end do
         sums = sums + part
      end do
      sums = sums*case%length_unit**2
      slope = slope*force + sums(2)
      force = force + sums(1)
      slope = slope/force
      is_converged = is_converged .and. force > 0
   end subroutine add_pressure_part

   !> Radii between which the pressure has one sign and no corner.
   pure subroutine find_rings(ring, radii, n)
      type(law_ring_t), intent(in) :: ring
      !> Receives the radii, reduced, from 0 to that of the contact.
      real(dp), intent(out) :: radii(0:)
      !> Number of rings.
      integer, intent(out) :: n
      real(dp) :: ends(2), low, r, first
      integer :: i, k, n_parts

      associate (a => ring%contact%spot%radius, corner => ring%shape%corner)
         radii = 0
         n = 0
         n_parts = 1
         ends = a
         if (corner > 0 .and. corner < a) then
            n_parts = 2
            ends(1) = corner
         end if
         first = 0
         do k = 1, n_parts
            low = first
            do i = 1, n_rings
               ! dense at both ends, and not at them
               r = first + (ends(k) - first)*sin(asin(1.0_dp)*(i - 0.5_dp)/n_rings)**2
               if (i > 1 .and. n < most_changes) then
                  if (pressure_of(ring, low) > 0 .neqv. pressure_of(ring, r) > 0) then
                     n = n + 1
                     radii(n) = root_between(ring, low, r)
                  end if
               end if
               low = r
            end do
            n = n + 1
            radii(n) = ends(k)
            first = ends(k)
         end do
      end associate
   end subroutine find_rings

   !> Where the pressure changes its sign, by halving.
   pure real(dp) function root_between(ring, low, high) result(middle)
      type(law_ring_t), intent(in) :: ring
      !> Radii of different signs.
      real(dp), intent(in) :: low, high
      real(dp) :: ends(2)
      integer :: i
      logical :: is_positive

      ends = [low, high]
      is_positive = pressure_of(ring, low) > 0
      middle = low
      do i = 1, n_halvings
         middle = (ends(1) + ends(2))/2
         if (pressure_of(ring, middle) > 0 .eqv. is_positive) then
            ends(1) = middle
         else
            ends(2) = middle
         end if
      end do
   end function root_between

   !> Pressure at a radius [Pa]; 0 where it is not finite.
   pure real(dp) function pressure_of(ring, r) result(pressure)
      type(law_ring_t), intent(in) :: ring
      !> Distance from the axis, reduced.
      real(dp), intent(in) :: r

      pressure = pressure_at(ring%shape, ring%contact, r)
      if (ieee_is_nan(pressure)) pressure = 0
      pressure = pressure*ring%unit
   end function pressure_of

   !> See `integrand_t`.
   pure real(dp) function evaluate(self, from_left, from_right)
      class(law_ring_t), intent(in) :: self
      !> Distances from both ends, reduced.
      real(dp), intent(in) :: from_left, from_right
      real(dp) :: r, pressure, stress, slope
      logical :: is_valid

      r = self%inner + from_left
      if (from_right < from_left) r = self%outer - from_right
      ! the ends themselves have no pressure where that is infinite
      r = max(r, nearest(self%inner, 1.0_dp))
      r = min(r, nearest(self%outer, -1.0_dp))
      pressure = max(pressure_of(self, r), 0.0_dp)
      call self%law%get_stress(self%speed, pressure, self%temperature, stress, slope, is_valid)
      if (self%is_slope) then
         stress = stress*slope
      else
         stress = stress - self%factor*pressure
      end if
      evaluate = 2*pi*r*(stress - self%without)
   end function evaluate

end module adfric_round_pressure_law

! SPDX-License-Identifier: GPL-3.0-or-later
!> Pressure under an indenter and gap beside it, reduced (E* H/L and H):
!>
!>     p = (1/pi) int g'(x)/sqrt(x^2 - r^2) dx,  r < x < a;       gap = (2/pi) int g'(x) arccos(x/r) dx,  a < x < r
!>
!> and what a flat punch of radius a adds that is pulled by `neck`. In t, with v = sqrt(x^2 - b^2), v_r = sqrt(|r^2 - b^2|),
!>
!>     p = (1/pi) int dg/dv dt,   v = v_r cosh(t) for r > b, v = v_r sinh(t) for r < b
!>
!> the integrands are analytic in a strip of half-width pi/2 about the real axis, so panels have them to round-off.
module adfric_round_profiles
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, half_pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_round_contact_state, only: contact_t
   use adfric_round_dugdale_gap, only: zone_gap, disc_gap
   use adfric_round_power_shape, only: power_shape_t
   use adfric_round_shape, only: shape_t
   use adfric_round_sphere_shape, only: sphere_shape_t
   use adfric_numerics_trigonometry, only: sinc_minus_cos
   use adfric_numerics_panels, only: panel_integrand_t, integrate
   implicit none (type, external)
   private
   public :: pressure_at, gap_at

   !> Logarithm of a height beyond all numbers, with space for factors.
   real(dp), parameter :: largest_logarithm = 400.0_dp
   !> Where a decaying exponential is round-off.
   real(dp), parameter :: decayed = 40.0_dp
   !> Ways along which dg/dv is integrated.
   integer, parameter :: along_cosh = 1, along_sinh = 2, along_decay = 3

   !> dg/dv along t.
   type, extends(panel_integrand_t) :: pressure_integrand_t
      !> The shape.
      class(shape_t), allocatable :: shape
      !> One of `along_...`: v = scale*cosh(t), scale*sinh(t) or scale*exp(-t).
      integer :: path = along_cosh
      !> The scale.
      real(dp) :: scale = 1
   contains
      procedure :: value_at => pressure_value
   end type pressure_integrand_t

   !> dg/dv arccos(x/r) dv/dt for v = V sin(t), or v = V/cosh(t).
   type, extends(panel_integrand_t) :: gap_integrand_t
      !> The shape.
      class(shape_t), allocatable :: shape
      !> Is v = V sin(t)?
      logical :: is_sine = .true.
      !> V = sqrt(r^2 - b^2).
      real(dp) :: largest = 1
   contains
      procedure :: value_at => gap_value
   end type gap_integrand_t

   !> x arccos(x/r) dx/dt for x = r sin(t).
   type, extends(panel_integrand_t) :: inner_integrand_t
   contains
      procedure :: value_at => inner_value
   end type inner_integrand_t

contains

   !> Pressure at a distance from the axis; 0 outside the contact, NaN where it is infinite.
   pure real(dp) function pressure_at(shape, contact, r) result(pressure)
      class(shape_t), intent(in) :: shape
      type(contact_t), intent(in) :: contact
      !> Distance from the axis, reduced, >= 0.
      real(dp), intent(in) :: r

      pressure = 0
      associate (a => contact%spot%radius)
         if (r >= a .and. contact%stress > 0 .and. r <= contact%adhesion_radius) pressure = -contact%stress
         if (r >= a .and. contact%stress > 0 .or. r > a) return
         if (contact%is_beyond) pressure = outer_pressure(shape, contact, r)
         if (r < shape%corner) pressure = pressure + shape%inner_rise()/pi*sqrt(max(0.0_dp, min(a, shape%corner)**2 - r**2))
         if (.not. abs(contact%neck) > 0) return
         if (contact%stress > 0) then
            pressure = pressure - 2*contact%stress/pi*atan2(contact%neck/(2*contact%stress), sqrt((a - r)*(a + r)))
         else if (r < a) then
            pressure = pressure - contact%neck/(pi*sqrt((a - r)*(a + r)))
         else
            pressure = not_a_number()
         end if
      end associate
   end function pressure_at

   !> What lies beyond the corner adds to the pressure.
   pure real(dp) function outer_pressure(shape, contact, r) result(pressure)
      class(shape_t), intent(in) :: shape
      type(contact_t), intent(in) :: contact
      !> Distance from the axis, reduced, >= 0 and at most a.
      real(dp), intent(in) :: r
      type(pressure_integrand_t) :: integrand
      real(dp) :: last

      pressure = 0
      associate (a => contact%spot%radius, b => shape%corner)
         select type (shape)
         type is (power_shape_t)
            if (shape%is_paraboloid()) then
               pressure = 2*shape%factors(1)/pi*sqrt((a - r)*(a + r))
               return
            end if
         end select
         integrand%scale = sqrt(abs(r - b)*(r + b))
         if (.not. integrand%scale > 0) then
            integrand%path = along_decay
            integrand%scale = contact%spot%beyond
            if (.not. shape%onset > 0) pressure = not_a_number()
            if (.not. shape%onset > 0 .or. .not. integrand%scale > 0) return
            last = decayed/shape%onset
         else if (r > b) then
            last = asinh(sqrt((a - r)*(a + r))/integrand%scale)
         else
            integrand%path = along_sinh
            last = asinh(contact%spot%beyond/integrand%scale)
         end if
         allocate (integrand%shape, source=shape)
         pressure = integrate(integrand, 0.0_dp, last)/pi
      end associate
   end function outer_pressure

   !> See `panel_integrand_t`.
   pure real(dp) function pressure_value(self, position)
      class(pressure_integrand_t), intent(in) :: self
      !> t > 0.
      real(dp), intent(in) :: position

      select case (self%path)
      case (along_cosh)
         pressure_value = self%shape%rise(self%scale*cosh(position))
      case (along_sinh)
         pressure_value = self%shape%rise(self%scale*sinh(position))
      case default
         pressure_value = self%shape%rise(self%scale*exp(-position))
      end select
   end function pressure_value

   !> Gap at a distance from the axis; 0 in contact, NaN beside a sphere, and where it is beyond all numbers.
   pure real(dp) function gap_at(shape, contact, r) result(gap)
      class(shape_t), intent(in) :: shape
      type(contact_t), intent(in) :: contact
      real(dp), intent(in) :: r
      real(dp) :: height, slope
      logical :: is_apart

      gap = 0
      associate (a => contact%spot%radius)
         is_apart = .not. a > 0 .and. (contact%stress > 0 .or. contact%approach < 0)
         if (.not. (r > a .or. is_apart)) return
         gap = not_a_number()
         select type (shape)
         type is (sphere_shape_t)
            if (.not. r < 1) return
         type is (power_shape_t)
            ! no exponent is above 100
            if (exponent(r) > 4) then
               if (maxval(shape%exponents(:shape%n_terms))*log(r) > largest_logarithm) return
            end if
         end select
         if (is_apart) then
            call shape%get_profile(r, height, slope)
            gap = height - contact%approach
            if (contact%stress > 0 .and. contact%adhesion_radius > 0) &
               & gap = gap - disc_gap(contact%stress, contact%adhesion_radius, r)
         else
            gap = 2/pi*(inner_opening(shape, contact, r) + outer_opening(shape, contact, r))
            if (contact%stress > 0) then
               gap = gap + zone_gap(contact%stress, a, contact%neck/(2*contact%stress), r)
            else
               gap = gap + 2/pi*contact%neck*atan2(sqrt((r - a)*(r + a)), a)
            end if
         end if
         ! beyond a flat face without edge there is nothing to have a gap from
         if (shape%n_pieces == 0 .and. r > shape%corner) gap = not_a_number()
      end associate
   end function gap_at

   !> What lies within the corner adds to the gap.
   pure real(dp) function inner_opening(shape, contact, r) result(opening)
      class(shape_t), intent(in) :: shape
      type(contact_t), intent(in) :: contact
      !> Distance from the axis, reduced, > a.
      real(dp), intent(in) :: r
      type(inner_integrand_t) :: integrand

      opening = 0
      if (contact%is_beyond .or. .not. shape%inner_rise() > 0) return
      opening = shape%inner_rise()*r**2*integrate(integrand, asin(contact%spot%radius/r), asin(min(1.0_dp, shape%corner/r)))
   end function inner_opening

   !> What lies beyond the corner adds to the gap: by v = V sin(t) where v is at most b, by v = V/cosh(t) where it is more.
   pure real(dp) function outer_opening(shape, contact, r) result(opening)
      class(shape_t), intent(in) :: shape
      type(contact_t), intent(in) :: contact
      real(dp), intent(in) :: r
      type(gap_integrand_t) :: integrand
      real(dp) :: first

      opening = 0
      first = 0
      if (contact%is_beyond) first = contact%spot%beyond
      associate (b => shape%corner, last => integrand%largest)
         if (.not. r > b) return
         select type (shape)
         type is (power_shape_t)
            if (shape%is_paraboloid()) then
               opening = shape%factors(1)*paraboloid_opening(contact%spot%radius, r)
               return
            end if
         end select
         last = sqrt((r - b)*(r + b))
         allocate (integrand%shape, source=shape)
         if (first < b) then
            opening = integrate(integrand, asin(min(1.0_dp, first/last)), merge(asin(min(1.0_dp, b/last)), half_pi, last > b))
            if (.not. last > b) return
            first = b
         end if
         if (.not. first > 0) return
         integrand%is_sine = .false.
         opening = opening + integrate(integrand, 0.0_dp, asinh(sqrt(max(0.0_dp, (last - first)*(last + first)))/first))
      end associate
   end function outer_opening

   !> The same of g = x^2: (r^2/2)(sin beta cos beta - beta cos 2 beta), a = r cos beta.
   pure real(dp) function paraboloid_opening(a, r) result(opening)
      !> Radius of contact, and distance from the axis, > a.
      real(dp), intent(in) :: a, r
      ! below this angle the difference loses digits
      real(dp), parameter :: narrow = 0.5_dp
      real(dp) :: e, beta

      e = sqrt((r - a)*(r + a))
      beta = atan2(e, a)
      if (beta < narrow) then
         opening = r**2*(beta*sinc_minus_cos(2*beta))/2
      else
         opening = (a*e + (e - a)*(e + a)*beta)/2
      end if
   end function paraboloid_opening

   !> See `panel_integrand_t`.
   pure real(dp) function gap_value(self, position)
      class(gap_integrand_t), intent(in) :: self
      !> t, > 0.
      real(dp), intent(in) :: position
      real(dp) :: v, rest, slope

      associate (last => self%largest)
         if (self%is_sine) then
            v = last*sin(position)
            rest = last*cos(position)
            slope = rest
         else
            v = last/cosh(position)
            rest = last*tanh(position)
            slope = rest*v/last
         end if
         gap_value = self%shape%rise(v)*atan2(rest, hypot(self%shape%corner, v))*slope
      end associate
   end function gap_value

   !> See `panel_integrand_t`.
   pure real(dp) function inner_value(self, position)
      class(inner_integrand_t), intent(in) :: self
      !> t, between 0 and pi/2.
      real(dp), intent(in) :: position

      inner_value = sin(position)*cos(position)*(half_pi - position)
      associate (unused => self)
      end associate
   end function inner_value

end module adfric_round_profiles

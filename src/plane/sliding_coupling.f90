! SPDX-License-Identifier: GPL-3.0-or-later
!> Sliding contact along a line on an elastic half-plane of Poisson's ratio nu < 1/2, where shear moves the contact: a wave in
!> closed form (a cylinder: `adfric_plane_coupled_line`).
!>
!> A rigid body slides along +x. u and h are positive into the solid, q is the shear stress on it along +x, p the pressure, and H the
!> Hilbert transform, H p = (1/pi) int p(t)/(x - t) dt. With beta = (1 - 2 nu)/(2 (1 - nu)), and means over a period,
!>
!>     du/dx = (2/E*) [-H p + beta (q - mean q)],   du/dx = dh/dx in contact,   q = tau + mu p there and 0 in gaps.
!>
!> With m = mu beta = tan(pi eta) and s = 2 beta tau/E* the function Psi = p (1 + i m) - i (E*/2) v has a continuation to the half-plane
!> above x, where v is 0 in contact and the slope of the gap plus s outside. So its phase is pi eta in contact and +-pi/2 outside.
!>
!> Wave h = D cos x, with x = k times position, pressures in E* k D and displacements in D; contact from c_m - w to c_m + w,
!> c = pi - w, y = x - c_m, and the phase M = c_m + pi eta:
!>
!>     Psi = e^(i pi eta) sin^(1/2-eta)((w+y)/2) sin^(1/2+eta)((w-y)/2) cos(y/2 + M - c eta),   p = cos(pi eta) e^(-i pi eta) Psi.
!>
!> Its terms e^(-ix) and 1 give M and the mean pressure, and the term e^(ix) gives T_s = -mean(p h_x). The sums are taken as
!> integrals over the contact here, which are right for the least contact too. With S = sin 2c eta - 2 eta sin c and
!> C = cos 2c eta - cos c the second one says C sin M - S cos M = -2 s (c/pi) cos(pi eta); without tau it is tan M = S/C.
!>
!> A tau that does not vanish with the pressure makes no strict solution: q jumps at the leading edge, and the gap is below 0 there on
!> a length (9/8) (beta tau/p_max)^2 w. That number over w is the error which is told.
module adfric_plane_sliding_coupling
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_numerics_double_exponential, only: integrand_t, integrate
   use adfric_numerics_scalar_root, only: equation_t, find_root
   implicit none (type, external)
   private
   public :: coupled_wave_t, new_coupled_wave, error_of_cut
   public :: set_width, is_pressing, add_integrals, add_extremes

   !> Below this opening, half of the gap, sums of the phase are series.
   real(dp), parameter :: small_opening = 0.5_dp
   !> What is integrated: p, p^2, p with the kernels of the displacement at the leading edge, and p with the slope of the wave.
   integer, parameter :: of_pressure = 1, of_square = 2, of_displacement = 3, of_slope = 4

   !> A partial contact of a wave in units of the wave.
   type :: coupled_wave_t
      !> eta = atan(m)/pi and s [-].
      real(dp) :: eta = 0, tilt = 0
      !> w and c = pi - w [rad], both with all digits.
      real(dp) :: half_width = 0, opening = pi
      !> Middle of the contact c_m, and M - c eta [rad]; the largest number where there is no state.
      real(dp) :: centre = 0, phase = 0
      !> Mean pressure, penetration of the crests below the mean surface, and T_s.
      real(dp) :: mean_pressure = 0, penetration = 0, slope_friction = 0
      !> T_s by the energy, -2 m [mean p^2 - (mean p)^2] - s mean p (1 - w/pi).
      real(dp) :: friction_of_energy = 0
      !> Largest pressure, and largest gap.
      real(dp) :: peak_pressure = 0, largest_gap = 0
   contains
      procedure :: pressure_between
      procedure :: pressure_at
      procedure :: gap_at
   end type coupled_wave_t

   !> A term over the contact of a wave, by the distances from its edges.
   type, extends(integrand_t) :: contact_term_t
      !> The contact.
      type(coupled_wave_t) :: wave
      !> One of `of_...`.
      integer :: term = of_pressure
   contains
      procedure :: evaluate => evaluate_contact
   end type contact_term_t

   !> The slope of the gap of a wave from one edge on.
   type, extends(integrand_t) :: gap_term_t
      !> Powers of the sines of half the distances from this edge and from the other one.
      real(dp) :: near = 0.5_dp, far = 0.5_dp
      !> w, c, and M - c eta and s, of the trailing edge with the other sign.
      real(dp) :: half_width = 0, opening = pi, phase = 0, tilt = 0
   contains
      procedure :: evaluate => evaluate_gap
   end type gap_term_t

   !> Slope of ln p in contact.
   type, extends(equation_t) :: peak_equation_t
      !> The contact.
      type(coupled_wave_t) :: wave
   contains
      procedure :: evaluate => evaluate_peak
   end type peak_equation_t

contains

   !> Is the pressure above 0 in all of the contact?
   pure logical function is_pressing(wave)
      type(coupled_wave_t), intent(in) :: wave

      is_pressing = abs(wave%phase) < wave%opening/2
   end function is_pressing

   !> The contact of a given width.
   pure subroutine new_coupled_wave(wave, m, tilt, half_width, is_converged)
      type(coupled_wave_t), intent(out) :: wave
      !> m = mu beta, and s = 2 beta tau/(E* k D) [-].
      real(dp), intent(in) :: m, tilt
      !> w [rad], above 0 and below pi.
      real(dp), intent(in) :: half_width
      !> Is there such a state, and have its integrals been found?
      logical, intent(out) :: is_converged

      wave%eta = atan(m)/pi
      wave%tilt = tilt
      wave%half_width = half_width
      wave%opening = pi - half_width
      call set_phase(wave)
      call add_integrals(wave, is_converged)
      if (is_converged) call add_extremes(wave, is_converged)
   end subroutine new_coupled_wave

   !> Set the width, and the middle that belongs to it.
   pure subroutine set_width(wave, x)
      type(coupled_wave_t), intent(inout) :: wave
      !> ln tan(w/2).
      real(dp), intent(in) :: x

      wave%half_width = 2*atan(exp(x))
      wave%opening = 2*atan(exp(-x))
      call set_phase(wave)
   end subroutine set_width

   !> Middle of the contact, and M - c eta; the largest number where the tilt is too large for the width.
   pure subroutine set_phase(wave)
      type(coupled_wave_t), intent(inout) :: wave
      real(dp) :: sine, cosine, lift, without, numerator, denominator

      associate (eta => wave%eta, w => wave%half_width, c => wave%opening)
         call get_sums(2*eta, c, sine, cosine)
         lift = 0
         if (abs(wave%tilt) > 0) lift = -2*wave%tilt*(c/pi)*cos(pi*eta)/hypot(sine, cosine)
         wave%centre = huge(wave%centre)
         wave%phase = huge(wave%phase)
         if (.not. abs(lift) <= 1) return
         if (w < pi/2) then
            ! tan(M - pi eta), whose terms of small contacts are small
            numerator = sin(pi*eta)*(cos(2*w*eta) - cos(w)) - cos(pi*eta)*(sin(2*w*eta) + 2*eta*sin(w))
            denominator = cos(pi*eta - 2*w*eta) + cos(w)*cos(pi*eta) - 2*eta*sin(w)*sin(pi*eta)
            wave%centre = atan2(numerator, denominator) + asin(lift)
            wave%phase = wave%centre + w*eta
         else
            without = atan2(sine, cosine)
            wave%centre = without + asin(lift) - pi*eta
            wave%phase = without + asin(lift) - c*eta
         end if
      end associate
   end subroutine set_phase

   !> sin(a c) - a sin c and cos(a c) - cos c, over 1 - a^2 where c is small; 0 <= a < 1.
   pure subroutine get_sums(a, c, sine, cosine)
      real(dp), intent(in) :: a, c
      real(dp), intent(out) :: sine, cosine
      real(dp) :: power, factor, even
      integer :: n

      if (c >= small_opening) then
         sine = sin(a*c) - a*sin(c)
         cosine = cos(a*c) - cos(c)
         return
      end if
      sine = 0
      cosine = 0
      power = 1
      factor = 0
      even = 1
      do n = 1, 9
         ! factor is (1 - a^2n)/(1 - a^2), power is (-1)^(n-1) c^2n/(2n)!
         factor = factor + even
         even = even*a**2
         power = merge(1, -1, n == 1)*power*c**2/((2*n - 1)*(2*n))
         cosine = cosine + power*factor
         sine = sine + a*c*power/(2*n + 1)*factor
      end do
      sine = sine*(1 - a**2)
      cosine = cosine*(1 - a**2)
   end subroutine get_sums

   !> Mean pressure, penetration, and T_s in both forms.
   pure subroutine add_integrals(wave, is_converged)
      type(coupled_wave_t), intent(inout) :: wave
      logical, intent(out) :: is_converged
      real(dp) :: square, displacement, edge
      logical :: is_found(4)

      is_converged = .false.
      if (.not. is_pressing(wave)) return
      associate (length => 2*wave%half_width)
         call integrate(contact_term_t(wave, of_pressure), length, wave%mean_pressure, is_found(1))
         call integrate(contact_term_t(wave, of_square), length, square, is_found(2))
         call integrate(contact_term_t(wave, of_displacement), length, displacement, is_found(3))
         call integrate(contact_term_t(wave, of_slope), length, wave%slope_friction, is_found(4), &
            & negligible=epsilon(1.0_dp)*wave%mean_pressure*length)
      end associate
      is_converged = all(is_found)
      wave%mean_pressure = wave%mean_pressure/(2*pi)
      associate (q => wave%mean_pressure, open_share => wave%opening/pi)
         wave%friction_of_energy = -2*tan(pi*wave%eta)*(square/(2*pi) - q**2) - wave%tilt*q*open_share
         ! the gap is 0 at the leading edge
         edge = wave%centre + wave%half_width
         wave%penetration = 2*sin(edge/2)**2 + displacement + wave%tilt*open_share*wave%half_width
      end associate
      wave%slope_friction = wave%slope_friction/(2*pi)
   end subroutine add_integrals

   !> Largest pressure, and largest gap.
   pure subroutine add_extremes(wave, is_converged)
      type(coupled_wave_t), intent(inout) :: wave
      logical, intent(out) :: is_converged
      real(dp) :: from_trailing

      associate (w => wave%half_width)
         from_trailing = w*(1 - 2*wave%eta)
         call find_root(peak_equation_t(wave), 0.0_dp, 2*w, .false., from_trailing, is_converged)
         wave%peak_pressure = wave%pressure_between(from_trailing, 2*w - from_trailing)
         wave%largest_gap = wave%gap_at(wave%centre + pi - 2*wave%phase)
      end associate
   end subroutine add_extremes

   !> Pressure by the distances from both edges.
   pure real(dp) function pressure_between(self, from_trailing, from_leading) result(pressure)
      class(coupled_wave_t), intent(in) :: self
      !> Distances in contact, both > 0; the smaller one has all its digits.
      real(dp), intent(in) :: from_trailing, from_leading
      real(dp) :: sines(2), cosine

      associate (w => self%half_width, c => self%opening, phase => self%phase)
         if (w < c) then
            sines = sin([from_trailing, from_leading]/2)
            cosine = cos((from_trailing - from_leading)/4 + phase)
         else if (from_leading < from_trailing) then
            sines = sin([c + from_leading/2, from_leading/2])
            cosine = sin((c + from_leading)/2 - phase)
         else
            sines = sin([from_trailing/2, c + from_trailing/2])
            cosine = sin((c + from_trailing)/2 + phase)
         end if
      end associate
      sines = max(sines, 0.0_dp)
      pressure = cos(pi*self%eta)*sines(1)**(0.5_dp - self%eta)*sines(2)**(0.5_dp + self%eta)*cosine
   end function pressure_between

   !> Pressure at a position [E* k D].
   pure real(dp) function pressure_at(self, x) result(pressure)
      class(coupled_wave_t), intent(in) :: self
      !> Position from a crest [rad].
      real(dp), intent(in) :: x
      real(dp) :: y

      y = x - self%centre
      y = y - 2*pi*anint(y/(2*pi))
      pressure = 0
      if (abs(y) < self%half_width) pressure = self%pressure_between(self%half_width + y, self%half_width - y)
   end function pressure_at

   !> Gap at a position [D]; from the nearer edge.
   pure real(dp) function gap_at(self, x) result(gap)
      class(coupled_wave_t), intent(in) :: self
      !> Position from a crest [rad].
      real(dp), intent(in) :: x
      type(gap_term_t) :: term
      real(dp) :: y, length, side
      logical :: is_found

      y = x - self%centre
      y = y - 2*pi*anint(y/(2*pi))
      gap = 0
      length = abs(y) - self%half_width
      if (.not. length > 0) return
      side = sign(1.0_dp, y)
      term%near = 0.5_dp + side*self%eta
      term%far = 0.5_dp - side*self%eta
      term%half_width = self%half_width
      term%opening = self%opening
      term%phase = side*self%phase
      term%tilt = side*self%tilt
      call integrate(term, length, gap, is_found)
      if (.not. is_found) gap = not_a_number()
   end function gap_at

   !> A term over the contact.
   pure real(dp) function evaluate_contact(self, from_left, from_right) result(value)
      class(contact_term_t), intent(in) :: self
      !> Distances from the trailing and the leading edge.
      real(dp), intent(in) :: from_left, from_right
      real(dp) :: sine

      value = self%wave%pressure_between(from_left, from_right)
      if (self%term == of_square) then
         value = value**2
      else if (self%term == of_displacement) then
         sine = sin(from_right/2)
         if (from_left < from_right .and. self%wave%opening < self%wave%half_width) sine = sin(self%wave%opening + from_left/2)
         value = value*(-2*log(2*sine)/pi + 2*tan(pi*self%wave%eta)*(0.5_dp - from_right/(2*pi)))
      else if (self%term == of_slope) then
         value = value*sin(self%wave%centre + (from_left - from_right)/2)
      end if
   end function evaluate_contact

   !> Slope of the gap away from an edge, less that of the jump of a constant shear stress.
   pure real(dp) function evaluate_gap(self, from_left, from_right) result(slope)
      class(gap_term_t), intent(in) :: self
      !> Distances from the edge, and from where the integral ends.
      real(dp), intent(in) :: from_left, from_right
      real(dp) :: sine, cosine

      if (self%half_width < self%opening) then
         sine = sin(self%half_width + from_left/2)
         cosine = cos((self%half_width + from_left)/2 + self%phase)
      else
         sine = sin(self%opening - from_left/2)
         cosine = sin((self%opening - from_left)/2 - self%phase)
      end if
      slope = 2*sin(from_left/2)**self%near*max(sine, 0.0_dp)**self%far*cosine - self%tilt
      associate (unused => from_right)
      end associate
   end function evaluate_gap

   !> Slope of ln p, which falls from one edge to the other.
   pure subroutine evaluate_peak(self, x, value, slope)
      class(peak_equation_t), intent(in) :: self
      !> Distance from the trailing edge.
      real(dp), intent(in) :: x
      real(dp), intent(out) :: value, slope
      real(dp) :: angles(3)

      associate (wave => self%wave)
         angles = [x/2, wave%half_width - x/2, (wave%opening + x)/2 + wave%phase]
         value = (0.5_dp - wave%eta)/tan(angles(1)) - (0.5_dp + wave%eta)/tan(angles(2)) + 1/tan(angles(3))
         slope = -((0.5_dp - wave%eta)/sin(angles(1))**2 + (0.5_dp + wave%eta)/sin(angles(2))**2 + 1/sin(angles(3))**2)/2
      end associate
   end subroutine evaluate_peak

   !> Relative length at the leading edge on which a constant shear stress would make the gap below 0.
   elemental real(dp) function error_of_cut(stress, peak_pressure) result(error)
      !> beta tau, and the largest pressure; in the same unit.
      real(dp), intent(in) :: stress, peak_pressure

      error = 0
      if (abs(stress) > 0) error = 1.125_dp*(stress/peak_pressure)**2
   end function error_of_cut

end module adfric_plane_sliding_coupling

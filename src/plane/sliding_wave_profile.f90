! SPDX-License-Identifier: GPL-3.0-or-later
!> Pressure and gap of a wave that slides over a viscoelastic half-plane, at a position. Units and symbols as in `sliding_wave`; y =
!> x - m.
!>
!> In the contact, with the sums sigma_i and G_i of the shift and the mean rho_i,
!>
!>     p = 2 R cos(y/2) [cos m + sum_i e_i A_i] + 2 sum_i e_i G_i int_y^w e^(-(z-y)/a_i) F_i dz/R
!>     either A_i = cos m - sigma_i,                  F_i = cos(z/2) (1 - R^2/rho_i)
!>     or     A_i = a_i (sin m + a_i sigma_i),        F_i = cos(z/2) + sin(z/2) (2 R^2 + C^2) a_i/(2 rho_i)
!>
!> The two differ by an integration by parts. Of each arm that one is taken whose A_i is small, so that the terms do not cancel.
!> In the gap, with cosh v = sin(y/2)/s,
!>
!>     g = s^2 (sinh 2v - 2v) cos m + 2 sin m cos(y/2) R + sum_j eta_j int_y^(2 pi - w) e^(-(z-y)/b_j) F_j dz
!>     F_j = C^2 sin(z/2)/R - 2 [s^2 + 2 (1 + 1/b_j^2) rho'_j] v
module adfric_plane_sliding_wave_profile
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_numerics_double_exponential, only: integrand_t, integrate
   use adfric_numerics_hyperbolic, only: sinh_minus_argument
   use adfric_plane_sliding_solid, only: sliding_solid_t
   use adfric_plane_sliding_wave, only: wave_contact_t
   implicit none (type, external)
   private
   public :: sliding_wave_pressure, sliding_wave_gap, sliding_wave_displacement, signed_pressure, signed_gap

   !> A wave whose s is less is not loaded.
   real(dp), parameter :: least_sine = 1.0e-140_dp
   !> Exponent whose decay is nothing.
   real(dp), parameter :: long_path = 45

   !> What a relaxation length adds to the pressure at a position in the contact.
   type, extends(integrand_t) :: wave_contact_integrand_t
      !> Half-widths w of the contact and pi - w of the gap, and the position y.
      real(dp) :: half_width = 0, half_gap = 0, position = 0
      !> Relaxation length a, and the mean rho.
      real(dp) :: length = 1, rho = 1
      !> C^2.
      real(dp) :: open_part = 1
      !> What remains from the end of the range to the leading edge.
      real(dp) :: rest = 0
      !> Is A = cos m - sigma?
      logical :: is_long = .false.
   contains
      procedure :: evaluate => contact_term
   end type wave_contact_integrand_t

   !> What a retardation length adds to the gap at a position.
   type, extends(integrand_t) :: wave_gap_integrand_t
      !> Half-widths w of the contact and pi - w of the gap, s = sin(w/2), and the path from the leading edge to the position, y -
      !> w.
      real(dp) :: half_width = 0, half_gap = 0, sine = 0, path = 0
      !> What remains from the end of the range to the trailing edge.
      real(dp) :: rest = 0
      !> Retardation length b, and s^2 + 2 (1 + 1/b^2) rho'.
      real(dp) :: length = 1, factor = 0
      !> C^2.
      real(dp) :: open_part = 1
   contains
      procedure :: evaluate => gap_term
   end type wave_gap_integrand_t

contains

   !> Pressure at x, >= 0: next to an edge round-off may change the sign of its terms.
   pure real(dp) function sliding_wave_pressure(solid, contact, x) result(p)
      !> The solid, with lengths in 1/k.
      type(sliding_solid_t), intent(in) :: solid
      type(wave_contact_t), intent(in) :: contact
      !> Position along the wave, from a crest [1/k].
      real(dp), intent(in) :: x

      p = signed_pressure(solid, contact, x)
      if (.not. ieee_is_nan(p)) p = max(0.0_dp, p)
   end function sliding_wave_pressure

   !> Pressure at x as its terms give it.
   pure real(dp) function signed_pressure(solid, contact, x) result(p)
      !> The solid, with lengths in 1/k.
      type(sliding_solid_t), intent(in) :: solid
      type(wave_contact_t), intent(in) :: contact
      !> Position along the wave, from a crest [1/k].
      real(dp), intent(in) :: x
      real(dp) :: y, root, factor, part, range, amplitude, round_off
      type(wave_contact_integrand_t) :: integrand
      integer :: i
      logical :: is_converged

      y = position_in_period(x - contact%shift%shift)
      p = 0
      if (contact%is_full) p = (contact%mean_pressure - contact%stiffness) + 2*contact%stiffness*cos(y/2)**2
      if (contact%is_full .or. abs(y) >= contact%half_width) return
      integrand%half_width = contact%half_width
      integrand%half_gap = half_gap(contact)
      integrand%position = y
      integrand%open_part = contact%cosine**2
      factor = contact%shift%cosine
      do i = 1, solid%n_arms
         call choose_form(solid, contact, i, integrand, part)
         factor = factor + solid%ratios(i)*part
      end do
      root = sqrt(sin((contact%half_width - y)/2)*sin((contact%half_width + y)/2))
      p = 2*root*cos(y/2)*factor
      ! that of this term where the root is largest
      round_off = 2*epsilon(p)*contact%sine*abs(factor)
      do i = 1, solid%n_arms
         call choose_form(solid, contact, i, integrand, part)
         range = min(contact%half_width - y, long_path*integrand%length)
         integrand%rest = (contact%half_width - y) - range
         amplitude = 2*solid%ratios(i)*contact%shift%edge_pressures(i)
         if (.not. abs(amplitude) > 0) cycle
         call integrate(integrand, range, part, is_converged, round_off/abs(amplitude))
         p = p + amplitude*part
         if (.not. is_converged) p = not_a_number()
      end do
   end function signed_pressure

   !> The form of the pressure of one arm that does not cancel.
   pure subroutine choose_form(solid, contact, i, integrand, part)
      type(sliding_solid_t), intent(in) :: solid
      type(wave_contact_t), intent(in) :: contact
      !> Number of the arm.
      integer, intent(in) :: i
      type(wave_contact_integrand_t), intent(inout) :: integrand
      !> A_i.
      real(dp), intent(out) :: part
      real(dp) :: long_part

      associate (a => solid%relaxation(i), shift => contact%shift)
         long_part = shift%cosine - shift%slopes(i)
         part = a*(shift%sine + a*shift%slopes(i))
         integrand%is_long = abs(long_part) < abs(part)
         if (integrand%is_long) part = long_part
         integrand%length = a
         integrand%rho = contact%rho(i)
      end associate
   end subroutine choose_form

   !> The integrand of the pressure, see `integrand_t`.
   pure real(dp) function contact_term(self, from_left, from_right) result(term)
      class(wave_contact_integrand_t), intent(in) :: self
      !> Distance from the position.
      real(dp), intent(in) :: from_left
      !> Distance from the end of the range.
      real(dp), intent(in) :: from_right
      real(dp) :: to_leading, to_trailing, near, square, sine, cosine

      to_leading = from_right + self%rest
      to_trailing = (self%half_width + self%position) + from_left
      near = min(to_leading, to_trailing)
      if (self%half_width < self%half_gap) then
         square = sin(near/2)*sin(self%half_width - near/2)
         cosine = cos((self%half_width - near)/2)
         sine = sin((self%half_width - near)/2)
      else
         square = sin(near/2)*sin(self%half_gap + near/2)
         cosine = sin((self%half_gap + near)/2)
         sine = cos((self%half_gap + near)/2)
      end if
      sine = sign(sine, to_trailing - to_leading)
      if (self%is_long) then
         term = cosine*(1 - square/self%rho)
      else
         term = cosine + sine*(2*square + self%open_part)*(self%length/(2*self%rho))
      end if
      term = exp(-from_left/self%length)*term/sqrt(square)
   end function contact_term

   !> Gap at x, >= 0: next to an edge round-off may change the sign of its terms.
   pure real(dp) function sliding_wave_gap(solid, contact, x) result(g)
      !> The solid, with lengths in 1/k.
      type(sliding_solid_t), intent(in) :: solid
      type(wave_contact_t), intent(in) :: contact
      !> Position along the wave, from a crest [1/k].
      real(dp), intent(in) :: x

      g = signed_gap(solid, contact, x)
      if (.not. ieee_is_nan(g)) g = max(0.0_dp, g)
   end function sliding_wave_gap

   !> Gap at x as its terms give it.
   pure real(dp) function signed_gap(solid, contact, x) result(g)
      !> The solid, with lengths in 1/k.
      type(sliding_solid_t), intent(in) :: solid
      type(wave_contact_t), intent(in) :: contact
      !> Position along the wave, from a crest [1/k].
      real(dp), intent(in) :: x
      real(dp) :: y, path, root, part, range, round_off
      type(wave_gap_integrand_t) :: integrand
      integer :: j
      logical :: is_converged

      y = position_in_period(x - contact%shift%shift)
      g = 0
      ! without contact the solid is flat
      if (.not. contact%half_width > 0) g = 2*sin(y/2)**2 - contact%penetration
      if (contact%is_full .or. abs(y) <= contact%half_width .or. .not. contact%half_width > 0) return
      if (y < 0) y = y + two_pi
      integrand = wave_gap_integrand_t(contact%half_width, half_gap(contact), contact%sine, y - contact%half_width, &
         & open_part=contact%cosine**2)
      path = 2*integrand%half_gap - integrand%path
      root = gap_root(integrand, min(path, integrand%path))
      g = contact%shift%cosine*elastic_gap(contact%sine, root)
      g = g + 2*contact%shift%sine*cos(y/2)*root
      ! that of these terms where the root is largest
      round_off = epsilon(g)*(contact%shift%cosine*elastic_gap(contact%sine, contact%cosine) + 2*contact%shift%sine*contact%cosine)
      do j = 1, solid%n_arms
         ! an arm between two of nearly the same time has none
         if (.not. abs(contact%shift%shares(j)) > 0) cycle
         associate (b => solid%retardation(j))
            integrand%length = b
            integrand%factor = contact%sine**2 + 2*(1 + 1/b**2)*contact%gap_rho(j)
         end associate
         range = min(path, long_path*integrand%length)
         integrand%rest = path - range
         call integrate(integrand, range, part, is_converged, round_off/abs(contact%shift%shares(j)))
         g = g + contact%shift%shares(j)*part
         if (.not. is_converged) g = not_a_number()
      end do
   end function signed_gap

   !> Half-width pi - w of the gap.
   pure real(dp) function half_gap(contact)
      type(wave_contact_t), intent(in) :: contact

      half_gap = 2*atan2(contact%cosine, contact%sine)
   end function half_gap

   !> R at a position in the gap.
   pure real(dp) function gap_root(integrand, near)
      class(wave_gap_integrand_t), intent(in) :: integrand
      !> Way to the nearer edge, 0 to pi - w.
      real(dp), intent(in) :: near

      if (integrand%half_width < integrand%half_gap) then
         gap_root = sqrt(sin(near/2)*sin(integrand%half_width + near/2))
      else
         gap_root = sqrt(sin(near/2)*sin(integrand%half_gap - near/2))
      end if
   end function gap_root

   !> Gap of a wave on an elastic solid: s^2 (sinh 2v - 2v).
   pure real(dp) function elastic_gap(sine, root)
      !> s = sin(w/2), >= 0.
      real(dp), intent(in) :: sine
      !> R = s sinh v.
      real(dp), intent(in) :: root

      if (sine > least_sine) then
         elastic_gap = sine**2*sinh_minus_argument(2*asinh(root/sine))
      else
         elastic_gap = 2*root**2
      end if
   end function elastic_gap

   !> The integrand of the gap, see `integrand_t`.
   pure real(dp) function gap_term(self, from_left, from_right) result(term)
      class(wave_gap_integrand_t), intent(in) :: self
      !> Distance from the position.
      real(dp), intent(in) :: from_left
      !> Distance from the end of the range.
      real(dp), intent(in) :: from_right
      real(dp) :: near, root

      near = min(from_right + self%rest, self%path + from_left)
      root = gap_root(self, near)
      term = self%open_part*sin((self%half_width + near)/2)/root - 2*self%factor*asinh(root/self%sine)
      term = exp(-from_left/self%length)*term
   end function gap_term

   !> Displacement of the surface at x, of which the mean is 0: where the wave is, or below it by the gap.
   pure real(dp) function sliding_wave_displacement(solid, contact, x) result(u)
      !> The solid, with lengths in 1/k.
      type(sliding_solid_t), intent(in) :: solid
      type(wave_contact_t), intent(in) :: contact
      !> Position along the wave, from a crest [1/k].
      real(dp), intent(in) :: x

      u = contact%penetration - 2*sin(position_in_period(x)/2)**2 + sliding_wave_gap(solid, contact, x)
   end function sliding_wave_displacement

   !> The same position within half a wave of the middle.
   pure real(dp) function position_in_period(x)
      !> A position [1/k].
      real(dp), intent(in) :: x

      position_in_period = x - two_pi*anint(x/two_pi)
   end function position_in_period

end module adfric_plane_sliding_wave_profile

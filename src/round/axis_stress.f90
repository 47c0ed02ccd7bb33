! SPDX-License-Identifier: GPL-3.0-or-later
!> Stresses in the half-space on the axis of an indenter, reduced (E* H/L), tension positive.
!>
!> With y(x) = delta - g(x) the pressure is that of punches of radius x and depth -dy. On the axis, at a depth z > 0, a punch gives
!>
!>     s_zz = -(1/pi) x (x^2 + 3 z^2)/(x^2 + z^2)^2,    s_rr = (1/2 pi) [x (x^2 + 3 z^2)/(x^2 + z^2)^2 - 2 (1 + nu) x/(x^2 + z^2)]
!>
!> for a depth of 1 (from Boussinesq's V = 2 int y z/(z^2 + x^2) dx). In Maugis's theory y is that of a uniform tension S on r < c, which
!> has closed forms, and of -dy = g' dx + 2 S x/sqrt(c^2 - x^2) dx on x < a. Poles are at x = +-i z, which the logarithm of x keeps
!> pi/2 away from all positions.
module adfric_round_axis_stress
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_round_contact_state, only: contact_t
   use adfric_round_shape, only: shape_t, spot_t
   use adfric_numerics_panels, only: panel_integrand_t, integrate
   implicit none (type, external)
   private
   public :: get_axis_stress

   !> Where a decaying exponential is round-off.
   real(dp), parameter :: decayed = 40.0_dp

   !> One of the two functions of x, times dg/dt along u = high exp(-t).
   type, extends(panel_integrand_t) :: profile_integrand_t
      !> The shape.
      class(shape_t), allocatable :: shape
      !> Do the positions lie beyond the corner?
      logical :: is_beyond = .true.
      !> The largest u, and the depth z.
      real(dp) :: high = 1, depth = 1
      !> Is it x/(x^2 + z^2)?
      logical :: is_simple = .true.
   contains
      procedure :: value_at => profile_value
   end type profile_integrand_t

   !> The same times 2 S x/sqrt(c^2 - x^2) dx/dt along x = c sin(y), y = high exp(-t).
   type, extends(panel_integrand_t) :: axis_zone_integrand_t
      !> arcsin(a/c), c, and the depth z.
      real(dp) :: high = 1, radius = 1, depth = 1
      !> Is it x/(x^2 + z^2)?
      logical :: is_simple = .true.
   contains
      procedure :: value_at => zone_value
   end type axis_zone_integrand_t

contains

   !> The stresses at a depth below the middle of a contact.
   pure subroutine get_axis_stress(shape, contact, poisson_ratio, depth, s_zz, s_rr)
      class(shape_t), intent(in) :: shape
      type(contact_t), intent(in) :: contact
      !> Poisson's ratio of the half-space.
      real(dp), intent(in) :: poisson_ratio
      !> z > 0, reduced.
      real(dp), intent(in) :: depth
      !> Receive the stress along the axis, and that across it, the same in all directions.
      real(dp), intent(out) :: s_zz, s_rr
      real(dp) :: simple, steep, level, a

      a = contact%spot%radius
      simple = profile_integral(shape, contact, depth, .true.) + zone_integral(contact, depth, .true.)
      steep = profile_integral(shape, contact, depth, .false.) + zone_integral(contact, depth, .false.)
      if (.not. contact%stress > 0 .and. a > 0) then
         ! the punch of radius a as a whole
         simple = simple - contact%neck*punch(a, depth, .true.)
         steep = steep - contact%neck*punch(a, depth, .false.)
      end if
      s_zz = -steep/pi
      s_rr = (steep - 2*(1 + poisson_ratio)*simple)/(2*pi)
      if (.not. contact%stress > 0) return
      level = depth/hypot(depth, contact%adhesion_radius)
      s_zz = s_zz + contact%stress*(1 - level)*(1 + level + level**2)
      ! (1 + 2 nu)/2 - (1 + nu) level + level^3/2, which falls like (1 - level) at depth
      s_rr = s_rr + contact%stress*(1 - level)*(1 + 2*poisson_ratio - level - level**2)/2
   end subroutine get_axis_stress

   !> x/(x^2 + z^2), or x (x^2 + 3 z^2)/(x^2 + z^2)^2.
   elemental real(dp) function punch(x, depth, is_simple)
      !> Radius x of the punch.
      real(dp), intent(in) :: x
      !> z.
      real(dp), intent(in) :: depth
      !> Which of the two.
      logical, intent(in) :: is_simple
      real(dp) :: distance

      distance = hypot(x, depth)
      punch = (x/distance)/distance
      if (.not. is_simple) punch = punch*(1 + 2*(depth/distance)**2)
   end function punch

   !> The integral over g.
   pure real(dp) function profile_integral(shape, contact, depth, is_simple) result(total)
      class(shape_t), intent(in) :: shape
      type(contact_t), intent(in) :: contact
      real(dp), intent(in) :: depth
      !> Which of the two functions.
      logical, intent(in) :: is_simple
      type(profile_integrand_t) :: integrand

      total = 0
      if (shape%n_pieces == 0 .or. .not. contact%u > 0) return
      allocate (integrand%shape, source=shape)
      integrand%depth = depth
      integrand%is_simple = is_simple
      if (contact%is_beyond) then
         integrand%high = contact%u
         total = integrate(integrand, 0.0_dp, decayed/(1 + shape%onset))
      end if
      if (.not. shape%inner_rise() > 0) return
      integrand%is_beyond = .false.
      integrand%high = min(contact%spot%radius, shape%corner)
      total = total + integrate(integrand, 0.0_dp, decayed/2)
   end function profile_integral

   !> See `panel_integrand_t`.
   pure real(dp) function profile_value(self, position)
      class(profile_integrand_t), intent(in) :: self
      !> t > 0.
      real(dp), intent(in) :: position
      type(spot_t) :: spot
      real(dp) :: u

      u = self%high*exp(-position)
      call self%shape%evaluate(u, self%is_beyond, spot)
      profile_value = punch(spot%radius, self%depth, self%is_simple)*spot%depth_slope*u
   end function profile_value

   !> The integral over the tension.
   pure real(dp) function zone_integral(contact, depth, is_simple) result(total)
      type(contact_t), intent(in) :: contact
      real(dp), intent(in) :: depth
      logical, intent(in) :: is_simple
      type(axis_zone_integrand_t) :: integrand

      total = 0
      if (.not. (contact%stress > 0 .and. contact%spot%radius > 0)) return
      integrand%high = atan2(contact%spot%radius, contact%neck/(2*contact%stress))
      integrand%radius = contact%adhesion_radius
      integrand%depth = depth
      integrand%is_simple = is_simple
      total = 2*contact%stress*integrate(integrand, 0.0_dp, decayed/2)
   end function zone_integral

   !> See `panel_integrand_t`.
   pure real(dp) function zone_value(self, position)
      class(axis_zone_integrand_t), intent(in) :: self
      !> t > 0.
      real(dp), intent(in) :: position
      real(dp) :: angle, x

      angle = self%high*exp(-position)
      x = self%radius*sin(angle)
      zone_value = punch(x, self%depth, self%is_simple)*x*angle
   end function zone_value

end module adfric_round_axis_stress

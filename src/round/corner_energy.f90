! SPDX-License-Identifier: GPL-3.0-or-later
!> Elastic energy int [g(a) - g(x)]^2 dx, 0 < x < a, of shapes with a corner at 1, for contacts beyond it: with v = sqrt(a^2 - 1),
!> phi = arctan(v) and T = arsinh(v), from the integrals over 1 < x < a
!>
!>     int x v = v^3/3,   int x phi = (a^2 phi - v)/2,   int x^2 v^2 = (a - 1)^2 (3 a^3 + 6 a^2 + 4 a + 2)/15
!>     int x^2 phi^2 = a^3 phi^2/3 - [phi (a v + T) - (a - 1) - Q]/3
!>     int x^2 v phi = phi [a^3 v/4 - (a v + T)/8] - (a^3 - 1)/12 + (a - 1 + Q)/8
!>     Q = int t/cosh(t) dt, 0 < t < T, = 2 G - 2 sum of (-1)^k e^(-n T) (T + 1/n)/n,   n = 2 k + 1,   G = 0.9159...
!>
!> Beside small contacts, and for the rounded cone, of whose closed form the terms would cancel, the integral is one of Gauss's.
module adfric_round_corner_energy
   use adfric_base_kinds, only: dp
   use adfric_round_corner_kinds, only: flat_face, flat_cone, flat_paraboloid, rounded_punch, rounded_cone, depth_beyond
   use adfric_numerics_gauss, only: gauss_nodes_10, gauss_weights_10
   use adfric_numerics_panels, only: panel_integrand_t, integrate
   implicit none (type, external)
   private
   public :: corner_energy

   !> From this v on the series of Q has its digits, and the differences of a punch, too.
   real(dp), parameter :: least_closed = 0.7_dp

   !> [g(a) - g(x)]^2 dx/dt, v = sinh(t).
   type, extends(panel_integrand_t) :: corner_energy_integrand_t
      !> The kind of the shape.
      integer :: kind = flat_cone
      !> g(a).
      real(dp) :: depth = 0
   contains
      procedure :: value_at
   end type corner_energy_integrand_t

contains

   !> The energy of a contact beyond the corner.
   pure real(dp) function corner_energy(kind, v) result(energy)
      !> One of the kinds of `adfric_round_corner_kinds`.
      integer, intent(in) :: kind
      !> v, >= 0.
      real(dp), intent(in) :: v

      if (kind == flat_face) then
         energy = 0
      else if (kind == flat_paraboloid) then
         energy = paraboloid_energy(v)
      else if (v < least_closed .or. kind == rounded_cone) then
         energy = integrated_energy(kind, v)
      else if (kind == rounded_punch) then
         energy = punch_energy(v)
      else
         energy = cone_energy(v)
      end if
   end function corner_energy

   !> The energy as an integral over v where the contact is small, else over t, v = sinh(t); within the corner it is a polynomial.
   pure real(dp) function integrated_energy(kind, v) result(energy)
      integer, intent(in) :: kind
      real(dp), intent(in) :: v
      type(corner_energy_integrand_t) :: integrand

      integrand%kind = kind
      integrand%depth = depth_beyond(kind, v, sqrt(1 + v*v))
      energy = integrand%depth**2
      if (kind == rounded_cone) energy = (integrand%depth - 1)**2 + 4*(integrand%depth - 1)/3 + 8.0_dp/15
      if (v < least_closed) then
         energy = energy + short_energy(integrand, v)
      else
         energy = energy + integrate(integrand, 0.0_dp, asinh(v))
      end if
   end function integrated_energy

   !> What lies beyond the corner as an integral over v. Its singularities are at v = i, so 10 nodes do.
   pure real(dp) function short_energy(integrand, v) result(energy)
      type(corner_energy_integrand_t), intent(in) :: integrand
      !> v of the contact, < `least_closed`.
      real(dp), intent(in) :: v
      real(dp) :: position, x
      integer :: node

      energy = 0
      do node = 1, size(gauss_nodes_10)
         position = v*(1 + gauss_nodes_10(node))/2
         x = sqrt(1 + position*position)
         energy = energy + gauss_weights_10(node)*position/x*(integrand%depth - depth_beyond(integrand%kind, position, x))**2
      end do
      energy = energy*v/2
   end function short_energy

   !> See `panel_integrand_t`.
   pure real(dp) function value_at(self, position)
      class(corner_energy_integrand_t), intent(in) :: self
      !> t > 0 of a radius inside the contact.
      real(dp), intent(in) :: position
      real(dp) :: v

      v = sinh(position)
      value_at = (self%depth - depth_beyond(self%kind, v, sqrt(1 + v*v)))**2*v
   end function value_at

   !> That of a cone.
   pure real(dp) function cone_energy(v) result(energy)
      !> v, >= `least_closed`.
      real(dp), intent(in) :: v
      real(dp) :: a, phi, t, depth

      a = sqrt(1 + v*v)
      phi = atan(v)
      t = log(a + v)
      depth = a*phi
      energy = depth*(depth*a - (a*a*phi - v)) + square_of_angle(v, a, phi, t, decaying_integral(a + v, t))
   end function cone_energy

   !> That of a paraboloid.
   pure real(dp) function paraboloid_energy(v) result(energy)
      real(dp), intent(in) :: v
      real(dp) :: a, depth

      a = sqrt(1 + v*v)
      depth = a*v
      energy = depth*(depth*a - 2*v**3/3) + square_of_path(v, a)
   end function paraboloid_energy

   !> That of a punch with a rounded edge.
   pure real(dp) function punch_energy(v) result(energy)
      real(dp), intent(in) :: v
      real(dp) :: a, phi, t, q, depth, less, mixed

      a = sqrt(1 + v*v)
      phi = atan(v)
      t = log(a + v)
      q = decaying_integral(a + v, t)
      less = v*v/(1 + a)
      depth = a*(v - phi)
      mixed = phi*(a**3*v/4 - (a*v + t)/8) - less*(a*a + a + 1)/12 + (less + q)/8
      energy = depth*(depth*a - 2*v**3/3 + a*a*phi - v) + square_of_path(v, a) - 2*mixed + square_of_angle(v, a, phi, t, q)
   end function punch_energy

   !> int x^2 v^2 dx.
   pure real(dp) function square_of_path(v, a) result(square)
      !> v, and the radius a.
      real(dp), intent(in) :: v, a

      square = (v*v/(1 + a))**2*(2 + a*(4 + a*(6 + 3*a)))/15
   end function square_of_path

   !> int x^2 phi^2 dx.
   pure real(dp) function square_of_angle(v, a, phi, t, q) result(square)
      !> v, the radius a, phi, T and Q.
      real(dp), intent(in) :: v, a, phi, t, q

      square = (a**3*phi**2 - phi*(a*v + t) + v*v/(1 + a) + q)/3
   end function square_of_angle

   !> Q.
   pure real(dp) function decaying_integral(growth, t) result(q)
      !> e^T, and T.
      real(dp), intent(in) :: growth, t
      real(dp), parameter :: twice_catalan = 1.8319311883544380_dp
      integer, parameter :: most_terms = 32
      real(dp) :: decay
      integer :: k, n

      q = twice_catalan
      decay = 2/growth
      do k = 0, most_terms
         n = 2*k + 1
         q = q - decay*(t + 1.0_dp/n)/n
         decay = -decay/growth**2
         if (abs(decay) < epsilon(q)) exit
      end do
   end function decaying_integral

end module adfric_round_corner_energy

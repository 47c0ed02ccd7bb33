! SPDX-License-Identifier: GPL-3.0-or-later
!> The exact sphere, f = R - sqrt(R^2 - r^2), in units of its radius R:
!>
!>     g = s artanh(s),  P1 = (1 + s^2) artanh(s) - s,  s = a/R
!>
!> The unknown is u = artanh(s), which has digits where s is close to 1.
module adfric_round_sphere_shape
   use adfric_base_kinds, only: dp
   use adfric_round_closed_annulus, only: get_sphere_annulus
   use adfric_round_shape, only: shape_t, spot_t
   use adfric_numerics_gauss, only: gauss_nodes_10, gauss_weights_10
   use adfric_numerics_libm, only: expm1
   use adfric_numerics_panels, only: panel_integrand_t, integrate
   implicit none (type, external)
   private
   public :: sphere_shape_t, new_sphere_shape

   !> Below this s the load is a series.
   real(dp), parameter :: small = 0.3_dp
   !> Up to this u 10 nodes do for its energy, whose singularities are at i pi/2.
   real(dp), parameter :: one_range = 1.0_dp
   !> Beyond this u the rest of the sphere is round-off.
   real(dp), parameter :: decayed = 24.0_dp

   !> A sphere of radius 1.
   type, extends(shape_t) :: sphere_shape_t
   contains
      procedure :: evaluate
      procedure :: unknown_of
      procedure :: get_end
      procedure :: rise
      procedure :: inner_rise
      procedure :: energy
      procedure :: get_profile
      procedure :: radius_of_height
      procedure :: get_closed_annulus
   end type sphere_shape_t

   !> [g(a) - g(x)]^2 dx/du.
   type, extends(panel_integrand_t) :: energy_integrand_t
      !> g(a).
      real(dp) :: depth = 0
   contains
      procedure :: value_at
   end type energy_integrand_t

contains

   !> The shape.
   pure subroutine new_sphere_shape(self)
      type(sphere_shape_t), intent(out) :: self

      self%edge = 1
      self%reach = 1
   end subroutine new_sphere_shape

   !> See `shape_t`.
   pure subroutine evaluate(self, u, is_beyond, spot)
      class(sphere_shape_t), intent(in) :: self
      real(dp), intent(in) :: u
      logical, intent(in) :: is_beyond
      type(spot_t), intent(out) :: spot

      associate (s => spot%radius, q => spot%radius_slope)
         s = tanh(u)
         q = inverse_square_cosh(u)
         spot%beyond = s
         spot%radius_curve = -2*s*q
         spot%depth = s*u
         spot%depth_slope = s + u*q
         spot%depth_curve = 2*q*(1 - u*s)
         if (s < small) then
            spot%load = load_series(s)
         else
            spot%load = (1 + s*s)*u - s
         end if
      end associate
      associate (unused => self, unused_too => is_beyond)
      end associate
   end subroutine evaluate

   !> The load as the sum of 4 k/(4 k^2 - 1) s^(2 k + 1), k = 1, 2, ...
   elemental real(dp) function load_series(s) result(load)
      !> Radius s of contact, 0 <= s <= `small`.
      real(dp), intent(in) :: s
      integer, parameter :: n_terms = 17
      integer :: k

      load = 0
      do k = n_terms, 1, -1
         load = load*s*s + 4.0_dp*k/(4*k*k - 1)
      end do
      load = load*s**3
   end function load_series

   !> 1/cosh(u)^2 = 1 - s^2.
   elemental real(dp) function inverse_square_cosh(u) result(square)
      !> The unknown, >= 0.
      real(dp), intent(in) :: u
      real(dp) :: decay

      decay = exp(-2*u)
      square = 4*decay/(1 + decay)**2
   end function inverse_square_cosh

   !> See `shape_t`.
   elemental real(dp) function unknown_of(self, radius)
      class(sphere_shape_t), intent(in) :: self
      real(dp), intent(in) :: radius

      unknown_of = atanh(radius)
      associate (unused => self)
      end associate
   end function unknown_of

   !> See `shape_t`: sqrt(s) g' is above 2 s^(3/2), and from u = 1 on above 2/3 cosh(u)^2.
   pure real(dp) function get_end(self, target)
      class(sphere_shape_t), intent(in) :: self
      real(dp), intent(in) :: target
      real(dp), parameter :: margin = 1.0_dp + 1.0e-6_dp

      get_end = margin*(target/2)**(2.0_dp/3)
      if (get_end < 0.9_dp) then
         get_end = atanh(get_end)
      else
         get_end = 1 + asinh(sqrt(1.5_dp*target))
      end if
      associate (unused => self)
      end associate
   end function get_end

   !> See `shape_t`.
   elemental real(dp) function rise(self, v)
      class(sphere_shape_t), intent(in) :: self
      real(dp), intent(in) :: v

      rise = atanh(v) + v/((1 - v)*(1 + v))
      associate (unused => self)
      end associate
   end function rise

   !> See `shape_t`: there is no corner.
   pure real(dp) function inner_rise(self)
      class(sphere_shape_t), intent(in) :: self

      inner_rise = 0
      associate (unused => self)
      end associate
   end function inner_rise

   !> See `shape_t`.
   pure real(dp) function energy(self, u, is_beyond)
      class(sphere_shape_t), intent(in) :: self
      real(dp), intent(in) :: u
      logical, intent(in) :: is_beyond
      type(energy_integrand_t) :: integrand
      integer :: node

      integrand%depth = u*tanh(u)
      if (u > one_range) then
         energy = integrate(integrand, 0.0_dp, min(u, decayed))
      else
         energy = 0
         do node = 1, size(gauss_nodes_10)
            energy = energy + gauss_weights_10(node)*u/2*integrand%value_at(u*(1 + gauss_nodes_10(node))/2)
         end do
      end if
      associate (unused => self, unused_too => is_beyond)
      end associate
   end function energy

   !> See `panel_integrand_t`.
   pure real(dp) function value_at(self, position)
      class(energy_integrand_t), intent(in) :: self
      !> The unknown artanh(x) of a radius inside the contact.
      real(dp), intent(in) :: position

      real(dp) :: less

      less = expm1(-2*position)
      ! tanh(u) and 1/cosh(u)^2
      value_at = (self%depth + position*less/(2 + less))**2*(4*(1 + less)/(2 + less)**2)
   end function value_at

   !> See `shape_t`.
   pure subroutine get_profile(self, r, height, slope)
      class(sphere_shape_t), intent(in) :: self
      real(dp), intent(in) :: r
      real(dp), intent(out) :: height, slope
      real(dp) :: level

      level = sqrt((1 - r)*(1 + r))
      height = r*r/(1 + level)
      slope = r/level
      associate (unused => self)
      end associate
   end subroutine get_profile

   !> See `shape_t`; above the equator there is none but 1.
   pure real(dp) function radius_of_height(self, height)
      class(sphere_shape_t), intent(in) :: self
      real(dp), intent(in) :: height

      radius_of_height = 1
      if (height < 1) radius_of_height = sqrt(height*(2 - height))
      associate (unused => self)
      end associate
   end function radius_of_height

   !> See `shape_t`.
   pure subroutine get_closed_annulus(self, spot, is_beyond, s, opening, intensity, is_closed)
      class(sphere_shape_t), intent(in) :: self
      type(spot_t), intent(in) :: spot
      logical, intent(in) :: is_beyond
      real(dp), intent(in) :: s
      real(dp), intent(out) :: opening, intensity
      logical, intent(out) :: is_closed
      real(dp) :: u

      is_closed = .true.
      u = 0
      if (spot%radius > 0) u = spot%depth/spot%radius
      call get_sphere_annulus(u, spot%radius, spot%radius_slope, s, opening, intensity)
      associate (unused => self, unused_too => is_beyond)
      end associate
   end subroutine get_closed_annulus

end module adfric_round_sphere_shape

! SPDX-License-Identifier: GPL-3.0-or-later
!> A wedge z = s |x| that slides along +x on an elastic half-plane with a shear stress mu p that moves the contact -a < x < b.
!>
!> With m = mu beta = tan(pi eta) the pressure is, with the integral over the other side of the apex,
!>
!>     p = (s E*/pi) cos^2(pi eta) X |int W/(t - x) dt|,   X = 1/W = (x + a)^(1/2 - eta) (b - x)^(1/2 + eta)
!>
!> It is bounded at both ends where u = a/(a + b) is the median of the beta distribution of 1/2 + eta and 1/2 - eta. With Y of this
!> distribution the load is
!>
!>     P = (pi E* s/2) (a + b) E|Y - u| = E* s cos(pi eta) a^(1/2 + eta) b^(1/2 - eta)
!>
!> since the mean deviation from a median is a difference of incomplete beta functions, of which only the powers remain.
!> The force on the slopes is T_s = s int p sgn(x) dx, and by the energy -(2 m/E*) int p^2 dx.
module adfric_plane_coupled_wedge
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_numerics_double_exponential, only: integrand_t, integrate
   use adfric_numerics_libm, only: expm1, log1p
   use adfric_numerics_scalar_root, only: equation_t, find_root
   implicit none (type, external)
   private
   public :: coupled_wedge_t, find_coupled_wedge

   !> How far the force on the slopes may be off that by the energy, over slope and load.
   real(dp), parameter :: balance = 1.0e-9_dp

   !> A wedge in contact, in the units of its input.
   type :: coupled_wedge_t
      !> eta, slope s and modulus E*.
      real(dp) :: eta = 0, slope = 1, modulus = 1
      !> Ends a, b of the contact, both > 0.
      real(dp) :: behind = 1, ahead = 1
      !> Load and force on the slopes per length; the latter also by the energy.
      real(dp) :: load = 0, slope_friction = 0, friction_of_energy = 0
   contains
      procedure :: wedge_pressure_at
   end type coupled_wedge_t

   !> Half of the distribution less the part below u.
   type, extends(equation_t) :: median_t
      !> eta.
      real(dp) :: eta = 0
   contains
      procedure :: evaluate => evaluate_median
   end type median_t

   !> y^near (beyond + length - y)^far over y from an end to the apex, by v = (y/length)^(near + 1): in v the end has no pole.
   type, extends(integrand_t) :: density_t
      !> Powers of the distances from the end and from the other one; distances of the apex from both.
      real(dp) :: near = -0.5_dp, far = -0.5_dp, length = 1, beyond = 0
      !> Distance of a position on the other side from the apex, by which (t - x) divides what the density is above that at the apex;
      !> below 0: none.
      real(dp) :: apart = -1, at_apex = 0
   contains
      procedure :: sum_up
      procedure :: evaluate => evaluate_density
   end type density_t

   !> The pressure on one side, or its square.
   type, extends(integrand_t) :: wedge_side_t
      !> The wedge.
      type(coupled_wedge_t) :: wedge
      !> Is it the side ahead of the apex, and is it the square?
      logical :: is_ahead = .true., is_square = .false.
   contains
      procedure :: evaluate => evaluate_side
   end type wedge_side_t

contains

   !> The contact of a half-width (a + b)/2, or under a load.
   pure subroutine find_coupled_wedge(m, slope, modulus, load, half_width, wedge, is_found)
      !> m = mu beta [-], >= 0, slope [-] and contact modulus.
      real(dp), intent(in) :: m, slope, modulus
      !> Load per length, which counts where the half-width is not above 0; and half-width.
      real(dp), intent(in) :: load, half_width
      !> Receives the contact.
      type(coupled_wedge_t), intent(out) :: wedge
      !> Was the contact found, have its integrals come to rest, and do the energies agree?
      logical, intent(out) :: is_found
      type(median_t) :: median
      type(wedge_side_t) :: side
      real(dp) :: u, length, sums(2, 2)
      logical :: is_there(2, 2)
      integer :: i, k

      wedge%eta = atan(m)/pi
      wedge%slope = slope
      wedge%modulus = modulus
      median%eta = wedge%eta
      u = 0.5_dp
      call find_root(median, 0.0_dp, 1.0_dp, .true., u, is_found)
      if (.not. is_found) return
      associate (unit => modulus*slope*cos(pi*wedge%eta)*u**(0.5_dp + wedge%eta)*(1 - u)**(0.5_dp - wedge%eta))
         length = 2*half_width
         if (.not. half_width > 0) length = load/unit
         wedge%load = unit*length
      end associate
      wedge%behind = u*length
      wedge%ahead = (1 - u)*length
      side%wedge = wedge
      do k = 1, 2
         do i = 1, 2
            side%is_ahead = i == 1
            side%is_square = k == 2
            call integrate(side, merge(wedge%ahead, wedge%behind, side%is_ahead), sums(i, k), is_there(i, k))
         end do
      end do
      wedge%slope_friction = slope*(sums(1, 1) - sums(2, 1))
      wedge%friction_of_energy = -2*(m/modulus)*sum(sums(:, 2))
      is_found = all(is_there) .and. abs(wedge%slope_friction - wedge%friction_of_energy) <= balance*slope*wedge%load
   end subroutine find_coupled_wedge

   !> See `equation_t`.
   pure subroutine evaluate_median(self, x, value, slope)
      class(median_t), intent(in) :: self
      !> u, between 0 and 1.
      real(dp), intent(in) :: x
      !> Part below u less a half; NaN where its integral has no rest.
      real(dp), intent(out) :: value
      real(dp), intent(out) :: slope
      type(density_t) :: density
      logical :: is_converged

      density%near = self%eta - 0.5_dp
      density%far = -self%eta - 0.5_dp
      density%length = x
      density%beyond = 1 - x
      call density%sum_up(value, is_converged)
      value = cos(pi*self%eta)/pi*value - 0.5_dp
      if (.not. is_converged) value = not_a_number()
      slope = cos(pi*self%eta)/pi*x**density%near*(1 - x)**density%far
   end subroutine evaluate_median

   !> The integral.
   pure subroutine sum_up(self, integral, is_converged)
      class(density_t), intent(in) :: self
      real(dp), intent(out) :: integral
      !> Has it come to rest?
      logical, intent(out) :: is_converged

      call integrate(self, 1.0_dp, integral, is_converged)
      integral = self%length/(self%near + 1)*integral
   end subroutine sum_up

   !> See `integrand_t`.
   pure real(dp) function evaluate_density(self, from_left, from_right) result(value)
      class(density_t), intent(in) :: self
      !> v, and 1 - v.
      real(dp), intent(in) :: from_left, from_right
      real(dp) :: apart, ratio

      ! (y/length)^-near of dy/dv is what takes the pole
      ratio = from_left**(1/(self%near + 1))
      ! next to the left end from_right may be 1, which has no logarithm here
      if (from_left < from_right) then
         apart = self%length*(1 - ratio)
      else
         apart = -self%length*expm1(log1p(-from_right)/(self%near + 1))
      end if
      value = self%length**self%near*(self%beyond + apart)**self%far
      if (self%apart >= 0) value = (value - self%at_apex*ratio**(-self%near))/(self%apart + apart)
   end function evaluate_density

   !> Pressure at a distance from the apex.
   pure real(dp) function pressure_beside(self, distance, from_end, is_ahead) result(pressure)
      type(coupled_wedge_t), intent(in) :: self
      !> Distances from the apex and from the end of the side, both > 0.
      real(dp), intent(in) :: distance, from_end
      !> Is it ahead of the apex?
      logical, intent(in) :: is_ahead
      type(density_t) :: density
      real(dp) :: integral
      logical :: is_converged

      density%apart = distance
      associate (a => self%behind, b => self%ahead, eta => self%eta)
         if (is_ahead) then
            density%near = eta - 0.5_dp
            density%far = -eta - 0.5_dp
            density%length = a
            density%beyond = b
            density%at_apex = a**density%near*b**density%far
            call density%sum_up(integral, is_converged)
            integral = integral + density%at_apex*log1p(a/distance)
            pressure = (a + distance)**(0.5_dp - eta)*from_end**(0.5_dp + eta)*integral
         else
            density%near = -eta - 0.5_dp
            density%far = eta - 0.5_dp
            density%length = b
            density%beyond = a
            density%at_apex = b**density%near*a**density%far
            call density%sum_up(integral, is_converged)
            integral = integral + density%at_apex*log1p(b/distance)
            pressure = from_end**(0.5_dp - eta)*(b + distance)**(0.5_dp + eta)*integral
         end if
         pressure = self%slope*self%modulus/pi*cos(pi*eta)**2*pressure
      end associate
      if (.not. is_converged) pressure = not_a_number()
   end function pressure_beside

   !> Pressure at a position; 0 outside the contact, infinite and so NaN at the apex.
   elemental real(dp) function wedge_pressure_at(self, x) result(pressure)
      class(coupled_wedge_t), intent(in) :: self
      !> Position from the apex, ahead > 0.
      real(dp), intent(in) :: x

      pressure = 0
      if (x >= self%ahead .or. x <= -self%behind) return
      pressure = not_a_number()
      if (x > 0) pressure = pressure_beside(self, x, self%ahead - x, .true.)
      if (x < 0) pressure = pressure_beside(self, -x, self%behind + x, .false.)
   end function wedge_pressure_at

   !> See `integrand_t`.
   pure real(dp) function evaluate_side(self, from_left, from_right) result(value)
      class(wedge_side_t), intent(in) :: self
      !> Distances from the apex and from the end.
      real(dp), intent(in) :: from_left, from_right

      value = pressure_beside(self%wedge, from_left, from_right, self%is_ahead)
      if (self%is_square) value = value**2
   end function evaluate_side

end module adfric_plane_coupled_wedge

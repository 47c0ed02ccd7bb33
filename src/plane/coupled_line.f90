! SPDX-License-Identifier: GPL-3.0-or-later
!> A cylinder and a flat punch that slide along +x on an elastic half-plane of Poisson's ratio nu < 1/2, where shear moves the contact,
!> in closed form. The equations and what they follow from stand in `adfric_plane_sliding_coupling`; m = mu beta = tan(pi eta).
!>
!> Cylinder of radius R: p = (E*/2R) cos(pi eta) (x+a)^(1/2-eta) (b-x)^(1/2+eta), a, b = w (1 +- 2 eta). A tau shifts it as a slope s
!> shifts a parabola.
!>
!>
!> Flat punch of half-width w: p = (P cos(pi eta)/pi) (w+x)^(-1/2-eta) (w-x)^(-1/2+eta).
module adfric_plane_coupled_line
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_numerics_double_exponential, only: integrand_t, integrate
   implicit none (type, external)
   private
   public :: coupled_cylinder_t, coupled_cylinder, coupled_punch_pressure

   !> A cylinder, in the units of its input.
   type :: coupled_cylinder_t
      !> eta = atan(m)/pi, radius and modulus.
      real(dp) :: eta = 0, radius = 1, modulus = 1
      !> Half-width w and middle of the contact; load and T_s per length; largest pressure.
      real(dp) :: half_width = 0, centre = 0, load = 0, slope_friction = 0, peak_pressure = 0
      !> T_s by the energy.
      real(dp) :: friction_of_energy = 0
   contains
      procedure :: cylinder_pressure_at
      procedure :: cylinder_gap_at
   end type coupled_cylinder_t

   !> (x + a)^(1/2 -+ eta) (x - b)^(1/2 +- eta) outside the contact of a cylinder, or its square inside.
   type, extends(integrand_t) :: cylinder_term_t
      !> Powers of the distances from the near and the far edge, length between the edges, and the power of all.
      real(dp) :: near = 0.5_dp, far = 0.5_dp, length = 0
      !> Is it inside?
      logical :: is_inside = .false.
   contains
      procedure :: evaluate => evaluate_cylinder
   end type cylinder_term_t

contains

   !> A cylinder under its load.
   pure type(coupled_cylinder_t) function coupled_cylinder(m, stress, radius, modulus, load) result(contact)
      !> m = mu beta [-], and beta tau [unit of the modulus].
      real(dp), intent(in) :: m, stress
      !> Radius, contact modulus E*, and load per length, >= 0.
      real(dp), intent(in) :: radius, modulus, load
      real(dp) :: square
      logical :: is_found

      contact%eta = atan(m)/pi
      contact%radius = radius
      contact%modulus = modulus
      contact%load = load
      associate (eta => contact%eta, w => contact%half_width)
         w = sqrt(4*(load/modulus)*radius/(pi*(1 - 4*eta**2)))
         contact%centre = -2*eta*w - 2*(stress/modulus)*radius
         contact%slope_friction = load*(-(8*eta/3)*(w/radius) - 2*(stress/modulus))
         contact%peak_pressure = (modulus/(2*radius))*cos(pi*eta)*w*(1 - 2*eta)**(0.5_dp - eta)*(1 + 2*eta)**(0.5_dp + eta)
         call integrate(cylinder_term_t(1 - 2*eta, 1 + 2*eta, 2*w, .true.), 2*w, square, is_found)
         contact%friction_of_energy = -2*tan(pi*eta)*modulus*(cos(pi*eta)/(2*radius))**2*square - 2*(stress/modulus)*load
         if (.not. is_found) contact%friction_of_energy = not_a_number()
      end associate
   end function coupled_cylinder

   !> Pressure at a position.
   pure real(dp) function cylinder_pressure_at(self, x) result(pressure)
      class(coupled_cylinder_t), intent(in) :: self
      !> Position from the lowest line.
      real(dp), intent(in) :: x

      pressure = 0
      associate (y => x - self%centre, w => self%half_width, eta => self%eta)
         if (abs(y) < w) pressure = (self%modulus/(2*self%radius))*cos(pi*eta)*(w + y)**(0.5_dp - eta)*(w - y)**(0.5_dp + eta)
      end associate
   end function cylinder_pressure_at

   !> Gap at a position. A constant shear stress leaves it as it is of a parabola that is shifted, up to the line that it adds.
   pure real(dp) function cylinder_gap_at(self, x) result(gap)
      class(coupled_cylinder_t), intent(in) :: self
      !> Position from the lowest line.
      real(dp), intent(in) :: x
      real(dp) :: y, length, tilt
      logical :: is_found

      y = x - self%centre
      gap = 0
      length = abs(y) - self%half_width
      if (.not. length > 0) return
      associate (eta => sign(self%eta, y*self%eta))
         call integrate(cylinder_term_t(0.5_dp + eta, 0.5_dp - eta, 2*self%half_width, .false.), length, gap, is_found)
      end associate
      ! s = 2 beta tau/E*
      tilt = -(self%centre + 2*self%eta*self%half_width)/self%radius
      gap = gap/self%radius - sign(tilt, y*tilt)*length
      if (.not. is_found) gap = not_a_number()
   end function cylinder_gap_at

   !> Powers of the distances from both edges.
   pure real(dp) function evaluate_cylinder(self, from_left, from_right) result(value)
      class(cylinder_term_t), intent(in) :: self
      real(dp), intent(in) :: from_left, from_right

      value = from_left**self%near*merge(from_right, self%length + from_left, self%is_inside)**self%far
   end function evaluate_cylinder

   !> Pressure below a flat punch that slides, with a load per length.
   elemental real(dp) function coupled_punch_pressure(m, half_width, load, x) result(pressure)
      !> m = mu beta [-], half-width, load per length, and the position from the middle.
      real(dp), intent(in) :: m, half_width, load, x
      real(dp) :: eta

      eta = atan(m)/pi
      pressure = 0
      if (abs(x) < half_width) pressure = load*(cos(pi*eta)/pi)*(half_width + x)**(-0.5_dp - eta)*(half_width - x)**(-0.5_dp + eta)
   end function coupled_punch_pressure

end module adfric_plane_coupled_line

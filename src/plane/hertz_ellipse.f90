! SPDX-License-Identifier: GPL-3.0-or-later
!> Hertz's contact of two surfaces whose gap is z = A x^2 + B y^2, 0 < A <= B (Johnson, Contact Mechanics, 1985, 4.2).
!>
!> The ellipse of contact has the half-axes a >= b, the pressure p = p0 sqrt(1 - x^2/a^2 - y^2/b^2), p0 = 3 P/(2 pi a b). With
!> Carlson's symmetric integrals, whose values are those of Legendre's E and K without their differences,
!>
!>     A = (P/2 pi E*) R_D(0, b^2, a^2),  B = (P/2 pi E*) R_D(0, a^2, b^2),  delta = (3 P/2 pi E*) R_F(0, a^2, b^2)
!>
!> Depth z into the solid; tension is positive.
module adfric_plane_hertz_ellipse
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_numerics_elliptic, only: carlson_d, carlson_f
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   use adfric_numerics_powers, only: cube_root
   use adfric_numerics_scalar_root, only: equation_t, find_root
   implicit none (type, external)
   private
   public :: ellipse_t, ellipse_shape_t, find_curvatures, find_shape, ellipse_of_load, ellipse_of_approach
   public :: ellipse_pressure, ellipse_gap, ellipse_axial_stress, ellipse_edge_shear, ellipse_misfit

   !> An axis ratio nearer to 1 than this is that of a circle where a difference would be divided by it.
   real(dp), parameter :: nearly_round = 1.0e-6_dp
   !> A Newton step of this size of ln(b/a) is the last.
   real(dp), parameter :: last_step = 1.0e-9_dp
   !> Deviators that add up to less than this share of their sizes cancel.
   real(dp), parameter :: round_off = 8*epsilon(1.0_dp)
   !> Widest panel of the quadrature of the gap.
   real(dp), parameter :: panel = 1.0_dp

   !> What depends on A/B alone.
   type :: ellipse_shape_t
      !> k = b/a.
      real(dp) :: axis_ratio = 1
      !> R_D(0, k^2, 1), R_D(0, 1, k^2) and R_F(0, 1, k^2).
      real(dp) :: d_along = 0, d_across = 0, f = 0
      !> Has the axis ratio been found to round-off?
      logical :: is_converged = .false.
   end type ellipse_shape_t

   !> A contact.
   type :: ellipse_t
      !> Half-axes a >= b [m].
      real(dp) :: major = 0, minor = 0
      !> Load P [N], approach delta [m], largest pressure p0 [Pa].
      real(dp) :: load = 0, approach = 0, peak_pressure = 0
      !> Shape of the ellipse, which does not depend on the load.
      type(ellipse_shape_t) :: shape
   end type ellipse_t

   !> ln[R_D(0, k^2, 1)/R_D(0, 1, k^2)] - ln(A/B) for x = ln k, k = b/a.
   type, extends(equation_t) :: axis_ratio_equation_t
      !> ln(A/B), A and B being the smaller and the larger curvature of the gap.
      real(dp) :: logarithm = 0
   contains
      procedure :: evaluate
   end type axis_ratio_equation_t

contains

   !> Curvatures A <= B of the gap between two bodies with principal curvatures `first` and `second` [1/m], convex positive,
   !> and the angle between their first principal directions. Without differences of near numbers,
   !>
   !>     A + B = half the sum of all four, B - A = half the length of the deviators, 4 A B = determinant of the tensors' sum
   !>
   !> A <= 0 means that there is no single ellipse of contact.
   pure subroutine find_curvatures(first, second, angle, a, b, direction)
      !> Principal curvatures of the first body [1/m], convex positive.
      real(dp), intent(in) :: first(2)
      !> Principal curvatures of the second body [1/m], convex positive.
      real(dp), intent(in) :: second(2)
      !> Angle from the first principal direction of the first body to that of the second [rad].
      real(dp), intent(in) :: angle
      !> Smaller curvature A of the gap [1/m]; 0 or less where there is no single ellipse of contact.
      real(dp), intent(out) :: a
      !> Larger curvature B of the gap [1/m].
      real(dp), intent(out) :: b
      !> Angle from the first principal direction of the first body to the major axis [rad], in (-pi/2, pi/2]; 0 for a circle.
      real(dp), intent(out) :: direction
      real(dp) :: d1, d2, along, across, determinant

      d1 = first(1) - first(2)
      d2 = second(1) - second(2)
      along = d1 + d2*cos(2*angle)
      across = d2*sin(2*angle)
      b = (sum(first) + sum(second) + hypot(along, across))/4
      determinant = product(first) + product(second) + (first(1)*second(2) + first(2)*second(1))*square_of(cos(angle), angle) &
         & + (first(1)*second(1) + first(2)*second(2))*square_of(sin(angle), angle)
      a = 0
      if (b > 0) a = min(b, determinant/4/b)
      direction = 0
      if (.not. hypot(along, across) > round_off*(abs(d1) + abs(d2))) return
      ! the gap rises least across the direction of the larger curvature
      direction = atan2(across, along)/2
      direction = direction - sign(pi/2, direction)
      if (.not. direction > -pi/2) direction = direction + pi
   end subroutine find_curvatures

   !> Square of the cosine or sine of an angle; of what is round-off of the angle nothing is left, so that cylinders turned by a right
   !> angle are parallel.
   pure real(dp) function square_of(value, angle)
      !> The cosine or sine.
      real(dp), intent(in) :: value
      !> The angle [rad].
      real(dp), intent(in) :: angle

      square_of = value**2
      if (abs(value) < 2*epsilon(1.0_dp)*max(1.0_dp, abs(angle))) square_of = 0
   end function square_of

   !> The shape of a ratio A/B of curvatures in (0, 1].
   pure subroutine find_shape(ratio, self)
      !> Ratio A/B of the curvatures [-], in (0, 1].
      real(dp), intent(in) :: ratio
      !> Shape of the ellipse; `is_converged` tells whether it was found.
      type(ellipse_shape_t), intent(out) :: self

      associate (k => self%axis_ratio)
         call find_axis_ratio(ratio, k, self%is_converged)
         if (.not. self%is_converged) return
         self%d_along = carlson_d(0.0_dp, k*k, 1.0_dp)
         self%d_across = carlson_d(0.0_dp, 1.0_dp, k*k)
         self%f = carlson_f(0.0_dp, 1.0_dp, k*k)
      end associate
   end subroutine find_shape

   !> Contact under a load P >= 0.
   pure subroutine ellipse_of_load(a, b, modulus, load, shape, self)
      !> Curvatures A <= B of the gap [1/m].
      real(dp), intent(in) :: a, b
      !> Contact modulus E* [Pa].
      real(dp), intent(in) :: modulus
      !> Load P [N], >= 0.
      real(dp), intent(in) :: load
      type(ellipse_shape_t), intent(in) :: shape
      !> The contact; its half-axes are 0 if the shape is not converged.
      type(ellipse_t), intent(out) :: self

      self%shape = shape
      self%load = load
      if (.not. shape%is_converged) return
      ! A + B, as a sum of terms of one sign
      self%major = cube_root(load/modulus/(2*pi*(a + b))*(shape%d_along + shape%d_across))
      self%minor = shape%axis_ratio*self%major
      if (.not. self%minor > 0) return
      self%peak_pressure = 3*load/(2*pi*self%major*self%minor)
      self%approach = 3*load/(2*pi*modulus*self%major)*shape%f
   end subroutine ellipse_of_load

   !> Contact with an approach delta. The sum of the equations of A and B, and that of delta, without P:
   !>
   !>     3 R_F(0, 1, k^2) (A + B) a^2 = (R_D(0, k^2, 1) + R_D(0, 1, k^2)) delta
   !>
   !> Bodies with delta < 0 are apart: half-axes and load are 0.
   pure subroutine ellipse_of_approach(a, b, modulus, approach, shape, self)
      !> Curvatures A <= B of the gap [1/m].
      real(dp), intent(in) :: a, b
      !> Contact modulus E* [Pa].
      real(dp), intent(in) :: modulus
      !> Approach delta of distant points [m]; the distance between the bodies is negative.
      real(dp), intent(in) :: approach
      type(ellipse_shape_t), intent(in) :: shape
      !> The contact; its half-axes are 0 if the shape is not converged.
      type(ellipse_t), intent(out) :: self

      self%shape = shape
      self%approach = approach
      if (.not. (shape%is_converged .and. approach > 0)) return
      ! the roots one by one: approach over curvature may be beyond all numbers
      self%major = sqrt(approach)/sqrt(a + b)*sqrt((shape%d_along + shape%d_across)/(3*shape%f))
      self%minor = shape%axis_ratio*self%major
      if (.not. self%minor > 0) return
      self%load = 2*pi*modulus*self%major/3*(approach/shape%f)
      self%peak_pressure = modulus*(approach/self%minor)/shape%f
   end subroutine ellipse_of_approach

   !> The ratio k = b/a in (0, 1] of a ratio A/B of curvatures.
   pure subroutine find_axis_ratio(ratio, k, is_converged)
      !> Ratio A/B of the curvatures [-], > 0; 1 and more is that of a circle.
      real(dp), intent(in) :: ratio
      !> Ratio b/a of the half-axes [-], in (0, 1].
      real(dp), intent(out) :: k
      !> Was the ratio of the half-axes found?
      logical, intent(out) :: is_converged
      type(axis_ratio_equation_t) :: equation
      real(dp) :: x

      k = 1
      is_converged = .true.
      if (ratio >= 1) return
      equation%logarithm = log(ratio)
      x = 2*equation%logarithm/3
      ! k > A/B
      call find_root(equation, equation%logarithm, 0.0_dp, .true., x, is_converged, last_step)
      k = exp(x)
   end subroutine find_axis_ratio

   !> See `equation_t`. With D1 = R_D(0, k^2, 1), D2 = R_D(0, 1, k^2), J = (D2 - D1)/(1 - k^2) the slope is
   !> 3 - k^2 J/D1 - J/D2, where J = 3/4 D1 for a circle.
   pure subroutine evaluate(self, x, value, slope)
      class(axis_ratio_equation_t), intent(in) :: self
      !> ln(b/a), < 0.
      real(dp), intent(in) :: x
      !> Value of the equation, 0 at its root.
      real(dp), intent(out) :: value
      !> Derivative of the value with respect to x.
      real(dp), intent(out) :: slope
      real(dp) :: k, d1, d2, j

      k = exp(x)
      d1 = carlson_d(0.0_dp, k*k, 1.0_dp)
      d2 = carlson_d(0.0_dp, 1.0_dp, k*k)
      j = 3*d1/4
      if (1 - k > nearly_round) j = (d2 - d1)/((1 - k)*(1 + k))
      value = log(d1/d2) - self%logarithm
      slope = 3 - k*k*j/d1 - j/d2
   end subroutine evaluate

   !> Pressure at a position along the axes; 0 outside.
   elemental real(dp) function ellipse_pressure(self, x, y)
      type(ellipse_t), intent(in) :: self
      !> Coordinates along the major and the minor axis, from the middle [m].
      real(dp), intent(in) :: x, y
      real(dp) :: r

      ellipse_pressure = 0
      if (.not. self%minor > 0) return
      r = hypot(x/self%major, y/self%minor)
      if (r < 1) ellipse_pressure = self%peak_pressure*sqrt((1 - r)*(1 + r))
   end function ellipse_pressure

   !> Gap at a position along the axes; 0 in contact. With the root t of x^2/(a^2 + t) + y^2/(b^2 + t) = 1,
   !>
   !>     g = (p0 a b/2E*) int_0^t (x^2/(a^2 + w) + y^2/(b^2 + w) - 1) dw/sqrt((a^2 + w)(b^2 + w) w),  w = b^2 sinh^2 s
   elemental real(dp) function ellipse_gap(self, modulus, x, y) result(gap)
      type(ellipse_t), intent(in) :: self
      !> Contact modulus E* [Pa].
      real(dp), intent(in) :: modulus
      !> Coordinates along the major and the minor axis, from the middle [m].
      real(dp), intent(in) :: x, y
      real(dp) :: u, v, k, t, end, s(size(gauss_nodes)), w(size(gauss_nodes)), width
      integer :: i, n

      gap = 0
      if (.not. self%minor > 0) return
      u = x/self%major
      v = y/self%major
      k = self%minor/self%major
      t = outer_root(u, v, k)
      if (.not. t > 0) return
      end = asinh(sqrt(t)/k)
      n = max(1, ceiling(end/panel))
      width = end/n
      do i = 1, n
         s = (i - 0.5_dp + gauss_nodes/2)*width
         w = (k*sinh(s))**2
         ! the bracket, without its difference
         gap = gap + width*sum(gauss_weights/2*k*k*sinh(end - s)*sinh(end + s)/sqrt(1 + w) &
            & *(u*u/((1 + w)*(1 + t)) + v*v/((k*k + w)*(k*k + t))))
      end do
      gap = gap*self%peak_pressure*self%minor/modulus
   end function ellipse_gap

   !> t >= 0 with u^2/(1 + t) + v^2/(k^2 + t) = 1; 0 inside the ellipse.
   elemental real(dp) function outer_root(u, v, k) result(t)
      !> Coordinates of the position along the major and the minor axis, in major half-axes [-].
      real(dp), intent(in) :: u, v
      !> Ratio b/a of the half-axes [-], in (0, 1].
      real(dp), intent(in) :: k
      real(dp) :: h, c, r

      t = 0
      r = hypot(u, v/k)
      if (r <= 1) return
      c = k*k*(r - 1)*(r + 1)
      h = (u*u + v*v - 1 - k*k)/2
      if (h > 0) then
         t = h + sqrt(h*h + c)
      else
         t = c/(sqrt(h*h + c) - h)
      end if
   end function outer_root

   !> Principal stresses [s_xx, s_yy, s_zz] on the axis at a depth z >= 0, from Boussinesq's potentials. With
   !>
   !>     Dx = (2/3) R_D(b^2 + z^2, z^2, a^2 + z^2), Dy = (2/3) R_D(a^2 + z^2, z^2, b^2 + z^2),
   !>     Ix = 2/(ra (ra + rb)), Iy = 2/(rb (ra + rb)), ra^2 = a^2 + z^2, rb^2 = b^2 + z^2,
   !>
   !>     s_xx = (p0 a b/2) [-2 nu z Dz + z Dx - (1 - 2 nu)(Ix - z Dx)],  z (Dx + Dy + Dz) = 2/(ra rb),  s_zz = -p0 a b/(ra rb)
   pure function ellipse_axial_stress(self, poisson_ratio, z) result(stress)
      type(ellipse_t), intent(in) :: self
      !> Poisson's ratio nu [-].
      real(dp), intent(in) :: poisson_ratio
      !> Depth on the axis [m], >= 0.
      real(dp), intent(in) :: z
      real(dp) :: stress(3)
      real(dp) :: k, d, ra, rb, zx, zy, zz

      k = self%minor/self%major
      d = z/self%major
      ra = hypot(1.0_dp, d)
      rb = hypot(k, d)
      zx = 2*d/3*carlson_d(rb*rb, d*d, ra*ra)
      zy = 2*d/3*carlson_d(ra*ra, d*d, rb*rb)
      zz = 2/(ra*rb) - zx - zy
      stress = [zx - 2*poisson_ratio*zz - (1 - 2*poisson_ratio)*(2/(ra*(ra + rb)) - zx), &
         & zy - 2*poisson_ratio*zz - (1 - 2*poisson_ratio)*(2/(rb*(ra + rb)) - zy), -2/(ra*rb)]
      stress = stress*self%peak_pressure*k/2
   end function ellipse_axial_stress

   !> Shear stress at the ends of the major axis, where the surface is pulled along it and pressed as much across it (Johnson 4.28):
   !> (1 - 2 nu) p0 (k/e^2)(artanh(e)/e - 1), e^2 = 1 - k^2, without the difference. For a circle (1 - 2 nu) p0/3.
   pure real(dp) function ellipse_edge_shear(self, poisson_ratio) result(shear)
      type(ellipse_t), intent(in) :: self
      !> Poisson's ratio nu [-].
      real(dp), intent(in) :: poisson_ratio
      real(dp) :: k

      k = self%minor/self%major
      shear = (1 - 2*poisson_ratio)*self%peak_pressure*k/3*carlson_d(k*k, k*k, 1.0_dp)
   end function ellipse_edge_shear

   !> Largest gap or overlap that the pressure leaves within the ellipse, over the approach; 0 but for round-off.
   pure real(dp) function ellipse_misfit(self, a, b, modulus) result(misfit)
      !> Contact whose load, approach, half-axes and shape are compared with each other.
      type(ellipse_t), intent(in) :: self
      !> Curvatures A <= B of the gap [1/m].
      real(dp), intent(in) :: a, b
      !> Contact modulus E* [Pa].
      real(dp), intent(in) :: modulus
      real(dp) :: unit, rise(2)

      misfit = 0
      if (.not. self%minor > 0) return
      associate (k => self%shape%axis_ratio, shape => self%shape)
         unit = 3*self%load/(2*pi*modulus*self%major)
         rise = [a*self%major**2 - unit/3*shape%d_along, b*self%minor**2 - unit/3*k*k*shape%d_across]
         misfit = (maxval(abs(rise)) + abs(self%approach - unit*shape%f))/self%approach
      end associate
   end function ellipse_misfit

end module adfric_plane_hertz_ellipse

! SPDX-License-Identifier: GPL-3.0-or-later
!> Contacts of summits with the principal curvatures k (1 + s) and k (1 - s): area and load over those of a sphere of the
!> curvature k.
!>
!> Hertz's ellipse of the axes a > b has y = (b/a)^2 from R_D(0, y, 1)/R_D(0, 1, y) = (1 - s)/(1 + s) (B. C. Carlson's integrals),
!> and with A = (2/3) R_D(0, y, 1)/(R_F(0, y, 1) (1 - s)) the area sqrt(y) A and the load (pi/2) sqrt(A)/R_F(0, y, 1). The
!> integrals have no cancellation at the circle.
module adfric_rough_summit_shapes
   use adfric_base_constants, only: pi
   use adfric_base_kinds, only: dp
   use adfric_numerics_elliptic, only: carlson_d, carlson_f
   use adfric_numerics_secant_root, only: find_rising_root, rising_equation_t
   implicit none (type, external)
   private
   public :: exact_ellipse, geometric_mean

   !> ln y of a ratio of curvatures.
   type, extends(rising_equation_t) :: ellipse_equation_t
      !> (1 - s)/(1 + s).
      real(dp) :: ratio = 1
   contains
      procedure :: evaluate
   end type ellipse_equation_t

contains

   !> Area and load of the ellipse over those of a sphere of the mean curvature under the same approach.
   pure subroutine exact_ellipse(s, area, load, is_converged)
      !> Difference of the curvatures over their sum, 0 <= s < 1.
      real(dp), intent(in) :: s
      real(dp), intent(out) :: area, load
      logical, intent(out) :: is_converged
      type(ellipse_equation_t) :: equation
      real(dp) :: x, y, half_axis, k

      area = 1
      load = 1
      is_converged = .true.
      if (.not. s > 0) return
      equation%ratio = (1 - s)/(1 + s)
      ! a ratio r of curvatures makes y of the size of r^(4/3), up to a logarithm
      x = 4*log(equation%ratio)/3
      call find_rising_root(equation, 4*x - 1, 0.0_dp, 0.75_dp, epsilon(1.0_dp), x, is_converged)
      y = exp(x)
      k = carlson_f(0.0_dp, y, 1.0_dp)
      half_axis = 2*carlson_d(0.0_dp, y, 1.0_dp)/(3*k*(1 - s))
      area = sqrt(y)*half_axis
      load = pi*sqrt(half_axis)/(2*k)
   end subroutine exact_ellipse

   !> See `rising_equation_t`: the logarithm of the ratio of the integrals less that of the curvatures.
   pure subroutine evaluate(self, x, value)
      class(ellipse_equation_t), intent(in) :: self
      !> ln y.
      real(dp), intent(in) :: x
      real(dp), intent(out) :: value

      value = log(carlson_d(0.0_dp, exp(x), 1.0_dp)/carlson_d(0.0_dp, 1.0_dp, exp(x))/self%ratio)
   end subroutine evaluate

   !> Area and load of a sphere of the curvature sqrt(k1 k2) over those of one of the mean curvature.
   elemental subroutine geometric_mean(s, area, load)
      !> Difference of the curvatures over their sum, 0 <= s < 1.
      real(dp), intent(in) :: s
      real(dp), intent(out) :: area, load

      area = 1/sqrt((1 - s)*(1 + s))
      load = sqrt(area)
   end subroutine geometric_mean

end module adfric_rough_summit_shapes

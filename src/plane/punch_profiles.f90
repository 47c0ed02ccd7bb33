! SPDX-License-Identifier: GPL-3.0-or-later
!> Profiles of rigid punches, and the closed form of the wedge, whose tip is no case for collocation.
module adfric_plane_punch_profiles
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_plane_rigid_punch, only: punch_profile_t
   implicit none (type, external)
   private
   public :: polynomial_t, power_load, wedge_load, wedge_pressure, wedge_gap

   !> z = sum over i of c_i x^(2i); flat without coefficients.
   type, extends(punch_profile_t) :: polynomial_t
      !> c_i >= 0 [m^(1 - 2i)], i = 1 ... 4.
      real(dp) :: c(4) = 0
   contains
      procedure :: height
      procedure :: slope
   end type polynomial_t

contains

   !> See `punch_profile_t`.
   elemental real(dp) function height(self, x)
      class(polynomial_t), intent(in) :: self
      !> Coordinate along the surface, from the middle of the punch [m].
      real(dp), intent(in) :: x

      associate (c => self%c, y => x*x)
         height = y*(c(1) + y*(c(2) + y*(c(3) + y*c(4))))
      end associate
   end function height

   !> See `punch_profile_t`.
   elemental real(dp) function slope(self, x)
      class(polynomial_t), intent(in) :: self
      !> Coordinate along the surface, from the middle of the punch [m].
      real(dp), intent(in) :: x

      associate (c => self%c, y => x*x)
         slope = 2*x*(c(1) + y*(2*c(2) + y*(3*c(3) + 4*y*c(4))))
      end associate
   end function slope

   !> Load of a punch z = c x^(2i) that touches over |x| < a: P = pi i (2i - 1)!!/(2i)!! E* c a^(2i) [N/m].
   pure real(dp) function power_load(modulus, c, i, a)
      !> Contact modulus E* [Pa].
      real(dp), intent(in) :: modulus
      !> Coefficient c of x^(2i) [m^(1 - 2i)].
      real(dp), intent(in) :: c
      !> Half of the power of x, >= 1.
      integer, intent(in) :: i
      !> Half-width a of contact [m], > 0.
      real(dp), intent(in) :: a
      integer :: k

      power_load = pi*i*product([((2*k - 1.0_dp)/(2*k), k=1, i)])*modulus*c*a**(2*i)
   end function power_load

   !> Load of a wedge of slope m that touches over |x| < a: P = E* m a [N/m].
   elemental real(dp) function wedge_load(modulus, slope, a)
      !> Contact modulus E* [Pa].
      real(dp), intent(in) :: modulus
      !> Slope m of the wedge [-], > 0.
      real(dp), intent(in) :: slope
      !> Half-width a of contact [m], > 0.
      real(dp), intent(in) :: a

      wedge_load = modulus*slope*a
   end function wedge_load

   !> Pressure of the wedge, (E* m/pi) arccosh(a/|x|); 0 outside, NaN at the tip, where it is infinite.
   elemental real(dp) function wedge_pressure(modulus, slope, a, x)
      !> Contact modulus E* [Pa].
      real(dp), intent(in) :: modulus
      !> Slope m of the wedge [-], > 0.
      real(dp), intent(in) :: slope
      !> Half-width a of contact [m], > 0.
      real(dp), intent(in) :: a
      !> Coordinate along the surface, from the middle of the punch [m].
      real(dp), intent(in) :: x

      wedge_pressure = 0
      if (abs(x) >= a) return
      wedge_pressure = not_a_number()
      if (.not. abs(x) > 0) return
      wedge_pressure = modulus*slope/pi*asinh(sqrt((a - abs(x))*(a + abs(x)))/abs(x))
   end function wedge_pressure

   !> Gap of the wedge, (2m/pi)(x arccos(a/x) - a arccosh(x/a)); 0 in contact.
   elemental real(dp) function wedge_gap(slope, a, x)
      !> Slope m of the wedge [-], > 0.
      real(dp), intent(in) :: slope
      !> Half-width a of contact [m], > 0.
      real(dp), intent(in) :: a
      !> Coordinate along the surface, from the middle of the punch [m].
      real(dp), intent(in) :: x
      real(dp) :: e

      wedge_gap = 0
      if (abs(x) <= a) return
      e = sqrt((abs(x) - a)*(abs(x) + a))
      wedge_gap = max(0.0_dp, 2*slope/pi*(abs(x)*atan2(e, a) - a*asinh(e/a)))
   end function wedge_gap

end module adfric_plane_punch_profiles

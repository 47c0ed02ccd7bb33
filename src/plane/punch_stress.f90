! SPDX-License-Identifier: GPL-3.0-or-later
!> Stresses in a half-plane under the pressure of a rigid punch.
!>
!> y points into the solid, tension is positive. With lengths in the half-width a, t = x + i y and Cauchy's integral W of the
!> pressure
!>
!>     W = (1/pi) int p(s)/(s - t) ds,  s_xx = -Im W - y Re W', s_yy = -Im W + y Re W', s_xy = y Im W'
!>
!> which is the superposition of Flamant's line loads (`adfric_plane_flamant`). Each part of the pressure has its closed form in
!> z = t - sqrt(t^2 - 1), |z| <= 1, the inverse of Joukowski's map, from
!>
!>     (1/pi) int sqrt(1 - s^2) U_(k-1)(s)/(s - t) ds = -z^k
module adfric_plane_punch_stress
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_plane_rigid_punch, only: punch_contact_t
   implicit none (type, external)
   private
   public :: punch_stress

contains

   !> Stresses [s_xx, s_yy, s_xy] at a position [Pa]; NaN where the pressure is infinite.
   pure function punch_stress(contact, slope, x, y) result(stress)
      type(punch_contact_t), intent(in) :: contact
      !> Slope of a wedge, whose pressure adds to that of the contact; 0 without a wedge [-].
      real(dp), intent(in) :: slope
      !> Coordinates of the position, from the middle of the punch [m], y >= 0.
      real(dp), intent(in) :: x, y
      real(dp) :: stress(3), depth
      complex(dp) :: t, root, z, w, derivative
      logical :: is_edge, is_tip

      associate (a => contact%half_width)
         depth = abs(y/a)
         t = cmplx(x/a, depth, dp)
         ! x - a first: what is near an edge keeps its digits
         root = sqrt(cmplx((x - a)/a, depth, dp))*sqrt(cmplx((x + a)/a, depth, dp))
      end associate
      is_edge = .not. abs(root) > 0
      is_tip = .not. abs(t) > 0
      stress = not_a_number()
      if (is_edge .and. contact%excess > 0 .or. is_tip .and. slope > 0) return
      stress = 0
      ! the bounded pressure ends at an edge, and y W' with it
      if (is_edge) return
      z = 1/(t + root)
      call add_bounded(contact%b, z, root, w, derivative)
      call add_flat(contact%excess/(pi*contact%half_width), t, root, w, derivative)
      if (slope > 0) call add_wedge(contact%modulus*slope, t, root, z, w, derivative)
      stress = [-aimag(w) - depth*real(derivative), -aimag(w) + depth*real(derivative), depth*aimag(derivative)]
   end function punch_stress

   !> Set W and W' of the sum of b_k sin(k th), cos th = s: W = -sum of b_k z^k, by Horner's rule.
   pure subroutine add_bounded(b, z, root, w, derivative)
      !> Coefficients b_k of the bounded pressure [Pa]; shape `(n_terms)`.
      real(dp), intent(in) :: b(:)
      !> Position z = t - sqrt(t^2 - 1), |z| <= 1.
      complex(dp), intent(in) :: z
      !> sqrt(t^2 - 1) of the position.
      complex(dp), intent(in) :: root
      !> Cauchy's integral W of the bounded pressure [Pa].
      complex(dp), intent(out) :: w
      !> Derivative W' with respect to t [Pa].
      complex(dp), intent(out) :: derivative
      integer :: k

      w = 0
      derivative = 0
      do k = size(b), 1, -1
         w = (w - b(k))*z
         derivative = (derivative + k*b(k))*z
      end do
      ! z' = -z/root
      derivative = derivative/root
   end subroutine add_bounded

   !> Add W and W' of c/sqrt(1 - s^2): W = -c/sqrt(t^2 - 1).
   pure subroutine add_flat(c, t, root, w, derivative)
      !> Coefficient c of the pressure [Pa].
      real(dp), intent(in) :: c
      !> Position t = x + i y, in half-widths.
      complex(dp), intent(in) :: t
      !> sqrt(t^2 - 1) of the position.
      complex(dp), intent(in) :: root
      !> Cauchy's integral W, to which this part is added [Pa].
      complex(dp), intent(inout) :: w
      !> Derivative W' with respect to t, to which this part is added [Pa].
      complex(dp), intent(inout) :: derivative

      w = w - c/root
      derivative = derivative + c*(t/root)/root/root
   end subroutine add_flat

   !> Add W and W' of (c/pi) arccosh(1/|s|): W = -(c/pi) arcsin(1/t) = -(2c/pi) arctan z = (i c/pi) ln((sqrt(t^2 - 1) + i)/t). The
   !> last form keeps the digits of t close to the tip.
   pure subroutine add_wedge(c, t, root, z, w, derivative)
      !> Coefficient c of the pressure: E* times the slope [Pa].
      real(dp), intent(in) :: c
      !> Position t = x + i y, in half-widths.
      complex(dp), intent(in) :: t
      !> sqrt(t^2 - 1) of the position.
      complex(dp), intent(in) :: root
      !> Position z = t - sqrt(t^2 - 1), |z| <= 1.
      complex(dp), intent(in) :: z
      !> Cauchy's integral W, to which this part is added [Pa].
      complex(dp), intent(inout) :: w
      !> Derivative W' with respect to t, to which this part is added [Pa].
      complex(dp), intent(inout) :: derivative
      complex(dp), parameter :: i = (0.0_dp, 1.0_dp)

      if (abs(z) < 0.5_dp) then
         w = w - 2*c/pi*atan(z)
      else
         w = w + i*c/pi*log((root + i)/t)
      end if
      derivative = derivative + c/pi/t/root
   end subroutine add_wedge

end module adfric_plane_punch_stress

! SPDX-License-Identifier: GPL-3.0-or-later
!> Pressure and gap of a cylinder that slides over a viscoelastic half-plane, at a position. Units and symbols as in
!> `sliding_cylinder`; y = x - m, R^2 = (1 - y^2)/4.
!>
!> In the contact, with the sums G_i of the shift,
!>
!>     p = 2 R + 2 sum_i e_i G_i int_y^1 e^(-(z-y)/a_i) [1 + z a_i/(4 rho_i)] dz/R
!>
!> In the gap, with |y| = cosh v,
!>
!>     g = (sinh 2v - 2v)/4 + sum_j eta_j [sinh v sign(y) + int_y e^(-(z-y)/b_j) F_j dz]
!>     F_j = |z|/sqrt(z^2 - 1) - 4 rho'_j v(z)/b_j^2
!>
!> up to the trailing edge from behind, and without end ahead, where the integral from the leading edge is 0. Nearer to an edge than
!> b_j the bracket is
!>
!>     sign(y) int [4 rho'_j v(z)/b_j^2 e^((y-z)/b_j) - (e^((y-z)/b_j) - 1) |z|/sqrt(z^2 - 1)] dz
!>
!> between edge and position, whose terms do not cancel however long b_j is.
module adfric_plane_sliding_cylinder_profile
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_numerics_double_exponential, only: integrand_t, integrate
   use adfric_numerics_hyperbolic, only: sinh_minus_argument
   use adfric_plane_sliding_cylinder, only: cylinder_contact_t
   implicit none (type, external)
   private
   public :: sliding_cylinder_pressure, sliding_cylinder_gap, signed_cylinder_pressure, signed_cylinder_gap

   !> Exponent whose decay is nothing.
   real(dp), parameter :: long_path = 45

   !> What a relaxation length adds to the pressure at a position in the contact.
   type, extends(integrand_t) :: cylinder_contact_integrand_t
      !> Path from the trailing edge to the position, 1 + y.
      real(dp) :: from_trailing = 0
      !> What remains from the end of the range to the leading edge.
      real(dp) :: rest = 0
      !> Relaxation length a, a/(4 rho), and 1 - 4 rho/a.
      real(dp) :: length = 1, factor = 0, deficit = 0
   contains
      procedure :: evaluate => contact_term
   end type cylinder_contact_integrand_t

   !> What a retardation length adds to the gap at a position.
   type, extends(integrand_t) :: cylinder_gap_integrand_t
      !> Path from the leading edge to the position, or from the position to the trailing edge.
      real(dp) :: path = 0
      !> 1 ahead of the contact, -1 behind it.
      real(dp) :: side = 1
      !> Does the range lie between edge and position?
      logical :: is_near = .false.
      !> What remains from the end of the range to the trailing edge.
      real(dp) :: rest = 0
      !> Retardation length b, and 4 rho'/b^2.
      real(dp) :: length = 1, factor = 0
   contains
      procedure :: evaluate => gap_term
   end type cylinder_gap_integrand_t

contains

   !> Pressure at x, >= 0: next to an edge round-off may change the sign of its terms.
   pure real(dp) function sliding_cylinder_pressure(contact, x) result(p)
      type(cylinder_contact_t), intent(in) :: contact
      !> Position along the surface, from the lowest point of the cylinder [w].
      real(dp), intent(in) :: x
      real(dp) :: y

      y = x - contact%shift%shift
      p = 0
      if (abs(y) >= 1) return
      p = signed_cylinder_pressure(contact, 1 + y, 1 - y)
      if (.not. ieee_is_nan(p)) p = max(0.0_dp, p)
   end function sliding_cylinder_pressure

   !> Pressure in the contact as its terms give it.
   pure real(dp) function signed_cylinder_pressure(contact, from_trailing, to_leading) result(p)
      type(cylinder_contact_t), intent(in) :: contact
      !> Distances of the position from the edges [w], both > 0; their sum is 2, and the smaller one has all its digits.
      real(dp), intent(in) :: from_trailing, to_leading
      type(cylinder_contact_integrand_t) :: integrand
      real(dp) :: part, range, amplitude
      integer :: i
      logical :: is_converged

      p = sqrt(from_trailing*to_leading)
      integrand%from_trailing = from_trailing
      do i = 1, contact%solid%n_arms
         amplitude = 2*contact%solid%ratios(i)*contact%shift%edge_pressures(i)
         if (.not. abs(amplitude) > 0) cycle
         integrand%length = contact%solid%relaxation(i)
         integrand%factor = integrand%length/(4*contact%rho(i))
         integrand%deficit = contact%deficits(i)
         range = min(to_leading, long_path*integrand%length)
         integrand%rest = to_leading - range
         call integrate(integrand, range, part, is_converged, epsilon(p)/abs(amplitude))
         p = p + amplitude*part
         if (.not. is_converged) p = not_a_number()
      end do
   end function signed_cylinder_pressure

   !> The integrand of the pressure, see `integrand_t`.
   pure real(dp) function contact_term(self, from_left, from_right) result(term)
      class(cylinder_contact_integrand_t), intent(in) :: self
      !> Distance from the position.
      real(dp), intent(in) :: from_left
      !> Distance from the end of the range.
      real(dp), intent(in) :: from_right
      real(dp) :: to_leading, to_trailing

      to_leading = from_right + self%rest
      to_trailing = self%from_trailing + from_left
      ! 1 + z a/(4 rho), which is small at the trailing edge where a is short
      term = (to_trailing - self%deficit)*self%factor
      term = exp(-from_left/self%length)*term*2/sqrt(to_leading*to_trailing)
   end function contact_term

   !> Gap at x, >= 0: next to an edge round-off may change the sign of its terms.
   pure real(dp) function sliding_cylinder_gap(contact, x) result(g)
      type(cylinder_contact_t), intent(in) :: contact
      !> Position along the surface, from the lowest point of the cylinder [w].
      real(dp), intent(in) :: x
      real(dp) :: y

      y = x - contact%shift%shift
      g = 0
      if (abs(y) <= 1) return
      g = signed_cylinder_gap(contact, abs(y) - 1, sign(1.0_dp, y))
      if (.not. ieee_is_nan(g)) g = max(0.0_dp, g)
   end function sliding_cylinder_gap

   !> Gap beside the contact as its terms give it.
   pure real(dp) function signed_cylinder_gap(contact, path, side) result(g)
      type(cylinder_contact_t), intent(in) :: contact
      !> Distance of the position from the nearer edge [w], > 0.
      real(dp), intent(in) :: path
      !> 1 for a position ahead of the contact, -1 for one behind it.
      real(dp), intent(in) :: side
      type(cylinder_gap_integrand_t) :: integrand
      real(dp) :: v, part, range
      integer :: j
      logical :: is_converged

      integrand%path = path
      integrand%side = side
      v = 2*asinh(sqrt(path/2))
      g = sinh_minus_argument(2*v)/4
      do j = 1, contact%solid%n_arms
         integrand%length = contact%solid%retardation(j)
         integrand%factor = 4*contact%gap_rho(j)/integrand%length**2
         integrand%is_near = path <= integrand%length
         range = path
         if (.not. integrand%is_near .and. (side > 0 .or. path > long_path*integrand%length)) range = long_path*integrand%length
         integrand%rest = path - range
         call integrate(integrand, range, part, is_converged)
         if (.not. integrand%is_near) part = part + side*sinh(v)
         g = g + contact%shift%shares(j)*part
         if (.not. is_converged) g = not_a_number()
      end do
   end function signed_cylinder_gap

   !> The integrand of the gap, see `integrand_t`.
   pure real(dp) function gap_term(self, from_left, from_right) result(term)
      class(cylinder_gap_integrand_t), intent(in) :: self
      !> Distance from the position.
      real(dp), intent(in) :: from_left
      !> Distance from the end of the range.
      real(dp), intent(in) :: from_right
      real(dp) :: to_edge, slope, v, half

      to_edge = from_right + self%rest
      if (self%side > 0 .and. .not. self%is_near) to_edge = self%path + from_left
      slope = (1 + to_edge)/sqrt(to_edge*(2 + to_edge))
      v = 2*asinh(sqrt(to_edge/2))
      if (self%is_near) then
         half = self%side*from_left/(2*self%length)
         term = self%side*exp(half)*(self%factor*v*exp(half) - 2*sinh(half)*slope)
      else
         term = exp(-from_left/self%length)*(slope - self%factor*v)
      end if
   end function gap_term

end module adfric_plane_sliding_cylinder_profile

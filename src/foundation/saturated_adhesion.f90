! SPDX-License-Identifier: GPL-3.0-or-later
!> Discrete contact with adhesion over the whole gap (GM 4.2), and discrete contact without adhesion.
!>
!> Contact ends where \( p = -\pi \) and starts where the gap closes. Both conditions are linear in the
!> cosine and sine of the shift s of the contact zone, for a given half width \( \lambda \):
!> $$ \kappa + \Re\{\overline{Z}\,G\,(\cos\lambda + i\sin\lambda\coth(\lambda/u))\} = 0, \qquad
!>    \kappa - \Re\{\overline{Z}\,(-\cos\lambda + i\sin\lambda\coth((\pi-\lambda)/v))\} = 0, $$
!> with \( Z = e^{is} \), G the complex modulus and \( \kappa = m + \pi \) the level. Their sum gives s, and then
!> the level in closed form: one increasing function \( \kappa(\lambda) \) from -1 (touch) to |G| (saturation),
!> the same for every load, adhesion stress and strip. GM's two edge equations are inverted by one scalar root.
module adfric_foundation_saturated_adhesion
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_base_constants, only: pi
   use adfric_numerics_scalar_root, only: equation_t, find_root
   use adfric_foundation_foundation, only: foundation_t
   use adfric_foundation_contact_zone, only: coth_and_slope, get_lag
   implicit none (type, external)
   private
   public :: depth_of_half_width, half_width_of_depth, shift_of_half_width, saturation_level

   !> Half width at a given depth.
   type, extends(equation_t) :: depth_equation_t
      !> Foundation under the strip.
      type(foundation_t) :: foundation
      !> Square root of the depth that is sought.
      real(dp) :: root_depth = 0
   contains
      procedure :: evaluate
   end type depth_equation_t

   !> Closer to saturation than this, round-off may tell that a start is on the wrong side of the half width.
   real(dp), parameter :: closest = 1.0e-8_dp

contains

   !> Level |G| at and above which the contact is saturated (GM 18).
   elemental real(dp) function saturation_level(foundation)
      type(foundation_t), intent(in) :: foundation

      saturation_level = hypot(foundation%storage, foundation%loss)
   end function saturation_level

   !> Shift of the contact zone towards the leading side [rad], in [0, pi).
   elemental real(dp) function shift_of_half_width(foundation, half_width) result(shift)
      type(foundation_t), intent(in) :: foundation
      !> Half width of the contact [rad], in (0, pi).
      real(dp), intent(in) :: half_width
      real(dp) :: coth_u, coth_v, excess

      if (has_asserts) call assert(half_width > 0 .and. half_width < pi, 'shift_of_half_width: 0 < half width < pi')
      associate (u => foundation%u, v => foundation%v)
         call coth_and_slope(half_width/u, coth_u, excess)
         call coth_and_slope((pi - half_width)/v, coth_v, excess)
         shift = atan2(foundation%loss*get_lag(half_width, u, coth_u), &
            & foundation%loss*cos(half_width) + (foundation%storage*coth_u + coth_v)*sin(half_width))
      end associate
   end function shift_of_half_width

   !> Depth \( \kappa + 1 \) of a half width, to full relative precision, and its derivative.
   elemental subroutine depth_of_half_width(foundation, half_width, depth, slope, shift_slope)
      type(foundation_t), intent(in) :: foundation
      real(dp), intent(in) :: half_width
      !> Depth \( \kappa + 1 \) [c], in (0, |G| + 1).
      real(dp), intent(out) :: depth
      !> Derivative of the depth with respect to the half width [c/rad].
      real(dp), intent(out) :: slope
      !> Derivative of the shift with respect to the half width [-].
      real(dp), intent(out), optional :: shift_slope
      real(dp) :: coth_u, coth_v, excess_u, excess_v, s, c, n, d, h, versine, h_less_d, n_slope, d_slope, h_slope, storage_coth

      if (has_asserts) call assert(half_width > 0 .and. half_width < pi, 'depth_of_half_width: 0 < half width < pi')
      associate (u => foundation%u, v => foundation%v, loss => foundation%loss)
         call coth_and_slope(half_width/u, coth_u, excess_u)
         call coth_and_slope((pi - half_width)/v, coth_v, excess_v)
         s = sin(half_width)
         c = cos(half_width)
         versine = merge(1 - c, s*s/(1 + c), c < 0)
         storage_coth = foundation%storage*coth_u + coth_v
         ! tan(shift) = n/d
         n = loss*get_lag(half_width, u, coth_u)
         d = loss*c + storage_coth*s
         h = sqrt(n*n + d*d)
         h_less_d = merge(n*n/(h + abs(d)), h - d, d > 0)
         depth = (n*s*coth_v + d*versine + h_less_d)/h

         n_slope = loss*(c*coth_u + s*(u - excess_u/u))
         d_slope = -loss*s + storage_coth*c + (excess_v/v - foundation%storage*excess_u/u)*s
         h_slope = (n*n_slope + d*d_slope)/h
         slope = (n_slope*s*coth_v + n*(c*coth_v + s*excess_v/v) + d_slope*versine + d*s &
            & + (n*n_slope - h_less_d*d_slope)/h - depth*h_slope)/h
         if (present(shift_slope)) shift_slope = (n_slope*d - n*d_slope)/(h*h)
      end associate
   end subroutine depth_of_half_width

   !> Half width of the contact at a depth.
   pure subroutine half_width_of_depth(foundation, depth, start, half_width, is_converged)
      type(foundation_t), intent(in) :: foundation
      !> Depth \( \kappa + 1 \) [c], in (0, |G| + 1).
      real(dp), intent(in) :: depth
      !> Half width of a neighbouring strip, as a guess, or 0 [rad].
      real(dp), intent(in) :: start
      !> Half width of the contact [rad].
      real(dp), intent(out) :: half_width
      logical, intent(out) :: is_converged
      type(depth_equation_t) :: equation

      if (has_asserts) call assert(depth > 0 .and. depth < saturation_level(foundation) + 1, &
         & 'half_width_of_depth: 0 < depth < |G| + 1')
      equation%foundation = foundation
      equation%root_depth = sqrt(depth)
      half_width = start
      if (half_width <= 0 .or. half_width > pi - closest) then
         half_width = 2*asin(sqrt(min(depth/(saturation_level(foundation) + 1), 1.0_dp)))
      end if
      call find_root(equation, 0.0_dp, pi, .true., half_width, is_converged)
   end subroutine half_width_of_depth

   !> The square root of the depth: proportional to the half width at touch, so Newton's method is at home.
   pure subroutine evaluate(self, x, value, slope)
      !> The foundation, and the root of the depth that is sought.
      class(depth_equation_t), intent(in) :: self
      !> Half width of the contact [rad].
      real(dp), intent(in) :: x
      !> Square root of the depth, less the one that is sought.
      real(dp), intent(out) :: value
      !> Derivative of the value with respect to the half width.
      real(dp), intent(out) :: slope
      real(dp) :: depth

      call depth_of_half_width(self%foundation, x, depth, slope)
      depth = sqrt(max(depth, 0.0_dp))
      value = depth - self%root_depth
      slope = slope/(2*max(depth, sqrt(tiny(depth))))
   end subroutine evaluate

end module adfric_foundation_saturated_adhesion

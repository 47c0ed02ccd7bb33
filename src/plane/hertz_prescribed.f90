! SPDX-License-Identifier: GPL-3.0-or-later
!> What may be prescribed of Hertz's contact in place of its load: the approach, the half-width, or the largest pressure.
!>
!> Each of them grows with the load as a power of it, so that there is one load for each: on a line a ~ p0 ~ P^(1/2), with
!>
!>     P = pi E* a^2/(4 R),  a = 2 R p0/E*
!>
!> and on an ellipse a ~ p0 ~ P^(1/3), delta ~ P^(2/3), with k = b/a, D = R_D(0, k^2, 1) + R_D(0, 1, k^2), and the curvatures A and B
!> of the gap, whose sum `adfric_plane_hertz_ellipse` takes, too,
!>
!>     P = 2 pi E* (A + B) a^3/D,  a = p0 k D/(3 E* (A + B))
module adfric_plane_hertz_prescribed
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_unset, only: is_set
   use adfric_plane_hertz_ellipse, only: ellipse_of_approach, ellipse_of_load, ellipse_shape_t, ellipse_t
   use adfric_plane_hertz_variables, only: in => hertz_input
   use adfric_solid_contact_modulus, only: contact_modulus_of
   implicit none (type, external)
   private
   public :: line_load, prescribed_ellipse

contains

   !> Load of a line per length [N/m].
   pure real(dp) function line_load(values) result(load)
      real(dp), intent(in) :: values(:)
      real(dp) :: half_width, modulus

      load = values(in%load)
      if (is_set(load)) return
      modulus = contact_modulus_of(values(in%contact_modulus:in%second_poisson_ratio))
      half_width = values(in%contact_half_width)
      if (is_set(values(in%peak_pressure))) half_width = 2*values(in%radius)*(values(in%peak_pressure)/modulus)
      load = pi/4*(half_width/values(in%radius))*half_width*modulus
   end function line_load

   !> Ellipse of a case under its load, or with what is prescribed instead.
   pure subroutine prescribed_ellipse(values, a, b, shape, s)
      real(dp), intent(in) :: values(:)
      !> Curvatures A <= B of the gap [1/m].
      real(dp), intent(in) :: a, b
      type(ellipse_shape_t), intent(in) :: shape
      !> The contact; its half-axes are 0 if the shape is not converged.
      type(ellipse_t), intent(out) :: s
      real(dp) :: modulus, load, half_width

      modulus = contact_modulus_of(values(in%contact_modulus:in%second_poisson_ratio))
      if (is_set(values(in%approach))) then
         call ellipse_of_approach(a, b, modulus, values(in%approach), shape, s)
         return
      end if
      load = values(in%load)
      half_width = values(in%contact_half_width)
      if (is_set(values(in%peak_pressure))) half_width = values(in%peak_pressure)/modulus*shape%axis_ratio &
         & *(shape%d_along + shape%d_across)/(3*(a + b))
      if (.not. is_set(load)) load = 2*pi*modulus*half_width*((a + b)*half_width)*(half_width/(shape%d_along + shape%d_across))
      call ellipse_of_load(a, b, modulus, load, shape, s)
   end subroutine prescribed_ellipse

end module adfric_plane_hertz_prescribed

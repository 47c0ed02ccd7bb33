! SPDX-License-Identifier: GPL-3.0-or-later
!> Integral over a contact along a line of a shear stress that goes with the pressure. Nodes lie dense at the edges, where the pressure
!> goes with a root.
module adfric_plane_contact_shear
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi
   use adfric_interface_friction_law, only: friction_law_t
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   implicit none (type, external)
   private
   public :: contact_nodes, contact_weights, integrate_over_contact, integrate_shear, n_contact_nodes

   !> Panels on which a law of the pressure is integrated, and the nodes of all.
   integer, parameter :: n_panels = 4, n_contact_nodes = n_panels*size(gauss_nodes)

contains

   !> Nodes on a contact [m].
   pure function contact_nodes(middle, half_width) result(x)
      !> Middle and half-width of the contact [m].
      real(dp), intent(in) :: middle, half_width
      real(dp) :: x(n_contact_nodes)
      integer :: k

      do k = 1, n_panels
         x((k - 1)*size(gauss_nodes) + 1:k*size(gauss_nodes)) = middle + half_width*sin(angles(k))
      end do
   end function contact_nodes

   !> Weights of the nodes on a contact of half-width 1.
   pure function contact_weights() result(weights)
      real(dp) :: weights(n_contact_nodes)
      integer :: k

      do k = 1, n_panels
         weights((k - 1)*size(gauss_nodes) + 1:k*size(gauss_nodes)) = half_pi/n_panels*gauss_weights*cos(angles(k))
      end do
   end function contact_weights

   !> The nodes of a panel as angles from -pi/2 to pi/2, of which the sines are the positions.
   pure function angles(panel)
      integer, intent(in) :: panel
      real(dp) :: angles(size(gauss_nodes))

      angles = half_pi*(2*panel - 1 + gauss_nodes - n_panels)/n_panels
   end function angles

   !> Shear over the contact.
   pure subroutine integrate_shear(law, speed, temperature, half_width, pressure, shear, slope, is_valid)
      type(friction_law_t), intent(in) :: law
      !> Speed [m/s] and temperature [K].
      real(dp), intent(in) :: speed, temperature
      !> Half-width of the contact, in any unit of length.
      real(dp), intent(in) :: half_width
      !> Pressure at the nodes [Pa]; shape `(n_contact_nodes)`.
      real(dp), intent(in) :: pressure(:)
      !> The shear [Pa unit of length], and its change by ln v.
      real(dp), intent(out) :: shear, slope
      !> Does the law hold at this speed and temperature?
      logical, intent(out) :: is_valid
      real(dp) :: stress, slope_of_stress, weight
      integer :: i, k, n

      shear = 0
      slope = 0
      n = 0
      do k = 1, n_panels
         associate (cosines => cos(angles(k)))
            do i = 1, size(gauss_nodes)
               n = n + 1
               call law%get_stress(speed, pressure(n), temperature, stress, slope_of_stress, is_valid)
               if (.not. is_valid) return
               weight = half_width*half_pi/n_panels*gauss_weights(i)*cosines(i)
               shear = shear + weight*stress
               slope = slope + weight*stress*slope_of_stress
            end do
         end associate
      end do
   end subroutine integrate_shear

   !> Integral over the contact of what is known at the nodes.
   pure real(dp) function integrate_over_contact(half_width, values) result(integral)
      !> Half-width of the contact, in any unit of length.
      real(dp), intent(in) :: half_width
      !> Values at the nodes; shape `(n_contact_nodes)`.
      real(dp), intent(in) :: values(:)
      integer :: k

      integral = 0
      do k = 1, n_panels
         integral = integral + half_width*half_pi/n_panels*sum(gauss_weights*cos(angles(k)) &
            & *values((k - 1)*size(gauss_nodes) + 1:k*size(gauss_nodes)))
      end do
   end function integrate_over_contact

end module adfric_plane_contact_shear

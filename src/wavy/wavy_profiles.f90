!> Pressure, shear stress, displacement and gap over one period of the surface.
module adfric_wavy_profiles
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_wavy_case, only: wavy_case_t
   use adfric_wavy_column, only: get_column
   use adfric_wavy_finite_slope, only: shear_of_pressure
   use adfric_wavy_steady_state, only: find_steady_state
   use adfric_wavy_strip, only: strip_t, steady_state_t, profile
   use adfric_wavy_surface, only: new_surface_strip, share_at
   implicit none (type, external)
   private
   public :: get_profiles

   !> Below this share of the height a strip is flat to every digit.
   real(dp), parameter :: flat = 1.0e-30_dp

contains

   !> Profiles at a penetration, in SI units.
   pure subroutine get_profiles(point, penetration, x, y, profiles)
      type(wavy_case_t), intent(in) :: point
      !> [m]
      real(dp), intent(in) :: penetration
      !> Coordinates along and across the sliding direction, 0 at the crest [m].
      real(dp), intent(in) :: x(:), y(:)
      !> Shape `(size(x), size(y), 4)`: pressure and shear stress [Pa], displacement and gap [m].
      real(dp), intent(out) :: profiles(:, :, :)
      type(strip_t) :: strip
      type(steady_state_t) :: state
      real(dp) :: share, xi, w, p, shear, pressure_unit, length_unit, slope
      integer :: i, j

      do j = 1, size(y)
         share = max(share_at(two_pi*y(j)/point%period), flat)
         call new_surface_strip(point%surface, penetration/point%height, share, strip)
         call find_steady_state(strip, point%surface%branch, state)
         length_unit = point%height*share/2
         pressure_unit = point%pressure_unit*share/2
         slope = two_pi*length_unit/point%period
         do i = 1, size(x)
            xi = two_pi*x(i)/point%period
            call get_column(strip, state, xi, w, p)
            shear = p*slope*sin(xi)
            if (point%surface%steepness > 0) shear = shear_of_pressure(p, xi, slope)
            profiles(i, j, 1) = p*pressure_unit
            profiles(i, j, 2) = shear*pressure_unit
            profiles(i, j, 3) = w*length_unit
            profiles(i, j, 4) = max(w - profile(strip, xi), 0.0_dp)*length_unit
         end do
      end do
   end subroutine get_profiles

end module adfric_wavy_profiles

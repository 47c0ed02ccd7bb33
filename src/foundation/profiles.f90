! SPDX-License-Identifier: GPL-3.0-or-later
!> Pressure, shear stress, displacement and gap over one period of the surface.
module adfric_foundation_profiles
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_base_constants, only: two_pi
   use adfric_foundation_case, only: wavy_case_t
   use adfric_foundation_column, only: get_column
   use adfric_foundation_finite_slope, only: shear_of_pressure
   use adfric_foundation_steady_state, only: find_steady_state
   use adfric_foundation_strip, only: strip_t, steady_state_t, profile
   use adfric_foundation_surface, only: new_surface_strip
   use adfric_foundation_wave_shape, only: share_at
   implicit none (type, external)
   private
   public :: get_profiles

   !> Below this share of the height a strip is flat to every digit.
   real(dp), parameter :: flat = 1.0e-30_dp

contains

   !> Profiles at a penetration, in SI units.
   pure subroutine get_profiles(point, penetration, x, y, profiles)
      !> The point in reduced units, and what these units are in SI units.
      type(wavy_case_t), intent(in) :: point
      !> Penetration of the crests into the undisturbed surface [m].
      real(dp), intent(in) :: penetration
      !> Coordinates along and across the sliding direction, 0 at the crest [m].
      real(dp), intent(in) :: x(:), y(:)
      !> Shape `(size(x), size(y), 4)`: pressure and shear stress [Pa], displacement and gap [m].
      real(dp), intent(out) :: profiles(:, :, :)
      type(steady_state_t) :: state
      real(dp) :: share
      integer :: j, mirror

      if (has_asserts) call assert(all(shape(profiles) == [size(x), size(y), 4]), &
         & 'get_profiles: profiles have the shape of the axes')
      do j = 1, size(y)
         ! the surface is even across its crest line
         mirror = size(y) + 1 - j
         if (mirror < j .and. .not. abs(y(j) + y(mirror)) > 0) then
            profiles(:, j, :) = profiles(:, mirror, :)
         else
            share = max(share_at(two_pi*y(j)/point%period), flat)
            call get_strip_profiles(point, penetration/point%height, x, share, state, profiles(:, j, :))
         end if
      end do
   end subroutine get_profiles

   !> Profiles along one strip.
   pure subroutine get_strip_profiles(point, penetration, x, share, state, profiles)
      type(wavy_case_t), intent(in) :: point
      !> Penetration of the crests into the undisturbed surface [h].
      real(dp), intent(in) :: penetration
      !> Coordinates along the sliding direction, 0 at the crest [m].
      real(dp), intent(in) :: x(:)
      !> Share Y of the height of the strip, in (0, 1].
      real(dp), intent(in) :: share
      !> In: the state of a strip nearby, as a guess. Out: the state of this strip.
      type(steady_state_t), intent(inout) :: state
      !> Pressure and shear stress [Pa], displacement and gap [m]; shape `(size(x), 4)`.
      real(dp), intent(out) :: profiles(:, :)
      type(strip_t) :: strip
      type(steady_state_t) :: guess
      real(dp) :: xi, w, p, shear, pressure_unit, length_unit, slope
      integer :: i

      guess = state
      call new_surface_strip(point%surface, penetration, share, strip)
      call find_steady_state(strip, point%surface%branch, state, guess)
      length_unit = point%height*share/2
      pressure_unit = point%pressure_unit*share/2
      slope = two_pi*length_unit/point%period
      do i = 1, size(x)
         xi = two_pi*x(i)/point%period
         call get_column(strip, state, xi, w, p)
         shear = p*slope*sin(xi)
         if (point%surface%shape%steepness > 0) shear = shear_of_pressure(p, xi, slope)
         profiles(i, 1) = p*pressure_unit
         profiles(i, 2) = shear*pressure_unit
         profiles(i, 3) = w*length_unit
         profiles(i, 4) = max(w - profile(strip, xi), 0.0_dp)*length_unit
      end do
   end subroutine get_strip_profiles

end module adfric_foundation_profiles

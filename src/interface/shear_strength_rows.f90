! SPDX-License-Identifier: GPL-3.0-or-later
!> Friction of what touches: the shear stress in the area of contact is tau0 + alpha p, p the pressure there, whatever the speed.
!>
!> With alpha = 0 it is Bowden and Tabor's: shear strength times real area. Over nominal area it is tau0 a + alpha P, a the share of the
!> area in contact and P what contact carries: the mean pressure, and the tension that adhesion has outside contact. So P needs no
!> pressure in cells. P is below 0 where contact pulls as a whole, by p0 at most; then, too, the stress is not below 0, since alpha p0
!> is at most tau0. Every elastic model of a half-space has its rows of the group `friction` from here.
module adfric_interface_shear_strength_rows
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_describe_rows, only: any_number, contact_profiles
   use adfric_describe_table, only: profile_t, variable_t
   implicit none (type, external)
   private
   public :: set_shear_rows, check_shear, has_shear, get_friction_of_area, shear_profiles, shear_stress
   public :: n_shear_rows, p_shear_stress

   !> Indices among the rows, and their number.
   integer, parameter :: shear_strength = 1, pressure_factor = 2
   integer, parameter :: n_shear_rows = pressure_factor
   !> Index of the shear stress among the profiles, behind those that every contact has.
   integer, parameter :: p_shear_stress = 3

contains

   !> The rows, in the group `friction`.
   subroutine set_shear_rows(rows)
      !> Receives the rows; shape `(n_shear_rows)`.
      type(variable_t), intent(out) :: rows(:)

      rows(shear_strength) = any_number(group='friction', name='shear_strength', unit='Pa', &
         & meaning='tau0 of the shear stress tau0 + alpha p in contact', lower=0.0_dp)
      rows(pressure_factor) = any_number(group='friction', name='pressure_factor', unit='-', &
         & meaning='alpha of the shear stress tau0 + alpha p in contact; 0 if not given', lower=0.0_dp)
   end subroutine set_shear_rows

   !> Is there friction?
   pure logical function has_shear(values)
      !> Values of the rows; shape `(n_shear_rows)`.
      real(dp), intent(in) :: values(:)

      has_shear = any(is_set(values))
   end function has_shear

   !> The profiles of a contact with friction; the last one belongs to cases with friction alone.
   function shear_profiles() result(p)
      type(profile_t) :: p(p_shear_stress)

      p(:p_shear_stress - 1) = contact_profiles()
      p(p_shear_stress) = profile_t(name='shear_stress', unit='Pa', &
         & long_name='shear stress of friction in contact, of a shear strength or in partial slip; 0 outside')
   end function shear_profiles

   !> Shear stress of cells, of values that have been checked, not all of them unset [Pa].
   pure function shear_stress(values, pressure, is_contact) result(stress)
      !> Values of the rows; shape `(n_shear_rows)`.
      real(dp), intent(in) :: values(:)
      !> Pressure, below 0 where adhesion pulls [Pa]; shape `(nx, ny)`.
      real(dp), intent(in) :: pressure(:, :)
      !> Do the surfaces touch? Shape `(nx, ny)`.
      logical, intent(in) :: is_contact(:, :)
      real(dp) :: stress(size(pressure, 1), size(pressure, 2)), factor

      factor = 0
      if (is_set(values(pressure_factor))) factor = values(pressure_factor)
      ! at an edge that pulls by tau0/alpha the sum is rounded
      stress = merge(max(values(shear_strength) + factor*pressure, 0.0_dp), 0.0_dp, is_contact)
   end function shear_stress

   !> Add to `problems` what is missing, and a shear stress that would be below 0.
   subroutine check_shear(rows, values, tension, problems)
      !> The rows; their names are part of the messages.
      type(variable_t), intent(in) :: rows(:)
      !> Values of the rows; shape `(n_shear_rows)`.
      real(dp), intent(in) :: values(:)
      !> Largest tension in contact, that of adhesion [Pa].
      real(dp), intent(in) :: tension
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      if (.not. is_set(values(pressure_factor))) return
      if (.not. is_set(values(shear_strength))) then
         call problems%add(rows(shear_strength)%group, rows(shear_strength)%name, 'is missing [Pa]; pressure_factor needs it')
      else if (values(pressure_factor)*tension > values(shear_strength)) then
         call problems%add(rows(pressure_factor)%group, rows(pressure_factor)%name, 'times the stress of adhesion is above ' &
            & //'shear_strength: where that stress pulls at the edge of contact, the shear stress would be below 0')
      end if
   end subroutine check_shear

   !> Friction over nominal area, of values that have been checked.
   pure subroutine get_friction_of_area(values, area, mean_pressure, tension, stress, coefficient)
      !> Values of the rows; shape `(n_shear_rows)`.
      real(dp), intent(in) :: values(:)
      !> Share of the nominal area in contact [-].
      real(dp), intent(in) :: area
      !> Load over nominal area [Pa].
      real(dp), intent(in) :: mean_pressure
      !> Tension of adhesion outside contact, over nominal area [Pa].
      real(dp), intent(in) :: tension
      !> Receives the friction force over nominal area [Pa], and that over the load; neither has a value without the group, the latter
      !> none without a load that presses.
      real(dp), intent(inout) :: stress, coefficient

      if (.not. has_shear(values)) return
      stress = 0
      ! the sum of load and tension is rounded, and no friction without contact
      if (area > 0) then
         stress = values(shear_strength)*area
         if (is_set(values(pressure_factor))) stress = max(stress + values(pressure_factor)*(mean_pressure + tension), 0.0_dp)
      end if
      if (mean_pressure > 0) coefficient = stress/mean_pressure
   end subroutine get_friction_of_area

end module adfric_interface_shear_strength_rows

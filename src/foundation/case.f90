! SPDX-License-Identifier: GPL-3.0-or-later
!> One point of the model `wavy_sliding`: from the values of a namelist to reduced units.
module adfric_foundation_case
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_base_unset, only: is_set, unset
   use adfric_interface_adhesion_rows, only: range_of
   use adfric_foundation_adhesion, only: adhesion_t, acting_adhesion
   use adfric_foundation_foundation, only: new_foundation
   use adfric_foundation_surface, only: surface_t
   use adfric_foundation_variables, only: in => foundation_input
   implicit none (type, external)
   private
   public :: wavy_case_t, resolve_case, dugdale_of, kind_2d, kind_3d, kind_profile, kind_cosines, kind_map

   !> Positions of the words in the choice of the surface.
   integer, parameter :: kind_2d = 1, kind_3d = 2, kind_profile = 3, kind_cosines = 4, kind_map = 5
   integer, parameter :: slope_finite = 2

   !> A point in reduced units, and the units.
   type :: wavy_case_t
      !> The surface on its foundation, in reduced units.
      type(surface_t) :: surface
      !> Adhesion as it is given, its stress in h/K and its range in h; the surface has that which acts.
      type(adhesion_t) :: given
      !> Is the load given? Else the penetration is.
      logical :: is_load_given = .false.
      !> Does nothing relax and nothing adhere, so that friction and losses are 0?
      logical :: is_elastic = .false.
      !> Is the pull-off load asked for? There is none without adhesion.
      logical :: wants_pull_off = .false.
      !> Load [h/K per period] or penetration [h].
      real(dp) :: load = 0, penetration = 0
      !> Units: period [m], height [m], pressure h/K [Pa], load [N/m or N], friction [N/m or N], area [m or m^2].
      real(dp) :: period = 1, height = 1, pressure_unit = 1, load_unit = 1, friction_unit = 1, area_unit = 1
   end type wavy_case_t

contains

   !> Stress, work and range of Dugdale's law, with the stress where work and range stand for it.
   pure function dugdale_of(values) result(law)
      !> Values of all variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      real(dp) :: law(in%range - in%stress + 1)

      law = values(in%stress:in%range)
      if (is_set(law(1)) .or. .not. all(is_set(law(2:)))) return
      law(1) = law(2)/law(3)
      law(3) = unset
   end function dugdale_of

   !> The point that the values describe; they have been checked.
   pure subroutine resolve_case(values, self)
      !> Values of all variables in SI units, in the order of `adfric_foundation_variables`; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> The point in reduced units, and what these units are in SI units.
      type(wavy_case_t), intent(out) :: self
      real(dp) :: stiffness, law(in%range - in%stress + 1)

      self%period = values(in%period)
      self%height = values(in%height)
      stiffness = values(in%stiffness)
      if (.not. is_set(stiffness)) stiffness = values(in%young_modulus) &
         & /((1 - values(in%poisson_ratio)**2)*values(in%thickness))
      self%pressure_unit = stiffness*self%height
      self%load_unit = self%pressure_unit*self%period
      self%friction_unit = self%pressure_unit*self%height
      self%area_unit = self%period

      associate (surface => self%surface)
         surface%shape%is_3d = nint(values(in%kind)) == kind_3d
         if (surface%shape%is_3d) then
            self%load_unit = self%load_unit*self%period
            self%friction_unit = self%friction_unit*self%period
            self%area_unit = self%area_unit*self%period
         end if
         call new_foundation(surface%foundation, &
            & two_pi*(values(in%velocity)*values(in%relaxation_time)/self%period), values(in%retardation_ratio))
         if (is_set(values(in%edge))) self%given%edge = nint(values(in%edge))
         surface%branch = nint(values(in%branch))
         if (nint(values(in%slope)) == slope_finite) surface%shape%steepness = two_pi*self%height/self%period
         surface%tolerance = values(in%relative_tolerance)
         surface%n_strips = nint(values(in%strips))
         law = dugdale_of(values)
         if (is_set(law(1))) then
            if (law(1) > 0) then
               self%given%stress = law(1)/self%pressure_unit
               self%given%range = range_of(law)/self%height
            end if
         end if
         surface%adhesion = acting_adhesion(self%given, surface%foundation%beta)
      end associate

      self%is_elastic = .not. (values(in%velocity) > 0 .and. values(in%retardation_ratio) > 1) &
         & .and. .not. self%surface%adhesion%stress > 0
      self%is_load_given = .not. is_set(values(in%penetration))
      if (is_set(values(in%load))) then
         self%load = values(in%load)/self%load_unit
      else if (is_set(values(in%mean_pressure))) then
         self%load = values(in%mean_pressure)/self%pressure_unit
      else
         self%penetration = values(in%penetration)/self%height
      end if
      self%wants_pull_off = self%is_load_given
      if (is_set(values(in%pull_off))) self%wants_pull_off = values(in%pull_off) > 0
      self%wants_pull_off = self%wants_pull_off .and. self%surface%adhesion%stress > 0
   end subroutine resolve_case

end module adfric_foundation_case

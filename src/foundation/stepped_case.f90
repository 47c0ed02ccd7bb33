! SPDX-License-Identifier: GPL-3.0-or-later
!> One point of `wavy_sliding` on heights or with a spectrum: from the values of a namelist to rows that a column steps along.
module adfric_foundation_stepped_case
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_base_unset, only: is_set
   use adfric_interface_adhesion_rows, only: range_of
   use adfric_interface_attraction, only: attraction_t, attraction_of_table, attraction_of_two, law_dugdale, law_table
   use adfric_solid_given_spectrum, only: fit_given_curve
   use adfric_solid_master_curve, only: master_curve_fit_t
   use adfric_solid_prony, only: prony_t, new_prony
   use adfric_solid_shift_rows, only: time_temperature_of
   use adfric_solid_time_temperature, only: time_temperature_t
   use adfric_shape_closing, only: closed_length
   use adfric_shape_height_line, only: cubic_pieces, linear_pieces
   use adfric_shape_periodic_heights, only: preparation_t
   use adfric_foundation_adhesion, only: edge_continuous, edge_instantaneous
   use adfric_foundation_case, only: dugdale_of, kind_2d, kind_3d, kind_cosines, kind_map, kind_profile
   use adfric_foundation_given_surface, only: given_surface_t
   use adfric_foundation_stepping_relief, only: relief_t, new_wave_relief, new_measured_relief
   use adfric_foundation_variables, only: in => foundation_input
   implicit none (type, external)
   private
   public :: stepped_case_t, is_stepped, has_other_law, get_attraction, has_heights, &
      & resolve_stepped, get_relief, get_spectrum, spacing_of, strip_spacing_of, &
      & size_of_period, samples_of, period_of, shape_positions, foundation_positions

   !> Position of the word in the choice of the interpolation.
   integer, parameter :: choice_linear = 1
   !> Variables that change the rows, and the spectrum, of a surface.
   integer, parameter :: shape_positions(*) = [in%kind, in%period, in%height, in%spacing, in%strip_spacing, in%interpolation, &
      & in%detrend, &
      & in%periodise, in%blend_share, in%shortest_wavelength, in%reverse]
   integer, parameter :: foundation_positions(*) = [in%stiffness, in%young_modulus, in%poisson_ratio, in%thickness, &
      & in%relaxation_time, &
      & in%retardation_ratio, in%relaxed_modulus, in%terms_per_decade]

   !> A point in reduced units, and the units.
   type :: stepped_case_t
      !> Periods that pass in a second, with the times as they are at the temperature [1/s].
      real(dp) :: pace = 0
      !> Adhesion stress [k0 h] and range [h]; edge rule and branch.
      real(dp) :: stress = 0, range = 0
      !> Another law than Dugdale's, in the same units; not allocated without one.
      type(attraction_t), allocatable :: attraction
      !> Edge rule, one of `edge_...`.
      integer :: edge = edge_continuous
      !> Is the branch the one that loading meets?
      logical :: is_approach = .false.
      !> Does nothing relax and nothing adhere, so that friction and losses are 0?
      logical :: is_elastic = .false.
      !> Is the load given? Else the penetration is.
      logical :: is_load_given = .false.
      !> Load [k0 h] or penetration [h].
      real(dp) :: load = 0, penetration = 0
      !> Units: period [m], height [m], pressure k0 h [Pa], load and friction [N/m or N], area [m or m^2].
      real(dp) :: period = 1, height = 1, pressure_unit = 1, load_unit = 1, friction_unit = 1, area_unit = 1
   end type stepped_case_t

contains

   !> Are heights or a spectrum given, for which a column is stepped? Else the surface is a wave on a standard solid.
   pure logical function is_stepped(values)
      !> Values of all variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      is_stepped = is_set(values(in%relaxation_times)) .or. is_set(values(in%master_curve))
      if (has_other_law(values)) is_stepped = .true.
      if (is_set(values(in%kind))) is_stepped = is_stepped .or. nint(values(in%kind)) >= kind_profile
   end function is_stepped

   !> Is there another law of attraction than Dugdale's?
   pure logical function has_other_law(values)
      real(dp), intent(in) :: values(:)

      has_other_law = .false.
      if (is_set(values(in%law))) has_other_law = nint(values(in%law)) /= law_dugdale
   end function has_other_law

   !> Another law of attraction than Dugdale's, in SI units; not allocated where numbers of it are missing.
   pure subroutine get_attraction(values, given, attraction)
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given
      type(attraction_t), allocatable, intent(out) :: attraction

      if (.not. has_other_law(values)) return
      if (nint(values(in%law)) == law_table) then
         if (allocated(given%attraction%table)) then
            allocate (attraction)
            attraction = attraction_of_table(given%attraction%table(:, 1), given%attraction%table(:, 2))
         end if
      else if (count(is_set(values(in%stress:in%range))) >= 2) then
         allocate (attraction)
         attraction = attraction_of_two(nint(values(in%law)), values(in%stress), values(in%surface_energy), values(in%range))
      end if
   end subroutine get_attraction

   !> Is the surface one of measured heights?
   pure logical function has_heights(values)
      real(dp), intent(in) :: values(:)

      has_heights = nint(values(in%kind)) == kind_profile .or. nint(values(in%kind)) == kind_map
   end function has_heights

   !> Distance of samples along x [m]; unset if it is not given.
   pure real(dp) function spacing_of(values, given) result(spacing)
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given

      spacing = values(in%spacing)
      if (.not. is_set(spacing)) spacing = given%dx
   end function spacing_of

   !> Distance of the rows of a map [m]; unset if it is not given.
   pure real(dp) function strip_spacing_of(values, given) result(spacing)
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given

      spacing = values(in%strip_spacing)
      if (.not. is_set(spacing)) spacing = given%dy
   end function strip_spacing_of

   !> Length of one period, after the ends of heights have been brought together [m].
   pure real(dp) function period_of(values, given) result(period)
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given

      if (has_heights(values)) then
         period = samples_of(values, given)*spacing_of(values, given)
      else
         period = values(in%period)
      end if
   end function period_of

   !> Number of samples of one period, after the ends of heights have been brought together.
   pure integer function samples_of(values, given) result(n)
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given
      type(preparation_t) :: preparation

      preparation = preparation_of(values)
      n = closed_length(size(given%heights, 1), preparation%closing, preparation%share)
   end function samples_of

   !> What makes one period of measured heights.
   pure type(preparation_t) function preparation_of(values) result(preparation)
      real(dp), intent(in) :: values(:)

      if (is_set(values(in%detrend))) preparation%trend = nint(values(in%detrend))
      if (is_set(values(in%periodise))) preparation%closing = nint(values(in%periodise))
      if (is_set(values(in%blend_share))) preparation%share = values(in%blend_share)
      if (is_set(values(in%shortest_wavelength))) preparation%shortest_wavelength = values(in%shortest_wavelength)
   end function preparation_of

   !> The rows of the surface.
   subroutine get_relief(values, given, is_coarse, relief, error)
      !> Values of all variables, which have been checked; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given
      logical, intent(in) :: is_coarse
      !> Receives the rows; lengths in m.
      type(relief_t), intent(out) :: relief
      type(error_t), allocatable, intent(out) :: error
      logical :: is_reversed

      is_reversed = word_of(values(in%reverse), 0) > 0
      select case (nint(values(in%kind)))
      case (kind_2d)
         call new_wave_relief(relief, [values(in%height)/2], [0.0_dp], .false.)
         relief%period = values(in%period)
      case (kind_cosines)
         call new_wave_relief(relief, given%amplitudes, given%phases, is_reversed)
         relief%period = values(in%period)
      case default
         call new_measured_relief(relief, given%heights, spacing_of(values, given), preparation_of(values), &
            & merge(linear_pieces, cubic_pieces, word_of(values(in%interpolation), 0) == choice_linear), is_reversed, &
            & is_coarse, error)
      end select
   end subroutine get_relief

   !> Position of a word, or a default where none is given.
   pure integer function word_of(value, default)
      !> Value of the variable.
      real(dp), intent(in) :: value
      !> What it is where it is not given.
      integer, intent(in) :: default

      word_of = default
      if (is_set(value)) word_of = nint(value)
   end function word_of

   !> Relaxed stiffness and arms of the foundation.
   pure subroutine get_spectrum(values, given, prony, fit)
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given
      !> Receives the spectrum [Pa/m, s].
      type(prony_t), intent(out) :: prony
      !> Receives the fit of a master curve, if one is given.
      type(master_curve_fit_t), intent(out) :: fit
      real(dp) :: per_modulus, relaxed

      per_modulus = 1
      if (is_set(values(in%thickness))) per_modulus = 1/((1 - values(in%poisson_ratio)**2)*values(in%thickness))
      if (is_set(values(in%master_curve))) then
         call fit_given_curve(given, values(in%relaxed_modulus), values(in%terms_per_decade), fit)
         call new_prony(prony, fit%prony%relaxed*per_modulus, fit%prony%moduli*per_modulus, fit%prony%times)
         return
      end if
      relaxed = values(in%stiffness)
      if (.not. is_set(relaxed)) relaxed = values(in%young_modulus)*per_modulus
      if (.not. is_set(values(in%relaxation_times))) then
         call new_prony(prony, relaxed, [(values(in%retardation_ratio) - 1)*relaxed], [values(in%relaxation_time)])
      else if (is_set(values(in%moduli))) then
         call new_prony(prony, relaxed, given%moduli, given%relaxation_times)
      else
         call new_prony(prony, relaxed, given%young_moduli*per_modulus, given%relaxation_times)
      end if
   end subroutine get_spectrum

   !> Length of a period, of waves and heights over x and y its area [m, m^2]. Heights that are blended are shorter than their samples,
   !> mirrored ones twice as long.
   pure real(dp) function size_of_period(values, given) result(size_of)
      !> Values of all variables in SI units; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given

      if (is_set(values(in%period))) then
         size_of = values(in%period)
         if (nint(values(in%kind)) == kind_3d) size_of = size_of**2
      else
         size_of = period_of(values, given)
         if (nint(values(in%kind)) == kind_map) size_of = size_of*strip_spacing_of(values, given)*size(given%heights, 2)
      end if
   end function size_of_period

   !> The point that the values describe; they have been checked.
   pure subroutine resolve_stepped(values, given, relief, prony, self)
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given
      type(relief_t), intent(in) :: relief
      !> The spectrum [Pa/m, s].
      type(prony_t), intent(in) :: prony
      type(stepped_case_t), intent(out) :: self
      type(time_temperature_t) :: law
      type(attraction_t), allocatable :: attraction
      real(dp) :: shift, dugdale(in%range - in%stress + 1)
      logical :: is_valid

      self%period = relief%period
      self%height = relief%height
      if (is_set(values(in%height_factor))) self%height = self%height*values(in%height_factor)
      self%pressure_unit = prony%relaxed*self%height
      self%load_unit = self%pressure_unit*self%period
      self%friction_unit = self%pressure_unit*self%height
      self%area_unit = self%period
      if (nint(values(in%kind)) == kind_map) then
         associate (width => strip_spacing_of(values, given)*size(relief%rows))
            self%load_unit = self%load_unit*width
            self%friction_unit = self%friction_unit*width
            self%area_unit = self%area_unit*width
         end associate
      end if
      law = time_temperature_of(values(in%shift:in%activation_energy), given%master_temperature)
      shift = 1
      if (is_set(values(in%temperature))) call law%get_shift_factor(values(in%temperature), shift, is_valid)
      self%pace = values(in%velocity)*shift/self%period
      if (is_set(values(in%time_factor))) self%pace = self%pace*values(in%time_factor)
      self%edge = merge(edge_continuous, edge_instantaneous, size(prony%times) <= 1)
      if (is_set(values(in%edge))) self%edge = nint(values(in%edge))
      self%is_approach = nint(values(in%branch)) == 2
      dugdale = dugdale_of(values)
      if (has_other_law(values)) then
         call get_attraction(values, given, attraction)
         if (allocated(attraction)) then
            allocate (self%attraction)
            self%attraction = attraction%in_units(self%pressure_unit, self%height)
            self%stress = self%attraction%stress
            self%range = self%attraction%range
         end if
      else if (is_set(dugdale(1))) then
         if (dugdale(1) > 0) then
            self%stress = dugdale(1)/self%pressure_unit
            self%range = range_of(dugdale)
            self%range = self%range/self%height
         end if
      end if
      self%is_elastic = .not. (self%pace > 0 .and. any(prony%moduli > 0)) .and. .not. self%stress > 0
      self%is_load_given = .not. is_set(values(in%penetration))
      if (is_set(values(in%load))) self%load = values(in%load)/self%load_unit
      if (is_set(values(in%mean_pressure))) self%load = values(in%mean_pressure)/self%pressure_unit
      if (.not. self%is_load_given) self%penetration = values(in%penetration)/self%height
   end subroutine resolve_stepped

end module adfric_foundation_stepped_case

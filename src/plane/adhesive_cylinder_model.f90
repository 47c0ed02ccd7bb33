! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `adhesive_cylinder`: a rigid cylinder that slides steadily over a viscoelastic half-plane, which pulls at it up to a
!> range.
module adfric_plane_adhesive_cylinder_model
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_interface_friction_law_rows, only: has_interface
   use adfric_interface_shear_strength_rows, only: n_shear_rows, p_shear_stress, shear_profiles
   use adfric_interface_total_friction, only: doubt_coupling
   use adfric_plane_adhesive_cylinder_check, only: check_adhesive_cylinder
   use adfric_plane_adhesive_cylinder_interface, only: add_adhesive_cylinder_interface, adhesive_cylinder_tractions
   use adfric_plane_adhesive_cylinder_point, only: adhesive_cylinder_point_t, derive_adhesive_cylinder, &
      & get_adhesive_cylinder_profiles, solve_adhesive_cylinder
   use adfric_plane_adhesive_cylinder_variables, only: get_adhesive_cylinder_results, get_adhesive_cylinder_variables, &
      & in => adhesive_cylinder_input, out => adhesive_cylinder_output
   use adfric_plane_viscoelastic_model, only: viscoelastic_model_t
   use adfric_solid_spectrum_rows, only: derive_spectrum, describe_spectrum, poisson_ratio_of
   use adfric_describe_derived, only: derived_t
   use adfric_describe_doubt, only: doubt_contact_too_wide
   use adfric_describe_pointwise, only: point_state_t
   use adfric_describe_status, only: status_not_converged, status_solved
   use adfric_describe_table, only: profile_axis_t
   implicit none (type, external)
   private
   public :: adhesive_cylinder_t, new_adhesive_cylinder

   !> The model.
   type, extends(viscoelastic_model_t) :: adhesive_cylinder_t
   contains
      procedure :: check_case
      procedure :: derive_quantities
      procedure :: describe_case
      procedure :: describe_doubts
      procedure :: measure
      procedure :: solve_point
      procedure :: count_profiles
      procedure :: fill_profiles
   end type adhesive_cylinder_t

contains

   !> The model with its tables.
   subroutine new_adhesive_cylinder(self)
      !> The new model; receives its tables.
      type(adhesive_cylinder_t), intent(out) :: self

      call self%set_tables(name='adhesive_cylinder', summary='a cylinder sliding on a viscoelastic solid that adheres to it', &
         & variables=get_adhesive_cylinder_variables(), results=get_adhesive_cylinder_results(), profiles=shear_profiles(), &
         & axes='x', is_depth=.false.)
      self%first_material = in%material(1)
      self%first_law = in%friction(n_shear_rows + 1)
   end subroutine new_adhesive_cylinder

   !> See `halfspace_model_t`.
   subroutine check_case(self, values, problems)
      class(adhesive_cylinder_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      call check_adhesive_cylinder(self%variables, values, self%given, self%given_law, problems)
   end subroutine check_case

   !> See `model_t`.
   function derive_quantities(self, values) result(list)
      class(adhesive_cylinder_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(derived_t), allocatable :: list(:)

      call derive_spectrum(list, values(in%material(1):in%temperature), self%given)
      call derive_adhesive_cylinder(list, values, self%given)
   end function derive_quantities

   !> See `model_t`.
   function describe_case(self, values) result(text)
      class(adhesive_cylinder_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text

      text = describe_spectrum(values(in%material(1):in%temperature), self%given)
   end function describe_case

   !> See `model_t`.
   function describe_doubts(self, values) result(text)
      class(adhesive_cylinder_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text

      text = ''
      if (has_interface(values(in%friction))) text = doubt_coupling(poisson_ratio_of(values(in%material(1):in%temperature)))
      associate (unused => self)
      end associate
   end function describe_doubts

   !> See `model_t`: the slope at the edge of contact that is further out.
   subroutine measure(self, values, results, measures)
      class(adhesive_cylinder_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Results of the point, NaN where they are not known; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> In: all `not_measured`. Out: with what is measured; shape `(n_doubts)`.
      real(dp), intent(inout) :: measures(:)

      if (.not. ieee_is_nan(results(out%half_width))) measures(doubt_contact_too_wide) = (results(out%half_width) &
         & + abs(results(out%contact_shift)))/values(in%radius)
      associate (unused => self)
      end associate
   end subroutine measure

   !> See `pointwise_model_t`.
   subroutine solve_point(self, values, state, results, error_estimate, status, counts)
      class(adhesive_cylinder_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> What the point before has left: branches at its velocity.
      class(point_state_t), allocatable, intent(inout) :: state
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Estimated relative error of the main result [-].
      real(dp), intent(out) :: error_estimate
      !> Status of the point, one of `status_...`.
      integer, intent(out) :: status
      !> These models count nothing; size 0.
      real(dp), intent(inout) :: counts(:)
      logical :: is_valid

      status = status_not_converged
      error_estimate = 0
      if (.not. allocated(state)) allocate (adhesive_cylinder_point_t :: state)
      select type (state)
      type is (adhesive_cylinder_point_t)
         call solve_adhesive_cylinder(values, self%given, state, results, error_estimate, status)
         if (status == status_solved .and. has_interface(values(in%friction))) then
            call add_adhesive_cylinder_interface(values, self%given, self%given_law, state, results, is_valid)
            if (.not. is_valid) status = status_not_converged
         end if
      end select
      associate (unused => counts)
      end associate
   end subroutine solve_point

   !> See `model_t`: the shear stress belongs to friction.
   pure integer function count_profiles(self, values)
      class(adhesive_cylinder_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      count_profiles = merge(p_shear_stress, p_shear_stress - 1, has_interface(values(in%friction)))
      associate (unused => self)
      end associate
   end function count_profiles

   !> See `pointwise_model_t`: pressure and gap, and with friction the shear stress.
   subroutine fill_profiles(self, values, results, state, axes, profiles)
      class(adhesive_cylinder_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> What `solve_block` found for this point, not used here.
      real(dp), intent(in) :: results(:)
      !> The state of the point.
      class(point_state_t), allocatable, intent(in) :: state
      !> Axes of the profiles, the slowest first.
      type(profile_axis_t), intent(in) :: axes(:)
      !> In: all NaN. Out: profiles of the point; shape `(n_fast, n_slow, n_profiles)`.
      real(dp), intent(inout) :: profiles(:, :, :)

      select type (state)
      type is (adhesive_cylinder_point_t)
         call get_adhesive_cylinder_profiles(state, axes(1)%coordinates, profiles(:, 1, 1), profiles(:, 1, 2))
      end select
      if (size(profiles, 3) == p_shear_stress) profiles(:, 1, p_shear_stress) = adhesive_cylinder_tractions(values, self%given, &
         & self%given_law, profiles(:, 1, 1), .not. profiles(:, 1, 2) > 0)
      associate (unused_results => results)
      end associate
   end subroutine fill_profiles

end module adfric_plane_adhesive_cylinder_model

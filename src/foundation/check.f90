! SPDX-License-Identifier: GPL-3.0-or-later
!> What is missing, contradictory or impossible in an input of the model `wavy_sliding`.
module adfric_foundation_check
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_interface_adhesion_rows, only: check_stress
   use adfric_describe_check, only: checks_t, new_checks
   use adfric_describe_table, only: variable_t
   use adfric_foundation_case, only: dugdale_of, wavy_case_t, resolve_case
   use adfric_foundation_stepped_check, only: check_load_values, require_modulus, require_single_time
   use adfric_foundation_variables, only: in => foundation_input
   implicit none (type, external)
   private
   public :: check_wavy_values

   !> What belongs to heights and spectra.
   integer, parameter :: of_stepping(*) = [in%heights, in%spacing, in%strip_spacing, in%amplitudes, in%phases, in%interpolation, &
      & in%detrend, in%periodise, in%blend_share, in%shortest_wavelength, in%reverse, in%height_factor, in%moduli, &
      & in%young_moduli, in%relaxed_modulus, in%terms_per_decade, in%time_factor, in%shift, in%reference_temperature, in%wlf_c1, &
      & in%wlf_c2, in%activation_energy, in%temperature]

contains

   !> Add to `problems` what is wrong with the values together.
   subroutine check_wavy_values(variables, values, is_swept, problems)
      !> Table of the variables; their names stand in the messages.
      type(variable_t), intent(in), target :: variables(:)
      !> Values in the order of `variables`, `unset` where none is given; shape `(n_variables)`.
      real(dp), intent(in), target :: values(:)
      logical, intent(in), target :: is_swept(:)
      type(problems_t), intent(inout), target :: problems
      type(checks_t) :: c
      integer :: before

      before = problems%count()
      call new_checks(c, variables, values, problems, is_swept)
      call c%need([in%kind, in%period, in%height])
      call check_foundation()
      call check_stress(variables(in%stress:in%range), dugdale_of(values), problems)
      call c%refuse([in%tension_table], 'has no meaning without law = ''table''')
      call c%need([in%velocity])
      call check_load_values(c)
      call c%refuse(of_stepping, &
         & 'belongs to heights, cosines or a spectrum (relaxation_times or master_curve), which are not given')
      if (values(in%profiles) > 0) then
         call c%add(in%profiles, 'need one period, which is swept; sweep another variable or switch profiles off', &
            & is_swept(in%period))
         call c%add(in%profiles, 'need one axis, and its samples are swept; sweep another variable or switch profiles off', &
            & any(is_swept([in%n_x, in%n_y])))
      end if
      if (problems%count() == before) call check_reduced()

   contains

      !> Foundation: a stiffness or a layer, and both times of the solid.
      subroutine check_foundation()
         logical :: has_layer(3)
         integer, parameter :: layer(3) = [in%young_modulus, in%poisson_ratio, in%thickness]

         has_layer = is_set(values(layer))
         if (c%has(in%stiffness) .and. any(has_layer)) then
            call c%add(in%stiffness, 'stands beside '//variables(layer(findloc(has_layer, .true., 1)))%name// &
               & '; give stiffness, or young_modulus, poisson_ratio and thickness')
         else if (.not. c%has(in%stiffness)) then
            call require_modulus(c)
         end if
         call require_single_time(c)
      end subroutine check_foundation

      !> Values that are possible one by one, and beyond all numbers together.
      subroutine check_reduced()
         type(wavy_case_t) :: resolved
         real(dp), parameter :: largest = 1.0e100_dp

         call resolve_case(values, resolved)
         associate (given => resolved%given)
            if (.not. resolved%surface%foundation%v < largest) call c%add(in%velocity, &
               & 'times relaxation_time and retardation_ratio is too large for the period')
            if (.not. max(given%stress, given%range) < largest) call c%add(in%stress, &
               & 'or its range is too large for this height and stiffness')
            if (.not. max(abs(resolved%load), abs(resolved%penetration)) < largest) call c%add(merge(in%load, &
               & in%penetration, resolved%is_load_given), 'is too large for this height and stiffness')
         end associate
      end subroutine check_reduced

   end subroutine check_wavy_values

end module adfric_foundation_check

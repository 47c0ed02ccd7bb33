! SPDX-License-Identifier: GPL-3.0-or-later
!> What is missing, contradictory or impossible in an input of `surface_sliding`.
module adfric_periodic_sliding_check
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_interface_attraction_rows, only: check_attraction, given_attraction_t, has_attraction, has_wall_at_contact, &
      & largest_tension
   use adfric_interface_friction_law_rows, only: given_law_t, n_interface_rows
   use adfric_interface_heat_rows, only: has_heat
   use adfric_interface_shear_coupling, only: check_coupling, is_coupled
   use adfric_solid_given_spectrum, only: given_spectrum_t
   use adfric_solid_spectrum_rows, only: check_spectrum, poisson_ratio_of, n_spectrum_rows, needs_velocity
   use adfric_describe_check, only: require, refuse_given, refuse_swept
   use adfric_describe_table, only: variable_t
   use adfric_periodic_given_heights, only: given_heights_t
   use adfric_periodic_sliding_case, only: is_direction, poisson_ratio_of_solid, speed_of
   use adfric_periodic_sliding_interface, only: check_surface_interface, without_temperature
   use adfric_periodic_sliding_variables, only: attraction_values, base_frictionless, cells_of, kind_heights, kind_wave_2d, &
      & s_adhesion, s_base, s_coupling, s_friction, s_heat, s_last_heat, s_law, s_poisson_ratio, s_tension_table, &
      & s_thickness, s_velocity, in => sliding_input
   use adfric_periodic_variables, only: is_wanted, prescribed => periodic_input
   implicit none (type, external)
   private
   public :: check_pull, check_sliding_surface, check_sliding_solid

   !> Most cells along a period of waves along x and y.
   integer, parameter :: most_cells_2d = 8192
   !> Least thickness of a layer, in periods: below it pressure hardly spreads, and numbers leave their range.
   real(dp), parameter :: thinnest = 1.0e-6_dp
   !> Velocities above it are no velocities [m/s].
   real(dp), parameter :: fastest = 1.0e60_dp

contains

   !> Add to `problems` what is wrong with the surface, its motion and its cells.
   subroutine check_sliding_surface(variables, values, heights, is_swept, has_profiles, problems)
      !> Table of the variables; their names stand in the messages.
      type(variable_t), intent(in) :: variables(:)
      !> Values in the order of `variables`; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(given_heights_t), intent(in) :: heights
      logical, intent(in) :: is_swept(:), has_profiles
      type(problems_t), intent(inout) :: problems

      call require(variables, values, [in%kind], problems)
      if (.not. is_set(values(in%kind))) return
      if (nint(values(in%kind)) == kind_heights) then
         call heights%check(variables(in%heights:in%rms_height), values(in%heights:in%rms_height), problems)
         call refuse_given(variables, values, is_swept, [in%period, in%amplitude, in%cells], 'has no meaning beside heights', &
            & problems)
      else
         call require(variables, values, [in%period, in%amplitude], problems)
         call refuse_given(variables, values, is_swept, [in%heights, in%length_x, in%length_y, in%rms_height], &
            & 'has no meaning for waves', problems)
         if (nint(values(in%kind)) == kind_wave_2d .and. cells_of(values) > most_cells_2d) &
            & call add(in%cells, 'is more than 8192, the most for wave_2d')
      end if
      if (nint(values(in%kind)) == kind_heights .and. .not. is_direction(values(in%direction), .true.)) &
         & call add(in%direction, 'is no multiple of 90 degrees')
      if (.not. is_direction(values(in%direction), .false.) .and. nint(values(in%kind)) /= kind_heights) &
         & call add(in%direction, 'is no multiple of 45 degrees')
      if (is_swept(in%direction)) call add(in%direction, 'is swept; a run has one direction')
      if (has_profiles) call refuse_swept(variables, is_swept, [in%period, in%cells, in%length_x, in%length_y], problems)

   contains

      !> Add a problem of one variable to the list.
      subroutine add(v, text)
         !> Index of the variable in the table, one of `v_...`.
         integer, intent(in) :: v
         !> What is wrong with the variable; its name is put before this.
         character(*), intent(in) :: text

         call problems%add(variables(v)%group, variables(v)%name, text)
      end subroutine add

   end subroutine check_sliding_surface

   !> Add to `problems` what is wrong with material, layer and velocity.
   subroutine check_sliding_solid(rows, values, length, spectrum, given_law, given_attraction, is_swept, problems)
      !> Rows of the solid; their names stand in the messages.
      type(variable_t), intent(in) :: rows(:)
      !> Values of the rows; shape `(n_solid_rows)`.
      real(dp), intent(in) :: values(:)
      !> Period along x [m], or unset.
      real(dp), intent(in) :: length
      type(given_spectrum_t), intent(in) :: spectrum
      type(given_law_t), intent(in) :: given_law
      !> Table of the law of attraction.
      type(given_attraction_t), intent(in) :: given_attraction
      !> Is the variable swept? Shape `(n_solid_rows)`.
      logical, intent(in) :: is_swept(:)
      type(problems_t), intent(inout) :: problems
      integer :: before

      before = problems%count()
      associate (of_solid => without_temperature(values, spectrum), needs => merge(.false., is_swept, &
         & abs(without_temperature(values, spectrum) - values) > 0))
         call check_spectrum(rows(:n_spectrum_rows), of_solid(:n_spectrum_rows), spectrum, needs(:n_spectrum_rows), problems)
      end associate
      call require(rows, values, [s_velocity], problems, needs_velocity)
      call check_attraction(rows(s_adhesion:s_tension_table), attraction_values(values), given_attraction, problems)
      if (.not. has_wall_at_contact(attraction_values(values))) call problems%add(rows(s_law)%group, rows(s_law)%name, &
         & 'is ''lennard_jones'', which has no wall; a body that slides is solved with laws that only pull')
      if (problems%count() == before) then
         if (.not. speed_of(values, spectrum) <= fastest) call problems%add(rows(s_velocity)%group, rows(s_velocity)%name, &
            & 'times the factor of the relaxation times is too large')
      end if
      if (problems%count() == before) call check_surface_interface(rows, values, spectrum, given_law, &
         & largest_tension(attraction_values(values), given_attraction), problems)
      call check_layer(rows, values, length, is_swept, problems)
      if (problems%count() == before) call check_coupled(rows, values, problems)
   end subroutine check_sliding_solid

   !> Add to `problems` what does not go with a contact that the shear stress moves.
   subroutine check_coupled(rows, values, problems)
      !> Rows of the solid; their names stand in the messages.
      type(variable_t), intent(in) :: rows(:)
      !> Values of the rows; shape `(n_solid_rows)`.
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems

      associate (row => rows(s_coupling))
         call check_coupling(row, values(s_coupling), values(s_friction:s_friction + n_interface_rows - 1), &
            & poisson_ratio_of_solid(values), .true., problems)
         if (.not. is_coupled(values(s_coupling))) return
         if (has_attraction(attraction_values(values))) call problems%add(row%group, row%name, &
            & 'stands beside adhesion, with which the contact is that of frictionless faces')
         if (has_heat(values(s_heat:s_last_heat))) call problems%add(row%group, row%name, &
            & 'stands beside &heat, with which the contact is that of frictionless faces')
         if (.not. is_set(values(s_base))) return
         if (nint(values(s_base)) == base_frictionless) call problems%add(row%group, row%name, &
            & 'stands beside base = ''frictionless'', which cannot carry the shear stress')
      end associate
   end subroutine check_coupled

   !> Add to `problems` a load that nothing pulls, and switches of adhesion.
   subroutine check_pull(variables, values, before_prescribed, switches, problems)
      !> Table of the variables; their names stand in the messages.
      type(variable_t), intent(in) :: variables(:)
      !> Values in the order of `variables`; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Index of the row before those of what is prescribed.
      integer, intent(in) :: before_prescribed
      !> Indices of the switches of the pull-off and of the other branch.
      integer, intent(in) :: switches(:)
      type(problems_t), intent(inout) :: problems
      integer :: k

      associate (load => before_prescribed + prescribed%mean_pressure)
         if (values(load) < 0) call problems%add(variables(load)%group, variables(load)%name, &
            & 'is below 0, but nothing pulls without &adhesion')
      end associate
      do k = 1, size(switches)
         associate (row => variables(switches(k)))
            if (is_wanted(values(switches(k)))) call problems%add(row%group, row%name, 'has no meaning without &adhesion')
         end associate
      end do
   end subroutine check_pull

   !> Add to `problems` what is wrong with the layer.
   subroutine check_layer(rows, values, length, is_swept, problems)
      !> Rows of the solid; their names stand in the messages.
      type(variable_t), intent(in) :: rows(:)
      !> Values of the rows; shape `(n_solid_rows)`.
      real(dp), intent(in) :: values(:)
      !> Period along x [m], or unset.
      real(dp), intent(in) :: length
      !> Is the variable swept? Shape `(n_solid_rows)`.
      logical, intent(in) :: is_swept(:)
      type(problems_t), intent(inout) :: problems

      if (.not. any(is_set(values([s_thickness, s_base, s_poisson_ratio])))) return
      call require(rows, values, [s_thickness, s_base], problems)
      if (is_set(values(s_thickness)) .and. is_set(length)) then
         if (values(s_thickness) < thinnest*length) call add(s_thickness, 'is less than 1e-6 of the period along x')
      end if
      if (.not. is_set(values(s_base))) return
      if (nint(values(s_base)) == base_frictionless) then
         call refuse_given(rows, values, is_swept, [s_poisson_ratio], 'has no meaning for base = ''frictionless''', problems)
         return
      end if
      associate (of_material => poisson_ratio_of(values(:n_spectrum_rows)), of_layer => values(s_poisson_ratio))
         if (.not. is_set(of_material) .and. .not. is_set(of_layer)) then
            call add(s_poisson_ratio, 'is missing [-]; a bonded layer needs it')
         else if (is_set(of_material) .and. is_set(of_layer)) then
            call add(s_poisson_ratio, 'stands beside that of &material; give one of them')
         end if
      end associate

   contains

      !> Add a problem of one row to the list.
      subroutine add(index, text)
         !> Index of the variable among the rows, one of `s_...`.
         integer, intent(in) :: index
         !> What is wrong with the variable; its name is put before this.
         character(*), intent(in) :: text

         call problems%add(rows(index)%group, rows(index)%name, text)
      end subroutine add

   end subroutine check_layer

end module adfric_periodic_sliding_check

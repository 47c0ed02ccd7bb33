! SPDX-License-Identifier: GPL-3.0-or-later
!> What the models of a periodic surface on an elastic half-space or layer share, with or without adhesion; a model says what its
!> surface is.
!> The file is long by its answers to `periodic_model_t`.
module adfric_periodic_elastic_model
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: newline
   use adfric_base_unset, only: is_set, unset
   use adfric_interface_adhesion_rows, only: adhesion_law_t, n_adhesion_rows, set_adhesion_rows
   use adfric_interface_attraction_rows, only: check_attraction, given_attraction_t, has_attraction, has_wall_at_contact, &
      & largest_tension, n_attraction_rows, resolve_attraction, set_attraction_rows
   use adfric_solid_contact_modulus, only: check_contact_modulus, contact_modulus_of, derive_contact_modulus, &
      & has_poisson_ratio, n_one_body, n_two_bodies, set_modulus_rows
   use adfric_interface_conduction_rows, only: check_conduction, conductances, has_conduction, n_conduction_results, &
      & n_conduction_rows, refuse_conduction, set_conduction_rows
   use adfric_interface_coulomb_rows, only: along_x, check_coulomb, coulomb_t, has_coulomb, n_coulomb_rows, needs_poisson_ratio, &
      & resolve_coulomb, set_coulomb_rows
   use adfric_interface_friction_law_rows, only: given_law_t, take_law_attribute, take_law_table
   use adfric_interface_shear_strength_rows, only: has_shear, n_shear_rows, p_shear_stress, set_shear_rows, &
      & shear_profiles
   use adfric_interface_total_friction, only: doubt_coupling
   use adfric_describe_derived, only: derived_t
   use adfric_describe_pointwise, only: point_state_t
   use adfric_describe_rows, only: positive
   use adfric_describe_table, only: profile_axis_t, variable_t
   use adfric_periodic_adhesion_cells, only: adhesion_fraction_of, are_sizes_possible, cells_per_zone, derive_zone, doubt_zone, &
      & error_of_edge, error_of_pull_off, regime_of, sees_pull_off, tension_outside
   use adfric_periodic_adhesive_solver, only: adhesion_in_units
   use adfric_periodic_attracted_surface, only: attraction_in_units
   use adfric_periodic_area, only: relative_error_of
   use adfric_periodic_depth_stresses, only: fill_stress_maps, store_stresses
   use adfric_periodic_elastic_interface, only: check_elastic_friction, has_law, n_friction_rows, n_motion_rows, &
      & has_friction, set_motion_rows, store_friction, store_left_out, tractions_of_friction
   use adfric_periodic_hardness_rows, only: check_turn, has_hardness, hardness_row, n_hardness_results, plastic_profile, &
      & resolve_hardness, store_impressions
   use adfric_periodic_layer_kernel, only: layer_kernel_t
   use adfric_periodic_layer_rows, only: check_layer_rows, get_layer, has_layer, n_layer_rows, needs_ratio_of_layer, &
      & numbers_of_layer, set_layer_rows
   use adfric_periodic_model, only: periodic_model_t
   use adfric_periodic_point, only: periodic_surface_t, periodic_solid_t, periodic_goal_t
   use adfric_periodic_slip, only: periodic_slip_t
   use adfric_periodic_solver, only: periodic_solution_t
   use adfric_periodic_stress_rows, only: check_stresses, has_depth, n_stress_profiles, n_stress_results, n_stress_rows, &
      & set_stress_rows, stress_profiles, wants_stresses
   use adfric_periodic_chords, only: chord_fraction, level_fraction
   use adfric_periodic_variables, only: get_elastic_results, is_wanted, n_elastic_solid, pull_off_row, &
      & stiffness_row, in => periodic_input, out => periodic_output
   implicit none (type, external)
   private
   public :: elastic_model_t, punch_values

   !> Rows of adhesion, with those of its law.
   integer, parameter :: n_law_of_adhesion = n_adhesion_rows + n_attraction_rows
   !> Rows of conduction, and behind them the switch of the stiffness; the hardness follows.
   integer, parameter :: n_punch_rows = n_conduction_rows + 1
   !> Index of the depth of impressions among the profiles.
   integer, parameter :: p_plastic_depth = p_shear_stress + 1

   !> The models of surfaces on an elastic half-space.
   type, abstract, extends(periodic_model_t) :: elastic_model_t
      !> Table of a law of friction.
      type(given_law_t) :: given_law
      !> Table and map of an attraction.
      type(given_attraction_t) :: given_attraction
   contains
      procedure :: take_dataset
      procedure :: take_attribute
      procedure, non_overridable :: take_law => take_dataset
      procedure(height_of_i), deferred :: height_of
      procedure :: set_elastic_tables
      procedure :: check_solid
      procedure, non_overridable :: check_elastic_solid => check_solid
      procedure :: set_solid
      procedure :: derive_solid
      procedure :: set_interface
      procedure :: finish_point
      procedure :: store_slip
      procedure :: store_depth
      procedure :: count_profiles
      procedure :: fill_profiles
      procedure :: describe_doubts
      procedure :: doubt_interface
      procedure, private :: adhesion_of
   end type elastic_model_t

   abstract interface

      !> Range of the undeformed gap [m].
      pure real(dp) function height_of_i(self, values)
         import :: elastic_model_t, dp
         implicit none (type, external)
         !> The model whose surface it is.
         class(elastic_model_t), intent(in) :: self
         !> Values of the variables, in the order of the table; shape `(n_variables)`.
         real(dp), intent(in) :: values(:)
      end function height_of_i

   end interface

contains

   !> Set the tables of the model.
   subroutine set_elastic_tables(self, name, summary, surface)
      class(elastic_model_t), intent(inout) :: self
      !> Name of the model in `&job model = ...`.
      character(*), intent(in) :: name
      !> What the model is, in one line for `adfric help`.
      character(*), intent(in) :: summary
      !> Variables of the surface.
      type(variable_t), intent(in) :: surface(:)
      type(variable_t) :: solid(n_elastic_solid)

      call set_modulus_rows(positive(group='solid', name='contact_modulus', unit='Pa', meaning=''), solid(:n_two_bodies))
      call set_adhesion_rows(solid(n_two_bodies + 1:n_two_bodies + n_adhesion_rows))
      call set_attraction_rows(solid(n_two_bodies + n_adhesion_rows + 1:n_two_bodies + n_law_of_adhesion))
      associate (before => n_two_bodies + n_law_of_adhesion)
         call set_conduction_rows(solid(before + 1:before + n_conduction_rows))
         solid(before + n_punch_rows) = stiffness_row()
         call set_stress_rows(solid(before + n_punch_rows + 1:before + n_punch_rows + n_stress_rows))
         associate (last => before + n_punch_rows + n_stress_rows)
            solid(last + 1) = hardness_row()
            call set_coulomb_rows(solid(last + 2:last + 1 + n_coulomb_rows))
         end associate
      end associate
      call set_layer_rows(solid(n_elastic_solid - n_layer_rows + 1:))
      associate (pull_off => n_elastic_solid - n_layer_rows - n_motion_rows)
         call set_shear_rows(solid(pull_off - n_shear_rows:pull_off - 1))
         solid(pull_off) = pull_off_row()
         call set_motion_rows(solid(pull_off + 1:pull_off + n_motion_rows))
      end associate
      call self%set_tables(name, summary, surface, solid, .true.)
      deallocate (self%results)
      allocate (self%results, source=get_elastic_results())
      deallocate (self%profiles)
      allocate (self%profiles(p_plastic_depth + n_stress_profiles))
      self%profiles(:p_shear_stress) = shear_profiles()
      self%profiles(p_plastic_depth) = plastic_profile()
      self%profiles(p_plastic_depth + 1:) = stress_profiles()
   end subroutine set_elastic_tables

   !> Index of the switch of the pull-off.
   pure integer function pull_off_index(self)
      class(elastic_model_t), intent(in) :: self

      pull_off_index = self%last_of_solid - n_layer_rows - n_motion_rows
   end function pull_off_index

   !> Values of the rows of the interface and its motion.
   pure function friction_values(self, values) result(friction)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      real(dp) :: friction(n_friction_rows)

      friction = values(pull_off_index(self) - n_shear_rows:pull_off_index(self) + n_motion_rows)
   end function friction_values

   !> Values of the rows of the layer.
   pure function layer_values(self, values) result(layer)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      real(dp) :: layer(n_layer_rows)

      layer = values(self%last_of_solid - n_layer_rows + 1:self%last_of_solid)
   end function layer_values

   !> Values of the rows of conduction, and that of the switch of the stiffness.
   pure function punch_values(self, values) result(punch)
      !> The model.
      class(elastic_model_t), intent(in) :: self
      !> Values of its variables.
      real(dp), intent(in) :: values(:)
      real(dp) :: punch(n_punch_rows)

      associate (before => self%first_of_solid + n_two_bodies + n_law_of_adhesion - 1)
         punch = values(before + 1:before + n_punch_rows)
      end associate
   end function punch_values

   !> Index before the rows of the stresses in depth.
   pure integer function before_stresses(self)
      class(elastic_model_t), intent(in) :: self

      before_stresses = self%first_of_solid + n_two_bodies + n_law_of_adhesion + n_punch_rows - 1
   end function before_stresses

   !> Values of the rows of the stresses in depth.
   pure function stress_values(self, values) result(stresses)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      real(dp) :: stresses(n_stress_rows)

      stresses = values(before_stresses(self) + 1:before_stresses(self) + n_stress_rows)
   end function stress_values

   !> Hardness [Pa]; unset where the solid does not yield.
   pure real(dp) function hardness_of(self, values) result(hardness)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)

      hardness = values(self%first_of_solid + n_two_bodies + n_law_of_adhesion + n_punch_rows + n_stress_rows)
   end function hardness_of

   !> Index of the mean pressure of a turn.
   pure integer function turn_index(self)
      class(elastic_model_t), intent(in) :: self

      turn_index = self%first_of_solid + n_two_bodies + n_adhesion_rows - 1
   end function turn_index

   !> Values of the rows of the modulus.
   pure function moduli_values(self, values) result(moduli)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      real(dp) :: moduli(n_two_bodies)

      moduli = values(self%first_of_solid:self%first_of_solid + n_two_bodies - 1)
   end function moduli_values

   !> Poisson's ratio of the half-space below a rigid body [-]; unset where it is not known, or both bodies are elastic.
   pure real(dp) function poisson_ratio_of(self, values) result(ratio)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)

      ! the last row of one body, and behind it the modulus of the other one
      associate (rows => values(self%first_of_solid + n_one_body - 1:self%first_of_solid + n_one_body))
         ratio = merge(unset, rows(1), is_set(rows(2)))
      end associate
   end function poisson_ratio_of

   !> See `model_t`: the table of a law of friction, and those of an attraction. A model that has other datasets calls it, too.
   subroutine take_dataset(self, index, values, problems)
      class(elastic_model_t), intent(inout) :: self
      !> Index of the dataset in `variables`.
      integer, intent(in) :: index
      !> Its values; shape `(n, n_columns)`.
      real(dp), intent(in) :: values(:, :)
      !> Receives what is wrong with the values; nothing here.
      type(problems_t), intent(inout) :: problems

      call take_law_table(self%given_law, index - pull_off_index(self), values)
      call self%given_attraction%take(index - (self%first_of_solid + n_two_bodies + n_adhesion_rows - 1), values)
      associate (unused => problems)
      end associate
   end subroutine take_dataset

   !> See `model_t`: the temperature of the table.
   subroutine take_attribute(self, index, name, value, problems)
      class(elastic_model_t), intent(inout) :: self
      !> Index of the dataset in `variables`.
      integer, intent(in) :: index
      !> Name of the attribute.
      character(*), intent(in) :: name
      !> Its value in SI units.
      real(dp), intent(in) :: value
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      call take_law_attribute(self%given_law, self%variables(index), index - pull_off_index(self), name, value, problems)
   end subroutine take_attribute

   !> See `periodic_model_t`.
   subroutine check_solid(self, values, is_swept, problems)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Is the variable swept? Not asked here; shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      type(problems_t), intent(inout) :: problems
      integer :: n_before

      call check_friction(self, values, problems)
      associate (first => self%first_of_solid, last => self%first_of_solid + n_two_bodies - 1, prescribed => self%before_prescribed)
         call check_contact_modulus(self%variables(first:last), values(first:last), problems, &
            & has_coulomb(coulomb_values(self, values)) .or. needs_ratio_of_layer(layer_values(self, values)) &
            & .or. wants_stresses(stress_values(self, values)))
         n_before = problems%count()
         associate (adhesion => adhesion_values(self, values))
            ! a solid that yields may have turned without adhesion
            call check_attraction(self%variables(last + 1:last + n_law_of_adhesion), &
               & merge(unset, adhesion, has_hardness(hardness_of(self, values)) .and. is_turn(self, last, size(adhesion))), &
               & self%given_attraction, problems)
         end associate
         call check_hardness(self, values, problems)
         ! a stress that is missing is told once
         if (problems%count() == n_before .and. .not. has_attraction(adhesion_values(self, values))) then
            if (values(prescribed + in%mean_pressure) < 0) call problems%add('operating', 'mean_pressure', &
               & 'is below 0, but nothing pulls without &adhesion')
            if (is_wanted(values(pull_off_index(self)))) &
               & call problems%add('output', 'pull_off', 'has no meaning without &adhesion')
         end if
      end associate
      call check_law(self, values, problems)
      call check_layer(self, values, problems)
      call check_punch(self, values, problems)
      call check_stresses(self%variables(before_stresses(self) + 1:before_stresses(self) + n_stress_rows), &
         & stress_values(self, values), has_poisson_ratio(moduli_values(self, values)), has_layer(layer_values(self, values)), &
         & has_attraction(adhesion_values(self, values)), has_friction(friction_values(self, values)), problems)
      if (problems%count() > 0) return
      if (lacks_poisson_ratio(self, values)) call problems%add('solid', 'poisson_ratio', &
         & 'is missing [-]; the tangential displacement needs it')
      if (.not. is_possible(self, values)) call problems%add('adhesion', 'stress', 'or its range is too small or too large ' &
         & //'for the surface: stress/(E* height/period) and range/height are 1e-12 to 1e12')
      associate (unused => is_swept)
      end associate
   end subroutine check_solid

   !> Add to `problems` friction of a contact without an edge, and a map that is not one of the cells.
   subroutine check_law(self, values, problems)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      type(periodic_surface_t) :: surface

      if (problems%count() > 0) return
      if (.not. has_wall_at_contact(adhesion_values(self, values)) .and. has_friction(friction_values(self, values))) &
         & call problems%add('adhesion', 'law', 'is ''lennard_jones'', by which contact has no edge, beside a shear stress; '// &
         & 'other laws have an edge')
      if (.not. allocated(self%given_attraction%map)) return
      call self%get_cells(values, surface)
      if (surface%is_quarter) then
         call problems%add('adhesion', 'work_map', 'is for surfaces of given heights; a wave is solved on a quarter of its period')
      else if (any(shape(self%given_attraction%map) /= surface%n_cells)) then
         call problems%add('adhesion', 'work_map', 'does not have the cells of the surface')
      end if
   end subroutine check_law

   !> Which of the values of adhesion is that of the turn?
   pure function is_turn(self, last, n)
      class(elastic_model_t), intent(in) :: self
      !> Index of the row before them, and their number.
      integer, intent(in) :: last, n
      logical :: is_turn(n)

      is_turn = .false.
      is_turn(turn_index(self) - last) = .true.
   end function is_turn

   !> Add to `problems` what a solid that yields cannot have beside it.
   subroutine check_hardness(self, values, problems)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems

      associate (hardness => hardness_of(self, values), prescribed => self%before_prescribed, turn => turn_index(self))
         if (.not. has_hardness(hardness)) return
         call check_turn(self%variables(turn), values(turn), values(prescribed + in%mean_pressure), problems)
         if (has_attraction(adhesion_values(self, values))) call refuse('stands beside &adhesion, which is solved on '// &
            & 'elastic solids')
         if (has_layer(layer_values(self, values))) call refuse('stands beside a layer or coating, where rounds of yielding may ' &
            & //'go too far')
         if (has_coulomb(coulomb_values(self, values))) call refuse('stands beside a coefficient of friction, whose slip is ' &
            & //'solved on elastic solids')
         if (is_set(values(prescribed + in%penetration))) call refuse('stands beside penetration; what has yielded is certain ' &
            & //'under a mean_pressure')
         if (wants_stresses(stress_values(self, values))) call refuse('stands beside stresses in depth, which are those of an '// &
            & 'elastic solid')
      end associate

   contains

      !> Add a problem of the hardness.
      subroutine refuse(reason)
         !> What follows its name.
         character(*), intent(in) :: reason

         call problems%add('solid', 'hardness', reason)
      end subroutine refuse

   end subroutine check_hardness

   !> Add to `problems` what is wrong with the layer, and what it cannot have beside it.
   subroutine check_layer(self, values, problems)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      type(periodic_surface_t) :: surface

      if (problems%count() > 0) return
      call self%get_cells(values, surface)
      associate (first => self%first_of_solid, last => self%last_of_solid)
         call check_layer_rows(self%variables(last - n_layer_rows + 1:last), layer_values(self, values), &
            & self%variables(first:first + n_two_bodies - 1), moduli_values(self, values), surface%period(1), problems)
      end associate
      if (.not. has_layer(layer_values(self, values))) return
      if (has_coulomb(coulomb_values(self, values))) call problems%add('friction', 'coefficient', &
         & 'stands beside a layer, whose tangential displacement is not solved')
      if (.not. has_wall_at_contact(adhesion_values(self, values))) call problems%add('adhesion', 'law', &
         & 'is ''lennard_jones'' beside a layer, where a law without a wall has no bounds; other laws have')
      if (is_wanted(values(pull_off_index(self)))) call problems%add('output', 'pull_off', &
         & 'is not found on layers and coatings; rounds that find no state there do not prove that there is none')
   end subroutine check_layer

   !> Add to `problems` what is wrong with conduction and stiffness, and what they cannot stand beside.
   subroutine check_punch(self, values, problems)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems

      associate (first => self%first_of_solid + n_two_bodies + n_law_of_adhesion, punch => punch_values(self, values))
         associate (rows => self%variables(first:first + n_conduction_rows - 1))
            call check_conduction(rows, punch, problems)
            if (problems%count() > 0) return
            if (has_layer(layer_values(self, values))) call refuse_conduction(rows, punch, 'stands beside a layer, in which a ' &
               & //'current does not spread as an indentation does', problems)
            if (.not. has_wall_at_contact(adhesion_values(self, values))) call refuse_conduction(rows, punch, &
               & 'stands beside the law ''lennard_jones'', by which contact has no edge', problems)
         end associate
         if (is_wanted(punch(n_punch_rows)) .and. has_attraction(adhesion_values(self, values))) call problems%add('output', &
            & 'stiffness', 'stands beside &adhesion, whose edge moves with the approach; differences of two loads have its slope')
      end associate
   end subroutine check_punch

   !> Add to `problems` what is wrong with the friction, of either kind.
   subroutine check_friction(self, values, problems)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      logical :: is_adhesive

      is_adhesive = has_attraction(adhesion_values(self, values))
      associate (first => pull_off_index(self) - n_shear_rows, last => pull_off_index(self) - 1)
         call check_elastic_friction(self%variables(first:last + 1 + n_motion_rows), friction_values(self, values), &
            & self%given_law, largest_tension(adhesion_values(self, values), self%given_attraction), problems)
         call check_coulomb(self%variables(first - n_coulomb_rows:first - 1), values(first - n_coulomb_rows:first - 1), &
            & is_adhesive, has_shear(values(first:last)) .or. has_law(friction_values(self, values)), problems)
      end associate
   end subroutine check_friction

   !> Values of the rows of adhesion and of its law.
   pure function adhesion_values(self, values) result(adhesion)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      real(dp) :: adhesion(n_law_of_adhesion)

      associate (before => self%first_of_solid + n_two_bodies - 1)
         adhesion = values(before + 1:before + n_law_of_adhesion)
      end associate
   end function adhesion_values

   !> Values of the rows of Coulomb's friction.
   pure function coulomb_values(self, values) result(friction)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      real(dp) :: friction(n_coulomb_rows)

      associate (last => pull_off_index(self) - n_shear_rows - 1)
         friction = values(last - n_coulomb_rows + 1:last)
      end associate
   end function coulomb_values

   !> Coulomb's friction of a point, whose values have been checked.
   type(coulomb_t) function friction_of(self, values) result(friction)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(periodic_surface_t) :: surface

      call self%get_cells(values, surface)
      call resolve_coulomb(coulomb_values(self, values), &
         & values(self%first_of_solid:self%first_of_solid + n_two_bodies - 1), surface%n_cells(2) == 1, friction)
   end function friction_of

   !> Does the tangential displacement lack Poisson's ratio, beside a contact modulus?
   logical function lacks_poisson_ratio(self, values) result(lacks)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(periodic_surface_t) :: surface

      lacks = has_coulomb(coulomb_values(self, values)) .and. .not. has_poisson_ratio( &
         & values(self%first_of_solid:self%first_of_solid + n_two_bodies - 1))
      if (.not. lacks) return
      call self%get_cells(values, surface)
      lacks = needs_poisson_ratio(coulomb_values(self, values), surface%n_cells(2) == 1)
   end function lacks_poisson_ratio

   !> Have stress and range sizes with which the surface can be solved?
   logical function is_possible(self, values)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(periodic_surface_t) :: surface
      type(adhesion_law_t) :: law

      law = self%adhesion_of(values)
      is_possible = .not. law%stress > 0
      if (is_possible) return
      call self%get_cells(values, surface)
      call self%set_solid(values, surface)
      is_possible = are_sizes_possible(law, self%height_of(values), surface)
   end function is_possible

   !> See `periodic_model_t`.
   subroutine set_solid(self, values, surface)
      !> The model, for the indices of the rows of the solid.
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(periodic_surface_t), intent(inout) :: surface
      type(layer_kernel_t) :: kernel

      if (.not. allocated(surface%solid)) allocate (periodic_solid_t :: surface%solid)
      surface%solid%modulus = contact_modulus_of(moduli_values(self, values))
      if (allocated(surface%solid%kernel)) deallocate (surface%solid%kernel)
      associate (layer => layer_values(self, values), moduli => moduli_values(self, values))
         if (.not. has_layer(layer)) return
         call get_layer(layer, moduli, surface%period(1), kernel)
         surface%solid%numbers = numbers_of_layer(layer, moduli, surface%period(1))
      end associate
      allocate (surface%solid%kernel, source=kernel)
   end subroutine set_solid

   !> Adhesion of a point, whose values have been checked.
   type(adhesion_law_t) function adhesion_of(self, values) result(law)
      class(elastic_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      call resolve_attraction(adhesion_values(self, values), self%given_attraction, law)
   end function adhesion_of

   !> See `periodic_model_t`.
   subroutine set_interface(self, values, surface, goal)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Periods and cells of the surface [m], and its solid.
      type(periodic_surface_t), intent(in) :: surface
      !> What is prescribed at the point; receives adhesion or friction.
      type(periodic_goal_t), intent(inout) :: goal
      type(adhesion_law_t) :: law

      if (allocated(goal%adhesion)) deallocate (goal%adhesion)
      if (allocated(goal%attraction)) deallocate (goal%attraction)
      if (allocated(goal%friction)) deallocate (goal%friction)
      if (allocated(goal%hardness)) deallocate (goal%hardness)
      if (has_hardness(hardness_of(self, values))) &
         & goal%hardness = resolve_hardness(hardness_of(self, values), values(turn_index(self)), surface%solid%modulus)
      associate (punch => punch_values(self, values))
         goal%wants_punch = has_conduction(punch(:n_conduction_rows)) .or. is_wanted(punch(n_punch_rows))
      end associate
      if (has_coulomb(coulomb_values(self, values))) then
         goal%friction = friction_of(self, values)
         goal%friction%stress = goal%friction%stress/surface%solid%modulus
      end if
      law = self%adhesion_of(values)
      if (.not. law%stress > 0) return
      if (allocated(law%attraction)) then
         goal%attraction = attraction_in_units(law, surface%solid%modulus)
      else
         goal%adhesion = adhesion_in_units(law, surface%solid%modulus)
      end if
      goal%wants_pull_off = is_wanted(values(pull_off_index(self))) .and. sees_pull_off(law, surface)
   end subroutine set_interface

   !> Largest gap of what is in contact [m]: 0, or that of the largest tension where the law has no wall.
   pure real(dp) function contact_gap(law) result(gap)
      type(adhesion_law_t), intent(in) :: law

      gap = 0
      if (allocated(law%attraction)) gap = law%attraction%gap_of_largest()
   end function contact_gap

   !> Share of the surface in contact that varies smoothly.
   pure real(dp) function smooth_fraction_of(law, surface, solution) result(fraction)
      type(adhesion_law_t), intent(in) :: law
      !> Periods and cells of the surface [m].
      type(periodic_surface_t), intent(in) :: surface
      !> Solution of the point; lengths in m, pressures in E*.
      type(periodic_solution_t), intent(in) :: solution

      if (contact_gap(law) > 0) then
         fraction = level_fraction(solution%gap - contact_gap(law), surface%is_quarter)
      else
         fraction = chord_fraction(solution%pressure, solution%gap, surface%cell_sizes(), surface%is_quarter)
      end if
   end function smooth_fraction_of

   !> See `periodic_model_t`: the regime, energies, and what cells can tell of adhesion.
   subroutine finish_point(self, values, surface, solution, results, error_estimate)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Periods and undeformed gap of the surface [m], and its solid.
      type(periodic_surface_t), intent(in) :: surface
      !> Solution of the point; lengths in m, pressures in E*.
      type(periodic_solution_t), intent(inout) :: solution
      !> In: with the results that all these models have. Out: with all; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Estimated relative error of the area of contact [-]; above 1 where the cells do not see the edge of adhesion.
      real(dp), intent(out) :: error_estimate
      type(adhesion_law_t) :: law
      logical :: is_valid

      law = self%adhesion_of(values)
      error_estimate = relative_error_of(solution%area)
      associate (modulus => surface%solid%modulus)
         results(out%elastic_energy) = modulus*solution%elastic_energy
         results(out%adhesion_energy) = modulus*solution%adhesion_energy
         if (.not. allocated(law%attraction)) results(out%adhesion_fraction) = adhesion_fraction_of(solution)
         results(out%regime) = regime_of(solution)
         ! the edge of a contact is taken for that on a half-space
         if (.not. allocated(surface%solid%kernel)) results(out%smooth_fraction) = smooth_fraction_of(law, surface, solution)
         if (has_hardness(hardness_of(self, values))) results(out%smooth_fraction) = max(results(out%smooth_fraction), &
            & results(out%mean_pressure)/hardness_of(self, values))
         call store_friction(friction_values(self, values), self%given_law, tension_outside(law, solution), &
            & modulus*solution%pressure, results, is_valid)
         if (.not. is_valid) error_estimate = huge(error_estimate)
         if (is_valid .and. is_set(poisson_ratio_of(self, values)) .and. .not. allocated(surface%solid%kernel)) &
            & call store_left_out(friction_values(self, values), self%given_law, poisson_ratio_of(self, values), surface, &
            & solution, results)
         if (surface%n_cells(2) > 1) results(out%friction_force) = results(out%friction_stress)*product(surface%period)
         call store_punch(punch_values(self, values), modulus, solution, results)
         if (has_hardness(hardness_of(self, values))) then
            results(out%peak_pressure) = min(results(out%peak_pressure), hardness_of(self, values))
            call store_impressions(hardness_of(self, values), solution, &
               & results(out%impressions(1):out%impressions(n_hardness_results)))
         end if
         if (.not. law%stress > 0) return
         results(out%cells_per_zone) = cells_per_zone(law, surface)
         if (law%opening > 1) results(out%opening_loss) = modulus*solution%opening_loss
         if (solution%pull_off < huge(1.0_dp)) results(out%pull_off_pressure) = modulus*solution%pull_off
         if (any(solution%share > 0) .and. any(solution%share < 1)) &
            & error_estimate = max(error_estimate, error_of_edge(results(out%cells_per_zone)))
         error_estimate = max(error_estimate, error_of_pull_off(solution, results(out%cells_per_zone)))
      end associate
   end subroutine finish_point

   !> Store stiffness and conductances, where they are wanted and finite.
   subroutine store_punch(values, modulus, solution, results)
      !> Values of the rows of conduction, and that of the switch of the stiffness.
      real(dp), intent(in) :: values(:)
      !> Contact modulus E* [Pa].
      real(dp), intent(in) :: modulus
      !> Solution of the point; lengths in m, pressures in E*.
      type(periodic_solution_t), intent(in) :: solution
      !> In: without them. Out: with them; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      real(dp) :: stiffness

      if (.not. allocated(solution%punch)) return
      associate (compliance => solution%punch%compliance)
         ! in full contact with a half-space both are infinite
         if (.not. abs(compliance) > 0) return
         stiffness = 0
         if (compliance > 0) stiffness = 1/compliance
      end associate
      if (is_wanted(values(n_punch_rows))) results(out%contact_stiffness) = modulus*stiffness
      results(out%stiffness_error) = solution%punch%error
      call conductances(values(:n_conduction_rows), stiffness, results(out%conductances(1):out%conductances(n_conduction_results)))
   end subroutine store_punch

   !> See `periodic_model_t`.
   subroutine store_depth(self, values, surface, solution, results, has_memory, slip)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Periods and cells of the surface [m], and its solid.
      type(periodic_surface_t), intent(in) :: surface
      !> Solution of the point; lengths in m, pressures in E*.
      type(periodic_solution_t), intent(in) :: solution
      !> In: without the stresses. Out: with them, if they are wanted; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Was there memory for them?
      logical, intent(out) :: has_memory
      !> Partial slip of the point, with stresses in E*; not present without.
      type(periodic_slip_t), intent(in), optional :: slip
      real(dp), allocatable :: shear(:, :)
      integer :: axis

      has_memory = .true.
      if (.not. wants_stresses(stress_values(self, values))) return
      axis = 1
      ! an array that is not allocated is an argument that is not present
      if (present(slip)) then
         shear = slip%traction
         axis = axis_of(self, values)
      else if (has_friction(friction_values(self, values))) then
         shear = tractions_of_friction(friction_values(self, values), self%given_law, surface%solid%modulus*solution%pressure, &
            & .not. solution%gap > 0)/surface%solid%modulus
      end if
      call store_stresses(stress_values(self, values), surface, solution%pressure, ratio_of_stresses(self, values), &
         & results(out%stresses(1):out%stresses(n_stress_results)), has_memory, shear, axis)
   end subroutine store_depth

   !> Axis of the shear stress: that of the tangential force, or x.
   integer function axis_of(self, values) result(axis)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(coulomb_t) :: friction

      axis = along_x
      if (.not. has_coulomb(coulomb_values(self, values))) return
      friction = friction_of(self, values)
      axis = friction%axis
   end function axis_of

   !> Poisson's ratio of the body in which the stresses are [-].
   pure real(dp) function ratio_of_stresses(self, values) result(ratio)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)

      ratio = values(self%first_of_solid + n_one_body - 1)
   end function ratio_of_stresses

   !> See `periodic_model_t`.
   subroutine store_slip(self, values, surface, slip, results)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Periods and undeformed gap of the surface [m], and its solid.
      type(periodic_surface_t), intent(in) :: surface
      !> Slip of the point; lengths in m, stresses in E*.
      type(periodic_slip_t), intent(in) :: slip
      !> In: with the results of the contact. Out: with all; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)

      results(out%stick_fraction) = 0
      if (results(out%contact_fraction) > 0) results(out%stick_fraction) = &
         & min(slip%stick%corrected/results(out%contact_fraction), 1.0_dp)
      results(out%tangential_displacement) = slip%displacement
      results(out%cycle_energy) = surface%solid%modulus*slip%cycle_energy
      if (slip%compliance < 0) results(out%tangential_stiffness) = 0
      if (slip%compliance > 0) results(out%tangential_stiffness) = surface%solid%modulus/slip%compliance
      if (.not. slip%poisson_defect < 0) results(out%poisson_defect) = slip%poisson_defect
      associate (unused => self, unused_values => values)
      end associate
   end subroutine store_slip

   !> See `model_t`: the shear stress belongs to friction.
   pure integer function count_profiles(self, values)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)

      count_profiles = p_shear_stress - 1
      if (has_friction(friction_values(self, values)) .or. has_coulomb(coulomb_values(self, values))) &
         & count_profiles = p_shear_stress
      if (has_hardness(hardness_of(self, values))) count_profiles = p_plastic_depth
      if (has_depth(stress_values(self, values))) count_profiles = p_plastic_depth + n_stress_profiles
   end function count_profiles

   !> See `pointwise_model_t`: the maps of pressure and gap, and with friction that of the shear stress.
   subroutine fill_profiles(self, values, results, state, axes, profiles)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Results of the point; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      class(point_state_t), allocatable, intent(in) :: state
      type(profile_axis_t), intent(in) :: axes(:)
      !> Receives the maps of pressure [Pa], gap [m], shear stress [Pa], and of the stresses in depth; shape `(nx, ny, n_profiles)`.
      real(dp), intent(inout) :: profiles(:, :, :)
      type(periodic_surface_t) :: surface

      call self%fill_contact_maps(values, results, state, axes, profiles)
      if (size(profiles, 3) < p_shear_stress) return
      if (has_friction(friction_values(self, values))) then
         profiles(:, :, p_shear_stress) = tractions_of_friction(friction_values(self, values), self%given_law, profiles(:, :, 1), &
            & .not. profiles(:, :, 2) > 0)
      else if (.not. (has_coulomb(coulomb_values(self, values)) .and. any(profiles(:, :, 1) > 0))) then
         profiles(:, :, p_shear_stress) = 0
      end if
      if (size(profiles, 3) < p_plastic_depth) return
      if (.not. has_hardness(hardness_of(self, values))) profiles(:, :, p_plastic_depth) = 0
      if (.not. has_depth(stress_values(self, values))) return
      call self%get_cells(values, surface)
      call fill_stress_maps(stress_values(self, values), surface, profiles(:, :, 1), ratio_of_stresses(self, values), &
         & profiles(:, :, p_shear_stress), axis_of(self, values), profiles(:, :, p_plastic_depth + 1:))
   end subroutine fill_profiles

   !> See `model_t`.
   function describe_doubts(self, values) result(text)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text

      text = self%doubt_interface(values)
   end function describe_doubts

   !> Shear stress that would move the contact, and zones of adhesion that the cells do not see, a line each; empty if there is
   !> nothing to say.
   function doubt_interface(self, values) result(text)
      class(elastic_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text
      type(periodic_surface_t) :: surface
      type(adhesion_law_t) :: law

      text = ''
      if (has_friction(friction_values(self, values))) text = doubt_coupling(poisson_ratio_of(self, values))
      if (has_hardness(hardness_of(self, values))) text = text//doubt_yielding(self, values)
      law = self%adhesion_of(values)
      if (.not. law%stress > 0) return
      if (has_layer(layer_values(self, values))) text = text//'a state of adhesion on a layer or coating is a state, but '// &
         & 'nothing proves that it is the most or least adhered one; where a load ends without one, that is not_converged'//newline
      call self%get_cells(values, surface)
      call self%set_solid(values, surface)
      text = text//doubt_zone(law, surface)
   end function doubt_interface

   !> A load that no surface carries; else nothing.
   pure function doubt_yielding(self, values) result(text)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text

      text = ''
      if (values(self%before_prescribed + in%mean_pressure) >= hardness_of(self, values)) text = text// &
         & 'mean_pressure is not below the hardness, which is the most that a surface carries: there is no equilibrium'//newline
   end function doubt_yielding

   !> See `periodic_model_t`: the contact modulus, and lengths of adhesion.
   function derive_solid(self, values, surface) result(derived)
      class(elastic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(periodic_surface_t), intent(in) :: surface
      type(derived_t), allocatable :: derived(:)
      type(adhesion_law_t) :: law

      associate (first => self%first_of_solid, last => self%first_of_solid + n_two_bodies - 1)
         derived = derive_contact_modulus(self%variables(first:last), values(first:last))
      end associate
      law = self%adhesion_of(values)
      if (.not. law%stress > 0) return
      if (has_layer(layer_values(self, values))) then
         call derive_zone(derived, law, surface, 'length l of a short zone of adhesion, pi E w/(4 p0^2) with E of waves of the '// &
            & 'wave number 2/l, at most the period')
      else
         call derive_zone(derived, law, surface, 'length of a short zone of adhesion, pi E* w/(4 p0^2)')
      end if
   end function derive_solid

end module adfric_periodic_elastic_model

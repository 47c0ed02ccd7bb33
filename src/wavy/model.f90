! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `wavy_sliding`: a rigid wavy surface sliding on a viscoelastic foundation (GM 2011).
module adfric_wavy_model
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi, pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_model_derived, only: derived_t, add_derived
   use adfric_model_model, only: model_t
   use adfric_model_rows, only: count_row, set_coordinate
   use adfric_model_status, only: status_solved, status_no_equilibrium
   use adfric_model_table, only: result_t, profile_axis_t
   use adfric_numerics_found_once, only: found_once_t
   use adfric_wavy_adhesion, only: adhesion_t, strip_adhesion_t, new_strip_adhesion, edge_front
   use adfric_wavy_case, only: wavy_case_t, resolve_case, kind_3d, kind_map
   use adfric_wavy_check, only: check_wavy_values
   use adfric_wavy_crosswise, only: memory_t
   use adfric_wavy_equilibrium, only: equilibrium_t, neighbour_t, solve_penetration, solve_load, leads_to
   use adfric_wavy_given_surface, only: given_surface_t, take_given
   use adfric_wavy_marched_case, only: is_marched
   use adfric_wavy_marched_check, only: check_marched_values
   use adfric_wavy_marched_description, only: describe_marched, doubt_marched, derive_marched
   use adfric_wavy_marched_points, only: solve_marched_block, solve_marched_profiles, row_places, column_places
   use adfric_wavy_profiles, only: get_profiles
   use adfric_wavy_pull_off, only: pull_off_t, find_pull_off, is_below_pull_off
   use adfric_wavy_pull_off_table, only: get_pull_off
   use adfric_wavy_steady_state, only: branch_adhered
   use adfric_wavy_strip, only: steady_state_t, regime_free, regime_adhesion_only, regime_adhesion_zones, regime_saturated, &
      & regime_saturated_adhesion
   use adfric_wavy_surface, only: negligible, is_same_surface
   use adfric_wavy_variables, only: get_wavy_profiles, get_wavy_results, get_wavy_variables, r_adhesion_area, r_contact_area, &
      & r_contact_shift, r_contact_width, r_dissipation, r_edge_loss, r_energy_imbalance, &
      & r_friction_coefficient, r_friction_force, r_load, r_penetration, r_pull_off_load, &
      & r_adhesion_count, r_contact_count, r_friction_sample_error, r_pull_off_penetration, r_regime, r_saturated_share, &
      & r_snap_count, v_heights, v_kind, v_load, v_n_x, v_n_y, v_penetration, v_period, v_profiles, &
      & v_relaxation_time, v_thickness, v_velocity
   implicit none (type, external)
   private
   public :: wavy_model_t, new_wavy_model

   !> Load or friction below this share of the sum of its terms is zero but for round-off.
   real(dp), parameter :: as_good_as_zero = 1.0e-13_dp
   !> Samples of a map whose points take long.
   integer, parameter :: large_map = 100000

   !> The model. A copy of one that is prepared is not to be used once either is released.
   type, extends(model_t) :: wavy_model_t
      private
      !> The pull-off loads that the points of a run share; null unless the model is prepared.
      type(found_once_t), pointer :: pull_offs => null()
      !> Lists and datasets of the input.
      type(given_surface_t) :: given
   contains
      procedure :: take_dataset
      procedure :: take_attribute
      procedure :: describe_case
      procedure :: prepare
      procedure :: release
      procedure :: check_values
      procedure :: describe_results
      procedure :: wants_profiles
      procedure :: get_profile_axes
      procedure :: solve_block
      procedure :: solve_profiles
      procedure :: derive_quantities
      procedure :: describe_doubts
      procedure :: unit_of
   end type wavy_model_t

contains

   !> The model with its tables.
   subroutine new_wavy_model(self)
      !> Receives its name and the tables of variables, results and profiles.
      type(wavy_model_t), intent(out) :: self

      self%name = 'wavy_sliding'
      self%summary = 'a rigid wavy surface sliding on a viscoelastic foundation, with adhesion'
      self%references = 'I. Goryacheva, Yu. Makhovskaya, acta mechanica et automatica 5(4) (2011)'
      self%variables = get_wavy_variables()
      self%results = get_wavy_results()
      self%profiles = get_wavy_profiles()
      self%profile_axes = 'y x'
      allocate (self%counts(2))
      self%counts(1) = count_row(name='strips_per_point', long_name='strips that were solved')
      self%counts(2) = count_row(name='closed_form_strips_per_point', long_name='strips that were solved in closed form')
   end subroutine new_wavy_model

   !> Add to `problems` what is contradictory or impossible in the values together.
   subroutine check_values(self, values, is_swept, problems)
      !> The model, whose table of variables is read.
      class(wavy_model_t), intent(in) :: self
      !> Values in the order of `self%variables`, of a swept variable one of its values; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      if (is_marched(values)) then
         call check_marched_values(self%variables, values, self%given, is_swept, problems)
      else
         call check_wavy_values(self%variables, values, is_swept, problems)
      end if
   end subroutine check_values

   !> The table of results, whose units are those of a 2-D or of a 3-D wave.
   function describe_results(self, values) result(results)
      !> The model, whose table of results serves a 2-D wave.
      class(wavy_model_t), intent(in) :: self
      !> Values of one point in the order of `self%variables`; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(result_t), allocatable :: results(:)

      results = self%results
      if (is_set(values(v_kind))) results = get_wavy_results(has_width(values))
   end function describe_results

   !> SI unit of a variable: the load of a 2-D wave is one per width.
   function unit_of(self, values, place) result(unit)
      !> The model, whose table of variables is read.
      class(wavy_model_t), intent(in) :: self
      !> Values of one point in the order of `self%variables`; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Place of the variable, one of `v_...`.
      integer, intent(in) :: place
      character(:), allocatable :: unit

      unit = self%variables(place)%unit
      if (place == v_load) unit = trim(merge('N  ', 'N/m', has_width(values)))
   end function unit_of

   !> Has the surface a width of its own, so that forces are not per width?
   pure logical function has_width(values)
      !> Values of one point in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      has_width = nint(values(v_kind)) == kind_3d .or. nint(values(v_kind)) == kind_map
   end function has_width

   !> Keep the values of a list or a dataset.
   subroutine take_dataset(self, place, values, problems)
      !> The model, which keeps the values.
      class(wavy_model_t), intent(inout) :: self
      !> Place of the variable, one of `v_...`.
      integer, intent(in) :: place
      !> The values in SI units; shape `(n_last, n_first)`.
      real(dp), intent(in) :: values(:, :)
      !> Receives what is wrong with the values.
      type(problems_t), intent(inout) :: problems

      call take_given(self%given, self%variables, place, values, problems)
      ! a map takes long, and its points are given to threads one by one
      if (place == v_heights .and. size(values) > large_map) self%largest_block = 1
   end subroutine take_dataset

   !> Keep what a dataset says of itself.
   subroutine take_attribute(self, place, name, value, problems)
      !> The model, which keeps the value.
      class(wavy_model_t), intent(inout) :: self
      !> Place of the variable, one of `v_...`.
      integer, intent(in) :: place
      !> Name of the attribute.
      character(*), intent(in) :: name
      !> Its value in SI units.
      real(dp), intent(in) :: value
      !> Receives what is wrong with it.
      type(problems_t), intent(inout) :: problems

      select case (name)
      case ('dx')
         self%given%dx = value
      case ('dy')
         self%given%dy = value
      case ('reference_temperature')
         self%given%master_temperature = value
      end select
      if (.not. value > 0) call problems%add(self%variables(place)%group, self%variables(place)%name, &
         & 'has an attribute '//name//' that is not > 0')
   end subroutine take_attribute

   !> What `adfric check` says of spectrum and heights.
   function describe_case(self, values) result(text)
      !> The model with its lists and datasets.
      class(wavy_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text

      text = ''
      if (is_marched(values)) text = describe_marched(values, self%given)
   end function describe_case

   !> Does the user ask for profiles?
   pure logical function wants_profiles(self, values)
      !> The model; nothing of it is read here.
      class(wavy_model_t), intent(in) :: self
      !> Values of one point in the order of `self%variables`; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      wants_profiles = values(v_profiles) > 0
      associate (unused => self)
      end associate
   end function wants_profiles

   !> The profile axes y and x: one period about the crest.
   subroutine get_profile_axes(self, values, axes)
      !> The model, for the names of its axes.
      class(wavy_model_t), intent(in) :: self
      !> Values of one point in the order of `self%variables`; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives y and x.
      type(profile_axis_t), allocatable, intent(out) :: axes(:)

      allocate (axes(2))
      if (is_marched(values)) then
         call set_coordinate(axes(1), self%profile_axes, 1, row_places(values, self%given))
         call set_coordinate(axes(2), self%profile_axes, 2, column_places(values, self%given))
         return
      end if
      call set_coordinate(axes(1), self%profile_axes, 1, &
         & about_crest(values(v_period), merge(nint(values(v_n_y)), 1, nint(values(v_kind)) == kind_3d)))
      call set_coordinate(axes(2), self%profile_axes, 2, about_crest(values(v_period), nint(values(v_n_x))))
   end subroutine get_profile_axes

   !> Coordinates over one period, as far on one side of the crest as on the other, to the last digit.
   pure function about_crest(period, n) result(coordinates)
      !> Period of the wave [m].
      real(dp), intent(in) :: period
      !> Number of coordinates; a single one is that of the crest.
      integer, intent(in) :: n
      real(dp) :: coordinates(n)
      integer :: k

      coordinates = 0
      if (n > 1) coordinates = [(period*(real(2*k - (n - 1), dp)/(2*(n - 1))), k=0, n - 1)]
   end function about_crest

   !> Make room for the pull-off loads that points share, each of which is found once.
   subroutine prepare(self)
      !> The model; all threads use what it keeps.
      class(wavy_model_t), intent(inout) :: self

      if (.not. associated(self%pull_offs)) allocate (self%pull_offs)
   end subroutine prepare

   !> Give back the pull-off loads that points have shared.
   subroutine release(self)
      !> The model, which keeps nothing at the end.
      class(wavy_model_t), intent(inout) :: self

      if (.not. associated(self%pull_offs)) return
      call self%pull_offs%clear()
      deallocate (self%pull_offs)
   end subroutine release

   !> Solve neighbouring points. Loads, and penetrations in 3-D and on the approach branch, are solved in the order in which each
   !> leads to the next on its branch.
   subroutine solve_block(self, values, results, error_estimate, status, counts)
      !> The model, whose pull-off loads are looked up, and completed, if it is prepared.
      class(wavy_model_t), intent(in) :: self
      !> Values of neighbouring points; shape `(n_variables, n_points)`.
      real(dp), intent(in) :: values(:, :)
      !> Results in SI units, NaN where there is no value; shape `(n_results, n_points)`.
      real(dp), intent(out) :: results(:, :)
      !> Relative error of load and friction [-], NaN where the point is not solved; shape `(n_points)`.
      real(dp), intent(out) :: error_estimate(:)
      !> How each point was solved, one of `status_...`; shape `(n_points)`.
      integer, intent(out) :: status(:)
      !> Receives the number of strips solved for all points of the block, and of those among them in closed form.
      real(dp), intent(out) :: counts(:)
      type(wavy_case_t) :: point, last, hopeless
      type(equilibrium_t) :: equilibrium
      type(memory_t) :: memory
      type(neighbour_t) :: neighbour
      type(pull_off_t) :: pull_off
      integer :: i, k, n
      logical :: is_reversed

      counts = 0
      n = size(values, 2)
      if (n > 0) then
         if (is_marched(values(:, 1))) then
            call solve_marched_block(self%given, values, results, error_estimate, status)
            counts(1) = n
            if (nint(values(v_kind, 1)) == kind_map) counts(1) = real(n, dp)*size(self%given%heights, 2)
            return
         end if
      end if
      is_reversed = .false.
      if (n > 1) is_reversed = leads_backwards(values(:, 1), values(:, 2))
      do k = 1, n
         i = merge(n + 1 - k, k, is_reversed)
         call resolve_case(values(:, i), point)
         if (point%wants_pull_off) then
            if (associated(self%pull_offs)) then
               call get_pull_off(self%pull_offs, point%surface, pull_off)
            else
               call find_pull_off(point%surface, pull_off)
            end if
         end if
         memory%is_even = .not. point%is_load_given
         memory%needs_slope = point%is_load_given
         if (point%is_load_given) then
            if (neighbour%n > 0) then
               if (.not. leads_to(last%surface, last%load, point%surface, point%load)) neighbour%n = 0
            end if
            if (is_below_pull_off(pull_off, point%surface, point%load) .or. is_hopeless(hopeless, point)) then
               equilibrium = equilibrium_t(status_no_equilibrium)
            else
               call solve_load(point%surface, point%load, neighbour, memory, equilibrium)
            end if
            if (equilibrium%status == status_no_equilibrium) hopeless = point
            last = point
         else
            call solve_penetration(point%surface, point%penetration, memory, equilibrium)
         end if
         call store(point, equilibrium, pull_off, results(:, i))
         status(i) = equilibrium%status
         error_estimate(i) = equilibrium%error_estimate
         if (status(i) /= status_solved) error_estimate(i) = not_a_number()
         counts = counts + [equilibrium%totals%n_strips, equilibrium%totals%n_closed_form]
      end do
   end subroutine solve_block

   !> Is a load without equilibrium for sure, because a larger one had none on the same surface? The load rises with the
   !> penetration without jumps, so where one load has no state all penetrations carry more.
   pure logical function is_hopeless(known, point)
      !> A point without equilibrium, or a default one before there is any.
      type(wavy_case_t), intent(in) :: known
      !> The point that is judged.
      type(wavy_case_t), intent(in) :: point

      is_hopeless = known%is_load_given .and. point%load <= known%load
      if (is_hopeless) is_hopeless = is_same_surface(known%surface, point%surface)
   end function is_hopeless

   !> Does a point lead to the one before it, and not the other way round?
   pure logical function leads_backwards(first, second)
      !> Values of two points, one after the other in the block; shape `(n_variables)`.
      real(dp), intent(in) :: first(:), second(:)
      type(wavy_case_t) :: one, two

      call resolve_case(first, one)
      call resolve_case(second, two)
      if (one%is_load_given) then
         leads_backwards = leads_to(two%surface, two%load, one%surface, one%load) &
            & .and. .not. leads_to(one%surface, one%load, two%surface, two%load)
      else
         leads_backwards = one%surface%adhesion%stress > 0 .and. is_same_surface(one%surface, two%surface)
         if (one%surface%branch == branch_adhered) then
            leads_backwards = leads_backwards .and. two%surface%shape%is_3d .and. two%penetration > one%penetration
         else
            leads_backwards = leads_backwards .and. two%penetration < one%penetration
         end if
      end if
   end function leads_backwards

   !> Results of a point in SI units.
   pure subroutine store(point, equilibrium, pull_off, results)
      !> The point in reduced units, and what these units are in SI units.
      type(wavy_case_t), intent(in) :: point
      !> What was found at the point, in reduced units.
      type(equilibrium_t), intent(in) :: equilibrium
      !> Pull-off load of the surface of the point, if it is asked for.
      type(pull_off_t), intent(in) :: pull_off
      !> Results in SI units, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(out) :: results(:)
      real(dp) :: width, losses

      results = not_a_number()
      if (equilibrium%status /= status_solved) return
      associate (t => equilibrium%totals)
         results(r_load) = t%load*point%load_unit
         if (point%is_load_given) results(r_load) = point%load*point%load_unit
         results(r_penetration) = equilibrium%penetration*point%height
         results(r_friction_force) = t%friction*point%friction_unit
         if (abs(results(r_load)) > as_good_as_zero*t%load_scale*point%load_unit) then
            results(r_friction_coefficient) = results(r_friction_force)/results(r_load)
         end if
         results(r_contact_area) = t%contact*point%area_unit
         results(r_adhesion_area) = t%adhesion*point%area_unit
         results(r_dissipation) = t%dissipation*point%friction_unit
         results(r_edge_loss) = t%edge_loss*point%friction_unit
         ! friction that is nothing beside the load has no digits of its own
         losses = max(t%friction_scale + t%dissipation + abs(t%edge_loss), negligible*t%load_scale)
         results(r_energy_imbalance) = 0
         if (losses > 0) results(r_energy_imbalance) = t%energy_mismatch/losses
      end associate
      associate (crest => equilibrium%crest)
         width = 2*crest%half_width
         if (crest%regime == regime_free .or. crest%regime == regime_adhesion_only) width = 0
         results(r_contact_width) = width/two_pi*point%period
         results(r_contact_shift) = merge(crest%shift, 0.0_dp, width > 0 .and. crest%half_width < pi)/two_pi*point%period
         results(r_regime) = crest%regime
         if (.not. point%surface%shape%is_3d) call count_zones(crest, point%surface%adhesion, &
            & point%surface%foundation%beta, results)
      end associate
      if (.not. point%wants_pull_off .or. .not. pull_off%is_converged) return
      results(r_pull_off_load) = pull_off%load*point%load_unit
      results(r_pull_off_penetration) = pull_off%penetration*point%height
   end subroutine store

   !> Numbers of zones of the one strip of a 2-D wave.
   pure subroutine count_zones(state, adhesion, beta, results)
      !> Its steady state.
      type(steady_state_t), intent(in) :: state
      !> Adhesion of the surface.
      type(adhesion_t), intent(in) :: adhesion
      !> Ratio of retardation to relaxation time [-].
      real(dp), intent(in) :: beta
      !> Receives the counts; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      type(strip_adhesion_t) :: law
      logical :: has_contact, has_free

      call new_strip_adhesion(law, adhesion, 0.5_dp, beta)
      has_contact = state%regime /= regime_free .and. state%regime /= regime_adhesion_only
      has_free = state%regime == regime_adhesion_zones
      results(r_contact_count) = merge(1, 0, has_contact)
      results(r_adhesion_count) = merge(1, 0, state%regime == regime_adhesion_only .or. state%regime == regime_saturated_adhesion)
      if (has_free) results(r_adhesion_count) = count([state%trailing, state%leading] > 0)
      results(r_snap_count) = merge(1, 0, (has_free .or. (state%regime == regime_adhesion_only .and. state%half_width < pi)) &
         & .and. law%jump > 0)
      results(r_saturated_share) = merge(1, 0, state%regime == regime_saturated)
      results(r_friction_sample_error) = 0
   end subroutine count_zones

   !> Profiles of one solved point.
   subroutine solve_profiles(self, values, results, profiles)
      !> The model, which knows the profile axes.
      class(wavy_model_t), intent(in) :: self
      !> Values of one point in the order of `self%variables`; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Results of the point, of which the penetration is read; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> Pressure and shear stress [Pa], displacement and gap [m]; shape `(n_x, n_y, 4)`.
      real(dp), intent(out) :: profiles(:, :, :)
      type(profile_axis_t), allocatable :: axes(:)
      type(wavy_case_t) :: point

      call self%get_profile_axes(values, axes)
      if (is_marched(values)) then
         call solve_marched_profiles(self%given, values, axes(2)%coordinates, profiles)
         return
      end if
      call resolve_case(values, point)
      call get_profiles(point, results(r_penetration), axes(2)%coordinates, axes(1)%coordinates, profiles)
   end subroutine solve_profiles

   !> Quantities that follow from the values of a point, for `adfric check` and the results file.
   function derive_quantities(self, values) result(derived)
      !> The model with its lists and datasets.
      class(wavy_model_t), intent(in) :: self
      !> Values of one point in the order of `self%variables`; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(derived_t), allocatable :: derived(:)
      character(*), parameter :: of_stiffness = 'stiffness young_modulus poisson_ratio thickness'
      character(*), parameter :: of_phase = 'period velocity relaxation_time', of_viscosity = of_phase//' retardation_ratio'
      character(*), parameter :: of_range = 'stress surface_energy range'
      type(wavy_case_t) :: point

      allocate (derived(0))
      if (is_marched(values)) then
         call derive_marched(derived, values, self%given)
         return
      end if
      call resolve_case(values, point)
      associate (given => point%given, f => point%surface%foundation)
         call add_derived(derived, 'relaxation_phase', '-', 'relaxation phase k V Ts', f%u, of_phase)
         call add_derived(derived, 'retardation_phase', '-', 'retardation phase k V Te', f%v, of_viscosity)
         call add_derived(derived, 'loss_ratio', '-', 'loss modulus over stiffness', f%loss, of_viscosity)
         call add_derived(derived, 'stiffness', 'Pa/m', 'long-time stiffness', point%pressure_unit/point%height, &
            & of_stiffness)
         call add_derived(derived, 'pressure_unit', 'Pa', 'pressure unit, height times stiffness', point%pressure_unit, &
            & of_stiffness//' height')
         call add_derived(derived, 'reduced_stress', '-', 'adhesion stress over the pressure unit', given%stress, &
            & of_stiffness//' height stress')
         if (given%stress > 0) call add_derived(derived, 'range', 'm', 'range of adhesion', &
            & given%range*point%height, of_range)
         call add_derived(derived, 'reduced_range', '-', 'range of adhesion over height', given%range, of_range//' height')
      end associate
   end function derive_quantities

   !> See `model_t`: sliding so slow that a layer has no front (docs/wavy.md).
   function describe_doubts(self, values) result(text)
      !> The model with its lists and datasets.
      class(wavy_model_t), intent(in) :: self
      !> Values of one point in the order of `self%variables`; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text
      character(40) :: lengths
      type(wavy_case_t) :: point
      real(dp) :: lag

      text = ''
      if (is_marched(values)) then
         text = doubt_marched(values, self%given)
         return
      end if
      call resolve_case(values, point)
      if (.not. is_set(values(v_thickness)) .or. point%given%edge /= edge_front .or. point%given%stress <= 0) return
      lag = values(v_velocity)*values(v_relaxation_time)
      if (lag >= values(v_thickness)) return
      write (lengths, '(es9.2, a, es9.2, a)') lag, ' m <', values(v_thickness), ' m'
      text = 'edge = ''front'' needs velocity times relaxation_time above thickness, but'//trim(lengths) &
         & //': the layer has less friction'//new_line('a')
   end function describe_doubts

end module adfric_wavy_model

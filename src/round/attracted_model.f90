! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `attracted_indenter`: a smooth indenter of any axisymmetric shape on an elastic half-space, with any law of attraction.
!> Dugdale's law has the closed forms of the model `indenter`.
module adfric_round_attracted_model
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_describe_check, only: checks_t, new_checks, refuse_swept
   use adfric_describe_derived, only: derived_t
   use adfric_describe_pointwise, only: point_state_t, pointwise_model_t
   use adfric_describe_status, only: status_no_equilibrium, status_not_converged, status_solved
   use adfric_describe_table, only: profile_axis_t
   use adfric_interface_attraction, only: law_dugdale, law_table
   use adfric_interface_attraction_rows, only: problem_of_table
   use adfric_round_attracted_point, only: attracted_point_t, attracted_survey_t, find_point, gap_of, make_body, pressure_of, &
      & reaches_beyond, survey_attraction
   use adfric_round_attracted_rows, only: before_attracted, get_attracted_results, get_attracted_variables, &
      & mine => attracted_input, n_attracted_results, n_attracted_variables, out => attracted_output, same_results, &
      & values_of_indenter
   use adfric_round_attracted_sample, only: body_t
   use adfric_round_case, only: indenter_case_t, is_possible, resolve_case
   use adfric_round_check, only: check_indenter_values
   use adfric_round_curve, only: control_approach, control_load, control_radius, control_spring, stability_control
   use adfric_round_dugdale_curve, only: dugdale_curve_t
   use adfric_round_model, only: indenter_model_t, new_indenter_model
   use adfric_round_survey, only: survey_curve, survey_t
   use adfric_round_variables, only: get_indenter_profiles, in => indenter_input, indenter_unit_of, kind_cone, kind_paraboloid, &
      & kind_polynomial, kind_power, kind_sphere, n_indenter_results, n_indenter_variables, p_gap, p_pressure, radius_axis
   use adfric_solid_contact_modulus, only: derive_contact_modulus
   implicit none (type, external)
   private
   public :: attracted_indenter_t, new_attracted_indenter

   !> The model.
   type, extends(pointwise_model_t) :: attracted_indenter_t
      !> Gaps [m] and tensions [Pa] of the law table; shape `(n, 2)`; not allocated without one.
      real(dp), allocatable :: table(:, :)
      !> The model of Dugdale's law.
      type(indenter_model_t) :: indenter
   contains
      procedure :: check_values
      procedure :: take_dataset
      procedure :: wants_profiles
      procedure :: get_profile_axes
      procedure :: solve_point
      procedure :: count_profiles
      procedure :: fill_profiles
      procedure :: derive_quantities
      procedure :: unit_of
   end type attracted_indenter_t

   !> What a point leaves.
   type, extends(point_state_t) :: attracted_state_t
      !> The point.
      type(indenter_case_t) :: case
      !> Its body with the law.
      type(body_t) :: body
      !> All states of the body; not allocated once another point has them.
      type(attracted_survey_t), allocatable :: survey
      !> What was found.
      type(attracted_point_t), allocatable :: point
      !> Values of the variables up to the table, and the control with its compliance, which the survey follows from.
      real(dp) :: values(before_attracted + mine%tension_table + 2) = 0
   end type attracted_state_t

contains

   !> The model with its tables.
   subroutine new_attracted_indenter(self)
      !> Receives its names and its tables.
      type(attracted_indenter_t), intent(out) :: self

      self%name = 'attracted_indenter'
      self%summary = 'an indenter of any smooth axisymmetric shape on a half-space, with any law of attraction'
      self%references = 'J. A. Greenwood, Proc. R. Soc. Lond. A 453 (1997) 1277; J. Q. Feng, Colloids Surf. A 172 (2000) 175'
      self%variables = get_attracted_variables()
      self%results = get_attracted_results()
      self%profiles = get_indenter_profiles()
      self%profile_axes = 'r'
      allocate (self%counts(0))
      call new_indenter_model(self%indenter)
   end subroutine new_attracted_indenter

   !> See `model_t`.
   subroutine take_dataset(self, index, values, problems)
      class(attracted_indenter_t), intent(inout) :: self
      !> Index of the dataset in `variables`.
      integer, intent(in) :: index
      !> Its values; shape `(n, 2)`.
      real(dp), intent(in) :: values(:, :)
      !> Receives what is wrong with the values; nothing here, `check_values` tells.
      type(problems_t), intent(inout) :: problems

      if (index == before_attracted + mine%tension_table) self%table = values
      associate (unused => problems)
      end associate
   end subroutine take_dataset

   !> See `model_t`.
   subroutine check_values(self, values, is_swept, problems)
      class(attracted_indenter_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      logical, intent(in) :: is_swept(:)
      type(problems_t), intent(inout) :: problems
      type(checks_t) :: c
      type(indenter_case_t) :: case
      type(body_t) :: body
      real(dp) :: own(n_indenter_variables)
      integer :: before, law
      logical :: swept(n_indenter_variables)

      before = problems%count()
      call new_checks(c, self%variables, values, problems)
      law = nint(values(before_attracted + mine%law))
      call check_law(c, law, self%table)
      if (values(before_attracted + mine%profiles) > 0) call refuse_swept(self%variables, is_swept, &
         & before_attracted + [mine%r_max, mine%n_r], problems)
      if (problems%count() > before) return
      ! a table that could not be read has been told
      if (law == law_table .and. .not. allocated(self%table)) return
      own = own_values(self, values)
      swept = .false.
      call check_indenter_values(self%indenter%variables, own, swept, problems)
      if (problems%count() > before .or. law == law_dugdale) return
      if (c%has(in%kind)) call c%add(in%kind, 'has a corner, and a law of attraction other than Dugdale''s has no solver there', &
         & .not. any(nint(values(in%kind)) == [kind_cone, kind_paraboloid, kind_power, kind_sphere, kind_polynomial]))
      if (problems%count() > before) return
      call resolve_case(own, case)
      call make_body(case, law, self%table, body)
      call c%add(in%radius, 'is so small that the attraction would reach beyond the sphere', reaches_beyond(body))
   end subroutine check_values

   !> The values that the model `indenter` would have, with its defaults.
   pure function own_values(self, values) result(own)
      class(attracted_indenter_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      real(dp) :: own(n_indenter_variables)

      own = values_of_indenter(values, self%table)
      where (.not. is_set(own)) own = self%indenter%variables%default
   end function own_values

   !> What a law needs of work, largest tension and range.
   subroutine check_law(c, law, samples)
      type(checks_t), intent(in) :: c
      !> One of `law_...`.
      integer, intent(in) :: law
      !> Gaps and tensions of a table; shape `(n, 2)`; not allocated without one.
      real(dp), allocatable, intent(in) :: samples(:, :)
      integer, parameter :: table = before_attracted + mine%tension_table
      character(:), allocatable :: text
      integer :: k

      if (law == law_table) then
         call c%need([table])
         if (allocated(samples)) then
            text = problem_of_table(samples)
            call c%add(table, text, len(text) > 0)
         end if
         do k = in%work_of_adhesion, in%lambda
            call c%add(k, 'has no meaning for law = ''table'', whose tension_table says it', c%has(k))
         end do
      else
         call c%add(table, 'has no meaning but for law = ''table''', c%has(table))
         k = count(is_set(c%values(in%work_of_adhesion:in%lambda)))
         if (k /= 2 .or. (c%has(in%lambda) .and. .not. c%has(in%work_of_adhesion))) then
            call c%add(in%work_of_adhesion, 'and adhesion_stress, adhesion_range or lambda: a law of attraction needs two of '// &
               & 'work_of_adhesion, adhesion_stress and adhesion_range, or work_of_adhesion and lambda')
         end if
         call c%add(in%work_of_adhesion, 'is 0, and a law of attraction needs some', c%has(in%work_of_adhesion) .and. &
            & .not. c%is_above_zero(in%work_of_adhesion))
      end if
   end subroutine check_law

   !> See `model_t`.
   pure logical function wants_profiles(self, values)
      class(attracted_indenter_t), intent(in) :: self
      real(dp), intent(in) :: values(:)

      wants_profiles = values(before_attracted + mine%profiles) > 0
      associate (unused => self)
      end associate
   end function wants_profiles

   !> See `model_t`.
   subroutine get_profile_axes(self, values, axes)
      class(attracted_indenter_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(profile_axis_t), allocatable, intent(out) :: axes(:)

      axes = radius_axis(values(before_attracted + mine%r_max), values(before_attracted + mine%n_r), 'm')
      associate (unused => self)
      end associate
   end subroutine get_profile_axes

   !> See `pointwise_model_t`.
   subroutine solve_point(self, values, state, results, error_estimate, status, counts)
      class(attracted_indenter_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> In: the path of the point before, which serves if body, law and control are the same. Out: that of this one.
      class(point_state_t), allocatable, intent(inout) :: state
      real(dp), intent(inout) :: results(:)
      real(dp), intent(out) :: error_estimate
      integer, intent(out) :: status
      !> This model counts nothing; size 0.
      real(dp), intent(inout) :: counts(:)
      type(attracted_state_t), allocatable :: found
      real(dp) :: own(n_indenter_variables), of_indenter(n_indenter_results)
      integer :: law

      error_estimate = 0
      status = status_no_equilibrium
      law = nint(values(before_attracted + mine%law))
      own = own_values(self, values)
      allocate (found)
      call resolve_case(own, found%case)
      if (.not. is_possible(own, found%case)) return
      if (law == law_dugdale) then
         of_indenter = not_a_number()
         call self%indenter%solve_point(own, state, of_indenter, error_estimate, status, counts)
         results(:size(same_results)) = of_indenter(same_results)
         if (.not. ieee_is_nan(results(out%pull_off_load))) results(out%pull_off_excess) = 0
         return
      end if
      call make_body(found%case, law, self%table, found%body)
      if (reaches_beyond(found%body)) return
      found%values = [values(:before_attracted + mine%tension_table), real(found%body%control, dp), found%body%compliance]
      where (.not. is_set(found%values)) found%values = -1
      call take_survey(state, found)
      allocate (found%point)
      call find_point(found%case, found%survey, values(before_attracted + mine%relative_tolerance), found%point)
      if (found%point%is_found .and. found%point%is_converged) then
         call store(self, found, results)
         error_estimate = min(1.0_dp, found%point%error)
         status = status_solved
      else if (.not. found%point%is_converged) then
         status = status_not_converged
      end if
      call move_alloc(found, state)
   end subroutine solve_point

   !> Take the path of the point before over, or make one.
   subroutine take_survey(state, found)
      class(point_state_t), allocatable, intent(inout) :: state
      type(attracted_state_t), intent(inout) :: found

      if (allocated(state)) then
         select type (state)
         type is (attracted_state_t)
            if (.not. any(abs(state%values - found%values) > 0)) then
               call move_alloc(state%survey, found%survey)
               return
            end if
         end select
      end if
      allocate (found%survey)
      call survey_attraction(found%body, found%survey)
   end subroutine take_survey

   !> Results in SI units.
   subroutine store(self, found, results)
      class(attracted_indenter_t), intent(in) :: self
      type(attracted_state_t), intent(in) :: found
      real(dp), intent(inout) :: results(:)
      type(survey_t) :: dugdale

      associate (case => found%case, point => found%point, sample => found%point%sample)
         associate (length => case%length_unit, height => case%height_unit, force => case%force_unit())
            results(out%load) = merge(case%given, sample%load, case%control == control_load)*force
            results(out%approach) = merge(case%given, sample%approach, case%control == control_approach)*height
            results(out%contact_radius) = max(sample%z, 0.0_dp)*length
            results(out%contact_area) = pi*results(out%contact_radius)**2
            if (sample%z > 0) results(out%mean_pressure) = results(out%load)/results(out%contact_area)
            results(out%contact_stiffness) = point%stiffness*case%stiffness_unit()
            results(out%elastic_energy) = sample%elastic_energy*force*height
            results(out%adhesion_energy) = sample%attraction_energy*force*height
            results(out%adhesion_radius) = sample%adhesion_radius*length
            results(out%stable) = merge(1, 0, point%is_stable)
            results([out%pull_off_load, out%jump_outward_load]) = [point%pull_off(1), point%jump_in(1)]*force
            results([out%pull_off_approach, out%jump_outward_approach]) = [point%pull_off(2), point%jump_in(2)]*height
            if (case%control == control_spring) results(out%base_approach) = case%given*height
            results(out%central_gap) = -case%given*height
            if (allocated(sample%state)) results(out%central_gap) = sample%state%central_gap*height
            call survey_curve(case%curve, case%control, dugdale)
            if (dugdale%ends%is_converged) results(out%pull_off_excess) = point%pull_off(1)/dugdale%ends%pull_off_load - 1
         end associate
      end associate
      associate (unused => self)
      end associate
   end subroutine store

   !> See `model_t`: pressure and gap.
   pure integer function count_profiles(self, values)
      class(attracted_indenter_t), intent(in) :: self
      real(dp), intent(in) :: values(:)

      count_profiles = p_gap
      associate (unused => self, unused_too => values)
      end associate
   end function count_profiles

   !> See `pointwise_model_t`: pressure and gap.
   subroutine fill_profiles(self, values, results, state, axes, profiles)
      class(attracted_indenter_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      real(dp), intent(in) :: results(:)
      class(point_state_t), allocatable, intent(in) :: state
      !> The axis r.
      type(profile_axis_t), intent(in) :: axes(:)
      real(dp), intent(inout) :: profiles(:, :, :)
      real(dp) :: r, height, slope, of_indenter(n_indenter_results)
      integer :: k

      if (nint(values(before_attracted + mine%law)) == law_dugdale) then
         of_indenter = not_a_number()
         call self%indenter%fill_profiles(own_values(self, values), of_indenter, state, axes, profiles)
         return
      end if
      select type (state)
      type is (attracted_state_t)
         associate (case => state%case)
            if (.not. allocated(state%point)) return
            if (.not. (state%point%is_found .and. state%point%is_converged)) return
            do k = 1, size(profiles, 1)
               r = axes(1)%coordinates(k)/case%length_unit
               if (r >= state%body%shape%edge) cycle
               if (.not. allocated(state%point%sample%state)) then
                  ! bodies that are apart keep their shape
                  call state%body%shape%get_profile(r, height, slope)
                  profiles(k, 1, p_pressure) = 0
                  profiles(k, 1, p_gap) = (height - state%point%sample%approach)*case%height_unit
                  cycle
               end if
               profiles(k, 1, p_pressure) = pressure_of(state%body, state%point%sample%state, r)*case%modulus &
                  & *(case%height_unit/case%length_unit)
               profiles(k, 1, p_gap) = gap_of(state%body, state%point%sample%state, r)*case%height_unit
            end do
         end associate
      end select
      associate (unused => results)
      end associate
   end subroutine fill_profiles

   !> See `model_t`.
   function derive_quantities(self, values) result(derived)
      class(attracted_indenter_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(derived_t), allocatable :: derived(:)

      associate (first => in%contact_modulus, last => in%second_poisson_ratio)
         derived = derive_contact_modulus(self%variables(first:last), values(first:last))
      end associate
   end function derive_quantities

   !> See `model_t`: the coefficient of r^n has a unit that depends on n.
   function unit_of(self, values, index) result(unit)
      class(attracted_indenter_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      integer, intent(in) :: index
      character(:), allocatable :: unit

      unit = indenter_unit_of(self%variables, values, index)
   end function unit_of

end module adfric_round_attracted_model

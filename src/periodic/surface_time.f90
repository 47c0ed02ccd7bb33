! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `surface_time`: a periodic surface on a viscoelastic half-space under a mean pressure that changes in time, without
!> adhesion and friction, as long as its contact does not shrink: how the area of contact grows with age.
!>
!> While the contact grows, each point of it was free until it was touched, and is touched since. So the surface is that of an elastic half-space
!> of the relaxed modulus E0 under the mean pressure \( E_0 Q(t) \), where Q is the creep strain of the given pressure
!> (`adfric_solid_creep`): one elastic contact for each time, exact in the history. The page `docs/theory/ageing.md` has the proof.
module adfric_periodic_surface_time
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: show_number
   use adfric_describe_check, only: refuse_swept, require
   use adfric_describe_derived, only: derived_t
   use adfric_describe_pointwise, only: point_state_t
   use adfric_describe_status, only: status_no_equilibrium, status_solved
   use adfric_describe_stepwise, only: steps_t, stepwise_model_t
   use adfric_describe_time_list, only: check_length, check_times
   use adfric_periodic_sliding_model, only: new_sliding_model, sliding_model_t
   use adfric_periodic_sliding_variables, only: n_surface_rows, s_velocity, sliding_input, sliding_output
   use adfric_periodic_surface_time_rows, only: n_ageing_profiles, n_ageing_results, n_ageing_rows, p_elastic, &
      & p_fraction, p_gap, p_penetration, p_pressure, p_smooth, p_time, set_ageing_results, set_history_rows, &
      & in => ageing_input, out => ageing_output
   use adfric_periodic_variables, only: periodic_input, periodic_output, tolerance_row
   use adfric_solid_creep, only: creep_t, new_creep
   use adfric_solid_given_spectrum, only: given_spectrum_t
   use adfric_solid_prony, only: new_prony, prony_t
   use adfric_solid_spectrum_rows, only: check_spectrum, derive_spectrum, describe_spectrum, get_spectrum, n_spectrum_rows, &
      & set_spectrum_rows, shift_factor_of, take_spectrum, take_spectrum_attribute
   implicit none (type, external)
   private
   public :: surface_time_t, new_surface_time

   !> Rows of the surface: those of `surface_sliding`, but for the direction. Then the tolerance and the solid.
   integer, parameter :: surface_rows(*) = [sliding_input%kind, sliding_input%period, sliding_input%amplitude, &
      & sliding_input%heights, sliding_input%length_x, sliding_input%length_y, sliding_input%rms_height, sliding_input%cells], &
      & own_heights = 4, before_solid = size(surface_rows) + 1, before_history = before_solid + n_spectrum_rows

   integer, parameter :: n_variables = before_history + n_ageing_rows

   !> The model.
   type, extends(stepwise_model_t) :: surface_time_t
      private
      !> The surface on the relaxed solid, at rest.
      type(sliding_model_t) :: relaxed
      !> Lists of the solid.
      type(given_spectrum_t) :: given
      !> Times [s] and mean pressures [Pa] of the history.
      real(dp), allocatable :: times(:), mean_pressures(:)
   contains
      procedure :: take_dataset
      procedure :: take_attribute
      procedure :: check_values
      procedure :: count_steps
      procedure :: describe_case
      procedure :: describe_doubts
      procedure :: derive_quantities
      procedure :: measure
      procedure :: solve_point
   end type surface_time_t

contains

   !> The model with its tables.
   subroutine new_surface_time(self)
      !> Receives its names and its tables.
      type(surface_time_t), intent(out) :: self
      integer :: k

      call new_sliding_model(self%relaxed)
      self%name = 'surface_time'
      self%summary = 'a rigid periodic surface on a viscoelastic half-space in time: growth of the area of contact'
      self%references = 'E. H. Lee, J. R. M. Radok, J. Appl. Mech. 27 (1960) 438'
      allocate (self%variables(n_variables))
      do k = 1, size(surface_rows)
         self%variables(k) = self%relaxed%variables(surface_rows(k))
      end do
      self%variables(before_solid) = tolerance_row()
      call set_spectrum_rows(self%variables(before_solid + 1:before_history))
      call set_history_rows(self%variables(before_history + 1:))
      allocate (self%results(n_ageing_results), self%profiles(n_ageing_profiles), self%counts(1))
      call set_ageing_results(self%results, self%profiles)
      self%counts(1) = self%relaxed%counts(1)
      self%profile_axes = 'step'
   end subroutine new_surface_time

   !> See `model_t`.
   subroutine take_dataset(self, index, values, problems)
      class(surface_time_t), intent(inout) :: self
      !> Index of the list in `variables`.
      integer, intent(in) :: index
      !> Its numbers; shape `(n, n_columns)`.
      real(dp), intent(in) :: values(:, :)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      if (index == own_heights) then
         call self%relaxed%take_dataset(sliding_input%heights, values, problems)
      else if (index <= before_history) then
         call take_spectrum(self%given, index - before_solid, values)
         call self%relaxed%take_dataset(n_surface_rows + 1 + index - before_solid, values, problems)
      else if (index == before_history + in%times) then
         self%times = values(:, 1)
      else
         self%mean_pressures = values(:, 1)
      end if
   end subroutine take_dataset

   !> See `model_t`: the temperature of a master curve.
   subroutine take_attribute(self, index, name, value, problems)
      class(surface_time_t), intent(inout) :: self
      !> Index of the variable.
      integer, intent(in) :: index
      !> Name of the attribute, and its value in SI units.
      character(*), intent(in) :: name
      real(dp), intent(in) :: value
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      call take_spectrum_attribute(self%given, self%variables(index), index - before_solid, name, value, problems)
      call self%relaxed%take_attribute(n_surface_rows + 1 + index - before_solid, name, value, problems)
   end subroutine take_attribute

   !> Values of `surface_sliding` for the surface at rest under a mean pressure.
   pure function relaxed_values(self, values, mean_pressure) result(inner)
      class(surface_time_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Mean pressure [Pa].
      real(dp), intent(in) :: mean_pressure
      real(dp) :: inner(size(self%relaxed%variables))

      inner = self%relaxed%variables%default
      inner(surface_rows) = values(:size(surface_rows))
      inner(self%relaxed%v_tolerance) = values(before_solid)
      associate (first => self%relaxed%first_of_solid)
         inner(first:first + n_spectrum_rows - 1) = values(before_solid + 1:before_history)
         inner(first + s_velocity - 1) = 0
      end associate
      inner(self%relaxed%before_prescribed + periodic_input%mean_pressure) = mean_pressure
   end function relaxed_values

   !> See `model_t`.
   subroutine check_values(self, values, is_swept, problems)
      class(surface_time_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      logical :: inner_swept(size(self%relaxed%variables))
      type(creep_t) :: creep
      real(dp), allocatable :: strains(:)
      real(dp) :: unit, fall
      integer :: before

      before = problems%count()
      inner_swept = .false.
      inner_swept(surface_rows) = is_swept(:size(surface_rows))
      call self%relaxed%check_surface(relaxed_values(self, values, 0.0_dp), inner_swept, problems)
      call check_spectrum(self%variables(before_solid + 1:before_history), values(before_solid + 1:before_history), self%given, &
         & is_swept(before_solid + 1:before_history), problems)
      call refuse_swept(self%variables, is_swept, [before_history + in%steps_per_leg], problems)
      call require(self%variables, values, before_history + [in%times, in%mean_pressures], problems)
      if (problems%count() > before) return
      associate (row => self%variables(before_history + in%mean_pressures))
         call check_length(row, size(self%mean_pressures), size(self%times), problems)
         if (problems%count() > before) return
         if (.not. maxval(self%mean_pressures) > 0) call problems%add(row%group, row%name, 'never presses: no value is above 0')
      end associate
      call check_times(self%times, problems)
      if (problems%count() > before) return
      call start_creep(self, values, creep, unit)
      call find_strains(self, creep, 1, strains, fall)
      if (fall < huge(fall)) call problems%add('history', 'mean_pressures', 'let the contact shrink at '//show_number(fall)// &
         & ' s, where the pressure falls faster than the solid creeps; only contacts that grow are solved')
   end subroutine check_values

   !> The solid of a point before its history, with its relaxed modulus as unit of modulus.
   pure subroutine start_creep(self, values, creep, modulus)
      class(surface_time_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the solid.
      type(creep_t), intent(out) :: creep
      !> Receives its relaxed modulus [Pa].
      real(dp), intent(out) :: modulus
      type(prony_t) :: solid, reduced

      associate (rows => values(before_solid + 1:before_history))
         call get_spectrum(rows, self%given, solid)
         modulus = solid%relaxed
         call new_prony(reduced, 1.0_dp, solid%moduli/modulus, solid%times*shift_factor_of(rows, self%given))
      end associate
      call new_creep(creep, reduced)
   end subroutine start_creep

   !> Pressure under which the relaxed solid has the contact of each step.
   pure subroutine find_strains(self, creep, n_per_leg, strains, fall)
      class(surface_time_t), intent(in) :: self
      !> In: at rest. Out: at the end of the history.
      type(creep_t), intent(inout) :: creep
      !> Steps of each leg.
      integer, intent(in) :: n_per_leg
      !> Receives the pressures [Pa], of the first one that is given and of each step; shape `(n_steps)`.
      real(dp), allocatable, intent(out) :: strains(:)
      !> Receives a time at which the contact shrinks [s]; enormous if there is none.
      real(dp), intent(out) :: fall
      real(dp) :: span, change, moment
      integer :: k, step
      logical :: falls

      fall = huge(fall)
      allocate (strains(1 + n_per_leg*(size(self%times) - 1)), source=not_a_number())
      call creep%jump(self%mean_pressures(1))
      strains(1) = creep%strain()
      do k = 2, size(self%times)
         span = self%times(k) - self%times(k - 1)
         change = self%mean_pressures(k) - self%mean_pressures(k - 1)
         if (span > 0) then
            call creep%find_fall(change/span, span, falls, moment)
         else
            falls = change < 0
            moment = 0
         end if
         if (falls) then
            fall = self%times(k - 1) + moment
            return
         end if
         do step = 1, n_per_leg
            if (span > 0) call creep%follow(change/span, span/n_per_leg)
            if (.not. span > 0) call creep%jump(change/n_per_leg)
            strains(1 + (k - 2)*n_per_leg + step) = creep%strain()
         end do
      end do
   end subroutine find_strains

   !> See `stepwise_model_t`: the steps that are written.
   pure integer function count_steps(self, values)
      class(surface_time_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      count_steps = 1 + (size(self%times) - 1)*nint(values(before_history + in%steps_per_leg))
   end function count_steps

   !> See `model_t`: the solid.
   function describe_case(self, values) result(text)
      class(surface_time_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text

      text = describe_spectrum(values(before_solid + 1:before_history), self%given)
   end function describe_case

   !> See `model_t`: edges that do not meet.
   function describe_doubts(self, values) result(text)
      class(surface_time_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text

      text = self%relaxed%describe_doubts(relaxed_values(self, values, 0.0_dp))
   end function describe_doubts

   !> See `model_t`.
   function derive_quantities(self, values) result(derived)
      class(surface_time_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(derived_t), allocatable :: derived(:)

      allocate (derived(0))
      call derive_spectrum(derived, values(before_solid + 1:before_history), self%given)
   end function derive_quantities

   !> See `model_t`: the slope of the surface.
   subroutine measure(self, values, results, measures)
      class(surface_time_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> What `solve_point` has found; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> In: all `not_measured`. Out: with what is measured; shape `(n_doubts)`.
      real(dp), intent(inout) :: measures(:)
      real(dp) :: inner(size(self%relaxed%results))

      inner = not_a_number()
      call self%relaxed%measure(relaxed_values(self, values, 0.0_dp), inner, measures)
      associate (unused => results)
      end associate
   end subroutine measure

   !> See `pointwise_model_t`.
   subroutine solve_point(self, values, state, results, error_estimate, status, counts)
      class(surface_time_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the steps, for the profiles; nothing is taken from the point before.
      class(point_state_t), allocatable, intent(inout) :: state
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Largest relative error of the area of contact of all steps.
      real(dp), intent(out) :: error_estimate
      !> One of `status_...`.
      integer, intent(out) :: status
      !> The iterations of all steps are added.
      real(dp), intent(inout) :: counts(:)
      type(creep_t) :: creep
      type(steps_t), allocatable :: found
      class(point_state_t), allocatable :: inner_state
      real(dp) :: unit, fall, error, inner(size(self%relaxed%results))
      real(dp), allocatable :: strains(:)
      integer :: k, first

      error_estimate = 0
      status = status_no_equilibrium
      call start_creep(self, values, creep, unit)
      call find_strains(self, creep, nint(values(before_history + in%steps_per_leg)), strains, fall)
      if (fall < huge(fall)) return
      first = findloc(strains > 0, .true., 1)
      allocate (found)
      allocate (found%steps(size(strains), size(self%profiles)), source=0.0_dp)
      call write_times(self, nint(values(before_history + in%steps_per_leg)), found%steps)
      found%steps(:, p_elastic) = strains
      results(out%contact_violation) = 0
      do k = first, size(strains)
         inner = not_a_number()
         call self%relaxed%solve_point(relaxed_values(self, values, strains(k)), inner_state, inner, error, status, counts)
         if (status /= status_solved) return
         if (self%is_stopped()) return
         error_estimate = max(error_estimate, error)
         found%steps(k, p_penetration) = inner(periodic_output%penetration)
         found%steps(k, p_fraction) = inner(periodic_output%contact_fraction)
         found%steps(k, p_smooth) = inner(sliding_output%smooth_fraction)
         found%steps(k, p_gap) = inner(periodic_output%mean_gap)
         results(out%contact_violation) = max(results(out%contact_violation), inner(periodic_output%contact_violation))
      end do
      ! before the first load the bodies touch at the highest summit: the gap is what the mean of the surface is away from it
      found%steps(:first - 1, p_gap) = found%steps(first, p_gap) + found%steps(first, p_penetration)
      associate (last => found%steps(size(strains), :))
         results(out%last_fraction) = last(p_fraction)
         results(out%last_smooth_fraction) = last(p_smooth)
         results(out%last_penetration) = last(p_penetration)
         results(out%growth) = last(p_fraction)/found%steps(first, p_fraction)
      end associate
      call move_alloc(found, state)
   end subroutine solve_point

   !> Times and mean pressures of the steps.
   pure subroutine write_times(self, n_per_leg, steps)
      class(surface_time_t), intent(in) :: self
      !> Steps of each leg.
      integer, intent(in) :: n_per_leg
      !> Receives them; shape `(n_steps, n_profiles)`.
      real(dp), intent(inout) :: steps(:, :)
      real(dp) :: share
      integer :: k, step

      steps(1, p_time) = self%times(1)
      steps(1, p_pressure) = self%mean_pressures(1)
      do k = 2, size(self%times)
         do step = 1, n_per_leg
            share = real(step, dp)/n_per_leg
            associate (row => 1 + (k - 2)*n_per_leg + step)
               steps(row, p_time) = self%times(k - 1)*(1 - share) + self%times(k)*share
               steps(row, p_pressure) = self%mean_pressures(k - 1)*(1 - share) + self%mean_pressures(k)*share
            end associate
         end do
      end do
   end subroutine write_times

end module adfric_periodic_surface_time

! SPDX-License-Identifier: GPL-3.0-or-later
!> The viscoelastic material of a half-space or a layer as an input gives it: a relaxation spectrum of contact moduli E/(1 - nu^2),
!> with nu constant, and the temperature that shifts its times. Every model with such a material has these rows in its table, one
!> behind the other, and reads them here; what stands in lists and datasets it keeps in a `given_spectrum_t`.
!>
!> The relaxed modulus and those of the arms are given either as contact moduli or as Young's moduli with Poisson's ratio. A master
!> curve is one of Young's modulus where Poisson's ratio stands beside it, and one of the contact modulus where it does not. Without
!> arms and master curve the material is elastic.
module adfric_solid_spectrum_rows
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_solid_contact_modulus, only: check_contact_modulus, contact_modulus_of, n_one_body, plane_strain_modulus, &
      & set_modulus_rows
   use adfric_solid_given_spectrum, only: given_spectrum_t, set_arm_rows, fit_given_curve, check_numbers_of_arms, check_curve, &
      & check_fit, describe_arms, describe_fit, doubt_range, n_arm_rows
   use adfric_solid_master_curve, only: master_curve_fit_t
   use adfric_solid_prony, only: prony_t, new_prony, instantaneous_modulus, most_arms
   use adfric_solid_shift_rows, only: set_shift_rows, time_temperature_of, check_shift, n_shift_rows
   use adfric_solid_time_temperature, only: time_temperature_t
   use adfric_describe_check, only: require, refuse_given
   use adfric_describe_derived, only: derived_t, add_derived
   use adfric_describe_rows, only: above_zero, list_row, positive
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: set_spectrum_rows, take_spectrum, take_spectrum_attribute, has_spectrum, check_spectrum, get_spectrum
   public :: is_same_spectrum, shift_factor_of, solid_shift_of, poisson_ratio_of, describe_spectrum, doubt_spectrum, derive_spectrum
   public :: n_spectrum_rows, spectrum_names, needs_velocity, get_spectrum_slopes

   !> Indices among the rows; the last one stands in the group of the operating conditions.
   integer, parameter :: modulus = 1, young_modulus = 2, poisson_ratio = 3, moduli = 4, young_moduli = 5, relaxation_times = 6, &
      & master_curve = 7, relaxed_modulus = 8, terms_per_decade = 9, time_factor = 10, shift = 11, activation_energy = 15, &
      & temperature = 16
   !> Number of rows.
   integer, parameter :: n_spectrum_rows = temperature
   !> Names of the rows of the spectrum, and of all of them.
   character(*), parameter :: modulus_names = 'modulus young_modulus poisson_ratio moduli young_moduli relaxation_times ' &
      & //'master_curve relaxed_modulus terms_per_decade'
   character(*), parameter :: shift_names = 'shift reference_temperature wlf_c1 wlf_c2 activation_energy temperature'
   character(*), parameter :: spectrum_names = modulus_names//' time_factor '//shift_names
   !> Why a contact over a viscoelastic solid needs a velocity.
   character(*), parameter :: needs_velocity = 'the body slides here. For a contact at rest on a half-space give &history times'
   !> The instantaneous modulus over the relaxed one, beyond which either is an input's mistake: the pairs of numbers that retardation
   !> times are found with have digits up to 1e32.
   real(dp), parameter :: largest_ratio = 1.0e30_dp

contains

   !> The rows of the spectrum, in the group `material`, and of the temperature, in the group `operating`.
   subroutine set_spectrum_rows(rows)
      !> Receives the rows; shape `(n_spectrum_rows)`.
      type(variable_t), intent(out) :: rows(:)
      character(*), parameter :: group = 'material'

      call set_modulus_rows(positive(group=group, name='', unit='Pa', meaning=''), rows(modulus:poisson_ratio))
      rows(modulus)%name = 'modulus'
      rows(modulus)%meaning = 'relaxed contact modulus E0 = E/(1 - nu^2)'
      rows(young_modulus)%meaning = 'relaxed Young''s modulus, instead of modulus'
      rows(poisson_ratio)%meaning = 'Poisson''s ratio nu, constant; beside master_curve: the curve is one of Young''s modulus'
      rows(moduli) = list_row(group=group, name='moduli', unit='Pa', &
         & meaning='contact moduli of arms beside the relaxed modulus, one for each of relaxation_times', lower=0.0_dp, &
         & least_count=1, most_count=most_arms)
      call set_arm_rows(group, rows(young_moduli:young_moduli + n_arm_rows - 1))
      call set_shift_rows(group, rows(shift:shift + n_shift_rows - 1))
      rows(temperature) = above_zero(group='operating', name='temperature', unit='K', &
         & meaning='temperature of the material; shift needs it')
   end subroutine set_spectrum_rows

   !> Keep the values of a list or a dataset; nothing of a variable that is none of the rows.
   subroutine take_spectrum(given, index, values)
      !> Receives the values.
      class(given_spectrum_t), intent(inout) :: given
      !> Index of the variable among the rows, from 1.
      integer, intent(in) :: index
      !> The values in SI units; shape `(n, n_columns)`.
      real(dp), intent(in) :: values(:, :)

      select case (index)
      case (moduli)
         given%moduli = values(:, 1)
      case (young_moduli)
         given%young_moduli = values(:, 1)
      case (relaxation_times)
         given%relaxation_times = values(:, 1)
      case (master_curve)
         given%master_curve = values
      end select
   end subroutine take_spectrum

   !> Keep the temperature that a master curve says of itself; nothing of a variable that is none of the rows.
   subroutine take_spectrum_attribute(given, row, index, name, value, problems)
      !> Receives the value.
      class(given_spectrum_t), intent(inout) :: given
      !> Row of the variable; its name is part of the message.
      type(variable_t), intent(in) :: row
      !> Index of the variable among the rows, from 1.
      integer, intent(in) :: index
      !> Name of the attribute.
      character(*), intent(in) :: name
      !> Its value in SI units.
      real(dp), intent(in) :: value
      !> Receives what is wrong with it.
      type(problems_t), intent(inout) :: problems

      if (index /= master_curve) return
      given%master_temperature = value
      if (.not. value > 0) call problems%add(row%group, row%name, 'has an attribute '//name//' that is not > 0')
   end subroutine take_spectrum_attribute

   !> Is anything of the group `material` given?
   pure logical function has_spectrum(values)
      !> Values of the rows; shape `(n_spectrum_rows)`.
      real(dp), intent(in) :: values(:)

      has_spectrum = any(is_set(values(:activation_energy)))
   end function has_spectrum

   !> Are there relaxation times, as a list or by a master curve? Their moduli may be 0.
   pure logical function has_times(values)
      !> Values of the rows; shape `(n_spectrum_rows)`.
      real(dp), intent(in) :: values(:)

      has_times = is_set(values(relaxation_times)) .or. is_set(values(master_curve))
   end function has_times

   !> Add to `problems` what is missing, stands beside another, or is impossible.
   subroutine check_spectrum(rows, values, given, is_swept, problems)
      !> The rows of `set_spectrum_rows`; their names are part of the messages.
      type(variable_t), intent(in) :: rows(:)
      !> Values of the rows; shape `(n_spectrum_rows)`.
      real(dp), intent(in) :: values(:)
      !> Lists and datasets of the input.
      class(given_spectrum_t), intent(in) :: given
      !> Is the variable swept? Shape `(n_spectrum_rows)`.
      logical, intent(in) :: is_swept(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: before

      before = problems%count()
      if (is_set(values(master_curve))) then
         call refuse_given(rows, values, is_swept, [modulus, young_modulus, moduli, young_moduli, relaxation_times], &
            & 'stands beside master_curve, which gives all moduli and times', problems)
      else
         call check_contact_modulus(rows(modulus:poisson_ratio), values(modulus:poisson_ratio), problems, .false.)
         call check_lists(rows, values, given, is_swept, problems)
      end if
      if (has_times(values)) then
         call check_shift(rows, values, is_swept, shift, temperature, given%master_temperature, problems)
      else
         call refuse_given(rows, values, is_swept, [time_factor, shift, temperature], &
            & 'has no meaning without relaxation_times or master_curve', problems)
      end if
      if (problems%count() == before) call check_numbers(rows, values, given, problems)
   end subroutine check_spectrum

   !> Add to `problems` lists that do not go together.
   subroutine check_lists(rows, values, given, is_swept, problems)
      !> The rows of `set_spectrum_rows`; their names are part of the messages.
      type(variable_t), intent(in) :: rows(:)
      !> Values of the rows; shape `(n_spectrum_rows)`.
      real(dp), intent(in) :: values(:)
      class(given_spectrum_t), intent(in) :: given
      !> Is the variable swept? Shape `(n_spectrum_rows)`.
      logical, intent(in) :: is_swept(:)
      type(problems_t), intent(inout) :: problems

      call refuse_given(rows, values, is_swept, [relaxed_modulus, terms_per_decade], 'has no meaning without master_curve', &
         & problems)
      if (.not. is_set(values(relaxation_times))) then
         call refuse_given(rows, values, is_swept, [moduli, young_moduli], 'needs relaxation_times', problems)
      else if (is_set(values(modulus))) then
         call refuse_given(rows, values, is_swept, [young_moduli], &
            & 'stands beside modulus; give modulus and moduli, or young_modulus, young_moduli and poisson_ratio', problems)
         call require(rows, values, [moduli], problems)
      else if (is_set(values(young_modulus))) then
         call refuse_given(rows, values, is_swept, [moduli], 'needs modulus; young_moduli stand beside young_modulus', problems)
         call require(rows, values, [young_moduli], problems)
      end if
      call check_numbers_of_arms(rows(moduli), rows(young_moduli), given, problems)
   end subroutine check_lists

   !> Add to `problems` what is possible value by value, and no solid.
   subroutine check_numbers(rows, values, given, problems)
      !> The rows of `set_spectrum_rows`; their names are part of the messages.
      type(variable_t), intent(in) :: rows(:)
      !> Values of the rows; shape `(n_spectrum_rows)`.
      real(dp), intent(in) :: values(:)
      class(given_spectrum_t), intent(in) :: given
      type(problems_t), intent(inout) :: problems
      type(prony_t) :: prony
      type(master_curve_fit_t) :: fit
      integer, parameter :: relaxed_indices(4) = [relaxed_modulus, modulus, young_modulus, master_curve]
      integer :: before, index

      before = problems%count()
      if (is_set(values(master_curve))) call check_curve(rows(master_curve), rows(relaxed_modulus), &
         & values(relaxed_modulus), given, problems)
      if (problems%count() > before) return
      call get_spectrum(values, given, prony, fit)
      if (is_set(values(master_curve))) call check_fit(rows(master_curve), fit, problems)
      if (problems%count() > before) return
      index = relaxed_indices(findloc(is_set(values(relaxed_indices)), .true., 1))
      if (.not. (prony%relaxed > tiny(1.0_dp) .and. prony%relaxed > instantaneous_modulus(prony)/largest_ratio)) &
         & call problems%add(rows(index)%group, rows(index)%name, 'is too small, or other moduli are too large')
   end subroutine check_numbers

   !> The spectrum of contact moduli, with its times as they were measured.
   pure subroutine get_spectrum(values, given, prony, fit)
      !> Values of the rows, which have been checked; shape `(n_spectrum_rows)`.
      real(dp), intent(in) :: values(:)
      !> Lists and datasets of the input.
      class(given_spectrum_t), intent(in) :: given
      !> Receives the spectrum [Pa, s]; at the temperature its times are these times `shift_factor_of`.
      type(prony_t), intent(out) :: prony
      !> Receives the fit of a master curve, if one is given.
      type(master_curve_fit_t), intent(out), optional :: fit
      type(master_curve_fit_t) :: fitted
      real(dp) :: per_modulus

      ! the contact modulus of a body whose Young's modulus is 1
      per_modulus = 1
      if (is_set(values(poisson_ratio))) per_modulus = plane_strain_modulus(1.0_dp, values(poisson_ratio))
      if (is_set(values(master_curve))) then
         call fit_given_curve(given, values(relaxed_modulus), values(terms_per_decade), fitted)
         call new_prony(prony, fitted%prony%relaxed*per_modulus, fitted%prony%moduli*per_modulus, fitted%prony%times)
         if (present(fit)) fit = fitted
         return
      end if
      associate (relaxed => contact_modulus_of(values(:n_one_body)))
         if (.not. is_set(values(relaxation_times))) then
            call new_prony(prony, relaxed, [real(dp) ::], [real(dp) ::])
         else if (is_set(values(moduli))) then
            call new_prony(prony, relaxed, given%moduli, given%relaxation_times)
         else
            call new_prony(prony, relaxed, given%young_moduli*per_modulus, given%relaxation_times)
         end if
      end associate
   end subroutine get_spectrum

   !> Derivatives of the numbers of a spectrum by one of its rows, or by a member of a list, in closed form.
   pure subroutine get_spectrum_slopes(values, given, prony, index, member, relaxed_by, moduli_by, times_by, is_known)
      !> Values of the rows, which have been checked; shape `(n_spectrum_rows)`.
      real(dp), intent(in) :: values(:)
      !> Lists and datasets of the input.
      class(given_spectrum_t), intent(in) :: given
      !> Their spectrum, as `get_spectrum` finds it.
      type(prony_t), intent(in) :: prony
      !> Index among the rows, and number of the member; 0: it is no list.
      integer, intent(in) :: index, member
      !> Receive derivatives of the relaxed modulus, and of moduli and times of the arms; shape `(n_arms)`.
      real(dp), intent(out) :: relaxed_by, moduli_by(:), times_by(:)
      !> Receives whether they are known; else they are 0.
      logical, intent(out) :: is_known
      real(dp), parameter :: round_off = 8*epsilon(1.0_dp)
      real(dp) :: per_modulus, own
      integer :: arm

      relaxed_by = 0
      moduli_by = 0
      times_by = 0
      is_known = .not. is_set(values(master_curve))
      if (.not. is_known) return
      if (member == 0) then
         is_known = index == modulus .or. index == young_modulus
         if (index == modulus) relaxed_by = 1
         if (index == young_modulus) relaxed_by = prony%relaxed/values(young_modulus)
         return
      end if
      is_known = any(index == [moduli, young_moduli, relaxation_times])
      if (.not. is_known) return
      arm = findloc(abs(prony%times - given%relaxation_times(member)) <= round_off*given%relaxation_times(member), .true., 1)
      is_known = arm > 0
      if (.not. is_known) return
      per_modulus = 1
      if (is_set(values(poisson_ratio))) per_modulus = plane_strain_modulus(1.0_dp, values(poisson_ratio))
      if (index == relaxation_times) then
         ! an arm may be two of one time
         if (is_set(values(moduli))) then
            own = given%moduli(member)
         else
            own = given%young_moduli(member)*per_modulus
         end if
         times_by(arm) = own/prony%moduli(arm)
      else
         moduli_by(arm) = merge(per_modulus, 1.0_dp, index == young_moduli)
      end if
   end subroutine get_spectrum_slopes

   !> Do two points have the same spectrum before it is shifted?
   pure logical function is_same_spectrum(values, others)
      !> Values of the rows at both points; shape `(n_spectrum_rows)`.
      real(dp), intent(in) :: values(:), others(:)

      is_same_spectrum = all(abs(values(:terms_per_decade) - others(:terms_per_decade)) <= 0)
   end function is_same_spectrum

   !> The factor of all relaxation times, by the temperature and by `time_factor` [-]. A body that slides at V over the shifted
   !> material meets what it meets at this factor times V over the one that is not.
   pure real(dp) function shift_factor_of(values, given) result(factor)
      !> Values of the rows, which have been checked; shape `(n_spectrum_rows)`.
      real(dp), intent(in) :: values(:)
      !> Lists and datasets of the input.
      class(given_spectrum_t), intent(in) :: given
      type(time_temperature_t) :: law
      logical :: is_valid

      factor = 1
      law = time_temperature_of(values(shift:shift + n_shift_rows - 1), given%master_temperature)
      if (is_set(values(temperature))) call law%get_shift_factor(values(temperature), factor, is_valid)
      if (is_set(values(time_factor))) factor = factor*values(time_factor)
   end function shift_factor_of

   !> The law by which temperature shifts all relaxation times; that of none where there is no shift.
   pure type(time_temperature_t) function solid_shift_of(values, given)
      !> Values of the rows; shape `(n_spectrum_rows)`.
      real(dp), intent(in) :: values(:)
      !> Lists and datasets of the input.
      class(given_spectrum_t), intent(in) :: given

      solid_shift_of = time_temperature_of(values(shift:shift + n_shift_rows - 1), given%master_temperature)
   end function solid_shift_of

   !> Poisson's ratio [-], or unset where it is not given.
   pure real(dp) function poisson_ratio_of(values)
      !> Values of the rows; shape `(n_spectrum_rows)`.
      real(dp), intent(in) :: values(:)

      poisson_ratio_of = values(poisson_ratio)
   end function poisson_ratio_of

   !> What `adfric check` says of the spectrum, a line each.
   function describe_spectrum(values, given) result(text)
      !> Values of the rows, which have been checked; shape `(n_spectrum_rows)`.
      real(dp), intent(in) :: values(:)
      !> Lists and datasets of the input.
      class(given_spectrum_t), intent(in) :: given
      character(:), allocatable :: text
      type(prony_t) :: prony
      type(master_curve_fit_t) :: fit

      call get_spectrum(values, given, prony, fit)
      text = ''
      if (is_set(values(master_curve))) text = describe_fit(given, fit)
      text = text//describe_arms(prony, 'contact modulus', 'Pa')
   end function describe_spectrum

   !> What in the material may not be what the user means, a line each.
   function doubt_spectrum(values, given, frequencies) result(text)
      !> Values of the rows, which have been checked; shape `(n_spectrum_rows)`.
      real(dp), intent(in) :: values(:)
      !> Lists and datasets of the input.
      class(given_spectrum_t), intent(in) :: given
      !> Lowest and highest angular frequency that the surface excites, as it is at the temperature [rad/s].
      real(dp), intent(in) :: frequencies(2)
      character(:), allocatable :: text
      type(prony_t) :: prony
      type(master_curve_fit_t) :: fit

      text = ''
      call get_spectrum(values, given, prony, fit)
      if (size(prony%moduli) == 0) text = 'the material is elastic, and nothing rubs: it has no relaxation_times or ' &
         & //'master_curve, or no moduli above 0 with them'//new_line('a')
      if (is_set(values(master_curve))) text = text//doubt_range(fit, frequencies*shift_factor_of(values, given))
   end function doubt_spectrum

   !> Add what follows from the rows: relaxed and instantaneous modulus, and the factor of the times.
   subroutine derive_spectrum(list, values, given)
      !> Receives the quantities.
      type(derived_t), allocatable, intent(inout) :: list(:)
      !> Values of the rows, which have been checked; shape `(n_spectrum_rows)`.
      real(dp), intent(in) :: values(:)
      !> Lists and datasets of the input.
      class(given_spectrum_t), intent(in) :: given
      type(prony_t) :: prony

      call get_spectrum(values, given, prony)
      call add_derived(list, 'modulus', 'Pa', 'relaxed contact modulus', prony%relaxed, modulus_names)
      call add_derived(list, 'instantaneous_modulus', 'Pa', 'instantaneous contact modulus', instantaneous_modulus(prony), &
         & modulus_names)
      if (.not. has_times(values)) return
      call add_derived(list, 'shift_factor', '-', 'factor of all relaxation times, by temperature and time_factor', &
         & shift_factor_of(values, given), 'time_factor master_curve '//shift_names)
   end subroutine derive_spectrum

end module adfric_solid_spectrum_rows

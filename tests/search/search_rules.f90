! SPDX-License-Identifier: GPL-3.0-or-later
!> What must hold of any solved case, whatever the model.
module search_rules
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_input_variable, only: is_in_range
   use adfric_describe_model, only: model_t
   use adfric_describe_status, only: status_solved, status_no_equilibrium, status_not_converged
   use adfric_describe_table, only: result_t, kind_real
   use adfric_describe_derived, only: derived_t
   use adfric_foundation_case, only: kind_map, wavy_case_t, resolve_case
   use adfric_foundation_stepped_case, only: is_stepped
   use adfric_foundation_surface, only: negligible
   use adfric_foundation_variables, only: in => foundation_input, out => foundation_output
   use model_calls, only: solve_values
   use random_dice, only: dice_t, new_dice
   use search_data, only: give_data, rescale_data
   use search_draw, only: drawn_case_t
   use search_units, only: n_dimensions, dimensions_of, unit_in_case
   implicit none (type, external)
   private
   public :: answer_t, answer_case, find_fault

   !> Balances and conditions of contact hold to this, or to what the error estimate admits.
   real(dp), parameter :: balance_digits = 1.0e-9_dp
   !> Energies in time have an error of their own, which the balance tells; where it is larger they have no value.
   real(dp), parameter :: balance_in_time = 1.0e-2_dp
   !> Two ways to the same state end as near to each other as this, and their error estimates, admit.
   real(dp), parameter :: same_state = 1.0e-8_dp, estimates = 10.0_dp
   !> Powers of two by which numbers are multiplied in other units are smaller than this.
   real(dp), parameter :: largest_power = 900
   !> Main results that have no value somewhere, each with a reason in the documents.
   character(*), parameter :: may_be_missing = ' friction_coefficient friction_force approach centre_pressure pull_off_load ' &
      & //'stick_fraction loss_time storage_modulus loss_modulus ' &
      & //'pull_off_approach frozen_pull_off_load path_work pull_off_pressure friction_stress ' &
      & //'contact_fraction_persson contact_fraction_wang_mueser mean_gap_wang_mueser normal_stiffness_wang_mueser ' &
      & //'friction_coefficient_yang_persson pull_off_pressure_yang_persson pastewka_robbins_ratio full_contact_work_ratio '

   !> Answers to the points of a case.
   type :: answer_t
      real(dp), allocatable :: results(:, :)
      real(dp), allocatable :: error_estimate(:)
      integer, allocatable :: status(:)
   end type answer_t

contains

   !> Solve the points of a case as one block.
   subroutine answer_case(model, drawn, answer)
      class(model_t), intent(in) :: model
      type(drawn_case_t), intent(in) :: drawn
      type(answer_t), intent(out) :: answer

      call solve_values(model, drawn%values, answer%results, answer%error_estimate, answer%status)
   end subroutine answer_case

   !> What is wrong with the answers; empty if nothing is.
   subroutine find_fault(model, drawn, answer, dice, fault)
      class(model_t), intent(in) :: model
      type(drawn_case_t), intent(in) :: drawn
      type(answer_t), intent(in) :: answer
      type(dice_t), intent(inout) :: dice
      character(:), allocatable, intent(out) :: fault
      type(result_t), allocatable :: results(:)
      real(dp) :: powers(n_dimensions)
      integer :: i

      ! of this size already, or gfortran 12 warns
      allocate (results(size(model%results)))
      results = model%describe_results(drawn%values(:, 1))
      fault = ''
      do i = 1, size(answer%status)
         if (len(fault) == 0) call judge_point(model%name, results, answer, i, is_under_load(model, drawn%values(:, i)), &
            & fault)
      end do
      if (len(fault) == 0) call judge_alone(model, results, drawn, answer, fault)
      if (len(fault) == 0) then
         call draw_powers_of_two(dice, powers)
         call judge_other_units(model, results, drawn, answer, powers, fault)
      end if
      ! a hard case lies within a rounding of its numbers
      if (len(fault) == 0 .and. .not. drawn%is_hard) then
         call draw_scales(drawn, powers)
         call judge_other_units(model, results, drawn, answer, powers, fault)
      end if
      if (len(fault) == 0) call judge_order(model, results, drawn, answer, fault)
      if (len(fault) == 0) call judge_profiles(model, drawn, answer, fault)
   end subroutine find_fault

   !> A state is whole, or it says that there is none.
   subroutine judge_point(model_name, results, answer, i, is_singular, fault)
      character(*), intent(in) :: model_name
      type(result_t), intent(in) :: results(:)
      type(answer_t), intent(in) :: answer
      !> Number of the point.
      integer, intent(in) :: i
      !> Is it a position without values?
      logical, intent(in) :: is_singular
      character(:), allocatable, intent(inout) :: fault
      real(dp) :: estimate
      integer :: k

      estimate = answer%error_estimate(i)
      select case (answer%status(i))
      case (status_solved)
         if (.not. ieee_is_finite(estimate)) then
            fault = at_point(i, 'error_estimate is not finite')
         else if (.not. (estimate >= 0 .and. estimate <= 1)) then
            fault = at_point(i, 'error_estimate is not in [0, 1]: '//show(estimate))
         end if
      case (status_no_equilibrium, status_not_converged)
         if (.not. ieee_is_nan(estimate)) fault = at_point(i, 'an error_estimate without a state')
      case default
         fault = at_point(i, 'no such status')
      end select
      do k = 1, size(results)
         if (len(fault) > 0) return
         associate (value => answer%results(k, i), name => results(k)%name)
            if (.not. (ieee_is_finite(value) .or. ieee_is_nan(value))) fault = at_point(i, name//' is infinite')
            if (answer%status(i) /= status_solved) cycle
            if (ieee_is_nan(value)) then
               if (results(k)%is_main .and. .not. is_singular .and. index(may_be_missing, ' '//name//' ') == 0) &
                  & fault = at_point(i, name//' has no value')
               cycle
            end if
            if (name == 'energy_imbalance' .or. name == 'contact_violation') then
               if (abs(value) > max(merge(balance_in_time, balance_digits, name == 'energy_imbalance' .and. &
                  & index(model_name, 'indenter_time') > 0), estimates*estimate)) fault = at_point(i, name//' = '//show(value))
            end if
         end associate
      end do
   end subroutine judge_point

   !> Does a given load act at the very position that is asked for? There a field has no value.
   pure logical function is_under_load(model, values)
      class(model_t), intent(in) :: model
      real(dp), intent(in) :: values(:)
      integer :: k

      is_under_load = .false.
      do k = 1, size(values)
         if (model%variables(k)%group /= 'position') cycle
         is_under_load = .true.
         if (abs(values(k)) > 0) exit
      end do
      if (k <= size(values)) is_under_load = .false.
   end function is_under_load

   !> A point alone has the answer that it has among its neighbours.
   subroutine judge_alone(model, results, drawn, answer, fault)
      class(model_t), intent(in) :: model
      type(result_t), intent(in) :: results(:)
      type(drawn_case_t), intent(in) :: drawn
      type(answer_t), intent(in) :: answer
      character(:), allocatable, intent(inout) :: fault
      type(drawn_case_t) :: single
      type(answer_t) :: alone
      integer :: i

      single%swept = drawn%swept
      do i = 1, size(answer%status)
         single%values = drawn%values(:, i:i)
         call answer_case(model, single, alone)
         call compare(model, results, drawn, answer, i, alone, 1, fault)
         if (len(fault) > 0) fault = 'alone: '//fault
         if (len(fault) > 0) return
      end do
   end subroutine judge_alone

   !> Units that are squares and cubes of powers of two cost no digits.
   subroutine draw_powers_of_two(dice, powers)
      type(dice_t), intent(inout) :: dice
      !> Of two, for Pa, m, s.
      real(dp), intent(out) :: powers(n_dimensions)
      integer :: k, number

      do k = 1, n_dimensions
         call dice%choose(7, number)
         powers(k) = 6*(number - 4)
      end do
   end subroutine draw_powers_of_two

   !> Any units: stresses, lengths and times by 1e-12 to 1e12, one at a time or all together. All numbers are rounded anew.
   subroutine draw_scales(drawn, powers)
      !> The case tells the dice, so that it stands as it was for the next one.
      type(drawn_case_t), intent(in) :: drawn
      !> Of two, for Pa, m, s; any numbers.
      real(dp), intent(out) :: powers(n_dimensions)
      real(dp), parameter :: most_decades = 12, twos = log(10.0_dp)/log(2.0_dp)
      type(dice_t) :: dice
      integer :: k, which

      call new_dice(dice, sum(abs(exponent(drawn%values))))
      call dice%choose(n_dimensions + 1, which)
      powers = 0
      do k = 1, n_dimensions
         if (which <= n_dimensions .and. which /= k) cycle
         call dice%between(-most_decades*twos, most_decades*twos, powers(k))
      end do
   end subroutine draw_scales

   !> In other units of stress, length and time everything is the same.
   subroutine judge_other_units(model, results, drawn, answer, powers, fault)
      class(model_t), intent(in) :: model
      type(result_t), intent(in) :: results(:)
      type(drawn_case_t), intent(in) :: drawn
      type(answer_t), intent(in) :: answer
      !> Of two, for Pa, m, s.
      real(dp), intent(in) :: powers(:)
      character(:), allocatable, intent(inout) :: fault
      type(drawn_case_t) :: other
      class(model_t), allocatable :: other_model
      type(answer_t) :: scaled
      logical :: is_valid
      integer :: i, k

      call rescale(model, drawn, powers, other, is_valid)
      if (.not. is_valid) return
      if (size(other%data) > 0) then
         allocate (other_model, source=model)
         call give_data(other_model, other%data, is_valid)
         if (.not. is_valid) return
         call answer_case(other_model, other, scaled)
      else
         call answer_case(model, other, scaled)
      end if
      do k = 1, size(results)
         associate (power => dot_product(powers, dimensions_of(results(k)%unit)))
            scaled%results(k, :) = scaled%results(k, :)*2.0_dp**(-power)
         end associate
      end do
      do i = 1, size(answer%status)
         call compare(model, results, drawn, answer, i, scaled, i, fault)
         if (len(fault) > 0) fault = 'in units '//show(2**powers(1))//' Pa, '//show(2**powers(2))//' m, '//show(2**powers(3))// &
            & ' s: '//fault
         if (len(fault) > 0) return
      end do
   end subroutine judge_other_units

   !> The same case in other units, if the model takes it.
   subroutine rescale(model, drawn, powers, other, is_valid)
      class(model_t), intent(in) :: model
      type(drawn_case_t), intent(in) :: drawn
      !> Of two, for Pa, m, s.
      real(dp), intent(in) :: powers(:)
      type(drawn_case_t), intent(out) :: other
      logical, intent(out) :: is_valid
      type(problems_t) :: problems
      logical :: is_swept(size(drawn%values, 1))
      real(dp) :: power
      integer :: i, k

      other = drawn
      ! the unit of a coefficient of r^n, or of t^-n, would change from point to point
      is_valid = all(model%variables(drawn%swept)%name /= [character(18) :: 'exponent', 'power_law_exponent'])
      do k = 1, size(other%values, 1)
         associate (v => model%variables(k))
            if (v%kind /= kind_real .or. .not. is_set(drawn%values(k, 1))) cycle
            power = dot_product(powers, dimensions_of(unit_in_case(model, drawn%values(:, 1), k)))
            ! no number holds the coefficient of a high power of r in all units
            is_valid = is_valid .and. abs(power) < largest_power
            if (.not. is_valid) return
            ! a default with a unit is a number like any other
            other%values(k, :) = other%values(k, :)*2.0_dp**power
            is_valid = is_valid .and. all(is_in_range(other%values(k, :), v))
         end associate
      end do
      if (.not. is_valid) return
      call rescale_data(model, powers, other%data)
      is_swept = .false.
      is_swept(other%swept) = .true.
      do i = 1, size(other%values, 2)
         call model%check_values(other%values(:, i), is_swept, problems)
      end do
      is_valid = problems%count() == 0
   end subroutine rescale

   !> Are two answers to one question the same?
   subroutine compare(model, results, drawn, one, i, two, j, fault)
      class(model_t), intent(in) :: model
      type(result_t), intent(in) :: results(:)
      type(drawn_case_t), intent(in) :: drawn
      type(answer_t), intent(in) :: one, two
      !> Numbers of the points.
      integer, intent(in) :: i, j
      character(:), allocatable, intent(inout) :: fault
      real(dp) :: tolerance
      integer :: k

      ! an answer that gives up is honest from either side
      if (one%status(i) == status_not_converged .or. two%status(j) == status_not_converged) return
      if (one%status(i) /= two%status(j)) then
         fault = at_point(i, 'one is solved, the other is not')
         return
      end if
      if (one%status(i) /= status_solved) return
      tolerance = same_state + estimates*(one%error_estimate(i) + two%error_estimate(j))
      do k = 1, size(results)
         if (.not. results(k)%is_main .or. results(k)%n_states() > 0) cycle
         ! differences of nearly equal loads; `tests/program/time_scenes.py` is about them
         if (results(k)%name == 'storage_modulus' .or. results(k)%name == 'loss_modulus') cycle
         associate (a => one%results(k, i), b => two%results(k, j))
            if (ieee_is_nan(a) .neqv. ieee_is_nan(b)) then
               fault = at_point(i, results(k)%name//' has a value in one of them only')
               return
            end if
            if (ieee_is_nan(a)) cycle
            if (abs(a - b) > tolerance*max(abs(a), abs(b), least_size(model, results, drawn%values(:, i), one%results(:, i), &
               & k))) then
               fault = at_point(i, results(k)%name//' is '//show(a)//' and '//show(b)//', estimates '// &
                  & show(one%error_estimate(i))//' and '//show(two%error_estimate(j)))
               return
            end if
         end associate
      end do
   end subroutine compare

   !> What a difference of a result is measured by, where the result itself is smaller: a component of a field by the whole
   !> field; load and approach of a contact by a share of those of pull-off (`docs/theory/round_branches.md`); load and friction of a wave by a
   !> share of the tractions they are made of, and friction that is nothing beside the load by that (`docs/theory/columns_strips.md`).
   real(dp) function least_size(model, results, values, found, k) result(least)
      class(model_t), intent(in) :: model
      type(result_t), intent(in) :: results(:)
      real(dp), intent(in) :: values(:), found(:)
      !> Number of the result.
      integer, intent(in) :: k
      real(dp), parameter :: share_of_pull_off = 0.06_dp
      integer :: i

      least = 0
      if (model%index_of('position', 'position_x') > 0) then
         do i = 1, size(results)
            if (results(i)%unit == results(k)%unit .and. .not. ieee_is_nan(found(i))) least = max(least, abs(found(i)))
         end do
      else if (model%name == 'wavy_sliding') then
         least = least_wavy_size(model, values, found, k)
      else
         do i = 1, size(results)
            if (results(i)%name /= 'pull_off_'//results(k)%name .or. ieee_is_nan(found(i))) cycle
            least = share_of_pull_off*abs(found(i))
         end do
      end if
   end function least_size

   !> The same for the wavy surface.
   real(dp) function least_wavy_size(model, values, found, k) result(least)
      class(model_t), intent(in) :: model
      real(dp), intent(in) :: values(:), found(:)
      integer, intent(in) :: k
      real(dp), parameter :: share_of_scale = 0.01_dp, round_off = 8*epsilon(1.0_dp)
      type(wavy_case_t) :: case
      real(dp) :: adhesion, steepness

      adhesion = 0
      if (is_set(values(in%stress))) adhesion = values(in%stress)*(found(out%contact_area) + found(out%adhesion_area))
      if (is_stepped(values)) then
         case%period = derived_value(model, values, 'period')
         case%height = derived_value(model, values, 'height')
         case%load_unit = derived_value(model, values, 'pressure_unit')*case%period
         if (nint(values(in%kind)) == kind_map) case%load_unit = case%load_unit/case%period*(found(out%contact_area) + &
            & found(out%adhesion_area))
      else
         call resolve_case(values, case)
      end if
      steepness = case%height/case%period
      least = 0
      select case (k)
      case (out%load)
         least = share_of_scale*adhesion
      case (out%penetration)
         ! a load within its tolerance
         if (case%load_unit > 0) least = (abs(found(out%load)) + adhesion)/case%load_unit*case%height
         ! a load below the round-off of the pressure that a height makes does not tell how far the surface is away
         if (abs(found(out%load)) <= round_off*case%load_unit) least = case%height/same_state
      case (out%friction_force)
         least = max(negligible*abs(found(out%load)), share_of_scale*adhesion)*steepness
      case (out%friction_coefficient)
         least = negligible*steepness
         if (abs(found(out%load)) > 0) least = max(least, share_of_scale*adhesion*(steepness + abs(found(k)))/abs(found(out%load)))
      end select
   end function least_wavy_size

   !> A quantity that follows from the values.
   real(dp) function derived_value(model, values, name) result(value)
      class(model_t), intent(in) :: model
      real(dp), intent(in) :: values(:)
      character(*), intent(in) :: name
      type(derived_t), allocatable :: derived(:)
      integer :: i

      value = 0
      allocate (derived, source=model%derive_quantities(values))
      do i = 1, size(derived)
         if (derived(i)%name == name) value = derived(i)%value
      end do
   end function derived_value

   !> What must not fall as the swept variable rises.
   subroutine judge_order(model, results, drawn, answer, fault)
      class(model_t), intent(in) :: model
      type(result_t), intent(in) :: results(:)
      type(drawn_case_t), intent(in) :: drawn
      type(answer_t), intent(in) :: answer
      character(:), allocatable, intent(inout) :: fault
      character(*), parameter :: rising(3, 10) = reshape([character(20) :: &
         & 'wavy_sliding', 'load', 'penetration', &
         & 'hertz', 'load', 'contact_half_width', &
         & 'rigid_punch', 'load', 'contact_half_width', &
         & 'wave_1d', 'mean_pressure', 'penetration', &
         & 'wave_1d', 'mean_pressure', 'contact_fraction', &
         & 'wave_2d_elastic', 'mean_pressure', 'penetration', &
         & 'wave_2d_elastic', 'mean_pressure', 'contact_fraction', &
         & 'surface_elastic', 'mean_pressure', 'penetration', &
         & 'free_surface', 'load', 'approach', &
         & 'free_surface', 'approach', 'load'], [3, 10])
      real(dp) :: last, error
      integer :: row, k, i
      logical :: is_first

      do row = 1, size(rising, 2)
         if (rising(1, row) /= model%name .or. rising(2, row) /= model%variables(drawn%swept)%name) cycle
         k = findloc([(results(i)%name == rising(3, row), i=1, size(results))], .true., 1)
         last = 0
         error = 0
         is_first = .true.
         do i = 1, size(answer%status)
            if (answer%status(i) /= status_solved) cycle
            associate (value => answer%results(k, i))
               error = max(error, same_state + estimates*answer%error_estimate(i))
               if (is_first) last = value
               is_first = .false.
               if (last - value > error*max(abs(value), abs(last))) fault = at_point(i, results(k)%name//' falls from '// &
                  & show(last)//' to '//show(value))
               last = max(last, value)
            end associate
         end do
      end do
   end subroutine judge_order

   !> Profiles of solved points are numbers or have no value.
   subroutine judge_profiles(model, drawn, answer, fault)
      class(model_t), intent(in) :: model
      type(drawn_case_t), intent(in) :: drawn
      type(answer_t), intent(in) :: answer
      character(:), allocatable, intent(inout) :: fault
      real(dp), allocatable :: profiles(:, :, :)
      integer :: i, n(3)

      if (.not. model%wants_profiles(drawn%values(:, 1))) return
      do i = 1, size(answer%status)
         if (answer%status(i) /= status_solved) cycle
         n = model%profile_shape(drawn%values(:, i))
         allocate (profiles(n(1), n(2), n(3)))
         call model%solve_profiles(drawn%values(:, i), answer%results(:, i), profiles)
         if (any(.not. (ieee_is_finite(profiles) .or. ieee_is_nan(profiles)))) fault = at_point(i, 'a profile is infinite')
         deallocate (profiles)
      end do
   end subroutine judge_profiles

   function at_point(i, text) result(line)
      integer, intent(in) :: i
      character(*), intent(in) :: text
      character(:), allocatable :: line
      character(12) :: number

      write (number, '(i0)') i
      line = 'point '//trim(number)//': '//text
   end function at_point

   function show(value) result(text)
      real(dp), intent(in) :: value
      character(:), allocatable :: text
      character(32) :: buffer

      write (buffer, '(es17.9e3)') value
      text = trim(adjustl(buffer))
   end function show

end module search_rules

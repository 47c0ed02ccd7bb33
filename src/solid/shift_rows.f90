! SPDX-License-Identifier: GPL-3.0-or-later
!> The law by which temperature shifts relaxation times, as an input gives it. Every model with such a law has these rows in its
!> table, one behind the other, and a row for the temperature among its operating conditions.
module adfric_solid_shift_rows
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_base_words, only: get_word
   use adfric_solid_time_temperature, only: time_temperature_t, shift_none, shift_wlf, shift_arrhenius
   use adfric_describe_check, only: require, refuse_given
   use adfric_describe_rows, only: above_zero, choice
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: set_shift_rows, time_temperature_of, check_shift, n_shift_rows

   !> Number of rows.
   integer, parameter :: n_shift_rows = 5
   !> Indices among the rows.
   integer, parameter :: shift = 1, reference_temperature = 2, wlf_c1 = 3, wlf_c2 = 4, activation_energy = 5

contains

   !> The rows of the law.
   subroutine set_shift_rows(group, rows)
      !> Namelist group of the rows, without `&`.
      character(*), intent(in) :: group
      !> Receives the rows; shape `(n_shift_rows)`.
      type(variable_t), intent(out) :: rows(:)

      rows(shift) = choice(group=group, name='shift', &
         & meaning='law by which temperature changes all relaxation times; none if not given', choices='none wlf arrhenius')
      rows(reference_temperature) = above_zero(group=group, name='reference_temperature', unit='K', &
         & meaning='temperature at which the relaxation times hold; that of the master curve if not given')
      rows(wlf_c1) = above_zero(group=group, name='wlf_c1', unit='-', meaning='constant c1 of WLF, log10 of the factor')
      rows(wlf_c2) = above_zero(group=group, name='wlf_c2', unit='K', meaning='constant c2 of WLF')
      rows(activation_energy) = above_zero(group=group, name='activation_energy', unit='J/mol', &
         & meaning='activation energy of Arrhenius'' law')
   end subroutine set_shift_rows

   !> The law that the values say.
   pure type(time_temperature_t) function time_temperature_of(values, master_temperature) result(law)
      !> Values of the rows; shape `(n_shift_rows)`.
      real(dp), intent(in) :: values(:)
      !> Temperature that a master curve comes with [K], or unset; `reference_temperature` goes before it.
      real(dp), intent(in) :: master_temperature

      law%law = law_of(values)
      if (is_set(master_temperature)) law%reference_temperature = master_temperature
      if (is_set(values(reference_temperature))) law%reference_temperature = values(reference_temperature)
      if (is_set(values(wlf_c1))) law%c1 = values(wlf_c1)
      if (is_set(values(wlf_c2))) law%c2 = values(wlf_c2)
      if (is_set(values(activation_energy))) law%activation_energy = values(activation_energy)
   end function time_temperature_of

   !> Which law is it, one of `shift_...`?
   pure integer function law_of(values)
      !> Values of the rows; shape `(n_shift_rows)`.
      real(dp), intent(in) :: values(:)

      law_of = shift_none
      ! the words of the choice stand in the order of the laws
      if (is_set(values(shift))) law_of = nint(values(shift)) - 1
   end function law_of

   !> Add to `problems` what is missing, has no meaning, or lies beyond the law.
   subroutine check_shift(variables, values, is_swept, first, temperature, master_temperature, problems)
      !> Table of the variables; their names are part of the messages.
      type(variable_t), intent(in) :: variables(:)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      !> Index of the first row of `set_shift_rows` in the table, and that of the temperature.
      integer, intent(in) :: first, temperature
      !> Temperature that a master curve comes with [K], or unset.
      real(dp), intent(in) :: master_temperature
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: reference, before

      before = problems%count()
      reference = first - 1 + reference_temperature
      associate (c1 => first - 1 + wlf_c1, c2 => first - 1 + wlf_c2, energy => first - 1 + activation_energy)
         select case (law_of(values(first:)))
         case (shift_none)
            call refuse_given(variables, values, is_swept, [temperature, reference, c1, c2, energy], &
               & 'has no meaning without shift', problems)
            return
         case (shift_wlf)
            call require(variables, values, [c1, c2, temperature], problems)
            call refuse_given(variables, values, is_swept, [energy], 'has no meaning for shift = ''wlf''', problems)
         case (shift_arrhenius)
            call require(variables, values, [energy, temperature], problems)
            call refuse_given(variables, values, is_swept, [c1, c2], 'has no meaning for shift = ''arrhenius''', problems)
         end select
      end associate
      if (.not. (is_set(values(reference)) .or. is_set(master_temperature))) call problems%add(variables(reference)%group, &
         & variables(reference)%name, 'is missing [K]; shift = ''' &
         & //get_word(variables(first)%choices, nint(values(first)))//''' needs it')
      if (problems%count() > before) return
      call check_range(variables(temperature), values(temperature), &
         & time_temperature_of(values(first:first + n_shift_rows - 1), master_temperature), problems)
   end subroutine check_shift

   !> Add to `problems` a temperature at which the law does not hold.
   subroutine check_range(row, temperature, law, problems)
      !> Row of the temperature; its name is part of the message.
      type(variable_t), intent(in) :: row
      !> The temperature [K].
      real(dp), intent(in) :: temperature
      type(time_temperature_t), intent(in) :: law
      type(problems_t), intent(inout) :: problems
      real(dp) :: factor
      logical :: is_valid

      call law%get_shift_factor(temperature, factor, is_valid)
      if (.not. is_valid) call problems%add(row%group, row%name, &
         & 'is out of the range of the law of the shift (for WLF, above T0 - c2)')
   end subroutine check_range

end module adfric_solid_shift_rows

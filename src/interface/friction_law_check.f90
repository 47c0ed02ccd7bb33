! SPDX-License-Identifier: GPL-3.0-or-later
!> What an input may not say of the law of an interface.
module adfric_interface_friction_law_check
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_base_words, only: get_word, has_word
   use adfric_interface_friction_law, only: friction_law_t, law_activated, law_constant, law_table
   use adfric_interface_friction_law_rows, only: given_law_t, get_friction_law, i_barrier_power, i_energy, i_law, &
      & i_pressure_factor, i_reference, i_shift, i_strength, i_table, law_of, n_interface_rows, needs_temperature, words_of_law
   use adfric_interface_shear_strength_rows, only: check_shear, n_shear_rows
   use adfric_solid_shift_rows, only: check_shift
   use adfric_solid_time_temperature, only: shift_none, time_temperature_t
   use adfric_describe_check, only: require
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: check_interface

   !> First word of `shift`.
   integer, parameter :: as_material = 1

contains

   !> Add to `problems` what is missing, has no meaning for the law, or lies beyond it.
   subroutine check_interface(table, values_of_table, of_interface, of_operating, given, of_solid, tension, problems)
      !> Rows with those of an interface among them; their names are part of the messages.
      type(variable_t), intent(in) :: table(:)
      !> Values of the rows, of which one of the interface is given; shape of `table`.
      real(dp), intent(in) :: values_of_table(:)
      !> Indices of the interface in `table`; shape `(n_interface_rows)`.
      integer, intent(in) :: of_interface(:)
      !> Those of temperature [K] and velocity [m/s].
      integer, intent(in) :: of_operating(2)
      !> The table of the input.
      type(given_law_t), intent(in) :: given
      !> The solid's own shift, or a default one.
      type(time_temperature_t), intent(in) :: of_solid
      !> Largest tension in contact, that of adhesion [Pa].
      real(dp), intent(in) :: tension
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      type(variable_t) :: rows(n_interface_rows), operating(2)
      real(dp) :: values(n_interface_rows), at(2)
      integer :: before, k

      before = problems%count()
      ! row by row: gfortran loses the texts of a section by indices
      do k = 1, n_interface_rows
         rows(k) = table(of_interface(k))
      end do
      do k = 1, 2
         operating(k) = table(of_operating(k))
      end do
      values = values_of_table(of_interface)
      at = values_of_table(of_operating)
      call check_words(rows, values, problems)
      if (law_of(values) == law_constant) then
         call check_shear(rows(:n_shear_rows), values(:n_shear_rows), tension, problems)
         return
      end if
      if (problems%count() > before) return
      call require(operating, at, [2], problems)
      if (law_of(values) == law_table) call check_table(rows(i_table), given, problems)
      call check_own_shift(rows, values, given, of_solid, operating(1), at(1), problems)
      if (is_set(values(i_barrier_power)) .and. abs(values(i_barrier_power) - 1.25_dp) < 0.25_dp) call problems%add( &
         & rows(i_barrier_power)%group, rows(i_barrier_power)%name, 'is neither 1 nor 1.5')
      if (problems%count() == before) call check_range(rows, values, given, of_solid, operating(2), at, tension, problems)
   end subroutine check_interface

   !> Add to `problems` what the law needs, and what belongs to another one.
   subroutine check_words(rows, values, problems)
      type(variable_t), intent(in) :: rows(:)
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: law
      integer :: k

      law = get_word(rows(i_law)%choices, law_of(values))
      do k = 1, n_interface_rows
         if (has_word(words_of_law(k), '+'//law)) then
            ! of the constant law the message is that of `check_shear`
            if (law_of(values) /= law_constant) call require(rows, values, [k], problems)
            if (law_of(values) == law_constant .and. .not. is_set(values(i_strength)) &
               & .and. .not. is_set(values(i_pressure_factor))) call require(rows, values, [i_strength], problems)
         else if (is_set(values(k)) .and. .not. has_word(words_of_law(k), law)) then
            call problems%add(rows(k)%group, rows(k)%name, 'has no meaning for law = '''//law//'''')
         end if
      end do
   end subroutine check_words

   !> Add to `problems` samples that make no table.
   subroutine check_table(row, given, problems)
      type(variable_t), intent(in) :: row
      type(given_law_t), intent(in) :: given
      type(problems_t), intent(inout) :: problems
      integer :: n

      if (.not. allocated(given%velocity_table)) return
      n = size(given%velocity_table, 1)
      associate (velocity => given%velocity_table(:, 1))
         if (.not. all(given%velocity_table > 0)) then
            call problems%add(row%group, row%name, 'has velocities or shear strengths that are not > 0')
         else if (.not. all(velocity(2:) > velocity(:n - 1))) then
            call problems%add(row%group, row%name, 'has velocities that do not rise')
         end if
      end associate
   end subroutine check_table

   !> Add to `problems` what is wrong with the interface's own shift, or that a temperature is missing.
   subroutine check_own_shift(rows, values, given, of_solid, row, temperature, problems)
      type(variable_t), intent(in) :: rows(:)
      real(dp), intent(in) :: values(:)
      type(given_law_t), intent(in) :: given
      type(time_temperature_t), intent(in) :: of_solid
      !> Row of the temperature, and its value [K].
      type(variable_t), intent(in) :: row
      real(dp), intent(in) :: temperature
      type(problems_t), intent(inout) :: problems
      type(variable_t) :: shift_rows(i_energy - i_shift + 2), of_temperature(1)
      real(dp) :: numbers(i_energy - i_shift + 2)
      logical :: is_swept(i_energy - i_shift + 2)
      integer :: k

      if (law_of(values) == law_activated) then
         of_temperature(1) = row
         call require(of_temperature, [temperature], [1], problems)
         return
      end if
      if (needs_temperature(values)) then
         do k = i_shift, i_energy
            shift_rows(k - i_shift + 1) = rows(k)
         end do
         shift_rows(size(shift_rows)) = row
         shift_rows(1)%choices = shift_rows(1)%choices(len('material ') + 1:)
         numbers = [values(i_shift) - 1, values(i_reference:i_energy), temperature]
         is_swept = .false.
         call check_shift(shift_rows, numbers, is_swept, 1, size(numbers), given%temperature, problems)
         return
      end if
      do k = i_reference, i_energy
         if (is_set(values(k))) call problems%add(rows(k)%group, rows(k)%name, &
            & 'has no meaning without shift = ''wlf'' or ''arrhenius'' in the same group')
      end do
      if (.not. is_set(values(i_shift))) return
      if (nint(values(i_shift)) == as_material .and. of_solid%law == shift_none) call problems%add(rows(i_shift)%group, &
         & rows(i_shift)%name, 'is that of the solid, which has none')
   end subroutine check_own_shift

   !> Add to `problems` a velocity that the law does not reach, and a shear stress that would be below 0.
   subroutine check_range(rows, values, given, of_solid, row, at, tension, problems)
      type(variable_t), intent(in) :: rows(:)
      real(dp), intent(in) :: values(:)
      type(given_law_t), intent(in) :: given
      type(time_temperature_t), intent(in) :: of_solid
      !> Row of the velocity.
      type(variable_t), intent(in) :: row
      !> Temperature [K] and velocity [m/s].
      real(dp), intent(in) :: at(2)
      real(dp), intent(in) :: tension
      type(problems_t), intent(inout) :: problems
      type(friction_law_t) :: law
      real(dp) :: stress, slope
      logical :: is_valid

      call get_friction_law(values, given, of_solid, law)
      call law%get_stress(abs(at(2)), 0.0_dp, at(1), stress, slope, is_valid)
      if (.not. is_valid .and. law%law == law_activated) then
         call problems%add(row%group, row%name, 'is above attempt_velocity, where the law activated ends')
      else if (.not. is_valid) then
         call problems%add(row%group, row%name, 'times the factor of the shift lies beyond velocity_table')
      else if (law%pressure_factor*tension > stress) then
         call problems%add(rows(i_pressure_factor)%group, rows(i_pressure_factor)%name, 'times the stress of adhesion is above ' &
            & //'the shear stress at this velocity: where that stress pulls at the edge of contact, the shear stress would be ' &
            & //'below 0')
      end if
   end subroutine check_range

end module adfric_interface_friction_law_check

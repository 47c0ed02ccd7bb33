! SPDX-License-Identifier: GPL-3.0-or-later
!> Values of namelist variables as they stand in an input.
module adfric_command_values
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_base_words, only: get_word
   use adfric_base_text, only: show_number
   use adfric_describe_table, only: variable_t, kind_logical, kind_choice
   use adfric_describe_word_sets, only: show_words
   implicit none (type, external)
   private
   public :: show_input_value

contains

   !> A value as it would be written in an input; `not given` where there is none.
   pure function show_input_value(variable, value) result(text)
      !> Row of the model's table: the kind of the variable and its choices.
      type(variable_t), intent(in) :: variable
      !> The value as it is kept, a number in SI units; `unset` where there is none.
      real(dp), intent(in) :: value
      character(:), allocatable :: text

      if (.not. is_set(value)) then
         text = 'not given'
      else if (variable%kind == kind_logical) then
         text = trim(merge('.true. ', '.false.', value > 0.5_dp))
      else if (variable%kind == kind_choice .and. variable%takes_several) then
         text = show_words(variable%choices, value, '''', ', ')
      else if (variable%kind == kind_choice) then
         text = ''''//get_word(variable%choices, nint(value))//''''
      else
         text = show_number(value)
      end if
   end function show_input_value

end module adfric_command_values

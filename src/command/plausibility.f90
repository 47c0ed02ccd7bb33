! SPDX-License-Identifier: GPL-3.0-or-later
!> What `adfric check` says of values far from those of any contact. It is a warning and changes nothing.
module adfric_command_plausibility
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_base_text, only: newline, show_number
   use adfric_input_run, only: run_input_t
   use adfric_describe_plausible_range, only: find_plausible_range, is_plausible
   use adfric_describe_table, only: kind_dataset
   implicit none (type, external)
   private
   public :: warn_of_values

contains

   !> A line for each variable that has such a value.
   function warn_of_values(run) result(lines)
      type(run_input_t), intent(in) :: run
      character(:), allocatable :: lines, unit
      real(dp) :: lower, upper
      integer :: i, k

      lines = ''
      do i = 1, size(run%model%variables)
         associate (variable => run%model%variables(i))
            unit = run%model%unit_of(run%plan%base, i)
            call find_plausible_range(variable, unit, lower, upper)
            associate (values => values_of(run, i, variable%kind == kind_dataset))
               k = findloc(is_plausible(values, lower, upper), .false., dim=1)
               if (k > 0) lines = lines//'warning: &'//variable%group//' '//variable%name//': '//show_number(values(k))//' ' &
                  //unit//' is far from any contact, usual are '//show_number(lower)//' to '//show_number(upper)//' ' &
                  //unit//'; is it in SI units?'//newline
            end associate
         end associate
      end do
   end function warn_of_values

   !> Every value that a variable has in a run; of a dataset the two ends of their range.
   pure function values_of(run, index, is_dataset) result(values)
      type(run_input_t), intent(in) :: run
      !> Index of the variable in the model's table, from 1.
      integer, intent(in) :: index
      !> Does the variable take its values from a dataset?
      logical, intent(in) :: is_dataset
      real(dp), allocatable :: values(:)

      allocate (values(0))
      if (is_dataset) then
         if (run%datasets(index)%is_given()) values = [run%datasets(index)%highest, run%datasets(index)%lowest]
      else if (is_set(run%plan%base(index))) then
         values = run%plan%values_of(index)
      end if
   end function values_of

end module adfric_command_plausibility

! SPDX-License-Identifier: GPL-3.0-or-later
!> Checks that models share: values that are missing, that stand beside others which say the same, or that may not be swept.
module adfric_describe_check
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: show_number
   use adfric_base_unset, only: is_set
   use adfric_describe_table, only: variable_t, kind_choice
   implicit none (type, external)
   private
   public :: require, require_one, refuse_given, refuse_size, refuse_swept

contains

   !> Each of a list has to be given.
   subroutine require(variables, values, list, problems)
      !> Table of the variables of the model; shape `(n_variables)`.
      type(variable_t), intent(in) :: variables(:)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Indices of the variables of the list in their table.
      integer, intent(in) :: list(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: k

      do k = 1, size(list)
         if (is_set(values(list(k)))) cycle
         associate (v => variables(list(k)))
            if (v%kind == kind_choice) then
               call problems%add(v%group, v%name, 'is missing, one of '//v%choices)
            else
               call problems%add(v%group, v%name, 'is missing ['//v%unit//']')
            end if
         end associate
      end do
   end subroutine require

   !> A value is possible, but its contact needs numbers that no computer has.
   subroutine refuse_size(variable, value, problems)
      !> Row of the variable.
      type(variable_t), intent(in) :: variable
      !> Its value, in its unit.
      real(dp), intent(in) :: value
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      call problems%add(variable%group, variable%name, 'leads to numbers above 1e308 or below 1e-308 with these bodies, given '// &
         & show_number(value)//' ['//variable%unit//']')
   end subroutine refuse_size

   !> Of a list not more than one may be given, and one has to be if it is needed.
   subroutine require_one(variables, values, list, is_needed, problems)
      !> Table of the variables of the model; shape `(n_variables)`.
      type(variable_t), intent(in) :: variables(:)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Indices of the variables of the list in their table.
      integer, intent(in) :: list(:)
      !> Has one of the list to be given?
      logical, intent(in) :: is_needed
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: first, last

      first = findloc(is_set(values(list)), .true., 1)
      last = findloc(is_set(values(list)), .true., 1, back=.true.)
      if (first == 0 .and. is_needed) then
         associate (v => variables(list(1)))
            call problems%add(v%group, v%name, 'is missing; one of '//list_names(variables, list)//' is needed')
         end associate
      else if (last > first) then
         associate (v => variables(list(first)), w => variables(list(last)))
            call problems%add(v%group, v%name, 'stands beside '//w%name//'; give one of them')
         end associate
      end if
   end subroutine require_one

   !> Of a list none may be given, since it has no meaning beside other values.
   subroutine refuse_given(variables, values, is_swept, list, text, problems)
      !> Table of the variables of the model; shape `(n_variables)`.
      type(variable_t), intent(in) :: variables(:)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      !> Indices of the variables of the list in their table.
      integer, intent(in) :: list(:)
      !> Why, behind the name of the variable.
      character(*), intent(in) :: text
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: k

      do k = 1, size(list)
         associate (v => variables(list(k)))
            if (is_set(values(list(k))) .or. is_swept(list(k))) call problems%add(v%group, v%name, text)
         end associate
      end do
   end subroutine refuse_given

   !> Of a list none may be swept, since the axis of the profiles depends on them and all points share it.
   subroutine refuse_swept(variables, is_swept, list, problems)
      !> Table of the variables of the model; shape `(n_variables)`.
      type(variable_t), intent(in) :: variables(:)
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      !> Indices of the variables of the list in their table.
      integer, intent(in) :: list(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: k

      do k = 1, size(list)
         associate (v => variables(list(k)))
            if (is_swept(list(k))) call problems%add(v%group, v%name, &
               & 'is swept, but all profiles share one axis; sweep another variable')
         end associate
      end do
   end subroutine refuse_swept

   !> Names as in `a, b or c`.
   pure function list_names(variables, list) result(text)
      type(variable_t), intent(in) :: variables(:)
      !> Indices of the variables of the list in their table, one or more.
      integer, intent(in) :: list(:)
      character(:), allocatable :: text
      integer :: k

      text = variables(list(1))%name
      do k = 2, size(list)
         if (k == size(list)) then
            text = text//' or '//variables(list(k))%name
         else
            text = text//', '//variables(list(k))%name
         end if
      end do
   end function list_names

end module adfric_describe_check

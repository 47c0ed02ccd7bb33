! SPDX-License-Identifier: GPL-3.0-or-later
!> The names of a model's groups and variables, as lists of words.
module adfric_model_vocabulary
   use adfric_base_words, only: has_word
   use adfric_model_model, only: model_t
   implicit none (type, external)
   private
   public :: list_groups, list_variables, list_groups_of

contains

   !> Groups of a model, separated by a blank.
   pure function list_groups(model) result(list)
      !> The model, whose table names groups and variables.
      class(model_t), intent(in) :: model
      character(:), allocatable :: list
      integer :: i

      list = ''
      do i = 1, size(model%variables)
         if (.not. has_word(list, model%variables(i)%group)) list = list//' '//model%variables(i)%group
      end do
      list = trim(adjustl(list))
   end function list_groups

   !> Variables of one group of a model, separated by a blank; of all groups if `group` is empty.
   pure function list_variables(model, group) result(list)
      !> The model, whose table names groups and variables.
      class(model_t), intent(in) :: model
      !> Name of the group; empty for all groups.
      character(*), intent(in) :: group
      character(:), allocatable :: list
      integer :: i

      list = ''
      do i = 1, size(model%variables)
         if (len_trim(group) > 0 .and. model%variables(i)%group /= group) cycle
         if (.not. has_word(list, model%variables(i)%name)) list = list//' '//model%variables(i)%name
      end do
      list = trim(adjustl(list))
   end function list_variables

   !> Groups of a model that have a variable of this name, separated by a blank.
   pure function list_groups_of(model, name) result(list)
      !> The model, whose table names groups and variables.
      class(model_t), intent(in) :: model
      !> Name of the variable, in small letters.
      character(*), intent(in) :: name
      character(:), allocatable :: list
      integer :: i

      list = ''
      do i = 1, size(model%variables)
         if (model%variables(i)%name == name) list = list//' '//model%variables(i)%group
      end do
      list = trim(adjustl(list))
   end function list_groups_of

end module adfric_model_vocabulary

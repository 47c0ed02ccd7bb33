! SPDX-License-Identifier: GPL-3.0-or-later
!> The names of a model's groups and variables, as lists of words.
module adfric_describe_vocabulary
   use adfric_base_words, only: count_words, get_word, has_word
   use adfric_describe_model, only: model_t
   implicit none (type, external)
   private
   public :: order_of_scenes, list_groups, list_variables, list_groups_of

   !> Groups of scenes in the order in which a reader meets them.
   character(*), parameter :: order_of_scenes = 'surface power_spectrum traction solid adhesion friction heat operating '// &
      & 'history position estimates numerics output'

contains

   !> Groups of a model, separated by a blank.
   pure function list_groups(model) result(list)
      !> The model, whose table names groups and variables.
      class(model_t), intent(in) :: model
      character(:), allocatable :: list
      integer :: i

      list = ''
      do i = 1, size(model%variables)
         if (model%variables(i)%is_hidden) cycle
         if (.not. has_word(list, model%variables(i)%group)) list = list//' '//model%variables(i)%group
      end do
      if (allocated(model%scene_names)) list = list//' '//groups_of(model%scene_names)
      list = trim(adjustl(list))
      if (allocated(model%scene)) list = in_order_of_scenes(list)
   end function list_groups

   !> The groups of names `group%name`.
   pure function groups_of(names) result(groups)
      !> The names, separated by a blank.
      character(*), intent(in) :: names
      character(:), allocatable :: groups, name
      integer :: k

      groups = ''
      do k = 1, count_words(names)
         name = get_word(names, k)
         groups = groups//' '//name(:index(name, '%') - 1)
      end do
   end function groups_of

   !> Groups of a scene in the order in which a reader meets them.
   pure function in_order_of_scenes(groups) result(list)
      !> The groups, separated by a blank.
      character(*), intent(in) :: groups
      character(:), allocatable :: list
      integer :: k

      list = ''
      do k = 1, count_words(order_of_scenes)
         if (has_word(groups, get_word(order_of_scenes, k))) list = list//' '//get_word(order_of_scenes, k)
      end do
      do k = 1, count_words(groups)
         if (.not. has_word(list, get_word(groups, k))) list = list//' '//get_word(groups, k)
      end do
      list = adjustl(list)
   end function in_order_of_scenes

   !> Variables of one group of a model, separated by a blank; of all groups if `group` is empty.
   pure function list_variables(model, group) result(list)
      !> The model, whose table names groups and variables.
      class(model_t), intent(in) :: model
      !> Name of the group; empty for all groups.
      character(*), intent(in) :: group
      character(:), allocatable :: list, name
      integer :: i

      list = ''
      do i = 1, size(model%variables)
         if (model%variables(i)%is_hidden .or. len_trim(group) > 0 .and. model%variables(i)%group /= group) cycle
         if (.not. has_word(list, model%variables(i)%name)) list = list//' '//model%variables(i)%name
      end do
      if (allocated(model%scene_names)) then
         do i = 1, count_words(model%scene_names)
            name = get_word(model%scene_names, i)
            if (name(:index(name, '%') - 1) /= group) cycle
            name = name(index(name, '%') + 1:)
            if (.not. has_word(list, name)) list = list//' '//name
         end do
      end if
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
         if (model%variables(i)%name == name .and. .not. model%variables(i)%is_hidden) list = list//' '//model%variables(i)%group
      end do
      list = trim(adjustl(list))
   end function list_groups_of

end module adfric_describe_vocabulary

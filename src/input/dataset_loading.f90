! SPDX-License-Identifier: GPL-3.0-or-later
!> The values of all datasets, groups and lists that an input has: from their files to the model.
module adfric_input_dataset_loading
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_words, only: get_word
   use adfric_input_attributes, only: load_attributes
   use adfric_input_case, only: case_t
   use adfric_input_dataset, only: load_dataset
   use adfric_input_group_columns, only: load_columns
   use adfric_input_variable, only: describe_allowed
   use adfric_describe_model, only: model_t
   use adfric_describe_scene_messages, only: say_as_scene
   use adfric_describe_table, only: variable_t
   use adfric_run_dataset, only: dataset_t
   implicit none (type, external)
   private
   public :: load_datasets

contains

   !> Read every dataset and hand it to the model; what is wrong with one is said with its name and line.
   subroutine load_datasets(model, input, problems)
      !> The model, which takes over the values of each dataset.
      class(model_t), intent(inout) :: model
      !> In: the names of the datasets. Out: also what is known of their values, and which are broken.
      type(case_t), intent(inout) :: input
      type(problems_t), intent(inout) :: problems
      type(problems_t) :: found
      real(dp), allocatable :: values(:, :)
      character(:), allocatable :: flaw
      integer :: i, k

      do i = 1, size(input%datasets)
         if (input%is_broken(i) .or. input%is_swept(i) .or. .not. input%datasets(i)%is_given()) cycle
         associate (variable => model%variables(i), dataset => input%datasets(i))
            call load_data(dataset, variable, values, flaw)
            found = problems_t()
            if (len(flaw) > 0 .and. names_index(flaw, dataset)) then
               call found%add(variable%group, variable%name, flaw)
            else if (len(flaw) > 0) then
               call found%add(variable%group, variable%name, flaw//', given '''//dataset%text//''', allowed: ' &
                  //describe_allowed(variable))
            else
               call model%take_dataset(i, values, found)
               call hand_over_attributes(model, i, dataset, found)
               call say_as_scene(model, found)
            end if
            do k = 1, found%count()
               call problems%add(found%items(k)%group, found%items(k)%variable, found%items(k)%text, line=input%line(i))
            end do
            input%is_broken(i) = found%count() > 0
            if (.not. input%is_broken(i)) input%values(i) = 1
         end associate
      end do
   end subroutine load_datasets

   !> Does it say already in which file, and where there, something is wrong?
   pure logical function names_index(flaw, dataset)
      !> What is wrong.
      character(*), intent(in) :: flaw
      !> The names of file and dataset, if it is no list.
      type(dataset_t), intent(in) :: dataset

      names_index = dataset%is_column
      if (names_index) names_index = index(flaw, dataset%file//': ') == 1
   end function names_index

   !> Read the values of a dataset or group with its attributes; those of a list are known.
   subroutine load_data(dataset, variable, values, flaw)
      !> In: the names of file and dataset, or the numbers. Out: also what is known of the values.
      type(dataset_t), intent(inout) :: dataset
      type(variable_t), intent(in) :: variable
      !> The values in SI units, the last dimension of the file first; shape `(n, 1)` for one dimension or a list, `(n, n_columns)`
      !> for a group.
      real(dp), allocatable, intent(out) :: values(:, :)
      !> What is wrong with the file, the dataset or its values; empty if nothing is wrong.
      character(:), allocatable, intent(out) :: flaw

      flaw = ''
      if (allocated(dataset%numbers)) then
         values = reshape(dataset%numbers, [size(dataset%numbers), 1])
         return
      end if
      call load_attributes(dataset, variable, flaw)
      if (len(flaw) > 0) return
      if (variable%n_columns() > 0) then
         call load_columns(dataset, variable, values, flaw)
      else
         call load_dataset(dataset, variable, values, flaw)
         if (variable%is_list .and. len(flaw) == 0) dataset%numbers = values(:, 1)
      end if
   end subroutine load_data

   !> Hand the model the attributes of a dataset whose values it has taken.
   subroutine hand_over_attributes(model, position, dataset, problems)
      !> The model, which takes over the attributes.
      class(model_t), intent(inout) :: model
      !> Index of the dataset in the variables of the model.
      integer, intent(in) :: position
      type(dataset_t), intent(in) :: dataset
      !> Receives what is wrong; nothing is done if something is wrong already.
      type(problems_t), intent(inout) :: problems
      integer :: k

      if (problems%count() > 0 .or. .not. allocated(dataset%attributes)) return
      do k = 1, size(dataset%attribute_values)
         call model%take_attribute(position, get_word(dataset%attributes, k), dataset%attribute_values(k), problems)
      end do
   end subroutine hand_over_attributes

end module adfric_input_dataset_loading

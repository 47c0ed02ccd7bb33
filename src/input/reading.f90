! SPDX-License-Identifier: GPL-3.0-or-later
!> An input while it is read.
module adfric_input_reading
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_input_namelist_file, only: namelist_file_t
   use adfric_describe_model, only: model_t
   use adfric_run_dataset, only: dataset_t
   implicit none (type, external)
   private
   public :: case_t, reading_t, new_reading

   !> A value for every variable, each component of shape `(n_variables)`.
   type :: case_t
      !> Values as a model holds them; of a swept variable the first one.
      real(dp), allocatable :: values(:)
      !> Does the variable stand in its group?
      logical, allocatable :: is_given(:)
      !> Is the variable swept?
      logical, allocatable :: is_swept(:)
      !> Was something wrong with the variable, so that its value is not what the user wanted?
      logical, allocatable :: is_broken(:)
      !> Line where the variable is given or swept; 0 where it is neither.
      integer, allocatable :: line(:)
      !> The dataset or group that the variable names, or its list of numbers, if it has one.
      type(dataset_t), allocatable :: datasets(:)
   end type case_t

   !> What all that reads an input has to do with.
   type :: reading_t
      !> The input, cut into groups and assignments.
      type(namelist_file_t), pointer :: file => null()
      !> What is wrong with the input; nothing is removed.
      type(problems_t), pointer :: problems => null()
      !> The model, whose tables say what there is; null as long as it is not known.
      class(model_t), pointer :: model => null()
      !> What the groups and the sweeps read so far give; null where they are not read.
      type(case_t), pointer :: input => null()
   contains
      procedure :: report
   end type reading_t

contains

   !> Begin to read. All that is given has to stay as long as the reading.
   subroutine new_reading(self, file, problems, model, input)
      !> Receives what it has to do with.
      type(reading_t), intent(out) :: self
      !> The input, cut into groups and assignments; without any where there is none.
      type(namelist_file_t), intent(in), target :: file
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout), target :: problems
      !> The model, if it is known.
      class(model_t), intent(in), target, optional :: model
      !> The case, if it is read.
      type(case_t), intent(inout), target, optional :: input

      self%file => file
      self%problems => problems
      if (present(model)) self%model => model
      if (present(input)) self%input => input
   end subroutine new_reading

   !> Add a problem of a variable, see `report_variable` of `namelist_file_t`.
   subroutine report(self, group, variable, text, index)
      class(reading_t), intent(in) :: self
      !> Number of the group in the file, from 1.
      integer, intent(in) :: group
      !> Name of the variable, empty for the whole group; and what is wrong, what was given, what is allowed.
      character(*), intent(in) :: variable, text
      !> Position of what is wrong in the text of the value; absent: the name of the variable is meant.
      integer, intent(in), optional :: index

      call self%file%report_variable(self%problems, group, variable, text, index)
   end subroutine report

end module adfric_input_reading

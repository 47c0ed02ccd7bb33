! SPDX-License-Identifier: GPL-3.0-or-later
!> A model that takes a dataset, and inputs that name one.
module dataset_trial
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_input_namelist_file, only: namelist_file_t, new_namelist_file
   use adfric_input_run, only: run_input_t, read_case
   use adfric_describe_table, only: variable_t, kind_dataset
   use adfric_run_doubting_model, only: doubting_model_t
   use trial_model, only: trial_model_t, new_trial_model
   implicit none (type, external)
   private
   public :: dataset_model_t, read_dataset, heights_index

   integer, parameter :: n_trial = 12, heights_index = n_trial + 1

   !> The trial model with &surface heights.
   type, extends(trial_model_t) :: dataset_model_t
      !> What it was given.
      real(dp), allocatable :: heights(:, :)
   contains
      procedure :: take_dataset
   end type dataset_model_t

contains

   !> Make the model; it takes one or two dimensions, with values from -100 to 100.
   subroutine new_dataset_model(self)
      type(dataset_model_t), intent(out) :: self
      type(trial_model_t) :: trial
      integer :: k

      call new_trial_model(trial)
      self%name = trial%name
      self%results = trial%results
      self%profiles = trial%profiles
      self%counts = trial%counts
      self%profile_axes = trial%profile_axes
      allocate (self%variables(heights_index))
      do k = 1, n_trial
         self%variables(k) = trial%variables(k)
      end do
      associate (variable => self%variables(heights_index))
         variable%group = 'surface'
         variable%name = 'heights'
         variable%kind = kind_dataset
         variable%unit = 'm'
         variable%meaning = 'heights'
         variable%lower = -100
         variable%upper = 100
         variable%largest_rank = 2
         variable%least_count = 2
      end associate
   end subroutine new_dataset_model

   !> Heights that begin with 13 make no sense.
   subroutine take_dataset(self, index, values, problems)
      class(dataset_model_t), intent(inout) :: self
      integer, intent(in) :: index
      real(dp), intent(in) :: values(:, :)
      type(problems_t), intent(inout) :: problems

      if (index /= heights_index) error stop 'dataset_trial: this is no dataset'
      self%heights = values
      if (nint(values(1, 1)) == 13) call problems%add('surface', 'heights', 'bring bad luck')
   end subroutine take_dataset

   !> Read an input with `heights` and perhaps more lines, and list what is wrong.
   subroutine read_dataset(heights, more, model, run, lines)
      !> As it stands behind `heights = `.
      character(*), intent(in) :: heights
      character(*), intent(in) :: more
      !> The model as it is afterwards, with its heights.
      type(dataset_model_t), intent(out) :: model
      type(run_input_t), intent(out) :: run
      !> A line for each problem.
      character(:), allocatable, intent(out) :: lines
      type(namelist_file_t) :: file
      type(problems_t) :: problems
      integer :: k

      call new_dataset_model(model)
      call new_namelist_file(file, 'f.nml', '&surface period = 1e-3'//new_line('a')//'heights = '//heights//' /'// &
         new_line('a')//more, problems)
      allocate (run%model, source=model)
      call read_case(file, run, problems)
      select type (reader => run%model)
      type is (dataset_model_t)
         model = reader
      type is (doubting_model_t)
         ! without problems the run has completed it
         select type (inner => reader%inner)
         type is (dataset_model_t)
            model = inner
         end select
      end select
      lines = ''
      do k = 1, problems%count()
         lines = lines//problems%line_of(k, 'f.nml')//new_line('a')
      end do
   end subroutine read_dataset

end module dataset_trial

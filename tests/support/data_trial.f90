! SPDX-License-Identifier: GPL-3.0-or-later
!> A model with lists, a group of columns and attributes, and inputs that give them.
module data_trial
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_input_namelist_file, only: namelist_file_t, new_namelist_file
   use adfric_input_run, only: run_input_t, read_case
   use adfric_describe_rows, only: columns_row, dataset, list_row
   use adfric_run_doubting_model, only: doubting_model_t
   use trial_model, only: trial_model_t, new_trial_model
   implicit none (type, external)
   private
   public :: data_model_t, new_data_model, read_data, amplitudes_index, curve_index, line_index, moduli_index

   integer, parameter :: n_trial = 12, amplitudes_index = n_trial + 1, moduli_index = n_trial + 2, &
      & curve_index = n_trial + 3, &
      & line_index = n_trial + 4
   !> Most numbers of the list of moduli.
   integer, parameter :: most_moduli = 4

   !> An array.
   type :: array_t
      real(dp), allocatable :: values(:, :)
   end type array_t

   !> The trial model with &surface amplitudes and line, &foundation moduli and curve.
   type, extends(trial_model_t) :: data_model_t
      !> What it was given, in the indices of the variables.
      type(array_t) :: taken(line_index)
      !> Attributes that it was given, as `name=value;`.
      character(:), allocatable :: attributes
   contains
      procedure :: take_dataset
      procedure :: take_attribute
   end type data_model_t

contains

   !> Make the model.
   subroutine new_data_model(self)
      type(data_model_t), intent(out) :: self
      type(trial_model_t) :: trial
      integer :: k

      call new_trial_model(trial)
      self%name = trial%name
      self%summary = trial%summary
      self%references = ''
      self%results = trial%results
      self%profiles = trial%profiles
      self%counts = trial%counts
      self%profile_axes = trial%profile_axes
      self%attributes = ''
      allocate (self%variables(line_index))
      do k = 1, n_trial
         self%variables(k) = trial%variables(k)
      end do
      self%variables(amplitudes_index) = list_row(group='surface', name='amplitudes', unit='m', meaning='amplitudes', &
         & most_count=64, attributes='phase', attribute_units='rad')
      self%variables(moduli_index) = list_row(group='foundation', name='moduli', unit='Pa', meaning='moduli', least_count=2, &
         & most_count=most_moduli, lower=0.0_dp, lower_open=.true., upper=1.0e12_dp)
      self%variables(curve_index) = columns_row(group='foundation', name='curve', columns='omega storage loss', &
         & units='rad/s Pa Pa', meaning='master curve', least_count=2, lower=0.0_dp, attributes='temperature', &
         & attribute_units='K')
      self%variables(line_index) = dataset(group='surface', name='line', unit='m', meaning='heights', largest_rank=1, &
         & least_count=2, attributes='dx dy', attribute_units='m m')
   end subroutine new_data_model

   !> Values that begin with 13 make no sense.
   subroutine take_dataset(self, index, values, problems)
      class(data_model_t), intent(inout) :: self
      integer, intent(in) :: index
      real(dp), intent(in) :: values(:, :)
      type(problems_t), intent(inout) :: problems

      if (index <= n_trial) error stop 'data_trial: this is no dataset'
      self%taken(index)%values = values
      if (nint(values(1, 1)) == 13) call problems%add(self%variables(index)%group, self%variables(index)%name, &
         & 'bring bad luck')
   end subroutine take_dataset

   !> An attribute of 13 makes no sense either.
   subroutine take_attribute(self, index, name, value, problems)
      class(data_model_t), intent(inout) :: self
      integer, intent(in) :: index
      character(*), intent(in) :: name
      real(dp), intent(in) :: value
      type(problems_t), intent(inout) :: problems
      character(12) :: number

      if (.not. allocated(self%taken(index)%values)) error stop 'data_trial: attributes come behind values'
      write (number, '(f0.3)') value
      self%attributes = self%attributes//name//'='//trim(number)//';'
      if (nint(value) == 13) call problems%add(self%variables(index)%group, self%variables(index)%name, &
         & name//' brings bad luck')
   end subroutine take_attribute

   !> Read an input, and list what is wrong.
   subroutine read_data(text, model, run, lines)
      !> Groups beside &surface period in line 1; `|` ends a line.
      character(*), intent(in) :: text
      !> The model as it is afterwards, with what it was given.
      type(data_model_t), intent(out) :: model
      type(run_input_t), intent(out) :: run
      !> A line for each problem.
      character(:), allocatable, intent(out) :: lines
      type(namelist_file_t) :: file
      type(problems_t) :: problems
      character(len(text)) :: more
      integer :: k

      call new_data_model(model)
      more = text
      do k = 1, len(text)
         if (text(k:k) == '|') more(k:k) = new_line('a')
      end do
      call new_namelist_file(file, 'f.nml', '&surface period = 1e-3'//new_line('a')//more, problems)
      allocate (run%model, source=model)
      call read_case(file, run, problems)
      select type (reader => run%model)
      type is (data_model_t)
         model = reader
      type is (doubting_model_t)
         ! without problems the run has completed it
         select type (inner => reader%inner)
         type is (data_model_t)
            model = inner
         end select
      end select
      lines = ''
      do k = 1, problems%count()
         lines = lines//problems%line_of(k, 'f.nml')//new_line('a')
      end do
   end subroutine read_data

end module data_trial

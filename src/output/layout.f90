! SPDX-License-Identifier: GPL-3.0-or-later
!> Which datasets a results file has, of what shape and size.
module adfric_output_layout
   use adfric_base_kinds, only: dp, i8
   use adfric_base_words, only: has_word
   use adfric_describe_table, only: extra_t, result_t, profile_t, profile_axis_t, results_of_every_run
   use adfric_output_axes, only: scale_t, companion_t, find_axes, find_companions, name_of_swept, name_of_dimension
   use adfric_output_constants, only: constant_t, find_constants, file_unit, list_taken, name_in_file
   use adfric_run_blocks, only: blocks_t
   use adfric_run_run, only: run_t
   implicit none (type, external)
   private
   public :: layout_t, new_layout, scale_t, companion_t, field_t, set_status_fields, number_indices, name_of_swept, &
      & name_of_dimension

   !> Meaning of the state `no_state` of a result.
   character(*), parameter :: no_state_meaning = 'no_value'
   !> Bytes of a real number and of a state.
   integer, parameter :: real_bytes = 8, state_bytes = 1
   !> Space for names, attributes and the file's own tables, for each dataset [bytes].
   integer, parameter :: bytes_per_dataset = 4096

   !> A dataset with a value at every point.
   type :: field_t
      !> Name of the dataset.
      character(:), allocatable :: name
      !> Unit as it stands in the file.
      character(:), allocatable :: unit
      !> What the values are, in a phrase.
      character(:), allocatable :: long_name
      !> Meanings of `first_flag`, `first_flag + 1`, ... separated by a blank; empty for real numbers.
      character(:), allocatable :: flag_meanings
      !> The state that the first of these meanings is of.
      integer :: first_flag = 0
      !> Index in the results of the model; 0 for `error_estimate` and `status`, which every model has.
      integer :: column = 0
   end type field_t

   !> The datasets of a results file. That of a whole run has the points in the shape of the sweep; that of a part has
   !> its points in a row.
   type :: layout_t
      !> The points of the file.
      type(blocks_t) :: blocks
      !> What has one value in the whole run.
      type(constant_t), allocatable :: constants(:)
      !> Variables that are lists of numbers; their values lie along a dimension of their own.
      type(scale_t), allocatable :: lists(:)
      !> Scales of the dimensions of the points, the slowest first: swept variables, or numbers from 1 where several variables
      !> change together and none of them leads.
      type(scale_t), allocatable :: axes(:)
      !> Swept variables that are no scale themselves.
      type(companion_t), allocatable :: companions(:)
      !> Axes of a profile, the slowest first, without those of size 1.
      type(scale_t), allocatable :: profile_axes(:)
      !> Datasets whose values are known when the file is created; not allocated before they have been asked for.
      type(extra_t), allocatable :: extras(:)
      !> Results, and last `error_estimate` and `status`.
      type(field_t), allocatable :: fields(:)
      !> Profiles.
      type(field_t), allocatable :: profiles(:)
      !> Names of what the model counts in each block.
      type(field_t), allocatable :: counts(:)
   contains
      procedure :: point_shape
      procedure :: row_shape
      procedure :: row_of
      procedure :: profile_shape
      procedure :: n_bytes
      procedure :: list_coordinates
   end type layout_t

contains

   !> Find the datasets of a run.
   subroutine new_layout(self, run)
      !> Receives the datasets and the points of the file.
      type(layout_t), intent(out) :: self
      !> The run, with its model and its points.
      class(run_t), intent(in) :: run
      type(result_t), allocatable :: results(:)
      integer :: i

      results = run%model%describe_results(run%plan%base)
      call find_constants(run, self%constants)
      call find_lists(run, self%lists)
      call find_axes(run, self%axes)
      call find_companions(run, self%companions)
      call find_fields(run, results, self%fields)
      if (run%model%wants_profiles(run%plan%base)) then
         call find_profile_axes(run, self%profile_axes)
         call find_profiles(run%model%describe_profiles(run%plan%base), self%profiles)
      else
         allocate (self%profile_axes(0), self%profiles(0))
      end if
      self%blocks = run%blocks()
      allocate (self%counts(size(run%model%counts)))
      do i = 1, size(self%counts)
         call set_field(self%counts(i), run%model%counts(i)%name, '-', &
            'sum over the points of a block, for the attribute of this name')
      end do
   end subroutine new_layout

   !> The variables that are lists of numbers.
   subroutine find_lists(run, lists)
      class(run_t), intent(in) :: run
      type(scale_t), allocatable, intent(out) :: lists(:)
      integer :: i, n

      n = 0
      do i = 1, size(run%datasets)
         if (allocated(run%datasets(i)%numbers)) n = n + 1
      end do
      allocate (lists(n))
      n = 0
      do i = 1, size(run%datasets)
         if (.not. allocated(run%datasets(i)%numbers)) cycle
         n = n + 1
         lists(n)%name = name_in_file(run, i, list_taken(run))
         lists(n)%unit = file_unit(run%model%unit_of(run%plan%base, i))
         lists(n)%long_name = run%model%variables(i)%meaning
         lists(n)%values = run%datasets(i)%numbers
      end do
   end subroutine find_lists

   !> The indices of the numbers of a list, as values along its dimension.
   pure subroutine number_indices(list, indices)
      !> The list.
      type(scale_t), intent(in) :: list
      !> Receives the indices from 1 on, with their name.
      type(scale_t), intent(out) :: indices
      integer :: i

      indices%name = list%name//'_place'
      indices%unit = '1'
      indices%long_name = 'place in '//list%name
      indices%values = [(real(i, dp), i=1, size(list%values))]
   end subroutine number_indices

   !> Results that are written. One that is swept itself stands in the file as a variable and is left out.
   subroutine find_fields(run, results, fields)
      class(run_t), intent(in) :: run
      !> Results of the model with the units of this run.
      type(result_t), intent(in) :: results(:)
      !> Receives the fields of the results, and last those of `error_estimate` and `status`.
      type(field_t), allocatable, intent(out) :: fields(:)
      character(:), allocatable :: swept
      integer :: i, n

      swept = ''
      do i = 1, size(run%model%variables)
         if (run%plan%is_swept(i)) swept = swept//' '//name_of_swept(run, i)
      end do
      allocate (fields(size(results) + 2))
      n = 0
      do i = 1, size(results)
         if (results(i)%is_hidden .or. has_word(swept, results(i)%name)) cycle
         n = n + 1
         call set_field(fields(n), results(i)%name, results(i)%unit, results(i)%long_name)
         fields(n)%column = i
         if (results(i)%n_states() == 0) cycle
         fields(n)%flag_meanings = no_state_meaning//' '//results(i)%flag_meanings
         fields(n)%first_flag = -1
      end do
      call set_status_fields(fields(n + 1:n + 2), run%model%list_states())
      fields = fields(:n + 2)
   end subroutine find_fields

   !> The last fields of every layout.
   pure subroutine set_status_fields(fields, states)
      !> Receive the descriptions of `error_estimate` and `status`.
      type(field_t), intent(inout) :: fields(2)
      !> Names of the states of a point, separated by a blank.
      character(*), intent(in) :: states
      type(result_t) :: results(2)
      integer :: i

      results = results_of_every_run(states)
      do i = 1, 2
         call set_field(fields(i), results(i)%name, results(i)%unit, results(i)%long_name)
         fields(i)%flag_meanings = results(i)%flag_meanings
      end do
   end subroutine set_status_fields

   !> Set what is written beside a dataset of real numbers.
   pure subroutine set_field(field, name, unit, long_name)
      !> Receives its texts, and no meanings of flags.
      type(field_t), intent(inout) :: field
      character(*), intent(in) :: name
      !> Unit of its values as the model gives it; a hyphen, or nothing, for a pure number.
      character(*), intent(in) :: unit
      !> What the values of the dataset are, in a phrase.
      character(*), intent(in) :: long_name

      field%name = name
      field%unit = file_unit(unit)
      field%long_name = long_name
      field%flag_meanings = ''
   end subroutine set_field

   !> Axes along which a profile has more than one value.
   subroutine find_profile_axes(run, axes)
      class(run_t), intent(in) :: run
      !> Receives the axes, the slowest first.
      type(scale_t), allocatable, intent(out) :: axes(:)
      type(profile_axis_t), allocatable :: of_model(:)
      type(scale_t) :: axis
      integer :: k

      call run%model%get_profile_axes(run%plan%base, of_model)
      allocate (axes(0))
      do k = 1, size(of_model)
         if (size(of_model(k)%coordinates) == 1) cycle
         axis%name = of_model(k)%name
         axis%unit = file_unit(of_model(k)%unit)
         axis%long_name = of_model(k)%long_name
         axis%values = of_model(k)%coordinates
         axes = [axes, axis]
      end do
   end subroutine find_profile_axes

   !> Profiles that are written.
   subroutine find_profiles(profiles, fields)
      type(profile_t), intent(in) :: profiles(:)
      !> Receives a field for each profile, in the same order.
      type(field_t), allocatable, intent(out) :: fields(:)
      integer :: i

      allocate (fields(size(profiles)))
      do i = 1, size(fields)
         call set_field(fields(i), profiles(i)%name, profiles(i)%unit, profiles(i)%long_name)
         fields(i)%column = i
      end do
   end subroutine find_profiles

   !> Number of points along each swept variable, the slowest first.
   pure function point_shape(self) result(counts)
      class(layout_t), intent(in) :: self
      integer(i8), allocatable :: counts(:)
      integer :: k

      counts = [(size(self%axes(k)%values, kind=i8), k=1, size(self%axes))]
   end function point_shape

   !> Shape of the points of the file: that of the sweep, or one row for a part.
   pure function row_shape(self) result(counts)
      class(layout_t), intent(in) :: self
      integer(i8), allocatable :: counts(:)

      if (self%blocks%part%is_whole()) then
         counts = self%point_shape()
      else
         counts = [self%blocks%n_points()]
      end if
   end function row_shape

   !> Index of a point in the file, from 1.
   pure integer(i8) function row_of(self, point)
      class(layout_t), intent(in) :: self
      !> Number of the point in the run, from 1.
      integer(i8), intent(in) :: point

      row_of = point
      if (.not. self%blocks%part%is_whole()) row_of = self%blocks%row_of(point)
   end function row_of

   !> Shape of a profile, the slowest axis first.
   pure function profile_shape(self) result(counts)
      class(layout_t), intent(in) :: self
      integer(i8), allocatable :: counts(:)
      integer :: k

      counts = [(size(self%profile_axes(k)%values, kind=i8), k=1, size(self%profile_axes))]
   end function profile_shape

   !> Names of what belongs to all values of results without being a scale, separated by a blank.
   pure function list_coordinates(self) result(names)
      class(layout_t), intent(in) :: self
      character(:), allocatable :: names
      integer :: i

      names = ''
      do i = 1, size(self%companions)
         names = names//' '//self%companions(i)%name
      end do
      do i = 1, size(self%constants)
         names = names//' '//self%constants(i)%name
      end do
      names = trim(adjustl(names))
   end function list_coordinates

   !> Size of the file [bytes]; a real number, since no integer would be large enough for a sweep that is
   !> too large.
   pure real(dp) function n_bytes(self)
      class(layout_t), intent(in) :: self
      real(dp) :: n_points, per_point, in_lists
      integer :: i

      n_points = product(real(self%point_shape(), dp))
      if (.not. self%blocks%part%is_whole()) n_points = real(self%blocks%n_points(), dp)
      per_point = real_bytes*size(self%profiles)*product(real(self%profile_shape(), dp))
      do i = 1, size(self%fields)
         per_point = per_point + merge(state_bytes, real_bytes, len(self%fields(i)%flag_meanings) > 0)
      end do
      per_point = per_point + real(real_bytes*(size(self%counts) + 1), dp)/self%blocks%size
      in_lists = 0
      do i = 1, size(self%lists)
         ! each with its numbers from 1 on
         in_lists = in_lists + 2*(real_bytes*size(self%lists(i)%values) + bytes_per_dataset)
      end do
      do i = 1, size(self%companions)
         in_lists = in_lists + real_bytes*size(self%companions(i)%values) + bytes_per_dataset
      end do
      n_bytes = in_lists + n_points*per_point + real_bytes*(sum(real(self%point_shape(), dp)) &
         + sum(real(self%profile_shape(), dp))) + bytes_per_dataset &
         *(size(self%constants) + size(self%axes) + size(self%profile_axes) + size(self%fields) + size(self%profiles) &
         + size(self%counts) + 2)
   end function n_bytes

end module adfric_output_layout

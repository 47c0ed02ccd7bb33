! SPDX-License-Identifier: GPL-3.0-or-later
!> The results of a case as C sees them: arrays with names, units and dimensions, in the form that the results file has, and what
!> the file says of the run as a whole. The numbers are those that the solution keeps in memory; none of them is copied.
module adfric_c_arrays
   use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t, c_int8_t, c_loc, c_null_ptr, c_ptr
   use adfric_base_error, only: error_t, file_failure, set_error
   use adfric_base_kinds, only: dp, i8
   use adfric_base_words, only: count_words, get_word, has_word
   use adfric_c_coordinates, only: coordinates_t, new_coordinates
   use adfric_c_texts, only: keep_text, too_little_memory
   use adfric_hdf5_datasets, only: to_state
   use adfric_describe_table, only: extra_t
   use adfric_output_constants, only: add_derived_constants, constant_t, file_unit
   use adfric_output_layout, only: field_t, layout_t, new_layout, number_indices, scale_t
   use adfric_run_memory_sink, only: memory_sink_t
   use adfric_run_run, only: run_t
   implicit none (type, external)
   private
   public :: array_info_t, arrays_t, new_arrays

   !> What an array is, as in adfric.h.
   integer(c_int32_t), parameter :: role_coordinate = 1, role_result = 2, role_profile = 3, role_parameter = 4, role_list = 5, &
      & role_extra = 6, role_words = 7

   !> `adfric_array` of adfric.h.
   type, bind(c) :: array_info_t
      !> Texts, and the arrays of dimensions.
      type(c_ptr) :: name, unit, long_name, flag_meanings, dimensions, shape, strides
      !> The numbers or states; the other one is null.
      type(c_ptr) :: values, states
      !> Number of dimensions, number of the first state, one of `role_...`.
      integer(c_int32_t) :: rank, first_flag, role
   end type array_info_t

   !> An array with what belongs to it.
   type :: array_t
      !> What C gets.
      type(array_info_t) :: info
      !> Names of the dimensions.
      type(c_ptr), allocatable :: dimensions(:)
      !> Number of values along each, and how many stand from one to the next.
      integer(c_int64_t), allocatable :: shape(:), strides(:)
      !> Numbers that stand nowhere else.
      real(c_double), allocatable :: values(:)
      !> States that stand nowhere else.
      integer(c_int8_t), allocatable :: states(:)
   end type array_t

   !> All arrays of a run.
   type :: arrays_t
      !> The arrays; shape at least `(n)`.
      type(array_t), allocatable :: items(:)
      !> Number of arrays.
      integer :: n = 0
      !> Their names, separated by a blank.
      character(:), allocatable :: names
      !> Results and profiles.
      type(memory_sink_t), allocatable :: found
   end type arrays_t

contains

   !> Make arrays of what was found.
   subroutine new_arrays(self, run, found, error)
      !> Receives the arrays; it must stay where it is.
      type(arrays_t), target, intent(out) :: self
      !> The run, with its model and its points.
      class(run_t), intent(in) :: run
      !> What was found; the arrays take it over.
      type(memory_sink_t), allocatable, intent(inout) :: found
      !> Allocated if there is too little memory.
      type(error_t), allocatable, intent(inout) :: error
      type(layout_t) :: layout
      type(coordinates_t) :: coordinates
      type(extra_t), allocatable :: extras(:)

      call new_layout(layout, run)
      call run%model%get_extras(extras)
      call add_derived_constants(run, layout%constants)
      call new_coordinates(coordinates, run, error)
      call move_alloc(found, self%found)
      self%names = ''
      allocate (self%items(size(coordinates%scales) + size(layout%profile_axes) + size(layout%constants) + 2*size(layout%lists) &
         & + size(layout%fields) + size(layout%profiles) + size(extras)))
      call add_coordinates(self, coordinates, layout, error)
      call add_constants(self, layout%constants, error)
      call add_lists(self, layout%lists, error)
      call add_fields(self, coordinates, layout, error)
      call add_profiles(self, coordinates, layout, run, error)
      call add_extras(self, extras, error)
   end subroutine new_arrays

   !> Add one more array, which gets its values afterwards.
   subroutine add(self, field, role, dimensions, shape, error)
      !> The arrays, the last one of which is new.
      type(arrays_t), target, intent(inout) :: self
      !> Its name, unit and meanings.
      type(field_t), intent(in) :: field
      !> One of `role_...`.
      integer(c_int32_t), intent(in) :: role
      !> Names of its dimensions, the slowest first.
      type(c_ptr), intent(in) :: dimensions(:)
      !> Number of values along each.
      integer(i8), intent(in) :: shape(:)
      !> Receives that there is too little memory.
      type(error_t), allocatable, intent(inout) :: error
      type(array_t), pointer :: item
      integer :: n

      self%n = self%n + 1
      self%names = self%names//' '//field%name
      item => self%items(self%n)
      call keep_text(field%name, item%info%name, error)
      call keep_text(field%unit, item%info%unit, error)
      call keep_text(field%long_name, item%info%long_name, error)
      call keep_text(field%flag_meanings, item%info%flag_meanings, error)
      n = size(shape)
      item%info%first_flag = int(field%first_flag, c_int32_t)
      item%info%rank = n
      item%info%role = role
      item%info%values = c_null_ptr
      item%info%states = c_null_ptr
      ! one more than there are, so that none of them is of size 0
      allocate (item%dimensions(n + 1), item%shape(n + 1), item%strides(n + 1))
      item%dimensions(n + 1) = c_null_ptr
      item%shape(n + 1) = 1
      item%strides(n + 1) = 1
      item%dimensions(:n) = dimensions
      item%shape(:n) = shape
      item%strides(:n) = strides_of(shape)
      item%info%dimensions = c_loc(item%dimensions)
      item%info%shape = c_loc(item%shape)
      item%info%strides = c_loc(item%strides)
   end subroutine add

   !> How many values stand from one to the next where the last dimension varies fastest.
   pure function strides_of(shape) result(strides)
      !> Number of values along each dimension.
      integer(i8), intent(in) :: shape(:)
      integer(i8) :: strides(size(shape))
      integer :: k

      strides = 1
      do k = size(shape) - 1, 1, -1
         strides(k) = strides(k + 1)*shape(k + 1)
      end do
   end function strides_of

   !> Give the last array numbers of its own.
   subroutine set_values(self, values, error)
      type(arrays_t), target, intent(inout) :: self
      !> The numbers.
      real(dp), intent(in) :: values(:)
      type(error_t), allocatable, intent(inout) :: error
      type(array_t), pointer :: item
      integer :: failure

      item => self%items(self%n)
      allocate (item%values(size(values)), stat=failure)
      if (failure == 0) then
         item%values(:) = values
         item%info%values = c_loc(item%values)
      else if (.not. allocated(error)) then
         call set_error(error, file_failure, too_little_memory)
      end if
   end subroutine set_values

   !> Give the last array states of its own.
   subroutine set_states(self, values, error)
      type(arrays_t), target, intent(inout) :: self
      !> Numbers of the states, NaN where there is none.
      real(dp), intent(in) :: values(:)
      type(error_t), allocatable, intent(inout) :: error
      type(array_t), pointer :: item
      integer(i8) :: i
      integer :: failure

      item => self%items(self%n)
      allocate (item%states(size(values)), stat=failure)
      if (failure == 0) then
         do i = 1, size(values, kind=i8)
            item%states(i) = to_state(values(i))
         end do
         item%info%states = c_loc(item%states)
      else if (.not. allocated(error)) then
         call set_error(error, file_failure, too_little_memory)
      end if
   end subroutine set_states

   !> Add what is swept, and the axes of the profiles.
   subroutine add_coordinates(self, coordinates, layout, error)
      type(arrays_t), target, intent(inout) :: self
      !> What is swept.
      type(coordinates_t), intent(in) :: coordinates
      !> Layout of the results file.
      type(layout_t), intent(in) :: layout
      type(error_t), allocatable, intent(inout) :: error
      type(c_ptr) :: axis
      integer :: k

      do k = 1, size(coordinates%scales)
         call add_scale(self, coordinates%scales(k), coordinates%dimensions(coordinates%dimension_of(k)), role_coordinate, error)
      end do
      do k = 1, size(layout%profile_axes)
         call keep_text(layout%profile_axes(k)%name, axis, error)
         call add_scale(self, layout%profile_axes(k), axis, role_coordinate, error)
      end do
   end subroutine add_coordinates

   !> Add values along a dimension.
   subroutine add_scale(self, scale, dimension, role, error)
      type(arrays_t), target, intent(inout) :: self
      !> The values, with name and unit.
      type(scale_t), intent(in) :: scale
      !> Name of the dimension.
      type(c_ptr), intent(in) :: dimension
      integer(c_int32_t), intent(in) :: role
      type(error_t), allocatable, intent(inout) :: error
      type(field_t) :: field

      field%name = scale%name
      field%unit = scale%unit
      field%long_name = scale%long_name
      field%flag_meanings = ''
      call add(self, field, role, [dimension], [size(scale%values, kind=i8)], error)
      call set_values(self, scale%values, error)
   end subroutine add_scale

   !> Add what has one value.
   subroutine add_constants(self, constants, error)
      type(arrays_t), target, intent(inout) :: self
      !> The constants.
      type(constant_t), intent(in) :: constants(:)
      type(error_t), allocatable, intent(inout) :: error
      type(field_t) :: field
      type(c_ptr) :: no_dimensions(0)
      integer(i8) :: no_shape(0)
      integer :: i

      do i = 1, size(constants)
         field%name = constants(i)%name
         field%unit = constants(i)%unit
         field%long_name = constants(i)%long_name
         field%flag_meanings = constants(i)%flag_meanings
         field%first_flag = constants(i)%first_flag
         call add(self, field, role_parameter, no_dimensions, no_shape, error)
         if (len(field%flag_meanings) == 0) then
            call set_values(self, [constants(i)%value], error)
         else
            call set_states(self, [constants(i)%value], error)
         end if
      end do
   end subroutine add_constants

   !> Add the lists, each behind the indices in it.
   subroutine add_lists(self, lists, error)
      type(arrays_t), target, intent(inout) :: self
      !> The lists.
      type(scale_t), intent(in) :: lists(:)
      type(error_t), allocatable, intent(inout) :: error
      type(scale_t) :: indices
      type(c_ptr) :: dimension
      integer :: i

      do i = 1, size(lists)
         call number_indices(lists(i), indices)
         call keep_text(indices%name, dimension, error)
         call add_scale(self, indices, dimension, role_coordinate, error)
         call add_scale(self, lists(i), dimension, role_list, error)
      end do
   end subroutine add_lists

   !> Add the results.
   subroutine add_fields(self, coordinates, layout, error)
      type(arrays_t), target, intent(inout) :: self
      type(coordinates_t), intent(in) :: coordinates
      type(layout_t), intent(in) :: layout
      type(error_t), allocatable, intent(inout) :: error
      integer :: i

      do i = 1, size(layout%fields)
         associate (field => layout%fields(i))
            ! the layout knows but one of the variables that are swept together
            if (has_word(coordinates%names, field%name)) cycle
            call add(self, field, role_result, coordinates%dimensions, coordinates%shape, error)
            if (field%column == 0 .and. len(field%flag_meanings) > 0) then
               call set_states(self, real(self%found%status, dp), error)
            else if (field%column == 0) then
               self%items(self%n)%info%values = c_loc(self%found%error_estimate(1))
            else if (len(field%flag_meanings) > 0) then
               call set_states(self, self%found%results(:, field%column), error)
            else
               self%items(self%n)%info%values = c_loc(self%found%results(1, field%column))
            end if
         end associate
      end do
   end subroutine add_fields

   !> Add the profiles.
   subroutine add_profiles(self, coordinates, layout, run, error)
      type(arrays_t), target, intent(inout) :: self
      type(coordinates_t), intent(in) :: coordinates
      type(layout_t), intent(in) :: layout
      !> The run, which says how profiles stand in memory.
      class(run_t), intent(in) :: run
      type(error_t), allocatable, intent(inout) :: error
      type(c_ptr), allocatable :: axes(:)
      integer :: i, k, counts(3), rank

      if (size(layout%profiles) == 0) return
      allocate (axes(size(layout%profile_axes)))
      do k = 1, size(axes)
         call keep_text(layout%profile_axes(k)%name, axes(k), error)
      end do
      counts = run%profile_shape()
      rank = size(coordinates%shape)
      do i = 1, size(layout%profiles)
         call add(self, layout%profiles(i), role_profile, [coordinates%dimensions, axes], &
            & [coordinates%shape, layout%profile_shape()], error)
         ! all profiles of a point stand together
         self%items(self%n)%strides(:rank) = strides_of(coordinates%shape)*product(int(counts, i8))
         self%items(self%n)%info%values = c_loc(self%found%profiles(1, 1, i, 1))
      end do
   end subroutine add_profiles

   !> Add what a fit has beside its results. Words are states with the words for their meanings.
   subroutine add_extras(self, extras, error)
      type(arrays_t), target, intent(inout) :: self
      !> What there is.
      type(extra_t), intent(in) :: extras(:)
      type(error_t), allocatable, intent(inout) :: error
      type(field_t) :: field
      type(c_ptr), allocatable :: dimensions(:)
      integer :: i, k

      do i = 1, size(extras)
         associate (extra => extras(i))
            field%name = extra%name
            field%unit = file_unit(extra%unit)
            field%long_name = extra%long_name
            field%first_flag = extra%first_flag
            field%flag_meanings = ''
            if (allocated(extra%flag_meanings)) field%flag_meanings = extra%flag_meanings
            if (allocated(dimensions)) deallocate (dimensions)
            allocate (dimensions(count_words(extra%dimensions)))
            do k = 1, size(dimensions)
               call keep_text(get_word(extra%dimensions, k), dimensions(k), error)
            end do
            if (allocated(extra%words)) then
               field%flag_meanings = extra%words
               field%first_flag = 0
               call add(self, field, role_words, dimensions, [int(count_words(extra%words), i8)], error)
               call set_states(self, [(real(k, dp), k=0, count_words(extra%words) - 1)], error)
            else if (len(field%flag_meanings) > 0) then
               call add(self, field, role_extra, dimensions, int(extra%counts, i8), error)
               call set_states(self, extra%values, error)
            else
               call add(self, field, merge(role_coordinate, role_extra, extra%dimensions == extra%name), dimensions, &
                  & int(extra%counts, i8), error)
               call set_values(self, extra%values, error)
            end if
         end associate
      end do
   end subroutine add_extras

end module adfric_c_arrays

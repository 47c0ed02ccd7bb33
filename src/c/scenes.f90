! SPDX-License-Identifier: GPL-3.0-or-later
!> The functions of adfric.h that open a scene some of whose values come later, and say what a case has.
module adfric_c_scenes
   use, intrinsic :: iso_c_binding, only: c_f_pointer, c_int, c_int32_t, c_int64_t, c_ptr
   use adfric_api_results, only: describe_name
   use adfric_api_state, only: read_state, case_state_t
   use adfric_api_values, only: error_of, find_index
   use adfric_base_error, only: error_t, file_failure, input_failure, set_error
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: longest_name, show_count
   use adfric_c_cases, only: keep_case, take_case
   use adfric_c_handles, only: leave_object
   use adfric_c_tables, only: describe_variable, result_info_t, set_result, variable_info_t
   use adfric_c_texts, only: read_text, read_words, refuse_null, status_of, too_little_memory
   implicit none (type, external)
   private

   !> Most variables that get their values later.
   integer, parameter :: most_names = 1000

contains

   !> See adfric.h.
   integer(c_int) function open_scene(text, n_names, names, opened) bind(c, name='adfric_open_scene') result(status)
      type(c_ptr), intent(in), value :: text
      integer(c_int32_t), intent(in), value :: n_names
      type(c_ptr), intent(in), value :: names, opened
      type(case_state_t), pointer :: state
      type(error_t), allocatable :: error
      character(longest_name), allocatable :: later(:)
      character(:), allocatable :: input
      integer :: failure

      nullify (state)
      allocate (later(0))
      call refuse_null(opened, 'opened', error)
      if (.not. allocated(error)) call read_text(text, 'text', input, error)
      if (.not. allocated(error) .and. (n_names < 0 .or. n_names > most_names)) then
         !$omp critical (adfric_api)
         call set_error(error, input_failure, 'n_names: out of range, given '//show_count(int(n_names))//', allowed: 0 to '// &
            & show_count(most_names))
         !$omp end critical (adfric_api)
      end if
      if (.not. allocated(error) .and. n_names > 0) call read_words(names, 'names', int(n_names), later, error)
      if (.not. allocated(error)) then
         allocate (state, stat=failure)
         if (failure /= 0) call set_error(error, file_failure, too_little_memory)
      end if
      !$omp critical (adfric_api)
      if (.not. allocated(error)) call read_state(state, input, is_text=.true., error=error, later=later)
      call keep_case(state, opened, error)
      !$omp end critical (adfric_api)
      status = status_of(error)
   end function open_scene

   !> See adfric.h.
   integer(c_int) function variable_of(self, name, variable) bind(c, name='adfric_variable_of') result(status)
      integer(c_int64_t), intent(in), value :: self
      type(c_ptr), intent(in), value :: name, variable
      type(case_state_t), pointer :: state
      type(error_t), allocatable :: error
      type(problems_t) :: problems
      type(variable_info_t), pointer :: info
      type(variable_info_t) :: found
      character(:), allocatable :: word
      integer :: index

      call take_case(self, state, error)
      if (.not. allocated(error)) then
         call refuse_null(variable, 'variable', error)
         if (.not. allocated(error)) call read_text(name, 'name', word, error)
         !$omp critical (adfric_api)
         if (.not. allocated(error)) then
            call find_index(state%run%model, word, index, problems)
            call error_of(problems, error)
            if (index > 0) call describe_variable(found, state%run%model%variables(index), error)
         end if
         !$omp end critical (adfric_api)
         if (.not. allocated(error)) then
            call c_f_pointer(variable, info)
            info = found
         end if
         call leave_object(self)
      end if
      status = status_of(error)
   end function variable_of

   !> See adfric.h.
   integer(c_int) function describe(self, name, described) bind(c, name='adfric_describe') result(status)
      integer(c_int64_t), intent(in), value :: self
      type(c_ptr), intent(in), value :: name, described
      type(case_state_t), pointer :: state
      type(error_t), allocatable :: error
      type(result_info_t), pointer :: info
      type(result_info_t) :: found
      character(:), allocatable :: word, unit, long_name, meanings

      call take_case(self, state, error)
      if (.not. allocated(error)) then
         call refuse_null(described, 'described', error)
         if (.not. allocated(error)) call read_text(name, 'name', word, error)
         !$omp critical (adfric_api)
         if (.not. allocated(error)) then
            call describe_name(state%run%model, state%input, word, unit, long_name, meanings, error)
            if (.not. allocated(error)) call set_result(found, word, unit, long_name, meanings, error)
         end if
         !$omp end critical (adfric_api)
         if (.not. allocated(error)) then
            call c_f_pointer(described, info)
            info = found
         end if
         call leave_object(self)
      end if
      status = status_of(error)
   end function describe

end module adfric_c_scenes

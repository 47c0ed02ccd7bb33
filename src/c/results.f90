! SPDX-License-Identifier: GPL-3.0-or-later
!> The functions of adfric.h that solve a case, and that give out and close results.
module adfric_c_results
   use, intrinsic :: iso_c_binding, only: c_double, c_f_pointer, c_funptr, c_int, c_int32_t, c_int64_t, c_loc, c_null_funptr, &
      & c_null_ptr, c_ptr
   use omp_lib, only: omp_get_max_threads
   use adfric_api_numbers, only: find_number
   use adfric_api_results, only: refuse
   use adfric_api_solution, only: solve_by_threads
   use adfric_api_state, only: case_state_t
   use adfric_base_error, only: error_t, file_failure, input_failure, set_error
   use adfric_base_text, only: show_count, to_lower
   use adfric_base_words, only: get_word
   use adfric_c_arrays, only: array_info_t, arrays_t, new_arrays
   use adfric_c_attributes, only: attribute_info_t, attributes_t, new_attributes
   use adfric_c_cases, only: take_case
   use adfric_c_handles, only: add_handle, end_handle, kind_results, leave_object, let_stop, take_object
   use adfric_c_listener, only: listener_t, new_listener
   use adfric_c_indices, only: check_index
   use adfric_c_texts, only: read_text, refuse_null, status_of, too_little_memory
   use adfric_run_memory_sink, only: memory_sink_t
   use adfric_run_summary, only: run_summary_t
   implicit none (type, external)
   private

   !> What a case has found.
   type :: results_t
      !> Its numbers.
      type(arrays_t) :: arrays
      !> What is said of it as a whole.
      type(attributes_t) :: attributes
   end type results_t

contains

   !> See adfric.h.
   integer(c_int) function solve(self, n_threads, progress, context, found) bind(c, name='adfric_solve') result(status)
      integer(c_int64_t), intent(in), value :: self
      integer(c_int32_t), intent(in), value :: n_threads
      type(c_funptr), intent(in), value :: progress
      type(c_ptr), intent(in), value :: context, found
      type(listener_t) :: listener
      type(case_state_t), pointer :: state
      type(error_t), allocatable :: error

      call refuse_null(found, 'found', error)
      if (.not. allocated(error)) call take_case(self, state, error)
      if (.not. allocated(error)) then
         call new_listener(listener, self, progress, context)
         call let_stop(self, 1_c_int)
         call solve_case(state, int(n_threads), listener, found, error)
         call let_stop(self, 0_c_int)
         call leave_object(self)
      end if
      status = status_of(error)
   end function solve

   !> See adfric.h.
   integer(c_int) function solve_point(self, n_names, names, values) bind(c, name='adfric_solve_point') result(status)
      integer(c_int64_t), intent(in), value :: self
      integer(c_int32_t), intent(in), value :: n_names
      type(c_ptr), intent(in), value :: names, values
      type(case_state_t), pointer :: state
      type(error_t), allocatable :: error
      real(c_double), pointer :: numbers(:)
      type(c_ptr), pointer :: list(:)

      call refuse_null(names, 'names', error)
      if (.not. allocated(error)) call refuse_null(values, 'values', error)
      if (.not. allocated(error)) call take_case(self, state, error)
      if (.not. allocated(error)) then
         call c_f_pointer(names, list, [max(n_names, 0_c_int32_t)])
         call c_f_pointer(values, numbers, [max(n_names, 0_c_int32_t)])
         call let_stop(self, 1_c_int)
         call solve_single(state, self, list, numbers, error)
         call let_stop(self, 0_c_int)
         call leave_object(self)
      end if
      status = status_of(error)
   end function solve_point

   !> Solve a case of one point.
   subroutine solve_single(state, handle, names, values, error)
      type(case_state_t), intent(inout) :: state
      !> Its handle.
      integer(c_int64_t), intent(in) :: handle
      !> Names of results.
      type(c_ptr), intent(in) :: names(:)
      !> Receives their values; left as they are if there is an error.
      real(c_double), intent(inout) :: values(:)
      !> Says what is wrong, or that the call was stopped.
      type(error_t), allocatable, intent(out) :: error
      type(memory_sink_t), allocatable :: sink
      type(listener_t) :: listener
      character(:), allocatable :: name
      real(c_double) :: found(size(names))
      integer :: k

      call new_listener(listener, handle, c_null_funptr, c_null_ptr)
      !$omp critical (adfric_api)
      if (state%run%plan%n_points() == 1) then
         call state%check_case(error)
      else
         call set_error(error, input_failure, 'the case has '//show_count(state%run%plan%n_points())// &
            & ' points, allowed: one, or adfric_solve')
      end if
      !$omp end critical (adfric_api)
      if (allocated(error)) return
      state%is_spent = state%is_fit
      call solve_by_threads(state%run, sink, error, progress=listener)
      if (allocated(error)) return
      !$omp critical (adfric_api)
      do k = 1, size(names)
         call read_text(names(k), 'name', name, error)
         if (.not. allocated(error)) call find_number(state%run%model, sink, name, found(k), error)
         if (allocated(error)) exit
      end do
      !$omp end critical (adfric_api)
      if (.not. allocated(error)) values(:) = found
   end subroutine solve_single

   !> Solve a case, and give what it finds a handle.
   subroutine solve_case(state, n_threads, listener, found, error)
      type(case_state_t), intent(inout) :: state
      !> Number of threads; 0: as many as OpenMP gives.
      integer, intent(in) :: n_threads
      !> Watches the call.
      class(listener_t), intent(inout) :: listener
      !> Receives the handle of the results.
      type(c_ptr), intent(in) :: found
      type(error_t), allocatable, intent(out) :: error
      type(memory_sink_t), allocatable :: sink
      type(run_summary_t) :: summary

      !$omp critical (adfric_api)
      if (n_threads < 0) then
         call set_error(error, input_failure, 'n_threads: out of range, given '//show_count(n_threads)// &
            & ', allowed: an integer >= 0')
      else
         call state%check_case(error)
      end if
      !$omp end critical (adfric_api)
      state%is_spent = state%is_fit
      if (.not. allocated(error)) call solve_by_threads(state%run, sink, error, merge(n_threads, omp_get_max_threads(), &
         & n_threads > 0), listener, summary)
      if (.not. allocated(error)) call keep_results(state, sink, summary, found, error)
   end subroutine solve_case

   !> Keep what was found.
   subroutine keep_results(state, sink, summary, found, error)
      type(case_state_t), intent(in) :: state
      !> What was found; the results take it over.
      type(memory_sink_t), allocatable, intent(inout) :: sink
      !> Counts and times of the solution.
      type(run_summary_t), intent(in) :: summary
      type(c_ptr), intent(in) :: found
      !> Allocated if there is too little memory.
      type(error_t), allocatable, intent(out) :: error
      type(results_t), pointer :: results
      integer(c_int64_t), pointer :: handle
      integer :: failure

      allocate (results, stat=failure)
      if (failure /= 0) then
         call set_error(error, file_failure, too_little_memory)
         return
      end if
      !$omp critical (adfric_api)
      call new_attributes(results%attributes, state%run, sink, summary%wall_seconds, error)
      call new_arrays(results%arrays, state%run, sink, error)
      !$omp end critical (adfric_api)
      if (.not. allocated(error)) then
         call c_f_pointer(found, handle)
         call add_handle(kind_results, c_loc(results), handle, error)
      end if
      if (allocated(error)) deallocate (results)
   end subroutine keep_results

   !> Begin to read results.
   subroutine take_results(self, results, error)
      !> Handle of the results.
      integer(c_int64_t), intent(in) :: self
      !> Receives the results.
      type(results_t), pointer, intent(out) :: results
      !> Allocated if there are no such results, or they are just being closed.
      type(error_t), allocatable, intent(out) :: error
      type(c_ptr) :: object

      nullify (results)
      call take_object(self, kind_results, .false., object, error)
      if (.not. allocated(error)) call c_f_pointer(object, results)
   end subroutine take_results

   !> See adfric.h.
   integer(c_int) function array_count(self, n) bind(c, name='adfric_array_count') result(status)
      integer(c_int64_t), intent(in), value :: self
      type(c_ptr), intent(in), value :: n
      type(results_t), pointer :: results
      type(error_t), allocatable :: error
      integer(c_int32_t), pointer :: number

      call take_results(self, results, error)
      if (.not. allocated(error)) then
         call refuse_null(n, 'n', error)
         if (.not. allocated(error)) then
            call c_f_pointer(n, number)
            number = int(results%arrays%n, c_int32_t)
         end if
         call leave_object(self)
      end if
      status = status_of(error)
   end function array_count

   !> See adfric.h.
   integer(c_int) function array_at(self, index, array) bind(c, name='adfric_array_at') result(status)
      integer(c_int64_t), intent(in), value :: self
      integer(c_int32_t), intent(in), value :: index
      type(c_ptr), intent(in), value :: array
      type(results_t), pointer :: results
      type(error_t), allocatable :: error

      call take_results(self, results, error)
      if (.not. allocated(error)) then
         call check_index('array', index, results%arrays%n, error)
         if (.not. allocated(error)) call give_array(results%arrays, int(index) + 1, array, error)
         call leave_object(self)
      end if
      status = status_of(error)
   end function array_at

   !> See adfric.h.
   integer(c_int) function array_of(self, name, array) bind(c, name='adfric_array_of') result(status)
      integer(c_int64_t), intent(in), value :: self
      type(c_ptr), intent(in), value :: name, array
      type(results_t), pointer :: results
      type(error_t), allocatable :: error
      character(:), allocatable :: word
      integer :: index

      call take_results(self, results, error)
      if (.not. allocated(error)) then
         call read_text(name, 'name', word, error)
         !$omp critical (adfric_api)
         if (.not. allocated(error)) call find_index(results%arrays, word, index, error)
         !$omp end critical (adfric_api)
         if (.not. allocated(error)) call give_array(results%arrays, index, array, error)
         call leave_object(self)
      end if
      status = status_of(error)
   end function array_of

   !> Find an array by its name.
   subroutine find_index(arrays, name, index, error)
      type(arrays_t), intent(in) :: arrays
      !> The name; capitals do not count.
      character(*), intent(in) :: name
      !> Receives the index, from 1; 0 if there is none.
      integer, intent(out) :: index
      !> Allocated if there is no such array.
      type(error_t), allocatable, intent(out) :: error

      do index = arrays%n, 1, -1
         if (get_word(arrays%names, index) == to_lower(name)) return
      end do
      call refuse(name, 'array', arrays%names, error)
   end subroutine find_index

   !> Give out an array.
   subroutine give_array(arrays, index, to, error)
      type(arrays_t), intent(in) :: arrays
      !> Index of the array, from 1.
      integer, intent(in) :: index
      !> Receives what is known of it.
      type(c_ptr), intent(in) :: to
      !> Allocated if that is null.
      type(error_t), allocatable, intent(out) :: error
      type(array_info_t), pointer :: info

      call refuse_null(to, 'array', error)
      if (allocated(error)) return
      call c_f_pointer(to, info)
      info = arrays%items(index)%info
   end subroutine give_array

   !> See adfric.h.
   integer(c_int) function attribute_count(self, n) bind(c, name='adfric_attribute_count') result(status)
      integer(c_int64_t), intent(in), value :: self
      type(c_ptr), intent(in), value :: n
      type(results_t), pointer :: results
      type(error_t), allocatable :: error
      integer(c_int32_t), pointer :: number

      call take_results(self, results, error)
      if (.not. allocated(error)) then
         call refuse_null(n, 'n', error)
         if (.not. allocated(error)) then
            call c_f_pointer(n, number)
            number = int(results%attributes%n, c_int32_t)
         end if
         call leave_object(self)
      end if
      status = status_of(error)
   end function attribute_count

   !> See adfric.h.
   integer(c_int) function attribute_at(self, index, attribute) bind(c, name='adfric_attribute') result(status)
      integer(c_int64_t), intent(in), value :: self
      integer(c_int32_t), intent(in), value :: index
      type(c_ptr), intent(in), value :: attribute
      type(results_t), pointer :: results
      type(error_t), allocatable :: error
      type(attribute_info_t), pointer :: info

      call take_results(self, results, error)
      if (.not. allocated(error)) then
         call check_index('attribute', index, results%attributes%n, error)
         if (.not. allocated(error)) call refuse_null(attribute, 'attribute', error)
         if (.not. allocated(error)) then
            call c_f_pointer(attribute, info)
            info = results%attributes%items(index + 1)%info
         end if
         call leave_object(self)
      end if
      status = status_of(error)
   end function attribute_at

   !> See adfric.h.
   integer(c_int) function close_results(self) bind(c, name='adfric_close_results') result(status)
      integer(c_int64_t), intent(in), value :: self
      type(results_t), pointer :: results
      type(error_t), allocatable :: error
      type(c_ptr) :: object

      call take_object(self, kind_results, .true., object, error)
      if (.not. allocated(error)) then
         call c_f_pointer(object, results)
         call end_handle(self)
         deallocate (results)
      end if
      status = status_of(error)
   end function close_results

end module adfric_c_results

! SPDX-License-Identifier: GPL-3.0-or-later
!> The functions of adfric.h that open, check and close cases.
module adfric_c_cases
   use, intrinsic :: iso_c_binding, only: c_f_pointer, c_int, c_int64_t, c_loc, c_ptr
   use adfric_api_state, only: open_model, read_state, case_state_t
   use adfric_base_error, only: error_t, file_failure, set_error
   use adfric_c_handles, only: add_handle, end_handle, kind_case, leave_object, take_object
   use adfric_c_texts, only: keep_text, read_text, refuse_null, status_of, too_little_memory
   implicit none (type, external)
   private
   public :: take_case, keep_case

   !> Where a case is from.
   integer, parameter :: from_model = 1, from_file = 2, from_text = 3

contains

   !> See adfric.h.
   integer(c_int) function open_case(model, opened) bind(c, name='adfric_open') result(status)
      type(c_ptr), intent(in), value :: model, opened

      call make_case(from_model, model, 'model', opened, status)
   end function open_case

   !> See adfric.h.
   integer(c_int) function read_case(path, opened) bind(c, name='adfric_read') result(status)
      type(c_ptr), intent(in), value :: path, opened

      call make_case(from_file, path, 'path', opened, status)
   end function read_case

   !> See adfric.h.
   integer(c_int) function read_case_text(text, opened) bind(c, name='adfric_read_text') result(status)
      type(c_ptr), intent(in), value :: text, opened

      call make_case(from_text, text, 'text', opened, status)
   end function read_case_text

   !> Make a case with a handle.
   subroutine make_case(from, given, what, opened, status)
      !> One of `from_...`.
      integer, intent(in) :: from
      !> Name of the model, name of the input, or its text.
      type(c_ptr), intent(in) :: given
      !> What the header calls that.
      character(*), intent(in) :: what
      !> Receives the handle.
      type(c_ptr), intent(in) :: opened
      !> Receives what has become of the call.
      integer(c_int), intent(out) :: status
      type(case_state_t), pointer :: state
      type(error_t), allocatable :: error
      character(:), allocatable :: text
      integer :: failure

      nullify (state)
      call refuse_null(opened, 'opened', error)
      if (.not. allocated(error)) call read_text(given, what, text, error)
      if (.not. allocated(error)) then
         allocate (state, stat=failure)
         if (failure /= 0) call set_error(error, file_failure, too_little_memory)
      end if
      !$omp critical (adfric_api)
      if (.not. allocated(error)) then
         if (from == from_model) then
            call open_model(state, text, error)
         else
            call read_state(state, text, is_text=from == from_text, error=error)
         end if
      end if
      call keep_case(state, opened, error)
      !$omp end critical (adfric_api)
      status = status_of(error)
   end subroutine make_case

   !> Give a case a handle, or end it after an error.
   subroutine keep_case(state, opened, error)
      !> The case; null if there is none. It is gone after an error.
      type(case_state_t), pointer, intent(inout) :: state
      !> Receives the handle.
      type(c_ptr), intent(in) :: opened
      !> In: what was wrong before, if anything was. Out: also that there is no memory for a handle.
      type(error_t), allocatable, intent(inout) :: error
      integer(c_int64_t), pointer :: handle

      if (.not. allocated(error)) then
         call c_f_pointer(opened, handle)
         call add_handle(kind_case, c_loc(state), handle, error)
      end if
      if (allocated(error) .and. associated(state)) deallocate (state)
   end subroutine keep_case

   !> See adfric.h.
   integer(c_int) function close_case(self) bind(c, name='adfric_close_case') result(status)
      integer(c_int64_t), intent(in), value :: self
      type(case_state_t), pointer :: state
      type(error_t), allocatable :: error

      call take_case(self, state, error)
      if (.not. allocated(error)) then
         call end_handle(self)
         !$omp critical (adfric_api)
         deallocate (state)
         !$omp end critical (adfric_api)
      end if
      status = status_of(error)
   end function close_case

   !> Begin to use a case.
   subroutine take_case(self, state, error)
      !> Handle of the case.
      integer(c_int64_t), intent(in) :: self
      !> Receives the case.
      type(case_state_t), pointer, intent(out) :: state
      !> Allocated if there is no such case, or another thread uses it.
      type(error_t), allocatable, intent(out) :: error
      type(c_ptr) :: object

      nullify (state)
      call take_object(self, kind_case, .true., object, error)
      if (.not. allocated(error)) call c_f_pointer(object, state)
   end subroutine take_case

   !> See adfric.h.
   integer(c_int) function model_of(self, model) bind(c, name='adfric_model_of') result(status)
      integer(c_int64_t), intent(in), value :: self
      type(c_ptr), intent(in), value :: model

      call give_text(self, .false., model, status)
   end function model_of

   !> See adfric.h.
   integer(c_int) function scene_of(self, scene) bind(c, name='adfric_scene_of') result(status)
      integer(c_int64_t), intent(in), value :: self
      type(c_ptr), intent(in), value :: scene

      call give_text(self, .true., scene, status)
   end function scene_of

   !> Give the name of the model of a case, or its scene.
   subroutine give_text(self, is_scene, text, status)
      integer(c_int64_t), intent(in) :: self
      !> Is the scene wanted, and not the name of the model?
      logical, intent(in) :: is_scene
      !> Receives the text.
      type(c_ptr), intent(in) :: text
      integer(c_int), intent(out) :: status
      type(case_state_t), pointer :: state
      type(error_t), allocatable :: error
      type(c_ptr), pointer :: given
      type(c_ptr) :: kept
      character(:), allocatable :: words

      call take_case(self, state, error)
      if (.not. allocated(error)) then
         call refuse_null(text, trim(merge('scene', 'model', is_scene)), error)
         if (.not. allocated(error)) then
            words = state%run%model%name
            if (is_scene) words = ''
            if (is_scene .and. allocated(state%run%model%scene)) words = state%run%model%scene
            call keep_text(words, kept, error)
         end if
         if (.not. allocated(error)) then
            call c_f_pointer(text, given)
            given = kept
         end if
         call leave_object(self)
      end if
      status = status_of(error)
   end subroutine give_text

   !> See adfric.h.
   integer(c_int) function point_count(self, n) bind(c, name='adfric_point_count') result(status)
      integer(c_int64_t), intent(in), value :: self
      type(c_ptr), intent(in), value :: n
      type(case_state_t), pointer :: state
      type(error_t), allocatable :: error
      integer(c_int64_t), pointer :: number

      call take_case(self, state, error)
      if (.not. allocated(error)) then
         call refuse_null(n, 'n', error)
         if (.not. allocated(error)) then
            call c_f_pointer(n, number)
            number = state%run%plan%n_points()
         end if
         call leave_object(self)
      end if
      status = status_of(error)
   end function point_count

   !> See adfric.h.
   integer(c_int) function check_case(self) bind(c, name='adfric_check') result(status)
      integer(c_int64_t), intent(in), value :: self
      type(case_state_t), pointer :: state
      type(error_t), allocatable :: error

      call take_case(self, state, error)
      if (.not. allocated(error)) then
         !$omp critical (adfric_api)
         call state%check_case(error)
         !$omp end critical (adfric_api)
         call leave_object(self)
      end if
      status = status_of(error)
   end function check_case

end module adfric_c_cases

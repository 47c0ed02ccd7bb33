! SPDX-License-Identifier: GPL-3.0-or-later
!> The functions of adfric.h that say which models there are, and what they have.
module adfric_c_models
   use, intrinsic :: iso_c_binding, only: c_associated, c_f_pointer, c_int, c_int32_t, c_loc, c_ptr
   use adfric, only: known_models, new_model
   use adfric_base_error, only: error_t, file_failure, input_failure, set_error
   use adfric_base_version, only: git_revision, program_version
   use adfric_base_words, only: count_words, get_word
   use adfric_c_indices, only: check_index
   use adfric_c_tables, only: model_info_t, new_tables, result_info_t, tables_t, variable_info_t
   use adfric_c_texts, only: keep_text, read_text, refuse_null, status_of, too_little_memory
   use adfric_input_run, only: say_unknown_model
   use adfric_describe_model, only: model_t
   implicit none (type, external)
   private

   interface
      !> Index where the tables of a model are kept; null if there is no such index.
      type(c_ptr) function c_tables_at(index) bind(c, name='adfric_tables_at')
         import :: c_int, c_ptr
         implicit none (type, external)
         !> Index of the model, from 0.
         integer(c_int), intent(in), value :: index
      end function c_tables_at
   end interface

contains

   !> See adfric.h.
   type(c_ptr) function version() bind(c, name='adfric_version')
      type(error_t), allocatable :: error

      call keep_text(program_version//' ('//git_revision//')', version, error)
   end function version

   !> See adfric.h.
   integer(c_int) function model_count(n) bind(c, name='adfric_model_count') result(status)
      type(c_ptr), intent(in), value :: n
      integer(c_int32_t), pointer :: number
      type(error_t), allocatable :: error

      call refuse_null(n, 'n', error)
      if (.not. allocated(error)) then
         call c_f_pointer(n, number)
         number = int(count_words(known_models), c_int32_t)
      end if
      status = status_of(error)
   end function model_count

   !> See adfric.h.
   integer(c_int) function model_at(index, model) bind(c, name='adfric_model') result(status)
      integer(c_int32_t), intent(in), value :: index
      type(c_ptr), intent(in), value :: model
      type(model_info_t), pointer :: info
      type(tables_t), pointer :: tables
      type(error_t), allocatable :: error

      call refuse_null(model, 'model', error)
      !$omp critical (adfric_api)
      if (.not. allocated(error)) call check_index('model', index, count_words(known_models), error)
      if (.not. allocated(error)) call find_tables(int(index), tables, error)
      if (.not. allocated(error)) then
         call c_f_pointer(model, info)
         info = tables%model
      end if
      status = status_of(error)
      !$omp end critical (adfric_api)
   end function model_at

   !> See adfric.h.
   integer(c_int) function variable_at(model, index, variable) bind(c, name='adfric_variable') result(status)
      type(c_ptr), intent(in), value :: model
      integer(c_int32_t), intent(in), value :: index
      type(c_ptr), intent(in), value :: variable
      type(variable_info_t), pointer :: info
      type(tables_t), pointer :: tables
      type(error_t), allocatable :: error

      call refuse_null(variable, 'variable', error)
      !$omp critical (adfric_api)
      if (.not. allocated(error)) call find_model(model, tables, error)
      if (.not. allocated(error)) call check_index('variable', index, size(tables%variables), error)
      if (.not. allocated(error)) then
         call c_f_pointer(variable, info)
         info = tables%variables(index + 1)
      end if
      status = status_of(error)
      !$omp end critical (adfric_api)
   end function variable_at

   !> See adfric.h.
   integer(c_int) function result_at(model, index, result) bind(c, name='adfric_result') result(status)
      type(c_ptr), intent(in), value :: model
      integer(c_int32_t), intent(in), value :: index
      type(c_ptr), intent(in), value :: result
      type(tables_t), pointer :: tables
      type(error_t), allocatable :: error

      call refuse_null(result, 'result', error)
      !$omp critical (adfric_api)
      if (.not. allocated(error)) call find_model(model, tables, error)
      if (.not. allocated(error)) call give_row(tables%results, 'result', index, result, error)
      status = status_of(error)
      !$omp end critical (adfric_api)
   end function result_at

   !> See adfric.h.
   integer(c_int) function profile_at(model, index, profile) bind(c, name='adfric_profile') result(status)
      type(c_ptr), intent(in), value :: model
      integer(c_int32_t), intent(in), value :: index
      type(c_ptr), intent(in), value :: profile
      type(tables_t), pointer :: tables
      type(error_t), allocatable :: error

      call refuse_null(profile, 'profile', error)
      !$omp critical (adfric_api)
      if (.not. allocated(error)) call find_model(model, tables, error)
      if (.not. allocated(error)) call give_row(tables%profiles, 'profile', index, profile, error)
      status = status_of(error)
      !$omp end critical (adfric_api)
   end function profile_at

   !> Give a row of results or profiles.
   subroutine give_row(rows, word, index, to, error)
      !> The rows.
      type(result_info_t), intent(in) :: rows(:)
      !> What a row is.
      character(*), intent(in) :: word
      !> Index of the row, from 0.
      integer(c_int32_t), intent(in) :: index
      !> Receives the row.
      type(c_ptr), intent(in) :: to
      !> Allocated if there is no such row.
      type(error_t), allocatable, intent(out) :: error
      type(result_info_t), pointer :: info

      call check_index(word, index, size(rows), error)
      if (allocated(error)) return
      call c_f_pointer(to, info)
      info = rows(index + 1)
   end subroutine give_row

   !> Find the tables of a model by its name.
   subroutine find_model(given, tables, error)
      !> Name of the model.
      type(c_ptr), intent(in) :: given
      !> Receives the tables.
      type(tables_t), pointer, intent(out) :: tables
      !> Allocated if there is no such model, or no memory for its tables.
      type(error_t), allocatable, intent(out) :: error
      character(:), allocatable :: name
      integer :: i

      nullify (tables)
      call read_text(given, 'model', name, error)
      if (allocated(error)) return
      do i = 1, count_words(known_models)
         if (get_word(known_models, i) /= name) cycle
         call find_tables(i - 1, tables, error)
         return
      end do
      call set_error(error, input_failure, '&job model: '//say_unknown_model(name, known_models))
   end subroutine find_model

   !> Find the tables of a model, or make them.
   subroutine find_tables(index, tables, error)
      integer, intent(in) :: index
      type(tables_t), pointer, intent(out) :: tables
      !> Allocated if there is too little memory.
      type(error_t), allocatable, intent(out) :: error
      type(c_ptr), pointer :: kept
      class(model_t), allocatable :: model
      integer :: failure

      nullify (tables)
      call c_f_pointer(c_tables_at(int(index, c_int)), kept)
      if (c_associated(kept)) then
         call c_f_pointer(kept, tables)
         return
      end if
      call new_model(model, get_word(known_models, index + 1), error)
      if (allocated(error)) return
      allocate (tables, stat=failure)
      if (failure /= 0) then
         call set_error(error, file_failure, too_little_memory)
         return
      end if
      call new_tables(tables, model, error)
      if (allocated(error)) then
         deallocate (tables)
      else
         kept = c_loc(tables)
      end if
   end subroutine find_tables

end module adfric_c_models

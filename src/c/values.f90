! SPDX-License-Identifier: GPL-3.0-or-later
!> The functions of adfric.h that set and sweep the variables of a case.
module adfric_c_values
   use, intrinsic :: iso_c_binding, only: c_double, c_f_pointer, c_int, c_int32_t, c_int64_t, c_ptr
   use adfric_api_state, only: case_state_t
   use adfric_base_error, only: error_t, input_failure, set_error
   use adfric_base_kinds, only: dp
   use adfric_base_text, only: show_count
   use adfric_c_cases, only: take_case
   use adfric_c_handles, only: leave_object
   use adfric_c_texts, only: read_text, refuse_null, status_of
   implicit none (type, external)
   private

   !> Letters of a name that are looked at where several are given.
   integer, parameter :: longest_name = 200
   !> Most variables that are swept together; no model has so many.
   integer(c_int64_t), parameter :: most_names = 1000

contains

   !> See adfric.h.
   integer(c_int) function set_real(self, name, value) bind(c, name='adfric_set_real') result(status)
      integer(c_int64_t), intent(in), value :: self
      type(c_ptr), intent(in), value :: name
      real(c_double), intent(in), value :: value

      call give_value(self, name, value, status)
   end function set_real

   !> See adfric.h.
   integer(c_int) function set_integer(self, name, value) bind(c, name='adfric_set_integer') result(status)
      integer(c_int64_t), intent(in), value :: self
      type(c_ptr), intent(in), value :: name
      integer(c_int64_t), intent(in), value :: value

      call give_value(self, name, real(value, dp), status)
   end function set_integer

   !> See adfric.h.
   integer(c_int) function set_logical(self, name, value) bind(c, name='adfric_set_logical') result(status)
      integer(c_int64_t), intent(in), value :: self
      type(c_ptr), intent(in), value :: name
      integer(c_int), intent(in), value :: value

      call give_value(self, name, value /= 0, status)
   end function set_logical

   !> See adfric.h.
   integer(c_int) function set_word(self, name, value) bind(c, name='adfric_set_word') result(status)
      integer(c_int64_t), intent(in), value :: self
      type(c_ptr), intent(in), value :: name, value
      type(error_t), allocatable :: error
      character(:), allocatable :: word

      call read_text(value, 'value', word, error)
      if (allocated(error)) then
         status = status_of(error)
      else
         call give_value(self, name, word, status)
      end if
   end function set_word

   !> Give a variable a value.
   subroutine give_value(self, name, value, status)
      !> Handle of the case.
      integer(c_int64_t), intent(in) :: self
      !> Name of the variable.
      type(c_ptr), intent(in) :: name
      !> The value: a real number of kind `dp`, a logical or a word.
      class(*), intent(in) :: value
      !> Receives what has become of the call.
      integer(c_int), intent(out) :: status
      type(case_state_t), pointer :: state
      type(error_t), allocatable :: error
      character(:), allocatable :: word

      call take_case(self, state, error)
      if (.not. allocated(error)) then
         call read_text(name, 'name', word, error)
         !$omp critical (adfric_api)
         if (.not. allocated(error)) call state%give(word, value, error)
         !$omp end critical (adfric_api)
         call leave_object(self)
      end if
      status = status_of(error)
   end subroutine give_value

   !> See adfric.h.
   integer(c_int) function set_array(self, name, rank, shape, values) bind(c, name='adfric_set_array') result(status)
      integer(c_int64_t), intent(in), value :: self
      type(c_ptr), intent(in), value :: name
      integer(c_int32_t), intent(in), value :: rank
      type(c_ptr), intent(in), value :: shape, values
      type(case_state_t), pointer :: state
      type(error_t), allocatable :: error
      character(:), allocatable :: word
      real(c_double), pointer :: array(:, :)

      call take_case(self, state, error)
      if (.not. allocated(error)) then
         call read_text(name, 'name', word, error)
         if (.not. allocated(error)) call find_array(rank, shape, values, array, error)
         !$omp critical (adfric_api)
         if (.not. allocated(error)) call state%give_dataset(word, array, int(rank), error)
         !$omp end critical (adfric_api)
         call leave_object(self)
      end if
      status = status_of(error)
   end function set_array

   !> An array of one or two dimensions as Fortran sees it.
   subroutine find_array(rank, given_shape, values, array, error)
      !> Number of dimensions.
      integer(c_int32_t), intent(in) :: rank
      !> Number of values along each.
      type(c_ptr), intent(in) :: given_shape
      !> The values, the last dimension varies fastest.
      type(c_ptr), intent(in) :: values
      !> Receives the values; shape `(nx, ny)`.
      real(c_double), pointer, intent(out) :: array(:, :)
      !> Allocated if there are no such arrays.
      type(error_t), allocatable, intent(out) :: error
      integer(c_int64_t), pointer :: counts(:)
      integer(c_int64_t) :: n(2)

      nullify (array)
      if (rank < 1 .or. rank > 2) then
         !$omp critical (adfric_api)
         call set_error(error, input_failure, 'rank: out of range, given '//show_count(int(rank))//', allowed: 1 or 2')
         !$omp end critical (adfric_api)
         return
      end if
      call refuse_null(given_shape, 'shape', error)
      if (.not. allocated(error)) call refuse_null(values, 'values', error)
      if (allocated(error)) return
      call c_f_pointer(given_shape, counts, [rank])
      n = 1
      n(:rank) = counts(rank:1:-1)
      call check_count('shape', n(1), error)
      if (.not. allocated(error)) call check_count('shape', n(2), error)
      if (.not. allocated(error)) call check_count('shape', n(1)*n(2), error)
      if (.not. allocated(error)) call c_f_pointer(values, array, n)
   end subroutine find_array

   !> Refuse a number of values that no array has.
   subroutine check_count(what, n, error, most)
      !> What the header calls the number.
      character(*), intent(in) :: what
      !> The number.
      integer(c_int64_t), intent(in) :: n
      !> Allocated if it is no number of values.
      type(error_t), allocatable, intent(out) :: error
      !> Largest number that is allowed; that of an array if absent.
      integer(c_int64_t), intent(in), optional :: most
      integer(c_int64_t) :: limit

      limit = huge(1)
      if (present(most)) limit = most
      if (n >= 1 .and. n <= limit) return
      !$omp critical (adfric_api)
      call set_error(error, input_failure, what//': out of range, given '//show_count(n)//', allowed: 1 to '//show_count(limit))
      !$omp end critical (adfric_api)
   end subroutine check_count

   !> See adfric.h.
   integer(c_int) function unset_variable(self, name) bind(c, name='adfric_unset') result(status)
      integer(c_int64_t), intent(in), value :: self
      type(c_ptr), intent(in), value :: name
      type(case_state_t), pointer :: state
      type(error_t), allocatable :: error
      character(:), allocatable :: word

      call take_case(self, state, error)
      if (.not. allocated(error)) then
         call read_text(name, 'name', word, error)
         !$omp critical (adfric_api)
         if (.not. allocated(error)) call state%take_back(word, error)
         !$omp end critical (adfric_api)
         call leave_object(self)
      end if
      status = status_of(error)
   end function unset_variable

   !> See adfric.h.
   integer(c_int) function sweep(self, name, n, values) bind(c, name='adfric_sweep') result(status)
      integer(c_int64_t), intent(in), value :: self
      type(c_ptr), intent(in), value :: name
      integer(c_int64_t), intent(in), value :: n
      type(c_ptr), intent(in), value :: values

      call sweep_several(self, [name], n, values, status)
   end function sweep

   !> See adfric.h.
   integer(c_int) function sweep_together(self, n_names, names, n, values) bind(c, name='adfric_sweep_together') result(status)
      integer(c_int64_t), intent(in), value :: self
      integer(c_int32_t), intent(in), value :: n_names
      type(c_ptr), intent(in), value :: names
      integer(c_int64_t), intent(in), value :: n
      type(c_ptr), intent(in), value :: values
      type(error_t), allocatable :: error
      type(c_ptr), pointer :: list(:)

      call refuse_null(names, 'names', error)
      if (.not. allocated(error)) call check_count('n_names', int(n_names, c_int64_t), error, most_names)
      if (allocated(error)) then
         status = status_of(error)
      else
         call c_f_pointer(names, list, [n_names])
         call sweep_several(self, list, n, values, status)
      end if
   end function sweep_together

   !> Sweep variables.
   subroutine sweep_several(self, names, n, values, status)
      integer(c_int64_t), intent(in) :: self
      !> Names of the variables.
      type(c_ptr), intent(in) :: names(:)
      !> Number of values of each.
      integer(c_int64_t), intent(in) :: n
      !> The values, those of a variable side by side.
      type(c_ptr), intent(in) :: values
      integer(c_int), intent(out) :: status
      type(case_state_t), pointer :: state
      type(error_t), allocatable :: error
      character(longest_name) :: words(size(names))
      real(c_double), pointer :: array(:, :)

      call take_case(self, state, error)
      if (.not. allocated(error)) then
         call read_names(names, words, error)
         if (.not. allocated(error)) call check_count('n', n, error)
         if (.not. allocated(error)) call check_count('n', n*size(names), error)
         if (.not. allocated(error)) call refuse_null(values, 'values', error)
         !$omp critical (adfric_api)
         if (.not. allocated(error)) then
            call c_f_pointer(values, array, [n, size(names, kind=c_int64_t)])
            call state%sweep(words, array, error)
         end if
         !$omp end critical (adfric_api)
         call leave_object(self)
      end if
      status = status_of(error)
   end subroutine sweep_several

   !> Read several names.
   subroutine read_names(given, words, error)
      !> The names.
      type(c_ptr), intent(in) :: given(:)
      !> Receives them; no variable has a name that is longer.
      character(longest_name), intent(out) :: words(:)
      !> Allocated if there is a name too little.
      type(error_t), allocatable, intent(out) :: error
      character(:), allocatable :: word
      integer :: i

      words = ''
      do i = 1, size(given)
         call read_text(given(i), 'name', word, error)
         if (allocated(error)) return
         words(i) = word
      end do
   end subroutine read_names

end module adfric_c_values

! SPDX-License-Identifier: GPL-3.0-or-later
!> Read a results file as any other program would. A failed call ends in a value that no test expects.
module read_back
   use, intrinsic :: iso_c_binding, only: c_char, c_f_pointer, c_int, c_int64_t, c_loc, c_long, c_null_char, c_ptr
   use, intrinsic :: iso_fortran_env, only: int8
   use hdf5
   use h5ds, only: h5dsis_attached_f, h5dsis_scale_f
   use adfric_base_kinds, only: dp, i8
   implicit none (type, external)
   private
   public :: results_reader_t, open_results, n_open_ids, set_file_size_limit, file_exists, delete_file, run_shell

   !> An open file.
   type :: results_reader_t
      integer(hid_t) :: file = -1
   contains
      procedure :: close => close_results
      procedure :: has
      procedure :: shape_of
      procedure :: reals
      procedure :: states
      procedure :: text_attribute
      procedure :: real_attribute
      procedure :: flags
      procedure :: has_attribute
      procedure :: is_scale_of
      procedure :: is_contiguous
   end type results_reader_t

   !> `struct rlimit`
   type, bind(c) :: limit_t
      integer(c_long) :: soft, hard
   end type limit_t

   interface
      !> `H5Fget_obj_count`; its Fortran binding is wrong after a second h5open_f.
      integer(c_long) function count_objects(file, kinds) bind(c, name='H5Fget_obj_count')
         import :: c_int, c_int64_t, c_long
         implicit none (type, external)
         integer(c_int64_t), intent(in), value :: file
         integer(c_int), intent(in), value :: kinds
      end function count_objects

      integer(c_int) function setrlimit(resource, limit) bind(c)
         import :: c_int, limit_t
         implicit none (type, external)
         integer(c_int), intent(in), value :: resource
         type(limit_t), intent(in) :: limit
      end function setrlimit

      integer(c_int) function getrlimit(resource, limit) bind(c)
         import :: c_int, limit_t
         implicit none (type, external)
         integer(c_int), intent(in), value :: resource
         type(limit_t), intent(out) :: limit
      end function getrlimit
   end interface

contains

   subroutine open_results(self, path)
      type(results_reader_t), intent(out) :: self
      character(*), intent(in) :: path
      integer :: status

      call h5open_f(status)
      call h5fopen_f(path, H5F_ACC_RDONLY_F, self%file, status)
   end subroutine open_results

   subroutine close_results(self)
      class(results_reader_t), intent(inout) :: self
      integer :: status

      call h5fclose_f(self%file, status)
   end subroutine close_results

   !> Number of files, datasets, groups and attributes that are open in this process.
   integer function n_open_ids()
      integer(hid_t), parameter :: all_files = 31
      integer(c_int), parameter :: all_but_types = 1 + 2 + 4 + 16

      n_open_ids = int(count_objects(all_files, all_but_types))
   end function n_open_ids

   !> Is there a dataset of this name?
   logical function has(self, name)
      class(results_reader_t), intent(in) :: self
      character(*), intent(in) :: name
      integer :: status

      call h5lexists_f(self%file, name, has, status)
   end function has

   !> Shape, the slowest dimension first.
   function shape_of(self, name) result(counts)
      class(results_reader_t), intent(in) :: self
      character(*), intent(in) :: name
      integer, allocatable :: counts(:)
      integer(hsize_t) :: dims(8), max_dims(8)
      integer(hid_t) :: dataset, space
      integer :: status, rank

      call h5dopen_f(self%file, name, dataset, status)
      call h5dget_space_f(dataset, space, status)
      call h5sget_simple_extent_ndims_f(space, rank, status)
      if (rank > 0) call h5sget_simple_extent_dims_f(space, dims(:rank), max_dims(:rank), status)
      counts = int(dims(rank:1:-1))
      call h5sclose_f(space, status)
      call h5dclose_f(dataset, status)
   end function shape_of

   !> Real numbers, the last dimension fastest.
   function reals(self, name) result(values)
      class(results_reader_t), intent(in) :: self
      character(*), intent(in) :: name
      real(dp), allocatable, target :: values(:)
      integer(hid_t) :: dataset
      type(c_ptr) :: address
      integer :: status

      allocate (values(product(self%shape_of(name))), source=-99.0_dp)
      call h5dopen_f(self%file, name, dataset, status)
      address = c_loc(values)
      call h5dread_f(dataset, H5T_NATIVE_DOUBLE, address, status)
      call h5dclose_f(dataset, status)
   end function reals

   !> States, which must stand as integers of one byte; else all -99.
   function states(self, name) result(values)
      class(results_reader_t), intent(in) :: self
      character(*), intent(in) :: name
      integer, allocatable :: values(:)
      integer(int8), allocatable, target :: buffer(:)
      integer(hid_t) :: dataset, type_id
      integer(size_t) :: length
      type(c_ptr) :: address
      integer :: status

      allocate (buffer(product(self%shape_of(name))), source=-99_int8)
      call h5dopen_f(self%file, name, dataset, status)
      call h5dget_type_f(dataset, type_id, status)
      call h5tget_size_f(type_id, length, status)
      address = c_loc(buffer)
      if (length == 1) call h5dread_f(dataset, h5kind_to_type(int8, H5_INTEGER_KIND), address, status)
      call h5tclose_f(type_id, status)
      call h5dclose_f(dataset, status)
      values = int(buffer)
   end function states

   !> A text of variable length in UTF-8 at a dataset, or at the file if `name` is '/'.
   function text_attribute(self, name, attribute_name) result(text)
      class(results_reader_t), intent(in) :: self
      character(*), intent(in) :: name, attribute_name
      character(:), allocatable :: text
      type(c_ptr), target :: pointer_to_text(1)
      character(kind=c_char), pointer :: letters(:)
      integer(hid_t) :: attribute, type_id, space
      type(c_ptr) :: address
      integer :: status, set, i
      logical :: is_variable

      text = '(none)'
      call h5aopen_by_name_f(self%file, name, attribute_name, attribute, status)
      if (status < 0) return
      call h5aget_type_f(attribute, type_id, status)
      call h5aget_space_f(attribute, space, status)
      call h5tget_cset_f(type_id, set, status)
      call h5tis_variable_str_f(type_id, is_variable, status)
      if (is_variable .and. set == H5T_CSET_UTF8_F) then
         address = c_loc(pointer_to_text)
         call h5aread_f(attribute, type_id, address, status)
         call c_f_pointer(pointer_to_text(1), letters, [100000])
         text = ''
         do i = 1, size(letters)
            if (letters(i) == c_null_char) exit
            text = text//letters(i)
         end do
         call h5dvlen_reclaim_f(type_id, space, H5P_DEFAULT_F, address, status)
      end if
      call h5sclose_f(space, status)
      call h5tclose_f(type_id, status)
      call h5aclose_f(attribute, status)
   end function text_attribute

   !> A number at a dataset, or at the file if `name` is '/'.
   real(dp) function real_attribute(self, name, attribute_name)
      class(results_reader_t), intent(in) :: self
      character(*), intent(in) :: name, attribute_name
      real(dp), target :: buffer
      integer(hid_t) :: attribute
      type(c_ptr) :: address
      integer :: status

      buffer = -99
      call h5aopen_by_name_f(self%file, name, attribute_name, attribute, status)
      if (status >= 0) then
         address = c_loc(buffer)
         call h5aread_f(attribute, H5T_NATIVE_DOUBLE, address, status)
         call h5aclose_f(attribute, status)
      end if
      real_attribute = buffer
   end function real_attribute

   !> The flag values of a dataset.
   function flags(self, name) result(values)
      class(results_reader_t), intent(in) :: self
      character(*), intent(in) :: name
      integer, allocatable :: values(:)
      integer(int8), target :: buffer(100)
      integer(hid_t) :: attribute, space
      integer(hsize_t) :: n
      type(c_ptr) :: address
      integer :: status

      n = 0
      call h5aopen_by_name_f(self%file, name, 'flag_values', attribute, status)
      if (status >= 0) then
         call h5aget_space_f(attribute, space, status)
         call h5sget_simple_extent_npoints_f(space, n, status)
         address = c_loc(buffer)
         call h5aread_f(attribute, h5kind_to_type(int8, H5_INTEGER_KIND), address, status)
         call h5sclose_f(space, status)
         call h5aclose_f(attribute, status)
      end if
      values = int(buffer(:n))
   end function flags

   !> Is there an attribute of this name?
   logical function has_attribute(self, name, attribute_name)
      class(results_reader_t), intent(in) :: self
      character(*), intent(in) :: name, attribute_name
      integer :: status

      call h5aexists_by_name_f(self%file, name, attribute_name, has_attribute, status)
   end function has_attribute

   !> Is a dataset the scale of a dimension of another one?
   logical function is_scale_of(self, scale_name, name, dimension)
      class(results_reader_t), intent(in) :: self
      character(*), intent(in) :: scale_name, name
      !> From 1, the slowest first.
      integer, intent(in) :: dimension
      integer(hid_t) :: scale, dataset
      integer :: status
      logical :: is_scale

      call h5dopen_f(self%file, scale_name, scale, status)
      call h5dopen_f(self%file, name, dataset, status)
      call h5dsis_scale_f(scale, is_scale, status)
      call h5dsis_attached_f(dataset, scale, dimension, is_scale_of, status)
      is_scale_of = is_scale_of .and. is_scale
      call h5dclose_f(dataset, status)
      call h5dclose_f(scale, status)
   end function is_scale_of

   !> Does a dataset stand in one piece, with its whole position on the disk?
   logical function is_contiguous(self, name)
      class(results_reader_t), intent(in) :: self
      character(*), intent(in) :: name
      integer(hid_t) :: dataset, list
      integer :: status, layout

      call h5dopen_f(self%file, name, dataset, status)
      call h5dget_create_plist_f(dataset, list, status)
      call h5pget_layout_f(list, layout, status)
      is_contiguous = layout == H5D_CONTIGUOUS_F
      call h5pclose_f(list, status)
      call h5dclose_f(dataset, status)
   end function is_contiguous

   !> Let no write of this process go beyond a position of a file; negative: any may.
   subroutine set_file_size_limit(n_bytes)
      integer, intent(in) :: n_bytes
      integer(c_int), parameter :: file_size = 1
      type(limit_t) :: limit
      integer(c_int) :: status

      status = getrlimit(file_size, limit)
      limit%soft = n_bytes
      if (n_bytes < 0) limit%soft = limit%hard
      status = setrlimit(file_size, limit)
   end subroutine set_file_size_limit

   logical function file_exists(path)
      character(*), intent(in) :: path

      inquire (file=path, exist=file_exists)
   end function file_exists

   subroutine delete_file(path)
      character(*), intent(in) :: path

      call run_shell('rm -rf '//path)
   end subroutine delete_file

   subroutine run_shell(command)
      character(*), intent(in) :: command

      call execute_command_line(command)
   end subroutine run_shell

end module read_back

! SPDX-License-Identifier: GPL-3.0-or-later
!> Stacks of rows of numbers in HDF5 files that others have written: a dataset of any number of dimensions, whose last one runs along
!> a row. Rows are read some at a time, so that a stack may be larger than the memory.
module adfric_hdf5_stacks
   use, intrinsic :: iso_c_binding, only: c_loc, c_ptr
   use hdf5, only: hid_t, h5dget_space_f, h5dopen_f, h5dread_f, H5T_NATIVE_DOUBLE
   use adfric_base_boxes, only: box_t, next_box
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp, i8
   use adfric_hdf5_calls, only: hdf5_calls_t, no_id
   use adfric_hdf5_datasets, only: close_dataset, create_space, select_box
   use adfric_hdf5_file, only: close_file
   use adfric_hdf5_labels, only: read_label
   use adfric_hdf5_samples, only: get_extent, most_dimensions, open_foreign_file, units_name
   use adfric_hdf5_sources, only: check_sources
   implicit none (type, external)
   private
   public :: row_stack_t, open_row_stack

   !> An open dataset.
   type :: row_stack_t
      !> Number of values along each dimension, the slowest first; the last one is the length of a row.
      integer(i8), allocatable :: counts(:)
      !> Units of the values as the file says them; empty if the file says none.
      character(:), allocatable :: units
      !> Ids of the file, the dataset and its space.
      integer(hid_t), private :: file = no_id, dataset = no_id, space = no_id
   contains
      procedure :: n_rows
      procedure :: row_length
      procedure :: read_rows
      procedure :: close => close_row_stack
   end type row_stack_t

contains

   !> Open a dataset.
   subroutine open_row_stack(self, file, path, flaw)
      !> Receives the open dataset; closed if something is wrong.
      type(row_stack_t), intent(out) :: self
      !> Name of the file.
      character(*), intent(in) :: file
      !> Name of the dataset within the file, with its groups.
      character(*), intent(in) :: path
      !> What is wrong, for the user; empty if nothing is.
      character(:), allocatable, intent(out) :: flaw
      type(hdf5_calls_t) :: calls
      type(error_t), allocatable :: error
      logical :: is_text

      flaw = ''
      self%units = ''
      call calls%open_library()
      call open_foreign_file(calls, file, self%file, flaw)
      if (len(flaw) == 0 .and. calls%is_good()) then
         call h5dopen_f(self%file, path, self%dataset, calls%status)
         if (calls%status < 0) then
            self%dataset = no_id
            flaw = 'there is no dataset '//path//' in the file'
         end if
      end if
      if (len(flaw) == 0) call get_extent(calls, self%dataset, most_dimensions, self%counts, flaw)
      if (len(flaw) == 0) then
         call read_label(calls, self%dataset, units_name, self%units, is_text)
         if (.not. is_text) flaw = 'the attribute '//units_name//' of the dataset '//path//' is no text'
      end if
      if (len(flaw) == 0) call check_sources(calls, file, self%dataset, 0, flaw)
      if (len(flaw) == 0 .and. calls%is_good()) then
         call h5dget_space_f(self%dataset, self%space, calls%status)
         call calls%check()
      end if
      if (len(flaw) == 0) then
         call calls%get_error('cannot be read', error)
         if (allocated(error)) flaw = error%message
      end if
      if (len(flaw) > 0) call self%close()
   end subroutine open_row_stack

   !> Number of rows.
   pure integer(i8) function n_rows(self)
      class(row_stack_t), intent(in) :: self

      n_rows = product(self%counts(:size(self%counts) - 1))
   end function n_rows

   !> Number of values of a row.
   pure integer(i8) function row_length(self)
      class(row_stack_t), intent(in) :: self

      row_length = self%counts(size(self%counts))
   end function row_length

   !> Read neighbouring rows.
   subroutine read_rows(self, first, values, is_read)
      class(row_stack_t), intent(in) :: self
      !> Number of the first row, from 1.
      integer(i8), intent(in) :: first
      !> Receives the values in the units of the file; shape `(row_length, n_rows)`.
      real(dp), contiguous, target, intent(inout) :: values(:, :)
      !> False: they could not be read.
      logical, intent(out) :: is_read
      type(hdf5_calls_t) :: calls
      type(box_t) :: box
      type(c_ptr) :: address
      integer(hid_t) :: memory_space
      integer(i8) :: done, n

      done = 0
      do while (done < size(values, 2) .and. calls%is_good())
         call next_box(self%counts(:size(self%counts) - 1), first - 1 + done, size(values, 2) - done, box)
         n = product(box%count)
         call create_space(calls, [n, self%row_length()], memory_space)
         call select_box(calls, self%space, [box%start, 0_i8], [box%count, self%row_length()])
         address = c_loc(values(1, done + 1))
         if (calls%is_good()) call h5dread_f(self%dataset, H5T_NATIVE_DOUBLE, address, calls%status, memory_space, self%space)
         call calls%check()
         call calls%close_id(memory_space)
         done = done + n
      end do
      is_read = calls%is_good()
   end subroutine read_rows

   !> Close the dataset and its file.
   subroutine close_row_stack(self)
      class(row_stack_t), intent(inout) :: self
      type(hdf5_calls_t) :: calls

      call calls%close_id(self%space)
      call close_dataset(calls, self%dataset)
      call close_file(calls, self%file)
   end subroutine close_row_stack

end module adfric_hdf5_stacks

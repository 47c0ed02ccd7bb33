! SPDX-License-Identifier: GPL-3.0-or-later
!> Short texts beside the datasets of files that others have written: attributes of any of the kinds that texts come in.
module adfric_hdf5_labels
   use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_f_pointer, c_loc, c_null_char, c_null_ptr, c_ptr, c_size_t
   use hdf5, only: hid_t, hsize_t, size_t, h5aexists_f, h5aopen_f, h5aread_f, h5aget_type_f, h5aget_space_f, h5tget_class_f, &
      h5tget_size_f, h5tis_variable_str_f, h5sget_select_npoints_f, h5dvlen_reclaim_f, H5T_STRING_F, H5P_DEFAULT_F
   use adfric_hdf5_calls, only: hdf5_calls_t, no_id
   implicit none (type, external)
   private
   public :: label_t, read_label

   !> Longest text that is read; a longer one is cut.
   integer, parameter :: longest_label = 256

   !> An attribute that others have written.
   type :: label_t
      !> Is there such an attribute?
      logical :: exists = .false.
      !> Its id, and those of its type and its space.
      integer(hid_t) :: id = no_id, type_id = no_id, space = no_id
      !> Class of its type.
      integer :: type_class = -1
      !> Number of its values.
      integer(hsize_t) :: n_values = 0
   contains
      procedure :: open
      procedure :: close
   end type label_t

   interface
      !> Length of a text that ends with a null character, looked for no further than `most`.
      integer(c_size_t) function strnlen(text, most) bind(c)
         import :: c_ptr, c_size_t
         implicit none (type, external)
         !> Address of the first letter.
         type(c_ptr), intent(in), value :: text
         !> Largest length [bytes].
         integer(c_size_t), intent(in), value :: most
      end function strnlen
   end interface

contains

   !> Read the text of an attribute.
   subroutine read_label(calls, index, name, label, is_text)
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the dataset that the attribute belongs to.
      integer(hid_t), intent(in) :: index
      character(*), intent(in) :: name
      !> Text of the attribute; empty if there is no such attribute, or nothing in it.
      character(:), allocatable, intent(out) :: label
      !> False if the attribute is no text, or has several.
      logical, intent(out) :: is_text
      type(label_t) :: attribute

      label = ''
      is_text = .true.
      call attribute%open(calls, index, name)
      if (calls%is_good() .and. attribute%n_values > 0) then
         is_text = attribute%n_values == 1 .and. attribute%type_class == H5T_STRING_F
         if (is_text) call read_text(calls, attribute%id, attribute%type_id, attribute%space, label)
      end if
      call attribute%close(calls)
   end subroutine read_label

   !> Open an attribute, if there is one of the name.
   subroutine open(self, calls, index, name)
      class(label_t), intent(out) :: self
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the dataset or group that the attribute belongs to.
      integer(hid_t), intent(in) :: index
      !> Name of the attribute.
      character(*), intent(in) :: name

      if (calls%is_good()) call h5aexists_f(index, name, self%exists, calls%status)
      call calls%check()
      if (.not. (calls%is_good() .and. self%exists)) return
      call h5aopen_f(index, name, self%id, calls%status)
      call calls%check()
      if (calls%is_good()) call h5aget_type_f(self%id, self%type_id, calls%status)
      call calls%check()
      if (calls%is_good()) call h5aget_space_f(self%id, self%space, calls%status)
      call calls%check()
      if (calls%is_good()) call h5tget_class_f(self%type_id, self%type_class, calls%status)
      call calls%check()
      if (calls%is_good()) call h5sget_select_npoints_f(self%space, self%n_values, calls%status)
      call calls%check()
   end subroutine open

   !> Close an attribute; nothing is done with one that is not open.
   subroutine close(self, calls)
      class(label_t), intent(inout) :: self
      !> Chain of HDF5 calls.
      type(hdf5_calls_t), intent(inout) :: calls

      call calls%close_id(self%space)
      call calls%close_id(self%type_id)
      call calls%close_id(self%id)
   end subroutine close

   !> Read a text of fixed or of variable length.
   subroutine read_text(calls, attribute, type_id, space, label)
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the open attribute, one text.
      integer(hid_t), intent(in) :: attribute
      !> HDF5 type of the attribute.
      integer(hid_t), intent(in) :: type_id
      !> Space of the attribute.
      integer(hid_t), intent(in) :: space
      !> Receives the text; left as it is if a call has failed.
      character(:), allocatable, intent(inout) :: label
      character(kind=c_char), allocatable, target :: letters(:)
      type(c_ptr), target :: pointer_to_text(1)
      type(c_ptr) :: address
      integer(size_t) :: length
      logical :: is_variable

      is_variable = .false.
      if (calls%is_good()) call h5tis_variable_str_f(type_id, is_variable, calls%status)
      call calls%check()
      if (.not. calls%is_good()) return
      if (is_variable) then
         pointer_to_text = c_null_ptr
         address = c_loc(pointer_to_text)
         call h5aread_f(attribute, type_id, address, calls%status)
         call calls%check()
         if (.not. calls%is_good()) return
         label = text_at(pointer_to_text(1), longest_label)
         call h5dvlen_reclaim_f(type_id, space, H5P_DEFAULT_F, address, calls%status)
      else
         call h5tget_size_f(type_id, length, calls%status)
         call calls%check()
         if (.not. calls%is_good()) return
         allocate (letters(length))
         letters = c_null_char
         address = c_loc(letters)
         call h5aread_f(attribute, type_id, address, calls%status)
         if (calls%status >= 0) label = text_at(address, int(min(length, int(longest_label, size_t))))
      end if
      call calls%check()
   end subroutine read_text

   !> The text at an address, without blanks at its end.
   function text_at(address, most) result(text)
      !> Address of the first letter; null for no text.
      type(c_ptr), intent(in) :: address
      !> Largest length; a longer text is cut.
      integer, intent(in) :: most
      character(:), allocatable :: text
      character(kind=c_char), pointer :: letters(:)
      integer :: i, n

      text = ''
      if (.not. c_associated(address)) return
      n = int(strnlen(address, int(most, c_size_t)))
      call c_f_pointer(address, letters, [n])
      text = repeat(' ', n)
      do i = 1, n
         text(i:i) = letters(i)
      end do
      text = trim(text)
   end function text_at

end module adfric_hdf5_labels

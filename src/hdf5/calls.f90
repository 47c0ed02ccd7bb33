! SPDX-License-Identifier: GPL-3.0-or-later
!> A chain of HDF5 calls that stops at the first one that fails, and knows why it failed.
!>
!> Every call leaves its status in `status`; `check` follows it. The next call is made only while
!> `is_good`; ids are closed by `close_id` whether the chain is good or not.
module adfric_hdf5_calls
   use, intrinsic :: iso_c_binding, only: c_char, c_f_pointer, c_funloc, c_funptr, c_int, c_int64_t, c_loc, &
      c_null_char, c_ptr
   use hdf5, only: hid_t, h5dont_atexit_f, h5open_f, h5eset_auto_f, h5idec_ref_f, h5iis_valid_f, &
      H5T_NATIVE_DOUBLE
   use adfric_base_error, only: error_t, set_error, file_failure
   implicit none (type, external)
   private
   public :: hdf5_calls_t, no_id

   !> An id that has not been opened.
   integer(hid_t), parameter :: no_id = -1

   !> Longest reason that is kept.
   integer, parameter :: reason_length = 512
   !> H5E_DEFAULT and H5E_WALK_UPWARD (from the cause to the call) of hdf5.h.
   integer(c_int64_t), parameter :: default_stack = 0
   integer(c_int), parameter :: walk_upward = 0

   !> A chain of calls.
   type :: hdf5_calls_t
      !> What the last call gave back; negative: failed.
      integer :: status = 0
      !> Has a call failed?
      logical, private :: has_failed = .false.
      !> Why the first of them failed.
      character(:), allocatable, private :: reason
   contains
      procedure :: open_library
      procedure :: silence
      procedure :: check
      procedure :: fail
      procedure :: is_good
      procedure :: close_id
      procedure :: get_error
   end type hdf5_calls_t

   !> A reason as it comes out of the stack of errors.
   type :: reason_t
      !> The reason, padded with blanks; empty until one is found.
      character(reason_length) :: text = ''
      !> Does the text come from the operating system?
      logical :: is_final = .false.
   end type reason_t

   !> `H5E_error2_t`.
   type, bind(c) :: stack_entry_t
      !> Identifiers of the library that failed, and of its major and minor error.
      integer(c_int64_t) :: class_id, major, minor
      !> Line of the source of HDF5.
      integer(c_int) :: line
      !> Texts that end with a null character; only `description` is read.
      type(c_ptr) :: function_name, file_name, description
   end type stack_entry_t

   interface
      !> `H5Ewalk2`, for which HDF5 has no Fortran binding.
      integer(c_int) function walk_stack(stack, direction, visit, reason) bind(c, name='H5Ewalk2')
         import :: c_int64_t, c_int, c_funptr, c_ptr
         implicit none (type, external)
         !> Which stack of errors; `default_stack` is that of this thread.
         integer(c_int64_t), intent(in), value :: stack
         !> Order in which the entries are visited; `walk_upward` is from the cause to the call.
         integer(c_int), intent(in), value :: direction
         !> C function that is called for each entry, such as `keep_reason`.
         type(c_funptr), intent(in), value :: visit
         !> Address that is handed to that function, here of a `reason_t`.
         type(c_ptr), intent(in), value :: reason
      end function walk_stack
   end interface

contains

   !> Make HDF5 ready, and silent: what goes wrong is reported by us.
   subroutine open_library(self)
      !> The chain; its other calls may follow if it is good afterwards.
      class(hdf5_calls_t), intent(inout) :: self
      logical :: is_open

      ! At the end of the program HDF5 would go through files whose writing has failed, and crash. All ids are
      ! closed by us. The status says only whether it has been asked before.
      call h5dont_atexit_f(self%status)
      ! Each h5open_f makes its own copies of all types.
      call h5iis_valid_f(H5T_NATIVE_DOUBLE, is_open, self%status)
      if (.not. is_open) call h5open_f(self%status)
      call self%check()
      call self%silence()
   end subroutine open_library

   !> Make HDF5 silent in this thread: a thread-safe build of HDF5 must be told in each thread.
   subroutine silence(self)
      class(hdf5_calls_t), intent(inout) :: self

      if (self%is_good()) call h5eset_auto_f(0, self%status)
      call self%check()
   end subroutine silence

   !> Take note of the status of the last call.
   subroutine check(self)
      !> The chain; a first failure is kept with its reason.
      class(hdf5_calls_t), intent(inout) :: self

      if (self%status >= 0 .or. self%has_failed) return
      self%has_failed = .true.
      call find_reason(self%reason)
   end subroutine check

   !> Break the chain off: no call is made any more.
   subroutine fail(self, reason)
      !> The chain, which is not good afterwards; an earlier reason is kept.
      class(hdf5_calls_t), intent(inout) :: self
      !> Why no call may follow: a phrase that ends a message.
      character(*), intent(in) :: reason

      if (self%has_failed) return
      self%has_failed = .true.
      self%reason = reason
   end subroutine fail

   !> Has every call been successful?
   pure logical function is_good(self)
      class(hdf5_calls_t), intent(in) :: self

      is_good = .not. self%has_failed
   end function is_good

   !> Close an id of any kind but a file or a dataset; `no_id` is left alone.
   subroutine close_id(self, id)
      !> The chain; an id is closed even where a call has failed.
      class(hdf5_calls_t), intent(inout) :: self
      !> The id, which is `no_id` afterwards.
      integer(hid_t), intent(inout) :: id
      integer :: references

      if (id == no_id) return
      call h5idec_ref_f(id, references, self%status)
      call self%check()
      id = no_id
   end subroutine close_id

   !> Raise an error if a call has failed.
   subroutine get_error(self, what, error)
      class(hdf5_calls_t), intent(in) :: self
      !> What was tried, on what file: the beginning of the message.
      character(*), intent(in) :: what
      !> Not allocated if no call has failed.
      type(error_t), allocatable, intent(out) :: error

      if (self%has_failed) call set_error(error, file_failure, what//': '//self%reason)
   end subroutine get_error

   !> Why the last call failed.
   subroutine find_reason(text)
      !> Receives the reason, or that there is none.
      character(:), allocatable, intent(out) :: text
      type(reason_t), target :: reason
      integer(c_int) :: status

      status = walk_stack(default_stack, walk_upward, c_funloc(keep_reason), c_loc(reason))
      if (status < 0 .or. len_trim(reason%text) == 0) reason%text = 'HDF5 gives no reason'
      text = trim(reason%text)
   end subroutine find_reason

   !> Keep what the operating system said or, without it, what HDF5 said first.
   integer(c_int) function keep_reason(number, entry, data) bind(c)
      !> Number of the entry, 0 for the cause.
      integer(c_int), intent(in), value :: number
      type(stack_entry_t), intent(in) :: entry
      !> Address of the `reason_t` that receives the text.
      type(c_ptr), intent(in), value :: data
      character(*), parameter :: mark = 'error message = '''
      type(reason_t), pointer :: reason
      character(reason_length) :: text
      integer :: first

      keep_reason = 0
      call c_f_pointer(data, reason)
      if (reason%is_final) return
      text = text_at(entry%description)
      first = index(text, mark)
      if (first > 0) then
         text = text(first + len(mark):)
         text = text(:index(text, '''') - 1)
         reason%is_final = .true.
      end if
      if (reason%is_final .or. number == 0) reason%text = text
   end function keep_reason

   !> The text of C at an address.
   function text_at(address) result(text)
      !> Address of a text that ends with a null character.
      type(c_ptr), intent(in) :: address
      character(reason_length) :: text
      character(kind=c_char), pointer :: letters(:)
      integer :: i

      text = ''
      call c_f_pointer(address, letters, [reason_length])
      do i = 1, reason_length
         if (letters(i) == c_null_char) exit
         text(i:i) = letters(i)
      end do
   end function text_at

end module adfric_hdf5_calls

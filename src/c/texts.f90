! SPDX-License-Identifier: GPL-3.0-or-later
!> Texts between C and Fortran, and how a call says what has become of it.
module adfric_c_texts
   use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_f_pointer, c_int, c_null_ptr, c_ptr, c_size_t
   use adfric_base_error, only: error_t, file_failure, input_failure, set_error
   use adfric_base_text, only: longest_name, show_count
   implicit none (type, external)
   private
   public :: read_text, read_words, keep_text, status_of, refuse_null, too_little_memory

   !> What is said where memory is short.
   character(*), parameter :: too_little_memory = 'there is too little memory'

   interface

      !> Length of a text without the 0 at its end.
      integer(c_size_t) function c_length(text) bind(c, name='strlen')
         import :: c_ptr, c_size_t
         implicit none (type, external)
         !> The text, not null.
         type(c_ptr), intent(in), value :: text
      end function c_length

      !> The same text, which stays until the program ends; null if there is no memory for it.
      type(c_ptr) function c_keep(text, length) bind(c, name='adfric_keep_text')
         import :: c_char, c_ptr, c_size_t
         implicit none (type, external)
         !> The text.
         character(kind=c_char), intent(in) :: text(*)
         !> Its length.
         integer(c_size_t), intent(in), value :: length
      end function c_keep

      !> Keep a message for this thread.
      subroutine c_keep_message(text, length) bind(c, name='adfric_keep_message')
         import :: c_char, c_size_t
         implicit none (type, external)
         !> The text.
         character(kind=c_char), intent(in) :: text(*)
         !> Its length.
         integer(c_size_t), intent(in), value :: length
      end subroutine c_keep_message

   end interface

contains

   !> Read a text of C.
   subroutine read_text(given, what, text, error)
      !> The text, which ends by a 0; null is an error.
      type(c_ptr), intent(in) :: given
      !> What the header calls it.
      character(*), intent(in) :: what
      !> Receives the text.
      character(:), allocatable, intent(out) :: text
      !> Allocated if there is no text, or no memory for it.
      type(error_t), allocatable, intent(out) :: error
      character(kind=c_char), pointer :: letters(:)
      integer(c_size_t) :: length, i
      integer :: failure

      call refuse_null(given, what, error)
      if (allocated(error)) return
      length = c_length(given)
      failure = 1
      if (length < huge(1)) allocate (character(length) :: text, stat=failure)
      if (failure /= 0) then
         call set_error(error, file_failure, what//': '//too_little_memory)
         return
      end if
      call c_f_pointer(given, letters, [length])
      do i = 1, length
         text(i:i) = letters(i)
      end do
   end subroutine read_text

   !> Read several texts; not within `critical (adfric_api)`, where the message of a text that is too long is made.
   subroutine read_words(given, what, n, words, error)
      !> The texts.
      type(c_ptr), intent(in) :: given
      !> What they are, for messages.
      character(*), intent(in) :: what
      !> Number of texts.
      integer, intent(in) :: n
      !> Receives them.
      character(longest_name), allocatable, intent(out) :: words(:)
      !> Allocated if one is missing, or too long.
      type(error_t), allocatable, intent(out) :: error
      type(c_ptr), pointer :: list(:)
      character(:), allocatable :: word
      integer :: i

      call refuse_null(given, what, error)
      if (allocated(error)) return
      call c_f_pointer(given, list, [n])
      allocate (words(n))
      do i = 1, n
         call read_text(list(i), what, word, error)
         if (allocated(error)) return
         if (len(word) > longest_name) then
            !$omp critical (adfric_api)
            call set_error(error, input_failure, what//': number '//show_count(i)//' is too long, allowed: at most '// &
               & show_count(longest_name)//' letters')
            !$omp end critical (adfric_api)
            return
         end if
         words(i) = word
      end do
   end subroutine read_words

   !> Refuse a pointer that is null.
   subroutine refuse_null(given, what, error)
      !> The pointer.
      type(c_ptr), intent(in) :: given
      !> What the header calls it.
      character(*), intent(in) :: what
      !> Allocated if it is null.
      type(error_t), allocatable, intent(out) :: error

      if (.not. c_associated(given)) call set_error(error, input_failure, what//': given NULL, allowed: a pointer')
   end subroutine refuse_null

   !> Give a text to C for good.
   subroutine keep_text(text, kept, error)
      !> The text.
      character(*), intent(in) :: text
      !> Receives the index of a copy that stays until the program ends.
      type(c_ptr), intent(out) :: kept
      !> In: what was wrong before, if anything was. Out: also that there is no memory for the text.
      type(error_t), allocatable, intent(inout) :: error

      kept = c_keep(text, int(len(text), c_size_t))
      if (.not. c_associated(kept) .and. .not. allocated(error)) call set_error(error, file_failure, too_little_memory)
   end subroutine keep_text

   !> What a call gives back, and the message that it leaves.
   integer(c_int) function status_of(error)
      !> What is wrong, if anything is.
      type(error_t), allocatable, intent(in) :: error

      if (allocated(error)) then
         call c_keep_message(error%message, len(error%message, c_size_t))
         status_of = int(error%code, c_int)
      else
         call c_keep_message('', 0_c_size_t)
         status_of = 0
      end if
   end function status_of

end module adfric_c_texts

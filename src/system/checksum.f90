! SPDX-License-Identifier: GPL-3.0-or-later
!> A short number that tells things apart, whatever they consist of: FNV-1a with 64 bits (G. Fowler, L. C. Noll, K.-P. Vo,
!> D. Eastlake, The FNV non-cryptographic hash algorithm).
module adfric_system_checksum
   use, intrinsic :: iso_c_binding, only: c_int64_t, c_loc, c_null_char, c_ptr, c_size_t
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: checksum_t, checksum_length, mix_reals, mix_integers

   !> Letters of a checksum as text.
   integer, parameter :: checksum_length = 16

   !> The checksum of what has been added so far; what is added in another order gives another one.
   type :: checksum_t
      private
      !> Of nothing: 14695981039346656037 - 2**64.
      integer(c_int64_t) :: sum = -3750763034362895579_c_int64_t
   contains
      procedure :: add_text
      procedure :: add_reals
      procedure :: to_text
   end type checksum_t

   interface
      !> FNV-1a of what came before and of bytes, in C.
      integer(c_int64_t) function c_add(before, bytes, n) bind(c, name='adfric_add_to_checksum')
         import :: c_int64_t, c_ptr, c_size_t
         implicit none (type, external)
         !> Checksum of what came before.
         integer(c_int64_t), intent(in), value :: before
         !> Address of the first byte that is added.
         type(c_ptr), intent(in), value :: bytes
         !> How many bytes are added.
         integer(c_size_t), intent(in), value :: n
      end function c_add

      !> The fast sum of what came before and of bytes, in C.
      integer(c_int64_t) function c_mix(before, bytes, n) bind(c, name='adfric_mix')
         import :: c_int64_t, c_ptr, c_size_t
         implicit none (type, external)
         !> Sum of what came before.
         integer(c_int64_t), intent(in), value :: before
         !> Address of the first byte that is added.
         type(c_ptr), intent(in), value :: bytes
         !> How many bytes are added.
         integer(c_size_t), intent(in), value :: n
      end function c_mix
   end interface

contains

   !> Add a text. Its end counts: 'ab' and 'c' are not 'a' and 'bc'.
   subroutine add_text(self, text)
      !> The checksum so far; the text is added to it.
      class(checksum_t), intent(inout) :: self
      !> The text; blanks at its end count, too.
      character(*), intent(in) :: text
      character(:), allocatable, target :: buffer

      buffer = text//c_null_char
      self%sum = c_add(self%sum, c_loc(buffer), int(len(buffer), c_size_t))
   end subroutine add_text

   !> Add numbers, each as its eight bytes, the lowest first.
   subroutine add_reals(self, numbers)
      !> The checksum so far; the numbers are added to it.
      class(checksum_t), intent(inout) :: self
      !> The numbers in their order; may be none.
      real(dp), intent(in), contiguous, target :: numbers(:)
      integer, parameter :: bytes = 8

      if (size(numbers) > 0) self%sum = c_add(self%sum, c_loc(numbers), bytes*size(numbers, kind=c_size_t))
   end subroutine add_reals

   !> A fast sum of numbers and of what came before them: a change of one of them always changes it.
   integer(c_int64_t) function mix_reals(before, n, numbers) result(sum)
      !> Sum of what came before.
      integer(c_int64_t), intent(in) :: before
      !> How many numbers are added.
      integer, intent(in) :: n
      !> The numbers; shape `(n)`.
      real(dp), intent(in), target :: numbers(*)
      integer(c_size_t), parameter :: bytes = 8

      sum = before
      if (n > 0) sum = c_mix(before, c_loc(numbers), bytes*n)
   end function mix_reals

   !> The same of integers.
   integer(c_int64_t) function mix_integers(before, n, numbers) result(sum)
      !> Sum of what came before.
      integer(c_int64_t), intent(in) :: before
      !> How many numbers are added.
      integer, intent(in) :: n
      !> The numbers; shape `(n)`.
      integer(c_int64_t), intent(in), target :: numbers(*)
      integer(c_size_t), parameter :: bytes = 8

      sum = before
      if (n > 0) sum = c_mix(before, c_loc(numbers), bytes*n)
   end function mix_integers

   !> Hexadecimal digits.
   pure function to_text(self) result(text)
      class(checksum_t), intent(in) :: self
      character(checksum_length) :: text
      integer, parameter :: to_small = iachar('a') - iachar('A')
      integer :: i

      write (text, '(z16.16)') self%sum
      do i = 1, len(text)
         if (text(i:i) >= 'A') text(i:i) = achar(iachar(text(i:i)) + to_small)
      end do
   end function to_text

end module adfric_system_checksum

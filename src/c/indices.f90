! SPDX-License-Identifier: GPL-3.0-or-later
!> Indices in lists, which C counts from 0.
module adfric_c_indices
   use, intrinsic :: iso_c_binding, only: c_int32_t
   use adfric_base_error, only: error_t, input_failure, set_error
   implicit none (type, external)
   private
   public :: check_index

contains

   !> Refuse a index that there is not.
   subroutine check_index(word, index, n, error)
      !> What stands at the indices.
      character(*), intent(in) :: word
      !> The index, from 0.
      integer(c_int32_t), intent(in) :: index
      !> Number of indices.
      integer, intent(in) :: n
      !> Allocated if there is no such index.
      type(error_t), allocatable, intent(out) :: error
      character(20) :: given, last

      if (index >= 0 .and. index < n) return
      write (given, '(i0)') index
      write (last, '(i0)') n - 1
      if (n == 0) then
         call set_error(error, input_failure, 'there is no '//word//' '//trim(given)//', there are none')
      else
         call set_error(error, input_failure, 'there is no '//word//' '//trim(given)//', allowed: 0 to '//trim(last))
      end if
   end subroutine check_index

end module adfric_c_indices

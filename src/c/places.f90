! SPDX-License-Identifier: GPL-3.0-or-later
!> Places in lists, which C counts from 0.
module adfric_c_places
   use, intrinsic :: iso_c_binding, only: c_int32_t
   use adfric_base_error, only: error_t, input_failure, set_error
   implicit none (type, external)
   private
   public :: check_place

contains

   !> Refuse a place that there is not.
   subroutine check_place(word, place, n, error)
      !> What stands at the places.
      character(*), intent(in) :: word
      !> The place, from 0.
      integer(c_int32_t), intent(in) :: place
      !> Number of places.
      integer, intent(in) :: n
      !> Allocated if there is no such place.
      type(error_t), allocatable, intent(out) :: error
      character(20) :: given, last

      if (place >= 0 .and. place < n) return
      write (given, '(i0)') place
      write (last, '(i0)') n - 1
      if (n == 0) then
         call set_error(error, input_failure, 'there is no '//word//' '//trim(given)//', there are none')
      else
         call set_error(error, input_failure, 'there is no '//word//' '//trim(given)//', allowed: 0 to '//trim(last))
      end if
   end subroutine check_place

end module adfric_c_places

! SPDX-License-Identifier: GPL-3.0-or-later
!> What the batches of adfric.h refuse as a whole.
module adfric_c_batches
   use, intrinsic :: iso_c_binding, only: c_double, c_int64_t
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_is_nan
   use adfric_base_error, only: error_t, input_failure, set_error
   use adfric_base_words, only: find_word
   implicit none (type, external)
   private
   public :: check_batch, check_positive, check_cells

   !> Longest text of a number.
   integer, parameter :: longest_number = 32

contains

   !> Refuse a batch whose arrays are not all there.
   subroutine check_batch(n, are_there, names, error)
      !> Number of values of each array.
      integer(c_int64_t), intent(in) :: n
      !> Is each array there?
      logical, intent(in) :: are_there(:)
      !> What the header calls them, separated by a blank.
      character(*), intent(in) :: names
      !> Allocated if an array is not there, or the number is below 0.
      type(error_t), allocatable, intent(out) :: error
      character(longest_number) :: text
      character(:), allocatable :: name

      if (n < 0) then
         write (text, '(i0)') n
         call set_error(error, input_failure, 'n: out of range, given '//trim(text)//', allowed: an integer >= 0')
      else if (.not. all(are_there) .and. n > 0) then
         call find_word(names, findloc(are_there, .false., dim=1), name)
         call set_error(error, input_failure, name//': given NULL, allowed: an array')
      end if
   end subroutine check_batch

   !> Refuse numbers that are not all > 0.
   subroutine check_positive(name, n, values, unit, error)
      !> What the header calls the array.
      character(*), intent(in) :: name
      !> Number of values.
      integer(c_int64_t), intent(in) :: n
      !> The numbers.
      real(c_double), intent(in) :: values(n)
      !> Their unit.
      character(*), intent(in) :: unit
      !> Allocated if one of them is not; says which is the first.
      type(error_t), allocatable, intent(out) :: error
      character(longest_number) :: given, index
      integer(c_int64_t) :: i

      do i = 1, n
         if (.not. is_positive(values(i))) exit
      end do
      if (i > n) return
      given = 'NaN'
      if (.not. ieee_is_nan(values(i))) write (given, '(es12.4)') values(i)
      write (index, '(i0)') i - 1
      call set_error(error, input_failure, name//': out of range, given '//trim(adjustl(given))//' at place '//trim(index)// &
         & ', allowed: a number > 0 ['//unit//']')
   end subroutine check_positive

   !> Is it a number > 0?
   elemental logical function is_positive(value)
      !> Any number, or NaN.
      real(c_double), intent(in) :: value

      is_positive = ieee_is_finite(value)
      if (is_positive) is_positive = value > 0
   end function is_positive

   !> Refuse numbers of cells that no map has.
   subroutine check_cells(name, n, error)
      !> What the header calls the number.
      character(*), intent(in) :: name
      !> The number.
      integer(c_int64_t), intent(in) :: n
      !> Allocated if it is no number of cells.
      type(error_t), allocatable, intent(out) :: error
      character(longest_number) :: given, most

      if (n >= 1 .and. n <= huge(1)) return
      write (given, '(i0)') n
      write (most, '(i0)') huge(1)
      call set_error(error, input_failure, name//': out of range, given '//trim(given)//', allowed: 1 to '//trim(most))
   end subroutine check_cells

end module adfric_c_batches

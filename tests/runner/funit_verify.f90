! SPDX-License-Identifier: GPL-3.0-or-later
!> What each relation between expected and actual values means, element by element.
!>
!> The assertions hand over arrays of any rank as flat lists with their shapes. An expected scalar
!> stands for every element. Comparing reals raises no floating-point trap, so that a NaN
!> or an overflow in a result is reported as a failure also where the program halts on such operations.
module funit_verify
   use, intrinsic :: iso_fortran_env, only: int32, int64, real32, real64
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use, intrinsic :: ieee_exceptions, only: ieee_all, ieee_get_status, ieee_set_halting_mode, &
      ieee_set_status, ieee_status_type
   use funit_exceptions, only: SourceLocation, throw
   implicit none (type, external)
   private
   public :: verify, widen

   !> Raise a failure at the first element for which the relation does not hold.
   interface verify
      module procedure :: verify_real64, verify_real32, verify_int64, verify_int32
      module procedure :: verify_logical, verify_character
   end interface verify

   !> The same value in double precision, without a trap for any kind of NaN.
   interface widen
      module procedure :: widen_real32
   end interface widen

contains

   subroutine verify_real64(relation, expected, actual, expected_shape, actual_shape, &
      tolerance, message, location)
      character(len=*), intent(in) :: relation
      real(real64), intent(in) :: expected(:), actual(:)
      integer, intent(in) :: expected_shape(:), actual_shape(:)
      real(real64), intent(in), optional :: tolerance
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      type(ieee_status_type) :: status
      real(real64) :: allowed, reference
      integer :: i

      if (.not. is_conformable(expected_shape, actual_shape, message, location)) return
      call ieee_get_status(status)
      call ieee_set_halting_mode(ieee_all, .false.)
      allowed = 0.0_real64
      if (present(tolerance)) allowed = tolerance
      elements: do i = 1, size(actual)
         reference = expected(min(i, size(expected)))
         if (.not. holds(relation, reference, actual(i), allowed)) then
            call raise(relation, real_text(reference), real_text(actual(i)), i, actual_shape, message, &
               location, real_text(allowed))
            exit elements
         end if
      end do elements
      call ieee_set_status(status)
   end subroutine verify_real64

   subroutine verify_real32(relation, expected, actual, expected_shape, actual_shape, &
      tolerance, message, location)
      character(len=*), intent(in) :: relation
      real(real32), intent(in) :: expected(:), actual(:)
      integer, intent(in) :: expected_shape(:), actual_shape(:)
      real(real32), intent(in), optional :: tolerance
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      real(real64) :: allowed

      allowed = 0.0_real64
      if (present(tolerance)) allowed = widen(tolerance)
      call verify_real64(relation, widen(expected), widen(actual), expected_shape, actual_shape, &
         allowed, message, location)
   end subroutine verify_real32

   subroutine verify_int64(relation, expected, actual, expected_shape, actual_shape, message, location)
      character(len=*), intent(in) :: relation
      integer(int64), intent(in) :: expected(:), actual(:)
      integer, intent(in) :: expected_shape(:), actual_shape(:)
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      integer(int64) :: reference
      integer :: i

      if (.not. is_conformable(expected_shape, actual_shape, message, location)) return
      elements: do i = 1, size(actual)
         reference = expected(min(i, size(expected)))
         if (.not. holds_integer(relation, reference, actual(i))) then
            call raise(relation, integer_text(reference), integer_text(actual(i)), i, actual_shape, &
               message, location)
            exit elements
         end if
      end do elements
   end subroutine verify_int64

   subroutine verify_int32(relation, expected, actual, expected_shape, actual_shape, message, location)
      character(len=*), intent(in) :: relation
      integer(int32), intent(in) :: expected(:), actual(:)
      integer, intent(in) :: expected_shape(:), actual_shape(:)
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      call verify_int64(relation, int(expected, int64), int(actual, int64), expected_shape, &
         actual_shape, message, location)
   end subroutine verify_int32

   subroutine verify_logical(relation, expected, actual, expected_shape, actual_shape, message, location)
      character(len=*), intent(in) :: relation
      logical, intent(in) :: expected(:), actual(:)
      integer, intent(in) :: expected_shape(:), actual_shape(:)
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      logical :: reference
      integer :: i

      if (.not. is_conformable(expected_shape, actual_shape, message, location)) return
      elements: do i = 1, size(actual)
         reference = expected(min(i, size(expected)))
         if (reference .neqv. actual(i)) then
            call raise(relation, merge('T', 'F', reference), merge('T', 'F', actual(i)), i, &
               actual_shape, message, location)
            exit elements
         end if
      end do elements
   end subroutine verify_logical

   !> Trailing blanks do not count, as in Fortran.
   subroutine verify_character(relation, expected, actual, expected_shape, actual_shape, message, location)
      character(len=*), intent(in) :: relation
      character(len=*), intent(in) :: expected(:), actual(:)
      integer, intent(in) :: expected_shape(:), actual_shape(:)
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      integer :: i, k

      if (.not. is_conformable(expected_shape, actual_shape, message, location)) return
      elements: do i = 1, size(actual)
         k = min(i, size(expected))
         if (expected(k) /= actual(i)) then
            call raise(relation, trim(expected(k)), trim(actual(i)), i, actual_shape, message, location)
            exit elements
         end if
      end do elements
   end subroutine verify_character

   !> Whether two reals stand in the relation; never for a NaN.
   logical function holds(relation, expected, actual, tolerance)
      character(len=*), intent(in) :: relation
      real(real64), intent(in) :: expected, actual, tolerance

      select case (relation)
      case ('Equal')
         ! The first two conditions also let equal infinities pass.
         holds = (actual >= expected .and. actual <= expected) .or. abs(actual - expected) <= tolerance
      case ('RelativelyEqual')
         holds = abs(expected) > 0.0_real64 .and. ieee_is_finite(expected)
         if (holds) holds = abs(actual - expected) <= tolerance*abs(expected)
      case ('LessThan')
         holds = expected < actual
      case ('LessThanOrEqual')
         holds = expected <= actual
      case ('GreaterThan')
         holds = expected > actual
      case ('GreaterThanOrEqual')
         holds = expected >= actual
      case default
         holds = .false.
      end select
   end function holds

   logical function holds_integer(relation, expected, actual) result(holds)
      character(len=*), intent(in) :: relation
      integer(int64), intent(in) :: expected, actual

      select case (relation)
      case ('Equal')
         holds = expected == actual
      case ('LessThan')
         holds = expected < actual
      case ('LessThanOrEqual')
         holds = expected <= actual
      case ('GreaterThan')
         holds = expected > actual
      case ('GreaterThanOrEqual')
         holds = expected >= actual
      case default
         holds = .false.
      end select
   end function holds_integer

   !> A scalar fits every shape, an array only its own; anything else is a failure.
   logical function is_conformable(expected, actual, message, location)
      integer, intent(in) :: expected(:), actual(:)
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      is_conformable = size(expected) == 0 .or. size(expected) == size(actual)
      if (is_conformable .and. size(expected) > 0) is_conformable = all(expected == actual)
      if (is_conformable) return
      call throw(headed(message, 'Arrays not conformable') &
         //new_line('a')//'    Expected shape: '//list_text(expected) &
         //new_line('a')//'      Actual shape: '//list_text(actual), location)
   end function is_conformable

   !> Describe the element that broke the relation.
   subroutine raise(relation, expected, actual, position, actual_shape, message, location, tolerance)
      character(len=*), intent(in) :: relation, expected, actual
      integer, intent(in) :: position, actual_shape(:)
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      character(len=*), intent(in), optional :: tolerance

      character(len=:), allocatable :: text
      logical :: is_order

      is_order = index(relation, 'Than') > 0
      text = headed(message, 'Assert'//relation//' failure:')//new_line('a')
      text = text//merge('          Left: <', '      Expected: <', is_order)//expected//'>'//new_line('a')
      text = text//merge('         Right: <', '        Actual: <', is_order)//actual//'>'
      if (present(tolerance) .and. .not. is_order) text = text//new_line('a')//'     Tolerance: <'//tolerance//'>'
      if (size(actual_shape) > 0) text = text//new_line('a')//'      at index: ' &
         //list_text(subscripts(position, actual_shape))
      call throw(text, location)
   end subroutine raise

   !> The user's message, if any, on a line above the text.
   pure function headed(message, text) result(whole)
      character(len=*), intent(in), optional :: message
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: whole

      whole = text
      if (present(message)) whole = trim(message)//new_line('a')//text
   end function headed

   !> Subscripts of an element of a list that was flattened in array element order.
   pure function subscripts(position, extents) result(indices)
      integer, intent(in) :: position, extents(:)
      integer :: indices(size(extents))

      integer :: i, rest

      rest = position - 1
      do i = 1, size(extents)
         indices(i) = modulo(rest, extents(i)) + 1
         rest = rest/extents(i)
      end do
   end function subscripts

   elemental function widen_real32(x) result(wide)
      real(real32), intent(in) :: x
      real(real64) :: wide

      integer(int32), parameter :: infinity_bits = int(z'7F800000', int32)
      integer(int64), parameter :: quiet_nan_bits = int(z'7FF8000000000000', int64)

      if (iand(transfer(x, 0_int32), huge(0_int32)) > infinity_bits) then
         wide = transfer(quiet_nan_bits, 0.0_real64)
      else
         wide = real(x, real64)
      end if
   end function widen_real32

   function real_text(value) result(text)
      real(real64), intent(in) :: value
      character(len=:), allocatable :: text

      character(len=40) :: buffer

      write (buffer, '(g0)') value
      text = trim(buffer)
   end function real_text

   function integer_text(value) result(text)
      integer(int64), intent(in) :: value
      character(len=:), allocatable :: text

      character(len=40) :: buffer

      write (buffer, '(i0)') value
      text = trim(buffer)
   end function integer_text

   function list_text(values) result(text)
      integer, intent(in) :: values(:)
      character(len=:), allocatable :: text

      character(len=100) :: buffer

      write (buffer, '("[", *(i0, :, ","))') values
      text = trim(buffer)//']'
   end function list_text

end module funit_verify

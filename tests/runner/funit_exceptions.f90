! SPDX-License-Identifier: GPL-3.0-or-later
!> Failures of the running test, and where they were raised.
!>
!> Test files call assertions without a handle, so the list of pending failures is a variable of this
!> module; it is the one position of the runner that assertions change.
module funit_exceptions
   implicit none (type, external)
   private
   public :: SourceLocation, failure_t, throw, anyExceptions, is_caught, take_failures

   !> Line of a test file.
   type :: SourceLocation
      !> Name of the file, without folders.
      character(len=200) :: file = '<unknown file>'
      !> Number of the line, from 1.
      integer :: line = 0
   end type SourceLocation

   !> A failed assertion.
   type :: failure_t
      !> What was expected and what was found; may have several lines.
      character(len=:), allocatable :: message
      type(SourceLocation) :: location
   end type failure_t

   type(failure_t), allocatable :: pending(:)

contains

   !> Add a failure of the running test.
   subroutine throw(message, location)
      character(len=*), intent(in) :: message
      type(SourceLocation), intent(in), optional :: location

      type(failure_t), allocatable :: longer(:)
      integer :: i, n

      n = count_pending()
      allocate (longer(n + 1))
      do i = 1, n
         longer(i) = pending(i)
      end do
      longer(n + 1)%message = trim(message)
      if (present(location)) longer(n + 1)%location = location
      call move_alloc(longer, pending)
   end subroutine throw

   !> Whether the running test has failed so far.
   logical function anyExceptions()
      anyExceptions = count_pending() > 0
   end function anyExceptions

   !> Drop one pending failure, the last one or the first one with the given message; false if there is none.
   logical function is_caught(message)
      character(len=*), intent(in), optional :: message

      type(failure_t), allocatable :: shorter(:)
      integer :: dropped, i, n

      n = count_pending()
      dropped = n
      if (present(message)) dropped = find_message(message)
      is_caught = dropped > 0
      if (.not. is_caught) return

      allocate (shorter(n - 1))
      do i = 1, n - 1
         shorter(i) = pending(merge(i, i + 1, i < dropped))
      end do
      call move_alloc(shorter, pending)
   end function is_caught

   !> Hand over all pending failures and forget them.
   subroutine take_failures(failures)
      type(failure_t), allocatable, intent(out) :: failures(:)

      if (.not. allocated(pending)) allocate (pending(0))
      call move_alloc(pending, failures)
   end subroutine take_failures

   integer function count_pending()
      count_pending = 0
      if (allocated(pending)) count_pending = size(pending)
   end function count_pending

   !> Position of the first pending failure with this message, or 0.
   integer function find_message(message) result(position)
      character(len=*), intent(in) :: message

      do position = 1, count_pending()
         if (pending(position)%message == message) return
      end do
      position = 0
   end function find_message

end module funit_exceptions

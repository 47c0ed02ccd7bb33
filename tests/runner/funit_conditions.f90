! SPDX-License-Identifier: GPL-3.0-or-later
!> Assertions about a single condition: true, false, NaN, finite, failed, raised.
module funit_conditions
   use, intrinsic :: iso_fortran_env, only: real32, real64
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_is_nan
   use, intrinsic :: ieee_exceptions, only: ieee_all, ieee_get_status, ieee_set_halting_mode, &
      ieee_set_status, ieee_status_type
   use funit_exceptions, only: is_caught, SourceLocation, throw
   use funit_verify, only: widen
   implicit none (type, external)
   private
   public :: assertTrue, assertFalse, assertIsNaN, assertIsFinite, assertFail, assertExceptionRaised

   interface assertTrue
      module procedure :: true_scalar, true_vector
   end interface assertTrue

   interface assertFalse
      module procedure :: false_scalar, false_vector
   end interface assertFalse

   interface assertIsNaN
      module procedure :: is_nan_real64, is_nan_real32
   end interface assertIsNaN

   interface assertIsFinite
      module procedure :: is_finite_real64, is_finite_real32
   end interface assertIsFinite

contains

   subroutine true_scalar(condition, message, location)
      logical, intent(in) :: condition
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      call require(condition, 'AssertTrue failure', message, location)
   end subroutine true_scalar

   subroutine true_vector(condition, message, location)
      logical, intent(in) :: condition(:)
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      call require(all(condition), 'AssertTrue failure', message, location)
   end subroutine true_vector

   subroutine false_scalar(condition, message, location)
      logical, intent(in) :: condition
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      call require(.not. condition, 'AssertFalse failure', message, location)
   end subroutine false_scalar

   subroutine false_vector(condition, message, location)
      logical, intent(in) :: condition(:)
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      call require(.not. any(condition), 'AssertFalse failure', message, location)
   end subroutine false_vector

   subroutine is_nan_real64(x, message, location)
      real(real64), intent(in) :: x
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      type(ieee_status_type) :: status

      call ieee_get_status(status)
      call ieee_set_halting_mode(ieee_all, .false.)
      call require(ieee_is_nan(x), 'AssertIsNaN failure', message, location)
      call ieee_set_status(status)
   end subroutine is_nan_real64

   subroutine is_nan_real32(x, message, location)
      real(real32), intent(in) :: x
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      call is_nan_real64(widen(x), message, location)
   end subroutine is_nan_real32

   subroutine is_finite_real64(x, message, location)
      real(real64), intent(in) :: x
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      type(ieee_status_type) :: status

      call ieee_get_status(status)
      call ieee_set_halting_mode(ieee_all, .false.)
      call require(ieee_is_finite(x), 'AssertIsFinite failure', message, location)
      call ieee_set_status(status)
   end subroutine is_finite_real64

   subroutine is_finite_real32(x, message, location)
      real(real32), intent(in) :: x
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      call is_finite_real64(widen(x), message, location)
   end subroutine is_finite_real32

   subroutine assertFail(message, location)
      character(len=*), intent(in) :: message
      type(SourceLocation), intent(in), optional :: location

      call throw(message, location)
   end subroutine assertFail

   !> An earlier call of this test has failed, with this message if one is given; that failure is forgiven.
   subroutine assertExceptionRaised(message, location)
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      if (is_caught(message)) return
      if (present(message)) then
         call throw('Failed to throw exception: <'//trim(message)//'>', location)
      else
         call throw('Failed to throw exception.', location)
      end if
   end subroutine assertExceptionRaised

   !> Raise a failure, described by the user's message if there is one, unless the condition holds.
   subroutine require(condition, text, message, location)
      logical, intent(in) :: condition
      character(len=*), intent(in) :: text
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      if (condition) return
      if (present(message)) then
         call throw(message, location)
      else
         call throw(text, location)
      end if
   end subroutine require

end module funit_conditions

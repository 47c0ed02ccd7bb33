! SPDX-License-Identifier: GPL-3.0-or-later
!> What a test file sees with `use funit`: the assertions of pFUnit that this runner knows.
module funit
   use funit_exceptions, only: anyExceptions, SourceLocation, throw
   use funit_conditions, only: assertExceptionRaised, assertFail, assertFalse, assertIsFinite, &
      assertIsNaN, assertTrue
   use funit_comparisons, only: assertEqual, assertGreaterThan, assertGreaterThanOrEqual, assertLessThan, &
      assertLessThanOrEqual, assertRelativelyEqual
   implicit none (type, external)
   private
   public :: anyExceptions, SourceLocation, throw
   public :: assertExceptionRaised, assertFail, assertFalse, assertIsFinite, assertIsNaN, assertTrue
   public :: assertEqual, assertGreaterThan, assertGreaterThanOrEqual, assertLessThan, &
      assertLessThanOrEqual, assertRelativelyEqual
end module funit

! SPDX-License-Identifier: GPL-3.0-or-later
!> Numbers with no more digits than their errors have two of.
module adfric_command_rounding
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_base_text, only: show_number
   implicit none (type, external)
   private
   public :: show_to_error, show_to_digits

   !> Decimal digits that tell any two numbers apart.
   integer, parameter :: all_digits = 17

contains

   !> A number to the second digit of its error; with two digits if it is smaller than that, without an error with three.
   pure function show_to_error(value, error) result(text)
      !> The number, or NaN.
      real(dp), intent(in) :: value
      !> Its error, > 0; NaN or 0: there is none.
      real(dp), intent(in) :: error
      character(:), allocatable :: text

      if (is_within(value, error)) then
         text = show_to_digits(value, 2)
      else if (has_error(error)) then
         text = show_to_step(value, exponent_of(rounded(error, 2)) - 1)
      else
         text = show_to_digits(value, 3)
      end if
   end function show_to_error

   !> A number with some digits.
   pure function show_to_digits(value, n_digits) result(text)
      real(dp), intent(in) :: value
      integer, intent(in) :: n_digits
      character(:), allocatable :: text

      if (.not. ieee_is_finite(value)) then
         text = 'none'
      else if (.not. abs(value) > 0) then
         text = '0'
      else
         text = show_to_step(value, exponent_of(abs(value)) - n_digits + 1)
      end if
   end function show_to_digits

   !> Is a number smaller than its error?
   pure logical function is_within(value, error)
      real(dp), intent(in) :: value
      !> Its error, NaN or 0.
      real(dp), intent(in) :: error

      is_within = has_error(error) .and. ieee_is_finite(value)
      if (is_within) is_within = abs(value) < error
   end function is_within

   !> Is there an error?
   pure logical function has_error(error)
      !> The error, NaN or 0.
      real(dp), intent(in) :: error

      has_error = ieee_is_finite(error)
      if (has_error) has_error = error > 0
   end function has_error

   !> A number rounded to some digits: 0.0996 to 0.10, whose first digit stands elsewhere.
   pure real(dp) function rounded(value, n_digits)
      !> The number, > 0.
      real(dp), intent(in) :: value
      integer, intent(in) :: n_digits

      rounded = round_to(value, exponent_of(value) - n_digits + 1)
   end function rounded

   !> Decimal exponent of the first digit.
   pure integer function exponent_of(value)
      real(dp), intent(in) :: value

      exponent_of = floor(log10(value)*(1 + sign(epsilon(value), log10(value))))
   end function exponent_of

   !> A number as a multiple of a power of ten.
   pure function show_to_step(value, exponent) result(text)
      real(dp), intent(in) :: value
      integer, intent(in) :: exponent
      character(:), allocatable :: text

      text = 'none'
      if (ieee_is_finite(value)) text = show_number(round_to(value, exponent))
   end function show_to_step

   !> The multiple of a power of ten next to a number, by its decimal digits, so that no others come in.
   pure real(dp) function round_to(value, exponent)
      !> The number.
      real(dp), intent(in) :: value
      integer, intent(in) :: exponent
      character(40) :: buffer
      character(16) :: form
      integer :: n_digits

      round_to = 0
      if (.not. abs(value) > 0) return
      n_digits = exponent_of(abs(value)) - exponent + 1
      if (n_digits < 1) then
         ! half of the power of ten, or more, is the power itself
         if (n_digits == 0 .and. abs(value) >= 0.5_dp*10.0_dp**exponent) round_to = sign(10.0_dp**exponent, value)
         return
      end if
      write (form, '(a, i0, a)') '(es40.', min(n_digits, all_digits) - 1, 'e3)'
      write (buffer, form) value
      read (buffer, *) round_to
   end function round_to

end module adfric_command_rounding

! SPDX-License-Identifier: GPL-3.0-or-later
!> The values of a sweep between two ends.
module adfric_input_sweep_values
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: fill_linear, fill_logarithmic

   !> Where products of a value and a count could overflow, values are scaled by a power of 2.
   real(dp), parameter :: large = 1e290_dp, scaling = 2.0_dp**(-40)

contains

   !> Values at equal distances; the ends are met to the last bit.
   pure subroutine fill_linear(from, to, values)
      !> First and last value, in any order.
      real(dp), intent(in) :: from, to
      !> Receives the values, as many as there is space for; a single one is `from`.
      real(dp), intent(out) :: values(:)
      real(dp) :: s, n, steps
      integer :: i

      s = merge(scaling, 1.0_dp, max(abs(from), abs(to)) > large)
      steps = real(max(size(values) - 1, 1), dp)
      do i = 1, size(values)
         n = real(i - 1, dp)
         values(i) = keep_between(((s*from)*(steps - n) + (s*to)*n)/steps, s*from, s*to)/s
         ! a step on zero is zero, not the round-off of the ends
         if (abs(values(i)) < 4*epsilon(s)*max(abs(from), abs(to))) values(i) = 0
      end do
      call set_ends(from, to, values)
   end subroutine fill_linear

   !> Values at equal ratios; the ends are met to the last bit, and powers of ten between powers of ten.
   pure subroutine fill_logarithmic(from, to, values)
      !> First and last value, in any order; both positive or both negative.
      real(dp), intent(in) :: from, to
      real(dp), intent(out) :: values(:)
      real(dp) :: first, last, n, steps, magnitude
      integer :: i

      first = log10(abs(from))
      last = log10(abs(to))
      steps = real(max(size(values) - 1, 1), dp)
      do i = 2, size(values) - 1
         n = real(i - 1, dp)
         magnitude = keep_between((first*(steps - n) + last*n)/steps, first, last)
         values(i) = keep_between(sign(10.0_dp**magnitude, from), from, to)
      end do
      call set_ends(from, to, values)
   end subroutine fill_logarithmic

   !> The first value is `from`, the last is `to`.
   pure subroutine set_ends(from, to, values)
      !> First and last value.
      real(dp), intent(in) :: from, to
      !> The values between which these ends are set; a single one becomes `from`.
      real(dp), intent(inout) :: values(:)

      if (size(values) < 1) return
      values(size(values)) = to
      values(1) = from
   end subroutine set_ends

   !> The value, or the end that rounding has carried it past.
   elemental real(dp) function keep_between(value, one_end, other_end)
      !> A value that should lie between the ends.
      real(dp), intent(in) :: value
      !> The ends, in any order.
      real(dp), intent(in) :: one_end, other_end

      keep_between = min(max(value, min(one_end, other_end)), max(one_end, other_end))
   end function keep_between

end module adfric_input_sweep_values

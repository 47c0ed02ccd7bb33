! SPDX-License-Identifier: GPL-3.0-or-later
!> Random numbers of a counter: each follows from its counter and its key alone, so that it does not matter which others are
!> drawn, in which order, or by whom. The generator is Philox4x32-10 (J. K. Salmon, M. A. Moraes, R. O. Dror, D. E. Shaw, SC11
!> (2011), paper 16). Its words of 32 bits stand in whole numbers of 64 bits, of which no product overflows.
module adfric_numerics_counted_numbers
   use adfric_base_kinds, only: dp, i8
   implicit none (type, external)
   private
   public :: counted_words, counted_uniforms

   !> The largest word, and that of half its bits.
   integer(i8), parameter :: word = 4294967295_i8, half_word = 65535_i8
   !> Factors of the counter, and what is added to the key in each round.
   integer(i8), parameter :: factors(2) = [3528531795_i8, 3449720151_i8], steps(2) = [2654435769_i8, 3144134277_i8]
   integer, parameter :: n_rounds = 10

contains

   !> Four random words.
   pure function counted_words(counter, key) result(words)
      !> Counter and key, of words from 0 to 2^32 - 1.
      integer(i8), intent(in) :: counter(4), key(2)
      integer(i8) :: words(4), k(2), high(2), low(2)
      integer :: round

      words = counter
      k = key
      do round = 1, n_rounds
         call multiply(factors, words([1, 3]), high, low)
         words = [ieor(ieor(high(2), words(2)), k(1)), low(2), ieor(ieor(high(1), words(4)), k(2)), low(1)]
         k = iand(k + steps, word)
      end do
   end function counted_words

   !> High and low word of a product of words.
   elemental subroutine multiply(a, b, high, low)
      integer(i8), intent(in) :: a, b
      integer(i8), intent(out) :: high, low
      integer(i8) :: lower, upper

      lower = a*iand(b, half_word)
      upper = a*shiftr(b, 16) + shiftr(lower, 16)
      high = shiftr(upper, 16)
      low = ior(shiftl(iand(upper, half_word), 16), iand(lower, half_word))
   end subroutine multiply

   !> Two numbers, evenly spread between 0 and 1, both left out, of 52 bits each.
   pure function counted_uniforms(counter, key) result(numbers)
      !> Any two whole numbers of the default kind, as counter; they are told apart by their low 32 bits.
      integer, intent(in) :: counter(2)
      !> Any whole number, as key.
      integer, intent(in) :: key
      real(dp) :: numbers(2)
      integer(i8) :: words(4)

      words = counted_words([iand(int(counter, i8), word), 0_i8, 0_i8], [iand(int(key, i8), word), 0_i8])
      numbers = (shiftl(words([1, 3]), 20) + shiftr(words([2, 4]), 12) + 0.5_dp)*2.0_dp**(-52)
   end function counted_uniforms

end module adfric_numerics_counted_numbers

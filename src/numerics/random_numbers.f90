! SPDX-License-Identifier: GPL-3.0-or-later
!> Random numbers that are the same on every machine: the generator MRG32k3a (P. L'Ecuyer, Operations Research 47, 1999, 159), whose whole
!> numbers stay below 2^53, and normal ones by G. E. P. Box and M. E. Muller (1958).
module adfric_numerics_random_numbers
   use adfric_base_kinds, only: dp, i8
   use adfric_base_constants, only: two_pi
   implicit none (type, external)
   private
   public :: random_t, new_random, next_uniform, next_normal

   !> The two moduli, and the factors.
   integer(i8), parameter :: first_modulus = 4294967087_i8, second_modulus = 4294944443_i8
   integer(i8), parameter :: first_factors(2) = [1403580_i8, 810728_i8], second_factors(2) = [527612_i8, 1370589_i8]
   !> Numbers that are drawn and left out, so that seeds that are near each other begin apart.
   integer, parameter :: n_left_out = 20

   !> A sequence.
   type :: random_t
      !> The last three numbers of both generators.
      integer(i8) :: first(3) = 12345_i8, second(3) = 12345_i8
   end type random_t

contains

   !> Begin a sequence.
   pure subroutine new_random(self, seed)
      !> Receives the sequence.
      type(random_t), intent(out) :: self
      !> Any number.
      integer, intent(in) :: seed
      real(dp) :: unused
      integer :: k

      self%first(1) = 1 + modulo(int(seed, i8), first_modulus - 1)
      self%second(1) = 1 + modulo(int(seed, i8)*7919_i8, second_modulus - 1)
      do k = 1, n_left_out
         call next_uniform(self, unused)
      end do
   end subroutine new_random

   !> The next number, evenly spread between 0 and 1, both left out.
   pure subroutine next_uniform(self, number)
      type(random_t), intent(inout) :: self
      real(dp), intent(out) :: number
      integer(i8) :: one, two

      one = modulo(first_factors(1)*self%first(2) - first_factors(2)*self%first(1), first_modulus)
      two = modulo(second_factors(1)*self%second(3) - second_factors(2)*self%second(1), second_modulus)
      self%first = [self%first(2:), one]
      self%second = [self%second(2:), two]
      one = modulo(one - two, first_modulus)
      if (one == 0) one = first_modulus
      number = one/(first_modulus + 1.0_dp)
   end subroutine next_uniform

   !> The next normal number.
   pure subroutine next_normal(self, number)
      !> The sequence.
      type(random_t), intent(inout) :: self
      !> Receives the number.
      real(dp), intent(out) :: number
      real(dp) :: u, v

      call next_uniform(self, u)
      call next_uniform(self, v)
      number = sqrt(-2*log(u))*cos(two_pi*v)
   end subroutine next_normal

end module adfric_numerics_random_numbers

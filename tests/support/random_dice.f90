! SPDX-License-Identifier: GPL-3.0-or-later
!> Random numbers that are the same on every machine.
module random_dice
   use adfric_base_kinds, only: dp, i8
   implicit none (type, external)
   private
   public :: dice_t, new_dice

   !> Two coupled generators of L'Ecuyer, Communications of the ACM 31 (1988) 742; period 2.3e18.
   type :: dice_t
      private
      integer(i8) :: first = 1, second = 1
   contains
      procedure :: between
      procedure :: decades
      procedure :: choose
      procedure :: happens
   end type dice_t

contains

   !> Dice that fall the same way for the same seed.
   pure subroutine new_dice(self, seed)
      type(dice_t), intent(out) :: self
      integer, intent(in) :: seed
      real(dp) :: unused
      integer :: k

      self%first = 1 + modulo(int(seed, i8), 2147483562_i8)
      self%second = 1 + modulo(16807_i8*seed, 2147483398_i8)
      do k = 1, 20
         call self%between(0.0_dp, 1.0_dp, unused)
      end do
   end subroutine new_dice

   !> A number that is uniform between two bounds.
   pure subroutine between(self, low, high, value)
      class(dice_t), intent(inout) :: self
      real(dp), intent(in) :: low, high
      real(dp), intent(out) :: value
      integer(i8), parameter :: first_modulus = 2147483563_i8, second_modulus = 2147483399_i8

      self%first = mod(40014_i8*self%first, first_modulus)
      self%second = mod(40692_i8*self%second, second_modulus)
      value = low + (high - low)*real(modulo(self%first - self%second, first_modulus - 1), dp)/(first_modulus - 1)
   end subroutine between

   !> A number whose logarithm is uniform between 10**low and 10**high.
   pure subroutine decades(self, low, high, value)
      class(dice_t), intent(inout) :: self
      real(dp), intent(in) :: low, high
      real(dp), intent(out) :: value

      call self%between(low, high, value)
      value = 10.0_dp**value
   end subroutine decades

   !> A whole number from 1 to n.
   pure subroutine choose(self, n, number)
      class(dice_t), intent(inout) :: self
      integer, intent(in) :: n
      integer, intent(out) :: number
      real(dp) :: value

      call self%between(0.0_dp, 1.0_dp, value)
      number = min(n, 1 + int(n*value))
   end subroutine choose

   !> True with a probability.
   pure subroutine happens(self, probability, is_so)
      class(dice_t), intent(inout) :: self
      real(dp), intent(in) :: probability
      logical, intent(out) :: is_so
      real(dp) :: value

      call self%between(0.0_dp, 1.0_dp, value)
      is_so = value < probability
   end subroutine happens

end module random_dice

! SPDX-License-Identifier: GPL-3.0-or-later
!> Times of contacts of a sphere by Maugis's theory, and the numbers that are held.
module sphere_timing
   use adfric_base_kinds, only: dp
   use adfric_round_sphere_contact, only: sphere_contact_t, branch_stable, find_contact
   use adfric_round_sphere_maugis_dugdale, only: maugis_t
   use adfric_system_clock, only: wall_clock
   use random_dice, only: dice_t, new_dice
   implicit none (type, external)
   private
   public :: time_theory, time_pull_off, even, logarithmic, shuffle

   integer, parameter :: n_pull_offs = 200

contains

   !> Microseconds per contact, each started from the last one or from nothing.
   subroutine time_theory(lambda, control, prescribed, is_warm, times, n_failed)
      real(dp), intent(in) :: lambda, prescribed(:)
      integer, intent(in) :: control
      logical, intent(in) :: is_warm
      real(dp), intent(out) :: times(:)
      !> Of the last repetition.
      integer, intent(out) :: n_failed
      type(maugis_t) :: theory
      type(sphere_contact_t) :: contact
      real(dp) :: start
      integer :: r, k

      theory%lambda = lambda
      do r = 1, size(times)
         contact = sphere_contact_t()
         n_failed = 0
         start = wall_clock()
         do k = 1, size(prescribed)
            if (.not. is_warm) contact%position = 0
            call find_contact(theory, control, prescribed(k), branch_stable, contact)
            if (.not. (contact%is_found .and. contact%is_converged)) n_failed = n_failed + 1
         end do
         times(r) = 1.0e6_dp*(wall_clock() - start)/size(prescribed)
      end do
   end subroutine time_theory

   !> Microseconds of a pull-off, of lambdas close to one.
   subroutine time_pull_off(lambda, control, times, n_failed)
      real(dp), intent(in) :: lambda
      integer, intent(in) :: control
      real(dp), intent(out) :: times(:)
      integer, intent(out) :: n_failed
      type(maugis_t) :: theory
      type(sphere_contact_t) :: contact
      real(dp) :: start
      integer :: r, k

      do r = 1, size(times)
         n_failed = 0
         start = wall_clock()
         do k = 1, n_pull_offs
            theory%lambda = lambda*(1 + 0.1_dp*k/n_pull_offs)
            call theory%pull_off(control, contact)
            if (.not. (contact%is_found .and. contact%is_converged)) n_failed = n_failed + 1
         end do
         times(r) = 1.0e6_dp*(wall_clock() - start)/n_pull_offs
      end do
   end subroutine time_pull_off

   !> Numbers in even steps.
   pure function even(low, high, n) result(numbers)
      real(dp), intent(in) :: low, high
      integer, intent(in) :: n
      real(dp) :: numbers(n)
      integer :: k

      numbers = [(low + (high - low)*(k - 1)/(n - 1), k=1, n)]
   end function even

   !> Numbers whose logarithms are in even steps.
   pure function logarithmic(low, high, n) result(numbers)
      !> Decimal logarithms.
      real(dp), intent(in) :: low, high
      integer, intent(in) :: n
      real(dp) :: numbers(n)
      integer :: k

      numbers = [(10**(low + (high - low)*(k - 1)/(n - 1)), k=1, n)]
   end function logarithmic

   !> The same numbers in random order.
   pure function shuffle(numbers) result(shuffled)
      real(dp), intent(in) :: numbers(:)
      real(dp) :: shuffled(size(numbers)), moved, position
      type(dice_t) :: dice
      integer :: k, other

      call new_dice(dice, 1)
      shuffled = numbers
      do k = size(numbers), 2, -1
         call dice%between(1.0_dp, real(k + 1, dp), position)
         other = min(int(position), k)
         moved = shuffled(k)
         shuffled(k) = shuffled(other)
         shuffled(other) = moved
      end do
   end function shuffle

end module sphere_timing

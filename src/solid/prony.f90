! SPDX-License-Identifier: GPL-3.0-or-later
!> The relaxation spectrum of a viscoelastic solid: a spring and N Maxwell arms in parallel.
!>
!> $$ M(s) = k_0 + \sum_i k_i \frac{s \tau_i}{1 + s \tau_i}, \qquad k_g = k_0 + \sum_i k_i, $$
!> with all moduli positive, in any unit. k0 is the relaxed modulus, kg the instantaneous one.
!> The complex modulus is M(i omega) = storage + i loss.
module adfric_solid_prony
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   implicit none (type, external)
   private
   public :: prony_t, new_prony, instantaneous_modulus, get_complex_modulus, most_arms

   !> Largest number of Maxwell arms.
   integer, parameter :: most_arms = 64

   !> A relaxation spectrum.
   type :: prony_t
      !> Relaxed modulus k0 [any unit of a modulus], > 0; 0 is a fluid.
      real(dp) :: relaxed = 1
      !> Moduli k_i of the arms [unit of `relaxed`], > 0; shape `(n_arms)`.
      real(dp), allocatable :: moduli(:)
      !> Relaxation times tau_i of the arms [s], > 0, strictly rising; shape `(n_arms)`.
      real(dp), allocatable :: times(:)
   contains
      procedure :: instantaneous_modulus
      procedure :: get_complex_modulus
   end type prony_t

contains

   !> A relaxation spectrum from arms in any order. Arms of times that are equal to round-off become one, and arms without a modulus
   !> are left out.
   pure subroutine new_prony(self, relaxed, moduli, times)
      !> The spectrum.
      type(prony_t), intent(out) :: self
      !> Relaxed modulus [any unit of a modulus], > 0; 0 is a fluid.
      real(dp), intent(in) :: relaxed
      !> Moduli of the arms [unit of `relaxed`], >= 0; any number of them, of which at most `most_arms` remain.
      real(dp), intent(in) :: moduli(:)
      !> Relaxation times of the arms [s], > 0; as many as moduli.
      real(dp), intent(in) :: times(:)
      real(dp) :: sorted_moduli(size(moduli)), sorted_times(size(moduli))
      integer :: i, n

      if (has_asserts) call assert(size(times) == size(moduli), 'new_prony: a time for each modulus')
      if (has_asserts) call assert(relaxed >= 0 .and. all(moduli >= 0) .and. all(times > 0), &
         & 'new_prony: relaxed >= 0, moduli >= 0, times > 0')
      n = 0
      do i = 1, size(moduli)
         if (moduli(i) > 0) call insert_arm(sorted_moduli, sorted_times, n, moduli(i), times(i))
      end do
      if (has_asserts) call assert(n <= most_arms, 'new_prony: most_arms')
      self%relaxed = relaxed
      self%moduli = sorted_moduli(:n)
      self%times = sorted_times(:n)
   end subroutine new_prony

   !> Put an arm in order among others of rising times. Times that are the same but for round-off are one: between two of them
   !> there would be a retardation time without digits.
   pure subroutine insert_arm(moduli, times, n, modulus, time)
      !> Moduli of the arms so far, with a position for one more.
      real(dp), intent(inout) :: moduli(:)
      !> Relaxation times of these arms, strictly rising [s].
      real(dp), intent(inout) :: times(:)
      !> Number of arms so far.
      integer, intent(inout) :: n
      !> Modulus of the new arm, > 0.
      real(dp), intent(in) :: modulus
      !> Relaxation time of the new arm [s], > 0.
      real(dp), intent(in) :: time
      real(dp), parameter :: round_off = 8*epsilon(1.0_dp)
      integer :: position

      do position = 1, n
         if (abs(times(position) - time) > round_off*time) cycle
         moduli(position) = moduli(position) + modulus
         return
      end do
      position = count(times(:n) < time) + 1
      moduli(position + 1:n + 1) = moduli(position:n)
      times(position + 1:n + 1) = times(position:n)
      moduli(position) = modulus
      times(position) = time
      n = n + 1
   end subroutine insert_arm

   !> The modulus kg of the first moment, k0 and all k_i.
   pure real(dp) function instantaneous_modulus(self)
      class(prony_t), intent(in) :: self

      instantaneous_modulus = self%relaxed + sum(self%moduli)
   end function instantaneous_modulus

   !> Storage and loss modulus at a frequency.
   !>
   !> Each is a sum of positive terms, and no term has a square of omega tau beyond 1: both are right to round-off at any frequency.
   elemental subroutine get_complex_modulus(self, frequency, storage, loss)
      class(prony_t), intent(in) :: self
      !> Angular frequency omega [rad/s], >= 0.
      real(dp), intent(in) :: frequency
      !> Real part of M(i omega) [unit of `relaxed`].
      real(dp), intent(out) :: storage
      !> Imaginary part of M(i omega) [unit of `relaxed`], >= 0.
      real(dp), intent(out) :: loss
      real(dp) :: rate, ratio
      integer :: i

      if (has_asserts) call assert(frequency >= 0, 'get_complex_modulus: frequency >= 0')
      storage = self%relaxed
      loss = 0
      do i = 1, size(self%times)
         ! omega tau, or its inverse where that is less
         rate = 1/self%times(i)
         ratio = min(frequency, rate)/max(frequency, rate)
         loss = loss + self%moduli(i)*(ratio/(1 + ratio**2))
         if (frequency < rate) then
            storage = storage + self%moduli(i)*(ratio**2/(1 + ratio**2))
         else
            storage = storage + self%moduli(i)/(1 + ratio**2)
         end if
      end do
   end subroutine get_complex_modulus

end module adfric_solid_prony

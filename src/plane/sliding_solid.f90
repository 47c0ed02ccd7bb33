! SPDX-License-Identifier: GPL-3.0-or-later
!> The viscoelastic solid as a body sees it that slides over it at a constant speed V: relaxation and retardation times become
!> lengths.
!>
!> In the frame of the body, which moves to +x, d/dt = -V d/dx, and the relation of pressure and displacement of an elastic half-
!> plane with the relaxed modulus E0 holds between
!>
!>     prod (1 - a_i d/dx) p   and   prod (1 - b_j d/dx) u,    a_i = V tau_i,  b_j = V lambda_j,  a_1 < b_1 < a_2 < ... < b_n
!>
!> with the relaxation times tau_i and the retardation times lambda_j. The unit of length is free; a wave has 1/k, and a cylinder
!> the half-width of its contact.
module adfric_plane_sliding_solid
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_solid_prony, only: prony_t
   use adfric_solid_retardation, only: retardation_t, new_retardation
   implicit none (type, external)
   private
   public :: sliding_solid_t, new_sliding_solid, suits_solid

   !> Bounds of the lengths, in the unit of length: no product of two of them, or of their inverses, overflows.
   real(dp), parameter :: least_length = 1.0e-100_dp, largest_length = 1.0e100_dp

   !> A solid that is slid over.
   type :: sliding_solid_t
      !> Number n of arms; none where the solid is elastic or at rest.
      integer :: n_arms = 0
      !> Moduli of the arms over the relaxed modulus, e_i = E_i/E0 [-], > 0; shape `(n)`.
      real(dp), allocatable :: ratios(:)
      !> Relaxation lengths a_i [unit of length], > 0, rising; shape `(n)`.
      real(dp), allocatable :: relaxation(:)
      !> Retardation lengths b_j [unit of length], > 0, rising; shape `(n)`.
      real(dp), allocatable :: retardation(:)
      !> Distances b_j - a_i [unit of length], each to all its digits; shape `(n, n)`, i first.
      real(dp), allocatable :: distances(:, :)
   contains
      procedure :: get_complex_ratio
      procedure :: instantaneous_ratio
      procedure :: change_unit
   end type sliding_solid_t

contains

   !> A solid that is slid over.
   pure subroutine new_sliding_solid(self, prony, speed)
      type(sliding_solid_t), intent(out) :: self
      !> Its relaxation spectrum, `relaxed` > 0.
      type(prony_t), intent(in) :: prony
      !> Speed of the body [unit of length/s], one that `suits_solid`.
      real(dp), intent(in) :: speed
      type(retardation_t) :: retardation

      if (has_asserts) call assert(prony%relaxed > 0 .and. suits_solid(prony, speed), 'new_sliding_solid: relaxed > 0, suits_solid')
      if (speed > 0) self%n_arms = size(prony%times)
      if (speed > 0) then
         call new_retardation(retardation, prony)
         self%ratios = prony%moduli/prony%relaxed
         self%relaxation = speed*prony%times
         self%retardation = speed*retardation%times
         self%distances = speed*retardation%distances
      else
         allocate (self%ratios(0), self%relaxation(0), self%retardation(0), self%distances(0, 0))
      end if
   end subroutine new_sliding_solid

   !> Is a speed 0, or such that no length is beyond the bounds? A negative one is not, nor is NaN.
   pure logical function suits_solid(prony, speed)
      !> Relaxation spectrum of the solid, `relaxed` > 0.
      type(prony_t), intent(in) :: prony
      !> Speed of the body [unit of length/s].
      real(dp), intent(in) :: speed

      suits_solid = speed >= 0
      if (.not. suits_solid .or. .not. speed > 0 .or. size(prony%times) == 0) return
      ! no retardation time is longer than the longest relaxation time by more than the ratio of the moduli
      suits_solid = prony%times(1) >= least_length/speed .and. &
         & prony%times(size(prony%times)) <= largest_length/max(speed, least_length)*(prony%relaxed/prony%instantaneous_modulus())
   end function suits_solid

   !> Storage and loss modulus over the relaxed modulus that a wave sees whose wave number is 1.
   pure subroutine get_complex_ratio(self, storage, loss)
      class(sliding_solid_t), intent(in) :: self
      !> E'/E0 [-], >= 1.
      real(dp), intent(out) :: storage
      !> E''/E0 [-], >= 0.
      real(dp), intent(out) :: loss

      loss = sum(self%ratios/(self%relaxation + 1/self%relaxation))
      storage = 1 + sum(self%ratios*self%relaxation/(self%relaxation + 1/self%relaxation))
   end subroutine get_complex_ratio

   !> The instantaneous modulus over the relaxed one.
   pure real(dp) function instantaneous_ratio(self)
      class(sliding_solid_t), intent(in) :: self

      instantaneous_ratio = 1 + sum(self%ratios)
   end function instantaneous_ratio

   !> Give the lengths in another unit.
   pure subroutine change_unit(self, unit)
      class(sliding_solid_t), intent(inout) :: self
      !> The new unit [unit of length], > 0.
      real(dp), intent(in) :: unit

      if (has_asserts) call assert(unit > 0, 'change_unit: unit > 0')
      self%relaxation = self%relaxation/unit
      self%retardation = self%retardation/unit
      self%distances = self%distances/unit
   end subroutine change_unit

end module adfric_plane_sliding_solid

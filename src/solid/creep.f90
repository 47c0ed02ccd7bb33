! SPDX-License-Identifier: GPL-3.0-or-later
!> Creep of a viscoelastic solid under a load that goes in straight legs.
!>
!> The creep compliance is \( J(t) = 1/k_g + \sum_j c_j (1 - e^{-t/\lambda_j}) \) (`adfric_solid_retardation`), and the strain under
!> a load P(t) that begins from 0
!> $$ Q(t) = \int J(t - s) \mathrm{d}P(s) = \frac{P}{k_g} + \sum_j c_j n_j, \qquad \dot n_j = \frac{P - n_j}{\lambda_j} . $$
!> On a leg of slope s it is known in closed form, and so is its rate, a constant and a sum of exponentials:
!> $$ \dot Q = \frac{s}{k_0} + \sum_j c_j \left(\frac{P_0 - n_j}{\lambda_j} - s\right) e^{-\tau/\lambda_j} . $$
module adfric_solid_creep
   use adfric_base_kinds, only: dp
   use adfric_numerics_libm, only: expm1
   use adfric_solid_prony, only: prony_t
   use adfric_solid_retardation, only: new_retardation, retardation_t
   implicit none (type, external)
   private
   public :: creep_t, new_creep

   !> The state of a creeping solid.
   type :: creep_t
      private
      !> Load now.
      real(dp) :: load = 0
      !> Compliances 1/k0 and 1/kg.
      real(dp) :: relaxed = 1, glassy = 1
      !> Retardation spectrum.
      type(retardation_t) :: spectrum
      !> Loads n_j of the Kelvin elements; shape `(n_arms)`.
      real(dp), allocatable :: taken(:)
   contains
      procedure :: strain
      procedure :: jump
      procedure :: follow
      procedure :: find_fall
   end type creep_t

contains

   !> A solid that was never loaded.
   pure subroutine new_creep(self, prony)
      !> Receives the solid at rest.
      type(creep_t), intent(out) :: self
      !> Its relaxation spectrum, `relaxed` > 0.
      type(prony_t), intent(in) :: prony

      call new_retardation(self%spectrum, prony)
      self%relaxed = 1/prony%relaxed
      self%glassy = 1/prony%instantaneous_modulus()
      allocate (self%taken(size(prony%times)), source=0.0_dp)
   end subroutine new_creep

   !> The strain Q, a load over a modulus.
   pure real(dp) function strain(self)
      class(creep_t), intent(in) :: self

      strain = self%load*self%glassy + sum(self%spectrum%compliances*self%taken)
   end function strain

   !> The load changes all at once.
   elemental subroutine jump(self, change)
      class(creep_t), intent(inout) :: self
      !> Change of the load.
      real(dp), intent(in) :: change

      self%load = self%load + change
   end subroutine jump

   !> The load changes along a straight leg.
   elemental subroutine follow(self, slope, span)
      class(creep_t), intent(inout) :: self
      !> Change of the load per time, and length of the leg in time, >= 0.
      real(dp), intent(in) :: slope, span
      real(dp) :: gone
      integer :: j

      do j = 1, size(self%taken)
         associate (x => span/self%spectrum%times(j))
            gone = -expm1(-x)
            self%taken(j) = self%taken(j) + gone*(self%load - self%taken(j)) &
               & + slope*self%spectrum%times(j)*remainder_of(x, gone)
         end associate
      end do
      self%load = self%load + slope*span
   end subroutine follow

   !> x - (1 - e^(-x)), without loss of digits.
   elemental real(dp) function remainder_of(x, gone) result(remainder)
      !> x >= 0, and 1 - e^(-x).
      real(dp), intent(in) :: x, gone
      real(dp), parameter :: small = 0.25_dp
      real(dp) :: term
      integer :: k

      remainder = x - gone
      if (x > small) return
      term = x**2/2
      remainder = term
      do k = 3, 14
         term = -term*x/k
         remainder = remainder + term
      end do
   end function remainder_of

   !> Does the strain fall somewhere on a leg? The rate is a sum of exponentials, so on any part of the leg it has a lower bound:
   !> each falling term at the end of the part, each rising one at its begin. Parts are halved until the bound is above 0, or the
   !> rate at an end of the part is below 0. What is no more than round-off of the terms is no fall.
   pure subroutine find_fall(self, slope, span, falls, moment)
      class(creep_t), intent(in) :: self
      !> Change of the load per time, and length of the leg in time, >= 0.
      real(dp), intent(in) :: slope, span
      !> Receives whether it falls.
      logical, intent(out) :: falls
      !> Receives a moment of the leg at which it does, from the begin of the leg; 0 where it does not.
      real(dp), intent(out) :: moment
      real(dp), parameter :: round_off = 1.0e-12_dp
      integer, parameter :: most_halves = 20000
      real(dp) :: weights(size(self%taken)), begin, end, least
      integer :: n

      weights = self%spectrum%compliances*((self%load - self%taken)/self%spectrum%times - slope)
      least = -round_off*(abs(slope)*self%relaxed + sum(abs(weights)))
      falls = .false.
      moment = 0
      begin = 0
      end = span
      do n = 1, most_halves
         falls = rate_between(begin, begin) < least
         if (falls) exit
         if (rate_between(begin, end) >= least) then
            if (end >= span) return
            begin = end
            end = span
            cycle
         end if
         falls = rate_between(end, end) < least
         if (falls) exit
         end = begin + (end - begin)/2
      end do
      ! so many parts end beside a rate that is 0 but for a share of 1e-8 of its terms
      falls = .true.
      moment = begin
      if (rate_between(end, end) < least) moment = end

   contains

      !> A lower bound of the rate between two times of the leg; the rate itself where they are one.
      pure real(dp) function rate_between(from, to) result(rate)
         real(dp), intent(in) :: from, to

         rate = slope*self%relaxed + sum(weights*exp(-merge(to, from, weights > 0)/self%spectrum%times))
      end function rate_between

   end subroutine find_fall

end module adfric_solid_creep

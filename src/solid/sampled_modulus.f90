! SPDX-License-Identifier: GPL-3.0-or-later
!> The modulus that a viscoelastic solid shows to a history that is known at equal intervals and linear between them.
!>
!> An arm of modulus E_i and relaxation time t_i follows such a history of strains e_j exactly by
!>
!> $$ s_{j+1} = \rho s_j + E_i \gamma (e_{j+1} - e_j), \qquad \rho = e^{-x}, \quad \gamma = (1 - \rho)/x, \quad x = T/t_i, $$
!> T the interval. A wave whose phase falls by theta from one sample to the next, e_j = exp(-i j theta), therefore meets the modulus
!>
!> $$ E_i \gamma \frac{1 - e^{i \theta}}{1 - \rho e^{i \theta}} = \frac{\sum_m E_i(\omega_m)/\omega_m^2}{\sum_m 1/\omega_m^2}, \qquad
!> \omega_m = -(\theta + 2 \pi m)/T, $$
!> the mean of the modulus over all waves that have these samples, with weights of 1 over the square of the frequency (they are those of
!> a hat function, whose transform is sinc^2). So storage and loss are positive for 0 < theta < pi, and the storage modulus lies between
!> the relaxed and the instantaneous one. The answer at a sample depends on that sample and those before it alone: positively on the
!> sample itself, negatively on all others. The modulus is that of the wave itself but for a term in theta^2.
module adfric_solid_sampled_modulus
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_solid_prony, only: prony_t
   implicit none (type, external)
   private
   public :: sampled_modulus

contains

   !> Complex modulus of a wave of samples, conjugate to that of exp(i omega t): the phase falls with time.
   pure complex(dp) function sampled_modulus(prony, interval, phase) result(modulus)
      !> The relaxation spectrum.
      type(prony_t), intent(in) :: prony
      !> Time from one sample to the next [s], > 0; may be huge, for a history at rest.
      real(dp), intent(in) :: interval
      !> Phase theta by which the wave falls in an interval [rad], from -pi to pi.
      real(dp), intent(in) :: phase
      complex(dp) :: difference
      real(dp) :: decayed, intervals
      integer :: i

      if (has_asserts) call assert(interval > 0, 'sampled_modulus: interval > 0')
      modulus = prony%relaxed
      ! 1 - exp(i theta)
      difference = 2*sin(phase/2)*cmplx(sin(phase/2), -cos(phase/2), dp)
      if (.not. abs(difference) > 0) return
      do i = 1, size(prony%times)
         intervals = max(interval*(1/prony%times(i)), tiny(1.0_dp))
         decayed = decayed_share(intervals)
         modulus = modulus + prony%moduli(i)*(decayed/intervals)*(difference/(decayed + (1 - decayed)*difference))
      end do
   end function sampled_modulus

   !> 1 - exp(-x), with all its digits.
   elemental real(dp) function decayed_share(x)
      !> Argument [-], > 0.
      real(dp), intent(in) :: x
      real(dp), parameter :: largest = 700
      real(dp) :: tangent

      ! 1 - exp(-x) = 2 t/(1 + t) with t = tanh(x/2)
      tangent = tanh(min(x, largest)/2)
      decayed_share = 2*tangent/(1 + tangent)
   end function decayed_share

end module adfric_solid_sampled_modulus

! SPDX-License-Identifier: GPL-3.0-or-later
!> The retardation spectrum of a viscoelastic solid: a spring and N Kelvin elements in series, which are the same column as the
!> spring and the N Maxwell arms of its relaxation spectrum (B. Gross, Mathematical Structure of the Theories of Viscoelasticity,
!> 1953).
!>
!> $$ J(s) = \frac{1}{M(s)} = \frac{1}{k_g} + \sum_j \frac{c_j}{1 + s \lambda_j}, \qquad \sum_j c_j = \frac{1}{k_0} - \frac{1}{k_g}. $$
!> The retardation times are the roots of
!> $$ k_0 = \sum_i \frac{k_i \tau_i}{\lambda - \tau_i}, \qquad \tau_1 < \lambda_1 < \tau_2 < \dots < \tau_N < \lambda_N, $$
!> and \( 1/c_j = \lambda_j \sum_i k_i \tau_i/(\lambda_j - \tau_i)^2 \). With forces \( q_i \) of the arms and lengths \( y_j \) of the
!> elements, \( q_i/\sqrt{k_i \tau_i} \) and \( -y_j/\sqrt{c_j \lambda_j} \) follow from each other by the orthogonal matrix
!> \( \sqrt{k_i \tau_i c_j \lambda_j}/(\lambda_j - \tau_i) \). It needs the distances \( \lambda_j - \tau_i \), which a difference of
!> the times does not give where an arm is weak.
module adfric_solid_retardation
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_solid_prony, only: prony_t
   use adfric_numerics_exact_pairs, only: get_product
   use adfric_numerics_secular, only: get_root_distances
   implicit none (type, external)
   private
   public :: retardation_t, new_retardation

   !> A retardation spectrum.
   type :: retardation_t
      !> Retardation times lambda_j [s], rising; shape `(n_arms)`.
      real(dp), allocatable :: times(:)
      !> Compliances c_j of the Kelvin elements [1/unit of the moduli], > 0; shape `(n_arms)`.
      real(dp), allocatable :: compliances(:)
      !> Distances lambda_j - tau_i [s], each to all its digits; shape `(n_arms, n_arms)`, i first.
      real(dp), allocatable :: distances(:, :)
   end type retardation_t

contains

   !> The retardation spectrum of a solid.
   pure subroutine new_retardation(self, prony)
      !> The retardation spectrum; it has as many times as the solid has arms.
      type(retardation_t), intent(out) :: self
      !> The relaxation spectrum of the solid, `relaxed` > 0.
      type(prony_t), intent(in) :: prony
      real(dp), dimension(size(prony%times)) :: tau, b, b_rest
      real(dp) :: relaxed
      integer :: j, n, time_unit, modulus_unit

      if (has_asserts) call assert(prony%relaxed > 0, 'new_retardation: a solid')
      n = size(prony%times)
      allocate (self%times(n), self%compliances(n), self%distances(n, n))
      if (n == 0) return
      ! units that are powers of 2 cost no digit
      time_unit = exponent(prony%times(n))
      modulus_unit = exponent(prony%relaxed)
      tau = scale(prony%times, -time_unit)
      relaxed = scale(prony%relaxed, -modulus_unit)
      call get_product(scale(prony%moduli, -modulus_unit), tau, b, b_rest)
      do j = 1, n
         call get_root_distances(b, b_rest, tau, relaxed, j, self%distances(:, j))
         self%times(j) = tau(j) + self%distances(j, j)
         self%compliances(j) = 1/(self%times(j)*sum(b/self%distances(:, j)**2))
      end do
      self%times = scale(self%times, time_unit)
      self%distances = scale(self%distances, time_unit)
      self%compliances = scale(self%compliances, -modulus_unit)
   end subroutine new_retardation

end module adfric_solid_retardation

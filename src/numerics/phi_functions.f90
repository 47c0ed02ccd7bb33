! SPDX-License-Identifier: GPL-3.0-or-later
!> Functions of exponential integrators: what a relaxation over one step does to a polynomial.
!>
!> \( \varphi_k(z) = \int_0^1 e^{-z (1 - s)} s^{k-1}/(k-1)!\, ds \) and the moments \( \chi_j(z) = \int_0^1 e^{-z s} s^j ds \), z >= 0.
!> Both obey recurrences that are stable upwards for k <= z and downwards above, so each is computed from that end.
!> Hochbruck, Ostermann, Acta Numerica 19 (2010), 209.
module adfric_numerics_phi_functions
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   implicit none (type, external)
   private
   public :: get_phi_functions, get_exponential_moments

   !> Terms of the series of the last function; enough as long as z is not above the number of functions, of which there are at most 20.
   integer, parameter :: n_terms = 60

contains

   !> The functions phi_1, phi_2, ... of one z, to a relative error of a few round-offs.
   pure subroutine get_phi_functions(z, phi)
      !> Step over relaxation time [-], >= 0; it may be as large as a number can be.
      real(dp), intent(in) :: z
      !> Receives phi_1 to phi_n, all > 0; shape `(n)`, n >= 1.
      real(dp), intent(out) :: phi(:)
      real(dp) :: term, factorial
      integer :: k, n, n_upwards

      n = size(phi)
      if (has_asserts) call assert(z >= 0 .and. n >= 1 .and. n <= 20, 'get_phi_functions: z >= 0, 1 to 20 functions')
      n_upwards = int(min(z, real(n, dp)))
      factorial = 1
      if (n_upwards > 0) phi(1) = (1 - exp(-min(z, longest(z))))/z
      do k = 2, n_upwards
         ! phi_k = (1/(k - 1)! - phi_(k-1))/z
         factorial = factorial*(k - 1)
         phi(k) = (1/factorial - phi(k - 1))/z
      end do
      if (n_upwards == n) return
      ! phi_n = sum over m of (-z)^m/(n + m)!
      factorial = 1
      do k = 2, n
         factorial = factorial*k
      end do
      term = 1/factorial
      phi(n) = term
      do k = 1, n_terms
         term = -term*z/(n + k)
         phi(n) = phi(n) + term
      end do
      do k = n - 1, n_upwards + 1, -1
         factorial = factorial/(k + 1)
         phi(k) = 1/factorial - z*phi(k + 1)
      end do
   end subroutine get_phi_functions

   !> The moments chi_0, chi_1, ... of the decay over a step.
   pure subroutine get_exponential_moments(z, chi)
      !> Step over relaxation time [-], >= 0; it may be as large as a number can be.
      real(dp), intent(in) :: z
      !> Receives chi_0 to chi_n, all > 0; shape `(0:n)`.
      real(dp), intent(out) :: chi(0:)
      real(dp) :: decay, term
      integer :: j, n, n_upwards

      n = ubound(chi, 1)
      if (has_asserts) call assert(z >= 0 .and. n < 20, 'get_exponential_moments: z >= 0, at most 20 moments')
      decay = exp(-min(z, longest(z)))
      ! the moments 0 to n_upwards - 1
      n_upwards = int(min(z, real(n + 1, dp)))
      if (n_upwards > 0) chi(0) = (1 - decay)/z
      do j = 1, n_upwards - 1
         chi(j) = (j*chi(j - 1) - decay)/z
      end do
      if (n_upwards > n) return
      ! chi_n = exp(-z) sum over m of z^m/((n + 1) ... (n + 1 + m))
      term = decay/(n + 1)
      chi(n) = term
      do j = 1, n_terms
         term = term*z/(n + 1 + j)
         chi(n) = chi(n) + term
      end do
      do j = n, n_upwards + 1, -1
         chi(j - 1) = (z*chi(j) + decay)/j
      end do
   end subroutine get_exponential_moments

   !> The largest exponent whose decay is a normal number.
   pure real(dp) function longest(z)
      !> A number of the kind that is asked for.
      real(dp), intent(in) :: z

      longest = -log(tiny(z))
   end function longest

end module adfric_numerics_phi_functions

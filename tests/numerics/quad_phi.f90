! SPDX-License-Identifier: GPL-3.0-or-later
!> Functions of exponential integrators in quadruple precision, by sums without cancellation.
module quad_phi
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: qp, quad_phi_function, quad_moment

   integer, parameter :: qp = selected_real_kind(33)
   !> Above this z the recurrences lose next to nothing of the 33 digits.
   real(qp), parameter :: large = 60
   integer, parameter :: n_terms = 600
   real(qp), parameter :: small_term = 1.0e-36_qp

contains

   !> phi_k(z) = integral of exp(-z (1 - s)) s^(k-1)/(k-1)! over 0 .. 1.
   pure real(qp) function quad_phi_function(k, z) result(phi)
      integer, intent(in) :: k
      real(qp), intent(in) :: z
      real(qp) :: factorial
      integer :: j

      factorial = 1
      if (z > large) then
         phi = (1 - exp(-min(z, 1000*large)))/z
         do j = 1, k - 1
            factorial = factorial*j
            phi = (1/factorial - phi)/z
         end do
         return
      end if
      do j = 1, k - 1
         factorial = factorial*j
      end do
      phi = growing_moment(k - 1, z)*exp(-z)/factorial
   end function quad_phi_function

   !> The integral of s^j exp(z s) over 0 .. 1, a sum of positive terms.
   pure real(qp) function growing_moment(j, z) result(total)
      integer, intent(in) :: j
      real(qp), intent(in) :: z
      real(qp) :: term
      integer :: m

      term = 1
      total = 0
      do m = 0, n_terms
         total = total + term/(j + 1 + m)
         term = term*z/(m + 1)
         if (term < small_term*total .and. m > z) exit
      end do
   end function growing_moment

   !> chi_j(z) = integral of s^j exp(-z s) over 0 .. 1.
   pure real(qp) function quad_moment(j, z) result(chi)
      integer, intent(in) :: j
      real(qp), intent(in) :: z
      real(qp) :: term, decay
      integer :: m

      decay = exp(-min(z, 1000*large))
      if (z > large) then
         chi = (1 - decay)/z
         do m = 1, j
            chi = (m*chi - decay)/z
         end do
         return
      end if
      term = decay
      chi = 0
      do m = 1, n_terms
         term = term/(j + m)
         chi = chi + term
         term = term*z
         if (term < small_term*chi .and. m > z) exit
      end do
   end function quad_moment

end module quad_phi

! SPDX-License-Identifier: GPL-3.0-or-later
!> Effective works of adhesion of the two edges of a contact that slides steadily over a viscoelastic half-plane, in the limit of a
!> Dugdale zone that is short beside the contact.
!>
!> Reduced: lengths in rho0 = pi E0 d0/(4 p0), the zone of the relaxed solid. J is the creep function, J = 1 - sum c_j exp(-x/b_j)
!> with sum c_j = 1 - E0/Einf, and a zone of length L opens by the range:
!>
!>     opening edge   w_o/w = L,                  1 = (1/(2 L0)) integral_0^L ln((sqrt L + sqrt y)/(sqrt L - sqrt y)) J(L - y) dy
!>     closing edge   w_c/w = Q(L)^2 pi/4,        1 = sqrt(L) Q(L) - (1/2) integral_0^L Q(t)/sqrt(t) dt
!>                    Q = 2 sqrt(t/pi) - (2/sqrt pi) sum c_j sqrt(b_j) Daw(sqrt(t/b_j))
module adfric_plane_crack_works
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_plane_adhesive_sliding_nodes, only: nodes_t, get_nodes
   implicit none (type, external)
   private
   public :: crack_works_t, get_crack_works

   !> Works and zones of both edges.
   type :: crack_works_t
      !> Works over the work of adhesion [-].
      real(dp) :: opening = 1, closing = 1
      !> Lengths of the zones [rho0].
      real(dp) :: opening_zone = 1, closing_zone = 1
   end type crack_works_t

contains

   !> Works of both edges.
   pure subroutine get_crack_works(compliances, retardation, works, is_converged)
      !> Compliances c_j of the Kelvin elements over 1/E0, > 0, with a sum below 1; shape `(n)`.
      real(dp), intent(in) :: compliances(:)
      !> Retardation lengths b_j [rho0], > 0, in rising order; shape `(n)`.
      real(dp), intent(in) :: retardation(:)
      type(crack_works_t), intent(out) :: works
      logical, intent(out) :: is_converged
      logical :: has_closing

      call find_zone(.true., compliances, retardation, works%opening_zone, is_converged)
      works%opening = works%opening_zone
      call find_zone(.false., compliances, retardation, works%closing_zone, has_closing)
      is_converged = is_converged .and. has_closing
      works%closing = pi*closing_sum(compliances, retardation, works%closing_zone)**2/4
   end subroutine get_crack_works

   !> The length at which a zone opens by the range; between less than 1 and Einf/E0.
   pure subroutine find_zone(is_opening, compliances, retardation, zone, is_converged)
      logical, intent(in) :: is_opening
      real(dp), intent(in) :: compliances(:), retardation(:)
      real(dp), intent(out) :: zone
      logical, intent(out) :: is_converged
      real(dp) :: low, high, f_low, f_high, f
      integer :: i, side

      low = log(0.25_dp)
      high = log(2/(1 - sum(compliances)))
      f_low = log(opening_of(is_opening, compliances, retardation, exp(low)))
      f_high = log(opening_of(is_opening, compliances, retardation, exp(high)))
      zone = 1
      is_converged = f_low < 0 .and. f_high > 0
      if (.not. is_converged) return
      side = 0
      do i = 1, 100
         zone = low - f_low*(high - low)/(f_high - f_low)
         f = log(opening_of(is_opening, compliances, retardation, exp(zone)))
         is_converged = abs(f) < 1.0e-14_dp .or. high - low < 1.0e-14_dp
         if (is_converged) exit
         if (f < 0) then
            low = zone
            f_low = f
            if (side == 1) f_high = f_high/2
            side = 1
         else
            high = zone
            f_high = f
            if (side == 2) f_low = f_low/2
            side = 2
         end if
         is_converged = abs(f) < 1.0e-12_dp
      end do
      zone = exp(zone)
   end subroutine find_zone

   !> Opening of a zone over the range.
   pure real(dp) function opening_of(is_opening, compliances, retardation, length) result(opening)
      logical, intent(in) :: is_opening
      real(dp), intent(in) :: compliances(:), retardation(:)
      !> Length of the zone [rho0].
      real(dp), intent(in) :: length
      type(nodes_t) :: nodes
      real(dp) :: roots
      integer :: i

      call get_nodes(length, spread(min(length, minval(retardation)), 1, 2), 38.0_dp, 1.0_dp, nodes)
      opening = 0
      if (is_opening) then
         do i = 1, size(nodes%weights)
            roots = sqrt(length) + sqrt(nodes%left(i))
            opening = opening + nodes%weights(i)*log(roots**2/nodes%right(i))/2 &
               & *(1 - sum(compliances*exp(-nodes%right(i)/retardation)))
         end do
      else
         opening = sqrt(length)*closing_sum(compliances, retardation, length)
         do i = 1, size(nodes%weights)
            opening = opening - nodes%weights(i)*closing_sum(compliances, retardation, nodes%left(i))/(2*sqrt(nodes%left(i)))
         end do
         opening = opening*sqrt(pi)
      end if
   end function opening_of

   !> Q.
   pure real(dp) function closing_sum(compliances, retardation, t) result(q)
      real(dp), intent(in) :: compliances(:), retardation(:)
      real(dp), intent(in) :: t
      integer :: j

      q = (1 - sum(compliances))*sqrt(t)
      do j = 1, size(compliances)
         q = q + compliances(j)*(sqrt(t) - sqrt(retardation(j))*dawson(sqrt(t/retardation(j))))
      end do
      q = q*2/sqrt(pi)
   end function closing_sum

   !> Dawson's function exp(-x^2) integral_0^x exp(s^2) ds, by Rybicki's sum (Comput. Phys. 3, 85, 1989), x >= 0.
   elemental real(dp) function dawson(x)
      real(dp), intent(in) :: x
      real(dp), parameter :: h = 0.2_dp
      real(dp) :: rest, term
      integer :: n, k

      dawson = 0
      if (x < 0.3_dp) then
         term = x
         do k = 0, 20
            dawson = dawson + term
            term = -term*2*x**2/(2*k + 3)
         end do
      else if (x > 50) then
         term = 1/(2*x)
         do k = 1, 8
            dawson = dawson + term
            term = term*(2*k - 1)/(2*x**2)
         end do
      else
         n = 2*nint(x/(2*h))
         rest = x - n*h
         do k = -61, 61, 2
            dawson = dawson + exp(-(rest - k*h)**2)/(n + k)
         end do
         dawson = dawson/sqrt(pi)
      end if
   end function dawson

end module adfric_plane_crack_works

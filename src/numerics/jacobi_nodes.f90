! SPDX-License-Identifier: GPL-3.0-or-later
!> Jacobi's elliptic functions sn, cn, dn at equally spaced arguments between 0 and the quarter period K.
!>
!> No argument is given, nor K: the values at K are (1, 0, k'), those at half of an argument follow from those at the argument, and
!> those between two neighbours from the formulas of addition. Every sum that is formed has terms of one sign, and so each value is
!> right to round-off, for a modulus k next to 1 too, where cn and dn are tiny.
module adfric_numerics_jacobi_nodes
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: halve_argument, put_midpoints

contains

   !> Go from an argument v to v/2, 0 < v <= K.
   pure subroutine halve_argument(values)
      !> In: sn, cn, dn of v. Out: those of v/2.
      real(dp), intent(inout) :: values(3)
      real(dp) :: sn, cn, dn

      sn = values(1)
      cn = values(2)
      dn = values(3)
      values(1) = sn/sqrt((1 + cn)*(1 + dn))
      values(2) = sqrt((cn + dn)/(1 + dn))
      values(3) = sqrt((cn + dn)/(1 + cn))
   end subroutine halve_argument

   !> Values halfway between neighbours: sn from the one below, cn and dn from the one above, where nothing cancels.
   pure subroutine put_midpoints(square, step, ends, midpoints)
      !> Square of the modulus k, 0 to 1.
      real(dp), intent(in) :: square
      !> sn, cn, dn of half the distance of the neighbours.
      real(dp), intent(in) :: step(3)
      !> sn, cn, dn at multiples of the distance, from 0 on; shape `(3, 0:n)`.
      real(dp), intent(in) :: ends(:, 0:)
      !> Receives the values between them; shape `(3, n)`.
      real(dp), intent(out) :: midpoints(:, :)
      real(dp) :: below, above
      integer :: i

      do i = 1, ubound(ends, 2)
         ! 1 - k^2 sn^2(u) sn^2(v) = cn^2(u) + sn^2(u) dn^2(v)
         below = ends(2, i - 1)**2 + (ends(1, i - 1)*step(3))**2
         above = ends(2, i)**2 + (ends(1, i)*step(3))**2
         midpoints(1, i) = (ends(1, i - 1)*step(2)*step(3) + step(1)*ends(2, i - 1)*ends(3, i - 1))/below
         midpoints(2, i) = (ends(2, i)*step(2) + ends(1, i)*step(1)*ends(3, i)*step(3))/above
         midpoints(3, i) = (ends(3, i)*step(3) + square*ends(1, i)*step(1)*ends(2, i)*step(2))/above
      end do
   end subroutine put_midpoints

end module adfric_numerics_jacobi_nodes

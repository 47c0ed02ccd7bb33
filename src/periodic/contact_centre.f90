! SPDX-License-Identifier: GPL-3.0-or-later
!> Where the contact of a wave stands: how far its middle lies from the crest at 0.
!>
!> The middle is that of the arc in which contact stands on the circle of one period: the phase of the first harmonic of the
!> contact. Of one contact between two edges it is half way between them; of a surface it is taken over all its rows. An edge
!> lies where the square of the pressure, which ends like the distance to the edge, falls to 0 on a straight line through two cells.
module adfric_periodic_contact_centre
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_base_not_a_number, only: not_a_number
   implicit none (type, external)
   private
   public :: contact_centre

   !> A harmonic that is less than this share of the contact has no phase but that of round-off.
   real(dp), parameter :: least_share = 1.0e-10_dp

contains

   !> Middle of the contact.
   pure real(dp) function contact_centre(pressure, along) result(centre)
      !> Pressure in the middles of the cells of one period, that begins at a crest; 0 where there is no contact; shape `(nx, ny)`.
      real(dp), intent(in) :: pressure(:, :)
      !> 1: along x, 2: along y.
      integer, intent(in) :: along
      complex(dp) :: harmonic
      integer :: j

      harmonic = 0
      if (along == 1) then
         do j = 1, size(pressure, 2)
            call add_row(pressure(:, j), harmonic)
         end do
      else
         do j = 1, size(pressure, 1)
            call add_row(pressure(j, :), harmonic)
         end do
      end if
      centre = not_a_number()
      if (abs(harmonic) > least_share*size(pressure, 3 - along)) centre = atan2(aimag(harmonic), real(harmonic, dp))/two_pi
   end function contact_centre

   !> Add the contact of a row: the integral of exp(i phase) between its edges.
   pure subroutine add_row(pressure, harmonic)
      !> Pressure in the cells of the row, >= 0.
      real(dp), intent(in) :: pressure(:)
      !> The harmonic, to which that of the row is added.
      complex(dp), intent(inout) :: harmonic
      integer :: i, n

      n = size(pressure)
      if (all(pressure > 0)) return
      do i = 1, n
         if (.not. pressure(i) > 0) cycle
         associate (before => pressure(modulo(i - 2, n) + 1), after => pressure(modulo(i, n) + 1))
            ! an edge at z adds -i exp(i z) where contact ends, and takes it away where it begins
            if (.not. after > 0) harmonic = harmonic - (0.0_dp, 1.0_dp)*turn(i - 0.5_dp + distance_to_edge(pressure(i), before))
            if (.not. before > 0) harmonic = harmonic + (0.0_dp, 1.0_dp)*turn(i - 0.5_dp - distance_to_edge(pressure(i), after))
         end associate
      end do

   contains

      !> exp(i phase) of a position.
      pure complex(dp) function turn(position)
         !> The position [cells].
         real(dp), intent(in) :: position

         turn = cmplx(cos(two_pi*position/n), sin(two_pi*position/n), dp)
      end function turn

   end subroutine add_row

   !> How far an edge lies beyond the middle of the last cell in contact [cells], 0 to 1.
   pure real(dp) function distance_to_edge(last, inner) result(distance)
      !> Pressure in that cell, > 0, and in the next one inwards.
      real(dp), intent(in) :: last, inner

      distance = 0.5_dp
      if (.not. inner > 0) return
      distance = 1
      if (inner**2 > 2*last**2) distance = last**2/(inner**2 - last**2)
   end function distance_to_edge

end module adfric_periodic_contact_centre

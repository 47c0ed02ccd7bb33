! SPDX-License-Identifier: GPL-3.0-or-later
!> Area of contact from where its edge cuts the rows and columns of cells.
!>
!> A count of cells varies in steps, which no fit can follow. Here the edge lies between two neighbours, of which one is in contact
!> with the pressure p and the other has the gap g. Near an edge without a singularity, s from it,
!>
!>     p = C sqrt(s)   inside,   g = (4 C/3 E*) s^(3/2)   outside
!>
!> (line contact of Hertz, and any other to leading order). The two distances add up to the cell: with r the part of it that is in
!> contact,
!>
!>     r/(1 - r)^3 = K,   K = (16/9) (p cell/E* g)^2 c,
!>
!> which has one root between 0 and 1; y = 1 - r solves K y^3 + y = 1. Where a row crosses the edge at an angle t from its normal,
!> c = cos^2 t. Of an edge without a preferred direction rows cross parts in proportion to cos t, so that c is 2/3 on average, which
!> is taken over x and y; along a line c = 1. With adhesion p counts from the tension of the zone.
!> A row has the sum of such parts and of whole cells for its chord. The mean over all rows, and over all columns, is the fraction
!> in contact (Cavalieri). Each is continuous in p and g: where a cell comes into contact its p and g are 0, and the edge passes
!> through it.
module adfric_periodic_chords
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: chord_fraction, level_fraction, part_in_contact, beside_body

   !> Gap of cells that are none of the body.
   real(dp), parameter :: beside_body = huge(1.0_dp)

contains

   !> Fraction of the surface in contact.
   pure real(dp) function chord_fraction(pressure, gap, cell, is_quarter, is_periodic) result(fraction)
      !> Pressure in the middles of the cells [E*]; shape `(nx, ny)`.
      real(dp), intent(in) :: pressure(:, :)
      !> Gap there, 0 in contact, and `beside_body` where there is no body; shape of `pressure`.
      real(dp), intent(in) :: gap(:, :)
      !> Sizes of a cell along x and y, in the unit of the gap.
      real(dp), intent(in) :: cell(2)
      !> Is the map a quarter between planes of symmetry (else it goes on periodically)?
      logical, intent(in) :: is_quarter
      !> Does a map that is no quarter go on periodically along x, along y? Else the body ends there. Not present: it does along
      !> both.
      logical, intent(in), optional :: is_periodic(2)
      real(dp) :: tension, along(2), rate(2)
      integer :: i, j
      logical :: has_ends(2)

      tension = max(-minval(pressure), 0.0_dp)
      has_ends = is_quarter
      if (present(is_periodic)) has_ends = has_ends .or. .not. is_periodic
      along = 0
      ! a part in contact has cell^2 c for its factor
      rate = cell*sqrt(merge(2/3.0_dp, 1.0_dp, size(gap, 2) > 1))
      do j = 1, size(gap, 2)
         along(1) = along(1) + chord_of(pressure(:, j) + tension, gap(:, j), rate(1), has_ends(1))
      end do
      fraction = along(1)/size(gap)
      if (size(gap, 2) == 1) return
      do i = 1, size(gap, 1)
         along(2) = along(2) + chord_of(pressure(i, :) + tension, gap(i, :), rate(2), has_ends(2))
      end do
      fraction = (along(1) + along(2))/(2*size(gap))
   end function chord_fraction

   !> Fraction of the surface where a field is below 0, by straight lines between the cells along both directions.
   pure real(dp) function level_fraction(field, is_quarter) result(fraction)
      !> The field in the middles of the cells; shape `(nx, ny)`.
      real(dp), intent(in) :: field(:, :)
      !> Is the map a quarter between planes of symmetry (else it goes on periodically)?
      logical, intent(in) :: is_quarter
      real(dp) :: along(2)
      integer :: i, j

      along = 0
      do j = 1, size(field, 2)
         along(1) = along(1) + part_below(field(:, j), is_quarter)
      end do
      fraction = along(1)/size(field)
      if (size(field, 2) == 1) return
      do i = 1, size(field, 1)
         along(2) = along(2) + part_below(field(i, :), is_quarter)
      end do
      fraction = (along(1) + along(2))/(2*size(field))
   end function level_fraction

   !> Part of a row where a field is below 0, in cells.
   pure real(dp) function part_below(field, is_quarter) result(part)
      real(dp), intent(in) :: field(:)
      !> Does the row end at planes of symmetry?
      logical, intent(in) :: is_quarter
      integer :: i, n

      n = size(field)
      part = 0
      do i = 1, n - 1
         part = part + between(field(i), field(i + 1))
      end do
      if (is_quarter) then
         ! half a cell at either end
         part = part + (between(field(1), field(1)) + between(field(n), field(n)))/2
      else
         part = part + between(field(n), field(1))
      end if

   contains

      !> Part between two neighbours.
      pure real(dp) function between(a, b)
         real(dp), intent(in) :: a, b

         if (a < 0 .and. b < 0) then
            between = 1
         else if (a < 0) then
            between = -a/(b - a)
         else if (b < 0) then
            between = -b/(a - b)
         else
            between = 0
         end if
      end function between

   end function part_below

   !> Chord of a row, in cells.
   pure real(dp) function chord_of(pressure, gap, cell, has_ends) result(chord)
      !> Pressure above the tension of a zone of adhesion [E*], and gap.
      real(dp), intent(in) :: pressure(:), gap(:)
      !> Size of a cell times cos t, in the unit of the gap.
      real(dp), intent(in) :: cell
      !> Does the row end, at planes of symmetry or at the border of the body (else it goes on periodically)?
      logical, intent(in) :: has_ends
      integer :: i, n

      n = size(gap)
      chord = 0
      do i = 1, n - 1
         chord = chord + part_of(i, i + 1)
      end do
      if (has_ends) then
         ! half a cell at either end
         if (.not. gap(1) > 0) chord = chord + 0.5_dp
         if (.not. gap(n) > 0) chord = chord + 0.5_dp
      else
         chord = chord + part_of(n, 1)
      end if

   contains

      !> Part in contact between two neighbours.
      pure real(dp) function part_of(i, k)
         !> Positions of the neighbours.
         integer, intent(in) :: i, k

         if (gap(i) > 0 .and. gap(k) > 0) then
            part_of = 0
         else if (max(gap(i), gap(k)) >= beside_body) then
            ! the body ends with its cell
            part_of = 0.5_dp
         else if (gap(i) > 0) then
            part_of = part_in_contact(pressure(k), gap(i), cell)
         else if (gap(k) > 0) then
            part_of = part_in_contact(pressure(i), gap(k), cell)
         else
            part_of = 1
         end if
      end function part_of

   end function chord_of

   !> Part of a cell that is in contact, between the middle of a cell in contact and that of one that is not.
   elemental real(dp) function part_in_contact(pressure, gap, cell) result(part)
      !> Pressure of the one in contact, above the tension of a zone of adhesion [E*].
      real(dp), intent(in) :: pressure
      !> Gap of the other one, > 0.
      real(dp), intent(in) :: gap
      !> Size of the cell times cos t, in the unit of the gap.
      real(dp), intent(in) :: cell
      real(dp) :: root, y

      ! the root of 3 K; y = 2 sinh(asinh(3 root/2)/3)/root
      root = min(4*max(pressure, 0.0_dp)*cell/(sqrt(3.0_dp)*gap), 1.0e100_dp)
      if (root < 1.0e-4_dp) then
         part = root**2/3
         return
      end if
      y = 2*sinh(asinh(1.5_dp*root)/3)/root
      part = 1 - y
   end function part_in_contact

end module adfric_periodic_chords

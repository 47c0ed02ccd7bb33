! SPDX-License-Identifier: GPL-3.0-or-later
!> Integrals over the part of a triangle where two linear functions are not above 0: what had closed at a turn, and what has not opened
!> since (`adfric_periodic_cohesion`). Points are given by the hat functions of the corners; areas are in units of the triangle's.
module adfric_periodic_cut_triangle
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: cut_shares, cut_depth, cut_line

   !> A convex part of a triangle.
   type :: polygon_t
      !> Number of its corners, none or three at least.
      integer :: n = 0
      !> Hat functions of the triangle's corners at those of the polygon, round it.
      real(dp) :: corner(3, 6) = 0
   end type polygon_t

   !> Corners of the whole triangle.
   real(dp), parameter :: whole(3, 3) = reshape([1.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp], [3, 3])

contains

   !> Integrals of the hat functions where both functions are not above 0; 1/3 each where that is the whole triangle.
   pure function cut_shares(excess, beyond) result(shares)
      !> The two functions at the corners of the triangle.
      real(dp), intent(in) :: excess(3), beyond(3)
      real(dp) :: shares(3)
      type(polygon_t) :: part
      integer :: k

      part = cut(cut(triangle(), beyond), excess)
      shares = 0
      do k = 2, part%n - 1
         shares = shares + fan_area(part, k)*(part%corner(:, 1) + part%corner(:, k) + part%corner(:, k + 1))/3
      end do
   end function cut_shares

   !> Integral of how far the first function is below 0, where both are not above it.
   pure real(dp) function cut_depth(excess, beyond) result(depth)
      !> The two functions at the corners of the triangle.
      real(dp), intent(in) :: excess(3), beyond(3)

      depth = -dot_product(excess, cut_shares(excess, beyond))
   end function cut_depth

   !> The part of a line through the triangle where a function is not above 0.
   pure subroutine cut_line(beyond, first, last, part)
      !> The function at the corners of the triangle.
      real(dp), intent(in) :: beyond(3)
      !> Hat functions at the ends of the line; receive those at the ends of the part.
      real(dp), intent(inout) :: first(3), last(3)
      !> Receives the length of the part over that of the line.
      real(dp), intent(out) :: part
      real(dp) :: ends(2), crossing

      ends = [dot_product(beyond, first), dot_product(beyond, last)]
      part = merge(0, 1, all(ends > 0))
      if (all(ends > 0) .or. all(ends <= 0)) return
      crossing = ends(1)/(ends(1) - ends(2))
      if (ends(1) > 0) then
         first = first + crossing*(last - first)
         part = 1 - crossing
      else
         last = first + crossing*(last - first)
         part = crossing
      end if
   end subroutine cut_line

   !> The triangle itself.
   pure type(polygon_t) function triangle() result(part)

      part%n = 3
      part%corner(:, :3) = whole
   end function triangle

   !> The part of a polygon where a function is not above 0.
   pure type(polygon_t) function cut(polygon, values) result(part)
      type(polygon_t), intent(in) :: polygon
      !> The function at the corners of the triangle.
      real(dp), intent(in) :: values(3)
      real(dp) :: here, there
      integer :: k, next

      do k = 1, polygon%n
         next = merge(1, k + 1, k == polygon%n)
         here = dot_product(values, polygon%corner(:, k))
         there = dot_product(values, polygon%corner(:, next))
         if (here <= 0) call add(polygon%corner(:, k))
         if ((here <= 0) .neqv. (there <= 0)) &
            & call add(polygon%corner(:, k) + here/(here - there)*(polygon%corner(:, next) - polygon%corner(:, k)))
      end do

   contains

      !> Add a corner.
      pure subroutine add(corner)
         !> Hat functions there.
         real(dp), intent(in) :: corner(3)

         if (part%n == size(part%corner, 2)) return
         part%n = part%n + 1
         part%corner(:, part%n) = corner
      end subroutine add

   end function cut

   !> Area of the triangle of a polygon's first corner, another one and the next.
   pure real(dp) function fan_area(polygon, k) result(area)
      type(polygon_t), intent(in) :: polygon
      !> The other corner.
      integer, intent(in) :: k

      ! hat functions add up to 1, so that two of them are coordinates
      associate (b => polygon%corner(:, k) - polygon%corner(:, 1), c => polygon%corner(:, k + 1) - polygon%corner(:, 1))
         area = abs(b(2)*c(3) - b(3)*c(2))
      end associate
   end function fan_area

end module adfric_periodic_cut_triangle

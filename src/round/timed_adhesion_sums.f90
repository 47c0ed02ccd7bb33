! SPDX-License-Identifier: GPL-3.0-or-later
!> What a memory that is straight between nodes adds to the gap at the edge of a zone of adhesion: the integral of its slope times
!> arccos(x/c), and the derivative of that by c. Cells beside c are summed one by one, the others as a series.
!>
!> A step asks for this sum at several c that are close together. The series has only moments of the memory m over far cells,
!>
!>     M_j(c) = sum m(x) d^j/sqrt(c^2 - x^2),    d = cell^2/(c^2 - x^2),
!>
!> and where c moves, so that c^2 grows by D cell^2, d becomes d/(1 + D d): M_j is a sum over i of (-j - 1/2 over i) D^i M_(j + i).
!> Far cells are 12 cells from c, so D d is a 24th where c moves by half a cell: moments up to the 8th leave 1e-11, and one sum over
!> the nodes does for all c of a step.
module adfric_round_timed_adhesion_sums
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: zone_sum_t, far_cells_t, move_sum, expand_far_cells, is_near

   ! cells beside c that are summed one by one, and the least number of others
   integer, parameter :: nearest = 12, fewest = 8
   !> Last moment of the memory over far cells, and the last one that the series has.
   integer, parameter :: last_moment = 8, last_power = 6

   !> The integral of the memory over the zone, node by node.
   type :: zone_sum_t
      !> Nodes above a and below c.
      integer :: low = 0, high = 0
      !> The integral between them, and the one of the angle up to the node above a.
      real(dp) :: total = 0, angle_sum = 0
      !> The derivative of the integral by c, times c, and sqrt(c^2 - x^2) at the node above a.
      real(dp) :: turn = 0, side = 0
   end type zone_sum_t

   !> Far cells of a step.
   type :: far_cells_t
      !> Their nodes: none where the last one is not above the first.
      integer :: low = 0, top = -1
      !> The radius c of the moments, and their values.
      real(dp), private :: c = 0, moments(0:last_moment) = 0
   end type far_cells_t

contains

   !> Bring the sum over whole cells from its lowest node to another one.
   pure subroutine move_sum(memory, cell, far, c, low, total)
      !> The memory at the nodes, and their distance; shape `(0:)`.
      real(dp), intent(in) :: memory(0:), cell
      !> Far cells of the step.
      type(far_cells_t), intent(in) :: far
      !> The radius c of adhesion.
      real(dp), intent(in) :: c
      !> The node above a.
      integer, intent(in) :: low
      !> The sum.
      type(zone_sum_t), intent(inout) :: total
      type(zone_sum_t) :: next
      real(dp) :: sums, turns
      integer :: k

      if (total%low - low > nearest + fewest .and. total%low > total%high) then
         if (is_near(far, cell, c) .and. low < far%top - fewest) then
            do k = total%low - 1, far%top, -1
               call add_cell(memory, cell, c, k, total)
            end do
            call get_far_sums(far, cell, c, sums, turns)
            call add_far_cells(memory, cell, c, far%low, sums, turns, total)
         else
            do k = total%low - 1, total%high - nearest, -1
               call add_cell(memory, cell, c, k, total)
            end do
            call sum_far_cells(memory, cell, c, low, total%low, sums, turns)
            call add_far_cells(memory, cell, c, low, sums, turns, total)
         end if
      end if
      do k = total%low - 1, low, -1
         call add_cell(memory, cell, c, k, total)
      end do
      do k = total%low, low - 1
         next = total
         next%low = k + 1
         call get_sides(min((k + 1)*cell, c), c, next%angle_sum, next%side)
         associate (slope => (memory(k + 1) - memory(k))/cell)
            next%total = total%total - slope*(next%angle_sum - total%angle_sum)
            next%turn = total%turn - slope*(total%side - next%side)
         end associate
         total = next
      end do
   end subroutine move_sum

   !> Add the cell below the lowest node.
   pure subroutine add_cell(memory, cell, c, node, total)
      !> The memory at the nodes, and their distance; shape `(0:)`.
      real(dp), intent(in) :: memory(0:), cell
      !> The radius c of adhesion.
      real(dp), intent(in) :: c
      !> The node below the lowest one.
      integer, intent(in) :: node
      type(zone_sum_t), intent(inout) :: total
      real(dp) :: angle_sum, side, slope

      call get_sides(node*cell, c, angle_sum, side)
      slope = (memory(node + 1) - memory(node))/cell
      total%total = total%total + slope*(total%angle_sum - angle_sum)
      total%turn = total%turn + slope*(side - total%side)
      total%angle_sum = angle_sum
      total%side = side
      total%low = node
   end subroutine add_cell

   !> Far cells of a step, and their moments.
   pure subroutine expand_far_cells(memory, cell, c, low, far)
      !> The memory at the nodes, and their distance; shape `(0:)`.
      real(dp), intent(in) :: memory(0:), cell
      !> A radius c of adhesion in the middle of those of the step.
      real(dp), intent(in) :: c
      !> The lowest node.
      integer, intent(in) :: low
      !> Receives the cells.
      type(far_cells_t), intent(out) :: far
      real(dp) :: x, q, d, part, m0, m1, m2, m3, m4, m5, m6, m7, m8
      integer :: k

      far%low = low
      far%top = int(c/cell) - nearest - 1
      far%c = c
      if (far%top - low < fewest) far%top = -1
      m0 = 0
      m1 = 0
      m2 = 0
      m3 = 0
      m4 = 0
      m5 = 0
      m6 = 0
      m7 = 0
      m8 = 0
      !$omp simd private(x, q, d, part) reduction(+:m0, m1, m2, m3, m4, m5, m6, m7, m8)
      do k = low + 1, far%top - 1
         x = k*cell
         q = 1/((c - x)*(c + x))
         d = cell*cell*q
         part = memory(k)*sqrt(q)
         m0 = m0 + part
         part = part*d
         m1 = m1 + part
         part = part*d
         m2 = m2 + part
         part = part*d
         m3 = m3 + part
         part = part*d
         m4 = m4 + part
         part = part*d
         m5 = m5 + part
         part = part*d
         m6 = m6 + part
         part = part*d
         m7 = m7 + part
         m8 = m8 + part*d
      end do
      far%moments = [m0, m1, m2, m3, m4, m5, m6, m7, m8]
   end subroutine expand_far_cells

   !> Do the moments hold at a radius?
   pure logical function is_near(far, cell, c)
      !> Far cells of a step.
      type(far_cells_t), intent(in) :: far
      !> Distance of the nodes, and a radius of adhesion.
      real(dp), intent(in) :: cell, c
      real(dp), parameter :: most = 0.6_dp

      is_near = far%top > far%low .and. abs(c - far%c) <= most*cell
   end function is_near

   !> The sums of `sum_far_cells` from moments.
   pure subroutine get_far_sums(far, cell, c, sums, turns)
      type(far_cells_t), intent(in) :: far
      real(dp), intent(in) :: cell, c
      !> Receive the sums.
      real(dp), intent(out) :: sums, turns
      integer :: i, j
      real(dp), parameter :: inverses(last_moment) = [(1.0_dp/i, i=1, last_moment)]
      real(dp) :: m(0:last_power), change, part, g

      change = (c - far%c)*(c + far%c)/cell**2
      do j = 0, last_power
         part = 1
         m(j) = far%moments(j)
         do i = 1, last_moment - j
            part = -part*change*(j + i - 0.5_dp)*inverses(i)
            m(j) = m(j) + part*far%moments(j + i)
         end do
      end do
      g = (c/cell)**2
      sums = m(0) - m(1)/6 + (15*g + 4)/60*m(2) - (28*g + 3)/84*m(3) + (7*g + 9)*g/24*m(4) - 27*g*g/32*m(5) &
         & + 33*g**3/64*m(6)
      turns = g*(m(1) - m(2) + 5*g/4*m(3))
   end subroutine get_far_sums

   !> The series over the nodes of far cells. By parts only second differences of the integral of arccos are needed, and
   !> these are derivatives of 1/sqrt(c^2 - x^2), in even powers of the cell. Twelve cells from c the first that is left out is
   !> 1e-11 of the whole.
   pure subroutine sum_far_cells(memory, cell, c, low, top, sums, turns)
      !> The memory at the nodes, and their distance; shape `(0:)`.
      real(dp), intent(in) :: memory(0:), cell
      !> The radius c of adhesion.
      real(dp), intent(in) :: c
      !> The lowest node, and the highest one.
      integer, intent(in) :: low, top
      !> Receive the sums of the integral, and of its derivative by c.
      real(dp), intent(out) :: sums, turns
      real(dp) :: x, q, d, moved, part
      integer :: k

      sums = 0
      turns = 0
      !$omp simd private(x, q, d, moved, part) reduction(+:sums, turns)
      do k = low + 1, top - 1
         x = k*cell
         q = 1/((c - x)*(c + x))
         ! the square of a cell over that of the distance from c, and that of c
         d = cell*cell*q
         moved = c*c*q
         part = memory(k)*sqrt(q)
         sums = sums + part*(1 + d*((3*moved - 2)/12 + d*(((105*moved - 120)*moved + 24)/360 &
            & + d*(((10395*moved - 17010)*moved + 7560)*moved - 720)/20160)))
         turns = turns + part*moved*(1 + d*(15*moved - 12)/12)
      end do
   end subroutine sum_far_cells

   !> Add cells that are far from c all at once.
   pure subroutine add_far_cells(memory, cell, c, low, sums, turns, total)
      !> The memory at the nodes, and their distance; shape `(0:)`.
      real(dp), intent(in) :: memory(0:), cell
      !> The radius c of adhesion.
      real(dp), intent(in) :: c
      !> The lowest node.
      integer, intent(in) :: low
      !> The sums of `sum_far_cells`.
      real(dp), intent(in) :: sums, turns
      !> The sum over whole cells; in: of those that are near c.
      type(zone_sum_t), intent(inout) :: total
      real(dp) :: top_angle, top_side, low_angle, low_side, angle_sum, side
      integer :: top

      top = total%low
      call get_sides((top - 1)*cell, c, top_angle, top_side)
      call get_sides((low + 1)*cell, c, low_angle, low_side)
      call get_sides(low*cell, c, angle_sum, side)
      total%total = total%total + cell*sums + (memory(top)*(total%angle_sum - top_angle) &
         & - memory(low)*(low_angle - angle_sum))/cell
      total%turn = total%turn - cell*turns + (memory(top)*(top_side - total%side) &
         & - memory(low)*(side - low_side))/cell
      total%angle_sum = angle_sum
      total%side = side
      total%low = low
   end subroutine add_far_cells

   !> The integral of arccos(x/c) from c to x, which is below 0, and sqrt(c^2 - x^2).
   pure subroutine get_sides(x, c, angle_sum, side)
      !> Radii: of a point, and where the angle is 0.
      real(dp), intent(in) :: x, c
      !> Receive both.
      real(dp), intent(out) :: angle_sum, side
      integer :: k
      integer, parameter :: n_terms = 12
      ! arccos(1 - e) is sqrt(2 e) times a sum of these e^k
      real(dp), parameter :: terms(0:n_terms) = [1.0_dp, 1/12.0_dp, 3/160.0_dp, 5/896.0_dp, 35/18432.0_dp, 63/90112.0_dp, &
         & 231/851968.0_dp, 143/1310720.0_dp, 6435/142606336.0_dp, 12155/637534208.0_dp, 46189/5637144576.0_dp, &
         & 88179/24696061952.0_dp, 676039/429496729600.0_dp], factors(0:n_terms) = [(terms(k)/(k + 1.5_dp), k=0, n_terms)]
      ! up to where all these terms are enough, and up to where the first ones are
      real(dp), parameter :: short = 0.12_dp, shortest = 0.03_dp
      integer, parameter :: n_first = 6
      real(dp) :: e, sums

      ! a node at c may lie above it by round-off
      side = sqrt(max((c - x)*(c + x), 0.0_dp))
      e = max(c - x, 0.0_dp)/c
      if (e < shortest) then
         sums = factors(n_first)
         do k = n_first - 1, 0, -1
            sums = sums*e + factors(k)
         end do
         angle_sum = -c*e*sqrt(2*e)*sums
      else if (e < short) then
         sums = factors(n_terms)
         do k = n_terms - 1, 0, -1
            sums = sums*e + factors(k)
         end do
         angle_sum = -c*e*sqrt(2*e)*sums
      else
         angle_sum = x*atan2(side, x) - side
      end if
   end subroutine get_sides

end module adfric_round_timed_adhesion_sums

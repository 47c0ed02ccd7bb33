! SPDX-License-Identifier: GPL-3.0-or-later
!> What states of `attracted_state` ask of a law, and its sums over nodes: between them s and g - F are linear in t^2, so the integral
!> F is a closed form, and that of the gap has a smooth integrand in the angle of x/r.
module adfric_round_attracted_sums
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_interface_attraction, only: attraction_t
   use adfric_round_shape, only: shape_t, spot_t
   implicit none (type, external)
   private
   public :: get_influence, get_sum_weights, get_tensions

contains

   !> Tensions of a law and their slopes. At a wall gaps below 0, which Newton's method may try, have the tension of contact.
   pure subroutine get_tensions(law, gap, tension, slopes)
      !> The law.
      type(attraction_t), intent(in) :: law
      !> Gaps of the nodes; shape `(0:n)`.
      real(dp), intent(in) :: gap(0:)
      !> Receive tensions and slopes; shape `(0:n)`.
      real(dp), intent(out) :: tension(0:), slopes(0:)

      if (law%has_wall()) then
         tension = law%tension(max(gap, 0.0_dp))
         slopes = merge(law%slope(max(gap, 0.0_dp)), 0.0_dp, gap >= 0)
      else
         tension = law%tension(gap)
         slopes = law%slope(gap)
      end if
      ! the last node is where the attraction ends
      if (law%has_end()) then
         tension(ubound(gap, 1)) = 0
         slopes(ubound(gap, 1)) = 0
      end if
   end subroutine get_tensions

   !> What the gap is without tension, and what tensions at the nodes add to it: gap = base + influence s.
   pure subroutine get_influence(shape, x, t, base, influence)
      !> Shape of the body.
      class(shape_t), intent(in) :: shape
      !> Radii of the nodes, and t; shape `(0:n)`.
      real(dp), intent(in) :: x(0:), t(0:)
      !> Receive the gap without tension less that on the axis, and what tensions add; shapes `(0:n)` and `(0:n, 0:n)`.
      real(dp), intent(out) :: base(0:), influence(0:, 0:)
      real(dp) :: depths(0:ubound(x, 1)), sums(0:ubound(x, 1), 0:ubound(x, 1)), weights(0:ubound(x, 1)), &
         & row(0:ubound(x, 1))
      type(spot_t) :: spot
      integer :: i, j, n

      n = ubound(x, 1)
      depths = 0
      do i = 0, n
         call shape%evaluate(shape%unknown_of(x(i)), .true., spot)
         depths(i) = spot%depth
      end do
      depths = depths - depths(0)
      ! transposed: a column has the sums of one node
      do i = 0, n
         call get_sum_weights(t, i, sums(:, i))
      end do
      base(0) = 0
      influence(0, :) = 0
      do i = 1, n
         call get_gap_weights(t, x, i, weights(:i))
         base(i) = 2/pi*dot_product(weights(:i), depths(:i))
         row = sum(weights(:i))*sums(:, 0)
         do j = 0, i
            row(j:) = row(j:) - weights(j)*sums(j:, j)
         end do
         influence(i, :) = 4/pi*row
      end do
   end subroutine get_influence

   !> F at a node is the sum of weights and tensions.
   pure subroutine get_sum_weights(t, i, weights)
      !> t of the nodes; shape `(0:n)`.
      real(dp), intent(in) :: t(0:)
      !> The node.
      integer, intent(in) :: i
      !> Receives the weights; shape `(0:n)`.
      real(dp), intent(out) :: weights(0:)
      real(dp) :: near, far
      integer :: j

      weights = 0
      near = 0
      do j = i, ubound(t, 1) - 1
         far = sqrt((t(j + 1) - t(i))*(t(j + 1) + t(i)))
         associate (share => (far - near)/(3*(far + near)))
            weights(j) = weights(j) + share*(2*far + near)
            weights(j + 1) = weights(j + 1) + share*(far + 2*near)
         end associate
         near = far
      end do
   end subroutine get_sum_weights

   !> The integral of a function over sqrt(r^2 - x^2) dx, from the first node to node i at r, is the sum of weights and its values.
   pure subroutine get_gap_weights(t, x, i, weights)
      real(dp), intent(in) :: t(0:), x(0:)
      integer, intent(in) :: i
      real(dp), intent(out) :: weights(0:)
      integer, parameter :: n_points = 3
      real(dp), parameter :: points(n_points) = [-0.774596669241483377_dp, 0.0_dp, 0.774596669241483377_dp], &
         & parts(n_points) = [5.0_dp, 8.0_dp, 5.0_dp]/9
      real(dp) :: near, far, middle, half, part
      integer :: j, k

      weights = 0
      ! sqrt(r^2 - x^2) at the ends of a cell
      near = sqrt((t(i) - t(0))*(t(i) + t(0)))
      do j = 0, i - 1
         far = sqrt((t(i) - t(j + 1))*(t(i) + t(j + 1)))
         half = atan2(x(j + 1)*near - x(j)*far, x(j)*x(j + 1) + near*far)/2
         middle = (atan2(near, x(j)) + atan2(far, x(j + 1)))/2
         do k = 1, n_points
            ! angles are counted from x = r
            part = (near - x(i)*sin(middle + half*points(k)))*(near + x(i)*sin(middle + half*points(k))) &
               & /((t(j + 1) - t(j))*(t(j + 1) + t(j)))
            weights(j) = weights(j) + half*parts(k)*(1 - part)
            weights(j + 1) = weights(j + 1) + half*parts(k)*part
         end do
         near = far
      end do
   end subroutine get_gap_weights

end module adfric_round_attracted_sums

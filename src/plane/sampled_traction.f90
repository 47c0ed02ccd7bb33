! SPDX-License-Identifier: GPL-3.0-or-later
!> Half-plane under tractions that are given at samples and linear between them (plane strain).
!>
!> Conventions as in `adfric_plane_flamant`: p presses along +y into the solid, q pulls along +x, tension is positive. With
!> t = s - x and z = x + i y the integrals of the loads' stresses over the surface,
!>
!>     [s_xx, s_yy, s_xy] = -(2/pi) int (p y - q t) [t^2, y^2, -t y]/(t^2 + y^2)^2 ds,
!>
!> are those of Cauchy for f = p and f = q, C = int f/(s - z) ds and its derivative C' = int f/(s - z)^2 ds:
!>
!>     int f y t^2/r^4 ds = (Im C + y Re C')/2,   int f y^3/r^4 ds = (Im C - y Re C')/2,
!>     int f y^2 t/r^4 ds = y Im C'/2,            int f t^3/r^4 ds = Re C - y Im C'/2.
!>
!> Over a linear piece of ends s0, s1, values f0, f1 and slope g, with L = ln((s1 - z)/(s0 - z)),
!>
!>     C = f(z) L + g (s1 - s0),   C' = f0/(s0 - z) - f1/(s1 - z) + g L
!>
!> which is used close to a piece. Where two pieces meet what is singular in them cancels. The terms cancel, too, far from a piece,
!> as the square of the distance; there the first integrals go by Gauss's rule, whose error falls as rho^(-2n) for n points and
!> an ellipse of Bernstein through z with the half-axes' sum rho in half-lengths of the piece.
module adfric_plane_sampled_traction
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_plane_strip_tractions, only: log_ratio
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   implicit none (type, external)
   private
   public :: sampled_traction_t, every_second

   !> Distance from the middle of a piece, in half its length, from which on 16 points do (rho > 3.7, error 5e-19), and 4 points
   !> (rho > 160, 2e-18).
   real(dp), parameter :: far = 2.0_dp, very_far = 80.0_dp
   !> Gauss's rule of 4 points on (-1, 1).
   real(dp), parameter :: few_nodes(4) = [-0.86113631159405257522_dp, -0.33998104358485626480_dp, &
      & 0.33998104358485626480_dp, 0.86113631159405257522_dp]
   real(dp), parameter :: few_weights(4) = [0.34785484513745385737_dp, 0.65214515486254614263_dp, &
      & 0.65214515486254614263_dp, 0.34785484513745385737_dp]
   !> Pieces whose sum is made before it goes to the others, so that round-off grows as the root of their number.
   integer, parameter :: block_size = 256

   !> Tractions; every component has the shape `(n_samples)`.
   type :: sampled_traction_t
      !> Positions [m], increasing.
      real(dp), allocatable :: s(:)
      !> Pressure, and traction along x [Pa].
      real(dp), allocatable :: p(:), q(:)
   contains
      procedure :: value_at
      procedure :: stress_at
      procedure :: integral_at
      procedure :: jumps_at
   end type sampled_traction_t

contains

   !> Every second sample, and the last one.
   pure type(sampled_traction_t) function every_second(self) result(coarse)
      class(sampled_traction_t), intent(in) :: self
      integer :: n, n_coarse

      n = size(self%s)
      n_coarse = n/2 + 1
      allocate (coarse%s(n_coarse), coarse%p(n_coarse), coarse%q(n_coarse))
      coarse%s(:n_coarse - 1) = self%s(1:n - 1:2)
      coarse%p(:n_coarse - 1) = self%p(1:n - 1:2)
      coarse%q(:n_coarse - 1) = self%q(1:n - 1:2)
      coarse%s(n_coarse) = self%s(n)
      coarse%p(n_coarse) = self%p(n)
      coarse%q(n_coarse) = self%q(n)
   end function every_second

   !> Is a position on the surface an end of the strip where a traction does not begin from zero?
   pure logical function jumps_at(self, x)
      class(sampled_traction_t), intent(in) :: self
      !> Coordinate on the surface [m].
      real(dp), intent(in) :: x
      integer :: n

      n = size(self%s)
      jumps_at = (.not. abs(x - self%s(1)) > 0 .and. max(abs(self%p(1)), abs(self%q(1))) > 0) .or. &
         & (.not. abs(x - self%s(n)) > 0 .and. max(abs(self%p(n)), abs(self%q(n))) > 0)
   end function jumps_at

   !> p and q at a position on the surface; 0 beside the strip.
   pure function value_at(self, x) result(value)
      class(sampled_traction_t), intent(in) :: self
      !> Coordinate on the surface [m].
      real(dp), intent(in) :: x
      real(dp) :: value(2)
      real(dp) :: share
      integer :: left, right, middle

      value = 0
      left = 1
      right = size(self%s)
      if (x < self%s(left) .or. x > self%s(right)) return
      do while (right - left > 1)
         middle = (left + right)/2
         if (x < self%s(middle)) then
            right = middle
         else
            left = middle
         end if
      end do
      share = (x - self%s(left))/(self%s(right) - self%s(left))
      value = [self%p(left) + share*(self%p(right) - self%p(left)), self%q(left) + share*(self%q(right) - self%q(left))]
   end function value_at

   !> Stresses [s_xx, s_yy, s_xy]; NaN at an end of the strip where a traction jumps.
   pure function stress_at(self, x, y) result(stress)
      class(sampled_traction_t), intent(in) :: self
      !> Coordinates of the position [m], y >= 0.
      real(dp), intent(in) :: x, y
      real(dp) :: stress(3)
      real(dp) :: part(3)
      integer :: first, i

      stress = not_a_number()
      if (.not. y > 0 .and. self%jumps_at(x)) return
      stress = 0
      do first = 1, size(self%s) - 1, block_size
         part = 0
         do i = first, min(first + block_size, size(self%s)) - 1
            call add_piece(self, i, x, y, part)
         end do
         stress = stress + part
      end do
      stress = -2/pi*stress
   end function stress_at

   !> Add -(pi/2) times the stresses of the piece from sample i to the next.
   pure subroutine add_piece(self, i, x, y, stress)
      class(sampled_traction_t), intent(in) :: self
      !> Number of the sample where the piece begins, from 1.
      integer, intent(in) :: i
      !> Coordinates of the position [m], y >= 0.
      real(dp), intent(in) :: x, y
      !> Sum of -(pi/2) times the stresses, to which the piece is added [Pa].
      real(dp), intent(inout) :: stress(3)
      real(dp) :: half, middle, distance_squared

      half = (self%s(i + 1) - self%s(i))/2
      middle = (self%s(i) - x) + half
      distance_squared = (middle/half)**2 + (y/half)**2
      if (distance_squared < far**2) then
         call add_near(self, i, x, y, stress)
      else if (distance_squared < very_far**2) then
         call add_far(self, i, gauss_nodes, gauss_weights, middle, half, y, stress)
      else
         call add_far(self, i, few_nodes, few_weights, middle, half, y, stress)
      end if
   end subroutine add_piece

   !> Add the stresses of a piece, as `add_piece` does, by Gauss's rule.
   pure subroutine add_far(self, i, nodes, weights, middle, half, y, stress)
      class(sampled_traction_t), intent(in) :: self
      !> Number of the sample where the piece begins, from 1.
      integer, intent(in) :: i
      !> Nodes of Gauss's rule, on (-1, 1).
      real(dp), intent(in) :: nodes(:)
      !> Weights of Gauss's rule, one for each node.
      real(dp), intent(in) :: weights(:)
      !> t = s - x in the middle of the piece [m].
      real(dp), intent(in) :: middle
      !> Half the length of the piece [m].
      real(dp), intent(in) :: half
      !> Depth of the position [m], >= 0.
      real(dp), intent(in) :: y
      !> Sum of -(pi/2) times the stresses, to which the piece is added [Pa].
      real(dp), intent(inout) :: stress(3)
      real(dp) :: t, p, q, r, c, s, radial
      integer :: k

      do k = 1, size(nodes)
         t = middle + half*nodes(k)
         p = ((1 - nodes(k))*self%p(i) + (1 + nodes(k))*self%p(i + 1))/2
         q = ((1 - nodes(k))*self%q(i) + (1 + nodes(k))*self%q(i + 1))/2
         r = sqrt(t*t + y*y)
         c = y/r
         s = t/r
         radial = weights(k)*(half/r)*(p*c - q*s)
         stress(1) = stress(1) + radial*s*s
         stress(2) = stress(2) + radial*c*c
         stress(3) = stress(3) - radial*s*c
      end do
   end subroutine add_far

   !> Add the stresses of a piece, as `add_piece` does, by the closed form.
   pure subroutine add_near(self, i, x, y, stress)
      class(sampled_traction_t), intent(in) :: self
      !> Number of the sample where the piece begins, from 1.
      integer, intent(in) :: i
      !> Coordinates of the position [m], y >= 0.
      real(dp), intent(in) :: x, y
      !> Sum of -(pi/2) times the stresses, to which the piece is added [Pa].
      real(dp), intent(inout) :: stress(3)
      complex(dp) :: cp, dp_y, cq, dq_y

      call cauchy(self%s(i:i + 1), self%p(i:i + 1), x, y, cp, dp_y)
      call cauchy(self%s(i:i + 1), self%q(i:i + 1), x, y, cq, dq_y)
      stress(1) = stress(1) + (aimag(cp) + real(dp_y))/2 - (real(cq) - aimag(dq_y)/2)
      stress(2) = stress(2) + (aimag(cp) - real(dp_y))/2 - aimag(dq_y)/2
      stress(3) = stress(3) - aimag(dp_y)/2 + (aimag(cq) + real(dq_y))/2
   end subroutine add_near

   !> C and y C' of a linear piece. At its ends themselves what is singular is left out: it cancels with the next piece's.
   pure subroutine cauchy(s, f, x, y, c, derivative)
      !> Ends of the piece [m], increasing.
      real(dp), intent(in) :: s(2)
      !> Traction at the ends of the piece [Pa].
      real(dp), intent(in) :: f(2)
      !> Coordinates of the position [m], y >= 0.
      real(dp), intent(in) :: x, y
      !> Cauchy's integral C of the piece [Pa].
      complex(dp), intent(out) :: c
      !> Depth times derivative, y C', of the piece [Pa].
      complex(dp), intent(out) :: derivative
      real(dp) :: half, u, v, r(2), slope, angle
      complex(dp) :: logarithm, value
      integer :: near

      half = (s(2) - s(1))/2
      u = ((x - s(1)) + (x - s(2)))/(2*half)
      v = y/half
      r = hypot(x - s, y)/half
      slope = (f(2) - f(1))/2
      near = minloc(r, 1)
      ! f(z), from the nearer end
      value = cmplx(f(near) + slope*((x - s(near))/half), slope*v, dp)
      ! under which the piece is seen; half a turn on it, and half of that at its ends
      angle = pi/2
      if (r(near) > 0) angle = atan2(2*v, v*v + ((x - s(1))/half)*((x - s(2))/half))
      ! ln(r2/r1); at an end without its own part, that of the next piece
      if (r(near) > 0) then
         logarithm = cmplx(-log_ratio(u, v, r(1), r(2)), angle, dp)
      else
         logarithm = cmplx(merge(1, -1, near == 1)*log(2*half), angle, dp)
      end if
      c = value*logarithm + 2*slope
      derivative = v*slope*logarithm
      if (.not. y > 0) return
      derivative = derivative + f(1)*(y/cmplx(s(1) - x, -y, dp)) - f(2)*(y/cmplx(s(2) - x, -y, dp))
   end subroutine cauchy

   !> int p(s)/(x - s) ds and int q(s)/(x - s) ds over the strip, principal values; NaN at an end where a traction jumps.
   pure function integral_at(self, x) result(integral)
      class(sampled_traction_t), intent(in) :: self
      !> Coordinate on the surface [m].
      real(dp), intent(in) :: x
      real(dp) :: integral(2)
      real(dp) :: part(2)
      integer :: first, i

      integral = not_a_number()
      if (self%jumps_at(x)) return
      integral = 0
      do first = 1, size(self%s) - 1, block_size
         part = 0
         do i = first, min(first + block_size, size(self%s)) - 1
            call add_piece_integral(self, i, x, part)
         end do
         integral = integral + part
      end do
   end function integral_at

   !> Add the integrals over the piece from sample i to the next.
   pure subroutine add_piece_integral(self, i, x, integral)
      class(sampled_traction_t), intent(in) :: self
      !> Number of the sample where the piece begins, from 1.
      integer, intent(in) :: i
      !> Coordinate on the surface [m].
      real(dp), intent(in) :: x
      !> Sums for p and q, to which the piece is added [Pa].
      real(dp), intent(inout) :: integral(2)
      real(dp) :: half, middle
      complex(dp) :: cp, cq, unused

      half = (self%s(i + 1) - self%s(i))/2
      middle = (self%s(i) - x) + half
      if (abs(middle/half) < far) then
         call cauchy(self%s(i:i + 1), self%p(i:i + 1), x, 0.0_dp, cp, unused)
         call cauchy(self%s(i:i + 1), self%q(i:i + 1), x, 0.0_dp, cq, unused)
         integral = integral - [real(cp), real(cq)]
      else if (abs(middle/half) < very_far) then
         call add_far_integral(self, i, gauss_nodes, gauss_weights, middle, half, integral)
      else
         call add_far_integral(self, i, few_nodes, few_weights, middle, half, integral)
      end if
   end subroutine add_piece_integral

   !> Add the integrals over a piece, as `add_piece_integral` does, by Gauss's rule.
   pure subroutine add_far_integral(self, i, nodes, weights, middle, half, integral)
      class(sampled_traction_t), intent(in) :: self
      !> Number of the sample where the piece begins, from 1.
      integer, intent(in) :: i
      !> Nodes of Gauss's rule, on (-1, 1).
      real(dp), intent(in) :: nodes(:)
      !> Weights of Gauss's rule, one for each node.
      real(dp), intent(in) :: weights(:)
      !> t = s - x in the middle of the piece [m].
      real(dp), intent(in) :: middle
      !> Half the length of the piece [m].
      real(dp), intent(in) :: half
      !> Sums for p and q, to which the piece is added [Pa].
      real(dp), intent(inout) :: integral(2)
      real(dp) :: share
      integer :: k

      do k = 1, size(nodes)
         share = -weights(k)*half/(middle + half*nodes(k))/2
         integral(1) = integral(1) + share*((1 - nodes(k))*self%p(i) + (1 + nodes(k))*self%p(i + 1))
         integral(2) = integral(2) + share*((1 - nodes(k))*self%q(i) + (1 + nodes(k))*self%q(i + 1))
      end do
   end subroutine add_far_integral

end module adfric_plane_sampled_traction

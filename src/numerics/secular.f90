! SPDX-License-Identifier: GPL-3.0-or-later
!> The roots of a secular equation, by their distances from its poles.
!>
!> $$ \sum_i \frac{b_i}{x - a_i} = c, \qquad b_i > 0, \quad c > 0, \quad a_1 < a_2 < \dots < a_N. $$
!> One root is in each interval between poles, and one beyond the last pole. A small b puts roots next to poles, from which they
!> cannot be told. What is solved for is therefore the distance of a root from the nearer pole. The equation is evaluated in pairs of
!> numbers: its terms may cancel, and every distance is right to all its digits nevertheless.
module adfric_numerics_secular
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_numerics_exact_pairs, only: get_sum, get_quotient
   implicit none (type, external)
   private
   public :: get_root_distances

   !> Steps in which any bracket has become a point.
   integer, parameter :: max_steps = 2000
   !> Steps of the fast iteration that may follow on each other.
   integer, parameter :: fast_steps = 12
   !> A root that is nearer to a pole than to the next one is within this share of their distance.
   real(dp), parameter :: near_share = 0.6_dp

   !> The equation of one root in its distance y > 0 from the near pole: sum_i b_i/(y + e_i) = level. It falls with y.
   type :: secular_equation_t
      !> Numerators b_i; shape `(n)`.
      real(dp), allocatable :: b(:)
      !> What the rounding of the numerators left; shape `(n)`.
      real(dp), allocatable :: b_rest(:)
      !> Distances e_i of the poles from the near one, positive behind it; shape `(n)`.
      real(dp), allocatable :: e(:)
      !> What the rounding of these distances left; shape `(n)`.
      real(dp), allocatable :: e_rest(:)
      !> Right-hand side: c where the near pole is below the root, -c where it is above.
      real(dp) :: level = 1
      !> Distance of the two poles beside the root.
      real(dp) :: gap = 1
      !> Is there no pole beyond the root?
      logical :: is_last = .false.
   end type secular_equation_t

contains

   !> Distances of one root from all poles, x - a_i.
   pure subroutine get_root_distances(b, b_rest, a, c, j, distances)
      !> Numerators, > 0; shape `(n)`. None of them, nor a pole, nor c, is beyond 1e100, nor below its inverse.
      real(dp), intent(in) :: b(:)
      !> What the rounding of the numerators left; shape `(n)`.
      real(dp), intent(in) :: b_rest(:)
      !> Poles, strictly rising; shape `(n)`.
      real(dp), intent(in) :: a(:)
      !> Right-hand side, > 0.
      real(dp), intent(in) :: c
      !> Number of the root, which is the first one above the pole of the same number.
      integer, intent(in) :: j
      !> Receives the distances, positive from the poles below; shape `(n)`.
      real(dp), intent(out) :: distances(:)
      type(secular_equation_t) :: equation
      real(dp) :: low, high, y, value, near_slope, far_slope

      if (has_asserts) call assert(c > 0 .and. all(b > 0) .and. all(a(2:) > a(:size(a) - 1)), &
         & 'get_root_distances: c > 0, b > 0, poles that rise')
      equation%b = b
      equation%b_rest = b_rest
      allocate (equation%e(size(a)), equation%e_rest(size(a)))
      equation%is_last = j == size(a)
      if (.not. equation%is_last) equation%gap = a(j + 1) - a(j)
      call look_from_below(equation, a, c, j)
      if (.not. equation%is_last) then
         call evaluate(equation, equation%gap/2, value, near_slope, far_slope)
         if (value > 0) call look_from_above(equation, a, c, j + 1)
      end if
      call get_bracket(equation, merge(j + 1, j, equation%level < 0), low, high)
      call find_distance(equation, low, high, y)
      distances = sign(1.0_dp, equation%level)*((y + equation%e) + equation%e_rest)
   end subroutine get_root_distances

   !> The equation as seen from a pole below the root.
   pure subroutine look_from_below(equation, a, c, near)
      !> Receives level and positions of the poles.
      type(secular_equation_t), intent(inout) :: equation
      !> Poles; shape `(n)`.
      real(dp), intent(in) :: a(:)
      !> Right-hand side.
      real(dp), intent(in) :: c
      !> Number of the near pole.
      integer, intent(in) :: near

      equation%level = c
      call get_sum(a(near), -a, equation%e, equation%e_rest)
   end subroutine look_from_below

   !> The equation as seen from a pole above the root.
   pure subroutine look_from_above(equation, a, c, near)
      type(secular_equation_t), intent(inout) :: equation
      real(dp), intent(in) :: a(:), c
      integer, intent(in) :: near

      equation%level = -c
      call get_sum(a, -a(near), equation%e, equation%e_rest)
   end subroutine look_from_above

   !> A bracket of the root, with both ends positive.
   pure subroutine get_bracket(equation, near, low, high)
      type(secular_equation_t), intent(in) :: equation
      integer, intent(in) :: near
      !> Ends of the bracket.
      real(dp), intent(out) :: low, high

      if (equation%is_last) then
         ! as if the last pole were alone, and as if all were there; factors of 2 for rounding
         low = equation%b(near)/equation%level/2
         high = sum(equation%b)/equation%level*2
      else
         high = near_share*equation%gap
         ! the near pole outweighs no more than the poles beyond, and the level
         low = equation%b(near)/(max(equation%level, 0.0_dp) &
            & - sum(equation%b/(high + equation%e), mask=equation%e < 0))
         low = min(low, high)/2
      end if
   end subroutine get_bracket

   !> The root of an equation whose value falls from one end of a bracket to the other.
   !>
   !> Each step solves an equation of two poles that has the value of this one and the slopes of its two sides (J. R. Bunch,
   !> C. P. Nielsen, D. C. Sorensen, Numerische Mathematik 31, 31, 1978). Where that leaves the bracket, or takes long, a step
   !> halves the bracket on a logarithmic scale.
   pure subroutine find_distance(equation, low, high, y)
      type(secular_equation_t), intent(in) :: equation
      !> Ends of the bracket, > 0.
      real(dp), intent(in) :: low, high
      !> The root.
      real(dp), intent(out) :: y
      real(dp) :: left, right, value, near_slope, far_slope, step
      integer :: i

      left = low
      right = high
      y = sqrt(left)*sqrt(right)
      do i = 1, max_steps
         call evaluate(equation, y, value, near_slope, far_slope)
         if (value > 0) then
            left = y
         else
            right = y
         end if
         step = step_of(equation, y, value, near_slope, far_slope)
         if (abs(step) <= epsilon(y)*y .or. right - left <= epsilon(y)*left) exit
         y = y + step
         if (.not. (y > left .and. y < right) .or. modulo(i, fast_steps) == 0) y = sqrt(left)*sqrt(right)
      end do
      if (abs(step) <= epsilon(y)*y) y = y + step
      if (has_asserts) call assert(i <= max_steps, 'find_distance: the bracket shrinks')
   end subroutine find_distance

   !> Value of the equation, sum_i b_i/(y + e_i) - level, and what its slope owes to either side.
   pure subroutine evaluate(equation, y, value, near_slope, far_slope)
      type(secular_equation_t), intent(in) :: equation
      !> Distance from the near pole, > 0 and less than the gap.
      real(dp), intent(in) :: y
      real(dp), intent(out) :: value
      !> The negative of its slope, from the near pole and those behind it.
      real(dp), intent(out) :: near_slope
      !> The negative of its slope, from the poles beyond the root.
      real(dp), intent(out) :: far_slope
      real(dp) :: distance, distance_rest, term, term_rest, total, rest, remainder
      integer :: i

      value = -equation%level
      rest = 0
      near_slope = 0
      far_slope = 0
      do i = 1, size(equation%b)
         call get_sum(y, equation%e(i), distance, distance_rest)
         distance_rest = distance_rest + equation%e_rest(i)
         call get_quotient(equation%b(i), equation%b_rest(i), distance, distance_rest, term, term_rest)
         call get_sum(value, term, total, remainder)
         value = total
         rest = rest + (remainder + term_rest)
         if (distance > 0) then
            near_slope = near_slope + term/distance
         else
            far_slope = far_slope + term/distance
         end if
      end do
      value = value + rest
   end subroutine evaluate

   !> The step to the root of p + q/y + r/(y - gap), of which q is given by the near slope and r by the far one.
   pure real(dp) function step_of(equation, y, value, near_slope, far_slope)
      type(secular_equation_t), intent(in) :: equation
      !> Distance from the near pole, where the step begins.
      real(dp), intent(in) :: y
      !> Value of the equation there.
      real(dp), intent(in) :: value
      !> What its slope owes to either side, with the sign changed.
      real(dp), intent(in) :: near_slope, far_slope
      real(dp) :: beyond, a, b, c, root

      if (equation%is_last) then
         step_of = bounded_quotient(value*y, near_slope*y - value, 1/epsilon(y))
         return
      end if
      beyond = y - equation%gap
      ! a step^2 + b step + c = 0
      a = value - near_slope*y - far_slope*beyond
      b = value*(y + beyond) - y*beyond*(near_slope + far_slope)
      c = value*y*beyond
      root = sqrt(max(b**2 - 4*a*c, 0.0_dp))
      if (b > 0) then
         step_of = bounded_quotient(-2*c, b + root, equation%gap)
      else
         step_of = bounded_quotient(root - b, 2*a, equation%gap)
      end if
   end function step_of

   !> x/y, or a bound where |x/y| is more.
   pure real(dp) function bounded_quotient(x, y, bound)
      !> Dividend.
      real(dp), intent(in) :: x
      !> Divisor, which may be 0.
      real(dp), intent(in) :: y
      !> Largest value that is given back.
      real(dp), intent(in) :: bound

      bounded_quotient = bound
      if (abs(x) < abs(y)*bound) bounded_quotient = x/y
   end function bounded_quotient

end module adfric_numerics_secular

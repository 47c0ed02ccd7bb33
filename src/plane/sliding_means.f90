! SPDX-License-Identifier: GPL-3.0-or-later
!> Means over the contact and over the gap of a wave, which the equations of sliding need of each relaxation or retardation length.
!>
!> Lengths in 1/k. The contact is -w < y < w and the gap w < y < 2 pi - w; s = sin(w/2), C = cos(w/2), R^2 = |cos y - cos w|/2. Then
!>
!>     contact, e^(-y/a) cos(y/2)/R:    rho = mean of R^2 = s^2 <sin^2 phi>,   nu = <cos 2 phi>
!>     gap,     e^(-y/b) cos(y/2)/R:    rho' = mean of R^2 = C^2 <sin^2 phi>
!>
!> where sin(y/2) = -s cos phi in the contact and cos(y/2) = C cos phi in the gap. All three are ratios of integrals, and
!> all integrands are positive, once the positions phi and pi - phi are taken together and nu is integrated by parts. Where b is
!> long,
!>
!>     rho' = (C^2 + s^2 ln s^2)/(-2 ln s^2) = C^2 mu
!>     rho' - C^2 mu = C^2 <(sin^2 phi - mu) (1 - z/(b sinh(z/b)))>,    z = pi - y
!>
!> and this excess is summed by itself. The integrals are sums at equal steps of v, dy = 2 R dv, which make phi an elliptic function
!> of v: sums over a period of an analytic function, whose error is squared when the step is halved, for a contact or a gap as
!> narrow as may be. A length that is short beside the arc needs the positions near one edge alone.
module adfric_plane_sliding_means
   use adfric_base_kinds, only: dp
   use adfric_numerics_jacobi_nodes, only: halve_argument, put_midpoints
   use adfric_numerics_hyperbolic, only: sinh_minus_argument
   use adfric_numerics_libm, only: expm1
   implicit none (type, external)
   private
   public :: arc_t, get_contact_means, get_gap_means, logarithm_of_sine, elastic_mean_gap

   !> Halvings of the step, from two intervals on.
   integer, parameter :: most_levels = 13
   !> The sums rest when the last change of a mean is at most the first number, and what it leaves at most the second: where the
   !> error is A r^(1/h), that is the cube of the last change over the square of the one before it. They rest, too, when these two
   !> changes are at most the third number, or the last one the fourth, since round-off hides how they fall.
   real(dp), parameter :: small_change = 3.0e-9_dp, small_error = 2.0e-16_dp, small_changes = 1.0e-10_dp, round_off = 1.0e-14_dp
   !> Exponent whose decay is nothing.
   real(dp), parameter :: long_path = 45

   !> One of the two arcs of a period, contact or gap.
   type :: arc_t
      !> Half of its length [1/k], 0 to pi.
      real(dp) :: half_width = 0
      !> Sine and cosine of half of the half-width.
      real(dp) :: sine = 0, cosine = 1
   end type arc_t

contains

   !> The two means over a contact.
   pure subroutine get_contact_means(arc, length, rho, nu, is_converged)
      type(arc_t), intent(in) :: arc
      !> Relaxation length a [1/k], > 0.
      real(dp), intent(in) :: length
      !> Mean of R^2, > 0.
      real(dp), intent(out) :: rho
      !> Mean of cos 2 phi, > 0.
      real(dp), intent(out) :: nu
      logical, intent(out) :: is_converged
      real(dp) :: means(2)

      call sum_over_arc(arc, length, .false., means, is_converged)
      rho = arc%sine**2*means(1)
      nu = means(2)
   end subroutine get_contact_means

   !> The two means over a gap.
   pure subroutine get_gap_means(arc, length, rho, excess, is_converged)
      type(arc_t), intent(in) :: arc
      !> Retardation length b [1/k], > 0.
      real(dp), intent(in) :: length
      !> Mean of R^2, > 0.
      real(dp), intent(out) :: rho
      !> By how much it is more than where b is long, < 0.
      real(dp), intent(out) :: excess
      logical, intent(out) :: is_converged
      real(dp) :: means(2)

      call sum_over_arc(arc, length, .true., means, is_converged)
      rho = arc%sine**2*means(1)
      excess = arc%sine**2*means(2)
   end subroutine get_gap_means

   !> -ln s^2 = -ln(1 - C^2), to round-off.
   elemental real(dp) function logarithm_of_sine(gap)
      type(arc_t), intent(in) :: gap

      if (gap%sine < gap%cosine) then
         logarithm_of_sine = gap%sine**2 + logarithm_rest(gap%sine**2)
      else
         logarithm_of_sine = -2*log(gap%cosine)
      end if
   end function logarithm_of_sine

   !> C^2 + s^2 ln s^2, the mean gap of an elastic solid, to round-off.
   elemental real(dp) function elastic_mean_gap(gap)
      type(arc_t), intent(in) :: gap

      if (gap%sine < gap%cosine) then
         elastic_mean_gap = gap%sine**4 - gap%cosine**2*logarithm_rest(gap%sine**2)
      else
         elastic_mean_gap = gap%sine**2 + 2*gap%cosine**2*log(gap%cosine)
      end if
   end function elastic_mean_gap

   !> -ln(1 - x) - x for 0 <= x <= 1/2.
   elemental real(dp) function logarithm_rest(x)
      !> A number.
      real(dp), intent(in) :: x
      real(dp) :: term
      integer :: k

      logarithm_rest = 0
      term = x
      do k = 2, 60
         term = term*x
         logarithm_rest = logarithm_rest + term/k
         if (term <= epsilon(x)*logarithm_rest) exit
      end do
   end function logarithm_rest

   !> <sin^2 phi> and, in a contact, nu, in a gap the excess over C^2, with twice as many positions until they rest.
   pure subroutine sum_over_arc(arc, length, is_gap, means, is_converged)
      type(arc_t), intent(in) :: arc
      !> Length of the decay [1/k], > 0.
      real(dp), intent(in) :: length
      logical, intent(in) :: is_gap
      real(dp), intent(out) :: means(2)
      logical, intent(out) :: is_converged
      real(dp) :: nodes(3, 0:2**most_levels), midpoints(3, 2**(most_levels - 1)), step(3), sums(3), mu
      real(dp) :: old_means(2), changes(2), old_changes(2)
      integer :: level, n

      mu = 0
      if (is_gap) mu = elastic_mean_gap(arc)/(2*logarithm_of_sine(arc)*arc%sine**2)
      call find_end_of_decay(arc, length, step)
      nodes(:, 0) = [0.0_dp, 1.0_dp, 1.0_dp]
      nodes(:, 1) = step
      sums = 0.5_dp*(terms_of(arc, length, is_gap, mu, nodes(:, 0)) + terms_of(arc, length, is_gap, mu, nodes(:, 1)))
      means = sums(2:)/sums(1)
      changes = 1
      do level = 1, most_levels
         n = 2**(level - 1)
         call halve_argument(step)
         call put_midpoints(arc%sine**2, step, nodes(:, 0:n), midpoints(:, :n))
         call add_terms(arc, length, is_gap, mu, midpoints(:, :n), sums)
         old_means = means
         means = sums(2:)/sums(1)
         old_changes = changes
         changes = change_of(means, old_means)
         is_converged = level > 2 .and. all(are_small(changes, old_changes))
         if (is_converged .or. level == most_levels) return
         nodes(:, 0:2*n:2) = nodes(:, 0:n)
         nodes(:, 1:2*n:2) = midpoints(:, :n)
      end do
   end subroutine sum_over_arc

   !> By what share of it a mean has changed, at most 1.
   elemental real(dp) function change_of(mean, old_mean)
      !> The mean, and what it was.
      real(dp), intent(in) :: mean, old_mean

      change_of = abs(mean - old_mean)
      if (change_of < abs(old_mean)) then
         change_of = change_of/abs(old_mean)
      else if (change_of > 0) then
         change_of = 1
      end if
   end function change_of

   !> Do the last changes of a mean say that it rests?
   elemental logical function are_small(change, old_change)
      !> The last change and the one before it, over the mean, >= 0.
      real(dp), intent(in) :: change, old_change

      are_small = change <= round_off .or. max(change, old_change) <= small_changes .or. &
         & (change <= small_change .and. change**3 <= small_error*old_change**2)
   end function are_small

   !> Halve the range of v, from the edge to the middle, as long as all of the decay is in the half.
   pure subroutine find_end_of_decay(arc, length, values)
      type(arc_t), intent(in) :: arc
      !> Length of the decay [1/k], > 0.
      real(dp), intent(in) :: length
      !> sn, cn, dn at the end of the range.
      real(dp), intent(out) :: values(3)
      real(dp) :: half(3)

      values = [1.0_dp, 0.0_dp, arc%cosine]
      do
         half = values
         call halve_argument(half)
         if (.not. path_from_edge(arc, half) > long_path*length) return
         values = half
      end do
   end subroutine find_end_of_decay

   !> Add the terms at several positions.
   pure subroutine add_terms(arc, length, is_gap, mu, nodes, sums)
      type(arc_t), intent(in) :: arc
      !> Length of the decay [1/k], > 0.
      real(dp), intent(in) :: length
      logical, intent(in) :: is_gap
      !> The mean of sin^2 phi over the gap where the length is long.
      real(dp), intent(in) :: mu
      !> sn, cn, dn at the positions; shape `(3, n)`.
      real(dp), intent(in) :: nodes(:, :)
      !> Sums of the terms.
      real(dp), intent(inout) :: sums(3)
      integer :: i

      do i = 1, size(nodes, 2)
         sums = sums + terms_of(arc, length, is_gap, mu, nodes(:, i))
      end do
   end subroutine add_terms

   !> The integrands with respect to v, of phi and pi - phi together: the weight, the weight times sin^2 phi, and what gives nu.
   pure function terms_of(arc, length, is_gap, mu, values) result(terms)
      type(arc_t), intent(in) :: arc
      !> Length of the decay [1/k], > 0.
      real(dp), intent(in) :: length
      logical, intent(in) :: is_gap
      !> The mean of sin^2 phi over the gap where the length is long.
      real(dp), intent(in) :: mu
      !> sn, cn, dn at the position.
      real(dp), intent(in) :: values(3)
      real(dp) :: terms(3)
      real(dp) :: cosine, square, path, to_middle, decay, far_side

      cosine = values(2)/values(3)
      square = (arc%cosine*values(1)/values(3))**2
      path = path_from_edge(arc, values)
      to_middle = arc%half_width - path
      ! a difference would lose digits there
      if (2*path > arc%half_width) to_middle = 2*asin(min(arc%sine*cosine, 1.0_dp))
      decay = exp(-path/length)
      far_side = -expm1(-2*to_middle/length)
      if (is_gap) then
         terms(1) = cosine*decay*far_side
         terms(3) = cosine*(square - mu)*beyond_line(to_middle/length, decay*far_side, exp(-arc%half_width/length))
      else
         terms(1) = decay*(2 - far_side)*arc%cosine/values(3)
         terms(3) = 2*arc%sine/length*square*cosine*decay*far_side
      end if
      terms(2) = square*terms(1)
   end function terms_of

   !> 2 F (sinh t - t).
   pure real(dp) function beyond_line(t, hyperbolic_part, factor)
      !> t, >= 0.
      real(dp), intent(in) :: t
      !> 2 F sinh t.
      real(dp), intent(in) :: hyperbolic_part
      !> F, >= 0.
      real(dp), intent(in) :: factor

      if (t < 1) then
         beyond_line = 2*factor*sinh_minus_argument(t)
      else
         beyond_line = hyperbolic_part - 2*factor*t
      end if
   end function beyond_line

   !> Path from the edge to a position.
   pure real(dp) function path_from_edge(arc, values)
      type(arc_t), intent(in) :: arc
      !> sn, cn, dn at the position.
      real(dp), intent(in) :: values(3)

      path_from_edge = 4*atan(arc%sine*arc%cosine*values(1)**2/((values(2) + values(3))*(1 + values(3))))
   end function path_from_edge

end module adfric_plane_sliding_means

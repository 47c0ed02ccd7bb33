! SPDX-License-Identifier: GPL-3.0-or-later
!> The stable and the unstable parts of a curve of Maugis's theory.
!>
!> Folds are roots of F_d + 2 s F_P (see `adfric_round_dugdale_curve`), a difference of two positive terms. With
!> N(c, th) = int g'(c cos(y)) cos(y) dy, 0 < y < th, they are where R = N/D is 2 S,
!>
!>     D = 1 - cos(th) + Y th^2/cos(th),    Y = 2 s a/(1 + 2 s a);    Y = 0 at given approach, Y = 1 under load.
!>
!> How often R turns along a curve is proved, or evaluated, in docs/theory/round_branches.md (Proofs; there N is H):
!>
!> - Where g' never falls R rises at every fold, so there is one at most: the cone, r^n with n >= 1 and sums of them, the sphere, and
!>   the rounded punch. Within a flat face R rises. Contacts whose zone ends within the face, too, are unstable.
!> - Beyond the corner of `flat_cone`, `flat_paraboloid` and `rounded_cone` R falls, and then it rises. In the tip of `rounded_cone` it
!>   rises, and may then fall.
!>
!> So the signs of R - 2 S at the ends of a stretch tell its folds, and where both are the same the extreme value at the turn does.
!> Round-off hides two folds that are closer together than about 1e-7 of their distance from the corner. Between them what is
!> prescribed is constant to round-off; both count as none.
module adfric_round_dugdale_folds
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, two_pi
   use adfric_round_curve, only: at_corner, curve_interval_t, endless
   use adfric_round_dugdale_stretch, only: margins_t, stretch_t, get_logarithm, divide_stretch, last_turn
   use adfric_round_shape, only: shape_t, within_edge
   implicit none (type, external)
   private
   public :: find_stable_parts, find_edge_angle

contains

   !> The parts of a curve.
   pure subroutine find_stable_parts(margins, shape, stress, range, intervals, n, is_converged)
      class(margins_t), intent(in) :: margins
      class(shape_t), intent(in) :: shape
      !> Stress and range of adhesion, reduced.
      real(dp), intent(in) :: stress, range
      type(curve_interval_t), intent(out) :: intervals(:)
      integer, intent(out) :: n
      logical, intent(out) :: is_converged
      type(stretch_t) :: outer, inner
      real(dp) :: edge

      n = 0
      is_converged = .true.
      edge = 0
      if (shape%has_face) edge = contact_at_edge(stress, range)
      if (edge > 0) then
         n = 1
         intervals(n) = curve_interval_t(.false., .false., .false., .false., 0.0_dp, edge)
      end if
      if (shape%n_pieces == 0) return
      call lay_outer(margins, shape, stress, range, outer, is_converged)
      if (.not. is_converged) return
      if (shape%corner > 0) then
         call lay_inner(margins, shape, edge, outer%at_low, inner, is_converged)
         if (.not. is_converged) return
         call divide_stretch(margins, inner, shape%corner, intervals, n, is_converged)
      end if
      call divide_stretch(margins, outer, shape%corner, intervals, n, is_converged)
   end subroutine find_stable_parts

   !> The stretch beyond the corner, up to a contact that is stable; beside a vertical edge up to the last one that has space for
   !> its zone.
   pure subroutine lay_outer(margins, shape, stress, range, outer, is_converged)
      class(margins_t), intent(in) :: margins
      class(shape_t), intent(in) :: shape
      real(dp), intent(in) :: stress, range
      type(stretch_t), intent(out) :: outer
      logical, intent(out) :: is_converged
      real(dp), parameter :: factor = 4.0_dp
      integer, parameter :: most_steps = 40
      integer :: k

      call get_logarithm(margins, 0.0_dp, .true., outer%at_low, is_converged)
      if (.not. is_converged) return
      if (.not. shape%has_rising_slope) outer%turn = 1
      ! that of JKR under load, which is the largest one
      outer%guess = max(shape%get_end(1.5_dp*sqrt(two_pi*stress*range)), sqrt(stress*range))
      if (shape%edge < endless) then
         call find_space(margins, shape%unknown_of(within_edge*shape%edge), outer%high, outer%at_high)
         outer%last = outer%high
         outer%guess = min(outer%guess, outer%high/2)
         return
      end if
      outer%high = max(outer%guess, 2*last_turn*shape%corner)
      do k = 1, most_steps
         call get_logarithm(margins, outer%high, .true., outer%at_high, is_converged)
         if (.not. is_converged .or. outer%at_high > 0) return
         outer%high = factor*outer%high
      end do
      is_converged = .false.
   end subroutine lay_outer

   !> The last contact beside a vertical edge that has space for its zone; c rises along the curve, so all smaller ones have, too.
   pure subroutine find_space(margins, most, u, logarithm)
      class(margins_t), intent(in) :: margins
      !> The contact that reaches the edge.
      real(dp), intent(in) :: most
      !> Receives the unknown of the last contact, 0 if that is the last one.
      real(dp), intent(out) :: u
      !> Receives ln(R/2 S) there.
      real(dp), intent(out) :: logarithm
      integer, parameter :: most_halvings = 16
      real(dp) :: low, high, value
      integer :: k
      logical :: is_found

      u = most
      call get_logarithm(margins, u, .true., logarithm, is_found)
      if (is_found) return
      low = 0
      high = most
      logarithm = -1
      do k = 1, most_halvings
         u = (low + high)/2
         call get_logarithm(margins, u, .true., value, is_found)
         if (is_found) low = u
         if (is_found) logarithm = value
         if (.not. is_found) high = u
      end do
      u = low
   end subroutine find_space

   !> The stretch within the corner.
   pure subroutine lay_inner(margins, shape, edge, at_high, inner, is_converged)
      class(margins_t), intent(in) :: margins
      class(shape_t), intent(in) :: shape
      !> The contact of a flat face whose zone ends at the corner; 0 if all zones end beyond.
      real(dp), intent(in) :: edge
      !> ln(R/2 S) at the corner.
      real(dp), intent(in) :: at_high
      type(stretch_t), intent(out) :: inner
      logical, intent(out) :: is_converged

      inner%is_beyond = .false.
      inner%at_high = at_high
      inner%high = shape%corner
      inner%guess = shape%corner/4
      if (shape%has_face) then
         inner%low = edge
         inner%guess = max(inner%low, 1.0_dp)
         inner%high = at_corner
      else
         inner%turn = -1
      end if
      inner%last = inner%high
      call get_logarithm(margins, inner%low, .false., inner%at_low, is_converged)
   end subroutine lay_inner

   !> The contact of a flat face whose zone ends at the corner, a little larger, for c to be beyond; 0 if all zones end beyond.
   !> Its u, a/sqrt(b^2 - a^2), is the cotangent of the angle of a flat punch.
   pure real(dp) function contact_at_edge(stress, range) result(u)
      real(dp), intent(in) :: stress, range
      real(dp), parameter :: beyond_round_off = 64*epsilon(1.0_dp)
      real(dp) :: angle

      call find_edge_angle(pi*range/(4*stress), angle)
      u = 0
      if (angle > 0) u = (1 + beyond_round_off)/tan(angle)
   end function contact_at_edge

   !> The angle th where th sin(th) + cos(th) - 1 has a value; 0 if the value is more than pi/2 - 1.
   pure subroutine find_edge_angle(value, angle)
      !> The value, > 0.
      real(dp), intent(in) :: value
      real(dp), intent(out) :: angle
      ! a step after this one is round-off
      real(dp), parameter :: close_enough = 1.0e-9_dp
      integer, parameter :: most_steps = 60
      real(dp) :: k, step
      integer :: i

      angle = 0
      if (.not. value < pi/2 - 1) return
      angle = min(sqrt(2*value), pi/2)
      do i = 1, most_steps
         k = sin(angle)*(angle - tan(angle/2))
         ! by the logarithm of the angle
         step = (value - k)/(angle*cos(angle)*angle + tiny(k))
         step = max(-0.5_dp, min(0.5_dp, step))
         angle = min(angle*exp(step), pi/2)
         if (abs(step) < close_enough) exit
      end do
   end subroutine find_edge_angle

end module adfric_round_dugdale_folds

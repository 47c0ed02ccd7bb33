! SPDX-License-Identifier: GPL-3.0-or-later
!> Partial slip of an indenter of any axisymmetric shape without adhesion: under a constant load P a tangential force T has grown from 0,
!> up to Coulomb's friction mu P (J. Jaeger, Arch. Appl. Mech. 63, 1993, 402; M. Ciavarella, J. Appl. Mech. 65, 1998, 998), reduced.
!>
!> The shear traction is mu [p(.; a) - p(.; e)], e the radius of the contact of the load P* = P - T/mu, which sticks. With m the ratio of
!> the tangential to the normal compliance,
!>
!>     u = mu m [g(a) - g(e)],   dT/du = 2 e/m,   W = 8 mu^2 m int [g(s) - g(e)] [g(a) - g(s)] ds,  e < s < a
!>
!> W being the energy of a cycle between T and -T. Where little slips, radii and depths are close together: the path from a down to
!> e is then found from P - P* = int 2 a dg along it, and all else by integrals along it, none of which has a term below 0. Where
!> much slips, W = 8 mu^2 m [(P + P*) (delta - delta*)/2 - (U - U*)], U the elastic energy. For r^n, q = e/a is (P*/P)^(1/(n + 1)),
!> and W = 8 mu^2 m a g(a)^2 int (t^n - q^n) (1 - t^n) dt, q < t < 1.
module adfric_round_slip
   use adfric_base_kinds, only: dp
   use adfric_round_contact, only: branch_stable, find_contact
   use adfric_round_contact_state, only: contact_t
   use adfric_round_survey, only: survey_t
   use adfric_round_curve, only: control_load, curve_t
   use adfric_round_power_shape, only: power_shape_t
   use adfric_round_shape, only: shape_t, spot_t
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights, gauss_nodes_10, gauss_weights_10, gauss_integrals_10, &
      & gauss_nodes_6, gauss_weights_6
   use adfric_numerics_libm, only: expm1, log1p
   implicit none (type, external)
   private
   public :: indenter_slip_t, find_indenter_slip

   !> From this share of mu P on differences have the digits.
   real(dp), parameter :: large_share = 0.5_dp
   !> Below this share of a a stretch is short: load and depths along it are integrals. The nearest singularity is 19 times half its length
   !> away from its middle, so an error of Gauss's rule falls with each node by 38^2, and one between nodes by 38: 6 and 10 nodes do.
   real(dp), parameter :: short = 0.1_dp
   !> Most stretches of a path: one on either side of the corner.
   integer, parameter :: most_stretches = 2

   !> Slip of a contact.
   type :: indenter_slip_t
      !> The contact that sticks.
      type(contact_t) :: stick
      !> e/a.
      real(dp) :: ratio = 1
      !> g(a) - g(e).
      real(dp) :: fall = 0
      !> W/(8 mu^2 m).
      real(dp) :: energy = 0
   end type indenter_slip_t

   !> A stretch of the path from a down to e, where u falls.
   type :: slip_stretch_t
      !> Does it lie beyond the corner?
      logical :: is_beyond = .true.
      !> Its largest u, and its length in u.
      real(dp) :: high = 0, length = 0
      !> How much g falls before it, and along it.
      real(dp) :: before = 0, fall = 0
      !> What the shape is at its beginning, and at its end.
      type(spot_t) :: start, finish
   end type slip_stretch_t

contains

   !> The slip of a contact without adhesion.
   pure subroutine find_indenter_slip(curve, survey, contact, tau, slip, is_converged)
      class(curve_t), intent(in) :: curve
      type(survey_t), intent(in) :: survey
      !> The contact, of a load > 0.
      type(contact_t), intent(in) :: contact
      !> T/(mu P), 0 to 1.
      real(dp), intent(in) :: tau
      type(indenter_slip_t), intent(out) :: slip
      logical, intent(out) :: is_converged
      type(slip_stretch_t) :: path(most_stretches)
      integer :: n

      is_converged = .true.
      if (.not. tau > 0) then
         slip%stick = contact
         return
      end if
      select type (shape => curve%shape)
      type is (power_shape_t)
         if (shape%n_terms == 1) then
            call find_power_slip(shape, contact, tau, slip)
            return
         end if
      end select
      if (curve%shape%n_pieces == 0 .or. tau >= large_share) then
         call find_contact(curve, survey, control_load, contact%load*(1 - tau), .true., branch_stable, slip%stick)
         is_converged = slip%stick%is_found .and. slip%stick%is_converged
         slip%fall = contact%approach - slip%stick%approach
         ! a whole face sticks
         if (curve%shape%n_pieces == 0) slip%fall = tau*contact%load/2
         if (curve%shape%n_pieces > 0) slip%energy = (contact%load + slip%stick%load)*slip%fall/2 &
            & - (curve%shape%energy(contact%u, contact%is_beyond) - curve%shape%energy(slip%stick%u, slip%stick%is_beyond))
      else
         call find_path(curve%shape, contact, tau*contact%load, path, n, is_converged)
         slip%fall = path(n)%before + path(n)%fall
         slip%energy = energy_of(curve%shape, path(:n))
         slip%stick = contact
         slip%stick%u = path(n)%high - path(n)%length
         slip%stick%is_beyond = path(n)%is_beyond
         call set_stick(path(n)%finish, (1 - tau)*contact%load, slip)
      end if
      slip%ratio = min(slip%stick%spot%radius/contact%spot%radius, 1.0_dp)
   end subroutine find_indenter_slip

   !> What follows for the contact that sticks from its place.
   pure subroutine set_stick(spot, load, slip)
      type(spot_t), intent(in) :: spot
      real(dp), intent(in) :: load
      type(indenter_slip_t), intent(inout) :: slip

      slip%stick%spot = spot
      slip%stick%load = load
      slip%stick%approach = spot%depth
      slip%stick%stiffness = 2*spot%radius
      slip%stick%adhesion_radius = spot%radius
   end subroutine set_stick

   !> The slip of a single power of r.
   pure subroutine find_power_slip(shape, contact, tau, slip)
      type(power_shape_t), intent(in) :: shape
      type(contact_t), intent(in) :: contact
      !> T/(mu P), above 0, up to 1.
      real(dp), intent(in) :: tau
      type(indenter_slip_t), intent(inout) :: slip
      type(spot_t) :: spot
      real(dp) :: logarithm

      associate (n => shape%exponents(1))
         slip%stick = contact
         slip%ratio = 0
         slip%fall = contact%spot%depth
         ! ln q
         logarithm = -huge(logarithm)
         if (tau < 1) then
            logarithm = log1p(-tau)/(n + 1)
            slip%ratio = exp(logarithm)
            slip%fall = -contact%spot%depth*expm1(n*logarithm)
         end if
         slip%energy = contact%spot%radius*contact%spot%depth**2*power_energy(n, tau, logarithm)
         slip%stick%u = contact%u*slip%ratio
         call shape%evaluate(slip%stick%u, .true., spot)
         call set_stick(spot, (1 - tau)*contact%load, slip)
      end associate
   end subroutine find_power_slip

   !> int (t^n - q^n) (1 - t^n) dt, q < t < 1: for a small whole n a polynomial, whose factors t - q and 1 - t are taken out; where
   !> much slips the difference of the closed forms.
   pure real(dp) function power_energy(n, tau, logarithm) result(energy)
      !> The exponent.
      real(dp), intent(in) :: n
      !> 1 - q^(n + 1).
      real(dp), intent(in) :: tau
      !> ln q; of no meaning where tau is 1.
      real(dp), intent(in) :: logarithm
      integer, parameter :: largest = 9
      real(dp) :: q, rest, t, factors(2)
      integer :: node, k, whole

      q = 0
      if (tau < 1) q = exp(logarithm)
      rest = 1
      if (tau < 1) rest = -expm1(logarithm)
      whole = nint(min(n, largest + 1.0_dp))
      if (abs(n - whole) > 0 .or. whole > largest) then
         if (tau >= large_share) then
            energy = n/(n + 1)*(2 - tau)*(1 - q**n) - 2*n**2/((n + 1)*(2*n + 1))*(1 - (1 - tau)*q**n)
            return
         end if
         whole = 0
      end if
      energy = 0
      do node = 1, size(gauss_nodes_10)
         t = q + rest*(1 + gauss_nodes_10(node))/2
         if (whole > 0) then
            ! (t^n - q^n)/(t - q) and (1 - t^n)/(1 - t)
            factors = 1
            do k = 2, whole
               factors = factors*[t, 1.0_dp] + [q, t]**(k - 1)
            end do
            factors = factors*rest*[1 + gauss_nodes_10(node), 1 - gauss_nodes_10(node)]/2
         else
            factors = [q**n*expm1(n*log1p(rest*(1 + gauss_nodes_10(node))/(2*q))), &
               & -expm1(n*log1p(-rest*(1 - gauss_nodes_10(node))/2))]
         end if
         energy = energy + gauss_weights_10(node)*rest/2*factors(1)*factors(2)
      end do
   end function power_energy

   !> The path along which the load falls by a part of itself.
   pure subroutine find_path(shape, contact, part, path, n, is_converged)
      class(shape_t), intent(in) :: shape
      type(contact_t), intent(in) :: contact
      !> By how much the load falls, > 0.
      real(dp), intent(in) :: part
      !> Receives the stretches, the first `n` of them.
      type(slip_stretch_t), intent(out) :: path(most_stretches)
      integer, intent(out) :: n
      logical, intent(out) :: is_converged
      real(dp) :: remaining, outer, fall

      n = 1
      remaining = part
      path(1)%is_beyond = contact%is_beyond
      path(1)%high = contact%u
      path(1)%start = contact%spot
      if (contact%is_beyond .and. shape%inner_rise() > 0) then
         call integrate_stretch(shape, path(1), contact%u, outer, fall)
         if (outer < part) then
            ! the path goes on within the corner
            path(1)%length = contact%u
            path(1)%fall = fall
            n = 2
            path(2)%is_beyond = .false.
            path(2)%high = shape%corner
            path(2)%before = fall
            call shape%evaluate(shape%corner, .false., path(2)%start)
            remaining = part - outer
         end if
      end if
      call find_length(shape, path(n), remaining, is_converged)
   end subroutine find_path

   !> The length of a stretch along which the load falls by a part. The fall of the load is concave where the load rises ever faster
   !> with u, as it does along all shapes, so Newton's method comes from below; steps are those of a parabola where it has a root.
   pure subroutine find_length(shape, stretch, part, is_converged)
      class(shape_t), intent(in) :: shape
      !> In: where the stretch begins. Out: with its length, its end and the fall of g.
      type(slip_stretch_t), intent(inout) :: stretch
      real(dp), intent(in) :: part
      logical, intent(out) :: is_converged
      ! what this step leaves, its third power, is round-off
      real(dp), parameter :: small_step = 1.0e-6_dp
      integer, parameter :: most_steps = 100
      real(dp) :: length, load, slope, rate, square, step
      integer :: k

      length = 0
      load = 0
      stretch%finish = stretch%start
      do k = 1, most_steps
         slope = 2*stretch%finish%radius*stretch%finish%depth_slope
         is_converged = slope > 0
         if (.not. is_converged) exit
         rate = stretch%finish%depth_slope
         square = 1 - 4*(stretch%finish%radius_slope*rate + stretch%finish%radius*stretch%finish%depth_curve) &
            & *((part - load)/slope/slope)
         step = (part - load)/slope
         if (square > 0) step = 2*step/(1 + sqrt(square))
         if (length + step >= stretch%high) step = (stretch%high - length)/2
         length = length + step
         call shape%evaluate(stretch%high - length, stretch%is_beyond, stretch%finish)
         is_converged = abs(step) <= small_step*length
         if (is_converged) stretch%fall = stretch%fall + step*(rate + stretch%finish%depth_slope)/2
         if (is_converged) exit
         call integrate_stretch(shape, stretch, length, load, stretch%fall)
      end do
      stretch%length = length
   end subroutine find_length

   !> What load and g lose along the beginning of a stretch: integrals where it is short, else differences.
   pure subroutine integrate_stretch(shape, stretch, length, load, fall)
      class(shape_t), intent(in) :: shape
      type(slip_stretch_t), intent(in) :: stretch
      !> Length of the beginning in u.
      real(dp), intent(in) :: length
      !> Receive the losses.
      real(dp), intent(out) :: load, fall
      type(spot_t) :: spot
      integer :: node

      if (.not. is_short(shape, stretch, length)) then
         call shape%evaluate(stretch%high - length, stretch%is_beyond, spot)
         load = stretch%start%load - spot%load
         fall = stretch%start%depth - spot%depth
         return
      end if
      load = 0
      fall = 0
      do node = 1, size(gauss_nodes_6)
         call shape%evaluate(stretch%high - length*(1 + gauss_nodes_6(node))/2, stretch%is_beyond, spot)
         associate (part => gauss_weights_6(node)*length/2*spot%depth_slope)
            fall = fall + part
            load = load + 2*spot%radius*part
         end associate
      end do
   end subroutine integrate_stretch

   !> Is the beginning of a stretch short?
   pure logical function is_short(shape, stretch, length)
      class(shape_t), intent(in) :: shape
      type(slip_stretch_t), intent(in) :: stretch
      real(dp), intent(in) :: length

      is_short = length < short*hypot(stretch%high, merge(shape%corner, 0.0_dp, stretch%is_beyond))
   end function is_short

   !> int [g(s) - g(e)] [g(a) - g(s)] ds along the path.
   pure real(dp) function energy_of(shape, path) result(energy)
      class(shape_t), intent(in) :: shape
      type(slip_stretch_t), intent(in) :: path(:)
      type(spot_t) :: spot
      real(dp) :: fall, total
      integer :: k, node

      energy = 0
      total = path(size(path))%before + path(size(path))%fall
      do k = 1, size(path)
         if (is_short(shape, path(k), path(k)%length)) then
            energy = energy + short_energy(shape, path(k), total)
            cycle
         end if
         do node = 1, size(gauss_nodes)
            call shape%evaluate(path(k)%high - path(k)%length*(1 + gauss_nodes(node))/2, path(k)%is_beyond, spot)
            fall = path(k)%before + (path(k)%start%depth - spot%depth)
            energy = energy + gauss_weights(node)*path(k)%length/2*spot%radius_slope*fall*(total - fall)
         end do
      end do
   end function energy_of

   !> The same along a short stretch, where depths are integrals of their slopes at the same nodes.
   pure real(dp) function short_energy(shape, stretch, total) result(energy)
      class(shape_t), intent(in) :: shape
      type(slip_stretch_t), intent(in) :: stretch
      !> g(a) - g(e).
      real(dp), intent(in) :: total
      type(spot_t) :: spots(size(gauss_nodes_10))
      real(dp) :: falls(size(gauss_nodes_10))
      integer :: node

      do node = 1, size(gauss_nodes_10)
         call shape%evaluate(stretch%high - stretch%length*(1 + gauss_nodes_10(node))/2, stretch%is_beyond, spots(node))
      end do
      falls = stretch%before + stretch%length/2*matmul(gauss_integrals_10, spots%depth_slope)
      energy = stretch%length/2*sum(gauss_weights_10*spots%radius_slope*falls*(total - falls))
   end function short_energy

end module adfric_round_slip

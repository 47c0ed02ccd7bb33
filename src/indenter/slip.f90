! SPDX-License-Identifier: GPL-3.0-or-later
!> Partial slip of an indenter of any axisymmetric shape without adhesion: under a constant load P a tangential force T has grown from 0,
!> up to Coulomb's friction mu P (J. Jaeger, Arch. Appl. Mech. 63, 1993, 402; M. Ciavarella, J. Appl. Mech. 65, 1998, 998), reduced.
!>
!> The shear traction is mu [p(.; a) - p(.; e)], e the radius of the contact of the load P* = P - T/mu, which sticks. With m the ratio of
!> the tangential to the normal compliance,
!>
!>     u = mu m [g(a) - g(e)],   dT/du = 2 e/m,   W = 8 mu^2 m int [g(s) - g(e)] [g(a) - g(s)] ds,  e < s < a
!>
!> W being the energy of a cycle between T and -T. Where little slips, radii and depths are close together: the way from a down to e
!> is then found from P - P* = int 2 a dg along it, and all else by integrals along it, none of which has a term below 0. Where much
!> slips, W = 8 mu^2 m [(P + P*) (delta - delta*)/2 - (U - U*)], U the elastic energy.
module adfric_indenter_slip
   use adfric_base_kinds, only: dp
   use adfric_indenter_contact, only: branch_stable, contact_t, find_contact, survey_t
   use adfric_indenter_curve, only: control_load, curve_t
   use adfric_indenter_shape, only: shape_t, spot_t
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   implicit none (type, external)
   private
   public :: indenter_slip_t, find_indenter_slip

   !> From this share of mu P on differences have the digits.
   real(dp), parameter :: large_share = 0.5_dp
   !> Below this share of u a stretch is short: depths along it are integrals.
   real(dp), parameter :: short = 0.1_dp
   !> Most stretches of a way: one on either side of the corner.
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

   !> A stretch of the way from a down to e, where u falls.
   type :: stretch_t
      !> Does it lie beyond the corner?
      logical :: is_beyond = .true.
      !> Its largest u, and its length in u.
      real(dp) :: high = 0, length = 0
      !> How much g falls before it, and along it.
      real(dp) :: before = 0, fall = 0
   end type stretch_t

contains

   !> The slip of a contact without adhesion.
   pure subroutine find_indenter_slip(curve, survey, contact, tau, slip, is_converged)
      !> The curve of the indenter.
      class(curve_t), intent(in) :: curve
      !> Its survey.
      type(survey_t), intent(in) :: survey
      !> The contact, of a load > 0.
      type(contact_t), intent(in) :: contact
      !> T/(mu P), 0 to 1.
      real(dp), intent(in) :: tau
      !> Receives the slip.
      type(indenter_slip_t), intent(out) :: slip
      !> Was it found to round-off?
      logical, intent(out) :: is_converged
      type(stretch_t) :: way(most_stretches)
      integer :: n

      call find_contact(curve, survey, control_load, contact%load*(1 - tau), .true., branch_stable, slip%stick)
      is_converged = slip%stick%is_found .and. slip%stick%is_converged
      slip%ratio = min(slip%stick%spot%radius/contact%spot%radius, 1.0_dp)
      if (curve%shape%n_pieces == 0) then
         ! the whole face sticks
         slip%fall = tau*contact%load/2
      else if (tau >= large_share) then
         slip%fall = contact%approach - slip%stick%approach
         slip%energy = (contact%load + slip%stick%load)*slip%fall/2 - (curve%shape%energy(contact%u, contact%is_beyond) &
            & - curve%shape%energy(slip%stick%u, slip%stick%is_beyond))
      else if (tau > 0) then
         call find_way(curve%shape, contact, tau*contact%load, way, n, is_converged)
         slip%fall = way(n)%before + way(n)%fall
         slip%energy = energy_of(curve%shape, way(:n))
      end if
   end subroutine find_indenter_slip

   !> The way along which the load falls by a part of itself.
   pure subroutine find_way(shape, contact, part, way, n, is_converged)
      !> The shape of the indenter.
      class(shape_t), intent(in) :: shape
      !> The contact where the way begins.
      type(contact_t), intent(in) :: contact
      !> By how much the load falls, > 0.
      real(dp), intent(in) :: part
      !> Receives the stretches, the first `n` of them.
      type(stretch_t), intent(out) :: way(most_stretches)
      !> Receives their number.
      integer, intent(out) :: n
      !> Was the end found to round-off?
      logical, intent(out) :: is_converged
      real(dp) :: left, outer, fall

      n = 1
      left = part
      way(1)%is_beyond = contact%is_beyond
      way(1)%high = contact%u
      if (contact%is_beyond .and. shape%inner_rise() > 0) then
         call integrate_stretch(shape, way(1), contact%u, outer, fall)
         if (outer < part) then
            ! the way goes on within the corner
            way(1)%length = contact%u
            way(1)%fall = fall
            n = 2
            way(2)%is_beyond = .false.
            way(2)%high = shape%corner
            way(2)%before = fall
            left = part - outer
         end if
      end if
      call find_length(shape, way(n), left, is_converged)
   end subroutine find_way

   !> The length of a stretch along which the load falls by a part. The fall of the load is concave where the load rises ever faster
   !> with u, as it does along all shapes, so Newton's method comes from below.
   pure subroutine find_length(shape, stretch, part, is_converged)
      !> The shape of the indenter.
      class(shape_t), intent(in) :: shape
      !> In: where the stretch begins. Out: with its length and the fall of g.
      type(stretch_t), intent(inout) :: stretch
      !> By how much the load falls, > 0.
      real(dp), intent(in) :: part
      !> Was it found to round-off?
      logical, intent(out) :: is_converged
      integer, parameter :: most_steps = 100
      type(spot_t) :: spot
      real(dp) :: length, load, slope, step
      integer :: k

      length = 0
      load = 0
      do k = 1, most_steps
         call shape%evaluate(stretch%high - length, stretch%is_beyond, spot)
         slope = 2*spot%radius*spot%depth_slope
         is_converged = slope > 0
         if (.not. is_converged) exit
         step = (part - load)/slope
         if (length + step >= stretch%high) step = (stretch%high - length)/2
         length = length + step
         is_converged = abs(step) <= 4*epsilon(step)*length
         call integrate_stretch(shape, stretch, length, load, stretch%fall)
         if (is_converged) exit
      end do
      stretch%length = length
   end subroutine find_length

   !> What load and g lose along the beginning of a stretch.
   pure subroutine integrate_stretch(shape, stretch, length, load, fall)
      !> The shape of the indenter.
      class(shape_t), intent(in) :: shape
      !> The stretch, for its beginning.
      type(stretch_t), intent(in) :: stretch
      !> Length of the beginning in u.
      real(dp), intent(in) :: length
      !> Receive the losses.
      real(dp), intent(out) :: load, fall
      type(spot_t) :: spot
      integer :: node

      load = 0
      fall = 0
      do node = 1, size(gauss_nodes)
         call shape%evaluate(stretch%high - length*(1 + gauss_nodes(node))/2, stretch%is_beyond, spot)
         associate (part => gauss_weights(node)*length/2*spot%depth_slope)
            fall = fall + part
            load = load + 2*spot%radius*part
         end associate
      end do
   end subroutine integrate_stretch

   !> int [g(s) - g(e)] [g(a) - g(s)] ds along the way.
   pure real(dp) function energy_of(shape, way) result(energy)
      !> The shape of the indenter.
      class(shape_t), intent(in) :: shape
      !> The stretches, from a down to e.
      type(stretch_t), intent(in) :: way(:)
      type(spot_t) :: start, spot
      real(dp) :: length, load, fall, total
      integer :: k, node

      energy = 0
      total = way(size(way))%before + way(size(way))%fall
      do k = 1, size(way)
         call shape%evaluate(way(k)%high, way(k)%is_beyond, start)
         do node = 1, size(gauss_nodes)
            length = way(k)%length*(1 + gauss_nodes(node))/2
            call shape%evaluate(way(k)%high - length, way(k)%is_beyond, spot)
            fall = start%depth - spot%depth
            if (way(k)%length < short*way(k)%high) call integrate_stretch(shape, way(k), length, load, fall)
            fall = way(k)%before + fall
            energy = energy + gauss_weights(node)*way(k)%length/2*spot%radius_slope*fall*(total - fall)
         end do
      end do
   end function energy_of

end module adfric_indenter_slip

! SPDX-License-Identifier: GPL-3.0-or-later
!> Brittle peeling of an indenter that adheres by JKR and sticks without limit, under a load P and a tangential force T (A. R. Savkoor,
!> G. A. D. Briggs, Proc. R. Soc. Lond. A 356, 1977, 103), reduced; t^2 = 2 pi W:
!>
!>     N^2 + m T^2 = 4 t^2 a^3,   N = P1(a) - P,   u = m T/(2 a)
!>
!> The energy release of all three modes, its mean around the edge, is W. As T grows from 0 the contact shrinks from that of rest, while
!> T^2 grows as a falls: up to the snap-off, where
!>
!>     k = N - 3 t^2 a/g'
!>
!> has the largest root below the contact of rest. dk/da has the sign of Z - 3 t^2/2, Z = a g'^2/(1 - h), h = a g''/g' (always positive where
!> h >= 1), and Z rises with a: for sums of powers since h rises, for the sphere and the rounded punch since h > 1, for the other kinds
!> beyond the corner, where Z is a function of a/b without parameter (seen by its values over eight decades). Within the tip of a rounded
!> cone h = 1. So beyond the corner k falls and then rises, if it falls at all, and within it rises: there is one root at most to the
!> right of the position where k is least. Where k > 0 down to a face T^2 grows up to its edge, which lets go as a whole.
!>
!> A flat face sticks as a whole until T^2 = (4 t^2 - P^2)/m under tension, and 4 t^2/m under pressure, which does not open its edge.
module adfric_round_brittle_peeling
   use adfric_base_kinds, only: dp
   use adfric_round_contact, only: take_given
   use adfric_round_contact_state, only: contact_t, set_contact
   use adfric_round_curve, only: control_load, curve_t
   use adfric_round_shape, only: spot_t
   use adfric_round_weak_path, only: weaken
   use adfric_numerics_scalar_root, only: equation_t, find_root
   implicit none (type, external)
   private
   public :: brittle_t, new_brittle, find_peeled

   !> A contact that peels.
   type :: brittle_t
      !> The curve of JKR.
      class(curve_t), allocatable :: curve
      !> P, m.
      real(dp) :: load = 0, compliance = 1
      !> The contact at rest.
      type(contact_t) :: rest
      !> The unknown at snap-off, and whether it lies beyond the corner.
      real(dp) :: last = 0
      !> Does it lie beyond the corner?
      logical :: last_is_beyond = .true.
      !> The force of snap-off, and the displacement there.
      real(dp) :: snap_off_force = 0, snap_off_displacement = 0
   end type brittle_t

   !> N - sqrt(4 t^2 a^3 - m T^2) = 0.
   type, extends(equation_t) :: peeled_equation_t
      !> The contact that peels.
      type(brittle_t) :: brittle
      !> Does u lie beyond the corner?
      logical :: is_beyond = .true.
      !> m T^2.
      real(dp) :: pull = 0
   contains
      procedure :: evaluate
   end type peeled_equation_t

contains

   !> A contact at rest, and where it snaps off.
   pure subroutine new_brittle(self, curve, load, compliance, rest)
      type(brittle_t), intent(out) :: self
      class(curve_t), intent(in) :: curve
      !> P.
      real(dp), intent(in) :: load
      !> m.
      real(dp), intent(in) :: compliance
      type(contact_t), intent(in) :: rest
      type(spot_t) :: spot
      real(dp) :: square

      allocate (self%curve, source=curve)
      self%load = load
      self%compliance = compliance
      self%rest = rest
      if (curve%shape%n_pieces == 0) then
         square = 4*curve%tension**2 - min(load, 0.0_dp)**2
         spot%radius = 1
      else
         call find_snap_off(self)
         call curve%shape%evaluate(self%last, self%last_is_beyond, spot)
         square = 4*curve%tension**2*spot%radius**3 - (spot%load - load)**2
      end if
      self%snap_off_force = sqrt(max(square, 0.0_dp)/compliance)
      self%snap_off_displacement = compliance*self%snap_off_force/(2*spot%radius)
   end subroutine new_brittle

   !> The largest root of k below the contact at rest.
   pure subroutine find_snap_off(self)
      !> The contact that peels, which receives the position.
      type(brittle_t), intent(inout) :: self
      real(dp), parameter :: next_to_nothing = 1.0e-9_dp
      real(dp) :: low, high, turn
      logical :: is_beyond

      is_beyond = self%rest%is_beyond
      high = self%rest%u
      if (is_beyond) then
         ! at the corner itself, or without contact, k may have no sign
         low = next_to_nothing*high
         turn = low
         if (rise_of(self, low, .true.) < 0) turn = sign_change(self, low, high, .true., .false.)
         if (reserve_of(self, turn, .true.) < 0) then
            self%last = sign_change(self, turn, high, .true., .true.)
            return
         end if
         ! a face is prescribed down to its edge
         self%last = 0
         if (.not. self%curve%shape%corner > 0 .or. self%curve%shape%has_face) return
         high = self%curve%shape%corner
      end if
      self%last_is_beyond = .false.
      self%last = sign_change(self, next_to_nothing*high, high, .false., .true.)
   end subroutine find_snap_off

   !> k dg/du, > 0 where T^2 grows as a falls.
   pure real(dp) function reserve_of(self, u, is_beyond) result(reserve)
      type(brittle_t), intent(in) :: self
      real(dp), intent(in) :: u
      logical, intent(in) :: is_beyond
      type(spot_t) :: spot

      call self%curve%shape%evaluate(u, is_beyond, spot)
      reserve = (spot%load - self%load)*spot%depth_slope - 3*self%curve%tension**2*spot%radius*spot%radius_slope
   end function reserve_of

   !> What has the sign of dk/da: (2 a g'^3 - 3 t^2 (g' - a g'')) (da/du)^3.
   pure real(dp) function rise_of(self, u, is_beyond) result(rise)
      type(brittle_t), intent(in) :: self
      real(dp), intent(in) :: u
      logical, intent(in) :: is_beyond
      type(spot_t) :: spot

      call self%curve%shape%evaluate(u, is_beyond, spot)
      associate (a => spot%radius, a_u => spot%radius_slope, g_u => spot%depth_slope)
         rise = 2*a*g_u**3 - 3*self%curve%tension**2*(g_u*a_u**2 - a*(spot%depth_curve*a_u - g_u*spot%radius_curve))
      end associate
   end function rise_of

   !> Where k or its derivative becomes positive: halving, in the logarithm where that is possible. The upper end if it does not.
   pure real(dp) function sign_change(self, first, last, is_beyond, is_of_reserve) result(position)
      type(brittle_t), intent(in) :: self
      !> The ends.
      real(dp), intent(in) :: first, last
      logical, intent(in) :: is_beyond
      !> Is it k that changes its sign?
      logical, intent(in) :: is_of_reserve
      integer, parameter :: most_steps = 200
      real(dp) :: low, high, value
      integer :: k

      low = first
      high = last
      do k = 1, most_steps
         if (high - low <= 2*epsilon(high)*high) exit
         position = low + (high - low)/2
         if (low < 0.1_dp*high) position = max(sqrt(low)*sqrt(high), 1.0e-3_dp*high)
         if (is_of_reserve) then
            value = reserve_of(self, position, is_beyond)
         else
            value = rise_of(self, position, is_beyond)
         end if
         if (value < 0) low = position
         if (.not. value < 0) high = position
      end do
      position = high
   end function sign_change

   !> The contact under a force.
   pure subroutine find_peeled(self, force, contact, ratio, stiffness, is_converged)
      type(brittle_t), intent(in) :: self
      !> T, from 0 to that of snap-off.
      real(dp), intent(in) :: force
      type(contact_t), intent(out) :: contact
      !> Receives N^2/(4 t^2 a^3), the share of the energy release that opens the edge.
      real(dp), intent(out) :: ratio
      !> Receives dT/du, while T grows.
      real(dp), intent(out) :: stiffness
      logical, intent(out) :: is_converged
      type(peeled_equation_t) :: equation
      class(curve_t), allocatable :: curve
      real(dp) :: low, high, u, value, slope

      contact = self%rest
      is_converged = .true.
      ratio = 1 - self%compliance*force**2/(4*self%curve%tension**2)
      stiffness = 2/self%compliance
      if (self%curve%shape%n_pieces == 0) return
      equation%brittle = self
      equation%pull = self%compliance*force**2
      equation%is_beyond = self%rest%is_beyond
      high = self%rest%u
      low = 0
      if (equation%is_beyond .and. .not. self%last_is_beyond) then
         call equation%evaluate(0.0_dp, value, slope)
         equation%is_beyond = .not. value > 0
         if (value > 0) high = self%curve%shape%corner
      end if
      if (equation%is_beyond .eqv. self%last_is_beyond) low = min(self%last, high)
      u = high
      if (force > 0 .and. low < high) then
         call find_root(equation, low*(1 - 4*epsilon(low)), high*(1 + 4*epsilon(high)), .true., u, is_converged)
         u = min(max(u, low), high)
      end if
      call self%curve%shape%evaluate(u, equation%is_beyond, contact%spot)
      associate (spot => contact%spot)
         ratio = 1 - equation%pull/(4*self%curve%tension**2*spot%radius**3)
         value = 12*self%curve%tension**2*spot%radius**2*spot%radius_slope - 4*(spot%load - self%load)*spot%radius*spot%depth_slope
         ! du = m (dT - T da/a)/2a
         stiffness = 2*spot%radius/self%compliance/(1 + 2*equation%pull*spot%radius_slope/(spot%radius*max(-value, tiny(value))))
      end associate
      if (.not. force > 0) return
      allocate (curve, source=self%curve)
      call weaken(curve, max(ratio, 0.0_dp))
      call set_contact(curve, control_load, u, equation%is_beyond, contact)
      contact%is_found = .true.
      contact%is_stable = .true.
      call take_given(curve, control_load, self%load, contact)
   end subroutine find_peeled

   !> See `equation_t`.
   pure subroutine evaluate(self, x, value, slope)
      class(peeled_equation_t), intent(in) :: self
      real(dp), intent(in) :: x
      real(dp), intent(out) :: value
      !> Its derivative by u.
      real(dp), intent(out) :: slope
      type(spot_t) :: spot
      real(dp) :: square, root

      call self%brittle%curve%shape%evaluate(x, self%is_beyond, spot)
      square = 4*self%brittle%curve%tension**2*spot%radius**3 - self%pull
      root = sqrt(max(square, 0.0_dp))
      value = spot%load - self%brittle%load - root
      slope = 2*spot%radius*spot%depth_slope
      if (root > 0) slope = slope - 6*self%brittle%curve%tension**2*spot%radius**2*spot%radius_slope/root
   end subroutine evaluate

end module adfric_round_brittle_peeling

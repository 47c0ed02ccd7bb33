! SPDX-License-Identifier: GPL-3.0-or-later
!> The curve of equilibrium of an indenter with adhesion, and where it is stable (JKR for any profile; D. Maugis, M. Barquins,
!> J. Phys. D 11, 1978, 1989), reduced:
!>
!>     Dl = sqrt(2 pi W a),   delta = g(a) - Dl,   P = P1(a) - 2 a Dl
!>
!> A state is stable where a g' > q Dl, q = 3/2 under a given load and 1/2 at a given approach. In each piece of a shape
!> sqrt(a) g'(a) rises or falls, so each piece has at most one fold, which is bracketed by its ends: no fold is missed.
!> Within a flat face g' = 0, so all contacts there are unstable.
!>
!> A spring of compliance s between the indenter and a base that is prescribed at delta + s P has q = (1 + 3 y)/(2 (1 + y)), y = 2 s
!> a (`adfric_round_spring_pieces` divides its pieces).
module adfric_round_curve
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_round_shape, only: piece_t, shape_t, spot_t
   use adfric_round_spring_pieces, only: divide_pieces, most_divided_pieces
   use adfric_numerics_scalar_root, only: equation_t, find_root
   implicit none (type, external)
   private
   public :: curve_t, state_t, curve_interval_t, stability_control, get_stability_factor
   public :: control_load, control_approach, control_spring, control_radius, most_intervals, endless, at_corner, disc_range_t, &
      & most_disc_ranges

   !> What is prescribed; that of a spring is the approach of its base.
   integer, parameter :: control_load = 1, control_approach = 2, control_spring = 3, control_radius = 4
   !> Most intervals of a curve; in JKR each piece has at most one fold, so there are ten, and one within a face.
   integer, parameter :: most_intervals = 16
   !> Most ranges of discs that are stable.
   integer, parameter :: most_disc_ranges = 3
   !> End of an interval that has none, and the corner of a flat face as seen from within, where u has none.
   real(dp), parameter :: endless = huge(1.0_dp), at_corner = 1.0e30_dp

   !> A state of the curve.
   type :: state_t
      !> What the shape is there.
      type(spot_t) :: spot
      !> Load P and approach delta.
      real(dp) :: load = 0, approach = 0
      !> Their derivatives by u.
      real(dp) :: load_slope = 0, approach_slope = 0
      !> dP/ddelta along the curve; NaN where the approach is least.
      real(dp) :: stiffness = 0
      !> g(a) - delta, the depth of the flat punch of radius a that adhesion adds.
      real(dp) :: neck = 0
      !> Radius c up to which adhesion acts, and its stress there; 0 where it acts in the contact alone.
      real(dp) :: adhesion_radius = 0, stress = 0
      !> Sizes of the terms of load and approach of a disc without touch; 0 of a contact, where they follow from the others.
      real(dp) :: disc_terms(2) = 0
      !> Is the state stable under a given load, at a given approach, and on a spring?
      logical :: is_stable(3) = .true.
      !> Was it found to round-off?
      logical :: is_converged = .true.
   end type state_t

   !> A curve of equilibrium.
   type :: curve_t
      !> The shape of the indenter.
      class(shape_t), allocatable :: shape
      !> sqrt(2 pi W), so that Dl = tension*sqrt(a); 0 without adhesion and in DMT.
      real(dp) :: tension = 0
      !> What adhesion outside the contact takes from the load (DMT); else 0.
      real(dp) :: outer_pull = 0
      !> Compliance of the spring that holds the indenter, E* L/k; of no meaning in another control.
      real(dp) :: compliance = 0
   contains
      procedure :: get_state
      procedure :: get_prescribed
      procedure :: get_sums
      procedure :: find_intervals
      procedure :: find_discs
      procedure :: get_disc
   end type curve_t

   !> Radii of discs of adhesion without touch that are stable; what is prescribed rises with the radius.
   type :: disc_range_t
      !> Ends of the range.
      real(dp) :: low = 0, high = 0
      !> Does the largest disc touch, so that the contacts follow? Else it is a fold.
      logical :: touches = .false.
   end type disc_range_t

   !> A part of the curve where all states are stable, or all are unstable. Along it what is prescribed rises, or falls.
   type :: curve_interval_t
      !> Does it lie beyond the corner?
      logical :: is_beyond = .true.
      !> Are its states stable?
      logical :: is_stable = .true.
      !> Is its beginning, or its end, a fold?
      logical :: begins_at_fold = .false., ends_at_fold = .false.
      !> Range of the unknown u; `endless` without an end.
      real(dp) :: low = 0, high = endless
      !> What is prescribed at the ends, see `adfric_round_prescribed`.
      real(dp) :: first = 0, last = 0
   end type curve_interval_t

   !> sqrt(a) g_u - q sqrt(2 pi W) a_u = 0.
   type, extends(equation_t) :: fold_equation_t
      !> The curve.
      class(curve_t), allocatable :: curve
      !> What is prescribed.
      integer :: control = control_load
      !> Does u lie beyond the corner?
      logical :: is_beyond = .true.
   contains
      procedure :: evaluate => evaluate_fold
   end type fold_equation_t

contains

   !> The state at an unknown.
   pure subroutine get_state(self, u, is_beyond, state)
      class(curve_t), intent(in) :: self
      !> The unknown, >= 0.
      real(dp), intent(in) :: u
      logical, intent(in) :: is_beyond
      type(state_t), intent(out) :: state
      real(dp) :: gain, loss

      associate (spot => state%spot)
         call self%shape%evaluate(u, is_beyond, spot)
         state%neck = self%tension*sqrt(spot%radius)
         state%adhesion_radius = spot%radius
         call sum_terms(self, spot, state%load, state%load_slope, state%approach, state%approach_slope)
         ! dP/ddelta = 2 a (a g' - 3 Dl/2)/(a g' - Dl/2)
         gain = spot%radius*spot%depth_slope
         loss = state%neck*spot%radius_slope
         state%stiffness = 2*spot%radius
         if (abs(gain - loss/2) > 0) then
            state%stiffness = state%stiffness*((gain - 1.5_dp*loss)/(gain - loss/2))
         else if (loss > 0) then
            state%stiffness = not_a_number()
         end if
         state%is_stable(control_load) = is_stable_at(self, spot, control_load)
         state%is_stable(control_approach) = is_stable_at(self, spot, control_approach)
         state%is_stable(control_spring) = is_stable_at(self, spot, control_spring)
      end associate
   end subroutine get_state

   !> What is prescribed, and its derivative by u.
   pure subroutine get_prescribed(self, control, u, is_beyond, prescribed, slope)
      class(curve_t), intent(in) :: self
      integer, intent(in) :: control
      real(dp), intent(in) :: u
      logical, intent(in) :: is_beyond
      !> Load, approach, or approach of the base of the spring, reduced.
      real(dp), intent(out) :: prescribed
      !> Derivative by u; of no meaning at a radius of 0.
      real(dp), intent(out) :: slope
      real(dp) :: load, load_slope

      call self%get_sums(u, is_beyond, load, load_slope, prescribed, slope)
      if (control == control_load) then
         prescribed = load
         slope = load_slope
      else if (control == control_spring) then
         prescribed = prescribed + self%compliance*load
         slope = slope + self%compliance*load_slope
      end if
   end subroutine get_prescribed

   !> Load and approach at an unknown, and their derivatives by u, which take less time than a state.
   pure subroutine get_sums(self, u, is_beyond, load, load_slope, approach, approach_slope)
      class(curve_t), intent(in) :: self
      real(dp), intent(in) :: u
      logical, intent(in) :: is_beyond
      !> Receive the load and its derivative.
      real(dp), intent(out) :: load, load_slope
      !> Receive the approach and its derivative.
      real(dp), intent(out) :: approach, approach_slope
      type(spot_t) :: spot

      call self%shape%evaluate(u, is_beyond, spot)
      call sum_terms(self, spot, load, load_slope, approach, approach_slope)
   end subroutine get_sums

   !> Load and approach at a spot, and their derivatives by u.
   pure subroutine sum_terms(curve, spot, load, load_slope, approach, approach_slope)
      class(curve_t), intent(in) :: curve
      type(spot_t), intent(in) :: spot
      real(dp), intent(out) :: load, load_slope, approach, approach_slope
      real(dp) :: root

      root = sqrt(spot%radius)
      load = spot%load - 2*spot%radius*(curve%tension*root) - curve%outer_pull
      approach = spot%depth - curve%tension*root
      load_slope = 2*root*(root*spot%depth_slope - 1.5_dp*curve%tension*spot%radius_slope)
      approach_slope = spot%depth_slope
      if (root > 0) approach_slope = spot%depth_slope - curve%tension*spot%radius_slope/(2*root)
   end subroutine sum_terms

   !> The states without touch that are stable, as ranges of their radii: a theory without range has none.
   pure subroutine find_discs(self, control, discs, n)
      class(curve_t), intent(in) :: self
      integer, intent(in) :: control
      !> Receives the ranges, from the smallest discs to the largest.
      type(disc_range_t), intent(out) :: discs(most_disc_ranges)
      integer, intent(out) :: n

      n = 0
      associate (unused => self, unused_too => control, unused_ranges => discs)
      end associate
   end subroutine find_discs

   !> A state without touch; a theory without range has none.
   pure subroutine get_disc(self, c, state)
      class(curve_t), intent(in) :: self
      !> Radius of the disc, >= 0.
      real(dp), intent(in) :: c
      type(state_t), intent(out) :: state

      associate (unused => self, unused_too => c)
      end associate
      state%is_converged = .false.
   end subroutine get_disc

   !> The control whose stability a state has: a given radius counts as a given load.
   elemental integer function stability_control(control)
      integer, intent(in) :: control

      stability_control = merge(control_load, control, control == control_radius)
   end function stability_control

   !> q of a control, and its derivative by a: a state is stable where a g' > q Dl.
   pure subroutine get_stability_factor(curve, control, radius, factor, slope)
      class(curve_t), intent(in) :: curve
      !> What is prescribed; a given radius counts as a given load.
      integer, intent(in) :: control
      !> Radius a of contact.
      real(dp), intent(in) :: radius
      !> q, and dq/da.
      real(dp), intent(out) :: factor, slope
      real(dp) :: y

      slope = 0
      factor = merge(0.5_dp, 1.5_dp, control == control_approach)
      if (control /= control_spring) return
      y = 2*curve%compliance*radius
      factor = (1 + 3*y)/(2*(1 + y))
      slope = 2*curve%compliance/(1 + y)**2
   end subroutine get_stability_factor

   !> Is the state at a spot stable?
   pure logical function is_stable_at(curve, spot, control)
      class(curve_t), intent(in) :: curve
      type(spot_t), intent(in) :: spot
      integer, intent(in) :: control
      real(dp) :: target, factor, slope

      call get_stability_factor(curve, control, spot%radius, factor, slope)
      target = factor*curve%tension
      is_stable_at = .true.
      if (.not. target > 0) return
      if (spot%radius_slope > 0) then
         is_stable_at = sqrt(spot%radius)*spot%depth_slope > target*spot%radius_slope
      else
         ! the corner: sqrt(a) g' is infinite, or what it is from within
         is_stable_at = spot%depth_slope > 0 .or. curve%shape%inner_rise() > target
      end if
   end function is_stable_at

   !> The stable and the unstable parts of the curve, from the smallest contacts to the largest.
   pure subroutine find_intervals(self, control, intervals, n, is_converged)
      class(curve_t), intent(in) :: self
      integer, intent(in) :: control
      type(curve_interval_t), intent(out) :: intervals(most_intervals)
      integer, intent(out) :: n
      !> Have all folds been found to round-off?
      logical, intent(out) :: is_converged
      type(piece_t) :: pieces(most_divided_pieces)
      integer :: k, n_pieces

      n = 0
      is_converged = .true.
      ! within a flat face g' = 0, and what adhesion holds falls with the contact
      if (self%shape%has_face .and. self%tension > 0) then
         n = 1
         intervals(n) = curve_interval_t(.false., .false., .false., .false., 0.0_dp, at_corner)
      end if
      n_pieces = self%shape%n_pieces
      if (n_pieces == 0) return
      pieces(:n_pieces) = self%shape%pieces(:n_pieces)
      if (control == control_spring) call divide_pieces(self%shape, self%compliance, pieces, n_pieces)
      do k = 1, n_pieces
         call split_piece(self, control, pieces(k), intervals, n, is_converged)
      end do
   end subroutine find_intervals

   !> Add the intervals of a piece.
   pure subroutine split_piece(curve, control, piece, intervals, n, is_converged)
      class(curve_t), intent(in) :: curve
      integer, intent(in) :: control
      type(piece_t), intent(in) :: piece
      !> The intervals; those of the piece are added.
      type(curve_interval_t), intent(inout) :: intervals(:)
      integer, intent(inout) :: n
      !> Becomes false if a fold is not found to round-off.
      logical, intent(inout) :: is_converged
      type(spot_t) :: spot
      real(dp) :: high, fold, largest
      logical :: is_stable, ends_stable, is_found

      call curve%shape%evaluate(piece%low, piece%is_beyond, spot)
      is_stable = is_stable_at(curve, spot, control)
      high = piece%high
      ends_stable = .true.
      if (high < endless) then
         call curve%shape%evaluate(high, piece%is_beyond, spot)
         ends_stable = is_stable_at(curve, spot, control)
      end if
      n = n + 1
      intervals(n) = curve_interval_t(piece%is_beyond, is_stable, .false., .false., piece%low, piece%high)
      if (is_stable .eqv. ends_stable) return
      largest = merge(0.5_dp, 1.5_dp, control == control_approach)
      if (.not. high < endless) high = max(2*piece%low, curve%shape%get_end(largest*curve%tension))
      call find_fold(curve, control, piece%is_beyond, piece%low, high, ends_stable, fold, is_found)
      is_converged = is_converged .and. is_found
      intervals(n)%high = fold
      intervals(n)%ends_at_fold = .true.
      n = n + 1
      intervals(n) = curve_interval_t(piece%is_beyond, ends_stable, .true., .false., fold, piece%high)
   end subroutine split_piece

   !> The fold between two indices of a piece.
   pure subroutine find_fold(curve, control, is_beyond, low, high, rises, fold, is_converged)
      class(curve_t), intent(in) :: curve
      integer, intent(in) :: control
      !> Does the piece lie beyond the corner?
      logical, intent(in) :: is_beyond
      !> Ends of the bracket.
      real(dp), intent(in) :: low, high
      !> Does sqrt(a) g'/q rise along the piece?
      logical, intent(in) :: rises
      !> Receives the unknown u of the fold.
      real(dp), intent(out) :: fold
      logical, intent(out) :: is_converged
      real(dp), parameter :: near_end = 1.0_dp - 1.0e-6_dp
      type(fold_equation_t) :: equation

      allocate (equation%curve, source=curve)
      equation%control = control
      equation%is_beyond = is_beyond
      ! that of a single power
      fold = high*near_end
      call find_root(equation, low, high, rises, fold, is_converged)
   end subroutine find_fold

   !> See `equation_t`.
   pure subroutine evaluate_fold(self, x, value, slope)
      class(fold_equation_t), intent(in) :: self
      !> The unknown u, > 0.
      real(dp), intent(in) :: x
      !> sqrt(a) g_u - q sqrt(2 pi W) a_u.
      real(dp), intent(out) :: value
      !> Derivative of the value by u.
      real(dp), intent(out) :: slope
      type(spot_t) :: spot
      real(dp) :: root, factor, factor_slope

      call self%curve%shape%evaluate(x, self%is_beyond, spot)
      call get_stability_factor(self%curve, self%control, spot%radius, factor, factor_slope)
      root = sqrt(spot%radius)
      value = root*spot%depth_slope - factor*self%curve%tension*spot%radius_slope
      slope = root*spot%depth_curve + spot%depth_slope*spot%radius_slope/(2*root) &
         & - self%curve%tension*(factor*spot%radius_curve + factor_slope*spot%radius_slope**2)
   end subroutine evaluate_fold

end module adfric_round_curve

! SPDX-License-Identifier: GPL-3.0-or-later
!> A rigid wavy strip that slides on a viscoelastic foundation and adheres to it (Goryacheva, Makhovskaya 2011), with plain
!> numbers or arrays of them.
!>
!> Reduced units: lengths along the surface in periods l, heights and penetrations in the height h of the wave from valley to
!> crest, stresses in h times the stiffness of the foundation. Loads are means over a period, in the unit of stress; friction is in
!> the unit of stress times h/l, for small slopes. Each procedure is elemental and pure, keeps nothing, and may be called by many
!> threads at once.
!>
!> Status: `status_solved` (0), `status_no_equilibrium` (1: no state carries the load, which is an answer), `status_not_converged`
!> (2), `status_bad_argument` (-2). All other results are NaN where the status is not `status_solved`.
module adfric_contact_strip
   use adfric_base_constants, only: pi, two_pi
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_contact_arguments, only: largest_ratio, lies_between, status_bad_argument
   use adfric_describe_status, only: status_no_equilibrium, status_not_converged, status_solved
   use adfric_foundation_crosswise, only: memory_t
   use adfric_foundation_equilibrium, only: equilibrium_t, neighbour_t, solve_load, solve_penetration
   use adfric_foundation_foundation, only: new_foundation
   use adfric_foundation_steady_state, only: branch_adhered, branch_approach
   use adfric_foundation_adhesion, only: edge_continuous, edge_instantaneous
   use adfric_foundation_strip, only: regime_adhesion_only, regime_free
   use adfric_foundation_surface, only: surface_t
   implicit none (type, external)
   private
   public :: solve_strip_load, solve_strip_penetration
   public :: dp, status_solved, status_no_equilibrium, status_not_converged, status_bad_argument

contains

   !> Find the steady state under a load.
   elemental subroutine solve_strip_load(phase, ratio, stress, range, load, penetration, friction, width, shift, status, &
      & is_instantaneous, is_approach)
      !> Relaxation phase 2 pi V Ts/l [-], 0 to 1e30: the speed.
      real(dp), intent(in) :: phase
      !> Ratio Te/Ts of retardation and relaxation time [-], 1 to 1e30; 1 is an elastic foundation.
      real(dp), intent(in) :: ratio
      !> Adhesion stress, 0 to 1e30; 0: no adhesion.
      real(dp), intent(in) :: stress
      !> Range of adhesion, > 0; not used without adhesion.
      real(dp), intent(in) :: range
      !> Load; tension is negative.
      real(dp), intent(in) :: load
      !> Receives the penetration of the crest into the undisturbed foundation.
      real(dp), intent(out) :: penetration
      !> Receives the friction force.
      real(dp), intent(out) :: friction
      !> Receives the width of the contact [l].
      real(dp), intent(out) :: width
      !> Receives the shift of the middle of the contact from the crest [l].
      real(dp), intent(out) :: shift
      !> Receives what has become of the state, see above.
      integer, intent(out) :: status
      !> Does the displacement jump where adhesion begins and ends? It does not if absent.
      logical, intent(in), optional :: is_instantaneous
      !> Is the branch meant where loading arrives, and not that where unloading does? It is not if absent.
      logical, intent(in), optional :: is_approach
      type(surface_t) :: surface
      type(equilibrium_t) :: equilibrium
      type(neighbour_t) :: neighbour
      type(memory_t) :: memory

      status = status_bad_argument
      if (are_good(phase, ratio, stress, range, load)) then
         surface = surface_of(phase, ratio, stress, range, is_instantaneous, is_approach)
         memory%needs_slope = .true.
         call solve_load(surface, load, neighbour, memory, equilibrium)
         status = equilibrium%status
      end if
      penetration = give(equilibrium%penetration, status)
      call read_state(equilibrium, status, friction, width, shift)
   end subroutine solve_strip_load

   !> Find the steady state at a penetration.
   elemental subroutine solve_strip_penetration(phase, ratio, stress, range, penetration, load, friction, width, shift, status, &
      & is_instantaneous, is_approach)
      !> Relaxation phase 2 pi V Ts/l [-], 0 to 1e30: the speed.
      real(dp), intent(in) :: phase
      !> Ratio Te/Ts of retardation and relaxation time [-], 1 to 1e30; 1 is an elastic foundation.
      real(dp), intent(in) :: ratio
      !> Adhesion stress, 0 to 1e30; 0: no adhesion.
      real(dp), intent(in) :: stress
      !> Range of adhesion, > 0; not used without adhesion.
      real(dp), intent(in) :: range
      !> Penetration of the crest into the undisturbed foundation.
      real(dp), intent(in) :: penetration
      !> Receives the load.
      real(dp), intent(out) :: load
      !> Receives the friction force.
      real(dp), intent(out) :: friction
      !> Receives the width of the contact [l].
      real(dp), intent(out) :: width
      !> Receives the shift of the middle of the contact from the crest [l].
      real(dp), intent(out) :: shift
      !> Receives what has become of the state, see above.
      integer, intent(out) :: status
      !> Does the displacement jump where adhesion begins and ends? It does not if absent.
      logical, intent(in), optional :: is_instantaneous
      !> Is the branch meant where loading arrives, and not that where unloading does? It is not if absent.
      logical, intent(in), optional :: is_approach
      type(surface_t) :: surface
      type(equilibrium_t) :: equilibrium
      type(memory_t) :: memory

      status = status_bad_argument
      if (are_good(phase, ratio, stress, range, penetration)) then
         surface = surface_of(phase, ratio, stress, range, is_instantaneous, is_approach)
         memory%is_even = .true.
         call solve_penetration(surface, penetration, memory, equilibrium)
         status = equilibrium%status
      end if
      load = give(equilibrium%totals%load, status)
      call read_state(equilibrium, status, friction, width, shift)
   end subroutine solve_strip_penetration

   !> May these numbers be solved?
   elemental logical function are_good(phase, ratio, stress, range, prescribed)
      real(dp), intent(in) :: phase, ratio, stress, range
      !> Load or penetration.
      real(dp), intent(in) :: prescribed

      are_good = lies_between(phase, 0.0_dp, largest_ratio) .and. lies_between(ratio, 1.0_dp, largest_ratio) &
         & .and. lies_between(stress, 0.0_dp, largest_ratio) .and. lies_between(prescribed, -largest_ratio, largest_ratio)
      if (.not. are_good) return
      if (stress > 0) are_good = lies_between(range, 1/largest_ratio, largest_ratio)
   end function are_good

   !> The surface that is one strip.
   pure type(surface_t) function surface_of(phase, ratio, stress, range, is_instantaneous, is_approach) result(surface)
      real(dp), intent(in) :: phase, ratio, stress, range
      logical, intent(in), optional :: is_instantaneous, is_approach

      call new_foundation(surface%foundation, phase, ratio)
      surface%adhesion%stress = stress
      if (stress > 0) surface%adhesion%range = range
      if (present(is_instantaneous)) surface%adhesion%edge = merge(edge_instantaneous, edge_continuous, is_instantaneous)
      if (present(is_approach)) surface%branch = merge(branch_approach, branch_adhered, is_approach)
   end function surface_of

   !> Friction and contact of a state.
   elemental subroutine read_state(equilibrium, status, friction, width, shift)
      type(equilibrium_t), intent(in) :: equilibrium
      integer, intent(in) :: status
      real(dp), intent(out) :: friction, width, shift

      friction = give(equilibrium%totals%friction, status)
      associate (crest => equilibrium%crest)
         width = 2*crest%half_width
         if (crest%regime == regime_free .or. crest%regime == regime_adhesion_only) width = 0
         shift = give(merge(crest%shift, 0.0_dp, width > 0 .and. crest%half_width < pi)/two_pi, status)
         width = give(width/two_pi, status)
      end associate
   end subroutine read_state

   !> A value of a state that is solved, or else NaN.
   elemental real(dp) function give(value, status)
      !> The value, which has a meaning if the state is solved.
      real(dp), intent(in) :: value
      integer, intent(in) :: status

      give = not_a_number()
      if (status == status_solved) give = value
   end function give

end module adfric_contact_strip

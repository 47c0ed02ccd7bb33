! SPDX-License-Identifier: GPL-3.0-or-later
!> Random strips of each regime with their answers, and what another method's answer is worth.
module strip_cases
   use adfric_base_kinds, only: dp
   use adfric_foundation_balance, only: balance_t, get_balance
   use adfric_foundation_steady_state, only: find_steady_state
   use adfric_foundation_strip, only: strip_t, steady_state_t, regime_adhesion_only, regime_adhesion_zones, regime_saturated
   use plain_edges, only: edges_t, new_edges, edges_of, elastic_edges, state_of_edges, is_possible
   use random_dice, only: dice_t, new_dice
   use trial_strips, only: trial_t, draw_trial, make_strip
   implicit none (type, external)
   private
   public :: case_t, snap, names, elsewhere, from_lengths, from_phases, from_rest, start_names
   public :: collect_cases, start_of, error_of, error_of_edges, load_scale, friction_scale

   !> Regimes as in the strip, and adhesion zones with a snap into contact.
   integer, parameter :: snap = regime_saturated + 1
   character(*), parameter :: names(0:snap) = [character(32) :: 'free', 'adhesion without contact', &
      'contact without adhesion', 'saturated adhesion', 'adhesion zones', 'saturated contact', 'adhesion zones with snap']
   !> Starts of a general solver: the answer's zones with other lengths, its edges at other phases, or a surface at rest.
   integer, parameter :: from_lengths = 1, from_phases = 2, from_rest = 3
   character(*), parameter :: start_names(3) = [character(8) :: 'lengths', 'phases', 'rest']
   !> Distance of the start of a general solver from the answer, and of the neighbour from the strip [h].
   real(dp), parameter :: start_error = 0.1_dp, neighbour = 1.0e-4_dp
   !> A relative error of a force from which on the answer is another one.
   real(dp), parameter :: elsewhere = 0.01_dp

   !> A strip and its answer.
   type :: case_t
      type(trial_t) :: trial
      type(strip_t) :: strip
      type(steady_state_t) :: neighbour, answer
      type(balance_t) :: balance
      type(edges_t) :: edges
      real(dp) :: start(4) = 0
   end type case_t

contains

   !> Random strips whose answer is in a regime.
   subroutine collect_cases(regime, cases)
      integer, intent(in) :: regime
      type(case_t), intent(out) :: cases(:)
      type(dice_t) :: dice
      type(strip_t) :: strip
      integer :: k, j, found

      call new_dice(dice, 1)
      k = 1
      do while (k <= size(cases))
         associate (c => cases(k))
            call draw_trial(dice, c%trial)
            call make_strip(c%trial, 0.0_dp, c%strip)
            call find_steady_state(c%strip, c%trial%branch, c%answer)
            found = c%answer%regime
            if (found == regime_adhesion_zones .and. c%answer%entry > 0) found = snap
            ! adhesion in the whole gap has no edges, an elastic foundation no Maxwell arm to time stepping
            if (found /= regime .or. c%trial%beta <= 1) cycle
            if (regime == regime_adhesion_only .and. c%answer%half_width >= 3.14_dp) cycle
            call make_strip(c%trial, neighbour, strip)
            call find_steady_state(strip, c%trial%branch, c%neighbour)
            call get_balance(c%strip, c%answer, c%balance)
            call new_edges(c%edges, c%strip, c%answer)
            do j = 1, size(c%start)
               call dice%between(-start_error, start_error, c%start(j))
            end do
         end associate
         k = k + 1
      end do
   end subroutine collect_cases

   !> A start of a general solver.
   pure function start_of(c, kind_of_start) result(x)
      type(case_t), intent(in) :: c
      integer, intent(in) :: kind_of_start
      real(dp) :: x(c%edges%n)

      select case (kind_of_start)
      case (from_lengths)
         x = edges_of(c%edges, c%answer, c%start)
      case (from_phases)
         x = edges_of(c%edges, c%answer, spread(0.0_dp, 1, 4))*(1 + c%start(:c%edges%n))
      case default
         x = elastic_edges(c%edges)
      end select
   end function start_of

   !> The error of forces, relative to the sizes of their terms.
   pure real(dp) function error_of(c, load, friction)
      type(case_t), intent(in) :: c
      real(dp), intent(in) :: load, friction

      error_of = max(abs(load - c%balance%load)/load_scale(c), abs(friction - c%balance%friction)/friction_scale(c))
   end function error_of

   !> The error of the forces that belong to edges, and whether these are possible at all.
   pure subroutine error_of_edges(c, x, error, is_admissible)
      type(case_t), intent(in) :: c
      real(dp), intent(in) :: x(:)
      !> 0 where the edges are impossible.
      real(dp), intent(out) :: error
      logical, intent(out) :: is_admissible
      type(steady_state_t) :: state
      type(balance_t) :: balance

      error = 0
      state = state_of_edges(c%edges, x)
      is_admissible = is_possible(c%edges, state)
      if (.not. is_admissible) return
      call get_balance(c%strip, state, balance)
      error = error_of(c, balance%load, balance%friction)
   end subroutine error_of_edges

   pure real(dp) function load_scale(c)
      type(case_t), intent(in) :: c

      load_scale = max(c%balance%load_scale, tiny(1.0_dp))
   end function load_scale

   pure real(dp) function friction_scale(c)
      type(case_t), intent(in) :: c

      friction_scale = max(c%balance%friction_scale + c%balance%dissipation + abs(c%balance%edge_loss), &
         1.0e-5_dp*load_scale(c))
   end function friction_scale

end module strip_cases

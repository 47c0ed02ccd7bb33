! SPDX-License-Identifier: GPL-3.0-or-later
!> Strips in the units of the reference tables, l = h = K = 1, solved and summed.
module unit_strips
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_foundation_adhesion, only: adhesion_t, acting_adhesion, edge_continuous, edge_instantaneous, edge_front
   use adfric_foundation_balance, only: balance_t, get_balance
   use adfric_foundation_foundation, only: foundation_t, new_foundation
   use adfric_foundation_steady_state, only: find_steady_state, branch_adhered, branch_approach
   use adfric_foundation_strip, only: strip_t, new_strip, steady_state_t, &
      regime_free, regime_adhesion_only, regime_discrete, regime_saturated_adhesion, regime_adhesion_zones, &
      regime_saturated
   implicit none (type, external)
   private
   public :: trial_strip_t, solved_strip_t, new_trial_strip, solve_strip, label_of, everywhere
   public :: edge_continuous, edge_instantaneous, edge_front, branch_adhered, branch_approach
   public :: regime_free, regime_adhesion_only, regime_discrete, regime_saturated_adhesion, regime_adhesion_zones, &
      regime_saturated

   !> A range of adhesion that no gap passes.
   real(dp), parameter :: everywhere = 1.0e6_dp

   !> A strip of height 1.
   type :: trial_strip_t
      real(dp) :: u = 1, beta = 10, stress = 0, range = everywhere, penetration = 0
      integer :: edge = edge_continuous, branch = branch_adhered
   end type trial_strip_t

   !> Its steady state.
   type :: solved_strip_t
      type(strip_t) :: strip
      type(steady_state_t) :: state
      type(balance_t) :: balance
      !> Load P K/(h l) and friction T K/h^2.
      real(dp) :: load = 0, friction = 0
      !> Ends of the contact -a and b and of adhesion -a1 and b1 [l].
      real(dp) :: a = 0, b = 0, a1 = 0, b1 = 0
      !> What the balances of load and energy leave over, of the sums of the sizes of their terms.
      real(dp) :: load_imbalance = 0, energy_imbalance = 0
   end type solved_strip_t

contains

   !> The strip in reduced form.
   elemental subroutine new_trial_strip(trial, strip)
      type(trial_strip_t), intent(in) :: trial
      type(strip_t), intent(out) :: strip
      type(foundation_t) :: foundation

      call new_foundation(foundation, trial%u, trial%beta)
      call new_strip(strip, foundation, 0.5_dp, trial%penetration, &
         acting_adhesion(adhesion_t(trial%stress, trial%range, trial%edge), trial%beta))
   end subroutine new_trial_strip

   !> Solve a strip.
   pure subroutine solve_strip(trial, solved, guess)
      type(trial_strip_t), intent(in) :: trial
      type(solved_strip_t), intent(out) :: solved
      type(steady_state_t), intent(in), optional :: guess
      real(dp) :: terms

      call new_trial_strip(trial, solved%strip)
      call find_steady_state(solved%strip, trial%branch, solved%state, guess)
      call get_balance(solved%strip, solved%state, solved%balance)
      associate (s => solved%state, b => solved%balance)
         solved%load = b%load/(2*two_pi)
         solved%friction = b%friction/4
         solved%a = (s%half_width - s%shift)/two_pi
         solved%b = (s%half_width + s%shift)/two_pi
         solved%a1 = solved%a + s%trailing/two_pi
         solved%b1 = solved%b + s%leading/two_pi
         if (b%load_scale > 0) solved%load_imbalance = b%load_mismatch/b%load_scale
         terms = b%friction_scale + b%dissipation + abs(b%edge_loss)
         if (terms > 0) solved%energy_imbalance = (b%friction - b%dissipation - b%edge_loss)/terms
      end associate
   end subroutine solve_strip

   !> A strip in words, for messages.
   function label_of(trial) result(label)
      type(trial_strip_t), intent(in) :: trial
      character(:), allocatable :: label
      character(200) :: line

      write (line, '(a, 5(es23.16, ","), 2(i2))') 'strip u, beta, p0, d0, D, edge, branch = ', trial%u, trial%beta, &
         trial%stress, trial%range, trial%penetration, trial%edge, trial%branch
      label = trim(line)
   end function label_of

end module unit_strips

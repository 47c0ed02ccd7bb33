! SPDX-License-Identifier: GPL-3.0-or-later
!> Random strips over the whole range of parameters, the same for the same seed.
module trial_strips
   use adfric_base_kinds, only: dp
   use adfric_foundation_foundation, only: foundation_t, new_foundation
   use adfric_foundation_steady_state, only: branch_adhered, branch_approach
   use adfric_foundation_adhesion, only: adhesion_t, edge_continuous, edge_instantaneous
   use adfric_foundation_strip, only: strip_t, new_strip
   use random_dice, only: dice_t
   implicit none (type, external)
   private
   public :: trial_t, draw_trial, make_strip, describe

   !> Parameters of a strip in units of the height h, and of h/K for stresses.
   type :: trial_t
      real(dp) :: u = 1, beta = 1, penetration = 0, stress = 0, range = 1
      integer :: edge = edge_continuous, branch = branch_adhered
   end type trial_t

   !> Shares of strips without adhesion and on an elastic foundation.
   real(dp), parameter :: share_without_adhesion = 0.05_dp, share_elastic = 0.02_dp

contains

   !> Draw a strip.
   pure subroutine draw_trial(dice, trial)
      type(dice_t), intent(inout) :: dice
      type(trial_t), intent(out) :: trial
      real(dp) :: kind, edge, branch

      call dice%decades(-3.0_dp, 2.0_dp, trial%u)
      call dice%decades(0.0_dp, 4.0_dp, trial%beta)
      call dice%decades(-3.0_dp, 2.0_dp, trial%stress)
      call dice%decades(-3.0_dp, 1.0_dp, trial%range)
      call dice%between(-0.1_dp, 2.0_dp, trial%penetration)
      call dice%between(0.0_dp, 1.0_dp, edge)
      call dice%between(0.0_dp, 1.0_dp, branch)
      call dice%between(0.0_dp, 1.0_dp, kind)
      trial%edge = merge(edge_continuous, edge_instantaneous, edge < 0.5_dp)
      trial%branch = merge(branch_adhered, branch_approach, branch < 0.5_dp)
      if (kind < share_without_adhesion) trial%stress = 0
      if (kind > 1 - share_elastic) trial%beta = 1
   end subroutine draw_trial

   !> The strip of a trial, its penetration changed by a little.
   pure subroutine make_strip(trial, change, strip)
      type(trial_t), intent(in) :: trial
      real(dp), intent(in) :: change
      type(strip_t), intent(out) :: strip
      type(foundation_t) :: foundation

      call new_foundation(foundation, trial%u, trial%beta)
      call new_strip(strip, foundation, 0.5_dp, trial%penetration + change, &
         adhesion_t(trial%stress, trial%range, trial%edge))
   end subroutine make_strip

   !> A trial as a namelist, to every digit.
   function describe(trial, fault) result(text)
      type(trial_t), intent(in) :: trial
      character(*), intent(in) :: fault
      character(:), allocatable :: text
      character(400) :: buffer

      write (buffer, '(3a, 5(a, es23.16), 2(a, i0), a)') '&strip fault=''', fault, '''', ' u=', trial%u, ', beta=', &
         trial%beta, ', stress=', trial%stress, ', range=', trial%range, ', penetration=', trial%penetration, &
         ', edge=', trial%edge, ', branch=', trial%branch, ' /'
      text = trim(buffer)
   end function describe

end module trial_strips

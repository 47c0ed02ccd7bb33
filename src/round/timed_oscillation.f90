! SPDX-License-Identifier: GPL-3.0-or-later
!> What a small oscillation on a rested contact says of the solid: the first harmonics of load and approach over a period.
module adfric_round_timed_oscillation
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_numerics_time_panels, only: n_nodes, panel_nodes, panel_sums
   use adfric_round_timed_panel, only: timed_panel_t
   use adfric_round_timed_path, only: timed_leg_t
   implicit none (type, external)
   private
   public :: oscillation_t, add_oscillation, get_moduli

   !> A period.
   type :: oscillation_t
      !> First harmonics of load and approach.
      complex(dp) :: load = 0, approach = 0
      !> What both change from the begin of the period to its end, and the radius of the contact before the first period.
      real(dp) :: load_change = 0, approach_change = 0, radius = 0
      !> Is contact lost in the period? Then it has no moduli.
      logical :: is_lost = .false.
   end type oscillation_t

contains

   !> Add a panel of the last period.
   pure subroutine add_oscillation(oscillation, leg, panel)
      !> The sums so far.
      type(oscillation_t), intent(inout) :: oscillation
      !> The period.
      type(timed_leg_t), intent(in) :: leg
      !> A panel of it.
      type(timed_panel_t), intent(in) :: panel
      complex(dp) :: turned(n_nodes)
      real(dp) :: angle(n_nodes)

      oscillation%is_lost = oscillation%is_lost .or. .not. minval(panel%radius) > 0
      angle = leg%frequency*(panel%clock - leg%clock + panel%span*(panel_nodes + 1)/2)
      turned = cmplx(cos(angle), -sin(angle), dp)*panel_sums*panel%span/(2*leg%span)
      oscillation%load = oscillation%load + sum(turned*panel%load)
      oscillation%approach = oscillation%approach + sum(turned*panel%approach)
      oscillation%load_change = oscillation%load_change + panel%load(n_nodes) - panel%load(1)
      oscillation%approach_change = oscillation%approach_change + panel%approach(n_nodes) - panel%approach(1)
   end subroutine add_oscillation

   !> Storage and loss modulus. What is straight in time is taken out: a load that still relaxes has a first harmonic of its own,
   !> i/(2 pi) of its change.
   pure subroutine get_moduli(oscillation, unit, storage, loss)
      !> The period.
      type(oscillation_t), intent(in) :: oscillation
      !> Unit of the moduli [Pa].
      real(dp), intent(in) :: unit
      !> Receive the moduli [Pa].
      real(dp), intent(out) :: storage, loss
      complex(dp) :: modulus

      modulus = (oscillation%load - cmplx(0.0_dp, oscillation%load_change/two_pi, dp)) &
         & /(oscillation%approach - cmplx(0.0_dp, oscillation%approach_change/two_pi, dp))/(2*oscillation%radius)
      storage = real(modulus)*unit
      loss = aimag(modulus)*unit
   end subroutine get_moduli

end module adfric_round_timed_oscillation

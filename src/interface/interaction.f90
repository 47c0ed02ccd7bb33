! SPDX-License-Identifier: GPL-3.0-or-later
!> The share X of adhesion that friction leaves (K. L. Johnson, Proc. R. Soc. Lond. A 453, 1997, 163: J 4.5-4.7).
!>
!> Slip works against the strength over the range of adhesion: g = tau0 s/w, at most g0 = tau0 s0/w. Of that work the
!> share alpha comes out of adhesion:
!>
!>     X = w'/w = sqrt((1 + g)^2 - 2 alpha g) - g                                  (J 4.7)
!>
!> which is real for alpha <= (1 + g)^2/(2g), and not negative for alpha <= 1 + 1/(2g), the narrower limit for g > 0.
module adfric_interface_interaction
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   implicit none (type, external)
   private
   public :: get_adhesion_ratio, adhesion_ratio, is_valid_interaction, slip_energy_of_ratio
   public :: reversible_interaction, largest_interaction, largest_slip_energy

contains

   !> Is X real and not negative?
   elemental logical function is_valid_interaction(slip_energy, interaction)
      !> Slip energy g [-]; not valid below 0.
      real(dp), intent(in) :: slip_energy
      !> Share alpha of the work of slip that comes out of adhesion [-]; not valid below 0.
      real(dp), intent(in) :: interaction

      is_valid_interaction = slip_energy >= 0 .and. interaction >= 0 .and. slip_energy <= largest_slip_energy(interaction)
   end function is_valid_interaction

   !> X of g and alpha (J 4.7); 0 beyond its validity. An endless g gives 1 - alpha.
   elemental real(dp) function adhesion_ratio(slip_energy, interaction) result(ratio)
      !> Slip energy g [-], >= 0.
      real(dp), intent(in) :: slip_energy
      !> Share alpha of the work of slip that comes out of adhesion [-], >= 0.
      real(dp), intent(in) :: interaction
      real(dp) :: excess

      if (has_asserts) call assert(slip_energy >= 0 .and. interaction >= 0, 'adhesion_ratio: g >= 0, alpha >= 0')
      ! X = (S^2 - g^2)/(S + g): no difference of large terms
      if (slip_energy <= 1) then
         excess = max(1 + 2*slip_energy*(1 - interaction), 0.0_dp)
         ratio = excess/(slip_energy + sqrt(excess + slip_energy**2))
      else
         excess = max(1/slip_energy + 2*(1 - interaction), 0.0_dp)
         ratio = excess/(1 + sqrt(1 + excess/slip_energy))
      end if
   end function adhesion_ratio

   !> X and dX/dg.
   elemental subroutine get_adhesion_ratio(slip_energy, interaction, ratio, slope)
      !> Slip energy g [-], >= 0.
      real(dp), intent(in) :: slip_energy
      !> Share alpha of the work of slip that comes out of adhesion [-], >= 0.
      real(dp), intent(in) :: interaction
      !> X, the share of adhesion that remains [-].
      real(dp), intent(out) :: ratio
      !> dX/dg [-].
      real(dp), intent(out) :: slope
      real(dp) :: root, rest

      ratio = adhesion_ratio(slip_energy, interaction)
      ! S, and 1 + g - alpha, S^2 less whose square is alpha (2 - alpha)
      root = ratio + slip_energy
      rest = 1 + slip_energy - interaction
      if (rest > 0) then
         ! halves, for an endless g
         slope = -interaction*(1 - interaction/2)/root/(root/2 + rest/2)
      else
         slope = (rest - root)/root
      end if
   end subroutine get_adhesion_ratio

   !> g of X, J 4.7 solved for it: (1 - X)(1 + X)/(2 (alpha - 1 + X)). For 0 <= X <= 1, X >= 1 - alpha; enormous where g has
   !> no end.
   elemental real(dp) function slip_energy_of_ratio(ratio, interaction) result(slip_energy)
      !> X, the share of adhesion that remains [-], from max(0, 1 - alpha) to 1.
      real(dp), intent(in) :: ratio
      !> Share alpha of the work of slip that comes out of adhesion [-], >= 0.
      real(dp), intent(in) :: interaction

      slip_energy = (1 - ratio)*(1 + ratio)/max(2*(interaction - (1 - ratio)), tiny(ratio))
   end function slip_energy_of_ratio

   !> alpha = 1 + g/2 of Savkoor and Briggs, with which nothing is dissipated: X = 1 - g.
   elemental real(dp) function reversible_interaction(slip_energy) result(interaction)
      !> Slip energy g [-], >= 0.
      real(dp), intent(in) :: slip_energy

      interaction = 1 + slip_energy/2
   end function reversible_interaction

   !> The largest alpha for which X of g is not below a given ratio, 0 <= ratio <= 1; g > 0.
   elemental real(dp) function largest_interaction(slip_energy, ratio) result(interaction)
      !> Slip energy g [-], > 0.
      real(dp), intent(in) :: slip_energy
      !> The least X that is allowed [-], 0 to 1.
      real(dp), intent(in) :: ratio

      if (has_asserts) call assert(slip_energy > 0, 'largest_interaction: g > 0')
      interaction = (1 - ratio)*(1 + (1 + ratio)/slip_energy/2)
   end function largest_interaction

   !> The largest g for which X is not negative; the largest number if there is none.
   elemental real(dp) function largest_slip_energy(interaction) result(slip_energy)
      !> Share alpha of the work of slip that comes out of adhesion [-], >= 0.
      real(dp), intent(in) :: interaction

      slip_energy = huge(slip_energy)
      if (interaction > 1) slip_energy = 1/(2*(interaction - 1))
   end function largest_slip_energy

end module adfric_interface_interaction

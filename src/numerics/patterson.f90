! SPDX-License-Identifier: GPL-3.0-or-later
!> A family of nested rules on (-1, 1): Gauss's of 5 nodes, Kronrod's extension of it to 11, Patterson's of that to 23
!> and 47 nodes, and below them the one of the midpoint. Each keeps all nodes of the one before.
!>
!> The rules of n = 11, 23 and 47 nodes are exact for polynomials of degree (3n + 1)/2 (T. N. L. Patterson, Math. Comp.
!> 22 (1968) 847). All weights are positive.
module adfric_numerics_patterson
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: n_levels, n_half, rule_nodes, rule_weights, first_stride

   !> The finest rule, and how many of its nodes are positive.
   integer, parameter :: n_levels = 4, n_half = 23
   !> Every eighth node of the finest rule, from the midpoint, is one of the first rule, every fourth one of the next.
   integer, parameter :: first_stride = 8

   !> Nodes of the finest rule from the midpoint on; the others are their negatives.
   real(dp), parameter :: rule_nodes(0:n_half) = [ &
      & 0.0_dp, 0.070698884851513173197_dp, 0.14108304540169852469_dp, 0.21083475823959201958_dp, &
      & 0.27963041316178319341_dp, 0.34713805493654518415_dp, 0.4130159172460903685_dp, 0.47691259248574345725_dp, &
      & 0.53846931010568309104_dp, 0.5973244423227357373_dp, 0.65311997810491663606_dp, 0.70550944966706714907_dp, &
      & 0.75416672657084922044_dp, 0.79879519325518136487_dp, 0.83913703080552600731_dp, 0.8749825623646845687_dp, &
      & 0.9061798459386639928_dp, 0.93264489666464059242_dp, 0.95437314473850901745_dp, 0.97145320780509339189_dp, &
      & 0.9840853600948424645_dp, 0.99260947425823423618_dp, 0.99754549758686732618_dp, 0.99964289406296230342_dp]
   !> Weights of the rules at their own nodes, likewise.
   real(dp), parameter :: weights_5(0:2) = [ &
      & 0.56888888888888888889_dp, 0.47862867049936646804_dp, 0.23692688505618908751_dp]
   real(dp), parameter :: weights_11(0:5) = [ &
      & 0.2829874178574912132_dp, 0.27284980191255892234_dp, 0.2410403392286475867_dp, 0.18680079655649265747_dp, &
      & 0.11523331662247339402_dp, 0.042582036751081832865_dp]
   real(dp), parameter :: weights_23(0:11) = [ &
      & 0.1415024762815156672_dp, 0.14024257842068333053_dp, 0.13641553072122802237_dp, 0.129893129061502188_dp, &
      & 0.12053227648303325459_dp, 0.10829771463353508625_dp, 0.093378762792174359548_dp, 0.076248311290396817176_dp, &
      & 0.057677836246853514639_dp, 0.038762093615661268628_dp, 0.021011712421961465073_dp, 0.0067888161722128595953_dp]
   real(dp), parameter :: weights_47(0:23) = [ &
      & 0.070751238538710838928_dp, 0.070594127268101438761_dp, 0.070121288798027307502_dp, 0.069328244229318439818_dp, &
      & 0.06820776582310313072_dp, 0.066750555048403447562_dp, 0.064946563955015220257_dp, 0.062786915665761711973_dp, &
      & 0.060266139068111248028_dp, 0.057384323288836859428_dp, 0.054148855882086356702_dp, 0.0505755785341534761_dp, &
      & 0.046689384561912553125_dp, 0.042524423682251645246_dp, 0.038124146304815522297_dp, 0.03354142415014525501_dp, &
      & 0.028838956825809733973_dp, 0.024090158434880851098_dp, 0.019380811266651235523_dp, 0.014812243700755632344_dp, &
      & 0.010508001411299066692_dp, 0.0066261496555101408676_dp, 0.0033690040914704269152_dp, 0.0010093190842238805935_dp]

   integer :: i, j
   !> Weights of all rules, from the midpoint's, at the nodes of the finest: 0 at nodes that are not their own.
   real(dp), parameter :: rule_weights(0:n_half, 0:n_levels) = reshape([2.0_dp, (0.0_dp, i=1, n_half), &
      & (weights_5(j), (0.0_dp, i=1, 7), j=0, 2), (weights_11(j), (0.0_dp, i=1, 3), j=0, 5), &
      & (weights_23(j), 0.0_dp, j=0, 11), weights_47], [n_half + 1, n_levels + 1])

end module adfric_numerics_patterson

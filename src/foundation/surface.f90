! SPDX-License-Identifier: GPL-3.0-or-later
!> The wavy surface as a set of strips, and what the strips add up to.
!>
!> Reduced units: lengths along the surface in periods l, heights in h, pressure in h/K.
!> Which strips a surface has, `wave_shape` says.
module adfric_foundation_surface
   use adfric_base_kinds, only: dp, i8
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_base_constants, only: two_pi
   use adfric_foundation_adhesion, only: adhesion_t, strip_adhesion_t, new_strip_adhesion
   use adfric_foundation_balance, only: balance_t, get_balance, get_load_slope, get_slope_bound
   use adfric_foundation_finite_slope, only: get_finite_slope_friction
   use adfric_foundation_foundation, only: foundation_t
   use adfric_foundation_steady_state, only: branch_adhered
   use adfric_foundation_strip, only: strip_t, new_strip, steady_state_t, regime_free, &
      & regime_adhesion_only, regime_adhesion_zones, regime_saturated, regime_saturated_adhesion
   use adfric_foundation_wave_shape, only: wave_shape_t, strip_amplitude, strip_penetration, strip_steepness
   implicit none (type, external)
   private
   public :: negligible, share_of_scale, surface_t, totals_t, new_surface_strip, add_strip, add_totals, add_load_slope, add_regime
   public :: is_same_surface, is_identical_surface, get_relative_error, attach_gap_of, lowest_of

   !> A balance that is violated by this share of its terms has not been solved.
   real(dp), parameter :: unbalanced = 1.0e-3_dp
   !> Share of the load below which the digits of friction are those of round-off.
   real(dp), parameter :: negligible = 1.0e-7_dp
   !> Below this share of the sum of their terms, load and friction are as good as zero.
   real(dp), parameter :: share_of_scale = 0.01_dp
   !> What the round-off of its terms grows to in friction, at most (`bench/error_estimates`).
   real(dp), parameter :: most_amplified = 1000.0_dp

   !> How many times as fast as the load friction changes, towards pull-off (`bench/error_estimates`).
   real(dp), parameter :: pull_off_amplified = 12.0_dp

   !> A wavy surface on its foundation.
   type :: surface_t
      !> Shape of the surface, with lengths in h.
      type(wave_shape_t) :: shape
      !> Foundation under the surface, at its velocity.
      type(foundation_t) :: foundation
      !> Adhesion as it acts, its stress in h/K and its range in h.
      type(adhesion_t) :: adhesion
      !> The branch, one of `branch_...`.
      integer :: branch = branch_adhered
      !> Strips on half a period of a 3-D surface (GM's 2N strips); 0: as many as the tolerance needs.
      integer :: n_strips = 0
      !> Relative tolerance of a 3-D surface.
      real(dp) :: tolerance = 1.0e-8_dp
   end type surface_t

   !> Forces and areas of a surface, per period in x (and in y), at one penetration.
   type :: totals_t
      !> Load [h/K] and friction [h^2/(K l)], and the change of the load with the penetration [1/K]: that of the strips as they
      !> are, without what strips gain or lose that change their regime.
      real(dp) :: load = 0, friction = 0, load_slope = 0
      !> The largest change of the load with the penetration here and at all smaller penetrations [1/K].
      real(dp) :: slope_bound = 0
      !> Which regimes follow each other across the surface, as a number; see `add_regime`.
      integer(i8) :: structure = 0
      !> Does every strip touch, and adhere wherever it does not?
      logical :: is_attached = .true.
      !> Shares of the surface in contact and in adhesion.
      real(dp) :: contact = 0, adhesion = 0
      !> Energy that the foundation takes, and the edges of adhesion, in the units of friction.
      real(dp) :: dissipation = 0, edge_loss = 0
      !> What the balances of load and energy leave over, and the sizes of their terms.
      real(dp) :: load_mismatch = 0, energy_mismatch = 0, load_scale = 0, friction_scale = 0
      !> Error of the friction of finite slopes, in the units of friction.
      real(dp) :: slope_error = 0
      !> Strips solved, and those of them in closed form.
      integer :: n_strips = 0, n_closed_form = 0
      !> Have all strips, and the rule across them, converged?
      logical :: is_converged = .true.
   end type totals_t

contains

   !> Are two surfaces the same, but for round-off of their units?
   elemental logical function is_same_surface(one, two)
      !> Two surfaces in reduced units; their tolerances are not compared.
      type(surface_t), intent(in) :: one, two

      is_same_surface = (one%shape%is_3d .eqv. two%shape%is_3d) .and. one%adhesion%edge == two%adhesion%edge &
         & .and. one%branch == two%branch .and. one%n_strips == two%n_strips .and. is_same(one%foundation%u, two%foundation%u) &
         & .and. is_same(one%foundation%beta, two%foundation%beta) .and. is_same(one%adhesion%stress, two%adhesion%stress) &
         & .and. is_same(one%adhesion%range, two%adhesion%range) .and. is_same(one%shape%steepness, two%shape%steepness)
   end function is_same_surface

   !> Are two surfaces the same to the last bit, and are to be solved to the same tolerance?
   elemental logical function is_identical_surface(one, two)
      !> Two surfaces in reduced units; their tolerances are compared, too.
      type(surface_t), intent(in) :: one, two

      is_identical_surface = is_same_surface(one, two) .and. .not. ( &
         & abs(one%foundation%u - two%foundation%u) > 0 .or. abs(one%foundation%beta - two%foundation%beta) > 0 &
         & .or. abs(one%adhesion%stress - two%adhesion%stress) > 0 .or. abs(one%adhesion%range - two%adhesion%range) > 0 &
         & .or. abs(one%shape%steepness - two%shape%steepness) > 0 .or. abs(one%tolerance - two%tolerance) > 0)
   end function is_identical_surface

   !> Are two numbers the same but for round-off of their units?
   elemental logical function is_same(one, two)
      !> Two numbers of the same unit.
      real(dp), intent(in) :: one, two

      is_same = abs(one - two) <= 4*epsilon(one)*max(abs(one), abs(two))
   end function is_same

   !> Gap at which adhesion takes hold of the free surface [h]: at minus this penetration the crests are drawn in.
   elemental real(dp) function attach_gap_of(surface) result(gap)
      type(surface_t), intent(in) :: surface
      type(strip_adhesion_t) :: law

      ! of a strip whose unit of length is that of the surface
      call new_strip_adhesion(law, surface%adhesion, 1.0_dp, surface%foundation%beta)
      gap = law%attach_gap
   end function attach_gap_of

   !> Penetration below which nothing adheres [h]: adhesion lifts the foundation by its stress at most, and does not reach further
   !> down than the gap of release.
   elemental real(dp) function lowest_of(surface) result(penetration)
      type(surface_t), intent(in) :: surface
      type(strip_adhesion_t) :: law

      call new_strip_adhesion(law, surface%adhesion, 1.0_dp, surface%foundation%beta)
      penetration = -(law%stress + law%release_gap)
   end function lowest_of

   !> The strip with the share Y of the height, at a penetration of the surface.
   elemental subroutine new_surface_strip(surface, penetration, share, strip)
      type(surface_t), intent(in) :: surface
      !> Penetration of the crests into the undisturbed surface [h].
      real(dp), intent(in) :: penetration
      !> Share Y of the height, in (0, 1].
      real(dp), intent(in) :: share
      !> The strip in its own reduced units, in which half its height is 1.
      type(strip_t), intent(out) :: strip

      if (has_asserts) call assert(share > 0 .and. share <= 1, 'new_surface_strip: 0 < share <= 1')
      call new_strip(strip, surface%foundation, strip_amplitude(share), strip_penetration(penetration, share), &
         & surface%adhesion)
   end subroutine new_surface_strip

   !> Add a strip of a width to the totals.
   pure subroutine add_strip(surface, strip, state, share, width, totals)
      !> The surface in reduced units; its steepness tells which friction is summed.
      type(surface_t), intent(in) :: surface
      type(strip_t), intent(in) :: strip
      !> Steady state of the strip; one that is not converged adds no forces.
      type(steady_state_t), intent(in) :: state
      !> Share Y of the height of the strip, in (0, 1].
      real(dp), intent(in) :: share
      !> Part of the period in y that the strip stands for [-].
      real(dp), intent(in) :: width
      !> Sums over strips; this strip is added.
      type(totals_t), intent(inout) :: totals
      type(balance_t) :: balance
      real(dp) :: first, second, friction, small_slope

      totals%n_strips = totals%n_strips + 1
      totals%is_converged = totals%is_converged .and. state%is_converged
      if (state%regime == regime_free .or. .not. state%is_converged) return
      call get_balance(strip, state, balance)
      totals%is_converged = totals%is_converged .and. is_balanced(balance)
      ! from units of half the height of the strip
      first = width*share/(2*two_pi)
      second = width*share**2/4
      totals%load = totals%load + first*balance%load
      totals%contact = totals%contact + width*balance%contact/two_pi
      totals%adhesion = totals%adhesion + width*balance%adhesion/two_pi
      totals%dissipation = totals%dissipation + second*balance%dissipation
      totals%edge_loss = totals%edge_loss + second*balance%edge_loss
      totals%load_mismatch = totals%load_mismatch + first*balance%load_mismatch
      totals%load_scale = totals%load_scale + first*balance%load_scale
      totals%energy_mismatch = totals%energy_mismatch &
         & + second*(balance%friction - balance%dissipation - balance%edge_loss)
      totals%friction_scale = totals%friction_scale + second*balance%friction_scale
      friction = balance%friction
      if (surface%shape%steepness > 0) then
         call get_finite_slope_friction(strip, state, strip_steepness(surface%shape, share), friction, small_slope)
         ! the same rule for the friction that is known in closed form tells its error
         totals%slope_error = totals%slope_error + second*abs(small_slope - balance%friction)
      end if
      totals%friction = totals%friction + second*friction
   end subroutine add_strip

   !> Do load and energy balance at all? Where the sliding is so fast that round-off has moved the edges, they do not.
   elemental logical function is_balanced(balance)
      !> Forces, losses and mismatches of one strip, in its own units.
      type(balance_t), intent(in) :: balance
      real(dp) :: losses

      losses = balance%friction_scale + balance%dissipation + abs(balance%edge_loss)
      is_balanced = abs(balance%load_mismatch) <= unbalanced*balance%load_scale + tiny(losses) &
         & .and. abs(balance%friction - balance%dissipation - balance%edge_loss) &
         & <= unbalanced*max(losses, negligible*balance%load_scale) + tiny(losses)
   end function is_balanced

   !> Add one sum to another, with a weight.
   pure subroutine add_totals(totals, part, weight)
      !> The sums that are added to.
      type(totals_t), intent(inout) :: totals
      type(totals_t), intent(in) :: part
      !> Factor of the forces and areas of `part`, not of its counts [-]; 1 if absent.
      real(dp), intent(in), optional :: weight
      real(dp) :: w

      w = 1
      if (present(weight)) w = weight
      totals%load = totals%load + w*part%load
      totals%friction = totals%friction + w*part%friction
      totals%load_slope = totals%load_slope + w*part%load_slope
      totals%slope_bound = totals%slope_bound + w*part%slope_bound
      totals%contact = totals%contact + w*part%contact
      totals%adhesion = totals%adhesion + w*part%adhesion
      totals%dissipation = totals%dissipation + w*part%dissipation
      totals%edge_loss = totals%edge_loss + w*part%edge_loss
      totals%load_mismatch = totals%load_mismatch + w*part%load_mismatch
      totals%energy_mismatch = totals%energy_mismatch + w*part%energy_mismatch
      totals%slope_error = totals%slope_error + w*part%slope_error
      totals%load_scale = totals%load_scale + w*part%load_scale
      totals%friction_scale = totals%friction_scale + w*part%friction_scale
      totals%n_strips = totals%n_strips + part%n_strips
      totals%n_closed_form = totals%n_closed_form + part%n_closed_form
      totals%is_converged = totals%is_converged .and. part%is_converged
   end subroutine add_totals

   !> Note one more regime across the surface.
   pure subroutine add_regime(totals, regime)
      !> Sums whose `structure` and `is_attached` take in the regime.
      type(totals_t), intent(inout) :: totals
      !> Regime of the next strip or panel from the crest line, one of `regime_...`.
      integer, intent(in) :: regime
      !> A prime below 2**60/8: the sum does not overflow, and two structures hardly ever have one number.
      integer(i8), parameter :: modulus = 144115188075855859_i8

      totals%structure = mod(totals%structure*8 + regime + 1, modulus)
      totals%is_attached = totals%is_attached .and. (regime == regime_saturated .or. regime == regime_saturated_adhesion)
   end subroutine add_regime

   !> Add the change of a strip's load with the penetration, and its bound.
   pure subroutine add_load_slope(strip, state, width, totals)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      real(dp), intent(in) :: width
      !> Sums over strips; slope and bound of this strip are added.
      type(totals_t), intent(inout) :: totals

      real(dp) :: slope, bound

      bound = width*get_slope_bound(strip, state)/two_pi
      slope = bound
      ! without edges of adhesion nothing is gained or lost
      if (state%regime == regime_adhesion_zones .or. state%regime == regime_adhesion_only) &
         & slope = width*get_load_slope(strip, state)/two_pi
      totals%load_slope = totals%load_slope + slope
      totals%slope_bound = totals%slope_bound + bound
   end subroutine add_load_slope

   !> The larger of the relative errors of load and friction, 1 at most.
   pure real(dp) function get_relative_error(totals, error, excess) result(relative)
      !> Sums over all strips, with their sizes and mismatches.
      type(totals_t), intent(in) :: totals
      !> Errors of load and friction beside round-off and what the balances leave over, in the units of `totals`.
      real(dp), intent(in) :: error(2)
      !> By how much the load may differ from one that is given [h/K].
      real(dp), intent(in) :: excess
      real(dp) :: errors(2), sizes(2), scales(2), shares(2)

      scales = [totals%load_scale, totals%friction_scale]
      sizes = max(abs([totals%load, totals%friction]), share_of_scale*scales)
      ! a friction that is nothing beside the load has no digits of its own
      sizes(2) = max(sizes(2), negligible*sizes(1))
      errors = error + 8*epsilon(1.0_dp)*scales + abs([totals%load_mismatch, totals%energy_mismatch]) + [0.0_dp, totals%slope_error]
      ! edges are known to the round-off of their phases, which shifts the load: that is friction, where there is any
      if (max(totals%contact, totals%adhesion) < 1) errors(2) = errors(2) &
         & + epsilon(1.0_dp)*min(4*totals%load_scale, most_amplified*totals%friction_scale)
      errors(1) = errors(1) + abs(excess)
      if (abs(excess) < sizes(1)) then
         errors(2) = errors(2) + pull_off_amplified*abs(excess)/sizes(1)*sizes(2)
      else
         errors(2) = errors(2) + pull_off_amplified*sizes(2)
      end if
      ! an error as large as the number is known says no more than 1
      shares = merge(1.0_dp, 0.0_dp, errors > 0)
      where (errors < sizes) shares = errors/sizes
      relative = maxval(shares)
   end function get_relative_error

end module adfric_foundation_surface

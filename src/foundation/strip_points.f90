! SPDX-License-Identifier: GPL-3.0-or-later
!> Points of `wavy_sliding` whose strips have closed forms, from values in SI units to results in SI units.
module adfric_foundation_strip_points
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi, pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_describe_status, only: status_solved, status_no_equilibrium
   use adfric_numerics_found_once, only: found_once_t
   use adfric_foundation_adhesion, only: adhesion_t, strip_adhesion_t, new_strip_adhesion
   use adfric_foundation_case, only: wavy_case_t, resolve_case
   use adfric_foundation_crosswise, only: memory_t
   use adfric_foundation_equilibrium, only: equilibrium_t, neighbour_t, solve_penetration, solve_load, leads_to
   use adfric_foundation_pull_off, only: pull_off_t, find_pull_off, is_below_pull_off
   use adfric_foundation_pull_off_table, only: get_pull_off
   use adfric_foundation_steady_state, only: branch_adhered
   use adfric_foundation_strip, only: steady_state_t, regime_free, regime_adhesion_only, regime_adhesion_zones, regime_saturated, &
      & regime_saturated_adhesion
   use adfric_foundation_surface, only: negligible, is_same_surface
   use adfric_foundation_variables, only: out => foundation_output
   implicit none (type, external)
   private
   public :: solve_strip_block

   !> Load or friction below this share of the sum of its terms is zero but for round-off.
   real(dp), parameter :: as_good_as_zero = 1.0e-13_dp

contains

   !> Solve neighbouring points. Loads, and penetrations in 3-D and on the approach branch, are solved in the order in which each
   !> leads to the next on its branch.
   subroutine solve_strip_block(pull_offs, values, results, error_estimate, status, counts)
      !> Pull-off loads that the points of a run share, which are looked up, and completed; null if none are shared.
      type(found_once_t), pointer, intent(in) :: pull_offs
      !> Values of neighbouring points; shape `(n_variables, n_points)`.
      real(dp), intent(in) :: values(:, :)
      !> Results in SI units, NaN where there is no value; shape `(n_results, n_points)`.
      real(dp), intent(out) :: results(:, :)
      !> Relative error of load and friction [-], NaN where the point is not solved; shape `(n_points)`.
      real(dp), intent(out) :: error_estimate(:)
      !> How each point was solved, one of `status_...`; shape `(n_points)`.
      integer, intent(out) :: status(:)
      !> Receives the number of strips solved for all points of the block, and of those among them in closed form.
      real(dp), intent(out) :: counts(:)
      type(wavy_case_t) :: point, last, hopeless
      type(equilibrium_t) :: equilibrium
      type(memory_t) :: memory
      type(neighbour_t) :: neighbour
      type(pull_off_t) :: pull_off
      integer :: i, k, n
      logical :: is_reversed

      counts = 0
      n = size(values, 2)
      is_reversed = .false.
      if (n > 1) is_reversed = leads_backwards(values(:, 1), values(:, 2))
      do k = 1, n
         i = merge(n + 1 - k, k, is_reversed)
         call resolve_case(values(:, i), point)
         if (point%wants_pull_off) then
            if (associated(pull_offs)) then
               call get_pull_off(pull_offs, point%surface, pull_off)
            else
               call find_pull_off(point%surface, pull_off)
            end if
         end if
         memory%is_even = .not. point%is_load_given
         memory%needs_slope = point%is_load_given
         if (point%is_load_given) then
            if (neighbour%n > 0) then
               if (.not. leads_to(last%surface, last%load, point%surface, point%load)) neighbour%n = 0
            end if
            if (is_below_pull_off(pull_off, point%surface, point%load) .or. is_hopeless(hopeless, point)) then
               equilibrium = equilibrium_t(status_no_equilibrium)
            else
               call solve_load(point%surface, point%load, neighbour, memory, equilibrium)
            end if
            if (equilibrium%status == status_no_equilibrium) hopeless = point
            last = point
         else
            call solve_penetration(point%surface, point%penetration, memory, equilibrium)
         end if
         call store(point, equilibrium, pull_off, results(:, i))
         status(i) = equilibrium%status
         error_estimate(i) = equilibrium%error_estimate
         if (status(i) /= status_solved) error_estimate(i) = not_a_number()
         counts = counts + [equilibrium%totals%n_strips, equilibrium%totals%n_closed_form]
      end do
   end subroutine solve_strip_block

   !> Is a load without equilibrium for sure, because a larger one had none on the same surface? The load rises with the
   !> penetration without jumps, so where one load has no state all penetrations carry more.
   pure logical function is_hopeless(known, point)
      !> A point without equilibrium, or a default one before there is any.
      type(wavy_case_t), intent(in) :: known
      type(wavy_case_t), intent(in) :: point

      is_hopeless = known%is_load_given .and. point%load <= known%load
      if (is_hopeless) is_hopeless = is_same_surface(known%surface, point%surface)
   end function is_hopeless

   !> Does a point lead to the one before it, and not the other way round?
   pure logical function leads_backwards(first, second)
      !> Values of two points, one after the other in the block; shape `(n_variables)`.
      real(dp), intent(in) :: first(:), second(:)
      type(wavy_case_t) :: one, two

      call resolve_case(first, one)
      call resolve_case(second, two)
      if (one%is_load_given) then
         leads_backwards = leads_to(two%surface, two%load, one%surface, one%load) &
            & .and. .not. leads_to(one%surface, one%load, two%surface, two%load)
      else
         leads_backwards = one%surface%adhesion%stress > 0 .and. is_same_surface(one%surface, two%surface)
         if (one%surface%branch == branch_adhered) then
            leads_backwards = leads_backwards .and. two%surface%shape%is_3d .and. two%penetration > one%penetration
         else
            leads_backwards = leads_backwards .and. two%penetration < one%penetration
         end if
      end if
   end function leads_backwards

   !> Results of a point in SI units.
   pure subroutine store(point, equilibrium, pull_off, results)
      !> The point in reduced units, and what these units are in SI units.
      type(wavy_case_t), intent(in) :: point
      !> What was found at the point, in reduced units.
      type(equilibrium_t), intent(in) :: equilibrium
      !> Pull-off load of the surface of the point, if it is asked for.
      type(pull_off_t), intent(in) :: pull_off
      !> Results in SI units, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(out) :: results(:)
      real(dp) :: width, losses

      results = not_a_number()
      if (equilibrium%status /= status_solved) return
      associate (t => equilibrium%totals)
         results(out%load) = t%load*point%load_unit
         if (point%is_load_given) results(out%load) = point%load*point%load_unit
         results(out%penetration) = equilibrium%penetration*point%height
         results(out%friction_force) = t%friction*point%friction_unit
         results(out%contact_area) = t%contact*point%area_unit
         results(out%adhesion_area) = t%adhesion*point%area_unit
         results(out%dissipation) = t%dissipation*point%friction_unit
         results(out%edge_loss) = t%edge_loss*point%friction_unit
         ! friction that is nothing beside the load has no digits of its own
         losses = max(t%friction_scale + t%dissipation + abs(t%edge_loss), negligible*t%load_scale)
         results(out%energy_imbalance) = 0
         if (losses > 0) results(out%energy_imbalance) = t%energy_mismatch/losses
         ! the terms of an elastic column cancel but for round-off
         if (point%is_elastic) results([out%friction_force, out%dissipation, out%energy_imbalance]) = 0
         if (abs(results(out%load)) > as_good_as_zero*t%load_scale*point%load_unit) &
            & results(out%friction_coefficient) = results(out%friction_force)/results(out%load)
      end associate
      associate (crest => equilibrium%crest)
         width = 2*crest%half_width
         if (crest%regime == regime_free .or. crest%regime == regime_adhesion_only) width = 0
         results(out%contact_width) = width/two_pi*point%period
         results(out%contact_shift) = merge(crest%shift, 0.0_dp, width > 0 .and. crest%half_width < pi)/two_pi*point%period
         results(out%regime) = crest%regime
         if (.not. point%surface%shape%is_3d) call count_zones(crest, point%surface%adhesion, &
            & point%surface%foundation%beta, results)
      end associate
      if (.not. point%wants_pull_off .or. .not. pull_off%is_converged) return
      results(out%pull_off_load) = pull_off%load*point%load_unit
      results(out%pull_off_penetration) = pull_off%penetration*point%height
   end subroutine store

   !> Numbers of zones of the one strip of a 2-D wave.
   pure subroutine count_zones(state, adhesion, beta, results)
      type(steady_state_t), intent(in) :: state
      type(adhesion_t), intent(in) :: adhesion
      !> Ratio of retardation to relaxation time [-].
      real(dp), intent(in) :: beta
      !> Receives the counts; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      type(strip_adhesion_t) :: law
      logical :: has_contact, has_free

      call new_strip_adhesion(law, adhesion, 0.5_dp, beta)
      has_contact = state%regime /= regime_free .and. state%regime /= regime_adhesion_only
      has_free = state%regime == regime_adhesion_zones
      results(out%contact_count) = merge(1, 0, has_contact)
      results(out%adhesion_count) = merge(1, 0, state%regime == regime_adhesion_only .or. state%regime == regime_saturated_adhesion)
      if (has_free) results(out%adhesion_count) = count([state%trailing, state%leading] > 0)
      results(out%snap_count) = merge(1, 0, (has_free .or. (state%regime == regime_adhesion_only .and. state%half_width < pi)) &
         & .and. law%jump > 0)
      results(out%saturated_share) = merge(1, 0, state%regime == regime_saturated)
      results(out%friction_sample_error) = 0
   end subroutine count_zones

end module adfric_foundation_strip_points

! SPDX-License-Identifier: GPL-3.0-or-later
!> Points of `wavy_sliding` on heights or with a spectrum, one after the other.
!>
!> Rows and spectrum are found once for neighbouring points that share them, and so are the ways of the rows for points of one velocity and
!> temperature. A point has no other memory of its neighbours.
module adfric_foundation_stepped_points
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_unset, only: is_set
   use adfric_solid_master_curve, only: master_curve_fit_t
   use adfric_solid_prony, only: prony_t
   use adfric_describe_status, only: status_solved, status_no_equilibrium, status_not_converged
   use adfric_numerics_correlated_mean, only: error_of_mean
   use adfric_shape_height_line, only: linear_pieces
   use adfric_foundation_case, only: kind_2d, kind_map
   use adfric_foundation_given_surface, only: given_surface_t
   use adfric_foundation_stepping_equilibrium, only: march_surface_t, march_equilibrium_t, find_at_penetration, find_at_load, &
      & march_solved, march_no_equilibrium
   use adfric_foundation_stepping_forces, only: march_forces_t
   use adfric_foundation_stepping_law, only: new_march_law
   use adfric_foundation_stepping_profiles, only: get_march_profiles
   use adfric_foundation_stepping_relief, only: relief_t
   use adfric_foundation_stepping_solid, only: solid_t, new_solid
   use adfric_foundation_stepping_path, only: way_t, new_way
   use adfric_foundation_stepped_case, only: marched_case_t, resolve_marched, get_relief, get_spectrum, has_heights, strip_spacing_of, &
      & period_of, shape_places, foundation_places
   use adfric_foundation_strip, only: regime_free, regime_adhesion_only, regime_discrete, regime_saturated_adhesion, &
      & regime_adhesion_zones, regime_saturated, regime_several_contacts, regime_mixed
   use adfric_foundation_surface, only: negligible, share_of_scale
   use adfric_foundation_variables, only: n_wavy_results, r_adhesion_area, r_adhesion_count, r_contact_area, r_contact_count, &
      & r_contact_shift, r_contact_width, r_dissipation, r_edge_loss, r_energy_imbalance, r_friction_coefficient, &
      & r_friction_force, r_friction_sample_error, r_load, r_penetration, r_regime, r_saturated_share, r_snap_count, v_kind, &
      & v_load, v_mean_pressure, v_n_x, v_penetration
   implicit none (type, external)
   private
   public :: solve_marched_block, solve_marched_profiles, row_places, column_places

   !> Load or friction below this share of the sum of its terms is zero but for round-off.
   real(dp), parameter :: as_good_as_zero = 1.0e-13_dp
   !> Round-off of load and friction, over the sizes of their terms and the pressure with which a glassy column answers to lengths.
   real(dp), parameter :: round_off = 4*epsilon(1.0_dp)
   !> Round-off of the lengths of slow dashpots in a contact, over that of one length: they are differences from those of
   !> endless contact, found anew where each part of the contact begins.
   real(dp), parameter :: share_of_places = 8
   !> Chords through half the samples err four times as much as through all, splines sixteen times: the change is 3 and 15 times the
   !> error, if all goes well, so that of chords counts this often.
   real(dp), parameter :: share_of_chords = 3

   !> Points of one surface, and what the last one leaves for the next.
   type :: marched_points_t
      private
      !> Values of the last point; shape `(n_variables)`.
      real(dp), allocatable :: values(:)
      !> Rows of the surface, and of every second sample.
      type(relief_t) :: relief, coarse
      !> The spectrum [Pa/m, s].
      type(prony_t) :: prony
      !> Periods that pass in a second at the ways that are there; negative if there are none.
      real(dp) :: pace = -1
      !> The rows with their ways, and those of every second sample.
      type(march_surface_t) :: surface, coarse_surface
      !> The last point and its state.
      type(marched_case_t) :: point
      !> The state.
      type(march_equilibrium_t) :: equilibrium
   contains
      procedure :: solve
      procedure :: get_profiles
   end type marched_points_t

contains

   !> Solve neighbouring points.
   subroutine solve_marched_block(given, values, results, error_estimate, status)
      !> Lists and datasets of the input.
      type(given_surface_t), intent(in) :: given
      !> Values of the points; shape `(n_variables, n_points)`.
      real(dp), intent(in) :: values(:, :)
      !> Receives the results in SI units, NaN where there is no value; shape `(n_results, n_points)`.
      real(dp), intent(out) :: results(:, :)
      !> Receives the relative errors of load and friction; shape `(n_points)`.
      real(dp), intent(out) :: error_estimate(:)
      !> Receives how each point was solved, one of `status_...`; shape `(n_points)`.
      integer, intent(out) :: status(:)
      type(marched_points_t) :: points
      integer :: i

      do i = 1, size(values, 2)
         call points%solve(values(:, i), given, results(:, i), error_estimate(i), status(i))
      end do
   end subroutine solve_marched_block

   !> Profiles of one point.
   subroutine solve_marched_profiles(given, values, x, profiles)
      !> Lists and datasets of the input.
      type(given_surface_t), intent(in) :: given
      !> Values of the point; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Coordinates along the sliding direction [m]; shape `(n_x)`.
      real(dp), intent(in) :: x(:)
      !> Receives pressure and shear stress [Pa], displacement and gap [m]; shape `(n_x, n_rows, 4)`.
      real(dp), intent(out) :: profiles(:, :, :)
      type(marched_points_t) :: points
      real(dp) :: results(n_wavy_results), error_estimate
      integer :: status

      call points%solve(values, given, results, error_estimate, status)
      profiles = not_a_number()
      if (status == status_solved) call points%get_profiles(x, profiles)
   end subroutine solve_marched_profiles

   !> Places of the rows across the sliding direction [m].
   function row_places(values, given) result(places)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Lists and datasets of the input.
      type(given_surface_t), intent(in) :: given
      real(dp), allocatable :: places(:)
      integer :: i

      if (nint(values(v_kind)) == kind_map) then
         places = [(strip_spacing_of(values, given)*(i - 1), i=1, size(given%heights, 2))]
      else
         places = [0.0_dp]
      end if
   end function row_places

   !> Places of the samples of profiles along the sliding direction: one period, about the crest of a wave [m].
   function column_places(values, given) result(places)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Lists and datasets of the input.
      type(given_surface_t), intent(in) :: given
      real(dp), allocatable :: places(:)
      real(dp) :: period
      integer :: i, n

      n = nint(values(v_n_x))
      period = period_of(values, given)
      places = [(period*(i - 1)/(n - 1), i=1, n)]
      if (nint(values(v_kind)) == kind_2d) places = [(period*(real(2*i - n - 1, dp)/(2*(n - 1))), i=1, n)]
   end function column_places

   !> Solve one point.
   subroutine solve(self, values, given, results, error_estimate, status)
      !> What the last point has left.
      class(marched_points_t), intent(inout) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Lists and datasets of the input.
      type(given_surface_t), intent(in) :: given
      !> Receives the results in SI units, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(out) :: results(:)
      !> Receives the relative error of load and friction, NaN where the point is not solved.
      real(dp), intent(out) :: error_estimate
      !> Receives how the point was solved, one of `status_...`.
      integer, intent(out) :: status
      type(march_equilibrium_t) :: coarse
      type(error_t), allocatable :: error
      logical :: has_samples

      results = not_a_number()
      error_estimate = not_a_number()
      status = status_not_converged
      has_samples = has_heights(values)
      call prepare_rows(self, values, given, has_samples, error)
      if (allocated(error)) return
      call find(self%surface, self%point, self%equilibrium)
      select case (self%equilibrium%status)
      case (march_solved)
         ! a state whose forces are no numbers is none
         if (.not. has_numbers(self%equilibrium)) return
         status = status_solved
      case (march_no_equilibrium)
         status = status_no_equilibrium
         return
      case default
         return
      end select
      if (has_samples) call find(self%coarse_surface, self%point, coarse)
      call store(values, self%point, self%equilibrium, self%relief%crests(1), results)
      error_estimate = get_error(self, coarse, has_samples)
   end subroutine solve

   !> Are penetration and forces numbers?
   pure logical function has_numbers(equilibrium)
      !> The equilibrium.
      type(march_equilibrium_t), intent(in) :: equilibrium

      associate (f => equilibrium%forces)
         has_numbers = ieee_is_finite(equilibrium%depth) .and. all(ieee_is_finite(f%load)) .and. all(ieee_is_finite(f%friction)) &
            & .and. all(ieee_is_finite(f%dissipation)) .and. all(ieee_is_finite(f%edge_loss))
      end associate
   end function has_numbers

   !> Rows, spectrum, ways and law for a point.
   subroutine prepare_rows(self, values, given, has_samples, error)
      !> What the last point has left, of which everything that has changed is made anew.
      class(marched_points_t), intent(inout) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Lists and datasets of the input.
      type(given_surface_t), intent(in) :: given
      !> Are there rows of every second sample?
      logical, intent(in) :: has_samples
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error
      type(master_curve_fit_t) :: fit
      type(solid_t) :: solid

      if (have_changed(self, values, shape_places)) then
         self%pace = -1
         call get_relief(values, given, .false., self%relief, error)
         if (has_samples .and. .not. allocated(error)) call get_relief(values, given, .true., self%coarse, error)
         if (allocated(error)) then
            if (allocated(self%values)) deallocate (self%values)
            return
         end if
      end if
      if (have_changed(self, values, foundation_places)) then
         self%pace = -1
         call get_spectrum(values, given, self%prony, fit)
      end if
      self%values = values
      call resolve_marched(values, given, self%relief, self%prony, self%point)
      if (abs(self%pace - self%point%pace) > 0) then
         call new_solid(solid, self%prony, self%point%pace)
         call lay_ways(self%surface, self%relief, solid)
         if (has_samples) call lay_ways(self%coarse_surface, self%coarse, solid)
         self%pace = self%point%pace
      end if
      call set_law(self%surface, self%point)
      if (has_samples) call set_law(self%coarse_surface, self%point)
   end subroutine prepare_rows

   !> Have values changed since the last point?
   pure logical function have_changed(self, values, places)
      !> What the last point has left.
      class(marched_points_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Places of the variables that are asked for.
      integer, intent(in) :: places(:)

      have_changed = .true.
      if (allocated(self%values)) have_changed = any(abs(values(places) - self%values(places)) > 0)
   end function have_changed

   !> Prepare the ways of all rows.
   subroutine lay_ways(surface, relief, solid)
      !> Receives the ways.
      type(march_surface_t), intent(inout) :: surface
      !> The rows.
      type(relief_t), intent(in) :: relief
      !> The foundation.
      type(solid_t), intent(in) :: solid
      type(way_t), allocatable :: rows(:)
      integer :: i

      allocate (rows(size(relief%rows)))
      !$omp parallel do schedule(static) if (size(rows) > 1)
      do i = 1, size(rows)
         call new_way(rows(i), relief%rows(i), solid)
      end do
      !$omp end parallel do
      call move_alloc(rows, surface%rows)
   end subroutine lay_ways

   !> Adhesion and branch of a surface.
   pure subroutine set_law(surface, point)
      !> The surface, with its ways.
      type(march_surface_t), intent(inout) :: surface
      !> The point.
      type(marched_case_t), intent(in) :: point

      call new_march_law(surface%law, point%stress, point%range, point%edge, surface%rows(1)%solid%glassy)
      surface%is_approach = point%is_approach
   end subroutine set_law

   !> Find the equilibrium of a point.
   subroutine find(surface, point, equilibrium)
      !> The surface.
      type(march_surface_t), intent(in) :: surface
      !> The point.
      type(marched_case_t), intent(in) :: point
      !> Receives the equilibrium.
      type(march_equilibrium_t), intent(out) :: equilibrium

      if (point%is_load_given) then
         call find_at_load(surface, point%load, equilibrium)
      else
         call find_at_penetration(surface, point%penetration, equilibrium)
      end if
   end subroutine find

   !> Mean over rows.
   pure real(dp) function mean(values)
      !> Values of the rows.
      real(dp), intent(in) :: values(:)

      mean = sum(values)/size(values)
   end function mean

   !> Results of a point in SI units.
   pure subroutine store(values, point, equilibrium, crest, results)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> The point.
      type(marched_case_t), intent(in) :: point
      !> Its equilibrium.
      type(march_equilibrium_t), intent(in) :: equilibrium
      !> How far the highest place of the first row is from where its way begins, along the way, in periods.
      real(dp), intent(in) :: crest
      !> Receives the results; those that have no value stay as they are; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      real(dp) :: losses, friction, shift
      integer :: n

      n = size(equilibrium%forces)
      associate (f => equilibrium%forces)
         friction = mean(f%friction)
         ! the terms of an elastic column cancel but for round-off
         if (point%is_elastic) friction = 0
         results(r_load) = mean(f%load)*point%load_unit
         if (is_set(values(v_load))) results(r_load) = values(v_load)
         if (is_set(values(v_mean_pressure))) results(r_load) = values(v_mean_pressure)*point%load_unit/point%pressure_unit
         results(r_penetration) = equilibrium%depth*point%height
         if (is_set(values(v_penetration))) results(r_penetration) = values(v_penetration)
         results(r_friction_force) = friction*point%friction_unit
         ! a load of 0 is given, or is 0 but for round-off
         if (abs(results(r_load)) > as_good_as_zero*mean(f%load_scale)*point%load_unit) &
            & results(r_friction_coefficient) = results(r_friction_force)/results(r_load)
         results(r_contact_area) = mean(f%contact)*point%area_unit
         results(r_adhesion_area) = mean(f%adhesion)*point%area_unit
         results(r_dissipation) = mean(f%dissipation)*point%friction_unit
         results(r_edge_loss) = mean(f%edge_loss)*point%friction_unit
         ! as for strips: losses that are nothing beside the load have no digits of their own
         losses = max(mean(f%friction_scale) + mean(f%dissipation) + mean(abs(f%edge_loss)), negligible*mean(f%load_scale))
         results(r_energy_imbalance) = 0
         if (losses > 0) results(r_energy_imbalance) = mean(f%energy_mismatch)/losses
         if (point%is_elastic) results([r_dissipation, r_energy_imbalance]) = 0
         results(r_contact_count) = sum(f%n_contacts)
         results(r_adhesion_count) = sum(f%n_adhesions)
         results(r_snap_count) = sum(f%n_snaps)
         results(r_saturated_share) = count(regimes_of(f) == regime_saturated)/real(n, dp)
         results(r_friction_sample_error) = merge(0.0_dp, error_of_mean(f%friction)*point%friction_unit, point%is_elastic)
         results(r_regime) = regime_mixed
         if (all(regimes_of(f) == regime_of(f(1)))) results(r_regime) = regime_of(f(1))
         if (n == 1 .and. f(1)%n_contacts == 0) then
            results([r_contact_width, r_contact_shift]) = 0
         else if (n == 1 .and. f(1)%n_contacts == 1) then
            results(r_contact_width) = f(1)%contact_length*point%period
            ! the way of a column goes to smaller x
            shift = f(1)%contact_middle - crest
            results(r_contact_shift) = -(shift - anint(shift))*point%period
            if (regime_of(f(1)) == regime_saturated) results(r_contact_shift) = 0
         end if
      end associate
   end subroutine store

   !> Regimes of rows.
   pure function regimes_of(forces) result(regimes)
      !> Forces and counts of the rows.
      type(march_forces_t), intent(in) :: forces(:)
      integer :: regimes(size(forces))
      integer :: i

      do i = 1, size(forces)
         regimes(i) = regime_of(forces(i))
      end do
   end function regimes_of

   !> Regime of a row.
   pure integer function regime_of(forces) result(regime)
      !> Its forces and counts.
      type(march_forces_t), intent(in) :: forces

      if (forces%n_contacts > 1) then
         regime = regime_several_contacts
      else if (forces%n_contacts == 1) then
         if (forces%n_free > 0) then
            regime = merge(regime_adhesion_zones, regime_discrete, forces%n_adhesions > 0)
         else
            regime = merge(regime_saturated_adhesion, regime_saturated, forces%n_adhesions > 0)
         end if
      else
         regime = merge(regime_adhesion_only, regime_free, forces%n_adhesions > 0)
      end if
   end function regime_of

   !> The larger of the relative errors of load and friction: what the balances leave over and round-off, what every second sample
   !> changes, and what every second row does. A change may be 0 by chance, where its sign turns, so those of load, friction and
   !> areas count together; under a load that of friction would be alone.
   pure real(dp) function get_error(self, coarse, has_samples) result(error)
      !> The points, of which the last one has its equilibrium.
      class(marched_points_t), intent(in) :: self
      !> The equilibrium on every second sample.
      type(march_equilibrium_t), intent(in) :: coarse
      !> Is there one?
      logical, intent(in) :: has_samples
      real(dp) :: errors(2), sizes(2), change, lengths, of_places

      associate (f => self%equilibrium%forces, rows => self%equilibrium%rows, law => self%surface%law)
         sizes = abs([mean(f%load), mean(f%friction)])
         sizes(1) = max(sizes(1), share_of_scale*mean(f%load_scale))
         ! a friction that is nothing beside the load has no digits of its own
         sizes(2) = max(sizes(2), negligible*sizes(1))
         ! places are known to the round-off of lengths, to which a column answers at once, and states to their last step
         lengths = 1 + abs(self%equilibrium%depth) + law%stress + law%shift
         errors = 0
         ! where nothing touches all forces are 0
         if (any(f%n_contacts + f%n_adhesions > 0)) then
            associate (glassy => self%surface%rows(1)%solid%glassy, step => maxval(rows%largest_step))
               errors(1) = mean(abs(f%load_mismatch)) + round_off*(mean(f%load_scale) + glassy*lengths) + step
               ! a pressure that is off by a constant makes no friction but where contact begins lower than it ends
               of_places = share_of_places*round_off*lengths + step
               errors(2) = mean(abs(f%energy_mismatch)) + round_off*mean(f%friction_scale) &
                  & + of_places*(glassy*mean(f%contact_rise) + law%stress)
            end associate
         end if
         change = 0
         if (has_samples) then
            change = 1
            if (coarse%status == march_solved) change = get_change(f, coarse%forces, sizes)
            if (self%relief%rows(1)%degree == linear_pieces) change = share_of_chords*change
         end if
         ! half of the difference is what leaving out every second row changes; where rows jump, that is no more than the error
         if (size(f) > 1) change = change + get_change(f(1::2), f(2::2), sizes)
      end associate
      if (self%point%is_load_given) errors(1) = 0
      if (self%point%is_elastic) errors(2) = 0
      error = min(1.0_dp, maxval(errors/max(sizes, errors, tiny(1.0_dp))) + change)
   end function get_error

   !> By how much two sets of rows differ in load, friction and areas, as a share of each.
   pure real(dp) function get_change(one, other, sizes) result(change)
      !> Forces of the rows of both sets.
      type(march_forces_t), intent(in) :: one(:), other(:)
      !> What load and friction are relative to.
      real(dp), intent(in) :: sizes(2)
      real(dp) :: differences(2), area

      area = max(mean(one%contact) + mean(one%adhesion), mean(other%contact) + mean(other%adhesion), tiny(1.0_dp))
      differences = abs([mean(one%load) - mean(other%load), mean(one%friction) - mean(other%friction)])
      change = sum(differences/max(sizes, differences, tiny(1.0_dp))) &
         & + (abs(mean(one%contact) - mean(other%contact)) + abs(mean(one%adhesion) - mean(other%adhesion)))/area
   end function get_change

   !> Profiles of the point that was solved last, in SI units.
   subroutine get_profiles(self, x, profiles)
      !> The points, of which the last one was solved.
      class(marched_points_t), intent(in) :: self
      !> Coordinates along the sliding direction [m]; shape `(n_x)`.
      real(dp), intent(in) :: x(:)
      !> Receives pressure and shear stress [Pa], displacement and gap [m]; shape `(n_x, n_rows, 4)`.
      real(dp), intent(out) :: profiles(:, :, :)
      integer :: i

      associate (p => self%point)
         do i = 1, size(self%surface%rows)
            call get_march_profiles(self%surface%rows(i), self%surface%law, self%equilibrium%depth, &
               & self%equilibrium%rows(i)%period, self%relief%starts(i), x/p%period, profiles(:, i, :))
         end do
         profiles(:, :, 1) = profiles(:, :, 1)*p%pressure_unit
         profiles(:, :, 2) = profiles(:, :, 2)*p%pressure_unit*p%height/p%period
         profiles(:, :, 3:4) = profiles(:, :, 3:4)*p%height
      end associate
   end subroutine get_profiles

end module adfric_foundation_stepped_points

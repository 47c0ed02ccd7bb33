! SPDX-License-Identifier: GPL-3.0-or-later
!> Points of `wavy_sliding` on heights or with a spectrum, one after the other.
!>
!> Rows and spectrum are found once for neighbouring points that share them, and so are the paths of the rows for points of one
!> velocity and temperature. A point has no other memory of its neighbours. The file is long by what a point stores: sums over rows,
!> bounds, and profiles.
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
   use adfric_foundation_stepping_equilibrium, only: stepping_surface_t, stepping_equilibrium_t, find_at_penetration, &
      & find_at_load, &
      & stepping_solved, stepping_no_equilibrium
   use adfric_foundation_stepping_forces, only: stepping_forces_t
   use adfric_foundation_stepping_law, only: new_stepping_law, new_attracting_law
   use adfric_foundation_stepping_profiles, only: get_stepping_profiles
   use adfric_foundation_stepping_relief, only: relief_t
   use adfric_foundation_stepping_solid, only: solid_t, new_solid
   use adfric_foundation_stepping_path, only: column_path_t, new_path
   use adfric_foundation_stepped_case, only: stepped_case_t, resolve_stepped, get_relief, get_spectrum, has_heights, &
      & strip_spacing_of, &
      & period_of, shape_positions, foundation_positions
   use adfric_foundation_strip, only: regime_free, regime_adhesion_only, regime_discrete, regime_saturated_adhesion, &
      & regime_adhesion_zones, regime_saturated, regime_several_contacts, regime_mixed
   use adfric_foundation_surface, only: negligible, share_of_scale
   use adfric_foundation_variables, only: n_wavy_results, in => foundation_input, out => foundation_output
   implicit none (type, external)
   private
   public :: solve_stepped_block, solve_stepped_profiles, row_indices, column_indices

   !> Load or friction below this share of the sum of its terms is zero but for round-off.
   real(dp), parameter :: as_good_as_zero = 1.0e-13_dp
   !> Round-off of load and friction, over the sizes of their terms and the pressure with which a glassy column answers to lengths.
   real(dp), parameter :: round_off = 4*epsilon(1.0_dp)
   !> Round-off of the lengths of slow dashpots in a contact, over that of one length: they are differences from those of
   !> endless contact, found anew where each part of the contact begins.
   real(dp), parameter :: share_of_indices = 8
   !> Chords through half the samples err four times as much as through all, splines sixteen times: the change is 3 and 15 times the
   !> error, if all goes well, so that of chords counts this often.
   real(dp), parameter :: share_of_chords = 3

   !> Points of one surface, and what the last one leaves for the next.
   type :: stepped_points_t
      private
      !> Values of the last point; shape `(n_variables)`.
      real(dp), allocatable :: values(:)
      !> Rows of the surface, and of every second sample.
      type(relief_t) :: relief, coarse
      !> The spectrum [Pa/m, s].
      type(prony_t) :: prony
      !> Periods that pass in a second on the paths that are there; negative if there are none.
      real(dp) :: pace = -1
      !> The rows with their paths, and those of every second sample.
      type(stepping_surface_t) :: surface, coarse_surface
      !> The last point and its state.
      type(stepped_case_t) :: point
      !> The state.
      type(stepping_equilibrium_t) :: equilibrium
   contains
      procedure :: solve
      procedure :: get_profiles
   end type stepped_points_t

contains

   !> Solve neighbouring points.
   subroutine solve_stepped_block(given, values, results, error_estimate, status)
      type(given_surface_t), intent(in) :: given
      !> Values of the points; shape `(n_variables, n_points)`.
      real(dp), intent(in) :: values(:, :)
      !> Receives the results in SI units, NaN where there is no value; shape `(n_results, n_points)`.
      real(dp), intent(out) :: results(:, :)
      !> Receives the relative errors of load and friction; shape `(n_points)`.
      real(dp), intent(out) :: error_estimate(:)
      !> Receives how each point was solved, one of `status_...`; shape `(n_points)`.
      integer, intent(out) :: status(:)
      type(stepped_points_t) :: points
      integer :: i

      do i = 1, size(values, 2)
         call points%solve(values(:, i), given, results(:, i), error_estimate(i), status(i))
      end do
   end subroutine solve_stepped_block

   !> Profiles of one point.
   subroutine solve_stepped_profiles(given, values, x, profiles)
      type(given_surface_t), intent(in) :: given
      !> Values of the point; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Coordinates along the sliding direction [m]; shape `(n_x)`.
      real(dp), intent(in) :: x(:)
      !> Receives pressure and shear stress [Pa], displacement and gap [m]; shape `(n_x, n_rows, 4)`.
      real(dp), intent(out) :: profiles(:, :, :)
      type(stepped_points_t) :: points
      real(dp) :: results(n_wavy_results), error_estimate
      integer :: status

      call points%solve(values, given, results, error_estimate, status)
      profiles = not_a_number()
      if (status == status_solved) call points%get_profiles(x, profiles)
   end subroutine solve_stepped_profiles

   !> Indices of the rows across the sliding direction [m].
   function row_indices(values, given) result(indices)
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given
      real(dp), allocatable :: indices(:)
      integer :: i

      if (nint(values(in%kind)) == kind_map) then
         indices = [(strip_spacing_of(values, given)*(i - 1), i=1, size(given%heights, 2))]
      else
         indices = [0.0_dp]
      end if
   end function row_indices

   !> Indices of the samples of profiles along the sliding direction: one period, about the crest of a wave [m].
   function column_indices(values, given) result(indices)
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given
      real(dp), allocatable :: indices(:)
      real(dp) :: period
      integer :: i, n

      n = nint(values(in%n_x))
      period = period_of(values, given)
      indices = [(period*(i - 1)/(n - 1), i=1, n)]
      if (nint(values(in%kind)) == kind_2d) indices = [(period*(real(2*i - n - 1, dp)/(2*(n - 1))), i=1, n)]
   end function column_indices

   !> Solve one point.
   subroutine solve(self, values, given, results, error_estimate, status)
      class(stepped_points_t), intent(inout) :: self
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given
      !> Receives the results in SI units, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(out) :: results(:)
      !> Receives the relative error of load and friction, NaN where the point is not solved.
      real(dp), intent(out) :: error_estimate
      !> Receives how the point was solved, one of `status_...`.
      integer, intent(out) :: status
      type(stepping_equilibrium_t) :: coarse
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
      case (stepping_solved)
         ! a state whose forces are no numbers is none
         if (.not. has_numbers(self%equilibrium)) return
         status = status_solved
      case (stepping_no_equilibrium)
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
      type(stepping_equilibrium_t), intent(in) :: equilibrium

      associate (f => equilibrium%forces)
         has_numbers = ieee_is_finite(equilibrium%depth) .and. all(ieee_is_finite(f%load)) .and. all(ieee_is_finite(f%friction)) &
            & .and. all(ieee_is_finite(f%dissipation)) .and. all(ieee_is_finite(f%edge_loss))
      end associate
   end function has_numbers

   !> Rows, spectrum, paths and law for a point.
   subroutine prepare_rows(self, values, given, has_samples, error)
      !> What the last point has left, of which everything that has changed is made anew.
      class(stepped_points_t), intent(inout) :: self
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given
      !> Are there rows of every second sample?
      logical, intent(in) :: has_samples
      type(error_t), allocatable, intent(out) :: error
      type(master_curve_fit_t) :: fit
      type(solid_t) :: solid

      if (have_changed(self, values, shape_positions)) then
         self%pace = -1
         call get_relief(values, given, .false., self%relief, error)
         if (has_samples .and. .not. allocated(error)) call get_relief(values, given, .true., self%coarse, error)
         if (allocated(error)) then
            if (allocated(self%values)) deallocate (self%values)
            return
         end if
      end if
      if (have_changed(self, values, foundation_positions)) then
         self%pace = -1
         call get_spectrum(values, given, self%prony, fit)
      end if
      self%values = values
      call resolve_stepped(values, given, self%relief, self%prony, self%point)
      if (abs(self%pace - self%point%pace) > 0) then
         call new_solid(solid, self%prony, self%point%pace)
         call lay_paths(self%surface, self%relief, solid)
         if (has_samples) call lay_paths(self%coarse_surface, self%coarse, solid)
         self%pace = self%point%pace
      end if
      call set_law(self%surface, self%point)
      if (has_samples) call set_law(self%coarse_surface, self%point)
   end subroutine prepare_rows

   !> Have values changed since the last point?
   pure logical function have_changed(self, values, indices)
      class(stepped_points_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Indices of the variables that are asked for.
      integer, intent(in) :: indices(:)

      have_changed = .true.
      if (allocated(self%values)) have_changed = any(abs(values(indices) - self%values(indices)) > 0)
   end function have_changed

   !> Prepare the paths of all rows.
   subroutine lay_paths(surface, relief, solid)
      type(stepping_surface_t), intent(inout) :: surface
      type(relief_t), intent(in) :: relief
      type(solid_t), intent(in) :: solid
      type(column_path_t), allocatable :: rows(:)
      integer :: i

      allocate (rows(size(relief%rows)))
      !$omp parallel do schedule(static) if (size(rows) > 1)
      do i = 1, size(rows)
         call new_path(rows(i), relief%rows(i), solid)
      end do
      !$omp end parallel do
      call move_alloc(rows, surface%rows)
   end subroutine lay_paths

   !> Adhesion and branch of a surface.
   pure subroutine set_law(surface, point)
      type(stepping_surface_t), intent(inout) :: surface
      type(stepped_case_t), intent(in) :: point

      if (allocated(point%attraction)) then
         call new_attracting_law(surface%law, point%attraction, surface%rows(1)%solid%glassy)
      else
         call new_stepping_law(surface%law, point%stress, point%range, point%edge, surface%rows(1)%solid%glassy)
      end if
      surface%is_approach = point%is_approach
   end subroutine set_law

   !> Find the equilibrium of a point.
   subroutine find(surface, point, equilibrium)
      type(stepping_surface_t), intent(in) :: surface
      type(stepped_case_t), intent(in) :: point
      type(stepping_equilibrium_t), intent(out) :: equilibrium

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
      real(dp), intent(in) :: values(:)
      type(stepped_case_t), intent(in) :: point
      type(stepping_equilibrium_t), intent(in) :: equilibrium
      !> How far the highest index of the first row is from where its path begins, along the path, in periods.
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
         results(out%load) = mean(f%load)*point%load_unit
         if (is_set(values(in%load))) results(out%load) = values(in%load)
         if (is_set(values(in%mean_pressure))) results(out%load) = values(in%mean_pressure)*point%load_unit/point%pressure_unit
         results(out%penetration) = equilibrium%depth*point%height
         if (is_set(values(in%penetration))) results(out%penetration) = values(in%penetration)
         results(out%friction_force) = friction*point%friction_unit
         ! a load of 0 is given, or is 0 but for round-off
         if (abs(results(out%load)) > as_good_as_zero*mean(f%load_scale)*point%load_unit) &
            & results(out%friction_coefficient) = results(out%friction_force)/results(out%load)
         results(out%contact_area) = mean(f%contact)*point%area_unit
         results(out%adhesion_area) = mean(f%adhesion)*point%area_unit
         results(out%dissipation) = mean(f%dissipation)*point%friction_unit
         results(out%edge_loss) = mean(f%edge_loss)*point%friction_unit
         ! as for strips: losses that are nothing beside the load have no digits of their own
         losses = max(mean(f%friction_scale) + mean(f%dissipation) + mean(abs(f%edge_loss)), negligible*mean(f%load_scale))
         results(out%energy_imbalance) = 0
         if (losses > 0) results(out%energy_imbalance) = mean(f%energy_mismatch)/losses
         if (point%is_elastic) results([out%dissipation, out%energy_imbalance]) = 0
         results(out%contact_count) = sum(f%n_contacts)
         results(out%adhesion_count) = sum(f%n_adhesions)
         results(out%snap_count) = sum(f%n_snaps)
         results(out%saturated_share) = count(regimes_of(f) == regime_saturated)/real(n, dp)
         results(out%friction_sample_error) = merge(0.0_dp, error_of_mean(f%friction)*point%friction_unit, point%is_elastic)
         results(out%regime) = regime_mixed
         if (all(regimes_of(f) == regime_of(f(1)))) results(out%regime) = regime_of(f(1))
         if (n == 1 .and. f(1)%n_contacts == 0) then
            results([out%contact_width, out%contact_shift]) = 0
         else if (n == 1 .and. f(1)%n_contacts == 1) then
            results(out%contact_width) = f(1)%contact_length*point%period
            ! the path of a column goes to smaller x
            shift = f(1)%contact_middle - crest
            results(out%contact_shift) = -(shift - anint(shift))*point%period
            if (regime_of(f(1)) == regime_saturated) results(out%contact_shift) = 0
         end if
      end associate
   end subroutine store

   !> Regimes of rows.
   pure function regimes_of(forces) result(regimes)
      type(stepping_forces_t), intent(in) :: forces(:)
      integer :: regimes(size(forces)), i

      do i = 1, size(forces)
         regimes(i) = regime_of(forces(i))
      end do
   end function regimes_of

   !> Regime of a row.
   pure integer function regime_of(forces) result(regime)
      type(stepping_forces_t), intent(in) :: forces

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
      class(stepped_points_t), intent(in) :: self
      type(stepping_equilibrium_t), intent(in) :: coarse
      logical, intent(in) :: has_samples
      real(dp) :: errors(2), sizes(2), change, lengths, of_indices

      associate (f => self%equilibrium%forces, rows => self%equilibrium%rows, law => self%surface%law)
         sizes = abs([mean(f%load), mean(f%friction)])
         sizes(1) = max(sizes(1), share_of_scale*mean(f%load_scale))
         ! a friction that is nothing beside the load has no digits of its own
         sizes(2) = max(sizes(2), negligible*sizes(1))
         ! indices are known to the round-off of lengths, to which a column answers at once, and states to their last step
         lengths = 1 + abs(self%equilibrium%depth) + law%stress + law%shift
         errors = 0
         ! where nothing touches all forces are 0
         if (any(f%n_contacts + f%n_adhesions > 0)) then
            associate (glassy => self%surface%rows(1)%solid%glassy, step => maxval(rows%largest_step))
               errors(1) = mean(abs(f%load_mismatch)) + round_off*(mean(f%load_scale) + glassy*lengths) + step + law%resolution
               ! a pressure that is off by a constant makes no friction but where contact begins lower than it ends
               of_indices = share_of_indices*round_off*lengths + step
               errors(2) = mean(abs(f%energy_mismatch)) + round_off*mean(f%friction_scale) &
                  & + of_indices*(glassy*mean(f%contact_rise) + law%stress) + law%resolution
            end associate
         end if
         change = 0
         if (has_samples) then
            change = 1
            if (coarse%status == stepping_solved) change = get_change(f, coarse%forces, sizes)
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
      type(stepping_forces_t), intent(in) :: one(:), other(:)
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
      class(stepped_points_t), intent(in) :: self
      real(dp), intent(in) :: x(:)
      real(dp), intent(out) :: profiles(:, :, :)
      integer :: i

      associate (p => self%point)
         do i = 1, size(self%surface%rows)
            call get_stepping_profiles(self%surface%rows(i), self%surface%law, self%equilibrium%depth, &
               & self%equilibrium%rows(i)%state, &
               & self%equilibrium%rows(i)%period, self%relief%starts(i), x/p%period, profiles(:, i, :))
         end do
         profiles(:, :, 1) = profiles(:, :, 1)*p%pressure_unit
         profiles(:, :, 2) = profiles(:, :, 2)*p%pressure_unit*p%height/p%period
         profiles(:, :, 3:4) = profiles(:, :, 3:4)*p%height
      end associate
   end subroutine get_profiles

end module adfric_foundation_stepped_points

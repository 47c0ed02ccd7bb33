! SPDX-License-Identifier: GPL-3.0-or-later
!> The results that `surface_sliding` has beside those of all models of a periodic surface, and the error of the friction.
module adfric_periodic_sliding_results
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_interface_adhesion_rows, only: adhesion_law_t
   use adfric_solid_order_margin, only: order_margin_of
   use adfric_periodic_adhesion_cells, only: adhesion_fraction_of, cells_per_zone, error_of_edge, error_of_pull_off, few_cells, &
      & regime_of
   use adfric_periodic_area, only: relative_error_of
   use adfric_periodic_contact_centre, only: contact_centre
   use adfric_periodic_coupled_kernel, only: coupled_kernel_t
   use adfric_periodic_coupled_losses, only: heat_of_half_space
   use adfric_periodic_sliding_variables, only: kind_heights, kind_wave_2d, in => sliding_input, sliding_output
   use adfric_periodic_point, only: periodic_surface_t
   use adfric_periodic_solver, only: branches_differ, branches_unknown, periodic_solution_t
   use adfric_periodic_variables, only: periodic_output, regime_none
   use adfric_periodic_viscoelastic_solid, only: viscoelastic_solid_t
   use adfric_periodic_wave_contact, only: wave_friction_of_full_contact
   implicit none (type, external)
   private
   public :: set_sliding_results, peak_of_wave

   !> Factor of the error by another law than Dugdale's where a zone has few cells: 64 cases (`docs/theory/attraction_laws.md`).
   real(dp), parameter :: error_of_few_cells = 2

contains

   !> Set friction and what goes with it.
   subroutine set_sliding_results(values, law, surface, solid, solution, results, error_estimate)
      real(dp), intent(in) :: values(:)
      !> The adhesion, without a stress where there is none.
      type(adhesion_law_t), intent(in) :: law
      !> Periods and cells of the surface [m].
      type(periodic_surface_t), intent(in) :: surface
      type(viscoelastic_solid_t), intent(in) :: solid
      !> Solution of the point; lengths in m, pressures in E0.
      type(periodic_solution_t), intent(in) :: solution
      !> In: with the results that all these models have. Out: with all; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Estimated relative error of the friction [-]; where there is none, that of the area.
      real(dp), intent(out) :: error_estimate
      real(dp) :: loss, direct
      logical :: is_wave

      is_wave = nint(values(in%kind)) /= kind_heights
      loss = solid%forward(solution%friction%loss)
      direct = solid%forward(solution%friction%direct)
      ! bodies apart have the round-off of nothing
      if (regime_of(solution) == regime_none) then
         loss = 0
         direct = 0
      end if
      results([sliding_output%friction_stress, sliding_output%dissipation]) = loss*solid%modulus
      results(sliding_output%friction_coefficient) = not_a_number()
      if (results(periodic_output%mean_pressure) > 0) results(sliding_output%friction_coefficient) = &
         & results(sliding_output%friction_stress)/results(periodic_output%mean_pressure)
      results(sliding_output%lateral_stress) = solid%leftward(solution%friction%loss)*solid%modulus
      results(sliding_output%full_contact_friction) = solid%forward(solution%full_friction)*solid%modulus
      if (is_wave) results(sliding_output%full_contact_friction) = solid%modulus*wave_friction_of_full_contact(solid, &
         & values(in%amplitude)/values(in%period), nint(values(in%kind)) == kind_wave_2d)
      results(sliding_output%contact_shift) = not_a_number()
      if (is_wave) results(sliding_output%contact_shift) = values(in%period) &
         & *shift_of(contact_pressure(solution, law%stress/solid%modulus), solid)
      results(sliding_output%energy_imbalance) = 0
      if (max(abs(direct), abs(loss)) > 0) results(sliding_output%energy_imbalance) = (direct - loss)/max(abs(direct), abs(loss))
      results(sliding_output%regime) = regime_of(solution)
      error_estimate = 0
      if (regime_of(solution) /= regime_none) error_estimate = error_of(solid, solution)
      ! in closed form
      if (is_wave .and. results(periodic_output%mean_pressure) >= results(periodic_output%full_contact_pressure)) error_estimate &
         & = 4*epsilon(1.0_dp)
      if (law%stress > 0) call set_adhesive_results(law, surface, solid, solution, results, error_estimate)
      if (allocated(solid%coupling)) call set_coupled_results(surface, solid, solution, results)
   end subroutine set_sliding_results

   !> Set what is known where shear moves the surface. What a layer loses is not.
   subroutine set_coupled_results(surface, solid, solution, results)
      !> Periods and cells of the surface [m].
      type(periodic_surface_t), intent(in) :: surface
      type(viscoelastic_solid_t), intent(in) :: solid
      !> Solution of the point; pressures in E0.
      type(periodic_solution_t), intent(in) :: solution
      !> In: with those of the pressure alone. Out: with those of the coupling; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      integer :: along, i

      results(sliding_output%smallest_stiffness_ratio) = solution%stiffness_ratio
      results(sliding_output%largest_coupling) = 0
      associate (coupling => solid%coupling, period => surface%period/surface%period(1))
         do along = 1, 2
            do i = 1, surface%n_cells(along)/2
               results(sliding_output%largest_coupling) = max(results(sliding_output%largest_coupling), &
                  & abs(coupling%coupling_of_wave(i/period(along))))
            end do
         end do
         results(sliding_output%dissipation) = not_a_number()
         if (coupling%thickness > 0) return
         select type (kernel => solid%kernel)
         type is (coupled_kernel_t)
            results(sliding_output%dissipation) = solid%modulus*heat_of_half_space(kernel, solution%pressure, period)
         end select
      end associate
   end subroutine set_coupled_results

   !> Set what adhesion adds.
   subroutine set_adhesive_results(law, surface, solid, solution, results, error_estimate)
      type(adhesion_law_t), intent(in) :: law
      !> Periods and cells of the surface [m].
      type(periodic_surface_t), intent(in) :: surface
      type(viscoelastic_solid_t), intent(in) :: solid
      !> Solution of the point; lengths in m, pressures in E0.
      type(periodic_solution_t), intent(in) :: solution
      !> In: with all other results. Out: with all; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> In: without the error of the edge of adhesion. Out: the larger of both; above 1 where the cells do not see that edge.
      real(dp), intent(inout) :: error_estimate

      ! other laws than Dugdale's have no zone with an end
      results(sliding_output%adhesion_fraction) = not_a_number()
      if (.not. allocated(law%attraction)) results(sliding_output%adhesion_fraction) = adhesion_fraction_of(solution)
      results(sliding_output%cells_per_zone) = cells_per_zone(law, surface)
      results(sliding_output%order_margin) = order_margin_of(solid%prony%moduli/solid%prony%relaxed, solid%prony%times)
      if (allocated(solution%loss_without_adhesion)) results(sliding_output%friction_without_adhesion) = &
         & solid%forward(solution%loss_without_adhesion)*solid%modulus
      if (results(periodic_output%mean_pressure) >= results(periodic_output%full_contact_pressure)) &
         & results(sliding_output%friction_without_adhesion) = results(sliding_output%friction_stress)
      results(sliding_output%adhesive_friction_stress) = results(sliding_output%friction_stress) &
         & - results(sliding_output%friction_without_adhesion)
      if (solution%branches /= branches_unknown) results(sliding_output%branches_differ) = &
         & merge(1, 0, solution%branches == branches_differ)
      if (solution%pull_off < huge(1.0_dp)) results(sliding_output%pull_off_pressure) = solid%modulus*solution%pull_off
      error_estimate = max(error_estimate, error_of_pull_off(solution, results(sliding_output%cells_per_zone)))
      if (.not. allocated(solution%share)) return
      if (.not. (any(solution%share > 0) .and. any(solution%share < 1))) return
      associate (n => results(sliding_output%cells_per_zone))
         ! coarser grids have no zone to compare, and a tension that is that in the middles of cells
         if (allocated(law%attraction) .and. n < few_cells) error_estimate = min(error_of_few_cells*error_estimate, 1.0_dp)
         error_estimate = max(error_estimate, error_of_edge(n))
      end associate
   end subroutine set_adhesive_results

   !> Pressure with the tension of adhesion added: above 0 in contact alone [E0].
   pure function contact_pressure(solution, stress) result(pressure)
      type(periodic_solution_t), intent(in) :: solution
      !> Stress of adhesion [E0].
      real(dp), intent(in) :: stress
      real(dp), allocatable :: pressure(:, :)

      allocate (pressure, source=solution%pressure)
      if (allocated(solution%share)) pressure(:, :) = merge(0.0_dp, pressure + stress*solution%share, solution%gap > 0)
   end function contact_pressure

   !> Relative error of the friction: the largest of what its two forms differ by, of what the last grid has changed, and of half of what
   !> the one before it has changed; 1 at most, and where the loss is no number above round-off. Where nothing rubs, that of the area.
   pure real(dp) function error_of(solid, solution) result(error)
      type(viscoelastic_solid_t), intent(in) :: solid
      type(periodic_solution_t), intent(in) :: solution
      real(dp) :: loss, whole, coarse(size(solution%coarse_losses, 2))
      integer :: k

      loss = solid%forward(solution%friction%loss)
      ! of a coupled contact the shear stress has no error, and the force on the slopes may be below 0
      whole = loss
      if (allocated(solid%coupling)) whole = whole + solid%coupling%friction_coefficient*solution%mean_pressure
      error = 1
      if (.not. max(abs(loss), abs(solid%forward(solution%friction%direct))) > 0) error = relative_error_of(solution%area)
      if (.not. whole > 0 .or. .not. max(abs(loss), abs(solid%forward(solution%friction%direct))) > 0) return
      error = abs(solid%forward(solution%friction%direct) - loss)
      coarse = [(solid%forward(solution%coarse_losses(:, k)), k=1, size(coarse))]
      if (solution%n_coarse_losses < size(coarse)) then
         error = max(error, abs(loss))
      else
         error = max(error, abs(coarse(1) - loss), abs(coarse(2) - coarse(1))/2)
      end if
      error = error/max(whole, error)
   end function error_of

   !> Shift of the contact from the crest towards the leading side [periods], -1/2 to 1/2; NaN where there is no contact or no gap,
   !> and along diagonals.
   pure real(dp) function shift_of(pressure, solid) result(shift)
      !> Pressure in the middles of the cells of one period.
      real(dp), intent(in) :: pressure(:, :)
      type(viscoelastic_solid_t), intent(in) :: solid

      shift = not_a_number()
      associate (steps => solid%motion%steps)
         if (steps(2) == 0) shift = steps(1)*contact_centre(pressure, 1)
         if (steps(1) == 0) shift = steps(2)*contact_centre(pressure, 2)
      end associate
   end function shift_of

   !> Largest value of a smooth map: that of the largest cell, and of the parabolas through it and its neighbours.
   pure real(dp) function peak_of_wave(map) result(peak)
      !> The map in the middles of cells; goes on periodically.
      real(dp), intent(in) :: map(:, :)
      integer :: index(2), n(2)

      index = maxloc(map)
      n = shape(map)
      peak = map(index(1), index(2))
      associate (i => index(1), j => index(2))
         peak = peak + rise(map(modulo(i - 2, n(1)) + 1, j), map(i, j), map(modulo(i, n(1)) + 1, j)) &
            & + rise(map(i, modulo(j - 2, n(2)) + 1), map(i, j), map(i, modulo(j, n(2)) + 1))
      end associate
   end function peak_of_wave

   !> How far a parabola rises above the largest of its three values.
   pure real(dp) function rise(before, largest, after)
      !> The values; the second one is not less than the others.
      real(dp), intent(in) :: before, largest, after

      rise = 0
      associate (curvature => (largest - before) + (largest - after))
         if (curvature > 0) rise = (after - before)**2/(8*curvature)
      end associate
   end function rise

end module adfric_periodic_sliding_results

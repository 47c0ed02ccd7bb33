! SPDX-License-Identifier: GPL-3.0-or-later
!> What the cells of a periodic surface tell of its adhesion: the regime, and how well they see a short zone.
!>
!> A zone of adhesion at the edge of a wide contact has the length pi E* h0/(4 p0) on an elastic half-space. On an elastic layer or
!> coating E* is the modulus of waves of that length (`adfric_periodic_layer_kernel`). On a viscoelastic solid E* is that of the
!> relaxed solid here: no zone is shorter than 0.89 times that, at any velocity.
module adfric_periodic_adhesion_cells
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_describe_derived, only: add_derived, derived_t
   use adfric_interface_adhesion_rows, only: adhesion_law_t, adhesion_names
   use adfric_periodic_point, only: periodic_surface_t
   use adfric_periodic_solver, only: periodic_solution_t
   use adfric_periodic_variables, only: regime_adhesion_only, regime_adhesion_zones, regime_full, regime_none, regime_partial, &
      & regime_saturated_adhesion
   implicit none (type, external)
   private
   public :: adhesion_fraction_of, are_sizes_possible, cells_per_zone, derive_zone, doubt_zone, error_of_edge, error_of_pull_off
   public :: few_cells
   public :: regime_of, sees_pull_off, tension_outside

   !> Cells per zone below which there is a doubt, and below which edges of adhesion are those of the cells.
   real(dp), parameter :: few_cells = 4, least_cells = 0.5_dp
   !> Error of an edge of adhesion with one cell per zone; it falls with the cells, below one with their square (`bench/run
   !> adhesion_cells`).
   real(dp), parameter :: error_of_cell = 0.05_dp
   !> Stress over E* height/period, and range over height, that are taken.
   real(dp), parameter :: least_size = 1.0e-12_dp, largest_size = 1.0e12_dp

contains

   !> The regime of a solution.
   pure integer function regime_of(solution) result(regime)
      type(periodic_solution_t), intent(in) :: solution

      regime = merge(regime_partial, regime_none, solution%area%cells > 0)
      if (allocated(solution%share)) then
         if (.not. any(solution%share < 1)) then
            regime = regime_saturated_adhesion
         else if (any(solution%share > 0)) then
            regime = merge(regime_adhesion_zones, regime_adhesion_only, solution%area%cells > 0)
         end if
      end if
      if (solution%area%cells >= 1) regime = regime_full
   end function regime_of

   !> Share of the area in adhesion without contact.
   pure real(dp) function adhesion_fraction_of(solution) result(fraction)
      type(periodic_solution_t), intent(in) :: solution

      fraction = 0
      if (.not. allocated(solution%share)) return
      fraction = max(sum(solution%share)/real(size(solution%gap), dp) - solution%area%corrected, 0.0_dp)
   end function adhesion_fraction_of

   !> Tension of adhesion outside contact, over nominal area [Pa].
   pure real(dp) function tension_outside(law, solution) result(tension)
      type(adhesion_law_t), intent(in) :: law
      type(periodic_solution_t), intent(in) :: solution

      tension = 0
      if (allocated(law%attraction)) then
         ! in full contact nothing is outside
         if (.not. allocated(solution%share)) return
         tension = law%stress*(sum(solution%share, mask=solution%gap > 0)/size(solution%gap))
      else if (allocated(solution%weighted_share)) then
         tension = maxval(law%part)*law%stress*(sum(solution%weighted_share, mask=solution%gap > 0)/size(solution%gap))
      else
         tension = law%stress*adhesion_fraction_of(solution)
      end if
   end function tension_outside

   !> Length of a short zone of adhesion [m].
   pure real(dp) function zone_length(law, surface) result(length)
      type(adhesion_law_t), intent(in) :: law
      !> Periods and cells of the surface [m], and its solid.
      type(periodic_surface_t), intent(in) :: surface

      length = pi*surface%solid%modulus*law%range/(4*law%stress)
      if (.not. allocated(surface%solid%kernel)) return
      associate (unit => surface%period(1))
         length = length*surface%solid%kernel%stretch_of_zone(length/unit, maxval(surface%period, mask=surface%n_cells > 1)/unit)
      end associate
   end function zone_length

   !> That over the length of a cell.
   pure real(dp) function cells_per_zone(law, surface)
      type(adhesion_law_t), intent(in) :: law
      !> Periods and cells of the surface [m], and its solid.
      type(periodic_surface_t), intent(in) :: surface

      associate (size => surface%cell_sizes())
         cells_per_zone = zone_length(law, surface)/maxval(size, mask=surface%n_cells > 1)
      end associate
   end function cells_per_zone

   !> Can the cells tell a pull-off? Where they cannot it is not sought.
   pure logical function sees_pull_off(law, surface)
      type(adhesion_law_t), intent(in) :: law
      !> Periods and cells of the surface [m], and its solid.
      type(periodic_surface_t), intent(in) :: surface

      sees_pull_off = cells_per_zone(law, surface) >= least_cells
   end function sees_pull_off

   !> Add the work of adhesion, and what a short zone is on the cells.
   subroutine derive_zone(derived, law, surface, meaning)
      type(derived_t), allocatable, intent(inout) :: derived(:)
      type(adhesion_law_t), intent(in) :: law
      !> Periods and cells of the surface [m], and its solid.
      type(periodic_surface_t), intent(in) :: surface
      !> What the length of a zone is on this solid.
      character(*), intent(in) :: meaning

      call add_derived(derived, 'surface_energy', 'J/m^2', 'stress times range', law%stress*law%range, adhesion_names)
      call add_derived(derived, 'zone_length', 'm', meaning, zone_length(law, surface))
      call add_derived(derived, 'cells_per_zone', '-', 'that over the length of a cell; a few are needed', &
         & cells_per_zone(law, surface))
   end subroutine derive_zone

   !> Relative error that the cells make of the edge of adhesion.
   pure real(dp) function error_of_edge(cells) result(error)
      !> Cells per zone.
      real(dp), intent(in) :: cells

      error = huge(error)
      if (cells >= least_cells) error = error_of_cell/min(cells, cells**2)
   end function error_of_edge

   !> Relative error of a pull-off, 0 where none was sought or found.
   pure real(dp) function error_of_pull_off(solution, cells) result(error)
      type(periodic_solution_t), intent(in) :: solution
      !> Cells per zone.
      real(dp), intent(in) :: cells

      error = 0
      if (.not. solution%pull_off < huge(1.0_dp)) return
      error = solution%pull_off_error
      if (error > 1) error = min(error_of_edge(cells), 1.0_dp)
   end function error_of_pull_off

   !> Zones of adhesion that the cells do not see, in a line; empty if there is nothing to say.
   function doubt_zone(law, surface) result(text)
      type(adhesion_law_t), intent(in) :: law
      !> Periods and cells of the surface [m], and its solid.
      type(periodic_surface_t), intent(in) :: surface
      character(:), allocatable :: text
      character(120) :: line

      text = ''
      if (.not. law%stress > 0) return
      associate (n => cells_per_zone(law, surface))
         if (n >= few_cells) return
         write (line, '(a, es8.1, a)') 'hint: a short zone of adhesion has', n, ' cells;'
         if (n >= least_cells) then
            text = trim(line)//' with more of them pull-off, and the loads at which contacts jump, will be others'//new_line('a')
         else
            text = trim(line)//' with fewer than 0.5 no state with an edge of adhesion is given'//new_line('a')
         end if
      end associate
   end function doubt_zone

   !> Have stress and range sizes with which a surface can be solved?
   pure logical function are_sizes_possible(law, height, surface) result(are_possible)
      type(adhesion_law_t), intent(in) :: law
      !> Range of the undeformed gap [m].
      real(dp), intent(in) :: height
      !> Periods and cells of the surface [m], and its solid.
      type(periodic_surface_t), intent(in) :: surface
      real(dp) :: sizes(2)

      are_possible = .not. law%stress > 0
      if (are_possible) return
      sizes = [law%stress/surface%solid%modulus/(height/maxval(surface%period)), law%range/height]
      are_possible = all(sizes >= least_size .and. sizes <= largest_size)
   end function are_sizes_possible

end module adfric_periodic_adhesion_cells

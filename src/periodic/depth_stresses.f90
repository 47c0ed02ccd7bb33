! SPDX-License-Identifier: GPL-3.0-or-later
!> Stresses in depth of a solved contact: the largest ones, and the maps of a depth.
module adfric_periodic_depth_stresses
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_base_unset, only: is_set
   use adfric_periodic_largest_stress, only: find_largest_stress, largest_at_depth, largest_stress_t, of_shear, of_von_mises, &
      & shear_of, von_mises_of
   use adfric_periodic_point, only: periodic_surface_t
   use adfric_periodic_stress_field, only: new_stress_field, n_stresses, stress_field_t
   use adfric_periodic_stress_rows, only: in => stress_input, out => stress_output, wants_search
   implicit none (type, external)
   private
   public :: store_stresses, fill_stress_maps

contains

   !> Store the largest stresses.
   subroutine store_stresses(values, surface, pressure, poisson_ratio, results, is_found, shear, axis)
      !> Values of the rows, of which some ask for stresses; shape `(n_stress_rows)`.
      real(dp), intent(in) :: values(:)
      !> Periods and cells of the surface [m], and its solid.
      type(periodic_surface_t), intent(in) :: surface
      !> Pressure in the cells [E*].
      real(dp), intent(in) :: pressure(:, :)
      !> Poisson's ratio [-].
      real(dp), intent(in) :: poisson_ratio
      !> In: NaN. Out: the results; shape `(n_stress_results)`.
      real(dp), intent(inout) :: results(:)
      !> Was there memory?
      logical, intent(out) :: is_found
      !> Shear stress on the solid [E*], and its axis; not present: none.
      real(dp), intent(in), optional :: shear(:, :)
      integer, intent(in), optional :: axis
      type(stress_field_t) :: field
      type(largest_stress_t) :: found
      real(dp), allocatable :: stress(:, :, :)
      integer :: part(2)

      call begin_field(field, stress, surface, pressure, poisson_ratio, is_found, shear, axis)
      if (.not. is_found) return
      associate (unit => surface%period(1))
         ! below an even pressure alone the stresses of all quarters are alike
         part = merge(shape(pressure), field%n_cells(), .not. present(shear))
         if (.not. wants_search(values)) then
            call largest_at_depth(field, values(in%depth)/unit, part, stress, found)
         else
            call find_largest_stress(field, surface%period/unit, pressure, poisson_ratio, part, stress, found, shear)
            results(out%search_error) = maxval(found%error)
         end if
      end associate
      call store_measure(of_von_mises, out%von_mises)
      call store_measure(of_shear, out%shear)
      ! what was given comes back to the last digit
      if (.not. wants_search(values)) results([out%von_mises(2), out%shear(2)]) = values(in%depth)
      if (is_set(values(in%strength))) results(out%yield_ratio) = results(out%von_mises(1))/values(in%strength)

   contains

      !> Store the results of a measure; a stress of the mean alone, far below, has no position.
      subroutine store_measure(measure, rows)
         !> Index of the measure, and those of its results: the stress, its depth, x and y.
         integer, intent(in) :: measure, rows(4)

         results(rows(1)) = found%stress(measure)*surface%solid%modulus
         if (.not. found%depth(measure) < huge(1.0_dp)) return
         if (.not. found%stress(measure) > 0) return
         results(rows(2)) = found%depth(measure)*surface%period(1)
         associate (sizes => surface%cell_sizes())
            results(rows(3)) = (found%cell(1, measure) - 0.5_dp)*sizes(1)
            if (surface%n_cells(2) > 1) results(rows(4)) = (found%cell(2, measure) - 0.5_dp)*sizes(2)
         end associate
      end subroutine store_measure

   end subroutine store_stresses

   !> The stresses below a pressure, with lengths in periods along x, and the workspace for those of one depth.
   subroutine begin_field(field, stress, surface, pressure, poisson_ratio, is_found, shear, axis)
      type(stress_field_t), intent(out) :: field
      !> Receives the workspace; shape `(nx, ny, n_stresses)` of a whole period.
      real(dp), allocatable, intent(out) :: stress(:, :, :)
      type(periodic_surface_t), intent(in) :: surface
      real(dp), intent(in) :: pressure(:, :)
      real(dp), intent(in) :: poisson_ratio
      !> Was there memory?
      logical, intent(out) :: is_found
      !> Shear stress on the solid, in the unit of the pressure, and its axis; not present: none.
      real(dp), intent(in), optional :: shear(:, :)
      integer, intent(in), optional :: axis
      type(error_t), allocatable :: error
      integer :: failure

      call new_stress_field(field, pressure, surface%period/surface%period(1), surface%is_quarter, poisson_ratio, error, shear, &
         & axis)
      is_found = .not. allocated(error)
      if (.not. is_found) return
      associate (n_cells => field%n_cells())
         allocate (stress(n_cells(1), n_cells(2), n_stresses), stat=failure)
      end associate
      is_found = failure == 0
   end subroutine begin_field

   !> The maps of a depth.
   subroutine fill_stress_maps(values, surface, pressure, poisson_ratio, shear, axis, maps)
      !> Values of the rows, with a depth; shape `(n_stress_rows)`.
      real(dp), intent(in) :: values(:)
      !> Periods and cells of the surface [m], and its solid.
      type(periodic_surface_t), intent(in) :: surface
      !> Pressure in the cells [Pa], the shear stress on the solid [Pa], and its axis.
      real(dp), intent(in) :: pressure(:, :), shear(:, :)
      real(dp), intent(in) :: poisson_ratio
      integer, intent(in) :: axis
      !> In: NaN. Out: the maps, NaN without memory; shape `(nx, ny, n_stress_profiles)`.
      real(dp), intent(inout) :: maps(:, :, :)
      type(stress_field_t) :: field
      real(dp), allocatable :: stress(:, :, :)
      integer :: i, j
      logical :: is_found

      call begin_field(field, stress, surface, pressure, poisson_ratio, is_found, shear, axis)
      if (.not. is_found) return
      call field%get_stresses(values(in%depth)/surface%period(1), stress)
      do j = 1, size(maps, 2)
         do i = 1, size(maps, 1)
            maps(i, j, 1) = von_mises_of(stress(i, j, :))
            maps(i, j, 2) = shear_of(stress(i, j, :))
            maps(i, j, 3:) = stress(i, j, :)
         end do
      end do
   end subroutine fill_stress_maps

end module adfric_periodic_depth_stresses

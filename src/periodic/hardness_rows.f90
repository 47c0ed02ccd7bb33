! SPDX-License-Identifier: GPL-3.0-or-later
!> The hardness of a solid on whose cells a contact is solved: its row, what it cannot stand beside, and the results.
!>
!> Equations in `adfric_periodic_yielding` and docs/theory/hardness.md.
module adfric_periodic_hardness_rows
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_describe_rows, only: positive, result_row
   use adfric_describe_table, only: profile_t, result_t, variable_t
   use adfric_periodic_solver, only: hardness_t, periodic_solution_t
   implicit none (type, external)
   private
   public :: hardness_row, has_hardness, resolve_hardness, check_turn, hardness_results, plastic_profile, store_impressions
   public :: n_hardness_results

   !> Number of results: share of the area that has yielded, mean depth of the impressions, and the energy that they took.
   integer, parameter :: n_hardness_results = 3

contains

   !> The row.
   type(variable_t) function hardness_row() result(row)

      row = positive(group='solid', name='hardness', unit='Pa', &
         & meaning='largest pressure that the solid bears; where it is reached, the surface yields')
   end function hardness_row

   !> Does the solid yield?
   pure logical function has_hardness(value)
      !> Value of the row.
      real(dp), intent(in) :: value

      has_hardness = is_set(value)
   end function has_hardness

   !> Add to `problems` a turn that lies below the pressure of the point.
   subroutine check_turn(row, turning_pressure, mean_pressure, problems)
      !> Row of the turn, whose name is part of the message.
      type(variable_t), intent(in) :: row
      !> Mean pressure of the turn and of the point [Pa]; each may be unset.
      real(dp), intent(in) :: turning_pressure, mean_pressure
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      if (is_set(turning_pressure) .and. is_set(mean_pressure) .and. turning_pressure < mean_pressure) &
         & call problems%add(row%group, row%name, 'is below mean_pressure; a load turns where it is largest')
   end subroutine check_turn

   !> The hardness of a point, whose values have been checked.
   pure type(hardness_t) function resolve_hardness(hardness, turning_pressure, modulus) result(resolved)
      !> Hardness, mean pressure of a turn or unset, and contact modulus [Pa].
      real(dp), intent(in) :: hardness, turning_pressure, modulus

      resolved%pressure = hardness/modulus
      if (is_set(turning_pressure)) resolved%turning_pressure = turning_pressure/modulus
   end function resolve_hardness

   !> The results.
   function hardness_results() result(r)
      type(result_t) :: r(n_hardness_results)

      r(1) = result_row(name='plastic_fraction', unit='-', &
         & long_name='share of the area that has yielded, under the largest load so far')
      r(2) = result_row(name='mean_plastic_depth', unit='m', long_name='volume of the impressions over nominal area')
      r(3) = result_row(name='plastic_work', unit='J/m^2', long_name='energy that the impressions took, over nominal area')
      r%is_counted = .true.
   end function hardness_results

   !> The profile of the impressions.
   type(profile_t) function plastic_profile() result(p)

      p = profile_t(name='plastic_depth', unit='m', long_name='depth of the impressions; 0 where the solid has not yielded')
   end function plastic_profile

   !> Store what has yielded.
   pure subroutine store_impressions(hardness, solution, results)
      !> Hardness [Pa].
      real(dp), intent(in) :: hardness
      !> Solution of the point; lengths in m.
      type(periodic_solution_t), intent(in) :: solution
      !> Receives the results; shape `(n_hardness_results)`.
      real(dp), intent(inout) :: results(:)

      associate (depth => solution%plastic_depth)
         results(1) = count(depth > 0)/real(size(depth), dp)
         results(2) = sum(depth)/size(depth)
         results(3) = hardness*results(2)
      end associate
   end subroutine store_impressions

end module adfric_periodic_hardness_rows

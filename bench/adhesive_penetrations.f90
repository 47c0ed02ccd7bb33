! SPDX-License-Identifier: GPL-3.0-or-later
!> Is a line of cells that adheres, at a given penetration, in the state of the exact wave? See bench/README.md.
!>
!> adhesive_penetrations [NUMBER [SEED]]
program adhesive_penetrations
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_error, only: error_t
   use adfric_plane_adhesive_wave_load, only: branch_approach, branch_adhered
   use adfric_plane_adhesive_wave_units, only: wave_adhesion_case_t, wave_adhesion_state_t, new_wave_adhesion
   use adfric_periodic_adhesive_penetration, only: solve_adhesive_penetration
   use adfric_periodic_adhesive_solver, only: periodic_adhesion_t
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_solver, only: periodic_solver_t, periodic_solution_t, new_periodic_solver, contact_solved
   use measure, only: print_heading, integer_argument
   use random_dice, only: dice_t, new_dice
   implicit none (type, external)

   !> Cells of the line, fewest of them in a short zone, and part of the load by which one state may differ.
   integer, parameter :: n = 256
   real(dp), parameter :: fewest_in_zone = 3, other_state = 0.01_dp
   !> States that were solved, not solved, and others than the exact one.
   integer :: n_solved, n_not_solved, n_other

   call print_heading('Adhesive lines at given penetrations')
   n_solved = 0
   n_not_solved = 0
   n_other = 0
   call search(integer_argument(1, 2000), integer_argument(2, 1))
   print '(3(a, i0))', 'solved ', n_solved, ', other states ', n_other, ', not converged ', n_not_solved

contains

   !> Draw stress and range, branch, turn and penetration, and solve.
   subroutine search(n_cases, seed)
      integer, intent(in) :: n_cases, seed
      type(dice_t) :: dice
      type(periodic_solver_t) :: solver
      type(wave_adhesion_case_t) :: exact
      type(periodic_adhesion_t) :: adhesion
      type(error_t), allocatable :: error
      real(dp) :: shape(n, 1), lowest, stress, range, u(4)
      logical :: is_possible, is_converged
      integer :: i, k

      shape(:, 1) = [(1 - cos(2*pi*(i - 0.5_dp)/n), i=1, n)]
      lowest = minval(shape)
      shape(:, :) = shape - lowest
      call new_periodic_solver(solver, elastic_kernel_t(), [n, 1], [1.0_dp, 1.0_dp], .false., error)
      if (allocated(error)) error stop 'no memory'
      call new_dice(dice, seed)
      k = 0
      do while (k < n_cases)
         call dice%decades(-2.0_dp, 0.5_dp, stress)
         call dice%decades(-2.0_dp, 0.3_dp, range)
         do i = 1, size(u)
            call dice%between(0.0_dp, 1.0_dp, u(i))
         end do
         if (range/(4*stress)*n < fewest_in_zone) cycle
         k = k + 1
         call new_wave_adhesion(exact, 1.0_dp, 1.0_dp, 1.0_dp, pi*stress, range, is_possible, is_converged)
         adhesion = periodic_adhesion_t(stress=pi*stress, range=range, is_adhered=u(1) > 0.5_dp, &
            & has_turned=u(1) > 0.75_dp, turning_pressure=1.2_dp*pi*u(2))
         call compare(solver, shape, lowest, exact, -1.3_dp*range - 0.1_dp + (1.1_dp + 1.3_dp*range)*u(3), adhesion)
      end do
   end subroutine search

   !> Compare a state with the exact one.
   subroutine compare(solver, shape, lowest, exact, penetration, adhesion)
      type(periodic_solver_t), intent(inout) :: solver
      real(dp), intent(in) :: shape(:, :), lowest, penetration
      type(wave_adhesion_case_t), intent(in) :: exact
      type(periodic_adhesion_t), intent(in) :: adhesion
      type(wave_adhesion_state_t) :: state
      type(periodic_solution_t) :: solution
      type(error_t), allocatable :: error
      logical :: is_converged

      if (adhesion%has_turned) then
         call exact%solve_penetration(penetration, branch_adhered, state, is_converged, adhesion%turning_pressure)
      else
         call exact%solve_penetration(penetration, merge(branch_adhered, branch_approach, adhesion%is_adhered), state, is_converged)
      end if
      call solve_adhesive_penetration(solver, shape, penetration - lowest, adhesion, 1.0e-10_dp, solution, error)
      if (allocated(error)) error stop 'no memory'
      if (solution%status /= contact_solved) then
         n_not_solved = n_not_solved + 1
      else
         n_solved = n_solved + 1
         associate (load => state%mean_pressure)
            if (abs(solution%mean_pressure - load) > other_state*max(0.3_dp*adhesion%stress, abs(load))) n_other = n_other + 1
         end associate
      end if
   end subroutine compare

end program adhesive_penetrations

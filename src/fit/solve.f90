! SPDX-License-Identifier: GPL-3.0-or-later
!> The fit of measured curves.
module adfric_fit_solve
   use adfric_base_kinds, only: dp
   use adfric_fit_problem, only: fit_t
   use adfric_fit_solution, only: solution_t, fit_not_converged
   implicit none (type, external)
   private
   public :: solve_fit

contains

   !> Find what the data say of the free variables. It changes nothing but `solution`, and threads may fit at the same time.
   subroutine solve_fit(fit, solution)
      !> What is to be fitted; it has been checked.
      type(fit_t), intent(in) :: fit
      !> Receives what is found.
      type(solution_t), intent(out) :: solution

      solution%status = fit_not_converged
      allocate (solution%estimate(size(fit%frees)), source=0.0_dp)
   end subroutine solve_fit

end module adfric_fit_solve

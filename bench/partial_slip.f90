! SPDX-License-Identifier: GPL-3.0-or-later
!> Partial slip of random self-affine surfaces on an elastic half-space: transforms beside those of the contact alone, and errors.
!>
!>     partial_slip [TABLE.csv [LARGEST [DIGITS]]]
!>
!> 128 to LARGEST cells (512 if absent) along x and y, residual 10**(-DIGITS), of which 10 is the default. Surfaces and loads are those
!> of `rough_surface`; tangential forces are parts of mu P, Poisson's ratio is 0.3. `ratio` is that of all pairs of transforms, those of
!> the contact, of what slips, of the stiffness and of the defect, to those of the contact alone; coarser grids count by their cells.
!> Errors are those against the slip of a contact that is solved to a residual of 1e-13, as that itself: of the displacement u and of the
!> largest shear traction, over these; of the stiffness; of the energy of a cycle over T u; of the defect; and the number of cells
!> that stick here or there alone. `difference` is how far u is from that of two contacts, of P and of P* = P - T/mu, each from nothing to
!> a residual of 1e-13; where the force is small it is the difference that has lost digits.
program partial_slip
   use, intrinsic :: iso_fortran_env, only: output_unit
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_interface_coulomb_rows, only: coulomb_t
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_operator, only: periodic_operator_t, new_periodic_operator
   use adfric_periodic_slip, only: periodic_slip_t, solve_slip
   use adfric_periodic_solver, only: periodic_solver_t, periodic_solution_t, new_periodic_solver, contact_solved
   use measure, only: print_heading, text_argument, integer_argument, open_table
   use rough_shapes, only: make_surface
   implicit none (type, external)

   real(dp), parameter :: tight = 1.0e-13_dp, nu = 0.3_dp
   real(dp), parameter :: loads(*) = [0.025_dp, 0.2_dp, 1.0_dp]
   real(dp), parameter :: shares(*) = [1.0e-6_dp, 1.0e-3_dp, 0.01_dp, 0.1_dp, 0.2_dp, 0.4_dp, 0.6_dp, 0.8_dp, 0.95_dp, 0.999_dp, &
      & 1.0_dp]
   real(dp), parameter :: exponents(*) = [0.8_dp, 0.3_dp]
   real(dp) :: tolerance
   integer :: table, n, k

   call print_heading('partial slip of random surfaces on an elastic half-space')
   tolerance = 10.0_dp**(-integer_argument(3, 10))
   table = open_table(text_argument(1, 'partial_slip.csv'), 'cells,hurst,shortest,load,tau,pairs_contact,pairs,ratio,'// &
      & 'error_displacement,error_stiffness,error_energy,error_defect,error_traction,difference,stick_cells')
   print '(a6, a6, a9, a7, a10, a9, a7, a7, 6a9, a6)', 'cells', 'hurst', 'shortest', 'load', 'T/mu P', 'contact', 'pairs', &
      & 'ratio', 'u', 'dT/du', 'W', 'defect', 'q', 'two', 'cells'
   n = 128
   do while (n <= integer_argument(2, 512))
      do k = 1, size(exponents)
         call report_surface(n, exponents(k), 16)
         call report_surface(n, exponents(k), n/2 - 1)
      end do
      n = 2*n
   end do
   close (table)

contains

   !> All loads and forces of one surface.
   subroutine report_surface(n, hurst, most_waves)
      integer, intent(in) :: n, most_waves
      real(dp), intent(in) :: hurst
      real(dp), allocatable :: shape(:, :), tension(:, :)
      type(periodic_solver_t) :: solver
      type(periodic_operator_t) :: operator
      type(periodic_solution_t) :: contact, exact
      type(error_t), allocatable :: error
      real(dp) :: load, pairs
      integer :: k, j

      call make_surface(n, hurst, most_waves, shape)
      allocate (tension, mold=shape)
      call new_periodic_operator(operator, elastic_kernel_t(), [n, n], [1.0_dp, 1.0_dp], .false., .false., error)
      call operator%apply_stiffness(shape, tension)
      call new_periodic_solver(solver, elastic_kernel_t(), [n, n], [1.0_dp, 1.0_dp], .false., error)
      if (allocated(error)) error stop 'no solver'
      do k = 1, size(loads)
         load = loads(k)*sqrt(sum(tension**2)/size(tension))
         pairs = pairs_of(solver)
         call solver%solve_load(shape, load, tolerance, contact, error)
         pairs = pairs_of(solver) - pairs
         call solve_tightly(solver, shape, load, exact)
         do j = 1, size(shares)
            write (table, '(i0, ",", f0.2, ",", i0, ",", f0.6, ",", es8.2, ",", f0.3)', advance='no') n, hurst, &
               & most_waves, loads(k), shares(j), pairs
            write (output_unit, '(i6, f6.1, i9, f7.3, es10.2, f9.1)', advance='no') n, hurst, most_waves, loads(k), shares(j), pairs
            call report_force(solver, shape, contact, exact, shares(j), pairs)
         end do
      end do
   end subroutine report_surface

   !> One force.
   subroutine report_force(solver, shape, contact, exact, share, pairs)
      type(periodic_solver_t), intent(inout) :: solver
      real(dp), intent(in) :: shape(:, :), share, pairs
      type(periodic_solution_t), intent(in) :: contact, exact
      type(periodic_solution_t) :: found, from, lighter
      type(periodic_slip_t), allocatable :: slip, truth
      type(coulomb_t) :: friction
      type(error_t), allocatable :: error
      real(dp) :: spent, errors(6)
      integer :: n_other

      friction%coefficient = 1
      friction%stress = share*contact%mean_pressure
      friction%poisson = nu/(2*(1 - nu))
      found = contact
      spent = pairs_of(solver)
      call solve_slip(solver, shape, friction, tolerance, found, slip, error)
      spent = pairs + pairs_of(solver) - spent
      if (allocated(error) .or. found%status /= contact_solved) error stop 'no slip'
      from = exact
      call solve_slip_tightly(solver, shape, friction, from, truth)
      errors = [abs(slip%displacement/truth%displacement - 1), 0.0_dp, &
         & abs(slip%cycle_energy - truth%cycle_energy)/(friction%stress*truth%displacement), 0.0_dp, &
         & maxval(abs(slip%traction - truth%traction))/maxval(truth%traction), 0.0_dp]
      call solve_tightly(solver, shape, exact%mean_pressure*(1 - share), lighter)
      errors(6) = abs(slip%displacement/(friction%compliance_ratio(.false.)*(exact%penetration - lighter%penetration)) - 1)
      if (truth%compliance > 0) errors(2) = abs(slip%compliance/truth%compliance - 1)
      if (truth%poisson_defect > 0) errors(4) = abs(slip%poisson_defect/truth%poisson_defect - 1)
      n_other = nint(abs(slip%stick%cells - truth%stick%cells)*size(shape))
      write (output_unit, '(f7.1, f7.2, 6es9.1, i6)') spent, spent/pairs, errors, n_other
      write (table, '(2(",", f0.3), 6(",", es8.2), ",", i0)') spent, spent/pairs, errors, n_other
      flush (output_unit)
   end subroutine report_force

   !> A contact from nothing, to the last digits that there are.
   subroutine solve_tightly(solver, shape, load, solution)
      type(periodic_solver_t), intent(inout) :: solver
      real(dp), intent(in) :: shape(:, :), load
      type(periodic_solution_t), intent(out) :: solution
      type(error_t), allocatable :: error

      call solver%solve_load(shape, load, tight, solution, error)
      if (allocated(error)) error stop 'no solution'
   end subroutine solve_tightly

   !> The slip as the difference of two contacts.
   subroutine solve_slip_tightly(solver, shape, friction, whole, slip)
      type(periodic_solver_t), intent(inout) :: solver
      real(dp), intent(in) :: shape(:, :)
      type(coulomb_t), intent(in) :: friction
      type(periodic_solution_t), intent(inout) :: whole
      type(periodic_slip_t), allocatable, intent(out) :: slip
      type(error_t), allocatable :: error

      call solve_slip(solver, shape, friction, tight, whole, slip, error)
      if (allocated(error) .or. .not. allocated(slip)) error stop 'no reference'
   end subroutine solve_slip_tightly

   !> Pairs of transforms so far.
   real(dp) function pairs_of(solver) result(pairs)
      type(periodic_solver_t), intent(in) :: solver
      integer :: k

      pairs = 0
      do k = 1, size(solver%grids)
         associate (cells => product(real(solver%grids(k)%operator%n_cells, dp)), &
            & all_cells => product(real(solver%grids(size(solver%grids))%operator%n_cells, dp)))
            pairs = pairs + solver%grids(k)%operator%n_applied*(cells/all_cells)
         end associate
      end do
   end function pairs_of

end program partial_slip

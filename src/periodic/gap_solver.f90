!> The gap over a given open region, by conjugate gradients.
!>
!> Where the surfaces are apart the pressure q + s + A g is zero (`adfric_periodic_contact`), where they touch the gap g
!> is zero. On the open region O that is A_OO g = -(q + s), symmetric and positive definite. The compliance restricted to O is the
!> preconditioner: operators of opposite order leave a condition number that hardly depends on the number of cells (O. Steinbach,
!> W. L. Wendland, Adv. Comput. Math. 9, 1998, 191).
!>
!> Under given load q is known. Under given penetration the mean of g is, and q is the multiplier of this constraint; the
!> directions are kept in the constraint by a projection in the preconditioner (N. I. M. Gould, M. E. Hribar, J. Nocedal,
!> SIAM J. Sci. Comput. 23, 2001, 1376).
module adfric_periodic_gap_solver
   use adfric_base_kinds, only: dp
   use adfric_periodic_operator, only: periodic_operator_t
   implicit none (type, external)
   private
   public :: gap_solver_t, new_gap_solver

   !> Iterations that are never needed: it takes about ten for ten digits.
   integer, parameter :: max_iterations = 500

   !> Workspace of the iterations.
   type :: gap_solver_t
      private
      !> 1 where open, 0 where in contact; shape of the cells, as are the others.
      real(dp), allocatable :: open(:, :)
      !> Residual, preconditioned residual, direction, stiffness times direction, preconditioned constant.
      real(dp), allocatable, dimension(:, :) :: r, z, d, ad, w
   contains
      procedure :: solve
      procedure, private :: precondition
   end type gap_solver_t

contains

   !> Make the workspace for a number of cells.
   pure subroutine new_gap_solver(self, n_cells)
      !> Workspace, allocated for these cells.
      type(gap_solver_t), intent(out) :: self
      !> Number of cells in each direction.
      integer, intent(in) :: n_cells(2)

      allocate (self%open(n_cells(1), n_cells(2)), source=0.0_dp)
      allocate (self%r, self%z, self%d, self%ad, self%w, mold=self%open)
   end subroutine new_gap_solver

   !> Improve the gap in the open region until the pressure there is small.
   subroutine solve(self, operator, is_open, has_fixed_mean, tolerance, pressure, gap, mean_pressure, n_iterations)
      !> Workspace for the cells of the operator.
      class(gap_solver_t), intent(inout) :: self
      !> Operator of the same cells, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator
      !> Is the cell in the open region? Shape of the cells, as that of `pressure` and `gap`.
      logical, intent(in) :: is_open(:, :)
      !> Is the mean gap given, and the mean pressure not?
      logical, intent(in) :: has_fixed_mean
      !> Largest pressure that may be left in the open region [E*].
      real(dp), intent(in) :: tolerance
      !> Pressure that belongs to `gap` and `mean_pressure` on entry [E*].
      real(dp), intent(in) :: pressure(:, :)
      !> Gap, which is improved in the open region; zero outside.
      real(dp), intent(inout) :: gap(:, :)
      !> Mean pressure q [E*]; it changes under a given mean gap only.
      real(dp), intent(inout) :: mean_pressure
      !> Number of iterations that were done.
      integer, intent(out) :: n_iterations
      real(dp) :: rz, rz_before, curvature, shift

      self%open(:, :) = merge(1.0_dp, 0.0_dp, is_open)
      self%r(:, :) = -pressure*self%open
      self%d(:, :) = 0
      rz_before = 1
      if (has_fixed_mean) then
         call operator%apply_compliance(self%open, self%w)
         self%w(:, :) = self%w*self%open
      end if
      do n_iterations = 0, max_iterations
         if (maxval(abs(self%r)) <= tolerance) exit
         call self%precondition(operator, has_fixed_mean, shift)
         mean_pressure = mean_pressure + shift
         rz = sum(self%r*self%z)
         if (.not. rz > 0) exit
         self%d(:, :) = self%z + (rz/rz_before)*self%d
         rz_before = rz
         call operator%apply_stiffness(self%d, self%ad)
         curvature = sum(self%d*self%ad)
         if (.not. curvature > 0) exit
         gap(:, :) = gap + (rz/curvature)*self%d
         self%r(:, :) = self%r - (rz/curvature)*self%open*self%ad
      end do
   end subroutine solve

   !> Apply the preconditioner; under a fixed mean gap find the mean pressure that leaves it.
   subroutine precondition(self, operator, has_fixed_mean, shift)
      !> Workspace with the residual; receives the preconditioned residual.
      class(gap_solver_t), intent(inout) :: self
      !> Operator of the same cells, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator
      !> Is the mean gap given, and the mean pressure not?
      logical, intent(in) :: has_fixed_mean
      !> Change of the mean pressure [E*]; 0 if the mean pressure is given.
      real(dp), intent(out) :: shift

      call operator%apply_compliance(self%r, self%z)
      self%z(:, :) = self%z*self%open
      shift = 0
      if (.not. has_fixed_mean) return
      shift = sum(self%z)/sum(self%w)
      self%z(:, :) = self%z - shift*self%w
      self%r(:, :) = self%r - shift*self%open
   end subroutine precondition

end module adfric_periodic_gap_solver

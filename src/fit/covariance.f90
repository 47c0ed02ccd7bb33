! SPDX-License-Identifier: GPL-3.0-or-later
!> The covariance of a fit, and what the data do not see.
!>
!> With the columns of J scaled to length 1, J = U S V'. C = V S^-2 V' and the scales, times S/(n - p) where sigma is not known. A singular
!> value below 1e-9 of the largest, or below what the errors of the derivatives leave, belongs to a direction that the data do not see:
!> moving along it changes no residual. A column of zeros is such a direction itself.
!>
!> With a loss the covariance is H^-1 M H^-1, H = J' diag(psi') J and M = J' diag(psi^2) J over all rows.
module adfric_fit_covariance
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_fit_objective, only: objective_t
   use adfric_numerics_bounded_least_squares, only: squares_work_t, most_variables
   use adfric_numerics_column_factors, only: factor_columns, get_singular_values
   use adfric_numerics_lapack, only: dgesv
   implicit none (type, external)
   private
   public :: find_covariance

   !> A singular value below this share of the largest is none.
   real(dp), parameter :: least_share = 1.0e-9_dp
   !> How much of a singular value the errors of derivatives may make.
   real(dp), parameter :: of_error = 100.0_dp

contains

   !> Find the covariance of the numbers that are fitted, or a direction that the data do not see.
   subroutine find_covariance(self, q, work, covariance, null_vector, is_identifiable, is_valid)
      type(objective_t), intent(inout) :: self
      !> The estimate.
      real(dp), intent(in) :: q(:)
      !> Workspace; it holds plain residuals and derivatives at the end.
      type(squares_work_t), intent(inout) :: work
      !> Receives the covariance, not scaled; NaN if there is none.
      real(dp), intent(out) :: covariance(:, :)
      !> Receives a direction of length 1 that the data do not see; 0 if they see all.
      real(dp), intent(out) :: null_vector(:)
      logical, intent(out) :: is_identifiable
      !> Has the model a value at the estimate?
      logical, intent(out) :: is_valid
      real(dp) :: cost, length(size(q)), values(size(q)), directions(size(q), size(q)), r(most_variables, most_variables)
      logical :: is_robust
      integer :: k, n, m

      n = size(q)
      covariance = not_a_number()
      null_vector = 0
      is_identifiable = .false.
      is_robust = self%is_robust()
      self%is_exact = .true.
      call self%evaluate(q, work%n_rows, work%r, work%j, cost, is_valid)
      if (is_robust .and. is_valid) then
         self%is_plain = .true.
         call self%evaluate(q, work%n_rows, work%r, work%j, cost, is_valid)
         self%is_plain = .false.
      end if
      self%is_exact = .false.
      if (.not. is_valid) return
      m = work%n_rows
      do k = 1, n
         length(k) = norm2(work%j(:m, k))
         if (.not. length(k) > 0) then
            null_vector(k) = 1
            return
         end if
         work%a(:m, k) = work%j(:m, k)/length(k)
      end do
      work%b(:m) = work%r(:m)
      call factor_columns(work%a(:m, :n), work%b(:m))
      r = 0
      do k = 1, n
         r(:min(k, m), k) = work%a(:min(k, m), k)
      end do
      call get_singular_values(r(:n, :n), values, directions)
      is_identifiable = values(n) > max(least_share, of_error*self%derivative_error())*values(1)
      if (.not. is_identifiable) then
         null_vector = directions(:, n)/length
         null_vector = null_vector/norm2(null_vector)
         return
      end if
      if (is_robust) then
         call find_sandwich(self, work, length, covariance)
         return
      end if
      do k = 1, n
         covariance(:, k) = matmul(directions/spread(values**2, 1, n), directions(k, :))/(length*length(k))
      end do
   end subroutine find_covariance

   !> The covariance with a loss.
   subroutine find_sandwich(self, work, length, covariance)
      type(objective_t), intent(in) :: self
      type(squares_work_t), intent(in) :: work
      !> Lengths of the columns.
      real(dp), intent(in) :: length(:)
      !> Receives the covariance; NaN if there is none.
      real(dp), intent(out) :: covariance(:, :)
      real(dp) :: bread(size(length), size(length)), filling(size(length), size(length))
      integer :: i, k, m, info, pivots(size(length)), n

      m = work%n_rows
      n = size(length)
      do i = 1, n
         do k = 1, n
            associate (product => work%j(:m, i)*work%j(:m, k)/(length(i)*length(k)))
               bread(i, k) = sum(self%psi_r(:m)*product)
               filling(i, k) = sum(self%psi(:m)**2*product)
            end associate
         end do
      end do
      covariance = bread
      ! H^-1 M, then H^-1 (H^-1 M)', for both are symmetric
      call dgesv(n, n, bread, n, pivots, filling, n, info)
      if (info == 0) then
         filling = transpose(filling)
         call dgesv(n, n, covariance, n, pivots, filling, n, info)
      end if
      covariance = not_a_number()
      if (info /= 0) return
      do k = 1, n
         covariance(:, k) = filling(:, k)/(length*length(k))
      end do
   end subroutine find_sandwich

end module adfric_fit_covariance

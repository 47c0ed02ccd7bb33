! SPDX-License-Identifier: GPL-3.0-or-later
!> An ensemble of surfaces that seeds draw from one spectrum: means of the results of its members, and of the main ones the spread
!> between members and the error of the mean.
!>
!> With the results x_k of n members, the mean is m = sum x_k/n, the spread of a member s = sqrt(sum (x_k - m)^2/(n - 1)), and the
!> standard error of the mean s/sqrt(n). A result that a member does not have, has no mean.
module adfric_rough_ensemble
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_describe_rows, only: result_row
   use adfric_describe_table, only: result_t
   use adfric_periodic_stress_rows, only: of_stress => stress_output
   use adfric_periodic_variables, only: n_elastic_results, out => periodic_output
   implicit none (type, external)
   private
   public :: set_ensemble_rows, find_ensemble, mean_and_spread, n_ensemble_rows

   !> Results of a surface that have a spread in the table of an ensemble.
   integer, parameter :: spread_of(*) = [out%mean_pressure, out%penetration, out%contact_fraction, out%peak_pressure, &
      & out%mean_gap, out%elastic_energy, out%pull_off_pressure, out%friction_stress, out%friction_coefficient, &
      & out%stick_fraction, out%tangential_displacement, out%tangential_stiffness]
   integer, parameter :: n_spreads = size(spread_of)
   !> Rows that an ensemble adds: spreads, then errors of means.
   integer, parameter :: n_ensemble_rows = 2*n_spreads

contains

   !> Rows of the spreads and of the errors of the means.
   subroutine set_ensemble_rows(of_surface, rows)
      !> Results of a surface; shape `(n_elastic_results)`.
      type(result_t), intent(in) :: of_surface(:)
      !> Receives the rows; shape `(n_ensemble_rows)`.
      type(result_t), intent(inout) :: rows(:)
      integer :: k

      do k = 1, n_spreads
         associate (name => of_surface(spread_of(k))%name, unit => of_surface(spread_of(k))%unit)
            rows(k) = result_row(name=name//'_spread', unit=unit, &
               & long_name='standard deviation of '//name//' between the surfaces of the seeds')
            rows(n_spreads + k) = result_row(name=name//'_error_of_mean', unit=unit, &
               & long_name='standard error of the mean of '//name//': its spread over the root of the number of seeds')
         end associate
         ! where the surfaces differ in an area by counting, so does their spread
         rows(k)%is_counted = of_surface(spread_of(k))%is_counted
         rows(n_spreads + k)%is_counted = rows(k)%is_counted
      end do
   end subroutine set_ensemble_rows

   !> Results of an ensemble of members that are all solved.
   pure subroutine find_ensemble(members, results)
      !> Results of the members; shape `(n_elastic_results, n_members)`.
      real(dp), intent(in) :: members(:, :)
      !> Receives the means and behind them the rows of the ensemble, NaN for one member; shape `(n_elastic_results +
      !> n_ensemble_rows)`.
      real(dp), intent(inout) :: results(:)
      real(dp) :: spreads(n_elastic_results)
      integer :: k, n

      n = size(members, 2)
      do k = 1, n_elastic_results
         call mean_and_spread(members(k, :), results(k), spreads(k))
      end do
      ! what tells how well a member is solved is that of the worst one; a regime has no mean
      if (all(ieee_is_finite(members(out%contact_violation, :)))) &
         & results(out%contact_violation) = maxval(members(out%contact_violation, :))
      if (n > 1) results(out%regime) = not_a_number()
      if (n > 1) call set_stiffness_error(members, results)
      if (n > 1) call set_stresses(members, results)
      results(n_elastic_results + 1:n_elastic_results + n_spreads) = spreads(spread_of)
      results(n_elastic_results + n_spreads + 1:n_elastic_results + n_ensemble_rows) = spreads(spread_of)/sqrt(real(n, dp))
   end subroutine find_ensemble

   !> Stresses in depth: positions along the surface have no mean, and the error of the search is that of the worst member.
   pure subroutine set_stresses(members, results)
      real(dp), intent(in) :: members(:, :)
      !> In: with the means. Out: as said.
      real(dp), intent(inout) :: results(:)

      associate (before => out%stresses(1) - 1)
         results(before + [of_stress%von_mises(3:), of_stress%shear(3:)]) = not_a_number()
         if (all(ieee_is_finite(members(before + of_stress%search_error, :)))) &
            & results(before + of_stress%search_error) = maxval(members(before + of_stress%search_error, :))
      end associate
   end subroutine set_stresses

   !> The error of the mean stiffness. That of a member counts over its own stiffness, and over the mean one by the part that it has; the
   !> conductances are in proportion to it.
   pure subroutine set_stiffness_error(members, results)
      real(dp), intent(in) :: members(:, :)
      !> In: with the mean of the errors. Out: with the error of the mean, where there is a stiffness.
      real(dp), intent(inout) :: results(:)
      integer, parameter :: weights(*) = [out%contact_stiffness, out%conductances]
      integer :: k

      associate (errors => members(out%stiffness_error, :))
         if (.not. all(ieee_is_finite(errors))) return
         do k = 1, size(weights)
            associate (weight => members(weights(k), :))
               if (.not. all(ieee_is_finite(weight))) cycle
               if (sum(weight) > 0) results(out%stiffness_error) = sum(weight*errors)/sum(weight)
            end associate
            return
         end do
      end associate
   end subroutine set_stiffness_error

   !> Mean and standard deviation of numbers. Those that are all alike have this mean to the last digit, and the deviation 0.
   pure subroutine mean_and_spread(x, mean, spread)
      !> The numbers; shape `(n)`, n > 0.
      real(dp), intent(in) :: x(:)
      !> Receives the mean, NaN if a number is NaN or infinite; and the standard deviation with n - 1, NaN also for one number.
      real(dp), intent(out) :: mean, spread
      real(dp) :: largest

      mean = x(1)
      spread = not_a_number()
      if (size(x) == 1) return
      mean = not_a_number()
      if (.not. all(ieee_is_finite(x))) return
      mean = x(1) + sum(x - x(1))/size(x)
      largest = maxval(abs(x - mean))
      spread = 0
      ! squares of small numbers vanish
      if (largest > 0) spread = largest*sqrt(sum(((x - mean)/largest)**2)/(size(x) - 1))
   end subroutine mean_and_spread

end module adfric_rough_ensemble

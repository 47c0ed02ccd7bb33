! SPDX-License-Identifier: GPL-3.0-or-later
!> The limit theories of a sphere beside Maugis's: their errors, and the bounds by which `auto` chooses.
module sphere_limits
   use, intrinsic :: iso_fortran_env, only: output_unit
   use adfric_base_kinds, only: dp
   use adfric_round_sphere_contact, only: theory_jkr, theory_dmt
   use adfric_round_sphere_theory_bounds, only: limit_t, new_limit
   use measure, only: spread_t, spread_of, open_table
   use quad_dugdale, only: qp, state_t, of_radius, least_value
   use sphere_timing, only: logarithmic
   implicit none (type, external)
   private
   public :: report_limits

   integer, parameter :: n_radii = 60

contains

   !> JKR and DMT at given radii: bound and true error.
   subroutine report_limits(path, decades, n_broken)
      character(*), intent(in) :: path
      !> Largest decimal logarithm of lambda, and of 1/lambda.
      integer, intent(in) :: decades
      !> Number of bounds that are broken.
      integer, intent(out) :: n_broken
      integer :: table, k

      n_broken = 0
      table = open_table(path, 'theory,lambda,points,proved,load_error,load_error_proved,load_bound,load_looseness,'// &
         'approach_error,approach_error_proved,approach_bound,approach_looseness')
      print '(/, a)', 'limit theories at radius 0.1 to 10: share with a bound; largest error, that and the largest bound where'
      print '(a)', 'there is a bound; median of bound/error'
      print '(a6, a9, a8, 3a10, a10, 4x, 4a10)', 'theory', 'lambda', 'proved', 'P any', 'P', 'bound', 'ratio', 'd any', 'd', &
         'bound', 'ratio'
      do k = 0, decades
         call report_theory(table, theory_jkr, 10.0_dp**k, n_broken)
      end do
      do k = 0, -decades, -1
         call report_theory(table, theory_dmt, 10.0_dp**k, n_broken)
      end do
      close (table)
      flush (output_unit)
   end subroutine report_limits

   !> One limit theory at one lambda.
   subroutine report_theory(table, number, lambda, n_broken)
      integer, intent(in) :: table, number
      real(dp), intent(in) :: lambda
      integer, intent(inout) :: n_broken
      type(limit_t) :: bounds
      type(state_t) :: truth
      real(dp) :: radii(n_radii), bound(2), error(2), scale(2), ratios(2, n_radii), any_error(2), proved_error(2), &
         proved_bound(2)
      type(spread_t) :: looseness(2)
      real(qp) :: a, limit(2)
      integer :: k, n

      radii = logarithmic(-1.0_dp, 1.0_dp, n_radii)
      any_error = 0
      proved_error = 0
      proved_bound = 0
      n = 0
      call new_limit(bounds, number, lambda, 1.0_dp)
      do k = 1, n_radii
         truth = of_radius(lambda, radii(k))
         a = radii(k)
         limit = [a**3 - 2, a**2]
         if (number == theory_jkr) limit = [a**3 - sqrt(6*a**3), a**2 - 2*sqrt(6*a)/3]
         scale = real(max(abs(truth%value(2:3)), real(least_value, qp)), dp)
         error = real(abs(limit - truth%value(2:3)), dp)/scale
         any_error = max(any_error, error)
         call bounds%get_bounds(radii(k), bound(1), bound(2))
         if (.not. maxval(bound) < 1.0e10_dp) cycle
         n = n + 1
         bound = bound/scale
         if (.not. all(error <= bound)) n_broken = n_broken + 1
         proved_error = max(proved_error, error)
         proved_bound = max(proved_bound, bound)
         ratios(:, n) = bound/error
      end do
      looseness = [spread_of(ratios(1, :n)), spread_of(ratios(2, :n))]
      associate (name => merge('jkr', 'dmt', number == theory_jkr))
         print '(a6, es9.1, f8.2, 2(3es10.1, f10.1, 4x))', name, lambda, real(n, dp)/n_radii, &
            (any_error(k), proved_error(k), proved_bound(k), looseness(k)%median, k=1, 2)
         write (table, '(a, ",", es8.1, 2(",", i0), 2(3(",", es9.2), ",", f0.2))') name, lambda, n_radii, n, &
            (any_error(k), proved_error(k), proved_bound(k), looseness(k)%median, k=1, 2)
      end associate
   end subroutine report_theory

end module sphere_limits

! SPDX-License-Identifier: GPL-3.0-or-later
!> Contacts of a sphere with their answers in quadruple precision, for other programs to be compared with.
module sphere_points
   use adfric_base_kinds, only: dp
   use adfric_round_sphere_contact, only: sphere_contact_t, control_load, control_approach, control_radius, branch_stable, &
      & find_contact, &
      theory_jkr, theory_dmt
   use adfric_round_sphere_dmt, only: dmt_t
   use adfric_round_sphere_jkr, only: jkr_t
   use adfric_round_sphere_maugis_dugdale, only: maugis_t
   use adfric_round_sphere_theory_bounds, only: limit_t, new_limit
   use adfric_system_clock, only: wall_clock
   use measure, only: spread_t, spread_of, open_table
   use plain_dugdale, only: solve_plain
   use quad_dugdale, only: state_t, of_radius, of_load, pull_off_of_load, pull_off_of_approach, least_value
   use sphere_timing, only: time_theory, time_pull_off, logarithmic
   implicit none (type, external)
   private
   public :: write_points

contains

   !> Points with their quadruple-precision answers, ours, and our time in this moment, for other programs.
   subroutine write_points(path, decades, n_repeats, n_failed)
      character(*), intent(in) :: path
      !> Largest decimal logarithm of lambda, and of 1/lambda; repetitions of a timing.
      integer, intent(in) :: decades, n_repeats
      integer, intent(out) :: n_failed
      integer, parameter :: n = 50
      type(maugis_t) :: theory
      type(sphere_contact_t) :: contact, fold
      type(state_t) :: truth
      type(spread_t) :: t
      real(dp) :: lambda, prescribed(n), times(n_repeats), other_times(3)
      integer :: table, decade, control, k, failed

      n_failed = 0
      table = open_table(path, 'lambda,held,value,radius,load,approach,our_radius,our_load,'// &
         'our_approach,our_us,m_load,m_approach,m_us,jkr_load,jkr_approach,jkr_us,jkr_bound,dmt_load,dmt_approach,dmt_us,dmt_bound')
      do decade = -decades, decades
         lambda = 10.0_dp**decade
         theory%lambda = lambda
         call theory%pull_off(control_load, fold)
         prescribed = logarithmic(-2.0_dp, 2.0_dp, n)
         call time_theory(lambda, control_radius, prescribed, .false., times, failed)
         n_failed = n_failed + failed
         t = spread_of(times)
         call time_others(lambda, prescribed, n_repeats, other_times)
         do k = 1, n
            contact = sphere_contact_t()
            call find_contact(theory, control_radius, prescribed(k), branch_stable, contact)
            truth = of_radius(lambda, prescribed(k))
            call write_point(table, lambda, 'radius', prescribed(k), truth, contact, t%median, other_times)
         end do
         prescribed = fold%load + logarithmic(-2.0_dp, 2.0_dp, n)
         call time_theory(lambda, control_load, prescribed, .false., times, failed)
         n_failed = n_failed + failed
         t = spread_of(times)
         do k = 1, n
            contact = sphere_contact_t()
            call find_contact(theory, control_load, prescribed(k), branch_stable, contact)
            truth = of_load(lambda, prescribed(k))
            call write_point(table, lambda, 'load', prescribed(k), truth, contact, t%median)
         end do
         do control = control_load, control_approach
            call time_pull_off(lambda, control, times, failed)
            n_failed = n_failed + failed
            t = spread_of(times)
            call theory%pull_off(control, contact)
            truth = pull_off_of_load(lambda)
            if (control == control_approach) truth = pull_off_of_approach(lambda)
            call write_point(table, lambda, merge('pull-off of load    ', 'pull-off of approach', control == control_load), &
               0.0_dp, truth, contact, t%median)
         end do
      end do
      close (table)
   end subroutine write_points

   !> A row of the table of points.
   subroutine write_point(table, lambda, what, value, truth, contact, time, other_times)
      integer, intent(in) :: table
      real(dp), intent(in) :: lambda, value, time
      character(*), intent(in) :: what
      type(state_t), intent(in) :: truth
      type(sphere_contact_t), intent(in) :: contact
      !> Of the textbook's form, JKR and DMT, where the radius is held [us].
      real(dp), intent(in), optional :: other_times(3)

      write (table, '(es8.1, ",", a, ",", es24.16, 3(",", es42.32e4), 3(",", es24.16), ",", f0.4)', advance='no') lambda, &
         trim(what), value, truth%value, contact%radius, contact%load, contact%approach, time
      if (present(other_times)) then
         call write_others(table, lambda, value, truth, other_times)
      else
         write (table, '(a)') repeat(',', 11)
      end if
   end subroutine write_point

   !> Load and approach of a radius by the textbook's form and by the limit theories, with the larger of their proved relative
   !> bounds (infinite where there is none); empty where the textbook's form does not converge.
   subroutine write_others(table, lambda, radius, truth, times)
      integer, intent(in) :: table
      real(dp), intent(in) :: lambda, radius, times(3)
      type(state_t), intent(in) :: truth
      type(sphere_contact_t) :: limit
      type(jkr_t) :: jkr
      type(dmt_t) :: dmt
      real(dp) :: load, approach
      logical :: is_converged

      call solve_plain(lambda, radius, load, approach, is_converged)
      if (is_converged) then
         write (table, '(2(",", es24.16), ",", f0.4)', advance='no') load, approach, times(1)
      else
         write (table, '(",,,", f0.4)', advance='no') times(1)
      end if
      call jkr%of_radius(radius, limit)
      write (table, '(2(",", es24.16), ",", f0.4, ",", es9.2)', advance='no') limit%load, limit%approach, times(2), &
         bound_of(theory_jkr)
      limit = sphere_contact_t()
      call dmt%of_radius(radius, limit)
      write (table, '(2(",", es24.16), ",", f0.4, ",", es9.2)') limit%load, limit%approach, times(3), bound_of(theory_dmt)

   contains

      !> Of the larger of a value and `least_value`.
      real(dp) function bound_of(number)
         integer, intent(in) :: number
         type(limit_t) :: limit
         real(dp) :: bounds(2)

         call new_limit(limit, number, lambda, 1.0_dp)
         call limit%get_bounds(radius, bounds(1), bounds(2))
         bound_of = min(maxval(bounds/max(abs(real(truth%value(2:3), dp)), least_value)), 1.0e9_dp)
      end function bound_of

   end subroutine write_others

   !> Median time of load and approach of a radius by the textbook's form, JKR and DMT [us].
   subroutine time_others(lambda, radii, n_repeats, medians)
      real(dp), intent(in) :: lambda, radii(:)
      integer, intent(in) :: n_repeats
      real(dp), intent(out) :: medians(3)
      integer, parameter :: n_calls = 20
      type(spread_t) :: t
      type(sphere_contact_t) :: contact
      type(jkr_t) :: jkr
      type(dmt_t) :: dmt
      real(dp) :: times(n_repeats), start, load, approach, total
      logical :: is_converged
      integer :: which, r, k, call_number

      total = 0
      do which = 1, size(medians)
         do r = 1, n_repeats
            start = wall_clock()
            do call_number = 1, n_calls
               do k = 1, size(radii)
                  if (which == 1) call solve_plain(lambda, radii(k), load, approach, is_converged)
                  if (which == 2) call jkr%of_radius(radii(k), contact)
                  if (which == 3) call dmt%of_radius(radii(k), contact)
                  total = total + contact%load
               end do
            end do
            times(r) = 1.0e6_dp*(wall_clock() - start)/(n_calls*size(radii))
         end do
         t = spread_of(times)
         medians(which) = t%median
      end do
      ! so that no compiler leaves the sum out
      if (.not. abs(total) >= 0) medians = -1
   end subroutine time_others

end module sphere_points

!> Contacts of a sphere with their answers in quadruple precision, for other programs to be compared with.
module sphere_points
   use adfric_base_kinds, only: dp
   use adfric_sphere_contact, only: contact_t, control_load, control_approach, control_radius, branch_stable, find_contact
   use adfric_sphere_maugis_dugdale, only: maugis_t
   use measure, only: spread_t, spread_of, open_table
   use quad_dugdale, only: state_t, of_radius, of_load, pull_off_of_load, pull_off_of_approach
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
      type(contact_t) :: contact, fold
      type(state_t) :: truth
      type(spread_t) :: t
      real(dp) :: lambda, held(n), times(n_repeats)
      integer :: table, decade, control, k, failed

      n_failed = 0
      table = open_table(path, 'lambda,held,value,radius,load,approach,our_radius,our_load,'// &
         'our_approach,our_us')
      do decade = -decades, decades
         lambda = 10.0_dp**decade
         theory%lambda = lambda
         call theory%pull_off(control_load, fold)
         held = logarithmic(-2.0_dp, 2.0_dp, n)
         call time_theory(lambda, control_radius, held, .false., times, failed)
         n_failed = n_failed + failed
         t = spread_of(times)
         do k = 1, n
            contact = contact_t()
            call find_contact(theory, control_radius, held(k), branch_stable, contact)
            truth = of_radius(lambda, held(k))
            call write_point(table, lambda, 'radius', held(k), truth, contact, t%median)
         end do
         held = fold%load + logarithmic(-2.0_dp, 2.0_dp, n)
         call time_theory(lambda, control_load, held, .false., times, failed)
         n_failed = n_failed + failed
         t = spread_of(times)
         do k = 1, n
            contact = contact_t()
            call find_contact(theory, control_load, held(k), branch_stable, contact)
            truth = of_load(lambda, held(k))
            call write_point(table, lambda, 'load', held(k), truth, contact, t%median)
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
   subroutine write_point(table, lambda, what, value, truth, contact, time)
      integer, intent(in) :: table
      real(dp), intent(in) :: lambda, value, time
      character(*), intent(in) :: what
      type(state_t), intent(in) :: truth
      type(contact_t), intent(in) :: contact

      write (table, '(es8.1, ",", a, ",", es24.16, 3(",", es42.32e4), 3(",", es24.16), ",", f0.4)') lambda, trim(what), &
         value, truth%value, contact%radius, contact%load, contact%approach, time
   end subroutine write_point

end module sphere_points

! SPDX-License-Identifier: GPL-3.0-or-later
!> Time of a point of the closed forms on a half-space, and the largest error that they report.
!>
!>     closed_forms [TABLE.csv]
!>
!> Sweeps in blocks as the program cuts them. Along a load or an approach the points of a block share what depends on the shape of
!> Hertz's contact alone; along an angle or Poisson's ratio they share nothing. See bench/README.md.
program closed_forms
   use, intrinsic :: iso_fortran_env, only: output_unit
   use adfric_base_kinds, only: dp, i8
   use adfric_describe_status, only: status_solved
   use adfric_run_blocks, only: block_size_of
   use adfric_system_clock, only: wall_clock
   use measure, only: spread_t, spread_of, print_heading, text_argument, open_table
   use trial_case, only: trial_case_t, new_case
   implicit none (type, external)

   integer, parameter :: n_repeats = 9, n_points = 2048
   type(trial_case_t) :: case
   integer :: table, k

   call print_heading('Closed forms on a half-space')
   table = open_table(text_argument(1, 'closed_forms.csv'), 'model,case,swept,us,us_least,us_most,error_estimate')
   print '(a13, a13, a20, a30, a16)', 'model', 'case', 'swept', 'us per point (range)', 'error_estimate'

   call start('hertz', 'kind', 1.0_dp)
   call case%give('radius', 0.01_dp)
   call case%give('poisson_ratio', 0.3_dp)
   call report('line', 'load', 1.0_dp, 1.0e3_dp)
   call case%give('load', 10.0_dp)
   call report('line', 'poisson_ratio', 0.1_dp, 0.5_dp)
   call start('hertz', 'kind', 2.0_dp)
   call case%give('radius', 0.01_dp)
   call case%give('poisson_ratio', 0.3_dp)
   call report('circular', 'load', 1.0_dp, 1.0e3_dp)
   call report('circular', 'approach', 1.0e-8_dp, 1.0e-6_dp)
   call start('hertz', 'kind', 3.0_dp)
   call case%give('radius_1x', 0.02_dp)
   call case%give('radius_1y', 0.01_dp)
   call case%give('radius_2x', 0.05_dp)
   call case%give('poisson_ratio', 0.3_dp)
   call report('elliptical', 'load', 1.0_dp, 1.0e3_dp)
   call report('elliptical', 'approach', 1.0e-8_dp, 1.0e-6_dp)
   call case%give('load', 10.0_dp)
   call report('elliptical', 'angle', 0.1_dp, 1.5_dp)

   call start('wave_1d', 'period', 1.0e-3_dp)
   call case%give('amplitude', 1.0e-6_dp)
   call report('pressure', 'mean_pressure', 1.0e5_dp, 4.0e6_dp)
   call report('penetration', 'penetration', 1.0e-9_dp, 9.0e-7_dp)
   ! with adhesion a sweep of the stress looks for the events of each wave anew
   call start('wave_1d', 'period', 1.0e-3_dp)
   call case%give('amplitude', 1.0e-6_dp)
   call case%give('stress', 1.0e6_dp)
   call case%give('range', 3.0e-7_dp)
   call report('adhesive', 'mean_pressure', 1.0e4_dp, 1.0e6_dp)
   call report('adhesive', 'penetration', 1.0e-9_dp, 9.0e-7_dp)
   call case%give('mean_pressure', 1.0e5_dp)
   call report('adhesive', 'stress', 1.0e4_dp, 3.0e6_dp)

   do k = 1, 4
      call start('rigid_punch', 'kind', real(k, dp))
      select case (k)
      case (1)
         call case%give('half_width', 1.0e-3_dp)
         call report('flat', 'load', 1.0_dp, 1.0e3_dp)
      case (2)
         call case%give('slope', 0.01_dp)
         call report('wedge', 'load', 1.0_dp, 1.0e3_dp)
      case (3)
         call case%give('radius', 0.01_dp)
         call report('cylinder', 'load', 1.0_dp, 1.0e3_dp)
      case (4)
         call case%give('coefficient_4', 1.0e5_dp)
         call report('x^4', 'load', 1.0_dp, 1.0e3_dp)
         call report('x^4', 'contact_half_width', 1.0e-5_dp, 1.0e-3_dp)
         call case%give('load', 10.0_dp)
         call report('x^4', 'points', 8.0_dp, 64.0_dp)
      end select
   end do

   call start('strip_load', 'distribution', 1.0_dp)
   call given_load('normal_traction', 'half_width')
   call report('uniform', 'position_x', 1.0e-4_dp, 1.0e-2_dp)
   call case%give('distribution', 2.0_dp)
   call report('hertz', 'position_x', 1.0e-4_dp, 1.0e-2_dp)
   call start('line_load', 'position_y', 1.0e-3_dp)
   call given_load('normal_load', 'datum')
   call report('line', 'position_x', 1.0e-4_dp, 1.0e-2_dp)
   call start('point_load', 'position_y', 1.0e-3_dp)
   call case%give('position_z', 1.0e-3_dp)
   call given_load('normal_load', 'tangential_load')
   call report('point', 'position_x', 1.0e-4_dp, 1.0e-2_dp)
   close (table)

contains

   !> A case of a model, with its first value; contacts get a modulus.
   subroutine start(model, name, value)
      character(*), intent(in) :: model, name
      real(dp), intent(in) :: value

      call new_case(case, model)
      call case%give(name, value)
      if (case%model%index_of('solid', 'contact_modulus') > 0) call case%give('contact_modulus', 1.0e9_dp)
   end subroutine start

   !> What the given loads need.
   subroutine given_load(load, other)
      !> Its name, and that of another variable.
      character(*), intent(in) :: load, other

      call case%give('young_modulus', 1.0e9_dp)
      call case%give('poisson_ratio', 0.3_dp)
      call case%give(load, 1.0e3_dp)
      call case%give(other, 1.0e-3_dp)
      if (case%model%index_of('position', 'position_z') == 0) call case%give('position_y', 1.0e-3_dp)
   end subroutine given_load

   !> Time of a point along a sweep in even steps of the logarithm; the variable is not given then.
   subroutine report(kind, swept, first, last)
      character(*), intent(in) :: kind, swept
      real(dp), intent(in) :: first, last
      type(trial_case_t) :: one
      real(dp) :: values(size(case%values), n_points), results(size(case%model%results), n_points), estimate(n_points), &
         times(n_repeats)
      integer :: status(n_points), r, i
      type(spread_t) :: time

      one = case
      do i = 1, n_points
         call one%give(swept, first*(last/first)**((i - 1.0_dp)/(n_points - 1)))
         values(:, i) = one%values
      end do
      do r = 1, n_repeats
         times(r) = wall_clock()
         call solve(values, results, estimate, status)
         times(r) = 1.0e6_dp*(wall_clock() - times(r))/n_points
      end do
      if (any(status /= status_solved)) error stop 'closed_forms: not solved'
      time = spread_of(times)
      print '(a13, a13, a20, f10.3, 2(a, f7.3), a, es15.1)', case%model%name, kind, swept, time%median, ' (', time%least, ' to ', &
         time%most, ')', maxval(estimate)
      write (table, '(3(a, ","), 3(f0.4, ","), es8.2)') case%model%name, kind, swept, time, maxval(estimate)
      flush (output_unit)
   end subroutine report

   !> Solve points in blocks.
   subroutine solve(values, results, estimate, status)
      real(dp), intent(in) :: values(:, :)
      real(dp), intent(out) :: results(:, :), estimate(:)
      integer, intent(out) :: status(:)
      real(dp) :: counts(size(case%model%counts))
      integer :: first, last, block

      block = block_size_of(100000_i8)
      do first = 1, size(status), block
         last = min(first + block - 1, size(status))
         call case%model%solve_block(values(:, first:last), results(:, first:last), estimate(first:last), status(first:last), &
            counts)
      end do
   end subroutine solve

end program closed_forms

! SPDX-License-Identifier: GPL-3.0-or-later
!> Time of a point of an indenter, and the largest error that it reports.
!>
!>     indenter [TABLE.csv]
!>
!> Sweeps in blocks as the program cuts them, for every kind of shape: without adhesion, by JKR, and by Maugis's theory. Along a load,
!> an approach or a radius the points of a block share the survey of Maugis's curve; along the work of adhesion each has its own. Partial
!> slip is that of contacts without adhesion, from small forces to sliding, and that of a shear strength with adhesion. With interaction
!> the force takes from adhesion, JKR's and that of a range; on a lateral spring each point has a way of its own, whose jumps are found. A
!> history is one point of many steps, of which each counts: load and force wander, so that the stack of its memory is up to some tens of
!> entries.
program indenter
   use, intrinsic :: iso_fortran_env, only: output_unit
   use adfric_base_kinds, only: dp, i8
   use adfric_base_problems, only: problems_t
   use adfric_base_words, only: get_word
   use adfric_describe_status, only: status_solved
   use adfric_run_blocks, only: block_size_of
   use adfric_system_clock, only: wall_clock
   use measure, only: spread_t, spread_of, print_heading, text_argument, open_table
   use trial_case, only: trial_case_t, new_case
   implicit none (type, external)

   !> Points of a sweep; those that have a way of their own are fewer.
   integer, parameter :: n_repeats = 5, n_points = 2048, n_paths = 64
   character(*), parameter :: kinds = 'flat cone paraboloid power sphere flat_cone flat_paraboloid rounded_punch '// &
      & 'rounded_cone polynomial'
   type(trial_case_t) :: case
   integer :: table, kind

   call print_heading('Indenters')
   table = open_table(text_argument(1, 'indenter.csv'), 'theory,kind,swept,us,us_least,us_most,error_estimate')
   print '(a16, a16, a20, a35, a16)', 'theory', 'kind', 'swept', 'us per point (range)', 'error_estimate'
   do kind = 1, 10
      call start(kind)
      call report('none', 'load', 1.0e-3_dp, 10.0_dp)
      call report('none', 'approach', 1.0e-3_dp, 1.0_dp)
      call report_slip()
      call case%give('work_of_adhesion', 0.01_dp)
      call report('jkr', 'load', 1.0e-3_dp, 10.0_dp)
      call report('jkr', 'approach', 0.1_dp, 1.0_dp)
      call case%give('adhesion_stress', 0.2_dp)
      call report('maugis_dugdale', 'load', 1.0e-3_dp, 10.0_dp)
      call report('maugis_dugdale', 'approach', 0.1_dp, 1.0_dp)
      if (kind > 1) call report('maugis_dugdale', 'contact_radius', 0.2_dp, 2.0_dp)
      call case%give('load', 0.1_dp)
      call report('maugis_dugdale', 'work_of_adhesion', 1.0e-3_dp, 0.1_dp)
      call report_strength()
      call report_interaction()
      call report_history(kind)
   end do
   close (table)

contains

   !> A kind with lengths and slopes of 1 and a modulus of 1, but for a sphere that is larger than its contacts.
   subroutine start(kind)
      integer, intent(in) :: kind

      call new_case(case, 'indenter')
      call start_shape(kind)
   end subroutine start

   !> The shape of a kind.
   subroutine start_shape(kind)
      integer, intent(in) :: kind

      call case%give('kind', real(kind, dp))
      call case%give('contact_modulus', 1.0_dp)
      if (any(kind == [3, 5, 7, 8, 9])) call case%give('radius', merge(4.0_dp, 1.0_dp, kind == 5))
      if (any(kind == [2, 6, 9])) call case%give('slope', 1.0_dp)
      if (any(kind == [1, 6, 7, 8])) call case%give('face_radius', 0.2_dp)
      if (kind == 4) call case%give('exponent', 2.5_dp)
      if (kind == 4) call case%give('coefficient', 1.0_dp)
      if (kind == 10) call case%give('coefficient_2', 0.5_dp)
      if (kind == 10) call case%give('coefficient_4', 0.2_dp)
   end subroutine start_shape

   !> Partial slip under a load of 1.
   subroutine report_slip()
      type(trial_case_t) :: plain

      plain = case
      call case%give('load', 1.0_dp)
      call case%give('poisson_ratio', 0.3_dp)
      case%values(case%model%index_of('friction', 'coefficient')) = 1
      call report('slip', 'tangential_force', 1.0e-6_dp, 1.0_dp)
      case = plain
   end subroutine report_slip

   !> Partial slip of a shear strength under a load of 1, with adhesion of a range.
   subroutine report_strength()
      type(trial_case_t) :: plain

      plain = case
      call case%give('load', 1.0_dp)
      call case%give('poisson_ratio', 0.3_dp)
      call case%give('shear_strength', 1.0_dp)
      call case%give('pressure_factor', 0.3_dp)
      call case%give('work_of_adhesion', 0.01_dp)
      call report('strength', 'tangential_force', 1.0e-6_dp, 0.03_dp)
      case = plain
   end subroutine report_strength

   !> A force that takes half of the work of its slip from adhesion, and a lateral spring.
   subroutine report_interaction()
      type(trial_case_t) :: plain

      plain = case
      call start(kind)
      call case%give('load', 1.0_dp)
      call case%give('poisson_ratio', 0.3_dp)
      call case%give('shear_strength', 1.0_dp)
      call case%give('work_of_adhesion', 0.01_dp)
      call case%give('slip_energy_ratio', 1.0_dp)
      call case%give('interaction', 0.5_dp)
      call report('interaction jkr', 'tangential_force', 1.0e-6_dp, 0.03_dp)
      call case%give('adhesion_stress', 0.2_dp)
      call report('interaction', 'tangential_force', 1.0e-6_dp, 0.03_dp, n_paths)
      call case%give('events', 1.0_dp)
      call report('lateral spring', 'lateral_stiffness', 1.0e-2_dp, 10.0_dp, n_paths)
      case = plain
   end subroutine report_interaction

   !> A history of random forces.
   subroutine report_history(kind)
      integer, intent(in) :: kind
      integer, parameter :: n_steps = 20000
      type(trial_case_t) :: plain
      type(problems_t) :: problems
      real(dp) :: draws(n_steps, 2), results(3, 1), estimate(1), times(n_repeats), counts(0)
      integer :: status(1), r, loads, forces
      type(spread_t) :: time

      plain = case
      call new_case(case, 'indenter_history')
      call start_shape(kind)
      call case%give('poisson_ratio', 0.3_dp)
      case%values(case%model%index_of('friction', 'coefficient')) = 0.3_dp
      call random_init(repeatable=.true., image_distinct=.false.)
      call random_number(draws)
      draws(:, 2) = 0.29_dp*draws(:, 1)*(2*draws(:, 2) - 1)
      loads = case%model%index_of('history', 'loads')
      forces = case%model%index_of('history', 'tangential_forces')
      case%values([loads, forces]) = 1
      call case%model%take_dataset(loads, draws(:, 1:1), problems)
      call case%model%take_dataset(forces, draws(:, 2:2), problems)
      do r = 1, n_repeats
         times(r) = wall_clock()
         call case%model%solve_block(reshape(case%values, [size(case%values), 1]), results, estimate, status, counts)
         times(r) = 1.0e6_dp*(wall_clock() - times(r))/n_steps
      end do
      if (any(status /= status_solved)) error stop 'indenter: not solved'
      time = spread_of(times)
      print '(a16, a16, a20, f11.3, 2(a, f9.3), a, es15.1)', 'history', get_word(kinds, kind), 'step', time%median, ' (', &
         time%least, ' to ', time%most, ')', maxval(estimate)
      write (table, '(3(a, ","), 3(f0.4, ","), es8.2)') 'history', get_word(kinds, kind), 'step', time, maxval(estimate)
      case = plain
   end subroutine report_history

   !> Time of a point along a sweep in even steps of the logarithm; the variable is not given then.
   subroutine report(theory, swept, first, last, n_given)
      character(*), intent(in) :: theory, swept
      real(dp), intent(in) :: first, last
      !> Number of points.
      integer, intent(in), optional :: n_given
      type(trial_case_t) :: one
      real(dp), allocatable :: values(:, :), results(:, :), estimate(:)
      real(dp) :: times(n_repeats)
      integer, allocatable :: status(:)
      integer :: n, r, i
      type(spread_t) :: time

      n = n_points
      if (present(n_given)) n = n_given
      allocate (values(size(case%values), n), results(size(case%model%results), n), estimate(n), status(n))
      one = case
      do i = 1, n
         call one%give(swept, first*(last/first)**((i - 1.0_dp)/(n - 1)))
         values(:, i) = one%values
      end do
      do r = 1, n_repeats
         times(r) = wall_clock()
         call solve(values, results, estimate, status)
         times(r) = 1.0e6_dp*(wall_clock() - times(r))/n
      end do
      if (any(status /= status_solved)) error stop 'indenter: not solved'
      time = spread_of(times)
      print '(a16, a16, a20, f11.3, 2(a, f9.3), a, es15.1)', theory, get_word(kinds, kind), swept, time%median, ' (', &
         time%least, ' to ', time%most, ')', maxval(estimate)
      write (table, '(3(a, ","), 3(f0.4, ","), es8.2)') theory, get_word(kinds, kind), swept, time, maxval(estimate)
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

end program indenter

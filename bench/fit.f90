! SPDX-License-Identifier: GPL-3.0-or-later
!> Fits of synthetic friction curves: how often an interval contains the truth, and how long a fit takes.
!>
!>     fit [COUNT [SEED [TABLE.csv]]]
!>
!> COUNT (100) curves a case. Beside each share stands what 1e4 fits with another model and other minimisers gave; an asterisk marks one
!> that differs by more than two sampling errors. A profile contains the truth if S with that variable held there is above the least S by
!> no more than the limit. See bench/README.md.
program fit
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_unset, only: unset
   use adfric_fit_course, only: course_t, begin_course
   use adfric_fit_path, only: sphere_path_t, set_path
   use adfric_fit_problem, only: fit_t, free_t, data_set_t, event_t, event_pull_off_load
   use adfric_fit_solution, only: solution_t, fit_solved
   use adfric_fit_solve, only: solve_fit
   use adfric_fit_starts, only: get_start
   use adfric_numerics_distributions, only: chi_squared_quantile, f_quantile, normal_quantile, t_quantile
   use adfric_numerics_random_numbers, only: random_t, new_random, next_normal
   use adfric_round_sphere_contact, only: theory_maugis_dugdale
   use adfric_round_sphere_model, only: sphere_model_t, new_sphere_model
   use adfric_round_sphere_variables, only: n_sphere_results, n_sphere_variables, state_sliding, units_si, &
      & in => sphere_input, out => sphere_output
   use measure, only: print_heading, integer_argument, text_argument, open_table
   implicit none (type, external)

   !> The tip of K. L. Johnson's Fig. 5.
   real(dp), parameter :: radius = 1.4e-7_dp, modulus = 4.4e10_dp, truth(2) = [0.19_dp, 9.6e8_dp], levels(2) = [0.6827_dp, 0.95_dp]
   !> Kinds of data: exact loads, loads with errors, loads whose errors are left out of the fit, errors that are not known.
   integer, parameter :: exact = 1, latent = 2, neglected = 3, unknown = 4
   type(sphere_model_t), target :: model
   integer :: table, n

   call new_sphere_model(model)
   call print_heading('Fits of friction against load')
   n = integer_argument(1, 100)
   table = open_table(text_argument(3, 'fit.csv'), 'case,variable,wald_68,wald_95,profile_68,profile_95,fits')
   print '(a, i0, a)', 'Share of intervals with the truth, ', n, ' curves a case; in brackets 1e4 others'
   print '(a34, a17, 4a15)', 'case', 'variable', 'Wald 68 %', 'Wald 95 %', 'profile 68 %', 'profile 95 %'
   call cover('x = 0, lambda 0.8', 0.0_dp, 0.8_dp, 40, exact, [689, 690, 696, 956, 953, 953, 690, 689, 696, 956, 953, 953])
   call cover('x = 0.4, lambda 0.8', 0.4_dp, 0.8_dp, 40, exact, [564, 607, 570, 718, 828, 711, 571, 601, 573, 942, 932, 946])
   call cover('x = 0.4, lambda 5', 0.4_dp, 5.0_dp, 40, exact, [558, 653, 603, 766, 764, 714, 584, 639, 639, 906, 927, 926])
   call cover('x = 0, lambda 5', 0.0_dp, 5.0_dp, 40, exact, [687, 742, 777, 953, 967, 915, 679, 687, 683, 949, 962, 961])
   call cover('x = 0, lambda 0.1', 0.0_dp, 0.1_dp, 40, exact, [678, 677, 688, 950, 948, 950, 678, 675, 685, 952, 948, 946])
   call cover('load errors 2 %', 0.0_dp, 0.8_dp, 40, latent, [687, 677, 681, 951, 951, 952, 687, 677, 681, 952, 951, 952])
   call cover('load errors left out', 0.0_dp, 0.8_dp, 40, neglected, [474, 594, 599, 787, 898, 905, 474, 594, 598, 781, 899, 904])
   call cover('sigma not known, 10 points', 0.0_dp, 0.8_dp, 10, unknown, [680, 681, 0, 945, 948, 0, 681, 682, 0, 945, 948, 0])
   close (table)
   call time_fits()

contains

   !> A curve without noise: friction and pull-off.
   subroutine new_curve(edge, lambda, n_points, kind, problem)
      real(dp), intent(in) :: edge, lambda
      integer, intent(in) :: n_points, kind
      type(fit_t), intent(out) :: problem
      type(data_set_t) :: data
      type(sphere_path_t) :: path
      real(dp) :: values(n_sphere_variables, n_points), results(n_sphere_results, n_points), error(n_points), counts(1), pull_off
      integer :: status(n_points), k

      problem%model => model
      problem%base = model%variables%default
      problem%base([in%units, in%state, in%theory]) = [units_si, state_sliding, theory_maugis_dugdale + 2]
      problem%base([in%radius, in%contact_modulus, in%edge_fraction]) = [radius, modulus, edge]
      problem%base([in%work_of_adhesion, in%shear_strength, in%lambda]) = [truth, lambda]
      call set_path(path, theory_maugis_dugdale, .false., lambda, 0.0_dp)
      pull_off = pi*truth(1)*radius*path%fold%p
      do k = 1, n_points
         values(:, k) = problem%base
         values(in%load, k) = pull_off*(0.9_dp - 3.9_dp*(k - 1)/(n_points - 1))
      end do
      call model%solve_block(values, results, error, status, counts)
      data%abscissa = in%load
      data%ordinate = out%friction_force
      data%x = values(in%load, :)
      data%y = results(out%friction_force, :)
      allocate (data%sigma(n_points), source=0.01_dp*data%y(minloc(abs(data%x), 1)))
      if (kind == latent) allocate (data%x_sigma(n_points), source=0.02_dp*abs(pull_off))
      problem%data_sets = [data]
      allocate (problem%events(0), problem%levels(0), problem%theories(0))
      if (kind /= unknown) problem%events = [event_t(1, event_pull_off_load, pull_off, 0.01_dp*abs(pull_off))]
      problem%wants_curves = .false.
      allocate (problem%frees(merge(2, 3, kind == unknown)))
      problem%frees(1) = new_free(in%work_of_adhesion)
      problem%frees(2) = new_free(in%shear_strength)
      if (kind /= unknown) problem%frees(3) = new_free(in%lambda)
   end subroutine new_curve

   !> A free variable without bounds of its own.
   type(free_t) function new_free(index)
      integer, intent(in) :: index

      new_free%name = model%variables(index)%name
      new_free%unit = model%variables(index)%unit
      new_free%variable = index
   end function new_free

   !> The same with noise.
   subroutine add_noise(from, kind, random, problem)
      type(fit_t), intent(in) :: from
      integer, intent(in) :: kind
      type(random_t), intent(inout) :: random
      type(fit_t), intent(out) :: problem
      real(dp) :: noise
      integer :: i

      problem = from
      associate (data => problem%data_sets(1))
         do i = 1, size(data%x)
            call next_normal(random, noise)
            data%y(i) = data%y(i) + noise*data%sigma(i)
            if (kind /= latent .and. kind /= neglected) cycle
            call next_normal(random, noise)
            data%x(i) = data%x(i) + 2*noise*from%events(1)%sigma
         end do
         if (kind == unknown) deallocate (data%sigma)
      end associate
      do i = 1, size(problem%events)
         call next_normal(random, noise)
         problem%events(i)%value = problem%events(i)%value + noise*problem%events(i)%sigma
      end do
   end subroutine add_noise

   !> How often the intervals of a case contain the truth.
   subroutine cover(name, edge, lambda, n_points, kind, expected)
      character(*), intent(in) :: name
      real(dp), intent(in) :: edge, lambda
      integer, intent(in) :: n_points, kind
      !> Thousandths: the three variables by Wald 68 % and 95 %, by profile 68 % and 95 %.
      integer, intent(in) :: expected(12)
      type(fit_t) :: clean, noisy
      type(solution_t) :: found
      type(random_t) :: random
      integer :: hits(3, 4), trial, k, n_solved, n_beyond
      real(dp) :: v(3)

      v = [truth, lambda]
      call new_curve(edge, lambda, n_points, kind, clean)
      call new_random(random, integer_argument(2, 1))
      hits = 0
      n_solved = 0
      n_beyond = 0
      do trial = 1, n
         call add_noise(clean, kind, random, noisy)
         call solve_fit(noisy, found)
         if (found%points_beyond_fold > 0) n_beyond = n_beyond + 1
         if (found%status /= fit_solved) cycle
         n_solved = n_solved + 1
         do k = 1, size(noisy%frees)
            call count_hits(noisy, found, k, v(k), hits(k, :))
         end do
      end do
      do k = 1, size(clean%frees)
         print '(a34, a17, 4(f7.3, a8))', name, clean%frees(k)%name, (hits(k, trial)/max(real(n_solved, dp), 1.0_dp), &
            & label_of(hits(k, trial), n_solved, expected(k + 3*(trial - 1))), trial=1, 4)
         write (table, '(4a, 4(i0, a), i0)') name, ',', clean%frees(k)%name, ',', (hits(k, trial), ',', trial=1, 4), n_solved
      end do
      if (n_solved < n) print '(a, i0, a, i0, a)', '   not solved: ', n - n_solved, ', with points beyond the fold: ', n_beyond
   end subroutine cover

   !> What was expected, in brackets, marked if what was found is more than two sampling errors from it.
   function label_of(hits, n_fits, expected) result(label)
      integer, intent(in) :: hits, n_fits, expected
      character(8) :: label
      real(dp) :: share, margin

      share = expected/1000.0_dp
      write (label, '(a, f4.3, a)') ' (', share, ') '
      margin = 2*sqrt(share*(1 - share)*(1.0_dp/max(n_fits, 1) + 1.0e-4_dp))
      if (abs(hits/real(max(n_fits, 1), dp) - share) > margin) label(8:8) = '*'
   end function label_of

   !> Do the four intervals of a variable contain the truth?
   subroutine count_hits(problem, found, k, value, hits)
      type(fit_t), intent(in) :: problem
      type(solution_t), intent(in) :: found
      integer, intent(in) :: k
      real(dp), intent(in) :: value
      integer, intent(inout) :: hits(4)
      type(fit_t) :: prescribed
      type(solution_t) :: there
      integer :: i, level
      real(dp) :: reach(2), limit(2), excess, variance

      reach = normal_quantile(levels)
      limit = chi_squared_quantile(levels, 1)
      variance = 1
      if (found%covariance_scaled) then
         reach = t_quantile(levels, found%degrees_of_freedom)
         limit = f_quantile(levels, 1, found%degrees_of_freedom)
         variance = found%sigma_estimate**2
      end if
      prescribed = problem
      prescribed%frees = pack(problem%frees, [(i /= k, i=1, size(problem%frees))])
      prescribed%base(problem%frees(k)%variable) = value
      call solve_fit(prescribed, there)
      excess = (there%chi2 - found%chi2)/variance
      do level = 1, 2
         if (abs(log(found%estimate(k)/value)) <= reach(level)*found%error_internal(k)) hits(level) = hits(level) + 1
         if (there%status == fit_solved .and. excess <= limit(level)) hits(2 + level) = hits(2 + level) + 1
      end do
   end subroutine count_hits

   !> Time of a fit of 200 points with three free variables, and the part of the model in it.
   subroutine time_fits()
      integer, parameter :: n_points = 200
      real(dp), parameter :: lambdas(3) = [0.1_dp, 0.8_dp, 5.0_dp]
      type(fit_t) :: clean, noisy
      type(solution_t) :: found
      type(random_t) :: random
      real(dp) :: start, finish, total, of_model, evaluations
      integer :: k, x, trial, n_timed

      n_timed = max(n/4, 10)
      print '(/, a)', 'Fits of 200 points with three free variables'
      print '(a8, a8, a12, a14, a20)', 'x', 'lambda', 'ms per fit', 'evaluations', 'share of the model'
      do x = 0, 1
         do k = 1, 3
            call new_curve(0.4_dp*x, lambdas(k), n_points, exact, clean)
            call new_random(random, 1)
            total = 0
            evaluations = 0
            do trial = 1, n_timed
               call add_noise(clean, exact, random, noisy)
               call cpu_time(start)
               call solve_fit(noisy, found)
               call cpu_time(finish)
               total = total + finish - start
               evaluations = evaluations + found%evaluations
            end do
            of_model = time_of_evaluation(noisy)*evaluations
            print '(f8.1, f8.1, f12.2, f14.1, f20.2)', 0.4_dp*x, lambdas(k), 1.0e3_dp*total/n_timed, evaluations/n_timed, &
               & of_model/total
         end do
      end do
   end subroutine time_fits

   !> Time of an evaluation of all points with their derivatives, from the indices of the one before, about as far as a step of a
   !> search.
   real(dp) function time_of_evaluation(problem) result(time)
      type(fit_t), intent(in) :: problem
      integer, parameter :: n_repeats = 200
      type(course_t) :: course
      real(dp) :: q(size(problem%frees)), moved(size(problem%frees)), cost, start, finish
      logical :: is_valid
      integer :: k

      call begin_course(course, problem)
      call get_start(course%objective, problem, unset, course%work, q)
      call cpu_time(start)
      do k = 1, n_repeats
         moved = q + 0.05_dp*sin(real(k, dp))
         associate (work => course%work)
            call course%objective%evaluate(moved, work%n_rows, work%r, work%j, cost, is_valid)
         end associate
      end do
      call cpu_time(finish)
      time = (finish - start)/n_repeats
   end function time_of_evaluation

end program fit

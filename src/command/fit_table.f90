! SPDX-License-Identifier: GPL-3.0-or-later
!> What a single fit has to say.
module adfric_command_fit_table
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_base_text, only: newline, show_count, show_number
   use adfric_base_unset, only: is_set
   use adfric_base_words, only: has_word, pad
   use adfric_command_fit_sets, only: show_set
   use adfric_command_rounding, only: show_to_digits, show_to_error
   use adfric_fit_problem, only: fit_t
   use adfric_fit_solution, only: solution_t, fit_solved, fit_too_few_points, fit_not_identifiable
   use adfric_describe_table, only: result_t
   implicit none (type, external)
   private
   public :: new_fit_table

   !> Widths of the columns of the table, and of the names below it.
   integer, parameter :: free_width = 28, unit_width = 8, number_width = 14, set_width = 34, name_width = 30
   !> Correlations beyond this are named.
   real(dp), parameter :: large_correlation = 0.95_dp
   !> Components of a direction below this are not named.
   real(dp), parameter :: small_component = 1.0e-6_dp
   !> A theory whose AIC is not larger by more is as good.
   real(dp), parameter :: worst_rival = 2
   !> Most indices that are listed.
   integer, parameter :: most_listed = 10

contains

   !> Variables, goodness, correlations, minima, what the data do not see, points, derived quantities and theories.
   function new_fit_table(fit, solution) result(text)
      type(fit_t), intent(in) :: fit
      type(solution_t), intent(in) :: solution
      character(:), allocatable :: text

      text = ''
      if (solution%status == fit_solved) text = variable_lines(fit, solution)
      if (solution%status /= fit_solved) text = line('no answer', say_reason(solution))
      if (any(solution%status == [fit_solved, fit_not_identifiable])) text = text//goodness_lines(fit, solution)
      text = text//null_lines(fit, solution)
      if (solution%status == fit_solved) text = text//correlation_lines(fit, solution)//minima_lines(fit, solution)
      text = text//point_lines(fit, solution)
      if (solution%status == fit_solved) text = text//derived_lines(solution)//theory_lines(fit, solution)
   end function new_fit_table

   !> A line of a name and a text.
   pure function line(name, rest)
      !> Name, at the beginning.
      character(*), intent(in) :: name
      !> What is said.
      character(*), intent(in) :: rest
      character(:), allocatable :: line

      line = pad(name, name_width)//rest//newline
   end function line

   !> Why there is no answer.
   pure function say_reason(solution) result(text)
      type(solution_t), intent(in) :: solution
      character(:), allocatable :: text

      select case (solution%status)
      case (fit_too_few_points)
         text = 'too few points'
      case (fit_not_identifiable)
         text = 'the data do not say what is free'
      case default
         text = 'the search did not converge'
      end select
      if (.not. allocated(solution%reason)) return
      if (len(solution%reason) > 0) text = text//': '//solution%reason
   end function say_reason

   !> A line for each free variable.
   function variable_lines(fit, solution) result(lines)
      type(fit_t), intent(in) :: fit
      type(solution_t), intent(in) :: solution
      character(:), allocatable :: lines, start
      real(dp) :: level
      integer :: i, k

      k = 1
      level = 0
      if (size(fit%levels) > 0) then
         k = minloc(abs(fit%levels - 0.95_dp), dim=1)
         level = fit%levels(k)
      end if
      lines = pad(pad(pad(pad(pad('variable', free_width)//'unit', free_width + unit_width)//'value', &
         free_width + unit_width + number_width)//'standard error', free_width + unit_width + 2*number_width + 2)// &
         show_number(100*level)//' % set', free_width + unit_width + 2*number_width + 2 + set_width)//'start'//newline
      do i = 1, size(fit%frees)
         start = 'from data'
         if (is_set(fit%frees(i)%start)) start = show_number(fit%frees(i)%start)
         lines = lines//pad(pad(pad(pad(pad(fit%frees(i)%name, free_width)//fit%frees(i)%unit, free_width + unit_width) &
            //show_to_error(solution%estimate(i), solution%error(i)), free_width + unit_width + number_width) &
            //show_error(solution, i), free_width + unit_width + 2*number_width + 2) &
            //show_set(fit, solution, i, k), free_width + unit_width + 2*number_width + 2 + set_width)//start &
            //trim(merge(', at a bound', '            ', solution%at_bound(i) /= 0))//newline
      end do
   end function variable_lines

   !> A standard error with two digits.
   pure function show_error(solution, i) result(text)
      type(solution_t), intent(in) :: solution
      !> Number of the free variable.
      integer, intent(in) :: i
      character(:), allocatable :: text

      text = 'none'
      if (ieee_is_finite(solution%error(i))) text = show_to_digits(solution%error(i), 2)
   end function show_error

   !> How well the model fits.
   function goodness_lines(fit, solution) result(lines)
      !> The fit, the unit of whose ordinate is that of sigma.
      type(fit_t), intent(in) :: fit
      type(solution_t), intent(in) :: solution
      character(:), allocatable :: lines
      type(result_t), allocatable :: results(:)

      lines = ''
      if (ieee_is_finite(solution%sigma_estimate)) then
         allocate (results, source=fit%model%describe_results(fit%base))
         lines = lines//line('standard error of a point', show_to_digits(solution%sigma_estimate, 2)//' '// &
            results(fit%data_sets(1)%ordinate)%unit//', found from the residuals of '//show_count(solution%degrees_of_freedom)// &
            ' degrees of freedom')
      else
         if (solution%degrees_of_freedom > 0) lines = lines//line('S over degrees of freedom', show_to_digits(solution%chi2, 3)// &
            ' / '//show_count(solution%degrees_of_freedom)//' = '//show_to_digits(solution%chi2/solution%degrees_of_freedom, 3))
         if (ieee_is_finite(solution%p_value)) lines = lines//line('Q, probability of a larger S', &
            show_to_digits(solution%p_value, 2))
         lines = lines//line('standard errors of points', 'as given')
      end if
      if (ieee_is_finite(solution%aic)) lines = lines//line('AIC, BIC', show_to_digits(solution%aic, 5)//', '// &
         show_to_digits(solution%bic, 5))
   end function goodness_lines

   !> Pairs of variables that are hardly told apart.
   pure function correlation_lines(fit, solution) result(lines)
      type(fit_t), intent(in) :: fit
      type(solution_t), intent(in) :: solution
      character(:), allocatable :: lines
      integer :: i, k

      lines = ''
      if (.not. allocated(solution%correlation)) return
      do i = 1, size(fit%frees)
         do k = 1, i - 1
            if (.not. ieee_is_finite(solution%correlation(k, i))) cycle
            if (abs(solution%correlation(k, i)) > large_correlation) lines = lines//line('correlation', &
               show_to_digits(solution%correlation(k, i), 3)//' of '//fit%frees(k)%name//' and '//fit%frees(i)%name)
         end do
      end do
   end function correlation_lines

   !> The other minima.
   pure function minima_lines(fit, solution) result(lines)
      type(fit_t), intent(in) :: fit
      type(solution_t), intent(in) :: solution
      character(:), allocatable :: lines
      integer :: i, k

      lines = ''
      if (.not. allocated(solution%minima_chi2)) return
      do k = 2, size(solution%minima_chi2)
         lines = lines//pad('another minimum', name_width)//'S - S_min = '// &
            show_to_digits(solution%minima_chi2(k) - solution%minima_chi2(1), 2)//':'
         do i = 1, size(fit%frees)
            if (i > 1) lines = lines//','
            lines = lines//' '//fit%frees(i)%name//' = '//show_to_digits(solution%minima(i, k), 3)
         end do
         lines = lines//newline
      end do
   end function minima_lines

   !> What the data do not see.
   pure function null_lines(fit, solution) result(lines)
      type(fit_t), intent(in) :: fit
      type(solution_t), intent(in) :: solution
      character(:), allocatable :: lines
      real(dp) :: largest
      integer :: i

      lines = ''
      if (.not. allocated(solution%null_vector)) return
      largest = maxval(abs(solution%null_vector))
      if (.not. largest > small_component) return
      lines = pad('not in the data', name_width)//'whatever changes together as'
      do i = 1, size(fit%frees)
         if (abs(solution%null_vector(i)) <= small_component*largest) cycle
         lines = lines//' '//show_to_digits(solution%null_vector(i)/largest, 3)
         if (fit%frees(i)%is_log) then
            lines = lines//' in ln '//fit%frees(i)%name
         else
            lines = lines//' in '//fit%frees(i)%name//' [scaled]'
         end if
      end do
      lines = lines//newline
   end function null_lines

   !> What helps where points lie beyond the fold: loads may have errors; at an approach without a state in contact nothing touches.
   pure function hint_beyond(fit) result(hint)
      type(fit_t), intent(in) :: fit
      character(:), allocatable :: hint

      integer :: k

      hint = ': standard errors of the abscissa (abscissa_sigma) say how far they may be'
      do k = 1, size(fit%data_sets)
         if (fit%model%variables(fit%data_sets(k)%abscissa)%name == 'approach') hint = &
            & ': free points are marked as such by a column branch or contact'
      end do
   end function hint_beyond

   !> Points that are used, left out, beyond the fold, and far from the curve.
   pure function point_lines(fit, solution) result(lines)
      type(fit_t), intent(in) :: fit
      type(solution_t), intent(in) :: solution
      character(:), allocatable :: lines
      integer :: i, n

      n = 0
      do i = 1, size(fit%data_sets)
         n = n + size(fit%data_sets(i)%x)
      end do
      lines = line('points', show_count(solution%points_used)//' used, '//show_count(n - solution%points_used)//' left out')
      n = 0
      do i = 1, size(solution%data_sets)
         if (allocated(solution%data_sets(i)%is_contact)) n = n + count(.not. solution%data_sets(i)%is_contact)
      end do
      if (n > 0) lines = lines//line('base line', show_count(n)//' points, found from the jump of the load')
      if (solution%points_beyond_fold > 0) lines = lines//line('points beyond the fold', show_count(solution%points_beyond_fold)// &
         hint_beyond(fit))
      if (solution%n_outliers == 0) return
      lines = lines//pad('residuals beyond 3', name_width)//show_count(solution%n_outliers)
      do i = 1, min(solution%n_outliers, most_listed)
         lines = lines//trim(merge(', at', ',   ', i == 1))
         if (size(fit%data_sets) > 1) lines = lines//' data '//show_count(solution%outliers(1, i))
         lines = lines//' point '//show_count(solution%outliers(2, i))
      end do
      if (solution%n_outliers > most_listed) lines = lines//', ...'
      lines = lines//newline
   end function point_lines

   !> Derived quantities.
   pure function derived_lines(solution) result(lines)
      type(solution_t), intent(in) :: solution
      character(:), allocatable :: lines
      integer :: i

      lines = ''
      if (.not. allocated(solution%derived)) return
      do i = 1, size(solution%derived)
         associate (item => solution%derived(i))
            lines = lines//pad(merge('derived', '       ', i == 1), 10)//pad(item%name, name_width - 10) &
               //show_to_error(item%value, item%error)//' +- '//show_to_digits(item%error, 2)
            if (item%unit /= '-') lines = lines//' '//item%unit
            lines = lines//newline
         end associate
      end do
   end function derived_lines

   !> Other theories.
   function theory_lines(fit, solution) result(lines)
      type(fit_t), intent(in) :: fit
      type(solution_t), intent(in) :: solution
      character(:), allocatable :: lines
      integer :: i, k

      lines = ''
      if (.not. allocated(solution%theories)) return
      do k = 1, size(solution%theories)
         associate (theory => solution%theories(k))
            lines = lines//pad('theory '//theory%name, name_width)
            if (.not. ieee_is_finite(theory%chi2)) then
               lines = lines//'does not fit these data at all'//newline
               cycle
            end if
            lines = lines//'S = '//show_to_digits(theory%chi2, 4)//', AIC '//show_more(theory%aic - solution%aic)//', BIC '// &
               show_more(theory%bic - solution%bic)//':'
            do i = 1, size(fit%frees)
               if (.not. ieee_is_finite(theory%estimate(i))) cycle
               lines = lines//' '//fit%frees(i)%name//' = '//show_to_digits(theory%estimate(i), 4)
            end do
            lines = lines//newline
            if (theory%aic - solution%aic <= worst_rival .and. has_word('jkr dmt', theory%name) .and. has_lambda(fit)) &
               lines = lines//line('', 'as good: the data give a bound of lambda alone, which is that of its set')
         end associate
      end do
   end function theory_lines

   !> Is lambda free? The theories of JKR and of DMT are the ends of its axis.
   pure logical function has_lambda(fit)
      type(fit_t), intent(in) :: fit
      integer :: i

      has_lambda = .false.
      do i = 1, size(fit%frees)
         has_lambda = has_lambda .or. fit%frees(i)%name == 'lambda'
      end do
   end function has_lambda

   !> A difference with its sign in words.
   pure function show_more(difference) result(text)
      real(dp), intent(in) :: difference
      character(:), allocatable :: text

      text = show_to_digits(abs(difference), 2)//trim(merge(' more', ' less', difference >= 0))
   end function show_more

end module adfric_command_fit_table

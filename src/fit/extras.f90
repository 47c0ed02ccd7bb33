! SPDX-License-Identifier: GPL-3.0-or-later
!> What the results file of a single fit has beside the results that every curve of a stack has.
module adfric_fit_extras
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_unset, only: is_set
   use adfric_base_words, only: count_words, get_word
   use adfric_fit_data_extras, only: get_data_extras
   use adfric_fit_extra_list, only: extra_list_t
   use adfric_fit_names, only: list_free_names
   use adfric_fit_problem, only: fit_t, event_names
   use adfric_fit_solution, only: solution_t, fit_solved
   use adfric_describe_table, only: extra_t
   implicit none (type, external)
   private
   public :: get_solution_extras

contains

   !> The datasets with their values.
   subroutine get_solution_extras(fit, solution, extras)
      type(fit_t), intent(in) :: fit
      type(solution_t), intent(in) :: solution
      type(extra_t), allocatable, intent(out) :: extras(:)
      type(extra_list_t) :: list
      character(:), allocatable :: names

      names = list_free_names(fit)
      call list%add_words('variable', 'free variables', names)
      call add_starts(fit, list)
      call add_null_vector(solution, list)
      if (solution%status == fit_solved) then
         call add_covariance(solution, names, list)
         call add_intervals(fit, solution, list)
         call add_minima(solution, list)
         call add_theories(solution, list)
         call add_profiles(solution, names, list)
      end if
      call add_events(fit, list)
      call get_data_extras(fit, solution, list)
      call list%move_to(extras)
   end subroutine get_solution_extras

   !> Where the search starts, and the bounds.
   subroutine add_starts(fit, list)
      type(fit_t), intent(in) :: fit
      type(extra_list_t), intent(inout) :: list
      integer :: i

      associate (frees => fit%frees)
         call list%add('start', '-', 'start that was given, in the unit of each variable', 'variable', &
            known([(frees(i)%start, i=1, size(frees))]))
      end associate
   end subroutine add_starts

   !> Numbers that are set, and NaN for the others.
   elemental real(dp) function known(value)
      !> A number, or `unset`.
      real(dp), intent(in) :: value

      known = not_a_number()
      if (is_set(value)) known = value
   end function known

   !> What the data do not see.
   subroutine add_null_vector(solution, list)
      type(solution_t), intent(in) :: solution
      type(extra_list_t), intent(inout) :: list

      if (.not. allocated(solution%null_vector)) return
      call list%add('null_vector', '-', 'direction in the variables as they are fitted that the data do not see; 0: they see all', &
         'variable', solution%null_vector)
   end subroutine add_null_vector

   !> Covariances and correlations.
   subroutine add_covariance(solution, names, list)
      type(solution_t), intent(in) :: solution
      !> Names of the free variables, separated by a blank.
      character(*), intent(in) :: names
      type(extra_list_t), intent(inout) :: list
      character(:), allocatable :: convention

      convention = 'from the standard errors of the points as they were given'
      if (solution%covariance_scaled) convention = 'times S/(n - p), since the standard error of the points was not known'
      call list%add_words('other_variable', 'free variables', names)
      call list%add_table('covariance', '-', 'covariance, '//convention//', in the units of both variables', &
         'variable other_variable', solution%covariance)
      call list%add_table('covariance_internal', '-', 'covariance, '//convention//', of the variables as they are fitted: ' &
         //'ln v, or v', 'variable other_variable', solution%covariance_internal)
      call list%add_table('correlation', '-', 'correlation of the variables as they are fitted', 'variable other_variable', &
         solution%correlation)
      call list%add('covariance_scaled', '-', 'was the covariance multiplied by S/(n - p)', '', &
         [merge(1.0_dp, 0.0_dp, solution%covariance_scaled)], flag_meanings='false true')
   end subroutine add_covariance

   !> Intervals as lists of pieces.
   subroutine add_intervals(fit, solution, list)
      type(fit_t), intent(in) :: fit
      type(solution_t), intent(in) :: solution
      type(extra_list_t), intent(inout) :: list

      if (.not. allocated(solution%interval)) return
      if (size(solution%interval) == 0) return
      call list%add_scale('level', '-', 'probability that an interval should hold the true value', fit%levels)
      call list%add_numbers('piece', 'piece of an interval', size(solution%interval, 2))
      call list%add_words('end', 'end of a piece', 'lower upper')
      call list%add('interval', '-', 'intervals in the unit of each variable; NaN: no such piece, or an open end', &
         'variable level piece end', reshape(solution%interval, [size(solution%interval)]))
      call list%add('interval_pieces', '-', 'number of pieces of each interval', 'variable level', &
         real(reshape(solution%interval_pieces, [size(solution%interval_pieces)]), dp))
   end subroutine add_intervals

   !> Every distinct minimum.
   subroutine add_minima(solution, list)
      type(solution_t), intent(in) :: solution
      type(extra_list_t), intent(inout) :: list

      call list%add_numbers('minimum', 'distinct minimum, the least first', size(solution%minima_chi2))
      call list%add('minima_chi2', '-', 'sum of squares S of each minimum less than 12 above the least', 'minimum', &
         solution%minima_chi2)
      call list%add('minima', '-', 'values of the variables at each minimum, in the unit of each variable', 'minimum variable', &
         reshape(solution%minima, [size(solution%minima)]))
   end subroutine add_minima

   !> The other theories.
   subroutine add_theories(solution, list)
      type(solution_t), intent(in) :: solution
      type(extra_list_t), intent(inout) :: list
      character(:), allocatable :: names
      integer :: i

      if (.not. allocated(solution%theories)) return
      if (size(solution%theories) == 0) return
      names = ''
      do i = 1, size(solution%theories)
         names = names//' '//solution%theories(i)%name
      end do
      associate (theories => solution%theories)
         call list%add_words('theory_name', 'theory that is compared', names)
         call list%add('theory_chi2', '-', 'least sum of squares S of each theory', 'theory_name', &
            [(theories(i)%chi2, i=1, size(theories))])
         call list%add('theory_aic', '-', 'criterion of Akaike of each theory', 'theory_name', &
            [(theories(i)%aic, i=1, size(theories))])
         call list%add('theory_bic', '-', 'criterion of Bayes of each theory', 'theory_name', &
            [(theories(i)%bic, i=1, size(theories))])
         call list%add('theory_estimate', '-', 'best values of each theory, in the unit of each variable', 'theory_name variable', &
            [(theories(i)%estimate, i=1, size(theories))])
      end associate
   end subroutine add_theories

   !> S as a function of each variable.
   subroutine add_profiles(solution, names, list)
      type(solution_t), intent(in) :: solution
      character(*), intent(in) :: names
      type(extra_list_t), intent(inout) :: list
      character(:), allocatable :: name
      integer :: i

      name = ''
      if (.not. allocated(solution%profiles)) return
      do i = 1, min(size(solution%profiles), count_words(names))
         if (.not. allocated(solution%profiles(i)%value)) cycle
         if (size(solution%profiles(i)%value) == 0) cycle
         name = get_word(names, i)
         call list%add_scale(name//'_profile_value', '-', 'values of '//name//' at which the others are fitted', &
            solution%profiles(i)%value)
         call list%add(name//'_profile', '-', 'S less its least value with '//name//' held, the others free', &
            name//'_profile_value', solution%profiles(i)%excess)
      end do
   end subroutine add_profiles

   !> What was measured beside the points.
   subroutine add_events(fit, list)
      type(fit_t), intent(in) :: fit
      type(extra_list_t), intent(inout) :: list
      integer :: i

      if (.not. allocated(fit%events)) return
      if (size(fit%events) == 0) return
      associate (events => fit%events)
         call list%add_numbers('event', 'measured event', size(events))
         call list%add('event_kind', '-', 'what was measured', 'event', [(real(events(i)%kind, dp), i=1, size(events))], &
            flag_meanings=event_names, first_flag=1)
         call list%add('event_data', '-', 'data set whose zeros shift the event', 'event', &
            [(real(events(i)%data_set, dp), i=1, size(events))])
         call list%add('event_value', '-', 'measured value in N or m', 'event', [(events(i)%value, i=1, size(events))])
         call list%add('event_sigma', '-', 'standard error of the measured value', 'event', &
            [(events(i)%sigma, i=1, size(events))])
      end associate
   end subroutine add_events

end module adfric_fit_extras

! SPDX-License-Identifier: GPL-3.0-or-later
!> Which points belong to a base line that no column marks, where the jump alone does not say it.
!>
!> In each pass the outermost points, m of them, are of bodies apart, with the load 0; the others are in contact. The numbers m are unknown
!> like the variables v, so the best answer has the least S over both. With v fixed, S is a sum over points, and the best m of each
!> pass is found exactly. With m fixed, v is found by a fit. Both steps in turn never raise S, and end after few.
!> The end may depend on the start, since an offset of the load can take the fold's ordinate to the base line: so such descents begin
!> at many thresholds of the abscissa. There is no contact beyond the fold: an answer that leaves points there beside a base line, or
!> as many as make one, gives way to one that has none, unless its S is less by `minima_limit` variances. Two answers whose S differ by less than `minima_limit` variances cannot be told apart. Where
!> they differ by more than their errors, or where one has no adhesion, there is no answer.
module adfric_fit_base_line_choice
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: unset
   use adfric_base_words, only: count_words, find_word
   use adfric_fit_base_line, only: wants_marks, fewest
   use adfric_fit_base_line_marks, only: choice_t, marks_t, find_marks, set_threshold
   use adfric_fit_course, only: course_t
   use adfric_fit_estimate, only: solve_best
   use adfric_fit_minima, only: minima_limit
   use adfric_fit_problem, only: fit_t, copy_fit
   use adfric_fit_solution, only: solution_t, fit_solved, fit_not_converged
   implicit none (type, external)
   private
   public :: settle_base_lines

   !> Thresholds from which marks begin, most steps of a descent, and starts of a search with marks that may not stay.
   integer, parameter :: n_thresholds = 6, most_steps = 20, few_starts = 3
   !> A lesser S is less by so many variances.
   real(dp), parameter :: same_cost = 1.0e-4_dp

contains

   !> Look for better marks where a fit says that its own are in doubt, and take the answer with the least S, if there is one.
   subroutine settle_base_lines(fit, marked, course, solution)
      type(fit_t), intent(in) :: fit
      !> In: the fit with the marks that the jump gives. Out: with those of the answer.
      type(fit_t), intent(inout) :: marked
      !> What the parts share; that of the answer.
      type(course_t), intent(inout) :: course
      !> The estimates; those of the answer.
      type(solution_t), intent(inout) :: solution
      type(choice_t) :: best, other
      type(choice_t) :: others(n_thresholds + 2)
      type(marks_t) :: marks
      logical :: wants(size(fit%data_sets))
      integer :: i, n_others

      wants = wants_marks(fit)
      if (.not. any(wants) .or. course%minima%n < 1) return
      best = choice_t(marked, course, solution)
      call find_marks(best, wants, marks)
      if (.not. marks%is_known) return
      if (solution%points_beyond_fold == 0 .and. marks%gain < minima_limit*course%variance) return
      n_others = 0
      call descend(best, wants)
      do i = 1, n_thresholds
         call copy_fit(fit, other%fit)
         call set_threshold(other%fit, wants, real(i, dp)/(n_thresholds + 1))
         other%fit%n_starts = few_starts
         call try(other, wants, others, n_others, best)
      end do
      call find_marks(best, wants, marks)
      do i = 1, 2
         if (i == 1) call copy_fit(marks%least, other%fit)
         if (i == 2) call copy_fit(marks%largest, other%fit)
         call start_at(other%fit, best%solution)
         call try(other, wants, others, n_others, best)
      end do
      call search_again(fit, best)
      call judge(fit, wants, others(:n_others), best)
      marked%data_sets = best%fit%data_sets
      course = best%course
      solution = best%solution
   end subroutine settle_base_lines

   !> Fit with other marks, and keep the answer.
   subroutine try(other, wants, others, n_others, best)
      type(choice_t), intent(inout) :: other
      !> The data sets that are marked here.
      logical, intent(in) :: wants(:)
      !> All answers and their number; this one is added.
      type(choice_t), intent(inout) :: others(:)
      integer, intent(inout) :: n_others
      type(choice_t), intent(inout) :: best

      call solve(other)
      if (other%course%minima%n < 1) return
      call descend(other, wants)
      n_others = n_others + 1
      call copy_choice(other, others(n_others))
      if (is_better(other, best)) call copy_choice(other, best)
   end subroutine try

   !> Copy an answer: once for all, since each copy of so many parts takes a compiler long.
   subroutine copy_choice(from, to)
      type(choice_t), intent(in) :: from
      type(choice_t), intent(inout) :: to

      to = from
   end subroutine copy_choice

   !> Let a search begin where another one ended.
   subroutine start_at(fit, solution)
      type(fit_t), intent(inout) :: fit
      type(solution_t), intent(in) :: solution

      fit%n_starts = 1
      fit%frees%start = solution%minima(:, 1)
   end subroutine start_at

   !> Search with the marks of an answer from all starts, if it was found from few.
   subroutine search_again(fit, best)
      type(fit_t), intent(in) :: fit
      type(choice_t), intent(inout) :: best
      type(choice_t) :: other

      if (best%fit%n_starts == fit%n_starts) return
      call copy_fit(best%fit, other%fit)
      other%fit%n_starts = fit%n_starts
      other%fit%frees = fit%frees
      call solve(other)
      call copy_fit(other%fit, best%fit)
      if (other%course%minima%n < 1) return
      if (.not. is_better(best, other)) call copy_choice(other, best)
   end subroutine search_again

   !> Say that there is no answer, where others are as good as the best one.
   subroutine judge(fit, wants, others, best)
      type(fit_t), intent(in) :: fit
      logical, intent(in) :: wants(:)
      type(choice_t), intent(in) :: others(:)
      !> The best one, whose status and reason are set.
      type(choice_t), intent(inout) :: best
      type(choice_t) :: other
      type(marks_t) :: marks
      logical :: is_other, is_known
      integer :: i

      if (best%solution%status /= fit_solved) return
      call find_marks(best, wants, marks)
      is_other = marks%gain_of_any > minima_limit*best%course%variance
      do i = 1, size(others)
         is_other = is_other .or. is_as_good(others(i), best)
      end do
      if (is_other) then
         best%solution%status = fit_not_converged
         best%solution%reason = 'the data do not tell the base line from contact: a column contact would'
      end if
      call remove_adhesion(fit, other%fit, is_known)
      if (.not. is_known) return
      call solve(other)
      if (other%solution%chi2 < best%solution%chi2 + minima_limit*variance_of(best)) then
         best%solution%status = fit_not_converged
         best%solution%reason = 'the data do not tell adhesion from none'
      end if
   end subroutine judge

   !> Has an answer a lesser S than the best one so far? Base lines left beyond the fold count as `minima_limit` variances.
   pure logical function is_better(other, best)
      type(choice_t), intent(in) :: other, best
      real(dp) :: gain

      gain = (best%solution%chi2 - other%solution%chi2)/variance_of(best)
      if (leaves_base_line(best)) gain = gain + minima_limit
      if (leaves_base_line(other)) gain = gain - minima_limit
      is_better = gain > same_cost
   end function is_better

   !> Does an answer leave a base line beyond the fold? Beside one that is marked each point there belongs to it.
   pure logical function leaves_base_line(self)
      type(choice_t), intent(in) :: self
      integer :: k, least

      least = fewest
      do k = 1, size(self%fit%data_sets)
         associate (data => self%fit%data_sets(k))
            if (.not. allocated(data%is_contact)) cycle
            if (.not. all(data%is_contact)) least = 1
         end associate
      end do
      leaves_base_line = self%solution%points_beyond_fold >= least
   end function leaves_base_line

   !> Is an answer as good as the best one, and beyond its errors?
   pure logical function is_as_good(other, best)
      type(choice_t), intent(in) :: other, best
      real(dp) :: distance(size(best%fit%frees))

      is_as_good = .false.
      if (other%course%minima%n < 1) return
      if (leaves_base_line(other) .and. .not. leaves_base_line(best)) return
      if (.not. other%solution%chi2 < best%solution%chi2 + minima_limit*variance_of(best)) return
      associate (one => best%solution%minima(:, 1), two => other%solution%minima(:, 1))
         where (best%fit%frees%is_log)
            distance = log(two) - log(one)
         elsewhere
            distance = two - one
         end where
      end associate
      is_as_good = .not. all(abs(distance) <= best%solution%error_internal)
   end function is_as_good

   !> Variance of a point in the unit of S.
   pure real(dp) function variance_of(self)
      type(choice_t), intent(in) :: self

      variance_of = self%course%variance*self%course%unit2
   end function variance_of

   !> Fit with the marks of a choice.
   subroutine solve(self)
      type(choice_t), intent(inout) :: self

      self%solution = solution_t()
      call solve_best(self%fit, self%course, self%solution)
   end subroutine solve

   !> Take the best marks at the values found, and fit again, as long as S falls.
   subroutine descend(self, wants)
      type(choice_t), intent(inout) :: self
      logical, intent(in) :: wants(:)
      type(choice_t) :: other
      type(marks_t) :: marks
      integer :: i

      do i = 1, most_steps
         call find_marks(self, wants, marks)
         if (.not. marks%gain > same_cost*self%course%variance) return
         call copy_fit(marks%best, other%fit)
         call start_at(other%fit, self%solution)
         call solve(other)
         if (.not. other%solution%chi2 < self%solution%chi2) return
         call copy_choice(other, self)
      end do
   end subroutine descend

   !> The same fit without adhesion, if adhesion is sought and the model has a theory without it.
   subroutine remove_adhesion(fit, other, is_known)
      type(fit_t), intent(in) :: fit
      type(fit_t), intent(inout) :: other
      logical, intent(out) :: is_known
      character(:), allocatable :: word
      logical :: is_adhesion(size(fit%frees))
      integer :: k, theory

      call copy_fit(fit, other)
      is_adhesion = .false.
      is_known = .false.
      theory = fit%model%solver_index_of('model', 'theory')
      if (theory == 0) return
      do k = 1, size(fit%model%variables)
         select case (fit%model%variables(k)%name)
         case ('work_of_adhesion')
            is_known = is_known .or. any(fit%frees%variable == k)
         case ('lambda', 'adhesion_stress', 'adhesion_range')
         case default
            cycle
         end select
         is_adhesion = is_adhesion .or. fit%frees%variable == k
         other%base(k) = unset
      end do
      if (.not. is_known) return
      other%frees = pack(fit%frees, .not. is_adhesion)
      do k = 1, count_words(fit%model%variables(theory)%choices)
         call find_word(fit%model%variables(theory)%choices, k, word)
         if (word == 'none' .or. word == 'hertz') other%base(theory) = k
      end do
   end subroutine remove_adhesion

end module adfric_fit_base_line_choice

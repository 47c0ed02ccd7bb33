! SPDX-License-Identifier: GPL-3.0-or-later
!> Which points belong to a base line that no column marks, where the jump alone does not say it.
!>
!> In each pass the outermost points, m of them, are of bodies apart, with the load 0; the others are in contact. The numbers m are unknown
!> like the variables v, so the best answer has the least S over both. With v fixed, S is a sum over points, and the best m of each
!> pass is found exactly. With m fixed, v is found by a fit. Both steps in turn never raise S, and end after few.
!> The end may depend on the start, since an offset of the load can take the fold's ordinate to the base line: so such descents begin
!> at many thresholds of the abscissa. There is no contact beyond the fold: an answer that leaves as many points there as make a base
!> line gives way to one that has none, unless its S is less by `minima_limit` variances. Two answers whose S differ by less than `minima_limit` variances cannot be told apart. Where
!> they differ by more than their errors, or where one has no adhesion, there is no answer.
module adfric_fit_base_line_choice
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: unset
   use adfric_base_words, only: count_words, find_word
   use adfric_fit_base_line, only: wants_marks, find_passes, fewest
   use adfric_fit_course, only: course_t
   use adfric_fit_curve, only: curve_t
   use adfric_fit_estimate, only: solve_best
   use adfric_fit_loss, only: get_loss
   use adfric_fit_minima, only: minima_limit
   use adfric_fit_objective, only: objective_t, new_objective, most_rows_of
   use adfric_fit_order, only: order_of
   use adfric_fit_problem, only: fit_t, data_set_t
   use adfric_fit_solution, only: solution_t, fit_solved, fit_not_converged
   implicit none (type, external)
   private
   public :: settle_base_lines

   !> Thresholds from which marks begin, most steps of a descent, and starts of a search with marks that may not stay.
   integer, parameter :: n_thresholds = 6, most_steps = 20, few_starts = 3
   !> A lesser S is less by so many variances.
   real(dp), parameter :: same_cost = 1.0e-4_dp

   !> Marks, and what is found with them.
   type :: choice_t
      !> The fit with its marks.
      type(fit_t) :: fit
      !> What the parts of its search share.
      type(course_t) :: course
      !> What was found.
      type(solution_t) :: solution
   end type choice_t

   !> Marks that would be better at the same values, and the least and largest base lines that are as good within `minima_limit`.
   type :: marks_t
      !> Has the model values?
      logical :: is_known = .false.
      !> What the better marks lower S by, in the unit of `course_t`.
      real(dp) :: gain = 0
      !> The same with base lines of any length.
      real(dp) :: gain_of_any = 0
      !> The same fit with these marks.
      type(fit_t) :: best, least, largest
   end type marks_t

contains

   !> Look for better marks where a fit says that its own are in doubt, and take the answer with the least S, if there is one.
   subroutine settle_base_lines(fit, marked, course, solution)
      !> The fit as it was given.
      type(fit_t), intent(in) :: fit
      !> In: the fit with the marks that the jump gives. Out: with those of the answer.
      type(fit_t), intent(inout) :: marked
      !> What the parts share; that of the answer.
      type(course_t), intent(inout) :: course
      !> The estimates; those of the answer.
      type(solution_t), intent(inout) :: solution
      type(choice_t) :: best, other
      type(choice_t), allocatable :: others(:)
      type(marks_t) :: marks
      logical :: wants(size(fit%data_sets))
      integer :: i

      wants = wants_marks(fit)
      if (.not. any(wants) .or. course%minima%n < 1) return
      best = choice_t(marked, course, solution)
      call find_marks(best, wants, marks)
      if (.not. marks%is_known) return
      if (solution%points_beyond_fold == 0 .and. marks%gain < minima_limit*course%variance) return
      allocate (others(0))
      call descend(best, wants)
      do i = 1, n_thresholds
         other%fit = fit
         call set_threshold(other%fit, wants, real(i, dp)/(n_thresholds + 1))
         other%fit%n_starts = few_starts
         call solve(other)
         if (other%course%minima%n < 1) cycle
         call descend(other, wants)
         others = [others, other]
         if (is_better(other, best)) best = other
      end do
      call search_again(fit, best)
      call judge(fit, wants, others, best)
      marked = best%fit
      course = best%course
      solution = best%solution
   end subroutine settle_base_lines

   !> Let a search begin where another one ended.
   subroutine start_at(fit, solution)
      !> The fit.
      type(fit_t), intent(inout) :: fit
      !> What the other search found.
      type(solution_t), intent(in) :: solution

      fit%n_starts = 1
      fit%frees%start = solution%minima(:, 1)
   end subroutine start_at

   !> Search with the marks of an answer from all starts, if it was found from few.
   subroutine search_again(fit, best)
      !> The fit as it was given.
      type(fit_t), intent(in) :: fit
      !> The answer.
      type(choice_t), intent(inout) :: best
      type(choice_t) :: other

      if (best%fit%n_starts == fit%n_starts) return
      other%fit = best%fit
      other%fit%n_starts = fit%n_starts
      other%fit%frees = fit%frees
      call solve(other)
      best%fit = other%fit
      if (other%course%minima%n < 1) return
      if (.not. is_better(best, other)) best = other
   end subroutine search_again

   !> Say that there is no answer, where others are as good as the best one.
   subroutine judge(fit, wants, others, best)
      !> The fit as it was given.
      type(fit_t), intent(in) :: fit
      !> The data sets that are marked here.
      logical, intent(in) :: wants(:)
      !> Other answers.
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
      do i = 1, 2
         if (is_other) exit
         other%fit = marks%least
         if (i == 2) other%fit = marks%largest
         call start_at(other%fit, best%solution)
         call solve(other)
         is_other = is_as_good(other, best)
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
      !> The answer.
      type(choice_t), intent(in) :: other
      !> The best one so far.
      type(choice_t), intent(in) :: best
      real(dp) :: gain

      gain = (best%solution%chi2 - other%solution%chi2)/variance_of(best)
      if (leaves_base_line(best)) gain = gain + minima_limit
      if (leaves_base_line(other)) gain = gain - minima_limit
      is_better = gain > same_cost
   end function is_better

   !> Does an answer leave as many points beyond the fold as make a base line?
   pure logical function leaves_base_line(self)
      !> The answer.
      type(choice_t), intent(in) :: self

      leaves_base_line = self%solution%points_beyond_fold >= fewest
   end function leaves_base_line

   !> Is an answer as good as the best one, and beyond its errors?
   pure logical function is_as_good(other, best)
      !> The answer, or none.
      type(choice_t), intent(in) :: other
      !> The best one.
      type(choice_t), intent(in) :: best
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
      !> The answer.
      type(choice_t), intent(in) :: self

      variance_of = self%course%variance*self%course%unit2
   end function variance_of

   !> Fit with the marks of a choice.
   subroutine solve(self)
      !> The choice.
      type(choice_t), intent(inout) :: self

      self%solution = solution_t()
      call solve_best(self%fit, self%course, self%solution)
   end subroutine solve

   !> Take the best marks at the values found, and fit again, as long as S falls.
   subroutine descend(self, wants)
      !> The choice.
      type(choice_t), intent(inout) :: self
      !> The data sets that are marked here.
      logical, intent(in) :: wants(:)
      type(choice_t) :: other
      type(marks_t) :: marks
      integer :: i

      do i = 1, most_steps
         call find_marks(self, wants, marks)
         if (.not. marks%gain > same_cost*self%course%variance) return
         other%fit = marks%best
         call start_at(other%fit, self%solution)
         call solve(other)
         if (.not. other%solution%chi2 < self%solution%chi2) return
         self = other
      end do
   end subroutine descend

   !> Which marks are best at the values that a choice has found.
   subroutine find_marks(self, wants, marks)
      !> The choice.
      type(choice_t), intent(in) :: self
      !> The data sets that are marked here.
      logical, intent(in) :: wants(:)
      !> Receives the marks.
      type(marks_t), intent(out) :: marks
      type(objective_t) :: contact, apart
      logical :: is_valid(2)
      integer :: k

      marks%best = self%fit
      marks%least = self%fit
      marks%largest = self%fit
      call evaluate_all(self, wants, .true., contact, is_valid(1))
      call evaluate_all(self, wants, .false., apart, is_valid(2))
      marks%is_known = all(is_valid)
      if (.not. marks%is_known) return
      do k = 1, size(wants)
         if (.not. wants(k)) cycle
         associate (at => contact%number(k))
            if (contact%is_sphere(k)) then
               call choose_marks(contact%spheres(at), apart%spheres(at), self%fit%data_sets(k), contact%loss(k), &
                  & contact%loss_width(k), self%course%variance, marks, k)
            else
               call choose_marks(contact%others(at), apart%others(at), self%fit%data_sets(k), contact%loss(k), &
                  & contact%loss_width(k), self%course%variance, marks, k)
            end if
         end associate
      end do
   end subroutine find_marks

   !> Evaluate all curves at the values of a choice as if all points that may be marked were in contact, or all but one apart.
   subroutine evaluate_all(self, wants, is_contact, objective, is_valid)
      !> The choice.
      type(choice_t), intent(in) :: self
      !> The data sets that are marked here.
      logical, intent(in) :: wants(:)
      !> Are the points in contact?
      logical, intent(in) :: is_contact
      !> Receives the curves.
      type(objective_t), intent(out) :: objective
      !> Has the model values?
      logical, intent(out) :: is_valid
      type(fit_t) :: trial
      real(dp), allocatable :: r(:), j(:, :)
      logical, allocatable :: is_used(:)
      real(dp) :: cost
      integer :: k, n

      trial = self%fit
      do k = 1, size(wants)
         if (.not. wants(k)) cycle
         associate (data => trial%data_sets(k))
            if (allocated(data%is_contact)) deallocate (data%is_contact)
            allocate (data%is_contact(size(data%x)), source=is_contact)
            is_used = ieee_is_finite(data%x)
            if (allocated(data%is_used)) is_used = is_used .and. data%is_used
            if (any(is_used)) data%is_contact(maxloc(data%x, 1, is_used)) = .true.
         end associate
      end do
      associate (scales => self%course%scales)
         call new_objective(objective, trial, scales%unit, scales%lower, scales%upper, scales%unknown_unit)
      end associate
      n = most_rows_of(objective)
      allocate (r(n), j(n, objective%n_free))
      call objective%evaluate(self%course%minima%q(:, 1), n, r, j, cost, is_valid)
   end subroutine evaluate_all

   !> Choose the marks of a curve: the best ones, and the least and largest base lines that are as good.
   subroutine choose_marks(contact, apart, data, loss, loss_width, variance, marks, number)
      !> The curve with all points in contact, and apart.
      class(curve_t), intent(in) :: contact, apart
      !> The data set with its present marks.
      type(data_set_t), intent(in) :: data
      !> Its loss, with its width.
      integer, intent(in) :: loss
      !> Width of the loss.
      real(dp), intent(in) :: loss_width
      !> Variance of a point.
      real(dp), intent(in) :: variance
      !> Receives the marks.
      type(marks_t), intent(inout) :: marks
      !> Number of the data set.
      integer, intent(in) :: number
      real(dp) :: excess(contact%n), other(contact%n), unused(contact%n), unused_too(contact%n)
      real(dp), allocatable :: sums(:)
      real(dp) :: present
      integer, allocatable :: pass(:), members(:), order(:)
      integer :: i, p, n

      call get_loss(loss, loss_width, apart%residual, excess, unused, unused_too)
      call get_loss(loss, loss_width, contact%residual, other, unused, unused_too)
      excess = excess - other
      call find_passes(data, contact%place, pass)
      do p = minval(pass), maxval(pass)
         members = pack([(i, i=1, contact%n)], pass == p)
         n = size(members)
         if (n < 1) cycle
         order = order_of(contact%x(members))
         members = members(order)
         ! what S is more by with the first i points apart; the innermost of all is in contact
         if (allocated(sums)) deallocate (sums)
         allocate (sums(0:n - 1), source=0.0_dp)
         do i = 1, n - 1
            sums(i) = sums(i - 1) + excess(members(i))
         end do
         present = 0
         if (allocated(data%is_contact)) present = sum(excess(members), .not. data%is_contact(contact%place(members)))
         marks%gain_of_any = marks%gain_of_any + present - minval(sums)
         sums(1:min(fewest, n) - 1) = huge(present)
         marks%gain = marks%gain + present - minval(sums)
         call mark_first(marks%best%data_sets(number), contact%place(members), minloc(sums, 1) - 1)
         call mark_first(marks%least%data_sets(number), contact%place(members), &
            & findloc(sums < minval(sums) + minima_limit*variance, .true., 1) - 1)
         call mark_first(marks%largest%data_sets(number), contact%place(members), &
            & findloc(sums < minval(sums) + minima_limit*variance, .true., 1, back=.true.) - 1)
      end do
   end subroutine choose_marks

   !> Mark the first points of a pass as base line, and the others as contact.
   pure subroutine mark_first(data, members, n)
      !> The data set.
      type(data_set_t), intent(inout) :: data
      !> Its points in this pass, outermost first.
      integer, intent(in) :: members(:)
      !> How many of them are the base line.
      integer, intent(in) :: n

      if (.not. allocated(data%is_contact)) allocate (data%is_contact(size(data%x)), source=.true.)
      data%is_contact(members) = .true.
      data%is_contact(members(:n)) = .false.
   end subroutine mark_first

   !> Mark a part of the points of each data set, the outermost ones, as base line.
   subroutine set_threshold(fit, wants, part)
      !> The fit.
      type(fit_t), intent(inout) :: fit
      !> The data sets that are marked here.
      logical, intent(in) :: wants(:)
      !> How large a part.
      real(dp), intent(in) :: part
      integer, allocatable :: points(:)
      integer :: i, k

      do k = 1, size(wants)
         if (.not. wants(k)) cycle
         associate (data => fit%data_sets(k))
            points = pack([(i, i=1, size(data%x))], ieee_is_finite(data%x))
            points = points(order_of(data%x(points)))
            call mark_first(data, points, nint(part*size(points)))
         end associate
      end do
   end subroutine set_threshold

   !> The same fit without adhesion, if adhesion is sought and the model has a theory without it.
   subroutine remove_adhesion(fit, other, is_known)
      !> The fit as it was given.
      type(fit_t), intent(in) :: fit
      !> Receives the fit without adhesion.
      type(fit_t), intent(out) :: other
      !> Is there one?
      logical, intent(out) :: is_known
      character(:), allocatable :: word
      logical :: is_adhesion(size(fit%frees))
      integer :: k, theory

      other = fit
      is_adhesion = .false.
      is_known = .false.
      theory = fit%model%index_of('model', 'theory')
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

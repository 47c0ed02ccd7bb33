! SPDX-License-Identifier: GPL-3.0-or-later
!> Marks of base lines: those that are best at values of the variables, and those of a threshold.
!>
!> With the variables fixed S is a sum over points. So the number of points of a base line that makes it least is found exactly, for each
!> pass by itself, from the costs of each point in contact and apart.
module adfric_fit_base_line_marks
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_fit_base_line, only: find_passes, fewest
   use adfric_fit_course, only: course_t
   use adfric_fit_curve, only: fit_curve_t
   use adfric_fit_loss, only: get_loss
   use adfric_fit_minima, only: minima_limit
   use adfric_fit_objective, only: objective_t, new_objective, most_rows_of
   use adfric_fit_order, only: order_of
   use adfric_fit_problem, only: fit_t, data_set_t, copy_fit
   use adfric_fit_solution, only: solution_t
   implicit none (type, external)
   private
   public :: choice_t, marks_t, find_marks, set_threshold

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

   !> Which marks are best at the values that a choice has found.
   subroutine find_marks(self, wants, marks)
      type(choice_t), intent(in) :: self
      !> The data sets that are marked here.
      logical, intent(in) :: wants(:)
      type(marks_t), intent(out) :: marks
      type(objective_t) :: contact, apart
      logical :: is_valid(2)
      integer :: k

      call copy_fit(self%fit, marks%best)
      call copy_fit(self%fit, marks%least)
      call copy_fit(self%fit, marks%largest)
      call evaluate_all(self, wants, .true., contact, is_valid(1))
      call evaluate_all(self, wants, .false., apart, is_valid(2))
      marks%is_known = all(is_valid)
      if (.not. marks%is_known) return
      do k = 1, size(wants)
         if (.not. wants(k)) cycle
         associate (at => contact%number(contact%first_curve(k)))
            if (contact%is_sphere(contact%first_curve(k))) then
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
      type(choice_t), intent(in) :: self
      logical, intent(in) :: wants(:), is_contact
      type(objective_t), intent(out) :: objective
      logical, intent(out) :: is_valid
      type(fit_t) :: trial
      real(dp), allocatable :: r(:), j(:, :)
      logical, allocatable :: is_used(:)
      real(dp) :: cost
      integer :: k, n

      call copy_fit(self%fit, trial)
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
      class(fit_curve_t), intent(in) :: contact, apart
      type(data_set_t), intent(in) :: data
      !> Its loss, with its width.
      integer, intent(in) :: loss
      real(dp), intent(in) :: loss_width
      !> Variance of a point.
      real(dp), intent(in) :: variance
      type(marks_t), intent(inout) :: marks
      integer, intent(in) :: number
      real(dp) :: excess(contact%n), other(contact%n), unused(contact%n), unused_too(contact%n)
      real(dp), allocatable :: sums(:)
      real(dp) :: present
      integer, allocatable :: pass(:), members(:), order(:)
      integer :: i, p, n, m, low, high

      call get_loss(loss, loss_width, apart%residual, excess, unused, unused_too)
      call get_loss(loss, loss_width, contact%residual, other, unused, unused_too)
      excess = excess - other
      call find_passes(data, contact%index, pass)
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
         if (allocated(data%is_contact)) present = sum(excess(members), .not. data%is_contact(contact%index(members)))
         marks%gain_of_any = marks%gain_of_any + present - minval(sums)
         sums(1:min(fewest, n) - 1) = huge(present)
         marks%gain = marks%gain + present - minval(sums)
         m = minloc(sums, 1) - 1
         call mark_first(marks%best%data_sets(number), contact%index(members), m)
         ! the next point may be as good after a fit: at the fold a curve is steep
         low = min(m - 1, findloc(sums < minval(sums) + minima_limit*variance, .true., 1) - 1)
         if (low < fewest) low = min(m, fewest)
         high = max(m + 1, findloc(sums < minval(sums) + minima_limit*variance, .true., 1, back=.true.) - 1)
         if (m == 0) high = max(high, fewest)
         call mark_first(marks%least%data_sets(number), contact%index(members), low)
         call mark_first(marks%largest%data_sets(number), contact%index(members), min(high, n - 1))
      end do
   end subroutine choose_marks

   !> Mark the first points of a pass as base line, and the others as contact.
   pure subroutine mark_first(data, members, n)
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
      type(fit_t), intent(inout) :: fit
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

end module adfric_fit_base_line_marks

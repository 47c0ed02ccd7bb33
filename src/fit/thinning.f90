! SPDX-License-Identifier: GPL-3.0-or-later
!> The search for the minima of a fit with very many points: first with some of them, then from the minima found with all.
!>
!> The sum of squares of every m-th point, times m, is that of all points within their noise. So a minimum of all points that counts lies
!> near one of the few that would count, and the costly searches from afar need few points. All points have the last word.
module adfric_fit_thinning
   use adfric_base_kinds, only: dp
   use adfric_fit_course, only: course_t, begin_course, has_too_few_points
   use adfric_fit_fold_survey, only: survey_folds
   use adfric_fit_minima, only: new_minima, add_search, sort_minima, minima_limit
   use adfric_fit_parts, only: take_part
   use adfric_fit_problem, only: fit_t
   use adfric_fit_search, only: find_minima
   implicit none (type, external)
   private
   public :: search_minima

   !> Data sets of more points are thinned, to about so many.
   integer, parameter :: many_points = 8000, few_points = 1500

contains

   !> Find all minima of a fit.
   subroutine search_minima(course, fit)
      !> The sum of squares with its scales; receives the minima.
      type(course_t), intent(inout) :: course
      type(fit_t), intent(in) :: fit
      type(course_t) :: other
      type(fit_t) :: few
      real(dp) :: q(size(fit%frees)), variance
      integer :: k

      if (course%n_points > many_points) then
         call thin_out(fit, few)
         call begin_course(other, few)
         if (.not. has_too_few_points(other, few)) then
            call find_minima(other%searched_t, few, other%minima)
            call new_minima(course%minima, size(q))
            variance = 1
            if (other%limits%freedom > 0 .and. other%minima%n > 0) variance = other%minima%cost(1)/other%limits%freedom
            do k = 1, other%minima%n
               if (other%minima%cost(k) > other%minima%cost(1) + minima_limit*variance) exit
               ! one number may have another unit where the largest values are left out
               q = other%minima%q(:, k)*other%scales%unit/course%scales%unit
               call add_search(course%searched_t, q, course%minima)
            end do
            course%minima%searches = course%minima%searches + other%minima%searches
            course%minima%steps = course%minima%steps + other%minima%steps
            call survey_folds(course%searched_t, course%minima)
            call sort_minima(course%minima, size(q))
            if (course%minima%n > 0) return
         end if
      end if
      call find_minima(course%searched_t, fit, course%minima)
   end subroutine search_minima

   !> The same fit with every m-th of the points of each data set.
   subroutine thin_out(fit, few)
      type(fit_t), intent(in) :: fit
      !> Receives the fit with fewer points.
      type(fit_t), intent(out) :: few
      integer, allocatable :: kept(:)
      integer :: i, k, m

      few = fit
      do k = 1, size(fit%data_sets)
         associate (from => fit%data_sets(k), to => few%data_sets(k))
            m = max(1, size(from%x)/few_points)
            kept = [(i, i=1 + (m - 1)/2, size(from%x), m)]
            call take_part(from, kept, to)
         end associate
      end do
   end subroutine thin_out

end module adfric_fit_thinning

! SPDX-License-Identifier: GPL-3.0-or-later
!> How many points a run has: reckoned before any value is made, so that what is too large is refused at once.
module adfric_input_sweep_size
   use adfric_base_kinds, only: dp, i8
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: show_count
   use adfric_input_group_values, only: take_count
   use adfric_input_namelist_file, only: namelist_file_t
   use adfric_input_number_list, only: most_values
   use adfric_run_plan, only: plan_t
   use adfric_run_refinement, only: refinement_t
   use adfric_input_reading, only: reading_t
   implicit none (type, external)
   private
   public :: check_counts, find_size_problem, say_above_limit

   !> Largest number of points: up to it a real number counts exactly.
   real(dp), parameter :: most_points = 2.0_dp**53

contains

   !> Check the counts of ranges and samples. A list, a table and a dataset have one value at least.
   subroutine check_counts(r)
      type(reading_t), intent(in) :: r
      type(refinement_t) :: refinement
      type(problems_t), target :: unused
      type(reading_t) :: aside
      character(:), allocatable :: text
      integer(i8), allocatable :: lengths(:)
      integer(i8) :: length
      integer :: i, group

      aside = r
      aside%problems => unused
      allocate (lengths(0))
      do i = 1, size(r%file%groups)
         if (.not. has_count(r%file, i)) cycle
         length = 1
         call take_count(aside, i, 'count', 1, most_values, length)
         lengths = [lengths, length]
      end do
      text = say_too_many(lengths)
      if (len(text) > 0) call r%problems%add('sweep', '', text)
      group = r%file%find_group('refine')
      if (group == 0 .or. size(lengths) /= 1 .or. len(text) > 0) return
      call take_count(aside, group, 'limit', 3, most_values, refinement%limit)
      if (lengths(1) > refinement%limit) call r%report(group, 'limit', &
         say_above_limit(lengths(1), refinement%limit))
   end subroutine check_counts

   !> Does a group make an axis with a count of its own?
   pure logical function has_count(file, group)
      type(namelist_file_t), intent(in) :: file
      integer, intent(in) :: group

      has_count = file%groups(group)%name == 'sweep' .or. file%groups(group)%name == 'sample'
      if (has_count) has_count = file%find_assignment(group, 'count') > 0 .and. file%find_assignment(group, 'with') == 0 &
         .and. file%find_assignment(group, 'values') == 0
   end function has_count

   !> Is the number of points beyond all counting? Empty if it is not.
   pure function find_size_problem(plan) result(text)
      !> The run, of which the sizes of the axes count.
      type(plan_t), intent(in) :: plan
      character(:), allocatable :: text

      text = say_too_many(plan%shape())
   end function find_size_problem

   !> What to say of a product that is beyond all counting; empty if it is not.
   pure function say_too_many(lengths) result(text)
      !> Number of values of each axis.
      integer(i8), intent(in) :: lengths(:)
      character(:), allocatable :: text, counts
      real(dp) :: n_points
      integer :: k

      text = ''
      counts = ''
      n_points = 1
      do k = 1, size(lengths)
         n_points = min(n_points*real(lengths(k), dp), 2*most_points)
         if (k > 1) counts = counts//' x '
         counts = counts//show_count(lengths(k))
      end do
      if (n_points > most_points) text = 'the sweep has too many points, given '//counts// &
         ', allowed: 2**53 points in all'
   end function say_too_many

   !> What to say of a refined sweep that begins with more values than it may have.
   pure function say_above_limit(n_values, limit) result(text)
      !> Values of the sweep.
      integer(i8), intent(in) :: n_values
      !> Values that the refined sweep may have.
      integer(i8), intent(in) :: limit
      character(:), allocatable :: text

      text = 'the sweep begins with more values than the refined one may have, given '//show_count(limit)//' for '// &
         show_count(n_values)//' values, allowed: a larger limit, or a sweep of fewer values'
   end function say_above_limit

end module adfric_input_sweep_size

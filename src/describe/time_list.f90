! SPDX-License-Identifier: GPL-3.0-or-later
!> What a list of times, and one of what is prescribed at them, may not say.
module adfric_describe_time_list
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: show_count, show_number
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: check_length, check_times

contains

   !> Add to `problems` that a list has not as many values as the times.
   subroutine check_length(row, n_values, n_times, problems)
      !> Row of what is prescribed.
      type(variable_t), intent(in) :: row
      !> Values of the list, and times.
      integer, intent(in) :: n_values, n_times
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      if (n_values /= n_times) call problems%add(row%group, row%name, 'has '//show_count(n_values)//' values, and times has ' &
         & //show_count(n_times))
   end subroutine check_length

   !> Add to `problems` that times fall, or are all equal.
   subroutine check_times(times, problems)
      !> The times [s]; at least one.
      real(dp), intent(in) :: times(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: k

      do k = 2, size(times)
         if (times(k) >= times(k - 1)) cycle
         call problems%add('history', 'times', 'falls from '//show_number(times(k - 1))//' s to '//show_number(times(k)) &
            & //' s at value '//show_count(k)//'; times rise, or are equal where there is a jump')
         return
      end do
      if (.not. times(size(times)) > times(1)) call problems%add('history', 'times', 'are all equal')
   end subroutine check_times

end module adfric_describe_time_list

! SPDX-License-Identifier: GPL-3.0-or-later
!> The work of adhesion that round contacts need, and what a message says where its stress or range stands alone.
module adfric_round_work_check
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_describe_check, only: require
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: require_work

contains

   !> Add to `problems` that the work of adhesion is missing, and which variable needs it.
   subroutine require_work(variables, values, work, others, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      !> Index of the work of adhesion, and those of stress and range.
      integer, intent(in) :: work, others(2)
      type(problems_t), intent(inout) :: problems
      integer :: k

      k = findloc(is_set(values(others)), .true., 1)
      if (k == 0 .or. is_set(values(work))) then
         call require(variables, values, [work], problems)
      else
         call problems%add(variables(work)%group, variables(work)%name, &
            & 'is missing ['//variables(work)%unit//']; '//variables(others(k))%name//' needs it')
      end if
   end subroutine require_work

end module adfric_round_work_check

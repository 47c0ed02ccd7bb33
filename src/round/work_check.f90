! SPDX-License-Identifier: GPL-3.0-or-later
!> The work of adhesion that round contacts need, and what a message says where its stress or range stands alone.
module adfric_round_work_check
   use adfric_base_unset, only: is_set
   use adfric_describe_check, only: checks_t
   implicit none (type, external)
   private
   public :: require_work

contains

   !> Add that the work of adhesion is missing, and which variable needs it.
   subroutine require_work(c, work, others)
      type(checks_t), intent(in) :: c
      !> Index of the work of adhesion, and those of stress and range.
      integer, intent(in) :: work, others(2)
      integer :: k

      k = findloc(is_set(c%values(others)), .true., 1)
      if (k == 0 .or. c%has(work)) then
         call c%need([work])
      else
         call c%add(work, 'is missing ['//c%variables(work)%unit//']; '//c%variables(others(k))%name//' needs it')
      end if
   end subroutine require_work

end module adfric_round_work_check

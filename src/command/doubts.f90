! SPDX-License-Identifier: GPL-3.0-or-later
!> What the user of a run may not mean, at its first point or where a sweep ends.
module adfric_command_doubts
   use adfric_base_kinds, only: dp
   use adfric_base_text, only: show_number
   use adfric_run_run, only: run_t
   implicit none (type, external)
   private
   public :: describe_doubts_of

contains

   !> Doubts of the first point; if there are none, those of the other end of the first sweep that has some there, and where that
   !> is.
   function describe_doubts_of(run) result(text)
      !> The run, whose model is prepared.
      class(run_t), intent(in) :: run
      character(:), allocatable :: text
      real(dp), allocatable :: values(:)
      integer :: k, last

      text = run%model%describe_doubts(run%plan%base)
      do k = 1, size(run%plan%axes)
         if (len(text) > 0) return
         associate (axis => run%plan%axes(k))
            last = size(axis%values, 2)
            allocate (values, source=run%plan%base)
            values(axis%variables) = axis%values(:, last)
            text = run%model%describe_doubts(values)
            deallocate (values)
            if (len(text) > 0) text = 'at '//run%model%variables(axis%variables(1))%name//' = ' &
               & //show_number(axis%values(1, last))//': '//text
         end associate
      end do
   end function describe_doubts_of

end module adfric_command_doubts

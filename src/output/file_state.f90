! SPDX-License-Identifier: GPL-3.0-or-later
!> The states in the life of a results file; which step leads from one to the other is drawn in `results_file.f90`.
module adfric_output_file_state
   use adfric_base_error, only: error_t, set_error, file_failure
   use adfric_base_words, only: get_word
   implicit none (type, external)
   private
   public :: is_idle, is_begun, is_open, is_closed, is_shared, check_state

   !> There is no run at work on the file; it has begun, and there is no file yet; this process alone writes it; the file is closed
   !> in this process, for several to write it; they do.
   integer, parameter :: is_idle = 1, is_begun = 2, is_open = 3, is_closed = 4, is_shared = 5
   !> Names of the states, in their order.
   character(*), parameter :: state_names = 'idle begun open closed shared'

contains

   !> Find a mistake of the program: a step that does not go out from the state in which the file is.
   pure subroutine check_state(state, allowed, step, error)
      !> State of the file, one of `is_...`.
      integer, intent(in) :: state
      !> States from which the step goes out.
      integer, intent(in) :: allowed(:)
      character(*), intent(in) :: step
      !> Allocated if the step is not allowed.
      type(error_t), allocatable, intent(out) :: error

      if (any(allowed == state)) return
      call set_error(error, file_failure, 'a mistake in adfric: '//step//' of a results file that is ' &
         //get_word(state_names, state))
   end subroutine check_state

end module adfric_output_file_state

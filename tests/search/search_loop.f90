! SPDX-License-Identifier: GPL-3.0-or-later
!> The search itself: draw, solve, judge, and say what breaks.
module search_loop
   use, intrinsic :: iso_fortran_env, only: error_unit
   use adfric, only: new_model
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp
   use adfric_describe_model, only: model_t
   use adfric_describe_status, only: n_status
   use adfric_system_clock, only: wall_clock
   use random_dice, only: dice_t, new_dice
   use search_draw, only: drawn_case_t, draw_case
   use search_rules, only: answer_t, answer_case, find_fault
   use search_text, only: input_of
   use search_watch, only: watch, stop_watch
   implicit none (type, external)
   private
   public :: search_t, search_model

   !> What a search has found.
   type :: search_t
      !> Cases that were drawn, and those that break a rule.
      integer :: n_cases = 0, n_faults = 0
      !> Points by status.
      integer :: by_status(0:n_status - 1) = 0
      !> Time of the solver, and of its slowest case per point [s].
      real(dp) :: seconds = 0, slowest = 0
      !> The slowest case as an input.
      character(:), allocatable :: slowest_input
   end type search_t

contains

   !> Search a model. The same seed gives the same cases.
   subroutine search_model(name, seed, n_cases, seconds, longest, search)
      character(*), intent(in) :: name
      integer, intent(in) :: seed
      !> The search ends after so many cases, or so much time.
      integer, intent(in) :: n_cases
      real(dp), intent(in) :: seconds
      !> A case that takes longer ends the program [s].
      integer, intent(in) :: longest
      type(search_t), intent(out) :: search
      class(model_t), allocatable :: model
      type(error_t), allocatable :: error
      type(dice_t) :: dice
      type(drawn_case_t) :: drawn
      character(:), allocatable :: fault
      real(dp) :: start
      logical :: is_drawn
      integer :: k

      call new_model(model, name, error)
      if (allocated(error)) error stop 'search_loop: no such model'
      call new_dice(dice, seed)
      search%slowest_input = ''
      start = wall_clock()
      do k = 1, n_cases
         if (wall_clock() - start > seconds) exit
         call draw_case(model, dice, drawn, is_drawn)
         if (.not. is_drawn) cycle
         search%n_cases = search%n_cases + 1
         call watch(input_of(model, drawn), longest)
         call solve_case(model, drawn, dice, search, fault)
         call stop_watch()
         if (len(fault) == 0) cycle
         search%n_faults = search%n_faults + 1
         write (error_unit, '(a)') '! '//fault//new_line('a')//input_of(model, drawn)
      end do
   end subroutine search_model

   !> Solve and judge a case.
   subroutine solve_case(model, drawn, dice, search, fault)
      class(model_t), intent(in) :: model
      type(drawn_case_t), intent(in) :: drawn
      type(dice_t), intent(inout) :: dice
      type(search_t), intent(inout) :: search
      character(:), allocatable, intent(out) :: fault
      type(answer_t) :: answer
      real(dp) :: start, per_point
      integer :: k

      start = wall_clock()
      call answer_case(model, drawn, answer)
      per_point = (wall_clock() - start)/size(answer%status)
      search%seconds = search%seconds + per_point*size(answer%status)
      if (per_point > search%slowest) then
         search%slowest = per_point
         search%slowest_input = input_of(model, drawn)
      end if
      do k = 0, n_status - 1
         search%by_status(k) = search%by_status(k) + count(answer%status == k)
      end do
      call find_fault(model, drawn, answer, dice, fault)
   end subroutine solve_case

end module search_loop

! SPDX-License-Identifier: GPL-3.0-or-later
!> The histories of a fit over time: that of the scene, or one of each `&data`, whose further variable is a list of the group
!> `history`: what the instrument prescribed at the time of each point.
module adfric_input_fit_history
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: show_count, show_number
   use adfric_base_unset, only: is_set
   use adfric_fit_problem, only: data_set_t, free_t
   use adfric_input_fit_data_group, only: data_group_t, is_history
   use adfric_input_given_list, only: keep_numbers
   use adfric_input_reading, only: reading_t
   use adfric_describe_model, only: model_t
   use adfric_describe_of_fits, only: is_abscissa_of_fits
   use adfric_run_listed_model, only: let_lists_vary, list_with_members_t, own_history_t
   implicit none (type, external)
   private
   public :: stack_history_t, hold_histories, take_histories, prescribe_curve, let_vary, n_others

   !> Where the curves of a stack over time have their histories from; nothing for other stacks.
   type :: stack_history_t
      !> Which further variable of the `&data` is that of each curve; 0: none.
      integer :: column = 0
      !> Positions of the times and of what is prescribed in the table of the model, where each curve has its own; else 0.
      integer :: lists(2) = 0
      !> The history of the scene, where it is that of all curves; else without numbers.
      type(own_history_t) :: scene
   end type stack_history_t

contains

   !> Which further variable of a `&data` is its history; 0: none.
   pure integer function history_of(model, group) result(k)
      class(model_t), intent(in) :: model
      type(data_group_t), intent(in) :: group

      do k = size(group%data_set%others), 1, -1
         if (is_history(model%variables(group%data_set%others(k)))) return
      end do
   end function history_of

   !> Further variables of a `&data` that are no history.
   pure integer function n_others(model, group)
      class(model_t), intent(in) :: model
      !> The `&data` group.
      type(data_group_t), intent(in) :: group

      n_others = size(group%data_set%others) - merge(1, 0, history_of(model, group) > 0)
   end function n_others

   !> Have the model check its values with some history where each `&data` has its own; report what does not go together.
   subroutine hold_histories(r, groups)
      type(reading_t), intent(in) :: r
      !> The `&data` groups.
      type(data_group_t), intent(in) :: groups(:)
      type(problems_t) :: unused
      integer :: g, k, times, list
      logical :: is_time

      times = r%model%index_of('history', 'times')
      list = 0
      do g = 1, size(groups)
         if (groups(g)%data_set%abscissa == 0) return
         k = history_of(r%model, groups(g))
         is_time = is_abscissa_of_fits(r%model%variables(groups(g)%data_set%abscissa))
         if (k == 0) then
            if (list > 0) call groups(g)%reader%report(r, 'variables', 'has no history, and another &data has one of its own, '// &
               'needed: one of each')
            cycle
         end if
         if (list == 0 .and. g > 1) call groups(g)%reader%report(r, 'variables', 'has a history of its own, and another &data '// &
            'has none, needed: one of each')
         if (.not. is_time) call groups(g)%reader%report(r, 'variables', 'has a history, and the abscissa is no time, needed: '// &
            'abscissa = ''time''')
         if (list > 0 .and. list /= groups(g)%data_set%others(k)) call groups(g)%reader%report(r, 'variables', &
            'prescribes something else than another &data, allowed: the same list of all')
         list = groups(g)%data_set%others(k)
         if (times == 0) cycle
         if (r%input%is_given(times)) call groups(g)%reader%report(r, 'variables', 'has a history, and &history has times, '// &
            'allowed: one of them')
      end do
      if (list == 0 .or. times == 0) return
      if (r%input%is_given(times)) return
      r%input%values([times, list]) = 1
      call r%model%take_dataset(times, reshape([0.0_dp, 1.0_dp], [2, 1]), unused)
      call r%model%take_dataset(list, reshape([0.0_dp, 1.0_dp], [2, 1]), unused)
   end subroutine hold_histories

   !> Take the histories off the further variables, and say what is prescribed at the points. The curves of a stack are read later: what
   !> `of_stack` has stays for them.
   subroutine take_histories(r, groups, data_sets, is_stack, histories, of_stack)
      type(reading_t), intent(in) :: r
      !> The `&data` groups.
      type(data_group_t), intent(in) :: groups(:)
      !> Their points.
      type(data_set_t), intent(inout) :: data_sets(:)
      !> Is it a stack of curves, whose points are not known yet?
      logical, intent(in) :: is_stack
      !> Receives the histories.
      type(own_history_t), allocatable, intent(out) :: histories(:)
      !> Receives where the curves of a stack have theirs from.
      type(stack_history_t), intent(out) :: of_stack
      integer, allocatable :: left(:)
      logical, allocatable :: is_there(:)
      integer :: g, k, i

      allocate (histories(size(groups)))
      do g = 1, size(groups)
         if (.not. is_abscissa_of_fits(r%model%variables(groups(g)%data_set%abscissa))) cycle
         k = history_of(r%model, groups(g))
         if (is_stack) then
            if (size(groups) > 1) call groups(g)%reader%report(r, 'file', 'is one of several stacks of curves over time, '// &
               'allowed: one &data')
            of_stack%column = k
            if (k > 0) of_stack%lists = [r%model%index_of('history', 'times'), data_sets(g)%others(k)]
            if (k == 0) call find_scene_history(r, of_stack%scene)
            data_sets(g)%others = [integer ::]
            return
         end if
         if (k == 0) then
            call find_scene_history(r, of_stack%scene)
            call prescribe(of_stack%scene, data_sets(g))
            cycle
         end if
         associate (set => data_sets(g))
            set%prescribed = set%at(k, :)
            is_there = ieee_is_finite(set%x) .and. ieee_is_finite(set%prescribed)
            histories(g)%variable = set%others(k)
            histories(g)%times = pack(set%x, is_there)
            histories(g)%prescribed = pack(set%prescribed, is_there)
            left = pack([(i, i=1, size(set%others))], [(i, i=1, size(set%others))] /= k)
            set%others = set%others(left)
            set%at = set%at(left, :)
            ! as of a data set that has none
            if (size(left) == 0) deallocate (set%at)
            call check_times(r, groups(g), histories(g))
            if (g == 1) call show_history(r, histories(g))
         end associate
      end do
   end subroutine take_histories

   !> The history of the first `&data` stands for all in what is shown and written of the scene.
   subroutine show_history(r, history)
      type(reading_t), intent(in) :: r
      type(own_history_t), intent(in) :: history
      character(:), allocatable :: flaw
      integer :: times

      times = r%model%index_of('history', 'times')
      call keep_numbers(history%times, r%model%variables(times), r%input%datasets(times), flaw)
      if (len(flaw) == 0) call keep_numbers(history%prescribed, r%model%variables(history%variable), &
         r%input%datasets(history%variable), flaw)
      if (len(flaw) == 0) r%input%is_given([times, history%variable]) = .true.
   end subroutine show_history

   !> Report times that fall, and a history that never presses.
   subroutine check_times(r, group, history)
      type(reading_t), intent(in) :: r
      type(data_group_t), intent(in) :: group
      type(own_history_t), intent(in) :: history
      integer :: k

      if (size(history%times) < 2) then
         call group%reader%report(r, 'file', 'has a history of '//show_count(size(history%times))//' points, needed: two')
         return
      end if
      do k = 2, size(history%times)
         if (history%times(k) >= history%times(k - 1)) cycle
         call group%reader%report(r, 'file', group%file//': the time falls from '//show_number(history%times(k - 1))//' s to '// &
            show_number(history%times(k))//' s, needed: times that rise')
         return
      end do
   end subroutine check_times

   !> The history of the scene, as far as a fit needs it for units and starts: of a path with a name its largest value.
   subroutine find_scene_history(r, history)
      type(reading_t), intent(in) :: r
      !> Receives the history.
      type(own_history_t), intent(out) :: history
      character(*), parameter :: lists(3) = [character(15) :: 'approaches', 'base_approaches', 'loads']
      character(*), parameter :: numbers(3) = [character(21) :: 'largest_approach', 'largest_base_approach', 'largest_load']
      integer :: times, k, i

      times = r%model%index_of('history', 'times')
      history%times = [0.0_dp, 1.0_dp]
      history%prescribed = [0.0_dp, 0.0_dp]
      do k = 1, size(lists)
         i = r%model%index_of('history', trim(numbers(k)))
         if (is_set(r%input%values(i))) history%prescribed(:) = r%input%values(i)
         i = r%model%index_of('history', trim(lists(k)))
         if (.not. (allocated(r%input%datasets(i)%numbers) .and. allocated(r%input%datasets(times)%numbers))) cycle
         if (size(r%input%datasets(i)%numbers) /= size(r%input%datasets(times)%numbers)) cycle
         history%times = r%input%datasets(times)%numbers
         history%prescribed = r%input%datasets(i)%numbers
         return
      end do
   end subroutine find_scene_history

   !> What a history prescribes at the points.
   pure subroutine prescribe(history, set)
      !> The history.
      type(own_history_t), intent(in) :: history
      !> The points; receives what is prescribed.
      type(data_set_t), intent(inout) :: set
      integer :: i, at

      if (allocated(set%prescribed)) deallocate (set%prescribed)
      allocate (set%prescribed(size(set%x)), source=0.0_dp)
      associate (t => history%times, z => history%prescribed)
         do i = 1, size(set%x)
            if (.not. ieee_is_finite(set%x(i))) cycle
            at = min(max(count(t <= set%x(i)), 1), size(t) - 1)
            set%prescribed(i) = z(at)
            if (t(at + 1) > t(at)) set%prescribed(i) = z(at) + (z(at + 1) - z(at))*(set%x(i) - t(at))/(t(at + 1) - t(at))
         end do
      end associate
   end subroutine prescribe

   !> What is prescribed at the points of a curve of a stack: a column of its own, or the history of the scene.
   pure subroutine prescribe_curve(history, set)
      !> Where its history is from.
      type(stack_history_t), intent(in) :: history
      !> The points, with the columns of further variables; these become what is prescribed.
      type(data_set_t), intent(inout) :: set

      if (history%column > 0) then
         set%prescribed = set%at(history%column, :)
         deallocate (set%at)
      else if (allocated(history%scene%times)) then
         call prescribe(history%scene, set)
      end if
   end subroutine prescribe_curve

   !> Let lists with free members, and histories, vary from point to point.
   subroutine let_vary(r, histories, frees, model)
      type(reading_t), intent(in) :: r
      !> The histories.
      type(own_history_t), intent(in) :: histories(:)
      !> The free variables; members of lists receive the index of their variable.
      type(free_t), intent(inout) :: frees(:)
      !> In: the model. Out: a model whose lists vary, if any do.
      class(model_t), allocatable, intent(inout) :: model
      type(list_with_members_t), allocatable :: lists(:)
      integer, allocatable :: of(:)
      integer :: i, k, n

      if (.not. any(frees%list > 0) .and. .not. any([(allocated(histories(k)%times), k=1, size(histories))])) return
      allocate (lists(count(frees%list > 0)))
      n = 0
      do i = 1, size(frees)
         if (frees(i)%list == 0 .or. any(frees(:i - 1)%list == frees(i)%list)) cycle
         n = n + 1
         of = pack([(k, k=1, size(frees))], frees%list == frees(i)%list)
         lists(n)%variable = frees(i)%list
         lists(n)%members = frees(of)%member
         lists(n)%numbers = r%input%datasets(frees(i)%list)%numbers
      end do
      lists = lists(:n)
      call let_lists_vary(model, lists, histories)
      do i = 1, n
         do k = 1, size(lists(i)%members)
            where (frees%list == lists(i)%variable .and. frees%member == lists(i)%members(k)) frees%variable = lists(i)%slots(k)
         end do
      end do
   end subroutine let_vary

end module adfric_input_fit_history

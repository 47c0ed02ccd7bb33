! SPDX-License-Identifier: GPL-3.0-or-later
!> `&event` and `&fit`: what was measured beside the points, and how the fit is made.
module adfric_input_fit_settings
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: join_words, show_count, show_text
   use adfric_base_unset, only: is_set
   use adfric_base_words, only: count_words, get_word, has_word
   use adfric_fit_problem, only: event_t, fit_t
   use adfric_input_case, only: case_t
   use adfric_input_fit_data_group, only: data_group_t
   use adfric_input_fit_values, only: reader_t, new_reader
   use adfric_input_namelist_file, only: namelist_file_t
   use adfric_input_suggestion, only: did_you_mean
   use adfric_describe_model, only: model_t
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: read_events, read_settings

   !> Levels of intervals where none are given.
   real(dp), parameter :: usual_levels(*) = [0.6827_dp, 0.95_dp]
   !> Index of the word `together`.
   integer, parameter :: curves_together = 2

contains

   !> Read every `&event`.
   subroutine read_events(file, rows, groups, events, problems)
      type(namelist_file_t), intent(in) :: file
      type(variable_t), intent(in) :: rows(:)
      !> The `&data` groups.
      type(data_group_t), intent(in) :: groups(:)
      type(event_t), allocatable, intent(out) :: events(:)
      type(problems_t), intent(inout) :: problems
      type(reader_t) :: reader
      real(dp) :: kind
      integer :: i, n

      allocate (events(count(file%groups%name == 'event')))
      n = 0
      do i = 1, size(file%groups)
         if (file%groups(i)%name /= 'event') cycle
         if (problems%is_enough()) exit
         n = n + 1
         associate (event => events(n))
            call new_reader(reader, file, i, rows, problems)
            call reader%read_whole(file, 'data', event%data_set, problems)
            if (event%data_set > size(groups)) then
               call reader%report(file, 'data', 'no &data of this number, given '//show_count(event%data_set)// &
                  ', allowed: 1 to '//show_count(size(groups)), problems)
               event%data_set = 1
            end if
            call reader%read_number(file, 'kind', kind, problems)
            if (is_set(kind)) event%kind = nint(kind)
            call reader%read_number(file, 'value', event%value, problems)
            call reader%read_number(file, 'sigma', event%sigma, problems)
            call reader%report_missing(file, 'kind', problems)
            call reader%report_missing(file, 'value', problems)
            call reader%report_missing(file, 'sigma', problems)
         end associate
      end do
      events = events(:n)
   end subroutine read_events

   !> Read `&fit`, which may be absent.
   subroutine read_settings(file, rows, model, input, fit, is_together, problems)
      type(namelist_file_t), intent(in) :: file
      type(variable_t), intent(in) :: rows(:)
      class(model_t), intent(in) :: model
      type(case_t), intent(in) :: input
      type(fit_t), intent(inout) :: fit
      !> Are the curves of a stack fitted together?
      logical, intent(out) :: is_together
      type(problems_t), intent(inout) :: problems
      type(reader_t) :: reader
      integer :: curves, group

      fit%levels = usual_levels
      fit%derived = ''
      allocate (fit%theories(0))
      is_together = .false.
      group = file%find_group('fit')
      if (group == 0) return
      call new_reader(reader, file, group, rows, problems)
      call reader%read_whole(file, 'intervals', fit%intervals, problems)
      call reader%read_numbers(file, 'levels', fit%levels, problems)
      call reader%read_whole(file, 'starts', fit%n_starts, problems)
      call reader%read_whole(file, 'curves', curves, problems)
      call reader%read_number(file, 'relative_tolerance', fit%relative_tolerance, problems)
      call reader%read_whole(file, 'refits', fit%n_bootstrap, problems)
      call reader%read_whole(file, 'seed', fit%seed, problems)
      call read_theories(file, reader, model, input, fit, problems)
      call reader%read_texts(file, 'derived', fit%derived, problems)
      is_together = curves == curves_together
   end subroutine read_settings

   !> Read the theories that are compared.
   subroutine read_theories(file, reader, model, input, fit, problems)
      type(namelist_file_t), intent(in) :: file
      !> The group `&fit`.
      type(reader_t), intent(in) :: reader
      class(model_t), intent(in) :: model
      type(case_t), intent(in) :: input
      type(fit_t), intent(inout) :: fit
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: words, known
      integer :: i, k, index

      call reader%read_texts(file, 'theories', words, problems)
      if (len(words) == 0) return
      index = model%solver_index_of('model', 'theory')
      if (index == 0) then
         call reader%report(file, 'theories', 'the model '''//model%name//''' has no theories', problems)
         return
      end if
      known = model%variables(index)%choices
      do i = 1, count_words(words)
         if (.not. has_word(known, get_word(words, i)) .or. get_word(words, i) == 'auto') then
            call reader%report(file, 'theories', 'unknown theory, given '''//show_text(get_word(words, i))//''', allowed: '''// &
               join_words(trim(adjustl(without_auto(known))), ''', ''')//''''//did_you_mean(get_word(words, i), known), problems)
            cycle
         end if
         do k = 1, count_words(known)
            if (get_word(known, k) /= get_word(words, i)) cycle
            if (k /= nint(input%values(index))) fit%theories = [fit%theories, k]
         end do
      end do
   end subroutine read_theories

   !> Words without `auto`, which is no theory.
   pure function without_auto(words) result(others)
      !> Words, separated by a blank.
      character(*), intent(in) :: words
      character(:), allocatable :: others
      integer :: k

      others = ''
      do k = 1, count_words(words)
         if (get_word(words, k) /= 'auto') others = others//' '//get_word(words, k)
      end do
   end function without_auto

end module adfric_input_fit_settings

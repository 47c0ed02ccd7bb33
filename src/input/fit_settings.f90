! SPDX-License-Identifier: GPL-3.0-or-later
!> `&event` and `&fit`: what was measured beside the points, and how the fit is made.
module adfric_input_fit_settings
   use adfric_base_kinds, only: dp
   use adfric_base_text, only: join_words, show_count, show_text
   use adfric_base_unset, only: is_set
   use adfric_base_words, only: count_words, get_word, has_word
   use adfric_fit_problem, only: event_t, fit_t
   use adfric_input_fit_data_group, only: data_group_t
   use adfric_input_fit_values, only: reader_t, new_reader
   use adfric_input_reading, only: reading_t
   use adfric_input_suggestion, only: did_you_mean
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: read_events, read_settings

   !> Levels of intervals where none are given.
   real(dp), parameter :: usual_levels(*) = [0.6827_dp, 0.95_dp]
   !> Index of the word `together`.
   integer, parameter :: curves_together = 2
   !> Index of the word `all` of the residuals.
   integer, parameter :: all_residuals = 2

contains

   !> Read every `&event`.
   subroutine read_events(r, rows, groups, events)
      type(reading_t), intent(in) :: r
      type(variable_t), intent(in) :: rows(:)
      !> The `&data` groups.
      type(data_group_t), intent(in) :: groups(:)
      type(event_t), allocatable, intent(out) :: events(:)
      type(reader_t) :: reader
      real(dp) :: kind
      integer :: i, n

      allocate (events(count(r%file%groups%name == 'event')))
      n = 0
      do i = 1, size(r%file%groups)
         if (r%file%groups(i)%name /= 'event') cycle
         if (r%problems%is_enough()) exit
         n = n + 1
         associate (event => events(n))
            call new_reader(reader, r, i, rows)
            call reader%read_whole(r, 'data', event%data_set)
            if (event%data_set > size(groups)) then
               call reader%report(r, 'data', 'no &data of this number, given '//show_count(event%data_set)//', allowed: 1 to ' &
                  //show_count(size(groups)))
               event%data_set = 1
            else if (size(groups(event%data_set)%others) > 0) then
               call reader%report(r, 'data', 'the points of &data['//show_count(event%data_set)//'] have variables of their '// &
                  'own, an event has none, allowed: a &data without variables')
            end if
            call reader%read_number(r, 'kind', kind)
            if (is_set(kind)) event%kind = nint(kind)
            call reader%read_number(r, 'value', event%value)
            call reader%read_number(r, 'sigma', event%sigma)
            call reader%report_missing(r, 'kind')
            call reader%report_missing(r, 'value')
            call reader%report_missing(r, 'sigma')
         end associate
      end do
      events = events(:n)
   end subroutine read_events

   !> Read `&fit`, which may be absent.
   subroutine read_settings(r, rows, fit, is_together, wants_residuals)
      type(reading_t), intent(in) :: r
      type(variable_t), intent(in) :: rows(:)
      type(fit_t), intent(inout) :: fit
      !> Are the curves of a stack fitted together?
      logical, intent(out) :: is_together
      !> Are the points of each curve wanted beside the results?
      logical, intent(out) :: wants_residuals
      type(reader_t) :: reader
      integer :: curves, residuals, group

      fit%levels = usual_levels
      fit%derived = ''
      allocate (fit%theories(0))
      is_together = .false.
      wants_residuals = .false.
      group = r%file%find_group('fit')
      if (group == 0) return
      call new_reader(reader, r, group, rows)
      call reader%read_whole(r, 'intervals', fit%intervals)
      call reader%read_numbers(r, 'levels', fit%levels)
      call reader%read_whole(r, 'starts', fit%n_starts)
      call reader%read_whole(r, 'curves', curves)
      call reader%read_whole(r, 'residuals', residuals)
      call reader%read_number(r, 'relative_tolerance', fit%relative_tolerance)
      call reader%read_whole(r, 'refits', fit%n_bootstrap)
      call reader%read_whole(r, 'seed', fit%seed)
      call read_theories(r, reader, fit)
      call reader%read_texts(r, 'derived', fit%derived)
      is_together = curves == curves_together
      wants_residuals = residuals == all_residuals
   end subroutine read_settings

   !> Read the theories that are compared.
   subroutine read_theories(r, reader, fit)
      type(reading_t), intent(in) :: r
      !> The group `&fit`.
      type(reader_t), intent(in) :: reader
      type(fit_t), intent(inout) :: fit
      character(:), allocatable :: words, known
      integer :: i, k, index

      call reader%read_texts(r, 'theories', words)
      if (len(words) == 0) return
      index = r%model%solver_index_of('model', 'theory')
      if (index == 0) then
         call reader%report(r, 'theories', 'the model '''//r%model%name//''' has no theories')
         return
      end if
      known = r%model%variables(index)%choices
      do i = 1, count_words(words)
         if (.not. has_word(known, get_word(words, i)) .or. get_word(words, i) == 'auto') then
            call reader%report(r, 'theories', 'unknown theory, given '''//show_text(get_word(words, i))//''', allowed: ''' &
               //join_words(trim(adjustl(without_auto(known))), ''', ''')//''''//did_you_mean(get_word(words, i), known))
            cycle
         end if
         do k = 1, count_words(known)
            if (get_word(known, k) /= get_word(words, i)) cycle
            if (k /= nint(r%input%values(index))) fit%theories = [fit%theories, k]
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

! SPDX-License-Identifier: GPL-3.0-or-later
!> The short table at the end of a run.
module adfric_output_run_table
   use adfric_base_kinds, only: dp, i8
   use adfric_base_text, only: show_number
   use adfric_base_words, only: get_word, pad
   use adfric_describe_doubt, only: doubt_limits, doubt_meanings, doubt_name, doubt_none, n_doubts, quantity_of
   use adfric_describe_status, only: status_solved, n_status
   use adfric_describe_table, only: result_t
   use adfric_run_summary, only: run_summary_t
   implicit none (type, external)
   private
   public :: new_run_table, new_end_lines, count_line, status_lines, doubt_lines

   character(*), parameter :: newline = achar(10)
   !> Width of the first column, and of a number of points.
   integer, parameter :: name_width = 38, count_width = 12

contains

   !> Points by status and state, range of each main result, wall time and file.
   function new_run_table(summary, results, states, path) result(text)
      !> What the run has met: points, states, ranges and time.
      type(run_summary_t), intent(in) :: summary
      !> Results of the model with the units of this run.
      type(result_t), intent(in) :: results(:)
      !> Names of the states of a point, separated by a blank.
      character(*), intent(in) :: states
      !> Name of the results file.
      character(*), intent(in) :: path
      character(:), allocatable :: text
      integer :: i

      text = status_lines(summary%by_status, states)
      if (summary%n_damaged > 0) text = text//count_line('damaged, solved again', summary%n_damaged)
      do i = 1, size(results)
         if (.not. any(summary%enumerated == i)) cycle
         if (results(i)%name == doubt_name) then
            text = text//doubt_lines(summary%by_state(:, i))
         else
            text = text//state_lines(results(i), summary%by_state(:, i))
         end if
      end do
      if (any(summary%main > 0)) text = text//head_line()
      do i = 1, size(results)
         if (any(summary%main == i)) text = text//range_line(results(i), summary%lowest(i), summary%highest(i))
      end do
      text = text//new_end_lines(summary, path)
   end function new_run_table

   !> Wall time and file, with which every table ends.
   function new_end_lines(summary, path) result(text)
      !> What the run has met, of which the time is shown.
      type(run_summary_t), intent(in) :: summary
      !> Name of the results file.
      character(*), intent(in) :: path
      character(:), allocatable :: text

      text = time_line(summary)//pad('file', 6)//path//newline
   end function new_end_lines

   !> Line with a number of points.
   function count_line(name, n) result(line)
      !> What the line begins with; blanks follow up to the column of the numbers.
      character(*), intent(in) :: name
      !> Number of points.
      integer(i8), intent(in) :: n
      character(:), allocatable :: line
      character(count_width) :: buffer

      write (buffer, '(i12)') n
      line = pad(name, name_width)//buffer//newline
   end function count_line

   !> Lines with the number of points in each state that was met.
   function state_lines(result, counts) result(lines)
      type(result_t), intent(in) :: result
      !> Number of points in each state, from 0 on.
      integer(i8), intent(in) :: counts(0:)
      character(:), allocatable :: lines
      integer :: i

      lines = ''
      if (all(counts == 0)) return
      lines = 'points by '//trim(words_of(result%name))//newline
      do i = 0, result%n_states() - 1
         if (counts(i) == 0) cycle
         lines = lines//count_line('  '//words_of(get_word(result%flag_meanings, i + 1)), counts(i))
      end do
   end function state_lines

   !> Lines with the number of points, and of those of each status.
   function status_lines(counts, states) result(lines)
      !> Number of points of each status.
      integer(i8), intent(in) :: counts(0:)
      !> Names of the states of a point, separated by a blank.
      character(*), intent(in) :: states
      character(:), allocatable :: lines
      integer :: i

      lines = count_line('points', sum(counts))
      do i = 0, n_status - 1
         if (counts(i) == 0 .and. i /= status_solved) cycle
         lines = lines//count_line('  '//words_of(get_word(states, i + 1)), counts(i))
      end do
   end function status_lines

   !> Lines with the number of points beyond each bound, and the bound; none if there is no such point.
   function doubt_lines(counts) result(lines)
      !> Number of points of each doubt, from 0 on.
      integer(i8), intent(in) :: counts(0:)
      character(:), allocatable :: lines
      integer :: i

      lines = ''
      if (all(counts(doubt_none + 1:) == 0)) return
      lines = 'points beyond a bound of the theory'//newline
      do i = doubt_none + 1, n_doubts
         if (counts(i) > 0) lines = lines//count_line('  '//words_of(get_word(doubt_meanings, i + 1)), counts(i)) &
            & //'    '//quantity_of(i)//' >= '//show_number(doubt_limits(i))//newline
      end do
   end function doubt_lines

   !> What the columns of the lines with ranges are.
   function head_line() result(line)
      character(:), allocatable :: line
      character(32) :: buffer

      write (buffer, '(a12, a, a12)') 'lowest', ' to ', 'highest'
      line = pad('result', name_width - 12)//trim(buffer)//' unit'//newline
   end function head_line

   !> Line with the range of a result.
   function range_line(result, lowest, highest) result(line)
      type(result_t), intent(in) :: result
      !> Smallest and largest value in the unit of the result; the smallest one is above the largest one if there is no value.
      real(dp), intent(in) :: lowest, highest
      character(:), allocatable :: line

      line = pad(words_of(result%name), name_width - 12)
      if (lowest > highest) then
         line = line//'no value'//newline
         return
      end if
      line = line//six_digits(lowest)//' to '//six_digits(highest)//' '//result%unit//newline
   end function range_line

   !> A number with six digits, whose exponent has two digits or three.
   pure function six_digits(x) result(text)
      real(dp), intent(in) :: x
      character(:), allocatable :: text
      character(13) :: buffer

      ! an exponent of three digits would take the letter away
      write (buffer, '(es12.5)') x
      if (index(buffer, 'E') == 0) write (buffer, '(es13.5e3)') x
      text = trim(buffer)
   end function six_digits

   !> Line with the duration of the run.
   function time_line(summary) result(line)
      !> Summary of the run, with its time and its number of points.
      type(run_summary_t), intent(in) :: summary
      character(:), allocatable :: line
      character(20) :: whole, per_point

      write (whole, '(f20.3)') summary%wall_seconds
      write (per_point, '(es20.2)') summary%wall_seconds/max(1.0_dp, real(summary%n_points, dp))
      line = pad('time', 6)//trim(adjustl(whole))//' s ('//trim(adjustl(per_point))//' s per point)'//newline
   end function time_line

   !> A name as words: without underscores.
   pure function words_of(name) result(words)
      !> Name in which underscores separate the words.
      character(*), intent(in) :: name
      character(len(name)) :: words
      integer :: i

      words = name
      do i = 1, len(name)
         if (name(i:i) == '_') words(i:i) = ' '
      end do
   end function words_of

end module adfric_output_run_table

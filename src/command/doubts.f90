! SPDX-License-Identifier: GPL-3.0-or-later
!> What the user of a run may not mean, at its first point or where a sweep ends, and what of it lies beyond a bound of the theory.
module adfric_command_doubts
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_text, only: newline, show_count, show_number
   use adfric_base_words, only: get_word
   use adfric_command_hints, only: warn_of_sliding
   use adfric_describe_doubt, only: doubt_limits, doubt_meanings, n_doubts, not_measured, quantity_of
   use adfric_run_run, only: run_t
   use adfric_run_time_estimate, only: time_estimate_t
   implicit none (type, external)
   private
   public :: describe_doubts_of, describe_bounds_of, describe_trials

contains

   !> Doubts of the first point; if there are none, those of the other end of the first sweep that has some there, and where that
   !> is. Behind them stands whether a contact slides.
   function describe_doubts_of(run) result(text)
      class(run_t), intent(in) :: run
      character(:), allocatable :: text
      integer :: k

      text = run%model%describe_doubts(run%plan%base)
      do k = 1, size(run%plan%axes)
         if (len(text) > 0) exit
         text = run%model%describe_doubts(values_at_end(run, k))
         if (len(text) > 0) text = 'at '//name_of_end(run, k)//': '//text
      end do
      text = text//warn_of_sliding(run)
   end function describe_doubts_of

   !> Values of the point at the other end of a sweep, of the others the first.
   pure function values_at_end(run, axis) result(values)
      class(run_t), intent(in) :: run
      !> Index of the sweep, from 1.
      integer, intent(in) :: axis
      real(dp), allocatable :: values(:)

      values = run%plan%base
      associate (swept => run%plan%axes(axis))
         values(swept%variables) = swept%values(:, size(swept%values, 2))
      end associate
   end function values_at_end

   !> What the end of a sweep is called.
   function name_of_end(run, axis) result(text)
      class(run_t), intent(in) :: run
      integer, intent(in) :: axis
      character(:), allocatable :: text

      associate (swept => run%plan%axes(axis))
         text = run%model%variables(swept%variables(1))%name//' = '//show_number(swept%values(1, size(swept%values, 2)))
      end associate
   end function name_of_end

   !> A line for each bound of the theory beyond which the run lies, as far as that is known before: at its first point, or at the
   !> other end of a sweep.
   function describe_bounds_of(run) result(text)
      class(run_t), intent(in) :: run
      character(:), allocatable :: text
      logical :: is_named(n_doubts)
      integer :: k

      text = ''
      is_named = .false.
      call name_bounds(run, run%plan%base, '', is_named, text)
      do k = 1, size(run%plan%axes)
         call name_bounds(run, values_at_end(run, k), ' at '//name_of_end(run, k), is_named, text)
      end do
   end function describe_bounds_of

   !> Name the bounds that a point lies beyond and that have not been named.
   subroutine name_bounds(run, values, index, is_named, text)
      class(run_t), intent(in) :: run
      real(dp), intent(in) :: values(:)
      !> Where the point is, in words; empty for the first one.
      character(*), intent(in) :: index
      logical, intent(inout) :: is_named(:)
      !> The lines, to which new ones are added.
      character(:), allocatable, intent(inout) :: text
      real(dp) :: measures(n_doubts), unknown(size(run%model%results))
      integer :: i

      measures = not_measured
      unknown = not_a_number()
      call run%model%measure(values, unknown, measures)
      do i = 1, n_doubts
         if (is_named(i) .or. ieee_is_nan(measures(i))) cycle
         if (measures(i) < doubt_limits(i)) cycle
         is_named(i) = .true.
         text = text//'doubt: '//get_word(doubt_meanings, i + 1)//index//', '//quantity_of(i)//' is '//show_number(measures(i)) &
            & //', and the theory holds up to '//show_number(doubt_limits(i))//newline
      end do
   end subroutine name_bounds

   !> A line for each bound of the theory beyond which trial points lie, and one where they leave out a coupling that counts.
   function describe_trials(estimate) result(text)
      type(time_estimate_t), intent(in) :: estimate
      character(:), allocatable :: text
      integer :: i

      text = ''
      do i = 1, n_doubts
         if (estimate%by_doubt(i) > 0) text = text//'doubt: '//get_word(doubt_meanings, i + 1)//' at ' &
            & //show_count(estimate%by_doubt(i))//' of '//show_count(estimate%n_trials)//' trial points, '//quantity_of(i) &
            & //' >= '//show_number(doubt_limits(i))//newline
      end do
      if (estimate%n_unsolved > 0 .and. estimate%n_unsolved == estimate%n_trials) text = text//'warning: none of '// &
         & show_count(estimate%n_trials)//' trial points has an answer; are sizes and units right?'//newline
      if (estimate%n_uncoupled > 0) text = text//'coupling left out at '//show_count(estimate%n_uncoupled)//' of ' &
         & //show_count(estimate%n_trials)//' trial points: to first order it changes the friction by more than the error ' &
         & //'(coupling_left_out)'//newline
   end function describe_trials

end module adfric_command_doubts

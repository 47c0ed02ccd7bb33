! SPDX-License-Identifier: GPL-3.0-or-later
!> A line on the terminal that says how far a run is.
module adfric_driver_progress_bar
   use, intrinsic :: iso_c_binding, only: c_int
   use, intrinsic :: iso_fortran_env, only: error_unit
   use adfric_base_kinds, only: dp, i8
   use adfric_run_progress, only: progress_t
   use adfric_system_clock, only: wall_clock
   implicit none (type, external)
   private
   public :: progress_bar_t, new_progress_bar

   !> Least time between two updates of the line [s].
   real(dp), parameter :: interval = 0.2_dp
   !> The line appears after this time, when the speed of the run is known [s].
   real(dp), parameter :: first_shown_after = 0.5_dp
   !> Length of the line.
   integer, parameter :: width = 78
   !> Moves the cursor back to the beginning of the line.
   character, parameter :: carriage_return = achar(13)

   !> The line on the terminal, and when it was last written.
   type, extends(progress_t) :: progress_bar_t
      private
      !> Is there a terminal, and does the user want to see it?
      logical :: is_shown = .false.
      !> Does the line stand on the terminal now?
      logical :: is_written = .false.
      !> When the run began, and when the line was written last, by `wall_clock` [s].
      real(dp) :: started_at = 0, written_at = 0
      !> Points that were solved before the first report; negative before it.
      integer(i8) :: n_before = -1
   contains
      procedure :: report
      procedure :: clear
   end type progress_bar_t

   interface
      !> Is a file a terminal? 1 or 0.
      integer(c_int) function isatty(file) bind(c, name='isatty')
         import :: c_int
         implicit none (type, external)
         !> Descriptor of the file.
         integer(c_int), intent(in), value :: file
      end function isatty
   end interface

contains

   !> Make the line ready; the time of the run counts from now.
   subroutine new_progress_bar(self, is_quiet)
      !> Receives the line, which is not yet shown.
      type(progress_bar_t), intent(out) :: self
      !> Does the user want nothing but errors?
      logical, intent(in) :: is_quiet
      integer(c_int), parameter :: standard_error = 2

      self%is_shown = isatty(standard_error) == 1
      if (is_quiet) self%is_shown = .false.
      self%started_at = wall_clock()
      self%written_at = self%started_at
   end subroutine new_progress_bar

   !> Update the line, if the last update was long enough ago.
   subroutine report(self, n_done, n_total)
      class(progress_bar_t), intent(inout) :: self
      !> Points that are done, and all points.
      integer(i8), intent(in) :: n_done, n_total
      real(dp) :: now, rate
      character(2*width) :: line
      integer :: status

      if (self%n_before < 0) self%n_before = n_done
      if (.not. self%is_shown .or. n_done == self%n_before) return
      now = wall_clock()
      if (now - self%written_at < interval .or. now - self%started_at < first_shown_after) return
      rate = (n_done - self%n_before)/(now - self%started_at)
      write (line, '(i0, a, i0, a, i0, a, es8.1, a)') n_done, ' of ', n_total, ' points (', (100*n_done)/n_total, &
         ' %),', rate, ' points/s, '//time_text((n_total - n_done)/rate)//' left'
      ! the terminal may be gone
      write (error_unit, '(2a)', advance='no', iostat=status) carriage_return, line(:width)
      flush (error_unit, iostat=status)
      self%is_written = .true.
      self%written_at = now
   end subroutine report

   !> Remove the line from the terminal.
   subroutine clear(self)
      class(progress_bar_t), intent(inout) :: self
      integer :: status

      if (.not. self%is_written) return
      write (error_unit, '(3a)', advance='no', iostat=status) carriage_return, repeat(' ', width), carriage_return
      self%is_written = .false.
   end subroutine clear

   !> A duration, in the unit that fits.
   function time_text(duration) result(text)
      !> The duration [s].
      real(dp), intent(in) :: duration
      character(:), allocatable :: text
      real(dp), parameter :: minute = 60, hour = 3600, day = 86400
      character(16) :: buffer

      if (duration < 2*minute) then
         write (buffer, '(i0, a)') nint(duration), ' s'
      else if (duration < 2*hour) then
         write (buffer, '(i0, a)') nint(duration/minute), ' min'
      else if (duration < 2*day) then
         write (buffer, '(i0, a)') nint(duration/hour), ' h'
      else
         write (buffer, '(es8.1, a)') duration/day, ' days'
      end if
      text = trim(adjustl(buffer))
   end function time_text

end module adfric_driver_progress_bar

! SPDX-License-Identifier: GPL-3.0-or-later
!> A sink that keeps everything, and counts how often each point came; and one that fails.
module counting_sink
   use, intrinsic :: iso_c_binding, only: c_int
   use adfric_base_kinds, only: dp, i8
   use adfric_base_error, only: error_t, set_error, file_failure
   use adfric_run_blocks, only: part_t
   use adfric_run_memory_sink, only: memory_sink_t, new_memory_sink
   use adfric_run_progress, only: progress_t
   use adfric_run_run, only: run_t
   use adfric_run_sink, only: sink_t
   implicit none (type, external)
   private
   public :: counting_sink_t, new_counting_sink, failing_sink_t, counting_progress_t, signalling_progress_t, n_different_bits

   !> Keeps everything, and counts.
   type, extends(memory_sink_t) :: counting_sink_t
      !> How often did the results and the profiles of each point come? Shape `(n_points)`.
      integer, allocatable :: n_puts(:), n_profile_puts(:)
      !> How often did points come?
      integer :: n_calls = 0
   contains
      procedure :: put => keep
      procedure :: put_profiles => keep_profiles
   end type counting_sink_t

   !> Fails when it has taken a number of points.
   type, extends(sink_t) :: failing_sink_t
      integer(i8) :: space = 0
      integer :: n_puts_after = 0
      logical :: has_failed = .false.
   contains
      procedure :: put => fail
      procedure :: put_profiles => fail_profiles
   end type failing_sink_t

   !> Remembers what it was told.
   type, extends(progress_t) :: counting_progress_t
      integer(i8) :: last = 0, total = 0
      logical :: is_monotone = .true.
   contains
      procedure :: report
   end type counting_progress_t

   !> Sends SIGTERM to its own process when a number of points is solved.
   type, extends(progress_t) :: signalling_progress_t
      integer(i8) :: last = 0
   contains
      procedure :: report => send
   end type signalling_progress_t

   interface
      integer(c_int) function raise(number) bind(c)
         import :: c_int
         implicit none (type, external)
         integer(c_int), intent(in), value :: number
      end function raise
   end interface

contains

   !> A sink for all points of a run, whichever part of it is solved.
   subroutine new_counting_sink(self, run)
      class(counting_sink_t), intent(out) :: self
      type(run_t), intent(in) :: run
      type(run_t) :: whole
      type(error_t), allocatable :: error

      whole = run
      whole%part = part_t()
      call new_memory_sink(self, whole, error)
      if (allocated(error)) error stop 'counting_sink: no memory'
      ! as a sink that has to wait for something
      self%has_own_thread = .true.
      allocate (self%n_puts(size(self%status)), self%n_profile_puts(size(self%status)), source=0)
   end subroutine new_counting_sink

   subroutine keep(self, first, results, error_estimate, status, counts, error)
      class(counting_sink_t), intent(inout) :: self
      integer(i8), intent(in) :: first
      real(dp), intent(in) :: results(:, :)
      real(dp), intent(in) :: error_estimate(:)
      integer, intent(in) :: status(:)
      real(dp), intent(in) :: counts(:, :)
      type(error_t), allocatable, intent(out) :: error

      self%n_calls = self%n_calls + 1
      self%n_puts(first:first + size(status) - 1) = self%n_puts(first:first + size(status) - 1) + 1
      call self%memory_sink_t%put(first, results, error_estimate, status, counts, error)
      if (size(results, 1) /= size(status)) call set_error(error, file_failure, 'shapes differ')
   end subroutine keep

   subroutine keep_profiles(self, point, profiles, error)
      class(counting_sink_t), intent(inout) :: self
      integer(i8), intent(in) :: point
      real(dp), intent(in) :: profiles(:, :, :)
      type(error_t), allocatable, intent(out) :: error

      self%n_profile_puts(point) = self%n_profile_puts(point) + 1
      call self%memory_sink_t%put_profiles(point, profiles, error)
   end subroutine keep_profiles

   subroutine fail(self, first, results, error_estimate, status, counts, error)
      class(failing_sink_t), intent(inout) :: self
      integer(i8), intent(in) :: first
      real(dp), intent(in) :: results(:, :)
      real(dp), intent(in) :: error_estimate(:)
      integer, intent(in) :: status(:)
      real(dp), intent(in) :: counts(:, :)
      type(error_t), allocatable, intent(out) :: error

      if (self%has_failed) self%n_puts_after = self%n_puts_after + 1
      if (first + size(status) - 1 <= self%space .and. size(results) >= size(error_estimate) &
         .and. size(counts, 1) > 0) return
      self%has_failed = .true.
      call set_error(error, file_failure, 'no room')
   end subroutine fail

   subroutine fail_profiles(self, point, profiles, error)
      class(failing_sink_t), intent(inout) :: self
      integer(i8), intent(in) :: point
      real(dp), intent(in) :: profiles(:, :, :)
      type(error_t), allocatable, intent(out) :: error

      if (self%has_failed) self%n_puts_after = self%n_puts_after + 1
      if (point <= self%space .and. size(profiles) > 0) return
      self%has_failed = .true.
      call set_error(error, file_failure, 'no room for a profile')
   end subroutine fail_profiles

   subroutine report(self, n_done, n_total)
      class(counting_progress_t), intent(inout) :: self
      integer(i8), intent(in) :: n_done, n_total

      self%is_monotone = self%is_monotone .and. n_done >= self%last
      self%last = n_done
      self%total = n_total
   end subroutine report

   subroutine send(self, n_done, n_total)
      class(signalling_progress_t), intent(inout) :: self
      integer(i8), intent(in) :: n_done, n_total
      integer(c_int), parameter :: sigterm = 15
      integer(c_int) :: status

      if (n_done < self%last .or. n_done == n_total) return
      self%last = huge(self%last)
      status = raise(sigterm)
      if (status /= 0) error stop 'no signal'
   end subroutine send

   !> How many numbers differ in a bit? NaN is like any other number here.
   elemental integer function n_different_bits(a, b)
      real(dp), intent(in) :: a, b

      n_different_bits = merge(0, 1, transfer(a, 1_i8) == transfer(b, 1_i8))
   end function n_different_bits

end module counting_sink

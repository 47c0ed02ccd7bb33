!> A sink that keeps everything, and counts how often each point came; and one that fails.
module memory_sink
   use, intrinsic :: iso_c_binding, only: c_int
   use adfric_base_kinds, only: dp, i8
   use adfric_base_error, only: error_t, set_error, file_failure
   use adfric_run_blocks, only: block_size_of
   use adfric_run_progress, only: progress_t
   use adfric_run_sink, only: sink_t
   implicit none (type, external)
   private
   public :: memory_sink_t, new_memory_sink, failing_sink_t, counting_progress_t, signalling_progress_t, n_different_bits

   !> Keeps everything.
   type, extends(sink_t) :: memory_sink_t
      !> Shape `(n_points, n_results)`.
      real(dp), allocatable :: results(:, :)
      !> Shape `(n_points)`.
      real(dp), allocatable :: error_estimate(:)
      integer, allocatable :: status(:), n_puts(:), n_profile_puts(:)
      !> A number of each profile of each point, shape `(n_points, 2)`: the sum of its values.
      real(dp), allocatable :: profile_sums(:, :)
      !> What the model counted in each block; shape `(n_blocks, n_counts)`.
      real(dp), allocatable :: counts(:, :)
      !> How often did points come?
      integer :: n_calls = 0
      !> Points of a block.
      integer :: block_size = 1
   contains
      procedure :: put => keep
      procedure :: put_profiles => keep_profiles
   end type memory_sink_t

   !> Fails when it has taken a number of points.
   type, extends(sink_t) :: failing_sink_t
      integer(i8) :: room = 0
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

   subroutine new_memory_sink(self, n_points, n_results, n_counts, largest_block)
      type(memory_sink_t), intent(out) :: self
      integer, intent(in) :: n_points, n_results
      !> 1 if absent.
      integer, intent(in), optional :: n_counts
      !> That of the model; none if absent.
      integer, intent(in), optional :: largest_block
      integer :: n

      n = 1
      if (present(n_counts)) n = n_counts
      self%block_size = block_size_of(int(n_points, i8))
      if (present(largest_block)) self%block_size = min(self%block_size, largest_block)
      allocate (self%counts(1 + n_points/self%block_size, n), source=0.0_dp)
      allocate (self%results(n_points, n_results), self%error_estimate(n_points), self%profile_sums(n_points, 2), &
         source=0.0_dp)
      allocate (self%status(n_points), self%n_puts(n_points), self%n_profile_puts(n_points), source=0)
   end subroutine new_memory_sink

   subroutine keep(self, first, results, error_estimate, status, counts, error)
      class(memory_sink_t), intent(inout) :: self
      integer(i8), intent(in) :: first
      real(dp), intent(in) :: results(:, :)
      real(dp), intent(in) :: error_estimate(:)
      integer, intent(in) :: status(:)
      real(dp), intent(in) :: counts(:, :)
      type(error_t), allocatable, intent(out) :: error
      integer(i8) :: last, block

      last = first + size(status) - 1
      block = 1 + (first - 1)/self%block_size
      self%counts(block:block + size(counts, 1) - 1, :) = counts
      self%n_calls = self%n_calls + 1
      self%results(first:last, :) = results
      self%error_estimate(first:last) = error_estimate
      self%status(first:last) = status
      self%n_puts(first:last) = self%n_puts(first:last) + 1
      if (size(results, 1) /= size(status)) call set_error(error, file_failure, 'shapes differ')
   end subroutine keep

   subroutine keep_profiles(self, point, profiles, error)
      class(memory_sink_t), intent(inout) :: self
      integer(i8), intent(in) :: point
      real(dp), intent(in) :: profiles(:, :, :)
      type(error_t), allocatable, intent(out) :: error
      integer :: k

      self%n_profile_puts(point) = self%n_profile_puts(point) + 1
      do k = 1, size(profiles, 3)
         self%profile_sums(point, k) = sum(profiles(:, :, k))
      end do
      if (size(profiles, 3) /= 2) call set_error(error, file_failure, 'shapes differ')
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
      if (first + size(status) - 1 <= self%room .and. size(results) >= size(error_estimate) &
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
      if (point <= self%room .and. size(profiles) > 0) return
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

end module memory_sink

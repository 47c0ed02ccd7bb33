!> A sink that keeps everything, and counts how often each point came; and one that fails.
module memory_sink
   use adfric_base_kinds, only: dp, i8
   use adfric_base_error, only: error_t, set_error, file_failure
   use adfric_sweep_progress, only: progress_t
   use adfric_sweep_sink, only: sink_t
   implicit none (type, external)
   private
   public :: memory_sink_t, new_memory_sink, failing_sink_t, counting_progress_t, n_different_bits

   !> Keeps everything.
   type, extends(sink_t) :: memory_sink_t
      !> Shape `(n_points, n_results)`.
      real(dp), allocatable :: results(:, :)
      !> Shape `(n_points)`.
      real(dp), allocatable :: error_estimate(:)
      integer, allocatable :: status(:), n_puts(:), n_profile_puts(:)
      !> A number of each profile of each point, shape `(n_points, 2)`: the sum of its values.
      real(dp), allocatable :: profile_sums(:, :)
      !> Are the points put in their order?
      logical :: is_in_order = .true.
      integer(i8) :: next = 1
      !> How often did points come?
      integer :: n_calls = 0
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

contains

   subroutine new_memory_sink(self, n_points, n_results)
      type(memory_sink_t), intent(out) :: self
      integer, intent(in) :: n_points, n_results

      allocate (self%results(n_points, n_results), self%error_estimate(n_points), self%profile_sums(n_points, 2), &
         source=0.0_dp)
      allocate (self%status(n_points), self%n_puts(n_points), self%n_profile_puts(n_points), source=0)
   end subroutine new_memory_sink

   subroutine keep(self, first, results, error_estimate, status, error)
      class(memory_sink_t), intent(inout) :: self
      integer(i8), intent(in) :: first
      real(dp), intent(in) :: results(:, :)
      real(dp), intent(in) :: error_estimate(:)
      integer, intent(in) :: status(:)
      type(error_t), allocatable, intent(out) :: error
      integer(i8) :: last

      last = first + size(status) - 1
      self%is_in_order = self%is_in_order .and. first == self%next
      self%next = last + 1
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

   subroutine fail(self, first, results, error_estimate, status, error)
      class(failing_sink_t), intent(inout) :: self
      integer(i8), intent(in) :: first
      real(dp), intent(in) :: results(:, :)
      real(dp), intent(in) :: error_estimate(:)
      integer, intent(in) :: status(:)
      type(error_t), allocatable, intent(out) :: error

      if (self%has_failed) self%n_puts_after = self%n_puts_after + 1
      if (first + size(status) - 1 <= self%room .and. size(results) >= size(error_estimate)) return
      self%has_failed = .true.
      call set_error(error, file_failure, 'no room')
   end subroutine fail

   subroutine fail_profiles(self, point, profiles, error)
      class(failing_sink_t), intent(inout) :: self
      integer(i8), intent(in) :: point
      real(dp), intent(in) :: profiles(:, :, :)
      type(error_t), allocatable, intent(out) :: error

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

   !> How many numbers differ in a bit? NaN is like any other number here.
   elemental integer function n_different_bits(a, b)
      real(dp), intent(in) :: a, b

      n_different_bits = merge(0, 1, transfer(a, 1_i8) == transfer(b, 1_i8))
   end function n_different_bits

end module memory_sink

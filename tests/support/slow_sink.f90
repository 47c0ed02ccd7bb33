! SPDX-License-Identifier: GPL-3.0-or-later
!> A sink that takes its time, and watches how it is called.
module slow_sink
   use, intrinsic :: iso_c_binding, only: c_int
   use omp_lib, only: omp_get_level, omp_get_thread_num
   use adfric_base_kinds, only: dp, i8
   use adfric_base_error, only: error_t, set_error, file_failure
   use counting_sink, only: counting_sink_t
   implicit none (type, external)
   private
   public :: slow_sink_t

   !> Keeps everything, slowly.
   type, extends(counting_sink_t) :: slow_sink_t
      !> How long each call takes [us].
      integer :: delay = 0
      !> Shall it not become ready?
      logical :: fails_at_once = .false.
      integer :: n_preparations = 0
      !> Calls before it was ready, and while another one went on.
      integer :: n_too_early = 0, n_at_once = 0
      !> Least and largest number of the threads that called it.
      integer :: threads(2) = [huge(1), -1]
      !> Most teams, one within another, around a call.
      integer :: level = 0
      integer, private :: n_inside = 0
   contains
      procedure :: prepare => prepare_slowly
      procedure :: put => keep_slowly
   end type slow_sink_t

   interface
      integer(c_int) function usleep(microseconds) bind(c)
         import :: c_int
         implicit none (type, external)
         integer(c_int), intent(in), value :: microseconds
      end function usleep
   end interface

contains

   subroutine prepare_slowly(self, error)
      class(slow_sink_t), intent(inout) :: self
      type(error_t), allocatable, intent(out) :: error

      call enter(self)
      if (self%fails_at_once) call set_error(error, file_failure, 'no sink')
      self%n_preparations = self%n_preparations + 1
      call leave(self)
   end subroutine prepare_slowly

   subroutine keep_slowly(self, first, results, error_estimate, status, counts, error)
      class(slow_sink_t), intent(inout) :: self
      integer(i8), intent(in) :: first
      real(dp), intent(in) :: results(:, :)
      real(dp), intent(in) :: error_estimate(:)
      integer, intent(in) :: status(:)
      real(dp), intent(in) :: counts(:, :)
      type(error_t), allocatable, intent(out) :: error

      call enter(self)
      if (self%n_preparations == 0) self%n_too_early = self%n_too_early + 1
      call self%counting_sink_t%put(first, results, error_estimate, status, counts, error)
      call leave(self)
   end subroutine keep_slowly

   subroutine enter(self)
      class(slow_sink_t), intent(inout) :: self
      integer :: n_inside
      integer(c_int) :: status

      !$omp atomic capture
      self%n_inside = self%n_inside + 1
      n_inside = self%n_inside
      !$omp end atomic
      if (n_inside > 1) self%n_at_once = self%n_at_once + 1
      self%threads = [min(self%threads(1), omp_get_thread_num()), max(self%threads(2), omp_get_thread_num())]
      self%level = max(self%level, omp_get_level())
      status = usleep(int(self%delay, c_int))
      if (status /= 0) error stop 'no sleep'
   end subroutine enter

   subroutine leave(self)
      class(slow_sink_t), intent(inout) :: self

      !$omp atomic
      self%n_inside = self%n_inside - 1
   end subroutine leave

end module slow_sink

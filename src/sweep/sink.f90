!> Where the results of a sweep go.
module adfric_sweep_sink
   use adfric_base_kinds, only: dp, i8
   use adfric_base_error, only: error_t
   implicit none (type, external)
   private
   public :: sink_t

   !> A place that takes results by the number of their first point, in any order.
   type, abstract :: sink_t
      !> May a thread call it that does nothing else?
      logical :: has_own_thread = .true.
   contains
      procedure :: prepare
      procedure(put_i), deferred :: put
      procedure(put_profiles_i), deferred :: put_profiles
   end type sink_t

   abstract interface

      !> Take the results of the points `first`, `first + 1`, ... These points are done then.
      subroutine put_i(self, first, results, error_estimate, status, counts, error)
         import :: sink_t, dp, i8, error_t
         implicit none (type, external)
         class(sink_t), intent(inout) :: self
         !> Number of the first point in the run, from 1; the first one of a block.
         integer(i8), intent(in) :: first
         !> Shape `(n_points, n_results)`: each result contiguous, as it is written.
         real(dp), intent(in) :: results(:, :)
         !> Shape `(n_points)`.
         real(dp), intent(in) :: error_estimate(:)
         !> Shape `(n_points)`.
         integer, intent(in) :: status(:)
         !> What the model counted in each block; shape `(n_blocks, n_counts)`.
         real(dp), intent(in) :: counts(:, :)
         type(error_t), allocatable, intent(out) :: error
      end subroutine put_i

      !> Take the profiles of one point, before its other results.
      subroutine put_profiles_i(self, point, profiles, error)
         import :: sink_t, dp, i8, error_t
         implicit none (type, external)
         class(sink_t), intent(inout) :: self
         integer(i8), intent(in) :: point
         !> Shape `(n_last_axis, n_first_axis, n_profiles)`.
         real(dp), intent(in) :: profiles(:, :, :)
         type(error_t), allocatable, intent(out) :: error
      end subroutine put_profiles_i

   end interface

contains

   !> Make ready what the first results need. Called once, before any results come.
   subroutine prepare(self, error)
      class(sink_t), intent(inout) :: self
      type(error_t), allocatable, intent(out) :: error

      associate (unused => self, unused_too => error)
      end associate
   end subroutine prepare

end module adfric_sweep_sink

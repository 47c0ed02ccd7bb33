! SPDX-License-Identifier: GPL-3.0-or-later
!> Where the results of a sweep go.
module adfric_run_sink
   use adfric_base_kinds, only: dp, i8
   use adfric_base_error, only: error_t
   implicit none (type, external)
   private
   public :: sink_t

   !> A index that takes results by the number of their first point, in any order.
   type, abstract :: sink_t
      !> May a thread that does nothing else put the results into the sink?
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
         !> The sink, which keeps or writes the results.
         class(sink_t), intent(inout) :: self
         !> Number of the first point in the run, from 1; the first one of a block.
         integer(i8), intent(in) :: first
         !> Results of the points, each result contiguous as it is written; shape `(n_points, n_results)`.
         real(dp), intent(in) :: results(:, :)
         !> Relative error of the main result at each point; shape `(n_points)`.
         real(dp), intent(in) :: error_estimate(:)
         !> One of `status_...` for each point; shape `(n_points)`.
         integer, intent(in) :: status(:)
         !> What the model counted in each block; shape `(n_blocks, n_counts)`.
         real(dp), intent(in) :: counts(:, :)
         !> Not allocated if all went well.
         type(error_t), allocatable, intent(out) :: error
      end subroutine put_i

      !> Take the profiles of one point, before its other results.
      subroutine put_profiles_i(self, point, profiles, error)
         import :: sink_t, dp, i8, error_t
         implicit none (type, external)
         !> The sink, which keeps or writes the profiles.
         class(sink_t), intent(inout) :: self
         !> Number of the point in the run, from 1.
         integer(i8), intent(in) :: point
         !> Profiles of the point; shape `(n_last_axis, n_first_axis, n_profiles)`.
         real(dp), intent(in) :: profiles(:, :, :)
         type(error_t), allocatable, intent(out) :: error
      end subroutine put_profiles_i

   end interface

contains

   !> Make ready what the first results need. Called once, before any results come.
   subroutine prepare(self, error)
      !> The sink, which can take results afterwards; here nothing has to be done for that.
      class(sink_t), intent(inout) :: self
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error

      associate (unused => self, unused_too => error)
      end associate
   end subroutine prepare

end module adfric_run_sink

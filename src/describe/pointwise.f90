! SPDX-License-Identifier: GPL-3.0-or-later
!> A model whose points are solved one after the other. What is found at a point stays until the next one of its block: its
!> profiles are taken from it, and the next point may begin from it.
module adfric_describe_pointwise
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_describe_model, only: model_t
   use adfric_describe_profile_receiver, only: profile_receiver_t
   use adfric_describe_status, only: status_solved, status_not_converged, status_stopped
   use adfric_describe_table, only: profile_axis_t
   implicit none (type, external)
   private
   public :: pointwise_model_t, point_state_t

   !> What is found at a point; a model extends it by what its profiles and its next point need.
   type, abstract :: point_state_t
   end type point_state_t

   !> A model whose points are solved one after the other.
   type, abstract, extends(model_t) :: pointwise_model_t
   contains
      procedure :: solve_block
      procedure :: solve_block_and_profiles
      procedure :: solve_profiles
      procedure(solve_point_i), deferred :: solve_point
      procedure(fill_profiles_i), deferred :: fill_profiles
   end type pointwise_model_t

   abstract interface

      !> Solve one point.
      subroutine solve_point_i(self, values, state, results, error_estimate, status, counts)
         import :: pointwise_model_t, point_state_t, dp
         implicit none (type, external)
         !> The model; all threads solve with the same one.
         class(pointwise_model_t), intent(in) :: self
         !> Values of the variables; shape `(n_variables)`.
         real(dp), intent(in) :: values(:)
         !> In: what the point before has left, not allocated at the first of a block; it saves time and changes no bit of the
         !> results. Out: what this point leaves; a model that leaves nothing does not allocate it.
         class(point_state_t), allocatable, intent(inout) :: state
         !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
         real(dp), intent(inout) :: results(:)
         !> Relative error of the main result [-], estimated; of no meaning where the point is not solved.
         real(dp), intent(out) :: error_estimate
         !> One of `status_...`.
         integer, intent(out) :: status
         !> What the model counts at this point is added, in the order of the table `counts`; shape `(n_counts)`.
         real(dp), intent(inout) :: counts(:)
      end subroutine solve_point_i

      !> Profiles of the point that has just been solved.
      subroutine fill_profiles_i(self, values, results, state, axes, profiles)
         import :: pointwise_model_t, point_state_t, profile_axis_t, dp
         implicit none (type, external)
         class(pointwise_model_t), intent(in) :: self
         real(dp), intent(in) :: values(:)
         !> What `solve_point` has found; shape `(n_results)`.
         real(dp), intent(in) :: results(:)
         !> What `solve_point` has left; not allocated if it leaves nothing.
         class(point_state_t), allocatable, intent(in) :: state
         !> Axes of the profiles, the slowest first.
         type(profile_axis_t), intent(in) :: axes(:)
         !> In: all NaN. Out: profiles of the point; shape `(n_last_axis, n_first_axis, n_profiles)`.
         real(dp), intent(inout) :: profiles(:, :, :)
      end subroutine fill_profiles_i

   end interface

contains

   !> See `model_t`.
   subroutine solve_block(self, values, results, error_estimate, status, counts)
      class(pointwise_model_t), intent(in) :: self
      real(dp), intent(in), contiguous :: values(:, :)
      real(dp), intent(out) :: results(:, :), error_estimate(:)
      integer, intent(out) :: status(:)
      real(dp), intent(out) :: counts(:)

      call solve_points(self, values, results, error_estimate, status, counts)
   end subroutine solve_block

   !> See `model_t`: the profiles are those of the states that the results are taken from.
   subroutine solve_block_and_profiles(self, values, results, error_estimate, status, counts, profiles, receiver)
      class(pointwise_model_t), intent(in) :: self
      real(dp), intent(in), contiguous :: values(:, :)
      real(dp), intent(out) :: results(:, :)
      !> Relative error of each point's main result [-], estimated; NaN if the point is not solved; shape `(n_points)`.
      real(dp), intent(out) :: error_estimate(:)
      integer, intent(out) :: status(:)
      real(dp), intent(out) :: counts(:)
      real(dp), intent(inout) :: profiles(:, :, :)
      class(profile_receiver_t), intent(inout) :: receiver

      call solve_points(self, values, results, error_estimate, status, counts, profiles, receiver)
   end subroutine solve_block_and_profiles

   !> Solve the points of a block, with their profiles or without.
   subroutine solve_points(self, values, results, error_estimate, status, counts, profiles, receiver)
      class(pointwise_model_t), intent(in) :: self
      !> Values of the variables of each point; shape `(n_variables, n_points)`.
      real(dp), intent(in) :: values(:, :)
      !> Receives the results of each point, NaN where there is no value; shape `(n_results, n_points)`.
      real(dp), intent(out) :: results(:, :)
      !> Relative error of each point's main result [-], estimated; NaN if the point is not solved; shape `(n_points)`.
      real(dp), intent(out) :: error_estimate(:)
      !> One of `status_...` for each point; shape `(n_points)`.
      integer, intent(out) :: status(:)
      !> Receives what was counted at the points of the block, in the order of the table `counts`; shape `(n_counts)`.
      real(dp), intent(out) :: counts(:)
      !> Space for the profiles of one point, of their shape; present if `receiver` is.
      real(dp), intent(inout), optional :: profiles(:, :, :)
      !> Takes the profiles of each solved point, and says whether more is wanted; not present: no profiles are made.
      class(profile_receiver_t), intent(inout), optional :: receiver
      class(point_state_t), allocatable :: state
      type(profile_axis_t), allocatable :: axes(:)
      integer :: i
      logical :: goes_on

      results = not_a_number()
      error_estimate = not_a_number()
      status = status_not_converged
      counts = 0
      do i = 1, size(values, 2)
         call self%solve_point(values(:, i), state, results(:, i), error_estimate(i), status(i), counts)
         if (self%is_stopped()) then
            ! the point may have ended before its time
            status(i:) = status_stopped
            return
         end if
         if (status(i) /= status_solved) error_estimate(i) = not_a_number()
         if (status(i) /= status_solved .or. .not. present(receiver)) cycle
         ! all points of a run share the axes
         if (.not. allocated(axes)) call self%get_profile_axes(values(:, i), axes)
         profiles = not_a_number()
         call self%fill_profiles(values(:, i), results(:, i), state, axes, profiles)
         call receiver%take(i, profiles, goes_on)
         if (.not. goes_on) return
      end do
   end subroutine solve_points

   !> See `model_t`: the point is solved once more.
   subroutine solve_profiles(self, values, results, profiles)
      class(pointwise_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:), results(:)
      !> Profiles of the point, NaN where there is no value; shape `(n_last_axis, n_first_axis, n_profiles)`.
      real(dp), intent(out) :: profiles(:, :, :)
      class(point_state_t), allocatable :: state
      type(profile_axis_t), allocatable :: axes(:)
      real(dp) :: again(size(results)), error_estimate, counts(size(self%counts))
      integer :: status

      profiles = not_a_number()
      again = not_a_number()
      counts = 0
      call self%solve_point(values, state, again, error_estimate, status, counts)
      if (status /= status_solved) return
      call self%get_profile_axes(values, axes)
      call self%fill_profiles(values, results, state, axes, profiles)
   end subroutine solve_profiles

end module adfric_describe_pointwise

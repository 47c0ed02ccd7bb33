! SPDX-License-Identifier: GPL-3.0-or-later
!> A model whose points go through a history: what each of its steps leaves is a profile along the axis `step`.
module adfric_describe_stepwise
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_describe_pointwise, only: pointwise_model_t, point_state_t
   use adfric_describe_table, only: profile_axis_t
   implicit none (type, external)
   private
   public :: stepwise_model_t, steps_t

   !> A model of histories.
   type, abstract, extends(pointwise_model_t) :: stepwise_model_t
   contains
      procedure :: wants_profiles
      procedure :: get_profile_axes
      procedure :: fill_profiles
      procedure(count_steps_i), deferred :: count_steps
   end type stepwise_model_t

   !> What a point leaves: the profiles.
   type, extends(point_state_t) :: steps_t
      !> Shape `(n_steps, n_profiles)`.
      real(dp), allocatable :: steps(:, :)
   end type steps_t

   abstract interface

      !> Number of steps, the same for all points of a run.
      pure integer function count_steps_i(self, values)
         import :: stepwise_model_t, dp
         implicit none (type, external)
         !> The model with its history.
         class(stepwise_model_t), intent(in) :: self
         !> Values of the variables; shape `(n_variables)`.
         real(dp), intent(in) :: values(:)
      end function count_steps_i

   end interface

contains

   !> See `model_t`: always.
   pure logical function wants_profiles(self, values)
      class(stepwise_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      wants_profiles = .true.
      associate (unused => self, unused_too => values)
      end associate
   end function wants_profiles

   !> See `model_t`.
   subroutine get_profile_axes(self, values, axes)
      class(stepwise_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the axis of the steps.
      type(profile_axis_t), allocatable, intent(out) :: axes(:)
      integer :: n, k

      allocate (axes(1))
      axes(1)%name = self%profile_axes
      axes(1)%unit = '-'
      axes(1)%long_name = 'number of the step'
      n = self%count_steps(values)
      allocate (axes(1)%coordinates(n), source=0.0_dp)
      do k = 1, n
         axes(1)%coordinates(k) = k
      end do
   end subroutine get_profile_axes

   !> See `pointwise_model_t`.
   subroutine fill_profiles(self, values, results, state, axes, profiles)
      class(stepwise_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Results of the point, of which none is needed; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> The steps of the point.
      class(point_state_t), allocatable, intent(in) :: state
      !> The axis of the steps.
      type(profile_axis_t), intent(in) :: axes(:)
      !> In: all NaN. Out: the profiles; shape `(n_steps, 1, n_profiles)`.
      real(dp), intent(inout) :: profiles(:, :, :)

      profiles = not_a_number()
      if (.not. allocated(state)) return
      select type (state)
      type is (steps_t)
         profiles(:, 1, :) = state%steps
      end select
      associate (unused => self, unused_too => values, unused_results => results, unused_axes => axes)
      end associate
   end subroutine fill_profiles

end module adfric_describe_stepwise

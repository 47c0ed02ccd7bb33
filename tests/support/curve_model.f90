! SPDX-License-Identifier: GPL-3.0-or-later
!> A model whose results are known curves of two variables, for derivatives, errors and refinement.
!>
!> `square` = x^2 y; `step` is 0 below x = 1/3 and 1 from there on; `bend` = max(0, x - 0.7); `side` is the state of the step;
!> below x = -1/7 there is no equilibrium, beyond x = 9 nothing converges.
module curve_model
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_describe_model, only: model_t
   use adfric_describe_status, only: status_solved, status_no_equilibrium, status_not_converged
   use adfric_describe_table, only: profile_axis_t, kind_real
   implicit none (type, external)
   private
   public :: curve_model_t, new_curve_model, x_index, y_index, square_index, step_index, bend_index, side_index
   public :: index_of_step, index_of_bend, index_of_end

   integer, parameter :: x_index = 1, y_index = 2, square_index = 1, step_index = 2, bend_index = 3, side_index = 4
   real(dp), parameter :: index_of_step = 1.0_dp/3, index_of_bend = 0.7_dp, index_of_end = -1.0_dp/7, too_far = 9

   !> The model.
   type, extends(model_t) :: curve_model_t
   contains
      procedure :: check_values
      procedure :: wants_profiles
      procedure :: get_profile_axes
      procedure :: solve_block
      procedure :: solve_profiles
   end type curve_model_t

contains

   !> Make the model; y is from 0 to 2.
   subroutine new_curve_model(self)
      type(curve_model_t), intent(out) :: self
      integer :: k

      self%name = 'curve'
      self%summary = 'curves'
      self%references = ''
      self%profile_axes = ''
      allocate (self%counts(0), self%profiles(0), self%variables(2), self%results(4))
      do k = 1, 2
         self%variables(k)%group = 'point'
         self%variables(k)%name = 'xy' (k:k)
         self%variables(k)%kind = kind_real
         self%variables(k)%unit = 'm'
         self%variables(k)%meaning = 'a coordinate'
         self%variables(k)%choices = ''
         self%variables(k)%default = 1
      end do
      self%variables(y_index)%lower = 0
      self%variables(y_index)%upper = 2
      do k = 1, 4
         self%results(k)%unit = '-'
         self%results(k)%long_name = 'a curve'
         self%results(k)%flag_meanings = ''
      end do
      self%results(square_index)%name = 'square'
      self%results(square_index)%unit = 'N'
      self%results(step_index)%name = 'step'
      self%results(bend_index)%name = 'bend'
      self%results(side_index)%name = 'side'
      self%results(side_index)%flag_meanings = 'below above'
   end subroutine new_curve_model

   subroutine check_values(self, values, is_swept, problems)
      class(curve_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      logical, intent(in) :: is_swept(:)
      type(problems_t), intent(inout) :: problems

      if (size(values) /= size(self%variables) .or. size(is_swept) /= 2) call problems%add('', '', 'wrong sizes')
   end subroutine check_values

   pure logical function wants_profiles(self, values)
      class(curve_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)

      wants_profiles = size(self%profiles) + size(values) < 0
   end function wants_profiles

   subroutine get_profile_axes(self, values, axes)
      class(curve_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(profile_axis_t), allocatable, intent(out) :: axes(:)

      allocate (axes(min(0, size(self%profiles) + size(values))))
   end subroutine get_profile_axes

   subroutine solve_block(self, values, results, error_estimate, status, counts)
      class(curve_model_t), intent(in) :: self
      real(dp), intent(in), contiguous :: values(:, :)
      real(dp), intent(out) :: results(:, :)
      real(dp), intent(out) :: error_estimate(:)
      integer, intent(out) :: status(:)
      real(dp), intent(out) :: counts(:)
      integer :: i

      counts = size(self%counts)
      do i = 1, size(status)
         associate (x => values(x_index, i), y => values(y_index, i))
            results(:, i) = [x**2*y, merge(1.0_dp, 0.0_dp, x >= index_of_step), max(0.0_dp, x - index_of_bend), &
               & merge(1.0_dp, 0.0_dp, x >= index_of_step)]
            status(i) = status_solved
            if (x < index_of_end) status(i) = status_no_equilibrium
            if (x > too_far) status(i) = status_not_converged
         end associate
         error_estimate(i) = epsilon(1.0_dp)
         if (status(i) == status_solved) cycle
         results(:, i) = not_a_number()
         error_estimate(i) = not_a_number()
      end do
   end subroutine solve_block

   subroutine solve_profiles(self, values, results, profiles)
      class(curve_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      real(dp), intent(in) :: results(:)
      real(dp), intent(out) :: profiles(:, :, :)

      profiles = size(self%profiles) + size(values) + size(results)
   end subroutine solve_profiles

end module curve_model

! SPDX-License-Identifier: GPL-3.0-or-later
!> Cases of `wavy_sliding` on heights, cosines and spectra as an input would give them.
module stepped_cases
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: unset
   use adfric_foundation_model, only: wavy_model_t, new_wavy_model
   use adfric_foundation_variables, only: in => foundation_input
   use model_calls, only: find_problems, solve_values, solve_point, axis_of
   implicit none (type, external)
   private
   public :: new_stepped, give_list, give_heights, give_attribute, sampled_wave, rough_line, rough_map
   public :: find_problems, solve_values, solve_point, axis_of
   public :: kind_2d, kind_3d, kind_profile, kind_cosines, kind_map

   !> Positions of the words of the kind.
   integer, parameter :: kind_2d = 1, kind_3d = 2, kind_profile = 3, kind_cosines = 4, kind_map = 5
   real(dp), parameter :: two_pi = 2*acos(-1.0_dp)

contains

   !> A surface of a kind without its heights or cosines, on a standard solid, with adhesion, at a penetration. Heights stay as they are.
   subroutine new_stepped(model, values, kind)
      type(wavy_model_t), intent(out) :: model
      real(dp), allocatable, intent(out) :: values(:)
      integer, intent(in) :: kind

      call new_wavy_model(model)
      values = model%variables%default
      values(in%kind) = kind
      if (kind == kind_2d .or. kind == kind_3d) then
         values([in%period, in%height]) = [1.0e-2_dp, 1.0e-4_dp]
      else if (kind == kind_cosines) then
         values(in%period) = 1.0e-2_dp
      else
         values([in%detrend, in%periodise]) = 1
      end if
      values(in%stiffness) = 1.0e8_dp
      values(in%relaxation_time) = 1.0e-3_dp
      values(in%retardation_ratio) = 10
      values(in%stress) = 2.0e3_dp
      values(in%range) = 1.0e-5_dp
      values(in%velocity) = 0.5_dp
      values(in%penetration) = 4.0e-5_dp
   end subroutine new_stepped

   !> Give a list of numbers.
   subroutine give_list(model, values, position, list)
      type(wavy_model_t), intent(inout) :: model
      real(dp), intent(inout) :: values(:)
      integer, intent(in) :: position
      real(dp), intent(in) :: list(:)
      type(problems_t) :: problems

      call model%take_dataset(position, reshape(list, [size(list), 1]), problems)
      values(position) = 1
   end subroutine give_list

   !> Give heights of shape `(nx, ny)` with their distances, without attributes.
   subroutine give_heights(model, values, heights, spacing, strip_spacing)
      type(wavy_model_t), intent(inout) :: model
      real(dp), intent(inout) :: values(:)
      real(dp), intent(in) :: heights(:, :)
      real(dp), intent(in) :: spacing
      real(dp), intent(in), optional :: strip_spacing
      type(problems_t) :: problems

      call model%take_dataset(in%heights, heights, problems)
      values([in%heights, in%spacing]) = [1.0_dp, spacing]
      values(in%strip_spacing) = unset
      if (present(strip_spacing)) values(in%strip_spacing) = strip_spacing
   end subroutine give_heights

   !> Give an attribute of a dataset.
   subroutine give_attribute(model, position, name, value)
      type(wavy_model_t), intent(inout) :: model
      integer, intent(in) :: position
      character(*), intent(in) :: name
      real(dp), intent(in) :: value
      type(problems_t) :: problems

      call model%take_attribute(position, name, value, problems)
   end subroutine give_attribute

   !> Samples of the wave of `new_marched`, from its crest on; shape `(n, 1)`.
   pure function sampled_wave(n) result(heights)
      integer, intent(in) :: n
      real(dp) :: heights(n, 1)
      integer :: i

      heights(:, 1) = [(0.5e-4_dp*cos(two_pi*(i - 1)/n), i=1, n)]
   end function sampled_wave

   !> Some waves of falling amplitudes in a period, without symmetry; shape `(n, 1)`, height about 1e-4.
   pure function rough_line(n) result(heights)
      integer, intent(in) :: n
      real(dp) :: heights(n, 1)
      integer :: i, m

      heights = 0
      do i = 1, n
         do m = 1, 5
            heights(i, 1) = heights(i, 1) + 2.0e-5_dp/sqrt(real(m, dp))*cos(two_pi*m*(i - 1)/n + 2*m**2)
         end do
      end do
   end function rough_line

   !> Rows that are all different; shape `(nx, ny)`.
   pure function rough_map(nx, ny) result(heights)
      integer, intent(in) :: nx, ny
      real(dp) :: heights(nx, ny)
      integer :: i, j, m

      heights = 0
      do j = 1, ny
         do i = 1, nx
            do m = 1, 4
               heights(i, j) = heights(i, j) + 3.0e-5_dp/m*cos(two_pi*m*(i - 1)/nx + 2*m**2)*cos(two_pi*(m - 0.5_dp)*j/ny + m)
            end do
         end do
      end do
   end function rough_map

end module stepped_cases

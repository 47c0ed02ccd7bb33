! SPDX-License-Identifier: GPL-3.0-or-later
!> Cases of the model `surface_sliding`.
module periodic_sliding_cases
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: unset
   use model_calls, only: set_value
   use trial_case, only: trial_case_t, new_case
   implicit none (type, external)
   private
   public :: new_wave_case, new_heights_case, give_arms, take, take_heights, give_in, kind_1d, kind_2d, kind_heights

   !> Kinds of surfaces, in the order of the choice.
   real(dp), parameter :: kind_1d = 1, kind_2d = 2, kind_heights = 3

contains

   !> A wave of given kind on one arm, under a mean pressure.
   subroutine new_wave_case(case, kind, period, amplitude, cells)
      type(trial_case_t), intent(out) :: case
      real(dp), intent(in) :: kind, period, amplitude, cells

      call new_case(case, 'surface_sliding')
      call case%give('kind', kind)
      call case%give('period', period)
      call case%give('amplitude', amplitude)
      call case%give('cells', cells)
   end subroutine new_wave_case

   !> Heights, with a period along y where they vary along it.
   subroutine new_heights_case(case, heights, length_x, length_y)
      type(trial_case_t), intent(out) :: case
      real(dp), intent(in) :: heights(:, :), length_x, length_y

      call new_case(case, 'surface_sliding')
      call case%give('kind', kind_heights)
      if (take_heights(case, heights) > 0) error stop 'periodic_sliding_cases: no heights'
      call case%give('length_x', length_x)
      if (size(heights, 2) > 1) call case%give('length_y', length_y)
   end subroutine new_heights_case

   !> A material and the velocity.
   subroutine give_arms(case, modulus, moduli, times, velocity)
      type(trial_case_t), intent(inout) :: case
      real(dp), intent(in) :: modulus, moduli(:), times(:), velocity

      call case%give('modulus', modulus)
      call case%give('velocity', velocity)
      if (size(moduli) == 0) return
      if (take(case, 'material', 'moduli', reshape(moduli, [size(moduli), 1])) &
         & + take(case, 'material', 'relaxation_times', reshape(times, [size(times), 1])) > 0) &
         & error stop 'periodic_sliding_cases: no arms'
   end subroutine give_arms

   !> Hand over heights as the program does; how many problems they have.
   integer function take_heights(case, heights)
      type(trial_case_t), intent(inout) :: case
      real(dp), intent(in) :: heights(:, :)

      take_heights = take(case, 'surface', 'heights', heights)
   end function take_heights

   !> Hand over a list or a dataset as the program does; how many problems it has.
   integer function take(case, group, name, values)
      type(trial_case_t), intent(inout) :: case
      character(*), intent(in) :: group, name
      real(dp), intent(in) :: values(:, :)
      type(problems_t) :: problems

      call case%model%take_dataset(case%model%index_of(group, name), values, problems)
      take = problems%count()
      call give_in(case, group, name, merge(1.0_dp, unset, take == 0))
   end function take

   !> Set a variable of a group.
   subroutine give_in(case, group, name, value)
      type(trial_case_t), intent(inout) :: case
      character(*), intent(in) :: group, name
      real(dp), intent(in) :: value

      call set_value(case%model, case%values, group, name, value)
   end subroutine give_in

end module periodic_sliding_cases

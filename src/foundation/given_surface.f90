! SPDX-License-Identifier: GPL-3.0-or-later
!> What an input gives of a surface and its foundation beside single numbers: heights, waves, spectra.
module adfric_foundation_given_surface
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: unset
   use adfric_interface_attraction_rows, only: given_attraction_t
   use adfric_solid_given_spectrum, only: given_spectrum_t
   use adfric_describe_table, only: variable_t
   use adfric_foundation_variables, only: in => foundation_input
   implicit none (type, external)
   private
   public :: given_surface_t, take_given

   !> Lists and datasets of an input; what is not given is not allocated. The moduli of arms are stiffnesses [Pa/m].
   type, extends(given_spectrum_t) :: given_surface_t
      !> Heights [m]; shape `(nx, ny)`, a profile has one row.
      real(dp), allocatable :: heights(:, :)
      !> Distances of samples that the heights come with [m], or unset.
      real(dp) :: dx = unset, dy = unset
      !> Amplitudes [m] and phases [rad] of a sum of waves; shape `(n)`.
      real(dp), allocatable :: amplitudes(:), phases(:)
      !> Table of the law of attraction.
      type(given_attraction_t) :: attraction
   end type given_surface_t

contains

   !> Keep the values of a list or a dataset.
   subroutine take_given(self, variables, index, values, problems)
      type(given_surface_t), intent(inout) :: self
      !> Table of the variables; their names stand in the messages.
      type(variable_t), intent(in) :: variables(:)
      !> Index of the variable, one of `v_...`.
      integer, intent(in) :: index
      !> The values in SI units; shape `(n_last, n_first)`.
      real(dp), intent(in) :: values(:, :)
      type(problems_t), intent(inout) :: problems

      select case (index)
      case (in%heights)
         self%heights = values
         if (.not. maxval(values) > minval(values)) call add('are all the same')
      case (in%tension_table)
         self%attraction%table = values
      case (in%amplitudes)
         self%amplitudes = values(:, 1)
         if (.not. maxval(abs(values)) > 0) call add('are all 0')
      case (in%phases)
         self%phases = values(:, 1)
      case (in%moduli)
         self%moduli = values(:, 1)
      case (in%young_moduli)
         self%young_moduli = values(:, 1)
      case (in%relaxation_times)
         self%relaxation_times = values(:, 1)
      case (in%master_curve)
         self%master_curve = values
      end select

   contains

      !> Add a problem of the variable.
      subroutine add(text)
         !> What is wrong; the name is put before it.
         character(*), intent(in) :: text

         call problems%add(variables(index)%group, variables(index)%name, text)
      end subroutine add

   end subroutine take_given

end module adfric_foundation_given_surface

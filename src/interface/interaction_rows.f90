! SPDX-License-Identifier: GPL-3.0-or-later
!> The variables of what friction does to adhesion, for every model of one contact: alpha, and the slip after which adhesion loses no
!> more (`adfric_interface_interaction`).
module adfric_interface_interaction_rows
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_describe_rows, only: above_zero, any_number
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: set_interaction_rows, slip_energy_ratio_of
   public :: n_interaction_rows

   !> Indices among the rows, and their number.
   integer, parameter :: interaction = 1, critical_slip = 2, slip_energy_ratio = 3
   integer, parameter :: n_interaction_rows = slip_energy_ratio

contains

   !> The rows, in the group `friction`.
   subroutine set_interaction_rows(rows)
      !> Receives the rows; shape `(n_interaction_rows)`.
      type(variable_t), intent(out) :: rows(:)

      rows(interaction) = any_number(group='friction', name='interaction', unit='-', &
         & meaning='alpha, the share of the work of slip that adhesion loses; 0: friction leaves adhesion alone', default=0.0_dp, &
         & lower=0.0_dp)
      rows(critical_slip) = above_zero(group='friction', name='critical_slip', unit='m', &
         & meaning='s0, after which slip takes no more from adhesion')
      rows(slip_energy_ratio) = above_zero(group='friction', name='slip_energy_ratio', unit='-', &
         & meaning='g0 = tau0 s0/w, instead of the critical slip')
   end subroutine set_interaction_rows

   !> g0; the largest number where slip never stops to take from adhesion.
   pure real(dp) function slip_energy_ratio_of(values, strength, work) result(ratio)
      !> Values of the rows; shape `(n_interaction_rows)`.
      real(dp), intent(in) :: values(:)
      !> tau0 [Pa], and the work of adhesion w [J/m^2].
      real(dp), intent(in) :: strength, work

      ratio = huge(ratio)
      if (is_set(values(slip_energy_ratio))) ratio = values(slip_energy_ratio)
      if (is_set(values(critical_slip)) .and. work > 0) ratio = strength*values(critical_slip)/work
   end function slip_energy_ratio_of

end module adfric_interface_interaction_rows

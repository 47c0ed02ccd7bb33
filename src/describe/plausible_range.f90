! SPDX-License-Identifier: GPL-3.0-or-later
!> What sizes quantities have in contacts that there are: values far outside are those of a slip in the units. Only a hint: what a
!> variable may be stands in its table.
module adfric_describe_plausible_range
   use adfric_base_kinds, only: dp
   use adfric_base_text, only: show_number
   use adfric_base_unset, only: is_set
   use adfric_describe_table, only: variable_t, kind_real, kind_dataset
   implicit none (type, external)
   private
   public :: find_plausible_range, is_plausible, describe_usual

   !> Range of the sizes in a unit.
   type :: plausible_row_t
      !> SI unit of the variables that the range is for.
      character(8) :: unit
      !> Smallest and largest size that is not doubted.
      real(dp) :: lower, upper
   end type plausible_row_t

   !> A turn [rad].
   real(dp), parameter :: turn = 6.3_dp
   !> From parts of an atom to a large wheel, from a breath of air to diamond, from a gel a metre thick to a layer of atoms, from
   !> van der Waals forces in a liquid to soft glue, from creep to sound in solids.
   type(plausible_row_t), parameter :: table(*) = [ &
      & plausible_row_t('m', 1.0e-13_dp, 10.0_dp), &
      & plausible_row_t('Pa', 1.0e-6_dp, 1.0e13_dp), &
      & plausible_row_t('Pa/m', 1.0e2_dp, 1.0e22_dp), &
      & plausible_row_t('J/m^2', 1.0e-7_dp, 1.0e2_dp), &
      & plausible_row_t('m/s', 1.0e-15_dp, 1.0e4_dp), &
      & plausible_row_t('s', 1.0e-15_dp, 1.0e15_dp), &
      & plausible_row_t('N', 1.0e-18_dp, 1.0e12_dp), &
      & plausible_row_t('N/m', 1.0e-18_dp, 1.0e12_dp), &
      & plausible_row_t('rad', 0.0_dp, turn)]

contains

   !> The range of the sizes that a variable usually has: that of its row in the table of the model, else that of its unit.
   pure subroutine find_plausible_range(variable, unit, lower, upper)
      !> Row of the variable in the table of its model; its kind and its usual sizes are read.
      type(variable_t), intent(in) :: variable
      !> Unit of the variable in this case; the first one counts where several are separated by `;`.
      character(*), intent(in) :: unit
      !> Ends of the range, in the SI unit; 0 and the largest number where nothing is known.
      real(dp), intent(out) :: lower, upper
      integer :: k

      lower = 0
      upper = huge(upper)
      if (.not. (variable%kind == kind_real .or. variable%kind == kind_dataset)) return
      do k = 1, size(table)
         if (table(k)%unit /= unit(:index(unit//';', ';') - 1)) cycle
         lower = table(k)%lower
         upper = table(k)%upper
         if (is_set(variable%usual_lower)) lower = variable%usual_lower
         if (is_set(variable%usual_upper)) upper = variable%usual_upper
      end do
   end subroutine find_plausible_range

   !> The sizes that a variable usually has, in words; empty where nothing is known.
   pure function describe_usual(variable, unit) result(text)
      !> Row of the variable in the table of its model.
      type(variable_t), intent(in) :: variable
      !> Its unit; the first one counts where several are separated by `;`.
      character(*), intent(in) :: unit
      character(:), allocatable :: text
      real(dp) :: lower, upper

      text = ''
      call find_plausible_range(variable, unit, lower, upper)
      if (.not. upper < huge(upper)) return
      text = 'usual sizes'
      if (lower > 0) text = text//' '//show_number(lower)
      text = text//' to '//show_number(upper)//' '//trim(unit(:index(unit//';', ';') - 1))
      if (.not. lower > 0) text = 'usual sizes up to'//text(len('usual sizes to') + 1:)
   end function describe_usual

   !> Is a value 0, or of a size within a range?
   elemental logical function is_plausible(value, lower, upper)
      !> The value, in the unit of the range; its sign has no part in it.
      real(dp), intent(in) :: value
      !> Ends of the range, >= 0.
      real(dp), intent(in) :: lower, upper

      is_plausible = .not. abs(value) > 0 .or. (abs(value) >= lower .and. abs(value) <= upper)
   end function is_plausible

end module adfric_describe_plausible_range

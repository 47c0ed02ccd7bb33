! SPDX-License-Identifier: GPL-3.0-or-later
!> Cases of the half-space in other units: the same physics with numbers in other units of length and stress.
module scaled_cases
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_describe_table, only: result_t
   use trial_case, only: trial_case_t
   implicit none (type, external)
   private
   public :: scale_values, factor_of

contains

   !> Express all values that are set in other units, by the units of the table of variables.
   subroutine scale_values(case, length, stress)
      type(trial_case_t), intent(inout) :: case
      !> What a metre and a pascal are in the other units.
      real(dp), intent(in) :: length, stress
      integer :: i

      do i = 1, size(case%values)
         if (.not. is_set(case%values(i))) cycle
         case%values(i) = case%values(i)*factor_of(unit_of_case(case, i), length, stress)
      end do
   end subroutine scale_values

   !> Unit of a variable; the load of a line contact is one per length.
   function unit_of_case(case, position) result(unit)
      type(trial_case_t), intent(in) :: case
      integer, intent(in) :: position
      character(:), allocatable :: unit
      type(result_t), allocatable :: results(:)

      unit = case%model%variables(position)%unit
      if (unit /= 'N; N/m for line') return
      results = case%model%describe_results(case%values)
      unit = results(1)%unit
   end function unit_of_case

   !> A unit of the tables in other units of length and stress; an unknown unit ends the program.
   pure real(dp) function factor_of(unit, length, stress)
      character(*), intent(in) :: unit
      real(dp), intent(in) :: length, stress

      select case (unit)
      case ('', '-', 'rad')
         factor_of = 1
      case ('m')
         factor_of = length
      case ('m^2')
         factor_of = length**2
      case ('1/m')
         factor_of = 1/length
      case ('1/m^3')
         factor_of = 1/length**3
      case ('1/m^5')
         factor_of = 1/length**5
      case ('1/m^7')
         factor_of = 1/length**7
      case ('Pa')
         factor_of = stress
      case ('N/m', 'J/m^2')
         factor_of = stress*length
      case ('N')
         factor_of = stress*length**2
      case ('Pa/m')
         factor_of = stress/length
      ! of bodies whose resistivity and conductivity stay, per length
      case ('S', 'W/K')
         factor_of = length
      case ('S/m^2', 'W/m^2/K')
         factor_of = 1/length
      case ('Pa m^1/2')
         factor_of = stress*sqrt(length)
      case default
         error stop 'scaled_cases: no such unit'
      end select
   end function factor_of

end module scaled_cases

! SPDX-License-Identifier: GPL-3.0-or-later
!> The unit interval as the range of a variable.
module adfric_input_range_mapping
   use adfric_base_kinds, only: dp
   use adfric_describe_table, only: variable_t, kind_integer
   implicit none (type, external)
   private
   public :: range_of_variable_t, map_range

   !> The range of a variable in a sample.
   type :: range_of_variable_t
      !> Index of the variable in the model's table, from 1; 0 if there is none.
      integer :: variable = 0
      !> Number of the `&range` group in the file, from 1.
      integer :: group = 0
      !> The ends, in any order.
      real(dp) :: from = 0, to = 0
      !> Are equal parts of the unit interval equal ratios, instead of equal distances?
      logical :: is_logarithmic = .false.
   end type range_of_variable_t

contains

   !> A part of the unit interval as a value in the range; of an integer each value has an equal part, or the nearest is taken
   !> where the range is logarithmic.
   elemental real(dp) function map_range(part, range, variable) result(value)
      !> 0 to 1.
      real(dp), intent(in) :: part
      !> The range, whose ends the variable may have; of one sign if it is logarithmic.
      type(range_of_variable_t), intent(in) :: range
      !> Row of the model's table: kind, and what an integer has to be a multiple of.
      type(variable_t), intent(in) :: variable
      real(dp) :: step, n

      step = variable%multiple_of
      if (range%is_logarithmic) then
         value = sign(10.0_dp**((1 - part)*log10(abs(range%from)) + part*log10(abs(range%to))), range%from)
         if (variable%kind == kind_integer) value = step*anint(value/step)
      else if (variable%kind == kind_integer) then
         n = anint(abs(range%to - range%from)/step) + 1
         value = range%from + sign(step*min(aint(part*n), n - 1), range%to - range%from)
      else
         value = (1 - part)*range%from + part*range%to
      end if
      value = min(max(value, min(range%from, range%to)), max(range%from, range%to))
   end function map_range

end module adfric_input_range_mapping

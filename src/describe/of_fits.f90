! SPDX-License-Identifier: GPL-3.0-or-later
!> Rows of a model that belong to fits alone: an abscissa that a run does not take, such as the time in a history, and the ordinates
!> over it, which a run has as profiles. They are hidden in the table of the model, with a name of their own.
module adfric_describe_of_fits
   use adfric_describe_scene_rules, only: hidden
   use adfric_describe_table, only: result_t, variable_t
   implicit none (type, external)
   private
   public :: is_abscissa_of_fits, is_ordinate_of_fits

contains

   !> Is a variable the abscissa of fits alone?
   elemental logical function is_abscissa_of_fits(variable) result(is_so)
      !> Row of the variable.
      type(variable_t), intent(in) :: variable

      is_so = variable%is_hidden
      if (is_so) is_so = variable%name /= hidden
   end function is_abscissa_of_fits

   !> Is a result an ordinate over such an abscissa alone?
   elemental logical function is_ordinate_of_fits(result) result(is_so)
      !> Row of the result.
      type(result_t), intent(in) :: result

      is_so = result%is_hidden
      if (is_so) is_so = result%name /= hidden
   end function is_ordinate_of_fits

end module adfric_describe_of_fits

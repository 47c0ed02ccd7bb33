! SPDX-License-Identifier: GPL-3.0-or-later
!> Where the curves of a stack come from.
module adfric_fit_curve_source
   use adfric_base_kinds, only: i8
   use adfric_fit_problem, only: data_set_t
   implicit none (type, external)
   private
   public :: curve_source_t

   !> A stack of measured curves.
   type, abstract :: curve_source_t
   contains
      procedure(get_curves_i), deferred :: get_curves
      procedure(close_i), deferred :: close
   end type curve_source_t

   abstract interface

      !> Get neighbouring curves. Threads may ask at the same time.
      subroutine get_curves_i(self, first, data_sets, is_read)
         import :: curve_source_t, data_set_t, i8
         implicit none (type, external)
         !> The stack.
         class(curve_source_t), intent(in) :: self
         !> Number of the first curve, from 1.
         integer(i8), intent(in) :: first
         !> In: the data sets without their points. Out: with those of each curve; shape `(n_data_sets, n_curves)`.
         type(data_set_t), intent(inout) :: data_sets(:, :)
         !> False: the points could not be read.
         logical, intent(out) :: is_read
      end subroutine get_curves_i

      !> Give back what the stack holds open.
      subroutine close_i(self)
         import :: curve_source_t
         implicit none (type, external)
         !> The stack, from which nothing is wanted any more.
         class(curve_source_t), intent(inout) :: self
      end subroutine close_i

   end interface

end module adfric_fit_curve_source

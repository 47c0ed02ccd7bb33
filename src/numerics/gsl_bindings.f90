!> Bindings of the GNU Scientific Library.
module adfric_numerics_gsl_bindings
   use, intrinsic :: iso_c_binding, only: c_funptr
   implicit none (type, external)
   private
   public :: gsl_set_error_handler_off

   interface
      !> Let errors be reported by status instead of ending the program; gives back the handler until now.
      type(c_funptr) function gsl_set_error_handler_off() bind(c, name='gsl_set_error_handler_off')
         import :: c_funptr
         implicit none (type, external)
      end function gsl_set_error_handler_off
   end interface

end module adfric_numerics_gsl_bindings

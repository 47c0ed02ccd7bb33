!> Functions of the C mathematical library that Fortran lacks.
module adfric_numerics_libm
   use, intrinsic :: iso_c_binding, only: c_double
   implicit none (type, external)
   private
   public :: expm1

   interface
      !> exp(x) - 1 without loss of digits.
      pure real(c_double) function expm1(x) bind(c, name='expm1')
         import :: c_double
         implicit none (type, external)
         !> Argument of the function [-].
         real(c_double), intent(in), value :: x
      end function expm1
   end interface

end module adfric_numerics_libm

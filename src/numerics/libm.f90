! SPDX-License-Identifier: GPL-3.0-or-later
!> Functions of the C mathematical library that Fortran lacks.
module adfric_numerics_libm
   use, intrinsic :: iso_c_binding, only: c_double
   implicit none (type, external)
   private
   public :: expm1, log1p

   interface
      !> exp(x) - 1 without loss of digits.
      pure real(c_double) function expm1(x) bind(c, name='expm1')
         import :: c_double
         implicit none (type, external)
         !> Argument of the function [-].
         real(c_double), intent(in), value :: x
      end function expm1

      !> ln(1 + x) without loss of digits.
      pure real(c_double) function log1p(x) bind(c, name='log1p')
         import :: c_double
         implicit none (type, external)
         !> Argument of the function [-], > -1.
         real(c_double), intent(in), value :: x
      end function log1p
   end interface

end module adfric_numerics_libm

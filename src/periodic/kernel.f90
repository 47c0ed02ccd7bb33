!> What a solid answers to pressure on its surface, wave by wave: the symbol of the periodic operator. A new kernel is a type that
!> extends this one in a file of its own.
module adfric_periodic_kernel
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: kernel_t

   !> The surface of a solid.
   type, abstract :: kernel_t
   contains
      procedure(stiffness_i), deferred :: stiffness
   end type kernel_t

   abstract interface

      !> Pressure over displacement of the wave exp(2 pi i n.x). It is complex where the displacement lags behind the pressure, as
      !> under a viscoelastic solid that slides; the wave -n has the conjugate stiffness.
      pure complex(dp) function stiffness_i(self, waves) result(stiffness)
         import :: kernel_t, dp
         implicit none (type, external)
         !> The surface of the solid.
         class(kernel_t), intent(in) :: self
         !> Number n of waves per length along x and y.
         real(dp), intent(in) :: waves(2)
      end function stiffness_i

   end interface

end module adfric_periodic_kernel

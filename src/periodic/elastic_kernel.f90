!> The surface of an elastic half-space: pressure over displacement is E* |k|/2 (K. L. Johnson, Contact Mechanics, 1985,
!> section 13.2).
module adfric_periodic_elastic_kernel
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_periodic_kernel, only: kernel_t
   implicit none (type, external)
   private
   public :: elastic_kernel_t

   !> An elastic half-space, with pressures in units of its contact modulus E*.
   type, extends(kernel_t) :: elastic_kernel_t
   contains
      procedure :: stiffness
   end type elastic_kernel_t

contains

   !> See `kernel_t`: |k|/2 with the wave number k = 2 pi n.
   pure complex(dp) function stiffness(self, waves)
      !> The half-space; it has no parameter of its own.
      class(elastic_kernel_t), intent(in) :: self
      !> Number n of waves per length along x and y.
      real(dp), intent(in) :: waves(2)

      stiffness = cmplx(two_pi*hypot(waves(1), waves(2))/2, 0.0_dp, dp)
      associate (unused => self)
      end associate
   end function stiffness

end module adfric_periodic_elastic_kernel

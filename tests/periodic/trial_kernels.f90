!> Kernels for tests of the periodic operator: a solid twice as stiff, and one whose displacement lags behind.
module trial_kernels
   use adfric_base_kinds, only: dp
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_kernel, only: kernel_t
   implicit none (type, external)
   private
   public :: stiff_kernel_t, lagging_kernel_t

   !> Twice the stiffness of an elastic half-space.
   type, extends(kernel_t) :: stiff_kernel_t
   contains
      procedure :: stiffness => stiffness_of_stiff
   end type stiff_kernel_t

   !> An elastic half-space whose displacement lags behind along x.
   type, extends(kernel_t) :: lagging_kernel_t
   contains
      procedure :: stiffness => stiffness_of_lagging
   end type lagging_kernel_t

contains

   pure complex(dp) function stiffness_of_stiff(self, waves) result(stiffness)
      class(stiff_kernel_t), intent(in) :: self
      real(dp), intent(in) :: waves(2)
      type(elastic_kernel_t) :: elastic

      stiffness = 2*elastic%stiffness(waves)
      associate (unused => self)
      end associate
   end function stiffness_of_stiff

   pure complex(dp) function stiffness_of_lagging(self, waves) result(stiffness)
      class(lagging_kernel_t), intent(in) :: self
      real(dp), intent(in) :: waves(2)
      type(elastic_kernel_t) :: elastic

      stiffness = elastic%stiffness(waves)*(1 + (0.0_dp, 0.1_dp)*sign(1.0_dp, waves(1)))
      associate (unused => self)
      end associate
   end function stiffness_of_lagging

end module trial_kernels

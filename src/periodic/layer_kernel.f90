! SPDX-License-Identifier: GPL-3.0-or-later
!> The surface of an elastic layer on a rigid base: pressure over displacement is E* |k|/(2 F(Q)), Q = |k| H, H the thickness,
!>
!> $$ F = \frac{2 \sinh^2 Q}{\sinh 2Q + 2Q} \text{ (frictionless base)}, \qquad
!> F = \frac{2 c \sinh 2Q - 4Q}{2 c \cosh 2Q + 4Q^2 + 1 + c^2} \text{ (bonded)}, \quad c = 3 - 4 \nu $$
!> (K. L. Johnson, Contact Mechanics, 1985, section 5.8, in other words). F is 1 for a layer much thicker than the wave is long.
module adfric_periodic_layer_kernel
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_numerics_hyperbolic, only: sinh_minus_argument
   use adfric_periodic_kernel, only: kernel_t
   implicit none (type, external)
   private
   public :: layer_kernel_t, compliance_factor

   !> Above this the layer is a half-space to round-off.
   real(dp), parameter :: deep = 22.0_dp

   !> An elastic layer, with pressures in units of its contact modulus E*.
   type, extends(kernel_t) :: layer_kernel_t
      !> Thickness H, in the unit of all lengths, > 0.
      real(dp) :: thickness = 1
      !> Is the layer bonded to its base? Else it slips there without friction.
      logical :: is_bonded = .false.
      !> Poisson's ratio, of the bonded layer alone [-].
      real(dp) :: poisson_ratio = 0.5_dp
   contains
      procedure :: get_stiffness
      procedure :: mean_compliance
   end type layer_kernel_t

contains

   !> See `kernel_t`: |k|/(2 F).
   pure subroutine get_stiffness(self, n_x, n_y, cell_size, stiffness)
      class(layer_kernel_t), intent(in) :: self
      !> Numbers of waves per length along x and along y.
      real(dp), intent(in) :: n_x(:), n_y(:)
      !> Size of the cells, not used here: this is the stiffness of the wave itself.
      real(dp), intent(in) :: cell_size(2)
      !> Receives the stiffness of each pair of numbers; shape `(size(n_y), size(n_x))`.
      complex(dp), intent(out) :: stiffness(:, :)
      real(dp) :: wave_number
      integer :: i, j

      do i = 1, size(n_x)
         do j = 1, size(n_y)
            wave_number = two_pi*hypot(n_x(i), n_y(j))
            stiffness(j, i) = 0
            if (wave_number > 0) stiffness(j, i) = wave_number/(2*compliance_factor(self, wave_number*self%thickness))
         end do
      end do
      associate (unused => cell_size)
      end associate
   end subroutine get_stiffness

   !> Mean displacement over mean pressure: H under a frictionless base, H (1 - 2 nu)/(1 - nu)^2 of a bonded layer [length/E*].
   pure real(dp) function mean_compliance(self)
      class(layer_kernel_t), intent(in) :: self

      mean_compliance = self%thickness
      if (self%is_bonded) mean_compliance = self%thickness*(1 - 2*self%poisson_ratio)/(1 - self%poisson_ratio)**2
   end function mean_compliance

   !> F(Q): the compliance over that of a half-space.
   pure real(dp) function compliance_factor(self, q) result(factor)
      class(layer_kernel_t), intent(in) :: self
      !> Wave number times thickness [-], > 0.
      real(dp), intent(in) :: q
      real(dp) :: c

      factor = 1
      if (q > deep) return
      if (self%is_bonded) then
         c = 3 - 4*self%poisson_ratio
         factor = (2*c*sinh_minus_argument(2*q) + 8*(1 - 2*self%poisson_ratio)*q)/(2*c*cosh(2*q) + 4*q**2 + 1 + c**2)
      else
         factor = 2*sinh(q)**2/(sinh(2*q) + 2*q)
      end if
   end function compliance_factor

end module adfric_periodic_layer_kernel

! SPDX-License-Identifier: GPL-3.0-or-later
!> The surface of a solid over which a body slides with the shear stress q = mu p, where this shear stress moves the surface.
!>
!> A wave of wave vector k, at the angle phi from the direction of sliding, has the displacement of its pressure alone times
!> 1 - i m cos phi, m = mu kappa. On a half-space kappa = beta = (1 - 2 nu)/(2 (1 - nu)), and on a bonded layer, Q = |k| H,
!>
!>     kappa = [2 c beta (cosh 2Q - 1) - 4 (1 - beta) Q^2]/(2 c sinh 2Q - 4 Q),   c = 3 - 4 nu,
!>
!> which tends to beta for thick layers and is below 0 in thin ones of nu > 1/4. The mean carries no coupling. So the stiffness is that
!> of the frictionless solid over 1 - i m cos phi. Its real part is above 0 for m >= 0, and the contact is unique there: the phases of
!> a modulus that loses energy and of the coupling have opposite signs. Below 0 it may be negative.
!>
!> On cells each component of k in cos phi has the factor (theta/2) cot(theta/2), theta its phase from cell to cell: the integral of q
!> by the trapezoidal rule. It is 0 for waves of two cells, which have no direction.
module adfric_periodic_coupled_kernel
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, two_pi
   use adfric_numerics_hyperbolic, only: sinh_minus_argument
   use adfric_interface_total_friction, only: coupling_of
   use adfric_periodic_kernel, only: kernel_t
   implicit none (type, external)
   private
   public :: coupled_kernel_t, shear_coupling_t, coupling_of_layer

   !> Above this Q a layer couples as a half-space does.
   real(dp), parameter :: deep = 22.0_dp

   !> What shear does to the surface.
   type :: shear_coupling_t
      !> mu [-], and Poisson's ratio [-].
      real(dp) :: friction_coefficient = 0, poisson_ratio = 0.5_dp
      !> Thickness of a bonded layer, in the unit of all lengths; 0: a half-space.
      real(dp) :: thickness = 0
      !> Direction of sliding, of length 1.
      real(dp) :: direction(2) = [1.0_dp, 0.0_dp]
   contains
      procedure :: coupling_of_wave
      procedure :: factor_of
   end type shear_coupling_t

   !> A solid with this coupling.
   type, extends(kernel_t) :: coupled_kernel_t
      !> The solid below frictionless faces.
      class(kernel_t), allocatable :: solid
      !> What shear does.
      type(shear_coupling_t) :: coupling
   contains
      procedure :: get_stiffness
      procedure :: mean_compliance
   end type coupled_kernel_t

contains

   !> See `kernel_t`.
   pure subroutine get_stiffness(self, n_x, n_y, cell_size, stiffness)
      class(coupled_kernel_t), intent(in) :: self
      !> Numbers of waves per length along x and along y.
      real(dp), intent(in) :: n_x(:), n_y(:)
      !> Size of the cells; 0 for waves whatever the cells.
      real(dp), intent(in) :: cell_size(2)
      !> Receives the stiffness of each pair of numbers; shape `(size(n_y), size(n_x))`.
      complex(dp), intent(out) :: stiffness(:, :)
      integer :: i, j

      call self%solid%get_stiffness(n_x, n_y, cell_size, stiffness)
      do i = 1, size(n_x)
         do j = 1, size(n_y)
            stiffness(j, i) = stiffness(j, i)*self%coupling%factor_of([n_x(i), n_y(j)], cell_size)
         end do
      end do
   end subroutine get_stiffness

   !> See `kernel_t`: that of the frictionless solid.
   pure real(dp) function mean_compliance(self)
      class(coupled_kernel_t), intent(in) :: self

      mean_compliance = self%solid%mean_compliance()
   end function mean_compliance

   !> 1/(1 - i m cos phi): stiffness over that of frictionless faces.
   pure complex(dp) function factor_of(self, n, cell_size) result(factor)
      class(shear_coupling_t), intent(in) :: self
      !> Numbers of waves per length along x and along y.
      real(dp), intent(in) :: n(2)
      !> Size of the cells, or 0.
      real(dp), intent(in) :: cell_size(2)
      real(dp) :: along

      factor = 1
      if (.not. any(abs(n) > 0)) return
      along = sum(self%direction*n*cell_factor(two_pi*n*cell_size))/norm2(n)
      factor = 1/cmplx(1.0_dp, -self%coupling_of_wave(norm2(n))*along, dp)
   end function factor_of

   !> m of waves along the direction of sliding [-].
   pure real(dp) function coupling_of_wave(self, n) result(m)
      class(shear_coupling_t), intent(in) :: self
      !> Number of waves per length, > 0.
      real(dp), intent(in) :: n

      m = self%friction_coefficient*coupling_of(self%poisson_ratio)
      if (self%thickness > 0) m = self%friction_coefficient*coupling_of_layer(self%poisson_ratio, two_pi*n*self%thickness)
   end function coupling_of_wave

   !> kappa(Q) of a wave on a bonded layer, what beta is on a half-space [-].
   pure real(dp) function coupling_of_layer(poisson_ratio, q) result(kappa)
      !> Poisson's ratio [-], and Q = k H [-], > 0.
      real(dp), intent(in) :: poisson_ratio, q
      real(dp) :: c, beta

      beta = coupling_of(poisson_ratio)
      kappa = beta
      if (q > deep) return
      c = 3 - 4*poisson_ratio
      ! cosh 2Q - 1 = 2 sinh^2 Q, and 2 c sinh 2Q - 4 Q = 2 c (sinh 2Q - 2Q) + 8 (1 - 2 nu) Q
      kappa = (4*c*beta*sinh(q)**2 - 4*(1 - beta)*q**2)/(2*c*sinh_minus_argument(2*q) + 8*(1 - 2*poisson_ratio)*q)
   end function coupling_of_layer

   !> (theta/2) cot(theta/2), 0 for waves of two cells.
   elemental real(dp) function cell_factor(theta)
      !> Phase from cell to cell [rad], -pi to pi.
      real(dp), intent(in) :: theta
      real(dp), parameter :: small = 1.0e-4_dp, near = 1.0e-12_dp

      if (abs(theta) < small) then
         cell_factor = 1 - theta**2/12
      else if (abs(theta) > pi*(1 - near)) then
         cell_factor = 0
      else
         cell_factor = (theta/2)/tan(theta/2)
      end if
   end function cell_factor

end module adfric_periodic_coupled_kernel

! SPDX-License-Identifier: GPL-3.0-or-later
!> What a viscoelastic half-space loses per distance where shear stress q = mu p moves its surface, and what the friction changes by
!> where it does not.
!>
!> With the stiffness A of a wave below frictionless faces, the angle phi of its wave vector from the direction of sliding, and constant
!> Poisson's ratio nu, the surface has the displacements
!>
!>     u_z = (p - i beta cos phi q)/A,   u_x = [(1 - nu cos^2 phi)/(1 - nu) q + i beta cos phi p]/A,
!>
!> so that a distance takes the work -mean(p du_z/dx + q du_x/dx), in which the terms with beta cancel:
!>
!>     sum over all waves of k_x (-Im A)/|A|^2 [1 + mu^2 (1 - nu cos^2 phi)/(1 - nu)] |p_k|^2.
!>
!> A shear stress q that is left out would change the friction by -mean(p du_z/dx) of its u_z to first order, here without what the
!> pressure changes by: minus the sum over all waves of k_x kappa cos phi Re(1/A) p_k q_k*, kappa that of a layer where there is one.
module adfric_periodic_coupled_losses
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_base_error, only: error_t
   use adfric_base_not_a_number, only: not_a_number
   use adfric_numerics_spectral_filter, only: spectral_filter_t, new_spectral_filter
   use adfric_periodic_coupled_kernel, only: coupled_kernel_t, shear_coupling_t
   use adfric_periodic_kernel, only: kernel_t
   use adfric_periodic_operator, only: wave_number
   implicit none (type, external)
   private
   public :: heat_of_half_space, change_on_cells

   !> The waves of a map.
   type :: waves_t
      !> Transforms of the cells.
      type(spectral_filter_t) :: filter
      !> Numbers of waves per length along x and along y.
      real(dp), allocatable :: n_x(:), n_y(:)
      !> Stiffness of each wave; shape `(size(n_y), size(n_x))`.
      complex(dp), allocatable :: stiffness(:, :)
   end type waves_t

contains

   !> The waves of a map on a solid; an error means that there is no memory.
   subroutine new_waves(self, kernel, n_cells, period, is_quarter, error)
      type(waves_t), intent(out) :: self
      class(kernel_t), intent(in) :: kernel
      !> Number of cells along x and along y.
      integer, intent(in) :: n_cells(2)
      !> Periods along x and y, in the unit of all lengths of the kernel.
      real(dp), intent(in) :: period(2)
      !> Are the cells a quarter of the period, whose modes are cosines?
      logical, intent(in) :: is_quarter
      type(error_t), allocatable, intent(out) :: error
      integer :: i

      call new_spectral_filter(self%filter, n_cells(1), n_cells(2), is_quarter, .false., error)
      if (allocated(error)) return
      associate (n_modes => self%filter%n_modes)
         self%n_x = [((i - 1)/period(1), i=1, n_modes(1))]
         self%n_y = [(wave_number(i - 1, n_cells(2), is_quarter)/period(2), i=1, n_modes(2))]
         allocate (self%stiffness(n_modes(2), n_modes(1)))
      end associate
      call kernel%get_stiffness(self%n_x, self%n_y, period/(n_cells*merge(2, 1, is_quarter)), self%stiffness)
   end subroutine new_waves

   !> Energy lost in a half-space per nominal area and distance, in the unit of the pressure; NaN where there is no memory.
   real(dp) function heat_of_half_space(kernel, pressure, period) result(heat)
      !> The half-space with its coupling.
      type(coupled_kernel_t), intent(in) :: kernel
      !> Pressure in the middles of the cells; shape `(nx, ny)`.
      real(dp), intent(in), contiguous :: pressure(:, :)
      !> Periods along x and y, in the unit of all lengths of the kernel.
      real(dp), intent(in) :: period(2)
      type(waves_t) :: waves
      type(error_t), allocatable :: error
      real(dp), allocatable :: factors(:, :), product(:, :)
      real(dp) :: n(2), along
      integer :: i, j

      heat = not_a_number()
      call new_waves(waves, kernel%solid, shape(pressure), period, .false., error)
      if (allocated(error)) return
      allocate (product, mold=pressure)
      allocate (factors(size(waves%n_y), size(waves%n_x)), source=0.0_dp)
      associate (mu => kernel%coupling%friction_coefficient, nu => kernel%coupling%poisson_ratio, stiffness => waves%stiffness)
         do i = 1, size(factors, 2)
            do j = 1, size(factors, 1)
               n = [waves%n_x(i), waves%n_y(j)]
               if (.not. any(abs(n) > 0)) cycle
               along = dot_product(kernel%coupling%direction, n)
               factors(j, i) = -two_pi*along*aimag(stiffness(j, i))/abs(stiffness(j, i))**2 &
                  & *(1 + mu**2*(1 - nu*(along/norm2(n))**2)/(1 - nu))
            end do
         end do
      end associate
      call waves%filter%apply(factors/waves%filter%gain, pressure, product, heat)
      heat = heat/size(pressure)
   end function heat_of_half_space

   !> Change of the friction over nominal area by a coupling, to first order, in the unit of the pressure; NaN where there is no memory.
   real(dp) function change_on_cells(kernel, coupling, pressure, shear, period, is_quarter) result(change)
      !> The solid below frictionless faces.
      class(kernel_t), intent(in) :: kernel
      !> Poisson's ratio, layer and direction of sliding, with a friction coefficient of 1.
      type(shear_coupling_t), intent(in) :: coupling
      !> Pressure and shear stress in the middles of the cells; shape `(nx, ny)`.
      real(dp), intent(in), contiguous :: pressure(:, :), shear(:, :)
      !> Periods along x and y, in the unit of all lengths of the kernel.
      real(dp), intent(in) :: period(2)
      !> Are the cells a quarter of the period, over which the solid has no losses?
      logical, intent(in) :: is_quarter
      type(waves_t) :: waves
      type(error_t), allocatable :: error
      real(dp), allocatable :: factors(:, :), product(:, :)
      real(dp) :: n(2), along
      integer :: i, j

      change = not_a_number()
      call new_waves(waves, kernel, shape(pressure), period, is_quarter, error)
      if (allocated(error)) return
      allocate (product, mold=pressure)
      allocate (factors(size(waves%n_y), size(waves%n_x)), source=0.0_dp)
      do i = 1, size(factors, 2)
         do j = 1, size(factors, 1)
            n = [waves%n_x(i), waves%n_y(j)]
            if (.not. any(abs(n) > 0)) cycle
            along = dot_product(coupling%direction, n)
            factors(j, i) = -two_pi*along**2/norm2(n)*coupling%coupling_of_wave(norm2(n))*real(1/waves%stiffness(j, i), dp)
         end do
      end do
      call waves%filter%apply(factors/waves%filter%gain, shear, product)
      change = sum(pressure*product)/size(pressure)
   end function change_on_cells

end module adfric_periodic_coupled_losses

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
   implicit none (type, external)
   private
   public :: heat_of_half_space, change_on_cells

contains

   !> Energy lost in a half-space per nominal area and distance, in the unit of the pressure; NaN where there is no memory.
   real(dp) function heat_of_half_space(kernel, pressure, period) result(heat)
      !> The half-space with its coupling.
      type(coupled_kernel_t), intent(in) :: kernel
      !> Pressure in the middles of the cells; shape `(nx, ny)`.
      real(dp), intent(in), contiguous :: pressure(:, :)
      !> Periods along x and y, in the unit of all lengths of the kernel.
      real(dp), intent(in) :: period(2)
      type(spectral_filter_t) :: filter
      type(error_t), allocatable :: error
      complex(dp), allocatable :: stiffness(:, :)
      real(dp), allocatable :: factors(:, :), product(:, :)
      real(dp) :: n(2), along
      integer :: i, j

      heat = not_a_number()
      call new_spectral_filter(filter, size(pressure, 1), size(pressure, 2), .false., .false., error)
      if (allocated(error)) return
      allocate (stiffness(filter%n_modes(2), filter%n_modes(1)), factors(filter%n_modes(2), filter%n_modes(1)))
      allocate (product, mold=pressure)
      call kernel%solid%get_stiffness([((i - 1)/period(1), i=1, size(stiffness, 2))], &
         & [(folded(j - 1, size(pressure, 2))/period(2), j=1, size(stiffness, 1))], period/shape(pressure), stiffness)
      factors = 0
      do i = 1, size(factors, 2)
         do j = 1, size(factors, 1)
            n = [real(i - 1, dp), folded(j - 1, size(pressure, 2))]/period
            if (.not. any(abs(n) > 0)) cycle
            along = dot_product(kernel%coupling%direction, n)
            associate (mu => kernel%coupling%friction_coefficient, nu => kernel%coupling%poisson_ratio)
               factors(j, i) = -two_pi*along*aimag(stiffness(j, i))/abs(stiffness(j, i))**2 &
                  & *(1 + mu**2*(1 - nu*(along/norm2(n))**2)/(1 - nu))
            end associate
         end do
      end do
      call filter%apply(factors/filter%gain, pressure, product, heat)
      heat = heat/size(pressure)
   end function heat_of_half_space

   !> Change of the friction over nominal area by a coupling, to first order, in the unit of the pressure; NaN where there is no memory.
   real(dp) function change_on_cells(kernel, coupling, pressure, shear, period) result(change)
      !> The solid below frictionless faces.
      class(kernel_t), intent(in) :: kernel
      !> Poisson's ratio, layer and direction of sliding, with a friction coefficient of 1.
      type(shear_coupling_t), intent(in) :: coupling
      !> Pressure and shear stress in the middles of the cells; shape `(nx, ny)`.
      real(dp), intent(in), contiguous :: pressure(:, :), shear(:, :)
      !> Periods along x and y, in the unit of all lengths of the kernel.
      real(dp), intent(in) :: period(2)
      type(spectral_filter_t) :: filter
      type(error_t), allocatable :: error
      complex(dp), allocatable :: stiffness(:, :)
      real(dp), allocatable :: factors(:, :), product(:, :)
      real(dp) :: n(2), along
      integer :: i, j

      change = not_a_number()
      call new_spectral_filter(filter, size(pressure, 1), size(pressure, 2), .false., .false., error)
      if (allocated(error)) return
      allocate (stiffness(filter%n_modes(2), filter%n_modes(1)), factors(filter%n_modes(2), filter%n_modes(1)))
      allocate (product, mold=pressure)
      call kernel%get_stiffness([((i - 1)/period(1), i=1, size(stiffness, 2))], &
         & [(folded(j - 1, size(pressure, 2))/period(2), j=1, size(stiffness, 1))], period/shape(pressure), stiffness)
      factors = 0
      do i = 1, size(factors, 2)
         do j = 1, size(factors, 1)
            n = [real(i - 1, dp), folded(j - 1, size(pressure, 2))]/period
            if (.not. any(abs(n) > 0)) cycle
            along = dot_product(coupling%direction, n)
            factors(j, i) = -two_pi*along**2/norm2(n)*coupling%coupling_of_wave(norm2(n))*real(1/stiffness(j, i), dp)
         end do
      end do
      call filter%apply(factors/filter%gain, shear, product)
      change = sum(pressure*product)/size(pressure)
   end function change_on_cells

   !> Number of waves of a mode along the second direction, below 0 for those that run the other way.
   pure real(dp) function folded(mode, n_points)
      !> Number of the mode, from 0, and number of cells.
      integer, intent(in) :: mode, n_points

      folded = merge(mode, mode - n_points, 2*mode <= n_points)
   end function folded

end module adfric_periodic_coupled_losses

! SPDX-License-Identifier: GPL-3.0-or-later
!> The surface of a viscoelastic solid over which a rough body slides steadily, in the frame of the body.
!>
!> The stiffness of a wave is that of the elastic solid of unit modulus times the complex modulus at the frequency with which the wave
!> passes a position of the solid. On cells the history of a position is known cell by cell, and between cells it is taken to be
!> linear (`adfric_solid_sampled_modulus`). The modulus of the wave itself would jump where waves are two cells long, whose
!> direction cannot be told, and such kernels ring: with them the sets of open and closed cells do not settle.
module adfric_periodic_sliding_kernel
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_solid_prony, only: prony_t
   use adfric_solid_sampled_modulus, only: sampled_modulus
   use adfric_periodic_kernel, only: kernel_t
   implicit none (type, external)
   private
   public :: sliding_kernel_t, new_sliding_kernel

   !> A viscoelastic solid that passes below a body.
   type, extends(kernel_t) :: sliding_kernel_t
      !> The elastic solid of unit modulus.
      class(kernel_t), allocatable :: solid
      !> Relaxation spectrum; pressures are in its unit.
      type(prony_t) :: prony
      !> Velocity of the body [length/s], > 0.
      real(dp) :: velocity = 0
      !> Its way from cell to cell, along x and along y.
      integer :: steps(2) = [1, 0]
   contains
      procedure :: get_stiffness
      procedure :: mean_compliance
   end type sliding_kernel_t

contains

   !> Set up a kernel.
   pure subroutine new_sliding_kernel(self, solid, prony, velocity, steps)
      type(sliding_kernel_t), intent(out) :: self
      class(kernel_t), intent(in) :: solid
      type(prony_t), intent(in) :: prony
      !> Velocity of the body in the unit of lengths per second, >= 0; with the shift of times by temperature.
      real(dp), intent(in) :: velocity
      !> Its way from cell to cell, along x and along y: -1, 0 or 1, not both 0. Along diagonals it goes from corner to corner.
      integer, intent(in) :: steps(2)

      allocate (self%solid, source=solid)
      self%prony = prony
      self%velocity = velocity
      self%steps = steps
   end subroutine new_sliding_kernel

   !> See `kernel_t`.
   pure subroutine get_stiffness(self, n_x, n_y, cell_size, stiffness)
      class(sliding_kernel_t), intent(in) :: self
      !> Numbers of waves per length along x and along y.
      real(dp), intent(in) :: n_x(:), n_y(:)
      !> Size of the cells, between whose middles displacements are linear along the motion.
      real(dp), intent(in) :: cell_size(2)
      !> Receives the stiffness of each pair of numbers; shape `(size(n_y), size(n_x))`.
      complex(dp), intent(out) :: stiffness(:, :)
      real(dp) :: step
      integer :: i, j

      call self%solid%get_stiffness(n_x, n_y, cell_size, stiffness)
      step = norm2(self%steps*cell_size)
      if (self%steps(2) == 0) then
         do i = 1, size(n_x)
            stiffness(:, i) = stiffness(:, i)*modulus_of(self, self%steps(1)*n_x(i)*cell_size(1), step)
         end do
      else
         do i = 1, size(n_x)
            do j = 1, size(n_y)
               stiffness(j, i) = stiffness(j, i)*modulus_of(self, dot_product(self%steps, [n_x(i), n_y(j)]*cell_size), step)
            end do
         end do
      end if
   end subroutine get_stiffness

   !> See `kernel_t`: that of the relaxed solid, at any velocity.
   pure real(dp) function mean_compliance(self)
      class(sliding_kernel_t), intent(in) :: self

      mean_compliance = self%solid%mean_compliance()/self%prony%relaxed
   end function mean_compliance

   !> Modulus that a wave meets.
   pure complex(dp) function modulus_of(self, n, step) result(modulus)
      class(sliding_kernel_t), intent(in) :: self
      !> Number of waves on the way from cell to cell.
      real(dp), intent(in) :: n
      !> Length of that way.
      real(dp), intent(in) :: step
      !> Numbers of waves are multiples of 1 over a number of cells; what is closer to a whole or a half one is that.
      real(dp), parameter :: round_off = 1.0e-12_dp
      real(dp) :: rest

      modulus = self%prony%relaxed
      ! slower than numbers go is at rest
      if (.not. self%velocity > step/sqrt(huge(1.0_dp))) return
      ! waves that look alike along the motion meet the same
      rest = n - nint(n)
      if (abs(rest) < round_off) return
      modulus = sampled_modulus(self%prony, step/self%velocity, two_pi*rest)
      ! a wave of two cells has no direction
      if (abs(abs(rest) - 0.5_dp) < round_off) modulus = real(modulus, dp)
   end function modulus_of

end module adfric_periodic_sliding_kernel

!> The surface of a viscoelastic solid over which a rough body slides steadily, in the frame of the body.
!>
!> The stiffness of a wave is that of the elastic solid of unit modulus times the complex modulus at the frequency with which the wave
!> passes a place of the solid. On cells the history of a place is known cell by cell, and between cells it is taken to be linear
!> (`adfric_material_sampled_modulus`). The modulus of the wave itself would jump where waves are two cells long, whose direction
!> cannot be told, and such kernels ring: with them the sets of open and closed cells do not settle.
module adfric_periodic_sliding_kernel
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_material_prony, only: prony_t
   use adfric_material_sampled_modulus, only: sampled_modulus
   use adfric_periodic_kernel, only: kernel_t
   implicit none (type, external)
   private
   public :: sliding_kernel_t, new_sliding_kernel

   !> A viscoelastic solid that passes below a body.
   type, extends(kernel_t) :: sliding_kernel_t
      private
      !> The elastic solid of unit modulus.
      class(kernel_t), allocatable :: solid
      !> Relaxation spectrum; pressures are in its unit.
      type(prony_t) :: prony
      !> Velocity of the body [length/s], > 0.
      real(dp) :: velocity = 0
      !> Direction of its motion: 1 along x, 2 along y.
      integer :: along = 1
      !> Does it move the other way?
      logical :: is_backward = .false.
   contains
      procedure :: get_stiffness
      procedure :: mean_compliance
   end type sliding_kernel_t

contains

   !> Set up a kernel.
   pure subroutine new_sliding_kernel(self, solid, prony, velocity, along, is_backward)
      !> The kernel.
      type(sliding_kernel_t), intent(out) :: self
      !> The elastic solid of unit modulus.
      class(kernel_t), intent(in) :: solid
      !> Relaxation spectrum; pressures are in its unit.
      type(prony_t), intent(in) :: prony
      !> Velocity of the body in the unit of lengths per second, >= 0; with the shift of times by temperature.
      real(dp), intent(in) :: velocity
      !> Direction of its motion: 1 along x, 2 along y.
      integer, intent(in) :: along
      !> Does it move towards lower x or y?
      logical, intent(in) :: is_backward

      allocate (self%solid, source=solid)
      self%prony = prony
      self%velocity = velocity
      self%along = along
      self%is_backward = is_backward
   end subroutine new_sliding_kernel

   !> See `kernel_t`.
   pure subroutine get_stiffness(self, n_x, n_y, cell_size, stiffness)
      !> The solid and the motion.
      class(sliding_kernel_t), intent(in) :: self
      !> Numbers of waves per length along x and along y.
      real(dp), intent(in) :: n_x(:), n_y(:)
      !> Size of the cells, between whose middles displacements are linear along the motion.
      real(dp), intent(in) :: cell_size(2)
      !> Receives the stiffness of each pair of numbers; shape `(size(n_y), size(n_x))`.
      complex(dp), intent(out) :: stiffness(:, :)
      integer :: i

      call self%solid%get_stiffness(n_x, n_y, cell_size, stiffness)
      if (self%along == 1) then
         do i = 1, size(n_x)
            stiffness(:, i) = stiffness(:, i)*modulus_of(self, n_x(i), cell_size(1))
         end do
      else
         do i = 1, size(n_y)
            stiffness(i, :) = stiffness(i, :)*modulus_of(self, n_y(i), cell_size(2))
         end do
      end if
   end subroutine get_stiffness

   !> See `kernel_t`: that of the relaxed solid, at any velocity.
   pure real(dp) function mean_compliance(self)
      !> The solid and the motion.
      class(sliding_kernel_t), intent(in) :: self

      mean_compliance = self%solid%mean_compliance()/self%prony%relaxed
   end function mean_compliance

   !> Modulus that a wave along the motion meets.
   pure complex(dp) function modulus_of(self, n, cell_size) result(modulus)
      !> The solid and the motion.
      class(sliding_kernel_t), intent(in) :: self
      !> Number of waves per length along the motion.
      real(dp), intent(in) :: n
      !> Size of a cell along the motion.
      real(dp), intent(in) :: cell_size
      real(dp) :: phase, interval

      modulus = self%prony%relaxed
      ! slower than numbers go is at rest
      if (.not. self%velocity > cell_size/sqrt(huge(1.0_dp))) return
      interval = cell_size/self%velocity
      phase = two_pi*n*cell_size
      if (self%is_backward) phase = -phase
      modulus = sampled_modulus(self%prony, interval, phase)
      ! a wave of two cells has no direction
      if (abs(abs(n)*cell_size - 0.5_dp) < epsilon(1.0_dp)) modulus = real(modulus, dp)
   end function modulus_of

end module adfric_periodic_sliding_kernel

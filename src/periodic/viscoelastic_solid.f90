! SPDX-License-Identifier: GPL-3.0-or-later
!> The viscoelastic half-space or layer over which a rough surface slides, with what is known of it in closed form.
!>
!> The wave exp(ik.x) of displacements has the pressure E(-k.V) |k|/2F, with the complex modulus E(omega) and the factor F of the
!> solid's thickness (`adfric_periodic_layer_kernel`), and over that of the coupling where shear moves the surface
!> (`adfric_periodic_coupled_kernel`). In full contact displacements are heights, and so all is known.
module adfric_periodic_viscoelastic_solid
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_solid_prony, only: prony_t, new_prony
   use adfric_periodic_coupled_kernel, only: coupled_kernel_t, shear_coupling_t
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_kernel, only: kernel_t
   use adfric_periodic_layer_kernel, only: layer_kernel_t
   use adfric_periodic_near_contact, only: near_steps
   use adfric_periodic_point, only: periodic_solid_t
   use adfric_periodic_sliding_kernel, only: sliding_kernel_t, new_sliding_kernel
   implicit none (type, external)
   private
   public :: viscoelastic_solid_t, motion_t, set_viscoelastic_solid

   !> How the body moves.
   type :: motion_t
      !> Velocity times the shift factor of the times [m/s], >= 0.
      real(dp) :: velocity = 0
      !> Its way from cell to cell, along x and along y: -1, 0 or 1.
      integer :: steps(2) = [1, 0]
      !> Does the surface vary along x, and along y?
      logical :: varies(2) = .true.
   contains
      procedure :: direction
   end type motion_t

   !> A viscoelastic solid below a moving body.
   type, extends(periodic_solid_t) :: viscoelastic_solid_t
      !> Spectrum of the contact modulus [E0, s].
      type(prony_t) :: prony
      !> Velocity [periods along x/s] and direction.
      type(motion_t) :: motion
      !> Elastic solid of unit modulus, with lengths in periods along x.
      class(kernel_t), allocatable :: elastic
      !> What shear does to the surface, with lengths in periods along x; not allocated: nothing.
      type(shear_coupling_t), allocatable :: coupling
   contains
      procedure :: stiffness_of_wave
      procedure :: losses_of_wave
      procedure :: forward
      procedure :: leftward
   end type viscoelastic_solid_t

contains

   !> Set up a solid.
   subroutine set_viscoelastic_solid(self, prony, motion, length, layer, coupling)
      !> Receives the solid, with its kernel.
      type(viscoelastic_solid_t), intent(out) :: self
      !> Spectrum of the contact modulus [Pa, s].
      type(prony_t), intent(in) :: prony
      type(motion_t), intent(in) :: motion
      !> Period along x [m], the unit of lengths.
      real(dp), intent(in) :: length
      !> Thickness [m], base and Poisson's ratio of the layer; absent: a half-space.
      type(layer_kernel_t), intent(in), optional :: layer
      !> Friction coefficient and Poisson's ratio where shear moves the surface; absent: it does not.
      type(shear_coupling_t), intent(in), optional :: coupling
      type(layer_kernel_t) :: reduced
      type(sliding_kernel_t), allocatable :: kernel, other
      real(dp) :: velocity
      integer :: k

      self%modulus = prony%relaxed
      call new_prony(self%prony, 1.0_dp, prony%moduli/prony%relaxed, prony%times)
      self%motion = motion
      self%motion%velocity = motion%velocity/length
      if (present(layer)) then
         reduced = layer
         reduced%thickness = layer%thickness/length
         allocate (self%elastic, source=reduced)
      else
         allocate (self%elastic, source=elastic_kernel_t())
      end if
      ! at rest, and along what does not vary, the solid is elastic, and its stiffness is real
      associate (along => merge(motion%direction(), 0.0_dp, motion%varies))
         velocity = self%motion%velocity*norm2(along)
      end associate
      if (velocity > 0 .and. size(self%prony%times) > 0) then
         allocate (kernel)
         call new_sliding_kernel(kernel, self%elastic, self%prony, velocity, merge(motion%steps, 0, motion%varies))
         allocate (self%near_kernels(size(near_steps)))
         do k = 1, size(near_steps)
            allocate (other, source=kernel)
            other%velocity = velocity*exp(near_steps(k))
            call move_alloc(other, self%near_kernels(k)%kernel)
         end do
         call move_alloc(kernel, self%kernel)
      else
         allocate (self%kernel, source=self%elastic)
      end if
      self%numbers = [reduced%thickness, reduced%poisson_ratio, merge(1.0_dp, 0.0_dp, [present(layer), reduced%is_bonded, &
         & motion%varies]), real(motion%steps, dp), self%motion%velocity, self%prony%moduli, self%prony%times]
      if (present(coupling)) call couple(self, coupling, reduced)
   end subroutine set_viscoelastic_solid

   !> Let shear move the surface.
   subroutine couple(self, coupling, layer)
      !> In: the solid with its kernel. Out: with that of the coupling around it.
      type(viscoelastic_solid_t), intent(inout) :: self
      !> Friction coefficient and Poisson's ratio.
      type(shear_coupling_t), intent(in) :: coupling
      !> The layer with lengths in periods along x; counts where it is bonded.
      type(layer_kernel_t), intent(in) :: layer
      type(coupled_kernel_t), allocatable :: kernel
      integer :: k

      self%coupling = coupling
      self%coupling%thickness = 0
      if (layer%is_bonded) self%coupling%thickness = layer%thickness
      self%coupling%direction = self%motion%direction()
      allocate (kernel)
      call move_alloc(self%kernel, kernel%solid)
      kernel%coupling = self%coupling
      call move_alloc(kernel, self%kernel)
      if (allocated(self%near_kernels)) then
         do k = 1, size(self%near_kernels)
            allocate (kernel)
            call move_alloc(self%near_kernels(k)%kernel, kernel%solid)
            kernel%coupling = self%coupling
            call move_alloc(kernel, self%near_kernels(k)%kernel)
         end do
      end if
      self%numbers = [self%numbers, coupling%friction_coefficient, coupling%poisson_ratio]
   end subroutine couple

   !> Stiffness of a wave, whatever the cells [E0/period along x].
   pure complex(dp) function stiffness_of_wave(self, waves) result(stiffness)
      class(viscoelastic_solid_t), intent(in) :: self
      !> Number of waves in a period along x, along x and y.
      real(dp), intent(in) :: waves(2)
      complex(dp) :: elastic(1, 1)
      real(dp) :: storage, loss, along

      call self%elastic%get_stiffness(waves(1:1), waves(2:2), [0.0_dp, 0.0_dp], elastic)
      along = self%forward(waves)
      call self%prony%get_complex_modulus(two_pi*abs(along)*self%motion%velocity, storage, loss)
      stiffness = elastic(1, 1)*cmplx(storage, -sign(loss, along), dp)
      if (allocated(self%coupling)) stiffness = stiffness*self%coupling%factor_of(waves, [0.0_dp, 0.0_dp])
   end function stiffness_of_wave

   !> Stress along x and y that a wave holds the body back with in full contact, k (-Im A) D^2/2 [E0].
   pure function losses_of_wave(self, waves, amplitude) result(losses)
      class(viscoelastic_solid_t), intent(in) :: self
      !> Number of waves in a period along x, along x and y.
      real(dp), intent(in) :: waves(2)
      !> Amplitude D [periods along x].
      real(dp), intent(in) :: amplitude
      real(dp) :: losses(2)

      losses = two_pi*waves*(-aimag(self%stiffness_of_wave(waves)))*amplitude**2/2
   end function losses_of_wave

   !> Component along the motion of a vector.
   pure real(dp) function forward(self, vector)
      class(viscoelastic_solid_t), intent(in) :: self
      !> Components along x and y.
      real(dp), intent(in) :: vector(2)

      forward = dot_product(self%motion%direction(), vector)
   end function forward

   !> Component of a vector to the left of the motion, seen from above the solid's surface with x to the right and y upward.
   pure real(dp) function leftward(self, vector)
      class(viscoelastic_solid_t), intent(in) :: self
      !> Components along x and y.
      real(dp), intent(in) :: vector(2)

      associate (e => self%motion%direction())
         leftward = e(1)*vector(2) - e(2)*vector(1)
      end associate
   end function leftward

   !> Vector of length 1 along the motion; cells are as long as wide where it is a diagonal.
   pure function direction(self)
      class(motion_t), intent(in) :: self
      real(dp) :: direction(2)

      direction = self%steps/norm2(real(self%steps, dp))
   end function direction

end module adfric_periodic_viscoelastic_solid

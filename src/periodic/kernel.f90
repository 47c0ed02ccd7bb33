! SPDX-License-Identifier: GPL-3.0-or-later
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
      procedure(get_stiffness_i), deferred :: get_stiffness
      procedure :: mean_compliance
      procedure :: orders_states
      procedure :: stretch_of_zone
   end type kernel_t

   abstract interface

      !> Pressure over displacement of the waves exp(2 pi i n.x). It is complex where the displacement lags behind the pressure, as
      !> under a viscoelastic solid that slides; the wave -n has the conjugate stiffness, and its real part is positive. A surface
      !> without waves, n = 0, has none: its stiffness is 0.
      pure subroutine get_stiffness_i(self, n_x, n_y, cell_size, stiffness)
         import :: kernel_t, dp
         implicit none (type, external)
         !> The surface of the solid.
         class(kernel_t), intent(in) :: self
         !> Numbers of waves per length along x and along y.
         real(dp), intent(in) :: n_x(:), n_y(:)
         !> Size of the cells that have the waves; a kernel may depend on it that takes fields to be linear between cells.
         real(dp), intent(in) :: cell_size(2)
         !> Receives the stiffness of each pair of numbers; shape `(size(n_y), size(n_x))`.
         complex(dp), intent(out) :: stiffness(:, :)
      end subroutine get_stiffness_i

   end interface

contains

   !> Mean displacement over mean pressure [length over unit of pressure]: 0, that of a half-space, whose mean displacement is not
   !> defined. A layer overrides it.
   pure real(dp) function mean_compliance(self)
      !> The surface of the solid; nothing is read from it here.
      class(kernel_t), intent(in) :: self

      mean_compliance = 0
      associate (unused => self)
      end associate
   end function mean_compliance

   !> Do adhesive states have an order, so that steps which find no state prove that there is none? A layer overrides it.
   pure logical function orders_states(self)
      !> The surface of the solid; nothing is read from it here.
      class(kernel_t), intent(in) :: self

      orders_states = .true.
      associate (unused => self)
      end associate
   end function orders_states

   !> Length of a short zone of adhesion over that on a half-space of the same modulus. A layer overrides it.
   pure real(dp) function stretch_of_zone(self, on_half_space, longest) result(stretch)
      !> The surface of the solid; nothing is read from it here.
      class(kernel_t), intent(in) :: self
      !> That length on a half-space, and the most that it can be here, in the unit of the kernel's lengths, > 0.
      real(dp), intent(in) :: on_half_space, longest

      stretch = 1
      associate (unused => self, unused_length => on_half_space, unused_longest => longest)
      end associate
   end function stretch_of_zone

end module adfric_periodic_kernel

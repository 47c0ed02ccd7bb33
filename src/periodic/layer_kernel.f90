! SPDX-License-Identifier: GPL-3.0-or-later
!> The surface of an elastic layer on a rigid base, or of a coating on an elastic half-space: pressure over displacement is
!> E* |k|/(2 F(|k| H)), H the thickness and E* the contact modulus of the layer, with F of `adfric_solid_layer_compliance`.
module adfric_periodic_layer_kernel
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_periodic_kernel, only: kernel_t
   use adfric_solid_layer_compliance, only: coating_t, deep, factor_of_bonded, factor_of_coating, factor_of_frictionless, &
      & mean_factor_of_bonded
   implicit none (type, external)
   private
   public :: layer_kernel_t, compliance_factor

   !> Ratio of lengths between which a zone is sought, and bisections there.
   real(dp), parameter :: ratio_of_lengths = 1.02_dp
   integer, parameter :: most_bisections = 60

   !> An elastic layer, with pressures in units of its contact modulus E*.
   type, extends(kernel_t) :: layer_kernel_t
      !> Thickness H, in the unit of all lengths, > 0.
      real(dp) :: thickness = 1
      !> Is the layer bonded to its rigid base? Else it slips there without friction.
      logical :: is_bonded = .false.
      !> Poisson's ratio, of the bonded layer alone [-].
      real(dp) :: poisson_ratio = 0.5_dp
      !> The layer as a coating of a half-space; not allocated: its base is rigid.
      type(coating_t), allocatable :: coating
   contains
      procedure :: get_stiffness
      procedure :: mean_compliance
      procedure :: orders_states
      procedure :: stretch_of_zone
      procedure :: zone_length
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

   !> Mean displacement over mean pressure [length/E*]: H over a frictionless base, H (1 - 2 nu)/(1 - nu)^2 of a bonded layer, and 0 of a
   !> coating, whose half-space has none.
   pure real(dp) function mean_compliance(self)
      class(layer_kernel_t), intent(in) :: self

      mean_compliance = self%thickness
      if (self%is_bonded) mean_compliance = self%thickness*mean_factor_of_bonded(self%poisson_ratio)
      if (allocated(self%coating)) mean_compliance = 0
   end function mean_compliance

   !> See `kernel_t`: entries of the stiffness off its diagonal are above 0, so that no order is proved (docs/theory/layers.md).
   pure logical function orders_states(self)
      class(layer_kernel_t), intent(in) :: self

      orders_states = .false.
      associate (unused => self)
      end associate
   end function orders_states

   !> See `kernel_t`.
   pure real(dp) function stretch_of_zone(self, on_half_space, longest) result(stretch)
      class(layer_kernel_t), intent(in) :: self
      !> That length on a half-space, and the most that it can be, in the unit of the thickness.
      real(dp), intent(in) :: on_half_space, longest

      stretch = self%zone_length(on_half_space, longest)/on_half_space
   end function stretch_of_zone

   !> Length l of a short zone of adhesion. On a half-space it is pi E* h0/(4 p0). Here the modulus is E*/F(2 H/l), that of waves
   !> with the wave number 2/l, so that l F(2 H/l) is that length. The least l counts.
   pure real(dp) function zone_length(self, on_half_space, longest) result(length)
      class(layer_kernel_t), intent(in) :: self
      !> pi E* h0/(4 p0) with the modulus of the layer, in the unit of its thickness, > 0.
      real(dp), intent(in) :: on_half_space
      !> The most that the length can be, that of the period; it is this, too, where no zone is short.
      real(dp), intent(in) :: longest
      real(dp) :: shorter
      integer :: k

      ! up to here the zone does not feel the base
      shorter = 2*self%thickness/deep
      length = min(on_half_space, longest)
      if (length <= shorter) return
      do
         length = min(ratio_of_lengths*shorter, longest)
         if (reaches(length)) exit
         if (length >= longest) return
         shorter = length
      end do
      do k = 1, most_bisections
         associate (middle => (shorter + length)/2)
            if (reaches(middle)) then
               length = middle
            else
               shorter = middle
            end if
         end associate
      end do

   contains

      !> Is a length that of the zone, or longer?
      pure logical function reaches(l)
         real(dp), intent(in) :: l

         reaches = l*compliance_factor(self, 2*self%thickness/l) >= on_half_space
      end function reaches

   end function zone_length

   !> F(Q): the compliance over that of a half-space.
   pure real(dp) function compliance_factor(self, q) result(factor)
      class(layer_kernel_t), intent(in) :: self
      !> Wave number times thickness [-], > 0.
      real(dp), intent(in) :: q

      if (allocated(self%coating)) then
         factor = factor_of_coating(q, self%coating)
      else if (self%is_bonded) then
         factor = factor_of_bonded(q, self%poisson_ratio)
      else
         factor = factor_of_frictionless(q)
      end if
   end function compliance_factor

end module adfric_periodic_layer_kernel

! SPDX-License-Identifier: GPL-3.0-or-later
!> Largest shear stress and largest von Mises stress on the axis under a contact.
module adfric_plane_largest_shear
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: axial_stress_t, find_largest_shear, find_largest_von_mises

   !> Something with principal stresses along its axis.
   type, abstract :: axial_stress_t
   contains
      procedure(stress_at_i), deferred :: stress_at
   end type axial_stress_t

   abstract interface
      !> Principal stresses at a depth >= 0.
      pure function stress_at_i(self, depth) result(stress)
         import :: axial_stress_t, dp
         implicit none (type, external)
         !> Field whose stresses are evaluated.
         class(axial_stress_t), intent(in) :: self
         !> Depth on the axis, >= 0, in the unit of length of the field.
         real(dp), intent(in) :: depth
         real(dp) :: stress(3)
      end function stress_at_i
   end interface

contains

   !> Find the largest shear stress.
   pure subroutine find_largest_shear(field, unit, depth, shear)
      !> Field whose principal stresses on the axis are compared.
      class(axial_stress_t), intent(in) :: field
      !> Smallest length of the contact, > 0; the largest shear stress is sought from the surface to 20 times this depth.
      real(dp), intent(in) :: unit
      !> Depth of the largest shear stress, in the unit of length of the field.
      real(dp), intent(out) :: depth
      !> Largest shear stress, in the unit of stress of the field.
      real(dp), intent(out) :: shear

      call find_largest(field, .false., unit, depth, shear)
   end subroutine find_largest_shear

   !> Find the largest von Mises stress.
   pure subroutine find_largest_von_mises(field, unit, depth, stress)
      !> Field whose principal stresses on the axis are compared.
      class(axial_stress_t), intent(in) :: field
      !> Smallest length of the contact, > 0; the largest stress is sought from the surface to 20 times this depth.
      real(dp), intent(in) :: unit
      !> Depth of the largest von Mises stress, in the unit of length of the field.
      real(dp), intent(out) :: depth
      !> Largest von Mises stress, in the unit of stress of the field.
      real(dp), intent(out) :: stress

      call find_largest(field, .true., unit, depth, stress)
   end subroutine find_largest_von_mises

   !> Find the largest value of a measure by samples, whose steps grow with the depth as the stress varies more slowly there, and then by
   !> the golden section. Its depth is known to the root of round-off only, for the stress is level there.
   pure subroutine find_largest(field, is_von_mises, unit, depth, largest)
      class(axial_stress_t), intent(in) :: field
      !> Is it the von Mises stress, or else the largest shear stress?
      logical, intent(in) :: is_von_mises
      real(dp), intent(in) :: unit
      real(dp), intent(out) :: depth, largest
      real(dp), parameter :: golden = 0.61803398874989484820_dp, step = 0.05_dp
      !> 20 even steps, and 62 that grow: 1.05^62 > 20.
      integer, parameter :: n_samples = 82, n_cuts = 36
      real(dp) :: z(0:n_samples + 1), samples(0:n_samples), left, right, inner, outer, inner_value, outer_value
      integer :: i

      z(0) = 0
      samples(0) = measure_at(field, is_von_mises, z(0))
      do i = 1, n_samples
         z(i) = z(i - 1) + step*max(unit, z(i - 1))
         samples(i) = measure_at(field, is_von_mises, z(i))
      end do
      z(n_samples + 1) = z(n_samples)*(1 + step)
      i = maxloc(samples, 1) - 1
      left = z(max(0, i - 1))
      right = z(i + 1)
      inner = right - golden*(right - left)
      outer = left + golden*(right - left)
      inner_value = measure_at(field, is_von_mises, inner)
      outer_value = measure_at(field, is_von_mises, outer)
      do i = 1, n_cuts
         if (inner_value < outer_value) then
            left = inner
            inner = outer
            inner_value = outer_value
            outer = left + golden*(right - left)
            outer_value = measure_at(field, is_von_mises, outer)
         else
            right = outer
            outer = inner
            outer_value = inner_value
            inner = right - golden*(right - left)
            inner_value = measure_at(field, is_von_mises, inner)
         end if
      end do
      depth = (left + right)/2
      largest = measure_at(field, is_von_mises, depth)
      if (largest > samples(0)) return
      depth = 0
      largest = samples(0)
   end subroutine find_largest

   !> Half the difference of the largest and the least principal stress, or the von Mises stress.
   pure real(dp) function measure_at(field, is_von_mises, depth) result(value)
      class(axial_stress_t), intent(in) :: field
      logical, intent(in) :: is_von_mises
      !> Depth on the axis, >= 0, in the unit of length of the field.
      real(dp), intent(in) :: depth
      real(dp) :: stress(3)

      stress = field%stress_at(depth)
      if (is_von_mises) then
         value = norm2(stress - cshift(stress, 1))/sqrt(2.0_dp)
      else
         value = (maxval(stress) - minval(stress))/2
      end if
   end function measure_at

end module adfric_plane_largest_shear

!> Largest shear stress on the axis under a contact.
module adfric_halfspace_largest_shear
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: axial_stress_t, find_largest_shear

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
         class(axial_stress_t), intent(in) :: self
         real(dp), intent(in) :: depth
         real(dp) :: stress(3)
      end function stress_at_i
   end interface

contains

   !> By samples and then by the golden section; a place is known to the root of round-off only, for there the stress is level.
   pure subroutine find_largest_shear(field, unit, depth, shear)
      class(axial_stress_t), intent(in) :: field
      !> Smallest length of the contact; the largest shear is above 20 times it.
      real(dp), intent(in) :: unit
      real(dp), intent(out) :: depth
      real(dp), intent(out) :: shear
      real(dp), parameter :: golden = 0.61803398874989484820_dp, step = 0.05_dp
      integer, parameter :: n_samples = 400, n_cuts = 42
      real(dp) :: left, right, inner, outer, samples(0:n_samples)
      integer :: i

      samples = [(shear_at(field, i*step*unit), i=0, n_samples)]
      i = maxloc(samples, 1) - 1
      left = max(0, i - 1)*step*unit
      right = (i + 1)*step*unit
      do i = 1, n_cuts
         inner = right - golden*(right - left)
         outer = left + golden*(right - left)
         if (shear_at(field, inner) < shear_at(field, outer)) then
            left = inner
         else
            right = outer
         end if
      end do
      depth = (left + right)/2
      shear = shear_at(field, depth)
      if (shear > samples(0)) return
      depth = 0
      shear = samples(0)
   end subroutine find_largest_shear

   !> Half the difference of the largest and the least principal stress.
   pure real(dp) function shear_at(field, depth)
      class(axial_stress_t), intent(in) :: field
      real(dp), intent(in) :: depth
      real(dp) :: stress(3)

      stress = field%stress_at(depth)
      shear_at = (maxval(stress) - minval(stress))/2
   end function shear_at

end module adfric_halfspace_largest_shear

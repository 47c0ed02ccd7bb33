! SPDX-License-Identifier: GPL-3.0-or-later
!> A shear stress given over the velocity: a cubic between neighbours in log v and log tau that goes no further up or down than its
!> samples, by Steffen's slopes.
module adfric_interface_strength_table
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   implicit none (type, external)
   private
   public :: strength_table_t, new_strength_table

   !> Samples in rising order of the velocity.
   type :: strength_table_t
      !> Logarithms of velocities [m/s] and stresses [Pa], and the slopes between both; shape `(n)`; not allocated without a table.
      real(dp), allocatable :: log_velocities(:), log_stresses(:), slopes(:)
   contains
      procedure :: covers
      procedure :: look_up
   end type strength_table_t

contains

   !> A table of samples.
   pure subroutine new_strength_table(self, velocities, stresses)
      type(strength_table_t), intent(out) :: self
      !> Velocities, rising [m/s], > 0; shape `(n)`, n > 1.
      real(dp), intent(in) :: velocities(:)
      !> Shear stresses [Pa], > 0; shape `(n)`.
      real(dp), intent(in) :: stresses(:)
      real(dp) :: steps(size(velocities) - 1), rises(size(velocities) - 1), mean
      integer :: i, n

      n = size(velocities)
      if (has_asserts) call assert(n > 1 .and. size(stresses) == n, 'new_strength_table: two samples, equal sizes')
      if (has_asserts) call assert(all(velocities > 0) .and. all(stresses > 0) .and. all(velocities(2:) > velocities(:n - 1)), &
         & 'new_strength_table: velocities rising, both > 0')
      self%log_velocities = log(velocities)
      self%log_stresses = log(stresses)
      steps = self%log_velocities(2:) - self%log_velocities(:n - 1)
      rises = (self%log_stresses(2:) - self%log_stresses(:n - 1))/steps
      allocate (self%slopes(n))
      self%slopes([1, n]) = rises([1, n - 1])
      do i = 2, n - 1
         ! that of the parabola through three samples, unless it leads beyond them
         mean = (rises(i - 1)*steps(i) + rises(i)*steps(i - 1))/(steps(i - 1) + steps(i))
         self%slopes(i) = (sign(1.0_dp, rises(i - 1)) + sign(1.0_dp, rises(i)))*min(abs(rises(i - 1)), abs(rises(i)), abs(mean)/2)
      end do
   end subroutine new_strength_table

   !> Does the table reach to a velocity?
   pure logical function covers(self, log_velocity)
      class(strength_table_t), intent(in) :: self
      !> Logarithm of the velocity [m/s].
      real(dp), intent(in) :: log_velocity
      ! an end of the table, times a factor and over it, is that end
      real(dp), parameter :: rounding = 1.0e-12_dp

      associate (v => self%log_velocities)
         covers = log_velocity >= v(1) - rounding .and. log_velocity <= v(size(v)) + rounding
      end associate
   end function covers

   !> The stress at a velocity of the table.
   pure subroutine look_up(self, log_velocity, log_stress, slope)
      class(strength_table_t), intent(in) :: self
      !> Logarithm of the velocity [m/s].
      real(dp), intent(in) :: log_velocity
      !> Logarithm of the shear stress [Pa], and its slope over `log_velocity` [-].
      real(dp), intent(out) :: log_stress, slope
      real(dp) :: step, rise, x, quadratic, cubic
      integer :: first, last, middle

      first = 1
      last = size(self%log_velocities)
      do while (last - first > 1)
         middle = (first + last)/2
         if (self%log_velocities(middle) > log_velocity) then
            last = middle
         else
            first = middle
         end if
      end do
      step = self%log_velocities(last) - self%log_velocities(first)
      rise = (self%log_stresses(last) - self%log_stresses(first))/step
      x = log_velocity - self%log_velocities(first)
      quadratic = (3*rise - 2*self%slopes(first) - self%slopes(last))/step
      cubic = (self%slopes(first) + self%slopes(last) - 2*rise)/step**2
      log_stress = self%log_stresses(first) + x*(self%slopes(first) + x*(quadratic + x*cubic))
      slope = self%slopes(first) + x*(2*quadratic + 3*x*cubic)
   end subroutine look_up

end module adfric_interface_strength_table

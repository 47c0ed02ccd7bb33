! SPDX-License-Identifier: GPL-3.0-or-later
!> Maugis's theory as one first writes it: Newton's method in m = c/a on J 2.12 at a given radius, in double precision.
!> For comparison only.
module plain_dugdale
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: solve_plain

   !> Of the last step, after which the error is round-off.
   real(dp), parameter :: tolerance = 1.0e-10_dp
   integer, parameter :: max_steps = 60

contains

   !> Load and approach at a radius; X = 1.
   pure subroutine solve_plain(lambda, radius, load, approach, is_converged)
      real(dp), intent(in) :: lambda, radius
      real(dp), intent(out) :: load, approach
      logical, intent(out) :: is_converged
      real(dp) :: m, value, slope, step, root
      integer :: k

      ! the first guess is above
      m = 2
      do k = 1, max_steps
         call evaluate(lambda, radius, m, value, slope)
         if (.not. value < 0) exit
         m = 10*m
      end do
      is_converged = .false.
      do k = 1, max_steps
         step = -value/slope
         if (.not. m + step > 1) step = (1 - m)/2
         m = m + step
         is_converged = abs(step) <= tolerance*m
         if (is_converged .or. .not. m > 1) exit
         call evaluate(lambda, radius, m, value, slope)
      end do
      is_converged = is_converged .and. m > 1
      root = sqrt(max(m*m - 1, 0.0_dp))
      load = radius**3 - lambda*radius**2*(root + m*m*acos(min(1/m, 1.0_dp)))
      approach = radius**2 - 4*lambda*radius*root/3
   end subroutine solve_plain

   !> J 2.12, and its derivative by m.
   pure subroutine evaluate(lambda, a, m, value, slope)
      real(dp), intent(in) :: lambda, a, m
      real(dp), intent(out) :: value, slope
      real(dp) :: root, angle

      root = sqrt(m*m - 1)
      angle = acos(1/m)
      value = lambda*a**2*((m*m - 2)*angle + root)/2 + 4*lambda**2*a*(root*angle - m + 1)/3 - 1
      slope = lambda*a**2*(m*angle + root/m) + 4*lambda**2*a*(m*angle/root + 1/m - 1)/3
   end subroutine evaluate

end module plain_dugdale

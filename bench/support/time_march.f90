! SPDX-License-Identifier: GPL-3.0-or-later
!> One period of a strip followed in equal steps of time, and the forces that its steps add up to: what a
!> general simulation would do. Backward differences, of first order. For comparison only.
module time_stepping
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_foundation_column, only: get_column
   use adfric_foundation_strip, only: strip_t, steady_state_t, regime_free
   implicit none (type, external)
   private
   public :: stepping_forces

   integer, parameter :: in_contact = 1, in_adhesion = 2, is_free = 3

contains

   !> Load and friction over the phases of one period, from the column of a state.
   pure subroutine stepping_forces(strip, state, steps, load, friction)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      integer, intent(in) :: steps
      real(dp), intent(out) :: load, friction
      real(dp) :: xi, h, w, p, level
      integer :: zone, k

      h = two_pi/steps
      ! begin in the middle of what is open, if anything is
      xi = state%shift + two_pi/2
      call get_column(strip, state, xi, w, p)
      zone = is_free
      if (p < -strip%adhesion%stress/2) zone = in_adhesion
      if (w <= strip%mean + cos(xi)) zone = in_contact
      load = 0
      friction = 0
      do k = 1, steps
         xi = xi - h
         level = strip%mean + cos(xi)
         call step_column(strip, h, level, w, p, zone)
         load = load + h*p
         friction = friction + h*p*sin(xi)
      end do
   end subroutine stepping_forces

   !> One step of the phase.
   pure subroutine step_column(strip, h, level, w, p, zone)
      type(strip_t), intent(in) :: strip
      real(dp), intent(in) :: h, level
      real(dp), intent(inout) :: w, p
      integer, intent(inout) :: zone

      associate (u => strip%foundation%u, v => strip%foundation%v)
         if (zone == in_contact) then
            ! p + u dp/ds = w + v dw/ds
            p = (u*p + h*level + v*(level - w))/(u + h)
            if (p > -strip%adhesion%stress) then
               w = level
               return
            end if
            zone = in_adhesion
         end if
         p = merge(-strip%adhesion%stress, 0.0_dp, zone == in_adhesion)
         w = (v*w + h*p)/(v + h)
         if (zone == in_adhesion .and. w - level > strip%adhesion%range .and. strip%adhesion%stress > 0) then
            zone = is_free
            w = w + strip%adhesion%jump
         else if (zone == is_free .and. w - level <= strip%adhesion%range .and. strip%adhesion%stress > 0) then
            zone = in_adhesion
            w = w - strip%adhesion%jump
         end if
         if (w > level) return
         zone = in_contact
         p = strip%foundation%beta*(level - w) - strip%adhesion%stress
         w = level
      end associate
   end subroutine step_column

end module time_stepping

! SPDX-License-Identifier: GPL-3.0-or-later
!> A column under the moving surface, followed in small steps of time: slow, of first order, and
!> independent of every closed form of the solver. For tests and benchmarks only.
module brute_stepping
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: brute_strip_t, brute_state_t, step_one_period, column_of_gap, column_of_height, height_of

   real(dp), parameter :: two_pi = 6.283185307179586476925286766559_dp

   !> The strip F = mean + cos(xi), with K = 1.
   type :: brute_strip_t
      real(dp) :: u = 1, beta = 1, mean = 0, stress = 0, range = 0
      !> Does the displacement jump where adhesion begins and ends? If so: with the range half way?
      logical :: is_instantaneous = .false., is_front = .false.
   end type brute_strip_t

   !> Displacement, stress in the Maxwell arm, and whether the column is held by adhesion or in contact.
   type :: brute_state_t
      real(dp) :: w = 0, q = 0
      logical :: in_contact = .false., in_adhesion = .false.
   end type brute_state_t

contains

   !> A column at phase xi with a given gap, or (gap negative) in contact with -gap as pressure above -stress.
   pure type(brute_state_t) function column_of_gap(strip, xi, gap, in_adhesion) result(column)
      type(brute_strip_t), intent(in) :: strip
      real(dp), intent(in) :: xi, gap
      logical, intent(in) :: in_adhesion
      real(dp) :: pressure

      column%w = strip%mean + cos(xi) + max(gap, 0.0_dp)
      column%in_contact = gap < 0
      column%in_adhesion = .not. column%in_contact .and. in_adhesion
      pressure = 0
      if (column%in_contact) pressure = -gap - strip%stress
      if (column%in_adhesion) pressure = -strip%stress
      column%q = pressure - column%w
   end function column_of_gap

   !> Time stepping one period from phase xi.
   pure subroutine step_one_period(strip, xi, steps, column)
      type(brute_strip_t), intent(in) :: strip
      real(dp), intent(in) :: xi
      integer, intent(in) :: steps
      type(brute_state_t), intent(inout) :: column
      integer :: k

      do k = 1, steps
         call take_step(strip, strip%mean + cos(xi - k*two_pi/steps), two_pi/steps, column)
      end do
   end subroutine step_one_period

   !> What stays continuous at every event and orders the columns: with instantaneous edges the stress of the
   !> glassy spring, else the gap; minus the pressure above -stress in contact.
   pure real(dp) function height_of(strip, xi, column) result(height)
      type(brute_strip_t), intent(in) :: strip
      real(dp), intent(in) :: xi
      type(brute_state_t), intent(in) :: column
      real(dp) :: f

      f = strip%mean + cos(xi)
      if (column%in_contact) then
         height = -(f + column%q + strip%stress)
      else
         height = strip%beta*(column%w - f)
         if (strip%is_instantaneous .and. .not. column%in_adhesion) height = height - strip%stress
      end if
   end function height_of

   !> The column of a height; where it could be free and could be held, `is_held` tells.
   pure type(brute_state_t) function column_of_height(strip, xi, height, is_prescribed) result(column)
      type(brute_strip_t), intent(in) :: strip
      real(dp), intent(in) :: xi, height
      logical, intent(in) :: is_prescribed
      real(dp) :: lift
      logical :: may_be_prescribed

      lift = merge(strip%stress, 0.0_dp, strip%is_instantaneous)
      may_be_prescribed = height <= strip%beta*release_gap(strip)
      if (height + lift > strip%beta*attach_gap(strip) .and. .not. (may_be_prescribed .and. is_prescribed)) then
         column = column_of_gap(strip, xi, (height + lift)/strip%beta, .false.)
      else
         column = column_of_gap(strip, xi, merge(height, height/strip%beta, height < 0), .true.)
      end if
   end function column_of_height

   !> Gap at which adhesion takes hold.
   pure real(dp) function attach_gap(strip)
      type(brute_strip_t), intent(in) :: strip

      attach_gap = strip%range
      if (strip%is_front) attach_gap = strip%range + strip%stress/strip%beta/2
   end function attach_gap

   !> Gap at which adhesion is lost.
   pure real(dp) function release_gap(strip)
      type(brute_strip_t), intent(in) :: strip

      release_gap = strip%range
      if (strip%is_front) release_gap = strip%range - strip%stress/strip%beta/2
   end function release_gap

   !> One implicit step of the phase h to a surface level f.
   pure subroutine take_step(strip, f, h, column)
      type(brute_strip_t), intent(in) :: strip
      real(dp), intent(in) :: f, h
      type(brute_state_t), intent(inout) :: column
      real(dp) :: arm

      if (column%in_contact) then
         ! q + u dq/ds = u (beta - 1) dw/ds with w = f
         arm = (column%q + (strip%beta - 1)*(f - column%w))/(1 + h/strip%u)
         if (f + arm > -strip%stress) then
            column%w = f
            column%q = arm
            return
         end if
         column%in_contact = .false.
         column%in_adhesion = .true.
      end if
      call move_open(strip, h, merge(-strip%stress, 0.0_dp, column%in_adhesion), column)
      if (column%in_adhesion .and. column%w - f > release_gap(strip)) then
         column%in_adhesion = .false.
         if (strip%is_instantaneous) column%w = column%w + strip%stress/strip%beta
      else if (.not. column%in_adhesion .and. column%w - f <= attach_gap(strip)) then
         column%in_adhesion = .true.
         if (strip%is_instantaneous) column%w = column%w - strip%stress/strip%beta
      end if
      if (column%w <= f) call enter_contact(strip, f, column)
   end subroutine take_step

   !> An open column under constant pressure.
   pure subroutine move_open(strip, h, pressure, column)
      type(brute_strip_t), intent(in) :: strip
      real(dp), intent(in) :: h, pressure
      type(brute_state_t), intent(inout) :: column
      real(dp) :: lag

      lag = h/(strip%beta*strip%u)
      column%w = (column%w + lag*pressure)/(1 + lag)
      column%q = pressure - column%w
   end subroutine move_open

   !> The gap has closed within the step: the rest of the way is pushed by the glassy stiffness.
   pure subroutine enter_contact(strip, f, column)
      type(brute_strip_t), intent(in) :: strip
      real(dp), intent(in) :: f
      type(brute_state_t), intent(inout) :: column

      column%in_contact = .true.
      column%q = -strip%stress - column%w + (strip%beta - 1)*(f - column%w)
      if (strip%stress <= 0) column%q = -column%w + (strip%beta - 1)*(f - column%w)
      column%w = f
   end subroutine enter_contact

end module brute_stepping

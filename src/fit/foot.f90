! SPDX-License-Identifier: GPL-3.0-or-later
!> The point of a curve nearest to a measured one, in standard errors of both coordinates: its foot.
!>
!> At the foot h = u u_t + v v_t = 0 with u = (X - X_i)/sX, v = (Y - Y_i)/sY. X and Y both rise outward. So where u and v are both positive the distance falls inward, where both are negative it
!> rises, and a root lies between the t of X_i and the t of Y_i. Is it alone? A point above the curve is outside of a convex set, since Y is
!> a concave function of X, and such a set has one nearest point. For a point below, near the fold, X is a parabola in Y: with U, V the
!> coordinates from the fold and r the radius of curvature there, h is V^3/(2 r^2) + V (1 - U/r) - V_i, which has one positive root for
!> V_i > 0 by Descartes' rule. For V_i <= 0 the foot is the fold, unless U > r, where two roots may appear: then positions between
!> are looked at, and the nearer of fold and root is taken. A pair of roots so close together that no sample lies between them does
!> no harm: the distance falls on to the fold behind it, so the fold is nearer.
module adfric_fit_foot
   use adfric_base_kinds, only: dp
   use adfric_fit_frame, only: frame_t
   use adfric_fit_ordinate, only: ordinate_t, get_ordinate
   use adfric_fit_path, only: sphere_path_t, find_state, is_outer
   use adfric_fit_state, only: fit_state_t, get_state, add_derivatives
   implicit none (type, external)
   private
   public :: foot_t, find_foot

   !> Samples of a path on which feet beside the fold are looked for, and most steps of a search.
   integer, parameter :: n_samples = 16, max_steps = 100
   real(dp), parameter :: close_enough = 1.0e-8_dp

   !> A measured point beside its curve.
   type :: foot_t
      !> The ordinate, a position in the results, and x.
      integer :: ordinate = 0
      !> Edge fraction x.
      real(dp) :: edge = 0
      !> The measured point and its standard errors.
      real(dp) :: x = 0, y = 0, x_sigma = 1, sigma = 1
   end type foot_t

contains

   !> The point of the curve nearest to a measured one.
   subroutine find_foot(self, c, path, t, s, o, is_fold)
      type(foot_t), intent(in) :: self
      type(frame_t), intent(in) :: c
      type(sphere_path_t), intent(in) :: path
      !> In: a guess of the position, or 0. Out: the position, unless the foot is the fold.
      real(dp), intent(inout) :: t
      type(fit_state_t), intent(out) :: s
      type(ordinate_t), intent(out) :: o
      logical, intent(out) :: is_fold
      real(dp) :: at_fold, inner, outer, position, distance
      logical :: is_beside

      call get_ordinate(self%ordinate, self%edge, path%fold, o)
      at_fold = (c%y_unit*o%y + c%y_zero - self%y)/self%sigma
      is_fold = at_fold >= 0
      inner = path%fold%t
      outer = -1
      distance = 0
      position = t
      if (is_fold) then
         s = path%fold
         is_beside = c%x_unit*path%prescribed_at_fold + c%x_zero < self%x
         if (is_beside) call look_beside(self, c, path, inner, outer, is_beside)
         if (.not. is_beside) return
         distance = at_fold**2 + ((c%x_unit*s%p + c%x_zero - self%x)/self%x_sigma)**2
         position = 0
      end if
      if (.not. (position > 0 .and. is_outer(path, position, inner))) call guess_foot(self, c, path, position)
      call find_root(self, c, path, inner, outer, position, s, o)
      if (is_fold) then
         is_fold = .not. ((c%y_unit*o%y + c%y_zero - self%y)/self%sigma)**2 &
            & + ((c%x_unit*s%p + c%x_zero - self%x)/self%x_sigma)**2 < distance
         if (is_fold) s = path%fold
         if (is_fold) call get_ordinate(self%ordinate, self%edge, s, o)
      else
         t = position
      end if
   end subroutine find_foot

   !> A first guess of a foot: the position of the measured abscissa, or near the fold.
   subroutine guess_foot(self, c, path, t)
      type(foot_t), intent(in) :: self
      type(frame_t), intent(in) :: c
      type(sphere_path_t), intent(in) :: path
      !> Receives the position.
      real(dp), intent(out) :: t
      type(fit_state_t) :: s
      logical :: is_beyond
      real(dp) :: prescribed, last_step

      prescribed = (self%x - c%x_zero)/c%x_unit
      t = 0
      call find_state(path, prescribed, t, s, last_step, is_beyond)
      if (is_beyond) t = path%fold%t + path%side*path%fold%t/20
      if (.not. is_outer(path, t, path%fold%t)) t = path%fold%t + path%side*0.1_dp
   end subroutine guess_foot

   !> h = u u_t + v v_t times the side, positive outside of the foot, and its derivative by the position.
   subroutine get_slope(self, c, path, t, s, o, h, h_t)
      type(foot_t), intent(in) :: self
      type(frame_t), intent(in) :: c
      type(sphere_path_t), intent(in) :: path
      real(dp), intent(in) :: t
      type(fit_state_t), intent(inout) :: s
      type(ordinate_t), intent(out) :: o
      !> Receives h times the side.
      real(dp), intent(out) :: h
      !> Receives the derivative of h.
      real(dp), intent(out) :: h_t
      real(dp) :: u, v, x_weight, y_weight

      call get_state(path%theory, path%lambda, t, s)
      call add_derivatives(path%theory, path%lambda, s)
      call get_ordinate(self%ordinate, self%edge, s, o)
      x_weight = c%x_unit/self%x_sigma
      y_weight = c%y_unit/self%sigma
      u = (c%x_unit*s%p + c%x_zero - self%x)/self%x_sigma
      v = (c%y_unit*o%y + c%y_zero - self%y)/self%sigma
      h = path%side*(u*x_weight*s%p_t + v*y_weight*o%y_t)
      h_t = (x_weight*s%p_t)**2 + (y_weight*o%y_t)**2 + u*x_weight*s%p_tt + v*y_weight*o%y_tt
   end subroutine get_slope

   !> Newton's method for the foot, within what is known of where it is.
   subroutine find_root(self, c, path, from, to, t, s, o)
      type(foot_t), intent(in) :: self
      type(frame_t), intent(in) :: c
      type(sphere_path_t), intent(in) :: path
      !> The position inside of the foot, and the one outside; < 0: not known.
      real(dp), intent(in) :: from, to
      !> In: a guess. Out: the position.
      real(dp), intent(inout) :: t
      type(fit_state_t), intent(inout) :: s
      type(ordinate_t), intent(inout) :: o
      real(dp) :: inner, outer, h, h_t, step
      integer :: k
      logical :: is_inside

      inner = from
      outer = to
      ! positions of Maugis-Dugdale end at 0 outward
      if (path%side < 0) outer = max(outer, 0.0_dp)
      if (.not. is_outer(path, t, inner) .or. outer >= 0 .and. .not. is_outer(path, outer, t)) t = (inner + outer)/2
      do k = 1, max_steps
         call get_slope(self, c, path, t, s, o, h, h_t)
         if (h > 0) then
            outer = t
         else
            inner = t
         end if
         step = huge(step)
         if (h_t > 0) step = -path%side*h/h_t
         if (abs(step) <= close_enough*min(t, abs(t - path%fold%t))) return
         is_inside = step < huge(step)
         if (is_inside) is_inside = is_outer(path, t + step, inner) .and. (outer < 0 .or. is_outer(path, outer, t + step))
         if (.not. is_inside) step = merge((inner + outer)/2, 2*t + 1, outer >= 0) - t
         if (path%side < 0 .and. .not. is_inside .and. .not. outer > 0) step = -t/2
         if (abs(step) <= 4*epsilon(t)*t) return
         t = t + step
      end do
   end subroutine find_root

   !> Look for a foot between the fold and the position of the measured abscissa, for a point below the fold's ordinate.
   subroutine look_beside(self, c, path, inner, outer, is_there)
      type(foot_t), intent(in) :: self
      type(frame_t), intent(in) :: c
      type(sphere_path_t), intent(in) :: path
      !> Receives a position inside of that foot, and one outside.
      real(dp), intent(out) :: inner, outer
      logical, intent(out) :: is_there
      type(fit_state_t) :: s
      type(ordinate_t) :: o
      real(dp) :: far, h, h_t
      integer :: k

      call guess_foot(self, c, path, far)
      outer = far
      is_there = .false.
      do k = 1, n_samples - 1
         inner = far + (path%fold%t - far)*k/real(n_samples, dp)
         call get_slope(self, c, path, inner, s, o, h, h_t)
         is_there = .not. h > 0
         if (is_there) return
         outer = inner
      end do
   end subroutine look_beside

end module adfric_fit_foot

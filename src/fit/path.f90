! SPDX-License-Identifier: GPL-3.0-or-later
!> The states of a sphere that a prescribed load, or the prescribed base of a spring, can have: the path from its end of stability,
!> the fold, outward.
!>
!> What is prescribed is phi: the load P, or the position of the base delta + ks P with the reduced compliance ks of the spring.
!> Along the path phi rises from the fold to infinity, so that each phi above that of the fold belongs to one state. The position t
!> of `adfric_fit_state` falls outward in Maugis-Dugdale, and rises in the other theories (`side`).
!>
!> Fold of the load: P_t = 0 has one root (`adfric_round_sphere_maugis_dugdale`). Fold of the base: phi_t = delta_t + ks P_t is negative at the
!> fold of the load, where delta_t < 0, and positive where delta_t = 0, beyond which P_t > 0. So the root lies between the two, or the path goes
!> through th = pi/2 to states without intimate contact, whose phi is a parabola in c. A measured point in contact belongs to a state with
!> intimate contact: its path ends at th = pi/2 (`ends_at_touch`). The pull-off of a base is the end of all states.
module adfric_fit_path
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, half_pi
   use adfric_numerics_powers, only: cube_root
   use adfric_round_sphere_contact, only: sphere_contact_t, theory_hertz, theory_jkr, theory_maugis_dugdale, control_load
   use adfric_round_sphere_dugdale_curve, only: guess_position, get_disc_radius
   use adfric_round_sphere_maugis_dugdale, only: maugis_t
   use adfric_fit_state, only: fit_state_t, get_state, add_derivatives
   implicit none (type, external)
   private
   public :: sphere_path_t, set_path, find_state, move_state, prescribed_value, is_outer, ends_unloaded

   !> A path.
   type :: sphere_path_t
      !> One of `theory_...`.
      integer :: theory = theory_maugis_dugdale
      !> Is the base of a spring prescribed, not the load?
      logical :: is_base = .false.
      !> Does the path end where intimate contact does?
      logical :: ends_at_touch = .true.
      !> Maugis's parameter, and the reduced compliance L/(k D) of the spring.
      real(dp) :: lambda = 0, ks = 0
      !> -1: the position falls outward; 1: it rises.
      integer :: side = -1
      !> The fold, with all derivatives, and phi there.
      type(fit_state_t) :: fold
      !> What is prescribed at the fold, and its second derivative by the position.
      real(dp) :: prescribed_at_fold = 0, prescribed_tt = 0
      !> Derivatives of the position of the fold by lambda and ks.
      real(dp) :: fold_l = 0, fold_ks = 0
   end type sphere_path_t

   !> A Newton step of this size, relative to the distance from the ends of the path, is the last: the parabola leaves its cube.
   real(dp), parameter :: close_enough = 1.0e-5_dp
   integer, parameter :: max_steps = 200
   !> So near to th = pi/2, where all derivatives by th vanish, the path's direction is asked for.
   real(dp), parameter :: before_end = 1.0e-5_dp

contains

   !> Make a path, and find its fold.
   pure subroutine set_path(path, theory, is_base, lambda, ks, has_apart)
      !> In: the path of a neighbour that helps the search, or a new one. Out: the path.
      type(sphere_path_t), intent(inout) :: path
      integer, intent(in) :: theory
      !> Is the base of a spring prescribed, not the load?
      logical, intent(in) :: is_base
      !> Maugis's parameter, > 0; without meaning in the other theories.
      real(dp), intent(in) :: lambda
      !> Reduced compliance L/(k D) of the spring, >= 0.
      real(dp), intent(in) :: ks
      !> Do states without intimate contact belong to the path? If absent, not.
      logical, intent(in), optional :: has_apart
      logical :: is_same, is_full

      is_full = .false.
      if (present(has_apart)) is_full = has_apart
      is_same = path%theory == theory .and. (path%is_base .eqv. is_base) .and. .not. abs(path%lambda - lambda) > 0 &
         & .and. .not. abs(path%ks - ks) > 0
      if (is_same .and. (path%ends_at_touch .eqv. .not. is_full)) return
      path%ends_at_touch = .not. is_full
      path%theory = theory
      path%is_base = is_base
      path%lambda = lambda
      path%ks = ks
      path%side = merge(-1, 1, theory == theory_maugis_dugdale)
      call find_fold(path)
      call add_derivatives(theory, lambda, path%fold)
      path%prescribed_at_fold = prescribed_value(path, path%fold)
      path%fold_l = 0
      path%fold_ks = 0
      associate (s => path%fold)
         path%prescribed_tt = s%p_tt
         if (is_base) path%prescribed_tt = s%d_tt + ks*s%p_tt
         if (.not. abs(path%prescribed_tt) > 0) return
         ! touch stays where it is, at th = pi/2
         if (path%ends_at_touch .and. s%t >= half_pi .and. path%side < 0) return
         if (is_base) then
            path%fold_l = -(s%d_tl + ks*s%p_tl)/path%prescribed_tt
            path%fold_ks = -s%p_t/path%prescribed_tt
         else
            path%fold_l = -s%p_tl/path%prescribed_tt
         end if
      end associate
   end subroutine set_path

   !> What is prescribed: load, or position of the base.
   pure real(dp) function prescribed_value(path, s)
      type(sphere_path_t), intent(in) :: path
      type(fit_state_t), intent(in) :: s

      prescribed_value = s%p
      if (path%is_base) prescribed_value = s%d + path%ks*s%p
   end function prescribed_value

   !> Its derivative by the position.
   pure real(dp) function prescribed_slope(path, s)
      type(sphere_path_t), intent(in) :: path
      type(fit_state_t), intent(in) :: s

      prescribed_slope = s%p_t
      if (path%is_base) prescribed_slope = s%d_t + path%ks*s%p_t
   end function prescribed_slope

   !> Does one position lie farther outward than another?
   pure logical function is_outer(path, t, than)
      type(sphere_path_t), intent(in) :: path
      !> The positions.
      real(dp), intent(in) :: t, than

      is_outer = path%side*(t - than) > 0
   end function is_outer

   !> Does contact begin at the end of the path without a jump? There the load, the area and their friction are 0, as out of contact.
   pure logical function ends_unloaded(path)
      type(sphere_path_t), intent(in) :: path

      ends_unloaded = path%theory == theory_hertz .and. path%is_base
   end function ends_unloaded

   !> Find the fold.
   pure subroutine find_fold(path)
      !> The path; it receives the fold.
      type(sphere_path_t), intent(inout) :: path
      type(fit_state_t) :: s
      real(dp) :: low, high, disc, first

      low = 0
      high = half_pi
      select case (path%theory)
      case (theory_maugis_dugdale)
         if (.not. path%is_base) then
            call find_zero_slope(path, low, high)
            return
         end if
         path%is_base = .false.
         call find_zero_slope(path, low, high)
         path%is_base = .true.
         low = path%fold%t
         call get_state(path%theory, path%lambda, half_pi - before_end, s)
         if (prescribed_slope(path, s) >= 0) then
            call find_zero_slope(path, low, high)
            return
         end if
         first = get_disc_radius(path%lambda, 1.0_dp)
         disc = first
         if (.not. path%ends_at_touch .and. path%ks*pi*path%lambda < 1) disc = min(first, &
            & 8*path%lambda/(3*pi*(1 - path%ks*pi*path%lambda)))
         call get_state(path%theory, path%lambda, half_pi + 1 - disc/first, path%fold)
      case (theory_jkr)
         high = sqrt(1.5_dp)
         if (path%is_base) then
            low = sqrt(6.0_dp)/6
            path%fold%t = (low + high)/2
            call find_zero_slope(path, low, high)
         else
            call get_state(path%theory, path%lambda, high, path%fold)
         end if
      case default
         call get_state(path%theory, path%lambda, 0.0_dp, path%fold)
      end select
   end subroutine find_fold

   !> Newton's method for the position between two where phi_t = 0; phi_t rises there.
   pure subroutine find_zero_slope(path, from, to)
      !> The path. In: with a guess of the fold. Out: with the fold.
      type(sphere_path_t), intent(inout) :: path
      !> Ends of the bracket.
      real(dp), intent(in) :: from, to
      type(maugis_t) :: theory
      type(sphere_contact_t) :: contact
      real(dp) :: low, high, t, value, slope, step
      integer :: k

      low = from
      high = to
      t = path%fold%t
      if (path%theory == theory_maugis_dugdale .and. .not. t > 0 .and. .not. path%is_base) then
         theory%lambda = path%lambda
         call theory%pull_off(control_load, contact)
         t = atan(exp(contact%position))
      end if
      if (.not. (t > low .and. t < high)) t = (low + high)/2
      do k = 1, max_steps
         call get_state(path%theory, path%lambda, t, path%fold)
         call add_derivatives(path%theory, path%lambda, path%fold)
         value = prescribed_slope(path, path%fold)
         slope = path%fold%p_tt
         if (path%is_base) slope = path%fold%d_tt + path%ks*path%fold%p_tt
         if (value < 0) low = t
         if (value > 0) high = t
         step = (low + high)/2 - t
         if (slope > 0) step = -value/slope
         if (.not. (t + step > low .and. t + step < high)) step = (low + high)/2 - t
         if (.not. abs(step) > 4*epsilon(t)*t) exit
         t = t + step
         if (abs(step) > 1.0e-8_dp*t) cycle
         ! the slope's error is of second order now
         call get_state(path%theory, path%lambda, t, path%fold)
         exit
      end do
   end subroutine find_zero_slope

   !> Find the state with a prescribed value.
   pure subroutine find_state(path, prescribed, t, s, last_step, is_beyond)
      type(sphere_path_t), intent(in) :: path
      !> Load, or position of the base, reduced.
      real(dp), intent(in) :: prescribed
      !> In: a guess, or 0. Out: the position of the state.
      real(dp), intent(inout) :: t
      !> Receives a state near the position, with the derivatives by the position.
      type(fit_state_t), intent(inout) :: s
      !> Receives Newton's step from that state to the position, for `move_state`.
      real(dp), intent(out) :: last_step
      !> Is there no such state? Then the fold is given.
      logical, intent(out) :: is_beyond
      real(dp) :: inner, outer, value, slope, step
      logical :: has_outer, is_inside
      integer :: k

      last_step = 0
      is_beyond = .not. prescribed > path%prescribed_at_fold
      if (is_beyond) then
         s = path%fold
         t = s%t
         return
      end if
      inner = path%fold%t
      has_outer = path%side < 0
      outer = 0
      if (.not. (path%side*(t - inner) > 0 .and. t > 0)) call guess_state(path, prescribed, inner, t)
      do k = 1, max_steps
         call get_state(path%theory, path%lambda, t, s)
         value = prescribed_value(path, s) - prescribed
         slope = prescribed_slope(path, s)
         if (value > 0) then
            outer = t
            has_outer = .true.
         else
            inner = t
         end if
         step = -value/slope
         is_inside = is_outer(path, t + step, inner) .and. t + step > 0
         if (is_inside .and. has_outer) is_inside = is_outer(path, outer, t + step)
         if (.not. is_inside) then
            step = merge((inner + outer)/2, 2*t + 1, has_outer) - t
            ! a position near 0 is far outward
            if (path%side < 0 .and. .not. outer > 0) step = -t/2
            if (.not. abs(step) > 4*epsilon(t)*t) exit
            t = t + step
            cycle
         end if
         if (abs(step) <= close_enough*min(t, abs(path%fold%t - t))) then
            last_step = step
            t = t + step
            return
         end if
         t = t + step
      end do
   end subroutine find_state

   !> Go the last step of Newton's method for what is prescribed, along parabolas, from a state with all derivatives.
   pure subroutine move_state(path, s, newton_step)
      type(sphere_path_t), intent(in) :: path
      type(fit_state_t), intent(inout) :: s
      !> Change of the position by Newton's method.
      real(dp), intent(in) :: newton_step
      real(dp) :: bend, step, half

      bend = s%p_tt
      if (path%is_base) bend = s%d_tt + path%ks*s%p_tt
      step = newton_step - bend*newton_step**2/(2*prescribed_slope(path, s))
      half = step/2
      s%t = s%t + step
      s%a = s%a + step*(s%a_t + half*s%a_tt)
      s%c = s%c + step*(s%c_t + half*s%c_tt)
      s%p = s%p + step*(s%p_t + half*s%p_tt)
      s%d = s%d + step*(s%d_t + half*s%d_tt)
      s%a_t = s%a_t + s%a_tt*step
      s%c_t = s%c_t + s%c_tt*step
      s%p_t = s%p_t + s%p_tt*step
      s%d_t = s%d_t + s%d_tt*step
      s%a_l = s%a_l + s%a_tl*step
      s%c_l = s%c_l + s%c_tl*step
      s%p_l = s%p_l + s%p_tl*step
      s%d_l = s%d_l + s%d_tl*step
   end subroutine move_state

   !> A first guess of the state: by the parabola at the fold, or as a large contact.
   pure subroutine guess_state(path, prescribed, inner, t)
      type(sphere_path_t), intent(in) :: path
      !> Load, or position of the base, reduced, above that of the fold.
      real(dp), intent(in) :: prescribed
      !> The innermost position.
      real(dp), intent(in) :: inner
      !> Receives the guess.
      real(dp), intent(out) :: t
      real(dp) :: above, radius, far

      above = prescribed - path%prescribed_at_fold
      radius = cube_root(above + 0.5_dp)
      if (path%is_base) then
         radius = sqrt(above + 0.3_dp)
         if (path%ks > 0) radius = min(radius, cube_root((above + 0.3_dp)/path%ks))
      end if
      select case (path%theory)
      case (theory_maugis_dugdale)
         far = atan(exp(guess_position(path%lambda, 1.0_dp, radius)))
      case (theory_jkr)
         far = radius*sqrt(radius)
      case default
         far = radius
      end select
      t = far
      if (path%prescribed_tt > 0) t = inner + path%side*sqrt(2*above/path%prescribed_tt)
      if (.not. (t > 0) .or. is_outer(path, t, far)) t = far
      if (.not. is_outer(path, t, inner)) t = merge(inner/2, 2*inner + 1, path%side < 0)
   end subroutine guess_state

end module adfric_fit_path

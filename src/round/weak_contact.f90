! SPDX-License-Identifier: GPL-3.0-or-later
!> The contact of an indenter while friction takes from its adhesion: the work of adhesion falls from w to X w, and with it the stress of
!> adhesion from S to X S, at one range h; what is prescribed stays.
!>
!> As X falls a, c and each radius between them fall, for every profile, up to the fold where the state ends
!> (docs/theory/round_peeling.md, Proofs).
!>
!> **JKR.** At a radius a the neck Dl follows from what is prescribed, and X = Dl^2/(2 pi W a) from it: the path is known in closed
!> form. It ends where dX/da = 0, which is a g' = q Dl (`adfric_round_curve`), and along the path
!>
!>     a g' d/q - N,    Dl = N/d,  N = P1 - P, g - delta or g + s P1 - base,  d = 2 a, 1 or 1 + 2 s a
!>
!> has a derivative of the sign of that of sqrt(a) g'/q: monotone on each piece of the shape. So no fold is passed over.
!>
!> **Maugis.** A state at X is sought below one of a larger X, by the sign of what is prescribed less what is given where the state
!> is stable; an unstable one lies below the fold. For kinds that are proved to have one fold that is certain. For others the path
!> is followed in steps in which the contact changes little, 8 and more in a decade, and a step that does not become small as X does
!> is a jump.
module adfric_round_weak_contact
   use adfric_base_kinds, only: dp
   use adfric_round_contact, only: take_given
   use adfric_round_contact_state, only: contact_t, prescribed_by, set_contact
   use adfric_round_curve, only: at_corner, control_spring, curve_t, state_t
   use adfric_round_dugdale_curve, only: dugdale_curve_t
   use adfric_round_weak_end, only: find_closed_end
   use adfric_round_weak_state, only: find_below
   use adfric_round_weak_path, only: middle, path_node_t, weak_path_t, weaken
   implicit none (type, external)
   private
   public :: weak_path_t, new_weak_path, extend_path, find_known, find_last

   !> Most nodes of a way that is followed in steps.
   integer, parameter :: most_nodes = 400
   !> Largest change of the unknown in a step of a way that is followed.
   real(dp), parameter :: near = 0.75_dp

contains

   !> A path from a contact with all of its adhesion.
   pure subroutine new_weak_path(self, curve, control, given, contact)
      type(weak_path_t), intent(out) :: self
      class(curve_t), intent(in) :: curve
      integer, intent(in) :: control
      real(dp), intent(in) :: given
      !> The contact, stable and of a radius > 0.
      type(contact_t), intent(in) :: contact

      allocate (self%curve, source=curve)
      self%control = control
      self%given = given
      select type (curve)
      type is (dugdale_curve_t)
         self%is_closed = curve%shape%n_pieces == 0
         self%is_followed = .not. self%is_closed .and. (.not. curve%shape%has_rising_slope .or. control == control_spring)
      end select
      allocate (self%nodes(merge(most_nodes, 1, self%is_followed)))
      self%n = 1
      self%nodes(1) = path_node_t(1.0_dp, contact)
      if (self%is_closed .and. curve%shape%n_pieces > 0) call find_closed_end(self)
   end subroutine new_weak_path

   !> The state of the path at an X.
   pure subroutine find_weaker(self, ratio, contact)
      !> The path; one that is followed receives the nodes up to there.
      type(weak_path_t), intent(inout) :: self
      !> X, from 0 to 1.
      real(dp), intent(in) :: ratio
      !> Receives the state, with `is_found`.
      type(contact_t), intent(out) :: contact

      call extend_path(self, ratio)
      call find_known(self, ratio, contact)
   end subroutine find_weaker

   !> Follow the way as far as an X, if it is one that is followed.
   pure subroutine extend_path(self, ratio)
      !> The path, which receives the nodes up to there.
      type(weak_path_t), intent(inout) :: self
      real(dp), intent(in) :: ratio

      if (.not. self%is_followed .or. self%is_lost .or. self%n == 0) return
      if (ratio < self%nodes(self%n)%ratio) call follow(self, ratio)
   end subroutine extend_path

   !> The state at an X up to which the path is known.
   pure subroutine find_known(self, ratio, contact)
      type(weak_path_t), intent(in) :: self
      real(dp), intent(in) :: ratio
      type(contact_t), intent(out) :: contact
      integer :: k

      if (self%n == 0) return
      if (.not. self%is_followed) then
         if (self%is_closed .and. self%is_lost .and. ratio < self%least_ratio) return
         call find_below(self, ratio, self%nodes(1)%contact, contact)
      else
         if (self%is_lost .and. ratio < self%nodes(self%n)%ratio) return
         do k = self%n, 1, -1
            if (self%nodes(k)%ratio >= ratio) exit
         end do
         call find_below(self, ratio, self%nodes(max(k, 1))%contact, contact)
      end if
   end subroutine find_known

   !> Follow the path down to an X, or to where its state is lost.
   pure subroutine follow(self, ratio)
      !> The path, which receives nodes, and maybe its end.
      type(weak_path_t), intent(inout) :: self
      !> X.
      real(dp), intent(in) :: ratio
      ! a step of X that leaves round-off only
      real(dp), parameter :: smallest = 1.0e-13_dp
      type(contact_t) :: contact
      real(dp) :: goal, step

      step = self%nodes(self%n)%ratio - ratio
      do
         associate (last => self%nodes(self%n))
            goal = max(last%ratio - step, ratio)
            call find_below(self, goal, last%contact, contact)
            if (contact%is_found) contact%is_found = is_near(self, last%contact, contact)
            if (contact%is_found) then
               if (self%n < most_nodes) self%n = self%n + 1
               self%nodes(self%n) = path_node_t(goal, contact)
               if (.not. goal > ratio) return
               step = 2*step
            else
               if (step <= smallest*last%ratio) exit
               step = step/4
            end if
         end associate
      end do
      self%is_lost = .true.
      self%least_ratio = self%nodes(self%n)%ratio
   end subroutine follow

   !> Is a state of the path near another one, so that no fold hides between them?
   pure logical function is_near(self, before, after)
      !> The path, whose range of adhesion tells what is near a corner.
      type(weak_path_t), intent(in) :: self
      !> The states, from the larger to the smaller one.
      type(contact_t), intent(in) :: before, after
      real(dp) :: smallest

      smallest = 1.0e-4_dp
      select type (curve => self%curve)
      type is (dugdale_curve_t)
         smallest = smallest*min(1.0_dp, sqrt(curve%range/curve%stress))
      end select
      is_near = after%spot%radius > near*before%spot%radius
      if (.not. is_near .or. .not. self%curve%shape%corner > 0) return
      if (before%is_beyond .eqv. after%is_beyond) then
         is_near = after%u > near*before%u .or. (before%is_beyond .and. before%u < smallest) &
            & .or. (.not. before%is_beyond .and. self%curve%shape%has_face .and. after%u > 1/smallest)
      else
         is_near = before%u < smallest .and. (after%spot%beyond < smallest .or. .not. self%curve%shape%has_face)
      end if
   end function is_near

   !> The last state of the path, where it is lost above an X that has none.
   pure subroutine find_last(self, ratio, last_ratio, contact, is_converged)
      type(weak_path_t), intent(inout) :: self
      !> An X without a state.
      real(dp), intent(in) :: ratio
      !> Receives X of the last state.
      real(dp), intent(out) :: last_ratio
      type(contact_t), intent(out) :: contact
      logical, intent(out) :: is_converged
      class(curve_t), allocatable :: curve

      is_converged = .true.
      if (self%is_closed .and. self%curve%shape%n_pieces > 0) then
         last_ratio = self%least_ratio
         allocate (curve, source=self%curve)
         call weaken(curve, last_ratio)
         call set_contact(curve, self%control, self%low, self%low_is_beyond, contact)
         contact%is_found = .true.
         contact%is_stable = .true.
         call take_given(curve, self%control, self%given, contact)
      else
         call find_last_ratio(self, ratio, last_ratio, contact, is_converged)
      end if
   end subroutine find_last

   !> The last state of a way that is no closed form: the X at which the fold below a state has what is given.
   pure subroutine find_last_ratio(self, ratio, last_ratio, contact, is_converged)
      type(weak_path_t), intent(inout) :: self
      real(dp), intent(in) :: ratio
      real(dp), intent(out) :: last_ratio
      type(contact_t), intent(out) :: contact
      logical, intent(out) :: is_converged
      integer, parameter :: most_steps = 200
      type(contact_t) :: upper, trial, fold
      real(dp) :: low, high, at_low, at_high, value, next
      integer :: k
      logical :: is_smooth

      low = ratio
      high = 1
      upper = self%nodes(1)%contact
      is_converged = .true.
      if (self%is_followed) then
         ! it has been followed to there
         last_ratio = self%nodes(self%n)%ratio
         call find_fold_below(self, last_ratio, self%nodes(self%n)%contact, contact, value)
         contact%is_found = .true.
         contact%is_stable = .true.
         return
      end if
      contact = upper
      is_smooth = self%curve%shape%n_pieces > 0
      if (is_smooth) call find_fold_below(self, high, upper, fold, at_high)
      at_low = 0
      value = 0
      do k = 1, most_steps
         if (high - low <= 2*epsilon(high)*high) exit
         next = low + (high - low)/2
         if (is_smooth .and. at_low > 0 .and. at_high < 0 .and. modulo(k, 5) > 0) then
            next = high - (high - low)*(at_high/(at_high - at_low))
            if (.not. (next > low .and. next < high)) next = low + (high - low)/2
         end if
         call find_weaker(self, next, trial)
         if (is_smooth) then
            call find_fold_below(self, next, upper, fold, value)
            if (abs(value) <= 4*epsilon(value)*abs(self%given)) then
               high = next
               contact = fold
               exit
            end if
         end if
         if (trial%is_found) then
            high = next
            upper = trial
            contact = trial
            if (is_smooth) contact = fold
            at_high = value
         else
            low = next
            at_low = value
         end if
      end do
      last_ratio = high
      contact%is_found = .true.
      contact%is_stable = .true.
   end subroutine find_last_ratio

   !> The first fold below a state, or the contact of radius 0, and how much more than what is given it holds.
   pure subroutine find_fold_below(self, ratio, upper, fold, value)
      type(weak_path_t), intent(in) :: self
      real(dp), intent(in) :: ratio
      type(contact_t), intent(in) :: upper
      type(contact_t), intent(out) :: fold
      !> Receives what it holds less what is given.
      real(dp), intent(out) :: value
      ! ln u of a step down, and of the smallest contact
      real(dp), parameter :: first_step = 1.0e-3_dp, smallest = -60.0_dp
      integer, parameter :: most_steps = 200
      class(curve_t), allocatable :: curve
      type(state_t) :: state
      real(dp) :: low, high, step, top
      integer :: k
      logical :: is_beyond

      allocate (curve, source=self%curve)
      call weaken(curve, ratio)
      is_beyond = upper%is_beyond
      high = upper%u
      if (is_beyond .and. curve%shape%corner > 0) then
         call curve%get_state(0.0_dp, .true., state)
         if (state%is_stable(self%control)) then
            is_beyond = .false.
            high = merge(at_corner, curve%shape%corner, curve%shape%has_face)
         end if
      end if
      top = high
      step = first_step
      low = 0
      do
         low = high*exp(-step)
         call curve%get_state(low, is_beyond, state)
         if (.not. state%is_stable(self%control) .or. log(low/top) < smallest*merge(3, 1, top >= at_corner)) exit
         high = low
         step = 2*step
      end do
      if (state%is_stable(self%control)) then
         ! down to the last touch
         low = 0
         high = 0
      end if
      do k = 1, most_steps
         if (high - low <= 2*epsilon(high)*high) exit
         step = middle(low, high)
         call curve%get_state(step, is_beyond, state)
         if (state%is_stable(self%control)) high = step
         if (.not. state%is_stable(self%control)) low = step
      end do
      call set_contact(curve, self%control, high, is_beyond, fold)
      value = prescribed_by(curve, self%control, fold) - self%given
      call take_given(curve, self%control, self%given, fold)
   end subroutine find_fold_below

end module adfric_round_weak_contact

! SPDX-License-Identifier: GPL-3.0-or-later
!> The stable stretches of a curve of equilibrium, from the smallest contacts to the largest, and what happens as what is
!> prescribed rises or falls along them.
!>
!> A contact goes along a stretch up to its end. There it jumps in its own direction until a stable state meets it: beside an
!> unstable one the energy falls towards the side to which it moves. So a rise is the running maximum along the curve from
!> below, and a fall the running minimum from above: no state beyond the first stable one is reached. Along a jump the potential
!> falls: E - P delta under a load, E at a given approach, E + s P^2/2 on a spring of compliance s.
module adfric_round_stretches
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_round_contact, only: try_interval, try_disc_range
   use adfric_round_contact_state, only: contact_t, prescribed_by, set_contact, set_disc, terms_of
   use adfric_round_survey, only: survey_t
   use adfric_round_curve, only: curve_t, disc_range_t, curve_interval_t, control_load, control_spring, most_disc_ranges, &
      & most_intervals
   use adfric_round_dugdale_curve, only: dugdale_curve_t
   use adfric_round_energy, only: adhesive_energy
   implicit none (type, external)
   private
   public :: stretches_t, journey_t, list_stretches, follow_stretches, potential_of, radii_of

   !> Radii that differ by less than this share are the same: beside a fold a radius has half the digits.
   real(dp), parameter :: close_by = 1.0e-6_dp

   !> A piece of the curve whose states are stable.
   type :: stable_stretch_t
      !> Is it of discs without touch?
      logical :: is_disc = .false.
      !> The discs.
      type(disc_range_t) :: disc
      !> The contacts.
      type(curve_interval_t) :: interval
      !> Is the next stretch, or the one before, its continuation? Of the largest one there is none needed.
      logical :: goes_on = .false., goes_back = .false.
   end type stable_stretch_t

   !> The stable stretches of a curve.
   type :: stretches_t
      !> What is prescribed, `control_load`, `control_approach` or `control_spring`.
      integer :: control = control_spring
      !> Number of stretches.
      integer :: n = 0
      !> The stretches, from the smallest contacts to the largest.
      type(stable_stretch_t) :: list(most_intervals + most_disc_ranges)
   end type stretches_t

   !> A part of a stretch that a contact has gone through.
   type :: passage_t
      !> Radii of contact and of adhesion where it was entered, and where it was left; shape `(2)`.
      real(dp) :: entered(2) = 0, left(2) = 0
      !> Load and approach where it was left, and the size of the terms of that load.
      real(dp) :: load = 0, approach = 0, load_terms = 0
   end type passage_t

   !> What a contact has gone through while what is prescribed rose or fell.
   type :: journey_t
      !> Index of the stretch of the last state; 0 below the smallest contacts.
      integer :: k = 0
      !> The last state that is stable, or the one from which the next jump begins.
      type(contact_t) :: contact
      !> What is prescribed in it.
      real(dp) :: prescribed = 0
      !> Do the bodies part at the end?
      logical :: parts = .false.
      !> Potential that the jumps have lost; that of bodies that part under a load is NaN, since they part for good.
      real(dp) :: loss = 0
      !> Sum of the terms whose differences the losses are.
      real(dp) :: terms = 0
      !> Number of jumps. Of the one that has lost most: its loss, what is prescribed in it, and the load right after.
      integer :: n_jumps = 0
      !> See above.
      real(dp) :: largest_loss = -1, jump = 0, load_after = 0
      !> Number of the stretches that it has gone through, and its parts of them.
      integer :: n_passages = 0
      !> See above.
      type(passage_t) :: passages(most_intervals + most_disc_ranges)
      !> Were all states found to round-off?
      logical :: is_converged = .true.
   end type journey_t

contains

   !> The stable stretches of a curve, from the smallest contacts to the largest.
   pure subroutine list_stretches(survey, control, stretches)
      type(survey_t), intent(in) :: survey
      !> What is prescribed in the survey.
      integer, intent(in) :: control
      type(stretches_t), intent(out) :: stretches
      integer :: k

      stretches%control = control
      associate (n => stretches%n, list => stretches%list)
         do k = 1, survey%n_discs
            n = n + 1
            list(n)%is_disc = .true.
            list(n)%disc = survey%discs(k)
            ! discs that begin at c = 0 go on from bodies that are apart
            list(n)%goes_back = .not. survey%discs(k)%low > 0
            if (survey%discs(k)%touches .and. survey%n > 0) list(n)%goes_on = survey%intervals(1)%is_stable
         end do
         do k = 1, survey%n
            if (.not. survey%intervals(k)%is_stable) cycle
            n = n + 1
            list(n)%interval = survey%intervals(k)
            list(n)%goes_on = .not. survey%intervals(k)%ends_at_fold
            if (n == 1) cycle
            if (k == 1) then
               list(n)%goes_back = list(n - 1)%goes_on
            else
               list(n)%goes_back = survey%intervals(max(k - 1, 1))%is_stable .and. .not. survey%intervals(k)%begins_at_fold
            end if
         end do
      end associate
   end subroutine list_stretches

   !> Go along the stretches, and jump where they end.
   pure subroutine follow_stretches(curve, stretches, direction, journey, target)
      class(curve_t), intent(in) :: curve
      type(stretches_t), intent(in) :: stretches
      !> 1 while what is prescribed rises, -1 while it falls.
      integer, intent(in) :: direction
      !> In: the first stretch `k` with a state of it; or no stretch (0), and the state from which a jump begins. Out: the end.
      type(journey_t), intent(inout) :: journey
      !> What is prescribed at the end; if absent the largest contacts, or bodies that part.
      real(dp), intent(in), optional :: target
      real(dp) :: entered(2)

      do
         if (journey%k == 0) then
            call land(curve, stretches, direction, merge(1, stretches%n, direction > 0), journey)
            if (journey%parts) return
         end if
         entered = radii_of(journey%contact)
         if (present(target)) then
            call find_in(curve, stretches, journey%k, target, journey%contact)
            journey%prescribed = target
            if (journey%contact%is_found) exit
         end if
         if (direction > 0 .and. journey%k == stretches%n) then
            ! the largest contacts have no end
            journey%is_converged = journey%is_converged .and. .not. present(target)
            return
         end if
         call get_end(curve, stretches, journey%k, direction > 0, journey%contact)
         journey%prescribed = prescribed_by(curve, stretches%control, journey%contact)
         journey%is_converged = journey%is_converged .and. journey%contact%is_converged
         call add_passage(entered, journey)
         associate (stretch => stretches%list(journey%k))
            if (merge(stretch%goes_on, stretch%goes_back, direction > 0)) then
               journey%k = journey%k + direction
               journey%parts = journey%k == 0
               if (journey%parts) return
               if (.not. present(target)) cycle
               ! between two stretches there is nothing but round-off
               if (direction*(journey%prescribed - target) >= 0) exit
               cycle
            end if
         end associate
         call land(curve, stretches, direction, journey%k + direction, journey)
         if (journey%parts) return
      end do
      journey%is_converged = journey%is_converged .and. journey%contact%is_converged
      call add_passage(entered, journey)
   end subroutine follow_stretches

   !> Radii of contact and of adhesion. Where one of them hardly changes the other one tells states apart.
   pure function radii_of(contact) result(radii)
      type(contact_t), intent(in) :: contact
      real(dp) :: radii(2)

      radii = [contact%spot%radius, contact%adhesion_radius]
   end function radii_of

   !> Take a part of a stretch into account, up to the state at hand.
   pure subroutine add_passage(entered, journey)
      !> Radii of contact and of adhesion where it was entered; shape `(2)`.
      real(dp), intent(in) :: entered(:)
      type(journey_t), intent(inout) :: journey
      real(dp) :: terms(2)

      terms = terms_of(journey%contact)
      journey%n_passages = journey%n_passages + 1
      associate (contact => journey%contact)
         journey%passages(journey%n_passages) = passage_t(entered, radii_of(contact), contact%load, contact%approach, &
            & terms(1))
      end associate
   end subroutine add_passage

   !> From a state to the first stretch that has what is prescribed in it, no smaller contact while it rises and no larger one
   !> while it falls: a jump, unless the state lies on that stretch.
   pure subroutine land(curve, stretches, direction, first, journey)
      class(curve_t), intent(in) :: curve
      type(stretches_t), intent(in) :: stretches
      !> 1 while what is prescribed rises, -1 while it falls.
      integer, intent(in) :: direction
      !> Index of the first stretch that is tried.
      integer, intent(in) :: first
      !> In: the state. Out: the stretch and what a jump has lost; or bodies that part.
      type(journey_t), intent(inout) :: journey
      type(contact_t) :: after
      real(dp) :: growth
      integer :: k

      do k = first, merge(stretches%n, 1, direction > 0), direction
         call find_in(curve, stretches, k, journey%prescribed, after)
         if (.not. after%is_found) cycle
         growth = direction*(after%adhesion_radius - journey%contact%adhesion_radius)
         if (growth < -close_by*journey%contact%adhesion_radius) cycle
         journey%k = k
         if (growth > close_by*journey%contact%adhesion_radius) call jump(curve, stretches%control, after, journey)
         journey%contact = after
         return
      end do
      ! the largest contacts have no end
      journey%is_converged = journey%is_converged .and. direction < 0
      journey%k = 0
      journey%parts = .true.
      call jump(curve, stretches%control, after, journey)
   end subroutine land

   !> Take a jump into account.
   pure subroutine jump(curve, control, after, journey)
      class(curve_t), intent(in) :: curve
      integer, intent(in) :: control
      !> The state after the jump, unless the bodies part.
      type(contact_t), intent(in) :: after
      !> In: with the state before the jump. Out: with what it has lost.
      type(journey_t), intent(inout) :: journey
      real(dp) :: loss

      loss = potential_of(curve, control, journey%contact)
      journey%terms = journey%terms + size_of_potential(curve, journey%contact)
      if (journey%parts) then
         if (control == control_load) loss = not_a_number()
      else
         loss = loss - potential_of(curve, control, after)
         journey%terms = journey%terms + size_of_potential(curve, after)
         journey%is_converged = journey%is_converged .and. after%is_converged
      end if
      journey%loss = journey%loss + loss
      journey%n_jumps = journey%n_jumps + 1
      if (journey%parts) return
      if (.not. loss > journey%largest_loss) return
      journey%largest_loss = loss
      journey%jump = journey%prescribed
      journey%load_after = after%load
   end subroutine jump

   !> The state at an end of a stretch.
   pure subroutine get_end(curve, stretches, k, is_largest, contact)
      class(curve_t), intent(in) :: curve
      type(stretches_t), intent(in) :: stretches
      !> Index of the stretch.
      integer, intent(in) :: k
      !> Its largest state, or its smallest one?
      logical, intent(in) :: is_largest
      type(contact_t), intent(out) :: contact

      associate (stretch => stretches%list(k))
         if (stretch%is_disc) then
            call set_disc(curve, stretches%control, merge(stretch%disc%high, stretch%disc%low, is_largest), contact)
         else
            call set_contact(curve, stretches%control, merge(stretch%interval%high, stretch%interval%low, is_largest), &
               & stretch%interval%is_beyond, contact)
         end if
      end associate
   end subroutine get_end

   !> The state of a stretch with what is prescribed, if there is one.
   pure subroutine find_in(curve, stretches, k, prescribed, contact)
      class(curve_t), intent(in) :: curve
      type(stretches_t), intent(in) :: stretches
      !> Index of the stretch.
      integer, intent(in) :: k
      real(dp), intent(in) :: prescribed
      !> Receives the state, with `is_found`.
      type(contact_t), intent(out) :: contact

      associate (stretch => stretches%list(k))
         if (stretch%is_disc) then
            call try_disc_range(curve, stretches%control, prescribed, stretch%disc, contact)
         else
            call try_interval(curve, stretches%control, prescribed, stretch%interval, contact)
         end if
      end associate
   end subroutine find_in

   !> What falls along a jump: E - P delta, E, or E + s P^2/2; 0 of bodies apart.
   pure real(dp) function potential_of(curve, control, contact) result(potential)
      class(curve_t), intent(in) :: curve
      !> What is prescribed.
      integer, intent(in) :: control
      type(contact_t), intent(in) :: contact

      potential = adhesive_energy(curve, contact)
      if (control == control_load) potential = potential - contact%load*contact%approach
      if (control == control_spring) potential = potential + curve%compliance*contact%load**2/2
   end function potential_of

   !> Sum of the terms whose differences are the energy of a contact, and of its load times its approach.
   pure real(dp) function size_of_potential(curve, contact) result(terms)
      class(curve_t), intent(in) :: curve
      type(contact_t), intent(in) :: contact

      terms = (curve%tension*contact%spot%radius)**2/2
      select type (curve)
      type is (dugdale_curve_t)
         terms = pi*curve%stress*contact%adhesion_radius**2*(curve%range + abs(contact%approach) + abs(contact%neck))
      end select
      if (contact%spot%radius > 0) terms = terms + contact%spot%load*contact%spot%depth + abs(contact%neck) &
         & *(abs(contact%neck)*contact%spot%radius + contact%spot%load)
      terms = terms + product(terms_of(contact))
   end function size_of_potential

end module adfric_round_stretches

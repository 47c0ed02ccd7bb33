! SPDX-License-Identifier: GPL-3.0-or-later
!> A cycle of approach and retraction, at a given approach or on a spring: where contact jumps in, where it lets go, and what energy
!> the jumps take.
!>
!> States follow each other on one curve of what is prescribed, h, over the size of the contact, from bodies apart (h = 0, or minus
!> the range of adhesion) to the largest contact. A jump goes on in its own direction until a stable state meets it: beside an
!> unstable one the energy falls towards the side to which it moves. So approach is the running maximum of h along the curve from
!> below, and retraction the running minimum from above: no state beyond the first stable one is reached, and the last state of
!> retraction is the one with the least h of all that are stable. Along a jump the energy E + s P^2/2 (s the compliance) falls.
module adfric_round_loop
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_round_contact, only: find_contact, try_interval, try_disc_range, branch_stable
   use adfric_round_contact_state, only: contact_t, prescribed_by, set_contact, set_disc
   use adfric_round_survey, only: survey_t
   use adfric_round_curve, only: curve_t, disc_range_t, curve_interval_t, control_spring, most_disc_ranges, most_intervals
   use adfric_round_dugdale_curve, only: dugdale_curve_t
   use adfric_round_energy, only: adhesive_energy
   implicit none (type, external)
   private
   public :: loop_t, find_loop

   !> What happens in a cycle, reduced; NaN where there is nothing of the kind.
   type :: loop_t
      !> What is prescribed where contact jumps in on approach, and the load right after: of the jump that takes most.
      real(dp) :: jump_in = 0, jump_in_load = 0
      !> What is prescribed in the last state of retraction.
      real(dp) :: pull_off = 0
      !> Energy that all jumps take.
      real(dp) :: energy = 0
      !> Were all states found to round-off?
      logical :: is_converged = .true.
   end type loop_t

   !> A piece of the curve whose states are stable.
   type :: loop_stretch_t
      !> Is it of discs without touch?
      logical :: is_disc = .false.
      !> The discs.
      type(disc_range_t) :: disc
      !> The contacts.
      type(curve_interval_t) :: interval
      !> Is the next stretch, or the one before, its continuation? Of the largest one there is none needed.
      logical :: goes_on = .false., goes_back = .false.
   end type loop_stretch_t

   !> The stable stretches of a curve.
   type :: loop_path_t
      !> What is prescribed, `control_approach` or `control_spring`.
      integer :: control = control_spring
      !> What is prescribed where bodies that are apart come into the reach of adhesion.
      real(dp) :: apart = 0
      !> Number of stretches.
      integer :: n = 0
      !> The stretches, from the smallest contacts to the largest.
      type(loop_stretch_t) :: stretches(most_intervals + most_disc_ranges)
   end type loop_path_t

contains

   !> The cycle.
   pure subroutine find_loop(curve, survey, control, loop)
      class(curve_t), intent(in) :: curve
      type(survey_t), intent(in) :: survey
      !> `control_approach` or `control_spring`.
      integer, intent(in) :: control
      type(loop_t), intent(out) :: loop
      type(loop_path_t) :: path

      path%control = control
      loop%is_converged = survey%ends%is_converged
      loop%jump_in = not_a_number()
      loop%jump_in_load = not_a_number()
      loop%pull_off = survey%ends%pull_off_approach
      if (control == control_spring) loop%pull_off = loop%pull_off + curve%compliance*survey%ends%pull_off_load
      select type (curve)
      type is (dugdale_curve_t)
         path%apart = -curve%range
      end select
      if (curve%shape%n_pieces == 0) then
         call follow_face(curve, survey, path, loop)
      else
         call list_stretches(survey, path)
         call approach(curve, path, loop)
         call retract(curve, path, loop)
      end if
      if (.not. loop%is_converged .or. (path%n == 0 .and. curve%shape%n_pieces > 0)) loop%energy = not_a_number()
   end subroutine find_loop

   !> A flat face: it jumps in as a whole, and lets go.
   pure subroutine follow_face(curve, survey, path, loop)
      class(curve_t), intent(in) :: curve
      type(survey_t), intent(in) :: survey
      type(loop_path_t), intent(in) :: path
      type(loop_t), intent(inout) :: loop
      type(contact_t) :: contact

      call find_contact(curve, survey, path%control, path%apart, .true., branch_stable, contact)
      loop%is_converged = loop%is_converged .and. contact%is_found .and. contact%is_converged
      loop%jump_in = path%apart
      loop%jump_in_load = contact%load
      loop%energy = -energy_of(curve, path%control, contact)
      call find_contact(curve, survey, path%control, loop%pull_off*(1 - 4*epsilon(1.0_dp)), .true., branch_stable, contact)
      loop%is_converged = loop%is_converged .and. contact%is_found .and. contact%is_converged
      loop%energy = loop%energy + energy_of(curve, path%control, contact)
   end subroutine follow_face

   !> The stable stretches of a curve, from the smallest contacts to the largest.
   pure subroutine list_stretches(survey, path)
      type(survey_t), intent(in) :: survey
      type(loop_path_t), intent(inout) :: path
      integer :: k

      do k = 1, survey%n_discs
         path%n = path%n + 1
         path%stretches(path%n)%is_disc = .true.
         path%stretches(path%n)%disc = survey%discs(k)
         ! discs that begin at c = 0 go on from bodies that are apart
         path%stretches(path%n)%goes_back = .not. survey%discs(k)%low > 0
         if (survey%discs(k)%touches .and. survey%n > 0) path%stretches(path%n)%goes_on = survey%intervals(1)%is_stable
      end do
      do k = 1, survey%n
         if (.not. survey%intervals(k)%is_stable) cycle
         path%n = path%n + 1
         path%stretches(path%n)%interval = survey%intervals(k)
         path%stretches(path%n)%goes_on = .not. survey%intervals(k)%ends_at_fold
         if (path%n == 1) cycle
         if (k == 1) then
            path%stretches(path%n)%goes_back = path%stretches(path%n - 1)%goes_on
         else
            path%stretches(path%n)%goes_back = survey%intervals(max(k - 1, 1))%is_stable &
               & .and. .not. survey%intervals(k)%begins_at_fold
         end if
      end do
   end subroutine list_stretches

   !> From bodies that are apart to the largest contact.
   pure subroutine approach(curve, path, loop)
      class(curve_t), intent(in) :: curve
      type(loop_path_t), intent(in) :: path
      type(loop_t), intent(inout) :: loop
      type(contact_t) :: before, after
      real(dp) :: prescribed, loss, largest
      integer :: k, next

      largest = -1
      k = 0
      if (path%n > 0) k = merge(1, 0, path%stretches(1)%goes_back)
      do while (k < path%n)
         next = k + 1
         if (k > 0) then
            if (path%stretches(k)%goes_on) then
               k = next
               cycle
            end if
            call get_end(curve, path, path%stretches(k), .true., before)
            loop%is_converged = loop%is_converged .and. before%is_converged
            prescribed = prescribed_by(curve, path%control, before)
            loss = energy_of(curve, path%control, before)
         else
            prescribed = path%apart
            loss = 0
         end if
         do k = next, path%n
            call find_in(curve, path, path%stretches(k), prescribed, after)
            if (after%is_found) exit
         end do
         loop%is_converged = loop%is_converged .and. after%is_found .and. after%is_converged
         if (.not. after%is_found) return
         loss = loss - energy_of(curve, path%control, after)
         loop%energy = loop%energy + loss
         if (.not. loss > largest) cycle
         largest = loss
         loop%jump_in = prescribed
         loop%jump_in_load = after%load
      end do
   end subroutine approach

   !> From the largest contact to bodies that are apart.
   pure subroutine retract(curve, path, loop)
      class(curve_t), intent(in) :: curve
      type(loop_path_t), intent(in) :: path
      type(loop_t), intent(inout) :: loop
      type(contact_t) :: before, after
      integer :: k, first

      k = path%n
      do while (k > 0)
         if (path%stretches(k)%goes_back) then
            k = k - 1
            cycle
         end if
         call get_end(curve, path, path%stretches(k), .false., before)
         loop%is_converged = loop%is_converged .and. before%is_converged
         loop%energy = loop%energy + energy_of(curve, path%control, before)
         first = k - 1
         do k = first, 1, -1
            call find_in(curve, path, path%stretches(k), prescribed_by(curve, path%control, before), after)
            if (.not. after%is_found) cycle
            loop%is_converged = loop%is_converged .and. after%is_converged
            loop%energy = loop%energy - energy_of(curve, path%control, after)
            exit
         end do
      end do
   end subroutine retract

   !> The state at an end of a stretch.
   pure subroutine get_end(curve, path, stretch, is_largest, contact)
      class(curve_t), intent(in) :: curve
      type(loop_path_t), intent(in) :: path
      type(loop_stretch_t), intent(in) :: stretch
      !> Its largest state, or its smallest one?
      logical, intent(in) :: is_largest
      type(contact_t), intent(out) :: contact

      if (stretch%is_disc) then
         call set_disc(curve, path%control, merge(stretch%disc%high, stretch%disc%low, is_largest), contact)
      else
         call set_contact(curve, path%control, merge(stretch%interval%high, stretch%interval%low, is_largest), &
            & stretch%interval%is_beyond, contact)
      end if
   end subroutine get_end

   !> The state of a stretch with what is prescribed, if there is one.
   pure subroutine find_in(curve, path, stretch, prescribed, contact)
      class(curve_t), intent(in) :: curve
      type(loop_path_t), intent(in) :: path
      type(loop_stretch_t), intent(in) :: stretch
      real(dp), intent(in) :: prescribed
      !> Receives the state, with `is_found`.
      type(contact_t), intent(out) :: contact

      if (stretch%is_disc) then
         call try_disc_range(curve, path%control, prescribed, stretch%disc, contact)
      else
         call try_interval(curve, path%control, prescribed, stretch%interval, contact)
      end if
   end subroutine find_in

   !> E + s P^2/2.
   pure real(dp) function energy_of(curve, control, contact) result(energy)
      class(curve_t), intent(in) :: curve
      integer, intent(in) :: control
      type(contact_t), intent(in) :: contact

      energy = adhesive_energy(curve, contact)
      if (control == control_spring) energy = energy + curve%compliance*contact%load**2/2
   end function energy_of

end module adfric_round_loop

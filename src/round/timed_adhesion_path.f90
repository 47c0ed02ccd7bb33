! SPDX-License-Identifier: GPL-3.0-or-later
!> A path of a contact with a zone of adhesion on one grid, what it leaves, and what two grids say together: the error of both is of
!> second order in cells and steps.
module adfric_round_timed_adhesion_path
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_round_timed_adhesion_contact, only: adhesive_contact_t
   use adfric_round_timed_adhesion_memory, only: stored_energy
   use adfric_round_timed_adhesion_zone, only: zone_energy
   use adfric_round_timed_path, only: prescribed_at, timed_leg_t
   implicit none (type, external)
   private
   public :: zone_outcome_t, read_outcome, extrapolate, difference_of, close_path

   !> Columns of the steps.
   integer, parameter, public :: c_time = 1, c_approach = 2, c_load = 3, c_contact = 4, c_adhesion = 5, n_columns = 5
   !> Numbers of a path.
   integer, parameter, public :: o_load = 1, o_approach = 2, o_clock = 3, o_loss = 4, o_jump_approach = 5, o_jump_load = 6, &
      & o_work = 7, o_stored = 8, o_adhesion = 9, o_taken = 10, n_numbers = 10

   !> What a path leaves, in units of the contact.
   type :: zone_outcome_t
      !> The steps; shape `(n_steps, n_columns)`.
      real(dp), allocatable :: steps(:, :)
      !> Its numbers; NaN where there is none.
      real(dp) :: numbers(n_numbers) = 0
      !> The largest of work, along the path, and energies, and what is not accounted for over it.
      real(dp) :: largest_energy = 0, imbalance = 0
      !> Jumps.
      integer :: n_jumps = 0
      !> The narrowest zone in cells; enormous where nothing ever touched.
      real(dp) :: narrowest = 0
      !> What was prescribed where contact was lost; the least of several times.
      real(dp) :: lost_at = huge(1.0_dp)
   end type zone_outcome_t

contains

   !> The numbers of a contact at the end of its path.
   pure subroutine read_outcome(contact, outcome)
      !> The contact.
      type(adhesive_contact_t), intent(in) :: contact
      !> In: with the steps. Out: with the numbers.
      type(zone_outcome_t), intent(inout) :: outcome
      integer :: k

      associate (numbers => outcome%numbers, least => contact%least)
         numbers = not_a_number()
         outcome%n_jumps = contact%n_jumps
         outcome%narrowest = contact%narrowest
         ! a least load at the very end is none
         if (least%leg > 0 .and. .not. (least%was_last .and. contact%state%c > 0)) &
            & numbers([o_load, o_approach, o_clock]) = [least%load, least%approach, least%clock]
         do k = contact%n_jumps, 1, -1
            associate (jump => contact%jumps(k))
               if (.not. jump%before%c > 0) numbers([o_jump_approach, o_jump_load]) = [jump%after%approach, jump%after%load]
               if (jump%after%c > 0) cycle
               if (ieee_is_nan(numbers(o_loss)) .and. .not. contact%state%c > 0) numbers(o_loss) = jump%clock
               associate (leg => contact%legs(jump%leg))
                  if (leg%span > 0) outcome%lost_at = min(outcome%lost_at, prescribed_at(leg, (jump%clock - leg%clock)/leg%span))
               end associate
            end associate
         end do
         numbers(o_work) = contact%work
         numbers(o_stored) = stored_energy(contact%memory, contact%problem%cell)
         numbers(o_adhesion) = zone_energy(contact%problem, contact%state)
         numbers(o_taken) = contact%lost + contact%taken
         outcome%imbalance = 0
         outcome%largest_energy = max(contact%largest_work, abs(numbers(o_stored)), abs(numbers(o_adhesion)), &
            & abs(numbers(o_taken)))
         associate (largest => outcome%largest_energy)
            if (largest > 0) outcome%imbalance = (numbers(o_work) - numbers(o_stored) - numbers(o_adhesion) &
               & - numbers(o_taken))/largest
         end associate
      end associate
   end subroutine read_outcome

   !> What two grids say together: the error of second order is taken out.
   pure subroutine extrapolate(coarse, fine, ratio, best)
      !> The outcomes.
      type(zone_outcome_t), intent(in) :: coarse, fine
      !> Cells of `coarse` over those of `fine`, > 1.
      real(dp), intent(in) :: ratio
      !> Receives the outcome.
      type(zone_outcome_t), intent(out) :: best
      real(dp) :: share
      integer :: k

      best = fine
      share = 1/(ratio**2 - 1)
      do k = 1, n_numbers
         ! absent on either grid
         if (ieee_is_nan(fine%numbers(k)) .or. ieee_is_nan(coarse%numbers(k))) cycle
         best%numbers(k) = fine%numbers(k) + share*(fine%numbers(k) - coarse%numbers(k))
      end do
      do k = 1, size(fine%steps, 1)
         associate (a => fine%steps(k, :), b => coarse%steps(k, :))
            if (.not. (a(c_adhesion) > 0 .and. b(c_adhesion) > 0)) cycle
            best%steps(k, c_approach:c_load) = a(c_approach:c_load) &
               & + share*(a(c_approach:c_load) - b(c_approach:c_load))
            best%steps(k, c_adhesion) = a(c_adhesion) + share*(a(c_adhesion) - b(c_adhesion))
            if (a(c_contact) > 0 .and. b(c_contact) > 0) best%steps(k, c_contact) = &
               & max(0.0_dp, a(c_contact) + share*(a(c_contact) - b(c_contact)))
         end associate
      end do
   end subroutine extrapolate

   !> How far two outcomes are apart: the distance of their curves of approach, load and radii over time, where each axis has the
   !> length of the whole path, of their pull-off load over itself, and of their energies over the largest along the path. A jump
   !> that comes a little later is a small distance. Radii lie between nodes and converge more slowly: where they are closer than
   !> 1e-3, they count by their cube.
   pure real(dp) function difference_of(one, other) result(distance)
      !> The outcomes.
      type(zone_outcome_t), intent(in) :: one, other
      real(dp), parameter :: most_of_radii = 1.0e-3_dp
      real(dp) :: sizes(n_columns), tilt, n, step
      integer :: k, column, last

      last = size(one%steps, 1)
      sizes(c_time) = one%steps(last, c_time) - one%steps(1, c_time)
      sizes(c_load:c_adhesion) = maxval(abs(one%steps(:, c_load:c_adhesion)), 1)
      ! under a load nobody knows the approach of bodies apart
      sizes(c_approach) = 0
      do k = 1, last
         if (one%steps(k, c_adhesion) > 0) sizes(c_approach) = max(sizes(c_approach), abs(one%steps(k, c_approach)))
      end do
      distance = 0
      do k = 2, last - 1
         if (.not. all(one%steps(k - 1:k + 1, c_adhesion) > 0 .and. other%steps(k - 1:k + 1, c_adhesion) > 0)) cycle
         do column = c_approach, c_adhesion
            if (.not. sizes(column) > 0) cycle
            tilt = 0
            n = one%steps(k + 1, c_time) - one%steps(k - 1, c_time)
            if (n > 0) tilt = abs(one%steps(k + 1, column) - one%steps(k - 1, column))/n*sizes(c_time)/sizes(column)
            step = abs(one%steps(k, column) - other%steps(k, column))/sizes(column)/(1 + tilt)
            if (column > c_load) step = step*(step/most_of_radii)**2
            distance = max(distance, step)
         end do
      end do
      if (ieee_is_nan(one%numbers(o_load)) .neqv. ieee_is_nan(other%numbers(o_load))) distance = 1
      ! paths that were not pulled off have no load of it
      if (.not. (ieee_is_nan(one%numbers(o_load)) .or. ieee_is_nan(other%numbers(o_load)))) then
         if (abs(one%numbers(o_load)) > 0) &
            & distance = max(distance, abs(one%numbers(o_load) - other%numbers(o_load))/abs(one%numbers(o_load)))
      end if
      associate (energy => one%numbers(o_work:n_numbers), other_energy => other%numbers(o_work:n_numbers))
         if (one%largest_energy > 0) distance = max(distance, maxval(abs(energy - other_energy))/one%largest_energy)
      end associate
   end function difference_of

   !> Begin a path with a name out of contact, and let its retraction end where it is lost. The rates stay.
   pure subroutine close_path(legs, begin, end)
      !> The legs; shape `(n_legs)`.
      type(timed_leg_t), intent(inout) :: legs(:)
      !> What is prescribed at the begin, and at the ends of retraction.
      real(dp), intent(in) :: begin, end
      real(dp) :: clock, change, last
      integer :: k

      clock = 0
      last = begin
      do k = 1, size(legs)
         associate (leg => legs(k))
            change = abs(leg%end - leg%begin)
            if (leg%end < leg%begin) leg%end = end
            leg%begin = last
            last = leg%end
            if (change > 0) leg%span = leg%span*(abs(leg%end - leg%begin)/change)
            leg%clock = clock
            clock = clock + leg%span
         end associate
      end do
   end subroutine close_path

end module adfric_round_timed_adhesion_path

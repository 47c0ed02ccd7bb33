! SPDX-License-Identifier: GPL-3.0-or-later
!> A contact of an indenter with a viscoelastic half-space in time, without adhesion: panel after panel, from event to event.
!>
!> The edge moves in one direction as long as the gap beside it closes, or opens. Events end a panel: the edge turns, it meets the
!> begin of a piece of springs, contact is lost or made, the edge passes a corner of the profile. Memory is never wiped out by a larger
!> loop, so no loop is closed. The file is long by what ends a panel and by what follows.
module adfric_round_timed_contact
   use adfric_base_kinds, only: dp
   use adfric_interface_normal_contact, only: normal_contact_t
   use adfric_numerics_time_panels, only: n_nodes
   use adfric_round_timed_energy, only: add_face, add_panel, end_contact, start_energy, timed_energy_t
   use adfric_round_timed_event, only: by_contact, by_piece, by_time, by_turn, find_event
   use adfric_round_timed_loss, only: ends_soon, solve_end
   use adfric_round_timed_panel, only: approach_rate, cannot_solve, solve_panel, timed_panel_t
   use adfric_round_timed_path, only: falls_to_zero, later, mark_t, prescribed_at, prescribed_rate, timed_control_t, &
      & timed_leg_t
   use adfric_solid_prony, only: prony_t
   use adfric_round_timed_springs, only: free_memory, get_spot, growing, growing_again, lost, mark_of, new_timed_springs, &
      & shrinking, thin_depth, timed_springs_t
   use adfric_round_timed_sudden, only: find_touch, force_at_axis, let_go, touch_at_once, touch_t
   implicit none (type, external)
   private
   public :: timed_contact_t, start_contact, advance, error_of

   !> The part of what is tolerated that a load is where contact is lost or made at once.
   real(dp), parameter :: as_good_as_none = 0.1_dp
   !> Largest load over what is tolerated at which contact that is lost by an error is made again.
   real(dp), parameter :: lost_before = 2000

   !> A contact in time.
   type, extends(timed_springs_t) :: timed_contact_t
      !> Length in time of the panel that will be tried next; 0 before the first one.
      real(dp) :: next_span = 0
      !> Panels that were solved.
      integer :: n_panels = 0
      !> Where the work goes; found only where it is wanted, for it takes as long as the rest.
      type(timed_energy_t) :: energy
      !> Is it wanted?
      logical :: has_energy = .false.
      !> Largest error of a panel over the tolerance, as estimated.
      real(dp) :: largest_error = 0
      !> Is the path at its end?
      logical :: is_done = .false.
      !> Turns without time between, one after the other.
      integer, private :: n_instant = 0
      !> Panels of the leg.
      integer, private :: n_of_leg = 0
      !> Was contact lost or made at once?
      logical, private :: was_sudden = .false.
      !> Phase that passes until contact is made at once, 0 if it is not to be made.
      real(dp), private :: wait = 0
   end type timed_contact_t

contains

   !> A contact before the begin of its history, with what counts as small in it.
   pure subroutine start_contact(self, prony, contacts, control, legs, tolerance, is_possible)
      !> Receives the contact.
      type(timed_contact_t), intent(out) :: self
      !> The solid; its relaxed modulus is above 0.
      type(prony_t), intent(in) :: prony
      !> Contacts of the indenter with an elastic half-space of modulus 1.
      class(normal_contact_t), intent(in) :: contacts
      !> What is prescribed.
      type(timed_control_t), intent(in) :: control
      !> Its legs; shape `(n_legs)`.
      type(timed_leg_t), intent(in) :: legs(:)
      !> Largest error of approach and load, over the largest ones.
      real(dp), intent(in) :: tolerance
      !> Does the history press anywhere?
      logical, intent(out) :: is_possible
      integer, parameter :: n_looks = 32, most_steps = 200
      real(dp) :: largest, low, high, radius, moment
      integer :: k

      call new_timed_springs(self%timed_springs_t, prony, contacts, control, legs)
      call start_energy(self%energy, size(prony%times))
      self%tolerance = tolerance
      largest = 0
      do k = 0, n_looks
         largest = max(largest, maxval(prescribed_at(legs, real(k, dp)/n_looks)))
      end do
      is_possible = largest > 0
      if (.not. is_possible) return
      ! the approach that all arms together would have, the least that it may be
      high = 1
      do k = 1, most_steps
         if (reached(high) >= largest) exit
         high = 4*high
      end do
      low = 0
      do k = 1, most_steps
         self%depth_size = (low + high)/2
         if (reached(self%depth_size) >= largest) then
            high = self%depth_size
         else
            low = self%depth_size
         end if
         if (high - low < 1.0e-3_dp*high) exit
      end do
      call get_spot(contacts, self%depth_size, radius, moment)
      self%load_size = 2*self%glassy*(self%depth_size*radius - moment)
      if (control%by_approach > 0) self%load_size = self%load_size*still_there(legs(maxloc(max(legs%begin, legs%end), 1)))
      self%softness = still_there(legs(size(legs)))
      is_possible = self%depth_size > 0 .and. self%load_size > 0
      ! a sine may begin below its first look
      self%approach = 0
      if (control%by_approach > 0) self%approach = min(0.0_dp, prescribed_at(legs(1), 0.0_dp)/control%by_approach)
      self%depth = self%approach

   contains

      !> The modulus that is left at the end of a leg, over the instantaneous one. Where the largest approach is reached, the load
      !> is as large at least.
      pure real(dp) function still_there(leg) result(share)
         type(timed_leg_t), intent(in) :: leg

         associate (clock => leg%clock + leg%span)
            share = (self%relaxed + sum(self%moduli*exp(-clock/self%times)))/self%glassy
         end associate
      end function still_there

      !> What would be prescribed at an approach of a solid with the instantaneous modulus.
      pure real(dp) function reached(approach)
         real(dp), intent(in) :: approach
         real(dp) :: at, integral

         call get_spot(contacts, approach, at, integral)
         reached = control%by_approach*approach + 2*control%by_load*self%glassy*(approach*at - integral)
      end function reached

   end subroutine start_contact

   !> Go on by one panel. It is long by the ends that a panel may have.
   pure subroutine advance(self, panel, is_solved)
      type(timed_contact_t), intent(inout) :: self
      !> Receives the panel.
      type(timed_panel_t), intent(inout) :: panel
      !> Was it found?
      logical, intent(out) :: is_solved
      integer, parameter :: most_tries = 150, most_instant = 2, most_cuts = 8, most_of_leg = 3000, most_of_arms = 30000, &
         & most_for_digits = 8
      real(dp), parameter :: at_once = 64*epsilon(1.0_dp), least_span = 1.0e-12_dp, stands_still = 30, &
         & round_off = 8*epsilon(1.0_dp), digits = 1.0e-9_dp
      type(mark_t) :: mark
      real(dp) :: span, end, waited
      integer :: try, event, ended_by, n_cuts
      logical :: is_cut

      if (self%phase <= 0) then
         self%n_of_leg = 0
         self%wait = 0
         call begin_leg(self)
      end if
      ! under a load contact is never lost, but by an error of the edge: it is made again, or there is no answer
      if (presses_nothing(self)) then
         is_solved = prescribed_at(self%legs(self%leg), self%phase) <= lost_before*self%tolerance*self%load_size
         if (is_solved) call make_contact(self)
         if (presses_nothing(self)) is_solved = .false.
         if (.not. is_solved) return
      end if
      if (is_let_go(self)) call let_all_go(self)
      waited = self%wait
      span = phase_span_of(self)
      ended_by = by_time
      n_cuts = 0
      is_solved = ends_soon(self%timed_springs_t)
      if (is_solved) then
         span = (1 - self%phase) - self%phase_rest
         call solve_end(self%timed_springs_t, panel)
      end if
      do try = 1, merge(0, most_tries, is_solved)
         call solve_panel(self%timed_springs_t, span, panel)
         is_solved = panel%error < cannot_solve
         if (.not. is_solved) then
            span = span*0.3_dp
            cycle
         end if
         call find_event(self%timed_springs_t, panel, event, end)
         if (self%wait > 0) then
            event = by_time
            end = 2
         end if
         if (event /= by_time .and. (end <= -1 + at_once .or. (end + 1)/2*span <= round_off*self%phase)) then
            ! nothing comes before the event; an edge that turns again and again without moving stands still
            if (event /= by_piece) self%n_instant = self%n_instant + 1
            if (self%n_instant <= most_instant .or. event == by_piece) then
               call take_event(self, event)
               span = phase_span_of(self)
               ended_by = by_time
               n_cuts = 0
               is_solved = .false.
               cycle
            end if
            event = by_time
            end = 2
            ! so it may, but for no longer than nothing moves
            is_solved = maxval(panel%depth) - minval(panel%depth) <= stands_still*thin_depth(self%timed_springs_t, 1.0_dp)
            if (.not. is_solved) then
               span = span*0.3_dp
               cycle
            end if
         end if
         is_cut = event /= by_time .and. end < 1 - at_once .and. n_cuts < most_cuts
         ! round-off counts where a shorter panel has as much
         if (panel%error > max(1.0_dp, merge(panel%round_off, 0.0_dp, try > most_for_digits)) &
            & .and. .not. (event == by_piece .and. is_cut)) then
            is_solved = .false.
            ended_by = by_time
            span = span*min(0.6_dp, max(merge(0.03_dp, 0.2_dp, try > 1), 0.8_dp*panel%error**(-1.0_dp/n_nodes)))
         else if (is_cut) then
            n_cuts = n_cuts + 1
            is_solved = .false.
            ended_by = event
            span = span*(end + 1)/2
         else
            exit
         end if
      end do
      if (.not. is_solved) then
         if (.not. is_as_good_as_lost(self)) return
         if (self%edge_mode == shrinking) then
            call let_all_go(self)
         else
            self%largest_error = max(self%largest_error, self%load/self%load_size/self%tolerance)
            call lose_contact(self)
         end if
         span = (1 - self%phase) - self%phase_rest
         ended_by = by_time
         call solve_panel(self%timed_springs_t, span, panel)
         is_solved = .true.
      end if
      if (span > least_span) self%n_instant = 0
      self%n_panels = self%n_panels + 1
      self%n_of_leg = self%n_of_leg + 1
      ! a bounded time: a panel takes as many arms
      is_solved = self%n_of_leg <= max(most_of_leg, most_of_arms/(1 + size(self%times)))
      if (.not. is_solved) return
      self%load_size = max(self%load_size, maxval(abs(panel%load)))
     self%depth_size = max(self%depth_size, maxval(panel%depth))
      if (ended_by == by_piece .and. panel%piece_end(n_nodes) > 0.1_dp*self%tolerance*piece_size(self)) ended_by = by_time
      self%largest_error = max(self%largest_error, panel%error)
      if (self%has_energy .and. self%edge_mode /= lost) call add_panel(self%energy, self%timed_springs_t, panel)
      call choose_next_span(self, panel, ended_by)
      mark = later(mark_of(self%timed_springs_t), span)
      if (ended_by == by_time .and. mark%phase >= 1 - 4*epsilon(1.0_dp)) mark = mark_t(leg=self%leg, phase=1.0_dp)
      call accept(self, panel, mark)
      self%phase = mark%phase
      self%phase_rest = mark%rest
      ! under a load that ends at 0 the edge has no digits there, but may have a depth
      if (self%edge_mode == shrinking .and. self%touched%count > 0 .and. .not. self%control%by_approach > 0) then
         if (self%load <= min(self%tolerance, digits)*self%legs(self%leg)%begin) call let_all_go(self)
      end if
      if (self%wait > 0) then
         self%wait = self%wait - span
         if (self%wait <= round_off*waited) call touch_now(self)
      end if
      if (ended_by /= by_time) then
         call take_event(self, ended_by)
      else if (self%phase >= 1) then
         self%phase = 0
         self%leg = self%leg + 1
         self%is_done = self%leg > size(self%legs)
      end if
   end subroutine advance

   !> Has a load that ends at 0 come so near to it that the edge has no digits? What is lost with the contact is part of the error.
   pure logical function is_as_good_as_lost(self) result(is_lost)
      type(timed_contact_t), intent(in) :: self
      real(dp), parameter :: digits = 1000
      real(dp) :: share

      share = self%load/self%load_size/self%tolerance
      is_lost = .not. self%control%by_approach > 0 .and. share <= digits .and. prescribed_rate(self%legs(self%leg), 1.0_dp) < 0
   end function is_as_good_as_lost

   !> Error of approach and load over the largest ones, estimated. Panels add up, and what twelve points do not see is more for many
   !> arms: the largest lack of a panel was half of the error at worst in `bench/run timed_contact`.
   pure real(dp) function error_of(self) result(error)
      !> A contact at the end of its path.
      type(timed_contact_t), intent(in) :: self
      ! what is left out where contact is lost or made at once stays: 3.5 times as much at worst (`tests/round`)
      real(dp), parameter :: margin = 4, sudden_margin = 16

      error = max(16*epsilon(1.0_dp), merge(sudden_margin, margin, self%was_sudden)*self%tolerance*self%largest_error)
   end function error_of

   !> Size of F of the springs at the edge.
   pure real(dp) function piece_size(self)
      type(timed_contact_t), intent(in) :: self

      piece_size = self%depth_size*merge(self%relaxed, 1.0_dp, self%edge_mode == shrinking)
   end function piece_size

   !> Length in phase of the panel that is tried.
   pure real(dp) function phase_span_of(self) result(span)
      type(timed_contact_t), intent(in) :: self

      span = (1 - self%phase) - self%phase_rest
      if (self%wait > 0 .and. self%wait < span) then
         span = self%wait
         return
      end if
      associate (leg => self%legs(self%leg))
         if (leg%span*span > self%next_span .and. self%next_span > 0) span = self%next_span/leg%span
         ! two equal panels rather than one and a small rest
         associate (rest => (1 - self%phase) - self%phase_rest)
            if (span > 0.6_dp*rest .and. span < rest) span = rest/2
         end associate
      end associate
   end function phase_span_of

   !> Length of the next panel from what this one may lack.
   pure subroutine choose_next_span(self, panel, event)
      type(timed_contact_t), intent(inout) :: self
      type(timed_panel_t), intent(in) :: panel
      integer, intent(in) :: event
      real(dp) :: factor

      if (.not. panel%span > 0) return
      ! what round-off makes is no smaller in a shorter panel
      factor = min(4.0_dp, 0.8_dp*max(panel%error - panel%round_off, 1.0e-20_dp)**(-1.0_dp/n_nodes))
      if (event == by_time) self%next_span = panel%span*factor
   end subroutine choose_next_span

   !> At the begin of a leg the prescribed rate may jump: does the edge grow or shrink now?
   pure subroutine begin_leg(self)
      type(timed_contact_t), intent(inout) :: self
      real(dp) :: rate, recovery

      ! how fast a free spring at the edge recovers
      recovery = self%legs(self%leg)%span*sum(self%moduli*self%at_edge/self%times)/self%glassy
      if (self%edge_mode == lost) then
         rate = prescribed_rate(self%legs(self%leg), 0.0_dp)
         if (.not. abs(self%control%by_approach) > 0) then
            if (rate > 0) call make_contact(self)
         else if (self%depth >= 0 .and. rate/self%control%by_approach > recovery) then
            call make_contact(self)
         end if
         return
      end if
      rate = approach_rate(self%timed_springs_t)
      if (rate > recovery .or. self%touched%count == 0) then
         call set_growing(self)
      else if (rate < recovery) then
         self%edge_mode = shrinking
      end if
   end subroutine begin_leg

   !> The edge grows, over springs that were touched before, if there are any.
   pure subroutine set_growing(self)
      type(timed_contact_t), intent(inout) :: self

      self%edge_mode = merge(growing_again, growing, self%free%count > 0)
   end subroutine set_growing

   !> Contact begins at the axis; springs that were lost all at once come back so.
   pure subroutine make_contact(self)
      type(timed_contact_t), intent(inout) :: self
      real(dp) :: moment

      self%next_span = 0
      if (is_made_at_once(self)) then
         call plan_touch(self)
         return
      end if
      ! an elastic solid has no dimple
      if (size(self%times) == 0) self%free%count = 0
      call set_growing(self)
      self%load = 0
      self%drive = 0
      self%depth = 0
      if (self%free%count > 0) self%depth = self%lost_depth
      call get_spot(self%contacts, self%depth, self%radius, moment)
      self%sums = self%radius*self%at_edge
      ! no load yet
      if (size(self%times) > 0) self%sums = self%sums - self%relaxed*(self%depth*self%radius - moment)/sum(self%moduli)
      if (self%has_energy) call add_face(self%energy, self%timed_springs_t)
   end subroutine make_contact

   !> Is contact made at once? Under a load, or behind a spring, over springs that were touched before.
   pure logical function is_made_at_once(self)
      type(timed_contact_t), intent(in) :: self

      is_made_at_once = self%control%by_load > 0 .and. size(self%times) > 0 .and. self%free%count > 0
      if (is_made_at_once) is_made_at_once = .not. abs(self%legs(self%leg)%amplitude) > 0 .and. closing(self) > 0
   end function is_made_at_once

   !> How fast what is prescribed goes beyond the first contact, per phase.
   pure real(dp) function closing(self)
      type(timed_contact_t), intent(in) :: self

      associate (leg => self%legs(self%leg))
         closing = prescribed_rate(leg, self%phase) &
            & - self%control%by_approach*leg%span*sum(self%moduli*self%at_edge/self%times)/self%glassy
      end associate
   end function closing

   !> How far what is prescribed is beyond the first contact.
   pure real(dp) function beyond_contact(self) result(beyond)
      type(timed_contact_t), intent(in) :: self

      if (self%control%by_approach > 0) then
         beyond = self%control%by_approach*self%depth
      else
         beyond = prescribed_at(self%legs(self%leg), self%phase)
      end if
   end function beyond_contact

   !> Find how long there is no contact yet: until a load is as large as one that counts for nothing.
   pure subroutine plan_touch(self)
      type(timed_contact_t), intent(inout) :: self
      type(touch_t) :: touch

      associate (depth => as_good_as_none*self%tolerance*self%depth_size, load => as_good_as_none*self%tolerance*self%load_size)
         call find_touch(self%timed_springs_t, [1/depth, 0.0_dp], &
            & [merge(self%control%by_load, 0.0_dp, self%control%by_approach > 0)/depth, 1/load], touch)
      end associate
      self%wait = (self%control%by_approach*touch%rise + self%control%by_load*touch%load - beyond_contact(self))/closing(self)
      if (.not. self%wait > 0) call touch_now(self)
   end subroutine plan_touch

   !> Make contact at once, if what is prescribed presses.
   pure subroutine touch_now(self)
      type(timed_contact_t), intent(inout) :: self
      type(touch_t) :: touch
      real(dp), parameter :: nothing = epsilon(1.0_dp)**4
      real(dp) :: beyond, squares(size(self%times)), carried, above

      self%wait = 0
      beyond = beyond_contact(self)
      if (.not. beyond > nothing) return
      self%was_sudden = .true.
      call find_touch(self%timed_springs_t, [self%control%by_approach/beyond, 0.0_dp], [self%control%by_load/beyond, 0.0_dp], touch)
      above = touch%rise
      if (self%control%by_approach > 0) above = above + self%control%by_load*touch%load
      self%largest_error = max(self%largest_error, above/self%depth_size/self%tolerance, touch%load/self%load_size/self%tolerance)
      call touch_at_once(self%timed_springs_t, touch, squares, carried)
      if (self%has_energy) then
         self%energy%squares = squares
         self%energy%carried = self%energy%carried - carried
      end if
      call set_growing(self)
   end subroutine touch_now

   !> Is there a load that counts, and no contact, nor one that is awaited? A load that falls to 0 may be lost a little before.
   pure logical function presses_nothing(self)
      type(timed_contact_t), intent(in) :: self
      real(dp) :: load

      presses_nothing = self%edge_mode == lost .and. .not. self%control%by_approach > 0 .and. self%phase > 0 &
         & .and. .not. self%wait > 0 .and. size(self%times) > 0
      if (.not. presses_nothing) return
      load = prescribed_at(self%legs(self%leg), self%phase)
      presses_nothing = load > self%tolerance*self%load_size*merge(lost_before, 2*as_good_as_none, &
         & prescribed_rate(self%legs(self%leg), self%phase) < 0)
   end function presses_nothing

   !> Does a load that falls to 0 count for nothing?
   pure logical function is_let_go(self)
      type(timed_contact_t), intent(in) :: self

      is_let_go = .not. self%control%by_approach > 0 .and. self%edge_mode == shrinking .and. self%touched%count > 0 &
         & .and. self%load <= as_good_as_none*self%tolerance*self%load_size .and. self%leg <= size(self%legs)
      if (is_let_go) is_let_go = falls_to_zero(self%legs(self%leg))
      if (is_let_go) is_let_go = abs(force_at_axis(self%timed_springs_t)) <= as_good_as_none*self%tolerance*self%depth_size
   end function is_let_go

   !> All springs are let go at once.
   pure subroutine let_all_go(self)
      type(timed_contact_t), intent(inout) :: self
      real(dp) :: carried

      self%largest_error = max(self%largest_error, self%load/self%load_size/self%tolerance, &
         & abs(force_at_axis(self%timed_springs_t))/self%depth_size/self%tolerance)
      self%was_sudden = .true.
      call let_go(self%timed_springs_t, carried)
      if (self%has_energy) self%energy%carried = self%energy%carried + carried
      call lose_contact(self)
   end subroutine let_all_go

   !> Take a panel over into the state.
   pure subroutine accept(self, panel, mark)
      type(timed_contact_t), intent(inout) :: self
      type(timed_panel_t), intent(in) :: panel
      !> When it ends.
      type(mark_t), intent(in) :: mark
      logical :: is_thin, is_lost
      real(dp) :: small

      small = 0.1_dp*self%tolerance
      is_thin = maxval(panel%depth) - minval(panel%depth) <= thin_depth(self%timed_springs_t, 1.0e-2_dp)
      select case (self%edge_mode)
      case (growing, growing_again)
         if (self%edge_mode == growing_again) call shorten(self%free%ends(:, self%free%count), panel%position(n_nodes))
         if (.not. is_thin) call self%touched%push(mark, panel%span, panel%depth, panel%at_edge - panel%drive)
      case (shrinking)
         call shorten(self%touched%ends(:, self%touched%count), panel%position(n_nodes))
         if (.not. is_thin) call self%free%push(mark, panel%span, panel%depth, &
            & free_memory(self%timed_springs_t, panel%approach - panel%depth, panel%at_edge))
      end select
      self%approach = panel%approach(n_nodes)
      self%depth = panel%depth(n_nodes)
      self%radius = panel%radius(n_nodes)
      self%load = panel%load(n_nodes)
      self%drive = panel%drive(n_nodes, :)
      self%sums = panel%sums(n_nodes, :)
      self%at_edge = panel%at_edge(n_nodes, :)
      if (self%edge_mode /= shrinking) return
      is_lost = self%depth <= small*self%depth_size
      if (is_lost) call lose_contact(self)
   end subroutine accept

   !> Go on after an event.
   pure subroutine take_event(self, event)
      type(timed_contact_t), intent(inout) :: self
      !> One of `by_...`.
      integer, intent(in) :: event

      if (self%edge_mode == lost .and. event /= by_contact) return
      select case (event)
      case (by_turn)
         if (self%edge_mode == shrinking) then
            call set_growing(self)
         else
            ! what a load that rises has just touched stays in contact
            if (self%touched%count == 0 .and. .not. self%control%by_approach > 0) then
               if (prescribed_rate(self%legs(self%leg), self%phase) > 0) return
            end if
            self%edge_mode = shrinking
            if (self%touched%count == 0) call lose_contact(self)
         end if
      case (by_contact)
         call make_contact(self)
      case (by_piece)
         if (self%edge_mode == shrinking) then
            self%touched%count = self%touched%count - 1
            if (self%touched%count == 0) call lose_contact(self)
         else
            self%free%count = self%free%count - 1
            call set_growing(self)
         end if
      end select
   end subroutine take_event

   !> A piece ends where the edge is now.
   pure subroutine shorten(ends, position)
      real(dp), intent(inout) :: ends(2)
      real(dp), intent(in) :: position

      ends(2) = max(ends(1), position)
   end subroutine shorten

   !> Contact is lost.
   pure subroutine lose_contact(self)
      type(timed_contact_t), intent(inout) :: self

      self%edge_mode = lost
      self%touched%count = 0
      self%lost_depth = self%depth
      self%lost_radius = self%radius
      if (self%has_energy) call end_contact(self%energy, self%timed_springs_t)
      ! free springs go more slowly than the edge did
      self%next_span = 0
      self%depth = 0
      self%radius = 0
      self%load = 0
      self%sums = 0
   end subroutine lose_contact

end module adfric_round_timed_contact

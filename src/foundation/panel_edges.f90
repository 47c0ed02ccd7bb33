! SPDX-License-Identifier: GPL-3.0-or-later
!> Where a regime of strips ends across a 3-D surface.
!>
!> Where adhesion begins to be lost, the margin of the range passes through zero; other branches end in a fold, or go on
!> in another regime where contact is lost or begins (see `branch_ends`).
module adfric_foundation_panel_edges
   use adfric_base_kinds, only: dp
   use adfric_foundation_branch_ends, only: find_fold, find_touch
   use adfric_foundation_steady_state, only: find_steady_state, find_without_release, find_beyond_fold, continue_state, &
      & get_range_margin, branch_adhered
   use adfric_foundation_strip, only: strip_t, steady_state_t, regime_saturated_adhesion, regime_adhesion_zones, &
      & regime_adhesion_only
   use adfric_foundation_surface, only: surface_t, new_surface_strip
   use adfric_foundation_wave_shape, only: share_at
   implicit none (type, external)
   private
   public :: probe_t, edge_t, probe, locate_edge, locate_release, solve_end, look_beyond, sharp
   public :: ends_in_closed_form, ends_in_release, ends_in_fold, ends_in_touch, ends_somehow

   !> An edge known to this phase moves no result by more than round-off does.
   real(dp), parameter :: sharp = 1.0e-12_dp
   !> An edge that is solved for is known to this.
   real(dp), parameter :: solved = 1.0e-14_dp
   integer, parameter :: max_trials = 60
   !> A contact of this half width carries next to nothing, and the edge where it is lost need not be sharper.
   real(dp), parameter :: narrow = 1.0e-3_dp, sharp_enough = 1.0e-9_dp

   !> How far beyond an edge the next regime is looked at, as a share of the remaining path; the latter where the edge has been
   !> solved for.
   real(dp), parameter :: beyond_edge = 1.0e-4_dp, beyond_end = 1.0e-8_dp
   !> How far before its end a branch is looked at, as a share of the path there.
   real(dp), parameter :: last_look = 1.0e-3_dp

   !> How regimes end: where a closed form knows, where adhesion begins to be lost, in a fold, where the gap touches
   !> zero, or in a way that Newton's method does not find.
   integer, parameter :: ends_in_closed_form = 0, ends_in_release = 1, ends_in_fold = 2, ends_in_touch = 3, ends_somehow = 4

   !> An edge between two regimes across the surface.
   type :: edge_t
      !> Crosswise phase k y of the edge, 0 at the crest line, pi at the valley line.
      real(dp) :: theta = 0
      !> How the regime ends, one of `ends_...`.
      integer :: ending = ends_in_closed_form
      !> The regime that ends there.
      integer :: regime = 0
      !> The state where that regime ends.
      type(steady_state_t) :: state
      !> How well `theta` is known.
      real(dp) :: uncertainty = 0
   end type edge_t

   !> A strip that was looked at.
   type :: probe_t
      !> Crosswise phase k y of the strip.
      real(dp) :: theta = 0
      !> Its steady state.
      type(steady_state_t) :: state
   end type probe_t

contains

   !> Look at one strip.
   pure type(probe_t) function probe(surface, penetration, theta, guess, is_regime_known)
      type(surface_t), intent(in) :: surface
      !> Penetration of the crests into the undisturbed surface [h].
      real(dp), intent(in) :: penetration
      !> Crosswise phase k y [rad], 0 on the crest line and pi in the valley.
      real(dp), intent(in) :: theta
      !> State of a strip nearby; it may save time.
      type(steady_state_t), intent(in), optional :: guess
      !> Is this strip known to be in the regime of the guess, if it is stable there? Then nothing else is tried.
      logical, intent(in), optional :: is_regime_known
      type(strip_t) :: strip

      call new_surface_strip(surface, penetration, share_at(theta), strip)
      probe%theta = theta
      call find_steady_state(strip, surface%branch, probe%state, guess, is_regime_known)
   end function probe

   !> Where the regime of a strip ends, on the way to another phase where it has ended.
   pure subroutine locate_edge(surface, penetration, inside, outside, edge, n_strips)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      type(probe_t), intent(in) :: inside
      !> Crosswise phase where that regime has ended [rad].
      real(dp), intent(in) :: outside
      type(edge_t), intent(out) :: edge
      !> Number of strips solved so far; those solved here are added.
      integer, intent(inout) :: n_strips
      type(probe_t) :: last
      real(dp) :: limit
      integer :: trial
      logical :: is_found

      edge%regime = inside%state%regime
      if (surface%branch == branch_adhered .and. inside%state%regime == regime_saturated_adhesion) then
         call locate_release(surface, penetration, inside%theta, outside, edge, is_found, n_strips)
         return
      end if
      last = inside
      limit = outside
      do trial = 1, max_trials
         call locate_end(surface, penetration, last, limit, edge, n_strips)
         if (edge%ending /= ends_somehow) return
         call look_for_more(surface, penetration, edge, last, limit, n_strips, is_found)
         if (.not. is_found) return
      end do
   end subroutine locate_edge

   !> Does a branch that Newton's method lost go on? `last` is where it was met again, `limit` where it has ended.
   pure subroutine look_for_more(surface, penetration, edge, last, limit, n_strips, is_found)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      type(edge_t), intent(in) :: edge
      !> In: any strip on the branch. Out: the last strip where the branch was met again, if it was.
      type(probe_t), intent(inout) :: last
      !> Crosswise phase where the branch has ended [rad]. Out: the same, or one nearer to the edge.
      real(dp), intent(inout) :: limit
      integer, intent(inout) :: n_strips
      !> Was the branch met again beyond the edge?
      logical, intent(out) :: is_found
      type(probe_t) :: next
      real(dp) :: share, path

      is_found = .false.
      path = limit - edge%theta
      share = beyond_edge
      do while (share < 1 .and. share*abs(path) > sharp)
         next = probe(surface, penetration, edge%theta + share*path)
         n_strips = n_strips + 1
         if (next%state%regime /= edge%regime) then
            limit = next%theta
            return
         end if
         is_found = .true.
         last = next
         share = 10*share
      end do
   end subroutine look_for_more

   !> Where adhesion begins to be lost: the margin of the range is positive at `inside`, negative at `outside`.
   !> Regula falsi with the Illinois rule.
   pure subroutine locate_release(surface, penetration, inside, outside, edge, is_found, n_strips)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      !> Crosswise phases where the margin is positive and where it is negative [rad].
      real(dp), intent(in) :: inside, outside
      !> Receives the phase, how the regime ends, and how well the phase is known.
      type(edge_t), intent(inout) :: edge
      !> Does the regime end between the two phases?
      logical, intent(out) :: is_found
      integer, intent(inout) :: n_strips
      real(dp) :: low, high, at_low, at_high, value, theta
      integer :: trial, side

      low = inside
      high = outside
      at_low = margin_at(surface, penetration, low)
      at_high = margin_at(surface, penetration, high)
      is_found = at_low >= 0 .and. at_high < 0
      side = 0
      do trial = 1, max_trials
         theta = low + (high - low)/2
         if (at_low > 0 .and. at_high < 0) theta = (low*at_high - high*at_low)/(at_high - at_low)
         if (abs(high - low) <= sharp .or. abs(theta - low) <= sharp .or. abs(theta - high) <= sharp) exit
         value = margin_at(surface, penetration, theta)
         if (value >= 0) then
            low = theta
            at_low = value
            if (side == 1) at_high = at_high/2
            side = 1
         else
            high = theta
            at_high = value
            if (side == -1) at_low = at_low/2
            side = -1
         end if
      end do
      edge%theta = theta
      edge%ending = ends_in_release
      edge%uncertainty = sharp
      n_strips = n_strips + trial
   end subroutine locate_release

   !> Margin of the range in the state with adhesion in the whole gap.
   pure real(dp) function margin_at(surface, penetration, theta) result(margin)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration, theta
      type(strip_t) :: strip
      type(steady_state_t) :: state

      call new_surface_strip(surface, penetration, share_at(theta), strip)
      call find_without_release(strip, state)
      margin = get_range_margin(strip, state)
   end function margin_at

   !> Where the branch of `inside` ends: Newton's method on its end as soon as that is near enough, bisection until then.
   pure subroutine locate_end(surface, penetration, inside, outside, edge, n_strips)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      type(probe_t), intent(in) :: inside
      !> Crosswise phase where that branch has ended [rad].
      real(dp), intent(in) :: outside
      type(edge_t), intent(inout) :: edge
      integer, intent(inout) :: n_strips
      type(probe_t) :: near, next
      type(strip_t) :: strip
      real(dp) :: limit, enough
      integer :: trial
      logical :: is_inside, is_found

      near = inside
      limit = outside
      is_inside = .true.
      ! forces fade out with the width of the contact, but jump at a fold
      enough = max(sharp, min(0.01_dp*surface%tolerance, sharp_enough))
      do trial = 1, max_trials
         if (is_inside) then
            call jump_to_end(surface, penetration, near, limit, edge, is_found)
            n_strips = n_strips + 3
            if (is_found) return
         end if
         if (near%state%half_width < narrow) enough = sharp_enough
         if (abs(limit - near%theta) <= enough) exit
         next%theta = near%theta + (limit - near%theta)/2
         call new_surface_strip(surface, penetration, share_at(next%theta), strip)
         ! where Newton's method no longer follows the branch it has ended, or is looked at again from beyond
         call continue_state(strip, near%state, next%state, is_inside)
         if (is_inside) then
            near = next
         else
            limit = next%theta
         end if
      end do
      edge = edge_t(near%theta, ends_somehow, near%state%regime, near%state, abs(limit - near%theta))
      n_strips = n_strips + trial
   end subroutine locate_end

   !> Solve for the end of a branch from a strip on it, and see that it is that branch's, before `limit`.
   pure subroutine jump_to_end(surface, penetration, near, limit, edge, is_found)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      type(probe_t), intent(in) :: near
      !> Crosswise phase where that branch has ended [rad].
      real(dp), intent(in) :: limit
      !> Receives where and how the branch ends, if that is found.
      type(edge_t), intent(inout) :: edge
      !> Was the end of this branch found?
      logical, intent(out) :: is_found
      type(edge_t) :: ends(2)
      type(steady_state_t) :: last
      type(strip_t) :: strip
      real(dp) :: at_end(3), at_last(3), at_near(3)
      logical :: is_end(2)
      integer :: k

      is_found = .false.
      if (near%state%regime /= regime_adhesion_zones .and. near%state%regime /= regime_adhesion_only) return
      do k = 1, 2
         ends(k) = edge_t(near%theta, merge(ends_in_fold, ends_in_touch, k == 1), near%state%regime, near%state, solved)
         call solve_end(surface, penetration, ends(k), is_end(k))
         is_end(k) = is_end(k) .and. (ends(k)%theta - near%theta)*(ends(k)%theta - limit) <= 0
      end do
      if (.not. any(is_end)) return
      k = minloc(abs(ends%theta - near%theta), 1, is_end)
      edge = ends(k)
      ! just before its end the branch of the strip is near the state there
      call new_surface_strip(surface, penetration, share_at(edge%theta - last_look*(edge%theta - near%theta)), strip)
      call continue_state(strip, near%state, last, is_found)
      if (.not. is_found) return
      at_end = extents(edge%state)
      at_last = extents(last)
      at_near = extents(near%state)
      is_found = maxval(abs(at_last - at_end)) <= 0.1_dp*maxval(abs(at_near - at_end)) + sharp_enough
   end subroutine jump_to_end

   !> Move an end to where it is now, from where it is on a neighbouring surface.
   pure subroutine solve_end(surface, penetration, edge, is_found)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      !> In: the edge on a neighbouring surface. Out: the edge on this surface.
      type(edge_t), intent(inout) :: edge
      !> Was the end found? If not, the state of the edge is of no use.
      logical, intent(out) :: is_found

      select case (edge%ending)
      case (ends_in_fold)
         call find_fold(surface, penetration, edge%theta, edge%state, is_found)
      case (ends_in_touch)
         call find_touch(surface, penetration, edge%theta, edge%state, is_found)
      case default
         is_found = .false.
      end select
      edge%uncertainty = solved
   end subroutine solve_end

   !> Half width and centre of contact and adhesion zones together, and half width of the contact.
   pure function extents(state)
      !> A state with adhesion zones, with contact or without.
      type(steady_state_t), intent(in) :: state
      real(dp) :: extents(3)

      extents = [state%half_width, state%shift, 0.0_dp]
      if (state%regime /= regime_adhesion_zones) return
      extents = [state%half_width + (state%trailing + state%leading)/2, state%outer_shift, state%half_width]
   end function extents

   !> The first strip beyond the end of a branch.
   pure type(probe_t) function look_beyond(surface, penetration, edge, other) result(beyond)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      type(edge_t), intent(in) :: edge
      !> Crosswise phase where the branch has ended [rad].
      real(dp), intent(in) :: other
      type(strip_t) :: strip
      real(dp) :: share

      share = merge(beyond_edge, beyond_end, edge%ending == ends_somehow)
      do
         beyond%theta = edge%theta + share*(other - edge%theta)
         if (edge%ending == ends_in_fold) then
            call new_surface_strip(surface, penetration, share_at(beyond%theta), strip)
            call find_beyond_fold(strip, surface%branch, edge%state, beyond%state)
            return
         end if
         beyond = probe(surface, penetration, beyond%theta)
         if (beyond%state%regime /= edge%regime .or. share >= 1) return
         share = min(10*share, 1.0_dp)
      end do
   end function look_beyond

end module adfric_foundation_panel_edges

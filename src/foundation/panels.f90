! SPDX-License-Identifier: GPL-3.0-or-later
!> Panels across a 3-D surface: stretches of the crosswise phase \( \theta = k y \) in which all strips are in one regime.
!>
!> Where the regime changes, forces have kinks or jumps across the surface, and no quadrature rule gets past them.
!> Edges of panels are known in closed form where contact begins or saturates; others are searched for.
module adfric_foundation_panels
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_foundation_panel_edges, only: probe_t, edge_t, probe, locate_edge, locate_release, solve_end, look_beyond, sharp, &
      & ends_in_release, ends_in_touch
   use adfric_foundation_saturated_adhesion, only: saturation_level
   use adfric_foundation_steady_state, only: branch_adhered, branch_approach
   use adfric_foundation_strip, only: regime_free, regime_saturated, regime_saturated_adhesion, regime_adhesion_zones, &
      & regime_adhesion_only
   use adfric_foundation_surface, only: surface_t, is_same_surface, attach_gap_of
   use adfric_foundation_wave_shape, only: phase_of_share
   implicit none (type, external)
   private
   public :: panel_t, division_t, divide_surface

   integer, parameter :: max_panels = 24
   !> Edges that may be known in closed form: saturation, first contact, first adhesion.
   integer, parameter :: n_known = 3
   !> Strips that are looked at on each stretch between edges known in closed form.
   integer, parameter :: n_probes = 10
   !> How far from the ends of a stretch the first and last of them are, as a share of it.
   real(dp), parameter :: at_end = 1.0e-5_dp

   !> A stretch of strips in one regime.
   type :: panel_t
      !> Crosswise phase of its ends.
      real(dp) :: start = 0, finish = 0
      !> Regime of the strips, one of `regime_...`.
      integer :: regime = 0
      !> Which closed form its start is known by; 0 if it was searched for.
      integer :: kind = 0
      !> The edge at its start.
      type(edge_t) :: edge
      !> How well its two ends are known together.
      real(dp) :: blur = 0
   end type panel_t

   !> All panels of half a period, from the crest line to the valley line.
   type :: division_t
      !> The panels, from the crest line on; those behind `n_panels` have no meaning.
      type(panel_t) :: panels(max_panels)
      !> Number of panels; 0 before there are any.
      integer :: n_panels = 0
      !> Surface that the panels belong to.
      type(surface_t) :: surface
      !> Penetration of the panels [h].
      real(dp) :: penetration = 0
      !> Penetration at which these regimes were found from nothing [h].
      real(dp) :: since = 0
      !> Strips solved on the path.
      integer :: n_strips = 0
   end type division_t

contains

   !> Divide half a period into panels.
   pure subroutine divide_surface(surface, penetration, fineness, division)
      type(surface_t), intent(in) :: surface
      !> Penetration of the crests into the undisturbed surface [h].
      real(dp), intent(in) :: penetration
      !> How many times more strips than usual are looked at.
      integer, intent(in) :: fineness
      !> In: the division of a neighbouring surface, or none; it saves time. Out: the division of this surface.
      type(division_t), intent(inout) :: division
      real(dp) :: edges(n_known + 2)
      integer :: kinds(n_known + 2), n_edges, k
      logical :: is_tracked

      division%n_strips = 0
      call get_known_edges(surface, penetration, edges, kinds, n_edges)
      is_tracked = may_track(surface, penetration, division)
      if (is_tracked) call track_edges(surface, penetration, edges(:n_edges), kinds(:n_edges), division, is_tracked)
      if (is_tracked) call check_panels(surface, penetration, division, is_tracked)
      if (.not. is_tracked) then
         division%n_panels = 0
         division%since = penetration
         do k = 1, n_edges - 1
            call divide_stretch(surface, penetration, fineness*n_probes, edges(k), edges(k + 1), kinds(k), division)
         end do
      end if
      division%surface = surface
      division%penetration = penetration
      associate (panels => division%panels(:division%n_panels))
         panels%blur = panels%edge%uncertainty
         do k = 1, division%n_panels - 1
            panels(k)%blur = panels(k)%blur + panels(k + 1)%edge%uncertainty
         end do
      end associate
   end subroutine divide_surface

   !> Crosswise phases where the regime changes in closed form, with both ends, in increasing order.
   pure subroutine get_known_edges(surface, penetration, edges, kinds, n_edges)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      !> The phases, 0 first and pi last [rad].
      real(dp), intent(out) :: edges(n_known + 2)
      !> Which of the closed forms each phase is known by, 1 to `n_known`; 0 at both ends.
      integer, intent(out) :: kinds(n_known + 2)
      integer, intent(out) :: n_edges
      real(dp) :: shares(n_known), lift, excess, theta
      integer :: k, j

      lift = penetration - 1 + surface%adhesion%stress
      excess = saturation_level(surface%foundation) - 1
      shares = -1
      ! saturation: lift + Y/2 = |G| Y/2; first contact: lift + Y = 0; first adhesion: D_y = -(gap of attachment)
      if (excess > 0) shares(1) = 2*lift/excess
      shares(2) = -lift
      if (surface%branch == branch_approach) shares(3) = 1 - penetration - attach_gap_of(surface)
      edges = pi
      edges(1) = 0
      kinds = 0
      n_edges = 1
      do k = 1, n_known
         if (.not. (shares(k) > 0 .and. shares(k) < 1)) cycle
         theta = phase_of_share(shares(k))
         n_edges = n_edges + 1
         j = n_edges
         do while (edges(j - 1) > theta)
            edges(j) = edges(j - 1)
            kinds(j) = kinds(j - 1)
            j = j - 1
         end do
         edges(j) = theta
         kinds(j) = k
      end do
      n_edges = n_edges + 1
      edges(n_edges) = pi
   end subroutine get_known_edges

   !> May edges be followed to a penetration? Only where their branch leads: unloading on the adhered branch, loading on
   !> the other. The other way, strips join the branch wherever they like.
   pure logical function may_track(surface, penetration, division)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      type(division_t), intent(in) :: division

      may_track = division%n_panels > 0
      if (.not. may_track) return
      if (surface%branch == branch_adhered) then
         may_track = penetration <= division%since
      else
         may_track = penetration >= division%since
      end if
      ! without release the closed forms know every edge
      may_track = (may_track .or. surface%adhesion%stress <= 0) .and. is_same_surface(surface, division%surface)
   end function may_track

   !> Follow the edges of a neighbouring surface to where they are now. It fails where an edge is not found nearby;
   !> an edge that is born elsewhere shows when strips of the wrong regime are met.
   pure subroutine track_edges(surface, penetration, edges, kinds, division, is_tracked)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      !> Crosswise phases of the edges known in closed form now, with both ends [rad].
      real(dp), intent(in) :: edges(:)
      !> Which of the closed forms each of them is known by; 0 at both ends.
      integer, intent(in) :: kinds(:)
      !> In: the division of a neighbouring surface. Out: the same panels, with their edges on this surface.
      type(division_t), intent(inout) :: division
      !> Were all edges found nearby, in the same order?
      logical, intent(out) :: is_tracked
      real(dp) :: reach
      integer :: k, n_searched

      n_searched = count(division%panels(2:division%n_panels)%kind == 0)
      is_tracked = n_searched + size(edges) - 1 == division%n_panels
      if (.not. is_tracked) return
      reach = 20*abs(penetration - division%penetration) + 1.0e-6_dp
      do k = 2, division%n_panels
         associate (before => division%panels(k - 1), this => division%panels(k))
            if (this%kind > 0) then
               is_tracked = any(kinds == this%kind)
               if (.not. is_tracked) return
               this%edge%theta = edges(findloc(kinds, this%kind, 1))
            else
               call track_edge(surface, penetration, reach, before, this, division%n_strips, is_tracked)
               if (.not. is_tracked) return
            end if
            is_tracked = this%edge%theta > before%start
            if (.not. is_tracked) return
            before%finish = this%edge%theta
            this%start = this%edge%theta
         end associate
      end do
   end subroutine track_edges

   !> Are panels that will not be looked into, because they are free or saturated, still in their regime?
   pure subroutine check_panels(surface, penetration, division, is_right)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      !> The panels; the strips solved here are added to their number.
      type(division_t), intent(inout) :: division
      !> Are all these panels still in their regime?
      logical, intent(out) :: is_right
      type(probe_t) :: found
      real(dp), parameter :: looks(2) = [0.1_dp, 0.9_dp]
      integer :: k, look

      is_right = .true.
      do k = 1, division%n_panels
         associate (panel => division%panels(k))
            if (panel%regime /= regime_free .and. panel%regime /= regime_saturated) cycle
            do look = 1, size(looks)
               found = probe(surface, penetration, panel%start + (panel%finish - panel%start)*looks(look))
               division%n_strips = division%n_strips + 1
               is_right = found%state%regime == panel%regime
               if (.not. is_right) return
            end do
         end associate
      end do
   end subroutine check_panels

   !> Follow the edge between two panels.
   pure subroutine track_edge(surface, penetration, reach, before, this, n_strips, is_tracked)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      !> How far the edge may have moved [rad].
      real(dp), intent(in) :: reach
      !> The panel on the crest side of the edge.
      type(panel_t), intent(in) :: before
      !> The panel that the edge begins. Out: its edge has moved, but not its start.
      type(panel_t), intent(inout) :: this
      !> Number of strips solved so far; those solved here are added.
      integer, intent(inout) :: n_strips
      !> Was the edge found nearby, between the same regimes?
      logical, intent(out) :: is_tracked
      type(probe_t) :: beyond
      real(dp) :: theta, side
      integer :: next_regime

      is_tracked = reach < min(this%start - before%start, this%finish - this%start)/3
      if (.not. is_tracked) return
      theta = this%start
      side = merge(1, -1, this%edge%regime == before%regime)
      next_regime = merge(this%regime, before%regime, this%edge%regime == before%regime)
      if (this%edge%ending == ends_in_release) then
         call locate_release(surface, penetration, theta - side*reach, theta + side*reach, this%edge, is_tracked, n_strips)
      else
         call solve_end(surface, penetration, this%edge, is_tracked)
         n_strips = n_strips + 1
      end if
      is_tracked = is_tracked .and. abs(this%edge%theta - theta) < reach
      if (.not. is_tracked) return
      ! nothing may have come between
      if (this%edge%ending == ends_in_touch) then
         is_tracked = next_regime == regime_adhesion_zones .or. next_regime == regime_adhesion_only
         return
      end if
      beyond = look_beyond(surface, penetration, this%edge, this%edge%theta + side*reach)
      is_tracked = beyond%state%regime == next_regime
      n_strips = n_strips + 1
   end subroutine track_edge

   !> Divide a stretch without known edges.
   pure subroutine divide_stretch(surface, penetration, n_looks, start, finish, kind, division)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      !> Number of strips to look at where there is adhesion.
      integer, intent(in) :: n_looks
      !> Crosswise phases of the ends of the stretch [rad].
      real(dp), intent(in) :: start, finish
      !> Closed form that the start of the stretch is known by, 1 to `n_known`; 0 at the crest line.
      integer, intent(in) :: kind
      !> The panels so far; those of the stretch are added.
      type(division_t), intent(inout) :: division
      type(probe_t) :: last, next
      integer :: k, count

      count = 1
      ! without release the closed forms know every edge
      if (surface%adhesion%stress > 0) count = n_looks
      last = probe(surface, penetration, start + (finish - start)*position(1, count))
      call add_panel(division, start, last%state%regime, kind)
      do k = 2, count
         next = probe(surface, penetration, start + (finish - start)*position(k, count), last%state)
         call divide_between(surface, penetration, last, next, division)
         last = next
      end do
      division%panels(division%n_panels)%finish = finish
      division%n_strips = division%n_strips + count
   end subroutine divide_stretch

   !> Where to look on a stretch: close to its ends, where regimes are born, and evenly between.
   pure real(dp) function position(k, count)
      !> Number of the strip on the stretch, from 1.
      integer, intent(in) :: k
      !> Number of strips on the stretch.
      integer, intent(in) :: count

      if (count == 1) then
         position = 0.5_dp
      else
         position = min(max(real(k - 1, dp)/(count - 1), at_end), 1 - at_end)
      end if
   end function position

   !> Find the edges between two strips: one edge of a regime at an end, then what lies beyond it.
   pure recursive subroutine divide_between(surface, penetration, one, two, division)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      !> Two strips, the first at the smaller crosswise phase.
      type(probe_t), intent(in) :: one, two
      !> The panels up to the first strip; those up to the second one are added.
      type(division_t), intent(inout) :: division
      type(probe_t) :: beyond
      type(edge_t) :: edge

      if (one%state%regime == two%state%regime .or. division%n_panels == max_panels) return
      if (two%theta - one%theta <= sharp) then
         division%panels(division%n_panels)%finish = two%theta
         call add_panel(division, two%theta, two%state%regime, 0)
         return
      end if
      if (ends_first(surface, one%state%regime, two%state%regime)) then
         call locate_edge(surface, penetration, one, two%theta, edge, division%n_strips)
         beyond = look_beyond(surface, penetration, edge, two%theta)
         division%panels(division%n_panels)%finish = edge%theta
         call add_panel(division, edge%theta, beyond%state%regime, 0, edge)
         call divide_between(surface, penetration, beyond, two, division)
      else
         call locate_edge(surface, penetration, two, one%theta, edge, division%n_strips)
         beyond = look_beyond(surface, penetration, edge, one%theta)
         call divide_between(surface, penetration, one, beyond, division)
         division%panels(division%n_panels)%finish = edge%theta
         call add_panel(division, edge%theta, two%state%regime, 0, edge)
      end if
   end subroutine divide_between

   !> Of two regimes that follow each other, is it the first whose end divides them? On the adhered branch that is the one that
   !> adheres more, on the approach branch the one that adheres less: the other may still exist beyond. Ends in closed form have
   !> been found before.
   pure logical function ends_first(surface, one, two)
      type(surface_t), intent(in) :: surface
      !> The two regimes, each one of `regime_...`.
      integer, intent(in) :: one, two
      integer :: order(0:5)

      ! by regime number: free, adhesion only, discrete, saturated adhesion, adhesion zones, saturated
      order = [0, 1, 0, 0, 2, 0]
      if (surface%branch == branch_adhered) then
         order(regime_saturated_adhesion) = 3
      else
         order(regime_adhesion_only) = 3
      end if
      ends_first = order(one) >= order(two)
   end function ends_first

   !> Begin a panel; when there are too many the last one goes on.
   pure subroutine add_panel(division, start, regime, kind, edge)
      !> The panels so far; the new one is the last.
      type(division_t), intent(inout) :: division
      !> Crosswise phase where the panel begins [rad].
      real(dp), intent(in) :: start
      !> Regime of the strips of the panel, one of `regime_...`.
      integer, intent(in) :: regime
      !> Closed form that the start is known by, 1 to `n_known`; 0 at the crest line, or if it was searched for.
      integer, intent(in) :: kind
      !> The edge at the start, if it was located.
      type(edge_t), intent(in), optional :: edge

      if (division%n_panels < max_panels) division%n_panels = division%n_panels + 1
      division%panels(division%n_panels) = panel_t(start, pi, regime, kind)
      if (present(edge)) division%panels(division%n_panels)%edge = edge
   end subroutine add_panel

end module adfric_foundation_panels

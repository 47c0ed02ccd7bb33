! SPDX-License-Identifier: GPL-3.0-or-later
!> Branches of states of an adhesive sliding wave or cylinder, at the speed of the point.
!>
!> Along the curve from first touch the load goes to the pull-off of the partial contact (or begins there), rises to the saturation
!> fold, and falls to the end of saturation. States of a rising load are stable under load. Where all of the gap is in range
!> (saturated) or none is left (full), the state is that without adhesion at q + p0 (`sliding_wave`), and it is there from the load
!> on whose largest gap is the range.
!>
!> - `adhered`, slow unloading from full contact: saturated or full from the end of saturation on, else the partial state.
!> - `approach`, slow loading from apart, q >= 0: the partial state up to the saturation fold, else saturated or full.
!> - Where partial states are a closed curve, these two branches begin and end at extremes of the load on it: first touch has no
!>   state, and what `approach` begins with at no load is the arc of rising load whose contacts are narrower.
!> - Under penetration, `approach` is free up to -d0 and follows the partial states upwards; `adhered` comes from full contact.
module adfric_plane_adhesive_sliding_branch
   use adfric_base_kinds, only: dp
   use adfric_plane_adhesive_sliding_zones, only: adhesive_slide_t, slide_zones_t
   use adfric_plane_adhesive_sliding_bulges, only: keep_states
   use adfric_plane_adhesive_sliding_curve, only: slide_curve_t, trace_curve, trace_from_corner, roughly, &
      & state_between
   use adfric_plane_adhesive_sliding_folds, only: insert_folds
   use adfric_plane_adhesive_sliding_point_of_curve, only: curve_point_t, correct_point, by_load, by_penetration
   use adfric_plane_adhesive_sliding_saturation, only: find_saturated_contact
   use adfric_plane_sliding_wave, only: wave_contact_t, get_full_contact, wave_of_pressure, wave_of_penetration
   implicit none (type, external)
   private
   public :: slide_branches_t, slide_state_t, find_branches, state_of_load, state_of_penetration

   !> Regimes: no state; apart; contact, two zones and a free gap; all of the gap in range; full contact.
   integer, parameter, public :: regime_none = 0, regime_free = 1, regime_zones = 2, regime_saturated = 3, regime_full = 4
   !> Branches.
   integer, parameter, public :: branch_adhered = 1, branch_approach = 2

   !> Ends of the branches at a speed.
   type :: slide_branches_t
      !> What slides on what.
      type(adhesive_slide_t) :: slide
      !> Are there partial states?
      logical :: has_curve = .false.
      !> Their curve, with all extremes of load and penetration among its points.
      type(slide_curve_t) :: curve
      !> Point of the least load of the partial contact; of its largest.
      integer :: pull_off = 0, fold = 0
      !> Is the pull off at first touch?
      logical :: is_at_touch = .false.
      !> Does the curve go beyond its largest load, or to the end of saturation?
      logical :: is_complete = .false.
      !> Are there partial states whose load rises with their width, so that they are stable under load? Those at first touch count.
      logical :: has_rise = .false.
      !> Loads of these two, and the one from which contact is full.
      real(dp) :: pull_off_load = 0, fold_load = 0, full_load = 0
      !> Load and penetration at the end of saturation.
      real(dp) :: saturation_load = 0, saturation_penetration = 0
   end type slide_branches_t

   !> A state.
   type :: slide_state_t
      !> One of `regime_...`.
      integer :: regime = regime_none
      !> Load, penetration and friction (`slide_zones_t`).
      real(dp) :: load = 0, penetration = 0, friction = 0
      !> Its edges, in `regime_zones`.
      type(slide_zones_t) :: zones
      !> The contact without adhesion under load and stress in its own units, saturated or full.
      type(wave_contact_t) :: contact
   end type slide_state_t

contains

   !> The branches at the speed of a solid.
   pure subroutine find_branches(slide, branches, is_found, largest_load)
      !> What slides on what, with the compliances of its solid.
      type(adhesive_slide_t), intent(in) :: slide
      type(slide_branches_t), intent(out) :: branches
      !> Was the end of saturation found? Whether the curve was says `has_curve`.
      logical, intent(out) :: is_found
      !> Load up to which the curve of a cylinder is wanted.
      real(dp), intent(in), optional :: largest_load
      type(wave_contact_t) :: full, corner
      real(dp) :: zones(2)
      real(dp), allocatable :: loads(:)
      logical :: begins_at_touch
      integer :: n

      branches%slide = slide
      is_found = .true.
      if (slide%is_wave) then
         call get_full_contact(slide%solid, full)
         branches%full_load = full%mean_pressure/2 - slide%stress
         call find_end_of_saturation(slide, branches, corner, zones, is_found)
         if (.not. is_found) return
      end if
      call trace_curve(slide, branches%curve, branches%has_curve, largest_load)
      if (slide%is_wave .and. slide%range < 2 .and. .not. branches%curve%is_closed .and. &
         & .not. (branches%curve%reaches_touch .and. branches%curve%reaches_corner)) call trace_from_corner(slide, &
         & corner%shift%shift, corner%half_width, zones, branches%curve, branches%has_curve)
      if (.not. branches%has_curve) return
      call insert_folds(slide, branches%curve)
      begins_at_touch = .true.
      if (slide%is_wave) call keep_states(roughly(slide), branches%curve, begins_at_touch)
      loads = branches%curve%points%load
      n = size(loads)
      branches%fold = maxloc(loads, 1)
      branches%pull_off = minloc(loads(:branches%fold), 1)
      branches%is_complete = branches%curve%is_closed &
         & .or. branches%curve%reaches_touch .and. (branches%fold < n .or. branches%curve%reaches_corner)
      branches%is_at_touch = loads(branches%pull_off) > loads(1) - 1.0e-9_dp*maxval(abs(loads(:branches%fold)))
      call sharpen(slide, branches%curve%points(branches%pull_off))
      call sharpen(slide, branches%curve%points(branches%fold))
      branches%pull_off_load = branches%curve%points(branches%pull_off)%load
      branches%fold_load = branches%curve%points(branches%fold)%load
      branches%has_rise = begins_at_touch .or. branches%pull_off < branches%fold
   end subroutine find_branches

   !> Bring a point that is near the curve onto it.
   pure subroutine sharpen(slide, point)
      type(adhesive_slide_t), intent(in) :: slide
      type(curve_point_t), intent(inout) :: point
      type(curve_point_t) :: sharp
      logical :: is_found

      sharp = point
      call correct_point(slide, point%z, point%tangent, sharp, is_found)
      if (is_found) point = sharp
   end subroutine sharpen

   !> The saturated state whose largest gap is the range. Without contact the gap is 2 at most.
   pure subroutine find_end_of_saturation(slide, branches, contact, zones, is_found)
      type(adhesive_slide_t), intent(in) :: slide
      type(slide_branches_t), intent(inout) :: branches
      !> The contact, and the distances of its largest gap from both edges, if the range is below 2.
      type(wave_contact_t), intent(out) :: contact
      real(dp), intent(out) :: zones(2)
      logical, intent(out) :: is_found

      is_found = .true.
      zones = 0
      branches%saturation_load = -slide%stress
      if (slide%range >= 2) return
      call find_saturated_contact(slide%solid, slide%range, contact, zones, is_found)
      branches%saturation_load = contact%mean_pressure/2 - slide%stress
      branches%saturation_penetration = contact%penetration
   end subroutine find_end_of_saturation

   !> The state of a load on a branch.
   pure subroutine state_of_load(branches, load, branch, state, is_solved)
      type(slide_branches_t), intent(in) :: branches
      real(dp), intent(in) :: load
      integer, intent(in) :: branch
      type(slide_state_t), intent(out) :: state
      logical, intent(out) :: is_solved
      logical :: is_partial, is_saturated

      is_solved = .true.
      is_partial = branches%has_rise
      if (is_partial) is_partial = load >= branches%pull_off_load .and. load <= branches%fold_load
      is_saturated = branches%slide%is_wave .and. load >= branches%saturation_load .and. load > -branches%slide%stress
      if (branch == branch_approach .and. load < 0) return
      if (branch == branch_approach .and. is_partial) is_saturated = .false.
      if (is_saturated) then
         call solve_saturated(branches, load, state, is_solved)
         ! what unloading from full contact keeps does not depend on other states
         if (branch == branch_adhered) return
      else if (is_partial) then
         ! a cylinder that unloads comes from the wide end of its curve
         call search(branches, by_load, load, branches%pull_off, branches%fold, &
            & merge(-1, 1, branch == branch_adhered .and. .not. branches%slide%is_wave), state, is_solved)
      end if
      ! where the curve could not be followed to its end nothing is known of what is not on it
      if (branches%has_curve .and. .not. branches%is_complete .and. .not. is_partial) is_solved = .false.
      if (.not. knows_curve(branches)) is_solved = .false.
   end subroutine state_of_load

   !> Is the curve there from first touch on, or does the range leave no partial state?
   pure logical function knows_curve(branches)
      type(slide_branches_t), intent(in) :: branches

      knows_curve = branches%has_curve .and. (branches%curve%reaches_touch .or. branches%curve%is_closed)
      if (branches%slide%is_wave .and. branches%slide%range >= 2) knows_curve = .true.
   end function knows_curve

   !> Contact with all of the gap in range.
   pure subroutine solve_saturated(branches, load, state, is_solved)
      type(slide_branches_t), intent(in) :: branches
      real(dp), intent(in) :: load
      type(slide_state_t), intent(out) :: state
      logical, intent(out) :: is_solved

      call wave_of_pressure(branches%slide%solid, 2*(load + branches%slide%stress), state%contact, is_solved)
      call fill_saturated(state)
      state%load = load
   end subroutine solve_saturated

   !> Results of a contact without adhesion.
   pure subroutine fill_saturated(state)
      type(slide_state_t), intent(inout) :: state

      state%regime = merge(regime_full, regime_saturated, state%contact%is_full)
      state%penetration = state%contact%penetration
      state%friction = state%contact%friction/2
   end subroutine fill_saturated

   !> Where the curve between two points passes a load or a penetration with a rising value.
   pure subroutine search(branches, which, wanted, first, last, direction, state, is_solved)
      type(slide_branches_t), intent(in) :: branches
      integer, intent(in) :: which
      real(dp), intent(in) :: wanted
      integer, intent(in) :: first, last, direction
      type(slide_state_t), intent(out) :: state
      logical, intent(out) :: is_solved
      type(curve_point_t) :: point
      real(dp) :: a, b
      integer :: i, k

      is_solved = .true.
      do k = first, last - 1
         i = k
         if (direction < 0) i = last - 1 - (k - first)
         associate (one => branches%curve%points(i), two => branches%curve%points(i + 1))
            a = merge(one%load, one%penetration, which == by_load)
            b = merge(two%load, two%penetration, which == by_load)
            if (.not. (a <= wanted .and. wanted <= b .and. b > a)) cycle
            call find_state(branches%slide, which, wanted, one, two, point, is_solved)
            state%regime = regime_zones
            state%zones = point%zones
            state%load = point%load
            state%penetration = point%penetration
            state%friction = point%friction
            return
         end associate
      end do
   end subroutine search

   !> The state between two neighbours that has a load or a penetration.
   pure subroutine find_state(slide, which, wanted, first, second, point, is_found)
      type(adhesive_slide_t), intent(in) :: slide
      integer, intent(in) :: which
      real(dp), intent(in) :: wanted
      type(curve_point_t), intent(in) :: first, second
      type(curve_point_t), intent(out) :: point
      logical, intent(out) :: is_found
      real(dp) :: low, high, share, f, f_low, f_high, chord(4), along, scale
      integer :: i, side
      logical :: is_rising
      type(curve_point_t) :: polished
      real(dp), parameter :: beyond = 1.0e-2_dp

      f_low = merge(first%load, first%penetration, which == by_load) - wanted
      f_high = merge(second%load, second%penetration, which == by_load) - wanted
      point = first
      is_found = .true.
      scale = max(abs(f_low), abs(f_high))
      if (.not. f_low < 0) return
      point = second
      if (.not. f_high > 0) return
      low = 0
      high = 1
      side = 0
      chord = second%z - first%z
      call state_between(slide, first, second, -f_low/(f_high - f_low), point, is_found, wanted, which)
      if (is_found) then
         along = dot_product(point%z - first%z, chord)/dot_product(chord, chord)
         ! the neighbours are only near the curve
         is_rising = merge(point%load_slope, point%penetration_slope, which == by_load)*dot_product(point%tangent, chord) > 0
         if (along > -beyond .and. along < 1 + beyond .and. is_rising) return
      end if
      do i = 1, 60
         share = low - f_low*(high - low)/(f_high - f_low)
         call state_between(slide, first, second, share, point, is_found)
         if (.not. is_found) return
         f = merge(point%load, point%penetration, which == by_load) - wanted
         if (abs(f) < 1.0e-2_dp*scale) then
            polished = point
            call correct_point(slide, point%z, chord, polished, is_found, wanted, which)
            along = 0
            if (is_found) along = dot_product(polished%z - first%z, chord)/dot_product(chord, chord)
            if (is_found .and. along > low - 1.0e-6_dp .and. along < high + 1.0e-6_dp) then
               point = polished
               return
            end if
         end if
         if (f < 0) then
            low = share
            f_low = f
            if (side == 1) f_high = f_high/2
            side = 1
         else
            high = share
            f_high = f
            if (side == 2) f_low = f_low/2
            side = 2
         end if
         is_found = abs(f) < 1.0e-13_dp*max(abs(wanted), scale)
         if (is_found .or. high - low < 1.0e-13_dp) exit
      end do
      is_found = abs(f) < 1.0e-11_dp*max(abs(wanted), scale)
   end subroutine find_state

   !> The state of a penetration on a branch.
   pure subroutine state_of_penetration(branches, penetration, branch, state, is_solved)
      type(slide_branches_t), intent(in) :: branches
      real(dp), intent(in) :: penetration
      integer, intent(in) :: branch
      type(slide_state_t), intent(out) :: state
      logical, intent(out) :: is_solved
      logical :: is_saturated

      is_solved = .true.
      is_saturated = penetration >= branches%saturation_penetration .and. penetration <= 1
      if (branch == branch_approach .and. penetration <= -branches%slide%range) then
         state%regime = regime_free
         state%penetration = penetration
         return
      end if
      if (branch == branch_adhered .and. is_saturated) then
         call solve_saturated_penetration(branches, penetration, state, is_solved)
         return
      end if
      ! which arc of a closed curve a penetration leads to is not known
      is_solved = knows_curve(branches) .and. .not. branches%curve%is_closed
      if (.not. is_solved) return
      if (branches%has_curve) then
         if (branch == branch_adhered) then
            call search(branches, by_penetration, penetration, 1, size(branches%curve%points), -1, state, is_solved)
         else
            call search(branches, by_penetration, penetration, 1, size(branches%curve%points), 1, state, is_solved)
         end if
      end if
      if (state%regime == regime_none .and. is_saturated) call solve_saturated_penetration(branches, penetration, state, is_solved)
   end subroutine state_of_penetration

   !> The same at a penetration.
   pure subroutine solve_saturated_penetration(branches, penetration, state, is_solved)
      type(slide_branches_t), intent(in) :: branches
      real(dp), intent(in) :: penetration
      type(slide_state_t), intent(out) :: state
      logical, intent(out) :: is_solved

      call wave_of_penetration(branches%slide%solid, penetration, state%contact, is_solved)
      call fill_saturated(state)
      state%load = state%contact%mean_pressure/2 - branches%slide%stress
   end subroutine solve_saturated_penetration

end module adfric_plane_adhesive_sliding_branch

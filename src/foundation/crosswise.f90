! SPDX-License-Identifier: GPL-3.0-or-later
!> Sums the strips of a surface: one strip in 2-D; in 3-D an integral across the surface.
!>
!> The surface is symmetric about the crest line, so half a period is enough. Each panel of one regime is an interval of
!> its own, whose rule is raised, or which is halved, until all together meet the tolerance.
!> Saturated strips are summed in closed form, free ones not at all.
module adfric_foundation_crosswise
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_numerics_patterson, only: n_levels, n_half
   use adfric_foundation_interval, only: interval_t, new_interval, raise_interval, split_interval, can_be_raised
   use adfric_foundation_panels, only: panel_t, division_t, divide_surface
   use adfric_foundation_steady_state, only: find_steady_state
   use adfric_foundation_strip, only: strip_t, steady_state_t, regime_free, regime_saturated
   use adfric_foundation_surface, only: negligible, surface_t, totals_t, new_surface_strip, add_strip, add_totals, &
      & add_load_slope, add_regime, is_same_surface
   use adfric_foundation_wave_shape, only: share_at
   implicit none (type, external)
   private
   public :: memory_t, get_totals

   !> Intervals that a surface may be divided into before the tolerance is given up: some 10^4 strips.
   integer, parameter :: max_intervals = 200
   !> How much closer than the tolerance an error is brought, by its estimate, which may be too small.
   real(dp), parameter :: margin = 4.0_dp
   !> Intervals that there is space for at first.
   integer, parameter :: n_usual = 8
   !> How many times more strips than usual are looked at in search of edges.
   integer, parameter :: finest = 32

   !> Strips of the last surface that was summed, as first guesses for the next one.
   type :: memory_t
      !> The crest strips of the last surface and of the one before.
      type(steady_state_t) :: crest, before
      !> The last surface.
      type(surface_t) :: surface
      !> Penetration of that surface [h]; -huge before there is one.
      real(dp) :: penetration = -huge(1.0_dp)
      !> Do the surfaces change in equal steps, so that two of them foretell the next?
      logical :: is_even = .false.
      !> Is the change of the load with the penetration asked for?
      logical :: needs_slope = .true.
      !> Strips at the nodes of the intervals, shape `(-n_half:n_half, n_places)`.
      type(steady_state_t), allocatable :: states(:, :)
      !> Panels of that surface.
      type(division_t) :: division
   end type memory_t

contains

   !> Forces and areas of a surface at a penetration.
   pure subroutine get_totals(surface, penetration, memory, totals, error)
      type(surface_t), intent(in) :: surface
      !> Penetration of the crests into the undisturbed surface [h].
      real(dp), intent(in) :: penetration
      !> Strips found before, as first guesses; they save time and change nothing. Out: those found here.
      type(memory_t), intent(inout) :: memory
      !> Forces and areas per period in x (and y).
      type(totals_t), intent(out) :: totals
      !> Estimates of the quadrature errors of load and friction, in the units of `totals`.
      real(dp), intent(out) :: error(2)
      type(strip_t) :: strip
      type(steady_state_t) :: crest
      type(totals_t) :: half
      integer :: k

      error = 0
      call new_surface_strip(surface, penetration, 1.0_dp, strip)
      call find_steady_state(strip, surface%branch, crest, next_crest(memory), &
         & adheres_more=penetration >= memory%penetration .and. is_same_surface(surface, memory%surface))
      memory%surface = surface
      memory%penetration = penetration
      memory%before = memory%crest
      memory%crest = crest
      if (.not. surface%shape%is_3d) then
         call add_strip(surface, strip, crest, 1.0_dp, 1.0_dp, totals)
         if (memory%needs_slope) call add_load_slope(strip, crest, 1.0_dp, totals)
         call add_regime(totals, crest%regime)
         totals%n_closed_form = merge(1, 0, crest%regime == regime_saturated .or. crest%regime == regime_free)
      else if (surface%n_strips > 0) then
         call sum_equal_strips(surface, penetration, (surface%n_strips + 1)/2, crest, half, error)
         call sum_equal_strips(surface, penetration, surface%n_strips, crest, totals, error)
         ! what half as many strips would have given tells the error, but for that of jumps
         error = error + abs([totals%load - half%load, totals%friction - half%friction])
         totals%n_strips = totals%n_strips + half%n_strips
      else
         call integrate_strips(surface, penetration, memory, totals, error)
         do k = 1, memory%division%n_panels
            call add_regime(totals, memory%division%panels(k)%regime)
         end do
      end if
   end subroutine get_totals

   !> What the next crest strip is expected to be.
   pure type(steady_state_t) function next_crest(memory) result(next)
      !> Strips found before, of which the last two crest strips are read.
      type(memory_t), intent(in) :: memory
      real(dp) :: lengths(4), change(4)

      next = memory%crest
      if (.not. memory%is_even .or. memory%before%regime /= next%regime) return
      lengths = [next%half_width, pi - next%half_width, next%trailing, next%leading]
      change = next%half_width - memory%before%half_width
      change(2:4) = [-change(1), next%trailing - memory%before%trailing, next%leading - memory%before%leading]
      if (any(abs(change) > lengths/2)) return
      next%half_width = next%half_width + change(1)
      next%bound_width = 2*next%bound_width - memory%before%bound_width
      next%shift = 2*next%shift - memory%before%shift
      next%trailing = next%trailing + change(3)
      next%leading = next%leading + change(4)
   end function next_crest

   !> GM's sum of 2N strips of equal width.
   pure subroutine sum_equal_strips(surface, penetration, n_strips, crest, totals, jumps)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      !> Number of strips on half a period.
      integer, intent(in) :: n_strips
      !> State of the crest strip, which is the first guess.
      type(steady_state_t), intent(in) :: crest
      !> Sums over strips; all of these are added.
      type(totals_t), intent(inout) :: totals
      !> Half the changes of load and friction from strip to strip where the regime changes: the edge lies in between.
      real(dp), intent(out) :: jumps(2)
      type(strip_t) :: strip
      type(steady_state_t) :: last, state
      type(totals_t) :: one
      real(dp) :: share, width, values(2), last_values(2)
      integer :: j

      last = crest
      last_values = 0
      jumps = 0
      width = 1.0_dp/n_strips
      do j = 0, n_strips
         ! the crest line itself is looked at, but not summed
         share = share_at(pi*max(j - 0.5_dp, 0.0_dp)*width)
         call new_surface_strip(surface, penetration, share, strip)
         state = crest
         if (j > 0) call find_steady_state(strip, surface%branch, state, last)
         one = totals_t()
         call add_strip(surface, strip, state, share, width, one)
         values = [one%load, one%friction]
         if (state%regime /= last%regime) jumps = jumps + abs(values - last_values)/2
         last = state
         last_values = values
         if (j == 0) cycle
         call add_load_slope(strip, state, width, one)
         one%n_closed_form = merge(1, 0, state%regime == regime_saturated .or. state%regime == regime_free)
         call add_totals(totals, one)
         call add_regime(totals, state%regime)
      end do
   end subroutine sum_equal_strips

   !> The integral over all strips, to the tolerance of the surface.
   pure subroutine integrate_strips(surface, penetration, memory, totals, error)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      type(memory_t), intent(inout) :: memory
      !> Sums over strips; all of the surface are added.
      type(totals_t), intent(inout) :: totals
      !> Estimates of the errors of load and friction, in the units of `totals`.
      real(dp), intent(out) :: error(2)
      type(interval_t), allocatable :: intervals(:)
      type(totals_t) :: closed
      integer :: n, k, fineness
      logical :: is_fine, is_uniform, was_tracked, is_last

      allocate (intervals(n_usual))
      closed = totals
      fineness = 1
      do
         is_last = fineness > finest
         was_tracked = memory%division%n_panels > 0
         call divide_surface(surface, penetration, fineness, memory%division)
         totals%n_strips = totals%n_strips + memory%division%n_strips
         call start_intervals(surface, penetration, memory, intervals, n, totals, is_uniform)
         if (is_uniform .or. is_last) &
            & call refine_intervals(surface, penetration, memory, totals, is_last, intervals, n, is_uniform, is_fine)
         if (is_uniform .or. is_last) exit
         ! an edge was born since the last surface, or lies between the strips that were looked at: look closer
         if (.not. was_tracked) fineness = 4*fineness
         memory%division%n_panels = 0
         closed%n_strips = totals%n_strips
         totals = closed
      end do
      error = 0
      do k = 1, n
         call add_totals(totals, intervals(k)%sums(intervals(k)%level))
         error = error + intervals(k)%error + intervals(k)%blur
      end do
      totals%is_converged = totals%is_converged .and. is_fine
   end subroutine integrate_strips

   !> Raise and halve intervals until all together meet the tolerance, or a strip of another regime is met.
   pure subroutine refine_intervals(surface, penetration, memory, base, is_last, intervals, n, is_uniform, is_fine)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      type(memory_t), intent(inout) :: memory
      type(totals_t), intent(in) :: base
      !> Is the refinement to go on where a strip of another regime is met?
      logical, intent(in) :: is_last
      !> The intervals, `n` of them in use; the array grows where it is full.
      type(interval_t), allocatable, intent(inout) :: intervals(:)
      !> Number of intervals in use.
      integer, intent(inout) :: n
      !> Are all strips of each panel in its regime?
      logical, intent(inout) :: is_uniform
      !> Do all errors together meet the tolerance?
      logical, intent(out) :: is_fine
      real(dp) :: scales(2)
      integer :: worst, n_whole, last_position

      n_whole = n
      last_position = n
      is_fine = n == 0
      do while (.not. is_fine)
         call find_worst(surface%tolerance, base, intervals(:n), worst, scales, is_fine)
         if (is_fine) exit
         if (can_be_raised(intervals(worst), scales)) then
            call raise(surface, penetration, intervals(worst), memory)
            associate (this => intervals(worst))
               ! the ends of a panel are not known so well that strips of the finest rule, or of parts, could not be beyond
               if (this%position <= n_whole .and. this%level < n_levels) is_uniform = is_uniform .and. this%is_uniform
            end associate
            if (.not. (is_uniform .or. is_last)) exit
         else
            if (n == max_intervals) exit
            if (n == size(intervals)) intervals = [intervals, intervals]
            n = n + 1
            call split_interval(intervals(worst), intervals(n), last_position)
            call start_interval(surface, penetration, intervals(worst), memory)
            call start_interval(surface, penetration, intervals(n), memory)
         end if
      end do
   end subroutine refine_intervals

   !> One interval for every panel that has no closed form, which is added to the totals.
   pure subroutine start_intervals(surface, penetration, memory, intervals, n, totals, is_uniform)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      type(memory_t), intent(inout) :: memory
      !> Receives the intervals; the array grows where it is full.
      type(interval_t), allocatable, intent(inout) :: intervals(:)
      !> Number of intervals in use.
      integer, intent(out) :: n
      !> Sums over strips; those of panels in closed form are added.
      type(totals_t), intent(inout) :: totals
      !> Are all strips of each panel in its regime?
      logical, intent(out) :: is_uniform
      type(panel_t) :: panel
      integer :: k

      n = 0
      is_uniform = .true.
      do k = 1, memory%division%n_panels
         panel = memory%division%panels(k)
         if (panel%regime == regime_free .or. panel%finish <= panel%start) cycle
         if (panel%regime == regime_saturated .and. surface%shape%steepness <= 0) then
            call add_saturated_panel(surface, penetration, panel, totals)
            cycle
         end if
         n = n + 1
         if (n > size(intervals)) intervals = [intervals, intervals]
         intervals(n) = new_interval(panel, n)
         call start_interval(surface, penetration, intervals(n), memory)
         is_uniform = is_uniform .and. intervals(n)%is_uniform
      end do
   end subroutine start_intervals

   !> The first two rules of an interval, whose difference tells an error.
   pure subroutine start_interval(surface, penetration, interval, memory)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      !> In: an interval without strips. Out: the interval at its second rule.
      type(interval_t), intent(inout) :: interval
      type(memory_t), intent(inout) :: memory

      call raise(surface, penetration, interval, memory)
      call raise(surface, penetration, interval, memory)
   end subroutine start_interval

   !> Raise an interval to the next rule.
   pure subroutine raise(surface, penetration, interval, memory)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      !> The interval, whose level rises by one.
      type(interval_t), intent(inout) :: interval
      type(memory_t), intent(inout) :: memory
      type(steady_state_t), allocatable :: states(:, :)

      if (.not. allocated(memory%states)) allocate (memory%states(-n_half:n_half, n_usual))
      if (interval%position > size(memory%states, 2)) then
         allocate (states(-n_half:n_half, 2*interval%position))
         states(:, :size(memory%states, 2)) = memory%states
         call move_alloc(states, memory%states)
      end if
      call raise_interval(surface, penetration, memory%needs_slope, interval, memory%states(:, interval%position))
   end subroutine raise

   !> The interval with the largest error, and whether all errors together are within the tolerance.
   pure subroutine find_worst(tolerance, base, intervals, worst, scales, is_fine)
      !> Relative tolerance of load and friction [-].
      real(dp), intent(in) :: tolerance
      type(totals_t), intent(in) :: base
      type(interval_t), intent(in) :: intervals(:)
      !> Position of the interval with the largest error.
      integer, intent(out) :: worst
      !> Sizes of load and friction that errors are relative to.
      real(dp), intent(out) :: scales(2)
      logical, intent(out) :: is_fine
      type(totals_t) :: all_totals
      real(dp) :: error(2), largest, weight
      integer :: k

      all_totals = base
      error = 0
      do k = 1, size(intervals)
         call add_totals(all_totals, intervals(k)%sums(intervals(k)%level))
         error = error + intervals(k)%error
      end do
      ! a sum near zero cannot be had to a relative tolerance
      scales = max(abs([all_totals%load, all_totals%friction]), &
         & 0.01_dp*[all_totals%load_scale, all_totals%friction_scale], tiny(1.0_dp))
      ! nor can a friction that is nothing beside the load
      scales(2) = max(scales(2), negligible*scales(1))
      is_fine = all(margin*error <= tolerance*scales)
      worst = 1
      largest = -1
      do k = 1, size(intervals)
         weight = maxval(intervals(k)%error/scales)
         if (weight <= largest) cycle
         largest = weight
         worst = k
      end do
   end subroutine find_worst

   !> Saturated strips from start to finish in closed form (GM 17).
   pure subroutine add_saturated_panel(surface, penetration, panel, totals)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      type(panel_t), intent(in) :: panel
      !> Sums over strips; those of the panel are added.
      type(totals_t), intent(inout) :: totals
      real(dp) :: width, first, second, load, friction

      ! integrals of 1, Y and Y^2 with Y = (1 + cos theta)/2
      width = panel%finish - panel%start
      first = (width + sin(panel%finish) - sin(panel%start))/2
      second = (1.5_dp*width + 2*(sin(panel%finish) - sin(panel%start)) &
         & + (sin(2*panel%finish) - sin(2*panel%start))/4)/4
      load = ((penetration - 1)*width + first/2)/pi
      friction = surface%foundation%loss*second/4
      totals%load = totals%load + load
      totals%load_slope = totals%load_slope + width/pi
      totals%slope_bound = totals%slope_bound + width/pi
      totals%load_scale = totals%load_scale + (abs(penetration - 1)*width + first/2)/pi
      totals%friction = totals%friction + friction
      totals%friction_scale = totals%friction_scale + friction
      totals%dissipation = totals%dissipation + friction
      totals%contact = totals%contact + width/pi
      totals%n_strips = totals%n_strips + 1
      totals%n_closed_form = totals%n_closed_form + 1
   end subroutine add_saturated_panel

end module adfric_foundation_crosswise

!> A wavy surface under a given penetration or a given load.
!>
!> Under load the penetration is sought on the chosen branch where the load rises with it. On the adhered branch
!> that is the largest such penetration, where unloading arrives; on the approach branch the smallest, where loading
!> arrives. A gap is never negative and the mean displacement is K times the mean pressure, so the load of
!> endless contact is the least that a penetration can have: it bounds the penetration from above.
module adfric_wavy_equilibrium
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_base_model, only: status_solved, status_no_equilibrium, status_not_converged
   use adfric_wavy_crosswise, only: memory_t, get_totals
   use adfric_wavy_steady_state, only: branch_adhered
   use adfric_wavy_surface, only: share_of_scale, surface_t, totals_t, is_same_surface, get_relative_error
   implicit none (type, external)
   private
   public :: equilibrium_t, solve_penetration, solve_load, leads_to

   integer, parameter :: max_iterations = 100, max_steps = 1000, max_refinements = 6
   !> Mean level of the profile below its crest [h], in 2-D and 3-D.
   real(dp), parameter :: mean_depth_2d = 0.5_dp, mean_depth_3d = 0.75_dp
   !> Longest and shortest step of the penetration on the way to a bracket [h].
   real(dp), parameter :: longest_step = 0.05_dp, shortest_step = 1.0e-6_dp
   !> Relative tolerance on the way to a bracket.
   real(dp), parameter :: rough_tolerance = 1.0e-4_dp
   !> A minimum of the load is known well enough when its place is known to this [h].
   real(dp), parameter :: closest = 1.0e-10_dp
   !> Relative tolerance of what is known in closed form.
   real(dp), parameter :: round_off = 1.0e-13_dp

   !> A point: its penetration, what it carries, and how well that is known.
   type :: equilibrium_t
      !> One of `status_...`.
      integer :: status = status_solved
      !> [h]
      real(dp) :: penetration = 0
      type(totals_t) :: totals
      !> Relative error of friction and load.
      real(dp) :: error_estimate = 0
   end type equilibrium_t

   !> The load less the one that is sought, at a penetration.
   type :: trial_t
      real(dp) :: penetration = 0, excess = 0
      type(totals_t) :: totals
      real(dp) :: error(2) = 0
   end type trial_t

contains

   !> Solve a point of given penetration.
   pure subroutine solve_penetration(surface, penetration, memory, equilibrium)
      type(surface_t), intent(in) :: surface
      !> [h]
      real(dp), intent(in) :: penetration
      type(memory_t), intent(inout) :: memory
      type(equilibrium_t), intent(out) :: equilibrium
      type(trial_t) :: trial

      call try_penetration(surface, penetration, 0.0_dp, memory, trial)
      call finish(trial, 0.0_dp, equilibrium)
   end subroutine solve_penetration

   !> Solve a point of given load.
   pure subroutine solve_load(surface, load, guess, memory, equilibrium)
      type(surface_t), intent(in) :: surface
      !> Per period in x (and y) [h/K].
      real(dp), intent(in) :: load
      !> Where the branch may be followed from: see `leads_to`. `unset` if nowhere.
      real(dp), intent(in) :: guess
      type(memory_t), intent(inout) :: memory
      type(equilibrium_t), intent(out) :: equilibrium
      type(trial_t) :: low, high
      real(dp) :: excess
      logical :: is_found

      call refine_guess(surface, load, guess, memory, high, is_found)
      if (.not. is_found) then
         call find_bracket(surface, load, memory, low, high, is_found)
         if (is_found) call close_bracket(surface, load, memory, low, high)
      end if
      equilibrium%status = merge(status_no_equilibrium, status_not_converged, &
         & low%totals%is_converged .and. high%totals%is_converged)
      if (.not. is_found) return
      excess = abs(high%excess)
      ! an error of the load is one of the penetration that carries it; what so few strips as the user wants carry is their load
      if (surface%n_strips == 0) excess = excess + high%error(1)
      call finish(high, excess, equilibrium)
   end subroutine solve_load

   !> Load at a penetration.
   pure subroutine try_penetration(surface, penetration, load, memory, trial)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration, load
      type(memory_t), intent(inout) :: memory
      type(trial_t), intent(out) :: trial

      trial%penetration = penetration
      call get_totals(surface, penetration, memory, trial%totals, trial%error)
      trial%excess = trial%totals%load - load
   end subroutine try_penetration

   !> Does a trial carry the load, to a tenth of the tolerance (in 2-D to round-off)?
   pure logical function carries_load(surface, trial)
      type(surface_t), intent(in) :: surface
      type(trial_t), intent(in) :: trial
      real(dp) :: tolerance

      tolerance = round_off
      if (surface%is_3d .and. surface%n_strips == 0) tolerance = max(surface%tolerance/10, round_off)
      carries_load = abs(trial%excess) <= tolerance*max(abs(trial%totals%load), share_of_scale*trial%totals%load_scale) &
         & .and. abs(trial%excess) < huge(tolerance)
   end function carries_load

   !> Does the penetration of one load (or one penetration) lead to another on the same branch? Without adhesion it always does.
   !> With it the load need not be monotone. On the adhered branch every penetration above the one that carries a load
   !> carries more, so what carries less lies below it; on the approach branch it is the other way round.
   pure logical function leads_to(from, from_load, to, to_load)
      type(surface_t), intent(in) :: from, to
      real(dp), intent(in) :: from_load, to_load

      leads_to = from%stress <= 0 .and. to%stress <= 0
      if (leads_to .or. .not. is_same_surface(from, to)) return
      if (to%branch == branch_adhered) then
         leads_to = to_load <= from_load
      else
         leads_to = to_load >= from_load
      end if
   end function leads_to

   !> Newton's method from a neighbour's penetration.
   pure subroutine refine_guess(surface, load, guess, memory, trial, is_found)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: load, guess
      type(memory_t), intent(inout) :: memory
      type(trial_t), intent(out) :: trial
      logical, intent(out) :: is_found
      type(trial_t) :: last
      real(dp) :: penetration, step, slope
      integer :: k, regime

      is_found = .false.
      if (.not. is_set(guess)) return
      penetration = guess
      regime = memory%crest%regime
      do k = 1, max_refinements
         call try_penetration(surface, penetration, load, memory, trial)
         if (.not. trial%totals%is_converged .or. .not. trial%totals%load_slope > 0) return
         ! a 2-D surface loses adhesion all at once: its regimes overlap
         if (surface%stress > 0 .and. .not. surface%is_3d .and. memory%crest%regime /= regime) return
         is_found = carries_load(surface, trial)
         if (is_found) return
         ! regimes that spread add to the slope of the strips: the chord sees that
         slope = trial%totals%load_slope
         if (k > 1) then
            ! as near as round-off lets the penetration come
            if (.not. abs(trial%penetration - last%penetration) > 0) return
            slope = (trial%excess - last%excess)/(trial%penetration - last%penetration)
         end if
         step = -trial%excess/slope
         if (.not. (slope > 0 .and. abs(step) < longest_step)) return
         penetration = penetration + step
         last = trial
      end do
   end subroutine refine_guess

   !> A penetration that carries too little and a larger one that carries enough, next to each other on the branch: to a
   !> tolerance that tells the one from the other, or else to the one that is asked for.
   pure subroutine find_bracket(surface, load, memory, low, high, has_bracket)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: load
      type(memory_t), intent(inout) :: memory
      type(trial_t), intent(out) :: low, high
      logical, intent(out) :: has_bracket
      type(surface_t) :: rough
      real(dp) :: ends(2)

      rough = surface
      if (surface%is_3d .and. surface%stress > 0) rough%tolerance = rough_tolerance
      call bracket_load(rough, load, memory, low, high, has_bracket)
      if (.not. has_bracket .or. surface%tolerance >= rough%tolerance) return
      ends = [low%penetration, high%penetration]
      call try_penetration(surface, ends(1), load, memory, low)
      call try_penetration(surface, ends(2), load, memory, high)
      if (low%excess < 0 .and. (high%excess >= 0 .or. carries_load(surface, high))) return
      call bracket_load(surface, load, memory, low, high, has_bracket)
   end subroutine find_bracket

   !> The same to the tolerance of the surface.
   pure subroutine bracket_load(surface, load, memory, low, high, has_bracket)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: load
      type(memory_t), intent(inout) :: memory
      type(trial_t), intent(out) :: low, high
      logical, intent(out) :: has_bracket
      real(dp) :: highest

      highest = load + merge(mean_depth_3d, mean_depth_2d, surface%is_3d)
      if (surface%stress <= 0) then
         low%excess = -load
         has_bracket = load >= 0
         if (has_bracket) call try_penetration(surface, highest, load, memory, high)
         ! nothing is carried by just touching
         if (.not. load > 0) high = low
      else if (surface%branch == branch_adhered) then
         call try_penetration(surface, highest, load, memory, high)
         call descend(surface, load, memory, low, high, has_bracket)
      else
         call ascend(surface, load, highest, memory, low, high, has_bracket)
      end if
   end subroutine bracket_load

   !> Go down from a penetration that carries enough, until one carries too little.
   pure subroutine descend(surface, load, memory, low, high, has_bracket)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: load
      type(memory_t), intent(inout) :: memory
      type(trial_t), intent(out) :: low
      !> In: the highest penetration.
      type(trial_t), intent(inout) :: high
      logical, intent(out) :: has_bracket
      type(trial_t) :: turn
      real(dp) :: lowest
      integer :: k, regime

      ! adhesion does not reach further down than this
      lowest = -(surface%stress + surface%range)
      low = high
      has_bracket = carries_load(surface, high)
      if (has_bracket) return
      do k = 1, max_steps
         if (high%penetration < lowest) return
         regime = memory%crest%regime
         call step_to(surface, high%penetration, -get_step(surface, high), load, memory, low)
         has_bracket = low%excess < 0
         if (has_bracket .or. .not. low%totals%is_converged) return
         if (low%totals%load_slope <= 0 .or. (.not. surface%is_3d .and. memory%crest%regime /= regime)) then
            turn = low
            call find_turn(surface, load, regime, memory, high, turn, has_bracket)
            if (has_bracket) then
               low = turn
               return
            end if
         end if
         high = low
      end do
      low%totals%is_converged = .false.
   end subroutine descend

   !> Load a step away; a little less far where a strip happens to be at the very end of its branch.
   pure subroutine step_to(surface, penetration, step, load, memory, trial)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration, step, load
      type(memory_t), intent(inout) :: memory
      type(trial_t), intent(out) :: trial
      integer :: k

      do k = 0, 3
         call try_penetration(surface, penetration + step*(1 - k/128.0_dp), load, memory, trial)
         if (trial%totals%is_converged) return
      end do
   end subroutine step_to

   !> How far the next penetration on the way to a bracket is: a little beyond the tangent, and not too far.
   pure real(dp) function get_step(surface, trial) result(step)
      type(surface_t), intent(in) :: surface
      type(trial_t), intent(in) :: trial

      step = longest_step*max(1.0_dp, surface%stress + surface%range)
      if (trial%totals%load_slope > 0) then
         step = min(step, 1.2_dp*abs(trial%excess)/trial%totals%load_slope + shortest_step)
      end if
   end function get_step

   !> Between two penetrations the load may turn, smoothly or at the end of a regime, and pass the one that is
   !> sought: close in on the turn from `near`, in whose regime the load rises with the penetration.
   pure subroutine find_turn(surface, load, regime, memory, near, far, has_passed)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: load
      !> Regime of the crest strip at `near`.
      integer, intent(in) :: regime
      type(memory_t), intent(inout) :: memory
      type(trial_t), intent(inout) :: near
      !> In: beyond the turn. Out: where the load has passed the one that is sought, if it has.
      type(trial_t), intent(inout) :: far
      logical, intent(out) :: has_passed
      type(trial_t) :: middle, limit
      integer :: k

      limit = far
      has_passed = .false.
      do k = 1, max_iterations
         if (abs(near%penetration - limit%penetration) <= closest*max(abs(near%penetration), 1.0_dp)) return
         call try_penetration(surface, near%penetration + (limit%penetration - near%penetration)/2, load, memory, middle)
         has_passed = middle%excess < 0 .neqv. near%excess < 0
         if (has_passed) far = middle
         if (has_passed .or. .not. middle%totals%is_converged) return
         if (middle%totals%load_slope > 0 .and. (surface%is_3d .or. memory%crest%regime == regime)) then
            near = middle
         else
            limit = middle
         end if
      end do
   end subroutine find_turn

   !> Go up from where nothing is touched, until a penetration carries enough after one that did not.
   pure subroutine ascend(surface, load, highest, memory, low, high, has_bracket)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: load, highest
      type(memory_t), intent(inout) :: memory
      type(trial_t), intent(out) :: low, high
      logical, intent(out) :: has_bracket
      type(trial_t) :: turn, top
      integer :: k, regime

      has_bracket = .false.
      ! just inside the range, where adhesion draws the crest in
      call try_penetration(surface, -surface%range*(1 - closest), load, memory, low)
      high = low
      do k = 1, max_steps
         if (low%penetration >= highest .or. .not. low%totals%is_converged) return
         regime = memory%crest%regime
         call step_to(surface, low%penetration, min(get_step(surface, low), highest - low%penetration), load, memory, high)
         turn = high
         if (low%excess < 0 .and. .not. surface%is_3d .and. memory%crest%regime /= regime) then
            ! enough just before adhesion takes hold everywhere at once?
            call find_turn(surface, load, regime, memory, low, turn, has_bracket)
            if (has_bracket) high = turn
         else if (low%excess >= 0 .and. high%excess >= 0 .and. low%totals%load_slope <= 0 &
            & .and. high%totals%load_slope > 0) then
            ! a tension that is only reached between the two?
            top = high
            turn = low
            call find_turn(surface, load, memory%crest%regime, memory, top, turn, has_bracket)
            if (has_bracket) low = turn
            if (has_bracket) high = top
         end if
         has_bracket = has_bracket .or. (low%excess < 0 .and. (high%excess >= 0 .or. carries_load(surface, high)))
         if (has_bracket) return
         low = high
      end do
      low%totals%is_converged = .false.
   end subroutine ascend

   !> Close a bracket: Newton's method from its better end, with bisection wherever that gains too little.
   pure subroutine close_bracket(surface, load, memory, low, high)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: load
      type(memory_t), intent(inout) :: memory
      type(trial_t), intent(inout) :: low
      !> Out: the penetration that carries the load.
      type(trial_t), intent(inout) :: high
      type(trial_t) :: middle
      real(dp) :: width, penetration
      integer :: k

      do k = 1, max_iterations
         if (carries_load(surface, high)) return
         width = high%penetration - low%penetration
         if (width <= 2*epsilon(width)*max(abs(high%penetration), abs(low%penetration))) exit
         penetration = low%penetration + width/2
         if (mod(k, 3) > 0) then
            middle = high
            if (abs(low%excess) < abs(high%excess)) middle = low
            if (middle%totals%load_slope > 0) penetration = middle%penetration - middle%excess/middle%totals%load_slope
            if (penetration <= low%penetration .or. penetration >= high%penetration) then
               ! two loads that do not differ, as far as round-off can tell, have no chord
               penetration = low%penetration + width/2
               if (high%excess > low%excess) penetration = low%penetration - low%excess*(width/(high%excess - low%excess))
            end if
         end if
         call try_penetration(surface, penetration, load, memory, middle)
         if (middle%excess < 0 .and. .not. carries_load(surface, middle)) then
            low = middle
         else
            high = middle
         end if
      end do
      ! as far as round-off of the penetration allows, but no further
      high%totals%is_converged = abs(high%excess) <= sqrt(round_off)*high%totals%load_scale
   end subroutine close_bracket

   !> What is known of the point, and how well.
   pure subroutine finish(trial, excess, equilibrium)
      type(trial_t), intent(in) :: trial
      !> By how much the load may differ from one that is given.
      real(dp), intent(in) :: excess
      type(equilibrium_t), intent(out) :: equilibrium

      equilibrium%penetration = trial%penetration
      equilibrium%totals = trial%totals
      equilibrium%error_estimate = get_relative_error(trial%totals, trial%error, excess)
      equilibrium%status = merge(status_solved, status_not_converged, &
         & trial%totals%is_converged .and. equilibrium%error_estimate < 1)
   end subroutine finish

end module adfric_wavy_equilibrium

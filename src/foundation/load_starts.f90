! SPDX-License-Identifier: GPL-3.0-or-later
!> Where the search for the state of a load begins.
!>
!> Two surfaces enclose the load of every state at every penetration: without adhesion it carries no less, and with adhesion in
!> the whole gap no more. The load of both is a convex function of the penetration (docs/theory/columns_load.md), so Newton's
!> method from above finds where they carry a load, and passes nothing.
module adfric_foundation_load_starts
   use adfric_base_kinds, only: dp
   use adfric_foundation_crosswise, only: memory_t
   use adfric_foundation_load_search, only: find_entry, search_found, search_empty
   use adfric_foundation_load_trial, only: trial_t, try_penetration, carries_load, get_reach, indistinct
   use adfric_foundation_steady_state, only: branch_adhered
   use adfric_foundation_surface, only: surface_t, attach_gap_of
   implicit none (type, external)
   private
   public :: start_above, start_below, search_without_adhesion, highest

   integer, parameter :: max_iterations = 100
   !> Mean level of the profile below its crest [h], in 2-D and 3-D.
   real(dp), parameter :: mean_depth_2d = 0.5_dp, mean_depth_3d = 0.75_dp
   !> Relative tolerance of a start.
   real(dp), parameter :: rough_tolerance = 1.0e-4_dp
   !> A start is near enough when the next step would be this short [h].
   real(dp), parameter :: near_enough = 1.0e-5_dp
   !> By how much less than the load a start from below carries, as a share.
   real(dp), parameter :: below = 1.0e-3_dp

contains

   !> The penetration of endless contact, which carries a load or more on every branch [h].
   pure real(dp) function highest(surface, load)
      type(surface_t), intent(in) :: surface
      !> The load [h/K].
      real(dp), intent(in) :: load

      highest = load + merge(mean_depth_3d, mean_depth_2d, surface%shape%is_3d)
   end function highest

   !> Without adhesion the load is a convex function of the penetration: Newton's method from above passes nothing.
   pure subroutine search_without_adhesion(surface, load, memory, state, outcome)
      type(surface_t), intent(in) :: surface
      !> Load that is sought [h/K].
      real(dp), intent(in) :: load
      !> Strips found before, as first guesses.
      type(memory_t), intent(inout) :: memory
      !> The state of the load if the outcome is `search_found`.
      type(trial_t), intent(out) :: state
      !> One of `search_...`.
      integer, intent(out) :: outcome
      real(dp) :: penetration, next
      integer :: k

      outcome = merge(search_found, search_empty, load >= 0)
      ! nothing is carried by just touching
      if (.not. load > 0) return
      next = highest(surface, load)
      do k = 1, max_iterations
         penetration = next
         call try_penetration(surface, penetration, load, memory, state)
         if (carries_load(surface, state) .or. .not. state%totals%is_converged .or. .not. state%excess > 0) exit
         next = penetration - state%excess/state%totals%slope_bound
         if (.not. next < penetration) exit
      end do
   end subroutine search_without_adhesion

   !> A penetration above which every state carries more than a load: with adhesion in the whole gap it carries as much.
   pure subroutine start_above(surface, load, high, outcome)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: load
      !> Receives the penetration; the rest is that of the surface with adhesion in the whole gap.
      type(trial_t), intent(out) :: high
      !> `search_empty` if every penetration carries more.
      integer, intent(out) :: outcome
      type(surface_t) :: attached

      attached = surface
      attached%branch = branch_adhered
      ! more than any gap
      attached%adhesion%range = 4*(1 + surface%adhesion%stress + surface%adhesion%range + abs(load))
      call descend_convex(attached, load, load, high, outcome)
   end subroutine start_above

   !> A penetration below which every state carries less than a load, and which carries less itself.
   pure subroutine start_below(surface, load, memory, low, outcome)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: load
      type(memory_t), intent(inout) :: memory
      !> What that penetration carries, if the outcome is `search_found`.
      type(trial_t), intent(out) :: low
      integer, intent(out) :: outcome
      type(surface_t) :: bare
      type(trial_t) :: high
      real(dp) :: start

      if (load > 0) then
         bare = surface
         bare%adhesion%stress = 0
         bare%adhesion%range = 0
         call descend_convex(bare, load*(1 - below), load, low, outcome)
         start = low%penetration
         call try_penetration(surface, start, load, memory, low)
      else
         call start_above(surface, load, high, outcome)
         if (outcome /= search_found) return
         ! just inside the gap of attachment, where adhesion draws the crest in
         call try_penetration(surface, -attach_gap_of(surface)*(1 - indistinct), load, memory, low)
         call find_entry(surface, load, high%penetration, memory, low, outcome)
      end if
   end subroutine start_below

   !> Newton's method from above on a surface whose load is a convex function of the penetration, to where it carries no more
   !> than `enough`, or is near a load.
   pure subroutine descend_convex(surface, load, enough, state, outcome)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: load
      !> A load not below it, where the path may end [h/K].
      real(dp), intent(in) :: enough
      !> The last penetration, and what it carries.
      type(trial_t), intent(out) :: state
      integer, intent(out) :: outcome
      type(surface_t) :: rough
      type(memory_t) :: memory
      real(dp) :: penetration, step
      integer :: k

      outcome = search_found
      rough = surface
      rough%tolerance = max(surface%tolerance, rough_tolerance)
      penetration = highest(surface, load)
      do k = 1, max_iterations
         call try_penetration(rough, penetration, load, memory, state)
         if (.not. state%totals%is_converged .or. state%totals%load <= enough .and. enough > load) return
         step = get_reach(state, state%totals%slope_bound)
         if (step >= huge(step)/2) outcome = search_empty
         if (outcome == search_empty) return
         ! what the quadrature may be wrong by is not gone down
         step = step*max(0.0_dp, 1 - 2*state%error(1)/max(abs(state%excess), tiny(step)))
         if (.not. state%excess > 0 .or. (step <= near_enough .and. .not. enough > load)) return
         penetration = penetration - step
      end do
   end subroutine descend_convex

end module adfric_foundation_load_starts

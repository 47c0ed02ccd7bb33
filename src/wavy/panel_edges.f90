!> Where a regime of strips ends across a 3-D surface.
!>
!> Where adhesion begins to be lost, the margin of the range passes through zero; where a branch ends, 1 - multiplier
!> does, like a square root; where contact is lost, its width does.
module adfric_wavy_panel_edges
   use adfric_base_kinds, only: dp
   use adfric_wavy_steady_state, only: find_steady_state, find_without_release, continue_state, get_range_margin, &
      & branch_adhered
   use adfric_wavy_strip, only: strip_t, steady_state_t, regime_saturated_adhesion
   use adfric_wavy_surface, only: surface_t, new_surface_strip, share_at
   implicit none (type, external)
   private
   public :: probe_t, probe, locate_edge, sharp

   !> An edge known to this phase moves no result by more than round-off does.
   real(dp), parameter :: sharp = 1.0e-12_dp
   integer, parameter :: max_trials = 60
   !> A contact of this half width carries next to nothing, and the edge where it is lost need not be sharper.
   real(dp), parameter :: narrow = 1.0e-3_dp, sharp_enough = 1.0e-9_dp

   !> A strip that was looked at.
   type :: probe_t
      real(dp) :: theta = 0
      type(steady_state_t) :: state
   end type probe_t

contains

   !> Look at one strip.
   pure type(probe_t) function probe(surface, penetration, theta, guess, is_regime_known)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration, theta
      type(steady_state_t), intent(in), optional :: guess
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
      real(dp), intent(in) :: outside
      real(dp), intent(out) :: edge
      integer, intent(inout) :: n_strips

      if (surface%branch == branch_adhered .and. inside%state%regime == regime_saturated_adhesion) then
         call locate_release(surface, penetration, inside%theta, outside, edge, n_strips)
      else
         call locate_fold(surface, penetration, inside, outside, edge, n_strips)
      end if
   end subroutine locate_edge

   !> Where adhesion begins to be lost: the margin of the range is positive at `inside`, negative at `outside`.
   !> Regula falsi with the Illinois rule.
   pure subroutine locate_release(surface, penetration, inside, outside, edge, n_strips)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration, inside, outside
      real(dp), intent(out) :: edge
      integer, intent(inout) :: n_strips
      real(dp) :: low, high, at_low, at_high, value
      integer :: trial, side

      low = inside
      high = outside
      at_low = margin_at(surface, penetration, low)
      at_high = margin_at(surface, penetration, high)
      side = 0
      do trial = 1, max_trials
         edge = low + (high - low)/2
         if (at_low > 0 .and. at_high < 0) edge = (low*at_high - high*at_low)/(at_high - at_low)
         if (abs(high - low) <= sharp .or. abs(edge - low) <= sharp .or. abs(edge - high) <= sharp) exit
         value = margin_at(surface, penetration, edge)
         if (value >= 0) then
            low = edge
            at_low = value
            if (side == 1) at_high = at_high/2
            side = 1
         else
            high = edge
            at_high = value
            if (side == -1) at_low = at_low/2
            side = -1
         end if
      end do
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

   !> Where the branch of `inside` ends. Near a fold (1 - multiplier)^2 is linear, where contact is lost the square of
   !> its width: secants of both from the inside, with bisection wherever they leave the bracket.
   pure subroutine locate_fold(surface, penetration, inside, outside, edge, n_strips)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      type(probe_t), intent(in) :: inside
      real(dp), intent(in) :: outside
      real(dp), intent(out) :: edge
      integer, intent(inout) :: n_strips
      type(probe_t) :: near, far, next
      type(strip_t) :: strip
      real(dp) :: limit, guess, left, last_left, short, enough
      integer :: trial
      logical :: is_inside, is_secant

      near = inside
      far = inside
      limit = outside
      last_left = abs(limit - near%theta)
      is_secant = .false.
      edge = near%theta + (limit - near%theta)/2
      do trial = 1, max_trials
         ! where Newton's method no longer follows the branch it has ended, or is looked at again from beyond
         call new_surface_strip(surface, penetration, share_at(edge), strip)
         next%theta = edge
         call continue_state(strip, near%state, next%state, is_inside)
         if (is_inside) then
            far = near
            near = next
         else
            limit = edge
         end if
         ! forces fade out with the width of the contact, but jump at a fold
         enough = max(sharp, min(0.01_dp*surface%tolerance, sharp_enough))
         if (near%state%half_width < narrow) enough = sharp_enough
         if (abs(limit - near%theta) <= enough) exit
         edge = near%theta + (limit - near%theta)/2
         guess = nearest_end(near, far, limit)
         left = abs(guess - near%theta)
         if (left <= enough) exit
         ! short of the guess by what its error may be, as long as every step gains; then bisection once
         is_secant = is_inside .and. (guess - near%theta)*(guess - limit) < 0 &
            & .and. (.not. is_secant .or. left < last_left/4)
         last_left = left
         short = min(0.1_dp, 10*abs(near%theta - far%theta)) + 0.001_dp
         if (is_secant) edge = near%theta + (guess - near%theta)*(1 - short)
      end do
      edge = near%theta
      n_strips = n_strips + trial
   end subroutine locate_fold

   !> Where the secants through two strips of a branch expect its end; `limit` if nowhere.
   pure real(dp) function nearest_end(near, far, limit) result(theta)
      type(probe_t), intent(in) :: near, far
      real(dp), intent(in) :: limit
      real(dp) :: at_near(2), at_far(2), guess
      integer :: k

      at_near = [1 - near%state%multiplier, near%state%half_width]**2
      at_far = [1 - far%state%multiplier, far%state%half_width]**2
      theta = limit
      do k = 1, 2
         if (at_far(k) <= at_near(k)) cycle
         guess = near%theta + (near%theta - far%theta)*at_near(k)/(at_far(k) - at_near(k))
         if (abs(guess - near%theta) < abs(theta - near%theta)) theta = guess
      end do
   end function nearest_end

end module adfric_wavy_panel_edges

! SPDX-License-Identifier: GPL-3.0-or-later
!> Where a branch of strips across a 3-D surface ends, by Newton's method on the edges and the position together.
!>
!> At a fold the multiplier is 1 and the edge equations alone become singular; with the position as an unknown and the
!> multiplier as an equation they are regular. Where contact is lost, or begins, the gap in the adhesion zone just
!> touches zero. A strip is linear in 1/Y (see `surface`), so derivatives with respect to 1/Y are exact differences.
module adfric_foundation_branch_ends
   use adfric_base_kinds, only: dp
   use adfric_numerics_lapack, only: dgesv
   use adfric_foundation_contact_zone, only: decay, longest_decay
   use adfric_foundation_edge_equations, only: edge_equations_t, get_edge_equations, get_adhesion_equations, free_length
   use adfric_foundation_edges, only: edge_rates_t, get_rates, get_multiplier, largest_share, is_admissible, is_admissible_adhesion
   use adfric_foundation_phases, only: remaining_phases
   use adfric_foundation_strip, only: strip_t, steady_state_t, lifted_profile, regime_adhesion_only, regime_adhesion_zones
   use adfric_foundation_surface, only: surface_t, new_surface_strip
   use adfric_foundation_wave_shape, only: share_at, phase_of_share
   implicit none (type, external)
   private
   public :: find_fold, find_touch

   integer, parameter :: max_iterations = 15
   !> Relative step after which nothing but round-off is left, for convergence is quadratic.
   real(dp), parameter :: close_enough = 1.0e-8_dp
   !> A step that leads nowhere.
   real(dp), parameter :: longest_step = 1.0e10_dp
   !> Unknowns of a strip with contact and adhesion zones, and of one with an adhesion zone alone.
   integer, parameter :: n_zones = 4, n_adhesion = 2

   !> What a strip depends on, and its change with 1/Y.
   type :: family_t
      !> A strip of the surface, and one nearby by which its change is known.
      type(strip_t) :: strip, other
      !> 1/Y of the other strip less that of the first.
      real(dp) :: step = 1
   end type family_t

contains

   !> Where the branch of a state folds.
   pure subroutine find_fold(surface, penetration, theta, state, is_found)
      type(surface_t), intent(in) :: surface
      !> Penetration of the crests into the undisturbed surface [h].
      real(dp), intent(in) :: penetration
      !> In: a guess of the crosswise phase [rad]. Out: where the branch folds.
      real(dp), intent(inout) :: theta
      !> In: a state near the fold. Out: the state at the fold.
      type(steady_state_t), intent(inout) :: state
      !> Was a fold found, with an admissible state? If not, `state` is of no use.
      logical, intent(out) :: is_found

      call solve_end(surface, penetration, .true., theta, state, is_found)
   end subroutine find_fold

   !> Where the gap in an adhesion zone without contact just touches zero.
   pure subroutine find_touch(surface, penetration, theta, state, is_found)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      !> In: a guess of the crosswise phase [rad]. Out: where the gap touches zero.
      real(dp), intent(inout) :: theta
      !> In: a state near the touch, with contact or without. Out: the state at the touch, without contact.
      type(steady_state_t), intent(inout) :: state
      !> Was a touch found, with an admissible state? If not, `state` is of no use.
      logical, intent(out) :: is_found

      if (state%regime == regime_adhesion_zones) then
         state%half_width = state%half_width + (state%trailing + state%leading)/2
         state%shift = state%outer_shift
         state%trailing = 0
         state%leading = 0
         state%entry = 0
         state%regime = regime_adhesion_only
      end if
      call solve_end(surface, penetration, .false., theta, state, is_found)
   end subroutine find_touch

   !> Newton's method on the edges, 1/Y, and the condition that the branch ends.
   pure subroutine solve_end(surface, penetration, is_fold, theta, state, is_found)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      !> Does the branch end in a fold? Else it ends where the gap touches zero.
      logical, intent(in) :: is_fold
      !> In: a guess of the crosswise phase [rad]. Out: where the branch ends.
      real(dp), intent(inout) :: theta
      !> In: a state near the end. Out: the state at the end.
      type(steady_state_t), intent(inout) :: state
      !> Was an end found, with an admissible state? If not, `state` is of no use.
      logical, intent(out) :: is_found
      type(family_t) :: family
      real(dp) :: matrix(n_zones + 1, n_zones + 1), step(n_zones + 1, 1), inverse, share, size_now, size_last
      integer :: pivots(n_zones + 1), iteration, n, info

      is_found = .false.
      n = merge(n_zones, n_adhesion, state%regime == regime_adhesion_zones) + 1
      inverse = 1/share_at(theta)
      size_last = huge(1.0_dp)
      do iteration = 1, max_iterations
         call new_family(surface, penetration, inverse, family)
         if (n > n_adhesion + 1) then
            call get_zone_rows(family, state, matrix, step)
         else
            call get_adhesion_rows(family, state, matrix, step)
         end if
         if (is_fold) then
            call get_fold_row(family, state, matrix(n, :n), step(n, 1))
         else
            call get_touch_row(family, state, matrix(n, :n), step(n, 1))
         end if
         if (.not. all(abs(matrix(:n, :n)) < huge(1.0_dp)) .or. .not. all(abs(step(:n, 1)) < huge(1.0_dp))) return
         step = -step
         call dgesv(n, 1, matrix, n_zones + 1, pivots, step, n_zones + 1, info)
         if (info /= 0) return
         ! zones without length stay so, whatever round-off says
         if (family%strip%adhesion%is_lost_at_contact .and. n > n_adhesion + 1) step(3:4, 1) = 0
         if (.not. maxval(abs(step(:n, 1))) < longest_step) return
         size_now = maxval(abs(step(:n - 1, 1)))/state%half_width + abs(step(n, 1))/inverse
         if (.not. size_now < 2) return
         share = 1
         if (state%regime == regime_adhesion_zones) share = largest_share(state, step(:n_zones, 1))
         call take_step(state, share*step(:n - 1, 1))
         inverse = inverse + share*step(n, 1)
         if (.not. (inverse > 1 .and. state%half_width > 0 .and. state%trailing >= 0 .and. state%leading >= 0 &
            & .and. free_length(state) > 0)) return
         if (share < 1) cycle
         is_found = size_now <= close_enough .or. (size_now <= sqrt(close_enough) .and. size_now >= size_last/2)
         if (is_found) exit
         size_last = size_now
      end do
      if (.not. is_found) return
      theta = phase_of_share(1/inverse)
      call new_family(surface, penetration, inverse, family)
      call judge_end(family%strip, is_fold, state, is_found)
   end subroutine solve_end

   !> The strip at 1/Y, and one at twice that.
   pure subroutine new_family(surface, penetration, inverse, family)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      !> Inverse 1/Y of the share of the first strip, >= 1.
      real(dp), intent(in) :: inverse
      !> Both strips, and the difference of their 1/Y.
      type(family_t), intent(out) :: family

      call new_surface_strip(surface, penetration, 1/inverse, family%strip)
      call new_surface_strip(surface, penetration, 1/(2*inverse), family%other)
      family%step = inverse
   end subroutine new_family

   !> The four edge equations: derivatives by (half_width, shift, trailing, leading, 1/Y), and values.
   pure subroutine get_zone_rows(family, state, matrix, value)
      !> The strip, and another one that tells the change with 1/Y.
      type(family_t), intent(in) :: family
      !> Edges of contact and adhesion where the equations are evaluated [rad].
      type(steady_state_t), intent(in) :: state
      !> Derivatives of the equations, a row for each; the row of the end of the branch is left to be filled.
      real(dp), intent(out) :: matrix(n_zones + 1, n_zones + 1)
      !> Values of the equations, in the same rows.
      real(dp), intent(out) :: value(n_zones + 1, 1)
      type(edge_equations_t) :: equations, other

      call get_edge_equations(family%strip, with_entry(family%strip, state), equations)
      call get_edge_equations(family%other, with_entry(family%other, state), other)
      matrix = 0
      value = 0
      value(:n_zones, 1) = equations%value
      associate (e => equations)
         ! by the edges a = half_width - shift and b = half_width + shift
         matrix(1, :2) = [e%e1_a + e%e1_b, e%e1_b - e%e1_a]
         matrix(2, :3) = [e%e2_a, -e%e2_a, e%e2_m]
         matrix(3, :4) = [e%e3_a + e%e3_b, e%e3_b - e%e3_a, e%e3_a, e%e3_b]
         matrix(4, :4) = [e%e4_b, e%e4_b, 0.0_dp, e%e4_m]
         matrix(:n_zones, n_zones + 1) = (other%value - e%value)/family%step
      end associate
   end subroutine get_zone_rows

   !> The two equations of an adhesion zone without contact: derivatives by (half_width, shift, 1/Y), and values.
   pure subroutine get_adhesion_rows(family, state, matrix, value)
      type(family_t), intent(in) :: family
      !> The adhesion zone where the equations are evaluated, by its half width and shift [rad].
      type(steady_state_t), intent(in) :: state
      real(dp), intent(out) :: matrix(n_zones + 1, n_zones + 1), value(n_zones + 1, 1)
      real(dp) :: jacobian(2, 2), by_depth(2), other(2)

      matrix = 0
      value = 0
      call get_adhesion_equations(family%other, state, other, jacobian, by_depth)
      call get_adhesion_equations(family%strip, state, value(:2, 1), jacobian, by_depth)
      matrix(:2, 1) = jacobian(:, 1) + jacobian(:, 2)
      matrix(:2, 2) = jacobian(:, 2) - jacobian(:, 1)
      matrix(:2, 3) = (other - value(:2, 1))/family%step
   end subroutine get_adhesion_rows

   !> A state with the stress at entry of a strip.
   pure type(steady_state_t) function with_entry(strip, state) result(changed)
      !> The strip, whose adhesion has the stress at entry.
      type(strip_t), intent(in) :: strip
      !> State of another strip, or one whose entry is not known yet.
      type(steady_state_t), intent(in) :: state

      changed = state
      if (strip%adhesion%snaps) changed%entry = strip%adhesion%entry
   end function with_entry

   !> The condition that the multiplier is 1, freed of its denominators, which are next to nothing in slow sliding.
   pure subroutine get_fold_row(family, state, row, value)
      type(family_t), intent(in) :: family
      !> Edges where the condition is evaluated [rad].
      type(steady_state_t), intent(in) :: state
      !> Derivatives of the condition by the edges and, last, by 1/Y; shape `(n_unknowns)`.
      real(dp), intent(out) :: row(:)
      !> Value of the condition; 0 at a fold.
      real(dp), intent(out) :: value
      type(edge_rates_t) :: rates, other
      real(dp), dimension(size(row)) :: release_by, freed_by, attach_by, attached_by, damping_by
      real(dp) :: at_release, at_attach, kept
      integer :: last

      rates = get_rates(family%strip, with_entry(family%strip, state))
      other = get_rates(family%other, with_entry(family%other, state))
      last = size(row)
      at_release = drive_slope(family%strip, state%shift - state%half_width - state%trailing)
      at_attach = drive_slope(family%strip, state%shift + state%half_width + state%leading)
      release_by = 0
      release_by(:2) = [at_release, -at_release]
      attach_by = 0
      attach_by(:2) = -at_attach
      damping_by = 0
      if (state%regime == regime_adhesion_zones) then
         release_by(3) = at_release
         attach_by(4) = -at_attach
         damping_by(1) = 2*(1/family%strip%foundation%u - 1/family%strip%foundation%v)
      end if
      attached_by = attach_by
      release_by(last) = (other%release - rates%release)/family%step
      attach_by(last) = (other%attach - rates%attach)/family%step
      attached_by(last) = (other%attached - rates%attached)/family%step
      freed_by = release_by
      freed_by(last) = (other%freed - rates%freed)/family%step
      kept = exp(-min(rates%damping, longest_decay))
      associate (r => rates)
         value = kept*r%freed*r%attached - r%release*r%attach
         row = kept*(freed_by*r%attached + r%freed*attached_by - r%freed*r%attached*damping_by) &
            & - release_by*r%attach - r%release*attach_by
      end associate
   end subroutine get_fold_row

   !> Slope of the drive.
   pure real(dp) function drive_slope(strip, xi)
      type(strip_t), intent(in) :: strip
      !> Phase [rad]; the crest is at 0.
      real(dp), intent(in) :: xi

      drive_slope = -sin(xi) + strip%foundation%v*cos(xi)
   end function drive_slope

   !> The condition that the least gap in an adhesion zone without contact is zero. Where it is least it does not
   !> change with the position, so only the edge where the zone begins and the strip count.
   pure subroutine get_touch_row(family, state, row, value)
      type(family_t), intent(in) :: family
      !> The adhesion zone where the condition is evaluated, by its half width and shift [rad].
      type(steady_state_t), intent(in) :: state
      !> Derivatives of the condition by half width, shift and 1/Y; shape `(3)`.
      real(dp), intent(out) :: row(:)
      !> Least gap in the adhesion zone [c]; huge where the gap has no minimum there.
      real(dp), intent(out) :: value
      real(dp) :: b, span, gap, other_gap, lost, w

      b = state%half_width + state%shift
      row = 0
      associate (strip => family%strip, other => family%other, v => family%strip%foundation%v)
         span = remaining_phases(strip, b, 0.0_dp, .false.)
         value = huge(1.0_dp)
         if (span < 0 .or. span >= 2*state%half_width) return
         lost = decay(span/v)
         gap = strip%adhesion%attached_gap
         other_gap = other%adhesion%attached_gap
         w = lifted_profile(strip, b) + gap
         value = gap - 2*sin(b - span/2)*sin(span/2) - w*lost
         row(:2) = -(sin(b) + w/v)*(1 - lost)
         row(3) = (other_gap - gap - (lifted_profile(other, b) + other_gap - w)*lost)/family%step
      end associate
   end subroutine get_touch_row

   !> Add a step to the edges of a state.
   pure subroutine take_step(state, step)
      type(steady_state_t), intent(inout) :: state
      !> Changes of half_width and shift, or also of trailing and leading [rad]; shape `(2)` or `(4)`.
      real(dp), intent(in) :: step(:)

      state%half_width = state%half_width + step(1)
      state%shift = state%shift + step(2)
      if (size(step) == n_adhesion) return
      state%trailing = state%trailing + step(3)
      state%leading = state%leading + step(4)
      state%outer_shift = state%outer_shift + step(2) + (step(4) - step(3))/2
   end subroutine take_step

   !> Is the end that was found one of admissible states?
   pure subroutine judge_end(strip, is_fold, state, is_end)
      type(strip_t), intent(in) :: strip
      logical, intent(in) :: is_fold
      !> The state at the end; its entry and its multiplier are set.
      type(steady_state_t), intent(inout) :: state
      !> Is the state admissible, and stable if it is a touch?
      logical, intent(out) :: is_end

      state%is_converged = .true.
      state%entry = 0
      state = with_entry(strip, state)
      state%multiplier = 1
      if (.not. is_fold) state%multiplier = get_multiplier(strip, state)
      if (state%regime == regime_adhesion_zones) then
         is_end = is_admissible(strip, state)
      else
         ! beyond a touch on the unstable side there is a fold
         is_end = is_admissible_adhesion(strip, state, may_touch=.not. is_fold) .and. (is_fold .or. state%multiplier < 1)
      end if
   end subroutine judge_end

end module adfric_foundation_branch_ends

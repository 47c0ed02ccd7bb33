! SPDX-License-Identifier: GPL-3.0-or-later
!> Limits of the pull-off load of an indenter on a viscoelastic half-space, each an elastic problem of the same profile:
!>
!> - relaxed, of slow retraction: the relaxed modulus;
!> - glassy, of approach and retraction that are both fast: the instantaneous modulus;
!> - frozen, of fast retraction after a relaxed contact: the memory has the profile of the contact but for a share 1/r, where r is
!>   the instantaneous modulus over the relaxed one. The profile that is left, g/r on the instantaneous modulus, is that of g on the
!>   relaxed one with r times the range, while the zone lies within the relaxed contact. Where it does not, the memory of the
!>   relaxed zone is a part of the profile: the states of that problem are followed from the rested one.
module adfric_round_timed_adhesion_limits
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_round_contact, only: branch_stable, find_contact
   use adfric_round_contact_state, only: contact_t
   use adfric_round_curve, only: control_load
   use adfric_round_dugdale_curve, only: dugdale_curve_t
   use adfric_round_survey, only: survey_t, survey_curve
   use adfric_round_timed_adhesion_problem, only: set_shape, zone_problem_t, zone_state_t
   use adfric_round_timed_adhesion_zone, only: solve_zone, sum_up
   use adfric_round_timed_path, only: timed_control_t
   implicit none (type, external)
   private
   public :: pull_off_limits_t, find_limits

   !> The loads, in units of the relaxed contact.
   type :: pull_off_limits_t
      !> Each is NaN where it was not found.
      real(dp) :: relaxed = 0, glassy = 0, frozen = 0
   end type pull_off_limits_t

contains

   !> The limits.
   pure subroutine find_limits(curve, ratio, rested, control, limits)
      !> The curve of the relaxed contact.
      type(dugdale_curve_t), intent(in) :: curve
      !> The instantaneous modulus over the relaxed one, >= 1.
      real(dp), intent(in) :: ratio
      !> The relaxed contact that is frozen, and what is prescribed when it is pulled.
      type(contact_t), intent(in) :: rested
      type(timed_control_t), intent(in) :: control
      !> Receives the loads.
      type(pull_off_limits_t), intent(out) :: limits
      real(dp) :: radius

      call find_pull_off(curve, 1.0_dp, 1.0_dp, limits%relaxed, radius)
      call find_pull_off(curve, 1/ratio, 1.0_dp, limits%glassy, radius)
      limits%glassy = ratio*limits%glassy
      call find_pull_off(curve, 1.0_dp, ratio, limits%frozen, radius)
      if (.not. radius <= rested%spot%radius) call follow_frozen(curve, ratio, rested, control, limits%frozen)
   end subroutine find_limits

   !> The least load of the frozen problem, from three grids: the memory of a zone ends as a square root, so that their error falls
   !> as the 3/2th power of a cell.
   pure subroutine follow_frozen(curve, ratio, rested, control, load)
      type(dugdale_curve_t), intent(in) :: curve
      real(dp), intent(in) :: ratio
      type(contact_t), intent(in) :: rested
      type(timed_control_t), intent(in) :: control
      !> Receives the load; NaN where grids do not agree.
      real(dp), intent(out) :: load
      integer, parameter :: fewest = 200, per_zone = 20, most_cells = 20000
      real(dp), parameter :: enough = 1.0e-4_dp
      real(dp) :: loads(3), gain
      integer :: grid, n

      associate (a => rested%spot%radius, c => rested%adhesion_radius)
         loads = not_a_number()
         n = fewest
         if (c > a) n = max(n, ceiling(min(real(most_cells, dp), per_zone*c/(c - a))))
         do grid = 1, 3
            call pull_frozen(curve, ratio, rested, control, n*2**(grid - 1), loads(grid))
         end do
      end associate
      gain = 1/(2*sqrt(2.0_dp) - 1)
      load = loads(3) + gain*(loads(3) - loads(2))
      ! false for NaN
      if (.not. abs(load - loads(2) - gain*(loads(2) - loads(1))) <= enough*abs(load)) load = not_a_number()
   end subroutine follow_frozen

   !> The least load along the states that a pull meets, on one grid: those that have less of what is prescribed than all before.
   pure subroutine pull_frozen(curve, ratio, rested, control, n, load)
      type(dugdale_curve_t), intent(in) :: curve
      real(dp), intent(in) :: ratio
      type(contact_t), intent(in) :: rested
      type(timed_control_t), intent(in) :: control
      !> Cells up to the radius of adhesion.
      integer, intent(in) :: n
      !> Receives the load; NaN where a state was not found.
      real(dp), intent(out) :: load
      integer, parameter :: most_steps = 200000
      real(dp), parameter :: least_step = 1.0e-9_dp
      type(zone_problem_t) :: problem
      type(zone_state_t) :: state
      real(dp) :: x, c, step, least, prescribed, radii(3), loads(3), guess
      integer :: k

      load = not_a_number()
      call set_shape(problem, curve%shape)
      problem%stress = curve%stress
      ! displacements times r: a profile g on the relaxed modulus, and beyond the edge of contact what the memory lacks of it
      problem%range = ratio*curve%range
      associate (a_r => rested%spot%radius, c_r => rested%adhesion_radius)
         problem%cell = c_r/n
         ! the memory has a kink at the edge of contact, which is a node
         if (a_r > problem%cell) problem%cell = a_r/anint(a_r/problem%cell)
         allocate (problem%memory(0:n + 4), source=0.0_dp)
         do k = 0, ubound(problem%memory, 1)
            x = k*problem%cell
            if (.not. x > a_r*(1 + 4*epsilon(x))) cycle
            problem%memory(k) = (ratio - 1)*(problem%depth_at(x) - rested%approach &
               & - 2*curve%stress*sqrt(max((c_r - x)*(c_r + x), 0.0_dp)))
         end do
         least = huge(least)
         loads = least
         radii = 0
         guess = a_r
         c = c_r
         do k = 0, most_steps
            if (.not. c > problem%cell) exit
            call sum_up(problem, c, guess, -0.5_dp, .false.)
            call solve_zone(problem, c, guess, state)
            if (.not. state%is_found) then
               load = not_a_number()
               return
            end if
            ! there is no memory within the rested contact
            problem%anchor = min(nint(a_r/problem%cell), int(state%a/problem%cell))
            ! neither radius moves by more than half a cell
            step = problem%cell/(2*max(1.0_dp, abs(state%a_slope)))
            guess = max(state%a/2, state%a - state%a_slope*step)
            c = c - max(step, least_step*c_r)
            prescribed = control%by_load*state%load
            if (control%by_approach > 0) prescribed = prescribed + control%by_approach*state%approach/ratio
            if (.not. prescribed < least) cycle
            least = prescribed
            radii = [radii(2:), state%c]
            loads = [loads(2:), state%load]
            if (k == 0) load = state%load
            load = min(load, state%load, vertex_of(radii, loads))
         end do
      end associate
   end subroutine pull_frozen

   !> The least value of a parabola through three points, if the middle one is the lowest.
   pure real(dp) function vertex_of(positions, values) result(least)
      !> The positions, in order, and the values; shape `(3)`.
      real(dp), intent(in) :: positions(:), values(:)
      real(dp) :: first, second, third

      least = values(2)
      if (.not. (values(1) > values(2) .and. values(3) > values(2) .and. values(1) < huge(least))) return
      first = (values(2) - values(1))/(positions(2) - positions(1))
      second = (values(3) - values(2))/(positions(3) - positions(2))
      third = (second - first)/(positions(3) - positions(1))
      ! from the middle point on
      first = first + third*(positions(2) - positions(1))
      if (abs(third) > 0) least = values(2) - first**2/(4*third)
   end function vertex_of

   !> Pull-off of a curve with another stress and another range, and the radius of adhesion there.
   pure subroutine find_pull_off(curve, stress_factor, range_factor, load, radius)
      type(dugdale_curve_t), intent(in) :: curve
      !> What stress and range are multiplied by.
      real(dp), intent(in) :: stress_factor, range_factor
      !> Receive load and radius.
      real(dp), intent(out) :: load, radius
      real(dp), parameter :: beside = 1.0e-10_dp
      type(dugdale_curve_t) :: other
      type(survey_t) :: survey
      type(contact_t) :: contact

      allocate (other%shape, source=curve%shape)
      other%stress = stress_factor*curve%stress
      other%range = range_factor*curve%range
      call survey_curve(other, control_load, survey)
      load = not_a_number()
      radius = huge(radius)
      if (.not. survey%ends%is_converged) return
      load = survey%ends%pull_off_load
      call find_contact(other, survey, control_load, load*(1 - beside), .true., branch_stable, contact)
      if (contact%is_found) radius = contact%adhesion_radius
   end subroutine find_pull_off

end module adfric_round_timed_adhesion_limits

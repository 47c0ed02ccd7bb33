! SPDX-License-Identifier: GPL-3.0-or-later
!> The contact of an instant with a zone of adhesion of Dugdale's law, on a solid that remembers: an elastic problem of modulus E
!> and profile G(x) = g(x) + w(x). The profile g of the shape is exact; the memory w is straight between nodes of one distance, and
!> integrated exactly. With s^2 = c^2 - a^2, cos(t) = a/c and the integral J of `adfric_round_annulus`,
!>
!>     h = (2/pi) (J + int w'(x) arccos(x/c) dx) + (4 S/pi E) [s t - (c - a)],   a < x < c
!>     E [G(a) - delta] = 2 S s,    P = E {P1(a) + 2 int [w(a) - w(x)] dx} - 2 S (c^2 t + a s)
!>
!> For a given c the first equation has one a, since its right side falls as a rises. Where it is too small at a = 0, nothing
!> touches: delta then comes from the gap at c, and the second equation is not needed.
!> Beyond the edge of a flat punch states go on with another parameter: `adfric_round_timed_adhesion_face`.
module adfric_round_timed_adhesion_zone
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi, pi
   use adfric_round_annulus, only: get_annulus
   use adfric_round_shape, only: spot_t, within_edge
   use adfric_round_timed_adhesion_face, only: solve_face
   use adfric_round_timed_adhesion_problem, only: get_memory, zone_problem_t, zone_state_t
   use adfric_round_timed_adhesion_sums, only: expand_far_cells, is_near, move_sum, zone_sum_t
   implicit none (type, external)
   private
   public :: set_edge, sum_up, solve_zone, shift_state, zone_energy

   !> The gap at c above the range as a function of a and c.
   type :: zone_gap_t
      !> Its value, minus its derivative by a, that by c, and the derivative of G at a.
      real(dp) :: value = 0, by_a = 1, by_c = 0, rise = 0
   end type zone_gap_t

contains

   !> Where the zone of a flat punch leaves its edge, with the present memory; and the parameter of a state there.
   pure subroutine set_edge(self, state)
      !> The problem.
      class(zone_problem_t), intent(inout) :: self
      !> In: radius of contact and approach of a state. Out: with its parameter in this problem.
      type(zone_state_t), intent(inout) :: state
      type(zone_state_t) :: edge

      if (.not. self%face < huge(self%face)) return
      call solve_zone(self, self%face, state%a, edge)
      self%has_edge = edge%is_found
      if (.not. self%has_edge) return
      self%edge_approach = edge%approach
      if (.not. state%c < self%face) state%c = self%face + max(0.0_dp, (state%approach - edge%approach)/self%face_scale)
   end subroutine set_edge

   !> Sum up the cells far from the edge of the zone, unless sums of the same memory hold at a radius.
   pure subroutine sum_up(self, c, a, onwards, is_new)
      !> The problem, with its memory.
      class(zone_problem_t), intent(inout) :: self
      !> Radii of adhesion and contact.
      real(dp), intent(in) :: c, a
      !> Where the middle of the radii c lies that are asked for next, beyond this one, in cells; within 0.5 of it.
      real(dp), intent(in) :: onwards
      !> Has the memory changed?
      logical, intent(in) :: is_new

      if (.not. is_new) then
         if (is_near(self%far, self%cell, c)) return
      end if
      call expand_far_cells(self%memory, self%cell, self%adhesion_radius(c + onwards*self%cell), int(a/self%cell) + 2, self%far)
   end subroutine sum_up

   !> The state of a given radius of adhesion.
   pure subroutine solve_zone(self, c, guess, state)
      !> The problem, with its memory.
      type(zone_problem_t), intent(in) :: self
      !> The radius c, >= 0; beyond a flat punch its parameter.
      real(dp), intent(in) :: c
      !> Where the search for a begins.
      real(dp), intent(in) :: guess
      !> Receives the state.
      type(zone_state_t), intent(out) :: state

      state%c = c
      if (.not. c > 0) then
         state%is_found = self%core == 0
         if (state%is_found) state%approach = self%memory(0) - self%range
      else if (c > self%face) then
         call solve_face(self, c, guess, state)
      else if (c < within_edge*self%shape%edge) then
         call find_contact_radius(self, c, guess, state)
      else
         state%is_found = .false.
      end if
   end subroutine solve_zone

   !> The radius of contact of a given radius of adhesion by Newton's method, and its state.
   pure subroutine find_contact_radius(self, c, guess, state)
      type(zone_problem_t), intent(in) :: self
      !> The radius c, > 0.
      real(dp), intent(in) :: c
      !> Where the search begins.
      real(dp), intent(in) :: guess
      !> Receives the state; `c` is set.
      type(zone_state_t), intent(inout) :: state
      integer, parameter :: most_steps = 100
      ! a step of Newton's method leaves its square
      real(dp), parameter :: small_step = 1.0e-12_dp, fine_step = 1.0e-6_dp, least_gap = 1.0e-14_dp, near_axis = 0.6_dp
      type(zone_sum_t) :: total
      type(zone_gap_t) :: opening
      real(dp) :: a, low, high, step, narrowest
      logical :: is_last, is_open, knows_low
      integer :: k

      total%high = self%node_below(c)
      total%low = total%high + 1
      narrowest = c*(1 - least_gap)
      low = 0
      high = narrowest
      knows_low = .false.
      a = min(max(guess, 0.0_dp), narrowest)
      is_last = .false.
      do k = 1, most_steps
         if (int(a/self%cell) < self%core) then
            state%is_found = .false.
            return
         end if
         call get_opening(self, c, a, total, opening)
         if (.not. a > 0) then
            if (.not. opening%value > 0) then
               ! nothing touches
               state%approach = self%memory(0) + opening%value
               state%load = -pi*self%stress*c**2
               state%approach_slope = opening%by_c
               state%load_slope = -2*pi*self%stress*c
               state%is_found = .not. ieee_is_nan(opening%value)
               return
            end if
            knows_low = .true.
         end if
         if (opening%value > 0) then
            low = a
         else
            high = a
         end if
         step = opening%value/opening%by_a
         ! in the first cell the straight memory makes a dent that the profile does not fill
         is_open = .not. low > 0 .and. .not. knows_low
         if (.not. (a + step > low .and. a + step < high)) then
            ! on the axis where Newton's method wants to go beyond it
            if (.not. (is_open .and. .not. a + step > low)) step = (low + high)/2 - a
         else if (abs(step) <= fine_step*min(a, c - a)) then
            is_last = int((a + step)/self%cell) == int(a/self%cell)
         end if
         if (is_open .and. .not. a + step > near_axis*self%cell) then
            step = -a
            is_open = .false.
         end if
         ! on the axis the slope has no meaning
         if (.not. a > 0) step = min(self%cell, high)/4
         is_last = (is_last .or. abs(step) <= small_step*c .or. high - low <= small_step*c) .and. a > 0 &
            & .and. a + step > near_axis*self%cell*merge(1, 0, is_open)
         a = a + step
         if (is_last) exit
      end do
      state%is_found = is_last
      if (.not. is_last) return
      state%a = a
      state%a_slope = opening%by_c/opening%by_a
      call close_state(self, opening%rise, state)
      state%is_found = .not. ieee_is_nan(state%load)
   end subroutine find_contact_radius

   !> Go along the curve of states by a change of c that is small beside a cell.
   pure subroutine shift_state(self, state, change)
      !> The problem.
      type(zone_problem_t), intent(in) :: self
      !> The state.
      type(zone_state_t), intent(inout) :: state
      !> Change of c.
      real(dp), intent(in) :: change

      state%c = state%c + change
      ! beside the axis the slope has no bound
      state%a = min(max(state%a + state%a_slope*change, 0.0_dp), max(self%adhesion_radius(state%c), 0.0_dp))
      state%approach = state%approach + state%approach_slope*change
      state%load = state%load + state%load_slope*change
   end subroutine shift_state

   !> Approach and load of a contact that touches.
   pure subroutine close_state(self, rise, state)
      type(zone_problem_t), intent(in) :: self
      !> The derivative of G at the radius of contact.
      real(dp), intent(in) :: rise
      !> In: with both radii and da/dc. Out: with approach and load.
      type(zone_state_t), intent(inout) :: state
      type(spot_t) :: spot
      real(dp) :: s, t, memory, sums, by_a

      associate (a => state%a, c => state%c)
         if (.not. self%face < huge(a)) call self%shape%evaluate(self%shape%unknown_of(a), .not. a < self%shape%corner, spot)
         s = sqrt((c - a)*(c + a))
         t = atan2(s, a)
         call get_memory(self, a, memory, sums)
         state%approach = spot%depth + memory - 2*self%stress*s/self%modulus
         state%load = self%modulus*(spot%load + 2*(a*memory - sums)) - 2*self%stress*(c*c*t + a*s)
         by_a = rise + 2*self%stress*a/(self%modulus*s)
         state%approach_slope = by_a*state%a_slope - 2*self%stress*c/(self%modulus*s)
         state%load_slope = 2*a*self%modulus*by_a*state%a_slope - 4*self%stress*c*(t + a/s)
      end associate
   end subroutine close_state

   !> The gap at c above the range, with the approach that a has, and its derivatives. Where the gap at a = 0 is
   !> too small, it is that of an approach w(0): the rest is what the approach gives.
   pure subroutine get_opening(self, c, a, total, gap)
      type(zone_problem_t), intent(in) :: self
      real(dp), intent(in) :: c, a
      !> The sum over whole cells, which is brought to the cell of a.
      type(zone_sum_t), intent(inout) :: total
      type(zone_gap_t), intent(out) :: gap
      type(spot_t) :: spot
      real(dp) :: s, t, opening, intensity, memory_slope
      logical :: is_beyond
      integer :: cell

      s = sqrt((c - a)*(c + a))
      t = atan2(s, a)
      opening = 0
      intensity = 0
      if (.not. self%face < huge(a)) then
         is_beyond = .not. a < self%shape%corner
         call self%shape%evaluate(self%shape%unknown_of(a), is_beyond, spot)
         call get_annulus(self%shape, spot, is_beyond, s, opening, intensity)
      end if
      cell = min(int(a/self%cell), total%high)
      call move_sum(self%memory, self%cell, self%far, c, cell + 1, total)
      memory_slope = (self%memory(cell + 1) - self%memory(cell))/self%cell
      opening = opening + total%total + memory_slope*(total%angle_sum - (a*t - s))
      gap%by_c = 2/(pi*c)*(intensity + total%turn + memory_slope*(s - total%side))
      if (a > 0) then
         gap%value = 2*opening/pi + 4*self%stress/(pi*self%modulus)*(s*t - (c - a)) - self%range
         gap%by_c = gap%by_c + 4*self%stress/(pi*self%modulus)*(c*t/s + a/c - 1)
         gap%rise = memory_slope
         if (spot%radius_slope > 0) gap%rise = gap%rise + spot%depth_slope/spot%radius_slope
         gap%by_a = 2*t/pi*(gap%rise + 2*self%stress*a/(s*self%modulus))
      else
         ! the state that touches at one point has w(0) - 2 S c/E as its approach
         gap%value = 2*opening/pi + 4*self%stress*c/(pi*self%modulus)*(half_pi - 1) - self%range
         if (.not. gap%value > 0) gap%value = gap%value - 2*self%stress*c/self%modulus
         gap%by_c = gap%by_c - 4*self%stress/(pi*self%modulus)
      end if
   end subroutine get_opening

   !> Energy of adhesion of a state: minus the work of adhesion over the disc r < c, and what of it the gap has taken.
   pure real(dp) function zone_energy(self, state) result(energy)
      type(zone_problem_t), intent(in) :: self
      type(zone_state_t), intent(in) :: state
      type(spot_t) :: spot
      real(dp) :: c, s, t, opening, intensity, moment, memory, sums, taken, low, high, first, slope
      integer :: k
      logical :: is_beyond

      energy = 0
      if (.not. state%c > 0) return
      c = self%adhesion_radius(state%c)
      associate (a => state%a)
         s = sqrt((c - a)*(c + a))
         t = atan2(s, a)
         moment = 0
         if (.not. self%face < huge(a)) then
            is_beyond = .not. a < self%shape%corner
            call self%shape%evaluate(self%shape%unknown_of(a), is_beyond, spot)
            call get_annulus(self%shape, spot, is_beyond, s, opening, intensity, moment)
         end if
         call get_memory(self, a, memory, sums)
         taken = moment + (spot%depth + memory - state%approach)*(c*c*t - a*s)/2 &
            & - 2*self%stress/self%modulus*(c - a)**2*(2*c + a)/3
         do k = self%node_below(a), self%node_below(c)
            low = max(a, k*self%cell)
            high = min(c, (k + 1)*self%cell)
            slope = (self%memory(k + 1) - self%memory(k))/self%cell
            first = self%memory(k) + slope*(low - k*self%cell) - memory - slope*low
            taken = taken + first*(half_disc(high, c) - half_disc(low, c)) &
               & - slope*(max((c - high)*(c + high), 0.0_dp)**1.5_dp - max((c - low)*(c + low), 0.0_dp)**1.5_dp)/3
         end do
         energy = self%stress*(4*taken - pi*c*c*self%range)
      end associate
   end function zone_energy

   !> The integral of sqrt(c^2 - x^2) from 0.
   elemental real(dp) function half_disc(x, c)
      real(dp), intent(in) :: x, c
      real(dp) :: s

      s = sqrt(max((c - x)*(c + x), 0.0_dp))
      half_disc = (x*s + c*c*atan2(x, s))/2
   end function half_disc

end module adfric_round_timed_adhesion_zone

! SPDX-License-Identifier: GPL-3.0-or-later
!> States of a flat punch of radius b whose zone of adhesion ends at its edge, on a solid that remembers
!> (`adfric_round_timed_adhesion_zone`).
!>
!> Under it g = 0 and c <= b. Its curve of states goes on where c = b and the gap there is below h: a zone
!> begins at the edge, or the whole face is pressed. There the approach d is the parameter. So c stands for b + (d - d_b)/k, where d_b
!> is the approach of the state with c = b that obeys the first equation, and k a scale. With x = b cos(t), the second one is
!>
!>     w(b cos(t)) - d = (2 S b/E) sin(t),   0 < t < pi/2
!>
!> whose left side falls with t, since w rises with x. Where d > w(b) the face touches as a whole, and only the load is needed.
module adfric_round_timed_adhesion_face
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi, pi
   use adfric_round_timed_adhesion_problem, only: get_memory, zone_problem_t, zone_state_t
   implicit none (type, external)
   private
   public :: solve_face

contains

   !> The state of a flat punch whose zone ends at its edge, where the gap is below the range.
   pure subroutine solve_face(self, c, guess, state)
      type(zone_problem_t), intent(in) :: self
      !> The parameter, above the radius of the face.
      real(dp), intent(in) :: c
      !> Where the search for a begins.
      real(dp), intent(in) :: guess
      !> Receives the state; `c` is set.
      type(zone_state_t), intent(inout) :: state
      integer, parameter :: most_steps = 100
      real(dp), parameter :: small_step = 1.0e-14_dp
      real(dp) :: t, low, high, stretch, value, slope, step, memory, rise, sums
      integer :: k

      state%approach = self%edge_approach + (c - self%face)*self%face_scale
      state%approach_slope = self%face_scale
      state%is_found = self%has_edge
      if (.not. state%is_found) return
      stretch = 2*self%stress*self%face/self%modulus
      if (.not. state%approach > self%memory(0) - stretch) then
         ! nothing touches
         state%load = -pi*self%stress*self%face**2
         return
      end if
      t = 0
      call interpolate(self, self%face, memory, rise)
      if (state%approach < memory) then
         low = 0
         high = half_pi
         t = acos(min(max(guess/self%face, 0.0_dp), 1.0_dp))
         do k = 1, most_steps
            call interpolate(self, self%face*cos(t), memory, rise)
            value = memory - stretch*sin(t) - state%approach
            if (value > 0) then
               low = t
            else
               high = t
            end if
            slope = rise*self%face*sin(t) + stretch*cos(t)
            step = (low + high)/2 - t
            if (abs(value) < slope*(high - low)) then
               if (t + value/slope > low .and. t + value/slope < high) step = value/slope
            end if
            t = t + step
            if (abs(step) <= small_step .or. high - low <= small_step) exit
         end do
         state%is_found = k <= most_steps
      end if
      associate (a => state%a, b => self%face)
         a = b*cos(t)
         call interpolate(self, a, memory, rise)
         slope = rise*b*sin(t) + stretch*cos(t)
         if (t > 0 .and. slope > 0) state%a_slope = self%face_scale*b*sin(t)/slope
         call get_memory(self, a, memory, sums)
         state%load = 2*self%modulus*(a*state%approach - sums) - 2*self%stress*b*b*(t - sin(t)*cos(t))
         state%load_slope = 2*self%modulus*a*self%face_scale
         state%is_found = state%is_found .and. .not. ieee_is_nan(state%load)
      end associate
   end subroutine solve_face

   !> The memory under a face, and its slope.
   pure subroutine interpolate(self, x, memory, slope)
      type(zone_problem_t), intent(in) :: self
      !> A radius up to that of the face.
      real(dp), intent(in) :: x
      real(dp), intent(out) :: memory, slope
      integer :: cell

      cell = min(int(x/self%cell), nint(self%face/self%cell) - 1)
      slope = (self%memory(cell + 1) - self%memory(cell))/self%cell
      memory = self%memory(cell) + slope*(x - cell*self%cell)
   end subroutine interpolate

end module adfric_round_timed_adhesion_face

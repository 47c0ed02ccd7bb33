! SPDX-License-Identifier: GPL-3.0-or-later
!> Springs of a half-space by the time at which each came into contact, or left it: a pile of pieces.
!>
!> A piece is a stretch of time in which the edge did not turn, as polynomials of this time: the depth G = g(x) of the spring at the
!> edge, and its memory c_i. What a spring is at a later time t follows from these alone,
!> $$ F = b(t) - w\, G + \sum_i m_i\, c_i\, e^{-(t - \tau)/T_i}, $$
!> with the time tau at which it passed the edge. On the pile of springs in contact F is the force of a spring (w = E0, m_i = E_i,
!> T_i the relaxation times), on that of free springs the gap above it (w = 1, m_k = -1, T_k the retardation times). The last
!> piece is that at the edge.
module adfric_round_timed_pile
   use adfric_base_kinds, only: dp
   use adfric_numerics_time_panels, only: n_nodes, get_weights
   implicit none (type, external)
   private
   public :: timed_pile_t, new_pile, instant_t

   !> A moment at which springs are looked at.
   type :: instant_t
      !> Time.
      real(dp) :: clock = 0
      !> Leg of the path.
      integer :: leg = 0
      !> Phase of the leg.
      real(dp) :: phase = 0
      !> b of the springs' F.
      real(dp) :: base = 0
   end type instant_t

   !> A pile.
   type :: timed_pile_t
      !> Number of pieces.
      integer :: count = 0
      !> w.
      real(dp) :: depth_weight = 1
      !> m_i and 1/T_i; shape `(n_arms)`.
      real(dp), allocatable :: weights(:), rates(:)
      !> Depths at the nodes of the pieces; shape `(n_nodes, capacity)`.
      real(dp), allocatable :: depths(:, :)
      !> Memory c_i at the nodes; shape `(n_nodes, n_arms, capacity)`.
      real(dp), allocatable :: memories(:, :, :)
      !> Time at the begin of each piece, length in time, phase at the begin, length in phase; shape `(4, capacity)`.
      real(dp), allocatable :: times(:, :)
      !> Positions s where what is left of a piece begins and ends; shape `(2, capacity)`.
      real(dp), allocatable :: ends(:, :)
      !> Legs of the path; shape `(capacity)`.
      integer, allocatable :: legs(:)
   contains
      procedure :: push
      procedure :: read_piece
      procedure :: read_at
      procedure :: value_at
      procedure :: value_per_lag
      procedure :: position_at
   end type timed_pile_t

contains

   !> An empty pile.
   pure subroutine new_pile(self, depth_weight, weights, rates)
      !> Receives the pile.
      type(timed_pile_t), intent(out) :: self
      !> w, m_i and 1/T_i.
      real(dp), intent(in) :: depth_weight, weights(:), rates(:)

      self%depth_weight = depth_weight
      self%weights = weights
      self%rates = rates
      call set_capacity(self, 32)
   end subroutine new_pile

   !> Make space.
   pure subroutine set_capacity(self, capacity)
      type(timed_pile_t), intent(inout) :: self
      integer, intent(in) :: capacity
      real(dp), allocatable :: depths(:, :), memories(:, :, :), times(:, :), ends(:, :)
      integer, allocatable :: legs(:)
      integer :: n

      n = self%count
      allocate (depths(n_nodes, capacity), memories(n_nodes, size(self%rates), capacity), times(4, capacity), ends(2, capacity), &
         & legs(capacity))
      if (n > 0) then
         depths(:, :n) = self%depths(:, :n)
         memories(:, :, :n) = self%memories(:, :, :n)
         times(:, :n) = self%times(:, :n)
         ends(:, :n) = self%ends(:, :n)
         legs(:n) = self%legs(:n)
      end if
      call move_alloc(depths, self%depths)
      call move_alloc(memories, self%memories)
      call move_alloc(times, self%times)
      call move_alloc(ends, self%ends)
      call move_alloc(legs, self%legs)
   end subroutine set_capacity

   !> Put a piece at the edge.
   pure subroutine push(self, times, leg, depths, memories)
      class(timed_pile_t), intent(inout) :: self
      !> Time at the begin, length in time, phase at the begin, length in phase.
      real(dp), intent(in) :: times(4)
      !> Leg of the path.
      integer, intent(in) :: leg
      !> Depths and memory at the nodes; shapes `(n_nodes)` and `(n_nodes, n_arms)`.
      real(dp), intent(in) :: depths(:), memories(:, :)

      if (self%count == size(self%legs)) call set_capacity(self, 2*self%count)
      self%count = self%count + 1
      associate (n => self%count)
         self%times(:, n) = times
         self%legs(n) = leg
         self%depths(:, n) = depths
         self%memories(:, :, n) = memories
         self%ends(:, n) = [-1, 1]
      end associate
   end subroutine push

   !> Depth and memory in the last piece.
   pure subroutine read_piece(self, s, depth, memory)
      class(timed_pile_t), intent(in) :: self
      !> Position in the piece, from -1 to 1.
      real(dp), intent(in) :: s
      !> Receive G and c_i of the spring; shape `(n_arms)`.
      real(dp), intent(out) :: depth, memory(:)

      call self%read_at(self%count, s, depth, memory)
   end subroutine read_piece

   !> Depth and memory in a piece.
   pure subroutine read_at(self, piece, s, depth, memory)
      class(timed_pile_t), intent(in) :: self
      !> Index of the piece.
      integer, intent(in) :: piece
      !> Position in the piece, from -1 to 1.
      real(dp), intent(in) :: s
      !> Receive G and c_i of the spring; shape `(n_arms)`.
      real(dp), intent(out) :: depth, memory(:)
      real(dp) :: weights(n_nodes)

      call get_weights(s, weights)
      depth = dot_product(weights, self%depths(:, piece))
      memory = matmul(weights, self%memories(:, :, piece))
   end subroutine read_at

   !> F of a spring of the last piece.
   pure real(dp) function value_at(self, s, instant) result(value)
      class(timed_pile_t), intent(in) :: self
      !> Position in the piece.
      real(dp), intent(in) :: s
      !> When.
      type(instant_t), intent(in) :: instant
      real(dp) :: depth, memory(size(self%rates)), lag

      call self%read_piece(s, depth, memory)
      associate (times => self%times(:, self%count))
         lag = instant%clock - times(1) - times(2)*(s + 1)/2
      end associate
      value = instant%base - self%depth_weight*depth + sum(self%weights*memory*exp(-self%rates*max(lag, 0.0_dp)))
   end function value_at

   !> F over the time since the spring passed the edge, where both are in one leg: in this form the root that F has at the moment
   !> itself is gone, and what is left crosses zero once.
   pure real(dp) function value_per_lag(self, s, instant) result(value)
      class(timed_pile_t), intent(in) :: self
      !> Position in the piece.
      real(dp), intent(in) :: s
      !> When.
      type(instant_t), intent(in) :: instant
      real(dp) :: lag

      value = self%value_at(s, instant)
      associate (times => self%times(:, self%count))
         lag = instant%phase - times(3) - times(4)*(s + 1)/2
         if (self%legs(self%count) == instant%leg .and. lag > 0) value = value/lag
      end associate
   end function value_per_lag

   !> The position in the last piece where F is zero; the begin of the piece, if F is below 0 there, and its end, if F is above 0 up
   !> to there and beyond.
   pure real(dp) function position_at(self, instant, before, guess) result(position)
      class(timed_pile_t), intent(in) :: self
      !> When.
      type(instant_t), intent(in) :: instant
      !> Position a little earlier.
      real(dp), intent(in) :: before
      !> A position that may be near.
      real(dp), intent(in) :: guess
      real(dp), parameter :: beyond = 0.3_dp, small = 4*epsilon(1.0_dp), first_step = 1.0e-6_dp
      integer, parameter :: most_steps = 60
      real(dp) :: low, high, at, next, last, at_last, least, most
      integer :: k

      least = self%ends(1, self%count)
      most = self%ends(2, self%count) + beyond
      last = before
      at_last = self%value_per_lag(last, instant)
      position = last
      if (.not. abs(at_last) > 0) return
      ! a bracket: F falls with the position
      low = last
      high = last
      position = merge(min(guess, before - first_step), max(guess, before + first_step), at_last < 0)
      do k = 1, most_steps
         position = min(most, max(least, position))
         at = self%value_per_lag(position, instant)
         if (at_last < 0) then
            low = position
            if (at >= 0) exit
            high = position
            if (position <= least) return
         else
            high = position
            if (at < 0) exit
            low = position
            if (position >= most) then
               position = self%ends(2, self%count)
               return
            end if
         end if
         next = position + 2*(position - last)
         last = position
         at_last = at
         position = next
      end do
      ! secants, and bisection where they do not close in
      do k = 1, most_steps
         next = position
         if (abs(at - at_last) > 0) next = position - at*(position - last)/(at - at_last)
         if (modulo(k, 8) == 0 .or. next < low .or. next > high) next = (low + high)/2
         last = position
         at_last = at
         position = next
         if (abs(position - last) <= small*(1 + abs(position))) return
         at = self%value_per_lag(position, instant)
         if (at >= 0) then
            low = position
         else
            high = position
         end if
         if (high - low <= small) return
      end do
   end function position_at

end module adfric_round_timed_pile

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
   use adfric_numerics_time_panels, only: n_nodes, get_weights_from_end
   use adfric_round_timed_path, only: mark_t
   implicit none (type, external)
   private
   public :: timed_pile_t, new_pile, instant_t

   !> A moment at which springs are looked at.
   type :: instant_t
      !> Leg of the path.
      integer :: leg = 0
      !> Time since the end of the last piece.
      real(dp) :: since = 0
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
      !> When each piece ends; shape `(capacity)`.
      type(mark_t), allocatable :: marks(:)
      !> Length in time of each piece; shape `(capacity)`.
      real(dp), allocatable :: spans(:)
      !> Positions where what is left of a piece begins and ends; shape `(2, capacity)`. They count from the end of the whole piece,
      !> 0, down to its begin, -2.
      real(dp), allocatable :: ends(:, :)
   contains
      procedure :: push
      procedure :: read_piece
      procedure :: lag_of
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
      real(dp), allocatable :: depths(:, :), memories(:, :, :), spans(:), ends(:, :)
      type(mark_t), allocatable :: marks(:)
      integer :: n

      n = self%count
      allocate (depths(n_nodes, capacity), memories(n_nodes, size(self%rates), capacity), spans(capacity), ends(2, capacity), &
         & marks(capacity))
      if (n > 0) then
         depths(:, :n) = self%depths(:, :n)
         memories(:, :, :n) = self%memories(:, :, :n)
         spans(:n) = self%spans(:n)
         ends(:, :n) = self%ends(:, :n)
         marks(:n) = self%marks(:n)
      end if
      call move_alloc(depths, self%depths)
      call move_alloc(memories, self%memories)
      call move_alloc(spans, self%spans)
      call move_alloc(ends, self%ends)
      call move_alloc(marks, self%marks)
   end subroutine set_capacity

   !> Put a piece at the edge.
   pure subroutine push(self, end, span, depths, memories)
      class(timed_pile_t), intent(inout) :: self
      !> When the piece ends, and its length in time.
      type(mark_t), intent(in) :: end
      real(dp), intent(in) :: span
      !> Depths and memory at the nodes; shapes `(n_nodes)` and `(n_nodes, n_arms)`.
      real(dp), intent(in) :: depths(:), memories(:, :)

      if (self%count == size(self%spans)) call set_capacity(self, 2*self%count)
      self%count = self%count + 1
      associate (n => self%count)
         self%marks(n) = end
         self%spans(n) = span
         self%depths(:, n) = depths
         self%memories(:, :, n) = memories
         self%ends(:, n) = [-2, 0]
      end associate
   end subroutine push

   !> Depth and memory in the last piece.
   pure subroutine read_piece(self, s, depth, memory)
      class(timed_pile_t), intent(in) :: self
      !> Position in the piece, from -2 to 0.
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
      !> Position in the piece, from -2 to 0.
      real(dp), intent(in) :: s
      !> Receive G and c_i of the spring; shape `(n_arms)`.
      real(dp), intent(out) :: depth, memory(:)
      real(dp) :: weights(n_nodes)

      call get_weights_from_end(s, weights)
      depth = dot_product(weights, self%depths(:, piece))
      memory = matmul(weights, self%memories(:, :, piece))
   end subroutine read_at

   !> Time since a spring passed the edge.
   pure real(dp) function lag_of(self, piece, s, since) result(lag)
      class(timed_pile_t), intent(in) :: self
      !> Index of the piece.
      integer, intent(in) :: piece
      !> Position in the piece, and the time since its end.
      real(dp), intent(in) :: s, since

      lag = since - self%spans(piece)*s/2
   end function lag_of

   !> F of a spring of the last piece.
   pure real(dp) function value_at(self, s, instant) result(value)
      class(timed_pile_t), intent(in) :: self
      !> Position in the piece.
      real(dp), intent(in) :: s
      !> When.
      type(instant_t), intent(in) :: instant
      real(dp) :: depth, memory(size(self%rates))

      call self%read_piece(s, depth, memory)
      associate (lag => self%lag_of(self%count, s, instant%since))
         value = instant%base - self%depth_weight*depth + sum(self%weights*memory*exp(-self%rates*max(lag, 0.0_dp)))
      end associate
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
      lag = self%lag_of(self%count, s, instant%since)
      if (self%marks(self%count)%leg == instant%leg .and. lag > 0) value = value/lag
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
      real(dp), parameter :: beyond = 0.3_dp, small = 4*epsilon(1.0_dp), first_step = 1.0e-12_dp
      integer, parameter :: most_steps = 100
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
         if (abs(position - last) <= small*(first_step + abs(position))) return
         at = self%value_per_lag(position, instant)
         if (at >= 0) then
            low = position
         else
            high = position
         end if
         if (high - low <= small*(first_step + abs(low))) return
      end do
   end function position_at

end module adfric_round_timed_pile

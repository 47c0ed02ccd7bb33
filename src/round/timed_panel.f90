! SPDX-License-Identifier: GPL-3.0-or-later
!> The springs during one panel of time, in which the edge moves in one direction: approach, edge and load as polynomials of time.
!>
!> With the approach at the nodes known, D_i follows exactly, the edge at each node is where F of a pile is zero (`timed_pile`), and
!> \( \dot Q_i = -Q_i/t_i + a \dot\delta + q_i(a) \dot a \). Under a load or behind a spring the approach follows from Newton's
!> method: springs that are in contact throughout answer with a load that depends on delta as D_i does. The file is long by how the
!> edge is found, and by what counts as an error.
module adfric_round_timed_panel
   use adfric_base_kinds, only: dp
   use adfric_numerics_lapack, only: dgesv
   use adfric_numerics_time_panels, only: get_memory, get_tail, lost_part, n_nodes, panel_nodes, panel_slopes
   use adfric_round_timed_path, only: mark_t, prescribed_at, prescribed_rate, prescribed_rise, time_between
   use adfric_round_timed_pile, only: instant_t, timed_pile_t
   use adfric_round_timed_springs, only: get_spot, growing, growing_again, lost, mark_of, shrinking, thin_depth, timed_springs_t
   implicit none (type, external)
   private
   public :: timed_panel_t, begin_panel, solve_panel, approach_rate, cannot_solve

   !> An error that asks for a much shorter panel.
   real(dp), parameter :: cannot_solve = 1.0e30_dp
   !> Largest part of a piece that the edge is guessed to pass from the first node of a panel to the second one, over their distance.
   real(dp), parameter :: most_of_piece = 0.1_dp

   !> A panel. Its values are those at the nodes.
   type :: timed_panel_t
      !> Time and phase at the begin, and lengths in both.
      real(dp) :: clock = 0, span = 0, phase = 0, phase_span = 0
      !> delta less that at the begin, with all digits of it.
      real(dp) :: rise(n_nodes) = 0
      !> delta, G(a), a, P, position in the last piece, d(delta - theta of a free spring)/ds, and F
      !> at the begin of the last piece.
      real(dp), dimension(n_nodes) :: approach = 0, depth = 0, radius = 0, load = 0, position = 0, opening = 0, piece_end = 0
      !> D_i, Q_i and q_i at the edge; shape `(n_nodes, n_arms)`.
      real(dp), allocatable :: drive(:, :), sums(:, :), at_edge(:, :)
      !> exp(-(t - begin)/t_i) and the memory of each arm; shapes `(n_nodes, n_arms)` and `(n_nodes, n_nodes, n_arms)`.
      real(dp), allocatable :: faded(:, :), memory(:, :, :)
      !> Estimated error over the tolerance, and what of it round-off alone may make.
      real(dp) :: error = cannot_solve, round_off = 0
   end type timed_panel_t

contains

   !> Solve a panel that begins at the state of the springs.
   pure subroutine solve_panel(self, phase_span, panel)
      type(timed_springs_t), intent(in) :: self
      !> Length of the panel in phase.
      real(dp), intent(in) :: phase_span
      !> In: a panel whose approach may be a guess. Out: the panel.
      type(timed_panel_t), intent(inout) :: panel
      integer, parameter :: most_steps = 25
      real(dp) :: residual(n_nodes), change, last_change, moved
      integer :: step

      call begin_panel(self, phase_span, panel)
      panel%error = cannot_solve
      if (abs(self%control%by_load) > 0 .and. self%edge_mode /= lost) then
         call guess_approach(self, panel)
         last_change = huge(1.0_dp)
         do step = 1, most_steps
            call follow_edge(self, panel)
            residual = prescribed_at(self%legs(self%leg), panel%phase + panel%phase_span*(panel_nodes + 1)/2) &
               & - self%control%by_approach*panel%approach - self%control%by_load*panel%load
            call correct_approach(self, panel, residual, change, moved)
            if (.not. change < huge(1.0_dp)) return
            if (change <= 1.0e-3_dp*self%tolerance .and. change > last_change/4) exit
            if (change <= 1.0e-6_dp*self%tolerance) exit
            ! round-off of the approach that stiff arms answer to, and that the load does not feel
            if (change > last_change/4 .and. max(moved, maxval(abs(residual))/(self%control%by_load*self%load_size)) &
               & <= 1.0e-3_dp*self%tolerance) exit
            last_change = change
         end do
         if (step > most_steps) return
      else if (abs(self%control%by_approach) > 0) then
         associate (leg => self%legs(self%leg), step => panel%phase_span*(panel_nodes + 1)/2)
            panel%approach = prescribed_at(leg, panel%phase + step)/self%control%by_approach
            panel%rise = prescribed_rise(leg, panel%phase, step)/self%control%by_approach
         end associate
      else
         panel%approach = self%approach
         panel%rise = 0
      end if
      call follow_edge(self, panel)
      call find_opening(self, panel)
      call estimate_error(self, panel)
   end subroutine solve_panel

   !> Times and memory of a panel.
   pure subroutine begin_panel(self, phase_span, panel)
      !> The springs at its begin.
      type(timed_springs_t), intent(in) :: self
      !> Length of the panel in phase.
      real(dp), intent(in) :: phase_span
      !> Receives them.
      type(timed_panel_t), intent(inout) :: panel
      integer :: i, n

      n = size(self%times)
      if (.not. allocated(panel%drive)) then
         allocate (panel%drive(n_nodes, n), panel%sums(n_nodes, n), panel%at_edge(n_nodes, n), panel%faded(n_nodes, n), &
            & panel%memory(n_nodes, n_nodes, n))
      end if
      associate (leg => self%legs(self%leg))
         panel%phase = self%phase
         panel%phase_span = phase_span
         panel%clock = leg%clock + leg%span*self%phase
         panel%span = leg%span*phase_span
      end associate
      do i = 1, n
         call get_memory(panel%span/(2*self%times(i)), panel%memory(:, :, i))
         panel%faded(:, i) = exp(-panel%span/(2*self%times(i))*(panel_nodes + 1))
      end do
   end subroutine begin_panel

   !> The edge, the load and all arms from the approach at the nodes.
   pure subroutine follow_edge(self, panel)
      type(timed_springs_t), intent(in) :: self
      type(timed_panel_t), intent(inout) :: panel
      real(dp), dimension(n_nodes) :: rate, radius_rate, moment
      real(dp) :: jump
      integer :: i

      rate = matmul(panel_slopes, panel%rise)
      do i = 1, size(self%times)
         panel%drive(:, i) = panel%faded(:, i)*self%drive(i) + matmul(panel%memory(:, :, i), rate)
      end do
      call find_edge(self, panel)
      if (self%edge_mode == lost) then
         panel%radius = 0
         panel%load = 0
         panel%sums = 0
         return
      end if
      call get_spot(self%contacts, panel%depth, panel%radius, moment)
      radius_rate = matmul(panel_slopes, panel%radius)
      panel%load = self%relaxed*(panel%approach*panel%radius - moment)
      ! where springs have hardly a force the edge may jump over them
      jump = panel%radius(1) - self%radius
      do i = 1, size(self%times)
         panel%sums(:, i) = panel%faded(:, i)*(self%sums(i) + jump*(panel%at_edge(1, i) + self%at_edge(i))/2) &
            & + matmul(panel%memory(:, :, i), panel%radius*rate + panel%at_edge(:, i)*radius_rate)
         panel%load = panel%load + self%moduli(i)*panel%sums(:, i)
      end do
      panel%load = 2*panel%load
   end subroutine follow_edge

   !> Depth and arms of the spring at the edge, at each node.
   pure subroutine find_edge(self, panel)
      type(timed_springs_t), intent(in) :: self
      type(timed_panel_t), intent(inout) :: panel
      real(dp) :: bases(n_nodes), faded(n_nodes, size(self%times)), small
      integer :: j, first

      panel%position = 1
      panel%piece_end = 1
      ! pieces that were too thin to be kept may lie between the edge and the pile
      small = thin_depth(self, 0.1_dp)
      panel%depth(1) = self%depth
      panel%at_edge(1, :) = self%at_edge
      select case (self%edge_mode)
      case (lost)
         panel%depth = 0
         call find_free_axis(self, panel)
      case (growing)
         panel%depth = panel%approach
         panel%at_edge = 0
      case (growing_again)
         call pass_piece(self, self%free, -panel%approach, small, panel, faded, first)
         do j = first, n_nodes
            panel%at_edge(j, :) = matmul(self%states, faded(j, :))
         end do
      case (shrinking)
         do j = 1, n_nodes
            bases(j) = self%relaxed*panel%approach(j) + sum(self%moduli*panel%drive(j, :))
         end do
         call pass_piece(self, self%touched, bases, small*self%glassy, panel, faded, first)
         panel%at_edge(first:, :) = panel%drive(first:, :) + faded(first:, :)
      end select
   end subroutine find_edge

   !> Where the edge is in the last piece of a pile, at each node.
   pure subroutine pass_piece(self, pile, bases, small, panel, faded, first)
      type(timed_springs_t), intent(in) :: self
      !> One of its piles.
      type(timed_pile_t), intent(in) :: pile
      !> b of the springs' F at each node, and the F that is round-off.
      real(dp), intent(in) :: bases(n_nodes), small
      !> In: depth of the edge at the begin. Out: with positions, depths, and F at the begin of the piece.
      type(timed_panel_t), intent(inout) :: panel
      !> Receives the memory of the spring at the edge as far as it has not faded; shape `(n_nodes, n_arms)`.
      real(dp), intent(out) :: faded(:, :)
      !> Receives the first node at which depth and memory are set: 2 where the edge is at the end of the piece.
      integer, intent(out) :: first
      type(instant_t) :: instant
      real(dp) :: memory(size(faded, 2)), since, part
      integer :: j

      instant%leg = self%leg
      since = time_between(self%legs, pile%marks(pile%count), mark_of(self))
      first = 1
      faded = 0
      ! a jump leaves a piece of no time
      part = most_of_piece
      if (most_of_piece*pile%spans(pile%count) > panel%span) part = panel%span/pile%spans(pile%count)
      associate (ends => pile%ends(:, pile%count))
         panel%position(1) = ends(2)
         do j = 1, n_nodes
            instant%since = since + panel%span*(panel_nodes(j) + 1)/2
            instant%base = bases(j)
            panel%piece_end(j) = pile%value_at(ends(1), instant)
            if (j == 1) then
               if (abs(pile%value_at(ends(2), instant)) <= small) first = 2
            end if
            if (j < first) cycle
            panel%position(j) = pile%position_at(instant, panel%position(max(1, j - 1)), guess_of(panel%position, j, part))
            call pile%read_piece(panel%position(j), panel%depth(j), memory)
            faded(j, :) = memory*exp(-pile%lag_of(pile%count, panel%position(j), instant%since)*pile%rates)
         end do
      end associate
   end subroutine pass_piece

   !> A guess of the position at a node from those before.
   pure real(dp) function guess_of(position, j, part) result(guess)
      real(dp), intent(in) :: position(n_nodes)
      integer, intent(in) :: j
      !> Length of the panel over that of the piece, at most `most_of_piece`.
      real(dp), intent(in) :: part

      if (j == 1) then
         guess = position(1)
      else if (j == 2) then
         guess = position(1) - part*(panel_nodes(2) - panel_nodes(1))
      else if (j == 3) then
         guess = position(2) + (position(2) - position(1))*(panel_nodes(3) - panel_nodes(2))/(panel_nodes(2) - panel_nodes(1))
      else
         associate (x => panel_nodes(j - 3:j - 1), f => position(j - 3:j - 1), y => panel_nodes(j))
            guess = f(1)*(y - x(2))*(y - x(3))/((x(1) - x(2))*(x(1) - x(3))) &
               & + f(2)*(y - x(1))*(y - x(3))/((x(2) - x(1))*(x(2) - x(3))) &
               & + f(3)*(y - x(1))*(y - x(2))/((x(3) - x(1))*(x(3) - x(2)))
         end associate
      end if
   end function guess_of

   !> Without contact: the spring on the axis is free, and `depth` is how far the indenter has gone beyond it, below 0.
   pure subroutine find_free_axis(self, panel)
      type(timed_springs_t), intent(in) :: self
      type(timed_panel_t), intent(inout) :: panel
      real(dp) :: memory(size(self%times)), depth, lag
      integer :: j

      panel%at_edge = 0
      panel%depth = panel%approach
      if (self%free%count == 0) return
      associate (free => self%free, end => self%free%ends(2, self%free%count))
         call free%read_piece(end, depth, memory)
         lag = free%lag_of(free%count, end, time_between(self%legs, free%marks(free%count), mark_of(self)))
         memory = memory*exp(-lag*free%rates)
      end associate
      do j = 1, n_nodes
         associate (now => memory*exp(-panel%span*(panel_nodes(j) + 1)/2*self%free%rates))
            if (abs(self%control%by_approach) > 0) then
               panel%depth(j) = panel%approach(j) - sum(now) - self%lost_depth
            else
               ! nothing but the spring says where the indenter is
               panel%approach(j) = sum(now) + self%lost_depth
               panel%depth(j) = 0
            end if
            panel%at_edge(j, :) = matmul(self%states, now)
         end associate
      end do
   end subroutine find_free_axis

   !> A first approach at the nodes: straight on as all arms would at once, or, from no contact, that of an elastic solid.
   pure subroutine guess_approach(self, panel)
      type(timed_springs_t), intent(in) :: self
      type(timed_panel_t), intent(inout) :: panel
      real(dp), parameter :: enough = 1.0e-3_dp
      integer, parameter :: most_steps = 60
      real(dp) :: given, low, high, depth, radius, moment, load, change
      integer :: j, step

      if (self%radius > 0) then
         panel%rise = approach_rate(self)*panel%phase_span*(panel_nodes + 1)/2
         panel%approach = self%approach + panel%rise
         return
      end if
      panel%rise(1) = 0
      do j = 2, n_nodes
         given = prescribed_at(self%legs(self%leg), panel%phase + panel%phase_span*(panel_nodes(j) + 1)/2)
         low = 0
         high = self%depth_size*4
         if (self%control%by_approach > 0) high = max(given/self%control%by_approach - self%approach, 0.0_dp)
         depth = high*(panel_nodes(j) + 1)/2
         do step = 1, most_steps
            call get_spot(self%contacts, depth, radius, moment)
            load = 2*self%glassy*(depth*radius - moment)
            change = self%control%by_approach*(self%approach + depth) + self%control%by_load*load - given
            if (change > 0) then
               high = depth
            else
               low = depth
            end if
            change = -change/(self%control%by_approach + 2*self%control%by_load*self%glassy*radius)
            if (abs(change) <= enough*depth) exit
            depth = depth + change
            if (.not. (depth > low .and. depth < high)) depth = merge((low + high)/2, high*0.03_dp, low > 0)
         end do
         panel%rise(j) = depth
      end do
      panel%approach = self%approach + panel%rise
   end subroutine guess_approach

   !> d delta/d phase at the begin of the panel, in contact.
   pure real(dp) function approach_rate(self) result(rate)
      !> The springs.
      type(timed_springs_t), intent(in) :: self

      associate (leg => self%legs(self%leg))
         rate = prescribed_rate(leg, self%phase)
         if (abs(self%control%by_load) > 0) then
            rate = (rate + 2*self%control%by_load*leg%span*sum(self%moduli*self%sums/self%times)) &
               & /(self%control%by_approach + 2*self%control%by_load*self%glassy*self%radius)
         else
            rate = rate/self%control%by_approach
         end if
      end associate
   end function approach_rate

   !> One step of Newton's method for the approach at the nodes.
   pure subroutine correct_approach(self, panel, residual, change, moved)
      type(timed_springs_t), intent(in) :: self
      type(timed_panel_t), intent(inout) :: panel
      !> What is prescribed less what it is.
      real(dp), intent(in) :: residual(n_nodes)
      !> Receives the largest change, over the size of depths, or of the load over that of loads; enormous, if there is none.
      real(dp), intent(out) :: change
      !> Receives the largest change of the approach alone, over the size of depths.
      real(dp), intent(out) :: moved
      real(dp) :: matrix(n_nodes - 1, n_nodes - 1), step(n_nodes - 1, 1), answer(n_nodes, n_nodes)
      integer :: pivots(n_nodes - 1), info, i, j

      answer = 0
      do i = 1, size(self%times)
         answer = answer + self%moduli(i)*panel%memory(:, :, i)
      end do
      matrix = 0
      answer = matmul(answer, panel_slopes)
      do j = 1, n_nodes - 1
         answer(j + 1, j + 1) = answer(j + 1, j + 1) + self%relaxed
         matrix(:, j) = 2*self%control%by_load*panel%radius(2:)*answer(2:, j + 1)
         matrix(j, j) = matrix(j, j) + self%control%by_approach
      end do
      step(:, 1) = residual(2:)
      call dgesv(n_nodes - 1, 1, matrix, n_nodes - 1, pivots, step, n_nodes - 1, info)
      change = huge(1.0_dp)
      moved = change
      if (info /= 0) return
      if (.not. all(abs(step) < huge(1.0_dp))) return
      moved = maxval(abs(step(:, 1)))/self%depth_size
      change = maxval(abs(step(:, 1))*max(1/self%depth_size, 2*self%glassy*panel%radius(2:)/self%load_size))
      panel%rise(2:) = panel%rise(2:) + step(:, 1)
      panel%rise(1) = 0
      panel%approach = self%approach + panel%rise
   end subroutine correct_approach

   !> How fast the gap beside the edge closes: above 0 the contact grows, below 0 it shrinks.
   pure subroutine find_opening(self, panel)
      type(timed_springs_t), intent(in) :: self
      type(timed_panel_t), intent(inout) :: panel
      integer :: i

      panel%opening = matmul(panel_slopes, panel%rise)
      do i = 1, size(self%times)
         panel%opening = panel%opening - panel%span/2*self%moduli(i)/(self%times(i)*self%glassy)*panel%at_edge(:, i)
      end do
   end subroutine find_opening

   !> What the polynomials may lack, over what is tolerated. What they lack of the radius changes the load by the force at the edge
   !> alone, which is 0: so it counts with what q_i changes in the panel.
   pure subroutine estimate_error(self, panel)
      type(timed_springs_t), intent(in) :: self
      type(timed_panel_t), intent(inout) :: panel
      real(dp), parameter :: noise = 256*epsilon(1.0_dp)
      real(dp) :: rate, radius_error, depth_error, load_error, decay, kept
      integer :: i

      depth_error = max(get_tail(panel%depth), get_tail(panel%approach))
      load_error = 0
      if (self%edge_mode /= lost) load_error = get_tail(panel%load)
      rate = maxval(abs(matmul(panel_slopes, panel%rise)))
      radius_error = get_tail(panel%radius)
      do i = 1, size(self%times)
         decay = panel%span/self%times(i)
         ! a fast arm remembers no more than the last moments of the panel
         kept = 1
         if (decay > 0) kept = lost_part(decay)/decay
         associate (edge => panel%at_edge(:, i), share => self%moduli(i)/self%glassy)
            load_error = max(load_error, self%moduli(i)*(radius_error*(rate*kept + maxval(edge) - minval(edge) &
               & + maxval(abs(edge))*(1 - panel%faded(n_nodes, i))) + (maxval(panel%radius) - minval(panel%radius))*get_tail(edge)))
            depth_error = max(depth_error, share*get_tail(panel%drive(:, i)), share*get_tail(edge))
         end associate
      end do
      panel%error = max(depth_error/self%depth_size, load_error/self%load_size)/self%tolerance
      panel%round_off = noise*max(maxval(abs(panel%approach))/self%depth_size, &
         & self%glassy*maxval(panel%radius)*maxval(abs(panel%rise))/self%load_size)/self%tolerance
   end subroutine estimate_error

end module adfric_round_timed_panel

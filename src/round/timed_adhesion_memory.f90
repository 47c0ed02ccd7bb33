! SPDX-License-Identifier: GPL-3.0-or-later
!> What a viscoelastic half-space remembers under a contact with a zone of adhesion: the displacement of its springs at nodes of one
!> distance, and that of their arms, z' = (th - z)/tau. Over a step of length t the displacement th goes straight in time, so that
!>
!>     z(end) = e z + b0 th + b1 th(end),    e = exp(-t/tau),   b1 = 1 - (1 - e) tau/t,   b0 = 1 - e - b1
!>
!> exactly. At the end of the step the half-space is elastic with a modulus E and a memory w that what was before decides:
!>
!>     E = E_glassy - sum E_i b1,    w = sum E_i (e z + b0 th)/E,    th(end) = w + y/E
!>
!> y is the spring's force: -2 S sqrt(c^2 - x^2) in the zone, 0 beyond it; in contact th is the approach less g.
!>
!> Springs that stay in contact move by the change d of the approach, all alike. So the stretch q = th - z of their arms has
!> become A q + B, with factors that are the same for all of them: q(end) = e q + (1 - b1) d. The springs of a core, some cells
!> within the edge, are left as they were when the core was made. A step takes A and B on, and what the core has lost follows from
!> the sums of q and q^2. Springs that the zone has left are a tail (`adfric_round_timed_adhesion_tail`). A step then costs the
!> springs between core and tail alone.
!> The file is long, since all that knows which springs are brought to the present and which are not stands in it.
module adfric_round_timed_adhesion_memory
   use adfric_base_kinds, only: dp
   use adfric_round_timed_adhesion_problem, only: zone_problem_t, zone_state_t
   use adfric_round_timed_adhesion_tail, only: make_tail, spring_tail_t, step_tail, wake_tail
   use adfric_solid_prony, only: prony_t
   implicit none (type, external)
   private
   public :: spring_memory_t, start_memory, reserve_nodes, prepare_step, take_step, stored_energy, wake_springs

   !> The springs at the nodes.
   type :: spring_memory_t
      !> The solid, whose relaxed modulus is 1.
      type(prony_t) :: solid
      !> Last node that adhesion has ever reached; beyond it nothing was moved. None if below 0.
      integer :: last = -1
      !> g at the nodes, and displacements of the springs; shape `(0:n_nodes)`.
      real(dp), allocatable :: depths(:), displacements(:)
      !> Displacements of their arms; shape `(0:n_nodes, n_arms)`.
      real(dp), allocatable :: arms(:, :)
      !> e, b0 and b1 of the step; shape `(n_arms)`.
      real(dp), allocatable :: decay(:), from_begin(:), from_end(:)
      !> What an arm loses over the step, see `weigh`; shape `(3, n_arms)`.
      real(dp), allocatable :: losses(:, :)
      !> Node at the edge of a flat punch; none if below 0.
      integer :: face_node = -1
      !> Last node that touches; 0 where none does.
      integer :: touching = 0
      !> Nodes of the core: those below this one, whose displacements and arms are those of the time when it was made.
      integer :: core = 0
      !> Springs that were left, from its first node on.
      type(spring_tail_t) :: tail
      !> Steps before a core or a tail is made again.
      integer :: pause = 0
      !> The approach at the end of the last step, and sums over the core of the depths and of ones, where the axis is a half.
      real(dp), private :: approach = 0, core_depths = 0, core_nodes = 0
      !> A and B of each arm, and sums of its q and q^2 over the core; shape `(n_arms)`.
      real(dp), allocatable, private :: core_factors(:), core_shifts(:), core_sums(:), core_squares(:)
   end type spring_memory_t

contains

   !> Springs at rest.
   pure subroutine start_memory(self, solid, problem, n_nodes)
      !> Receives the springs.
      type(spring_memory_t), intent(out) :: self
      !> The solid, whose relaxed modulus is 1.
      type(prony_t), intent(in) :: solid
      !> The elastic problem, with shape and distance of nodes; receives its nodes.
      type(zone_problem_t), intent(inout) :: problem
      !> Nodes beside the axis.
      integer, intent(in) :: n_nodes

      self%solid = solid
      if (problem%face < huge(problem%face)) self%face_node = nint(problem%face/problem%cell)
      allocate (self%decay(size(solid%times)), self%from_begin(size(solid%times)), self%from_end(size(solid%times)), &
         & source=0.0_dp)
      allocate (self%losses(3, size(solid%times)), source=0.0_dp)
      allocate (self%core_factors(size(solid%times)), self%core_shifts(size(solid%times)), self%core_sums(size(solid%times)), &
         & self%core_squares(size(solid%times)), source=0.0_dp)
      allocate (self%arms(0:-1, size(solid%times)))
      allocate (self%depths(0:-1), self%displacements(0:-1))
      call reserve_nodes(self, problem, n_nodes)
   end subroutine start_memory

   !> Make sure that there are nodes; those that are new are at rest.
   pure subroutine reserve_nodes(self, problem, n_nodes)
      !> The springs.
      type(spring_memory_t), intent(inout) :: self
      !> The elastic problem, which has the same nodes.
      type(zone_problem_t), intent(inout) :: problem
      !> Nodes beside the axis that are needed.
      integer, intent(in) :: n_nodes
      real(dp), allocatable :: depths(:), displacements(:), arms(:, :), memory(:)
      integer :: n, old

      old = ubound(self%depths, 1)
      if (size(self%depths) == 0) old = -1
      if (old >= n_nodes) return
      n = max(n_nodes, 3*old/2)
      allocate (depths(0:n), displacements(0:n), arms(0:n, size(self%solid%times)), memory(0:n), source=0.0_dp)
      if (old >= 0) then
         depths(:old) = self%depths
         displacements(:old) = self%displacements
         arms(:old, :) = self%arms
         memory(:old) = problem%memory
      end if
      call get_depths(problem, old + 1, n, depths)
      call move_alloc(depths, self%depths)
      call move_alloc(displacements, self%displacements)
      call move_alloc(arms, self%arms)
      call move_alloc(memory, problem%memory)
   end subroutine reserve_nodes

   !> g at nodes; enormous where the profile has ended.
   pure subroutine get_depths(problem, first, last, depths)
      type(zone_problem_t), intent(in) :: problem
      integer, intent(in) :: first, last
      real(dp), intent(inout) :: depths(0:)
      integer :: k

      do k = first, last
         depths(k) = problem%depth_at(k*problem%cell)
      end do
   end subroutine get_depths

   !> The elastic problem at the end of a step.
   pure subroutine prepare_step(self, span, problem)
      !> The springs at its begin.
      type(spring_memory_t), intent(inout) :: self
      !> Its length in time, >= 0.
      real(dp), intent(in) :: span
      !> Receives modulus and memory.
      type(zone_problem_t), intent(inout) :: problem
      real(dp) :: factor, sums
      integer :: arm, k, top

      problem%core = self%core
      associate (solid => self%solid, last => self%last, memory => problem%memory)
         do arm = 1, size(solid%times)
            call weigh(span/solid%times(arm), self%decay(arm), self%from_begin(arm), self%from_end(arm), self%losses(:, arm))
         end do
         problem%modulus = solid%relaxed + sum(solid%moduli*(1 - self%from_end))
         if (last < 0) return
         top = min(last, self%tail%first - 1)
         factor = sum(solid%moduli*self%from_begin)/problem%modulus
         !$omp simd
         do k = self%core, top
            memory(k) = factor*self%displacements(k)
         end do
         do arm = 1, size(solid%times)
            factor = solid%moduli(arm)*self%decay(arm)/problem%modulus
            !$omp simd
            do k = self%core, top
               memory(k) = memory(k) + factor*self%arms(k, arm)
            end do
         end do
         problem%anchor = self%touching
         sums = core_memory(self, problem%modulus) - memory(self%touching)/2
         if (self%core == 0) sums = sums - memory(0)/2
         !$omp simd reduction(+:sums)
         do k = self%core, self%touching
            sums = sums + memory(k)
         end do
         problem%anchor_sum = problem%cell*sums
      end associate
   end subroutine prepare_step

   !> Sum of the memory over the core, where the axis is a half.
   pure real(dp) function core_memory(self, modulus) result(sums)
      type(spring_memory_t), intent(in) :: self
      !> The modulus of the step.
      real(dp), intent(in) :: modulus
      real(dp) :: displacements
      integer :: arm

      sums = 0
      if (self%core == 0) return
      displacements = self%approach*self%core_nodes - self%core_depths
      do arm = 1, size(self%solid%times)
         sums = sums + self%solid%moduli(arm)*((self%decay(arm) + self%from_begin(arm))*displacements &
            & - self%decay(arm)*(self%core_factors(arm)*self%core_sums(arm) + self%core_shifts(arm)*self%core_nodes))
      end do
      sums = sums/modulus
   end function core_memory

   !> What the core of an arm loses over the step over its modulus and the cell, as `losses` say, and its A and B at the end.
   pure subroutine step_core(self, arm, change, sums)
      type(spring_memory_t), intent(inout) :: self
      integer, intent(in) :: arm
      !> Change of the approach.
      real(dp), intent(in) :: change
      !> Receives the half of what is lost.
      real(dp), intent(out) :: sums
      real(dp) :: stretches, squares

      associate (a => self%core_factors(arm), b => self%core_shifts(arm), n => self%core_nodes, loss => self%losses(:, arm))
         stretches = a*self%core_sums(arm) + b*n
         squares = a*(a*self%core_squares(arm) + 2*b*self%core_sums(arm)) + b*b*n
         sums = loss(1)*squares + loss(2)*stretches*change + loss(3)*change*change*n
         a = self%decay(arm)*a
         b = self%decay(arm)*b + (1 - self%from_end(arm))*change
      end associate
   end subroutine step_core

   !> Make a core of other nodes: the springs of the present one are brought to the present.
   pure subroutine set_core(self, n_nodes)
      !> The springs.
      type(spring_memory_t), intent(inout) :: self
      !> Its nodes, which touch: 0 for no core.
      integer, intent(in) :: n_nodes
      real(dp) :: stretch, sums, squares
      integer :: arm, k

      do arm = 1, size(self%solid%times)
         associate (a => self%core_factors(arm), b => self%core_shifts(arm))
            do k = 0, self%core - 1
               stretch = a*(self%displacements(k) - self%arms(k, arm)) + b
               self%arms(k, arm) = self%approach - self%depths(k) - stretch
            end do
         end associate
      end do
      do k = 0, self%core - 1
         self%displacements(k) = self%approach - self%depths(k)
      end do
      self%core = n_nodes
      if (n_nodes == 0) return
      self%core_factors = 1
      self%core_shifts = 0
      self%core_nodes = n_nodes - 0.5_dp
      self%core_depths = sum(self%depths(:n_nodes - 1)) - self%depths(0)/2
      do arm = 1, size(self%solid%times)
         stretch = self%displacements(0) - self%arms(0, arm)
         sums = -stretch/2
         squares = -stretch**2/2
         !$omp simd private(stretch) reduction(+:sums, squares)
         do k = 0, n_nodes - 1
            stretch = self%displacements(k) - self%arms(k, arm)
            sums = sums + stretch
            squares = squares + stretch*stretch
         end do
         self%core_sums(arm) = sums
         self%core_squares(arm) = squares
      end do
   end subroutine set_core

   !> Bring all springs to the present.
   pure subroutine wake_springs(self)
      !> The springs.
      type(spring_memory_t), intent(inout) :: self

      call set_core(self, 0)
      if (self%tail%first <= self%last) call wake_tail(self%tail, self%last, self%displacements, self%arms)
   end subroutine wake_springs

   !> A tail from another node on.
   pure subroutine move_tail(self, first)
      type(spring_memory_t), intent(inout) :: self
      !> Its first node; none beyond the last one.
      integer, intent(in) :: first

      if (self%tail%first <= self%last) call wake_tail(self%tail, self%last, self%displacements, self%arms)
      if (first <= self%last) call make_tail(self%tail, first, self%last, self%displacements, self%arms)
   end subroutine move_tail

   !> Core and tail after a step: they follow the edges of contact and of the zone in blocks, some cells beside them.
   pure subroutine follow_edges(self, adhering)
      type(spring_memory_t), intent(inout) :: self
      !> Last node within the zone.
      integer, intent(in) :: adhering
      integer, parameter :: block = 64, margin = 8, least = 4

      ! the states of a flat punch ask for the memory on the axis
      if (self%face_node >= 0) return
      if (self%pause > 0) then
         self%pause = self%pause - 1
         return
      end if
      if (self%touching - margin > self%core + block) then
         call set_core(self, self%touching - margin)
      else if (self%core > 0 .and. self%touching < self%core + least) then
         call set_core(self, max(0, self%touching - block))
      end if
      ! the products of a tail of few springs cost more than these
      if (adhering + margin + max(block, (size(self%solid%times) + 1)**2) < min(self%tail%first, self%last + 1)) then
         call move_tail(self, adhering + margin)
      else if (adhering + least > self%tail%first - 1) then
         call move_tail(self, adhering + block)
      end if
   end subroutine follow_edges

   !> e, b0 and b1 of an arm, and what it loses over the step: with its stretch q before the step and the change d of the
   !> displacement, the integral of q^2 over time and its own time is l1 q^2 + l2 q d + l3 d^2.
   pure subroutine weigh(share, decay, from_begin, from_end, losses)
      !> Length of the step over the time of the arm.
      real(dp), intent(in) :: share
      real(dp), intent(out) :: decay, from_begin, from_end, losses(3)
      real(dp), parameter :: short = 1.0e-2_dp
      real(dp) :: less

      decay = exp(-share)
      if (share < short) then
         less = share*(1 - share/2*(1 - share/3*(1 - share/4*(1 - share/5*(1 - share/6)))))
         from_end = share/2*(1 - share/3*(1 - share/4*(1 - share/5*(1 - share/6))))
         ! sums of (2^(n - 1) - 2) (-share)^(n - 3)/n! from n = 3 on
         losses(3) = share*(1/3.0_dp - share*(1/4.0_dp - share*(7/60.0_dp - share*(1/24.0_dp - share*(31/2520.0_dp &
            & - share/320)))))
      else
         less = 1 - decay
         from_end = 1 - less/share
         losses(3) = (share - 2*less + less*(1 + decay)/2)/share**2
      end if
      from_begin = less - from_end
      losses(1) = less*(1 + decay)/2
      losses(2) = 0
      if (share > 0) losses(2) = less*less/share
   end subroutine weigh

   !> Go to the end of a step. Adds what its arms have lost.
   pure subroutine take_step(self, problem, state, lost)
      !> The springs.
      type(spring_memory_t), intent(inout) :: self
      !> The elastic problem at its end, that of `prepare_step`.
      type(zone_problem_t), intent(in) :: problem
      !> The state there.
      type(zone_state_t), intent(in) :: state
      !> Energy that was lost, to which is added.
      real(dp), intent(inout) :: lost
      real(dp) :: factor, sums, lost_beyond(size(self%solid%times))
      real(dp) :: ends(self%core:min(max(self%last, problem%node_below(state%c)), self%tail%first - 1)), c
      integer :: k, arm, first, last, touching, edge

      c = problem%adhesion_radius(state%c)
      first = self%core
      last = ubound(ends, 1)
      lost_beyond = 0
      if (self%tail%first <= self%last) then
         call step_tail(self%tail, self%solid, problem%modulus, self%decay, self%from_begin, self%from_end, self%losses, &
            & lost_beyond)
      else
         self%last = last
      end if
      touching = -1
      if (state%c > 0) touching = problem%node_below(state%a)
      if (.not. state%a > 0) touching = -1
      self%touching = max(touching, 0)
      !$omp simd
      do k = first, touching
         ends(k) = state%approach - self%depths(k)
      end do
      factor = 2*problem%stress/problem%modulus
      edge = min(last, ceiling(c/problem%cell) - 1)
      !$omp simd
      do k = touching + 1, edge
         ends(k) = problem%memory(k) - factor*sqrt(max((c - k*problem%cell)*(c + k*problem%cell), 0.0_dp))
      end do
      ends(max(touching, edge) + 1:) = problem%memory(max(touching, edge) + 1:last)
      do arm = 1, size(self%solid%times)
         ! the spring on the axis stands for half a cell, and so does that at the edge of a flat punch
         if (first > 0) then
            call step_core(self, arm, state%approach - self%approach, sums)
         else
            sums = -loss_at(self, arm, 0, ends(0))/2
         end if
         if (last == self%face_node) sums = sums - loss_at(self, arm, last, ends(last))/2
         call step_arm(last - first + 1, self%decay(arm), self%from_end(arm), self%losses(:, arm), ends, &
            & self%displacements(first:last), self%arms(first:last, arm), sums)
         lost = lost + 2*self%solid%moduli(arm)*problem%cell*(sums + lost_beyond(arm))
      end do
      self%displacements(first:last) = ends
      self%approach = state%approach
      call follow_edges(self, problem%node_below(state%c))
   end subroutine take_step

   !> Springs of an arm that go to the end of a step.
   pure subroutine step_arm(n, decay, from_end, losses, ends, displacements, arms, sums)
      !> Number of springs.
      integer, intent(in) :: n
      !> e and b1 of the arm, and what it loses, see `weigh`.
      real(dp), intent(in) :: decay, from_end, losses(3)
      !> Displacements at the end of the step and at its begin.
      real(dp), intent(in) :: ends(n), displacements(n)
      !> Displacements of the arms.
      real(dp), intent(inout) :: arms(n)
      !> Half of what is lost over modulus and cell, to which is added.
      real(dp), intent(inout) :: sums
      real(dp) :: before, change, first, both, last
      integer :: k

      first = losses(1)
      both = losses(2)
      last = losses(3)
      !$omp simd private(before, change) reduction(+:sums)
      do k = 1, n
         before = displacements(k) - arms(k)
         change = ends(k) - displacements(k)
         arms(k) = displacements(k) - decay*before + from_end*change
         sums = sums + (first*before*before + both*before*change + last*change*change)
      end do
   end subroutine step_arm

   !> What an arm of one spring loses, as `step_arm` has it.
   pure real(dp) function loss_at(self, arm, node, end) result(lost)
      type(spring_memory_t), intent(in) :: self
      integer, intent(in) :: arm, node
      !> Displacement at the end of the step.
      real(dp), intent(in) :: end
      real(dp) :: before, change

      before = self%displacements(node) - self%arms(node, arm)
      change = end - self%displacements(node)
      lost = self%losses(1, arm)*before*before + self%losses(2, arm)*before*change + self%losses(3, arm)*change*change
   end function loss_at

   !> Energy that springs and arms store.
   pure real(dp) function stored_energy(self, cell) result(energy)
      !> The springs.
      type(spring_memory_t), intent(in) :: self
      !> Distance of the nodes.
      real(dp), intent(in) :: cell
      type(spring_memory_t) :: present

      if (self%core > 0 .or. self%tail%first <= self%last) then
         present = self
         call wake_springs(present)
         energy = energy_of(present, cell)
      else
         energy = energy_of(self, cell)
      end if
   end function stored_energy

   !> Energy that springs and arms store; there is no core.
   pure real(dp) function energy_of(self, cell) result(energy)
      type(spring_memory_t), intent(in) :: self
      real(dp), intent(in) :: cell
      real(dp) :: at_edge
      integer :: arm, last

      last = self%last
      energy = 0
      if (last < 0) return
      at_edge = merge(0.5_dp, 0.0_dp, last == self%face_node)
      energy = self%solid%relaxed*(sum(self%displacements(:last)**2) - self%displacements(0)**2/2 &
         & - at_edge*self%displacements(last)**2)
      do arm = 1, size(self%solid%times)
         energy = energy + self%solid%moduli(arm)*(sum((self%displacements(:last) - self%arms(:last, arm))**2) &
            & - (self%displacements(0) - self%arms(0, arm))**2/2 &
            & - at_edge*(self%displacements(last) - self%arms(last, arm))**2)
      end do
      energy = energy*cell
   end function energy_of

end module adfric_round_timed_adhesion_memory

! SPDX-License-Identifier: GPL-3.0-or-later
!> Derivatives of the load of one cycle in closed form (`adfric_round_timed_cycle`) by moduli, relaxation times, and a motion of the
!> path, each at no more cost than the load.
!>
!> The load is \( P = 2 \int_0^{t_1} E(t - s)\, a\, d\delta \), where t1 is the root of \( F = \int_{t_1}^t E(t - s)\, d\delta = 0 \).
!> With \( P_{t_1} = 2 a(t_1) E(t - t_1) \dot\delta(t_1) \) and \( F_{t_1} = -E(t - t_1) \dot\delta(t_1) \) the motion of the root
!> needs no division: for any number v
!> $$ \frac{dP}{dv} = \partial_v P + 2 a(t_1)\, \partial_v F \quad \text{at a given } t_1 . $$
!> While the contact grows, t1 = t and F = 0. The partial derivatives are
!>
!> - by E_i: Q_i and D_i of arms, which the cycle has;
!> - by t_i: \( K_i = \partial Q_i/\partial t_i \), of which \( \dot K_i = -K_i/t_i + Q_i/t_i^2 \), and that of D_i in closed form;
!> - by a motion \( \psi \) of the approach: \( 2 \int_0^{t_1} E(t - s)\, d(a \psi) \), in parts
!>   \( a \psi - \frac{1}{t_i} \int e^{-(t_1 - s)/t_i} a \psi\, ds \) for each arm, with \( \psi = 1 \) and \( \psi = s \).
module adfric_round_timed_cycle_slopes
   use adfric_base_kinds, only: dp
   use adfric_interface_normal_contact, only: normal_contact_t
   use adfric_numerics_time_panels, only: get_all_faded, lost_part, lost_twice, n_nodes, panel_nodes
   use adfric_round_timed_cycle, only: approach_at, drive_at, find_origin, get_memories, load_of, timed_cycle_t
   use adfric_round_timed_springs, only: get_spot
   implicit none (type, external)
   private
   public :: cycle_change_t, new_cycle_change, get_loads

   !> What derivatives need beside the cycle.
   type :: cycle_slopes_t
      !> K_i, the integral of a with memory and that of a s with memory, at the nodes of the panels; shape `(n_nodes, 3, n_arms,
      !> n_panels)`.
      real(dp), allocatable :: sums(:, :, :, :)
      !> Derivatives of D_i by t_i at the begins of the legs; shape `(n_arms, n_legs)`.
      real(dp), allocatable :: drive(:, :)
   end type cycle_slopes_t

   !> A number for each that a cycle depends on: the derivative of a load by it, or its own by what it follows from.
   type :: cycle_change_t
      !> The relaxed modulus; a motion of the approach by 1, and by its time.
      real(dp) :: relaxed = 0, shift = 0, drift = 0
      !> Moduli and relaxation times of the arms; shape `(n_arms)`.
      real(dp), allocatable :: moduli(:), times(:)
   end type cycle_change_t

   !> Columns of the sums.
   integer, parameter :: by_time = 1, of_radius = 2, of_radius_and_time = 3

contains

   !> No change.
   pure subroutine new_cycle_change(self, n_arms)
      !> Receives zeros.
      type(cycle_change_t), intent(out) :: self
      !> Number of arms.
      integer, intent(in) :: n_arms

      allocate (self%moduli(n_arms), self%times(n_arms), source=0.0_dp)
   end subroutine new_cycle_change

   !> The chain rule: the derivative of a load by what all numbers of a cycle follow from.
   pure real(dp) function chain(gradient, change) result(slope)
      !> Derivatives of the load, and of the numbers.
      type(cycle_change_t), intent(in) :: gradient, change

      slope = gradient%relaxed*change%relaxed + gradient%shift*change%shift + gradient%drift*change%drift &
         & + dot_product(gradient%moduli, change%moduli) + dot_product(gradient%times, change%times)
   end function chain

   !> Loads of a cycle at times, and their derivatives by what all its numbers follow from.
   pure subroutine get_loads(cycle, contacts, clocks, changes, loads, slopes)
      !> A cycle that was found; it remembers where it was looked at last.
      type(timed_cycle_t), intent(inout) :: cycle
      !> Contacts of the indenter with an elastic half-space of modulus 1.
      class(normal_contact_t), intent(in) :: contacts
      !> The times, in that of the legs; shape `(n_times)`.
      real(dp), intent(in) :: clocks(:)
      !> Derivatives of the numbers of the cycle; shape `(n_slopes)`.
      type(cycle_change_t), intent(in) :: changes(:)
      !> Receives the loads; shape `(n_times)`.
      real(dp), intent(out) :: loads(:)
      !> Receives their derivatives; shape `(n_times, n_slopes)`.
      real(dp), intent(out) :: slopes(:, :)
      type(cycle_slopes_t) :: self
      type(cycle_change_t) :: gradient
      integer :: i, k

      call new_cycle_slopes(self, cycle)
      call new_cycle_change(gradient, size(cycle%solid%times))
      do i = 1, size(clocks)
         call read_slopes(self, cycle, contacts, clocks(i), loads(i), gradient)
         do k = 1, size(changes)
            slopes(i, k) = chain(gradient, changes(k))
         end do
      end do
   end subroutine get_loads

   !> Find what derivatives need.
   pure subroutine new_cycle_slopes(self, cycle)
      !> Receives it.
      type(cycle_slopes_t), intent(out) :: self
      !> A cycle that was found.
      type(timed_cycle_t), intent(in) :: cycle
      integer :: k

      associate (arms => size(cycle%solid%times))
         allocate (self%sums(n_nodes, 3, arms, cycle%n), self%drive(arms, size(cycle%legs)))
         self%drive(:, 1) = 0
         do k = 2, size(cycle%legs)
            self%drive(:, k) = drive_by_time(self, cycle, k - 1, cycle%legs(k)%clock)
         end do
      end associate
      do k = 1, cycle%n
         call sum_panel(self, cycle, k)
      end do
   end subroutine new_cycle_slopes

   !> The sums of a panel, which go on from those of the one before.
   pure subroutine sum_panel(self, cycle, number)
      type(cycle_slopes_t), intent(inout) :: self
      type(timed_cycle_t), intent(in) :: cycle
      !> Number of the panel.
      integer, intent(in) :: number
      real(dp) :: values(n_nodes, 3), integrals(n_nodes, 3), faded(n_nodes), before(3), lag(n_nodes)
      integer :: i, c

      associate (panel => cycle%panels(number), times => cycle%solid%times)
         lag = panel%span*(panel_nodes + 1)/2
         values(:, of_radius) = panel%radius
         values(:, of_radius_and_time) = panel%radius*(panel%clock + lag)
         before = 0
         do i = 1, size(times)
            if (number > 1) before = self%sums(n_nodes, :, i, number - 1)
            values(:, by_time) = panel%sums(:, i)/times(i)/times(i)
            call get_all_faded(panel%span/(2*times(i)), values, integrals, faded)
            do c = 1, 3
               self%sums(:, c, i, number) = faded*before(c) + integrals(:, c)*panel%span/2
            end do
            ! a rest is nothing but decay, however fast
            if (.not. abs(panel%slope) > 0) self%sums(:, by_time, i, number) = faded*before(by_time) &
               & + lag/times(i)/times(i)*panel%sums(:, i)
         end do
      end associate
   end subroutine sum_panel

   !> Derivatives of D_i by t_i at a time of a leg.
   pure function drive_by_time(self, cycle, leg, clock) result(drive)
      type(cycle_slopes_t), intent(in) :: self
      type(timed_cycle_t), intent(in) :: cycle
      integer, intent(in) :: leg
      real(dp), intent(in) :: clock
      real(dp) :: drive(size(cycle%solid%times)), slope

      associate (l => cycle%legs(leg), times => cycle%solid%times)
         slope = (l%end - l%begin)/l%span
         drive = slope*lost_twice((clock - l%clock)/times) + (self%drive(:, leg) + cycle%drive(:, leg) &
            & *((clock - l%clock)/times/times))*exp(-(clock - l%clock)/times)
      end associate
   end function drive_by_time

   !> The load at a time and its derivatives; all are 0 without contact.
   pure subroutine read_slopes(self, cycle, contacts, clock, load, gradient)
      !> What derivatives need.
      type(cycle_slopes_t), intent(in) :: self
      !> The cycle; it remembers where it was looked at last.
      type(timed_cycle_t), intent(inout) :: cycle
      !> Contacts of the indenter with an elastic half-space of modulus 1.
      class(normal_contact_t), intent(in) :: contacts
      !> The time, in that of the legs.
      real(dp), intent(in) :: clock
      !> Receives the load.
      real(dp), intent(out) :: load
      !> Its arms are there. Receives the derivatives.
      type(cycle_change_t), intent(inout) :: gradient
      real(dp) :: weights(n_nodes), memories(0:size(cycle%solid%times)), sums(3, size(cycle%solid%times)), root, depth, radius, &
         & moment, lag, faded
      integer :: leg, k, i
      logical :: has_contact

      load = 0
      gradient%relaxed = 0
      gradient%shift = 0
      gradient%drift = 0
      gradient%moduli = 0
      gradient%times = 0
      call find_origin(cycle, clock, leg, root, depth, has_contact)
      if (.not. has_contact) return
      call get_spot(contacts, depth, radius, moment)
      lag = clock - root
      associate (solid => cycle%solid)
         call get_memories(cycle, contacts, root, depth, memories, k, weights)
         load = load_of(cycle, memories, lag)
         if (leg <= cycle%turn) load = max(0.0_dp, dot_product(weights, cycle%panels(k)%load))
         ! springs of the jump remember nothing else
         sums = 0
         if (k > 0) then
            do i = 1, size(solid%times)
               sums(:, i) = matmul(weights, self%sums(:, :, i, k))
            end do
         end if
         gradient%relaxed = memories(0)
         gradient%shift = solid%relaxed*radius
         gradient%drift = solid%relaxed*radius*root
         do i = 1, size(solid%times)
            associate (time => solid%times(i), modulus => solid%moduli(i))
               faded = exp(-lag/time)
               gradient%moduli(i) = faded*memories(i)
               gradient%times(i) = modulus*faded*(sums(by_time, i) + memories(i)*(lag/time/time))
               gradient%shift = gradient%shift + modulus*faded*(radius - sums(of_radius, i)/time)
               gradient%drift = gradient%drift + modulus*faded*(radius*root - sums(of_radius_and_time, i)/time)
            end associate
         end do
         if (leg > cycle%turn) call add_root(self, cycle, clock, leg, root, depth, radius, gradient)
         gradient%relaxed = 2*gradient%relaxed
         gradient%shift = 2*gradient%shift
         gradient%drift = 2*gradient%drift
         gradient%moduli = 2*gradient%moduli
         gradient%times = 2*gradient%times
      end associate
   end subroutine read_slopes

   !> What the condition of the edge adds while the contact shrinks: a times the derivatives of F. A motion of the approach by a
   !> constant adds nothing that the sums do not have: F is of what moves after t1, or, in the jump, what they have themselves.
   pure subroutine add_root(self, cycle, clock, leg, root, depth, radius, gradient)
      type(cycle_slopes_t), intent(in) :: self
      type(timed_cycle_t), intent(in) :: cycle
      real(dp), intent(in) :: clock
      !> Leg of the time.
      integer, intent(in) :: leg
      !> t1, G(a) and a.
      real(dp), intent(in) :: root, depth, radius
      !> The derivatives are added.
      type(cycle_change_t), intent(inout) :: gradient
      real(dp), dimension(size(cycle%solid%times)) :: faded, earlier, earlier_by_time, now
      integer :: first

      if (depth < cycle%jump) then
         earlier = depth
         earlier_by_time = 0
      else
         first = max(1, count(cycle%legs(:cycle%turn)%clock < root))
         call drive_at(cycle, first, root, earlier)
         earlier_by_time = drive_by_time(self, cycle, first, root)
      end if
      call drive_at(cycle, leg, clock, now)
      associate (solid => cycle%solid, lag => clock - root)
         faded = exp(-lag/solid%times)
         gradient%relaxed = gradient%relaxed + radius*(approach_at(cycle%legs(leg), clock) - depth)
         gradient%moduli = gradient%moduli + radius*(now - earlier*faded)
         gradient%times = gradient%times + radius*solid%moduli*(drive_by_time(self, cycle, leg, clock) &
            & - (earlier_by_time + earlier*(lag/solid%times/solid%times))*faded)
         gradient%drift = gradient%drift + radius*(solid%relaxed*lag + sum(solid%moduli*solid%times*lost_part(lag/solid%times)))
      end associate
   end subroutine add_root

end module adfric_round_timed_cycle_slopes

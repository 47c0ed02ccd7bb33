! SPDX-License-Identifier: GPL-3.0-or-later
!> One cycle under a given approach in closed form (T. C. T. Ting, J. Appl. Mech. 33 (1966) 845): a contact that grows along straight
!> legs and then shrinks along others, none slower than the one before, until the indenter is out of the dimple. It may begin with a
!> jump into contact.
!>
!> While it grows, \( Q_i = \int e^{-(t-s)/t_i} a\, d\delta(s) \) is found on panels of time, and the load is
!> \( 2[E_0 \int a\, d\delta + \sum E_i Q_i] \). While it shrinks, the edge is where it was at the time t1, which is the root of
!> $$ E_0 [\delta(t) - \delta(t_1)] + \sum_i E_i [D_i(t) - D_i(t_1) e^{-(t - t_1)/t_i}] = 0, $$
!> and the load is the same sum with Q_i(t1) exp(-(t - t1)/t_i). So a point costs a root and a look at a panel, and nothing is
!> followed step by step. Springs of the jump have all come at once. Among them the edge is at the depth G with
!> \( E_0 \delta(t) + \sum_i E_i D_i(t) = E(t)\, G \), and the load is \( 2 E(t) \int_0^G a\, d\delta \).
!> Times are those of the legs, and lengths and moduli have the units of the contacts. The file is long by what growth and shrinking
!> share.
module adfric_round_timed_cycle
   use adfric_base_kinds, only: dp
   use adfric_interface_normal_contact, only: normal_contact_t
   use adfric_numerics_time_panels, only: get_faded, get_tail, get_weights, last_begun, lost_part, n_nodes, panel_nodes
   use adfric_round_timed_path, only: timed_control_t, timed_leg_t
   use adfric_round_timed_springs, only: get_spot
   use adfric_solid_prony, only: prony_t
   implicit none (type, external)
   private
   public :: timed_cycle_t, new_cycle, read_cycle, find_origin, get_memories, load_of, approach_at, drive_at

   !> A panel of the growing contact.
   type :: grown_panel_t
      !> Time at the begin, and length in time.
      real(dp) :: clock = 0, span = 0
      !> Speed of the approach.
      real(dp) :: slope = 0
      !> Radius of contact at the nodes.
      real(dp) :: radius(n_nodes) = 0
      !> Load at the nodes.
      real(dp) :: load(n_nodes) = 0
      !> int a d delta in column 0, and Q_i in column i, at the nodes; shape `(n_nodes, 0:n_arms)`.
      real(dp), allocatable :: sums(:, :)
   end type grown_panel_t

   !> A cycle.
   type :: timed_cycle_t
      !> Is it one, and was it found?
      logical :: is_found = .false.
      !> Error of the load over the largest one, estimated.
      real(dp) :: error = 0
      !> The solid.
      type(prony_t) :: solid
      !> All legs; and those from the first touch on.
      type(timed_leg_t), allocatable :: path(:), legs(:)
      !> The last of these that does not fall.
      integer :: turn = 0
      !> End of the path, and approach right after a jump at its begin, 0 without one.
      real(dp) :: end = 0, jump = 0
      !> D_i at the begins of the legs; shape `(n_arms, n_legs)`.
      real(dp), allocatable :: drive(:, :)
      !> Panels of the growing contact.
      type(grown_panel_t), allocatable :: panels(:)
      !> Number of panels.
      integer :: n = 0
      !> The last time at which the shrinking contact was looked at, and its t1: a later one has an earlier t1.
      real(dp), private :: last = huge(1.0_dp), last_root = 0
   end type timed_cycle_t

   !> Panels that there is space for at first.
   integer, parameter :: first_space = 24

contains

   !> Find whether legs are one cycle, and if so, follow the growing contact.
   pure subroutine new_cycle(self, solid, contacts, control, legs, tolerance)
      !> Receives the cycle.
      type(timed_cycle_t), intent(out) :: self
      !> The solid, its relaxed modulus 1.
      type(prony_t), intent(in) :: solid
      !> Contacts of the indenter with an elastic half-space of modulus 1.
      class(normal_contact_t), intent(in) :: contacts
      !> What is prescribed.
      type(timed_control_t), intent(in) :: control
      !> Its legs; shape `(n_legs)`.
      type(timed_leg_t), intent(in) :: legs(:)
      !> Largest error of the load, over the largest one.
      real(dp), intent(in) :: tolerance
      integer :: k, first

      if (abs(control%by_load) > 0 .or. size(legs) == 0) return
      first = 1
      if (.not. legs(1)%span > 0 .and. .not. abs(legs(1)%begin) > 0 .and. legs(1)%end > 0) first = 2
      if (size(legs) < first) return
      if (any(abs(legs%amplitude) > 0) .or. .not. all(legs(first:)%span > 0)) return
      self%end = legs(size(legs))%clock + legs(size(legs))%span
      if (first == 2) self%jump = legs(1)%end
      self%solid = solid
      self%path = legs(first:)
      call take_legs(self, self%path)
      if (self%turn == 0) return
      associate (arms => size(solid%times))
         allocate (self%drive(arms, size(self%legs)))
         self%drive(:, 1) = self%jump
         do k = 2, size(self%legs)
            call drive_at(self, k - 1, self%legs(k)%clock, self%drive(:, k))
         end do
      end associate
      call grow(self, contacts, tolerance)
   end subroutine new_cycle

   !> Keep the legs from the first touch to where contact is lost at the latest, if they are one cycle.
   pure subroutine take_legs(self, legs)
      type(timed_cycle_t), intent(inout) :: self
      type(timed_leg_t), intent(in) :: legs(:)
      real(dp) :: slopes(size(legs))
      integer :: first, last, k

      first = findloc(legs%end > 0, .true., 1)
      if (first == 0) return
      if (.not. self%jump > 0 .and. legs(first)%begin > 0) return
      if (self%jump > 0 .and. (first > 1 .or. abs(legs(1)%begin - self%jump) > 0)) return
      last = size(legs) + 1 - findloc(legs(size(legs):1:-1)%begin > 0 .or. legs(size(legs):1:-1)%end > 0, .true., 1)
      slopes = (legs%end - legs%begin)/legs%span
      self%legs = legs(first:last)
      do k = first, last
         if (slopes(k) < 0) exit
      end do
      ! from then on never slower
      if (any(slopes(k + 1:last) > slopes(k:last - 1))) return
      if (any(legs(first + 1:last)%begin <= 0)) return
      self%turn = k - first
      if (self%jump > 0) return
      associate (leg => self%legs(1))
         leg%clock = leg%clock - leg%begin/slopes(first)
         leg%span = leg%end/slopes(first)
         leg%begin = 0
      end associate
   end subroutine take_legs

   !> D_i at a time of a leg.
   pure subroutine drive_at(self, leg, clock, drive)
      !> The cycle, with D_i at the begin of the leg.
      type(timed_cycle_t), intent(in) :: self
      !> The leg, among those from the first touch on, and the time.
      integer, intent(in) :: leg
      real(dp), intent(in) :: clock
      !> Receives D_i; shape `(n_arms)`.
      real(dp), intent(out) :: drive(:)
      real(dp) :: slope

      associate (l => self%legs(leg), times => self%solid%times)
         slope = (l%end - l%begin)/l%span
         drive = slope*times*lost_part((clock - l%clock)/times) + self%drive(:, leg)*exp(-(clock - l%clock)/times)
      end associate
   end subroutine drive_at

   !> Follow the growing contact.
   pure subroutine grow(self, contacts, tolerance)
      type(timed_cycle_t), intent(inout) :: self
      class(normal_contact_t), intent(in) :: contacts
      real(dp), intent(in) :: tolerance
      integer, parameter :: most_tries = 1000
      real(dp), parameter :: first_part = 3.0e-3_dp, margin = 4
      type(grown_panel_t) :: panel
      real(dp) :: sums(0:size(self%solid%times)), largest, span, end, error, radius, moment
      integer :: leg, try

      associate (legs => self%legs, turn => self%legs(self%turn), solid => self%solid)
         call get_spot(contacts, turn%end, radius, moment)
         end = turn%clock + turn%span
         ! the load is as large at least
         largest = 2*(solid%relaxed + sum(solid%moduli*exp(-(end - legs(1)%clock)/solid%times)))*(turn%end*radius - moment)
         if (.not. largest > 0) return
         allocate (self%panels(first_space))
         leg = 1
         sums = 0
         if (self%jump > 0) then
            call get_spot(contacts, self%jump, radius, moment)
            sums = self%jump*radius - moment
         end if
         panel%clock = legs(1)%clock
         span = first_part*(end - legs(1)%clock)
         do try = 1, most_tries
            end = end_of_piece(legs(leg), contacts%kink, panel%clock)
            panel%span = end - panel%clock
            if (panel%span > span) panel%span = merge(panel%span/2, span, span > 0.6_dp*panel%span)
            call solve_growth(solid, contacts, legs(leg), sums, panel, error)
            error = error/(tolerance*largest)
            if (.not. error < huge(1.0_dp)) return
            span = panel%span*max(0.2_dp, min(6.0_dp, 0.8_dp*max(error, 1.0e-20_dp)**(-1.0_dp/n_nodes)))
            if (error > 1) cycle
            self%error = max(self%error, margin*tolerance*error)
            call keep(self, panel)
            sums = panel%sums(n_nodes, :)
            panel%clock = panel%clock + panel%span
            if (panel%clock < end - 4*epsilon(1.0_dp)*(abs(end) + legs(1)%span)) cycle
            panel%clock = end
            if (end < legs(leg)%clock + legs(leg)%span) cycle
            if (leg == self%turn) exit
            leg = leg + 1
            panel%clock = legs(leg)%clock
         end do
         self%is_found = try <= most_tries
         self%error = max(self%error, 16*epsilon(1.0_dp))
      end associate
   end subroutine grow

   !> Where a leg ends, or the edge passes a corner of the profile.
   pure real(dp) function end_of_piece(leg, kink, clock) result(end)
      type(timed_leg_t), intent(in) :: leg
      !> Depth of the corner, and a time before the end.
      real(dp), intent(in) :: kink, clock
      real(dp) :: corner

      end = leg%clock + leg%span
      if (.not. (kink > leg%begin .and. kink < leg%end)) return
      corner = leg%clock + leg%span*(kink - leg%begin)/(leg%end - leg%begin)
      if (corner > clock .and. corner < end) end = corner
   end function end_of_piece

   !> A panel of the growing contact.
   pure subroutine solve_growth(solid, contacts, leg, sums, panel, error)
      type(prony_t), intent(in) :: solid
      class(normal_contact_t), intent(in) :: contacts
      !> The leg.
      type(timed_leg_t), intent(in) :: leg
      !> int a d delta and Q_i at the begin; shape `(0:n_arms)`.
      real(dp), intent(in) :: sums(0:)
      !> In: begin and length. Out: with loads and sums.
      type(grown_panel_t), intent(inout) :: panel
      !> Receives what the polynomials may lack of the load.
      real(dp), intent(out) :: error
      real(dp) :: depth(n_nodes), moment(n_nodes), integral(n_nodes), faded(n_nodes), slope, lacking
      integer :: i

      if (.not. allocated(panel%sums)) allocate (panel%sums(n_nodes, 0:size(solid%times)))
      slope = (leg%end - leg%begin)/leg%span
      panel%slope = slope
      depth = leg%begin + slope*(panel%clock - leg%clock + panel%span*(panel_nodes + 1)/2)
      call get_spot(contacts, depth, panel%radius, moment)
      panel%sums(:, 0) = depth*panel%radius - moment
      panel%load = solid%relaxed*panel%sums(:, 0)
      lacking = get_tail(panel%radius)*slope
      error = solid%relaxed*get_tail(panel%sums(:, 0))
      do i = 1, size(solid%times)
         if (slope > 0) then
            call get_faded(panel%span/(2*solid%times(i)), panel%radius, integral, faded)
            panel%sums(:, i) = faded*sums(i) + integral*(slope*panel%span/2)
         else
            panel%sums(:, i) = exp(-panel%span/(2*solid%times(i))*(panel_nodes + 1))*sums(i)
         end if
         panel%load = panel%load + solid%moduli(i)*panel%sums(:, i)
         error = error + solid%moduli(i)*lacking*min(solid%times(i), panel%span)
      end do
      panel%load = 2*panel%load
      error = max(2*error, get_tail(panel%load))
   end subroutine solve_growth

   !> Keep a panel.
   pure subroutine keep(self, panel)
      type(timed_cycle_t), intent(inout) :: self
      type(grown_panel_t), intent(in) :: panel
      type(grown_panel_t), allocatable :: more(:)
      integer :: k

      if (self%n == size(self%panels)) then
         allocate (more(2*self%n))
         do k = 1, self%n
            more(k) = self%panels(k)
         end do
         call move_alloc(more, self%panels)
      end if
      self%n = self%n + 1
      self%panels(self%n) = panel
   end subroutine keep

   !> Approach, depth of the edge and load at a time; the latter are both 0 without contact.
   pure subroutine read_cycle(self, contacts, clock, approach, depth, load)
      !> The cycle; it remembers where it was looked at last.
      type(timed_cycle_t), intent(inout) :: self
      !> Contacts of the indenter with an elastic half-space of modulus 1.
      class(normal_contact_t), intent(in) :: contacts
      !> The time, in that of the legs.
      real(dp), intent(in) :: clock
      !> Receive delta, G(a) and the load.
      real(dp), intent(out) :: approach, depth, load
      real(dp) :: weights(n_nodes), memories(0:size(self%solid%times)), root
      integer :: leg, k
      logical :: has_contact

      approach = approach_at(self%path(max(1, count(self%path%clock <= clock))), clock)
      load = 0
      call find_origin(self, clock, leg, root, depth, has_contact)
      if (.not. has_contact) return
      if (leg <= self%turn) then
         call look_at(self, root, k, weights)
         load = dot_product(weights, self%panels(k)%load)
      else
         call get_memories(self, contacts, root, depth, memories, k, weights)
         load = load_of(self, memories, clock - root)
      end if
   end subroutine read_cycle

   !> What the springs in contact remember up to the time t1: int a d delta, and Q_i.
   pure subroutine get_memories(self, contacts, root, depth, memories, panel, weights)
      !> The cycle.
      type(timed_cycle_t), intent(in) :: self
      !> Contacts of the indenter with an elastic half-space of modulus 1.
      class(normal_contact_t), intent(in) :: contacts
      !> t1 and G(a), as `find_origin` says.
      real(dp), intent(in) :: root, depth
      !> Receives int a d delta in column 0, and Q_i in column i; shape `(0:n_arms)`.
      real(dp), intent(out) :: memories(0:)
      !> Receives the number of the panel of t1, 0 in the jump.
      integer, intent(out) :: panel
      !> Receives the weights of its nodes.
      real(dp), intent(out) :: weights(n_nodes)
      real(dp) :: radius, moment
      integer :: i

      if (depth < self%jump) then
         panel = 0
         weights = 0
         call get_spot(contacts, depth, radius, moment)
         memories = depth*radius - moment
         return
      end if
      call look_at(self, root, panel, weights)
      do i = 0, size(self%solid%times)
         memories(i) = dot_product(weights, self%panels(panel)%sums(:, i))
      end do
   end subroutine get_memories

   !> The load of what springs remember, some time later.
   pure real(dp) function load_of(self, memories, lag) result(load)
      !> The cycle.
      type(timed_cycle_t), intent(in) :: self
      !> See `get_memories`; shape `(0:n_arms)`.
      real(dp), intent(in) :: memories(0:)
      !> The time that has passed since t1.
      real(dp), intent(in) :: lag
      integer :: i

      load = self%solid%relaxed*memories(0)
      do i = 1, size(self%solid%times)
         load = load + self%solid%moduli(i)*exp(-lag/self%solid%times(i))*memories(i)
      end do
      load = max(0.0_dp, 2*load)
   end function load_of

   !> The time t1 at which the edge came to where it is: now while the contact grows, earlier while it shrinks.
   pure subroutine find_origin(self, clock, leg, root, depth, has_contact)
      !> The cycle; it remembers where it was looked at last.
      type(timed_cycle_t), intent(inout) :: self
      !> The time t, in that of the legs.
      real(dp), intent(in) :: clock
      !> Receives the leg of the time, among those from the first touch on; 0: before it.
      integer, intent(out) :: leg
      !> Receive t1 and G(a), the approach there; below `jump` it came into contact in the jump.
      real(dp), intent(out) :: root, depth
      !> Receives whether there is contact.
      logical, intent(out) :: has_contact

      root = clock
      depth = 0
      leg = 0
      has_contact = clock > self%legs(1)%clock .or. self%jump > 0
      if (.not. has_contact) return
      leg = max(1, count(self%legs%clock <= clock))
      if (leg <= self%turn) then
         depth = approach_at(self%legs(leg), clock)
      else
         call find_root(self, leg, clock, root, depth, has_contact)
      end if
   end subroutine find_origin

   !> The panel of a time, and the weights of its nodes.
   pure subroutine look_at(self, clock, panel, weights)
      !> The cycle.
      type(timed_cycle_t), intent(in) :: self
      !> The time, while the contact grows.
      real(dp), intent(in) :: clock
      !> Receives the number of the panel.
      integer, intent(out) :: panel
      !> Receives the weights.
      real(dp), intent(out) :: weights(n_nodes)

      panel = last_begun(self%panels(:self%n)%clock, clock)
      associate (found => self%panels(panel))
         call get_weights(min(1.0_dp, max(-1.0_dp, 2*(clock - found%clock)/found%span - 1)), weights)
      end associate
   end subroutine look_at

   !> The approach at a time of a leg.
   pure real(dp) function approach_at(leg, clock) result(approach)
      !> The leg.
      type(timed_leg_t), intent(in) :: leg
      !> The time.
      real(dp), intent(in) :: clock

      approach = leg%begin + (leg%end - leg%begin)*max(0.0_dp, min(1.0_dp, (clock - leg%clock)/leg%span))
   end function approach_at

   !> The time t1 at which the edge was where it is. E_0 delta(t1) + sum E_i D_i(t1) exp(-(t - t1)/t_i) rises with t1 and is convex
   !> along a leg, so Newton's method from above passes no root.
   pure subroutine find_root(self, leg, clock, root, depth, has_contact)
      type(timed_cycle_t), intent(inout) :: self
      !> The leg, and the time t.
      integer, intent(in) :: leg
      real(dp), intent(in) :: clock
      !> Receive t1 and the approach there.
      real(dp), intent(out) :: root, depth
      logical, intent(out) :: has_contact
      integer, parameter :: most_steps = 100
      real(dp) :: drive(size(self%solid%times)), faded(size(self%solid%times)), base, rest, slope, change, value
      integer :: k, step

      associate (solid => self%solid)
         root = self%legs(1)%clock
         depth = 0
         call drive_at(self, leg, clock, drive)
         base = solid%relaxed*approach_at(self%legs(leg), clock) + sum(solid%moduli*drive)
         has_contact = base > 0
         if (.not. has_contact) return
         do k = self%turn, 1, -1
            associate (l => self%legs(k))
               faded = exp(-(clock - l%clock)/solid%times)
               if (solid%relaxed*l%begin + sum(solid%moduli*self%drive(:, k)*faded) > base) cycle
               slope = (l%end - l%begin)/l%span
               root = l%clock + l%span
               depth = l%end
               if (.not. slope > 0) return
               if (self%last <= clock .and. self%last_root >= l%clock) root = min(root, self%last_root)
               rest = solid%relaxed*l%begin + sum(solid%moduli*self%drive(:, k)*faded) - base
               do step = 1, most_steps
                  faded = exp(-(clock - root)/solid%times)
                  value = rest + slope*(solid%relaxed*(root - l%clock) + sum(solid%moduli*solid%times*faded &
                     & *lost_part((root - l%clock)/solid%times)))
                  change = value/(slope*(solid%relaxed + sum(solid%moduli*faded)))
                  root = min(l%clock + l%span, max(l%clock, root - change))
                  if (abs(change) <= 4*epsilon(1.0_dp)*self%end) exit
               end do
               depth = approach_at(l, root)
            end associate
            exit
         end do
         if (k == 0) depth = base/(solid%relaxed + sum(solid%moduli*exp(-(clock - root)/solid%times)))
      end associate
      self%last = clock
      self%last_root = root
   end subroutine find_root

end module adfric_round_timed_cycle

! SPDX-License-Identifier: GPL-3.0-or-later
!> One period of a column on its path, zone by zone.
!>
!> The state of a column where the period begins is the lengths of its dashpots, less the shift while it is attached, and whether it
!> is attached. The period returns what the lengths grow by, as a sum over zones that keeps the digits of slow arms, and the zones, from
!> which everything else follows.
!>
!> The file is long by two kinds of open zones: those of Dugdale's law in closed form, and those of other laws in steps.
module adfric_foundation_stepping_period
   use adfric_base_kinds, only: dp
   use adfric_foundation_stepping_attracted_zone, only: attracted_sums_t, gap_trace_t, pass_attracted_zone
   use adfric_foundation_stepping_law, only: stepping_law_t
   use adfric_foundation_stepping_solid, only: product_of
   use adfric_foundation_stepping_path, only: column_path_t, decay_of, expm1_of, height_at, stretches_at, pressure_since
   use adfric_foundation_stepping_zone_end, only: position_t, end_contact, end_open_zone, period_over, zone_closes
   implicit none (type, external)
   private
   public :: column_state_t, zone_t, stepped_period_t, step_period, in_contact, in_adhesion, in_free, &
      & in_attraction

   !> Kinds of zones; the last one is every open zone of another law than Dugdale's.
   integer, parameter :: in_contact = 1, in_adhesion = 2, in_free = 3, in_attraction = 4
   !> Most zones for each piece of the heights.
   integer, parameter :: most_zones = 4

   !> State of a column.
   type :: column_state_t
      !> Lengths of the dashpots, less the shift while the column is attached; shape `(n_arms)`.
      real(dp), allocatable :: length(:)
      !> Is the column in contact or in adhesion? Not used without adhesion.
      logical :: is_attached = .true.
      !> Branch of another law than Dugdale's.
      integer :: branch = 0
   end type column_state_t

   !> A zone.
   type :: zone_t
      !> One of `in_...`.
      integer :: kind = in_contact
      !> Where it begins and ends.
      type(position_t) :: start, finish
      !> Its share of the period.
      real(dp) :: duration = 0
      !> Height where it begins and ends, without the penetration.
      real(dp) :: first_height = 0, last_height = 0
      !> Integral of the pressure.
      real(dp) :: load = 0
      !> How it ends: `period_over`, `zone_closes` or `zone_lets_go`.
      integer :: ending = period_over
      !> Did the surface snap into this contact?
      logical :: is_snap = .false.
      !> Number of the span of gaps of a zone under another law than Dugdale's.
      integer :: span = 0
      !> Integrals over such a zone.
      type(attracted_sums_t) :: sums
   end type zone_t

   !> A period.
   type :: stepped_period_t
      !> Number of zones.
      integer :: n_zones = 0
      !> The zones in their order; more may be allocated.
      type(zone_t), allocatable :: zones(:)
      !> What zones begin with: stretches less those of endless contact, or Kelvin elements; shape `(n_arms, n_zones)`.
      real(dp), allocatable :: start(:, :)
      !> Growth of the lengths of the dashpots, without jumps at edges; shape `(n_arms)`.
      real(dp), allocatable :: growth(:)
      !> The stretches where the period ends, if it ends in contact; shape `(n_arms)`.
      real(dp), allocatable :: last_stretch(:)
      !> Is the column attached where the period ends?
      logical :: is_attached = .true.
      !> Branch where it ends, and number of jumps to larger gaps, of another law than Dugdale's.
      integer :: branch = 0, n_snaps = 0
      !> Energy that its jumps take.
      real(dp) :: jump_loss = 0
      !> Integral of the pressure over the period, and its share in contact.
      real(dp) :: load = 0
      !> Was every zone followed to its end?
      logical :: is_complete = .false.
   end type stepped_period_t

contains

   !> Time stepping one period.
   pure subroutine step_period(path, law, depth, state, period, trace)
      type(column_path_t), intent(in) :: path
      type(stepping_law_t), intent(in) :: law
      !> Penetration, by which all heights are higher.
      real(dp), intent(in) :: depth
      type(column_state_t), intent(in) :: state
      !> Receives the period; its memory is used again.
      type(stepped_period_t), intent(inout) :: period
      !> Receives the gaps under another law than Dugdale's.
      type(gap_trace_t), intent(inout), optional :: trace
      real(dp) :: current(path%solid%n)
      type(position_t) :: position
      integer :: kind, span
      logical :: is_over, is_snap

      call clear(period, path%solid%n)
      call begin(path, law, depth, state, kind, span, current)
      position = position_t()
      is_snap = .false.
      do while (period%n_zones < most_zones*path%n + 16)
         call add_zone(period, kind, span, position, is_snap)
         associate (zone => period%zones(period%n_zones))
            if (kind == in_contact) then
               call pass_contact(path, law, depth, zone, current, period, is_over)
            else if (kind == in_attraction) then
               call pass_attraction(path, law, depth, zone, current, period, is_over, trace)
            else
               call pass_open_zone(path, law, depth, zone, current, period, is_over)
            end if
            position = zone%finish
            period%load = period%load + zone%load
            if (is_over) exit
            if (allocated(law%attraction)) then
               call cross_span(path, law, depth, zone, current, kind, span, period)
            else
               call cross_edge(path, law, depth, zone, current, kind, is_snap)
            end if
         end associate
         if (.not. period%is_complete) exit
      end do
      period%is_complete = period%is_complete .and. is_over
      period%is_attached = kind /= in_free
      if (allocated(law%attraction)) period%branch = law%attraction%branch_of(span)
      if (kind == in_contact) period%last_stretch = current
   end subroutine step_period

   !> Forget the last period.
   pure subroutine clear(period, n)
      !> The period, whose memory is kept.
      type(stepped_period_t), intent(inout) :: period
      !> Number of arms.
      integer, intent(in) :: n
      integer, parameter :: first_space = 32

      if (allocated(period%start)) then
         if (size(period%start, 1) /= n) deallocate (period%zones, period%start, period%growth)
      end if
      if (.not. allocated(period%zones)) allocate (period%zones(first_space), period%start(n, first_space), period%growth(n))
      period%n_zones = 0
      period%growth = 0
      period%load = 0
      period%is_complete = .true.
      period%is_attached = .true.
      period%branch = 0
      period%n_snaps = 0
      period%jump_loss = 0
      if (allocated(period%last_stretch)) deallocate (period%last_stretch)
   end subroutine clear

   !> Zone and state where the period begins.
   pure subroutine begin(path, law, depth, state, kind, span, current)
      type(column_path_t), intent(in) :: path
      type(stepping_law_t), intent(in) :: law
      real(dp), intent(in) :: depth
      type(column_state_t), intent(in) :: state
      integer, intent(out) :: kind
      !> Receives the span of another law than Dugdale's; 0 else.
      integer, intent(out) :: span
      !> Receives the stretches, or the Kelvin elements; shape `(n_arms)`.
      real(dp), intent(out) :: current(:)
      real(dp) :: height, apart
      logical :: is_attached

      height = depth + path%coefficients(0, 1)
      apart = sum(path%solid%stiffness*state%length)/path%solid%glassy - height
      span = 0
      if (allocated(law%attraction)) then
         span = law%attraction%span_of(state%branch, apart)
         kind = merge(in_contact, in_attraction, span == 0)
      else if (law%stress > 0) then
         is_attached = state%is_attached
         if (apart <= law%attach_gap) is_attached = .true.
         if (apart >= law%release_reach) is_attached = .false.
         kind = in_free
         if (is_attached) kind = merge(in_contact, in_adhesion, apart <= law%drop)
      else
         kind = merge(in_contact, in_free, apart < 0)
      end if
      select case (kind)
      case (in_contact)
         current = height - (state%length + law%shift)
      case (in_adhesion)
         current = product_of(path%solid%elements_of_lengths, state%length + law%shift + law%stress)
      case default
         current = product_of(path%solid%elements_of_lengths, state%length)
      end select
   end subroutine begin

   !> Add a zone.
   pure subroutine add_zone(period, kind, span, position, is_snap)
      type(stepped_period_t), intent(inout) :: period
      integer, intent(in) :: kind
      !> Span of another law than Dugdale's.
      integer, intent(in) :: span
      type(position_t), intent(in) :: position
      logical, intent(in) :: is_snap
      type(zone_t), allocatable :: zones(:)
      real(dp), allocatable :: start(:, :)
      integer :: n

      n = period%n_zones
      if (n == size(period%zones)) then
         allocate (zones(2*n), start(size(period%start, 1), 2*n))
         zones(:n) = period%zones
         start(:, :n) = period%start
         call move_alloc(zones, period%zones)
         call move_alloc(start, period%start)
      end if
      period%n_zones = n + 1
      period%zones(n + 1) = zone_t(kind=kind, start=position, is_snap=is_snap, span=span)
   end subroutine add_zone

   !> Pass a contact.
   pure subroutine pass_contact(path, law, depth, zone, current, period, is_over)
      type(column_path_t), intent(in) :: path
      type(stepping_law_t), intent(in) :: law
      real(dp), intent(in) :: depth
      !> The zone; receives its end and load.
      type(zone_t), intent(inout) :: zone
      !> In: stretches where it begins. Out: where it ends; shape `(n_arms)`.
      real(dp), intent(inout) :: current(:)
      !> The period, whose growth is completed.
      type(stepped_period_t), intent(inout) :: period
      logical, intent(out) :: is_over
      real(dp), dimension(path%solid%n) :: first, first_growth, last, last_growth, disturbance, passed, lost, grown
      logical :: is_found
      integer :: event

      associate (s => path%solid)
         call stretches_at(path, zone%start%piece, zone%start%theta, first, first_growth)
         disturbance = current - first
         period%start(:, period%n_zones) = disturbance
         zone%finish = position_t(zone%start%piece, zone%start%theta)
         call end_contact(path, depth, law%strength, disturbance, zone%finish, event, is_found)
         period%is_complete = period%is_complete .and. is_found
         is_over = event == period_over
         zone%ending = event
         call close_period(path, zone)
         call measure(path, zone)
         call stretches_at(path, zone%finish%piece, zone%finish%theta, last, last_growth)
         passed = zone%duration/s%time
         lost = expm1_of(-passed)
         current = last + disturbance*decay_of(passed)
         grown = (zone%last_height - zone%first_height) - (last - first)
         where (path%is_slow) grown = last_growth - first_growth
         zone%load = depth*zone%duration - sum(s%stiffness*s%time*disturbance*lost) &
            & + pressure_since(path, zone%start%piece - 1, zone%finish%piece, zone%finish%theta, last, last_growth) &
            & - pressure_since(path, zone%start%piece - 1, zone%start%piece, zone%start%theta, first, first_growth)
         period%growth = period%growth + grown - disturbance*lost
      end associate
   end subroutine pass_contact

   !> Pass an open zone.
   pure subroutine pass_open_zone(path, law, depth, zone, current, period, is_over)
      type(column_path_t), intent(in) :: path
      type(stepping_law_t), intent(in) :: law
      real(dp), intent(in) :: depth
      type(zone_t), intent(inout) :: zone
      !> In: Kelvin elements where it begins. Out: where it ends; shape `(n_arms)`.
      real(dp), intent(inout) :: current(:)
      type(stepped_period_t), intent(inout) :: period
      logical, intent(out) :: is_over
      real(dp) :: lost(path%solid%n), pressure, close_gap, release_gap
      logical :: is_found
      integer :: event

      period%start(:, period%n_zones) = current
      pressure = merge(-law%stress, 0.0_dp, zone%kind == in_adhesion)
      close_gap = merge(0.0_dp, law%attach_gap, zone%kind == in_adhesion)
      release_gap = merge(law%release_gap, huge(1.0_dp), zone%kind == in_adhesion)
      zone%finish = position_t(zone%start%piece, zone%start%theta)
      call end_open_zone(path, depth, pressure, close_gap, release_gap, current, zone%finish, event, is_found)
      period%is_complete = period%is_complete .and. is_found
      is_over = event == period_over
      call close_period(path, zone)
      call measure(path, zone)
      lost = expm1_of(-zone%duration/path%solid%retardation)
      period%growth = period%growth + product_of(path%solid%lengths_of_elements, current*lost)
      current = current*decay_of(zone%duration/path%solid%retardation)
      zone%load = pressure*zone%duration
      zone%ending = event
   end subroutine pass_open_zone

   !> Pass an open zone of another law than Dugdale's.
   pure subroutine pass_attraction(path, law, depth, zone, current, period, is_over, trace)
      type(column_path_t), intent(in) :: path
      type(stepping_law_t), intent(in) :: law
      real(dp), intent(in) :: depth
      type(zone_t), intent(inout) :: zone
      !> In: Kelvin elements where it begins. Out: where it ends; shape `(n_arms)`.
      real(dp), intent(inout) :: current(:)
      type(stepped_period_t), intent(inout) :: period
      logical, intent(out) :: is_over
      type(gap_trace_t), intent(inout), optional :: trace
      real(dp) :: grown(path%solid%n)
      logical :: is_found
      integer :: event

      period%start(:, period%n_zones) = current
      zone%finish = position_t(zone%start%piece, zone%start%theta)
      call pass_attracted_zone(path, law%attraction, zone%span, depth, zone%finish, current, grown, zone%sums, event, &
         & is_found, trace)
      period%is_complete = period%is_complete .and. is_found
      is_over = event == period_over
      call close_period(path, zone)
      call measure(path, zone)
      zone%duration = zone%sums%duration
      zone%load = zone%sums%load
      zone%ending = event
      period%growth = period%growth + product_of(path%solid%lengths_of_elements, grown)
   end subroutine pass_attraction

   !> Cross the end of a span of another law than Dugdale's.
   pure subroutine cross_span(path, law, depth, zone, current, kind, span, period)
      type(column_path_t), intent(in) :: path
      type(stepping_law_t), intent(in) :: law
      real(dp), intent(in) :: depth
      type(zone_t), intent(in) :: zone
      !> In: state before the end. Out: behind it, of the kind of the next zone; shape `(n_arms)`.
      real(dp), intent(inout) :: current(:)
      !> In: kind and span of the zone. Out: those of the next one.
      integer, intent(inout) :: kind, span
      !> The period, whose losses are completed.
      type(stepped_period_t), intent(inout) :: period
      real(dp) :: reach, gap, next_gap
      integer :: next

      associate (s => path%solid, a => law%attraction)
         if (kind == in_contact) then
            ! the dashpots keep their lengths while the column is let go
            current = current - (depth + zone%last_height + sum(s%stiffness*current))/s%glassy
            current = product_of(s%elements_of_stretches, current)
            reach = a%contact_reach
            gap = 0
            next = a%span_above(span, reach)
         else if (zone%ending == zone_closes) then
            reach = a%spans(span)%low_reach
            gap = a%spans(span)%low_gap
            next = a%span_below(span, reach)
         else
            reach = a%spans(span)%high_reach
            gap = a%spans(span)%high_gap
            next = a%span_above(span, reach)
         end if
         if (next == 0) current = product_of(s%stretches_of_elements, current) - reach
         if (a%branch_of(next) /= a%branch_of(span)) then
            next_gap = a%gap_at(next, reach)
            period%jump_loss = period%jump_loss + (a%energy(gap, reach) - a%energy(next_gap, reach))
            if (next > span) period%n_snaps = period%n_snaps + 1
         end if
      end associate
      span = next
      kind = merge(in_contact, in_attraction, next == 0)
   end subroutine cross_span

   !> The end of the period is the end of its last piece.
   pure subroutine close_period(path, zone)
      type(column_path_t), intent(in) :: path
      !> The zone, whose end may lie behind the last piece.
      type(zone_t), intent(inout) :: zone

      if (zone%finish%piece > path%n) zone%finish = position_t(path%n, 1.0_dp)
   end subroutine close_period

   !> Duration and heights of a zone.
   pure subroutine measure(path, zone)
      type(column_path_t), intent(in) :: path
      type(zone_t), intent(inout) :: zone

      zone%duration = (real(zone%finish%piece - zone%start%piece, dp) + (zone%finish%theta - zone%start%theta))*path%step
      if (zone%finish%passed >= 0) zone%duration = zone%finish%passed*path%step
      zone%first_height = height_at(path, zone%start%piece, zone%start%theta)
      zone%last_height = height_at(path, zone%finish%piece, zone%finish%theta)
      ! to the last digit, where the friction of a closed contact is a small part of the work
      if (zone%finish%piece == path%n .and. zone%finish%theta >= 1) zone%last_height = path%coefficients(0, 1)
   end subroutine measure

   !> Cross the edge between two zones.
   pure subroutine cross_edge(path, law, depth, zone, current, kind, is_snap)
      type(column_path_t), intent(in) :: path
      type(stepping_law_t), intent(in) :: law
      real(dp), intent(in) :: depth
      type(zone_t), intent(in) :: zone
      !> In: state before the edge. Out: behind it, of the kind of the next zone; shape `(n_arms)`.
      real(dp), intent(inout) :: current(:)
      !> Receives the kind of the next zone.
      integer, intent(inout) :: kind
      !> Receives whether the surface snaps into the next zone.
      logical, intent(out) :: is_snap

      is_snap = .false.
      associate (s => path%solid)
         select case (zone%kind)
         case (in_contact)
            ! the dashpots keep their lengths, and w follows from them and from the pressure
            current = current - (depth + zone%last_height + sum(s%stiffness*current) + law%strength)/s%glassy
            if (.not. law%has_zones) current = current + law%strength/s%glassy
            current = product_of(s%elements_of_stretches, current)
            kind = merge(in_adhesion, in_free, law%has_zones)
         case (in_adhesion)
            if (zone%ending == zone_closes) then
               current = product_of(s%stretches_of_elements, current)
               kind = in_contact
            else
               current = current - s%compliance*(law%stress + law%shift)
               kind = in_free
            end if
         case default
            if (law%has_zones .and. .not. law%snaps) then
               current = current + s%compliance*(law%stress + law%shift)
               kind = in_adhesion
            else
               is_snap = law%stress > 0
               current = product_of(s%stretches_of_elements, current) - law%attach_gap
               kind = in_contact
            end if
         end select
      end associate
   end subroutine cross_edge

end module adfric_foundation_stepping_period

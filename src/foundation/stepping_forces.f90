! SPDX-License-Identifier: GPL-3.0-or-later
!> Friction, losses, areas and counts of a steady period.
!>
!> Friction is the integral of p df along the path. Losses are those of the arms: in open zones from the Kelvin elements, which lose
!> what the arms lose (their scaled amplitudes are those of the arms, turned), in contact what the work of the pressure leaves after
!> the change of the energy that is stored. Beside them edges of adhesion may take energy.
module adfric_foundation_stepping_forces
   use adfric_base_kinds, only: dp
   use adfric_numerics_phi_functions, only: get_exponential_moments
   use adfric_foundation_stepping_law, only: stepping_law_t
   use adfric_foundation_stepping_period, only: stepped_period_t, zone_t, in_contact, in_adhesion, in_free, &
      & in_attraction
   use adfric_foundation_stepping_solid, only: product_of
   use adfric_foundation_stepping_path, only: column_path_t, decay_of, expm1_of, get_double_moment, stretches_at, work_of_heights
   use adfric_foundation_stepping_zone_end, only: position_t
   implicit none (type, external)
   private
   public :: stepping_forces_t, get_stepping_forces

   !> Forces of a period, with lengths along it in periods.
   type :: stepping_forces_t
      !> Load and friction.
      real(dp) :: load = 0, friction = 0
      !> Energy that the arms and the edges of adhesion take.
      real(dp) :: dissipation = 0, edge_loss = 0
      !> Shares of contact and of adhesion.
      real(dp) :: contact = 0, adhesion = 0
      !> What the mean displacement leaves over of the load, and friction over the losses.
      real(dp) :: load_mismatch = 0, energy_mismatch = 0
      !> Sizes of the terms of load and friction.
      real(dp) :: load_scale = 0, friction_scale = 0
      !> By how much the heights change from the beginning to the end of contacts, whatever its sign; a pressure that is off by
      !> a constant changes friction by that, and not more.
      real(dp) :: contact_rise = 0
      !> Numbers of contacts, adhesion zones, free zones, and of edges where the surface snaps off.
      integer :: n_contacts = 0, n_adhesions = 0, n_free = 0, n_snaps = 0
      !> Middle and length of the contact if there is one, in periods from where the period begins, along the path.
      real(dp) :: contact_middle = 0, contact_length = 0
   end type stepping_forces_t

contains

   !> Sum up a steady period.
   pure subroutine get_stepping_forces(path, law, depth, period, forces)
      type(column_path_t), intent(in) :: path
      type(stepping_law_t), intent(in) :: law
      real(dp), intent(in) :: depth
      type(stepped_period_t), intent(in) :: period
      type(stepping_forces_t), intent(out) :: forces
      real(dp) :: displacement
      integer :: i

      call count_zones(law, period, forces)
      ! what nothing touches is at rest; its state is 0 but for round-off
      if (forces%n_contacts + forces%n_adhesions == 0 .and. .not. allocated(law%attraction)) return
      displacement = 0
      do i = 1, period%n_zones
         if (period%zones(i)%kind == in_contact) then
            call add_contact(path, depth, period%zones(i), period%start(:, i), forces, displacement)
         else if (period%zones(i)%kind == in_attraction) then
            associate (sums => period%zones(i)%sums)
               forces%friction = forces%friction + sums%work
               forces%friction_scale = forces%friction_scale + sums%size_of_work
               forces%dissipation = forces%dissipation + sums%dissipation
               ! the area that the largest tension would have
               forces%adhesion = forces%adhesion - sums%load/law%stress
               displacement = displacement + sums%displacement
            end associate
         else
            call add_open_zone(path, law, period%zones(i), period%start(:, i), forces, displacement)
         end if
         forces%load_scale = forces%load_scale + abs(period%zones(i)%load)
      end do
      if (.not. forces%load_scale > 0) then
         ! nothing acts, and what was left of a stretch has decayed
         forces%friction = 0
         forces%friction_scale = 0
         forces%dissipation = 0
      end if
      ! the law pulls everywhere, so that its zones have no number but where there is no contact
      if (allocated(law%attraction) .and. forces%n_contacts == 0 .and. forces%load_scale > 0) forces%n_adhesions = 1
      call find_single_contact(path, period, forces)
      forces%load = period%load
      if (allocated(law%attraction)) then
         forces%edge_loss = period%jump_loss
         forces%n_snaps = period%n_snaps
      else
         forces%edge_loss = get_edge_loss(path, law, period)
      end if
      forces%load_mismatch = displacement - forces%load
      forces%energy_mismatch = forces%friction - forces%dissipation - forces%edge_loss
   end subroutine get_stepping_forces

   !> Add a contact.
   pure subroutine add_contact(path, depth, zone, disturbance, forces, displacement)
      type(column_path_t), intent(in) :: path
      real(dp), intent(in) :: depth
      type(zone_t), intent(in) :: zone
      !> Stretches less those of endless contact where it begins; shape `(n_arms)`.
      real(dp), intent(in) :: disturbance(:)
      type(stepping_forces_t), intent(inout) :: forces
      !> Integral of the displacement over the period.
      real(dp), intent(inout) :: displacement
      real(dp), dimension(path%solid%n) :: first, last, growth
      real(dp) :: work, size_of_work, stored, heights

      call stretches_at(path, zone%start%piece, zone%start%theta, first, growth)
      first = first + disturbance
      call integrate_contact(path, zone%start, zone%finish, disturbance, heights, work, size_of_work)
      call stretches_at(path, zone%finish%piece, zone%finish%theta, last, growth)
      last = last + disturbance*decay_of(zone%duration/path%solid%time)
      ! the penetration adds work to that of the spring that is relaxed
      work = work + depth*(zone%last_height - zone%first_height)
      stored = (zone%last_height - zone%first_height)*(depth + (zone%last_height + zone%first_height)/2) &
         & + sum(path%solid%stiffness*(last - first)*(last + first))/2
      forces%friction = forces%friction + work
      forces%friction_scale = forces%friction_scale + size_of_work
      forces%dissipation = forces%dissipation + (work - stored)
      forces%contact = forces%contact + zone%duration
      forces%contact_rise = forces%contact_rise + abs(zone%last_height - zone%first_height)
      displacement = displacement + depth*zone%duration + heights
   end subroutine add_contact

   !> Integrals over a contact, piece by piece.
   pure subroutine integrate_contact(path, start, finish, first_disturbance, heights, work, size_of_work)
      type(column_path_t), intent(in) :: path
      type(position_t), intent(in) :: start, finish
      !> Stretches less those of endless contact where it begins; shape `(n_arms)`.
      real(dp), intent(in) :: first_disturbance(:)
      !> Receives the integral of the heights over time.
      real(dp), intent(out) :: heights
      !> Receives the integral of the pressure over heights, without the penetration, and the size of its terms.
      real(dp), intent(out) :: work, size_of_work
      real(dp) :: from_height, to_height, kept
      real(dp) :: c(0:path%degree), first_moments(path%degree), part, from, to, first(path%solid%n), growth(path%solid%n), &
         & disturbance(path%solid%n)
      integer :: j, m

      heights = 0
      work = 0
      size_of_work = 0
      disturbance = first_disturbance
      ! what slow arms keep of their disturbance all but cancels what endless contact has; both act over the same change of height
      kept = sum(path%solid%stiffness*disturbance, path%is_slow)
      from_height = 0
      to_height = 0
      do j = start%piece, finish%piece
         from = merge(start%theta, 0.0_dp, j == start%piece)
         to = merge(finish%theta, 1.0_dp, j == finish%piece)
         if (.not. to > from) cycle
         call get_part(path%coefficients(:, j), from, to, c)
         do m = 0, path%degree
            heights = heights + (to - from)*path%step*c(m)/(m + 1)
         end do
         if (from > 0 .or. to < 1) then
            call stretches_at(path, j, from, first, growth)
            part = get_part_work(path, to - from, c, first + disturbance)
            disturbance = disturbance*decay_of((to - from)*path%ratio)
         else
            do m = 1, path%degree
               first_moments(m) = sum(path%moments(:, m)*disturbance)
            end do
            ! whole pieces follow each other, so that heights have to be known at the ends only
            if (j == start%piece .or. (j == start%piece + 1 .and. start%theta > 0)) from_height = c(0)
            to_height = path%coefficients(0, modulo(j, path%n) + 1)
            part = path%work(j) + sum((first_moments - kept)*c(1:))
            disturbance = disturbance*path%decay(:, 1)
            size_of_work = size_of_work + abs(work_of_heights(path, c(0), to_height, kept))
         end if
         work = work + part
         size_of_work = size_of_work + abs(part)
      end do
      work = work + work_of_heights(path, from_height, to_height, kept)
   end subroutine integrate_contact

   !> Coefficients of a part of a piece, from 0 to 1 on the part.
   pure subroutine get_part(c, from, to, part)
      !> Coefficients of the piece; shape `(0:degree)`.
      real(dp), intent(in) :: c(0:)
      !> Where the part begins and ends in the piece.
      real(dp), intent(in) :: from, to
      !> Receives its coefficients; shape `(0:degree)`.
      real(dp), intent(out) :: part(0:)
      real(dp) :: power
      integer :: i, m

      part = c
      do m = 0, ubound(c, 1) - 1
         do i = ubound(c, 1) - 1, m, -1
            part(i) = part(i) + from*part(i + 1)
         end do
      end do
      power = 1
      do m = 1, ubound(c, 1)
         power = power*(to - from)
         part(m) = part(m)*power
      end do
   end subroutine get_part

   !> Work of the pressure over a part of a piece.
   pure real(dp) function get_part_work(path, length, c, stretch) result(work)
      type(column_path_t), intent(in) :: path
      !> Length of the part in pieces.
      real(dp), intent(in) :: length
      !> Coefficients of the heights over the part; shape `(0:degree)`.
      real(dp), intent(in) :: c(0:)
      !> Stretches where the part begins; shape `(n_arms)`.
      real(dp), intent(in) :: stretch(:)
      real(dp) :: chi(0:path%degree), z
      integer :: i, l, m

      work = sum(c(1:))*(c(0) + sum(c))/2
      do i = 1, path%solid%n
         z = path%ratio(i)*length
         call get_exponential_moments(z, chi)
         do m = 1, path%degree
            work = work + path%solid%stiffness(i)*c(m)*stretch(i)*m*chi(m - 1)
            do l = 1, path%degree
               work = work + path%solid%stiffness(i)*c(m)*c(l)*get_double_moment(z, l, m)
            end do
         end do
      end do
   end function get_part_work

   !> Add a zone of adhesion or a free one.
   pure subroutine add_open_zone(path, law, zone, elements, forces, displacement)
      type(column_path_t), intent(in) :: path
      type(stepping_law_t), intent(in) :: law
      type(zone_t), intent(in) :: zone
      !> Kelvin elements where it begins; shape `(n_arms)`.
      real(dp), intent(in) :: elements(:)
      type(stepping_forces_t), intent(inout) :: forces
      real(dp), intent(inout) :: displacement
      real(dp) :: work

      associate (s => path%solid, duration => zone%duration)
         forces%dissipation = forces%dissipation - sum(elements**2*expm1_of(-2*duration/s%retardation)/(2*s%compliance))
         displacement = displacement + zone%load - sum(elements*s%retardation*expm1_of(-duration/s%retardation))
         if (zone%kind == in_adhesion) then
            work = -law%stress*(zone%last_height - zone%first_height)
            forces%friction = forces%friction + work
            forces%friction_scale = forces%friction_scale + abs(work)
            forces%adhesion = forces%adhesion + duration
         end if
      end associate
   end subroutine add_open_zone

   !> Count zones round the period: one that its end cuts counts once.
   pure subroutine count_zones(law, period, forces)
      type(stepping_law_t), intent(in) :: law
      type(stepped_period_t), intent(in) :: period
      type(stepping_forces_t), intent(inout) :: forces
      integer :: i

      ! the surface snaps off where the displacement jumps and nothing pulls any more
      do i = 2, period%n_zones
         if (law%jump > 0 .and. period%zones(i)%kind == in_free .and. period%zones(i - 1)%kind /= in_free) &
            & forces%n_snaps = forces%n_snaps + 1
      end do
      do i = 1, period%n_zones
         if (i == 1 .and. period%n_zones > 1) then
            if (period%zones(1)%kind == period%zones(period%n_zones)%kind) cycle
         end if
         select case (period%zones(i)%kind)
         case (in_contact)
            forces%n_contacts = forces%n_contacts + 1
         case (in_adhesion)
            forces%n_adhesions = forces%n_adhesions + 1
         case default
            forces%n_free = forces%n_free + 1
         end select
      end do
   end subroutine count_zones

   !> Middle and length of the contact, if there is one.
   pure subroutine find_single_contact(path, period, forces)
      type(column_path_t), intent(in) :: path
      type(stepped_period_t), intent(in) :: period
      !> The counts; receives middle and length.
      type(stepping_forces_t), intent(inout) :: forces
      real(dp) :: first, last
      integer :: i

      if (forces%n_contacts /= 1) return
      first = 2
      last = -1
      do i = 1, period%n_zones
         if (period%zones(i)%kind /= in_contact) cycle
         associate (zone => period%zones(i))
            if (i == period%n_zones .and. i > 1 .and. last >= 0) then
               ! it goes on where the period begins
               first = (zone%start%piece - 1 + zone%start%theta)*path%step - 1
            else
               first = min(first, (zone%start%piece - 1 + zone%start%theta)*path%step)
               last = first + zone%duration
            end if
         end associate
      end do
      forces%contact_middle = (first + last)/2
      forces%contact_length = last - first
   end subroutine find_single_contact

   !> Energy that edges of adhesion take.
   pure real(dp) function get_edge_loss(path, law, period) result(loss)
      type(column_path_t), intent(in) :: path
      type(stepping_law_t), intent(in) :: law
      type(stepped_period_t), intent(in) :: period
      real(dp) :: stretches(path%solid%n)
      integer :: i

      loss = 0
      do i = 1, period%n_zones - 1
         associate (here => period%zones(i), next => period%zones(i + 1), s => path%solid)
            if (next%is_snap) then
               ! what adhesion gives on the path, less what the glassy column takes
               loss = loss + law%stress*law%range - s%glassy*law%attach_gap**2/2
            else if (here%kind == in_free .and. next%kind == in_adhesion) then
               loss = loss + law%stress*law%range - law%stress*law%attach_gap + law%stress*law%jump/2
               stretches = product_of(s%stretches_of_elements, period%start(:, i + 1))
               loss = loss + law%shift*sum(s%stiffness*(2*stretches + law%shift))/2
            else if (here%kind == in_adhesion .and. next%kind == in_free) then
               loss = loss + law%stress*law%release_gap + law%stress*law%jump/2 - law%stress*law%range
               stretches = product_of(s%stretches_of_elements, period%start(:, i + 1))
               loss = loss + law%shift*sum(s%stiffness*(-2*stretches + law%shift))/2
            end if
         end associate
      end do
   end function get_edge_loss

end module adfric_foundation_stepping_forces

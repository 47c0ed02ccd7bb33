! SPDX-License-Identifier: GPL-3.0-or-later
!> Pressure, shear stress, displacement and gap along a row of a stepped surface.
module adfric_foundation_stepping_profiles
   use adfric_base_kinds, only: dp
   use adfric_foundation_stepping_law, only: stepping_law_t
   use adfric_foundation_stepping_attracted_zone, only: gap_trace_t, traced_gap
   use adfric_foundation_stepping_period, only: column_state_t, stepped_period_t, step_period, in_contact, in_adhesion, &
      & in_attraction
   use adfric_foundation_stepping_path, only: column_path_t, decay_of, height_at, steepness_at, stretches_at
   implicit none (type, external)
   private
   public :: get_stepping_profiles

contains

   !> Profiles at given positions, in the units of the time stepping; the shear stress in that of pressure times heights over the
   !> period.
   pure subroutine get_stepping_profiles(path, law, depth, state, period, start, positions, profiles)
      type(column_path_t), intent(in) :: path
      type(stepping_law_t), intent(in) :: law
      real(dp), intent(in) :: depth
      !> The state where the period begins.
      type(column_state_t), intent(in) :: state
      type(stepped_period_t), intent(in) :: period
      !> Where the path begins, x in periods.
      real(dp), intent(in) :: start
      !> Positions x in periods; shape `(n)`.
      real(dp), intent(in) :: positions(:)
      !> Receives pressure, shear stress, displacement and gap; shape `(n, 4)`.
      real(dp), intent(out) :: profiles(:, :)
      real(dp) :: passed, theta, pressure, displacement
      type(stepped_period_t) :: again
      type(gap_trace_t) :: trace
      integer :: i, piece, zone

      if (allocated(law%attraction)) then
         call step_period(path, law, depth, state, again, trace)
      end if
      do i = 1, size(positions)
         ! a column meets falling x
         passed = modulo(start - positions(i), 1.0_dp)*path%n
         piece = min(int(passed) + 1, path%n)
         theta = min(passed - (piece - 1), 1.0_dp)
         zone = find_zone(period, piece, theta)
         call get_state(path, law, depth, period, trace, zone, piece, theta, pressure, displacement)
         profiles(i, 1) = pressure
         profiles(i, 2) = pressure*steepness_at(path, piece, theta)*path%n
         profiles(i, 3) = displacement
         profiles(i, 4) = max(displacement - depth - height_at(path, piece, theta), 0.0_dp)
      end do
   end subroutine get_stepping_profiles

   !> The zone of a position.
   pure integer function find_zone(period, piece, theta) result(zone)
      type(stepped_period_t), intent(in) :: period
      integer, intent(in) :: piece
      !> Share of the piece that is passed.
      real(dp), intent(in) :: theta

      do zone = 1, period%n_zones - 1
         associate (finish => period%zones(zone)%finish)
            if (finish%piece > piece .or. (finish%piece == piece .and. finish%theta >= theta)) return
         end associate
      end do
      zone = period%n_zones
   end function find_zone

   !> Pressure and displacement at a position.
   pure subroutine get_state(path, law, depth, period, trace, zone, piece, theta, pressure, displacement)
      type(column_path_t), intent(in) :: path
      type(stepping_law_t), intent(in) :: law
      real(dp), intent(in) :: depth
      type(stepped_period_t), intent(in) :: period
      !> Gaps under another law than Dugdale's.
      type(gap_trace_t), intent(in) :: trace
      !> Number of the zone of the position.
      integer, intent(in) :: zone
      integer, intent(in) :: piece
      real(dp), intent(in) :: theta
      real(dp), intent(out) :: pressure, displacement
      real(dp), dimension(path%solid%n) :: stretch, growth
      real(dp) :: time, gap

      associate (here => period%zones(zone), s => path%solid)
         time = max(0.0_dp, (real(piece - here%start%piece, dp) + (theta - here%start%theta))*path%step)
         if (here%kind == in_contact) then
            call stretches_at(path, piece, theta, stretch, growth)
            stretch = stretch + period%start(:, zone)*decay_of(time/s%time)
            displacement = depth + height_at(path, piece, theta)
            pressure = displacement + sum(s%stiffness*stretch)
         else if (here%kind == in_attraction) then
            gap = traced_gap(trace, (piece - 1 + theta)*path%step)
            displacement = depth + height_at(path, piece, theta) + gap
            pressure = -law%attraction%law%tension(gap)
         else
            pressure = merge(-law%stress, 0.0_dp, here%kind == in_adhesion)
            displacement = pressure + sum(period%start(:, zone)*decay_of(time/s%retardation))
         end if
      end associate
   end subroutine get_state

end module adfric_foundation_stepping_profiles

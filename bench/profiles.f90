! SPDX-License-Identifier: GPL-3.0-or-later
!> A rough profile under a load: the time stepping with blocks and safe steps beside a plain time stepping of the same accuracy.
!>
!>     profiles [TABLE.csv]
!>
!> The plain time stepping visits every sample, goes round until the state repeats itself, and finds the penetration by regula
!> falsi. Both have the same tables of endless contact, whose preparation is timed apart. See bench/README.md.
program profiles
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_solid_prony, only: prony_t, new_prony
   use adfric_shape_height_line, only: height_line_t, new_sampled_line, cubic_pieces
   use adfric_foundation_adhesion, only: edge_instantaneous
   use adfric_foundation_stepping_equilibrium, only: stepping_surface_t, stepping_equilibrium_t, find_at_load, stepping_solved
   use adfric_foundation_stepping_forces, only: stepping_forces_t, get_stepping_forces
   use adfric_foundation_stepping_law, only: new_stepping_law
   use adfric_foundation_stepping_period, only: column_state_t, stepped_period_t, step_period
   use adfric_foundation_stepping_solid, only: solid_t, new_solid
   use adfric_foundation_stepping_path, only: new_path
   use measure, only: print_heading, text_argument, open_table
   implicit none (type, external)

   integer, parameter :: n_samples = 10000, n_waves = 1000, n_repeats = 20
   integer, parameter :: arms(*) = [1, 4, 10, 20]
   !> Load and penetration of the plain time stepping are known to this.
   real(dp), parameter :: tolerance = 1.0e-12_dp
   type(height_line_t) :: line
   integer :: table, k, which

   call print_heading('a rough profile of 10000 samples under a load')
   table = open_table(text_argument(1, 'profiles.csv'), 'arms,adhesion,prepare_ns,us,periods,plain_us,plain_periods,difference')
   print '(a5, a10, a18, a12, a9, a12, a9, a12)', 'arms', 'adhesion', 'prepare ns/sample', 'load us', 'periods', 'plain us', &
      & 'periods', 'friction'
   call make_line(line)
   do k = 1, size(arms)
      do which = 1, 3
         call report(table, arms(k), which)
      end do
   end do
   close (table)

contains

   !> A random line with a roll-off at ten waves, one high, from its highest position.
   subroutine make_line(line)
      type(height_line_t), intent(out) :: line
      real(dp) :: heights(n_samples), phases(n_waves), lowest, highest
      integer :: i, m, first

      call random_seed(put=[(17*i, i=1, 64)])
      call random_number(phases)
      heights = 0
      do m = 1, n_waves
         do i = 1, n_samples
            heights(i) = heights(i) + real(max(m, 10), dp)**(-1.3_dp) &
               & *cos(two_pi*(mod(i*m, n_samples)/real(n_samples, dp) + phases(m)))
         end do
      end do
      call new_sampled_line(line, heights/(maxval(heights) - minval(heights)), cubic_pieces)
      call line%get_extremes(lowest, highest, first)
      call line%rotate(first)
      line%coefficients(0, :) = line%coefficients(0, :) - highest
   end subroutine make_line

   !> One number of arms: without adhesion (1), and with it on the adhered (2) and the approach branch (3).
   subroutine report(table, n, which)
      integer, intent(in) :: table, n, which
      character(*), parameter :: names(3) = ['none    ', 'adhered ', 'approach']
      real(dp), parameter :: load = 0.02_dp
      type(prony_t) :: prony
      type(solid_t) :: solid
      type(stepping_surface_t) :: surface
      type(stepping_equilibrium_t) :: equilibrium
      real(dp) :: start, finish, prepare, seconds, plain_seconds, friction
      integer :: i, plain_periods

      call new_prony(prony, 1.0_dp, [(100.0_dp/n, i=1, n)], [(10.0_dp**(-5 + 6*(i - 0.5_dp)/n), i=1, n)])
      call new_solid(solid, prony, 1.0_dp)
      allocate (surface%rows(1))
      call cpu_time(start)
      do i = 1, n_repeats
         call new_path(surface%rows(1), line, solid)
      end do
      call cpu_time(finish)
      prepare = (finish - start)/(n_repeats*real(n_samples, dp))
      if (which > 1) call new_stepping_law(surface%law, 0.05_dp, 0.01_dp, edge_instantaneous, solid%glassy)
      surface%is_approach = which == 3
      call cpu_time(start)
      do i = 1, n_repeats
         call find_at_load(surface, load, equilibrium)
      end do
      call cpu_time(finish)
      seconds = (finish - start)/n_repeats
      if (equilibrium%status /= stepping_solved) error stop 'profiles: not solved'
      plain_seconds = 0
      plain_periods = 0
      friction = equilibrium%forces(1)%friction
      if (which < 3) then
         call cpu_time(start)
         call find_plainly(surface, load, friction, plain_periods)
         call cpu_time(finish)
         plain_seconds = finish - start
      end if
      friction = abs(friction/equilibrium%forces(1)%friction - 1)
      print '(i5, a10, f18.1, f12.1, i9, f12.1, i9, es12.1)', n, names(which), 1.0e9_dp*prepare, 1.0e6_dp*seconds, &
         & equilibrium%n_periods, 1.0e6_dp*plain_seconds, plain_periods, friction
      write (table, '(i0, ",", a, ",", 2(es9.2, ","), i0, ",", es9.2, ",", i0, ",", es9.2)') n, trim(names(which)), &
         & 1.0e9_dp*prepare, 1.0e6_dp*seconds, equilibrium%n_periods, 1.0e6_dp*plain_seconds, plain_periods, friction
   end subroutine report

   !> The same by a time stepping that visits every sample, plain iteration, and regula falsi (Illinois).
   subroutine find_plainly(surface, load, friction, n_periods)
      type(stepping_surface_t), intent(in) :: surface
      real(dp), intent(in) :: load
      real(dp), intent(out) :: friction
      integer, intent(out) :: n_periods
      type(stepping_surface_t) :: plain
      type(column_state_t) :: state
      type(stepped_period_t) :: period
      type(stepping_forces_t) :: forces
      real(dp) :: low, high, middle, at_low, at_high, excess
      integer :: k, side

      plain = surface
      associate (path => plain%rows(1))
         do k = 2, size(path%bounds)
            path%bounds(k)%pressure = -huge(1.0_dp)
            path%bounds(k)%lowest = -huge(1.0_dp)
            path%bounds(k)%highest = huge(1.0_dp)
         end do
         n_periods = 0
         high = load - path%mean
         low = 0
         call settle(plain, low, state, period, n_periods)
         at_low = period%load - load
         call settle(plain, high, state, period, n_periods)
         at_high = period%load - load
         side = 0
         do k = 1, 200
            middle = (low*at_high - high*at_low)/(at_high - at_low)
            call settle(plain, middle, state, period, n_periods)
            excess = period%load - load
            if (abs(excess) <= tolerance .or. high - low <= tolerance) exit
            if (excess > 0) then
               high = middle
               at_high = excess
               if (side > 0) at_low = at_low/2
               side = 1
            else
               low = middle
               at_low = excess
               if (side < 0) at_high = at_high/2
               side = -1
            end if
         end do
         call get_stepping_forces(path, plain%law, middle, period, forces)
      end associate
      friction = forces%friction
   end subroutine find_plainly

   !> Go round until the state repeats itself, from below.
   subroutine settle(surface, depth, state, period, n_periods)
      type(stepping_surface_t), intent(in) :: surface
      real(dp), intent(in) :: depth
      type(column_state_t), intent(inout) :: state
      type(stepped_period_t), intent(inout) :: period
      integer, intent(inout) :: n_periods
      integer :: k

      state%length = spread(-surface%law%stress - 1.0e-3_dp, 1, surface%rows(1)%solid%n)
      state%is_attached = .true.
      do k = 1, 1000000
         call step_period(surface%rows(1), surface%law, depth, state, period)
         n_periods = n_periods + 1
         if (maxval(abs(period%growth)) <= tolerance .and. (period%is_attached .eqv. state%is_attached)) return
         state%length = state%length + period%growth
         state%is_attached = period%is_attached
      end do
   end subroutine settle

end program profiles

! SPDX-License-Identifier: GPL-3.0-or-later
!> A paraboloid that is pressed, and drawn back, into a viscoelastic half-space in time: panels and time of a history against its
!> error, by approach and by load, for 1 to 20 relaxation times over four decades.
!>
!>     timed_contact [TABLE.csv]
!>
!> The error is that of the load, or of the approach where the load is given, at 1001 times against a run of the finest tolerance,
!> over the largest one. Beside it stand the estimate of the run and its time, without the sums of energy.
program timed_contact
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: unset
   use adfric_numerics_time_panels, only: get_weights, n_nodes
   use adfric_round_contact, only: branch_stable
   use adfric_round_indenter_states, only: find_indenter_states, indenter_states_t
   use adfric_round_timed_contact, only: advance, error_of, start_contact, timed_contact_t
   use adfric_round_timed_panel, only: timed_panel_t
   use adfric_round_timed_path, only: timed_control_t, timed_leg_t
   use adfric_round_variables, only: choose_none, kind_paraboloid, n_indenter_variables, in => indenter_input
   use adfric_solid_prony, only: new_prony, prony_t
   use adfric_system_clock, only: wall_clock
   use measure, only: print_heading, text_argument, open_table
   implicit none (type, external)

   integer, parameter :: n_times = 1001, arms(*) = [1, 3, 6, 20]
   real(dp), parameter :: tolerances(*) = [1.0e-4_dp, 1.0e-6_dp, 1.0e-7_dp, 1.0e-9_dp, 1.0e-11_dp], finest = 1.0e-12_dp
   character(*), parameter :: controls(2) = [character(8) :: 'approach', 'load']
   integer :: table, c, n, k
   real(dp) :: fine(n_times), found(n_times), seconds, estimate
   integer :: n_panels

   call print_heading('a paraboloid on a viscoelastic half-space in time')
   table = open_table(text_argument(1, 'timed_contact.csv'), 'control,arms,tolerance,panels,us,error,estimate')
   print '(a10, a6, a11, a8, a12, 2a11)', 'control', 'arms', 'tolerance', 'panels', 'us', 'error', 'estimate'
   do c = 1, size(controls)
      do n = 1, size(arms)
         call follow(controls(c), arms(n), finest, fine, n_panels, seconds, estimate)
         do k = 1, size(tolerances)
            call follow(controls(c), arms(n), tolerances(k), found, n_panels, seconds, estimate)
            print '(a10, i6, es11.1, i8, f12.1, 2es11.1)', controls(c), arms(n), tolerances(k), n_panels, seconds*1.0e6_dp, &
               & maxval(abs(found - fine))/maxval(fine), estimate
            write (table, '(a, '','', i0, '','', es8.1, '','', i0, '','', es12.5, '','', es10.3, '','', es10.3)') &
               & trim(controls(c)), arms(n), tolerances(k), n_panels, seconds*1.0e6_dp, &
               & maxval(abs(found - fine))/maxval(fine), estimate
         end do
      end do
   end do
   close (table)

contains

   !> Go through a triangle; the shortest time of several runs.
   subroutine follow(control, n_arms, tolerance, values, n_panels, seconds, estimate)
      character(*), intent(in) :: control
      integer, intent(in) :: n_arms
      real(dp), intent(in) :: tolerance
      real(dp), intent(out) :: values(n_times)
      integer, intent(out) :: n_panels
      real(dp), intent(out) :: seconds, estimate
      integer, parameter :: n_runs = 5
      type(timed_contact_t) :: contact
      type(timed_panel_t) :: panel
      type(indenter_states_t) :: states
      type(timed_control_t) :: prescribed
      type(timed_leg_t) :: legs(2)
      type(prony_t) :: solid
      real(dp) :: body(n_indenter_variables), begin, weights(n_nodes), s
      integer :: run, i, first
      logical :: is_fine

      body = unset
      body([in%theory, in%branch, in%profiles, in%n_r, in%contact_modulus]) = [choose_none, branch_stable, 0, 2, 1]
      body([in%kind, in%radius, in%approach]) = [real(kind_paraboloid, dp), 1.0_dp, 1.0_dp]
      call find_indenter_states(body, states, is_fine)
      call new_prony(solid, 1.0_dp, [(9.0_dp/n_arms, i=1, n_arms)], [(10**(4*(i - 0.5_dp)/n_arms - 2), i=1, n_arms)])
      if (control == 'load') prescribed = timed_control_t(0.0_dp, 1.0_dp)
      legs(1) = timed_leg_t(span=1.0_dp, end=1.0_dp)
      legs(2) = timed_leg_t(clock=1.0_dp, span=1.0_dp, begin=1.0_dp, end=0.1_dp)
      seconds = huge(1.0_dp)
      do run = 1, n_runs
         begin = wall_clock()
         call start_contact(contact, solid, states, prescribed, legs, tolerance, is_fine)
         first = 1
         do while (.not. contact%is_done)
            call advance(contact, panel, is_fine)
            if (.not. is_fine) error stop 'timed_contact: a panel was not found'
            do i = first, n_times
               s = 2*(2.0_dp*(i - 1)/(n_times - 1) - panel%clock)/panel%span - 1
               if (s > 1 + 1.0e-9_dp) exit
               call get_weights(min(1.0_dp, s), weights)
               values(i) = dot_product(weights, merge(panel%approach, panel%load, control == 'load'))
            end do
            first = i
         end do
         seconds = min(seconds, wall_clock() - begin)
      end do
      n_panels = contact%n_panels
      estimate = error_of(contact)
   end subroutine follow

end program timed_contact

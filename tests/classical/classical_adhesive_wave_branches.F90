! SPDX-License-Identifier: GPL-3.0-or-later
! Which state a load or a penetration has: a grid that knows of no formula, folds counted along the curve, energies, loops.
module classical_adhesive_wave_branches
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_classical_adhesive_wave, only: zones_t, load_slope, penetration_slope
   use adfric_classical_adhesive_wave_curve, only: adhesive_wave_t, find_contact, get_curve_state, is_open
   use adfric_classical_adhesive_wave_events, only: new_adhesive_wave
   use adfric_classical_adhesive_wave_jumps, only: wave_jumps_t, get_jumps
   use adfric_classical_adhesive_wave_load, only: state_of_load, branch_approach, branch_adhered
   use adfric_classical_adhesive_wave_penetration, only: state_of_penetration
   use adfric_classical_adhesive_wave_state, only: wave_adhesion_t, dissipated_energy, regime_none, regime_no_contact, &
      & regime_zones, regime_saturated
   use brute_adhesion, only: brute_wave_t, new_brute_wave, solve_branch
   use funit
   implicit none (type, external)

   integer, parameter :: longest_label = 100

contains

   !> Numbers from 0 to 1, the same in every run.
   pure real(dp) function weyl(i, k)
      integer, intent(in) :: i, k
      real(dp), parameter :: steps(3) = [0.6180339887498949_dp, 0.4142135623730951_dp, 0.7320508075688772_dp]

      weyl = modulo(i*steps(k), 1.0_dp)
   end function weyl

   ! Folds of both kinds along a dense curve: two and none others, for stresses over ten decades and ranges around 2 as well.
   !@test
   subroutine test_fold_counts()
      type(adhesive_wave_t) :: wave
      type(zones_t) :: zones
      character(longest_label) :: label
      real(dp) :: stress, range, x, slopes(2), old(2)
      logical :: is_converged
      integer :: i, j, counts(2)

      do i = 1, 200
         stress = 10**(10*weyl(i, 1) - 5)
         range = 10**(5*weyl(i, 2) - 4)
         if (mod(i, 3) == 0) range = 1.9_dp + 0.4_dp*weyl(i, 2)
         write (label, '(2g22.14)') stress, range
         call new_adhesive_wave(wave, stress, range, is_converged)
#line 46 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertTrue(is_converged, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 46) )
  if (anyExceptions()) return
#line 47 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
         counts = 0
         old = -1
         zones%y = 0
         do j = 1, 500
            x = -25 + 0.1_dp*(j - 0.5_dp)
            if (is_open(wave, x)) then
               slopes = [-1.0_dp, 1/cosh(x) + wave%sigma*log(2/cosh(x))]
            else
               call find_contact(wave, x, zones, is_converged)
#line 56 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertTrue(is_converged, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 56) )
  if (anyExceptions()) return
#line 57 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
               slopes = [load_slope(wave%sigma, zones), penetration_slope(wave%sigma, zones)]
            end if
            where (slopes*old < 0) counts = counts + 1
            old = slopes
         end do
#line 62 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertEqual(2, counts(2), message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 62) )
  if (anyExceptions()) return
#line 63 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
         ! folds closer than the samples are not counted
         if (wave%has_folds) then
            if (wave%largest%place - wave%least%place < 0.2_dp) cycle
         end if
#line 67 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertEqual(merge(2, 0, wave%has_folds), counts(1), message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 67) )
  if (anyExceptions()) return
#line 68 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
      end do
   end subroutine test_fold_counts

   ! Under loads: the grid's least and greatest states, and those after a turn.
   !@test
   subroutine test_grid()
      integer, parameter :: n = 96
      type(brute_wave_t) :: grid
      type(adhesive_wave_t) :: wave
      real(dp) :: cases(2, 4), load
      logical :: is_converged
      integer :: i, k

      cases = reshape([0.3_dp, 0.3_dp, 0.6414085_dp, 0.3_dp, 0.2_dp, 1.0_dp, 0.4_dp, 2.1_dp], [2, 4])
      call new_brute_wave(grid, n)
      do i = 1, 4
         call new_adhesive_wave(wave, cases(1, i), cases(2, i), is_converged)
         do k = -8, 14
            load = 0.05_dp*k + 0.013_dp
            ! the edge of a grid is pinned, so jumps of the grid come at other loads
            if (wave%has_folds) then
               if (abs(load - wave%least_load) < 0.03_dp .or. abs(load - wave%largest_load) < 0.03_dp) cycle
            end if
            if (abs(load - wave%saturation_load) < 0.03_dp) cycle
            call check_grid(grid, wave, load)
         end do
      end do
   end subroutine test_grid

   !> Compare the states of a load.
   subroutine check_grid(grid, wave, load)
      type(brute_wave_t), intent(in) :: grid
      type(adhesive_wave_t), intent(in) :: wave
      real(dp), intent(in) :: load
      type(wave_adhesion_t) :: state
      character(longest_label) :: label
      logical :: labels(grid%n), has_state, is_converged
      real(dp) :: gap(grid%n), pressure(grid%n)
      integer :: branch
      real(dp), parameter :: pinning = 0.04_dp

      do branch = branch_approach, branch_adhered
         write (label, '(3g16.8, i2)') wave%stress, wave%range, load, branch
         labels = branch == branch_adhered
         has_state = load >= 0 .or. branch == branch_adhered
         if (load >= 0) labels(1) = .true.
         if (has_state) call solve_branch(grid, wave%stress, wave%range, load, labels, gap, pressure, has_state)
         call state_of_load(wave, load, branch, state, is_converged)
#line 116 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertTrue(is_converged, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 116) )
  if (anyExceptions()) return
#line 117 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
#line 117 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertTrue(has_state .eqv. state%regime /= regime_none, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 117) )
  if (anyExceptions()) return
#line 118 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
         if (.not. has_state) cycle
#line 119 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertEqual(1 - sum(gap)/grid%n, state%penetration, tolerance=pinning, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 119) )
  if (anyExceptions()) return
#line 120 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
#line 120 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertEqual(real(count(labels), dp)/(2*grid%n), state%cohesive_half_width, tolerance=pinning, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 120) )
  if (anyExceptions()) return
#line 121 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
      end do
   end subroutine check_grid

   ! After a turn at a load: partial contact stays partial, saturation stays saturated.
   !@test
   subroutine test_turn()
      type(adhesive_wave_t) :: wave
      type(wave_adhesion_t) :: state, other
      type(brute_wave_t) :: grid
      logical :: is_converged, has_state
      logical :: labels(96)
      real(dp) :: gap(96), pressure(96)

      ! the largest load is 0.297, saturation ends at 0.0079, the least load is -0.115
      call new_adhesive_wave(wave, pi*0.35_dp**2/0.6_dp, 0.3_dp, is_converged)
      call state_of_load(wave, 0.15_dp, branch_adhered, state, is_converged)
#line 137 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertTrue(state%regime == regime_saturated, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 137) )
  if (anyExceptions()) return
#line 138 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
      call state_of_load(wave, 0.15_dp, branch_adhered, state, is_converged, turning_load=0.25_dp)
#line 139 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertTrue(state%regime == regime_zones, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 139) )
  if (anyExceptions()) return
#line 140 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
      call state_of_load(wave, 0.15_dp, branch_adhered, other, is_converged, turning_load=0.3_dp)
#line 141 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertTrue(other%regime == regime_saturated, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 141) )
  if (anyExceptions()) return
#line 142 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
      call new_brute_wave(grid, 96)
      labels = .false.
      labels(1) = .true.
      call solve_branch(grid, wave%stress, wave%range, 0.25_dp, labels, gap, pressure, has_state)
      call solve_branch(grid, wave%stress, wave%range, 0.15_dp, labels, gap, pressure, has_state)
#line 147 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertEqual(1 - sum(gap)/96, state%penetration, tolerance=0.04_dp, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 147) )
  if (anyExceptions()) return
#line 148 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
      call state_of_load(wave, -0.12_dp, branch_adhered, state, is_converged, turning_load=0.25_dp)
#line 149 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertTrue(state%regime == regime_none, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 149) )
  if (anyExceptions()) return
#line 150 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
      call state_of_load(wave, -0.1_dp, branch_adhered, state, is_converged, turning_load=0.25_dp)
#line 151 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertTrue(state%regime == regime_zones, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 151) )
  if (anyExceptions()) return
#line 152 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
      call state_of_penetration(wave, 0.94_dp, branch_adhered, state, is_converged)
#line 153 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertTrue(state%regime == regime_saturated, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 153) )
  if (anyExceptions()) return
#line 154 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
      call state_of_penetration(wave, 0.94_dp, branch_adhered, state, is_converged, turning_load=0.25_dp)
#line 155 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertTrue(state%regime == regime_zones, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 155) )
  if (anyExceptions()) return
#line 156 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
   end subroutine test_turn

   ! approach <= adhered in every respect, both rise with the load, and loads and penetrations are inverse to each other.
   !@test
   subroutine test_order()
      type(adhesive_wave_t) :: wave
      type(wave_adhesion_t) :: low, high, again
      character(longest_label) :: label
      real(dp) :: load, old(2)
      logical :: is_converged(3)
      integer :: i, k
      real(dp), parameter :: slack = 1.0e-12_dp

      do i = 1, 500
         call new_adhesive_wave(wave, 10**(6*weyl(i, 1) - 4), 10**(5*weyl(i, 2) - 3), is_converged(1))
         write (label, '(2g22.14)') wave%stress, wave%range
#line 172 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertTrue(is_converged(1), message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 172) )
  if (anyExceptions()) return
#line 173 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
         old = -huge(load)
         do k = 0, 10
            load = 0.1_dp*(k + weyl(i, 3))
            call state_of_load(wave, load, branch_approach, low, is_converged(1))
            call state_of_load(wave, load, branch_adhered, high, is_converged(2))
#line 178 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertTrue(all(is_converged(:2)), message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 178) )
  if (anyExceptions()) return
#line 179 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
#line 179 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertTrue(low%regime /= regime_none .and. high%regime /= regime_none, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 179) )
  if (anyExceptions()) return
#line 180 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
#line 180 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertTrue(low%contact_half_width <= high%contact_half_width + slack, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 180) )
  if (anyExceptions()) return
#line 181 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
#line 181 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertTrue(low%cohesive_half_width <= high%cohesive_half_width + slack, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 181) )
  if (anyExceptions()) return
#line 182 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
#line 182 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertTrue(low%penetration <= high%penetration + slack, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 182) )
  if (anyExceptions()) return
#line 183 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
#line 183 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertTrue(low%penetration >= old(1) - slack .and. high%penetration >= old(2) - slack, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 183) )
  if (anyExceptions()) return
#line 184 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
            old = [low%penetration, high%penetration]
            if (low%regime /= regime_zones) cycle
            call state_of_penetration(wave, low%penetration, branch_approach, again, is_converged(3))
#line 187 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertTrue(is_converged(3), message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 187) )
  if (anyExceptions()) return
#line 188 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
#line 188 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertEqual(load, again%mean_pressure, tolerance=1.0e-8_dp*(1 + wave%stress), message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 188) )
  if (anyExceptions()) return
#line 189 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
         end do
      end do
   end subroutine test_order

   ! dE = P d delta along the branches, by Simpson's rule, away from jumps.
   !@test
   subroutine test_energy_along()
      type(adhesive_wave_t) :: wave
      type(wave_adhesion_t) :: states(3)
      character(longest_label) :: label
      real(dp) :: delta, work
      logical :: is_converged
      integer :: i, k, branch
      real(dp), parameter :: h = 1.0e-3_dp

      do i = 1, 300
         call new_adhesive_wave(wave, 10**(4*weyl(i, 1) - 3), 10**(4*weyl(i, 2) - 3), is_converged)
         do branch = branch_approach, branch_adhered
            delta = (1 + 2*h)*weyl(i, 3) - wave%range*(1 - weyl(i, 3)) - 2*h
            if (abs(delta - wave%least_penetration) < 0.02_dp .or. abs(delta - wave%largest_penetration) < 0.02_dp) cycle
            if (abs(delta - wave%saturation_penetration) < 0.02_dp .or. abs(delta) < 0.02_dp .or. delta > 0.98_dp) cycle
            if (abs(delta + wave%range) < 0.02_dp) cycle
            do k = 1, 3
               call state_of_penetration(wave, delta + (k - 2)*h, branch, states(k), is_converged)
#line 213 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 213) )
  if (anyExceptions()) return
#line 214 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
            end do
            write (label, '(3g22.14, i2)') wave%stress, wave%range, delta, branch
            work = h/3*(states(1)%mean_pressure + 4*states(2)%mean_pressure + states(3)%mean_pressure)
#line 217 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertEqual(work, dissipated_energy(states(3), states(1)), tolerance=1.0e-7_dp*(1 + wave%stress), message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 217) )
  if (anyExceptions()) return
#line 218 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
         end do
      end do
   end subroutine test_energy_along

   ! The closed loop of the penetration: its work is the sum of what the jumps lose.
   !@test
   subroutine test_closed_loop()
      real(dp), parameter :: stresses(4) = [0.3_dp, 0.64_dp, 1.5_dp, 0.05_dp], ranges(4) = [0.3_dp, 0.3_dp, 0.6_dp, 2.5_dp]
      type(adhesive_wave_t) :: wave
      type(wave_jumps_t) :: jumps
      real(dp) :: work, lost, edges(5)
      logical :: is_converged
      integer :: i

      do i = 1, 4
         call new_adhesive_wave(wave, stresses(i), ranges(i), is_converged)
         edges = [-wave%range, 0.0_dp, wave%largest_penetration, 1.0_dp, 1.0_dp]
         if (wave%largest_penetration < 0) edges(2:3) = edges(3:2:-1)
         work = work_along(wave, branch_approach, edges)
         lost = loss_at(wave, -wave%range, branch_approach) + loss_at(wave, wave%largest_penetration, branch_approach)
         edges = [wave%least_penetration, min(wave%saturation_penetration, 0.0_dp), max(wave%saturation_penetration, 0.0_dp), &
            & 1.0_dp, 1.0_dp]
         if (wave%saturation_penetration < 0) edges(3) = 0
         work = work - work_along(wave, branch_adhered, edges)
         lost = lost - loss_at(wave, wave%saturation_penetration, branch_adhered) &
            & - loss_at(wave, wave%least_penetration, branch_adhered)
#line 244 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertTrue(lost > 0, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 244) )
  if (anyExceptions()) return
#line 245 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
         call get_jumps(wave, jumps, is_converged)
#line 246 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 246) )
  if (anyExceptions()) return
#line 247 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
#line 247 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertEqual(lost, jumps%total, tolerance=1.0e-11_dp, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 247) )
  if (anyExceptions()) return
#line 248 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
#line 248 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertEqual(lost, work, tolerance=1.0e-6_dp*lost + 1.0e-10_dp, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 248) )
  if (anyExceptions()) return
#line 249 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
      end do
   end subroutine test_closed_loop

   ! Around first contact, where x does not tell the contacts apart, load and area go on without a step.
   !@test
   subroutine test_first_contact()
      type(adhesive_wave_t) :: wave
      type(zones_t) :: zones
      type(wave_adhesion_t) :: state
      character(longest_label) :: label
      real(dp) :: load, penetration, gap, step
      logical :: is_converged
      integer :: k

      call new_adhesive_wave(wave, 0.3_dp, 0.3_dp, is_converged)
      call find_contact(wave, wave%first_place, zones, is_converged)
      call get_curve_state(wave, zones, load, penetration, gap)
      do k = 2, 15
         step = 0.1_dp**k
         write (label, '(i4)') k
         call state_of_penetration(wave, penetration + step, branch_approach, state, is_converged)
#line 270 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertTrue(is_converged .and. state%regime == regime_zones, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 270) )
  if (anyExceptions()) return
#line 271 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
#line 271 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertEqual(load, state%mean_pressure, tolerance=step + 1.0e-14_dp, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 271) )
  if (anyExceptions()) return
#line 272 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
#line 272 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertTrue(state%contact_half_width**2 < step, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 272) )
  if (anyExceptions()) return
#line 273 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
         call state_of_penetration(wave, penetration - step, branch_approach, state, is_converged)
#line 274 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertTrue(is_converged .and. state%regime == regime_no_contact, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 274) )
  if (anyExceptions()) return
#line 275 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
#line 275 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertEqual(load, state%mean_pressure, tolerance=step + 1.0e-14_dp, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 275) )
  if (anyExceptions()) return
#line 276 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
      end do
   end subroutine test_first_contact

   ! No jump gains energy, for stresses over six decades and ranges over five.
   !@test
   subroutine test_jumps_lose()
      type(adhesive_wave_t) :: wave
      type(wave_jumps_t) :: jumps
      character(longest_label) :: label
      logical :: is_converged
      real(dp) :: slack
      integer :: i

      do i = 1, 500
         call new_adhesive_wave(wave, 10**(6*weyl(i, 1) - 4), 10**(5*weyl(i, 2) - 3), is_converged)
         write (label, '(2g22.14)') wave%stress, wave%range
         call get_jumps(wave, jumps, is_converged)
#line 293 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertTrue(is_converged, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 293) )
  if (anyExceptions()) return
#line 294 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
         slack = 1.0e-13_dp*(1 + wave%stress)*(1 + wave%range)
#line 295 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
  call assertTrue(min(jumps%jump_in, jumps%saturation, jumps%desaturation, jumps%pull_off) >= -slack, message=label, &
 & location=SourceLocation( &
 & 'classical_adhesive_wave_branches.pf', &
 & 295) )
  if (anyExceptions()) return
#line 296 "/work/main/tests/classical/classical_adhesive_wave_branches.pf"
      end do
   end subroutine test_jumps_lose

   !> The integral of P over the penetration between edges, where P may have a vertical slope or a jump.
   real(dp) function work_along(wave, branch, edges)
      type(adhesive_wave_t), intent(in) :: wave
      integer, intent(in) :: branch
      real(dp), intent(in) :: edges(5)
      integer, parameter :: n = 4000
      type(wave_adhesion_t) :: state
      real(dp) :: v
      logical :: is_converged
      integer :: i, k

      work_along = 0
      do k = 1, 4
         do i = 1, n
            ! delta = edge + width (3 v^2 - 2 v^3) by the midpoint rule
            v = (i - 0.5_dp)/n
            call state_of_penetration(wave, edges(k) + (edges(k + 1) - edges(k))*v**2*(3 - 2*v), branch, state, is_converged)
            work_along = work_along + state%mean_pressure*(edges(k + 1) - edges(k))*6*v*(1 - v)/n
         end do
      end do
   end function work_along

   !> What the state just below a penetration has more energy than the one just above.
   real(dp) function loss_at(wave, penetration, branch)
      type(adhesive_wave_t), intent(in) :: wave
      real(dp), intent(in) :: penetration
      integer, intent(in) :: branch
      type(wave_adhesion_t) :: below, above
      logical :: is_converged
      real(dp), parameter :: h = 1.0e-13_dp

      call state_of_penetration(wave, penetration - h, branch, below, is_converged)
      call state_of_penetration(wave, penetration + h, branch, above, is_converged)
      loss_at = dissipated_energy(below, above)
   end function loss_at

end module classical_adhesive_wave_branches

module Wrapclassical_adhesive_wave_branches
   use FUnit
   use classical_adhesive_wave_branches
   implicit none
   private

contains


end module Wrapclassical_adhesive_wave_branches

function classical_adhesive_wave_branches_suite() result(suite)
   use FUnit
   use classical_adhesive_wave_branches
   use Wrapclassical_adhesive_wave_branches
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('classical_adhesive_wave_branches_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_fold_counts', &
      test_fold_counts))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_grid', &
      test_grid))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_turn', &
      test_turn))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_order', &
      test_order))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_energy_along', &
      test_energy_along))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_closed_loop', &
      test_closed_loop))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_first_contact', &
      test_first_contact))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_jumps_lose', &
      test_jumps_lose))
   call suite%addTest(t)


end function classical_adhesive_wave_branches_suite


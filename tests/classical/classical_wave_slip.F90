! SPDX-License-Identifier: GPL-3.0-or-later
! Partial slip of `wave_1d`: the table, limits, derivative, energy and force from the profiles, full contact, other units, and what
! is refused.
module classical_wave_slip
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_classical_wave_slip, only: find_wave_slip, wave_shear, wave_slip_t
   use adfric_classical_westergaard, only: wave_gap, wave_half_width, wave_penetration, wave_pressure
   use adfric_model_status, only: status_solved, status_no_equilibrium
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   use reference_table, only: table_t, read_table
   use trial_case, only: trial_case_t, new_case
   use funit
   implicit none (type, external)

   real(dp), parameter :: closed_form = 100*epsilon(1.0_dp), along_y = 2
   !> Wavelength and amplitude [m], Young's modulus [Pa], Poisson's ratio, a coefficient of friction.
   real(dp), parameter :: period = 2.0e-3_dp, amplitude = 3.0e-6_dp, young = 7.0e10_dp, nu = 0.3_dp, mu = 0.25_dp

contains

   !> Pressure of full contact [Pa].
   pure real(dp) function full()
      full = pi*young/(1 - nu**2)*amplitude/period
   end function full

   !> A wave under q p* and a share of mu q p*.
   subroutine new_wave(case, q, tau)
      type(trial_case_t), intent(out) :: case
      real(dp), intent(in) :: q, tau

      call new_case(case, 'wave_1d')
      call case%give('period', period)
      call case%give('amplitude', amplitude)
      case%values(case%model%index_of('solid', 'young_modulus')) = young
      case%values(case%model%index_of('solid', 'poisson_ratio')) = nu
      call case%give('mean_pressure', q*full())
      call case%give('coefficient', mu)
      call case%give('tangential_stress', tau*mu*q*full())
   end subroutine new_wave

   !@test
   subroutine test_table()
      type(table_t) :: table
      type(wave_slip_t) :: slip
      type(trial_case_t) :: case
      real(dp) :: fair
      integer :: i

      call read_table(table, 'slip_wave_1d')
#line 52 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertEqual(13, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 52) )
  if (anyExceptions()) return
#line 53 "/work/main/tests/classical/classical_wave_slip.pf"
      do i = 1, table%n_rows
         associate (q => table%number(i, 'q'), tau => table%number(i, 'tau'))
            ! 1 - tau is rounded
            fair = closed_form + 2*epsilon(tau)/max(1 - tau, epsilon(tau))
            call find_wave_slip(q, tau, slip)
#line 58 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertRelativelyEqual(table%number(i, 'u'), slip%displacement, tolerance=closed_form, message=table%label(i), &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 58) )
  if (anyExceptions()) return
#line 59 "/work/main/tests/classical/classical_wave_slip.pf"
#line 59 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertRelativelyEqual(table%number(i, 'W'), slip%energy, tolerance=closed_form, message=table%label(i), &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 59) )
  if (anyExceptions()) return
#line 60 "/work/main/tests/classical/classical_wave_slip.pf"
#line 60 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertEqual(table%number(i, 'two_c_over_l'), 2*wave_half_width(slip%stick_pressure), tolerance=fair, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 60) )
  if (anyExceptions()) return
#line 61 "/work/main/tests/classical/classical_wave_slip.pf"
            call new_wave(case, q, tau)
#line 62 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 62) )
  if (anyExceptions()) return
#line 63 "/work/main/tests/classical/classical_wave_slip.pf"
            call case%solve()
#line 64 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 64) )
  if (anyExceptions()) return
#line 65 "/work/main/tests/classical/classical_wave_slip.pf"
#line 65 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertRelativelyEqual(table%number(i, 'u')*mu*amplitude, case%found('tangential_displacement'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 65) )
  if (anyExceptions()) return
#line 66 "/work/main/tests/classical/classical_wave_slip.pf"
#line 66 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertRelativelyEqual(table%number(i, 'W')*mu**2*full()*amplitude, case%found('cycle_energy'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 66) )
  if (anyExceptions()) return
#line 67 "/work/main/tests/classical/classical_wave_slip.pf"
            associate (stick => case%found('stick_fraction')*case%found('contact_fraction'))
#line 68 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertEqual(table%number(i, 'two_c_over_l'), stick, tolerance=fair, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 68) )
  if (anyExceptions()) return
#line 69 "/work/main/tests/classical/classical_wave_slip.pf"
            end associate
         end associate
      end do
   end subroutine test_table

   ! With x = -ln(1 - tau) no digit is lost where tau is small or next to 1, up to and beyond full contact.
   !@test
   subroutine test_ends()
      real(dp), parameter :: pressures(4) = [1.0e-9_dp, 0.3_dp, 0.999_dp, 1.0_dp]
      type(wave_slip_t) :: slip
      real(dp) :: tau
      integer :: i, k

      do i = 1, size(pressures)
         associate (q => pressures(i))
            do k = 4, 12
               tau = 10.0_dp**(-k)
               call find_wave_slip(q, tau, slip)
               ! W = (2/3) q^2 tau^3 (1 + tau/2 + ...)
#line 88 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertRelativelyEqual(q*tau*(-log(q) + tau/2 + tau**2/6 + tau**3/12), slip%displacement, tolerance=1.0e-11_dp, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 88) )
  if (anyExceptions()) return
#line 89 "/work/main/tests/classical/classical_wave_slip.pf"
#line 89 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertRelativelyEqual(q**2*tau**3*(2 + tau)/3, slip%energy, tolerance=1.0e-7_dp, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 89) )
  if (anyExceptions()) return
#line 90 "/work/main/tests/classical/classical_wave_slip.pf"
               call find_wave_slip(q, 1 - tau, slip)
#line 91 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertRelativelyEqual(wave_penetration(q) - wave_penetration(q*tau), slip%displacement, tolerance=1.0e-13_dp, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 91) )
  if (anyExceptions()) return
#line 92 "/work/main/tests/classical/classical_wave_slip.pf"
            end do
            call find_wave_slip(q, 1.0_dp, slip)
#line 94 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertRelativelyEqual(wave_penetration(q), slip%displacement, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 94) )
  if (anyExceptions()) return
#line 95 "/work/main/tests/classical/classical_wave_slip.pf"
#line 95 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertRelativelyEqual(2*q**2, slip%energy, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 95) )
  if (anyExceptions()) return
#line 96 "/work/main/tests/classical/classical_wave_slip.pf"
#line 96 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertEqual(0.0_dp, slip%stick, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 96) )
  if (anyExceptions()) return
#line 97 "/work/main/tests/classical/classical_wave_slip.pf"
         end associate
      end do
   end subroutine test_ends

   ! The energy is that of pressure and gap, the force that of the tractions, the stiffness the slope of the force.
   !@test
   subroutine test_balances()
      real(dp), parameter :: pressures(5) = [0.02_dp, 0.5_dp, 0.97_dp, 1.0_dp, 1.3_dp]
      real(dp), parameter :: shares(4) = [0.05_dp, 0.3_dp, 0.8_dp, 0.999_dp]
      real(dp), parameter :: step = 1.0e-4_dp
      type(wave_slip_t) :: slip, before, after
      integer :: i, k

      do i = 1, size(pressures)
         do k = 1, size(shares)
            associate (q => pressures(i), tau => shares(k))
               call find_wave_slip(q, tau, slip)
#line 114 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertRelativelyEqual(q*tau, mean_of(q, tau, .true.), tolerance=1.0e-9_dp, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 114) )
  if (anyExceptions()) return
#line 115 "/work/main/tests/classical/classical_wave_slip.pf"
               if (.not. slip%stick < 1) cycle
#line 116 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertRelativelyEqual(slip%energy, 4*mean_of(q, tau, .false.), tolerance=1.0e-6_dp, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 116) )
  if (anyExceptions()) return
#line 117 "/work/main/tests/classical/classical_wave_slip.pf"
               call find_wave_slip(q, tau*(1 - step), before)
               call find_wave_slip(q, min(tau*(1 + step), 1.0_dp), after)
               associate (slope => (after%displacement - before%displacement)/(q*(min(tau*(1 + step), 1.0_dp) - tau*(1 - step))))
#line 120 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertRelativelyEqual(slope, slip%compliance, tolerance=1.0e-2_dp/(1 - tau)*step + 1.0e-7_dp, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 120) )
  if (anyExceptions()) return
#line 121 "/work/main/tests/classical/classical_wave_slip.pf"
               end associate
            end associate
         end do
      end do
   end subroutine test_balances

   !> Mean over a wave of the tractions, or of pressure times gap of what sticks, between the edges of both contacts.
   real(dp) function mean_of(q, tau, of_traction) result(mean)
      real(dp), intent(in) :: q, tau
      logical, intent(in) :: of_traction
      integer, parameter :: n_panels = 40
      real(dp) :: ends(4), x, half, width, t
      integer :: part, panel, node

      ends = [0.0_dp, wave_half_width(q*(1 - tau)), wave_half_width(q), 0.5_dp]
      mean = 0
      do part = 1, 3
         width = (ends(part + 1) - ends(part))/2
         do panel = 1, n_panels
            do node = 1, size(gauss_nodes)
               ! places are dense at both ends
               half = pi/(2*n_panels)
               t = half*(2*panel - 1 + gauss_nodes(node))
               x = ends(part) + width*(1 - cos(t))
               associate (weight => 2*gauss_weights(node)*half*width*sin(t))
                  if (of_traction) then
                     mean = mean + weight*wave_shear(q, tau, x)
                  else
                     mean = mean + weight*wave_pressure(q, x)*wave_gap(q*(1 - tau), x)
                  end if
               end associate
            end do
         end do
      end do
   end function mean_of

   ! What is pressed more than full contact needs sticks as a whole, and gives way by nothing.
   !@test
   subroutine test_full_contact()
      type(trial_case_t) :: case
      type(wave_slip_t) :: slip

      call new_wave(case, 1.5_dp, 0.3_dp)
      call case%solve()
#line 165 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 165) )
  if (anyExceptions()) return
#line 166 "/work/main/tests/classical/classical_wave_slip.pf"
#line 166 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertEqual(1.0_dp, case%found('stick_fraction'), &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 166) )
  if (anyExceptions()) return
#line 167 "/work/main/tests/classical/classical_wave_slip.pf"
#line 167 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertEqual(0.0_dp, case%found('tangential_displacement'), &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 167) )
  if (anyExceptions()) return
#line 168 "/work/main/tests/classical/classical_wave_slip.pf"
#line 168 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertEqual(0.0_dp, case%found('cycle_energy'), &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 168) )
  if (anyExceptions()) return
#line 169 "/work/main/tests/classical/classical_wave_slip.pf"
#line 169 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertTrue(ieee_is_nan(case%found('tangential_stiffness')), &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 169) )
  if (anyExceptions()) return
#line 170 "/work/main/tests/classical/classical_wave_slip.pf"
      ! from the pressure of full contact down
      call find_wave_slip(1.5_dp, 0.8_dp, slip)
#line 172 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertRelativelyEqual(wave_penetration(1.0_dp) - wave_penetration(0.3_dp), slip%displacement, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 172) )
  if (anyExceptions()) return
#line 173 "/work/main/tests/classical/classical_wave_slip.pf"
   end subroutine test_full_contact

   ! Under a light load each crest is a cylinder of radius l^2/(4 pi^2 D).
   !@test
   subroutine test_hertz()
      real(dp), parameter :: q = 1.0e-7_dp
      type(trial_case_t) :: wave, line
      integer :: k

      do k = 1, 9, 2
         call new_wave(wave, q, 0.1_dp*k)
         call wave%solve()
         call new_case(line, 'hertz')
         call line%give('kind', 1.0_dp)
         call line%give('radius', period**2/(4*pi**2*amplitude))
         line%values(line%model%index_of('solid', 'young_modulus')) = young
         line%values(line%model%index_of('solid', 'poisson_ratio')) = nu
         call line%give('load', q*full()*period)
         call line%give('coefficient', mu)
         call line%give('tangential_force', 0.1_dp*k*mu*q*full()*period)
         call line%solve()
#line 194 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertRelativelyEqual(line%found('stick_fraction'), wave%found('stick_fraction'), tolerance=q, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 194) )
  if (anyExceptions()) return
#line 195 "/work/main/tests/classical/classical_wave_slip.pf"
#line 195 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertRelativelyEqual(line%found('cycle_energy')/period, wave%found('cycle_energy'), tolerance=q, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 195) )
  if (anyExceptions()) return
#line 196 "/work/main/tests/classical/classical_wave_slip.pf"
      end do
   end subroutine test_hertz

   ! Along the grooves both bodies give way by their shear moduli; the other way the signs change.
   !@test
   subroutine test_directions()
      type(trial_case_t) :: across, along
      real(dp), allocatable :: maps(:, :, :), mirrored(:, :, :)
      real(dp) :: ratio, displacement, stiffness

      call new_wave(across, 0.4_dp, 0.6_dp)
      call across%give('n_x', 33.0_dp)
      call across%give('x_max', period)
      call across%give('profiles', 1.0_dp)
      call across%solve()
      call across%get_profiles(maps)
      along = across
      call along%give('tangential_axis', along_y)
      call along%give('tangential_stress', -0.6_dp*0.4_dp*mu*full())
#line 215 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertEqual('', along%problems_of(), &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 215) )
  if (anyExceptions()) return
#line 216 "/work/main/tests/classical/classical_wave_slip.pf"
      call along%solve()
      call along%get_profiles(mirrored)
#line 218 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertEqual(3, size(maps, 3), &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 218) )
  if (anyExceptions()) return
#line 219 "/work/main/tests/classical/classical_wave_slip.pf"
#line 219 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertTrue(all(abs(maps(:, :, 3) + mirrored(:, :, 3)) <= 1.0e-15_dp*maxval(maps(:, :, 1))), &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 219) )
  if (anyExceptions()) return
#line 220 "/work/main/tests/classical/classical_wave_slip.pf"
#line 220 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertTrue(all(maps(:, :, 3) <= mu*maps(:, :, 1)*(1 + closed_form)), &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 220) )
  if (anyExceptions()) return
#line 221 "/work/main/tests/classical/classical_wave_slip.pf"
      ! E*/G for one body on a rigid one, over 2: 1/(1 - nu)
      ratio = 1/(1 - nu)
      displacement = -ratio*across%found('tangential_displacement')
      stiffness = across%found('tangential_stiffness')/ratio
#line 225 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertRelativelyEqual(displacement, along%found('tangential_displacement'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 225) )
  if (anyExceptions()) return
#line 226 "/work/main/tests/classical/classical_wave_slip.pf"
#line 226 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertRelativelyEqual(ratio*across%found('cycle_energy'), along%found('cycle_energy'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 226) )
  if (anyExceptions()) return
#line 227 "/work/main/tests/classical/classical_wave_slip.pf"
#line 227 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertRelativelyEqual(stiffness, along%found('tangential_stiffness'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 227) )
  if (anyExceptions()) return
#line 228 "/work/main/tests/classical/classical_wave_slip.pf"
   end subroutine test_directions

   ! At a penetration, and without contact.
   !@test
   subroutine test_controls()
      type(trial_case_t) :: loaded, pressed

      call new_wave(loaded, 0.4_dp, 0.6_dp)
      call loaded%solve()
      call new_wave(pressed, 0.4_dp, 0.6_dp)
      pressed%values(pressed%model%index_of('operating', 'mean_pressure')) = huge(1.0_dp)
      call pressed%give('penetration', loaded%found('penetration'))
#line 240 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertEqual('', pressed%problems_of(), &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 240) )
  if (anyExceptions()) return
#line 241 "/work/main/tests/classical/classical_wave_slip.pf"
      call pressed%solve()
      associate (displacement => loaded%found('tangential_displacement'))
#line 243 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertRelativelyEqual(displacement, pressed%found('tangential_displacement'), tolerance=1.0e-12_dp, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 243) )
  if (anyExceptions()) return
#line 244 "/work/main/tests/classical/classical_wave_slip.pf"
      end associate
      call pressed%give('penetration', -1.0e-6_dp)
      call pressed%solve()
#line 247 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertEqual(status_no_equilibrium, pressed%status(1), &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 247) )
  if (anyExceptions()) return
#line 248 "/work/main/tests/classical/classical_wave_slip.pf"
      call pressed%give('tangential_stress', 0.0_dp)
      call pressed%solve()
#line 250 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertEqual(status_solved, pressed%status(1), &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 250) )
  if (anyExceptions()) return
#line 251 "/work/main/tests/classical/classical_wave_slip.pf"
#line 251 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertTrue(ieee_is_nan(pressed%found('stick_fraction')), &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 251) )
  if (anyExceptions()) return
#line 252 "/work/main/tests/classical/classical_wave_slip.pf"
   end subroutine test_controls

   ! Beyond mu P nothing holds, and no result is left.
   !@test
   subroutine test_sliding()
      type(trial_case_t) :: case

      call new_wave(case, 0.4_dp, 1.0_dp)
      call case%solve()
#line 261 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 261) )
  if (anyExceptions()) return
#line 262 "/work/main/tests/classical/classical_wave_slip.pf"
#line 262 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertEqual(0.0_dp, case%found('tangential_stiffness'), &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 262) )
  if (anyExceptions()) return
#line 263 "/work/main/tests/classical/classical_wave_slip.pf"
      call new_wave(case, 0.4_dp, -1.001_dp)
      call case%solve()
#line 265 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertEqual(status_no_equilibrium, case%status(1), &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 265) )
  if (anyExceptions()) return
#line 266 "/work/main/tests/classical/classical_wave_slip.pf"
#line 266 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertTrue(ieee_is_nan(case%found('penetration')), &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 266) )
  if (anyExceptions()) return
#line 267 "/work/main/tests/classical/classical_wave_slip.pf"
   end subroutine test_sliding

   !@test
   subroutine test_refusals()
      type(trial_case_t) :: case

      call new_wave(case, 0.4_dp, 0.5_dp)
      call case%give('shear_strength', 1.0e6_dp)
#line 275 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertTrue(index(case%problems_of(), '&friction coefficient: stands beside shear_strength') > 0, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 275) )
  if (anyExceptions()) return
#line 276 "/work/main/tests/classical/classical_wave_slip.pf"
      call new_wave(case, 0.4_dp, 0.5_dp)
      call case%give('stress', 1.0e6_dp)
      call case%give('range', 1.0e-7_dp)
#line 279 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertTrue(index(case%problems_of(), '&friction coefficient: stands beside &adhesion') > 0, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 279) )
  if (anyExceptions()) return
#line 280 "/work/main/tests/classical/classical_wave_slip.pf"
      call new_wave(case, 0.4_dp, 0.5_dp)
      case%values(case%model%index_of('operating', 'tangential_stress')) = huge(1.0_dp)
#line 282 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertTrue(index(case%problems_of(), '&operating tangential_stress: is missing') > 0, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 282) )
  if (anyExceptions()) return
#line 283 "/work/main/tests/classical/classical_wave_slip.pf"
      call new_wave(case, 0.4_dp, 0.5_dp)
      case%values(case%model%index_of('friction', 'coefficient')) = huge(1.0_dp)
#line 285 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertTrue(index(case%problems_of(), '&operating tangential_stress: has no meaning without') > 0, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 285) )
  if (anyExceptions()) return
#line 286 "/work/main/tests/classical/classical_wave_slip.pf"
      call new_wave(case, 0.4_dp, 0.5_dp)
      case%values(case%model%index_of('solid', 'young_modulus')) = huge(1.0_dp)
      case%values(case%model%index_of('solid', 'poisson_ratio')) = huge(1.0_dp)
      call case%give('contact_modulus', 1.0e9_dp)
#line 290 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 290) )
  if (anyExceptions()) return
#line 291 "/work/main/tests/classical/classical_wave_slip.pf"
      call case%give('tangential_axis', along_y)
#line 292 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertTrue(index(case%problems_of(), '&solid poisson_ratio: is missing') > 0, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 292) )
  if (anyExceptions()) return
#line 293 "/work/main/tests/classical/classical_wave_slip.pf"
   end subroutine test_refusals

   ! Numbers in other units are other numbers of the same contact.
   !@test
   subroutine test_units()
      type(trial_case_t) :: case, scaled
      real(dp), parameter :: meter = 1024, pascal = 1.0_dp/4096

      call new_wave(case, 0.7_dp, 0.4_dp)
      call case%solve()
      scaled = case
      call scaled%give('period', period*meter)
      call scaled%give('amplitude', amplitude*meter)
      scaled%values(scaled%model%index_of('solid', 'young_modulus')) = young*pascal
      call scaled%give('mean_pressure', 0.7_dp*full()*pascal)
      call scaled%give('tangential_stress', 0.4_dp*mu*0.7_dp*full()*pascal)
      call scaled%solve()
      associate (ratio => scaled%found('tangential_stiffness')/case%found('tangential_stiffness'))
#line 311 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertRelativelyEqual(pascal/meter, ratio, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 311) )
  if (anyExceptions()) return
#line 312 "/work/main/tests/classical/classical_wave_slip.pf"
      end associate
#line 313 "/work/main/tests/classical/classical_wave_slip.pf"
  call assertRelativelyEqual(case%found('cycle_energy')*pascal*meter, scaled%found('cycle_energy'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_wave_slip.pf', &
 & 313) )
  if (anyExceptions()) return
#line 314 "/work/main/tests/classical/classical_wave_slip.pf"
   end subroutine test_units

end module classical_wave_slip

module Wrapclassical_wave_slip
   use FUnit
   use classical_wave_slip
   implicit none
   private

contains


end module Wrapclassical_wave_slip

function classical_wave_slip_suite() result(suite)
   use FUnit
   use classical_wave_slip
   use Wrapclassical_wave_slip
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('classical_wave_slip_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_table', &
      test_table))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_ends', &
      test_ends))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_balances', &
      test_balances))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_full_contact', &
      test_full_contact))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_hertz', &
      test_hertz))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_directions', &
      test_directions))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_controls', &
      test_controls))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_sliding', &
      test_sliding))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_refusals', &
      test_refusals))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_units', &
      test_units))
   call suite%addTest(t)


end function classical_wave_slip_suite


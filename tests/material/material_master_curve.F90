! SPDX-License-Identifier: GPL-3.0-or-later
! Spectra fitted to master curves.
module material_master_curve
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi
   use adfric_material_master_curve, only: master_curve_fit_t, fit_master_curve, default_terms_per_decade
   use adfric_material_prony, only: prony_t, new_prony, most_arms
   use random_dice, only: dice_t, new_dice
   use funit
   implicit none (type, external)

   !> The fractional Zener curve of the demonstration: E0, Eg [Pa], exponent, time [s].
   real(dp), parameter :: relaxed = 2.1e6_dp, glassy = 2.0e9_dp, fraction = 0.55_dp, time = 1.0e-7_dp
   !> Its frequencies: ten a decade, half of them on either side of 1e5 rad/s, in 14 decades.
   integer, parameter :: per_decade = 10, n_points = 14*per_decade + 1

contains

   ! The curve E0 + (Eg - E0) s/(1 + s), s = (i omega tau)^alpha.
   subroutine get_zener_curve(frequencies, storage, loss)
      real(dp), allocatable, intent(out) :: frequencies(:), storage(:), loss(:)
      complex(dp) :: s(n_points), moduli(n_points)
      integer :: k

      allocate (frequencies, source=[(10.0_dp**(-2 + real(k, dp)/per_decade), k=0, n_points - 1)])
      s = (frequencies*time)**fraction*exp(cmplx(0.0_dp, half_pi*fraction, dp))
      moduli = relaxed + (glassy - relaxed)*s/(1 + s)
      allocate (storage, source=real(moduli, dp))
      allocate (loss, source=aimag(moduli))
   end subroutine get_zener_curve

   ! The spectrum of the demonstration, which another program fitted.
   subroutine read_demonstration(prony)
      type(prony_t), intent(out) :: prony
      integer, parameter :: n_arms = 15
      real(dp) :: times(n_arms), moduli(n_arms)
      character(1000) :: folder
      character(100) :: line
      integer :: unit, length, k

      call get_environment_variable('ADFRIC_TEST_REFERENCE', folder, length)
      open (newunit=unit, file=folder(:length)//'/prof_demo_prony.csv', status='old', action='read')
      read (unit, '(a)') line
      do k = 1, n_arms
         read (unit, *) times(k), moduli(k)
      end do
      close (unit)
      ! the relaxed modulus stands in the comment, with nine digits
#line 49 "/work/main/tests/material/material_master_curve.pf"
  call assertGreaterThan(index(line, 'E_inf = 2105253.83'), 0, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 49) )
  if (anyExceptions()) return
#line 50 "/work/main/tests/material/material_master_curve.pf"
      call new_prony(prony, 2105253.83_dp, moduli, times)
   end subroutine read_demonstration

   ! Largest misfits of the curve, with more and more times; from 14 decades of frequencies, ten in each.
   !@test
   subroutine test_zener_misfits()
      type(master_curve_fit_t) :: fit
      real(dp), allocatable :: frequencies(:), storage(:), loss(:)
      real(dp), parameter :: terms(5) = [0.5_dp, 1.0_dp, 1.5_dp, 2.0_dp, 3.0_dp]
      real(dp), parameter :: expected(5) = [0.36_dp, 0.048_dp, 0.006_dp, 7.0e-4_dp, 1.0e-5_dp]
      !> Half of the last digit that is given, in relative terms.
      real(dp), parameter :: digits(5) = [0.015_dp, 0.011_dp, 0.085_dp, 0.075_dp, 0.5_dp]
      integer :: i

      call get_zener_curve(frequencies, storage, loss)
      do i = 1, size(terms)
         call fit_master_curve(fit, frequencies, storage, loss, terms(i))
#line 67 "/work/main/tests/material/material_master_curve.pf"
  call assertTrue(fit%is_solved, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 67) )
  if (anyExceptions()) return
#line 68 "/work/main/tests/material/material_master_curve.pf"
#line 68 "/work/main/tests/material/material_master_curve.pf"
  call assertTrue(fit%is_solid, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 68) )
  if (anyExceptions()) return
#line 69 "/work/main/tests/material/material_master_curve.pf"
#line 69 "/work/main/tests/material/material_master_curve.pf"
  call assertEqual(1 + nint(16*terms(i)), fit%n_times, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 69) )
  if (anyExceptions()) return
#line 70 "/work/main/tests/material/material_master_curve.pf"
#line 70 "/work/main/tests/material/material_master_curve.pf"
  call assertEqual(1.0_dp, fit%modulus%largest/expected(i), tolerance=digits(i), &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 70) )
  if (anyExceptions()) return
#line 71 "/work/main/tests/material/material_master_curve.pf"
#line 71 "/work/main/tests/material/material_master_curve.pf"
  call assertLessThan(fit%modulus%rms, fit%modulus%largest, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 71) )
  if (anyExceptions()) return
#line 72 "/work/main/tests/material/material_master_curve.pf"
         ! no part is off by more than |E| is, and |E| by no more than both parts together
#line 73 "/work/main/tests/material/material_master_curve.pf"
  call assertLessThanOrEqual(fit%modulus%largest, hypot(fit%storage%largest, fit%loss%largest), &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 73) )
  if (anyExceptions()) return
#line 74 "/work/main/tests/material/material_master_curve.pf"
#line 74 "/work/main/tests/material/material_master_curve.pf"
  call assertGreaterThan(fit%loss%largest, fit%modulus%largest, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 74) )
  if (anyExceptions()) return
#line 75 "/work/main/tests/material/material_master_curve.pf"
      end do
#line 76 "/work/main/tests/material/material_master_curve.pf"
  call assertEqual([1.0e-2_dp, 1.0e12_dp], [fit%lowest_frequency, fit%highest_frequency], tolerance=1.0_dp, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 76) )
  if (anyExceptions()) return
#line 77 "/work/main/tests/material/material_master_curve.pf"
   end subroutine test_zener_misfits

   ! One time in each decade gives the spectrum of the demonstration, from the same curve.
   !@test
   subroutine test_demonstration()
      type(master_curve_fit_t) :: fit
      type(prony_t) :: prony
      real(dp), allocatable :: frequencies(:), storage(:), loss(:)
      !> Two fits of one curve: round-off times what the unknowns amplify it by, at the ends of the range.
      real(dp), parameter :: two_fits = 1.0e-11_dp

      call get_zener_curve(frequencies, storage, loss)
      call fit_master_curve(fit, frequencies, storage, loss, 1.0_dp)
      call read_demonstration(prony)
#line 91 "/work/main/tests/material/material_master_curve.pf"
  call assertEqual(size(prony%times), size(fit%prony%times), &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 91) )
  if (anyExceptions()) return
#line 92 "/work/main/tests/material/material_master_curve.pf"
      ! nine digits of the table
#line 93 "/work/main/tests/material/material_master_curve.pf"
  call assertEqual(1.0_dp, fit%prony%relaxed/prony%relaxed, tolerance=2.5e-9_dp, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 93) )
  if (anyExceptions()) return
#line 94 "/work/main/tests/material/material_master_curve.pf"
#line 94 "/work/main/tests/material/material_master_curve.pf"
  call assertEqual(prony%times/fit%prony%times, spread(1.0_dp, 1, size(prony%times)), tolerance=20*epsilon(1.0_dp), &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 94) )
  if (anyExceptions()) return
#line 95 "/work/main/tests/material/material_master_curve.pf"
#line 95 "/work/main/tests/material/material_master_curve.pf"
  call assertEqual(prony%moduli/fit%prony%moduli, spread(1.0_dp, 1, size(prony%times)), tolerance=two_fits, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 95) )
  if (anyExceptions()) return
#line 96 "/work/main/tests/material/material_master_curve.pf"
   end subroutine test_demonstration

   ! Data of a spectrum whose times are offered give the spectrum back, in any order of the data and in any units.
   !@test
   subroutine test_round_trip()
      type(master_curve_fit_t) :: fit
      type(prony_t) :: prony
      real(dp), allocatable :: frequencies(:), storage(:), loss(:)
      real(dp), parameter :: times_unit = 1.0e-20_dp, moduli_unit = 1.0e50_dp
      real(dp) :: shares(15)
      !> The arms at the ends are seen by few data, by which round-off is amplified.
      real(dp), parameter :: recovered = 1.0e-10_dp

      call get_zener_curve(frequencies, storage, loss)
      call read_demonstration(prony)
      frequencies = frequencies(n_points:1:-1)/times_unit
      prony%relaxed = prony%relaxed*moduli_unit
      prony%moduli = prony%moduli*moduli_unit
      prony%times = prony%times*times_unit
      call prony%get_complex_modulus(frequencies, storage, loss)
      call fit_master_curve(fit, frequencies, storage, loss, 1.0_dp)
#line 117 "/work/main/tests/material/material_master_curve.pf"
  call assertTrue(fit%is_solved, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 117) )
  if (anyExceptions()) return
#line 118 "/work/main/tests/material/material_master_curve.pf"
#line 118 "/work/main/tests/material/material_master_curve.pf"
  call assertLessThan(fit%modulus%largest, 1.0e-13_dp, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 118) )
  if (anyExceptions()) return
#line 119 "/work/main/tests/material/material_master_curve.pf"
#line 119 "/work/main/tests/material/material_master_curve.pf"
  call assertEqual(1.0_dp, fit%prony%relaxed/prony%relaxed, tolerance=recovered, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 119) )
  if (anyExceptions()) return
#line 120 "/work/main/tests/material/material_master_curve.pf"
      shares = modulus_near(fit%prony, prony%times)/prony%moduli
#line 121 "/work/main/tests/material/material_master_curve.pf"
  call assertEqual(shares, spread(1.0_dp, 1, 15), tolerance=recovered, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 121) )
  if (anyExceptions()) return
#line 122 "/work/main/tests/material/material_master_curve.pf"

   contains

      ! Moduli of the arms at given times.
      function modulus_near(found, times) result(moduli)
         type(prony_t), intent(in) :: found
         real(dp), intent(in) :: times(:)
         real(dp) :: moduli(size(times))
         integer :: i

         moduli = [(sum(found%moduli, abs(found%times/times(i) - 1) < 1.0e-6_dp), i=1, size(times))]
      end function modulus_near
   end subroutine test_round_trip

   ! Times that are not offered: the curve of the spectrum comes back as well as the times are dense.
   !@test
   subroutine test_other_times()
      type(master_curve_fit_t) :: fit
      type(prony_t) :: prony
      real(dp), allocatable :: frequencies(:), storage(:), loss(:)
      real(dp) :: misfits(3)
      integer :: i

      call get_zener_curve(frequencies, storage, loss)
      call read_demonstration(prony)
      prony%times = 2.3_dp*prony%times
      call prony%get_complex_modulus(frequencies, storage, loss)
      do i = 1, 3
         call fit_master_curve(fit, frequencies, storage, loss, real(i, dp))
#line 151 "/work/main/tests/material/material_master_curve.pf"
  call assertTrue(fit%is_solved, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 151) )
  if (anyExceptions()) return
#line 152 "/work/main/tests/material/material_master_curve.pf"
         misfits(i) = fit%modulus%largest
      end do
#line 154 "/work/main/tests/material/material_master_curve.pf"
  call assertGreaterThan(misfits(1), misfits(2), &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 154) )
  if (anyExceptions()) return
#line 155 "/work/main/tests/material/material_master_curve.pf"
#line 155 "/work/main/tests/material/material_master_curve.pf"
  call assertGreaterThan(misfits(2), misfits(3), &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 155) )
  if (anyExceptions()) return
#line 156 "/work/main/tests/material/material_master_curve.pf"
#line 156 "/work/main/tests/material/material_master_curve.pf"
  call assertLessThan(misfits(3), 0.02_dp, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 156) )
  if (anyExceptions()) return
#line 157 "/work/main/tests/material/material_master_curve.pf"
   end subroutine test_other_times

   ! Noise is not fitted by more times: every fit is proved, has no negative modulus, and is off by about the noise. Many more times
   ! than data tell apart are no harm.
   !@test
   subroutine test_noise()
      type(master_curve_fit_t) :: fit
      type(dice_t) :: dice
      real(dp), allocatable :: frequencies(:), storage(:), loss(:)
      real(dp), parameter :: noise = 0.02_dp
      real(dp) :: factor
      integer :: i, trial, first, last
      real(dp), parameter :: terms(6) = [1.5_dp, 2.0_dp, 3.0_dp, 4.0_dp, 20.0_dp, 1000.0_dp]

      call new_dice(dice, 7)
      do trial = 1, 60
         call get_zener_curve(frequencies, storage, loss)
         do i = 1, n_points
            call dice%between(1 - noise, 1 + noise, factor)
            storage(i) = storage(i)*factor
            call dice%between(1 - noise, 1 + noise, factor)
            loss(i) = loss(i)*factor
         end do
         call dice%choose(n_points - 30, first)
         call dice%choose(n_points - first, last)
         last = first + last
         if (modulo(trial, 3) == 0) then
            first = 1
            last = n_points
         end if
         call fit_master_curve(fit, frequencies(first:last), storage(first:last), loss(first:last), &
            terms(1 + modulo(trial, size(terms))))
#line 189 "/work/main/tests/material/material_master_curve.pf"
  call assertTrue(fit%is_solved, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 189) )
  if (anyExceptions()) return
#line 190 "/work/main/tests/material/material_master_curve.pf"
#line 190 "/work/main/tests/material/material_master_curve.pf"
  call assertLessThanOrEqual(fit%n_times, most_arms, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 190) )
  if (anyExceptions()) return
#line 191 "/work/main/tests/material/material_master_curve.pf"
#line 191 "/work/main/tests/material/material_master_curve.pf"
  call assertTrue(all(fit%prony%moduli > 0), &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 191) )
  if (anyExceptions()) return
#line 192 "/work/main/tests/material/material_master_curve.pf"
#line 192 "/work/main/tests/material/material_master_curve.pf"
  call assertLessThan(fit%modulus%largest, 2*noise, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 192) )
  if (anyExceptions()) return
#line 193 "/work/main/tests/material/material_master_curve.pf"
#line 193 "/work/main/tests/material/material_master_curve.pf"
  call assertLessThan(fit%modulus%rms, noise, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 193) )
  if (anyExceptions()) return
#line 194 "/work/main/tests/material/material_master_curve.pf"
      end do
   end subroutine test_noise

   ! A fluid has no relaxed modulus, and is said to be none of a solid.
   !@test
   subroutine test_fluid()
      type(master_curve_fit_t) :: fit
      type(prony_t) :: prony
      real(dp) :: frequencies(41), storage(41), loss(41)
      integer :: k

      frequencies = [(10.0_dp**(0.1_dp*k), k=-20, 20)]
      call new_prony(prony, 0.0_dp, [1.0e5_dp, 1.0e6_dp], [1.0_dp, 0.1_dp])
      call prony%get_complex_modulus(frequencies, storage, loss)
      call fit_master_curve(fit, frequencies, storage, loss, 1.0_dp)
#line 209 "/work/main/tests/material/material_master_curve.pf"
  call assertTrue(fit%is_solved, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 209) )
  if (anyExceptions()) return
#line 210 "/work/main/tests/material/material_master_curve.pf"
#line 210 "/work/main/tests/material/material_master_curve.pf"
  call assertFalse(fit%is_solid, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 210) )
  if (anyExceptions()) return
#line 211 "/work/main/tests/material/material_master_curve.pf"
#line 211 "/work/main/tests/material/material_master_curve.pf"
  call assertEqual(0.0_dp, fit%prony%relaxed, tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 211) )
  if (anyExceptions()) return
#line 212 "/work/main/tests/material/material_master_curve.pf"
      ! a thousandth of the smallest storage modulus is seen
      storage = storage + 1.0e-3_dp*minval(storage)
      call fit_master_curve(fit, frequencies, storage, loss, 1.0_dp)
#line 215 "/work/main/tests/material/material_master_curve.pf"
  call assertTrue(fit%is_solid, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 215) )
  if (anyExceptions()) return
#line 216 "/work/main/tests/material/material_master_curve.pf"
#line 216 "/work/main/tests/material/material_master_curve.pf"
  call assertEqual(1.0e-3_dp*minval(storage)/1.001_dp, fit%prony%relaxed, tolerance=1.0e-8_dp*minval(storage), &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 216) )
  if (anyExceptions()) return
#line 217 "/work/main/tests/material/material_master_curve.pf"
   end subroutine test_fluid

   ! One frequency alone, an elastic body, and a loss that noise made negative: no misfit is divided by nothing.
   !@test
   subroutine test_odd_data()
      type(master_curve_fit_t) :: fit

      call fit_master_curve(fit, [1.0_dp], [1.0_dp], [0.1_dp], default_terms_per_decade)
#line 225 "/work/main/tests/material/material_master_curve.pf"
  call assertTrue(fit%is_solved, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 225) )
  if (anyExceptions()) return
#line 226 "/work/main/tests/material/material_master_curve.pf"
#line 226 "/work/main/tests/material/material_master_curve.pf"
  call assertLessThan(fit%modulus%largest, 1.0e-13_dp, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 226) )
  if (anyExceptions()) return
#line 227 "/work/main/tests/material/material_master_curve.pf"
      call fit_master_curve(fit, [1.0_dp, 10.0_dp], [3.0_dp, 3.0_dp], [0.0_dp, 0.0_dp], default_terms_per_decade)
#line 228 "/work/main/tests/material/material_master_curve.pf"
  call assertTrue(fit%is_solved, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 228) )
  if (anyExceptions()) return
#line 229 "/work/main/tests/material/material_master_curve.pf"
#line 229 "/work/main/tests/material/material_master_curve.pf"
  call assertEqual(3.0_dp, fit%prony%relaxed, tolerance=1.0e-13_dp, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 229) )
  if (anyExceptions()) return
#line 230 "/work/main/tests/material/material_master_curve.pf"
#line 230 "/work/main/tests/material/material_master_curve.pf"
  call assertEqual(0.0_dp, fit%loss%largest, tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 230) )
  if (anyExceptions()) return
#line 231 "/work/main/tests/material/material_master_curve.pf"
      call fit_master_curve(fit, [1.0_dp, 10.0_dp], [3.0_dp, 3.0_dp], [0.01_dp, -0.01_dp], default_terms_per_decade)
#line 232 "/work/main/tests/material/material_master_curve.pf"
  call assertTrue(fit%is_solved, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 232) )
  if (anyExceptions()) return
#line 233 "/work/main/tests/material/material_master_curve.pf"
#line 233 "/work/main/tests/material/material_master_curve.pf"
  call assertEqual(0.01_dp/3, fit%modulus%largest, tolerance=0.002_dp, &
 & location=SourceLocation( &
 & 'material_master_curve.pf', &
 & 233) )
  if (anyExceptions()) return
#line 234 "/work/main/tests/material/material_master_curve.pf"
   end subroutine test_odd_data

end module material_master_curve

module Wrapmaterial_master_curve
   use FUnit
   use material_master_curve
   implicit none
   private

contains


end module Wrapmaterial_master_curve

function material_master_curve_suite() result(suite)
   use FUnit
   use material_master_curve
   use Wrapmaterial_master_curve
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('material_master_curve_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_zener_misfits', &
      test_zener_misfits))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_demonstration', &
      test_demonstration))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_round_trip', &
      test_round_trip))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_other_times', &
      test_other_times))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_noise', &
      test_noise))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_fluid', &
      test_fluid))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_odd_data', &
      test_odd_data))
   call suite%addTest(t)


end function material_master_curve_suite


! The model `surface_sliding`: published tables, its limits, moved, mirrored and in other units, and what is rejected.
module periodic_sliding_model
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: unset
   use adfric_model_derived, only: derived_t
   use adfric_model_status, only: status_solved, status_no_equilibrium
   use counting_sink, only: n_different_bits
   use periodic_sliding_cases, only: new_wave_case, new_heights_case, give_arms, take, take_heights, give_in, kind_1d, &
      kind_2d, kind_heights
   use reference_table, only: table_t, read_table, table_digits
   use trial_case, only: trial_case_t, new_case
   use trial_surfaces, only: rough_surface
   use funit
   implicit none (type, external)

   real(dp), parameter :: two_pi = 6.283185307179586476925286766559_dp, pi = two_pi/2
   !> Two solutions of the default tolerance, relative to their largest values; friction is a small difference of pressures.
   real(dp), parameter :: equal_solutions = 1.0e-8_dp, equal_friction = 1.0e-6_dp
   !> Closed forms.
   real(dp), parameter :: round_off = 1.0e-13_dp
   !> How far a friction may be off, over its estimated error: at most 1.2 was met in the tables, on 256 to 4096 cells.
   real(dp), parameter :: trust = 1.25_dp

contains

   ! Exact contacts of a sinusoid on a half-plane of one arm: friction and area within their errors, the shift to half a cell.
   !@test
   subroutine test_wave_table()
      real(dp), parameter :: amplitude = 1.0e-3_dp, n = 1024, modulus = 1/(pi*amplitude)
      type(table_t) :: table
      type(trial_case_t) :: case
      real(dp) :: friction, shift, exact, bound
      integer :: k

      call read_table(table, 'visco_wave_sls')
#line 37 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertGreaterThan(table%n_rows, 100, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 37) )
  if (anyExceptions()) return
#line 38 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      do k = 1, table%n_rows
         call new_wave_case(case, kind_1d, 1.0_dp, amplitude, n)
         call give_arms(case, modulus, [modulus*(table%number(k, 'r') - 1)], [1.0_dp], table%number(k, 'a')/two_pi)
         call case%give('mean_pressure', table%number(k, 'p_over_p0star'))
         call case%solve()
#line 43 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(status_solved, case%status(1), message=table%label(k), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 43) )
  if (anyExceptions()) return
#line 44 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
         friction = table%number(k, 'friction_over_E0k2D2')*modulus*(two_pi*amplitude)**2
         bound = trust*case%error_estimate(1)*friction
#line 46 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(friction, case%found('friction_stress'), tolerance=bound, message=table%label(k), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 46) )
  if (anyExceptions()) return
#line 47 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
         exact = table%number(k, 'area_fraction')
         bound = case%found('contact_fraction_error') + epsilon(1.0_dp)
#line 49 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(exact, case%found('contact_fraction'), tolerance=bound, message=table%label(k), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 49) )
  if (anyExceptions()) return
#line 50 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
         exact = table%number(k, 'penetration_over_D')*amplitude
#line 51 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(exact, case%found('penetration'), tolerance=2.0e-4_dp*amplitude, message=table%label(k), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 51) )
  if (anyExceptions()) return
#line 52 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 52 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(case%found('friction_stress'), case%found('dissipation'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 52) )
  if (anyExceptions()) return
#line 53 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
         if (table%text(k, 'regime') == 'full') then
#line 54 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(2.0_dp, case%found('regime'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 54) )
  if (anyExceptions()) return
#line 55 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 55 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertIsNaN(case%found('contact_shift'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 55) )
  if (anyExceptions()) return
#line 56 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
            cycle
         end if
#line 58 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(1.0_dp, case%found('regime'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 58) )
  if (anyExceptions()) return
#line 59 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
         shift = (table%number(k, 'trailing_edge_k') + table%number(k, 'leading_edge_k'))/(2*two_pi)
#line 60 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(shift, case%found('contact_shift'), tolerance=0.5_dp/n, message=table%label(k), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 60) )
  if (anyExceptions()) return
#line 61 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      end do
   end subroutine test_wave_table

   ! Three arms over six decades of velocity, against `wave_1d`, which has them in closed form.
   !@test
   subroutine test_three_arms()
      real(dp), parameter :: moduli(3) = [2.0e6_dp, 4.0e6_dp, 5.0e6_dp], times(3) = [1.0e-2_dp, 1.0e-3_dp, 1.0e-4_dp]
      real(dp), parameter :: period = 1.0e-4_dp, amplitude = 1.0e-6_dp
      type(trial_case_t) :: case, exact
      real(dp) :: velocity, bound
      integer :: k

      do k = -4, 2
         velocity = 10.0_dp**k
         call new_wave_case(case, kind_1d, period, amplitude, 512.0_dp)
         call give_arms(case, 1.0e6_dp, moduli, times, velocity)
         call case%give('mean_pressure', 1.0e4_dp)
         call case%solve()
         call new_case(exact, 'wave_1d')
         call exact%give('period', period)
         call exact%give('amplitude', amplitude)
         call give_arms(exact, 1.0e6_dp, moduli, times, velocity)
         call exact%give('mean_pressure', 1.0e4_dp)
#line 84 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual('', exact%problems_of(), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 84) )
  if (anyExceptions()) return
#line 85 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
         call exact%solve()
#line 86 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual([status_solved, status_solved], [case%status, exact%status], &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 86) )
  if (anyExceptions()) return
#line 87 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
         bound = trust*case%error_estimate(1)
#line 88 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(exact%found('friction_stress'), case%found('friction_stress'), tolerance=bound, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 88) )
  if (anyExceptions()) return
#line 89 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
         bound = case%found('contact_fraction_error')
#line 90 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(exact%found('contact_fraction'), case%found('contact_fraction'), tolerance=bound, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 90) )
  if (anyExceptions()) return
#line 91 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 91 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(exact%found('contact_shift'), case%found('contact_shift'), tolerance=0.5_dp*period/512, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 91) )
  if (anyExceptions()) return
#line 92 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
         bound = exact%found('full_contact_pressure')
#line 93 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(bound, case%found('full_contact_pressure'), tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 93) )
  if (anyExceptions()) return
#line 94 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      end do
   end subroutine test_three_arms

   ! The bi-sinusoid within the uncertainty of the table and the error of 256 cells.
   !@test
   subroutine test_bisine_table()
      real(dp), parameter :: amplitude = 1.0e-3_dp, modulus = 1/(two_pi*amplitude)
      type(table_t) :: table
      type(trial_case_t) :: case
      real(dp) :: exact, bound
      integer :: k

      call read_table(table, 'visco_bisine_sls')
#line 107 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(15, table%n_rows, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 107) )
  if (anyExceptions()) return
#line 108 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      do k = 1, table%n_rows
         call new_wave_case(case, kind_2d, 1.0_dp, amplitude, 256.0_dp)
         call give_arms(case, modulus, [modulus*(table%number(k, 'r') - 1)], [1.0_dp], table%number(k, 'a')/two_pi)
         call case%give('mean_pressure', table%number(k, 'p_over_p0star'))
         call case%solve()
#line 113 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 113) )
  if (anyExceptions()) return
#line 114 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
         exact = table%number(k, 'mu_over_kD')*two_pi*amplitude
         bound = table%number(k, 'mu_pm')*two_pi*amplitude + (case%error_estimate(1) + table_digits)*exact
#line 116 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(exact, case%found('friction_coefficient'), tolerance=bound, message=table%label(k), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 116) )
  if (anyExceptions()) return
#line 117 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
         exact = table%number(k, 'penetration_over_D')*amplitude
         bound = (table%number(k, 'penetration_pm') + 2.0e-4_dp)*amplitude
#line 119 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(exact, case%found('penetration'), tolerance=bound, message=table%label(k), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 119) )
  if (anyExceptions()) return
#line 120 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
         exact = table%number(k, 'area_fraction')
         bound = table%number(k, 'area_pm') + case%found('contact_fraction_error') + epsilon(1.0_dp)
#line 122 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(exact, case%found('contact_fraction'), tolerance=bound, message=table%label(k), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 122) )
  if (anyExceptions()) return
#line 123 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
         ! as even across the motion as the wave
#line 124 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(0.0_dp, case%found('lateral_stress')/case%found('friction_stress'), tolerance=equal_friction, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 124) )
  if (anyExceptions()) return
#line 125 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      end do
   end subroutine test_bisine_table

   !> Arms of a material of the table of full contact.
   subroutine get_material(name, moduli, times)
      character(*), intent(in) :: name
      real(dp), allocatable, intent(out) :: moduli(:), times(:)
      integer :: i

      select case (name)
      case ('sls10')
         moduli = [9.0_dp]
         times = [1.0_dp]
      case ('three')
         moduli = [1.0_dp, 3.0_dp, 5.0_dp]
         times = [10.0_dp, 1.0_dp, 0.1_dp]
      case ('decades12')
         moduli = [(sqrt(2.0_dp)**i, i=0, 12)]
         times = [(10.0_dp**(3 - i), i=0, 12)]
      end select
   end subroutine get_material

   ! Waves in full contact are known in closed form; as heights on 64 cells they are known to the second order of the cells, since
   ! the history of a place is taken to be a chain of straight lines.
   !@test
   subroutine test_full_contact_table()
      integer, parameter :: n = 64
      real(dp), parameter :: amplitude = 0.01_dp/two_pi
      type(table_t) :: table
      real(dp) :: cosine(n, 1)
      type(trial_case_t) :: case
      real(dp), allocatable :: moduli(:), times(:)
      real(dp) :: friction, pressure
      integer :: k, i, kind

      call read_table(table, 'visco_full_contact_prony')
#line 161 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertGreaterThan(table%n_rows, 20, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 161) )
  if (anyExceptions()) return
#line 162 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      do k = 1, table%n_rows
         call get_material(trim(table%text(k, 'material')), moduli, times)
         friction = table%number(k, 'T_over_E0k2D2')*1.0e-4_dp
         pressure = table%number(k, 'p_full_over_E0kD')*0.01_dp
         do kind = 1, 2
            call new_wave_case(case, real(kind, dp), 1.0_dp, amplitude, 32.0_dp)
            call give_arms(case, 1.0_dp, moduli, times, table%number(k, 'kV')/two_pi)
            ! waves across the motion find the solid relaxed
            if (kind == 2) pressure = pressure + 0.005_dp
            call case%give('mean_pressure', pressure*(1 + round_off))
            call case%solve()
#line 173 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(friction, case%found('friction_stress'), tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 173) )
  if (anyExceptions()) return
#line 174 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 174 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(friction, case%found('full_contact_friction'), tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 174) )
  if (anyExceptions()) return
#line 175 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 175 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(pressure, case%found('full_contact_pressure'), tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 175) )
  if (anyExceptions()) return
#line 176 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 176 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(kind*amplitude, case%found('penetration'), tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 176) )
  if (anyExceptions()) return
#line 177 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 177 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual([1.0_dp, 2.0_dp], [case%found('contact_fraction'), case%found('regime')], &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 177) )
  if (anyExceptions()) return
#line 178 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
            call case%give('mean_pressure', pressure/2)
            call case%solve()
#line 180 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(friction, case%found('full_contact_friction'), tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 180) )
  if (anyExceptions()) return
#line 181 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
         end do
         cosine(:, 1) = [(amplitude*cos(two_pi*(i - 0.5_dp)/n), i=1, n)]
         call new_heights_case(case, cosine, 1.0_dp, 1.0_dp)
         call give_arms(case, 1.0_dp, moduli, times, table%number(k, 'kV')/two_pi)
         call case%give('mean_pressure', 2*pressure)
         call case%solve()
#line 187 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(friction, case%found('friction_stress'), tolerance=(two_pi/n)**2/6, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 187) )
  if (anyExceptions()) return
#line 188 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 188 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(0.0_dp, case%found('energy_imbalance'), tolerance=1.0e-6_dp, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 188) )
  if (anyExceptions()) return
#line 189 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 189 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertLessThan(case%error_estimate(1), (2*two_pi/n)**2, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 189) )
  if (anyExceptions()) return
#line 190 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      end do
   end subroutine test_full_contact_table

   ! Thin layers: the strip of the wavy surface, from which they differ by what the table says.
   !@test
   subroutine test_layer_table()
      real(dp), parameter :: h = 2
      type(table_t) :: table
      type(trial_case_t) :: case
      real(dp) :: compliance, friction, penetration, bound
      integer :: k, n_done

      call read_table(table, 'visco_layer_to_gm')
      n_done = 0
      do k = 1, table%n_rows
         if (table%number(k, 'kH') > 0.1_dp .or. table%number(k, 'cells') > 2048) cycle
         n_done = n_done + 1
         associate (nu => table%number(k, 'nu'), thickness => table%number(k, 'kH'))
            call new_wave_case(case, kind_1d, two_pi, h/2, 2048.0_dp)
            call give_arms(case, 1.0_dp, [9.0_dp], [1.0_dp], table%number(k, 'u'))
            call case%give('thickness', thickness)
            compliance = thickness
            call case%give('base', 1.0_dp)
            if (table%text(k, 'base') == 'bonded') then
               compliance = thickness*(1 - 2*nu)/(1 - nu)**2
               call case%give('base', 2.0_dp)
               call give_in(case, 'layer', 'poisson_ratio', nu)
            end if
         end associate
#line 219 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(1, n_problems(case), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 219) )
  if (anyExceptions()) return
#line 220 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
         call case%give('mean_pressure', table%number(k, 'P_K_over_h')*h/(compliance*two_pi))
#line 221 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 221) )
  if (anyExceptions()) return
#line 222 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
         call case%solve()
#line 223 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 223) )
  if (anyExceptions()) return
#line 224 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
         friction = table%number(k, 'T_strip')*(1 + table%number(k, 'T_rel_diff'))*h**2/(compliance*two_pi)
         ! the table has the error of its cells in full contact
         bound = case%error_estimate(1) + (two_pi/table%number(k, 'cells'))**2/6
#line 227 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(friction, case%found('friction_stress'), tolerance=bound, message=table%label(k), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 227) )
  if (anyExceptions()) return
#line 228 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
         penetration = table%number(k, 'D_over_h_strip')*(1 + table%number(k, 'D_rel_diff'))*h
#line 229 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(penetration, case%found('penetration'), tolerance=1.0e-4_dp, message=table%label(k), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 229) )
  if (anyExceptions()) return
#line 230 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      end do
#line 231 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertGreaterThan(n_done, 5, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 231) )
  if (anyExceptions()) return
#line 232 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
   end subroutine test_layer_table

   !> Number of problems of a case.
   integer function n_problems(case)
      type(trial_case_t), intent(in) :: case
      character(:), allocatable :: text
      integer :: i

      allocate (text, source=case%problems_of())
      n_problems = count([(text(i:i) == new_line('a'), i=1, len(text))])
   end function n_problems

   ! At rest, and on a solid without arms, the results are those of the elastic models to the last bit.
   !@test
   subroutine test_rest()
      real(dp), parameter :: modulus = 2.0e7_dp, length = 1.0e-4_dp
      integer, parameter :: n_shared = 8
      type(trial_case_t) :: case, elastic
      real(dp) :: heights(32, 48)
      integer :: k

      heights = -1.0e-6_dp*rough_surface(32, 48, 5)
      call new_case(elastic, 'surface_elastic')
#line 255 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(0, take(elastic, 'surface', 'heights', heights), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 255) )
  if (anyExceptions()) return
#line 256 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      call elastic%give('length_x', length)
      call elastic%give('length_y', 1.5_dp*length)
      call elastic%give('contact_modulus', modulus)
      call elastic%give('mean_pressure', 2.0e5_dp)
      call elastic%solve()
      do k = 1, 2
         call new_heights_case(case, heights, length, 1.5_dp*length)
         if (k == 1) call give_arms(case, modulus, [9*modulus], [1.0_dp], 0.0_dp)
         if (k == 2) call give_arms(case, modulus, [real(dp) ::], [real(dp) ::], 1.0_dp)
         call case%give('mean_pressure', 2.0e5_dp)
         call case%solve()
#line 267 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(0, sum(n_different_bits(elastic%results(:n_shared, :), case%results(:n_shared, :))), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 267) )
  if (anyExceptions()) return
#line 268 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 268 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(elastic%error_estimate(1), case%error_estimate(1), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 268) )
  if (anyExceptions()) return
#line 269 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 269 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(0.0_dp, case%found('friction_stress'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 269) )
  if (anyExceptions()) return
#line 270 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 270 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(0.0_dp, case%found('full_contact_friction'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 270) )
  if (anyExceptions()) return
#line 271 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 271 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(0.0_dp, case%found('energy_imbalance'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 271) )
  if (anyExceptions()) return
#line 272 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 272 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertIsNaN(case%found('contact_shift'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 272) )
  if (anyExceptions()) return
#line 273 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      end do
   end subroutine test_rest

   ! The bi-sinusoid at rest is `wave_2d_elastic`, and very fast it is that of the instantaneous modulus.
   !@test
   subroutine test_both_ends()
      real(dp), parameter :: modulus = 1.0e9_dp, period = 1.0e-5_dp, amplitude = 1.0e-7_dp
      type(trial_case_t) :: case, elastic
      integer :: k

      do k = 1, 2
         call new_case(elastic, 'wave_2d_elastic')
         call elastic%give('period', period)
         call elastic%give('amplitude', amplitude)
         call elastic%give('cells', 64.0_dp)
         call elastic%give('contact_modulus', merge(1, 10, k == 1)*modulus)
         call elastic%give('mean_pressure', 2.0e7_dp)
         call elastic%solve()
         call new_wave_case(case, kind_2d, period, amplitude, 64.0_dp)
         call give_arms(case, modulus, [9*modulus], [1.0e-3_dp], merge(0.0_dp, 1.0e12_dp, k == 1))
         call case%give('mean_pressure', 2.0e7_dp)
         call case%solve()
         ! very fast, waves across the motion find the solid relaxed: not more than those along it find it
         if (k == 2) then
#line 297 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertLessThan(case%found('friction_coefficient'), 1.0e-9_dp, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 297) )
  if (anyExceptions()) return
#line 298 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 298 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertLessThan(case%found('contact_fraction'), 0.5_dp, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 298) )
  if (anyExceptions()) return
#line 299 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
            cycle
         end if
#line 301 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(elastic%found('contact_fraction'), case%found('contact_fraction'), tolerance=10*epsilon(1.0_dp), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 301) )
  if (anyExceptions()) return
#line 302 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 302 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(elastic%found('penetration'), case%found('penetration'), tolerance=equal_solutions, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 302) )
  if (anyExceptions()) return
#line 303 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 303 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(elastic%found('peak_pressure'), case%found('peak_pressure'), tolerance=1.0e-5_dp, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 303) )
  if (anyExceptions()) return
#line 304 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 304 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(0.0_dp, case%found('contact_shift')/period, tolerance=equal_solutions, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 304) )
  if (anyExceptions()) return
#line 305 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      end do
      call new_case(elastic, 'wave_1d')
      call new_wave_case(case, kind_1d, period, amplitude, 1024.0_dp)
      call elastic%give('period', period)
      call elastic%give('amplitude', amplitude)
      call elastic%give('contact_modulus', 10*modulus)
      call give_arms(case, modulus, [9*modulus], [1.0e-3_dp], 1.0e9_dp)
      call elastic%give('mean_pressure', 1.0e7_dp)
      call case%give('mean_pressure', 1.0e7_dp)
      call elastic%solve()
      call case%solve()
#line 316 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(elastic%found('penetration'), case%found('penetration'), tolerance=1.0e-4_dp, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 316) )
  if (anyExceptions()) return
#line 317 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      associate (bound => case%found('contact_fraction_error'))
#line 318 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(elastic%found('contact_fraction'), case%found('contact_fraction'), tolerance=bound, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 318) )
  if (anyExceptions()) return
#line 319 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      end associate
   end subroutine test_both_ends

   !> A rough surface on two arms that slides, with maps.
   subroutine new_rough_case(case, heights, length_x, length_y, direction)
      type(trial_case_t), intent(out) :: case
      real(dp), intent(in) :: heights(:, :), length_x, length_y, direction

      call new_heights_case(case, heights, length_x, length_y)
      call give_arms(case, 1.0e6_dp, [4.0e6_dp, 2.0e7_dp], [1.0e-3_dp, 1.0e-5_dp], 0.1_dp)
      call case%give('direction', direction)
      call case%give('mean_pressure', 2.0e4_dp)
      call case%give('profiles', 1.0_dp)
   end subroutine new_rough_case

   ! A rough surface turned by right angles slides as it did: what holds it back, and what holds it on its way; its maps are turned.
   !@test
   subroutine test_directions()
      real(dp), parameter :: length_x = 1.0e-4_dp, length_y = 1.5e-4_dp
      type(trial_case_t) :: case, turned
      real(dp), allocatable :: maps(:, :, :), turned_maps(:, :, :), heights(:, :), pressure(:, :)
      integer :: k
      real(dp) :: lengths(2)

      heights = -1.0e-6_dp*rough_surface(32, 48, 5)
      call new_rough_case(case, heights, length_x, length_y, 0.0_dp)
#line 345 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 345) )
  if (anyExceptions()) return
#line 346 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      call case%solve()
#line 347 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 347) )
  if (anyExceptions()) return
#line 348 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      call case%get_profiles(maps)
      allocate (pressure, source=maps(:, :, 1))
#line 350 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertGreaterThan(abs(case%found('lateral_stress')), 1.0e-4_dp*case%found('friction_stress'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 350) )
  if (anyExceptions()) return
#line 351 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      lengths = [length_x, length_y]
      do k = 1, 3
         ! a quarter turn to the left takes x to y and y to -x
         heights = transpose(heights)
         heights = heights(size(heights, 1):1:-1, :)
         pressure = transpose(pressure)
         pressure = pressure(size(pressure, 1):1:-1, :)
         lengths = lengths([2, 1])
         call new_rough_case(turned, heights, lengths(1), lengths(2), 90.0_dp*k)
         call turned%solve()
#line 361 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(status_solved, turned%status(1), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 361) )
  if (anyExceptions()) return
#line 362 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 362 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(case%found('friction_stress'), turned%found('friction_stress'), tolerance=equal_friction, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 362) )
  if (anyExceptions()) return
#line 363 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 363 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(case%found('lateral_stress'), turned%found('lateral_stress'), tolerance=equal_friction, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 363) )
  if (anyExceptions()) return
#line 364 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 364 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(case%found('penetration'), turned%found('penetration'), tolerance=equal_solutions, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 364) )
  if (anyExceptions()) return
#line 365 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
         associate (full => case%found('full_contact_friction'))
#line 366 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(full, turned%found('full_contact_friction'), tolerance=equal_solutions, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 366) )
  if (anyExceptions()) return
#line 367 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
         end associate
         call turned%get_profiles(turned_maps)
#line 369 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(pressure, turned_maps(:, :, 1), tolerance=equal_friction*maxval(pressure), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 369) )
  if (anyExceptions()) return
#line 370 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      end do
      ! the other way: another friction, but for full contact
      call new_rough_case(turned, -1.0e-6_dp*rough_surface(32, 48, 5), length_x, length_y, 180.0_dp)
      call turned%solve()
#line 374 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertGreaterThan(abs(turned%found('friction_stress')/case%found('friction_stress') - 1), 1.0e-3_dp, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 374) )
  if (anyExceptions()) return
#line 375 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      associate (full => case%found('full_contact_friction'))
#line 376 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(full, turned%found('full_contact_friction'), tolerance=equal_solutions, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 376) )
  if (anyExceptions()) return
#line 377 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      end associate
   end subroutine test_directions

   ! Waves along diagonals: full contact of the table, all diagonals alike, and a wave in one direction.
   !@test
   subroutine test_diagonals()
      integer, parameter :: n = 64
      real(dp), parameter :: amplitude = 0.01_dp/two_pi
      type(table_t) :: table
      type(trial_case_t) :: case, turned
      real(dp), allocatable :: moduli(:), times(:)
      real(dp) :: exact, friction(4)
      integer :: k

      call read_table(table, 'visco_full_contact_prony')
      do k = 1, table%n_rows
         call get_material(table%text(k, 'material'), moduli, times)
         call new_wave_case(case, kind_2d, 1.0_dp, amplitude, real(n, dp))
         call give_arms(case, 1.0_dp, moduli, times, table%number(k, 'kV')/two_pi)
         call case%give('direction', 45.0_dp)
         call case%give('mean_pressure', 1.0e4_dp)
         call case%solve()
#line 399 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 399) )
  if (anyExceptions()) return
#line 400 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
         exact = table%number(k, 'T45_over_E0k2D2')*(two_pi*amplitude)**2
#line 401 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(exact, case%found('friction_stress'), tolerance=1.0e-12_dp, message=table%label(k), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 401) )
  if (anyExceptions()) return
#line 402 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 402 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(0.0_dp, case%found('lateral_stress'), tolerance=1.0e-12_dp*exact, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 402) )
  if (anyExceptions()) return
#line 403 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      end do
      ! partial contact is the same along all diagonals, and its error falls with the cells
      do k = 1, 4
         call new_wave_case(case, kind_2d, 1.0_dp, amplitude, 32*2.0_dp**min(k, 3))
         call give_arms(case, 1.0_dp, [9.0_dp], [1.0_dp], 1/two_pi)
         call case%give('direction', merge(315.0_dp, 45.0_dp, k == 4))
         call case%give('mean_pressure', 0.002_dp)
#line 410 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 410) )
  if (anyExceptions()) return
#line 411 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
         call case%solve()
#line 412 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 412) )
  if (anyExceptions()) return
#line 413 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 413 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertIsNaN(case%found('contact_shift'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 413) )
  if (anyExceptions()) return
#line 414 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 414 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertGreaterThan(case%found('friction_stress'), 0.0_dp, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 414) )
  if (anyExceptions()) return
#line 415 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
         friction(k) = case%found('friction_stress')
      end do
#line 417 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(friction(3), friction(4), tolerance=equal_friction, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 417) )
  if (anyExceptions()) return
#line 418 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 418 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertLessThan(abs(friction(3) - friction(2)), abs(friction(2) - friction(1))/2, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 418) )
  if (anyExceptions()) return
#line 419 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      ! a line goes less fast along x, and is held back by less
      call new_wave_case(case, kind_1d, 1.0_dp, amplitude, real(n, dp))
      call give_arms(case, 1.0_dp, [9.0_dp], [1.0_dp], 1/two_pi)
      call case%give('mean_pressure', 0.002_dp)
      call case%give('direction', 135.0_dp)
      call case%solve()
      call new_wave_case(turned, kind_1d, 1.0_dp, amplitude, real(n, dp))
      call give_arms(turned, 1.0_dp, [9.0_dp], [1.0_dp], 1/(two_pi*sqrt(2.0_dp)))
      call turned%give('mean_pressure', 0.002_dp)
      call turned%solve()
      exact = turned%found('friction_stress')/sqrt(2.0_dp)
#line 430 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(exact, case%found('friction_stress'), tolerance=equal_friction, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 430) )
  if (anyExceptions()) return
#line 431 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
   end subroutine test_diagonals

   ! A wave slides either way alike, and its contact is shifted to the leading side; along y it is a wave of its own.
   !@test
   subroutine test_mirror()
      type(trial_case_t) :: case, other
      real(dp), allocatable :: maps(:, :, :), other_maps(:, :, :)
      integer :: k

      call new_wave_case(case, kind_2d, 1.0e-4_dp, 1.0e-6_dp, 64.0_dp)
      call give_arms(case, 1.0e6_dp, [9.0e6_dp], [1.0e-4_dp], 0.1_dp)
      call case%give('mean_pressure', 2.0e4_dp)
      call case%solve()
      call case%get_profiles(maps)
#line 445 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertGreaterThan(case%found('contact_shift'), 1.0e-6_dp, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 445) )
  if (anyExceptions()) return
#line 446 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      do k = 1, 3
         allocate (other%model, source=case%model)
         allocate (other%values, source=case%values)
         call other%give('direction', 90.0_dp*k)
         call other%solve()
         call other%get_profiles(other_maps)
         if (k == 1) maps(:, :, 1) = transpose(maps(:, :, 1))
         if (k == 2) maps(:, :, 1) = transpose(maps(:, 64:1:-1, 1))
         if (k == 3) maps(:, :, 1) = transpose(maps(:, :, 1))
#line 455 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(maps(:, :, 1), other_maps(:, :, 1), tolerance=equal_friction*maxval(maps(:, :, 1)), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 455) )
  if (anyExceptions()) return
#line 456 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 456 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(case%found('friction_stress'), other%found('friction_stress'), tolerance=equal_friction, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 456) )
  if (anyExceptions()) return
#line 457 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 457 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(case%found('contact_shift'), other%found('contact_shift'), tolerance=equal_friction, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 457) )
  if (anyExceptions()) return
#line 458 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
         deallocate (other%model, other%values)
      end do
   end subroutine test_mirror

   ! Lengths, pressures and times in other units.
   !@test
   subroutine test_other_units()
      real(dp), parameter :: metre = 1.0e9_dp, pascal = 1.0e-9_dp, second = 1.0e3_dp
      type(trial_case_t) :: case, other
      real(dp) :: heights(32, 32)

      heights = -1.0e-6_dp*rough_surface(32, 32, 6)
      call new_heights_case(case, heights, 1.0e-4_dp, 1.0e-4_dp)
      call give_arms(case, 1.0e6_dp, [4.0e6_dp], [1.0e-4_dp], 0.1_dp)
      call case%give('mean_pressure', 1.0e5_dp)
      call case%solve()
      call new_heights_case(other, metre*heights, metre*1.0e-4_dp, metre*1.0e-4_dp)
      call give_arms(other, pascal*1.0e6_dp, [pascal*4.0e6_dp], [second*1.0e-4_dp], metre*0.1_dp/second)
      call other%give('mean_pressure', pascal*1.0e5_dp)
      call other%solve()
#line 478 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(pascal*case%found('friction_stress'), other%found('friction_stress'), tolerance=equal_friction, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 478) )
  if (anyExceptions()) return
#line 479 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 479 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(case%found('friction_coefficient'), other%found('friction_coefficient'), tolerance=equal_friction, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 479) )
  if (anyExceptions()) return
#line 480 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 480 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(metre*case%found('penetration'), other%found('penetration'), tolerance=equal_solutions, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 480) )
  if (anyExceptions()) return
#line 481 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 481 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(pascal*case%found('peak_pressure'), other%found('peak_pressure'), tolerance=equal_friction, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 481) )
  if (anyExceptions()) return
#line 482 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 482 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(case%found('contact_fraction'), other%found('contact_fraction'), tolerance=epsilon(1.0_dp), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 482) )
  if (anyExceptions()) return
#line 483 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
   end subroutine test_other_units

   !> A quantity that follows from the values of a case.
   real(dp) function derived_of(case, name) result(value)
      type(trial_case_t), intent(in) :: case
      character(*), intent(in) :: name
      type(derived_t), allocatable :: derived(:)
      integer :: i

      value = -1
      allocate (derived, source=case%model%derive_quantities(case%values))
      do i = 1, size(derived)
         if (derived(i)%name == name) value = derived(i)%value
      end do
   end function derived_of

   ! The penetration of a load gives the load, on a half-space and on layers; full contact of a half-space has no larger one.
   !@test
   subroutine test_penetration()
      type(trial_case_t) :: case
      real(dp) :: found(3), full
      integer :: base, kind

      do kind = 1, 2
         do base = 0, 2
            call new_wave_case(case, real(kind, dp), 1.0e-4_dp, 1.0e-6_dp, 64.0_dp)
            call give_arms(case, 1.0e6_dp, [9.0e6_dp], [1.0e-4_dp], 0.1_dp)
            if (base > 0) then
               call case%give('thickness', 2.0e-5_dp)
               call case%give('base', real(base, dp))
               if (base == 2) call give_in(case, 'layer', 'poisson_ratio', 0.4_dp)
            end if
            call case%give('mean_pressure', 3.0e4_dp)
            call case%solve()
#line 517 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 517) )
  if (anyExceptions()) return
#line 518 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
            found = [case%found('penetration'), case%found('friction_stress'), case%found('contact_fraction')]
            call case%give('mean_pressure', unset)
            call case%give('penetration', found(1))
#line 521 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 521) )
  if (anyExceptions()) return
#line 522 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
            call case%solve()
#line 523 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 523) )
  if (anyExceptions()) return
#line 524 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 524 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(3.0e4_dp, case%found('mean_pressure'), tolerance=equal_friction, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 524) )
  if (anyExceptions()) return
#line 525 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 525 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(found(2), case%found('friction_stress'), tolerance=equal_friction, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 525) )
  if (anyExceptions()) return
#line 526 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 526 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(found(3), case%found('contact_fraction'), tolerance=epsilon(1.0_dp), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 526) )
  if (anyExceptions()) return
#line 527 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
            call case%give('penetration', 1.0e-4_dp)
            call case%solve()
            if (base == 0) then
#line 530 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(status_no_equilibrium, case%status(1), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 530) )
  if (anyExceptions()) return
#line 531 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
            else
#line 532 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(2.0_dp, case%found('regime'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 532) )
  if (anyExceptions()) return
#line 533 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
               ! the penetration of full contact is that of its pressure
               call case%give('penetration', derived_of(case, 'full_contact_penetration')*(1 + round_off))
               call case%solve()
               full = derived_of(case, 'full_contact_pressure')
#line 537 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(full, case%found('mean_pressure'), tolerance=10*round_off, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 537) )
  if (anyExceptions()) return
#line 538 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 538 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(case%found('full_contact_friction'), case%found('friction_stress'), tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 538) )
  if (anyExceptions()) return
#line 539 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
            end if
         end do
      end do
   end subroutine test_penetration

   ! Nothing touches, nothing rubs; one cell too few for a coarser grid, and the error is anything.
   !@test
   subroutine test_no_contact_and_no_grids()
      type(trial_case_t) :: case
      character(:), allocatable :: text

      call new_wave_case(case, kind_1d, 1.0e-4_dp, 1.0e-6_dp, 64.0_dp)
      call give_arms(case, 1.0e6_dp, [9.0e6_dp], [1.0e-4_dp], 0.1_dp)
      call case%give('mean_pressure', 0.0_dp)
      call case%solve()
#line 554 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual([0.0_dp, 0.0_dp, 0.0_dp], [case%found('friction_stress'), case%found('regime'), case%error_estimate(1)], &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 554) )
  if (anyExceptions()) return
#line 555 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 555 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertIsNaN(case%found('friction_coefficient'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 555) )
  if (anyExceptions()) return
#line 556 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 556 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertGreaterThan(case%found('full_contact_friction'), 0.0_dp, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 556) )
  if (anyExceptions()) return
#line 557 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      call new_rough_case(case, -1.0e-6_dp*rough_surface(31, 33, 5), 1.0e-4_dp, 1.0e-4_dp, 0.0_dp)
      call case%solve()
#line 559 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 559) )
  if (anyExceptions()) return
#line 560 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 560 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(1.0_dp, case%error_estimate(1), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 560) )
  if (anyExceptions()) return
#line 561 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      allocate (text, source=case%model%describe_case(case%values))
#line 562 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertTrue(index(text, 'the error of the area is not estimated, nor that of the friction') > 0, message=text, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 562) )
  if (anyExceptions()) return
#line 563 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
   end subroutine test_no_contact_and_no_grids

   ! On a thin layer in fast sliding it takes many steps to halve the pressure that is left in open cells, and none is in vain.
   !@test
   subroutine test_slow_steps()
      type(trial_case_t) :: case

      call new_wave_case(case, kind_2d, 1.0_dp, 0.001_dp, 64.0_dp)
      call give_arms(case, 1.0_dp, [1.0e4_dp], [1.0_dp], 1.0_dp)
      call case%give('thickness', 0.01_dp)
      call case%give('base', 1.0_dp)
      call case%give('mean_pressure', 0.01_dp)
      call case%solve()
#line 576 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 576) )
  if (anyExceptions()) return
#line 577 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 577 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertLessThanOrEqual(case%found('contact_violation'), 1.0e-10_dp, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 577) )
  if (anyExceptions()) return
#line 578 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
   end subroutine test_slow_steps

   ! A point in closed form takes no iterations, whatever the point before it took.
   !@test
   subroutine test_iterations_of_closed_forms()
      type(trial_case_t) :: case
      real(dp), allocatable :: values(:, :), results(:, :)
      real(dp) :: alone(1), together(1), error_estimate(2)
      integer :: status(2)

      call new_wave_case(case, kind_1d, 1.0_dp, 0.01_dp, 64.0_dp)
      call give_arms(case, 1.0_dp, [9.0_dp], [1.0_dp], 0.1_dp)
      call case%give('mean_pressure', 0.005_dp)
      allocate (values(size(case%values), 2), results(size(case%model%results), 2))
      values(:, 1) = case%values
      call case%give('mean_pressure', 1.0_dp)
      values(:, 2) = case%values
      call case%model%solve_block(values(:, :1), results(:, :1), error_estimate(:1), status(:1), alone)
      call case%model%solve_block(values, results, error_estimate, status, together)
#line 597 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual([status_solved, status_solved], status, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 597) )
  if (anyExceptions()) return
#line 598 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 598 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertGreaterThan(alone(1), 0.0_dp, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 598) )
  if (anyExceptions()) return
#line 599 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 599 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(alone(1), together(1), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 599) )
  if (anyExceptions()) return
#line 600 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
   end subroutine test_iterations_of_closed_forms

   ! Times shifted by temperature, or a velocity of as much more, are the same.
   !@test
   subroutine test_shift_factor()
      type(trial_case_t) :: case, faster

      call new_wave_case(case, kind_1d, 1.0e-4_dp, 1.0e-6_dp, 256.0_dp)
      call give_arms(case, 1.0e6_dp, [9.0e6_dp], [1.0e-4_dp], 0.1_dp)
      call case%give('mean_pressure', 2.0e4_dp)
      call case%give('shift', 2.0_dp)
      call case%give('reference_temperature', 300.0_dp)
      call case%give('temperature', 290.0_dp)
      call case%give('wlf_c1', 10.0_dp)
      call case%give('wlf_c2', 110.0_dp)
#line 615 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 615) )
  if (anyExceptions()) return
#line 616 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      call case%solve()
      call new_wave_case(faster, kind_1d, 1.0e-4_dp, 1.0e-6_dp, 256.0_dp)
      call give_arms(faster, 1.0e6_dp, [9.0e6_dp], [1.0e-4_dp], 1.0_dp)
      call faster%give('mean_pressure', 2.0e4_dp)
      call faster%solve()
#line 621 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(faster%found('friction_stress'), case%found('friction_stress'), tolerance=equal_friction, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 621) )
  if (anyExceptions()) return
#line 622 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
   end subroutine test_shift_factor

   !> Is this one of the problems of a case?
   logical function says(case, text, swept)
      type(trial_case_t), intent(in) :: case
      character(*), intent(in) :: text
      character(*), intent(in), optional :: swept

      says = index(case%problems_of(swept), 'case: &'//text) > 0
   end function says

   !@test
   subroutine test_rejections_of_surfaces()
      type(trial_case_t) :: case

      call new_case(case, 'surface_sliding')
#line 638 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertTrue(says(case, 'surface kind: is missing, one of wave_1d wave_2d heights'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 638) )
  if (anyExceptions()) return
#line 639 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      call case%give('kind', kind_1d)
#line 640 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertTrue(says(case, 'surface period: is missing [m]'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 640) )
  if (anyExceptions()) return
#line 641 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 641 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertTrue(says(case, 'surface amplitude: is missing [m]'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 641) )
  if (anyExceptions()) return
#line 642 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 642 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertTrue(says(case, 'operating velocity: is missing [m/s]'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 642) )
  if (anyExceptions()) return
#line 643 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 643 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertTrue(says(case, 'operating mean_pressure: is missing'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 643) )
  if (anyExceptions()) return
#line 644 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      call new_wave_case(case, kind_2d, 1.0_dp, 0.01_dp, 128.0_dp)
      call give_arms(case, 1.0_dp, [9.0_dp], [1.0_dp], 1.0_dp)
      call case%give('mean_pressure', 0.01_dp)
#line 647 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 647) )
  if (anyExceptions()) return
#line 648 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      call case%give('length_x', 1.0_dp)
#line 649 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertTrue(says(case, 'surface length_x: has no meaning for waves'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 649) )
  if (anyExceptions()) return
#line 650 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      call case%give('length_x', unset)
#line 651 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(32, case%model%variables(case%model%index_of('numerics', 'cells'))%multiple_of, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 651) )
  if (anyExceptions()) return
#line 652 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      call case%give('cells', 16384.0_dp)
#line 653 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertTrue(says(case, 'numerics cells: is more than 8192, the most for wave_2d'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 653) )
  if (anyExceptions()) return
#line 654 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      call case%give('kind', kind_1d)
#line 655 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 655) )
  if (anyExceptions()) return
#line 656 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      call case%give('direction', 44.0_dp)
#line 657 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertTrue(says(case, 'surface direction: is no multiple of 45 degrees'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 657) )
  if (anyExceptions()) return
#line 658 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      call case%give('direction', 0.0_dp)
#line 659 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertTrue(says(case, 'surface direction: is swept; a run has one direction', 'direction'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 659) )
  if (anyExceptions()) return
#line 660 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      call case%give('penetration', 0.01_dp)
#line 661 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertTrue(says(case, 'operating mean_pressure: stands beside penetration'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 661) )
  if (anyExceptions()) return
#line 662 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      call case%give('penetration', unset)
      call case%give('profiles', 1.0_dp)
#line 664 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertTrue(says(case, 'numerics cells: is swept', 'cells'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 664) )
  if (anyExceptions()) return
#line 665 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 665 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertTrue(says(case, 'surface period: is swept', 'period'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 665) )
  if (anyExceptions()) return
#line 666 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 666 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual('', case%problems_of('velocity'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 666) )
  if (anyExceptions()) return
#line 667 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      call case%give('kind', kind_heights)
#line 668 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertTrue(says(case, 'surface heights: is missing [m]'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 668) )
  if (anyExceptions()) return
#line 669 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 669 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertTrue(says(case, 'surface period: has no meaning beside heights'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 669) )
  if (anyExceptions()) return
#line 670 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 670 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertTrue(says(case, 'numerics cells: has no meaning beside heights'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 670) )
  if (anyExceptions()) return
#line 671 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 671 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(1, take_heights(case, reshape([1.0_dp, 1.0_dp, 1.0_dp, 1.0_dp], [4, 1])), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 671) )
  if (anyExceptions()) return
#line 672 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
   end subroutine test_rejections_of_surfaces

   !@test
   subroutine test_rejections_of_solids()
      type(trial_case_t) :: case

      call new_wave_case(case, kind_1d, 1.0_dp, 0.01_dp, 128.0_dp)
      call case%give('mean_pressure', 0.01_dp)
      call case%give('velocity', 1.0_dp)
#line 681 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertTrue(says(case, 'material modulus: is missing [Pa]'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 681) )
  if (anyExceptions()) return
#line 682 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      call give_arms(case, 1.0_dp, [9.0_dp], [1.0_dp], 1.0_dp)
#line 683 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 683) )
  if (anyExceptions()) return
#line 684 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      call case%give('time_factor', 1.0e100_dp)
#line 685 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertTrue(says(case, 'operating velocity: times the factor of the relaxation times is too large'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 685) )
  if (anyExceptions()) return
#line 686 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      call case%give('time_factor', unset)
      call case%give('base', 2.0_dp)
#line 688 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertTrue(says(case, 'layer thickness: is missing [m]'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 688) )
  if (anyExceptions()) return
#line 689 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 689 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertTrue(says(case, 'layer poisson_ratio: is missing [-]; a bonded layer needs it'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 689) )
  if (anyExceptions()) return
#line 690 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      call case%give('thickness', 1.0_dp)
      call give_in(case, 'layer', 'poisson_ratio', 0.3_dp)
#line 692 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 692) )
  if (anyExceptions()) return
#line 693 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      call case%give('base', 1.0_dp)
#line 694 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertTrue(says(case, 'layer poisson_ratio: has no meaning for base = ''frictionless'''), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 694) )
  if (anyExceptions()) return
#line 695 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      call give_in(case, 'layer', 'poisson_ratio', unset)
      call case%give('thickness', 1.0e-7_dp)
#line 697 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertTrue(says(case, 'layer thickness: is less than 1e-6 of the period along x'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 697) )
  if (anyExceptions()) return
#line 698 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      call case%give('thickness', 1.0_dp)
      call case%give('base', unset)
#line 700 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertTrue(says(case, 'layer base: is missing, one of frictionless bonded'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 700) )
  if (anyExceptions()) return
#line 701 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      ! a material that has it
      call case%give('base', 2.0_dp)
      call case%give('modulus', unset)
      call give_in(case, 'material', 'moduli', unset)
      call case%give('young_modulus', 1.0_dp)
      call give_in(case, 'material', 'poisson_ratio', 0.3_dp)
#line 707 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(0, take(case, 'material', 'young_moduli', reshape([9.0_dp], [1, 1])), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 707) )
  if (anyExceptions()) return
#line 708 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 708 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertFalse(says(case, 'layer'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 708) )
  if (anyExceptions()) return
#line 709 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      call give_in(case, 'layer', 'poisson_ratio', 0.3_dp)
#line 710 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertTrue(says(case, 'layer poisson_ratio: stands beside that of &material'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 710) )
  if (anyExceptions()) return
#line 711 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
   end subroutine test_rejections_of_solids

   ! What `adfric check` says: arms, the frequencies of the surface, and a doubt where they lie beyond the master curve.
   !@test
   subroutine test_description()
      type(trial_case_t) :: case
      real(dp) :: curve(9, 3), lowest
      integer :: i

      call new_rough_case(case, -1.0e-6_dp*rough_surface(32, 48, 5), 1.0e-4_dp, 1.5e-4_dp, 90.0_dp)
#line 721 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertTrue(index(case%model%describe_case(case%values), 'arm 2: contact modulus') > 0, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 721) )
  if (anyExceptions()) return
#line 722 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      lowest = two_pi*0.1_dp/1.5e-4_dp
#line 723 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(lowest, derived_of(case, 'lowest_frequency'), tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 723) )
  if (anyExceptions()) return
#line 724 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 724 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertRelativelyEqual(24*lowest, derived_of(case, 'highest_frequency'), tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 724) )
  if (anyExceptions()) return
#line 725 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 725 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(-1.0_dp, derived_of(case, 'cells'), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 725) )
  if (anyExceptions()) return
#line 726 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 726 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual('', case%model%describe_doubts(case%values), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 726) )
  if (anyExceptions()) return
#line 727 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      do i = 1, 9
         associate (omega => 10.0_dp**(i - 3))
            curve(i, :) = [omega, 1.0e6_dp + 1.0e6_dp*omega**2/(1 + omega**2), 1.0e6_dp*omega/(1 + omega**2)]
         end associate
      end do
      call case%give('modulus', unset)
      call case%give('moduli', unset)
      call case%give('relaxation_times', unset)
#line 735 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual(0, take(case, 'material', 'master_curve', curve), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 735) )
  if (anyExceptions()) return
#line 736 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 736 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 736) )
  if (anyExceptions()) return
#line 737 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
#line 737 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertEqual('', case%model%describe_doubts(case%values), &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 737) )
  if (anyExceptions()) return
#line 738 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
      call case%give('velocity', 100.0_dp)
#line 739 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
  call assertTrue(index(case%model%describe_doubts(case%values), 'beyond it friction is missing') > 0, &
 & location=SourceLocation( &
 & 'periodic_sliding_model.pf', &
 & 739) )
  if (anyExceptions()) return
#line 740 "/work/wt/penetration/tests/periodic/periodic_sliding_model.pf"
   end subroutine test_description

end module periodic_sliding_model

module Wrapperiodic_sliding_model
   use FUnit
   use periodic_sliding_model
   implicit none
   private

contains


end module Wrapperiodic_sliding_model

function periodic_sliding_model_suite() result(suite)
   use FUnit
   use periodic_sliding_model
   use Wrapperiodic_sliding_model
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('periodic_sliding_model_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_wave_table', &
      test_wave_table))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_three_arms', &
      test_three_arms))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_bisine_table', &
      test_bisine_table))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_full_contact_table', &
      test_full_contact_table))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_layer_table', &
      test_layer_table))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_rest', &
      test_rest))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_both_ends', &
      test_both_ends))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_directions', &
      test_directions))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_diagonals', &
      test_diagonals))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_mirror', &
      test_mirror))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_other_units', &
      test_other_units))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_penetration', &
      test_penetration))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_no_contact_and_no_grids', &
      test_no_contact_and_no_grids))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_slow_steps', &
      test_slow_steps))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_iterations_of_closed_forms', &
      test_iterations_of_closed_forms))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_shift_factor', &
      test_shift_factor))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_rejections_of_surfaces', &
      test_rejections_of_surfaces))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_rejections_of_solids', &
      test_rejections_of_solids))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_description', &
      test_description))
   call suite%addTest(t)


end function periodic_sliding_model_suite


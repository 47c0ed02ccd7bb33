! SPDX-License-Identifier: GPL-3.0-or-later
!> What a call through adfric.h costs above the same call in Fortran: a point of a batch, and a case of one point from its
!> opening to its end.
!>
!>     c_calls [TABLE.csv]
!>
!> Both calls take the same arrays in turn; the difference is of neighbours in time, and times are those of the processor. See
!> bench/README.md.
program c_calls
   use, intrinsic :: iso_c_binding, only: c_char, c_double, c_int, c_int32_t, c_int64_t, c_int8_t, c_null_char, c_null_funptr, &
      & c_null_ptr, c_funptr, c_ptr
   use, intrinsic :: iso_fortran_env, only: output_unit
   use adfric_base_kinds, only: dp
   use adfric_contact_sphere, only: solve_sphere_approach, solve_sphere_load
   use adfric_contact_strip, only: solve_strip_load, solve_strip_penetration
   use measure, only: spread_t, spread_of, print_heading, text_argument, open_table
   implicit none (type, external)

   interface
      integer(c_int) function c_sphere(n, lambda, prescribed, flags, first, second, third, status) bind(c, &
         & name='adfric_sphere_load')
         import :: c_double, c_int, c_int32_t, c_int64_t, c_int8_t
         implicit none (type, external)
         integer(c_int64_t), intent(in), value :: n
         real(c_double), intent(in) :: lambda(*), prescribed(*)
         integer(c_int8_t), intent(in) :: flags(*)
         real(c_double), intent(inout) :: first(*), second(*), third(*)
         integer(c_int32_t), intent(inout) :: status(*)
      end function c_sphere
      integer(c_int) function c_approach(n, lambda, prescribed, flags, first, second, third, status) &
         & bind(c, name='adfric_sphere_approach')
         import :: c_double, c_int, c_int32_t, c_int64_t, c_int8_t
         implicit none (type, external)
         integer(c_int64_t), intent(in), value :: n
         real(c_double), intent(in) :: lambda(*), prescribed(*)
         integer(c_int8_t), intent(in) :: flags(*)
         real(c_double), intent(inout) :: first(*), second(*), third(*)
         integer(c_int32_t), intent(inout) :: status(*)
      end function c_approach
      integer(c_int) function c_strip(n, phase, ratio, stress, range, prescribed, jumps, loads, first, second, third, fourth, &
         & status) &
         & bind(c, name='adfric_strip_load')
         import :: c_double, c_int, c_int32_t, c_int64_t, c_int8_t
         implicit none (type, external)
         integer(c_int64_t), intent(in), value :: n
         real(c_double), intent(in) :: phase(*), ratio(*), stress(*), range(*), prescribed(*)
         integer(c_int8_t), intent(in) :: jumps(*), loads(*)
         real(c_double), intent(inout) :: first(*), second(*), third(*), fourth(*)
         integer(c_int32_t), intent(inout) :: status(*)
      end function c_strip
      integer(c_int) function c_penetration(n, phase, ratio, stress, range, prescribed, jumps, loads, first, second, third, &
         & fourth, &
         & status) bind(c, name='adfric_strip_penetration')
         import :: c_double, c_int, c_int32_t, c_int64_t, c_int8_t
         implicit none (type, external)
         integer(c_int64_t), intent(in), value :: n
         real(c_double), intent(in) :: phase(*), ratio(*), stress(*), range(*), prescribed(*)
         integer(c_int8_t), intent(in) :: jumps(*), loads(*)
         real(c_double), intent(inout) :: first(*), second(*), third(*), fourth(*)
         integer(c_int32_t), intent(inout) :: status(*)
      end function c_penetration
      integer(c_int) function c_open(model, opened) bind(c, name='adfric_open')
         import :: c_char, c_int, c_int64_t
         implicit none (type, external)
         character(kind=c_char), intent(in) :: model(*)
         integer(c_int64_t), intent(out) :: opened
      end function c_open
      integer(c_int) function c_set(self, name, value) bind(c, name='adfric_set_real')
         import :: c_char, c_double, c_int, c_int64_t
         implicit none (type, external)
         integer(c_int64_t), intent(in), value :: self
         character(kind=c_char), intent(in) :: name(*)
         real(c_double), intent(in), value :: value
      end function c_set
      integer(c_int) function c_solve(self, n_threads, progress, context, found) bind(c, name='adfric_solve')
         import :: c_funptr, c_int, c_int32_t, c_int64_t, c_ptr
         implicit none (type, external)
         integer(c_int64_t), intent(in), value :: self
         integer(c_int32_t), intent(in), value :: n_threads
         type(c_funptr), intent(in), value :: progress
         type(c_ptr), intent(in), value :: context
         integer(c_int64_t), intent(out) :: found
      end function c_solve
      integer(c_int) function c_close_case(self) bind(c, name='adfric_close_case')
         import :: c_int, c_int64_t
         implicit none (type, external)
         integer(c_int64_t), intent(in), value :: self
      end function c_close_case
      integer(c_int) function c_close_results(self) bind(c, name='adfric_close_results')
         import :: c_int, c_int64_t
         implicit none (type, external)
         integer(c_int64_t), intent(in), value :: self
      end function c_close_results
   end interface

   integer, parameter :: n_repeats = 41, n_points = 4000, n_cases = 200
   real(dp), dimension(n_points) :: lambda, prescribed, ones, tens, stress, range, first, second, third, fourth
   integer(c_int8_t) :: no(n_points)
   integer :: status(n_points), table, k

   call print_heading('Calls through adfric.h beside those in Fortran')
   table = open_table(text_argument(1, 'c_calls.csv'), 'call,ns_fortran,ns_above,ns_above_least,ns_above_most')
   print '(a, t22, a, t42, a)', 'call', 'Fortran', 'above it (range)'
   lambda = 1
   ones = 1
   tens = 10
   stress = 0.05_dp
   range = 0.1_dp
   no = 0
   prescribed = [(-1 + 5.0_dp*k/n_points, k=1, n_points)]
   call report('sphere_load')
   prescribed = [(-0.5_dp + 2.0_dp*k/n_points, k=1, n_points)]
   call report('sphere_approach')
   prescribed = [(0.5_dp*k/n_points, k=1, n_points)]
   call report('strip_load')
   prescribed = [(1.0_dp*k/n_points, k=1, n_points)]
   call report('strip_penetration')
   call report_cases()
   close (table)

contains

   !> Time both calls in turn.
   subroutine report(name)
      character(*), intent(in) :: name
      real(dp) :: fortran(n_repeats), above(n_repeats), start, now
      type(spread_t) :: spread, base
      integer :: r

      do r = 1, n_repeats
         call cpu_time(start)
         call call_fortran(name)
         call cpu_time(now)
         fortran(r) = 1.0e9_dp*(now - start)/n_points
         call cpu_time(start)
         call call_c(name)
         call cpu_time(now)
         above(r) = 1.0e9_dp*(now - start)/n_points - fortran(r)
      end do
      base = spread_of(fortran)
      spread = spread_of(above)
      print '(a, t20, f9.0, a, t40, f7.1, a, f7.1, a, f7.1, a)', name, base%median, ' ns', spread%median, ' ns (', spread%least, &
         & ' to', spread%most, ')'
      write (table, '(a, 4('','', f0.2))') name, base%median, spread%median, spread%least, spread%most
      flush (output_unit)
   end subroutine report

   !> The call in Fortran.
   subroutine call_fortran(name)
      character(*), intent(in) :: name

      select case (name)
      case ('sphere_load')
         call solve_sphere_load(lambda, prescribed, first, second, third, status, no /= 0)
      case ('sphere_approach')
         call solve_sphere_approach(lambda, prescribed, first, second, third, status, no /= 0)
      case ('strip_load')
         call solve_strip_load(ones, tens, stress, range, prescribed, first, second, third, fourth, status, no /= 0, no /= 0)
      case default
         call solve_strip_penetration(ones, tens, stress, range, prescribed, first, second, third, fourth, status, no /= 0, no /= 0)
      end select
   end subroutine call_fortran

   !> The same by adfric.h.
   subroutine call_c(name)
      character(*), intent(in) :: name
      integer(c_int64_t), parameter :: n = n_points
      integer(c_int) :: outcome

      select case (name)
      case ('sphere_load')
         outcome = c_sphere(n, lambda, prescribed, no, first, second, third, status)
      case ('sphere_approach')
         outcome = c_approach(n, lambda, prescribed, no, first, second, third, status)
      case ('strip_load')
         outcome = c_strip(n, ones, tens, stress, range, prescribed, no, no, first, second, third, fourth, status)
      case default
         outcome = c_penetration(n, ones, tens, stress, range, prescribed, no, no, first, second, third, fourth, status)
      end select
      if (outcome /= 0) error stop 'a batch is refused'
   end subroutine call_c

   !> Time of a case of one point, from its opening to its end.
   subroutine report_cases()
      real(dp) :: times(n_repeats), start, now
      type(spread_t) :: spread
      integer :: r, i

      do r = 1, n_repeats
         call cpu_time(start)
         do i = 1, n_cases
            call solve_case()
         end do
         call cpu_time(now)
         times(r) = 1.0e6_dp*(now - start)/n_cases
      end do
      spread = spread_of(times)
      print '(a, f0.1, a, f0.1, a, f0.1, a)', 'a case of one sphere, opened, set, solved and closed: ', spread%median, ' us (', &
         & spread%least, ' to ', spread%most, ')'
   end subroutine report_cases

   !> A sphere under a load.
   subroutine solve_case()
      integer(c_int64_t) :: tip, found
      integer(c_int) :: outcome(8)

      outcome(1) = c_open('sphere'//c_null_char, tip)
      outcome(2) = c_set(tip, 'radius'//c_null_char, 1.0e-6_dp)
      outcome(3) = c_set(tip, 'contact_modulus'//c_null_char, 1.0e9_dp)
      outcome(4) = c_set(tip, 'work_of_adhesion'//c_null_char, 0.0_dp)
      outcome(5) = c_set(tip, 'load'//c_null_char, 1.0e-6_dp)
      outcome(6) = c_solve(tip, 1_c_int32_t, c_null_funptr, c_null_ptr, found)
      outcome(7) = c_close_results(found)
      outcome(8) = c_close_case(tip)
      if (any(outcome /= 0)) error stop 'a case is refused'
   end subroutine solve_case

end program c_calls

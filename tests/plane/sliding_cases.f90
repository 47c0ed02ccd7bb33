! SPDX-License-Identifier: GPL-3.0-or-later
! Solids of tables, and modes of the pressure of a sliding wave.
module sliding_cases
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_solid_prony, only: prony_t, new_prony
   use adfric_plane_sliding_solid, only: sliding_solid_t, new_sliding_solid
   use adfric_plane_sliding_wave, only: wave_contact_t
   use adfric_plane_sliding_wave_profile, only: sliding_wave_pressure
   implicit none (type, external)
   private
   public :: solid_of, prony_of_cells, named_prony, pressure_samples_t, sample_pressure, pressure_mode, complex_ratio

   !> Pressures at positions of a contact, with weights whose sum makes a mean over the period.
   type :: pressure_samples_t
      !> Positions, from a crest.
      real(dp), allocatable :: x(:)
      !> Pressures times weights.
      real(dp), allocatable :: share(:)
   end type pressure_samples_t

contains

   !> A solid with relaxed modulus 1.
   type(sliding_solid_t) function solid_of(moduli, times, speed) result(solid)
      real(dp), intent(in) :: moduli(:), times(:), speed
      type(prony_t) :: prony

      call new_prony(prony, 1.0_dp, moduli, times)
      call new_sliding_solid(solid, prony, speed)
   end function solid_of

   !> A spectrum with relaxed modulus 1 from two cells of a table, lists with blanks.
   type(prony_t) function prony_of_cells(moduli, times) result(prony)
      character(*), intent(in) :: moduli, times
      real(dp) :: numbers(20), other(20)
      integer :: n, i

      n = 1
      do i = 1, len_trim(moduli)
         if (moduli(i:i) == ' ') n = n + 1
      end do
      read (moduli, *) numbers(:n)
      read (times, *) other(:n)
      call new_prony(prony, 1.0_dp, numbers(:n), other(:n))
   end function prony_of_cells

   !> A spectrum by its name in `visco_full_contact_prony`.
   type(prony_t) function named_prony(name) result(prony)
      character(*), intent(in) :: name
      integer :: i

      select case (name)
      case ('sls10')
         call new_prony(prony, 1.0_dp, [9.0_dp], [1.0_dp])
      case ('three')
         call new_prony(prony, 1.0_dp, [1.0_dp, 3.0_dp, 5.0_dp], [10.0_dp, 1.0_dp, 0.1_dp])
      case default
         call new_prony(prony, 1.0_dp, [(sqrt(2.0_dp)**i, i=0, 12)], [(10.0_dp**(3 - i), i=0, 12)])
      end select
   end function named_prony

   !> Midpoints of an angle, of which y is a smooth function that dwells at the edges. The error falls faster than any power of their number.
   type(pressure_samples_t) function sample_pressure(solid, contact, n) result(samples)
      type(sliding_solid_t), intent(in) :: solid
      type(wave_contact_t), intent(in) :: contact
      integer, intent(in) :: n
      real(dp) :: theta, inner, y
      integer :: i

      allocate (samples%x(n), samples%share(n))
      do i = 1, n
         theta = pi*(i - 0.5_dp)/n - pi/2
         inner = theta + 0.5_dp*sin(2*theta)
         y = 2*asin(contact%sine*sin(inner))
         samples%x(i) = y + contact%shift%shift
         samples%share(i) = sliding_wave_pressure(solid, contact, samples%x(i)) &
            & *(2*contact%sine*cos(inner)/cos(y/2))*(1 + cos(2*theta))/(2*n)
      end do
   end function sample_pressure

   !> Mean of p exp(-i k x).
   complex(dp) function pressure_mode(samples, k)
      type(pressure_samples_t), intent(in) :: samples
      integer, intent(in) :: k

      pressure_mode = sum(samples%share*exp(cmplx(0.0_dp, -k*samples%x, dp)))
   end function pressure_mode

   !> E(-k V)/E0, which the mode exp(i k x) meets.
   complex(dp) function complex_ratio(solid, k)
      type(sliding_solid_t), intent(in) :: solid
      integer, intent(in) :: k

      complex_ratio = 1 + sum(solid%ratios*cmplx(0.0_dp, -k*solid%relaxation, dp)/cmplx(1.0_dp, -k*solid%relaxation, dp))
   end function complex_ratio

end module sliding_cases

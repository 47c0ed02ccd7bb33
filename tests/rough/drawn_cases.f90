! SPDX-License-Identifier: GPL-3.0-or-later
!> Surfaces that a seed draws, for tests of the model `spectrum_elastic`.
module drawn_cases
   use adfric_base_kinds, only: dp
   use trial_case, only: new_case, trial_case_t
   implicit none (type, external)
   private
   public :: new_surface, length

   !> Period, and longest wave [m].
   real(dp), parameter :: length = 1.0e-5_dp

contains

   !> A surface of 4 to 16 waves in a period, pressed.
   subroutine new_surface(case, metre, pascal, seed)
      type(trial_case_t), intent(out) :: case
      real(dp), intent(in) :: metre, pascal
      integer, intent(in) :: seed

      call new_case(case, 'spectrum_elastic')
      call case%give('hurst_exponent', 0.8_dp)
      call case%give('longest_wavelength', length*metre)
      call case%give('rolloff_wavelength', length/4*metre)
      call case%give('shortest_wavelength', length/16*metre)
      call case%give('root_mean_square_slope', 0.1_dp)
      call case%give('length_x', length*metre)
      call case%give('seed', real(seed, dp))
      call case%give('cells', 64.0_dp)
      call case%give('contact_modulus', 1.0e9_dp*pascal)
      call case%give('mean_pressure', 1.0e7_dp*pascal)
   end subroutine new_surface

end module drawn_cases

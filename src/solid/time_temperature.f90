! SPDX-License-Identifier: GPL-3.0-or-later
!> How temperature shifts all relaxation times of a solid by one factor a_T, with its moduli kept: tau_i(T) = a_T tau_i(T0).
!>
!> WLF (M. L. Williams, R. F. Landel, J. D. Ferry, J. Am. Chem. Soc. 77, 3701, 1955):
!> $$ \log_{10} a_T = -\frac{c_1 (T - T_0)}{c_2 + T - T_0}, $$
!> which has its pole below T0, where the solid has become a glass. Arrhenius, with the gas constant R:
!> $$ \ln a_T = \frac{E_a}{R} \left(\frac{1}{T} - \frac{1}{T_0}\right). $$
module adfric_solid_time_temperature
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: time_temperature_t, get_shift_factor, log_slope, shift_none, shift_wlf, shift_arrhenius, gas_constant

   !> Laws of the shift: none, so that a_T = 1; WLF; Arrhenius.
   integer, parameter :: shift_none = 0, shift_wlf = 1, shift_arrhenius = 2
   !> Gas constant R [J/(mol K)]: the product of the Boltzmann and the Avogadro constant, exact since 2019.
   real(dp), parameter :: gas_constant = 8.31446261815324_dp
   !> Largest |log10 a_T|: beyond it times shifted by the factor leave the range of numbers.
   real(dp), parameter :: most_decades = 200.0_dp

   !> A law of the shift with its constants.
   type :: time_temperature_t
      !> The law, one of `shift_...`.
      integer :: law = shift_none
      !> Temperature T0 at which the times were measured [K], > 0.
      real(dp) :: reference_temperature = 298.15_dp
      !> Constant c1 of WLF [-], >= 0.
      real(dp) :: c1 = 0
      !> Constant c2 of WLF [K], > 0.
      real(dp) :: c2 = 1
      !> Activation energy Ea of Arrhenius [J/mol], >= 0.
      real(dp) :: activation_energy = 0
   contains
      procedure :: get_shift_factor
      procedure :: log_slope
   end type time_temperature_t

contains

   !> The factor a_T of all relaxation times at a temperature.
   elemental subroutine get_shift_factor(self, temperature, factor, is_valid)
      class(time_temperature_t), intent(in) :: self
      !> Temperature T [K].
      real(dp), intent(in) :: temperature
      !> The factor a_T [-], > 0; 1 where it is not valid.
      real(dp), intent(out) :: factor
      !> Does the law hold at the temperature? False at T <= 0, of WLF at c2 + T - T0 <= 0, and where |log10 a_T| exceeds 200.
      logical, intent(out) :: is_valid
      real(dp) :: decades

      factor = 1
      is_valid = temperature > 0
      if (.not. is_valid) return
      associate (warmer => temperature - self%reference_temperature)
         select case (self%law)
         case (shift_wlf)
            is_valid = self%c2 + warmer > 0
            if (.not. is_valid) return
            is_valid = self%c1*abs(warmer) <= most_decades*(self%c2 + warmer)
            if (is_valid) factor = 10.0_dp**(-self%c1*warmer/(self%c2 + warmer))
         case (shift_arrhenius)
            decades = self%activation_energy/(gas_constant*log(10.0_dp))*(warmer/self%reference_temperature)
            is_valid = abs(decades) <= most_decades*temperature
            if (is_valid) factor = 10.0_dp**(-decades/temperature)
         end select
      end associate
   end subroutine get_shift_factor

   !> d ln a_T/dT at a temperature at which the law holds [1/K].
   elemental real(dp) function log_slope(self, temperature)
      class(time_temperature_t), intent(in) :: self
      !> Temperature T [K].
      real(dp), intent(in) :: temperature

      log_slope = 0
      if (self%law == shift_wlf) log_slope = -log(10.0_dp)*self%c1*self%c2/(self%c2 + temperature - self%reference_temperature)**2
      if (self%law == shift_arrhenius) log_slope = -self%activation_energy/(gas_constant*temperature**2)
   end function log_slope

end module adfric_solid_time_temperature

! SPDX-License-Identifier: GPL-3.0-or-later
!> Laws of the shear stress tau of an interface over the slip velocity v, the pressure p and the temperature T.
!>
!> With the factor a_T by which the temperature shifts the interface's own times (`adfric_solid_time_temperature`):
!>
!> - constant:  tau0, at every v and T;
!> - power:  tau0 (v a_T/v0)^n;
!> - activated (Eyring):  (kT/phi) arsinh[(v/(2 v0)) exp((Q + p Om)/kT)], whose barrier falls linearly with the stress;
!> - activated with `barrier_power` 3/2 (Prandtl and Tomlinson): the mean stress at escape (`adfric_interface_escape_stress`) of the
!>   barrier Q + p Om, with v/v0 for the ramp over the attempts;
!> - bonds:  `adfric_interface_breaking_bonds`, with u = v a_T/v_b and the strength N K x_b/(1 + m);
!> - log_gaussian:  tau_p exp(-c [log10(v a_T/v_p)]^2);
!> - table:  of tau over v a_T (`adfric_interface_strength_table`).
!>
!> To each but the activated ones alpha p is added. In both activated laws (Q + p Om)/phi is the stress at which the barrier is gone.
!> All laws but the constant one and the table have 0 at v = 0: there is no static friction in them. Velocities enter by their
!> logarithms.
module adfric_interface_friction_law
   use adfric_base_kinds, only: dp
   use adfric_interface_breaking_bonds, only: get_bond_stress, hazard_constant
   use adfric_interface_escape_stress, only: get_escape_stress
   use adfric_interface_strength_table, only: strength_table_t
   use adfric_numerics_libm, only: log1p
   use adfric_solid_time_temperature, only: gas_constant, time_temperature_t
   implicit none (type, external)
   private
   public :: friction_law_t, law_constant, law_power, law_activated, law_bonds, law_log_gaussian, law_table

   !> Laws, in the order of the choice.
   integer, parameter :: law_constant = 1, law_power = 2, law_activated = 3, law_bonds = 4, law_log_gaussian = 5, law_table = 6
   !> Avogadro's constant [1/mol], exact since 2019.
   real(dp), parameter :: avogadro = 6.02214076e23_dp

   !> A law with its constants.
   type :: friction_law_t
      !> One of `law_...`.
      integer :: law = law_constant
      !> tau0 of the constant law and of the power law, strength of bonds, or peak stress of the Gaussian law [Pa].
      real(dp) :: strength = 0
      !> alpha [-], 0 in the activated laws.
      real(dp) :: pressure_factor = 0
      !> v0 of the power law and of the activated ones, speed v_b of bonds, or peak velocity of the Gaussian law [m/s], > 0.
      real(dp) :: velocity = 1
      !> n of the power law, m of bonds, or c of the Gaussian law [-], >= 0.
      real(dp) :: exponent = 0
      !> Q [J/mol] of the activated laws.
      real(dp) :: activation_energy = 0
      !> phi and Om of the activated laws [m^3].
      real(dp) :: shear_volume = 1, pressure_volume = 0
      !> Does the barrier fall with the power 3/2 of the stress?
      logical :: is_curved = .false.
      !> Hazard of bonds, one of `hazard_...`.
      integer :: hazard = hazard_constant
      !> The table.
      type(strength_table_t) :: table
      !> The law of a_T.
      type(time_temperature_t) :: shift
   contains
      procedure :: get_stress
      procedure :: depends_on_pressure
      procedure :: is_coulomb
   end type friction_law_t

contains

   !> Shear stress of the interface.
   pure subroutine get_stress(self, speed, pressure, temperature, stress, slope, is_valid)
      class(friction_law_t), intent(in) :: self
      !> |v| [m/s], >= 0.
      real(dp), intent(in) :: speed
      !> p [Pa]; in the activated laws a tension counts as 0.
      real(dp), intent(in) :: pressure
      !> T [K], > 0; counts in the activated laws and where there is a shift.
      real(dp), intent(in) :: temperature
      !> tau [Pa], >= 0.
      real(dp), intent(out) :: stress
      !> d ln tau/d ln v [-]; 0 at v = 0.
      real(dp), intent(out) :: slope
      !> Does the law hold there? Not where the shift does not, beyond the table, and in activated laws above v0.
      logical, intent(out) :: is_valid
      real(dp) :: factor, without

      stress = 0
      slope = 0
      if (self%law == law_constant) then
         is_valid = .true.
         stress = self%strength
      else if (.not. speed > 0) then
         is_valid = self%law /= law_table
      else if (self%law == law_activated) then
         call get_activated_stress(self, log(speed), max(pressure, 0.0_dp), temperature, stress, slope, is_valid)
      else
         call self%shift%get_shift_factor(temperature, factor, is_valid)
         if (is_valid) call get_shifted_stress(self, log(speed) + log(factor), stress, slope, is_valid)
      end if
      if (.not. is_valid .or. .not. self%pressure_factor > 0) return
      without = stress
      ! at an edge that pulls by tau0/alpha the sum is rounded
      stress = max(without + self%pressure_factor*pressure, 0.0_dp)
      if (stress > 0) slope = slope*(without/stress)
   end subroutine get_stress

   !> Is the stress proportional to the pressure?
   pure logical function is_coulomb(self)
      class(friction_law_t), intent(in) :: self

      is_coulomb = self%law == law_constant .and. self%pressure_factor > 0 .and. .not. self%strength > 0
   end function is_coulomb

   !> Does the stress depend on the pressure?
   pure logical function depends_on_pressure(self)
      class(friction_law_t), intent(in) :: self

      depends_on_pressure = self%law == law_activated .and. self%pressure_volume > 0
   end function depends_on_pressure

   !> Stress of a law of v a_T.
   pure subroutine get_shifted_stress(self, log_speed, stress, slope, is_valid)
      type(friction_law_t), intent(in) :: self
      !> ln(v a_T), v in m/s.
      real(dp), intent(in) :: log_speed
      real(dp), intent(out) :: stress, slope
      logical, intent(out) :: is_valid
      real(dp) :: decades, log_stress

      is_valid = .true.
      select case (self%law)
      case (law_power)
         stress = self%strength*exp(self%exponent*(log_speed - log(self%velocity)))
         slope = self%exponent
      case (law_bonds)
         call get_bond_stress(self%hazard, log_speed - log(self%velocity), self%exponent, stress, slope)
         stress = self%strength*stress
      case (law_log_gaussian)
         decades = (log_speed - log(self%velocity))/log(10.0_dp)
         stress = self%strength*exp(-self%exponent*decades**2)
         slope = -2*self%exponent*decades/log(10.0_dp)
      case default
         stress = 0
         slope = 0
         is_valid = self%table%covers(log_speed)
         if (.not. is_valid) return
         call self%table%look_up(log_speed, log_stress, slope)
         stress = exp(log_stress)
      end select
   end subroutine get_shifted_stress

   !> Stress of an activated law.
   pure subroutine get_activated_stress(self, log_speed, pressure, temperature, stress, slope, is_valid)
      type(friction_law_t), intent(in) :: self
      !> ln v, v in m/s.
      real(dp), intent(in) :: log_speed
      !> p [Pa], >= 0, and T [K].
      real(dp), intent(in) :: pressure, temperature
      real(dp), intent(out) :: stress, slope
      logical, intent(out) :: is_valid
      real(dp) :: thermal, barrier, log_rate

      stress = 0
      slope = 0
      log_rate = log_speed - log(self%velocity)
      is_valid = temperature > 0 .and. .not. log_rate > 0
      if (.not. is_valid) return
      ! kT [J], and the barrier over it
      thermal = gas_constant/avogadro*temperature
      barrier = self%activation_energy/(gas_constant*temperature) + pressure*self%pressure_volume/thermal
      if (self%is_curved) then
         call get_escape_stress(barrier, log_rate, stress, slope)
         stress = thermal*barrier/self%shear_volume*stress
      else
         call get_arsinh(log_rate + barrier, stress, slope)
         stress = thermal/self%shear_volume*stress
      end if
   end subroutine get_activated_stress

   !> arsinh(e^y/2), and d ln arsinh/dy.
   pure subroutine get_arsinh(y, value, slope)
      real(dp), intent(in) :: y
      real(dp), intent(out) :: value, slope
      real(dp) :: x

      if (y > 0) then
         ! y + ln((1 + sqrt(1 + 4 e^(-2 y)))/2), which has no large numbers
         x = 4*exp(-2*y)
         value = y + log1p(x/(2*(1 + sqrt(1 + x))))
         slope = 1/(sqrt(1 + x)*value)
      else
         x = exp(y)/2
         value = asinh(x)
         slope = 1
         if (x > 0) slope = x/(sqrt(1 + x**2)*value)
      end if
   end subroutine get_arsinh

end module adfric_interface_friction_law

! SPDX-License-Identifier: GPL-3.0-or-later
!> The temperature of a contact that heats itself: states of T = T0 + sum of w_i tau(p_i, v, T).
!>
!> The shear stress tau makes the heat v tau where it acts, and heat raises the temperature in proportion. So the weights w_i
!> [K/Pa] tell by how much a shear stress at each position, or in each cell, warms the contact in the mean. The law has the mean
!> temperature of the contact everywhere.
!>
!> States are where f(T) = T - T0 - sum of w_i tau is 0. f is below 0 at T0, and above 0 at T0 + sum of w_i times the largest stress.
!> Between nodes it is looked for changes of sign, and for a least or largest value on the other side of 0. Of the law log_gaussian
!> no state is missed: the changes of its curvature are nodes, so there are three states at most (docs/theory/heat.md).
module adfric_interface_thermal_states
   use adfric_base_kinds, only: dp
   use adfric_interface_friction_law, only: friction_law_t, law_activated, law_constant, law_log_gaussian, law_power
   use adfric_numerics_scalar_root, only: equation_t, find_root
   use adfric_solid_time_temperature, only: gas_constant, shift_arrhenius, shift_wlf
   implicit none (type, external)
   private
   public :: heated_contact_t, thermal_states_t, most_states

   !> Most states that are kept.
   integer, parameter :: most_states = 9
   !> Cells between the coldest and the hottest temperature, and cells of the search for the largest stress.
   integer, parameter :: n_cells = 240, n_samples = 400
   !> By how much the largest of the samples is raised.
   real(dp), parameter :: above_samples = 1.01_dp
   !> Step of differences, over the temperature.
   real(dp), parameter :: small_step = 1.0e-4_dp

   !> States, from cold to hot.
   type :: thermal_states_t
      !> Their number.
      integer :: n = 0
      !> Temperatures of the contact [K], and the change of T0 + sum of w_i tau with T there [-]; above 1 the state is not stable.
      real(dp) :: temperature(most_states) = 0, gain(most_states) = 0
   end type thermal_states_t

   !> f(T), or its slope.
   type, extends(equation_t) :: heated_contact_t
      !> The law of the interface.
      type(friction_law_t) :: law
      !> Speed [m/s], >= 0.
      real(dp) :: speed = 0
      !> T0: temperature of the contact without heat of its shear [K].
      real(dp) :: base = 0
      !> Pressure [Pa] and weight [K/Pa], >= 0 in sum, of each cell or node of the contact; shape `(n)`.
      real(dp), allocatable :: pressure(:), weights(:)
      !> Is the slope looked for, and not the value?
      logical, private :: is_slope = .false.
   contains
      procedure :: find_states
      procedure :: evaluate
      procedure, private :: get_rise
      procedure, private :: get_excess
      procedure, private :: largest_rise
      procedure, private :: add_inflections
      procedure, private :: search_between
      procedure, private :: search_cell
      procedure, private :: add_state
   end type heated_contact_t

contains

   !> All states.
   pure subroutine find_states(self, states, is_converged)
      class(heated_contact_t), intent(in) :: self
      !> Receives the states.
      type(thermal_states_t), intent(out) :: states
      !> Was each of them found, and at least one? Not where the law does not hold at a temperature between T0 and the hottest one.
      logical, intent(out) :: is_converged
      real(dp) :: value, slope, largest
      real(dp), allocatable :: nodes(:)
      integer :: k

      call self%get_excess(self%base, value, slope, is_converged)
      if (.not. is_converged) return
      if (.not. -value > spacing(self%base)/2) then
         ! no heat, or so little that it is below round-off
         call self%add_state(self%base, states, is_converged)
         return
      end if
      largest = self%largest_rise(-value)
      nodes = [(self%base + largest*(real(k, dp)/n_cells)**3, k=0, n_cells)]
      nodes(n_cells + 1) = max(nodes(n_cells + 1), self%base*(1 + 4*epsilon(1.0_dp)))
      ! a law that falls with T has one state, which one cell brackets
      if (any(self%law%law == [law_constant, law_power, law_activated])) nodes = [self%base, nodes(n_cells + 1)]
      if (self%law%law == law_log_gaussian) call self%add_inflections(nodes)
      call self%search_between(nodes, states, is_converged)
      is_converged = is_converged .and. states%n > 0
   end subroutine find_states

   !> f(T), or its slope; see `equation_t`.
   pure subroutine evaluate(self, x, value, slope)
      class(heated_contact_t), intent(in) :: self
      !> Temperature [K].
      real(dp), intent(in) :: x
      !> f [K], or its slope [-].
      real(dp), intent(out) :: value
      !> Change of it with T.
      real(dp), intent(out) :: slope
      real(dp) :: other
      logical :: is_valid

      call self%get_excess(x, value, slope, is_valid)
      if (self%is_slope) then
         value = slope
         associate (h => small_step*x)
            call self%get_excess(x + h, other, slope, is_valid)
            slope = (slope - value)/h
         end associate
      end if
   end subroutine evaluate

   !> f(T) and its slope.
   pure subroutine get_excess(self, temperature, value, slope, is_valid)
      class(heated_contact_t), intent(in) :: self
      !> T [K].
      real(dp), intent(in) :: temperature
      !> f [K], and its slope [-].
      real(dp), intent(out) :: value, slope
      !> Does the law hold there? Else the value is that without heat.
      logical, intent(out) :: is_valid
      real(dp) :: rise, change, warmer, colder, h
      logical :: holds

      value = temperature - self%base
      slope = 1
      call self%get_rise(temperature, rise, change, is_valid)
      if (.not. is_valid) return
      value = value - rise
      if (self%law%law == law_activated) then
         h = small_step*temperature
         call self%get_rise(temperature + h, warmer, change, holds)
         call self%get_rise(temperature - h, colder, change, holds)
         change = (warmer - colder)/(2*h)
      end if
      slope = slope - change
   end subroutine get_excess

   !> sum of w_i tau and, but for activated laws, its change with T.
   pure subroutine get_rise(self, temperature, rise, change, is_valid)
      class(heated_contact_t), intent(in) :: self
      !> T [K].
      real(dp), intent(in) :: temperature
      !> The sum [K], and its change with T [-].
      real(dp), intent(out) :: rise, change
      !> Does the law hold there?
      logical, intent(out) :: is_valid
      real(dp) :: stress, slope
      integer :: i

      rise = 0
      change = 0
      is_valid = .true.
      if (self%law%depends_on_pressure()) then
         do i = 1, size(self%weights)
            call self%law%get_stress(self%speed, self%pressure(i), temperature, stress, slope, is_valid)
            if (.not. is_valid) return
            rise = rise + self%weights(i)*stress
         end do
         return
      end if
      call self%law%get_stress(self%speed, 0.0_dp, temperature, stress, slope, is_valid)
      if (.not. is_valid) return
      associate (weight => sum(self%weights))
         rise = weight*stress
         change = weight*stress*slope*self%law%shift%log_slope(temperature)
         if (self%law%pressure_factor > 0) rise = rise + self%law%pressure_factor*dot_product(self%weights, self%pressure)
      end associate
   end subroutine get_rise

   !> Largest rise at any temperature above T0 [K].
   pure real(dp) function largest_rise(self, at_base) result(largest)
      class(heated_contact_t), intent(in) :: self
      !> Rise at T0 [K].
      real(dp), intent(in) :: at_base
      real(dp) :: rise, change
      logical :: is_valid
      integer :: k

      largest = at_base
      if (any(self%law%law == [law_constant, law_power, law_activated])) return
      if (self%law%law == law_log_gaussian) then
         largest = self%law%strength*sum(self%weights)
         if (self%law%pressure_factor > 0) largest = largest + self%law%pressure_factor*dot_product(self%weights, self%pressure)
         return
      end if
      do k = 1, n_samples
         call self%get_rise(self%base*(1 + (real(k, dp)/(n_samples + 1 - k))**2), rise, change, is_valid)
         if (is_valid) largest = max(largest, rise)
      end do
      largest = above_samples*largest
   end function largest_rise

   !> Add the temperatures at which d2 tau/dT2 changes its sign.
   pure subroutine add_inflections(self, nodes)
      class(heated_contact_t), intent(in) :: self
      !> In: rising temperatures [K]. Out: with those between them, rising.
      real(dp), allocatable, intent(inout) :: nodes(:)
      real(dp) :: hot, rate, pole, c, low, high, y(4), middle, temperature
      integer :: i, k

      associate (law => self%law)
         c = law%exponent
         hot = log10(self%speed/law%velocity)
         if (law%shift%law == shift_wlf) then
            hot = hot - law%shift%c1
            rate = law%shift%c1*law%shift%c2
            pole = law%shift%reference_temperature - law%shift%c2
         else if (law%shift%law == shift_arrhenius) then
            rate = law%shift%activation_energy/(gas_constant*log(10.0_dp))
            hot = hot - rate/law%shift%reference_temperature
            pole = 0
         else
            return
         end if
      end associate
      if (.not. (c > 0 .and. rate > 0)) return
      ! between the y of both ends h has no more than one root in each of the pieces that its largest and least value make
      associate (root => sqrt((2*c*hot)**2 + 18*c))
         y = [hot + rate/(nodes(size(nodes)) - pole), (2*c*hot - root)/(6*c), (2*c*hot + root)/(6*c), hot + rate/(nodes(1) - pole)]
      end associate
      y(2:3) = min(max(y(2:3), y(1)), y(4))
      do i = 1, 3
         low = y(i)
         high = y(i + 1)
         if (.not. (curvature(low) < 0 .neqv. curvature(high) < 0)) cycle
         do k = 1, 100
            middle = (low + high)/2
            if (curvature(middle) < 0 .eqv. curvature(low) < 0) then
               low = middle
            else
               high = middle
            end if
         end do
         temperature = pole + rate/(low - hot)
         if (.not. (temperature > nodes(1) .and. temperature < nodes(size(nodes)))) cycle
         nodes = [pack(nodes, nodes < temperature), temperature, pack(nodes, nodes > temperature)]
      end do

   contains

      !> What has the sign of d2 tau/dT2.
      pure real(dp) function curvature(at)
         !> y [-].
         real(dp), intent(in) :: at

         curvature = 2*c*at**3 - 2*c*hot*at**2 - 3*at + hot
      end function curvature

   end subroutine add_inflections

   !> States between nodes.
   pure subroutine search_between(self, nodes, states, is_converged)
      class(heated_contact_t), intent(in) :: self
      !> Temperatures, rising [K].
      real(dp), intent(in) :: nodes(:)
      !> Receives the states.
      type(thermal_states_t), intent(inout) :: states
      !> Was each of them found?
      logical, intent(inout) :: is_converged
      real(dp) :: ends(2), values(2), slopes(2)
      integer :: k

      ends(1) = nodes(1)
      call self%get_excess(ends(1), values(1), slopes(1), is_converged)
      do k = 2, size(nodes)
         if (.not. nodes(k) > ends(1)) cycle
         ends(2) = nodes(k)
         call self%get_excess(ends(2), values(2), slopes(2), is_converged)
         if (.not. is_converged) return
         call self%search_cell(ends, values, slopes, states, is_converged)
         if (.not. is_converged) return
         ends(1) = ends(2)
         values(1) = values(2)
         slopes(1) = slopes(2)
      end do
      ! the hottest temperature is a state where no more than rounding is between both
      if (states%n == 0 .and. abs(values(2)) <= 8*epsilon(1.0_dp)*ends(2)) call self%add_state(ends(2), states, is_converged)
   end subroutine search_between

   !> States in a cell.
   pure subroutine search_cell(self, ends, values, slopes, states, is_converged)
      class(heated_contact_t), intent(in) :: self
      !> Temperatures at its ends [K], f there, and the slopes of f.
      real(dp), intent(in) :: ends(2), values(2), slopes(2)
      !> Receives the states.
      type(thermal_states_t), intent(inout) :: states
      !> Was each of them found?
      logical, intent(out) :: is_converged
      type(heated_contact_t) :: derivative
      real(dp) :: x, turn, value, slope

      is_converged = .true.
      if (values(1) < 0 .neqv. values(2) < 0) then
         x = ends(1)
         call find_root(self, ends(1), ends(2), values(1) < 0, x, is_converged)
         if (is_converged) call self%add_state(x, states, is_converged)
         return
      end if
      ! f turns towards 0 and back: it may pass 0 twice
      if (.not. (slopes(1)*values(1) < 0 .and. slopes(2)*values(2) > 0)) return
      derivative = self
      derivative%is_slope = .true.
      turn = ends(1)
      call find_root(derivative, ends(1), ends(2), slopes(1) < 0, turn, is_converged)
      if (.not. is_converged) return
      call self%evaluate(turn, value, slope)
      if (value < 0 .eqv. values(1) < 0) return
      x = ends(1)
      call find_root(self, ends(1), turn, values(1) < 0, x, is_converged)
      if (is_converged) call self%add_state(x, states, is_converged)
      if (.not. is_converged) return
      x = ends(2)
      call find_root(self, turn, ends(2), value < 0, x, is_converged)
      if (is_converged) call self%add_state(x, states, is_converged)
   end subroutine search_cell

   !> Add a state.
   pure subroutine add_state(self, temperature, states, is_converged)
      class(heated_contact_t), intent(in) :: self
      !> Its temperature [K].
      real(dp), intent(in) :: temperature
      !> Receives the state.
      type(thermal_states_t), intent(inout) :: states
      !> Does the law hold there, and is there space for the state?
      logical, intent(out) :: is_converged
      real(dp) :: value, slope

      call self%get_excess(temperature, value, slope, is_converged)
      is_converged = is_converged .and. states%n < most_states
      if (.not. is_converged) return
      states%n = states%n + 1
      states%temperature(states%n) = temperature
      states%gain(states%n) = 1 - slope
   end subroutine add_state

end module adfric_interface_thermal_states

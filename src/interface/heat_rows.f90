! SPDX-License-Identifier: GPL-3.0-or-later
!> Heat of the slip as an input gives it: rows of the group `heat`, and the results that go with them. Without the group a scene is
!> isothermal.
module adfric_interface_heat_rows
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set, unset
   use adfric_interface_friction_law, only: friction_law_t
   use adfric_interface_heat_sources, only: largest_of_disc
   use adfric_interface_thermal_states, only: heated_contact_t, thermal_states_t
   use adfric_describe_check, only: require
   use adfric_describe_rows, only: above_zero, any_number, choice, result_row
   use adfric_describe_table, only: result_t, variable_t
   implicit none (type, external)
   private
   public :: heat_t, set_heat_rows, has_heat, get_heat, check_heat, heat_results, doubt_heat, velocity_that_heats
   public :: usual_capacity, usual_conductivity
   public :: n_heat_rows, n_heat_results, h_contact, h_flash, h_peak, h_background, h_gain, h_states, h_share, h_bulk, h_interface

   !> Indices among the rows.
   integer, parameter :: conductivity = 1, density = 2, capacity = 3, second = 4, background = 5, slab = 6, time = 7, branch = 8
   integer, parameter :: n_heat_rows = branch
   !> Words of `background`, in the order of the choice.
   integer, parameter :: as_prescribed = 1, of_slab = 2, of_time = 3
   !> The word `hot` of `thermal_branch`.
   integer, parameter :: is_hot = 2
   !> Indices among the results.
   integer, parameter :: h_contact = 1, h_flash = 2, h_peak = 3, h_background = 4, h_gain = 5, h_states = 6, h_share = 7, &
      & h_bulk = 8, h_interface = 9
   integer, parameter :: n_heat_results = h_interface
   !> Change of the shear stress that matters, and steps of the search for its velocity, in decades.
   real(dp), parameter :: change_that_matters = 0.01_dp, first_decade = -12.0_dp, last_decade = 4.0_dp, step_of_decades = 0.01_dp
   !> Conductivity [W/m/K] and heat capacity per volume [J/m^3/K] of polymers, as numbers go.
   real(dp), parameter :: usual_conductivity = 0.2_dp, usual_capacity = 2.0e6_dp

   !> What an input says of heat.
   type :: heat_t
      !> Conductivity [W/m/K] and diffusivity [m^2/s] of the solid; conductivity of the other body.
      real(dp) :: conductivity = 1, diffusivity = 1, second_conductivity = 0
      !> Rise of the background over the heat that goes into the solid, over nominal area [m^2 K/W].
      real(dp) :: background = 0
      !> Of several states, is it the hottest one?
      logical :: is_hot = .false.
   contains
      procedure :: settle
   end type heat_t

contains

   !> The rows.
   subroutine set_heat_rows(rows)
      !> Receives the rows; shape `(n_heat_rows)`.
      type(variable_t), intent(out) :: rows(:)
      character(*), parameter :: group = 'heat'

      rows(conductivity) = above_zero(group=group, name='conductivity', unit='W/m/K', meaning='thermal conductivity of the solid')
      rows(density) = above_zero(group=group, name='density', unit='kg/m^3', meaning='density of the solid')
      rows(capacity) = above_zero(group=group, name='heat_capacity', unit='J/kg/K', meaning='specific heat capacity of the solid')
      rows(second) = any_number(group=group, name='second_conductivity', unit='W/m/K', lower=0.0_dp, &
         & meaning='thermal conductivity of the body that slides; 0: all heat goes into the solid')
      rows(background) = choice(group=group, name='background', choices='prescribed slab time', &
         & meaning='temperature of the surface but for flashes: temperature (prescribed, if not given), or with the rise over ' &
         & //'a slab on a base of this temperature (slab), or after a time of sliding (time)')
      rows(slab) = above_zero(group=group, name='slab_thickness', unit='m', &
         & meaning='thickness of the slab; that of the layer if not given')
      rows(time) = above_zero(group=group, name='sliding_time', unit='s', meaning='time since the body began to slide')
      rows(branch) = choice(group=group, name='thermal_branch', choices='cold hot', &
         & meaning='which of several temperatures of contact: the lowest (cold, if not given) or the highest')
   end subroutine set_heat_rows

   !> Does heat count?
   pure logical function has_heat(values)
      !> Values of the rows; shape `(n_heat_rows)`.
      real(dp), intent(in) :: values(:)

      has_heat = any(is_set(values))
   end function has_heat

   !> What checked values say.
   pure subroutine get_heat(values, thickness, heat)
      !> Values of the rows; shape `(n_heat_rows)`.
      real(dp), intent(in) :: values(:)
      !> Thickness of the layer [m], or unset.
      real(dp), intent(in) :: thickness
      !> Receives the heat.
      type(heat_t), intent(out) :: heat

      heat%conductivity = values(conductivity)
      heat%diffusivity = values(conductivity)/values(density)/values(capacity)
      heat%second_conductivity = values(second)
      select case (background_of(values))
      case (of_slab)
         heat%background = merge(values(slab), thickness, is_set(values(slab)))/values(conductivity)
      case (of_time)
         heat%background = 2*sqrt(values(time)/(pi*values(conductivity)*values(density)*values(capacity)))
      end select
      if (is_set(values(branch))) heat%is_hot = nint(values(branch)) == is_hot
   end subroutine get_heat

   !> The temperature of a contact that heats itself, and the results that are known with it. Until heat is found the peak is 0, and
   !> there is no share.
   pure subroutine settle(self, contact, temperature, results, is_valid)
      class(heat_t), intent(in) :: self
      !> The contact, with its weights.
      type(heated_contact_t), intent(in) :: contact
      !> Out: mean temperature of the contact [K]; as it was where the states are not found.
      real(dp), intent(inout) :: temperature
      !> Receives the results; shape `(n_heat_results)`.
      real(dp), intent(inout) :: results(:)
      !> Were the states found?
      logical, intent(out) :: is_valid
      type(thermal_states_t) :: states
      integer :: i

      call contact%find_states(states, is_valid)
      if (.not. is_valid) return
      i = merge(states%n, 1, self%is_hot)
      temperature = states%temperature(i)
      results([h_contact, h_gain, h_states]) = [temperature, states%gain(i), real(states%n, dp)]
      results([h_flash, h_peak, h_share]) = [temperature - contact%base, 0.0_dp, not_a_number()]
   end subroutine settle

   !> Which background is it?
   pure integer function background_of(values)
      real(dp), intent(in) :: values(:)

      background_of = as_prescribed
      if (is_set(values(background))) background_of = nint(values(background))
   end function background_of

   !> Add to `problems` what is missing, or has no meaning.
   subroutine check_heat(table, values_of_table, first, of_temperature, has_friction, thickness, is_single, problems)
      !> Rows with those of the heat among them; their names stand in the messages.
      type(variable_t), intent(in) :: table(:)
      !> Values of the rows; shape of `table`.
      real(dp), intent(in) :: values_of_table(:)
      !> Index of the first row of the heat, and that of the temperature.
      integer, intent(in) :: first, of_temperature
      !> Is there friction of the interface?
      logical, intent(in) :: has_friction
      !> Thickness of the layer [m], or unset.
      real(dp), intent(in) :: thickness
      !> Is the contact a single one, a line or a circle, which has no nominal area?
      logical, intent(in) :: is_single
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: k

      associate (values => values_of_table(first:first + n_heat_rows - 1))
         if (.not. has_heat(values)) return
         k = findloc(is_set(values), .true., 1)
         if (.not. has_friction) then
            call refuse(k, 'has no meaning without a shear stress in &friction, whose work is the heat')
            return
         end if
         call require(table, values_of_table, [first - 1 + [conductivity, density, capacity, second], of_temperature], problems)
         if (is_set(values(slab)) .and. background_of(values) /= of_slab) call refuse(slab, 'has no meaning without ' &
            & //'background = ''slab''')
         if (is_set(values(time)) .and. background_of(values) /= of_time) call refuse(time, 'has no meaning without ' &
            & //'background = ''time''')
         if (background_of(values) == of_slab .and. .not. is_set(thickness) .and. .not. is_single) call require(table, &
            & values_of_table, [first - 1 + slab], problems)
         if (background_of(values) == of_time .and. .not. (is_single .or. is_set(thickness))) call require(table, &
            & values_of_table, [first - 1 + time], problems)
         if (is_set(thickness)) then
            if (background_of(values) == of_time) call refuse(background, 'is ''time'', which is for a half-space; ' &
               & //'a layer has a steady temperature, that of ''slab''')
            if (is_set(values(slab))) call refuse(slab, 'stands beside the thickness of the layer, which is ' &
               & //'that of the slab')
         end if
         if (is_single .and. background_of(values) /= as_prescribed) then
            call refuse(background, 'is not ''prescribed''; a single contact on a half-space has no nominal area whose heat ' &
               & //'would count')
         else if (background_of(values) /= as_prescribed .and. values(second) > 0 .and. is_set(values(second))) then
            call refuse(background, 'is not ''prescribed'' beside a second_conductivity above 0; how the mean heat is shared ' &
               & //'is not known')
         end if
         if (is_single .and. values(second) > 0 .and. is_set(values(second))) call refuse(second, 'is above 0; how a single ' &
            & //'contact shares its heat with the body is not in closed form')
      end associate

   contains

      !> Add a problem of one row to the list.
      subroutine refuse(row, text)
         !> Index among the rows of the heat.
         integer, intent(in) :: row
         !> What is wrong; the name is put before this.
         character(*), intent(in) :: text

         call problems%add(table(first - 1 + row)%group, table(first - 1 + row)%name, text)
      end subroutine refuse

   end subroutine check_heat

   !> The rows of the results.
   function heat_results(unit) result(rows)
      !> Unit of heat: W/m^2, or W/m of a line.
      character(*), intent(in) :: unit
      type(result_t) :: rows(n_heat_results)

      rows(h_contact) = result_row(name='contact_temperature', unit='K', &
         & long_name='mean temperature of the contact, that of the law of friction')
      rows(h_flash) = result_row(name='flash_temperature', unit='K', &
         & long_name='mean rise of the temperature in contact above that of the background')
      rows(h_peak) = result_row(name='peak_flash_temperature', unit='K', &
         & long_name='largest rise of the temperature above that of the background')
      rows(h_background) = result_row(name='background_temperature_rise', unit='K', &
         & long_name='rise of the background above the given temperature')
      rows(h_gain) = result_row(name='thermal_gain', unit='-', &
         & long_name='by how much the heat of a contact that is 1 K warmer warms it; above 1 the state is not stable')
      rows(h_states) = result_row(name='thermal_states', unit='-', &
         & long_name='number of temperatures of contact that there are at this velocity')
      rows(h_share) = result_row(name='heat_share', unit='-', &
         & long_name='share of the heat of the interface that goes into the solid')
      rows(h_bulk) = result_row(name='bulk_heat', unit=unit, long_name='heat of the losses in the solid')
      rows(h_interface) = result_row(name='interface_heat', unit=unit, long_name='heat of the shear stress in contact')
      rows(h_states)%is_counted = .true.
   end function heat_results

   !> A line on the velocity above which heat changes the shear stress by a hundredth, in contacts of a given size.
   subroutine doubt_heat(values, law, temperature, half_width, text)
      !> Values of the rows, which have been checked; shape `(n_heat_rows)`.
      real(dp), intent(in) :: values(:)
      !> The law of the interface.
      type(friction_law_t), intent(in) :: law
      !> Temperature without heat [K].
      real(dp), intent(in) :: temperature
      !> Half-width of a contact [m].
      real(dp), intent(in) :: half_width
      !> Receives the line; empty without heat.
      character(:), allocatable, intent(out) :: text
      character(250) :: line
      real(dp) :: velocity

      text = ''
      if (.not. has_heat(values)) return
      velocity = velocity_that_heats(values, law, temperature, half_width)
      if (is_set(velocity)) then
         write (line, '(2(a, es8.1), a)') 'heat changes the shear stress by a hundredth from a velocity of', velocity, &
            & ' m/s on, in contacts of the half-width', half_width, ' m, if all of it goes into the solid'
         text = trim(line)//new_line('a')
      else
         text = 'heat does not change the shear stress by a hundredth at any velocity'//new_line('a')
      end if
   end subroutine doubt_heat

   !> Velocity from which on heat changes the shear stress by a hundredth [m/s], in contacts of a given size: where
   !> |d ln tau/dT| dT reaches it, with the largest rise dT = 2 tau v a/(lambda sqrt(pi (4/pi + P))) under a disc. Without heat in the
   !> input the solid is the polymer of `usual_...`. Not set where there is no such velocity.
   real(dp) function velocity_that_heats(values, law, temperature, half_width) result(velocity)
      !> Values of the rows, which have been checked; shape `(n_heat_rows)`.
      real(dp), intent(in) :: values(:)
      !> The law of the interface.
      type(friction_law_t), intent(in) :: law
      !> Temperature without heat [K], or unset.
      real(dp), intent(in) :: temperature
      !> Half-width of a contact [m].
      real(dp), intent(in) :: half_width
      type(heat_t) :: heat
      real(dp) :: v, change
      integer :: k

      velocity = unset
      if (.not. (is_set(temperature) .and. half_width > 0)) return
      heat%conductivity = usual_conductivity
      heat%diffusivity = usual_conductivity/usual_capacity
      if (has_heat(values)) call get_heat(values, half_width, heat)
      do k = 0, nint((last_decade - first_decade)/step_of_decades)
         v = 10**(first_decade + k*step_of_decades)
         call get_change(change)
         if (.not. change > change_that_matters) cycle
         velocity = v
         return
      end do

   contains

      !> Relative change of the shear stress by the heat; 0 where the law does not hold.
      subroutine get_change(relative)
         real(dp), intent(out) :: relative
         real(dp) :: stress, warmer, slope
         logical :: holds(2)
         real(dp), parameter :: dt = 0.01_dp

         relative = 0
         call law%get_stress(v, 0.0_dp, temperature, stress, slope, holds(1))
         call law%get_stress(v, 0.0_dp, temperature + dt, warmer, slope, holds(2))
         if (.not. all(holds) .or. .not. stress > 0) return
         relative = abs(warmer - stress)/(stress*dt)*stress*v*half_width/heat%conductivity &
            & *largest_of_disc(v*half_width/(2*heat%diffusivity))
      end subroutine get_change

   end function velocity_that_heats

end module adfric_interface_heat_rows

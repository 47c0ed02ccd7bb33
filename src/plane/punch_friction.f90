! SPDX-License-Identifier: GPL-3.0-or-later
!> Friction of a rigid punch that slides along a half-plane by a shear stress tau0 + alpha p. With `coupling` and tau0 = 0 the shear
!> stress moves the contact of a flat punch or of a wedge, in closed form.
module adfric_plane_punch_friction
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_interface_friction_law, only: friction_law_t
   use adfric_interface_shear_coupling, only: coupling_results, is_coupled, n_coupling_results
   use adfric_interface_shear_strength_rows, only: check_shear, has_shear
   use adfric_interface_total_friction, only: coupling_of, n_total_results, sliding_friction_t, total_friction_results
   use adfric_plane_contact_shear, only: contact_nodes, n_contact_nodes
   use adfric_plane_coupled_line, only: coupled_punch_pressure
   use adfric_plane_coupled_wedge, only: coupled_wedge_t
   use adfric_plane_left_out_coupling, only: left_out_of_line
   use adfric_plane_punch_state, only: punch_state_t
   use adfric_describe_check, only: require
   use adfric_describe_rows, only: result_row
   use adfric_describe_table, only: result_t, variable_t
   implicit none (type, external)
   private
   public :: punch_friction_t, punch_friction_results, n_friction_results, check_punch_friction, store_punch_friction
   public :: sliding_pressure_at

   !> Catalan's constant; the squared pressure of a wedge is the squared slope of it times 8.
   real(dp), parameter :: catalan = 0.915965594177219015_dp
   !> What is round-off of a force on the slopes, over slope and load.
   real(dp), parameter :: round_off = 1.0e-12_dp
   !> Results, in their order: friction, its ratio to the load, the shift, the imbalance of the energies, parts, coupling.
   integer, parameter :: n_friction_results = 4 + n_total_results + n_coupling_results

   !> What the input says of the friction.
   type :: punch_friction_t
      !> tau0 [Pa] and alpha [-], where they are given.
      real(dp) :: shear(2) = 0
      !> Value of `coupling`, velocity [m/s], Poisson's ratio [-] and contact modulus [Pa].
      real(dp) :: coupling = 0, velocity = 0, poisson_ratio = 0, modulus = 1
   contains
      procedure :: exists
      procedure :: moves_contact
      procedure :: get_coupling
   end type punch_friction_t

contains

   !> The rows of the results.
   function punch_friction_results() result(rows)
      type(result_t) :: rows(n_friction_results)

      rows(1) = result_row(name='friction_force', unit='N/m', long_name='friction force per length of a punch that slides, with ' &
         & //'the sign of the velocity')
      rows(2) = result_row(name='friction_coefficient', unit='-', long_name='friction force over load')
      rows(3) = result_row(name='contact_shift', unit='m', long_name='middle of the contact, from that of the punch')
      rows(4) = result_row(name='energy_imbalance', unit='-', &
         & long_name='force on the slopes, from the pressure, less that by the energy, over the larger of both')
      rows(5:4 + n_total_results) = total_friction_results('force', 'N/m')
      rows(5 + n_total_results:) = coupling_results()
   end function punch_friction_results

   !> Is there friction?
   pure logical function exists(self)
      class(punch_friction_t), intent(in) :: self

      exists = has_shear(self%shear)
   end function exists

   !> Does it move the contact?
   pure logical function moves_contact(self)
      class(punch_friction_t), intent(in) :: self

      moves_contact = self%exists() .and. is_coupled(self%coupling)
   end function moves_contact

   !> m = alpha beta [-].
   pure real(dp) function get_coupling(self) result(m)
      class(punch_friction_t), intent(in) :: self

      m = self%shear(2)*coupling_of(self%poisson_ratio)
   end function get_coupling

   !> Add to `problems` what is missing or has no meaning.
   subroutine check_punch_friction(rows, self, is_closed, problems)
      !> Rows of shear strength, factor, coupling and velocity; their names stand in the messages.
      type(variable_t), intent(in) :: rows(4)
      type(punch_friction_t), intent(in) :: self
      !> Is it a flat punch, or a wedge without an end?
      logical, intent(in) :: is_closed
      type(problems_t), intent(inout) :: problems

      if (.not. self%exists()) then
         if (is_set(self%coupling)) call problems%add(rows(3)%group, rows(3)%name, &
            & 'has no meaning without a shear stress of the interface')
         if (is_set(self%velocity)) call problems%add(rows(4)%group, rows(4)%name, &
            & 'has no meaning without a shear stress of the interface')
         return
      end if
      call check_shear(rows(:2), self%shear, 0.0_dp, problems)
      if (.not. is_coupled(self%coupling)) return
      call require(rows(4:), [self%velocity], [1], problems)
      if (.not. is_set(self%poisson_ratio)) call problems%add(rows(3)%group, rows(3)%name, &
         & 'needs poisson_ratio; a contact modulus alone does not tell it')
      if (.not. is_closed) then
         call problems%add(rows(3)%group, rows(3)%name, 'has no closed form for this punch; allowed: flat punches, wedges ' &
            & //'without half_width, and cylinders without it')
      else if (self%shear(1) > 0 .or. .not. is_set(self%shear(2))) then
         call problems%add(rows(3)%group, rows(3)%name, 'stands beside a shear_strength above 0; a punch takes ' &
            & //'shear_strength = 0 and pressure_factor')
      end if
   end subroutine check_punch_friction

   !> Store the results of friction.
   pure subroutine store_punch_friction(self, state, results)
      type(punch_friction_t), intent(in) :: self
      !> The punch on its contact.
      type(punch_state_t), intent(in) :: state
      !> Receives the results, those that are known; shape `(n_friction_results)`.
      real(dp), intent(inout) :: results(:)
      type(sliding_friction_t) :: friction
      type(friction_law_t) :: law
      real(dp) :: largest, x(n_contact_nodes)

      law%strength = self%shear(1)
      if (is_set(self%shear(2))) law%pressure_factor = self%shear(2)
      friction%direction = sign(1.0_dp, self%velocity)
      associate (contact => state%contact, wedge => state%coupled)
         friction%interfacial = 2*contact%half_width*law%strength + law%pressure_factor*contact%load
         results(3:4) = 0
         if (self%moves_contact() .and. state%slope > 0) then
            friction%hysteretic = wedge%slope_friction
            results(3) = friction%direction*(wedge%ahead - wedge%behind)/2
            largest = max(abs(wedge%slope_friction), abs(wedge%friction_of_energy))
            ! without a coupling both are round-off
            if (largest > round_off*wedge%slope*wedge%load) results(4) = (wedge%slope_friction - wedge%friction_of_energy)/largest
         end if
         call friction%store(self%velocity, contact%load, results(1), results(2), results(5:4 + n_total_results))
         associate (coupling => results(5 + n_total_results:))
            if (self%moves_contact()) then
               coupling(1) = self%get_coupling()
               coupling(2) = cos(atan(self%get_coupling()))
            else if (.not. is_set(self%poisson_ratio) .or. .not. abs(results(1)) > 0) then
               coupling(3) = not_a_number()
            else if (.not. state%slope > 0 .and. .not. contact%half_width < state%face .and. size(contact%b) == 0) then
               coupling(3) = 0
            else if (contact%excess > 0) then
               ! the squared pressure of an edge has no integral
               coupling(3) = not_a_number()
            else if (state%slope > 0) then
               coupling(3) = -2*(coupling_of(self%poisson_ratio)/contact%modulus)*(law%strength*contact%load &
                  & + law%pressure_factor*(state%slope*contact%modulus/pi)**2*8*catalan*contact%half_width)/abs(results(1))
            else
               x = contact_nodes(0.0_dp, contact%half_width)
               coupling(3) = left_out_of_line(law, abs(self%velocity), 0.0_dp, state%pressure(x), contact%half_width, 0.0_dp, &
                  & self%poisson_ratio, contact%modulus, results(1))
            end if
         end associate
      end associate
   end subroutine store_punch_friction

   !> Pressure along x of a punch whose shear stress moves the contact.
   elemental real(dp) function sliding_pressure_at(self, state, x) result(pressure)
      type(punch_friction_t), intent(in) :: self
      type(punch_state_t), intent(in) :: state
      !> Position from the middle of the punch [m].
      real(dp), intent(in) :: x
      real(dp) :: ahead

      ahead = sign(1.0_dp, self%velocity)*x
      if (state%slope > 0) then
         pressure = state%coupled%wedge_pressure_at(ahead)
      else
         pressure = coupled_punch_pressure(self%get_coupling(), state%contact%half_width, state%contact%load, ahead)
         if (.not. abs(x) < state%contact%half_width .and. .not. abs(x) > state%contact%half_width) pressure = not_a_number()
      end if
   end function sliding_pressure_at

end module adfric_plane_punch_friction

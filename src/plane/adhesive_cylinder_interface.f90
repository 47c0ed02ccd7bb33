! SPDX-License-Identifier: GPL-3.0-or-later
!> Friction of an adhesive cylinder that slides over a viscoelastic half-plane with a law of the interface: the sum with what the
!> solid loses.
module adfric_plane_adhesive_cylinder_interface
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_interface_friction_law, only: friction_law_t
   use adfric_interface_friction_law_rows, only: get_friction_law, given_law_t
   use adfric_interface_total_friction, only: get_shear_of_area, interface_tractions, near_ratios, sliding_friction_t
   use adfric_plane_adhesive_cylinder_point, only: adhesive_cylinder_point_t, new_cylinder_case
   use adfric_plane_adhesive_cylinder_variables, only: in => adhesive_cylinder_input, out => adhesive_cylinder_output
   use adfric_plane_adhesive_sliding_nodes, only: get_nodes, nodes_t
   use adfric_plane_adhesive_sliding_point_of_curve, only: by_load, correct_point, curve_point_t
   use adfric_plane_adhesive_sliding_profile, only: new_slide_profile, slide_pressure, slide_profile_t
   use adfric_plane_adhesive_sliding_zones, only: adhesive_slide_t, slide_zones_t
   use adfric_solid_given_spectrum, only: given_spectrum_t
   use adfric_solid_spectrum_rows, only: solid_shift_of
   implicit none (type, external)
   private
   public :: add_adhesive_cylinder_interface, adhesive_cylinder_tractions

   !> How near positions come to the ends of a part of the contact.
   real(dp), parameter :: depth = 38
   !> Samples between which the pressure is looked at for a change of sign, and halvings of what is found.
   integer, parameter :: n_samples = 200, n_halvings = 60

contains

   !> The law of the interface.
   pure subroutine law_of_cylinder(values, spectrum, given, law)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: spectrum
      type(given_law_t), intent(in) :: given
      type(friction_law_t), intent(out) :: law

      call get_friction_law(values(in%friction), given, solid_shift_of(values(in%material(1):in%temperature), spectrum), law)
   end subroutine law_of_cylinder

   !> Add the interface to the friction of a point that has been solved.
   pure subroutine add_adhesive_cylinder_interface(values, spectrum, given, point, results, is_valid)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: spectrum
      type(given_law_t), intent(in) :: given
      type(adhesive_cylinder_point_t), intent(in) :: point
      !> In: results of the solid. Out: with both parts of the friction; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Does the law hold at this velocity and temperature?
      logical, intent(out) :: is_valid
      type(friction_law_t) :: law
      type(sliding_friction_t) :: friction

      call law_of_cylinder(values, spectrum, given, law)
      friction%direction = point%direction
      friction%hysteretic = friction%direction*results(out%friction_force)
      call get_shear(values, law, point, point%branches%slide, point%state%zones, friction%interfacial, &
         & friction%interfacial_slope, is_valid)
      if (.not. is_valid) return
      call add_neighbours(values, spectrum, law, point, friction%neighbours)
      call friction%store(values(in%velocity), values(in%load), results(out%friction_force), results(out%friction_coefficient), &
         & results(out%hysteretic_friction_force:out%velocity_slope))
   end subroutine add_adhesive_cylinder_interface

   !> Friction at velocities nearby, each from the state of the point itself; NaN where none is found.
   pure subroutine add_neighbours(values, spectrum, law, point, sums)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: spectrum
      type(friction_law_t), intent(in) :: law
      type(adhesive_cylinder_point_t), intent(in) :: point
      real(dp), intent(out) :: sums(:)
      type(adhesive_cylinder_point_t) :: other
      type(adhesive_slide_t) :: slide
      type(curve_point_t) :: start, found
      real(dp) :: shear, unused
      integer :: k
      logical :: is_solved

      sums = not_a_number()
      associate (z => point%state%zones)
         start%z = [z%middle, log(z%half_width), log(z%leading), log(z%trailing)]
      end associate
      do k = 1, size(near_ratios)
         other%material = point%material
         other%prony = point%prony
         call new_cylinder_case(values, spectrum, values(in%velocity)*near_ratios(k), other, slide)
         if (.not. other%is_possible) cycle
         found = start
         call correct_point(slide, start%z, start%z, found, is_solved, point%load, by_load)
         if (.not. is_solved) cycle
         call get_shear(values, law, point, slide, found%zones, shear, unused, is_solved)
         if (is_solved) sums(k) = abs(point%friction_unit())*found%friction + shear
      end do
   end subroutine add_neighbours

   !> Shear of a contact per length [N/m].
   pure subroutine get_shear(values, law, point, slide, zones, shear, slope, is_valid)
      real(dp), intent(in) :: values(:)
      type(friction_law_t), intent(in) :: law
      !> The point, for its units.
      type(adhesive_cylinder_point_t), intent(in) :: point
      type(adhesive_slide_t), intent(in) :: slide
      type(slide_zones_t), intent(in) :: zones
      !> The shear, and its change by ln v in this contact.
      real(dp), intent(out) :: shear, slope
      logical, intent(out) :: is_valid
      type(slide_profile_t) :: profile
      real(dp), allocatable :: ends(:)
      integer :: k

      if (.not. law%depends_on_pressure()) then
         call get_shear_of_area(law, abs(values(in%velocity)), values(in%temperature), 2*point%length*zones%half_width, &
            & values(in%load) + values(in%stress(1))*point%length*(zones%leading + zones%trailing), shear, slope, is_valid)
         return
      end if
      shear = 0
      slope = 0
      is_valid = .true.
      call new_slide_profile(slide, zones, profile)
      call find_ends(profile, ends)
      do k = 1, size(ends) - 1
         if (is_valid) call add_part(values, law, point, profile, ends(k), ends(k + 1), shear, slope, is_valid)
      end do
   end subroutine get_shear

   !> The edges of contact, and between them where the pressure changes its sign, since a tension counts as no pressure.
   pure subroutine find_ends(profile, ends)
      type(slide_profile_t), intent(in) :: profile
      !> Distances from the trailing edge, rising.
      real(dp), allocatable, intent(out) :: ends(:)
      real(dp) :: low, high, middle, last
      integer :: i, k

      associate (width => 2*profile%zones%half_width)
         ends = [0.0_dp]
         last = -1
         do i = 1, n_samples
            high = width*(1 - cos(acos(-1.0_dp)*i/(n_samples + 1)))/2
            if (sign(1.0_dp, pressure_at(high)) > last .or. sign(1.0_dp, pressure_at(high)) < last) then
               low = width*(1 - cos(acos(-1.0_dp)*(i - 1)/(n_samples + 1)))/2
               do k = 1, n_halvings
                  middle = (low + high)/2
                  if (pressure_at(middle)*last > 0) low = middle
                  if (.not. pressure_at(middle)*last > 0) high = middle
               end do
               ends = [ends, high]
               last = -last
            end if
         end do
         ends = [ends, width]
      end associate

   contains

      !> Pressure at a distance from the trailing edge.
      pure real(dp) function pressure_at(left)
         real(dp), intent(in) :: left

         pressure_at = slide_pressure(profile, left, 2*profile%zones%half_width - left)
      end function pressure_at

   end subroutine find_ends

   !> Add the shear between two positions.
   pure subroutine add_part(values, law, point, profile, from, to, shear, slope, is_valid)
      real(dp), intent(in) :: values(:)
      type(friction_law_t), intent(in) :: law
      type(adhesive_cylinder_point_t), intent(in) :: point
      type(slide_profile_t), intent(in) :: profile
      !> Distances from the trailing edge.
      real(dp), intent(in) :: from, to
      real(dp), intent(inout) :: shear, slope
      logical, intent(out) :: is_valid
      type(nodes_t) :: nodes
      real(dp) :: shortest, stress, slope_of_stress, pressure
      integer :: i

      is_valid = .true.
      associate (z => profile%zones, solid => profile%slide%solid)
         shortest = min(z%leading, z%trailing, to - from)
         if (solid%n_arms > 0) shortest = min(shortest, solid%relaxation(1))
         call get_nodes(to - from, [shortest, shortest], depth, 1.0_dp, nodes)
         do i = 1, size(nodes%weights)
            pressure = slide_pressure(profile, from + nodes%left(i), (2*z%half_width - to) + nodes%right(i))
            call law%get_stress(abs(values(in%velocity)), point%pressure_unit()*pressure, values(in%temperature), stress, &
               & slope_of_stress, is_valid)
            if (.not. is_valid) return
            shear = shear + point%length*nodes%weights(i)*stress
            slope = slope + point%length*nodes%weights(i)*stress*slope_of_stress
         end do
      end associate
   end subroutine add_part

   !> Shear stress along x [Pa].
   pure function adhesive_cylinder_tractions(values, spectrum, given, pressure, is_contact) result(stress)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: spectrum
      type(given_law_t), intent(in) :: given
      !> Pressure [Pa]; shape `(n_x)`.
      real(dp), intent(in) :: pressure(:)
      !> Do the bodies touch? Shape `(n_x)`.
      logical, intent(in) :: is_contact(:)
      real(dp) :: stress(size(pressure))
      type(friction_law_t) :: law

      call law_of_cylinder(values, spectrum, given, law)
      stress = interface_tractions(law, values(in%velocity), values(in%temperature), pressure, is_contact)
   end function adhesive_cylinder_tractions

end module adfric_plane_adhesive_cylinder_interface

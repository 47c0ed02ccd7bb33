! SPDX-License-Identifier: GPL-3.0-or-later
!> What an input of the model `hertz` may not say, and what its values mean.
module adfric_plane_hertz_check
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set, unset
   use adfric_interface_conduction_rows, only: check_conduction, n_conduction_rows, refuse_conduction
   use adfric_interface_friction_law_check, only: check_interface
   use adfric_interface_friction_law_rows, only: given_law_t, has_interface, needs_temperature
   use adfric_interface_shear_coupling, only: check_coupling, is_coupled
   use adfric_interface_heat_rows, only: check_heat, has_heat
   use adfric_plane_hertz_ellipse, only: find_curvatures
   use adfric_plane_hertz_variables, only: kind_line, kind_elliptical, in => hertz_input
   use adfric_plane_hertz_slip, only: check_slip, refuse_slip
   use adfric_plane_sliding_check, only: check_sliding, refuse_sliding
   use adfric_plane_sliding_cylinder_point, only: is_possible_cylinder
   use adfric_solid_contact_modulus, only: check_contact_modulus
   use adfric_solid_given_spectrum, only: given_spectrum_t
   use adfric_solid_spectrum_rows, only: has_spectrum, solid_shift_of
   use adfric_solid_time_temperature, only: shift_none, time_temperature_t
   use adfric_describe_check, only: refuse_given, require, require_one
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: check_hertz, check_radii, is_sliding, get_curvatures, steepest_edge, wants_stresses

contains

   !> Add to `problems` what is missing or impossible.
   subroutine check_hertz(variables, values, given, given_law, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: given
      type(given_law_t), intent(in) :: given_law
      type(problems_t), intent(inout) :: problems
      integer :: before

      before = problems%count()
      call require(variables, values, [in%kind], problems)
      if (is_sliding(values)) then
         call check_material(variables, values, given, given_law, problems)
         call refuse_slip(variables, values, problems)
      else
         call check_solid(variables, values, given_law, problems)
         call check_slip(variables, values, problems)
      end if
      if (.not. is_set(values(in%kind))) return
      call check_load(variables, values, problems)
      call check_current(variables, values, problems)
      call check_stresses(values, problems)
      call check_radii(variables, values, problems)
      if (.not. is_sliding(values) .or. problems%count() > before) return
      if (.not. is_possible_cylinder(values, given)) call problems%add('operating', 'velocity', &
         & 'is too small or too large for the radius, the load and the relaxation times')
   end subroutine check_hertz

   !> Add to `problems` what is wrong with the load, or with what is prescribed instead.
   subroutine check_load(variables, values, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      logical :: is_swept(size(values))

      ! what is swept has a value here, too
      is_swept = .false.
      associate (others => [in%contact_half_width, in%peak_pressure])
         if (nint(values(in%kind)) /= kind_line) then
            call require_one(variables, values, [in%load, in%approach, others], .true., problems)
            return
         end if
         call refuse_given(variables, values, is_swept, [in%approach], &
            & 'is undefined for the line contact of half-planes; give load', problems)
         if (is_sliding(values)) then
            call refuse_given(variables, values, is_swept, others, 'has no meaning beside &material; give load', problems)
            if (.not. any(is_set(values(others)))) call require(variables, values, [in%load], problems)
            return
         end if
         if (is_coupled(values(in%coupling))) call refuse_given(variables, values, is_swept, others, &
            & 'stands beside coupling, which moves the contact; give load', problems)
         call require_one(variables, values, [in%load, others], .true., problems)
      end associate
   end subroutine check_load

   !> Add to `problems` what the largest stresses lack, or stand beside: they are those below a pressure alone.
   subroutine check_stresses(values, problems)
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems

      if (.not. wants_stresses(values)) return
      if (.not. is_set(values(in%poisson_ratio))) call problems%add('solid', 'poisson_ratio', &
         & 'is missing [-]; the stresses in depth need it')
      if (is_sliding(values)) call problems%add('output', 'largest_stresses', &
         & 'stands beside &material, in which stresses in depth are not solved')
      if (is_set(values(in%coefficient)) .or. has_interface(values(in%friction))) call problems%add('output', 'largest_stresses', &
         & 'stands beside &friction, whose shear stress has no closed form in depth; on cells partial slip has')
   end subroutine check_stresses

   !> Are the largest stresses wanted, by their switch or by a yield strength?
   pure logical function wants_stresses(values)
      real(dp), intent(in) :: values(:)

      wants_stresses = is_set(values(in%yield_strength))
      if (is_set(values(in%largest_stresses))) wants_stresses = wants_stresses .or. values(in%largest_stresses) > 0
   end function wants_stresses

   !> Add to `problems` what is wrong with conduction, which a line contact does not have.
   subroutine check_current(variables, values, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems

      associate (rows => variables(in%conduction(1):in%conduction(n_conduction_rows)), &
            & of_rows => values(in%conduction(1):in%conduction(n_conduction_rows)))
         if (nint(values(in%kind)) == kind_line) then
            call refuse_conduction(rows, of_rows, 'has no meaning for this kind; the conductance of a line contact depends ' &
               & //'on the size of the bodies', problems)
         else
            call check_conduction(rows, of_rows, problems)
         end if
      end associate
   end subroutine check_current

   !> Add to `problems` what is wrong with elastic solids, over which a velocity counts for a law of the interface alone.
   subroutine check_solid(variables, values, given_law, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(given_law_t), intent(in) :: given_law
      type(problems_t), intent(inout) :: problems
      real(dp) :: others(size(values))
      integer :: k

      call check_contact_modulus(variables(in%contact_modulus:in%second_poisson_ratio), &
         & values(in%contact_modulus:in%second_poisson_ratio), problems, .true.)
      call check_coupling(variables(in%coupling), values(in%coupling), values(in%friction), values(in%poisson_ratio), .false., &
         & problems)
      others = values
      if (has_interface(values(in%friction))) then
         call check_sliding_cylinder(variables, values, given_law, problems)
         others(in%velocity) = unset
         if (needs_temperature(values(in%friction)) .or. has_heat(values(in%heat))) others(in%temperature) = unset
      end if
      call refuse_sliding(variables(in%material(1):in%velocity), others(in%material(1):in%velocity), problems)
      if (.not. has_heat(values(in%heat))) return
      k = findloc(is_set(values(in%heat)), .true., 1)
      if (is_coupled(values(in%coupling))) then
         call problems%add('heat', variables(in%heat(k))%name, 'stands beside coupling, with which the contact would depend on ' &
            & //'its own temperature')
         return
      end if
      if (has_interface(values(in%friction))) call require(variables, values, [in%velocity], problems)
      call check_heat(variables, values, in%heat(1), in%temperature, has_interface(values(in%friction)), unset, .true., problems)
   end subroutine check_solid

   !> Add to `problems` what does not go with a law of the interface on an elastic solid.
   subroutine check_sliding_cylinder(variables, values, given_law, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(given_law_t), intent(in) :: given_law
      type(problems_t), intent(inout) :: problems
      type(time_temperature_t) :: none
      integer :: k

      if (is_set(values(in%kind))) then
         if (nint(values(in%kind)) /= kind_line) call refuse_around(variables, values, problems)
      end if
      if (is_coupled(values(in%coupling))) call require(variables, values, [in%velocity], problems)
      call check_interface(variables, values, in%friction, [in%temperature, in%velocity], given_law, none, 0.0_dp, problems)
      do k = in%tangential_force, in%coefficient
         if (k == in%tangential_axis) cycle
         if (is_set(values(k))) call problems%add(variables(k)%group, variables(k)%name, &
            & 'stands beside a shear stress of sliding, in which nothing sticks')
      end do
      if (is_coupled(values(in%coupling)) .and. is_set(values(in%second_young_modulus))) call problems%add( &
         & variables(in%coupling)%group, variables(in%coupling)%name, 'stands beside second_young_modulus; the body that slides ' &
         & //'is rigid')
   end subroutine check_sliding_cylinder

   !> Add to `problems` what a law of the interface has beside it for cylinders alone.
   subroutine refuse_around(variables, values, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      integer :: k

      if (is_coupled(values(in%coupling))) call problems%add(variables(in%coupling)%group, variables(in%coupling)%name, &
         & 'has no meaning for this kind; single contacts that shear stress moves are cylinders')
      k = findloc(is_set(values(in%heat)), .true., 1)
      if (k > 0) call problems%add('heat', variables(in%heat(k))%name, 'has no meaning for this kind; its contact has no closed ' &
         & //'form of the heat')
   end subroutine refuse_around

   !> Add to `problems` what is wrong with a viscoelastic material.
   subroutine check_material(variables, values, given, given_law, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: given
      type(given_law_t), intent(in) :: given_law
      type(problems_t), intent(inout) :: problems
      type(time_temperature_t) :: of_solid
      real(dp) :: others(size(values))
      integer :: k, before

      before = problems%count()
      if (is_set(values(in%kind))) then
         if (nint(values(in%kind)) /= kind_line) call problems%add('contact', 'kind', &
            & 'is not ''line''; over &material only a cylinder slides')
      end if
      k = findloc(is_set(values(in%contact_modulus:in%second_poisson_ratio)), .true., 1)
      if (k > 0) call problems%add('solid', variables(in%contact_modulus - 1 + k)%name, &
         & 'stands beside &material, over which a rigid cylinder slides; give &solid for elastic solids, or &material')
      if (is_coupled(values(in%coupling))) call problems%add(variables(in%coupling)%group, variables(in%coupling)%name, &
         & 'stands beside &material; a wave or a surface on cells has both')
      of_solid = solid_shift_of(values(in%material(1):in%temperature), given)
      others = values
      ! a solid without shift has no use for the temperature of the interface
      if ((needs_temperature(values(in%friction)) .or. has_heat(values(in%heat))) .and. of_solid%law == shift_none) &
         & others(in%temperature) = unset
      call check_sliding(variables(in%material(1):in%velocity), others(in%material(1):in%velocity), given, problems)
      call check_heat(variables, values, in%heat(1), in%temperature, has_interface(values(in%friction)), unset, .true., problems)
      if (problems%count() == before .and. has_interface(values(in%friction))) call check_interface(variables, values, &
         & in%friction, [in%temperature, in%velocity], given_law, of_solid, 0.0_dp, problems)
   end subroutine check_material

   !> Add to `problems` radii that do not go with the kind of contact, or make none.
   subroutine check_radii(variables, values, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      real(dp) :: a, b, direction
      integer :: i

      do i = in%radius, in%radius_2y
         if (i == in%radius .eqv. nint(values(in%kind)) /= kind_elliptical) cycle
         if (is_set(values(i))) call problems%add('contact', variables(i)%name, 'has no meaning for this kind')
      end do
      if (nint(values(in%kind)) /= kind_elliptical) then
         call require(variables, values, [in%radius], problems)
         return
      end if
      do i = in%radius_1x, in%radius_2y
         if (abs(values(i)) > 0) cycle
         call problems%add('contact', variables(i)%name, 'is 0, allowed: any other number; flat if not given')
         return
      end do
      call get_curvatures(values, a, b, direction)
      if (.not. a > 0) call problems%add('contact', 'radius_1x', &
         & 'and the other radii do not make a gap that opens in all directions: there is no ellipse of contact')
   end subroutine check_radii

   !> Does a cylinder slide over a viscoelastic half-plane?
   pure logical function is_sliding(values)
      real(dp), intent(in) :: values(:)

      is_sliding = has_spectrum(values(in%material(1):in%temperature))
   end function is_sliding

   !> The largest slope that a body has at an end of an axis of the contact, its half-width over the radius of a round one. Of a line
   !> and a circle only R is known, that of both bodies together.
   pure real(dp) function steepest_edge(values, major, minor, direction) result(slope)
      real(dp), intent(in) :: values(:)
      !> Half-widths of the contact [m].
      real(dp), intent(in) :: major, minor
      !> Angle from the first principal direction of the first body to the major axis [rad].
      real(dp), intent(in) :: direction
      real(dp) :: curvatures(4), angle
      integer :: body

      if (nint(values(in%kind)) /= kind_elliptical) then
         slope = major/values(in%radius)
         return
      end if
      curvatures = principal_curvatures(values)
      slope = 0
      do body = 1, 2
         angle = direction
         if (body == 2) angle = direction - values(in%angle)
         associate (kx => curvatures(2*body - 1), ky => curvatures(2*body))
            slope = max(slope, hypot(kx*cos(angle), ky*sin(angle))*major, hypot(kx*sin(angle), ky*cos(angle))*minor)
         end associate
      end do
   end function steepest_edge

   !> Principal curvatures of both bodies [1/m], 0 where one is flat.
   pure function principal_curvatures(values) result(curvatures)
      real(dp), intent(in) :: values(:)
      real(dp) :: curvatures(4)
      integer :: i

      curvatures = 0
      do i = 1, 4
         if (is_set(values(in%radius_1x + i - 1))) curvatures(i) = 1/values(in%radius_1x + i - 1)
      end do
   end function principal_curvatures

   !> Curvatures A <= B of the gap A x^2 + B y^2; A <= 0 where there is no ellipse of contact.
   pure subroutine get_curvatures(values, a, b, direction)
      real(dp), intent(in) :: values(:)
      !> Smaller curvature A of the gap [1/m]; 0 or less where there is no single ellipse of contact.
      real(dp), intent(out) :: a
      !> Larger curvature B of the gap [1/m].
      real(dp), intent(out) :: b
      !> Angle from the first principal direction of the first body to the major axis [rad]; 0 for a circle.
      real(dp), intent(out) :: direction
      real(dp) :: curvatures(4)

      if (nint(values(in%kind)) /= kind_elliptical) then
         a = 0.5_dp/values(in%radius)
         b = a
         direction = 0
         return
      end if
      a = 0
      b = 0
      direction = 0
      if (.not. minval(abs(values(in%radius_1x:in%radius_2y))) > 0) return
      curvatures = principal_curvatures(values)
      call find_curvatures(curvatures(:2), curvatures(3:), values(in%angle), a, b, direction)
   end subroutine get_curvatures

end module adfric_plane_hertz_check

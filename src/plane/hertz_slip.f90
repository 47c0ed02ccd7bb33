! SPDX-License-Identifier: GPL-3.0-or-later
!> Partial slip of the model `hertz`: its rows of friction, what they may not say, and what a point finds.
!>
!> The bonded contact of an ellipse gives way by C T along an axis (Johnson, Contact Mechanics, 1985, 7.2), summed over the bodies,
!>
!>     C_x = [(1 - nu) R_F(0, a^2, b^2) + nu (a^2/3) R_D(0, b^2, a^2)]/(2 pi G),   C_y with (b^2/3) R_D(0, a^2, b^2)
!>
!> and under Coulomb's friction by u = (3/2) mu P C (1 - y^2). A line has no displacement, that of a half-plane has no zero.
!>
!> A cylinder that rolls has the slip of `adfric_plane_rolling_line` instead.
!>
!> Exact where the tangential force does not press and the pressure does not shear: bodies alike, or one rigid and the other
!> incompressible; in slip at nu > 0 the displacement across the force is left out.
module adfric_plane_hertz_slip
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_interface_friction_law_rows, only: has_interface
   use adfric_interface_normal_contact, only: friction_holds
   use adfric_plane_hertz_ellipse, only: ellipse_shape_t, ellipse_t
   use adfric_plane_hertz_line, only: line_contact_t
   use adfric_plane_hertz_variables, only: axis_minor, kind_elliptical, kind_line, state_rolling, in => hertz_input, &
      & out => hertz_output
   use adfric_plane_partial_slip, only: ellipse_slip, line_slip, partial_slip_t, shear_traction
   use adfric_plane_rolling_line, only: rolling_loss, rolling_of_creepage, rolling_of_force, rolling_slip, rolling_t, &
      & rolling_traction
   use adfric_solid_contact_modulus, only: contact_modulus_of, poisson_compliance_of
   use adfric_describe_check, only: require, require_one
   use adfric_describe_rows, only: contact_profiles
   use adfric_describe_table, only: profile_t, variable_t
   implicit none (type, external)
   private
   public :: hertz_slip_t, check_slip, refuse_slip, has_slip, find_slip, add_line_slip, add_ellipse_slip, slip_profiles
   public :: bonded_compliance, tractions, p_shear_stress, is_rolling, solve_rolling, fill_rolling, p_slip_ratio

   !> Positions of the shear stress and the slip of rolling among the profiles, behind those that every contact has.
   integer, parameter :: p_shear_stress = 3, p_slip_ratio = 4

   !> Slip at a point.
   type :: hertz_slip_t
      !> Slip in units of the contact.
      type(partial_slip_t) :: share
      !> The largest shear traction that could be, mu p0, with the sign of the force [Pa].
      real(dp) :: traction = 0
      !> A cylinder that rolls.
      type(rolling_t) :: rolling
      !> Its creepage where all of it begins to slip, with the sign of the force [-].
      real(dp) :: full_creepage = 0
   end type hertz_slip_t

contains

   !> Has the case friction?
   pure logical function has_slip(values)
      real(dp), intent(in) :: values(:)

      has_slip = is_set(values(in%coefficient))
   end function has_slip

   !> Does a cylinder roll over an elastic body?
   pure logical function is_rolling(values)
      real(dp), intent(in) :: values(:)

      is_rolling = is_set(values(in%state))
      if (is_rolling) is_rolling = nint(values(in%state)) == state_rolling
   end function is_rolling

   !> The profiles of a contact with friction; that of the shear stress belongs to cases with friction alone, that of slip to rolling.
   function slip_profiles() result(p)
      type(profile_t) :: p(p_slip_ratio)

      p(:p_shear_stress - 1) = contact_profiles()
      p(p_slip_ratio) = profile_t(name='slip_ratio', unit='-', &
         & long_name='velocity of slip over that of rolling, along the tangential force')
      p(p_shear_stress) = profile_t(name='shear_stress', unit='Pa', &
         & long_name='shear stress of friction, along the tangential force')
   end function slip_profiles

   !> Add to `problems` what is missing or has no meaning for an elastic contact.
   subroutine check_slip(variables, values, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      integer :: kind

      call check_rolling(variables, values, problems)
      if (.not. has_slip(values)) then
         if (is_set(values(in%tangential_force))) call problems%add('friction', 'coefficient', &
            & 'is missing [-]; tangential_force needs it')
         if (is_set(values(in%tangential_axis)) .and. .not. has_interface(values(in%friction))) call problems%add('operating', &
            & 'tangential_axis', 'has no meaning without &friction coefficient')
         if (is_set(values(in%tangential_axis)) .and. has_interface(values(in%friction)) .and. is_set(values(in%kind))) then
            if (nint(values(in%kind)) /= kind_elliptical) call problems%add('operating', 'tangential_axis', &
               & 'has no meaning for this kind')
         end if
         return
      end if
      if (.not. is_rolling(values) .and. .not. is_set(values(in%creepage))) &
         & call require(variables, values, [in%tangential_force], problems)
      if (.not. is_set(values(in%kind))) return
      kind = nint(values(in%kind))
      if (is_set(values(in%tangential_axis)) .and. kind /= kind_elliptical) call problems%add('operating', 'tangential_axis', &
         & 'has no meaning for this kind')
      if (kind /= kind_line .and. is_set(values(in%contact_modulus)) .and. .not. is_set(values(in%poisson_ratio))) &
         & call problems%add('solid', 'poisson_ratio', 'is missing [-]; the tangential displacement needs it')
   end subroutine check_slip

   !> Add to `problems` what is wrong with a cylinder that rolls, or with a creepage without it.
   subroutine check_rolling(variables, values, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems

      if (.not. is_rolling(values)) then
         if (is_set(values(in%creepage))) call problems%add('operating', 'creepage', &
            & 'has no meaning without state = ''rolling''')
         return
      end if
      call require_one(variables, values, [in%tangential_force, in%creepage], .true., problems)
      if (.not. has_slip(values) .and. .not. is_set(values(in%tangential_force))) call problems%add('friction', 'coefficient', &
         & 'is missing [-]; rolling needs it')
      if (.not. is_set(values(in%kind))) return
      if (nint(values(in%kind)) /= kind_line) call problems%add('operating', 'state', &
         & 'is ''rolling'', which has a closed form for kind = ''line'' alone')
   end subroutine check_rolling

   !> Add to `problems` what there is of friction, where a cylinder slides over a material.
   subroutine refuse_slip(variables, values, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      integer :: k

      do k = in%tangential_force, in%coefficient
         if (is_set(values(k))) call problems%add(variables(k)%group, variables(k)%name, &
            & 'has no meaning beside &material, over which a cylinder slides without such friction')
      end do
   end subroutine refuse_slip

   !> Slip of a contact under a load.
   pure subroutine find_slip(values, load, peak_pressure, is_line, slip, is_possible)
      real(dp), intent(in) :: values(:)
      !> Load P [N; N/m of a line], >= 0.
      real(dp), intent(in) :: load
      !> Largest pressure p0 [Pa].
      real(dp), intent(in) :: peak_pressure
      !> Is the contact one along a line?
      logical, intent(in) :: is_line
      type(hertz_slip_t), intent(out) :: slip
      logical, intent(out) :: is_possible
      real(dp) :: force, tau

      force = abs(values(in%tangential_force))/values(in%coefficient)
      is_possible = friction_holds(force, load)
      if (.not. (is_possible .and. load > 0)) return
      tau = min(force/load, 1.0_dp)
      if (is_line) slip%share = line_slip(tau)
      if (.not. is_line) slip%share = ellipse_slip(tau)
      slip%traction = sign(values(in%coefficient)*peak_pressure, values(in%tangential_force))
   end subroutine find_slip

   !> Results of slip along a line.
   pure subroutine add_line_slip(values, load, share, results)
      real(dp), intent(in) :: values(:)
      !> Load P [N/m], > 0.
      real(dp), intent(in) :: load
      type(partial_slip_t), intent(in) :: share
      !> Receives the results of slip; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)

      results(out%stick_fraction) = share%stick
      results(out%cycle_energy) = 4/pi*(values(in%coefficient)*load)*(values(in%coefficient)*load/modulus_of(values))*share%energy
   end subroutine add_line_slip

   !> Slip of a cylinder that rolls, and its results.
   pure subroutine solve_rolling(values, load, line, slip, results, is_possible)
      real(dp), intent(in) :: values(:)
      !> Load P [N/m], >= 0.
      real(dp), intent(in) :: load
      !> The contact under this load.
      type(line_contact_t), intent(in) :: line
      type(hertz_slip_t), intent(out) :: slip
      !> Receives the results of rolling; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      logical, intent(out) :: is_possible
      real(dp) :: friction, given, scale

      is_possible = .true.
      if (is_set(values(in%tangential_force))) is_possible = friction_holds(abs(values(in%tangential_force)) &
         & /values(in%coefficient), load)
      slip%full_creepage = values(in%coefficient)*line%half_width/line%radius
      if (is_possible .and. .not. slip%full_creepage > 0) then
         ! without a load nothing is driven, whatever the creepage
         results([out%tangential_force, out%creepage, out%dissipation, out%energy_imbalance]) = 0
         if (is_set(values(in%creepage))) results(out%creepage) = values(in%creepage)
      end if
      if (.not. (is_possible .and. slip%full_creepage > 0)) return
      friction = values(in%coefficient)*load
      if (is_set(values(in%tangential_force))) then
         given = values(in%tangential_force)
         slip%rolling = rolling_of_force(min(abs(given)/friction, 1.0_dp))
      else
         given = values(in%creepage)
         slip%rolling = rolling_of_creepage(abs(given)/slip%full_creepage)
      end if
      slip%traction = sign(values(in%coefficient)*line%peak_pressure, given)
      slip%full_creepage = sign(slip%full_creepage, given)
      associate (rolling => slip%rolling)
         results(out%stick_fraction) = 1 - rolling%rest
         results(out%tangential_force) = sign(friction*rolling%force(), given)
         results(out%creepage) = slip%full_creepage*rolling%creepage
         scale = friction*abs(slip%full_creepage)
         results(out%dissipation) = scale*(rolling%force()*rolling%creepage)
         results(out%energy_imbalance) = 0
         if (rolling%rest > 0) results(out%energy_imbalance) = rolling_loss(rolling)/(rolling%force()*rolling%creepage) - 1
      end associate
   end subroutine solve_rolling

   !> Shear stress [Pa] and slip over the velocity of rolling, along a line of x.
   pure subroutine fill_rolling(slip, line, x, shear_stress, slip_ratio)
      type(hertz_slip_t), intent(in) :: slip
      !> The contact.
      type(line_contact_t), intent(in) :: line
      !> Coordinates across the contact, along which it rolls [m]; shape `(n_x)`.
      real(dp), intent(in) :: x(:)
      !> Receive both; shape `(n_x)`.
      real(dp), intent(out) :: shear_stress(:), slip_ratio(:)

      shear_stress = 0
      slip_ratio = 0
      if (.not. line%half_width > 0) return
      shear_stress = slip%traction*rolling_traction(slip%rolling, x/line%half_width)
      slip_ratio = slip%full_creepage*rolling_slip(slip%rolling, x/line%half_width)
   end subroutine fill_rolling

   !> Results of slip on an ellipse.
   pure subroutine add_ellipse_slip(values, ellipse, share, results)
      real(dp), intent(in) :: values(:)
      !> The contact, of half-axes > 0.
      type(ellipse_t), intent(in) :: ellipse
      type(partial_slip_t), intent(in) :: share
      !> Receives the results of slip; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      real(dp) :: compliance, friction, full

      compliance = compliance_of(values, ellipse)/ellipse%major
      friction = values(in%coefficient)*ellipse%load
      full = 1.5_dp*friction*compliance
      results(out%stick_fraction) = share%stick**2
      results(out%tangential_displacement) = sign(full*share%displacement(), values(in%tangential_force))
      results(out%tangential_stiffness) = share%stick/compliance
      results(out%cycle_energy) = friction*full*share%energy
   end subroutine add_ellipse_slip

   !> Tangential compliance of the bonded ellipse along the axis of the force, times its half-axis a [1/Pa].
   pure real(dp) function compliance_of(values, ellipse) result(compliance)
      real(dp), intent(in) :: values(:)
      type(ellipse_t), intent(in) :: ellipse
      logical :: is_along_minor

      is_along_minor = is_set(values(in%tangential_axis))
      if (is_along_minor) is_along_minor = nint(values(in%tangential_axis)) == axis_minor
      compliance = bonded_compliance(values(in%contact_modulus:in%second_poisson_ratio), ellipse%shape, is_along_minor)
   end function compliance_of

   !> C of the module's head times the half-axis a [1/Pa].
   pure real(dp) function bonded_compliance(moduli, shape, is_along_minor) result(compliance)
      !> Values of the rows of the contact modulus; shape `(n_two_bodies)`.
      real(dp), intent(in) :: moduli(:)
      type(ellipse_shape_t), intent(in) :: shape
      !> Does the force act along the minor axis?
      logical, intent(in) :: is_along_minor
      real(dp) :: along

      along = shape%d_along
      if (is_along_minor) along = shape%axis_ratio**2*shape%d_across
      compliance = (2/contact_modulus_of(moduli)*shape%f + poisson_compliance_of(moduli)*along/3)/(2*pi)
   end function bonded_compliance

   !> E* [Pa].
   pure real(dp) function modulus_of(values)
      real(dp), intent(in) :: values(:)

      modulus_of = contact_modulus_of(values(in%contact_modulus:in%second_poisson_ratio))
   end function modulus_of

   !> Shear tractions [Pa].
   pure function tractions(slip, squares)
      type(hertz_slip_t), intent(in) :: slip
      !> Squares of the distances from the middle, in half-axes; shape `(n_positions)`.
      real(dp), intent(in) :: squares(:)
      real(dp) :: tractions(size(squares))

      tractions = slip%traction*shear_traction(slip%share, squares)
   end function tractions

end module adfric_plane_hertz_slip

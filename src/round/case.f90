! SPDX-License-Identifier: GPL-3.0-or-later
!> One point of the model `indenter`: from the values of a namelist to a shape and its curve in reduced variables.
!>
!> Units: a shape with a corner has L = b and H = k b or b^2/R, a sphere L = H = R, a flat face L = H = b. A power of r has no length
!> of its own: L is then the radius of the fold at given load, n K C L^(n - 1/2) = (3/2) sqrt(2 pi w/E*), without adhesion the radius
!> of contact, and H = K C L^n. Of a polynomial L is the least of its terms, and H the sum.
module adfric_round_case
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, half_pi, two_pi
   use adfric_base_unset, only: is_set
   use adfric_round_contact, only: branch_stable
   use adfric_round_corner_shape, only: corner_shape_t, new_corner_shape, flat_face, flat_cone, flat_paraboloid, rounded_punch, &
      & rounded_cone
   use adfric_round_curve, only: curve_t, control_load, control_approach, control_spring, control_radius
   use adfric_round_dugdale_curve, only: dugdale_curve_t
   use adfric_round_edge_slope, only: slope_of
   use adfric_round_power_shape, only: power_shape_t, new_power_shape, depth_factor
   use adfric_round_sphere_shape, only: sphere_shape_t, new_sphere_shape
   use adfric_round_variables, only: choose_auto, choose_none, kind_cone, kind_flat_cone, kind_flat_paraboloid, &
      & kind_paraboloid, kind_polynomial, kind_power, kind_rounded_cone, kind_rounded_punch, kind_sphere, theory_dmt, &
      & theory_jkr, theory_maugis_dugdale, theory_none, in => indenter_input
   use adfric_solid_contact_modulus, only: contact_modulus_of, poisson_compliance_of
   implicit none (type, external)
   private
   public :: indenter_case_t, resolve_case, is_possible, tangential_compliance, theory_of, has_plain_spring, has_plain_base

   !> Units and what is prescribed must be between these powers of ten, or numbers have no space.
   integer, parameter :: largest_unit = 70, largest_number = 30

   !> A point in reduced variables.
   type :: indenter_case_t
      !> Its curve, with the shape.
      class(curve_t), allocatable :: curve
      !> One of `theory_...`.
      integer :: theory = theory_none
      !> Units L [m] of lengths in the plane and H [m] of heights, and E* [Pa].
      real(dp) :: length_unit = 1, height_unit = 1, modulus = 1
      !> What is prescribed (`control_...`), and one of `branch_...`.
      integer :: control = control_load, branch = branch_stable
      !> Load, approach (of the base of a spring, too) or unknown u that is prescribed, reduced.
      real(dp) :: given = 0
      !> Does a given u lie beyond the corner?
      logical :: is_beyond = .true.
      !> Radius of contact that is given, reduced; 0 if none is.
      real(dp) :: radius = 0
      !> Stiffness of a lateral spring, reduced; 0 if none is given.
      real(dp) :: lateral_stiffness = 0
      !> Displacement of its base, reduced; 0 if none is given.
      real(dp) :: base_displacement = 0
   contains
      procedure :: force_unit
      procedure :: stiffness_unit
   end type indenter_case_t

contains

   !> E* L H [N].
   pure real(dp) function force_unit(self)
      class(indenter_case_t), intent(in) :: self

      force_unit = self%modulus*self%length_unit*self%height_unit
   end function force_unit

   !> E* L [N/m].
   pure real(dp) function stiffness_unit(self)
      class(indenter_case_t), intent(in) :: self

      stiffness_unit = self%modulus*self%length_unit
   end function stiffness_unit

   !> The point that the values describe; they have been checked.
   pure subroutine resolve_case(values, self)
      !> Values of the variables, in the order of `adfric_round_variables`.
      real(dp), intent(in) :: values(:)
      type(indenter_case_t), intent(out) :: self
      type(sphere_shape_t), allocatable :: sphere
      real(dp) :: work

      self%theory = theory_of(values)
      allocate (curve_t :: self%curve)
      if (self%theory == theory_maugis_dugdale) then
         deallocate (self%curve)
         allocate (dugdale_curve_t :: self%curve)
      end if
      self%modulus = contact_modulus_of(values(in%contact_modulus:in%second_poisson_ratio))
      work = 0
      if (self%theory /= theory_none) work = values(in%work_of_adhesion)
      self%branch = nint(values(in%branch))
      self%control = control_radius
      if (is_set(values(in%load))) self%control = control_load
      if (is_set(values(in%approach))) self%control = control_approach
      if (is_set(values(in%base_approach))) self%control = control_spring
      select case (nint(values(in%kind)))
      case (kind_cone, kind_paraboloid, kind_power, kind_polynomial)
         call resolve_powers(values, work/self%modulus, self)
      case (kind_sphere)
         allocate (sphere)
         call new_sphere_shape(sphere)
         call move_alloc(sphere, self%curve%shape)
         self%length_unit = values(in%radius)
         self%height_unit = values(in%radius)
      case default
         call resolve_corner(values, self)
      end select
      if (.not. self%height_unit > 0) return
      ! W = w L/(E* H^2)
      work = (work/self%modulus)/self%height_unit*(self%length_unit/self%height_unit)
      call resolve_adhesion(values, work, self%theory, self%modulus*(self%height_unit/self%length_unit), self%height_unit, &
         & self%curve)
      call resolve_given(values, self)
      if (is_set(values(in%lateral_stiffness))) self%lateral_stiffness = values(in%lateral_stiffness)/self%stiffness_unit()
      if (is_set(values(in%base_displacement))) self%base_displacement = values(in%base_displacement)/self%height_unit
   end subroutine resolve_case

   !> The theory of a case: without adhesion none, and without a range JKR.
   pure integer function theory_of(values) result(theory)
      real(dp), intent(in) :: values(:)

      theory = theory_none
      if (.not. is_set(values(in%work_of_adhesion))) return
      if (.not. values(in%work_of_adhesion) > 0 .or. nint(values(in%theory)) == choose_none) return
      theory = theory_jkr
      if (nint(values(in%theory)) == choose_auto) then
         if (any(is_set(values(in%adhesion_stress:in%lambda)))) theory = theory_maugis_dugdale
      else
         theory = nint(values(in%theory)) - choose_none
      end if
   end function theory_of

   !> Adhesion of a curve.
   pure subroutine resolve_adhesion(values, work, theory, stress_unit, height_unit, curve)
      real(dp), intent(in) :: values(:)
      !> W, the reduced work of adhesion.
      real(dp), intent(in) :: work
      integer, intent(in) :: theory
      !> Units of stresses [Pa] and heights [m].
      real(dp), intent(in) :: stress_unit, height_unit
      class(curve_t), intent(inout) :: curve
      real(dp) :: n, exponent

      curve%tension = sqrt(two_pi*work)
      ! P = P1 - 2 pi w R, reduced: g = x^2 = x^2/R
      if (theory == theory_dmt) then
         curve%tension = 0
         curve%outer_pull = two_pi*work
      end if
      select type (curve)
      type is (dugdale_curve_t)
         if (is_set(values(in%adhesion_stress))) then
            curve%stress = values(in%adhesion_stress)/stress_unit
         else if (is_set(values(in%adhesion_range))) then
            curve%stress = work/(values(in%adhesion_range)/height_unit)
         else
            ! lambda = (3/2) sigma0 a0/(E* D), D = a0^n in these units, 2 pi W a0 = (8/3) D^2
            exponent = 2
            if (nint(values(in%kind)) == kind_cone) exponent = 1
            if (nint(values(in%kind)) == kind_power) exponent = values(in%exponent)
            n = (0.75_dp*pi*work)**((exponent - 1)/(2*exponent - 1))
            curve%stress = 2*values(in%lambda)/3*n
         end if
         curve%range = work/curve%stress
      end select
   end subroutine resolve_adhesion

   !> A shape with a corner.
   pure subroutine resolve_corner(values, self)
      real(dp), intent(in) :: values(:)
      type(indenter_case_t), intent(inout) :: self
      type(corner_shape_t), allocatable :: shape
      real(dp) :: b
      integer :: kind

      b = values(in%face_radius)
      allocate (shape)
      select case (nint(values(in%kind)))
      case (kind_flat_cone)
         kind = flat_cone
         self%height_unit = slope_of(values)*b
      case (kind_flat_paraboloid)
         kind = flat_paraboloid
         self%height_unit = b*(b/values(in%radius))
      case (kind_rounded_punch)
         kind = rounded_punch
         self%height_unit = b*(b/values(in%radius))
      case (kind_rounded_cone)
         kind = rounded_cone
         b = slope_of(values)*values(in%radius)
         self%height_unit = slope_of(values)*b
      case default
         kind = flat_face
         self%height_unit = b
      end select
      self%length_unit = b
      call new_corner_shape(shape, kind)
      call move_alloc(shape, self%curve%shape)
   end subroutine resolve_corner

   !> A sum of powers.
   pure subroutine resolve_powers(values, length, self)
      real(dp), intent(in) :: values(:)
      !> w/E* [m].
      real(dp), intent(in) :: length
      type(indenter_case_t), intent(inout) :: self
      type(power_shape_t), allocatable :: shape
      real(dp), allocatable :: exponents(:), logarithms(:)
      real(dp) :: unit, height

      call get_terms(values, exponents, logarithms)
      if (length > 0) then
         unit = minval((log(1.5_dp) + log(two_pi*length)/2 - log(exponents) - logarithms)/(exponents - 0.5_dp))
      else
         unit = minval(radius_logarithm(values, self%modulus, exponents, logarithms))
      end if
      ! the sum of the heights, of which the largest is taken out
      logarithms = logarithms + exponents*unit
      height = maxval(logarithms)
      height = height + log(sum(exp(logarithms - height)))
      if (abs(unit) < largest_unit*log(10.0_dp)) self%length_unit = exp(unit)
      if (abs(height) < largest_unit*log(10.0_dp)) self%height_unit = exp(height)
      ! the unit of a height that is no number stays 0, which `is_possible` refuses
      if (.not. (abs(unit) < largest_unit*log(10.0_dp) .and. abs(height) < largest_unit*log(10.0_dp))) self%height_unit = 0
      allocate (shape)
      call new_power_shape(shape, exponents, exp(logarithms - height))
      call move_alloc(shape, self%curve%shape)
   end subroutine resolve_powers

   !> Exponents of the terms, and the logarithms of their K C.
   pure subroutine get_terms(values, exponents, logarithms)
      real(dp), intent(in) :: values(:)
      !> Receives the exponents; one or more.
      real(dp), allocatable, intent(out) :: exponents(:)
      !> Receives the logarithms of K C, C in [m^(1 - n)].
      real(dp), allocatable, intent(out) :: logarithms(:)
      integer :: k

      select case (nint(values(in%kind)))
      case (kind_cone)
         exponents = [1.0_dp]
         logarithms = [log(half_pi*slope_of(values))]
      case (kind_paraboloid)
         exponents = [2.0_dp]
         logarithms = [-log(values(in%radius))]
      case (kind_power)
         exponents = [values(in%exponent)]
         logarithms = [log(depth_factor(values(in%exponent))) + log(values(in%coefficient))]
      case default
         exponents = pack([(real(k, dp), k=1, 8)], values(in%coefficient_1:in%coefficient_8) > 0)
         logarithms = log(pack(values(in%coefficient_1:in%coefficient_8), values(in%coefficient_1:in%coefficient_8) > 0))
         logarithms = logarithms + log(depth_factor(exponents))
      end select
   end subroutine get_terms

   !> Logarithm of the radius of contact of each term alone, without adhesion; that of a height of 1 where nothing is in contact.
   pure function radius_logarithm(values, modulus, exponents, logarithms) result(radius)
      real(dp), intent(in) :: values(:)
      !> E* [Pa].
      real(dp), intent(in) :: modulus
      !> Exponents n and logarithms of K C.
      real(dp), intent(in) :: exponents(:), logarithms(:)
      real(dp) :: radius(size(exponents))

      radius = -logarithms/exponents
      if (is_set(values(in%load))) then
         if (values(in%load) > 0) radius = (log(values(in%load)/(2*modulus)) + log(1 + 1/exponents) - logarithms)/(exponents + 1)
      else if (is_set(values(in%approach))) then
         if (values(in%approach) > 0) radius = (log(values(in%approach)) - logarithms)/exponents
      else if (is_set(values(in%base_approach))) then
         ! delta and P/k are each at most their sum
         if (values(in%base_approach) > 0) radius = min((log(values(in%base_approach)) - logarithms)/exponents, &
            & (log(values(in%base_approach)) + log(values(in%machine_stiffness)/modulus/2) + log(1 + 1/exponents) &
            & - logarithms)/(exponents + 1))
      else
         radius = log(values(in%contact_radius))
      end if
   end function radius_logarithm

   !> What is prescribed.
   pure subroutine resolve_given(values, self)
      real(dp), intent(in) :: values(:)
      !> In: with shape and units. Out: with what is prescribed, too.
      type(indenter_case_t), intent(inout) :: self

      if (self%control == control_load) then
         self%given = values(in%load)/self%force_unit()
      else if (self%control == control_approach) then
         self%given = values(in%approach)/self%height_unit
      else if (self%control == control_spring) then
         self%given = values(in%base_approach)/self%height_unit
         self%curve%compliance = self%modulus*self%length_unit/values(in%machine_stiffness)
      else if (is_set(values(in%face_angle))) then
         self%given = tan(values(in%face_angle))
      else
         self%radius = values(in%contact_radius)/self%length_unit
         self%is_beyond = self%radius >= self%curve%shape%corner
         self%given = self%radius
         if (is_inside(self, self%radius)) self%given = self%curve%shape%unknown_of(self%radius)
      end if
   end subroutine resolve_given

   !> Is a radius less than that of a sphere?
   pure logical function is_inside(self, radius)
      type(indenter_case_t), intent(in) :: self
      !> Radius a of contact, reduced.
      real(dp), intent(in) :: radius

      is_inside = .true.
      select type (shape => self%curve%shape)
      type is (sphere_shape_t)
         is_inside = radius < 1
      end select
   end function is_inside

   !> Is g at a given radius within the numbers?
   pure logical function has_depth(self)
      type(indenter_case_t), intent(in) :: self
      real(dp), parameter :: most = largest_unit*log(10.0_dp)

      has_depth = self%radius > 10.0_dp**(-largest_unit)
      if (.not. has_depth) return
      select type (shape => self%curve%shape)
      type is (power_shape_t)
         has_depth = maxval(shape%exponents(:shape%n_terms))*abs(log(self%radius)) < most
      end select
   end function has_depth

   !> Is the stiffness of a lateral spring within the numbers?
   pure logical function has_plain_spring(self)
      type(indenter_case_t), intent(in) :: self
      real(dp), parameter :: most = 10.0_dp**largest_number

      has_plain_spring = self%lateral_stiffness > 1/most .and. self%lateral_stiffness < most
   end function has_plain_spring

   !> Is the displacement of the base of a lateral spring within the numbers?
   pure logical function has_plain_base(self)
      type(indenter_case_t), intent(in) :: self

      has_plain_base = self%base_displacement < 10.0_dp**largest_number
   end function has_plain_base

   !> Is there such a contact? Without adhesion a contact of given radius is not smaller than a face, and none is larger than a
   !> sphere; and all has to be within the numbers.
   pure logical function is_possible(values, self)
      real(dp), intent(in) :: values(:)
      type(indenter_case_t), intent(in) :: self
      real(dp), parameter :: most = 10.0_dp**largest_unit

      is_possible = self%height_unit > 1/most .and. self%height_unit < most .and. self%length_unit > 1/most &
         & .and. self%length_unit < most .and. abs(self%given) < 10.0_dp**largest_number .and. self%curve%tension < most &
         & .and. self%curve%compliance < most
      if (self%control == control_spring) is_possible = is_possible .and. self%curve%compliance > 1/most
      if (.not. is_possible) return
      select type (curve => self%curve)
      type is (dugdale_curve_t)
         is_possible = curve%stress < most .and. curve%range < most .and. curve%stress > 1/most .and. curve%range > 1/most
         if (is_possible .and. is_inside(self, self%radius)) then
            is_possible = curve%has_space(merge(self%given, 0.0_dp, self%radius > 0), self%is_beyond)
         end if
      end select
      if (is_set(values(in%lateral_stiffness))) is_possible = is_possible .and. has_plain_spring(self) &
         & .and. has_plain_base(self)
      if (.not. is_possible .or. .not. is_set(values(in%contact_radius))) return
      is_possible = has_depth(self) .and. is_inside(self, self%radius) &
         & .and. (self%is_beyond .or. .not. self%curve%shape%has_face &
         & .or. self%theory /= theory_none)
   end function is_possible

   !> m, the ratio of the tangential to the normal compliance: 1 + (E*/4) sum of nu/G.
   pure real(dp) function tangential_compliance(values, case) result(ratio)
      real(dp), intent(in) :: values(:)
      type(indenter_case_t), intent(in) :: case

      ratio = 1 + case%modulus*poisson_compliance_of(values(in%contact_modulus:in%second_poisson_ratio))/4
   end function tangential_compliance

end module adfric_round_case

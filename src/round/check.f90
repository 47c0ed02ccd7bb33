! SPDX-License-Identifier: GPL-3.0-or-later
!> What is missing, contradictory or impossible in an input of the model `indenter`.
module adfric_round_check
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_base_words, only: get_word
   use adfric_round_case, only: has_plain_base, has_plain_spring, indenter_case_t, resolve_case, is_possible, theory_of
   use adfric_round_contact, only: branch_stable
   use adfric_round_dugdale_curve, only: dugdale_curve_t
   use adfric_round_friction_check, only: check_friction, is_moved
   use adfric_round_variables, only: choose_auto, choose_dmt, choose_jkr, choose_maugis_dugdale, choose_none, &
      & kind_cone, kind_flat, kind_flat_cone, kind_flat_paraboloid, kind_paraboloid, kind_polynomial, kind_power, &
      & kind_rounded_cone, kind_rounded_punch, kind_sphere, law_peeling, theory_maugis_dugdale, in => indenter_input
   use adfric_solid_contact_modulus, only: check_contact_modulus
   use adfric_interface_shear_strength_rows, only: check_shear
   use adfric_round_work_check, only: require_work
   use adfric_describe_check, only: require, require_one, refuse_size, refuse_swept
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: check_indenter_values, check_body

   !> With adhesion, smaller exponents make contacts beyond all numbers; at 1/2 and below no state is stable.
   real(dp), parameter :: least_exponent = 0.51_dp

contains

   !> Add to `problems` what is wrong with the values together.
   subroutine check_indenter_values(variables, values, is_swept, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      logical, intent(in) :: is_swept(:)
      type(problems_t), intent(inout) :: problems
      integer :: before

      before = problems%count()
      call check_body(variables, values, is_moved(values) .or. is_set(values(in%position_z)), problems)
      call check_friction(variables, values, problems)
      call check_adhesion(variables, values, problems)
      call check_operation(variables, values, problems)
      if (is_set(values(in%position_z)) .and. .not. is_set(values(in%poisson_ratio))) &
         & call problems%add('solid', 'poisson_ratio', 'is missing [-]; the stresses at position_z need it')
      if (values(in%profiles) > 0) then
         call require(variables, values, [in%r_max], problems)
         call refuse_swept(variables, is_swept, [in%r_max, in%n_r], problems)
      end if
      if (problems%count() == before) call check_sizes(variables, values, problems)
   end subroutine check_indenter_values

   !> Shape and solids.
   subroutine check_body(variables, values, has_own_poisson_ratio, problems)
      !> Table whose rows up to the moduli are those of this model.
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      !> Has Poisson's ratio of the first body a use of its own beside the contact modulus?
      logical, intent(in) :: has_own_poisson_ratio
      type(problems_t), intent(inout) :: problems

      call require(variables, values, [in%kind], problems)
      if (is_set(values(in%kind))) call check_shape(variables, values, problems)
      call check_contact_modulus(variables(in%contact_modulus:in%second_poisson_ratio), &
         & values(in%contact_modulus:in%second_poisson_ratio), problems, has_own_poisson_ratio)
   end subroutine check_body

   !> What each kind of shape needs, and what it has no place for.
   subroutine check_shape(variables, values, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      logical :: is_used(in%coefficient_8)
      integer :: kind, k

      kind = nint(values(in%kind))
      is_used = .false.
      is_used(in%kind) = .true.
      is_used(in%radius) = any(kind == [kind_paraboloid, kind_sphere, kind_flat_paraboloid, kind_rounded_punch, kind_rounded_cone])
      is_used([in%slope, in%half_angle]) = any(kind == [kind_cone, kind_flat_cone, kind_rounded_cone])
      is_used([in%exponent, in%coefficient]) = kind == kind_power
      is_used(in%face_radius) = any(kind == [kind_flat, kind_flat_cone, kind_flat_paraboloid, kind_rounded_punch])
      is_used(in%coefficient_1:in%coefficient_8) = kind == kind_polynomial
      do k = in%radius, in%coefficient_8
         if (is_used(k)) then
            if (any(k == [in%slope, in%half_angle]) .or. k >= in%coefficient_1) cycle
            call require(variables, values, [k], problems)
         else if (is_set(values(k)) .and. (k < in%coefficient_1 .or. values(k) > 0)) then
            call problems%add(variables(k)%group, variables(k)%name, 'has no meaning for kind = ''' &
               & //get_word(variables(in%kind)%choices, kind)//'''')
         end if
      end do
      if (is_used(in%slope)) call require_one(variables, values, [in%slope, in%half_angle], .true., problems)
      if (kind == kind_polynomial .and. .not. maxval(values(in%coefficient_1:in%coefficient_8)) > 0) then
         call problems%add('shape', 'coefficient_1', 'is 0 like all coefficients; give one of them, or kind = ''flat''')
      end if
   end subroutine check_shape

   !> Theory and work of adhesion.
   subroutine check_adhesion(variables, values, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      logical :: has_adhesion

      has_adhesion = .false.
      if (is_set(values(in%work_of_adhesion))) has_adhesion = values(in%work_of_adhesion) > 0
      call require_one(variables, values, [in%adhesion_stress, in%adhesion_range, in%lambda], &
         & nint(values(in%theory)) == choose_maugis_dugdale, problems)
      if (nint(values(in%theory)) >= choose_jkr .or. any(is_set(values(in%adhesion_stress:in%lambda)))) then
         call require_work(variables, values, in%work_of_adhesion, [in%adhesion_stress, in%adhesion_range], problems)
         if (is_set(values(in%work_of_adhesion)) .and. nint(values(in%theory)) > choose_jkr .and. .not. has_adhesion) &
            & call problems%add('adhesion', 'work_of_adhesion', 'is 0, and this theory needs adhesion')
      else if (nint(values(in%theory)) == choose_none .and. has_adhesion) then
         call problems%add('adhesion', 'work_of_adhesion', 'has no meaning for theory = ''none''')
      end if
      if (is_set(values(in%kind))) call check_theory(values, problems)
      if (.not. (has_adhesion .and. is_set(values(in%kind)) .and. is_set(values(in%exponent)))) return
      if (nint(values(in%kind)) == kind_power .and. values(in%exponent) < least_exponent) call problems%add('shape', 'exponent', &
         & 'is too small for adhesion: at 1/2 and below no state is stable; allowed with adhesion: a number >= 0.51 [-]')
   end subroutine check_adhesion

   !> What belongs to some kinds alone: DMT and lambda.
   subroutine check_theory(values, problems)
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      logical :: is_square, has_range
      integer :: kind

      kind = nint(values(in%kind))
      is_square = kind == kind_paraboloid
      if (kind == kind_power .and. is_set(values(in%exponent))) is_square = .not. abs(values(in%exponent) - 2) > 0
      if (nint(values(in%theory)) == choose_dmt .and. .not. is_square) call problems%add('model', 'theory', &
         & 'is ''dmt'', which only r^2 has: the pull of a long range on other profiles depends on its stress')
      if (is_set(values(in%lambda)) .and. .not. any(kind == [kind_cone, kind_paraboloid, kind_power])) &
         & call problems%add('adhesion', 'lambda', 'has a meaning only for a cone, a paraboloid and a power; give adhesion_stress')
      has_range = nint(values(in%theory)) == choose_maugis_dugdale .or. (nint(values(in%theory)) == choose_auto &
         & .and. any(is_set(values(in%adhesion_stress:in%lambda))))
      if (kind == kind_power .and. has_range .and. values(in%exponent) < 1) call problems%add('shape', 'exponent', &
         & 'is too small for adhesion of a range; allowed with it: a number >= 1 [-]')
   end subroutine check_theory

   !> What is prescribed.
   subroutine check_operation(variables, values, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      integer, parameter :: with_face(*) = [kind_flat_cone, kind_flat_paraboloid, kind_rounded_punch]
      integer :: kind, k

      call require_one(variables, values, [in%load, in%approach, in%contact_radius, in%face_angle, in%base_approach], .true., &
         & problems)
      if (is_set(values(in%base_approach))) call require(variables, values, [in%machine_stiffness], problems)
      if (is_set(values(in%machine_stiffness)) .and. .not. is_set(values(in%base_approach))) call problems%add('operating', &
         & 'machine_stiffness', 'has no meaning without base_approach, the approach of what holds the spring')
      if (values(in%events) > 0 .and. .not. any(is_set(values([in%approach, in%base_approach]))) .and. .not. &
         & (is_set(values(in%load)) .and. (is_set(values(in%shear_strength)) .or. nint(values(in%law)) == law_peeling))) &
         & call problems%add('output', 'events', 'has no meaning at a given load or radius, which makes no cycle; give approach ' &
         & //'or base_approach, or at a given load shear_strength')
      do k = in%contact_radius, in%face_angle
         if (is_set(values(k)) .and. nint(values(in%branch)) /= branch_stable) call problems%add('operating', 'branch', &
            & 'has no meaning with '//variables(k)%name//', which belongs to one state')
      end do
      if (.not. is_set(values(in%kind))) return
      kind = nint(values(in%kind))
      if (kind == kind_flat .and. is_set(values(in%contact_radius))) call problems%add('operating', 'contact_radius', &
         & 'has no meaning for kind = ''flat'', whose whole face is in contact')
      if (is_set(values(in%face_angle)) .and. .not. any(kind == with_face)) call problems%add('operating', 'face_angle', &
         & 'has a meaning only for flat_cone, flat_paraboloid and rounded_punch')
   end subroutine check_operation

   !> Values that are possible one by one, and not together.
   subroutine check_sizes(variables, values, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      type(indenter_case_t) :: case
      integer :: prescribed

      call resolve_case(values, case)
      if (is_set(values(in%lateral_stiffness)) .and. case%height_unit > 0 .and. .not. has_plain_spring(case)) then
         call refuse_size(variables(in%lateral_stiffness), values(in%lateral_stiffness), problems)
         return
      end if
      if (case%height_unit > 0 .and. .not. has_plain_base(case)) then
         call refuse_size(variables(in%base_displacement), values(in%base_displacement), problems)
         return
      end if
      if (is_possible(values, case)) then
         select type (curve => case%curve)
         type is (dugdale_curve_t)
            call check_shear(variables(in%shear_strength:in%pressure_factor), values(in%shear_strength:in%pressure_factor), &
               & curve%stress*case%modulus*(case%height_unit/case%length_unit), problems)
         end select
         return
      end if
      if (nint(values(in%kind)) == kind_sphere .and. case%theory == theory_maugis_dugdale) then
         call problems%add('shape', 'radius', 'is so small that adhesion would reach beyond the sphere')
         return
      end if
      prescribed = in%base_approach
      if (.not. is_set(values(prescribed))) prescribed = in%load - 1 + findloc(is_set(values(in%load:in%face_angle)), .true., 1)
      if (prescribed == in%contact_radius .and. nint(values(in%kind)) == kind_sphere) then
         call problems%add('operating', 'contact_radius', 'is not smaller than the radius of the sphere')
      else if (prescribed == in%contact_radius .and. case%curve%shape%has_face) then
         call problems%add('operating', 'contact_radius', &
            & 'is smaller than face_radius, and without adhesion the whole face is in contact')
      else
         call refuse_size(variables(prescribed), values(prescribed), problems)
      end if
   end subroutine check_sizes

end module adfric_round_check

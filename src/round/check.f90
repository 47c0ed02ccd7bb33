! SPDX-License-Identifier: GPL-3.0-or-later
!> What is missing, contradictory or impossible in an input of the model `indenter`.
module adfric_round_check
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_base_words, only: get_word
   use adfric_round_case, only: has_plain_base, has_plain_spring, indenter_case_t, resolve_case, is_possible
   use adfric_round_contact, only: branch_stable
   use adfric_round_dugdale_curve, only: dugdale_curve_t
   use adfric_round_friction_check, only: check_friction, is_moved
   use adfric_round_variables, only: choose_auto, choose_dmt, choose_jkr, choose_maugis_dugdale, choose_none, &
      & kind_cone, kind_flat, kind_flat_cone, kind_flat_paraboloid, kind_paraboloid, kind_polynomial, kind_power, &
      & kind_rounded_cone, kind_rounded_punch, kind_sphere, law_peeling, theory_maugis_dugdale, in => indenter_input
   use adfric_solid_contact_modulus, only: check_contact_modulus
   use adfric_interface_conduction_rows, only: check_conduction, n_conduction_rows
   use adfric_interface_shear_strength_rows, only: check_shear
   use adfric_round_work_check, only: require_work
   use adfric_describe_check, only: checks_t, new_checks, refuse_size, refuse_swept
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: check_indenter_values, check_history_body, check_shape_alone, check_adhesion

   !> With adhesion, smaller exponents make contacts beyond all numbers; at 1/2 and below no state is stable.
   real(dp), parameter :: least_exponent = 0.51_dp

contains

   !> Add to `problems` what is wrong with the values together.
   subroutine check_indenter_values(variables, values, is_swept, problems)
      type(variable_t), intent(in), target :: variables(:)
      real(dp), intent(in), target :: values(:)
      logical, intent(in) :: is_swept(:)
      type(problems_t), intent(inout), target :: problems
      type(checks_t) :: c
      integer :: before

      before = problems%count()
      call new_checks(c, variables, values, problems)
      call check_body(c, is_moved(values) .or. c%has(in%position_z))
      call check_friction(c)
      call check_adhesion(c)
      call check_operation(c)
      call check_conduction(variables(in%conduction(1):in%conduction(n_conduction_rows)), &
         & values(in%conduction(1):in%conduction(n_conduction_rows)), problems)
      call c%add(in%poisson_ratio, 'is missing [-]; the stresses at position_z need it', &
         & c%has(in%position_z) .and. .not. c%has(in%poisson_ratio))
      if (values(in%profiles) > 0) then
         call c%need([in%r_max])
         call refuse_swept(variables, is_swept, [in%r_max, in%n_r], problems)
      end if
      if (problems%count() == before) call check_sizes(c)
   end subroutine check_indenter_values

   !> Shape and solids of an indenter that goes through a path.
   subroutine check_history_body(variables, values, problems)
      !> Table whose rows up to the moduli are those of this model.
      type(variable_t), intent(in), target :: variables(:)
      real(dp), intent(in), target :: values(:)
      type(problems_t), intent(inout), target :: problems
      type(checks_t) :: c

      call new_checks(c, variables, values, problems)
      call check_body(c, .true.)
   end subroutine check_history_body

   !> Shape of an indenter whose solid is checked elsewhere.
   subroutine check_shape_alone(variables, values, problems)
      !> Table whose rows up to those of the shape are those of this model.
      type(variable_t), intent(in), target :: variables(:)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in), target :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout), target :: problems
      type(checks_t) :: c

      call new_checks(c, variables, values, problems)
      call c%need([in%kind])
      if (c%has(in%kind)) call check_shape(c)
   end subroutine check_shape_alone

   !> Shape and solids.
   subroutine check_body(c, has_own_poisson_ratio)
      type(checks_t), intent(in) :: c
      !> Has Poisson's ratio of the first body a use of its own beside the contact modulus?
      logical, intent(in) :: has_own_poisson_ratio

      call c%need([in%kind])
      if (c%has(in%kind)) call check_shape(c)
      call check_contact_modulus(c%variables(in%contact_modulus:in%second_poisson_ratio), &
         & c%values(in%contact_modulus:in%second_poisson_ratio), c%problems, has_own_poisson_ratio)
   end subroutine check_body

   !> What each kind of shape needs, and what it has no place for.
   subroutine check_shape(c)
      type(checks_t), intent(in) :: c
      logical :: is_used(in%coefficient_8)
      integer :: kind, k

      kind = nint(c%values(in%kind))
      is_used = .false.
      is_used(in%kind) = .true.
      is_used(in%radius) = any(kind == [kind_paraboloid, kind_sphere, kind_flat_paraboloid, kind_rounded_punch, kind_rounded_cone])
      is_used([in%slope, in%half_angle]) = any(kind == [kind_cone, kind_flat_cone, kind_rounded_cone])
      is_used([in%exponent, in%coefficient]) = kind == kind_power
      is_used(in%face_radius) = any(kind == [kind_flat, kind_flat_cone, kind_flat_paraboloid, kind_rounded_punch])
      is_used(in%coefficient_1:in%coefficient_8) = kind == kind_polynomial
      do k = in%radius, in%coefficient_8
         if (is_used(k)) then
            call c%need([k], .not. any(k == [in%slope, in%half_angle]) .and. k < in%coefficient_1)
         else
            call c%add(k, 'has no meaning for kind = '''//get_word(c%variables(in%kind)%choices, kind)//'''', &
               & c%has(k) .and. (k < in%coefficient_1 .or. c%values(k) > 0))
         end if
      end do
      if (is_used(in%slope)) call c%need_one([in%slope, in%half_angle], .true.)
      call c%add(in%coefficient_1, 'is 0 like all coefficients; give one of them, or kind = ''flat''', &
         & kind == kind_polynomial .and. .not. maxval(c%values(in%coefficient_1:in%coefficient_8)) > 0)
   end subroutine check_shape

   !> Theory and work of adhesion.
   subroutine check_adhesion(c)
      type(checks_t), intent(in) :: c
      logical :: has_adhesion, has_range
      integer :: theory

      theory = nint(c%values(in%theory))
      has_adhesion = c%is_above_zero(in%work_of_adhesion)
      has_range = c%has_any([in%adhesion_stress, in%adhesion_range, in%lambda])
      call c%need_one([in%adhesion_stress, in%adhesion_range, in%lambda], theory == choose_maugis_dugdale)
      if (theory >= choose_jkr .or. has_range) then
         call require_work(c, in%work_of_adhesion, [in%adhesion_stress, in%adhesion_range])
         call c%add(in%work_of_adhesion, 'is 0, and this theory needs adhesion', &
            & c%has(in%work_of_adhesion) .and. theory > choose_jkr .and. .not. has_adhesion)
      else
         call c%add(in%work_of_adhesion, 'has no meaning for theory = ''none''', theory == choose_none .and. has_adhesion)
      end if
      if (.not. c%has(in%kind)) return
      call check_theory(c, theory, theory == choose_maugis_dugdale .or. (theory == choose_auto .and. has_range))
      call c%add(in%exponent, &
         & 'is too small for adhesion: at 1/2 and below no state is stable; allowed with adhesion: a number >= 0.51 [-]', &
         & has_adhesion .and. c%is_choice(in%kind, kind_power) .and. c%values(in%exponent) < least_exponent)
   end subroutine check_adhesion

   !> What belongs to some kinds alone: DMT and lambda.
   subroutine check_theory(c, theory, has_range)
      type(checks_t), intent(in) :: c
      !> One of `choose_...`.
      integer, intent(in) :: theory
      !> Does adhesion reach beyond the contact?
      logical, intent(in) :: has_range
      integer :: kind

      kind = nint(c%values(in%kind))
      call c%add(in%theory, 'is ''dmt'', which only r^2 has: the pull of a long range on other profiles depends on its stress', &
         & theory == choose_dmt .and. kind /= kind_paraboloid &
         & .and. .not. (kind == kind_power .and. .not. abs(c%values(in%exponent) - 2) > 0))
      call c%add(in%lambda, 'has a meaning only for a cone, a paraboloid and a power; give adhesion_stress', &
         & c%has(in%lambda) .and. .not. any(kind == [kind_cone, kind_paraboloid, kind_power]))
      call c%add(in%exponent, 'is too small for adhesion of a range; allowed with it: a number >= 1 [-]', &
         & kind == kind_power .and. has_range .and. c%values(in%exponent) < 1)
   end subroutine check_theory

   !> What is prescribed.
   subroutine check_operation(c)
      type(checks_t), intent(in) :: c
      integer, parameter :: with_face(*) = [kind_flat_cone, kind_flat_paraboloid, kind_rounded_punch]
      integer :: k

      call c%need_one([in%load, in%approach, in%contact_radius, in%face_angle, in%base_approach], .true.)
      call c%need([in%machine_stiffness], c%has(in%base_approach))
      call c%add(in%machine_stiffness, 'has no meaning without base_approach, the approach of the base of the spring', &
         & c%has(in%machine_stiffness) .and. .not. c%has(in%base_approach))
      call c%add(in%events, 'has no meaning at a given load or radius, which makes no cycle; give approach ' &
         & //'or base_approach, or at a given load shear_strength', c%values(in%events) > 0 &
         & .and. .not. c%has_any([in%approach, in%base_approach]) .and. .not. &
         & (c%has(in%load) .and. (c%has(in%shear_strength) .or. c%is_choice(in%law, law_peeling))))
      do k = in%contact_radius, in%face_angle
         call c%add(in%branch, 'has no meaning with '//c%variables(k)%name//', which belongs to one state', &
            & c%has(k) .and. .not. c%is_choice(in%branch, branch_stable))
      end do
      if (.not. c%has(in%kind)) return
      call c%add(in%contact_radius, 'has no meaning for kind = ''flat'', whose whole face is in contact', &
         & c%is_choice(in%kind, kind_flat) .and. c%has(in%contact_radius))
      call c%add(in%face_angle, 'has a meaning only for flat_cone, flat_paraboloid and rounded_punch', &
         & c%has(in%face_angle) .and. .not. any(nint(c%values(in%kind)) == with_face))
   end subroutine check_operation

   !> Values that are possible one by one, and not together.
   subroutine check_sizes(c)
      type(checks_t), intent(in) :: c
      type(indenter_case_t) :: case
      integer :: prescribed

      call resolve_case(c%values, case)
      prescribed = in%base_approach
      if (.not. c%has(prescribed)) prescribed = in%load - 1 + findloc(is_set(c%values(in%load:in%face_angle)), .true., 1)
      if (c%has(in%lateral_stiffness) .and. case%height_unit > 0 .and. .not. has_plain_spring(case)) then
         prescribed = in%lateral_stiffness
      else if (case%height_unit > 0 .and. .not. has_plain_base(case)) then
         prescribed = in%base_displacement
      else if (is_possible(c%values, case)) then
         select type (curve => case%curve)
         type is (dugdale_curve_t)
            call check_shear(c%variables(in%shear_strength:in%pressure_factor), c%values(in%shear_strength:in%pressure_factor), &
               & curve%stress*case%modulus*(case%height_unit/case%length_unit), c%problems)
         end select
         return
      else if (c%is_choice(in%kind, kind_sphere) .and. case%theory == theory_maugis_dugdale) then
         call c%add(in%radius, 'is so small that adhesion would reach beyond the sphere')
         return
      else if (prescribed == in%contact_radius .and. c%is_choice(in%kind, kind_sphere)) then
         call c%add(in%contact_radius, 'is not smaller than the radius of the sphere')
         return
      else if (prescribed == in%contact_radius .and. case%curve%shape%has_face) then
         call c%add(in%contact_radius, 'is smaller than face_radius, and without adhesion the whole face is in contact')
         return
      end if
      call refuse_size(c%variables(prescribed), c%values(prescribed), c%problems)
   end subroutine check_sizes

end module adfric_round_check

! SPDX-License-Identifier: GPL-3.0-or-later
!> What data cannot say, whatever the noise: free variables that only occur together, or not at all. Known before anything is
!> solved, it is refused with the reason; what depends on the values is found by the fit.
module adfric_input_fit_identity
   use adfric_base_unset, only: is_set
   use adfric_base_words, only: get_word
   use adfric_fit_problem, only: free_t, nuisance_load_offset, nuisance_friction_offset, nuisance_contact_point, &
      nuisance_lateral_gain, nuisance_spring_stiffness, nuisance_tilt, nuisance_drift_rate
   use adfric_input_case, only: case_t
   use adfric_input_fit_data_group, only: data_group_t
   use adfric_input_fit_values, only: reader_t
   use adfric_input_reading, only: reading_t
   use adfric_describe_model, only: model_t
   use adfric_describe_of_fits, only: is_abscissa_of_fits
   implicit none (type, external)
   private
   public :: check_identity

contains

   !> Report what is known beforehand not to be in the data.
   subroutine check_identity(r, groups, frees, readers)
      type(reading_t), intent(in) :: r
      !> The `&data` groups.
      type(data_group_t), intent(in) :: groups(:)
      type(free_t), intent(in) :: frees(:)
      type(reader_t), intent(in) :: readers(:)
      integer :: i

      do i = 1, size(frees)
         if (frees(i)%nuisance > 0) call check_nuisance(r, groups(frees(i)%data_set), frees, i, readers(i))
      end do
      if (r%model%name /= 'sphere') return
      call check_gain(r, groups, frees, readers)
      call check_friction_alone(r, groups, frees, readers)
      call check_theory(r, frees, readers)
   end subroutine check_identity

   !> Has a nuisance any effect on its data set, and one of its own?
   subroutine check_nuisance(r, group, frees, index, reader)
      type(reading_t), intent(in) :: r
      !> The `&data` group of the nuisance.
      type(data_group_t), intent(in) :: group
      type(free_t), intent(in) :: frees(:)
      !> Which of them it is.
      integer, intent(in) :: index
      type(reader_t), intent(in) :: reader
      logical :: is_x_load, is_y_load, is_approach, is_time, has_effect
      integer :: i

      if (group%data_set%abscissa == 0 .or. group%data_set%ordinate == 0) return
      is_x_load = r%model%variables(group%data_set%abscissa)%name == 'load'
      is_y_load = r%model%results(group%data_set%ordinate)%name == 'load'
      is_approach = r%model%variables(group%data_set%abscissa)%name == 'approach'
      is_time = is_abscissa_of_fits(r%model%variables(group%data_set%abscissa))
      has_effect = .true.
      select case (frees(index)%nuisance)
      case (nuisance_load_offset)
         has_effect = is_x_load .or. is_y_load
      case (nuisance_contact_point)
         has_effect = is_approach .or. r%model%variables(group%data_set%abscissa)%name == 'base_approach' .or. is_time
      case (nuisance_drift_rate)
         has_effect = is_time
      case (nuisance_spring_stiffness)
         has_effect = is_approach
      case (nuisance_tilt)
         has_effect = is_y_load .and. .not. is_x_load
      end select
      if (.not. has_effect) call reader%report(r, 'variable', frees(index)%name//' has no effect on ' &
         //r%model%results(group%data_set%ordinate)%name//' against '//r%model%variables(group%data_set%abscissa)%name &
         //', allowed: a variable that has one')
      if (frees(index)%nuisance /= nuisance_friction_offset .or. .not. is_y_load .or. is_x_load) return
      do i = 1, size(frees)
         if (frees(i)%nuisance /= nuisance_load_offset .or. frees(i)%data_set /= frees(index)%data_set) cycle
         if (is_set(frees(i)%prior) .or. is_set(frees(index)%prior)) cycle
         call reader%report(r, 'variable', frees(index)%name//' and '//frees(i)%name//' are one number where the load is ' &
            //'the ordinate, allowed: one of them free, or a prior')
      end do
   end subroutine check_nuisance

   !> The gain of friction and the shear strength are one number.
   subroutine check_gain(r, groups, frees, readers)
      type(reading_t), intent(in) :: r
      type(data_group_t), intent(in) :: groups(:)
      type(free_t), intent(in) :: frees(:)
      type(reader_t), intent(in) :: readers(:)
      integer :: strength, i, g, last
      logical :: is_known

      strength = find_free(r%model, frees, 'shear_strength')
      if (strength == 0) return
      if (is_set(frees(strength)%prior)) return
      last = 0
      do g = 1, size(groups)
         if (groups(g)%data_set%ordinate == 0) return
         if (r%model%results(groups(g)%data_set%ordinate)%name /= 'friction_force') cycle
         is_known = .true.
         do i = 1, size(frees)
            if (frees(i)%nuisance /= nuisance_lateral_gain .or. frees(i)%data_set /= g) cycle
            is_known = is_set(frees(i)%prior)
            last = i
         end do
         ! one friction with a known gain tells the strength
         if (is_known) return
      end do
      if (last > 0) call readers(last)%report(r, 'variable', frees(last)%name//' and shear_strength are one number: only ' &
         //'their product is in the data, allowed: one of them free, or a prior')
   end subroutine check_gain

   !> What friction against load alone cannot say: F is tau0 R^(4/3) (w/E*)^(2/3) times a function of P/(w R) and lambda.
   subroutine check_friction_alone(r, groups, frees, readers)
      type(reading_t), intent(in) :: r
      type(data_group_t), intent(in) :: groups(:)
      type(free_t), intent(in) :: frees(:)
      type(reader_t), intent(in) :: readers(:)
      integer :: strength, modulus, fraction, g

      do g = 1, size(groups)
         if (groups(g)%data_set%abscissa == 0 .or. groups(g)%data_set%ordinate == 0) return
         if (r%model%results(groups(g)%data_set%ordinate)%name /= 'friction_force') return
         if (r%model%variables(groups(g)%data_set%abscissa)%name /= 'load') return
      end do
      if (is_above_zero(r%input, r%model%index_of('friction', 'interaction'))) return
      strength = find_free(r%model, frees, 'shear_strength')
      modulus = find_free(r%model, frees, 'contact_modulus')
      fraction = find_free(r%model, frees, 'edge_fraction')
      if (strength > 0 .and. modulus > 0) then
         if (.not. (is_set(frees(strength)%prior) .or. is_set(frees(modulus)%prior) .or. is_dugdale_given(r%model, r%input))) &
            call readers(modulus)%report(r, 'variable', 'contact_modulus and shear_strength cannot both be known from ' &
            //'friction against load: only shear_strength^3/contact_modulus^2 is in it, allowed: one of them free, a prior, ' &
            //'or a &data of contact_area')
      end if
      if (fraction > 0 .and. find_free(r%model, frees, 'lambda') > 0) call readers(fraction)%report(r, 'variable', &
         'edge_fraction and lambda cannot both be known from friction against load, allowed: one of them free, or a &data of ' &
         //'contact_area')
   end subroutine check_friction_alone

   !> Is the stress or the range of adhesion prescribed, so that the modulus has a part in lambda?
   pure logical function is_dugdale_given(model, input)
      class(model_t), intent(in) :: model
      type(case_t), intent(in) :: input
      integer :: k, index

      is_dugdale_given = .false.
      do k = 1, 2
         index = model%solver_index_of('sphere', get_word('adhesion_stress adhesion_range', k))
         if (index == 0) cycle
         is_dugdale_given = is_dugdale_given .or. (is_set(input%values(index)) .and. .not. input%is_swept(index))
      end do
   end function is_dugdale_given

   !> Is a number given, and above 0?
   pure logical function is_above_zero(input, index)
      type(case_t), intent(in) :: input
      !> Index of the variable; 0: there is none.
      integer, intent(in) :: index

      is_above_zero = .false.
      if (index == 0) return
      if (is_set(input%values(index))) is_above_zero = input%values(index) > 0
   end function is_above_zero

   !> Has each free variable a meaning in the theory?
   subroutine check_theory(r, frees, readers)
      type(reading_t), intent(in) :: r
      type(free_t), intent(in) :: frees(:)
      type(reader_t), intent(in) :: readers(:)
      character(:), allocatable :: theory
      integer :: index, i, k

      index = r%model%solver_index_of('model', 'theory')
      if (index == 0) return
      theory = get_word(r%model%variables(index)%choices, nint(r%input%values(index)))
      if (theory == 'maugis_dugdale') return
      do k = 1, 3
         i = find_free(r%model, frees, get_word('lambda adhesion_stress adhesion_range', k))
         if (i == 0) cycle
         if (theory == 'auto') then
            call readers(i)%report(r, 'variable', frees(i)%name//' is free, and theory = ''auto'' changes the theory with it, ' &
               //'needed: &model theory = ''maugis_dugdale''')
         else
            call readers(i)%report(r, 'variable', frees(i)%name//' has no meaning with theory = '''//theory &
               //''', needed: &model theory = ''maugis_dugdale''')
         end if
      end do
   end subroutine check_theory

   !> Index of a variable of the model among the free ones; 0 if it is not free.
   pure integer function find_free(model, frees, name)
      class(model_t), intent(in) :: model
      type(free_t), intent(in) :: frees(:)
      character(*), intent(in) :: name
      integer :: i

      find_free = 0
      do i = 1, size(frees)
         if (frees(i)%variable == 0) cycle
         if (model%variables(frees(i)%variable)%name == name) find_free = i
      end do
   end function find_free

end module adfric_input_fit_identity

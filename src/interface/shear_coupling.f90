! SPDX-License-Identifier: GPL-3.0-or-later
!> The row by which shear stress in sliding contact may move this contact, its results, and what an input may not say of it.
!>
!> Below a Poisson's ratio of 1/2 shear tilts the surface. With q = tau + mu p, m = mu beta tells by how much, and part of the friction
!> is then a force T_s on the slopes of the body that no loss makes: it may be below 0.
module adfric_interface_shear_coupling
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_interface_friction_law_rows, only: has_interface, has_law_of_speed, i_pressure_factor, i_pressure_volume, i_strength
   use adfric_interface_total_friction, only: coupling_of
   use adfric_describe_rows, only: result_row, switch
   use adfric_describe_table, only: result_t, variable_t
   implicit none (type, external)
   private
   public :: coupling_row, coupling_results, is_coupled, check_coupling, change_by_coupling, doubt_left_out, n_coupling_results

   !> Number of the results of `coupling_results`.
   integer, parameter :: n_coupling_results = 3

contains

   !> The row, in the group `friction`.
   type(variable_t) function coupling_row()

      coupling_row = switch(group='friction', name='coupling', meaning='let shear stress move the contact, where ' &
         & //'Poisson''s ratio is below 0.5 or a layer is bonded; it does not if not given')
   end function coupling_row

   !> The rows of the results.
   function coupling_results() result(rows)
      type(result_t) :: rows(n_coupling_results)

      rows(1) = result_row(name='largest_coupling', unit='-', long_name='largest size of m, friction coefficient times the ' &
         & //'coupling of a wave by Poisson''s ratio')
      rows(2) = result_row(name='smallest_stiffness_ratio', unit='-', long_name='least real part of the stiffness of a wave ' &
         & //'over its size; above 0 the contact is proved to be the only one')
      rows(3) = result_row(name='coupling_left_out', unit='-', long_name='change of the friction over the friction, to first ' &
         & //'order, by a coupling that is left out')
   end function coupling_results

   !> Does shear move the contact?
   pure logical function is_coupled(value)
      !> Value of the row.
      real(dp), intent(in) :: value

      is_coupled = .false.
      if (is_set(value)) is_coupled = value > 0
   end function is_coupled

   !> Add to `problems` what a coupling needs, and what does not go with it.
   subroutine check_coupling(row, value, friction, poisson_ratio, is_on_cells, problems)
      !> The row; its name is part of the messages.
      type(variable_t), intent(in) :: row
      !> Its value.
      real(dp), intent(in) :: value
      !> Values of the interface; shape `(n_interface_rows)`.
      real(dp), intent(in) :: friction(:)
      !> Poisson's ratio of the solid [-], or unset.
      real(dp), intent(in) :: poisson_ratio
      !> Is the contact one on cells, where the shear stress has to be proportional to the pressure?
      logical, intent(in) :: is_on_cells
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      if (.not. is_set(value)) return
      if (.not. has_interface(friction)) then
         call problems%add(row%group, row%name, 'has no meaning without a shear stress of the interface')
         return
      end if
      if (.not. is_coupled(value)) return
      if (.not. is_set(poisson_ratio)) call problems%add(row%group, row%name, &
         & 'needs poisson_ratio; a contact modulus alone does not tell it')
      if (is_set(friction(i_pressure_volume))) call problems%add(row%group, row%name, &
         & 'stands beside pressure_activation_volume; it takes a shear stress that is constant or goes with the pressure')
      if (.not. is_on_cells) return
      if (has_law_of_speed(friction)) then
         call problems%add(row%group, row%name, 'stands beside a law of the velocity; on cells it takes shear_strength = 0 ' &
            & //'and pressure_factor')
      else if (friction(i_strength) > 0 .or. .not. is_set(friction(i_pressure_factor))) then
         call problems%add(row%group, row%name, 'stands beside a shear_strength above 0, which jumps at the edge of contact, ' &
            & //'so that no cells there keep their state; on cells it takes shear_strength = 0 and pressure_factor')
      end if
   end subroutine check_coupling

   !> Change of the friction of a contact, to first order, if shear stress moved it: -2 (beta/E*) [mean p q - mean p mean q] of a line,
   !> half of it of an area in whose pressure all directions are alike.
   pure real(dp) function change_by_coupling(poisson_ratio, modulus, product, pressure, shear, is_line) result(change)
      !> Poisson's ratio [-], and contact modulus [Pa]; NaN without the former.
      real(dp), intent(in) :: poisson_ratio, modulus
      !> Means of pressure times shear stress, of pressure and of shear stress over a period; or, beside 0 and 0, the integral of the
      !> product over a single contact.
      real(dp), intent(in) :: product, pressure, shear
      !> Does nothing vary across the motion?
      logical, intent(in) :: is_line

      change = not_a_number()
      if (is_set(poisson_ratio)) change = -merge(2, 1, is_line)*(coupling_of(poisson_ratio)/modulus)*(product - pressure*shear)
   end function change_by_coupling

   !> A line on a coupling that is left out and changes the friction by more than its error; else nothing.
   function doubt_left_out(change, error_estimate, has_coupling) result(text)
      !> `coupling_left_out` [-], NaN where it is not known.
      real(dp), intent(in) :: change
      !> Estimated relative error of the friction [-].
      real(dp), intent(in) :: error_estimate
      !> Has the scene a solver that takes the coupling in?
      logical, intent(in) :: has_coupling
      character(:), allocatable :: text
      character(300) :: line

      text = ''
      if (ieee_is_nan(change)) return
      if (.not. abs(change) > error_estimate) return
      write (line, '(a, es9.1, a, es8.1, a)') 'shear stress moves the contact where Poisson''s ratio is below 0.5; left out, as ' &
         & //'here, it changes the friction by', change, ' of it to first order, beside an error of', error_estimate, &
         & trim(merge('; coupling = .true. takes it in', '                               ', has_coupling))
      text = trim(line)//new_line('a')
   end function doubt_left_out

end module adfric_interface_shear_coupling

! SPDX-License-Identifier: GPL-3.0-or-later
!> How a number of a scene becomes that of its solver, and back.
module adfric_run_conversion
   use adfric_base_constants, only: pi
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_base_words, only: has_word
   use adfric_describe_model, only: model_t
   use adfric_describe_table, only: kind_real, variable_t
   implicit none (type, external)
   private
   public :: as_it_is, to_reverse, to_axis, to_degrees, direction_tolerance
   public :: follows_nothing, follows_work, follows_stress
   public :: be_angle, conversion_of, lengths_of, take_spacing
   public :: find_what_follows, is_counted_over_area, text_over_area, to_scene, to_solver, unit_over_area

   !> How a value of the scene becomes that of the solver.
   integer, parameter :: as_it_is = 0, doubled = 1, by_samples_x = 2, by_samples_y = 3, to_reverse = 4, to_axis = 5, to_degrees = 6
   !> Directions count as the nearest one that is allowed if they are no further off [rad].
   real(dp), parameter :: direction_tolerance = 1.0e-4_dp
   !> What of adhesion follows from the other two: nothing, the work, or the stress.
   integer, parameter :: follows_nothing = 0, follows_work = 1, follows_stress = 2
   !> Results of columns that a solver counts for a period, and a scene over the nominal area.
   character(*), parameter :: of_period = 'load friction_force contact_area adhesion_area dissipation edge_loss pull_off_load '// &
      & 'friction_sample_error hysteretic_friction_force interfacial_friction_force'

contains

   !> Indices of the lengths of heights, if the solver does not know their spacing; else 0.
   pure function lengths_of(model) result(indices)
      class(model_t), intent(in) :: model
      integer :: indices(2), heights

      indices = 0
      heights = model%index_of('surface', 'heights')
      if (heights == 0) return
      if (model%variables(heights)%n_attributes() > 0) return
      indices = [model%index_of('surface', 'length_x'), model%index_of('surface', 'length_y')]
   end function lengths_of

   !> Heights may come with their spacing.
   pure subroutine take_spacing(heights)
      type(variable_t), intent(inout) :: heights

      heights%attributes = 'dx dy'
      heights%attribute_units = 'm m'
   end subroutine take_spacing

   !> How a variable is converted.
   pure integer function conversion_of(variable) result(how)
      type(variable_t), intent(in) :: variable

      how = as_it_is
      if (variable%is_called('surface', 'height')) how = doubled
      if (variable%is_called('surface', 'spacing')) how = by_samples_x
      if (variable%is_called('surface', 'strip_spacing')) how = by_samples_y
      if (variable%is_called('surface', 'reverse')) how = to_reverse
      if (variable%is_called('operating', 'tangential_axis')) how = to_axis
      if (variable%is_called('surface', 'direction')) how = to_degrees
   end function conversion_of

   !> A variable is an angle for the scene, instead of a word or of degrees.
   pure subroutine be_angle(variable, how)
      type(variable_t), intent(inout) :: variable
      !> How it is converted.
      integer, intent(in) :: how

      select case (how)
      case (to_reverse)
         variable%meaning = 'direction to which the body slides: 0 along +x, or pi against it'
      case (to_axis)
         variable%meaning = 'direction of the tangential force from the first axis (x, or the major one): 0 or pi/2'
      case default
         variable%meaning = 'direction to which the body slides, from +x to +y; a multiple of pi/2, of pi/4 for waves'
      end select
      variable%kind = kind_real
      variable%has_steps = .true.
      variable%unit = 'rad'
      variable%choices = ''
      variable%lower = -6.5_dp
      variable%upper = 6.5_dp
      if (is_set(variable%default)) variable%default = 0
   end subroutine be_angle

   !> Value of the solver.
   pure real(dp) function to_solver(how, value, samples) result(converted)
      integer, intent(in) :: how
      !> Value of the scene.
      real(dp), intent(in) :: value
      !> Samples of the heights along x and y.
      integer, intent(in) :: samples(2)

      converted = value
      select case (how)
      case (doubled)
         converted = 2*value
      case (by_samples_x)
         converted = value/samples(1)
      case (by_samples_y)
         converted = value/samples(2)
      case (to_reverse)
         converted = merge(1, 0, modulo(nint(value/pi), 2) == 1)
      case (to_axis)
         converted = 1 + modulo(nint(2*value/pi), 2)
      case (to_degrees)
         converted = 180*value/pi
         if (abs(converted - 45*nint(converted/45)) < 180*direction_tolerance/pi) converted = 45*nint(converted/45)
      end select
   end function to_solver

   !> Value of the scene.
   pure real(dp) function to_scene(how, value, samples) result(converted)
      integer, intent(in) :: how
      !> Value of the solver.
      real(dp), intent(in) :: value
      integer, intent(in) :: samples(2)

      converted = value
      select case (how)
      case (doubled)
         converted = value/2
      case (by_samples_x)
         converted = value*samples(1)
      case (by_samples_y)
         converted = value*samples(2)
      case (to_reverse)
         converted = pi*value
      case (to_axis)
         converted = pi/2*(value - 1)
      case (to_degrees)
         converted = value*pi/180
      end select
   end function to_scene

   !> What of adhesion a scene leaves out that its solver asks for. Round bodies ask for the work beside another one, surfaces of
   !> waves and heights for the stress.
   pure integer function find_what_follows(model, facts) result(follows)
      class(model_t), intent(in) :: model
      character(*), intent(in) :: facts

      follows = follows_nothing
      if (has_word('sphere indenter adhesive_indenter_time adhesive_indenter_history', model%name)) then
         if (has_word(facts, 'stress_given') .and. has_word(facts, 'range_given') .and. .not. has_word(facts, 'work_given')) &
            follows = follows_work
      else if (model%index_of('adhesion', 'law') > 0) then
         ! the stress follows from the law
         follows = follows_nothing
      else if (has_word(facts, 'work_given') .and. has_word(facts, 'range_given') .and. .not. has_word(facts, 'stress_given')) then
         follows = follows_stress
      end if
   end function find_what_follows

   !> Does a scene count a result over the nominal area, and the solver for a period?
   pure logical function is_counted_over_area(solver, result_name)
      !> Name of the solver.
      character(*), intent(in) :: solver
      !> Name that the solver has for the result.
      character(*), intent(in) :: result_name

      is_counted_over_area = solver == 'wavy_sliding' .and. has_word(of_period, result_name)
   end function is_counted_over_area

   !> Unit of what the solver counts for a period, over the nominal area: Pa for a force, 1 for an area.
   pure function unit_over_area(unit) result(over_area)
      !> Unit of the solver.
      character(*), intent(in) :: unit
      character(:), allocatable :: over_area

      over_area = '-'
      if (index(unit, 'N') > 0) over_area = 'Pa'
   end function unit_over_area

   !> What a result is that the solver counts for a period, over the nominal area.
   pure function text_over_area(text) result(over_area)
      !> What the solver says.
      character(*), intent(in) :: text
      character(:), allocatable :: over_area
      character(*), parameter :: of_period = ' on one period'
      integer :: at

      at = index(text, of_period)
      over_area = text//' over nominal area'
      if (at > 0) over_area = text(:at - 1)//' over nominal area'//text(at + len(of_period):)
   end function text_over_area

end module adfric_run_conversion

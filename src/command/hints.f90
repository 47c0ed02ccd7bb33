! SPDX-License-Identifier: GPL-3.0-or-later
!> What of friction the user of a run may not mean: a tangential force that no friction holds, and a body at rest.
!>
!> One rule for all contacts with Coulomb's friction: where the force T is more than mu P, the contact slides, and the point has no
!> equilibrium. That is an answer, and a warning tells of it.
module adfric_command_hints
   use adfric_base_kinds, only: dp
   use adfric_base_text, only: newline
   use adfric_base_unset, only: is_set
   use adfric_command_rounding, only: show_to_digits
   use adfric_describe_table, only: variable_t
   use adfric_interface_normal_contact, only: friction_holds
   use adfric_input_run, only: run_input_t
   use adfric_run_plan, only: plan_t
   use adfric_run_run, only: run_t
   implicit none (type, external)
   private
   public :: warn_of_sliding, hint_of_state

contains

   !> A line if a tangential force is more than mu P at a point of the run: a warning where it is so at every point, else a hint.
   !> Empty where the load follows from something else.
   function warn_of_sliding(run) result(line)
      class(run_t), intent(in) :: run
      character(:), allocatable :: line
      real(dp) :: ratios(2)
      integer :: at(3), k

      line = ''
      associate (variables => run%model%variables)
         at(1) = max(find(variables, 'operating', 'tangential_force'), find(variables, 'operating', 'tangential_stress'))
         at(2) = find(variables, 'friction', 'coefficient')
         at(3) = max(find(variables, 'operating', 'load'), find(variables, 'operating', 'mean_pressure'))
         if (any(at == 0)) return
         if (.not. all(is_set(run%plan%base(at)))) return
         ratios = ratios_along(run%plan, at, 0)
         do k = 1, size(run%plan%axes)
            ratios = times(ratios, ratios_along(run%plan, at, k))
         end do
         if (friction_holds(ratios(2), 1.0_dp)) return
         line = 'warning'
         if (friction_holds(ratios(1), 1.0_dp)) line = 'hint'
         line = line//': &'//variables(at(1))%group//' '//variables(at(1))%name//': more than mu P'
         if (friction_holds(ratios(1), 1.0_dp)) line = line//' at some points'
         if (ratios(2) < huge(ratios)) line = line//', up to '//show_to_digits(ratios(2), 3)//' times as much'
         line = line//'; there the contact slides, and the point has no equilibrium'//newline
      end associate
   end function warn_of_sliding

   !> Least and largest share that an axis has in |T|/(mu P), T, mu and P being those that change along it; the other share is that
   !> of what does not change.
   pure function ratios_along(plan, at, axis) result(ends)
      type(plan_t), intent(in) :: plan
      !> Indices of T, mu and P.
      integer, intent(in) :: at(3)
      !> Index of the axis, from 1; 0: what does not change.
      integer, intent(in) :: axis
      real(dp) :: ends(2)
      real(dp), allocatable :: shares(:)
      logical :: belongs(3)
      integer :: i

      if (axis == 0) then
         belongs = [(.not. plan%is_swept(at(i)), i=1, 3)]
         allocate (shares(1), source=1.0_dp)
      else
         belongs = [(any(plan%axes(axis)%variables == at(i)), i=1, 3)]
         allocate (shares(size(plan%axes(axis)%values, 2)), source=1.0_dp)
      end if
      if (belongs(1)) shares = abs(plan%values_of(at(1)))
      do i = 2, 3
         if (belongs(i)) shares = over(shares, plan%values_of(at(i)))
      end do
      ends = [minval(shares), maxval(shares)]
   end function ratios_along

   !> A quotient, 0 for a force of 0, and the largest number where nothing presses.
   elemental real(dp) function over(force, other)
      !> The force, >= 0, and what it is divided by.
      real(dp), intent(in) :: force, other

      over = 0
      if (.not. force > 0) return
      over = huge(over)
      if (other > force/huge(force)) over = force/other
   end function over

   !> A product of numbers that may be the largest.
   elemental real(dp) function times(one, two)
      !> Factors, >= 0.
      real(dp), intent(in) :: one, two

      times = 0
      if (.not. min(one, two) > 0) return
      times = huge(times)
      if (max(one, two) < huge(times)/max(min(one, two), 1.0_dp)) times = one*two
   end function times

   !> A line for a scene with a shear strength whose body neither slides nor has a tangential force.
   function hint_of_state(run) result(line)
      type(run_input_t), intent(in) :: run
      character(:), allocatable :: line
      integer :: i, state

      line = ''
      if (.not. allocated(run%model%scene)) return
      state = find(run%model%variables, 'operating', 'state')
      i = find(run%model%variables, 'friction', 'shear_strength')
      if (state == 0 .or. i == 0) return
      if (.not. is_set(run%plan%base(i)) .or. run%is_given(state)) return
      if (index(run%model%scene, ', pressed') == 0) return
      line = 'hint: the body is at rest, and has no friction force; &operating state = ''sliding'' gives it'//newline
   end function hint_of_state

   !> Index of a variable by its names in the language of the solver; 0 if it has no meaning here.
   pure integer function find(variables, group, name) result(i)
      type(variable_t), intent(in) :: variables(:)
      !> Its group and name.
      character(*), intent(in) :: group, name

      do i = size(variables), 1, -1
         if (variables(i)%is_called(group, name) .and. .not. variables(i)%is_hidden) return
      end do
   end function find

end module adfric_command_hints

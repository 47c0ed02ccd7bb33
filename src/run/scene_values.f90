! SPDX-License-Identifier: GPL-3.0-or-later
!> The values of a scene, which its solver counts otherwise: amplitude for height, lengths for spacings, an angle for a word.
!>
!>     height = 2 amplitude,   spacing = length/samples,   degrees = 180 direction/pi
!>
!> Of work, stress and range of adhesion a scene gives any two; the solver gets those that it knows: work = stress range. The
!> lengths of heights follow from the attributes dx and dy of their dataset where they are not given.
module adfric_run_scene_values
   use adfric_base_constants, only: pi
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set, unset
   use adfric_describe_model, only: model_t
   use adfric_describe_table, only: variable_t
   use adfric_run_conversion, only: as_it_is, be_angle, conversion_of, direction_tolerance, find_what_follows, follows_nothing, &
      follows_stress, follows_work, lengths_of, take_spacing, to_axis, to_degrees, to_reverse, to_scene, to_solver
   use adfric_run_reversal, only: reversal_t
   implicit none (type, external)
   private
   public :: new_scene_values, scene_values_t

   !> How the values of a scene become those of the solver.
   type :: scene_values_t
      !> How each variable is converted; shape `(n_variables)`.
      integer, allocatable :: how(:)
      !> Indices of the variables that are converted.
      integer, allocatable :: changed(:)
      !> Samples of the heights along x and y; 1 where there are none.
      integer :: n_x = 1, n_y = 1
      !> What of adhesion follows from the other two, and the indices of the three.
      integer :: follows = follows_nothing, work = 0, stress = 0, range = 0
      !> Is the surface a wave, which is the same in both directions?
      logical :: is_wave = .false.
      !> Indices of the lengths that the scene gives by the spacing of the heights; 0 where the solver knows the spacing.
      integer :: lengths(2) = 0
      !> Spacing of the samples along x and y that the heights come with [m], or unset.
      real(dp) :: spacing(2) = unset
      !> What the sense of the motion changes.
      type(reversal_t) :: reversal
   contains
      procedure :: are_as_they_are
      procedure :: change_rows
      procedure :: convert
      procedure :: of_scene
      procedure :: check_directions
      procedure :: follows_from_spacing
   end type scene_values_t

contains

   !> How a solver takes the values of a scene.
   subroutine new_scene_values(self, model, surface, facts)
      type(scene_values_t), intent(out) :: self
      !> The solver, with its tables renamed.
      class(model_t), intent(in) :: model
      !> The surface of the scene, and the facts of it, separated by a blank.
      character(*), intent(in) :: surface, facts
      integer :: i

      allocate (self%how(size(model%variables)), source=as_it_is)
      do i = 1, size(self%how)
         self%how(i) = conversion_of(model%variables(i))
      end do
      self%changed = pack([(i, i=1, size(self%how))], self%how /= as_it_is)
      self%follows = find_what_follows(model, facts)
      self%lengths = lengths_of(model)
      self%work = model%index_of('adhesion', 'work_of_adhesion')
      self%stress = model%index_of('adhesion', 'adhesion_stress')
      self%range = model%index_of('adhesion', 'adhesion_range')
      self%is_wave = index(surface, 'wave_') == 1 .and. model%name == 'wavy_sliding'
   end subroutine new_scene_values

   !> Rows of variables become those of the scene.
   pure subroutine change_rows(self, variables)
      class(scene_values_t), intent(in) :: self
      type(variable_t), intent(inout) :: variables(:)
      integer :: i

      do i = 1, size(variables)
         if (any(self%how(i) == [to_reverse, to_axis, to_degrees])) call be_angle(variables(i), self%how(i))
         if (self%lengths(1) > 0 .and. variables(i)%is_called('surface', 'heights')) call take_spacing(variables(i))
      end do
   end subroutine change_rows

   !> Does the solver count as the scene does?
   pure logical function are_as_they_are(self)
      class(scene_values_t), intent(in) :: self

      are_as_they_are = self%follows == follows_nothing .and. size(self%changed) == 0 .and. all(self%lengths == 0)
   end function are_as_they_are

   !> Values of a scene become those of the solver.
   pure subroutine convert(self, values)
      class(scene_values_t), intent(in) :: self
      !> Values of points; shape `(n_variables, n_points)`.
      real(dp), intent(inout), contiguous :: values(:, :)
      integer :: i, j, k

      call self%reversal%turn_values(values)
      do k = 1, size(self%changed)
         i = self%changed(k)
         do j = 1, size(values, 2)
            ! without a word a solver takes its first axis
            if (self%how(i) == to_axis .and. abs(values(i, j)) <= direction_tolerance) values(i, j) = unset
            if (is_set(values(i, j))) values(i, j) = to_solver(self%how(i), values(i, j), [self%n_x, self%n_y])
         end do
      end do
      do k = 1, 2
         if (.not. self%follows_from_spacing(k) .or. k == 2 .and. self%n_y == 1) cycle
         associate (length => values(self%lengths(k), :))
            where (.not. is_set(length)) length = self%spacing(k)*merge(self%n_x, self%n_y, k == 1)
         end associate
      end do
      ! a wave is the same in both directions
      if (self%is_wave) values(self%reversal%direction, :) = unset
      select case (self%follows)
      case (follows_work)
         values(self%work, :) = values(self%stress, :)*values(self%range, :)
         values(self%range, :) = unset
      case (follows_stress)
         values(self%stress, :) = values(self%work, :)/values(self%range, :)
         values(self%range, :) = unset
      end select
   end subroutine convert

   !> Does a length follow from the spacing that the heights come with?
   pure logical function follows_from_spacing(self, k)
      class(scene_values_t), intent(in) :: self
      !> 1 along x, 2 along y.
      integer, intent(in) :: k

      follows_from_spacing = self%lengths(k) > 0 .and. is_set(self%spacing(k))
   end function follows_from_spacing

   !> Value of a scene.
   pure real(dp) function of_scene(self, at, value)
      class(scene_values_t), intent(in) :: self
      !> Index of the variable.
      integer, intent(in) :: at
      !> Value of the solver.
      real(dp), intent(in) :: value

      of_scene = to_scene(self%how(at), value, [self%n_x, self%n_y])
   end function of_scene

   !> Refuse directions that the solver does not know.
   subroutine check_directions(self, model, values, is_swept, problems)
      class(scene_values_t), intent(in) :: self
      !> The solver, with the rows of the scene.
      class(model_t), intent(in) :: model
      !> Values of the scene; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      real(dp) :: step
      integer :: i

      do i = 1, size(values)
         if (self%how(i) /= to_reverse .and. self%how(i) /= to_axis) cycle
         step = merge(pi, pi/2, self%how(i) == to_reverse)
         if (is_swept(i)) call problems%add(model%variables(i)%group, model%variables(i)%name, 'is swept; a run has one direction')
         if (.not. is_set(values(i))) cycle
         if (abs(values(i) - step*nint(values(i)/step)) > direction_tolerance) call problems%add(model%variables(i)%group, &
            model%variables(i)%name, 'is no multiple of '//trim(merge('pi  ', 'pi/2', self%how(i) == to_reverse)))
      end do
   end subroutine check_directions

end module adfric_run_scene_values

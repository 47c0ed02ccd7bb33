! SPDX-License-Identifier: GPL-3.0-or-later
!> The path of a contact with friction: straight steps whose ends are given by lists, of loads or approaches and of tangential forces or
!> displacements. Rows of such lists and of what each step leaves, and what lists may not say.
module adfric_interface_history_path
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: newline, show_count, show_number
   use adfric_base_unset, only: is_set
   use adfric_interface_normal_contact, only: friction_holds
   use adfric_describe_rows, only: list_row, positive, result_row
   use adfric_describe_table, only: profile_t, result_t, variable_t
   implicit none (type, external)
   private
   public :: history_path_t, set_path_rows, set_path_results, set_path_profiles

   !> Positions of the rows among each other: the coefficient of friction, and the lists.
   integer, parameter, public :: path_coefficient = 1, path_loads = 2, path_approaches = 3, path_tangential_forces = 4, &
      & path_tangential_displacements = 5
   integer, parameter, public :: n_path_rows = path_tangential_displacements
   !> Results in the order of their rows; a component is the index of its row.
   type :: path_output_t
      !> Indices of the rows.
      integer :: total_loss = 0, largest_force = 0, largest_displacement = 0
   end type path_output_t
   type(path_output_t), parameter, public :: path_output = transfer(counting, path_output_t())
   integer, parameter, public :: n_path_results = path_output%largest_displacement
   !> Positions of the profiles.
   integer, parameter, public :: p_load = 1, p_approach = 2, p_tangential_force = 3, p_tangential_displacement = 4, &
      & p_contact = 5, p_stick = 6, p_friction_loss = 7
   integer, parameter, public :: n_path_profiles = p_friction_loss

   !> Most steps of a path.
   integer, parameter :: most_steps = 100000000

   !> The numbers of a list of the path; not allocated where it is not given.
   type :: list_t
      !> In SI units; shape `(n_steps)`.
      real(dp), allocatable :: values(:)
   end type list_t

   !> A path.
   type :: history_path_t
      !> Loads, approaches, tangential forces, tangential displacements.
      type(list_t) :: lists(path_loads:path_tangential_displacements)
   contains
      procedure :: count_steps
      procedure :: check
      procedure, private :: check_mixture
      procedure :: warn_of_sliding
   end type history_path_t

contains

   !> The rows of the path, in the groups `friction` and `history`.
   subroutine set_path_rows(rows)
      !> Receives the rows; shape `(n_path_rows)`.
      type(variable_t), intent(out) :: rows(:)

      rows(path_coefficient) = positive(group='friction', name='coefficient', unit='-', meaning='mu of Coulomb''s friction')
      rows(path_coefficient)%has_bare_name = .false.
      rows(path_loads) = list_row(group='history', name='loads', unit='N', &
         & meaning='loads at the ends of straight steps, the first from 0; a list or FILE:/DATASET', most_count=most_steps, &
         & lower=0.0_dp)
      rows(path_approaches) = list_row(group='history', name='approaches', unit='m', meaning='approaches, instead of the loads; ' &
         & //'below 0 out of contact', most_count=most_steps)
      rows(path_tangential_forces) = list_row(group='history', name='tangential_forces', unit='N', &
         & meaning='tangential forces at the ends of the steps, up to mu P of either sign', most_count=most_steps)
      rows(path_tangential_displacements) = list_row(group='history', name='tangential_displacements', unit='m', &
         & meaning='displacements of distant points along the force, instead of the tangential forces', most_count=most_steps)
   end subroutine set_path_rows

   !> The results of a path.
   subroutine set_path_results(results)
      !> Receives the rows; shape `(n_path_results)`.
      type(result_t), intent(out) :: results(:)

      results(path_output%total_loss) = result_row(name='total_friction_loss', unit='J', &
         & long_name='energy that friction has taken by the last step', is_main=.true.)
      results(path_output%largest_force) = result_row(name='largest_tangential_force', unit='N', &
         & long_name='largest size of the tangential force at a step', is_main=.true.)
      results(path_output%largest_displacement) = result_row(name='largest_tangential_displacement', unit='m', &
         & long_name='largest size of the tangential displacement at a step', is_main=.true.)
   end subroutine set_path_results

   !> What each step leaves. How large the contact and what sticks are is named by whoever knows their shape.
   subroutine set_path_profiles(contact, stick, profiles)
      !> Rows of the size of the contact, and of what sticks.
      type(profile_t), intent(in) :: contact, stick
      !> Receives the rows; shape `(n_path_profiles)`.
      type(profile_t), intent(out) :: profiles(:)

      profiles(p_load) = profile_t(name='load', unit='N', long_name='load')
      profiles(p_approach) = profile_t(name='approach', unit='m', long_name='approach of distant points')
      profiles(p_tangential_force) = profile_t(name='tangential_force', unit='N', long_name='tangential force')
      profiles(p_tangential_displacement) = profile_t(name='tangential_displacement', unit='m', &
         & long_name='displacement of distant points along the tangential force')
      profiles(p_contact) = contact
      profiles(p_stick) = stick
      profiles(p_friction_loss) = profile_t(name='friction_loss', unit='J', long_name='energy that friction has taken so far')
   end subroutine set_path_profiles

   !> Number of the steps; 0 where there is no list.
   pure integer function count_steps(self) result(n)
      class(history_path_t), intent(in) :: self
      integer :: k

      n = 0
      do k = path_loads, path_tangential_displacements
         if (allocated(self%lists(k)%values)) n = size(self%lists(k)%values)
      end do
   end function count_steps

   !> Of two rows, the one that is given.
   pure integer function given_of(values, one, two)
      !> Values of the rows; shape `(n_path_rows)`.
      real(dp), intent(in) :: values(:)
      !> Positions of the rows.
      integer, intent(in) :: one, two

      given_of = merge(one, two, is_set(values(one)))
   end function given_of

   !> Add to `problems` lists that are missing or too many, or make no path.
   subroutine check(self, rows, values, problems)
      class(history_path_t), intent(in) :: self
      !> Its rows; their names are part of the messages; shape `(n_path_rows)`.
      type(variable_t), intent(in) :: rows(:)
      !> Values of the rows; shape `(n_path_rows)`.
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      integer :: normal, tangential, before

      before = problems%count()
      call check_pair(rows, values, path_loads, path_approaches, problems)
      call check_pair(rows, values, path_tangential_forces, path_tangential_displacements, problems)
      if (problems%count() > before) return
      normal = given_of(values, path_loads, path_approaches)
      tangential = given_of(values, path_tangential_forces, path_tangential_displacements)
      if (.not. (allocated(self%lists(normal)%values) .and. allocated(self%lists(tangential)%values))) return
      associate (n => self%lists(normal)%values, t => self%lists(tangential)%values)
         if (size(n) /= size(t)) then
            call problems%add('history', rows(tangential)%name, 'has '//show_count(size(t))//' values, and ' &
               & //rows(normal)%name//' has '//show_count(size(n)))
            return
         end if
         if (.not. maxval(n) > 0) call problems%add('history', rows(normal)%name, 'never presses: no value is above 0')
      end associate
      if ((normal == path_loads) .neqv. (tangential == path_tangential_forces)) then
         call self%check_mixture(rows, normal, tangential, problems)
      end if
   end subroutine check

   !> One of two lists is needed.
   subroutine check_pair(rows, values, one, two, problems)
      type(variable_t), intent(in) :: rows(:)
      !> Their values.
      real(dp), intent(in) :: values(:)
      !> Positions of the two.
      integer, intent(in) :: one, two
      type(problems_t), intent(inout) :: problems

      if (is_set(values(one)) .and. is_set(values(two))) then
         call problems%add('history', rows(one)%name, 'stands beside '//rows(two)%name//'; give one of them')
      else if (.not. (is_set(values(one)) .or. is_set(values(two)))) then
         call problems%add('history', rows(one)%name, 'is missing ['//rows(one)%unit//']; give it, or '//rows(two)%name)
      end if
   end subroutine check_pair

   !> Loads with displacements, or approaches with forces: what changes in one step is one of them.
   subroutine check_mixture(self, rows, normal, tangential, problems)
      class(history_path_t), intent(in) :: self
      type(variable_t), intent(in) :: rows(:)
      !> Positions of the lists that are given.
      integer, intent(in) :: normal, tangential
      type(problems_t), intent(inout) :: problems
      integer :: k

      associate (n => self%lists(normal)%values, t => self%lists(tangential)%values)
         do k = 1, size(n)
            if (k == 1) then
               if (.not. abs(t(k)) > 0) cycle
            else
               if (.not. (abs(n(k) - n(k - 1)) > 0 .and. abs(t(k) - t(k - 1)) > 0)) cycle
            end if
            call problems%add('history', rows(tangential)%name, 'changes at step '//show_count(k)//' together with ' &
               & //rows(normal)%name//'; let them change in turn, or give both as forces or both as displacements')
            return
         end do
      end associate
   end subroutine check_mixture

   !> A line if friction does not hold a force of the path; empty where loads or forces follow from displacements.
   function warn_of_sliding(self, values) result(line)
      class(history_path_t), intent(in) :: self
      !> Values of the rows; shape `(n_path_rows)`.
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: line
      integer :: k

      line = ''
      if (.not. all(is_set(values([path_loads, path_tangential_forces, path_coefficient])))) return
      associate (n => self%lists(path_loads)%values, t => self%lists(path_tangential_forces)%values)
         do k = 1, size(n)
            if (friction_holds(t(k), values(path_coefficient)*n(k))) cycle
            line = 'warning: &history tangential_forces: '//show_number(t(k))//' N at step '//show_count(k) &
               & //' is more than mu P; there the contact slides, and the path has no equilibrium'//newline
            return
         end do
      end associate
   end function warn_of_sliding

end module adfric_interface_history_path

! SPDX-License-Identifier: GPL-3.0-or-later
!> The law of attraction as an input gives it: rows of the group `adhesion` behind those of `adfric_interface_adhesion_rows`, whose values
!> stand in front of theirs wherever both are asked for. Two of stress, work and range give the third, by each law's own ratio.
module adfric_interface_attraction_rows
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set, unset
   use adfric_interface_adhesion_rows, only: adhesion_law_t, branch_approach, check_adhesion, has_adhesion, n_adhesion_rows, &
      & resolve_adhesion
   use adfric_interface_attraction, only: attraction_of_table, attraction_of_two, attraction_t, law_dugdale, law_lennard_jones, &
      & law_table, law_words, work_ratio
   use adfric_describe_rows, only: above_zero, choice, columns_row, dataset
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: given_attraction_t, set_attraction_rows, check_attraction, has_attraction, has_wall_at_contact
   public :: largest_tension, resolve_attraction, n_attraction_rows
   public :: law_row, table_row, problem_of_table

   !> Indices among the rows of adhesion.
   integer, parameter :: stress = 1, energy = 2, range = 3, branch = 4
   !> Part by which a work of opening may be below that of closing by round-off.
   real(dp), parameter :: rounding = 1.0e-12_dp
   !> Indices behind them.
   integer, parameter :: law = n_adhesion_rows + 1, table = n_adhesion_rows + 2, map = n_adhesion_rows + 3, &
      & opening = n_adhesion_rows + 4
   !> Number of the rows of this file.
   integer, parameter :: n_attraction_rows = opening - n_adhesion_rows

   !> What an input gives of the attraction beside single numbers.
   type :: given_attraction_t
      !> Gaps [m] and tensions [Pa] of a table; shape `(n, 2)`; not allocated without one.
      real(dp), allocatable :: table(:, :)
      !> Work of adhesion of the cells over `work_of_adhesion`; shape of the cells; not allocated: 1.
      real(dp), allocatable :: map(:, :)
   contains
      procedure :: take
   end type given_attraction_t

contains

   !> The rows, in the group `adhesion`.
   subroutine set_attraction_rows(rows)
      !> Receives the rows; shape `(n_attraction_rows)`.
      type(variable_t), intent(out) :: rows(:)
      character(*), parameter :: group = 'adhesion'

      rows(law - n_adhesion_rows) = law_row(law_words)
      rows(table - n_adhesion_rows) = table_row()
      rows(map - n_adhesion_rows) = dataset(group=group, name='work_map', unit='-', largest_rank=2, least_count=1, &
         & meaning='work of adhesion of each cell of the heights over work_of_adhesion; 1 if not given')
      rows(opening - n_adhesion_rows) = above_zero(group=group, name='opening_work_of_adhesion', unit='J/m^2', &
         & meaning='work of adhesion that opening takes, at the same stress; if not given that of closing')
   end subroutine set_attraction_rows

   !> The row of the law.
   type(variable_t) function law_row(choices) result(row)
      !> Words of the laws that a model has, separated by a blank.
      character(*), intent(in) :: choices
      character(:), allocatable :: meaning

      meaning = 'tension over gap g, with range r: constant up to r; exp(-g/r); 1 - g/r; (1 + g/r)^-3; '
      if (index(choices, 'lennard_jones') > 0) meaning = meaning//'(1 + g/r)^-3 - (1 + g/r)^-9; '
      row = choice(group='adhesion', name='law', choices=choices, default='dugdale', meaning=meaning//'a table')
   end function law_row

   !> The row of the table of a law.
   type(variable_t) function table_row() result(row)
      row = columns_row(group='adhesion', name='tension_table', columns='gap tension', units='m Pa', &
         & meaning='group with the tension over the gap, falling to 0, for the law table', least_count=2, lower=0.0_dp)
   end function table_row

   !> Keep a dataset; nothing of another variable.
   subroutine take(self, index, values)
      class(given_attraction_t), intent(inout) :: self
      !> Index of the variable among the rows of `set_attraction_rows`.
      integer, intent(in) :: index
      !> The values in SI units.
      real(dp), intent(in) :: values(:, :)

      if (index == table - n_adhesion_rows) self%table = values
      if (index == map - n_adhesion_rows) self%map = values
   end subroutine take

   !> Index of the law, one of `law_...`.
   pure integer function law_of(values)
      !> Values of the rows of adhesion and attraction.
      real(dp), intent(in) :: values(:)

      law_of = law_dugdale
      if (is_set(values(law))) law_of = nint(values(law))
   end function law_of

   !> Is there a hard wall at the gap 0?
   pure logical function has_wall_at_contact(values) result(has_wall)
      !> Values of the rows of adhesion and attraction.
      real(dp), intent(in) :: values(:)

      has_wall = law_of(values) /= law_lennard_jones
   end function has_wall_at_contact

   !> Values of the rows of adhesion, with a stress where work and range stand for it: that of Dugdale's law, which has a work as other
   !> laws do.
   pure function with_stress(values) result(adhesion)
      !> Values of the rows of adhesion and attraction.
      real(dp), intent(in) :: values(:)
      real(dp) :: adhesion(n_adhesion_rows)

      adhesion = values(:n_adhesion_rows)
      if (is_set(adhesion(stress)) .or. .not. (is_set(adhesion(energy)) .and. is_set(adhesion(range)))) return
      adhesion(stress) = adhesion(energy)/adhesion(range)
      adhesion(range) = unset
   end function with_stress

   !> Does adhesion act?
   pure logical function has_attraction(values)
      !> Values of the rows of adhesion and attraction.
      real(dp), intent(in) :: values(:)

      if (law_of(values) == law_table) then
         has_attraction = is_set(values(table))
      else
         has_attraction = has_adhesion(with_stress(values))
      end if
   end function has_attraction

   !> Largest tension [Pa]; 0 without adhesion, or where a table is not known.
   pure real(dp) function largest_tension(values, given) result(tension)
      !> Values of the rows of adhesion and attraction.
      real(dp), intent(in) :: values(:)
      !> Table of the law, if there is one.
      type(given_attraction_t), intent(in) :: given

      tension = 0
      if (.not. has_attraction(values)) return
      if (law_of(values) == law_table) then
         if (allocated(given%table)) tension = given%table(1, 2)
      else if (is_set(values(stress))) then
         tension = values(stress)
      else
         tension = values(energy)/(work_ratio(law_of(values))*values(range))
      end if
   end function largest_tension

   !> The adhesion of values that have been checked.
   pure subroutine resolve_attraction(values, given, adhesion)
      !> Values of the rows of adhesion and attraction.
      real(dp), intent(in) :: values(:)
      !> Table of the law and map of the work.
      type(given_attraction_t), intent(in) :: given
      !> Receives the adhesion. Stress and range are those of Dugdale's law with the same largest tension and work.
      type(adhesion_law_t), intent(out) :: adhesion

      if (law_of(values) == law_dugdale) then
         call resolve_adhesion(with_stress(values), adhesion)
      else
         call resolve_law(values, given, adhesion)
      end if
      if (.not. adhesion%stress > 0) return
      if (allocated(given%map)) allocate (adhesion%part, source=given%map)
      if (.not. is_set(values(opening))) return
      adhesion%opening = values(opening)/(adhesion%stress*adhesion%range)
      ! equal works are one
      if (adhesion%opening < 1 + rounding) adhesion%opening = 1
   end subroutine resolve_attraction

   !> The adhesion by another law than Dugdale's.
   pure subroutine resolve_law(values, given, adhesion)
      !> Values of the rows of adhesion and attraction.
      real(dp), intent(in) :: values(:)
      !> Table of the law.
      type(given_attraction_t), intent(in) :: given
      !> Receives the adhesion.
      type(adhesion_law_t), intent(out) :: adhesion
      type(attraction_t) :: found
      real(dp) :: rows(n_adhesion_rows)

      rows = with_stress(values)
      if (.not. has_attraction(values)) then
         return
      else if (law_of(values) == law_table) then
         if (.not. allocated(given%table)) return
         found = attraction_of_table(given%table(:, 1), given%table(:, 2))
      else
         found = attraction_of_two(law_of(values), values(stress), values(energy), values(range))
      end if
      rows(stress) = found%stress
      rows(energy) = found%work
      rows(range) = unset
      call resolve_adhesion(rows, adhesion)
      allocate (adhesion%attraction, source=found)
   end subroutine resolve_law

   !> What is wrong with the table of a law: gaps rise from 0, and tensions fall from above 0 to 0. Empty if nothing is.
   pure function problem_of_table(samples) result(text)
      !> Gaps and tensions; shape `(n, 2)`.
      real(dp), intent(in) :: samples(:, :)
      character(:), allocatable :: text
      integer :: n

      text = ''
      n = size(samples, 1)
      if (abs(samples(1, 1)) > 0) then
         text = 'does not begin with the gap 0'
      else if (.not. all(samples(2:, 1) > samples(:n - 1, 1))) then
         text = 'has gaps that do not rise'
      else if (.not. samples(1, 2) > 0) then
         text = 'has no tension in contact'
      else if (any(samples(2:, 2) > samples(:n - 1, 2))) then
         text = 'has tensions that rise with the gap'
      else if (samples(n, 2) > 0) then
         text = 'does not end with the tension 0'
      end if
   end function problem_of_table

   !> Add to `problems` what is missing, stands beside another, or is wrong with the datasets.
   subroutine check_attraction(rows, values, given, problems)
      !> Rows of adhesion and attraction; their names are part of the messages.
      type(variable_t), intent(in) :: rows(:)
      !> Their values.
      real(dp), intent(in) :: values(:)
      !> Table of the law and map of the work.
      type(given_attraction_t), intent(in) :: given
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      real(dp) :: adhesion(n_adhesion_rows)
      character(:), allocatable :: text
      integer :: k, n_before

      n_before = problems%count()
      adhesion = with_stress(values)
      if (law_of(values) == law_table) then
         do k = stress, range
            if (is_set(values(k))) call add(k, 'has no meaning for law = ''table'', which has the tensions themselves')
         end do
         if (.not. is_set(values(table))) then
            call add(table, 'is missing; law = ''table'' needs it')
         else if (allocated(given%table)) then
            text = problem_of_table(given%table)
            if (len(text) > 0) call add(table, text)
         end if
         adhesion(stress:range) = [1.0_dp, 1.0_dp, unset]
      else if (is_set(values(table))) then
         call add(table, 'has no meaning without law = ''table''')
      else if (law_of(values) /= law_dugdale .and. .not. any(is_set(values(stress:range)))) then
         call add(law, 'needs two of '//rows(energy)%name//', '//rows(stress)%name//' and '//rows(range)%name)
      end if
      call check_adhesion(rows(:n_adhesion_rows), adhesion, problems)
      if (is_set(values(opening)) .and. problems%count() == n_before) call check_opening(rows, values, given, problems)
      if (.not. (is_set(values(map)) .and. allocated(given%map))) return
      if (any(given%map < 0)) call add(map, 'has works below 0')
      if (.not. any(given%map > 0)) call add(map, 'has no work above 0')
      if (.not. has_wall_at_contact(values) .and. .not. all(given%map > 0)) call add(map, 'has works of 0, which do not push, '// &
         & 'and law = ''lennard_jones'' has no wall')

   contains

      !> Add a problem of one row to the list.
      subroutine add(row, problem)
         !> Index of the variable among the rows.
         integer, intent(in) :: row
         !> What is wrong with the variable.
         character(*), intent(in) :: problem

         call problems%add(rows(row)%group, rows(row)%name, problem)
      end subroutine add

   end subroutine check_attraction

   !> Add to `problems` a work of opening that is less than closing gives, or without a closing before it.
   subroutine check_opening(rows, values, given, problems)
      !> Rows of adhesion and attraction; their names are part of the messages.
      type(variable_t), intent(in) :: rows(:)
      !> Their values, nothing else of which is wrong.
      real(dp), intent(in) :: values(:)
      !> Table of the law.
      type(given_attraction_t), intent(in) :: given
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      type(adhesion_law_t) :: law

      associate (row => rows(opening))
         if (.not. has_attraction(values)) then
            call problems%add(row%group, row%name, 'has no meaning without a stress of adhesion')
         else if (.not. has_wall_at_contact(values)) then
            call problems%add(row%group, row%name, 'has no meaning for law = ''lennard_jones'', which pushes in contact')
         else if (nint(values(branch)) == branch_approach) then
            call problems%add(row%group, row%name, 'has no meaning for branch = ''approach'', which does not open')
         else
            call resolve_attraction(values, given, law)
            if (law%stress > 0 .and. values(opening) < (1 - rounding)*law%stress*law%range) &
               & call problems%add(row%group, row%name, 'is below '//rows(energy)%name//', which closing gives')
         end if
      end associate
   end subroutine check_opening

end module adfric_interface_attraction_rows

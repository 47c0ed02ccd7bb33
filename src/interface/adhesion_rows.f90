! SPDX-License-Identifier: GPL-3.0-or-later
!> The adhesion of surfaces: a stress pulls where the gap is at most its range (Dugdale), and stress times range is the surface energy.
!> Every model with the group `adhesion` has its rows from here, and says the same where they are wrong. Models of a half-space have
!> all rows, one behind the other, and read them by `resolve_adhesion`; `wavy_sliding` has those of the stress, with rows of its own
!> between them and the branch.
module adfric_interface_adhesion_rows
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_interface_attraction, only: attraction_t
   use adfric_describe_rows, only: above_zero, any_number, choice, result_row
   use adfric_describe_table, only: result_t, variable_t
   implicit none (type, external)
   private
   public :: set_adhesion_rows, set_stress_rows, branch_row, check_adhesion, check_stress, has_adhesion, range_of, resolve_adhesion
   public :: branches_differ_row, adhesion_law_t, n_adhesion_rows, n_stress_rows, branch_adhered, branch_approach, adhesion_names

   !> Indices among the rows.
   integer, parameter :: stress = 1, surface_energy = 2, range = 3, branch = 4, turning_pressure = 5
   !> Number of rows of the stress with its range, and of all.
   integer, parameter :: n_stress_rows = range, n_adhesion_rows = turning_pressure
   !> Names of the rows of the stress.
   character(*), parameter :: adhesion_names = 'stress surface_energy range'
   !> Indices of the words in the choice of the branch.
   integer, parameter :: branch_adhered = 1, branch_approach = 2

   !> An adhesion as the rows give it.
   type :: adhesion_law_t
      !> Stress [Pa], 0 without adhesion.
      real(dp) :: stress = 0
      !> Largest gap with adhesion [m]; of no meaning where the stress is 0.
      real(dp) :: range = 0
      !> One of `branch_...`.
      integer :: branch = branch_adhered
      !> Mean pressure at which the approach has turned [Pa]; not allocated if it went on up to full contact. So it may stand for an
      !> optional argument.
      real(dp), allocatable :: turning_pressure
      !> Another law than Dugdale's [Pa, m]; not allocated: Dugdale's.
      type(attraction_t), allocatable :: attraction
      !> Work of adhesion of the cells over that of the law; shape of the cells; not allocated: 1.
      real(dp), allocatable :: part(:, :)
      !> Work that opening takes over that which closing gives, >= 1.
      real(dp) :: opening = 1
   end type adhesion_law_t

contains

   !> All rows, in the group `adhesion`.
   subroutine set_adhesion_rows(rows)
      !> Receives the rows; shape `(n_adhesion_rows)`.
      type(variable_t), intent(out) :: rows(:)

      call set_stress_rows(rows(:n_stress_rows))
      rows(branch) = branch_row()
      rows(turning_pressure) = any_number(group='adhesion', name='turning_pressure', unit='Pa', &
         & meaning='mean pressure up to which the surfaces have approached before they part again: of the adhered branch, full ' &
         & //'contact if not given, and of a solid that yields', lower=0.0_dp)
   end subroutine set_adhesion_rows

   !> Whether the branches differ, among the results.
   type(result_t) function branches_differ_row() result(row)

      row = result_row(name='branches_differ', unit='-', &
         & long_name='1 where the other branch has another state, 0 where it has none or the same')
   end function branches_differ_row

   !> The rows of the stress and its range.
   subroutine set_stress_rows(rows)
      !> Receives the rows; shape `(n_stress_rows)`.
      type(variable_t), intent(out) :: rows(:)

      rows(stress) = any_number(group='adhesion', name='stress', unit='Pa', meaning='adhesion stress p0; 0: no adhesion', &
         & lower=0.0_dp)
      rows(surface_energy) = above_zero(group='adhesion', name='surface_energy', unit='J/m^2', meaning='stress times range')
      rows(range) = above_zero(group='adhesion', name='range', unit='m', &
         & meaning='largest gap with adhesion, instead of the surface energy')
   end subroutine set_stress_rows

   !> The row of the branch.
   function branch_row() result(row)
      type(variable_t) :: row

      row = choice(group='adhesion', name='branch', &
         & meaning='where states coexist: the one that unloading keeps (adhered) or that loading meets (approach)', &
         & choices='adhered approach', default='adhered')
   end function branch_row

   !> Does adhesion act?
   pure logical function has_adhesion(values)
      !> Values of the rows; shape `(n_adhesion_rows)`.
      real(dp), intent(in) :: values(:)

      has_adhesion = is_set(values(stress)) .and. values(stress) > 0
   end function has_adhesion

   !> Largest gap with adhesion [m], where there is a stress.
   pure real(dp) function range_of(values)
      !> Values of the rows; shape `(n_stress_rows)` at least.
      real(dp), intent(in) :: values(:)

      range_of = values(range)
      if (.not. is_set(range_of)) range_of = values(surface_energy)/values(stress)
   end function range_of

   !> The adhesion of values that have been checked.
   pure subroutine resolve_adhesion(values, law)
      !> Values of the rows; shape `(n_adhesion_rows)`.
      real(dp), intent(in) :: values(:)
      !> Receives the adhesion.
      type(adhesion_law_t), intent(out) :: law

      if (.not. has_adhesion(values)) return
      law%stress = values(stress)
      law%range = range_of(values)
      law%branch = nint(values(branch))
      if (is_set(values(turning_pressure))) law%turning_pressure = values(turning_pressure)
   end subroutine resolve_adhesion

   !> Add to `problems` what is missing or stands beside another.
   subroutine check_adhesion(rows, values, problems)
      !> The rows of `set_adhesion_rows`; their names are part of the messages.
      type(variable_t), intent(in) :: rows(:)
      !> Values of the rows; shape `(n_adhesion_rows)`.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      call check_stress(rows, values, problems)
      if (.not. is_set(values(turning_pressure))) return
      associate (row => rows(turning_pressure))
         if (.not. is_set(values(stress))) then
            call problems%add(row%group, row%name, 'has no meaning without adhesion, or the hardness of a half-space')
         else if (nint(values(branch)) == branch_approach) then
            call problems%add(row%group, row%name, 'has no meaning for branch = ''approach'', which has not turned')
         end if
      end associate
   end subroutine check_adhesion

   !> A stress with an energy or a range, and nothing of it without a stress.
   subroutine check_stress(rows, values, problems)
      !> The rows of `set_stress_rows`; others may follow.
      type(variable_t), intent(in) :: rows(:)
      !> Values of the rows; shape `(n_stress_rows)` at least.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      if (.not. is_set(values(stress))) then
         if (is_set(values(surface_energy))) call add(stress, 'is missing [Pa]; '//rows(surface_energy)%name//' needs it')
         if (is_set(values(range))) call add(stress, 'is missing [Pa]; '//rows(range)%name//' needs it')
      else if (is_set(values(surface_energy)) .and. is_set(values(range))) then
         call add(surface_energy, 'stands beside '//rows(range)%name//'; beside '//rows(stress)%name//' one of them is enough')
      else if (.not. is_set(values(surface_energy)) .and. .not. is_set(values(range))) then
         if (values(stress) > 0) call add(surface_energy, 'is missing [J/m^2]; '//rows(stress)%name//' needs it, or '// &
            & rows(range)%name)
      end if

   contains

      !> Add a problem of one row to the list.
      subroutine add(index, text)
         !> Index of the variable among the rows, such as `stress`.
         integer, intent(in) :: index
         !> What is wrong with the variable; its name is put before this.
         character(*), intent(in) :: text

         call problems%add(rows(index)%group, rows(index)%name, text)
      end subroutine add

   end subroutine check_stress

end module adfric_interface_adhesion_rows

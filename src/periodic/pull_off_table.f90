! SPDX-License-Identifier: GPL-3.0-or-later
!> Pull-offs of the surfaces of a run: the first point of a surface has its pull-off found, all others look it up.
!>
!> All threads use one table. What stands in it depends on the surface and its adhesion alone, so it does not matter who found it.
module adfric_periodic_pull_off_table
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp
   use adfric_numerics_found_once, only: found_once_t, search_t
   use adfric_periodic_adhesive_pull_off, only: periodic_pull_off_t, find_pull_off
   use adfric_periodic_adhesive_solver, only: periodic_adhesion_t
   use adfric_periodic_attracted_pull_off, only: find_attracted_pull_off
   use adfric_periodic_attracted_surface, only: periodic_attraction_t
   use adfric_periodic_solver, only: periodic_solver_t
   implicit none (type, external)
   private
   public :: get_pull_off, seek_on_grid

contains

   !> The pull-off of a surface on one grid by any law, from the table where there is one.
   subroutine seek_on_grid(table, solver, shape, solid, tolerance, adhesion, attraction, pull_off, error)
      !> The table of Dugdale's law, which receives what had to be found; null: none. Other laws have none.
      type(found_once_t), pointer, intent(in) :: table
      type(periodic_solver_t), intent(inout) :: solver
      !> Gap of the undeformed surfaces in the middles of the cells [periods along x].
      real(dp), intent(in) :: shape(:, :)
      !> Periods, and the numbers from which the kernel of the solid is made.
      real(dp), intent(in) :: solid(:)
      real(dp), intent(in) :: tolerance
      !> Dugdale's law; of no meaning beside another one.
      type(periodic_adhesion_t), intent(in), optional :: adhesion
      !> Another law.
      type(periodic_attraction_t), intent(in), optional :: attraction
      type(periodic_pull_off_t), intent(out) :: pull_off
      type(error_t), allocatable, intent(out) :: error

      if (present(attraction)) then
         call find_attracted_pull_off(solver, shape, attraction, tolerance, pull_off)
      else if (associated(table)) then
         call get_pull_off(table, solver, shape, solid, adhesion, tolerance, pull_off, error)
      else
         call find_pull_off(solver, shape, adhesion, tolerance, pull_off, error)
      end if
   end subroutine seek_on_grid

   !> The pull-off of a surface, from the table if it stands there.
   subroutine get_pull_off(table, solver, shape, solid, adhesion, tolerance, pull_off, error)
      !> The table, which receives what had to be found.
      type(found_once_t), intent(inout) :: table
      type(periodic_solver_t), intent(inout) :: solver
      !> Gap of the undeformed surfaces in the middles of the cells [periods along x].
      real(dp), intent(in) :: shape(:, :)
      !> Periods, that along x 1, and the numbers from which the kernel of the solid is made.
      real(dp), intent(in) :: solid(:)
      type(periodic_adhesion_t), intent(in) :: adhesion
      real(dp), intent(in) :: tolerance
      type(periodic_pull_off_t), intent(out) :: pull_off
      type(error_t), allocatable, intent(out) :: error
      type(search_t) :: search
      real(dp), allocatable :: parts(:)
      real(dp) :: found(5)
      logical :: is_known

      found = 0
      allocate (parts(0))
      if (allocated(adhesion%part)) parts = pack(adhesion%part, .true.)
      if (allocated(adhesion%law)) then
         parts = [parts, real(adhesion%law%law, dp), adhesion%law%stress, adhesion%law%range]
         if (allocated(adhesion%law%gaps)) parts = [parts, adhesion%law%gaps, adhesion%law%tensions]
      end if
      call look_up(table, [adhesion%stress, adhesion%range, merge(adhesion%turning_pressure, -1.0_dp, adhesion%has_turned), &
         & adhesion%opening, tolerance, solid, parts, real(size(shape, 1), dp), &
         & merge(1.0_dp, 0.0_dp, solver%grids(1)%operator%is_quarter)], shape, found, is_known, search)
      if (is_known) then
         pull_off = periodic_pull_off_t(found(1), found(2), found(3), found(4) > 0, found(5))
         return
      end if
      call find_pull_off(solver, shape, adhesion, tolerance, pull_off, error)
      if (allocated(error)) then
         call table%give_up(search)
      else
         call table%keep(search, [pull_off%mean_pressure, pull_off%penetration, pull_off%n_pairs, &
            & merge(1.0_dp, 0.0_dp, pull_off%is_found), pull_off%margin])
      end if
   end subroutine get_pull_off

   !> Look up the numbers of a pull-off.
   subroutine look_up(table, numbers, shape, found, is_known, search)
      type(found_once_t), intent(inout) :: table
      !> Numbers that it depends on beside the gaps.
      real(dp), intent(in) :: numbers(:)
      !> Gap of the undeformed surfaces [periods along x].
      real(dp), intent(in) :: shape(:, :)
      !> Receives the numbers if they are known.
      real(dp), intent(inout) :: found(:)
      !> Are they known? They are not where there is no memory to look them up.
      logical, intent(out) :: is_known
      !> Receives what it needs to keep them.
      type(search_t), intent(out) :: search
      real(dp), allocatable :: key(:)
      integer :: j, failure

      is_known = .false.
      allocate (key(size(numbers) + size(shape)), stat=failure)
      if (failure /= 0) return
      key(:size(numbers)) = numbers
      do j = 1, size(shape, 2)
         key(size(numbers) + (j - 1)*size(shape, 1) + 1:size(numbers) + j*size(shape, 1)) = shape(:, j)
      end do
      call table%look_up(key, found, is_known, search)
   end subroutine look_up

end module adfric_periodic_pull_off_table

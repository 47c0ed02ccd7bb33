!> Pull-offs of the surfaces of a run: the first point of a surface finds its pull-off, all others look it up.
!>
!> All threads use one list. What stands in it depends on the surface and its adhesion alone, so it does not matter who found it; two
!> threads that need one at the same time may both find it, to the same bits.
module adfric_periodic_pull_off_list
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp
   use adfric_periodic_adhesive_pull_off, only: pull_off_t, find_pull_off
   use adfric_periodic_adhesive_solver, only: periodic_adhesion_t
   use adfric_periodic_solver, only: periodic_solver_t
   implicit none (type, external)
   private
   public :: pull_off_list_t, get_pull_off

   !> Surfaces that are kept; then the oldest ones are forgotten.
   integer, parameter :: most_surfaces = 32
   !> Numbers that a pull-off depends on beside the shape.
   integer, parameter :: n_numbers = 7

   !> A surface whose pull-off is known.
   type :: known_pull_off_t
      !> Adhesion, tolerance, periods and symmetry.
      real(dp) :: numbers(n_numbers) = 0
      !> Gap of the undeformed surfaces [periods along x]; not allocated: none is known.
      real(dp), allocatable :: shape(:, :)
      !> The pull-off; pressures in E*, lengths in periods along x.
      type(pull_off_t) :: pull_off
   end type known_pull_off_t

   !> The surfaces.
   type :: pull_off_list_t
      private
      !> In the order in which they were found, the oldest one overwritten.
      type(known_pull_off_t) :: known(most_surfaces)
      !> How often a pull-off was found, since it did not stand in the list.
      integer, public :: n_found = 0
   end type pull_off_list_t

contains

   !> The pull-off of a surface, from the list if it stands there.
   subroutine get_pull_off(list, solver, shape, period, adhesion, tolerance, pull_off, error)
      !> The list, which receives what had to be found.
      type(pull_off_list_t), intent(inout) :: list
      !> Solver for surfaces of these cells and periods.
      type(periodic_solver_t), intent(inout) :: solver
      !> Gap of the undeformed surfaces in the middles of the cells [periods along x].
      real(dp), intent(in) :: shape(:, :)
      !> Periods, that along x 1.
      real(dp), intent(in) :: period(2)
      !> The law; lengths in periods along x.
      type(periodic_adhesion_t), intent(in) :: adhesion
      !> Largest residual that is allowed [-].
      real(dp), intent(in) :: tolerance
      !> The pull-off.
      type(pull_off_t), intent(out) :: pull_off
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error
      real(dp) :: numbers(n_numbers)
      integer :: place

      numbers = [adhesion%stress, adhesion%range, merge(adhesion%turning_pressure, -1.0_dp, adhesion%has_turned), tolerance, &
         & period, merge(1.0_dp, 0.0_dp, solver%grids(1)%operator%is_quarter)]
      !$omp critical (adfric_periodic_pull_off_list)
      place = place_of(list, numbers, shape)
      if (place > 0) pull_off = list%known(place)%pull_off
      !$omp end critical (adfric_periodic_pull_off_list)
      if (place > 0) return
      call find_pull_off(solver, shape, adhesion, tolerance, pull_off, error)
      if (allocated(error)) return
      !$omp critical (adfric_periodic_pull_off_list)
      associate (known => list%known(1 + modulo(list%n_found, most_surfaces)))
         known%numbers = numbers
         known%shape = shape
         known%pull_off = pull_off
      end associate
      list%n_found = list%n_found + 1
      !$omp end critical (adfric_periodic_pull_off_list)
   end subroutine get_pull_off

   !> Where a surface stands in the list; 0 if it does not.
   pure integer function place_of(list, numbers, shape) result(place)
      !> The list.
      type(pull_off_list_t), intent(in) :: list
      !> Adhesion, tolerance, periods and symmetry.
      real(dp), intent(in) :: numbers(:)
      !> Gap of the undeformed surfaces [periods along x].
      real(dp), intent(in) :: shape(:, :)
      integer :: k

      place = 0
      do k = 1, most_surfaces
         if (.not. allocated(list%known(k)%shape)) return
         associate (known => list%known(k))
            if (any(abs(known%numbers - numbers) > 0)) cycle
            if (size(known%shape, 1) /= size(shape, 1) .or. size(known%shape, 2) /= size(shape, 2)) cycle
            if (any(abs(known%shape - shape) > 0)) cycle
         end associate
         place = k
         return
      end do
   end function place_of

end module adfric_periodic_pull_off_list

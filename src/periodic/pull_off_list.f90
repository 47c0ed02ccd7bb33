!> Pull-offs of the surfaces of a run: the first point of a surface has its pull-off found, all others look it up.
!>
!> All threads use one list. What stands in it depends on the surface and its adhesion alone, so it does not matter who found it. A
!> thread that needs one which another thread seeks waits for it; those of different surfaces are sought at the same time.
module adfric_periodic_pull_off_list
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp
   use adfric_numerics_thread_lock, only: thread_lock_t
   use adfric_periodic_adhesive_pull_off, only: pull_off_t, find_pull_off
   use adfric_periodic_adhesive_solver, only: periodic_adhesion_t
   use adfric_periodic_solver, only: periodic_solver_t
   implicit none (type, external)
   private
   public :: pull_off_list_t, get_pull_off, forget_pull_offs

   !> Surfaces that are kept; then the oldest ones are forgotten.
   integer, parameter :: most_surfaces = 32
   !> Cells that these have together at most, but for one surface, which may have more.
   integer, parameter :: most_cells = 2**22
   !> Numbers that a pull-off depends on beside the shape.
   integer, parameter :: n_numbers = 7

   !> A surface whose pull-off is known or sought.
   type :: known_pull_off_t
      !> Adhesion, tolerance, periods and symmetry.
      real(dp) :: numbers(n_numbers) = 0
      !> Gap of the undeformed surfaces [periods along x]; not allocated: there is no surface.
      real(dp), allocatable :: shape(:, :)
      !> Is a thread seeking the pull-off?
      logical :: is_sought = .false.
      !> That thread holds this lock.
      type(thread_lock_t) :: lock
      !> The pull-off; pressures in E*, lengths in periods along x.
      type(pull_off_t) :: pull_off
   end type known_pull_off_t

   !> The surfaces.
   type :: pull_off_list_t
      private
      !> In the order in which they were asked for, the oldest one overwritten.
      type(known_pull_off_t) :: known(most_surfaces)
      !> How often a surface was given a place.
      integer :: n_placed = 0
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
      logical :: is_known, has_place

      numbers = [adhesion%stress, adhesion%range, merge(adhesion%turning_pressure, -1.0_dp, adhesion%has_turned), tolerance, &
         & period, merge(1.0_dp, 0.0_dp, solver%grids(1)%operator%is_quarter)]
      do
         !$omp critical (adfric_periodic_pull_off_list)
         place = place_of(list, numbers, shape)
         is_known = .false.
         if (place > 0) is_known = .not. list%known(place)%is_sought
         if (is_known) pull_off = list%known(place)%pull_off
         has_place = .false.
         if (place == 0) call give_place(list, numbers, shape, place, has_place)
         !$omp end critical (adfric_periodic_pull_off_list)
         if (is_known) return
         if (has_place .or. place == 0) exit
         call list%known(place)%lock%wait_for()
      end do
      call find_pull_off(solver, shape, adhesion, tolerance, pull_off, error)
      !$omp critical (adfric_periodic_pull_off_list)
      if (.not. allocated(error)) list%n_found = list%n_found + 1
      if (has_place) call keep(list%known(place), pull_off, allocated(error))
      !$omp end critical (adfric_periodic_pull_off_list)
   end subroutine get_pull_off

   !> Give a surface that does not stand in the list the place of the oldest one that is not sought.
   subroutine give_place(list, numbers, shape, place, has_place)
      !> The list; the place has the surface, and its lock is held.
      type(pull_off_list_t), intent(inout) :: list
      !> Adhesion, tolerance, periods and symmetry.
      real(dp), intent(in) :: numbers(:)
      !> Gap of the undeformed surfaces [periods along x].
      real(dp), intent(in) :: shape(:, :)
      !> The place; 0 where all surfaces are sought or there is no memory.
      integer, intent(out) :: place
      !> Is there a place?
      logical, intent(out) :: has_place
      integer :: k, n_places, failure

      n_places = max(1, min(most_surfaces, most_cells/size(shape)))
      has_place = .false.
      do k = 0, n_places - 1
         place = 1 + modulo(list%n_placed + k, n_places)
         has_place = .not. list%known(place)%is_sought
         if (has_place) exit
      end do
      if (has_place) then
         associate (known => list%known(place))
            if (allocated(known%shape)) deallocate (known%shape)
            allocate (known%shape, source=shape, stat=failure)
            has_place = failure == 0
            if (has_place) call known%lock%acquire()
            known%is_sought = has_place
            known%numbers = numbers
         end associate
         list%n_placed = list%n_placed + 1
      end if
      if (.not. has_place) place = 0
   end subroutine give_place

   !> Keep a pull-off that has been sought, and let those who wait for it go on.
   subroutine keep(known, pull_off, has_failed)
      !> The surface, whose lock the thread holds.
      type(known_pull_off_t), intent(inout) :: known
      !> Its pull-off.
      type(pull_off_t), intent(in) :: pull_off
      !> Was there too little memory to find it? Then the surface leaves the list, and others seek for themselves.
      logical, intent(in) :: has_failed

      if (has_failed) deallocate (known%shape)
      known%pull_off = pull_off
      known%is_sought = .false.
      call known%lock%release()
   end subroutine keep

   !> Forget all pull-offs, once no thread asks for one.
   subroutine forget_pull_offs(list)
      !> The list, which has none at the end.
      type(pull_off_list_t), intent(inout) :: list
      integer :: k

      do k = 1, most_surfaces
         if (allocated(list%known(k)%shape)) deallocate (list%known(k)%shape)
         call list%known(k)%lock%destroy()
      end do
   end subroutine forget_pull_offs

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
         if (.not. allocated(list%known(k)%shape)) cycle
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

!> The pull-off loads of all surfaces of a run: the first point of a surface has its pull-off load found, all others look it up.
!>
!> All threads use one table. What stands in it depends on the surface alone, so it does not matter who found it; two threads that
!> need one at the same time may both find it, to the same bits.
module adfric_wavy_pull_off_table
   use adfric_base_kinds, only: i8
   use adfric_wavy_pull_off, only: pull_off_t, find_pull_off
   use adfric_wavy_steady_state, only: branch_adhered
   use adfric_wavy_surface, only: surface_t, is_identical_surface
   implicit none (type, external)
   private
   public :: pull_off_table_t, get_pull_off

   !> Places of a table that is used for the first time.
   integer, parameter :: fewest_places = 64

   !> Pull-off loads, each at the first free place from the one that its surface gives.
   type :: pull_off_table_t
      private
      !> Pull-off loads, shape `(n_places)`; a place is free where nothing is known.
      type(pull_off_t), allocatable :: places(:)
      !> Number of places in use, at most half of them.
      integer :: n_known = 0
      !> Number of places that the table grows to; then it begins anew when it is full.
      integer, public :: most_places = 2**17
      !> How often a pull-off load was found, since it did not stand in the table.
      integer(i8), public :: n_found = 0
   end type pull_off_table_t

contains

   !> The pull-off load of a surface, from the table if it stands there.
   subroutine get_pull_off(table, surface, pull_off)
      !> The table, which receives what had to be found.
      type(pull_off_table_t), intent(inout) :: table
      !> The surface in reduced units; its branch does not matter.
      type(surface_t), intent(in) :: surface
      !> In: the pull-off load of a surface, or of none. Out: that of this surface.
      type(pull_off_t), intent(inout) :: pull_off
      type(surface_t) :: adhered

      if (pull_off%is_known) then
         if (is_identical_surface(surface, pull_off%surface)) return
      end if
      adhered = surface
      adhered%branch = branch_adhered
      !$omp critical (adfric_wavy_pull_off_table)
      call recall(table, adhered, pull_off)
      !$omp end critical (adfric_wavy_pull_off_table)
      if (.not. pull_off%is_known) then
         call find_pull_off(adhered, pull_off)
         !$omp critical (adfric_wavy_pull_off_table)
         call keep(table, pull_off)
         table%n_found = table%n_found + 1
         !$omp end critical (adfric_wavy_pull_off_table)
      end if
      pull_off%surface = surface
   end subroutine get_pull_off

   !> Look up a pull-off load.
   pure subroutine recall(table, surface, pull_off)
      !> The table that is looked into.
      type(pull_off_table_t), intent(in) :: table
      !> The surface, on its adhered branch.
      type(surface_t), intent(in) :: surface
      !> Receives the pull-off load; `is_known` tells whether it stands in the table.
      type(pull_off_t), intent(out) :: pull_off

      if (allocated(table%places)) pull_off = table%places(place_of(table%places, surface))
   end subroutine recall

   !> Keep a pull-off load. A table that may not grow any more begins anew when it is full.
   pure subroutine keep(table, pull_off)
      !> The table, which grows where half of its places are in use.
      type(pull_off_table_t), intent(inout) :: table
      !> The pull-off load of a surface on its adhered branch.
      type(pull_off_t), intent(in) :: pull_off
      integer :: place

      if (.not. allocated(table%places)) allocate (table%places(fewest_places))
      if (2*table%n_known >= size(table%places)) then
         if (size(table%places) < table%most_places) then
            call grow(table)
         else
            table%places%is_known = .false.
            table%n_known = 0
         end if
      end if
      place = place_of(table%places, pull_off%surface)
      ! another thread may have kept it already
      if (.not. table%places(place)%is_known) table%n_known = table%n_known + 1
      table%places(place) = pull_off
   end subroutine keep

   !> Give a table twice as many places.
   pure subroutine grow(table)
      !> The table, of which nothing is lost.
      type(pull_off_table_t), intent(inout) :: table
      type(pull_off_t), allocatable :: places(:)
      integer :: k

      allocate (places(2*size(table%places)))
      do k = 1, size(table%places)
         if (table%places(k)%is_known) places(place_of(places, table%places(k)%surface)) = table%places(k)
      end do
      call move_alloc(places, table%places)
   end subroutine grow

   !> The place where a surface stands, or the free one where it would.
   pure integer function place_of(places, surface) result(place)
      !> Places of a table, some of which are free.
      type(pull_off_t), intent(in) :: places(:)
      !> The surface, on its adhered branch.
      type(surface_t), intent(in) :: surface

      place = first_place(surface, size(places))
      do while (places(place)%is_known)
         if (is_identical_surface(surface, places(place)%surface)) exit
         place = 1 + modulo(place, size(places))
      end do
   end function place_of

   !> Where a surface is looked for first: surfaces that differ in any bit are spread over all places.
   pure integer function first_place(surface, n_places) result(place)
      !> The surface, on its adhered branch.
      type(surface_t), intent(in) :: surface
      !> Number of places.
      integer, intent(in) :: n_places
      !> The halves of a number are mixed by a multiplication modulo a prime, which does not overflow.
      integer(i8), parameter :: prime = 2147483647_i8, factor = 630360016_i8, half = 4294967295_i8
      integer(i8) :: numbers(6), mixed
      integer :: k

      numbers = transfer([surface%foundation%u, surface%foundation%beta, surface%adhesion%stress, surface%adhesion%range, &
         & surface%shape%steepness, surface%tolerance], numbers)
      mixed = 1
      do k = 1, size(numbers)
         mixed = modulo(mixed*factor + iand(numbers(k), half), prime)
         mixed = modulo(mixed*factor + ishft(numbers(k), -32), prime)
      end do
      place = 1 + int(modulo(mixed, int(n_places, i8)))
   end function first_place

end module adfric_wavy_pull_off_table

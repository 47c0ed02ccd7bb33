!> What a point of a block has found, for those after it.
!>
!> It is kept with all the numbers that it was computed from, and given to a point whose own are the same to the last bit, and to
!> no other: so results do not depend on which points came before.
module adfric_classical_point_memory
   use adfric_base_kinds, only: dp, i8
   implicit none (type, external)
   private
   public :: point_memory_t

   !> Numbers, and what they were computed from.
   type :: point_memory_t
      private
      !> The numbers that were computed from, and those that were found.
      real(dp), allocatable :: key(:), found(:)
   contains
      procedure :: recall
      procedure :: keep
   end type point_memory_t

contains

   !> Give back what was found for a key.
   pure subroutine recall(self, key, found, is_known)
      !> Memory that is looked into.
      class(point_memory_t), intent(in) :: self
      !> All numbers that `found` depends on.
      real(dp), intent(in) :: key(:)
      !> What was kept for the key; left as it is where the key is not known.
      real(dp), intent(inout) :: found(:)
      !> Is the key that of the memory, to the last bit?
      logical, intent(out) :: is_known

      is_known = .false.
      if (.not. allocated(self%key)) return
      if (size(self%key) /= size(key)) return
      is_known = all(transfer(self%key, [0_i8]) == transfer(key, [0_i8]))
      if (is_known) found = self%found
   end subroutine recall

   !> Keep what was found for a key, in place of what was kept before.
   pure subroutine keep(self, key, found)
      !> Memory, which receives key and numbers.
      class(point_memory_t), intent(inout) :: self
      !> All numbers that `found` depends on.
      real(dp), intent(in) :: key(:)
      !> Numbers that are kept.
      real(dp), intent(in) :: found(:)

      self%key = key
      self%found = found
   end subroutine keep

end module adfric_classical_point_memory

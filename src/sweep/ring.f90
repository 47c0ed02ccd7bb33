!> Which block a thread solves next, and which slab goes to the sink next.
!>
!> A few slabs are used in turn. Blocks are given out in the order of their points; a slab whose blocks are all
!> solved is put into the sink, also in order, and is then used again further on. Nothing here knows of
!> threads: the caller lets only one of them at a time into these procedures.
module adfric_sweep_ring
   use adfric_base_kinds, only: i8
   use adfric_sweep_slab, only: slab_t, new_slab
   implicit none (type, external)
   private
   public :: ring_t, new_ring, n_slabs

   !> Number of slabs.
   integer, parameter :: n_slabs = 4

   !> The slabs of a run.
   type :: ring_t
      type(slab_t) :: slabs(n_slabs)
      !> Points of the run, and how many of them have been given to slabs and are solved.
      integer(i8) :: n_points = 0, n_placed = 0, n_solved = 0
      !> The slab whose blocks are given out, and the one that goes to the sink next.
      integer :: filling = 1, emptying = 1
      !> Is a thread putting a slab into the sink?
      logical :: is_putting = .false.
   contains
      procedure :: take_block
      procedure :: finish_block
      procedure :: take_slab
      procedure :: release_slab
   end type ring_t

contains

   !> Make room for the results of a run.
   subroutine new_ring(self, n_points, n_results, block_size, blocks_per_slab, is_ready)
      type(ring_t), intent(out) :: self
      integer(i8), intent(in) :: n_points
      integer, intent(in) :: n_results
      integer, intent(in) :: block_size, blocks_per_slab
      !> False if there is no memory.
      logical, intent(out) :: is_ready
      integer :: k

      self%n_points = n_points
      do k = 1, n_slabs
         call new_slab(self%slabs(k), n_results, block_size, blocks_per_slab, is_ready)
         if (.not. is_ready) return
      end do
   end subroutine new_ring

   !> Take the next block.
   pure subroutine take_block(self, slab, block, is_last)
      class(ring_t), intent(inout) :: self
      !> Slab of the block; 0 if there is none now, because all slabs wait for their results.
      integer, intent(out) :: slab
      !> Its number in the slab, from 1.
      integer, intent(out) :: block
      !> True, and no block taken, if all blocks of the run have been taken.
      logical, intent(out) :: is_last
      integer :: next

      slab = 0
      block = 0
      is_last = .false.
      associate (current => self%slabs(self%filling))
         if (current%n_taken == current%n_blocks) then
            is_last = self%n_placed == self%n_points
            next = merge(self%filling, 1 + mod(self%filling, n_slabs), self%n_placed == 0)
            if (is_last .or. self%slabs(next)%n_blocks > 0) return
            self%filling = next
            call self%slabs(next)%move_to(self%n_placed + 1, self%n_points - self%n_placed)
            self%n_placed = self%n_placed + self%slabs(next)%n_points
         end if
      end associate
      slab = self%filling
      self%slabs(slab)%n_taken = self%slabs(slab)%n_taken + 1
      block = self%slabs(slab)%n_taken
   end subroutine take_block

   !> Take note that a block is solved.
   pure subroutine finish_block(self, slab, block)
      class(ring_t), intent(inout) :: self
      integer, intent(in) :: slab
      integer, intent(in) :: block
      integer :: offset, n

      call self%slabs(slab)%get_block(block, offset, n)
      self%n_solved = self%n_solved + n
      self%slabs(slab)%n_solved = self%slabs(slab)%n_solved + 1
   end subroutine finish_block

   !> Take the next slab that can be put into the sink; whoever gets one calls `release_slab` afterwards.
   pure subroutine take_slab(self, slab)
      class(ring_t), intent(inout) :: self
      !> 0 if there is none, or if another one is being put.
      integer, intent(out) :: slab

      slab = 0
      associate (next => self%slabs(self%emptying))
         if (self%is_putting .or. next%n_blocks == 0 .or. next%n_solved < next%n_blocks) return
      end associate
      slab = self%emptying
      self%is_putting = .true.
   end subroutine take_slab

   !> Give back the slab that has been put into the sink.
   pure subroutine release_slab(self)
      class(ring_t), intent(inout) :: self

      call self%slabs(self%emptying)%move_to(1_i8, 0_i8)
      self%emptying = 1 + mod(self%emptying, n_slabs)
      self%is_putting = .false.
   end subroutine release_slab

end module adfric_sweep_ring

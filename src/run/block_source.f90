! SPDX-License-Identifier: GPL-3.0-or-later
!> Who says which blocks are solved next.
module adfric_run_block_source
   use, intrinsic :: iso_fortran_env, only: int8
   use adfric_base_kinds, only: i8
   use adfric_run_blocks, only: blocks_t
   implicit none (type, external)
   private
   public :: block_source_t, block_list_t, new_block_list

   !> A source of blocks. Nothing here knows of threads: the caller lets only one of them at a time into `take_blocks`.
   type, abstract :: block_source_t
      !> The blocks that there are.
      type(blocks_t) :: blocks
      !> Blocks that have not been taken yet.
      integer(i8) :: n_remaining = 0
      !> Points that were solved before this run.
      integer(i8) :: n_points_before = 0
      !> Points that other processes have taken in this run, as far as is known.
      integer(i8) :: n_points_elsewhere = 0
   contains
      procedure(take_blocks_i), deferred :: take_blocks
      procedure :: end_early => end_alone
   end type block_source_t

   abstract interface
      !> Take the next blocks, which stand side by side in the run.
      subroutine take_blocks_i(self, most, first, n)
         import :: block_source_t, i8
         implicit none (type, external)
         !> The source, which has these blocks no more.
         class(block_source_t), intent(inout) :: self
         !> Largest number of blocks to take, at least 1.
         integer, intent(in) :: most
         !> Number in the run of the first block that is taken.
         integer(i8), intent(out) :: first
         !> Number of blocks that are taken; 0 if none remains.
         integer, intent(out) :: n
      end subroutine take_blocks_i
   end interface

   !> The blocks of a part of a run in their order, but for those that have been solved before.
   type, extends(block_source_t) :: block_list_t
      private
      !> Index of the next block.
      integer(i8) :: next = 1
      !> Is the block at a index solved (1) or not (0)? Not allocated if none is; a byte for up to 256 points.
      integer(int8), allocatable :: is_done(:)
   contains
      procedure :: take_blocks => take_from_list
      procedure :: mark_done
      procedure :: is_solved
      procedure :: leave_out
   end type block_list_t

contains

   !> Nothing more will be asked for, though blocks remain: other processes shall end, too. Here there are none.
   subroutine end_alone(self)
      class(block_source_t), intent(inout) :: self

      self%n_remaining = 0
   end subroutine end_alone

   !> All blocks of a part of a run.
   subroutine new_block_list(self, blocks)
      !> Receives all blocks, none of which is solved.
      type(block_list_t), intent(out) :: self
      !> The blocks of a part of a run.
      type(blocks_t), intent(in) :: blocks

      self%blocks = blocks
      self%n_remaining = blocks%n_blocks()
   end subroutine new_block_list

   !> Leave a block out, since it is solved.
   subroutine mark_done(self, index)
      !> The list, in which the block is marked as solved; its points count as solved before.
      class(block_list_t), intent(inout) :: self
      !> Index of the block in the part, from 1.
      integer(i8), intent(in) :: index

      if (.not. allocated(self%is_done)) allocate (self%is_done(self%blocks%n_blocks()), source=0_int8)
      if (self%is_done(index) == 1) return
      self%is_done(index) = 1
      self%n_remaining = self%n_remaining - 1
      self%n_points_before = self%n_points_before + self%blocks%n_points_of(self%blocks%block_at(index))
   end subroutine mark_done

   !> See `block_source_t`.
   subroutine take_from_list(self, most, first, n)
      class(block_list_t), intent(inout) :: self
      !> Largest number of blocks to take, at least 1.
      integer, intent(in) :: most
      !> Number in the run of the first block that is taken.
      integer(i8), intent(out) :: first
      !> Number of blocks that are taken; 0 if none remains.
      integer, intent(out) :: n
      integer :: most_here

      first = 0
      n = 0
      if (self%n_remaining == 0) return
      do while (self%is_solved(self%next))
         self%next = self%next + 1
      end do
      first = self%blocks%block_at(self%next)
      most_here = int(min(int(most, i8), self%blocks%n_neighbours(self%next)))
      do while (n < most_here)
         if (self%is_solved(self%next)) exit
         n = n + 1
         self%next = self%next + 1
      end do
      self%n_remaining = self%n_remaining - n
   end subroutine take_from_list

   !> Leave out the next blocks that remain.
   subroutine leave_out(self, n)
      !> The list, which goes on behind the blocks that are left out.
      class(block_list_t), intent(inout) :: self
      !> Number of blocks to leave out, at most `n_remaining`.
      integer(i8), intent(in) :: n
      integer(i8) :: n_passed

      n_passed = 0
      do while (n_passed < n)
         if (.not. self%is_solved(self%next)) n_passed = n_passed + 1
         self%next = self%next + 1
      end do
      self%n_remaining = self%n_remaining - n
   end subroutine leave_out

   !> Was the block at a index solved before?
   pure logical function is_solved(self, index)
      !> The list, which knows what has been marked as solved.
      class(block_list_t), intent(in) :: self
      !> Index of the block in the part, from 1.
      integer(i8), intent(in) :: index

      is_solved = .false.
      if (allocated(self%is_done)) is_solved = self%is_done(index) == 1
   end function is_solved

end module adfric_run_block_source

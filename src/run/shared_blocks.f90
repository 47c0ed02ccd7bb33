! SPDX-License-Identifier: GPL-3.0-or-later
!> Blocks that several processes solve together: each takes the next ones when it has time.
!>
!> All processes have the same list of blocks that remain and draw tickets for them from one counter; a ticket says how
!> many blocks of the list others have taken before. So nobody deals them out, and none stands idle while there are any.
module adfric_run_shared_blocks
   use adfric_base_kinds, only: i8
   use adfric_run_world, only: world_t
   use adfric_run_block_source, only: block_source_t, block_list_t
   implicit none (type, external)
   private
   public :: shared_blocks_t, new_shared_blocks

   !> More tickets than there are blocks in any run.
   integer(i8), parameter :: all_tickets = 2_i8**40

   !> The share of one process.
   type, extends(block_source_t) :: shared_blocks_t
      private
      !> The processes, and the counter of their tickets.
      type(world_t), pointer :: world => null()
      !> Blocks that no process has taken, as far as this one knows.
      type(block_list_t) :: list
      !> Number of blocks that all processes solve, and of those at the front of the list that are gone.
      integer(i8) :: n_all = 0, n_gone = 0
      !> Blocks of the last ticket that have not been asked for yet, and all that were taken here.
      integer(i8) :: n_at_hand = 0, n_taken = 0
   contains
      procedure :: take_blocks => take_shared_blocks
      procedure :: end_early
   end type shared_blocks_t

contains

   !> The blocks of a list, which is the same in all processes.
   subroutine new_shared_blocks(self, list, world)
      !> Receives the list and the share of this process.
      type(shared_blocks_t), intent(out) :: self
      !> Blocks of the run, with those marked that are solved; the same in all processes.
      type(block_list_t), intent(in) :: list
      !> The processes; it must live as long as `self`, and no ticket may have been taken from it.
      type(world_t), intent(inout), target :: world

      self%world => world
      self%list = list
      self%blocks = list%blocks
      self%n_points_before = list%n_points_before
      self%n_all = list%n_remaining
      self%n_remaining = share_of(self, self%n_all)
   end subroutine new_shared_blocks

   !> What remains to one process, rounded up.
   pure integer(i8) function share_of(self, n)
      type(shared_blocks_t), intent(in) :: self
      !> Number of blocks that remain for all processes together.
      integer(i8), intent(in) :: n

      share_of = (n + self%world%n_ranks - 1)/self%world%n_ranks
   end function share_of

   !> See `block_source_t`.
   subroutine take_shared_blocks(self, most, first, n)
      class(shared_blocks_t), intent(inout) :: self
      !> Largest number of blocks to take, at least 1.
      integer, intent(in) :: most
      !> Number in the run of the first block that is taken.
      integer(i8), intent(out) :: first
      !> Number of blocks that are taken; 0 if none remains.
      integer, intent(out) :: n

      first = 0
      n = 0
      if (self%n_at_hand == 0) call draw_ticket(self, most)
      if (self%n_at_hand == 0) return
      ! blocks that were solved before may stand between those of a ticket
      call self%list%take_blocks(int(min(int(most, i8), self%n_at_hand)), first, n)
      self%n_gone = self%n_gone + n
      self%n_at_hand = self%n_at_hand - n
      self%n_taken = self%n_taken + n
      self%n_remaining = share_of(self, self%n_all - self%n_gone)
      self%n_points_elsewhere = max(0_i8, self%n_gone - self%n_taken)*self%blocks%size
   end subroutine take_shared_blocks

   !> Draw a ticket for some blocks; nothing is kept afterwards if none remain.
   subroutine draw_ticket(self, most)
      !> The source, which holds the blocks of the ticket afterwards.
      class(shared_blocks_t), intent(inout) :: self
      !> Number of blocks that the ticket is for; fewer are kept if fewer remain.
      integer, intent(in) :: most
      integer(i8) :: n_before

      call self%world%take_tickets(int(most, i8), n_before)
      if (n_before >= self%n_all) then
         self%n_remaining = 0
         return
      end if
      call self%list%leave_out(n_before - self%n_gone)
      self%n_gone = n_before
      self%n_at_hand = min(int(most, i8), self%n_all - n_before)
   end subroutine draw_ticket

   !> See `block_source_t`: nobody gets a block any more.
   subroutine end_early(self)
      class(shared_blocks_t), intent(inout) :: self
      integer(i8) :: n_before

      call self%world%take_tickets(all_tickets, n_before)
      self%n_at_hand = 0
      self%n_remaining = 0
   end subroutine end_early

end module adfric_run_shared_blocks

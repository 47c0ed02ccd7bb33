! SPDX-License-Identifier: GPL-3.0-or-later
!> What the processes of a run must agree on: how it ends, which blocks are solved, what all of them found.
module adfric_run_agreement
   use, intrinsic :: iso_fortran_env, only: int8
   use adfric_base_kinds, only: dp, i8
   use adfric_base_error, only: error_t, set_error
   use adfric_run_world, only: world_t
   use adfric_run_block_source, only: block_list_t
   use adfric_run_summary, only: run_summary_t
   implicit none (type, external)
   private
   public :: share_failure, share_error, share_status, share_answer, share_done_blocks, add_up_summary

contains

   !> Give everyone the failure of the first process that has one. Nobody goes on before all have come here.
   subroutine share_failure(world, status, text)
      !> The processes of the run, all of which must call this procedure.
      type(world_t), intent(in) :: world
      !> In: exit status of this process, 0 without failure. Out: that of the first process with a failure.
      integer, intent(inout) :: status
      !> In: the message of the failure, if there is one. Out: that of the first process with a failure.
      character(:), allocatable, intent(inout) :: text
      integer(int8), allocatable :: bytes(:)
      integer(i8) :: numbers(2)
      real(dp) :: least(1)
      integer :: from, i

      least = -real(merge(world%rank, world%n_ranks, status /= 0), dp)
      call world%find_greatest(least)
      from = -nint(least(1))
      if (from == world%n_ranks) return
      numbers = 0
      if (world%rank == from) numbers = [int(status, i8), len(text, kind=i8)]
      call world%add_up(numbers)
      status = int(numbers(1))
      allocate (bytes(numbers(2)), source=0_int8)
      if (world%rank == from) bytes = [(int(iachar(text(i:i)) - 128, int8), i=1, len(text))]
      call world%share_bytes(bytes, from)
      if (allocated(text)) deallocate (text)
      allocate (character(size(bytes)) :: text)
      do i = 1, size(bytes)
         text(i:i) = achar(int(bytes(i)) + 128)
      end do
   end subroutine share_failure

   !> Give everyone the error of the first process that has one. Nobody goes on before all have come here.
   subroutine share_error(world, error)
      !> The processes of the run, all of which must call this procedure.
      type(world_t), intent(in) :: world
      !> In: the error of this process. Out: that of the first process with an error; not allocated if none has one.
      type(error_t), allocatable, intent(inout) :: error
      character(:), allocatable :: text
      integer :: status

      status = 0
      text = ''
      if (allocated(error)) then
         status = error%code
         text = error%message
      end if
      call share_failure(world, status, text)
      if (status /= 0) call set_error(error, status, text)
   end subroutine share_error

   !> Give everyone the number of the first process.
   subroutine share_status(world, status)
      !> The processes of the run, all of which must call this procedure.
      type(world_t), intent(in) :: world
      !> In: a number, which counts in the first process alone. Out: that of the first process.
      integer, intent(inout) :: status
      integer(i8) :: numbers(1)

      numbers = merge(status, 0, world%is_first())
      call world%add_up(numbers)
      status = int(numbers(1))
   end subroutine share_status

   !> Give everyone the answer of the first process.
   subroutine share_answer(world, answer)
      !> The processes of the run, all of which must call this procedure.
      type(world_t), intent(in) :: world
      !> In: an answer, which counts in the first process alone. Out: that of the first process.
      logical, intent(inout) :: answer
      integer :: number

      number = merge(1, 0, answer)
      call share_status(world, number)
      answer = number == 1
   end subroutine share_answer

   !> Give everyone the blocks that the first process knows to be solved.
   subroutine share_done_blocks(world, list)
      !> The processes of the run, all of which must call this procedure.
      type(world_t), intent(in) :: world
      !> In: all blocks of the part, marked as solved in the first process. Out: marked everywhere.
      type(block_list_t), intent(inout) :: list
      integer(int8), allocatable :: is_done(:)
      integer(i8) :: index

      if (world%n_ranks == 1) return
      allocate (is_done(list%blocks%n_blocks()), source=0_int8)
      do index = 1, size(is_done, kind=i8)
         if (list%is_solved(index)) is_done(index) = 1
      end do
      call world%share_bytes(is_done, 0)
      do index = 1, size(is_done, kind=i8)
         if (is_done(index) == 1) call list%mark_done(index)
      end do
   end subroutine share_done_blocks

   !> Make what each process found what all of them found; times are those of the slowest.
   subroutine add_up_summary(world, summary)
      !> The processes of the run, all of which must call this procedure.
      type(world_t), intent(in) :: world
      !> In: what this process found. Out: what all of them found.
      type(run_summary_t), intent(inout) :: summary
      integer(i8), allocatable :: counts(:)
      real(dp), allocatable :: extremes(:)
      integer :: n, m

      n = size(summary%by_status)
      allocate (counts(1 + n + size(summary%by_state)))
      counts(:) = [summary%n_points, summary%by_status, reshape(summary%by_state, [size(summary%by_state)])]
      call world%add_up(counts)
      summary%n_points = counts(1)
      summary%by_status = counts(2:n + 1)
      summary%by_state = reshape(counts(n + 2:), shape(summary%by_state))

      m = size(summary%highest)
      allocate (extremes(2*m + 2))
      extremes(:) = [-summary%lowest, summary%highest, summary%wall_seconds, real(summary%signal, dp)]
      call world%find_greatest(extremes)
      summary%lowest = -extremes(:m)
      summary%highest = extremes(m + 1:2*m)
      summary%wall_seconds = extremes(2*m + 1)
      summary%signal = nint(extremes(2*m + 2))
   end subroutine add_up_summary

end module adfric_run_agreement

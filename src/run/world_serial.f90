! SPDX-License-Identifier: GPL-3.0-or-later
!> The processes that solve a run together: here only one. `world_mpi.f90` holds the same module for programs that are built
!> with MPI; the build takes one of them.
module adfric_run_world
   use, intrinsic :: iso_fortran_env, only: int8
   use hdf5, only: hid_t
   use adfric_base_kinds, only: dp, i8
   use adfric_hdf5_calls, only: hdf5_calls_t
   use adfric_hdf5_file, only: create_access
   implicit none (type, external)
   private
   public :: world_t, world_kind

   !> What the program says of how it was built.
   character(*), parameter :: world_kind = ''

   !> One process.
   type :: world_t
      !> Number of this process, from 0; number of all, and of those on this machine.
      integer :: rank = 0, n_ranks = 1, n_here = 1
      !> Tickets that have been given out.
      integer(i8), private :: n_tickets = 0
   contains
      procedure :: start
      procedure :: stop => stop_world
      procedure :: is_first
      procedure :: share_bytes
      procedure :: add_up
      procedure :: find_greatest
      procedure :: take_tickets
      procedure :: create_shared_access
   end type world_t

contains

   !> Find the other processes.
   subroutine start(self)
      !> The only process, which has given out no ticket yet.
      class(world_t), intent(inout) :: self

      self%n_tickets = 0
   end subroutine start

   !> Leave the other processes.
   subroutine stop_world(self)
      class(world_t), intent(inout) :: self

      self%n_tickets = 0
   end subroutine stop_world

   !> Is it the process that speaks for all?
   pure logical function is_first(self)
      class(world_t), intent(in) :: self

      is_first = self%rank == 0
   end function is_first

   !> Give everyone the bytes of one process.
   subroutine share_bytes(self, bytes, from)
      class(world_t), intent(in) :: self
      !> In: bytes, as many in every process. Out: those of the process `from`.
      integer(int8), intent(inout), contiguous :: bytes(:)
      !> Number of the process whose bytes are given to all, from 0.
      integer, intent(in) :: from

      associate (unused => self%rank, unused_too => bytes, unused_as_well => from)
      end associate
   end subroutine share_bytes

   !> Put the sums over all processes in the index of numbers, everywhere.
   subroutine add_up(self, numbers)
      class(world_t), intent(in) :: self
      !> In: numbers of this process, as many in each. Out: their sums over all processes.
      integer(i8), intent(inout), contiguous :: numbers(:)

      associate (unused => self%rank, unused_too => numbers)
      end associate
   end subroutine add_up

   !> Put the greatest of all processes in the index of numbers, everywhere.
   subroutine find_greatest(self, numbers)
      class(world_t), intent(in) :: self
      !> In: numbers of this process, as many in each. Out: the greatest of all processes.
      real(dp), intent(inout), contiguous :: numbers(:)

      associate (unused => self%rank, unused_too => numbers)
      end associate
   end subroutine find_greatest

   !> Take tickets, each of which is given out once among all processes, in order. Nobody has to wait for another process.
   subroutine take_tickets(self, n, n_before)
      !> Holds the counter of tickets, or knows the process that does.
      class(world_t), intent(inout) :: self
      !> Number of tickets to take.
      integer(i8), intent(in) :: n
      !> Number of tickets that had been given out before these, to all processes.
      integer(i8), intent(out) :: n_before

      n_before = self%n_tickets
      self%n_tickets = self%n_tickets + n
   end subroutine take_tickets

   !> Create a list of properties by which all processes open a file together.
   subroutine create_shared_access(self, calls, list)
      class(world_t), intent(in) :: self
      !> Takes note of calls of HDF5 that fail.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the list of properties, to be closed by the caller.
      integer(hid_t), intent(out) :: list

      call create_access(calls, list)
      associate (unused => self%rank)
      end associate
   end subroutine create_shared_access

end module adfric_run_world

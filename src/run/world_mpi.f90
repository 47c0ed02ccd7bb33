! SPDX-License-Identifier: GPL-3.0-or-later
!> The processes that solve a run together, by MPI. `world_serial.f90` holds the same module for programs without MPI.
module adfric_run_world
   use, intrinsic :: iso_c_binding, only: c_f_pointer, c_ptr
   use, intrinsic :: iso_fortran_env, only: int8
   use hdf5, only: hid_t, h5pset_fapl_mpio_f
   use mpi_f08, only: MPI_Comm, MPI_Win, MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, MPI_INFO_NULL, &
      MPI_THREAD_MULTIPLE, MPI_BYTE, MPI_INTEGER8, MPI_REAL8, MPI_SUM, MPI_MAX, MPI_IN_PLACE, MPI_ADDRESS_KIND, &
      MPI_Init_thread, MPI_Finalize, MPI_Comm_rank, MPI_Comm_size, MPI_Comm_split_type, MPI_Comm_free, MPI_Bcast, &
      MPI_Allreduce, MPI_Barrier, MPI_Win_allocate, MPI_Win_free, MPI_Win_lock_all, MPI_Win_unlock_all, MPI_Win_sync, &
      MPI_Win_flush, MPI_Fetch_and_op
   use omp_lib, only: omp_set_num_threads
   use adfric_base_kinds, only: dp, i8
   use adfric_base_words, only: count_words, get_word
   use adfric_hdf5_calls, only: hdf5_calls_t
   use adfric_hdf5_file, only: create_access
   implicit none (type, external)
   private
   public :: world_t, world_kind

   !> What the program says of how it was built.
   character(*), parameter :: world_kind = ', MPI'

   !> What those who start processes together tell them: Open MPI, PMIx (also Slurm), PMI (MPICH, Intel, also Slurm).
   character(*), parameter :: signs_of_launchers = 'OMPI_COMM_WORLD_SIZE PMIX_RANK PMI_RANK'
   !> Largest number of bytes that are sent at once.
   integer, parameter :: most_bytes = 2**30

   !> All processes.
   type :: world_t
      !> Number of this process, from 0; number of all, and of those on this machine.
      integer :: rank = 0, n_ranks = 1, n_here = 1
      !> Tickets that have been given out, while there is one process.
      integer(i8), private :: n_tickets = 0
      !> Window to the counter of tickets, which stands in the first of several processes.
      type(MPI_Win), private :: window
      !> Is MPI at work?
      logical, private :: has_mpi = .false.
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

   !> Find the other processes. One that was started alone needs no MPI, and saves its time and its files. One of several has
   !> one thread unless the user wants more: cores are given to processes.
   subroutine start(self)
      !> Receives the numbers of processes and of this one among them.
      class(world_t), intent(inout) :: self
      type(MPI_Comm) :: here
      type(hdf5_calls_t) :: calls
      integer :: thread_support, length

      if (.not. is_launched()) return
      ! When it becomes ready after MPI, HDF5 is ended by MPI_Finalize and crashes over files whose writing has failed. A
      ! failure shows when a file is opened.
      call calls%open_library()
      call MPI_Init_thread(MPI_THREAD_MULTIPLE, thread_support)
      self%has_mpi = .true.
      call MPI_Comm_rank(MPI_COMM_WORLD, self%rank)
      call MPI_Comm_size(MPI_COMM_WORLD, self%n_ranks)
      if (self%n_ranks == 1) return
      call MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, self%rank, MPI_INFO_NULL, here)
      call MPI_Comm_size(here, self%n_here)
      call MPI_Comm_free(here)
      call get_environment_variable('OMP_NUM_THREADS', length=length)
      ! threads take tickets and write files at the same time
      if (length == 0 .or. thread_support < MPI_THREAD_MULTIPLE) call omp_set_num_threads(1)
      call open_counter(self)
   end subroutine start

   !> Was this process started together with others? If a launcher is not known here, its processes are taken for runs of their
   !> own, which the lock of the results file keeps apart.
   logical function is_launched()
      integer :: i, length

      is_launched = .false.
      do i = 1, count_words(signs_of_launchers)
         call get_environment_variable(get_word(signs_of_launchers, i), length=length)
         is_launched = is_launched .or. length > 0
      end do
   end function is_launched

   !> Make the counter of tickets ready, for access by all processes at any time.
   subroutine open_counter(self)
      !> The processes; receives the window to the counter, which stands in the first of them.
      class(world_t), intent(inout) :: self
      integer, parameter :: bytes_of_counter = 8
      integer(i8), pointer :: counter
      integer(MPI_ADDRESS_KIND) :: n_bytes
      type(c_ptr) :: address

      n_bytes = merge(bytes_of_counter, 0, self%rank == 0)
      call MPI_Win_allocate(n_bytes, bytes_of_counter, MPI_INFO_NULL, MPI_COMM_WORLD, address, self%window)
      call MPI_Win_lock_all(0, self%window)
      if (self%rank == 0) then
         call c_f_pointer(address, counter)
         counter = 0
         call MPI_Win_sync(self%window)
      end if
      call MPI_Barrier(MPI_COMM_WORLD)
   end subroutine open_counter

   !> Leave the other processes.
   subroutine stop_world(self)
      class(world_t), intent(inout) :: self

      if (self%n_ranks > 1) then
         call MPI_Win_unlock_all(self%window)
         call MPI_Win_free(self%window)
      end if
      if (self%has_mpi) call MPI_Finalize()
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
      integer(i8) :: first
      integer :: n

      if (self%n_ranks == 1) return
      do first = 1, size(bytes, kind=i8), most_bytes
         n = int(min(int(most_bytes, i8), size(bytes, kind=i8) - first + 1))
         call MPI_Bcast(bytes(first:first + n - 1), n, MPI_BYTE, from, MPI_COMM_WORLD)
      end do
   end subroutine share_bytes

   !> Put the sums over all processes in the index of numbers, everywhere.
   subroutine add_up(self, numbers)
      class(world_t), intent(in) :: self
      !> In: numbers of this process, as many in each. Out: their sums over all processes.
      integer(i8), intent(inout), contiguous :: numbers(:)

      if (self%n_ranks == 1) return
      call MPI_Allreduce(MPI_IN_PLACE, numbers, size(numbers), MPI_INTEGER8, MPI_SUM, MPI_COMM_WORLD)
   end subroutine add_up

   !> Put the greatest of all processes in the index of numbers, everywhere.
   subroutine find_greatest(self, numbers)
      class(world_t), intent(in) :: self
      !> In: numbers of this process, as many in each. Out: the greatest of all processes.
      real(dp), intent(inout), contiguous :: numbers(:)

      if (self%n_ranks == 1) return
      call MPI_Allreduce(MPI_IN_PLACE, numbers, size(numbers), MPI_REAL8, MPI_MAX, MPI_COMM_WORLD)
   end subroutine find_greatest

   !> Take tickets, each of which is given out once among all processes, in order. Nobody has to wait for another process:
   !> the counter is changed where it stands, without the help of its owner.
   subroutine take_tickets(self, n, n_before)
      !> Holds the counter of tickets, or knows the process that does.
      class(world_t), intent(inout) :: self
      !> Number of tickets to take.
      integer(i8), intent(in) :: n
      !> Number of tickets that had been given out before these, to all processes.
      integer(i8), intent(out) :: n_before
      integer(i8), asynchronous :: wanted, before

      if (self%n_ranks == 1) then
         n_before = self%n_tickets
         self%n_tickets = self%n_tickets + n
         return
      end if
      wanted = n
      call MPI_Fetch_and_op(wanted, before, MPI_INTEGER8, 0, 0_MPI_ADDRESS_KIND, MPI_SUM, self%window)
      call MPI_Win_flush(0, self%window)
      n_before = before
   end subroutine take_tickets

   !> Create a list of properties by which all processes open a file together.
   subroutine create_shared_access(self, calls, list)
      class(world_t), intent(in) :: self
      !> Takes note of calls of HDF5 that fail.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the list of properties, to be closed by the caller.
      integer(hid_t), intent(out) :: list

      call create_access(calls, list)
      if (self%n_ranks == 1 .or. .not. calls%is_good()) return
      call h5pset_fapl_mpio_f(list, MPI_COMM_WORLD%MPI_VAL, MPI_INFO_NULL%MPI_VAL, calls%status)
      call calls%check()
   end subroutine create_shared_access

end module adfric_run_world

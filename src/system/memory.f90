! SPDX-License-Identifier: GPL-3.0-or-later
!> Memory that this process may still have.
module adfric_system_memory
   use, intrinsic :: iso_c_binding, only: c_double, c_int
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: has_space, has_free, free_memory

   !> Space for a line of the system's account.
   integer, parameter :: line_length = 256
   !> So little is there without a look at the account, which takes longer than many points do [bytes].
   real(dp), parameter :: always_there = 16.0e6_dp

   interface

      !> Can so much memory be had? 1 or 0.
      integer(c_int) function c_has_space(n_bytes) bind(c, name='adfric_has_room')
         import :: c_double, c_int
         implicit none (type, external)
         !> Size of the memory that is asked for [bytes].
         real(c_double), intent(in), value :: n_bytes
      end function c_has_space

      !> Bytes that the limit of this process leaves; negative if there is none, or it cannot be said.
      real(c_double) function c_space_below_limit() bind(c, name='adfric_room_below_limit')
         import :: c_double
         implicit none (type, external)
      end function c_space_below_limit

   end interface

contains

   !> Can so much be had? To be asked before an `allocate` that may be too large: one that fails ends the program.
   logical function has_space(n_bytes)
      !> Size of the memory that is asked for [bytes].
      real(dp), intent(in) :: n_bytes

      has_space = c_has_space(n_bytes) /= 0
   end function has_space

   !> Is so much free for this process?
   logical function has_free(n_bytes)
      !> Size of the memory that is needed [bytes].
      real(dp), intent(in) :: n_bytes

      has_free = n_bytes <= always_there
      if (.not. has_free) has_free = n_bytes <= free_memory()
   end function has_free

   !> Bytes of memory that are free for this process; huge if it cannot be said.
   real(dp) function free_memory()
      real(dp) :: space

      free_memory = available_memory()
      space = c_space_below_limit()
      if (space >= 0) free_memory = min(free_memory, space)
   end function free_memory

   !> Bytes of memory that the machine has free; huge if it cannot be said.
   real(dp) function available_memory()
      character(*), parameter :: key = 'MemAvailable:'
      character(line_length) :: line
      integer :: unit, status

      available_memory = huge(1.0_dp)
      open (newunit=unit, file='/proc/meminfo', action='read', status='old', iostat=status)
      if (status /= 0) return
      do
         read (unit, '(a)', iostat=status) line
         if (status /= 0) exit
         if (index(line, key) /= 1) cycle
         read (line(len(key) + 1:), *, iostat=status) available_memory
         if (status == 0) available_memory = 1024*available_memory
         exit
      end do
      close (unit, iostat=status)
   end function available_memory

end module adfric_system_memory

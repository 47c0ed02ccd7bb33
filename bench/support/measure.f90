! SPDX-License-Identifier: GPL-3.0-or-later
!> What every benchmark prints about itself, and what it makes of repeated timings.
module measure
   use, intrinsic :: iso_fortran_env, only: compiler_version
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: spread_t, spread_of, machine, print_heading, integer_argument, text_argument, open_table

   !> Median and range of repeated measurements.
   type :: spread_t
      real(dp) :: median = 0, least = 0, most = 0
   end type spread_t

contains

   !> Median and range of a sample.
   pure type(spread_t) function spread_of(sample) result(spread)
      real(dp), intent(in) :: sample(:)
      real(dp) :: sorted(size(sample)), moved
      integer :: i, j

      sorted = sample
      do i = 2, size(sorted)
         moved = sorted(i)
         do j = i - 1, 1, -1
            if (sorted(j) <= moved) exit
            sorted(j + 1) = sorted(j)
         end do
         sorted(j + 1) = moved
      end do
      if (size(sorted) == 0) return
      i = (size(sorted) + 1)/2
      spread = spread_t((sorted(i) + sorted(size(sorted) + 1 - i))/2, sorted(1), sorted(size(sorted)))
   end function spread_of

   !> Name of the processor.
   function machine() result(name)
      character(:), allocatable :: name
      character(256) :: line
      integer :: unit, status

      name = 'unknown processor'
      open (newunit=unit, file='/proc/cpuinfo', action='read', status='old', iostat=status)
      do while (status == 0)
         read (unit, '(a)', iostat=status) line
         if (index(line, 'model name') /= 1) cycle
         name = trim(adjustl(line(index(line, ':') + 1:)))
         exit
      end do
      close (unit, iostat=status)
   end function machine

   !> Say what is measured, where, and with what it was compiled.
   subroutine print_heading(title)
      character(*), intent(in) :: title

      print '(a)', title
      print '(4a)', 'on ', machine(), ', compiled with ', compiler_version()
   end subroutine print_heading

   !> An argument of the command line that is a whole number.
   integer function integer_argument(position, default) result(value)
      integer, intent(in) :: position, default
      character(32) :: text
      integer :: status

      value = default
      call get_command_argument(position, text)
      if (text == '') return
      read (text, *, iostat=status) value
      if (status /= 0) error stop 'not a whole number: '//text
   end function integer_argument

   !> An argument of the command line.
   function text_argument(position, default) result(text)
      integer, intent(in) :: position
      character(*), intent(in) :: default
      character(:), allocatable :: text
      character(4096) :: buffer

      call get_command_argument(position, buffer)
      text = trim(buffer)
      if (text == '') text = default
   end function text_argument

   !> Open a table for writing, with the machine and the names of the columns on top.
   integer function open_table(path, columns) result(unit)
      character(*), intent(in) :: path, columns

      open (newunit=unit, file=path, action='write', status='replace')
      write (unit, '(4a)') '# ', machine(), ', ', compiler_version()
      write (unit, '(a)') columns
   end function open_table

end module measure

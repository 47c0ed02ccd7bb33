! SPDX-License-Identifier: GPL-3.0-or-later
!> Is there space for a run?
module adfric_output_resources
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t, set_error, input_failure
   use adfric_output_layout, only: layout_t, new_layout
   use adfric_run_run, only: run_t
   use adfric_run_runner, only: memory_needed
   use adfric_system_files, only: folder_of, free_space
   use adfric_system_memory, only: free_memory, has_free
   implicit none (type, external)
   private
   public :: check_resources, check_disk, check_memory, file_size_of, show_bytes

contains

   !> Refuse a run that is too large for the disk or the memory.
   subroutine check_resources(run, n_alike, error)
      !> The run, with its model and its points.
      class(run_t), intent(in) :: run
      !> Number of processes on this machine that need as much memory.
      integer, intent(in) :: n_alike
      !> Not allocated if there is space for the run.
      type(error_t), allocatable, intent(out) :: error

      call check_disk(file_size_of(run), run%output, error)
      if (.not. allocated(error)) call check_memory(run, n_alike, error)
   end subroutine check_resources

   !> Refuse a results file that is too large for the disk.
   subroutine check_disk(n_bytes, path, error)
      !> Size of the file [bytes].
      real(dp), intent(in) :: n_bytes
      !> Name of the file.
      character(*), intent(in) :: path
      !> Not allocated if there is space for the file.
      type(error_t), allocatable, intent(out) :: error
      character(:), allocatable :: folder

      folder = folder_of(path)
      if (n_bytes > free_space(folder)) call set_error(error, input_failure, 'the sweep is too large for the disk, needed: ' &
         //show_bytes(n_bytes)//', free in '//folder//': '//show_bytes(free_space(folder)))
   end subroutine check_disk

   !> Refuse a run that is too large for the memory.
   subroutine check_memory(run, n_alike, error)
      !> The run, with its model and its points.
      class(run_t), intent(in) :: run
      !> Number of processes on this machine that need as much memory.
      integer, intent(in) :: n_alike
      !> Not allocated if there is space for the run.
      type(error_t), allocatable, intent(out) :: error
      real(dp) :: needed

      needed = n_alike*memory_needed(run)
      if (.not. has_free(needed)) call set_error(error, input_failure, 'the run is too large for the memory, needed: ' &
         //show_bytes(needed)//', free: '//show_bytes(free_memory()))
   end subroutine check_memory

   !> Size of the results file of a run, or of its part [bytes].
   real(dp) function file_size_of(run)
      !> The run, with its model and its points.
      class(run_t), intent(in) :: run
      type(layout_t) :: layout

      call new_layout(layout, run)
      file_size_of = layout%n_bytes()
   end function file_size_of

   !> A number of bytes for people.
   pure function show_bytes(n_bytes) result(text)
      !> Number of bytes, >= 0.
      real(dp), intent(in) :: n_bytes
      character(:), allocatable :: text
      character(*), parameter :: units(0:*) = ['bytes', 'kB   ', 'MB   ', 'GB   ', 'TB   ', 'PB   ', 'EB   ']
      character(24) :: buffer
      real(dp) :: rest
      integer :: k

      rest = n_bytes
      do k = 0, size(units) - 2
         if (rest < 999.5_dp) exit
         rest = rest/1000
      end do
      if (rest < 9.95_dp .and. k > 0) then
         write (buffer, '(f4.1)') rest
      else
         write (buffer, '(f20.0)') rest
         buffer = buffer(:index(buffer, '.') - 1)
      end if
      text = trim(adjustl(buffer))//' '//trim(units(k))
   end function show_bytes

end module adfric_output_resources

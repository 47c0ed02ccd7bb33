! SPDX-License-Identifier: GPL-3.0-or-later
!> `adfric merge`: put the parts of a run together.
module adfric_command_merge
   use adfric_base_kinds, only: i8
   use adfric_base_error, only: error_t, set_error, input_failure
   use adfric_base_words, only: pad
   use adfric_base_text, only: newline
   use adfric_command_line, only: command_t
   use adfric_command_outcome, only: outcome_t, exit_not_converged
   use adfric_describe_doubt, only: n_doubts
   use adfric_describe_status, only: status_not_converged, status_not_identifiable, n_status
   use adfric_output_heading, only: heading_t
   use adfric_output_layout, only: layout_t
   use adfric_output_merging, only: write_merged
   use adfric_output_names, only: check_output_name, would_replace
   use adfric_output_part_files, only: part_file_t, check_parts
   use adfric_output_resources, only: check_disk
   use adfric_output_run_table, only: count_line, doubt_lines, status_lines
   use adfric_system_files, only: target_of
   implicit none (type, external)
   private
   public :: merge_parts

contains

   !> Carry out the command.
   subroutine merge_parts(command, outcome)
      !> What the user asks for on the command line.
      type(command_t), intent(in) :: command
      !> Receives what the command has to say, and the exit status.
      type(outcome_t), intent(inout) :: outcome
      type(part_file_t) :: parts(size(command%others))
      type(layout_t) :: layout
      type(heading_t) :: heading
      type(error_t), allocatable :: error
      character(:), allocatable :: path
      integer(i8) :: by_status(0:n_status - 1), by_doubt(0:n_doubts)
      integer :: i

      do i = 1, size(parts)
         parts(i)%path = command%others(i)%text
      end do
      path = target_of(command%subject)
      call check_names(command, path, parts, error)
      if (.not. allocated(error)) call check_parts(parts, layout, heading, by_status, by_doubt, error)
      if (.not. allocated(error) .and. .not. command%is_virtual) call check_disk(layout%n_bytes()*size(parts), &
         path, error)
      if (.not. allocated(error)) &
         call write_merged(parts, layout, heading, path, command%overwrite, command%is_virtual, error)
      if (allocated(error)) then
         call outcome%fail(error)
         return
      end if
      if (any(by_status([status_not_converged, status_not_identifiable]) > 0)) outcome%exit_status = exit_not_converged
      if (command%is_quiet) return
      call outcome%say(count_line('parts', size(parts, kind=i8)))
      call outcome%say(status_lines(by_status, layout%fields(size(layout%fields))%flag_meanings)//doubt_lines(by_doubt))
      call outcome%say(pad('file', 6)//path//newline)
   end subroutine merge_parts

   !> May the file be written, and is it none of the parts?
   subroutine check_names(command, path, parts, error)
      type(command_t), intent(in) :: command
      character(*), intent(in) :: path
      !> The parts of the run, of which only the names are known.
      type(part_file_t), intent(in) :: parts(:)
      type(error_t), allocatable, intent(out) :: error
      integer :: i

      do i = 1, size(parts)
         if (.not. would_replace(path, parts(i)%path)) cycle
         call set_error(error, input_failure, path//': the results would replace the part '//parts(i)%path)
         return
      end do
      call check_output_name(path, command%overwrite, error, &
         & 'or name another one: adfric merge FILE.h5 PART.h5 ... writes FILE.h5')
   end subroutine check_names

end module adfric_command_merge

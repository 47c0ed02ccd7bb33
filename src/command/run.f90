! SPDX-License-Identifier: GPL-3.0-or-later
!> `adfric run` and `adfric fit`: solve every point of an input, or fit every curve, and write the results file.
module adfric_command_run
   use adfric_base_error, only: error_t, set_error, input_failure, file_failure
   use adfric_base_kinds, only: dp
   use adfric_base_printable, only: shell_word
   use adfric_base_text, only: newline, show_count
   use adfric_base_watch, only: watch_t
   use adfric_command_case, only: open_input, fit_only, run_only
   use adfric_command_doubts, only: describe_doubts_of
   use adfric_command_fit_doubts, only: describe_fit_doubts
   use adfric_command_fit_table, only: new_fit_table
   use adfric_command_line, only: command_t
   use adfric_command_outcome, only: outcome_t, exit_success, exit_not_converged, exit_signal
   use adfric_command_solve, only: solve_case, is_begun
   use adfric_fit_stack_model, only: stack_model_t
   use adfric_input_fit, only: fit_input_t
   use adfric_input_run, only: run_input_t
   use adfric_describe_status, only: status_not_converged, status_not_identifiable
   use adfric_output_done_points, only: read_done_points
   use adfric_output_layout, only: layout_t, new_layout
   use adfric_output_names, only: check_output_name, check_partial_name, partial_name, part_name, would_replace
   use adfric_output_resources, only: check_resources, check_memory
   use adfric_output_run_table, only: new_end_lines, new_run_table
   use adfric_run_agreement, only: share_answer, share_error, share_failure
   use adfric_run_world, only: world_t
   use adfric_run_block_source, only: block_list_t
   use adfric_run_blocks, only: blocks_t
   use adfric_run_progress, only: progress_t
   use adfric_run_refinement, only: refine_together
   use adfric_run_run, only: run_t
   use adfric_run_summary, only: run_summary_t
   use adfric_system_clock, only: wall_clock
   use adfric_system_files, only: kind_of_path, path_file, target_of, id_of_file, is_same, remove_file
   use adfric_system_interruption, only: signal_name, signal_watch_t
   implicit none (type, external)
   private
   public :: run_case

contains

   !> Carry out the command.
   subroutine run_case(command, world, progress, outcome)
      !> What the user asks for on the command line.
      type(command_t), intent(in) :: command
      !> The processes that take part; the outcome of the first one holds for all.
      type(world_t), intent(inout) :: world
      !> Is told from time to time how many points are solved.
      class(progress_t), intent(inout) :: progress
      !> Receives what the command has to say, and the exit status.
      type(outcome_t), intent(inout) :: outcome
      type(run_input_t) :: run
      type(fit_input_t), allocatable :: details
      type(run_summary_t) :: summary
      type(error_t), allocatable :: error
      type(signal_watch_t), target :: signals
      class(watch_t), pointer :: watch
      real(dp) :: start
      logical :: is_complete

      call open_input(command%subject, merge(fit_only, run_only, command%name == 'fit'), run, details, outcome)
      call share_failure(world, outcome%exit_status, outcome%errors)
      if (outcome%exit_status /= exit_success) return
      call refine_run(command, world, run, error)
      if (allocated(error)) then
         call outcome%fail(error)
         return
      end if
      if (len(command%output) > 0) run%output = command%output
      run%part = command%part
      run%output = target_of(part_name(run%output, run%part))
      is_complete = .false.
      call check_part(command, run, error)
      if (world%is_first() .and. .not. allocated(error)) call find_complete(command, run, is_complete, summary, error)
      if (.not. (allocated(error) .or. is_complete)) call check_output(command, world, run, error)
      call share_error(world, error)
      call share_answer(world, is_complete)
      if (.not. (allocated(error) .or. is_complete)) then
         ! a signal ends a point that takes long, too; it is solved again later
         watch => signals
         call run%model%obey(watch)
         start = wall_clock()
         call run%model%prepare()
         call solve_case(command, world, run, wall_clock() - start, progress, summary, error)
         call run%model%release()
         nullify (watch)
         call run%model%obey(watch)
      end if
      if (allocated(error)) then
         call outcome%fail(error)
      else if (summary%signal /= 0) then
         call set_error(error, exit_signal + summary%signal, say_stopped(command, run, summary))
         call outcome%fail(error)
      else
         if (any(summary%by_status([status_not_converged, status_not_identifiable]) > 0)) outcome%exit_status = exit_not_converged
         if (command%is_quiet .or. .not. world%is_first()) return
         call outcome%say(new_table(run, summary))
         call outcome%say(describe_doubts_of(run))
         if (is_complete) call outcome%say('this run was complete already'//newline)
      end if
   end subroutine run_case

   !> The table at the end: what a single fit has found, or what a run or a stack has met.
   function new_table(run, summary) result(text)
      class(run_t), intent(in) :: run
      type(run_summary_t), intent(in) :: summary
      character(:), allocatable :: text

      text = new_run_table(summary, run%model%describe_results(run%plan%base), run%model%list_states(), run%output)
      select type (model => run%model)
      type is (stack_model_t)
         if (.not. allocated(model%solution)) return
         text = new_fit_table(model%fit, model%solution)//describe_fit_doubts(model%fit, model%solution)// &
            new_end_lines(summary, run%output)
         if (len(run%title) > 0) text = run%title//newline//text
      end select
   end function new_table

   !> A single fit has no parts.
   subroutine check_part(command, run, error)
      type(command_t), intent(in) :: command
      class(run_t), intent(in) :: run
      !> Allocated if a part of a single fit is wanted.
      type(error_t), allocatable, intent(out) :: error

      if (command%part%is_whole()) return
      select type (model => run%model)
      type is (stack_model_t)
         if (.not. model%is_single()) return
         call set_error(error, input_failure, command%subject//': a single fit has no parts, given --shard '// &
            show_count(command%part%number)//'/'//show_count(command%part%of)//', allowed: adfric fit without --shard')
      end select
   end subroutine check_part

   !> Refine the sweep of a run that wants it. What this finds is the same whenever it is done, so that a run goes on with it, and a
   !> part has the values of the others; the hash of the case tells if not.
   subroutine refine_run(command, world, run, error)
      type(command_t), intent(in) :: command
      !> The processes that take part; the first one solves.
      type(world_t), intent(in) :: world
      !> The run, whose only sweep may get more values.
      class(run_t), intent(inout) :: run
      !> Not allocated if all went well; the same in all processes.
      type(error_t), allocatable, intent(out) :: error

      if (.not. run%refinement%is_wanted()) return
      call run%model%prepare()
      call refine_together(world, run%refinement, run%model, run%plan%base, run%plan%axes(1), error)
      call run%model%release()
      if (allocated(error)) error%message = command%subject//': '//error%message
   end subroutine refine_run

   !> Is the run that is to be resumed complete already? A file of another run is left to `check_output`.
   subroutine find_complete(command, run, is_complete, summary, error)
      type(command_t), intent(in) :: command
      class(run_t), intent(in) :: run
      !> Is every point solved, so that nothing has to be done?
      logical, intent(out) :: is_complete
      !> Counts and ranges of the whole run; only to be used if it is complete.
      type(run_summary_t), intent(out) :: summary
      !> Allocated if the file is not complete and may not be overwritten, or if its other name cannot be removed.
      type(error_t), allocatable, intent(out) :: error
      type(layout_t) :: layout
      type(block_list_t) :: list
      type(error_t), allocatable :: mismatch
      character(:), allocatable :: partial

      is_complete = .false.
      if (.not. command%resumes) return
      if (kind_of_path(run%output) /= path_file) return
      if (would_replace(run%output, command%subject)) return
      partial = partial_name(run%output)
      if (kind_of_path(partial) == path_file) then
         if (.not. is_same(id_of_file(partial), id_of_file(run%output))) return
         ! the run was stopped while it gave the file its name
         call remove_file(partial, error)
         if (allocated(error)) return
      end if
      call new_layout(layout, run)
      call read_done_points(run%output, run, layout, list, summary, mismatch)
      is_complete = .not. allocated(mismatch)
      if (is_complete) is_complete = list%n_remaining == 0
      if (is_complete .or. command%overwrite) return
      if (.not. allocated(mismatch)) then
         if (summary%n_damaged > 0) then
            call set_error(mismatch, file_failure, run%output//': it is damaged, '//show_count(summary%n_damaged) &
               //' points have not the values that were written')
         else
            call set_error(mismatch, file_failure, run%output//': not every point is solved')
         end if
      end if
      mismatch%message = mismatch%message//'; --force overwrites it, --output writes another file'
      call move_alloc(mismatch, error)
   end subroutine find_complete

   !> Can the results be written? Asked before anything is solved.
   subroutine check_output(command, world, run, error)
      type(command_t), intent(in) :: command
      !> The processes that take part; the first one looks at the names, all look at the memory.
      type(world_t), intent(in) :: world
      class(run_t), intent(in) :: run
      !> Allocated if the results cannot be written.
      type(error_t), allocatable, intent(out) :: error
      integer :: k

      if (.not. world%is_first()) then
         call check_memory(run, world%n_here, error)
         if (allocated(error)) error%message = command%subject//': '//error%message
         return
      end if
      if (would_replace(run%output, command%subject)) then
         call set_error(error, input_failure, run%output//': the results would replace the input')
         return
      end if
      do k = 1, size(run%datasets)
         if (.not. run%datasets(k)%is_in_file()) cycle
         if (.not. would_replace(run%output, run%datasets(k)%file)) cycle
         call set_error(error, input_failure, run%output//': the results would replace the data of '//run%model%variables(k)%name)
         return
      end do
      call check_output_name(run%output, command%overwrite, error)
      if (.not. allocated(error)) call check_partial_name(run%output, command%overwrite .or. command%resumes, error)
      if (allocated(error)) return
      if (is_begun(command, run)) then
         call check_memory(run, world%n_here, error)
      else
         call check_resources(run, world%n_here, error)
      end if
      if (allocated(error)) error%message = command%subject//': '//error%message
   end subroutine check_output

   !> What a run says that was asked to end, and how it goes on.
   function say_stopped(command, run, summary) result(text)
      type(command_t), intent(in) :: command
      class(run_t), intent(in) :: run
      !> Counts of the points that are solved, and the signal that ended the run.
      type(run_summary_t), intent(in) :: summary
      character(:), allocatable :: text
      type(blocks_t) :: blocks

      blocks = run%blocks()
      text = command%subject//': stopped by '//signal_name(summary%signal)//', '//show_count(summary%n_points)//' of ' &
         //show_count(blocks%n_points())//' points are in '//partial_name(run%output)//'; adfric '//command%name//' --resume'
      if (.not. command%part%is_whole()) &
         text = text//' --shard '//show_count(command%part%number)//'/'//show_count(command%part%of)
      if (len(command%output) > 0) text = text//' --output '//shell_word(command%output)
      text = text//' '//shell_word(command%subject)//' goes on'
   end function say_stopped

end module adfric_command_run

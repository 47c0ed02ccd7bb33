! SPDX-License-Identifier: GPL-3.0-or-later
!> Solve what remains of a run, alone or together with other processes, and write it.
module adfric_command_solve
   use hdf5, only: hid_t
   use omp_lib, only: omp_get_max_threads
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp
   use adfric_command_line, only: command_t
   use adfric_hdf5_calls, only: hdf5_calls_t
   use adfric_output_names, only: partial_name
   use adfric_output_results_file, only: results_file_t
   use adfric_run_agreement, only: share_error, share_done_blocks, add_up_summary
   use adfric_run_shared_blocks, only: shared_blocks_t, new_shared_blocks
   use adfric_run_world, only: world_t
   use adfric_run_block_source, only: block_list_t, new_block_list
   use adfric_run_progress, only: progress_t
   use adfric_run_run, only: run_t
   use adfric_run_runner, only: run_sweep
   use adfric_run_summary, only: run_summary_t, new_summary
   use adfric_system_files, only: kind_of_path, path_file
   use adfric_system_interruption, only: catch_signals
   use adfric_system_threads, only: check_threads
   implicit none (type, external)
   private
   public :: solve_case, is_begun

contains

   !> Solve every point that is not solved yet, and write the results. Only the first process names and completes the file.
   subroutine solve_case(command, world, run, seconds_before, progress, summary, error)
      type(command_t), intent(in) :: command
      !> The processes that solve the run together.
      type(world_t), intent(inout) :: world
      class(run_t), intent(in) :: run
      !> What it took before the first point, such as the search of a fit [s].
      real(dp), intent(in) :: seconds_before
      !> Is told from time to time how many points are solved.
      class(progress_t), intent(inout) :: progress
      !> Summary of all processes; the points that were solved before count in the first of them alone.
      type(run_summary_t), intent(out) :: summary
      !> Not allocated if all went well; the same in all processes.
      type(error_t), allocatable, intent(out) :: error
      type(results_file_t) :: results
      type(run_summary_t) :: before
      type(block_list_t) :: list

      call catch_signals()
      call begin_file(command, world, run, results, list, before, error)
      if (allocated(error)) return
      if (world%n_ranks == 1) then
         call run_sweep(run, results, progress, summary, error, list)
      else
         call solve_together(world, run, results, list, progress, summary, error)
      end if
      if (world%is_first()) then
         summary%wall_seconds = summary%wall_seconds + seconds_before
         call summary%merge(before)
         if (summary%n_points == list%blocks%n_points()) summary%signal = 0
         call end_file(results, summary, error)
         summary%wall_seconds = summary%wall_seconds + before%wall_seconds
      end if
      call share_error(world, error)
   end subroutine solve_case

   !> Create the file or go on with the one that is there, and find the blocks that remain.
   subroutine begin_file(command, world, run, results, list, before, error)
      type(command_t), intent(in) :: command
      type(world_t), intent(in) :: world
      class(run_t), intent(in) :: run
      !> The results file, open in the first process alone.
      type(results_file_t), intent(inout) :: results
      !> Blocks of the run, with those marked that are solved; the same in all processes.
      type(block_list_t), intent(out) :: list
      !> Summary of the points that are solved already; of none but in the first process.
      type(run_summary_t), intent(out) :: before
      type(error_t), allocatable, intent(out) :: error
      logical :: resumes

      call check_threads(omp_get_max_threads(), error)
      if (allocated(error)) error%message = command%subject//': '//error%message
      call share_error(world, error)
      if (allocated(error)) return
      resumes = .false.
      if (world%is_first()) resumes = is_begun(command, run)
      if (resumes) then
         call results%resume(run, command%overwrite, list, before, error)
      else
         call new_block_list(list, run%blocks())
         call new_summary(before, run%model%results)
         if (world%n_ranks == 1) then
            ! the file is created while the first points are solved
            call results%begin(run, command%overwrite, error)
         else if (world%is_first()) then
            call results%create(run, command%overwrite, error)
         end if
      end if
      call share_error(world, error)
      if (.not. allocated(error)) call share_done_blocks(world, list)
   end subroutine begin_file

   !> Is there a file to go on with?
   logical function is_begun(command, run)
      type(command_t), intent(in) :: command
      class(run_t), intent(in) :: run

      is_begun = .false.
      if (command%resumes) is_begun = kind_of_path(partial_name(run%output)) == path_file
   end function is_begun

   !> Solve the blocks of a list together with the other processes. An error in one of them ends the work of all.
   subroutine solve_together(world, run, results, list, progress, summary, error)
      !> The processes that solve the run together.
      type(world_t), intent(inout), target :: world
      class(run_t), intent(in) :: run
      !> The results file, open in the first process alone, before and after.
      type(results_file_t), intent(inout) :: results
      !> Blocks of the run, with those marked that are solved; the same in all processes.
      type(block_list_t), intent(in) :: list
      class(progress_t), intent(inout) :: progress
      !> Summary of the points that all processes solve now.
      type(run_summary_t), intent(out) :: summary
      type(error_t), allocatable, intent(out) :: error
      type(shared_blocks_t) :: blocks
      integer(hid_t) :: access
      type(hdf5_calls_t) :: calls

      call new_summary(summary, run%model%results)
      if (world%is_first()) then
         call results%hand_over(error)
      else
         call results%join(run, error)
      end if
      call share_error(world, error)
      if (allocated(error)) return
      call world%create_shared_access(calls, access)
      call results%open_shared(access, error)
      call calls%close_id(access)
      call share_error(world, error)
      if (.not. allocated(error)) then
         call new_shared_blocks(blocks, list, world)
         call run_sweep(run, results, progress, summary, error, blocks)
      end if
      call results%close_shared(error)
      call share_error(world, error)
      call add_up_summary(world, summary)
      if (world%is_first() .and. .not. allocated(error)) call results%open_found(error)
   end subroutine solve_together

   !> Complete the file, or leave it for another time.
   subroutine end_file(results, summary, error)
      !> The results file; it is closed afterwards.
      type(results_file_t), intent(inout) :: results
      !> Summary of all points that are solved; its time is that of this run alone.
      type(run_summary_t), intent(in) :: summary
      !> In: why the run ended before its time, if it did. Out: that with what remains of the file, or why the file failed.
      type(error_t), allocatable, intent(inout) :: error

      if (allocated(error)) then
         call results%abandon(error)
      else if (summary%signal /= 0) then
         call results%stop(summary%wall_seconds, error)
      else
         call results%finish(summary%wall_seconds, error)
      end if
   end subroutine end_file

end module adfric_command_solve

! SPDX-License-Identifier: GPL-3.0-or-later
!> The program `adfric`: see `adfric help`.
program main
   use, intrinsic :: iso_c_binding, only: c_int
   use adfric_base_error, only: error_t
   use adfric_base_version, only: program_version, git_revision
   use adfric_command_check, only: check_case
   use adfric_command_help, only: give_help
   use adfric_command_line, only: command_t, get_arguments, parse_arguments
   use adfric_command_merge, only: merge_parts
   use adfric_command_modernise, only: modernise_input
   use adfric_command_outcome, only: outcome_t, exit_success
   use adfric_command_run, only: run_case
   use adfric_driver_last_resort, only: begin_watch, end_watch
   use adfric_driver_last_words, only: write_outcome
   use adfric_driver_progress_bar, only: progress_bar_t, new_progress_bar
   use adfric_run_agreement, only: share_status
   use adfric_run_world, only: world_t, world_kind
   use adfric_system_program_end, only: end_program
   implicit none (type, external)
   type(world_t) :: world
   type(command_t) :: command
   type(outcome_t) :: outcome
   type(error_t), allocatable :: error
   type(progress_bar_t) :: bar

   call begin_watch()
   call world%start()
   call parse_arguments(get_arguments(), command, error)
   if (allocated(error)) then
      call outcome%fail(error)
   else if (command%name == 'run' .or. command%name == 'fit') then
      call new_progress_bar(bar, command%is_quiet .or. .not. world%is_first())
      call run_case(command, world, bar, outcome)
      call bar%clear()
   else if (world%is_first()) then
      select case (command%name)
      case ('merge')
         call merge_parts(command, outcome)
      case ('modernise')
         call modernise_input(command, outcome)
      case ('check')
         call check_case(command, outcome)
      case ('help')
         call give_help(command, outcome)
      case default
         call outcome%say('adfric '//program_version//' ('//git_revision//world_kind//')'//new_line('a'))
      end select
   end if

   if (world%is_first()) call write_outcome(outcome)
   call share_status(world, outcome%exit_status)
   call world%stop()
   call end_watch()
   if (outcome%exit_status /= exit_success) call end_program(int(outcome%exit_status, c_int))
end program main

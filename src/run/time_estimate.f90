! SPDX-License-Identifier: GPL-3.0-or-later
!> How long a run will take on a machine that has nothing else to do, from a few of its points that are solved in another process
!> for a fraction of a second.
module adfric_run_time_estimate
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use omp_lib, only: omp_get_max_threads, omp_get_num_procs
   use adfric_base_kinds, only: dp, i8
   use adfric_describe_doubt, only: doubt_name, doubt_none, n_doubts
   use adfric_describe_profile_receiver, only: profile_receiver_t
   use adfric_describe_status, only: status_solved
   use adfric_run_blocks, only: blocks_t
   use adfric_run_run, only: run_t
   use adfric_system_clock, only: wall_clock
   use adfric_system_child_process, only: child_process_t, start_child
   implicit none (type, external)
   private
   public :: time_estimate_t, estimate_time, longest_trial

   !> Time after which no trial is begun, and after which one that has been begun is given up [s].
   real(dp), parameter :: time_for_trials = 0.3_dp, longest_trial = 0.6_dp
   !> What is counted of trial points.
   integer, parameter :: n_counts = 2 + n_doubts
   !> The other process ends so long after the last trial should have, even if this one is gone [s].
   real(dp), parameter :: time_to_end = 1.0_dp
   !> A trial that takes longer has enough points [s].
   real(dp), parameter :: long_trial = 0.02_dp

   !> Name of the result that tells by how much a coupling that is left out changes the friction, over the friction.
   character(*), parameter :: coupling_name = 'coupling_left_out'

   !> What is known of the time of a run.
   type :: time_estimate_t
      !> Time of all points with the threads that there are [s].
      real(dp) :: seconds = 0
      !> Number of threads that solve.
      integer :: n_threads = 1
      !> Was at least one trial made to its end? Else the time is only known to be longer.
      logical :: is_complete = .false.
      !> Is anything known?
      logical :: is_known = .false.
      !> Number of trial points, and of those beyond each bound of the theory.
      integer :: n_trials = 0, by_doubt(n_doubts) = 0
      !> Trial points of which a coupling that is left out changes the friction by more than its error, and those without an answer.
      integer :: n_uncoupled = 0, n_unsolved = 0
   end type time_estimate_t

   !> Takes profiles and forgets them.
   type, extends(profile_receiver_t) :: waste_t
   contains
      procedure :: take => take_waste
   end type waste_t

contains

   !> Estimate the time of a run. It takes no longer than `patience`, whatever becomes of the trials.
   subroutine estimate_time(run, estimate, patience)
      !> The run, whose model solves the points.
      class(run_t), intent(in) :: run
      !> Receives the time, or that it is not known.
      type(time_estimate_t), intent(out) :: estimate
      !> Time after which a trial is given up [s]; `longest_trial` if absent.
      real(dp), intent(in), optional :: patience
      type(blocks_t) :: blocks
      type(child_process_t) :: child
      real(dp) :: start, trial(2 + n_counts), points, seconds, seconds_of_all, waited, longest
      logical :: is_there

      longest = longest_trial
      if (present(patience)) longest = patience
      blocks = run%blocks()
      estimate%n_threads = omp_get_max_threads()
      start = wall_clock()
      call start_child(child, ceiling(longest + time_to_end), is_there)
      if (child%is_child) then
         call try_points(run, blocks, child)
         call child%end_child()
      end if
      if (.not. is_there) return
      points = 0
      seconds = 0
      do
         call child%receive(trial, start + longest - wall_clock(), is_there)
         if (.not. is_there) exit
         points = points + trial(1)
         seconds = seconds + trial(2)
         estimate%n_trials = estimate%n_trials + nint(trial(1))
         estimate%n_uncoupled = estimate%n_uncoupled + nint(trial(3))
         estimate%n_unsolved = estimate%n_unsolved + nint(trial(4))
         estimate%by_doubt = estimate%by_doubt + nint(trial(5:))
      end do
      waited = wall_clock() - start
      call child%stop(seconds_of_all)
      call conclude(points, seconds, seconds_of_all, blocks, estimate)
      ! one point takes longer than all the time there was; or the trial was no success
      estimate%is_known = estimate%is_complete .or. waited >= longest
   end subroutine estimate_time

   !> The time of all points from that of some.
   subroutine conclude(points, seconds, seconds_of_all, blocks, estimate)
      !> Number of points that the trials have solved.
      real(dp), intent(in) :: points
      !> Time that these points took on a processor [s].
      real(dp), intent(in) :: seconds
      !> Time of all trials on a processor, whether they came to an end or not [s].
      real(dp), intent(in) :: seconds_of_all
      !> The blocks of the run, which say how many points and blocks it has.
      type(blocks_t), intent(in) :: blocks
      !> In: the number of threads. Out: also the time, and whether a trial came to its end.
      type(time_estimate_t), intent(inout) :: estimate
      real(dp) :: per_point
      integer(i8) :: n_at_once

      n_at_once = min(int(min(estimate%n_threads, omp_get_num_procs()), i8), blocks%n_blocks_of_run)
      estimate%is_complete = points > 0
      per_point = seconds_of_all
      if (estimate%is_complete) per_point = seconds/points
      estimate%seconds = per_point*real(blocks%n_points_of_run, dp)/n_at_once
   end subroutine conclude

   !> In the other process: solve neighbouring points here and there in the run, more of them at once as long as that is quick, and
   !> tell how long it takes once there are as many as there will be: the first point of a block takes longer than the others. Where
   !> the time is over before, the last trial has to do.
   subroutine try_points(run, blocks, child)
      class(run_t), intent(in) :: run
      !> The blocks of the run, of which some are tried.
      type(blocks_t), intent(in) :: blocks
      !> Sends the number of points and the time [s] of each trial to the process that waits for them.
      type(child_process_t), intent(in) :: child
      real(dp) :: start, seconds
      integer(i8) :: n_done
      integer :: k, n, n_solved, largest, of_trial(n_counts)
      logical :: is_told

      start = wall_clock()
      largest = int(min(int(blocks%size, i8), blocks%n_points_of_run))
      n = 1
      n_done = 0
      k = 0
      n_solved = 0
      seconds = 0
      of_trial = 0
      is_told = .false.
      do while (wall_clock() - start < time_for_trials .and. n_done < 2*blocks%n_points_of_run)
         k = k + 1
         call try_block(run, blocks, block_of_trial(blocks, k), n, seconds, n_solved, of_trial)
         n_done = n_done + n_solved
         if (seconds < long_trial .and. n < largest) then
            n = min(2*n, largest)
         else
            call child%send([real(n_solved, dp), seconds, real(of_trial, dp)])
            is_told = .true.
         end if
      end do
      if (.not. is_told) call child%send([real(n_solved, dp), seconds, real(of_trial, dp)])
   end subroutine try_points

   !> The block of a trial: the first one in the middle, the others where the run is tried least so far.
   pure integer(i8) function block_of_trial(blocks, trial) result(block)
      !> The blocks of the run, which say how many there are.
      type(blocks_t), intent(in) :: blocks
      !> Number of the trial, from 1.
      integer, intent(in) :: trial
      real(dp) :: index, step
      integer :: rest

      ! the digits of the number behind the point, in reverse (van der Corput)
      index = 0
      step = 0.5_dp
      rest = trial
      do while (rest > 0)
         index = index + step*modulo(rest, 2)
         rest = rest/2
         step = step/2
      end do
      block = min(int(index*real(blocks%n_blocks_of_run, dp), i8) + 1, blocks%n_blocks_of_run)
   end function block_of_trial

   !> Solve the first points of a block.
   subroutine try_block(run, blocks, block, n_wanted, seconds, n, of_trial)
      class(run_t), intent(in) :: run
      !> The blocks of the run, which say where this one begins and ends.
      type(blocks_t), intent(in) :: blocks
      !> Number of the block in the run, from 1.
      integer(i8), intent(in) :: block
      !> Number of points to solve; fewer are if the block has fewer.
      integer, intent(in) :: n_wanted
      !> Time that the points took on a processor [s].
      real(dp), intent(out) :: seconds
      !> Number of points that were solved.
      integer, intent(out) :: n
      !> Receives how many of them leave out a coupling that counts, have no answer, and lie beyond each bound of the theory.
      integer, intent(out) :: of_trial(n_counts)
      real(dp), allocatable :: values(:, :), results(:, :), errors(:), profiles(:, :, :)
      integer, allocatable :: status(:)
      real(dp) :: counts(size(run%model%counts))
      type(waste_t) :: waste
      real(dp) :: start, finish
      integer :: shape(3)

      n = min(n_wanted, blocks%n_points_of(block))
      allocate (values(size(run%model%variables), n), results(size(run%model%results), n), errors(n), status(n))
      call run%plan%get_values(blocks%first_point(block), values)
      call cpu_time(start)
      shape = run%profile_shape()
      if (all(shape > 0)) then
         allocate (profiles(shape(1), shape(2), shape(3)))
         call run%model%solve_block_and_profiles(values, results, errors, status, counts, profiles, waste)
      else
         call run%model%solve_block(values, results, errors, status, counts)
      end if
      call cpu_time(finish)
      seconds = finish - start
      call count_doubts(run, results, errors, status, of_trial)
   end subroutine try_block

   !> Count the points that leave out a coupling that counts, those without an answer, and those beyond each bound of the theory.
   subroutine count_doubts(run, results, errors, status, of_trial)
      class(run_t), intent(in) :: run
      !> Results of the points, shape `(n_results, n)`, and their estimated relative errors; shape `(n)`.
      real(dp), intent(in) :: results(:, :), errors(:)
      !> Status of the points; shape `(n)`.
      integer, intent(in) :: status(:)
      !> Receives the counts; shape `(n_counts)`.
      integer, intent(out) :: of_trial(:)
      integer :: i, k

      of_trial = 0
      of_trial(2) = count(status /= status_solved)
      do k = 1, size(run%model%results)
         do i = 1, size(status)
            if (status(i) /= status_solved .or. ieee_is_nan(results(k, i))) cycle
            if (run%model%results(k)%name == coupling_name .and. abs(results(k, i)) > errors(i)) of_trial(1) = of_trial(1) + 1
            if (run%model%results(k)%name /= doubt_name) cycle
            associate (doubt => nint(results(k, i)))
               if (doubt > doubt_none) of_trial(2 + doubt) = of_trial(2 + doubt) + 1
            end associate
         end do
      end do
   end subroutine count_doubts

   !> Forget the profiles of a point.
   subroutine take_waste(self, index, profiles, goes_on)
      class(waste_t), intent(inout) :: self
      !> Index of the point in its block, from 1; not used.
      integer, intent(in) :: index
      !> Profiles of the point, which are forgotten; shape `(n_last_axis, n_first_axis, n_profiles)`.
      real(dp), intent(in) :: profiles(:, :, :)
      !> Always true: the rest of the block is wanted, so that its time is known.
      logical, intent(out) :: goes_on

      goes_on = .true.
      associate (unused => self, unused_index => index, unused_profiles => profiles)
      end associate
   end subroutine take_waste

end module adfric_run_time_estimate

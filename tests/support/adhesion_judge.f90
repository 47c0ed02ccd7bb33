! SPDX-License-Identifier: GPL-3.0-or-later
!> Is a state of an adhering surface one, and the one that was asked for? Pressure and shares from `plain_periodic`, branches from rounds
!> alone, energies, and the order of states.
module adhesion_judge
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_periodic_adhesive_solver, only: periodic_adhesion_t, solve_adhesive_load
   use adfric_periodic_cohesion, only: new_cohesion
   use adfric_periodic_contact, only: contact_state_t, solve_contact, start_contact
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_gap_solver, only: gap_solver_t, new_gap_solver
   use adfric_periodic_operator, only: periodic_operator_t, new_periodic_operator
   use adfric_periodic_solver, only: periodic_solver_t, periodic_solution_t, new_periodic_solver, contact_solved, &
      & contact_not_converged, contact_out_of_range
   use adhesion_trials, only: adhesion_trial_t
   use plain_periodic, only: stiff_pressure, plain_share
   implicit none (type, external)
   private
   public :: adhesion_counts_t, judge_adhesion

   !> What is asked of the solver, and how much more of it an answer may leave; and the round-off of a sum of some thousand terms.
   real(dp), parameter :: tolerance = 1.0e-10_dp, slack = 4.0_dp, round_off = 1.0e-14_dp
   !> Shares and gaps, over the height, of two states that are in order differ by no more the other way. On maps, where the
   !> stiffness has entries of 2 % above 0 off its diagonal, the order is not proved.
   real(dp), parameter :: like_share = 1.0e-5_dp, like_gap = 1.0e-7_dp, like_share_of_map = 2.0e-3_dp, like_gap_of_map = 1.0e-4_dp
   !> Cells per zone below which a model has no answer but for contacts without an edge of adhesion (`elastic_model.f90`).
   real(dp), parameter :: least_cells = 0.5_dp
   !> Rounds that a time stepping may take, and the change of shares that ends it.
   integer, parameter :: most_rounds = 4000
   real(dp), parameter :: two_pi = 6.283185307179586476925286766559_dp
   real(dp), parameter :: resting = 1.0e-9_dp
   !> Transforms that no solution may take.
   real(dp), parameter :: most_pairs = 2.0e4_dp

   !> What a search has found.
   type :: adhesion_counts_t
      integer :: n_trials = 0, n_faults = 0
      !> Answers: solved, not converged, no state; and of those that are solved, with zones that the cells do not see.
      integer :: by_status(0:2) = 0, n_unseen = 0
      !> Loads with two states; pairs of states in order.
      integer :: n_with_branches = 0, n_in_order = 0
      !> Branches found by rounds alone: as many as agree, are the state on the other side of a jump, or do not come to rest.
      integer :: n_same = 0, n_beyond_jump = 0, n_restless = 0
      integer :: n_rounds = 0
      !> The largest residual over what is allowed, rise of an energy in a round over its size, and number of transforms.
      real(dp) :: residual = 0, rise = 0, pairs = 0
   end type adhesion_counts_t

contains

   !> Solve a trial on all branches, and judge each answer. What is wrong is said in `fault`, which is empty else.
   subroutine judge_adhesion(trial, counts, fault)
      type(adhesion_trial_t), intent(in) :: trial
      type(adhesion_counts_t), intent(inout) :: counts
      character(*), intent(out) :: fault
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: least, most, more_least, more_most, turn, turned
      type(error_t), allocatable :: error

      fault = ''
      counts%n_trials = counts%n_trials + 1
      call new_periodic_solver(solver, elastic_kernel_t(), shape(trial%shape), trial%period, trial%is_quarter, error)
      if (allocated(error)) error stop 'adhesion_judge: no solver'
      call answer(solver, trial, trial%load, .true., .false., most, counts, fault)
      call answer(solver, trial, trial%more_load, .true., .false., more_most, counts, fault)
      call answer(solver, trial, trial%turn, .false., .false., turn, counts, fault)
      if (turn%status == contact_solved) call answer(solver, trial, trial%load, .true., .true., turned, counts, fault)
      call put_in_order(trial, turned, turn, 'adhered beyond the turn', counts, fault)
      call put_in_order(trial, turned, most, 'adhered below what a turn leaves', counts, fault)
      call put_in_order(trial, most, more_most, 'more load is less adhered', counts, fault)
      call stepping(trial, most, .true., counts, fault)
      if (trial%load >= 0) then
         call answer(solver, trial, trial%load, .false., .false., least, counts, fault)
         call answer(solver, trial, trial%more_load, .false., .false., more_least, counts, fault)
         call put_in_order(trial, least, turned, 'a turn leaves less than the approach', counts, fault)
         call put_in_order(trial, least, more_least, 'more load is less adhered on approach', counts, fault)
         call stepping(trial, least, .false., counts, fault)
         if (least%status == contact_solved .and. most%status == contact_solved) then
            if (maxval(most%share - least%share) > 0.01_dp) counts%n_with_branches = counts%n_with_branches + 1
         end if
      end if
      if (len_trim(fault) > 0) counts%n_faults = counts%n_faults + 1
   end subroutine judge_adhesion

   !> Keep the first fault.
   pure subroutine say(fault, text, value)
      character(*), intent(inout) :: fault
      character(*), intent(in) :: text
      real(dp), intent(in) :: value

      if (len_trim(fault) == 0) write (fault, '(a, es10.2)') text, value
   end subroutine say

   !> Solve and judge one state.
   subroutine answer(solver, trial, load, is_adhered, has_turned, solution, counts, fault)
      type(periodic_solver_t), intent(inout) :: solver
      type(adhesion_trial_t), intent(in) :: trial
      real(dp), intent(in) :: load
      logical, intent(in) :: is_adhered, has_turned
      type(periodic_solution_t), intent(out) :: solution
      type(adhesion_counts_t), intent(inout) :: counts
      character(*), intent(inout) :: fault
      type(error_t), allocatable :: error

      call solve_adhesive_load(solver, trial%shape, load, periodic_adhesion_t(trial%stress, trial%range, is_adhered, has_turned, &
         & trial%turn), tolerance, solution, error)
      if (allocated(error)) error stop 'adhesion_judge: no solution'
      counts%by_status(solution%status) = counts%by_status(solution%status) + 1
      counts%pairs = max(counts%pairs, solution%n_pairs)
      if (solution%n_pairs > most_pairs) call say(fault, 'transforms', solution%n_pairs)
      if (is_unseen(trial, solution)) then
         counts%n_unseen = counts%n_unseen + 1
         solution%status = contact_not_converged
      end if
      if (solution%status == contact_out_of_range .and. load > 0) call say(fault, 'no state under a load', load)
      if (solution%status == contact_solved) call judge_state(trial, load, solution, counts, fault)
   end subroutine answer

   !> Do zones of adhesion end between cells that do not see them? Models give no such answer.
   pure logical function is_unseen(trial, solution)
      type(adhesion_trial_t), intent(in) :: trial
      type(periodic_solution_t), intent(in) :: solution
      integer :: n

      is_unseen = .false.
      if (solution%status /= contact_solved) return
      n = size(trial%shape, 1)*merge(2, 1, trial%is_quarter)
      is_unseen = two_pi/8*(trial%range/trial%stress)*n/trial%period(1) < least_cells .and. any(solution%share < 1) &
         & .and. any(solution%share > 0)
   end function is_unseen

   !> Conditions of contact, the shares of the gap, the load.
   subroutine judge_state(trial, load, solution, counts, fault)
      type(adhesion_trial_t), intent(in) :: trial
      real(dp), intent(in) :: load
      type(periodic_solution_t), intent(in) :: solution
      type(adhesion_counts_t), intent(inout) :: counts
      character(*), intent(inout) :: fault
      real(dp), allocatable, dimension(:, :) :: pressure, tension, change
      real(dp) :: scale, allowed, left, height

      associate (gap => solution%gap)
         if (.not. all(ieee_is_finite(gap)) .or. .not. all(ieee_is_finite(solution%pressure))) then
            call say(fault, 'not a number', 0.0_dp)
            return
         end if
         height = maxval(trial%shape)
         allocate (tension, change, mold=gap)
         tension(:, :) = trial%stress*plain_share(gap, trial%range, trial%is_quarter)
         change(:, :) = gap - trial%shape
         pressure = load + stiff_pressure(change, trial%period, trial%is_quarter)
         scale = maxval(pressure + tension)
         ! the shortest wave has the stiffness pi n/period
         allowed = slack*(tolerance + round_off*(two_pi*size(gap, 1)*height + trial%stress + abs(load))/scale)
         left = maxval(abs(min((pressure + tension)/scale, gap/height)))
         counts%residual = max(counts%residual, left/allowed)
         if (.not. left <= allowed) call say(fault, 'violation of the law', left)
         if (minval(gap) < 0) call say(fault, 'gap', minval(gap))
         change(:, :) = abs(solution%pressure - pressure)
         ! what was left in open cells is carried by the others
         left = allowed*scale*size(gap)/max(1, count(solution%pressure + trial%stress*solution%share > 0))
         if (.not. maxval(change) <= left) call say(fault, 'written pressure', maxval(change)/scale)
         change(:, :) = abs(solution%share - tension/trial%stress)
         if (.not. maxval(change) <= like_share) call say(fault, 'written share', maxval(change))
         if (.not. abs(sum(solution%pressure)/size(gap) - load) <= allowed*scale) call say(fault, 'mean pressure', load)
      end associate
   end subroutine judge_state

   !> Of two answers the first must not be more adhered.
   subroutine put_in_order(trial, low, high, text, counts, fault)
      type(adhesion_trial_t), intent(in) :: trial
      type(periodic_solution_t), intent(in) :: low, high
      character(*), intent(in) :: text
      type(adhesion_counts_t), intent(inout) :: counts
      character(*), intent(inout) :: fault
      real(dp) :: most_over, most_above
      logical :: is_line

      is_line = size(trial%shape, 2) == 1
      most_over = merge(like_share, like_share_of_map, is_line)
      most_above = merge(like_gap, like_gap_of_map, is_line)
      if (low%status == contact_solved .and. high%status == contact_out_of_range) call say(fault, text//': no state', 0.0_dp)
      if (low%status /= contact_solved .or. high%status /= contact_solved) return
      counts%n_in_order = counts%n_in_order + 1
      associate (over => maxval(low%share - high%share), above => maxval(high%gap - low%gap)/maxval(trial%shape))
         if (over > most_over) call say(fault, text//': share', over)
         if (above > most_above) call say(fault, text//': gap', above)
      end associate
      if (low%area%cells > high%area%cells) call say(fault, text//': area', low%area%cells - high%area%cells)
      if (low%penetration > high%penetration + most_above*maxval(trial%shape)) &
         & call say(fault, text//': penetration', low%penetration)
   end subroutine put_in_order

   !> Go rounds from all shares or from none: the energy falls in each, and they end at the answer, or beside it next to a jump.
   subroutine stepping(trial, solution, is_adhered, counts, fault)
      type(adhesion_trial_t), intent(in) :: trial
      type(periodic_solution_t), intent(in) :: solution
      logical, intent(in) :: is_adhered
      type(adhesion_counts_t), intent(inout) :: counts
      character(*), intent(inout) :: fault
      type(periodic_operator_t) :: operator
      type(gap_solver_t) :: gap_solver
      type(contact_state_t) :: state
      type(error_t), allocatable :: error
      real(dp), allocatable :: share(:, :)
      real(dp) :: energy, before, size_of
      integer :: k

      call new_periodic_operator(operator, elastic_kernel_t(), shape(trial%shape), trial%period, trial%is_quarter, .false., error)
      if (allocated(error)) error stop 'adhesion_judge: no operator'
      call new_gap_solver(gap_solver, shape(trial%shape))
      allocate (share, mold=trial%shape)
      share(:, :) = merge(1, 0, is_adhered)
      if (.not. is_adhered .and. .not. trial%load > 0) share(:, :) = plain_share(trial%shape, trial%range, trial%is_quarter)
      state%shape = trial%shape
      state%mean_pressure = trial%load
      allocate (state%cohesion)
      call new_cohesion(state%cohesion, trial%stress, trial%range, trial%is_quarter)
      state%cohesion%share = share
      before = huge(before)
      do k = 1, most_rounds
         if (.not. trial%load + trial%stress*sum(share)/size(share) > 0) then
            call compare(trial, solution, counts, is_adhered, fault)
            return
         end if
         state%cohesion%share = share
         if (.not. allocated(state%gap)) call start_contact(state, operator)
         state%n_iterations = 0
         state%n_rounds = 0
         call solve_contact(state, operator, gap_solver, 1.0e-11_dp)
         counts%n_rounds = counts%n_rounds + 1
         share(:, :) = plain_share(state%gap, trial%range, trial%is_quarter)
         call find_energy(trial, state%gap, share, energy, size_of)
         if (k > 1) counts%rise = max(counts%rise, (energy - before)/size_of)
         if (k > 1 .and. energy - before > 1.0e-9_dp*size_of) call say(fault, 'energy rises', (energy - before)/size_of)
         before = energy
         if (maxval(abs(share - state%cohesion%share)) > resting) cycle
         state%cohesion%share(:, :) = share
         call compare(trial, solution, counts, is_adhered, fault, state)
         return
      end do
      counts%n_restless = counts%n_restless + 1
   end subroutine stepping

   !> Energy of solid, adhesion and load, and the size of its terms.
   subroutine find_energy(trial, gap, share, energy, size_of)
      type(adhesion_trial_t), intent(in) :: trial
      real(dp), intent(in) :: gap(:, :), share(:, :)
      real(dp), intent(out) :: energy, size_of
      real(dp), allocatable :: change(:, :), stiff(:, :)
      real(dp) :: terms(3)

      allocate (change, mold=gap)
      change(:, :) = gap - trial%shape
      stiff = stiff_pressure(change, trial%period, trial%is_quarter)
      terms = [sum(change*stiff)/2, trial%stress*sum(share*(gap - trial%range)), trial%load*sum(gap)]/size(gap)
      energy = sum(terms)
      size_of = maxval(abs(terms)) + trial%full_pressure*maxval(trial%shape)*1.0e-6_dp
   end subroutine find_energy

   !> Is the answer where the rounds have come to rest, or that there is none where they broke off?
   subroutine compare(trial, solution, counts, is_adhered, fault, state)
      type(adhesion_trial_t), intent(in) :: trial
      type(periodic_solution_t), intent(in) :: solution
      type(adhesion_counts_t), intent(inout) :: counts
      logical, intent(in) :: is_adhered
      character(*), intent(inout) :: fault
      type(contact_state_t), intent(in), optional :: state
      logical :: is_same

      if (solution%status == contact_not_converged) return
      if (.not. present(state) .or. solution%status == contact_out_of_range) then
         is_same = .not. present(state) .and. solution%status == contact_out_of_range
      else
         is_same = maxval(abs(state%gap - solution%gap)) <= 1.0e-5_dp*maxval(trial%shape)
         ! beyond the wanted state there is none
         associate (over => maxval(merge(1, -1, is_adhered)*(solution%share - state%cohesion%share)))
            if (over > merge(like_share, like_share_of_map, size(trial%shape, 2) == 1) .and. .not. is_same) &
               & call say(fault, 'beyond the last state: share', over)
         end associate
      end if
      counts%n_same = counts%n_same + merge(1, 0, is_same)
      counts%n_beyond_jump = counts%n_beyond_jump + merge(0, 1, is_same)
   end subroutine compare

end module adhesion_judge

! SPDX-License-Identifier: GPL-3.0-or-later
!> Random waves that adhere while they slide, judged by transients (`wave_transient`): a point of `wave_1d` is right if sliding from
!> apart, or from full contact, ends in its state.
!>
!> A transient runs on two grids. Its answer is that of the finer one, and its error is a multiple of the difference of the two. So
!> a state of another branch is found out, and a wrong digit beyond the error of the cells is not.
module transient_judge
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_problems, only: problems_t
   use adfric_describe_status, only: status_no_equilibrium, status_solved
   use random_dice, only: dice_t
   use trial_case, only: trial_case_t, new_case
   use wave_transient, only: transient_t, contact_fraction_of, friction_of, full_pressure_of, new_transient, settle, &
      & slide_at_gap, slide_under, start_flat, start_full_at_speed
   implicit none (type, external)
   private
   public :: slide_trial_t, transient_counts_t, draw_slide, judge_slide, solve_program, words_of_slide

   !> A wave in reduced units, on a solid that relaxes to E0 = 1 (`wave_transient`).
   type :: slide_trial_t
      !> Moduli and relaxation lengths of the arms; shape `(n_arms)`.
      real(dp), allocatable :: moduli(:), lengths(:)
      !> Tension, range, and the mean pressure or the penetration.
      real(dp) :: stress = 0, range = 0, prescribed = 0
      !> Is the penetration prescribed? Does the state come from full contact?
      logical :: has_penetration = .false., is_adhered = .false.
      !> Events of the program at this speed: pull-off, saturation fold, end of saturation, NaN where there is none, and the least
      !> mean pressure of full contact without adhesion.
      real(dp) :: events(4) = 0
   end type slide_trial_t

   !> What became of trials.
   type :: transient_counts_t
      !> Trials; answers of the program that are no convergence; transients that did not settle, or whose grids are not of
      !> one mind; states that were judged, and of these the ones without contact.
      integer :: n_trials = 0, n_unconverged = 0, n_restless = 0, n_judged = 0, n_apart = 0
      !> Judged states with a gap, and those whose friction is known to 20 % at least.
      integer :: n_gaps = 0, n_sharp = 0
      !> Wrong ones.
      integer :: n_wrong = 0
      !> Largest difference over what is allowed.
      real(dp) :: largest = 0
   end type transient_counts_t

   !> Answer of a transient: friction, penetration or mean pressure, and share in contact.
   type :: answer_t
      real(dp) :: values(3) = 0
      logical :: is_apart = .false., is_settled = .false.
   end type answer_t

   !> Cells of the two grids, periods at most.
   integer, parameter :: coarse = 64, fine = 128, most_periods = 150
   !> Periods of a change of the load, and more for each relaxation length of an arm.
   integer, parameter :: ramp_periods = 6
   !> Relaxation lengths up to which a ramp is longer.
   real(dp), parameter :: longest_ramp = 10
   !> Penetration at which loading at a mean gap begins: apart, the flat surface would touch.
   real(dp), parameter :: first_penetration = 0.02_dp
   !> Error of the finer grid in units of the difference of the two, and what is allowed besides, relative and absolute.
   real(dp), parameter :: error_over_difference = 3, digits = 2.0e-3_dp, cells_of_contact = 2
   !> Difference of the grids, relative, up to which friction counts as known.
   real(dp), parameter :: sharp = 0.2_dp

contains

   !> Draw a wave, whose events are those that the program finds.
   subroutine draw_slide(dice, trial)
      type(dice_t), intent(inout) :: dice
      type(slide_trial_t), intent(out) :: trial
      real(dp) :: spread, longest, total, part
      integer :: n, i

      call dice%choose(30, n)
      call dice%happens(0.4_dp, trial%has_penetration)
      if (trial%has_penetration) n = 1 + mod(n, 3)
      call dice%happens(0.3_dp, trial%has_penetration)
      call dice%happens(0.5_dp, trial%is_adhered)
      call dice%decades(-6.0_dp, 6.0_dp, longest)
      call dice%between(0.0_dp, 8.0_dp, spread)
      allocate (trial%moduli(n), trial%lengths(n))
      do i = 1, n
         call dice%between(0.0_dp, 1.0_dp, part)
         trial%lengths(i) = longest*10**(-spread*(i - 1 + 0.5_dp*part)/n)
         call dice%decades(-1.0_dp, 0.0_dp, trial%moduli(i))
      end do
      call dice%decades(-1.0_dp, 4.0_dp, total)
      trial%moduli = total*trial%moduli/sum(trial%moduli)
      call dice%decades(-1.3_dp, 0.5_dp, trial%stress)
      call dice%decades(-0.7_dp, 0.3_dp, part)
      trial%range = min(part*trial%stress, 1.8_dp)
      call get_events(trial)
      call draw_point(dice, trial)
   end subroutine draw_slide

   !> Draw the penetration, or the load away from the jumps.
   subroutine draw_point(dice, trial)
      type(dice_t), intent(inout) :: dice
      type(slide_trial_t), intent(inout) :: trial
      real(dp) :: part, low, high
      logical :: is_partial, has_fold

      call dice%between(0.06_dp, 0.94_dp, part)
      call dice%happens(0.7_dp, is_partial)
      if (trial%has_penetration) then
         trial%prescribed = part
         return
      end if
      associate (pull_off => trial%events(1), fold => trial%events(2), end => trial%events(3), full => trial%events(4))
         has_fold = .not. ieee_is_nan(fold)
         if (trial%is_adhered) then
            low = -trial%stress
            if (.not. ieee_is_nan(pull_off)) low = max(low, 0.85_dp*pull_off)
            high = end
            if (has_fold) high = min(end, fold)
            if (.not. (is_partial .and. high > low)) then
               low = end
               high = max(full - trial%stress, end + 0.3_dp*(end + trial%stress))
            end if
         else
            low = 0
            high = 0
            if (has_fold) high = max(fold, 0.0_dp)
            if (.not. (is_partial .and. high > 0)) then
               low = max(0.02_dp, high, end)
               high = 2*low
            end if
         end if
         trial%prescribed = low + part*(high - low)
      end associate
   end subroutine draw_point

   !> The point of a trial, in units in which 1/k = 1 m, k D = 0.1 and E0 k D = 1 Pa.
   subroutine solve_program(trial, case)
      type(slide_trial_t), intent(in) :: trial
      type(trial_case_t), intent(out) :: case

      call new_case(case, 'wave_1d')
      call case%give('period', 2*pi)
      call case%give('amplitude', 0.1_dp)
      call case%give('modulus', 10.0_dp)
      call give_list(case, 'moduli', 10*trial%moduli)
      call give_list(case, 'relaxation_times', trial%lengths)
      call case%give('velocity', 1.0_dp)
      call case%give('stress', trial%stress)
      call case%give('range', 0.1_dp*trial%range)
      call case%give('branch', merge(1.0_dp, 2.0_dp, trial%is_adhered))
      if (trial%has_penetration) then
         call case%give('penetration', 0.1_dp*trial%prescribed)
      else
         call case%give('mean_pressure', trial%prescribed)
      end if
      call case%solve()
   end subroutine solve_program

   !> Give a list to the material.
   subroutine give_list(case, name, values)
      type(trial_case_t), intent(inout) :: case
      character(*), intent(in) :: name
      real(dp), intent(in) :: values(:)
      type(problems_t) :: problems

      associate (row => case%model%index_of('material', name))
         case%values(row) = 1
         call case%model%take_dataset(row, reshape(values, [size(values), 1]), problems)
      end associate
      if (problems%count() > 0) error stop 'transient_judge: a list is refused'
   end subroutine give_list

   !> Ends of the branches.
   subroutine get_events(trial)
      type(slide_trial_t), intent(inout) :: trial
      type(trial_case_t) :: case

      call solve_program(trial, case)
      trial%events = [case%found('pull_off_pressure'), case%found('saturation_fold_pressure'), &
         & case%found('end_of_saturation_pressure'), case%found('full_contact_pressure')]
   end subroutine get_events

   !> Compare the state of the program with that of a transient.
   subroutine judge_slide(trial, counts, fault, asked, grids)
      type(slide_trial_t), intent(in) :: trial
      type(transient_counts_t), intent(inout) :: counts
      !> What is wrong; blank if nothing is.
      character(*), intent(out) :: fault
      !> What the program is asked, if it is not the trial: a fault that is made on purpose.
      type(slide_trial_t), intent(in), optional :: asked
      !> Cells of the coarse grid and of the fine one, if they are not the usual ones.
      integer, intent(in), optional :: grids(2)
      type(trial_case_t) :: case
      type(answer_t) :: rough, judge
      real(dp) :: allowed(3), found(3), over
      integer :: n(2)

      fault = ''
      n = [coarse, fine]
      if (present(grids)) n = grids
      counts%n_trials = counts%n_trials + 1
      if (present(asked)) then
         call solve_program(asked, case)
      else
         call solve_program(trial, case)
      end if
      if (all(case%status(1) /= [status_solved, status_no_equilibrium])) then
         counts%n_unconverged = counts%n_unconverged + 1
         return
      end if
      call slide_on(trial, n(1), rough)
      call slide_on(trial, n(2), judge)
      if (.not. (rough%is_settled .and. judge%is_settled) .or. (rough%is_apart .neqv. judge%is_apart)) then
         counts%n_restless = counts%n_restless + 1
         return
      end if
      counts%n_judged = counts%n_judged + 1
      if (judge%is_apart) counts%n_apart = counts%n_apart + 1
      if (judge%is_apart .neqv. case%status(1) == status_no_equilibrium) then
         fault = merge('contact is lost       ', 'contact is not lost   ', judge%is_apart)
      else if (.not. judge%is_apart) then
         found = [10*case%found('friction_stress'), 10*case%found('penetration'), case%found('contact_fraction')]
         if (trial%has_penetration) found(2) = case%found('mean_pressure')
         allowed = [error_over_difference + halvings_to_resolve(trial, n(2)), error_over_difference, error_over_difference]
         allowed = allowed*abs(judge%values - rough%values) + digits*abs(judge%values)
         allowed(2) = allowed(2) + digits*merge(trial%stress, 1.0_dp, trial%has_penetration)
         allowed(3) = allowed(3) + cells_of_contact/n(1)
         if (judge%values(3) < 1) counts%n_gaps = counts%n_gaps + 1
         if (abs(judge%values(1) - rough%values(1)) <= sharp*abs(judge%values(1))) counts%n_sharp = counts%n_sharp + 1
         over = maxval(abs(found - judge%values)/allowed)
         counts%largest = max(counts%largest, over)
         if (.not. over <= 1) write (fault, '(a, 3(3(1x, es13.6), ";"))') 'another state:', found, judge%values, rough%values
      end if
      if (len_trim(fault) > 0) counts%n_wrong = counts%n_wrong + 1
   end subroutine judge_slide

   !> How often the cells of the finer grid would have to be halved to be as short as the arms' lengths, on the mean of their losses.
   !> The pressure jumps at the ends of the zones, so that an arm far shorter than a cell has a loss that grows by the same at each
   !> halving.
   real(dp) function halvings_to_resolve(trial, n_cells) result(halvings)
      type(slide_trial_t), intent(in) :: trial
      !> Cells of the finer grid.
      integer, intent(in) :: n_cells
      real(dp) :: losses(size(trial%lengths))

      losses = trial%moduli*trial%lengths/(1 + trial%lengths**2)
      halvings = sum(losses*max(0.0_dp, log(2*pi/n_cells/trial%lengths)/log(2.0_dp)))/sum(losses)
   end function halvings_to_resolve

   !> Slide from apart, or from full contact, to the load or the penetration, and on until nothing changes.
   subroutine slide_on(trial, n, answer)
      type(slide_trial_t), intent(in) :: trial
      integer, intent(in) :: n
      type(answer_t), intent(out) :: answer
      type(transient_t) :: wave
      real(dp) :: start
      integer :: periods, k

      call new_transient(wave, n, trial%moduli, trial%lengths, trial%stress, trial%range)
      periods = ramp_periods
      if (any(trial%lengths <= longest_ramp)) periods = periods &
         & + ceiling(2*maxval(trial%lengths, mask=trial%lengths <= longest_ramp))
      if (trial%is_adhered) then
         call start_full_at_speed(wave)
         start = full_pressure_of(wave) - trial%stress
         start = start + 0.1_dp*abs(start)
         if (.not. trial%has_penetration) start = max(start, trial%prescribed)
         call slide_under(wave, start)
      else
         call start_flat(wave)
         if (trial%has_penetration) then
            call slide_at_gap(wave, 1 - first_penetration)
         else
            start = 1.0e-3_dp*min(1.0_dp, trial%prescribed)
            call slide_under(wave, start)
         end if
      end if
      if (trial%has_penetration) start = 1 - sum(wave%gap)/n
      do k = 1, periods*n
         if (wave%is_apart .or. .not. wave%is_sound) exit
         associate (now => start + (trial%prescribed - start)*k/(periods*n))
            if (trial%has_penetration) then
               call slide_at_gap(wave, 1 - now)
            else
               call slide_under(wave, now)
            end if
         end associate
      end do
      if (.not. wave%is_apart .and. wave%is_sound) call settle(wave, most_periods, trial%has_penetration, 1.0e-5_dp, &
         & answer%is_settled)
      answer%is_apart = wave%is_apart
      if (wave%is_apart) answer%is_settled = .true.
      answer%values = [friction_of(wave), merge(wave%load, 1 - sum(wave%gap)/n, trial%has_penetration), contact_fraction_of(wave)]
      if (any(ieee_is_nan(answer%values))) answer%is_settled = .false.
   end subroutine slide_on

   !> A trial in words.
   subroutine words_of_slide(trial, words)
      type(slide_trial_t), intent(in) :: trial
      character(*), intent(out) :: words

      write (words, '(a, 1x, a, es23.16, 2(a, es23.16), a, *(1x, es12.5))') merge('adhered ', 'approach', trial%is_adhered), &
         & merge('penetration  ', 'mean_pressure', trial%has_penetration), trial%prescribed, ' stress', trial%stress, ' range', &
         & trial%range, ' events, moduli, lengths', trial%events, trial%moduli, trial%lengths
   end subroutine words_of_slide

end module transient_judge

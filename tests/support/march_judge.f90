! SPDX-License-Identifier: GPL-3.0-or-later
!> Random cases for the time stepping of any heights, and what a time stepping in small steps says of its solutions.
module stepping_judge
   use adfric_base_kinds, only: dp
   use adfric_shape_height_line, only: height_line_t, new_cosine_line
   use brute_spectrum, only: brute_column_t, brute_forces_t, new_brute_column, settle
   use stepping_cases, only: stepping_case_t
   use random_dice, only: dice_t
   implicit none (type, external)
   private
   public :: draw_case, judge_case, words_of_case, verdict_right, verdict_wrong, verdict_open

   !> The time stepping agrees; it does not, however small the steps; it did not come to rest.
   integer, parameter :: verdict_right = 0, verdict_wrong = 1, verdict_open = 2
   !> Load and friction agree to this share of the sizes of stresses.
   real(dp), parameter :: agreement = 3.0e-4_dp
   !> Steps of the first time stepping, and how often they are multiplied by four.
   integer, parameter :: first_steps = 2048, most_refinements = 4
   integer, parameter :: most_periods = 3000

contains

   !> A sum of 3 to 10 waves on a solid with 1 to 20 times; edge rule and branch follow in turn.
   subroutine draw_case(dice, number, trial, depth)
      type(dice_t), intent(inout) :: dice
      integer, intent(in) :: number
      type(stepping_case_t), intent(out) :: trial
      real(dp), intent(out) :: depth
      real(dp) :: decay, sum_of_amplitudes
      integer :: m, n

      call dice%choose(8, n)
      n = n + 2
      call dice%between(0.5_dp, 1.5_dp, decay)
      allocate (trial%amplitudes(n), trial%phases(n))
      do m = 1, n
         call dice%between(0.3_dp, 1.0_dp, trial%amplitudes(m))
         trial%amplitudes(m) = trial%amplitudes(m)*m**(-decay)
         call dice%between(0.0_dp, 6.2831853_dp, trial%phases(m))
      end do
      sum_of_amplitudes = sqrt(2*sum(trial%amplitudes**2))
      trial%amplitudes = trial%amplitudes*0.35_dp/sum_of_amplitudes
      call dice%choose(20, n)
      if (mod(number, 3) == 0) n = 1 + mod(n, 3)
      allocate (trial%stiffness(n), trial%times(n))
      do m = 1, n
         call dice%decades(-1.0_dp, 0.0_dp, trial%stiffness(m))
         call dice%decades(-2.5_dp, 0.0_dp, trial%times(m))
      end do
      call dice%decades(0.0_dp, 1.0_dp, decay)
      trial%stiffness = trial%stiffness*(decay/sum(trial%stiffness))
      call dice%decades(-2.0_dp, 0.0_dp, trial%stress)
      call dice%decades(-2.0_dp, -0.5_dp, trial%range)
      trial%edge = 1 + mod(number, 3)
      trial%is_approach = mod(number/3, 2) == 0
      if (mod(number, 10) == 0) trial%stress = 0
      call dice%between(-0.3_dp, 1.0_dp, depth)
   end subroutine draw_case

   !> Judge load and friction of a case.
   subroutine judge_case(trial, depth, load, friction, verdict, difference)
      type(stepping_case_t), intent(in) :: trial
      real(dp), intent(in) :: depth, load, friction
      !> Receives one of `verdict_...`.
      integer, intent(out) :: verdict
      !> Receives the last difference over the size of stresses.
      real(dp), intent(out) :: difference
      type(height_line_t) :: line
      type(brute_column_t) :: column
      type(brute_forces_t) :: forces
      real(dp) :: lowest, highest
      integer :: k, piece

      call new_cosine_line(line, trial%amplitudes, trial%phases)
      call line%get_extremes(lowest, highest, piece)
      verdict = verdict_wrong
      do k = 0, most_refinements
         call new_brute_column(column, trial, depth, highest, first_steps*4**k)
         call settle(column, most_periods, forces)
         difference = max(abs(forces%load - load), abs(forces%friction - friction))/(1 + trial%stress)
         if (.not. forces%is_steady) verdict = verdict_open
         if (forces%is_steady) verdict = merge(verdict_right, verdict_wrong, difference <= agreement)
         if (verdict == verdict_right) return
      end do
   end subroutine judge_case

   !> A case in words.
   subroutine words_of_case(number, trial, depth, words)
      integer, intent(in) :: number
      type(stepping_case_t), intent(in) :: trial
      real(dp), intent(in) :: depth
      character(*), intent(out) :: words

      write (words, '(a, i0, a, i0, a, i0, a, 3es12.4, a, i0, l2)') 'case ', number, ' of ', size(trial%amplitudes), ' waves, ', &
         size(trial%times), ' times; p0, d0, D =', trial%stress, trial%range, depth, '; edge, approach: ', trial%edge, &
         trial%is_approach
   end subroutine words_of_case

end module stepping_judge

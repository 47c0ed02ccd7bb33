! SPDX-License-Identifier: GPL-3.0-or-later
!> Random rough surfaces that adhere: heights, law, loads. E* is 1 and the period along x is 1.
module adhesion_trials
   use adfric_base_kinds, only: dp
   use plain_periodic, only: stiff_pressure
   use random_dice, only: dice_t
   implicit none (type, external)
   private
   public :: adhesion_trial_t, draw_trial, words_of_trial

   real(dp), parameter :: two_pi = 6.283185307179586476925286766559_dp

   !> A surface, its law, and two loads.
   type :: adhesion_trial_t
      !> Gap of the undeformed surfaces, 0 at first touch; of the quarter if it is one.
      real(dp), allocatable :: shape(:, :)
      !> Period along x and y.
      real(dp) :: period(2) = 1
      !> Is it a quarter between mirrors?
      logical :: is_quarter = .false.
      !> Tension and range of the law.
      real(dp) :: stress = 0, range = 0
      !> Mean pressure, a higher one, and one from which the load falls.
      real(dp) :: load = 0, more_load = 0, turn = 0
      !> Pressure of full contact on the cells.
      real(dp) :: full_pressure = 0
      !> Waves along the shortest period, and exponent of their amplitudes.
      integer :: n_waves = 1
      real(dp) :: exponent = 1
   end type adhesion_trial_t

contains

   !> Draw a trial. Near: zones of 0.4 to 100 cells and a stress next to the pressure of full contact; else stress and range are 1e-12
   !> to 1e12 of that pressure and of the height.
   subroutine draw_trial(dice, is_near, most_cells, trial)
      type(dice_t), intent(inout) :: dice
      logical, intent(in) :: is_near
      !> Cells along a side, at most: 16, 20, 24, 32, 48 or 64 and more on lines.
      integer, intent(in) :: most_cells
      type(adhesion_trial_t), intent(out) :: trial
      real(dp) :: height, unit

      call draw_shape(dice, most_cells, trial)
      ! a unit of length for heights
      call dice%decades(-9.0_dp, 9.0_dp, unit)
      trial%shape(:, :) = unit*trial%shape
      height = maxval(trial%shape)
      trial%full_pressure = maxval(stiff_pressure(trial%shape, trial%period, trial%is_quarter))
      if (is_near) then
         call dice%decades(-2.0_dp, 0.7_dp, trial%stress)
         call dice%decades(-0.4_dp, 2.0_dp, trial%range)
         associate (cells => size(trial%shape, 1)*merge(2, 1, trial%is_quarter)/trial%period(1))
            trial%range = trial%range*8/two_pi*(trial%stress*trial%full_pressure/height)/cells
         end associate
      else
         call dice%decades(-12.0_dp, 12.0_dp, trial%stress)
         call dice%decades(-12.0_dp, 12.0_dp, trial%range)
      end if
      trial%stress = trial%stress*trial%full_pressure
      trial%range = trial%range*height
      call draw_loads(dice, trial)
   end subroutine draw_trial

   !> Waves of random phases, heights 0 to 1.
   subroutine draw_shape(dice, most_cells, trial)
      type(dice_t), intent(inout) :: dice
      integer, intent(in) :: most_cells
      type(adhesion_trial_t), intent(inout) :: trial
      integer, parameter :: sides(*) = [16, 20, 24, 32, 48, 64]
      integer :: n(2), which
      logical :: is_line, is_long, is_quarter
      real(dp) :: waves

      call dice%choose(count(sides <= most_cells), which)
      n = sides(which)
      call dice%happens(0.25_dp, is_line)
      call dice%happens(0.2_dp, is_long)
      call dice%happens(0.15_dp, is_quarter)
      if (is_line) then
         n = [2*n(1), 1]
      else if (is_quarter) then
         trial%is_quarter = .true.
         n = n/2
      else if (is_long) then
         n(2) = max(16, n(2)/2)
         trial%period(2) = real(n(2), dp)/n(1)
      end if
      call dice%between(0.4_dp, 2.2_dp, trial%exponent)
      call dice%decades(0.0_dp, log10(real(n(1), dp)/2.01_dp), waves)
      trial%n_waves = int(waves)
      allocate (trial%shape(n(1), n(2)))
      call add_waves(dice, trial)
      trial%shape(:, :) = trial%shape - minval(trial%shape)
      trial%shape(:, :) = trial%shape/maxval(trial%shape)
   end subroutine draw_shape

   !> Add up waves; even ones in a quarter.
   subroutine add_waves(dice, trial)
      type(dice_t), intent(inout) :: dice
      type(adhesion_trial_t), intent(inout) :: trial
      real(dp) :: phase, size_of, weight
      integer :: i, j, k, l, n(2)

      n = shape(trial%shape)
      trial%shape(:, :) = 0
      do l = merge(0, -trial%n_waves, trial%is_quarter), trial%n_waves
         if (n(2) == 1 .and. l /= 0) cycle
         do k = 0, trial%n_waves
            size_of = hypot(real(k, dp), l/trial%period(2))
            if (.not. size_of > 0 .or. abs(2*l) >= max(2, n(2))*merge(2, 1, trial%is_quarter)) cycle
            call dice%between(0.0_dp, 1.0_dp, phase)
            weight = size_of**(-trial%exponent)
            do j = 1, n(2)
               do i = 1, n(1)
                  trial%shape(i, j) = trial%shape(i, j) + weight*wave(i, j)
               end do
            end do
         end do
      end do

   contains

      real(dp) function wave(i, j)
         integer, intent(in) :: i, j

         if (trial%is_quarter) then
            wave = (2*phase - 1)*cos(two_pi/2*k*(i - 0.5_dp)/n(1))*cos(two_pi/2*l*(j - 0.5_dp)/n(2))
         else
            wave = cos(two_pi*(real(k*i, dp)/n(1) + real(l*j, dp)/n(2) + phase))
         end if
      end function wave

   end subroutine add_waves

   !> Loads from pull to full contact.
   subroutine draw_loads(dice, trial)
      type(dice_t), intent(inout) :: dice
      type(adhesion_trial_t), intent(inout) :: trial
      real(dp) :: part
      integer :: which

      call dice%choose(8, which)
      select case (which)
      case (1)
         trial%load = 0
      case (2, 3, 4)
         call dice%decades(-3.0_dp, 0.01_dp, part)
         trial%load = -part*trial%stress
      case default
         call dice%decades(-4.0_dp, 0.3_dp, part)
         trial%load = part*trial%full_pressure
      end select
      call dice%decades(-3.0_dp, 0.0_dp, part)
      trial%more_load = trial%load + part*max(abs(trial%load), trial%full_pressure)
      call dice%decades(-4.0_dp, 0.0_dp, part)
      trial%turn = max(trial%load, 0.0_dp) + part*trial%full_pressure
   end subroutine draw_loads

   !> A trial in a line.
   subroutine words_of_trial(k, trial, words)
      !> Number of the trial.
      integer, intent(in) :: k
      type(adhesion_trial_t), intent(in) :: trial
      character(*), intent(out) :: words

      write (words, '(a, i0, a, 2(i0, 1x), l1, a, i0, f5.2, a, 5es24.16)') 'trial ', k, ': cells ', shape(trial%shape), &
         & trial%is_quarter, ' waves ', trial%n_waves, trial%exponent, ' stress, range, load, more, turn over p* and height', &
         & trial%stress/trial%full_pressure, trial%range/maxval(trial%shape), &
         & [trial%load, trial%more_load, trial%turn]/trial%full_pressure
   end subroutine words_of_trial

end module adhesion_trials

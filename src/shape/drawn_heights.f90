! SPDX-License-Identifier: GPL-3.0-or-later
!> A Gaussian surface of a power spectrum, drawn by a seed: the sum of the waves of a period l_x by l_y,
!>
!>     z(x, y) = sum a_m cos(q_m r + phi_m),   q_m = 2 pi (m_x/l_x, m_y/l_y),   a_m = sqrt(4 C(q_m) A ln(1/u_m)),   phi_m = 2 pi v_m
!>
!> over half of the plane, m_x > 0, or m_x = 0 and m_y > 0, with A = (2 pi)^2/(l_x l_y). Real and imaginary part of a wave are
!> independent and Gaussian, as the theories of rough contact suppose: <a_m^2> = 4 C A, and <z^2> = 2 sum C A, the integral of C
!> over all wave numbers where the period has many waves. The numbers u_m and v_m of a wave follow from seed, m_x and m_y alone.
!> So a wave of a seed is the same whatever the cells, and whichever other waves the spectrum has. The mean height is 0.
module adfric_shape_drawn_heights
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_base_constants, only: pi, two_pi
   use adfric_base_error, only: error_t, file_failure, set_error
   use adfric_base_kinds, only: dp
   use adfric_numerics_counted_numbers, only: counted_uniforms
   use adfric_numerics_wave_sum, only: sum_waves
   use adfric_shape_height_spectrum, only: height_spectrum_t
   implicit none (type, external)
   private
   public :: draw_heights, wave_of_seed, waves_along, can_hold, has_longest

   !> Relative round-off of a wave number at an end of the spectrum, whose wave belongs to it.
   real(dp), parameter :: round_off = 1.0e-9_dp

contains

   !> Factor sqrt(2 ln(1/u)) exp(i phi) of a wave: mean square 2.
   pure complex(dp) function wave_of_seed(seed, mx, my) result(wave)
      !> The seed.
      integer, intent(in) :: seed
      !> Numbers of waves in the period along x, >= 0, and along y; > 0 where that along x is 0.
      integer, intent(in) :: mx, my
      real(dp) :: numbers(2)

      numbers = counted_uniforms([mx, my], seed)
      wave = sqrt(-2*log(numbers(1)))*exp(cmplx(0.0_dp, two_pi*numbers(2), dp))
   end function wave_of_seed

   !> The heights in the middles of equal cells, the first of which begins at x = 0 and y = 0.
   subroutine draw_heights(spectrum, seed, period, heights, error)
      !> The spectrum; its shortest wave is longer than two cells.
      type(height_spectrum_t), intent(in) :: spectrum
      !> The seed.
      integer, intent(in) :: seed
      !> Periods along x and y [m].
      real(dp), intent(in) :: period(2)
      !> Receives the heights [m]; shape `(nx, ny)`.
      real(dp), intent(out) :: heights(:, :)
      !> Allocated if there is no memory.
      type(error_t), allocatable, intent(out) :: error
      complex(dp), allocatable :: waves(:, :)
      complex(dp) :: wave
      integer :: n(2), most(2), mx, my, failure

      n = shape(heights)
      most = int(waves_along(spectrum, period)*(1 + round_off))
      if (has_asserts) call assert(can_hold(spectrum, period, n), 'draw_heights: more than two cells in a wave')
      allocate (waves(0:n(1)/2, 0:n(2) - 1), stat=failure)
      if (failure /= 0) then
         heights = 0
         call set_error(error, file_failure, 'there is no memory for the waves of a surface')
         return
      end if
      waves = 0
      do my = -most(2), most(2)
         do mx = 0, most(1)
            if (mx == 0 .and. my <= 0) cycle
            wave = amplitude(spectrum, period, mx, my)*wave_of_seed(seed, mx, my)/2 &
               & *exp(cmplx(0.0_dp, pi*(real(mx, dp)/n(1) + real(my, dp)/n(2)), dp))
            waves(mx, modulo(my, n(2))) = wave
            if (mx == 0) waves(0, n(2) - my) = conjg(wave)
         end do
      end do
      call sum_waves(waves, heights, error)
   end subroutine draw_heights

   !> Root of the mean square of a wave, sqrt(2 C A) [m]; 0 outside of the spectrum.
   pure real(dp) function amplitude(spectrum, period, mx, my)
      type(height_spectrum_t), intent(in) :: spectrum
      real(dp), intent(in) :: period(2)
      !> Numbers of waves in the period along x and y.
      integer, intent(in) :: mx, my
      real(dp) :: q

      q = two_pi*hypot(mx/period(1), my/period(2))
      associate (first => spectrum%q(0), last => spectrum%q(size(spectrum%power)))
         if (abs(q - first) < round_off*first) q = first
         if (abs(q - last) < round_off*last) q = last
      end associate
      amplitude = two_pi*sqrt(2*spectrum%density_at(q)/period(1)/period(2))
   end function amplitude

   !> How many of the shortest waves the periods have along x and y [-].
   pure function waves_along(spectrum, period) result(n_waves)
      !> The spectrum.
      type(height_spectrum_t), intent(in) :: spectrum
      !> Periods along x and y [m].
      real(dp), intent(in) :: period(2)
      real(dp) :: n_waves(2)

      n_waves = period*(spectrum%q(size(spectrum%power))/two_pi)
   end function waves_along

   !> Can cells have the waves of a spectrum? Each has more than two cells then.
   pure logical function can_hold(spectrum, period, n_cells)
      !> The spectrum.
      type(height_spectrum_t), intent(in) :: spectrum
      !> Periods along x and y [m].
      real(dp), intent(in) :: period(2)
      !> Numbers of cells along x and y.
      integer, intent(in) :: n_cells(2)

      can_hold = all(2*waves_along(spectrum, period)*(1 + 2*round_off) < n_cells)
   end function can_hold

   !> Has a period the longest wave of a spectrum, along x and along y?
   pure logical function has_longest(spectrum, period)
      !> The spectrum.
      type(height_spectrum_t), intent(in) :: spectrum
      !> Periods along x and y [m].
      real(dp), intent(in) :: period(2)

      has_longest = all(period*spectrum%longest > two_pi*(1 - round_off))
   end function has_longest

end module adfric_shape_drawn_heights

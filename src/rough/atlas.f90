! SPDX-License-Identifier: GPL-3.0-or-later
!> How far Persson's theory has been off: least and largest ratio of a theory over the numerical answer of `surface_elastic`, for
!> twelve self-affine spectra at nine pressures.
!>
!> The spectra had Hurst exponents 0.3, 0.5 and 0.8, shortest waves of 1/64 to 1 of the roll-off, and Nayak's parameters from 1.5
!> to 118. They were solved on 512 by 512 cells with 8 seeds each; 1024 cells change the area by 2 % at most, the gap by 0.3 %.
!> Nothing is said outside of this range.
module adfric_rough_atlas
   use adfric_base_kinds, only: dp
   use adfric_base_text, only: newline
   use adfric_base_words, only: pad
   use adfric_shape_height_spectrum, only: height_spectrum_t
   use adfric_rough_variables, only: n_shares, share_yang_persson, suffixes
   implicit none (type, external)
   private
   public :: describe_bands, compared_constant, find_band, quantity_area, quantity_gap, quantity_stiffness

   !> Quantities that were compared.
   integer, parameter :: quantity_area = 1, quantity_gap = 2, quantity_stiffness = 3, n_quantities = 3
   character(*), parameter :: names(n_quantities) = [character(16) :: 'contact_fraction', 'mean_gap', 'normal_stiffness']

   !> Pressures p/(E g) at which theories were compared.
   integer, parameter :: n_pressures = 9
   real(dp), parameter :: pressures(n_pressures) = [0.003_dp, 0.01_dp, 0.02_dp, 0.05_dp, 0.1_dp, 0.2_dp, 0.4_dp, 0.8_dp, 1.2_dp]
   !> A pressure that is so near to one of them is that one.
   real(dp), parameter :: same = 1.0e-6_dp
   !> Least and largest Nayak's parameter.
   real(dp), parameter :: least_nayak = 1.5_dp, largest_nayak = 118
   !> Yang and Persson's constant that was compared.
   real(dp), parameter :: compared_constant = 0.45_dp
   !> Ratios of the theories, `persson`, `yang_persson`, `wang_mueser`: of the area, then of the gap, then of the stiffness.
   real(dp), parameter :: least_ratios(n_pressures, n_shares, n_quantities) = reshape([ &
      & 0.6569_dp, 0.6561_dp, 0.6673_dp, 0.6893_dp, 0.7292_dp, 0.794_dp, 0.8849_dp, 0.9723_dp, 0.9958_dp, &
      & 0.9789_dp, 0.9756_dp, 0.9869_dp, 0.9941_dp, 0.9977_dp, 0.9832_dp, 0.9638_dp, 0.9793_dp, 0.996_dp, &
      & 0.8813_dp, 0.8805_dp, 0.8961_dp, 0.9265_dp, 0.9741_dp, 1.015_dp, 1.002_dp, 0.985_dp, 0.9962_dp, &
      & 1.571_dp, 1.388_dp, 1.256_dp, 1.025_dp, 0.8539_dp, 0.6493_dp, 0.4376_dp, 0.2564_dp, 0.1691_dp, &
      & 0.9602_dp, 0.9597_dp, 0.9674_dp, 0.988_dp, 0.9653_dp, 0.9201_dp, 0.7604_dp, 0.5145_dp, 0.3528_dp, &
      & 1.003_dp, 0.9599_dp, 0.9375_dp, 0.917_dp, 0.9274_dp, 0.9329_dp, 0.9418_dp, 0.7438_dp, 0.5364_dp, &
      & 0.311_dp, 0.4287_dp, 0.489_dp, 0.5926_dp, 0.721_dp, 0.9027_dp, 1.248_dp, 2.003_dp, 2.875_dp, &
      & 0.6668_dp, 0.7789_dp, 0.8043_dp, 0.8764_dp, 0.8865_dp, 0.9194_dp, 0.9254_dp, 1.053_dp, 1.388_dp, &
      & 0.5577_dp, 0.7347_dp, 0.8318_dp, 0.9266_dp, 1.019_dp, 0.9515_dp, 0.9603_dp, 0.7821_dp, 0.922_dp], &
      & [n_pressures, n_shares, n_quantities])
   real(dp), parameter :: largest_ratios(n_pressures, n_shares, n_quantities) = reshape([ &
      & 0.7604_dp, 0.77_dp, 0.7834_dp, 0.793_dp, 0.8194_dp, 0.8645_dp, 0.918_dp, 0.9785_dp, 0.9972_dp, &
      & 1.133_dp, 1.145_dp, 1.159_dp, 1.144_dp, 1.121_dp, 1.071_dp, 0.9999_dp, 0.9855_dp, 0.9974_dp, &
      & 1.02_dp, 1.033_dp, 1.052_dp, 1.066_dp, 1.095_dp, 1.105_dp, 1.039_dp, 0.9912_dp, 0.9976_dp, &
      & 1.76_dp, 1.509_dp, 1.373_dp, 1.17_dp, 1.02_dp, 0.8438_dp, 0.6422_dp, 0.4257_dp, 0.2849_dp, &
      & 1.175_dp, 1.135_dp, 1.095_dp, 1.067_dp, 1.038_dp, 1.042_dp, 1.026_dp, 0.8436_dp, 0.5937_dp, &
      & 1.181_dp, 1.086_dp, 1.04_dp, 0.9861_dp, 1.006_dp, 1.028_dp, 1.158_dp, 1.199_dp, 0.9012_dp, &
      & 0.4608_dp, 0.5048_dp, 0.5575_dp, 0.7241_dp, 0.8899_dp, 1.191_dp, 1.774_dp, 3.285_dp, 5.007_dp, &
      & 1.009_dp, 1.068_dp, 1.101_dp, 1.084_dp, 1.058_dp, 1.03_dp, 1.102_dp, 1.68_dp, 2.412_dp, &
      & 0.8282_dp, 0.904_dp, 0.9717_dp, 1.062_dp, 1.172_dp, 1.194_dp, 1.052_dp, 1.202_dp, 1.596_dp], &
      & [n_pressures, n_shares, n_quantities])

contains

   !> Least and largest ratio of a theory over the exact answer, at the measured pressures on both sides.
   pure subroutine find_band(quantity, share, pressure, nayak, least, largest, is_known)
      !> One of `quantity_...`, and number of the form of the theory.
      integer, intent(in) :: quantity, share
      !> p/(E g), and Nayak's parameter.
      real(dp), intent(in) :: pressure, nayak
      real(dp), intent(out) :: least, largest
      !> Has it been measured there?
      logical, intent(out) :: is_known
      integer :: k, last

      least = 1
      largest = 1
      is_known = pressure >= pressures(1)*(1 - same) .and. pressure <= pressures(n_pressures)*(1 + same) &
         & .and. nayak >= least_nayak .and. nayak <= largest_nayak
      if (.not. is_known) return
      k = max(1, count(pressures <= pressure*(1 + same)))
      last = min(n_pressures, k + 1)
      if (abs(pressure - pressures(k)) <= same*pressure) last = k
      least = minval(least_ratios(k:last, share, quantity))
      largest = maxval(largest_ratios(k:last, share, quantity))
   end subroutine find_band

   !> What `adfric check` says of a pressure: the ratios, and what they are within.
   function describe_bands(spectrum, pressure, constant) result(text)
      type(height_spectrum_t), intent(in) :: spectrum
      !> p/(E g).
      real(dp), intent(in) :: pressure
      !> Yang and Persson's constant; nothing is known of another one than `compared_constant`.
      real(dp), intent(in) :: constant
      character(:), allocatable :: text
      integer, parameter :: column = 34
      character(12) :: numbers(2)
      real(dp) :: least, largest
      logical :: is_known
      integer :: quantity, share

      call find_band(quantity_area, 1, pressure, spectrum%nayak_parameter(), least, largest, is_known)
      write (numbers(1), '(es9.2)') pressure
      if (.not. is_known) then
         text = 'p/(E g) ='//numbers(1)//': theories were compared with surface_elastic for p/(E g) from 0.003 to 1.2 '// &
            & 'and Nayak''s parameter from 1.5 to 118 alone'//newline
         return
      end if
      text = 'ratio to surface_elastic at p/(E g) ='//trim(numbers(1))//', of 12 self-affine spectra:'//newline
      do quantity = 1, n_quantities
         do share = 1, n_shares
            if (share == share_yang_persson .and. abs(constant - compared_constant) > same) cycle
            call find_band(quantity, share, pressure, spectrum%nayak_parameter(), least, largest, is_known)
            write (numbers, '(f4.2)') least, largest
            text = text//pad('  '//trim(names(quantity))//'_'//trim(suffixes(share)), column)//trim(numbers(1))//' to '// &
               & trim(numbers(2))//within(max(1 - least, largest - 1))//newline
         end do
      end do
   end function describe_bands

   !> What an error is within.
   pure function within(error) result(text)
      real(dp), intent(in) :: error
      character(:), allocatable :: text

      text = ''
      if (error <= 0.3_dp) text = ', within 30 %'
      if (error <= 0.1_dp) text = ', within 10 %'
      if (error <= 0.05_dp) text = ', within 5 %'
   end function within

end module adfric_rough_atlas

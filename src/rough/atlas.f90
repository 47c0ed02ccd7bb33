! SPDX-License-Identifier: GPL-3.0-or-later
!> How far Persson's theory has been off: least and largest ratio of a theory over the numerical answer of `surface_elastic`, for
!> twelve self-affine spectra at nine pressures, as the benchmark `theories` measures them.
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
   public :: describe_bands, describe_atlas, compared_constant, find_band, quantity_area, quantity_gap, quantity_stiffness

   !> Quantities that were compared.
   integer, parameter :: quantity_area = 1, quantity_gap = 2, quantity_stiffness = 3, n_quantities = 3
   character(*), parameter :: names(n_quantities) = [character(16) :: 'contact_fraction', 'mean_gap', 'normal_stiffness']

   !> Pressures p/(E g) at which theories were compared.
   integer, parameter :: n_pressures = 9
   real(dp), parameter :: pressures(n_pressures) = [0.003_dp, 0.01_dp, 0.02_dp, 0.05_dp, 0.1_dp, 0.2_dp, 0.4_dp, 0.8_dp, 1.2_dp]
   !> Columns of texts: names with theories, and names alone.
   integer, parameter :: column_of_bands = 34, column_of_names = 20
   !> A theory with a larger error does not do.
   real(dp), parameter :: worst_that_would_do = 0.3_dp
   !> A pressure that is so near to one of them is that one.
   real(dp), parameter :: same = 1.0e-6_dp
   !> Least and largest Nayak's parameter.
   real(dp), parameter :: least_nayak = 1.5_dp, largest_nayak = 118
   !> Yang and Persson's constant that was compared.
   real(dp), parameter :: compared_constant = 0.45_dp
   !> Ratios of the theories, `persson`, `yang_persson`, `wang_mueser`: of the area, then of the gap, then of the stiffness.
   real(dp), parameter :: least_ratios(n_pressures, n_shares, n_quantities) = reshape([ &
      & 0.6458_dp, 0.6559_dp, 0.6644_dp, 0.6896_dp, 0.7314_dp, 0.7954_dp, 0.8832_dp, 0.9735_dp, 0.9952_dp, &
      & 0.9624_dp, 0.9753_dp, 0.9826_dp, 0.9946_dp, 1.001_dp, 0.9849_dp, 0.962_dp, 0.9805_dp, 0.9954_dp, &
      & 0.8665_dp, 0.8802_dp, 0.8922_dp, 0.9269_dp, 0.9769_dp, 1.017_dp, 1.0_dp, 0.9862_dp, 0.9956_dp, &
      & 1.555_dp, 1.299_dp, 1.172_dp, 1.024_dp, 0.8637_dp, 0.6948_dp, 0.4763_dp, 0.3037_dp, 0.232_dp, &
      & 0.9611_dp, 0.9568_dp, 0.9629_dp, 0.9856_dp, 0.9727_dp, 0.9281_dp, 0.8277_dp, 0.6096_dp, 0.4836_dp, &
      & 1.004_dp, 0.9236_dp, 0.9014_dp, 0.9149_dp, 0.9251_dp, 0.941_dp, 1.007_dp, 0.8813_dp, 0.7346_dp, &
      & 0.2984_dp, 0.432_dp, 0.494_dp, 0.5978_dp, 0.7241_dp, 0.9052_dp, 1.242_dp, 2.036_dp, 2.738_dp, &
      & 0.6398_dp, 0.8137_dp, 0.8405_dp, 0.8762_dp, 0.9116_dp, 0.888_dp, 0.9207_dp, 1.07_dp, 1.322_dp, &
      & 0.5351_dp, 0.7461_dp, 0.8367_dp, 0.9263_dp, 1.026_dp, 0.9077_dp, 0.8931_dp, 0.795_dp, 0.8784_dp], &
      & [n_pressures, n_shares, n_quantities])
   real(dp), parameter :: largest_ratios(n_pressures, n_shares, n_quantities) = reshape([ &
      & 0.7279_dp, 0.7619_dp, 0.7805_dp, 0.8168_dp, 0.8474_dp, 0.8786_dp, 0.9206_dp, 0.9763_dp, 0.9961_dp, &
      & 1.085_dp, 1.133_dp, 1.154_dp, 1.178_dp, 1.159_dp, 1.088_dp, 1.003_dp, 0.9833_dp, 0.9963_dp, &
      & 0.9766_dp, 1.023_dp, 1.048_dp, 1.098_dp, 1.132_dp, 1.123_dp, 1.042_dp, 0.989_dp, 0.9965_dp, &
      & 1.746_dp, 1.5_dp, 1.365_dp, 1.167_dp, 1.017_dp, 0.8442_dp, 0.6408_dp, 0.4294_dp, 0.3497_dp, &
      & 1.147_dp, 1.106_dp, 1.086_dp, 1.049_dp, 1.073_dp, 1.042_dp, 1.024_dp, 0.8508_dp, 0.7287_dp, &
      & 1.159_dp, 1.064_dp, 1.033_dp, 0.9757_dp, 1.044_dp, 1.099_dp, 1.156_dp, 1.209_dp, 1.106_dp, &
      & 0.4452_dp, 0.5076_dp, 0.5959_dp, 0.7614_dp, 0.8892_dp, 1.136_dp, 1.65_dp, 2.817_dp, 3.755_dp, &
      & 0.9746_dp, 1.063_dp, 1.094_dp, 1.088_dp, 1.061_dp, 1.022_dp, 1.075_dp, 1.441_dp, 1.81_dp, &
      & 0.8002_dp, 0.9002_dp, 1.035_dp, 1.192_dp, 1.176_dp, 1.198_dp, 1.048_dp, 1.031_dp, 1.199_dp], &
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
      character(12) :: numbers(2)
      real(dp) :: least, largest
      logical :: is_known
      integer :: quantity, share

      call find_band(quantity_area, 1, pressure, spectrum%nayak_parameter(), least, largest, is_known)
      write (numbers(1), '(es9.2)') pressure
      if (.not. is_known) then
         text = 'p/(E g) ='//numbers(1)//': theories were compared with contact on cells for p/(E g) from 0.003 to 1.2 '// &
            & 'and Nayak''s parameter from 1.5 to 118 alone'//newline
         return
      end if
      text = 'ratio to contact on cells at p/(E g) ='//trim(numbers(1))//', of 12 self-affine spectra:'//newline
      do quantity = 1, n_quantities
         do share = 1, n_shares
            if (share == share_yang_persson .and. abs(constant - compared_constant) > same) cycle
            call find_band(quantity, share, pressure, spectrum%nayak_parameter(), least, largest, is_known)
            write (numbers, '(f4.2)') least, largest
            text = text//pad('  '//trim(names(quantity))//'_'//trim(suffixes(share)), column_of_bands)//trim(numbers(1))//' to '// &
               & trim(numbers(2))//within(max(1 - least, largest - 1))//newline
         end do
      end do
      text = text//'which would do:'//newline
      do quantity = 1, n_quantities
         text = text//recommend(quantity, pressure, spectrum%nayak_parameter(), constant)
      end do
   end function describe_bands

   !> The form whose ratios are nearest to 1 at a pressure, and what it is within; none within 30 % is none that would do.
   function recommend(quantity, pressure, nayak, constant) result(text)
      !> One of `quantity_...`.
      integer, intent(in) :: quantity
      !> p/(E g), Nayak's parameter, and Yang and Persson's constant.
      real(dp), intent(in) :: pressure, nayak, constant
      character(:), allocatable :: text
      real(dp) :: least, largest, error, smallest
      logical :: is_known
      integer :: share, best

      smallest = worst_that_would_do
      best = 0
      do share = 1, n_shares
         if (share == share_yang_persson .and. abs(constant - compared_constant) > same) cycle
         call find_band(quantity, share, pressure, nayak, least, largest, is_known)
         error = max(1 - least, largest - 1)
         if (.not. is_known .or. error > smallest) cycle
         smallest = error
         best = share
      end do
      if (best == 0) then
         text = '  '//pad(trim(names(quantity)), column_of_names)//'none within 30 %'//newline
      else
         text = '  '//pad(trim(names(quantity)), column_of_names)//trim(suffixes(best))//within(smallest)//newline
      end if
   end function recommend

   !> What `adfric help theories` says: the largest error of each form at each pressure.
   function describe_atlas() result(text)
      character(:), allocatable :: text
      character(6) :: cell
      real(dp) :: least, largest
      logical :: is_known
      integer :: quantity, share, k

      text = pad('p/(E g)', column_of_bands)
      do k = 1, n_pressures
         write (cell, '(f6.3)') pressures(k)
         if (pressures(k) >= 0.01_dp) write (cell, '(f6.2)') pressures(k)
         text = text//cell
      end do
      text = text//newline
      do quantity = 1, n_quantities
         do share = 1, n_shares
            text = text//pad(trim(names(quantity))//'_'//trim(suffixes(share)), column_of_bands)
            do k = 1, n_pressures
               call find_band(quantity, share, pressures(k), least_nayak, least, largest, is_known)
               write (cell, '(i6)') ceiling(100*max(1 - least, largest - 1))
               text = text//cell
            end do
            text = text//newline
         end do
      end do
   end function describe_atlas

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

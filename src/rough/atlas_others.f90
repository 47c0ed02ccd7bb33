! SPDX-License-Identifier: GPL-3.0-or-later
!> How far theories of rough contact have been off where surfaces part or slide, by the benchmark `theories`: two self-affine
!> spectra with Hurst exponents 0.3 and 0.8, 16 seeds each where they part, 8 where they slide.
module adfric_rough_atlas_others
   use adfric_base_kinds, only: dp
   use adfric_base_text, only: newline
   implicit none (type, external)
   private
   public :: describe_parting, describe_sliding

   !> Tension over E g and range over the root mean square height of the parting surfaces.
   integer, parameter :: n_pairs = 5
   real(dp), parameter :: pairs(2, n_pairs) = reshape([0.1_dp, 0.5_dp, 0.2_dp, 0.5_dp, 0.3_dp, 0.7_dp, &
      & 0.2_dp, 1.0_dp, 0.4_dp, 1.0_dp], [2, n_pairs])
   !> Pull-off of cells over the tension, mean of both spectra; least and largest ratio of `yang_persson`, then of `wang_mueser`.
   real(dp), parameter :: pull_offs(n_pairs) = [0.00935_dp, 0.0301_dp, 0.135_dp, 0.199_dp, 0.302_dp]
   real(dp), parameter :: pull_off_ratios(4, n_pairs) = reshape([ &
      & 0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, &
      & 0.484_dp, 0.539_dp, 0.52_dp, 0.557_dp, &
      & 0.637_dp, 0.65_dp, 0.718_dp, 0.727_dp, &
      & 0.76_dp, 0.774_dp, 0.83_dp, 0.839_dp, &
      & 0.726_dp, 0.73_dp, 0.773_dp, 0.777_dp], &
      & [4, n_pairs])
   !> Loads p/(E0 g) and speeds q V t of sliding surfaces, q of the longest wave.
   integer, parameter :: n_loads = 2, n_speeds = 5
   real(dp), parameter :: loads(n_loads) = [0.05_dp, 0.3_dp], speeds(n_speeds) = [0.002_dp, 0.02_dp, 0.1_dp, 0.3_dp, 1.0_dp]
   !> Least and largest ratio of the friction by `yang_persson`, for both spectra.
   real(dp), parameter :: friction_ratios(2, n_speeds, n_loads) = reshape([ &
      & 0.42_dp, 0.457_dp, 0.517_dp, 0.607_dp, 0.85_dp, 1.01_dp, 1.17_dp, 1.29_dp, 1.55_dp, 1.62_dp, &
      & 0.667_dp, 0.715_dp, 0.722_dp, 0.783_dp, 0.863_dp, 0.955_dp, 0.991_dp, 1.1_dp, 1.15_dp, 1.22_dp], &
      & [2, n_speeds, n_loads])

contains

   !> Lines of `adfric help theories` on pull-off.
   function describe_parting() result(text)
      character(:), allocatable :: text
      character(100) :: line
      integer :: k

      text = 'Pull-off of 2 spectra by the bearing area over that of cells; 0: the theory finds no tension.'//newline// &
         & 'p0 is the tension, r its range, h the root mean square height:'//newline//newline// &
         & '  p0/(E g)   r/h   pull-off/p0   yang_persson    wang_mueser'//newline
      do k = 1, n_pairs
         write (line, '(2x,f8.2,f6.1,es14.1,2(3x,f5.2," to ",f4.2))') pairs(:, k), pull_offs(k), pull_off_ratios(:, k)
         text = text//trim(line)//newline
      end do
   end function describe_parting

   !> Lines of `adfric help theories` on sliding.
   function describe_sliding() result(text)
      character(:), allocatable :: text
      character(100) :: line
      integer :: k

      text = 'Friction of 2 spectra on a solid with one arm of 9 E0, yang_persson over surface_sliding;'//newline// &
         & 'q of the longest wave, t the relaxation time:'//newline//newline//'  p/(E0 g)'
      write (line, '(*(:,f10.3,3x))') speeds
      text = text//'   q V t ='//trim(line)//newline
      do k = 1, n_loads
         write (line, '(2x,f8.2,11x,*(:,f5.2," to ",f4.2))') loads(k), friction_ratios(:, :, k)
         text = text//trim(line)//newline
      end do
   end function describe_sliding

end module adfric_rough_atlas_others

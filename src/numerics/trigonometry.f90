!> Differences of angles, sines and cosines that keep their digits where the angle is small.
module adfric_numerics_trigonometry
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: sinc_minus_cos, angle_minus_sine

contains

   !> sin(x)/x - cos x for 0 <= x <= pi.
   elemental real(dp) function sinc_minus_cos(x)
      real(dp), intent(in) :: x
      integer :: k
      real(dp) :: y, term

      if (x >= 1) then
         sinc_minus_cos = sin(x)/x - cos(x)
         return
      end if
      ! sum of (-1)^(k+1) 2k x^(2k)/(2k+1)!
      y = x*x
      term = y/6
      sinc_minus_cos = 0
      do k = 1, 9
         sinc_minus_cos = sinc_minus_cos + 2*k*term
         term = -term*y/((2*k + 2)*(2*k + 3))
      end do
   end function sinc_minus_cos

   !> x - sin x for x >= 0.
   elemental real(dp) function angle_minus_sine(x)
      real(dp), intent(in) :: x
      integer :: k
      real(dp) :: y, term

      if (x >= 1) then
         angle_minus_sine = x - sin(x)
         return
      end if
      y = x*x
      term = x*y/6
      angle_minus_sine = 0
      do k = 1, 9
         angle_minus_sine = angle_minus_sine + term
         term = -term*y/((2*k + 2)*(2*k + 3))
      end do
   end function angle_minus_sine

end module adfric_numerics_trigonometry

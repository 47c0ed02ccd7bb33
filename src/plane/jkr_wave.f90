! SPDX-License-Identifier: GPL-3.0-or-later
!> The limit of an adhesive wave (`adhesive_wave`) for a short range at a prescribed surface energy w (K. L. Johnson, Int. J. Solids
!> Struct. 32 (1995) 423): the pressure is singular at the edge of contact, and only alpha^2 = 2 w l/(pi^2 E* D^2) counts.
!>
!> With theta = pi a, T = tan theta, s = sin theta, pressures in p* = pi E* D/l, heights in D and lengths in l,
!>
!>     P     = s^2 - alpha sqrt(T)
!>     delta = s^2 (1 - 2 ln s) + 2 alpha sqrt(T) ln s
!>
!>     dP/d theta     = 2 T/(1 + T^2) - alpha (1 + T^2)/(2 sqrt(T))
!>     d delta/d theta = -2 ln s dP/d theta + 2 alpha/sqrt(T)
!>
!> The load rises with a where alpha < f(T) = 4 T^(3/2)/(1 + T^2)^2. f rises up to T^2 = 3/5, where it is 1.0652, and falls beyond: so
!> below 1.0652 the load has a minimum, the pull-off of partial contacts, and a maximum, beyond which the wave closes; above, it has
!> neither.
module adfric_plane_jkr_wave
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_numerics_libm, only: log1p
   use adfric_numerics_scalar_root, only: equation_t, find_root
   implicit none (type, external)
   private
   public :: jkr_wave_load, jkr_wave_penetration, jkr_wave_load_slope, jkr_wave_penetration_slope, find_jkr_pull_off

   !> ln T at the largest f.
   real(dp), parameter :: turn = log(0.6_dp)/2

   !> ln f - ln alpha as a function of ln T.
   type, extends(equation_t) :: jkr_fold_equation_t
      !> ln alpha.
      real(dp) :: logarithm = 0
   contains
      procedure :: evaluate
   end type jkr_fold_equation_t

contains

   !> P [p*].
   elemental real(dp) function jkr_wave_load(alpha, half_width) result(load)
      !> alpha, > 0.
      real(dp), intent(in) :: alpha
      !> a [l], > 0, < 1/2.
      real(dp), intent(in) :: half_width

      load = sin(pi*half_width)**2 - alpha*sqrt(tan(pi*half_width))
   end function jkr_wave_load

   !> delta [D].
   elemental real(dp) function jkr_wave_penetration(alpha, half_width) result(penetration)
      !> alpha, > 0.
      real(dp), intent(in) :: alpha
      !> a [l], > 0, < 1/2.
      real(dp), intent(in) :: half_width
      real(dp) :: s, logarithm

      s = sin(pi*half_width)
      logarithm = log(s)
      penetration = s**2*(1 - 2*logarithm) + 2*alpha*sqrt(tan(pi*half_width))*logarithm
   end function jkr_wave_penetration

   !> dP/d theta.
   elemental real(dp) function jkr_wave_load_slope(alpha, half_width) result(slope)
      !> alpha, > 0.
      real(dp), intent(in) :: alpha
      !> a [l], > 0, < 1/2.
      real(dp), intent(in) :: half_width
      real(dp) :: t

      t = tan(pi*half_width)
      slope = 2*t/(1 + t**2) - alpha*(1 + t**2)/(2*sqrt(t))
   end function jkr_wave_load_slope

   !> d delta/d theta.
   elemental real(dp) function jkr_wave_penetration_slope(alpha, half_width) result(slope)
      !> alpha, > 0.
      real(dp), intent(in) :: alpha
      !> a [l], > 0, < 1/2.
      real(dp), intent(in) :: half_width

      slope = -2*log(sin(pi*half_width))*jkr_wave_load_slope(alpha, half_width) + 2*alpha/sqrt(tan(pi*half_width))
   end function jkr_wave_penetration_slope

   !> The contact of the least load, for alpha < 1.0652.
   pure subroutine find_jkr_pull_off(alpha, half_width, load, has_fold)
      !> alpha, > 0.
      real(dp), intent(in) :: alpha
      !> a there [l].
      real(dp), intent(out) :: half_width
      !> The least load [p*].
      real(dp), intent(out) :: load
      logical, intent(out) :: has_fold
      type(jkr_fold_equation_t) :: equation
      real(dp) :: x, value, slope

      half_width = 0
      load = 0
      equation%logarithm = log(alpha)
      call equation%evaluate(turn, value, slope)
      has_fold = value > 0
      if (.not. has_fold) return
      ! f < 4 T^(3/2)
      associate (low => (2.0_dp/3)*(equation%logarithm - log(4.0_dp)))
         x = low
         call find_root(equation, low, turn, .true., x, has_fold)
      end associate
      half_width = atan(exp(x))/pi
      load = jkr_wave_load(alpha, half_width)
   end subroutine find_jkr_pull_off

   !> See `jkr_fold_equation_t`.
   pure subroutine evaluate(self, x, value, slope)
      class(jkr_fold_equation_t), intent(in) :: self
      real(dp), intent(in) :: x
      !> ln f - ln alpha.
      real(dp), intent(out) :: value
      !> Its derivative.
      real(dp), intent(out) :: slope
      real(dp) :: square

      square = exp(2*x)
      value = log(4.0_dp) + 1.5_dp*x - 2*log1p(square) - self%logarithm
      slope = 1.5_dp - 4*square/(1 + square)
   end subroutine evaluate

end module adfric_plane_jkr_wave

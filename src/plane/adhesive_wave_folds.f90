! SPDX-License-Identifier: GPL-3.0-or-later
!> The folds of the load of an adhesive wave (`adhesive_wave`): the least load of a partial contact, and the largest one, beyond
!> which the wave snaps into saturation.
!>
!> With r = exp(-L) = tan alpha/tan gamma and X = T^2, m^2 = (1 - r^2)/(1 + r^2 X), the slope of the load is 0 where
!>
!>     F(L, X) := (1/L) sqrt[(1 - r^2)/(1 + r^2 X)] T/(1 + X) = sigma/2
!>
!> A fold is a minimum where X < X*(L), and a maximum where X > X*(L); (1 + r^2 X*)/(1 + X*) is the positive root of the quadratic
!>
!>     [2 L + (1 - r^2)/r^2] nu^2 + [2 L^2 - 2 L - (1 - r^2)] nu - [L^2 + (1 - r^2) L]
!>
!> For eta < eta*(sigma) the load has one minimum and one maximum, else none (docs/theory/adhesive_wave.md, Proofs). Both are found
!> by following the lines of minima and maxima, with brackets that hold one root. Minima: by T, from the first contact to T*; there
!> F falls with L for L > ln(0.736 X), and L < sin 2 gamma/sigma. Maxima: by ln L, below L*; F falls with X beyond X*.
module adfric_plane_adhesive_wave_folds
   use adfric_base_kinds, only: dp
   use adfric_numerics_scalar_root, only: equation_t, find_root
   use adfric_numerics_secant_root, only: rising_equation_t, find_rising_root
   use adfric_numerics_libm, only: expm1, log1p
   use adfric_plane_adhesive_wave, only: zones_t, get_zones_of_position, range_excess
   implicit none (type, external)
   private
   public :: fold_turn_t, find_fold_turn, find_least_load, find_largest_load

   !> Bounds of ln L of the turning point; sigma is between 1e-80 and 1e100.
   real(dp), parameter :: least_logarithm = -500.0_dp, largest_logarithm = 5.7_dp
   !> Below this L, X* is its linear part 0.6 + 0.4 L.
   real(dp), parameter :: small_log_ratio = 1.0e-4_dp
   !> What the logarithm of two equal numbers may be.
   real(dp), parameter :: round_off = 4*epsilon(1.0_dp)
   !> See the head: F falls with L beyond ln(0.736 X).
   real(dp), parameter :: least_factor = 0.736_dp
   !> Newton steps that are enough from one side.
   integer, parameter :: max_steps = 100

   !> Where minima and maxima of the load meet.
   type :: fold_turn_t
      !> ln L* and ln T*.
      real(dp) :: log_log_ratio = 0, position = 0
      !> eta*, beyond which no partial contact is stable under load.
      real(dp) :: range = 0
   end type fold_turn_t

   !> -ln F along X*(L), which rises with ln L.
   type, extends(rising_equation_t) :: turn_equation_t
      !> ln(sigma/2).
      real(dp) :: logarithm = 0
   contains
      procedure :: evaluate => evaluate_turn
   end type turn_equation_t

   !> ln of the range along one of both lines of folds, which rises with ln T or ln L.
   type, extends(rising_equation_t) :: wave_fold_equation_t
      !> sigma and the range eta.
      real(dp) :: sigma = 1, range = 1
      !> Is it the line of maxima?
      logical :: is_largest = .false.
   contains
      procedure :: evaluate => evaluate_fold
   end type wave_fold_equation_t

   !> ln F - ln(sigma/2) as a function of L.
   type, extends(equation_t) :: log_ratio_equation_t
      !> T^2 and sigma/sin 2 gamma.
      real(dp) :: square = 1, ratio = 1
   contains
      procedure :: evaluate => evaluate_log_ratio
   end type log_ratio_equation_t

contains

   !> Where minima and maxima of the load meet, for a stress.
   pure subroutine find_fold_turn(sigma, turn, is_converged)
      !> sigma = 2 S/pi, > 0.
      real(dp), intent(in) :: sigma
      type(fold_turn_t), intent(out) :: turn
      logical, intent(out) :: is_converged
      type(turn_equation_t) :: equation
      type(zones_t) :: zones
      real(dp) :: x

      equation%logarithm = log(sigma/2)
      ! F^2 tends to 0.293/L at small L and to exp(-L)/L at large L
      x = log(log1p(1.17_dp/sigma**2))
      call find_rising_root(equation, least_logarithm, largest_logarithm, (1 + exp(x))/2, round_off, x, is_converged)
      turn%log_log_ratio = x
      turn%position = log(turn_square(exp(x)))/2
      call get_zones_of_ratio(exp(x), turn%position, zones)
      turn%range = range_excess(sigma, 0.0_dp, zones)
   end subroutine find_fold_turn

   !> The minimum of the load of partial contacts, for eta < eta*.
   pure subroutine find_least_load(sigma, range, turn, first_position, zones, is_converged)
      !> sigma = 2 S/pi, > 0.
      real(dp), intent(in) :: sigma
      !> Range eta, below that of the turning point.
      real(dp), intent(in) :: range
      type(fold_turn_t), intent(in) :: turn
      !> ln T of the first contact.
      real(dp), intent(in) :: first_position
      type(zones_t), intent(out) :: zones
      logical, intent(out) :: is_converged
      type(wave_fold_equation_t) :: equation
      real(dp) :: x

      equation%sigma = sigma
      equation%range = range
      ! short zones: sin^2 gamma of 4 t^3 = alpha^2 in the limit of Johnson, Kendall and Roberts
      x = log(sigma*range/16)/3
      call find_rising_root(equation, min(first_position, turn%position - 1.0e-6_dp), turn%position, 2.0_dp, round_off, x, &
         & is_converged)
      call get_zones_of_ratio(minimum_log_ratio(sigma, x), x, zones)
   end subroutine find_least_load

   !> The maximum of the load of partial contacts, for eta < eta*.
   pure subroutine find_largest_load(sigma, range, turn, zones, is_converged)
      !> sigma = 2 S/pi, > 0.
      real(dp), intent(in) :: sigma
      !> Range eta, below that of the turning point.
      real(dp), intent(in) :: range
      type(fold_turn_t), intent(in) :: turn
      type(zones_t), intent(out) :: zones
      logical, intent(out) :: is_converged
      type(wave_fold_equation_t) :: equation
      real(dp) :: x, low, step, value

      equation = wave_fold_equation_t(sigma, range, .true.)
      step = 2
      low = turn%log_log_ratio - step
      do
         call equation%evaluate(low, value)
         if (.not. value > 0 .or. low < -1.0e3_dp) exit
         step = 2*step
         low = low - step
      end do
      x = low + step/2
      call find_rising_root(equation, low, turn%log_log_ratio, 1.0_dp, round_off, x, is_converged)
      call get_zones_of_ratio(exp(x), maximum_position(sigma, exp(x)), zones)
   end subroutine find_largest_load

   !> Zones of given L and x.
   pure subroutine get_zones_of_ratio(log_ratio, position, zones)
      !> L, > 0.
      real(dp), intent(in) :: log_ratio
      !> x = ln T.
      real(dp), intent(in) :: position
      type(zones_t), intent(out) :: zones
      real(dp) :: m, y, square, r2

      square = exp(2*position)
      r2 = exp(-2*log_ratio)
      m = sqrt(-expm1(-2*log_ratio)/(1 + r2*square))
      if (m < 0.5_dp) then
         y = atanh(m)
      else
         ! 1 - m^2 = r^2 (1 + X)/(1 + r^2 X)
         y = log1p(m) + log_ratio - (log1p(square) - log1p(r2*square))/2
      end if
      call get_zones_of_position(position, y, zones)
   end subroutine get_zones_of_ratio

   !> X*(L), where a minimum turns into a maximum: the root of the quadratic in nu, written in X.
   pure real(dp) function turn_square(log_ratio) result(x)
      !> L, > 0.
      real(dp), intent(in) :: log_ratio
      real(dp) :: r2, e, a, b, c, c0, c1, c2

      if (log_ratio < small_log_ratio) then
         x = 0.6_dp + 0.4_dp*log_ratio
         return
      end if
      associate (l => log_ratio)
         r2 = exp(-2*l)
         e = -expm1(-2*l)
         a = 2*l + e/r2
         b = 2*l*l - 2*l - e
         c = -l*(l + e)
         c0 = l*l - e*l + e*e/r2
         c1 = 2*a*r2 + b*(1 + r2) + 2*c
         c2 = (a*r2 + b)*r2 + c
         x = (-c1 - sqrt(c1*c1 - 4*c2*c0))/(2*c2)
      end associate
   end function turn_square

   !> See `turn_equation_t`.
   pure subroutine evaluate_turn(self, x, value)
      class(turn_equation_t), intent(in) :: self
      !> ln L.
      real(dp), intent(in) :: x
      !> ln(sigma/2) - ln F.
      real(dp), intent(out) :: value
      real(dp) :: l, square, r2

      l = exp(x)
      square = turn_square(l)
      r2 = exp(-2*l)
      value = self%logarithm + x + log1p(square) - (log(square) + log(-expm1(-2*l)) - log1p(r2*square))/2
   end subroutine evaluate_turn

   !> See `wave_fold_equation_t`.
   pure subroutine evaluate_fold(self, x, value)
      class(wave_fold_equation_t), intent(in) :: self
      !> ln T of a minimum, ln L of a maximum.
      real(dp), intent(in) :: x
      !> ln of the range over the one that is wanted.
      real(dp), intent(out) :: value
      type(zones_t) :: zones

      if (self%is_largest) then
         call get_zones_of_ratio(exp(x), maximum_position(self%sigma, exp(x)), zones)
      else
         call get_zones_of_ratio(minimum_log_ratio(self%sigma, x), x, zones)
      end if
      value = log(range_excess(self%sigma, 0.0_dp, zones)/self%range)
   end subroutine evaluate_fold

   !> L of a minimum of the load.
   pure real(dp) function minimum_log_ratio(sigma, position) result(l)
      !> sigma = 2 S/pi, > 0.
      real(dp), intent(in) :: sigma
      !> x = ln T.
      real(dp), intent(in) :: position
      type(log_ratio_equation_t) :: equation
      real(dp) :: low, high
      logical :: is_converged

      equation%square = exp(2*position)
      high = 1/(sigma*cosh(position))
      equation%ratio = 1/high
      low = max(log(least_factor*equation%square), 0.0_dp)
      l = min(high, 2*high**2/(1 + equation%square))
      if (low < high) call find_root(equation, low, high*(1 + 4*epsilon(high)), .false., l, is_converged)
   end function minimum_log_ratio

   !> See `log_ratio_equation_t`.
   pure subroutine evaluate_log_ratio(self, x, value, slope)
      !> The equation with T^2 and the stress.
      class(log_ratio_equation_t), intent(in) :: self
      !> L, > 0.
      real(dp), intent(in) :: x
      !> ln F - ln(sigma/2).
      real(dp), intent(out) :: value
      !> Derivative of the value.
      real(dp), intent(out) :: slope
      real(dp) :: r2, e, h

      r2 = exp(-2*x)
      e = -expm1(-2*x)
      h = 1 + r2*self%square
      value = log(e/h)/2 - log(x*self%ratio)
      slope = r2/e + r2*self%square/h - 1/x
   end subroutine evaluate_log_ratio

   !> ln T of a maximum of the load, L < L*: ln F is concave and falls with x beyond X*, so Newton's method comes down from a bound
   !> above, X^2 (1 + r^2 X) < rho^2 X with rho = 2 sqrt(1 - r^2)/(sigma L).
   pure real(dp) function maximum_position(sigma, log_ratio) result(x)
      !> sigma = 2 S/pi, > 0.
      real(dp), intent(in) :: sigma
      !> L, > 0.
      real(dp), intent(in) :: log_ratio
      real(dp) :: rho, r2, square, step, slope
      integer :: i

      r2 = exp(-2*log_ratio)
      rho = 2*sqrt(-expm1(-2*log_ratio))/(sigma*log_ratio)
      x = min(log(rho), log(rho)/2 + log_ratio/2)
      do i = 1, max_steps
         square = exp(2*x)
         slope = 1 - 2*square/(1 + square) - r2*square/(1 + r2*square)
         step = (log(rho) + x - log1p(square) - log1p(r2*square)/2)/slope
         x = x - step
         if (abs(step) < 1.0e-9_dp .or. slope >= 0) exit
      end do
   end function maximum_position

end module adfric_plane_adhesive_wave_folds

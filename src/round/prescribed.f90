! SPDX-License-Identifier: GPL-3.0-or-later
!> The state of a part of a curve where a load, an approach, or the approach of the base of a spring is prescribed.
module adfric_round_prescribed
   use adfric_base_kinds, only: dp
   use adfric_round_curve, only: curve_t, curve_interval_t, control_load, endless
   use adfric_numerics_scalar_root, only: equation_t, find_root
   implicit none (type, external)
   private
   public :: find_prescribed, measure_interval

   !> Slopes of logarithms end at the inverse of this.
   real(dp), parameter :: smallest_excess = 1.0e-300_dp

   !> Load or approach, that of the indenter or of the base of its spring, along an interval, less what is given. The unknown is
   !> ln(u - low), or u.
   type, extends(equation_t) :: prescribed_equation_t
      !> The curve.
      class(curve_t), allocatable :: curve
      !> The interval.
      type(curve_interval_t) :: interval
      !> What is prescribed; not `control_radius`.
      integer :: control = control_load
      !> What is given, and the value at the beginning of the interval.
      real(dp) :: given = 0, first = 0
      !> Is the logarithm of u - low the unknown, and is the logarithm of what exceeds the first value compared?
      logical :: is_of_logarithm = .true., compares_logarithms = .true.
   contains
      procedure :: evaluate => evaluate_prescribed
   end type prescribed_equation_t

contains

   !> What is prescribed at the ends of an interval, without bound where it has no end.
   pure subroutine measure_interval(curve, control, interval)
      class(curve_t), intent(in) :: curve
      integer, intent(in) :: control
      type(curve_interval_t), intent(inout) :: interval
      real(dp) :: slope

      call curve%get_prescribed(control, interval%low, interval%is_beyond, interval%first, slope)
      interval%last = merge(endless, -endless, interval%is_stable)
      if (interval%high < endless) call curve%get_prescribed(control, interval%high, interval%is_beyond, interval%last, slope)
   end subroutine measure_interval

   !> The state of an interval where a load or an approach is prescribed.
   pure subroutine find_prescribed(curve, control, interval, given, u, is_found, is_converged)
      class(curve_t), intent(in) :: curve
      integer, intent(in) :: control
      type(curve_interval_t), intent(in) :: interval
      real(dp), intent(in) :: given
      real(dp), intent(out) :: u
      !> Is there such a state in the interval?
      logical, intent(out) :: is_found
      logical, intent(out) :: is_converged
      type(prescribed_equation_t) :: equation

      associate (first => interval%first, last => interval%last)
         is_found = given >= min(first, last) .and. given <= max(first, last)
         is_converged = is_found
         u = interval%low
         if (.not. is_found .or. .not. abs(given - first) > 0) return
         u = interval%high
         if (.not. abs(given - last) > 0) return
         allocate (equation%curve, source=curve)
         equation%interval = interval
         equation%control = control
         equation%given = given
         equation%first = first
         if (interval%is_stable) then
            call find_rising(equation, u, is_converged)
         else
            call find_falling(equation, u, is_converged)
         end if
      end associate
   end subroutine find_prescribed

   !> A stable state: what is prescribed rises from its first value like a power of u - low, so its logarithm is almost linear in
   !> that of u - low, and Newton's method comes to the root from anywhere.
   pure subroutine find_rising(equation, u, is_converged)
      type(prescribed_equation_t), intent(in) :: equation
      real(dp), intent(out) :: u
      logical, intent(out) :: is_converged
      real(dp), parameter :: largest_step = 3.0_dp, margin = 0.05_dp
      integer, parameter :: most_steps = 400
      real(dp) :: low, high, x, value, slope, step
      integer :: k

      low = -endless
      high = endless
      x = log(max(1.0_dp, equation%interval%low))
      if (equation%interval%high < endless) then
         high = log(equation%interval%high - equation%interval%low)
         x = min(x, high - margin)
      end if
      do k = 1, most_steps
         call equation%evaluate(x, value, slope)
         ! the first guess is the root where the unit of length is its radius
         is_converged = abs(value) <= 2*epsilon(value)
         u = equation%interval%low + exp(x)
         if (is_converged) return
         if (value < 0) low = x
         if (.not. value < 0) high = x
         if (low > -endless .and. high < endless) exit
         step = largest_step
         if (abs(value) < largest_step*slope) step = abs(value)/slope + margin
         x = x - sign(step, value)
      end do
      is_converged = low > -endless .and. high < endless
      if (is_converged) call find_root(equation, low, high, .true., x, is_converged)
      u = equation%interval%low + exp(x)
   end subroutine find_rising

   !> An unstable state.
   pure subroutine find_falling(equation, u, is_converged)
      !> The equation, for an unstable interval.
      type(prescribed_equation_t), intent(inout) :: equation
      real(dp), intent(out) :: u
      logical, intent(out) :: is_converged
      ! logarithm of the smallest part of the interval where a state is sought
      real(dp), parameter :: smallest = -300.0_dp
      real(dp) :: high

      equation%compares_logarithms = .false.
      equation%is_of_logarithm = .not. equation%interval%low > 0
      u = 0
      if (equation%is_of_logarithm) then
         high = log(equation%interval%high)
         u = high - 1
         call find_root(equation, high + smallest, high, .false., u, is_converged)
         u = exp(u)
      else
         call find_root(equation, equation%interval%low, equation%interval%high, .false., u, is_converged)
      end if
   end subroutine find_falling

   !> See `equation_t`.
   pure subroutine evaluate_prescribed(self, x, value, slope)
      class(prescribed_equation_t), intent(in) :: self
      !> The unknown ln(u - low), or u.
      real(dp), intent(in) :: x
      !> What is prescribed less what is given, or the difference of the logarithms.
      real(dp), intent(out) :: value
      !> Derivative of the value by the unknown.
      real(dp), intent(out) :: slope
      real(dp) :: u, factor, prescribed, excess

      u = x
      factor = 1
      if (self%is_of_logarithm) then
         factor = exp(x)
         u = self%interval%low + factor
      end if
      call self%curve%get_prescribed(self%control, u, self%interval%is_beyond, prescribed, slope)
      slope = slope*factor
      value = prescribed - self%given
      if (.not. self%compares_logarithms) return
      excess = max(prescribed - self%first, tiny(prescribed))
      value = log_ratio(value, self%given - self%first, excess)
      ! next to the beginning of the interval the slope has no bound
      slope = slope/max(excess, abs(slope)*smallest_excess)
   end subroutine evaluate_prescribed

   !> ln(excess/rest) for excess = rest + difference, with the digits of the difference.
   elemental real(dp) function log_ratio(difference, rest, excess)
      !> What the excess has more than the rest.
      real(dp), intent(in) :: difference
      !> The rest, > 0.
      real(dp), intent(in) :: rest
      !> Their sum, > 0.
      real(dp), intent(in) :: excess
      real(dp) :: ratio

      ratio = difference/(rest + excess)
      if (abs(ratio) < 0.1_dp) then
         log_ratio = 2*ratio*(1 + ratio**2*(1 + ratio**2*(0.6_dp + ratio**2*(3/7.0_dp + ratio**2/3)))/3)
      else
         ! the ratio itself may be too small for a number
         log_ratio = log(excess) - log(rest)
      end if
   end function log_ratio

end module adfric_round_prescribed

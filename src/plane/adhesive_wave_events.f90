! SPDX-License-Identifier: GPL-3.0-or-later
!> An adhesive wave with all events of its curve of equilibria (`adhesive_wave_curve`, which says why there are no others): here those
!> of the penetration.
module adfric_plane_adhesive_wave_events
   use adfric_base_kinds, only: dp
   use adfric_numerics_scalar_root, only: equation_t, find_root
   use adfric_numerics_secant_root, only: rising_equation_t, find_rising_root
   use adfric_plane_adhesive_wave, only: zones_t, get_zones_of_position, range_excess, get_range_slopes, penetration_slope, &
      & get_fold_slopes, open_crest
   use adfric_plane_adhesive_wave_curve, only: adhesive_wave_t, find_curve, find_contact, get_curve_state, is_open, &
      & least_position, largest_position
   implicit none (type, external)
   private
   public :: new_adhesive_wave

   !> What an equation over its leading term may be at its root.
   real(dp), parameter :: round_off = 4*epsilon(1.0_dp)
   !> A Newton step of this size is the last.
   real(dp), parameter :: last_step = 1.0e-9_dp
   !> Newton steps of both unknowns, and the largest y at which the range says something of y.
   integer, parameter :: max_steps = 4
   real(dp), parameter :: largest_y = 300.0_dp

   !> ln of the range over eta as a function of x at given y.
   type, extends(equation_t) :: position_equation_t
      !> The wave.
      type(adhesive_wave_t) :: wave
      !> y.
      real(dp) :: y = 0
   contains
      procedure :: evaluate => evaluate_position
   end type position_equation_t

   !> Minus the slope of the penetration along the curve, as a function of ln y for c < 1/4 or of x for c > 1/4.
   type, extends(rising_equation_t) :: extreme_equation_t
      !> The wave.
      type(adhesive_wave_t) :: wave
      !> Is it the minimum?
      logical :: is_least = .false.
   contains
      procedure :: evaluate => evaluate_extreme
   end type extreme_equation_t

contains

   !> A wave with all events.
   pure subroutine new_adhesive_wave(self, stress, range, is_converged)
      type(adhesive_wave_t), intent(out) :: self
      !> S = sigma0/p*, 1e-12 to 1e12.
      real(dp), intent(in) :: stress
      !> eta = h0/D, 1e-12 to 1e12.
      real(dp), intent(in) :: range
      logical, intent(out) :: is_converged
      logical :: has_found
      real(dp) :: position, unused, gap

      call find_curve(self, stress, range, is_converged)
      position = open_fold_position(self%sigma)
      if (is_open(self, -position)) then
         call get_zones_of_position(-position, open_crest, self%lowest)
      else
         call find_lowest(self, has_found)
         is_converged = is_converged .and. has_found
      end if
      if (is_open(self, position)) then
         call get_zones_of_position(position, open_crest, self%highest)
      else
         call find_highest(self, has_found)
         is_converged = is_converged .and. has_found
      end if
      call get_curve_state(self, self%lowest, unused, self%least_penetration, gap)
      call get_curve_state(self, self%highest, unused, self%largest_penetration, gap)
   end subroutine new_adhesive_wave

   !> |x| of the extremes of the penetration with an open crest: w + 2 sigma ln w = 0 by z = ln w, for which Newton's method comes
   !> down from 0, and cosh x = 2/w.
   pure real(dp) function open_fold_position(sigma) result(x)
      !> sigma = 2 S/pi, > 0.
      real(dp), intent(in) :: sigma
      real(dp) :: z, step
      integer :: i

      z = 0
      do i = 1, 100
         step = (exp(z) + 2*sigma*z)/(exp(z) + 2*sigma)
         z = z - step
         if (abs(step) < last_step) exit
      end do
      x = acosh(2*exp(-z))
   end function open_fold_position

   !> The minimum of the penetration in contact, along y.
   pure subroutine find_lowest(self, is_converged)
      type(adhesive_wave_t), intent(inout) :: self
      logical, intent(out) :: is_converged
      type(extreme_equation_t) :: equation
      type(zones_t) :: zones
      real(dp) :: x, low

      call find_contact(self, 0.0_dp, zones, is_converged)
      if (.not. is_converged) return
      equation%wave = self
      equation%is_least = .true.
      low = log(zones%y)
      x = low + 0.5_dp
      call find_rising_root(equation, low, log(open_crest), 1.0_dp, round_off, x, is_converged)
      call get_zones_of_position(position_of(self, exp(x)), exp(x), self%lowest)
   end subroutine find_lowest

   !> The maximum of the penetration in contact, along x; Newton's method in x and y finds contacts that x cannot tell apart.
   pure subroutine find_highest(self, is_converged)
      type(adhesive_wave_t), intent(inout) :: self
      logical, intent(out) :: is_converged
      type(extreme_equation_t) :: equation
      real(dp) :: x, low, high, value

      equation%wave = self
      low = max(0.0_dp, self%first_position)
      high = self%last_position
      if (high >= largest_position) then
         high = low + 2
         do
            call equation%evaluate(high, value)
            if (value > 0 .or. high > largest_position) exit
            low = high
            high = low + 2
         end do
      end if
      x = (low + high)/2
      call find_rising_root(equation, low, high, 1.0_dp, round_off, x, is_converged)
      self%highest%y = 0
      if (is_converged) call find_contact(self, x, self%highest, is_converged)
      if (is_converged) call refine(self, self%highest)
   end subroutine find_highest

   !> Newton's method for an extreme of the penetration.
   pure subroutine refine(self, zones)
      type(adhesive_wave_t), intent(in) :: self
      !> Zones close to the extreme, and there.
      type(zones_t), intent(inout) :: zones
      real(dp) :: a(2), load_by(2), b(2), right(2), det, dx, dy
      integer :: i

      do i = 1, max_steps
         if (zones%y > largest_y) exit
         call get_range_slopes(self%sigma, zones, a(1), a(2))
         call get_fold_slopes(self%sigma, zones, load_by, b)
         right = -[range_excess(self%sigma, self%range, zones), penetration_slope(self%sigma, zones)]
         det = a(1)*b(2) - a(2)*b(1)
         dx = (right(1)*b(2) - right(2)*a(2))/det
         dy = (right(2)*a(1) - right(1)*b(1))/det
         if (.not. (abs(dx) < 1.0e-6_dp .and. abs(dy) < zones%y/2)) exit
         call get_zones_of_position(zones%position + dx, zones%y + dy, zones)
      end do
   end subroutine refine

   !> See `extreme_equation_t`.
   pure subroutine evaluate_extreme(self, x, value)
      class(extreme_equation_t), intent(in) :: self
      !> ln y, or ln T.
      real(dp), intent(in) :: x
      !> The slope, with sign.
      real(dp), intent(out) :: value
      type(zones_t) :: zones
      logical :: is_converged

      if (self%is_least) then
         call get_zones_of_position(position_of(self%wave, exp(x)), exp(x), zones)
      else
         call find_contact(self%wave, x, zones, is_converged)
      end if
      value = -penetration_slope(self%wave%sigma, zones)/(self%wave%sigma*zones%y**2)
   end subroutine evaluate_extreme

   !> x of the equilibrium at a given y, c < 1/4.
   pure real(dp) function position_of(wave, y) result(x)
      type(adhesive_wave_t), intent(in) :: wave
      real(dp), intent(in) :: y
      type(position_equation_t) :: equation
      logical :: is_converged

      equation%wave = wave
      equation%y = y
      x = wave%first_position
      call find_root(equation, least_position, 1.0e-3_dp, .true., x, is_converged, last_step)
   end function position_of

   !> See `position_equation_t`.
   pure subroutine evaluate_position(self, x, value, slope)
      class(position_equation_t), intent(in) :: self
      !> x = ln T.
      real(dp), intent(in) :: x
      !> ln of the range over eta.
      real(dp), intent(out) :: value
      !> Its derivative.
      real(dp), intent(out) :: slope
      type(zones_t) :: zones
      real(dp) :: range, unused

      call get_zones_of_position(x, self%y, zones)
      range = range_excess(self%wave%sigma, 0.0_dp, zones)
      call get_range_slopes(self%wave%sigma, zones, slope, unused)
      value = log(range/self%wave%range)
      slope = slope/range
   end subroutine evaluate_position

end module adfric_plane_adhesive_wave_events

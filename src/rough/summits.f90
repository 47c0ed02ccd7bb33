! SPDX-License-Identifier: GPL-3.0-or-later
!> Theories of summits that are pressed one by one, after P. R. Nayak's density of their heights z and principal curvatures
!> k (1 + s) and k (1 - s). With kappa = k/sqrt(m4), heights and separations d from the mean plane over the height h, and Nayak's
!> parameter alpha, the heights of a curvature have the mean (3/2) kappa/sqrt(alpha) and the variance v^2 = 1 - 3/(2 alpha), and
!>
!>     A = (sqrt(alpha)/2) int kappa^3 w a v G_1(x) dkappa ds,   x = (d - mean)/v
!>     p/(E g) = (sqrt(2)/(3 pi)) alpha^(3/4) int kappa^(7/2) w f v^(3/2) G_(3/2)(x) dkappa ds
!>     w = sqrt(3/(4 pi)) exp(-3 kappa^2/4) 3 s (1 - s^2) exp(-3 kappa^2 s^2/2)
!>
!> with the area a and the load f of a summit over those of a sphere of the curvature k. Over s the integral is done once,
!> whatever the surface. Greenwood and Williamson have one radius, the mean density of summits, and Gaussian heights of summits.
module adfric_rough_summits
   use adfric_base_constants, only: pi
   use adfric_base_kinds, only: dp
   use adfric_numerics_chebyshev, only: degree
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   use adfric_rough_panel_series, only: new_panel_series, panel_series_t, positions_of
   use adfric_rough_summit_loads, only: new_summit_loads, summit_loads_t
   use adfric_rough_summit_shapes, only: exact_ellipse, geometric_mean
   implicit none (type, external)
   private
   public :: summits_t, new_summits, summit_state_t, theory_greenwood_williamson, theory_bush_gibson_thomas
   public :: theory_greenwood_elliptic, theory_nayak_sphere, n_summit_theories

   !> The theories.
   integer, parameter :: theory_greenwood_williamson = 1, theory_bush_gibson_thomas = 2, theory_greenwood_elliptic = 3, &
      & theory_nayak_sphere = 4, n_summit_theories = 4
   !> Largest separation over height where a state is sought, and least pressure over E g: that of the first is below it.
   real(dp), parameter :: most_separation = 30, least_pressure = 1.0e-100_dp
   !> Half-width of the curvatures that count around the most frequent one, and largest curvature of the series.
   real(dp), parameter :: reach = 6.5_dp, most_curvature = 34
   integer, parameter :: n_panels = 68
   !> Widest panel of the curvatures.
   real(dp), parameter :: widest = 1.5_dp
   !> Ends of the panels of asin s.
   real(dp), parameter :: angles(0:4) = [0.0_dp, 0.1_dp, 0.3_dp, 0.8_dp, pi/2]

   !> What the theories share for all surfaces.
   type :: summits_t
      !> Moments of heights above a level.
      type(summit_loads_t) :: loads
      !> Integrals over s of the area and of the load, times 1 + kappa^2, of the theories but the first.
      type(panel_series_t) :: area(2:n_summit_theories), load(2:n_summit_theories)
      !> Have all been found?
      logical :: is_converged = .false.
   contains
      procedure :: at_separation
      procedure :: under_pressure
   end type summits_t

   !> A state of a theory.
   type :: summit_state_t
      !> Separation of the mean planes over h, area, p/(E g), and -dp/dd over E g/h.
      real(dp) :: separation = 0, area = 0, pressure = 0, stiffness = 0
   end type summit_state_t

contains

   !> Find what the theories share.
   pure subroutine new_summits(self)
      type(summits_t), intent(out) :: self
      integer, parameter :: n_s = size(gauss_nodes)*(size(angles) - 1)
      real(dp) :: kappa(0:degree, n_panels), w(n_s), s(n_s), values(0:degree, n_panels, 2)
      real(dp) :: area(n_s, 2:n_summit_theories), load(n_s, 2:n_summit_theories), density(n_s)
      logical :: is_converged
      integer :: i, j, k

      call new_summit_loads(self%loads)
      call get_nodes(s, w)
      area = 1
      load = 1
      self%is_converged = .true.
      do i = 1, n_s
         call exact_ellipse(s(i), area(i, theory_bush_gibson_thomas), load(i, theory_bush_gibson_thomas), is_converged)
         self%is_converged = self%is_converged .and. is_converged
      end do
      call geometric_mean(s, area(:, theory_greenwood_elliptic), load(:, theory_greenwood_elliptic))
      kappa = positions_of(0.0_dp, most_curvature/n_panels, n_panels)
      do i = 2, n_summit_theories
         do k = 1, n_panels
            do j = 0, degree
               density = w*3*s*(1 - s)*(1 + s)*exp(-1.5_dp*(kappa(j, k)*s)**2)*(1 + kappa(j, k)**2)
               values(j, k, :) = [sum(density*area(:, i)), sum(density*load(:, i))]
            end do
         end do
         call new_panel_series(self%area(i), 0.0_dp, most_curvature/n_panels, values(:, :, 1))
         call new_panel_series(self%load(i), 0.0_dp, most_curvature/n_panels, values(:, :, 2))
      end do
   end subroutine new_summits

   !> Nodes and weights of integrals over s = sin(angle): integrands have roots of 1 - s.
   pure subroutine get_nodes(s, w)
      real(dp), intent(out) :: s(:), w(:)
      real(dp) :: angle(size(gauss_nodes))
      integer :: k, first

      do k = 1, size(angles) - 1
         first = size(gauss_nodes)*(k - 1) + 1
         angle = angles(k - 1) + (angles(k) - angles(k - 1))*(1 + gauss_nodes)/2
         s(first:first + size(gauss_nodes) - 1) = sin(angle)
         w(first:first + size(gauss_nodes) - 1) = gauss_weights*(angles(k) - angles(k - 1))/2*cos(angle)
      end do
   end subroutine get_nodes

   !> The state of a theory at a separation.
   pure subroutine at_separation(self, theory, alpha, separation, state)
      class(summits_t), intent(in) :: self
      !> One of `theory_...`.
      integer, intent(in) :: theory
      !> Nayak's parameter, 3/2 at least.
      real(dp), intent(in) :: alpha
      !> Separation of the mean planes over h, from 0 to `most_separation`.
      real(dp), intent(in) :: separation
      type(summit_state_t), intent(out) :: state

      if (theory == theory_greenwood_williamson) then
         call get_equal_summits(self, alpha, separation, state)
      else
         call get_all_summits(self, theory, alpha, separation, state)
      end if
   end subroutine at_separation

   !> Greenwood and Williamson: equal summits of the mean curvature, whose heights are Gaussian.
   pure subroutine get_equal_summits(self, alpha, separation, state)
      class(summits_t), intent(in) :: self
      real(dp), intent(in) :: alpha, separation
      type(summit_state_t), intent(out) :: state
      !> Variance of the heights of summits: m0 (1 - this/alpha).
      real(dp), parameter :: spread = 1 - 3*sqrt(3.0_dp) + 16/pi
      real(dp) :: deviation, x, g(3), unit

      deviation = sqrt(1 - spread/alpha)
      x = (separation - 4/sqrt(pi*alpha))/deviation
      call self%loads%get_moments(x, g)
      g = g*exp(-max(x, 0.0_dp)**2/2)
      ! radius (3/8) sqrt(pi/m4), density m4/(6 pi sqrt(3) m2)
      unit = 4/(18*pi*sqrt(3.0_dp))*sqrt(3/8.0_dp)*pi**0.25_dp/sqrt(2.0_dp)*alpha**0.75_dp
      state%separation = separation
      state%area = sqrt(alpha*pi)/(16*sqrt(3.0_dp))*deviation*g(2)
      state%pressure = unit*deviation*sqrt(deviation)*g(3)
      state%stiffness = 1.5_dp*unit*sqrt(deviation)*g(1)
   end subroutine get_equal_summits

   !> Summits of all curvatures.
   pure subroutine get_all_summits(self, theory, alpha, separation, state)
      class(summits_t), intent(in) :: self
      integer, intent(in) :: theory
      real(dp), intent(in) :: alpha, separation
      type(summit_state_t), intent(out) :: state
      real(dp), allocatable :: ends(:)
      real(dp) :: v, x, kappa, g(3), weight, sums(3)
      integer :: i, k

      v = sqrt(max(1 - 1.5_dp/alpha, 1.0e-14_dp))
      call find_ends(alpha, separation, v, ends)
      sums = 0
      do i = 1, size(ends) - 1
         do k = 1, size(gauss_nodes)
            kappa = ends(i) + (ends(i + 1) - ends(i))*(1 + gauss_nodes(k))/2
            x = (separation - 1.5_dp*kappa/sqrt(alpha))/v
            call self%loads%get_moments(x, g)
            weight = gauss_weights(k)*(ends(i + 1) - ends(i))/2*sqrt(3/(4*pi))*kappa**3/(1 + kappa**2) &
               & *exp(-0.75_dp*kappa**2 - max(x, 0.0_dp)**2/2)
            sums(2) = sums(2) + weight*self%area(theory)%value_at(kappa)*g(2)
            weight = weight*sqrt(kappa)*self%load(theory)%value_at(kappa)
            sums(1) = sums(1) + weight*g(1)
            sums(3) = sums(3) + weight*g(3)
         end do
      end do
      state%separation = separation
      state%area = sqrt(alpha)/2*v*sums(2)
      state%pressure = sqrt(2.0_dp)/(3*pi)*alpha**0.75_dp*v*sqrt(v)*sums(3)
      state%stiffness = sqrt(2.0_dp)/(2*pi)*alpha**0.75_dp*sqrt(v)*sums(1)
   end subroutine get_all_summits

   !> Ends of panels of the curvatures: around that whose mean height is the separation they widen from the scatter of heights.
   pure subroutine find_ends(alpha, separation, v, ends)
      real(dp), intent(in) :: alpha, separation
      !> Standard deviation of the heights of a curvature.
      real(dp), intent(in) :: v
      !> Receives them, rising.
      real(dp), allocatable, intent(out) :: ends(:)
      real(dp) :: low, high, middle, step, x
      real(dp), allocatable :: above(:), below(:)
      integer :: k

      ! the sum of 3/4 kappa^2 and x^2/2 is least at d/sqrt(alpha)
      low = max(0.0_dp, separation/sqrt(alpha) - reach)
      high = min(most_curvature, separation/sqrt(alpha) + reach)
      middle = min(max(separation*sqrt(alpha)/1.5_dp, low), high)
      allocate (above(0), below(0))
      step = v*sqrt(alpha)/1.5_dp
      x = middle
      do while (x < high)
         x = min(high, x + min(step, widest))
         if (high - x < 1.0e-3_dp*min(step, widest)) x = high
         above = [above, x]
         step = 2*step
      end do
      step = v*sqrt(alpha)/1.5_dp
      x = middle
      do while (x > low)
         x = max(low, x - min(step, widest))
         if (x - low < 1.0e-3_dp*min(step, widest)) x = low
         below = [below, x]
         step = 2*step
      end do
      ends = [(below(k), k=size(below), 1, -1), middle, above]
   end subroutine find_ends

   !> The state of a theory under a pressure, by Newton's method for ln p, whose slope falls with the separation.
   pure subroutine under_pressure(self, theory, alpha, pressure, guess, state, is_there, is_converged)
      class(summits_t), intent(in) :: self
      !> One of `theory_...`.
      integer, intent(in) :: theory
      !> Nayak's parameter; p/(E g), > 0; and a first separation over h, from 0 to `most_separation`.
      real(dp), intent(in) :: alpha, pressure, guess
      type(summit_state_t), intent(out) :: state
      !> Does a separation have the pressure? The theories have none below the mean plane, and none is sought of less than
      !> `least_pressure`.
      logical, intent(out) :: is_there
      logical, intent(out) :: is_converged
      integer, parameter :: max_iterations = 100
      real(dp) :: low, high, separation, step, excess
      integer :: k

      is_converged = self%is_converged
      is_there = pressure >= least_pressure
      if (.not. is_there) return
      low = -1
      high = most_separation
      separation = guess
      is_converged = .false.
      do k = 1, max_iterations
         call self%at_separation(theory, alpha, separation, state)
         if (.not. state%pressure > 0) then
            high = separation
            separation = (max(low, 0.0_dp) + high)/2
            cycle
         end if
         excess = log(state%pressure/pressure)
         if (excess >= 0) low = separation
         if (excess < 0) high = separation
         is_there = high > 0
         if (.not. is_there) exit
         step = excess*state%pressure/state%stiffness
         ! the error of the last step is of the size of its square
         is_converged = abs(step) <= 1.0e-13_dp*max(separation, 1.0_dp)
         if (is_converged) exit
         separation = separation + step
         if (low < 0) separation = max(separation, 0.0_dp)
         if (.not. (separation >= low .and. separation <= high)) separation = (max(low, 0.0_dp) + high)/2
      end do
      is_converged = (is_converged .or. .not. is_there) .and. self%is_converged
   end subroutine under_pressure

end module adfric_rough_summits

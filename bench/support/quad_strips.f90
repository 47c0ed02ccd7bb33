! SPDX-License-Identifier: GPL-3.0-or-later
!> A strip in quadruple precision, for comparison only: the edge equations of `plain_edges` by Newton's method, from an answer in
!> double precision, and the forces of these edges from integrals written out. Foundations with Te/Ts = 1 are not covered.
module quad_strips
   use, intrinsic :: iso_fortran_env, only: qp => real128
   use adfric_base_kinds, only: dp
   use adfric_foundation_adhesion, only: edge_instantaneous
   use adfric_foundation_strip, only: steady_state_t, regime_free, regime_adhesion_only, regime_adhesion_zones, &
      regime_saturated_adhesion, regime_saturated
   use trial_strips, only: trial_t
   implicit none (type, external)
   private
   public :: get_quad_forces

   real(qp), parameter :: pi = 3.14159265358979323846264338327950288_qp
   !> Step of the derivatives, and the last step of the edges, relative to the first.
   real(qp), parameter :: difference = 1.0e-15_qp, close_enough = 1.0e-24_qp
   integer, parameter :: max_steps = 12
   !> The answer is another one if its edges are further than this from it.
   real(qp), parameter :: farthest = 1.0e-4_qp

   !> A strip in units of half its height.
   type :: quad_strip_t
      real(qp) :: u, v, storage, loss, mean, stress, range, jump, entry
      integer :: regime, n
   end type quad_strip_t

contains

   !> Integrals of p and p sin(xi) over a period, pressures in K times half the height.
   pure subroutine get_quad_forces(trial, state, load, friction, is_found)
      type(trial_t), intent(in) :: trial
      !> The answer in double precision: its regime, and where its edges are looked for.
      type(steady_state_t), intent(in) :: state
      real(qp), intent(out) :: load, friction
      logical, intent(out) :: is_found
      type(quad_strip_t) :: s
      real(qp) :: x(4), start(4)

      s = new_quad_strip(trial, state)
      start(1:2) = state%half_width + [-1, 1]*real(state%shift, qp)
      start(3:4) = start(1:2) + [real(state%trailing, qp), real(state%leading, qp)]
      x = start
      is_found = .true.
      load = 0
      friction = 0
      select case (s%regime)
      case (regime_free)
         return
      case (regime_saturated)
         load = 2*pi*s%mean
         friction = pi*s%loss
         return
      case (regime_adhesion_only)
         ! adhesion everywhere
         if (state%half_width > 3.14_dp) then
            load = -2*pi*s%stress
            return
         end if
      end select
      call find_edges(s, x(:s%n), is_found)
      is_found = is_found .and. all(abs(x(:s%n) - start(:s%n)) < farthest)
      if (is_found) call add_forces(s, x, load, friction)
   end subroutine get_quad_forces

   pure type(quad_strip_t) function new_quad_strip(trial, state) result(s)
      type(trial_t), intent(in) :: trial
      type(steady_state_t), intent(in) :: state
      real(qp) :: beta

      beta = trial%beta
      s%u = trial%u
      s%v = beta*s%u
      s%storage = (1 + s%u*s%v)/(1 + s%u**2)
      s%loss = (s%v - s%u)/(1 + s%u**2)
      s%mean = 2*real(trial%penetration, qp) - 1
      s%stress = 2*real(trial%stress, qp)
      s%range = 2*real(trial%range, qp)
      s%jump = 0
      if (trial%edge == edge_instantaneous) s%jump = s%stress/beta
      s%entry = 0
      s%regime = state%regime
      s%n = 2
      if (s%regime == regime_adhesion_zones) s%n = 4
      if (state%entry > 0) then
         s%entry = s%stress - beta*s%range
         s%n = 3
      end if
   end function new_quad_strip

   !> Newton's method with differences.
   pure subroutine find_edges(s, x, is_found)
      type(quad_strip_t), intent(in) :: s
      real(qp), intent(inout) :: x(:)
      logical, intent(out) :: is_found
      real(qp), dimension(size(x)) :: f, moved, step
      real(qp) :: slopes(size(x), size(x))
      integer :: k, j

      is_found = .false.
      do k = 1, max_steps
         f = residuals(s, x)
         do j = 1, size(x)
            moved = x
            moved(j) = x(j) + difference
            slopes(:, j) = (residuals(s, moved) - f)/difference
         end do
         call solve_linear(slopes, f, step, is_found)
         if (.not. is_found) return
         x = x - step
         is_found = maxval(abs(step)) < close_enough
         if (is_found) return
      end do
   end subroutine find_edges

   !> Gauss's elimination with pivots.
   pure subroutine solve_linear(matrix, right, x, is_solved)
      real(qp), intent(inout) :: matrix(:, :)
      real(qp), intent(in) :: right(:)
      real(qp), intent(out) :: x(:)
      logical, intent(out) :: is_solved
      real(qp) :: row(size(right)), value
      integer :: n, i, j, p

      n = size(right)
      x = right
      is_solved = .false.
      do i = 1, n
         p = i - 1 + maxloc(abs(matrix(i:, i)), 1)
         if (.not. abs(matrix(p, i)) > 0) return
         row = matrix(p, :)
         matrix(p, :) = matrix(i, :)
         matrix(i, :) = row
         value = x(p)
         x(p) = x(i)
         x(i) = value
         do j = i + 1, n
            x(j) = x(j) - x(i)*matrix(j, i)/matrix(i, i)
            matrix(j, :) = matrix(j, :) - matrix(i, :)*(matrix(j, i)/matrix(i, i))
         end do
      end do
      do i = n, 1, -1
         x(i) = (x(i) - dot_product(matrix(i, i + 1:), x(i + 1:)))/matrix(i, i)
      end do
      is_solved = .true.
   end subroutine solve_linear

   !> The conditions at the edges, as in `plain_edges`.
   pure function residuals(s, x) result(f)
      type(quad_strip_t), intent(in) :: s
      real(qp), intent(in) :: x(:)
      real(qp) :: f(size(x)), b1

      associate (a => x(1), b => x(2))
         select case (s%regime)
         case (regime_adhesion_only)
            f(1) = (level(b) + s%range - s%jump + s%stress)*exp(-(a + b)/s%v) - s%stress - level(-a) - s%range
            f(2) = (level(-a) + s%range + s%jump)*exp(-(2*pi - a - b)/s%v) - level(b) - s%range
         case (regime_adhesion_zones)
            associate (a1 => x(3))
               b1 = b
               if (s%n == 4) b1 = x(s%n)
               f(1) = pressure(s, -a) + s%stress + (s%entry - s%stress - pressure(s, b))*exp(-(a + b)/s%u)
               f(2) = (level(-a) + s%stress)*exp(-(a1 - a)/s%v) - s%stress - level(-a1) - s%range
               f(3) = (level(-a1) + s%range + s%jump)*exp(-(2*pi - a1 - b1)/s%v) - level(b1) - s%range
               if (s%n == 4) f(s%n) = (level(b1) + s%range - s%jump + s%stress)*exp(-(b1 - b)/s%v) - s%stress - level(b)
            end associate
         case default
            f(1) = pressure(s, -a) + s%stress - (s%stress + pressure(s, b))*exp(-(a + b)/s%u)
            f(2) = (level(-a) + s%stress)*exp(-(2*pi - a - b)/s%v) - s%stress - level(b)
         end select
      end associate

   contains

      pure real(qp) function level(xi)
         real(qp), intent(in) :: xi

         level = s%mean + cos(xi)
      end function level

   end function residuals

   !> The pressure of endless contact.
   pure real(qp) function pressure(s, xi)
      type(quad_strip_t), intent(in) :: s
      real(qp), intent(in) :: xi

      pressure = s%mean + s%storage*cos(xi) + s%loss*sin(xi)
   end function pressure

   !> p = pressure(xi) + C exp(-(b - xi)/u) in the contact, -stress in adhesion.
   pure subroutine add_forces(s, x, load, friction)
      type(quad_strip_t), intent(in) :: s
      !> a, b, a1, b1.
      real(qp), intent(in) :: x(4)
      real(qp), intent(inout) :: load, friction
      real(qp) :: transient, kept, open_length, open_sine, b1

      associate (a => x(1), b => x(2), a1 => x(3))
         if (s%regime == regime_adhesion_only) then
            load = -s%stress*(a + b)
            friction = -s%stress*(cos(a) - cos(b))
            return
         end if
         transient = s%entry - s%stress - pressure(s, b)
         kept = exp(-(a + b)/s%u)
         load = s%mean*(a + b) + s%storage*(sin(a) + sin(b)) + s%loss*(cos(a) - cos(b)) + transient*s%u*(1 - kept)
         friction = s%mean*(cos(a) - cos(b)) + s%storage*(sin(b)**2 - sin(a)**2)/2 &
            + s%loss*(a + b - sin(b)*cos(b) - sin(a)*cos(a))/2 &
            + transient*s%u/(1 + s%u**2)*(sin(b) - s%u*cos(b) + kept*(sin(a) + s%u*cos(a)))
         open_length = 0
         open_sine = 0
         if (s%regime == regime_saturated_adhesion) then
            open_length = 2*pi - a - b
            open_sine = cos(b) - cos(a)
         else if (s%regime == regime_adhesion_zones) then
            b1 = b
            if (s%n == 4) b1 = x(4)
            open_length = a1 - a + b1 - b
            open_sine = cos(a1) - cos(a) + cos(b) - cos(b1)
         end if
         load = load - s%stress*open_length
         friction = friction - s%stress*open_sine
      end associate
   end subroutine add_forces

end module quad_strips

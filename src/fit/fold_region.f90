! SPDX-License-Identifier: GPL-3.0-or-later
!> The sum of squares while the fold of a curve stays between two neighbouring points.
!>
!> With points of contact X_1 <= X_2 <= ... the region k has X_k <= X_f <= X_(k+1): k points lie beyond the fold, and
!> S is smooth within. At X_f = X_(k+1) the point k+1 reaches the fold, where its ordinate goes by (X_(k+1) - X_f)^p
!> and S has a kink. So one of the free variables, the pivot, gives way to
!>
!>     s = ((X_(k+1) - X_f)/H)^p,    H the mean distance of the points,
!>
!> and S is smooth in s and the other variables up to both ends of the region, which are plain bounds of s. The pivot
!> follows from s by Newton's method for X_f: at once where it is a zero. With g the derivatives of X_f, dq_p = -(sum
!> of g_j dq_j + H s^(1/p-1)/p ds)/g_p.
module adfric_fit_fold_region
   use adfric_base_kinds, only: dp
   use adfric_fit_fold, only: curve_fold_t, find_fold, fold_slope, fold_slopes, last_slopes
   use adfric_fit_objective, only: objective_t
   use adfric_numerics_bounded_least_squares, only: least_squares_t
   implicit none (type, external)
   private
   public :: region_t, new_region, enter_region, leave_region

   !> How near the fold may come to a point that it does not pass, in units of the round-off of abscissas.
   real(dp), parameter :: nearest = 1.0e4_dp*epsilon(1.0_dp)
   !> Steps of Newton's method for the pivot, and its longest one.
   integer, parameter :: most_steps = 60
   real(dp), parameter :: longest_step = 2.0_dp

   !> A region.
   type, extends(least_squares_t) :: region_t
      !> The sum of squares.
      type(objective_t), pointer :: objective => null()
      !> The curve whose fold it is.
      type(curve_fold_t) :: fold
      !> Which variable gives way to s, and how many points lie beyond the fold.
      integer :: pivot = 0, n_beyond = 0
      !> The power p, H, the nearest distance of the fold to a point, and X_(k+1).
      real(dp) :: power = 0.5_dp, unit = 1, gap = 0, next = 0
      !> Bounds of the numbers that are fitted, and of the same with s.
      real(dp), allocatable :: lower_q(:), upper_q(:), lower(:), upper(:)
      !> The numbers that are fitted at the last evaluation.
      real(dp), allocatable :: q(:)
      !> Was the pivot beyond its bounds at the last position?
      logical :: is_outside = .false.
   contains
      procedure :: evaluate
   end type region_t

contains

   !> Choose the pivot: the zero of the abscissa if it is free, else the variable that moves the fold most.
   subroutine new_region(self, objective, fold, lower, upper, is_fixed, q, is_there)
      !> Receives the region, without a position yet.
      type(region_t), intent(out) :: self
      type(objective_t), intent(inout), target :: objective
      type(curve_fold_t), intent(in) :: fold
      !> Bounds of the numbers that are fitted.
      real(dp), intent(in) :: lower(:), upper(:)
      !> Which of them stay as they are.
      logical, intent(in) :: is_fixed(:)
      real(dp), intent(in) :: q(:)
      !> Is there a variable that moves the fold?
      logical, intent(out) :: is_there
      real(dp) :: by_free(size(q))
      integer :: n

      self%objective => objective
      self%fold = fold
      self%lower_q = lower
      self%upper_q = upper
      self%lower = lower
      self%upper = upper
      self%q = q
      n = size(fold%x)
      self%unit = (fold%x(n) - fold%x(1))/(n - 1)
      self%gap = nearest*maxval(abs(fold%x))
      by_free = fold_slopes(objective, q, fold)
      self%power = fold%power
      where (is_fixed .or. q <= lower .or. q >= upper) by_free = 0
      is_there = any(abs(by_free) > 0) .and. self%unit > 0
      if (.not. is_there) return
      self%pivot = maxloc(abs(by_free), 1)
      do n = 1, size(q)
         if (abs(by_free(n)) > 0 .and. .not. objective%frees(n)%is_log) self%pivot = n
      end do
   end subroutine new_region

   !> Enter the region with so many points beyond the fold, as near as possible to a position.
   subroutine enter_region(self, n_beyond, q, u, is_there)
      type(region_t), intent(inout) :: self
      !> Points beyond the fold, less than there are.
      integer, intent(in) :: n_beyond
      real(dp), intent(in) :: q(:)
      !> Receives the same with s.
      real(dp), intent(out) :: u(:)
      !> Is there space between the neighbouring points?
      logical, intent(out) :: is_there
      real(dp) :: at, width

      self%n_beyond = n_beyond
      self%next = self%fold%x(n_beyond + 1)
      width = huge(width)
      if (n_beyond > 0) width = self%next - self%fold%x(n_beyond) - self%gap
      is_there = width > 3*self%gap
      u = q
      if (.not. is_there) return
      associate (p => self%pivot)
         self%lower(p) = s_of(self, self%gap)
         self%upper(p) = 1.0e90_dp
         if (n_beyond > 0) self%upper(p) = s_of(self, width)
         self%q = q
         call find_fold(self%objective, q, self%fold, at, is_there)
         if (.not. is_there) return
         u(p) = min(max(s_of(self, max(self%next - at, 0.0_dp)), self%lower(p)), self%upper(p))
      end associate
   end subroutine enter_region

   !> s at a distance of the fold from the next point.
   pure real(dp) function s_of(self, distance)
      type(region_t), intent(in) :: self
      real(dp), intent(in) :: distance

      s_of = (distance/self%unit)**self%power
   end function s_of

   !> The numbers that are fitted at a position.
   subroutine leave_region(self, u, q, is_valid)
      type(region_t), intent(inout) :: self
      !> The position, with s.
      real(dp), intent(in) :: u(:)
      !> Receives the numbers that are fitted.
      real(dp), intent(out) :: q(:)
      !> Is there such a position within the bounds?
      logical, intent(out) :: is_valid
      real(dp) :: wanted, at, step, slope
      logical :: is_known
      integer :: k

      associate (p => self%pivot)
         q = u
         q(p) = self%q(p)
         wanted = self%next - self%unit*u(p)**(1/self%power)
         is_valid = .false.
         self%is_outside = .false.
         do k = 1, most_steps
            call find_fold(self%objective, q, self%fold, at, is_known)
            if (.not. is_known) return
            slope = fold_slope(self%objective, q, self%fold, p)
            if (.not. abs(slope) > 0) return
            step = (wanted - at)/slope
            if (self%objective%frees(p)%is_log) step = min(max(step, -longest_step), longest_step)
            if (.not. abs(step) <= huge(step)) return
            q(p) = q(p) + step
            is_valid = abs(step*slope) <= self%gap/1000
            if (is_valid) exit
         end do
         self%is_outside = is_valid .and. (q(p) < self%lower_q(p) .or. q(p) > self%upper_q(p))
         is_valid = is_valid .and. .not. self%is_outside
         if (is_valid) self%q = q
      end associate
   end subroutine leave_region

   !> See `least_squares_t`.
   subroutine evaluate(self, q, n_rows, r, j, cost, is_valid)
      class(region_t), intent(inout) :: self
      real(dp), intent(in) :: q(:)
      integer, intent(out) :: n_rows
      real(dp), intent(inout) :: r(:), j(:, :)
      !> Receives the sum of the costs of all rows.
      real(dp), intent(out) :: cost
      logical, intent(out) :: is_valid
      real(dp) :: plain(size(q)), by_free(size(q))
      integer :: k

      n_rows = 0
      cost = 0
      call leave_region(self, q, plain, is_valid)
      if (.not. is_valid) return
      call self%objective%evaluate(plain, n_rows, r, j, cost, is_valid)
      if (.not. is_valid) return
      by_free = last_slopes(self%objective, self%fold)
      associate (p => self%pivot, e => 1/self%power)
         j(:n_rows, p) = j(:n_rows, p)/by_free(p)
         do k = 1, size(q)
            if (k /= p) j(:n_rows, k) = j(:n_rows, k) - by_free(k)*j(:n_rows, p)
         end do
         j(:n_rows, p) = -self%unit*e*q(p)**(e - 1)*j(:n_rows, p)
      end associate
   end subroutine evaluate

end module adfric_fit_fold_region

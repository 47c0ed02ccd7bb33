! SPDX-License-Identifier: GPL-3.0-or-later
!> Sums of squares whose minima are known, and GSL's search for them.
module trial_squares
   use, intrinsic :: iso_c_binding, only: c_ptr, c_int, c_size_t, c_double, c_funptr, c_funloc, c_loc, c_null_ptr, c_null_funptr
   use adfric_base_kinds, only: dp
   use adfric_numerics_bounded_least_squares, only: least_squares_t
   implicit none (type, external)
   private
   public :: trial_squares_t, rosenbrock, decay, broken, straight, combined, kinked, gsl_minimum

   integer, parameter :: rosenbrock = 1, decay = 2, broken = 3, straight = 4, combined = 5, kinked = 6
   !> Points of the decay, and what was measured there.
   integer, parameter :: n_decay = 30

   !> One of these sums, whose numbers may have other units.
   type, extends(least_squares_t) :: trial_squares_t
      integer :: kind = rosenbrock
      real(dp) :: unit = 1
      !> Size of the round-off of the sum, as a part of it.
      real(dp) :: round_off = 0
      !> Calls that had no value.
      integer :: n_refused = 0
   contains
      procedure :: evaluate
   end type trial_squares_t

   type, bind(c) :: fdf_t
      type(c_funptr) :: f = c_null_funptr, df = c_null_funptr, fvv = c_null_funptr
      integer(c_size_t) :: n = 0, p = 0
      type(c_ptr) :: params = c_null_ptr
      integer(c_size_t) :: nevalf = 0, nevaldf = 0, nevalfvv = 0
   end type fdf_t

   interface
      integer(c_int) function fit_by_gsl(fdf, x) bind(c)
         import :: c_ptr, c_int
         implicit none (type, external)
         type(c_ptr), value :: fdf, x
      end function fit_by_gsl

      real(c_double) function gsl_vector_get(v, i) bind(c)
         import :: c_ptr, c_size_t, c_double
         implicit none (type, external)
         type(c_ptr), value :: v
         integer(c_size_t), value :: i
      end function gsl_vector_get

      subroutine gsl_vector_set(v, i, x) bind(c)
         import :: c_ptr, c_size_t, c_double
         implicit none (type, external)
         type(c_ptr), value :: v
         integer(c_size_t), value :: i
         real(c_double), value :: x
      end subroutine gsl_vector_set

      subroutine gsl_matrix_set(m, i, j, x) bind(c)
         import :: c_ptr, c_size_t, c_double
         implicit none (type, external)
         type(c_ptr), value :: m
         integer(c_size_t), value :: i, j
         real(c_double), value :: x
      end subroutine gsl_matrix_set
   end interface

contains

   !> See `least_squares_t`.
   subroutine evaluate(self, q, n_rows, r, j, cost, is_valid)
      class(trial_squares_t), intent(inout) :: self
      real(dp), intent(in) :: q(:)
      integer, intent(out) :: n_rows
      real(dp), intent(inout) :: r(:), j(:, :)
      real(dp), intent(out) :: cost
      logical, intent(out) :: is_valid
      real(dp) :: x(size(q)), t
      integer :: i

      x = q*self%unit
      is_valid = .true.
      n_rows = 2
      select case (self%kind)
      case (rosenbrock)
         r(:2) = [10*(x(2) - x(1)**2), 1 - x(1)]
         j(:2, 1) = [-20*x(1), -1.0_dp]
         j(:2, 2) = [10.0_dp, 0.0_dp]
      case (decay)
         n_rows = n_decay
         do i = 1, n_decay
            t = 0.1_dp*i
            r(i) = x(1)*exp(-x(2)*t) + x(3) - measured(i)
            j(i, :) = [exp(-x(2)*t), -x(1)*t*exp(-x(2)*t), 1.0_dp]
         end do
      case (broken)
         ! the root of a negative number
         is_valid = x(1) > 0
         if (.not. is_valid) self%n_refused = self%n_refused + 1
         r(:2) = [sqrt(max(x(1), 0.0_dp)) - 0.001_dp, x(2) - 3]
         j(:2, 1) = [0.5_dp/sqrt(max(x(1), tiny(x))), 0.0_dp]
         j(:2, 2) = [0.0_dp, 1.0_dp]
      case (straight)
         r(:2) = [x(1) + 2*x(2) - 3, 3*x(1) - x(2) - 2]
         j(:2, 1) = [1.0_dp, 3.0_dp]
         j(:2, 2) = [2.0_dp, -1.0_dp]
      case (kinked)
         r(:2) = [3 + abs(x(1)), x(2) - 3]
         j(:2, 1) = [sign(1.0_dp, x(1)), 0.0_dp]
         j(:2, 2) = [0.0_dp, 1.0_dp]
      case default
         ! only the sum of both is seen
         n_rows = 3
         r(:3) = [x(1) + x(2) - 1, 2*(x(1) + x(2)) - 4, 3*(x(1) + x(2))]
         j(:3, 1) = [1.0_dp, 2.0_dp, 3.0_dp]
         j(:3, 2) = j(:3, 1)
      end select
      j(:n_rows, :) = j(:n_rows, :)*self%unit
      cost = sum(r(:n_rows)**2)
      cost = cost*(1 + self%round_off*sin(1.0e9_dp*sum(x)))
   end subroutine evaluate

   !> What was measured of the decay: values with a pattern for noise.
   pure real(dp) function measured(i)
      integer, intent(in) :: i

      measured = 5*exp(-0.15_dp*i) + 1 + 0.1_dp*sin(7.0_dp*i)
   end function measured

   !> The minimum of the decay by GSL, from a start.
   subroutine gsl_minimum(x, is_found)
      real(dp), intent(inout), target :: x(3)
      logical, intent(out) :: is_found
      type(fdf_t), target :: fdf

      fdf%f = c_funloc(gsl_residuals)
      fdf%df = c_funloc(gsl_derivatives)
      fdf%n = n_decay
      fdf%p = 3
      is_found = fit_by_gsl(c_loc(fdf), c_loc(x)) == 0
   end subroutine gsl_minimum

   !> Residuals as GSL asks for them.
   integer(c_int) function gsl_residuals(x, params, f) bind(c)
      type(c_ptr), value :: x, params, f
      real(dp) :: r(n_decay), j(n_decay, 3)

      call at(x, r, j)
      call put(f, r)
      gsl_residuals = 0
      associate (unused => params)
      end associate
   end function gsl_residuals

   !> Derivatives as GSL asks for them.
   integer(c_int) function gsl_derivatives(x, params, df) bind(c)
      type(c_ptr), value :: x, params, df
      real(dp) :: r(n_decay), j(n_decay, 3)
      integer(c_size_t) :: i, k

      call at(x, r, j)
      do k = 1, 3
         do i = 1, n_decay
            call gsl_matrix_set(df, i - 1, k - 1, j(i, k))
         end do
      end do
      gsl_derivatives = 0
      associate (unused => params)
      end associate
   end function gsl_derivatives

   !> The decay at a vector of GSL.
   subroutine at(x, r, j)
      type(c_ptr), intent(in) :: x
      real(dp), intent(out) :: r(:), j(:, :)
      type(trial_squares_t) :: squares
      real(dp) :: cost
      integer :: n
      integer(c_size_t) :: k
      logical :: is_valid

      squares%kind = decay
      call squares%evaluate([(gsl_vector_get(x, k), k=0, 2)], n, r, j, cost, is_valid)
   end subroutine at

   !> Put numbers into a vector of GSL.
   subroutine put(f, r)
      type(c_ptr), intent(in) :: f
      real(dp), intent(in) :: r(:)
      integer(c_size_t) :: i

      do i = 1, size(r)
         call gsl_vector_set(f, i - 1, r(i))
      end do
   end subroutine put

end module trial_squares

! SPDX-License-Identifier: GPL-3.0-or-later
!> GSL's hybrid solver without derivatives (gsl_multiroot_fsolver_hybrids), for comparison only.
module gsl_multiroot
   use, intrinsic :: iso_c_binding, only: c_ptr, c_funptr, c_int, c_size_t, c_double, c_funloc, c_loc, c_f_pointer, c_null_ptr, &
      c_null_funptr
   use adfric_base_kinds, only: dp
   use plain_edges, only: edges_t, get_residuals
   implicit none (type, external)
   private
   public :: solver_t, new_solver, free_solver, solve_edges, gsl_set_error_handler_off

   integer(c_int), parameter :: success = 0, go_on = -2
   integer, parameter :: max_iterations = 200

   !> A solver of n equations, made once and used for many strips.
   type :: solver_t
      private
      type(c_ptr) :: solver = c_null_ptr, start = c_null_ptr
      integer(c_size_t) :: n = 0
   end type solver_t

   type, bind(c) :: gsl_function_t
      type(c_funptr) :: f = c_null_funptr
      integer(c_size_t) :: n = 0
      type(c_ptr) :: params = c_null_ptr
   end type gsl_function_t

   type, bind(c) :: gsl_vector_t
      integer(c_size_t) :: size = 0, stride = 1
      type(c_ptr) :: data = c_null_ptr, block = c_null_ptr
      integer(c_int) :: owner = 0
   end type gsl_vector_t

   interface
      !> The solver reports what it cannot do by a status; GSL's own handler would end the program.
      type(c_funptr) function gsl_set_error_handler_off() bind(c)
         import :: c_funptr
         implicit none (type, external)
      end function gsl_set_error_handler_off

      type(c_ptr) function new_gsl_hybrids(n) bind(c)
         import :: c_ptr, c_size_t
         implicit none (type, external)
         integer(c_size_t), value :: n
      end function new_gsl_hybrids

      subroutine gsl_multiroot_fsolver_free(solver) bind(c)
         import :: c_ptr
         implicit none (type, external)
         type(c_ptr), value :: solver
      end subroutine gsl_multiroot_fsolver_free

      integer(c_int) function gsl_multiroot_fsolver_set(solver, f, x) bind(c)
         import :: c_ptr, c_int
         implicit none (type, external)
         type(c_ptr), value :: solver, f, x
      end function gsl_multiroot_fsolver_set

      integer(c_int) function gsl_multiroot_fsolver_iterate(solver) bind(c)
         import :: c_ptr, c_int
         implicit none (type, external)
         type(c_ptr), value :: solver
      end function gsl_multiroot_fsolver_iterate

      type(c_ptr) function gsl_multiroot_fsolver_root(solver) bind(c)
         import :: c_ptr
         implicit none (type, external)
         type(c_ptr), value :: solver
      end function gsl_multiroot_fsolver_root

      type(c_ptr) function gsl_multiroot_fsolver_f(solver) bind(c)
         import :: c_ptr
         implicit none (type, external)
         type(c_ptr), value :: solver
      end function gsl_multiroot_fsolver_f

      integer(c_int) function gsl_multiroot_test_residual(f, tolerance) bind(c)
         import :: c_ptr, c_int, c_double
         implicit none (type, external)
         type(c_ptr), value :: f
         real(c_double), value :: tolerance
      end function gsl_multiroot_test_residual

      type(c_ptr) function gsl_vector_alloc(n) bind(c)
         import :: c_ptr, c_size_t
         implicit none (type, external)
         integer(c_size_t), value :: n
      end function gsl_vector_alloc

      subroutine gsl_vector_free(vector) bind(c)
         import :: c_ptr
         implicit none (type, external)
         type(c_ptr), value :: vector
      end subroutine gsl_vector_free
   end interface

contains

   !> Make a solver of n equations.
   subroutine new_solver(self, n)
      type(solver_t), intent(out) :: self
      integer, intent(in) :: n

      self%n = n
      self%solver = new_gsl_hybrids(self%n)
      self%start = gsl_vector_alloc(self%n)
   end subroutine new_solver

   subroutine free_solver(self)
      type(solver_t), intent(inout) :: self

      call gsl_multiroot_fsolver_free(self%solver)
      call gsl_vector_free(self%start)
      self = solver_t()
   end subroutine free_solver

   !> Solve the edge equations from the edges in x.
   subroutine solve_edges(self, edges, tolerance, x, is_converged)
      type(solver_t), intent(in) :: self
      type(edges_t), intent(in), target :: edges
      !> Of the sum of the sizes of the residuals.
      real(dp), intent(in) :: tolerance
      real(dp), intent(inout) :: x(:)
      logical, intent(out) :: is_converged
      type(gsl_function_t), target :: equations
      real(dp), pointer :: values(:)
      integer(c_int) :: status
      integer :: k

      call view(self%start, values)
      values = x
      equations = gsl_function_t(c_funloc(evaluate), self%n, c_loc(edges))
      status = gsl_multiroot_fsolver_set(self%solver, c_loc(equations), self%start)
      do k = 1, max_iterations
         if (status /= success) exit
         status = gsl_multiroot_fsolver_iterate(self%solver)
         if (status /= success) exit
         status = gsl_multiroot_test_residual(gsl_multiroot_fsolver_f(self%solver), tolerance)
         if (status /= go_on) exit
         status = success
         if (k == max_iterations) status = go_on
      end do
      call view(gsl_multiroot_fsolver_root(self%solver), values)
      x = values
      is_converged = status == success .and. all(abs(x) < huge(x))
   end subroutine solve_edges

   !> The residuals, as GSL calls for them.
   integer(c_int) function evaluate(x, params, f) bind(c) result(status)
      type(c_ptr), value :: x, params, f
      type(edges_t), pointer :: edges
      real(dp), pointer :: unknowns(:), residuals(:)

      call c_f_pointer(params, edges)
      call view(x, unknowns)
      call view(f, residuals)
      call get_residuals(edges, unknowns, residuals)
      status = success
   end function evaluate

   !> The elements of a GSL vector of stride 1.
   subroutine view(vector, elements)
      type(c_ptr), intent(in) :: vector
      real(dp), pointer, intent(out) :: elements(:)
      type(gsl_vector_t), pointer :: contents

      call c_f_pointer(vector, contents)
      call c_f_pointer(contents%data, elements, [contents%size])
   end subroutine view

end module gsl_multiroot

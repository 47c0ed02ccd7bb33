! SPDX-License-Identifier: GPL-3.0-or-later
!> Points of a measured curve as any model sees them: ordinates at abscissas, and the fold, where contact ends.
!>
!> A model that knows its pull-off (results `pull_off_load` and `pull_off_approach`) has no contact at an abscissa below that of the fold.
!> A point of contact there has the ordinate of the fold, whatever the model says of bodies apart: so the ordinate is a continuous
!> function of abscissa and variables. Without adhesion the fold is touch, with load 0.
module adfric_fit_model_points
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_fit_path, only: sphere_path_t, set_path
   use adfric_fit_problem, only: free_t
   use adfric_fit_sphere_basis, only: basis_t, set_basis
   use adfric_describe_model, only: model_t
   use adfric_describe_of_fits, only: is_abscissa_of_fits
   use adfric_describe_status, only: status_solved
   use adfric_round_sphere_contact, only: theory_hertz
   implicit none (type, external)
   private
   public :: model_points_t, new_model_points, fold_t, is_beyond_fold

   !> Regime of a point beyond the fold, and of one that has no solution.
   integer, parameter :: regime_beyond = huge(1)
   integer, parameter, public :: regime_none = -1
   !> Least and largest error that a result is taken to have.
   real(dp), parameter :: least_error = 1.0e-13_dp, largest_error = 1.0e-4_dp
   !> Points that the model is asked for at once.
   integer, parameter :: most_at_once = 1024, most_of_history = 1000000000
   !> Distance from the fold, as a part of its abscissa, from which an ordinate at the fold is extrapolated.
   real(dp), parameter :: beside_fold = 1.0e-10_dp

   !> Where contact ends.
   type :: fold_t
      !> Does the model know it?
      logical :: is_known = .false.
      !> Abscissa and ordinate.
      real(dp) :: x = 0, y = 0
   end type fold_t

   !> What is asked of the model.
   type :: model_points_t
      !> The model.
      class(model_t), pointer :: model => null()
      !> Positions of abscissa and ordinate, and of the result `regime`; 0: none.
      integer :: abscissa = 0, ordinate = 0, regime = 0
      !> Positions of the results that say where the fold is, and of the variable that is the stiffness of a spring; 0: none.
      integer :: pull_off_load = 0, pull_off_approach = 0, spring = 0
      !> Position of the result `pull_off_load`, for events.
      integer :: pull_off_result = 0
      !> Is the abscissa a load, and is the ordinate one?
      logical :: is_by_load = .false., is_load = .false.
      !> Is it the approach of a smooth sphere, whose fold has a closed form?
      logical :: is_sphere = .false.
      !> Points that the model is asked for at once: all, where they are those of one history.
      integer :: most = most_at_once
      !> Is the abscissa one of fits alone, over which a model may have derivatives in closed form?
      logical :: is_of_fits = .false.
   contains
      procedure :: ask
      procedure :: ask_with_slopes
      procedure :: find_fold
   end type model_points_t

contains

   !> Take the model, the abscissa and the ordinate.
   subroutine new_model_points(self, model, base, abscissa, ordinate, is_sphere)
      type(model_points_t), intent(out) :: self
      class(model_t), pointer, intent(in) :: model
      !> Values of all variables of the model; those of free ones have no meaning.
      real(dp), intent(in) :: base(:)
      !> Positions of the abscissa in the variables, and of the ordinate in the results.
      integer, intent(in) :: abscissa, ordinate
      !> Is it a smooth sphere, as `adfric_fit_path` has it?
      logical, intent(in) :: is_sphere
      integer :: k, branch

      self%model => model
      self%abscissa = abscissa
      self%ordinate = ordinate
      self%is_by_load = model%variables(abscissa)%name == 'load'
      self%is_load = model%results(ordinate)%name == 'load'
      do k = 1, size(model%results)
         select case (model%results(k)%name)
         case ('regime')
            self%regime = k
         case ('pull_off_load')
            self%pull_off_load = k
         case ('pull_off_approach')
            self%pull_off_approach = k
         end select
      end do
      self%pull_off_result = self%pull_off_load
      branch = model%index_of('operating', 'branch')
      if (branch > 0) then
         if (nint(base(branch)) /= 1) self%pull_off_load = 0
      end if
      select case (model%variables(abscissa)%name)
      case ('load', 'approach')
      case ('base_approach')
         self%spring = model%index_of('operating', 'machine_stiffness')
      case default
         self%pull_off_load = 0
      end select
      self%is_of_fits = is_abscissa_of_fits(model%variables(abscissa))
      if (self%is_of_fits) self%most = most_of_history
      self%is_sphere = is_sphere .and. model%variables(abscissa)%name == 'approach'
   end subroutine new_model_points

   !> Is a regime that of a point beyond the fold?
   elemental logical function is_beyond_fold(regime)
      integer, intent(in) :: regime

      is_beyond_fold = regime == regime_beyond
   end function is_beyond_fold

   !> Ask the model for the ordinates at abscissas.
   subroutine ask(self, values, x, y, regimes, error, fold)
      class(model_points_t), intent(in) :: self
      real(dp), intent(in) :: values(:), x(:)
      real(dp), intent(out) :: y(:)
      !> Receives the regimes, 0 where the model has none, -1 where there is no solution.
      integer, intent(out) :: regimes(:)
      !> Receives the relative error of a result: the largest one, or the mean where there is a fold, beside which it is large.
      real(dp), intent(out) :: error
      type(fold_t), intent(out) :: fold
      real(dp), allocatable :: errors(:)
      real(dp) :: found(size(self%model%results))
      integer :: first, last, n_solved

      allocate (errors(size(x)), source=0.0_dp)
      y = 0
      regimes = regime_none
      error = least_error
      if (size(x) == 0) return
      if (self%is_sphere) call find_sphere_fold(values, fold)
      last = min(self%most, size(x))
      call ask_block(self, values, x(:last), y(:last), regimes(:last), errors(:last), found)
      if (.not. self%is_sphere) call read_fold(self, values, found, fold)
      !$omp parallel do schedule(dynamic) private(last, found) if (size(x)/2 > self%most)
      do first = self%most + 1, size(x), self%most
         last = min(first + self%most - 1, size(x))
         call ask_block(self, values, x(first:last), y(first:last), regimes(first:last), errors(first:last), found)
      end do
      !$omp end parallel do
      if (fold%is_known) then
         where (.not. x > fold%x) regimes = regime_beyond
      end if
      where (is_beyond_fold(regimes) .or. .not. ieee_is_finite(errors)) errors = 0
      n_solved = count(regimes /= regime_none .and. regimes /= regime_beyond)
      error = min(max(maxval(errors), least_error), largest_error)
      if (.not. fold%is_known) return
      if (n_solved > 0) error = min(max(sum(errors)/n_solved, least_error), largest_error)
      if (any(is_beyond_fold(regimes))) call find_ordinate(self, values, fold)
      where (is_beyond_fold(regimes)) y = fold%y
   end subroutine ask

   !> Ask the model for the ordinates at abscissas with derivatives by the free variables, where it has them in closed form.
   subroutine ask_with_slopes(self, values, x, frees, slopes, y, y_by, is_known, error, is_there)
      class(model_points_t), intent(in) :: self
      real(dp), intent(in) :: values(:), x(:)
      type(free_t), intent(in) :: frees(:)
      !> Derivatives of the variables by the numbers that are fitted; shape `(n_free)`.
      real(dp), intent(in) :: slopes(:)
      real(dp), intent(out) :: y(:)
      !> Receives derivatives by the numbers that are fitted, 0 where they are not known; shape `(n_points, n_free)`.
      real(dp), intent(out) :: y_by(:, :)
      !> Receives for which free variables they are known.
      logical, intent(out) :: is_known(:)
      !> Receives the relative error of an ordinate.
      real(dp), intent(out) :: error
      !> Receives whether there is a closed form; without one nothing else has a meaning.
      logical, intent(out) :: is_there
      integer :: k

      call self%model%solve_with_slopes(values, x, self%ordinate, frees%variable, [(0, k=1, size(frees))], y, y_by, is_known, &
         & error, is_there)
      is_there = is_there .and. all(ieee_is_finite(y)) .and. all(ieee_is_finite(y_by))
      error = min(max(error, least_error), largest_error)
      do k = 1, size(frees)
         y_by(:, k) = y_by(:, k)*slopes(k)
      end do
   end subroutine ask_with_slopes

   !> Ask the model for the ordinates of a block; what stands in other blocks does not matter.
   subroutine ask_block(self, values, x, y, regimes, errors, first)
      class(model_points_t), intent(in) :: self
      real(dp), intent(in) :: values(:), x(:)
      !> In: 0 and `regime_none`. Out: ordinates and regimes of the points that have a solution.
      real(dp), intent(inout) :: y(:)
      integer, intent(inout) :: regimes(:)
      !> Receives the relative errors of the solutions; 0 without one.
      real(dp), intent(out) :: errors(:)
      !> Receives all results of the first point.
      real(dp), intent(out) :: first(:)
      real(dp), allocatable :: all_values(:, :), results(:, :)
      real(dp) :: counts(size(self%model%counts))
      integer :: status(size(x)), k

      allocate (all_values(size(values), size(x)), results(size(self%model%results), size(x)))
      do k = 1, size(x)
         all_values(:, k) = values
         all_values(self%abscissa, k) = x(k)
      end do
      call self%model%solve_block(all_values, results, errors, status, counts)
      first = results(:, 1)
      do k = 1, size(x)
         if (status(k) == status_solved .and. ieee_is_finite(results(self%ordinate, k))) then
            y(k) = results(self%ordinate, k)
            regimes(k) = 0
            if (self%regime > 0) regimes(k) = nint(results(self%regime, k))
         else
            errors(k) = 0
         end if
      end do
   end subroutine ask_block

   !> The fold alone.
   subroutine find_fold(self, values, fold)
      class(model_points_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(fold_t), intent(out) :: fold
      real(dp) :: all_values(size(values), 1), results(size(self%model%results), 1), error_estimate(1), &
         & counts(size(self%model%counts))
      integer :: status(1)

      if (self%is_sphere) then
         call find_sphere_fold(values, fold)
         call find_ordinate(self, values, fold)
      else if (self%pull_off_load > 0) then
         all_values(:, 1) = values
         all_values(self%abscissa, 1) = 0
         call self%model%solve_block(all_values, results, error_estimate, status, counts)
         call read_fold(self, values, results(:, 1), fold)
         if (fold%is_known) call find_ordinate(self, values, fold)
      end if
   end subroutine find_fold

   !> The fold that the results of a point name: load and approach at which contact separates.
   pure subroutine read_fold(self, values, results, fold)
      class(model_points_t), intent(in) :: self
      real(dp), intent(in) :: values(:), results(:)
      type(fold_t), intent(inout) :: fold

      fold%is_known = self%pull_off_load > 0 .and. self%pull_off_approach > 0
      if (.not. fold%is_known) return
      associate (load => results(self%pull_off_load), approach => results(self%pull_off_approach))
         fold%is_known = ieee_is_finite(load) .and. ieee_is_finite(approach)
         if (.not. fold%is_known) return
         fold%x = approach
         if (self%is_by_load) fold%x = load
         if (self%spring > 0) fold%x = approach + load/values(self%spring)
         fold%y = load
         if (self%model%results(self%ordinate)%name == 'approach') fold%y = approach
      end associate
   end subroutine read_fold

   !> An ordinate at the fold that no result names: near it the ordinate is a straight line over the root of the distance.
   subroutine find_ordinate(self, values, fold)
      class(model_points_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(fold_t), intent(inout) :: fold
      real(dp) :: all_values(size(values), 2), results(size(self%model%results), 2), error_estimate(2), &
         & counts(size(self%model%counts)), size_of
      integer :: status(2)

      if (self%is_load .or. self%model%results(self%ordinate)%name == 'approach') return
      size_of = abs(fold%x)
      fold%y = 0
      if (.not. size_of > 0) return
      all_values(:, 1) = values
      all_values(:, 2) = values
      all_values(self%abscissa, :) = fold%x + beside_fold*size_of*[1, 4]
      call self%model%solve_block(all_values, results, error_estimate, status, counts)
      fold%is_known = all(status == status_solved) .and. all(ieee_is_finite(results(self%ordinate, :)))
      if (fold%is_known) fold%y = 2*results(self%ordinate, 1) - results(self%ordinate, 2)
   end subroutine find_ordinate

   !> The fold of a sphere under a given approach. DMT ends at touch with its pull.
   pure subroutine find_sphere_fold(values, fold)
      !> Values of all variables of the model `sphere`.
      real(dp), intent(in) :: values(:)
      type(fold_t), intent(inout) :: fold
      type(basis_t) :: basis
      type(sphere_path_t) :: path
      type(free_t) :: none(0)
      real(dp) :: no_slopes(0)

      call set_basis(basis, values, none, no_slopes)
      call set_path(path, basis%theory, .true., basis%lambda, 0.0_dp)
      fold%is_known = .true.
      fold%x = basis%approach*path%prescribed_at_fold
      fold%y = basis%force*path%fold%p
      if (basis%theory == theory_hertz) fold%y = 0
   end subroutine find_sphere_fold

end module adfric_fit_model_points

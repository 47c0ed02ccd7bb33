! SPDX-License-Identifier: GPL-3.0-or-later
!> Ordinates of any model and their derivatives by differences, with or without a fold; in closed form where the model has it.
!>
!> Above the fold x_f a point is a position s = sqrt(d), d = x - x_f. Ordinates are smooth over s, and at a given x near the fold
!> they are not: y is about y_f + c s. So a variable v is moved at a fixed position, and the position at fixed variables:
!>
!>     dy/dv at x = dy/dv at d - y_x dx_f/dv,    y_x = y_s/(2 s).
!>
!> A point beyond the fold has the ordinate of the fold.
module adfric_fit_model_slopes
   use adfric_base_kinds, only: dp
   use adfric_fit_model_points, only: model_points_t, fold_t, is_beyond_fold, regime_none
   use adfric_fit_problem, only: free_t
   implicit none (type, external)
   private
   public :: slopes_t, set_slopes

   !> Ordinates at abscissas, and their derivatives. `n` points, `n_free` free variables.
   type :: slopes_t
      !> Ordinates, and their derivatives by the abscissa; shape `(n)`.
      real(dp), allocatable :: y(:), y_x(:)
      !> Regimes; shape `(n)`.
      integer, allocatable :: regimes(:)
      !> The fold, and derivatives of its abscissa by the numbers that are fitted.
      type(fold_t) :: fold
      !> Derivatives of the fold's abscissa; shape `(n_free)`.
      real(dp), allocatable :: fold_x_by(:)
      !> Derivatives of the ordinates by the numbers that are fitted, at a given abscissa and at a given position; shape `(n,
      !> n_free)`.
      real(dp), allocatable :: by(:, :), by_at_position(:, :)
      !> Derivatives of the abscissas at a given position; shape `(n, n_free)`.
      real(dp), allocatable :: x_by_at_position(:, :)
      !> Derivatives of abscissa and ordinate by the position; shape `(n)`.
      real(dp), allocatable :: x_s(:), y_s(:)
      !> Relative error of the derivatives.
      real(dp) :: derivative_error = 0
   end type slopes_t

   !> Steps of a position are those of one of at least this part of the largest one.
   real(dp), parameter :: least_position = 0.01_dp

contains

   !> Find ordinates and derivatives.
   subroutine set_slopes(of, points, values, x, size_of_x, frees, slopes, is_central, wants_x, is_valid)
      type(slopes_t), intent(out) :: of
      type(model_points_t), intent(in) :: points
      real(dp), intent(in) :: values(:), x(:)
      !> Size of the abscissas, for steps.
      real(dp), intent(in) :: size_of_x
      type(free_t), intent(in) :: frees(:)
      real(dp), intent(in) :: slopes(:)
      logical, intent(in) :: is_central, wants_x
      !> Has the model a value at all points?
      logical, intent(out) :: is_valid
      real(dp) :: e, h
      logical :: is_known(size(slopes))
      integer :: k, n

      n = size(x)
      allocate (of%y(n), of%regimes(n))
      allocate (of%y_x(n), of%x_s(n), of%y_s(n), of%fold_x_by(size(slopes)), source=0.0_dp)
      allocate (of%by(n, size(slopes)), of%by_at_position(n, size(slopes)), of%x_by_at_position(n, size(slopes)), source=0.0_dp)
      is_known = .false.
      is_valid = points%is_of_fits .and. n > 0
      if (is_valid) call points%ask_with_slopes(values, x, frees, slopes, of%y, of%by, is_known, e, is_valid)
      if (is_valid) then
         of%regimes = 0
      else
         is_known = .false.
         of%by = 0
         call points%ask(values, x, of%y, of%regimes, e, of%fold)
      end if
      is_valid = all(of%regimes >= 0)
      if (.not. is_valid) return
      h = merge(e**(1.0_dp/3), sqrt(e), is_central)
      of%derivative_error = merge(e**(2.0_dp/3), sqrt(e), is_central)
      if (all(is_known .or. frees%variable == 0)) of%derivative_error = e
      do k = 1, size(slopes)
         if (frees(k)%variable == 0 .or. is_known(k)) cycle
         if (of%fold%is_known) then
            call move_variable(of, points, values, x, frees(k)%variable, k, slopes(k), h, is_central, is_valid)
         else
            call differentiate(of, points, values, x, size_of_x, frees(k)%variable, slopes(k), h, is_central, of%by(:, k), is_valid)
         end if
         if (.not. is_valid) return
      end do
      if (of%fold%is_known) then
         if (wants_x .or. any(abs(of%fold_x_by) > 0)) call move_positions(of, points, values, x, h, is_central, is_valid)
         do k = 1, size(slopes)
            of%by(:, k) = of%by_at_position(:, k) - of%y_x*of%fold_x_by(k)
         end do
      else
         if (wants_x) call differentiate(of, points, values, x, size_of_x, 0, 1.0_dp, h, is_central, of%y_x, is_valid)
         of%by_at_position = of%by
         of%x_s = 1
         of%y_s = of%y_x
      end if
   end subroutine set_slopes

   !> Derivatives by a variable at given positions.
   subroutine move_variable(of, points, values, x, variable, free, slope, h, is_central, is_valid)
      !> In: with ordinates and fold. Out: with the derivatives by the variable.
      type(slopes_t), intent(inout) :: of
      type(model_points_t), intent(in) :: points
      real(dp), intent(in) :: values(:), x(:)
      !> Position of the variable in the model's table, and its number among the free ones.
      integer, intent(in) :: variable, free
      !> Derivative of the variable by the number that is fitted.
      real(dp), intent(in) :: slope
      !> Relative step.
      real(dp), intent(in) :: h
      logical, intent(in) :: is_central
      logical, intent(out) :: is_valid
      real(dp) :: above(size(x)), below(size(x)), up, down
      type(fold_t) :: fold_above, fold_below
      logical :: has_above, has_below

      call shift(h, above, fold_above, up, has_above)
      has_below = .false.
      below = of%y
      fold_below = of%fold
      down = 0
      if (is_central .or. .not. has_above) call shift(-h, below, fold_below, down, has_below)
      is_valid = has_above .or. has_below
      if (.not. is_valid) return
      if (.not. has_above) then
         above = of%y
         fold_above = of%fold
         up = 0
      else if (.not. has_below) then
         below = of%y
         fold_below = of%fold
         down = 0
      end if
      of%by_at_position(:, free) = (above - below)/(up - down)*slope
      of%fold_x_by(free) = (fold_above%x - fold_below%x)/(up - down)*slope
      of%x_by_at_position(:, free) = of%fold_x_by(free)

   contains

      !> Ordinates at the same positions, with the variable moved as far as the table of the model lets it go.
      subroutine shift(part, shifted, fold, step, is_there)
         !> The relative step.
         real(dp), intent(in) :: part
         !> Receives the ordinates.
         real(dp), intent(out) :: shifted(:)
         type(fold_t), intent(out) :: fold
         real(dp), intent(out) :: step
         !> Has the model a value at all positions?
         logical, intent(out) :: is_there
         real(dp) :: moved(size(values))

         moved = values
         moved(variable) = values(variable) + part*max(abs(values(variable)), abs(slope))
         step = moved(variable) - values(variable)
         shifted = 0
         is_there = moved(variable) >= points%model%variables(variable)%lower &
            & .and. moved(variable) <= points%model%variables(variable)%upper
         if (.not. is_there) return
         call points%find_fold(moved, fold)
         is_there = fold%is_known
         if (is_there) call ask_positions(of, points, moved, x - of%fold%x, fold, shifted, is_there)
      end subroutine shift

   end subroutine move_variable

   !> Derivatives by the positions.
   subroutine move_positions(of, points, values, x, h, is_central, is_valid)
      !> In: with ordinates and fold. Out: with the derivatives by position and abscissa.
      type(slopes_t), intent(inout) :: of
      type(model_points_t), intent(in) :: points
      real(dp), intent(in) :: values(:), x(:), h
      logical, intent(in) :: is_central
      logical, intent(out) :: is_valid
      real(dp), dimension(size(x)) :: s, step, above, below, down

      s = sqrt(max(x - of%fold%x, 0.0_dp))
      step = h*max(s, least_position*maxval(s))
      call ask_positions(of, points, values, (s + step)**2, of%fold, above, is_valid)
      if (.not. is_valid) return
      below = of%y
      down = 0
      if (is_central) then
         down = merge(step, 0.0_dp, s > 2*step)
         call ask_positions(of, points, values, (s - down)**2, of%fold, below, is_valid)
         if (.not. is_valid) return
      end if
      where (is_beyond_fold(of%regimes))
         of%x_s = 1
      elsewhere
         of%y_s = (above - below)/(step + down)
         of%x_s = 2*s
         of%y_x = of%y_s/(2*s)
      end where
   end subroutine move_positions

   !> Ordinates at given distances from a fold; those beyond it have that of the fold.
   subroutine ask_positions(of, points, values, distances, fold, y, is_there)
      type(slopes_t), intent(in) :: of
      type(model_points_t), intent(in) :: points
      real(dp), intent(in) :: values(:), distances(:)
      type(fold_t), intent(in) :: fold
      real(dp), intent(out) :: y(:)
      logical, intent(out) :: is_there
      integer :: inside(count(.not. is_beyond_fold(of%regimes))), regimes(count(.not. is_beyond_fold(of%regimes))), k
      real(dp) :: found(count(.not. is_beyond_fold(of%regimes))), unused
      type(fold_t) :: other

      y = fold%y
      is_there = .true.
      inside = pack([(k, k=1, size(distances))], .not. is_beyond_fold(of%regimes))
      if (size(inside) == 0) return
      call points%ask(values, fold%x + distances(inside), found, regimes, unused, other)
      is_there = all(regimes >= 0)
      y(inside) = found
   end subroutine ask_positions

   !> Derivative of the ordinates by a variable, or by the abscissa, where there is no fold.
   subroutine differentiate(of, points, values, x, size_of_x, variable, slope, h, is_central, y_by, is_valid)
      type(slopes_t), intent(in) :: of
      type(model_points_t), intent(in) :: points
      real(dp), intent(in) :: values(:), x(:), size_of_x
      !> Position of the variable in the model's table; 0: the abscissa.
      integer, intent(in) :: variable
      real(dp), intent(in) :: slope, h
      logical, intent(in) :: is_central
      !> Receives the derivative.
      real(dp), intent(out) :: y_by(:)
      logical, intent(out) :: is_valid
      real(dp), dimension(size(x)) :: above, below
      integer, dimension(size(x)) :: above_regimes, below_regimes
      real(dp) :: up, down

      call shift(h, above, above_regimes, up)
      below_regimes = regime_none
      below = of%y
      down = 0
      if (is_central .or. any(above_regimes /= of%regimes)) call shift(-h, below, below_regimes, down)
      is_valid = all(max(above_regimes, below_regimes) >= 0)
      if (.not. is_valid) return
      where (above_regimes == of%regimes .and. below_regimes == of%regimes)
         y_by = (above - below)/(up - down)
      elsewhere (above_regimes == of%regimes .or. below_regimes < 0)
         y_by = (above - of%y)/up
      elsewhere
         y_by = (below - of%y)/down
      end where
      y_by = y_by*slope

   contains

      !> Ordinates at a step from the position, as far as the table of the model lets it go.
      subroutine shift(part, shifted, shifted_regimes, step)
         real(dp), intent(in) :: part
         real(dp), intent(out) :: shifted(:)
         integer, intent(out) :: shifted_regimes(:)
         !> Receives the step of the variable.
         real(dp), intent(out) :: step
         real(dp) :: moved(size(values)), unused
         type(fold_t) :: fold

         moved = values
         if (variable == 0) then
            step = part*size_of_x
            call points%ask(values, x + step, shifted, shifted_regimes, unused, fold)
            return
         end if
         moved(variable) = values(variable) + part*max(abs(values(variable)), abs(slope))
         step = moved(variable) - values(variable)
         if (moved(variable) < points%model%variables(variable)%lower &
            & .or. moved(variable) > points%model%variables(variable)%upper) then
            shifted_regimes = regime_none
            shifted = 0
            return
         end if
         call points%ask(moved, x, shifted, shifted_regimes, unused, fold)
      end subroutine shift

   end subroutine differentiate

end module adfric_fit_model_slopes

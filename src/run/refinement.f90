! SPDX-License-Identifier: GPL-3.0-or-later
!> The refinement of a sweep where a result jumps or bends, or where there is an equilibrium on one side only.
!>
!> An interval between two values is halved as long as it is wider than the tolerance and
!>
!> - one of its ends is solved and the other has no equilibrium, or one has the result and the other has not, or
!> - the result is a state, and differs at its ends, or
!> - the result at one of its ends lies off the straight line through the two neighbours of that end by more than `resolution` of
!>   the range that the result has at the values with which the sweep begins.
!>
!> All intervals that need it are halved at once, then looked at again. Each point is solved by itself, so that the values do not
!> depend on threads or on what is solved beside. A jump is found if the result differs at two values with which the sweep begins;
!> two jumps between two of them may cancel, and are not seen then.
module adfric_run_refinement
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use, intrinsic :: iso_fortran_env, only: int8
   use adfric_base_error, only: error_t, set_error, file_failure, input_failure
   use adfric_base_kinds, only: dp, i8
   use adfric_base_text, only: show_count, show_number
   use adfric_describe_model, only: model_t
   use adfric_describe_status, only: status_no_equilibrium, status_not_converged, status_out_of_memory, status_solved
   use adfric_run_agreement, only: share_error
   use adfric_run_plan, only: axis_t
   use adfric_run_world, only: world_t
   implicit none (type, external)
   private
   public :: refinement_t, refine, refine_together

   !> How a sweep is refined.
   type :: refinement_t
      !> Index of the result in the model's table; 0: nothing is refined.
      integer :: result = 0
      !> Width of an interval that is not halved any more, in units of the whole sweep [-].
      real(dp) :: tolerance = 0
      !> How far the result may lie off a straight line, in units of its range [-].
      real(dp) :: resolution = 0.01_dp
      !> Most values of the refined sweep.
      integer(i8) :: limit = 1000
      !> Is the width that of the logarithm?
      logical :: is_logarithmic = .false.
   contains
      procedure :: is_wanted
      procedure :: describe
   end type refinement_t

   !> The values of a sweep, and what was found there.
   type :: refined_curve_t
      !> Values of the variable, which rise or fall.
      real(dp), allocatable :: x(:)
      !> The result.
      real(dp), allocatable :: y(:)
      !> Status of each point.
      integer, allocatable :: status(:)
   end type refined_curve_t

contains

   !> Is anything refined?
   pure logical function is_wanted(self)
      class(refinement_t), intent(in) :: self

      is_wanted = self%result > 0
   end function is_wanted

   !> The refinement in words.
   function describe(self, model) result(text)
      class(refinement_t), intent(in) :: self
      !> The model, whose table names the result.
      class(model_t), intent(in) :: model
      character(:), allocatable :: text

      text = 'where '//model%results(self%result)%name//' jumps or bends, to '//show_number(self%tolerance)//' of the sweep, '// &
         'at most '//show_count(self%limit)//' values'
   end function describe

   !> Refine the only axis of a run, in one process for all.
   subroutine refine_together(world, refinement, model, base, axis, error)
      !> The processes of the run, all of which must call this procedure.
      type(world_t), intent(in) :: world
      !> How the sweep is refined.
      type(refinement_t), intent(in) :: refinement
      !> The model, which is prepared in the first process.
      class(model_t), intent(in) :: model
      !> Values of all variables where nothing is swept.
      real(dp), intent(in) :: base(:)
      !> In: the sweep. Out: the refined sweep, the same in all processes.
      type(axis_t), intent(inout) :: axis
      !> Not allocated if all went well; the same in all processes.
      type(error_t), allocatable, intent(out) :: error
      integer(int8), allocatable :: bytes(:)
      integer(i8) :: n(1)

      if (world%is_first()) call refine(refinement, model, base, axis, error)
      call share_error(world, error)
      if (allocated(error) .or. world%n_ranks == 1) return
      n = 0
      if (world%is_first()) n = size(axis%values, 2)
      call world%add_up(n)
      allocate (bytes(storage_size(1.0_dp)/8*n(1)), source=0_int8)
      if (world%is_first()) bytes = transfer(axis%values, bytes)
      call world%share_bytes(bytes, 0)
      axis%values = reshape(transfer(bytes, [0.0_dp]), [1, int(n(1))])
   end subroutine refine_together

   !> Refine a sweep of one variable.
   subroutine refine(refinement, model, base, axis, error)
      type(refinement_t), intent(in) :: refinement
      class(model_t), intent(in) :: model
      !> Values of all variables where nothing is swept.
      real(dp), intent(in) :: base(:)
      !> In: the sweep. Out: the refined sweep.
      type(axis_t), intent(inout) :: axis
      !> Allocated if there would be too many values, or if there is too little memory.
      type(error_t), allocatable, intent(out) :: error
      type(refined_curve_t) :: curve
      logical, allocatable :: is_halved(:)
      real(dp) :: range

      call solve_curve(refinement, model, base, axis%variables(1), axis%values(1, :), curve)
      range = range_of(curve)
      do
         if (any(curve%status == status_out_of_memory)) then
            call set_error(error, file_failure, 'cannot refine the sweep: too little memory for a point')
            return
         end if
         call choose_intervals(refinement, model, curve, range, is_halved)
         if (.not. any(is_halved)) exit
         if (size(curve%x) + count(is_halved) > refinement%limit) then
            call set_error(error, input_failure, '&refine limit: the refined sweep needs more values, given '// &
               show_count(refinement%limit)//', allowed: more, a larger tolerance or a larger resolution')
            return
         end if
         call halve(refinement, model, base, axis%variables(1), is_halved, curve)
      end do
      axis%values = reshape(curve%x, [1, size(curve%x)])
   end subroutine refine

   !> Solve the points of a curve, each by itself.
   subroutine solve_curve(refinement, model, base, variable, x, curve)
      type(refinement_t), intent(in) :: refinement
      class(model_t), intent(in) :: model
      real(dp), intent(in) :: base(:)
      !> Index of the variable that is swept.
      integer, intent(in) :: variable
      !> Its values.
      real(dp), intent(in) :: x(:)
      type(refined_curve_t), intent(out) :: curve
      integer :: i

      curve%x = x
      allocate (curve%y(size(x)), curve%status(size(x)))
      !$omp parallel do schedule(dynamic)
      do i = 1, size(x)
         call solve_one(refinement, model, base, variable, x(i), curve%y(i), curve%status(i))
      end do
      !$omp end parallel do
   end subroutine solve_curve

   !> Solve one point.
   subroutine solve_one(refinement, model, base, variable, x, y, status)
      type(refinement_t), intent(in) :: refinement
      class(model_t), intent(in) :: model
      real(dp), intent(in) :: base(:)
      integer, intent(in) :: variable
      !> Its value.
      real(dp), intent(in) :: x
      !> Receives the result.
      real(dp), intent(out) :: y
      integer, intent(out) :: status
      real(dp) :: values(size(base), 1), results(size(model%results), 1), error_estimate(1), counts(size(model%counts))
      integer :: states(1)

      values(:, 1) = base
      values(variable, 1) = x
      call model%solve_block(values, results, error_estimate, states, counts)
      y = results(refinement%result, 1)
      status = states(1)
   end subroutine solve_one

   !> Difference of the greatest and the least result; 0 if there is none.
   pure real(dp) function range_of(curve)
      type(refined_curve_t), intent(in) :: curve
      real(dp), allocatable :: y(:)

      range_of = 0
      y = pack(curve%y,.not. ieee_is_nan(curve%y))
      if (size(y) > 0) range_of = maxval(y) - minval(y)
   end function range_of

   !> Which intervals are halved next?
   subroutine choose_intervals(refinement, model, curve, range, is_halved)
      type(refinement_t), intent(in) :: refinement
      !> The model, whose table says whether the result is a state.
      class(model_t), intent(in) :: model
      type(refined_curve_t), intent(in) :: curve
      !> Range of the result at the values with which the sweep begins.
      real(dp), intent(in) :: range
      !> Receives which intervals are halved, in the order of the curve.
      logical, allocatable, intent(out) :: is_halved(:)
      logical :: is_off(size(curve%x)), is_state
      integer :: i, n

      n = size(curve%x)
      is_state = model%results(refinement%result)%n_states() > 0
      is_off = .false.
      do i = 2, n - 1
         if (.not. is_state) is_off(i) = is_off_line(refinement, curve, i, refinement%resolution*range)
      end do
      allocate (is_halved(n - 1), source=.false.)
      do i = 1, n - 1
         if (width(refinement, curve, i) <= refinement%tolerance) cycle
         is_halved(i) = changes(curve, i, is_state) .or. is_off(i) .or. is_off(i + 1)
      end do
   end subroutine choose_intervals

   !> Width of an interval in units of the whole sweep.
   pure real(dp) function width(refinement, curve, i)
      type(refinement_t), intent(in) :: refinement
      type(refined_curve_t), intent(in) :: curve
      !> Number of the interval, from 1.
      integer, intent(in) :: i

      width = index_of(refinement, curve, i + 1) - index_of(refinement, curve, i)
   end function width

   !> Index of a value in the sweep, from 0 to 1.
   pure real(dp) function index_of(refinement, curve, i)
      type(refinement_t), intent(in) :: refinement
      type(refined_curve_t), intent(in) :: curve
      !> Number of the value, from 1.
      integer, intent(in) :: i

      associate (first => curve%x(1), last => curve%x(size(curve%x)))
         if (refinement%is_logarithmic) then
            index_of = log(curve%x(i)/first)/log(last/first)
         else
            index_of = (curve%x(i) - first)/(last - first)
         end if
      end associate
   end function index_of

   !> Does a point lie off the straight line through its two neighbours?
   pure logical function is_off_line(refinement, curve, i, allowed)
      type(refinement_t), intent(in) :: refinement
      type(refined_curve_t), intent(in) :: curve
      integer, intent(in) :: i
      !> How far it may lie off.
      real(dp), intent(in) :: allowed
      real(dp) :: left, right

      is_off_line = .false.
      if (any(ieee_is_nan(curve%y(i - 1:i + 1)))) return
      left = width(refinement, curve, i - 1)
      right = width(refinement, curve, i)
      is_off_line = abs(curve%y(i) - (right*curve%y(i - 1) + left*curve%y(i + 1))/(left + right)) > allowed
   end function is_off_line

   !> Does a status or a state change between the ends of an interval? What did not converge says nothing.
   pure logical function changes(curve, i, is_state)
      type(refined_curve_t), intent(in) :: curve
      integer, intent(in) :: i
      logical, intent(in) :: is_state

      changes = .false.
      if (any(curve%status(i:i + 1) == status_not_converged)) return
      changes = any(curve%status(i:i + 1) == status_solved) .and. any(curve%status(i:i + 1) == status_no_equilibrium)
      changes = changes .or. (ieee_is_nan(curve%y(i)) .neqv. ieee_is_nan(curve%y(i + 1)))
      if (changes .or. .not. is_state .or. ieee_is_nan(curve%y(i))) return
      changes = nint(curve%y(i)) /= nint(curve%y(i + 1))
   end function changes

   !> Halve some intervals.
   subroutine halve(refinement, model, base, variable, is_halved, curve)
      type(refinement_t), intent(in) :: refinement
      class(model_t), intent(in) :: model
      real(dp), intent(in) :: base(:)
      integer, intent(in) :: variable
      !> Which intervals are halved, in the order of the curve?
      logical, intent(in) :: is_halved(:)
      !> The curve, which gets a point for each of them.
      type(refined_curve_t), intent(inout) :: curve
      type(refined_curve_t) :: added, merged
      integer :: i, k, n

      n = size(curve%x)
      call solve_curve(refinement, model, base, variable, pack(middle(curve%x(:n - 1), curve%x(2:), refinement%is_logarithmic), &
         is_halved), added)
      allocate (merged%x(n + size(added%x)), merged%y(n + size(added%x)), merged%status(n + size(added%x)))
      k = 0
      do i = 1, n
         merged%x(i + k) = curve%x(i)
         merged%y(i + k) = curve%y(i)
         merged%status(i + k) = curve%status(i)
         if (i == n) exit
         if (.not. is_halved(i)) cycle
         k = k + 1
         merged%x(i + k) = added%x(k)
         merged%y(i + k) = added%y(k)
         merged%status(i + k) = added%status(k)
      end do
      curve = merged
   end subroutine halve

   !> The middle of an interval.
   elemental real(dp) function middle(a, b, is_logarithmic)
      !> The ends, of one sign if the middle is that of the logarithm.
      real(dp), intent(in) :: a, b
      logical, intent(in) :: is_logarithmic

      if (is_logarithmic) then
         middle = sign(sqrt(abs(a))*sqrt(abs(b)), a)
      else
         middle = 0.5_dp*a + 0.5_dp*b
      end if
   end function middle

end module adfric_run_refinement

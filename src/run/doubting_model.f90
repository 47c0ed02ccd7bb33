! SPDX-License-Identifier: GPL-3.0-or-later
!> A model that holds another one, and says of each point whether it lies within the bounds of its theory: the last result is the
!> doubt. To whoever runs it, it is a model like any other.
module adfric_run_doubting_model
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_describe_doubt, only: doubt_beyond_yield, doubt_estimate_above_tenth, doubt_name, find_doubt, &
      & n_doubts, not_measured
   use adfric_describe_model, only: model_t
   use adfric_describe_profile_receiver, only: profile_receiver_t
   use adfric_describe_status, only: status_solved
   use adfric_describe_table, only: doubt_row, result_t
   use adfric_run_converted_model, only: converted_model_t
   use adfric_run_wrapped_model, only: wrapped_model_t
   implicit none (type, external)
   private
   public :: doubting_model_t, let_doubt

   !> A model with one result more.
   type, extends(wrapped_model_t) :: doubting_model_t
      !> Index of the result that says how far the solid is from its yield strength; 0 where there is none.
      integer :: yield_ratio = 0
   contains
      procedure :: solve_block
      procedure :: solve_block_and_profiles
      procedure :: describe_results
      procedure :: get_nominal_sizes
   end type doubting_model_t

contains

   !> Let a model doubt; one that has the result already, as a fit or a model that doubts, stays as it is. A solver with the values
   !> of a scene doubts itself, so that these are converted once.
   recursive subroutine let_doubt(model)
      !> In: the model. Out: a model that holds it.
      class(model_t), allocatable, intent(inout) :: model
      type(doubting_model_t), allocatable :: doubting
      integer :: k

      do k = 1, size(model%results)
         if (model%results(k)%name == doubt_name) return
      end do
      select type (model)
      class is (converted_model_t)
         call let_doubt(model%inner)
         call model%take_doubt()
         return
      end select
      allocate (doubting)
      call doubting%wrap(model)
      do k = 1, size(doubting%inner%results)
         if (doubting%inner%results(k)%name == 'yield_ratio') doubting%yield_ratio = k
      end do
      call append_doubt(doubting%inner%results, doubting%results)
      call move_alloc(doubting, model)
   end subroutine let_doubt

   !> A table with the doubt behind its rows.
   subroutine append_doubt(rows, results)
      type(result_t), intent(in) :: rows(:)
      type(result_t), allocatable, intent(out) :: results(:)
      integer :: i

      allocate (results(size(rows) + 1))
      do i = 1, size(rows)
         results(i) = rows(i)
      end do
      results(size(results)) = doubt_row()
   end subroutine append_doubt

   !> See `model_t`.
   subroutine solve_block(self, values, results, error_estimate, status, counts)
      class(doubting_model_t), intent(in) :: self
      real(dp), intent(in), contiguous :: values(:, :)
      real(dp), intent(out) :: results(:, :), error_estimate(:)
      integer, intent(out) :: status(:)
      real(dp), intent(out) :: counts(:)

      call self%inner%solve_block(values, results(:size(results, 1) - 1, :), error_estimate, status, counts)
      call add_doubts(self, values, error_estimate, status, results)
   end subroutine solve_block

   !> See `model_t`.
   subroutine solve_block_and_profiles(self, values, results, error_estimate, status, counts, profiles, receiver)
      class(doubting_model_t), intent(in) :: self
      real(dp), intent(in), contiguous :: values(:, :)
      real(dp), intent(out) :: results(:, :), error_estimate(:)
      integer, intent(out) :: status(:)
      real(dp), intent(out) :: counts(:)
      real(dp), intent(inout) :: profiles(:, :, :)
      class(profile_receiver_t), intent(inout) :: receiver

      call self%inner%solve_block_and_profiles(values, results(:size(results, 1) - 1, :), error_estimate, status, counts, &
         & profiles, receiver)
      call add_doubts(self, values, error_estimate, status, results)
   end subroutine solve_block_and_profiles

   !> Add the doubt of each point that is solved.
   subroutine add_doubts(self, values, error_estimate, status, results)
      class(doubting_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:, :)
      !> Relative error of each point.
      real(dp), intent(in) :: error_estimate(:)
      integer, intent(in) :: status(:)
      !> In: results of the inner model. Out: with the doubts, NaN where a point is not solved; shape `(n_results, n_points)`.
      real(dp), intent(inout) :: results(:, :)
      real(dp) :: measures(n_doubts)
      integer :: i, n

      n = size(results, 1)
      do i = 1, size(status)
         results(n, i) = not_a_number()
         if (status(i) /= status_solved) cycle
         measures = not_measured
         call self%inner%measure(values(:, i), results(:n - 1, i), measures)
         measures(doubt_estimate_above_tenth) = error_estimate(i)
         if (self%yield_ratio > 0) measures(doubt_beyond_yield) = results(self%yield_ratio, i)
         results(n, i) = find_doubt(measures)
      end do
   end subroutine add_doubts

   !> See `model_t`: values are those of the inner model, and need no copy.
   pure subroutine get_nominal_sizes(self, values, sizes)
      class(doubting_model_t), intent(in) :: self
      real(dp), intent(in), contiguous :: values(:, :)
      real(dp), intent(out) :: sizes(:)

      call self%inner%get_nominal_sizes(values, sizes)
   end subroutine get_nominal_sizes

   !> See `model_t`.
   function describe_results(self, values) result(results)
      class(doubting_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(result_t), allocatable :: results(:)

      call append_doubt(self%inner%describe_results(values), results)
   end function describe_results

end module adfric_run_doubting_model

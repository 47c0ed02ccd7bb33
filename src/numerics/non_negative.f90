! SPDX-License-Identifier: GPL-3.0-or-later
!> Linear least squares with unknowns that are not negative: the least |A x - b| over x >= 0.
!>
!> The method of active sets of C. L. Lawson and R. J. Hanson, Solving Least Squares Problems, 1974, chapter 23, on a triangle of
!> which the columns have the length 1: some unknowns are free, the others 0. The unknown along whose column the residual points most
!> becomes free; those that the least squares of the free ones would make negative become 0 again, the first of them first.
!> A solution is proved by its gradient (Kuhn and Tucker): it vanishes for free unknowns and does not point inwards for the others.
module adfric_numerics_non_negative
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_numerics_lapack, only: dgeqrf
   implicit none (type, external)
   private
   public :: solve_non_negative

   !> Space for the factorisation, in columns.
   integer, parameter :: space = 32
   !> Steps for each unknown; a problem without rounding takes about one.
   integer, parameter :: steps_per_unknown = 20

   !> A problem with columns of length 1 or 0, and its state.
   type :: non_negative_problem_t
      !> The triangle of the columns; shape `(n_rows, n)`.
      real(dp), allocatable :: a(:, :)
      !> Right-hand side, of length 1; shape `(n_rows)`.
      real(dp), allocatable :: b(:)
      !> The unknowns; shape `(n)`.
      real(dp), allocatable :: x(:)
      !> The free unknowns in the order in which they became free; the first `n_free` positions are used.
      integer, allocatable :: free(:)
      !> Number of free unknowns.
      integer :: n_free = 0
   end type non_negative_problem_t

contains

   !> Solve A x = b, x >= 0, in the sense of least squares.
   pure subroutine solve_non_negative(a, b, x, is_solved)
      !> The matrix; shape `(m, n)`. It may have any rank.
      real(dp), intent(in) :: a(:, :)
      !> Right-hand side; shape `(m)`.
      real(dp), intent(in) :: b(:)
      !> Receives the unknowns; shape `(n)`.
      real(dp), intent(out) :: x(:)
      !> Is the solution proved by its gradient, to round-off? If not, x is a point x >= 0 that fits the better the later the search
      !> came to its end.
      logical, intent(out) :: is_solved
      type(non_negative_problem_t) :: problem
      real(dp) :: column_lengths(size(a, 2)), right_length

      if (has_asserts) call assert(size(b) == size(a, 1) .and. size(x) == size(a, 2), 'solve_non_negative: shapes')
      column_lengths = norm2(a, 1)
      right_length = norm2(b)
      x = 0
      is_solved = .true.
      if (.not. (right_length > 0 .and. any(column_lengths > 0))) return
      where (.not. column_lengths > 0) column_lengths = 1
      call new_problem(problem, a/spread(column_lengths, 1, size(a, 1)), b/right_length)
      call search(problem)
      x = problem%x/column_lengths*right_length
      is_solved = is_proved(problem)
   end subroutine solve_non_negative

   !> A problem in which no unknown is free.
   pure subroutine new_problem(self, a, b)
      type(non_negative_problem_t), intent(out) :: self
      !> The matrix; shape `(m, n)`.
      real(dp), intent(in) :: a(:, :)
      !> Right-hand side; shape `(m)`.
      real(dp), intent(in) :: b(:)
      real(dp), allocatable :: both(:, :)
      integer :: n, n_rows

      n = size(a, 2)
      allocate (both(size(a, 1), n + 1))
      both(:, :n) = a
      both(:, n + 1) = b
      call make_triangle(both)
      n_rows = min(size(a, 1), n + 1)
      self%a = both(:n_rows, :n)
      self%b = both(:n_rows, n + 1)
      allocate (self%x(n), source=0.0_dp)
      allocate (self%free(n), source=0)
   end subroutine new_problem

   !> Replace a matrix by its factor R.
   pure subroutine make_triangle(a)
      !> In: the matrix. Out: R, with zeros below the diagonal.
      real(dp), intent(inout) :: a(:, :)
      real(dp) :: factors(size(a, 2)), work(space*size(a, 2))
      integer :: info, k

      call dgeqrf(size(a, 1), size(a, 2), a, size(a, 1), factors, work, size(work), info)
      if (has_asserts) call assert(info == 0, 'make_triangle: arguments of dgeqrf')
      do k = 1, size(a, 2)
         a(k + 1:, k) = 0
      end do
   end subroutine make_triangle

   !> Free one unknown after the other until none is left that would lessen the residual.
   pure subroutine search(self)
      type(non_negative_problem_t), intent(inout) :: self
      logical :: is_tried(size(self%x)), is_free_now
      real(dp) :: gradient(size(self%x))
      integer :: k, entry

      is_tried = .false.
      do k = 1, steps_per_unknown*size(self%x)
         gradient = gradient_of(self)
         is_tried(self%free(:self%n_free)) = .true.
         entry = maxloc(gradient, 1, .not. is_tried)
         if (entry == 0) exit
         if (gradient(entry) <= round_off(self)) exit
         call free_unknown(self, entry, is_free_now)
         ! rounding may forbid what the gradient allows; the next best has its turn then
         if (is_free_now) then
            is_tried = .false.
         else
            is_tried(entry) = .true.
         end if
      end do
   end subroutine search

   !> How fast the residual falls with each unknown.
   pure function gradient_of(self) result(gradient)
      type(non_negative_problem_t), intent(in) :: self
      !> Products of the columns and the residual; shape `(n)`.
      real(dp) :: gradient(size(self%x))

      gradient = matmul(self%b - matmul(self%a, self%x), self%a)
   end function gradient_of

   !> What rounding leaves of a gradient that vanishes, for columns and a right-hand side of length 1.
   pure real(dp) function round_off(self)
      type(non_negative_problem_t), intent(in) :: self

      round_off = 10*size(self%x)*epsilon(1.0_dp)
   end function round_off

   !> Let an unknown become free, and go to the least squares of the free ones as far as all remain positive.
   pure subroutine free_unknown(self, entry, is_free)
      type(non_negative_problem_t), intent(inout) :: self
      !> The unknown.
      integer, intent(in) :: entry
      !> Did it become free? It does not where its column is one of the others to round-off.
      logical, intent(out) :: is_free
      real(dp) :: best(size(self%x))
      logical :: is_regular

      self%n_free = self%n_free + 1
      self%free(self%n_free) = entry
      call get_least_squares(self, best, is_regular)
      is_free = is_regular .and. best(self%n_free) > 0
      if (.not. is_free) then
         self%n_free = self%n_free - 1
         return
      end if
      do while (any(best(:self%n_free) <= 0))
         call go_towards(self, best)
         call drop_zeros(self)
         call get_least_squares(self, best, is_regular)
         if (.not. is_regular) return
      end do
      self%x(self%free(:self%n_free)) = best(:self%n_free)
   end subroutine free_unknown

   !> Go from the free unknowns towards others until the first one is 0.
   pure subroutine go_towards(self, best)
      !> The problem; its free unknowns are positive, but for a new one that rises.
      type(non_negative_problem_t), intent(inout) :: self
      !> Where to go, which is not positive in at least one position.
      real(dp), intent(in) :: best(:)
      real(dp) :: shares(self%n_free), share
      integer :: k

      shares = 1
      do k = 1, self%n_free
         associate (x => self%x(self%free(k)))
            if (best(k) <= 0) shares(k) = x/(x - best(k))
         end associate
      end do
      share = minval(shares, best(:self%n_free) <= 0)
      do k = 1, self%n_free
         associate (x => self%x(self%free(k)))
            if (best(k) <= 0 .and. shares(k) <= share) then
               x = 0
            else
               x = max(x + share*(best(k) - x), 0.0_dp)
            end if
         end associate
      end do
   end subroutine go_towards

   !> Unknowns that became 0 are no longer free.
   pure subroutine drop_zeros(self)
      type(non_negative_problem_t), intent(inout) :: self
      integer :: k, n

      n = 0
      do k = 1, self%n_free
         if (self%x(self%free(k)) > 0) then
            n = n + 1
            self%free(n) = self%free(k)
         end if
      end do
      self%n_free = n
   end subroutine drop_zeros

   !> Least squares of the free unknowns, of any sign.
   pure subroutine get_least_squares(self, best, is_regular)
      type(non_negative_problem_t), intent(in) :: self
      !> Receives the values of the free unknowns, in their order; the first `n_free` positions.
      real(dp), intent(out) :: best(:)
      !> Can the last column be told from the others?
      logical, intent(out) :: is_regular
      real(dp) :: both(size(self%b), self%n_free + 1)
      integer :: k, n

      n = self%n_free
      best = 0
      is_regular = n <= size(self%b)
      if (n == 0 .or. .not. is_regular) return
      both(:, :n) = self%a(:, self%free(:n))
      both(:, n + 1) = self%b
      call make_triangle(both)
      is_regular = abs(both(n, n)) > round_off(self)
      if (.not. is_regular) return
      do k = n, 1, -1
         best(k) = (both(k, n + 1) - dot_product(both(k, k + 1:n), best(k + 1:n)))/both(k, k)
      end do
   end subroutine get_least_squares

   !> Is the state a solution, to round-off?
   pure logical function is_proved(self)
      type(non_negative_problem_t), intent(in) :: self
      real(dp) :: gradient(size(self%x))

      gradient = gradient_of(self)
      is_proved = all(self%x >= 0) .and. all(gradient <= 10*round_off(self)) &
         & .and. all(abs(gradient(self%free(:self%n_free))) <= 10*round_off(self))
   end function is_proved

end module adfric_numerics_non_negative

! SPDX-License-Identifier: GPL-3.0-or-later
!> One step in time of a column under a law of attraction: three gaps, from which all else follows.
!>
!> See `adfric_foundation_stepping_attracted_zone` for the equations.
module adfric_foundation_stepping_attracted_step
   use adfric_base_kinds, only: dp
   use adfric_numerics_phi_functions, only: get_phi_functions
   use adfric_foundation_stepping_attraction, only: column_attraction_t
   use adfric_foundation_stepping_path, only: column_path_t, expm1_of
   use adfric_foundation_stepping_zone_curve, only: highest_power
   use adfric_foundation_stepping_zone_end, only: position_t
   implicit none (type, external)
   private
   public :: step_weights_t, attracted_step_t, set_weights, try_step, cubic_of, points, lobatto, round_off

   !> Lobatto's points and weights.
   real(dp), parameter :: shift = 0.22360679774997896964_dp, points(0:3) = [0.0_dp, 0.5_dp - shift, 0.5_dp + shift, 1.0_dp], &
      & lobatto(0:3) = [1.0_dp, 5.0_dp, 5.0_dp, 1.0_dp]/12
   !> Most iterations of Newton's method.
   integer, parameter :: most_iterations = 12
   !> Lengths are known to this share of them.
   real(dp), parameter :: round_off = 16*epsilon(1.0_dp)

   !> What a length of step makes of the elements.
   type :: step_weights_t
      !> The length, in pieces; negative if there is none.
      real(dp) :: length = -1
      !> What is lost of an element up to each point, <= 0; shape `(n_arms, 3)`.
      real(dp), allocatable :: lost(:, :)
      !> What the powers of p make of an element of compliance 1 up to each point; shape `(n_arms, 3, 0:3)`.
      real(dp), allocatable :: forced(:, :, :)
      !> What pressures at the points add to the reach at the last three; shape `(3, 0:3)`.
      real(dp) :: influence(3, 0:3) = 0
   end type step_weights_t

   !> A step that has been tried.
   type :: attracted_step_t
      !> Length in pieces, gaps, tensions, slopes, reaches and heights at the points.
      real(dp) :: length = 0, gaps(0:3) = 0, tensions(0:3) = 0, slopes(0:3) = 0, reaches(0:3) = 0, heights(0:3) = 0
      !> Powers of the heights over the step, and of the pressure.
      real(dp) :: rise(0:highest_power) = 0, pressure(0:3) = 0
      !> Was a solution found?
      logical :: is_solved = .false.
   end type attracted_step_t

contains

   !> What a length of step makes of the elements.
   pure subroutine set_weights(path, length, weights)
      type(column_path_t), intent(in) :: path
      !> The length, in pieces.
      real(dp), intent(in) :: length
      !> Receives the weights; its arrays are allocated.
      type(step_weights_t), intent(inout) :: weights
      real(dp), parameter :: factorials(0:3) = [1.0_dp, 1.0_dp, 2.0_dp, 6.0_dp]
      real(dp) :: phi(4), x
      integer :: j, k, m

      weights%length = length
      weights%influence = 0
      do k = 1, 3
         do j = 1, path%solid%n
            x = path%open_ratio(j)*length*points(k)
            call get_phi_functions(x, phi)
            weights%lost(j, k) = expm1_of(-x)
            do m = 0, 3
               weights%forced(j, k, m) = x*factorials(m)*phi(m + 1)*points(k)**m
               weights%influence(k, :) = weights%influence(k, :) + path%solid%compliance(j)*weights%forced(j, k, m)*powers_of(m)
            end do
         end do
      end do
   end subroutine set_weights

   !> What values at the points add to a power of their cubic; shape `(0:3)`.
   pure function powers_of(m) result(row)
      !> The power, 0 to 3.
      integer, intent(in) :: m
      real(dp) :: row(0:3)
      ! 1/(a (b - a) b) with the inner points a and b
      real(dp), parameter :: c = 5*sqrt(5.0_dp)

      select case (m)
      case (0)
         row = [1.0_dp, 0.0_dp, 0.0_dp, 0.0_dp]
      case (1)
         row = [-6.0_dp, c*points(2), -c*points(1), 1.0_dp]
      case (2)
         row = [10.0_dp, -c*(1 + points(2)), c*(1 + points(1)), -5.0_dp]
      case default
         row = [-5.0_dp, c, -c, 5.0_dp]
      end select
   end function powers_of

   !> Powers of the cubic through values at the points.
   pure function cubic_of(values) result(powers)
      !> The values; shape `(0:3)`.
      real(dp), intent(in) :: values(0:)
      real(dp) :: powers(0:3)
      integer :: m

      do m = 0, 3
         powers(m) = sum(powers_of(m)*values(0:3))
      end do
   end function cubic_of

   !> Find the gaps of a step by Newton's method.
   pure subroutine try_step(path, attraction, span, depth, position, elements, gap, weights, step)
      type(column_path_t), intent(in) :: path
      type(column_attraction_t), intent(in) :: attraction
      integer, intent(in) :: span
      real(dp), intent(in) :: depth
      !> Where the step begins.
      type(position_t), intent(in) :: position
      !> The Kelvin elements there; shape `(n_arms)`.
      real(dp), intent(in) :: elements(:)
      !> The gap there.
      real(dp), intent(in) :: gap
      type(step_weights_t), intent(in) :: weights
      !> In: the length. Out: the step.
      type(attracted_step_t), intent(inout) :: step
      real(dp) :: base(3), matrix(3, 3), move(3), enough, lowest
      integer :: i, k

      call set_heights(path, position, step)
      step%reaches(0) = sum(elements) - depth - step%heights(0)
      do k = 1, 3
         base(k) = step%reaches(0) + sum(elements*weights%lost(:, k)) - (step%heights(k) - step%heights(0))
      end do
      step%gaps = gap
      call attraction%get_tension(span, gap, step%tensions(0), step%slopes(0))
      enough = max(1.0e-10_dp*attraction%law%range, round_off*(1 + abs(depth) + maxval(abs(base))))
      lowest = attraction%spans(span)%low_gap - attraction%law%range/2
      step%is_solved = .false.
      do i = 1, most_iterations
         do k = 1, 3
            call attraction%get_tension(span, step%gaps(k), step%tensions(k), step%slopes(k))
         end do
         do k = 1, 3
            move(k) = base(k) - step%gaps(k) - step%tensions(k)/attraction%glassy - sum(weights%influence(k, :)*step%tensions)
            matrix(k, :) = weights%influence(k, 1:3)*step%slopes(1:3)
            matrix(k, k) = matrix(k, k) + 1 + step%slopes(k)/attraction%glassy
         end do
         call solve_three(matrix, move)
         step%gaps(1:3) = step%gaps(1:3) + move
         if (.not. (all(step%gaps(1:3) > lowest) .and. all(abs(move) < 1.0e30_dp))) return
         step%is_solved = all(abs(move) <= enough)
         if (step%is_solved) exit
      end do
      if (.not. step%is_solved) return
      do k = 1, 3
         call attraction%get_tension(span, step%gaps(k), step%tensions(k), step%slopes(k))
         step%reaches(k) = step%gaps(k) + step%tensions(k)/attraction%glassy
      end do
      step%pressure = cubic_of(-step%tensions)
   end subroutine try_step

   !> Heights over a step.
   pure subroutine set_heights(path, position, step)
      type(column_path_t), intent(in) :: path
      type(position_t), intent(in) :: position
      !> The step, whose length is known.
      type(attracted_step_t), intent(inout) :: step
      real(dp) :: scale
      integer :: i, m

      step%rise = 0
      step%rise(0:path%degree) = path%coefficients(:, position%piece)
      do m = 0, path%degree - 1
         do i = path%degree - 1, m, -1
            step%rise(i) = step%rise(i) + position%theta*step%rise(i + 1)
         end do
      end do
      scale = 1
      do m = 1, path%degree
         scale = scale*step%length
         step%rise(m) = step%rise(m)*scale
      end do
      step%heights = 0
      do m = path%degree, 0, -1
         step%heights = step%rise(m) + points*step%heights
      end do
   end subroutine set_heights

   !> Solve three equations.
   pure subroutine solve_three(matrix, vector)
      !> The matrix, which is spent.
      real(dp), intent(inout) :: matrix(3, 3)
      !> In: right side. Out: the solution; `huge` where there is none.
      real(dp), intent(inout) :: vector(3)
      real(dp), parameter :: least = 1.0e-100_dp
      real(dp) :: factor
      integer :: i, k

      do k = 1, 3
         if (.not. abs(matrix(k, k)) > least) then
            vector = huge(1.0_dp)
            return
         end if
         do i = k + 1, 3
            factor = matrix(i, k)/matrix(k, k)
            matrix(i, :) = matrix(i, :) - factor*matrix(k, :)
            vector(i) = vector(i) - factor*vector(k)
         end do
      end do
      do k = 3, 1, -1
         vector(k) = (vector(k) - sum(matrix(k, k + 1:)*vector(k + 1:)))/matrix(k, k)
      end do
   end subroutine solve_three

end module adfric_foundation_stepping_attracted_step

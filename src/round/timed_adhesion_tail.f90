! SPDX-License-Identifier: GPL-3.0-or-later
!> Springs that a contact with a zone of adhesion has left: a tail from some cells beyond the zone on. Nothing pulls at them, so a
!> step takes displacement and arms of all of them on by one matrix,
!>
!>     th(end) = sum E_i (e z + b0 th)/E,    z(end) = e z + b0 th + b1 th(end)
!>
!> in the terms of `adfric_round_timed_adhesion_memory`. They are left as they were when the tail was made, and the product of these
!> matrices is kept. What they have lost follows from the sums of products of displacements over the tail.
module adfric_round_timed_adhesion_tail
   use adfric_base_kinds, only: dp
   use adfric_solid_prony, only: prony_t
   implicit none (type, external)
   private
   public :: spring_tail_t, make_tail, step_tail, wake_tail

   !> A tail.
   type :: spring_tail_t
      !> Its first node; enormous where there is none.
      integer :: first = huge(1)
      !> What has become of (displacement, arms) since the tail was made; shape `(0:n_arms, 0:n_arms)`.
      real(dp), allocatable, private :: map(:, :)
      !> Sums of products of (displacement, arms) over the tail, at present; shape `(0:n_arms, 0:n_arms)`.
      real(dp), allocatable, private :: products(:, :)
   end type spring_tail_t

contains

   !> Springs become a tail.
   pure subroutine make_tail(self, first, last, displacements, arms)
      !> Receives the tail.
      type(spring_tail_t), intent(out) :: self
      !> Its nodes.
      integer, intent(in) :: first, last
      !> Displacements of the springs and of their arms; shapes `(0:)` and `(0:, n_arms)`.
      real(dp), intent(in) :: displacements(0:), arms(0:, :)
      integer :: i, j, n

      self%first = first
      n = size(arms, 2)
      allocate (self%map(0:n, 0:n), self%products(0:n, 0:n), source=0.0_dp)
      self%products(0, 0) = dot_product(displacements(first:last), displacements(first:last))
      self%map(0, 0) = 1
      do i = 1, n
         self%map(i, i) = 1
         self%products(i, 0) = dot_product(displacements(first:last), arms(first:last, i))
         self%products(0, i) = self%products(i, 0)
         do j = 1, i
            self%products(i, j) = dot_product(arms(first:last, i), arms(first:last, j))
            self%products(j, i) = self%products(i, j)
         end do
      end do
   end subroutine make_tail

   !> Go to the end of a step.
   pure subroutine step_tail(self, solid, modulus, decay, from_begin, from_end, losses, sums)
      !> The tail.
      type(spring_tail_t), intent(inout) :: self
      !> The solid, and the modulus of the step.
      type(prony_t), intent(in) :: solid
      real(dp), intent(in) :: modulus
      !> e, b0 and b1 of the step; shape `(n_arms)`.
      real(dp), intent(in) :: decay(:), from_begin(:), from_end(:)
      !> What an arm loses; shape `(3, n_arms)`.
      real(dp), intent(in) :: losses(:, :)
      !> Receives half of what each arm has lost over its modulus and the cell; shape `(n_arms)`.
      real(dp), intent(out) :: sums(:)
      real(dp) :: step(0:size(decay), 0:size(decay)), before(0:size(decay)), change(0:size(decay)), moved(0:size(decay))
      integer :: arm, n

      n = size(decay)
      step = 0
      step(0, 0) = sum(solid%moduli*from_begin)/modulus
      step(0, 1:) = solid%moduli*decay/modulus
      do arm = 1, n
         step(arm, :) = from_end(arm)*step(0, :)
         step(arm, 0) = step(arm, 0) + from_begin(arm)
         step(arm, arm) = step(arm, arm) + decay(arm)
      end do
      change = step(0, :)
      change(0) = change(0) - 1
      moved = matmul(self%products, change)
      do arm = 1, n
         before = self%products(:, 0) - self%products(:, arm)
         sums(arm) = losses(1, arm)*(before(0) - before(arm)) + losses(2, arm)*(moved(0) - moved(arm)) &
            & + losses(3, arm)*dot_product(change, moved)
      end do
      call take_on(n + 1, step, self%map, self%products)
   end subroutine step_tail

   !> Map and products at the end of a step.
   pure subroutine take_on(n, step, map, products)
      integer, intent(in) :: n
      !> The matrix of the step.
      real(dp), intent(in) :: step(n, n)
      real(dp), intent(inout) :: map(n, n), products(n, n)
      real(dp) :: left(n, n)
      integer :: i, j

      do j = 1, n
         left(:, j) = matmul(step, products(:, j))
      end do
      do j = 1, n
         do i = 1, n
            products(i, j) = dot_product(left(i, :), step(j, :))
         end do
      end do
      do j = 1, n
         left(:, j) = matmul(step, map(:, j))
      end do
      map = left
   end subroutine take_on

   !> The springs of a tail at present; it is one no more.
   pure subroutine wake_tail(self, last, displacements, arms)
      !> The tail.
      type(spring_tail_t), intent(inout) :: self
      !> Its last node.
      integer, intent(in) :: last
      !> Displacements of the springs and of their arms; shapes `(0:)` and `(0:, n_arms)`.
      real(dp), intent(inout) :: displacements(0:), arms(0:, :)
      real(dp) :: spring(0:size(arms, 2))
      integer :: k

      do k = self%first, last
         spring(0) = displacements(k)
         spring(1:) = arms(k, :)
         spring(:) = matmul(self%map, spring)
         displacements(k) = spring(0)
         arms(k, :) = spring(1:)
      end do
      self%first = huge(1)
   end subroutine wake_tail

end module adfric_round_timed_adhesion_tail

! SPDX-License-Identifier: GPL-3.0-or-later
!> A period as spans in which small changes of the state and of the penetration pass, edges that move being one of them.
!>
!> See `adfric_foundation_stepping_response` for the equations.
module adfric_foundation_stepping_spans
   use adfric_base_kinds, only: dp
   use adfric_numerics_lapack, only: dgesv
   use adfric_foundation_stepping_solid, only: solid_t, multiply, product_of
   use adfric_foundation_stepping_path, only: decay_of, expm1_of
   implicit none (type, external)
   private
   public :: span_t, get_response, solve

   !> Solutions that are larger are none: the system is singular.
   real(dp), parameter :: largest = 1.0e30_dp

   !> A part of a period, and the edge behind it.
   type :: span_t
      !> Is it contact? Else it is open.
      logical :: is_contact = .true.
      !> Its share of the period.
      real(dp) :: duration = 0
      !> Time between the edges of two states behind it.
      real(dp) :: crossing = 0
      !> By how much the edge moves with m; 0 where w does not jump.
      real(dp) :: delay = 0
      !> By how much what the dashpots follow jumps there, and the displacement.
      real(dp) :: target_step = 0, displacement_step = 0
   end type span_t

contains

   !> What a unit of each length, and a unit less of penetration, adds to the lengths in a period, and to the integral of w - D.
   pure subroutine get_response(solid, spans, growth, displacement)
      type(solid_t), intent(in) :: solid
      type(span_t), intent(in) :: spans(:)
      !> Receives what is added to the lengths; shape `(n_arms, n_arms + 1)`.
      real(dp), intent(out) :: growth(:, :)
      !> Receives what is added to the integral; shape `(n_arms + 1)`.
      real(dp), intent(out) :: displacement(:)
      real(dp) :: vectors(solid%n, solid%n + 1), moved(solid%n + 1)
      integer :: i, k

      vectors = 0
      do i = 1, solid%n
         vectors(i, i) = 1
      end do
      growth = 0
      displacement = 0
      do i = 1, size(spans)
         if (spans(i)%is_contact) then
            call pass_contact(solid, spans(i)%duration, vectors, growth)
         else
            call pass_open(solid, spans(i)%duration, vectors, growth, displacement)
         end if
         if (spans(i)%delay > 0) moved = spans(i)%delay*largest_position(solid, vectors, spans(i)%crossing)
         if (spans(i)%crossing > 0) call pass_open(solid, spans(i)%crossing, vectors, growth, displacement)
         if (.not. spans(i)%delay > 0) cycle
         displacement = displacement + spans(i)%displacement_step*moved
         do k = 1, size(vectors, 2)
            vectors(:, k) = vectors(:, k) + spans(i)%target_step*moved(k)/solid%time
            growth(:, k) = growth(:, k) + spans(i)%target_step*moved(k)/solid%time
         end do
      end do
   end subroutine get_response

   !> The change of m, or the largest within a time of openness.
   pure function largest_position(solid, vectors, time) result(positions)
      type(solid_t), intent(in) :: solid
      !> Changes of the lengths; shape `(n_arms, n_arms + 1)`.
      real(dp), intent(in) :: vectors(:, :)
      !> The time, or 0.
      real(dp), intent(in) :: time
      real(dp) :: positions(size(vectors, 2)), elements(solid%n)
      integer :: k, last

      last = size(vectors, 2)
      do k = 1, last
         positions(k) = sum(solid%stiffness*vectors(:, k))/solid%glassy
      end do
      positions(last) = positions(last) + 1/solid%glassy
      if (.not. time > 0) return
      do k = 1, last
         ! the last vector has a unit less of penetration, to which all lengths tend
         elements = product_of(solid%elements_of_lengths, vectors(:, k) - merge(1, 0, k == last))
         positions(k) = sum(max(elements, elements*decay_of(time/solid%retardation))) + merge(1, 0, k == last)
      end do
   end function largest_position

   !> Pass contact: lengths tend to heights that stay as they are.
   pure subroutine pass_contact(solid, duration, vectors, growth)
      type(solid_t), intent(in) :: solid
      !> Its time.
      real(dp), intent(in) :: duration
      !> Changes of the lengths; shape `(n_arms, n_arms + 1)`.
      real(dp), intent(inout) :: vectors(:, :)
      !> What has been added to them; shape `(n_arms, n_arms + 1)`.
      real(dp), intent(inout) :: growth(:, :)
      real(dp) :: lost(solid%n)
      integer :: k

      lost = expm1_of(-duration/solid%time)
      do k = 1, size(vectors, 2)
         growth(:, k) = growth(:, k) + lost*vectors(:, k)
         vectors(:, k) = vectors(:, k) + lost*vectors(:, k)
      end do
   end subroutine pass_contact

   !> Pass an open zone: Kelvin elements relax, and lengths tend to what the penetration is less.
   pure subroutine pass_open(solid, duration, vectors, growth, displacement)
      type(solid_t), intent(in) :: solid
      real(dp), intent(in) :: duration
      real(dp), intent(inout) :: vectors(:, :), growth(:, :)
      !> What has been added to the integral of w - D; shape `(n_arms + 1)`.
      real(dp), intent(inout) :: displacement(:)
      real(dp), dimension(size(vectors, 1), size(vectors, 2)) :: elements
      real(dp) :: lost(solid%n)
      integer :: k, last

      last = size(vectors, 2)
      lost = expm1_of(-duration/solid%retardation)
      vectors(:, last) = vectors(:, last) - 1
      call multiply(solid%n, last, solid%elements_of_lengths, vectors, .false., elements)
      do k = 1, last
         elements(:, k) = lost*elements(:, k)
         displacement(k) = displacement(k) - sum(solid%retardation*elements(:, k))
      end do
      call multiply(solid%n, last, solid%lengths_of_elements, elements, .true., vectors)
      call multiply(solid%n, last, solid%lengths_of_elements, elements, .true., growth)
      vectors(:, last) = vectors(:, last) + 1
      displacement(last) = displacement(last) + duration
   end subroutine pass_open

   !> Solve (I - J) x = b, J - I being the growth of units of each length.
   pure subroutine solve(growth, vectors, is_solved)
      !> The growth; shape `(n_arms, n_arms)`.
      real(dp), intent(in) :: growth(:, :)
      !> In: right sides. Out: solutions; shape `(n_arms, n_vectors)`.
      real(dp), intent(inout) :: vectors(:, :)
      logical, intent(out) :: is_solved
      real(dp) :: matrix(size(growth, 1), size(growth, 1))
      integer :: pivots(size(growth, 1)), info

      is_solved = .true.
      if (size(growth, 1) == 0) return
      matrix = -growth
      call dgesv(size(growth, 1), size(vectors, 2), matrix, size(growth, 1), pivots, vectors, size(growth, 1), info)
      is_solved = info == 0 .and. all(abs(vectors) <= largest)
   end subroutine solve

end module adfric_foundation_stepping_spans

! SPDX-License-Identifier: GPL-3.0-or-later
!> The curves of a data set whose points differ in more than the abscissa: points with the same values of its further variables.
!>
!> A curve has one set of values, so it has one fold, and one position of a point on it. What belongs to the measurement, such as the
!> zeros, is that of the data set.
module adfric_fit_parts
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_fit_order, only: order_of
   use adfric_fit_problem, only: data_set_t
   implicit none (type, external)
   private
   public :: curve_points_t, list_curves, number_curves, take_part, set_values_at, has_others

   !> The points of a curve.
   type :: curve_points_t
      !> Number of the data set.
      integer :: data_set = 0
      !> Indices of the points in it.
      integer, allocatable :: points(:)
   end type curve_points_t

contains

   !> Have the points of a data set values of further variables?
   pure logical function has_others(data)
      !> The data set.
      type(data_set_t), intent(in) :: data

      has_others = .false.
      if (allocated(data%others)) has_others = size(data%others) > 0
   end function has_others

   !> The curves of all data sets, in the order of these. A data set without further variables is one curve, whatever its points.
   pure subroutine list_curves(data_sets, curves)
      !> The data sets.
      type(data_set_t), intent(in) :: data_sets(:)
      !> Receives the curves.
      type(curve_points_t), allocatable, intent(out) :: curves(:)
      integer, allocatable :: number(:)
      integer :: n_curves(size(data_sets)), g, c, n, i

      do g = 1, size(data_sets)
         n_curves(g) = 1
         if (has_others(data_sets(g))) n_curves(g) = maxval([number_curves(data_sets(g)), 0])
      end do
      allocate (curves(sum(n_curves)), number(0))
      n = 0
      do g = 1, size(data_sets)
         number = number_curves(data_sets(g))
         do c = 1, n_curves(g)
            n = n + 1
            curves(n)%data_set = g
            curves(n)%points = pack([(i, i=1, size(number))], number == c)
         end do
      end do
   end subroutine list_curves

   !> Number of the curve of each point, from 1, in the order in which they come; 0 for a point that is not used, or has no value.
   pure function number_curves(data) result(curve)
      !> The data set.
      type(data_set_t), intent(in) :: data
      integer :: curve(size(data%x))
      integer :: rank(size(data%x)), first(size(data%x)), j, i, n
      real(dp) :: key(size(data%x))

      curve = 1
      if (.not. has_others(data)) return
      if (allocated(data%is_used)) curve = merge(1, 0, data%is_used)
      do j = 1, size(data%others)
         rank = rank_of(data%at(j, :))
         key = merge(real(curve, dp)*(size(curve) + 1) + rank, not_a_number(), rank > 0 .and. curve > 0)
         curve = rank_of(key)
      end do
      n = 0
      first = 0
      do i = 1, size(curve)
         if (curve(i) == 0) cycle
         if (first(curve(i)) == 0) then
            n = n + 1
            first(curve(i)) = n
         end if
         curve(i) = first(curve(i))
      end do
   end function number_curves

   !> Ranks of numbers, from 1; equal ones have one rank, and what is no number has 0.
   pure function rank_of(numbers) result(rank)
      !> The numbers.
      real(dp), intent(in) :: numbers(:)
      integer :: rank(size(numbers)), order(size(numbers)), i, n
      real(dp) :: last

      rank = 0
      order = order_of(merge(numbers, huge(1.0_dp), ieee_is_finite(numbers)))
      n = 0
      last = 0
      do i = 1, size(numbers)
         associate (number => numbers(order(i)))
            if (.not. ieee_is_finite(number)) cycle
            if (n == 0 .or. number > last) n = n + 1
            last = number
            rank(order(i)) = n
         end associate
      end do
   end function rank_of

   !> Some points of a data set, with all else that it has.
   pure subroutine take_part(from, points, part)
      !> The data set.
      type(data_set_t), intent(in) :: from
      !> Indices of the points.
      integer, intent(in) :: points(:)
      !> Receives the data set of these points.
      type(data_set_t), intent(out) :: part

      part = from
      part%x = from%x(points)
      part%y = from%y(points)
      if (allocated(from%sigma)) part%sigma = from%sigma(points)
      if (allocated(from%x_sigma)) part%x_sigma = from%x_sigma(points)
      if (allocated(from%at)) part%at = from%at(:, points)
      if (allocated(from%is_contact)) part%is_contact = from%is_contact(points)
      if (allocated(from%prescribed)) part%prescribed = from%prescribed(points)
      if (allocated(from%segment)) part%segment = from%segment(points)
      if (allocated(from%is_used)) part%is_used = from%is_used(points)
   end subroutine take_part

   !> Put the further variables of a point to where they belong.
   pure subroutine set_values_at(data, point, values)
      !> The data set.
      type(data_set_t), intent(in) :: data
      !> Index of the point; where there is none, nothing is done.
      integer, intent(in) :: point
      !> Values of all variables of the model.
      real(dp), intent(inout) :: values(:)

      if (.not. has_others(data)) return
      if (point > size(data%x)) return
      values(data%others) = data%at(:, point)
   end subroutine set_values_at

end module adfric_fit_parts

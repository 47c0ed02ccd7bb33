! SPDX-License-Identifier: GPL-3.0-or-later
!> The points of a `&data` group: from the columns of a file to a data set.
module adfric_input_fit_points
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_text, only: show_count, show_number
   use adfric_base_unset, only: is_set
   use adfric_fit_problem, only: data_set_t
   use adfric_input_fit_data_group, only: data_group_t
   use adfric_input_variable, only: find_outlier
   use adfric_describe_model, only: model_t
   use adfric_describe_table, only: variable_t
   use adfric_system_checksum, only: checksum_t
   implicit none (type, external)
   private
   public :: columns_t, set_points, add_to_checksum, count_points, point_counts_t, find_flaw, find_outside

   !> Columns of one curve in SI units; one that is not there is not allocated.
   type :: columns_t
      !> Abscissa and ordinate.
      real(dp), allocatable :: x(:), y(:)
      !> Standard errors of both.
      real(dp), allocatable :: sigma(:), x_sigma(:)
      !> 1 in contact, 0 free; and the number of the segment.
      real(dp), allocatable :: branch(:), segment(:)
      !> Further variables of the model; shape `(n_others, n)`.
      real(dp), allocatable :: at(:, :)
   end type columns_t

   !> What there is of points, summed over curves.
   type :: point_counts_t
      !> Points, those that are used, those without a number, those outside of the range, and those that are free.
      integer :: n = 0, n_used = 0, n_without = 0, n_outside = 0, n_free = 0
      !> Range of abscissa and ordinate over the points that are used.
      real(dp) :: x(2) = [huge(1.0_dp), -huge(1.0_dp)], y(2) = [huge(1.0_dp), -huge(1.0_dp)]
   end type point_counts_t

contains

   !> Make a data set of columns.
   subroutine set_points(group, columns, data_set)
      !> The `&data` group.
      class(data_group_t), intent(in) :: group
      type(columns_t), intent(in) :: columns
      !> Receives the points; the rest of it is that of the group.
      type(data_set_t), intent(inout) :: data_set
      logical, allocatable :: is_used(:)

      data_set%x = columns%x
      data_set%y = columns%y
      is_used = ieee_is_finite(columns%x) .and. ieee_is_finite(columns%y)
      if (allocated(columns%sigma)) then
         data_set%sigma = columns%sigma
      else if (is_set(group%sigma)) then
         data_set%sigma = spread(group%sigma, 1, size(columns%x))
      else if (is_set(group%relative_sigma)) then
         data_set%sigma = group%relative_sigma*abs(columns%y)
      end if
      if (allocated(columns%x_sigma)) then
         data_set%x_sigma = columns%x_sigma
      else if (is_set(group%abscissa_sigma)) then
         data_set%x_sigma = spread(group%abscissa_sigma, 1, size(columns%x))
      end if
      call need_positive(data_set%sigma, is_used)
      call need_positive(data_set%x_sigma, is_used)
      if (allocated(columns%branch)) then
         is_used = is_used .and. .not. ieee_is_nan(columns%branch)
         data_set%is_contact = is_above(columns%branch, 0.5_dp)
      end if
      if (allocated(columns%segment)) then
         is_used = is_used .and. .not. ieee_is_nan(columns%segment)
         data_set%segment = nint(merge(columns%segment, 0.0_dp, is_used))
      end if
      if (allocated(columns%at)) then
         data_set%at = columns%at
         is_used = is_used .and. all(ieee_is_finite(columns%at), 1)
      end if
      if (is_set(group%from)) is_used = is_used .and. .not. is_above(-columns%x, -group%from)
      if (is_set(group%to)) is_used = is_used .and. .not. is_above(columns%x, group%to)
      call move_alloc(is_used, data_set%is_used)
   end subroutine set_points

   !> Is a number above a bound? What is no number is above none, and is not compared.
   elemental logical function is_above(value, bound)
      !> The number, or NaN.
      real(dp), intent(in) :: value
      real(dp), intent(in) :: bound

      is_above = .false.
      if (ieee_is_finite(value)) is_above = value > bound
   end function is_above

   !> Points without a standard error are not used.
   pure subroutine need_positive(sigma, is_used)
      !> Standard errors; not allocated: none is needed.
      real(dp), allocatable, intent(in) :: sigma(:)
      logical, intent(inout) :: is_used(:)

      if (.not. allocated(sigma)) return
      is_used = is_used .and. is_above(sigma, 0.0_dp)
   end subroutine need_positive

   !> What is wrong with columns whatever their order; empty if nothing is.
   pure subroutine find_flaw(columns, flaw)
      type(columns_t), intent(in) :: columns
      character(:), allocatable, intent(out) :: flaw
      integer :: i

      flaw = ''
      call find_not_positive(columns%sigma, 'the ordinate', flaw)
      call find_not_positive(columns%x_sigma, 'the abscissa', flaw)
      if (.not. allocated(columns%branch)) return
      do i = 1, size(columns%branch)
         if (ieee_is_nan(columns%branch(i))) cycle
         if (.not. (abs(columns%branch(i)) > 0) .or. .not. (abs(columns%branch(i) - 1) > 0)) cycle
         flaw = 'the branch of point '//show_count(i)//' is neither, given '//show_number(columns%branch(i))// &
            ', allowed: 1 in contact, 0 free'
         return
      end do
   end subroutine find_flaw

   !> A value of the abscissa or of a further variable that the model does not take. An approach has a zero of its own, which is not
   !> known here.
   pure subroutine find_outside(group, model, columns, flaw)
      !> The `&data` group with its further variables.
      class(data_group_t), intent(in) :: group
      class(model_t), intent(in) :: model
      type(columns_t), intent(in) :: columns
      !> Receives what is wrong; empty if nothing is.
      character(:), allocatable, intent(out) :: flaw
      integer :: i, k

      flaw = ''
      associate (row => model%variables(group%data_set%abscissa))
         if (row%own_name() /= 'approach') then
            do i = 1, size(columns%x)
               if (is_set(group%from) .and. is_above(-columns%x(i), -group%from)) cycle
               if (is_set(group%to) .and. is_above(columns%x(i), group%to)) cycle
               call check_value(row, columns%x(i), i, flaw)
               if (len(flaw) > 0) return
            end do
         end if
      end associate
      if (.not. allocated(columns%at)) return
      do k = 1, size(columns%at, 1)
         do i = 1, size(columns%at, 2)
            call check_value(model%variables(group%data_set%others(k)), columns%at(k, i), i, flaw)
            if (len(flaw) > 0) return
         end do
      end do
   end subroutine find_outside

   !> Say what is wrong with the value of a point for its variable; what is no number is no value.
   pure subroutine check_value(row, value, point, flaw)
      type(variable_t), intent(in) :: row
      real(dp), intent(in) :: value
      !> Number of the point.
      integer, intent(in) :: point
      !> Receives what is wrong; empty if nothing is.
      character(:), allocatable, intent(out) :: flaw
      integer :: first

      flaw = ''
      if (.not. ieee_is_finite(value)) return
      call find_outlier([value], row, first, flaw)
      if (len(flaw) > 0) flaw = row%name//' is out of range at point '//show_count(point)//', given '//show_number(value)// &
         flaw(index(flaw, ', allowed'):)
   end subroutine check_value

   !> Find a standard error that is none.
   pure subroutine find_not_positive(sigma, whose, flaw)
      !> Standard errors; not allocated: there are none.
      real(dp), allocatable, intent(in) :: sigma(:)
      !> Of what they are, for the message.
      character(*), intent(in) :: whose
      !> Receives what is wrong.
      character(:), allocatable, intent(inout) :: flaw
      integer :: i

      if (.not. allocated(sigma)) return
      do i = 1, size(sigma)
         if (ieee_is_nan(sigma(i))) cycle
         if (sigma(i) > 0) cycle
         flaw = 'the standard error of '//whose//' of point '//show_count(i)//' is none, given '//show_number(sigma(i))// &
            ', allowed: a number > 0, or nan where there is no point'
         return
      end do
   end subroutine find_not_positive

   !> Add columns to a checksum.
   subroutine add_to_checksum(columns, sum)
      type(columns_t), intent(in) :: columns
      type(checksum_t), intent(inout) :: sum

      call sum%add_reals(columns%x)
      call sum%add_reals(columns%y)
      if (allocated(columns%sigma)) call sum%add_reals(columns%sigma)
      if (allocated(columns%x_sigma)) call sum%add_reals(columns%x_sigma)
      if (allocated(columns%branch)) call sum%add_reals(columns%branch)
      if (allocated(columns%segment)) call sum%add_reals(columns%segment)
      if (allocated(columns%at)) call sum%add_reals(reshape(columns%at, [size(columns%at)]))
   end subroutine add_to_checksum

   !> Count the points of a curve.
   pure subroutine count_points(data_set, counts)
      type(data_set_t), intent(in) :: data_set
      !> The counts, to which those of the curve are added.
      type(point_counts_t), intent(inout) :: counts
      logical :: is_number(size(data_set%x))

      is_number = ieee_is_finite(data_set%x) .and. ieee_is_finite(data_set%y)
      counts%n = counts%n + size(data_set%x)
      counts%n_used = counts%n_used + count(data_set%is_used)
      counts%n_without = counts%n_without + count(.not. is_number)
      counts%n_outside = counts%n_outside + count(is_number .and. .not. data_set%is_used)
      if (allocated(data_set%is_contact)) counts%n_free = counts%n_free + count(data_set%is_used .and. .not. data_set%is_contact)
      counts%x = [min(counts%x(1), minval(data_set%x, mask=data_set%is_used)), &
         max(counts%x(2), maxval(data_set%x, mask=data_set%is_used))]
      counts%y = [min(counts%y(1), minval(data_set%y, mask=data_set%is_used)), &
         max(counts%y(2), maxval(data_set%y, mask=data_set%is_used))]
   end subroutine count_points

end module adfric_input_fit_points

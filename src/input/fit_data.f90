! SPDX-License-Identifier: GPL-3.0-or-later
!> The points of all `&data` groups: read, counted, and compared with what a fit needs.
module adfric_input_fit_data
   use adfric_base_kinds, only: dp, i8
   use adfric_base_text, only: show_count
   use adfric_base_unset, only: is_set
   use adfric_fit_problem, only: data_set_t, fit_t, loss_gauss
   use adfric_input_fit_data_group, only: data_group_t
   use adfric_input_fit_points, only: add_to_checksum, columns_t, count_points, find_flaw, find_outside, point_counts_t, &
      set_points
   use adfric_input_fit_stack, only: file_of, is_dataset, open_stack_file, path_of, stack_file_t
   use adfric_input_fit_table, only: read_table_columns
   use adfric_input_reading, only: reading_t
   use adfric_describe_model, only: model_t
   use adfric_run_dataset, only: dataset_t
   use adfric_system_checksum, only: checksum_t
   implicit none (type, external)
   private
   public :: loaded_data_t, load_data, check_data

   !> Curves that are read at once.
   integer, parameter :: curves_at_once = 64

   !> What is known of the points of all groups.
   type :: loaded_data_t
      !> Points of each group, over all curves.
      type(point_counts_t), allocatable :: counts(:)
      !> Names and checksums, as the results file has them.
      type(dataset_t), allocatable :: datasets(:)
      !> Points of each group, of one curve, or of all curves of a stack together.
      type(data_set_t), allocatable :: data_sets(:)
      !> Open columns of a stack, closed ones of other groups.
      type(stack_file_t), allocatable :: files(:)
      !> Number of curves along each dimension, the slowest first; size 0 for a single fit.
      integer(i8), allocatable :: lengths(:)
   contains
      procedure :: has_sigma
   end type loaded_data_t

contains

   !> Read the points of all groups.
   subroutine load_data(r, groups, is_together, loaded)
      type(reading_t), intent(in) :: r
      !> The `&data` groups, all of them whole.
      type(data_group_t), intent(in) :: groups(:)
      !> Are the curves of a stack fitted together?
      logical, intent(in) :: is_together
      !> Receives the points, or the open stacks.
      type(loaded_data_t), intent(out) :: loaded
      character(:), allocatable :: variable, flaw
      integer :: g, n_before

      n_before = r%problems%count()
      allocate (loaded%counts(size(groups)), loaded%datasets(size(groups)), loaded%data_sets(size(groups)), &
         loaded%files(size(groups)), loaded%lengths(0))
      do g = 1, size(groups)
         loaded%data_sets(g) = groups(g)%data_set
         loaded%data_sets(g)%name = groups(g)%file
         if (is_dataset(groups(g)%file) .and. .not. allocated(groups(g)%table)) then
            call load_stack(groups(g), r%model, is_together, loaded, g, variable, flaw)
         else
            call load_table(groups(g), r%model, loaded, g, variable, flaw)
         end if
         if (len(flaw) > 0) call groups(g)%reader%report(r, variable, flaw)
      end do
      if (r%problems%count() == n_before .and. .not. is_together) call find_lengths(r, groups, loaded)
      if (r%problems%count() == n_before .and. size(loaded%lengths) > 0) return
      do g = 1, size(groups)
         call loaded%files(g)%close()
      end do
   end subroutine load_data

   !> Read a table.
   subroutine load_table(group, model, loaded, g, variable, flaw)
      !> The `&data` group.
      type(data_group_t), intent(in) :: group
      class(model_t), intent(in) :: model
      type(loaded_data_t), intent(inout) :: loaded
      integer, intent(in) :: g
      !> Variable of the group that a flaw is one of.
      character(:), allocatable, intent(out) :: variable
      !> What is wrong; empty if nothing is wrong.
      character(:), allocatable, intent(out) :: flaw
      type(columns_t) :: columns
      type(checksum_t) :: sum

      call read_table_columns(group, model, columns, loaded%datasets(g)%form, variable, flaw)
      if (len(flaw) > 0) return
      call set_points(group, columns, loaded%data_sets(g))
      call count_points(loaded%data_sets(g), loaded%counts(g))
      call add_to_checksum(columns, sum)
      loaded%datasets(g)%text = group%file
      loaded%datasets(g)%file = group%file
      loaded%datasets(g)%path = ''
      call describe(loaded, g, sum, [size(columns%x, kind=i8)])
   end subroutine load_table

   !> Read every curve of a stack, to know what is in it; those of a single fit are kept.
   subroutine load_stack(group, model, is_together, loaded, g, variable, flaw)
      type(data_group_t), intent(in) :: group
      class(model_t), intent(in) :: model
      logical, intent(in) :: is_together
      !> Receives the points, or what is known of them.
      type(loaded_data_t), intent(inout) :: loaded
      integer, intent(in) :: g
      character(:), allocatable, intent(out) :: variable, flaw
      type(columns_t), allocatable :: curves(:)
      type(columns_t) :: all_curves
      type(checksum_t) :: sum
      type(data_set_t) :: curve
      integer(i8) :: first, n_curves
      integer :: i
      logical :: is_read

      call open_stack_file(loaded%files(g), group, model, variable, flaw)
      if (len(flaw) > 0) return
      n_curves = product(loaded%files(g)%lengths)
      do first = 1, n_curves, curves_at_once
         allocate (curves(min(int(curves_at_once, i8), n_curves - first + 1)))
         call loaded%files(g)%read_columns(first, curves, is_read)
         if (.not. is_read) flaw = 'the values cannot be read'
         do i = 1, size(curves)
            if (len(flaw) > 0) exit
            call find_flaw(curves(i), flaw)
            if (len(flaw) == 0) call find_outside(group, model, curves(i), flaw)
            if (len(flaw) > 0 .and. n_curves > 1) flaw = 'curve '//show_count(first + i - 1)//': '//flaw
            if (len(flaw) > 0) exit
            curve = group%data_set
            call set_points(group, curves(i), curve)
            call count_points(curve, loaded%counts(g))
            call add_to_checksum(curves(i), sum)
            if (is_together .or. n_curves == 1) call append(curves(i), int(first) + i - 1, n_curves > 1, all_curves)
         end do
         deallocate (curves)
         if (len(flaw) > 0) then
            variable = 'file'
            call loaded%files(g)%close()
            return
         end if
      end do
      if (is_together .or. n_curves == 1) call set_points(group, all_curves, loaded%data_sets(g))
      loaded%datasets(g)%text = group%file
      loaded%datasets(g)%file = file_of(group%file)
      loaded%datasets(g)%path = path_of(group%file)
      call describe(loaded, g, sum, [loaded%files(g)%lengths, int(loaded%files(g)%n_points, i8)])
   end subroutine load_stack

   !> Add a curve to others; each is a segment of its own.
   subroutine append(curve, number, is_numbered, all_curves)
      type(columns_t), intent(in) :: curve
      !> Its number, from 1.
      integer, intent(in) :: number
      !> Is the number that of the segment?
      logical, intent(in) :: is_numbered
      !> The others, to which it is added.
      type(columns_t), intent(inout) :: all_curves

      call append_column(curve%x, all_curves%x)
      call append_column(curve%y, all_curves%y)
      call append_column(curve%sigma, all_curves%sigma)
      call append_column(curve%x_sigma, all_curves%x_sigma)
      call append_column(curve%branch, all_curves%branch)
      ! a stack has none
      if (allocated(curve%at)) all_curves%at = curve%at
      if (is_numbered) then
         call append_column(spread(real(number, dp), 1, size(curve%x)), all_curves%segment)
      else
         call append_column(curve%segment, all_curves%segment)
      end if
   end subroutine append

   !> Add values to a column.
   subroutine append_column(values, column)
      !> The values; not present or not allocated: there is no such column.
      real(dp), intent(in), optional :: values(:)
      !> The column, which grows.
      real(dp), allocatable, intent(inout) :: column(:)

      if (.not. present(values)) return
      if (.not. allocated(column)) allocate (column(0))
      column = [column, values]
   end subroutine append_column

   !> What the results file says of the data.
   subroutine describe(loaded, g, sum, counts)
      !> The counts, and the dataset that receives the rest.
      type(loaded_data_t), intent(inout) :: loaded
      integer, intent(in) :: g
      type(checksum_t), intent(in) :: sum
      !> Number of values along each dimension, the slowest first.
      integer(i8), intent(in) :: counts(:)

      associate (dataset => loaded%datasets(g))
         dataset%counts = counts
         dataset%units = ''
         dataset%lowest = loaded%counts(g)%y(1)
         dataset%highest = loaded%counts(g)%y(2)
         dataset%checksum = sum%to_text()
      end associate
   end subroutine describe

   !> Find the shape of the stack: all groups have the same.
   subroutine find_lengths(r, groups, loaded)
      type(reading_t), intent(in) :: r
      !> The `&data` groups.
      type(data_group_t), intent(in) :: groups(:)
      !> In: the open stacks. Out: also the shape.
      type(loaded_data_t), intent(inout) :: loaded
      logical :: is_same
      integer :: g

      do g = 1, size(groups)
         if (allocated(loaded%files(g)%lengths)) then
            if (size(loaded%files(g)%lengths) > 0) loaded%lengths = loaded%files(g)%lengths
         end if
      end do
      if (size(loaded%lengths) == 0) return
      do g = 1, size(groups)
         is_same = allocated(loaded%files(g)%lengths)
         if (is_same) is_same = size(loaded%files(g)%lengths) == size(loaded%lengths)
         if (is_same) is_same = all(loaded%files(g)%lengths == loaded%lengths)
         if (.not. is_same) call groups(g)%reader%report(r, 'file', 'not as many curves as in another &data, given ''' &
            //groups(g)%file//''', allowed: stacks of one shape')
      end do
   end subroutine find_lengths

   !> Are there points enough for a single fit, and standard errors where they are needed?
   subroutine check_data(r, groups, loaded, fit)
      type(reading_t), intent(in) :: r
      type(data_group_t), intent(in) :: groups(:)
      type(loaded_data_t), intent(in) :: loaded
      type(fit_t), intent(in) :: fit
      integer :: g, n, n_priors
      logical :: is_known

      n_priors = count(is_set([(fit%frees(g)%prior, g=1, size(fit%frees))]))
      n = size(fit%events) + n_priors
      is_known = .true.
      do g = 1, size(groups)
         n = n + loaded%counts(g)%n_used
         is_known = has_errors(groups(g), loaded, g)
         if (loaded%counts(g)%n_used == 0) then
            call groups(g)%reader%report(r, 'file', say_no_points(groups(g), loaded%counts(g)))
         else if (loaded%counts(g)%n_free == loaded%counts(g)%n_used) then
            call groups(g)%reader%report(r, 'file', 'no point is in contact, given '//show_count(loaded%counts(g)%n_used) &
               //' free points in '//groups(g)%file//', needed: points in contact')
         end if
         if (is_known) cycle
         if (size(groups) > 1) call groups(g)%reader%report(r, 'sigma', 'not given, needed: standard errors, by which several ' &
            //'&data are weighed')
         if (groups(g)%data_set%loss /= loss_gauss) call groups(g)%reader%report(r, 'loss', 'needs standard errors, allowed ' &
            //'without them: ''gauss''')
         if (allocated(loaded%data_sets(g)%x_sigma)) call groups(g)%reader%report(r, 'abscissa_sigma', 'needs standard errors ' &
            //'of the ordinate beside')
         if (size(fit%events) + n_priors > 0) call groups(g)%reader%report(r, 'sigma', 'not given, needed: standard errors, ' &
            //'by which points and events or priors are weighed')
      end do
      if (r%problems%count() > 0 .or. size(loaded%lengths) > 0) return
      if (n < size(fit%frees) .or. (n == size(fit%frees) .and. .not. is_known)) call groups(1)%reader%report(r, 'file', &
         'too few points, given '//show_count(n)//' points, events and priors for '//show_count(size(fit%frees)) &
         //' free variables, needed: at least '//show_count(size(fit%frees) + merge(0, 1, is_known)))
   end subroutine check_data

   !> Has a group standard errors of the ordinate from its file, or of all points?
   pure logical function has_sigma(self, g)
      class(loaded_data_t), intent(in) :: self
      integer, intent(in) :: g

      has_sigma = allocated(self%data_sets(g)%sigma)
      if (size(self%lengths) > 0) has_sigma = has_sigma .or. self%files(g)%has_sigma()
   end function has_sigma

   !> Have the points of a group standard errors?
   pure logical function has_errors(group, loaded, g)
      type(data_group_t), intent(in) :: group
      type(loaded_data_t), intent(in) :: loaded
      integer, intent(in) :: g

      has_errors = is_set(group%sigma) .or. is_set(group%relative_sigma) .or. loaded%has_sigma(g)
   end function has_errors

   !> Why there are no points.
   function say_no_points(group, counts) result(text)
      type(data_group_t), intent(in) :: group
      type(point_counts_t), intent(in) :: counts
      character(:), allocatable :: text

      text = 'no point can be used, given '//show_count(counts%n)//' points in '//group%file
      if (counts%n_without > 0) text = text//', '//show_count(counts%n_without)//' of them without a number'
      if (counts%n_outside > 0) text = text//', '//show_count(counts%n_outside)//' outside of from and to or without a ' &
         //'standard error'
      text = text//', needed: points with numbers'
   end function say_no_points

end module adfric_input_fit_data

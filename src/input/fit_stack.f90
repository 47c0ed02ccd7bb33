! SPDX-License-Identifier: GPL-3.0-or-later
!> The points of `&data` groups from HDF5 files: one curve each, or stacks of curves.
!>
!> HDF5 serves one thread at a time: what reads here while points are solved takes turns with what writes the results.
module adfric_input_fit_stack
   use adfric_base_kinds, only: dp, i8
   use adfric_base_text, only: join_words, show_count, show_text
   use adfric_base_units, only: unit_t, to_si
   use adfric_base_unset, only: is_set
   use adfric_fit_curve_source, only: curve_source_t
   use adfric_fit_problem, only: data_set_t
   use adfric_hdf5_members, only: find_members
   use adfric_hdf5_stacks, only: row_stack_t, open_row_stack
   use adfric_input_dataset, only: honour_name
   use adfric_input_fit_data_group, only: data_group_t, is_history
   use adfric_input_fit_history, only: prescribe_curve, stack_history_t
   use adfric_input_fit_points, only: columns_t, set_points
   use adfric_input_fit_table, only: is_wanted
   use adfric_input_unit_match, only: match_units
   use adfric_describe_model, only: model_t
   implicit none (type, external)
   private
   public :: stack_file_t, hdf5_stack_t, is_dataset, file_of, path_of, open_stack_file

   !> What stands between the name of the file and that of the dataset, with which the latter begins.
   character(*), parameter :: divider = ':/'
   !> Columns of a stack.
   integer, parameter :: c_x = 1, c_y = 2, c_sigma = 3, c_x_sigma = 4, c_branch = 5, c_segment = 6, n_columns = 6

   !> A column.
   type :: stack_column_t
      !> Is there such a column?
      logical :: exists = .false.
      !> The open dataset.
      type(row_stack_t) :: rows
      !> Its unit.
      type(unit_t) :: unit
      !> The values that all curves share, in SI units; not allocated if each has its own.
      real(dp), allocatable :: shared(:)
   end type stack_column_t

   !> The columns of a `&data` group.
   type :: stack_file_t
      !> Columns, `c_...`.
      type(stack_column_t) :: columns(n_columns)
      !> Columns of the further variables of the group.
      type(stack_column_t), allocatable :: others(:)
      !> Number of curves along each dimension, the slowest first; size 0 for one curve.
      integer(i8), allocatable :: lengths(:)
      !> Points of a curve.
      integer :: n_points = 0
   contains
      procedure :: has_sigma
      procedure :: read_columns
      procedure :: close => close_stack_file
   end type stack_file_t

   !> The curves of a run.
   type, extends(curve_source_t) :: hdf5_stack_t
      !> The `&data` groups, and their columns.
      type(data_group_t), allocatable :: groups(:)
      !> Columns of each group.
      type(stack_file_t), allocatable :: files(:)
      !> Where curves over time have their histories from.
      type(stack_history_t) :: history
   contains
      procedure :: get_curves
      procedure :: close => close_stack
   end type hdf5_stack_t

contains

   !> Does the name of a file name a dataset within it?
   pure logical function is_dataset(name)
      !> Name of a file, with that of a dataset or without.
      character(*), intent(in) :: name

      is_dataset = index(name, divider, back=.true.) > 1
   end function is_dataset

   !> The name of the file.
   pure function file_of(name) result(file)
      character(*), intent(in) :: name
      character(:), allocatable :: file

      file = name
      if (is_dataset(name)) file = name(:index(name, divider, back=.true.) - 1)
   end function file_of

   !> The name of the dataset within its file, or of its folder.
   pure function path_of(name) result(path)
      !> Name of a file with that of a dataset.
      character(*), intent(in) :: name
      character(:), allocatable :: path

      path = name(index(name, divider, back=.true.) + 1:)
   end function path_of

   !> Open the columns of a group. It is long by these: each has a name, a unit and a rule of its own.
   subroutine open_stack_file(self, group, model, variable, flaw)
      type(stack_file_t), intent(out) :: self
      !> The `&data` group.
      class(data_group_t), intent(in) :: group
      class(model_t), intent(in) :: model
      !> Variable of the group that a flaw is one of.
      character(:), allocatable, intent(out) :: variable
      character(:), allocatable, intent(out) :: flaw
      character(:), allocatable :: folder
      logical :: exists(4)
      integer :: k

      variable = 'file'
      folder = path_of(group%file)
      folder = folder(:index(folder, '/', back=.true.))
      call open_column(self%columns(c_y), file_of(group%file), path_of(group%file), group%y_unit, flaw)
      if (len(flaw) > 0) then
         if (index(flaw, 'given') == 0) flaw = flaw//', given '''//show_text(group%file)//''''
         call self%close()
         return
      end if
      associate (counts => self%columns(c_y)%rows%counts)
         self%lengths = counts(:size(counts) - 1)
         self%n_points = int(counts(size(counts)))
      end associate
      if (size(self%lengths) > 0 .and. .not. all([(is_history(model%variables(group%data_set%others(k))), &
         k=1, size(group%others))])) then
         variable = 'variables'
         flaw = 'beside a stack of curves, given '//show_count(product(self%lengths))//' curves in '//file_of(group%file)// &
            ', allowed: one curve'
         call self%close()
         return
      end if
      allocate (self%others(size(group%others)))
      call find_members(file_of(group%file), folder, 'sigma branch contact segment', exists, flaw)
      call add('abscissa_column', group%abscissa_column, model%variables(group%data_set%abscissa)%name, .true., .false., c_x, &
         group%x_unit)
      if (.not. (is_set(group%sigma) .or. is_set(group%relative_sigma))) call add('sigma_column', group%sigma_column, 'sigma', &
         .false., exists(1), c_sigma, group%y_unit)
      call add('abscissa_sigma_column', group%abscissa_sigma_column, '', .false., .false., c_x_sigma, group%x_unit)
      call add('branch_column', group%branch_column, trim(merge('branch ', 'contact', exists(2))), .false., exists(2) .or. &
         exists(3), c_branch, '-')
      call add('segment_column', group%segment_column, 'segment', .false., exists(4), c_segment, '-')
      do k = 1, size(self%others)
         if (len(flaw) > 0) exit
         variable = 'variables'
         call open_column(self%others(k), file_of(group%file), folder//group%others(k)%name, group%others(k)%unit, flaw)
         if (len(flaw) == 0) call check_shape(self, self%others(k), flaw)
         if (len(flaw) > 0) flaw = file_of(group%file)//': '//flaw
      end do
      if (len(flaw) > 0) call self%close()

   contains

      !> Add a column: that of the name that is given, else that of its usual name.
      subroutine add(of_variable, given, usual, is_needed, is_there, column, unit)
         !> Variable of the group that names the column.
         character(*), intent(in) :: of_variable
         !> Name that is given; not allocated if none is, empty if no column is wanted.
         character(:), allocatable, intent(in) :: given
         !> Usual name of the column; empty if it has none.
         character(*), intent(in) :: usual
         logical, intent(in) :: is_needed
         !> Is there a column of the usual name?
         logical, intent(in) :: is_there
         !> Which column, `c_...`.
         integer, intent(in) :: column
         !> SI unit that is wanted.
         character(*), intent(in) :: unit
         character(:), allocatable :: name

         if (len(flaw) > 0) return
         if (.not. is_wanted(given, is_needed, is_there)) return
         name = usual
         if (allocated(given)) then
            if (len(given) > 0) name = given
         end if
         variable = of_variable
         call open_column(self%columns(column), file_of(group%file), folder//name, unit, flaw)
         if (.not. (allocated(given) .or. is_needed) .and. allocated(self%columns(column)%rows%counts)) then
            ! a number of this name, as in results files, is no column
            if (size(self%columns(column)%rows%counts) == 0) flaw = ''
            if (size(self%columns(column)%rows%counts) == 0) return
         end if
         if (len(flaw) == 0) call check_shape(self, self%columns(column), flaw)
         if (len(flaw) > 0) flaw = file_of(group%file)//': '//flaw
      end subroutine add

   end subroutine open_stack_file

   !> Open a column, and find out how its numbers become SI units.
   subroutine open_column(self, file, path, unit, flaw)
      type(stack_column_t), intent(out) :: self
      character(*), intent(in) :: file, path, unit
      !> What is wrong; empty if nothing is wrong.
      character(:), allocatable, intent(out) :: flaw
      character(:), allocatable :: units

      call open_row_stack(self%rows, file, path, flaw)
      if (len(flaw) > 0) return
      self%exists = .true.
      units = self%rows%units
      call honour_name(path, units, flaw)
      if (len(flaw) == 0) call match_units(units, unit, 'dataset '//path, self%unit, flaw)
      if (len(flaw) > 0) flaw = flaw//', allowed: units of ['//unit//']'
   end subroutine open_column

   !> Has a column the shape of the ordinate, or that of one curve, which is then read?
   subroutine check_shape(self, item, flaw)
      !> The columns, with their ordinate.
      type(stack_file_t), intent(in) :: self
      !> The column; that of one curve is read.
      type(stack_column_t), intent(inout) :: item
      character(:), allocatable, intent(out) :: flaw
      real(dp), allocatable :: values(:, :)
      logical :: is_read, is_same

      flaw = ''
      if (size(item%rows%counts) == 1 .and. item%rows%row_length() == self%n_points) then
         allocate (values(self%n_points, 1))
         call item%rows%read_rows(1_i8, values, is_read)
         if (.not. is_read) flaw = 'the dataset cannot be read'
         if (is_read) item%shared = to_si(values(:, 1), item%unit)
         return
      end if
      is_same = size(item%rows%counts) == size(self%columns(c_y)%rows%counts)
      if (is_same) is_same = all(item%rows%counts == self%columns(c_y)%rows%counts)
      if (.not. is_same) flaw = 'the shape is not that of the ordinate, given '//show_shape(item%rows%counts)//', allowed: '// &
         show_shape(self%columns(c_y)%rows%counts)//' or '//show_count(self%n_points)
   end subroutine check_shape

   !> A shape in words.
   pure function show_shape(counts) result(text)
      !> Number of values along each dimension, the slowest first.
      integer(i8), intent(in) :: counts(:)
      character(:), allocatable :: text
      integer :: k

      text = ''
      do k = 1, size(counts)
         text = text//' '//show_count(counts(k))
      end do
      text = join_words(trim(adjustl(text)), ' x ')
   end function show_shape

   !> Has the stack standard errors of the ordinate?
   pure logical function has_sigma(self)
      class(stack_file_t), intent(in) :: self

      has_sigma = self%columns(c_sigma)%exists
   end function has_sigma

   !> Read neighbouring curves.
   subroutine read_columns(self, first, curves, is_read)
      class(stack_file_t), intent(in) :: self
      !> Number of the first curve, from 1.
      integer(i8), intent(in) :: first
      !> Receive the columns of each curve in SI units.
      type(columns_t), intent(out) :: curves(:)
      !> False: they could not be read.
      logical, intent(out) :: is_read
      real(dp), allocatable :: values(:, :)
      integer :: c, i

      allocate (values(self%n_points, size(curves)))
      is_read = .true.
      do c = 1, n_columns
         if (.not. self%columns(c)%exists) cycle
         if (.not. allocated(self%columns(c)%shared)) then
            call self%columns(c)%rows%read_rows(first, values, is_read)
            if (.not. is_read) return
            values = to_si(values, self%columns(c)%unit)
         end if
         do i = 1, size(curves)
            if (allocated(self%columns(c)%shared)) values(:, i) = self%columns(c)%shared
            select case (c)
            case (c_x)
               curves(i)%x = values(:, i)
            case (c_y)
               curves(i)%y = values(:, i)
            case (c_sigma)
               curves(i)%sigma = values(:, i)
            case (c_x_sigma)
               curves(i)%x_sigma = values(:, i)
            case (c_branch)
               curves(i)%branch = values(:, i)
            case (c_segment)
               curves(i)%segment = values(:, i)
            end select
         end do
      end do
      if (.not. allocated(self%others)) return
      if (size(self%others) == 0) return
      do i = 1, size(curves)
         allocate (curves(i)%at(size(self%others), self%n_points), source=0.0_dp)
      end do
      do c = 1, size(self%others)
         ! those that all curves share have been read when they were opened
         if (.not. allocated(self%others(c)%shared)) then
            call self%others(c)%rows%read_rows(first, values, is_read)
            if (.not. is_read) return
            values = to_si(values, self%others(c)%unit)
         end if
         do i = 1, size(curves)
            if (allocated(self%others(c)%shared)) values(:, i) = self%others(c)%shared
            curves(i)%at(c, :) = values(:, i)
         end do
      end do
   end subroutine read_columns

   !> Close the columns.
   subroutine close_stack_file(self)
      class(stack_file_t), intent(inout) :: self
      integer :: c

      do c = 1, n_columns
         call self%columns(c)%rows%close()
      end do
      if (.not. allocated(self%others)) return
      do c = 1, size(self%others)
         call self%others(c)%rows%close()
      end do
   end subroutine close_stack_file

   !> See `curve_source_t`.
   subroutine get_curves(self, first, data_sets, is_read)
      class(hdf5_stack_t), intent(in) :: self
      integer(i8), intent(in) :: first
      type(data_set_t), intent(inout) :: data_sets(:, :)
      logical, intent(out) :: is_read
      type(columns_t) :: curves(size(data_sets, 2))
      integer :: g, i

      is_read = .true.
      do g = 1, size(self%files)
         ! the same lock as that of the sink (src/run/delivery.f90)
         !$omp critical (adfric_run_sink)
         ! nor may a caller of the library open another file meanwhile (src/api)
         !$omp critical (adfric_api)
         call self%files(g)%read_columns(first, curves, is_read)
         !$omp end critical (adfric_api)
         !$omp end critical (adfric_run_sink)
         if (.not. is_read) return
         do i = 1, size(curves)
            call set_points(self%groups(g), curves(i), data_sets(g, i))
            call prescribe_curve(self%history, data_sets(g, i))
         end do
      end do
   end subroutine get_curves

   !> See `curve_source_t`.
   subroutine close_stack(self)
      class(hdf5_stack_t), intent(inout) :: self
      integer :: g

      do g = 1, size(self%files)
         call self%files(g)%close()
      end do
   end subroutine close_stack

end module adfric_input_fit_stack

! SPDX-License-Identifier: GPL-3.0-or-later
!> The heights of a rough body as an input gives them: in the middles of equal cells that fill a period, from x = 0 and y = 0 on,
!> positive towards the solid. The summits touch first. A body that ends at the border of its map, or on either side of a strip, may
!> lack cells; where it lacks one there is no body.
module adfric_periodic_given_heights
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: show_number
   use adfric_base_unset, only: is_set
   use adfric_describe_check, only: require
   use adfric_describe_rows, only: positive, dataset
   use adfric_describe_table, only: variable_t
   use adfric_periodic_grids, only: n_grids_of
   use adfric_periodic_operator, only: is_too_long
   use adfric_periodic_point, only: periodic_surface_t
   use adfric_periodic_solver, only: grids_for_error
   use adfric_shape_period_seam, only: seam_t, seam_of
   implicit none (type, external)
   private
   public :: given_heights_t, set_heights_rows, n_heights_rows

   !> Number of rows.
   integer, parameter :: n_heights_rows = 4
   !> Positions among the rows.
   integer, parameter :: heights = 1, length_x = 2, length_y = 3, rms_height = 4
   !> Fewest cells in each direction, so that they can hold a wave.
   integer, parameter :: fewest_cells = 4

   !> Heights of an input.
   type :: given_heights_t
      !> Does the map end at its border, in one direction at least? Else it is a period, of which no cell is missing.
      logical :: has_border = .false.
      !> Is the cell one of the body? Shape of `depths`.
      logical, allocatable :: is_body(:, :)
      !> Depths below the highest summit, shape `(nx, ny)` [m]; ny = 1 for a surface that does not vary along y; 0 beside the body.
      real(dp), allocatable :: depths(:, :)
      !> Root of the mean square of the heights about their mean [m].
      real(dp) :: root_mean_square = 0
      !> Mean squares of the differences of neighbours along x and y [m^2], in a period of the first and the last cell, too.
      real(dp) :: differences(2) = 0
      !> Cell of the lowest height, along x and y.
      integer :: lowest(2) = 1
   contains
      procedure :: take
      procedure :: check
      procedure :: get_cells
      procedure :: get_shape
      procedure :: factor_of
      procedure :: slope
      procedure :: describe
      procedure :: doubt
      procedure, private :: is_line
   end type given_heights_t

contains

   !> The rows of heights and periods.
   subroutine set_heights_rows(rows)
      !> Receives the rows; shape `(n_heights_rows)`.
      type(variable_t), intent(inout) :: rows(:)

      rows(heights) = dataset(group='surface', name='heights', unit='m', &
         & meaning='heights of the rough body, (ny, nx), or (nx) if it does not vary along y; the largest touches first', &
         & largest_rank=2, least_count=fewest_cells)
      rows(length_x) = positive(group='surface', name='length_x', unit='m', &
         & meaning='period in x, along which the heights vary fastest')
      rows(length_y) = positive(group='surface', name='length_y', unit='m', meaning='period in y')
      rows(rms_height) = positive(group='surface', name='root_mean_square_height', unit='m', &
         & meaning='the heights are multiplied so that this is the root of their mean square; as they are if it is not given')
   end subroutine set_heights_rows

   !> Keep the depths below the highest summit.
   subroutine take(self, row, values, problems)
      class(given_heights_t), intent(inout) :: self
      !> Row of the heights; its name is part of the messages.
      type(variable_t), intent(in) :: row
      !> Heights of the rough body [m], NaN where there is none; shape `(nx, ny)`, ny = 1 if they do not vary along y.
      real(dp), intent(in) :: values(:, :)
      type(problems_t), intent(inout) :: problems
      real(dp) :: largest
      integer :: cell(2)

      self%is_body = .not. ieee_is_nan(values)
      cell = findloc(self%is_body, .true.)
      self%depths = merge(values, values(cell(1), cell(2)), self%is_body)
      self%depths = maxval(self%depths) - self%depths
      where (.not. self%is_body) self%depths = 0
      self%lowest = maxloc(self%depths)
      largest = maxval(self%depths)
      if (largest > 0) then
         self%root_mean_square = largest*sqrt(variance_of(self%depths/largest, self%is_body))
         self%differences(1) = largest**2*mean_square_step(self, self%depths/largest, 1)
         self%differences(2) = largest**2*mean_square_step(self, self%depths/largest, 2)
      else if (self%has_border) then
         ! a flat punch
         self%root_mean_square = 0
         self%differences = 0
      else
         call problems%add(row%group, row%name, 'all heights are the same')
      end if
   end subroutine take

   !> Mean square about the mean.
   pure real(dp) function variance_of(values, is_body) result(variance)
      !> Values, 0 beside the body.
      real(dp), intent(in) :: values(:, :)
      logical, intent(in) :: is_body(:, :)
      real(dp) :: mean

      mean = sum(values)/count(is_body)
      variance = sum(merge((values - mean)**2, 0.0_dp, is_body))/count(is_body)
   end function variance_of

   !> Mean square of the differences of neighbours, round the period if it is one.
   pure real(dp) function mean_square_step(self, values, axis) result(square)
      type(given_heights_t), intent(in) :: self
      real(dp), intent(in) :: values(:, :)
      !> 1 along x, 2 along y.
      integer, intent(in) :: axis
      logical, allocatable :: is_pair(:, :)

      allocate (is_pair, source=self%is_body)
      is_pair(:, :) = is_pair .and. cshift(self%is_body, 1, axis)
      if (self%has_border .and. axis == 1) is_pair(size(is_pair, 1), :) = .false.
      if (self%has_border .and. axis == 2) is_pair(:, size(is_pair, 2)) = .false.
      square = sum(merge((cshift(values, 1, axis) - values)**2, 0.0_dp, is_pair))/max(1, count(is_pair))
   end function mean_square_step

   !> Root of the mean square of the slope [-].
   pure real(dp) function slope(self, values)
      class(given_heights_t), intent(in) :: self
      !> Values of the rows; shape `(n_heights_rows)`.
      real(dp), intent(in) :: values(:)

      slope = sqrt(self%differences(1))*size(self%depths, 1)/values(length_x)
      if (.not. self%is_line()) slope = hypot(slope, sqrt(self%differences(2))*size(self%depths, 2)/values(length_y))
      slope = self%factor_of(values)*slope
   end function slope

   !> By what the heights of the input are multiplied [-].
   pure real(dp) function factor_of(self, values) result(factor)
      class(given_heights_t), intent(in) :: self
      !> Values of the rows; shape `(n_heights_rows)`.
      real(dp), intent(in) :: values(:)

      factor = 1
      if (is_set(values(rms_height))) factor = values(rms_height)/self%root_mean_square
   end function factor_of

   !> Does the surface not vary along y?
   pure logical function is_line(self)
      class(given_heights_t), intent(in) :: self

      is_line = size(self%depths, 2) == 1
   end function is_line

   !> Add to `problems` what is missing or impossible.
   subroutine check(self, rows, values, problems)
      class(given_heights_t), intent(in) :: self
      !> The rows of `set_heights_rows`; their names are part of the messages.
      type(variable_t), intent(in) :: rows(:)
      !> Values of the rows; shape `(n_heights_rows)`.
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems

      call require(rows, values, [heights, length_x], problems)
      if (.not. is_set(values(heights))) return
      if (self%has_border .and. self%is_line()) then
         call problems%add('surface', 'heights', 'have one dimension, x; a body that ends somewhere needs two, (ny, nx)')
         return
      end if
      if (.not. self%is_line()) then
         call require(rows, values, [length_y], problems)
         if (is_set(values(length_x)) .and. is_set(values(length_y))) then
            if (is_too_long(shape(self%depths), values([length_x, length_y]))) call problems%add('surface', 'length_y', &
               & 'makes cells more than 1e6 times as long as wide, given '// &
               & show_number(values(length_y))//' m beside length_x = '//show_number(values(length_x))//' m')
         end if
      else if (is_set(values(length_y))) then
         call problems%add('surface', 'length_y', 'is given, but the heights have one dimension, x')
      end if
      if (.not. self%has_border) return
      if (is_set(values(rms_height)) .and. .not. self%root_mean_square > 0) &
         & call problems%add('surface', 'root_mean_square_height', 'is given, but all heights are the same')
   end subroutine check

   !> Periods and cells of the heights.
   subroutine get_cells(self, values, surface)
      class(given_heights_t), intent(in) :: self
      !> Values of the rows, which have been checked; shape `(n_heights_rows)`.
      real(dp), intent(in) :: values(:)
      !> Receives the periods and the cells.
      type(periodic_surface_t), intent(inout) :: surface

      surface%period = values(length_x)
      if (.not. self%is_line()) surface%period(2) = values(length_y)
      surface%n_cells = shape(self%depths)
   end subroutine get_cells

   !> The undeformed gap of a point.
   pure subroutine get_shape(self, values, shape)
      class(given_heights_t), intent(in) :: self
      !> Values of the rows, which have been checked; shape `(n_heights_rows)`.
      real(dp), intent(in) :: values(:)
      !> In: that of the point before, not allocated at the first one. Out: depths below the highest summit, which are not copied
      !> again where they are the same [m].
      real(dp), allocatable, intent(inout) :: shape(:, :)
      real(dp) :: factor

      factor = self%factor_of(values)
      if (allocated(shape)) then
         associate (x => self%lowest(1), y => self%lowest(2))
            if (.not. abs(shape(x, y) - factor*self%depths(x, y)) > 0) return
         end associate
         deallocate (shape)
      end if
      allocate (shape, source=self%depths)
      shape(:, :) = factor*shape
   end subroutine get_shape

   !> A line where the error is not estimated; else nothing.
   function describe(self, has_friction) result(text)
      class(given_heights_t), intent(in) :: self
      !> Does the body rub, so that `error_estimate` is that of the friction?
      logical, intent(in) :: has_friction
      character(:), allocatable :: text

      text = ''
      if (n_grids_of(shape(self%depths)) >= grids_for_error) return
      text = 'the error of the area is not estimated'
      if (has_friction) text = text//', nor that of the friction, whose error_estimate is 1'
      text = text//': for that the numbers of cells have to be multiples of 4, 32 at least'//new_line('a')
   end function describe

   !> A line for edges that do not meet.
   function doubt(self, is_periodic) result(text)
      class(given_heights_t), intent(in) :: self
      !> Does the surface go on periodically along x, along y? Not present: it does along both.
      logical, intent(in), optional :: is_periodic(2)
      character(:), allocatable :: text
      character(*), parameter :: axes = 'xy'
      type(seam_t) :: seam
      character(60) :: steps
      integer :: k

      text = ''
      do k = 1, merge(1, 2, self%is_line())
         if (present(is_periodic)) then
            if (.not. is_periodic(k)) cycle
         end if
         seam = seam_of(self%depths, k)
         if (.not. seam%is_open()) cycle
         write (steps, '(es9.2, a, es9.2, a)') seam%step, ' m, inside at most', seam%largest, ' m'
         text = text//'the heights do not meet where the period ends along '//axes(k:k)//': a step of' &
            & //trim(steps)//' (root mean square); is the surface periodic?'//new_line('a')
      end do
   end function doubt

end module adfric_periodic_given_heights

!> The model `surface_elastic`: a rigid periodic surface, given by its heights, on an elastic half-space, without friction and
!> adhesion.
!>
!> The heights stand in the middles of equal cells that fill a period, from x = 0 and y = 0 on. They are those of the rough body,
!> positive towards the half-space: the summits touch first.
module adfric_periodic_surface_model
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_model_check, only: require, refuse_swept
   use adfric_model_rows, only: positive, dataset
   use adfric_model_table, only: variable_t
   use adfric_periodic_grids, only: n_grids_of
   use adfric_periodic_model, only: periodic_model_t
   use adfric_periodic_operator, only: is_too_long
   use adfric_periodic_point, only: periodic_surface_t
   use adfric_periodic_solver, only: grids_for_error
   use adfric_periodic_variables, only: modulus_of
   use adfric_shape_period_seam, only: seam_t, seam_of
   implicit none (type, external)
   private
   public :: surface_model_t, new_surface_model

   !> Places of the surface's own variables; those of `adfric_periodic_variables` follow.
   integer, parameter, public :: v_heights = 1, v_length_x = 2, v_length_y = 3
   integer, parameter, public :: n_surface_own = 3
   !> Fewest cells in each direction, so that they can hold a wave.
   integer, parameter :: fewest_cells = 4

   !> The model `surface_elastic`.
   type, extends(periodic_model_t) :: surface_model_t
      private
      !> Heights less the largest of them, shape `(nx, ny)` [m]; ny = 1 for a surface that does not vary along y.
      real(dp), allocatable :: depths(:, :)
   contains
      procedure :: take_dataset
      procedure :: check_surface
      procedure :: get_cells
      procedure :: get_shape
      procedure :: get_full_pressure
      procedure :: get_peak_pressure
      procedure :: describe_surface
      procedure :: describe_doubts
      procedure, private :: is_line
   end type surface_model_t

contains

   !> The model with its tables.
   subroutine new_surface_model(self)
      !> The new model; receives its tables.
      type(surface_model_t), intent(out) :: self
      type(variable_t) :: v(n_surface_own)

      v(v_heights) = dataset(group='surface', name='heights', unit='m', &
         & meaning='heights of the rough body, (ny, nx), or (nx) if it does not vary along y; the largest touches first', &
         & largest_rank=2, least_count=fewest_cells)
      v(v_length_x) = positive(group='surface', name='length_x', unit='m', &
         & meaning='period in x, along which the heights vary fastest')
      v(v_length_y) = positive(group='surface', name='length_y', unit='m', meaning='period in y')
      call self%set_tables(name='surface_elastic', variables=v, &
         & summary='a rigid periodic surface of given heights on an elastic half-space: area, pressure and gap up to full contact')
   end subroutine new_surface_model

   !> See `model_t`.
   subroutine take_dataset(self, place, values, problems)
      !> The model, which keeps the depths below the highest summit.
      class(surface_model_t), intent(inout) :: self
      !> Place of the dataset in `variables`.
      integer, intent(in) :: place
      !> Heights of the rough body [m]; shape `(nx, ny)`, ny = 1 if they do not vary along y.
      real(dp), intent(in) :: values(:, :)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      if (maxval(values) > minval(values)) then
         self%depths = maxval(values) - values
      else
         call problems%add(self%variables(place)%group, self%variables(place)%name, 'all heights are the same')
      end if
   end subroutine take_dataset

   !> Does the surface not vary along y?
   pure logical function is_line(self)
      !> The model with its heights.
      class(surface_model_t), intent(in) :: self

      is_line = size(self%depths, 2) == 1
   end function is_line

   !> See `periodic_model_t`.
   subroutine check_surface(self, values, is_swept, problems)
      !> The model with its heights; its tables give the variables their names.
      class(surface_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      call require(self%variables, values, [v_heights, v_length_x], problems)
      if (.not. is_set(values(v_heights))) return
      if (.not. self%is_line()) then
         call require(self%variables, values, [v_length_y], problems)
         if (is_set(values(v_length_x)) .and. is_set(values(v_length_y))) then
            if (is_too_long(shape(self%depths), values([v_length_x, v_length_y]))) call problems%add('surface', 'length_y', &
               & 'and length_x make cells more than 1e6 times as long as wide')
         end if
      else if (is_set(values(v_length_y))) then
         call problems%add('surface', 'length_y', 'is given, but the heights have one dimension, x')
      end if
      if (self%wants_profiles(values)) call refuse_swept(self%variables, is_swept, [v_length_x, v_length_y], problems)
   end subroutine check_surface

   !> See `periodic_model_t`.
   subroutine get_cells(self, values, surface)
      !> The model with its heights.
      class(surface_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the periods and the cells of the heights.
      type(periodic_surface_t), intent(inout) :: surface

      surface%period = values(v_length_x)
      if (.not. self%is_line()) surface%period(2) = values(v_length_y)
      surface%n_cells = shape(self%depths)
   end subroutine get_cells

   !> See `periodic_model_t`: all points have the same map.
   subroutine get_shape(self, values, shape)
      !> The model with its heights.
      class(surface_model_t), intent(in) :: self
      !> Values of the variables, not used here.
      real(dp), intent(in) :: values(:)
      !> Receives the depths below the highest summit, unless it has them already [m].
      real(dp), allocatable, intent(inout) :: shape(:, :)

      if (.not. allocated(shape)) allocate (shape, source=self%depths)
      associate (unused => values)
      end associate
   end subroutine get_shape

   !> See `periodic_model_t`: that of the cells as they are.
   pure real(dp) function get_full_pressure(self, values, on_cells)
      !> The model, for the places of the shared variables.
      class(surface_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Pressure of full contact of the surface as its cells have it [E*].
      real(dp), intent(in) :: on_cells

      get_full_pressure = modulus_of(values(self%n_own + 1:))*on_cells
   end function get_full_pressure

   !> See `periodic_model_t`: that of a cell.
   real(dp) function get_peak_pressure(self, values, pressure)
      !> The model, for the places of the shared variables.
      class(surface_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Pressure in the middles of the cells [E*]; shape `(nx, ny)`.
      real(dp), intent(in) :: pressure(:, :)

      get_peak_pressure = modulus_of(values(self%n_own + 1:))*maxval(pressure)
   end function get_peak_pressure

   !> See `periodic_model_t`.
   function describe_surface(self) result(text)
      !> The model with its heights.
      class(surface_model_t), intent(in) :: self
      character(:), allocatable :: text

      text = ''
      if (n_grids_of(shape(self%depths)) < grids_for_error) text = 'the error of the area is not estimated: for that the ' &
         & //'numbers of cells have to be multiples of 4, 32 at least'//new_line('a')
   end function describe_surface

   !> See `model_t`: edges that do not meet.
   function describe_doubts(self, values) result(text)
      !> The model with its heights.
      class(surface_model_t), intent(in) :: self
      !> Values of the variables, not used here.
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text
      character(*), parameter :: axes = 'xy'
      type(seam_t) :: seam
      character(60) :: steps
      integer :: k

      text = ''
      do k = 1, merge(1, 2, self%is_line())
         seam = seam_of(self%depths, k)
         if (.not. seam%is_open()) cycle
         write (steps, '(es9.2, a, es9.2, a)') seam%step, ' m, inside at most', seam%largest, ' m'
         text = text//'the heights do not meet where the period ends along '//axes(k:k)//': a step of' &
            & //trim(steps)//' (root mean square); is the surface periodic?'//new_line('a')
      end do
      associate (unused => values)
      end associate
   end function describe_doubts

end module adfric_periodic_surface_model

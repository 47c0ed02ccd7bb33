!> The file with the results of a run.
!>
!> It is written under another name beside the final one, and renamed when it is complete. Every dataset has its
!> full size from the start and holds NaN, or the state -1, where nothing has been written yet.
module adfric_output_results_file
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use, intrinsic :: iso_fortran_env, only: int8, compiler_version
   use hdf5, only: hid_t
   use adfric_base_kinds, only: dp, i8
   use adfric_base_error, only: error_t, set_error, file_failure
   use adfric_base_model, only: model_t, attribute_t
   use adfric_base_version, only: program_version, git_revision
   use adfric_base_words, only: count_words
   use adfric_output_boxes, only: box_t, next_box
   use adfric_output_hdf5_layer_attributes, only: write_attribute
   use adfric_output_hdf5_layer_calls, only: hdf5_calls_t, no_id
   use adfric_output_hdf5_layer_datasets, only: create_space, select_box, create_real_dataset, &
      create_state_dataset, write_values, close_dataset, make_scale, attach_scale, no_state
   use adfric_output_hdf5_layer_file, only: create_file, flush_file, close_file
   use adfric_output_layout, only: layout_t, new_layout, scale_t, field_t
   use adfric_output_names, only: check_output_name, partial_name
   use adfric_output_operating_system, only: kind_of_path, path_free, file_id_t, id_of_file, is_same, &
      is_locked, move_file, remove_file, ignore_file_size_signal, utc_time
   use adfric_sweep_clock, only: wall_clock
   use adfric_sweep_plan, only: plan_t
   use adfric_sweep_sink, only: sink_t
   implicit none (type, external)
   private
   public :: results_file_t, note_t

   !> Time between two flushes [s].
   real(dp), parameter :: flush_interval = 10

   !> A text that stands as an attribute of the file.
   type :: note_t
      character(:), allocatable :: name
      character(:), allocatable :: text
   end type note_t

   !> A results file that is being written.
   type, extends(sink_t) :: results_file_t
      private
      !> Final name.
      character(:), allocatable :: path
      !> May a file of this name be replaced?
      logical :: overwrite = .false.
      type(layout_t) :: layout
      integer(hid_t) :: file = no_id
      !> Which file has been created under the name of the partial one; others may put theirs there.
      type(file_id_t) :: id
      !> Spaces of the shape of a result and of a profile of all points.
      integer(hid_t) :: space = no_id, profile_space = no_id
      !> The datasets, in the order of the layout.
      integer(hid_t), allocatable :: scales(:), fields(:), profiles(:)
      !> When the file was last flushed.
      real(dp) :: flushed_at = 0
   contains
      procedure :: create
      procedure :: put
      procedure :: put_profiles
      procedure :: finish
      procedure :: abandon
      procedure :: discard
   end type results_file_t

contains

   !> Create the file with every dataset in it.
   subroutine create(self, path, overwrite, model, plan, title, input, error, notes)
      class(results_file_t), intent(inout) :: self
      !> Final name.
      character(*), intent(in) :: path
      !> May a file of this name be replaced?
      logical, intent(in) :: overwrite
      class(model_t), intent(in) :: model
      type(plan_t), intent(in) :: plan
      !> Title of the run.
      character(*), intent(in) :: title
      !> Whole text of the input file.
      character(*), intent(in) :: input
      type(error_t), allocatable, intent(out) :: error
      !> What else is to stand in the file.
      type(note_t), intent(in), optional :: notes(:)
      type(hdf5_calls_t) :: calls
      logical :: is_in_use
      integer :: k

      call check_output_name(path, overwrite, error)
      if (allocated(error)) return
      if (kind_of_path(partial_name(path)) /= path_free) call remove_file(partial_name(path), error)
      if (allocated(error)) return
      self%path = path
      self%overwrite = overwrite
      call new_layout(self%layout, model, plan)
      call ignore_file_size_signal()
      call create_file(calls, partial_name(path), self%file)
      ! What a creation leaves that has failed half way is ours, too, but not what another run has just begun.
      is_in_use = is_locked(partial_name(path))
      if (calls%is_good() .or. .not. is_in_use) self%id = id_of_file(partial_name(path))
      call write_heading(calls, self%file, model, title, input)
      if (present(notes)) then
         do k = 1, size(notes)
            call write_attribute(calls, self%file, notes(k)%name, notes(k)%text)
         end do
      end if
      call create_scales(calls, self)
      call create_fields(calls, self)
      call flush_file(calls, self%file)
      self%flushed_at = wall_clock()
      call calls%get_error(path//': cannot create', error)
      if (allocated(error)) call self%discard()
   end subroutine create

   !> Write what is known of the run before it starts.
   subroutine write_heading(calls, file, model, title, input)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      class(model_t), intent(in) :: model
      character(*), intent(in) :: title, input

      call write_attribute(calls, file, 'title', title)
      call write_attribute(calls, file, 'model', model%name)
      call write_attribute(calls, file, 'adfric_version', program_version)
      call write_attribute(calls, file, 'git_revision', git_revision)
      call write_attribute(calls, file, 'compiler', compiler_version())
      call write_attribute(calls, file, 'created', utc_time())
      call write_attribute(calls, file, 'input', input)
   end subroutine write_heading

   !> Create the swept variables and the axes of the profiles.
   subroutine create_scales(calls, self)
      type(hdf5_calls_t), intent(inout) :: calls
      class(results_file_t), intent(inout) :: self
      integer :: k, n

      n = size(self%layout%axes)
      allocate (self%scales(n + size(self%layout%profile_axes)), source=no_id)
      do k = 1, n
         call create_scale(calls, self%file, self%layout%axes(k), self%scales(k))
      end do
      do k = 1, size(self%layout%profile_axes)
         call create_scale(calls, self%file, self%layout%profile_axes(k), self%scales(n + k))
      end do
   end subroutine create_scales

   !> Create a scale with its values.
   subroutine create_scale(calls, file, scale, dataset)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      type(scale_t), intent(in) :: scale
      integer(hid_t), intent(out) :: dataset
      integer(hid_t) :: space

      call create_space(calls, [size(scale%values, kind=i8)], space)
      call create_real_dataset(calls, file, scale%name, space, dataset)
      call write_attribute(calls, dataset, 'units', scale%unit)
      call write_attribute(calls, dataset, 'long_name', scale%long_name)
      call write_values(calls, dataset, space, space, scale%values)
      call make_scale(calls, dataset, scale%name)
      call calls%close_id(space)
   end subroutine create_scale

   !> Create the results and the profiles.
   subroutine create_fields(calls, self)
      type(hdf5_calls_t), intent(inout) :: calls
      class(results_file_t), intent(inout) :: self
      integer :: i, n

      n = size(self%layout%axes)
      allocate (self%fields(size(self%layout%fields)), self%profiles(size(self%layout%profiles)), source=no_id)
      call create_space(calls, self%layout%point_shape(), self%space)
      call create_space(calls, [self%layout%point_shape(), self%layout%profile_shape()], self%profile_space)
      do i = 1, size(self%fields)
         call create_field(calls, self%file, self%layout%fields(i), self%space, self%scales(:n), self%fields(i))
      end do
      do i = 1, size(self%profiles)
         call create_field(calls, self%file, self%layout%profiles(i), self%profile_space, self%scales, &
            self%profiles(i))
      end do
   end subroutine create_fields

   !> Create a dataset of a result or a profile.
   subroutine create_field(calls, file, field, space, scales, dataset)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      type(field_t), intent(in) :: field
      integer(hid_t), intent(in) :: space
      !> Scales of its dimensions.
      integer(hid_t), intent(in) :: scales(:)
      integer(hid_t), intent(out) :: dataset
      integer(int8), allocatable :: flags(:)
      integer :: k

      if (len(field%flag_meanings) == 0) then
         call create_real_dataset(calls, file, field%name, space, dataset)
      else
         call create_state_dataset(calls, file, field%name, space, dataset)
         flags = [(int(field%first_flag + k, int8), k=0, count_words(field%flag_meanings) - 1)]
         call write_attribute(calls, dataset, 'flag_values', flags)
         call write_attribute(calls, dataset, 'flag_meanings', field%flag_meanings)
      end if
      call write_attribute(calls, dataset, 'units', field%unit)
      call write_attribute(calls, dataset, 'long_name', field%long_name)
      do k = 1, size(scales)
         call attach_scale(calls, dataset, scales(k), k)
      end do
   end subroutine create_field

   !> Write the results of a row of points.
   subroutine put(self, first, results, error_estimate, status, error)
      class(results_file_t), intent(inout) :: self
      integer(i8), intent(in) :: first
      real(dp), intent(in) :: results(:, :)
      real(dp), intent(in) :: error_estimate(:)
      integer, intent(in) :: status(:)
      type(error_t), allocatable, intent(out) :: error
      type(hdf5_calls_t) :: calls
      type(box_t) :: box
      integer :: done, n

      done = 0
      do while (done < size(status) .and. calls%is_good())
         call next_box(self%layout%point_shape(), first - 1 + done, int(size(status) - done, i8), box)
         n = int(product(box%count))
         call put_box(calls, self, box, results(done + 1:done + n, :), error_estimate(done + 1:done + n), &
            status(done + 1:done + n))
         done = done + n
      end do
      if (wall_clock() - self%flushed_at > flush_interval) then
         call flush_file(calls, self%file)
         self%flushed_at = wall_clock()
      end if
      call calls%get_error(self%path//': cannot write', error)
   end subroutine put

   !> Write the results of the points of a box; `status`, which says that a point is complete, comes last.
   subroutine put_box(calls, self, box, results, error_estimate, status)
      type(hdf5_calls_t), intent(inout) :: calls
      class(results_file_t), intent(in) :: self
      type(box_t), intent(in) :: box
      real(dp), intent(in) :: results(:, :)
      real(dp), intent(in) :: error_estimate(:)
      integer, intent(in) :: status(:)
      !> What is written next, contiguous.
      real(dp), allocatable :: numbers(:)
      integer(int8), allocatable :: states(:)
      integer(hid_t) :: memory_space
      integer :: i, n

      n = size(self%fields)
      call create_space(calls, [size(status, kind=i8)], memory_space)
      call select_box(calls, self%space, box%start, box%count)
      do i = 1, n - 2
         numbers = results(:, self%layout%fields(i)%column)
         if (len(self%layout%fields(i)%flag_meanings) == 0) then
            call write_values(calls, self%fields(i), memory_space, self%space, numbers)
         else
            states = to_state(numbers)
            call write_values(calls, self%fields(i), memory_space, self%space, states)
         end if
      end do
      numbers = error_estimate
      call write_values(calls, self%fields(n - 1), memory_space, self%space, numbers)
      states = int(status, int8)
      call write_values(calls, self%fields(n), memory_space, self%space, states)
      call calls%close_id(memory_space)
   end subroutine put_box

   !> A state as it stands in the file.
   elemental integer(int8) function to_state(value)
      !> The number of the state, or NaN where there is none.
      real(dp), intent(in) :: value

      to_state = no_state
      if (ieee_is_finite(value)) to_state = nint(value, int8)
   end function to_state

   !> Write the profiles of a point.
   subroutine put_profiles(self, point, profiles, error)
      class(results_file_t), intent(inout) :: self
      integer(i8), intent(in) :: point
      real(dp), intent(in) :: profiles(:, :, :)
      type(error_t), allocatable, intent(out) :: error
      type(hdf5_calls_t) :: calls
      type(box_t) :: box
      integer(hid_t) :: memory_space
      integer :: i, n

      n = size(profiles, 1)*size(profiles, 2)
      call next_box(self%layout%point_shape(), point - 1, 1_i8, box)
      call create_space(calls, [int(n, i8)], memory_space)
      associate (shape => self%layout%profile_shape())
         call select_box(calls, self%profile_space, [box%start, 0*shape], [box%count, shape])
      end associate
      do i = 1, size(self%profiles)
         call write_values(calls, self%profiles(i), memory_space, self%profile_space, &
            reshape(profiles(:, :, i), [n]))
      end do
      call calls%close_id(memory_space)
      call calls%get_error(self%path//': cannot write', error)
   end subroutine put_profiles

   !> Complete the file and give it its name.
   subroutine finish(self, wall_seconds, sums, error)
      class(results_file_t), intent(inout) :: self
      !> Time that the run took [s].
      real(dp), intent(in) :: wall_seconds
      !> Sums over all points of what the model counts.
      type(attribute_t), intent(in) :: sums(:)
      type(error_t), allocatable, intent(out) :: error
      type(hdf5_calls_t) :: calls
      real(dp) :: n_points
      integer :: i

      n_points = product(real(self%layout%point_shape(), dp))
      call write_attribute(calls, self%file, 'wall_seconds', wall_seconds)
      do i = 1, size(sums)
         call write_attribute(calls, self%file, sums(i)%name, sums(i)%value/n_points)
      end do
      call close_all(calls, self)
      call calls%get_error(self%path//': cannot complete', error)
      if (.not. allocated(error)) then
         if (is_same(self%id, id_of_file(partial_name(self%path)))) then
            call move_file(partial_name(self%path), self%path, self%overwrite, error)
         else
            call set_error(error, file_failure, self%path//': the results are lost: '//partial_name(self%path) &
               //' has been removed or replaced while it was written')
         end if
      end if
      if (allocated(error)) call self%abandon(error)
   end subroutine finish

   !> Close the file and leave what has been written under the name of the partial file; the error says so.
   subroutine abandon(self, error)
      class(results_file_t), intent(inout) :: self
      !> Why the run ends here.
      type(error_t), intent(inout) :: error
      type(hdf5_calls_t) :: calls

      call close_all(calls, self)
      if (is_same(self%id, id_of_file(partial_name(self%path)))) &
         error%message = error%message//'; the results so far stay in '//partial_name(self%path)
   end subroutine abandon

   !> Close the file and remove what has been written.
   subroutine discard(self)
      class(results_file_t), intent(inout) :: self
      type(hdf5_calls_t) :: calls
      type(error_t), allocatable :: error

      call close_all(calls, self)
      ! A file that cannot be removed does no harm: the next run replaces it.
      if (is_same(self%id, id_of_file(partial_name(self%path)))) call remove_file(partial_name(self%path), error)
   end subroutine discard

   !> Close every id.
   subroutine close_all(calls, self)
      type(hdf5_calls_t), intent(inout) :: calls
      class(results_file_t), intent(inout) :: self

      call close_datasets(calls, self%profiles)
      call close_datasets(calls, self%fields)
      call close_datasets(calls, self%scales)
      call calls%close_id(self%profile_space)
      call calls%close_id(self%space)
      call close_file(calls, self%file)
   end subroutine close_all

   !> Close the datasets of a list.
   subroutine close_datasets(calls, ids)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), allocatable, intent(inout) :: ids(:)
      integer :: i

      if (.not. allocated(ids)) return
      do i = 1, size(ids)
         call close_dataset(calls, ids(i))
      end do
      deallocate (ids)
   end subroutine close_datasets

end module adfric_output_results_file

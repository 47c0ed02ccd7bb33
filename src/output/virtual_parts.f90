! SPDX-License-Identifier: GPL-3.0-or-later
!> Which points of a run are in the files of its parts, as virtual datasets need it.
module adfric_output_virtual_parts
   use hdf5, only: hid_t
   use adfric_base_kinds, only: i8
   use adfric_hdf5_calls, only: hdf5_calls_t, no_id
   use adfric_hdf5_datasets, only: create_space
   use adfric_hdf5_virtual, only: select_nothing, add_box, create_virtual_list, add_source, &
      create_virtual_dataset
   use adfric_base_boxes, only: box_t, next_box
   use adfric_output_layout, only: layout_t, field_t
   use adfric_run_blocks, only: blocks_t
   implicit none (type, external)
   private
   public :: virtual_parts_t, new_virtual_parts

   !> The points of a part.
   type :: virtual_part_t
      !> Name of the file, as it stands in the other one.
      character(:), allocatable :: path
      !> Spaces of the part's results and of the run's, these with the points of the part selected; the same of profiles.
      integer(hid_t) :: source = no_id, target = no_id, profile_source = no_id, profile_target = no_id
   end type virtual_part_t

   !> All parts that have points.
   type :: virtual_parts_t
      private
      !> Number of parts that have been added.
      integer :: n = 0
      !> The parts that have points, with space for all.
      type(virtual_part_t), allocatable :: parts(:)
   contains
      procedure :: add
      procedure :: create_dataset
      procedure :: close => close_all
   end type virtual_parts_t

contains

   !> Make space for parts.
   subroutine new_virtual_parts(self, n)
      !> Receives the space, and no parts.
      type(virtual_parts_t), intent(out) :: self
      !> Largest number of parts.
      integer, intent(in) :: n

      allocate (self%parts(n))
   end subroutine new_virtual_parts

   !> Add a part.
   subroutine add(self, calls, layout, blocks, path)
      !> The parts so far; a part without points is not added.
      class(virtual_parts_t), intent(inout) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      type(layout_t), intent(in) :: layout
      type(blocks_t), intent(in) :: blocks
      !> Name of the part's file, relative to the folder of the file of the whole run, or absolute.
      character(*), intent(in) :: path

      if (blocks%n_blocks() == 0) return
      self%n = self%n + 1
      associate (part => self%parts(self%n), shape => layout%profile_shape())
         part%path = path
         call create_space(calls, [blocks%n_points()], part%source)
         call create_space(calls, [blocks%n_points(), shape], part%profile_source)
         call create_space(calls, layout%row_shape(), part%target)
         call create_space(calls, [layout%row_shape(), shape], part%profile_target)
         call select_points(calls, layout, blocks, [integer(i8) ::], part%target)
         call select_points(calls, layout, blocks, shape, part%profile_target)
      end associate
   end subroutine add

   !> Select the points of a part.
   subroutine select_points(calls, layout, blocks, shape, space)
      type(hdf5_calls_t), intent(inout) :: calls
      type(layout_t), intent(in) :: layout
      type(blocks_t), intent(in) :: blocks
      !> Shape of what each point has: of size 0 for a result, the shape of a profile for a profile.
      integer(i8), intent(in) :: shape(:)
      !> Space of all points, each with what it has; the points of the part are selected afterwards.
      integer(hid_t), intent(in) :: space
      type(box_t) :: box
      integer(i8) :: index, n, point, last

      call select_nothing(calls, space)
      index = 1
      do while (index <= blocks%n_blocks())
         n = blocks%n_neighbours(index)
         point = blocks%first_point(blocks%block_at(index))
         last = min(point + n*blocks%size - 1, blocks%n_points_of_run)
         do while (point <= last)
            call next_box(layout%row_shape(), point - 1, last - point + 1, box)
            call add_box(calls, space, [box%start, 0*shape], [box%count, shape])
            point = point + product(box%count)
         end do
         index = index + n
      end do
   end subroutine select_points

   !> Create a virtual dataset of the whole run.
   subroutine create_dataset(self, calls, file, field, is_profile, space, dataset)
      class(virtual_parts_t), intent(in) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the open results file of the whole run.
      integer(hid_t), intent(in) :: file
      !> Description of the dataset, whose name is the same in the new file and in the parts.
      type(field_t), intent(in) :: field
      !> Is it a dataset of profiles? Else it is one of results.
      logical, intent(in) :: is_profile
      !> Space of the dataset's shape, all points of the run.
      integer(hid_t), intent(in) :: space
      !> Id of the dataset, to be closed by the caller; `no_id` if a call has failed.
      integer(hid_t), intent(out) :: dataset
      integer(hid_t) :: list
      logical :: is_real
      integer :: i

      is_real = len(field%flag_meanings) == 0
      call create_virtual_list(calls, is_real, list)
      do i = 1, self%n
         associate (part => self%parts(i))
            if (is_profile) then
               call add_source(calls, list, part%profile_target, part%path, field%name, part%profile_source)
            else
               call add_source(calls, list, part%target, part%path, field%name, part%source)
            end if
         end associate
      end do
      call create_virtual_dataset(calls, file, field%name, is_real, space, list, dataset)
      call calls%close_id(list)
   end subroutine create_dataset

   !> Close every space.
   subroutine close_all(self, calls)
      class(virtual_parts_t), intent(inout) :: self
      !> Chain of HDF5 calls; the ids are closed even where one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      integer :: i

      do i = 1, self%n
         call calls%close_id(self%parts(i)%source)
         call calls%close_id(self%parts(i)%target)
         call calls%close_id(self%parts(i)%profile_source)
         call calls%close_id(self%parts(i)%profile_target)
      end do
      self%n = 0
   end subroutine close_all

end module adfric_output_virtual_parts

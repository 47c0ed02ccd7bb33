! SPDX-License-Identifier: GPL-3.0-or-later
!> What is swept, as dimensions and as arrays along them. A dimension has the name of its variable, or a name of its own where
!> several variables change along it.
module adfric_c_coordinates
   use, intrinsic :: iso_c_binding, only: c_ptr
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: i8
   use adfric_base_text, only: show_count
   use adfric_c_texts, only: keep_text
   use adfric_output_constants, only: file_unit
   use adfric_output_layout, only: scale_t
   use adfric_run_run, only: run_t
   implicit none (type, external)
   private
   public :: coordinates_t, new_coordinates

   !> Name of a dimension along which several variables change.
   character(*), parameter :: name_of_joint = 'point'

   !> What is swept.
   type :: coordinates_t
      !> Names of the dimensions, the slowest first.
      type(c_ptr), allocatable :: dimensions(:)
      !> Number of values along each.
      integer(i8), allocatable :: shape(:)
      !> The swept variables, in the order of their dimensions.
      type(scale_t), allocatable :: scales(:)
      !> Place of the dimension of each of them, from 1.
      integer, allocatable :: dimension_of(:)
      !> Their names, separated by a blank.
      character(:), allocatable :: names
   end type coordinates_t

contains

   !> Find what is swept.
   subroutine new_coordinates(self, run, error)
      !> Receives the dimensions and the values along them.
      type(coordinates_t), intent(out) :: self
      !> The run, with its model and its points.
      class(run_t), intent(in) :: run
      !> Receives that there is too little memory.
      type(error_t), allocatable, intent(inout) :: error
      integer :: j, k, n, n_joint

      self%shape = run%plan%shape()
      n = 0
      do k = 1, size(run%plan%axes)
         n = n + size(run%plan%axes(k)%variables)
      end do
      allocate (self%dimensions(size(self%shape)), self%scales(n), self%dimension_of(n))
      self%names = ''
      n = 0
      n_joint = 0
      do k = 1, size(run%plan%axes)
         do j = 1, size(run%plan%axes(k)%variables)
            n = n + 1
            self%dimension_of(n) = k
            call set_scale(run, k, j, self%scales(n))
            self%names = self%names//' '//self%scales(n)%name
         end do
         if (size(run%plan%axes(k)%variables) == 1) then
            call keep_text(self%scales(n)%name, self%dimensions(k), error)
         else
            n_joint = n_joint + 1
            call name_joint(n_joint, self%dimensions(k), error)
         end if
      end do
   end subroutine new_coordinates

   !> Name a dimension along which several variables change.
   subroutine name_joint(number, name, error)
      !> Number of the dimension among those of this kind, from 1.
      integer, intent(in) :: number
      !> Receives the name.
      type(c_ptr), intent(out) :: name
      !> Receives that there is too little memory.
      type(error_t), allocatable, intent(inout) :: error

      if (number == 1) then
         call keep_text(name_of_joint, name, error)
      else
         call keep_text(name_of_joint//'_'//show_count(number), name, error)
      end if
   end subroutine name_joint

   !> Name a swept variable as the results file does, and give it its values.
   subroutine set_scale(run, axis, place, scale)
      !> The run, with its model and its points.
      class(run_t), intent(in) :: run
      !> Place of the axis, from 1.
      integer, intent(in) :: axis
      !> Place of the variable along it, from 1.
      integer, intent(in) :: place
      !> Receives the variable.
      type(scale_t), intent(out) :: scale
      integer :: j, k, n_same

      associate (variables => run%model%variables, number => run%plan%axes(axis)%variables(place))
         n_same = 0
         do k = 1, size(run%plan%axes)
            do j = 1, size(run%plan%axes(k)%variables)
               if (variables(run%plan%axes(k)%variables(j))%name == variables(number)%name) n_same = n_same + 1
            end do
         end do
         scale%name = variables(number)%name
         if (n_same > 1) scale%name = variables(number)%group//'_'//variables(number)%name
         scale%unit = file_unit(run%model%unit_of(run%plan%base, number))
         scale%long_name = variables(number)%meaning
         scale%values = run%plan%axes(axis)%values(place, :)
      end associate
   end subroutine set_scale

end module adfric_c_coordinates

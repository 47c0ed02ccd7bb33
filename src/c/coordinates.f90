! SPDX-License-Identifier: GPL-3.0-or-later
!> What is swept, as dimensions and as arrays along them. A dimension has the name of its variable, or a name of its own where
!> several variables change along it.
module adfric_c_coordinates
   use, intrinsic :: iso_c_binding, only: c_ptr
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: i8
   use adfric_c_texts, only: keep_text
   use adfric_output_constants, only: file_unit
   use adfric_output_layout, only: scale_t, name_of_swept, name_of_dimension
   use adfric_run_run, only: run_t
   implicit none (type, external)
   private
   public :: coordinates_t, new_coordinates

   !> What is swept.
   type :: coordinates_t
      !> Names of the dimensions, the slowest first.
      type(c_ptr), allocatable :: dimensions(:)
      !> Number of values along each.
      integer(i8), allocatable :: shape(:)
      !> The swept variables, in the order of their dimensions.
      type(scale_t), allocatable :: scales(:)
      !> Index of the dimension of each of them, from 1.
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
      integer :: j, k, n

      self%shape = run%plan%shape()
      n = 0
      do k = 1, size(run%plan%axes)
         n = n + size(run%plan%axes(k)%variables)
      end do
      allocate (self%dimensions(size(self%shape)), self%scales(n), self%dimension_of(n))
      self%names = ''
      n = 0
      do k = 1, size(run%plan%axes)
         do j = 1, size(run%plan%axes(k)%variables)
            n = n + 1
            self%dimension_of(n) = k
            call set_scale(run, k, j, self%scales(n))
            self%names = self%names//' '//self%scales(n)%name
         end do
         call keep_text(name_of_dimension(run, k), self%dimensions(k), error)
      end do
   end subroutine new_coordinates

   !> Name a swept variable as the results file does, and give it its values.
   subroutine set_scale(run, axis, index, scale)
      class(run_t), intent(in) :: run
      !> Index of the axis, from 1.
      integer, intent(in) :: axis
      !> Index of the variable along it, from 1.
      integer, intent(in) :: index
      !> Receives the variable.
      type(scale_t), intent(out) :: scale

      associate (number => run%plan%axes(axis)%variables(index))
         scale%name = name_of_swept(run, number)
         scale%unit = file_unit(run%model%unit_of(run%plan%base, number))
         scale%long_name = run%model%variables(number)%meaning
         scale%values = run%plan%axes(axis)%values(index, :)
      end associate
   end subroutine set_scale

end module adfric_c_coordinates

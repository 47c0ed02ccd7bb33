! SPDX-License-Identifier: GPL-3.0-or-later
!> The axes of a results file: what is swept, as scales of dimensions and as variables that change in step with them.
module adfric_output_axes
   use adfric_base_kinds, only: dp
   use adfric_base_text, only: show_count
   use adfric_output_constants, only: file_unit
   use adfric_run_run, only: run_t
   implicit none (type, external)
   private
   public :: scale_t, companion_t, find_axes, find_companions, name_of_swept, name_of_dimension

   !> A dataset of one dimension with the values along a dimension of others.
   type :: scale_t
      !> Name of the dataset.
      character(:), allocatable :: name
      !> Unit as it stands in the file.
      character(:), allocatable :: unit
      !> What the values are, in a phrase.
      character(:), allocatable :: long_name
      !> Values along the dimension.
      real(dp), allocatable :: values(:)
   end type scale_t

   !> A dataset of one dimension whose values change in step with those of another one, which is the scale of the dimension.
   type, extends(scale_t) :: companion_t
      !> Index of the dimension among those of the points, from 1.
      integer :: axis = 1
   end type companion_t

contains

   !> The scales of the dimensions of the points.
   subroutine find_axes(run, axes)
      class(run_t), intent(in) :: run
      !> Receives a scale for each dimension, the slowest first.
      type(scale_t), allocatable, intent(out) :: axes(:)
      integer :: i, k

      allocate (axes(size(run%plan%axes)))
      do k = 1, size(axes)
         if (.not. allocated(run%plan%axes(k)%name)) then
            call set_swept(run, k, 1, axes(k))
            cycle
         end if
         axes(k)%name = name_of_dimension(run, k)
         axes(k)%unit = '1'
         axes(k)%long_name = 'number of the '//run%plan%axes(k)%name
         axes(k)%values = [(real(i, dp), i=1, size(run%plan%axes(k)%values, 2))]
      end do
   end subroutine find_axes

   !> The swept variables that are no scale themselves.
   subroutine find_companions(run, companions)
      class(run_t), intent(in) :: run
      !> Receives the variables, in the order of their dimensions.
      type(companion_t), allocatable, intent(out) :: companions(:)
      integer :: j, k, n

      n = 0
      do k = 1, size(run%plan%axes)
         n = n + size(run%plan%axes(k)%variables)
         if (.not. allocated(run%plan%axes(k)%name)) n = n - 1
      end do
      allocate (companions(n))
      n = 0
      do k = 1, size(run%plan%axes)
         do j = merge(1, 2, allocated(run%plan%axes(k)%name)), size(run%plan%axes(k)%variables)
            n = n + 1
            call set_swept(run, k, j, companions(n))
            companions(n)%axis = k
         end do
      end do
   end subroutine find_companions

   !> Describe a swept variable.
   subroutine set_swept(run, axis, index, scale)
      class(run_t), intent(in) :: run
      !> Index of the axis, from 1.
      integer, intent(in) :: axis
      !> Index of the variable along it, from 1.
      integer, intent(in) :: index
      class(scale_t), intent(inout) :: scale

      associate (number => run%plan%axes(axis)%variables(index))
         scale%name = name_of_swept(run, number)
         scale%unit = file_unit(run%model%unit_of(run%plan%base, number))
         scale%long_name = run%model%variables(number)%meaning
         scale%values = run%plan%axes(axis)%values(index, :)
      end associate
   end subroutine set_swept

   !> Name of a swept variable: its own or, where two that are swept share it, with the group before it.
   function name_of_swept(run, variable) result(name)
      class(run_t), intent(in) :: run
      !> Index of the variable in the model's table, from 1.
      integer, intent(in) :: variable
      character(:), allocatable :: name
      integer :: i, n_same

      n_same = 0
      do i = 1, size(run%model%variables)
         if (run%model%variables(i)%name /= run%model%variables(variable)%name) cycle
         if (run%plan%is_swept(i)) n_same = n_same + 1
      end do
      name = run%model%variables(variable)%name
      if (n_same > 1) name = run%model%variables(variable)%group//'_'//name
   end function name_of_swept

   !> Name of a dimension of the points: that of the variable that leads, or a name of its own, with a number behind it where
   !> another dimension before it has the same.
   function name_of_dimension(run, axis) result(name)
      class(run_t), intent(in) :: run
      integer, intent(in) :: axis
      character(:), allocatable :: name
      integer :: k, n_same

      if (.not. allocated(run%plan%axes(axis)%name)) then
         name = name_of_swept(run, run%plan%axes(axis)%variables(1))
         return
      end if
      name = run%plan%axes(axis)%name
      n_same = 1
      do k = 1, axis - 1
         if (.not. allocated(run%plan%axes(k)%name)) cycle
         if (run%plan%axes(k)%name == name) n_same = n_same + 1
      end do
      if (n_same > 1) name = name//'_'//show_count(n_same)
   end function name_of_dimension

end module adfric_output_axes

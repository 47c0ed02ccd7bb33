! SPDX-License-Identifier: GPL-3.0-or-later
!> What the models of given loads share: the same numbers at one position as results, and along two axes as maps.
module adfric_plane_field_model
   use adfric_base_kinds, only: dp
   use adfric_base_words, only: get_word, count_words
   use adfric_plane_model, only: halfspace_model_t
   use adfric_describe_pointwise, only: point_state_t
   use adfric_describe_status, only: status_solved
   use adfric_describe_rows, only: result_row
   use adfric_describe_table, only: result_t, profile_t, profile_axis_t
   implicit none (type, external)
   private
   public :: field_model_t, set_stresses, set_plane_stresses, set_displacements, maps_of

   !> A model of given loads: its results are the field at one position, its profiles maps of the field.
   type, abstract, extends(halfspace_model_t) :: field_model_t
   contains
      procedure(get_field_i), deferred :: get_field
      procedure(get_position_i), deferred :: get_position
      procedure :: solve_point
      procedure :: fill_profiles
   end type field_model_t

   abstract interface

      !> The results at a position.
      subroutine get_field_i(self, values, position, field)
         import :: field_model_t, dp
         implicit none (type, external)
         !> The model whose field is evaluated.
         class(field_model_t), intent(in) :: self
         !> Values of the variables, in the order of the table; shape `(n_variables)`.
         real(dp), intent(in) :: values(:)
         !> Coordinates x, y, z of the position [m]; of a half-plane x, y, 0.
         real(dp), intent(in) :: position(3)
         !> Results at the position, NaN where there is no value; shape `(n_results)`.
         real(dp), intent(out) :: field(:)
      end subroutine get_field_i

      !> The position of the results, or a position of a map, whose coordinates along the axes replace those of the results.
      pure function get_position_i(self, values, slow, fast) result(position)
         import :: field_model_t, dp
         implicit none (type, external)
         !> The model, whose type alone says which axes its maps have.
         class(field_model_t), intent(in) :: self
         !> Values of the variables, in the order of the table; shape `(n_variables)`.
         real(dp), intent(in) :: values(:)
         !> Coordinates on the axes of a map [m]; without them the position is that of the results.
         real(dp), intent(in), optional :: slow, fast
         real(dp) :: position(3)
      end function get_position_i

   end interface

contains

   !> Set rows of stresses.
   subroutine set_stresses(components, r)
      !> Components separated by a blank, such as 'xx yy xy'.
      character(*), intent(in) :: components
      !> Table of results; its first rows are set, one for each component.
      type(result_t), intent(inout) :: r(:)
      character(:), allocatable :: name
      integer :: k

      do k = 1, count_words(components)
         name = get_word(components, k)
         r(k) = result_row(name='stress_'//name, unit='Pa', long_name='stress s_'//name//', tension positive', is_main=.true.)
      end do
   end subroutine set_stresses

   !> Set the rows of the stresses in the plane: s_xx, s_yy, s_xy and the largest shear.
   subroutine set_plane_stresses(r)
      !> Table of results; its first four rows are set.
      type(result_t), intent(inout) :: r(:)
      integer, parameter :: shear = 4

      call set_stresses('xx yy xy', r)
      r(shear) = result_row(name='largest_shear_stress', unit='Pa', long_name='largest shear stress in the plane', is_main=.true.)
   end subroutine set_plane_stresses

   !> Set rows of displacements.
   subroutine set_displacements(components, r)
      !> Components separated by a blank, such as 'x y'.
      character(*), intent(in) :: components
      !> Table of results; its first rows are set, one for each component.
      type(result_t), intent(inout) :: r(:)
      character(:), allocatable :: name
      integer :: k

      do k = 1, count_words(components)
         name = get_word(components, k)
         r(k) = result_row(name='displacement_'//name, unit='m', long_name='displacement along '//name)
      end do
   end subroutine set_displacements

   !> Table of the profiles: a map of every result.
   function maps_of(results) result(p)
      !> Table of results, each of which gets a map of its own.
      type(result_t), intent(in) :: results(:)
      type(profile_t), allocatable :: p(:)
      integer :: k

      allocate (p(size(results)))
      do k = 1, size(results)
         p(k)%name = results(k)%name//'_map'
         p(k)%unit = results(k)%unit
         p(k)%long_name = results(k)%long_name
      end do
   end function maps_of

   !> See `pointwise_model_t`. Where the field has no value, under a concentrated load, the results are NaN.
   subroutine solve_point(self, values, state, results, error_estimate, status, counts)
      !> The model whose field is evaluated at the position of the results.
      class(field_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Nothing is left for the next point.
      class(point_state_t), allocatable, intent(inout) :: state
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Estimated relative error of the main result [-].
      real(dp), intent(out) :: error_estimate
      !> Status of the point, one of `status_...`.
      integer, intent(out) :: status
      !> These models count nothing; size 0.
      real(dp), intent(inout) :: counts(:)

      call self%get_field(values, self%get_position(values), results)
      error_estimate = epsilon(error_estimate)
      status = status_solved
      associate (unused => state, unused_counts => counts)
      end associate
   end subroutine solve_point

   !> See `pointwise_model_t`.
   subroutine fill_profiles(self, values, results, state, axes, profiles)
      class(field_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> What `solve_block` found for this point, not used here.
      real(dp), intent(in) :: results(:)
      !> What `solve_point` has left, not used here.
      class(point_state_t), allocatable, intent(in) :: state
      type(profile_axis_t), intent(in) :: axes(:)
      !> In: all NaN. Out: profiles of the point; shape `(n_fast, n_slow, n_profiles)`.
      real(dp), intent(inout) :: profiles(:, :, :)
      integer :: i, j

      associate (slow => axes(1)%coordinates, fast => axes(2)%coordinates)
         do j = 1, size(slow)
            do i = 1, size(fast)
               call self%get_field(values, self%get_position(values, slow(j), fast(i)), profiles(i, j, :))
            end do
         end do
      end associate
      associate (unused => results, unused_state => state)
      end associate
   end subroutine fill_profiles

end module adfric_plane_field_model

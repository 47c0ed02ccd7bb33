! SPDX-License-Identifier: GPL-3.0-or-later
!> A model that holds another one, and is like it but for its results: the first ones are those of the inner model.
module adfric_run_wrapped_model
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_watch, only: watch_t
   use adfric_describe_derived, only: derived_t
   use adfric_describe_model, only: model_t
   use adfric_describe_table, only: profile_axis_t, profile_t
   implicit none (type, external)
   private
   public :: wrapped_model_t

   !> A model around another one; whoever extends it solves blocks.
   type, abstract, extends(model_t) :: wrapped_model_t
      !> The inner model.
      class(model_t), allocatable :: inner
   contains
      procedure :: wrap
      procedure :: inner_values
      procedure :: inner_results
      procedure :: check_values
      procedure :: wants_profiles
      procedure :: get_profile_axes
      procedure :: solve_profiles
      procedure :: prepare
      procedure :: release
      procedure :: obey
      procedure :: take_dataset
      procedure :: take_attribute
      procedure :: derive_quantities
      procedure :: describe_case
      procedure :: describe_doubts
      procedure :: velocity_of_heat
      procedure :: measure
      procedure :: get_nominal_sizes
      procedure :: count_profiles
      procedure :: describe_profiles
      procedure :: unit_of
   end type wrapped_model_t

contains

   !> Take over a model, with its tables but for that of the results.
   subroutine wrap(self, inner)
      class(wrapped_model_t), intent(inout) :: self
      !> The model, which is not allocated afterwards.
      class(model_t), allocatable, intent(inout) :: inner

      call move_alloc(inner, self%inner)
      self%name = self%inner%name
      if (allocated(self%inner%scene)) self%scene = self%inner%scene
      if (allocated(self%inner%scene_names)) self%scene_names = self%inner%scene_names
      self%summary = self%inner%summary
      self%references = self%inner%references
      self%variables = self%inner%variables
      self%profiles = self%inner%profiles
      self%counts = self%inner%counts
      self%profile_axes = self%inner%profile_axes
      self%largest_block = self%inner%largest_block
      self%shares_points = self%inner%shares_points
   end subroutine wrap

   !> Values of the inner model: here the same. A model that counts otherwise overrides it.
   pure function inner_values(self, values) result(inner)
      class(wrapped_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      real(dp) :: inner(size(values))

      inner = values
      associate (unused => self)
      end associate
   end function inner_values

   !> Results of the inner model, which are the first ones: here the same. A model that counts otherwise overrides it.
   pure function inner_results(self, values, results) result(inner)
      class(wrapped_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Results of a point; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      real(dp) :: inner(size(self%inner%results))

      inner = results(:size(inner))
      associate (unused => values)
      end associate
   end function inner_results

   !> See `model_t`.
   subroutine check_values(self, values, is_swept, problems)
      class(wrapped_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      logical, intent(in) :: is_swept(:)
      type(problems_t), intent(inout) :: problems

      call self%inner%check_values(self%inner_values(values), is_swept, problems)
   end subroutine check_values

   !> See `model_t`.
   pure logical function wants_profiles(self, values)
      class(wrapped_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)

      wants_profiles = self%inner%wants_profiles(self%inner_values(values))
   end function wants_profiles

   !> See `model_t`.
   subroutine get_profile_axes(self, values, axes)
      class(wrapped_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(profile_axis_t), allocatable, intent(out) :: axes(:)

      call self%inner%get_profile_axes(self%inner_values(values), axes)
   end subroutine get_profile_axes

   !> See `model_t`.
   subroutine solve_profiles(self, values, results, profiles)
      class(wrapped_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:), results(:)
      real(dp), intent(out) :: profiles(:, :, :)

      call self%inner%solve_profiles(self%inner_values(values), self%inner_results(values, results), profiles)
   end subroutine solve_profiles

   !> See `model_t`.
   subroutine prepare(self)
      class(wrapped_model_t), intent(inout) :: self

      call self%inner%prepare()
   end subroutine prepare

   !> See `model_t`.
   subroutine release(self)
      class(wrapped_model_t), intent(inout) :: self

      call self%inner%release()
   end subroutine release

   !> See `model_t`.
   subroutine obey(self, watch)
      class(wrapped_model_t), intent(inout) :: self
      class(watch_t), pointer, intent(in) :: watch

      self%watch => watch
      call self%inner%obey(watch)
   end subroutine obey

   !> See `model_t`.
   subroutine take_dataset(self, index, values, problems)
      class(wrapped_model_t), intent(inout) :: self
      integer, intent(in) :: index
      real(dp), intent(in) :: values(:, :)
      type(problems_t), intent(inout) :: problems

      call self%inner%take_dataset(index, values, problems)
      self%largest_block = self%inner%largest_block
   end subroutine take_dataset

   !> See `model_t`.
   subroutine take_attribute(self, index, name, value, problems)
      class(wrapped_model_t), intent(inout) :: self
      integer, intent(in) :: index
      character(*), intent(in) :: name
      real(dp), intent(in) :: value
      type(problems_t), intent(inout) :: problems

      call self%inner%take_attribute(index, name, value, problems)
   end subroutine take_attribute

   !> See `model_t`.
   function derive_quantities(self, values) result(derived)
      class(wrapped_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(derived_t), allocatable :: derived(:)

      allocate (derived, source=self%inner%derive_quantities(self%inner_values(values)))
   end function derive_quantities

   !> See `model_t`.
   function describe_case(self, values) result(text)
      class(wrapped_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text

      text = self%inner%describe_case(self%inner_values(values))
   end function describe_case

   !> See `model_t`.
   function describe_doubts(self, values) result(text)
      class(wrapped_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text

      text = self%inner%describe_doubts(self%inner_values(values))
   end function describe_doubts

   !> See `model_t`.
   real(dp) function velocity_of_heat(self, values) result(velocity)
      class(wrapped_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)

      velocity = self%inner%velocity_of_heat(self%inner_values(values))
   end function velocity_of_heat

   !> See `model_t`.
   subroutine measure(self, values, results, measures)
      class(wrapped_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:), results(:)
      real(dp), intent(inout) :: measures(:)

      call self%inner%measure(self%inner_values(values), self%inner_results(values, results), measures)
   end subroutine measure

   !> See `model_t`.
   pure subroutine get_nominal_sizes(self, values, sizes)
      class(wrapped_model_t), intent(in) :: self
      real(dp), intent(in), contiguous :: values(:, :)
      real(dp), intent(out) :: sizes(:)
      real(dp) :: inner(size(values, 1), size(values, 2))
      integer :: i

      do i = 1, size(values, 2)
         inner(:, i) = self%inner_values(values(:, i))
      end do
      call self%inner%get_nominal_sizes(inner, sizes)
   end subroutine get_nominal_sizes

   !> See `model_t`.
   pure integer function count_profiles(self, values)
      class(wrapped_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)

      count_profiles = self%inner%count_profiles(self%inner_values(values))
   end function count_profiles

   !> See `model_t`.
   function describe_profiles(self, values) result(profiles)
      class(wrapped_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(profile_t), allocatable :: profiles(:)

      allocate (profiles, source=self%inner%describe_profiles(self%inner_values(values)))
   end function describe_profiles

   !> See `model_t`.
   function unit_of(self, values, index) result(unit)
      class(wrapped_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      integer, intent(in) :: index
      character(:), allocatable :: unit

      unit = self%inner%unit_of(self%inner_values(values), index)
   end function unit_of

end module adfric_run_wrapped_model

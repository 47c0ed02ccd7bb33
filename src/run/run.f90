! SPDX-License-Identifier: GPL-3.0-or-later
!> A run: a model, the points that it solves, and what belongs to all of them.
!>
!> Whoever has a run and a sink solves it by two calls: `prepare` of its model, and `run_sweep` of the runner. What a run is
!> does not depend on where its description comes from (a namelist file, a caller of the library) or where its results go.
module adfric_run_run
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_describe_model, only: model_t
   use adfric_describe_plausible_range, only: find_plausible_range
   use adfric_run_blocks, only: blocks_t, part_t, new_blocks
   use adfric_run_dataset, only: dataset_t
   use adfric_run_doubting_model, only: let_doubt
   use adfric_run_plan, only: plan_t
   use adfric_run_refinement, only: refinement_t
   use adfric_run_variation, only: variation_t
   use adfric_run_varied_model, only: vary_model
   implicit none (type, external)
   private
   public :: run_t, new_run

   !> A run.
   type :: run_t
      !> The model that solves the points.
      class(model_t), allocatable :: model
      !> Every point: the base values and the swept axes.
      type(plan_t) :: plan
      !> Part of the run that is solved.
      type(part_t) :: part
      !> Datasets that the variables name, shape `(n_variables)`; without a text where a variable names none.
      type(dataset_t), allocatable :: datasets(:)
      !> Digest of what is solved beside the model's variables and datasets, such as what is fitted; not allocated if there is nothing.
      character(:), allocatable :: digest
      !> How the only sweep is refined before it is solved.
      type(refinement_t) :: refinement
      !> What is wanted to know beside the results of the model.
      type(variation_t) :: variation
      !> Title; empty if there is none.
      character(:), allocatable :: title
      !> Whole text of the input, from which the run can be repeated; empty if there is none.
      character(:), allocatable :: text
      !> Name of the results file; empty if there is none.
      character(:), allocatable :: output
   contains
      procedure :: complete_model
      procedure :: blocks
      procedure :: profile_shape
   end type run_t

contains

   !> A run of one point, at which each variable has its default value, without texts and results file.
   subroutine new_run(self, model)
      !> Receives the run, to which values, axes and texts may be added.
      class(run_t), intent(out) :: self
      !> The model that solves the points; the run takes it over, and it is not allocated any more.
      class(model_t), allocatable, intent(inout) :: model
      integer :: i

      call move_alloc(model, self%model)
      call let_doubt(self%model)
      allocate (self%variation%derivatives(0), self%variation%uncertain(0))
      allocate (self%plan%base(size(self%model%variables)), self%plan%axes(0), self%datasets(size(self%model%variables)))
      do i = 1, size(self%plan%base)
         self%plan%base(i) = self%model%variables(i)%default
      end do
      self%title = ''
      self%text = ''
      self%output = ''
   end subroutine new_run

   !> Let the model tell what is wanted beside its results, and what is doubted. Once, when all variables have their values.
   subroutine complete_model(self)
      class(run_t), intent(inout) :: self

      if (self%variation%is_wanted()) call apply_variation(self)
      ! the doubt is no result of the neighbours of a point
      call let_doubt(self%model)
   end subroutine complete_model

   !> Let the model tell what is wanted beside its results.
   subroutine apply_variation(self)
      class(run_t), intent(inout) :: self
      real(dp) :: scales(size(self%plan%base)), upper
      integer :: i

      do i = 1, size(scales)
         scales(i) = 0
         if (is_set(self%plan%base(i))) scales(i) = maxval(abs(self%plan%values_of(i)))
         if (scales(i) > 0) cycle
         ! a variable that is 0 everywhere: the least size that is usual
         call find_plausible_range(self%model%variables(i), self%model%unit_of(self%plan%base, i), scales(i), upper)
         if (.not. scales(i) > 0) scales(i) = 1
      end do
      call vary_model(self%model, self%variation, scales)
   end subroutine apply_variation

   !> The blocks of the part of the run.
   pure function blocks(self)
      !> The run, whose number of points, part and model say how it is cut.
      class(run_t), intent(in) :: self
      type(blocks_t) :: blocks

      call new_blocks(blocks, self%plan%n_points(), self%part, self%model%largest_block)
   end function blocks

   !> Shape of the profiles of a point, the axis that runs fastest first: `(n_last_axis, n_first_axis, n_profiles)`; zeros if no
   !> profiles are wanted.
   function profile_shape(self) result(counts)
      !> The run, whose base values say whether profiles are wanted, and how long they are.
      class(run_t), intent(in) :: self
      integer :: counts(3)

      counts = 0
      if (self%model%wants_profiles(self%plan%base)) counts = self%model%profile_shape(self%plan%base)
   end function profile_shape

end module adfric_run_run

! SPDX-License-Identifier: GPL-3.0-or-later
!> What is said of results as a whole, as the attributes of a results file do.
module adfric_c_attributes
   use, intrinsic :: iso_c_binding, only: c_char, c_double, c_loc, c_null_char, c_null_ptr, c_ptr
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_words, only: get_word
   use adfric_c_texts, only: keep_text
   use adfric_output_heading, only: conventions, heading_t, new_heading, source_of
   use adfric_run_memory_sink, only: memory_sink_t
   use adfric_run_run, only: run_t
   use adfric_system_files, only: utc_time
   implicit none (type, external)
   private
   public :: attribute_info_t, attributes_t, new_attributes

   !> Number of attributes that all results have at most.
   integer, parameter :: n_common = 15

   !> `adfric_attribute_info` of adfric.h.
   type, bind(c) :: attribute_info_t
      !> Name, and the text or null.
      type(c_ptr) :: name, text
      !> The number, or NaN.
      real(c_double) :: number
   end type attribute_info_t

   !> An attribute.
   type :: attribute_t
      !> What C gets.
      type(attribute_info_t) :: info
      !> The text with a 0 at its end.
      character(kind=c_char), allocatable :: text(:)
   end type attribute_t

   !> All attributes.
   type :: attributes_t
      !> The attributes; shape at least `(n)`.
      type(attribute_t), allocatable :: items(:)
      !> Number of attributes.
      integer :: n = 0
   end type attributes_t

contains

   !> Find what is said of a run.
   subroutine new_attributes(self, run, found, seconds, error)
      !> Receives the attributes; it must stay where it is.
      type(attributes_t), target, intent(out) :: self
      !> The run, with its model and its points.
      class(run_t), intent(in) :: run
      !> What was found.
      type(memory_sink_t), intent(in) :: found
      !> Time that the solution took [s].
      real(dp), intent(in) :: seconds
      !> Receives that there is too little memory.
      type(error_t), allocatable, intent(inout) :: error
      type(heading_t) :: heading

      call new_heading(heading, run)
      allocate (self%items(n_common + 2*size(heading%data) + size(run%model%counts)))
      call add_texts(self, heading, error)
      call add_numbers(self, run, found, seconds, error)
   end subroutine new_attributes

   !> Add what the heading of a file says.
   subroutine add_texts(self, heading, error)
      type(attributes_t), target, intent(inout) :: self
      !> The heading that a file of the run would have.
      type(heading_t), intent(in) :: heading
      type(error_t), allocatable, intent(inout) :: error
      integer :: i

      call add_text(self, 'title', heading%title, error)
      if (len(heading%scene) > 0) call add_text(self, 'scene', heading%scene, error)
      call add_text(self, 'model', heading%model, error)
      call add_text(self, 'adfric_version', heading%version, error)
      call add_text(self, 'git_revision', heading%revision, error)
      call add_text(self, 'compiler', heading%compiler, error)
      call add_text(self, 'created', utc_time(), error)
      call add_text(self, 'Conventions', conventions, error)
      call add_text(self, 'source', source_of(heading), error)
      if (len(heading%references) > 0) call add_text(self, 'references', heading%references, error)
      call add_text(self, 'input', heading%input, error)
      call add_text(self, 'case_hash', heading%hash, error)
      if (size(heading%data) > 0) call add_text(self, 'datasets', heading%data_names, error)
      do i = 1, size(heading%data)
         call add_text(self, 'dataset_'//get_word(heading%data_names, i), heading%data(i)%name, error)
         call add_text(self, 'checksum_'//get_word(heading%data_names, i), heading%data(i)%checksum, error)
      end do
   end subroutine add_texts

   !> Add the time, and what the model has counted.
   subroutine add_numbers(self, run, found, seconds, error)
      type(attributes_t), target, intent(inout) :: self
      !> The run, whose model counts.
      class(run_t), intent(in) :: run
      type(memory_sink_t), intent(in) :: found
      real(dp), intent(in) :: seconds
      type(error_t), allocatable, intent(inout) :: error
      real(dp) :: means(size(run%model%counts))
      integer :: i

      means = found%mean_counts()
      call add(self, 'wall_seconds', seconds, error)
      do i = 1, size(means)
         call add(self, run%model%counts(i)%name, means(i), error)
      end do
   end subroutine add_numbers

   !> Add an attribute.
   subroutine add(self, name, number, error)
      !> The attributes, the last one of which is new.
      type(attributes_t), target, intent(inout) :: self
      character(*), intent(in) :: name
      !> Its number; NaN if it gets a text.
      real(dp), intent(in) :: number
      type(error_t), allocatable, intent(inout) :: error

      self%n = self%n + 1
      call keep_text(name, self%items(self%n)%info%name, error)
      self%items(self%n)%info%text = c_null_ptr
      self%items(self%n)%info%number = number
   end subroutine add

   !> Add an attribute that is a text.
   subroutine add_text(self, name, text, error)
      type(attributes_t), target, intent(inout) :: self
      character(*), intent(in) :: name
      !> Its text.
      character(*), intent(in) :: text
      type(error_t), allocatable, intent(inout) :: error
      integer :: i

      call add(self, name, not_a_number(), error)
      allocate (self%items(self%n)%text(len(text) + 1))
      do i = 1, len(text)
         self%items(self%n)%text(i) = text(i:i)
      end do
      self%items(self%n)%text(len(text) + 1) = c_null_char
      self%items(self%n)%info%text = c_loc(self%items(self%n)%text)
   end subroutine add_text

end module adfric_c_attributes

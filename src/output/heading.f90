! SPDX-License-Identifier: GPL-3.0-or-later
!> What a results file says of its run as a whole.
module adfric_output_heading
   use, intrinsic :: iso_fortran_env, only: compiler_version
   use hdf5, only: hid_t
   use adfric_base_version, only: program_version, git_revision
   use adfric_base_words, only: count_words, get_word
   use adfric_hdf5_attributes, only: write_attribute
   use adfric_hdf5_calls, only: hdf5_calls_t
   use adfric_hdf5_reading, only: has_attribute, read_attribute
   use adfric_run_case_hash, only: case_hash
   use adfric_run_run, only: run_t
   use adfric_system_files, only: utc_time
   implicit none (type, external)
   private
   public :: heading_t, new_heading, write_heading, read_heading, say_difference, conventions, source_of

   !> The CF conventions that a file keeps.
   character(*), parameter :: conventions = 'CF-1.11'

   !> What is said of a dataset that the input names.
   type :: data_note_t
      !> FILE:/DATASET, and the checksum of its values.
      character(:), allocatable :: name, checksum
   end type data_note_t

   !> The texts at the root of the file.
   type :: heading_t
      !> Title of the run; without one the scene, or the name of the model.
      character(:), allocatable :: title
      !> What is solved, in words; empty where the input names a model.
      character(:), allocatable :: scene
      !> Name of the model.
      character(:), allocatable :: model
      !> Where the model was published.
      character(:), allocatable :: references
      !> What was done before to get these results, a line each; empty for a run that begins.
      character(:), allocatable :: history
      !> Version of the program.
      character(:), allocatable :: version
      !> Revision of its sources.
      character(:), allocatable :: revision
      !> Compiler that it was built by.
      character(:), allocatable :: compiler
      !> Whole text of the input.
      character(:), allocatable :: input
      !> Variables that name a dataset, separated by a blank.
      character(:), allocatable :: data_names
      !> Name and checksum of the dataset of each of these.
      type(data_note_t), allocatable :: data(:)
      !> Hash of the case; empty in a file that adfric has not made.
      character(:), allocatable :: hash
   end type heading_t

contains

   !> The heading of a run of this program.
   subroutine new_heading(self, run)
      !> Receives the texts; its history is empty.
      type(heading_t), intent(out) :: self
      !> The run, with its model and its points.
      class(run_t), intent(in) :: run

      self%scene = ''
      if (allocated(run%model%scene)) self%scene = run%model%scene
      self%title = run%title
      ! the CF conventions want one
      if (len_trim(self%title) == 0) self%title = self%scene
      if (len_trim(self%title) == 0) self%title = run%model%name
      self%model = run%model%name
      self%references = run%model%references
      self%history = ''
      self%version = program_version
      self%revision = git_revision
      self%compiler = compiler_version()
      self%input = run%text
      self%hash = case_hash(run)
      call set_data(self, run)
   end subroutine new_heading

   !> What is said of the datasets that the input names.
   subroutine set_data(self, run)
      !> Receives the names and the checksums of the datasets.
      type(heading_t), intent(inout) :: self
      class(run_t), intent(in) :: run
      integer :: i, n

      allocate (self%data(count(run%datasets%is_in_file())))
      self%data_names = ''
      n = 0
      do i = 1, size(run%datasets)
         if (.not. run%datasets(i)%is_in_file()) cycle
         n = n + 1
         self%data_names = trim(self%data_names//' '//run%model%variables(i)%name)
         self%data(n)%name = run%datasets(i)%text
         self%data(n)%checksum = run%datasets(i)%checksum
      end do
      self%data_names = trim(adjustl(self%data_names))
   end subroutine set_data

   !> Write the heading of a new file.
   subroutine write_heading(calls, file, heading)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      !> Texts to write at the root of the file; a history that is not empty is that of files that are merged.
      type(heading_t), intent(in) :: heading
      character(:), allocatable :: name
      integer :: i

      call write_attribute(calls, file, 'title', heading%title)
      if (len(heading%scene) > 0) call write_attribute(calls, file, 'scene', heading%scene)
      call write_attribute(calls, file, 'model', heading%model)
      call write_attribute(calls, file, 'adfric_version', heading%version)
      call write_attribute(calls, file, 'git_revision', heading%revision)
      call write_attribute(calls, file, 'compiler', heading%compiler)
      call write_attribute(calls, file, 'created', utc_time())
      call write_conventions(calls, file, heading)
      call write_attribute(calls, file, 'input', heading%input)
      call write_attribute(calls, file, 'case_hash', heading%hash)
      if (size(heading%data) > 0) call write_attribute(calls, file, 'datasets', heading%data_names)
      do i = 1, size(heading%data)
         name = get_word(heading%data_names, i)
         call write_attribute(calls, file, 'dataset_'//name, heading%data(i)%name)
         call write_attribute(calls, file, 'checksum_'//name, heading%data(i)%checksum)
      end do
   end subroutine write_heading

   !> Write what the CF conventions ask of a file.
   subroutine write_conventions(calls, file, heading)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      !> Heading of the file; a history that is not empty is that of files that are merged.
      type(heading_t), intent(in) :: heading
      character(:), allocatable :: program, step

      program = source_of(heading)
      step = ' run'
      if (len(heading%history) > 0) step = ' merge'
      call write_attribute(calls, file, 'Conventions', conventions)
      call write_attribute(calls, file, 'source', program)
      call write_attribute(calls, file, 'history', heading%history//utc_time()//' '//program//step//new_line('a'))
      if (len(heading%references) > 0) call write_attribute(calls, file, 'references', heading%references)
   end subroutine write_conventions

   !> The program that has made a file.
   pure function source_of(heading) result(program)
      !> Heading of the file.
      type(heading_t), intent(in) :: heading
      character(:), allocatable :: program

      program = 'adfric '//heading%version//' ('//heading%revision//')'
   end function source_of

   !> Read the heading of a file.
   subroutine read_heading(calls, file, heading)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      !> Receives the texts at the root of the file; `hash` is empty if adfric has not made the file.
      type(heading_t), intent(out) :: heading
      character(:), allocatable :: name
      integer :: i

      heading%hash = ''
      heading%data_names = ''
      allocate (heading%data(0))
      if (.not. has_attribute(calls, file, 'case_hash')) return
      call read_attribute(calls, file, 'title', heading%title)
      heading%scene = ''
      if (has_attribute(calls, file, 'scene')) call read_attribute(calls, file, 'scene', heading%scene)
      call read_attribute(calls, file, 'model', heading%model)
      call read_attribute(calls, file, 'adfric_version', heading%version)
      call read_attribute(calls, file, 'git_revision', heading%revision)
      call read_attribute(calls, file, 'compiler', heading%compiler)
      call read_attribute(calls, file, 'input', heading%input)
      call read_attribute(calls, file, 'history', heading%history)
      heading%references = ''
      if (has_attribute(calls, file, 'references')) call read_attribute(calls, file, 'references', heading%references)
      call read_attribute(calls, file, 'case_hash', heading%hash)
      if (has_attribute(calls, file, 'datasets')) call read_attribute(calls, file, 'datasets', heading%data_names)
      deallocate (heading%data)
      allocate (heading%data(count_words(heading%data_names)))
      do i = 1, size(heading%data)
         name = get_word(heading%data_names, i)
         call read_attribute(calls, file, 'dataset_'//name, heading%data(i)%name)
         call read_attribute(calls, file, 'checksum_'//name, heading%data(i)%checksum)
      end do
   end subroutine read_heading

   !> Why a file does not belong to a run; empty if it does.
   pure function say_difference(other, own) result(text)
      !> Heading of the file, and heading of the run.
      type(heading_t), intent(in) :: other, own
      character(:), allocatable :: text

      text = ''
      if (other%hash == own%hash) return
      if (len(other%hash) == 0) then
         text = 'it is no results file of adfric'
      else if (other%version /= own%version .or. other%revision /= own%revision) then
         text = 'it was made by another program, adfric '//other%version//' ('//other%revision//'), not ' &
            //own%version//' ('//own%revision//')'
      else if (other%compiler /= own%compiler) then
         text = 'it was made by a program of another compiler, '//other%compiler//', not '//own%compiler
      else if (other%model /= own%model) then
         text = 'it was made from another input, with model = '''//other%model//''''
      else if (has_other_data(other, own)) then
         text = 'it was made from other data, in '//own%data(1)%name
      else
         text = 'it was made from another input'
      end if
   end function say_difference

   !> Do the datasets of two files have the same names, but not the same values?
   pure logical function has_other_data(other, own)
      type(heading_t), intent(in) :: other, own
      integer :: i

      has_other_data = .false.
      if (size(own%data) == 0 .or. other%data_names /= own%data_names) return
      do i = 1, size(own%data)
         has_other_data = has_other_data .or. other%data(i)%checksum /= own%data(i)%checksum
      end do
   end function has_other_data

end module adfric_output_heading

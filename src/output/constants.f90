! SPDX-License-Identifier: GPL-3.0-or-later
!> What has one value in a whole run: the variables that are not swept, given or by default, and what follows from them.
module adfric_output_constants
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_base_words, only: has_word
   use adfric_describe_model, only: derived_t
   use adfric_describe_table, only: kind_choice, kind_dataset, kind_logical
   use adfric_describe_word_sets, only: show_words
   use adfric_run_run, only: run_t
   implicit none (type, external)
   private
   public :: constant_t, find_constants, add_derived_constants, file_unit, list_taken, name_in_file

   !> Words of a logical variable, for 0 and 1.
   character(*), parameter :: logical_words = 'false true'

   !> A number, or one of several words, that holds for every point.
   type :: constant_t
      !> Name of the dataset.
      character(:), allocatable :: name
      !> Unit as it stands in the file.
      character(:), allocatable :: unit
      !> What the value is, in a phrase.
      character(:), allocatable :: long_name
      !> Meanings of `first_flag`, `first_flag + 1`, ... separated by a blank; empty for real numbers.
      character(:), allocatable :: flag_meanings
      !> The state that the first of these meanings is of.
      integer :: first_flag = 0
      !> The number, or the state as a number.
      real(dp) :: value = 0
   end type constant_t

contains

   !> The variables that have one value.
   subroutine find_constants(run, constants)
      class(run_t), intent(in) :: run
      !> Receives the variables that are set and not swept, but for datasets.
      type(constant_t), allocatable, intent(out) :: constants(:)
      character(:), allocatable :: taken
      logical :: is_constant(size(run%model%variables))
      integer :: i, n

      taken = list_taken(run)
      do i = 1, size(is_constant)
         is_constant(i) = run%model%variables(i)%kind /= kind_dataset .and. is_set(run%plan%base(i))
         if (is_constant(i)) is_constant(i) = .not. (run%plan%is_swept(i) .or. run%model%variables(i)%is_hidden)
      end do
      allocate (constants(count(is_constant)))
      n = 0
      do i = 1, size(is_constant)
         if (.not. is_constant(i)) cycle
         n = n + 1
         call set_constant(run, i, taken, constants(n))
      end do
   end subroutine find_constants

   !> A variable that has one value.
   subroutine set_constant(run, index, taken, constant)
      class(run_t), intent(in) :: run
      !> Index of the variable in the variables of the model.
      integer, intent(in) :: index
      !> Names of other datasets that the file may have.
      character(*), intent(in) :: taken
      !> Receives the name, the unit and the value.
      type(constant_t), intent(out) :: constant

      associate (variable => run%model%variables(index))
         constant%name = name_in_file(run, index, taken)
         constant%unit = file_unit(run%model%unit_of(run%plan%base, index))
         constant%long_name = variable%meaning
         constant%value = run%plan%base(index)
         constant%flag_meanings = ''
         if (variable%kind == kind_logical) constant%flag_meanings = logical_words
         if (variable%kind == kind_choice) then
            constant%flag_meanings = variable%choices
            constant%first_flag = 1
            if (variable%takes_several) then
               ! of all sums of words the file knows that of the run
               constant%flag_meanings = show_words(variable%choices, constant%value, '', '+')
               constant%first_flag = nint(constant%value)
            end if
         end if
      end associate
   end subroutine set_constant

   !> Add the quantities that follow from what is not swept. It may take a while, as for the spectrum of a surface.
   subroutine add_derived_constants(run, constants)
      !> The run, with its model and its points.
      class(run_t), intent(in) :: run
      !> The constants so far; the derived quantities that have one value in the run are added.
      type(constant_t), allocatable, intent(inout) :: constants(:)
      type(derived_t), allocatable :: derived(:)
      type(constant_t), allocatable :: longer(:)
      logical, allocatable :: is_constant(:)
      integer :: i, n

      allocate (derived, source=run%model%get_derived(run%plan%base))
      call find_derived_constants(run, derived, is_constant)
      n = size(constants)
      allocate (longer(n + count(is_constant)))
      longer(:n) = constants
      do i = 1, size(derived)
         if (.not. is_constant(i)) cycle
         n = n + 1
         longer(n)%name = derived(i)%name
         longer(n)%unit = file_unit(derived(i)%unit)
         longer(n)%long_name = derived(i)%long_name
         longer(n)%flag_meanings = ''
         longer(n)%value = derived(i)%value
      end do
      call move_alloc(longer, constants)
   end subroutine add_derived_constants

   !> Which derived quantities have one value in the run, and a name of their own.
   subroutine find_derived_constants(run, derived, is_constant)
      class(run_t), intent(in) :: run
      type(derived_t), intent(in) :: derived(:)
      !> Receives whether each of them is one.
      logical, allocatable, intent(out) :: is_constant(:)
      character(:), allocatable :: taken
      integer :: i, k

      allocate (is_constant(size(derived)))
      taken = list_taken(run)
      do i = 1, size(derived)
         is_constant(i) = .not. has_word(taken, derived(i)%name)
         do k = 1, size(run%model%variables)
            if (.not. run%plan%is_swept(k)) cycle
            if (derived(i)%follows_from(run%model%variables(k)%own_name())) is_constant(i) = .false.
         end do
      end do
   end subroutine find_derived_constants

   !> A unit as it stands in the file: 1 for a pure number.
   pure function file_unit(unit) result(text)
      !> Unit as the model gives it; a hyphen, or nothing, for a pure number.
      character(*), intent(in) :: unit
      character(:), allocatable :: text

      text = unit
      if (len_trim(unit) == 0 .or. unit == '-') text = '1'
   end function file_unit

   !> Name of a variable in the file; with its group before it where it would not be the only one of its name.
   function name_in_file(run, variable, taken) result(name)
      class(run_t), intent(in) :: run
      !> Index of the variable in the variables of the model.
      integer, intent(in) :: variable
      !> Names of other datasets that the file may have, see `list_taken`.
      character(*), intent(in) :: taken
      character(:), allocatable :: name
      logical :: is_alone
      integer :: i

      name = run%model%variables(variable)%name
      is_alone = .not. has_word(taken, name)
      do i = 1, size(run%model%variables)
         if (i == variable .or. run%model%variables(i)%name /= name) cycle
         if (run%model%variables(i)%has_bare_name .or. .not. run%model%variables(variable)%has_bare_name) is_alone = .false.
      end do
      if (.not. is_alone) name = run%model%variables(variable)%group//'_'//name
   end function name_in_file

   !> Names of the other datasets that a file may have: results, profiles and their axes, swept variables.
   function list_taken(run) result(names)
      class(run_t), intent(in) :: run
      character(:), allocatable :: names
      integer :: i

      names = 'status error_estimate blocks '//run%model%profile_axes
      if (allocated(run%model%extra_names)) names = names//' '//run%model%extra_names
      do i = 1, size(run%model%results)
         names = names//' '//run%model%results(i)%name
      end do
      do i = 1, size(run%model%profiles)
         names = names//' '//run%model%profiles(i)%name
      end do
      do i = 1, size(run%model%variables)
         if (run%plan%is_swept(i)) names = names//' '//run%model%variables(i)%name
      end do
   end function list_taken

end module adfric_output_constants

!> What has one value in a whole run: the variables that are not swept, given or by default, and what follows from them.
module adfric_output_constants
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_base_words, only: has_word
   use adfric_model_model, only: model_t, derived_t
   use adfric_model_table, only: variable_t, kind_choice, kind_dataset, kind_logical
   use adfric_run_plan, only: plan_t
   implicit none (type, external)
   private
   public :: constant_t, find_constants, add_derived_constants, file_unit

   !> Words of a logical variable, for 0 and 1.
   character(*), parameter :: logical_words = 'false true'

   !> A number, or one of several words, that holds for every point.
   type :: constant_t
      character(:), allocatable :: name
      character(:), allocatable :: unit
      character(:), allocatable :: long_name
      !> Meanings of `first_flag`, `first_flag + 1`, ... separated by a blank; empty for real numbers.
      character(:), allocatable :: flag_meanings
      integer :: first_flag = 0
      real(dp) :: value = 0
   end type constant_t

contains

   !> The variables that have one value.
   subroutine find_constants(model, plan, constants)
      !> Model of the run, with the descriptions of its variables and results.
      class(model_t), intent(in) :: model
      !> Plan of the run: the values of its variables, and which of them are swept.
      type(plan_t), intent(in) :: plan
      !> Receives the variables that are set and not swept, but for datasets.
      type(constant_t), allocatable, intent(out) :: constants(:)
      type(constant_t) :: constant
      integer :: i

      allocate (constants(0))
      do i = 1, size(model%variables)
         associate (variable => model%variables(i))
            if (variable%kind == kind_dataset .or. .not. is_set(plan%base(i)) .or. is_swept(plan, i)) cycle
            constant%name = name_of(model, plan, i)
            constant%unit = file_unit(model%unit_of(plan%base, i))
            constant%long_name = variable%meaning
            constant%value = plan%base(i)
            constant%flag_meanings = ''
            constant%first_flag = 0
            if (variable%kind == kind_logical) constant%flag_meanings = logical_words
            if (variable%kind == kind_choice) then
               constant%flag_meanings = variable%choices
               constant%first_flag = 1
            end if
         end associate
         constants = [constants, constant]
      end do
   end subroutine find_constants

   !> Add the quantities that follow from what is not swept. It may take a while, as for the spectrum of a surface.
   subroutine add_derived_constants(model, plan, constants)
      !> Model of the run, with the descriptions of its variables and results.
      class(model_t), intent(in) :: model
      !> Plan of the run: the values of its variables, and which of them are swept.
      type(plan_t), intent(in) :: plan
      !> The constants so far; the derived quantities that have one value in the run are added.
      type(constant_t), allocatable, intent(inout) :: constants(:)
      type(derived_t), allocatable :: derived(:)
      type(constant_t) :: constant
      logical :: is_constant
      integer :: i, k

      allocate (derived, source=model%get_derived(plan%base))
      do i = 1, size(derived)
         is_constant = .not. has_word(list_taken(model, plan), derived(i)%name)
         do k = 1, size(plan%axes)
            if (derived(i)%follows_from(model%variables(plan%axes(k)%variable)%name)) is_constant = .false.
         end do
         if (.not. is_constant) cycle
         constant%name = derived(i)%name
         constant%unit = file_unit(derived(i)%unit)
         constant%long_name = derived(i)%long_name
         constant%flag_meanings = ''
         constant%value = derived(i)%value
         constants = [constants, constant]
      end do
   end subroutine add_derived_constants

   !> A unit as it stands in the file: 1 for a pure number.
   pure function file_unit(unit) result(text)
      !> Unit as the model gives it; a hyphen, or nothing, for a pure number.
      character(*), intent(in) :: unit
      character(:), allocatable :: text

      text = unit
      if (len_trim(unit) == 0 .or. unit == '-') text = '1'
   end function file_unit

   !> Is a variable swept?
   pure logical function is_swept(plan, variable)
      !> Plan of the run: the values of its variables, and which of them are swept.
      type(plan_t), intent(in) :: plan
      !> Place of the variable in the variables of the model.
      integer, intent(in) :: variable
      integer :: k

      is_swept = .false.
      do k = 1, size(plan%axes)
         is_swept = is_swept .or. plan%axes(k)%variable == variable
      end do
   end function is_swept

   !> Name of a variable in the file; with its group before it where it would not be the only one of its name.
   function name_of(model, plan, variable) result(name)
      !> Model of the run, with the descriptions of its variables and results.
      class(model_t), intent(in) :: model
      !> Plan of the run: the values of its variables, and which of them are swept.
      type(plan_t), intent(in) :: plan
      !> Place of the variable in the variables of the model.
      integer, intent(in) :: variable
      character(:), allocatable :: name
      logical :: is_alone
      integer :: i

      name = model%variables(variable)%name
      is_alone = .not. has_word(list_taken(model, plan), name)
      do i = 1, size(model%variables)
         if (i == variable .or. model%variables(i)%name /= name) cycle
         if (model%variables(i)%has_bare_name .or. .not. model%variables(variable)%has_bare_name) is_alone = .false.
      end do
      if (.not. is_alone) name = model%variables(variable)%group//'_'//name
   end function name_of

   !> Names of the other datasets that a file may have: results, profiles and their axes, swept variables.
   function list_taken(model, plan) result(names)
      !> Model of the run, with the descriptions of its variables and results.
      class(model_t), intent(in) :: model
      !> Plan of the run: the values of its variables, and which of them are swept.
      type(plan_t), intent(in) :: plan
      character(:), allocatable :: names
      integer :: i

      names = 'status error_estimate blocks '//model%profile_axes
      do i = 1, size(model%results)
         names = names//' '//model%results(i)%name
      end do
      do i = 1, size(model%profiles)
         names = names//' '//model%profiles(i)%name
      end do
      do i = 1, size(plan%axes)
         names = names//' '//model%variables(plan%axes(i)%variable)%name
      end do
   end function list_taken

end module adfric_output_constants

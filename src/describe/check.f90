! SPDX-License-Identifier: GPL-3.0-or-later
!> Checks that models share: values that are missing, that stand beside others which say the same, or that may not be swept.
module adfric_describe_check
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: show_number
   use adfric_base_unset, only: is_set
   use adfric_describe_table, only: variable_t, kind_choice
   implicit none (type, external)
   private
   public :: checks_t, new_checks, require, require_one, refuse_given, refuse_size, refuse_swept

   !> The values of an input while they are checked: what the rules of a model read, and where they say what is wrong.
   type :: checks_t
      !> Table of the variables; messages have their groups and names from it.
      type(variable_t), pointer :: variables(:) => null()
      !> Values of the variables, `unset` where none is given.
      real(dp), pointer :: values(:) => null()
      !> Is the variable swept? Null where no rule asks for it.
      logical, pointer :: is_swept(:) => null()
      !> What is wrong with the input.
      type(problems_t), pointer :: problems => null()
   contains
      procedure :: has
      procedure :: has_any
      procedure :: is_above_zero
      procedure :: is_choice
      procedure :: add
      procedure :: need
      procedure :: need_one
      procedure :: refuse
   end type checks_t

contains

   !> Begin to check values. All that is given has to stay as long as the checks.
   subroutine new_checks(self, variables, values, problems, is_swept)
      !> Receives what the rules read.
      type(checks_t), intent(out) :: self
      !> Table of the variables of the model; shape `(n_variables)`.
      type(variable_t), intent(in), target :: variables(:)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in), target :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout), target :: problems
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in), target, optional :: is_swept(:)

      self%variables => variables
      self%values => values
      self%problems => problems
      if (present(is_swept)) self%is_swept => is_swept
   end subroutine new_checks

   !> Is the variable given?
   pure logical function has(self, index)
      class(checks_t), intent(in) :: self
      !> Index of the variable in the table, as in the following.
      integer, intent(in) :: index

      has = is_set(self%values(index))
   end function has

   !> Is a variable of a list given?
   pure logical function has_any(self, list)
      class(checks_t), intent(in) :: self
      !> Indices of the variables in the table, as in the following.
      integer, intent(in) :: list(:)

      has_any = any(is_set(self%values(list)))
   end function has_any

   !> Is the number given, and above 0; or is the switch on?
   pure logical function is_above_zero(self, index)
      class(checks_t), intent(in) :: self
      !> Index of the variable.
      integer, intent(in) :: index

      is_above_zero = self%has(index) .and. self%values(index) > 0
   end function is_above_zero

   !> Is a word the one of this number?
   pure logical function is_choice(self, index, number)
      class(checks_t), intent(in) :: self
      !> Index of the variable, whose word is known.
      integer, intent(in) :: index
      !> Number of the word in the choices, from 1.
      integer, intent(in) :: number

      is_choice = nint(self%values(index)) == number
   end function is_choice

   !> A rule: say of a variable what is wrong if the rule is broken.
   subroutine add(self, index, text, is_broken)
      class(checks_t), intent(in) :: self
      !> Index of the variable.
      integer, intent(in) :: index
      !> What is wrong, behind the name of the variable.
      character(*), intent(in) :: text
      !> Is the rule broken? It is if this is absent.
      logical, intent(in), optional :: is_broken

      if (present(is_broken)) then
         if (.not. is_broken) return
      end if
      associate (v => self%variables(index))
         call self%problems%add(v%group, v%name, text)
      end associate
   end subroutine add

   !> Each of a list has to be given, if that is needed.
   subroutine need(self, list, is_needed)
      class(checks_t), intent(in) :: self
      !> Indices of the variables.
      integer, intent(in) :: list(:)
      !> Is it needed? It is if this is absent.
      logical, intent(in), optional :: is_needed

      if (present(is_needed)) then
         if (.not. is_needed) return
      end if
      call require(self%variables, self%values, list, self%problems)
   end subroutine need

   !> See `require_one`.
   subroutine need_one(self, list, is_needed)
      class(checks_t), intent(in) :: self
      !> Indices of the variables.
      integer, intent(in) :: list(:)
      !> Has one of the list to be given?
      logical, intent(in) :: is_needed

      call require_one(self%variables, self%values, list, is_needed, self%problems)
   end subroutine need_one

   !> Of a list none may be given or swept, since it has no meaning beside other values.
   subroutine refuse(self, list, text)
      class(checks_t), intent(in) :: self
      !> Indices of the variables.
      integer, intent(in) :: list(:)
      !> Why, behind the name of the variable.
      character(*), intent(in) :: text
      integer :: k

      do k = 1, size(list)
         if (self%has(list(k))) then
            call self%add(list(k), text)
         else if (associated(self%is_swept)) then
            call self%add(list(k), text, self%is_swept(list(k)))
         end if
      end do
   end subroutine refuse

   !> Each of a list has to be given.
   subroutine require(variables, values, list, problems, reason)
      !> Table of the variables of the model; shape `(n_variables)`.
      type(variable_t), intent(in) :: variables(:)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Indices of the variables of the list in their table.
      integer, intent(in) :: list(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      !> Why they are needed, behind a semicolon; absent: no reason is given.
      character(*), intent(in), optional :: reason
      character(:), allocatable :: behind
      integer :: k

      behind = ''
      if (present(reason)) behind = '; '//reason
      do k = 1, size(list)
         if (is_set(values(list(k)))) cycle
         associate (v => variables(list(k)))
            if (v%kind == kind_choice) then
               call problems%add(v%group, v%name, 'is missing, one of '//v%choices//behind)
            else
               call problems%add(v%group, v%name, 'is missing ['//v%unit//']'//behind)
            end if
         end associate
      end do
   end subroutine require

   !> A value is possible, but its contact needs numbers that no computer has.
   subroutine refuse_size(variable, value, problems)
      !> Row of the variable.
      type(variable_t), intent(in) :: variable
      !> Its value, in its unit.
      real(dp), intent(in) :: value
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      call problems%add(variable%group, variable%name, 'leads to numbers above 1e308 or below 1e-308 with these bodies, given '// &
         & show_number(value)//' ['//variable%unit//']')
   end subroutine refuse_size

   !> Of a list not more than one may be given, and one has to be if it is needed.
   subroutine require_one(variables, values, list, is_needed, problems)
      !> Table of the variables of the model; shape `(n_variables)`.
      type(variable_t), intent(in) :: variables(:)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Indices of the variables of the list in their table.
      integer, intent(in) :: list(:)
      !> Has one of the list to be given?
      logical, intent(in) :: is_needed
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: first, last

      first = findloc(is_set(values(list)), .true., 1)
      last = findloc(is_set(values(list)), .true., 1, back=.true.)
      if (first == 0 .and. is_needed) then
         associate (v => variables(list(1)))
            call problems%add(v%group, v%name, 'is missing; one of '//list_names(variables, list)//' is needed')
         end associate
      else if (last > first) then
         associate (v => variables(list(first)), w => variables(list(last)))
            call problems%add(v%group, v%name, 'stands beside '//w%name//'; give one of them')
         end associate
      end if
   end subroutine require_one

   !> Of a list none may be given, since it has no meaning beside other values.
   subroutine refuse_given(variables, values, is_swept, list, text, problems)
      !> Table of the variables of the model; shape `(n_variables)`.
      type(variable_t), intent(in), target :: variables(:)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in), target :: values(:)
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in), target :: is_swept(:)
      !> Indices of the variables of the list in their table.
      integer, intent(in) :: list(:)
      !> Why, behind the name of the variable.
      character(*), intent(in) :: text
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout), target :: problems
      type(checks_t) :: c

      call new_checks(c, variables, values, problems, is_swept)
      call c%refuse(list, text)
   end subroutine refuse_given

   !> Of a list none may be swept, since the axis of the profiles depends on them and all points share it.
   subroutine refuse_swept(variables, is_swept, list, problems)
      !> Table of the variables of the model; shape `(n_variables)`.
      type(variable_t), intent(in) :: variables(:)
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      !> Indices of the variables of the list in their table.
      integer, intent(in) :: list(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: k

      do k = 1, size(list)
         associate (v => variables(list(k)))
            if (is_swept(list(k))) call problems%add(v%group, v%name, &
               & 'is swept, but all profiles share one axis; sweep another variable')
         end associate
      end do
   end subroutine refuse_swept

   !> Names as in `a, b or c`.
   pure function list_names(variables, list) result(text)
      type(variable_t), intent(in) :: variables(:)
      !> Indices of the variables of the list in their table, one or more.
      integer, intent(in) :: list(:)
      character(:), allocatable :: text
      integer, allocatable :: known(:)
      integer :: k

      known = pack(list, .not. variables(list)%is_hidden)
      text = ''
      do k = 1, size(known)
         if (k == size(known) .and. k > 1) then
            text = text//' or '
         else if (k > 1) then
            text = text//', '
         end if
         text = text//variables(known(k))%name
      end do
   end function list_names

end module adfric_describe_check

! SPDX-License-Identifier: GPL-3.0-or-later
!> A list of everything that is wrong with an input, so that the user sees all of it at once.
module adfric_base_problems
   implicit none (type, external)
   private
   public :: problem_t, problems_t

   !> One problem. Where there is no group, no variable or no known line the component is empty or 0.
   type :: problem_t
      !> Namelist group, without `&`.
      character(:), allocatable :: group
      !> Which group of that name, from 1; 0 where the group may stand only once.
      integer :: index = 0
      !> Variable of the group.
      character(:), allocatable :: variable
      !> Line of the file, from 1; 0 unknown.
      integer :: line = 0
      !> What is wrong, what was given, what is allowed.
      character(:), allocatable :: text
   end type problem_t

   !> So many are enough: an input with more is not what somebody meant to write, and each takes time and a line.
   integer, parameter :: most_problems = 100

   !> The problems found so far, in the order in which they were found.
   type :: problems_t
      !> The problems.
      type(problem_t), allocatable :: items(:)
      !> Has the reading been given up, so that nothing may be concluded from what has not been found?
      logical :: is_given_up = .false.
   contains
      procedure :: add
      procedure :: is_enough
      procedure :: count => count_problems
      procedure :: is_repeated
      procedure :: line_of
   end type problems_t

contains

   !> Add a problem to the list.
   pure subroutine add(self, group, variable, text, index, line)
      class(problems_t), intent(inout) :: self
      !> Namelist group, without `&`; empty if there is none.
      character(*), intent(in) :: group
      !> Variable of the group; empty if there is none.
      character(*), intent(in) :: variable
      !> What is wrong, what was given, what is allowed.
      character(*), intent(in) :: text
      !> Which group of that name, from 1; 0 or absent where the group may stand only once.
      integer, intent(in), optional :: index
      !> Line of the file, from 1; 0 or absent if it is not known.
      integer, intent(in), optional :: line
      type(problem_t) :: item

      item%group = group
      item%variable = variable
      item%text = text
      if (present(index)) item%index = index
      if (present(line)) item%line = line
      if (.not. allocated(self%items)) allocate (self%items(0))
      self%items = [self%items, item]
   end subroutine add

   !> Is it time to stop looking for more?
   pure logical function is_enough(self)
      class(problems_t), intent(in) :: self

      is_enough = self%is_given_up .or. self%count() >= most_problems
   end function is_enough

   !> Has an earlier problem the same line? What is read twice is wrong once.
   pure logical function is_repeated(self, i)
      class(problems_t), intent(in) :: self
      !> Index of the problem in the list, from 1.
      integer, intent(in) :: i
      integer :: k

      is_repeated = .false.
      do k = 1, i - 1
         if (self%line_of(k, '') == self%line_of(i, '')) is_repeated = .true.
      end do
   end function is_repeated

   !> Number of problems.
   pure integer function count_problems(self)
      class(problems_t), intent(in) :: self

      count_problems = 0
      if (allocated(self%items)) count_problems = size(self%items)
   end function count_problems

   !> The line that is printed for a problem: `FILE.nml: &group[index] variable: text (line 7)`, or `&group variable: text`.
   pure function line_of(self, i, file) result(line)
      class(problems_t), intent(in) :: self
      !> Index of the problem in the list, from 1.
      integer, intent(in) :: i
      !> Name of the input file; empty if there is none.
      character(*), intent(in) :: file
      character(:), allocatable :: line, text
      character(12) :: number

      associate (item => self%items(i))
         text = ''
         if (len(file) > 0) text = file//':'
         if (len(item%group) > 0) text = text//' &'//item%group
         if (item%index > 0) then
            write (number, '(i0)') item%index
            text = text//'['//trim(number)//']'
         end if
         if (len(item%variable) > 0) text = text//' '//item%variable
         if (len(item%group) + len(item%variable) > 0) text = text//':'
         text = text//' '//item%text
         if (item%line > 0) then
            write (number, '(i0)') item%line
            text = text//' (line '//trim(number)//')'
         end if
      end associate
      ! the blank before the group separates it from the name of a file
      line = text(merge(2, 1, len(file) == 0):)
   end function line_of

end module adfric_base_problems

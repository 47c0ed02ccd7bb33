! SPDX-License-Identifier: GPL-3.0-or-later
!> A namelist file in memory: its whole text, its groups and its assignments.
module adfric_input_namelist_file
   use adfric_base_error, only: error_t, set_error, input_failure
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: show_count
   use adfric_base_words, only: has_word
   use adfric_input_text_table, only: text_table_t
   use adfric_input_assignment_scan, only: assignment_t, scan_assignments
   use adfric_input_group_scan, only: group_t, repeatable, scan_groups
   use adfric_input_source_text, only: source_t, new_source, find_control_character
   use adfric_input_whole_file, only: read_whole_file
   implicit none (type, external)
   private
   public :: namelist_file_t, open_namelist_file, open_namelist_text, new_namelist_file, no_namelist_file

   !> A namelist file.
   type :: namelist_file_t
      !> Name of the file, as the user gave it.
      character(:), allocatable :: path
      !> Text of the file, byte by byte.
      character(:), allocatable :: text
      !> The text without comments, everything else at the same positions.
      type(source_t) :: source
      !> The groups, in the order of the file.
      type(group_t), allocatable :: groups(:)
      !> The assignments of all groups, in the order of the file.
      type(assignment_t), allocatable :: assignments(:)
      !> Tables that somebody has in memory; their names go before those of files.
      type(text_table_t), allocatable :: tables(:)
   contains
      procedure :: find_group
      procedure :: find_assignment
      procedure :: value_of
      procedure :: line_of
      procedure :: report
      procedure :: report_variable
   end type namelist_file_t

contains

   !> Read a file and find its groups and assignments.
   subroutine open_namelist_file(self, path, problems, error)
      !> Receives the text with its groups and assignments; empty if there is an error.
      type(namelist_file_t), intent(out) :: self
      !> Name of the file, as the user gave it.
      character(*), intent(in) :: path
      type(problems_t), intent(inout) :: problems
      !> Allocated if the file cannot be read, or is no text.
      type(error_t), allocatable, intent(out) :: error
      character(:), allocatable :: text

      call read_whole_file(path, text, error)
      if (allocated(error)) return
      call open_namelist_text(self, path, text, problems, error)
      if (allocated(error)) error%message = path//': '//error%message
   end subroutine open_namelist_file

   !> Find the groups and assignments of a text that may be none.
   subroutine open_namelist_text(self, path, text, problems, error)
      type(namelist_file_t), intent(out) :: self
      !> Name of the file, as the user gave it; empty if there is none.
      character(*), intent(in) :: path
      !> The whole text of the file, byte by byte.
      character(*), intent(in) :: text
      type(problems_t), intent(inout) :: problems
      !> Allocated if it is no text; without the name of the file.
      type(error_t), allocatable, intent(out) :: error
      type(source_t) :: source
      integer :: index

      index = find_control_character(text)
      if (index > 0) then
         call new_source(source, text(:index))
         call set_error(error, input_failure, 'cannot be an input, it is not a text, given the control '// &
            'character '//show_count(iachar(text(index:index)))//' (line '//show_count(source%line_at(index))//')')
         return
      end if
      call new_namelist_file(self, path, text, problems)
   end subroutine open_namelist_text

   !> Find groups and assignments of a text; whatever stands twice is a problem.
   subroutine new_namelist_file(self, path, text, problems)
      !> Receives the text with its groups and assignments.
      type(namelist_file_t), intent(out) :: self
      character(*), intent(in) :: path, text
      type(problems_t), intent(inout) :: problems

      self%path = path
      self%text = text
      call new_source(self%source, text)
      call scan_groups(self%source, self%groups, problems)
      call scan_assignments(self%source, self%groups, self%assignments, problems)
      call report_repeated_groups(self, problems)
      call report_repeated_variables(self, problems)
   end subroutine new_namelist_file

   !> What stands for the file of a case that is from none.
   subroutine no_namelist_file(self)
      !> Receives a file without a name, a text and groups.
      type(namelist_file_t), intent(out) :: self

      self%path = ''
      self%text = ''
      call new_source(self%source, '')
      allocate (self%groups(0), self%assignments(0))
   end subroutine no_namelist_file

   !> Report groups that stand twice.
   subroutine report_repeated_groups(self, problems)
      type(namelist_file_t), intent(in) :: self
      type(problems_t), intent(inout) :: problems
      integer :: i, first

      do i = 1, size(self%groups)
         if (self%groups(i)%index < 2 .or. has_word(repeatable, self%groups(i)%name)) cycle
         if (problems%is_enough()) exit
         first = self%find_group(trim(self%groups(i)%name))
         call self%report(problems, i, '', 'the group is given twice, first in line '// &
            show_count(self%line_of(self%groups(first)%first))//', allowed: once', self%groups(i)%first)
      end do
   end subroutine report_repeated_groups

   !> Report variables that stand twice in their group.
   subroutine report_repeated_variables(self, problems)
      !> The file, whose assignments are compared within each group.
      type(namelist_file_t), intent(in) :: self
      type(problems_t), intent(inout) :: problems
      integer :: i, first

      do i = 1, size(self%assignments)
         first = self%find_assignment(self%assignments(i)%group, trim(self%assignments(i)%name))
         if (first == i) cycle
         if (problems%is_enough()) exit
         call self%report(problems, self%assignments(i)%group, trim(self%assignments(i)%name), &
            'the variable is given twice, first in line '//show_count(self%line_of(self%assignments(first)%first))// &
            ', allowed: once', self%assignments(i)%first)
      end do
   end subroutine report_repeated_variables

   !> Number of the first group of a name; 0 if there is none.
   pure integer function find_group(self, name)
      class(namelist_file_t), intent(in) :: self
      !> Name of the group, in small letters.
      character(*), intent(in) :: name

      do find_group = 1, size(self%groups)
         if (self%groups(find_group)%name == name) return
      end do
      find_group = 0
   end function find_group

   !> Number of the first assignment to a variable of a group; 0 if there is none.
   pure integer function find_assignment(self, group, name)
      class(namelist_file_t), intent(in) :: self
      !> Number of the group in the file, from 1.
      integer, intent(in) :: group
      !> Name of the variable, in small letters.
      character(*), intent(in) :: name

      do find_assignment = 1, size(self%assignments)
         if (self%assignments(find_assignment)%group /= group) cycle
         if (self%assignments(find_assignment)%name == name) return
      end do
      find_assignment = 0
   end function find_assignment

   !> Text of the value of an assignment, without comments.
   pure function value_of(self, assignment) result(text)
      class(namelist_file_t), intent(in) :: self
      !> Number of the assignment in the file, from 1.
      integer, intent(in) :: assignment
      character(:), allocatable :: text

      associate (item => self%assignments(assignment))
         text = self%source%bare(item%value_first:item%value_last)
      end associate
   end function value_of

   !> Line of a position in the text.
   pure integer function line_of(self, position)
      class(namelist_file_t), intent(in) :: self
      !> Position in the text, from 1 to one behind its end.
      integer, intent(in) :: position

      line_of = self%source%line_at(position)
   end function line_of

   !> Add a problem of a group to the list.
   pure subroutine report(self, problems, group, variable, text, position)
      !> The file, which gives the name of the group and the number of the line.
      class(namelist_file_t), intent(in) :: self
      !> Receives the problem behind those that there are.
      type(problems_t), intent(inout) :: problems
      !> Number of the group in the file, from 1.
      integer, intent(in) :: group
      !> Name of the variable; empty if the problem is one of the whole group.
      character(*), intent(in) :: variable
      !> What is wrong, what was given, what is allowed.
      character(*), intent(in) :: text
      !> Position in the text of what is wrong, for the number of the line.
      integer, intent(in) :: position

      call problems%add(trim(self%groups(group)%name), variable, text, &
         index=self%groups(group)%shown_index, line=self%line_of(position))
   end subroutine report

   !> Add a problem of a variable to the list, with the line where it stands; where it does not, that of its group.
   subroutine report_variable(self, problems, group, variable, text, index)
      class(namelist_file_t), intent(in) :: self
      !> Receives the problem behind those that there are.
      type(problems_t), intent(inout) :: problems
      !> Number of the group in the file, from 1.
      integer, intent(in) :: group
      !> Name of the variable; empty if the problem is one of the whole group.
      character(*), intent(in) :: variable
      !> What is wrong, what was given, what is allowed.
      character(*), intent(in) :: text
      !> Position of what is wrong in the text of the value; absent: the name of the variable is meant.
      integer, intent(in), optional :: index
      integer :: number, position

      position = self%groups(group)%first
      number = self%find_assignment(group, variable)
      if (number > 0) position = self%assignments(number)%first
      if (number > 0 .and. present(index)) position = self%assignments(number)%value_first + index - 1
      call self%report(problems, group, variable, text, position)
   end subroutine report_variable

end module adfric_input_namelist_file

! SPDX-License-Identifier: GPL-3.0-or-later
!> Where the assignments of a namelist file stand: `variable = value` within the groups.
module adfric_input_assignment_scan
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: newline, name_length, to_lower, is_name, is_separator, show_count, show_text, strip
   use adfric_input_group_scan, only: group_t
   use adfric_input_source_text, only: source_t, end_of_quote
   implicit none (type, external)
   private
   public :: assignment_t, scan_assignments

   !> Assignments that a file may have: more than all variables of a model and a sweep of each of them.
   integer, parameter :: most_assignments = 2000

   !> A `variable = value`.
   type :: assignment_t
      !> Number of the group in the file, from 1.
      integer :: group = 0
      !> Name of the variable, in small letters.
      character(name_length) :: name = ''
      !> Position of the name in the text.
      integer :: first = 0
      !> Ends of the value in the text, without surrounding blanks and the comma that may follow.
      integer :: value_first = 0, value_last = 0
   end type assignment_t

contains

   !> Find the assignments of all groups.
   subroutine scan_assignments(source, groups, assignments, problems)
      type(source_t), intent(in) :: source
      !> The groups of the file; those in which something makes no sense are marked as garbled.
      type(group_t), intent(inout) :: groups(:)
      !> The assignments of all groups, in the order of the file.
      type(assignment_t), allocatable, intent(out) :: assignments(:)
      type(problems_t), intent(inout) :: problems
      type(assignment_t), allocatable :: found(:)
      integer :: i, n

      allocate (found(most_assignments))
      n = 0
      do i = 1, size(groups)
         if (problems%is_enough()) exit
         call scan_group(source, groups(i), i, found, n, problems)
      end do
      assignments = found(:n)
   end subroutine scan_assignments

   !> Find the assignments of one group.
   subroutine scan_group(source, group, number, assignments, n, problems)
      type(source_t), intent(in) :: source
      !> The group to look through; it is marked as garbled if something in it makes no sense.
      type(group_t), intent(inout) :: group
      integer, intent(in) :: number
      !> Space for the assignments of all groups; those of this group follow the ones found before.
      type(assignment_t), intent(inout) :: assignments(:)
      !> Number of assignments found so far.
      integer, intent(inout) :: n
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: name
      integer :: equals, next_equals, name_first, next_first

      call find_assignment(source%bare, group%body_first, group%body_last, name_first, equals)
      call check_start(source, group, name_first, problems)
      do while (equals <= group%body_last .and. .not. problems%is_enough())
         call find_assignment(source%bare, equals + 1, group%body_last, next_first, next_equals)
         name = strip(source%bare(name_first:equals - 1))
         if (.not. is_name(name)) then
            call report_name(source, group, name, equals, problems)
         else if (n == size(assignments)) then
            call problems%add('', '', 'no input has more than '//show_count(n)//' variables', line=source%line_at(equals))
            problems%is_given_up = .true.
         else
            n = n + 1
            assignments(n)%group = number
            assignments(n)%name = to_lower(name)
            assignments(n)%first = name_first
            call trim_value(source%bare, equals + 1, next_first - 1, assignments(n))
         end if
         equals = next_equals
         name_first = next_first
      end do
   end subroutine scan_group

   !> Find the next `name =`; both positions are behind `last` if there is none. A `=` without a name is passed over:
   !> it belongs to what stands before it.
   pure subroutine find_assignment(bare, first, last, name_first, equals)
      !> Text of the file without comments.
      character(*), intent(in) :: bare
      !> Ends of the part of the text that is searched; `first` lies outside of quotes.
      integer, intent(in) :: first, last
      !> Position where the name begins.
      integer, intent(out) :: name_first
      !> Position of the `=` behind the name.
      integer, intent(out) :: equals

      equals = first
      do while (equals <= last)
         select case (bare(equals:equals))
         case ('''', '"')
            equals = end_of_quote(bare, equals)
         case ('=')
            name_first = first + start_of_name(bare(first:equals - 1)) - 1
            if (len(strip(bare(name_first:equals - 1))) > 0) return
         end select
         equals = equals + 1
      end do
      equals = last + 1
      name_first = last + 1
   end subroutine find_assignment

   !> Position of the name, with its subscripts, at the end of a text.
   pure integer function start_of_name(text)
      !> What stands before the `=`, from the end of the assignment before.
      character(*), intent(in) :: text
      integer :: bracket

      start_of_name = skip_blanks_back(text, len(text) + 1)
      if (start_of_name > 1) then
         ! only what ends with a bracket is searched for another: it is the end of a name, and searched no more
         if (text(start_of_name - 1:start_of_name - 1) == ')') then
            bracket = index(text, '(', back=.true.)
            if (bracket > 0) start_of_name = skip_blanks_back(text, bracket)
         end if
      end if
      do while (start_of_name > 1)
         if (is_separator(text(start_of_name - 1:start_of_name - 1))) exit
         if (scan(text(start_of_name - 1:start_of_name - 1), '''"=') > 0) exit
         start_of_name = start_of_name - 1
      end do
   end function start_of_name

   !> First position of the blanks before a position.
   pure integer function skip_blanks_back(text, position)
      !> Text that is looked through backwards.
      character(*), intent(in) :: text
      !> Position behind the blanks, at most one behind the text.
      integer, intent(in) :: position

      do skip_blanks_back = position, 2, -1
         if (.not. (text(skip_blanks_back - 1:skip_blanks_back - 1) == ' ' .or. &
            text(skip_blanks_back - 1:skip_blanks_back - 1) == newline)) return
      end do
      skip_blanks_back = 1
   end function skip_blanks_back

   !> Report what stands between the name of a group and its first assignment.
   subroutine check_start(source, group, name_first, problems)
      type(source_t), intent(in) :: source
      !> The group; it is marked as garbled if something stands there.
      type(group_t), intent(inout) :: group
      !> Position where its first assignment begins; one behind the group if there is none.
      integer, intent(in) :: name_first
      type(problems_t), intent(inout) :: problems
      integer :: first

      first = group%body_first + verify(source%bare(group%body_first:name_first - 1), ' '//newline) - 1
      if (first < group%body_first) return
      group%is_garbled = .true.
      call problems%add(trim(group%name), '', 'not an assignment, given '// &
         show_text(strip(source%bare(first:name_first - 1)))//', allowed: variable = value', &
         index=group%shown_index, line=source%line_at(first))
   end subroutine check_start

   !> Report what cannot be the name of a variable.
   subroutine report_name(source, group, name, equals, problems)
      type(source_t), intent(in) :: source
      !> The group of the assignment, which is marked as garbled.
      type(group_t), intent(inout) :: group
      !> What stands where a name should stand.
      character(*), intent(in) :: name
      !> Position of the `=` behind it, for the number of the line.
      integer, intent(in) :: equals
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: what

      group%is_garbled = .true.
      what = 'not a name of a variable'
      if (scan(name, '(%') > 0) what = 'subscripts and components are not known here'
      call problems%add(trim(group%name), '', what//', given '//show_text(name//' =')// &
         ', allowed: variable = value', index=group%shown_index, line=source%line_at(equals))
   end subroutine report_name

   !> Set where the value of an assignment stands.
   pure subroutine trim_value(bare, first, last, assignment)
      character(*), intent(in) :: bare
      !> Ends of what stands behind the `=`, up to the next name or the end of the group.
      integer, intent(in) :: first, last
      !> Receives the ends of its value; `value_last` is smaller than `value_first` if there is none.
      type(assignment_t), intent(inout) :: assignment
      integer :: length

      assignment%value_first = first
      assignment%value_last = first - 1
      length = verify(bare(first:last), ' '//newline, back=.true.)
      if (length == 0) return
      if (bare(first + length - 1:first + length - 1) == ',') &
         length = verify(bare(first:first + length - 2), ' '//newline, back=.true.)
      if (length == 0) return
      assignment%value_first = first + verify(bare(first:first + length - 1), ' '//newline) - 1
      assignment%value_last = first + length - 1
   end subroutine trim_value

end module adfric_input_assignment_scan

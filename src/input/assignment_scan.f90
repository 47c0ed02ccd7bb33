!> Where the assignments of a namelist file stand: `variable = value` within the groups.
module adfric_input_assignment_scan
   use adfric_base_problems, only: problems_t
   use adfric_input_group_scan, only: group_t
   use adfric_input_source_text, only: end_of_quote, line_at
   use adfric_input_text, only: newline, name_length, to_lower, is_name, is_separator, show_text, strip
   implicit none (type, external)
   private
   public :: assignment_t, scan_assignments

   !> A `variable = value`.
   type :: assignment_t
      !> Number of its group.
      integer :: group = 0
      !> In small letters.
      character(name_length) :: name = ''
      !> Position of its name.
      integer :: first = 0
      !> Where its value stands, without surrounding blanks and the comma that may follow.
      integer :: value_first = 0, value_last = 0
   end type assignment_t

contains

   !> Find the assignments of all groups.
   subroutine scan_assignments(bare, groups, assignments, problems)
      !> Text without comments.
      character(*), intent(in) :: bare
      type(group_t), intent(inout) :: groups(:)
      type(assignment_t), allocatable, intent(out) :: assignments(:)
      type(problems_t), intent(inout) :: problems
      integer :: i, n

      n = 0
      do i = 1, len(bare)
         if (bare(i:i) == '=') n = n + 1
      end do
      allocate (assignments(n))
      n = 0
      do i = 1, size(groups)
         call scan_group(bare, groups(i), i, assignments, n, problems)
      end do
      assignments = assignments(:n)
   end subroutine scan_assignments

   !> Find the assignments of one group.
   subroutine scan_group(bare, group, number, assignments, n, problems)
      character(*), intent(in) :: bare
      type(group_t), intent(inout) :: group
      !> Number of the group.
      integer, intent(in) :: number
      type(assignment_t), intent(inout) :: assignments(:)
      !> Assignments found so far.
      integer, intent(inout) :: n
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: name
      integer :: equals, next_equals, name_first, next_first

      call find_assignment(bare, group%body_first, group%body_last, name_first, equals)
      call check_start(bare, group, name_first, problems)
      do while (equals <= group%body_last)
         call find_assignment(bare, equals + 1, group%body_last, next_first, next_equals)
         name = strip(bare(name_first:equals - 1))
         if (is_name(name)) then
            n = n + 1
            assignments(n)%group = number
            assignments(n)%name = to_lower(name)
            assignments(n)%first = name_first
            call trim_value(bare, equals + 1, next_first - 1, assignments(n))
         else
            call report_name(bare, group, name, equals, problems)
         end if
         equals = next_equals
         name_first = next_first
      end do
   end subroutine scan_group

   !> Find the next `name =`; both positions are behind `last` if there is none. A `=` without a name is passed over:
   !> it belongs to what stands before it.
   pure subroutine find_assignment(bare, first, last, name_first, equals)
      character(*), intent(in) :: bare
      integer, intent(in) :: first, last
      integer, intent(out) :: name_first, equals

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
      character(*), intent(in) :: text

      start_of_name = skip_blanks_back(text, len(text) + 1)
      if (start_of_name > 1) then
         if (text(start_of_name - 1:start_of_name - 1) == ')' .and. index(text, '(') > 0) then
            start_of_name = skip_blanks_back(text, index(text, '(', back=.true.))
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
      character(*), intent(in) :: text
      integer, intent(in) :: position

      do skip_blanks_back = position, 2, -1
         if (.not. (text(skip_blanks_back - 1:skip_blanks_back - 1) == ' ' .or. &
            text(skip_blanks_back - 1:skip_blanks_back - 1) == newline)) return
      end do
      skip_blanks_back = 1
   end function skip_blanks_back

   !> Report what stands between the name of a group and its first assignment.
   subroutine check_start(bare, group, name_first, problems)
      character(*), intent(in) :: bare
      type(group_t), intent(inout) :: group
      integer, intent(in) :: name_first
      type(problems_t), intent(inout) :: problems
      integer :: first

      first = group%body_first + verify(bare(group%body_first:name_first - 1), ' '//newline) - 1
      if (first < group%body_first) return
      group%is_garbled = .true.
      call problems%add(trim(group%name), '', 'not an assignment, given '// &
         show_text(strip(bare(first:name_first - 1)))//', allowed: variable = value', &
         index=group%shown_index, line=line_at(bare, first))
   end subroutine check_start

   !> Report what cannot be the name of a variable.
   subroutine report_name(bare, group, name, equals, problems)
      character(*), intent(in) :: bare
      type(group_t), intent(inout) :: group
      !> What stands for a name.
      character(*), intent(in) :: name
      integer, intent(in) :: equals
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: what

      group%is_garbled = .true.
      what = 'not a name of a variable'
      if (scan(name, '(%') > 0) what = 'subscripts and components are not known here'
      call problems%add(trim(group%name), '', what//', given '//show_text(name//' =')// &
         ', allowed: variable = value', index=group%shown_index, line=line_at(bare, equals))
   end subroutine report_name

   !> Set where the value of an assignment stands.
   pure subroutine trim_value(bare, first, last, assignment)
      character(*), intent(in) :: bare
      integer, intent(in) :: first, last
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

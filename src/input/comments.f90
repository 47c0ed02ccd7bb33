! SPDX-License-Identifier: GPL-3.0-or-later
!> The comments of an input, for one that is written anew.
module adfric_input_comments
   use adfric_base_text, only: newline, strip
   use adfric_input_namelist_file, only: namelist_file_t
   implicit none (type, external)
   private
   public :: comments_before, comments_above, comments_inside, comments_at_end, comment_behind, layout_of

contains

   !> Lines of comment before a group, from the end of the group before it.
   function comments_before(file, group) result(lines)
      type(namelist_file_t), intent(in) :: file
      integer, intent(in) :: group
      character(:), allocatable :: lines
      integer :: first

      first = 1
      if (group > 1) first = behind_group(file, group - 1)
      lines = comment_lines(file%text(first:file%groups(group)%first - 1), '')
   end function comments_before

   !> Lines of comment behind the last group.
   function comments_at_end(file) result(lines)
      type(namelist_file_t), intent(in) :: file
      character(:), allocatable :: lines

      lines = ''
      if (size(file%groups) > 0) lines = comment_lines(file%text(behind_group(file, size(file%groups)):), '')
   end function comments_at_end

   !> Position behind the end of a group. What stands behind its `/` is a comment of its last assignment if that is in the
   !> same line.
   integer function behind_group(file, group)
      type(namelist_file_t), intent(in) :: file
      integer, intent(in) :: group
      integer :: i, last

      behind_group = min(file%groups(group)%body_last + 2, len(file%text) + 1)
      last = 0
      do i = 1, size(file%assignments)
         if (file%assignments(i)%group == group) last = file%assignments(i)%value_last
      end do
      if (last == 0) return
      if (index(file%text(last:behind_group - 1), newline) == 0) behind_group = end_of_line_at(file%text, behind_group - 1)
   end function behind_group

   !> Lines of comment above an assignment, from the assignment before it.
   function comments_above(file, number) result(lines)
      type(namelist_file_t), intent(in) :: file
      integer, intent(in) :: number
      character(:), allocatable :: lines
      integer :: first

      associate (assignment => file%assignments(number))
         first = file%groups(assignment%group)%body_first
         if (number > 1) then
            if (file%assignments(number - 1)%group == assignment%group) first = file%assignments(number - 1)%value_last + 1
         end if
         first = end_of_line_at(file%text, first)
         lines = comment_lines(file%text(first:assignment%first - 1), '  ')
      end associate
   end function comments_above

   !> What stands between the name of an assignment and the end of its value.
   function layout_of(file, number) result(text)
      type(namelist_file_t), intent(in) :: file
      integer, intent(in) :: number
      character(:), allocatable :: text

      associate (assignment => file%assignments(number))
         text = file%text(assignment%first:assignment%value_last)
         text = text(index(text, '='):)
      end associate
   end function layout_of

   !> The comments between the name of an assignment and the end of its value, a line each.
   function comments_inside(file, number) result(lines)
      type(namelist_file_t), intent(in) :: file
      integer, intent(in) :: number
      character(:), allocatable :: lines
      integer :: i, last

      lines = ''
      i = file%assignments(number)%first
      do while (i <= file%assignments(number)%value_last)
         ! the text without comments has blanks there
         if (file%text(i:i) == '!' .and. file%source%bare(i:i) == ' ') then
            last = end_of_line_at(file%text, i) - 1
            lines = lines//'  '//strip(file%text(i:last))//newline
            i = last
         end if
         i = i + 1
      end do
   end function comments_inside

   !> Position behind the end of a line.
   pure integer function end_of_line_at(text, position)
      character(*), intent(in) :: text
      integer, intent(in) :: position

      end_of_line_at = len(text) + 1
      if (position > len(text)) return
      if (index(text(position:), newline) > 0) end_of_line_at = position + index(text(position:), newline)
   end function end_of_line_at

   !> The lines of a text that are comments.
   pure function comment_lines(text, indent) result(lines)
      !> The text, from the beginning of a line or the end of a group.
      character(*), intent(in) :: text
      !> What each line begins with.
      character(*), intent(in) :: indent
      character(:), allocatable :: lines, line
      integer :: first, last

      lines = ''
      first = 1
      do while (first <= len(text))
         last = end_of_line_at(text, first) - 1
         line = strip(text(first:last))
         if (index(line, '!') == 1) lines = lines//indent//line//newline
         first = last + 1
      end do
   end function comment_lines

   !> The comment behind an assignment, in its line; empty if there is none.
   function comment_behind(file, number) result(comment)
      type(namelist_file_t), intent(in) :: file
      integer, intent(in) :: number
      character(:), allocatable :: comment
      integer :: first, last, mark

      comment = ''
      first = file%assignments(number)%value_last + 1
      last = end_of_line_at(file%text, first) - 1
      if (last < first) return
      if (number < size(file%assignments)) then
         if (file%assignments(number + 1)%first <= last) return
      end if
      mark = index(file%text(first:last), '!')
      if (mark > 0) comment = strip(file%text(first + mark - 1:last))
   end function comment_behind

end module adfric_input_comments

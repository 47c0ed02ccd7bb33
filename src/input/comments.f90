! SPDX-License-Identifier: GPL-3.0-or-later
!> The comments of an input, for one that is written anew.
module adfric_input_comments
   use adfric_base_text, only: newline, strip
   use adfric_input_namelist_file, only: namelist_file_t
   implicit none (type, external)
   private
   public :: comments_before, comments_above, comment_behind

contains

   !> Lines of comment before a group, from the end of the group before it.
   function comments_before(file, group) result(lines)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Number of the group.
      integer, intent(in) :: group
      character(:), allocatable :: lines
      integer :: first

      first = 1
      if (group > 1) first = end_of_line_at(file%text, file%groups(group - 1)%body_last + 1)
      lines = comment_lines(file%text(first:file%groups(group)%first - 1))
   end function comments_before

   !> Lines of comment above an assignment, from the assignment before it.
   function comments_above(file, number) result(lines)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Number of the assignment.
      integer, intent(in) :: number
      character(:), allocatable :: lines
      integer :: first

      associate (assignment => file%assignments(number))
         first = file%groups(assignment%group)%body_first
         if (number > 1) then
            if (file%assignments(number - 1)%group == assignment%group) first = file%assignments(number - 1)%value_last + 1
         end if
         first = end_of_line_at(file%text, first)
         lines = comment_lines(file%text(first:assignment%first - 1))
      end associate
   end function comments_above

   !> Position behind the end of a line.
   pure integer function end_of_line_at(text, position)
      !> The text.
      character(*), intent(in) :: text
      !> A position in the line.
      integer, intent(in) :: position

      end_of_line_at = len(text) + 1
      if (position > len(text)) return
      if (index(text(position:), newline) > 0) end_of_line_at = position + index(text(position:), newline)
   end function end_of_line_at

   !> The lines of a text that are comments.
   pure function comment_lines(text) result(lines)
      !> The text, from the beginning of a line.
      character(*), intent(in) :: text
      character(:), allocatable :: lines, line
      integer :: first, last

      lines = ''
      first = 1
      do while (first <= len(text))
         last = end_of_line_at(text, first) - 1
         line = strip(text(first:last))
         if (index(line, '!') == 1) lines = lines//text(first:last)
         first = last + 1
      end do
   end function comment_lines

   !> The comment behind an assignment, in its line; empty if there is none.
   function comment_behind(file, number) result(comment)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Number of the assignment.
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

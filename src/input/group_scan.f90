! SPDX-License-Identifier: GPL-3.0-or-later
!> Where the groups of a namelist file stand.
!>
!> The run-time library skips in silence what it does not understand, so the file is first cut into
!> pieces. A group begins with `&name`, the first thing on its line, and ends with `/` or `&end`.
!> Everything is a position in the text, so that each problem can be reported with its line.
module adfric_input_group_scan
   use adfric_base_problems, only: problems_t
   use adfric_base_words, only: has_word
   use adfric_base_text, only: newline, name_length, to_lower, is_letter, is_name_character, show_count, show_text
   use adfric_input_source_text, only: source_t, end_of_quote, is_closed, end_of_line
   implicit none (type, external)
   private
   public :: group_t, scan_groups, repeatable

   !> The groups that may stand more than once.
   character(*), parameter :: repeatable = 'sweep range uncertain data event free'
   !> Groups that a file may have: more than all groups of a model and a sweep of each of its variables.
   integer, parameter :: most_groups = 1000

   !> A namelist group.
   type :: group_t
      !> Name of the group, in small letters.
      character(name_length) :: name = ''
      !> Which group of this name, from 1.
      integer :: index = 0
      !> Number of the group in messages; 0 where they need none: for the first group of a name that may stand only once.
      integer :: shown_index = 0
      !> Position of the `&` in the text.
      integer :: first = 0
      !> Ends of the text that holds the assignments.
      integer :: body_first = 0, body_last = 0
      !> Does something in it make no sense, so that any of its variables may have been meant?
      logical :: is_garbled = .false.
      !> Is there a `/` or `&end`?
      logical :: has_end = .false.
   end type group_t

contains

   !> Find the groups.
   subroutine scan_groups(source, groups, problems)
      type(source_t), intent(in) :: source
      !> The groups, in the order of the file.
      type(group_t), allocatable, intent(out) :: groups(:)
      type(problems_t), intent(inout) :: problems
      type(group_t), allocatable :: found(:)
      integer :: position, n

      allocate (found(most_groups))
      n = 0
      position = 1
      do while (.not. problems%is_enough())
         call skip_to_group(source, position, problems)
         if (position > len(source%bare)) exit
         if (n == most_groups) then
            call problems%add('', '', 'no input has more than '//show_count(most_groups)//' groups', &
               line=source%line_at(position))
            problems%is_given_up = .true.
            exit
         end if
         n = n + 1
         associate (group => found(n))
            call read_group_name(source%bare, position, group)
            group%index = 1 + count(found(:n - 1)%name == group%name)
            if (group%index > 1 .or. has_word(repeatable, group%name)) group%shown_index = group%index
            call skip_to_group_end(source, position, group, problems)
         end associate
      end do
      groups = found(:n)
   end subroutine scan_groups

   !> Move to the next group; what stands before it is a problem.
   subroutine skip_to_group(source, position, problems)
      type(source_t), intent(in) :: source
      !> In: where to look from. Out: the `&` of the next group, or one behind the text.
      integer, intent(inout) :: position
      type(problems_t), intent(inout) :: problems
      logical :: is_reported

      is_reported = .false.
      do while (position <= len(source%bare))
         select case (source%bare(position:position))
         case (' ', newline)
         case default
            if (is_group_start(source%bare, position)) return
            if (.not. is_reported) call report_outside(source, position, problems)
            is_reported = .true.
         end select
         position = position + 1
      end do
   end subroutine skip_to_group

   !> Report text that belongs to no group.
   subroutine report_outside(source, position, problems)
      type(source_t), intent(in) :: source
      !> Position where the text begins that belongs to no group.
      integer, intent(in) :: position
      type(problems_t), intent(inout) :: problems

      call problems%add('', '', 'text outside of any group, given '// &
         show_text(trim(source%bare(position:end_of_line(source%bare, position))))// &
         ', allowed: groups &name ... / that start on a line of their own', line=source%line_at(position))
   end subroutine report_outside

   !> Does a group begin at this position?
   pure logical function is_group_start(bare, position)
      !> Text of the file without comments.
      character(*), intent(in) :: bare
      !> Position in the text, from 1.
      integer, intent(in) :: position
      integer :: i

      is_group_start = .false.
      if (bare(position:position) /= '&' .or. position == len(bare)) return
      if (.not. is_letter(bare(position + 1:position + 1))) return
      if (is_group_end(bare, position)) return
      ! only blanks lie between it and the end of the line before
      do i = position - 1, 1, -1
         if (bare(i:i) == newline) exit
         if (bare(i:i) /= ' ') return
      end do
      is_group_start = .true.
   end function is_group_start

   !> Does a group end with the word `&end` at this position?
   pure logical function is_group_end(bare, position)
      character(*), intent(in) :: bare
      integer, intent(in) :: position
      character(5) :: word

      word = to_lower(bare(position:min(position + 4, len(bare))))
      is_group_end = word(:4) == '&end' .and. .not. is_name_character(word(5:5))
   end function is_group_end

   !> Read the name after `&`.
   subroutine read_group_name(bare, position, group)
      character(*), intent(in) :: bare
      !> In: position of the `&`. Out: the position behind the name.
      integer, intent(inout) :: position
      !> Receives its name, in small letters, and its position.
      type(group_t), intent(inout) :: group

      group%first = position
      position = position + 1
      do while (position <= len(bare))
         if (.not. is_name_character(bare(position:position))) exit
         position = position + 1
      end do
      group%name = to_lower(bare(group%first + 1:min(position - 1, group%first + name_length)))
   end subroutine read_group_name

   !> Find the end of a group, and move behind it.
   subroutine skip_to_group_end(source, position, group, problems)
      type(source_t), intent(in) :: source
      !> In: the position behind the name of the group. Out: the position behind the group.
      integer, intent(inout) :: position
      !> Receives the ends of its body; it is garbled if a quote is not closed.
      type(group_t), intent(inout) :: group
      type(problems_t), intent(inout) :: problems

      call find_group_end(source%bare, position, group)
      ! a quote that is not closed is reported with its variable, and takes the / with it
      if (group%has_end .or. group%is_garbled) return
      call problems%add(trim(group%name), '', 'the / that ends the group is missing', &
         index=group%shown_index, line=source%line_at(group%first))
   end subroutine skip_to_group_end

   !> Find the end of a group, with its `/` or without.
   pure subroutine find_group_end(bare, position, group)
      character(*), intent(in) :: bare
      integer, intent(inout) :: position
      !> Receives the ends of its body, and whether it has an end; it is garbled if a quote is not closed.
      type(group_t), intent(inout) :: group
      integer :: last

      group%body_first = position
      group%has_end = .true.
      do while (position <= len(bare))
         group%body_last = position - 1
         select case (bare(position:position))
         case ('''', '"')
            last = end_of_quote(bare, position)
            group%is_garbled = group%is_garbled .or. .not. is_closed(bare(position:last))
            position = last
         case ('/')
            position = position + 1
            return
         case ('&')
            if (is_group_end(bare, position)) then
               position = position + 4
               return
            end if
            if (is_group_start(bare, position)) exit
         end select
         position = position + 1
      end do
      if (position > len(bare)) group%body_last = len(bare)
      group%has_end = .false.
   end subroutine find_group_end

end module adfric_input_group_scan

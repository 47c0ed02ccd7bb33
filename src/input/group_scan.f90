!> Where the groups of a namelist file stand.
!>
!> The run-time library skips in silence what it does not understand, so the file is first cut into
!> pieces. A group begins with `&name`, the first thing on its line, and ends with `/` or `&end`.
!> Everything is a position in the text, so that each problem can be reported with its line.
module adfric_input_group_scan
   use adfric_base_problems, only: problems_t
   use adfric_input_source_text, only: end_of_quote, is_closed, end_of_line, line_at
   use adfric_input_text, only: newline, name_length, to_lower, is_letter, is_name_character, show_text
   implicit none (type, external)
   private
   public :: group_t, scan_groups

   !> The group that may stand more than once.
   character(*), parameter :: repeatable = 'sweep'

   !> A namelist group.
   type :: group_t
      !> In small letters.
      character(name_length) :: name = ''
      !> Which group of this name, from 1.
      integer :: index = 0
      !> The same as it is reported; 0 where the group needs no number.
      integer :: shown_index = 0
      !> Position of its `&`.
      integer :: first = 0
      !> Where its assignments stand.
      integer :: body_first = 0, body_last = 0
      !> Does something in it make no sense, so that any of its variables may have been meant?
      logical :: is_garbled = .false.
   end type group_t

contains

   !> Find the groups.
   subroutine scan_groups(bare, groups, problems)
      !> Text without comments.
      character(*), intent(in) :: bare
      type(group_t), allocatable, intent(out) :: groups(:)
      type(problems_t), intent(inout) :: problems
      integer :: position, n, i

      n = 0
      do i = 1, len(bare)
         if (bare(i:i) == '&') n = n + 1
      end do
      allocate (groups(n))
      n = 0
      position = 1
      do
         call skip_to_group(bare, position, problems)
         if (position > len(bare)) exit
         n = n + 1
         call read_group_name(bare, position, groups(n))
         groups(n)%index = 1 + count(groups(:n - 1)%name == groups(n)%name)
         if (groups(n)%index > 1 .or. groups(n)%name == repeatable) groups(n)%shown_index = groups(n)%index
         call skip_to_group_end(bare, position, groups(n), problems)
      end do
      groups = groups(:n)
   end subroutine scan_groups

   !> Move to the next group; what stands before it is a problem.
   subroutine skip_to_group(bare, position, problems)
      character(*), intent(in) :: bare
      integer, intent(inout) :: position
      type(problems_t), intent(inout) :: problems
      logical :: is_reported

      is_reported = .false.
      do while (position <= len(bare))
         if (is_group_start(bare, position)) return
         if (.not. (bare(position:position) == ' ' .or. bare(position:position) == newline)) then
            if (.not. is_reported) call report_outside(bare, position, problems)
            is_reported = .true.
         end if
         position = position + 1
      end do
   end subroutine skip_to_group

   !> Report text that belongs to no group.
   subroutine report_outside(bare, position, problems)
      character(*), intent(in) :: bare
      integer, intent(in) :: position
      type(problems_t), intent(inout) :: problems

      call problems%add('', '', 'text outside of any group, given '// &
         show_text(trim(bare(position:end_of_line(bare, position))))// &
         ', allowed: groups &name ... / that start on a line of their own', line=line_at(bare, position))
   end subroutine report_outside

   !> Does a group begin at this position?
   pure logical function is_group_start(bare, position)
      character(*), intent(in) :: bare
      integer, intent(in) :: position
      integer :: line_first

      is_group_start = .false.
      if (bare(position:position) /= '&' .or. position == len(bare)) return
      if (.not. is_letter(bare(position + 1:position + 1))) return
      if (is_group_end(bare, position)) return
      line_first = index(bare(:position), newline, back=.true.) + 1
      is_group_start = verify(bare(line_first:position - 1), ' ') == 0
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
      !> Position of `&`, then the position after the name.
      integer, intent(inout) :: position
      type(group_t), intent(inout) :: group

      group%first = position
      position = position + 1
      do while (position <= len(bare))
         if (.not. is_name_character(bare(position:position))) exit
         position = position + 1
      end do
      group%name = to_lower(bare(group%first + 1:position - 1))
   end subroutine read_group_name

   !> Find the end of a group, and move behind it.
   subroutine skip_to_group_end(bare, position, group, problems)
      character(*), intent(in) :: bare
      integer, intent(inout) :: position
      type(group_t), intent(inout) :: group
      type(problems_t), intent(inout) :: problems
      integer :: last

      group%body_first = position
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
      ! a quote that is not closed is reported with its variable, and takes the / with it
      if (group%is_garbled) return
      call problems%add(trim(group%name), '', 'the / that ends the group is missing', &
         index=group%shown_index, line=line_at(bare, group%first))
   end subroutine skip_to_group_end

end module adfric_input_group_scan

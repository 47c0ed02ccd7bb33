! SPDX-License-Identifier: GPL-3.0-or-later
!> Inputs that somebody has spoiled: letters, words and lines of a good input are deleted, doubled, exchanged and replaced.
module search_mutations
   use random_dice, only: dice_t
   implicit none (type, external)
   private
   public :: mutate

   character(*), parameter :: newline = achar(10)
   !> Most changes of one input.
   integer, parameter :: most_changes = 4
   !> Longest piece that is deleted, doubled or moved.
   integer, parameter :: longest_piece = 40
   !> What is written into an input: everything that means something in one, and what means nothing anywhere.
   character(*), parameter :: words(*) = [character(40) :: '&', '/', '=', '''', '"', '!', ',', '(', ')', '*', '%', '.', '-', &
      '&end', '&sweep', '&job', '&surface /', '3*', '0*', '999999999*', '1000000000*1', '1e308', '1.8e308', '1e-308', '4.9e-324', &
      '-1e400', 'nan', 'inf', '1e', '1d', '.true.', '''''', '""', 'values =', 'from =', 'to =', 'count = 0', 'count = 100000000', &
      'spacing = ''log''', 'variable = ''load''', 'load = 1', 'heights = ''mutation.h5:/none''', '0', '-0.0', '00000', '+1', &
      'model = ''sphere''', 'title = ''t''', 'output = ''-x''', '&units', achar(9), achar(13), achar(13)//newline, newline, &
      achar(0), achar(27)//'[2J', achar(127), char(194)//char(155)//'2J', char(226)//char(128)//char(174), char(255), &
      char(195)//char(164)]

contains

   !> Spoil an input.
   subroutine mutate(text, other, dice, mutated)
      character(*), intent(in) :: text
      !> Another input, of which pieces are taken.
      character(*), intent(in) :: other
      type(dice_t), intent(inout) :: dice
      character(:), allocatable, intent(out) :: mutated
      integer :: k, n

      mutated = text
      call dice%choose(most_changes, n)
      do k = 1, n
         call change(mutated, other, dice)
      end do
   end subroutine mutate

   !> Change one thing.
   subroutine change(text, other, dice)
      character(:), allocatable, intent(inout) :: text
      character(*), intent(in) :: other
      type(dice_t), intent(inout) :: dice
      integer :: kind, first, last, position, word

      call dice%choose(9, kind)
      call choose_piece(text, dice, first, last)
      call dice%choose(len(text) + 1, position)
      call dice%choose(size(words), word)
      select case (kind)
      case (1)
         text = text(:first - 1)//text(last + 1:)
      case (2)
         text = text(:position - 1)//text(first:last)//text(position:)
      case (3, 4)
         text = text(:position - 1)//trim(words(word))//text(position:)
      case (5)
         text = text(:first - 1)//trim(words(word))//text(last + 1:)
      case (6)
         call replace_letter(text, dice)
      case (7)
         call choose_line(text, dice, first, last)
         text = text(:first - 1)//text(last + 1:)
      case (8)
         call choose_line(other, dice, first, last)
         text = text(:position - 1)//other(first:last)//text(position:)
      case (9)
         text = text(:position - 1)
      end select
   end subroutine change

   !> Choose some letters; none of an empty text.
   subroutine choose_piece(text, dice, first, last)
      character(*), intent(in) :: text
      type(dice_t), intent(inout) :: dice
      integer, intent(out) :: first, last
      integer :: length

      call dice%choose(max(1, len(text)), first)
      call dice%choose(longest_piece, length)
      last = min(len(text), first + length - 1)
   end subroutine choose_piece

   !> Choose a line with its end.
   subroutine choose_line(text, dice, first, last)
      character(*), intent(in) :: text
      type(dice_t), intent(inout) :: dice
      integer, intent(out) :: first, last
      integer :: position

      call dice%choose(max(1, len(text)), position)
      position = min(position, len(text))
      first = index(text(:position), newline, back=.true.) + 1
      last = position + index(text(position + 1:)//newline, newline)
      last = min(last, len(text))
   end subroutine choose_line

   !> Replace a letter by any byte.
   subroutine replace_letter(text, dice)
      character(:), allocatable, intent(inout) :: text
      type(dice_t), intent(inout) :: dice
      integer :: position, byte

      call dice%choose(max(1, len(text)), position)
      call dice%choose(256, byte)
      if (position <= len(text)) text(position:position) = char(byte - 1)
   end subroutine replace_letter

end module search_mutations

! SPDX-License-Identifier: GPL-3.0-or-later
!> Inputs of any length that repeat one thing: what costs a reader time where it looks at anything more than a few times.
module search_shapes
   implicit none (type, external)
   private
   public :: shape_t, shapes, text_of_shape

   !> An input: a beginning, a piece that is repeated, and an end. `|` stands for the end of a line, `~` for a blank at the end
   !> of a piece, `#` for a number that counts the repetitions.
   type :: shape_t
      character(80) :: head
      character(60) :: piece
      character(60) :: tail
   end type shape_t

   character(*), parameter :: job = '&job model = "wavy_sliding" /|', swept = job//'&sweep variable = "load", values =~', &
      value = job//'&surface period =~'
   character(*), parameter :: carriage_return = achar(13)

   type(shape_t), parameter :: shapes(*) = [ &
      ! texts, names and numbers without end
      shape_t('&job title = "', 'x', '" /'), shape_t('&job model = "', 'x', '" /'), shape_t('&job output = "', 'x', '" /'), &
      shape_t('&', 'x', ' /'), shape_t(job//'&surface', 'x', ' = 1 /'), shape_t(value, '1', ' /'), &
      shape_t(job//'&sweep variable = "', 'v', '", values = 1 /'), shape_t(job//'&surface kind = "', 'wave_', '" /'), &
      ! groups, variables and sweeps without end
      shape_t(job, '&a# /|', ''), shape_t('', '&a# /|', ''), shape_t(job, '&surface /|', ''), shape_t(job, '&a#|', ''), &
      shape_t(job//'&surface|', 'a# = 1|', '/'), shape_t(job//'&surface|', 'period = 1|', '/'), &
      shape_t(job//'&unknown|', 'a# = 1|', '/'), shape_t(job, '&sweep /|', ''), &
      shape_t(job, '&sweep variable = "load", values = # /|', ''), shape_t(job, '&sweep variable = "a#", values = # /|', ''), &
      ! values without end
      shape_t(swept, '1~', '/'), shape_t(swept, '-1.234567890123456e-01,~', '0 /'), shape_t(swept, '1 ! comment|', '/'), &
      shape_t(swept, '1 x~', '/'), shape_t(swept, '2*1,', ' 1 /'), shape_t(value, '1,~', '2 /'), &
      ! comments, blanks and line ends
      shape_t('', '! a comment|', ''), shape_t('', '!', ''), shape_t('', '|', ''), shape_t('', carriage_return, ''), &
      shape_t('', carriage_return//'|', ''), shape_t('', achar(9), ''), shape_t('', '~', ''), shape_t('', '~&a', ''), &
      shape_t(value, '|', ' /'), shape_t(swept, '|', ' /'), &
      ! signs
      shape_t('', '&', ''), shape_t('', '&a', ''), shape_t('', '&a|', ''), shape_t('', '&end~', ''), shape_t(value, '&a~', ' /'), &
      shape_t('', '''', ''), shape_t('', '"''', ''), shape_t(value, '''', ' /'), shape_t(value, '"''', ' /'), &
      shape_t(value, '"~', ' /'), shape_t(job//'&surface~', 'a = "|', ' /'), shape_t('&job title = ''', '''''', ''' /'), &
      shape_t('', ',', ''), shape_t(value, ',', ' /'), shape_t(swept, ',', ' /'), &
      shape_t('', '=', ''), shape_t(value, '=', ' /'), shape_t(job//'&surface~', '=,', ' /'), &
      shape_t(job//'&surface~', 'a=', ' /'), shape_t(job//'&surface~', 'a(1) = 1~', ' /'), &
      shape_t(job//'&surface~', ')=', ' /'), shape_t(job//'&surface~', '(', ' /'), &
      shape_t('', '/', ''), shape_t(value, '/', ' /'), &
      shape_t(value, '*', ' /'), shape_t(job//'&sweep variable = "', '%', '", values = 1 /'), &
      shape_t('', achar(0), ''), shape_t(value, achar(0), ' /')]

contains

   !> The input.
   function text_of_shape(shape, length) result(text)
      type(shape_t), intent(in) :: shape
      !> Letters of the repeated part.
      integer, intent(in) :: length
      character(:), allocatable :: text
      integer :: i, repetition

      allocate (character(length + len(shape%head) + 2*len(shape%piece) + len(shape%tail)) :: text)
      i = 0
      call append(trim(shape%head), 0, text, i)
      repetition = 0
      do while (i < length)
         repetition = repetition + 1
         call append(trim(shape%piece), repetition, text, i)
      end do
      call append(trim(shape%tail), 0, text, i)
      text = text(:i)
   end function text_of_shape

   !> Append a piece.
   subroutine append(piece, repetition, text, i)
      character(*), intent(in) :: piece
      !> What stands for `#`.
      integer, intent(in) :: repetition
      character(*), intent(inout) :: text
      !> Length so far.
      integer, intent(inout) :: i
      character(12) :: number
      integer :: k

      do k = 1, len(piece)
         select case (piece(k:k))
         case ('#')
            write (number, '(i0)') repetition
            text(i + 1:i + len_trim(number)) = trim(number)
            i = i + len_trim(number)
         case default
            i = i + 1
            text(i:i) = piece(k:k)
            if (piece(k:k) == '|') text(i:i) = achar(10)
            if (piece(k:k) == '~') text(i:i) = ' '
         end select
      end do
   end subroutine append

end module search_shapes

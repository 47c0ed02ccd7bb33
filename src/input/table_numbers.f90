! SPDX-License-Identifier: GPL-3.0-or-later
!> Numbers in the cells of a table of text, and the mark that is decimal in them.
module adfric_input_table_numbers
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_text, only: show_number, show_text, to_lower
   use adfric_input_literal, only: convert
   use adfric_input_table_cells, only: begin_cells, cell_t, end_of_text_line, find_next_line, is_comment, next_cell
   implicit none (type, external)
   private
   public :: is_number_form, is_missing, is_numeral, has_numbers_alone, convert_cell, find_decimal_mark

   !> No number of physics is larger.
   real(dp), parameter :: largest = 1.0e60_dp
   character(*), parameter :: digits = '0123456789'

contains

   !> Is a word a number, with one decimal mark at most?
   pure logical function is_number_form(word)
      !> The word without blanks around it.
      character(*), intent(in) :: word
      integer :: i, n_digits
      logical :: has_mark

      is_number_form = .false.
      has_mark = .false.
      n_digits = 0
      do i = merge(2, 1, scan(word(:min(1, len(word))), '+-') == 1), len(word)
         select case (word(i:i))
         case ('0':'9')
            n_digits = n_digits + 1
         case ('.', ',')
            if (has_mark) return
            ! a comma stands between digits, so that it can be told from one that separates
            if (word(i:i) == ',' .and. n_digits == 0) return
            has_mark = .true.
         case default
            exit
         end select
      end do
      if (n_digits == 0) return
      if (word(i - 1:i - 1) == ',') return
      is_number_form = i > len(word)
      if (is_number_form .or. scan(word(i:min(i, len(word))), 'eEdD') == 0) return
      i = i + 1
      if (scan(word(i:min(i, len(word))), '+-') == 1) i = i + 1
      is_number_form = i <= len(word) .and. verify(word(i:), '0123456789') == 0
   end function is_number_form

   !> Is a cell without a value?
   pure logical function is_missing(word)
      !> Text of the cell without blanks around it.
      character(*), intent(in) :: word

      is_missing = len(word) == 0
      if (is_missing .or. len(word) > 7) return
      select case (to_lower(word))
      case ('nan', '+nan', '-nan', 'na', 'n/a', 'null', 'none', 'missing', '-', '--')
         is_missing = .true.
      end select
   end function is_missing

   !> Does a word look like a number, with any decimal marks between its digits?
   pure logical function is_numeral(word)
      character(*), intent(in) :: word

      is_numeral = .false.
      if (verify(word, digits//'.,+-eEdD') > 0 .or. scan(word, digits) == 0) return
      is_numeral = scan(word(1:1), digits//'.+-') == 1 .and. scan(word(len(word):), digits//'.') == 1 &
         .and. index(word, '+,') == 0 .and. index(word, '-,') == 0
   end function is_numeral

   !> Has a line numbers, and nothing else but words for no value, whatever separates them?
   pure logical function has_numbers_alone(line)
      character(*), intent(in) :: line
      character(*), parameter :: between = ' ,;"'//achar(9)//achar(13)
      integer :: first, length

      has_numbers_alone = .false.
      first = verify(line, between)
      do while (first > 0)
         length = scan(line(first:), between) - 1
         if (length < 0) length = len(line) - first + 1
         if (is_number_form(line(first:first + length - 1))) then
            has_numbers_alone = .true.
         else if (.not. is_missing(line(first:first + length - 1))) then
            has_numbers_alone = .false.
            return
         end if
         first = first + length
         length = verify(line(first:), between)
         first = merge(0, first + length - 1, length == 0)
      end do
   end function has_numbers_alone

   !> A number from a cell.
   pure subroutine convert_cell(word, has_decimal_comma, separator, value, flaw)
      character(*), intent(in) :: word
      logical, intent(in) :: has_decimal_comma
      !> What separates the columns.
      character, intent(in) :: separator
      !> Receives the number, NaN where there is none.
      real(dp), intent(out) :: value
      character(:), allocatable, intent(out) :: flaw
      character(len(word)) :: plain
      integer :: comma

      flaw = ''
      value = not_a_number()
      if (is_missing(word)) return
      plain = word
      comma = index(word, ',')
      if (comma > 0 .and. is_numeral(word)) then
         if (separator == ',') then
            flaw = 'a comma in a number where commas separate columns, which may be decimal or part thousands'
         else if (index(word, '.') > 0 .or. index(word, ',', back=.true.) > comma .or. .not. has_decimal_comma) then
            flaw = 'thousands are parted'
         end if
         plain(comma:comma) = '.'
      else if (has_decimal_comma .and. index(word, '.') > 0 .and. is_numeral(word)) then
         flaw = 'thousands are parted'
      end if
      if (len(flaw) > 0) then
         flaw = flaw//', given '//show_text(word)
         return
      end if
      call convert(plain, value, flaw)
      if (len(flaw) > 0 .and. comma > 0) call convert(word, value, flaw)
      if (len(flaw) == 0 .and. abs(value) > largest) flaw = 'out of range, given '//show_number(value)
   end subroutine convert_cell

   !> Find the decimal mark: the one that the numbers of the rows have, which is the same in all.
   pure subroutine find_decimal_mark(text, rows_at, separator, is_comma, flaw, entry)
      character(*), intent(in) :: text
      !> Position of the first line of the rows.
      integer, intent(in) :: rows_at
      character, intent(in) :: separator
      !> Receives whether the mark is a comma.
      logical, intent(out) :: is_comma
      character(:), allocatable, intent(out) :: flaw
      !> Position in the text of what is wrong, from 1.
      integer, intent(inout) :: entry
      type(cell_t) :: cell
      integer :: first, last, with_comma, with_point
      logical :: is_shown

      flaw = ''
      is_comma = .false.
      if (separator == ',' .or. rows_at > len(text)) return
      if (index(text(rows_at:), ',') == 0) return
      with_comma = 0
      with_point = 0
      is_shown = separator == ';'
      call find_next_line(text, rows_at, first, last)
      do while (first > 0)
         cell = begin_cells(first)
         if (is_comment(text(first:last))) cell%next = 0
         do while (cell%next > 0)
            call next_cell(text, last, separator, cell)
            if (.not. is_number_form(text(cell%first:cell%last))) cycle
            if (index(text(cell%first:cell%last), '.') > 0) then
               if (with_point == 0) with_point = cell%first
            else if (index(text(cell%first:cell%last), ',') > 0) then
               if (with_comma == 0) with_comma = cell%first
               is_shown = is_shown .or. .not. may_part_thousands(text(cell%first:cell%last))
            end if
         end do
         call find_next_line(text, last + 2, first, last)
      end do
      is_comma = with_comma > 0
      if (.not. is_comma) return
      if (with_point > 0) then
         entry = max(with_comma, with_point)
         flaw = 'numbers with points and numbers with commas, given '//word_at(min(with_comma, with_point))//' and '// &
            word_at(entry)//', allowed: one decimal mark'
      else if (.not. is_shown) then
         entry = with_comma
         flaw = 'every comma stands before three digits and may be decimal or part thousands, given '//word_at(entry)// &
            ', allowed: one number at least, as 1,25 or 0,125, that shows which; or columns between semicolons'
      end if

   contains

      !> The word at a position.
      pure function word_at(position) result(word)
         integer, intent(in) :: position
         character(:), allocatable :: word

         word = text(position:end_of_text_line(text, position))
         word = show_text(word(:verify(word//' ', digits//'.,+-eEdD') - 1))
      end function word_at

   end subroutine find_decimal_mark

   !> May a number with one comma be one whose thousands are parted?
   pure logical function may_part_thousands(word)
      !> A number with a comma.
      character(*), intent(in) :: word
      integer :: comma, first

      comma = index(word, ',')
      first = merge(2, 1, scan(word(1:1), '+-') == 1)
      may_part_thousands = comma - first <= 3 .and. word(first:first) /= '0' .and. len(word) == comma + 3
      if (may_part_thousands) may_part_thousands = verify(word(comma + 1:), digits) == 0
   end function may_part_thousands

end module adfric_input_table_numbers

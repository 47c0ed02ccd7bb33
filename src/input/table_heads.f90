! SPDX-License-Identifier: GPL-3.0-or-later
!> The heads of the columns of a table of text: names, each with a unit or without, and how a column is found by its name.
module adfric_input_table_heads
   use adfric_base_text, only: show_count, show_text, to_lower
   use adfric_input_head_unit, only: add_unit, head_t, is_unit_like, split_head
   use adfric_input_suggestion, only: find_nearest
   use adfric_input_table_cells, only: begin_cells, cell_t, count_cells, next_cell, tab, text_of_cell
   use adfric_input_table_numbers, only: is_number_form
   implicit none (type, external)
   private
   public :: heads_t, read_heads, set_heads

   !> Stands for a blank within a name where names are separated by blanks.
   character, parameter :: inner_blank = achar(31)
   !> Names that a message lists at most.
   integer, parameter :: most_listed = 12
   !> Names that are compared at most with one that is not known.
   integer, parameter :: most_compared = 1000
   !> What stands in quotes alone where columns are not told apart by it.
   character(*), parameter :: reserved = tab//';,'

   !> A column.
   type :: head_column_t
      !> Its head without quotes.
      character(:), allocatable :: text
      !> The same in small letters, with underscores for blanks and hyphens.
      character(:), allocatable :: key
      !> Its unit in the line of units; empty where there is none.
      character(:), allocatable :: unit
   end type head_column_t

   !> All columns.
   type :: heads_t
      !> The columns in their order.
      type(head_column_t), allocatable :: columns(:)
   contains
      procedure :: n_columns
      procedure :: are_units
      procedure :: has_letters
      procedure :: take_units
      procedure :: find
      procedure :: get
      procedure :: list_names
      procedure :: say_unknown
   end type heads_t

contains

   !> Read a line as the heads of columns: names for all numbers, or units.
   pure subroutine read_heads(text, first, last, separator, n_least, n_most, self, is_right)
      character(*), intent(in) :: text
      !> Positions of the first and the last character of the line.
      integer, intent(in) :: first, last
      character, intent(in) :: separator
      !> Columns that have a number, and those that there are at most.
      integer, intent(in) :: n_least, n_most
      !> Receives the heads, without empty ones at the end.
      type(heads_t), intent(out) :: self
      !> False if there are too few or too many, if one is a number, or if its quotes are wrong.
      logical, intent(out) :: is_right
      type(heads_t) :: words

      call split_line(text(first:last), separator, n_most, self, is_right)
      if (.not. is_right) return
      if (separator == ' ') then
         words = self
         call join_units(words, self)
         if (.not. is_number_right(self)) self = words
         if (.not. is_number_right(self)) call split_line(with_tabs(text(first:last)), tab, n_most, self, is_right)
      end if
      is_right = is_right .and. is_number_right(self)

   contains

      !> Are there so many heads, or units?
      pure logical function is_number_right(heads)
         type(heads_t), intent(in) :: heads

         is_number_right = heads%n_columns() >= n_least .and. heads%n_columns() <= n_most
         if (.not. is_number_right .and. heads%n_columns() < n_least) is_number_right = heads%are_units()
      end function is_number_right

   end subroutine read_heads

   !> Heads that somebody has, without a line of text.
   pure subroutine set_heads(self, names, units)
      type(heads_t), intent(out) :: self
      !> The heads, with a unit or without; blanks at their ends do not count.
      character(*), intent(in) :: names(:)
      !> Units from elsewhere, empty where there is none; shape of the names.
      character(*), intent(in) :: units(:)
      integer :: k

      allocate (self%columns(size(names)))
      do k = 1, size(names)
         call set_text(self%columns(k), trim(adjustl(names(k))))
         self%columns(k)%unit = trim(adjustl(units(k)))
      end do
   end subroutine set_heads

   !> Split a line into heads.
   pure subroutine split_line(line, separator, n_most, self, is_right)
      character(*), intent(in) :: line
      character, intent(in) :: separator
      !> Columns that there are at most.
      integer, intent(in) :: n_most
      type(heads_t), intent(out) :: self
      !> False if there is none, if one is a number, or if its quotes are wrong.
      logical, intent(out) :: is_right
      type(cell_t) :: cell
      integer :: k, n_cells, n_filled

      call count_cells(line, 1, len(line), separator, n_cells, n_filled, is_right)
      is_right = .not. is_right .and. n_filled > 0
      allocate (self%columns(n_filled))
      cell = begin_cells(1)
      do k = 1, n_filled
         call next_cell(line, len(line), separator, cell)
         call set_text(self%columns(k), text_of_cell(line, cell))
         if (cell%is_quoted) cycle
         if (is_number_form(self%columns(k)%text)) is_right = .false.
         if ((n_most == 1 .or. separator == ' ') .and. scan(self%columns(k)%text, reserved) > 0) is_right = .false.
      end do
   end subroutine split_line

   !> Join words to heads: a unit belongs to the name before it, as in `load [nN]`, `load / nN` and `load in nN`.
   pure subroutine join_units(words, heads)
      type(heads_t), intent(in) :: words
      type(heads_t), intent(out) :: heads
      character(:), allocatable :: text
      integer :: k, n
      logical :: is_next

      allocate (heads%columns(words%n_columns()))
      n = 0
      text = ''
      do k = 1, words%n_columns()
         is_next = len(text) > 0
         if (is_next) is_next = .not. belongs_together(text, words%columns(k)%text)
         if (is_next) then
            n = n + 1
            call set_text(heads%columns(n), text)
            text = ''
         end if
         text = trim(adjustl(text//' '//words%columns(k)%text))
      end do
      n = n + 1
      call set_text(heads%columns(n), text)
      heads%columns = heads%columns(:n)
   end subroutine join_units

   !> Does a word belong to the head before it?
   pure logical function belongs_together(text, word)
      !> The head so far.
      character(*), intent(in) :: text
      character(*), intent(in) :: word

      belongs_together = scan(word(:min(1, len(word))), '([{/') == 1 .or. text(len(text):) == '/' .or. to_lower(word) == 'in'
      if (belongs_together) return
      belongs_together = index(to_lower(text), ' in', back=.true.) == len(text) - 2 .and. len(text) > 3
      if (belongs_together) return
      ! a bracket that is open
      belongs_together = scan(text, '([{', back=.true.) > scan(text, ')]}', back=.true.)
   end function belongs_together

   !> A line with a tab for each gap of two blanks or more.
   pure function with_tabs(line) result(changed)
      character(*), intent(in) :: line
      character(:), allocatable :: changed
      integer :: i, n

      changed = trim(adjustl(line))
      n = 0
      i = 1
      do while (i <= len(changed))
         n = n + 1
         changed(n:n) = changed(i:i)
         associate (gap => verify(changed(i:), ' '//tab) - 1)
            if (gap > 1) changed(n:n) = tab
            i = i + max(1, gap)
         end associate
      end do
      changed = changed(:n)
   end function with_tabs

   !> Set the head of a column.
   pure subroutine set_text(self, text)
      !> Receives the head; it has no unit from elsewhere.
      type(head_column_t), intent(out) :: self
      !> The head without quotes.
      character(*), intent(in) :: text

      self%text = text
      self%key = key_of(text)
      self%unit = ''
   end subroutine set_text

   !> What is compared of a name: capitals do not count, and blanks, hyphens and underscores are alike.
   pure function key_of(name) result(key)
      character(*), intent(in) :: name
      character(len(name)) :: key
      integer :: i

      key = to_lower(name)
      do i = 1, len(key)
         if (scan(key(i:i), ' -') == 1) key(i:i) = '_'
      end do
   end function key_of

   !> Number of columns.
   elemental integer function n_columns(self)
      class(heads_t), intent(in) :: self

      n_columns = size(self%columns)
   end function n_columns

   !> Are all heads units, in brackets or not, so that they are those of the names above?
   pure logical function are_units(self)
      class(heads_t), intent(in) :: self
      integer :: k

      are_units = .true.
      do k = 1, self%n_columns()
         are_units = len(self%columns(k)%text) == 0
         if (.not. are_units) are_units = is_unit_like(bare_unit(self%columns(k)%text))
         if (.not. are_units) return
      end do
   end function are_units

   !> Is there a head that is more than a sign, such as the hyphen of a pure number?
   pure logical function has_letters(self)
      class(heads_t), intent(in) :: self
      integer :: k

      has_letters = .false.
      do k = 1, self%n_columns()
         has_letters = has_letters .or. verify(self%columns(k)%text, '-1[](){} ') > 0
      end do
   end function has_letters

   !> A unit without the brackets around it.
   pure function bare_unit(text) result(unit)
      !> The unit, in brackets or not.
      character(*), intent(in) :: text
      character(:), allocatable :: unit

      unit = text
      if (len(text) < 2) return
      if (index('([{', text(1:1)) > 0 .and. index('([{', text(1:1)) == index(')]}', text(len(text):))) &
         unit = trim(adjustl(text(2:len(text) - 1)))
   end function bare_unit

   !> Take the units of the line below.
   pure subroutine take_units(self, units)
      class(heads_t), intent(inout) :: self
      class(heads_t), intent(in) :: units
      integer :: k

      do k = 1, min(self%n_columns(), units%n_columns())
         self%columns(k)%unit = bare_unit(units%columns(k)%text)
      end do
   end subroutine take_units

   !> The head of a column, taken apart.
   pure subroutine get(self, position, head)
      class(heads_t), intent(in) :: self
      !> Which column, from 1.
      integer, intent(in) :: position
      !> Receives name and unit, and what is wrong with them.
      type(head_t), intent(out) :: head

      call split_head(self%columns(position)%text, head)
      call add_unit(head, self%columns(position)%unit)
   end subroutine get

   !> Find a column by its name or by its whole head. The same letters go before letters that are alike.
   pure subroutine find(self, name, position, other)
      class(heads_t), intent(in) :: self
      character(*), intent(in) :: name
      !> Receives the index of the column, from 1; 0 if there is none.
      integer, intent(out) :: position
      !> Receives the index of another column that fits as well; 0 if there is none.
      integer, intent(out) :: other
      type(head_t) :: head
      character(len(name)) :: key
      integer :: k
      logical :: is_same, is_exact, is_like

      position = 0
      other = 0
      is_exact = .false.
      key = key_of(name)
      if (len(name) == 0) return
      do k = 1, self%n_columns()
         if (len(self%columns(k)%key) < len(key)) cycle
         if (self%columns(k)%key(:len(key)) /= key) cycle
         call self%get(k, head)
         is_same = head%text == name .or. head%name == name
         is_like = self%columns(k)%key == key .or. key_of(head%name) == key
         if (is_same .and. .not. is_exact) then
            position = k
            other = 0
            is_exact = .true.
         else if (is_same .or. (is_like .and. .not. is_exact)) then
            if (position > 0) other = k
            if (position == 0) position = k
         end if
      end do
   end subroutine find

   !> The names of the first columns, and how many there are more.
   pure function list_names(self) result(text)
      class(heads_t), intent(in) :: self
      character(:), allocatable :: text
      type(head_t) :: head
      integer :: k

      text = ''
      do k = 1, min(most_listed, self%n_columns())
         call self%get(k, head)
         if (k > 1) text = text//', '
         text = text//show_text(head%name)
      end do
      if (self%n_columns() > most_listed) text = text//' and '//show_count(self%n_columns() - most_listed)//' more'
   end function list_names

   !> What to say of a column that is not there.
   pure function say_unknown(self, name) result(text)
      class(heads_t), intent(in) :: self
      !> The name that is not known.
      character(*), intent(in) :: name
      character(:), allocatable :: text, known, near
      type(head_t) :: head
      integer :: k

      text = 'unknown column, given '//show_text(name)//', allowed: '//self%list_names()
      known = ''
      do k = 1, min(most_compared, self%n_columns())
         call self%get(k, head)
         known = known//' '//exchange(head%name, ' ', inner_blank)
      end do
      near = find_nearest(exchange(name, ' ', inner_blank), known)
      if (len(near) > 0) text = text//'; did you mean '//show_text(exchange(near, inner_blank, ' '))//'?'
   end function say_unknown

   !> A text with one character in the index of another.
   pure function exchange(text, old, new) result(changed)
      !> Any text.
      character(*), intent(in) :: text
      !> The character that is replaced, and the one that takes its place.
      character, intent(in) :: old, new
      character(len(text)) :: changed
      integer :: i

      changed = text
      do i = 1, len(text)
         if (text(i:i) == old) changed(i:i) = new
      end do
   end function exchange

end module adfric_input_table_heads

! SPDX-License-Identifier: GPL-3.0-or-later
!> The values of the groups that an input of `adfric fit` has beside those of its model.
module adfric_input_fit_values
   use adfric_base_kinds, only: dp
   use adfric_base_text, only: show_text
   use adfric_input_fit_rows, only: find_fit_row, list_fit_names
   use adfric_input_group_values, only: take_text
   use adfric_input_item, only: item_t, next_item
   use adfric_input_literal, only: convert
   use adfric_input_namelist_file, only: namelist_file_t
   use adfric_input_number_list, only: read_list
   use adfric_input_reading, only: reading_t
   use adfric_input_variable, only: describe_allowed, find_outlier, read_variable
   use adfric_input_vocabulary, only: report_unknown_names
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: reader_t, new_reader

   !> Most numbers of a list.
   integer, parameter :: most_numbers = 20

   !> Reads the values of one group.
   type :: reader_t
      !> Number of the group in the file, from 1.
      integer :: group = 0
      !> Name of the group, without `&`.
      character(:), allocatable :: name
      !> Rows of all groups of a fit.
      type(variable_t), allocatable :: rows(:)
   contains
      procedure :: has
      procedure :: read_number
      procedure :: read_whole
      procedure :: read_numbers
      procedure :: read_text
      procedure :: read_texts
      procedure :: report
      procedure :: report_missing
   end type reader_t

contains

   !> Begin with a group: names that it does not have are reported.
   subroutine new_reader(self, r, group, rows)
      type(reader_t), intent(out) :: self
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      type(variable_t), intent(in) :: rows(:)

      self%group = group
      self%name = trim(r%file%groups(group)%name)
      self%rows = rows
      call report_unknown_names(r, group, list_fit_names(rows, self%name))
   end subroutine new_reader

   !> Is a variable given?
   logical function has(self, file, name)
      class(reader_t), intent(in) :: self
      type(namelist_file_t), intent(in) :: file
      character(*), intent(in) :: name

      has = file%find_assignment(self%group, name) > 0
   end function has

   !> Read a number, or a choice as its index; the default where it is not given, or wrong.
   subroutine read_number(self, r, name, value)
      class(reader_t), intent(in) :: self
      type(reading_t), intent(in) :: r
      character(*), intent(in) :: name
      !> Receives the number.
      real(dp), intent(out) :: value
      character(:), allocatable :: flaw
      integer :: number, entry

      associate (row => self%rows(find_fit_row(self%rows, self%name, name)))
         value = row%default
         number = r%file%find_assignment(self%group, name)
         if (number == 0) return
         call read_variable(r%file%value_of(number), row, value, flaw, entry)
         if (len(flaw) > 0) call r%report(self%group, name, flaw, entry)
      end associate
   end subroutine read_number

   !> Read a whole number, or a choice as its index.
   subroutine read_whole(self, r, name, value)
      class(reader_t), intent(in) :: self
      type(reading_t), intent(in) :: r
      !> Name of the variable, which has a default.
      character(*), intent(in) :: name
      !> Receives the number.
      integer, intent(out) :: value
      real(dp) :: number

      call self%read_number(r, name, number)
      value = nint(number)
   end subroutine read_whole

   !> Read a list of numbers.
   subroutine read_numbers(self, r, name, values)
      class(reader_t), intent(in) :: self
      type(reading_t), intent(in) :: r
      character(*), intent(in) :: name
      !> In: the default. Out: the numbers that are given.
      real(dp), allocatable, intent(inout) :: values(:)
      real(dp), allocatable :: given(:)
      character(:), allocatable :: flaw
      integer :: number, entry, first

      number = r%file%find_assignment(self%group, name)
      if (number == 0) return
      associate (row => self%rows(find_fit_row(self%rows, self%name, name)))
         call read_list(r%file%value_of(number), given, flaw, entry, most_numbers)
         if (len(flaw) > 0) flaw = flaw//', allowed: '//describe_allowed(row)
         if (len(flaw) == 0) call find_outlier(given, row, first, flaw)
      end associate
      if (len(flaw) > 0) then
         call r%report(self%group, name, flaw)
      else
         values = given
      end if
   end subroutine read_numbers

   !> Read a text.
   subroutine read_text(self, r, name, text)
      class(reader_t), intent(in) :: self
      type(reading_t), intent(in) :: r
      character(*), intent(in) :: name
      !> Receives the text; not allocated where none is given, or something is wrong.
      character(:), allocatable, intent(out) :: text

      call take_text(r, self%group, name, 'a text in quotes', text)
   end subroutine read_text

   !> Read several words.
   subroutine read_texts(self, r, name, words)
      class(reader_t), intent(in) :: self
      type(reading_t), intent(in) :: r
      character(*), intent(in) :: name
      !> Receives the words, separated by a blank; empty where none is given, or something is wrong.
      character(:), allocatable, intent(out) :: words
      type(item_t) :: item
      character(:), allocatable :: text, word, flaw
      integer :: number, position

      words = ''
      number = r%file%find_assignment(self%group, name)
      if (number == 0) return
      text = r%file%value_of(number)
      position = 1
      do
         call next_item(text, position, item, flaw)
         if (item%first == 0 .and. len(flaw) == 0) exit
         if (len(flaw) == 0) call convert(text(item%first:item%last), word, flaw)
         if (len(flaw) == 0) then
            if (len_trim(word) == 0 .or. index(trim(word), ' ') > 0) flaw = 'not a word, given '''//show_text(word)//''''
         end if
         if (len(flaw) > 0) then
            call r%report(self%group, name, flaw//', allowed: words in quotes')
            words = ''
            return
         end if
         words = trim(adjustl(words//' '//word))
      end do
   end subroutine read_texts

   !> Add a problem of a variable of the group.
   subroutine report(self, r, name, text)
      class(reader_t), intent(in) :: self
      type(reading_t), intent(in) :: r
      !> Name of the variable; empty for the group.
      character(*), intent(in) :: name
      character(*), intent(in) :: text

      call r%report(self%group, name, text)
   end subroutine report

   !> Report that a variable is not given, unless something in the group made no sense.
   subroutine report_missing(self, r, name)
      class(reader_t), intent(in) :: self
      type(reading_t), intent(in) :: r
      character(*), intent(in) :: name

      if (r%file%groups(self%group)%is_garbled .or. self%has(r%file, name)) return
      associate (row => self%rows(find_fit_row(self%rows, self%name, name)))
         call r%report(self%group, name, 'not given, needed: '//row%meaning//', '//describe_allowed(row))
      end associate
   end subroutine report_missing

end module adfric_input_fit_values

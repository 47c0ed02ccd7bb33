! SPDX-License-Identifier: GPL-3.0-or-later
!> Entries of a page of help: what several models say in the same words stands there once, with the names of all of them.
module adfric_command_help_entries
   use adfric_base_words, only: count_words, get_word, pad, has_word
   use adfric_base_text, only: newline, join_words
   implicit none (type, external)
   private
   public :: entries_t

   !> What is said, and by whom.
   type :: help_entry_t
      !> What is said; one line of a table, or a page.
      character(:), allocatable :: text
      !> Names of those who say it, separated by a blank.
      character(:), allocatable :: owners
   end type help_entry_t

   !> Entries in the order in which they came.
   type :: entries_t
      !> The entries, with space for more.
      type(help_entry_t), allocatable, private :: items(:)
      !> Number of entries.
      integer, private :: n = 0
   contains
      procedure :: add
      procedure :: count => count_entries
      procedure :: show_table
      procedure :: show_pages
      procedure, private :: index_of
   end type entries_t

contains

   !> Add an entry; of one that is there already the owner alone.
   pure subroutine add(self, text, owner)
      !> The entries, to which the text or its owner is added.
      class(entries_t), intent(inout) :: self
      !> What is said; nothing is added if it is empty.
      character(*), intent(in) :: text
      !> Name of who says it, a word.
      character(*), intent(in) :: owner
      integer :: i

      if (len(text) == 0) return
      i = self%index_of(text)
      if (i == 0) then
         call make_space(self)
         self%n = self%n + 1
         self%items(self%n)%text = text
         self%items(self%n)%owners = owner
      else if (.not. has_word(self%items(i)%owners, owner)) then
         self%items(i)%owners = self%items(i)%owners//' '//owner
      end if
   end subroutine add

   !> Space for one more.
   pure subroutine make_space(self)
      !> The entries, which have space for at least one more afterwards.
      type(entries_t), intent(inout) :: self
      integer, parameter :: first_size = 16
      type(help_entry_t), allocatable :: larger(:)
      integer :: i

      if (.not. allocated(self%items)) allocate (self%items(first_size))
      if (self%n < size(self%items)) return
      allocate (larger(2*self%n))
      do i = 1, self%n
         call move_alloc(self%items(i)%text, larger(i)%text)
         call move_alloc(self%items(i)%owners, larger(i)%owners)
      end do
      call move_alloc(larger, self%items)
   end subroutine make_space

   !> Index of an entry; 0 if there is none.
   pure integer function index_of(self, text)
      class(entries_t), intent(in) :: self
      !> Text of the entry, compared as a whole.
      character(*), intent(in) :: text

      do index_of = self%n, 1, -1
         if (self%items(index_of)%text == text) return
      end do
   end function index_of

   !> Number of entries.
   pure integer function count_entries(self)
      class(entries_t), intent(in) :: self

      count_entries = self%n
   end function count_entries

   !> A line for each, with its owners behind it; long lists go on below.
   pure function show_table(self, width, is_sorted) result(lines)
      class(entries_t), intent(in) :: self
      !> Width of the first column [letters].
      integer, intent(in) :: width
      !> Do the entries stand by the alphabet, instead of in the order in which they came?
      logical, intent(in) :: is_sorted
      character(:), allocatable :: lines
      integer :: order(self%n), i

      order = [(i, i=1, self%n)]
      if (is_sorted) order = sorted(self)
      lines = ''
      do i = 1, self%n
         associate (item => self%items(order(i)))
            lines = lines//pad('  '//item%text, width)//wrap(item%owners, width)//newline
         end associate
      end do
   end function show_table

   !> Words with commas between them, on lines that are not too long.
   pure function wrap(list, indent) result(text)
      !> Words, separated by a blank.
      character(*), intent(in) :: list
      !> Number of letters before the list on its first line, and of blanks before it on the others.
      integer, intent(in) :: indent
      character(:), allocatable :: text
      integer, parameter :: most_columns = 110
      character(:), allocatable :: word
      integer :: k, column

      text = get_word(list, 1)
      column = indent + len(text)
      do k = 2, count_words(list)
         word = get_word(list, k)
         text = text//','
         if (column + len(word) + 2 > most_columns) then
            text = text//newline//repeat(' ', indent - 1)
            column = indent - 2
         end if
         text = text//' '//word
         column = column + len(word) + 2
      end do
   end function wrap

   !> Indices of the entries by the alphabet: each is put behind those that come before it.
   pure function sorted(self) result(order)
      type(entries_t), intent(in) :: self
      integer :: order(self%n), i, k

      do i = 1, self%n
         do k = i - 1, 1, -1
            if (llt(self%items(order(k))%text, self%items(i)%text)) exit
            order(k + 1) = order(k)
         end do
         order(k + 1) = i
      end do
   end function sorted

   !> Every entry, after a line that names its owners; a blank line between them.
   pure function show_pages(self) result(lines)
      class(entries_t), intent(in) :: self
      character(:), allocatable :: lines
      integer :: i

      lines = ''
      do i = 1, self%n
         if (i > 1) lines = lines//newline
         lines = lines//'model = '//wrap(''''//join_words(self%items(i)%owners, ''' ''')//'''', len('model = '))//newline &
            & //self%items(i)%text
      end do
   end function show_pages

end module adfric_command_help_entries

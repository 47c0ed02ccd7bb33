! SPDX-License-Identifier: GPL-3.0-or-later
!> A list of datasets for a results file, which grows.
module adfric_fit_extra_list
   use adfric_base_kinds, only: dp
   use adfric_base_words, only: count_words, get_word
   use adfric_describe_table, only: extra_t
   implicit none (type, external)
   private
   public :: extra_list_t

   !> Datasets that there is space for at first.
   integer, parameter :: first_space = 64

   !> The list.
   type :: extra_list_t
      private
      !> The datasets, with space for more.
      type(extra_t), allocatable :: items(:)
      !> Number of datasets.
      integer :: n = 0
   contains
      procedure :: add
      procedure :: add_table
      procedure :: add_scale
      procedure :: add_numbers
      procedure :: add_words
      procedure :: move_to
   end type extra_list_t

contains

   !> Add a dataset of numbers.
   subroutine add(self, name, unit, long_name, dimensions, values, flag_meanings, first_flag)
      class(extra_list_t), intent(inout) :: self
      character(*), intent(in) :: name
      !> SI unit, `-` for a pure number.
      character(*), intent(in) :: unit
      character(*), intent(in) :: long_name
      !> Names of its scales, the slowest first, separated by a blank; they stand in the list already. Empty for a scalar.
      character(*), intent(in) :: dimensions
      !> Values, the last dimension fastest.
      real(dp), intent(in) :: values(:)
      !> Meanings of its states, separated by a blank; not present: it has numbers.
      character(*), intent(in), optional :: flag_meanings
      !> The state that the first of these meanings is of; not present: 0.
      integer, intent(in), optional :: first_flag
      integer :: k

      call make_space(self)
      associate (item => self%items(self%n))
         item%name = name
         item%unit = unit
         item%long_name = long_name
         item%dimensions = dimensions
         allocate (item%counts(count_words(dimensions)))
         do k = 1, size(item%counts)
            item%counts(k) = length_of(self, get_word(dimensions, k))
         end do
         item%values = values
         if (present(flag_meanings)) item%flag_meanings = flag_meanings
         if (present(first_flag)) item%first_flag = first_flag
      end associate
   end subroutine add

   !> Add a dataset of two dimensions.
   subroutine add_table(self, name, unit, long_name, dimensions, values)
      class(extra_list_t), intent(inout) :: self
      character(*), intent(in) :: name, unit, long_name
      !> Names of its scales, the slowest first, separated by a blank; they stand in the list already.
      character(*), intent(in) :: dimensions
      !> Values; a symmetric matrix, so that the order has no meaning.
      real(dp), intent(in) :: values(:, :)

      call self%add(name, unit, long_name, dimensions, reshape(values, [size(values)]))
   end subroutine add_table

   !> Add the scale of a dimension.
   subroutine add_scale(self, name, unit, long_name, values)
      class(extra_list_t), intent(inout) :: self
      !> Name of the dataset, which is that of the dimension.
      character(*), intent(in) :: name
      character(*), intent(in) :: unit, long_name
      !> Values along the dimension.
      real(dp), intent(in) :: values(:)

      call make_space(self)
      associate (item => self%items(self%n))
         item%name = name
         item%unit = unit
         item%long_name = long_name
         item%dimensions = name
         item%counts = [size(values)]
         item%values = values
      end associate
   end subroutine add_scale

   !> Add a scale that counts from 1.
   subroutine add_numbers(self, name, long_name, n)
      class(extra_list_t), intent(inout) :: self
      character(*), intent(in) :: name
      !> What is counted.
      character(*), intent(in) :: long_name
      !> How many there are.
      integer, intent(in) :: n
      integer :: i

      call self%add_scale(name, '-', long_name//', from 1', [(real(i, dp), i=1, n)])
   end subroutine add_numbers

   !> Add a scale of words.
   subroutine add_words(self, name, long_name, words)
      class(extra_list_t), intent(inout) :: self
      character(*), intent(in) :: name
      !> What the words are.
      character(*), intent(in) :: long_name
      !> The words along the dimension, separated by a blank.
      character(*), intent(in) :: words

      call make_space(self)
      associate (item => self%items(self%n))
         item%name = name
         item%unit = '-'
         item%long_name = long_name
         item%dimensions = name
         item%counts = [count_words(words)]
         item%words = words
      end associate
   end subroutine add_words

   !> Hand over the datasets; the list is empty afterwards.
   subroutine move_to(self, extras)
      class(extra_list_t), intent(inout) :: self
      !> Receives the datasets in their order.
      type(extra_t), allocatable, intent(out) :: extras(:)

      if (self%n == 0) then
         allocate (extras(0))
      else
         allocate (extras(self%n), source=self%items(:self%n))
         deallocate (self%items)
      end if
      self%n = 0
   end subroutine move_to

   !> Space for one more, which counts.
   subroutine make_space(self)
      !> The list, which grows by one.
      type(extra_list_t), intent(inout) :: self
      type(extra_t), allocatable :: larger(:)

      if (.not. allocated(self%items)) allocate (self%items(first_space))
      if (self%n == size(self%items)) then
         allocate (larger(2*self%n))
         larger(:self%n) = self%items
         call move_alloc(larger, self%items)
      end if
      self%n = self%n + 1
   end subroutine make_space

   !> Length of a dimension.
   pure integer function length_of(self, name)
      type(extra_list_t), intent(in) :: self
      !> Name of the scale.
      character(*), intent(in) :: name
      integer :: i

      length_of = 0
      do i = 1, self%n - 1
         if (self%items(i)%name == name) length_of = self%items(i)%counts(1)
      end do
   end function length_of

end module adfric_fit_extra_list

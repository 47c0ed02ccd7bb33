! SPDX-License-Identifier: GPL-3.0-or-later
!> What the values of an input that names a model are in a scene: words, numbers, and names of variables and results.
module adfric_input_modern_values
   use adfric_base_kinds, only: dp
   use adfric_base_text, only: show_number, strip
   use adfric_base_words, only: count_words, get_word
   use adfric_input_item, only: item_t, next_item
   use adfric_input_literal, only: convert
   use adfric_input_namelist_file, only: namelist_file_t
   use adfric_input_variable, only: read_variable
   use adfric_input_vocabulary, only: find_variable, full_name
   use adfric_describe_model, only: model_t
   use adfric_describe_table, only: kind_choice, variable_t
   use adfric_run_conversion, only: as_it_is
   use adfric_run_converted_model, only: converted_model_t
   implicit none (type, external)
   private
   public :: index_of_assigned, swept_variable, is_converted, are_numbers, word_of, count_items, item_of, bare_of
   public :: value_in_scene, theories_in_scene, names_in_scene, result_in_scene, numbers_in_scene

contains

   !> Is a variable counted otherwise in a scene?
   pure logical function is_converted(new, at)
      class(model_t), intent(in) :: new
      !> Index of the variable; 0: none.
      integer, intent(in) :: at

      is_converted = .false.
      select type (new)
      class is (converted_model_t)
         if (at > 0) is_converted = new%scene_values%how(at) /= as_it_is
      end select
   end function is_converted

   !> Index of the variable that an assignment gives a value, in the table of the model; 0 if the model has none such.
   pure integer function index_of_assigned(file, number, old)
      type(namelist_file_t), intent(in) :: file
      integer, intent(in) :: number
      class(model_t), intent(in) :: old

      associate (assignment => file%assignments(number))
         index_of_assigned = old%index_of(trim(file%groups(assignment%group)%name), trim(assignment%name))
      end associate
   end function index_of_assigned

   !> Index of the variable that a group sweeps; 0 if it names none.
   integer function swept_variable(file, group, old) result(at)
      type(namelist_file_t), intent(in) :: file
      integer, intent(in) :: group
      class(model_t), intent(in) :: old
      character(:), allocatable :: word, flaw
      integer :: number

      at = 0
      number = file%find_assignment(group, 'variable')
      if (number == 0) return
      call convert(item_of(file%value_of(number), 1), word, flaw)
      if (len(flaw) == 0) call find_variable(old, word, '', at, flaw)
   end function swept_variable

   !> Are there numbers alone, without repeats?
   logical function are_numbers(text)
      !> Value of the assignment.
      character(*), intent(in) :: text
      character(:), allocatable :: flaw
      real(dp) :: value
      integer :: k

      are_numbers = index(text, '*') == 0
      do k = 1, count_items(text)
         call convert(item_of(text, k), value, flaw)
         are_numbers = are_numbers .and. len(flaw) == 0
      end do
   end function are_numbers

   !> The word of one row that stands where another row has the word of an input.
   function word_of(text, row, other) result(word)
      !> Value of the assignment: a word in quotes.
      character(*), intent(in) :: text
      type(variable_t), intent(in) :: row, other
      character(:), allocatable :: word, given, flaw
      integer :: k

      word = ''
      call convert(strip(text), given, flaw)
      if (len(flaw) > 0) return
      do k = 1, count_words(row%choices)
         if (get_word(row%choices, k) == given .and. k <= count_words(other%choices)) word = get_word(other%choices, k)
      end do
   end function word_of

   !> Number of values of an assignment.
   integer function count_items(text)
      character(*), intent(in) :: text

      count_items = 0
      do while (len(item_of(text, count_items + 1)) > 0)
         count_items = count_items + 1
      end do
   end function count_items

   !> One of the values of an assignment; empty if there are not as many.
   function item_of(text, number) result(item_text)
      character(*), intent(in) :: text
      !> Number of the value, from 1.
      integer, intent(in) :: number
      character(:), allocatable :: item_text, flaw
      type(item_t) :: item
      integer :: position, k

      item_text = ''
      position = 1
      do k = 1, number
         item_text = ''
         if (position > len(text)) return
         call next_item(text, position, item, flaw)
         if (len(flaw) > 0 .or. item%first == 0) return
         item_text = text(item%first:item%last)
      end do
   end function item_of

   !> Value of an assignment as a scene has it.
   function value_in_scene(given, old, new, at) result(text)
      !> Value as it stands in the input.
      character(*), intent(in) :: given
      class(model_t), intent(in) :: old, new
      integer, intent(in) :: at
      character(:), allocatable :: text, flaw
      real(dp) :: value
      integer :: position

      text = strip(given)
      if (is_converted(new, at)) then
         call read_variable(given, old%variables(at), value, flaw, position)
         if (len(flaw) == 0) text = number_in_scene(value, new, at)
      else if (old%variables(at)%kind == kind_choice) then
         text = ''''//word_of(given, old%variables(at), new%variables(at))//''''
      end if
   end function value_in_scene

   !> Words of theories as a scene has them.
   function theories_in_scene(text, old, new) result(words)
      !> Words in quotes.
      character(*), intent(in) :: text
      class(model_t), intent(in) :: old, new
      character(:), allocatable :: words
      integer :: k, at

      words = text
      at = old%index_of('model', 'theory')
      if (at == 0) return
      words = ''
      do k = 1, count_items(text)
         if (k > 1) words = words//', '
         words = words//''''//word_of(item_of(text, k), old%variables(at), new%variables(at))//''''
      end do
   end function theories_in_scene

   !> A name without its quotes and its group.
   pure function bare_of(text) result(bare)
      !> A word in quotes.
      character(*), intent(in) :: text
      character(:), allocatable :: bare
      integer :: first

      first = max(index(text, '%', back=.true.), scan(text, '''"')) + 1
      bare = text(first:)
      if (scan(bare, '''"') > 0) bare = bare(:scan(bare, '''"') - 1)
   end function bare_of

   !> Names of variables as a scene has them.
   function names_in_scene(text, old, new) result(names)
      character(*), intent(in) :: text
      class(model_t), intent(in) :: old, new
      character(:), allocatable :: names, word, flaw
      integer :: k, at

      names = ''
      do k = 1, count_items(text)
         call convert(item_of(text, k), word, flaw)
         at = 0
         if (len(flaw) == 0) call find_variable(old, word, '', at, flaw)
         if (at > 0) word = full_name(new, at)
         if (k > 1) names = names//', '
         names = names//''''//word//''''
      end do
   end function names_in_scene

   !> Name of a result as a scene has it.
   function result_in_scene(text, old, new) result(name)
      character(*), intent(in) :: text
      class(model_t), intent(in) :: old, new
      character(:), allocatable :: name, word, flaw
      integer :: k

      name = text
      call convert(text, word, flaw)
      if (len(flaw) > 0) return
      do k = 1, size(old%results)
         if (old%results(k)%name == word) name = ''''//new%results(k)%name//''''
      end do
   end function result_in_scene

   !> Numbers of a swept variable as a scene has them.
   function numbers_in_scene(text, new, at) result(numbers)
      !> The numbers, or the name of a dataset.
      character(*), intent(in) :: text
      class(model_t), intent(in) :: new
      integer, intent(in) :: at
      character(:), allocatable :: numbers, flaw
      real(dp) :: value
      integer :: k

      numbers = text
      if (.not. is_converted(new, at)) return
      numbers = ''
      do k = 1, count_items(text)
         call convert(item_of(text, k), value, flaw)
         if (k > 1) numbers = numbers//', '
         if (len(flaw) == 0) numbers = numbers//number_in_scene(value, new, at)
         if (len(flaw) > 0) numbers = numbers//item_of(text, k)
      end do
   end function numbers_in_scene

   !> A number of a converted variable as a scene has it.
   function number_in_scene(value, new, at) result(number)
      !> Value of the model.
      real(dp), intent(in) :: value
      class(model_t), intent(in) :: new
      integer, intent(in) :: at
      character(:), allocatable :: number

      number = show_number(value)
      select type (new)
      class is (converted_model_t)
         number = show_number(new%scene_values%of_scene(at, value))
      end select
   end function number_in_scene

end module adfric_input_modern_values

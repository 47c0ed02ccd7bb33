!> From the text of a value to the value, by the run-time library's own namelist reader.
!>
!> Each text is first examined, since that reader is silent about much of what is wrong.
!> Every procedure returns a flaw: what is wrong and what was given; empty, the value is good.
module adfric_input_value_text
   use adfric_base_kinds, only: dp, i8
   use adfric_input_literal, only: item_t, next_item, find_real_flaw, find_integer_flaw, find_logical_flaw, &
                                   find_string_flaw
   use adfric_input_text, only: newline, is_name, show_text, show_count
   implicit none (type, external)
   private
   public :: read_reals, read_real, read_integer, read_logical, read_string, most_values

   !> Values that a list may have.
   integer, parameter :: most_values = 100000000

contains

   !> Read a list of real numbers.
   subroutine read_reals(text, values, flaw, place)
      character(*), intent(in) :: text
      !> Size 0 if something is wrong.
      real(dp), allocatable, intent(out) :: values(:)
      character(:), allocatable, intent(out) :: flaw
      !> Position of what is wrong in the text.
      integer, intent(out) :: place
      type(item_t) :: item
      integer(i8) :: n
      integer :: position, status

      n = 0
      place = 1
      position = 1
      allocate (values(0))
      do
         call next_item(text, position, item, flaw)
         if (item%first == 0) exit
         place = item%first
         if (len(flaw) == 0) flaw = find_real_flaw(text(item%first:item%last))
         if (len(flaw) > 0) return
         n = n + item%repeat
      end do
      if (n == 0) flaw = 'no value given'
      if (n > most_values) flaw = 'too many values, given '//show_count(n)
      if (len(flaw) > 0) return
      deallocate (values)
      allocate (values(n), stat=status)
      if (status /= 0) then
         allocate (values(0))
         flaw = 'too many values for the memory, given '//show_count(n)
      else
         call read_checked_reals(text, values, flaw)
      end if
   end subroutine read_reals

   !> Read real numbers from a text that is known to be good.
   subroutine read_checked_reals(text, values, flaw)
      character(*), intent(in) :: text
      real(dp), intent(out) :: values(:)
      character(:), allocatable, intent(inout) :: flaw
      real(dp), allocatable :: x(:)
      namelist /one/ x
      character(:), allocatable :: source
      integer :: status

      allocate (x(size(values)), source=0.0_dp)
      source = as_namelist(text)
      read (source, nml=one, iostat=status)
      if (status /= 0) flaw = 'not a list of numbers, given '//show_text(text)
      values = x
   end subroutine read_checked_reals

   !> Read one real number.
   subroutine read_real(text, value, flaw, place)
      character(*), intent(in) :: text
      real(dp), intent(out) :: value
      character(:), allocatable, intent(out) :: flaw
      integer, intent(out) :: place
      real(dp) :: x
      namelist /one/ x
      character(:), allocatable :: source
      type(item_t) :: item
      integer :: status

      x = 0
      call take_only_item(text, item, flaw, place)
      if (len(flaw) == 0) flaw = find_real_flaw(text(item%first:item%last))
      if (len(flaw) == 0) then
         source = as_namelist(text)
         read (source, nml=one, iostat=status)
         if (status /= 0) flaw = 'not a number, given '//show_text(text)
      end if
      value = x
   end subroutine read_real

   !> Read one integer.
   subroutine read_integer(text, value, flaw, place)
      character(*), intent(in) :: text
      integer(i8), intent(out) :: value
      character(:), allocatable, intent(out) :: flaw
      integer, intent(out) :: place
      integer(i8) :: x
      namelist /one/ x
      character(:), allocatable :: source
      type(item_t) :: item
      integer :: status

      x = 0
      call take_only_item(text, item, flaw, place)
      if (len(flaw) == 0) flaw = find_integer_flaw(text(item%first:item%last))
      if (len(flaw) == 0) then
         source = as_namelist(text)
         read (source, nml=one, iostat=status)
         if (status /= 0) flaw = 'not an integer, given '//show_text(text)
      end if
      value = x
   end subroutine read_integer

   !> Read one logical.
   subroutine read_logical(text, value, flaw, place)
      character(*), intent(in) :: text
      logical, intent(out) :: value
      character(:), allocatable, intent(out) :: flaw
      integer, intent(out) :: place
      logical :: x
      namelist /one/ x
      character(:), allocatable :: source
      type(item_t) :: item
      integer :: status

      x = .false.
      call take_only_item(text, item, flaw, place)
      if (len(flaw) == 0) flaw = find_logical_flaw(text(item%first:item%last))
      if (len(flaw) == 0) then
         source = as_namelist(text)
         read (source, nml=one, iostat=status)
         if (status /= 0) flaw = 'not a logical, given '//show_text(text)
      end if
      value = x
   end subroutine read_logical

   !> Read one text in quotes; blanks at its end do not count.
   subroutine read_string(text, value, flaw, place)
      character(*), intent(in) :: text
      character(:), allocatable, intent(out) :: value
      character(:), allocatable, intent(out) :: flaw
      integer, intent(out) :: place
      character(len(text)) :: x
      namelist /one/ x
      character(:), allocatable :: source
      type(item_t) :: item
      integer :: status

      x = ''
      call take_only_item(text, item, flaw, place)
      if (len(flaw) == 0) flaw = find_string_flaw(text(item%first:item%last))
      if (len(flaw) == 0) then
         source = as_namelist(text)
         read (source, nml=one, iostat=status)
         if (status /= 0) flaw = 'not a text in quotes, given '//show_text(text)
      end if
      value = trim(x)
   end subroutine read_string

   !> Take the value of a variable that has only one.
   pure subroutine take_only_item(text, item, flaw, place)
      character(*), intent(in) :: text
      type(item_t), intent(out) :: item
      character(:), allocatable, intent(out) :: flaw
      integer, intent(out) :: place
      type(item_t) :: second
      integer :: position

      place = 1
      position = 1
      call next_item(text, position, item, flaw)
      if (item%first == 0) flaw = 'no value given'
      if (len(flaw) > 0) return
      if (item%repeat > 1) flaw = 'several values, given '//show_text(text)
      if (position > len(text)) return
      place = position
      call next_item(text, position, second, flaw)
      if (len(flaw) > 0) return
      flaw = 'several values, given '//show_text(text)
      if (is_name(text(second%first:second%last))) flaw = flaw//' (is a quote or a = missing?)'
   end subroutine take_only_item

   !> A namelist of one variable.
   pure function as_namelist(text) result(source)
      character(*), intent(in) :: text
      character(:), allocatable :: source
      integer :: i

      source = '&one x = '//text//' /'
      do i = 1, len(source)
         if (source(i:i) == newline) source(i:i) = ' '
      end do
   end function as_namelist

end module adfric_input_value_text

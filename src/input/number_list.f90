!> Lists of numbers.
module adfric_input_number_list
   use adfric_base_kinds, only: dp, i8
   use adfric_input_item, only: item_t, next_item
   use adfric_input_literal, only: convert
   use adfric_input_text, only: show_count
   implicit none (type, external)
   private
   public :: read_list, most_values

   !> Values that a list may have.
   integer, parameter :: most_values = 100000000

contains

   !> Read a list of real numbers.
   subroutine read_list(text, values, flaw, place)
      character(*), intent(in) :: text
      !> Size 0 if something is wrong.
      real(dp), allocatable, intent(out) :: values(:)
      !> What is wrong and what was given; empty if the list is good.
      character(:), allocatable, intent(out) :: flaw
      !> Position of what is wrong in the text.
      integer, intent(out) :: place
      integer(i8) :: n
      integer :: status

      allocate (values(0))
      call scan_list(text, values, n, flaw, place)
      if (len(flaw) > 0) return
      if (n == 0) flaw = 'no value given'
      if (n > most_values) flaw = 'too many values, given '//show_count(n)
      if (len(flaw) > 0) return
      deallocate (values)
      allocate (values(n), stat=status)
      if (status == 0) then
         call scan_list(text, values, n, flaw, place)
      else
         allocate (values(0))
         flaw = 'too many values for the memory, given '//show_count(n)
      end if
   end subroutine read_list

   !> Examine and count the values of a list, and keep those for which there is room.
   subroutine scan_list(text, values, n, flaw, place)
      character(*), intent(in) :: text
      real(dp), intent(inout) :: values(:)
      !> How many values the list has.
      integer(i8), intent(out) :: n
      character(:), allocatable, intent(out) :: flaw
      integer, intent(out) :: place
      type(item_t) :: item
      real(dp) :: value
      integer :: position

      n = 0
      place = 1
      position = 1
      do
         call next_item(text, position, item, flaw)
         if (item%first == 0) exit
         place = item%first
         if (len(flaw) == 0) call convert(text(item%first:item%last), value, flaw)
         if (len(flaw) > 0) return
         values(n + 1:min(n + item%repeat, size(values, kind=i8))) = value
         n = n + item%repeat
      end do
   end subroutine scan_list

end module adfric_input_number_list

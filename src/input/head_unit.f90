! SPDX-License-Identifier: GPL-3.0-or-later
!> The unit in the head of a column, or in the name of a dataset: `load [nN]`, `load (nN)`, `load / nN`, `load in nN`, `load_nN`.
!>
!> A head with a part that is not understood is never taken for one in SI units: it has a unit that nobody knows, or a flaw.
module adfric_input_head_unit
   use adfric_base_text, only: show_text, to_lower
   use adfric_base_units, only: unit_t, read_unit, is_same_quantity
   use adfric_base_words, only: has_word
   implicit none (type, external)
   private
   public :: head_t, split_head, add_unit, is_unit_like

   !> What stands between a name and a unit without brackets, and what is left out at the end of a name.
   character(*), parameter :: joints = ' _-.,:;', ends = joints//'/'
   !> Brackets that open and that close.
   character(*), parameter :: opening = '[({', closing = '])}'
   !> Units that are no powers of ten of SI units: they are recognised, and refused.
   character(*), parameter :: foreign_units = 'V mV uV nV kV A mA uA nA pA lb lbf psi ksi kgf gf dyn inch inches ft deg degree ' &
      //'degrees degC degF percent volt volts'
   !> The sign of degrees.
   character(*), parameter :: degree = char(194)//char(176)
   !> The same, where nothing but units stands: in a line of them.
   character(*), parameter :: other_units = foreign_units//' % min h C F '//degree//' '//degree//'C '//degree &
      //'F a.u. arb. arb au counts cts ppm'
   !> What stands between the factors of a unit.
   character(*), parameter :: between_factors = ' */'

   !> A head.
   type :: head_t
      !> The whole of it.
      character(:), allocatable :: text
      !> The name without the unit.
      character(:), allocatable :: name
      !> The unit as it is written; empty where there is none.
      character(:), allocatable :: unit
      !> What is wrong with it, and what was given; empty if nothing is wrong.
      character(:), allocatable :: flaw
      !> Does nothing but its own letters tell that the unit is one, as in `load_nN`?
      logical :: is_bare = .false.
   end type head_t

contains

   !> Take a head apart.
   pure subroutine split_head(text, head)
      !> The head without quotes, and without blanks around it.
      character(*), intent(in) :: text
      type(head_t), intent(out) :: head

      head%text = text
      head%name = text
      head%unit = ''
      head%flaw = ''
      if (len(text) == 0) return
      if (scan(text(len(text):), closing) == 1) then
         call split_brackets(head)
      else if (scan(text, '[(') > 0) then
         head%flaw = 'something stands behind a bracket, or it is not closed, given '//show_text(text)
      else
         call split_words(head)
      end if
   end subroutine split_head

   !> Take a head without brackets apart.
   pure subroutine split_words(head)
      !> In: the whole head. Out: also the name and the unit, if there is one.
      type(head_t), intent(inout) :: head
      integer :: k

      k = index(' '//to_lower(head%text), ' in ', back=.true.)
      if (k > 1) then
         call cut(head, k - 1, k + 3)
         return
      end if
      k = index(head%text, ' / ') + 1
      if (k < 2) then
         call split_letters(head)
         if (head%is_bare) return
         k = index(head%text, '/')
      end if
      if (k > 1) call cut(head, k - 1, k + 1)
   end subroutine split_words

   !> Cut a head in name and unit.
   pure subroutine cut(head, last, first)
      !> In: the whole head. Out: also the name and the unit.
      type(head_t), intent(inout) :: head
      !> Where the name ends at the latest.
      integer, intent(in) :: last
      !> Where the unit begins.
      integer, intent(in) :: first

      head%name = head%text(:verify(head%text(:last), ends, back=.true.))
      head%unit = trim(adjustl(head%text(first:)))
      if (len(head%unit) == 0) head%flaw = 'no unit where one is announced, given '//show_text(head%text)
   end subroutine cut

   !> Take a head apart that ends with a bracket.
   pure subroutine split_brackets(head)
      !> In: the whole head. Out: also the name, the unit, and what is wrong.
      type(head_t), intent(inout) :: head
      integer :: first, last, kind

      last = len(head%text)
      kind = index(closing, head%text(last:))
      first = index(head%text, opening(kind:kind), back=.true.)
      if (first == 0) then
         head%flaw = 'a bracket closes that has not opened, given '//show_text(head%text)
         return
      end if
      head%name = head%text(:verify(head%text(:first - 1), ends, back=.true.))
      head%unit = trim(adjustl(head%text(first + 1:last - 1)))
      if (len(head%unit) == 0) head%flaw = 'no unit in the brackets, given '//show_text(head%text)
      if (len(head%flaw) == 0 .and. is_unit(head%unit)) head%flaw = contradiction(head%name, head%unit)
   end subroutine split_brackets

   !> Take a head apart whose last word is a unit.
   pure subroutine split_letters(head)
      type(head_t), intent(inout) :: head
      integer :: k, last

      last = verify(head%text, joints, back=.true.)
      ! the longest unit is the one that is meant: N m-1, and not m-1
      do k = 2, last - 1
         if (scan(head%text(k:k), joints) == 0 .or. scan(head%text(k + 1:k + 1), joints//'+0123456789') > 0) cycle
         if (.not. (is_unit(head%text(k + 1:last)) .or. has_word(foreign_units, head%text(k + 1:last)))) cycle
         if (verify(head%text(:k), ends) == 0) return
         call cut(head, k, k + 1)
         head%unit = head%text(k + 1:last)
         head%is_bare = .true.
         k_in: if (len(head%name) > 3) then
            ! load_in_nN
            if (to_lower(head%name(len(head%name) - 1:)) /= 'in') exit k_in
            if (scan(head%name(len(head%name) - 2:len(head%name) - 2), joints) == 0) exit k_in
            head%name = head%name(:verify(head%name(:len(head%name) - 2), ends, back=.true.))
         end if k_in
         return
      end do
   end subroutine split_letters

   !> Hold the unit that stands outside of a head, in a line of units or an attribute, against that of the head.
   pure subroutine add_unit(head, unit)
      !> In: the head. Out: the same with that unit.
      type(head_t), intent(inout) :: head
      !> The unit that stands outside, as it is written; empty: there is none, and nothing is done.
      character(*), intent(in) :: unit

      if (len(unit) == 0) return
      if (len(head%unit) > 0 .and. is_unit(head%unit) .and. len(head%flaw) == 0) then
         head%flaw = contradiction(head%text, unit)
         if (len(head%flaw) > 0) return
         if (is_like(head%unit, unit)) return
      end if
      ! what looked like a unit is a part of the name
      head%name = head%text
      head%flaw = ''
      head%is_bare = .false.
      head%unit = unit
   end subroutine add_unit

   !> What to say of a name with a unit of its own that another unit contradicts; empty if it does not.
   pure function contradiction(text, unit) result(flaw)
      !> The name, with a unit or without.
      character(*), intent(in) :: text
      !> The other unit.
      character(*), intent(in) :: unit
      character(:), allocatable :: flaw
      type(head_t) :: inner
      type(unit_t) :: one, other
      logical :: is_one, is_other

      flaw = ''
      inner%text = text
      inner%name = text
      inner%unit = ''
      inner%flaw = ''
      if (len(text) == 0) return
      if (scan(text(len(text):), closing) == 1) then
         inner%unit = text(scan(text, opening, back=.true.) + 1:len(text) - 1)
      else
         call split_words(inner)
      end if
      call read_unit(inner%unit, one, is_one)
      call read_unit(unit, other, is_other)
      if (len(inner%unit) == 0 .or. .not. (is_one .and. is_other)) return
      ! of another quantity, as in T_g [K], it is a part of the name
      if (inner%is_bare .and. .not. is_same_quantity(one, other)) return
      if (is_like(inner%unit, unit)) return
      flaw = 'two units that contradict each other, given '//show_text(inner%unit)//' and '//show_text(unit)
   end function contradiction

   !> Are two known units the same, however they are written?
   pure logical function is_like(one, other)
      !> The units.
      character(*), intent(in) :: one, other
      type(unit_t) :: a, b
      logical :: is_known_a, is_known_b

      call read_unit(one, a, is_known_a)
      call read_unit(other, b, is_known_b)
      is_like = is_known_a .and. is_known_b .and. is_same_quantity(a, b) .and. a%exponent == b%exponent
   end function is_like

   !> Is a text a unit that is known, a hyphen or 1 among them?
   pure logical function is_unit(text)
      character(*), intent(in) :: text
      type(unit_t) :: unused

      is_unit = len(text) > 0
      if (is_unit) call read_unit(text, unused, is_unit)
   end function is_unit

   !> Is a text of a line of units a unit, be it known or not?
   pure logical function is_unit_like(text)
      character(*), intent(in) :: text
      integer :: first, length

      is_unit_like = is_unit(text)
      if (is_unit_like) return
      first = verify(text, between_factors)
      do while (first > 0)
         length = scan(text(first:)//' ', between_factors) - 1
         is_unit_like = is_unit(text(first:first + length - 1)) .or. has_word(other_units, text(first:first + length - 1))
         if (.not. is_unit_like) return
         first = first + length
         length = verify(text(first:), between_factors)
         first = merge(0, first + length - 1, length == 0)
      end do
   end function is_unit_like

end module adfric_input_head_unit

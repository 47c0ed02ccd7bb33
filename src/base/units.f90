! SPDX-License-Identifier: GPL-3.0-or-later
!> Units as people write them: `nm`, `MPa`, `N/m^2`, `mJ m-2`.
!>
!> A unit is a power of ten of SI units, so that a number is converted by one multiplication or division with an exact power of
!> ten: the result is the number nearest to the true one. What is no power of ten of SI, an inch or a pound, is not known here.
module adfric_base_units
   use adfric_base_kinds, only: dp
   use adfric_base_words, only: count_words, get_word
   implicit none (type, external)
   private
   public :: unit_t, read_unit, is_same_quantity, to_si, quotient_unit

   !> Powers of m, kg, s, K and ohm.
   integer, parameter :: n_dimensions = 5
   !> Powers of ten up to this one are kept without error.
   integer, parameter :: largest_exact = 22
   character(*), parameter :: digits = '0123456789'

   !> A unit.
   type :: unit_t
      !> Decimal exponent of its size in SI units.
      integer :: exponent = 0
      !> Powers of m, kg, s, K and ohm in it.
      integer :: powers(n_dimensions) = 0
   end type unit_t

   !> A row of the table of units.
   type :: row_t
      !> Its symbols and names, separated by a blank.
      character(40) :: names
      !> The unit, without a prefix.
      type(unit_t) :: unit
      !> May a prefix stand before it?
      logical :: has_prefixes
   end type row_t

   !> The table of units.
   type(row_t), parameter :: table(*) = [ &
      row_t('m metre metres meter meters', unit_t(0, [1, 0, 0, 0, 0]), .true.), &
      row_t('micron microns', unit_t(-6, [1, 0, 0, 0, 0]), .false.), &
      row_t('angstrom angstroms Angstrom Angstroms', unit_t(-10, [1, 0, 0, 0, 0]), .false.), &
      row_t('g gram grams', unit_t(-3, [0, 1, 0, 0, 0]), .true.), &
      row_t('s second seconds', unit_t(0, [0, 0, 1, 0, 0]), .true.), &
      row_t('K kelvin kelvins', unit_t(0, [0, 0, 0, 1, 0]), .true.), &
      row_t('Hz hertz', unit_t(0, [0, 0, -1, 0, 0]), .true.), &
      row_t('N newton newtons', unit_t(0, [1, 1, -2, 0, 0]), .true.), &
      row_t('Pa pascal pascals', unit_t(0, [-1, 1, -2, 0, 0]), .true.), &
      row_t('bar bars', unit_t(5, [-1, 1, -2, 0, 0]), .true.), &
      row_t('J joule joules', unit_t(0, [2, 1, -2, 0, 0]), .true.), &
      row_t('W watt watts', unit_t(0, [2, 1, -3, 0, 0]), .true.), &
      row_t('ohm ohms Ohm Ohms', unit_t(0, [0, 0, 0, 0, 1]), .true.), &
      row_t('S siemens', unit_t(0, [0, 0, 0, 0, -1]), .true.), &
      row_t('rad radian radians', unit_t(0, [0, 0, 0, 0, 0]), .false.)]

   !> Prefixes before symbols and before names, with their exponents.
   character(*), parameter :: prefixes = 'Y Z E P T G M k h da d c m u n p f a z y ' &
      //'tera giga mega kilo hecto deca deci centi milli micro nano pico femto'
   integer, parameter :: exponents(*) = [24, 21, 18, 15, 12, 9, 6, 3, 2, 1, -1, -2, -3, -6, -9, -12, -15, -18, -21, -24, &
      12, 9, 6, 3, 2, 1, -1, -2, -3, -6, -9, -12, -15]

   !> Signs beyond the English alphabet, each with what it stands for; the last two are of an older spelling.
   character(3), parameter :: signs(*) = [character(3) :: char(194)//char(181), char(206)//char(188), char(195)//char(133), &
      char(226)//char(132)//char(171), 'A'//char(204)//char(138), char(194)//char(183), char(226)//char(139)//char(133), &
      char(194)//char(178), char(194)//char(179), char(194)//char(185), char(226)//char(129)//char(187), char(206)//char(169), &
      char(226)//char(132)//char(166), char(181), char(197)]
   character(8), parameter :: meanings(*) = [character(8) :: 'u', 'u', 'angstrom', 'angstrom', 'angstrom', '*', '*', '2', '3', &
      '1', '-', 'ohm', 'ohm', 'u', 'angstrom']

contains

   !> Understand a unit: factors between blanks, `*`, `.` or `/`, each with a power, such as `m`, `N/m^2`, `mJ m-2` or `kg.s**-2`.
   pure subroutine read_unit(text, unit, is_known)
      !> The unit as people write it.
      character(*), intent(in) :: text
      !> Receives the unit, if it is known.
      type(unit_t), intent(out) :: unit
      !> False if the unit is not understood, or too far from SI for an exact conversion.
      logical, intent(out) :: is_known
      character(:), allocatable :: plain
      integer :: position, sign

      plain = in_plain_letters(text)
      position = 1
      sign = 1
      is_known = .false.
      do
         call read_factor(plain, position, sign, unit, is_known)
         if (.not. is_known) return
         if (position > len(plain)) exit
         call read_operator(plain, position, sign)
      end do
      is_known = abs(unit%exponent) <= largest_exact
   end subroutine read_unit

   !> Are both units of the same quantity?
   pure logical function is_same_quantity(a, b)
      !> The two units; their sizes have no part in it.
      type(unit_t), intent(in) :: a, b

      is_same_quantity = all(a%powers == b%powers)
   end function is_same_quantity

   !> A number of a unit in SI units.
   elemental real(dp) function to_si(number, unit)
      !> The number, in the unit.
      real(dp), intent(in) :: number
      !> The unit of the number, from `read_unit`.
      type(unit_t), intent(in) :: unit

      if (unit%exponent >= 0) then
         to_si = number*10.0_dp**unit%exponent
      else
         to_si = number/10.0_dp**(-unit%exponent)
      end if
   end function to_si

   !> The unit of a quotient, as text: `N` by `m/s` is `N/m s`, in which each divides or multiplies what stands before it.
   pure function quotient_unit(numerator, denominator) result(text)
      !> Units that `read_unit` understands; a hyphen, 1 or nothing for a pure number.
      character(*), intent(in) :: numerator, denominator
      character(:), allocatable :: text
      integer :: i
      logical :: is_divided

      text = '-'
      if (is_pure(denominator)) then
         if (.not. is_pure(numerator)) text = numerator
         return
      end if
      if (numerator == denominator) return
      text = '1'
      if (.not. is_pure(numerator)) text = numerator
      is_divided = .true.
      i = 1
      do while (i <= len_trim(denominator))
         if (scan(denominator(i:i), ' .*/') > 0) then
            is_divided = denominator(i:i) /= '/'
            i = i + 1
            cycle
         end if
         associate (length => scan(denominator(i:)//' ', ' .*/') - 1)
            ! a number alone, as in 1/s, changes nothing
            if (denominator(i:i + length - 1) /= '1') text = text//merge('/', ' ', is_divided)//denominator(i:i + length - 1)
            i = i + length
         end associate
      end do
   end function quotient_unit

   !> Is it the unit of a pure number?
   pure logical function is_pure(unit)
      !> The unit; a hyphen, 1 or nothing for a pure number.
      character(*), intent(in) :: unit

      is_pure = len_trim(unit) == 0 .or. unit == '-' .or. unit == '1'
   end function is_pure

   !> The text with the signs of the table replaced, without blanks at its ends.
   pure function in_plain_letters(text) result(plain)
      !> The text, in UTF-8 or Latin-1.
      character(*), intent(in) :: text
      character(:), allocatable :: plain
      integer :: i, k, length

      plain = ''
      i = 1
      do while (i <= len(text))
         do k = 1, size(signs)
            length = len_trim(signs(k))
            if (i + length - 1 > len(text)) cycle
            if (text(i:i + length - 1) == signs(k)(:length)) exit
         end do
         if (k <= size(signs)) then
            plain = plain//trim(meanings(k))
            i = i + length
         else
            plain = plain//text(i:i)
            i = i + 1
         end if
      end do
      plain = trim(adjustl(plain))
   end function in_plain_letters

   !> Read a factor with its power.
   pure subroutine read_factor(text, position, sign, unit, is_known)
      !> The whole unit, in plain letters.
      character(*), intent(in) :: text
      !> In: the index where the factor begins. Out: the index behind it.
      integer, intent(inout) :: position
      !> 1, or -1 if the unit is divided by the factor.
      integer, intent(in) :: sign
      !> The unit so far, which is multiplied or divided by the factor.
      type(unit_t), intent(inout) :: unit
      !> False if the factor is not understood; the unit is unchanged then.
      logical, intent(out) :: is_known
      type(unit_t) :: factor
      integer :: length, power

      length = scan(text(position:)//' ', ' *./^+-'//digits) - 1
      power = 1
      if (length > 0) then
         call look_up(text(position:position + length - 1), factor, is_known)
         position = position + length
         if (is_known) call read_power(text, position, power, is_known)
      else
         ! a pure number, which has no power
         is_known = scan(text(position:min(position, len(text))), '1-') == 1
         position = position + 1
      end if
      if (is_known .and. position <= len(text)) is_known = scan(text(position:position), ' *./') == 1
      if (.not. is_known) return
      unit%exponent = unit%exponent + sign*power*factor%exponent
      unit%powers = unit%powers + sign*power*factor%powers
   end subroutine read_factor

   !> Read a power, `^2`, `**-1` or `2`; 1 if there is none.
   pure subroutine read_power(text, position, power, is_known)
      !> The whole unit, in plain letters.
      character(*), intent(in) :: text
      !> In: the index where the power may begin. Out: the index behind it.
      integer, intent(inout) :: position
      !> Receives the power; 1 if there is none.
      integer, intent(out) :: power
      !> False if the power is not understood.
      logical, intent(out) :: is_known
      logical :: is_needed
      integer :: first

      power = 1
      first = position
      if (index(text(position:), '**') == 1) position = position + 2
      if (index(text(position:), '^') == 1) position = position + 1
      is_needed = position > first
      first = position
      if (scan(text(position:min(position, len(text))), '+-') == 1) position = position + 1
      ! one digit is enough for any quantity
      is_known = scan(text(position:min(position, len(text))), digits) == 1
      if (is_known) then
         power = iachar(text(position:position)) - iachar('0')
         if (text(first:first) == '-') power = -power
         position = position + 1
      else
         is_known = .not. is_needed .and. position == first
      end if
   end subroutine read_power

   !> Read what stands between two factors.
   pure subroutine read_operator(text, position, sign)
      !> The whole unit, in plain letters.
      character(*), intent(in) :: text
      !> In: the index behind a factor. Out: the index where the next factor begins.
      integer, intent(inout) :: position
      !> 1, or -1 if the unit is divided by the factor that follows.
      integer, intent(out) :: sign
      integer :: n_blanks

      sign = 1
      n_blanks = verify(text(position:), ' ') - 1
      position = position + n_blanks
      if (scan(text(position:position), '*./') == 0) return
      if (text(position:position) == '/') sign = -1
      position = position + 1
      position = position + max(0, verify(text(position:), ' ') - 1)
   end subroutine read_operator

   !> Look up a unit, with a prefix or without.
   pure subroutine look_up(name, unit, is_known)
      !> Symbol or name of the unit, with a prefix or without.
      character(*), intent(in) :: name
      !> Receives the unit, if it is known.
      type(unit_t), intent(out) :: unit
      !> False if the table does not have the unit.
      logical, intent(out) :: is_known
      integer :: i, k, n

      is_known = .true.
      do i = 1, size(table)
         if (is_listed(name, table(i)%names)) then
            unit = table(i)%unit
            return
         end if
      end do
      do k = 1, count_words(prefixes)
         if (index(name, get_word(prefixes, k)) /= 1) cycle
         n = len(get_word(prefixes, k))
         do i = 1, size(table)
            if (.not. table(i)%has_prefixes) cycle
            if (.not. is_listed(name(n + 1:), table(i)%names)) cycle
            ! nm and nanometre, but not nmetre and nanom: symbols have three letters at most, names more
            if ((n > 2) .neqv. (len(name) - n > 3)) cycle
            unit = table(i)%unit
            unit%exponent = unit%exponent + exponents(k)
            return
         end do
      end do
      is_known = .false.
   end subroutine look_up

   !> Is a word in a list?
   pure logical function is_listed(word, list)
      !> The word; an empty one is in no list.
      character(*), intent(in) :: word
      !> Words, separated by a blank.
      character(*), intent(in) :: list

      is_listed = len(word) > 0 .and. index(' '//list//' ', ' '//word//' ') > 0
   end function is_listed

end module adfric_base_units

! SPDX-License-Identifier: GPL-3.0-or-later
!> Dimensions of units as they stand in the tables of a model, in powers of Pa, m and s.
module search_units
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_describe_model, only: model_t
   use adfric_describe_table, only: result_t
   implicit none (type, external)
   private
   public :: n_dimensions, dimensions_of, unit_in_case

   !> Pa, m, s.
   integer, parameter :: n_dimensions = 3

contains

   !> Powers of Pa, m and s of a unit such as `J/m^2` or `Pa m^1/2`; a pure number has none.
   pure function dimensions_of(unit) result(powers)
      character(*), intent(in) :: unit
      real(dp) :: powers(n_dimensions)
      real(dp) :: power, sign
      integer :: first, last

      powers = 0
      ! an energy for each mole counts in that of the gas constant, which is the same number in all units of a case
      if (index(unit, '/mol') > 0) return
      sign = 1
      first = 1
      do while (first <= len(unit))
         if (index(' /', unit(first:first)) > 0) then
            if (unit(first:first) == '/') sign = -1
            first = first + 1
            cycle
         end if
         last = first - 1 + scan(unit(first:)//' ', ' /^') - 1
         power = 1
         associate (name => unit(first:last))
            if (last < len(unit)) then
               if (unit(last + 1:last + 1) == '^') call read_power(unit, last, power)
            end if
            powers = powers + sign*power*base_of(name)
         end associate
         first = last + 1
      end do
   end function dimensions_of

   !> Read a power `^2` or `^1/2`, or `^(1-2.5)`; one with a letter, `^(1-n)`, is not known and counts as 0.
   pure subroutine read_power(unit, last, power)
      character(*), intent(in) :: unit
      !> In: before the `^`. Out: the end of the power.
      integer, intent(inout) :: last
      real(dp), intent(out) :: power
      integer, parameter :: zero = iachar('0')
      integer :: close, status

      if (unit(last + 2:last + 2) == '(') then
         close = last + index(unit(last + 1:), ')')
         read (unit(last + 5:close - 1), *, iostat=status) power
         power = merge(1 - power, 0.0_dp, status == 0)
         last = close
         return
      end if
      power = iachar(unit(last + 2:last + 2)) - zero
      last = last + 2
      if (len(unit) < last + 2) return
      if (unit(last + 1:last + 1) /= '/' .or. verify(unit(last + 2:last + 2), '0123456789') > 0) return
      power = power/(iachar(unit(last + 2:last + 2)) - zero)
      last = last + 2
   end subroutine read_power

   !> Powers of a single unit.
   pure function base_of(name) result(powers)
      character(*), intent(in) :: name
      real(dp) :: powers(n_dimensions)

      select case (name)
      case ('Pa')
         powers = [1, 0, 0]
      case ('m')
         powers = [0, 1, 0]
      case ('s')
         powers = [0, 0, 1]
      case ('N')
         powers = [1, 2, 0]
      case ('J')
         powers = [1, 3, 0]
      case ('W')
         powers = [1, 3, -1]
      case ('Hz')
         powers = [0, 0, -1]
      case ('kg')
         powers = [1, 1, 2]
      ! those of electricity and temperature stay as they are
      case ('-', '1', 'rad', 'degrees', 'K', 'mol', 'ohm', 'S', '')
         powers = 0
      case default
         error stop 'search_units: no such unit: '//name
      end select
   end function base_of

   !> The unit of a variable in a case. Where it depends on the kind of the surface, it is that of the result of the same name. A
   !> volume of activation stands below kT, which is the same number of J in all units of a case: it counts as 1/Pa. The modulus of
   !> a power law is that after 1 s, whatever the unit of time: E t^a is the number that stays.
   function unit_in_case(model, values, position) result(unit)
      class(model_t), intent(in) :: model
      real(dp), intent(in) :: values(:)
      integer, intent(in) :: position
      character(:), allocatable :: unit
      type(result_t), allocatable :: results(:)
      character(32) :: rest
      integer :: i

      unit = model%unit_of(values, position)
      if (model%variables(position)%name == 'power_law_modulus') then
         do i = 1, size(values)
            if (model%variables(i)%name /= 'power_law_exponent' .or. .not. is_set(values(i))) cycle
            write (rest, '(f32.28)') 1 - values(i)
            unit = 'Pa s^(1-'//trim(adjustl(rest))//')'
         end do
      end if
      if (index(model%variables(position)%name, '_activation_volume') > 0) unit = '1/Pa'
      if (index(unit, ';') == 0) return
      allocate (results(size(model%results)))
      results = model%describe_results(values)
      unit = unit(:index(unit, ';') - 1)
      do i = 1, size(results)
         ! a kind that is not drawn yet leaves both
         if (index(results(i)%unit, ';') > 0) cycle
         if (results(i)%name == model%variables(position)%name) unit = results(i)%unit
      end do
   end function unit_in_case

end module search_units

! SPDX-License-Identifier: GPL-3.0-or-later
!> The units in which a file has its numbers, compared with the unit that is wanted: honoured or refused.
module adfric_input_unit_match
   use adfric_base_units, only: unit_t, read_unit, is_same_quantity
   use adfric_base_text, only: show_text
   implicit none (type, external)
   private
   public :: match_units

contains

   !> Find out how numbers become SI units.
   pure subroutine match_units(units, wanted, thing, unit, flaw)
      !> Units in which the numbers are; empty: SI units.
      character(*), intent(in) :: units
      !> SI unit that is wanted, a hyphen for a pure number.
      character(*), intent(in) :: wanted
      !> What has the units, for a message, such as 'dataset'.
      character(*), intent(in) :: thing
      !> Receives the unit for `to_si`; only to be used if nothing is wrong.
      type(unit_t), intent(out) :: unit
      !> Why the numbers cannot be converted; empty if they can.
      character(:), allocatable, intent(out) :: flaw
      type(unit_t) :: si
      logical :: is_known, is_si

      flaw = ''
      if (len(units) == 0) return
      call read_unit(units, unit, is_known)
      call read_unit(wanted, si, is_si)
      if (.not. is_known) then
         flaw = 'the units '''//show_text(units)//''' of the '//thing//' are not known'
      else if (.not. (is_si .and. is_same_quantity(unit, si))) then
         flaw = 'the units '''//show_text(units)//''' of the '//thing//' are of another quantity'
      end if
   end subroutine match_units

end module adfric_input_unit_match
